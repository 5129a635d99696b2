"""Facts as equations and conditions, in either arithmetic."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import sympy as sp

from restitution.errors import ImpossibleError, MissingError, StatementError
from restitution.expression.evaluate import Angle, Scalar, Value
from restitution.expression.tree import Expression, Name, Place, has_quantity, is_quantity
from restitution.expression.writing import write_expression
from restitution.problem import (
    Aligned,
    AtRest,
    Compare,
    Given,
    Impact,
    Kick,
    Meets,
    Part,
    Problem,
    Relation,
)
from restitution.shapes import Circle, Segment
from restitution.solving.equations.extents import within_a_half_turn
from restitution.solving.story import missing, obstacles
from restitution.solving.story.conditions import AnyOf, Condition, Equation
from restitution.solving.story.forward import Story
from restitution.solving.story.happenings import Happening
from restitution.solving.story.quantities import reason_of_rest, reason_without_direction
from restitution.solving.story.unknowns import Letters, proved_sign
from restitution.vector import Vector

Requirement = Equation | Condition | AnyOf


def givens(problem: Problem, part: Part) -> list[tuple[Given, int]]:
    """The lines of facts in force in a part, each with the number of events told before it."""
    return [(step, now) for step, now, _ in problem.timeline(part) if isinstance(step, Given)]


def requirements(
    relation: Relation, story: Story, now: int, place: Place | None = None
) -> list[Requirement]:
    """Requirements of a relation. Raises StatementError where it makes no sense.

    Raises ImpossibleError where it clashes with a story that is impossible by itself.
    """
    requirements_ = _requirements(relation, story, now, place)
    if story.fault is not None and any(_never(requirement) for requirement in requirements_):
        raise story.fault
    return requirements_


def _never(condition: Requirement) -> bool:
    """Whether an exact equation is one between different numbers."""
    return (
        isinstance(condition, Equation)
        and condition.value.is_number
        and bool(condition.value.is_nonzero)
    )


def _requirements(
    relation: Relation, story: Story, now: int, place: Place | None
) -> list[Requirement]:
    try:
        match relation:
            case Compare():
                return _compare(relation, story, now, place)
            case Aligned():
                return _aligned(relation, story, now, place)
            case AtRest(body):
                v = story.velocity(_sphere(story, body), now)
                why = f"{body.name} is at rest"
                return [Equation(v.x, why, place, True), Equation(v.y, why, place, True)]
            case Meets():
                return _meets(relation, story, now)
    except StatementError as error:
        if error.line is None and place is not None:
            raise error.at(place.line, place.column) from error
        raise
    raise TypeError(relation)  # pragma: no cover - the kinds of relation are all listed


def _sphere(story: Story, name: Name) -> str:
    if name.name not in story.spheres:
        place = name.place
        raise StatementError(
            f"{name.name} is not a sphere",
            None if place is None else place.line,
            None if place is None else place.column,
        )
    return name.name


def _compare(relation: Compare, story: Story, now: int, place: Place | None) -> list[Requirement]:
    evaluator = story.evaluator(now)
    values = [evaluator.value(tree) for tree in relation.operands]
    requirements_: list[Requirement] = []
    for n, op in enumerate(relation.operators):
        left, right = values[n : n + 2]
        if op == "=":
            _look_for_a_size(relation.operands[n : n + 2], (left, right))
            requirements_.extend(equal(story, left, right, place))
            continue
        requirements_.append(_ordered(story, left, op, right, relation.operands[n : n + 2], now))
    return requirements_


def _look_for_a_size(trees: Sequence[Expression], values: Sequence[Value]) -> None:
    """Raises StatementError where a line of centres would equal what is no unit vector."""
    for tree, other, value in zip(trees, reversed(trees), reversed(values), strict=True):
        if not is_quantity(tree, "line_of_centres"):
            continue
        size = None if not isinstance(value, Vector) else value.x**2 + value.y**2
        if isinstance(size, sp.Expr) and size.is_number and sp.simplify(size - 1) != 0:
            text = write_expression(other)
            raise StatementError(
                f"line_of_centres is a unit vector, and {text} is not: write "
                f"'line_of_centres parallel to {text}'"
            )


def equal(story: Story, left: Value, right: Value, place: Place | None) -> list[Requirement]:
    """Left = right, as equations free of inverse functions."""
    zero = story.field.zero
    why = "a fact"
    if isinstance(left, Vector) or isinstance(right, Vector):
        sides = []
        for side in (left, right):
            if isinstance(side, Vector):
                sides.append(side)
            elif not isinstance(side, Angle) and story.field.is_zero(side):
                sides.append(Vector(zero, zero))
            else:
                raise StatementError(
                    "a vector cannot equal a number: abs(…) is its magnitude and along(…, i) a "
                    "component; 'impulse' is a magnitude, and impulse(A) the vector that acts on A"
                )
        a, b = sides
        return [Equation(a.x - b.x, why, place, True), Equation(a.y - b.y, why, place, True)]
    if isinstance(left, Angle) or isinstance(right, Angle):
        evaluator = story.evaluator(0)
        one, other = evaluator.as_angle(left), evaluator.as_angle(right)
        return [
            Equation(one.y * other.x - one.x * other.y, why, place, True),
            Condition(
                _same_sense(story, one, other), ">", "the angles would differ by 180°", "fact"
            ),
        ]
    return [Equation(left - right, why, place, True)]


def _same_sense(story: Story, one: Angle, other: Angle) -> Scalar:
    """What is positive where two angles with the same tangent are the same.

    Beside an angle in numbers that is no right angle, a cosine of the same sign says all.
    """
    for a, b in ((one, other), (other, one)):
        if isinstance(b.x, sp.Expr) and b.x.is_number and (b.x.is_positive or b.x.is_negative):
            return a.x if b.x.is_positive else -a.x
    return one.x * other.x + one.y * other.y


def _ordered(
    story: Story, left: Value, op: str, right: Value, trees: Sequence[Expression], now: int
) -> Condition:
    if isinstance(left, Vector) or isinstance(right, Vector):
        raise StatementError(
            "vectors cannot be compared by size: compare abs(…), their magnitudes, or "
            "along(…, i), the components in one direction"
        )
    relation: Literal[">", ">="] = ">=" if op.endswith("=") else ">"
    small, large = (left, right) if op.startswith("<") else (right, left)
    reason = "a given inequality does not hold"
    if isinstance(small, Angle) or isinstance(large, Angle):
        one, other = trees
        is_open = within_a_half_turn(story, one, other, now)
        evaluator = story.evaluator(0)
        a, b = (evaluator.as_angle(x) for x in (small, large)) if is_open else (None, None)
        if a is None or b is None or all(story.field.is_zero(angle.y) for angle in (a, b)):
            # Of 0° and 180° the difference has no sine that would tell which is the greater.
            first, last = (x.measure() if isinstance(x, Angle) else x for x in (small, large))
            return Condition(last - first, relation, reason, "fact")
        # They differ by 180° at most, so the sign of the sine of the difference is that of it.
        return Condition(b.y * a.x - b.x * a.y, relation, reason, "fact")
    return Condition(large - small, relation, reason, "fact")


def _aligned(relation: Aligned, story: Story, now: int, place: Place | None) -> list[Requirement]:
    a, b = story.direction(relation.left, now), story.direction(relation.right, now)
    dot, cross = a.dot(b), a.cross(b)
    why = "a fact"
    if relation.relation == "perpendicular to":
        return [Equation(dot, why, place, True)]
    if relation.relation in ("in the direction of", "opposite to"):
        for vector, tree in ((a, relation.left), (b, relation.right)):
            if story.still(vector):
                raise ImpossibleError(reason_of_rest(tree))
    requirements_: list[Requirement] = [Equation(cross, why, place, True)]
    if relation.relation == "in the direction of":
        requirements_.append(Condition(dot, ">", "the directions would be opposite", "fact"))
    elif relation.relation == "opposite to":
        requirements_.append(Condition(-dot, ">", "the directions would be the same", "fact"))
    return requirements_


def needs_of_motion(relation: Relation, story: Story, now: int) -> Iterator[Condition | AnyOf]:
    """That what a fact of directions is about does move: what is at rest has no direction."""
    if not isinstance(relation, Aligned):
        return
    evaluator = story.evaluator(now)
    for tree in (relation.left, relation.right):
        vector = evaluator.value(tree) if has_quantity(tree) else None
        if not isinstance(vector, Vector):
            continue
        reason = reason_without_direction(tree, relation.relation)
        parts = [story.rational(part) for part in (vector.x, vector.y)]
        if any(_is_never_zero(story, part) for part in parts):
            continue
        options = tuple(
            Condition(part, "!=", reason, "rest") for part in parts if not story.field.is_zero(part)
        )
        if len(options) > 1:
            yield AnyOf(options, reason, "rest")
        else:
            yield options[0] if options else Condition(story.field.zero, "!=", reason, "rest")


def _is_never_zero(story: Story, x: Scalar) -> bool:
    """Whether a scalar is certainly not zero, whatever its letters are."""
    return isinstance(story.unknowns, Letters) and bool(story.unknowns.proved_sign(x))


def _meets(relation: Meets, story: Story, now: int) -> list[Requirement]:
    one, other = relation.first.name, relation.second.name
    name = _sphere(story, relation.first)
    if other in story.walls:
        _require_free_line(story, now, name, other)
        conditions, reason, refused = _towards_wall(relation, story, now, name)
    else:
        _sphere(story, relation.second)
        event = next(
            (h for h in reversed(story.happenings[:now]) if {one, other} == set(h.bodies)), None
        )
        if event is None:
            raise StatementError(f"{one} and {other} have not collided before this line")
        reason = f"{one} and {other} do not collide again"
        refused = f"{one} and {other} collide again"
        if _leave_their_line(story, event, one, other, now) and _placed(story, event, now):
            return _met_by_places(relation, story, now, reason, refused)
        conditions = [_approach(story, event, one, other, now)]
        rebounds = _rebounds(story, event, one, other, now)
        if rebounds:
            return _met_after_a_rebound(relation, story, conditions[0], rebounds, reason, refused)
    if relation.happens:
        return [Condition(condition, ">", reason, "fact") for condition in conditions]
    options = tuple(Condition(-condition, ">=", refused, "fact") for condition in conditions)
    return [options[0] if len(options) == 1 else AnyOf(options, refused, "fact")]


def _approach(story: Story, event: Happening, one: str, other: str, stage: int) -> Scalar:
    """The speed of approach after event ``stage``, along the line of centres of a given one."""
    towards = event.oriented() if event.bodies[0] == one else -event.oriented()
    return (story.velocity(one, stage) - story.velocity(other, stage)).dot(towards)


def comes_back(story: Story, one: str, other: str, now: int) -> bool:
    """Whether one of two spheres that met may come back to the other from a wall on their line."""
    if {one, other} & set(story.walls):
        return False
    met = [h for h in story.happenings[:now] if {one, other} == set(h.bodies)]
    return bool(met) and bool(_rebounds(story, met[-1], one, other, now))


@dataclass(frozen=True)
class _Rebound:
    """A sphere that may come back to another from the wall ahead of it, along their line.

    ``heading`` is how fast it moves to the wall, ``back`` how fast it comes from there, and
    ``closing`` how fast both approach after that.
    """

    heading: Scalar
    back: Scalar
    closing: Scalar


def _rebounds(
    story: Story, event: Happening, one: str, other: str, now: int
) -> tuple[_Rebound, ...]:
    """The rebounds, of either of two spheres, by which they may meet again."""
    pairs = ((one, other), (other, one))
    return tuple(rebound for pair in pairs for rebound in _rebound(story, event, *pair, now))


def _rebound(
    story: Story, event: Happening, ahead: str, behind: str, now: int
) -> Iterator[_Rebound]:
    """How a sphere comes back from the wall ahead of it.

    Nothing where the sphere has hit no wall on their line that lies beyond it, or is seen not to
    move towards that: it comes back with the coefficient with which it came back before.
    """
    away = event.oriented() if event.bodies[0] == behind else -event.oriented()
    walls = [
        happening
        for happening in story.happenings[:now]
        if happening.bodies[0] == ahead and happening.bodies[-1] in story.walls
    ]
    if not walls or not _keep_to_their_line(story, event, ahead, behind, now):
        return
    normal = walls[-1].oriented()
    beyond = story.rational(normal.dot(away))
    if not story.field.is_zero(story.rational(normal.cross(away))) or story.sign(beyond) != 1:
        return
    pace = story.velocity(ahead, now)
    heading = pace.dot(away)
    if not _is_never_positive(story, heading):
        back = (pace * walls[-1].e).dot(away)
        yield _Rebound(heading, back, story.velocity(behind, now).dot(away) + back)


def _met_after_a_rebound(
    relation: Meets,
    story: Story,
    approach: Scalar,
    rebounds: Sequence[_Rebound],
    reason: str,
    refused: str,
) -> list[Requirement]:
    """What two spheres need to meet, or not to meet, where one may come back from a wall."""
    sure = [proved_sign(story, own.heading) == 1 for own in rebounds]
    if len(rebounds) > 1 and all(sure):
        # Each goes to its own wall: who comes back from there meets the other.
        back = sum(own.back for own in rebounds)
        if relation.happens:
            return [Condition(back, ">", reason, "fact")]
        return [Condition(-back, ">=", refused, "fact")]
    if not relation.happens:
        pairs = ((own.heading, own.closing) for own in rebounds)
        apart = (
            AnyOf(tuple(Condition(-e, ">=", refused, "fact") for e in option), refused, "fact")
            for option in pairs
        )
        return [Condition(-approach, ">=", refused, "fact"), *apart]
    if len(rebounds) > 1:
        return [Condition(approach, ">", reason, "fact")]
    (own,) = rebounds
    if sure[0]:
        return [Condition(own.closing, ">", reason, "fact")]  # who catches up meets it sooner
    if _is_never_positive(story, approach):
        return [Condition(value, ">", reason, "fact") for value in (own.heading, own.closing)]
    options = ((approach, own.heading), (approach, own.closing))
    return [
        AnyOf(tuple(Condition(e, ">", reason, "fact") for e in option), reason, "fact")
        for option in options
    ]


def _is_never_positive(story: Story, x: Scalar) -> bool:
    """Whether it is certain that a scalar is negative or zero."""
    if story.field.exact and sp.sympify(x, strict=True).is_nonpositive:
        return True
    return proved_sign(story, x) in (0, -1)


def _leave_their_line(story: Story, event: Happening, one: str, other: str, now: int) -> bool:
    """Whether two spheres that met may have left the line of centres by the time that matters.

    If nothing has happened to either since, they are separating, and if both keep to the line,
    their order decides. Raises MissingError where only their places can tell.
    """
    since = story.happenings[event.number : now]
    if not any({one, other} & set(happening.bodies) for happening in since):
        return False
    if _keep_to_their_line(story, event, one, other, now):
        return False
    stages = range(event.number, now + 1)
    if _placed(story, event, now):
        return True
    if any(story.sign(_approach(story, event, one, other, n)) in (1, None) for n in stages):
        again = f"whether {one} and {other} collide again"
        unknown = [happening.bodies for happening in (event, *since) if happening.unknown_line]
        if unknown:
            lines = [f"the line of centres of {first} and {second}" for first, second in unknown]
            raise missing.needs(again, lines)
        raise MissingError(
            f"{again} depends on their places, as they move "
            "across their line of centres, one relative to the other"
        )
    return True


def _keep_to_their_line(story: Story, event: Happening, one: str, other: str, now: int) -> bool:
    """Whether two spheres move, one relative to the other, along the line of an impact alone."""
    centres = event.oriented()
    across = (
        story.rational((story.velocity(one, n) - story.velocity(other, n)).cross(centres))
        for n in range(event.number, now + 1)
    )
    return all(story.field.is_zero(value) for value in across)


def _placed(story: Story, event: Happening, now: int) -> bool:
    """Whether the places of the two spheres of an event are known from it on."""
    if story.implied or any(story.place(name, now) is None for name in event.bodies):
        return False
    for happening in story.happenings[event.number : now]:
        if not set(happening.bodies) & set(event.bodies):
            continue
        if isinstance(happening.step, Kick):
            return False
        for name in happening.bodies:
            wall, sphere = story.walls.get(name), story.spheres.get(name)
            if wall is not None and not wall.shape.is_placed:
                return False
            if sphere is not None and sphere.position is None:
                return False
    return True


def _met_by_places(
    relation: Meets, story: Story, now: int, reason: str, refused: str
) -> list[Requirement]:
    one, other = relation.first.name, relation.second.name
    first, second = story.place(one, now), story.place(other, now)
    assert first is not None
    assert second is not None
    v, w = story.velocity(one, now), story.velocity(other, now)
    # At the same time, whichever it is: they are as if they had always moved so.
    gap = (second[0] - w * second[1]) - (first[0] - v * first[1])
    later = obstacles.later(story, first[1], second[1])
    gap, approach = gap + (w - v) * later, v - w
    radius = story.radius(one)
    closing = story.rational(gap.dot(approach))
    aside = story.rational(gap.cross(approach))
    if radius is None:
        if relation.happens:
            return [Equation(aside, reason, fact=True), Condition(closing, ">", reason, "fact")]
        touch = Condition(aside, "!=", reason, "fact")
    else:
        # The distance at which they pass is |gap × approach|/|approach|.
        room = story.rational(4 * radius * radius * approach.dot(approach) - aside * aside)
        if relation.happens:
            return [Condition(value, ">", reason, "fact") for value in (room, closing)]
        touch = Condition(-room, ">=", reason, "fact")
    return [AnyOf((touch, Condition(-closing, ">=", reason, "fact")), refused, "fact")]


def _require_free_line(story: Story, now: int, name: str, wall: str) -> None:
    """Raise MissingError where another sphere stays between a sphere and a wall, on one line.

    That is the sphere which it struck last on its line perpendicular to the wall, both having
    kept to that line, and which struck the wall.
    """
    velocity = story.velocity(name, now)
    for other in story.spheres:
        met = [h for h in story.happenings[:now] if set(h.bodies) == {name, other}]
        if not met or other == name:
            continue
        towards = met[-1].oriented() if met[-1].bodies[0] == name else -met[-1].oriented()
        against = [h for h in story.happenings[:now] if h.bodies == (other, wall)]
        if not against or not all(
            story.field.is_zero(story.rational(vector.cross(towards)))
            for vector in (velocity, against[-1].oriented())
        ):
            continue
        ahead = (against[-1].oriented().dot(towards), velocity.dot(towards))
        if all(story.sign(story.rational(value)) == 1 for value in ahead) and (
            _keep_to_their_line(story, met[-1], name, other, now)
        ):
            raise MissingError(f"{other} is between {name} and {wall}, on one line with both")


def _towards_wall(
    relation: Meets, story: Story, now: int, name: str
) -> tuple[list[Scalar], str, str]:
    """What must be positive for a sphere to come to a wall, and why it is refused, yes or no.

    Without places the wall lies in front of the sphere, at any distance: on the side from which
    it was struck before, or else on that to which the sphere first moved.
    """
    wall = relation.second.name
    v = story.velocity(name, now)
    struck = [h for h in story.happenings[:now] if isinstance(h.step, Impact)]
    own = next((h for h in reversed(struck) if h.bodies == (name, wall)), None)
    again = " again" if relation.again else ""
    reason, refused = f"{name} does not hit {wall}{again}", f"{name} hits {wall}{again}"
    if relation.again and own is None:
        raise StatementError(f"{name} has not hit {wall} before this line")
    shape = story.walls[wall].shape
    if isinstance(shape, Circle) and own is not None:
        return [v.dot(v)], reason, refused  # inside a circle every way leads to it
    normal = story.wall_direction(relation.second).turned_left()
    known = story.place(name, now)
    bounded = isinstance(shape, Segment) and not story.implied
    if shape.point is not None and known is not None and (own is None or bounded):
        through = story.evaluator(0).vector(shape.point)
        gap, speed = normal.dot(through - known[0]), normal.dot(v)
        conditions = [gap * speed]
        if isinstance(shape, Segment) and not story.field.is_zero(speed):
            along = normal.turned_left() * -1
            share = (known[0] + v * (gap / speed) - through).dot(along)
            conditions += [share, along.dot(along) - share]
        return conditions, reason, refused
    event = own or next((h for h in reversed(struck) if h.bodies[1] == wall), None)
    if event is not None:
        return [v.dot(event.oriented())], reason, refused
    for stage in range(now + 1):
        first = story.velocity(name, stage).dot(normal)
        if not story.field.is_zero(first):
            return [v.dot(normal) * first], reason, refused
    return [story.field.zero], reason, refused
