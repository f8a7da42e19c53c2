"""Small pictures, data and include files for scenes, written to a folder that both programs search."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

W, H = 9, 7


def colours() -> np.ndarray:
    """Returns an uneven picture of H x W x 4 bytes with a bit of everything."""
    y, x = np.mgrid[0:H, 0:W]
    channels = [x * 255 // (W - 1), y * 255 // (H - 1), (x * y * 37) % 256, 255 - (x * 29 + y * 17) % 256]
    return np.stack(channels, axis=-1).astype(np.uint8)


def png(path: Path, rows: np.ndarray, kind: int, bits: int = 8, extra: list[tuple[bytes, bytes]] = ()) -> None:
    """Writes a PNG of colour type `kind`; `extra` chunks stand before the pixels."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    height, width = rows.shape[:2]
    raw = b"".join(b"\0" + row.astype(">u2" if bits == 16 else "u1").tobytes() for row in rows)
    head = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    chunks = [(b"IHDR", head), *extra, (b"IDAT", zlib.compress(raw)), (b"IEND", b"")]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*c) for c in chunks))


def tga(path: Path, rgba: np.ndarray) -> None:
    """Writes an uncompressed TGA with alpha, top row first."""
    height, width = rgba.shape[:2]
    head = struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, width, height, 32, 0x28)
    path.write_bytes(head + rgba[..., [2, 1, 0, 3]].tobytes())


def bmp(path: Path, rgb: np.ndarray) -> None:
    """Writes a BMP of 24 bits, bottom row first."""
    height, width = rgb.shape[:2]
    pad = b"\0" * (-3 * width % 4)
    data = b"".join(row[:, ::-1].tobytes() + pad for row in rgb[::-1])
    head = struct.pack("<2sIHHIIiiHHIIiiII", b"BM", 54 + len(data), 0, 0, 54, 40, width, height, 1, 24, 0, len(data), 2835, 2835, 0, 0)
    path.write_bytes(head + data)


def write(folder: Path) -> None:
    """Writes every file that productions may name."""
    folder.mkdir(parents=True, exist_ok=True)
    rgba = colours()
    rgb, grey = rgba[..., :3], rgba[..., 2]
    png(folder / "rgb.png", rgb, 2)
    png(folder / "rgba.png", rgba, 6)
    png(folder / "grey.png", grey, 0)
    png(folder / "greya.png", rgba[..., 2:4], 4)
    png(folder / "grey16.png", (grey.astype(np.uint16) * 257) ^ 0x35, 0, 16)
    png(folder / "rgb16.png", (rgb.astype(np.uint16) * 257) ^ 0x35, 2, 16)
    png(folder / "linear.png", rgb, 2, extra=[(b"gAMA", struct.pack(">I", 100000))])
    png(folder / "g22.png", rgb, 2, extra=[(b"gAMA", struct.pack(">I", 45455))])
    png(folder / "srgb.png", rgb, 2, extra=[(b"sRGB", b"\0")])
    palette = np.random.default_rng(5).integers(0, 256, (8, 3), dtype=np.uint8).tobytes()
    index = (np.add.outer(np.arange(H), 2 * np.arange(W)) % 8).astype(np.uint8)
    png(folder / "index.png", index, 3, extra=[(b"PLTE", palette)])
    png(folder / "indext.png", index, 3, extra=[(b"PLTE", palette), (b"tRNS", bytes([0, 90, 180, 255]))])
    (folder / "rgb.ppm").write_bytes(b"P6\n%d %d\n255\n" % (W, H) + rgb.tobytes())
    (folder / "grey.pgm").write_bytes(b"P5\n%d %d\n255\n" % (W, H) + grey.tobytes())
    tga(folder / "rgba.tga", rgba)
    bmp(folder / "rgb.bmp", rgb)
    (folder / "cube.df3").write_bytes(struct.pack(">HHH", 3, 4, 5) + bytes((i * 41) % 256 for i in range(60)))
    (folder / "old.inc").write_text("#version 3.5;\n#declare FromOld = 0.4;\n")
    (folder / "new.inc").write_text("#version 3.7;\n#declare FromNew = 0.4;\n")
    (folder / "kept.inc").write_text(
        "#ifndef(Kept_Inc)\n#declare Kept_Inc = version;\n#version 3.6;\n#declare FromKept = 0.4;\n"
        "#version Kept_Inc;\n#end\n")


if __name__ == "__main__":
    import sys

    write(Path(sys.argv[1]))
