"""A deflection at a wall that is given: the angle to the wall afterwards, less that before."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Name,
    Quantity,
    has_root,
    letters,
)
from restitution.planning.angles.along_lines import angle_along_the_centres
from restitution.planning.angles.turn_lines import Term, by_tangents
from restitution.planning.angles.turning import angle_line
from restitution.planning.angles.wall_turns import named_at_a_wall, terms_at_a_wall
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import in_tangents, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import GivenEquation, Scene


def given_by_the_angle_after(
    scene: Scene, equation: GivenEquation, body: Name, frame: Frame, given: Source
) -> int | None:
    """The equation for the tangent of the angle after a wall, of a velocity that the data resolve.

    The path before has its angle to the wall by components, α with tan α = 5/7. A deflection of
    60° leaves 60° − α for the path afterwards: in numbers that is an angle in degrees, and in
    letters it has the tangent of a difference. None where it is no acute angle.
    """
    turned = given.value
    if scene.unknown(turned) or frame.wall is None:
        return None
    mark = scene.desk.mark()
    line = _by_the_line_of_centres(scene, equation, body, frame, given)
    if line is not None:
        return line
    before = named_at_a_wall(scene, body, frame, frame.number - 1)
    if before is not None and _is_left(scene, turned, Apply("arctan", before[0].tangent)):
        early, named = before
        inverse = _in_numbers(scene, turned, early)
        after = named_at_a_wall(scene, body, frame, frame.number)
        if after is not None:
            late, meaning = after
            whole = _as_it_is_given(equation.link.right, turned)
            move = Move("define", "sum", frame.number, (body.name,))
            pool = together(given.refs, named, meaning)
            if inverse is not None:
                line = _in_degrees(scene, move, (*pool, inverse), whole, (inverse, late))
            else:
                line = _by_a_difference(scene, move, pool, (whole, turned), (early, late))
    if line is None:
        scene.desk.back(mark)
    return line


def _by_the_line_of_centres(
    scene: Scene, equation: GivenEquation, body: Name, frame: Frame, given: Source
) -> int | None:
    """The same of a sphere that another one set in motion: its line of centres tells the angle.

    It comes at 45° to the wall, so a deflection of 75° leaves 30°. None of another path.
    """
    last = scene.last_event(body.name, frame.number - 1)
    if not last or frame.wall is None or given.value.free_symbols:
        return None
    mark, line = scene.desk.mark(), None
    early = Quantity("angle", (Quantity("velocity", (body,), last), Name(frame.wall)))
    number = angle_along_the_centres(scene, early)
    if number is not None and _is_left(scene, given.value, scene.desk.last_link(number).right):
        after = named_at_a_wall(scene, body, frame, frame.number)
        if after is not None:
            late, meaning = after
            whole = _as_it_is_given(equation.link.right, given.value)
            move = Move("define", "sum", frame.number, (body.name,))
            pool = together(given.refs, meaning, (number,))
            line = _in_degrees(scene, move, pool, whole, (number, late))
    if line is None:
        scene.desk.back(mark)
    return line


def _is_left(scene: Scene, turned: sp.Expr, angle: Expression) -> bool:
    """Whether a deflection leaves an acute angle, once another angle is taken off."""
    rest = scene.model.in_data(turned - scene.scalar(angle))
    if scene.unknown(rest):
        return False
    return scene.model.sign(rest) >= 0 > scene.model.sign(rest - sp.pi / 2)


def _in_numbers(scene: Scene, turned: sp.Expr, early: Term) -> int | None:
    """The line of the angle before in degrees, where that after is better told in degrees as well.

    None where letters stand in them. Of an angle before that is no number of degrees, None too
    where a fraction is the tangent of what is left, or the question is not one in decimals.
    """
    angle = scene.desk.meant(early.angle)
    before = sp.atan(scene.scalar(early.tangent))
    rest = turned - before
    if rest.free_symbols:
        return None
    if not isinstance(tree_of(tidy(before), angle=True), Degrees) and (
        not is_for_a_calculator(scene) or tidy(tangent_of_angle(rest)).is_Rational
    ):
        return None
    assert isinstance(angle, Quantity)
    return angle_line(scene, angle)


def is_for_a_calculator(scene: Scene) -> bool:
    """Whether velocities are numbers, and the question has no roots: decimals are expected."""
    facts = [fact for fact in scene.facts.values() if fact.kind != "geometry"]
    velocities = [fact.relation for fact in facts if fact.id.startswith("velocity")]
    in_numbers = not any(letters(tree) for relation in velocities for tree in relation.trees)
    return in_numbers and not any(has_root(tree) for fact in facts for tree in fact.relation.trees)


def _in_degrees(
    scene: Scene,
    move: Move,
    pool: tuple[Ref, ...],
    whole: Expression,
    angles: tuple[int, Term],
) -> int | None:
    """By both angles in degrees: ``5e/7 = tan(60° − arctan(5/7))``, and what that is exactly.

    ``angles`` are the line of the one before, and the one after with its tangent.
    """
    number, late = angles
    rest: Expression = Binary("-", whole, scene.desk.last_link(number).right)
    relation = chain(late.angle, (rest, None))
    degrees = tree_of(tidy(scene.scalar(rest)), angle=True)
    if isinstance(degrees, Degrees):
        relation, rest = chain(late.angle, (rest, None), (degrees, "rearrange")), degrees
    line = scene.judge.write((move,), pool, relation)
    if line is None:
        return None
    tangent = Apply("tan", rest)
    if isinstance(rest, Degrees):
        equation = chain(tangent, (late.tangent, None))
        return scene.judge.write((Move("put"),), (*late.refs, line), equation)
    value = tree_of(in_tangents(tidy(tangent_of_angle(scene.scalar(rest)))))
    equation = chain(late.tangent, (tangent, None), (value, "identity"))
    return scene.judge.write((Move("put", "sum-of-angles"),), (*late.refs, line), equation)


def _by_a_difference(
    scene: Scene,
    move: Move,
    pool: tuple[Ref, ...],
    given: tuple[Expression, sp.Expr],
    terms: tuple[Term, Term],
) -> int | None:
    """By the tangents of both angles, and what the formula makes of these."""
    (whole, turned), (early, late) = given, terms
    relation = chain(late.angle, (Binary("-", whole, early.angle), None))
    line = scene.judge.write((move,), pool, relation)
    pair = Term(whole, tree_of(tidy(tangent_of_angle(turned)))), early
    known = line and by_tangents(scene, line, "difference", pair, Apply("tan", late.angle))
    if not known:
        return None
    relation = chain(late.tangent, (scene.desk.last_link(known).right, None))
    return scene.judge.write((Move("put"),), (known, *late.refs), relation)


def given_by_the_sum(
    scene: Scene, equation: GivenEquation, body: Name, frame: Frame, given: Source
) -> int | None:
    """The equation for the tangent of a deflection at a wall, by those of both angles to the wall.

    It is for what holds unknowns before the wall, or is unknown itself. None where an angle has no
    tangent.
    """
    mark, turned = scene.desk.mark(), given.value
    both = terms_at_a_wall(scene, body, frame)
    line = None
    is_open = both is not None and (
        scene.unknown(turned) or scene.unknown(scene.scalar(both[0][0].tangent))
    )
    if both is not None and is_open:
        (early, named), (late, meaning) = both
        whole = _as_it_is_given(equation.link.right, turned)
        total = chain(Binary("+", early.angle, late.angle), (whole, None))
        move = Move("define", "sum", frame.number, (body.name,))
        line = scene.judge.write((move,), together(given.refs, named, meaning), total)
    if both is not None and line is not None:
        tangent = tree_of(tidy(tangent_of_angle(turned)))
        line = by_tangents(scene, line, "sum", (early, late), tangent)
    if line is None:
        scene.desk.back(mark)
    return line


def _as_it_is_given(right: Expression, turned: sp.Expr) -> Expression:
    """A deflection as the fact has it, or as its number of degrees."""
    degrees = tree_of(turned, angle=True)
    return degrees if isinstance(degrees, Degrees) else right
