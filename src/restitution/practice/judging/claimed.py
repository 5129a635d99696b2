"""What a claim of a script gives a value, and whether it holds in a world."""

from __future__ import annotations

from dataclasses import replace

from restitution.errors import RestitutionError
from restitution.expression.tree import Expression, Letter, is_quantity, walk
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Problem


def meant_by(entry: Entry) -> Expression:
    """What the left side of a claim means."""
    left = entry.claim.left
    return entry.meanings.get(left.name, left) if isinstance(left, Letter) else left


def has_value(value: Expression, tree: Expression, entry: Entry, world: World) -> bool:
    """Whether a tree of an entry has the value of another one in a world, to three figures."""
    return holds_in(replace(entry, claim=Claim(value, "=", tree)), world)


def holds_in(entry: Entry, world: World) -> bool:
    """Whether a claim holds in a world, exactly or to three figures."""
    try:
        grade = agrees(entry.claim, world, entry.meanings, entry.decimals, entry.scope)
    except RestitutionError:
        return False
    return grade in ("exact", "rounded")


def is_given(kind: str, problem: Problem) -> bool:
    """Whether the question gives a relation with a quantity of a kind in it."""
    return any(
        is_quantity(node, kind)
        for _, step in problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare)
        for side in relation.operands
        for node in walk(side)
    )
