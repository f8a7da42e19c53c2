"""What stands around objects: versions, gamma, declarations, cameras, lights and what fills the air."""

from __future__ import annotations

import re

from grammar import Grammar, production, simplest
from tree import Node, block, group, leaf, need

simplest("camera", lambda: leaf("camera { location <0,1,-4> look_at 0 }"))
simplest("light", lambda: leaf("light_source { <3,5,-6>, 1 }"))

OLD = ["3.0", "3.1", "3.5", "3.6", "3.62"]


def scene(g: Grammar) -> Node:
    """Returns a whole scene."""
    parts = [g.make("header"), *declarations(g)]
    if g.flip(0.1, "legacy", "texture", "finish"):
        parts.append(g.make("default"))
    parts.append(g.make("camera"))
    parts += [g.make("light") for _ in g.some(1, 3 if g.in_focus("light") else 1)]
    parts += [g.make("item") for _ in g.some(1, 3)]
    if g.flip(0.35, "air", "gamma"):
        parts += [g.make("air") for _ in g.some(1, 2)]
    if g.flip(0.1, "gamma", "legacy"):
        parts.insert(g.rng.randint(0, len(parts)), leaf(f"#version {g.pick(*OLD, '3.7', '3.7')};", feature="late version"))
    whole = group(*parts)
    if re.search(r"\bf_[a-z]", whole.text()):
        parts.insert(1, leaf('#include "functions.inc"', feature="functions.inc"))
    return group(*parts)


# Version and gamma


@production("header", "gamma", 5)
def modern(g):
    g.has_gamma, g.version = True, "3.7"
    return group(leaf("#version 3.7;", feature="version 3.7"), settings(g, "1"))


@production("header", "gamma", 3)
def any_header(g):
    parts = []
    version = g.pick("", "3.7", "3.7", *OLD)
    if version:
        parts.append(leaf(f"#version {version};", feature=f"version {version}"))
    g.version = version
    if g.flip(0.25, "gamma"):
        g.includes.add("colors.inc")
        parts.append(leaf('#include "colors.inc"', feature="colors.inc"))
    for file in ("old.inc", "new.inc", "kept.inc"):
        if g.flip(0.04, "gamma"):
            parts.append(leaf(f'#include "{file}"', feature=file))
    gamma = g.pick("", "1", "1", "2.2", "srgb", "1.8")
    g.has_gamma = bool(gamma)
    parts.append(settings(g, gamma))
    return group(*parts)


def settings(g: Grammar, gamma: str) -> Node:
    """Returns global_settings with a gamma, or without where it is empty."""
    made = [leaf(f"assumed_gamma {gamma}", feature=f"assumed_gamma {gamma}")] if gamma else []
    if g.flip(0.12, "legacy", "finish", "pattern"):
        made.append(leaf(g.pick(f"ambient_light {g.pick(g.rgb(), '2', '0')}", f"noise_generator {g.pick(1, 2, 3)}", f"max_trace_level {g.integer(1, 9)}", f"adc_bailout {g.pick('0', '.1', '.003')}", "irid_wavelength rgb <.3,.2,.14>", "number_of_waves 4", "max_intersections 128", "charset utf8")))
    return block("global_settings", *made) if made or g.rng.random() < 0.3 else group()


# Declarations


def declarations(g: Grammar) -> list[Node]:
    """Returns declarations that later parts may use."""
    makers = {"colour": ("Col1", g.rgb), "transform": ("Tra1", lambda: f"transform {{ rotate {g.vector(-45, 45)} translate {g.vector(-0.3, 0.3)} scale {g.pick('1', '.8', '<1,2,1>')} }}")}
    blocks = {"pigment": ("Pig1", "pigment body"), "normal": ("Nor1", "normal body"), "texture": ("Tex1", "texture body")}
    made = []
    for kind, (name, make) in makers.items():
        if g.flip(0.15, "language", "transform"):
            made.append(leaf(f"#declare {name} = {make()};" if kind == "colour" else f"#declare {name} = {make()}", feature="declare " + kind))
            g.declare(kind, name)
    for kind, (name, sort) in blocks.items():
        if g.flip(0.15, "language", "texture"):
            made.append(Node(f"#declare {name} =", [block(kind, g.make(sort))], feature="declare " + kind))
            g.declare(kind, name)
    for kind, name in (("finish", "Fin1"), ("interior", "Int1"), ("object", "Obj1")):
        if g.flip(0.12, "language", "csg"):
            made.append(Node(f"#declare {name} =", [g.make(kind)], feature="declare " + kind))
            g.declare(kind, name)
    if g.flip(0.12, "language", "pattern"):
        made.append(leaf(f"#declare Fun1 = function {{ {g.pick('x*x-y', 'sin(x*4)*cos(z*3)', 'pattern { bozo }', 'pattern { marble turbulence .3 scale .5 }', 'x+y+z', 'max(x,y)', 'f_noise3d(x,y,z)')} }}", feature="declare function"))
        g.declare("function", "Fun1")
    if g.in_focus("language") or "Fun1" in g.names.get("function", []):
        made.append(g.make("prelude"))
    return made


