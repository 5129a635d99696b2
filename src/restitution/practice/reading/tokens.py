"""The tokens of a line of working, and how a script uses its letters."""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction

from restitution.records import dataclass


@dataclass(frozen=True)
class Token:
    """A token: its kind, its text, and the offsets at which it begins and ends in the plain line.

    ``gap`` counts the blanks before it. A number has a ``value``, a letter its canonical ``name``.
    """

    kind: str
    text: str
    start: int
    end: int
    column: int
    gap: int = 0
    name: str = ""
    value: Fraction = Fraction(0)

    @property
    def word(self) -> str:
        """What it is as a word, in small letters."""
        return self.name if self.kind == "word" and self.name else self.text.lower()


@dataclass(frozen=True)
class Usage:
    """How a question and a script use names and letters.

    ``letters`` are those of the question, ``angles`` the letters that are angles, ``vectors``
    those that are vectors; ``alone`` the Latin letters that stand alone in the script. ``aliases``
    are the letters that stand for others (``a`` for ``alpha``), ``counted`` those that the script
    has with a 1 behind them. ``times`` is whether an x is a
    sign, ``joules`` whether a J may be a letter, ``metres`` whether an m directly behind a number
    is no mass; a 2 behind one of the ``squares`` is a power, and
    so is one behind ``sin`` where ``powers``.
    """

    spheres: frozenset[str] = frozenset()
    walls: frozenset[str] = frozenset()
    points: frozenset[str] = frozenset()
    letters: frozenset[str] = frozenset()
    angles: frozenset[str] = frozenset()
    vectors: frozenset[str] = frozenset()
    alone: frozenset[str] = frozenset()
    aliases: dict[str, str] = field(default_factory=dict, hash=False)
    counted: frozenset[str] = frozenset()
    times: bool = True
    joules: bool = False
    metres: bool = False
    squares: frozenset[str] = frozenset()
    powers: bool = False

    @property
    def names(self) -> frozenset[str]:
        """The names of spheres, walls and points."""
        return self.spheres | self.walls | self.points
