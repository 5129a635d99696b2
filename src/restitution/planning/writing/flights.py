"""Ways over speeds, as lines write them: positive as far as values tell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from restitution.explaining.lines.derivation import Ref, Relation
from restitution.expression.tree import (
    Binary,
    Expression,
    Negate,
    Number,
    Unit,
    has_quantity,
    letters,
)
from restitution.planning.writing.desk import Source, chain, link, together
from restitution.planning.writing.forms import (
    ONE,
    ZERO,
    difference,
    negative,
    product,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.place_trees import AXES
from restitution.planning.writing.polynomials import factored
from restitution.planning.writing.premises import nonzero, sign_known
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def swept_product(scene: Scene, last: sp.Expr, first: sp.Expr, pace: sp.Expr) -> Expression:
    """A way times a component, each written as a positive number as far as values tell."""
    (distance, pace_), minus = _sizes(scene, last, first, pace)
    tree = swept(product(distance, pace_))
    return negative(tree) if minus else tree


def slope(
    scene: Scene,
    last: sp.Expr,
    first: sp.Expr,
    pace: sp.Expr,
    over: sp.Expr,
    by_degrees: tuple[Expression, Expression] | None = None,
) -> Expression:
    """A way in one direction by that in another: each size positive as far as values tell.

    ``by_degrees`` are the sizes of the two speeds by an angle of the data.
    """
    (distance, *paces), minus = _sizes(scene, last, first, pace, over)
    first_pace, second_pace = by_degrees or paces
    ratio = () if first_pace == second_pace else (Binary("/", first_pace, second_pace),)
    tree = product(distance, *ratio)
    return negative(tree) if minus else tree


def gradient(
    scene: Scene, above: Sequence[Source], below: Sequence[Source]
) -> tuple[Expression, bool]:
    """A way over another one, of each its two ends: both sizes, and whether it is negative."""
    minus, sizes = False, []
    for first, last in (above, below):
        (size,), back = _sizes(scene, last.value, first.value)
        minus ^= back
        sizes.append(size)
    return swept(Binary("/", *sizes)), minus


def time_relation(
    quantity: Expression, tree: Expression, value: sp.Expr, pace: sp.Expr, in_degrees: bool = False
) -> Relation:
    """``t = d/v = …``: what is divided by 1 is still seen to be divided, and so is (3 − 0)/4.

    ``in_degrees`` tells that the tree has the speed by an angle of the data.
    """
    if value.is_number and abs(pace) == 1 and not in_degrees:
        tree = Binary("/", swept(tree), ONE)
        return Relation(((link(quantity, tree), link(tree, tree_of(value), by="rearrange")),))
    match swept(tree):
        case Binary("/", Number() as distance, Number()) as quotient if quotient == tree_of(value):
            tree = replace(quotient, left=Binary("-", distance, ZERO))
            return Relation(((link(quantity, tree), link(tree, quotient, by="rearrange")),))
    return chain(quantity, (swept(tree), None), (tree_of(value), "rearrange"))


def _sizes(
    scene: Scene, last: sp.Expr, first: sp.Expr, *paces: sp.Expr
) -> tuple[list[Expression], bool]:
    """A way and speeds as positive trees, and whether their product is negative."""
    minus = scene.model.sign(scene.model.in_data(last - first)) < 0
    if minus:
        last, first = first, last
    sizes = [difference(tree_of(last), tree_of(first))]
    for pace in paces:
        back = scene.model.sign(scene.model.in_data(pace)) < 0
        minus ^= back
        sizes.append(tree_of(-pace if back else pace))
    return sizes, minus


def divisor_refs(scene: Scene, distance: sp.Expr, pace: sp.Expr) -> tuple[Ref, ...]:
    """What tells that a speed is not zero: nothing, where the way plainly is not."""
    open_ = [x for x in sp.Mul.make_args(factored(distance)) if not _is_plainly_not_zero(scene, x)]
    if not open_:
        return ()
    return together(nonzero(scene, pace), *(sign_known(scene, value) for value in open_))


def _is_plainly_not_zero(scene: Scene, factor: sp.Expr) -> bool:
    """Whether a factor is a number, or made of positive letters and terms of one sign."""
    base = factor.base if factor.is_Pow else factor
    roles = scene.model.unknowns.roles
    terms = sp.Add.make_args(base)
    for letter in base.free_symbols:
        role = roles.get(letter.name)
        if role is None or role.kind != "positive":
            return False
    return len({sp.sign(term.as_coeff_Mul()[0]) for term in terms}) == 1


def time_quotient(
    scene: Scene,
    last: sp.Expr,
    first: sp.Expr,
    pace: sp.Expr,
    form: Expression | None = None,
    end: Expression | None = None,
) -> Expression:
    """A distance over a speed, both positive as far as their values tell.

    ``form`` is how the size of the speed is written, and ``end`` how the coordinate at the end is,
    where that is not by the value.
    """
    ends = [tree_of(last) if end is None else end, tree_of(first)]
    if scene.model.sign(pace) < 0:
        ends, pace = ends[::-1], -pace
    match [swept(end) for end in ends]:
        case [Negate(near), Negate(far)]:
            distance = difference(far, near)  # 4d − d/2, and not −d/2 + 4d
        case _:
            distance = difference(*ends)
    return Binary("/", distance, tree_of(pace) if form is None else form)


def added(first: Vector, flight: Expression, pace: Vector) -> Expression:
    """A place and a velocity for some time; a time in letters stands behind a size: ``4t i``."""
    parts = [(value, axis) for value, axis in zip(pace, AXES, strict=True) if value != 0]
    distance = product(flight, tree_of(pace))
    if len(parts) == 1 and (has_quantity(flight) or letters(flight)):
        ((size, axis),) = parts
        distance = product(tree_of(size), flight, Unit(axis))
    return swept(total((tree_of(first), distance)))