@production("default", "legacy")
def default(g):
    return leaf("#default { " + g.pick("pigment { rgb <.9,.7,.2> }", "finish { ambient .3 }", "finish { ambient 0 diffuse .9 }", "texture { pigment { rgb <.2,.7,.9> } finish { phong .6 } }", "normal { bumps .3 }") + " }")


# Cameras


@production("camera", "camera", 4)
def plain_camera(g):
    made = [need(f"location <{g.number(-2, 2)},{g.number(-1, 3)},{g.pick('-4', '-5', '-3')}>"), leaf(f"look_at {g.pick('0', '0', g.vector(-0.5, 0.5))}")]
    made[1:1] = g.maybe(0.3, f"angle {g.pick('40', '60', '30', '90')}", "angle")
    return block("camera", *made)


@production("camera", "camera")
def special_camera(g):
    kind = g.pick("perspective", "orthographic", "fisheye", "ultra_wide_angle", "omnimax", "panoramic", "cylinder 1", "cylinder 2", "cylinder 3", "cylinder 4", "spherical")
    made = [leaf(kind, feature=kind), need(f"location {g.pick('<0,1,-4>', '<1,1.5,-3>', '<0,0,-2.5>')}")]
    made += g.maybe(0.3, f"up {g.pick('y', '2*y', '<0,1,.2>')}") + g.maybe(0.3, f"right {g.pick('x', '-x*4/3', 'x*2', '<1.33,.2,0>')}") + g.maybe(0.25, f"direction {g.pick('z', '2*z', '<0,.1,1>')}") + g.maybe(0.2, f"sky {g.direction()}")
    made += g.maybe(0.5, f"angle {g.pick('40', '90', '150', '200', '360', '180, 90' if kind == 'spherical' else '20')}", "angle")
    made += g.maybe(0.7, f"look_at {g.pick('0', '<.2,.1,0>')}") + g.maybe(0.2, f"rotate {g.vector(-30, 30)}") + g.maybe(0.1, "translate .3*x") + g.maybe(0.1, "scale <1,1.2,1>")
    if g.flip(0.08, "camera"):
        made.append(leaf(f"aperture {g.unit()} blur_samples {g.integer(2, 20)} focal_point {g.pick('0', '<0,0,-1>')}", feature="focal blur"))
    if g.flip(0.06, "camera"):
        made.append(leaf(f"normal {{ {g.pick('bumps', 'ripples', 'gradient x')} {g.unit()} scale .3 }}", feature="camera normal"))
    return block("camera", *made)


# Lights


@production("light", "light", 5)
def point_light(g):
    return block("light_source", need(f"{g.pick('<3,5,-6>', '<-4,3,-3>', g.vector(-5, 5))}, {g.pick('1', '1', g.rgb(), 'rgb 1.5', 'color rgb -.3', '<1,.8,.6>')}"), *light_ends(g))


@production("light", "light", 1.5)
def spot_light(g):
    kind = g.pick("spotlight", "spotlight", "cylinder")
    sizes = f"radius {g.number(5, 30)}", f"falloff {g.number(5, 45)}"
    if kind == "cylinder":
        sizes = f"radius {g.number(0.1, 1)}", f"falloff {g.number(0.3, 2)}"
    return block("light_source", need(f"<2,4,-3>, {g.pick('1', g.rgb())}"), leaf(kind, feature="light " + kind), leaf(f"point_at {g.vector(-0.5, 0.5)}"), *[leaf(s) for s in sizes if g.rng.random() < 0.8], *g.maybe(0.4, f"tightness {g.number(0, 20)}"), *g.maybe(0.15, "parallel", "parallel"), *light_ends(g))


