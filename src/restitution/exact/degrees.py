"""Cosine and sine of multiples of π that stay as they are: cos 42° and no nested roots.

SymPy writes those of 36°, 42° and of other multiples of 3° by roots within roots. Nobody reads
these, and to bring them into their usual form takes seconds: only multiples of 30° and 45° have
surds. Those of 15° and 75° are sums of two, which nobody reads either.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import sympy
from sympy import Expr, Rational

_STEPS = 12
"""Multiples of π over this have ratios made of roots, long ones too."""

_STANDARD = (1, 2, 3, 4, 6)
"""The denominators of multiples of π that have surds."""

_RIGHT = Fraction(1, 2)

# They bear the names of SymPy's, by which it prints and computes them.


class cos(sympy.cos):  # type: ignore[misc]  # noqa: N801
    """A cosine that is never written by roots."""

    @classmethod
    def eval(cls, arg: Expr) -> None:
        """Nothing else than it is."""

    def _eval_expand_trig(self, **_: Any) -> Expr:
        return self


class sin(sympy.sin):  # type: ignore[misc]  # noqa: N801
    """A sine that is never written by roots."""

    @classmethod
    def eval(cls, arg: Expr) -> None:
        """Nothing else than it is."""

    def _eval_expand_trig(self, **_: Any) -> Expr:
        return self


class tan(sympy.tan):  # type: ignore[misc]  # noqa: N801
    """A tangent that is never written by roots."""

    @classmethod
    def eval(cls, arg: Expr) -> None:
        """Nothing else than it is."""

    def _eval_expand_trig(self, **_: Any) -> Expr:
        return self


def cosine(turns: Fraction) -> Expr:
    """The cosine of a multiple of π by that of an acute angle."""
    turns %= 2
    turns = min(turns, 2 - turns)
    if turns > _RIGHT:
        return -_ratio(sympy.cos, 1 - turns)
    return _ratio(sympy.cos, turns)


def cosine_beside(turns: Fraction, others: Iterable[Fraction]) -> Expr:
    """A cosine beside those of other multiples of π: of 15° beside 65° it has roots.

    There 15° is the difference of two angles, and none of the data.
    """
    if _STEPS % turns.denominator == 0 and any(_STEPS % other.denominator for other in others):
        return sympy.cos(Rational(turns.numerator, turns.denominator) * sympy.pi)
    return cosine(turns)


def sine(turns: Fraction) -> Expr:
    """The sine of a multiple of π by that of an acute angle."""
    turns %= 2
    if turns > 1:
        return -sine(turns - 1)
    return _ratio(sympy.sin, min(turns, 1 - turns))


def tangent(angle: Expr) -> Expr:
    """The tangent of an angle; a multiple of π stays as it is."""
    own = sympy.tan(angle)
    turns = turns_of(angle)
    if turns is None or not turns or is_standard(turns) or own.has(sympy.tan):
        return own
    return tan(angle)


def with_ratio(function: type, angle: Expr) -> Expr:
    """A sine, cosine or tangent of an angle; that of a multiple of π stays as it is."""
    if function is sympy.tan:
        return tangent(angle)
    turns = turns_of(angle)
    if turns is None:
        return function(angle)
    return cosine(turns) if function is sympy.cos else sine(turns)


def function_of(x: Expr) -> type:
    """The function of an expression as SymPy knows it."""
    function: type = {cos: sympy.cos, sin: sympy.sin, tan: sympy.tan}.get(x.func, x.func)
    return function


def sine_beside(x: Expr) -> Expr | None:
    """The sine of the angle of a cosine; None of another expression."""
    if not isinstance(x, sympy.cos):
        return None
    return (sin if isinstance(x, cos) else sympy.sin)(x.args[0])


def is_standard(turns: Fraction) -> bool:
    """Whether a multiple of π has a table's ratios, as 30° and 45° have."""
    return turns.denominator in _STANDARD


def has_sums_of_surds(angle: Expr) -> bool:
    """Whether the ratios of an angle are sums of surds, as those of 15° and 75° are."""
    turns = turns_of(angle)
    return turns is not None and turns.denominator == _STEPS


def turns_of(angle: Expr) -> Fraction | None:
    """An angle as a multiple of π; None where it is no rational one."""
    turns = angle / sympy.pi
    return Fraction(int(turns.p), int(turns.q)) if turns.is_Rational else None


def _ratio(function: type[sympy.sin | sympy.cos], turns: Fraction) -> Expr:
    angle = Rational(turns.numerator, turns.denominator) * sympy.pi
    own = function(angle)
    if isinstance(own, sympy.sin | sympy.cos) or is_standard(turns):
        return own
    return cos(angle) if function is sympy.cos else sin(angle)


__all__ = [
    "cosine",
    "cosine_beside",
    "function_of",
    "has_sums_of_surds",
    "is_standard",
    "sine",
    "sine_beside",
    "tangent",
    "turns_of",
    "with_ratio",
]
