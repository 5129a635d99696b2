"""Laws of an impact that a line shows by itself to be used wrongly: values, ratios, vectors."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import permutations, product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.quantities import ENERGIES, LOSSES
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    is_vector,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judging.certain_letters import is_root_of_a_sum
from restitution.practice.judging.claimed import has_value, holds_in, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.plain_energies import has_energies_of_both
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import is_bare
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_TINY = 1e-9
_TWO = Number(Fraction(2))
_ONE = Number(Fraction(1))
_OF_ANGLES = frozenset({"sine-cosine", "angle-from-normal"})
_OF_WHOLE_SPEEDS = frozenset({"restitution-whole-speed", "speed-for-component"})
# What may be wrong in a component before an impact.
_OF_COMPONENTS = frozenset({"sine-cosine", "angle-from-normal", "speed-for-component"})


def is_coefficient_inverted(entry: Entry, world: World) -> bool:
    """Whether a coefficient of restitution is given approach over separation: ``e = 23/17``."""
    meant = meant_by(entry)
    events = _events_of(meant, world)
    return bool(events) and any(
        has_value(Binary("/", _ONE, _coefficient(number)), entry.claim.right, entry, world)
        for number in events
    )


def is_equation_inverted(entry: Entry, world: World) -> bool:
    """Whether an equation for a coefficient that is sought holds with 1/e for e: ``3 = 2e``."""
    sides = (entry.claim.left, entry.claim.right)
    for name in letters(sides[0]) | letters(sides[1]):
        own = Letter(name)
        meant = entry.meanings.get(name, own)
        known = meant == own and name not in world.determined
        if own in sides or known or not _events_of(meant, world):
            continue
        left, right = (exchanged(side, {own: Binary("/", _ONE, own)}) for side in sides)
        if holds_in(replace(entry, claim=Claim(left, entry.claim.sign, right)), world):
            return True
    return False


def is_coefficient_of_speeds(entry: Entry, world: World) -> bool:
    """Whether whole speeds at a wall are in the ratio e: ``5 = e√153``, ``e = 5/√153``."""
    for number, body in world.wall_impacts():
        before, after = (Quantity("speed", (Name(body),), stage) for stage in (number - 1, number))
        into = Quantity("along", (_velocity(body, number - 1), _line(number)))
        if has_value(before, Apply("abs", into), entry, world):
            continue  # nothing moves along the wall
        if number in _events_of(meant_by(entry), world):
            if has_value(Binary("/", after, before), entry.claim.right, entry, world):
                return True
            continue
        e = world.events[number - 1]
        letter = e.e if isinstance(e, Impact) and e.e is not None else Letter("e")
        if not isinstance(letter, Letter) or letter.name not in world.determined:
            continue
        for one, other in permutations((entry.claim.left, entry.claim.right)):
            if letter.name not in letters(other) or letter.name in letters(one):
                continue
            slowed = Binary("*", _coefficient(number), before)
            if has_value(after, one, entry, world) and has_value(slowed, other, entry, world):
                return True
    return False


def is_fraction_of_line_energy(entry: Entry, world: World) -> bool:
    """Whether a share that is lost is one of the energy along the line of centres.

    It is the share of a claim, or the one that is given: ``1 - e² = 3/8``.
    """
    left, right = entry.claim.left, entry.claim.right
    match meant_by(entry):
        case Binary("/", Quantity(kind) as lost, Quantity("energy")) if kind in LOSSES:
            lines = _lines_of_losses(world)
            shares = (Binary("/", lost, along) for _, along in lines)
            hundred = Number(Fraction(100))
            return any(
                has_value(x, right, entry, world)
                for share in shares
                for x in (share, Binary("*", hundred, share))
            )
    for one, other in permutations((left, right)):
        if not is_bare(one) or not letters(other) or letters(other) - world.determined:
            continue
        for number, along in _lines_of_losses(world):
            lost = Quantity("energy_lost", (), number)
            whole = Binary("/", lost, Quantity("energy", (), number - 1))
            share = Binary("/", lost, along)
            if has_value(whole, one, entry, world) and has_value(share, other, entry, world):
                return not has_value(whole, other, entry, world)
    return False


def _lines_of_losses(world: World) -> Iterator[tuple[int, Expression]]:
    """The energies along the line of centres before impacts, and into walls."""
    struck = [(number, (body,)) for number, body in world.wall_impacts()]
    for number, bodies in (*_pairs(world), *struck):
        yield number, reduce(_plus, (_energy_by(x, "along", number - 1, number) for x in bodies))


def is_impulse_by_other_function(entry: Entry, world: World) -> bool:
    """Whether an impulse is right with the other one of sine and cosine: ``mu cos 30``."""
    meant = unsigned(meant_by(entry))
    inside = meant.arguments[0] if is_component(meant) else meant
    right = entry.claim.right
    ratios = [node for node in walk(right) if is_function(node, "sin", "cos")]
    if not is_quantity(inside, "impulse") or len(ratios) != 1:
        return False
    (ratio,) = ratios
    other = Apply("cos" if ratio.function == "sin" else "sin", ratio.argument)
    return has_value(meant_by(entry), exchanged(right, {ratio: other}), entry, world)


def _are_alike(variant: VariantAt, world: World) -> bool:
    """Whether sine and cosine are exchanged at a wall to which a body comes at 45°."""
    if variant.mistake not in _OF_ANGLES or not variant.event.wall:
        return False
    number, (body, *_) = variant.event.number, variant.event.bodies
    parts = (Quantity(x, (_velocity(body, number - 1), _line(number))) for x in COMPONENTS)
    try:
        one, other = (np.abs(world.spread(world.scalar(part))) for part in parts)
    except RestitutionError:
        return False
    return bool(np.allclose(one, other, rtol=_TINY))


def _is_angle_alone(variant: VariantAt, entry: Entry, world: World) -> bool:
    """Whether a deflection is given as an angle before the impact, by its letter or its figures."""
    alone = isinstance(entry.claim.right, Degrees | Letter)
    if variant.mistake != "deflection-difference" or not alone:
        return False
    number = variant.event.number
    angles = (
        Quantity("angle", (_velocity(body, number - 1), _line(number)))
        for body in variant.event.bodies
        if body in world.start
    )
    return any(
        has_value(tree, entry.claim.right, entry, world)
        for angle in angles
        for tree in (angle, Binary("-", RIGHT_ANGLE, angle), Binary("-", STRAIGHT_ANGLE, angle))
    )


def is_energy_of_components(entry: Entry, world: World) -> bool:
    """Whether an energy after two spheres meet has one component of a sphere for its speed.

    One of them may have struck a wall since.
    """
    meant = meant_by(entry)
    if not isinstance(meant, Quantity) or meant.kind not in ENERGIES:
        return False
    for number, pair in _pairs(world):
        stage = number if meant.stage is None else meant.stage
        if not isinstance(stage, int) or stage < number:
            continue
        if stage > number and meant.kind != "energy":
            continue
        bodies = [x.name for x in meant.arguments if isinstance(x, Name)] or list(world.start)
        if not set(bodies) <= set(pair):
            continue
        before: list[Expression] = [
            Quantity("energy", (Name(body),), number - 1) for body in bodies
        ]
        for kinds in product(("whole", "along", "across"), repeat=len(bodies)):
            if set(kinds) == {"whole"}:
                continue
            after = reduce(
                _plus,
                (
                    _energy_by(body, kind, stage, number)
                    for body, kind in zip(bodies, kinds, strict=True)
                ),
            )
            value = after if meant.kind == "energy" else Binary("-", reduce(_plus, before), after)
            wrong = not has_value(meant, entry.claim.right, entry, world)
            if wrong and has_value(value, entry.claim.right, entry, world):
                return True
    return False


def _velocity_of_one(entry: Entry) -> tuple[Quantity, str] | None:
    """The velocity that a line is meant to be, and whose it is."""
    match meant_by(entry):
        case Quantity("velocity", (Name(body),)) as velocity:
            return velocity, body
    return None


def is_across_exchanged(entry: Entry, world: World) -> bool:
    """Whether a velocity after two spheres meet has the other one's component across."""
    of_one = _velocity_of_one(entry)
    if of_one is None:
        return False
    velocity, body = of_one
    typed = entry.claim.right
    for number, pair in _pairs(world):
        if body not in pair or velocity.stage not in (None, number):
            continue
        other = next(sphere for sphere in pair if sphere != body)
        line = _line(number)
        wanted = _velocity(other, number - 1)
        if _has_part("across", typed, wanted, line, entry, world) and _has_part(
            "along", typed, velocity, line, entry, world
        ):
            return True
    return False


