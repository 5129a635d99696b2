"""The one printer of values put in: it alone decides on ×, brackets, signs and zeros.

A formula is a template of the statement language, and its letters stand for values:
``printed("m*u + n*v", m=2, u=3, n=4, v=-1)`` is 2 × 3 + 4 × (−1). What is zero is left out of a
sum, a factor 1 out of a product; numbers have × between them, letters nothing; what is negative or
several things stands in brackets, and a sign before letters is drawn to the front.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, Literal

import sympy as sp

from restitution.expression import read_expression
from restitution.expression import tree as trees
from restitution.render import layout as lay
from restitution.render.layout import Bold, Brackets, Layout, Number, Product, Sum

_HALF = lay.fraction(Number("1"), Number("2"))


def printed(template: str, **values: Any) -> Layout:
    """A template with values put in, not worked out.

    A value is an expression, a pair for a vector, or a layout; every letter of the template has
    one. Raises KeyError for a letter without a value.
    """
    return _put(_read(template), {name: look(value) for name, value in values.items()})


@lru_cache(maxsize=256)
def _read(template: str) -> trees.Expression:
    return read_expression(template)


def _put(tree: trees.Expression, values: Mapping[str, Layout]) -> Layout:
    match tree:
        case trees.Letter(name):
            return values[name]
        case trees.Number(value):
            return look(sp.Rational(value.numerator, value.denominator))
        case trees.Negate(operand):
            return lay.negative(_put(operand, values))
        case trees.Apply("sqrt", argument):
            return lay.Root(_put(argument, values))
        case trees.Binary("^", base, trees.Number(2)):
            laid_base = _put(base, values)
            return laid_base if _zero(laid_base) else square(laid_base)
        case trees.Binary("/", above, below):
            return lay.fraction(_put(above, values), _put(below, values))
        case trees.Binary("*", _, _):
            first, *others = _factors(tree)
            laid = [_put(each, values) for each in others]
            if first == _read("1/2"):
                return _half(*laid)
            return _product([_put(first, values), *laid])
        case trees.Binary("+" | "-", _, _):
            return _sum(list(_terms(tree)), values)
    raise TypeError(tree)


def _factors(tree: trees.Expression) -> list[trees.Expression]:
    if isinstance(tree, trees.Binary) and tree.op == "*":
        return [*_factors(tree.left), tree.right]
    return [tree]


def _terms(tree: trees.Expression) -> list[tuple[Literal["+", "-"], trees.Expression]]:
    if isinstance(tree, trees.Binary) and tree.op in ("+", "-"):
        return [*_terms(tree.left), ("+" if tree.op == "+" else "-", tree.right)]
    return [("+", tree)]


def _product(factors: list[Layout]) -> Layout:
    if any(_zero(each) for each in factors):
        return Number("0")
    sign, first = lay.split_sign(factors[0])
    kept = [each for each in (first, *factors[1:]) if each != lay.ONE]
    if len(kept) > 1:
        size = product_of(*kept)
    else:
        size = kept[0] if kept else Number("1")
    return lay.negative(size) if sign == "-" else size


def _half(mass: Layout, inside: Layout) -> Layout:
    """½mv², with v² as a sum of squares of components."""
    if _zero(mass) or _zero(inside):
        return Number("0")
    inside = lay.bracketed(inside)
    letters = not (_numeric(mass) or _begins(mass))
    if _begins(inside) and letters:
        return Product((lay.product(_HALF, lay.bracketed(mass)), inside), "×")
    if not letters or _begins(inside):
        return Product((_HALF, lay.bracketed(mass), inside), "×")
    return lay.product(_HALF, lay.bracketed(mass), inside)


def _sum(
    terms: list[tuple[Literal["+", "-"], trees.Expression]], values: Mapping[str, Layout]
) -> Layout:
    pairs = [_pair(term, values) for sign, term in terms if sign == "+"]
    if len(pairs) == len(terms) and all(pairs):
        return _sum_of_products([each for each in pairs if each])
    whole: Layout = Number("0")
    for sign, term in terms:
        laid = _put(term, values)
        if _zero(laid):
            continue
        if sign == "+":
            whole = laid if _zero(whole) else lay.total([whole, laid])
        else:
            whole = difference(whole, laid)
    return whole


def _pair(term: trees.Expression, values: Mapping[str, Layout]) -> tuple[Layout, Layout] | None:
    """The factors of a product of two letters that stand for numbers; else None."""
    match term:
        case trees.Binary("*", trees.Letter(a), trees.Letter(b)):
            first, second = values[a], values[b]
            return None if _vector(first) or _vector(second) else (first, second)
    return None


def _vector(laid: Any) -> bool:
    """Whether a layout is a vector: one with **i**, **j** or a bold letter in it."""
    if isinstance(laid, Bold):
        return True
    match laid:
        case Sum(terms):
            return any(_vector(each) for _, each in terms)
        case Product(factors):
            return any(_vector(each) for each in factors)
        case Brackets(inside):
            return _vector(inside)
    return False


def look(value: Any, *, angle: bool = False) -> Layout:
    """How a value looks: a vector for a pair, degrees for an angle."""
    if isinstance(value, Layout):
        return value
    if isinstance(value, tuple):
        return lay.vector(value[0], value[1])
    return lay.from_sympy(sp.sympify(value, strict=True), degrees=angle)


def product_of(*factors: Any) -> Layout:
    """A product with values put in: ``×`` between numbers, nothing between letters."""
    laid = [look(each) for each in factors]
    if (
        len(laid) == 2
        and isinstance(laid[0], lay.Letter)
        and isinstance(laid[1], Product)
        and (laid[0] in laid[1].factors)
    ):
        return Product(tuple(laid), "×")  # e × eu, not eeu
    if sum(_numeric(each) for each in laid) > 1 or any(_begins(each) for each in laid[1:]):
        first, *rest = [
            Brackets(each) if _is_negative(each) and index else lay.bracketed(each)
            for index, each in enumerate(laid)
        ]
        if first == Number("1"):
            return lay.product(*rest, sign="×") if len(rest) > 1 else rest[0]
        return Product((first, *rest), "×")
    return lay.product(*laid)


def _numeric(laid: Layout) -> bool:
    _, size = lay.split_sign(laid)
    return (
        isinstance(size, Number)
        or (
            isinstance(size, lay.Fraction)
            and isinstance(size.above, Number)
            and isinstance(size.below, Number)
        )
        or isinstance(size, lay.Root)
    )


def _begins(laid: Layout) -> bool:
    _, size = lay.split_sign(laid)
    while isinstance(size, Product | lay.Fraction | lay.Power):
        size = (
            size.factors[0]
            if isinstance(size, Product)
            else size.above
            if isinstance(size, lay.Fraction)
            else size.base
        )
    return isinstance(size, Number)


def _is_negative(laid: Layout) -> bool:
    return isinstance(laid, Sum) and len(laid.terms) == 1


def difference(first: Any, second: Any) -> Layout:
    """``a − b`` with values put in: ``3 − (−4)``; a zero is left out.

    Of vectors ``(3**i** − 9**j**) − (6**i** − 5**j**)``.
    """
    a, b = look(first), look(second)
    if _zero(b):
        return a
    if _vector(a) or _vector(b):
        return _vector_difference(a, b)
    minus: Layout
    if _is_negative(b):
        minus = Brackets(b)
        if not _starts_numeric(b):
            return lay.total([a, lay.split_sign(b)[1]]) if not _zero(a) else lay.split_sign(b)[1]
    else:
        minus = lay.bracketed(b)
    if _zero(a):
        return Sum((("-", minus),))
    terms = a.terms if isinstance(a, Sum) else (("+", a),)
    return Sum((*terms, ("-", minus)))


def _vector_difference(a: Layout, b: Layout) -> Layout:
    left = Brackets(a) if _several(a) else a
    right = Brackets(b) if isinstance(b, Sum) else b
    if _zero(a):
        return Sum((("-", right),))
    terms = left.terms if isinstance(left, Sum) else (("+", left),)
    return Sum((*terms, ("-", right)))


def _several(laid: Layout) -> bool:
    """Whether a layout is a sum of more than one term."""
    return isinstance(laid, Sum) and len(laid.terms) > 1


def _zero(laid: Layout) -> bool:
    return laid == Number("0") or laid == lay.ZERO_VECTOR


def _starts_numeric(laid: Layout) -> bool:
    return _begins(laid) and not _has_letter(laid)


def _has_letter(laid: Any) -> bool:
    if isinstance(laid, lay.Letter):
        return True
    for name in getattr(laid, "__slots__", ()):
        inner = getattr(laid, name)
        if isinstance(inner, tuple):
            for each in inner:
                parts = each if isinstance(each, tuple) else (each,)
                if any(_has_letter(part) for part in parts if not isinstance(part, str)):
                    return True
        elif not isinstance(inner, str | int) and inner is not None and _has_letter(inner):
            return True
    return False


def square(value: Any) -> Layout:
    """A square with the value put in: ``(−4)²``, ``(u cos α)²``, ``v²``."""
    laid = look(value)
    sign, size = lay.split_sign(laid)
    if sign == "-" and _has_letter(size):
        laid = size
    if isinstance(laid, lay.Root):
        laid = Brackets(laid)
    return lay.power(laid, Number("2"))


def _sum_of_products(pairs: Iterable[tuple[Layout, Layout]]) -> Layout:
    """Masses times velocities, or the terms of a scalar product, with the values put in.

    ``2 × (−4) + 3 × 3``, ``3mu + 2m × (−2u)``, ``(u cos α)(u cos α) − (u sin α)(eu sin α)``.
    """
    terms: list[Layout] = []
    for first, second in pairs:
        if _zero(first) or _zero(second):
            continue
        (sign, size), (other, rest) = lay.split_sign(first), lay.split_sign(second)
        if _wordy(size) and _wordy(rest):
            term: Layout = lay.product(Brackets(size), Brackets(rest))
            flip = (sign == "-") != (other == "-")
        elif second == Number("1") or first == Number("1"):
            term = second if first == Number("1") else first
            sign, term = lay.split_sign(term)
            flip = sign == "-"
        elif isinstance(rest, Number) and other == "+" and not _begins(size):
            term = lay.product(rest, size)  # 4m
            flip = sign == "-"
        elif _begins(rest) and not (sign == "-" and not terms):
            term = product_of(size, second)
            flip = sign == "-"
        else:
            term = product_of(size, rest)
            flip = (sign == "-") != (other == "-")
        if isinstance(term, Sum) and len(term.terms) > 1 and flip:
            term = Brackets(term)
        terms.append(Sum((("-", term),)) if flip else term)
    return lay.total(terms)


def _wordy(laid: Layout) -> bool:
    """Whether a factor holds a function: two such run into each other without brackets."""
    if isinstance(laid, lay.Function):
        return True
    return isinstance(laid, Product) and any(isinstance(f, lay.Function) for f in laid.factors)
