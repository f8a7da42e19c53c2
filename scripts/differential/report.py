"""Writes what was found: a folder for each kind, and a list."""

from __future__ import annotations

import json
import shutil
import threading
from pathlib import Path

from programs import Outcome
from tree import Node, features

RANK = ["crash", "we hang", "only we refuse", "only POV-Ray refuses", "picture"]
LEVEL = ["differs", "alike", "close", "slight"]


class Report:
    """Collects finds; two with the same outcome and the same features left are one kind."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.folder.mkdir(parents=True, exist_ok=True)
        self.lock = threading.Lock()
        self.kinds: dict[str, list[str]] = {}
        self.entries: dict[str, tuple[int, str]] = {}

    def add(self, seed: str, root: Node, outcome: Outcome, label: str, work: Path, alpha: bool) -> bool:
        """Notes a reduced scene with the pictures in `work`; returns whether its kind is new.

        `label` names the known difference that it shows, if any.
        """
        text = root.text()
        key = label or f"{outcome.kind} {outcome.verdict.level if outcome.verdict else outcome.message[:50]}: {', '.join(features(root))}"
        with self.lock:
            fresh = key not in self.kinds
            self.kinds.setdefault(key, []).append(seed)
            if fresh:
                self.keep(seed, text, key, outcome, work, alpha, bool(label))
            self.write()
        return fresh

    def keep(self, seed: str, text: str, key: str, outcome: Outcome, work: Path, alpha: bool, listed: bool) -> None:
        """Copies scene and pictures of a new kind to the report's folder."""
        place = self.folder / seed.replace(":", "-")
        place.mkdir(exist_ok=True)
        (place / "scene.pov").write_text(text + "\n")
        for name in ("theirs.exr", "ours.exr"):
            if (work / name).exists():
                shutil.copy(work / name, place / name)
        line = f"{seed}{' +UA' if alpha else ''} {outcome.line()} [{key}]"
        (place / "summary.txt").write_text(line + "\n")
        rank = RANK.index(outcome.kind) * 10 + (LEVEL.index(outcome.verdict.level) if outcome.verdict else 0) + 1000 * listed
        self.entries[key] = (rank, f"{line}\n{text}")

    def write(self) -> None:
        """Writes the list, worst first."""
        rows = sorted(self.entries.items(), key=lambda item: (item[1][0], -len(self.kinds[item[0]])))
        body = [f"== {len(self.kinds[key])} times: {text}\n" for key, (_, text) in rows]
        (self.folder / "LIST.txt").write_text("\n".join(body))
        (self.folder / "kinds.json").write_text(json.dumps(self.kinds, indent=1))
