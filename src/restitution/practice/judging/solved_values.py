"""Values that true lines above decide: what is wrong is how they are solved, and no law."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.tree import (
    Binary,
    Letter,
    Quantity,
    is_binary,
    is_vector,
    letters,
    quantities_in,
    rational,
    terms_of,
)
from restitution.practice.judging.claimed import meant_by
from restitution.practice.judging.deduction import deduced_from
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.explained import JudgedSoFar
from restitution.practice.reading.relations import worked_out
from restitution.practice.worlds.world import World
from restitution.problem import Value

_MOST = 10**8
_SAME = 1e-9
_OF_MOTION = frozenset({"velocity", "speed"})


def is_decided(entry: Entry, judge: JudgedSoFar) -> bool:
    """Whether true lines above decide a value that a claim gives wrongly: ``2e = 1/2, e = 1``."""
    world = judge.base
    claim = entry.claim
    if claim.sign != "=" or claim.others or not isinstance(claim.left, Letter | Quantity):
        return False
    if is_vector(claim.right) or not letters(claim.right) <= world.letters.keys():
        return False
    factor = _factor(entry, world)
    if factor is None:
        return False
    right = Binary("*", rational(factor), claim.right)
    true = [other for other in judge.entries if other.right and not other.is_value]
    known = [other for other in judge.entries if other.right and other.is_value]
    mended = replace(entry, claim=replace(claim, right=right), right=True, wrong=False)
    data = judge.question.given
    return bool(true) and bool(deduced_from(mended, [*known, *true], world, data))


def goes_on_from_true_line(entry: Entry, judge: JudgedSoFar) -> bool:
    """Whether a claim has a side of the true equation above it, a quotient cleared or not.

    Below ``(3 - 3k)/(1 + k) = -1`` a wrong ``3 - 3k = -1 + k`` is a slip in algebra.
    """
    above = judge.entries[-1] if judge.entries else None
    if above is None or not above.right:
        return False
    if {entry.claim.sign, above.claim.sign} != {"="}:
        return False
    if is_solved_from(entry, above, judge.base):
        return True
    if above.number == entry.number:
        return False
    sides = [above.claim.left, above.claim.right]
    sides += [side.left for side in sides if is_binary(side, "/")]
    unknown = judge.base.determined | entry.meanings.keys()
    # A single product, such as u cos α, stands in more than one law.
    long = [side for side in sides if is_binary(side, "+", "-") and letters(side) & unknown]
    return any(side in long for side in (entry.claim.left, entry.claim.right))


def is_solved_from(entry: Entry, above: Entry, world: World) -> bool:
    """Whether a claim solves a true equation for its only unknown: ``1 - 2e = 0, e = 2``.

    On the way there it has a number of the equation as a term: ``12 - 6 = 3k`` below
    ``12 - 2k = -6 + k``.
    """
    claim, unknown = entry.claim, world.determined | entry.meanings.keys()
    sides, sides_above = ((x.left, x.right) for x in (claim, above.claim))
    own, other = (
        {name for side in both for name in letters(side)} & unknown for both in (sides, sides_above)
    )
    if len(own) != 1 or own != other or above.is_value or claim.left == above.claim.right:
        return False
    if isinstance(claim.left, Letter) and not letters(claim.right):
        return True
    numbers, known = (
        {abs(x) for side in both for term in terms_of(side) if (x := worked_out(term))}
        for both in (sides, sides_above)
    )
    return not (numbers & known).issubset({1})


def _factor(entry: Entry, world: World) -> Fraction | None:
    """What the value that is given has to be multiplied by, where it is one number."""
    try:
        sides = (entry.claim.left, entry.claim.right)
        true, given = (
            world.spread(world.scalar(side, entry.meanings, scope=entry.scope)) for side in sides
        )
    except RestitutionError:
        return None
    if not np.all(np.abs(given)):
        return None
    ratio = true / given
    if not np.all(np.isfinite(ratio)):
        return None  # the root of a negative number has no value
    near = Fraction(float(ratio.flat[0])).limit_denominator(_MOST)
    same = np.all(np.abs(ratio - float(near)) <= _SAME * np.abs(ratio))
    return near if near and same else None


def is_over(number: int, world: World) -> bool:
    """Whether an earlier part asks for the velocity after an event, and this part for later ones.

    Who goes on from there has had that velocity, right or wrong.
    """
    problem, part = world.problem, world.part
    if part not in problem.parts:
        return False
    above = problem.parts[: problem.parts.index(part)]
    done = [
        now
        for earlier in above
        for item, now in problem.asked(earlier)
        if isinstance(item, Value)
        and any(node.kind in _OF_MOTION for node in quantities_in(item.expression))
    ]
    own = [now for _, now in problem.asked(part)]
    return bool(done and own) and number <= max(done) < max(own)


def of_this_part(variants: Sequence[VariantAt], world: World) -> tuple[VariantAt, ...]:
    """Altered laws without those of events that are over.

    Who works something out in a later part has had what an earlier one asks for.
    """
    return tuple(x for x in variants if not (x.laws and is_over(x.event.number, world)))


def has_kept_across(number: int, judge: JudgedSoFar) -> bool:
    """Whether a true line above has the component that stays at an impact."""
    return any(
        (use.principle, use.event, use.altered) == ("unchanged", number, None)
        for other in judge.entries
        if other.right
        for use in judge.uses_of_entry(other)
    )


def is_along_alone(entry: Entry) -> bool:
    """Whether a claim gives a speed or a distance, and no vector.

    With no component across it may have left that out, or taken the other one for the speed.
    """
    meant = meant_by(entry)
    return isinstance(meant, Quantity) and meant.kind in ("speed", "distance")
