"""Looks: pigments, patterns, normals, finishes, textures and interiors."""

from __future__ import annotations

import re

from grammar import Grammar, production, simplest
from tree import Node, block, group, leaf, need

simplest("look", lambda: leaf("pigment { rgb <.8,.6,.4> }"))
simplest("pigment body", lambda: leaf("rgb <.8,.6,.4>"))
simplest("texture body", lambda: leaf("pigment { rgb <.8,.6,.4> }"))
simplest("normal body", lambda: leaf("bumps 1"))
simplest("pattern", lambda: leaf("gradient x"))
simplest("finish", lambda: leaf("finish { ambient 1 diffuse 0 }"))


@production("look", "texture", 4)
def pigment(g):
    made = [block("pigment", *([need("uv_mapping", "uv_mapping")] if g.flip(0.06, "texture") else []), g.make("pigment body"))]
    if g.flip(0.2, "normal"):
        made.append(g.make("normal"))
    if g.flip(0.35, "finish"):
        made.append(g.make("finish"))
    if g.flip(0.12, "interior"):
        made.append(g.make("interior"))
    return group(*made)


@production("look", "texture", 3)
def texture(g):
    made = [block("texture", g.make("texture body"))]
    while g.flip(0.2, "texture") and len(made) < 3:
        made.append(block("texture", g.make("layer"), feature="layer"))
    if g.flip(0.1, "texture"):
        made.append(block("interior_texture", g.make("texture body"), feature="interior_texture"))
    if g.flip(0.12, "interior"):
        made.append(g.make("interior"))
    return group(*made)


@production("look", "interior", 1)
def glass(g):
    return group(leaf(f"pigment {{ {g.pick('rgbf <.9,1,.9,.8>', 'rgbt <1,.8,.6,.7>', 'rgbft <.8,.9,1,.4,.4>', 'rgbt 1')} }}"), g.make("finish"), g.make("interior"))


@production("look", "texture", 0.5)
def material(g):
    return block("material", block("texture", g.make("texture body")), *([g.make("interior")] if g.rng.random() < 0.6 else []), *g.maybe(0.3, f"scale {g.positive()}"))


# Pigments


@production("colour", "pigment", 3)
def plain_colour(g):
    return leaf(g.rgb())


@production("colour", "pigment")
def odd_colour(g):
    forms = [f"rgbf <{g.unit()},{g.unit()},{g.unit()},{g.unit()}>", f"rgbt <{g.unit()},{g.unit()},{g.unit()},{g.unit()}>", f"color red {g.unit()} green {g.unit()}",
             f"rgbft <{g.unit()},{g.unit()},{g.unit()},.3,.4>", f"rgb {g.vector(0, 1)} transmit {g.unit()}", f"rgb {g.number(0, 2)}", f"color {g.vector(0, 1)}", f"rgb {g.vector(-1, 3)}",
             f"rgb <.2,.5,.8>*{g.number(0, 2)}", f"rgb .5 filter {g.unit()}", f"rgbt {g.unit()}", f"rgb <{g.unit()},{g.unit()},{g.unit()}>+{g.vector(0, 1)}*.2"]
    if g.has_gamma:
        forms += [f"srgb {g.vector(0, 1)}", f"srgbt <{g.unit()},{g.unit()},{g.unit()},.3>"]
    if "colors.inc" in g.includes:
        forms += ["Orange", "color Red", "rgb Gold*.7", "Clear", "color SkyBlue transmit .4", "Green filter .5"]
    if name := g.name("colour"):
        forms += [name, f"color {name}", f"{name}*.5", f"rgb {name}", f"color {name} transmit .3"]
    return leaf(g.rng.choice(forms))


simplest("colour", lambda: leaf("rgb <.8,.6,.4>"))


@production("pigment body", "pigment", 4)
def solid(g):
    return g.make("colour")


