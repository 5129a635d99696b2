"""Angles between velocities at an impact of spheres: by the angles of both to the line of centres.

The two lie on one side of that line or on both, and point the same way along it or not. So the
angles are added, or taken from each other, or from 180°; in letters, by their tangents.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import count, islice
from typing import Any, Literal

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Line, Meaning, Move, Ref, Relation, numbers_in
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
)
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.angles import RIGHT, STRAIGHT, angle_to_a_line
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.given_angles import given_angle
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass

_I = Unit("i")
NONE = Degrees(Fraction(0))

# Of two angles p and q that are made into a third: p + q, p − q, 180° − p − q, 180° − p + q.
Form = Literal["sum", "difference", "rest of sum", "rest of difference"]


# A body, and the event after which its velocity is meant.
Moving = tuple[str, int]


@dataclass(frozen=True)
class Direction:
    """A velocity, seen from the line of centres.

    ``angle`` is its angle to that, where it is told: as none, or a right one, or by the data, which
    ``sources`` name; else ``named`` is the quantity that a working has to name, and ``sources`` are
    what tells its sense along the line of centres, where its components do not.
    """

    velocity: Quantity
    along: Source
    across: Source
    angle: Expression | None
    named: Quantity
    sources: tuple[Ref, ...] = ()

    @property
    def refs(self) -> tuple[Ref, ...]:
        """What its components rest on."""
        return together(self.along.whole, self.across.whole)


@dataclass(frozen=True)
class Turn:
    """An angle between two velocities at an impact, of two to the line of centres.

    ``pushed`` tells which way the impulse pushes a body of which the velocity afterwards is open.
    """

    asked: Quantity
    frame: Frame
    move: Move
    first: Direction
    second: Direction
    form: Form
    pushed: tuple[Ref, ...] = ()

    def made_of(self, first: Expression | None, second: Expression | None) -> Expression:
        """The angle by the two others; None stands for no angle at all."""
        if first is None and second is None:
            return STRAIGHT if self.form.startswith("rest") else NONE
        if first is None or second is None:
            (one,) = (tree for tree in (first, second) if tree is not None)
            return Binary("-", STRAIGHT, one) if self.form.startswith("rest") else one
        match self.form:
            case "sum":
                return Binary("+", first, second)
            case "difference":
                return Binary("-", first, second)
            case "rest of sum":
                return Binary("-", Binary("-", STRAIGHT, first), second)
        return Binary("+", Binary("-", STRAIGHT, first), second)


def turns_of(scene: Scene, asked: Quantity) -> Iterator[Turn]:
    """The ways in which an angle is made of two others; none where it is no such angle.

    Lines that a way rests on are written when it is asked for: those before it may be gone by then.
    """
    for number in count():
        turn = next(islice(_turns(scene, asked), number, None), None)
        if turn is None:
            return
        yield turn


def _turns(scene: Scene, asked: Quantity) -> Iterator[Turn]:
    """The ways in which an angle is made of two others.

    The angles are those to the line of centres; where it is open which way a body goes along that,
    they are those of up to 180° to **i** or **j**.
    """
    pair = velocities_of(scene, asked)
    if pair is None:
        return
    (one, first), (other, second) = pair
    if one == other and first > second:
        pair = pair[::-1]
    event = impact_of(scene, *pair)
    if event is None:
        return
    frame = scene.frame(event)
    p, q = (_direction(scene, frame, *state) for state in pair)
    if p is None or q is None:
        return
    angles = {p.angle, q.angle}
    if frame.wall is not None and angles != {NONE}:
        return  # at a wall the angles are those to the wall
    if one != other and NONE in angles and RIGHT not in angles:
        wider = p if q.angle == NONE else q
        if wider.angle is None and scene.desk.known(wider.named) is None:
            return  # the other angle is what is asked
    if one == other:
        q = replace(q, sources=q.sources or _of_the_given_sense(scene, asked, frame, p, q))
    move = Move("define", "difference", event, (one,) if one == other else (one, other))
    by_a_unit = one == other and angles.isdisjoint((NONE, RIGHT))
    # An angle that is given, or found, to **i** or **j** is not found again to the line of centres.
    units_first = one != other or any(
        _is_given_to_a_unit(scene, side.velocity) or _is_found_to_a_unit(scene, side.velocity)
        for side in (p, q)
    )
    # Of a component that is a letter yet, the sense is open.
    units_first |= is_along_a_letter(scene, q)
    units_first &= by_a_unit or one != other
    for in_units in (True, False) if units_first else (False, True):
        turn: Turn | None = None
        if in_units and by_a_unit:
            turn = _from_a_unit(scene, asked, frame, move, (p, q))
        elif in_units and one != other:
            turn = _of_two_from_a_unit(scene, asked, frame, move, (p, q))
        elif not in_units:
            form, swapped = _form_of(scene, p, q, one == other)
            sides = (q, p) if swapped else (p, q)
            # Which way the impulse pushes the body is seen before the laws are used.
            open_ = one == other and scene.unknown(q.along.value)
            pushed = _met(scene, frame, one) if open_ else ()
            turn = None if form is None else Turn(asked, frame, move, *sides, form, pushed)
        if turn is not None:
            yield turn
    turn = _by_the_given(scene, asked, frame, move, (p, q)) if one == other else None
    if turn is not None:
        yield turn


def is_along_a_letter(scene: Scene, side: Direction) -> bool:
    """Whether the component of a velocity along the line of centres is a letter, with no value."""
    components = (component.symbol for component in scene.model.components.values())
    return side.along.value in components


def _of_the_given_sense(
    scene: Scene, asked: Quantity, frame: Frame, early: Direction, late: Direction
) -> tuple[Ref, ...]:
    """What tells how a sphere goes on by a deflection that is given, where that may be open."""
    given = given_angle(scene, asked)
    if given is None or late.angle is not None or not scene.unknown(late.along.value):
        return ()
    (body,) = early.velocity.arguments
    assert isinstance(body, Name)
    return together(given[1], _met(scene, frame, body.name), early.refs)


def _by_the_given(
    scene: Scene, asked: Quantity, frame: Frame, move: Move, sides: tuple[Direction, Direction]
) -> Turn | None:
    """The turn of a sphere by a deflection that is given, which tells how it goes on.

    It came at 30° to the line of centres and is turned by 30°, so it leaves at 60°. None where one
    of these is no number, and where it is told without the deflection.
    """
    early, late = sides
    given = given_angle(scene, asked)
    if given is None or early.angle in (NONE, RIGHT) or late.angle is not None:
        return None
    if _form_of(scene, early, late, True)[0] is not None:
        return None
    turned = scene.scalar(given[0])
    slope = tidy(early.across.value / early.along.value)
    fall = tidy(expanded(early.along.value - late.along.value))
    sense, falls = (scene.model.sign(value) for value in (early.along.value, fall))
    if not (slope.is_number and turned.is_number and sense and falls):
        return None
    before = sp.atan(abs(slope))
    after = before + sense * falls * turned
    if not 0 < after < sp.pi or after == sp.pi / 2:
        return None
    (body,) = early.velocity.arguments
    assert isinstance(body, Name)
    pushed = _met(scene, frame, body.name)
    if after > sp.pi / 2:
        return Turn(asked, frame, move, early, late, "rest of sum", pushed)
    pair = (late, early) if after > before else (early, late)
    return Turn(asked, frame, move, *pair, "difference", pushed)


def _is_given_to_a_unit(scene: Scene, velocity: Quantity) -> bool:
    """Whether the facts give the angle of a velocity to **i** or **j**."""
    angles = (Quantity("angle", (velocity, unit)) for unit in (Unit("i"), Unit("j")))
    return any(given_angle(scene, angle) is not None for angle in angles)


def _is_found_to_a_unit(scene: Scene, velocity: Quantity) -> bool:
    """Whether a line in force has the tangent of the angle of a velocity to **i** or **j**.

    It is one into which nothing is to be put that is known by now.
    """
    for axis in (Unit("i"), Unit("j")):
        angle = Quantity("angle", (velocity, axis))
        named, tangents = letter_known(scene, angle), [Apply("tan", angle)]
        if named is not None:
            tangents.append(Apply("tan", Letter(named[0])))
        for line in scene.desk.lines:
            own = line.relation
            if not isinstance(own, Relation) or own.options[0][0].left not in tangents:
                continue
            if len(own.options) > 1 or not scene.desk.holds(line.number):
                continue
            return True
    return any(_is_along_i(scene, line, velocity) for line in scene.desk.lines)


def _is_along_i(scene: Scene, line: Line, velocity: Quantity) -> bool:
    """Whether a line names the angle of a velocity to another one, which is in the direction of i.

    That angle is obtuse: else it is the one to the line of centres.
    """
    match line.relation:
        case Meaning(_, Quantity("angle", (Quantity("velocity") as a, Quantity("velocity") as b))):
            pass
        case _:
            return False
    if velocity not in (a, b) or not scene.desk.holds(line.number):
        return False
    (x, y), (own, _) = (
        scene.vector(quantity) for quantity in ((b, a) if velocity == a else (a, b))
    )
    if scene.unknown(x) or scene.unknown(own) or not scene.model.identically_zero(y):
        return False
    return scene.model.sign(x) > 0 > scene.model.sign(own)


def _from_a_unit(
    scene: Scene, asked: Quantity, frame: Frame, move: Move, sides: tuple[Direction, Direction]
) -> Turn | None:
    """Where it is open which way a body goes along the line of centres: by angles of up to 180°."""
    units = [tree for tree in (frame.along, frame.across) if isinstance(tree, Unit)]
    fact = scene.facts.get(f"axis {frame.number}")
    line = fact.relation.only[0].right if fact is not None else None
    unit = line if isinstance(line, Unit) else next(iter(units), None)
    if unit is None or frame.write is not None or not isinstance(line, Unit):
        return None
    body = asked.arguments[0] if asked.kind == "deflection" else sides[0].velocity.arguments[0]
    assert isinstance(body, Name)
    given = scene.facts.get(f"velocity {body.name}")
    seen: list[Direction] = []
    for side in sides:
        angle: Expression | None = None
        match given.relation.only[0].right if given is not None else None:
            case Polar(_, size, origin, None) if not side.velocity.stage:
                if (origin or Unit("i")) == unit:
                    angle = size
        if angle is None and not side.velocity.stage:
            onward = scene.scalar(Quantity("along", (side.velocity, unit)))
            if scene.model.decide(onward, ">=", 0):
                angle = _angle_of_data(scene, body.name, frame)
        own = replace(side, angle=None, named=Quantity("angle", (side.velocity, unit)), sources=())
        given_as = given_angle(scene, own.named) if angle is None else None
        if given_as is not None:
            own = replace(own, angle=given_as[0], sources=given_as[1])
        seen.append(own if angle is None else _of_data(scene, own, body.name, angle))
    fall = tidy(expanded(sides[0].along.value - sides[1].along.value))
    sign = scene.model.sign(fall)
    if not sign or not scene.model.decide(sign * fall, ">=", 0):
        return None
    late, early = (seen[1], seen[0]) if sign == 1 else (seen[0], seen[1])
    # Which way the impulse pushes the body is seen before the laws are used.
    open_ = scene.unknown(sides[1].along.value)
    pushed = _met(scene, frame, body.name) if open_ else ()
    return Turn(asked, frame, move, late, early, "difference", pushed)


def _of_two_from_a_unit(
    scene: Scene, asked: Quantity, frame: Frame, move: Move, sides: tuple[Direction, Direction]
) -> Turn | None:
    """The angle between the velocities of two bodies, by their angles to **i** that stand.

    None where they do not, or the bodies do not go to one side of a line of centres along **i**.
    """
    fact = scene.facts.get(f"axis {frame.number}")
    unit = fact.relation.only[0].right if fact is not None else None
    if not isinstance(unit, Unit) or frame.write is not None:
        return None
    if not all(_is_found_to_a_unit(scene, side.velocity) for side in sides):
        return None
    (a, b), (c, d) = ([side.along.value, side.across.value] for side in sides)
    across, turn = (scene.model.sign(tidy(expanded(value))) for value in (b * d, a * d - b * c))
    if across != 1 or not turn or scene.unknown(a) or scene.unknown(c):
        return None
    seen = [replace(s, named=Quantity("angle", (s.velocity, unit)), sources=()) for s in sides]
    further = turn * scene.model.sign(b)
    first, second = seen[::-1] if further == 1 else seen
    return Turn(asked, frame, move, first, second, "difference")


def _met(scene: Scene, frame: Frame, body: str) -> tuple[Ref, ...]:
    """What the component along the line of centres of what a body meets rests on, before it."""
    before = frame.number - 1
    others = (sphere for sphere in scene.spheres(frame.number) if sphere != body)
    sources = (in_direction(scene, "along", sphere, before, frame) for sphere in others)
    return together(*(source.whole for source in sources))


def impact_of(scene: Scene, one: Moving, other: Moving) -> int | None:
    """The impact at which two velocities are resolved: that of one body before and after it.

    Of two bodies it is their own, with both velocities after it, or both before. None without one.
    """
    (a, early), (b, late) = one, other
    event = max(early, late)
    if event not in scene.model.frames or not {a, b} <= set(scene.bodies(event)):
        return None
    if a == b:
        return event if scene.last_event(a, event - 1) == min(early, late) != event else None
    return event if early == late else None


def velocities_of(scene: Scene, asked: Quantity) -> tuple[Moving, Moving] | None:
    """The two velocities between which an angle is, each after the last event of its body.

    Those of a deflection are the one before it and the one after it. None of another angle.
    """
    match asked:
        case Quantity("deflection", (Name(body),), int(event)):
            return (body, scene.last_event(body, event - 1)), (body, event)
        case Quantity("angle", (Quantity("velocity") as a, Quantity("velocity") as b)):
            return body_and_stage(scene, a), body_and_stage(scene, b)
    return None


def _direction(scene: Scene, frame: Frame, body: str, last: int) -> Direction | None:
    stage = frame.number if last == frame.number else frame.number - 1
    along, across = (in_direction(scene, kind, body, stage, frame) for kind in COMPONENTS)
    velocity = Quantity("velocity", (Name(body),), last)
    named = Quantity("angle", (velocity, Quantity("line_of_centres", (), frame.number)))
    zero = [scene.model.identically_zero(source.value) for source in (along, across)]
    if all(zero):
        return None
    angle: Expression | None = None
    if zero[0]:
        angle = RIGHT
    elif zero[1]:
        angle = NONE
    own = Direction(velocity, along, across, angle, named)
    if angle is None and not last:
        angle = _angle_of_data(scene, body, frame)
        return own if angle is None else _of_data(scene, own, body, angle)
    if angle is None:
        known = given_angle(scene, named) or _by_its_direction(scene, velocity, frame)
        return own if known is None else replace(own, angle=known[0], sources=known[1])
    return own


def _by_its_direction(
    scene: Scene, velocity: Quantity, frame: Frame
) -> tuple[Expression, tuple[Ref, ...]] | None:
    """An angle to a line of centres along **i**, by a direction that a line tells."""
    direction = Quantity("direction", velocity.arguments, velocity.stage)
    known = scene.desk.known(direction)
    axis = scene.facts.get(f"axis {frame.number}")
    if known is None or axis is None or axis.relation.only[0].right not in (_I, Negate(_I)):
        return None
    lines = numbers_in(known.refs)
    meanings = [
        line.number
        for line in scene.desk.lines
        if isinstance(line.relation, Meaning) and line.relation.quantity == direction
    ]
    if known.value.free_symbols or len(lines) != 1 or not meanings:
        return None
    return _acute(scene.desk.last_link(lines[0]).right), (*lines, *meanings)


def _acute(angle: Expression) -> Expression:
    """The angle of up to 90° to **i**, or to its opposite, of a direction."""
    match angle:
        case Negate(operand):
            return _acute(operand)
        case Binary("-", left, right) if STRAIGHT in (left, right):
            return right if left == STRAIGHT else left
        case Degrees(value) if value > 90:
            return Degrees(180 - value)
    return angle


def _of_data(scene: Scene, direction: Direction, body: str, angle: Expression) -> Direction:
    """A direction that the data tell by an angle, of which the number may be known."""
    value, refs = scene.put(scene.scalar(angle))
    known = tree_of(tidy(value), angle=True) if refs else angle
    if not isinstance(known, Degrees):
        known, refs = angle, ()
    return replace(direction, angle=known, sources=(f"velocity {body}", *refs))


def _angle_of_data(scene: Scene, body: str, frame: Frame) -> Expression | None:
    """The angle of up to 90° to the line of centres at which a velocity is given."""
    axis = scene.facts.get(f"axis {frame.number}")
    return None if axis is None else angle_to_a_line(scene, body, axis.relation.only[0].right)


def _form_of(scene: Scene, p: Direction, q: Direction, same: bool) -> tuple[Form | None, bool]:
    """How the angle is made of the two, and whether they change places."""

    def sign(value: Any) -> int | None:
        own = tidy(expanded(value))
        if scene.model.identically_zero(own):
            return 1
        at = scene.model.sign(own)
        return at if at and scene.model.decide(at * own, ">=", 0) else None

    a, b, c, d = (source.value for source in (p.along, p.across, q.along, q.across))
    onward = 1 if RIGHT in (p.angle, q.angle) else sign(a * c)
    beside = 1 if same or NONE in (p.angle, q.angle) else sign(b * d)
    if onward is None or beside is None:
        return None, False
    if onward == 1 and beside == -1:
        return "sum", False
    if onward == -1 and beside == 1:
        return "rest of sum", False
    if RIGHT in (p.angle, q.angle) or NONE in (p.angle, q.angle):
        first = p.angle == RIGHT or q.angle == NONE
        wider: int | None = 1 if first else -1
    else:
        wider = sign(c**2 - a**2) if same else sign((b * c) ** 2 - (d * a) ** 2)
    if wider is None:
        return None, False
    return ("difference" if onward == 1 else "rest of difference"), wider == -1
