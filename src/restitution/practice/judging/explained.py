"""What explains a false line, and what is known of its script when that is asked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

from restitution.explaining.mistakes.misconceptions import (
    VariantAt,
)
from restitution.practice.judgement import Mistake, Use
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.judged_link import Question
from restitution.practice.script import Claim
from restitution.practice.worlds.world import World
from restitution.records import dataclass

Stated = frozenset[tuple[str, int | None, tuple[str, ...]]]


@dataclass(frozen=True)
class Explained:
    """The altered laws that explain a false claim, and the slip that it may be instead.

    ``at`` is the text that would have to be another, where no other would do, ``near`` the laws
    of the claim corrected, and ``mended`` the claim itself with what it uses. ``plain`` is a
    misconception in a line that states no law. ``direct`` tells that nothing moves across the lines
    of centres, ``of_impulse`` that the claim gives an impulse, ``along`` that it gives a speed or a
    distance by components along the line alone, ``over`` that what it goes on from is asked for in
    an earlier part, ``by_sines`` that it sets the component into a wall equal to that before by
    sines, ``shadowed`` the altered laws that others are plainer than.
    """

    variants: tuple[VariantAt, ...] = ()
    slip: str | None = None
    at: str | None = None
    near: tuple[Use, ...] = ()
    mended: tuple[Claim, tuple[Use, ...]] | None = None
    plain: str | None = None
    direct: bool = False
    of_impulse: bool = False
    along: bool = False
    over: bool = False
    by_sines: bool = False
    shadowed: frozenset[str] = frozenset()

    @property
    def is_empty(self) -> bool:
        """Whether neither a misconception nor a slip explains the claim."""
        return not (self.variants or self.plain or self.slip)

    def is_by_itself(self, mistake: Mistake) -> bool:
        """Whether a mistake has its name from the claim, and not from an altered law."""
        return not mistake.variants or (self.by_sines and mistake.id == "sine-cosine")

    def without(self, mistake: str) -> Explained:
        """What explains the claim but one misconception."""
        variants = tuple(variant for variant in self.variants if variant.mistake != mistake)
        return replace(self, variants=variants, plain=None if self.plain == mistake else self.plain)

    def shared_with(self, other: Explained) -> Explained:
        """What explains this claim and another of its line, if anything explains both."""
        ids = {variant.id for variant in other.variants}
        both = tuple(variant for variant in self.variants if variant.id in ids)
        return replace(self, variants=both or self.variants)


class JudgedSoFar(Protocol):
    """What is known of a script by the lines that are judged."""

    entries: list[Entry]

    question: Question

    @property
    def base(self) -> World:
        """The solution in which most lines are true."""

    def students(self) -> Sequence[World]:
        """The worlds in which the lines so far hold, as far as they can hold together."""

    def altered(self, variant: VariantAt) -> World | None:
        """The world of an altered law, all else being right."""

    def suspected(self) -> frozenset[str]:
        """The ids of the altered laws of which false lines above are instances."""

    def stated(self) -> Stated:
        """The laws that a line above states rightly, each with its event and its bodies."""

    def uses_of_entry(self, entry: Entry) -> tuple[Use, ...]:
        """The laws that a line uses."""


def signs_alone(whole: Explained, first: Explained) -> Explained:
    """What explains the value of a chain, where a sign mends the expression before it.

    Then of all laws that would give the value those alone are meant that have a sign altered. A
    sign in a sum of energies is no mistake with a name.
    """
    laws = {use.principle for use in first.near} if first.slip == "sign" else set[str]()
    if laws == {"energy"}:
        return first
    signs = tuple(x for x in whole.variants if x.mistake in {f"{law}-sign" for law in laws})
    return replace(whole, variants=signs) if signs else whole
