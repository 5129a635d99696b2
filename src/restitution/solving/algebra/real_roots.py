"""The real roots of one polynomial, exact."""

from __future__ import annotations

import math
from collections.abc import Sequence

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.exact import denested, reduced_over_surds
from restitution.exact.degrees import tangent, with_ratio
from restitution.expression.enclosed import Enclosed
from restitution.solving.algebra.cosines import gathered, has_cosines, without_cosines
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.number_fields import isolating, norm, split_over_numbers
from restitution.solving.algebra.numbers import at
from restitution.solving.algebra.polynomials import (
    TooLargeError,
    afford,
    coefficients,
    degree,
    factors,
)
from restitution.solving.algebra.signs import (
    definite,
    plain_number,
    rational_below,
    sign,
    vanishing,
)


def square_roots(value: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The square roots of a value that x may have by its sign; none of a negative value."""
    if vanishing(value):
        return [] if x.is_positive else [sp.Integer(0)]
    if definite(value) < 0:
        return []
    size = _sqrt(value)
    if x.is_nonnegative:
        return [size]
    return [size, -size]


def _sqrt(value: sp.Expr) -> sp.Expr:
    if value.has(sp.CRootOf):
        return sp.sqrt(value)
    if not value.free_symbols:
        return denested(sp.sqrt(rational_below(value)))
    afford(sp.count_ops(value) ** 2)
    return sp.sqrt(sp.factor(value))


def roots(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The real roots of a polynomial in ``x``, exact; coefficients may hold letters and surds.

    Raises UnsupportedError where there is no formula for people (degree above 2 with letters).
    """
    parts = coefficients(equation, x)
    if len(parts) < 2:
        return []
    if len(parts) == 2:
        a, b = parts
        return _in_degrees(equation, x, [_tidy_root(-b / a)])
    equation = gathered(equation)
    values: list[sp.Expr] = []
    for factor in _factors_of(equation, x):
        values += [root for root in _roots_of(factor, x) if root not in values]
    return _in_degrees(equation, x, values)


def _in_degrees(equation: sp.Expr, x: sp.Symbol, values: list[sp.Expr]) -> list[sp.Expr]:
    """Roots that are tangents of whole degrees as such, where degrees stand in the equation."""
    if equation.free_symbols != {x} or not x.name.startswith("tan_") or not has_cosines(equation):
        return values
    parts = coefficients(equation, x)
    numbers = [float(at(value, {}).fraction) for value in values]
    in_degrees = list(values)
    for number in numbers:
        angle = sp.Rational(round(2 * math.degrees(math.atan(number))), 360) * sp.pi
        c, s = (with_ratio(function, angle) for function in (sp.cos, sp.sin))
        powers = [c**n * s ** (len(parts) - 1 - n) for n in range(len(parts))]
        total = sp.Add(*[part * power for part, power in zip(parts, powers, strict=True)])
        if gathered(sp.expand(total)) == 0:
            # It is a root: that which is nearest to it.
            gaps = [abs(other - math.tan(float(angle))) for other in numbers]
            in_degrees[gaps.index(min(gaps))] = tangent(angle)
    return in_degrees


def _factors_of(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    if degree(equation, x) > 2 and equation.free_symbols == {x}:
        return split_over_numbers(equation, x)
    try:
        parts = factors(equation)
    except (sp.PolynomialError, TooLargeError):
        return [equation]
    return [factor for factor in parts if factor.has(x)]


def _roots_of(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    parts = coefficients(equation, x)
    top = len(parts) - 1
    if top == 1:
        return [_tidy_root(-parts[1] / parts[0])]
    if top == 2:
        return _quadratic(*parts)
    if top == 4 and parts[1] == 0 and parts[3] == 0:
        squares = _quadratic(parts[0], parts[2], parts[4])
        values = []
        for square in squares:
            if definite(square) < 0:
                continue
            size = _sqrt(square)
            values += [size, -size] if size != 0 else [size]
        return values
    if equation.free_symbols != {x}:
        if any(part != 0 for part in parts[1:-1]):
            raise UnsupportedError(
                f"an equation of degree {top} with letters has no usable exact solution"
            )
        return _of_binomial(parts[0], parts[-1], top)
    lone = without_cosines(equation, x) if has_cosines(equation) else None
    rational = norm(equation if lone is None else lone, x)
    afford(isolating(rational, x))
    values = []
    for value, _ in sp.Poly(rational, x, domain="QQ").real_roots(multiple=False):
        if degree(rational, x) == top or (_may_be_root(parts, value) and _is_root(parts, value)):
            values.append(value)
    return values


def _of_binomial(a: sp.Expr, b: sp.Expr, power: int) -> list[sp.Expr]:
    """The real roots of a xⁿ + b: one if n is odd and the sign is known, else two or none."""
    value = neat(-b / a)
    known = definite(value)
    if known == 0 or (known < 0 and power % 2 == 0):
        if known < 0:
            return []
        raise UnsupportedError(
            f"an equation of degree {power} with letters has no usable exact solution"
        )
    size = sp.Pow(value if known > 0 else neat(-value), sp.Rational(1, power))
    if power % 2:
        return [size if known > 0 else -size]
    return [size, -size]


def _may_be_root(parts: Sequence[sp.Expr], value: sp.Expr) -> bool:
    """Whether 20 digits cannot distinguish a polynomial from zero at a number."""
    x, total, size = value.evalf(20), sp.Float(0, 20), sp.Float(0, 20)
    for part in parts:
        c = part.evalf(20)
        total, size = total * x + c, size * abs(x) + abs(c)
    return bool(abs(total) <= size * sp.Float("1e-12"))


def _is_root(parts: Sequence[sp.Expr], value: sp.Expr) -> bool:
    """Whether a root of the norm is a root of the polynomial and not of a conjugate."""
    x, total = at(value, {}), Enclosed.of(0)
    for part in parts:
        total = total * x + at(part, {})
    return not total.sign


def _quadratic(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> list[sp.Expr]:
    if a.has(sp.CRootOf):
        b, c = (rational_below(value / a) if value.is_number else value / a for value in (b, c))
        a = sp.Integer(1)
    elif a.is_number and not a.is_Rational and not has_cosines(a):
        # Dividing first keeps surds out of the denominator under the root.
        over = plain_number(1 / a)
        b, c = (
            sp.radsimp(sp.expand(value / a if over is None else value * over), max_terms=4)
            for value in (b, c)
        )
        a = sp.Integer(1)
    if b == 0 and has_cosines(a) and not (a.free_symbols | c.free_symbols):
        size = _by_half_an_angle(a, c) or sp.sqrt(-c / a)
        return [size, -size] if size.is_real else []
    discriminant = gathered(sp.expand(b * b - 4 * a * c))
    if discriminant.is_number:
        discriminant = rational_below(discriminant)
        if sign(discriminant) in (-1, None):
            return []
    elif definite(discriminant) < 0:
        return []
    if vanishing(discriminant):
        return [_tidy_root(-b / (2 * a))]
    d = _sqrt(discriminant)
    turn = definite(b, frozenset(), True)
    if a.free_symbols and definite(a) == 0 and turn != 0:
        # The leading coefficient may vanish, and one root is then that of b x + c.
        finite, other = -2 * c / (b + turn * d), (-b - turn * d) / (2 * a)
        return [_tidy_root(value) for value in ((finite, other) if turn > 0 else (other, finite))]
    return [_tidy_root((-b + d) / (2 * a)), _tidy_root((-b - d) / (2 * a))]


def _by_half_an_angle(a: sp.Expr, c: sp.Expr) -> sp.Expr | None:
    """The positive root of a x² + c with a = p(1 − cos φ): in sin ½φ, in which the data were.

    The same of p(1 + cos φ) in cos ½φ. None of other coefficients.
    """
    ratios = a.atoms(sp.sin, sp.cos)
    if len(ratios) != 1 or (a.free_symbols | c.free_symbols):
        return None
    (ratio,) = ratios
    if not isinstance(ratio, sp.cos) or not c.is_polynomial(ratio) or sp.degree(a, ratio) != 1:
        return None
    half = ratio.args[0] / 2
    for sign_, root in ((-1, with_ratio(sp.sin, half)), (1, with_ratio(sp.cos, half))):
        whole = sp.expand(a.subs(ratio, sign_ * (2 * root**2 - 1)))
        if whole.coeff(root, 0) == 0:
            rest = sp.expand(-c.subs(ratio, sign_ * (2 * root**2 - 1)))
            turn = -1 if sign(whole.coeff(root, 2)) == -1 else 1
            return sp.sqrt(turn * rest) / (sp.sqrt(turn * whole.coeff(root, 2)) * root)
    return None


def _tidy_root(value: sp.Expr) -> sp.Expr:
    if value.is_number:
        value = rational_below(value)
        return value if value.has(sp.CRootOf) else denested(value)
    return reduced_over_surds(neat(value))
