"""Where expressions vanish as letters vary: the ends at which something may change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache, partial
from itertools import pairwise

import sympy as sp
from mpmath.libmp import NoConvergence

from restitution import exact
from restitution.errors import UnsupportedError
from restitution.expression.enclosed import DIGITS, Enclosed
from restitution.oracle.roles import Role
from restitution.solving.algebra.numbers import at
from restitution.solving.algebra.systems import solve_system

NEAR = (1, 3, 7, 13)


def at_end(x: sp.Expr, symbol: sp.Symbol, end: sp.Expr) -> sp.Expr | None:
    """The numerator of an expression at an end of a letter; None where it has no value there."""
    value = sp.together(x.xreplace({symbol: end})).as_numer_denom()[0]
    return None if value.has(sp.nan, sp.zoo, sp.oo) else sp.expand(value)


def at_infinity(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """What decides the sign of a polynomial as a letter grows without end."""
    return sp.Poly(x, symbol).LC() if x.is_polynomial(symbol) else None


def zeros(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    roles: Mapping[str, Role],
    wanted: str,
) -> list[sp.Expr]:
    """The values of one letter at which expressions vanish together."""
    angles = frozenset(s for s in unknowns if s.name in roles and roles[s.name].kind == "angle")
    acute = frozenset(
        s
        for s in angles
        if roles[s.name].low == 0
        and roles[s.name].high is not None
        and bool(roles[s.name].high <= sp.pi / 2)
    )
    bare = any(
        equation.xreplace({f: sp.Integer(1) for f in equation.atoms(sp.Function)}).has(s)
        for s in angles
        for equation in equations
    )
    if bare:
        angles = acute = frozenset()
    values = []
    try:
        for solution in solve_system(list(equations), list(unknowns), angles, acute, roles):
            value = solution.values.get(wanted)
            if value is not None and value.has(sp.atan, sp.atan2):
                value = exact.tidy_angle(value).replace(sp.atan, partial(_of_its_tangent, roles))
            if value is not None and not _is_complex(value):
                values.append(value)
    except (UnsupportedError, sp.PolynomialError, NotImplementedError):
        return []
    return values


def _is_complex(x: sp.Expr) -> bool:
    """Whether an expression is seen to be no real number, as the arctangent of 2i."""
    return x.is_extended_real is False or x.has(sp.atanh, sp.acoth, sp.asinh, sp.acosh)


def _of_its_tangent(roles: Mapping[str, Role], x: sp.Expr) -> sp.Expr:
    """The arctangent of an expression: of the tangent of an angle up to 90°, that angle."""
    if isinstance(x, sp.tan) and x.args[0].is_Symbol:
        role = roles.get(x.args[0].name)
        if role is not None and role.kind == "angle" and role.low == 0 and role.high == sp.pi / 2:
            return x.args[0]
    return sp.atan(x)


@lru_cache(maxsize=1024)
def deciding(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """An expression's numerator and denominator, and what stands under its roots and bars."""
    top, bottom = sp.together(x).as_numer_denom()
    parts = [top, bottom]
    for node in sp.preorder_traversal(x):
        if node.is_Pow and node.exp.is_Rational and not node.exp.is_Integer:
            parts.append(sp.together(node.base).as_numer_denom()[0])
        elif isinstance(node, sp.Abs):
            parts.append(sp.together(node.args[0]).as_numer_denom()[0])
    return tuple(part for part in parts if part.free_symbols)


@lru_cache(maxsize=1024)
def told_apart(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """Expressions without arctan2 of which one vanishes where an angle comes to a plain number.

    The second one vanishes where a direction goes from 180° to -180°.
    """
    own = list(x.atoms(sp.atan2))
    if len(own) != 1:
        return ()
    angle = sp.Dummy("angle")
    linear = sp.expand(x.xreplace({own[0]: angle}))
    slope = linear.coeff(angle)
    rest = linear - slope * angle
    if not slope.is_number or not rest.is_number or slope.is_zero:
        return ()
    above, along = own[0].args
    across = above * sp.cos(rest / slope) + along * sp.sin(rest / slope)
    return tuple(part for value in (across, above) for part in deciding(value))


@lru_cache(maxsize=1024)
def essential_factors(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of an expression that can change sign."""
    try:
        factors = [f for f, _ in sp.factor_list(x)[1]] if sp.count_ops(x) < 400 else [x]
    except (sp.PolynomialError, NotImplementedError):
        factors = [x]
    return tuple(f for f in factors if f.free_symbols and not f.is_positive and not f.is_negative)


def numeric_zeros(
    atoms: Sequence[sp.Expr], x: sp.Symbol, values: Mapping[str, Enclosed]
) -> list[Enclosed]:
    """Where expressions vanish, in numbers, as one letter varies and the others are put in."""
    roots: list[Enclosed] = []
    for atom in atoms:
        if not atom.has(x):
            continue
        others = {
            s: sp.Float(str(values[s.name]), DIGITS)
            for s in atom.free_symbols
            if s != x and s.name in values
        }
        if len(others) != len(atom.free_symbols) - 1:
            continue
        roots += _numeric_zeros(atom.xreplace(others), x)
    return roots


@lru_cache(maxsize=1024)
def _numeric_zeros(expression: sp.Expr, x: sp.Symbol) -> tuple[Enclosed, ...]:
    """Where an expression of one letter vanishes: the same for all data that only set a scale."""
    angle = expression.has(sp.sin, sp.cos, sp.tan)
    if angle:
        t = sp.Dummy("t")
        expression = expression.xreplace(
            {
                sp.sin(x): 2 * t / (1 + t**2),
                sp.cos(x): (1 - t**2) / (1 + t**2),
                sp.tan(x): 2 * t / (1 - t**2),
            }
        )
        variable = t
    else:
        variable = x
    try:
        poly = sp.Poly(sp.together(expression).as_numer_denom()[0], variable)
        roots = poly.nroots(n=35, maxsteps=200)
    except (
        sp.PolynomialError,
        sp.GeneratorsNeeded,
        ValueError,
        NotImplementedError,
        NoConvergence,
    ):
        return ()
    real = [sp.re(root) for root in roots if abs(sp.im(root)) < 1e-18]
    return tuple(2 * at(sp.atan(root), {}) if angle else at(root, {}) for root in real)


def representatives(numbers: list[Enclosed], role: Role) -> list[Enclosed]:
    """Numbers, points between them, beyond them and close to them, in this order."""
    if not numbers:
        return [at(sp.Rational(1, 3), {})]
    pairs = list(pairwise(numbers))
    points = [*numbers, *((a + b) / 2 for a, b in pairs)]
    points += [numbers[0] - 1, numbers[-1] + 1, numbers[-1] * 2 + 3]
    for power in NEAR:
        # Where a root hides a border, it may lie as near to an end as one likes.
        for a, b in pairs:
            points += [a + (b - a) / 10**power, b - (b - a) / 10**power]
    low = None if role.low is None else at(role.low, {})
    high = None if role.high is None else at(role.high, {})
    return [x for x in points if (low is None or x >= low) and (high is None or x <= high)]
