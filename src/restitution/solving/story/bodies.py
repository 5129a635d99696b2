"""What the bodies of a statement must be before anything can happen to them.

A value that is plainly impossible (a negative mass, a wall of no length, spheres within each
other) is named with its rule and its place before the story is told: what would follow from it, a
clash or a miss, hides what is wrong. Only what is proved counts, in exact numbers or by the signs
that letters have.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations
from typing import Any

import sympy as sp

from restitution.errors import ImpossibleError, StatementError
from restitution.exact.symbols import symbols_in
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Number,
    Place,
    Quantity,
    has_quantity,
    letters,
    line_and_column,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.problem import Compare, Given, Impact, Part, Problem, Sphere, Wall
from restitution.render.layout import display, display_point
from restitution.render.text import to_text
from restitution.shapes import Line, Segment
from restitution.solving.algebra.neat import neat
from restitution.solving.story.state import State
from restitution.vector import Vector

# The sign of an expression in more letters and operations than these is hardly plain.
_PLAIN = 40


def require_bodies(state: State) -> None:
    """Masses and radii are positive, walls have a direction, no spheres overlap at the start.

    Raises ImpossibleError, with its place, for the first of which the contrary is proved.
    """
    for sphere in state.problem.spheres:
        _positive(state, sphere.mass, f"the mass of {sphere.name}", "a mass", sphere.place)
        _positive(state, sphere.radius, f"the radius of {sphere.name}", "a radius", sphere.place)
    for wall in state.problem.walls:
        _positive(state, wall.radius, f"the radius of the wall {wall.name}", "a radius", wall.place)
        _extended(state, wall)
    _apart(state)


def require_direction(c: Vector, what: str, tree: Any, place: Place | None) -> None:
    """Raises ImpossibleError where a direction is proved to be that of the zero vector."""
    if _is_zero(c):
        raise _impossible(f"{what} is along the zero vector, which has no direction", tree, place)


def coefficient_outside(step: Impact) -> bool:
    """Whether the coefficient of an impact is given as a number, and one outside [0, 1].

    However little it is: numbers of finite precision may not show it.
    """
    return step.e is not None and _outside_by_itself(step.e)


@lru_cache(maxsize=1024)
def _outside_by_itself(tree: Expression) -> bool:
    if isinstance(tree, Number):
        return tree.value > 1
    if any(isinstance(node, Letter | Quantity) for node in walk(tree)):
        return False
    try:
        value = in_letters(tree)
    except (StatementError, sp.SympifyError):
        return False
    return bool(value.is_negative) or bool((value - 1).is_positive)


def impossible_coefficient(step: Impact) -> ImpossibleError:
    """The error for a coefficient that is given as a number outside [0, 1]."""
    assert step.e is not None
    return _impossible(
        f"e = {write_expression(step.e)} where {step.first} hits {step.second}: "
        "a coefficient of restitution lies in [0, 1]",
        step.e,
        step.place,
    )


def fixed_letters(problem: Problem, part: Part) -> frozenset[str]:
    """The letters that a fact in force equates with an expression of letters and numbers."""
    return frozenset(
        side.name
        for step, _, _ in problem.timeline(part)
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare) and set(relation.operators) == {"="}
        if not any(map(has_quantity, relation.operands))
        for side in relation.operands
        if isinstance(side, Letter)
    )


# --- one property each --------------------------------------------------------------------------


def _positive(state: State, tree: Any, what: str, noun: str, place: Place | None) -> None:
    if tree is None or _rests_on(state, tree):
        return
    value = sp.sympify(state.read(tree, what), strict=True)
    if _no_more_than_zero(value):
        shown = to_text(display(value))
        if isinstance(tree, Expression) and letters(tree) and not value.free_symbols:
            shown = f"{write_expression(tree)} = {shown}"
        raise _impossible(f"{what} is {shown}: {noun} must be positive", tree, place)


def _extended(state: State, wall: Wall) -> None:
    """A wall has a direction, and a segment a length."""
    match wall.shape:
        case Line(along) if along is not None and not _rests_on(state, along):
            along = state.wall_direction(Name(wall.name))
            require_direction(along, f"the wall {wall.name}", wall.along, wall.place)
        case Segment(start, end) if _are_fixed(state, start, end):
            start, end = (state.read_vector(point, wall.name) for point in (start, end))
            if _is_zero(end - start):
                shown = to_text(display_point(*start))
                text = (
                    f"the wall {wall.name} goes from {shown} to {shown}: a wall must have a length"
                )
                raise _impossible(text, wall.start, wall.place)


def _are_fixed(state: State, *places: Any) -> bool:
    return not any(place is None or _rests_on(state, place) for place in places)


def _apart(state: State) -> None:
    """Spheres with a radius do not overlap at the places given."""
    placed = [
        sphere
        for sphere in state.problem.spheres
        if sphere.position is not None and not _rests_on(state, sphere.position)
    ]
    radius = state.radius(placed[0].name) if placed else None
    if radius is None:
        return
    for sphere in placed:
        for wall in state.problem.walls:
            if wall.radius is not None and not _rests_on(state, wall.centre):
                _clear_of_circle(state, sphere, wall, radius)
    for one, other in combinations(placed, 2):
        p, q = (state.read_vector(sphere.position, sphere.name) for sphere in (one, other))
        square = sp.expand((q - p).dot(q - p))
        if sp.expand(4 * radius * radius - square).is_positive:
            centres = " and ".join(to_text(display_point(*vector)) for vector in (p, q))
            message = (
                f"{one.name} and {other.name} overlap at the start: their centres, at {centres}, "
                f"are {to_text(display(state.field.sqrt(square)))} apart, "
                f"less than two radii, {to_text(display(neat(2 * radius)))}"
            )
            raise _impossible(message, other.position, other.place)


def _clear_of_circle(state: State, sphere: Sphere, wall: Wall, radius: sp.Expr) -> None:
    """A sphere lies inside a circular wall, or outside it."""
    size = state.read(wall.radius, f"the radius of {wall.name}")
    p = state.read_vector(sphere.position, sphere.name)
    out = p - state.read_vector(wall.centre, f"the centre of {wall.name}")
    square = sp.expand(out.dot(out))
    if sp.expand(size * size - square).is_positive:
        if sp.expand(size - radius).is_nonpositive:
            message = (
                f"{sphere.name} is too large to move inside {wall.name}: its radius is "
                f"{to_text(display(radius))}, that of {wall.name} {to_text(display(size))}"
            )
            raise _impossible(message, sphere.radius, sphere.place)
        overlaps = sp.expand(square - (size - radius) ** 2).is_positive
    else:
        apart = sp.expand(square - size * size).is_positive
        overlaps = apart and sp.expand((size + radius) ** 2 - square).is_positive
    if overlaps:
        distance = to_text(display(state.field.sqrt(square)))
        message = (
            f"{sphere.name} overlaps {wall.name} at the start: its centre, at "
            f"{to_text(display_point(*p))}, is {distance} from that of {wall.name}, whose radius "
            f"is {to_text(display(size))}, and the radius of {sphere.name} is "
            f"{to_text(display(radius))}"
        )
        raise _impossible(message, sphere.position, sphere.place)


def _no_more_than_zero(value: sp.Expr) -> bool:
    if symbols_in(value) and value.count_ops() > _PLAIN:
        return False
    return bool(value.is_nonpositive) or (not symbols_in(value) and bool(neat(value) == 0))


def _is_zero(v: Vector) -> bool:
    return all(
        component == 0 or (not symbols_in(component) and neat(component) == 0) for component in v
    )


def _rests_on(state: State, value: Any) -> bool:
    """Whether a property depends on the motion, or on a name that depends on the motion."""
    seen: set[str] = set()
    pending = [value]
    while pending:
        tree = pending.pop()
        if not isinstance(tree, Expression):
            continue
        for node in walk(tree):
            if isinstance(node, Quantity):
                return True
            if isinstance(node, Name) and node.name in state.points:
                pending.append(state.points[node.name].position)
            elif isinstance(node, Letter) and node.name in state.lets and node.name not in seen:
                let, now = state.lets[node.name]
                if now:
                    return True
                seen.add(node.name)
                pending.append(let.expression)
    return False


def _impossible(message: str, tree: Any, place: Place | None) -> ImpossibleError:
    return ImpossibleError(message, *line_and_column(getattr(tree, "place", None) or place))
