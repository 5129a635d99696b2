"""A relation of a line with its verdict, and what a part asks, as a judge knows them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace

from restitution.expression.tree import (
    Expression,
)
from restitution.practice.judgement import Accuracy, Verdict
from restitution.practice.judging.bounds import Bounds
from restitution.practice.judging.support import Wanted
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.world import World
from restitution.records import dataclass

COARSE = "coarse"
OTHER_ROOT = "other-root"
REPEATED = "repeated"
"""The remark on a line that has the mistake of an earlier one once more."""
GRADES: tuple[Accuracy, ...] = ("coarse", "rounded", "exact")


@dataclass(frozen=True)
class Question:
    """What a part prints and asks, the letters that it has to find, and those that it gives.

    ``bounds`` are what it says of sizes; ``extreme`` tells that it asks for a greatest or least
    value, and ``at_extremes`` are the worlds in which it is reached.
    """

    wanted: Wanted
    unknown: frozenset[str] = frozenset()
    given: frozenset[str] = frozenset()
    bounds: Bounds = field(default_factory=Bounds)
    extreme: bool = False
    at_extremes: tuple[World, ...] = ()


@dataclass(frozen=True)
class JudgedLink:
    """A link with its verdict: the reading that decided, and what is said of it.

    ``grounded`` tells whether what is true follows from true lines and laws that are not broken,
    ``his_own`` that it follows from the student's own wrong values as well.
    ``right`` is a claim that follows, as it would be without the wrong numbers above it.
    """

    verdict: Verdict
    claim: Claim
    accuracy: Accuracy | None = None
    sources: tuple[int, ...] = ()
    remark: str | None = None
    letters: frozenset[str] = frozenset()
    right: Claim | None = None
    meant: tuple[tuple[str, Expression], ...] = ()
    grounded: bool = True
    his_own: bool = False


def as_decided(line: ScriptLine, judged: Sequence[JudgedLink]) -> ScriptLine:
    """A line in which the reading that decided stands before the other readings of its link."""

    def decided(link: Link, claim: Claim) -> Link:
        if claim not in link.readings[1:]:
            return link
        others = (reading for reading in link.readings if reading != claim)
        return replace(link, readings=(claim, *others))

    links = (decided(link, own.claim) for link, own in zip(line.links, judged, strict=True))
    return replace(line, links=tuple(links))


def goes_on(before: JudgedLink, link: JudgedLink) -> bool:
    """Whether a link goes on from a true one as a chain."""
    return before.verdict == "true" and before.claim.right == link.claim.left
