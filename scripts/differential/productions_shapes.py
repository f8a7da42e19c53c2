"""Shapes: every kind of object, with parameters that are legal and now and then degenerate."""

from __future__ import annotations

from grammar import Grammar, production, simplest
from tree import Node, block, group, leaf, need

simplest("object", lambda: block("sphere", need("0, 1"), leaf("pigment { rgb .8 }")))


def modifiers(g: Grammar) -> list[Node]:
    """Returns what may follow the parameters of any object: look, movement, flags, clips and bounds."""
    made = [g.make("look")] if g.depth < 3 or g.flip(0.3, "texture") else []
    for _ in g.some(0, 3 if g.in_focus("transform") else 1):
        made.insert(g.rng.randint(0, len(made)), g.make("transform"))
    if g.flip(0.15, "flags"):
        made.append(g.make("flag"))
    if g.depth < 4 and g.flip(0.06, "csg"):
        made.insert(g.rng.randint(0, len(made)), g.make("clip"))
    return made


def shape(word: str):
    """Registers a function that returns the parameters of a shape as nodes; modifiers follow by themselves."""

    def register(make):
        def whole(g: Grammar) -> Node:
            return block(word, *make(g), *modifiers(g))

        whole.__name__ = make.__name__
        production("object", "shape", WEIGHTS.get(word, 1.0))(whole)
        return whole

    return register


WEIGHTS = {"sphere": 4, "box": 4, "cylinder": 2.5, "cone": 2, "plane": 1.5, "torus": 2, "text": 0.6, "isosurface": 1.2,
           "parametric": 0.3, "julia_fractal": 0.6, "bicubic_patch": 0.7}


@shape("sphere")
def sphere(g):
    return [need(f"{g.vector(-1, 1)}, {g.positive()}")]


@shape("box")
def box(g):
    return [need(g.pick("-1, 1", f"{g.vector(-1.5, 0)}, {g.vector(0, 1.5)}", "<-1,-1,-1>, <1,.5,1>", f"{g.vector(-1, 1)}, {g.vector(-1, 1)}"))]


@shape("cylinder")
def cylinder(g):
    ends = g.pick(f"{g.vector(-1, 0)}, {g.direction()}", "-y, y", "0, x", "<0,-1,0>, <0,.5,0>")
    return [need(f"{ends}, {g.positive(1)}"), *g.maybe(0.3, "open", "open")]


@shape("cone")
def cone(g):
    radii = g.pick((g.positive(1), "0"), ("0", g.positive(1)), (g.positive(1), g.positive(1)), (".5", ".5"))
    return [need(f"<0,-1,0>, {radii[0]}, {g.pick('y', '<.5,1,0>', '<0,.5,.5>')}, {radii[1]}"), *g.maybe(0.3, "open", "open")]


@shape("torus")
def torus(g):
    return [need(f"{g.positive(1.2)}, {g.number(0.1, 0.8)}"), *g.maybe(0.1, "sturm")]


@shape("plane")
def plane(g):
    return [need(g.pick("y, -1", "z, 3", f"{g.direction()}, {g.number(-2, 1)}", "-y, 1"))]


@shape("disc")
def disc(g):
    return [need(f"{g.vector(-1, 1)}, {g.direction()}, {g.positive()}{g.pick('', '', ', .4', ', 0')}")]


@shape("triangle")
def triangle(g):
    return [need(f"{g.vector(-1.5, 0)}, {g.vector(0, 1.5)}, <-1,1,.5>")]


@shape("smooth_triangle")
def smooth_triangle(g):
    return [need(f"<-1,-1,0>, {g.direction()}, <1,-1,0>, {g.direction()}, <0,1,.5>, {g.direction()}")]


@shape("polygon")
def polygon(g):
    outer = "<-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>"
    return [need(g.pick(f"5, {outer}", f"10, {outer}, <-.5,-.5>, <.5,-.5>, <.5,.5>, <-.5,.5>, <-.5,-.5>",
                        "6, <0,0>, <1,0>, <1,1>, <.5,.3>, <0,1>, <0,0>", "4, <0,0,0>, <1,0,1>, <0,1,.5>, <0,0,0>",
                        "11, <-1,-1>, <1,1>, <1,-1>, <-1,1>, <-1,-1>, <0,.9>, <.5,.5>, <.2,-.9>, <-.7,.1>, <.9,.1>, <0,.9>"))]


