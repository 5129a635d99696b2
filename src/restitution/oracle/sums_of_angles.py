"""Relations between sums of angles as relations between sines, for who knows polynomials alone."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.oracle.formula import (
    FALSE,
    TRUE,
    All,
    Formula,
    Relation,
    Some,
)
from restitution.oracle.points import (
    BeyondError,
    Program,
    constant_interval,
    ends_of,
)
from restitution.oracle.roles import REAL, Role
from restitution.oracle.testers import (
    holds_with,
)


def without_numbers(formula: Formula) -> Formula:
    """The formula without relations between plain numbers whose truth is certain."""
    match formula:
        case Relation(value, operator):
            sign = None if value.free_symbols else Program.of([value]).signs({})[0]
            if sign is None:
                return formula
            return TRUE if holds_with(Relation(value, operator), {value: sign}) else FALSE
        case All(parts):
            return All(tuple(without_numbers(part) for part in parts))
        case Some(parts):
            return Some(tuple(without_numbers(part) for part in parts))


def with_sines(formula: Formula, roles: Mapping[str, Role]) -> Formula:
    """The formula with sums of angles as sines, each with the same sign."""
    match formula:
        case Relation(value, operator):
            return Relation(sine_of_share(value, roles), operator)
        case All(parts):
            return All(tuple(with_sines(part, roles) for part in parts))
        case Some(parts):
            return Some(tuple(with_sines(part, roles) for part in parts))


def sine_of_share(x: sp.Expr, roles: Mapping[str, Role]) -> sp.Expr:
    """A sum of angles as the sine of a share of it, which has the same sign."""
    low = high = sp.Integer(0)
    angular = open_ = False
    for term in _rational_combination(x):
        coefficient, atom = term.as_coeff_Mul()
        if not coefficient.is_Rational:
            return x
        if atom.is_Symbol:
            role = roles.get(atom.name, REAL)
            if role.kind != "angle" or role.low is None or role.high is None:
                return x
            ends = role.low, role.high
            angular, open_ = True, open_ or not any(role.closed)
        elif isinstance(atom, _INVERSE):
            width = sp.pi if isinstance(atom, sp.acos | sp.atan2) else sp.pi / 2
            ends = (sp.Integer(0) if isinstance(atom, sp.acos) else -width), width
            if not term.free_symbols:
                ends = atom, atom  # its value is known
            angular = True
            open_ = open_ or (isinstance(atom, sp.atan) and bool(term.free_symbols))
        elif not term.free_symbols and (atom is sp.pi or coefficient is term or term.is_Rational):
            ends = atom, atom
        else:
            return x
        least, most = ends if coefficient > 0 else ends[::-1]
        low, high = low + coefficient * least, high + coefficient * most
    if not angular:
        return x
    try:
        for end, sign in ((low, 1), (high, -1)):
            if _exceeds(sign * end, 0):
                return end  # so far from 0 that the angles do not matter
        share = 1
        while any(
            not _exceeds(share * sp.pi, end) and not (open_ and end == share * sp.pi)
            for end in (-low, high)
        ):
            share += 1
    except BeyondError:
        return x
    return sp.sin(x / share)


def _rational_combination(x: sp.Expr) -> list[sp.Expr]:
    """The terms of a sum of which rational numbers multiply sums, with like terms together.

    Nothing else is multiplied out: that may take long, and is no sum of angles.
    """
    shares: dict[sp.Expr, sp.Expr] = {}
    pending = [(sp.Integer(1), x)]
    while pending:
        factor, each = pending.pop()
        coefficient, rest = each.as_coeff_Mul()
        if rest.is_Add:
            pending.extend((factor * coefficient, term) for term in reversed(rest.args))
        else:
            shares[rest] = shares.get(rest, sp.Integer(0)) + factor * coefficient
    return [share * atom for atom, share in shares.items() if share != 0] or [sp.Integer(0)]


def _exceeds(x: sp.Expr, bound: sp.Expr | int) -> bool:
    """Whether a number is certain to be more than another one."""
    least, _ = ends_of(constant_interval(sp.sympify(x - bound, strict=True), 30))
    return bool(least > 0)


_INVERSE = (sp.atan, sp.asin, sp.acos, sp.atan2)


def angle_within(angle: sp.Expr, role: Role) -> sp.Expr | float:
    """An angle turned into the range of its letter."""
    low, high = ends_of(constant_interval(angle, 30))
    middle = (low + high) / 2
    for turns in (0, 1, -1, 2, -2):
        number = float(middle) + turns * 6.283185307179586
        inside = (role.low is None or number >= float(role.low) - 1e-12) and (
            role.high is None or number <= float(role.high) + 1e-12
        )
        if inside:
            return angle + 2 * turns * sp.pi if turns else angle
    return angle
