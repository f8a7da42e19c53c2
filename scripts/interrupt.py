#!/usr/bin/env python3
"""Kills the program at random moments and goes on, again and again: files must come out as if nothing had happened.

    scripts/interrupt.py PROGRAM [KILLS [SEED]]

Each round renders a picture or an animation through `PROGRAM povray … +C` in a folder of its own, killed (-9, now and then
-TERM or -INT) at random until it is done, and compares all files of the folder with those of an undisturbed run, byte for
byte. Rounds go on until there were so many kills by -9.
"""

import collections
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENE = """#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 3, -8 + clock> look_at 0 } light_source { <9, 9, -9>, 1 area_light 3*x, 3*y, 2, 2 }
#declare I = 0; #while (I < 16)
  sphere { <mod(I, 4) - 1.5, 0, div(I, 4) - 1.5>, .45 pigment { rgbt <.2, .4, .6, .5> } finish { reflection .4 } interior { ior 1.3 } }
#declare I = I + 1; #end
plane { y, -.5 pigment { checker rgb 1 rgb .2 } }
"""
# Seconds until a kill at most: there should be many, also where other work slows the program down. Blocks of the picture
# take much less, so every longer run gets on.
LONGEST = 1.5
KINDS = {
    "picture": ["+W480", "+H360", "+A0.3", "+R2"],
    "exr": ["+W360", "+H270", "+A0.3", "+AM2", "+R2", "+FE"],
    "animation": ["+W64", "+H48", "+KFF40", "+A0.3", "+R2"],
}


def start(program: str, folder: Path, kind: str, goes_on: bool) -> subprocess.Popen:
    arguments = [program, "povray", "scene.pov", *KINDS[kind], "-V"] + (["+C"] if goes_on else [])
    return subprocess.Popen(arguments, cwd=folder, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)


def files(folder: Path) -> dict:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def undisturbed(program: str, kind: str) -> tuple:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "scene.pov").write_text(SCENE)
        began = time.monotonic()
        assert start(program, folder, kind, False).wait() == 0
        return files(folder), time.monotonic() - began


def main() -> int:
    program = os.path.abspath(sys.argv[1])
    enough = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    expected = {kind: undisturbed(program, kind) for kind in KINDS}
    kills, rounds, wrong = collections.Counter(), 0, 0
    while kills[signal.SIGKILL] < enough:
        kind = list(KINDS)[rounds % len(KINDS)]
        rounds += 1
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "scene.pov").write_text(SCENE)
            while True:
                process = start(program, folder, kind, True)
                try:
                    process.wait(0.02 + chance.random() * min(expected[kind][1] * 0.8, LONGEST))
                    break
                except subprocess.TimeoutExpired:
                    how = chance.choice([signal.SIGKILL] * 8 + [signal.SIGTERM, signal.SIGINT])
                    process.send_signal(how)
                    kills[how] += process.wait() != 0
            # What the last one finished may have been left by one before it, killed while it wrote.
            if process.returncode != 0 or files(folder) != expected[kind][0]:
                wrong += 1
                print(f"round {rounds}, {kind}: exit {process.returncode}, {sorted(files(folder))[:5]}")
    counted = ", ".join(f"{n} by {how.name}" for how, n in sorted(kills.items()))
    print(f"{rounds} rounds, kills: {counted}; {wrong} wrong; undisturbed "
          + ", ".join(f"{kind} {time:.1f} s" for kind, (_, time) in expected.items()))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
