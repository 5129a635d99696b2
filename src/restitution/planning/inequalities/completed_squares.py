"""Between what a speed is, over a coefficient: its square is completed, which has both ends."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Binary, Quantity
from restitution.oracle.roles import Role
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.forms import ZERO, product, square, tree_of
from restitution.planning.writing.polynomials import factored
from restitution.solving.story.letters import roles


def write_completed(claims: Comparing, line: int, relation: Relation) -> int | None:
    """Both ends of a speed, of which the square is of the second degree in a coefficient.

    None where the coefficient is at neither end least, or letters stand beside it in the sum.
    """
    speed = claims.scene.desk.last_link(line).left
    if len(relation.only) != 2 or not isinstance(speed, Quantity) or speed.kind != "speed":
        return None
    mark = claims.worths.mark()
    written = _written(claims, speed, relation)
    if written is None:
        claims.worths.back(mark)
    return written


def _written(claims: Comparing, speed: Quantity, relation: Relation) -> int | None:
    squared = claims.worths.squared(speed)
    own = None if squared is None else _completed(claims, squared)
    if squared is None or own is None:
        return None
    symbol, lead, least, more = own
    base = square(Binary("-", tree_of(symbol), tree_of(least)))
    whole = product(tree_of(lead), Binary("+", base, tree_of(more)))
    completed = claims.judge.write(
        (Move("rearrange"),), [squared], Relation(((Link(square(speed), "=", whole),),))
    )
    most = max(least**2, (1 - least) ** 2)
    extent = Relation(((Link(ZERO, "<=", base), Link(base, "<=", tree_of(most))),))
    known = claims.judge.known([symbol.name])
    between = claims.judge.write((Move("sign"),), known, extent)
    if completed is None or between is None:
        return None
    low, high = (tree_of(factored(lead * (each + more))) for each in (0, most))
    ends = Relation(((Link(low, "<=", square(speed)), Link(square(speed), "<=", high)),))
    last = claims.compared([completed, between], ends)
    return None if last is None else claims.compared([last], relation)


def _completed(claims: Comparing, line: int) -> tuple[sp.Symbol, sp.Expr, sp.Expr, sp.Expr] | None:
    """A coefficient, and a, p and r of the a((e − p)² + r) that a line has, with p inside."""
    value = claims.worths.value(claims.scene.desk.last_link(line).right)
    known = {name for name, role in roles(claims.scene.problem).items() if _is_coefficient(role)}
    symbols = [each for each in value.free_symbols if each.name in known]
    if len(symbols) != 1 or not value.is_polynomial(*symbols):
        return None
    poly = sp.Poly(sp.expand(value), *symbols)
    if poly.degree() != 2:
        return None
    lead, middle, rest = (factored(poly.nth(n)) for n in (2, 1, 0))
    least = sp.cancel(-middle / (2 * lead))
    more = sp.cancel(rest / lead - least**2)
    if not (least.is_Rational and more.is_Rational and 0 < least < 1 and more > 0):
        return None
    return symbols[0], lead, least, more


def _is_coefficient(role: Role) -> bool:
    return role.kind == "restitution" and (role.low, role.high) == (0, 1)
