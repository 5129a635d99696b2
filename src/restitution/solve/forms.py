"""Values as answers: signs resolved, angles as inverse tangents, everything in textbook form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from restitution import exact
from restitution.expression.evaluate import Angle
from restitution.solve.neat import neat
from restitution.solve.numbers import sign_at
from restitution.vector import Vector

Samples = Sequence[Mapping[str, Any]]


def plain(value: Any, samples: Samples) -> Any:
    """A value of any kind in textbook form: a SymPy expression, or a Vector of two."""
    if isinstance(value, Vector):
        return Vector(plain(value.x, samples), plain(value.y, samples))
    if isinstance(value, Angle):
        return angle(value, samples)
    return exact.tidy(signed(sp.sympify(value, strict=True), samples))


def signed(x: sp.Expr, samples: Samples) -> sp.Expr:
    """Sizes |x| and roots of squares without bars where the sign of x is known."""
    for _ in range(4):
        bars = list(x.atoms(sp.Abs))
        if not bars:
            break
        put = {}
        for node in bars:
            sign = sign_at(node.args[0], samples)
            if sign is not None:
                put[node] = sign * node.args[0]
        if not put:
            break
        x = x.xreplace(put)
    return x


def angle(value: Angle, samples: Samples) -> sp.Expr:
    """An angle in radians, by an inverse tangent where that is possible."""
    x, y = (signed(sp.sympify(part, strict=True), samples) for part in (value.x, value.y))
    if not x.free_symbols and not y.free_symbols:
        return exact.tidy_angle(sp.atan2(_number(y), _number(x)))
    sx, sy = sign_at(x, samples), sign_at(y, samples)
    if sy == 0 and sx is not None:
        return sp.Integer(0) if sx > 0 else sp.pi
    if sx == 0 and sy is not None:
        return sy * sp.pi / 2
    measured = value.measure()
    if isinstance(measured, sp.Symbol) or (
        measured.is_Add and not measured.has(sp.atan2) and not measured.has(sp.Abs)
    ):
        return exact.tidy_angle(measured)
    if sx is not None:
        ratio = exact.tidy(neat(y / x))
        turned = sp.atan(ratio)
        if sx > 0:
            return exact.tidy_angle(turned)
        if sy is None:
            return sp.atan2(exact.tidy(y), exact.tidy(x))
        flat = sp.pi if sy > 0 else -sp.pi
        return exact.tidy_angle(
            flat - sp.atan(exact.tidy(neat(-y / x))) if sy > 0 else flat + sp.atan(ratio)
        )
    if sy is not None and sy > 0:
        return exact.tidy_angle(sp.pi / 2 - sp.atan(exact.tidy(neat(x / y))))
    return sp.atan2(exact.tidy(y), exact.tidy(x))


def _number(x: sp.Expr) -> sp.Expr:
    return sp.sqrtdenest(sp.radsimp(sp.expand(x), max_terms=4)) if not x.is_Rational else x


def direction(value: Vector, samples: Samples) -> Vector:
    """A direction vector, up to scale, without fractions or common factors."""
    x, y = (signed(sp.sympify(part, strict=True), samples) for part in value)
    if x == 0:
        return Vector(sp.Integer(0), sp.Integer(sign_at(y, samples) or 1))
    if y == 0:
        return Vector(sp.Integer(sign_at(x, samples) or 1), sp.Integer(0))
    return Vector(exact.tidy(x), exact.tidy(y))
