"""Values that altered definitions give: the quantity that a claim names, and its value."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import ResultAt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    is_component,
    is_quantity,
    unsigned,
)
from restitution.practice.judging.claimed import holds_in
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.plain_mistakes import not_negative
from restitution.practice.worlds.world import World


def is_result(entry: Entry, result: ResultAt, world: World) -> bool:
    """Whether a claim gives a quantity the value that an altered definition gives it."""
    if not _is_quantity(entry, result.quantity, world):
        return False
    kind = result.quantity
    if is_quantity(kind, "impulse") and not kind.arguments:
        # Of a size people may write the difference in either order.
        entry = replace(entry, claim=replace(entry.claim, right=Apply("abs", entry.claim.right)))
    if not _gives(entry, result.value, world):
        return False
    return result.sense is None or not_negative(result.sense, world)


def _is_quantity(entry: Entry, quantity: Expression, world: World) -> bool:
    """Whether the left side of a claim names a quantity."""
    left = entry.claim.left
    if not isinstance(left, Letter | Quantity):
        return False
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    if is_quantity(quantity, "impulse") and not quantity.arguments:
        return is_impulse(left, entry) and _same_value(Apply("abs", meant), quantity, entry, world)
    if isinstance(meant, Binary) and isinstance(quantity, Binary):
        return _same_value(meant, quantity, entry, world)
    return (
        isinstance(meant, Quantity)
        and isinstance(quantity, Quantity)
        and (meant.kind == quantity.kind)
        and _same_value(meant, quantity, entry, world)
    )


def is_impulse(tree: Expression, entry: Entry) -> bool:
    """Whether a side is the size of an impulse, or a component of one."""
    meant = entry.meanings.get(tree.name, tree) if isinstance(tree, Letter) else tree
    meant = unsigned(meant)
    if is_component(meant):
        meant = meant.arguments[0]
    return is_quantity(meant, "impulse")


def _same_value(one: Expression, other: Expression, entry: Entry, world: World) -> bool:
    try:
        a = world.scalar(one, entry.meanings, scope=entry.scope)
        b = world.scalar(other, entry.meanings, scope=entry.scope)
    except RestitutionError:
        return False
    return bool(np.allclose(a, b, rtol=1e-9, atol=1e-12))


def _gives(entry: Entry, value: Expression, world: World) -> bool:
    """Whether the right side of a claim has the value of a tree."""
    claim = type(entry.claim)(value, "=", entry.claim.right)
    return holds_in(Entry(entry.number, claim, entry.meanings, entry.scope, entry.decimals), world)
