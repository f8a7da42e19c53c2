"""The language around scenes: expressions, functions, macros, loops, arrays, strings and splines."""

from __future__ import annotations

from grammar import Grammar, production
from tree import Node, block, group, leaf, need


def float_expression(g: Grammar, low: float, high: float) -> str | None:
    """Returns an expression in brackets whose value lies between the limits, or None."""
    target = g.rng.uniform(low, high)
    a, b = g.rng.uniform(0.2, 2), g.rng.uniform(0.1, 1.5)
    forms = [f"({target / a:.4g}*{a:.3g})", f"({target - b:.4g}+{b:.3g})", f"({target + b:.4g}-{b:.3g})", f"({target * a:.4g}/{a:.3g})", f"({b:.3g}>{a:.3g} ? {target:.3g} : {target * 0.9:.3g})",
             f'val("{target:.3g}")', f"<{a:.2g},{target:.3g},{b:.2g}>.y", f"vdot(<{target:.3g},{b:.2g},1>,x)", f"select({b - 1:.2g},{target:.3g},{(low + high) / 2:.3g})", f"({target:.3g}+0*sin({b:.3g}))", f"min({target:.3g},{high:.3g})",
             f"({target:.3g}+.1*mod({a:.3g},.3)*0)", f"max({low:.3g},{target:.3g})", f"({target:.3g}*(strlen(\"a{{b\")=3))", f"({target:.3g}+!{b:.2g})", f"({target - 1:.4g}+pow({a:.2g},0))",
             f"vlength(<{abs(target):.3g},0,0>)*{1 if target >= 0 else -1}", f"({target:.3g}+0*{b:.2g} & 1 ? {target:.3g} : 0)", f"abs({abs(target):.3g})*{1 if target >= 0 else -1}", f"({target:.3g}+(1 = 1)-(2 > 1))",
             f"({target:.4g}*asc(\"A\")/65)", f"vrotate(<{target:.3g},0,0>,360*y).x", f"({target:.3g}+int({b:.2g}/9))", f"div({target * 10:.0f},10)+0" if low < div10(target) < high else f"({target:.3g})"]
    if "Arr1" in g.names.get("array", []):
        forms += [f"({target:.3g}+Arr1[{g.rng.randint(0, 2)}]*.1)", f"({target - 0.3:.3g}+.1*dimension_size(Arr1,1))"]
    if "Fun1" in g.names.get("function", []):
        forms += [f"({target:.3g}+.1*Fun1(.3,{b:.2g},.7))"] * 2
    if "Spl1" in g.names.get("spline", []):
        forms += [f"({target:.3g}+.1*Spl1({b:.2g}).x)", f"({target:.3g}+.1*Spl1({-b:.2g}).y)"]
    if "Mac1" in g.names.get("macro", []):
        forms += [f"Mac1({target:.3g},{b:.2g})"] * 2
    return g.rng.choice(forms)


def div10(value: float) -> float:
    """Returns the value that `div` gives for ten times the value and ten."""
    return float(int(round(value * 10) / 10))


@production("prelude", "language", 2)
def array(g):
    g.declare("array", "Arr1")
    return leaf(g.pick("#declare Arr1 = array[3] { .2, .5, .9 }", "#declare Arr1 = array[3];\n#declare Arr1[0] = .3; #declare Arr1[1] = -.4; #declare Arr1[2] = 1;", "#declare Arr1 = array[3]\n#for (I,0,2) #declare Arr1[I] = I/3; #end"))


@production("prelude", "language", 2)
def spline(g):
    kind = g.pick("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline", "")
    made = leaf(f"#declare Spl1 = spline {{ {kind} -.5, <0,.2,1>, 0, {g.vector(-1, 1)}, .4, {g.vector(-1, 1)}, 1, <1,0,.5>, 1.7, {g.vector(-1, 1)} }}", feature=kind)
    g.declare("spline", "Spl1")
    return made


@production("prelude", "language", 2)
def macro(g):
    if g.version == "3.0":
        return g.make("prelude")
    g.declare("macro", "Mac1")
    return leaf(g.pick("#macro Mac1(A, B) (A+B*0) #end", "#macro Mac1(A, B) #local C = A; (C) #end", "#macro Mac1(A, B) #if (B > .5) A #else A*.9 #end #end", "#macro Mac1(A, B) #local I = 0; #while (I < 3) #local I = I+1; #end (A+I*.01) #end"))


@production("prelude", "language")
def several(g):
    return group(g.make("prelude"), g.make("prelude"))


@production("item", "language", 0.8)
def for_loop(g):
    last = g.rng.randint(2, 6)
    moved = g.pick("translate <Ci*.6-1,0,0>", "rotate y*Ci*60", "translate <cos(Ci),sin(Ci),0>", "translate x*.5*mod(Ci,3) translate y*int(Ci/3)", "scale 1-.1*Ci translate Ci*.3")
    inner = block("object", block("sphere", need(f"0, {g.number(0.2, 0.6)}")), leaf(g.pick("pigment { rgb <Ci/6,.5,1-Ci/6> }", "pigment { rgb 1 }")), leaf(moved))
    if g.rng.random() < 0.5:
        inner = block("object", g.make("object"), leaf("scale .4"), leaf(moved))
    head = g.pick(f"#for (Ci, 0, {last})", f"#for (Ci, {last}, 0, -1)", f"#declare Ci = 0; #while (Ci < {last})")
    step = [leaf("#declare Ci = Ci+1;", keep=True)] if "while" in head else []
    return Node(head, [inner, *step], "#end")


