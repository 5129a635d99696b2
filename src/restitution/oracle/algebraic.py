"""Expressions made algebraic: roots in coprime radicands, roles of letters, rational ends."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ

from restitution.oracle.points import constant_interval, ends_of
from restitution.oracle.roles import REAL, Role

TRIGONOMETRIC = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)
INVERSE = (sp.atan, sp.acos, sp.asin, sp.atan2)

_TRIED = 10_000  # primes up to this are sought in what stands under a root


def algebraic(x: sp.Expr) -> sp.Expr:
    """Floats as the fractions that they are written as."""
    floats = x.atoms(sp.Float)
    return x.xreplace({value: sp.Rational(str(value)) for value in floats}) if floats else x


def radicands(x: sp.Pow) -> list[sp.Expr]:
    """What stands under a root; of a whole number its factors: small primes, and what is left.

    No more is sought, as a number of a hundred digits may take years.
    """
    base = x.base
    if base.is_Integer and base > 1:
        return list(_factors(int(base)))
    return [base]


@lru_cache(maxsize=4096)
def _factors(whole: int) -> tuple[sp.Integer, ...]:
    """The small primes of a whole number, and what is left: the same each time.

    SymPy finds more of them once it has met these numbers elsewhere.
    """
    primes = sp.factorint(whole, limit=_TRIED)
    return tuple(sp.Integer(p) for p, n in sorted(primes.items()) for _ in range(n))


def role_of(x: sp.Symbol) -> Role:
    """What a symbol may be, by what SymPy assumes of it."""
    if x.is_positive:
        return Role("positive", sp.Integer(0), None)
    if x.is_nonnegative:
        return Role("positive", sp.Integer(0), None, (True, False))
    return REAL


def rational_or_none(x: sp.Expr | None) -> Fraction | None:
    """A rational number as a fraction."""
    return Fraction(int(x.p), int(x.q)) if x is not None and x.is_Rational else None


def end_below(x: sp.Expr) -> Fraction:
    """A fraction that is certain to be at most a number, by its forty digits."""
    return ends_of(constant_interval(x, 40))[0]


def end_above(x: sp.Expr) -> Fraction:
    """A fraction that is certain to be at least a number."""
    return ends_of(constant_interval(x, 40))[1]


def domain_number(x: Fraction) -> Any:
    """A fraction as an element of the domain of rationals."""
    # The numbers of mpmath are those of gmpy2 where it is installed, and FLINT takes none of them.
    return QQ(int(x.numerator), int(x.denominator))
