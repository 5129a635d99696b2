"""Quadratics that have one sign throughout: by their discriminants, or as sums of squares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Line,
    Link,
    Relation,
    equality,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Number,
    has_quantity,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.oracle import Role
from restitution.planning.writing.forms import (
    ZERO,
    factors,
    negative,
    product,
    square,
    total,
    tree_of,
)
from restitution.workings.reasons.signs_of_factors import bases_of, worth_of


def definite_sums(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> Iterator[tuple[Expression, Relation, bool]]:
    """The quadratics on whose sign a line rests, with why they have it.

    That is the discriminant of one in a letter; of one in two letters it is a sum of squares, and
    then the last value is false. So it is of one whose square is completed already.
    """
    if line.move.id not in ("sign", "compare") or not isinstance(line.relation, Relation):
        return
    if any(link.sign not in FLIPPED for links in line.relation.options for link in links):
        return
    for own in derivation.lines_in(line.premises):
        for tree in _stated(own.relation) if isinstance(own.relation, Relation) else ():
            for base in bases_of(tree):
                if is_binary(base, "+", "-") and any(is_binary(e, "-") for e in walk(base)):
                    yield from _definite(base, roles)


def _stated(relation: Relation) -> Iterator[Expression]:
    """What a line says of a difference, or of what is compared with zero."""
    if len(relation.options) != 1:
        return
    links = relation.options[0]
    if all(link.sign == "=" for link in links):
        if is_binary(links[0].left, "-") and not has_quantity(links[-1].right):
            yield links[-1].right
        return
    match links:
        case (Link(left, _, right),) if is_zero(right) and not has_quantity(left):
            yield left


def _definite(
    tree: Expression, roles: Mapping[str, Role]
) -> Iterator[tuple[Expression, Relation, bool]]:
    try:
        value = sp.expand(worth_of(tree, roles))
    except (RestitutionError, TypeError, ValueError):
        return
    match tree:
        case Binary("+", first, number) if not letters(number):
            of_sums = [e for e in factors(first) if _is_square_of_sum(e)]
            if len(of_sums) == 1 and sum(1 for e in factors(first) if letters(e)) == 1:
                yield tree, Relation(((Link(of_sums[0], ">=", ZERO),),)), False
                return
    symbols = sorted(value.free_symbols, key=lambda e: e.name)
    if not value.is_polynomial(*symbols) or not 0 < len(symbols) < 3:
        return
    poly = sp.Poly(value, *symbols)
    if not all(c.is_Rational for c in poly.coeffs()) or poly.total_degree() != 2:
        return
    if len(symbols) == 1:
        if poly.discriminant() < 0:
            yield tree, discriminant_of(poly), True
        return
    one, other = symbols
    a, b, c = (value.coeff(one, 2), value.coeff(one, 1).coeff(other, 1), value.coeff(other, 2))
    if not poly.is_homogeneous or 0 in (a, b, c) or b**2 - 4 * a * c >= 0:
        return
    inside = tree_of(one + b / (2 * a) * other)
    rest = tree_of((c - b**2 / (4 * a)) * other**2)
    squares = total((product(tree_of(a), square(inside)), rest))
    yield tree, equality(tree, squares), False


def _is_square_of_sum(tree: Expression) -> bool:
    """Whether an expression is the square of a sum, or of a difference."""
    match tree:
        case Binary("^", Binary("+" | "-"), Number(power)):
            return power == 2
    return False


def discriminant_of(quadratic: sp.Poly) -> Relation:
    """The discriminant of a quadratic in a letter, as it is worked out: 11² − 4 × 8 × 8 = −135."""
    worth = tree_of(sp.nsimplify(quadratic.discriminant()))
    a, b, c = (tree_of(abs(own)) for own in quadratic.all_coeffs())
    # Both ends have one sign, or there would be roots.
    four = product(product(tree_of(4), a), c)
    stated = Binary("-", square(b), four) if quadratic.nth(1) else negative(four)
    return equality(stated, worth)


def without_root(quadratic: sp.Poly, subject: Expression) -> tuple[Relation, Relation]:
    """A quadratic equation in a letter or a ratio, with its discriminant."""
    (symbol,) = quadratic.gens
    own = -quadratic if quadratic.LC().is_negative else quadratic
    stated = tree_of(own.as_expr(), as_it_is=True)
    return equality(exchanged(stated, {tree_of(symbol): subject}), ZERO), discriminant_of(own)


__all__ = ["definite_sums", "without_root"]
