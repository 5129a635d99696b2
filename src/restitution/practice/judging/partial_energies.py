"""Energies of some bodies alone, and of bodies without their masses, as a line shows them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import permutations

from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    is_binary,
    is_quantity,
    terms_of,
    unsigned,
)
from restitution.practice.judging.claimed import has_value, holds_in, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.reading.relations import worked_out
from restitution.practice.worlds.world import World

_BOTH = 2


def of_a_part(entry: Entry, world: World) -> str | None:
    """The misconception of a line that has the energy of one body, or a mass, left out."""
    if _is_share_of_one(entry, world):
        return "energy-one-sphere"
    return "mass-omitted" if _is_without_mass_of_one(entry, world) else None


def _is_share_of_one(entry: Entry, world: World) -> bool:
    """Whether the share of the energy that is lost is that of one sphere: ``15/25`` of A's 25."""
    if len(world.start) < _BOTH:
        return False
    match meant_by(entry):
        case Binary("/", Quantity(kind, (), stage), Quantity("energy", ())) if kind in LOSSES:
            number = stage if isinstance(stage, int) else len(world.events)
        case _:
            return False
    if holds_in(entry, world):
        return False
    for body in world.start:
        before, after = (Quantity("energy", (Name(body),), n) for n in (number - 1, number))
        share = Binary("/", Binary("-", before, after), before)
        if has_value(share, entry.claim.right, entry, world):
            return True
    return False


def _is_without_mass_of_one(entry: Entry, world: World) -> bool:
    """Whether one of two energies that are added has no mass: ``50 + ½(2)²`` with a mass of 3.

    So is ``½m(w²)`` of a body with the mass km.
    """
    meant = meant_by(entry)
    right = entry.claim.right
    if not is_quantity(meant, "energy") or meant.arguments or not is_binary(right, "+"):
        return False
    if len(world.start) != _BOTH or holds_in(entry, world):
        return False
    masses = {sphere.name: sphere.mass for sphere in world.problem.spheres}
    terms = (right.left, right.right)
    for (one, whole), (other, bare) in permutations(zip(world.start, terms, strict=True)):
        mass = Quantity("mass", (Name(other),))
        unit = masses[one]
        if not isinstance(unit, Letter | Number):
            continue
        shares: list[Expression] = [mass]
        if isinstance(unit, Letter):
            shares = [Binary("/", mass, unit)]
        own = replace(meant, arguments=(Name(one),))
        left_out = replace(meant, arguments=(Name(other),))
        if has_value(own, whole, entry, world) and any(
            has_value(left_out, Binary("*", share, bare), entry, world) for share in shares
        ):
            return not has_value(left_out, bare, entry, world)
    return False


def adds_known_numbers(entry: Entry, entries: Iterable[Entry]) -> bool:
    """Whether a side adds numbers, or takes one from another, of which true lines have one."""
    terms = [unsigned(term) for term in terms_of(entry.claim.right)]
    if len(terms) < _BOTH or not all(isinstance(term, Number) for term in terms):
        return False
    true = (
        side for other in entries if other.right for side in (other.claim.left, other.claim.right)
    )
    known = {worked_out(side) for side in true}
    return any(worked_out(term) in known for term in terms)