def entries(g: Grammar, sort: str) -> list[Node]:
    """Returns the entries of a map, with the usual and the unusual stops."""
    n = g.rng.randint(1, 4)
    stops = g.pick([i / max(n - 1, 1) for i in range(n)], sorted(round(g.rng.uniform(0, 1), 2) for _ in range(n)), [0.5] * n, [round(g.rng.uniform(-0.3, 1.3), 2) for _ in range(n)])
    made = [Node(f"[{stop:g}", [coloured(g.make(sort)) if sort == "colour" else g.make(sort)], "]") for stop in stops]
    made[0].keep = True
    return made


def coloured(node: Node) -> Node:
    """Returns a colour with the keyword that a colour map asks for (ours takes it without, too)."""
    node.head = node.head if re.match("[cs]?rgb|colou?r|red", node.head) else "color " + node.head
    return node


@production("pigment body", "pigment", 4)
def patterned_pigment(g):
    maps = []
    if g.rng.random() < 0.85:
        if g.rng.random() < 0.1:
            maps = [block(g.pick("color_map", "colour_map"), need(f"[0, .4 color {g.rgb()} color {g.rgb()}]"), leaf(f"[.4, 1.001 color {g.rgb()} color {g.rgb()}]"), feature="old_color_map")]
        elif g.depth < 5 and g.flip(0.2, "pigment"):
            maps = [block("pigment_map", *entries(g, "pigment body"), feature="pigment_map")]
        else:
            maps = [block("color_map", *entries(g, "colour"), feature="color_map")]
    return group(g.make("pattern"), *maps, *pattern_modifiers(g))


@production("pigment body", "pigment", 1.5)
def listed_pigment(g):
    word = g.pick("checker", "hexagon", "brick", "square", "triangular", "cubic", "object")
    if word == "object":
        head = f"object {{ {g.pick('sphere { 0, .8 }', 'box { -.5, .6 }', 'torus { .7, .3 }', 'plane { y, .1 }', 'union { sphere { x*.5, .5 } box { -.3, .2 } }')}"
        n, tail = 2, "}"
    else:
        n, head, tail = {"checker": 2, "hexagon": 3, "brick": 2, "square": 4, "triangular": 6, "cubic": 6}[word], word, ""
    colours = [block("pigment", g.make("pigment body")) if g.depth < 4 and g.flip(0.1, "pigment") else g.make("colour") for _ in range(g.pick(n, n, n, 1, 0))]
    pigments = any(c.head.startswith("pigment") for c in colours)
    if pigments:
        colours = [c if c.head.startswith("pigment") else block("pigment", c) for c in colours]
    if word == "object":
        colours = (colours + [leaf("rgb x"), leaf("rgb y")] if not pigments else colours * 2)[:2]
    listed = group(*[Node("", [c], "," if i + 1 < len(colours) else "") for i, c in enumerate(colours)])
    extra = g.maybe(0.4, f"brick_size <{g.positive()},{g.positive()},{g.positive()}>") + g.maybe(0.4, f"mortar {g.number(0.05, 0.3)}") if word == "brick" else []
    return Node("", [need(head), listed, leaf(tail), *extra, *pattern_modifiers(g)], feature=word)


PICTURES = ['png "rgb.png"', 'png "rgba.png"', 'png "grey.png"', 'png "greya.png"', 'png "grey16.png"', 'png "rgb16.png"', 'png "linear.png"', 'png "g22.png"', 'png "srgb.png"', 'png "index.png"', 'png "indext.png"',
            'ppm "rgb.ppm"', 'pgm "grey.pgm"', 'tga "rgba.tga"', 'bmp "rgb.bmp"', '"rgb.png"', '"rgb.ppm"']


def picture(g: Grammar) -> list[Node]:
    """Returns the inside of an image_map, image_pattern or bump_map."""
    made = [need(g.rng.choice(PICTURES) + (f" gamma {g.pick('1', '2.2', 'srgb', '1.8')}" if g.flip(0.08, "gamma") else "") + g.pick("", "", "", "", " premultiplied on", " premultiplied off"))]
    made += g.maybe(0.5, f"map_type {g.pick('0', '1', '2', '5')}", "map_type") + g.maybe(0.4, f"interpolate {g.pick('2', '4', '2')}", "interpolate") + g.maybe(0.25, "once", "once")
    return made


