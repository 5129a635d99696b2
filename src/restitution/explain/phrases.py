"""Operands and words: expressions with their values put in, and the names of things."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction as Ratio
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explain.steps import Row, Side, shown, side
from restitution.explaining.marks import Marks
from restitution.explaining.saying import Sentence, say
from restitution.explaining.sentences import SENTENCES
from restitution.render import layout as lay
from restitution.render.layout import Bold, Brackets, Layout, Number, Product, Relation, Sum

OR = str(say("list.or"))
"""What stands between alternatives."""


def ordinal(number: int) -> Sentence | None:
    """``first``, ``second``, …; None for a number that has no such word here."""
    word = f"ordinal.{number}"
    return say(word) if word in SENTENCES else None


def look(value: Any, *, angle: bool = False) -> Layout:
    """How a value looks: a vector for a pair, degrees for an angle."""
    if isinstance(value, Layout):
        return value
    if isinstance(value, tuple):
        return lay.vector(value[0], value[1])
    return lay.from_sympy(sp.sympify(value, strict=True), degrees=angle)


def answer(value: Any, *, angle: bool = False, percentage: bool = False) -> list[Side]:
    """A result: its exact form, and to 3 significant figures where that says more."""
    if isinstance(value, tuple):
        laid = lay.display_vector(*value)
    else:
        laid = lay.display(value, angle=angle, percentage=percentage)
    if not isinstance(laid, Relation):
        exact = _rounded_only(laid, value, angle)
        return [Side(laid, None if exact else value)]
    return [Side(laid.operands[0], value), *(shown(each) for each in laid.operands[1:])]


def _rounded_only(laid: Layout, value: Any, angle: bool) -> bool:
    return not isinstance(value, tuple) and laid != lay.from_sympy(value, degrees=angle)


def chain(*sides: Any, points: Marks = (), asides: tuple[Sentence, ...] = ()) -> Row:
    """Sides with ``=`` between them; one that looks like the side before it is left out."""
    kept: list[Side] = []
    for each in sides:
        made = each if isinstance(each, Side) else side(each)
        if kept and made.layout == kept[-1].layout:
            if kept[-1].value is None:
                kept[-1] = made
            continue
        if len(kept) > 1 and same_term(made.layout, kept[-1].layout):
            kept[-1] = made  # ¾u = 3u/4
            continue
        kept.append(made)
    if len(kept) == 1:
        kept.append(kept[0])
    return Row(
        tuple(each.layout for each in kept),
        ("=",) * (len(kept) - 1),
        tuple(each.value for each in kept),
        points,
        asides,
    )


def same_term(a: Layout, b: Layout) -> bool:
    """Whether two products differ only in where their number stands: ``¾u``, ``3u/4``."""
    first, second = _coefficient(a), _coefficient(b)
    return first is not None and first == second


def _coefficient(laid: Layout) -> tuple[Ratio, frozenset[tuple[Layout, int]]] | None:
    """The number in a plain product and its other factors; None for what is none."""
    sign, laid = lay.split_sign(laid)
    below = Ratio(1)
    if isinstance(laid, lay.Fraction) and not isinstance(laid.above, Number):
        number = _coefficient(laid.below)
        if number is None or number[1]:
            return None
        laid, below = laid.above, number[0]
    factors = laid.factors if isinstance(laid, Product) else (laid,)
    if isinstance(laid, Product) and laid.sign:
        return None
    number_, others = Ratio(1), Counter[Layout]()
    for factor in factors:
        if isinstance(factor, Brackets | Sum):
            return None
        plain = _ratio_of(factor)
        if plain is None:
            others[factor] += 1
        else:
            number_ *= plain
    if not number_ or not below or not others:
        return None
    return (-number_ if sign == "-" else number_) / below, frozenset(others.items())


def _ratio_of(laid: Layout) -> Ratio | None:
    if isinstance(laid, Number):
        return Ratio(laid.digits) if laid.digits.isdigit() else None
    if isinstance(laid, lay.Fraction):
        above, below = _ratio_of(laid.above), _ratio_of(laid.below)
        return above / below if above is not None and below else None
    return None


def relation(
    left: Any, sign: str, right: Any, points: Marks = (), asides: tuple[Sentence, ...] = ()
) -> Row:
    """Two sides with any sign between them."""
    a, b = side(left), side(right)
    return Row((a.layout, b.layout), (lay.SIGNS.get(sign, sign),), (a.value, b.value))


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
    """``a − b`` with values put in: ``3 − (−4)``; a zero is left out."""
    a, b = look(first), look(second)
    if b == Number("0") or b == lay.ZERO_VECTOR:
        return a
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


def half_m(mass: Any, *components: Any) -> Layout:
    """½mv², with v² as a sum of squares of components."""
    half = lay.fraction(Number("1"), Number("2"))
    parts = [each for each in components if not _zero(look(each))]
    if not parts:
        return Number("0")
    squares = [square(each) for each in parts]
    m = look(mass)
    inside = squares[0] if len(squares) == 1 else Brackets(lay.total(squares))
    if _begins(inside) and not (_numeric(m) or _begins(m)):
        return Product((lay.product(half, lay.bracketed(m)), inside), "×")
    if _numeric(m) or _begins(m) or _begins(inside):
        return Product((half, lay.bracketed(m), inside), "×")
    return lay.product(half, lay.bracketed(m), inside)


def minus(first: Layout, second: Layout) -> Layout:
    """One layout less another, in brackets if need be."""
    if _zero(second):
        return first
    if isinstance(second, Sum):
        second = Brackets(second)
    terms = first.terms if isinstance(first, Sum) else (("+", first),)
    return Sum((*terms, ("-", second)))


def direction_words(x: Any, y: Any) -> Layout:
    """The direction of a vector as a vector without fractions: ``3**i** + 4**j**``."""
    a, b = sp.sympify(x, strict=True), sp.sympify(y, strict=True)
    if a == 0:
        return lay.vector(0, sp.sign(b))
    if b == 0:
        return lay.vector(sp.sign(a), 0)
    ratio = tidy(sp.radsimp(b / a))
    if isinstance(ratio, sp.Rational):
        sign = 1 if sp.sympify(a, strict=True).is_positive or sp.N(a) > 0 else -1
        return lay.vector(sign * ratio.q, sign * ratio.p)
    return lay.vector(tidy(a), tidy(b))


def bold_velocity(name: str) -> Layout:
    """**v** with the name of a sphere."""
    return Bold("v", name)


def sum_of_products(pairs: Iterable[tuple[Any, Any]]) -> Layout:
    """Masses times velocities, or the terms of a scalar product, with the values put in.

    ``2 × (−4) + 3 × 3``, ``3mu + 2m × (−2u)``, ``(u cos α)(u cos α) − (u sin α)(eu sin α)``.
    """
    terms: list[Layout] = []
    for a, b in pairs:
        first, second = look(a), look(b)
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


def vector_difference(first: tuple[Any, Any], second: tuple[Any, Any]) -> Layout:
    """``(3**i** − 9**j**) − (6**i** − 5**j**)``; nothing is taken away for the zero vector."""
    a, b = look((first[0], first[1])), look((second[0], second[1]))
    if b == lay.ZERO_VECTOR:
        return a
    left = Brackets(a) if isinstance(a, Sum) and len(a.terms) > 1 else a
    right = Brackets(b) if isinstance(b, Sum) else b
    terms = left.terms if isinstance(left, Sum) else (("+", left),)
    if a == lay.ZERO_VECTOR:
        return Sum((("-", right),))
    return Sum((*terms, ("-", right)))
