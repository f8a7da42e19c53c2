#!/usr/bin/env python3
"""Whether pictures are as far from the truth as they say.

usage: calibrate.py [--binary PATH] [--scenes FOLDER] [--list FILE] [--size 160x120] [--jobs 2] [--csv FILE] [--svg FILE]

Each scene below the folder (POV-Ray's samples by default; --list takes a file with one name a line) is rendered to three
targets and, with another seed, to a reference whose own estimated error is at most a quarter of the smallest target.
The true error of a picture is the RMSE against the reference with the reference's own error taken off. Printed for each
target: how many pictures were made, for how many the true error lies between half and twice the estimate, and for how
many it is at most the target. Scenes that cannot be rendered, that take too long, or whose reference did not get that
far, are counted and named. Constants of the sampler were fitted on scenes with an even number in the list; both halves
are told apart.
Needs: pip install numpy OpenEXR
"""
import argparse
import collections
import concurrent.futures
import csv
import glob
import math
import os
import subprocess
import sys
import tempfile

import numpy
import OpenEXR

TARGETS = (0.04, 0.02, 0.01)
REFERENCE = 0.0025
# Seconds that a reference may take, and a picture without antialiasing, on one thread.
PATIENCE, PLAIN = 45, 4
Pair = collections.namedtuple("Pair", "scene number target estimate true reference samples")


def read(path):
    with OpenEXR.File(path) as file:
        figures = {name: float(numpy.ravel(value)[0]) for name, value in file.header().items()
                   if name.startswith("whitted:") and not isinstance(value, str)}
        return file.channels()["RGB"].pixels.astype(float), figures


