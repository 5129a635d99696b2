"""An angle that is given, less or more one that is told: the angle that is left, by its tangent."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import Term, by_tangents, premises_of, term_of_data
from restitution.planning.formulas.named_angles import letter_of, tangent_line
from restitution.planning.formulas.turns import NONE, Direction, Form, Turn
from restitution.planning.writing.angles import RIGHT, STRAIGHT
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import ONE, TWO, difference, product, square, tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def other_angle(
    turn: Turn, first: bool, given: Expression, other: Expression
) -> tuple[Expression, Form, bool]:
    """One of the two angles of which a given one is made, by that and the other of them.

    As a tree, as a form of the given angle and the other, and whether the other comes first in
    that. Of an angle less 180° the tangent is that of the angle.
    """
    match turn.form:
        case "sum":
            return Binary("-", given, other), "difference", False
        case "difference" if first:
            return Binary("+", given, other), "sum", False
        case "difference":
            return Binary("-", other, given), "difference", True
        case "rest of sum":
            return Binary("-", Binary("-", STRAIGHT, given), other), "rest of sum", False
    if first:
        return Binary("+", Binary("-", STRAIGHT, given), other), "rest of difference", False
    return Binary("-", Binary("+", given, other), STRAIGHT), "sum", False


def by_the_known(
    scene: Scene, turn: Turn, given: Term, value: Any, refs: tuple[Ref, ...]
) -> int | None:
    """What a given angle says of the tangent of the one of its two angles that is open.

    The other one is told, with its tangent as a number: so the tangent of the open one is a number
    too, which stands on its own line, and is put equal to what the components make of it. None
    where that is not so. ``value`` is the tangent of the given angle, ``refs`` what gives it.
    """
    open_ = [side for side in (turn.first, turn.second) if side.angle is None]
    determined = [side for side in (turn.first, turn.second) if side.angle is not None]
    if len(open_) != 1 or not determined or determined[0].angle in (NONE, RIGHT):
        return None
    (side,), other = open_, determined[0].angle
    assert other is not None
    ratio = tidy(side.across.value / side.along.value)
    term = term_of_data(scene, other)
    known, more = scene.put(tangent_of_angle(scene.scalar(other)))
    if (
        not scene.unknown(ratio)
        or known.free_symbols
        or sp.sympify(value, strict=True).free_symbols
    ):
        return None
    if more and isinstance(term.tangent, Apply):
        term = Term(term.angle, tree_of(tidy(known)), more)
    tree, form, swapped = other_angle(turn, side is turn.first, given.angle, other)
    if tree == Binary("+", given.angle, other):
        tree, swapped = Binary("+", other, given.angle), True
    final = tidy(_tangent(form, *((known, value) if swapped else (value, known))))
    if not final.is_finite or final == 0:
        return None
    mark = scene.desk.mark()
    line = _lines(scene, turn, side, (given, term), (tree, form, swapped), refs, final)
    if line is None:
        scene.desk.back(mark)
    return line


def _lines(
    scene: Scene,
    turn: Turn,
    side: Direction,
    terms: tuple[Term, Term],
    form_of_turn: tuple[Expression, Form, bool],
    refs: tuple[Ref, ...],
    final: Any,
) -> int | None:
    own = formula(scene, side.named)
    if own.move.record != "tan":
        return None
    (given, other), (tree, form, swapped) = terms, form_of_turn
    first, letter = tangent_line(scene, side.named, own, own.move)
    _, meaning = letter_of(scene, side.named)
    subject = Letter(letter)
    twice = given.angle == other.angle and form == "sum"
    relation = chain(subject, (product(TWO, other.angle) if twice else tree, None))
    sources = [
        ref
        for direction in (turn.first, turn.second)
        for ref in (*direction.sources, *direction.refs)
    ]
    pool = dict.fromkeys((*refs, meaning, *sources, *turn.pushed, *turn.frame.refs))
    premises = premises_of(scene, turn, pool, relation, (*refs, meaning))
    if premises is None:
        return None
    angle = scene.desk.write(turn.move, premises, relation)
    tangent = Apply("tan", subject)
    if twice:
        known = _of_the_double(scene, angle, tangent, other, final)
    else:
        pair = (other, given) if swapped else (given, other)
        known = by_tangents(scene, angle, form, pair, tangent)
    if known is None:
        return None
    right = scene.desk.last_link(first).right
    equation = chain(right, (tree_of(final), None))
    premises = scene.judge.enough(Move("put"), (known, first), equation)
    return None if premises is None else scene.desk.write(Move("put"), premises, equation)


def _of_the_double(
    scene: Scene, line: int, tangent: Expression, other: Term, final: Any
) -> int | None:
    """The tangent of twice an angle, by the formula for it."""
    if not isinstance(other.angle, Letter):
        return None
    own = Apply("tan", other.angle)
    right = Binary("/", product(TWO, own), difference(ONE, square(own)))
    relation = chain(tangent, (right, None))
    move = Move("identity", "double-angle")
    refs = scene.judge.enough(move, (line,), relation, background(scene, {other.angle.name}))
    if refs is None:
        return None
    number = scene.desk.write(move, refs, relation)
    put = Binary("/", product(TWO, other.tangent), difference(ONE, square(other.tangent)))
    relation = chain(tangent, (put, None), (tree_of(final), "rearrange"))
    premises = scene.judge.enough(Move("put"), together((number,), other.refs), relation)
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


def _tangent(form: Form, p: Any, q: Any) -> Any:
    """The tangent of an angle by those of the two of which it is made."""
    match form:
        case "sum":
            return (p + q) / (1 - p * q)
        case "difference":
            return (p - q) / (1 + p * q)
        case "rest of sum":
            return (p + q) / (p * q - 1)
    return (q - p) / (1 + p * q)
