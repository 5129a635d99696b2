"""Places and times: where a body is at an event, when that is, and how far things are apart.

Between two events a body moves in a straight line at constant speed. A time follows from a
distance and the component of the velocity in that one direction; a place follows from a time.
Everything is counted along **i** and **j**. Where something in the data is asked for because a
body comes to a point, its path gives an equation, in which no time stands.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Expression,
    Name,
    Quantity,
    Unit,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.angles import range_of
from restitution.planning.closing import nonzero
from restitution.planning.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.forms import (
    ZERO,
    difference,
    negative,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.frames import Frame
from restitution.planning.impacts import before, in_direction
from restitution.planning.resolving import along_axis, unit_of
from restitution.planning.routes import Candidate
from restitution.planning.scene import Scene
from restitution.problem import Arrival, Impact
from restitution.solve.quantities import quantity as quantity_of
from restitution.vector import Vector

Axis = Literal["i", "j"]
AXES: tuple[Axis, Axis] = ("i", "j")
KINDS = frozenset({"time", "position", "distance"})


# --- trees --------------------------------------------------------------------------------------


def time_tree(number: int) -> Quantity:
    """The time of an event; of event 0, the start."""
    return Quantity("time", (), number)


def place_tree(body: str, stage: int) -> Quantity:
    """Where a body is at an event."""
    return Quantity("position", (Name(body),), stage)


def coordinate_tree(body: str, stage: int, axis: Axis) -> Quantity:
    """A coordinate of the place of a body at an event."""
    return Quantity("along", (place_tree(body, stage), Unit(axis)))


def serves(tree: Expression) -> bool:
    """Whether a quantity is a time, a place, a coordinate or a distance."""
    match tree:
        case Quantity("along" | "across", (Quantity("position"), _)):
            return True
        case Quantity(kind):
            return kind in KINDS
    return False


def is_duration(tree: Expression) -> bool:
    """Whether an expression is the time between two events."""
    match tree:
        case Binary("-", Quantity("time", (), int()), Quantity("time", (), int())):
            return True
    return False


def is_about_times(own: Link) -> bool:
    """Whether an equation is one between times, and perhaps letters."""
    nodes = [each for side in (own.left, own.right) for each in walk(side)]
    kinds = {each.kind for each in nodes if isinstance(each, Quantity)}
    return kinds == {"time"}


# --- what is known ------------------------------------------------------------------------------


def _put(scene: Scene, value: Any, refs: Sequence[Ref] = ()) -> Source:
    own, more = scene.put(value)
    return Source(own, together(refs, more))


def _known(scene: Scene, tree: Expression) -> Source | None:
    source = scene.desk.known(tree)
    return None if source is None else _put(scene, source.value, source.refs)


def _last_move(scene: Scene, body: str, number: int) -> int:
    """The last event before another one in which a body took part; 0 for the start."""
    latest = scene.model.story.latest(body, number - 1)
    return 0 if latest is None else latest.number


def velocity(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """The component of a velocity along an axis, after so many events."""
    source = along_axis(scene, body, stage, axis)
    own = _put(scene, source.value, source.whole)
    letters_ = {each.symbol for each in scene.model.components.values()}
    if letters_ & own.value.free_symbols:
        raise NotPlannedError(f"the velocity of {body} after event {stage} is open")
    return own


def start(scene: Scene) -> tuple[int, tuple[Ref, ...]]:
    """The event at which the clock starts, and the fact that says so."""
    fact = scene.facts.get("start")
    if fact is None:
        raise NotPlannedError("the clock does not start")
    (own,) = fact.relation.only
    assert isinstance(own.left, Quantity)
    assert isinstance(own.left.stage, int)
    return own.left.stage, (fact.id,)


def _contact(scene: Scene, number: int) -> Iterator[Link]:
    for fact in scene.desk.facts:
        if fact.id == f"contact {number}":
            yield from fact.relation.only


def _of_contact(scene: Scene, body: str, number: int, axis: Axis) -> Source | None:
    """A coordinate that the place of an event gives at once: of an aligned wall, or of a point."""
    refs: tuple[Ref, ...] = (f"contact {number}",)
    for own in _contact(scene, number):
        if own.left == coordinate_tree(body, number, axis):
            return _put(scene, scene.scalar(own.right), refs)
        if own.left == place_tree(body, number) and not has_quantity(own.right):
            place = scene.value(own.right)
            return _put(scene, _part(place, axis), refs)
    return None


def _part(place: Any, axis: Axis) -> sp.Expr:
    x, y = place
    return sp.sympify(x if axis == "i" else y, strict=True)


def _partner(scene: Scene, body: str, number: int) -> str | None:
    """The other sphere of an impact of two."""
    others = [each for each in scene.bodies(number) if each != body]
    if len(others) != 1 or others[0] not in scene.model.story.spheres:
        return None
    return others[0]


# --- places -------------------------------------------------------------------------------------


def coordinate(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate of a body at an event; written down where it is worked out."""
    given = _coordinate_given(scene, body, stage, axis)
    return _moved(scene, body, stage, axis) if given is None else given


