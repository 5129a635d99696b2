"""A given inequality of an angle: its tangent is more, or less, than that of the bound."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Fact, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Degrees,
    Letter,
    Quantity,
    is_function,
)
from restitution.planning.angles.turn_lines import meeting
from restitution.planning.angles.wall_turns import sum_at_a_wall
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.inequalities import without_signs
from restitution.planning.writing.polynomials import expanded

Bounded = tuple[int, Sign, sp.Expr]
"""A line that says an inequality of letters, its sign, and what is compared with 0 by it."""


def write_bounded(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """The tangent of an angle compared with that of an acute one, in letters.

    None where it is open whether the angle is acute, or nothing is left to be compared.
    """
    assert isinstance(link.right, Degrees)
    judge, mark = worths.judge, worths.mark()
    if (beside := _beside_a_known_angle(worths, fact, link, angle)) is not None:
        return beside
    worths.back(mark)
    try:
        line = worths.angle(angle)
        own = worths.scene.desk.last_link(line)
        if not is_function(own.left, "tan"):
            raise NotPlannedError("an angle without a tangent")
        line, letter, extent = worths.lettered(line, own.left.argument)
    except NotPlannedError:
        worths.back(mark)
        return None
    tangent, right = Apply("tan", letter), worths.scene.desk.last_link(line).right
    value, bound = worths.value(right), _tangent_of(link.right)
    known = worths.known_in(value)
    pool: list[Ref] = [fact.id, *extent]
    if not _is_at_most_a_right_angle(extent):
        met = meeting(worths.scene)
        acute = judge.write(
            (Move("sign"),), [line, *known, *met], _relation(Link(tangent, ">", ZERO))
        )
        pool += [] if acute is None else [acute]
    limit = tree_of(bound)
    stripped = without_signs(worths.scene, expanded(value - bound), link.sign)
    compared = judge.write((Move("compare"),), pool, _relation(Link(tangent, link.sign, limit)))
    if compared is None or stripped is None:
        worths.back(mark)
        return None
    put = judge.write((Move("put"),), [compared, line], _relation(Link(right, link.sign, limit)))
    if put is None:
        worths.back(mark)
        return None
    sign, x = stripped
    return put, sign, x


def _beside_a_known_angle(
    worths: Worths, fact: Fact, link: Link, angle: Quantity
) -> Bounded | None:
    """The tangent of the other angle of a deflection at a wall, where one is a number of degrees.

    That is taken from the bound first: 45° + β ≤ 60°, so β ≤ 15°. None of any other deflection.
    """
    scene, judge = worths.scene, worths.judge
    if angle.kind != "deflection" or angle.stage not in scene.model.frames:
        return None
    try:
        worths.determine_angle(angle)
        own = sum_at_a_wall(scene, angle, scene.frame(int(str(angle.stage))))
    except NotPlannedError:
        return None
    if own is None or not isinstance(own[1][0].angle, Degrees):
        return None
    number, (before, after) = own
    assert isinstance(link.right, Degrees)
    rest = Degrees(link.right.value - before.angle.value)  # type: ignore[union-attr]
    if not 0 < rest.value < RIGHT_ANGLE.value:
        return None
    names = {
        e.name for e in (after.angle, scene.desk.last_link(number).left) if isinstance(e, Letter)
    }
    lets = scene.desk.introducing(names)
    whole = scene.desk.last_link(number).right
    first = judge.write(
        (Move("put"), Move("compare")),
        [fact.id, number, *lets],
        _relation(Link(whole, link.sign, link.right)),
    )
    less = first and judge.write(
        (Move("rearrange"),), [first], _relation(Link(after.angle, link.sign, rest))
    )
    if not less:
        return None
    tangent, limit = Apply("tan", after.angle), tree_of(_tangent_of(rest))
    standing = next(ref for ref in after.refs if isinstance(ref, int))
    _, _, extent = worths.lettered(standing, after.angle)
    compared = judge.write(
        (Move("compare"),), [less, *extent], _relation(Link(tangent, link.sign, limit))
    )
    value = worths.value(after.tangent)
    stripped = without_signs(scene, expanded(value - _tangent_of(rest)), link.sign)
    put = compared and judge.write(
        (Move("put"),), [compared, *after.refs], _relation(Link(after.tangent, link.sign, limit))
    )
    return None if not put or stripped is None else (put, *stripped)


def _relation(link: Link) -> Relation:
    return Relation(((link,),))


def _tangent_of(angle: Degrees) -> Any:
    return tidy(sp.tan(sp.Rational(angle.value.numerator, angle.value.denominator) * sp.pi / 180))


def _is_at_most_a_right_angle(extent: tuple[Ref, ...]) -> bool:
    """Whether what is known of an angle says that it is no more than 90°."""
    return any(isinstance(ref, str) and ("90°" in ref or "acute" in ref) for ref in extent)
