#!/usr/bin/env python3
"""Renders small scenes of media, photons, radiosity and light below surfaces by us and by POV-Ray, and says how far apart they are.

    cargo build --release
    python3 scripts/global_light.py [--program FILE] [NAME …]

Prints a row of a Markdown table for each scene: largest difference, rms and change of the mean, linear, beside what is accepted:
about as much as POV-Ray with two threads differs from POV-Ray with one. Exit code 1 if a scene is further away.

Needs POV-Ray 3.7 and Python's OpenEXR and numpy.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy

from contact_sheets import ROOT, read_exr

# Half a step of POV-Ray's 16 bits, and single precision on our side.
EQUAL = 2e-5

FOG = """camera { location <0, 1, -6> look_at <0, 1, 0> }
light_source { <-3, 5, -1>, 1 spotlight point_at <0, 0, 0> radius 12 falloff 18 }
plane { y, 0 pigment { rgb .5 } }
sphere { <0, .6, 0>, .6 pigment { rgb <.8, .4, .2> } }
box { <-4, -.1, -4>, <4, 6, 4> hollow pigment { rgbt 1 } interior { media { scattering { 1, .04 } MEDIA } } }"""

BOZO = """camera { location <0, 0, -5> look_at 0 }
light_source { <5, 5, -5>, 1 }
sphere { 0, 1.5 hollow pigment { rgbt 1 } interior { media { emission .1 absorption .1 scattering { 1, .2 } MEDIA
  density { bozo color_map { [.3 rgb 0] [.7 rgb <1, .7, .4>] } scale .5 } } } }
plane { -z, -4 hollow pigment { rgb .1 } }"""

BALL = """global_settings { photons { spacing .02 } }
camera { location <0, 4, -5> look_at <.3, 0, 0> angle 45 }
light_source { <-3, 6, -1>, .8 }
plane { y, 0 pigment { rgb .6 } finish { ambient 0 diffuse .7 } }
sphere { <0, 1, 0>, .7 pigment { rgbt .95 } interior { ior IOR } photons { target refraction on reflection off collect off } }"""

TWO = BALL + """
light_source { <4, 5, -2>, <.3, .4, .6> }
box { <1.4, 0, -.6>, <1.6, 1.2, .9> pigment { rgb .3 } finish { reflection .6 } photons { target reflection on } }"""

# The ball all but touches the floor, and its caustic has a cusp.
CUSP = BALL.replace("<0, 1, 0>, .7", "<0, .72, 0>, .7")

ROOM = """global_settings { radiosity { RADIOSITY } }
camera { location <0, 1.5, -3.8> look_at <0, 1.2, 0> angle 70 }
light_source { <0, 2.7, -1>, .35 fade_distance 2 fade_power 2 }
box { <-2, 0, -4>, <2, 3, 2> hollow pigment { rgb <.8, .7, .6> } finish { ambient 0 diffuse .7 } }
sphere { <.8, .5, .2>, .5 pigment { rgb <.3, .5, .8> } finish { ambient 0 diffuse .8 } }
box { <-1.4, 0, 0>, <-.4, 1.6, 1> pigment { rgb .8 } finish { ambient 0 diffuse .8 } rotate 10*y }"""

MARBLE = """global_settings { mm_per_unit 10 subsurface { samples 50, 50 } }
camera { location <0, 2, -6> look_at 0 angle 40 }
light_source { <-4, 5, -6>, .8 }
plane { y, -1 pigment { rgb .5 } finish { ambient 0 diffuse .6 } }
sphere { 0, 1 pigment { rgb <.8, .7, .5> } finish { ambient 0 diffuse .7 subsurface { translucency <.5, .3, .2> } }
  interior { ior 1.3 } }"""


@dataclass(frozen=True)
class Accepted:
    """Largest differences that are no difference; of the mean as a part of it."""

    worst: float | None = None
    rms: float | None = None
    mean: float | None = None


@dataclass(frozen=True)
class Case:
    """A scene, and how near we must be. `handed_on` has its radiosity saved and loaded by us."""

    name: str
    scene: str
    accepted: Accepted
    size: tuple[int, int] = (160, 120)
    handed_on: bool = False


def noise(rms: float) -> Accepted:
    """Of random samples: POV-Ray's own rms by half more, and an unbiased mean."""
    return Accepted(rms=1.5 * rms, mean=0.005)


SAME = Accepted(worst=EQUAL)
CAUSTIC = Accepted(rms=0.006, mean=0.03)
# What POV-Ray's picture changes by when the spacing is .0201.
SHARP_CAUSTIC = Accepted(rms=0.0138, mean=0.03)
INDIRECT = Accepted(rms=0.003, mean=0.01)
FINE = "count 100 error_bound .5 pretrace_end .01"