@shape("mesh")
def mesh(g):
    tex = g.flip(0.4, "texture")
    made = []
    for _ in g.some(1, 4):
        uv = " uv_vectors <0,0>,<1,0>,<.5,1>" if g.rng.random() < 0.4 else ""
        t = " texture { Tex1 }" if tex and g.name("texture") else ""
        made.append(leaf(f"triangle {{ {g.vector(-1.5, 1.5)}, {g.vector(-1.5, 1.5)}, {g.vector(-1, 1)}{uv}{t} }}"))
    made[0].keep = True
    if g.rng.random() < 0.4:
        made.append(leaf(f"smooth_triangle {{ <-1,-1,0>, {g.direction()}, <1,-1,0>, {g.direction()}, <0,1,.5>, {g.direction()} }}"))
    return made + g.maybe(0.3, f"inside_vector {g.direction()}", "inside_vector") + g.maybe(0.1, "hierarchy off")


@shape("mesh2")
def mesh2(g):
    parts = [need("vertex_vectors { 5, <-1,-1,-1>, <1,-1,-1>, <1,-1,1>, <-1,-1,1>, <0,1,0> }")]
    if g.rng.random() < 0.4:
        parts.append(leaf(f"normal_vectors {{ 5, <-1,-1,-1>, <1,-1,-1>, <1,-1,1>, <-1,-1,1>, {g.direction()} }}"))
    if g.rng.random() < 0.4:
        parts.append(leaf("uv_vectors { 5, <0,0>, <1,0>, <1,1>, <0,1>, <.5,.5> }"))
    listed = g.name("texture") and g.flip(0.3, "texture")
    if listed:
        parts.append(need("texture_list { 2, texture { Tex1 }, texture { pigment { rgb x } } }", feature="texture_list"))
        faces = g.pick("<0,1,4>,0, <1,2,4>,1, <2,3,4>,0, <3,0,4>,1, <0,1,2>,0,1,1, <0,2,3>,0", "<0,1,4>,0,1,0, <1,2,4>,1, <2,3,4>,0, <3,0,4>,1,1,0, <0,1,2>,0, <0,2,3>,1")
    else:
        faces = "<0,1,4>, <1,2,4>, <2,3,4>, <3,0,4>, <0,1,2>, <0,2,3>"
    return parts + [need(f"face_indices {{ 6, {faces} }}")] + g.maybe(0.4, f"inside_vector {g.direction()}", "inside_vector")


@shape("bicubic_patch")
def bicubic_patch(g):
    rows = [f"<{x - 1.5:g},{g.number(-1, 1)},{y - 1.5:g}>" for y in range(4) for x in range(4)]
    kind = g.pick("type 0 ", "type 1 ")
    return [need(f"{kind}flatness {g.pick('0', '.01', '.1')} u_steps {g.integer(0, 4)} v_steps {g.integer(1, 4)}"),
            *g.maybe(0.3, "uv_vectors <0,0>,<1,0>,<1,1>,<0,1>"), need(", ".join(rows))]


@shape("blob")
def blob(g):
    made = [leaf(f"threshold {g.pick('.6', '.3', '.01', '1')}")]
    for _ in g.some(1, 4):
        moved = g.pick("", "", f" rotate {g.vector(-90, 90)}", f" scale {g.pick('<1,.5,1>', '2')}", f" pigment {{ {g.rgb()} }}")
        strength = g.pick("1", "2", f"strength {g.number(-2, 3)}")
        kind = g.rng.random() < 0.6
        made.append(leaf(f"sphere {{ {g.vector(-1, 1)}, {g.positive()}, {strength}{moved} }}" if kind else
                         f"cylinder {{ {g.vector(-1, 0)}, {g.direction()}, {g.positive(1)}, {strength}{moved} }}"))
    return made + g.maybe(0.1, "sturm") + g.maybe(0.1, "hierarchy off")


@shape("height_field")
def height_field(g):
    what = g.pick('png "grey.png"', 'png "grey16.png"', 'pgm "grey.pgm"', 'png "rgb.png"', 'png "index.png"', 'tga "rgba.tga"',
                  "function 12, 9 { .5+.4*sin(9*x)*cos(7*y) }", "function 5, 5 { pattern { bozo scale .3 } }")
    return [need(what), *g.maybe(0.4, "smooth", "smooth"), *g.maybe(0.3, f"water_level {g.unit()}", "water_level"), *g.maybe(0.1, "gamma 2.2"),
            leaf("translate <-.5,0,-.5> scale <3,1,3>")]


