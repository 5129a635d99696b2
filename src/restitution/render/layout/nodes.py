"""The nodes of a layout: few, frozen, and without a format."""

from __future__ import annotations

from typing import Literal, TypeAlias

from restitution.expression.tree import keeps_hash
from restitution.records import dataclass


class _Node:
    """What every node keeps: texts are looked up by layouts again and again."""

    __slots__ = ("_hash",)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Number(_Node):
    """Digits as printed, without a sign: ``3``, ``0.634``."""

    digits: str


@keeps_hash
@dataclass(frozen=True, slots=True)
class Letter(_Node):
    """A letter in italics; Greek ones go by name (``alpha``)."""

    name: str
    subscript: str = ""


@keeps_hash
@dataclass(frozen=True, slots=True)
class Bold(_Node):
    """An upright bold letter: **i**, **j**, **v** with a subscript, the zero vector **0**."""

    name: str
    subscript: str = ""


@keeps_hash
@dataclass(frozen=True, slots=True)
class Words(_Node):
    """Upright text."""

    text: str


@keeps_hash
@dataclass(frozen=True, slots=True)
class Sum(_Node):
    """Terms with their signs; one term with a minus is a negative quantity."""

    terms: tuple[tuple[Literal["+", "-"], Layout], ...]


@keeps_hash
@dataclass(frozen=True, slots=True)
class Product(_Node):
    """Factors side by side, or with ``×`` or ``·`` between them."""

    factors: tuple[Layout, ...]
    sign: Literal["", "×", "·"] = ""


@keeps_hash
@dataclass(frozen=True, slots=True)
class Fraction(_Node):
    """One thing above another."""

    above: Layout
    below: Layout


@keeps_hash
@dataclass(frozen=True, slots=True)
class Root(_Node):
    """A root; the index is 2 for the square root, and then not printed."""

    inside: Layout
    index: int = 2


@keeps_hash
@dataclass(frozen=True, slots=True)
class Power(_Node):
    """A base with an exponent."""

    base: Layout
    exponent: Layout


@keeps_hash
@dataclass(frozen=True, slots=True)
class Function(_Node):
    """A named function; the power stands after the name, as in sin²α."""

    name: str
    argument: Layout
    power: Layout | None = None


@keeps_hash
@dataclass(frozen=True, slots=True)
class Brackets(_Node):
    """Round brackets, or the bars of an absolute value."""

    inside: Layout
    kind: Literal["()", "||"] = "()"


@keeps_hash
@dataclass(frozen=True, slots=True)
class Degrees(_Node):
    """A number of degrees."""

    inside: Layout


@keeps_hash
@dataclass(frozen=True, slots=True)
class Percent(_Node):
    """A percentage."""

    inside: Layout


@keeps_hash
@dataclass(frozen=True, slots=True)
class Coordinates(_Node):
    """Things in round brackets with commas between: (3, −4)."""

    items: tuple[Layout, ...]


@keeps_hash
@dataclass(frozen=True, slots=True)
class Relation(_Node):
    """A chain: ``signs[k]`` (one of ``= ≠ < ≤ > ≥ ≈ →``) stands between operands k and k + 1."""

    operands: tuple[Layout, ...]
    signs: tuple[str, ...]


@keeps_hash
@dataclass(frozen=True, slots=True)
class Phrase(_Node):
    """Things side by side with a separator of words between: ``e = 0 or e = 1``."""

    items: tuple[Layout, ...]
    separator: str = " "


Layout: TypeAlias = (
    Number
    | Letter
    | Bold
    | Words
    | Sum
    | Product
    | Fraction
    | Root
    | Power
    | Function
    | Brackets
    | Degrees
    | Percent
    | Coordinates
    | Relation
    | Phrase
)
# Numbers with more bits than this are rounded, as nobody reads their digits.
LONGEST = 400
ONE = Number("1")
ZERO_VECTOR = Bold("0")
SIGNS = {"<=": "≤", ">=": "≥", "==": "=", "!=": "≠"}
