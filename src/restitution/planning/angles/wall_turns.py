"""Deflections at a wall: the angles of the path to it before and after, added."""

from __future__ import annotations

import math
from collections.abc import Iterable

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Move, Ref
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import Term, by_tangents, term_of_data
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_of, tangent_line
from restitution.planning.formulas.turns import Form
from restitution.planning.writing.angles import angle_of_approach, data_of_approach
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import TWO, product, swept, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def tangent_at_a_wall(scene: Scene, asked: Quantity, frame: Frame) -> int | None:
    """The tangent of a deflection from those of the angles to the wall; None where they are none.

    The last line is ``tan(δ) = … = …``, with a letter for the deflection.
    """
    mark = scene.desk.mark()
    own = sum_at_a_wall(scene, asked, frame)
    if own is None:
        return None
    turned, _ = letter_of(scene, asked)
    number = by_tangents(scene, own[0], "sum", own[1], Apply("tan", Letter(turned)))
    if number is None:
        scene.desk.back(mark)
    return number


def given_tangent_at_a_wall(scene: Scene, equation: GivenEquation) -> int | None:
    """The equation of the tangent of a deflection that is given, by those of the angles to a wall.

    None of what is no impact with a wall, or where the path has no angle to that; nor where e
    comes to less than 0, with which the path goes on through the wall.
    """
    match equation.link.left:
        case Apply("tan", Quantity("deflection", (Name(body),), int(event)) as asked):
            frame = scene.frame(event) if event in scene.model.frames else None
        case _:
            return None
    if frame is None or frame.wall is None or goes_on(scene, body, frame):
        return None
    mark = scene.desk.mark()
    own = sum_at_a_wall(scene, asked, frame)
    if own is None:
        return None
    turned, meaning = letter_of(scene, asked)
    value, refs = scene.put(scene.scalar(equation.link.right))
    put = tree_of(value), together(equation.refs, refs, (meaning,))
    number = by_tangents(scene, own[0], "sum", own[1], Apply("tan", Letter(turned)), put)
    if number is None:
        scene.desk.back(mark)
    return number


def goes_on(scene: Scene, body: str, frame: Frame) -> bool:
    """Whether a path goes on through a wall, as it does with a coefficient below 0."""
    stages = frame.number - 1, frame.number
    both = (in_direction(scene, "along", body, stage, frame).value for stage in stages)
    return math.prod(map(scene.model.sign, both)) > 0


def sum_at_a_wall(
    scene: Scene, asked: Quantity, frame: Frame
) -> tuple[int, tuple[Term, Term]] | None:
    """The line that adds the angles to a wall before and after, with their tangents.

    That before has a letter where it is not given as one or in degrees. None where the velocity
    before has no component towards the wall, or none along it.
    """
    (name,) = asked.arguments
    assert isinstance(name, Name)
    both = terms_at_a_wall(scene, name, frame)
    if both is None:
        return None
    (before, refs), (after, more) = both
    turned, meaning = letter_of(scene, asked)
    relation = chain(Letter(turned), (Binary("+", before.angle, after.angle), None))
    move = Move("define", "sum", frame.number, (name.name,))
    number = scene.judge.write((move,), together(refs, more, (meaning,)), relation)
    return None if number is None else (number, (before, after))


Named = tuple[Term, tuple[Ref, ...]]
"""An angle to a wall with its tangent, and what says which angle it is."""


def terms_at_a_wall(scene: Scene, name: Name, frame: Frame) -> tuple[Named, Named] | None:
    """The angles to a wall before and after, with their tangents; None where one has none."""
    if frame.wall is None:
        return None
    angle = angle_of_approach(scene, name.name, frame)
    early: Named | None
    if angle is not None:
        early = term_of_data(scene, angle), data_of_approach(scene, name.name, frame)
    else:
        early = named_at_a_wall(scene, name, frame, frame.number - 1)
    late = None if early is None else named_at_a_wall(scene, name, frame, frame.number)
    return None if early is None or late is None else (early, late)


