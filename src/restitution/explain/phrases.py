"""Operands and words: expressions with their values put in, and the names of things."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction as Ratio
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explain.steps import Row, Side, shown, side
from restitution.explaining.marks import Marks
from restitution.explaining.saying import Sentence, say
from restitution.explaining.sentences import SENTENCES
from restitution.render import layout as lay
from restitution.render.layout import Brackets, Layout, Number, Product, Relation, Sum

OR = str(say("list.or"))
"""What stands between alternatives."""


def ordinal(number: int) -> Sentence | None:
    """``first``, ``second``, …; None for a number that has no such word here."""
    word = f"ordinal.{number}"
    return say(word) if word in SENTENCES else None


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
