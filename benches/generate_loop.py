#!/usr/bin/env python3
"""Writes a scene that does little but run: a loop of N steps (a million unless told otherwise) with rand, arithmetic
and a small macro, whose result is the place of one sphere and is printed, so that two programs can be compared.

    python3 benches/generate_loop.py loop.pov
"""

import argparse
import sys

SCENE = """// A loop of {steps} steps, written by benches/generate_loop.py.
#version 3.7;
global_settings {{ assumed_gamma 1.0 }}

#declare Stream = seed(4711);
#declare Sum = 0;
#declare Place = <0, 0, 0>;

#macro Step(Amount, Turn)
  #local Angle = 2 * pi * Amount + Turn;
  vnormalize(<cos(Angle), Amount - 0.5, sin(Angle)>)
#end

#declare K = 0;
#while (K < {steps})
  #declare R = rand(Stream);
  #if (mod(K, 3) = 0)
    #declare Sum = Sum + sqrt(R) * (1 - R / 2);
  #else
    #declare Sum = Sum - pow(R, 3) / (1 + abs(Sum));
  #end
  #declare Place = 0.999 * Place + 0.01 * Step(R, Sum);
  #declare K = K + 1;
#end

#debug concat("sum ", str(Sum, 0, 10), " place ", vstr(3, Place, ", ", 0, 10), "\\n")

camera {{ location <0, 0, -5> look_at 0 }}
light_source {{ <-5, 7, -6> rgb 1 }}
sphere {{ Place, 1 pigment {{ rgb <0.8, 0.5, 0.2> }} }}
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=1_000_000, help="how many (default: %(default)s)")
    parser.add_argument("file", help="scene to write, - for standard output")
    asked = parser.parse_args()
    with sys.stdout if asked.file == "-" else open(asked.file, "w") as out:
        out.write(SCENE.format(steps=asked.steps))


if __name__ == "__main__":
    main()
