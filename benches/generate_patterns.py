#!/usr/bin/env python3
"""Writes a scene for each pattern into a folder: a plane that does little else than to add up ten sizes of it.

    python3 benches/generate_patterns.py target/patterns
"""

import sys
from pathlib import Path

SCENE = """// Ten sizes of the pattern {name}, written by benches/generate_patterns.py.
#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
camera {{ orthographic location -z right 4*x up 3*y look_at 0 }}
plane {{
  z, 0
  hollow
  pigment {{
    average
    pigment_map {{
{entries}
    }}
  }}
  finish {{ ambient 0 diffuse 0 emission 1 }}
}}
"""

MAP = "color_map { [0 rgb 0] [1 rgb 1] }"

# What stands before the colours; patterns that are not named here need only their names.
PARAMETERS = {
    "gradient": "gradient x",
    "julia": "julia <0.353, 0.288>, 30",
    "mandel": "mandel 50",
    "marble": "marble turbulence 0.5",
    "pavement": "pavement number_of_sides 4 number_of_tiles 5",
    "spiral1": "spiral1 5",
    "spiral2": "spiral2 5",
    "tiling": "tiling 10",
    "turbulence": "bozo turbulence 1",
    "wood": "wood turbulence 0.5",
}

# Patterns of blocks have colours in place of maps.
BLOCKS = {
    "brick": "color rgb 0 color rgb 1",
    "checker": "color rgb 0 color rgb 1",
    "cubic": "color rgb 0 color rgb 1 color rgb 0.2 color rgb 0.4 color rgb 0.6 color rgb 0.8",
    "hexagon": "color rgb 0 color rgb 1 color rgb 0.5",
    "square": "color rgb 0 color rgb 1 color rgb 0.3 color rgb 0.6",
    "triangular": "color rgb 0 color rgb 1 color rgb 0.2 color rgb 0.4 color rgb 0.6 color rgb 0.8",
}

PLAIN = """agate boxed bozo bumps cells crackle cylindrical dents granite leopard onion planar quilted radial ripples
spherical spotted waves wrinkles""".split()


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    patterns = {name: f"{name} {MAP}" for name in PLAIN}
    patterns |= {name: f"{start} {MAP}" for name, start in PARAMETERS.items()}
    patterns |= {name: f"{name} {colours}" for name, colours in BLOCKS.items()}
    for name, pattern in sorted(patterns.items()):
        entries = "\n".join(f"      [1 {pattern} scale {0.2 + 0.05 * i:.2f}]" for i in range(10))
        (folder / f"{name}.pov").write_text(SCENE.format(name=name, entries=entries))
    print(f"{len(patterns)} scenes in {folder}")


if __name__ == "__main__":
    main()
