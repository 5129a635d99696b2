"""That a sphere comes to a wall between its ends: its place there as an inequality, solved."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Binary, Expression, Name, Quantity, Unit
from restitution.planning.formulas.whereabouts import velocity
from restitution.planning.inequalities.worths import Worths
from restitution.planning.journeys import journeys
from restitution.planning.journeys.places import coordinate
from restitution.planning.writing.desk import NotPlannedError, together
from restitution.planning.writing.flights import slope
from restitution.planning.writing.forms import swept, total, tree_of
from restitution.planning.writing.inequalities import certain, solve_linear, without_signs
from restitution.planning.writing.place_trees import Axis
from restitution.planning.writing.polynomials import cancelled, expanded, factored, one_fraction


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
    ends = [scene.scalar(side) for side in (low.left, high.right)]
    if not _bounds(_open(worths, value, ends)):
        return None
    worths.solver.determine(journeys.goals(scene, place))
    number, known = journeys.write(scene, place)
    put, refs = scene.put(known)
    value, tree = sp.sympify(put, strict=True), tree_of(put)
    # An end that it cannot come to is not named.
    open_ = _open(worths, value, ends)
    if not _bounds(open_):
        return None  # what was put in since leaves no letter
    links = (Link(low.left, "<", tree), Link(tree, "<", high.right))
    kept = tuple(link for link, equation in zip(links, open_, strict=True) if equation is not None)
    names = worths.known_in(value)
    pool: list[Ref] = [fact.id, number, *refs, *names]
    line = judge.write((Move("compare"),), pool, Relation((kept,)))
    if line is None:
        return None
    solved = [solve_linear(scene, *equation, wanted) for equation in open_ if equation is not None]
    relation = _joined([link for link in solved if link is not None])
    if relation is None or len(relation.only) < len(kept):
        return line
    if len(kept) > 1:
        whole = _without_denominator(worths, ends[0], value, ends[1])
        if whole is not None:
            line = judge.write((Move("compare"),), [line, *names], whole) or line
    after = judge.write((Move("rearrange"), Move("compare")), [line, *names], relation)
    return line if after is None else after


def _bounds(open_: Sequence[tuple[Sign, sp.Expr] | None]) -> bool:
    """Whether one of the ends that a place can come to bounds a letter."""
    return any(equation is not None and equation[1].free_symbols for equation in open_)


def is_of_a_path(relation: Relation) -> bool:
    """Whether a relation says where a path comes to the line of a wall with ends, or does not."""
    return len(relation.options) * len(relation.options[0]) == 2


def write_first_hit(worths: Worths, fact: Fact, wanted: Expression | None) -> int | None:
    """That a path comes to the line of a wall between its ends, or beyond them, solved.

    None where that is so anyway.
    """
    scene, judge = worths.scene, worths.judge
    there = _between_ends(fact.relation)
    match there:
        case Binary("+", _, Binary("*", Binary("-", level, _), Binary("/", pace, over))):
            pass
        case _:
            raise NotPlannedError("a path to a wall")
    (body, stage), beside_axis, across = _whose(pace), _axis(pace), _axis(over)
    for quantity in (pace, over):
        worths.determine(quantity)
    begin, start = (coordinate(scene, body, stage, axis) for axis in (beside_axis, across))
    along, towards = (velocity(scene, body, stage, axis) for axis in (beside_axis, across))
    end = scene.scalar(level)
    value = tidy(begin.value + (end - start.value) * along.value / towards.value)
    share = slope(scene, end, start.value, along.value, towards.value)
    tree = swept(total((tree_of(begin.value), share)))
    bounds = [
        (link.sign, scene.scalar(link.right))
        if link.left == there
        else (FLIPPED[link.sign], scene.scalar(link.left))
        for links in fact.relation.options
        for link in links
    ]
    gaps = [without_signs(scene, one_fraction(value - bound), sign) for sign, bound in bounds]
    kept = [n for n, gap in enumerate(gaps) if gap is not None and gap[1].free_symbols]
    if not kept:
        return None
    names = worths.known_in(value)
    refs = together(begin.refs, start.refs, along.refs, towards.refs)
    beyond = len(fact.relation.options) > 1
    relations = [_with(fact.relation, there, worth) for worth in (tree, tree_of(value))]
    # To the far side of an end the path may not come at all.
    near = [
        n
        for n, (sign, bound) in enumerate(bounds)
        if not beyond
        or certain(scene, one_fraction(value - bound)) != (1 if sign[0] == "<" else -1)
    ]
    solved = [solve_linear(scene, *gap, wanted) for n in near if (gap := gaps[n]) is not None]
    ends = [link for link in solved if link is not None]
    if len(ends) == len(near):
        last = Relation(tuple((end,) for end in ends)) if beyond else _joined(ends)
        relations += [] if last is None else [last]
    line: int | None = None
    moves = (Move("put"), Move("rearrange"), Move("compare"))
    for relation in relations:
        if line is not None and relation == scene.desk.relation(line):
            continue
        pool = [fact.id, *refs, *names] if line is None else [line, *names]
        after = judge.write(moves, pool, relation)
        line = line if after is None else after
    return line


def _between_ends(relation: Relation) -> Expression:
    """The coordinate that a relation bounds."""
    links = [link for option in relation.options for link in option]
    return links[0].right if len(relation.options) == 1 else links[0].left


def _with(relation: Relation, there: Expression, tree: Expression) -> Relation:
    """A relation with another tree for a coordinate."""
    return Relation(
        tuple(
            tuple(
                Link(
                    tree if link.left == there else link.left,
                    link.sign,
                    tree if link.right == there else link.right,
                )
                for link in links
            )
            for links in relation.options
        )
    )


def _whose(component: Expression) -> tuple[str, int]:
    """The body of a component of velocity, and after which event it is."""
    match component:
        case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), Unit())):
            return body, stage
    raise NotPlannedError("a path to a wall")


def _axis(component: Expression) -> Axis:
    assert isinstance(component, Quantity)
    assert isinstance(component.arguments[1], Unit)
    return "i" if component.arguments[1].axis == "i" else "j"


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
    sides = [factored(value) for value in (low * below, above, high * below)]
    common = sp.gcd_terms(sp.gcd_list([expanded(side) for side in sides]))
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
    low, high = sorted(links, key=lambda link: link.sign[0] == "<")
    if low.sign[0] == high.sign[0]:
        return None
    sign = "<" if low.sign == ">" else "<="
    return Relation(((Link(low.right, sign, low.left), high),))  # type: ignore[arg-type]
