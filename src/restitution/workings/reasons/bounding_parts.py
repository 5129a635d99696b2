"""Parts of values that bound them: squares, and sums and products of a sine and a cosine."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.trees import rebuilt, squared
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.solving.algebra.signs import sign


def wave_of(node: Expression) -> tuple[Expression, tuple[Link, ...]] | None:
    """The greatest value of ``a cos x + b sin x``, or of ``sin x cos x``, and what tells it."""
    a = b = None
    two = Number(Fraction(2))
    match node:
        case Binary("*", before, Apply("sin" | "cos" as one, x)):
            rest, last = (before.left, before.right) if is_binary(before, "*") else (None, before)
            if last != Apply("cos" if one == "sin" else "sin", x):
                return None
            half = Binary("/", Number(Fraction(1)), two)
            most = half if rest is None else Binary("*", rest, half)
            double = Apply("sin", Binary("*", two, x))
            twice = Binary("*", Binary("*", two, Apply("sin", x)), Apply("cos", x))
            return most, (Link(twice, "=", double), Link(double, "<=", Number(Fraction(1))))
        case Binary("+", left, right):
            a, b = _times(left), _times(right)
        case Apply("sin" | "cos", Binary("*")):
            return Number(Fraction(1)), (Link(node, "<=", Number(Fraction(1))),)
    if a is None or b is None:
        return None
    if a[1].argument != b[1].argument or {a[1].function, b[1].function} != {"sin", "cos"}:
        return None
    total = sp.expand(a[0] ** 2 + b[0] ** 2)
    if a[0].is_positive and b[0].is_positive:
        return tree_of(sp.sqrt(total)), _as_one_cosine(node, a, b, sp.sqrt(total))
    other_ = Binary("-", _scaled(b[0], a[1]), _scaled(a[0], b[1]))
    squared = tree_of(total)
    less = Binary("-", squared, Binary("^", other_, two))
    links = (Link(Binary("^", node, two), "=", less), Link(less, "<=", squared))
    return tree_of(sp.sqrt(total)), links


def _as_one_cosine(
    node: Expression, a: tuple[sp.Expr, Apply], b: tuple[sp.Expr, Apply], most: sp.Expr
) -> tuple[Link, ...]:
    """``3 cos(x) + 4 sin(x) = 5 cos(x - arctan(4/3)) <= 5``: the form R cos(x − γ)."""
    (cosine, x), (sine, _) = (a, b) if a[1].function == "cos" else (b, a)
    turn = sp.atan(sp.radsimp(sine / cosine))
    degrees = sp.deg(turn)
    angle: Expression = Apply("arctan", tree_of(sp.radsimp(sine / cosine)))
    if degrees.is_Rational:
        angle = Degrees(Fraction(int(degrees.p), int(degrees.q)))
    whole = Binary("*", tree_of(most), Apply("cos", Binary("-", x.argument, angle)))
    return Link(node, "=", whole), Link(whole, "<=", tree_of(most))


def _times(tree: Expression) -> tuple[sp.Expr, Apply] | None:
    """A number, perhaps a root, times a sine or a cosine."""
    match tree:
        case Apply("sin" | "cos"):
            return sp.Integer(1), tree
        case Binary("*", factor, Apply("sin" | "cos") as ratio) if not letters(factor):
            return in_letters(factor), ratio
    return None


def _scaled(factor: sp.Expr, ratio: Apply) -> Expression:
    return ratio if factor == 1 else Binary("*", tree_of(factor), ratio)


def is_bound_by(whole: Expression, node: Expression, most: Expression, bound: Expression) -> bool:
    """Whether a bound is a whole with the greatest value of a part of it, for letters of 2/3."""
    put = rebuilt(whole, lambda tree: most if tree == node else tree)
    try:
        one, other = (evaluate(tree, lambda _: sp.Rational(2, 3)) for tree in (put, bound))
        return sign(sp.sympify(one - other, strict=True)) == 0
    except (RestitutionError, TypeError, ValueError):
        return False


def squares_of_terms(tree: Expression, sign: str) -> Iterator[tuple[Expression, Expression]]:
    """The terms of sums that are squares, or multiples of them, each with its square.

    For an upper bound those that are taken away.
    """
    for node in walk(tree):
        match node:
            case Binary("+", left, right) if sign == ">=":
                terms: tuple[Expression, ...] = (left, right)
            case Binary("-", _, right) if sign == "<=":
                terms = (right,)
            case _:
                continue
        for term in terms:
            match term:
                case Binary("^", _, Number(Fraction(numerator=2, denominator=1))):
                    yield term, term
                case Binary("/", Binary("^", _, Number(Fraction(numerator=2))) as inner, _):
                    yield term, inner
                case Binary(
                    "/",
                    Binary("*", Number(), Binary("^", _, Number(Fraction(numerator=2))) as own),
                    _,
                ):
                    yield term, own
                case Binary("*", factor, Binary("^", _, Number(Fraction(numerator=2))) as inner):
                    if not letters(factor):
                        yield term, inner


def squares_below(tree: Expression) -> Iterator[tuple[Expression, Expression]]:
    """The squares of letters in a quotient: what it is without one may bound it."""
    for node in walk(tree):
        match node:
            case Binary("/", _, below):
                for term in walk(below):
                    match term:
                        case Binary("^", Letter(), Number(Fraction(numerator=2, denominator=1))):
                            yield term, term


__all__ = ["is_bound_by", "squared", "squares_below", "squares_of_terms", "wave_of"]
