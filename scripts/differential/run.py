#!/usr/bin/env python3
"""Renders random scenes with POV-Ray and with whitted and reduces what differs.

Example: scripts/differential/run.py --seed 1 --count 500 --jobs 6 --area csg --whitted target/release/whitted --out /tmp/found
"""

from __future__ import annotations

import argparse
import collections
import queue
import resource
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import assets
import known
import productions_language  # noqa: F401  (registers productions)
import productions_shapes  # noqa: F401
import productions_textures  # noqa: F401
from grammar import Grammar
from productions_scene import scene
from programs import Outcome, Setup, shape, try_text
from reducer import reduce
from report import Report
from rounding import without_rounding
from tree import Node

AREAS = ["shape", "csg", "texture", "pigment", "pattern", "warp", "normal", "finish", "light", "interior", "camera", "air", "gamma", "transform", "language", "legacy", "flags"]


class Run:
    """One run: its settings, folders and counts."""

    def __init__(self, args: argparse.Namespace):
        self.args = args
        self.out = Path(args.out).resolve()
        assets.write(self.out / "assets")
        self.setup = Setup(whitted=str(Path(args.whitted).resolve()), limit=args.limit, assets=self.out / "assets")
        self.report = Report(self.out / "found")
        self.early: collections.Counter[str] = collections.Counter()
        self.counts: collections.Counter[str] = collections.Counter()
        self.slots: queue.Queue[int] = queue.Queue()
        for slot in range(args.jobs):
            self.slots.put(slot)
        self.writing = threading.Lock()
        self.reducing = threading.Semaphore(args.reducers)
        self.start = time.monotonic()

    def one(self, seed: int) -> None:
        """Makes, renders, compares and if need be reduces one scene."""
        if self.args.minutes and time.monotonic() - self.start > self.args.minutes * 60:
            return
        area = self.args.area or AREAS[seed % len(AREAS)]
        root = scene(Grammar(seed, area, self.args.chance))
        alpha = Grammar(seed, "alpha").rng.random() < 0.15
        slot = self.slots.get()
        try:
            outcome = self.tried(root.text(), slot, alpha)
            label = self.label(root, outcome, slot, alpha)
            self.count(f"{area}:{seed}", alpha, outcome, label)
            if outcome.differs():
                with self.reducing:
                    self.follow(f"{area}:{seed}", root, outcome, label, slot, alpha)
        finally:
            self.slots.put(slot)

    def tried(self, text: str, slot: int, alpha: bool) -> Outcome:
        """Compares both programs' pictures of a text, without what is rounding."""
        folder = self.out / f"job{slot}"
        return without_rounding(text, folder, self.setup, alpha, try_text(text, folder, self.setup, alpha))

    def label(self, root: Node, outcome: Outcome, slot: int, alpha: bool) -> str:
        """Returns the name of the known difference that a scene has, or nothing."""
        agrees = lambda text: self.tried(text, slot, alpha).kind in ("same", "rounding")
        return known.name(root, outcome, agrees, lambda text: self.differing(text, slot, alpha))

    def differing(self, text: str, slot: int, alpha: bool) -> float:
        """Returns how many pixels differ, rounding included: infinitely many where there are no pictures to compare."""
        found = try_text(text, self.out / f"job{slot}", self.setup, alpha)
        return 0 if found.kind == "same" else found.verdict.count if found.verdict and not found.verdict.why else float("inf")

    def follow(self, seed: str, root: Node, outcome: Outcome, label: str, slot: int, alpha: bool) -> None:
        """Reduces a scene that differs and reports it."""
        base = self.out / f"job{slot}"
        early = label or (outcome.kind + shape(outcome.message) if outcome.message else "")
        if early and self.early[early] >= 2:
            self.early[early] += 1
            return
        if early:
            self.early[early] += 1
        alpha_matters = alpha and not self.again(root.text(), base / "0", False, outcome)
        keeps = lambda text, worker: self.again(text, base / str(worker), alpha_matters, outcome)
        small = reduce(root, keeps, workers=6, budget=self.args.budget)
        last = try_text(small.text(), base / "last", self.setup, alpha_matters)
        label = label or self.label(small, last, slot, alpha_matters)
        fresh = self.report.add(seed, small, last if last.differs() else outcome, label, base / "last", alpha_matters)
        print(("NEW  " if fresh else "     ") + f"{seed} {last.line()}{f' [{label}]' if label else ''}", flush=True)

    def again(self, text: str, folder: Path, alpha: bool, outcome: Outcome) -> bool:
        """Returns whether a text differs in the way of `outcome`, and not by rounding."""
        found = try_text(text, folder, self.setup, alpha)
        alike = lambda found: found.alike(outcome) and (found.verdict is None or found.verdict.overlaps(outcome.verdict))
        return alike(found) and alike(without_rounding(text, folder, self.setup, alpha, found, quick=True))

    def count(self, seed: str, alpha: bool, outcome: Outcome, label: str) -> None:
        """Counts an outcome and writes it down, unless both programs agree."""
        level = f" {outcome.verdict.level}" if outcome.kind == "picture" else ""
        key = f"known: {label}" if label else outcome.kind + level + (" (both refuse)" if "both refuse" in outcome.message else "")
        with self.writing:
            self.counts[key] += 1
            total = sum(self.counts.values())
            if outcome.kind != "same":
                with open(self.out / "outcomes.txt", "a") as log:
                    log.write(f"{seed}{' +UA' if alpha else ''} {outcome.line()}{f' [{label}]' if label else ''}\n")
        if total % 50 == 0:
            print(f"-- {total}: {dict(self.counts)}", flush=True)


