"""Mistakes that a line shows by itself, where it is an instance of no law, right or altered.

And what kind of claim a line is: of an energy, of squares, of a coefficient.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import combinations, permutations, product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.quantities import ENERGIES, LOSSES
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judgement import Use
from restitution.practice.judging.claimed import has_value, holds_in, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.plain_deflections import is_given_difference
from restitution.practice.judging.plain_energies import (
    has_energies_of_both,
    is_energy_of_difference,
    is_energy_of_one_component,
    is_fraction_of_line,
    is_of_exchanged_squares,
    is_tangent_inverted,
    is_turned_loss,
    is_without_a_square,
)
from restitution.practice.judging.plain_impulses import (
    is_impulse_of_other_mass,
    is_impulse_of_speeds,
    is_impulse_of_unit_mass,
    is_impulse_reversed,
    is_velocity_without_mass,
)
from restitution.practice.judging.plain_laws import SHOWN
from restitution.practice.judging.slips import Correction
from restitution.practice.judging.squares import (
    is_root_without_squares,
    is_square_of_a_size,
    is_worth,
)
from restitution.practice.judging.typed_energies import (
    are_one_number,
    given_energies,
    has_half,
    has_square,
    is_given_energy,
)
from restitution.practice.judging.written_laws import have_sizes
from restitution.practice.reading.phrase_names import is_phrase, is_relative
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array, is_bare
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.terms import terms_of
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_TWO = Number(Fraction(2))
_SIGNED = frozenset({"momentum", "restitution"})
_TINY, _ROUNDED = 1e-9, 0.005
# The largest denominator of a multiple of an energy: ¾ of it.
_SIMPLE = 12


def plainly(
    entry: Entry, world: World, entries: Iterable[Entry], mended: Sequence[Correction]
) -> str | None:
    """A misconception in a line that is an instance of no law, altered or not."""
    if entry.claim.sign != "=" or is_turned_loss(entry, world):
        return None
    name = next((name for shows, name in _SHOWN if shows(entry, world)), None)
    if name is not None:
        return name
    changes = {correction.change for correction in mended}
    squares = any(is_square_of_a_size(x, mended, entry, world) for x in mended) and changes <= {
        "square",
        "power",
        "figure",
        "factor",
    }
    above = (other for other in entries if other.claim.left == entry.claim.left)
    worked = isinstance(entry.claim.right, Binary | Apply)
    if squares and worked and _is_of_squares(entry) and not any(map(is_energetic, above)):
        return "square-not-taken"  # where no line above has squares that may be copied wrongly
    return None


def _is_other_component(entry: Entry, world: World) -> bool:
    """Whether a component is given that at right angles to it, by a sine or a cosine."""
    if not any(is_function(node, "sin", "cos") for node in walk(entry.claim.right)):
        return False  # a number may be one by a slip
    meant = meant_by(entry)
    meant = unsigned(meant)
    if not is_component(meant):
        return False
    other = "across" if meant.kind == "along" else "along"
    size = Apply("abs", replace(meant, kind=other))
    claim = replace(entry.claim, left=size, right=Apply("abs", entry.claim.right))
    return holds_in(replace(entry, claim=claim), world)


def _is_without_half(entry: Entry, world: World) -> bool:
    """Whether one of two energies has no ½: ½(2m)w² = ¼mu² for a quarter of ½mu²."""
    for one, other in permutations((entry.claim.left, entry.claim.right)):
        if _loses(entry, one, other) and not has_half(one):
            twice = Claim(other, "=", Binary("/", one, _TWO))
            if holds_in(replace(entry, claim=twice), world):
                return True  # lost = m(10u² - 4u²)
        if not has_square(one):
            continue
        if is_bare(other) and not has_half(one) and is_given_energy(other, world):
            claim = Claim(Binary("/", one, _TWO), "=", other)  # 2(6)² - 2v² = 18, lost 18
            if holds_in(replace(entry, claim=claim), world):
                return True
        if not has_square(other) or is_bare(other):
            continue
        if has_half(one) and not has_half(other):
            claim = Claim(one, "=", Binary("/", other, _TWO))
            if holds_in(replace(entry, claim=claim), world):
                return True
    return False


def _loses(entry: Entry, one: Expression, other: Expression) -> bool:
    """Whether a line gives an energy lost as squares, or as a difference: 3(100 - 40)."""
    lost = other is entry.claim.left and is_quantity(meant_by(entry), *LOSSES)
    return lost and (has_square(one) or any(is_binary(node, "-") for node in walk(one)))


def _is_of_line_energies(entry: Entry, world: World) -> bool:
    """Whether a fact about the energies of spheres is stated of ½mq² along the line alone."""
    sides = entry.claim.left, entry.claim.right
    whole = [_with_whole_energies(side, entry, world) for side in sides]
    if all(tree is None for tree in whole):
        return False
    left, right = (own or side for own, side in zip(whole, sides, strict=True))
    return holds_in(replace(entry, claim=Claim(left, "=", right)), world)


def _with_whole_energies(tree: Expression, entry: Entry, world: World) -> Expression | None:
    """The energies of which a side, a multiple of ½mq² along the line, should be the multiple."""
    size = _spread_in(tree, entry, world)
    for number, spheres in _pairs_of(world):
        line = Quantity("line_of_centres", (), number)
        for body in spheres if has_square(tree) else ():
            name = Name(body)
            part = Quantity("along", (Quantity("velocity", (name,), number), line))
            square = Binary("*", Quantity("mass", (name,)), Binary("^", part, _TWO))
            energy = Quantity("energy", (name,), number)
            along, of_all = (
                _spread_of(form, world) for form in (Binary("/", square, _TWO), energy)
            )
            if not (np.all(along > _TINY) and np.all(of_all > along * (1 + _ROUNDED))):
                continue
            factor = Fraction(float(np.nan_to_num(size / along).flat[0])).limit_denominator(_SIMPLE)
            if factor and np.all(np.abs(size - float(factor) * along) <= _TINY * size):
                return Binary("*", Number(factor), energy)
    return None


def _spread_in(tree: Expression, entry: Entry, world: World) -> Array:
    """The size of a tree of an entry in every sample; not a number where it has no value."""
    try:
        return np.abs(world.spread(world.scalar(tree, entry.meanings, scope=entry.scope)))
    except RestitutionError:
        return np.full(1, np.nan)


def is_speed_by_energies(entry: Entry, world: World) -> bool:
    """Whether a speed is that before in the ratio of the energies: V = kU where V² = kU²."""
    meant = meant_by(entry)
    if not is_quantity(meant, "speed"):
        return False
    number = len(world.events) if meant.stage is None else meant.stage
    for stage in range(number) if isinstance(number, int) else ():
        square, before = Binary("^", meant, _TWO), replace(meant, stage=stage)
        claim = replace(entry.claim, left=square, right=Binary("*", entry.claim.right, before))
        if holds_in(replace(entry, claim=claim), world):
            return True
    return False


def is_whole_speed(entry: Entry, world: World) -> bool:
    """Whether a component of a velocity is given the whole speed of its body, in data alone."""
    if not letters(entry.claim.right) <= world.letters.keys():
        return False
    meant = meant_by(entry)
    meant = unsigned(meant)
    match meant:
        case Quantity("along", (Quantity("velocity", (Name(),) as body, stage), _)):
            if is_zero(replace(meant, kind="across"), world):
                return False  # its component is the speed, with a sign
            claim = replace(entry.claim, left=Quantity("speed", body, stage))
            turned = replace(claim, right=Negate(claim.right))
            return any(holds_in(replace(entry, claim=form), world) for form in (claim, turned))
    return False


def _pairs_of(world: World) -> Iterator[tuple[int, tuple[str, str]]]:
    """The impacts of two spheres, by the number of the event."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and number in world.lines and step.second not in world.walls:
            yield number, (step.first, step.second)


