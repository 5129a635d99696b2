"""Units behind a value: which are read, what each measures, and how many of the SI unit it is."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import cache

from restitution.expression.dimensions import (
    ENERGY,
    IMPULSE,
    LENGTH,
    MASS,
    NONE,
    SPEED,
    TIME,
    Dimension,
)
from restitution.records import dataclass

# What a unit of each dimension is called here, and what measures it.
NAMES: Mapping[Dimension, tuple[str, str]] = {
    MASS: ("mass", "kg"),
    LENGTH: ("length", "m"),
    TIME: ("time", "s"),
    SPEED: ("speed", "m/s"),
    IMPULSE: ("impulse", "N s"),
    ENERGY: ("energy", "J"),
    NONE: ("angle", "rad"),
}

_MINUS_ONE = r"[-−–]\s?1"
_POWER = rf"(?:\^|\*\*)?\s?(?:\(\s?{_MINUS_ONE}\s?\)|\{{\s?{_MINUS_ONE}\s?\}}|{_MINUS_ONE})|⁻¹"
_DOT = r"\s?[·⋅∙.]?\s?"
PER_SECOND = rf"{_DOT}s\s?(?:{_POWER})|\s?/\s?s(?:ec)?|\s+per\s+second"
_PER_HOUR = rf"{_DOT}h(?:r|our)?\s?(?:{_POWER})|\s?/\s?h(?:r|our)?|\s+per\s+hour"

# Pattern, dimension, and how many of the SI unit it is.
_KNOWN: tuple[tuple[str, Dimension, Fraction], ...] = (
    (rf"kg{_DOT}m(?:{PER_SECOND})", IMPULSE, Fraction(1)),
    (rf"N{_DOT}s|[Nn]ewton[\s-]?seconds?", IMPULSE, Fraction(1)),
    (rf"(?:km|kilomet(?:re|er)s?)(?:{_PER_HOUR})", SPEED, Fraction(5, 18)),
    (rf"(?:cm|centimet(?:re|er)s?)(?:{PER_SECOND})", SPEED, Fraction(1, 100)),
    (rf"(?:mm|millimet(?:re|er)s?)(?:{PER_SECOND})", SPEED, Fraction(1, 1000)),
    (rf"(?:m|met(?:re|er)s?)(?:{PER_SECOND})|mps", SPEED, Fraction(1)),
    (r"[Kk][Gg]s?|kilograms?|kilos?", MASS, Fraction(1)),
    (r"g|grams?", MASS, Fraction(1, 1000)),
    (r"cm|centimet(?:re|er)s?", LENGTH, Fraction(1, 100)),
    (r"mm|millimet(?:re|er)s?", LENGTH, Fraction(1, 1000)),
    (r"m|met(?:re|er)s?", LENGTH, Fraction(1)),
    (r"s|secs?|seconds?", TIME, Fraction(1)),
    (r"J|[Jj]oules?", ENERGY, Fraction(1)),
    (r"rad|radians?", NONE, Fraction(1)),
)

# Units that people write and that are not read: they are named in a message.
_OTHERS = (
    r"lbs?|pounds?|oz|ounces?|stones?|tonnes?|tons?|mg|ft|feet|foot|inch(?:es)?|yards?|yds?|miles?"
    r"|km|kilomet(?:re|er)s?|mph|kph|kmh|knots?|minutes?|mins?|hours?|hrs?|ms|kJ|MJ|mJ|eV|kcal"
    r"|kN|Nm|N\s+m|N|[Nn]ewtons?"
    rf"|(?:km|ft|feet)(?:{PER_SECOND})|(?:mi|miles?|m|met(?:re|er)s?)(?:{_PER_HOUR})"
    rf"|g{_DOT}c?m(?:{PER_SECOND})|kg{_DOT}km(?:{_PER_HOUR})|kN{_DOT}s|N(?:{PER_SECOND})"
)

_END = r"(?!\w)(?=\s*(?:$|[,)<>=≤≥⩽⩾+\-−–:]|(?:at|from|to|through|radius|over|in|as|[ij])(?!\w)))"


@dataclass(frozen=True, slots=True)
class Measure:
    """A unit: what it measures, and how many of the SI unit it is.

    ``dimension`` is None for a unit that is not read, ``NONE`` for the radian.
    """

    dimension: Dimension | None
    factor: Fraction = Fraction(1)


def at_the_end(text: str, at: int) -> re.Match[str] | None:
    """A unit that ends a value: as long a one as stands there."""
    # The pattern is a long one, and not compiled for a letter with which no unit begins.
    return _at_the_end().match(text, at) if text[at : at + 1] in _FIRST else None


@cache
def _at_the_end() -> re.Pattern[str]:
    every = [pattern for pattern, _, _ in _KNOWN] + [_OTHERS]
    return re.compile("(?:" + "|".join(every) + ")" + _END)


_FIRST = frozenset("cefghijklmnoprstyJKMN")


def like_a_unit(text: str, at: int) -> bool:
    """Whether a product at the end of a value looks like a unit; a letter is no more than that."""
    unit = at_the_end(text, at)
    return unit is not None and unit.group() not in ("g", "m", "s", "J", "N")


@cache
def _known() -> tuple[tuple[re.Pattern[str], Measure], ...]:
    return tuple((re.compile(text), Measure(one, factor)) for text, one, factor in _KNOWN)


def measure(unit: str) -> Measure:
    """What a unit is, by its text."""
    for pattern, known in _known():
        if pattern.fullmatch(unit):
            return known
    return Measure(None)


def letters_of(unit: str) -> frozenset[str]:
    """The letters of which a unit could be a product; none for one that is a word."""
    runs = re.findall(r"[A-Za-z]+", unit)
    if any(len(run) > 3 or run in ("rad", "sec", "per") for run in runs):
        return frozenset()
    return frozenset("".join(runs))
