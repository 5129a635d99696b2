"""A given bound of a deflection that is made of two angles, as one of the angle that is open."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Move, Ref, numbers_in
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Degrees, Expression, Letter, Quantity
from restitution.planning.angles.angles_after_walls import is_for_a_calculator
from restitution.planning.angles.turn_lines import (
    Term,
    inverse_of_data,
    made_of_angles,
    terms_of,
)
from restitution.planning.angles.turning import angle_line
from restitution.planning.angles.wall_turns import sum_at_a_wall
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.turns import turns_of
from restitution.planning.inequalities.angles_bounded import (
    Bound,
    Bounded,
    by_tangents,
    relation_of,
)
from restitution.planning.inequalities.bounds_by_cotangents import by_cotangents
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass


@dataclass(frozen=True)
class Turned:
    """A deflection as a line makes it of an angle that is known and of one that is open.

    ``whole`` is that with the known angle in numbers, which ``inverse`` gives if it has a letter:
    a line with its inverse tangent, or a fact with its degrees.
    """

    line: int
    open: Term
    whole: Expression
    inverse: tuple[Ref, ...] = ()
    in_degrees: bool = False


def write_other_angle(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """A ratio of the other angle of a deflection, where one is known in degrees.

    That is taken from the bound first: 45° + β ≤ 60°, so β ≤ 15°, and β − 60° < 20°, so β < 80°.
    Where β may be obtuse its cotangent is compared. None of any other deflection.
    """
    if angle.kind != "deflection" or angle.stage not in worths.scene.model.frames:
        return None
    mark = worths.mark()
    try:
        worths.determine_angle(angle)
        own = _turned(worths.scene, angle, link.right)
        bounded = None if own is None else _of_the_other(worths, fact, link, own)
    except NotPlannedError:
        bounded = None
    if bounded is None:
        worths.back(mark)
    return bounded


def _of_the_other(worths: Worths, fact: Fact, link: Link, own: Turned) -> Bounded | None:
    scene, judge = worths.scene, worths.judge
    late = own.open.angle
    if not isinstance(late, Letter):
        return None
    value, symbol = scene.scalar(own.whole), scene.scalar(late)
    slope = value.diff(symbol)
    rest = tidy((scene.scalar(link.right) - value.subs(symbol, 0)) / slope)
    if not 0 < sp.N(rest) < sp.N(sp.pi):
        return None
    sign = link.sign if slope > 0 else FLIPPED[link.sign]
    end = tree_of(rest, angle=True, as_it_is=True)
    turned, whole = scene.desk.last_link(own.line).left, scene.desk.last_link(own.line).right
    names = {tree.name for tree in (late, turned) if isinstance(tree, Letter)}
    moves = (Move("rearrange"), Move("put"), Move("compare"))
    # Degrees are put in first; an inverse tangent stays a letter until the angle is alone.
    if own.in_degrees:
        whole = own.whole
    given, refs = (own.inverse, ()) if own.in_degrees else ((), own.inverse)
    first = judge.write(
        (Move("put"), Move("compare")),
        [fact.id, own.line, *given, *scene.desk.introducing(names)],
        relation_of(Link(whole, link.sign, link.right)),
    )
    less = first and judge.write(moves, [first, *refs], relation_of(Link(late, sign, end)))
    if not less:
        return None
    line = numbers_in(own.open.refs)[0]
    _, letter, extent = worths.lettered(line, late)
    bound, standing = Bound(less, letter, sign, end), worths.mark()
    bounded = by_tangents(worths, bound, line, extent) if sp.N(rest) < sp.N(sp.pi / 2) else None
    if bounded is not None:
        return bounded
    worths.back(standing)
    other = scene.desk.meant(late)
    return by_cotangents(worths, bound, other) if isinstance(other, Quantity) else None


def _turned(scene: Scene, angle: Quantity, bound: Expression) -> Turned | None:
    """The line that makes a deflection of a known angle and another one.

    None where neither is known, or the other one has no tangent.
    """
    mark = scene.desk.mark()
    for line, terms in _ways(scene, angle):
        whole = scene.desk.last_link(line).right
        for known, other in (terms, terms[::-1]):
            if not isinstance(other.angle, Letter) or not numbers_in(other.refs):
                continue
            if isinstance(known.angle, Degrees):
                return Turned(line, other, whole)
            in_degrees = _given_in_degrees(scene, known.angle)
            if in_degrees is not None:
                put, refs = in_degrees
                return Turned(line, other, exchanged(whole, {known.angle: put}), refs, True)
            inverse = _in_decimals(scene, known, scene.scalar(bound))
            if inverse is not None:
                worth = scene.desk.last_link(inverse).right
                return Turned(line, other, exchanged(whole, {known.angle: worth}), (inverse,))
        scene.desk.back(mark)
    return None


def _given_in_degrees(scene: Scene, angle: Expression) -> tuple[Expression, tuple[Ref, ...]] | None:
    """The degrees that a letter of the data is given as, with where; None of another angle."""
    known = scene.desk.known(angle) if isinstance(angle, Letter) else None
    if known is None:
        return None
    value = sp.sympify(known.value, strict=True)
    if not (value * 180 / sp.pi).is_Rational:
        return None
    return tree_of(value, angle=True, as_it_is=True), known.refs


def _ways(scene: Scene, angle: Quantity) -> Iterator[tuple[int, tuple[Term, Term]]]:
    """The lines that make a deflection of two angles, each with these and their tangents."""
    frame = scene.frame(int(str(angle.stage)))
    if frame.wall is not None:
        own = sum_at_a_wall(scene, angle, frame)
        if own is not None:
            yield own
        return
    for turn in turns_of(scene, angle):
        terms = terms_of(scene, turn)
        if terms is not None:
            letter, _ = letter_of(scene, angle)
            whole = turn.made_of(*(term.angle for term in terms))
            line = made_of_angles(scene, turn, chain(Letter(letter), (whole, None)), ())
            if line is not None:
                yield line, terms


def _in_decimals(scene: Scene, known: Term, bound: sp.Expr) -> int | None:
    """The line of an angle of which a number is the tangent, in a question for a calculator.

    None of another angle, and where what is left of the bound has a fraction for its tangent.
    """
    angle, tangent = scene.desk.meant(known.angle), scene.scalar(known.tangent)
    standard = bool((bound / _STANDARD).is_Integer)
    if not tangent.is_number or (standard and not is_for_a_calculator(scene)):
        return None
    left = (tangent_of_angle(bound + sign * sp.atan(tangent)) for sign in (1, -1))
    if any(tidy(own).is_Rational for own in left):
        return None
    if isinstance(angle, Quantity):
        return angle_line(scene, angle)
    is_given = isinstance(angle, Letter) and angle.name in scene.ratio_facts
    return inverse_of_data(scene, angle.name) if is_given else None  # type: ignore[union-attr]


# Of multiples of this the tangent is known without a calculator.
_STANDARD = sp.pi / 12


__all__ = ["write_other_angle"]