@production("pigment body", "pigment", 1.2)
def image_map(g):
    made = picture(g)
    made += g.maybe(0.2, f"{g.pick('filter', 'transmit')} {g.pick('2, .7', '0 .9') if 'index' in made[0].head else 'all .5'}", "picture filter")
    return group(block("image_map", *made), *[g.make("transform") for _ in g.some(0, 1)], *g.maybe(0.3, "translate -.5 scale 2"))


@production("pigment body", "pigment", 0.5, nested=True)
def average_pigment(g):
    return group(need("average"), block("pigment_map", *entries(g, "pigment body"), keep=True))


@production("pigment body", "pigment", 0.6)
def declared_pigment(g):
    name = g.name("pigment")
    return group(need(name), *[g.make("transform") for _ in g.some(0, 2)], *([leaf(f"turbulence {g.unit()}")] if g.rng.random() < 0.2 else [])) if name else g.make("colour")


# Patterns

PLAIN = ["agate", "boxed", "bozo", "bumps", "cells", "cylindrical", "dents", "granite", "leopard", "marble", "onion", "planar", "radial", "ripples", "spherical", "spotted", "waves", "wood", "wrinkles", "crackle"]


@production("pattern", "pattern", 6)
def plain_pattern(g):
    word = g.rng.choice(PLAIN)
    return need(word, feature=word)


def pattern(weight: float = 1.0):
    """Registers a function that returns the text of a pattern."""

    def register(make):
        def whole(g):
            return need(make(g))

        whole.__name__ = make.__name__
        return production("pattern", "pattern", weight)(whole)

    return register


@pattern(2)
def gradient(g):
    return f"gradient {g.direction()}"


@pattern()
def agate_turb(g):
    return f"agate agate_turb {g.number(0, 2)}"


@pattern(2)
def crackle(g):
    return "crackle" + g.pick("", f" form {g.vector(-1, 1)}", " solid", f" metric {g.pick('1', '3', '2.5')}", f" offset {g.unit()}", " form <1,1,0> metric 1")


@pattern()
def quilted(g):
    return f"quilted control0 {g.unit()} control1 {g.unit()}"


@pattern()
def slope(g):
    return g.pick(f"slope {g.direction()}", f"slope {{ {g.direction()}, 0, .8 }}", f"slope {{ {g.direction()} altitude {g.direction()} }}", f"slope {{ {g.direction()}, .2, .9 altitude y, -1, 1 }}", "slope { point_at <2,3,-1> }")


@pattern(0.6)
def aoi(g):
    return "aoi"


@pattern(1.5)
def fractal(g):
    kind = g.pick(f"mandel {g.integer(1, 30)}", f"julia <{g.number(-1, 1)},{g.number(-1, 1)}>, {g.integer(1, 30)}", f"magnet 1 mandel {g.integer(2, 20)}", f"magnet 2 mandel {g.integer(2, 20)}", f"magnet 1 julia <.2,.4>, {g.integer(2, 20)}", f"magnet 2 julia <{g.number(-1, 1)},.4>, 9")
    return kind + g.pick("", "", f" exponent {g.integer(2, 6)}" if not kind.startswith("magnet") else "") + g.pick("", f" exterior {g.integer(0, 8)}, {g.number(0, 2)}") + g.pick("", f" interior {g.integer(0, 6)}, {g.number(0, 2)}")


@pattern(1.5)
def function_pattern(g):
    return "function { " + g.pick("x*x+y*y", "sin(3*x)*.5+y", "mod(x*3,1)", "f_noise3d(x*3,y*3,z*3)", "atan2(y,x)/pi", "select(x-y,0,.5,1)", "x", "-y", "abs(x)+floor(z*3)*.3", "min(x,y,z)", "f_sphere(x,y,z,.5)", "pow(abs(x),y)", "f_ridged_mf(x,y,z,.1,2,6,.7,.7,2)", "x/(y*y)",
                                  *(["Fun1(x,y,z)"] if "Fun1" in g.names.get("function", []) else [])) + " }"


