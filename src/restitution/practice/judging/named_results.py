"""What a claim gives a value: an impulse, a loss, an angle; and by which altered definition."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import ResultAt
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    unsigned,
)
from restitution.practice.judging.claimed import holds_in
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.judging.other_forms import is_turn, kind_of
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


def is_worked_angle(entry: Entry) -> bool:
    """Whether a claim gives the cosine of an angle by a quotient of products of numbers."""
    left, right = entry.claim.left, entry.claim.right
    named = is_function(left, "cos") and isinstance(left.argument, Letter | Quantity)
    return named and is_binary(right, "/") and is_binary(right.left, "+", "-") and is_numeric(right)


def is_loss(entry: Entry) -> bool:
    """Whether a claim gives what is lost of kinetic energy a value that is not zero."""
    left = entry.claim.left
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    return kind_of(meant) in LOSSES and entry.claim.right != Number(Fraction(0))


def is_deflection(entry: Entry) -> bool:
    """Whether the left side of a claim is the angle between two directions of one body."""
    left = entry.claim.left
    return is_turn(entry.meanings.get(left.name, left) if isinstance(left, Letter) else left)
