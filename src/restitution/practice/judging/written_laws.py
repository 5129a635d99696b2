"""Laws that are written out term by term, with numbers put in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Quantity,
    Unit,
    is_component,
    letters,
)
from restitution.practice.judgement import Use
from restitution.practice.judging.entries import Entry
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.terms import terms_of
from restitution.practice.worlds.world import World
from restitution.problem import Impact

# What a line is said to use where too little is left open in it for a law to be seen. By chance
# ``w + 2 = 3`` holds by momentum as well, of which it has no terms.
_OTHERWISE = frozenset({"solve", "unchanged", "fact", "component", "momentum"})
_NEAR, _TINY = 0.005, 1e-9
_LEAST = 3


def with_written_law(uses: tuple[Use, ...], entry: Entry, world: World) -> tuple[Use, ...]:
    """The uses of a line, a law of two spheres first if all its terms are those of the law.

    ``12 - 2 = 3(1.5) + w`` is an equation of w alone, and momentum all the same.
    """
    if not uses or uses[0].principle not in _OTHERWISE or not _is_open(entry):
        return uses
    if uses[0].principle == "momentum" and _has_two_velocities(entry):
        return uses
    for number, spheres in _pairs_of(world):
        if any(_is_momentum(entry, world, number, spheres, axis) for axis in _axes(number)):
            law = Use("momentum", number, spheres)
            return (law, *(use for use in uses if use.principle != "momentum"))
        if _is_restitution(entry, world, number, spheres):
            law = Use("restitution", number, spheres)
            return (law, *(use for use in uses if use.principle != "restitution"))
    return uses


def is_written_momentum(entry: Entry, world: World) -> bool:
    """Whether all terms of an equation are momenta along a line of centres, whatever their signs.

    ``8 + 5 = 2v + 5`` is of momentum, also where v comes out as another law altered would have it.
    """
    return _is_open(entry) and any(
        _is_momentum(entry, world, number, spheres, Quantity("line_of_centres", (), number))
        for number, spheres in _pairs_of(world)
    )


def has_terms_of_other_sizes(entry: Entry, world: World) -> bool:
    """Whether an equation has as many terms as there are momenta, and other ones.

    In ``4 - 2k = -2 + k`` it is a mass that is left out, and no sign. The momenta of any impact
    may be meant.
    """
    other = False
    for number, spheres in _pairs_of(world):
        momenta = _momenta(world, number, spheres, Quantity("line_of_centres", (), number))
        alike = _terms_for(momenta or (), entry)
        if alike is not None and _have_sizes(alike, momenta or (), entry, world):
            return False
        other = other or alike is not None
    return other


def leaves_out_one_mass(entry: Entry, world: World) -> bool:
    """Whether the terms of a claim are the momenta of two spheres, of one without its mass."""
    for number, spheres in _pairs_of(world):
        momenta = _momenta(world, number, spheres, Quantity("line_of_centres", (), number))
        alike = _terms_for(momenta or (), entry)
        if alike is None or momenta is None or _have_sizes(alike, momenta, entry, world):
            continue
        for place, body in enumerate(spheres):
            mass = world.scalar(Quantity("mass", (Name(body),)))
            own = [x / mass if n // 2 == place else x for n, x in enumerate(momenta)]
            if _have_sizes(alike, own, entry, world):
                return True
    return False


def _terms_for(momenta: Sequence[Array], entry: Entry) -> Sequence[Sequence[Expression]] | None:
    """The terms of an equation, if there are as many as there are momenta that are not zero."""
    count = sum(bool(np.all(np.abs(own) > _TINY)) for own in momenta)
    alike = [terms for terms in terms_of(entry.claim) if len(terms) == count > _LEAST]
    return alike if alike and _is_open(entry) else None


def _have_sizes(
    alike: Sequence[Sequence[Expression]], wanted: Sequence[Array], entry: Entry, world: World
) -> bool:
    """Whether terms, in one of their forms, have these sizes that are not zero."""
    moving = [np.abs(own) for own in wanted if np.all(np.abs(own) > _TINY)]
    return any(have_sizes(terms, moving, entry, world) for terms in alike)


def _is_open(entry: Entry) -> bool:
    """Whether a claim is an equation with a letter in a sum."""
    sides = entry.claim.left, entry.claim.right
    return entry.claim.sign == "=" and any(map(letters, sides))


def _has_two_velocities(entry: Entry) -> bool:
    """Whether two letters of a claim are components of velocities: none is put in."""
    names = letters(entry.claim.left) | letters(entry.claim.right)
    return sum(map(is_component, map(entry.meanings.get, names))) > 1


def _axes(number: int) -> Iterator[Expression]:
    """The line of centres, and i and j, along which momentum as a vector is kept."""
    yield Quantity("line_of_centres", (), number)
    yield from (Unit("i"), Unit("j"))


def _pairs_of(world: World) -> Iterator[tuple[int, tuple[str, str]]]:
    """The impacts of two spheres, by the number of the event."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and number in world.lines and step.second not in world.walls:
            yield number, (step.first, step.second)


