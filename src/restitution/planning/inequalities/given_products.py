"""A scalar product that is given a bound: the velocities are put into it."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Fact, Link, Move, Relation, Sign
from restitution.expression.tree import Quantity, has_quantity, is_quantity, walk
from restitution.planning.formulas.angle_formulas import product_formula
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
