"""Two components listed below the heading of a wall: ``after W: u cos α, e u sin α``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import COMPONENTS, Expression, Name, Negate, Quantity, letters
from restitution.practice.judging.entries import Meanings
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_WORD = re.compile(r"[A-Za-z]{3,}")
_FUNCTION = re.compile(r"sin|cos|tan")
# Words that list components, and say nothing else of them.
_LISTING = frozenset(
    ("after", "and", "par", "parallel", "perp", "perpendicular", "along", "across", "the", "wall")
    + ("horizontal", "horizontally", "vertical", "vertically", "hits", "hitting", "component")
    + ("components", "have", "has", "now", "then", "stays", "normal")
)


def as_components(line: ScriptLine, worlds: Sequence[World], meanings: Meanings) -> ScriptLine:
    """A line that lists two wrong components after a wall, with what it claims of each.

    One is right, or both are what came before or that times e; two that come before are no claim.
    The line as it is where that is not so, in the true world or in the student's own.
    """
    event = line.scope.event
    step = worlds[0].events[event - 1] if event and event <= len(worlds[0].events) else None
    if not isinstance(step, Impact) or step.second not in worlds[0].walls or event is None:
        return line
    if len(line.values) != 2 or line.declarations or not _only_lists(line, worlds[0]):
        return line
    if any(letters(value).isdisjoint(worlds[0].letters) for value in line.values):
        return line
    claims: tuple[Claim, ...] | None = None
    for world in worlds:
        listed = _claims(line.values, event, step.first, world, meanings)
        if not listed:
            return line
        claims = claims or listed
    links = tuple(Link((claim,), 1, max(1, len(line.text)), ()) for claim in claims or ())
    return replace(line, kind="relations", links=links, values=())


def _only_lists(line: ScriptLine, world: World) -> bool:
    """Whether a line has no words but those of a list."""
    bodies = {name.lower() for name in (*world.walls, *world.start)}
    words = (word.lower() for word in _WORD.findall(line.text) if not _FUNCTION.search(word))
    return all(word in _LISTING or word in bodies for word in words)


def _claims(
    values: Sequence[Expression], event: int, body: str, world: World, meanings: Meanings
) -> tuple[Claim, ...]:
    """What two values claim of the components after an event; nothing where they may be right."""
    line = Quantity("line_of_centres", (), event)

    def part(kind: str, stage: int) -> Quantity:
        return Quantity(kind, (Quantity("velocity", (Name(body),), stage), line))

    try:
        before, across = (world.scalar(part(x, event - 1)) for x in COMPONENTS)
        after = world.scalar(part("along", event))
        e = world.scalar(Quantity("restitution", (), event))
        first, second = (world.scalar(value, meanings) for value in values)
    except RestitutionError:
        return ()
    for one, other, swapped in ((first, second, False), (second, first, True)):
        towards = values[1] if swapped else values[0]
        beside = values[0] if swapped else values[1]
        known = _same(one, after) or _same(one, before)
        known = known and _same(other, e * across) and not _same(other, across)
        fresh = all(not _same(other, x) for x in (before, after, across, np.hypot(after, across)))
        if known or (_same(one, after) and fresh):
            own = towards if _agree(after, one) else Negate(towards)
            stays = beside if _agree(across, other) else Negate(beside)
            return Claim(part("along", event), "=", own), Claim(part("across", event), "=", stays)
    return ()


def _agree(first: Array, second: Array) -> bool:
    """Whether two values have one sign."""
    return bool(np.all(np.multiply(first, second) >= 0))


def _same(first: Array, second: Array) -> bool:
    """Whether two values have one size at all samples."""
    return bool(np.allclose(np.abs(first), np.abs(second), rtol=1e-6, atol=1e-12))
