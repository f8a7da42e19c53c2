"""Differences that we know and keep (docs/differences.md): what must not drown a report.

A row is a name and a predicate over the text of a reduced scene and its outcome. The first that holds names the find.
"""

from __future__ import annotations

import re

from programs import Outcome


def has(*patterns: str):
    """Returns a predicate: every pattern occurs in the text."""
    return lambda text, alpha: all(re.search(p, text) for p in patterns)


KNOWN = [
    ("fresnel when leaving a nested object", has(r"fresnel", r"interior \{")),
    ("blur of orthographic and cylinder cameras", has(r"aperture", r"orthographic|cylinder [34]")),
    ("poly, cubic, quartic: inside", has(r"\b(poly|cubic|quartic)\b", r"difference|intersection|merge")),
    ("fade of a parallel light", has(r"parallel", r"fade_")),
    ("quadric: box of a paraboloid or hyperboloid", has(r"quadric", r"clipped_by|intersection|difference")),
    ("sphere_sweep: inside", has(r"sphere_sweep", r"difference|intersection|merge|clipped_by|trace|inside")),
    ("cubic sphere_sweep: bounds", has(r"sphere_sweep", r"cubic_spline|b_spline")),
    ("bicubic_patch clipped", has(r"bicubic_patch", r"clipped_by|intersection|difference|merge")),
    ("sides of a triangle", has(r"triangle", r"interior_texture")),
    ("box of a disc in an intersection", has(r"disc", r"intersection|difference")),
    ("pattern at a border", has(r"gradient y|checker|cells|cubic\b|brick", r"plane \{\s*y, -1\s")),
    ("f_noise3d below version 3.5", has(r"f_noise3d|pattern \{", r"#version 3\.[01]")),
    ("opacity of a blob", has(r"blob", r"rgb[ft]+|transmit|filter|layer")),
    ("transmit all of a uv-mapped picture", has(r"uv_mapping", r"(transmit|filter) all")),
    ("premultiplied PPM or PGM", has(r"p[pg]m\"", r"premultiplied on")),
    ("sine_wave of 1", has(r"sine_wave")),
    ("media", has(r"\bmedia\b")),
]


def name(text: str, outcome: Outcome, alpha: bool = False) -> str:
    """Returns the name of a known difference, or nothing."""
    return next((label for label, holds in KNOWN if outcome.kind == "picture" and holds(text, alpha)), "")
