"""Values of an expression at admissible points, to as many digits as are asked for.

What is assumed of a letter is what its SymPy symbol says. A positive letter alone inside a sine,
cosine or tangent is an acute angle, as everywhere in the language of statements. Nonnegative
letters are coefficients of restitution, tried out between 0 and 1.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import sympy
from sympy import Add, Expr, Float, Mul, Pow, Rational, S, Symbol

from restitution.exact.simplicity import MASKED, TRIGONOMETRIC, WITHOUT_VALUE
from restitution.work import spend

# A float is not trusted with the sign of a sum that cancels to so small a part.
_DOUBTFUL = 1e-9


def has_one_sign(total: Expr) -> bool:
    """Whether turning a sum round would make it negative at all admissible letters tried."""
    return _all_of(_samples(total), lambda value: value > 0)


def is_negative(total: Expr) -> bool:
    """Whether a sum is negative at all samples: how it is written depends on it, and no truth."""
    return _all_of(_samples(total), lambda value: value < 0)


def _all_of(values: Iterator[float], test: Callable[[float], bool]) -> bool:
    """Whether there are values and all pass; none is worked out beyond the first that fails."""
    any_ = False
    for value in values:
        if not test(value):
            return False
        any_ = True
    return any_


def _samples(total: Expr) -> Iterator[float]:
    """Values at fixed admissible points; none if a letter may have either sign."""
    letters = sorted(total.free_symbols, key=sympy.default_sort_key)
    if any(letter.is_extended_nonnegative is not True for letter in letters):
        return
    generator = random.Random(5)
    # One letter after the other is made large or small: u − 8v has no sign of its own, nor has
    # 14e − 1.
    masked = [x for x in letters if isinstance(x, sympy.Dummy) and x.name in MASKED]
    ends = [
        (letter, end)
        for letter in letters
        if letter not in masked
        for end in (
            (Fraction(1, 10_000), Fraction(1000))
            if letter.is_positive or letter.name == "root"
            else (Fraction(1, 10_000), Fraction(9_999, 10_000))
        )
    ]
    for index in range(6 + len(ends)):
        point = {letter: _sample(letter, generator, False) for letter in letters}
        if index >= 6:
            point[ends[index - 6][0]] = ends[index - 6][1]
        if masked:
            point.update(_of_an_angle(masked, generator))
        value = _with_its_sign(total, point)
        if value is None:
            return
        yield value


def _with_its_sign(value: Expr, point: dict[Symbol, Fraction]) -> float | None:
    """A real value whose sign is right; None where there is none."""
    try:
        rough = _in_floats(value, {letter: float(number) for letter, number in point.items()})
    except OverflowError:
        rough = None
    if rough is not None and abs(rough[0]) > rough[1] * _DOUBTFUL:
        return rough[0]
    number = value.evalf(15, subs={letter: _precise(x) for letter, x in point.items()})
    return float(number) if number.is_Float or number.is_Integer else None


def _in_floats(value: Expr, point: dict[Symbol, float]) -> tuple[float, float] | None:
    """A value in floats and the size that it would have if no sum cancelled; None if it is none."""
    if value.is_Symbol:
        return point[value], abs(point[value])
    if value.is_Rational:
        number = float(value)
        return number, abs(number)
    if not isinstance(value, Add | Mul | Pow):
        return None
    if isinstance(value, Pow):
        base = _in_floats(value.base, point)
        if base is None or base[0] == 0 or not value.exp.is_Rational:
            return None
        exponent = float(value.exp)
        if base[0] < 0 and not value.exp.is_Integer:
            return None
        power = base[0] ** exponent
        return power, abs(power) * (base[1] / abs(base[0])) ** abs(exponent)
    total, size = (0.0, 0.0) if value.is_Add else (1.0, 1.0)
    for argument in value.args:
        part = _in_floats(argument, point)
        if part is None:
            return None
        total = total + part[0] if value.is_Add else total * part[0]
        size = size + part[1] if value.is_Add else size * part[1]
    return total, size


def _of_an_angle(masked: list[Symbol], generator: random.Random) -> dict[Symbol, Fraction]:
    """Values for masked functions: of one acute angle where they may be, else of several."""
    several = len({x.name for x in masked}) < len(masked)
    angle = generator.uniform(0.05, 1.5)
    values = {}
    for value in masked:
        angle = generator.uniform(0.05, 1.5) if several else angle
        values[value] = Fraction(getattr(math, value.name)(angle))
    return values


def _sample(letter: Symbol, generator: random.Random, acute: bool) -> Fraction:
    """A random admissible value of a letter."""
    value = Fraction(generator.randrange(10**12) + 1, 10**12)
    if acute:
        return Fraction(1, 10) + value * Fraction(13, 10)
    if letter.is_positive:
        return Fraction(1, 7) + 3 * value
    if letter.is_nonnegative:
        return Fraction(1, 50) + Fraction(24, 25) * value
    if letter.is_negative:
        return -Fraction(1, 7) - 3 * value
    return 6 * value - 3


def _precise(value: Fraction) -> Float:
    """A value to 110 digits."""
    return Float(Rational(value.numerator, value.denominator), 110)


def admissible_points(
    value: Expr, generator: random.Random, count: int
) -> Iterator[dict[Symbol, Float]]:
    """Random admissible values of the letters of an expression, at most so many times."""
    letters = sorted(value.free_symbols, key=sympy.default_sort_key)
    if not letters:
        yield {}
        return
    inside: set[Any] = set()
    for atom in value.atoms(*TRIGONOMETRIC):
        inside |= atom.free_symbols
    for _ in range(count):
        yield {
            x: _precise(_sample(x, generator, x in inside and bool(x.is_positive))) for x in letters
        }


def value_at(
    value: Expr, point: dict[Symbol, Float], digits: int, real_only: bool
) -> tuple[Any, Any] | None:
    """The value at a point and the scale on which it may be called zero.

    None if there is no value there or, with ``real_only``, no real one.

    The scale is that of the terms, so that units do not matter.
    """
    spend()
    try:
        number = value.evalf(digits, subs=point, maxn=4 * digits)
        scale = _scale(value, point)
    except WITHOUT_VALUE:
        return None
    if not number.is_number or number.has(S.NaN, S.ComplexInfinity, S.Infinity):
        return None
    if not number.is_real:
        real, imaginary = number.as_real_imag()
        if abs(imaginary) > abs(real) * Float("1e-20"):
            if point and real_only:
                return None
            number = abs(number)
        else:
            number = real
    return number, scale


def _scale(value: Expr, point: dict[Symbol, Float]) -> Any:
    """How large an expression is where no sum in it cancels."""
    if value.is_Add:
        sizes = [_scale(argument, point) for argument in value.args]
        return max(size for size in sizes if size.is_real)
    if value.is_Mul and value.has(Add):
        return math.prod(_scale(argument, point) for argument in value.args)
    if value.is_Pow and value.exp.is_Rational and value.exp > 0 and value.base.has(Add):
        return _scale(value.base, point) ** value.exp
    return abs(value.evalf(15, subs=point))
