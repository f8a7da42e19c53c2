#!/usr/bin/env python3
"""Renders the pictures of the README: a strip of examples, and one scene by us (left) and by POV-Ray (right).

    cargo build --release
    python3 scripts/gallery.py

Needs POV-Ray 3.7 and Python's OpenEXR and numpy.
"""

import subprocess
import tempfile
from pathlib import Path

import numpy
from contact_sheets import ROOT, read_exr, to_srgb, write_png

STRIP = ["03_csg", "04_glass", "05_chess", "06_shell", "07_landscape", "09_knot"]
TILE = (220, 165)
PAIR, PAIR_SIZE = "12_harbour", (400, 300)


def by_us(name: str, size: tuple[int, int], folder: Path) -> numpy.ndarray:
    """sRGB pixels of an example."""
    out = folder / f"{name}.exr"
    scene = ROOT / "examples" / f"{name}.pov"
    size = [str(side) for side in size]
    command = [ROOT / "target/release/whitted", "render", scene, "-o", out, "-W", size[0], "-H", size[1], "-a", "1,0.1,3"]
    subprocess.run(command, check=True)
    return to_srgb(read_exr(out))


def by_povray(name: str, size: tuple[int, int], folder: Path) -> numpy.ndarray:
    """The same by POV-Ray with the same options."""
    out = folder / f"{name}-povray.exr"
    scene = ROOT / "examples" / f"{name}.pov"
    switches = [f"+W{size[0]}", f"+H{size[1]}", "+A0.1", "+AM1", "+R3", "-J", "-D", "-P", "-GA", "+FE"]
    subprocess.run(["povray", f"+I{scene}", f"+O{out}", *switches], check=True, capture_output=True)
    return to_srgb(read_exr(out))


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        tiles = [by_us(name, TILE, folder) for name in STRIP]
        rows = [numpy.concatenate(tiles[i : i + 3], axis=1) for i in range(0, len(tiles), 3)]
        write_png(ROOT / "docs/gallery.png", numpy.concatenate(rows, axis=0))
        pair = [by_us(PAIR, PAIR_SIZE, folder), by_povray(PAIR, PAIR_SIZE, folder)]
        write_png(ROOT / "docs/side-by-side.png", numpy.concatenate(pair, axis=1))


if __name__ == "__main__":
    main()
