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
    return tidy(signed(sp.sympify(value, strict=True), samples))


def tidy(x: sp.Expr) -> sp.Expr:
    """Textbook form; sines of angles such as 37° are treated as those of a letter."""
    if x.has(sp.atan):
        x = x.replace(sp.atan, lambda a: sp.atan(tidy(a)))
    if not x.has(sp.sin, sp.cos, sp.tan):
        return unnested(exact.tidy(x))
    masked, angles = _angles_as_letters(x)
    return exact.tidy(neat(masked)).xreplace(angles) if angles else exact.tidy(x)


def _angles_as_letters(x: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Sines, cosines and tangents of plain numbers as those of an acute letter."""
    letters: dict[sp.Expr, sp.Symbol] = {}
    put: dict[sp.Expr, sp.Expr] = {}
    for node in sorted(x.atoms(sp.sin, sp.cos, sp.tan), key=sp.default_sort_key):
        argument = node.args[0]
        if argument.free_symbols:
            continue
        # SymPy turns the sine of 50° into the cosine of 40°: one letter for both.
        other = sp.pi / 2 - argument
        if other in letters:
            complement = {sp.sin: sp.cos, sp.cos: sp.sin}.get(node.func)
            if complement is None:
                put[node] = 1 / sp.tan(letters[other])
            else:
                put[node] = complement(letters[other])
            continue
        if argument not in letters:
            letters[argument] = sp.Dummy(f"alpha_{len(letters)}", positive=True)
        put[node] = node.func(letters[argument])
    return x.xreplace(put), {letter: argument for argument, letter in letters.items()}


def unnested(x: sp.Expr) -> sp.Expr:
    """A numerical factor with roots inside roots, as a sum of plain roots where possible."""
    number, rest = x.as_independent(*x.free_symbols) if x.free_symbols else (x, sp.Integer(1))
    if x.free_symbols and not x.is_Mul:
        return x
    if not exact.is_nested(number) or not number.is_real:
        return x
    plainer = exact.denested(sp.sqrt(sp.radsimp(sp.expand(number**2))))
    if number.is_negative:
        plainer = -plainer
    if exact.cost(plainer) < exact.cost(number):
        return exact.tidy(plainer * rest)
    return x


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
    if not x.free_symbols and not y.free_symbols and not (x + y).has(sp.sin, sp.cos, sp.tan):
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
        ratio = tidy(neat(y / x))
        for letter in sorted(ratio.free_symbols, key=lambda s: s.name):
            # arctan(cos α / sin α) is the complement of α.
            if sx > 0 and letter.is_positive and ratio.has(sp.sin(letter), sp.tan(letter)):
                turned = neat(ratio.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a)))
                if neat(turned * sp.sin(letter) / sp.cos(letter)) == 1:
                    return sp.pi / 2 - letter
        turned = sp.atan(ratio)
        if sx > 0:
            return exact.tidy_angle(turned)
        if sy is None:
            return sp.atan2(tidy(y), tidy(x))
        flat = sp.pi if sy > 0 else -sp.pi
        return exact.tidy_angle(
            flat - sp.atan(tidy(neat(-y / x))) if sy > 0 else flat + sp.atan(ratio)
        )
    if sy is not None and sy > 0:
        return exact.tidy_angle(sp.pi / 2 - sp.atan(tidy(neat(x / y))))
    return sp.atan2(tidy(y), tidy(x))


def _number(x: sp.Expr) -> sp.Expr:
    return sp.sqrtdenest(sp.radsimp(sp.expand(x), max_terms=4)) if not x.is_Rational else x


def direction(value: Vector, samples: Samples) -> Vector:
    """A direction vector, up to scale, without fractions or common factors."""
    x, y = (signed(sp.sympify(part, strict=True), samples) for part in value)
    if x == 0:
        return Vector(sp.Integer(0), sp.Integer(sign_at(y, samples) or 1))
    if y == 0:
        return Vector(sp.Integer(sign_at(x, samples) or 1), sp.Integer(0))
    return Vector(tidy(x), tidy(y))
