"""The irreducible factors of a polynomial over ℚ, in the same time each time.

SymPy lifts the factors of an image of the polynomial in one letter. The image is of numbers drawn
at random; an unlucky one splits although the polynomial does not, and to lift its factors through
ten letters never ends. Here the draws are the same for each polynomial, and where a letter stands
in its first power alone nothing is drawn: A x + B is irreducible once A and B have nothing in
common. So is A x² + B x + C where B² − 4AC is no square, which mostly one value of it shows.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import reduce
from math import isqrt
from typing import Any

from sympy.core import random as draws
from sympy.polys.rings import PolyElement

_Factors = tuple[Any, list[tuple[PolyElement, int]]]
# Values for the letters in turn, at which few numbers are squares by chance.
_POINTS = ((7, 11, -5, 13, 17, -3, 19, 23), (-29, 3, 31, 5, -37, 41, 2, 43))


def factor_list(a: PolyElement) -> _Factors:
    """A number and the irreducible factors with their powers, as ``a.factor_list()`` gives them.

    Each has whole coefficients without a common divisor, and a positive leading one. Raises
    CoercionFailed for a ring over no field or integers.
    """
    number, factors = _factor_list(a)
    return number, sorted(factors, key=_in_order) if len(factors) > 1 else factors


def _in_order(part: tuple[PolyElement, int]) -> tuple[Any, ...]:
    """SymPy's order of factors: the degree in the first letter, the power, the coefficients."""
    factor, power = part
    dense = factor.to_dense()
    return len(dense), power, dense


def _factor_list(a: PolyElement) -> _Factors:
    degrees = a.degrees()
    if a.ring.ngens > 1:
        for letter, degree in enumerate(degrees):
            if degree == 1:
                return _of_linear(a, letter)
        for letter, degree in enumerate(degrees):
            if degree == 2 and not _may_split(a, letter):
                coefficients = _coefficients(a, letter)
                return _with_content(a, reduce(PolyElement.gcd, coefficients))
    with _same_draws():
        number, factors = a.factor_list()
    return number, factors


def _of_linear(a: PolyElement, letter: int) -> _Factors:
    rest, slope = _coefficients(a, letter)
    if not rest:
        number, factors = _factor_list(slope)
        return number, [(a.ring.gens[letter], 1), *factors]
    return _with_content(a, slope.gcd(rest))


def _with_content(a: PolyElement, content: PolyElement) -> _Factors:
    """The factors of a multiple of an irreducible polynomial."""
    number, factors = _factor_list(content)
    share, own = a.quo(content).primitive()
    if own.LC < 0:
        share, own = -share, -own
    return number * share, [(own, 1), *factors]


def _coefficients(a: PolyElement, letter: int) -> list[PolyElement]:
    """The coefficients of the powers of one letter, that of its power 0 first."""
    coefficients = [a.ring.zero for _ in range(a.degree(a.ring.gens[letter]) + 1)]
    for powers, number in a.items():
        rest = (*powers[:letter], 0, *powers[letter + 1 :])
        coefficients[powers[letter]][rest] = number
    return coefficients


def _may_split(a: PolyElement, letter: int) -> bool:
    """Whether a polynomial of degree 2 in a letter may have two factors with that letter.

    Then its discriminant is a square, and so is each value of that.
    """
    for point in _POINTS:
        coefficients = [a.ring.domain.zero] * 3
        for powers, number in a.items():
            value = number
            for n, power in enumerate(powers):
                if power and n != letter:
                    value = value * point[n % len(point)] ** power
            coefficients[powers[letter]] += value
        c, b, a_ = coefficients
        if not _is_square(b * b - 4 * a_ * c):
            return False
    return True


def _is_square(number: Any) -> bool:
    sides = int(number.numerator), int(number.denominator)
    return number >= 0 and all(isqrt(side) ** 2 == side for side in sides)


@contextmanager
def _same_draws() -> Iterator[None]:
    """SymPy's own draws begin anew; who else uses them has them back as they were."""
    state = draws.rng.getstate()
    draws.seed(1)
    try:
        yield
    finally:
        draws.rng.setstate(state)
