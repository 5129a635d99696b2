"""Lines about a result that hold where a mistake puts another value in its place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.explaining.mistakes.misconceptions import ResultAt, VariantAt, variants_at
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Expression, Letter, quantities_in, walk
from restitution.practice.judgement import Use
from restitution.practice.script import Claim, Decimal, Scope
from restitution.practice.worlds.agreement import NOT, grades
from restitution.practice.worlds.arrays import UnvaluedError
from restitution.practice.worlds.states import States
from restitution.practice.worlds.telling import Meanings
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_NAMES: Mapping[str, str] = dict.fromkeys(LOSSES, "energy")


def altered_results(
    claim: Claim,
    tried: States,
    meanings: Meanings,
    decimals: Sequence[Decimal],
    scope: Scope,
    *,
    loose: bool,
) -> tuple[Use, ...]:
    """The altered results of which a line is an instance.

    With ``loose`` those that hold in states that no law binds, or few; else those that hold in the
    world with their value put in. Raises UnvaluedError where a side has no value.
    """
    spoken = _spoken(claim, tried.world, meanings, scope)
    uses: list[Use] = []
    for variant, result in _results(tried.world):
        if not any(result.quantity == tree for tree in spoken):
            continue
        put = _put(claim, result, tried.world, meanings, scope)
        try:
            if not _is_meant(result, tried):
                continue
            exactness = grades(put, tried.world, meanings, decimals, scope)
        except UnvaluedError:
            continue
        use = Use(_principle(result.quantity), variant.event.number)
        use = replace(use, bodies=variant.event.bodies, altered=variant.id)
        loosely = _holds_loosely(tried, tried.holding(exactness < NOT), variant.event.number)
        if loosely if loose else (exactness[: tried.rows] < NOT).all():
            uses.append(use)
    return tuple(dict.fromkeys(uses))


def _holds_loosely(tried: States, holding: object, event: int) -> bool:
    """Whether something holds in states of an event under fewer than all of its laws."""
    assert isinstance(holding, np.ndarray)
    lawful = [
        (block, bool(holds))
        for block, holds in zip(tried.blocks, holding, strict=True)
        if block.event == event and block.variant is None and not block.given
    ]
    most = max(len(block.laws) for block, _ in lawful)
    return any(holds for block, holds in lawful if len(block.laws) < most)


def _results(world: World) -> Iterator[tuple[VariantAt, ResultAt]]:
    """The altered results of all impacts, the latest first."""
    events = events_of(world.problem)
    for event in reversed(events[: len(world.events)]):
        if isinstance(world.events[event.number - 1], Impact):
            for variant in variants_at(event, events):
                for result in variant.results:
                    yield variant, result


def _is_meant(result: ResultAt, tried: States) -> bool:
    """Whether anyone would make this mistake here."""
    if result.sense is None:
        return True
    sense = tried.world.scalar(result.sense)[: tried.rows]
    return bool(np.all(sense >= -1e-9))


def _principle(result: Expression) -> str:
    """The principle of lines about a result; of a fraction or a difference, that of its parts."""
    first = next(quantities_in(result))
    return _NAMES.get(first.kind, first.kind)


# --- trees ----------------------------------------------------------------------------------------


def _put(claim: Claim, result: ResultAt, world: World, meanings: Meanings, scope: Scope) -> Claim:
    """A line with the altered value in place of the quantity."""
    sides = (
        exchanged(_in_words(side, world, meanings, scope), {result.quantity: result.value})
        for side in (claim.left, claim.right)
    )
    left, right = sides
    return Claim(left, claim.sign, right)


def _spoken(claim: Claim, world: World, meanings: Meanings, scope: Scope) -> frozenset[Expression]:
    return frozenset(
        node
        for side in (claim.left, claim.right)
        for node in walk(_in_words(side, world, meanings, scope))
    )


def _in_words(tree: Expression, world: World, meanings: Meanings, scope: Scope) -> Expression:
    """A tree with quantities in place of letters, at the stages that are meant."""

    def change(node: Expression) -> Expression:
        if isinstance(node, Letter):
            if node.name in meanings and meanings[node.name] != node:
                return meanings[node.name]
            if node.name in world.lets:
                return world.lets[node.name][0].expression
        return node

    return staged(world.problem, rebuilt(tree, change), world.now(scope))