@shape("isosurface")
def isosurface(g):
    body = g.pick("x*x+y*y+z*z-.8", f"f_sphere(x,y,z,.8)+{g.number(0, 0.3)}*sin(9*x)*sin(8*y)", "f_torus(x,y,z,.7,.3)",
                  "f_rounded_box(x,y,z,.2,.8,.6,.7)", "abs(x)+abs(y)+abs(z)-1", "max(abs(x),abs(y),abs(z))-.7", "y-.3*sin(3*x)*z",
                  "f_heart(x,z,y,-1)", "f_noise3d(x*2,y*2,z*2)-.5", "min(f_sphere(x-.4,y,z,.6),f_sphere(x+.4,y,z,.6))", "x*y*z-.05", "f_ridged_mf(x,y,z,.1,3,6,.7,.7,2)-.6")
    used = group(need(f"function {{ {body} }}"), need(f"max_gradient {g.pick('4', '10')}"), keep=True)
    used.children += [leaf(g.pick("contained_by { box { -1, 1 } }", "contained_by { sphere { 0, 1.2 } }", "contained_by { box { <-1,-.5,-1>, <1,.6,.8> } }")),
                      leaf("accuracy .0005")]
    return [used, *g.maybe(0.3, "all_intersections", "all_intersections"), *g.maybe(0.15, "max_trace 3"), *g.maybe(0.4, "open", "open"), *g.maybe(0.1, "threshold .1"),
            *g.maybe(0.08, "evaluate 2, 1.2, .99")]


@shape("julia_fractal")
def julia_fractal(g):
    kind = g.pick("quaternion sqr", "quaternion cube", "hypercomplex sqr", "hypercomplex exp", "hypercomplex sin", "hypercomplex reciprocal", "hypercomplex pwr(3,0)")
    return [need(f"<{g.number(-0.5, 0.5)},{g.number(-0.5, 0.6)},{g.number(-0.4, 0.4)},{g.number(-0.3, 0.3)}> {kind}"),
            leaf(f"max_iteration {g.integer(3, 7)}"), leaf("precision 20"), *g.maybe(0.3, f"slice <0,{g.number(-0.4, 0.4)},0,1>, {g.number(-0.2, 0.2)}", "slice")]


POINTS = ["<.3,-1>, <.8,-.5>, <.4,0>, <.9,.5>, <.2,1>", "<0,-1>, <1,-1>, <.5,0>, <1,1>, <0,1>", "<.5,-1>, <1,0>, <.5,1>, <.5,-1>", "<0,-1>, <.7,-.6>, <.7,.3>, <0,1>"]


@shape("lathe")
def lathe(g):
    kind = g.pick("linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline", "")
    points = "<.2,-1>, <1,-.7>, <.6,0>, <.3,.2>, <.3,.2>, <.2,.5>, <.9,.8>, <.2,1>" if kind.startswith("bez") else g.pick(*POINTS)
    return [need(f"{kind} {points.count('<')}, {points}"), *g.maybe(0.2, "sturm")]


@shape("sor")
def sor(g):
    points = g.pick("<.2,-1.2>, <.3,-1>, <.8,-.3>, <.4,.4>, <.7,1>, <.6,1.2>", "<0,-1>, <.5,-.9>, <.9,0>, <.1,.9>, <0,1>", "<1,-1>, <1,-.5>, <1,.5>, <1,1>")
    return [need(f"{points.count('<')}, {points}"), *g.maybe(0.3, "open", "open"), *g.maybe(0.2, "sturm")]


@shape("prism")
def prism(g):
    square = "<-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>"
    kind, points = g.pick(("linear_spline", square), ("linear_spline", square + ", <-.5,-.5>, <.5,-.5>, <0,.5>, <-.5,-.5>"),
                          ("quadratic_spline", "<-1,-1>, <.5,-1>, <1,.4>, <0,1>, <-1,.2>, <.5,-1>"), ("cubic_spline", "<-1,0>, <0,-1>, <1,0>, <.3,1>, <-1,0>, <0,-1>, <1,0>"),
                          ("bezier_spline", "<-1,-1>, <-1,.5>, <0,1.5>, <1,1>, <1,1>, <1,-.2>, <0,-1.5>, <-1,-1>"))
    sweep = g.pick("linear_sweep", "linear_sweep", "conic_sweep", "")
    heights = g.pick("0, 1", "-1, .5") if sweep == "conic_sweep" else g.pick("-.5, .5", "0, 1", "1, 0", f"{g.number(-1, 0)}, {g.number(0, 1)}")
    return [need(f"{kind} {sweep} {heights}, {points.count('<')}, {points}"), *g.maybe(0.25, "open", "open"), *g.maybe(0.1, "sturm")]


