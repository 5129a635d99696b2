"""Sides of a row: with the other sign, and without those that say the same."""

from __future__ import annotations

from restitution.render import layout as lay


def turned_side(side: lay.Layout) -> lay.Layout | None:
    """A side of negative terms alone with the other sign; None of another."""
    if not isinstance(side, lay.Sum) or any(sign == "+" for sign, _ in side.terms):
        return None
    return lay.total(lay.Sum((("+", term),)) for _, term in side.terms)


def without_doubles(sides: list[lay.Layout], signs: list[str]) -> None:
    """Leaves out what stands on a side as on the one before it."""
    for n in range(len(sides) - 1, 1, -1):
        if sides[n] == sides[n - 1]:
            del sides[n], signs[n - 1]


__all__ = ["turned_side", "without_doubles"]
