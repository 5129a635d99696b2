"""Decimals: values to double precision and to significant figures."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy
from sympy import Expr, Float, Rational

from restitution.exact.symbols import symbols_in
from restitution.exact.zero import is_zero


def decimal(expression: Any) -> float | None:
    """The value to double precision, or None where letters remain or it is not a real number."""
    value = sympy.sympify(expression, strict=True)
    if not isinstance(value, Expr) or value.free_symbols:
        return None
    try:
        number = complex(value.evalf(30, maxn=200))
    except (TypeError, ValueError, OverflowError, ArithmeticError):
        return None
    if number.imag != 0 and abs(number.imag) > 1e-25 * abs(number):
        return None
    return number.real + 0.0


def significant(expression: Any, figures: int = 3) -> str:
    """The value to so many significant figures, as written in an examination.

    Halves are rounded away from zero; trailing zeros are kept (``1.20``), integers are padded
    (``12300``); from 10⁷ and below 10⁻⁴ a power of ten is split off (``1.23 × 10⁸``).
    Raises ValueError for an expression with letters or without a real value.
    """
    value = sympy.sympify(expression, strict=True)
    exact = _as_fraction(value, figures)
    if exact == 0:
        return "0"
    sign = "-" if exact < 0 else ""
    digits, exponent = _round(abs(exact), figures)
    if exponent >= 7 or exponent < -4:
        mantissa = _place_point(digits, 0)
        return f"{sign}{mantissa} × 10{_superscript(exponent)}"
    return sign + _place_point(digits, exponent)


def _as_fraction(value: Any, figures: int) -> Fraction:
    """A rational that rounds as the value does to so many figures."""
    if isinstance(value, Expr) and not symbols_in(value):
        if isinstance(value, Rational):
            return Fraction(int(value.p), int(value.q))
        for digits in (figures + 25, figures + 80):
            number = value.evalf(digits, maxn=400)
            real, imaginary = number.as_real_imag()
            if not real.is_Float and not real.is_Rational:
                break
            if imaginary != 0 and abs(imaginary) > abs(real) * Float("1e-20"):
                break
            if abs(real) < Float("1e-40") and is_zero(value):
                return Fraction(0)
            exact = Rational(real)
            fraction = Fraction(int(exact.p), int(exact.q))
            if fraction == 0:
                return fraction
            close = _near_tie(fraction, figures)
            if close is None:
                return fraction
        else:
            return close if close is not None else fraction
    raise ValueError(f"{value} has no real value to be rounded")


def _near_tie(value: Fraction, figures: int) -> Fraction | None:
    """The tie that a value is within 10⁻¹⁵ of a last figure of, or None."""
    unit = Fraction(10) ** (_exponent(abs(value)) - figures + 1)
    doubled = value / unit * 2
    nearest = round(doubled)
    if nearest % 2 and abs(doubled - nearest) < Fraction(1, 10**15):
        return nearest * unit / 2
    return None


def _exponent(value: Fraction) -> int:
    """The power of ten of the first digit of a positive number."""
    power = (value.numerator.bit_length() - value.denominator.bit_length()) * 3 // 10
    while Fraction(10) ** power > value:
        power -= 1
    while Fraction(10) ** (power + 1) <= value:
        power += 1
    return power


def _round(value: Fraction, figures: int) -> tuple[str, int]:
    """The digits of a positive number rounded half up, and the power of ten of the first."""
    power = _exponent(value)
    scaled = value / Fraction(10) ** (power - figures + 1)
    digits = int(scaled + Fraction(1, 2))
    if digits >= 10**figures:
        digits //= 10
        power += 1
    return str(digits), power


def _place_point(digits: str, exponent: int) -> str:
    if exponent < 0:
        return "0." + "0" * (-exponent - 1) + digits
    if exponent + 1 >= len(digits):
        return digits + "0" * (exponent + 1 - len(digits))
    return digits[: exponent + 1] + "." + digits[exponent + 1 :]


def _superscript(power: int) -> str:
    return str(power).translate(str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"))
