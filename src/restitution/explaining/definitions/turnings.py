"""The angle between two velocities at an impact, by their angles to the line of centres."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import permutations

import sympy as sp

from restitution.explaining.data.paths_and_lines import angle_between, degrees_of
from restitution.explaining.definitions.common import axis_of
from restitution.explaining.definitions.senses import oriented
from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.lines.quotients import Plane, Quotient
from restitution.explaining.lines.trees import settled
from restitution.explaining.steps.step import Step
from restitution.expression.evaluate import in_letters
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
    has_quantity,
    is_binary,
    letters,
    unsigned,
)

_WHOLE, _STRAIGHT, _RIGHT, _NONE = (Degrees(Fraction(size)) for size in (360, 180, 90, 0))

# A body, and the event after which its velocity is meant.
Moving = tuple[str, int]


def turnings(step: Step, event: Event | None) -> Iterator[Link]:
    """A deflection, and the angle between two velocities before an impact or after it.

    Both velocities are seen from the line of centres. They point the same way along it or not, and
    lie on one side of it or on both, as the components tell: so the angles to it are added, or
    taken from each other, or from 180°. That a velocity stays on its side has to be cited too.
    """
    if event is None or not set(step.move.bodies) <= set(event.bodies):
        return
    before, after = event.number - 1, event.number
    pairs: list[tuple[Moving, Moving]]
    match step.move.bodies:
        case (body,):
            pairs = [((body, before), (body, after))]
        case (first, second):
            pairs = [((first, number), (second, number)) for number in (before, after)]
        case _:
            return
    yield from _by_directions(step, event)
    yield from _to_parallel_lines(step, event)
    yield from _beside_a_velocity_along_i(step, event)
    yield from _from_direction_to_direction(step, event)
    for one, other in pairs:
        velocities = [Quantity("velocity", (Name(body),), stage) for body, stage in (one, other)]
        subjects = [Quantity("angle", tuple(pair)) for pair in (velocities, velocities[::-1])]
        if one[0] == other[0]:
            subjects.append(Quantity("deflection", (Name(one[0]),), event.number))
            subjects += _from_its_axis(step, *velocities)
        for angle in (_between(step, event, one, other), _from_a_unit(step, event, one, other)):
            if angle is not None:
                yield from (Link(subject, "=", angle) for subject in subjects)


def _from_its_axis(step: Step, early: Quantity, late: Quantity) -> Iterator[Quantity]:
    """The angle of a velocity to **i** or **j**, where the body came in that direction."""
    for link in step.links:
        if link.left == early and link.sign == "=":
            for axis, angle in (("i", _NONE), ("j", _RIGHT)):
                sure = all(step.setting.role(x).kind == "positive" for x in _of_size(link.right))
                if sure and direction_from_i(link.right) == angle:
                    yield Quantity("angle", (late, Unit(axis)))  # type: ignore[arg-type]


def _between(step: Step, event: Event, one: Moving, other: Moving) -> Expression | None:
    """The angle between two velocities; None where what is cited leaves it open."""
    a, b, c, d = (
        _component(step, event, kind, state) for state in (one, other) for kind in COMPONENTS
    )
    if a is None or b is None or c is None or d is None:
        return None
    p, q = (_to_the_line(event, state, *own) for state, own in ((one, (a, b)), (other, (c, d))))
    square = _RIGHT in (p, q)
    onward = 1 if square else _sign(step, a * c)
    if onward is None and one[0] == other[0]:
        onward = goes_on_by_its_deflection(step, event, one[0])
    if p == q == _NONE and one[0] != other[0]:
        onward = _on_one_line(step, event, (one, a), (other, c))
    beside = 1 if _NONE in (p, q) else _sign(step, b * d)
    if onward is None or beside is None:
        return None
    if onward == 1 and beside == -1:
        return Binary("+", p, q)
    if onward == -1 and beside == 1:
        return Binary("-", Binary("-", _STRAIGHT, p), q)
    # The greater angle less the other one, or what that leaves of a straight one.
    if p == _RIGHT or q == _NONE:
        wider: int | None = 1
    elif q == _RIGHT or p == _NONE:
        wider = -1
    elif one[0] == other[0]:
        wider = _sign(step, c * c - a * a) or _turned_away(step, event, one, (a, c))
    else:
        wider = _sign(step, b * b * c * c - d * d * a * a)
    if wider is None:
        return None
    high, low = (p, q) if wider == 1 else (q, p)
    if onward == 1:
        return Binary("-", high, low)
    return Binary("+", Binary("-", _STRAIGHT, high), low)


def _turned_away(
    step: Step, event: Event, before: Moving, along: tuple[Quotient, Quotient]
) -> int | None:
    """−1 where a body that goes on the same way is slowed along the line of centres, else 1.

    So it is afterwards at the greater angle to that. None where it is open.
    """
    a, c = along
    sense, falls = _sign(step, a), _sign(step, a - c) or _pushed_back(step, event, before)
    return None if sense is None or falls is None else -sense * falls


def goes_on_by_its_deflection(step: Step, event: Event, body: str) -> int | None:
    """1 where a body goes on in the sense in which it came along the line of centres, else −1.

    The deflection is cited as a number, and the path before has components of which the ratio is
    one: at 30° to the line and turned by 30°, back from the other sphere, it is at 60°. None where
    it is open to which side it is turned, and where it is left at right angles to the line.
    """
    before, after = ((body, event.number - back) for back in (1, 0))
    a, b, d = (
        _component(step, event, kind, state)
        for kind, state in (("along", before), ("across", before), ("across", after))
    )
    if a is None or b is None or d is None or a.vanishes or _sign(step, b * d) != 1:
        return None
    sense, push = _sign(step, a), _pushed_back(step, event, before)
    deflection = Quantity("deflection", (Name(body),), event.number)
    given = [link.right for link in step.links if (link.left, link.sign) == (deflection, "=")]
    turned = _number(given[0]) if given else None
    slope = step.world.expression(step.world.reduced(b / a), step.setting.roles)
    if sense is None or push is None or turned is None or not slope.is_number:
        return None
    whole = abs(math.atan(float(slope))) + sense * push * turned
    if not 0 < whole < math.pi or math.isclose(whole, math.pi / 2):
        return None
    return 1 if whole < math.pi / 2 else -1


def _on_one_line(step: Step, event: Event, *sides: tuple[Moving, Quotient]) -> int | None:
    """Whether two spheres go the same way along the line of centres, 1, or opposite ways, −1.

    That is what is asked: so it is open in which sense a letter is drawn, unless its sphere was at
    rest, and moves off.
    """
    loose: set[str] = set()
    for (body, stage), along in sides:
        before = [_component(step, event, kind, (body, stage - 1)) for kind in COMPONENTS]
        if not all(part is not None and part.vanishes for part in before):
            loose |= {key[1] for key in step.world.keys(along.above).values() if key[0] == "letter"}
    (_, a), (_, c) = sides
    return oriented(step, a * c, loose)


def _from_a_unit(step: Step, event: Event, one: Moving, other: Moving) -> Expression | None:
    """The angle between two velocities, by the angles of up to 180° to **i** or **j**.

    Where it is that by which one body turns, the component along the line of centres, in that
    direction, falls as the angle grows. Two bodies go to one side of the line.
    """
    unit = step.world.directions.get(axis_of(event))
    sense = 1
    if isinstance(unit, Negate):
        unit, sense = unit.operand, -1
    if not isinstance(unit, Unit):
        return None
    if one[0] == other[0]:
        c, d = (_component(step, event, "along", state) for state in (one, other))
        falls = None if c is None or d is None else _sign(step, c - d)
        falls = falls or _pushed_back(step, event, one)
        falls = falls if _is_on_one_side(step, event, one, other) else None
    else:
        falls = _further_back(step, event, one, other)
    if falls is None:
        return None
    early, late = (
        Quantity("angle", (Quantity("velocity", (Name(body),), stage), unit))
        for body, stage in (one, other)
    )
    return Binary("-", late, early) if falls == sense else Binary("-", early, late)


def _is_on_one_side(step: Step, event: Event, one: Moving, other: Moving) -> bool:
    """Whether two velocities are certain to point to the same side of the line of centres."""
    b, d = (_component(step, event, "across", state) for state in (one, other))
    return b is not None and d is not None and _sign(step, b * d) == 1


def _further_back(step: Step, event: Event, one: Moving, other: Moving) -> int | None:
    """1 where the second of two velocities on one side makes the greater angle with the axis.

    −1 where the first does; None where that, or on which sides they are, is open.
    """
    a, b, c, d = (
        _component(step, event, kind, state) for state in (one, other) for kind in COMPONENTS
    )
    if a is None or b is None or c is None or d is None or _sign(step, b * d) != 1:
        return None
    side, turn = _sign(step, b), _sign(step, a * d - b * c)
    return None if side is None or turn is None else side * turn


def _pushed_back(step: Step, event: Event, before: Moving) -> int | None:
    """1 where an impact of spheres takes from a component along the axis, −1 where it adds to it.

    The impulse on a sphere is against its velocity relative to the other sphere.
    """
    body, stage = before
    others = [other for other in event.bodies if other != body]
    if stage != event.number - 1 or event.wall or event.kind != "impact" or len(others) != 1:
        return None
    own, other = (_component(step, event, "along", (name, stage)) for name in (body, *others))
    return None if own is None or other is None else _sign(step, own - other)


def _by_directions(step: Step, event: Event) -> Iterator[Link]:
    """The angle of a velocity to **i**, or to a line along **i**, by its direction from **i**.

    That is a wall, or the line of centres. On which side of **i** the velocity lies tells the sign,
    and which way it goes along a line whether the angle is taken from 180°.
    """
    for let in step.lets:
        match let.quantity:
            case Quantity("angle", (Quantity("velocity", (Name() as body,), stage), line)):
                pass
            case _:
                continue
        if stage not in (event.number - 1, event.number) or body.name not in step.move.bodies:
            continue
        x, y = (_in_the_plane(step, body, stage, axis) for axis in "ij")
        up = None if y is None else _sign(step, y)
        if up is None:
            continue
        direction: Expression = Quantity("direction", (body,), stage)
        size = direction if up == 1 else Negate(direction)
        if line == Unit("i"):
            yield Link(let.quantity, "=", size)
        elif _is_along_i(step, line):
            onward = None if x is None else _sign(step, x)
            if onward is not None:
                angle = size if onward == 1 else Binary("-", _STRAIGHT, size)
                yield Link(let.quantity, "=", angle)


def _beside_a_velocity_along_i(step: Step, event: Event) -> Iterator[Link]:
    """The angle of a velocity to **i**, by that to another velocity, in the direction of **i**."""
    for let in step.lets:
        match let.quantity:
            case Quantity("angle", (Quantity("velocity") as first, Quantity("velocity") as second)):
                pass
            case _:
                continue
        for own, other in ((first, second), (second, first)):
            (body,), stage = other.arguments, other.stage
            if not isinstance(body, Name) or not isinstance(stage, int):
                continue
            x, y = (_in_the_plane(step, body, stage, axis) for axis in "ij")
            along = x is not None and y is not None and y.vanishes and not x.vanishes
            if along and x is not None and _sign(step, x) == 1:
                yield Link(Quantity("angle", (own, Unit("i"))), "=", let.quantity)


def _to_parallel_lines(step: Step, event: Event) -> Iterator[Link]:
    """The angle of a velocity to the line of centres, by that to a wall parallel to it."""
    centres = _along(step, axis_of(event))
    for let in step.lets:
        match let.quantity:
            case Quantity("angle", (Quantity("velocity") as velocity, Name() as wall)):
                own = Quantity("angle", (velocity, axis_of(event)))
                if centres is not None and _along(step, Quantity("direction", (wall,))) == centres:
                    yield Link(own, "=", let.quantity)


def _from_direction_to_direction(step: Step, event: Event) -> Iterator[Link]:
    """The deflection of a body by its directions from **i**: one of the data, one that is cited."""
    if len(step.move.bodies) != 1:
        return
    (body,) = map(Name, step.move.bodies)
    if any(
        other.number < event.number and body.name in other.bodies for other in step.setting.events
    ):
        return
    late = Quantity("direction", (body,), event.number)
    names = [late, *(Letter(let.letter) for let in step.lets if let.quantity == late)]
    for link in step.links:
        if link.left in names and link.sign == "=":
            after = _number(link.right)
            break
    else:
        return
    values = {link.left: link.right for link in step.links if link.sign == "="}
    for link in step.links:
        if link.left == Quantity("velocity", (body,), 0) and link.sign == "=":
            early = direction_from_i(link.right)
            early = values.get(early, early) if isinstance(early, Letter) else early
            before = None if early is None else _number(early)
            if early is None or before is None or after is None or abs(after - before) > math.pi:
                continue
            if any(step.setting.role(name).kind != "positive" for name in _of_size(link.right)):
                continue
            turn = Binary("-", late, early) if after > before else Binary("-", early, late)
            yield Link(Quantity("deflection", (body,), event.number), "=", turn)


def is_given_angle(step: Step, line: Link) -> bool:
    """Whether a line says an angle of a velocity of the data to a line as these give it."""
    own = (line.left, line.right)
    return line.sign == "=" and any((x.left, x.right) == own for x in _to_given_lines(step))


def _to_given_lines(step: Step) -> Iterator[Link]:
    """The angle of a velocity of the data to a wall, a line of centres, **i** or **j**.

    It is the one by which the velocity is given, or the difference of two in degrees.
    """
    for link in step.links:
        match link:
            case Link(Quantity("velocity", (Name(),), 0) as velocity, "=", Polar() as right):
                pass
            case _:
                continue
        size = unsigned(right.angle)
        acute = isinstance(size, Letter) and _is_acute(step, size)
        within = acute or (isinstance(size, Degrees) and 0 <= size.value <= 90)
        if any(step.setting.role(x).kind != "positive" for x in letters(right.size)):
            continue
        if right.wall is not None:
            if within and size == right.angle:
                yield Link(Quantity("angle", (velocity, right.wall)), "=", size)
            continue
        origin = Unit("i") if right.origin is None else right.origin
        if isinstance(unsigned(origin), Unit) and (
            acute or (isinstance(size, Degrees) and 0 <= size.value <= 180)
        ):
            yield Link(Quantity("angle", (velocity, origin)), "=", size)
        if unsigned(origin) == Unit("i"):
            yield from _to_cited_lines(step, velocity, right.angle, within)


def _to_cited_lines(
    step: Step, velocity: Quantity, direction: Expression, within: bool
) -> Iterator[Link]:
    """The angles of a velocity to the lines whose directions are cited, by its own from **i**."""
    walls = [Name(name) for name, kind in step.setting.names.items() if kind == "wall"]
    axes = [axis_of(event) for event in step.setting.events]
    lines: list[tuple[Expression, Quantity]] = [(own, own) for own in axes]
    lines += [(wall, Quantity("direction", (wall,))) for wall in walls]
    for line, axis in lines:
        along = step.world.directions.get(axis)
        if along is None:
            continue
        turn: Expression = along
        if isinstance(unsigned(along), Unit):
            turn = _NONE if unsigned(along) == Unit("i") else _RIGHT
        whole = angle_between(direction, turn)
        if whole is not None:
            yield Link(Quantity("angle", (velocity, line)), "=", Degrees(degrees_of(whole)))
        elif within and turn == _NONE:
            yield Link(Quantity("angle", (velocity, line)), "=", unsigned(direction))


def between_given_directions(step: Step) -> Iterator[Link]:
    """Directions of velocities of the data, and the angle between two, given in degrees."""
    given: list[tuple[Expression, Expression, float]] = []
    for link in step.links:
        match link:
            case Link(Quantity("velocity", (Name(),), 0) as velocity, "=", right):
                angle = direction_from_i(right)
                worth = None if angle is None else _number(angle)
                sure = all(step.setting.role(x).kind == "positive" for x in _of_size(right))
                if sure and isinstance(angle, Letter) and _is_acute(step, angle):
                    yield Link(replace(velocity, kind="direction"), "=", angle)
                if angle is not None and worth is not None and sure:
                    given.append((velocity, angle, worth))
    for (one, first, low), (other, last, high) in permutations(given, 2):
        if low < high:
            apart: Expression = Binary("-", last, first)
            apart = apart if high - low <= math.pi else Binary("-", _WHOLE, apart)
            for pair in ((one, other), (other, one)):
                yield Link(Quantity("angle", pair), "=", apart)


def direction_from_i(velocity: Expression) -> Expression | None:
    """The direction of a velocity, as an angle from **i**, as the data have it."""
    match velocity:
        case Polar(_, Degrees() | Negate(Degrees()) | Letter() as angle, None | Unit("i"), None):
            return angle
        case Polar(_, Apply("arcsin" | "arccos" | "arctan") as angle, None | Unit("i"), None):
            return angle
        case Unit(axis):
            return _NONE if axis == "i" else _RIGHT
        case Negate(Unit(axis)):
            return _STRAIGHT if axis == "i" else Negate(_RIGHT)
        case Negate(Binary("*", size, Unit() as unit)) if not _is_negative(size):
            return direction_from_i(Negate(unit))
        case Binary("*", size, Unit() as unit):
            return direction_from_i(Negate(unit) if _is_negative(size) else unit)
    return None


def _of_size(velocity: Expression) -> Iterable[str]:
    """The letters of a velocity, but for that of its direction."""
    return letters(velocity.size if isinstance(velocity, Polar) else velocity)


def _is_negative(size: Expression) -> bool:
    """Whether a size is written with a minus; letters of speeds are positive."""
    return isinstance(size, Negate) or (is_binary(size, "*", "/") and _is_negative(size.left))


def _is_acute(step: Step, angle: Letter) -> bool:
    """Whether a letter of the data stands for an acute angle."""
    role = step.setting.role(angle.name)
    return role.kind == "angle" and role.low == 0 and role.high == sp.pi / 2


def _number(tree: Expression) -> float | None:
    """The number of radians of an angle without letters."""
    if letters(tree) or has_quantity(tree):
        return None
    return float(sp.N(in_letters(tree)))


def _along(step: Step, line: Quantity) -> Expression | None:
    """The direction of a wall, or of a line of centres, that is cited, in either sense."""
    own = step.world.directions.get(line)
    return unsigned(own)


def _in_the_plane(step: Step, body: Name, stage: int, axis: str) -> Quotient | None:
    """A component along **i** or **j**, with what is cited put in."""
    tree = Quantity("along", (Quantity("velocity", (body,), stage), Unit(axis)))  # type: ignore[arg-type]
    value = step.world.value(settled(tree, step.setting.events))
    known = step.rules().put_into(value)
    return None if isinstance(known, Plane) or known == value else step.world.reduced(known)


def _is_along_i(step: Step, line: Expression) -> bool:
    """Whether a wall, or a line of centres, that is cited is along **i**."""
    match line:
        case Name():
            return _along(step, Quantity("direction", (line,))) == Unit("i")
        case Quantity("line_of_centres"):
            return _along(step, line) == Unit("i")
    return False


def _component(step: Step, event: Event, kind: str, moving: Moving) -> Quotient | None:
    """A component in a direction of the impact, with what is cited put in."""
    body, stage = moving
    tree = Quantity(kind, (Quantity("velocity", (Name(body),), stage), axis_of(event)))
    value = step.rules().put_into(step.world.value(settled(tree, step.setting.events)))
    return None if isinstance(value, Plane) else step.world.reduced(value)


def _to_the_line(event: Event, moving: Moving, along: Quotient, across: Quotient) -> Expression:
    """The angle of a velocity to the line of centres, of up to 90°."""
    if along.vanishes:
        return _RIGHT
    if across.vanishes:
        return _NONE
    body, stage = moving
    return Quantity("angle", (Quantity("velocity", (Name(body),), stage), axis_of(event)))


def _sign(step: Step, value: Quotient) -> int | None:
    """The sign of what components make, 1 where it is nothing; None where it is open."""
    own = step.world.reduced(value)
    return 1 if own.vanishes else oriented(step, own)
