"""A bound of a coefficient by another letter, with the end of the coefficient beyond it.

``e > (2 − cos α)/(1 + cos α)`` and ``e ≤ 1`` leave ``(2 − cos α)/(1 + cos α) < 1``, which is
solved for the angle.
"""

from __future__ import annotations

from collections.abc import Iterable

from restitution.explaining.lines.derivation import (
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    numbers_in,
    turned,
)
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.inequalities import solve_linear, subject_of, without_signs
from restitution.planning.writing.polynomials import one_fraction
from restitution.solving.story.letters import roles

_SOLVING = (Move("rearrange"), Move("cancel"), Move("compare"))
_ORDERS: dict[str, tuple[Sign, Sign]] = {">": ("<", "<="), "<": (">", ">=")}


def write_beyond_a_coefficient(
    claims: Comparing, lines: Iterable[Ref], relation: Relation
) -> int | None:
    """A range of a letter by lines that bound a coefficient by it; None without such a line."""
    wanted = subject_of(relation)
    if len(relation.options) > 1 or not isinstance(wanted, Letter):
        return None
    mark = claims.worths.mark()
    for line in numbers_in(lines):
        own = claims.scene.desk.line(line).relation
        if not isinstance(own, Relation) or len(own.options) > 1 or len(own.only) > 1:
            continue
        link = own.only[0] if isinstance(own.only[0].left, Letter) else turned(own.only[0])
        solved = _solved(claims, line, link, wanted)
        last = None if solved is None else claims.compared([solved], relation)
        if last is not None:
            return last
        claims.worths.back(mark)
    return None


def _solved(claims: Comparing, line: int, link: Link, wanted: Letter) -> int | None:
    """What the end of a coefficient says of a letter by which it is bounded, solved for that."""
    scene = claims.scene
    known = roles(scene.problem)
    match link:
        case Link(Letter(name), "<" | "<=" | ">" | ">=" as sign, right):
            role = known.get(name)
        case _:
            return None
    if role is None or role.kind != "restitution" or letters(right) != {wanted.name}:
        return None
    end = role.high if sign[0] == ">" else role.low
    if end is None or has_quantity(right):
        return None
    value = claims.worths.value(right)
    for order in _ORDERS[sign[0]]:
        open_ = without_signs(scene, one_fraction(value - end), order)
        solved = None if open_ is None else solve_linear(scene, *open_, wanted)
        if open_ is None or solved is None:
            continue
        between = Relation(((Link(right, order, tree_of(end)),),))
        pool = [line, *claims.judge.known([name])]
        first = claims.judge.write((Move("compare"),), pool, between)
        if first is None:
            continue
        ranges = claims.judge.known([wanted.name])
        return claims.judge.write(_SOLVING, [first, *ranges], Relation(((solved,),)))
    return None


__all__ = ["write_beyond_a_coefficient"]
