#!/usr/bin/env python3
"""Renders the contact sheets of patterns and normals by us (left) and by POV-Ray (right), each pair as one PNG in docs.

    cargo build --release
    python3 scripts/contact_sheets.py

Needs POV-Ray 3.7 and Python's OpenEXR and numpy.
"""

import argparse
import struct
import subprocess
import tempfile
import zlib
from pathlib import Path

import Imath
import numpy
import OpenEXR

ROOT = Path(__file__).resolve().parent.parent
SHEETS = {"10_patterns": "contact-patterns.png", "11_normals": "contact-normals.png"}


def read_exr(path: Path) -> numpy.ndarray:
    """Linear RGB, height x width x 3, top row first."""
    file = OpenEXR.InputFile(str(path))
    window = file.header()["dataWindow"]
    shape = (window.max.y - window.min.y + 1, window.max.x - window.min.x + 1)
    single = Imath.PixelType(Imath.PixelType.FLOAT)
    channels = [numpy.frombuffer(file.channel(name, single), numpy.float32).reshape(shape) for name in "RGB"]
    return numpy.stack(channels, axis=-1)


def to_srgb(linear: numpy.ndarray) -> numpy.ndarray:
    clipped = numpy.clip(linear, 0, 1)
    encoded = numpy.where(clipped <= 0.0031308, clipped * 12.92, 1.055 * clipped ** (1 / 2.4) - 0.055)
    return (255 * encoded + 0.5).astype(numpy.uint8)


def write_png(path: Path, pixels: numpy.ndarray) -> None:
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", default=str(ROOT / "target/release/whitted"), help="ours (default: %(default)s)")
    asked = parser.parse_args()
    for scene, target in SHEETS.items():
        source = ROOT / f"examples/{scene}.pov"
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = Path(folder) / "ours.exr", Path(folder) / "theirs.exr"
            size = ["--width", "480", "--height", "360", "--antialias", "1,0.1,2"]
            subprocess.run([asked.binary, "render", str(source), "--output", str(ours), *size], check=True)
            smooth = ["+W480", "+H360", "+AM1", "+A0.1", "+R2", "-J"]
            command = ["povray", f"+I{source}", f"+O{theirs}", "+FE", "-D", *smooth]
            subprocess.run(command, check=True, capture_output=True)
            pair = [to_srgb(read_exr(path)) for path in (ours, theirs)]
        gap = numpy.full((pair[0].shape[0], 8, 3), 255, numpy.uint8)
        write_png(ROOT / "docs" / target, numpy.concatenate([pair[0], gap, pair[1]], axis=1))
        different = numpy.abs(pair[0].astype(int) - pair[1].astype(int)).max(axis=-1) > 2
        print(f"{target}: {100 * (1 - different.mean()):.2f} % of pixels within 2/255")


if __name__ == "__main__":
    main()
