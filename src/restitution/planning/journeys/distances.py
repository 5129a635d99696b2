"""How far two things are apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, numbers_in
from restitution.expression.tree import Apply, AtTime, Expression, Name, Pair, Quantity, Unit
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.separations import separation_known
from restitution.planning.formulas.whereabouts import (
    are_apart,
    last_move,
    rests,
    standing,
    tidied,
    velocity,
)
from restitution.planning.journeys.flown import flown
from restitution.planning.journeys.instants import piece, place_then, time_since
from restitution.planning.journeys.places import (
    coordinate,
    flight_time,
    leg,
    place,
    spot,
    time_of,
    worked_out,
)
from restitution.planning.writing.angle_ratios import range_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.place_trees import (
    AXES,
    Axis,
    coordinate_tree,
    duration_tree,
    place_tree,
    time_tree,
)
from restitution.planning.writing.polynomials import expanded, factored
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def distance(scene: Scene, asked: Quantity) -> Source:
    """A distance by the coordinates of both ends, or by the velocities since they were together."""
    known = standing(scene, asked)
    if known is not None:
        return known
    if isinstance(asked.stage, AtTime):
        together_ = _distance_since_contact(scene, asked)
        if together_ is not None:
            return together_
    else:
        for by_contact in (_at_their_contact, _distance_at_an_event):
            if (together_ := by_contact(scene, asked)) is not None:
                return together_
    length = _as_a_path(scene, asked)
    if length is not None:
        return length
    flight = flown(scene, asked)
    if flight is not None:
        nowhere = [sp.Integer(0), sp.Integer(0)]
        refs = together(*(source.refs for source in flight))
        return _write_distance(
            scene, asked, None, refs, [source.value for source in flight], nowhere
        )
    ends = [_end(scene, argument, asked.stage) for argument in asked.arguments]
    refs = together(*(end.refs for end in ends))
    (a, b) = (end.value for end in ends)
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
        gaps.append((difference(tree_of(x), tree_of(y)), tidy(x - y)))
    if not gaps:
        raise NotPlannedError("a distance that is nothing")
    if len(gaps) == 1:
        ((tree, gap),) = gaps
        value = gap if scene.model.sign(gap) >= 0 else -gap
    else:
        tree = Apply("sqrt", total(square(tree) for tree, _ in gaps))
        value = sp.sqrt(tidy(expanded(sum(gap**2 for _, gap in gaps))))
    kept = _square_kept([gap for _, gap in gaps]) if times is None else None
    if times is not None:
        tree = product(times[0], tree)
        value = value * times[1]
    value = sized(scene, tidy(value))
    move = Move("define", "distance", event)
    again = times is not None and _at_another_time(scene, asked, event)
    final = tree_of(value) if kept is None else kept
    relation = chain(asked, (swept(tree), None), (final, "rearrange"))
    if again:
        relation = chain(asked, (final, None))
    signs = together(*(_signs(scene, gap) for _, gap in gaps))
    premises = scene.judge.enough(move, refs, relation, signs)
    used = together(refs, signs) if premises is None else premises
    number = scene.desk.write(move, used, relation, "silent" if again else "line")
    return scene.desk.know(asked, value, (number,))


def _square_kept(gaps: Sequence[sp.Expr]) -> Expression | None:
    """The root of two squares, one of a sum of letters of its own, which is not multiplied out.

    Such a square shows at once what is least. None of other squares.
    """
    sums = [gap for gap in gaps if any(x.is_Add for x in sp.Mul.make_args(factored(gap)))]
    others = set[sp.Basic]().union(*(gap.free_symbols for gap in gaps if gap not in sums))
    if len(gaps) == 1 or len(sums) != 1 or not sums[0].free_symbols - others:
        return None
    trees = (tree_of(expanded(gap), as_it_is=True) if gap in sums else tree_of(gap) for gap in gaps)
    return Apply("sqrt", total(map(square, trees)))


def _at_another_time(scene: Scene, asked: Quantity, event: int | None) -> bool:
    """Whether a distance since a contact stands for another time: that of this time is seen."""
    stands = (
        scene.desk.relation(line.number).only[0].left
        for line in scene.desk.lines
        if line.move == Move("define", "distance", event) and scene.desk.holds(line.number)
    )
    return any(
        isinstance(own, Quantity)
        and isinstance(own.stage, AtTime)
        and own.arguments == asked.arguments
        for own in stands
    )


def sized(scene: Scene, value: sp.Expr) -> sp.Expr:
    """A value in which sizes are taken with the sign that they have."""
    return tidy(
        value.replace(sp.Abs, lambda inside: inside if scene.model.sign(inside) >= 0 else -inside)
    )


def _signs(scene: Scene, gap: sp.Expr) -> tuple[Ref, ...]:
    """What tells the signs of the letters of a distance: ranges, and times that are positive."""
    refs = [*ranges(scene, gap), *_orders(scene, gap)]
    factors = sp.Mul.make_args(factored(gap))
    for letter in gap.free_symbols.intersection(factors):
        role = scene.model.unknowns.roles.get(letter.name)
        if role is None or role.kind != "real":
            continue
        for number in range(1, scene.events + 1):
            trees: tuple[Expression, ...] = (
                time_tree(number),
                *(duration_tree(number, n) for n in range(1, number)),
            )
            known = (scene.desk.known(tree) for tree in trees)
            time = next((source for source in known if source is not None), None)
            if time is not None and not time.value.is_Add and time.value.has(letter):
                refs += time.refs
                break
    return tuple(refs)


def _orders(scene: Scene, gap: sp.Expr) -> Iterator[Ref]:
    """The facts that tell of a difference in a value which of the two is the greater."""
    factors = [factor for factor in sp.Mul.make_args(factored(gap)) if factor.is_Add]
    for fact in scene.desk.facts:
        if fact.kind != "range" or not scene.desk.holds(fact.id) or len(fact.relation.options) > 1:
            continue
        for own in fact.relation.only:
            difference_ = expanded(scene.scalar(own.left) - scene.scalar(own.right))
            if any(expanded(factor**2 - difference_**2) == 0 for factor in factors):
                yield fact.id


def ranges(scene: Scene, value: sp.Expr) -> tuple[Ref, ...]:
    """What may be known of the letters of a value that are not plainly positive."""
    refs: list[Ref] = []
    for letter in sorted(value.free_symbols, key=lambda symbol: symbol.name):
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
            value = tidied(scene, scene.value(tree))
            return Source(value, (f"point {name}",))
        case Pair():
            return Source(tidied(scene, scene.value(tree)), ())
        case Name(name):
            return _end(scene, Quantity("position", (tree,), stage), stage)
        case Quantity("position", (Name(body),), int(number)):
            if tree in scene.asked_alone:
                return place(scene, body, number)
            if any(_is_worked_out(scene, body, number, axis) for axis in AXES):
                x, y = (worked_out(scene, body, number, axis) for axis in AXES)
                return Source(Vector(x.value, y.value), together(x.refs, y.refs))
            return spot(scene, body, number)
        case Quantity("position", (body,), AtTime(Quantity("time", (), int(number)))):
            return _end(scene, Quantity("position", (body,), number), number)
        case Quantity("position", (Name(body),), AtTime()):
            return place_then(scene, tree, body)
    raise NotPlannedError("the end of a distance")


def _as_a_path(scene: Scene, asked: Quantity) -> Source | None:
    """How far two meet from where one of them was at its last event: that is what it goes.

    None where it does not move along an axis, or where no line follows from that.
    """
    for ends in (asked.arguments, asked.arguments[::-1]):
        match ends:
            case (
                Quantity("position", (Name(body),), int(early)),
                Quantity("position", (Name(other),), int(late)),
            ) if 0 < early < late:
                met = {body, other} == set(scene.bodies(late)) == set(scene.spheres(late))
                if not met or are_apart(scene, late) or last_move(scene, body, late) != early:
                    return None
                mark = scene.desk.mark()
                length = _write_path(scene, asked, (body, other), (early, late))
                if length is None:
                    scene.desk.back(mark)
                return length
    return None


def _write_path(
    scene: Scene, asked: Quantity, bodies: tuple[str, str], events: tuple[int, int]
) -> Source | None:
    """The line of a distance by the speed of the first body and the time between two events."""
    (body, other), (early, late) = bodies, events
    pace = {axis: velocity(scene, body, early, axis) for axis in AXES}
    moving = [axis for axis in AXES if pace[axis].value != 0]
    begin, time = leg(scene, late)
    if len(moving) != 1 or begin != early:
        return None
    own = pace[moving[0]]
    speed = own.value if scene.model.sign(own.value) > 0 else -own.value
    tree = swept(product(tree_of(tidy(speed)), tree_of(time.value)))
    value = sized(scene, tidy(speed * time.value))
    relation = chain(asked, (tree, None), (tree_of(value), "rearrange"))
    ends = ((body, early), (body, late), (other, late))
    beside = [coordinate(scene, *end, axis) for end in ends for axis in AXES if axis not in moving]
    move = Move("define", "straight-line", late, (body,))
    open_ = [e.number for e in scene.desk.lines if e.move == move and scene.desk.holds(e.number)]
    refs = together(
        own.refs,
        time.refs,
        open_,
        (f"contact {late}",),
        spot(scene, body, early).refs,
        *(source.refs for source in beside),
        ranges(scene, value),
    )
    move = Move("define", "distance")
    # A line that says the place is cited rather than the wall.
    premises = scene.judge.needed(move, (*refs, f"contact {early}"), relation)
    if premises is None:
        return None
    number = scene.desk.write(move, premises, relation)
    return scene.desk.know(asked, value, (number,))


def _is_worked_out(scene: Scene, body: str, number: int, axis: Axis) -> bool:
    """Whether a coordinate stands in a letter that has a value by now."""
    known = scene.desk.known(coordinate_tree(body, number, axis))
    return known is not None and scene.put(known.value)[0] != known.value


def _distance_since_contact(scene: Scene, asked: Quantity) -> Source | None:
    """How far apart two bodies are that met last, by their relative velocity and the time since.

    None where they met others in between.
    """
    assert isinstance(asked.stage, AtTime)
    names = [argument.name for argument in asked.arguments if isinstance(argument, Name)]
    pieces = {
        piece(scene, name, asked.stage.time) for name in names if name in scene.model.story.spheres
    }
    if len(names) != 2 or len(pieces) != 1:
        return None
    (met,) = pieces
    if not _are_together(scene, met, names):
        return None
    early = time_of(scene, met)
    return _since_contact(scene, asked, met, time_since(scene, asked.stage.time, met, early))


def _at_their_contact(scene: Scene, asked: Quantity) -> Source | None:
    """That two particles are at one point where they collide; None of any other distance."""
    names = [argument.name for argument in asked.arguments if isinstance(argument, Name)]
    stage = asked.stage
    if not isinstance(stage, int) or len(names) != 2 or not _are_together(scene, stage, names):
        return None
    relation = chain(asked, (ZERO, None))
    number = scene.judge.write((Move("define", "distance"),), (f"contact {stage}",), relation)
    return None if number is None else scene.desk.know(asked, sp.Integer(0), (number,))


def _distance_at_an_event(scene: Scene, asked: Quantity) -> Source | None:
    """How far apart two bodies are that met last, at an event of one of them.

    None where they met others in between, and where a place of one is asked, or is a line already.
    """
    names = [argument.name for argument in asked.arguments if isinstance(argument, Name)]
    stage = asked.stage
    if not isinstance(stage, int) or len(names) != 2:
        return None
    if not set(names) <= set(scene.model.story.spheres):
        return None
    events = {last_move(scene, name, stage) for name in names}
    met = min(events)
    if len(events) != 1 or not _are_together(scene, met, names):
        return None
    if any(rests(scene, name, stage) for name in names):
        return None  # it stays where they met
    trees = [(place_tree(name, stage), *_coordinates(name, stage)) for name in names]
    if any(standing(scene, tree) or tree in scene.asked_alone for own in trees for tree in own):
        return None
    mark = scene.desk.mark()
    own = _since_contact(scene, asked, met, flight_time(scene, met, stage))
    lines = map(scene.desk.line, numbers_in(own.refs))
    if all(scene.judge.follows(e.move, e.premises, scene.desk.relation(e.number)) for e in lines):
        return own
    scene.desk.back(mark)
    return None


def _coordinates(body: str, stage: int) -> tuple[Expression, ...]:
    return tuple(coordinate_tree(body, stage, axis) for axis in AXES)


def _are_together(scene: Scene, met: int, names: Sequence[str]) -> bool:
    """Whether an event is an impact of two bodies that are particles."""
    if not met or set(scene.bodies(met)) != set(names) or met not in scene.model.frames:
        return False
    return not are_apart(scene, met)


def _since_contact(
    scene: Scene,
    asked: Quantity,
    met: int,
    flight: tuple[Expression, sp.Expr, tuple[Ref, ...]],
) -> Source:
    """The line of a distance by the relative velocity after an impact, and the time since."""
    frame, (tree, length, more) = scene.frame(met), flight
    names = list(scene.bodies(met))
    apart = separation_known(scene, frame)
    across = [in_direction(scene, "across", name, met, frame) for name in names]
    if apart is None:
        along = [in_direction(scene, "along", name, met, frame) for name in names]
    else:
        along = [Source(sp.Integer(0)), apart]
    a, b = ([x, y] for x, y in zip(along, across, strict=True))
    named = [frame.component(axis, names[0], met).arguments[-1] for axis in ("across", "along")]
    used = together(
        more,
        (f"contact {met}",),
        () if all(isinstance(tree, Unit) for tree in named) else frame.refs,
        *(source.whole for source in (*a, *b)),
    )
    values = [[source.value for source in own] for own in (a, b)]
    return _write_distance(scene, asked, met, used, values[0], values[1], (tree, length))
