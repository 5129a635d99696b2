"""A bound of one quantity by a multiple of another, where their ratio stands in letters already.

From ``loss at the first impact = tan² α × loss at the second`` an inequality between the two losses
becomes one of tan² α: nothing is worked out again.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Showing,
)
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    Binary,
    Expression,
    Quantity,
    has_quantity,
    quantities_in,
)
from restitution.planning.formulas.shares_left import as_a_loss
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import ZERO, product_without, tree_of


def write_by_a_ratio(worths: Worths, fact: Fact, link: Link) -> int | None:
    """The bound of a ratio that an item above has in letters; None without such an item.

    What is given of the energy that is left is so of the share that is lost.
    """
    line = _by_a_ratio(worths, fact.id, link)
    return _by_the_share_lost(worths, fact, link) if line is None else line


def _by_the_share_lost(worths: Worths, fact: Fact, link: Link) -> int | None:
    """The bound of what is lost, by that of what is left; None without a ratio of the one."""
    for number in _ratios(worths):
        mark = worths.mark()
        turned = as_a_loss(worths.scene, link, worths.scene.desk.last_link(number).left)
        if turned is not None:
            own, defined = turned
            pool = (fact.id, defined)
            lost = worths.judge.write((Move("compare"),), pool, Relation(((own,),)))
            line = None if lost is None else _by_a_ratio(worths, lost, own)
            if line is not None:
                return line
        worths.back(mark)
    return None


def _by_a_ratio(worths: Worths, given: Ref, link: Link) -> int | None:
    left, right = (_multiple(worths, side) for side in (link.left, link.right))
    if left is None or right is None:
        return None
    (first, a), (second, b) = left, right
    for line in _ratios(worths):
        own = worths.scene.desk.last_link(line)
        match own.left:
            case Binary("/", Quantity() as above, Quantity() as below) if (
                {above, below} == {first, second} != {above}
            ):
                turned = above == second
            case _:
                continue
        bound = tree_of(tidy(a / b if turned else b / a))
        sign = FLIPPED[link.sign] if turned else link.sign
        mark = worths.mark()
        more = _positive(worths, below)
        if more is not None:
            compared = Relation(((Link(own.right, sign, bound),),))
            pool: tuple[Ref, ...] = (given, line, more)
            written = worths.judge.write((Move("compare"),), pool, compared)
            if written is not None:
                return written
        worths.back(mark)
    return None


def _positive(worths: Worths, quantity: Quantity) -> int | None:
    """The line that a quantity is positive, after that of the sums in it; None where it is open."""
    known = worths.scene.desk.known(quantity)
    if known is None or not all(isinstance(ref, int) for ref in known.refs):
        return None
    sums = [
        factor
        for factor in sp.Mul.make_args(sp.fraction(sp.sympify(known.value, strict=True))[0])
        if factor.is_Add
    ]
    names = symbol_names(known.value)
    pool: list[Ref] = [*known.refs, *worths.judge.known(names)]
    relation = Relation(((Link(quantity, ">", ZERO),),))
    roles = worths.scene.model.unknowns.roles
    # That a product of masses and speeds is positive needs no line.
    plain = not sums and all(roles[name].kind == "positive" for name in names if name in roles)
    shown: Showing = "silent" if plain else "line"
    line = worths.judge.write((Move("sign"),), pool, relation, shown=shown)
    for addend in sums if line is None else ():
        own = Relation(((Link(tree_of(addend), ">", ZERO),),))
        letters_ = symbol_names(addend)
        more = worths.judge.write((Move("sign"),), worths.judge.known(letters_), own)
        pool[:0] = [] if more is None else [more]
    return line or worths.judge.write((Move("compare"),), pool, relation)


def _multiple(worths: Worths, side: Expression) -> tuple[Quantity, sp.Expr] | None:
    """A positive number times one quantity of the motion; None of anything else."""
    quantities = set(quantities_in(side))
    own = next((quantity for quantity in quantities if quantity.kind in _KINDS), None)
    factor = None if own is None else product_without(side, own)
    if own is None or factor is None or has_quantity(factor):
        return None
    value = worths.scene.scalar(factor)
    return (own, value) if value.is_positive and value.is_number else None


_KINDS = ENERGIES | {"speed", "impulse", "time", "distance"}


def _ratios(worths: Worths) -> Iterator[int]:
    """The ends of items that give one quantity over another in letters."""
    desk = worths.scene.desk
    for end in reversed(desk.ends):
        relation = desk.relation(end.line) if desk.holds(end.line) else None
        if relation is not None and len(relation.options) == 1:
            own = desk.last_link(end.line)
            if own.sign == "=" and has_quantity(own.left) and not has_quantity(own.right):
                yield end.line