def named_at_a_wall(scene: Scene, name: Name, frame: Frame, stage: int) -> Named | None:
    """The angle of a path to a wall by its letter, with its tangent, and what that letter is."""
    assert frame.wall is not None
    velocity = Quantity("velocity", (name,), scene.last_event(name.name, stage))
    angle = Quantity("angle", (velocity, Name(frame.wall)))
    try:
        own = formula(scene, angle)
    except NotPlannedError:
        return None
    line, letter = tangent_line(scene, angle, own, own.move)
    value = scene.desk.last_link(line).right
    return Term(Letter(letter), value, (line,)), (letter_of(scene, angle)[1],)


def given_at_a_wall(
    scene: Scene, equation: GivenEquation, body: str, frame: Frame, turned: sp.Expr
) -> int | None:
    """At a wall the angles to it before and after make the deflection: an equation in tangents.

    None where the angle at which the body comes is not given as one to the wall, or is no letter
    and no number of degrees.
    """
    event = frame.number
    angle = angle_of_approach(scene, body, frame)
    if angle is None:
        return None
    assert frame.wall is not None
    wall, data = frame.wall, data_of_approach(scene, body, frame)
    after = Quantity("angle", (Quantity("velocity", (Name(body),), event), Name(wall)))
    move = Move("define", "sum", event, (body,))
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, after)
    own = formula(scene, after)
    cited = together(equation.refs, data, (meaning,))
    worth = scene.desk.known(angle) if isinstance(angle, Letter) else None
    degrees = None if worth is None else tree_of(worth.value, angle=True)
    if worth is not None and isinstance(degrees, Degrees):
        angle, cited = degrees, together(cited, worth.refs)
    if isinstance(angle, Degrees) or turned.free_symbols:
        rest = tidy(turned - scene.scalar(angle))
        final = tree_of(rest, angle=True)
        right = Binary("-", equation.link.right, angle)
        shorter = isinstance(final, Degrees) or _mentions(final) < _mentions(right)
        final = final if shorter else right
        relation = chain(Letter(letter), (right, None))
        if shorter:
            relation = chain(Letter(letter), (right, None), (final, "rearrange"))
        premises = scene.judge.enough(move, cited, relation)
        if premises is not None:
            line = scene.desk.write(move, premises, relation)
            known = (*data, *background(scene, letters(angle)))
            tangent = _tangent(scene, own, final, (line, meaning), known)
            if tangent is not None:
                return tangent
        scene.desk.back(mark)
        return None
    line, _ = tangent_line(scene, after, own, own.move)
    sides = Binary("+", angle, Letter(letter))
    relation = chain(sides, (equation.link.right, None))
    premises = scene.judge.enough(move, cited, relation)
    if premises is not None:
        number = scene.desk.write(move, premises, relation)
        value = scene.desk.last_link(line).right
        terms = (term_of_data(scene, angle), Term(Letter(letter), value, (line,)))
        number_ = by_tangents(scene, number, "sum", terms, tree_of(tidy(tangent_of_angle(turned))))
        if number_ is not None:
            return number_
    scene.desk.back(mark)
    return None


def _tangent(
    scene: Scene, own: Formula, angle: Expression, refs: tuple[Ref, ...], known: Iterable[Ref]
) -> int | None:
    """The tangent of an angle to a wall by its components; of 0° it is 0, whatever their sense."""
    is_zero = scene.scalar(angle) == 0
    quotient = unsigned(swept(own.right)) if is_zero else swept(own.right)
    relation = chain(Apply("tan", angle), (quotient, None))
    premises = scene.judge.enough(own.move, (*refs, *own.refs), relation, known)
    if premises is not None and is_zero:
        premises = scene.judge.needed(own.move, premises, relation)  # no component away from it
    return None if premises is None else scene.desk.write(own.move, premises, relation)


def _mentions(tree: Expression) -> int:
    """How many times letters stand in a tree."""
    return sum(isinstance(node, Letter) for node in walk(tree))


