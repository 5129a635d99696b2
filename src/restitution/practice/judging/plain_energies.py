"""Energies, shares of energies and tangents that a line shows by itself to be wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, permutations

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.quantities import ENERGIES, LOSSES
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    is_binary,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    terms_of,
    walk,
)
from restitution.practice.judging.claimed import has_value, holds_in, meant_by
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World

_NEAR = 0.006
"""What a student's own rounding may move a speed by."""
_TWO = Number(Fraction(2))
_COEFFICIENTS = (0.37, 0.71)
_TINY = 1e-9


def is_energy_of_difference(entry: Entry, world: World) -> bool:
    """Whether an energy is that of a difference of speeds of one body: ``½m(10 - 4.27)²``."""
    meant = meant_by(entry)
    kinds = {node.kind for node in quantities_in(meant)}
    if not kinds & ENERGIES:
        return False
    return any(
        _are_speeds_of_one(left, right, entry, world)
        for node in walk(entry.claim.right)
        for left, right in _squared_difference(node)
    )


def is_turned_loss(entry: Entry, world: World) -> bool:
    """Whether an energy lost has the sign of a gain: ``KE lost = 18 - 27 = -9``."""
    claim, meant = entry.claim, meant_by(entry)
    loss = is_quantity(meant, *LOSSES) or (
        is_binary(meant, "-")
        and all(is_quantity(side, *ENERGIES) for side in (meant.left, meant.right))
    )
    if claim.sign != "=" or claim.others or not loss:
        return False
    return holds_in(replace(entry, claim=replace(claim, right=Negate(claim.right))), world)


def has_half_in_all(entry: Entry, world: World) -> bool:
    """Whether the right side of a claim is one product, with a half in it that is no mass."""
    right = entry.claim.right
    half = Number(Fraction(1, 2))
    nodes = list(walk(right))
    halves = nodes.count(half) + sum(is_binary(x, "/") and x.right == _TWO for x in nodes)
    masses = any(sphere.mass == half for sphere in world.problem.spheres)
    return halves > masses and not is_binary(right, "+", "-")


def _squared_difference(tree: Expression) -> Iterator[tuple[Expression, Expression]]:
    match tree:
        case Binary("^", Binary("-" | "+", left, right), Number(power)) if power == 2:
            yield left, right


def _are_speeds_of_one(one: Expression, other: Expression, entry: Entry, world: World) -> bool:
    """Whether two trees are worth the speeds of one body before and after, but for rounding."""
    own = _size(one, entry, world), _size(other, entry, world)
    if own[0] is None or own[1] is None:
        return False
    return any(
        near[0] and near[1] and near[0].isdisjoint(near[1])
        for sizes in _speeds(world)
        for near in [[{n for n, x in enumerate(sizes) if _are_near(size, x)} for size in own]]
    )


def _speeds(world: World) -> Iterator[list[Array]]:
    """The speeds of each body at all stages, and the sizes of its components along each line."""
    for body in world.start:
        stages = range(len(world.events) + 1)
        yield [world.scalar(Quantity("speed", (Name(body),), stage)) for stage in stages]
        velocities = [Quantity("velocity", (Name(body),), stage) for stage in stages]
        for number in world.lines:
            line = Quantity("line_of_centres", (), number)
            yield [np.abs(world.scalar(Quantity("along", (v, line)))) for v in velocities]


def _size(tree: Expression, entry: Entry, world: World) -> Array | None:
    try:
        return np.abs(world.spread(world.scalar(tree, entry.meanings, scope=entry.scope)))
    except RestitutionError:
        return None


def _are_near(one: Array | None, other: Array) -> bool:
    assert one is not None
    return bool(np.all(other > 0) and np.all(np.abs(one - other) <= _NEAR * other))


def is_fraction_of_line(entry: Entry, world: World) -> bool:
    """Whether a share lost at a wall is that of the energy along its normal: ``1 - e²``."""
    match meant_by(entry):
        case Binary("/", Quantity(kind), Quantity("energy")) if kind in LOSSES:
            pass
        case Quantity(kind) if kind in LOSSES and is_numeric(entry.claim.right):
            pass  # lost = 1 - 4/9, where the question asks for a share
        case _:
            return False
    for number, _ in world.wall_impacts():
        e = Quantity("restitution", (), number)
        share = Binary("-", Number(Fraction(1)), Binary("^", e, _TWO))
        if has_value(share, entry.claim.right, entry, world):
            return True
    return False


def is_tangent_inverted(entry: Entry, world: World) -> bool:
    """Whether the tangent after a wall is that before it over e, and not times e."""
    left = entry.claim.left
    if not is_function(left, "tan"):
        return False
    right = entry.claim.right
    quotient = is_binary(right, "/") and is_numeric(right)
    if not quotient and not any(isinstance(node, Apply) for node in walk(right)):
        return False
    for number, body in world.wall_impacts():
        line = Quantity("line_of_centres", (), number)
        velocities = (Quantity("velocity", (Name(body),), n) for n in (number - 1, number))
        before, after = (
            Apply("cot", Quantity("angle", (velocity, line))) for velocity in velocities
        )
        wrong = Binary("/", before, Quantity("restitution", (), number))
        if has_value(after, left, entry, world) and has_value(
            wrong, entry.claim.right, entry, world
        ):
            return True
    return False


