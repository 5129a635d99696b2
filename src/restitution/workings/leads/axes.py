"""In which senses **i** and **j** run beside a wall to which an angle is told."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from restitution.explaining.data.arrangement import Arrangement
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.tree import Apply, Expression, Name, Negate, Polar, Unit, negated
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.wording.scene import Scene, scene_of, wall_before
from restitution.workings.rendering.steps import Step

AXES = (lay.Bold("i"), lay.Bold("j"))


def senses_of_axes(problem: Problem) -> tuple[Sentence, ...]:
    """How **i** and **j** lie to walls, and to the ways on which spheres first come to them.

    Where the question leaves that open, they are taken so; where it is told of an angle to a wall,
    which has two sides, it is said. None where angles are told from **i** or **j**.
    """
    scene = scene_of(problem)
    return tuple(
        sentence
        for sphere in problem.spheres
        if isinstance(sphere.velocity, Polar)
        for sentence in (_sense_at_a_wall(scene, sphere.name, sphere.velocity),)
        if sentence is not None
    )


def _sense_at_a_wall(scene: Scene, body: str, velocity: Polar) -> Sentence | None:
    """How a sphere with such a velocity first moves along a wall, and on which side of it."""
    taken = wall_before(scene, velocity) if len(scene.problem.spheres) == 1 else None
    name = taken or (velocity.wall.name if isinstance(velocity.wall, Name) else None)
    wall = None if name is None else scene.wall(name)
    if wall is None or not isinstance(wall.along, Unit):
        return None
    along: Expression = wall.along
    if velocity.wall is None and isinstance(velocity.origin, Negate):
        along = Negate(along)
    across, towards = _left(along), velocity.wall is None
    signs = Arrangement(scene.problem)
    side, turn = (signs.sign(Apply(ratio, velocity.angle)) for ratio in ("cos", "sin"))
    if side is None or not turn:
        return None
    if side < 0:
        along = negated(along)
    towards ^= turn < 0
    if isinstance(across, Negate):
        across, towards = across.operand, not towards
    assert isinstance(across, Unit)
    ways, sides = _TAKEN if taken else _TOLD
    return say(
        sides[towards],
        along=lay.Bold(wall.along.axis),
        sense=say(ways[isinstance(along, Negate)]),
        across=lay.Bold(across.axis),
        body=body,
        wall=wall.name,
    )


# In which of two senses a sphere moves, and on which side an axis is, as taken and as told.
_Words = tuple[tuple[SentenceId, SentenceId], tuple[SentenceId, SentenceId]]
_TAKEN: _Words = ("axes.with", "axes.against"), ("axes.away", "axes.towards")
_TOLD: _Words = ("axes.told.with", "axes.told.against"), ("axes.told.away", "axes.told.towards")


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


def with_axes(steps: Sequence[Step], sentences: tuple[Sentence, ...]) -> Iterator[Step]:
    """Steps with sentences above the first of them that has **i** or **j**."""
    waiting = True
    for step in steps:
        if waiting and has_axes(step):
            waiting = False
            if step.kind == "setting":
                yield replace(step, sentences=(*sentences, *step.sentences))
                continue
            yield Step("setting", sentences=sentences)
        yield step


def has_axes(value: Any) -> bool:
    """Whether **i** or **j** stands in what is printed, or a coordinate."""
    if isinstance(value, lay.Bold):
        return value in AXES
    if isinstance(value, str):
        return "-coordinate" in value
    if isinstance(value, tuple | list):
        return any(map(has_axes, value))
    fields_ = getattr(type(value), "__dataclass_fields__", ())  # those of any other class: none
    return any(has_axes(getattr(value, name)) for name in fields_)


__all__ = ["has_axes", "senses_of_axes", "with_axes"]