def is_restitution_parallel(entry: Entry, world: World) -> bool:
    """Whether a velocity after a wall has e in its component along the wall, the other turned."""
    of_one = _velocity_of_one(entry)
    if of_one is None:
        return False
    velocity, body = of_one
    typed = entry.claim.right
    for number, own in world.wall_impacts():
        if own != body or velocity.stage not in (None, number):
            continue
        line, before = _line(number), _velocity(body, number - 1)
        slowed = Binary("*", _coefficient(number), Quantity("across", (before, line)))
        kept = Quantity("along", (before, line))
        across, along = (Quantity(kind, (typed, line)) for kind in ("across", "along"))
        if has_value(slowed, across, entry, world) and any(
            has_value(component, along, entry, world) for component in (kept, Negate(kept))
        ):
            return True
    return False


def is_law_of_relative_velocities(entry: Entry, world: World) -> bool:
    """Whether relative velocities as vectors are in the ratio e, across the line as well."""
    for number, (first, second) in _pairs(world):
        after, before = (
            Binary("-", _velocity(second, stage), _velocity(first, stage))
            for stage in (number, number - 1)
        )
        slowed = Binary("*", _coefficient(number), before)
        for left, right in permutations((entry.claim.left, entry.claim.right)):
            relative = any(has_value(x, left, entry, world) for x in (after, Negate(after)))
            if not relative or is_bare(left) or not is_vector(right):
                continue
            if any(has_value(x, right, entry, world) for x in (slowed, Negate(slowed))):
                return True
    return False


