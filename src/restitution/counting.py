"""Numbers of things, their order and lists of them, in words."""

from __future__ import annotations

from collections.abc import Sequence

_ORDINALS = (
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "sixth",
    "seventh",
    "eighth",
    "ninth",
    "tenth",
)


def counted(number: int, noun: str) -> str:
    """``1 sphere``, ``2 spheres``."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def ordinal(number: int) -> str:
    """``first``, ``second``, …; ``11th`` where words grow long."""
    if number <= len(_ORDINALS):
        return _ORDINALS[number - 1]
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{'th' if 10 < number % 100 < 14 else ending}"


def listed(words: Sequence[str], link: str = "and") -> str:
    """``a``, ``a and b``, ``a, b and c``; nothing where there is none."""
    *most, last = words or ("",)
    before = "" if link.startswith(",") else " "
    return f"{', '.join(most)}{before}{link} {last}" if most else last