def _coordinate_given(scene: Scene, body: str, stage: int, axis: Axis) -> Source | None:
    """A coordinate that needs no working: of the data, of a line, or of the other body there."""
    if stage == 0:
        fact = scene.facts.get(f"position {body}")
        if fact is None:
            raise NotPlannedError(f"the place of {body} at the start is not given")
        place = scene.value(fact.relation.only[0].right)
        return _put(scene, _part(place, axis), (fact.id,))
    known = _known(scene, coordinate_tree(body, stage, axis))
    if known is not None:
        return known
    if body not in scene.bodies(stage):
        return None
    if "origin" in scene.facts and stage == start(scene)[0]:
        refs: tuple[Ref, ...] = ("origin",)
        if body != scene.bodies(stage)[0]:
            refs = (f"contact {stage}", "origin")
        return Source(sp.Integer(0), refs)
    given = _of_contact(scene, body, stage, axis)
    if given is not None:
        return given
    other = _partner(scene, body, stage)
    if other is None or not any(True for _ in _contact(scene, stage)):
        return None
    theirs = _known(scene, coordinate_tree(other, stage, axis))
    if theirs is None and _rests(scene, other, stage):
        theirs = _moved(scene, other, stage, axis)
    if theirs is None:
        return None
    gap, refs = scene.put(_apart(scene, body, stage, axis))
    return Source(tidy(theirs.value + gap), together((f"contact {stage}",), theirs.refs, refs))


