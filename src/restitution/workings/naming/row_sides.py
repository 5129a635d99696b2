"""Sides of a row: with another sign, with either, as alternatives, without doubles."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Relation
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.workings.naming.measured import is_plain
from restitution.workings.naming.sources import is_vector


def turned_side(side: lay.Layout) -> lay.Layout | None:
    """A side of negative terms alone with the other sign; None of another."""
    if not isinstance(side, lay.Sum) or any(sign == "+" for sign, _ in side.terms):
        return None
    return lay.total(lay.Sum((("+", term),)) for _, term in side.terms)


def without_doubles(sides: list[lay.Layout], signs: list[str]) -> None:
    """Leaves out what stands on a side as on one before it, and what leads back to that."""
    for n in range(len(sides) - 1, 1, -1):
        first = sides.index(sides[n], 1) if n < len(sides) else n
        if first < n:
            del sides[first + 1 : n + 1], signs[first:n]


def are_values(relation: Relation) -> bool:
    """Whether a line gives several values of one scalar or angle."""
    lefts = {links[0].left for links in relation.options}
    return len(lefts) == 1 < len(relation.options) and all(
        all(link.sign in ("=", "≈") for link in links) and not is_vector(links[0].left)
        for links in relation.options
    )


__all__ = ["are_values", "turned_side", "without_doubles"]


def is_vector_of_short_decimals(value: lay.Layout) -> bool:
    """Whether a vector has two components of numbers with at most two decimals, one or more."""
    if not isinstance(value, lay.Sum) or len(value.terms) != 2 or not is_plain(value):
        return False
    digits: list[str] = []
    for _, term in value.terms:
        match term:
            case lay.Product((lay.Number(size), lay.Bold())):
                digits.append(size)
            case lay.Bold():
                pass
            case _:
                return False
    return any("." in e for e in digits) and all(len(e.partition(".")[2]) <= 2 for e in digits)


def has_decimals(side: lay.Layout) -> bool:
    """Whether a side is written in decimals, to which no zeros need be added."""
    return "." in to_text(side)
