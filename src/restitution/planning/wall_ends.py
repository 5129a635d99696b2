"""That a sphere comes to a wall between its ends: its place there as an inequality, solved."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.explaining.derivation import Fact, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Expression
from restitution.planning import journeys
from restitution.planning.desk import NotPlannedError
from restitution.planning.forms import tree_of
from restitution.planning.inequalities import certain, solve_linear, without_signs
from restitution.planning.polynomials import cancelled, factored, one_fraction
from restitution.planning.worths import Worths


def write_between(worths: Worths, fact: Fact, wanted: Expression | None) -> int | None:
    """The line in which a place between the ends of a wall bounds a letter, solved if it can be.

    None where the place is within them anyway, or is given.
    """
    mark = worths.mark()
    try:
        line = _between(worths, fact, wanted)
    except NotPlannedError:
        line = None
    if line is None:
        worths.back(mark)
    return line


def _between(worths: Worths, fact: Fact, wanted: Expression | None) -> int | None:
    scene, judge = worths.scene, worths.judge
    low, high = fact.relation.only
    place = low.right
    value = sp.sympify(scene.put(scene.scalar(place))[0], strict=True)
    ends = [scene.scalar(each) for each in (low.left, high.right)]
    if not any(each is not None and each[1].free_symbols for each in _open(worths, value, ends)):
        return None
    worths.solver.determine(journeys.goals(scene, place))
    number, known = journeys.write(scene, place)
    put, refs = scene.put(known)
    value, tree = sp.sympify(put, strict=True), tree_of(put)
    # An end that it cannot come to is not named.
    open_ = _open(worths, value, ends)
    links = (Link(low.left, "<", tree), Link(tree, "<", high.right))
    kept = tuple(link for link, each in zip(links, open_, strict=True) if each is not None)
    names = worths.known_in(value)
    pool: list[Ref] = [fact.id, number, *refs, *names]
    line = judge.write((Move("compare"),), pool, Relation((kept,)))
    if line is None:
        return None
    solved = [solve_linear(scene, *each, wanted) for each in open_ if each is not None]
    relation = _joined([each for each in solved if each is not None])
    if relation is None or len(relation.only) < len(kept):
        return line
    if len(kept) > 1:
        whole = _without_denominator(worths, ends[0], value, ends[1])
        if whole is not None:
            line = judge.write((Move("compare"),), [line, *names], whole) or line
    after = judge.write((Move("rearrange"), Move("compare")), [line, *names], relation)
    return line if after is None else after


def _open(
    worths: Worths, value: sp.Expr, ends: Sequence[sp.Expr]
) -> list[tuple[Sign, sp.Expr] | None]:
    """The conditions that a value lies between two ends; None where one holds anyway."""
    gaps = (value - ends[0], ends[1] - value)
    return [without_signs(worths.scene, one_fraction(gap), ">") for gap in gaps]


def _without_denominator(
    worths: Worths, low: sp.Expr, value: sp.Expr, high: sp.Expr
) -> Relation | None:
    """A value between two ends, multiplied by the letters below it; None where there are none."""
    above, below = sp.fraction(factored(one_fraction(value)))
    if not below.free_symbols or certain(worths.scene, below) != 1:
        return None
    sides = [factored(each) for each in (low * below, above, high * below)]
    common = sp.gcd_terms(sp.gcd_list([sp.expand(side) for side in sides]))
    if certain(worths.scene, common) != 1:
        return None
    trees = [tree_of(factored(cancelled(side / common))) for side in sides]
    return Relation(((Link(trees[0], "<", trees[1]), Link(trees[1], "<", trees[2])),))


def _joined(links: list[Link]) -> Relation | None:
    """One bound, or two of the same letter as a chain."""
    if len(links) == 1:
        return Relation((tuple(links),))
    if len(links) != 2 or links[0].left != links[1].left:
        return None
    low, high = sorted(links, key=lambda each: each.sign[0] == "<")
    if low.sign[0] == high.sign[0]:
        return None
    sign = "<" if low.sign == ">" else "<="
    return Relation(((Link(low.right, sign, low.left), high),))  # type: ignore[arg-type]
