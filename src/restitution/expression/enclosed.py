"""Real numbers of which two ends are known, between which they lie for certain.

Nothing is taken to be zero because it is small: a mass may be 10⁻⁶⁰ and a speed 10⁻⁶⁰. What has a
sign is on one side of zero with all that rounding can have done; what rounding has left of a number
that vanishes has zero between its ends, and so has the root of it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from mpmath.libmp import (
    dps_to_prec,
    finf,
    fnan,
    fninf,
    fnone,
    fone,
    from_float,
    from_int,
    from_man_exp,
    from_rational,
    fzero,
    mpf_add,
    mpf_atan,
    mpf_lt,
    mpf_sign,
    mpf_sub,
    mpi_abs,
    mpi_add,
    mpi_atan,
    mpi_atan2,
    mpi_cos_sin,
    mpi_div,
    mpi_exp,
    mpi_log,
    mpi_mid,
    mpi_mul,
    mpi_neg,
    mpi_pow_int,
    mpi_sub,
    round_ceiling,
    round_floor,
    to_float,
    to_rational,
    to_str,
)
from mpmath.libmp.libmpi import mpi_pi

# Intervals are pairs of the numbers of ``mpmath.libmp``: its functions take the precision with
# each operation, and are a few times faster than the objects of a context.
Interval = tuple[Any, Any]
_ONE: Interval = (fone, fone)
_ZERO: Interval = (fzero, fzero)


class UndefinedError(ArithmeticError):
    """An expression has no real value at a point."""


# --- intervals --------------------------------------------------------------------------------


def whole_power_in(precision: int, base: Interval | None, n: int) -> Interval:
    """A whole power. Raises UndefinedError for a negative power of zero."""
    if base is None or (n < 0 and holds_zero(base)):
        raise UndefinedError("division by zero")
    return mpi_pow_int(base, n, precision)  # type: ignore[no-any-return]


def power_in(precision: int, base: Interval | None, p: int, q: int) -> Interval:
    """The power p/q. Raises UndefinedError where it is not real."""
    if base is None or mpf_sign(base[1]) < 0 or (p < 0 and mpf_sign(base[0]) <= 0):
        raise UndefinedError
    if mpf_sign(base[0]) < 0:  # what is not known to be negative may be nothing
        base = fzero, base[1]
    if q == 2:
        return mpi_pow_int(_roots(base, precision), p, precision)  # type: ignore[no-any-return]
    if mpf_sign(base[0]) <= 0:
        raise UndefinedError
    exponent = fraction_in(precision, Fraction(p, q))
    logarithm = mpi_mul(mpi_log(base, precision), exponent, precision)
    return mpi_exp(logarithm, precision)  # type: ignore[no-any-return]


@lru_cache(maxsize=4096)
def fraction_in(precision: int, value: Fraction) -> Interval:
    """A fraction between numbers of so many bits."""
    above, below = value.numerator, value.denominator
    return (
        from_rational(above, below, precision, round_floor),
        from_rational(above, below, precision, round_ceiling),
    )


@lru_cache(maxsize=1024)
def cos_sin_in(precision: int, x: Interval) -> tuple[Interval, Interval]:
    """The cosine and the sine of an angle; the angles that are given come again and again."""
    cosine, sine = mpi_cos_sin(x, precision)
    return cosine, sine


def function_in(precision: int, operation: str, inner: Sequence[Interval]) -> Interval:
    """A function by its name. Raises UndefinedError where it has no real value for certain."""
    x = inner[0]
    if operation in ("sin", "cos", "tan", "sec", "cot", "csc"):
        cosine, sine = cos_sin_in(precision, x)
        if operation in ("sin", "cos"):
            return sine if operation == "sin" else cosine
        below = cosine if operation in ("tan", "sec") else sine
        if holds_zero(below):
            raise UndefinedError
        above = {"tan": sine, "cot": cosine}.get(operation, _ONE)
        return mpi_div(above, below, precision)  # type: ignore[no-any-return]
    if operation == "atan":
        return _arctangents(x, precision)
    if operation == "acot":
        if holds_zero(x):
            raise UndefinedError
        return _arctangents(mpi_div(_ONE, x, precision), precision)
    if operation in ("acos", "asin"):
        if mpf_lt(x[1], fnone) or mpf_lt(fone, x[0]):
            raise UndefinedError
        other = mpi_sub(_ONE, mpi_mul(x, x, precision), precision)
        if mpf_sign(other[1]) < 0:
            raise UndefinedError
        if mpf_sign(other[0]) < 0:
            other = fzero, other[1]
        other = _roots(other, precision)
        pair = (other, x) if operation == "acos" else (x, other)
        return mpi_atan2(*pair, precision)  # type: ignore[no-any-return]
    if operation == "atan2":
        y, x = inner
        if mpf_sign(x[0]) <= 0 and holds_zero(y):
            if y == _ZERO and mpf_sign(x[1]) < 0:
                return mpi_pi(precision)  # type: ignore[no-any-return]
            raise UndefinedError
        return mpi_atan2(y, x, precision)  # type: ignore[no-any-return]
    if operation == "abs":
        return mpi_abs(x, precision)  # type: ignore[no-any-return]
    if operation == "sign":
        sign = sign_of(x)
        if sign is None:
            raise UndefinedError
        return (fone, fone) if sign > 0 else (fnone, fnone)
    low, high = x
    for a, b in inner[1:]:
        if operation == "max":
            low, high = (a if mpf_lt(low, a) else low), (b if mpf_lt(high, b) else high)
        else:
            low, high = (a if mpf_lt(a, low) else low), (b if mpf_lt(b, high) else high)
    return low, high


def _roots(x: Interval, precision: int) -> Interval:
    """The square roots of an interval without negative numbers, as ``mpi_sqrt`` has them.

    That takes whole roots in Python, and of either end where there is but one.
    """
    low, high = x
    if low != high:
        return _root(low, precision)[0], _root(high, precision)[1]
    return _root(low, precision)


def _root(x: Any, precision: int) -> Interval:
    """A square root between numbers of so many bits."""
    _, mantissa, exponent, bits = x
    if not mantissa:
        return x, x
    shift = max(4, 2 * precision - bits + 4)
    shift += (exponent - shift) & 1
    whole = mantissa << shift
    root = math.isqrt(whole)
    exponent = (exponent - shift) // 2
    low = from_man_exp(root, exponent, precision, round_floor)
    if root * root != whole:  # a little more, of which only is rounded that it is more
        root, exponent = 2 * root + 1, exponent - 1
    return low, from_man_exp(root, exponent, precision, round_ceiling)


def _arctangents(x: Interval, precision: int) -> Interval:
    """The arctangents of an interval, whose ends are no further apart than the tangents."""
    low, high = x
    if high in (finf, fninf) or low in (finf, fninf):
        return mpi_atan(x, precision)  # type: ignore[no-any-return]
    least = most = fzero
    if low != fzero:
        # Ten bits more, so that it need not be rounded well: one of the last place is left on
        # either side.
        first = mpf_atan(low, precision + 10, round_floor)
        _, _, exponent, bits = first
        last = from_man_exp(1, exponent + bits - precision)
        least = mpf_sub(first, last, precision, round_floor)
        most = mpf_add(first, last, precision, round_ceiling)
    if low != high:
        most = mpf_add(most, mpf_sub(high, low), precision, round_ceiling)
    return least, most


def sign_of(interval: Interval) -> int | None:
    """1 or -1; None where an interval has zero in it."""
    low, high = interval
    return 1 if mpf_sign(low) > 0 else -1 if mpf_sign(high) < 0 else None


def holds_zero(interval: Interval) -> bool:
    """Whether zero is in an interval."""
    low, high = interval
    return bool(mpf_sign(low) <= 0 <= mpf_sign(high))


# --- numbers ----------------------------------------------------------------------------------

DIGITS = 400
_PRECISION = dps_to_prec(DIGITS)


class Enclosed:
    """A real number between two ends of 400 digits, with the arithmetic of numbers.

    One is less than another where all of it is. ``sign`` is 0 where it may be zero: what has no
    sign at 400 digits is zero in all but made-up cases, and who must know asks the oracle.
    Equality is that of the ends.
    """

    __slots__ = ("ends",)

    def __init__(self, ends: Interval) -> None:
        self.ends = ends

    @classmethod
    def of(cls, value: Enclosed | Fraction | float) -> Enclosed:
        """A number as one of these. Raises UndefinedError for what is infinite or no number."""
        return cls(_interval(value))

    @property
    def sign(self) -> int:
        """1 or -1 where that is certain, else 0."""
        return sign_of(self.ends) or 0

    @property
    def fraction(self) -> Fraction:
        """The middle, exactly."""
        return Fraction(*to_rational(self._middle))

    @property
    def between(self) -> tuple[Fraction, Fraction]:
        """The two ends, exactly."""
        low, high = (Fraction(*to_rational(end)) for end in self.ends)
        return low, high

    @property
    def _middle(self) -> Any:
        low, high = self.ends
        return low if low == high else mpi_mid(self.ends, _PRECISION)

    def hull(self, other: Enclosed) -> Enclosed:
        """The number of which only is known that it is between these two."""
        (a, b), (c, d) = self.ends, other.ends
        return Enclosed((c if mpf_lt(c, a) else a, d if mpf_lt(b, d) else b))

    def sqrt(self) -> Enclosed:
        """The square root. Raises UndefinedError for what is negative."""
        return Enclosed(power_in(_PRECISION, self.ends, 1, 2))

    def cos_sin(self) -> tuple[Enclosed, Enclosed]:
        """The cosine and the sine."""
        c, s = cos_sin_in(_PRECISION, self.ends)
        return Enclosed(c), Enclosed(s)

    def arc(self, function: str) -> Enclosed:
        """``asin``, ``acos`` or ``atan``. Raises UndefinedError beyond 1."""
        return Enclosed(function_in(_PRECISION, function, [self.ends]))

    @classmethod
    def atan2(cls, y: Enclosed | float, x: Enclosed | float) -> Enclosed:
        """The angle of a direction; 180° where it is not known to be on either side of that."""
        y, x = cls.of(y), cls.of(x)
        if not y.sign and x.sign <= 0:
            return PI if x.sign else cls(_ZERO)
        return cls(function_in(_PRECISION, "atan2", [y.ends, x.ends]))

    def __add__(self, other: Any) -> Enclosed:
        ends = other.ends if type(other) is Enclosed else _other(other)
        return NotImplemented if ends is None else Enclosed(_sum(self.ends, ends))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Enclosed:
        ends = other.ends if type(other) is Enclosed else _other(other)
        return NotImplemented if ends is None else Enclosed(_sum(self.ends, ends, -1))

    def __rsub__(self, other: Any) -> Enclosed:
        ends = _other(other)
        return NotImplemented if ends is None else Enclosed(_sum(ends, self.ends, -1))

    def __mul__(self, other: Any) -> Enclosed:
        ends = other.ends if type(other) is Enclosed else _other(other)
        return NotImplemented if ends is None else Enclosed(_product(self.ends, ends))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Enclosed:
        ends = _other(other)
        return NotImplemented if ends is None else Enclosed(_quotient(self.ends, ends))

    def __rtruediv__(self, other: Any) -> Enclosed:
        ends = _other(other)
        return NotImplemented if ends is None else Enclosed(_quotient(ends, self.ends))

    def __pow__(self, exponent: Any) -> Enclosed:
        if isinstance(exponent, Enclosed) and exponent.ends[0] == exponent.ends[1]:
            exponent = exponent.fraction
        if not isinstance(exponent, Enclosed):
            power = Fraction(exponent)
            if power.denominator == 1:
                return Enclosed(whole_power_in(_PRECISION, self.ends, power.numerator))
            if power.denominator < 2**16:  # a root, and no number of many digits
                return Enclosed(power_in(_PRECISION, self.ends, power.numerator, power.denominator))
        if mpf_sign(self.ends[0]) <= 0:
            if self.sign == 0 and Enclosed.of(exponent) > 0:
                return Enclosed(_ZERO)
            raise UndefinedError("a power of a negative number")
        logarithm = mpi_mul(mpi_log(self.ends, _PRECISION), _interval(exponent), _PRECISION)
        return Enclosed(mpi_exp(logarithm, _PRECISION))

    def __rpow__(self, base: Any) -> Enclosed:
        return Enclosed.of(base) ** self

    def __neg__(self) -> Enclosed:
        return Enclosed(mpi_neg(self.ends))

    def __pos__(self) -> Enclosed:
        return self

    def __abs__(self) -> Enclosed:
        return Enclosed(mpi_abs(self.ends))

    def __lt__(self, other: Any) -> bool:
        ends = _other(other)
        return NotImplemented if ends is None else bool(mpf_lt(self.ends[1], ends[0]))

    def __gt__(self, other: Any) -> bool:
        ends = _other(other)
        return NotImplemented if ends is None else bool(mpf_lt(ends[1], self.ends[0]))

    def __le__(self, other: Any) -> bool:
        """Whether it is not greater for certain."""
        ends = _other(other)
        return NotImplemented if ends is None else not mpf_lt(ends[1], self.ends[0])

    def __ge__(self, other: Any) -> bool:
        """Whether it is not less for certain."""
        ends = _other(other)
        return NotImplemented if ends is None else not mpf_lt(self.ends[1], ends[0])

    def __eq__(self, other: object) -> bool:
        ends = _other(other)
        return NotImplemented if ends is None else bool(self.ends == ends)

    def __hash__(self) -> int:
        return hash(self.ends)

    def __float__(self) -> float:
        return float(to_float(self._middle))

    def __str__(self) -> str:
        return str(to_str(self._middle, DIGITS))

    __repr__ = __str__


def _interval(value: Any) -> Interval:
    ends = _other(value)
    if ends is None:
        raise TypeError(value)
    return ends


def _other(value: Any) -> Interval | None:
    """The ends of an operand; None for what is no number."""
    if isinstance(value, Enclosed):
        return value.ends
    if isinstance(value, int):
        own = from_int(value)
        return own, own
    if isinstance(value, float):
        own = from_float(value)
        if own in (finf, fninf, fnan):
            raise UndefinedError(str(value))
        return own, own
    return fraction_in(_PRECISION, value) if isinstance(value, Fraction) else None


def _sum(one: Interval, other: Interval, sign: int = 1) -> Interval:
    """The sum, or the difference, of two numbers: of two that are exact exactly, if it is short."""
    low, high = one
    least, most = other
    if low == high and least == most:
        minus, a, p, _ = low
        back, b, q, _ = least
        if a and b and abs(p - q) < _PRECISION:
            exponent = min(p, q)
            whole = (-a if minus else a) << (p - exponent)
            whole += (-b if bool(back) is (sign > 0) else b) << (q - exponent)
            end = _exact(whole, exponent)
            if end is not None:
                return end, end
    act = mpi_add if sign > 0 else mpi_sub
    return act(one, other, _PRECISION)  # type: ignore[no-any-return]


def _exact(whole: Any, exponent: int) -> Any:
    """A whole number times a power of 2, as ``mpmath.libmp`` has it; None of one that is long."""
    size = abs(whole)
    if not size:
        return fzero
    shift = (size & -size).bit_length() - 1
    size >>= shift
    bits = size.bit_length()
    return (int(whole < 0), size, exponent + shift, bits) if bits <= _PRECISION else None


def _product(one: Interval, other: Interval) -> Interval:
    """The product of two numbers: of two that are exact exactly, if it is short."""
    low, high = one
    least, most = other
    if low == high and least == most:
        minus, a, p, _ = low
        back, b, q, _ = least
        whole = a * b  # odd, as both are
        bits = whole.bit_length()
        if whole and bits <= _PRECISION:
            end = minus ^ back, whole, p + q, bits
            return end, end
    return mpi_mul(one, other, _PRECISION)  # type: ignore[no-any-return]


def _quotient(above: Interval, below: Interval) -> Interval:
    if holds_zero(below):
        raise ZeroDivisionError("division by zero")
    return mpi_div(above, below, _PRECISION)  # type: ignore[no-any-return]


PI = Enclosed(mpi_pi(_PRECISION))
