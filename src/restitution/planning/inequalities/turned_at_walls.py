"""Bounds of a deflection at a wall: by the angle to the wall afterwards, which is added to it."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Apply, Binary, Expression, Letter, Name, Quantity
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.named_angles import letter_of, tangent_line
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.angles import angle_of_approach, data_of_approach
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, expanded, one_fraction


def write_turn(claims: Comparing, quantities: Sequence[Quantity], relation: Relation) -> int | None:
    """A deflection at a wall compared; None where it is not that, or leads nowhere."""
    mark = claims.worths.mark()
    try:
        line = _turn(claims, quantities, relation)
    except NotPlannedError:
        line = None
    if line is None:
        claims.worths.back(mark)
    return line


def _turn(claims: Comparing, quantities: Sequence[Quantity], relation: Relation) -> int | None:
    scene = claims.scene
    match quantities:
        case [Quantity("deflection", (Name(body),), int(event)) as turned]:
            pass
        case _:
            return None
    if event not in scene.model.frames:
        return None
    frame = scene.frame(event)
    angle = angle_of_approach(scene, body, frame)
    if frame.wall is None or angle is None:
        return None
    velocity = Quantity("velocity", (Name(body),), event)
    claims.worths.determine(velocity)
    after = Quantity("angle", (velocity, Name(frame.wall)))
    own = formula(scene, after)
    line, letter = tangent_line(scene, after, own, own.move)
    line = claims.worths.tangent_closed(line)
    before, known = scene.put(sp.sympify(scene.scalar(angle), strict=True))
    ends: list[Link] = []
    tangents: list[Link] = []
    for link in relation.only:
        sides = [_less(claims, side, turned, before, letter) for side in (link.left, link.right)]
        ends.append(Link(sides[0], link.sign, sides[1]))
        ratios = [_ratio(claims, side) for side in sides]
        if None in ratios:
            return None
        tangents.append(Link(ratios[0], link.sign, ratios[1]))  # type: ignore[arg-type]
    bound = claims.monotone(line, Relation((tuple(tangents),)))
    if bound is None:
        return None
    extent = f"0° <= {letter} <= 90°"
    _, let = letter_of(scene, after)
    inside = claims.compared([bound, extent, let], Relation((tuple(ends),)))
    if inside is None:
        return None
    move = Move("define", "sum", event, (body,))
    sum_ = chain(turned, (Binary("+", angle, Letter(letter)), None))
    added = claims.judge.write(
        (move,), together(data_of_approach(scene, body, frame), (let,)), sum_
    )
    if added is not None and known:
        worth = Binary("+", tree_of(before, angle=True), Letter(letter))
        put = chain(turned, (worth, None))
        added = claims.judge.write((Move("put"),), together((added,), known), put)
    return None if added is None else claims.compared([inside, added], relation)


def _less(
    claims: Comparing, side: Expression, turned: Quantity, before: sp.Expr, letter: str
) -> Expression:
    """A side of an inequality of the deflection without the angle before."""
    if side == turned:
        return Letter(letter)
    value = sp.sympify(claims.scene.scalar(side), strict=True)
    return tree_of(tidy(value - before), angle=True)


def _ratio(claims: Comparing, side: Expression) -> Expression | None:
    if isinstance(side, Letter):
        return Apply("tan", side)
    value = tangent_of(sp.sympify(claims.scene.scalar(side), strict=True))
    return None if value is None else tree_of(value)


def tangent_of(angle: sp.Expr) -> sp.Expr | None:
    """The tangent of an expression of angles, by tangents; None where it has none."""
    own = sp.expand_trig(sp.tan(expanded(angle))).replace(sp.cot, lambda x: 1 / sp.tan(x))
    own = own.replace(sp.sin, lambda x: sp.tan(x) * sp.cos(x))
    own = cancelled(one_fraction(own))
    if own.has(sp.zoo, sp.oo, sp.nan, sp.atan, sp.asin, sp.acos, sp.sin, sp.cos):
        return None
    return tidy(own)
