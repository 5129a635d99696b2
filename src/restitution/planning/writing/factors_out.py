"""An equation without the ratios of an angle that both sides have, before it is solved.

Where components are in proportion both sides have sin α cos α: what is left is a line of its own.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Relation, equality
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Binary, Expression, has_quantity
from restitution.oracle import Oracle
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.lines_in_two import number_above, with_two_for


def with_factors_out(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a square of a ratio is solved for below the equation without."""
    for line in derivation.lines:
        left_over = _without_common(derivation, line)
        if left_over is None:
            continue
        above = replace(line, number=number_above(derivation), relation=left_over)
        for premises in ((above.number,), (above.number, *line.premises[1:])):
            below = replace(line, premises=premises)
            whole = with_two_for(derivation, line, (above, below), oracle)
            if whole is not None:
                return whole
    return derivation


def _without_common(derivation: Derivation, line: Line) -> Relation | None:
    """The equation above a square of a ratio without the ratios that both its sides have."""
    match line.move, line.relation:
        case Move("rearrange", None), Relation(((Link(Binary("^"), "=", _),),)):
            base = derivation.line(line.premises[0])
        case _:
            return None
    match None if base is None else base.relation:
        case Relation(((Link(Binary("*") as left, "=", Binary("*") as right),),)):
            sides = [_factors(left), _factors(right)]
        case _:
            return None
    one, other = sides
    if one is None or other is None:
        return None
    common = {own: min(n, other.get(own, 0)) for own, n in one.items()}
    common = {own: n for own, n in common.items() if n > 0}
    if not any(own.has(sp.sin, sp.cos) for own in common):
        return None
    rest = [
        sp.Mul(*(own ** (n - common.get(own, 0)) for own, n in side.items()))
        for side in (one, other)
    ]
    return equality(*map(tree_of, _whole(*rest)))


def _factors(tree: Expression) -> dict[sp.Expr, int] | None:
    """The factors of a product in letters, each with its power; None of what is none."""
    if has_quantity(tree):
        return None
    try:
        value = sp.factor(in_letters(tree, positive=True))
    except RestitutionError:
        return None
    powers = {base: int(n) for base, n in value.as_powers_dict().items() if n.is_Integer}
    return powers if sp.expand(sp.Mul(*(b**n for b, n in powers.items())) - value) == 0 else None


def _whole(one: sp.Expr, other: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Both sides without the numbers below them."""
    numbers = [side.as_coeff_Mul()[0] for side in (one, other)]
    parts = sp.Rational(sp.ilcm(*(n.q for n in numbers)), sp.igcd(*(n.p for n in numbers)))
    return one * parts, other * parts


__all__ = ["with_factors_out"]
