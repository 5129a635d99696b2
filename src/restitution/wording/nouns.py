"""Quantities, and expressions of quantities, as noun phrases.

``speed(P)`` is *the speed of P immediately after the impact*, ``energy_lost/energy(0)`` *the
fraction of the total kinetic energy before the collision that is lost in it*. Words stand in
front of what they apply to (the sum of, the square of), so that no brackets are needed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from restitution.expression.dimensions import TIME
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    has_quantity,
)
from restitution.problem import Impact, Kick
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.scene import (
    INITIALLY,
    Scene,
    after,
    bodies_of,
    event_name,
    happening,
    instant,
    just_before,
    name_of,
)
from restitution.wording.structure import Named, Words
from restitution.wording.words import listed, names, words


@dataclass(frozen=True)
class Noun:
    """A noun phrase: ``head`` (the speed of P) and ``when`` (immediately after the impact).

    ``kind`` and ``body`` are there where it can be told together with others of its kind: the
    speeds of A and B. ``tail`` is what follows the body: in the direction of **i**.
    """

    head: Words
    when: Words = ()
    kind: str = ""
    body: str = ""
    tail: Words = ()

    def words(self) -> Words:
        """The whole phrase."""
        return words(self.head, " ", self.when) if self.when else self.head


# What is said of one body, in the singular and of several.
_OF_BODY = {
    "velocity": ("velocity", "velocities"),
    "speed": ("speed", "speeds"),
    "direction": ("direction of motion", "directions of motion"),
    "deflection": ("angle of deflection", "angles of deflection"),
    "energy": ("kinetic energy", "kinetic energies"),
    "momentum": ("momentum", "momenta"),
    "mass": ("mass", "masses"),
    "position": ("coordinates", "coordinates"),
}
_INITIAL = "initial "
_FUNCTIONS = {
    "sin": "the sine of ",
    "cos": "the cosine of ",
    "tan": "the tangent of ",
    "cot": "the cotangent of ",
    "sec": "the secant of ",
    "cosec": "the cosecant of ",
    "arcsin": "the angle whose sine is ",
    "arccos": "the angle whose cosine is ",
    "arctan": "the angle whose tangent is ",
    "sqrt": "the square root of ",
    "abs": "the magnitude of ",
}


def phrase(scene: Scene, tree: Expression) -> Words:
    """An expression in words; one without quantities as mathematics."""
    return noun(scene, tree).words()


def noun(scene: Scene, tree: Expression) -> Noun:
    """An expression as a noun phrase."""
    if not has_quantity(tree):
        return Noun((Named(tree.name),) if isinstance(tree, Name) else words(values.laid(tree)))
    match tree:
        case Quantity():
            return _QUANTITIES.get(tree.kind, _of_body)(scene, tree)
        case Negate(Binary("*" | "/" as op, factor, rest)) if not has_quantity(factor):
            return noun(scene, Binary(op, Negate(factor), rest))
        case Negate(operand):
            return _led("the negative of ", noun(scene, operand))
        case Apply(name, argument):
            return _led(_FUNCTIONS[name], noun(scene, argument))
        case Binary():
            return _binary(scene, tree)
        case Pair(x, y):
            return _pair("the vector with components ", noun(scene, x), " and ", noun(scene, y))
        case Polar(size, angle, origin, wall):
            if wall is not None:
                return _polar(scene, size, angle, "clockwise", wall)
            return _polar(scene, size, angle, "anticlockwise", origin)
    raise AssertionError(tree)  # a quantity stands in no other node


def _polar(
    scene: Scene, size: Expression, angle: Expression, sense: str, start: Expression | None
) -> Noun:
    """A vector by size and direction, one of them a quantity."""
    origin = line(scene, start).words() if start is not None else (values.EAST,)
    turned = words(phrase(scene, angle), f" {sense} from ", origin)
    return Noun(words("a vector whose magnitude is ", phrase(scene, size), ", at ", turned))


def _led(words_before: str | Words, inner: Noun) -> Noun:
    return Noun(words(words_before, inner.head), inner.when)


def _pair(lead: str, left: Noun, link: str, right: Noun) -> Noun:
    """Two phrases in one; a moment that both share is told once."""
    if left.when == right.when or not left.when:
        return Noun(words(lead, left.head, link, right.head), right.when)
    return Noun(words(lead, left.words(), link, right.words()))


# --- arithmetic -----------------------------------------------------------------------------------


def _binary(scene: Scene, tree: Binary) -> Noun:
    left, right = tree.left, tree.right
    match tree.op:
        case "+":
            return _pair("the sum of ", noun(scene, left), " and ", noun(scene, right))
        case "-":
            return _difference(scene, left, right)
        case "*" if not has_quantity(left):
            return _led(values.times(left), noun(scene, right))
        case "*" if not has_quantity(right):
            return _led(values.times(right), noun(scene, left))
        case "*":
            return _pair("the product of ", noun(scene, left), " and ", noun(scene, right))
        case "/":
            return _ratio(scene, left, right)
    if right == Number(Fraction(2)):
        return _led("the square of ", noun(scene, left))
    return _pair("", noun(scene, left), " to the power ", noun(scene, right))


def _difference(scene: Scene, left: Expression, right: Expression) -> Noun:
    match left, right:
        case Quantity("time", (), int(later)), Quantity("time", (), int(earlier)):
            first, then = event_name(scene, earlier), event_name(scene, later)
            return Noun(words("the time between ", first, " and ", then))
        case Quantity("velocity", (Name(a),)), Quantity("velocity", (Name(b),)) if a != b:
            one, other = noun(scene, left), noun(scene, right)
            if one.when == other.when:
                relative = words("the velocity of ", Named(a), " relative to ", Named(b))
                return Noun(relative, one.when)
    one, other = noun(scene, left), noun(scene, right)
    if values.is_vector(left) or values.is_vector(right):
        return _pair("", one, " minus ", other)
    change = _change(scene, left, right)
    if change is not None:
        return change
    return Noun(words("the amount by which ", one.words(), " exceeds ", other.words()))


def _change(scene: Scene, left: Expression, right: Expression) -> Noun | None:
    """What one quantity of a body has gained or lost in the only event."""
    if len(scene.events) != 1 or not isinstance(left, Quantity) or not isinstance(right, Quantity):
        return None
    if (left.kind, left.arguments) != (right.kind, right.arguments) or left.kind not in _OF_BODY:
        return None
    body = name_of(left.arguments[0]) if left.arguments else None  # of all bodies
    stages = [scene.stage(each.stage, body) for each in (left, right)]
    if stages not in ([1, 0], [0, 1]):
        return None
    change = "increase" if stages == [1, 0] else "decrease"
    the_rest = noun(scene, left).head
    return Noun(words(f"the {change} in ", the_rest), during(scene, 1))


def _ratio(scene: Scene, left: Expression, right: Expression) -> Noun:
    match left, right:
        case Quantity("energy_lost" | "total_energy_lost"), Quantity("energy"):
            whole, lost = whole_energy(scene, left, right), lost_where(scene, left)
            return Noun(words("the fraction of ", whole, " that is lost", lost))
    if not has_quantity(right):
        return _divided(noun(scene, left), right)
    return _pair("the ratio of ", noun(scene, left), " to ", noun(scene, right))


def _divided(above: Noun, below: Expression) -> Noun:
    return Noun(words(above.words(), " divided by ", lay.bracketed(lay.from_tree(below))))


def whole_energy(scene: Scene, lost: Quantity, whole: Quantity) -> Words:
    """The energy of which a part is lost; that just before needs no moment."""
    number = _event(scene, lost)
    start = 0 if lost.kind == "total_energy_lost" else number - 1
    said = noun(scene, whole)
    if not whole.arguments and len(scene.events) == 1 and scene.stage(whole.stage, None) == start:
        return said.head
    return said.words()


def lost_where(scene: Scene, lost: Quantity) -> Words:
    """Where energy is lost, with a blank in front."""
    if lost.kind == "total_energy_lost":
        return (" altogether",) if len(scene.events) > 1 else ()
    where = during(scene, _event(scene, lost))
    return words(" ", where) if where else ()


# --- quantities -----------------------------------------------------------------------------------


def _event(scene: Scene, tree: Quantity, body: str | None = None) -> int:
    """The number of the event that a quantity of an event belongs to."""
    if isinstance(tree.stage, int):
        return tree.stage
    if body is not None:
        for number in range(scene.now, 0, -1):
            if body in bodies_of(scene.events[number - 1]):
                return number
    return scene.now


def moment(scene: Scene, tree: Quantity, body: str | None) -> Words:
    """When a quantity is meant that goes on from event to event."""
    if tree.stage == "before":
        return just_before(scene, body)
    if isinstance(tree.stage, AtTime):
        return at_time(scene, tree.stage)
    number = scene.stage(tree.stage, body)
    # No event is told yet by whose name this moment could go.
    return INITIALLY if scene.now == number == 0 else after(scene, number)


def _place_when(scene: Scene, tree: Quantity, body: str | None) -> Words:
    """When a body is somewhere."""
    if isinstance(tree.stage, AtTime):
        return at_time(scene, tree.stage)
    return instant(scene, scene.stage(tree.stage, body))


def at_time(scene: Scene, stage: AtTime) -> Words:
    """``2 s after the impact``, ``t after the start``."""
    match stage.time:
        case Binary("+", Quantity("time", (), int(number)), rest) if not has_quantity(rest):
            return words(
                values.value(scene.style, rest, TIME), " after ", event_name(scene, number)
            )
    start = ("the start",) if scene.timed() else event_name(scene, 1)
    if has_quantity(stage.time):
        return words("at a time after ", start, " of ", phrase(scene, stage.time))
    if isinstance(stage.time, Number):
        return words(values.value(scene.style, stage.time, TIME), " after ", start)
    return words("at time ", values.value(scene.style, stage.time, TIME), " after ", start)


def _of_body(scene: Scene, tree: Quantity) -> Noun:
    body = name_of(tree.arguments[0]) or ""
    return _at_moment(tree.kind, body, () if tree.kind == "mass" else moment(scene, tree, body))


def _at_moment(kind: str, body: str, when: Words) -> Noun:
    if when == INITIALLY:
        kind, when = f"{_INITIAL}{kind}", ()
    return Noun(of_bodies(kind, (body,)), when, kind, body)


def of_bodies(kind: str, bodies: Sequence[str]) -> Words:
    """``the speed of A``, ``the speeds of A and B``."""
    return words(f"the {_called(kind, len(bodies))} of ", names(bodies))


def kinds_of(kinds: Sequence[str], body: str) -> Words:
    """``the speed and the direction of motion of A``."""
    each = [f"the {_called(kind, 1)}" for kind in kinds]
    return words(listed(each), " of ", Named(body))


def _called(kind: str, number: int) -> str:
    """``speed``, ``initial speeds``."""
    one, several = _OF_BODY[kind.removeprefix(_INITIAL)]
    initial = _INITIAL if kind.startswith(_INITIAL) else ""
    return initial + (one if number == 1 else several)


def _direction(scene: Scene, tree: Quantity) -> Noun:
    name = name_of(tree.arguments[0]) or ""
    if scene.is_wall(name):
        return Noun(words("the direction of ", Named(name)))
    moving = _at_moment("direction", name, moment(scene, tree, name))
    return _led(("the angle anticlockwise from ", values.EAST, " to "), moving)


def _deflection(scene: Scene, tree: Quantity) -> Noun:
    body = name_of(tree.arguments[0]) or ""
    return Noun(
        of_bodies("deflection", (body,)),
        _in_event(scene, _event(scene, tree, body)),
        "deflection",
        body,
    )


def _in_event(scene: Scene, number: int) -> Words:
    """``in the impact``; nothing where the statement has only one event."""
    if len(scene.events) <= 1:
        return ()
    return during(scene, number)


def during(scene: Scene, number: int) -> Words:
    """``in the impact``, ``due to the impulse``."""
    if number == 0:
        return ()
    due = isinstance(scene.events[number - 1], Kick)
    return words("due to " if due else "in ", event_name(scene, number))


def _impulse(scene: Scene, tree: Quantity) -> Noun:
    body = name_of(tree.arguments[0]) if tree.arguments else None
    number = _event(scene, tree, body)
    event = scene.events[number - 1] if number else None
    if isinstance(event, Kick):
        size = "" if body else "the magnitude of "
        alone = sum(isinstance(each, Kick) for each in scene.events) == 1
        on = (" on ", Named(event.body)) if alone else ()
        return Noun(words(size, event_name(scene, number), on))
    where = during(scene, number)
    if body is not None:
        return Noun(words("the impulse on ", Named(body)), where)
    return Noun(("the magnitude of the impulse",), where)


def _energy(scene: Scene, tree: Quantity) -> Noun:
    if tree.arguments:
        return _of_body(scene, tree)
    when = moment(scene, tree, None)
    initial, when = ("initial ", ()) if when == INITIALLY else ("", when)
    if len(scene.problem.spheres) == 1:
        (only,) = scene.problem.spheres
        return Noun(words(f"the {initial}kinetic energy of ", Named(only.name)), when)
    return Noun((f"the {initial}total kinetic energy",), when)


def _energy_lost(scene: Scene, tree: Quantity) -> Noun:
    number = _event(scene, tree)
    return Noun(("the kinetic energy lost",), during(scene, number))


def _total_energy_lost(scene: Scene, tree: Quantity) -> Noun:
    number = scene.stage(tree.stage, None)
    if len(scene.events) <= 1 or number == len(scene.events):
        return Noun(("the total kinetic energy lost",))
    return Noun(
        words("the total kinetic energy lost up to and including ", event_name(scene, number))
    )


def _momentum(scene: Scene, tree: Quantity) -> Noun:
    if tree.arguments:
        return _of_body(scene, tree)
    when = moment(scene, tree, None)
    if when == INITIALLY:
        return Noun(("the initial total momentum",))
    return Noun(("the total momentum",), when)


def _line_of_centres(scene: Scene, tree: Quantity) -> Noun:
    """As something asked for: a unit vector with its sense."""
    number = _event(scene, tree)
    event = scene.events[number - 1] if number else None
    if not isinstance(event, Impact):
        return Noun(("the line of centres",))
    where = _in_event(scene, number)
    if scene.is_wall(event.second):
        return Noun(
            words("the unit vector perpendicular to ", Named(event.second), " and directed into it")
        )
    towards = words(" from ", Named(event.first), " to ", Named(event.second))
    return Noun(words("the unit vector along the line of centres", towards), where)


def line(scene: Scene, tree: Expression) -> Noun:
    """Something that has a direction, as the side of an angle."""
    match tree:
        case Name(name):
            return Noun((Named(name),))
        case Quantity("line_of_centres"):
            number = _event(scene, tree)
            event = scene.events[number - 1] if number else None
            if isinstance(event, Impact) and scene.is_wall(event.second):
                return Noun(words("the perpendicular to ", Named(event.second)))
            return Noun(("the line of centres",), _in_event(scene, number))
        case Quantity("velocity", (Name(name),)):
            return _at_moment("direction", name, moment(scene, tree, name))
        case Quantity("direction", (Name(name),)) if scene.is_wall(name):
            return Noun((Named(name),))
    if has_quantity(tree):
        return noun(scene, tree)
    return Noun(values.direction_of(scene.style, tree))


def _angle(scene: Scene, tree: Quantity) -> Noun:
    one, other = (line(scene, each) for each in tree.arguments)
    if one.kind == other.kind != "" and one.body != other.body and one.when == other.when:
        return Noun(
            words("the angle between ", of_bodies(one.kind, (one.body, other.body))), one.when
        )
    if one.kind and other.kind:
        return Noun(words("the angle between ", one.words(), " and ", other.words()))
    if other.kind and not one.kind:
        one, other = other, one
    if not one.kind:
        return _pair("the angle between ", one, " and ", other)
    return Noun(
        words("the angle that ", one.head, " makes with ", other.head), one.when or other.when
    )


def _along(scene: Scene, tree: Quantity) -> Noun:
    vector, axis = tree.arguments
    of = noun(scene, vector)
    way = _axis(scene, axis, across=tree.kind == "across")
    if way.when and of.when and way.when != of.when:
        return Noun(words("the component of ", of.words(), " in ", way.words()))
    tail = words(" in ", way.head)
    head = words("the component of ", of.head, tail)
    if of.kind == "velocity":
        return Noun(head, of.when, f"component{tail}", of.body, tail)
    return Noun(head, of.when or way.when)


def _axis(scene: Scene, axis: Expression, *, across: bool) -> Noun:
    """The direction of a component, with its sense."""
    turn = "the direction at 90° anticlockwise from " if across else "the direction of "
    if isinstance(axis, Quantity) and axis.kind == "line_of_centres":
        return _led(turn, sensed_line(scene, axis))
    if isinstance(axis, Name):
        wall = scene.wall(axis.name)
        if wall is not None and wall.along is not None:
            axis = wall.along
        elif wall is not None and wall.start is not None:
            ends = (values.spot(wall.start), " to ", values.spot(wall.end))
            return Noun(words(turn, Named(wall.name), ", taken from ", *ends, ","))
        else:
            return Noun(words(turn, Named(axis.name)))
    if has_quantity(axis):
        return _led(turn, noun(scene, axis))
    if across:
        left = values.to_the_left(scene.style, axis)
        return Noun(left if isinstance(left[0], str) else words("the direction of ", left))
    if values.is_vector(axis):
        return Noun(words("the direction of ", values.direction_of(scene.style, axis)))
    return Noun(words(values.direction_of(scene.style, axis)))


def sensed_line(scene: Scene, tree: Quantity) -> Noun:
    """A line of centres with its sense: from the first body to the second, or into the wall."""
    plain = line(scene, tree)
    number = _event(scene, tree)
    event = scene.events[number - 1] if number else None
    if not isinstance(event, Impact):
        return plain
    if scene.is_wall(event.second):
        return Noun(words(plain.head, ", directed into it,"), plain.when)
    return Noun(
        words(plain.head, " from ", Named(event.first), " to ", Named(event.second)), plain.when
    )


def _position(scene: Scene, tree: Quantity) -> Noun:
    return _led("the coordinates of ", place(scene, tree))


def place(scene: Scene, tree: Quantity) -> Noun:
    """What is somewhere, a sphere or its centre, and when."""
    body = name_of(tree.arguments[0]) or ""
    centre = "the centre of " if _has_size(scene) else ""
    return Noun(words(centre, Named(body)), _place_when(scene, tree, body))


def _has_size(scene: Scene) -> bool:
    """Whether a sphere's centre has to be told from the sphere."""
    return any(each.radius is not None for each in scene.problem.spheres)


