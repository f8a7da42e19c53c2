#!/usr/bin/env python3
"""Recovers the 267 constants of POV-Ray's lattice noise by probing, and checks the noise built from them.

The constants are single numbers that only show through the values of the noise functions. With the generator of the
permutation known, every constant can be met alone: at a lattice point the noise is one table entry, halved.

    python3 scripts/probe_noise_table.py            writes src/math/noise_table.rs and checks it
    python3 scripts/probe_noise_table.py --check    only checks the constants that are there

The check evaluates noise generators 1, 2 and 3 and vector turbulence in Python, written here from their description
alone, and compares them with POV-Ray's own values at several hundred points.
"""

import argparse
import math
import random
import re
import struct
from pathlib import Path

import povprobe

TARGET = Path(__file__).resolve().parent.parent / "src/math/noise_table.rs"
COUNT = 267
SETUP = "#declare N = function { internal(78) }"


def draws(state: int):
    """The pseudo-random source of both kinds of noise: 15 bits from the middle of a 32-bit congruence."""
    while True:
        state = (1812433253 * state + 12345) % 2**32
        yield state >> 16 & 32767


def permutation() -> list[int]:
    """The permutation of 0..4095 behind the lattice hash."""
    table, source = list(range(4096)), draws(0)
    for i in range(4095, -1, -1):
        j = next(source) % 4096
        table[i], table[j] = table[j], table[i]
    assert table[:6] == [2291, 2574, 3654, 1557, 1196, 3388] and table[4095] == 3088
    return table


P = permutation()


def hash_at(i: int, j: int, k: int) -> int:
    """Hash of a lattice index."""
    return P[P[P[i % 4096] ^ (j % 4096)] ^ (k % 4096)] & 255


def hash_of_point(x: int, y: int, z: int) -> int:
    """Hash of an integer point, whose index is moved by 10000."""
    return hash_at(x + 10000, y + 10000, z + 10000)


def points_by_hash() -> dict[int, tuple[int, int, int]]:
    """One integer point for each of the 256 hashes."""
    found = {}
    for x in range(12):
        for y in range(12):
            for z in range(12):
                found.setdefault(hash_of_point(x, y, z), (x, y, z))
    assert len(found) == 256
    return found


def six_digits(value: float) -> float:
    """The constants have six significant decimal digits."""
    return float(f"{value:.6g}")


def recover() -> list[float]:
    """All constants, each met alone (0..255 as values, the rest as the last component of the vector noise)."""
    points = points_by_hash()
    value = lambda p: f"N({p[0]},{p[1]},{p[2]},1)"
    vector = lambda p: f"vturbulence(2,.5,1,<{p[0]},{p[1]},{p[2]}>).z"
    table = [six_digits(2 * v - 1) for v in povprobe.values([value(points[h]) for h in range(256)], SETUP)]
    # A lattice value is clamped to 0..1, so a constant beyond -1..1 would not show: the second way sees it.
    table += [six_digits(2 * v) for v in povprobe.values([vector(points[h]) for h in range(248, 256)])]
    corner = points[255]
    halfway = [tuple(c + 0.5 * (axis == a) for a, c in enumerate(corner)) for axis in range(3)]
    for axis, noise in enumerate(povprobe.values([vector(p) for p in halfway])):
        g = hash_of_point(*(c + (axis == a) for a, c in enumerate(corner)))
        table.append(six_digits(2 * (2 * noise - table[263] / 2 - table[g + 8] / 2 + table[g + 9 + axis] / 2)))
    again = [six_digits(2 * v) for v in povprobe.values([vector(points[h - 8]) for h in range(8, 256)])]
    assert again == table[8:256], "the two ways to see a constant disagree"
    return table


def write(table: list[float]) -> None:
    """Writes the constants as Rust, in rows filled to 120 columns."""
    rows, row = [], ""
    for text in (rust_number(v) + "," for v in table):
        if row and len("    " + row + " " + text) > 120:
            rows.append("    " + row)
            row = text
        else:
            row = f"{row} {text}".strip()
    rows.append("    " + row)
    TARGET.write_text(
        "//! The constants of the lattice noise.\n"
        "//!\n"
        "//! Provenance: recovered from the running POV-Ray 3.7.0.10 by `scripts/probe_noise_table.py`, which asks it for\n"
        "//! the noise at lattice points (where the noise is one constant, halved) and rounds to the six digits they have.\n"
        "//! The same script checks them at several hundred other points. Written by the script: do not edit.\n\n"
        "/// Value and slopes of the noise at a lattice corner with hash `h` stand at `h`, `h + 1`, `h + 2`, `h + 3`; the\n"
        "/// components of the vector noise start at `h`, `h + 4` and `h + 8`.\n"
        "#[rustfmt::skip] // One entry is too long for rustfmt's filled rows: it would take 267 lines.\n"
        f"pub(super) static NOISE_TABLE: [f64; {COUNT}] = [\n" + "\n".join(rows) + "\n];\n"
    )


def rust_number(value: float) -> str:
    text = repr(value)
    assert "e" not in text
    return text


