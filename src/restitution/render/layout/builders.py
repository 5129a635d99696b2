"""Builders of layouts, which put brackets where the meaning needs them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from restitution.render.layout.nodes import (
    ONE,
    Bold,
    Brackets,
    Degrees,
    Fraction,
    Function,
    Layout,
    Letter,
    Number,
    Phrase,
    Power,
    Product,
    Relation,
    Root,
    Sum,
)


def letter(name: str) -> Letter:
    """The layout of a letter by its canonical name: ``u``, ``alpha``, ``lambda_``, ``e_1``."""
    head, _, subscript = name.partition("_")
    return Letter(head, subscript.strip("_"))


def negative(inside: Layout) -> Layout:
    """The layout with the other sign."""
    sign, size = split_sign(inside)
    if sign == "-":
        return size
    return Sum((("-", bracketed(size)),))


def split_sign(layout: Layout) -> tuple[Literal["+", "-"], Layout]:
    """The sign of a single term, and the term without it."""
    if isinstance(layout, Sum) and len(layout.terms) == 1:
        return layout.terms[0]
    return "+", layout


def bracketed(layout: Layout) -> Layout:
    """The layout in brackets if it is a sum, a negative or several things."""
    if isinstance(layout, Sum | Relation | Phrase):
        return Brackets(layout)
    return layout


def total(terms: Iterable[Layout]) -> Layout:
    """A sum of layouts; negative ones are subtracted, sums inside are opened."""
    parts: list[tuple[Literal["+", "-"], Layout]] = []
    for term in terms:
        parts.extend(term.terms if isinstance(term, Sum) else [("+", term)])
    if len(parts) == 1 and parts[0][0] == "+":
        return parts[0][1]
    return Sum(tuple(parts)) if parts else Number("0")


def product(*factors: Layout, sign: Literal["", "×", "·"] = "") -> Layout:
    """A product; sums are put in brackets, and products without a sign are opened."""
    flat: list[Layout] = []
    for factor in factors:
        if isinstance(factor, Product) and factor.sign == "" and sign == "":
            flat.extend(factor.factors)
        else:
            flat.append(factor)
    if sign == "" and len(flat) > 1:
        flat = [layout for layout in flat if layout != ONE] or [ONE]
    if len(flat) == 1:
        return flat[0]
    first, *others = (bracketed(layout) for layout in flat)
    if sign == "":  # 2 before 3^(5/7) would be 23 to a power
        others = [
            Brackets(layout) if _is_power_of_a_number(layout) else layout for layout in others
        ]
    return Product((first, *others), sign)


def _is_power_of_a_number(layout: Layout) -> bool:
    return isinstance(layout, Power) and isinstance(layout.base, Number)


def fraction(above: Layout, below: Layout) -> Layout:
    """A fraction; a denominator 1 is left out, a sign of the numerator stands in front."""
    if below == ONE:
        return above
    sign, size = split_sign(above)
    inner = Fraction(size, below)
    return Sum(((sign, inner),)) if sign == "-" else inner


def power(base: Layout, exponent: Layout) -> Layout:
    """A power; sin α squared is sin²α, and a base of several things is put in brackets."""
    if exponent == ONE:
        return base
    if isinstance(base, Function) and base.power is None and isinstance(exponent, Number):
        return Function(base.name, base.argument, exponent)
    if not isinstance(base, Number | Letter | Bold | Brackets):
        base = Brackets(base)
    return Power(base, exponent)


def root(inside: Layout, index: int = 2) -> Layout:
    """A root."""
    return Root(inside.inside if _is_round(inside) else inside, index)  # type: ignore[union-attr]


def function(name: str, argument: Layout, exponent: Layout | None = None) -> Layout:
    """A function; its argument is put in brackets unless it is a letter, number or ``2α``."""
    simple = isinstance(argument, Number | Letter | Brackets) or (
        isinstance(argument, Degrees) and isinstance(argument.inside, Number)
    )
    if (
        isinstance(argument, Product)
        and not name.startswith("arc")
        and argument.sign == ""
        and len(argument.factors) == 2
        and isinstance(argument.factors[0], Number)
        and isinstance(argument.factors[1], Letter)
    ):
        simple = True
    return Function(name, argument if simple else Brackets(argument), exponent)


def _is_round(layout: Layout) -> bool:
    return isinstance(layout, Brackets) and layout.kind == "()"
