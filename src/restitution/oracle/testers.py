"""Formulas compiled, to be tried at points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.oracle.formula import (
    All,
    Formula,
    Relation,
    Some,
    letters_of,
    relations,
)
from restitution.oracle.points import (
    Ball,
    BeyondError,
    Point,
    Program,
    as_number,
)
from restitution.oracle.polynomials import Polynomials, TooLargeError


class Tester:
    """A formula compiled, to be tried at points."""

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        self.values = tuple(dict.fromkeys(relation.value for relation in relations(formula)))
        self._program = Program.of(self.values)
        self._tree = _placed(formula, {value: n for n, value in enumerate(self.values)})
        self.letters = letters_of(formula)

    def holds(
        self, point: Point, balls: Mapping[str, Ball] | None = None, *, exactly: bool = False
    ) -> bool | None:
        """Whether the formula holds at a point; None where that is not certain.

        ``exactly`` also asks algebra whether an expression vanishes there, which takes longer.
        """
        signs = self._program.signs(point, balls)
        if exactly:
            signs = [
                0 if sign is None and _vanishes_at(value, point) else sign
                for value, sign in zip(self.values, signs, strict=True)
            ]
        return _holds(self._tree, signs)

    def signs(self, point: Point, balls: Mapping[str, Ball] | None = None) -> list[int | None]:
        """The signs of the expressions in it, each once, at a point."""
        return self._program.signs(point, balls)

    def balls(self, letters: Mapping[str, Ball]) -> list[Ball | None]:
        """The expressions in it in floats, with bounds of the errors; None where they have none."""
        return self._program.balls({}, letters)

    def holds_with(self, signs: Sequence[int | None]) -> bool | None:
        """Whether the formula holds where its expressions have these signs, in their order."""
        return _holds(self._tree, signs)


# A formula with places in a list of signs for its expressions.
_Tree = Any  # (place, operator) | (bool, list of trees): all of them, or some

_SIGNS = {"=": (0,), "!=": (1, -1), ">": (1,), ">=": (0, 1)}


def _placed(formula: Formula, places: Mapping[sp.Expr, int]) -> _Tree:
    match formula:
        case Relation(value, operator):
            return places[value], _SIGNS[operator]
        case All(parts) | Some(parts):
            return isinstance(formula, All), [_placed(part, places) for part in parts]


def _holds(tree: _Tree, signs: Sequence[int | None]) -> bool | None:
    kind, inner = tree
    if kind is not True and kind is not False:
        sign = signs[kind]
        return None if sign is None else sign in inner
    open_ = False
    for value in inner:
        truth = _holds(value, signs)
        if truth is (not kind):
            return truth
        open_ = open_ or truth is None
    return None if open_ else kind


@lru_cache(maxsize=512)
def tester_of(formula: Formula) -> Tester:
    """A formula compiled; the same one for who asks again."""
    return Tester(formula)


def _vanishes_at(x: sp.Expr, point: Point) -> bool:
    """Whether an expression is seen by algebra to be zero at a point: cos 150° + √3/2."""
    numbers = {
        symbol: as_number(value)
        for symbol in x.free_symbols
        if (value := point.get(symbol.name)) is not None
    }
    try:
        there = x.xreplace(numbers)
        if there.free_symbols or there.has(sp.nan, sp.zoo, sp.oo):
            return False
        world = Polynomials([there], {})
        return world.vanishes(world.quotient(there)[0])
    except (TooLargeError, BeyondError, ZeroDivisionError, ValueError):
        return False  # of what has no value there SymPy finds no least one


def holds_with(formula: Formula, signs: Mapping[sp.Expr, int | None]) -> bool | None:
    """Whether a formula holds where its expressions have these signs; None if that is open."""
    match formula:
        case Relation(value, operator):
            sign = signs[value]
            if sign is None:
                return None
            return {"=": sign == 0, "!=": sign != 0, ">": sign > 0, ">=": sign >= 0}[operator]
        case All(parts):
            truths = [holds_with(part, signs) for part in parts]
            return False if False in truths else None if None in truths else True
        case Some(parts):
            truths = [holds_with(part, signs) for part in parts]
            return True if True in truths else None if None in truths else False


def holds_at(formula: Formula, point: Point, *, exactly: bool = False) -> bool | None:
    """Whether a formula holds at a point; None where that is not certain.

    ``exactly`` also asks algebra whether an expression vanishes there, which takes longer.
    """
    return tester_of(formula).holds(point, exactly=exactly)
