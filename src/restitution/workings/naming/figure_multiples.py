"""Multiples of letters by numbers that only a calculator knows: 0.1351u, 0.3220(1 − 2e)u."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import sympy as sp

from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Rounded,
    children,
    has_quantity,
    has_root,
    letters,
)
from restitution.planning.writing.forms import product, tree_of
from restitution.workings.naming.measured import FIGURES_BETWEEN, number_carried, scalar_worth


@lru_cache(maxsize=4096)
def number_and_letters(tree: Expression) -> tuple[sp.Expr, sp.Expr] | None:
    """The number and the product of letters of a multiple of letters; None of another value."""
    value = None if has_quantity(tree) or not letters(tree) else scalar_worth(tree)
    if value is None:
        return None
    value = sp.factor(value)
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    factors = sp.Mul.make_args(rest)
    if not number.is_real or not all(map(_is_plain_factor, factors)):
        return None
    if number.is_negative:
        # 1 − 2e, and not 2e − 1 with a minus before it.
        mixed = [e for e in factors if e.is_Add and len({*map(_is_negative, e.args)}) > 1]
        if mixed:
            return -number, sp.Mul(-mixed[0], *(e for e in factors if e is not mixed[0]))
    return number, rest


def _is_negative(term: sp.Expr) -> bool:
    return bool(term.could_extract_minus_sign())


def _is_plain_factor(factor: sp.Expr) -> bool:
    """Whether a factor is a letter, a power of one, or a sum of letters with whole numbers."""
    base, power = factor.as_base_exp()
    plain = base.is_Symbol or (base.is_Add and all(e.is_Integer for e in base.atoms(sp.Number)))
    return bool(plain and power.is_Integer and not base.atoms(sp.Pow, sp.Function))


def multiple_of(number: sp.Expr, letters_: sp.Expr) -> Expression | None:
    """A multiple of letters with its number in figures: 0.1351u."""
    size = number_carried(number, FIGURES_BETWEEN)
    if size is None:
        return None
    whole = product(Rounded(abs(size), FIGURES_BETWEEN), tree_of(letters_))
    return Negate(whole) if size < 0 else whole


def is_one_term(tree: Expression) -> bool:
    """Whether a tree is a number times letters, over a number perhaps, with nothing to work out."""
    match tree:
        case Negate(inside):
            return is_one_term(inside)
        case Binary("/", inside, Number()):
            return _is_product(inside)
    return _is_product(tree)


def _is_product(tree: Expression) -> bool:
    match tree:
        case Letter() | Binary("^", Letter(), Number()):
            return True
        case Binary("*", left, right):
            return _is_product(left) and _is_product(right)
    return not letters(tree)


def beside_figures(
    exact: Sequence[Expression], trees: Sequence[Expression], solved: bool
) -> list[Expression]:
    """The sides of a chain with figures for roots as well, behind the first that has figures.

    Where a line is ``solved``, on every side.
    """
    first = next((n for n in range(len(trees)) if trees[n] != exact[n]), None)
    if first is None:
        return list(trees)
    return [roots_in_figures(tree) if solved or n > first else tree for n, tree in enumerate(trees)]


def roots_in_figures(tree: Expression) -> Expression:
    """A side with figures for its numbers with roots, beside others: 5.934k − 2.828."""
    if not has_root(tree) or has_quantity(tree):
        return tree
    value = None if letters(tree) else scalar_worth(tree)
    number = None if value is None else number_carried(value, FIGURES_BETWEEN)
    if number is not None:
        size = Rounded(abs(number), FIGURES_BETWEEN)
        return Negate(size) if number < 0 else size
    parts = number_and_letters(tree) if is_one_term(tree) else None
    if parts is not None:
        return multiple_of(*parts) or tree
    put = {child: roots_in_figures(child) for child in children(tree)}
    return exchanged(tree, {child: own for child, own in put.items() if own != child})