CASES = [
    Case("media-2", FOG.replace("MEDIA", "method 2 samples 10"), SAME),
    Case("media-3", FOG.replace("MEDIA", ""), SAME),
    Case("media-3-jitter", FOG.replace("MEDIA", "jitter .5"), noise(0.0011)),
    Case("media-2-jitter", FOG.replace("MEDIA", "method 2 samples 10 jitter 1"), noise(0.0012)),
    Case("media-1", FOG.replace("MEDIA", "method 1 intervals 10 samples 1"), noise(0.0048)),
    Case("bozo-3", BOZO.replace("MEDIA", ""), SAME),
    Case("bozo-1", BOZO.replace("MEDIA", "method 1 intervals 10 samples 1"), noise(0.0090)),
    Case("photons", BALL.replace("IOR", "1.2"), CAUSTIC),
    Case("photons-two", TWO.replace("IOR", "1.2"), CAUSTIC),
    Case("photons-sharp", BALL.replace("IOR", "1.5"), SHARP_CAUSTIC),
    Case("photons-cusp", CUSP.replace("IOR", "1.5"), CAUSTIC),
    Case("photons-cusp-radius", CUSP.replace("IOR", "1.5").replace(".02", ".02 radius .05"), CAUSTIC),
    Case("radiosity", ROOM.replace("RADIOSITY", ""), INDIRECT),
    Case("radiosity-fine", ROOM.replace("RADIOSITY", FINE), INDIRECT),
    Case("radiosity-handed-on", ROOM.replace("RADIOSITY", ""), INDIRECT, handed_on=True),
    Case("subsurface", MARBLE, Accepted(mean=0.005), size=(80, 60)),
]


def run(command: list[str], folder: Path) -> None:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}\n{done.stderr[-3000:]}")


def read_ppm(path: Path) -> numpy.ndarray:
    """Linear RGB of 16 bits, height x width x 3, top row first."""
    data = path.read_bytes()
    header = re.match(rb"P6\s(?:#[^\n]*\n)*(\d+)\s+(\d+)\s+65535\s", data)
    width, height = map(int, header.groups())
    return numpy.frombuffer(data[header.end() :], ">u2").reshape(height, width, 3) / 65535


def by_povray(case: Case, folder: Path) -> numpy.ndarray:
    width, height = case.size
    size = [f"+W{width}", f"+H{height}"]
    run(["povray", "+Is.pov", "+Op.ppm", *size, "+FP16", "File_Gamma=1", "+WT1", "-D", "-A"], folder)
    return read_ppm(folder / "p.ppm")


def by_us(case: Case, folder: Path, program: Path) -> numpy.ndarray:
    width, height = case.size
    command = [str(program), "render", "s.pov", "--output", "w.exr", "--width", str(width), "--height", str(height), "--float"]
    if case.handed_on:
        run([*command, "--radiosity-to", "light.txt"], folder)
        command += ["--radiosity-from", "light.txt"]
    run(command, folder)
    return read_exr(folder / "w.exr")


def told(case: Case, found: Accepted) -> tuple[str, bool]:
    """A row of the table, and whether all is near enough."""
    words, met = [case.name], True
    for name, digits in (("worst", 5), ("rms", 5), ("mean", 4)):
        value, limit = getattr(found, name), getattr(case.accepted, name)
        met &= limit is None or value <= limit
        words.append(f"{value:.{digits}f}" + ("" if limit is None else f" (≤ {limit:.5g})"))
    return f"| {' | '.join([*words, 'met' if met else 'NOT MET'])} |", met


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=ROOT / "target/release/whitted")
    parser.add_argument("names", nargs="*", help="only these scenes")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    print("| scene | largest | rms | mean | |\n|---|---|---|---|---|")
    all_met = True
    for case in CASES:
        if arguments.names and case.name not in arguments.names:
            continue
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "s.pov").write_text(f"#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{case.scene}\n")
            theirs, ours = by_povray(case, folder), by_us(case, folder, program)
        # POV-Ray's file holds nothing brighter than white.
        away = numpy.clip(ours, 0, 1) - theirs
        mean = abs(away.mean()) / theirs.mean()
        found = Accepted(float(abs(away).max()), float(numpy.sqrt((away**2).mean())), float(mean))
        row, met = told(case, found)
        print(row, flush=True)
        all_met &= met
    return 0 if all_met else 1


if __name__ == "__main__":
    sys.exit(main())
