"""Takes a scene apart until nothing can go without the difference going too."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from grammar import SIMPLEST
from tree import Node

NUMBER = re.compile(r"(?<![\w.\"#])-?(?:\d+\.?\d*|\.\d+)(?:e-?\d+)?(?![\w\"])")


@dataclass
class Edit:
    """A change at the node with number `uid`: `change` returns what stands there instead, None for nothing."""

    uid: int
    change: Callable[[Node], Node | None]


class Reducer:
    """One reduction: what holds, how many texts may still be tried, which were."""

    def __init__(self, keeps: Callable[[str, int], bool], workers: int, budget: int):
        self.keeps = keeps
        self.pool = ThreadPoolExecutor(workers)
        self.workers = workers
        self.left = budget
        self.failed: set[str] = set()

    def reduce(self, root: Node) -> Node:
        """Goes through all stages until none of them gets further."""
        stages = [halves, drops, hoists, plainer, drops, inner_words, numbers]
        while self.left > 0:
            before = root.text()
            for stage in stages:
                root = self.run(root, list(stage(root)))
            if root.text() == before:
                break
        self.pool.shutdown()
        return root

    def run(self, root: Node, edits: list[Edit]) -> Node:
        """Tries edits, a few at a time, and returns the tree with all that hold together."""
        while edits and self.left > 0:
            batch: list[tuple[Edit, Node]] = []
            while edits and len(batch) < self.workers:
                edit = edits.pop(0)
                tree = applied(root, edit)
                if tree and tree.text() not in self.failed and tree.text() != root.text():
                    batch.append((edit, tree))
            answers = list(self.pool.map(self.ask, [tree.text() for _, tree in batch], range(self.workers)))
            good = [pair for pair, answer in zip(batch, answers) if answer]
            root = self.combined(root, good)
        return root

    def ask(self, text: str, slot: int) -> bool:
        """Returns whether a text shows the difference, and remembers when it does not."""
        self.left -= 1
        if answer := self.keeps(text, slot):
            return answer
        self.failed.add(text)
        return False

    def combined(self, root: Node, good: list[tuple[Edit, Node]]) -> Node:
        """Returns the tree with all good edits if they hold together, else with the first."""
        if len(good) > 1:
            whole = root
            for edit, _ in good:
                whole = applied(whole, edit) or whole
            if self.ask(whole.text(), 0):
                return whole
        return good[0][1] if good else root


def reduce(root: Node, keeps: Callable[[str, int], bool], workers: int = 6, budget: int = 300) -> Node:
    """Returns the smallest tree found for whose text `keeps(text, slot)` holds.

    `slot` is a number below `workers`, for a folder of one's own. About `budget` texts are tried.
    """
    return Reducer(keeps, workers, budget).reduce(root)


def applied(root: Node, edit: Edit) -> Node | None:
    """Returns a copy with an edit made, or None when its node is gone."""
    fresh = root.copy()
    if fresh.uid == edit.uid:
        return edit.change(fresh)
    for parent in fresh.walk():
        for i, child in enumerate(parent.children):
            if child.uid == edit.uid:
                put = edit.change(child)
                parent.children[i : i + 1] = [put] if put else []
                return fresh
    return None


def halves(root: Node) -> Iterator[Edit]:
    """Yields edits that drop half of a long list, then single large nodes."""
    for node in root.walk():
        free = [c.uid for c in node.children if not c.keep]
        if len(free) >= 4:
            for part in (free[: len(free) // 2], free[len(free) // 2 :]):
                yield Edit(node.uid, lambda old, gone=set(part): without(old, gone))


def without(node: Node, gone: set[int]) -> Node:
    """Returns a node without some of its children."""
    node.children = [c for c in node.children if c.uid not in gone]
    return node


def drops(root: Node) -> Iterator[Edit]:
    """Yields edits that drop a node, large ones first, those marked as needed last.

    A camera stays: at the origin, where it stands by default, too many surfaces meet it.
    """
    order = sorted(root.walk(), key=lambda node: (node.keep, -node.size()))
    fixed = {inner.uid for node in root.walk() if any(i.sort == "camera" for i in node.walk()) for inner in (node, *node.children) if inner.keep or inner is node}
    for node in order:
        if node is not root and node.uid not in fixed:
            yield Edit(node.uid, lambda _: None)


def hoists(root: Node) -> Iterator[Edit]:
    """Yields edits that put a node of the same sort from inside in a node's place, or a directive's content."""
    for node in root.walk():
        for inner in list(node.walk())[1:]:
            if node.sort and inner.sort == node.sort:
                yield Edit(node.uid, lambda _, put=inner: put.copy())
        if node.head.startswith("#") and node.children:
            yield Edit(node.uid, lambda old: Node("", old.children))


def plainer(root: Node) -> Iterator[Edit]:
    """Yields edits that put the plainest node of the sort in a node's place."""
    for node in root.walk():
        if node.sort in SIMPLEST:
            plain = SIMPLEST[node.sort]()
            plain.sort = node.sort
            if len(plain.text()) < len(node.text()):
                yield Edit(node.uid, lambda _, put=plain: put.copy())


def inner_words(root: Node) -> Iterator[Edit]:
    """Yields edits that take a block or a word with its numbers out of a node's own text."""
    for node in root.walk():
        for found in re.finditer(r"\b[a-z_]+ \{[^{}]*\}|\[[^][]*\]|(?<![\w<,]) [a-z_]{3,}(?: [-\d.<][^ a-z]*)?(?= |$)", node.head):
            yield Edit(node.uid, lambda old, head=cut(node.head, found, ""): headed(old, head))


def numbers(root: Node) -> Iterator[Edit]:
    """Yields edits that make a number simpler."""
    for node in root.walk():
        if node.head.startswith("#version"):
            continue
        for found in NUMBER.finditer(node.head):
            for simple in simpler(found.group(0)):
                yield Edit(node.uid, lambda old, head=cut(node.head, found, simple), was=node.head: headed(old, head) if old.head == was else old)


def cut(text: str, found: re.Match, put: str) -> str:
    """Returns a text with something else where a match was."""
    return text[: found.start()] + put + text[found.end() :]


def headed(node: Node, head: str) -> Node:
    """Returns a node with another text of its own."""
    node.head = " ".join(head.split()) if "\n" not in head else head
    return node


def simpler(number: str) -> list[str]:
    """Returns numbers that are shorter to read, the shortest first.

    None becomes 0 or 1 that was not near: that would make faces meet, and one difference turn into another.
    """
    value = float(number)
    ways = [f"{value:.1g}", f"{value:.2g}"] if abs(value) >= 1e-9 else []
    return [way for i, way in enumerate(ways) if len(way) < len(number) and way != number and way not in ways[:i]]