def _time(scene: Scene, tree: Quantity) -> Noun:
    number = tree.stage if isinstance(tree.stage, int) else scene.now
    if number == 0:
        return Noun(("the time at the start",))
    if not scene.timed():
        for first, event in enumerate(scene.events, 1):
            if isinstance(event, Impact) and not scene.is_wall(event.second):
                if first == number:
                    return Noun(words("the time of ", event_name(scene, number)))
                since = words("the time from ", event_name(scene, first), " until ")
                return Noun(words(since, happening(scene, number)))
            break
    return Noun(words("the time from the start until ", happening(scene, number)))


def _somewhere(scene: Scene, tree: Expression) -> Noun:
    """One end of a distance."""
    match tree:
        case Name(name):
            return Noun((Named(name),))
        case Quantity("position", (Name(name),)):
            centre = "the centre of " if _has_size(scene) else ""
            return Noun(
                words("the position of ", centre, Named(name)), _place_when(scene, tree, name)
            )
    return Noun(values.point(tree)) if not has_quantity(tree) else noun(scene, tree)


def _distance(scene: Scene, tree: Quantity) -> Noun:
    one, other = tree.arguments
    spheres = {each.name for each in scene.problem.spheres}
    bodies = [
        each.name for each in tree.arguments if isinstance(each, Name) and each.name in spheres
    ]
    if len(bodies) == 2:
        centres = "the centres of " if _has_size(scene) else ""
        return Noun(
            words("the distance between ", centres, names(bodies)), _place_when(scene, tree, None)
        )
    left, right = _somewhere(scene, one), _somewhere(scene, other)
    match one, other:
        case Quantity("position", (Name(a),)), Quantity("position", (Name(b),)) if a == b:
            moments = (" ", left.when, " and ", right.when)
            return Noun(words("the distance between the positions of ", Named(a), *moments))
    when = _place_when(scene, tree, bodies[0]) if bodies else ()
    if bodies:
        return Noun(words("the distance between ", left.head, " and ", right.head), when)
    return Noun(words("the distance between ", left.words(), " and ", right.words()))


def _dot(scene: Scene, tree: Quantity) -> Noun:
    one, other = (_vector(scene, each) for each in tree.arguments)
    return _pair("the scalar product of ", one, " and ", other)


def _vector(scene: Scene, tree: Expression) -> Noun:
    return (
        Noun(values.direction_of(scene.style, tree))
        if not has_quantity(tree)
        else noun(scene, tree)
    )


_QUANTITIES: Mapping[str, Callable[[Scene, Quantity], Noun]] = {
    "direction": _direction,
    "deflection": _deflection,
    "impulse": _impulse,
    "energy": _energy,
    "energy_lost": _energy_lost,
    "total_energy_lost": _total_energy_lost,
    "momentum": _momentum,
    "line_of_centres": _line_of_centres,
    "angle": _angle,
    "along": _along,
    "across": _along,
    "position": _position,
    "time": _time,
    "distance": _distance,
    "dot": _dot,
}
