#!/usr/bin/env python3
"""Counts the instructions that a pixel of a plain scene takes, by callgrind, and compares them with what they may be.

    python3 benches/instructions.py                       all scenes; exit code 1 where one is above its limit
    python3 benches/instructions.py --binary OTHER plane  some, by another program, to compare

Counts are differences between two sizes of a picture, so that start and end cost nothing. They are the same on all
machines of a kind, and do not drift with load; limits are some percent above what was found, for other compilers.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEAD = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 45 } light_source { <5, 9, -7>, 1 }
"""
FLOOR = "plane { y, -1 pigment { rgb <.6, .7, .8> } }\n"
BALLS = "#for (I, 0, 9) sphere { <mod(I, 5) - 2, 0, div(I, 5) * 2>, .5 pigment { rgbt <.9, I / 10, .3, T> } F } #end\n"
SOLIDS = """#for (I, 0, 3) difference {
    box { <-.6, -.6, -.6>, .6 } cylinder { -z, z, .4 } sphere { <.6, .6, -.6>, .5 }
    pigment { rgb <.9, .5, .3> } rotate 30 * I * y translate (I * 1.6 - 2.4) * x } #end
"""


def balls(finish: str, transmit: float = 0) -> str:
    return FLOOR + BALLS.replace("F }", finish + " }").replace("T>", f"{transmit}>")


#: Scene, and the most instructions that a pixel of it may take: 8 % more than were counted.
SCENES = {
    "plane": (FLOOR, 3050),
    "checker": (FLOOR.replace("rgb <.6, .7, .8>", "checker rgb 1, rgb .3"), 3050),
    "spheres": (balls("finish { phong .8 phong_size 40 }"), 3800),
    "mirrors": (balls("finish { reflection .5 }"), 4600),
    "glass": (balls("finish { specular .3 } interior { ior 1.5 }", 0.8), 7750),
    "solids": (FLOOR + SOLIDS, 6150),
}


def instructions(binary: str, scene: str, width: int, height: int) -> int:
    """Of a whole run on one thread."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.pov").write_text(HEAD + scene)
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", binary, "render", "scene.pov"]
        command += ["-o", "scene.exr", "-t", "1", "-a", "off", "-W", str(width), "-H", str(height)]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        found = re.search(r"Collected : (\d+)", done.stderr)
        if done.returncode != 0 or not found:
            sys.exit(f"{' '.join(command)}\n{done.stderr[-2000:]}")
        return int(found[1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", help="default: all")
    parser.add_argument("--binary", default=str(ROOT / "target/release/whitted"), help="default: %(default)s")
    asked = parser.parse_args()
    above = 0
    for name in asked.scenes or SCENES:
        scene, limit = SCENES[name]
        (small, large) = ((64, 48), (128, 96))
        more = instructions(asked.binary, scene, *large) - instructions(asked.binary, scene, *small)
        each = more / (large[0] * large[1] - small[0] * small[1])
        above += each > limit
        print(f"{name:10} {each:8.0f} instructions a pixel, at most {limit}{'' if each <= limit else ': TOO MANY'}")
    sys.exit(1 if above else 0)


if __name__ == "__main__":
    main()
