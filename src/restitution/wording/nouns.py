"""Quantities, and expressions of quantities, as noun phrases.

``speed(P)`` is *the speed of P immediately after the impact*, ``energy_lost/energy(0)`` *the
fraction of the total kinetic energy before the collision that is lost in it*. Words stand in
front of what they apply to (the sum of, the square of), so that no brackets are needed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from restitution.expression.defined import quantity_of
from restitution.expression.dimensions import TIME
from restitution.expression.quantities import CHANGED, KINDS, LOSSES
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
    is_binary,
    is_quantity,
    name_of,
    rational,
)
from restitution.problem import Arrival, Event, Impact, bodies_of
from restitution.render import layout as lay
from restitution.shapes import Line, Segment
from restitution.wording import values
from restitution.wording.event_nouns import (
    energy_lost,
    energy_of_all,
    impulse,
    line_of_centres,
    lost_where,
    of_an_event,
    of_several,
    total_energy_lost,
)
from restitution.wording.moments import during, event_number, in_event, same_event
from restitution.wording.noun_phrases import (
    INITIAL,
    Noun,
    at_moment,
    led,
    of_bodies,
    of_its_body,
    pair,
)
from restitution.wording.scene import (
    INITIALLY,
    Scene,
    after,
    event_name,
    happening,
    instant,
    just_before,
)
from restitution.wording.structure import Emphasis, Words
from restitution.wording.words import listed, names, words

_LINE = "line_of_centres"
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
        return Noun(
            (Emphasis(tree.name),) if isinstance(tree, Name) else words(values.layout_of(tree))
        )
    defined = quantity_of(tree)
    if defined is not None:
        return noun(scene, defined)
    match tree:
        case Quantity(kind):
            usual = of_an_event if KINDS[kind].of_an_event else _of_bodies
            return _QUANTITIES.get(kind, usual)(scene, tree)
        case Negate(Binary("*" | "/" as op, factor, rest)) if not has_quantity(factor):
            return noun(scene, Binary(op, Negate(factor), rest))
        case Negate(operand):
            return led("the negative of ", noun(scene, operand))
        case Apply("abs", argument) if (between := ends(scene, argument)) is not None:
            return _distance(scene, Quantity("distance", between))
        case Apply(name, argument):
            return led(_FUNCTIONS[name], noun(scene, argument))
        case Binary():
            return _binary(scene, tree)
        case Pair(x, y):
            return pair("the vector with components ", noun(scene, x), " and ", noun(scene, y))
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


# --- arithmetic -----------------------------------------------------------------------------------


def _binary(scene: Scene, tree: Binary) -> Noun:
    left, right = tree.left, tree.right
    match tree.op:
        case "+":
            return _sum(scene, terms(tree))
        case "-":
            return _difference(scene, left, right)
        case "*" if not has_quantity(left):
            return led(values.times(left), noun(scene, right))
        case "*" if not has_quantity(right):
            return led(values.times(right), noun(scene, left))
        case "*":
            return pair("the product of ", noun(scene, left), " and ", noun(scene, right))
        case "/":
            return _ratio(scene, left, right)
    if right == Number(Fraction(2)):
        return led("the square of ", noun(scene, left))
    return pair("", noun(scene, left), " to the power ", noun(scene, right))


def terms(tree: Expression) -> list[Expression]:
    """The terms of a sum, as far as it only adds."""
    if is_binary(tree, "+"):
        return [*terms(tree.left), *terms(tree.right)]
    return [tree]


def alike(nouns: Sequence[Noun]) -> bool:
    """Whether nouns are of one kind at one moment, of several bodies: the speeds of A and B."""
    first = nouns[0]
    bodies = {one.body for one in nouns}
    plain = first.kind and not first.tail and len(bodies) == len(nouns) > 1
    return bool(plain) and all((one.kind, one.when) == (first.kind, first.when) for one in nouns)


def times_until(scene: Scene, trees: Sequence[Expression]) -> tuple[Words, list[Words]] | None:
    """Times that are counted from one start: its words, and what ends each; None for others."""
    phrases = [_time_parts(scene, tree) for tree in trees]
    starts = [parts[0] for parts in phrases if parts is not None and parts[0]]
    if len(starts) < len(trees) or len(set(starts)) > 1 or len(trees) < 2:
        return None
    return starts[0], [parts[1] for parts in phrases if parts is not None]


def until(last: Sequence[Words]) -> Words:
    """``until A hits W and until A hits V``."""
    return listed([words("until ", ending) for ending in last])


def _sum(scene: Scene, added: Sequence[Expression]) -> Noun:
    nouns = [noun(scene, one) for one in added]
    if alike(nouns):
        return Noun(
            words("the sum of ", of_bodies(nouns[0].kind, [x.body for x in nouns])), nouns[0].when
        )
    times = times_until(scene, added)
    if times is not None:
        start, last = times
        return Noun(words("the sum of the times from ", start, " ", until(last)))
    total = pair("the sum of ", nouns[0], " and ", nouns[1])
    for one in nouns[2:]:
        total = pair("the sum of ", total, " and ", one)
    return total


def _difference(scene: Scene, left: Expression, right: Expression) -> Noun:
    match left, right:
        case Quantity("time", (), int(later)), Quantity("time", (), int(earlier)) if (
            earlier < later
        ):
            first, then = event_name(scene, earlier), event_name(scene, later)
            return Noun(words("the time between ", first, " and ", then))
        case Quantity("velocity", (Name(a),)), Quantity("velocity", (Name(b),)) if a != b:
            one, other = noun(scene, left), noun(scene, right)
            if (one.kind, one.when) == (other.kind, other.when):
                relative = words(f"the {one.kind} of ", Emphasis(a), " relative to ", Emphasis(b))
                return Noun(relative, one.when)
    between = displacement(scene, Binary("-", left, right))
    if between is not None:
        return between
    change = _change(scene, left, right)
    if change is not None:
        return change
    one, other = noun(scene, left), noun(scene, right)
    if values.is_vector(left) or values.is_vector(right):
        return pair("", one, " minus ", other)
    return Noun(words("the amount by which ", one.words(), " exceeds ", other.words()))


def _change(scene: Scene, left: Expression, right: Expression) -> Noun | None:
    """What one quantity has gained or lost in one event; a vector has changed."""
    if not isinstance(left, Quantity) or not isinstance(right, Quantity):
        return None
    if (left.kind, left.arguments) != (right.kind, right.arguments) or left.kind not in CHANGED:
        return None
    body = name_of(left.arguments[0]) if left.arguments else None  # of all bodies
    later, earlier = (
        None if isinstance(quantity.stage, AtTime) else scene.stage(quantity.stage, body)
        for quantity in (left, right)
    )
    if later is None or earlier is None:
        return None
    between = range(min(later, earlier) + 1, max(later, earlier) + 1)
    own = [n for n in between if _is_changed(scene.events[n - 1], body)]
    if len(own) != 1:
        return None
    (number,) = own
    vector = left.kind in ("velocity", "momentum")
    if vector and later < earlier:
        return None
    change = "change" if vector else "increase" if later > earlier else "decrease"
    if body is not None:
        head = of_bodies(left.kind, (body,))
    else:
        head = of_several("momentum", "", ()) if vector else energy_of_all(scene, "")
    return Noun(words(f"the {change} in ", head), during(scene, number))


def _is_changed(event: Event, body: str | None) -> bool:
    """Whether an event changes how a body moves, or any of all."""
    return not isinstance(event, Arrival) and (body is None or body in bodies_of(event))


def _ratio(scene: Scene, left: Expression, right: Expression) -> Noun:
    match left, right:
        case Quantity(kind), Quantity("energy") if kind in LOSSES:
            whole, lost = whole_energy(scene, left, right), lost_where(scene, left)
            return Noun(words("the fraction of ", whole, " that is lost", lost))
    if isinstance(right, Number) and right.value:
        return led(values.times(rational(1 / right.value)), noun(scene, left))
    if not has_quantity(right):
        return _divided(noun(scene, left), right)
    return pair("the ratio of ", noun(scene, left), " to ", noun(scene, right))


def _divided(above: Noun, below: Expression) -> Noun:
    return Noun(words(above.words(), " divided by ", lay.bracketed(lay.from_tree(below))))


def share(scene: Scene, tree: Expression) -> Noun | None:
    """A ratio as a percentage: the decrease in the speed of P as a percentage of its speed."""
    match tree:
        case Binary("/", left, right) if has_quantity(left) and has_quantity(right):
            lost = is_quantity(left, *LOSSES)
            if not (lost and is_quantity(right, "energy")):
                return pair("", noun(scene, left), " as a percentage of ", noun(scene, right))
    return None


# --- places ---------------------------------------------------------------------------------------


def ends(scene: Scene, tree: Expression) -> tuple[Expression, Expression] | None:
    """Where a vector between two places begins and ends; None for any other vector."""
    origin = Pair(Number(Fraction(0)), Number(Fraction(0)))
    match tree:
        case Binary("-", end, begin) if _is_place(scene, end) and _is_place(scene, begin):
            pair = (begin, end)
        case Negate(begin) if _is_somewhere(scene, begin):
            pair = (begin, origin)
        case _ if _is_somewhere(scene, tree):
            pair = (origin, tree)
        case _:
            return None
    return pair if any(_is_somewhere(scene, tree) for tree in pair) else None


def _is_somewhere(scene: Scene, tree: Expression) -> bool:
    """Whether a tree is the place of a body, or a named point."""
    if isinstance(tree, Name):
        return any(tree.name == point.name for point in scene.problem.points)
    return is_quantity(tree, "position")


def _is_place(scene: Scene, tree: Expression) -> bool:
    return _is_somewhere(scene, tree) or (isinstance(tree, Pair) and not has_quantity(tree))


def displacement(scene: Scene, tree: Expression) -> Noun | None:
    """``the vector from O to the position of S when it hits W``."""
    pair = ends(scene, tree)
    if pair is None:
        return None
    begin, end = pair
    to = somewhere(scene, end)
    match begin, end:
        case Quantity("position", (Name(a),)), Quantity("position", (Name(b),)) if a == b:
            if not _has_size(scene):
                when = _place_when(scene, end, a)
                initial = when == INITIALLY
                to = words("its initial position") if initial else words("its position ", when)
    return Noun(words("the vector from ", somewhere(scene, begin), " to ", to))


def somewhere(scene: Scene, tree: Expression) -> Words:
    """A place to be or to go to: ``O``, ``the point (3, 7)``, ``the initial position of S``."""
    if isinstance(tree, Quantity):
        return _position(scene, tree).words()
    if isinstance(tree, Pair):
        for point in scene.problem.points:
            if point.position == tree:
                return (Emphasis(point.name),)
    return values.point(tree)


def whole_energy(scene: Scene, lost: Quantity, whole: Quantity) -> Words:
    """The energy of which a part is lost; that just before needs no moment."""
    number = event_number(scene, lost)
    start = 0 if lost.kind == "total_energy_lost" else number - 1
    phrase = noun(scene, whole)
    if not whole.arguments and len(scene.events) == 1 and scene.stage(whole.stage, None) == start:
        return phrase.head
    return phrase.words()


# --- quantities -----------------------------------------------------------------------------------


def moment(scene: Scene, tree: Quantity, body: str | None) -> Words:
    """When a quantity is meant that goes on from event to event."""
    if tree.stage == "before":
        return just_before(scene, body)
    if isinstance(tree.stage, AtTime):
        return at_time(scene, tree.stage)
    number = scene.stage(tree.stage, body)
    # No event is told yet by whose name this moment could go.
    return INITIALLY if scene.now == number == 0 else after(scene, number, body)


def _place_when(scene: Scene, tree: Quantity, body: str | None) -> Words:
    """When a body is somewhere."""
    if isinstance(tree.stage, AtTime):
        return at_time(scene, tree.stage)
    subject = None if _has_size(scene) else body
    return instant(scene, scene.stage(tree.stage, body), subject)


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


def _of_bodies(scene: Scene, tree: Quantity) -> Noun:
    """What is said of bodies at a moment, or of all of them."""
    named = [name_of(argument) or "" for argument in tree.arguments]
    body = named[0] if named else None
    when = moment(scene, tree, body) if KINDS[tree.kind].staged else ()
    if len(named) == 1:
        return at_moment(tree.kind, named[0], when)
    initial, when = (INITIAL, ()) if when == INITIALLY else ("", when)
    return Noun(of_several(tree.kind, initial, named), when)


def _direction(scene: Scene, tree: Quantity) -> Noun:
    name = name_of(tree.arguments[0]) or ""
    if scene.is_wall(name):
        return Noun(words("the direction of ", Emphasis(name)))
    moving = at_moment("direction", name, moment(scene, tree, name))
    return led(("the angle anticlockwise from ", values.EAST, " to "), moving)


def _energy(scene: Scene, tree: Quantity) -> Noun:
    if tree.arguments:
        return _of_bodies(scene, tree)
    when = moment(scene, tree, None)
    initial, when = (INITIAL, ()) if when == INITIALLY else ("", when)
    return Noun(energy_of_all(scene, initial), when)


def line(scene: Scene, tree: Expression) -> Noun:
    """A direction as the side of an angle."""
    match tree:
        case Name(name):
            return Noun((Emphasis(name),))
        case Quantity("line_of_centres"):
            number = event_number(scene, tree)
            event = scene.events[number - 1] if number else None
            if isinstance(event, Impact) and scene.is_wall(event.second):
                return Noun(words("the perpendicular to ", Emphasis(event.second)))
            return Noun(("the line of centres",), in_event(scene, number))
        case Quantity("velocity", (Name(name),)):
            return at_moment("direction", name, moment(scene, tree, name))
        case Quantity("direction", (Name(name),)):
            if scene.is_wall(name):
                return Noun((Emphasis(name),))
            return at_moment("direction", name, moment(scene, tree, name))
    between = displacement(scene, tree)
    if between is not None:
        return between
    if has_quantity(tree):
        return noun(scene, tree)
    return Noun(values.direction_of(scene.style, tree))


def _angle(scene: Scene, tree: Quantity) -> Noun:
    one, other = (line(scene, argument) for argument in tree.arguments)
    if one.kind == other.kind != "" and one.body != other.body and one.when == other.when:
        return Noun(
            words("the angle between ", of_bodies(one.kind, (one.body, other.body))), one.when
        )
    if one.kind and other.kind:
        return Noun(words("the angle between ", one.words(), " and ", of_its_body(one, other)))
    if other.kind and not one.kind:
        one, other = other, one
    if not one.kind:
        return pair("the angle between ", one, " and ", other)
    apart = one.when and other.when and not same_event(one.when, other.when)
    if apart or any(_is_between(argument) for argument in tree.arguments):
        return Noun(words("the angle between ", one.words(), " and ", other.words()))
    return Noun(
        words("the angle that ", one.head, " makes with ", other.head), one.when or other.when
    )


def _is_between(tree: Expression) -> bool:
    """Whether a direction is told by more than a name, or by a place and its moment."""
    simple = isinstance(tree, Quantity) and tree.kind in ("velocity", "direction", _LINE)
    return has_quantity(tree) and not simple


def _along(scene: Scene, tree: Quantity) -> Noun:
    vector, axis = tree.arguments
    of = noun(scene, vector)
    axis_noun = _axis(scene, axis, across=tree.kind == "across")
    if has_quantity(axis) and not _is_line(axis):
        return Noun(words("the component of ", of.words(), " in ", axis_noun.words()))
    if axis_noun.when and of.when and axis_noun.when != of.when:
        return Noun(words("the component of ", of.words(), " in ", axis_noun.words()))
    tail = words(" in ", axis_noun.head)
    head = words("the component of ", of.head, tail)
    if of.kind == "velocity":
        return Noun(head, of.when, f"component{tail}", of.body, tail)
    return Noun(head, of.when or axis_noun.when)


def _is_line(axis: Expression) -> bool:
    return is_quantity(axis, _LINE)


def _axis(scene: Scene, axis: Expression, *, across: bool) -> Noun:
    """The direction of a component, with its sense."""
    turn = "the direction at 90° anticlockwise from " if across else "the direction of "
    if is_quantity(axis, _LINE):
        return led(turn, sensed_line(scene, axis))
    if isinstance(axis, Name):
        wall = scene.wall(axis.name)
        match wall.shape if wall is not None else None:
            case Line(along) if along is not None:
                axis = along
            case Segment(start, end):
                ends = (values.spot(start), " to ", values.spot(end))
                return Noun(words(turn, Emphasis(axis.name), ", taken from ", *ends, ","))
            case _:
                return Noun(words(turn, Emphasis(axis.name)))
    if is_quantity(axis, "direction"):
        return led(turn if across else "", line(scene, axis))
    between = displacement(scene, axis)
    if between is not None or has_quantity(axis):
        return led(turn, between or noun(scene, axis))
    if across:
        left = values.to_the_left(scene.style, axis)
        return Noun(left if isinstance(left[0], str) else words("the direction of ", left))
    if values.is_vector(axis):
        return Noun(words("the direction of ", values.direction_of(scene.style, axis)))
    return Noun(words(values.direction_of(scene.style, axis)))


def sensed_line(scene: Scene, tree: Quantity) -> Noun:
    """A line of centres with its sense: from the first body to the second, or into the wall."""
    plain = line(scene, tree)
    number = event_number(scene, tree)
    event = scene.events[number - 1] if number else None
    if not isinstance(event, Impact):
        return plain
    if scene.is_wall(event.second):
        return Noun(words(plain.head, ", directed into it,"), plain.when)
    return Noun(
        words(plain.head, " from ", Emphasis(event.first), " to ", Emphasis(event.second)),
        plain.when,
    )


def _position(scene: Scene, tree: Quantity) -> Noun:
    """``the position of S when it hits W``, ``the initial position of S``."""
    at = place(scene, tree)
    if at.when == INITIALLY:
        return Noun(words(f"the {INITIAL}position of ", at.head))
    return Noun(words("the position of ", at.head), at.when)


def place(scene: Scene, tree: Quantity) -> Noun:
    """What is somewhere, a sphere or its centre, and when."""
    body = name_of(tree.arguments[0]) or ""
    centre = "the centre of " if _has_size(scene) else ""
    return Noun(words(centre, Emphasis(body)), _place_when(scene, tree, body))


def _has_size(scene: Scene) -> bool:
    """Whether a sphere's centre has to be told from the sphere."""
    return any(sphere.radius is not None for sphere in scene.problem.spheres)


