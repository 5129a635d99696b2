"""From which side a sphere comes at a wall: ``u at alpha to W`` is from the left of W, unless the
places say that the sphere is on its right.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Evaluator, Symbolic
from restitution.expression.tree import Binary, Expression, Name, Number, Polar
from restitution.oracle import REAL, Oracle, compared
from restitution.problem import Problem, Sphere
from restitution.shapes import Line, Segment
from restitution.solving.letters import roles
from restitution.vector import Vector


def with_sides(problem: Problem) -> Problem:
    """The problem, in which spheres on the right of a wall come at that wall from its right."""
    spheres = tuple(_with_side(problem, sphere) for sphere in problem.spheres)
    return problem if spheres == problem.spheres else replace(problem, spheres=spheres)


def _with_side(problem: Problem, sphere: Sphere) -> Sphere:
    """The sphere, with an angle from the direction of a wall on whose right it is."""
    match sphere.velocity:
        case Polar(size, angle, None, Name(name)) if sphere.position is not None:
            wall = next((each for each in problem.walls if each.name == name), None)
        case _:
            return sphere
    shape = None if wall is None else wall.shape
    if wall is None or not isinstance(shape, Line | Segment) or not shape.is_placed:
        return sphere
    try:
        along = _along(problem, shape)
        is_beyond = along is not None and _is_on_the_right(problem, sphere, shape, along)
    except RestitutionError:
        return sphere  # a place or a direction that follows from the motion
    if not is_beyond:
        return sphere
    return replace(sphere, velocity=Polar(size, angle, along, place=sphere.velocity.place))


def _along(problem: Problem, shape: Line | Segment) -> Expression | None:
    """The direction of a straight wall as a vector; None where it is not given."""
    if isinstance(shape, Segment):
        return Binary("-", shape.end, shape.start)
    if shape.along is None or isinstance(_evaluator(problem).value(shape.along), Vector):
        along: Expression | None = shape.along
        return along
    return Polar(Number(Fraction(1)), shape.along)


def _is_on_the_right(
    problem: Problem, sphere: Sphere, shape: Line | Segment, along: Expression
) -> bool:
    """Whether a sphere begins on the right of a wall, whatever the letters are."""
    evaluator = _evaluator(problem)
    side = evaluator.vector(along)
    gap = evaluator.vector(sphere.position) - evaluator.vector(shape.point)
    return Oracle(roles(problem)).proves(compared(side.x * gap.y, "<", side.y * gap.x))


def _evaluator(problem: Problem) -> Evaluator:
    known = roles(problem)
    return Evaluator(Symbolic(), lambda name: known.get(name, REAL).symbol(name))


__all__ = ["with_sides"]
