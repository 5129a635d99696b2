"""By which speed a time is worked out: the whole one, or that in a direction, which is named."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Line,
    Meaning,
    Relation,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    is_function,
    unsigned,
)
from restitution.workings.naming.measured import vector_worth, worth
from restitution.workings.naming.quantities import Naming

Side = tuple[Unit, Expression | sp.Expr]
"""A component of a velocity: **i** or **j**, and what it is in this direction."""

_COORDINATE: dict[Expression, str] = {Unit("i"): "x", Unit("j"): "y"}


def speed_of_a_flight(derivation: Derivation, naming: Naming, line: Line) -> Sentence:
    """The speed by which a distance is divided, in words.

    *speed* of who moves along **i** or **j** alone, else *speed parallel to the x-axis*, or
    *perpendicular to W* where the question has no **i**; *in that direction* of another line.
    """
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].right:
        case Binary("/", _, speed):
            own = _worth(speed)
        case Number(ratio):  # a distance and a speed that are whole numbers
            speed, own = Number(ratio), sp.Integer(ratio.denominator)
        case _:
            return say("flight.speed-there")
    if own is None:
        return say("flight.speed-there")
    sides = list(_sides(derivation, naming, line))
    values = [(unit, value) for unit, side in sides if (value := _worth(side)) is not None]
    if sides and len(values) == len(sides):
        moving = [(unit, value) for unit, value in values if value != 0]
        if len(moving) == 1 and len(sides) == 2 and _divides(naming, line, *moving[0], own):
            return say("flight.speed")
        fitting = {unit for unit, value in moving if value in (own, -own)}
        if len(fitting) > 1:  # whose components are equal comes to a wall across it
            fitting &= {_normal(naming, line)}
        if len(fitting) == 1:
            return _in_the_direction(naming, line, fitting.pop())
    across = _across_a_wall(derivation, naming, line, speed)
    return say("flight.speed-there") if across is None else across


def _divides(naming: Naming, line: Line, unit: Unit, value: Any, own: sp.Expr) -> bool:
    """Whether a distance is divided by the only component, up to a number of the distance.

    Such a number is told from the sine of an angle only where that component is the one into the
    wall.
    """
    if value in (own, -own):
        return True
    return unit == _normal(naming, line) and bool((own / value).is_Integer)


def _normal(naming: Naming, line: Line) -> Expression | None:
    """**i** or **j** where that is square to the wall to which a body comes."""
    event = naming.events.get(line.move.event or 0)
    if event is None or not event.wall:
        return None
    normal = naming.unit_of(event, "along")
    return _of_a_wall_by_its_ends(naming, event) if normal is None else unsigned(normal)


def _of_a_wall_by_its_ends(naming: Naming, event: Event) -> Unit | None:
    """**i** or **j** where one is square to a wall that its ends give."""
    fact = naming.derivation.fact(f"axis {event.number}")
    if fact is None or len(fact.relation.options) != 1:
        return None
    vector = vector_worth(fact.relation.only[-1].right)
    if vector is None or (vector.x == 0) == (vector.y == 0):
        return None
    return Unit("i" if vector.y == 0 else "j")


def _in_the_direction(naming: Naming, line: Line, axis: Unit) -> Sentence:
    """The direction of a speed: by an axis where the question has any, else by the wall."""
    if naming.has_axes:
        return say("flight.speed-along", axis=_COORDINATE[axis])
    normal = _normal(naming, line)
    if normal is None:
        return say("flight.speed-there")
    wall = naming.events[line.move.event or 0].bodies[1]
    return say(
        "flight.speed-across-wall" if normal == axis else "flight.speed-along-wall", wall=wall
    )


def _across_a_wall(
    derivation: Derivation, naming: Naming, line: Line, speed: Expression
) -> Sentence | None:
    """The speed of a body of which the statement says at what angle to a wall it moves."""
    fact = derivation.fact(f"velocity {line.move.bodies[0]}")
    if fact is None or fact.id not in line.premises:
        return None
    match fact.relation.only[-1].right, speed:
        case (
            Polar(size, angle, None, Name(wall)),
            Binary("*", own, Apply("sin" | "cos" as name, at)),
        ) if own == size and at == angle:
            normal = _normal(naming, line)
            if (
                naming.has_axes
                and normal is not None
                and name == "sin"
                and wall in _ends(naming, line)
            ):
                return say("flight.speed-along", axis=_COORDINATE[normal])
            return say(
                "flight.speed-across-wall" if name == "sin" else "flight.speed-along-wall",
                wall=wall,
            )
    return None


def _ends(naming: Naming, line: Line) -> tuple[str, ...]:
    """The bodies of the impact at which the time of a line ends."""
    event = naming.events.get(line.move.event or 0)
    return () if event is None else event.bodies


def _sides(derivation: Derivation, naming: Naming, line: Line) -> Iterator[Side]:
    """The components of the velocity of the body of a line, as the lines that it cites have them.

    They are those of the statement only where no line has one.
    """
    own = [
        side
        for ref in line.premises
        if isinstance(ref, int)
        for cited in (derivation.line(ref),)
        if cited is not None
        for side in _sides_of(naming, cited, line.move.bodies)
    ]
    yield from own
    if own:
        return
    ratios = dict(_ratios_cited(derivation, line))
    for ref in line.premises:
        fact = derivation.fact(ref)
        if fact is not None and _is_of_the_velocity(fact, line.move.bodies):
            vector = vector_worth(fact.relation.only[-1].right)
            if vector is not None:
                yield Unit("i"), vector.x.subs(ratios)
                yield Unit("j"), vector.y.subs(ratios)


def _ratios_cited(derivation: Derivation, line: Line) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The sines and cosines with their values that a line cites."""
    for cited in derivation.lines_in(line.premises):
        match cited.relation:
            case Relation((links,)):
                for link in links:
                    if link.sign == "=" and is_function(link.left, "sin", "cos"):
                        yield worth(link.left), worth(link.right)


def _is_of_the_velocity(fact: Fact, bodies: tuple[str, ...]) -> bool:
    match fact.relation.only[0].left:
        case Quantity("velocity", (Name(body),)):
            return body in bodies
    return False


def _sides_of(naming: Naming, line: Line, bodies: tuple[str, ...]) -> Iterator[Side]:
    """The component of one of these bodies that a line has, along **i** or **j**."""
    value: Expression
    match line.relation:
        case Meaning(letter, quantity):
            left, value = quantity, Letter(letter)
        case Relation(((link, *_) as links,)):
            left, value = link.left, links[-1].right
        case _:
            return
    if isinstance(left, Letter) and left.name in naming.meanings:
        left = naming.meanings[left.name].quantity
    match left:
        case Quantity("velocity", (Name(body),)) if body in bodies:
            vector = vector_worth(value)
            if vector is not None:
                yield Unit("i"), vector.x
                yield Unit("j"), vector.y
        case Quantity("along" | "across" as kind, (Quantity("velocity", (Name(body),)), axis)) if (
            body in bodies
        ):
            unit = axis
            if not isinstance(unsigned(axis), Unit):
                unit = naming.unit_of(naming.event_of_axis(axis), kind) or axis
            match unit:
                case Unit():
                    yield unit, value
                case Negate(Unit() as opposite):
                    yield opposite, Negate(value)


def _worth(value: Expression | sp.Expr) -> sp.Expr | None:
    """What a tree is worth in letters that are positive; None where a line cannot say it."""
    try:
        return value if isinstance(value, sp.Basic) else sp.expand(worth(value))
    except (RestitutionError, TypeError):
        return None
