"""Runs both programs on a text and says in which way they differ."""

from __future__ import annotations

import re
import signal
import subprocess
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

import verdict


@dataclass
class Setup:
    """Which programs, which size, and where files lie."""

    whitted: str = "target/release/whitted"
    povray: str = "povray"
    width: int = 64
    height: int = 48
    limit: float = 20.0
    assets: Path = Path("assets")
    include: str = "/usr/share/povray-3.7/include"
    extra: list[str] = field(default_factory=list)


@dataclass
class Outcome:
    """What came of a text.

    `kind` is "same", "rounding" (`rounding.py`), "picture", "only POV-Ray refuses", "only we refuse", "crash",
    "we hang", "skipped" (POV-Ray crashed or took too long, or both refuse); `message` holds the error of whoever
    refused.
    """

    kind: str
    message: str = ""
    verdict: verdict.Verdict | None = None
    seconds: tuple[float, float] = (0.0, 0.0)

    def differs(self) -> bool:
        """Returns whether this is worth a report."""
        return self.kind not in ("same", "rounding", "skipped")

    def alike(self, other: Outcome) -> bool:
        """Returns whether both show a difference of one kind."""
        return self.kind == other.kind and shape(self.message) == shape(other.message)

    def line(self) -> str:
        """Returns the outcome in a line."""
        return f"{self.kind}: {self.verdict.line() if self.verdict else self.message}"


def shape(message: str) -> str:
    """Returns an error message without its numbers, names and places."""
    return re.sub(r"'[^']*'|`[^`]*`|\"[^\"]*\"|[-\d.]+", "*", message)[:60]


# POV-Ray sleeps most of its 0.7 s: many may sleep at once, few may work.
WORKING = threading.Semaphore(2)


@dataclass
class Done:
    """What a program did: exit code (None when it took too long), messages, seconds, and where its picture is, if any."""

    code: int | None
    messages: str
    seconds: float
    picture: Path | None = None


def render(command: list[str], text: str, picture: Path, limit: float) -> Done:
    """Runs a program on a text, in the folder of the picture that it makes.

    `limit` is processor time, so that a busy machine does not look like a slow program; eight times that is the end.
    """
    picture.parent.mkdir(parents=True, exist_ok=True)
    (picture.parent / "scene.pov").write_text(text)
    picture.unlink(missing_ok=True)
    start = time.monotonic()
    bounded = ["prlimit", f"--cpu={limit:.0f}", "nice", "-n", "10", *command]
    try:
        done = subprocess.run(bounded, cwd=picture.parent, capture_output=True, timeout=8 * limit, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return Done(None, "took too long", limit)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return Done(None, "took too long", limit)
    messages = (done.stderr + done.stdout).decode(errors="replace")
    return Done(done.returncode, messages, time.monotonic() - start, picture if done.returncode == 0 and picture.exists() else None)


def try_text(text: str, folder: Path, setup: Setup, alpha: bool = False) -> Outcome:
    """Renders a text with both programs in `folder` and compares what comes out."""
    theirs = render_theirs(text, folder, setup, alpha)
    ours = render_ours(text, folder, setup, alpha)
    outcome = judge(theirs.code, theirs.messages, ours.code, ours.messages, folder)
    outcome.seconds = (theirs.seconds, ours.seconds)
    return outcome


def render_theirs(text: str, folder: Path, setup: Setup, alpha: bool) -> Done:
    """Renders a text with POV-Ray to `theirs.exr` in `folder`."""
    size = [f"+W{setup.width}", f"+H{setup.height}"]
    command = [setup.povray, "+Iscene.pov", "+Otheirs.exr", "+FE", *size, "-A", "-D", "-P", "-V", "+WT1", "-GS", "-GR", "-GD", f"+L{setup.include}", f"+L{setup.assets}", *(["+UA"] if alpha else [])]
    return render(command, text, folder / "theirs.exr", setup.limit)


def render_ours(text: str, folder: Path, setup: Setup, alpha: bool) -> Done:
    """Renders a text with whitted to `ours.exr` in `folder`."""
    command = [setup.whitted, "render", "scene.pov", "--output", "ours.exr", "-W", str(setup.width), "-H", str(setup.height), "-a", "off", "-t", "1", "--isosurface-search", "povray", "-I", setup.include, "-I", str(setup.assets), *(["--alpha"] if alpha else []), *setup.extra]
    with WORKING:
        return render(command, text, folder / "ours.exr", setup.limit)


def judge(their_code: int | None, their_text: str, our_code: int | None, our_text: str, folder: Path) -> Outcome:
    """Says what exit codes, messages and pictures mean."""
    if our_code is not None and (our_code < 0 or our_code > 2 or "panicked" in our_text):
        return Outcome("crash", first(our_text, r"panicked at .*(?:\n.*)?") or f"exit code {our_code}")
    if their_code is None or their_code not in (0, 1):
        return Outcome("skipped", f"POV-Ray: {their_code}")
    if our_code is None:
        return Outcome("we hang" if their_code == 0 else "skipped", "took too long")
    their_error = first(re.sub(r"\n ", " ", their_text), r"(?<!Possible )(?:Parse|Fatal) Error: .*|Fatal error.*")
    our_error = first(our_text, r"(?:^|\n)(?:error[^\n]*|\S*error:[^\n]*)").strip()
    if their_code != 0 and our_code != 0:
        return Outcome("skipped", f"both refuse: {their_error} | {our_error}")
    if their_code != 0:
        return Outcome("only POV-Ray refuses", their_error)
    if our_code != 0:
        return Outcome("only we refuse", our_error or our_text[-200:])
    found = verdict.compare(folder / "theirs.exr", folder / "ours.exr")
    return Outcome("same" if found.level == "same" else "picture", verdict=found)


def first(text: str, pattern: str) -> str:
    """Returns the first place that matches, on one line, or nothing."""
    found = re.search(pattern, text)
    return " ".join(found.group(0).split()) if found else ""