@production("light", "light", 1)
def area_light(g):
    counts = g.pick("1, 4", "3, 3", "2, 2", "5, 1", "4, 3")
    made = [need(f"<2,4,-3>, {g.pick('1', g.rgb())}"), need(f"area_light {g.direction()}, {g.direction()}, {counts}")]
    made += g.maybe(0.4, f"adaptive {g.integer(0, 3)}", "adaptive") + (g.maybe(0.3, "circular", "circular") if "1" not in counts else []) + (g.maybe(0.3, "orient", "orient") if "1" not in counts else []) + g.maybe(0.25, "area_illumination on", "area_illumination")
    made += g.maybe(0.15, "spotlight point_at 0 radius 15 falloff 25") + g.maybe(0.1, "parallel point_at 0", "parallel") + (g.maybe(0.3, "jitter") if g.chance else [])
    return block("light_source", *made, *light_ends(g))


@production("light", "light", 0.8)
def parallel_light(g):
    return block("light_source", need(f"<2,4,-3>, {g.rgb()}"), leaf("parallel"), leaf(f"point_at {g.vector(-1, 1)}"), *light_ends(g))


def light_ends(g: Grammar) -> list[Node]:
    """Returns what may end any light."""
    made = []
    if g.flip(0.12, "light"):
        made.append(leaf(f"fade_distance {g.number(0.5, 8)} fade_power {g.pick('1', '2', '3')}", feature="light fade"))
    made += g.maybe(0.05, "shadowless", "shadowless") + g.maybe(0.05, g.pick("media_interaction off", "media_attenuation on"))
    if g.flip(0.05, "light"):
        made.append(leaf(f"looks_like {{ sphere {{ 0, .3 pigment {{ {g.rgb()} }} }} }}", feature="looks_like"))
    if g.flip(0.04, "light"):
        made.append(leaf(f"projected_through {{ {g.pick('sphere { <1,2,-1.5>, .5 }', 'box { <0,1.9,-3>, <2,2,0> }')} }}", feature="projected_through"))
    if g.flip(0.06, "transform"):
        made.append(leaf(f"translate {g.vector(-1, 1)}"))
    return made


# What fills the air


@production("air", "air", 3)
def background(g):
    return block("background", g.make("colour"))


@production("air", "air", 3)
def sky_sphere(g):
    pigments = [block("pigment", g.make("pigment body")) for _ in g.some(1, 2)]
    return block("sky_sphere", *pigments, *g.maybe(0.2, f"emission {g.pick('.5', 'rgb <1,.5,.2>')}"), *g.maybe(0.3, f"rotate {g.vector(-90, 90)}"))


@production("air", "air", 2)
def fog(g):
    made = [leaf(f"fog_type {g.pick(1, 2)}"), need(f"distance {g.number(1, 12)}"), g.make("colour")]
    made += g.maybe(0.4, f"fog_offset {g.number(-1, 1)}") + g.maybe(0.5, f"fog_alt {g.number(0.2, 2)}") + g.maybe(0.2, f"turbulence {g.unit()}") + g.maybe(0.2, f"turb_depth {g.unit()}") + g.maybe(0.15, f"up {g.direction()}") + g.maybe(0.1, f"rotate {g.vector(-40, 40)}")
    return block("fog", *made)


@production("air", "air", 0.8)
def rainbow(g):
    made = [need(f"angle {g.pick('30', '20', '42.5')}"), need(f"width {g.pick('5', '20')}"), need(f"direction {g.pick('z', '<0,-.2,1>', g.direction())}"), leaf(f"distance {g.pick('1000', '3')}"), block("color_map", need("[0 rgbt <1,0,0,.5>]"), leaf(f"[.5 {g.rgb()}]"), leaf("[1 rgbt 1]"))]
    return block("rainbow", *made, *g.maybe(0.3, "up <.2,1,0>"), *g.maybe(0.4, f"arc_angle {g.pick('90', '180')}"), *g.maybe(0.3, f"falloff_angle {g.pick('120', '200')}"))


# Items: objects by themselves or made by directives


@production("item", "shape", 6)
def single(g):
    return group(g.make("object"))


@production("item", "csg", 1)
def floor(g):
    return block("plane", need(f"y, {g.pick('-1', '-1.2', '-.5')}"), g.make("look"))