def related_at_a_wall(scene: Scene, equation: GivenEquation) -> int | None:
    """A deflection at a wall, α + β, that is given by these angles: as 2β, or as 2β + 30°.

    So one of the two is the other, or differs from it by a number; where α is a number of degrees
    so is β. The last line is that of their tangents. None where the fact is no such one.
    """
    match equation.link.left:
        case Quantity("deflection", (Name(body),), int(event)) if event in scene.model.frames:
            pass
        case _:
            return None
    frame = scene.frame(event)
    if frame.wall is None:
        return None
    angle = angle_of_approach(scene, body, frame)
    after, early = (
        Quantity("angle", (Quantity("velocity", (Name(body),), stage), Name(frame.wall)))
        for stage in (event, scene.last_event(body, event - 1))
    )
    if isinstance(angle, Degrees):
        return _related_to_degrees(scene, equation, angle, after)
    if angle is not None and not isinstance(angle, Letter):
        return None
    pair = (early if angle is None else angle, after)
    more = _excess(scene, equation.link.right, pair)
    times = _multiple(scene, equation.link.right, pair) if more is None else None
    if more is None and times is None:
        return None
    mark = scene.desk.mark()
    first: Named | None
    if angle is not None:
        first = Term(angle, Apply("tan", angle)), data_of_approach(scene, body, frame)
    else:
        first = named_at_a_wall(scene, Name(body), frame, event - 1)
    if first is None:
        scene.desk.back(mark)
        return None
    term, data = first
    own = formula(scene, after)
    line, name = tangent_line(scene, after, own, own.move)
    letter, (_, meaning) = Letter(name), letter_of(scene, after)
    total = chain(
        Binary("+", term.angle, letter),
        (exchanged(equation.link.right, {after: letter, early: term.angle}), None),
    )
    move = Move("define", "sum", event, (body,))
    premises = scene.judge.enough(move, together(equation.refs, data, (meaning,)), total)
    number = None
    if premises is not None:
        number = scene.desk.write(move, premises, total)
        if more is not None:
            number = _by_one_of_them(scene, number, (term, letter), more, line)
        elif times is not None and term.refs:
            number = _by_twice_the_other(scene, number, (term, letter), times, line)
        elif times is not None:
            number = _by_its_multiple(scene, number, (term.angle, letter), times, line)
    if number is None:
        scene.desk.back(mark)
    return number


def _related_to_degrees(
    scene: Scene, equation: GivenEquation, angle: Degrees, after: Quantity
) -> int | None:
    """The same where the angle before is a number of degrees: 30° + β = 2β, so β = 30°."""
    match equation.link.left, after.arguments:
        case Quantity("deflection", (Name(body),), int(event)), (_, Name()):
            pass
        case _:
            return None
    later = sp.Symbol("later")
    tree = exchanged(equation.link.right, {after: Letter(later.name)})
    if has_quantity(tree) or letters(tree) != {later.name}:
        return None
    rest = expanded(scene.worth(tree, {later.name: later}) - later - scene.scalar(angle))
    slope = rest.coeff(later)
    if not slope.is_number or slope == 0 or expanded(rest - slope * later).free_symbols:
        return None
    worth = tree_of(tidy(later - rest / slope), angle=True)
    if not isinstance(worth, Degrees):
        return None
    mark, frame = scene.desk.mark(), scene.frame(event)
    own = formula(scene, after)
    letter, meaning = letter_of(scene, after)
    total = chain(
        Binary("+", angle, Letter(letter)),
        (exchanged(equation.link.right, {after: Letter(letter)}), None),
    )
    data = data_of_approach(scene, body, frame)
    move, pool = Move("define", "sum", event, (body,)), together(equation.refs, data, (meaning,))
    line = scene.judge.write((move,), pool, total)
    known = chain(Letter(letter), (worth, None))
    value = line and scene.judge.write((Move("rearrange"),), (line,), known)
    if value:
        tangent = _tangent(scene, own, worth, (value, meaning), data)
        if tangent is not None:
            return tangent
    scene.desk.back(mark)
    return None


