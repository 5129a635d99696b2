"""Angles that a working names: the letter for one, and its ratios as lines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.explaining.lines.derivation import Meaning, Move, MoveId, Ref, Relation
from restitution.explaining.lines.trees import angles_with_both_ratios, exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.planning.formulas.definitions import Formula
from restitution.planning.writing.angle_ratios import given_ratio
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import ONE, factors, in_tangents, product, swept, tree_of
from restitution.planning.writing.polynomials import cancelled, expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.same_angles import tangent_by_the_same, write_same_angle
from restitution.planning.writing.scene import Scene

# Numbers with more places are fractions.
_PLACES = 4

ANGLES = {
    "deflection": ("delta", "phi", "psi", "gamma"),
    "angle": ("beta", "theta", "phi", "psi", "gamma"),
    "direction": ("theta", "phi", "beta", "psi", "gamma"),
}


def letter_of(scene: Scene, asked: Quantity) -> tuple[str, Ref]:
    """The letter for an angle, and the line that introduces it, or the fact."""
    known = letter_known(scene, asked)
    if known is not None:
        return known
    letter = free_letter(scene, asked.kind)
    return letter, scene.desk.write(Move("let"), (), Meaning(letter, asked))


def letter_known(scene: Scene, asked: Quantity) -> tuple[str, Ref] | None:
    """The letter that an angle has already, and the line or the fact that says so; else None."""
    for fact in scene.desk.facts:
        if fact.id.startswith("let ") and fact.relation.only[0].left == asked:
            right = fact.relation.only[0].right
            assert isinstance(right, Letter)
            return right.name, fact.id
    for line in scene.desk.lines:
        if isinstance(line.relation, Meaning) and line.relation.quantity == asked:
            return line.relation.letter, line.number
    return None


def free_letter(scene: Scene, kind: str) -> str:
    """A letter for an angle of a kind that stands for nothing yet."""
    taken, names = letters_taken(scene), ANGLES[kind]
    numbered = (f"{name}_{n}" for n in range(1, 9) for name in names)
    return next(name for name in (*names, *numbered) if name not in taken)


def letters_taken(scene: Scene) -> set[str]:
    """The letters that a new one must not be."""
    own = {line.relation.letter for line in scene.desk.lines if isinstance(line.relation, Meaning)}
    symbols = {component.symbol.name for component in scene.model.components.values()}
    problem = scene.problem
    bodies = {sphere.name for sphere in problem.spheres} | {wall.name for wall in problem.walls}
    bodies |= {point.name for point in problem.points}
    return own | symbols | bodies | set(scene.model.unknowns.roles)


def ratio_line(
    scene: Scene,
    move: Move,
    refs: tuple[Ref, ...],
    ratio: Expression,
    right: Expression,
    value: Any,
) -> int:
    """A ratio of an angle by components, and what that comes to.

    Where the one in the denominator is negative it keeps its sign: that tells the angle. One that
    is 1 stands there all the same, 4/1: so the components are seen.
    """
    numbered = _with_a_number_in_front(right)
    first = numbered or swept(right)
    match right:
        case Binary("/", above, below) if isinstance(swept(below), Negate) or (
            swept(below) == ONE and is_function(ratio, "tan")
        ):
            first = Binary("/", swept(above), swept(below))
    final = in_tangents(value) if sp.sympify(value, strict=True).is_number else value
    ends = tuple(_over_roots(scene, first))
    if numbered is None and not (ends and _is_of_degrees(final)):
        ends = (*ends, tree_of(final))
    rearrange: MoveId = "rearrange"
    relation = chain(ratio, (first, None), *((end, rearrange) for end in ends))
    names = letters(relation.only[0].right)
    # On which side of a right angle the angle is, may rest on what is given of letters.
    known = [ref for name in sorted(names) for ref in scene.judge.ranges_given(name)]
    if known or sp.sympify(value, strict=True).has(sp.Abs):
        known += background(scene, names)
    if known:
        refs = scene.judge.enough(move, refs, relation, known) or refs
    if angles_with_both_ratios((right,)) and not scene.judge.follows(move, refs, relation):
        *links, last = relation.only
        by_squares = Relation(((*links, replace(last, by="identity")),))
        premises = scene.judge.enough(move, refs, by_squares, background(scene, names))
        if premises is not None:
            refs, relation = premises, by_squares
    return scene.desk.write(move, refs, relation)


def _with_a_number_in_front(quotient: Expression) -> Expression | None:
    """A quotient of figures, 3.2 sin 37° over a sum, without a quotient above: 16 sin 37°/5.

    None of another one, and where that number has no end as a decimal.
    """
    match quotient:
        case Binary("/", above, Binary("+" | "-") as below) if not letters(quotient):
            first, *rest = factors(above)
        case _:
            return None
    match first:
        case Binary("/", Number(whole), Number(part)) if rest and 10**_PLACES % part == 0:
            return Binary("/", product(Number(whole / part), *rest), swept(below))
    return None


def _is_of_degrees(value: Any) -> bool:
    """Whether a number has ratios of angles such as 35°."""
    own = sp.sympify(value, strict=True)
    return bool(own.is_number and own.has(sp.sin, sp.cos))


def _over_roots(scene: Scene, quotient: Expression) -> Iterator[Expression]:
    """A quotient of numbers without common letters, where a sum with roots stands below."""
    match quotient:
        case Binary("/", above, below) if letters(above) & letters(below):
            sides = [sp.sympify(scene.scalar(tree), strict=True) for tree in (above, below)]
        case _:
            return
    common = sp.Mul(*(symbol for symbol in sides[1].free_symbols))
    top, bottom = (expanded(cancelled(side / common)) for side in sides)
    if not top.is_number or not bottom.is_number or not bottom.is_Add:
        return
    terms = [term for side in (top, bottom) for term in sp.Add.make_args(side)]
    lowest = sp.ilcm(1, *(term.as_coeff_Mul()[0].q for term in terms))
    top, bottom = (tree_of(expanded(value * lowest), as_it_is=True) for value in (top, bottom))
    yield Binary("/", top, bottom)


def tangent_line(scene: Scene, asked: Quantity, own: Formula, move: Move) -> tuple[int, str]:
    """The tangent of an angle by its definition: the line, and the letter of the angle.

    Where that stands in letters of which some are known by now, these are put in.
    """
    letter, meaning = letter_of(scene, asked)
    refs = together(own.refs, (meaning,))
    subject = Apply("tan", Letter(letter))
    standing = _tangent_with_values(scene, asked, meaning, own)
    if standing is None:
        standing = _tangent_by_a_letter(scene, asked, subject, meaning)
    if standing is not None:
        return standing, letter
    same = write_same_angle(scene, asked, letter, meaning)
    known = None if same is None else tangent_by_the_same(scene, letter, same)
    if known is not None:
        return known, letter
    return ratio_line(scene, move, refs, subject, own.right, own.value), letter


def _tangent_by_a_letter(
    scene: Scene, asked: Quantity, subject: Expression, meaning: Ref
) -> int | None:
    """The line of a tangent that stands without a letter for its angle, with the letter put in."""
    desk = scene.desk
    for line in reversed(desk.lines):
        if isinstance(line.relation, Meaning) or not desk.holds(line.number):
            continue
        links = line.relation.options[0]
        if len(line.relation.options) > 1 or links[0].left != Apply("tan", asked):
            continue
        if any(link.sign != "=" for link in links) or scene.lets_in(links[-1]):
            continue
        relation = chain(subject, (links[-1].right, None))
        premises = scene.judge.enough(Move("rearrange"), (line.number, meaning), relation)
        if premises is not None:
            return desk.write(Move("rearrange"), premises, relation)
    return None


def _tangent_with_values(scene: Scene, asked: Quantity, meaning: Ref, own: Formula) -> int | None:
    """The line of a tangent that stands, with the values of its letters put in if they have any.

    It may stand without the letter for its angle.
    """
    desk, subject = scene.desk, Apply("tan", Letter(letter_of(scene, asked)[0]))
    for line in reversed(desk.lines):
        if isinstance(line.relation, Meaning) or not desk.holds(line.number):
            continue
        links = line.relation.options[0]
        if len(line.relation.options) > 1 or links[0].left not in (subject, Apply("tan", asked)):
            continue
        if any(link.sign != "=" for link in links) or has_quantity(links[-1].right):
            continue
        ratios, given = _given_ratios(scene, links[-1].right)
        put, refs = scene.put(scene.scalar(exchanged(links[-1].right, ratios)))
        if not scene.model.identically_zero(put - own.value):
            continue
        lets = scene.lets_in(desk.last_link(line.number))
        named = () if links[0].left == subject else (meaning,)
        if not refs and not given and not lets:
            if not named:
                return line.number
            continue
        relation = chain(subject, (tree_of(in_tangents(put)), None))
        pool = (line.number, *named, *given, *refs)
        premises = scene.judge.enough(Move("put"), pool, relation, lets)
        if premises is not None:
            return desk.write(Move("put"), premises, relation)
    return None


def _given_ratios(
    scene: Scene, tree: Expression
) -> tuple[dict[Expression, Expression], tuple[Ref, ...]]:
    """The ratios of angles in a tree of which the facts give the values, and these facts."""
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    for node in walk(tree):
        match node:
            case Apply(_, Letter(name)) if name in scene.ratio_facts and node not in values:
                ratio, right, ref = given_ratio(scene, name)
                if ratio == node:
                    values[node], refs = right, [*refs, ref]
    return values, tuple(refs)
