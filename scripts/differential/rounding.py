"""Tells rounding from rules: where POV-Ray's own picture flips when its input changes by less than anybody sees.

A face that lies in a pattern's border, a ray along an edge and a search that ends by chance have no right answer: the
last bits decide, and moving the camera by a hundred-millionth decides anew. Where that changes POV-Ray's own pixels,
another program's pixels may differ as well.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import verdict
from programs import Outcome, Setup, render_ours, render_theirs

MOVES = ["<1.3,.7,-.9>", "<-.8,-1.1,.6>", "<.4,-1.7,-.8>", "<-1.6,.9,.7>"]
"""Directions of the changes: no axis, no diagonal."""

SIZES = ["e-8", "e-9", "e-7"]
"""Sizes of the changes, in units of scenes a few units wide and in degrees."""


def without_rounding(text: str, folder: Path, setup: Setup, alpha: bool, outcome: Outcome, quick: bool = False) -> Outcome:
    """Returns what is left of a difference between the pictures in `folder` where rounding explains some of it.

    Rounding explains a pixel that a change moves in POV-Ray's picture, and one next to it where ours moves to
    POV-Ray's colour. What is left is another outcome, of kind "rounding" when nobody would see it. `quick` tries only
    two changes; else changes of one size after the other are tried for as long as they explain anything.
    """
    if outcome.kind != "picture" or outcome.verdict.why:
        return outcome
    theirs, ours = verdict.load(folder / "theirs.exr"), verdict.load(folder / "ours.exr")
    loose, reached = np.zeros(theirs.shape[:2], bool), np.zeros(theirs.shape[:2], bool)
    left = outcome

    def moved(change: str, slot: int) -> tuple[Path | None, Path | None]:
        work = folder / f"rounding{slot}"
        return render_theirs(change, work, setup, alpha).picture, render_ours(change, work, setup, alpha).picture

    for size in SIZES:
        several = list(itertools.islice(changes(text, size), 2 if quick else None))
        with ThreadPoolExecutor(len(several)) as pool:
            for their_picture, our_picture in pool.map(moved, several, itertools.count()):
                if their_picture and our_picture:
                    loose |= verdict.off(theirs, verdict.load(their_picture))
                    reached |= ~verdict.off(theirs, verdict.load(our_picture))
        found = verdict.judge(theirs, np.where((loose | (near(loose) & reached))[..., None], theirs, ours))
        if found.level == "same":
            return Outcome("rounding", verdict=outcome.verdict, seconds=outcome.seconds)
        if quick or found.count > 0.95 * left.verdict.count:
            break
        left = Outcome("picture", verdict=found, seconds=outcome.seconds)
    return left


def near(mask: np.ndarray) -> np.ndarray:
    """Returns where a pixel or one at most two away is in the mask."""
    wide = np.pad(mask, 2)
    height, width = mask.shape
    return np.any([wide[dy : dy + height, dx : dx + width] for dy in range(5) for dx in range(5)], axis=0)


def changes(text: str, size: str) -> Iterator[str]:
    """Yields a scene with changes far below what is seen: of its camera, and of its textures upon their objects."""
    for i, move in enumerate(MOVES):
        turned = ended(text, r"\bcamera \{", f" rotate {move}*1{size} translate {move}*1{size}")
        yield ended(turned, r"\b(pigment|texture|normal) \{", f" translate {move}*1{size}") if i % 2 else turned


def ended(text: str, head: str, put: str) -> str:
    """Returns a text in which every block that begins with `head` ends with `put`."""
    parts, stack, at = [], [], 0
    for found in re.finditer(r'"(?:\\.|[^"\\])*"|' + head + r"|[{}]", text):
        token = found.group(0)
        if token[-1] == "{":
            stack.append(len(token) > 1)
        elif token == "}" and stack and stack.pop():
            parts += [text[at : found.start()], put + " "]
            at = found.start()
    return "".join([*parts, text[at:]])
