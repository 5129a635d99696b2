"""Every line of a worked solution is checked by numbers before it is printed."""

from __future__ import annotations

import operator
from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import sympy as sp

from restitution.explain.steps import Row
from restitution.solve.numbers import UndefinedError, at

_TOLERANCE = 1e-18
_ORDERED = {"<": operator.lt, "≤": operator.le, ">": operator.gt, "≥": operator.ge}


def holds(row: Row, sample: Mapping[str, Any]) -> bool:
    """Whether a line is true at a sample of the letters.

    Operands without a value (rounded ones, words) are not asked. An operand that has no value
    at the sample makes the line fail.
    """
    known = [(value, index) for index, value in enumerate(row.values) if value is not None]
    try:
        for (left, i), (right, k) in pairwise(known):
            if any(sign not in ("=", *_ORDERED, "≠") for sign in row.signs[i:k]):
                continue
            sign = next((s for s in row.signs[i:k] if s != "="), "=")
            if not _related(left, sign, right, sample):
                return False
    except (UndefinedError, KeyError, TypeError, ValueError, ArithmeticError):
        return False
    return True


def _related(left: Any, sign: str, right: Any, sample: Mapping[str, Any]) -> bool:
    if isinstance(left, tuple) != isinstance(right, tuple):
        return False
    pairs = zip(left, right, strict=True) if isinstance(left, tuple) else [(left, right)]
    for one, other in pairs:
        a, b = at(sp.sympify(one, strict=True), sample), at(sp.sympify(other, strict=True), sample)
        close = abs(a - b) <= _TOLERANCE * (1 + abs(a) + abs(b))
        if sign == "=" and not close:
            return False
        if sign == "≠" and close:
            return False
        if sign in _ORDERED:
            if close:
                if sign in "<>":
                    return False
            elif not _ORDERED[sign](a, b):
                return False
    return True
