"""Components set equal to those at right angles to them: ``v sin β = u cos α``, ``along ½u``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import permutations

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Quantity,
    is_component,
    is_function,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judging.claimed import has_value, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.worlds.world import World
from restitution.problem import Impact

# The component of a velocity that a function of its angle to the wall gives.
_PARTS: Mapping[str, str] = {"sin": "along", "cos": "across"}


def is_sine_for_cosine(entry: Entry, world: World) -> bool:
    """Whether a component after a wall is that before at right angles, both by their angles."""
    if entry.claim.sign != "=" or not letters(entry.claim.left) | letters(entry.claim.right):
        return False
    sides = entry.claim.left, entry.claim.right
    functions = [set(_functions_in(side)) for side in sides]
    if {len(own) for own in functions} != {1} or functions[0] == functions[1]:
        return False
    return any(
        all(
            _is_component(side, stage, name, number, entry, world)
            for side, stage in ((before, number - 1), (after, number))
        )
        for number, step in enumerate(world.events, 1)
        if isinstance(step, Impact) and step.second in world.walls
        for name in (step.first,)
        for before, after in permutations(sides)
    )


def is_kept_by_sines(entry: Entry, world: World) -> bool:
    """Whether the component into a wall is set equal to that before: ``v sin β = u sin α``.

    As the first of two equations, the other one with e, it stands for that along the wall.
    """
    sides = entry.claim.left, entry.claim.right
    if entry.claim.sign != "=" or any(set(_functions_in(side)) != {"sin"} for side in sides):
        return False
    return any(
        all(
            _is_component(side, stage, step.first, number, entry, world)
            for side, stage in ((before, number - 1), (after, number))
        )
        for number, step in enumerate(world.events, 1)
        if isinstance(step, Impact) and step.second in world.walls
        for before, after in permutations(sides)
    )


def is_speed_in_other_ratio(entry: Entry, world: World) -> bool:
    """Whether a speed is resolved in the ratio of the other component: ``along ½u``.

    That of the moment itself, or, as a phrase without a time may stand for it, of the one before.
    """
    meant = unsigned(meant_by(entry))
    if not is_component(meant) or entry.claim.sign != "=":
        return False
    match meant.arguments:
        case (Quantity("velocity", body, int(stage)), axis):
            stages = (stage, stage - 1) if stage else (stage,)
        case _:
            return False
    typed = entry.claim.right
    factors = tuple(_factors_in(typed))
    other = "across" if meant.kind == "along" else "along"
    return any(
        has_value(
            Apply("abs", Quantity(other, (Quantity("velocity", body, moment), axis))),
            Apply("abs", typed),
            entry,
            world,
        )
        for moment in stages
        if any(has_value(Quantity("speed", body, moment), x, entry, world) for x in factors)
    )


def is_exchanged_as_well(entry: Entry, above: Entry, world: World) -> bool:
    """Whether two lines give a body each component the size of the other one, sine for cosine."""
    first, second = (unsigned(meant_by(one)) for one in (above, entry))
    if not is_component(first) or not is_component(second) or first.kind == second.kind:
        return False
    return first.arguments[1] == second.arguments[1] and all(
        any(
            has_value(
                Apply("abs", replace(other, arguments=(moment, other.arguments[1]))),
                Apply("abs", one.claim.right),
                one,
                world,
            )
            for moment in _moments(other)
        )
        for one, other in ((above, second), (entry, first))
    )


def _moments(component: Quantity) -> Iterator[Expression]:
    """The velocity of which a component is, at its moment and before its impact."""
    velocity = component.arguments[0]
    yield velocity
    if isinstance(velocity, Quantity) and isinstance(velocity.stage, int) and velocity.stage:
        yield replace(velocity, stage=velocity.stage - 1)


def _factors_in(tree: Expression) -> Iterator[Expression]:
    """The factors of a product that has more than one, without those below a line."""
    match tree:
        case Binary("*", left, right):
            for side in (left, right):
                yield side
                yield from _factors_in(side)
        case Binary("/", above, _):
            yield above
            yield from _factors_in(above)


def _functions_in(tree: Expression) -> Iterator[str]:
    """The sines and cosines in a tree."""
    for node in walk(tree):
        if isinstance(node, Apply) and is_function(node, *_PARTS):
            yield node.function


def _is_component(
    tree: Expression, stage: int, body: str, number: int, entry: Entry, world: World
) -> bool:
    """Whether a tree has the size of the component that its sine or cosine gives."""
    velocity = Quantity("velocity", (Name(body),), stage)
    line = Quantity("line_of_centres", (), number)
    (function,) = set(_functions_in(tree))
    part = Apply("abs", Quantity(_PARTS[function], (velocity, line)))
    return has_value(part, Apply("abs", tree), entry, world)
