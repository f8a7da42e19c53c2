#!/usr/bin/env python3
"""Lets programs that call `povray` call ours, through their own interfaces, and compares the pictures with POV-Ray's.

    python3 -m venv V && V/bin/pip install vapory ase fdray povplot plato-draw pillow "jinja2<3.1" "markupsafe<2.1"
    V/bin/python scripts/callers.py PROGRAM
    python3.12 -m venv W && W/bin/pip install quiltwright pillow    # it wants Python 3.12
    W/bin/python scripts/callers.py PROGRAM
    apt install pymol python3-pil && /usr/bin/python3 scripts/callers.py PROGRAM

Needs an installed POV-Ray. A caller that is not installed is left out. A picture is the same if 99.5 % of its pixels differ by
no more than 2 of 255 and all by 0.25 in the mean; exit code 1 unless all are.
"""

import contextlib
import os
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image


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


def by_plato(folder: Path):
    from plato.draw import povray

    places = np.array([[0, 0, 0], [1.2, 0.3, 0.2], [-0.8, 0.9, -0.4]], dtype=float)
    balls = povray.Spheres(positions=places, colors=[[0.8, 0.2, 0.1, 1], [0.1, 0.5, 0.9, 1], [0.2, 0.8, 0.3, 0.6]],
                           radii=[0.6, 0.4, 0.5])
    faces = povray.ConvexPolyhedra(positions=[[0.4, -1, 0.3]], orientations=[[0.9, 0.3, 0.2, 0.1]], colors=[[0.9, 0.8, 0.2, 1]],
                                   vertices=[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    features = {"antialiasing": {"value": 0.1}, "ambient_light": {"value": 0.25}, "transparent_background": {"value": True},
                "multithreading": {"value": 2}}
    for name, wanted in [("plain", {}), ("features", features)]:
        scene = povray.Scene([balls, faces], size=(6, 4.5), pixel_scale=27, features=wanted)
        scene.save(str(folder / f"{name}.png"))
        yield name, np.asarray(Image.open(folder / f"{name}.png"))


def by_quiltwright(folder: Path):
    from quiltwright.povray import PovCamera, depth_sweep, render_pov_quilt
    from quiltwright.quilt import QuiltSpec

    (folder / "hall.inc").write_text("plane { y, 0 pigment { checker rgb <.9, .8, .6> rgb .3 } }")
    (folder / "hall.pov").write_text("""#version 3.7; global_settings { assumed_gamma 1 } #include "hall.inc"
        light_source { <5, 9, -6>, 1 } sphere { <0, 1, 0>, 1 pigment { rgb <.2, .4, .9> } finish { reflection .3 phong .6 } }
        camera { location <0, 2, -8> look_at <0, 1, 0> }""")
    camera = PovCamera(location=(0, 2, -8), look_at=(0, 1, 0), fov=30)
    spec = QuiltSpec(columns=3, rows=2, quilt_width=288, quilt_height=256, aspect=0.75)
    yield "quilt", render_pov_quilt(folder / "hall.pov", spec, camera, jobs=2, progress=False)
    rows = depth_sweep(folder / "hall.pov", camera, [3, 6, 9], progress=False)
    yield "depths", np.array([[[255 * share for _, share in rows]]])


def by_pymol(folder: Path):
    import pymol2

    os.chdir(folder)
    with pymol2.PyMOL() as pymol:
        command = pymol.cmd
        command.fragment("trp")
        command.show_as("sticks")
        command.show("spheres", "elem N")
        command.bg_color("white")
        command.orient()
        command.ray(160, 120, renderer=1)
    # What it asked for; the picture that it shows is made of that.
    yield "molecule", np.asarray(Image.open(folder / "tmp_pymol.png"))


@contextlib.contextmanager
def silence():
    """What callers and their children say goes nowhere: POV-Ray draws pictures in letters on standard output."""
    sys.stdout.flush()
    kept = [os.dup(stream) for stream in (1, 2)]
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for stream in (1, 2):
            os.dup2(nowhere, stream)
        yield
    finally:
        sys.stdout.flush()
        for stream, copy in zip((1, 2), kept):
            os.dup2(copy, stream)
        for descriptor in [nowhere, *kept]:
            os.close(descriptor)


def pictures(caller, path: str) -> list:
    """What a caller makes with the first `povray` of a search path."""
    before, place = os.environ["PATH"], os.getcwd()
    os.environ["PATH"] = path
    try:
        with tempfile.TemporaryDirectory() as folder, silence():
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
        for caller in [by_vapory, by_ase, by_fdray, by_povplot, by_plato, by_quiltwright, by_pymol]:
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
                near = (far.max(axis=2) <= 2).mean()
                same = near >= 0.995 and far.mean() <= 0.25
                wrong += not same
                print(f"{name}, {what}, {one.shape}: {'same' if same else 'NOT SAME'}, {near:.2%} of pixels within 2,"
                      f" mean {far.mean():.4f}, at most {far.max():.0f}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
