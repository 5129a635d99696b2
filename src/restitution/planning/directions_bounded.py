"""Bounds of the direction of a velocity: by its tangent, or its cotangent where that has none."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import FLIPPED, Link, Move, Ref, Relation
from restitution.expression.tree import Apply, Binary, Letter, Quantity
from restitution.planning.comparing import Comparing
from restitution.planning.desk import Source, together
from restitution.planning.forms import tree_of
from restitution.planning.inequalities import turned
from restitution.planning.named_angles import letter_of, ratio_line
from restitution.planning.velocity_formulas import body_and_stage, in_the_plane


def write_of_direction(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """The bounds of a direction by those of a ratio of it; None of another angle.

    A component that keeps its sign tells on which side the velocity points.
    """
    match quantities:
        case [Quantity("direction", _, int()) as direction] if all(
            each.sign in FLIPPED for each in relation.only
        ):
            pass
        case _:
            return None
    mark = claims.worths.mark()
    velocity = Quantity("velocity", direction.arguments, direction.stage)
    claims.worths.determine(velocity)
    scene = claims.scene
    body, stage = body_and_stage(scene, direction)
    x, y = in_the_plane(scene, body, stage)
    for function, below in (("tan", x), ("cot", y)):
        if not _keeps_its_sign(claims, below):
            continue
        above = y if below is x else x
        letter, let = letter_of(scene, direction)
        value = tidy(above.value / below.value)
        quotient = Binary("/", tree_of(above.value), tree_of(below.value))
        ratio = Apply(function, Letter(letter))
        move = Move("define", "tan-direction", stage or None, (body,))
        refs = together(x.whole, y.whole, (let,))
        line = ratio_line(scene, move, refs, ratio, quotient, value)
        links = [each if each.left == direction else turned(each) for each in relation.only]
        ends = [own for each in links if (own := _bound(claims, ratio, each)) is not None]
        if len(ends) < len(links):
            continue
        if len(ends) == 2:
            ends = [turned(ends[0]), ends[1]] if function == "tan" else [turned(ends[1]), ends[0]]
        bounds = claims.monotone(line, Relation((tuple(ends),)))
        if bounds is not None:
            known = claims.worths.known_in(value)
            pool = [bounds, let, *y.whole, *x.whole, *known]
            last = claims.judge.write((Move("compare"),), pool, relation)
            if last is None:
                side = _side(claims, direction, [let, *y.whole, *known], scene.model.sign(y.value))
                pool = [bounds, let, *(() if side is None else (side,))]
                last = claims.judge.write((Move("compare"),), pool, relation)
            if last is not None:
                return last
        claims.worths.back(mark)
        claims.worths.determine(velocity)
    claims.worths.back(mark)
    return None


def _side(claims: Comparing, direction: Quantity, pool: Sequence[Ref], sign: int) -> int | None:
    """The line that says on which side of **i** a velocity points."""
    low, high = (0, 180) if sign > 0 else (-180, 0)
    ends = [tree_of(sp.Integer(each) * sp.pi / 180, angle=True) for each in (low, high)]
    links = (Link(ends[0], "<", direction), Link(direction, "<", ends[1]))
    return claims.judge.write((Move("sign"),), pool, Relation((links,)))


def _keeps_its_sign(claims: Comparing, component: Source) -> bool:
    """Whether a component is not zero, whatever the letters are."""
    model = claims.scene.model
    sign = model.sign(component.value)
    return bool(sign) and bool(model.decide(sign * model.in_data(component.value), ">", 0))


def _bound(claims: Comparing, ratio: Apply, link: Link) -> Link | None:
    """The bound of a ratio that belongs to one of its direction, with the ratio on the left.

    None where there is none: a right angle has no tangent.
    """
    angle = sp.sympify(claims.scene.scalar(link.right), strict=True)
    there = sp.tan(angle) if ratio.function == "tan" else sp.cot(angle)
    sign = link.sign if ratio.function == "tan" else FLIPPED[link.sign]
    return None if there.has(sp.zoo) else Link(ratio, sign, tree_of(tidy(there)))


__all__ = ["write_of_direction"]