@pattern()
def pigment_pattern(g):
    return f"pigment_pattern {{ {g.pick('bozo', 'gradient x', 'checker', 'marble turbulence .5', 'wood')} {g.pick('', 'color_map { [0 rgb <.2,.4,.9>] [1 rgb <1,.3,0>] }', 'scale .5')} }}"


@production("pattern", "pattern")
def image_pattern(g):
    return block("image_pattern", *picture(g), *g.maybe(0.2, "use_alpha"), keep=True)


@pattern()
def spiral(g):
    return f"spiral{g.pick(1, 2)} {g.integer(1, 6)}"


@pattern()
def tiling(g):
    return f"tiling {g.integer(1, 24)}"


@pattern()
def pavement(g):
    return f"pavement number_of_sides {g.pick('3', '4', '6')} number_of_tiles {g.integer(1, 4)} pattern 1 exterior {g.pick('0', '1', '2')} interior {g.pick('0', '1', '2')} form {g.pick('0', '1', '2')}"


@pattern(0.7)
def density_file(g):
    return f'density_file df3 "cube.df3" interpolate {g.pick(0, 1, 2)}'


def pattern_modifiers(g: Grammar) -> list[Node]:
    """Returns what may follow a pattern: waves, turbulence, warps, transformations."""
    made = []
    for _ in g.some(0, 3 if g.in_focus("pattern", "warp") else 1):
        made.append(g.make("pattern modifier"))
    return made


@production("pattern modifier", "pattern", 1.5)
def wave(g):
    return leaf(g.pick("ramp_wave", "triangle_wave", "sine_wave", "scallop_wave", "cubic_wave", f"poly_wave {g.pick('', '2', '.5')}"))


@production("pattern modifier", "pattern", 1.5)
def frequency(g):
    return leaf(g.pick(f"frequency {g.number(-3, 5)}", f"phase {g.number(-1, 1)}"))


@production("pattern modifier", "pattern", 2)
def turbulence(g):
    return leaf(f"turbulence {g.pick(g.unit(), g.vector(0, 1), '0')}" + g.pick("", f" octaves {g.integer(1, 8)}") + g.pick("", f" omega {g.number(0, 1)}") + g.pick("", f" lambda {g.number(1, 3)}"))


@production("pattern modifier", "pattern", 0.7)
def noise_generator(g):
    return leaf(f"noise_generator {g.pick(1, 2, 3)}")


@production("pattern modifier", "pattern", 4)
def pattern_transform(g):
    return g.make("transform")


@production("pattern modifier", "warp", 2)
def warp(g):
    return leaf("warp { " + g.pick(f"repeat {g.pick('x', 'y', 'z', '.5*x', '2*z')} {g.pick('', 'flip x', 'flip <1,1,0>', 'offset <0,.3,.2>')}",
                                   f"black_hole {g.vector(-0.5, 0.5)}, {g.positive(1)} {g.pick('', 'inverse')} {g.pick('', 'falloff 2')} {g.pick('', 'strength .6')} {g.pick('', 'repeat <1,1,1>')} {g.pick('', 'turbulence <.2,.3,.1>')}",
                                   f"turbulence {g.unit()} {g.pick('', 'octaves 3')} {g.pick('', 'lambda 2.5 omega .3')}", f"cylindrical {g.pick('', 'orientation z', 'dist_exp 1')}", f"spherical {g.pick('', 'orientation x', 'dist_exp .5')}",
                                   f"toroidal {g.pick('', 'orientation y', 'major_radius .7', 'dist_exp 1')}", f"planar {g.pick('', 'x, .3', '<1,1,0>, 0')}") + " }")


# Normals


@production("normal", "normal")
def normal_block(g):
    return block("normal", g.make("normal body"), feature="normal")


