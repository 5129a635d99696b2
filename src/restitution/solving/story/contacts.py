"""Places of contact that are sought: unknowns of their own, where a root would nest.

A sphere whose direction is sought comes to another one, or to a circular wall, at a place that
told forward is a root of an expression in that direction; what happens next is a root of this
root. Where a fact stands at the end (a sphere reaches a point), the place of contact is therefore
left unknown, with what is known of it: it lies on a circle around what is struck, and the path
leads there. The equations are then polynomials with few unknowns each, and can be solved from the
end of the story (``stages``). What comes out is checked by telling the story forward in numbers.

The unknowns of event n are ``c_nx`` and ``c_ny``, for the line of centres; ``w_n``, one over the
time of the flight that leads there; ``s_n``, how much of the line of centres a sphere that was at
rest has as its velocity afterwards.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

import sympy as sp

from restitution.expression.evaluate import Scalar
from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Part, Problem
from restitution.records import dataclass
from restitution.shapes import Circle
from restitution.solving.story.conditions import Condition, Equation
from restitution.solving.story.state import State
from restitution.vector import Vector


@dataclass(frozen=True)
class Contact:
    """How a sphere comes to a place of contact that is sought, or was."""

    centres: Vector  # from the sphere to what it strikes, or from the centre of a round wall
    flight: Scalar
    velocity: Vector | None  # just before, by the way it takes; None where the place is known


def ends_at_a_point(problem: Problem, part: Part) -> bool:
    """Whether a body comes to a point after an impact whose place follows by a root."""
    by_root: set[str] = set()
    round_walls = {wall.name for wall in problem.walls if isinstance(wall.shape, Circle)}
    spheres = {sphere.name for sphere in problem.spheres}
    for step, _, _ in problem.timeline(part):
        if isinstance(step, Impact):
            free = step.second in spheres and step.along is None and step.offset is None
            if free or step.second in round_walls or step.first in by_root:
                by_root |= {step.first, step.second} & spheres
        elif isinstance(step, Arrival) and step.body in by_root:
            walls = {wall.name for wall in problem.walls}
            if not (isinstance(step.target, Name) and step.target.name in walls):
                return True
    return False


def rests_on(values: Iterable[Scalar], names: Collection[str]) -> bool:
    """Whether expressions hold one of these letters, or a hidden unknown."""
    return any(
        symbol.name in names or symbol.name.startswith("_")
        for value in values
        for symbol in sp.sympify(value, strict=True).free_symbols
    )


def is_sought(state: State, number: int, *values: Scalar) -> bool:
    """Whether the place of event ``number`` is sought, where a root of ``values`` would give it."""
    if state.problem.altered:
        return False
    chooses = getattr(state.unknowns, "seeks_contact", None)
    return chooses is not None and state.field.exact and bool(chooses(number, values))


def with_sphere(
    state: State, number: int, step: Impact, start: Vector, velocity: Vector, other: Vector
) -> Contact:
    """How a sphere at ``start`` comes to another one at rest at ``other``."""
    r = state.radius(step.first)
    assert r is not None
    phrase = f"the line of centres of {step.first} and {step.second}"
    c = _hidden(state, number, phrase)
    state.equations.append(Equation(c.dot(c) - 4 * r * r, phrase, kind="direction"))
    displacement = other - c - start
    reason = f"{step.first} and {step.second} are separating"
    state.conditions.append(Condition(displacement.dot(c), ">", reason, "approach"))
    name = step.first
    missed = f"{step.first} passes {step.second} without touching it"
    return _arriving(state, number, name, displacement, velocity, c, missed)


def with_circle(
    state: State,
    number: int,
    name: str,
    wall: str,
    out: Vector,
    reach: Scalar,
    inside: bool,
    velocity: Vector,
) -> Contact:
    """How a sphere ``out`` of the centre of a circular wall comes to it."""
    phrase = f"the place where {name} strikes {wall}"
    c = _hidden(state, number, phrase)
    if not state.still(out):
        # Along and across the radius to where it was: what is symmetrical shows as such.
        c = out * c.x + out.turned_left() * c.y
    state.equations.append(Equation(sp.expand(c.dot(c) - reach * reach), phrase, kind="direction"))
    displacement = c - out
    reason = f"{name} moves away from {wall}"
    towards = displacement.dot(c)
    state.conditions.append(Condition(towards if inside else -towards, ">", reason, "approach"))
    return _arriving(state, number, name, displacement, velocity, c, f"{name} passes by {wall}")


def _hidden(state: State, number: int, phrase: str) -> Vector:
    return Vector(
        state.unknowns.hidden(f"c_{number}x", phrase, "real"),
        state.unknowns.hidden(f"c_{number}y", phrase, "real"),
    )


def _arriving(
    state: State,
    number: int,
    name: str,
    displacement: Vector,
    velocity: Vector,
    c: Vector,
    missed: str,
) -> Contact:
    pace = state.unknowns.hidden(f"w_{number}", f"the time that {name} takes", "positive")
    state.equations.append(Equation(displacement.cross(velocity), missed))
    if not pace.is_Symbol:
        return Contact(c, 1 / pace, None)
    state.equations.append(
        Equation(pace * displacement.dot(displacement) - displacement.dot(velocity), missed)
    )
    return Contact(c, 1 / pace, displacement * pace)


def velocities_after(
    state: State, number: int, step: Impact, u: Vector, c: Vector, e: Scalar
) -> tuple[Vector, Vector, Vector]:
    """Velocities after of a sphere with velocity ``u`` and of one at rest, and its impulse."""
    m, other = state.mass(step.first), state.mass(step.second)
    r = state.radius(step.first)
    assert r is not None
    phrase = f"the speed of {step.second} after event {number}"
    share = state.unknowns.hidden(f"s_{number}", phrase, "positive")
    law = share * (m + other) * 4 * r * r - (1 + e) * m * u.dot(c)
    state.equations.append(Equation(sp.expand(law), "Newton's experimental law", kind="law"))
    after = c * share
    return state.neat(u - after * (other / m)), after, after * other
