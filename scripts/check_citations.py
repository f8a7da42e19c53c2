"""Checks that what is cited about POV-Ray stands in docs/povray, and that nothing is cited in another form.

A citation names a page of docs/povray and a section of it, in one of two forms:

    language facts, section 15            sections 5.2 to 5.5 of the function facts

A page may also be named without a section ("the shape facts"); within a page "section 4" is one of its own. Comments of any length and paragraphs of Markdown are
read as one line, so that a citation may be broken anywhere. Prints what is wrong and exits with 1, or says how many
citations hold.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE_FOLDER = ROOT / "docs" / "povray"
PAGES = {
    "language": "language.md",
    "function": "functions.md",
    "camera": "camera-and-image.md",
    "camera and image": "camera-and-image.md",
    "command line": "command-line.md",
    "shape": "shapes-analytic.md",
    "freeform": "shapes-freeform.md",
    "shading": "shading.md",
    "pattern": "patterns.md",
    "photon": "photons.md",
    "radiosity": "radiosity.md",
    "subsurface": "subsurface.md",
}
PLACES = ["src", "tests", "benches", "golden", "scripts", "docs", "examples", "fuzz", "grammar", ".ci"]
SUFFIXES = {".rs", ".py", ".sh", ".md", ".pov", ".inc", ".toml", ".txt", ".pest", ""}

NAME = "(?:" + "|".join(sorted(PAGES, key=len, reverse=True)) + ")"
NUMBER = r"\d+(?:\.\d+)*"
NUMBERS = rf"{NUMBER}(?:(?:, (?:and )?| and | to ){NUMBER})*"
CITED = re.compile(
    rf"\b(?P<before>{NAME}) facts, sections? (?P<numbers_after>{NUMBERS})"
    rf"|\bsections? (?P<numbers_before>{NUMBERS}) of the (?P<after>{NAME}) facts\b",
    re.IGNORECASE,
)
NAMED = re.compile(rf"\b{NAME} facts\b", re.IGNORECASE)
# Whatever else looks as if it meant a section of the facts.
ODD = re.compile(
    rf"\bfacts? files?\b|\bfacts?,? (?:§ ?)?{NUMBER}|\bfacts, (?!section)[a-z-]+, section"
    rf"|\bsections? {NUMBERS} of the (?!{NAME} facts\b)[a-z -]{{0,40}}facts\b",
    re.IGNORECASE,
)
# A section of the page itself, in a page.
OWN = re.compile(rf"(?<!facts, )\bsections? (?P<numbers>{NUMBERS})(?! of the {NAME} facts)", re.IGNORECASE)
COMMENT = re.compile(r"^\s*(?://[/!]?|#+|%+)\s?(.*)$")


def passages(path: Path):
    """Yields (line number, text): each run of comment lines, or each paragraph of Markdown, as one line."""
    lines = path.read_text(errors="replace").splitlines()
    markdown = path.suffix == ".md"
    start, words = 1, []
    for number, line in enumerate(lines, 1):
        comment = line if markdown else (m := COMMENT.match(line)) and m.group(1)
        if comment is None or not comment.strip():
            if words:
                yield start, " ".join(words)
            words = []
            # A comment behind code stands alone.
            if not markdown and "//" in line:
                yield number, line.split("//", 1)[1]
            continue
        if not words:
            start = number
        words.append(comment.strip())
    if words:
        yield start, " ".join(words)


def numbers(text: str):
    """All sections of "3.5, 3.6 and 4" or "5.2 to 5.5"."""
    items = re.findall(rf"(?:(to) )?({NUMBER})", text)
    for i, (to, item) in enumerate(items):
        if to:
            *stem, first = items[i - 1][1].split(".")
            last = item.split(".")[-1]
            yield from (".".join([*stem, str(n)]) for n in range(int(first) + 1, int(last) + 1))
        else:
            yield item


def sections(page: str) -> set[str]:
    """The numbers in the headings of a page."""
    text = (PAGE_FOLDER / page).read_text()
    return set(re.findall(rf"^#+ ({NUMBER})\b", text, re.MULTILINE))


def files():
    """Every text in which something may be cited; the pages themselves cite one another."""
    yield from sorted(ROOT.glob("*.md"))
    for place in PLACES:
        for path in sorted((ROOT / place).rglob("*")):
            if path.is_file() and path.suffix in SUFFIXES and path.resolve() != Path(__file__).resolve():
                yield path


def main() -> int:
    known = {page: sections(page) for page in set(PAGES.values())}
    wrong, held = [], 0
    for path in files():
        for line, text in passages(path):
            place = f"{path.relative_to(ROOT)}:{line}"
            for cited in CITED.finditer(text):
                name = (cited["before"] or cited["after"]).lower()
                for number in numbers(cited["numbers_after"] or cited["numbers_before"]):
                    held += 1
                    if number not in known[PAGES[name]]:
                        wrong.append(f"{place}: docs/povray/{PAGES[name]} has no section {number}")
            held += len(NAMED.findall(text)) - len(CITED.findall(text))
            if path.parent == PAGE_FOLDER and path.name in known:
                for own in OWN.finditer(text):
                    for number in numbers(own["numbers"]):
                        if number not in known[path.name]:
                            wrong.append(f"{place}: this page has no section {number}")
            for odd in ODD.finditer(text):
                wrong.append(f"{place}: write '<page> facts, section N', not '{odd.group(0)}'")
    for complaint in wrong:
        print(complaint)
    if not wrong:
        print(f"{held} citations of docs/povray hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