@production("normal body", "normal", 4)
def bumpy(g):
    word = g.pick("bumps", "dents", "ripples", "waves", "wrinkles", "granite", "agate", "marble", "wood", "leopard", "onion", "quilted", "crackle", "bozo", "spotted", "radial", "boxed", "spherical", "gradient x", "cells", "checker", "brick", "hexagon", "function { sin(9*x)*y }", "cylindrical")
    return group(need(f"{word} {g.pick('', g.unit(), g.number(-2, 3))}", feature=word.split()[0]), *normal_modifiers(g))


@production("normal body", "normal")
def facets(g):
    return group(need(f"facets {g.pick('coords 1', 'coords .3', 'size .5', 'size 1')}"), *normal_modifiers(g))


@production("normal body", "normal")
def bump_map(g):
    return group(block("bump_map", *picture(g), *g.maybe(0.5, f"bump_size {g.number(-3, 5)}"), keep=True), *normal_modifiers(g))


@production("normal body", "normal", 1.5)
def slope_map(g):
    return group(g.make("pattern"), block("slope_map", need("[0 <0,1>]"), leaf("[.3 <1,0>]"), leaf(f"[.7 <{g.unit()},{g.number(-1, 1)}>]"), leaf("[1 <0,-1>]")), *normal_modifiers(g))


@production("normal body", "normal", 1.2, nested=True)
def normal_map(g):
    return group(g.make("pattern"), block("normal_map", *entries(g, "normal body"), keep=True), *normal_modifiers(g))


@production("normal body", "normal", 0.6, nested=True)
def average_normal(g):
    return group(need("average"), block("normal_map", *entries(g, "normal body"), keep=True), *normal_modifiers(g))


@production("normal body", "normal", 0.5)
def declared_normal(g):
    name = g.name("normal")
    return group(need(name), *normal_modifiers(g)) if name else need("bumps .6")


def normal_modifiers(g: Grammar) -> list[Node]:
    """Returns what may follow a normal."""
    return pattern_modifiers(g) + g.maybe(0.1, f"bump_size {g.number(-2, 3)}", "bump_size") + g.maybe(0.1, "no_bump_scale", "no_bump_scale") + g.maybe(0.1, f"accuracy {g.pick('.001', '.1', '.02')}") + g.maybe(0.3, "scale .3")


# Finishes

FINISH = {
    "ambient": lambda g: g.pick(f"ambient {g.unit()}", f"ambient {g.rgb()}"), "emission": lambda g: f"emission {g.pick(g.unit(), g.rgb())}",
    "diffuse": lambda g: g.pick(f"diffuse {g.unit()}", f"diffuse {g.unit()}, {g.unit()}", "diffuse albedo .7"), "brilliance": lambda g: f"brilliance {g.number(0, 3)}",
    "phong": lambda g: f"phong {g.pick(g.unit(), 'albedo .4')} phong_size {g.pick('1', '10', '60')}", "specular": lambda g: f"specular {g.pick(g.unit(), 'albedo .5')} roughness {g.pick('.1', '.02', '.5')}",
    "metallic": lambda g: f"metallic {g.pick('', g.unit())}", "reflection": lambda g: f"reflection {g.pick(g.unit(), g.rgb())}",
    "reflection_block": lambda g: f"reflection {{ {g.pick(g.unit(), g.rgb() + ', ' + g.rgb(), '0, 1')} {g.pick('', 'fresnel', 'fresnel on')} {g.pick('', 'falloff 3')} {g.pick('', 'exponent .7')} {g.pick('', 'metallic', 'metallic .5')} }}",
    "conserve_energy": lambda g: "conserve_energy", "irid": lambda g: f"irid {{ {g.unit()} thickness {g.unit()} turbulence {g.pick('0', '.5')} }}", "refraction": lambda g: "refraction 1", "ior": lambda g: f"ior {g.number(1, 2)}",
    "use_alpha": lambda g: "reflection_exponent .8", "fade": lambda g: f"fade_power 2 fade_distance {g.positive()}",
}


