"""Scenes as trees: what a generator builds, a reducer takes apart and a printer turns into text."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field


@dataclass
class Node:
    """A piece of a scene: `head`, then its children, then `tail`.

    `sort` says in which places the node may stand ("object", "pigment body", ...): a node can be replaced by any
    other of its sort. `feature` names the production that made it; what is left of these after reduction tells
    differences apart. `keep` marks what the node around it cannot do without. `uid` stays with a node through copies.
    """

    head: str
    children: list[Node] = field(default_factory=list)
    tail: str = ""
    sort: str = ""
    feature: str = ""
    keep: bool = False
    uid: int = field(default_factory=itertools.count().__next__)

    def copy(self) -> Node:
        """Returns the whole tree anew, so that changes do not reach the original."""
        children = [child.copy() for child in self.children]
        return Node(self.head, children, self.tail, self.sort, self.feature, self.keep, self.uid)

    def walk(self) -> Iterator[Node]:
        """Yields the node and all below it, outer ones first."""
        yield self
        for child in self.children:
            yield from child.walk()

    def size(self) -> int:
        """Returns the number of nodes."""
        return sum(1 for _ in self.walk())

    def text(self, indent: int = 0) -> str:
        """Returns the scene text of the node, a line for each head, child and tail."""
        inner = indent + 2 if self.head else indent
        parts = [" " * indent + self.head] if self.head else []
        parts += [child.text(inner) for child in self.children]
        parts += [" " * indent + self.tail] if self.tail else []
        text = "\n".join(part for part in parts if part.strip())
        flat = " ".join(line.strip() for line in text.splitlines())
        return " " * indent + flat if len(flat) + indent <= 100 and "#" not in flat and "//" not in flat else text


def leaf(text: str, keep: bool = False, feature: str = "", sort: str = "") -> Node:
    """Returns a node of text alone."""
    return Node(text, keep=keep, feature=feature, sort=sort)


def need(text: str, feature: str = "") -> Node:
    """Returns a leaf that the node around it cannot do without."""
    return Node(text, keep=True, feature=feature)


def block(word: str, *children: Node, sort: str = "", feature: str = "", keep: bool = False) -> Node:
    """Returns `word { children }`."""
    return Node(word + " {", list(children), "}", sort, feature, keep)


def group(*children: Node, sort: str = "", feature: str = "", keep: bool = False) -> Node:
    """Returns children one after the other without anything around them."""
    return Node("", list(children), "", sort, feature, keep)


def features(root: Node) -> list[str]:
    """Returns the names of the productions that a tree still holds, sorted."""
    return sorted({node.feature for node in root.walk() if node.feature})
