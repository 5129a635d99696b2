"""What is proved of an expression by what its letters may be."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Relation,
    Some,
    Verdict,
)
from restitution.oracle.roles import Role
from restitution.solving.algebra.numbers import number_of, plain_sign
from restitution.work import remembered

PROVED = Verdict("proved", "algebra")


UNDECIDED = Verdict("undecided", "undecided")


REFUTED = Verdict("refuted", "witness")


ARCS = (sp.atan, sp.asin, sp.acos, sp.atan2)


_POINTS = 12


LONG = 80


PLAIN_SIGNS = {"≤": "<=", "≥": ">=", "≠": "!="}


def proved_sign(oracle: Oracle, x: sp.Expr) -> int | None:
    """The sign of an expression wherever some facts hold; None if that is open."""
    plain = plain_sign(x)
    if plain is not None:
        return plain
    try:
        return oracle.sign(x)
    except BeyondError:
        return None


@remembered(256)
def admitted_points(
    roles: tuple[tuple[str, Role], ...], facts: tuple[Formula, ...], names: frozenset[str]
) -> tuple[tuple[Point, Mapping[str, Any]], ...]:
    """A few points at which facts hold, with each as numbers of many digits."""
    return tuple(
        (point, {name: number_of(value) for name, value in point.items()})
        for point in Oracle(dict(roles), facts).points(names, _POINTS)
    )


def is_less_than_a_turn(angle: sp.Expr, oracle: Oracle) -> bool:
    """Whether a sum of angles is certain to be between −360° and 360°."""
    low = high = sp.Integer(0)
    for term in sp.Add.make_args(sp.expand(angle)):
        coefficient, atom = term.as_coeff_Mul()
        if isinstance(atom, sp.atan | sp.asin):
            ends = (-sp.pi / 2, sp.pi / 2)
        elif isinstance(atom, sp.acos):
            ends = (sp.Integer(0), sp.pi)
        elif isinstance(atom, sp.atan2):
            ends = (-sp.pi, sp.pi)
        elif atom.is_Symbol:
            role = oracle.roles.get(atom.name)
            if role is None or role.low is None or role.high is None:
                return False
            ends = (role.low, role.high)
        elif not term.free_symbols:
            ends = (atom, atom)
        else:
            return False
        if not coefficient.is_Rational:
            return False
        if proved_sign(oracle, atom) == 1:
            ends = (sp.Max(ends[0], 0), ends[1])
        elif proved_sign(oracle, atom) == -1:
            ends = (ends[0], sp.Min(ends[1], 0))
        products = [coefficient * end for end in ends]
        low, high = low + min(products), high + max(products)
    return bool(-2 * sp.pi < low) and bool(high < 2 * sp.pi)


def renamed_formula(formula: Formula, put: Mapping[sp.Symbol, sp.Symbol]) -> Formula:
    """A formula with other symbols."""
    match formula:
        case Relation(value, operator):
            return Relation(value.xreplace(put), operator)
        case All(parts):
            return All(tuple(renamed_formula(part, put) for part in parts))
        case Some(parts):
            return Some(tuple(renamed_formula(part, put) for part in parts))