def _walls_of(world: World) -> Iterator[tuple[int, tuple[str, ...]]]:
    """The impacts with walls, each with its sphere."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and step.second not in world.start:
            yield number, (step.first,)


def is_momentum_of_speeds(entry: Entry, world: World) -> bool:
    """Whether terms of an equation of momentum are masses times whole speeds: one, or several."""
    for number, spheres in _pairs_of(world):
        line = Quantity("line_of_centres", (), number)
        sizes: list[tuple[Array, ...]] = []
        for body, stage in product(spheres, (number - 1, number)):
            mass, speed = Quantity("mass", (Name(body),)), Quantity("speed", (Name(body),), stage)
            part = Quantity("along", (Quantity("velocity", (Name(body),), stage), line))
            whole, along = (
                _spread_of(Binary("*", mass, quantity), world) for quantity in (speed, part)
            )
            apart = bool(np.all(np.abs(whole - along) > _ROUNDED * whole))
            sizes.append((along, whole) if apart else (along,))
        for terms in terms_of(entry.claim):
            for chosen in product(*(range(len(size)) for size in sizes)):
                wanted = [size[n] for size, n in zip(sizes, chosen, strict=True)]
                moving = [size for size in wanted if np.all(size > _TINY)]
                fits = any(chosen) and len(terms) == len(moving) > 2
                if fits and have_sizes(terms, moving, entry, world):
                    return True
    return False


def _is_energy_of_one(entry: Entry, world: World) -> bool:
    """Whether the energy of all spheres is given that of some of them, while the others move."""
    for quantity, value in given_energies(world):
        for one, other in permutations((entry.claim.left, entry.claim.right)):
            if are_one_number(one, value) and not is_bare(
                other
            ):  # ½(2)(36) - ½(2)v² = 18 is all that is lost
                stage = len(world.events) if quantity.stage is None else quantity.stage
                lost = replace(quantity, stage=stage)
                entry = replace(entry, claim=replace(entry.claim, left=lost, right=other))
    meant = meant_by(entry)
    if not is_quantity(meant, "energy", "energy_lost"):
        return False
    if meant.arguments or len(world.start) < 2 or has_energies_of_both(entry, world):
        return False
    single = [_energy_of(Name(sphere), meant) for sphere in world.start]
    return any(
        holds_in(replace(entry, claim=replace(entry.claim, left=reduce(_plus, some))), world)
        for number in range(1, len(single))
        for some in combinations(single, number)
    )


def _energy_of(body: Name, energy: Quantity) -> Expression:
    """The energy of one body, or what it loses, of that of all."""
    after = Quantity("energy", (body,), energy.stage)
    if energy.kind == "energy" or not isinstance(energy.stage, int):
        return after
    return Binary("-", replace(after, stage=energy.stage - 1), after)


def _plus(one: Expression, other: Expression) -> Expression:
    return Binary("+", one, other)


def _is_share_of_line(entry: Entry, world: World) -> bool:
    """Whether energy lost is a share of that by the components along the line of centres alone."""
    for number, spheres in (*_pairs_of(world), *_walls_of(world)):
        lost, before = Quantity("energy_lost", (), number), Quantity("energy", (), number - 1)
        line = Quantity("line_of_centres", (), number)
        along: Expression | None = None
        for name in spheres:
            part = Quantity("along", (Quantity("velocity", (Name(name),), number - 1), line))
            term = Binary("*", Quantity("mass", (Name(name),)), Binary("^", part, _TWO))
            along = term if along is None else Binary("+", along, term)
        share = Binary("*", Binary("/", lost, before), Binary("/", along, _TWO))  # type: ignore[arg-type]
        for one, other in permutations((entry.claim.left, entry.claim.right)):
            claims = Claim(lost, "=", one), Claim(share, "=", other)
            if all(holds_in(replace(entry, claim=claim), world) for claim in claims):
                return True
    return False


def _is_without_mass(entry: Entry, world: World) -> bool:
    """Whether a mass is left out of a velocity after a blow, of an impulse, or of an energy.

    That is v = u + I, I = v - u, and ½(u² - v²) of bodies with one mass.
    """
    meant = meant_by(entry)
    match meant:
        case Quantity("velocity", (Name(),) as body, stage):
            number = len(world.events) if stage is None else stage
            if not isinstance(number, int) or number < 1:
                return False
            before = Quantity("velocity", body, number - 1)
            impulse = Quantity("impulse", body, number)
            return has_value(Binary("+", before, impulse), entry.claim.right, entry, world)
        case Quantity("impulse" | "energy" | "energy_lost", _, _):
            return any(
                has_value(meant, Binary("*", Quantity("mass", (Name(body),)), right), entry, world)
                and not has_value(
                    Quantity("mass", (Name(body),)), Number(Fraction(1)), entry, world
                )
                for body in _bodies_of(meant, world)
                for right in _of_either_sign(meant, entry.claim.right)
            )
    return False


def _of_either_sign(meant: Quantity, tree: Expression) -> tuple[Expression, ...]:
    """A tree, and as the size of an impulse also its negative."""
    size = meant.kind == "impulse" and not meant.arguments
    return (tree, Negate(tree)) if size else (tree,)


def _bodies_of(meant: Quantity, world: World) -> list[str]:
    """The bodies whose masses multiply a quantity: one, or both that an impulse acts on."""
    if meant.arguments:
        return [argument.name for argument in meant.arguments if isinstance(argument, Name)]
    if meant.kind == "impulse" or len(world.start) == 1:
        return list(world.start)
    return []


def _is_of_other_masses(entry: Entry, world: World) -> bool:
    """Whether the energies of two spheres have each the mass of the other."""
    meant = meant_by(entry)
    if not is_quantity(meant, "energy", "energy_lost"):
        return False
    number = len(world.events) if meant.stage is None else meant.stage
    if not isinstance(number, int):
        return False
    named = [argument.name for argument in meant.arguments if isinstance(argument, Name)]
    for _, pair in _pairs_of(world):
        bodies = named or list(pair)
        if not set(bodies) <= set(pair) or len(world.start) > 2:
            continue
        other = dict(zip(pair, reversed(pair), strict=True))
        stages = (number,) if meant.kind == "energy" else (number - 1, number)
        energies = [_energy_by_masses(bodies, other, stage) for stage in stages]
        value = energies[0] if len(energies) == 1 else Binary("-", energies[0], energies[1])
        if has_value(value, entry.claim.right, entry, world) and not has_value(
            value, meant, entry, world
        ):
            return True
    return False


def _energy_by_masses(bodies: Sequence[str], other: Mapping[str, str], stage: int) -> Expression:
    """The kinetic energy of some bodies, each with the mass of another one."""
    terms: list[Expression] = []
    for body in bodies:
        ratio = Binary("/", *(Quantity("mass", (Name(x),)) for x in (other[body], body)))
        terms.append(Binary("*", ratio, Quantity("energy", (Name(body),), stage)))
    return reduce(_plus, terms)


def _is_other_function(entry: Entry, world: World) -> bool:
    """Whether a sine is given the value of the cosine of its angle, or the other way round."""
    match entry.claim.left:
        case Apply("sin" | "cos" as name, Letter() as angle):
            other = Apply("cos" if name == "sin" else "sin", angle)
            return letters(entry.claim.right) == set() and has_value(
                other, entry.claim.right, entry, world
            )
    return False


def _is_relative_speed_across(entry: Entry, world: World) -> bool:
    """Whether a speed of approach or of separation is that across the line of centres."""
    left = entry.claim.left
    if not (isinstance(left, Letter) and is_phrase(left.name) and is_relative(left.name)):
        return False
    meant = meant_by(entry)
    meant = unsigned(meant)
    if not is_quantity(meant, "along"):
        return False
    across = Apply("abs", replace(meant, kind="across"))
    return has_value(across, Apply("abs", entry.claim.right), entry, world)


def is_law_of_speeds(entry: Entry, world: World) -> bool:
    """Whether the speed after a wall is e times that before it."""
    for number, step in enumerate(world.events, 1):
        if not has_coefficient(step) or not isinstance(step, Impact):
            continue
        if step.second not in world.walls or is_speed_by_energies(entry, world):
            continue
        before, after = (Quantity("speed", (Name(step.first),), n) for n in (number - 1, number))
        slowed = Binary("*", Quantity("restitution", (), number), before)
        for one, other in permutations((entry.claim.left, entry.claim.right)):
            worth = has_value(one, after, entry, world) and has_value(other, slowed, entry, world)
            if worth and not is_bare(one) and not is_bare(other):
                return True
    return False


def _is_without_across(entry: Entry, world: World) -> bool:
    """Whether a velocity after an impact of two spheres has nothing across their line."""
    match meant_by(entry):
        case Quantity("velocity", (Name(),), stage) as velocity:
            number = len(world.events) if stage is None else stage
        case _:
            return False
    if number not in world.lines:
        return False
    line = Quantity("line_of_centres", (), number)
    kept = Binary("*", Quantity("along", (velocity, line)), line)
    moved = Quantity("across", (velocity, line))
    return has_value(kept, entry.claim.right, entry, world) and not is_zero(moved, world)


def _is_angle_of_other_wall(entry: Entry, world: World) -> bool:
    """Whether an angle to a wall is taken from a wall that the sphere left before.

    It has the value of the angle after that wall, or of the one before it, alone or beside the
    angle of the walls.
    """
    match meant_by(entry):
        case Quantity("angle", (Quantity("velocity", (Name(body),)), Name(wall))):
            pass
        case _:
            return False
    struck = [
        (number, step.second)
        for number, step in enumerate(world.events, 1)
        if isinstance(step, Impact) and step.first == body
    ]
    second = next((number for number, other in struck if other == wall), 0)
    earlier = [impact for impact in struck if impact[0] < second and impact[1] != wall]
    return any(
        has_value(angle, entry.claim.right, entry, world)
        for number, other in earlier
        if other not in world.start
        for angle in _angles_of_wall(body, number, other, wall)
    )


def _angles_of_wall(body: str, number: int, left: str, wall: str) -> Iterator[Expression]:
    """The angles that one to a wall may be taken for, of a body that leaves another wall."""
    after, before = (
        Quantity("angle", (Quantity("velocity", (Name(body),), stage), Name(left)))
        for stage in (number, number - 1)
    )
    yield from (after, before)
    between = Quantity("angle", (Name(left), Name(wall)))
    yield Binary("-", between, before)
    yield Binary("-", Binary("-", STRAIGHT_ANGLE, between), before)


def _is_share_by_speeds(entry: Entry, world: World) -> bool:
    """Whether the share of an energy is that of the speed: lost = 1 - v/u."""
    meant = meant_by(entry)
    if len(world.start) != 1:
        return False
    (body,) = world.start
    match meant:
        case Binary("/", Quantity(kind, _, late), Quantity("energy", _, early)):
            if kind not in ENERGIES:
                return False
            ratio: Expression = Binary(
                "/", Quantity("speed", (Name(body),), late), Quantity("speed", (Name(body),), early)
            )
            share = ratio if kind == "energy" else Binary("-", Number(Fraction(1)), ratio)
            percent = Binary("*", share, Number(Fraction(100)))
            return any(
                has_value(tree, entry.claim.right, entry, world) for tree in (share, percent)
            )
    return False


def is_direct(number: int, world: World) -> bool:
    """Whether no sphere moves across the line of centres before an impact."""
    line = world.lines.get(number)
    step = world.events[number - 1] if number <= len(world.events) else None
    if line is None or not isinstance(step, Impact):
        return False
    motion = Telling(world, degrees=False)
    spheres = [sphere for sphere in (step.first, step.second) if sphere in world.start]
    across = (world.spread(motion.velocity(sphere, number - 1).cross(line)) for sphere in spheres)
    return all(bool(np.all(np.abs(component) < _TINY)) for component in across)


def is_zero(tree: Expression, world: World) -> bool:
    """Whether a quantity is zero in every sample."""
    size = _spread_of(tree, world)
    return bool(np.all(size < _TINY))


def leaves_out_across(variant: VariantAt, entry: Entry, world: World) -> bool:
    """Whether components across are exchanged with one that is zero: it is left out.

    Of the body that has none before, a line tells that it has the other one's.
    """
    number = variant.event.number
    line = Quantity("line_of_centres", (), number)
    without = {
        body
        for body in variant.event.bodies
        if is_zero(
            Quantity("across", (Quantity("velocity", (Name(body),), number - 1), line)), world
        )
    }
    meant = {node.name for node in walk(meant_by(entry)) if isinstance(node, Name)}
    return variant.mistake == "across-exchanged" and bool(without) and not without & meant


def has_coefficient(event: object) -> bool:
    """Whether an event has a coefficient of restitution that the question tells."""
    return isinstance(event, Impact) and event.e is not None


def sign_of_a_component(
    entry: Entry, world: World, mended: Sequence[Correction], near: Sequence[Use]
) -> str | None:
    """The mistake in a sign of a law where the term is a component that points the other way."""
    use = near[0] if near else None
    if use is None or use.event is None or use.principle not in _SIGNED:
        return None
    turned = [
        correction.part
        for correction in mended
        if correction.change == "sign"
        and correction.part not in (entry.claim.left, entry.claim.right)
    ]
    step = world.events[use.event - 1]
    if not isinstance(step, Impact) or step.second in world.walls:
        return None
    line = Quantity("line_of_centres", (), use.event)
    for stage in (use.event - 1, use.event):
        along = [
            Quantity("along", (Quantity("velocity", (Name(sphere),), stage), line))
            for sphere in (step.first, step.second)
        ]
        if not not_negative(Negate(Binary("*", *along)), world):
            continue  # they move the same way
        for body, component in zip((step.first, step.second), along, strict=True):
            term: Expression = component
            if use.principle == "momentum":
                term = Binary("*", Quantity("mass", (Name(body),)), component)
            sizes = (_spread_of(term, world),)
            if any(is_worth(part, entry, world, sizes) for part in turned):
                return f"{use.principle}-sign"
    return None


def _spread_of(tree: Expression, world: World) -> Array:
    """The size of a quantity in every sample; not a number where it has no value."""
    try:
        return np.abs(world.spread(world.scalar(tree)))
    except RestitutionError:
        return np.full(1, np.nan)


def _is_ratio_of_relative_speeds(entry: Entry, world: World) -> bool:
    """Whether a coefficient of restitution is that of the sizes of the relative velocities."""
    if not is_coefficient(entry):
        return False
    for number, step in enumerate(world.events, 1):
        if not isinstance(step, Impact) or step.second in world.walls:
            continue
        after, before = (
            Apply("abs", Binary("-", *(Quantity("velocity", (Name(x),), stage) for x in pair)))
            for pair in ((step.first, step.second),)
            for stage in (number, number - 1)
        )
        claims = [replace(entry.claim, left=Binary("/", after, before))]
        if not is_direct(number, world):
            claims += _ratios_of_speeds(entry.claim, step, number)
        if any(holds_in(replace(entry, claim=claim), world) for claim in claims):
            return True
    return False


def _ratios_of_speeds(claim: Claim, step: Impact, number: int) -> Iterator[Claim]:
    """A claim with the sums and differences of whole speeds in place of its left side."""
    bodies = (step.first, step.second)
    speeds = [[Quantity("speed", (Name(x),), n) for x in bodies] for n in (number, number - 1)]
    after, before = ((Binary("+", *pair), Binary("-", *pair)) for pair in speeds)
    for above, below in product(after, before):
        yield replace(claim, left=Binary("/", Apply("abs", above), Apply("abs", below)))


def is_energetic(entry: Entry) -> bool:
    """Whether a claim speaks of energies, or of squares of speeds."""
    return is_of_energy(entry) or any(
        is_binary(node, "^") and not isinstance(node.left, Apply)
        for side in (entry.claim.left, entry.claim.right)
        for node in walk(side)
    )


def _is_of_squares(entry: Entry) -> bool:
    """Whether a claim is of squares, or its left side an energy, a speed, or its square."""
    left = entry.claim.left
    if all(map(has_square, (left, entry.claim.right))):
        return True
    left = left.left if is_binary(left, "^") else left
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    return isinstance(meant, Quantity) and (meant.kind == "speed" or "energy" in meant.kind)


def is_of_energy(entry: Entry) -> bool:
    """Whether a letter or a phrase of a claim means an energy, or a ratio of energies."""
    for side in (entry.claim.left, entry.claim.right):
        for node in walk(side):
            meant = entry.meanings.get(node.name, node) if isinstance(node, Letter) else node
            if any(isinstance(part, Quantity) and "energy" in part.kind for part in walk(meant)):
                return True
    return False


def is_sought_angle(entry: Entry, world: World) -> bool:
    """Whether a claim gives an angle that the part has to find, by itself: ``tan α = 1/3``."""
    left = entry.claim.left
    angle = left.argument if isinstance(left, Apply) else left
    own = isinstance(angle, Letter) and angle.name in world.angles & world.determined
    return own and not letters(entry.claim.right)


def is_coefficient(entry: Entry) -> bool:
    """Whether a claim gives a coefficient of restitution a number: e = 3/4."""
    left = entry.claim.left
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    named = isinstance(left, Letter) and left.name == "e" and meant == left
    named = named or is_quantity(meant, "restitution")
    numbers = {Letter, Quantity}.isdisjoint(map(type, walk(entry.claim.right)))
    trigonometric = any(
        isinstance(x, Apply) and x.function != "sqrt" for x in walk(entry.claim.right)
    )
    return named and numbers and not trigonometric


def not_negative(tree: Expression, world: World) -> bool:
    """Whether a quantity is negative in no sample."""
    try:
        return bool(np.all(world.scalar(tree) >= -1e-9))
    except RestitutionError:
        return False


# What a line shows by itself, the first that fits; a name may have several signs.
_SHOWN: tuple[tuple[Callable[[Entry, World], bool], str], ...] = (
    (_is_other_component, "sine-cosine"),
    (is_speed_by_energies, "energy-ratio-as-speed"),
    (_is_share_by_speeds, "energy-ratio-as-speed"),
    (_is_ratio_of_relative_speeds, "restitution-whole-speed"),
    (_is_without_half, "energy-no-half"),
    (is_energy_of_difference, "energy-of-difference"),
    (_is_energy_of_one, "energy-one-sphere"),
    (_is_share_of_line, "energy-fraction-of-line"),
    (_is_of_line_energies, "energy-component-missing"),
    (_is_without_mass, "mass-omitted"),
    (_is_of_other_masses, "masses-exchanged"),
    (_is_other_function, "sine-cosine"),
    (_is_relative_speed_across, "restitution-parallel"),
    (_is_without_across, "across-changed"),
    (is_fraction_of_line, "energy-fraction-of-line"),
    (is_tangent_inverted, "restitution-inverted"),
    (is_of_exchanged_squares, "restitution-parallel"),
    (is_root_without_squares, "square-not-taken"),
    (is_energy_of_one_component, "energy-component-missing"),
    (is_without_a_square, "square-not-taken"),
    (is_impulse_reversed, "impulse-sign"),
    (is_impulse_of_speeds, "impulse-of-speeds"),
    (is_impulse_of_other_mass, "masses-exchanged"),
    (is_impulse_of_unit_mass, "mass-omitted"),
    (is_velocity_without_mass, "mass-omitted"),
    (_is_angle_of_other_wall, "second-wall-angle"),
    (is_given_difference, "deflection-difference"),
    *SHOWN,
)
