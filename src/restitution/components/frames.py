"""The frames of impacts: directions in which velocities are resolved, components, principles."""

from __future__ import annotations

from typing import Literal

import sympy as sp

from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True)
class Frame:
    """The directions in which the velocities of one impact are resolved.

    ``n`` is the unit vector along the line of centres, or perpendicular to a wall and away from
    it; ``t`` the one across, or along the wall. ``by_values`` tells that the line of centres is
    known only from the solution, not from the data. Where it has to be worked out, ``angle`` is the
    letter for the angle that it, or the wall, makes with **i**.
    """

    number: int
    wall: str | None
    n: Vector
    t: Vector
    axis: Literal["i", "j"] | None
    by_values: bool = False
    angle: sp.Symbol | None = None


def component(v: Vector, direction: Vector) -> sp.Expr:
    """The component of a vector in the direction of a unit vector, which mostly is i or j."""
    terms = [
        x if coefficient is sp.S.One else -x if coefficient is sp.S.NegativeOne else x * coefficient
        for x, coefficient in zip(v, direction, strict=True)
        if coefficient is not sp.S.Zero
    ]
    return sp.sympify(sum(terms[1:], terms[0]) if terms else sp.S.Zero, strict=True)


@dataclass(frozen=True)
class Component:
    """An unknown component of a velocity after an impact."""

    symbol: sp.Symbol
    body: str
    number: int
    value: sp.Expr


@dataclass(frozen=True)
class Law:
    """A principle as an equation: ``residual`` = 0. ``unknowns`` are found when it is used."""

    kind: Literal["momentum", "restitution"]
    number: int
    residual: sp.Expr
