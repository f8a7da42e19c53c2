#!/usr/bin/env python3
"""Writes a scene with one mesh2: a rippled surface of N triangles (a million unless told otherwise).

    python3 benches/generate_mesh.py mesh.pov
    python3 benches/generate_mesh.py --triangles 5000000 --smooth mesh.pov
"""

import argparse
import math
import sys
from typing import Iterator, TextIO

HEAD = """// A rippled surface of {count} triangles, written by benches/generate_mesh.py.
#version 3.7;
global_settings {{ assumed_gamma 1.0 }}

camera {{ location <0, 4.5, -7> look_at <0, -0.4, 0> angle 42 }}
light_source {{ <-6, 9, -5> rgb 1 }}
background {{ rgb <0.05, 0.07, 0.12> }}

mesh2 {{
"""
TAIL = """  pigment { rgb <0.75, 0.55, 0.35> }
  finish { specular 0.3 roughness 0.02 }
}
"""


def height(x: float, z: float) -> tuple[float, float, float]:
    """Height of the surface and its slopes along x and z: rings around two centres."""
    total, slope_x, slope_z = 0.0, 0.0, 0.0
    for centre_x, centre_z, size, rate in ((-1.2, 0.6, 0.25, 5.0), (1.6, -0.9, 0.15, 9.0)):
        r = math.hypot(x - centre_x, z - centre_z) + 1e-9
        fall = size / (1 + r)
        total += fall * math.cos(rate * r)
        along = -fall / (1 + r) * math.cos(rate * r) - fall * rate * math.sin(rate * r)
        slope_x += along * (x - centre_x) / r
        slope_z += along * (z - centre_z) / r
    return total, slope_x, slope_z


def grid(rows: int, columns: int) -> Iterator[tuple[float, float]]:
    for j in range(rows + 1):
        for i in range(columns + 1):
            yield 8 * i / columns - 4, 8 * j / rows - 4


def write(out: TextIO, triangles: int, smooth: bool) -> None:
    rows = max(1, math.isqrt(triangles // 4))
    columns = max(1, round(triangles / (2 * rows)))
    vertices = (rows + 1) * (columns + 1)
    out.write(HEAD.format(count=2 * rows * columns))
    out.write(f"  vertex_vectors {{\n    {vertices}")
    out.writelines(f",\n    <{x:.6g}, {height(x, z)[0]:.6g}, {z:.6g}>" for x, z in grid(rows, columns))
    out.write("\n  }\n")
    if smooth:
        out.write(f"  normal_vectors {{\n    {vertices}")
        slopes = (height(x, z) for x, z in grid(rows, columns))
        out.writelines(f",\n    <{-along_x:.6g}, 1, {-along_z:.6g}>" for _, along_x, along_z in slopes)
        out.write("\n  }\n")
    out.write(f"  face_indices {{\n    {2 * rows * columns}")
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b = a + columns + 1
            out.write(f",\n    <{a}, {a + 1}, {b}>, <{a + 1}, {b + 1}, {b}>")
    out.write("\n  }\n")
    out.write(TAIL)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--triangles", type=int, default=1_000_000, help="about how many (default: %(default)s)")
    parser.add_argument("--smooth", action="store_true", help="with a normal for each vertex")
    parser.add_argument("file", help="scene to write, - for standard output")
    asked = parser.parse_args()
    with sys.stdout if asked.file == "-" else open(asked.file, "w") as out:
        write(out, asked.triangles, asked.smooth)


if __name__ == "__main__":
    main()
