#!/usr/bin/env python3
"""Lets programs that call `povray` call ours, through their own interfaces, and compares the pictures with POV-Ray's.

    python3 -m venv V && V/bin/pip install vapory ase fdray povplot "jinja2<3.1" "markupsafe<2.1"
    V/bin/python scripts/callers.py PROGRAM

Needs an installed POV-Ray. A caller that is not installed is left out. Prints, for each picture, how many values differ by
more than 2 of 255 and by how much at most; exit code 1 if that is more than one in twenty of any.
"""

import contextlib
import io
import os
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image


# The area lights of ASE are jittered, which is another chance in each program.
LIMIT = 0.05


def by_vapory(folder: Path):
    from vapory import Background, Camera, Finish, LightSource, Pigment, Scene, Sphere, Texture

    camera = Camera("location", [0, 2, -3], "look_at", [0, 1, 2])
    light = LightSource([2, 4, -3], "color", [1, 1, 1])
    ball = Sphere([0, 1, 2], 2, Texture(Pigment("color", [1, 0, 1]), Finish("phong", 0.8, "reflection", 0.3)))
    scene = Scene(camera, objects=[light, Background("color", [0.1, 0.2, 0.4]), ball])
    scene.render(str(folder / "vapory.png"), width=160, height=120, antialiasing=0.01)
    yield "file", np.asarray(Image.open(folder / "vapory.png"))
    yield "array", scene.render(width=160, height=120, quality=9)
    broken = Scene(camera, objects=[Sphere([0, 0, 0], 1, "nonsense")])
    try:
        broken.render(str(folder / "broken.png"), width=16, height=12)
    except IOError as error:
        assert "Parse Error" in str(error), error
    else:
        raise AssertionError("a wrong scene was rendered")


def by_ase(folder: Path):
    from ase.build import molecule
    from ase.io.pov import write_pov

    os.chdir(folder)
    write_pov("ase.pov", molecule("CH3CH2OH"), povray_settings={"canvas_width": 160}).render()
    yield "molecule", np.asarray(Image.open(folder / "ase.png"))


def by_fdray(_: Path):
    from fdray import Background, Camera, Color, LightSource, Renderer, Scene, Sphere

    scene = Scene(Camera(30, 30), LightSource(0, "white"), Background("white"), Sphere((0, 0, 0), 0.5, Color("red")))
    yield "ball", Renderer(160, 120).render(scene)


def by_povplot(folder: Path):
    import povplot

    # Its own triangles need an old matplotlib.
    scene = "camera { location <0, 1, -4> look_at 0 } light_source { <4, 4, -4>, 1 } sphere { 0, 1 pigment { rgb {{ red }} } }"
    with open(folder / "povplot.png", "wb") as out:
        povplot.render(out, scene="#version 3.7; global_settings { assumed_gamma 1 } " + scene, size=(160, 120),
                       antialias=True, transparent=True, scene_args={"red": "<1, .2, .1>"}, imgtype="png")
    yield "ball", np.asarray(Image.open(folder / "povplot.png"))


def pictures(caller, path: str) -> list:
    """What a caller makes with the first `povray` of a search path."""
    before, place = os.environ["PATH"], os.getcwd()
    os.environ["PATH"] = path
    try:
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            return [(name, np.asarray(picture).astype(int)) for name, picture in caller(Path(folder))]
    finally:
        os.environ["PATH"] = before
        os.chdir(place)


def main() -> int:
    program, usual = os.path.abspath(sys.argv[1]), os.environ["PATH"]
    if not shutil.which("povray"):
        sys.exit("POV-Ray is not installed")
    wrong = 0
    with tempfile.TemporaryDirectory() as links:
        os.symlink(program, Path(links) / "povray")
        for caller in [by_vapory, by_ase, by_fdray, by_povplot]:
            name = caller.__name__.removeprefix("by_")
            try:
                theirs = pictures(caller, usual)
            except ImportError as error:
                print(f"{name}: left out ({error})")
                continue
            for (what, one), (_, other) in zip(theirs, pictures(caller, f"{links}{os.pathsep}{usual}")):
                if one.shape != other.shape:
                    print(f"{name}, {what}: {one.shape} and {other.shape}")
                    wrong += 1
                    continue
                far = abs(one - other)
                print(f"{name}, {what}, {one.shape}: {(far > 2).mean():.2%} of the values differ by more than 2, at most {far.max()}")
                wrong += (far > 2).mean() > LIMIT
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
