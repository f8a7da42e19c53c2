#!/usr/bin/env python3
"""Runs our renderer and POV-Ray in turn on the same scenes and prints the ratios of CPU time and memory.

    python3 benches/race.py scene.pov …
    python3 benches/race.py --rounds 5 --width 640 --height 480 scene.pov
    python3 benches/race.py --parse scene.pov             only parsing and evaluation are of interest: 1 x 1 pixel

Both use one thread and no antialiasing, and write EXR. CPU time is user and system time of the process, memory its
largest resident set, both as the kernel counts them (less than the 15 MiB of this script is not seen). Runs alternate,
so that a change of the machine's speed meets both; the median of each is compared. Exit code 1 when either fails.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def measure(command: list[str], folder: str) -> tuple[float, float]:
    """CPU seconds and peak memory in MiB of one run."""
    with open(Path(folder) / "log", "w+") as log:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            log.seek(0)
            sys.exit(f"{' '.join(command)}\nfailed with code {process.returncode}:\n{log.read()[-2000:]}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def race(scene: Path, asked: argparse.Namespace) -> None:
    size = (1, 1) if asked.parse else (asked.width, asked.height)
    with tempfile.TemporaryDirectory() as folder:
        ours = [asked.binary, "render", str(scene), "--output", f"{folder}/ours.exr", "--antialias", "off"]
        ours += ["--threads", "1", "--width", str(size[0]), "--height", str(size[1])]
        theirs = ["povray", f"+I{scene}", f"+O{folder}/theirs.exr", "+FE", "-D", "-P", "-A", "+WT1"]
        theirs += [f"+L{scene.parent}", f"+W{size[0]}", f"+H{size[1]}"]
        runs = [(measure(ours, folder), measure(theirs, folder)) for _ in range(asked.rounds)]
    for name, index, unit in (("CPU", 0, "s"), ("memory", 1, "MiB")):
        our_median, their_median = (statistics.median(run[who][index] for run in runs) for who in (0, 1))
        print(
            f"{scene.name:28} {name:7} ours {our_median:9.3f} {unit:3}  POV-Ray {their_median:9.3f} {unit:3}"
            f"  POV-Ray / ours {their_median / max(our_median, 1e-9):7.2f}",
            flush=True,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="+", type=Path)
    parser.add_argument("--binary", default=str(ROOT / "target/release/whitted"), help="ours (default: %(default)s)")
    parser.add_argument("--rounds", type=int, default=3, help="runs of each (default: %(default)s)")
    parser.add_argument("--width", type=int, default=640)
    parser.add_argument("--height", type=int, default=480)
    parser.add_argument("--parse", action="store_true", help="render one pixel: the rest is parsing")
    asked = parser.parse_args()
    for scene in asked.scenes:
        race(scene.resolve(), asked)


if __name__ == "__main__":
    main()
