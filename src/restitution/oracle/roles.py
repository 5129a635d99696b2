"""What a letter may be: its kind, and the interval in which its values lie."""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Literal

import sympy as sp

from restitution.records import dataclass

Kind = Literal["positive", "real", "angle", "restitution"]


@dataclass(frozen=True)
class Role:
    """A letter's kind and the interval in which its values lie (None is no bound)."""

    kind: Kind
    low: sp.Expr | None
    high: sp.Expr | None
    closed: tuple[bool, bool] = (False, False)

    def symbol(self, name: str) -> sp.Symbol:
        """The letter as a SymPy symbol that knows its sign."""
        return _symbol(name, self._sense)

    @cached_property
    def _sense(self) -> str:
        """What is assumed of the letter's sign.

        An angle that is known to be positive counts as acute, with a cosine of 0 or more.
        """
        if self.low is None or not self.low.is_nonnegative:
            return "real"
        if self.kind == "angle" and (self.high is None or self.high > sp.pi / 2):
            return "real"
        return "nonnegative" if self.low == 0 and self.closed[0] else "positive"


@lru_cache(maxsize=2048)
def _symbol(name: str, sense: str) -> sp.Symbol:
    return sp.Symbol(name, **{sense: True})


POSITIVE = Role("positive", sp.Integer(0), None)
REAL = Role("real", None, None)
ACUTE = Role("angle", sp.Integer(0), sp.pi / 2)
TO_180 = Role("angle", sp.Integer(0), sp.pi, (True, True))
DIRECTION = Role("angle", -sp.pi, sp.pi, (False, True))
COEFFICIENT = Role("restitution", sp.Integer(0), sp.Integer(1), (True, True))


def of_two_angles(one: Role, sign: str, other: Role) -> Role | None:
    """What the sum or the difference of two angles may be."""
    if one.kind != "angle" or other.kind != "angle":
        return None
    if one.low is None or one.high is None or other.low is None or other.high is None:
        return None
    ends, closed = (other.low, other.high), other.closed
    if sign == "-":
        ends, closed = (-other.high, -other.low), closed[::-1]
    low, high = one.low + ends[0], one.high + ends[1]
    return Role("angle", low, high, (one.closed[0] and closed[0], one.closed[1] and closed[1]))
