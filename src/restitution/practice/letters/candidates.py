"""What a letter of a student's may mean: the quantities of a story, each with how usual it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

from restitution.expression.quantities import ANGLES, ENERGIES, Nature
from restitution.expression.tree import (
    GREEK,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Quantity,
    Unit,
    is_function,
    is_quantity,
    negated,
    walk,
)
from restitution.problem import (
    Event,
    Find,
    Impact,
    Kick,
    Part,
    Problem,
    Wall,
    bodies_of,
    trees_of_step,
)
from restitution.records import dataclass
from restitution.shapes import Circle

Kind = Literal[
    "component",
    "speed",
    "velocity",
    "relative",
    "angle",
    "tangent",
    "deflection",
    "impulse",
    "energy",
    "mass",
    "coefficient",
    "time",
    "distance",
    "place",
    "direction",
    "ratio",
    "definition",
]

AXES: tuple[Expression, ...] = (Unit("i"), Unit("j"))
# What the sense against i, j or the first body's way to the second costs.
_TURNED = 0.1
_RIGHT_ANGLE, _TWO_RIGHT_ANGLES = RIGHT_ANGLE, STRAIGHT_ANGLE


@dataclass(frozen=True)
class Candidate:
    """A quantity that a letter may mean.

    ``body`` and ``event`` are those it belongs to (event 0: before the first), ``axis`` is what a
    component is taken along; ``start`` tells that it belongs to the start and is known from the
    statement. ``unchanged`` tells of a component that it is the same before and after ``event``,
    ``varies`` that the value depends on letters of the statement, ``asked`` that the part asks for
    it, ``beside`` that its axis is i or j where the line of centres is neither, ``stopped`` that
    the part is to show that its body has come to rest, ``given`` that it is one of a later velocity
    which the statement gives in numbers.
    ``cost`` grows from 0 for the most usual to 1 for the least usual.
    """

    quantity: Expression
    kind: Kind
    nature: Nature
    body: str | None = None
    event: int | None = None
    axis: Expression | None = None
    start: bool = False
    cost: float = 0.0
    unchanged: bool = False
    varies: bool = False
    asked: bool = False
    beside: bool = False
    stopped: bool = False
    given: bool = False

    @property
    def sensed(self) -> bool:
        """Whether it has a sense that may be turned."""
        if self.nature == "vector" and (self.kind == "velocity" or self.asked):
            return False  # as a vector it has its sense by itself
        if self.kind == "velocity":
            return True
        if self.kind in ("component", "relative", "direction"):
            return True
        return (self.kind == "impulse" and self.axis is not None) or self.nature == "vector"

    def turned(self) -> Candidate:
        """The same quantity in the other sense."""
        return replace(self, quantity=negated(self.quantity), cost=self.cost + _TURNED)


def candidates(problem: Problem, part: Part | None = None) -> tuple[Candidate, ...]:
    """Every quantity of the events up to and with a part that a letter may mean."""
    return tuple(_all(problem, _events(problem, part)))


def _events(problem: Problem, part: Part | None) -> list[Event]:
    """The events up to the last one of which a part asks: those behind it are of later parts."""
    steps = (step for step, _, _ in problem.timeline(part))
    events = [step for step in steps if isinstance(step, Event)]
    if part is None or part == problem.parts[-1]:
        return events
    asked = max((now for _, now in problem.asked(part)), default=0)
    return events[: asked or len(events)]


def _all(problem: Problem, events: Sequence[Event]) -> Iterator[Candidate]:
    unknown = {sphere.name for sphere in problem.spheres if sphere.velocity is None}
    for sphere in problem.spheres:
        stages = [0, *(n for n, event in enumerate(events, 1) if sphere.name in bodies_of(event))]
        for place, stage in enumerate(stages):
            start = stage == 0 and sphere.name not in unknown
            following = stages[place + 1] if place + 1 < len(stages) else None
            yield from _of_motion(problem, events, sphere.name, stage, following, start)
        yield Candidate(Quantity("mass", (Name(sphere.name),)), "mass", "scalar", sphere.name)
    for number, event in enumerate(events, 1):
        yield from _of_event(problem, event, number)
    yield from _of_the_whole(problem, events)
    yield from _of_free_masses(problem)
    yield from _of_places(problem, events)


def _of_places(problem: Problem, events: Sequence[Event]) -> Iterator[Candidate]:
    """Where bodies are at the events, if the statement says where they start."""
    for sphere in problem.spheres if any(sphere.position for sphere in problem.spheres) else ():
        for number, event in enumerate(events, 1):
            if sphere.name not in bodies_of(event):
                continue
            place = Quantity("position", (Name(sphere.name),), number)
            yield Candidate(place, "place", "vector", sphere.name, number, cost=0.2)
            for unit in AXES:
                part = Quantity("along", (place, unit))
                yield Candidate(part, "place", "scalar", sphere.name, number, unit, cost=0.3)
    for place in _places_asked(problem):
        (body,) = (argument.name for argument in place.arguments if isinstance(argument, Name))
        for unit in AXES:
            part = Quantity("along", (place, unit))
            yield Candidate(part, "place", "scalar", body, len(events), unit, cost=0.3)


def _places_asked(problem: Problem) -> Iterator[Quantity]:
    """The places at a moment between or behind events for which a question asks."""
    asked = (
        node
        for _, step in problem.steps()
        if isinstance(step, Find)
        for tree in trees_of_step(step)
        for node in walk(tree)
    )
    for node in dict.fromkeys(asked):
        if is_quantity(node, "position") and not isinstance(node.stage, int | None):
            yield node


def _of_free_masses(problem: Problem) -> Iterator[Candidate]:
    """The ratios of two masses of which nothing is given: m and km."""
    free = [sphere.name for sphere in problem.spheres if sphere.mass is None]
    if len(free) == 2:
        for one, other in (free[::-1], free):
            masses = (Quantity("mass", (Name(one),)), Quantity("mass", (Name(other),)))
            yield Candidate(Binary("/", *masses), "ratio", "scalar")


def wall_of(problem: Problem, event: Event | None) -> Wall | None:
    """The wall that is struck in an event."""
    names = bodies_of(event) if event is not None else ()
    return next((wall for wall in problem.walls if wall.name in names), None)


def velocity(body: str, stage: int) -> Quantity:
    """The velocity of a body after so many events."""
    return Quantity("velocity", (Name(body),), stage)


def before_event(tree: Expression) -> Expression:
    """A component after an event as it was before it."""
    match tree:
        case Quantity("velocity", arguments, int(stage)):
            return Quantity("velocity", arguments, stage - 1)
        case Quantity(kind, arguments, own):
            return Quantity(kind, tuple(before_event(argument) for argument in arguments), own)
    return tree


def line(event: Event, number: int) -> Expression:
    """The line of centres of an impact as an axis: i or j where the statement says so."""
    along = event.along if isinstance(event, Impact) else None
    match along:
        case Unit():
            return along
        case Negate(Unit() as axis):
            return axis
    return Quantity("line_of_centres", (), number)


def components(
    problem: Problem, event: Event | None, number: int, of: Expression
) -> Iterator[tuple[Expression, Expression, float]]:
    """The components of a vector that people use at an event: with their axes and costs."""
    wall = wall_of(problem, event)
    if wall is not None and not isinstance(wall.shape, Circle):
        yield Quantity("across", (of, Name(wall.name))), Name(wall.name), 0.0
        yield Quantity("along", (of, Name(wall.name))), Name(wall.name), 0.1
    elif isinstance(event, Impact):
        axis = line(event, number)
        yield Quantity("along", (of, axis)), axis, 0.0
        if not isinstance(axis, Unit):
            yield Quantity("across", (of, axis)), axis, 0.1
    for unit in AXES:
        yield Quantity("along", (of, unit)), unit, 0.1


def _of_motion(
    problem: Problem,
    events: Sequence[Event],
    body: str,
    stage: int,
    following: int | None,
    start: bool,
) -> Iterator[Candidate]:
    """What a body's motion after one event and before the next has."""
    v, far = velocity(body, stage), 0.3 if stage == 0 else 0.0
    seen: set[Expression] = set()
    for number in (stage, following):
        event = events[number - 1] if number else None
        if number is None or (event is None and following is not None):
            continue
        late = far if number == stage else far + 0.05
        for quantity, axis, cost in components(problem, event, number, v):
            if quantity not in seen:
                seen.add(quantity)
                beside = cost > 0 and wall_of(problem, event) is None
                yield Candidate(
                    quantity,
                    "component",
                    "scalar",
                    body,
                    stage,
                    axis,
                    start,
                    cost + late,
                    beside=beside,
                )
        for quantity, cost in _angles(problem, event, number, v):
            if quantity not in seen:
                seen.add(quantity)
                yield Candidate(quantity, "angle", "angle", body, stage, None, start, cost + late)
                tangent = Apply("tan", quantity)
                yield Candidate(
                    tangent, "tangent", "scalar", body, stage, None, start, cost + late + 0.2
                )
    if stage > 1:
        whole = Quantity("angle", (v, velocity(body, 0)))
        yield Candidate(whole, "deflection", "angle", body, stage, None, False, 0.3)
    name = Name(body)
    direction = Quantity("direction", (name,), stage)
    yield Candidate(direction, "angle", "angle", body, stage, None, start, far + 0.4)
    speed, energy = Quantity("speed", (name,), stage), Quantity("energy", (name,), stage)
    yield Candidate(speed, "speed", "scalar", body, stage, None, start, far + 0.1)
    yield Candidate(v, "velocity", "vector", body, stage, None, start, far)
    yield Candidate(energy, "energy", "scalar", body, stage, None, False, far + 0.1)


