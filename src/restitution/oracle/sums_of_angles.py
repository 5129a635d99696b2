"""Relations between sums of angles as relations between sines, for who knows polynomials alone."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

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
from restitution.oracle.polynomials import Polynomials, TooLargeError
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
    """A sum of angles as the sine of a share of it, which has the same sign.

    One with an inverse sine, cosine or tangent is compared by that, where the rest is between its
    ends.
    """
    if x.has(*_INVERSE) and x.has(sp.Abs):
        x = x.xreplace({bar: _without_bars(bar, roles) for bar in x.atoms(sp.Abs)})
    terms = _rational_combination(x)
    extent = _extent(terms, roles)
    if extent is None:
        return x
    try:
        by_ratio = _by_ratio(terms, roles)
        if by_ratio is not None:
            return by_ratio
        low, high, open_ = extent
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


def _extent(
    terms: Iterable[sp.Expr], roles: Mapping[str, Role]
) -> tuple[sp.Expr, sp.Expr, bool] | None:
    """Between which numbers a sum of angles lies, and whether it comes to neither of them.

    None of what is no sum of angles.
    """
    low = high = sp.Integer(0)
    angular = open_ = False
    for term in terms:
        coefficient, atom = term.as_coeff_Mul()
        if not coefficient.is_Rational:
            return None
        if atom.is_Symbol:
            role = roles.get(atom.name, REAL)
            if role.kind != "angle" or role.low is None or role.high is None:
                return None
            ends = role.low, role.high
            angular, open_ = True, open_ or not any(role.closed)
        elif isinstance(atom, _INVERSE):
            # Of a plain number its value is known.
            ends = _ends_of(atom, roles) if term.free_symbols else (atom, atom)
            angular = True
            open_ = open_ or (isinstance(atom, sp.atan) and ends == (-sp.pi / 2, sp.pi / 2))
        elif not term.free_symbols and (atom is sp.pi or coefficient is term or term.is_Rational):
            ends = atom, atom
        else:
            return None
        least, most = ends if coefficient > 0 else ends[::-1]
        low, high = low + coefficient * least, high + coefficient * most
    return (low, high, open_) if angular else None


def _by_ratio(terms: Sequence[sp.Expr], roles: Mapping[str, Role]) -> sp.Expr | None:
    """The sign of α − arcsin x as that of sin α − x; None where no such sum is seen.

    That of α − arctan x is as that of sin α − x cos α.
    """
    for term in terms:
        sense, atom = term.as_coeff_Mul()
        if abs(sense) != 1 or not isinstance(atom, sp.asin | sp.acos | sp.atan):
            continue
        others = [other for other in terms if other != term]
        rest = _extent(others, roles) if term.free_symbols else None
        (ratio,) = atom.args
        is_tangent = isinstance(atom, sp.atan)
        if rest is None or not (is_tangent or is_never_negative(1 - ratio**2, roles)):
            continue
        low, high, _ = rest
        own_low, own_high = (
            ((0, sp.pi) if sense == -1 else (-sp.pi, 0))
            if isinstance(atom, sp.acos)
            else (-sp.pi / 2, sp.pi / 2)
        )
        if _exceeds(own_low, low) or _exceeds(high, own_high):
            continue
        angle = sp.Add(*others)
        if is_tangent:
            return sp.sin(angle) + sense * ratio * sp.cos(angle)
        if isinstance(atom, sp.asin):
            return sp.sin(angle) + sense * ratio
        return sense * (sp.cos(angle) - ratio)
    return None


def _ends_of(atom: sp.Expr, roles: Mapping[str, Role]) -> tuple[sp.Expr, sp.Expr]:
    """Between which numbers an inverse function lies, by the signs of what stands in it."""
    right = sp.pi / 2
    upper = is_never_negative(atom.args[0], roles)
    if isinstance(atom, sp.acos):
        return sp.Integer(0), right if upper else sp.pi
    ahead = not isinstance(atom, sp.atan2) or is_never_negative(atom.args[1], roles)
    width = right if ahead else sp.pi
    return (sp.Integer(0) if upper else -width), width


def _without_bars(bar: sp.Expr, roles: Mapping[str, Role]) -> sp.Expr:
    """The size of an expression without bars, where its sign is plain."""
    (inside,) = bar.args
    if is_never_negative(inside, roles):
        return inside
    return -inside if is_never_negative(-inside, roles) else bar


def is_never_negative(x: sp.Expr, roles: Mapping[str, Role]) -> bool:
    """Whether coefficients show that an expression is nowhere negative."""
    try:
        world = Polynomials([x], roles)
        above, below = world.quotient(x)
        sense = world.sign(below)
        if sense is None:
            return False
        for factor, power in world.factors(above):
            if power % 2 == 0 or world.not_negative(factor):
                continue
            if not world.not_negative(-factor):
                return False
            sense = -sense
        return sense == 1
    except (TooLargeError, BeyondError):
        return False


def _rational_combination(x: sp.Expr) -> list[sp.Expr]:
    """The terms of a sum of which rational numbers multiply sums, with like terms together.

    Nothing else is multiplied out: that may take long, and is no sum of angles.
    """
    shares: dict[sp.Expr, sp.Expr] = {}
    pending = [(sp.Integer(1), x)]
    while pending:
        factor, addend = pending.pop()
        coefficient, rest = addend.as_coeff_Mul()
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