def main() -> None:
    """Reads the command line and runs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1, help="first seed")
    parser.add_argument("--count", type=int, default=200, help="how many scenes")
    parser.add_argument("--seeds", help="these seeds instead, separated by commas")
    parser.add_argument("--jobs", type=int, default=6, help="scenes at once; POV-Ray mostly sleeps")
    parser.add_argument("--reducers", type=int, default=3, help="scenes reduced at once")
    parser.add_argument("--area", choices=AREAS, help="the part of the language to look at (default: all in turn)")
    parser.add_argument("--whitted", default="target/release/whitted")
    parser.add_argument("--out", default="/tmp/differential")
    parser.add_argument("--limit", type=float, default=8, help="seconds of processor time for each program")
    parser.add_argument("--budget", type=int, default=150, help="texts tried for one reduction")
    parser.add_argument("--minutes", type=float, default=0, help="stop after so long")
    parser.add_argument("--chance", action="store_true", help="also what is chance by nature (jitter)")
    parser.add_argument("--scene", nargs="+", help="only compare these files")
    parser.add_argument("--alpha", action="store_true", help="with --scene: also with +UA")
    parser.add_argument("--print", action="store_true", help="only print the scenes")
    args = parser.parse_args()
    if args.print:
        for seed in range(args.seed, args.seed + args.count):
            print(f"// {args.area or AREAS[seed % len(AREAS)]}:{seed}\n" + scene(Grammar(seed, args.area or AREAS[seed % len(AREAS)], args.chance)).text())
        return
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    run = Run(args)
    if args.scene:
        for path in args.scene:
            for alpha in (False, True) if args.alpha else (False,):
                found = try_text(Path(path).read_text(), run.out / "single", run.setup, alpha)
                print(f"{path}{' +UA' if alpha else ''}: {found.line()}")
        return
    seeds = [int(seed) for seed in args.seeds.split(",")] if args.seeds else range(args.seed, args.seed + args.count)
    with ThreadPoolExecutor(args.jobs) as pool:
        for done in [pool.submit(run.one, seed) for seed in seeds]:
            done.result()
    print(f"{sum(run.counts.values())} scenes: {dict(run.counts)}; {len(run.report.kinds)} kinds reduced; met without reducing again: {dict(run.early)}; see {run.report.folder}/LIST.txt")


if __name__ == "__main__":
    main()