@shape("sphere_sweep")
def sphere_sweep(g):
    kind, n = g.pick(("linear_spline", 3), ("b_spline", 5), ("cubic_spline", 5), ("linear_spline", 2))
    points = ", ".join(f"<{2 * i / (n - 1) - 1:.2g},{g.number(-1, 1)},{g.number(-0.5, 0.5)}>, {g.number(0.1, 0.5)}" for i in range(n))
    return [need(f"{kind} {n}, {points}"), *g.maybe(0.3, "tolerance .0001")]


@shape("ovus")
def ovus(g):
    return [need(f"{g.positive(1)}, {g.positive(1)}")]


@shape("superellipsoid")
def superellipsoid(g):
    return [need(f"<{g.pick('1', '.2', '2', g.number(0.2, 2))},{g.pick('1', '.3', '2', g.number(0.2, 2))}>")]


@shape("quadric")
def quadric(g):
    return [need(g.pick("<1,1,1>,<0,0,0>,<0,0,0>,-1", "<1,0,1>,0,0,-.5", "<1,-1,1>,0,0,-.1", "<1,0,1>,0,<0,-1,0>,-.5", f"{g.vector(-1, 1)},{g.vector(-1, 1)},{g.vector(-1, 1)},{g.number(-1, 1)}")),
            *g.maybe(0.7, "clipped_by { box { -1.5, 1.5 } }")]


@shape("cubic")
def cubic(g):
    return [need("<" + ",".join(g.pick("0", "0", g.number(-1, 1)) for _ in range(20)) + ">"), leaf("clipped_by { box { -1.5, 1.5 } }"), *g.maybe(0.3, "sturm")]


@shape("quartic")
def quartic(g):
    middle = ",".join(g.pick("0", "0", "0", g.number(-1, 1)) for _ in range(33))
    return [need(g.pick(f"<1,{middle},{g.number(-1, 0)}>", "<1,0,0,0,2,0,0,2,0,-1.2,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,.8,0,0,0,0,1,0,-1.2,0,.2>")), leaf("clipped_by { box { -1.5, 1.5 } }"), *g.maybe(0.5, "sturm")]


