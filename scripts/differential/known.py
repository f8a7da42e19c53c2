"""Differences that we know and keep (docs/differences.md): what must not drown a report.

A row holds a name, a predicate over a scene's text, and a cure: an edit of the scene's tree that takes the cause away.
A scene has the difference when it fits and both programs agree about the cured scene; nothing is named on suspicion.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from programs import Outcome
from tree import Node, group, leaf, need

Cure = Callable[[Node], None]
Holds = Callable[[str], bool]
MODIFIERS = ("look", "transform", "flag", "clip", "pigment", "texture")


@dataclass
class Known:
    """A known difference: `holds` says whether a text may have it, `cure` changes a copy of its tree in place."""

    name: str
    holds: Holds
    cure: Cure


def has(*patterns: str) -> Holds:
    """Returns a predicate: every pattern occurs in the text."""
    return lambda text: all(re.search(p, text) for p in patterns)


def is_spindle(sizes: str) -> bool:
    """Returns whether a torus may have a tube that is thicker than its circle: not if two numbers say otherwise."""
    found = re.fullmatch(r"([\d.]+), ([\d.]+)", sizes)
    return not found or float(found[1]) < float(found[2])


def rewritten(pattern: str, put: str = "") -> Cure:
    """Returns a cure that replaces what matches in the text of every node."""

    def cure(root: Node) -> None:
        for node in root.walk():
            node.head = re.sub(pattern, put, node.head)

    return cure


def spheres(*words: str) -> Cure:
    """Returns a cure that puts spheres in the place of some shapes; looks, movements and clips stay."""

    def cure(root: Node) -> None:
        for node in root.walk():
            if node.head in [f"{word} {{" for word in words]:
                node.head = "sphere {"
                node.children = [need("0, .8"), *[child for child in node.children if child.sort in MODIFIERS]]

    return cure


def added(word: str, put: str) -> Cure:
    """Returns a cure that adds something at the end of each block that begins with a word."""

    def cure(root: Node) -> None:
        for node in root.walk():
            if node.head == word + " {":
                node.children.append(leaf(put))

    return cure


def discs(root: Node) -> None:
    """Puts spheres in the place of discs, also of those that share a line with something else."""
    spheres("disc")(root)
    rewritten(r"\bdisc \{ 0, y, 1", "sphere { 0, .8")(root)


def all_faces(root: Node) -> None:
    """Makes meshes report every face to what they are parts of."""
    for word in ("mesh", "mesh2"):
        added(word, "hierarchy off")(root)


def closed_form(root: Node) -> None:
    """Takes `sturm` from surfaces of revolution."""
    for node in root.walk():
        if node.head == "sor {":
            node.children = [child for child in node.children if child.head != "sturm"]


def plump(root: Node) -> None:
    """Puts spheres in the place of spindle tori."""
    for node in root.walk():
        if node.head == "torus {" and is_spindle(node.children[0].head):
            spheres("torus")(group(node))


def upright(flag: str) -> Cure:
    """Returns a cure that takes `inverse` from solids made of others."""

    def cure(root: Node) -> None:
        for node in root.walk():
            if re.match("(union|merge|intersection|difference|object) {", node.head):
                node.children = [child for child in node.children if child.head != flag]

    return cure


def without(feature: str) -> Cure:
    """Returns a cure that takes out what a production made."""

    def cure(root: Node) -> None:
        for node in root.walk():
            node.children = [child for child in node.children if child.feature != feature]

    return cure


VECTOR_PART = r"\b(turbulence|scale|translate|rotate) ((<[^<>]*>|v[a-z]+\([^()]*\)|[xyz])\.[xyz])"


def even(root: Node) -> None:
    """Takes the transformations off smooth triangles that change their shape."""
    for node in root.walk():
        if node.head == "smooth_triangle {":
            node.children = [child for child in node.children if not re.match("matrix|transform|scale", child.head)]


def steep(root: Node) -> None:
    """Gives isosurfaces a gradient that bounds most of what the grammar makes."""
    for node in root.walk():
        if node.head == "isosurface {":
            kept = [child for child in node.children if not re.match("max_gradient|evaluate", child.head)]
            node.children = [kept[0], leaf("max_gradient 300"), *kept[1:]]


SHAPES = r"\b(?:object|sphere|box|cylinder|cone|plane|disc|torus|union|merge|intersection|difference|polygon|triangle|quadric) \{"


def twins(text: str) -> bool:
    """Returns whether two round shapes have the same numbers."""
    numbers = r"\b((?:sphere|cylinder|cone|torus|ovus) \{\s*[-\d.<>,xyz\s]*\d)"
    return bool(re.search(rf"{numbers}(?s:.*)\1", text))


def apart(size: str) -> Cure:
    """Returns a cure that moves the objects of a scene and their parts a little, each by another way, so that no faces
    lie in the same place.

    POV-Ray overlooks what lies less than 0.0001, for shadows 0.001, behind where a ray leaves a surface: moves of
    hundredths are larger than that, also where they run nearly along the surface. Round things in the same place cross
    each other in a ring of such distances all the same, which is the narrower the farther they are moved.
    """

    def cure(root: Node) -> None:
        for i, node in enumerate(placed(root)):
            move = f"translate <{13 + 7 * i},{11 + 5 * i},{-17 + 3 * i}>*{size}"
            if node.tail == "}" and (node.sort == "object" or re.match(SHAPES, node.head)):
                node.children.append(leaf(move))
            else:
                node.head = re.sub(rf"^(.*{SHAPES}.*)\}}", rf"\1{move} }}", node.head)
        for loop in root.walk():
            if re.search(r"#(for|while) \(Ci", loop.head):
                for copy in [node for node in loop.children if node.tail == "}"]:
                    copy.children.append(leaf(f"translate <31,-47,23>*{size}*Ci"))

    return cure


def placed(node: Node) -> list[Node]:
    """Returns the objects of a scene and their parts."""
    solids = [word + " {" for word in ("union", "merge", "intersection", "difference", "object", "light_group")]
    nested = lambda child: placed(child) if not child.head or child.head in solids or child.head[0] == "#" else []
    return [inner for child in node.children for inner in (child, *nested(child))]


KNOWN = [
    Known("fresnel when leaving a nested object", has(r"fresnel", r"interior \{"), rewritten(r"fresnel( on)?")),
    Known("blur of orthographic and cylinder cameras", has(r"aperture", r"orthographic|cylinder [34]"), rewritten(r"aperture .* focal_point (0|<[^>]*>)")),
    Known("poly, cubic, quartic: inside", has(r"\b(poly|cubic|quartic) \{", r"difference|intersection|merge|clipped_by|fog|interior|inverse"), spheres("poly", "cubic", "quartic")),
    Known("fade of a parallel light", has(r"parallel", r"fade_distance"), rewritten(r"fade_distance \S+ fade_power \S+")),
    Known("quadric: box", has(r"quadric \{", r"clipped_by|intersection|difference|bounded_by"), spheres("quadric")),
    Known("cubic sphere_sweep", has(r"sphere_sweep \{", r"cubic_spline|b_spline"), spheres("sphere_sweep")),
    Known("sphere_sweep: inside", has(r"sphere_sweep", r"difference|intersection|merge|clipped_by|trace|interior|fog|inverse"), spheres("sphere_sweep")),
    Known("bicubic_patch clipped", has(r"bicubic_patch", r"clipped_by|intersection|difference|merge"), spheres("bicubic_patch")),
    Known("sides of a triangle", has(r"triangle \{", r"interior_texture|trace"), spheres("triangle", "smooth_triangle", "mesh", "mesh2")),
    Known("box of a disc in an intersection", has(r"disc \{", r"intersection|difference"), discs),
    Known("f_noise3d below version 3.5", has(r"f_noise3d|pattern \{", r"#version 3\.[01]"), rewritten(r"f_noise3d\([^()]*\)|(?<=function \{ )pattern \{[^{}]*\}", "x")),
    Known("opacity of a blob", has(r"blob \{", r"rgb[ft]+|transmit|filter|layer"), spheres("blob")),
    Known("transmit all of a picture inside a pigment", has(r"uv_mapping|pigment_map", r"(transmit|filter) all"), rewritten(r"(transmit|filter) all \S+")),
    Known("premultiplied PPM or PGM", has(r"p[pg]m\"", r"premultiplied on"), rewritten("premultiplied on")),
    Known("sine_wave of 1", has(r"sine_wave"), rewritten("sine_wave")),
    Known("sor without sturm", has(r"sor \{"), added("sor", "sturm")),
    Known("sor with sturm", has(r"sor \{", r"sturm"), closed_form),
    Known("quadratic lathe without sturm", has(r"lathe \{", r"quadratic_spline"), added("lathe", "sturm")),
    Known("mesh in a solid", has(r"\bmesh2? \{", r"intersection|difference|merge"), all_faces),
    Known("julia_fractal subtracted and then moved", has(r"julia_fractal \{", r"difference|inverse", r"translate|rotate|scale|matrix|transform"), spheres("julia_fractal")),
    Known("last blocker in a merge", has(r"merge \{", r"rgb[ft]+|transmit|filter|alpha"), added("merge", "no_shadow")),
    Known("smooth_triangle moved unevenly", has(r"smooth_triangle \{", r"matrix|transform"), even),
    Known("spindle torus", has(r"torus \{"), plump),
    Known("faces in the same place", has(), apart("1e-3")),
    Known("round faces in the same place", twins, apart("5e-3")),
    Known("isosurface with too low a max_gradient", has(r"isosurface \{"), steep),
    Known("bounded_by too small", has(r"bounded_by"), rewritten(r"^bounded_by \{.*", "")),
    Known("min_extent", has(r"min_extent"), rewritten(r"^box \{ min_extent.*")),
    Known("camera inside an inverted solid", has(r"\binverse\b", r"union|merge|intersection|difference"), upright("inverse")),
    Known("camera inside a solid of inverted parts", has(r"\binverse\b", r"intersection|difference|merge"), without("inverse")),
    Known("a vector's component where a vector is expected", has(VECTOR_PART), rewritten(VECTOR_PART, r"\1 1*\2")),
    Known("macros below version 3.1", has(r"#macro", r"#version 3\.0"), rewritten(r"#version 3\.0", "#version 3.1")),
    Known("spherical camera below version 3.5", has(r"\bspherical\b", r"#version 3\.[01]"), rewritten(r"#version 3\.[01]", "#version 3.5")),
    Known("metallic before a vector's component", has(r"metallic (<|v[a-z]+\()"), rewritten(r"metallic (<|v[a-z]+\().*", "metallic")),
    Known("wide angle of an old orthographic camera", has(r"orthographic", r"angle (200|360)"), rewritten(r"angle (200|360)", "angle 90")),
]


def suspects(text: str) -> list[Known]:
    """Returns the known differences that a text may have."""
    return [row for row in KNOWN if row.holds(text)]


def name(root: Node, outcome: Outcome, agrees: Callable[[str], bool], count: Callable[[str], float]) -> str:
    """Returns the name of the known difference that a scene has, several joined by "and", or nothing.

    `agrees` tells whether both programs make the same picture of a text, `count` how many pixels differ. Of several
    names none can be left out.
    """
    rows = suspects(root.text()) if outcome.differs() else []
    explained = lambda several: bool(several) and cured(root, several) != root.text() and agrees(cured(root, several))
    for row in rows:
        if explained([row]):
            return row.name
    several = rows
    if len(rows) < 2 or not explained(rows):
        several, left = [], count(root.text())
        # Twice: what one cure does may only show after a later one, as when a program refuses the scene.
        for row in [*rows, *rows]:
            if row not in several and (fewer := count(cured(root, [*several, row]))) < left:
                several, left = [*several, row], fewer
        if not explained(several):
            return ""
    for row in rows:
        without_it = [other for other in several if other is not row]
        several = without_it if row in several and explained(without_it) else several
    return " and ".join(row.name for row in several)


def cured(root: Node, rows: list[Known]) -> str:
    """Returns the text of a scene from which some causes are taken out."""
    copy = root.copy()
    for row in rows:
        row.cure(copy)
    return copy.text()
