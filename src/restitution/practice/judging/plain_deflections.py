"""Deflections that a line shows by itself to be put together wrongly."""

from __future__ import annotations

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    is_function,
)
from restitution.practice.judging.claimed import has_value, is_given
from restitution.practice.judging.entries import Entry
from restitution.practice.worlds.world import World
from restitution.problem import Impact


def is_deflection_as_angle(entry: Entry, world: World) -> bool:
    """Whether the tangent of a deflection has the value of that of the angle after the impact.

    That is one to the line of centres, ``tan 30° = usinθ/v`` for a sphere turned by 30°, or to a
    wall: ``tan 75° = e tan 45°``.
    """
    left = entry.claim.left
    if not is_function(left, "tan"):
        return False
    walled = {number for number, _ in world.wall_impacts()}
    for number in world.lines:
        line = Quantity("line_of_centres", (), number)
        for name in world.start:
            velocity = Quantity("velocity", (Name(name),), number)
            angle = Quantity("angle", (velocity, line))
            turned = Quantity("deflection", (Name(name),), number)
            ratios = ("tan", "cot") if number in walled else ("tan",)
            for after in (Apply(ratio, angle) for ratio in ratios):
                try:
                    if (
                        has_value(after, entry.claim.right, entry, world)
                        and has_value(turned, left.argument, entry, world)
                        and not has_value(after, left, entry, world)
                    ):
                        return True
                except RestitutionError:
                    continue
    return False


def is_given_deflection(entry: Entry, world: World) -> bool:
    """Whether an angle after an impact has the value that the question gives for the deflection."""
    left = entry.claim.left
    inside = left.argument if is_function(left, "tan") else left
    meant = entry.meanings.get(inside.name) if isinstance(inside, Letter) else inside
    match meant:
        case Quantity("angle", (Quantity("velocity", bodies, int(stage)), _)) if stage:
            turned: Expression = Quantity("deflection", bodies, stage)
        case _:
            return False
    given = is_given("deflection", world.problem)
    own: Expression = meant
    if inside is not left:
        turned, own = Apply("tan", turned), Apply("tan", own)
    value = entry.claim.right
    return (
        given and has_value(turned, value, entry, world) and not has_value(own, value, entry, world)
    )


def is_given_difference(entry: Entry, world: World) -> bool:
    """Whether the difference of the angles to a wall is set equal to a deflection that is given."""
    if not is_given("deflection", world.problem):
        return False
    for number, event in enumerate(world.events, 1):
        if not isinstance(event, Impact):
            continue
        body, wall = Name(event.first), Name(event.second)
        before, after = (
            Quantity("angle", (Quantity("velocity", (body,), stage), wall))
            for stage in (number - 1, number)
        )
        turned = Apply("tan", Quantity("deflection", (body,), number))
        apart = Apply("tan", Binary("-", before, after))
        left, right = entry.claim.left, entry.claim.right
        if event.second not in world.start and has_value(apart, left, entry, world):
            return has_value(turned, right, entry, world)
    return False
