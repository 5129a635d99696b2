"""The name of a mistake: which altered law a false line is an instance of, or which slip it is.

A misconception is named where random states single out one altered law, or, where numbers are put
in already, where the line holds in one altered world and no slip explains it as well. In doubt a
mistake has no name.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from restitution.explaining.facts import events_of
from restitution.explaining.misconceptions import MISCONCEPTIONS, ResultAt, VariantAt, variants_at
from restitution.expression.tree import Expression, Letter, Quantity
from restitution.practice.agreement import agrees
from restitution.practice.arrays import UnvaluedError
from restitution.practice.entries import Entry, is_numeric, same_relation
from restitution.practice.judgement import Mistake
from restitution.practice.lines import text_of
from restitution.practice.slips import Correction, corrections
from restitution.practice.world import World
from restitution.problem import Problem

if TYPE_CHECKING:
    from restitution.practice.verdicts import Judge

# A sign that is turned undoes these, and so is no slip beside them.
_OF_SIGNS = frozenset(
    {"momentum-sign", "restitution-sign", "impulse-sign", "deflection-difference"}
)
_OF_POWERS = frozenset({"square-not-taken", "energy-ratio-as-speed"})
_OF_FACTORS = frozenset({"mass-omitted", "restitution-omitted", "energy-no-half", "across-changed"})
NO_NAME = Mistake(None)


@dataclass(frozen=True)
class Explained:
    """An altered law that explains a line, and whether by random states, not by its numbers."""

    variant: VariantAt
    by_states: bool

    @property
    def mistake(self) -> str:
        return self.variant.mistake


class Names:
    """Names the mistakes in the lines of one problem."""

    def __init__(self, problem: Problem) -> None:
        events = events_of(problem)
        self.worlds: dict[Any, World | None] = {}
        self.variants = tuple(each for event in events for each in variants_at(event, events))

    def named(self, entry: Entry, judge: Judge) -> Mistake:
        """The mistake that begins in a claim that is false."""
        mended = tuple(_mending(entry, judge))
        at = text_of(mended[0].part) if mended else None
        explained = self._explaining(entry, judge, mended)
        families = tuple(dict.fromkeys(each.mistake for each in explained))
        if families:
            variants = tuple(dict.fromkeys(each.variant.id for each in explained))
            first, *also = families
            return Mistake(
                first if not also else None,
                "misconception",
                variants,
                tuple(families) if also else (),
                at,
                sure=not also,
            )
        slip = _slip(entry, judge, mended)
        return NO_NAME if slip is None else Mistake(slip, "slip", at=at)

    # --- misconceptions -----------------------------------------------------------------------

    def _explaining(
        self, entry: Entry, judge: Judge, mended: Sequence[Correction]
    ) -> list[Explained]:
        """The altered laws that explain a claim where no slip does."""
        if entry.claim.sign != "=" or entry.claim.others:
            return []
        by_states = list(self._instances(entry, judge))
        if by_states:
            return [each for each in by_states if _stands(each, mended)]
        if is_numeric(entry.claim.left) and is_numeric(entry.claim.right):
            return []
        results = list(self._results(entry, judge))
        worlds = [] if results else list(self._worlds(entry, judge))
        found = results or worlds
        return [each for each in found if _stands(each, mended)]

    def _instances(self, entry: Entry, judge: Judge) -> Iterator[Explained]:
        """By random states: the altered laws of which the claim is an instance."""
        ids = {use.altered for use in judge.uses_of_entry(entry) if use.altered is not None}
        for variant in self.variants:
            if variant.id in ids and _plausible(variant, judge.base):
                yield Explained(variant, True)

    def _results(self, entry: Entry, judge: Judge) -> Iterator[Explained]:
        """By a result: the claim gives a quantity the value that an altered definition gives it."""
        for variant in self.variants:
            for result in variant.results:
                for world in (judge.base, *judge.students()):
                    if _is_result(entry, result, world):
                        yield Explained(variant, False)

    def _worlds(self, entry: Entry, judge: Judge) -> Iterator[Explained]:
        """By altered worlds: the claim holds where one law is altered, and all else is right."""
        stated = judge.stated()
        for variant in self.variants:
            if not variant.laws or not variant.alteration.solvable:
                continue
            if any((law.law, variant.event.number) in stated for law in variant.laws):
                continue
            if not _plausible(variant, judge.base):
                continue
            world = judge.altered(variant)
            if world is not None and _holds(entry, world):
                yield Explained(variant, False)


def _stands(each: Explained, mended: Sequence[Correction]) -> bool:
    """Whether no slip explains a line as well as an altered law does."""
    undone = {"sign"} if each.mistake in _OF_SIGNS else set()
    if each.mistake in _OF_POWERS:
        undone |= {"power"}
    if each.mistake in _OF_FACTORS:
        undone |= {"factor"}
    if each.by_states:
        undone |= {"figure", "factor", "turned"}
    return all(correction.change in undone for correction in mended)


def _plausible(variant: VariantAt, world: World) -> bool:
    """Whether the signs that a variant puts in by hand are those of the components."""
    return all(_not_negative(sense, world) for sense in variant.senses)


def _not_negative(tree: Expression, world: World) -> bool:
    try:
        return bool(np.all(world.scalar(tree) >= -1e-9))
    except UnvaluedError:
        return False


def _holds(entry: Entry, world: World) -> bool:
    """Whether a claim holds in a world, exactly or to three figures."""
    try:
        grade = agrees(entry.claim, world, entry.meanings, entry.decimals, entry.scope)
    except UnvaluedError:
        return False
    return grade in ("exact", "rounded")


def _is_result(entry: Entry, result: ResultAt, world: World) -> bool:
    """Whether a claim gives a quantity the value that an altered definition gives it."""
    if not _is_quantity(entry, result.quantity, world) or not _gives(entry, result.value, world):
        return False
    return result.sense is None or _not_negative(result.sense, world)


def _is_quantity(entry: Entry, quantity: Expression, world: World) -> bool:
    """Whether the left side of a claim names a quantity."""
    left = entry.claim.left
    if not isinstance(left, Letter | Quantity):
        return False
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    return (
        isinstance(meant, Quantity)
        and isinstance(quantity, Quantity)
        and (meant.kind == quantity.kind)
        and _same_value(meant, quantity, entry, world)
    )


def _same_value(one: Expression, other: Expression, entry: Entry, world: World) -> bool:
    try:
        a = world.scalar(one, entry.meanings, scope=entry.scope)
        b = world.scalar(other, entry.meanings, scope=entry.scope)
    except UnvaluedError:
        return False
    return bool(np.allclose(a, b, rtol=1e-9, atol=1e-12))


def _gives(entry: Entry, value: Expression, world: World) -> bool:
    """Whether the right side of a claim has the value of a tree."""
    claim = type(entry.claim)(value, "=", entry.claim.right)
    return _holds(Entry(entry.number, claim, entry.meanings, entry.scope, entry.decimals), world)


# --- slips ------------------------------------------------------------------------------------


def _mending(entry: Entry, judge: Judge) -> Iterator[Correction]:
    """The corrections at one place with which a claim is true, or follows."""
    if entry.claim.others:
        return
    worlds = (judge.base, *judge.students())
    for correction in corrections(entry.claim):
        mended = Entry(entry.number, correction.claim, entry.meanings, entry.scope, entry.decimals)
        if any(_holds(mended, world) for world in worlds):
            yield correction


def _slip(entry: Entry, judge: Judge, mended: Sequence[Correction]) -> str | None:
    """The slip that a false claim is, where only one kind of slip explains it."""
    changes = {each.change for each in mended}
    claim = entry.claim
    if claim.sign != "=":
        return None
    if "radians" in changes:
        return "calculator"
    if any(_stands_above(each, judge.entries) for each in mended):
        return "copied"
    if is_numeric(claim.left) and is_numeric(claim.right):
        return "sign" if changes == {"sign"} else "arithmetic"
    if "sign" in changes:
        return "sign"
    if changes & {"power", "turned"}:
        return "algebra"
    if changes and changes <= {"figure", "factor"}:
        return "arithmetic" if entry.is_value else "algebra"
    return None


def _stands_above(correction: Correction, entries: Iterable[Entry]) -> bool:
    """Whether the corrected claim is one of the lines above, or has a long side of one."""
    if correction.change not in ("sign", "figure", "letter"):
        return False
    return any(same_relation(correction.claim, entry.claim) for entry in entries)


def kinds_of(mistake: str) -> tuple[str, ...]:
    """The principles whose lines a misconception fits."""
    return MISCONCEPTIONS[mistake].kinds