def is_separation_as_approach(entry: Entry, world: World) -> bool:
    """Whether a separation with a velocity put in is as great as the approach: ``w + 2u = 6u``."""
    own = entry.meanings.keys()
    for number, (first, second) in _pairs(world):
        apart, near = (
            Quantity("along", (Binary("-", _velocity(one, n), _velocity(other, n)), _line(number)))
            for one, other, n in ((second, first, number), (first, second, number - 1))
        )
        for left, right in permutations((entry.claim.left, entry.claim.right)):
            if not is_binary(left, "+", "-") or not letters(left) & own or letters(right) & own:
                continue
            if has_value(apart, left, entry, world) and has_value(near, right, entry, world):
                return True
    return False


def is_time_by_speed(entry: Entry, world: World) -> bool:
    """Whether a time is a distance over a whole speed, where it is that over a component."""
    quotients = [node for node in walk(entry.claim.right) if is_binary(node, "/")]
    if not is_quantity(meant_by(entry), "time") or len(quotients) != 1:
        return False
    distance, own = quotients[0].left, quotients[0].right
    moving = (_velocity(x, n) for x in world.start for n in range(len(world.events) + 1))
    for velocity in moving:
        if not has_value(replace(velocity, kind="speed"), own, entry, world):
            continue
        for unit in (Unit("i"), Unit("j")):
            part = Apply("abs", Quantity("along", (velocity, unit)))
            resolved: dict[Expression, Expression] = {quotients[0]: Binary("/", distance, part)}
            right = exchanged(entry.claim.right, resolved)
            claim = replace(entry.claim, right=right)
            if not _is_zero(part, world) and holds_in(replace(entry, claim=claim), world):
                return True
    return False


def cannot_be(variant: VariantAt, entry: Entry, world: World) -> bool:
    """Whether a claim is not of the kind in which an altered law shows itself.

    A component that is given before an impact is not changed there; and where e is put across,
    each sphere keeps its component along the line: with one of zero an equation tells nothing.
    Who adds two squares has components, and puts no whole speed into a law; and of components
    that have one size nobody sees which is taken for the other.
    """
    squares = any(map(is_root_of_a_sum, walk(entry.claim.right)))
    if squares and variant.mistake in _OF_WHOLE_SPEEDS:
        return True
    if variant.mistake == "energy-one-sphere" and has_energies_of_both(entry, world):
        return True
    if _is_angle_alone(variant, entry, world) or _are_alike(variant, world):
        return True
    meant = meant_by(entry)
    meant = unsigned(meant)
    match meant:
        case Quantity("along" | "across", (Quantity("velocity", (Name(body),), int(stage)), _)):
            before = stage < variant.event.number and variant.mistake not in _OF_COMPONENTS
            known = (sphere.velocity for sphere in world.problem.spheres if sphere.name == body)
            if before and any(velocity is not None for velocity in known):
                return True
    if variant.mistake != "restitution-parallel":
        return False
    if variant.event.wall:
        number, (body, *_) = variant.event.number, variant.event.bodies
        # Where nothing moves along the wall, e is left out and not put elsewhere.
        return _is_zero(Quantity("across", (_velocity(body, number - 1), _line(number))), world)
    names = letters(entry.claim.left) | letters(entry.claim.right)
    bodies = {
        node.name
        for name in names & entry.meanings.keys()
        if _is_along(entry.meanings[name])
        for node in walk(entry.meanings[name])
        if isinstance(node, Name)
    }
    number = variant.event.number
    along = (Quantity("along", (_velocity(body, number - 1), _line(number))) for body in bodies)
    return len(bodies) > 1 and any(_is_zero(component, world) for component in along)


