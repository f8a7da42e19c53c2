#!/usr/bin/env python3
"""Recovers the 112 border maps of the `pavement` pattern by probing POV-Ray, and writes them as Rust.

A pavement cuts the plane into unit squares or unit triangles and joins some of them into tiles: an edge of a cell is
a border of a tile or is open. Just inside the middle of a border the pattern is near 1, near an open edge it is near
0. For triangles, `form 2` bends some corners of the joints; which ones is seen by comparing with `form 0`.

    python3 scripts/probe_pavement.py         writes src/compiled/texture/pavement_table.rs

Cells are counted in lattice coordinates (i, j): the point i*A + j*B with A = (1, 0), and B = (0, 1) for squares or
(1/2, sqrt(3)/2) for triangles. Every edge belongs to one lattice point: edge 0 goes along A, edge 1 along B, and edge 2
(triangles) joins the ends of these two.
"""

import itertools
from pathlib import Path

import povprobe

TARGET = Path(__file__).resolve().parent.parent / "src/compiled/texture/pavement_table.rs"
PATTERNS = {3: [1, 1, 1, 3, 4, 12], 4: [1, 1, 2, 5, 12, 35], 6: [1, 1, 3, 7, 22]}
PERIODS = {
    3: [(1, 2), (1, 2), (3, 2), (2, 4), (5, 10), (6, 12)],
    4: [(1, 1), (2, 2), (6, 6), (4, 4), (10, 10), (12, 12)],
    6: [(3, 2), (3, 2), (9, 6), (12, 8), (30, 20)],
}
INSIDE = 0.001
HEIGHT = 3**0.5 / 2

# Corners of the cells at a lattice point, in lattice coordinates. A side is named by its two corners.
SQUARE = [((0, 0), (1, 0), (1, 1), (0, 1))]
TRIANGLES = [((0, 0), (1, 0), (0, 1)), ((1, 1), (0, 1), (1, 0))]


def cells(sides):
    return SQUARE if sides == 4 else TRIANGLES


def place(sides, point):
    """Lattice coordinates to the plane."""
    i, j = point
    return (i, j) if sides == 4 else (i + j / 2, j * HEIGHT)


def edge_of(a, b):
    """The edge between two neighbouring lattice points: its lattice point and its number."""
    (i, j), (k, l) = sorted((a, b))
    if l == j:
        return (i, j, 0)
    return (i, j, 1) if k == i else (i, l, 2)


def sample_points(sides):
    """Points to look at for each cell: just inside the middle of every side, then 35 % from corner to centre."""
    points = []
    for corners in cells(sides):
        flat = [place(sides, c) for c in corners]
        centre = [sum(p[axis] for p in flat) / len(flat) for axis in (0, 1)]
        for a, b in zip(flat, flat[1:] + flat[:1]):
            middle = [(a[axis] + b[axis]) / 2 for axis in (0, 1)]
            distance = sum((centre[axis] - middle[axis]) ** 2 for axis in (0, 1)) ** 0.5
            points.append([m + (c - m) * INSIDE / distance for m, c in zip(middle, centre)])
        if sides != 4:
            points += [[v + 0.35 * (c - v) for v, c in zip(p, centre)] for p in flat]
    return points


def digits(sides, tiles, number):
    """One digit for each point of each cell over a whole period: 1 border, 0 open, and for corners 1 bent, 0 not."""
    width, rows = PERIODS[sides][tiles - 1]
    points = sample_points(sides)
    base = "0,1" if sides == 4 else "0.5,sqrt(3)/2"
    pattern = f"pavement number_of_sides {sides} number_of_tiles {tiles} pattern {number} form"
    ramp = "color_map { [0 rgb 0] [1 rgb 1] }"  # `pattern` functions refuse pavement, `pigment` functions do not.
    is_corner = [sides != 4 and n % 6 >= 3 for n in range(len(points))]
    scene = [
        "#version 3.7; global_settings { assumed_gamma 1 }",
        f"#declare Plain = function {{ pigment {{ {pattern} 0 {ramp} }} }}",
        f"#declare Bent = function {{ pigment {{ {pattern} 2 {ramp} }} }}",
        f"#declare Count = {len(points)};",
        "#declare X = array[Count] {" + ",".join(repr(p[0]) for p in points) + "}",
        "#declare Z = array[Count] {" + ",".join(repr(p[1]) for p in points) + "}",
        "#declare Corner = array[Count] {" + ",".join(str(int(c)) for c in is_corner) + "}",
        f"#for (J, 0, {rows - 1}) #for (I, 0, {width - 1})",
        f"#declare Place = <I, 0, 0> + J * <{base.split(',')[0]}, 0, {base.split(',')[1]}>;",
        '#declare Row = "";',
        "#for (N, 0, Count - 1)",
        "#declare V = Plain(Place.x + X[N], 0, Place.z + Z[N]).red;",
        "#if (Corner[N]) #declare V = (abs(Bent(Place.x + X[N], 0, Place.z + Z[N]).red - V) > 1e-6);",
        '#elseif (V > 0.1 & V < 0.9) #error "neither border nor open" #end',
        '#declare Row = concat(Row, #if (V > 0.5) "1" #else "0" #end);',
        '#end #debug concat("@", Row, "\\n") #end #end',
    ]
    found = [line[1:] for line in povprobe.run("\n".join(scene)).splitlines() if line.startswith("@")]
    assert len(found) == width * rows
    return found


