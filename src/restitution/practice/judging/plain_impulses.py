"""Impulses, and velocities after them, that a line shows by itself to be wrong in a usual way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import permutations

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    has_unit_vector,
    is_binary,
    is_function,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judging.claimed import has_value, holds_in, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import is_bare
from restitution.practice.worlds.world import World
from restitution.problem import Impact, trees

_TERMS_OF_A_VALUE = 3  # v = 3i + 4j
_NEAR = 0.006
"""What a student's own rounding may move a speed by: 2 for 2.003."""


def is_impulse_of_speeds(entry: Entry, world: World) -> bool:
    """Whether an impulse is a mass times the difference, or the sum, of whole speeds.

    They are those of one body before and after, rounded as the student has them.
    """
    meant = meant_by(entry)
    meant = unsigned(meant)
    if not is_quantity(meant, "impulse"):
        return False
    number = meant.stage if isinstance(meant.stage, int) else len(world.events)
    for body in world.start:
        mass = Quantity("mass", (Name(body),))
        speeds = (Quantity("speed", (Name(body),), stage) for stage in (number - 1, number))
        wanted = [Binary("*", mass, speed) for speed in speeds]
        changes = (Binary(op, *wanted) for op in ("+", "-"))
        if any(_are_near(change, meant, entry, world) for change in changes):
            continue  # along one line speeds are components, and a sign is wrong
        for terms in _two_terms(entry.claim.right):
            for one, other in permutations(terms):
                if _are_near(one, wanted[0], entry, world) and _are_near(
                    other, wanted[1], entry, world
                ):
                    return True
    return False


def is_impulse_of_other_mass(entry: Entry, world: World) -> bool:
    """Whether an impulse is the change of velocity of one sphere times the mass of the other.

    A mass of one unit, *m*, may be one left out.
    """
    return any(not unit for unit in _other_masses(entry, world))


def is_impulse_of_unit_mass(entry: Entry, world: World) -> bool:
    """Whether the mass of the other sphere in an impulse is one unit, as if it were left out."""
    return any(_other_masses(entry, world))


def _other_masses(entry: Entry, world: World) -> Iterator[bool]:
    """Whether the mass of another sphere by which an impulse is worked out is one unit."""
    left = entry.claim.left
    if is_function(left, "abs"):
        entry = replace(entry, claim=replace(entry.claim, left=left.argument))
    meant = unsigned(meant_by(entry))
    if not is_quantity(meant, "impulse") or len(world.start) != 2:
        return
    number = meant.stage if isinstance(meant.stage, int) else len(world.events)
    if number not in world.lines:
        return
    line = Quantity("line_of_centres", (), number)
    for body, other in permutations(world.start):
        own, mass = (Quantity("mass", (Name(name),)) for name in (body, other))
        if _are_near(own, mass, entry, world):
            continue
        along = [
            Quantity("along", (Quantity("velocity", (Name(body),), stage), line))
            for stage in (number - 1, number)
        ]
        change = Binary("*", mass, Binary("-", along[1], along[0]))
        if not _are_near(entry.claim.right, change, entry, world):
            continue
        momenta = [Binary("*", mass, part) for part in along]
        terms = [pair for one in _two_terms(entry.claim.right) for pair in permutations(one)]
        both = any(
            _are_near(one, momenta[0], entry, world) and _are_near(two, momenta[1], entry, world)
            for one, two in terms
        )
        shown = list(walk(entry.claim.right))
        shown = [] if any(_are_near(x, own, entry, world) for x in shown) else shown
        if both or any(_are_near(x, mass, entry, world) for x in shown):
            masses = {sphere.name: sphere.mass for sphere in world.problem.spheres}
            yield isinstance(masses[other], Letter) or masses[other] == Number(Fraction(1))


def is_change_of_momentum(impulse: Expression, value: Expression, world: World) -> bool:
    """Whether numbers add or subtract the momenta of one body before and after an impulse.

    So do ``2 × 4 - 2 × 2`` and ``2(4 - 2)``, whatever the components are taken for.
    """
    if not is_quantity(impulse, "impulse"):
        return False
    number = impulse.stage if isinstance(impulse.stage, int) else len(world.events)
    if number not in world.lines:
        return False
    entry = Entry(0, Claim(impulse, "=", value))
    line = Quantity("line_of_centres", (), number)
    for body in world.start:
        mass = Quantity("mass", (Name(body),))
        velocities = [Quantity("velocity", (Name(body),), n) for n in (number - 1, number)]
        momenta = [
            [Binary("*", mass, Quantity(kind, (v, line))) for kind in COMPONENTS]
            for v in velocities
        ]
        for terms in _two_terms(value):
            for one, other in permutations(terms):
                before = any(_are_near(one, momentum, entry, world) for momentum in momenta[0])
                if before and any(
                    _are_near(other, momentum, entry, world) for momentum in momenta[1]
                ):
                    return True
    return False


def _two_terms(tree: Expression) -> Iterator[tuple[Expression, Expression]]:
    """The two terms of a change of momentum: of ``m(v - u)`` and of ``mv - mu``."""
    match tree:
        case Negate(operand):
            yield from _two_terms(operand)
        case Binary("+" | "-", left, right):
            yield left, right
        case Binary("*", left, right):
            for factor, inside in ((left, right), (right, left)):
                for one, other in _two_terms(inside):
                    yield Binary("*", factor, one), Binary("*", factor, other)