def _time(scene: Scene, tree: Quantity) -> Noun:
    start, end = _time_parts(scene, tree) or ((), ())
    return Noun(words("the time from ", start, " until ", end) if start else end)


def _time_parts(scene: Scene, tree: Expression) -> tuple[Words, Words] | None:
    """From when to when a time is; of a moment the name alone; None for what is no time."""
    if not is_quantity(tree, "time"):
        return None
    number = tree.stage if isinstance(tree.stage, int) else scene.now
    if number == 0:
        return (), ("the time at the start",)
    if not scene.timed():
        for first, event in enumerate(scene.events, 1):
            if isinstance(event, Impact) and not scene.is_wall(event.second):
                if first == number:
                    return (), words("the time of ", event_name(scene, number))
                return event_name(scene, first), happening(scene, number)
            break
    return ("the start",), happening(scene, number)


def _somewhere(scene: Scene, tree: Expression) -> Noun:
    """One end of a distance."""
    match tree:
        case Name(name):
            return Noun((Emphasis(name),))
        case Quantity("position", (Name(),)):
            return _position(scene, tree)
    return Noun(values.point(tree)) if not has_quantity(tree) else noun(scene, tree)


def _distance(scene: Scene, tree: Quantity) -> Noun:
    one, other = tree.arguments
    spheres = {sphere.name for sphere in scene.problem.spheres}
    bodies = [
        argument.name
        for argument in tree.arguments
        if isinstance(argument, Name) and argument.name in spheres
    ]
    if len(bodies) == 2:
        centres = "the centres of " if _has_size(scene) else ""
        when = _place_when(scene, tree, None)
        initial, when = (INITIAL, ()) if when == INITIALLY else ("", when)
        return Noun(words(f"the {initial}distance between ", centres, names(bodies)), when)
    left, right = _somewhere(scene, one), _somewhere(scene, other)
    match one, other:
        case Quantity("position", (Name(a),)), Quantity("position", (Name(b),)) if a == b:
            first, second = left.when or INITIALLY, right.when or INITIALLY
            if second == INITIALLY:
                first, second = second, first
            moments = (" ", first, " and ", second)
            return Noun(words("the distance between the positions of ", Emphasis(a), *moments))
    if bodies:
        when = _place_when(scene, tree, bodies[0])
        if when == INITIALLY:
            return Noun(words("the initial distance between ", left.head, " and ", right.head))
        return Noun(words("the distance between ", left.head, " and ", right.head), when)
    return Noun(words("the distance between ", left.words(), " and ", right.words()))


def _dot(scene: Scene, tree: Quantity) -> Noun:
    one, other = (_vector(scene, argument) for argument in tree.arguments)
    return pair("the scalar product of ", one, " and ", other)


def _vector(scene: Scene, tree: Expression) -> Noun:
    return (
        Noun(values.direction_of(scene.style, tree))
        if not has_quantity(tree)
        else noun(scene, tree)
    )


_QUANTITIES: Mapping[str, Callable[[Scene, Quantity], Noun]] = {
    "direction": _direction,
    "impulse": impulse,
    "energy": _energy,
    "energy_lost": energy_lost,
    "total_energy_lost": total_energy_lost,
    "line_of_centres": line_of_centres,
    "angle": _angle,
    "along": _along,
    "across": _along,
    "position": _position,
    "time": _time,
    "distance": _distance,
    "dot": _dot,
}
