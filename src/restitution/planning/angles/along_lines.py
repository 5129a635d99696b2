"""Angles of spheres that move along lines of centres of which the directions are told by angles."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from restitution.exact import tidy
from restitution.explaining.definitions.turnings import direction_from_i
from restitution.explaining.lines.derivation import Move, Ref
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    has_quantity,
    is_quantity,
    letters,
)
from restitution.oracle.roles import ACUTE
from restitution.planning.angles.directions import along_the_centres, angle_of_the_line
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.angles import RIGHT
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.premises import nonzero
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass


@dataclass(frozen=True)
class _Turn:
    """The angle of a direction from **i**, and what tells it; a wall points both ways."""

    angle: Expression
    refs: tuple[Ref, ...] = ()
    both_ways: bool = False


def angle_along_the_centres(scene: Scene, asked: Quantity) -> int | None:
    """The line of an angle that a sphere which moves along a line of centres makes with a line.

    That is **i** or **j**, a wall, another line of centres, a velocity at the start along **i** or
    **j**, or that of another such sphere: the angle is the difference of their directions. None of
    another angle.
    """
    match asked:
        case Quantity("angle", (one, other)):
            moving = [tree for tree in (one, other) if is_quantity(tree, "velocity")]
        case _:
            return None
    mark = scene.desk.mark()
    slants = any(isinstance(_along(scene, tree), Degrees) for tree in (one, other))
    turns = [_turn(scene, tree, slants=slants) for tree in (one, other)] if moving else []
    known = [turn for turn in turns if turn is not None]
    angle = _between(scene, *known) if len(known) == len(turns) > 0 else None
    if angle is not None:
        steps = _steps(scene, angle)
        bodies = [body_and_stage(scene, tree) for tree in moving]
        record = "perpendicular" if steps[-1] == RIGHT else "parallel"
        record = record if any(stage for _, stage in bodies) else "difference"
        names = tuple(dict.fromkeys(body for body, _ in bodies))
        move = Move("define", record, max(stage for _, stage in bodies) or None, names)
        relation = chain(asked, *zip(steps, (None, "rearrange"), strict=False))
        premises = scene.judge.needed(move, together(*(turn.refs for turn in known)), relation)
        if premises is not None:
            return scene.desk.write(move, premises, relation)
    scene.desk.back(mark)
    return None


def given_along_the_centres(scene: Scene, given: GivenEquation) -> int | None:
    """The letter for a line of centres by the direction that is given of who goes along it.

    It is given from **i**, or as an angle to another direction, or by a ratio of that. None of
    another fact.
    """
    subject, right = given.link.left, given.link.right
    match subject:
        case Quantity("direction" | "angle") as asked:
            pass
        case Apply("sin" | "cos" | "tan", Quantity("direction" | "angle") as asked):
            pass
        case _:
            return None
    if letters(right) or has_quantity(right):
        return None
    mark, frames = scene.desk.mark(), dict(scene.frames)
    try:
        of_direction = asked.kind == "direction"
        write = along_the_centres if of_direction else angle_along_the_centres
        line = write(scene, asked)
    except NotPlannedError:
        line = None
    angle = ZERO if line is None else scene.desk.last_link(line).right
    kinds = Letter | Binary | Negate
    if line is not None and letters(angle) and isinstance(angle, kinds):
        relation = chain(exchanged(subject, {asked: angle}), (right, None))
        for refs in ((line, *given.refs), (*given.refs, line)):
            if (put := scene.judge.write((Move("put"),), refs, relation)) is not None:
                return put
    scene.desk.back(mark)
    scene.frames = frames
    return None


def _steps(scene: Scene, angle: Expression) -> tuple[Expression, ...]:
    """A difference of angles, and what it comes to where both are in degrees."""
    if not isinstance(angle, Binary) or letters(angle):
        return (angle,)
    return angle, tree_of(tidy(scene.scalar(angle)), angle=True)


def _along(scene: Scene, line: Expression) -> Expression | None:
    """The direction of a wall, or of a line of centres, as it is given; None of another tree."""
    ref = _fact_of(line)
    return None if ref not in scene.facts else scene.facts[ref].relation.only[0].right


def _fact_of(line: Expression) -> str:
    """The fact that gives the direction of a wall, or of a line of centres."""
    match line:
        case Name(wall):
            return f"wall {wall}"
        case Quantity("line_of_centres", (), int(number)):
            return f"axis {number}"
    return ""


def _turn(scene: Scene, tree: Expression, *, slants: bool) -> _Turn | None:
    """The direction of **i**, **j**, a wall or a velocity along a line of centres, as an angle.

    The line of centres is along neither **i** nor **j**, but beside a wall that ``slants``.
    """
    match tree:
        case Unit(axis):
            return _Turn(RIGHT if axis == "j" else Degrees(Fraction(0)))
        case Name() | Quantity("line_of_centres") if (right := _along(scene, tree)) is not None:
            along = _turn_of_a_line(right)
            return None if along is None else _Turn(along, (_fact_of(tree),), both_ways=True)
        case Quantity("velocity"):
            return _turn_of_a_velocity(scene, tree, slants=slants)
    return None


def _turn_of_a_line(right: Expression) -> Expression | None:
    match right:
        case Unit(axis):
            return RIGHT if axis == "j" else Degrees(Fraction(0))
        case Degrees():
            return right
    return None


def _turn_of_a_velocity(scene: Scene, velocity: Quantity, *, slants: bool) -> _Turn | None:
    """The direction of a sphere that has no component across the last line of centres."""
    body, stage = body_and_stage(scene, velocity)
    if stage == 0:
        return _turn_at_the_start(scene, body)
    own = scene.model.frames.get(stage)
    if own is None or own.wall is not None:
        return None
    if own.axis is not None and not slants and any(scene.velocity(body, stage - 1)):
        return None
    frame = scene.frame(stage)
    angle = angle_of_the_line(scene, frame)
    if angle is None:
        return None
    try:
        along, across = (in_direction(scene, kind, body, stage, frame) for kind in COMPONENTS)
    except NotPlannedError:
        return None
    if across.value != 0 or scene.model.proved_sign(scene.model.in_data(along.value)) != 1:
        return None
    pool = together(across.whole, along.whole, frame.refs, nonzero(scene, along.value))
    return _Turn(angle, pool)


def _turn_at_the_start(scene: Scene, body: str) -> _Turn | None:
    """The direction of a velocity of the data along **i** or **j**."""
    if f"velocity {body}" not in scene.facts:
        return None
    initial = scene.initial(body)
    own = direction_from_i(scene.facts[f"velocity {body}"].relation.only[0].right)
    if isinstance(own, Letter) or (own is not None and list(_degrees(own))):
        return _Turn(own, initial.refs)
    for (own, other), angle in ((initial.value, 0), (reversed(initial.value), 90)):
        if other == 0 and (sign := scene.model.proved_sign(own)):
            turn = angle if sign > 0 else angle - 180 if angle else 180
            return _Turn(_in_degrees(Fraction(turn)), initial.refs)
    return None


def _in_degrees(value: Fraction) -> Expression:
    return Negate(Degrees(-value)) if value < 0 else Degrees(value)


def _between(scene: Scene, one: _Turn, other: _Turn) -> Expression | None:
    """The angle between two directions, of 0° to 180°, or to 90° where one points both ways."""
    degrees = [value for turn in (one, other) for value in _degrees(turn.angle)]
    both_ways = one.both_ways or other.both_ways
    if len(degrees) > 1:
        return _apart(max(degrees), min(degrees), both_ways=both_ways)
    match [turn.angle for turn in (one, other)]:
        case [Letter(name) as letter, Degrees(value)] | [Degrees(value), Letter(name) as letter]:
            acute = scene.model.unknowns.roles.get(name) == ACUTE
            if acute and scene.desk.known(letter) is None and value in (0, 90):
                return letter if value == 0 else Binary("-", RIGHT, letter)
    return None


def _apart(high: Fraction, low: Fraction, *, both_ways: bool) -> Expression | None:
    """The angle between two directions in degrees: as a sum or difference, where that is it."""
    apart = min((high - low) % 360, (low - high) % 360)
    apart = min(apart, 180 - apart) if both_ways else apart
    if not 0 < apart < 180:
        return None
    if high - low != apart or 0 in (high, low):
        return Degrees(apart)
    return Binary("-" if low > 0 else "+", Degrees(high), Degrees(abs(low)))


def _degrees(angle: Expression) -> Iterator[Fraction]:
    """The number of degrees of an angle that has one."""
    match angle:
        case Degrees(value):
            yield value
        case Negate(Degrees(value)):
            yield -value


__all__ = ["angle_along_the_centres", "given_along_the_centres"]