def _angles(
    problem: Problem, event: Event | None, number: int, v: Expression
) -> Iterator[tuple[Expression, float]]:
    """The angles of a velocity at an event, with their costs."""
    wall = wall_of(problem, event)
    lines: list[tuple[Expression, float]] = []
    if wall is not None:
        lines = [(Name(wall.name), 0.0)]
    elif isinstance(event, Impact):
        lines = [(Quantity("line_of_centres", (), number), 0.0)]
    for axis, cost in lines:
        angle = Quantity("angle", (v, axis))
        yield angle, cost
        yield Binary("-", _RIGHT_ANGLE, angle), cost + 0.15
        yield Binary("-", _TWO_RIGHT_ANGLES, angle), cost + 0.4
    for unit in AXES:
        angle = Quantity("angle", (v, unit))
        yield angle, 0.2
        yield Quantity("angle", (v, Negate(unit))), 0.3


def _of_event(problem: Problem, event: Event, number: int) -> Iterator[Candidate]:
    """What belongs to one event."""
    spheres = [s.name for s in problem.spheres if s.name in bodies_of(event)]
    if isinstance(event, Impact | Kick):
        yield Candidate(
            Quantity("impulse", (), number), "impulse", "scalar", None, number, None, cost=0.0
        )
        for body in spheres:
            yield from _of_impulse(problem, event, number, body)
            before, after = (
                Quantity("energy", (Name(body),), stage) for stage in (number - 1, number)
            )
            loss = Binary("-", before, after)
            yield Candidate(loss, "energy", "scalar", body, number, cost=0.3)
            yield Candidate(negated(loss), "energy", "scalar", body, number, cost=0.4)
            yield Candidate(
                Quantity("deflection", (Name(body),), number),
                "deflection",
                "angle",
                body,
                number,
                cost=0.1,
            )
        yield Candidate(Quantity("energy_lost", (), number), "energy", "scalar", None, number)
    if isinstance(event, Impact):
        yield from _of_impact(problem, event, number, spheres)


