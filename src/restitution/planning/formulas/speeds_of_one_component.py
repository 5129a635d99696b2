"""Speeds that are one component of certain sign: they have no root, and no bars."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.exact.plain_angles import plain_angles_in
from restitution.explaining.lines.derivation import FLIPPED, Move, Ref, Relation
from restitution.expression.tree import (
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def is_squared(scene: Scene, quantity: Quantity) -> bool:
    """Whether a speed that is not asked stands in what is given: both sides are squared."""
    desk = scene.desk
    given = (e for e in desk.facts if e.kind in ("given", "range") and desk.holds(e.id))
    sides = (side for fact in given for side in fact.relation.trees)
    tied = any(quantity in walk(side) for side in sides)
    return tied and quantity not in scene.asked_alone


def root_of_one_square(scene: Scene, tree: Expression) -> sp.Expr | None:
    """The root of one square whose base has a certain sign; None of anything else.

    A square of roots of letters is multiplied out, as a reader cannot see what it is the square of.
    What has ratios of angles in degrees stays as its line has it.
    """
    if not is_binary(tree, "^"):
        return None
    base = scene.scalar(tree.left)
    sign = proved_sign(scene.model.ground, base) if base.free_symbols else None
    if sign and plain_angles_in(base):
        return sign * base
    return tidy(sign * base) if sign else None


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


def of_given_sign(
    scene: Scene, move: Move, quantity: Quantity, base: Expression, refs: tuple[Ref, ...]
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]] | None:
    """A speed as the size of the one component, whose sign an inequality tells, with premises.

    None where that is open, or where no inequality is given or worked out.
    """
    names, value = letters(base), scene.scalar(base)
    bounds = (*_bounds(scene, names), *(ref for n in names for ref in scene.judge.ranges_given(n)))
    if not bounds:
        return None
    pool = (*background(scene, names), *bounds)
    for size, own in ((base, value), (tree_of(tidy(-value)), tidy(-value))):
        premises = scene.judge.enough(move, refs, chain(quantity, (size, None)), pool)
        if premises is not None:
            return size, own, premises
    return None


def _bounds(scene: Scene, names: frozenset[str]) -> Iterator[int]:
    """The lines in force that bound one of some letters."""
    for line in scene.desk.lines:
        own = line.relation
        if not isinstance(own, Relation) or len(own.options) > 1 or len(own.only) > 1:
            continue
        (link,) = own.only
        bounds = link.sign in FLIPPED and isinstance(link.left, Letter) and link.left.name in names
        if bounds and scene.desk.holds(line.number):
            yield line.number


__all__ = [
    "is_in_a_sum",
    "is_squared",
    "of_given_sign",
    "of_one_component",
    "root_of_one_square",
]
