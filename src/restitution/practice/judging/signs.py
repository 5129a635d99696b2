"""Signs in values: where one of them is wrong, and no law is written with another sign."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    has_unit_vector,
    is_quantity,
    letters,
    walk,
)
from restitution.practice.judging.claimed import holds_in
from restitution.practice.judging.entries import Entry, is_monomial, is_numeric
from restitution.practice.judging.plain_mistakes import is_zero
from restitution.practice.judging.slips import Correction
from restitution.practice.judging.squares import is_worth
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World
from restitution.problem import Impact

OF_SIGNS = frozenset({"momentum-sign", "restitution-sign"})
# Two values of which one is rounded to two figures agree so far.
_NEAR = Fraction(1, 100)


def plainer_signs(
    variants: Sequence[VariantAt], entry: Entry, world: World
) -> tuple[VariantAt, ...]:
    """Altered laws without others where one has a sign, which is plainer.

    The speed of a body that moves along the line of centres is its component, with that sign; and
    of masses nothing is seen where a sum of momenta is worked out.
    """
    if not any(variant.mistake in OF_SIGNS for variant in variants):
        return tuple(variants)
    summed = any(is_monomial(side) for side in (entry.claim.left, entry.claim.right))
    return tuple(
        variant
        for variant in variants
        if not (variant.mistake == "speed-for-component" and _is_of_speeds_along(variant, world))
        and not (variant.mistake == "masses-exchanged" and summed)
    )


def _is_of_speeds_along(variant: VariantAt, world: World) -> bool:
    """Whether all bodies of which a law has speeds move along the line of centres."""
    line = Quantity("line_of_centres", (), variant.event.number)
    speeds = [
        node
        for law in variant.laws
        for side in law.sides
        for node in walk(side)
        if is_quantity(node, "speed")
    ]
    across = (
        Quantity("across", (Quantity("velocity", speed.arguments, speed.stage), line))
        for speed in speeds
    )
    return bool(speeds) and all(is_zero(component, world) for component in across)


def is_slip_of_sign(entry: Entry, mended: Sequence[Correction], world: World) -> bool:
    """Whether a value is right but for a sign in it, and that is not of a term of a law.

    In ``v = u(1 + 2e)/3`` no term is what a body has before an impact, as it is in
    ``v = (6 - 3×2)/5``, or in a momentum.
    """
    left, right = entry.claim.left, entry.claim.right
    if not isinstance(left, Letter | Quantity) or not letters(right) <= world.letters.keys():
        return False
    turned = [correction.part for correction in mended if correction.change == "sign"]
    if not turned:
        return False
    sizes = tuple(_terms(world))
    return not any(is_worth(part, entry, world, sizes) for part in turned if part != right)


def is_inverse_of_the_opposite(entry: Entry, entries: Sequence[Entry]) -> bool:
    """Whether an angle is taken of a ratio of which a line above has the opposite.

    In ``δ = tan⁻¹(18)`` below ``tan δ = −18`` a sign is left out.
    """
    match entry.claim.right:
        case Apply("arcsin" | "arccos" | "arctan" as inverse, ratio) if is_numeric(ratio):
            own = in_letters(ratio)
        case _:
            return False
    for above in entries:
        match above.claim.left:
            case Apply(function) if function == inverse.removeprefix("arc") and not above.wrong:
                if is_numeric(above.claim.right):
                    other = in_letters(above.claim.right)
                    if own and abs(own + other) < _NEAR * abs(own):
                        return True
    return False


def is_turned_as_a_whole(entry: Entry, mended: Sequence[Correction]) -> bool:
    """Whether a vector that is one whole side of a claim has the wrong sense."""
    sides = entry.claim.left, entry.claim.right
    return any(map(has_unit_vector, sides)) and any(
        correction.change == "sign"
        and any(correction.part is side or correction.part == side for side in sides)
        for correction in mended
    )


def is_opposite_impulse(entry: Entry, world: World) -> bool:
    """Whether an impulse of a given size is equal to the opposite of the change of momentum.

    In ``12 = 3(v - 5)`` for a sphere that is slowed down the terms are subtracted as they should
    be: what is wrong is the sense of the impulse alone.
    """
    left, right = entry.claim.left, entry.claim.right
    sized = any(is_numeric(side) and is_monomial(side) for side in (left, right))
    opposite = replace(entry, claim=Claim(left, "=", Negate(right)))
    return sized and entry.claim.sign == "=" and holds_in(opposite, world)


def _terms(world: World) -> Iterator[Array]:
    """The sizes of the terms of laws at each impact, of what there is before it."""
    for number, step in enumerate(world.events, 1):
        if not isinstance(step, Impact):
            continue
        line = Quantity("line_of_centres", (), number)
        bodies = [body for body in (step.first, step.second) if body in world.start]
        along: list[Expression] = [
            Quantity("along", (Quantity("velocity", (Name(body),), number - 1), line))
            for body in bodies
        ]
        masses = [Quantity("mass", (Name(body),)) for body in bodies]
        trees: list[Expression] = [
            *along,
            *(Binary("*", mass, part) for mass, part in product(masses, along)),
        ]
        coefficient = Quantity("restitution", (), number)
        whole = Binary("-", along[0], along[1]) if len(along) == 2 else along[0]
        trees += [Binary("*", coefficient, part) for part in (*along, whole)]
        trees += [Binary("*", Binary("*", mass, coefficient), whole) for mass in masses]
        for tree in trees:
            try:
                yield np.abs(world.spread(world.scalar(Apply("abs", tree))))
            except RestitutionError:
                continue
