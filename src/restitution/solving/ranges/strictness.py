"""Inequalities that together are strict: what is not negative, and not zero, is positive."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.oracle import Relation


def strict(inequalities: Sequence[Relation]) -> list[Relation]:
    """Inequalities in which what is not negative, and not zero, is positive: f ≥ 0, |f| > 0."""
    bases = {
        inequality: inequality.value.args[0]
        for inequality in inequalities
        if isinstance(inequality.value, sp.Abs) and inequality.operator in (">", "!=")
    }
    own = {
        other: inequality
        for inequality, base in bases.items()
        for other in inequalities
        if other.operator == ">=" and base in (other.value, -other.value)
    }
    return [
        Relation(inequality.value, ">") if inequality in own else inequality
        for inequality in inequalities
        if inequality not in own.values()
    ]


__all__ = ["strict"]