def read() -> list[float]:
    """The constants as they stand in the Rust file."""
    body = TARGET.read_text().split("= [", 1)[1]
    table = [float(number) for number in re.findall(r"-?\d+\.\d+", body)]
    assert len(table) == COUNT
    return table


def cell(c: float) -> tuple[int, float]:
    """Lattice cell of a coordinate and the place within it."""
    n = int(c) if c >= 0 else int(c - (1 - 1e-10))
    return n + 10000, c - n


def fade(f: float) -> float:
    return f * f * (3 - 2 * f)


def clamp(v: float) -> float:
    return min(max(v, 0.0), 1.0)


def lattice(table: list[float], p, o: int) -> float:
    """The lattice sum with table offset `o`."""
    cells = [cell(c) for c in p]
    total = 0.0
    for corner in range(8):
        bits = [corner >> axis & 1 for axis in range(3)]
        weight = math.prod(fade(f) if b else 1 - fade(f) for (_, f), b in zip(cells, bits))
        h = hash_at(*(n + b for (n, _), b in zip(cells, bits))) + o
        slopes = sum(table[h + 1 + axis] * (f - b) for axis, ((_, f), b) in enumerate(zip(cells, bits)))
        total += weight * (table[h] / 2 + slopes)
    return total


def vector_turbulence(table, lam: float, omega: float, octaves: int, p) -> list[float]:
    """Vector turbulence; POV-Ray keeps lambda and omega in single precision."""
    lam, omega = (struct.unpack("f", struct.pack("f", v))[0] for v in (lam, omega))
    sums, size, weight = [0.0] * 3, 1.0, 1.0
    for _ in range(octaves):
        for axis in range(3):
            sums[axis] += weight * lattice(table, [size * c for c in p], 4 * axis)
        size, weight = size * lam, weight * omega
    return sums


def gradients():
    """Unit gradients and permutation of generator 3."""
    source, vectors = draws(1), []
    while len(vectors) < 2048:
        v = [(next(source) % 4096 - 2048) / 2048 for _ in range(3)]
        square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
        if 1e-5 <= square <= 1:
            vectors.append([c * (1 / math.sqrt(square)) for c in v])
    e = list(range(2048)) + [0]
    for i in range(2048, 0, -2):
        j = next(source) % 2048
        e[i], e[j] = e[j], e[i]
    assert e[:6] == [0, 1, 386, 3, 649, 1576]
    return vectors, e[:2048]


G, Q = gradients()


def gradient_noise(p) -> float:
    """Noise generator 3."""
    shifted = [c + 10000000.023157213 for c in p]
    index = [math.floor(t) for t in shifted]
    f = [t - n for t, n in zip(shifted, index)]

    def corner(a, b, c):
        i, j, k = index[0] + a, index[1] + b, index[2] + c
        g = G[(Q[(Q[i % 2048] + j) % 2048] + k) % 2048]
        return (f[0] - a) * g[0] + (f[1] - b) * g[1] + (f[2] - c) * g[2]

    mix = lambda w, a, b: a + w * (b - a)
    wx, wy, wz = map(fade, f)
    low, high = ([mix(wx, corner(0, b, c), corner(1, b, c)) for b in (0, 1)] for c in (0, 1))
    return clamp(0.5 * (1.59 * mix(wz, mix(wy, *low), mix(wy, *high)) + 0.985))


def noise(table, generator: int, p) -> float:
    """Noise of one of the three generators."""
    if generator == 1:
        return clamp(lattice(table, p, 0) + 0.5)
    if generator == 2:
        return clamp((lattice(table, p, 0) + 1.05242) * 0.48985582)
    return gradient_noise(p)


def check(table: list[float]) -> float:
    """Largest difference from POV-Ray over fixed and random points: each generator, and turbulence of many octaves."""
    rng = random.Random(1)
    points = [(0.1, 0.2, 0.3), (-1.5, 20.25, -300.75), (0, 0, 0), (1, 2, 3), (-5e-11, 0.5, 7.25)]
    points += [tuple(rng.uniform(-s, s) for _ in range(3)) for s in (1, 10, 100, 5000) for _ in range(25)]
    text = lambda p: ",".join(repr(float(c)) for c in p)
    expected, actual = [], []
    for generator in (1, 2, 3):
        expected += povprobe.values([f"N({text(p)},{generator})" for p in points], SETUP)
        actual += [noise(table, generator, p) for p in points]
    for lam, omega, octaves in ((2, 0.5, 1), (2.1, 0.55, 6), (1.7, 0.8, 10)):
        for axis in range(3):
            ask = [f"vturbulence({lam},{omega},{octaves},<{text(p)}>).{'xyz'[axis]}" for p in points]
            expected += povprobe.values(ask)
            actual += [vector_turbulence(table, lam, omega, octaves, p)[axis] for p in points]
    worst = max(abs(a - e) for a, e in zip(actual, expected))
    print(f"{len(expected)} values, largest difference {worst:.3g}")
    return worst


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="only check the constants that are there")
    if not parser.parse_args().check:
        write(recover())
    # The order of additions differs from POV-Ray's, hence a few units in the last place, more for large coordinates.
    assert check(read()) < 1e-11


if __name__ == "__main__":
    main()
