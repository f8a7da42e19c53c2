"""The machinery of the generator: a registry of productions and the source of chance that they draw from.

A new feature is a function of a few lines, anywhere in a `productions_*.py`:

    @production("object", area="shape", weight=2)
    def ovus(g):
        return block("ovus", need(f"{g.positive()}, {g.positive()}"), *g.modifiers())
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass

from tree import Node, leaf

NICE = [-2, -1.5, -1, -0.5, -0.25, 0, 0.25, 0.5, 1, 1, 1.5, 2, 3]
"""Numbers that make faces coincide and patterns meet their own borders."""


@dataclass
class Production:
    """One way to make a node of a sort."""

    make: Callable[[Grammar], Node]
    name: str
    area: str
    weight: float
    nested: bool


REGISTRY: dict[str, list[Production]] = {}
SIMPLEST: dict[str, Callable[[], Node]] = {}
"""For each sort, the plainest node: what the reducer tries in place of any other."""


def production(sort: str, area: str, weight: float = 1.0, nested: bool = False):
    """Registers a function as one way to make a node of `sort`.

    `area` is the part of the language that it tests; asking for that area makes it six times as likely. `nested`
    marks what holds nodes of the same sort and is therefore left out in the depth.
    """

    def register(make):
        REGISTRY.setdefault(sort, []).append(Production(make, make.__name__, area, weight, nested))
        return make

    return register


def simplest(sort: str, make: Callable[[], Node]) -> None:
    """Says what the plainest node of a sort is."""
    SIMPLEST[sort] = make


class Grammar:
    """What productions draw from: chance, the area in focus, and what the scene has declared so far."""

    def __init__(self, seed: int, focus: str, chance: bool = False):
        self.rng = random.Random(f"{focus}:{seed}")
        self.focus = focus
        self.chance = chance
        self.depth = 0
        self.has_gamma = False
        self.version = ""
        self.names: dict[str, list[str]] = {}
        self.includes: set[str] = set()
        self.uv = False

    # Nodes

    def make(self, sort: str) -> Node:
        """Returns a random node of a sort, marked with sort and feature."""
        ways = [p for p in REGISTRY[sort] if not (p.nested and self.depth >= 3)]
        weights = [p.weight * (6 if p.area == self.focus else 1) / (1 + self.depth * p.nested) for p in ways]
        way = self.rng.choices(ways, weights)[0]
        self.depth += 1
        node = way.make(self)
        self.depth -= 1
        node.sort = node.sort or sort
        node.feature = node.feature or way.name
        return node

    def in_focus(self, *areas: str) -> bool:
        """Returns whether one of the areas is the one looked at."""
        return self.focus in areas

    def flip(self, share: float, *areas: str) -> bool:
        """Returns True with the given chance, up to three times as often when one of `areas` is in focus."""
        return self.rng.random() < (min(0.8, share * 3) if self.focus in areas else share)

    def pick(self, *choices):
        """Returns one of the choices."""
        return self.rng.choice(choices)

    def some(self, low: int, high: int) -> range:
        """Returns a range of random length between `low` and `high`."""
        return range(self.rng.randint(low, high))

    def maybe(self, share: float, text: str, feature: str = "") -> list[Node]:
        """Returns a leaf in a list, or an empty list."""
        return [leaf(text, feature=feature)] if self.rng.random() < share else []

    def declare(self, kind: str, name: str) -> None:
        """Notes that the scene has declared `name` as a `kind`."""
        self.names.setdefault(kind, []).append(name)

    def name(self, kind: str) -> str | None:
        """Returns a declared name of the kind, or None."""
        return self.rng.choice(self.names[kind]) if self.names.get(kind) else None

    # Numbers as text

    def number(self, low: float, high: float) -> str:
        """Returns a number between the limits: often a round one, and in the language area an expression."""
        if self.flip(0.04, "language") and (made := self.expression(low, high)):
            return made
        nice = [n for n in NICE if low <= n <= high]
        if nice and self.rng.random() < 0.4:
            return f"{self.rng.choice(nice):g}"
        return f"{self.rng.uniform(low, high):.3g}"

    def expression(self, low: float, high: float) -> str | None:
        """Returns an expression worth about a number between the limits, without a comma at its top level."""
        from productions_language import float_expression

        return float_expression(self, low, high)

    def positive(self, high: float = 1.5) -> str:
        """Returns a number above zero."""
        return self.number(0.1, high)

    def unit(self) -> str:
        """Returns a number between 0 and 1."""
        return self.number(0, 1)

    def integer(self, low: int, high: int) -> str:
        """Returns a whole number."""
        return str(self.rng.randint(low, high))

    def vector(self, low: float, high: float, n: int = 3) -> str:
        """Returns a vector of `n` numbers between the limits."""
        if n == 3 and self.rng.random() < 0.08 and low <= 0 and high >= 1:
            return self.pick("x", "y", "z", "0", "1", "-x")
        return "<" + ",".join(self.number(low, high) for _ in range(n)) + ">"

    def direction(self) -> str:
        """Returns a vector that is not zero."""
        if self.rng.random() < 0.4:
            return self.pick("x", "y", "z", "-x", "-y", "-z", "x+y", "<1,1,1>")
        first = self.pick(-1, 1) * self.rng.uniform(0.3, 1)
        numbers = [f"{first:.2g}", self.number(-1, 1), self.number(-1, 1)]
        self.rng.shuffle(numbers)
        return "<" + ",".join(numbers) + ">"

    def rgb(self) -> str:
        """Returns a plain colour."""
        return "rgb <" + ",".join(f"{self.rng.uniform(0, 1):.2g}" for _ in range(3)) + ">"
