"""A student's working as data: its lines, and every way in which each of them can be read.

Trees are those of the statement language. A letter of the student's is a `Letter`; so is a phrase
that names a quantity (``speed of A``, ``KE lost``), with its words as its name: no letter has a
blank in it. What letters and phrases mean is decided later (`letters`).
"""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction
from typing import Literal

from restitution.expression.tree import Degrees, Expression, Number, Place
from restitution.records import dataclass

Sign = Literal["=", "<", "<=", ">", ">=", "!="]
LineKind = Literal["relations", "declaration", "heading", "remark", "crossed", "unread"]


class InScript(Place):
    """Where something stands in a script; what statements and templates say has another place."""

    __slots__ = ()


def column_of(tree: Expression) -> int | None:
    """The column at which a number of a script stands; None of anything else."""
    is_number = isinstance(tree, Number | Degrees)
    return tree.place.column if is_number and isinstance(tree.place, InScript) else None


@dataclass(frozen=True)
class Decimal:
    """A decimal as typed: its value, how many figures it has, and half a unit of its last place.

    ``column`` is that of its `Number` in the tree (``Number.place``), counted from 1.
    """

    column: int
    value: Fraction
    figures: int
    half_unit: Fraction

    def half_unit_of(self, number: Fraction) -> Fraction:
        """Half a unit where a reading has another number here: 12.3, and not 0.123, for 12.3%."""
        return self.half_unit * number / self.value if self.value else self.half_unit


@dataclass(frozen=True)
class Claim:
    """A relation in one reading; ``others`` are further right sides: ``x = a or b``, ``x = ±a``."""

    left: Expression
    sign: Sign
    right: Expression
    others: tuple[Expression, ...] = ()

    def leads_to(self, behind: Claim) -> bool:
        """Whether another relation goes on from this one in a chain.

        In ``f > 3/5 so 3/5 < f`` the sign turns, and no chain is meant.
        """
        turns = {self.sign[0], behind.sign[0]} == {"<", ">"}
        return self.right == behind.left and not turns


@dataclass(frozen=True)
class Link:
    """A relation of a line, the most natural reading first.

    A chain ``a = b = c`` is two links. ``start`` and ``end`` are columns of the line.
    ``supposed`` is the case in which it is to hold: ``e = 0: v = u/2``.
    """

    readings: tuple[Claim, ...]
    start: int
    end: int
    decimals: tuple[Decimal, ...] = ()
    supposed: tuple[Claim, ...] = ()


@dataclass(frozen=True)
class Declaration:
    """``let v = component of A along i after``: what a letter is to mean.

    ``meanings`` are the quantities that the words may name, as trees, the most natural first; a
    vector or an expression of letters declares by its value. ``words`` are as typed.
    """

    letter: str
    meanings: tuple[Expression, ...]
    words: str


@dataclass(frozen=True)
class Scope:
    """What the lines below a heading are about; None where the heading does not say it.

    ``event`` is the number of an event of the story, ``body`` a sphere, ``case`` a number that
    grows with every new case.
    """

    event: int | None = None
    body: str | None = None
    case: int | None = None
    stage: Literal["before", "after"] | None = None


ANYWHERE = Scope()


@dataclass(frozen=True)
class ScriptLine:
    """A line as typed. ``values`` are the numbers and expressions of a remark.

    ``supposed`` are the relations behind *if* and *when*, which it does not claim.
    ``fault`` and ``column`` say what was expected, and where, in a line that cannot be read.
    """

    number: int
    text: str
    kind: LineKind
    part: str | None = None
    scope: Scope = ANYWHERE
    links: tuple[Link, ...] = ()
    declarations: tuple[Declaration, ...] = ()
    values: tuple[Expression, ...] = ()
    supposed: tuple[Claim, ...] = ()
    fault: str | None = None
    column: int | None = None


@dataclass(frozen=True)
class Script:
    """A working: its lines, numbered from 1 as typed, blank lines counted and left out.

    ``literal`` is the working read without `a` for α and the like, where a letter was read so.
    """

    lines: tuple[ScriptLine, ...]
    literal: Script | None = field(default=None, compare=False)

    def of(self, part: str | None) -> Script:
        """The lines that belong to a part; all of them where the script opens no part."""
        if all(line.part is None for line in self.lines):
            return self
        literal = None if self.literal is None else self.literal.of(part)
        return Script(tuple(line for line in self.lines if line.part == part), literal)