@shape("poly")
def poly(g):
    order, n = g.pick((2, 10), (3, 20), (5, 56), (6, 84))
    terms = ["0"] * n
    for i in (0, n - 1, n - 4, n - 6, n // 2, n // 3):
        terms[i] = g.number(-1, 1)
    return [need(f"{order}, <{','.join(terms)}>"), leaf("clipped_by { box { -1.5, 1.5 } }"), *g.maybe(0.5, "sturm")]


@shape("text")
def text(g):
    font = g.pick('"timrom.ttf"', '"cyrvetic.ttf"', "internal 1", '"crystal.ttf"', "internal 2")
    kind = "" if font.startswith("internal") else "ttf "
    if font.startswith("internal"):
        return [need(f'{font} "{g.pick("Ab", "fi8", "x", "O&g")}", {g.number(0.1, 0.6)}, {g.pick("0", ".1*x", "<.1,.2,0>")}'), leaf("translate <-.5,-.3,0>")]
    return [need(f'{kind}{font} "{g.pick("Ab", "fi8", "x", "O&g", "i j")}", {g.number(0.1, 0.6)}, {g.pick("0", ".1*x", "<.1,.2,0>")}'), leaf("translate <-.5,-.3,0>")]


@shape("parametric")
def parametric(g):
    body = g.pick("function { sin(u)*cos(v) }, function { sin(v) }, function { cos(u)*cos(v) }", "function { u/3 }, function { .3*sin(u)*v }, function { v }")
    return [need(f"{body} <-3.1,-1.5>, <3.1,1.5>"), need("contained_by { sphere { 0, 1.6 } }"), leaf("max_gradient 2"), leaf("accuracy .002"), *g.maybe(0.3, "precompute 6, x, y, z")]


# What follows the parameters


@production("transform", "transform", 3)
def translate(g):
    return leaf(f"translate {g.vector(-1, 1)}")


@production("transform", "transform", 3)
def rotate(g):
    return leaf(f"rotate {g.pick(g.vector(-90, 90), '90*y', '<0,45,0>', '180*x', '<-90,0,0>')}")


@production("transform", "transform", 2)
def scale(g):
    return leaf(f"scale {g.pick('.5', '<1,.5,1>', '<-1,1,1>', '<1,0,1>', g.number(0.3, 2), f'<{g.positive()},{g.positive()},{g.positive()}>', '-1', '0.001', '100')}")


@production("transform", "transform")
def matrix(g):
    return leaf(g.pick("matrix <1,0,0, .5,1,0, 0,0,1, 0,0,0>", "matrix <0,1,0, 1,0,0, 0,0,1, .3,0,0>", f"matrix <1,{g.number(-0.5, 0.5)},0, 0,1,0, {g.number(-0.5, 0.5)},0,1, {g.number(-1, 1)},0,0>"))


@production("transform", "transform")
def transform_block(g):
    name = g.name("transform")
    if name and g.rng.random() < 0.6:
        return leaf(g.pick(f"transform {{ {name} }}", f"transform {name}", f"transform {{ {name} inverse }}", f"transform {{ rotate 30 transform {{ {name} }} translate .2*x inverse }}"))
    return leaf(f"transform {{ rotate {g.vector(-45, 45)} translate {g.vector(-0.5, 0.5)} {g.pick('', 'inverse')} }}")


@production("flag", "flags")
def flag(g):
    word = g.pick("hollow", "no_shadow", "no_image", "no_reflection", "inverse", "double_illuminate", "hollow off", "no_radiosity", "inverse inverse")
    return leaf(word, feature=word)


@production("clip", "csg")
def clip(g):
    kind = g.pick("clipped_by", "clipped_by", "bounded_by")
    what = g.pick("box { -.6, .7 }", "plane { y, .2 }", "plane { x, 0 } plane { y, 0 inverse }", "sphere { <.5,0,0>, 1 }", "sphere { 0, .9 inverse }", "cylinder { -y, y, .6 }")
    if kind == "bounded_by":
        what = g.pick("box { -2, 2 }", "sphere { 0, 2 }", "clipped_by", "sphere { 0, 1 }", "plane { y, .5 }")
    elif g.rng.random() < 0.3:
        return block(kind, g.make("object"), *g.maybe(0.2, "translate .3*y"), feature=kind)
    return leaf(f"{kind} {{ {what} }}", feature=kind)


# Solids made of others


def csg(word: str, weight: float):
    """Registers union, merge, intersection or difference."""

    def make(g: Grammar) -> Node:
        parts = [g.make("tied pair")] if g.rng.random() < 0.25 else []
        parts += [g.make("object") for _ in g.some(1, 3)]
        if parts:
            parts[0].keep = False
        extra = g.maybe(0.3, "cutaway_textures", "cutaway_textures") if word in ("difference", "intersection") else []
        split = g.maybe(0.1, g.pick("split_union off", "split_union on")) if word == "union" else []
        return block(word, *parts, *extra, *split, *modifiers(g))

    make.__name__ = word
    production("object", "csg", weight, nested=True)(make)


for word, weight in (("union", 2.5), ("difference", 3), ("intersection", 2.5), ("merge", 2)):
    csg(word, weight)

TIES = ["box { -1, 1 {0} } box { <-1,-1,0>, <1,.5,2> {1} }", "sphere { 0, 1 {0} } sphere { 0, 1 {1} }", "plane { y, 0 {0} } box { -1, <1,0,1> {1} }",
        "cylinder { -y, y, .7 {0} } cylinder { <0,-.5,0>, y, .7 {1} }", "cylinder { 0, y, .7 {0} } box { <-1,0,-1>, <1,1,1> {1} }", "box { 0, 1 {0} } box { <1,0,0>, <2,1,1> {1} }",
        "plane { y, 0 {0} } plane { y, 0 inverse {1} }", "sphere { 0, 1 {0} } object { sphere { 0, 2 {1} } scale .5 }", "box { -1, 1 {0} } plane { x, 1 {1} }", "disc { 0, y, 1 {0} } plane { y, 0 {1} }",
        "cone { 0, 1, y, 0 {0} } plane { y, 0 {1} }", "torus { 1, .3 {0} } cylinder { <0,-.3,0>, <0,.3,0>, 1 {1} }"]


@production("tied pair", "csg")
def tied_pair(g):
    looks = [g.pick("", f"pigment {{ {g.rgb()} }}"), g.pick("", f"pigment {{ {g.rgb()} }}")]
    pair = g.rng.choice(TIES).replace("{0}", looks[0]).replace("{1}", looks[1])
    return leaf(pair)


@production("object", "csg", 1.2, nested=True)
def object_block(g):
    name = g.name("object")
    inner = need(name) if name and g.rng.random() < 0.7 else g.make("object")
    return block("object", inner, *modifiers(g))


@production("object", "flags", 0.6, nested=True)
def light_group(g):
    return block("light_group", leaf(f"light_source {{ {g.vector(-3, 3)}, {g.rgb()} }}"), g.make("object"), *g.maybe(0.5, f"global_lights {g.pick('on', 'off')}"), *g.maybe(0.3, f"translate {g.vector(-0.5, 0.5)}"))