def _of_impulse(problem: Problem, event: Event, number: int, body: str) -> Iterator[Candidate]:
    on = Quantity("impulse", (Name(body),), number)
    yield Candidate(on, "impulse", "vector", body, number, cost=0.1)
    for quantity, axis, cost in components(problem, event, number, on):
        yield Candidate(quantity, "impulse", "scalar", body, number, axis, cost=cost + 0.1)


def _of_impact(
    problem: Problem, event: Impact, number: int, spheres: Sequence[str]
) -> Iterator[Candidate]:
    yield Candidate(Quantity("restitution", (), number), "coefficient", "scalar", None, number)
    centres = Quantity("line_of_centres", (), number)
    yield Candidate(centres, "direction", "vector", None, number)
    for unit in AXES:
        angle = Quantity("angle", (centres, unit))
        usual = 0.0 if event.offset is not None and unit == Unit("i") else 0.3
        yield Candidate(angle, "angle", "angle", None, number, cost=usual)
        tangent = Apply("tan", angle)
        yield Candidate(tangent, "tangent", "scalar", None, number, cost=0.4)
    if len(spheres) == 2:
        moving = {sphere.name for sphere in problem.spheres if sphere.velocity is not None}
        for stage, start in ((number, False), (number - 1, number == 1)):
            first, second = (velocity(body, stage) for body in spheres)
            between = Quantity("angle", (first, second))
            yield Candidate(between, "angle", "angle", None, stage, None, start, 0.3)
            difference = Binary("-", first, second)
            given = start and moving.issuperset(spheres)
            yield Candidate(difference, "relative", "vector", None, stage, None, given, 0.3)
            yield Candidate(
                Quantity("along", (difference, line(event, number))),
                "relative",
                "scalar",
                None,
                stage,
                None,
                given,
                0.4,
            )
    for body in spheres:
        ratio = Binary(
            "/", *(Quantity("speed", (Name(body),), stage) for stage in (number, number - 1))
        )
        yield Candidate(ratio, "ratio", "scalar", body, number, cost=0.5)


