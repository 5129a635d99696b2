"""What a line only supposes, or says of a change: ``v < 0 if e > 1/2``, ``4 becomes 2``."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Expression,
    Letter,
    Name,
    Quantity,
    letters,
)
from restitution.practice.judging.entries import Entry, Meanings
from restitution.practice.reading.grammar import is_vector
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.student import facts_of, laws_of, student_world
from restitution.practice.worlds.world import World

_EXTREME = re.compile(
    r"(?<!at )\b(max|min|maximum|minimum|greatest|largest|smallest|least)\b", re.IGNORECASE
)
_CLOSE = 1e-6  # of a fact that holds
_BECOMING = re.compile(r"\b(becomes?|changes? to|goes to|turns into)\b", re.IGNORECASE)
_ARROW = re.compile(r"[-=]+>|[→⇒⟹⟶⇨➜➔➡]")


def speaks_of_an_extreme(line: ScriptLine) -> bool:
    """Whether a line speaks of a greatest or least value: ``max e is 1``."""
    return bool(_EXTREME.search(line.text))


def answer_in(line: ScriptLine) -> Link | None:
    """The only bound that a remark supposes, with a letter on one side: ``when k > 2``."""
    if line.kind != "remark" or len(line.supposed) != 1 or line.supposed[0].sign == "=":
        return None
    (claim,) = line.supposed
    single = any(isinstance(side, Letter) for side in (claim.left, claim.right))
    return Link((claim,), 1, len(line.text)) if single else None


def cases_in(
    opening: Sequence[str | None], line: ScriptLine
) -> Iterator[tuple[int, Sequence[int]]]:
    """The cases of a line, each with the places of the links that hold in it.

    ``opening`` has for every link that may open a case its letter. One stands before what holds in
    it, ``e = 0 → k = 4 and e = 1 → k = 2/3``, or last in brackets: ``4 = v + 2w (u = 5)``.
    """
    first = next(filter(None, opening), None)
    places = [place for place, letter in enumerate(opening) if letter and letter == first]
    last = len(opening) - 1
    if places == [last] and line.text.rstrip().endswith(")"):
        yield last, range(last)
    elif places and not places[0]:
        for place, end in pairwise((*places, len(opening))):
            if end > place + 1:
                yield place, range(place + 1, end)


def supposed_in(
    supposed: Sequence[Claim],
    line: ScriptLine,
    base: World,
    meanings: Meanings,
    unknown: Collection[str],
) -> tuple[World, ...] | None:
    """The world in which what a line supposes holds, if there is one that can be worked out.

    None where it supposes nothing, or what holds in any case; no world where nobody knows what
    its letters mean.
    """
    if not supposed:
        return None
    try:
        if all(agrees(claim, base, meanings, ()) for claim in supposed):
            return None
    except RestitutionError:
        return ()
    claims = [claim for claim in supposed if claim.sign == "="]
    if not claims:
        return ()
    entries = [Entry(line.number, claim, meanings, line.scope, right=False) for claim in claims]
    names = frozenset[str]().union(
        *(letters(side) for claim in claims for side in (claim.left, claim.right))
    )
    names = names & base.letters.keys()
    follows = bool(names & base.determined)
    every = frozenset(base.letters)
    singly = (frozenset((name,)) for name in sorted(every - names))
    for further in (frozenset[str](), *singly, every) if follows else (frozenset[str](),):
        # Where what is supposed follows from another letter, that has another value as well.
        world = student_world(base, entries, {*unknown, *names, *further})
        if world is not None and (not follows or _is_consistent(world)):
            return (world,)
    return ()


def _is_consistent(world: World) -> bool:
    """Whether the laws and what the statement gives hold in a world."""
    with np.errstate(all="ignore"):
        equations = (*facts_of(world), *laws_of(world))
        return all(np.all(np.abs(equation.residual(world)) < _CLOSE) for equation in equations)


def becomes_vector(claim: Claim, line: ScriptLine) -> bool:
    """Whether a claim in a line may say that a vector becomes another."""
    between = _BECOMING.search(line.text) or _ARROW.search(line.text)
    vectors = is_vector(claim.left, frozenset()) and is_vector(claim.right, frozenset())
    return between is not None and vectors


def changes_of_sizes(
    claim: Claim, line: ScriptLine, world: World
) -> Iterator[tuple[Claim, Claim, Claim]]:
    """What ``4 becomes 2`` may say: the sizes of a component before and after an impact.

    Or, of vectors, the velocities before and after one: ``(6, -3) becomes (6, 2)``, or with an
    arrow between them. Behind both is what the line states.
    """
    vectors = becomes_vector(claim, line)
    if claim.sign != "=" or not (vectors or _BECOMING.search(line.text)):
        return
    for number in world.lines:
        axis = Quantity("line_of_centres", (), number)
        for name in world.start:
            if vectors:
                old = Quantity("velocity", (Name(name),), number - 1)
                stated = Claim(replace(old, stage=number), "=", claim.right)
                yield Claim(old, "=", claim.left), stated, stated
                continue
            for kind in COMPONENTS:
                before, after = (
                    _size(Quantity(kind, (Quantity("velocity", (Name(name),), stage), axis)))
                    for stage in (number - 1, number)
                )
                left, right = _size(claim.left), _size(claim.right)
                yield Claim(before, "=", left), Claim(after, "=", right), claim


def _size(tree: Expression) -> Expression:
    return Apply("abs", tree)
