"""A velocity of one component, as a vector, where it is resolved at the next impact."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Event, Line, Link, Meaning, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Pair,
    Quantity,
    Unit,
    is_binary,
    is_zero,
    unsigned,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.naming.measured import vector_worth
from restitution.workings.naming.quantities import Naming


def vector_resolved(
    derivation: Derivation, naming: Naming, line: Line, event: Event
) -> lay.Layout | None:
    """The velocity that a line resolves before an impact, if it has one component only.

    It is that after an earlier impact, along the line of that or across it. None where both
    components stand, or where the velocity stands as a vector.
    """
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].left:
        case Quantity(_, (Quantity("velocity", _, int(stage)) as velocity, _)):
            pass
        case _:
            return None
    only = only_component(derivation, naming, line, event)
    if only is None:
        return None
    component, value = only
    unit = _unit(derivation, naming, stage, component)
    if unit is None:
        return None
    sign, size = lay.split_sign(naming.layout(value))
    in_front, unit_vector = lay.split_sign(unit)
    term = lay.product(size, unit_vector)
    vector = term if sign == in_front else lay.negative(term)
    return lay.Relation((naming.layout(velocity), vector), ("=",))


def only_component(
    derivation: Derivation, naming: Naming, line: Line, event: Event
) -> tuple[Expression, Expression] | None:
    """The one component that is not zero of the velocity that a line resolves, with its value."""
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].left:
        case Quantity(_, (Quantity("velocity", _, int(stage)) as velocity, _)):
            pass
        case _:
            return None
    if not 0 < stage < event.number:
        return None
    parts: dict[Expression, Expression] = {}
    for ref in line.premises:
        own = derivation.line(ref)
        match own.relation if own is not None else None:
            case Relation(((Link(left), *_) as links,)):
                quantity = _component_of(naming, left)
            case _:
                continue
        match quantity:
            case Quantity("along" | "across", (other, axis)) if other == velocity:
                if isinstance(axis, Unit) or axis == Quantity("line_of_centres", (), stage):
                    parts[quantity] = links[-1].right
    whole = [(component, value) for component, value in parts.items() if not is_zero(value)]
    if len(parts) != 2 or len(whole) != 1:
        return None
    return whole[0]


def struck_at_rest(derivation: Derivation, naming: Naming, line: Line) -> str | None:
    """The body whose velocity a line resolves, where an impact set it going from rest.

    None where it met something before that.
    """
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].left:
        case Quantity(_, (Quantity("velocity", (Name(body),), int(stage)), _)) if stage:
            return body if went_from_rest(derivation, naming, body, stage) else None
    return None


def went_from_rest(derivation: Derivation, naming: Naming, body: str, stage: int) -> bool:
    """Whether an impact of spheres set a body going that was at rest, and met nothing before."""
    fact = derivation.fact(f"velocity {body}")
    match None if fact is None else fact.relation.options[0][-1].right:
        case Pair(x, y) if is_zero(x) and is_zero(y):
            pass
        case _:
            return False
    events = naming.events.items()
    met = [number for number, event in events if body in event.bodies and number <= stage]
    return met == [stage] and not naming.events[stage].wall


def angle_by_degrees(
    derivation: Derivation, naming: Naming, line: Line, event: Event
) -> Expression | None:
    """The angle to the line of centres, or to the wall, by which a line resolves a velocity.

    It is the difference of the angles of two lines of centres where the data have both.
    """
    assert isinstance(line.relation, Relation)
    left, right = line.relation.options[0][0].left, line.relation.options[0][0].right
    match left:
        case Quantity("along" | "across" as kind, (Quantity("velocity", _, int(stage)), _)) if (
            stage
        ):
            pass
        case _:
            return None
    ratios = [
        node
        for node in walk(right)
        if isinstance(node, Apply) and isinstance(node.argument, Degrees)
    ]
    match ratios:
        case [Apply("sin" | "cos" as ratio, Degrees(size))] if not is_binary(right, "+", "-"):
            pass
        case _:
            return None
    measured = "sin" if event.wall else "cos"
    if isinstance(left.arguments[1], Unit):
        fact = derivation.fact(f"axis {event.number}")
        axis = None if fact is None else fact.relation.only[-1].right
        axis = unsigned(axis)
        kind = "along" if axis == left.arguments[1] else "across"
    angle = size if (ratio == measured) == (kind == "along") else 90 - size
    turns = []
    for number in (stage, event.number):
        fact = derivation.fact(f"axis {number}")
        turns.append(None if fact is None else fact.relation.only[-1].right)
    for pair in (turns, turns[::-1]):
        match pair:
            case [Degrees(one), Degrees(other)] if not event.wall and one - other == angle:
                return Binary("-", Degrees(one), Degrees(other))
    return Degrees(angle)


def in_degrees(angle: Binary) -> Degrees:
    """What a difference of two angles in degrees is."""
    match angle:
        case Binary("-", Degrees(one), Degrees(other)):
            return Degrees(one - other)
    raise ValueError(angle)


def _component_of(naming: Naming, tree: Expression) -> Expression:
    """The component of which a line says the value, perhaps by its letter."""
    meaning = naming.meanings.get(tree.name) if isinstance(tree, Letter) else None
    if not isinstance(meaning, Meaning):
        return tree
    return tree if meaning.sense is not None else meaning.quantity


def _unit(
    derivation: Derivation, naming: Naming, number: int, component: Expression
) -> lay.Layout | None:
    """The unit vector of a component after an impact; None where it has no letter.

    Across is to the left of along.
    """
    match component:
        case Quantity("along", (_, Unit(axis))):
            return lay.Bold(axis)
        case Quantity("along" | "across" as kind, (_, Quantity())):
            pass
        case _:
            return None
    fact = derivation.fact(f"axis {number}")
    direction = None if fact is None else vector_worth(fact.relation.options[0][-1].right)
    if direction is None or (direction.x and direction.y):
        return naming.bold.unit(number, kind)
    along = direction if kind == "along" else direction.turned_left()
    unit = lay.Bold("i" if along.x else "j")
    return lay.negative(unit) if (along.x + along.y).is_negative else unit


__all__ = ["vector_resolved"]
