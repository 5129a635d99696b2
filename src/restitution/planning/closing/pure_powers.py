"""Equations such as e⁶ = 1/10, or e³ = ½: the root of that degree."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Relation
from restitution.expression.tree import Binary, Letter, Number
from restitution.planning.closing.excluded_roots import option, rejected
from restitution.planning.closing.ratios import inside_functions
from restitution.planning.closing.roots import known_as
from restitution.planning.formulas.impacts import residual
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import (
    expanded,
    factor_powers,
    numerator,
    polynomial_in,
)
from restitution.planning.writing.scene import Scene

_LEAST = 3


def pure_power(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """The root of a power of the unknown that is a number; None of another equation."""
    above = numerator(residual(scene, number))
    if symbol in inside_functions(above):
        return None
    factors = [(base, power) for base, power in factor_powers(above) if base.has(symbol)]
    if not factors:
        return None
    polynomial = polynomial_in(expanded(sp.Mul(*(base**power for base, power in factors))), symbol)
    degree = polynomial.degree()
    if degree < _LEAST or {power for (power,) in polynomial.monoms()} != {degree, 0}:
        return None
    value = tidy(-polynomial.nth(0) / polynomial.nth(degree))
    if not value.is_Rational or value <= 0:
        return None
    subject = Letter(symbol.name)
    power_ = Binary("^", subject, Number(Fraction(degree)))
    relation = chain(power_, (tree_of(value), None))
    if scene.desk.relation(number) != relation:
        line = in_another_form(scene, number, relation)
        if line is None:
            return None
        number = line
    root = tidy(sp.root(value, degree))
    if scene.model.sign(root - scene.final(symbol)) != 0:
        return None
    ends = [root] if degree % 2 else [root, -root]
    roots = Relation(tuple(option(subject, end) for end in ends))
    if not scene.judge.follows(Move("roots"), (number,), roots):
        return None
    line = scene.desk.write(Move("roots"), (number,), roots)
    if len(ends) > 1:
        line = rejected(scene, line, symbol, subject, [root])
    return known_as(scene, symbol, root, line)


__all__ = ["pure_power"]