def _excess(scene: Scene, right: Expression, angles: tuple[Expression, Quantity]) -> sp.Expr | None:
    """How much more an angle after is than that before, where both add up to an expression.

    None where that is no number.
    """
    before, later = sp.Symbol("before"), sp.Symbol("later")
    rest = _rest(scene, right, angles, before, later)
    if rest is None:
        return None
    either = (expanded(sign * rest + later - before) for sign in (1, -1))
    return next((more for more in either if more.is_number), None)


def _multiple(
    scene: Scene, right: Expression, angles: tuple[Expression, Quantity]
) -> sp.Rational | None:
    """Which multiple of an angle before that after is, where both add up to an expression."""
    before, later = sp.Symbol("before"), sp.Symbol("later")
    rest = _rest(scene, right, angles, before, later)
    if rest is None or rest.subs({before: 0, later: 0}) != 0 or not rest.coeff(later):
        return None
    times = -rest.coeff(before) / rest.coeff(later)
    is_multiple = (
        times.is_Rational and times > 0 and expanded(rest.subs(later, times * before)) == 0
    )
    return times if is_multiple else None


def _rest(
    scene: Scene,
    right: Expression,
    angles: tuple[Expression, Quantity],
    before: sp.Symbol,
    later: sp.Symbol,
) -> sp.Expr | None:
    """An expression of two angles less both of them; None with anything else in it."""
    angle, after = angles
    tree = exchanged(right, {after: Letter(later.name), angle: Letter(before.name)})
    if has_quantity(tree) or letters(tree) - {before.name, later.name}:
        return None
    value = scene.worth(tree, {before.name: before, later.name: later})
    return expanded(value - before - later)


def _by_its_multiple(
    scene: Scene, number: int, angles: tuple[Expression, Letter], times: sp.Rational, line: int
) -> int | None:
    """The tangent of an angle after a wall, as one of a multiple of that before."""
    (before, after), value = angles, scene.desk.last_link(line).right
    multiple = tree_of(times * scene.scalar(before))
    relation = chain(after, (multiple, None))
    if not scene.judge.follows(Move("rearrange"), (number,), relation):
        return None
    number = scene.desk.write(Move("rearrange"), (number,), relation)
    tangents = chain(Apply("tan", multiple), (value, None))
    if scene.judge.follows(Move("put"), (line, number), tangents):
        return scene.desk.write(Move("put"), (line, number), tangents)
    return None


def _by_twice_the_other(
    scene: Scene, number: int, angles: tuple[Term, Letter], times: sp.Rational, line: int
) -> int | None:
    """The tangents of two angles of which one is twice the other; None of another multiple."""
    before, after = angles[0], Term(angles[1], scene.desk.last_link(line).right, (line,))
    if times not in (2, 1 / sp.Integer(2)):
        return None
    once, twice = (before, after) if times == 2 else (after, before)
    relation = chain(twice.angle, (product(TWO, once.angle), None))
    if not scene.judge.follows(Move("rearrange"), (number,), relation):
        return None
    number = scene.desk.write(Move("rearrange"), (number,), relation)
    given = twice.tangent, twice.refs
    return by_tangents(scene, number, "sum", (once, once), Apply("tan", twice.angle), given)


def _by_one_of_them(
    scene: Scene, number: int, angles: tuple[Term, Letter], more: sp.Expr, line: int
) -> int | None:
    """The tangents of both angles, of which a line gives the sum and ``more`` is the difference."""
    (term, after), value = angles, scene.desk.last_link(line).right
    before = term.angle
    size = tree_of(tidy(abs(more)), angle=True)
    plus = bool(more > 0)
    right = before if more == 0 else Binary("+" if plus else "-", before, size)
    relation = chain(after, (right, None))
    if not scene.judge.follows(Move("rearrange"), (number,), relation):
        return None
    number = scene.desk.write(Move("rearrange"), (number,), relation)
    if more == 0:
        tangents = chain(term.tangent, (value, None))
        refs = (line, number, *term.refs)
        if scene.judge.follows(Move("put"), refs, tangents):
            return scene.desk.write(Move("put"), refs, tangents)
        return None
    terms = term, term_of_data(scene, size)
    form: Form = "sum" if plus else "difference"
    return by_tangents(scene, number, form, terms, Apply("tan", after), (value, (line,)))