def is_energy_of_one_component(entry: Entry, world: World) -> bool:
    """Whether the speed after a wall has the component along it left out: ``½(2)(4e)² = 18``."""
    return _is_of_wrong_squares(entry, world, lambda into, _, e: (_square(_product(into, e)),))


def is_without_a_square(entry: Entry, world: World) -> bool:
    """Whether a component after a wall is not squared beside the other: ``16 + 6e² = 25``."""

    def forms(into: Expression, along: Expression, e: Expression) -> tuple[Expression, ...]:
        whole = _square(_product(into, e)), _square(along)
        return (
            Binary("+", _product(into, _square(e)), whole[1]),
            Binary("+", _product(_square(into), e), whole[1]),
            Binary("+", _product(into, e), whole[1]),
            Binary("+", whole[0], along),
        )

    return _is_of_wrong_squares(entry, world, forms)


def _is_of_wrong_squares(
    entry: Entry,
    world: World,
    forms: Callable[[Expression, Expression, Expression], tuple[Expression, ...]],
) -> bool:
    """Whether a side with e is a multiple of a form, and the other one of the square of a speed.

    A form is of the sizes of the components into a wall and along it, and of e.
    """
    for one, other in permutations((entry.claim.left, entry.claim.right)):
        if "e" not in letters(one) & world.letters.keys() or "e" in letters(other):
            continue
        value = _size(other, entry, world)
        if value is None:
            continue
        for number, body in world.wall_impacts():
            before = Quantity("velocity", (Name(body),), number - 1)
            line = Quantity("line_of_centres", (), number)
            into, along = (Apply("abs", Quantity(kind, (before, line))) for kind in COMPONENTS)
            if not np.all(np.abs(world.spread(world.scalar(along))) > _TINY):
                continue
            speed = world.scalar(Quantity("speed", (Name(body),), number))
            for form in forms(into, along, Letter("e")):
                ratios = _ratios_for(one, form, entry, world)
                if not _are_constant(ratios):
                    continue
                assert ratios is not None
                if np.allclose(np.abs(ratios[0]) * speed**2, value, rtol=1e-6, atol=0):
                    return True
    return False


def _square(tree: Expression) -> Expression:
    return Binary("^", tree, _TWO)


def _product(one: Expression, other: Expression) -> Expression:
    return Binary("*", one, other)


def has_energies_of_both(entry: Entry, world: World) -> bool:
    """Whether one term of a sum is the energy of a body, or twice that, and another is not.

    Or it is what a body loses or gains of its energy.
    """
    terms = list(terms_of(entry.claim.right))
    sizes = [_size(term, entry, world) for term in terms]
    stages = range(len(world.events) + 1)
    for body in world.start:
        energies = [world.scalar(Quantity("energy", (Name(body),), stage)) for stage in stages]
        energies += [np.abs(one - other) for one, other in combinations(energies, 2)]
        known = [size for size in sizes if size is None or np.all(size > _TINY)]
        own = [
            size is not None
            and any(np.all(energy > 0) and _is_once_or_twice(size, energy) for energy in energies)
            for size in known
        ]
        if any(own) and not all(own):
            return True
    return False


def _is_once_or_twice(size: Array, energy: Array) -> bool:
    return any(bool(np.all(np.abs(size - k * energy) <= _TINY * energy)) for k in (1, 2))


def is_of_exchanged_squares(entry: Entry, world: World) -> bool:
    """Whether e is with the square of the wrong component at a wall: ``73 = 6² + (8e)²``."""
    for side in (entry.claim.left, entry.claim.right):
        if "e" not in letters(side) & world.letters.keys() or not isinstance(side, Binary):
            continue
        for number, body in world.wall_impacts():
            before = Quantity("velocity", (Name(body),), number - 1)
            line = Quantity("line_of_centres", (), number)
            into, along = (Binary("^", Quantity(kind, (before, line)), _TWO) for kind in COMPONENTS)
            wrong, right = (_with_square_of_e(*pair) for pair in ((along, into), (into, along)))
            ratios = [_ratios_for(side, square, entry, world) for square in (wrong, right)]
            if _are_constant(ratios[0]) and not _are_constant(ratios[1]):
                return True
    return False


def _with_square_of_e(one: Expression, other: Expression) -> Expression:
    """The sum of a square times e², and of another square."""
    return Binary("+", Binary("*", one, Binary("^", Letter("e"), _TWO)), other)


def _ratios_for(tree: Expression, other: Expression, entry: Entry, world: World) -> Array | None:
    """The ratios of two trees for two values of e, shape (2, samples)."""
    ratios: list[Array] = []
    for value in _COEFFICIENTS:
        e = np.full(world.samples, value)
        changed = world.replaced(letters={**world.letters, "e": e})
        try:
            own = changed.scalar(tree, entry.meanings, scope=entry.scope)
            ratios.append(world.spread(own / changed.scalar(other)))
        except RestitutionError:
            return None
    return np.stack(ratios)


def _are_constant(ratios: Array | None) -> bool:
    return ratios is not None and bool(np.allclose(ratios[0], ratios[1], rtol=1e-6, atol=0))