def _are_near(own: Expression, wanted: Expression, entry: Entry, world: World) -> bool:
    """Whether a term has the size of another, but for the student's rounding."""
    try:
        size = np.abs(world.spread(world.scalar(own, entry.meanings, scope=entry.scope)))
        other = np.abs(world.spread(world.scalar(wanted)))
    except RestitutionError:
        return False
    return bool(np.all(other > 0) and np.all(np.abs(size - other) <= _NEAR * other))


def is_impulse_reversed(entry: Entry, world: World) -> bool:
    """Whether a velocity after an impulse is worked out with the impulse in the other sense."""
    if _adds_velocities(entry, world):
        return True
    given = (node for tree in trees(world.problem) for node in walk(tree))
    if not any(is_quantity(quantity, "impulse") for quantity in given):
        return False
    meant = meant_by(entry)
    inside = unsigned(meant)
    match inside:
        case Quantity("velocity", _, int(stage)) if stage:
            after: Expression = inside
        case Quantity("along", (Quantity("velocity", _, int(stage)), _)) if stage:
            after = inside
        case _:
            return False
    twice = Binary("*", Number(Fraction(2)), _at_stage(after, stage - 1))
    value: Expression = Binary("-", twice, after)
    value = Negate(value) if inside is not meant else value
    return has_value(value, entry.claim.right, entry, world)


def _adds_velocities(entry: Entry, world: World) -> bool:
    """Whether a blow is given the sum of two velocities: ``2(v + i - 2j) = 6i - 4j``."""
    for side in (entry.claim.left, entry.claim.right):
        if not any(is_binary(node, "+") and has_unit_vector(node) for node in walk(side)):
            continue
        for name in letters(side) & entry.meanings.keys():
            match entry.meanings[name]:
                case Quantity("velocity", _, int(number)) as after if number:
                    pass
                case _:
                    continue
            if isinstance(world.events[number - 1], Impact):
                continue
            twice = Binary("*", Number(Fraction(2)), _at_stage(after, number - 1))
            put: dict[Expression, Expression] = {Letter(name): Binary("-", after, twice)}
            left, right = (exchanged(x, put) for x in (entry.claim.left, entry.claim.right))
            if holds_in(replace(entry, claim=Claim(left, entry.claim.sign, right)), world):
                return True
    return False


def of_given_impulse(entry: Entry, world: World) -> str | None:
    """The mistake of an equation of a given impulse with the change of one body's velocity.

    Its sense is turned in ``7.5 = 3(v - 4)``, and a mass left out in ``7.5 = 4 - v``.
    """
    given = {node for tree in trees(world.problem) for node in walk(tree)}
    impulses = [node for node in given if is_quantity(node, "impulse")]
    if not impulses or entry.claim.sign != "=":
        return None
    for one, other in permutations((entry.claim.left, entry.claim.right)):
        own_letters = letters(other) - world.letters.keys()
        sought = not own_letters and bool(letters(other) & world.determined)  # 6 + 6e = 5
        if not is_bare(one) or not (sought or len(own_letters) == 1):
            continue  # of one body, and no difference of two velocities
        for impulse in impulses:
            if not _are_near(one, impulse, entry, world):
                continue
            if _are_near(other, impulse, entry, world):
                return "impulse-sign"
            for body in world.start:
                mass = Quantity("mass", (Name(body),))
                own = Binary("*", mass, other)
                if _are_near(own, impulse, entry, world):
                    return "mass-omitted"
    return None


def is_velocity_without_mass(entry: Entry, world: World) -> bool:
    """Whether a claim has a velocity that an impulse, or the momentum, gives without the masses.

    So has ``2i - 3j = v - 2i`` where 2i - 3j is the impulse on half a kilogram. A value alone
    shows nothing of how it was come by.
    """
    if sum(map(_terms_in, (entry.claim.left, entry.claim.right))) <= _TERMS_OF_A_VALUE:
        return False
    names = letters(entry.claim.left) | letters(entry.claim.right)
    for name in names & entry.meanings.keys():
        meant = entry.meanings[name]
        for velocity in {x for x in walk(meant) if is_quantity(x, "velocity")}:
            for value in _without_masses(velocity, world):
                own = exchanged(meant, {velocity: value})
                claim = Claim(
                    exchanged(entry.claim.left, {Letter(name): own}),
                    entry.claim.sign,
                    exchanged(entry.claim.right, {Letter(name): own}),
                )
                if holds_in(replace(entry, claim=claim), world):
                    return True
    return False


def _terms_in(tree: Expression) -> int:
    """How many terms stand in a sum; a pair has two."""
    match tree:
        case Binary("+" | "-", left, right):
            return _terms_in(left) + _terms_in(right)
        case Negate(operand):
            return _terms_in(operand)
        case Pair():
            return 2
    return 1


def _without_masses(velocity: Quantity, world: World) -> Iterator[Expression]:
    """What a velocity after an event would be if every mass were 1."""
    number = velocity.stage
    if not isinstance(number, int) or not 0 < number <= len(world.events):
        return
    (body,) = velocity.arguments[:1]
    event = world.events[number - 1]
    yield Binary("+", _at_stage(velocity, number - 1), Quantity("impulse", (body,), number))
    if not isinstance(event, Impact) or event.second in world.walls:
        return
    other = event.second if body == Name(event.first) else event.first
    before, after = (Quantity("velocity", (Name(other),), n) for n in (number - 1, number))
    yield Binary("+", _at_stage(velocity, number - 1), Binary("-", before, after))


def _at_stage(tree: Expression, stage: int) -> Expression:
    match tree:
        case Quantity("velocity", arguments):
            return Quantity("velocity", arguments, stage)
        case Quantity("along", (velocity, axis)):
            return Quantity("along", (_at_stage(velocity, stage), axis))
    return tree