def render(args, scene, folder, options, seconds):
    """The picture and its figures; an empty answer where there is none."""
    out = os.path.join(folder, "picture.exr")
    width, height = args.size.split("x")
    command = [args.binary, "render", os.path.basename(scene), "--output", out, "--float", "--threads", "1",
               "--no-warn", "all", "-W", width, "-H", height, *options]
    try:
        done = subprocess.run(command, cwd=os.path.dirname(scene), capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None
    return read(out) if done.returncode == 0 else None


def rmse(a, b):
    return math.sqrt(numpy.mean((a - b) ** 2))


def measure(args, number, scene):
    """Pairs of estimate and truth, or why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        if render(args, scene, folder, ["--antialias", "off"], PLAIN) is None:
            return "cannot be rendered or is slow"
        options = ["--target-error", str(REFERENCE), "--seed", "123456789"]
        found = render(args, scene, folder, options, PATIENCE)
        if found is None:
            return "its reference takes too long"
        reference, own = found[0], found[1]["whitted:errorEstimate"]
        if own > REFERENCE:
            return "its reference is not good enough"
        pairs = []
        for target in TARGETS:
            found = render(args, scene, folder, ["--target-error", str(target), "--seed", str(number)], PATIENCE)
            if found is not None:
                picture, figures = found
                true = math.sqrt(max(0.0, rmse(picture, reference) ** 2 - own ** 2))
                estimate, samples = figures["whitted:errorEstimate"], figures["whitted:samples"]
                pairs.append(Pair(args.names[number], number, target, estimate, true, own,
                                  samples / reference.shape[0] / reference.shape[1]))
        return pairs


def is_calibrated(pair):
    """Errors far below the target and the reference's own are right whatever the estimate says of them."""
    negligible = max(pair.target / 20, pair.reference)
    within = 0.5 * pair.estimate <= pair.true <= 2 * pair.estimate
    return within or max(pair.true, pair.estimate) <= negligible


def tell(pairs, title):
    print(title)
    for target in (*TARGETS, None):
        some = [pair for pair in pairs if target in (None, pair.target)]
        if some:
            good, hits = sum(map(is_calibrated, some)), sum(pair.true <= pair.target for pair in some)
            ratios = sorted(pair.true / pair.estimate for pair in some if pair.estimate > 0)
            print(f"  target {target or 'all':>5}: {len(some)} pictures, {good} ({100 * good / len(some):.1f} %) between half and "
                  f"twice the estimate, {hits} ({100 * hits / len(some):.1f} %) at most the target, "
                  f"median of true / estimate {ratios[len(ratios) // 2]:.2f}")


def histogram(pairs, path):
    """The logarithms of true over estimated error, as a picture that stands by itself."""
    edges = [k / 8 for k in range(-16, 17)]
    logs = [min(max(math.log2(max(pair.true, 1e-9) / max(pair.estimate, 1e-9)), -1.99), 1.99) for pair in pairs
            if pair.estimate > 0]
    counts = numpy.histogram(logs, edges)[0]
    width, height, left, base = 640, 300, 50, 250
    step, scale = (width - 2 * left) / len(counts), (base - 40) / max(counts)
    bars = []
    for i, count in enumerate(counts):
        inside = -1 <= edges[i] < 1
        bars.append(f'<rect class="{"in" if inside else "out"}" x="{left + i * step + 1:.1f}" y="{base - count * scale:.1f}" '
                    f'width="{step - 2:.1f}" height="{count * scale:.1f}"><title>{count}</title></rect>')
        if count:
            bars.append(f'<text x="{left + (i + .5) * step:.1f}" y="{base - count * scale - 5:.1f}">{count}</text>')
    names = {-2: "¼ or less", -1: "½", 0: "1", 1: "2", 2: "4 or more"}
    marks = [f'<text x="{left + (log + 2) * 8 * step:.1f}" y="{base + 18}">{name}</text>' for log, name in names.items()]
    with open(path, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img" '
                   f'aria-label="Histogram of true over estimated error of {len(logs)} pictures">'
                   "<style>text{font:12px sans-serif;text-anchor:middle;fill:#555}.in{fill:#3b78b5}.out{fill:#c9702e}"
                   "line{stroke:#888}@media(prefers-color-scheme:dark){text{fill:#bbb}}</style>"
                   f'<line x1="{left}" x2="{width - left}" y1="{base}" y2="{base}"/>{"".join(bars)}{"".join(marks)}'
                   f'<text x="{width / 2}" y="{base + 40}">true error / estimated error</text></svg>\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--binary", default="target/release/whitted")
    parser.add_argument("--scenes", default="/usr/share/doc/povray/examples")
    parser.add_argument("--list")
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--csv")
    parser.add_argument("--svg")
    args = parser.parse_args()
    args.binary = os.path.abspath(args.binary)
    if args.list:
        with open(args.list) as file:
            args.names = [line.strip() for line in file if line.strip()]
    else:
        found = glob.glob("**/*.pov", root_dir=args.scenes, recursive=True)
        args.names = sorted(found)
    pairs, refused = [], collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        jobs = [pool.submit(measure, args, number, os.path.join(args.scenes, name)) for number, name in enumerate(args.names)]
        for number, job in enumerate(jobs):
            answer = job.result()
            if isinstance(answer, str):
                refused[answer] += 1
                print(f"{args.names[number]}: {answer}", file=sys.stderr)
                continue
            pairs.extend(answer)
            for pair in answer:
                if not is_calibrated(pair):
                    print(f"{pair.scene}: target {pair.target}, estimate {pair.estimate:.4f}, true {pair.true:.4f}", file=sys.stderr)
    tell(pairs, "all scenes")
    tell([pair for pair in pairs if pair.number % 2 == 0], "scenes that constants were fitted on")
    tell([pair for pair in pairs if pair.number % 2 == 1], "scenes that they are judged on")
    print(f"{len({pair.scene for pair in pairs})} scenes; left out:", dict(refused))
    if args.csv:
        with open(args.csv, "w", newline="") as file:
            csv.writer(file).writerows([Pair._fields, *pairs])
    if args.svg:
        histogram(pairs, args.svg)


if __name__ == "__main__":
    main()
