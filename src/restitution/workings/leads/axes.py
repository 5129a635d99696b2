"""In which senses **i** and **j** are taken, where the question leaves that open."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Degrees, Expression, Negate, Polar, Unit, negated
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.wording.scene import scene_of, wall_before
from restitution.workings.rendering.steps import Step

AXES = (lay.Bold("i"), lay.Bold("j"))


def senses_of_axes(problem: Problem) -> Sentence | None:
    """How **i** and **j** lie to the first wall and to the way on which a sphere comes to it.

    None where the question says it: of a sphere that comes to a wall at an acute angle it says no
    more than that, unless a vector is asked for.
    """
    if len(problem.spheres) != 1 or not isinstance(problem.spheres[0].velocity, Polar):
        return None
    (sphere,) = problem.spheres
    velocity = problem.spheres[0].velocity
    name = wall_before(scene_of(problem), velocity)
    wall = next((wall for wall in problem.walls if wall.name == name), None)
    if wall is None or not isinstance(wall.along, Unit):
        return None
    along: Expression = wall.along
    if velocity.wall is None and isinstance(velocity.origin, Negate):
        along = Negate(along)
    across, towards = _left(along), velocity.wall is None
    if isinstance(velocity.angle, Degrees) and velocity.angle.value > _RIGHT:
        along = negated(along)
    if isinstance(across, Negate):
        across, towards = across.operand, not towards
    assert isinstance(across, Unit)
    return say(
        "axes.towards" if towards else "axes.away",
        along=lay.Bold(wall.along.axis),
        sense=say("axes.against" if isinstance(along, Negate) else "axes.with"),
        across=lay.Bold(across.axis),
        body=sphere.name,
        wall=wall.name,
    )


_RIGHT = 90


def _left(axis: Expression) -> Expression:
    """The direction to the left of **i**, **j** or one of their opposites."""
    match axis:
        case Unit("i"):
            return Unit("j")
        case Negate(Unit("i")):
            return Negate(Unit("j"))
        case Negate(_):
            return Unit("i")
    return Negate(Unit("i"))


def with_axes(steps: Sequence[Step], sentence: Sentence) -> Iterator[Step]:
    """Steps with a sentence above the first of them that has **i** or **j**."""
    waiting = True
    for step in steps:
        if waiting and has_axes(step):
            waiting = False
            if step.kind == "setting":
                yield replace(step, sentences=(sentence, *step.sentences))
                continue
            yield Step("setting", sentences=(sentence,))
        yield step


def has_axes(value: Any) -> bool:
    """Whether **i** or **j** stands in what is printed."""
    if isinstance(value, lay.Bold):
        return value in AXES
    if isinstance(value, tuple | list):
        return any(map(has_axes, value))
    if is_dataclass(value) and not isinstance(value, type):
        return any(has_axes(getattr(value, field.name)) for field in fields(value))
    return False


__all__ = ["has_axes", "senses_of_axes", "with_axes"]
