"""Quantities in the words of a student: ``component of A in the direction of i after``."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from restitution.expression.defined import quantity_of
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
)
from restitution.expression.writing import write_expression
from restitution.problem import Event, Impact, Problem, bodies_of
from restitution.wording.telling import has_axes


def words_of(tree: Expression, problem: Problem) -> str:
    """A quantity in words, without an article; any other expression as it is written."""
    tree = quantity_of(tree) or tree
    match tree:
        case Negate(Quantity("along" | "across" as kind, arguments, stage)):
            return _component(kind, arguments, problem, turned=True)
        case Negate(Quantity() as inner):
            return f"minus the {words_of(inner, problem)}"
        case Quantity(kind, arguments):
            return _WORDS.get(kind, _named)(tree, problem)
        case Binary("-", Degrees() as whole, Quantity("angle", (Quantity() as moving, side))):
            if whole == RIGHT_ANGLE:
                return _angle(moving, f"the perpendicular to {_line(side, problem)}", problem)
            return f"180° less the {words_of(tree.right, problem)}"
        case Binary("-", Quantity("energy", one, int(early)), Quantity("energy", two, int(late))):
            if one == two and early + 1 == late:
                return f"kinetic energy lost by {_names(one)}{_during(late, problem)}"
            if one == two and early == late + 1:
                return f"kinetic energy gained by {_names(one)}{_during(early, problem)}"
        case Binary("-", Quantity("velocity", (Name(a),), stage), Quantity("velocity", (Name(b),))):
            return f"velocity of {a} relative to {b}{_when(stage, problem)}"
        case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
            return f"time from {_event(early, problem)} to {_event(late, problem)}"
        case Apply(function, Quantity() as inner):
            return f"{function} of the {words_of(inner, problem)}"
    return write_expression(tree)


def words_in_hints(tree: Expression, problem: Problem) -> str:
    """The same for a reader of the question: where that has no **i** and **j**, a component at the
    first wall is parallel to it, towards it or away from it.
    """
    match tree:
        case Quantity("along", (Quantity("velocity", (Name(body),), stage), axis)):
            side = _side_of_wall(body, stage, axis, problem)
            if side is not None and not has_axes(problem):
                return f"component of {body} {side}{_when(stage, problem)}"
    return words_of(tree, problem)


def _side_of_wall(body: str, stage: object, axis: Expression, problem: Problem) -> str | None:
    """A direction at the first wall that a sphere strikes, if its velocity is told by that.

    A sphere that is told so, without its place, comes from the left of the wall.
    """
    sphere = next((moving for moving in problem.spheres if moving.name == body), None)
    event = problem.events[0] if problem.events else None
    if sphere is None or not isinstance(event, Impact) or stage not in (0, 1):
        return None
    wall = next((struck for struck in problem.walls if struck.name == event.second), None)
    velocity = sphere.velocity
    if wall is None or not isinstance(velocity, Polar) or velocity.wall != Name(wall.name):
        return None
    if event.first != body or sphere.position is not None:
        return None
    line, direction = _TURNS.get(wall.along), _TURNS.get(axis)
    if line is None or direction is None:
        return None
    return {
        0: f"parallel to {wall.name}",
        1: f"away from {wall.name}",
        3: f"towards {wall.name}",
    }.get((direction - line) % 4)


def _names(arguments: tuple[Expression, ...]) -> str:
    return (
        " and ".join(argument.name for argument in arguments if isinstance(argument, Name))
        or "all spheres"
    )


def _named(tree: Quantity, problem: Problem) -> str:
    """A quantity of bodies by its noun; one without bodies by that of all."""
    record, when = KINDS[tree.kind], ""
    if record.of_an_event:
        when = _during(tree.stage, problem)
    elif record.before:
        when = _when(tree.stage, problem)
    if not tree.arguments:
        return f"{record.called_of_all}{when}"
    if not all(isinstance(argument, Name) for argument in tree.arguments):
        return write_expression(tree)
    return f"{record.in_formulas} {_names(tree.arguments)}{when}"


def _restitution(tree: Quantity, problem: Problem) -> str:
    return f"coefficient of restitution{_during(tree.stage, problem)}"


def _time(tree: Quantity, problem: Problem) -> str:
    number = tree.stage if isinstance(tree.stage, int) else 0
    return f"time of {_event(number, problem)}"


def _place(tree: Quantity, problem: Problem) -> str:
    number = tree.stage if isinstance(tree.stage, int) else 0
    return f"position of {_names(tree.arguments)} at {_event(number, problem)}"


def _centres(tree: Quantity, problem: Problem) -> str:
    number = tree.stage if isinstance(tree.stage, int) else 1
    return f"unit vector along {_towards(number, problem)}"


def _along(tree: Quantity, problem: Problem) -> str:
    return _component(tree.kind, tree.arguments, problem, turned=False)


def _component(
    kind: str, arguments: tuple[Expression, ...], problem: Problem, *, turned: bool
) -> str:
    of, axis = arguments
    match of:
        case Quantity("velocity", (Name(body),), stage):
            whose, when = f"component of {body}", _when(stage, problem)
        case Quantity("impulse", (Name(body),), stage):
            whose, when = f"component of the impulse on {body}", _during(stage, problem)
        case _:
            whose, when = f"component of the {words_of(of, problem)}", ""
    return f"{whose} {_direction(kind, axis, problem, turned)}{when}"


def _direction(kind: str, axis: Expression, problem: Problem, turned: bool) -> str:
    """The direction of a component, with its sense."""
    match axis:
        case Unit(name) if kind == "along":
            return f"in the direction of {'−' if turned else ''}{name}"
        case Negate(Unit(name)) if kind == "along":
            return f"in the direction of {'' if turned else '−'}{name}"
        case Name(name):
            relation = "along" if kind == "along" else "perpendicular to"
            return f"{relation} {name}{_arrow(turned)}"
        case Quantity("line_of_centres", (), int(number)):
            if kind == "along":
                return f"along {_towards(number, problem, turned)}"
            return f"perpendicular to the line of centres{_arrow(turned)}"
    relation = "in the direction of" if kind == "along" else "at 90° anticlockwise from"
    return f"{relation} {'−' if turned else ''}{write_expression(axis)}"


def _arrow(turned: bool) -> str:
    return ", the other way," if turned else ""


def _towards(number: int, problem: Problem, turned: bool = False) -> str:
    event = problem.events[number - 1] if 0 < number <= len(problem.events) else None
    if not isinstance(event, Impact):
        return "the line of centres"
    first, second = event.first, event.second
    if any(wall.name == second for wall in problem.walls):
        return f"the normal, {'away from' if turned else 'into'} {second},"
    return f"the line of centres, towards {first if turned else second},"


def _line(side: Expression, problem: Problem) -> str:
    match side:
        case Name(name):
            return name
        case Unit(name):
            return name
        case Quantity("line_of_centres"):
            return "the line of centres"
    return write_expression(side).replace("-", "−")


def _angle_words(tree: Quantity, problem: Problem) -> str:
    one, other = tree.arguments
    match one, other:
        case (
            Quantity("velocity", (Name(a),), stage),
            Quantity("velocity", (Name(b),), other_stage),
        ):
            if a != b:
                return f"angle between the velocities of {a} and {b}{_when(stage, problem)}"
            earlier = _when(other_stage, problem)
            return f"angle between the velocities of {a}{_when(stage, problem)} and{earlier}"
        case Quantity("line_of_centres"), _:
            return f"angle of the line of centres to {_line(other, problem)}"
        case Quantity("velocity"), _:
            assert isinstance(one, Quantity)
            return _angle(one, _line(other, problem), problem)
    return write_expression(tree)


def _angle(moving: Quantity, side: str, problem: Problem) -> str:
    return f"angle of {_names(moving.arguments)} to {side}{_when(moving.stage, problem)}"


# --- when -----------------------------------------------------------------------------------------


def _event(number: int, problem: Problem) -> str:
    """An event by its bodies: ``the impact with W``, ``the impact of A and B``."""
    events = problem.events
    if not 0 < number <= len(events):
        return "the start"
    event = events[number - 1]
    name = _called(event, problem)
    same = [n for n, event in enumerate(events, 1) if _called(event, problem) == name]
    return name if len(same) == 1 else f"{name} (event {number})"


def _called(event: Event, problem: Problem) -> str:
    if not isinstance(event, Impact):
        return f"the event of {bodies_of(event)[0]}"
    if any(wall.name == event.second for wall in problem.walls):
        return f"the impact with {event.second}"
    return f"the impact of {event.first} and {event.second}"


def _when(stage: object, problem: Problem) -> str:
    """When, with a blank in front: ``after``, ``after the impact with W``."""
    if stage is None:
        return ""
    if stage == "before":
        return " before"
    number = stage if isinstance(stage, int) else 0
    if len(problem.events) == 1:
        return " after" if number else " before"
    return f" after {_event(number, problem)}" if number else " at the start"


def _during(stage: object, problem: Problem) -> str:
    if not isinstance(stage, int) or len(problem.events) == 1:
        return ""
    return f" in {_event(stage, problem)}"


_TURNS: Mapping[object, int] = {
    Unit("i"): 0,
    Unit("j"): 1,
    Negate(Unit("i")): 2,
    Negate(Unit("j")): 3,
}
"""Quarter turns from **i**."""

_WORDS: Mapping[str, Callable[[Quantity, Problem], str]] = {
    "restitution": _restitution,
    "time": _time,
    "position": _place,
    "line_of_centres": _centres,
    "along": _along,
    "across": _along,
    "angle": _angle_words,
}