@production("finish", "finish")
def finish(g):
    if (name := g.name("finish")) and g.rng.random() < 0.2:
        return block("finish", need(name), *g.maybe(0.5, f"ambient {g.unit()}"))
    old = ["refraction", "ior", "fade"]
    words = [w for w in FINISH if w not in old or g.flip(0.1, "legacy")]
    chosen = g.rng.sample(words, g.rng.randint(1, min(5 if g.in_focus("finish") else 2, len(words))))
    return block("finish", *[leaf(FINISH[w](g), feature="finish " + w) for w in chosen])


# Textures


@production("texture body", "texture", 5)
def plain_texture(g):
    made = [block("pigment", g.make("pigment body"))]
    if g.flip(0.3, "normal", "texture"):
        made.append(g.make("normal"))
    if g.flip(0.4, "finish"):
        made.append(g.make("finish"))
    for _ in g.some(0, 1):
        made.append(g.make("transform"))
    return group(*made)


@production("layer", "texture")
def layer(g):
    see_through = g.pick("rgbt <1,.2,.1,.5>", "rgbf <.2,.8,.3,.6>", "checker rgbt 1, rgb <.1,.2,.9> scale .4", "bozo color_map { [.4 rgbt 1] [.5 rgb <1,1,0>] } scale .3", "gradient y color_map { [0 rgb x transmit .2] [1 rgbft <0,1,0,.5,.5>] }")
    return group(leaf(f"pigment {{ {see_through} }}"), *([g.make("finish")] if g.rng.random() < 0.4 else []), *g.maybe(0.2, "normal { bumps .5 scale .2 }"))


@production("texture body", "texture", 2, nested=True)
def texture_map(g):
    return group(g.make("pattern"), block("texture_map", *entries(g, "texture body"), keep=True), *pattern_modifiers(g))


@production("texture body", "texture", 1, nested=True)
def listed_texture(g):
    word, n = g.pick(("checker", 2), ("brick", 2), ("hexagon", 3), ("cubic", 6), ("square", 4), ("triangular", 6))
    textures = [block("texture", g.make("texture body"), feature="listed") for _ in range(2)]
    while len(textures) < n:
        textures.append(block("texture", leaf(f"pigment {{ {g.rgb()} }}")))
    return Node("", [need(word), *[Node("", [t], "," if i + 1 < n else "", keep=True) for i, t in enumerate(textures)], *pattern_modifiers(g)], feature=word + " of textures")


@production("texture body", "texture", 0.5, nested=True)
def material_map(g):
    return group(block("material_map", *picture(g), block("texture", g.make("texture body")), block("texture", g.make("texture body")), leaf("texture { pigment { rgb x } }"), leaf("texture { pigment { rgb y } }"), keep=True), *g.maybe(0.3, "scale 2"))


@production("texture body", "texture", 0.5, nested=True)
def average_texture(g):
    return group(need("average"), block("texture_map", *entries(g, "texture body"), keep=True))


@production("texture body", "texture", 0.8)
def declared_texture(g):
    name = g.name("texture")
    return group(need(name), *[g.make("transform") for _ in g.some(0, 2)], *g.maybe(0.3, f"pigment {{ {g.rgb()} }}"), *g.maybe(0.2, "finish { phong .5 }")) if name else leaf(f"pigment {{ {g.rgb()} }}")


# Interiors


@production("interior", "interior")
def interior(g):
    made = g.maybe(0.8, f"ior {g.number(0.7, 2.2)}", "interior ior") + g.maybe(0.4, f"fade_power {g.pick('1', '2', '1000', '1001')}", "fade_power") + g.maybe(0.4, f"fade_distance {g.positive()}") + g.maybe(0.3, f"fade_color {g.rgb()}", "fade_color")
    made += g.maybe(0.25, f"caustics {g.unit()}", "caustics") + g.maybe(0.15, f"dispersion {g.number(1, 1.2)} dispersion_samples {g.integer(2, 7)}", "dispersion")
    if (name := g.name("interior")) and g.rng.random() < 0.2:
        made.insert(0, need(name))
    return block("interior", *made)
