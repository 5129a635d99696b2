"""Speeds that are given in a sum: of one component they have no root."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Expression,
    Quantity,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.desk import chain
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def is_in_a_sum(scene: Scene, quantity: Quantity) -> bool:
    """Whether a quantity is given together with a sum: no root is taken of both sides then."""
    return any(
        any(quantity in walk(side) for side in sides)
        and any(is_binary(node, "+", "-") and has_quantity(node) for e in sides for node in walk(e))
        for sides in ((given.link.left, given.link.right) for given in scene.given)
    )


def of_one_component(
    scene: Scene, move: Move, quantity: Quantity, base: Expression, refs: tuple[Ref, ...]
) -> tuple[Ref, ...] | None:
    """Premises of a speed that is the one component, as that is certain not to be negative."""
    known = background(scene, letters(base))
    return scene.judge.enough(move, refs, chain(quantity, (base, None)), known)