def _apart(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    """How far, along an axis, a centre is ahead of the one that it touches."""
    own = next(_contact(scene, stage))
    match own.right:
        case Binary("+" | "-" as sign, Quantity("position"), offset):
            length = _part(scene.value(offset), axis)
            return length if (sign == "+") == (own.left == place_tree(body, stage)) else -length
    return sp.Integer(0)


def _rests(scene: Scene, body: str, stage: int) -> bool:
    """Whether a body is at rest until an event."""
    own, _ = scene.put(scene.velocity(body, _last_move(scene, body, stage)))
    return all(scene.model.in_data(each) == 0 for each in own)


def _keeps(scene: Scene, body: str, since: int, axis: Axis) -> bool:
    """Whether a body does not move along an axis after an event."""
    pace = scene.model.in_data(_part(scene.velocity(body, since), axis))
    return bool(pace == 0)


def _moved(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate by the time since the last event of a body."""
    if _rests(scene, body, stage) or _open_line(scene, body, stage) is not None:
        place = _place_moved(scene, body, stage)
        return Source(_part(place.value, axis), place.refs)
    since = _last_move(scene, body, stage)
    if not _keeps(scene, body, since, axis):
        time_of(scene, stage)
    first = coordinate(scene, body, since, axis)
    pace = velocity(scene, body, since, axis)
    refs = [*first.refs, *pace.refs]
    tree: Expression = tree_of(first.value)
    value = first.value
    if pace.value != 0:
        flight, length, used = _flight_time(scene, since, stage)
        refs += used
        tree = total((tree, product(tree_of(pace.value), flight)))
        value = tidy(first.value + pace.value * length)
    quantity = coordinate_tree(body, stage, axis)
    number = scene.desk.write(
        Move("define", "straight-line", stage, (body,)),
        refs,
        chain(quantity, (swept(tree), None), (tree_of(value), "rearrange")),
    )
    return scene.desk.know(quantity, value, (number,))


def _flight_time(
    scene: Scene, since: int, stage: int
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The time between two events, as a difference, and what it is worth."""
    early, late = time_of(scene, since), time_of(scene, stage)
    tree = difference(tree_of(late.value), tree_of(early.value))
    return tree, tidy(late.value - early.value), together(early.refs, late.refs)


def _place_moved(scene: Scene, body: str, stage: int) -> Source:
    """A place by the velocity since the last event of a body, as a vector."""
    quantity = place_tree(body, stage)
    known = _known(scene, quantity)
    if known is not None:
        return known
    since = _last_move(scene, body, stage)
    if not _rests(scene, body, stage):
        time_of(scene, stage)
    open_ = _open_line(scene, body, stage)
    if open_ is not None:
        time = time_of(scene, stage)
        value = _tidied(scene, scene.value(quantity))
        number = scene.desk.write(
            Move("put"), (open_, *time.refs), chain(quantity, (tree_of(value), None))
        )
        return _know_place(scene, body, stage, value, number)
    first, pace = _spot(scene, body, since), _velocity_then(scene, body, since)
    refs = together(first.refs, pace.refs)
    tree: Expression = tree_of(first.value)
    value = first.value
    if tuple(pace.value) != (0, 0):
        flight, length, used = _flight_time(scene, since, stage)
        refs = together(refs, used)
        tree = _added(first.value, flight, pace.value)
        value = Vector(
            *(tidy(a + b * length) for a, b in zip(first.value, pace.value, strict=True))
        )
    number = _write_place(
        scene, Move("define", "straight-line", stage, (body,)), quantity, refs, tree, value
    )
    return _know_place(scene, body, stage, value, number)


def _write_place(
    scene: Scene,
    move: Move,
    quantity: Expression,
    refs: Sequence[Ref],
    tree: Expression,
    value: Vector,
) -> int:
    own = tree_of(value)
    number = scene.desk.write(move, refs, chain(quantity, (tree, None)))
    if own != tree:
        number = scene.desk.write(Move("rearrange"), (number,), chain(quantity, (own, None)))
    return number


def _added(first: Vector, flight: Expression, pace: Vector) -> Expression:
    """A place and a velocity for some time."""
    own = tree_of(pace)
    return swept(total((tree_of(first), product(flight, own))))


def _know_place(scene: Scene, body: str, stage: int, value: Vector, number: int) -> Source:
    for axis, each in zip(AXES, value, strict=True):
        scene.desk.know(coordinate_tree(body, stage, axis), each, (number,))
    return scene.desk.know(place_tree(body, stage), value, (number,))


def _spot(scene: Scene, body: str, stage: int) -> Source:
    """A place by its coordinates, without a line of its own."""
    known = _known(scene, place_tree(body, stage))
    if known is not None:
        return known
    if stage and all(_coordinate_given(scene, body, stage, axis) is None for axis in AXES):
        return _place_moved(scene, body, stage)
    x, y = (coordinate(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def _velocity_then(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector, by its components along **i** and **j**."""
    x, y = (velocity(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def _tidied(scene: Scene, place: Any) -> Vector:
    own, _ = scene.put(place)
    return Vector(*(tidy(each) for each in own))


def _open_line(scene: Scene, body: str, stage: int) -> int | None:
    """The line that says where a body is by a time that is not yet known."""
    for each in scene.desk.lines:
        if each.move == Move("define", "straight-line", stage, (body,)) and scene.desk.holds(
            each.number
        ):
            (own, *_) = scene.desk.relation(each.number).only
            if own.left == place_tree(body, stage) and time_tree(stage) in set(walk(own.right)):
                return each.number
    return None


# --- times --------------------------------------------------------------------------------------


def time_of(scene: Scene, number: int) -> Source:
    """The time of an event; written down where it is worked out."""
    first, refs = start(scene)
    if number == first:
        return Source(sp.Integer(0), refs)
    known = _known(scene, time_tree(number))
    if known is not None:
        return known
    if number < first:
        raise NotPlannedError("a time before the clock starts")
    if number == 0:
        raise NotPlannedError("the start has no time")
    step = scene.model.happening(number).step
    if isinstance(step, Impact) and step.second in scene.model.story.spheres:
        return _time_of_meeting(scene, number, step)
    if not isinstance(step, Impact | Arrival):
        raise NotPlannedError("the time of a blow")
    body = scene.bodies(number)[0]
    axis = _axis_for(scene, body, number)
    if axis is None:
        return _time_to_slanted(scene, body, number)
    return _time_along(scene, body, number, axis)


def _axis_for(scene: Scene, body: str, number: int) -> Axis | None:
    """The direction in which it is known how far a body goes: the shorter one to write."""
    since = _last_move(scene, body, number)
    chosen: list[tuple[int, Axis]] = []
    for axis in AXES:
        if _of_contact(scene, body, number, axis) is None:
            continue
        pace = _value_of_velocity(scene, body, since, axis)
        if pace == 0:
            continue
        open_ = len(scene.unknown(pace))
        place = _value_of_coordinate(scene, body, since, axis)
        open_ += len(scene.unknown(place))
        chosen.append((1000 * open_ + sp.count_ops(pace), axis))
    return min(chosen)[1] if chosen else None


def _value_of_velocity(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    return tidy(_part(scene.velocity(body, stage), axis))


def _value_of_coordinate(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    return tidy(_part(scene.value(place_tree(body, stage)), axis))


def _time_along(scene: Scene, body: str, number: int, axis: Axis) -> Source:
    """A time by a distance and a speed in one direction."""
    since = _last_move(scene, body, number)
    early = time_of(scene, since)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    pace = velocity(scene, body, since, axis)
    return _flight(scene, number, body, (first, last), pace, early)


def _flight(
    scene: Scene,
    number: int,
    body: str,
    ends: tuple[Source, Source],
    pace: Source,
    early: Source,
) -> Source:
    first, last = ends
    tree = _quotient(scene, last.value, first.value, pace.value)
    value = tidy(early.value + (last.value - first.value) / pace.value)
    refs = together(
        first.refs,
        last.refs,
        pace.refs,
        early.refs,
        _divisor(scene, tidy(last.value - first.value), pace.value),
    )
    quantity = time_tree(number)
    line = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        refs,
        chain(
            quantity,
            (swept(total((tree_of(early.value), tree))), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(quantity, value, (line,))


def _swept_product(scene: Scene, last: sp.Expr, first: sp.Expr, pace: sp.Expr) -> Expression:
    """A way times a component, each written as a positive number as far as values tell."""
    minus = False
    if scene.model.sign(scene.model.in_data(last - first)) < 0:
        last, first, minus = first, last, not minus
    if scene.model.sign(scene.model.in_data(pace)) < 0:
        pace, minus = -pace, not minus
    tree = swept(product(difference(tree_of(last), tree_of(first)), tree_of(pace)))
    return negative(tree) if minus else tree


def _divisor(scene: Scene, way: sp.Expr, pace: sp.Expr) -> tuple[Ref, ...]:
    """What tells that a speed is not zero: nothing, where the way plainly is not."""
    if all(_is_plainly_not_zero(scene, each) for each in sp.Mul.make_args(sp.factor(way))):
        return ()
    return nonzero(scene, pace)


def _is_plainly_not_zero(scene: Scene, factor: sp.Expr) -> bool:
    """Whether a factor is a number, or made of positive letters and terms of one sign."""
    base = factor.base if factor.is_Pow else factor
    roles = scene.model.unknowns.roles
    terms = sp.Add.make_args(base)
    for letter in base.free_symbols:
        role = roles.get(letter.name)
        if role is None or role.kind != "positive":
            return False
    return len({sp.sign(each.as_coeff_Mul()[0]) for each in terms}) == 1


def _quotient(scene: Scene, last: sp.Expr, first: sp.Expr, pace: sp.Expr) -> Expression:
    """A distance over a speed, both positive as far as their values tell."""
    if scene.model.sign(pace) < 0:
        last, first, pace = first, last, -pace
    way = difference(tree_of(last), tree_of(first))
    return Binary("/", way, tree_of(pace))


def _time_to_slanted(scene: Scene, body: str, number: int) -> Source:
    """The time to a wall that is not along an axis: the coordinates by the time, on its line."""
    match next(_contact(scene, number), None):
        case Link(Quantity("dot", (Binary("-", _, through), normal)), "=", _):
            place, axis = _tidied(scene, scene.value(through)), _tidied(scene, scene.value(normal))
        case _:
            raise NotPlannedError("the time to a wall whose place is not given")
    since = _last_move(scene, body, number)
    first, pace, early = (
        _spot(scene, body, since),
        _velocity_then(scene, body, since),
        time_of(scene, since),
    )
    t = time_tree(number)
    flight = difference(t, tree_of(early.value))
    open_ = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(first.refs, pace.refs, early.refs),
        chain(place_tree(body, number), (_added(first.value, flight, pace.value), None)),
    )
    terms = [
        product(
            tree_of(n),
            total((tree_of(tidy(a - b)), product(tree_of(v), flight))),
        )
        for n, a, b, v in zip(axis, first.value, place, pace.value, strict=True)
        if n != 0
    ]
    fact = scene.desk.write(
        Move("fact"), (f"contact {number}", open_), Relation(((link(swept(total(terms)), ZERO),),))
    )
    closing = tidy(pace.value.dot(axis))
    value = tidy(early.value + (place - first.value).dot(axis) / closing)
    line = scene.desk.write(
        Move("rearrange"), (fact, *nonzero(scene, closing)), chain(t, (tree_of(value), None))
    )
    return scene.desk.know(t, value, (line,))


def _time_of_meeting(scene: Scene, number: int, step: Impact) -> Source:
    """The time at which two spheres meet, from the one direction in which they approach."""
    if not any(True for _ in _contact(scene, number)):
        raise NotPlannedError("where spheres with radii touch")
    for body, other in ((step.first, step.second), (step.second, step.first)):
        if _rests(scene, other, number):
            return _time_to_resting(scene, number, body, other)
    if any(_apart(scene, step.first, number, axis) != 0 for axis in AXES):
        raise NotPlannedError("where two spheres with radii touch that both move")
    return _time_of_two(scene, number, step.first, step.second)


def _time_to_resting(scene: Scene, number: int, body: str, other: str) -> Source:
    since = _last_move(scene, body, number)
    axis = _approach(scene, number, body, other)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    pace, early = velocity(scene, body, since, axis), time_of(scene, since)
    return _flight(scene, number, body, (first, last), pace, early)


def _approach(scene: Scene, number: int, body: str, other: str) -> Axis:
    """The direction in which two bodies come nearer to each other."""
    gaps: list[tuple[int, Axis]] = []
    for axis in AXES:
        gap = tidy(
            _value_of_velocity(scene, body, number - 1, axis)
            - _value_of_velocity(scene, other, number - 1, axis)
        )
        if gap != 0:
            gaps.append((sp.count_ops(gap), axis))
    if not gaps:
        raise NotPlannedError("two bodies that do not approach")
    return min(gaps)[1]


def _time_of_two(scene: Scene, number: int, body: str, other: str) -> Source:
    """The one's coordinate with the time as unknown; the other comes to the same place then."""
    axis = _approach(scene, number, body, other)
    t = time_tree(number)
    since = _last_move(scene, other, number)
    first, pace = coordinate(scene, other, since, axis), velocity(scene, other, since, axis)
    if pace.value == 0:
        last = _moved(scene, other, number, axis)
        there, constant, used = tree_of(last.value), last.value, last.refs
    else:
        early = time_of(scene, since)
        flight = difference(t, tree_of(early.value))
        there = swept(total((tree_of(first.value), product(tree_of(pace.value), flight))))
        constant = first.value - pace.value * early.value
        used = (
            scene.desk.write(
                Move("define", "straight-line", number, (other,)),
                together(first.refs, pace.refs, early.refs),
                chain(coordinate_tree(other, number, axis), (there, None)),
            ),
        )
    since = _last_move(scene, body, number)
    start_, speed = coordinate(scene, body, since, axis), velocity(scene, body, since, axis)
    early = time_of(scene, since)
    flight = difference(t, tree_of(early.value))
    own = swept(total((tree_of(start_.value), product(tree_of(speed.value), flight))))
    met = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(start_.refs, speed.refs, early.refs, (f"contact {number}",), used),
        chain(own, (there, None)),
    )
    closing = tidy(speed.value - pace.value)
    value = tidy((constant - start_.value + speed.value * early.value) / closing)
    line = scene.desk.write(
        Move("rearrange"),
        (met, *nonzero(scene, closing)),
        chain(t, (tree_of(value), None)),
    )
    return scene.desk.know(t, value, (line,))


# --- what is asked ------------------------------------------------------------------------------


def write(scene: Scene, asked: Expression) -> tuple[int, Any]:
    """Writes what a time, a place or a distance is; returns the last line, and the value.

    Raises NotPlannedError where there is no plan, and where the data say it already.
    """
    match asked:
        case Quantity("time", (), int(number)):
            source = time_of(scene, number)
        case Quantity("along", (Quantity("position", (Name(body),), int(stage)), Unit(axis))):
            source = coordinate(scene, body, stage, axis)
            if not any(isinstance(each, int) for each in source.refs):
                source = _moved(scene, body, stage, axis)
        case Quantity("position", (Name(body),), int(stage)):
            source = _place(scene, body, stage)
        case Quantity("position", (Name(body),), AtTime()):
            source = _place_then(scene, asked, body)
        case Quantity("distance", (_, _)):
            source = _distance(scene, asked)
        case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
            source = _duration(scene, asked, late, early)
        case _:
            raise NotPlannedError("no plan for a place of that kind")
    _check(scene, asked, source.value)
    lines = [each for each in source.refs if isinstance(each, int)]
    if not lines:
        raise NotPlannedError("what is asked is given")
    if len(lines) > 1:
        relation = chain(asked, (tree_of(source.value), None))
        lines = [scene.desk.write(Move("put"), source.refs, relation)]
        scene.desk.know(asked, source.value, lines)
    return lines[0], source.value


def _check(scene: Scene, asked: Expression, value: Any) -> None:
    """The value has to be that of the story."""
    own, in_data = scene.value(asked), scene.model.in_data
    pairs = zip(own, value, strict=True) if isinstance(value, Vector) else [(own, value)]
    gaps = [_sized(scene, in_data(a)) - _sized(scene, in_data(b)) for a, b in pairs]
    if not all(scene.model.identically_zero(each) for each in gaps):
        raise NotPlannedError("another piece of the path than the lines say")


def _place(scene: Scene, body: str, stage: int) -> Source:
    """A place by its coordinates, where one of them is given; else by a vector."""
    quantity = place_tree(body, stage)
    known = _known(scene, quantity)
    if known is not None:
        return known
    if all(_coordinate_given(scene, body, stage, axis) is None for axis in AXES):
        return _place_moved(scene, body, stage)
    parts = [coordinate(scene, body, stage, axis) for axis in AXES]
    value = Vector(*(each.value for each in parts))
    number = scene.desk.write(
        Move("define", "assemble", stage or None, (body,)),
        together(*(each.refs for each in parts)),
        chain(quantity, (tree_of(value), None)),
    )
    return scene.desk.know(quantity, value, (number,))


def _piece(scene: Scene, body: str, time: Expression) -> int:
    """The last event of a body before a time; of a letter that is open, its last one."""
    own = [n for n in range(1, scene.events + 1) if body in scene.bodies(n)]
    value = scene.scalar(time)
    later = bool(letters(time) & scene.model.story.open_times)
    if later:
        return own[-1] if own else 0
    chosen = 0
    for number in own:
        when = scene.model.happening(number).time
        if when is None:
            raise NotPlannedError("the time of an event is not known")
        if scene.model.sign(value - when) >= 0:
            chosen = number
    return chosen


def _place_then(scene: Scene, asked: Quantity, body: str) -> Source:
    """A place at a time: by the place and the velocity at the last event before it."""
    assert isinstance(asked.stage, AtTime)
    known = _known(scene, asked)
    if known is not None:
        return known
    since = _piece(scene, body, asked.stage.time)
    first, pace, early = (
        _spot(scene, body, since),
        _velocity_then(scene, body, since),
        time_of(scene, since),
    )
    flight, length, refs = _since(scene, asked.stage.time, since, early)
    tree = _added(first.value, flight, pace.value)
    value = Vector(*(tidy(a + b * length) for a, b in zip(first.value, pace.value, strict=True)))
    used = together(first.refs, pace.refs)
    if tuple(pace.value) != (0, 0):
        used = together(used, refs)
    number = _write_place(
        scene, Move("define", "straight-line", since or None, (body,)), asked, used, tree, value
    )
    return scene.desk.know(asked, value, (number,))


def _since(
    scene: Scene, time: Expression, event: int, early: Source
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """How long after an event a time is, as a tree, in value, and what that rests on."""
    match time:
        case Binary("+", own, later) if own == time_tree(event):
            value, refs = scene.put(scene.scalar(later))
            return tree_of(value), value, refs
    when, refs = scene.put(scene.scalar(time))
    tree = difference(tree_of(when), tree_of(early.value))
    return tree, tidy(when - early.value), together(early.refs, refs)


def _distance(scene: Scene, asked: Quantity) -> Source:
    """A distance by the coordinates of both ends, or by the velocities since they were together."""
    known = _known(scene, asked)
    if known is not None:
        return known
    if isinstance(asked.stage, AtTime):
        together_ = _distance_since_contact(scene, asked)
        if together_ is not None:
            return together_
    ends = [_end(scene, each, asked.stage) for each in asked.arguments]
    refs = together(*(each.refs for each in ends))
    (a, b) = (each.value for each in ends)
    return _write_distance(scene, asked, None, refs, [tidy(x) for x in a], [tidy(x) for x in b])


def _write_distance(
    scene: Scene,
    asked: Quantity,
    event: int | None,
    refs: Sequence[Ref],
    a: Sequence[sp.Expr],
    b: Sequence[sp.Expr],
    times: tuple[Expression, sp.Expr] | None = None,
) -> Source:
    gaps = []
    for x, y in zip(a, b, strict=True):
        gap = tidy(x - y)
        if gap == 0:
            continue
        if scene.model.sign(gap) < 0:
            x, y = y, x
        gaps.append((difference(tree_of(x), tree_of(y)), gap))
    if not gaps:
        raise NotPlannedError("a distance that is nothing")
    if len(gaps) == 1:
        ((tree, gap),) = gaps
        value = gap if scene.model.sign(gap) >= 0 else -gap
    else:
        tree = Apply("sqrt", total(square(each) for each, _ in gaps))
        value = sp.sqrt(tidy(sp.expand(sum(gap**2 for _, gap in gaps))))
    if times is not None:
        tree = product(times[0], tree)
        value = value * times[1]
    value = _sized(scene, tidy(value))
    number = scene.desk.write(
        Move("define", "distance", event),
        together(refs, *(_signs(scene, gap) for _, gap in gaps)),
        chain(asked, (swept(tree), None), (tree_of(value), "rearrange")),
    )
    return scene.desk.know(asked, value, (number,))


def _sized(scene: Scene, value: sp.Expr) -> sp.Expr:
    """A value in which sizes are taken with the sign that they have."""
    return tidy(
        value.replace(sp.Abs, lambda inside: inside if scene.model.sign(inside) >= 0 else -inside)
    )


def _signs(scene: Scene, gap: sp.Expr) -> tuple[Ref, ...]:
    """What tells the signs of the letters of a distance: ranges, and times that are positive."""
    refs = [*ranges(scene, gap), *_orders(scene, gap)]
    factors = sp.Mul.make_args(sp.factor(gap))
    for letter in gap.free_symbols.intersection(factors):
        role = scene.model.unknowns.roles.get(letter.name)
        if role is None or role.kind != "real":
            continue
        for number in range(1, scene.events + 1):
            time = scene.desk.known(time_tree(number))
            if time is not None and not time.value.is_Add and time.value.has(letter):
                refs += time.refs
                break
    return tuple(refs)


def _orders(scene: Scene, gap: sp.Expr) -> Iterator[Ref]:
    """The facts that tell of a difference in a value which of the two is the greater."""
    factors = [each for each in sp.Mul.make_args(sp.factor(gap)) if each.is_Add]
    for fact in scene.desk.facts:
        if fact.kind != "range" or not scene.desk.holds(fact.id) or len(fact.relation.options) > 1:
            continue
        for own in fact.relation.only:
            difference_ = sp.expand(scene.scalar(own.left) - scene.scalar(own.right))
            if any(sp.expand(each**2 - difference_**2) == 0 for each in factors):
                yield fact.id


def ranges(scene: Scene, value: sp.Expr) -> tuple[Ref, ...]:
    """What may be known of the letters of a value that are not plainly positive."""
    refs: list[Ref] = []
    for letter in sorted(value.free_symbols, key=lambda each: each.name):
        role = scene.model.unknowns.roles.get(letter.name)
        if role is not None and role.kind == "restitution":
            refs += [f"{letter.name} >= 0", f"{letter.name} <= 1"]
        elif role is not None and role.kind == "angle":
            refs.append(range_of(scene, letter.name))
    return tuple(refs)


def _end(scene: Scene, tree: Expression, stage: Any) -> Source:
    """One end of a distance: a point, or where a body is."""
    match tree:
        case Name(name) if f"point {name}" in scene.facts:
            value = _tidied(scene, scene.value(tree))
            return Source(value, (f"point {name}",))
        case Name(name):
            return _end(scene, Quantity("position", (tree,), stage), stage)
        case Quantity("position", (Name(body),), int(number)):
            return _spot(scene, body, number)
        case Quantity("position", (Name(body),), AtTime()):
            return _place_then(scene, tree, body)
    raise NotPlannedError("the end of a distance")


def _distance_since_contact(scene: Scene, asked: Quantity) -> Source | None:
    """How far apart two bodies are that met last, by their relative velocity and the time since.

    None where they met others in between.
    """
    assert isinstance(asked.stage, AtTime)
    names = [each.name for each in asked.arguments if isinstance(each, Name)]
    pieces = {
        _piece(scene, each, asked.stage.time) for each in names if each in scene.model.story.spheres
    }
    if len(names) != 2 or len(pieces) != 1:
        return None
    (met,) = pieces
    if not met or set(scene.bodies(met)) != set(names) or met not in scene.model.frames:
        return None
    frame = scene.frame(met)
    early = time_of(scene, met)
    flight, length, more = _since(scene, asked.stage.time, met, early)
    names = list(scene.bodies(met))
    apart = separation_known(scene, frame)
    across = [in_direction(scene, "across", each, met, frame) for each in names]
    if apart is None:
        along = [in_direction(scene, "along", each, met, frame) for each in names]
    else:
        along = [Source(sp.Integer(0)), apart]
    a, b = ([x, y] for x, y in zip(along, across, strict=True))
    named = [frame.component("across", names[0], met).arguments[-1]]
    if apart is None:
        named.append(frame.component("along", names[0], met).arguments[-1])
    else:
        named.append(_separation_direction(frame))
    used = together(
        more,
        (f"contact {met}",),
        () if all(isinstance(each, Unit) for each in named) else frame.refs,
        *(each.whole for each in (*a, *b)),
    )
    values = [[each.value for each in own] for own in (a, b)]
    return _write_distance(scene, asked, met, used, values[0], values[1], (flight, length))


def _separation_direction(frame: Frame) -> Expression:
    """The direction in which a separation is counted: of an axis, where that is the line."""
    for axis in AXES:
        if frame.n == unit_of(axis):
            return Unit(axis)
    return frame.along


def _separation_tree(scene: Scene, frame: Frame) -> Expression:
    first, second = scene.bodies(frame.number)
    direction = _separation_direction(frame)
    own, other = (
        Quantity("along", (Quantity("velocity", (Name(each),), frame.number), direction))
        for each in (second, first)
    )
    return Binary("-", own, other)


def separation_known(scene: Scene, frame: Frame) -> Source | None:
    """How fast two spheres separate along their line of centres, where that is known alone."""
    return _known(scene, _separation_tree(scene, frame))


def write_separation(scene: Scene, frame: Frame) -> None:
    """The law of restitution alone: the speed of separation from that of approach."""
    first, second = scene.bodies(frame.number)
    e = scene.coefficient(frame.number)
    u, x = (before(scene, "along", each, frame) for each in (first, second))
    if e.value == 0:
        u = x = Source(sp.Integer(0))
    value = tidy(e.value * (u.value - x.value))
    quantity = _separation_tree(scene, frame)
    approach = difference(tree_of(u.value), tree_of(x.value))
    number = scene.desk.write(
        Move("law", "restitution", frame.number, (first, second)),
        together(e.refs, u.whole, x.whole, frame.names_axis("along")),
        chain(
            quantity,
            (swept(product(tree_of(e.value), approach)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    scene.desk.know(quantity, value, (number,))


def _duration(scene: Scene, asked: Expression, late: int, early: int) -> Source:
    """The time between two events: of one body in one direction, or as a difference of times."""
    known = _known(scene, asked)
    if known is not None:
        return known
    times = [_known(scene, time_tree(each)) for each in (late, early)]
    shared = [each for each in scene.bodies(late) if _last_move(scene, each, late) == early]
    if all(times) or not shared:
        return _difference_of_times(scene, asked, late, early)
    body = shared[0]
    axis = _axis_for(scene, body, late)
    if axis is None:
        return _difference_of_times(scene, asked, late, early)
    first, last = (coordinate(scene, body, each, axis) for each in (early, late))
    pace = velocity(scene, body, early, axis)
    value = tidy((last.value - first.value) / pace.value)
    line = scene.desk.write(
        Move("define", "straight-line", late, (body,)),
        together(
            first.refs, last.refs, pace.refs, _divisor(scene, last.value - first.value, pace.value)
        ),
        chain(
            asked,
            (swept(_quotient(scene, last.value, first.value, pace.value)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(asked, value, (line,))


def _difference_of_times(scene: Scene, asked: Expression, late: int, early: int) -> Source:
    a, b = (time_of(scene, each) for each in (late, early))
    value = tidy(a.value - b.value)
    line = scene.desk.write(
        Move("combine"),
        together(a.refs, b.refs),
        chain(
            asked,
            (difference(tree_of(a.value), tree_of(b.value)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(asked, value, (line,))


def goals(scene: Scene, asked: Expression) -> list[sp.Expr]:
    """What has to be known for a time or a place.

    What a wall does to a component follows from the component before it, and is written when the
    working comes to that wall.
    """
    value = scene.value(asked)
    parts = list(value) if isinstance(value, Vector) else [value]
    return [without_walls(scene, sp.sympify(each, strict=True)) for each in parts]


def without_walls(scene: Scene, value: sp.Expr) -> sp.Expr:
    """A value with the components after walls put in by those before them."""
    changes: dict[sp.Basic, sp.Expr] = {}
    for law in scene.model.laws:
        if scene.model.frames[law.number].wall is not None:
            body = scene.bodies(law.number)[0]
            symbol = scene.model.components[law.number, body].symbol
            changes[symbol] = (symbol - law.residual).xreplace(changes)
    return value.xreplace(changes)


# --- paths --------------------------------------------------------------------------------------


def residuals(scene: Scene, own: Link) -> tuple[sp.Expr, ...]:
    """An equation between times and places, each time by one direction as lines have it."""
    story = scene.model.story

    def value(tree: Quantity) -> Any:
        match tree:
            case Quantity("time", (), int(number)):
                return _time_value(scene, number)
        return quantity_of(story, tree, scene.events)

    read = type(story.evaluator(scene.events))(
        story.field, scene.model.unknowns.letter, value, story._named, story.wall_direction
    )
    gap = [read.scalar(each) for each in (own.left, own.right)]
    return (tidy(without_walls(scene, gap[0] - gap[1])),)


def _time_value(scene: Scene, number: int) -> sp.Expr:
    """A time as lines come to it: at a point, by the direction that is the simplest."""
    own = scene.value(time_tree(number))
    if number == 0 or not isinstance(scene.model.happening(number).step, Arrival):
        return own
    body = scene.bodies(number)[0]
    axis = _axis_for(scene, body, number)
    since = _last_move(scene, body, number)
    if axis is None:
        return own
    first, last = (_value_of_coordinate(scene, body, each, axis) for each in (since, number))
    pace = _value_of_velocity(scene, body, since, axis)
    early = _time_value(scene, since) if since else sp.Integer(0)
    return early + (last - first) / pace


@dataclass(frozen=True)
class Path:
    """That a body comes to a point, as an equation of a route."""

    number: int
    body: str
    candidate: Candidate


def paths(scene: Scene) -> Iterator[Path]:
    """The equations of the paths to points, in which something unknown stands."""
    for number in range(1, scene.events + 1):
        step = scene.model.happening(number).step
        if not isinstance(step, Arrival):
            continue
        body = step.body
        since = _last_move(scene, body, number)
        if scene.model.story.place(body, since) is None:
            continue
        if any(_of_contact_tree(scene, body, number, axis) is None for axis in AXES):
            continue
        place, end = (scene.value(place_tree(body, each)) for each in (since, number))
        gap = Vector(end.x - place.x, end.y - place.y)
        residual = tidy(without_walls(scene, gap.cross(scene.velocity(body, since))))
        if scene.unknown(residual):
            yield Path(number, body, Candidate(f"path {number}", 2.0, (residual,)))


def _of_contact_tree(scene: Scene, body: str, number: int, axis: Axis) -> Expression | None:
    for own in _contact(scene, number):
        if own.left in (place_tree(body, number), coordinate_tree(body, number, axis)):
            return own.right
    return None


def write_path(scene: Scene, path: Path) -> int:
    """The line of a path, and its number: at the time at which the body comes there, else without.

    Where one direction tells the time, the other gives the equation.
    """
    body, number = path.body, path.number
    since = _last_move(scene, body, number)
    for axis, other in (AXES, AXES[::-1]):
        pace = _value_of_velocity(scene, body, since, axis)
        first = _value_of_coordinate(scene, body, since, axis)
        last = _value_of_coordinate(scene, body, number, axis)
        when = scene.model.happening(since).time if since else sp.Integer(0)
        values = [without_walls(scene, each) for each in (pace, first, last, when)]
        if pace == 0 or any(scene.unknown(each) for each in values):
            continue
        known = _known(scene, time_tree(number)) or _time_along(scene, body, number, axis)
        ends = [coordinate(scene, body, each, other) for each in (since, number)]
        speed, early = velocity(scene, body, since, other), time_of(scene, since)
        flight = difference(tree_of(known.value), tree_of(early.value))
        return scene.desk.write(
            Move("define", "straight-line", number, (body,)),
            together(*(each.refs for each in ends), speed.refs, early.refs, known.refs),
            chain(
                swept(difference(tree_of(ends[1].value), tree_of(ends[0].value))),
                (swept(product(tree_of(speed.value), flight)), None),
            ),
        )
    sides: list[Expression] = []
    refs: list[Ref] = []
    for axis in AXES:
        coordinate(scene, body, since, axis)
    paces = [velocity(scene, body, since, axis) for axis in AXES]
    for axis, pace in zip(AXES, reversed(paces), strict=True):
        ends = [coordinate(scene, body, each, axis) for each in (since, number)]
        refs += [ref for each in (*ends, pace) for ref in each.refs]
        sides.append(_swept_product(scene, ends[1].value, ends[0].value, pace.value))
    return scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        refs,
        chain(sides[0], (sides[1], None)),
    )