def _is_momentum(
    entry: Entry, world: World, number: int, spheres: Sequence[str], axis: Expression
) -> bool:
    """Whether the terms of a claim are the momenta along an axis, before and after."""
    momenta = _momenta(world, number, spheres, axis)
    if momenta is None:
        return False
    pairs = zip(momenta[::2], momenta[1::2], strict=True)
    if all(np.all(np.abs(before - after) <= _TINY) for before, after in pairs):
        return False  # across the line of centres each keeps its own
    return _has_terms(entry, world, momenta)


def _momenta(
    world: World, number: int, spheres: Sequence[str], axis: Expression
) -> list[Array] | None:
    """The momenta of two spheres along an axis, each before and after; None without a value."""
    momenta: list[Array] = []
    for body, stage in product(spheres, (number - 1, number)):
        part = Quantity("along", (Quantity("velocity", (Name(body),), stage), axis))
        momentum = Binary("*", Quantity("mass", (Name(body),)), part)
        try:
            momenta.append(world.spread(world.scalar(momentum)))
        except RestitutionError:
            return None
    return momenta


def _is_restitution(entry: Entry, world: World, number: int, spheres: Sequence[str]) -> bool:
    """Whether the terms of a claim are speeds of separation, and of approach times e."""
    line = Quantity("line_of_centres", (), number)
    try:
        before, after = (
            [
                world.spread(world.scalar(Quantity("along", (velocity, line))))
                for velocity in (Quantity("velocity", (Name(body),), stage) for body in spheres)
            ]
            for stage in (number - 1, number)
        )
        e = world.spread(world.scalar(Quantity("restitution", (), number)))
    except RestitutionError:
        return False
    approach = before[0] - before[1]
    return _has_terms(entry, world, [*after, *(e * own for own in before)]) or _has_terms(
        entry, world, [*after, e * approach]
    )


def _has_terms(entry: Entry, world: World, wanted: Sequence[Array]) -> bool:
    """Whether the terms of a claim are those of a law that are not zero."""
    moving = [np.abs(own) for own in wanted if np.all(np.abs(own) > _TINY)]
    return any(
        len(terms) == len(moving) >= _LEAST and have_sizes(terms, moving, entry, world)
        for terms in terms_of(entry.claim)
    )


def have_sizes(
    terms: Sequence[Expression], wanted: Sequence[Array], entry: Entry, world: World
) -> bool:
    """Whether terms have these sizes, in some order and up to one factor."""
    try:
        own = [world.spread(world.scalar(x, entry.meanings, scope=entry.scope)) for x in terms]
    except RestitutionError:
        return False
    one, other = (np.sort(np.abs(np.stack(values)), axis=0) for values in (own, wanted))
    ratios = one / other
    return bool(np.all(np.ptp(ratios, axis=0) <= _NEAR * ratios[0]))
