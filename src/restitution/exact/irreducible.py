"""The irreducible factors of a polynomial over ℚ, in the same time each time.

SymPy lifts the factors of an image of the polynomial in one letter. The image is of numbers drawn
at random; an unlucky one splits although the polynomial does not, and to lift its factors through
ten letters never ends. Here the draws are the same for each polynomial, and where a letter stands
in its first power alone nothing is drawn: A x + B is irreducible once A and B have nothing in
common.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from sympy.core import random as draws
from sympy.polys.rings import PolyElement


def factor_list(a: PolyElement) -> tuple[Any, list[tuple[PolyElement, int]]]:
    """A number and the irreducible factors with their powers, as ``a.factor_list()`` gives them.

    The order of the factors may differ. Each has whole coefficients without a common divisor, and
    a positive leading one. Raises CoercionFailed for a ring over no field or integers.
    """
    for letter, degree in enumerate(a.degrees()):
        if degree == 1 and a.ring.ngens > 1:
            slope, rest = _in_powers_of(a, letter)
            if not rest:
                number, factors = factor_list(slope)
                return number, [(a.ring.gens[letter], 1), *factors]
            common = slope.gcd(rest)
            number, factors = factor_list(common)
            share, own = a.quo(common).primitive()
            if own.LC < 0:
                share, own = -share, -own
            return number * share, [(own, 1), *factors]
    with _same_draws():
        number, factors = a.factor_list()
    return number, factors


def _in_powers_of(a: PolyElement, letter: int) -> tuple[PolyElement, PolyElement]:
    """The coefficients of a polynomial that is linear in one letter: of it, and the rest."""
    slope, rest = a.ring.zero, a.ring.zero
    for powers, number in a.items():
        if powers[letter]:
            slope[(*powers[:letter], 0, *powers[letter + 1 :])] = number
        else:
            rest[powers] = number
    return slope, rest


@contextmanager
def _same_draws() -> Iterator[None]:
    """SymPy's own draws begin anew; who else uses them has them back as they were."""
    state = draws.rng.getstate()
    draws.seed(1)
    try:
        yield
    finally:
        draws.rng.setstate(state)
