#!/usr/bin/env python3
"""Writes a scene with N random spheres (100,000 unless told otherwise) over a mirror-like floor.

    python3 benches/generate_spheres.py spheres.pov
"""

import argparse
import random
import sys
from typing import TextIO

HEAD = """// {count} random spheres over a mirror-like floor, written by benches/generate_spheres.py.
#version 3.7;
global_settings {{ assumed_gamma 1.0 }}

camera {{ location <0, 7, -26> look_at <0, 2.5, 0> angle 45 }}
light_source {{ <-30, 40, -35> rgb 0.9 }}
light_source {{ <40, 25, -20> rgb <0.25, 0.25, 0.35> }}
background {{ rgb <0.25, 0.4, 0.7> }}

plane {{ y, 0 pigment {{ rgb <0.15, 0.15, 0.18> }} finish {{ reflection 0.5 }} }}

#declare Red = texture {{ pigment {{ rgb <0.85, 0.25, 0.2> }} finish {{ phong 0.6 }} }}
#declare Gold = texture {{ pigment {{ rgb <0.9, 0.7, 0.25> }} finish {{ specular 0.7 metallic }} }}
#declare Green = texture {{ pigment {{ rgb <0.3, 0.65, 0.3> }} }}
#declare Blue = texture {{ pigment {{ rgb <0.25, 0.4, 0.85> }} finish {{ phong 0.6 }} }}
#declare Mirror = texture {{ pigment {{ rgb 0.1 }} finish {{ reflection 0.6 }} }}

"""


def write(out: TextIO, count: int) -> None:
    source = random.Random(20240229)
    # The spheres fill the same share of the space whatever their number.
    typical = 0.13 * (100_000 / max(count, 1)) ** (1 / 3)
    out.write(HEAD.format(count=count))
    for _ in range(count):
        radius = typical * source.uniform(0.3, 1.0)
        x, z = source.uniform(-18, 18), source.uniform(-10, 22)
        y = radius + 7 * source.random() ** 2
        name = source.choices(("Red", "Gold", "Green", "Blue", "Mirror"), weights=(3, 2, 3, 3, 1))[0]
        out.write(f"sphere {{ <{x:.5g}, {y:.5g}, {z:.5g}>, {radius:.4g} texture {{ {name} }} }}\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spheres", type=int, default=100_000, help="how many (default: %(default)s)")
    parser.add_argument("file", help="scene to write, - for standard output")
    asked = parser.parse_args()
    with sys.stdout if asked.file == "-" else open(asked.file, "w") as out:
        write(out, asked.spheres)


if __name__ == "__main__":
    main()
