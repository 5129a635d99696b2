"""A deflection, or an angle between two velocities, that is given: as an equation in components."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, Literal

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.definitions.turnings import direction_from_i
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    is_quantity,
    letters,
)
from restitution.planning.angles.known_turns import by_the_known, other_angle
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.scalar_angles import write_given_cosine
from restitution.planning.angles.turn_lines import (
    Term,
    by_tangents,
    made_of_angles,
    meeting,
    terms_of,
)
from restitution.planning.angles.turning import angle_line
from restitution.planning.axes.offsets import angle_of_an_offset
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.turns import NONE, Direction, Turn, is_along_a_letter, turns_of
from restitution.planning.writing.angles import RIGHT
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    ZERO,
    difference,
    product,
    square,
    swept,
    tree_of,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def given_turn(scene: Scene, equation: GivenEquation) -> int | None:
    """The equation of an angle between two velocities that is given, or its tangent.

    None where it is not made of two angles to one line.
    """
    match equation.link.left:
        case Quantity() as asked:
            ratio = False
        case Apply("tan", Quantity() as asked):
            ratio = True
        case _:
            return None
    mark = scene.desk.mark()
    own = _as_a_turn(scene, asked)
    for turn in turns_of(scene, own):
        if own != asked and not any(_is_across(scene, e) for e in (turn.first, turn.second)):
            continue  # its tangent is a quotient of components
        line = _by_ratio(scene, equation, turn) if ratio else _by_angle(scene, equation, turn)
        if line is not None:
            return line
        scene.desk.back(mark)
    return None


def _as_a_turn(scene: Scene, asked: Quantity) -> Quantity:
    """The deflection that an angle to **i** or **j** is, of a body that came in that direction."""
    match asked:
        case Quantity("angle", (Quantity("velocity", (Name(body),), int(event)), Unit(axis))):
            fact = scene.facts.get(f"velocity {body}")
            early = None if fact is None else direction_from_i(fact.relation.only[0].right)
            came = {"i": Degrees(Fraction(0)), "j": RIGHT}[axis]
            if early == came and event and not scene.last_event(body, event - 1):
                return Quantity("deflection", (Name(body),), event)
    return asked


def _by_angle(scene: Scene, equation: GivenEquation, turn: Turn) -> int | None:
    value, refs = scene.put(scene.scalar(equation.link.right))
    given = together(equation.refs, refs)
    angles = [side.angle for side in (turn.first, turn.second)]
    right = equation.link.right if not refs else tree_of(value, angle=True)
    mark = scene.desk.mark()
    line = _one_angle(scene, equation, turn, right, value)
    if line is not None:
        return line
    scene.desk.back(mark)
    if None not in angles:
        relation = chain(turn.made_of(*angles), (right, None))
        return made_of_angles(scene, turn, relation, given)
    if scene.model.identically_zero(sp.cos(value)):
        return None
    ratio, more = scene.put(tangent_of_angle(value))
    if not ratio.free_symbols:
        own = Term(right, tree_of(tidy(ratio)), more if isinstance(right, Letter) else ())
        line = by_the_known(scene, turn, own, ratio, given)
        if line is not None:
            return line
    if any(map(partial(_is_across, scene), (turn.first, turn.second))):
        return None  # of a right angle there is no tangent
    open_ = any(is_along_a_letter(scene, side) for side in (turn.first, turn.second))
    if open_ and (ratio.free_symbols or tidy(ratio).has(sp.sqrt(2), sp.sqrt(3))):
        return None  # a component in the letters of both angles, or with roots, is not worked out
    line = write_given_cosine(scene, equation, turn.asked)
    if line is not None:
        return line
    scene.desk.back(mark)
    terms = terms_of(scene, turn)
    if terms is None:
        return None
    relation = chain(turn.made_of(*(own.angle for own in terms)), (right, None))
    number = made_of_angles(scene, turn, relation, given)
    if number is None:
        return None
    doubled = _as_its_double(scene, turn, terms, right, number)
    if doubled is not None:
        return doubled
    tangent, more = scene.put(tangent_of_angle(value))
    if more:
        put = (tree_of(tangent), more)
        return by_tangents(scene, number, turn.form, terms, Apply("tan", right), put)
    return by_tangents(scene, number, turn.form, terms, tree_of(tidy(tangent)))


def _as_its_double(
    scene: Scene, turn: Turn, terms: tuple[Term, Term], right: Expression, number: int
) -> int | None:
    """The equation of ``β − α = α``, which says that β is 2α; None of another turn."""
    own, other = terms
    if turn.form != "difference" or not isinstance(right, Letter) or other.angle != right:
        return None
    mark = scene.desk.mark()
    twice = chain(own.angle, (product(TWO, right), None))
    line = scene.judge.write((Move("rearrange"),), (number,), twice)
    tangents = Apply("tan", own.angle), Apply("tan", right)
    double = Binary("/", product(TWO, tangents[1]), difference(ONE, square(tangents[1])))
    known = (*background(scene, letters(own.angle) | letters(right)), *meeting(scene))
    for move, pool, relation in (
        (Move("identity", "double-angle"), (), chain(tangents[0], (double, None))),
        (Move("put"), own.refs, chain(own.tangent, (double, None))),
    ):
        if line is None:
            break
        refs = scene.judge.enough(move, (line, *pool), relation, known)
        line = None if refs is None else scene.desk.write(move, refs, relation)
    if line is None:
        scene.desk.back(mark)
    return line


def _is_across(scene: Scene, side: Direction) -> bool:
    """Whether a velocity turns out to have no component along the line of centres."""
    along = sp.sympify(side.along.value, strict=True)
    return scene.model.identically_zero(scene.model.in_data(along))


def _by_ratio(scene: Scene, equation: GivenEquation, turn: Turn) -> int | None:
    terms = terms_of(scene, turn)
    if terms is None:
        return None
    letter, meaning = letter_of(scene, turn.asked)
    ratio, more = scene.put(scene.scalar(equation.link.right))
    if not ratio.free_symbols:
        own = Term(Letter(letter), tree_of(ratio), together(equation.refs, more, (meaning,)))
        line = by_the_known(scene, turn, own, ratio, (meaning,))
        if line is not None:
            return line
    relation = chain(Letter(letter), (turn.made_of(*(own.angle for own in terms)), None))
    number = made_of_angles(scene, turn, relation, ())
    if number is None:
        return None
    value, refs = scene.put(scene.scalar(equation.link.right))
    tangent = Apply("tan", Letter(letter))
    given = together(equation.refs, refs, (letter_of(scene, turn.asked)[1],))
    return by_tangents(scene, number, turn.form, terms, tangent, (tree_of(value), given))


def _one_angle(
    scene: Scene, equation: GivenEquation, turn: Turn, given: Expression, value: Any
) -> int | None:
    """The one angle that is not told, as a number of degrees, and what that says of components."""
    sides: Sequence[Direction] = (turn.first, turn.second)
    own = [e for e in sides if e.angle is None] or [
        e for e in sides if isinstance(e.angle, Letter) and scene.unknown(scene.scalar(e.angle))
    ]
    data = [e for e in own if _at_whole_degrees(scene, e) is not None]
    is_by_lines = len(own) == len(sides) and len(data) == 1
    if is_by_lines:
        # One velocity is given as a vector: its angle has lines of its own.
        by_lines = _by_components(scene, data[0])
        sides = [by_lines if e is data[0] else e for e in sides]
        own = [e for e in sides if e is not by_lines]
    if len(own) != 1:
        return None
    (side,) = own
    (other,) = (e.angle for e in sides if e is not side)
    rest = sp.Integer(0) if other is None else scene.scalar(other)
    if other is None or (
        rest.free_symbols != value.free_symbols and (scene.unknown(value) or scene.unknown(rest))
    ):
        return None
    first = side is turn.first
    tree, _, _ = other_angle(turn, first, given, other)
    if other == NONE:
        return None
    worth = {
        "sum": value - rest,
        "difference": value + rest if first else rest - value,
        "rest of sum": sp.pi - value - rest,
        "rest of difference": sp.pi + rest - value if first else value + rest - sp.pi,
    }[turn.form]
    final = tree_of(tidy(worth), angle=True)
    if isinstance(final, Degrees):
        if not 0 <= worth <= sp.pi:
            return None  # an angle between directions is at most 180°
    elif scene.unknown(worth) or not (isinstance(other, Degrees) or _is_complement(final)):
        return None
    named: tuple[Ref, ...] = ()
    subject = side.angle
    if subject is None:
        letter, meaning = letter_of(scene, side.named)
        subject, named = Letter(letter), (meaning,)
    relation = chain(subject, (tree, None), (final, "rearrange"))
    refs = [ref for own in sides for ref in own.sources]
    pool = dict.fromkeys(
        (
            *equation.refs,
            *named,
            *refs,
            *turn.first.refs,
            *turn.second.refs,
            *turn.pushed,
            *turn.frame.refs,
            f"velocity {_body(side)}",  # from its direction an angle may be given
        )
    )
    pool = dict.fromkeys(ref for ref in pool if isinstance(ref, int) or ref in scene.facts)
    premises = scene.judge.needed(turn.move, pool, relation, (*equation.refs, *named))
    if premises is None:
        return None
    line = scene.desk.write(turn.move, premises, relation)
    if side.angle is not None or _is_in_its_letter(scene, side, subject):
        return line
    return _of_components(scene, turn, side, line, final)


def _is_complement(angle: Expression) -> bool:
    """Whether an angle is what a letter leaves of a right angle, so that its tangent is plain."""
    return isinstance(angle, Binary) and (angle.op, angle.left) == ("-", RIGHT)


def _is_in_its_letter(scene: Scene, side: Direction, subject: Expression) -> bool:
    """Whether components are written in the letter for their angle, which is an unknown."""
    if not isinstance(subject, Letter):
        return False
    symbol = scene.model.unknowns.letter(subject.name)
    ratio = sp.sympify(side.across.value / side.along.value, strict=True)
    return symbol in scene.unknown(ratio) and tidy(ratio**2 - sp.tan(symbol) ** 2) == 0


def _at_whole_degrees(scene: Scene, side: Direction) -> Degrees | None:
    """The angle to the line of centres of a velocity of the data that has whole degrees.

    None of one that goes back along an axis: its angle to that may be another one.
    """
    along, across = (sp.sympify(source.value, strict=True) for source in (side.along, side.across))
    if side.velocity.stage or side.angle is not None or along.is_zero is not False:
        return None
    slope = tidy(across / along)
    forth = slope.is_positive or scene.model.sign(along) > 0
    if not slope.is_number or not (
        forth or is_quantity(side.named.arguments[1], "line_of_centres")
    ):
        return None
    return _in_degrees(sp.atan(abs(slope)))


def _in_degrees(angle: sp.Expr) -> Degrees | None:
    tree = tree_of(tidy(angle), angle=True)
    return tree if isinstance(tree, Degrees) else None


def _by_components(scene: Scene, side: Direction) -> Direction:
    """A direction of the data with its angle, which lines give by its components."""
    line = angle_of_an_offset(scene, side.named) or angle_line(scene, side.named)
    _, meaning = letter_of(scene, side.named)
    return replace(side, angle=_at_whole_degrees(scene, side), sources=(meaning, line))


def _body(side: Direction) -> str:
    (body,) = side.velocity.arguments
    return str(getattr(body, "name", ""))


def _of_components(
    scene: Scene, turn: Turn, side: Direction, line: int, angle: Expression
) -> int | None:
    """What an angle to the line of centres says of components: a tangent, or one that is 0."""
    _, meaning = letter_of(scene, side.named)
    bodies = (_body(side),)
    axis = turn.frame.refs
    if angle == RIGHT:
        move = Move("define", "perpendicular", turn.frame.number, bodies)
        relation: Relation = chain(tree_of(side.along.value), (ZERO, None))
        pool = (line, meaning, *side.along.refs, *axis)
        refs = scene.judge.needed(move, pool, relation)
        return None if refs is None else scene.desk.write(move, refs, relation)
    own = formula(scene, side.named)
    relation = chain(Apply("tan", angle), (swept(own.right), None))
    names = {str(symbol) for symbol in sp.sympify(own.value, strict=True).free_symbols}
    first = line, meaning, *own.refs
    refs = scene.judge.enough(own.move, first, relation, (*axis, *background(scene, names)))
    refs = refs or scene.judge.enough(own.move, together(first, side.sources), relation)
    if refs is None:
        return None
    written = scene.desk.write(own.move, refs, relation)
    return _with_its_number(scene, written, angle) or written


def _with_its_number(scene: Scene, line: int, angle: Expression) -> int | None:
    """A line of the tangent of a sum with the number that this is: tan(45° + arctan ⅓) = 2.

    None where it is no quotient of whole numbers, or the angle is a number of degrees.
    """
    match angle:
        case Binary("+" | "-" as sign, one, other) if not letters(angle):
            tangents = [tidy(tangent_of_angle(scene.scalar(tree))) for tree in (one, other)]
        case _:
            return None
    value = tidy(tangent_of_angle(scene.scalar(angle)))
    if not all(number.is_Rational for number in (value, *tangents)):
        return None
    first, second = map(tree_of, tangents)
    opposite: Literal["+", "-"] = "-" if sign == "+" else "+"
    below = Binary(opposite, ONE, product(first, second))
    quotient = swept(Binary("/", Binary(sign, first, second), below))
    steps = ((quotient, None), (tree_of(value), "rearrange"))
    known = chain(Apply("tan", angle), *steps)  # type: ignore[arg-type]
    formula_ = scene.judge.write((Move("identity", "sum-of-angles"),), (), known)
    if formula_ is None:
        return None
    right = scene.desk.last_link(line).right
    relation = chain(tree_of(value), (right, None))
    return scene.judge.write((Move("put"),), (line, formula_), relation)
