"""A scalar product that is given a bound: the velocities are put into it."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Fact, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import (
    Expression,
    Quantity,
    Unit,
    has_quantity,
    is_quantity,
    unsigned,
    walk,
)
from restitution.planning.formulas.angle_formulas import product_formula
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ZERO, swept, tree_of
from restitution.planning.writing.inequalities import without_signs
from restitution.planning.writing.polynomials import expanded


def write_given_product(worths: Worths, fact: Fact, link: Link) -> tuple[int, Sign, sp.Expr] | None:
    """The line of a scalar product that is given a bound, with what is compared with zero in it.

    None for another inequality, and where the velocities are not known as vectors.
    """
    match link:
        case Link(Quantity("dot") as product, sign, right) if not has_quantity(right):
            pass
        case _:
            return None
    scene, mark = worths.scene, worths.mark()
    for node in walk(product):
        if is_quantity(node, "velocity"):
            worths.determine(node)
    try:
        own = product_formula(scene, product)
    except NotPlannedError:
        worths.back(mark)
        return None
    gap = expanded(own.value - scene.scalar(right))
    stripped = without_signs(scene, gap, sign)
    known = worths.known_in(gap)
    first = Relation(((Link(swept(own.right), sign, right),),))
    number = worths.judge.write((Move("put"),), [fact.id, *own.refs, *known], first)
    if stripped is None or number is None:
        worths.back(mark)
        return None
    sign, x = stripped
    short = Relation(((Link(tree_of(x), sign, ZERO),),))
    moves = (Move("rearrange"), Move("cancel"))
    return worths.judge.write(moves, [number, *known], short) or number, sign, x


def product_with_an_axis(
    worths: Worths, angle: Quantity
) -> tuple[tuple[tuple[str, int]], Expression, sp.Expr, tuple[Ref, ...]] | None:
    """The component along **i** or **j** of a velocity that stands as a vector, which it has then.

    With whose velocity it is, its value and what that rests on. None of another angle.
    """
    match angle:
        case Quantity("angle", (Quantity("velocity") as velocity, line)) if isinstance(
            unsigned(line), Unit
        ):
            worths.determine(velocity)
        case _:
            return None
    mark = worths.mark()
    try:
        own = product_formula(worths.scene, Quantity("dot", (velocity, line)))
    except NotPlannedError:
        worths.back(mark)
        return None
    state = body_and_stage(worths.scene, velocity)
    return (state,), swept(own.right), sp.sympify(own.value, strict=True), own.refs
