"""Places and times: how long a sphere takes to a wall or a point, and where it is then."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import sympy as sp

from restitution.exact import tidy
from restitution.explain.phrases import answer, chain
from restitution.explain.steps import Row, Side, Step, side
from restitution.explaining.marks import A1, M1
from restitution.explaining.printing import look, printed
from restitution.explaining.saying import Sentence, say
from restitution.expression.tree import AtTime, Expression, Name, Quantity
from restitution.problem import Arrival, Impact
from restitution.render import layout as lay
from restitution.render.layout import Bold, Layout, Letter
from restitution.solve.conditions import Equation as StoryEquation
from restitution.solve.quantities import point_of
from restitution.solve.story import Happening
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.quantities import Derived
    from restitution.explain.working import Working


def time_letter(number: int) -> Layout:
    """T with the number of the event."""
    return Letter("t", str(number))


def travel(work: Working, number: int) -> None:
    """Writes how the time of an event is found, and what it rests on."""
    if ("travel", number) in work.done or number == 0:
        return
    work.done.add(("travel", number))
    story = work.model.story
    event = work.model.happening(number)
    if event.time is None:
        return
    for body in _moving(work, event):
        earlier = story.place(body, number - 1)
        latest = story.latest(body, number - 1)
        if earlier is not None and latest is not None and latest.time is not None:
            travel(work, latest.number)
    inside: set[sp.Symbol] = set(work.open(event.time))
    work.reach(inside)
    value = work.put(event.time)
    made = _flight(work, event, value)
    if made is None:
        return
    sentence, rows = made
    work.write("result", rows, sentences=(sentence,))


def _moving(work: Working, event: Happening) -> list[str]:
    return [b for b in event.bodies if b in work.model.story.spheres]


def _flight(work: Working, event: Happening, value: sp.Expr) -> tuple[Sentence, list[Row]] | None:
    story = work.model.story
    step = event.step
    number = event.number
    name = side(value, time_letter(number))
    if isinstance(step, Impact) and step.second in story.spheres:
        return _meeting(work, event, step, value)
    target: str | None
    if isinstance(step, Impact):
        body, target = step.first, step.second
    elif isinstance(step, Arrival):
        body = step.body
        target = step.target.name if isinstance(step.target, Name) else None
    else:
        return None
    known = story.place(body, number - 1)
    if known is None:
        return None
    where, when = work.put(known[0]), work.put(known[1])
    v = work.put(story.velocity(body, number - 1))
    if isinstance(step, Impact) and story.walls[step.second].centre is not None:
        return _to_circle(work, event, value, where, when, v)
    there = story.place(body, number)
    assert there is not None
    end = work.put(there[0])
    flight = tidy(value - when)
    way = Vector(tidy(end.x - where.x), tidy(end.y - where.y))
    shortest = _shortest(work, way, v, target, story)
    if shortest is None:
        return None
    distance, speed, axis = shortest
    sizes = {"distance": look(distance), "speed": look(speed)}
    if axis == "wall":
        sentence = say("flight.to-wall", body=body, wall=target or "", **sizes)
    elif axis is not None:
        sentence = say("flight.axis", body=body, axis=Bold(axis), **sizes)
    else:
        sentence = say("flight.straight", body=body, **sizes)
    ratio = Side(printed("d/v", d=distance, v=speed), tidy(distance / speed))
    rows: list[Row]
    if when == 0:
        rows = [chain(name, ratio, side(flight), points=(M1, A1))]
    else:
        begun = time_letter(_since(work, body, number))
        total = printed("t + d/v", t=begun, d=distance, v=speed)
        rows = [
            chain(name, side(value, total), *answer(value), points=(M1, A1)),
        ]
    return sentence, rows


def _to_circle(
    work: Working, event: Happening, value: sp.Expr, where: Vector, when: sp.Expr, v: Vector
) -> tuple[Sentence, list[Row]]:
    """The distance from the centre of a circular wall is its radius again."""
    story = work.model.story
    step = event.step
    assert isinstance(step, Impact)
    wall = story.walls[step.second]
    centre = work.put(story.read_vector(wall.centre, "the centre"))
    there = story.place(step.first, event.number)
    assert there is not None
    end = work.put(there[0])
    reach = tidy(work.resolved(sp.sqrt(tidy((end - centre).dot(end - centre)))))
    flight = tidy(value - when)
    gap = Vector(tidy(where.x - centre.x), tidy(where.y - centre.y))
    t = lay.Letter("t")
    squares = printed("(x + a*t)^2 + (y + b*t)^2", x=gap.x, a=v.x, y=gap.y, b=v.y, t=t)
    total = (gap.x + v.x * flight) ** 2 + (gap.y + v.y * flight) ** 2
    rows = [
        Row(
            (squares, printed("r^2", r=reach)),
            ("=",),
            (total, reach**2),
            (M1, A1),
        ),
        chain(side(flight, lay.Letter("t")), *answer(flight), points=(A1,)),
    ]
    name = side(value, time_letter(event.number))
    if when != 0:
        begun = time_letter(_since(work, step.first, event.number))
        made = printed("s + t", s=begun, t=lay.Letter("t"))
        rows.append(chain(name, side(value, made), *answer(value)))
    else:
        rows[-1] = chain(name, side(flight, lay.Letter("t")), *answer(flight), points=(A1,))
    sentence = say(
        "circle.again" if when != 0 else "circle.time",
        body=step.first,
        radius=look(reach),
        wall=wall.name,
        letter=lay.Letter("t"),
    )
    return sentence, rows


def _since(work: Working, body: str, number: int) -> int:
    latest = work.model.story.latest(body, number - 1)
    return latest.number if latest is not None else 0


def _shortest(
    work: Working, way: Vector, v: Vector, target: str | None, story: Any
) -> tuple[Any, Any, Literal["wall", "i", "j"] | None] | None:
    """A distance, the component of velocity along it, and whether it is along an axis.

    ``wall`` is the axis perpendicular to the wall that is the target.
    """
    if target is not None and target in story.walls and story.walls[target].centre is None:
        along = work.put(story.wall_direction(Name(target)))
        if along.x == 0 or along.y == 0:
            pick = ("x", "y")[0 if along.x == 0 else 1]
            d, s = getattr(way, pick), getattr(v, pick)
            d = tidy(work.resolved(sp.Abs(d)))
            s = tidy(work.resolved(sp.Abs(s)))
            if d == 0 or s == 0:
                return None
            return d, s, "wall"
    axes: tuple[tuple[str, Literal["i", "j"]], ...] = (("x", "i"), ("y", "j"))
    for pick, axis in axes:
        d, s = getattr(way, pick), getattr(v, pick)
        other = getattr(way, "y" if pick == "x" else "x")
        if s != 0 and d != 0 and (other == 0 or not sp.sympify(s, strict=True).has(sp.sqrt)):
            d = tidy(work.resolved(sp.Abs(d)))
            s = tidy(work.resolved(sp.Abs(s)))
            return d, s, None if other == 0 else axis
    size = tidy(work.resolved(sp.sqrt(tidy(way.dot(way)))))
    speed = tidy(work.resolved(sp.sqrt(tidy(v.dot(v)))))
    if size == 0 or speed == 0:
        return None
    return size, speed, None


def _meeting(
    work: Working, event: Happening, step: Impact, value: sp.Expr
) -> tuple[Sentence, list[Row]] | None:
    story = work.model.story
    number = event.number
    one, other = (story.place(n, number - 1) for n in (step.first, step.second))
    if one is None or other is None:
        return None
    start = _later(work, one[1], other[1])
    v1, v2 = (work.put(story.velocity(n, number - 1)) for n in (step.first, step.second))
    p1 = work.put(one[0] + story.velocity(step.first, number - 1) * (start - one[1]))
    p2 = work.put(other[0] + story.velocity(step.second, number - 1) * (start - other[1]))
    gap = Vector(tidy(p2.x - p1.x), tidy(p2.y - p1.y))
    w = Vector(tidy(v1.x - v2.x), tidy(v1.y - v2.y))
    r = story.radius(step.first)
    flight = tidy(value - work.put(start))
    t = sp.Symbol("t", positive=True)
    name = side(value, time_letter(number))
    if r is not None and not (gap.y == 0 and w.y == 0) and not (gap.x == 0 and w.x == 0):
        reach = work.put(2 * r)
        left = tidy((gap.x - w.x * t) ** 2 + (gap.y - w.y * t) ** 2)
        rows = [
            Row(
                (
                    printed(
                        "(x - a*t)^2 + (y - b*t)^2",
                        x=gap.x,
                        a=w.x,
                        y=gap.y,
                        b=w.y,
                        t=lay.Letter("t"),
                    ),
                    printed("r^2", r=reach),
                ),
                ("=",),
                (left.xreplace({t: flight}), reach**2),
                (M1, A1),
            )
        ]
        rows.append(chain(name, *answer(value), points=(A1,)))
        apart = say("touch.apart", one=step.first, other=step.second, distance=look(reach))
        return apart, rows
    pick = "x" if w.x != 0 else "y"
    d, s = getattr(gap, pick), getattr(w, pick)
    if r is not None:
        d = tidy(sp.Abs(d) - work.put(2 * r))
    d, s = (tidy(work.resolved(sp.Abs(x))) for x in (d, s))
    if s == 0 or d == 0:
        return None
    ratio = Side(printed("d/v", d=d, v=s), tidy(d / s))
    sentence = say("gap.closes", one=step.first, other=step.second, gap=look(d), speed=look(s))
    begun = work.put(start)
    if begun == 0:
        return sentence, [chain(name, ratio, *answer(value), points=(M1, A1))]
    since = max(_since(work, step.first, number), _since(work, step.second, number))
    total = printed("t + d/v", t=time_letter(since), d=d, v=s)
    return sentence, [chain(name, side(value, total), *answer(value), points=(M1, A1))]


def _later(work: Working, a: Any, b: Any) -> Any:
    return a if work.sign(a - b) >= 0 else b


def derive_place(work: Working, name: Layout, tree: Quantity, now: int) -> Derived:
    """The lines for a time, a place or a distance."""
    from restitution.explain.quantities import Derived, evaluated

    story = work.model.story
    value = evaluated(work, tree, now)
    if tree.kind == "time":
        assert isinstance(tree.stage, int)
        travel(work, tree.stage)
        if any(time_letter(tree.stage) in row.operands for s in work.steps for row in s.rows):
            return Derived((), value)
        return Derived((chain(Side(name, value), *answer(value), points=(A1,)),), value)
    bodies = [a for a in tree.arguments if isinstance(a, Name) and a.name in story.spheres]
    stage = tree.stage
    rows: list[Row] = []
    if isinstance(stage, AtTime):
        for body in bodies:
            latest = story.latest(body.name, now)
            if latest is not None:
                travel(work, latest.number)
    else:
        upto = stage if isinstance(stage, int) else now
        if upto and bodies:
            travel(work, upto)
    if tree.kind == "position":
        made = _place_layout(work, tree, now)
        sides: list[Any] = [Side(name, value)]
        if made is not None:
            sides.append(Side(made, value))
        laid = lay.display_point(*value)
        operands = laid.operands if isinstance(laid, lay.Relation) else (laid,)
        sides.append(Side(operands[0], value))
        sides += [Side(each, None) for each in operands[1:]]
        return Derived((chain(*sides, points=(M1, A1)),), value)
    one, other = tree.arguments
    for each in (one, other):
        if isinstance(each, Quantity) and each.kind == "position" and each.stage != 0:
            derived = derive_place(work, work.layout(each), each, now)
            work.write("result", derived.rows)
    points = [_point(work, each, tree, now) for each in (one, other)]
    for each, point in zip((one, other), points, strict=True):
        if isinstance(each, Name) and each.name in story.spheres:
            laid = lay.display_point(*point)
            first = laid.operands[0] if isinstance(laid, lay.Relation) else laid
            rows.append(chain(side(tuple(point), Bold("r", each.name)), Side(first, tuple(point))))
    gap = Vector(tidy(points[0].x - points[1].x), tidy(points[0].y - points[1].y))
    made_ = None
    if gap.x != 0 and gap.y != 0:
        made_ = Side(printed("sqrt(a^2 + b^2)", a=gap.x, b=gap.y), value)
    final = [Side(name, value), *([made_] if made_ else []), *answer(value)]
    rows.append(chain(*final, points=(M1, A1)))
    return Derived(tuple(rows), value)


def _point(work: Working, argument: Expression, tree: Quantity, now: int) -> Vector:
    return work.put(point_of(work.model.story, argument, tree, now))  # type: ignore[no-any-return]


def _place_layout(work: Working, tree: Quantity, now: int) -> Layout | None:
    """The place before plus velocity times time."""
    story = work.model.story
    argument = tree.arguments[0]
    assert isinstance(argument, Name)
    body = argument.name
    stage = tree.stage
    if isinstance(stage, AtTime):
        return None
    number = stage if isinstance(stage, int) else now
    if number == 0:
        return None
    known = story.place(body, number - 1)
    event = work.model.happening(number)
    if known is None or event.time is None:
        return None
    v = work.put(story.velocity(body, number - 1))
    if v == (0, 0):
        return None
    flight = tidy(work.put(event.time) - work.put(known[1]))
    start = work.put(known[0])
    return printed("r + t*v", r=tuple(start), t=flight, v=tuple(v))


def meeting_step(work: Working, equation: StoryEquation) -> Step | None:
    """A sphere passes through the point it is said to come to."""
    story = work.model.story
    for event in story.happenings:
        if not isinstance(event.step, Arrival) or (
            isinstance(event.step.target, Name) and (event.step.target.name in story.walls)
        ):
            continue
        body = event.step.body
        known = story.place(body, event.number - 1)
        if known is None:
            continue
        point = story.evaluator(event.number - 1).vector(event.step.target)
        v = story.velocity(body, event.number - 1)
        if (
            sp.simplify(
                sp.sympify((point - known[0]).cross(v), strict=True)
                - sp.sympify(equation.value, strict=True)
            )
            != 0
        ):
            continue
        closed = _triangle_of_chords(work, event, body, point)
        if closed is not None:
            return closed
        latest = story.latest(body, event.number - 1)
        if latest is not None:
            travel_known(work, latest.number)
        way = work.put(Vector(*(point - known[0])))
        v = work.put(v)
        row = chain(
            Side(printed("a*b", a=v.y, b=way.x), tidy(v.y * way.x)),
            Side(printed("a*b", a=v.x, b=way.y), tidy(v.x * way.y)),
            points=(M1, A1),
        )
        target = work.layout(event.step.target)
        start = _coordinates(work.put(known[0]))
        sentence = say("aim.velocity", body=body, start=start, target=target)
        return Step("fact", (row,), sentences=(sentence,))
    residual = work.put(equation.value)
    return Step(
        "fact",
        (chain(side(tidy(residual)), side(sp.Integer(0)), points=(M1, A1)),),
        sentences=(say("aim.unless", reason=equation.reason),),
    )


def _triangle_of_chords(work: Working, event: Happening, body: str, point: Vector) -> Step | None:
    """Two impacts with one circular wall and back to the start on it: three chords."""
    story = work.model.story
    frames = [work.model.frames.get(number) for number in range(1, event.number)]
    start = story.place(body, 0)
    if start is None or len(frames) != 2 or any(f is None or f.wall is None for f in frames):
        return None
    if not all(work.model.on_a_chord(number, body) for number in (1, 2)):
        return None
    if work.sign(start[0].x - point.x) != 0 or work.sign(start[0].y - point.y) != 0:
        return None
    tangents = []
    for number in (1, 2):
        un, ut = work.model.before(number, body)
        tangents.append(tidy(work.put(-ut / un)))
    tangents.append(tidy(work.put(ut / work.model.after(2, body))))
    a, b, c = tangents
    row = chain(
        Side(
            printed("(a + b)/(1 - p)", a=a, b=b, p=tidy(a * b)),
            (a + b) / (1 - a * b),
        ),
        Side(look(tidy(1 / c)), 1 / c),
        points=(M1, A1),
    )
    sentence = say("aim.chords", tangents=[look(a), look(b), look(c)])
    return Step("fact", (row,), sentences=(sentence,))


def _coordinates(v: Vector) -> Layout:
    return lay.Coordinates((look(v.x), look(v.y)))


def travel_known(work: Working, number: int) -> None:
    """The journey up to an event, if what it rests on is known."""
    event = work.model.happening(number)
    if event.time is not None and not work.open(event.time):
        travel(work, number)


__all__ = ["derive_place", "meeting_step", "travel", "travel_known"]
