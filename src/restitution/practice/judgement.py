"""The judgement of a line: its verdict, the law it uses, the mistake in it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import Literal

from restitution.expression.tree import Expression
from restitution.practice.script import ANYWHERE, Claim, Scope, ScriptLine
from restitution.records import dataclass

Verdict = Literal["true", "follows", "false", "asks", "unread", "remark", "unsupported"]
Accuracy = Literal["exact", "rounded", "coarse"]
By = Literal["statement", "declared", "default", "agreed", "inferred"]


@dataclass(frozen=True)
class Meaning:
    """What a letter, or a phrase, of a script means in a scope.

    ``quantity`` is one of the statement language and may carry a sign:
    ``-along(velocity(A), i)``. ``words`` say it as a student would. ``since`` is the number of the
    line from which it holds, until the same letter has another meaning.
    """

    letter: str
    quantity: Expression
    words: str
    by: By
    scope: Scope = ANYWHERE
    since: int = 0


@dataclass(frozen=True)
class Use:
    """A law of an impact, a fact or a definition that a line is an instance of.

    ``principle`` is ``momentum``, ``restitution``, ``unchanged``, ``impulse``, ``energy``,
    ``angle``, ``deflection``, ``speed``, ``fact``, ``solve``, ``arithmetic``, …; ``altered`` the id
    of the altered law (``momentum-sign/2``) where the line is an instance of that one instead.
    """

    principle: str
    event: int | None = None
    bodies: tuple[str, ...] = ()
    altered: str | None = None


@dataclass(frozen=True)
class Mistake:
    """A mistake that begins in a line.

    ``id`` is a misconception (``momentum-sign``), a slip (``sign``), or None where it has no name;
    ``variants`` the altered laws it could be, ``also`` other ids that explain it as well, ``at``
    the text at which it stands. ``leads_to`` are values that follow from it, by item or letter.
    """

    id: str | None
    kind: Literal["misconception", "slip", "accuracy"] | None = None
    variants: tuple[str, ...] = ()
    also: tuple[str, ...] = ()
    at: str | None = None
    sure: bool = True
    leads_to: Mapping[str, str] | None = None


@dataclass(frozen=True)
class JudgedLine:
    """A line with its verdict.

    ``uses`` are the laws that it states or cannot be had without, ``stated`` those of its several
    relations; ``link`` is the place (from 0) of
    the link that fails; ``sources`` are the numbers of the lines above from which it follows;
    ``read_as`` the reading that decided, in symbols; ``meant`` what letters and phrases mean in
    this line where it is not what they mean in the script. ``grounded`` tells that a true line does
    not rest on a false one above it, as far as that can be told, ``his_own`` that one which does
    follows from the student's own values too. ``mended`` is the link that fails
    as it would be without a slip, with what it then uses. ``before`` are the laws of the relations
    that stand, and are true, before the one that fails.
    """

    line: ScriptLine
    verdict: Verdict
    accuracy: Accuracy | None = None
    uses: tuple[Use, ...] = ()
    stated: tuple[Use, ...] = ()
    read_as: str | None = None
    link: int | None = None
    sources: tuple[int, ...] = ()
    mistake: Mistake | None = None
    remark: str | None = None
    grounded: bool = True
    his_own: bool = False
    meant: Mapping[str, Expression] = field(default_factory=dict, compare=False)
    mended: tuple[Claim, tuple[Use, ...]] | None = None
    before: tuple[Use, ...] = ()


@dataclass(frozen=True)
class Judgement:
    """A script judged: its lines, what its letters mean, and the letters that have to be asked."""

    lines: tuple[JudgedLine, ...]
    letters: tuple[Meaning, ...]
    asks: tuple[str, ...] = ()


def false_roots(lines: Iterable[JudgedLine]) -> Mapping[int, frozenset[int]]:
    """The numbers of the false lines on which each line rests; a false one rests on itself.

    A source that is none of the lines, one of an earlier part, is a root.
    """
    roots: dict[int, frozenset[int]] = {}
    for line in lines:
        number = line.line.number
        under = (roots.get(source, frozenset({source})) for source in line.sources)
        own = {number} if line.verdict == "false" else set[int]()
        roots[number] = frozenset(own).union(*under)
    return roots
