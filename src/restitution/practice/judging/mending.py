"""Slips in a claim by itself: the corrections that mend it, and which one kind of slip it is."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_operator,
    has_unit_vector,
    is_binary,
    is_quantity,
    walk,
)
from restitution.practice.judgement import Use
from restitution.practice.judging.claimed import holds_in
from restitution.practice.judging.entries import (
    Entry,
    is_numeric,
    is_of_a_journey,
    same_relation,
)
from restitution.practice.judging.explained import JudgedSoFar
from restitution.practice.judging.plain_energies import is_turned_loss
from restitution.practice.judging.slips import Correction, corrections
from restitution.practice.reading.phrase_names import is_phrase, is_vague
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import difference, numbers_of
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_LOST = ("power", "square", "factor")
_CLOSE, _TINY = 0.03, 1e-6


def mending(entry: Entry, judge: JudgedSoFar) -> Iterator[Correction]:
    """The corrections at one place with which a claim is true, or follows."""
    if entry.claim.others:
        return
    worlds = (judge.base, *judge.students())
    journey = is_of_a_journey(entry)
    data = numbers_of(judge.base.problem) if journey else ()
    for correction in corrections(entry.claim):
        if correction.claim.left == correction.claim.right:
            continue  # w = w corrects nothing
        if journey and (correction.change in _LOST or _is_datum(correction.part, data)):
            continue  # the whole time for that since an impact: nothing is miswritten
        if correction.change == "power" and _is_value_alone(correction.part, entry, judge):
            continue  # where no square was, none is forgotten
        mended = Entry(entry.number, correction.claim, entry.meanings, entry.scope, entry.decimals)
        if any(_is_near(mended, world) and holds_in(mended, world) for world in worlds):
            yield correction


def _is_value_alone(part: Expression, entry: Entry, judge: JudgedSoFar) -> bool:
    """Whether a claim gives the part a number, and no line above has its square."""
    claim = entry.claim
    if part != claim.left or not isinstance(claim.right, Number):
        return False
    square = Binary("^", part, Number(Fraction(2)))
    return not any(
        square in walk(side) for x in judge.entries for side in (x.claim.left, x.claim.right)
    )


def _is_datum(part: Expression, data: Collection[Fraction]) -> bool:
    return isinstance(part, Number) and part.value in data


def _is_datum_without_point(correction: Correction, data: Collection[Fraction]) -> bool:
    """Whether the decimal point of a datum has moved by a place: ``3`` for a mass of 0.3."""
    part, put = correction.part, correction.put
    if not (isinstance(part, Number) and isinstance(put, Number)) or part.value in data:
        return False
    return put.value in data and part.value in (10 * put.value, put.value / 10)


def worked_out(
    entry: Entry, judge: JudgedSoFar, mended: Iterable[Correction]
) -> tuple[Claim, tuple[Use, ...]] | None:
    """A vector that is worked out wrongly, as it would be right, and what the claim then uses.

    A coordinate is decided by what stands on the other side, as no number of an equation is.
    """
    claim = entry.claim
    if not (has_unit_vector(claim.right) and has_operator(claim.left, "+", "-")):
        return None
    for correction in mended:
        if correction.change == "figure" and correction.claim.left == claim.left:
            right = replace(entry, claim=correction.claim, wrong=False, right=True)
            return correction.claim, judge.uses_of_entry(right)
    return None


def _is_near(entry: Entry, world: World) -> bool:
    """Whether the sides of a claim differ by so little that rounding may be all of it."""
    try:
        apart, size = difference(entry.claim, world, entry.meanings, entry.scope)
    except RestitutionError:
        return False
    return entry.claim.sign != "=" or bool(np.all(np.abs(apart) <= _CLOSE * size + _TINY))


def kind_of_slip(entry: Entry, judge: JudgedSoFar, mended: Sequence[Correction]) -> str | None:
    """The slip that a false claim is, where only one kind of slip explains it."""
    changes = {correction.change for correction in mended} - {"square"}
    claim = entry.claim
    if claim.sign != "=":
        return None
    if "radians" in changes:
        return "calculator"
    if is_turned_loss(entry, judge.base):
        return "sign"
    if any(_stands_above(correction, judge.entries) for correction in mended):
        return "copied"
    if any(_is_datum_without_point(x, numbers_of(judge.base.problem)) for x in mended):
        return "copied"
    if is_numeric(claim.left) and is_numeric(claim.right):
        return "sign" if changes == {"sign"} else "arithmetic"
    if "sign" in changes:
        return "sign"
    if changes & {"power", "turned"}:
        return "algebra"
    if changes and changes <= {"figure", "factor"}:
        if _is_of_geometry(entry, judge.base):
            return None
        if not entry.is_value:
            return "algebra"
        if _is_of_something(claim.left) and has_operator(claim.right, "+", "-"):
            return None  # of which size it is, or angle, is not said, nor which number is another
        return None if _is_formula_in_numbers(claim.right) else "arithmetic"
    return None


def _is_of_something(label: Expression) -> bool:
    """Whether a label says what kind of value it is, and not of what."""
    return isinstance(label, Letter) and is_phrase(label.name) and is_vague(label.name)


def _is_of_geometry(entry: Entry, world: World) -> bool:
    """Whether a claim gives the angle of a line of centres by an offset: ``sin θ = r/2r``."""
    left = entry.claim.left
    if not (isinstance(left, Apply) and isinstance(left.argument, Letter)):
        return False
    meant = entry.meanings.get(left.argument.name, left.argument)
    of_line = any(is_quantity(node, "line_of_centres") for node in walk(meant))
    offset = any(isinstance(step, Impact) and step.offset is not None for step in world.events)
    return offset and of_line


def _is_formula_in_numbers(tree: Expression) -> bool:
    """Whether a sum of numbers stands in a quotient, a product or a power: ``(4 - 3)/5``.

    That is a law with numbers put in, and one of them may be any other.
    """
    return any(
        is_binary(node, "/", "*", "^")
        and any(
            is_binary(part, "+", "-") for side in (node.left, node.right) for part in walk(side)
        )
        for node in walk(tree)
    )


def _stands_above(correction: Correction, entries: Iterable[Entry]) -> bool:
    """Whether the corrected claim is one of the lines above, or has a long side of one."""
    if correction.change not in ("sign", "figure", "letter"):
        return False
    return any(same_relation(correction.claim, entry.claim) for entry in entries)
