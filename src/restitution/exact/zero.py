"""Whether an expression is zero, or two are the same."""

from __future__ import annotations

import math
import random
from typing import Any

import sympy
from sympy import Expr, Float

from restitution.exact.directions import direction_of
from restitution.exact.numbers import tidy_number
from restitution.exact.samples import admissible_points, value_at
from restitution.exact.simplicity import SEARCHED, WITHOUT_VALUE, node_count
from restitution.exact.textbook import tidy

MOST_DIGITS = 20_000


def same(a: Any, b: Any) -> bool:
    """Whether two expressions are equal for all admissible values of their letters.

    See `is_zero` for how that is decided.
    """
    left, right = sympy.sympify(a, strict=True), sympy.sympify(b, strict=True)
    if left == right:
        return True
    if not isinstance(left, Expr) or not isinstance(right, Expr):
        return False
    if left.is_infinite or right.is_infinite:
        return False
    return is_zero(left - right)


def is_zero(expression: Any) -> bool:
    """Whether an expression is zero for all admissible values of its letters.

    It is refuted by a value to 30 digits at up to four random admissible points that is not
    zero. What survives is proved zero by rational normal form, with sines and cosines reduced
    and surds rationalised. Else a number made with roots is calculated to as many digits as any
    such number needs to be told from zero (`digits_apart`). An expression in letters, a long sum
    of angles, or a number of another kind, is taken to be zero if it vanishes to 100 digits at
    fresh points: claims about letters are for the oracle to decide.
    """
    value = sympy.sympify(expression, strict=True)
    if value.is_Number:
        return bool(value == 0)
    if not isinstance(value, Expr):
        return False
    generator = random.Random(20)
    seen, real = 0, True
    # Where no point tried gives a real value, complex values must do.
    for real in (True, False):
        for point in admissible_points(value, generator, 8):
            rounded = value_at(value, point, 30, real)
            if rounded is None:
                continue
            number, scale = rounded
            if abs(number) > scale * 1e-20:
                return False
            seen += 1
            if seen == (4 if point else 1):
                break
        if seen:
            break
    if _proved_zero(value):
        return True
    if not value.free_symbols:
        number = _zero_direction(value)
        digits = None if number is None else digits_apart(number)
        if number is not None and digits is not None:
            return bool(abs((number + 1).evalf(digits + 10) - 1) < Float(10) ** -digits)
    return bool(seen) and all(
        rounded is None or abs(rounded[0]) <= rounded[1] * Float("1e-85", 20)
        for point in admissible_points(value, generator, 3)
        for rounded in [value_at(value, point, 100, real)]
    )


def _zero_direction(value: Expr) -> Expr | None:
    """What is zero just where a small number is, and is made with roots: the sine of an angle."""
    if not value.has(sympy.atan, sympy.asin, sympy.acos, sympy.atan2):
        return value
    if value.count_ops() > _LONGEST_ANGLE:
        return None  # multiplied out, its sine would take minutes
    direction = direction_of(value)
    return None if direction is None else direction[1]


_LONGEST_ANGLE = 150


def digits_apart(value: Expr) -> int | None:
    """So many digits tell a number made with roots from zero; None if there is no such bound.

    This is the bound of Burnikel, Fleischer, Mehlhorn and Schirra (A strong and easily computable
    separation bound for arithmetic expressions involving radicals, Algorithmica 27, 2000): for
    each part, ``above`` and ``below`` bound all conjugates of a numerator and a denominator that
    are algebraic integers, and ``degree`` bounds the degree of all together.
    """
    degree = 1
    seen: dict[Expr, tuple[float, float]] = {}

    def bounds(x: Expr) -> tuple[float, float]:
        """Logarithms of what bounds the conjugates above and below the line."""
        nonlocal degree
        if x in seen:
            return seen[x]
        if x.is_Rational:
            above, below = _log(abs(int(x.p))), _log(int(x.q))
        elif x.is_Add:
            above, below = bounds(x.args[0])
            for argument in x.args[1:]:
                a, b = bounds(argument)
                above, below = max(above + b, a + below) + math.log(2), below + b
        elif x.is_Mul:
            parts = [bounds(argument) for argument in x.args]
            above, below = sum(a for a, _ in parts), sum(b for _, b in parts)
        elif x.is_Pow and x.exp.is_Rational:
            above, below = bounds(x.base)
            power, root = abs(int(x.exp.p)), int(x.exp.q)
            above, below = above * power, below * power
            if x.exp.p < 0:
                above, below = below, above
            degree *= root
            if above >= below:
                above = (above + (root - 1) * below) / root
            else:
                below = (below + (root - 1) * above) / root
        elif isinstance(x, sympy.cos | sympy.sin) and (x.args[0] / sympy.pi).is_Rational:
            # Twice it is an algebraic integer whose conjugates are such numbers as well.
            above = below = math.log(2)
            degree *= 2 * int((x.args[0] / sympy.pi).q)
        else:
            raise ValueError(x)
        seen[x] = above, below
        return above, below

    try:
        above, below = bounds(value)
    except (ValueError, TypeError):
        return None
    digits = (below + (degree - 1) * max(above, 0.0)) / math.log(10)
    return int(digits) + 2 if digits < MOST_DIGITS else None


def _log(n: int) -> float:
    return math.log(n) if n else 0.0


def _proved_zero(value: Expr) -> bool:
    """A proof by normal form; False proves nothing."""
    if node_count(value, SEARCHED) >= SEARCHED:
        return False
    try:
        if not value.free_symbols:
            return bool(tidy_number(value) == 0)
        return bool(tidy(value) == 0)
    except WITHOUT_VALUE:
        return False