def borders(sides, tiles, number):
    """The border bit of every edge and the bent bit of every corner in one period, as functions of (i, j)."""
    width, rows = PERIODS[sides][tiles - 1]
    # A step of `rows` rows straight up is not a multiple of B for triangles: it goes back half as many units.
    skew = 0 if sides == 4 else rows // 2

    def wrap(i, j):
        turns, j = divmod(j, rows)
        return (i + turns * skew) % width, j

    found = digits(sides, tiles, number)
    edges, bends = {}, {}
    for index, text in enumerate(found):
        j, i = divmod(index, width)
        bits = iter(text)
        for which, corners in enumerate(cells(sides)):
            absolute = [(i + a, j + b) for a, b in corners]
            for a, b in zip(absolute, absolute[1:] + absolute[:1]):
                k, l, e = edge_of(a, b)
                bit = next(bits) == "1"
                assert edges.setdefault((*wrap(k, l), e), bit) == bit, "the two sides of an edge disagree"
            if sides != 4:
                for corner in range(3):
                    bends[(i, j, which, corner)] = next(bits) == "1"
    return width, rows, wrap, edges, bends


def check_bends(wrap, edges, bends):
    """A corner is bent exactly where the tile's wedge around it is two triangles wide: bends need no table."""
    ring = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)]
    for (i, j, which, corner), bent in bends.items():
        corners = [(i + a, j + b) for a, b in TRIANGLES[which]]
        v = corners[corner]
        around = [(v[0] + a, v[1] + b) for a, b in ring]
        walls = []
        for end in around:
            k, l, e = edge_of(v, end)
            walls.append(edges[(*wrap(k, l), e)])
        # The triangle fills the wedge between directions `low` and `low + 1`; widen it both ways up to a border.
        low = next(n for n in range(6) if {around[n], around[(n + 1) % 6]} == set(corners) - {v})
        high = low + 1
        while any(walls) and not walls[low % 6]:
            low -= 1
        while any(walls) and not walls[high % 6]:
            high += 1
        assert bent == (any(walls) and high - low == 2), "the rule of the bends does not hold"


def smallest_lattice(width, rows, wrap, edges, kinds):
    """The period lattice of least area, vectors (w, 0) and (s, h), with its edge bits row by row."""
    at = lambda i, j, e: edges[(*wrap(i, j), e)]
    period = list(itertools.product(range(width), range(rows), range(kinds)))
    invariant = lambda di, dj: all(at(i + di, j + dj, e) == at(i, j, e) for i, j, e in period)
    w = next(w for w in range(1, width + 1) if invariant(w, 0))
    h, s = next((h, s) for h in range(1, rows + 1) for s in range(w) if invariant(s, h))
    bits = [at(i, j, e) for j in range(h) for i in range(w) for e in range(kinds)]
    return w, h, s, sum(bit << n for n, bit in enumerate(bits))


HEAD = """//! Which cell sides are tile borders in each of the 112 pavements.
//!
//! Provenance: recovered from the running POV-Ray 3.7.0.10 by `scripts/probe_pavement.py`, which looks at the pattern's
//! value just inside the middle of every cell side. Written by the script: do not edit.
//!
//! Cells are squares or triangles over the lattice points `i * A + j * B`, with `A = (1, 0)` and `B = (0, 1)` for four
//! sides, `B = (1/2, sqrt(3)/2)` for three and six. Each edge belongs to one lattice point: edge 0 leads along `A`, edge
//! 1 along `B`, and edge 2 (triangles only) joins the ends of these two.
//!
//! No table is needed for the corners that `form` bends: the script found that a triangle's corner is bent exactly where
//! the wedge of its tile around that corner is two triangles wide.

/// The borders of one pavement over one period.
pub(super) struct PavementMap {
    /// Periods: the map repeats after (`width`, 0) and after (`shift`, `height`), in lattice steps.
    pub(super) width: u8,
    pub(super) height: u8,
    pub(super) shift: u8,
    /// Bit `(j * width + i) * k + edge` tells whether an edge is a border; `k` is 2 for squares, 3 for triangles.
    pub(super) borders: u128,
}

const fn map(width: u8, height: u8, shift: u8, borders: u128) -> PavementMap {
    PavementMap { width, height, shift, borders }
}
"""

NAMES = {3: "TRIANGLE", 4: "SQUARE", 6: "HEXAGON"}


def main() -> None:
    text = [HEAD]
    for sides, counts in PATTERNS.items():
        name = NAMES[sides]
        text += [f"/// Pavements with `number_of_sides {sides}`, by `number_of_tiles` and then `pattern`, each less one."]
        text += [f"pub(super) const {name}_PAVEMENTS: [&[PavementMap]; {len(counts)}] = ["]
        for tiles, count in enumerate(counts, 1):
            rows = []
            for number in range(1, count + 1):
                width, height, wrap, edges, bends = borders(sides, tiles, number)
                check_bends(wrap, edges, bends)
                w, h, s, bits = smallest_lattice(width, height, wrap, edges, 2 if sides == 4 else 3)
                rows.append(f"map({w}, {h}, {s}, {bits:#x})")
            line = f"    &[{', '.join(rows)}],"
            text += [line] if len(line) <= 120 else ["    &[", *(f"        {row}," for row in rows), "    ],"]
        text += ["];\n"]
    TARGET.parent.mkdir(parents=True, exist_ok=True)
    TARGET.write_text("\n".join(text).rstrip() + "\n")


if __name__ == "__main__":
    main()