def _of_the_whole(problem: Problem, events: Sequence[Event]) -> Iterator[Candidate]:
    """What belongs to all bodies, or to no one event."""
    last = len(events)
    for stage in range(last + 1):
        total = Quantity("energy", (), stage)
        yield Candidate(total, "energy", "scalar", None, stage, cost=0.2)
    if last > 1:
        whole = Quantity("total_energy_lost", (), last)
        yield Candidate(whole, "energy", "scalar", None, last, cost=0.1)
    for number in range(1, last + 1):
        then = Quantity("time", (), number)
        yield Candidate(then, "time", "scalar", None, number)
        for earlier in range(1, number):
            between = Binary("-", then, Quantity("time", (), earlier))
            yield Candidate(between, "time", "scalar", None, number, cost=0.1)


# --- what a letter may be by its look -------------------------------------------------------------

_VELOCITIES: tuple[Kind, ...] = ("component", "speed", "velocity", "relative")
TURNS: tuple[Kind, ...] = ("angle", "deflection")
_BY_LETTER: dict[str, tuple[Kind, ...]] = {
    **dict.fromkeys("IJQ", ("impulse",)),
    **dict.fromkeys("RFSP", ("impulse", *_VELOCITIES)),
    **dict.fromkeys(("KE", "ke", "Ek", "E", "K", "L", "KE_lost", "loss"), ("energy",)),
    **dict.fromkeys(("m", "M"), ("mass", "tangent")),
    "e": ("coefficient",),
    **dict.fromkeys(("f", "epsilon"), ("coefficient", *_VELOCITIES)),
    "t": ("time", "tangent", *_VELOCITIES),
    "T": ("time", "tangent", "energy", *_VELOCITIES),
    "k": ("ratio", "coefficient", "tangent", *_VELOCITIES),
    "r": ("ratio", "coefficient", "tangent", *_VELOCITIES, "place"),
    **dict.fromkeys("xyp", (*_VELOCITIES, "place")),
    **dict.fromkeys("n", ("direction", "ratio", *_VELOCITIES)),
    **dict.fromkeys("dsD", ("distance", "time", "deflection", *_VELOCITIES, "place")),
    **dict.fromkeys(("lambda", "mu"), ("impulse", "ratio", "tangent", *TURNS)),
}


def kinds_of(letter: str, in_angle: bool) -> tuple[Kind, ...]:
    """The kinds of quantity that a letter may mean by its look and by where it stands.

    ``in_angle`` tells that it stands inside a trigonometric function.
    """
    if in_angle:
        return TURNS
    base, _, below = letter.rstrip("'").partition("_")
    if base in ("m", "M") and below:
        return ("mass",)
    if base in ("t", "T") and below.isdigit():
        return ("time", *_VELOCITIES)
    if base in _BY_LETTER:
        return _BY_LETTER[base]
    return TURNS if base in GREEK else _VELOCITIES


def is_odd(letter: str, quantity: Expression) -> bool:
    """Whether nobody would take a letter for a quantity by its look: T for a tangent."""
    kinds = {_KINDS.get(node.kind) for node in walk(quantity) if isinstance(node, Quantity)}
    tangent = is_function(quantity, "tan")
    known = "tangent" if tangent else next((kind for kind in _ORDER if kind in kinds), None)
    usual = kinds_of(letter, False)
    if known == "angle":
        return usual[0] not in TURNS and letter[:1] not in "abxy"
    return known is not None and known != usual[0]


_KINDS: dict[str, Kind] = {
    **dict.fromkeys(("along", "across", "speed", "velocity"), "component"),
    **dict.fromkeys(ANGLES, "angle"),
    **dict.fromkeys(ENERGIES, "energy"),
    "impulse": "impulse",
    "time": "time",
    "position": "place",
    "mass": "mass",
    "restitution": "coefficient",
}
# Of a tree the first of these that is in it tells what it is.
_ORDER: tuple[Kind, ...] = (
    *("place", "energy", "impulse", "angle", "time", "component", "mass", "coefficient"),
)


def earlier(letter: str) -> bool:
    """Whether a letter is usual for a quantity before an impact: u, u_A, U_1."""
    return letter[:1] in ("u", "U")


def suffix(letter: str) -> str:
    """What stands below a letter: ``A`` of v_A."""
    return letter.rstrip("'").partition("_")[2]
