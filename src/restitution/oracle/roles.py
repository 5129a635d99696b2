"""What a letter may be: its kind, and the interval in which its values lie."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import sympy as sp

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
        if self.low is not None and self.low.is_nonnegative:
            if self.low == 0 and self.closed[0]:
                return sp.Symbol(name, nonnegative=True)
            return sp.Symbol(name, positive=True)
        return sp.Symbol(name, real=True)


POSITIVE = Role("positive", sp.Integer(0), None)
REAL = Role("real", None, None)
ACUTE = Role("angle", sp.Integer(0), sp.pi / 2)
TO_180 = Role("angle", sp.Integer(0), sp.pi, (True, True))
DIRECTION = Role("angle", -sp.pi, sp.pi, (False, True))
COEFFICIENT = Role("restitution", sp.Integer(0), sp.Integer(1), (True, True))