@production("item", "language", 0.6)
def conditional(g):
    test = g.pick("version >= 3.7", "version < 3.5", "defined(Foo)", "1 & 0", "!0", "strcmp(\"a\",\"b\") < 0", "0.1+0.2 = 0.3", "clock = 0", "version = 3.7", "x.x > .5")
    head = g.pick(f"#if ({test})", "#ifdef (Col1)", "#ifndef (Tex1)")
    return Node(head, [g.make("object"), Node("#else", [leaf(f"sphere {{ 0, .7 pigment {{ {g.rgb()} }} }}")])], "#end")


@production("item", "language", 0.5)
def switched(g):
    value = g.pick("1", "2.5", "version", "int(3.7)")
    return group(need(f"#switch ({value})"), Node("#case (1)", [g.make("object"), leaf("#break")]), Node("#range (2,3.5)", [g.make("object"), *g.maybe(0.6, "#break")]), Node("#else", [leaf("box { -.5, .5 pigment { rgb y } }")]), need("#end"))


@production("item", "language", 0.7)
def object_macro(g):
    if g.version == "3.0":
        return g.make("item")
    return group(Node("#macro Put(What, Where, Hue)", [leaf("object { What pigment { Hue } translate Where }", keep=True)], "#end", keep=True),
                 Node(f"Put(", [g.make("object"), leaf(f", {g.vector(-1, 1)}, {g.rgb()})", keep=True)]), leaf(f"Put(box {{ -.3, .3 }}, {g.vector(-1, 1)}, {g.pick('rgb x', 'rgb <.3,1,.5>', 'color rgbt <1,1,0,.3>')})"))


@production("item", "language", 0.5)
def redeclared(g):
    return group(Node("#declare Thing =", [g.make("object")], keep=True), block("object", need("Thing"), g.make("transform")), block("object", need("Thing"), g.make("look"), g.make("transform")))


@production("item", "language", 0.4)
def traced(g):
    return group(Node("#declare Target =", [g.make("object")], keep=True), need("#declare Norm = <0,0,0>;\n#declare Hit = trace(Target, <.1,.2,-5>, z, Norm);"), leaf("object { Target }"),
                 need(g.pick("sphere { Hit, .3 pigment { rgb abs(Norm) } }", "#if (vlength(Norm) != 0) cylinder { Hit, Hit+Norm, .1 pigment { rgb x } } #end",                              "box { min_extent(Target), max_extent(Target) pigment { rgbt <1,1,0,.6> } }")))


@production("item", "language", 0.3)
def numbers_shown(g):
    """Shows an expression's value as heights and colours, so that its figures are compared."""
    args = [g.rng.uniform(-2, 3) for _ in range(3)]
    text = g.pick("sin({0})*cos({1})", "pow(abs({0}),{1})", "mod({0},{1})", "atan2({0},{1})", "vlength(<{0},{1},{2}>)*.5", "vnormalize(<{0},{1},{2}>).y", "vcross(<{0},1,2>,<{1},{2},1>).z*.2", "vaxis_rotate(<{0},1,0>,y+x,{1}*50).x", "vturbulence(2,.5,6,<{0},{1},{2}>).x",
                  "int({0})+floor({1})*.5+ceil({2})*.3", "exp({0})*.1", "ln(abs({0})+.1)", "tanh({0})", "acos({0}/4)", "bitwise_xor(5,int(abs({0}*9)))*.1", "strlen(str({0},5,2))*.1", "val(str({0},0,3))", "asc(chr(65+int(abs({1}))))*.01", "(strcmp(substr(\"hello\",2,3),\"ell\")=0)*.7", "({0}<{1})+.3*({1}>={2})",
                  "rand(seed(int(abs({0}*99))))", "select({0},{1},{2})", "f_noise3d({0},{1},{2})", "f_torus({0},{1},{2},1,.3)*.3", "div({0}*10,3)*.1", "sqrt(abs({0}))", "log(abs({1})+1)", "asinh({0})", "degrees({0})*.01", "max({0},{1},{2})")
    return leaf(f"sphere {{ 0, 1 pigment {{ rgb <.5+.25*({text.format(*[f'{a:.3g}' for a in args])}),.3,.2> }} finish {{ ambient 1 diffuse 0 }} translate y*.2 }}")


@production("item", "legacy", 0.4)
def old_words(g):
    return leaf(g.pick("composite { sphere { 0, .8 pigment { rgb x } } box { .5, 1 pigment { rgb y } } }", "sphere { 0, 1 texture { pigment { color red 1 green .5 } finish { ambient .2 } } }",
                       "sphere { 0, 1 pigment { color red .5 alpha .4 } }", "sphere { 0, 1 pigment { rgbf .7 } finish { refraction 1 ior 1.4 } }", "box { -1, 1 texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb y } } } scale .5 } }", "sphere { 0, 1 pigment { marble color_map { [0, .5 color red 1 color blue 1] [.5, 1 color blue 1 color green 1] } } }",
                       "sphere { 0, 1 pigment { gradient y quick_color rgb x } }", "quadric { <1,1,1>,<0,0,0>,<0,0,0>,-1 pigment { rgb 1 } }", "union { sphere { 0, 1 } bounded_by { sphere { 0, 1.1 } } pigment { rgb z } }", "sphere { 0, 1 pigment { onion turbulence .2 color_map { [0 rgb 0] [1 rgb 1] } } }",
                       "light_source { <2,3,-2> color red 1 spotlight point_at <0,0,0> tightness 5 radius 10 falloff 20 }", "sphere { 0, 1 texture { pigment { rgb 1 } finish { reflection .3 phong 1 phong_size 20 } normal { bumps .4 } } }"))
