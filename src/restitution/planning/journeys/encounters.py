"""Two spheres that both move and meet: one direction tells the time, the other an equation."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import Expression, has_quantity
from restitution.planning.formulas.whereabouts import (
    axis_of_approach,
    contact_of,
    last_move,
    offset_at,
    rests,
)
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ZERO, difference, swept, total, tree_of
from restitution.planning.writing.place_trees import AXES, Axis
from restitution.planning.writing.scene import Scene
from restitution.problem import Impact
from restitution.vector import Vector


def both_moving(scene: Scene, number: int) -> tuple[str, str] | None:
    """The spheres of an impact to which both move, from places that are known; None of others."""
    step = scene.model.happening(number).step
    story = scene.model.story
    if not isinstance(step, Impact) or step.second not in story.spheres:
        return None
    pair = (step.first, step.second)
    if circle_of(scene, number) is not None or not any(True for _ in contact_of(scene, number)):
        return None
    if any(rests(scene, sphere, number) for sphere in pair):
        return None
    placed = [story.place(sphere, last_move(scene, sphere, number)) for sphere in pair]
    return None if None in placed else pair


def aside(scene: Scene, number: int, pair: tuple[str, str]) -> sp.Expr:
    """How far one passes the other, times their relative speed: zero where they meet."""
    gaps, paces = [], []
    for body in pair:
        since = last_move(scene, body, number)
        known = scene.model.story.place(body, since)
        if known is None:
            raise NotPlannedError(f"the place of {body} is open")
        (place, time), pace = known, scene.velocity(body, since)
        paces.append(pace)
        gaps.append(place - pace * time)
    apart = Vector(*(offset_at(scene, pair[0], number, axis) for axis in AXES))
    gap = gaps[0] - gaps[1] - apart
    return tidy(gap.cross(paces[0] - paces[1]))


def in_the_other(scene: Scene, number: int, pair: tuple[str, str]) -> Axis:
    """The direction that does not tell the time of a meeting."""
    timed = axis_of_approach(scene, number, *pair)
    return "j" if timed == "i" else "i"


def with_the_gap(scene: Scene, body: str, number: int, axis: Axis, there: Expression) -> Expression:
    """The coordinate of a sphere by that of the one that it touches."""
    gap = tidy(offset_at(scene, body, number, axis))
    if gap == 0:
        return there
    if not has_quantity(there) and tidy(scene.scalar(there) + gap) == 0:
        return ZERO
    if scene.model.sign(gap) < 0:
        return swept(difference(there, tree_of(-gap)))
    return swept(total((there, tree_of(gap))))


__all__ = ["aside", "both_moving", "in_the_other", "with_the_gap"]
