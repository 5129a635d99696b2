"""Trees of polynomials in a letter, in a ratio of an angle, or in a square."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.expression.tree import Binary, Expression, Number
from restitution.planning.writing.forms import product, square, total, tree_of


def polynomial_tree(polynomial: sp.Poly, subject: Expression) -> Expression:
    """A polynomial, the highest power of what it is in first."""
    terms = []
    for (power,), value in polynomial.terms():
        tree = tree_of(value)
        terms.append(product(tree, _power(subject, power)) if power else tree)
    return total(terms)


def _power(subject: Expression, power: int) -> Expression:
    """A power of what an equation is in."""
    if power == 1:
        return subject
    return doubled_power(subject) if power == 2 else Binary("^", subject, Number(Fraction(power)))


def doubled_power(subject: Expression) -> Expression:
    """The square of what an equation is in; of a square the fourth power."""
    match subject:
        case Binary("^", base, Number(value)):
            return Binary("^", base, Number(2 * value))
    return square(subject)


__all__ = ["doubled_power", "polynomial_tree"]
