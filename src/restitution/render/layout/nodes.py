"""The nodes of a layout: few, frozen, and without a format."""

from __future__ import annotations

from typing import Literal, TypeAlias

from restitution.records import dataclass


@dataclass(frozen=True, slots=True)
class Number:
    """Digits as printed, without a sign: ``3``, ``0.634``."""

    digits: str


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter in italics; Greek ones go by name (``alpha``)."""

    name: str
    subscript: str = ""


@dataclass(frozen=True, slots=True)
class Bold:
    """An upright bold letter: **i**, **j**, **v** with a subscript, the zero vector **0**."""

    name: str
    subscript: str = ""


@dataclass(frozen=True, slots=True)
class Words:
    """Upright text."""

    text: str


@dataclass(frozen=True, slots=True)
class Sum:
    """Terms with their signs; one term with a minus is a negative quantity."""

    terms: tuple[tuple[Literal["+", "-"], Layout], ...]


@dataclass(frozen=True, slots=True)
class Product:
    """Factors side by side, or with ``×`` or ``·`` between them."""

    factors: tuple[Layout, ...]
    sign: Literal["", "×", "·"] = ""


@dataclass(frozen=True, slots=True)
class Fraction:
    """One thing above another."""

    above: Layout
    below: Layout


@dataclass(frozen=True, slots=True)
class Root:
    """A root; the index is 2 for the square root, and then not printed."""

    inside: Layout
    index: int = 2


@dataclass(frozen=True, slots=True)
class Power:
    """A base with an exponent."""

    base: Layout
    exponent: Layout


@dataclass(frozen=True, slots=True)
class Function:
    """A named function; the power stands after the name, as in sin²α."""

    name: str
    argument: Layout
    power: Layout | None = None


@dataclass(frozen=True, slots=True)
class Brackets:
    """Round brackets, or the bars of an absolute value."""

    inside: Layout
    kind: Literal["()", "||"] = "()"


@dataclass(frozen=True, slots=True)
class Degrees:
    """A number of degrees."""

    inside: Layout


@dataclass(frozen=True, slots=True)
class Percent:
    """A percentage."""

    inside: Layout


@dataclass(frozen=True, slots=True)
class Coordinates:
    """Things in round brackets with commas between: (3, −4)."""

    items: tuple[Layout, ...]


@dataclass(frozen=True, slots=True)
class Relation:
    """A chain: ``signs[k]`` (one of ``= ≠ < ≤ > ≥ ≈ →``) stands between operands k and k + 1."""

    operands: tuple[Layout, ...]
    signs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Phrase:
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