def _is_zero(tree: Expression, world: World) -> bool:
    try:
        return bool(np.all(np.abs(world.spread(world.scalar(tree))) < _TINY))
    except RestitutionError:
        return False


def _is_along(tree: Expression) -> bool:
    inner = unsigned(tree)
    return is_quantity(inner, "along")


def _has_part(
    kind: str, typed: Expression, wanted: Expression, line: Expression, entry: Entry, world: World
) -> bool:
    """Whether a vector has a component of another one, and not zero."""
    own, other = (Quantity(kind, (vector, line)) for vector in (typed, wanted))
    return has_value(other, own, entry, world)


def _events_of(meant: Expression, world: World) -> tuple[int, ...]:
    """The impacts of which a quantity is the coefficient of restitution."""
    if is_quantity(meant, "restitution"):
        return (meant.stage,) if isinstance(meant.stage, int) else ()
    if not isinstance(meant, Letter):
        return ()
    return tuple(
        number
        for number, step in enumerate(world.events, 1)
        if isinstance(step, Impact) and (step.e or Letter("e")) == meant
    )


def _coefficient(number: int) -> Quantity:
    return Quantity("restitution", (), number)


def _velocity(body: str, stage: int) -> Quantity:
    return Quantity("velocity", (Name(body),), stage)


def _line(number: int) -> Quantity:
    return Quantity("line_of_centres", (), number)


def _energy_by(body: str, kind: str, stage: int, number: int) -> Expression:
    """The energy of a sphere, of its speed or of one of its components."""
    if kind == "whole":
        return Quantity("energy", (Name(body),), stage)
    part = Quantity(kind, (_velocity(body, stage), _line(number)))
    twice = Binary("*", Quantity("mass", (Name(body),)), Binary("^", part, _TWO))
    return Binary("/", twice, _TWO)


def _plus(one: Expression, other: Expression) -> Expression:
    return Binary("+", one, other)


def _pairs(world: World) -> Iterator[tuple[int, tuple[str, str]]]:
    """The impacts of two spheres, by the number of the event."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and number in world.lines and step.second in world.start:
            yield number, (step.first, step.second)


def is_rebound_kept(entry: Entry, world: World) -> bool:
    """Whether the component away from a later wall is that into it: ``w sin 30 = √3eu/2``.

    Of an e that is to be found no other value fits both.
    """
    for number, body in world.wall_impacts():
        if number == 1:
            continue
        line = Quantity("line_of_centres", (), number)
        velocities = (Quantity("velocity", (Name(body),), n) for n in (number - 1, number))
        into, away = (Apply("abs", Quantity("along", (v, line))) for v in velocities)
        for one, other in permutations((entry.claim.left, entry.claim.right)):
            own = "e" in letters(other) and not is_bare(one)
            sizes = Apply("abs", one), Apply("abs", other)
            kept = own and has_value(away, sizes[0], entry, world)
            if kept and has_value(into, sizes[1], entry, world):
                return True
    return False


SHOWN: tuple[tuple[Callable[[Entry, World], bool], str], ...] = (
    (is_coefficient_inverted, "restitution-inverted"),
    (is_equation_inverted, "restitution-inverted"),
    (is_coefficient_of_speeds, "restitution-whole-speed"),
    (is_fraction_of_line_energy, "energy-fraction-of-line"),
    (is_impulse_by_other_function, "sine-cosine"),
    (is_energy_of_components, "energy-component-missing"),
    (is_across_exchanged, "across-exchanged"),
    (is_restitution_parallel, "restitution-parallel"),
    (is_law_of_relative_velocities, "restitution-whole-speed"),
    (is_separation_as_approach, "restitution-omitted"),
    (is_time_by_speed, "speed-for-component"),
    (is_rebound_kept, "restitution-omitted"),
)
"""What a line shows by itself, and its name."""
