"""Newton's law with a number that is not the coefficient of its impact."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Number,
    Quantity,
    is_binary,
    letters,
    walk,
)
from restitution.practice.judgement import Use
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_EVEN = 1e-9
_SIMPLE = 1000
Corrected = tuple[Claim, tuple[Use, ...]]


def with_its_coefficient(
    entry: Entry, world: World, uses_of: Callable[[Entry], tuple[Use, ...]]
) -> Corrected | None:
    """A false claim with the coefficient of its impact, if it is Newton's law then.

    So it is with ``q - p = 1/3 × 4u`` where e is 1/2: a side is the approach times another number
    between 0 and 1, or that number alone. ``uses_of`` tells what a claim is an instance of.
    """
    claim = entry.claim
    if claim.sign != "=" or claim.others:
        return None
    for number, step in enumerate(world.events, 1):
        if not isinstance(step, Impact):
            continue
        coefficient = Quantity("restitution", (), number)
        for put in _corrections(entry, step, number, coefficient, world):
            mended = replace(entry, claim=put, wrong=False, right=True)
            uses = uses_of(mended)
            first = next(iter(uses), None)
            if first is None or first.altered or first.event != number:
                continue
            if first.principle == "restitution":
                return put, uses
    return None


def _corrections(
    entry: Entry, step: Impact, number: int, coefficient: Expression, world: World
) -> Iterator[Claim]:
    """The claim with its coefficient in place of the number that stands there, on either side."""
    approach = _approach(step, number, world)
    try:
        own = world.scalar(coefficient)
    except RestitutionError:
        return
    for place in ("left", "right"):
        side = getattr(entry.claim, place)
        if not letters(side) <= world.letters.keys():
            continue
        try:
            size = world.scalar(side, entry.meanings, scope=entry.scope)
        except RestitutionError:
            continue
        other = entry.claim.right if place == "left" else entry.claim.left
        if _has_value(side, own) or (is_numeric(other) and _has_value(other, own)):
            continue  # the coefficient is there: e(4 - 1) has a wrong sign, ½ × 5 = 3.5 a wrong sum
        for base in (approach, None) if is_numeric(side) else (approach,):
            factor = _factor(size, base, own)
            if factor is None or not _has_value(side, np.float64(factor.value)):
                continue  # q - p = 5 quotes no number for a coefficient
            put = Binary("*", side, Binary("/", coefficient, factor))
            left = place == "left"
            yield replace(entry.claim, left=put) if left else replace(entry.claim, right=put)


def _has_value(side: Expression, value: Array) -> bool:
    """Whether a number, or a fraction of two, in a side has a value."""
    tops = [node for node in walk(side) if isinstance(node, Number)]
    tops += [
        Number(node.left.value / node.right.value)
        for node in walk(side)
        if is_binary(node, "/")
        if isinstance(node.left, Number) and isinstance(node.right, Number) and node.right.value
    ]
    return any(np.allclose(float(top.value), value) for top in tops)


def _approach(step: Impact, number: int, world: World) -> Array:
    """The speed of approach of an impact."""
    line = Quantity("line_of_centres", (), number)
    speeds = [
        world.scalar(Quantity("along", (Quantity("velocity", (Name(name),), number - 1), line)))
        for name in (step.first, step.second)
        if name in world.start
    ]
    return np.abs(speeds[0] - (speeds[1] if len(speeds) > 1 else 0))


def _factor(size: Array, approach: Array | None, own: Array) -> Number | None:
    """The number between 0 and 1 that stands for a coefficient; None where it is that itself."""
    with np.errstate(all="ignore"):
        factor = np.abs(size) if approach is None else np.abs(size / approach)
    factor = np.atleast_1d(factor)
    if not np.all(np.isfinite(factor)) or np.ptp(factor) > _EVEN:
        return None
    value = float(factor.flat[0])
    if not 0 < value < 1 or np.allclose(value, own, rtol=_EVEN):
        return None
    return Number(Fraction(value).limit_denominator(_SIMPLE))
