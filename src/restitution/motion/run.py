"""The motion of a few spheres: from impact to impact, each by the one law.

**The rules.**

- *Simultaneous impacts* are taken one pair at a time, until no bodies that touch approach each
  other. Of several that are due, the one goes first whose first body stands first on the table;
  then the one whose second body does, spheres before walls. Impacts of separate pairs do not
  depend on the order; where one sphere strikes several at once, the law says nothing, and this
  order decides.
- *Grazing*: a sphere that only touches in passing has no impact.
- *Corners* that point inwards are two walls struck at once, those that stand out, and ends of
  walls, are points: the line of centres leads from the centre to the point. What two walls share
  is struck once.
- *e = 0*: after the impact the bodies stay in contact, without further impacts, until another
  body changes the velocity of one of them.
- *Rounding*: an approach that is no more than rounding of the speeds from which it was made is no
  impact; it is taken away in silence, and so is such a speed of a single sphere.
- *Collapse*: infinitely many impacts in a finite time cannot be told one by one. When bodies that
  were apart by less than rounding go on striking each other, the run is given up with a
  `CollapseError`, which carries the motion so far.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from heapq import heapify, heappop, heappush
from math import hypot
from operator import index
from typing import TYPE_CHECKING, Any, NamedTuple

from restitution import law
from restitution.counting import counted
from restitution.errors import CollapseError, ImpossibleError, StatementError
from restitution.motion import pieces
from restitution.motion.arithmetic import Arithmetic, ExactNumbers, given
from restitution.motion.contact import TOLERANCE, Contact, Face, leaving, meeting
from restitution.motion.pieces import Motion, Piece, Struck, Track
from restitution.motion.table import Post, Ring, Table, is_inside
from restitution.records import dataclass
from restitution.vector import Vector

if TYPE_CHECKING:
    import numpy as np

# Impacts in a row of one sphere with bodies that it was touching already. A cascade among bodies
# that touch, or in a narrow corner, may need many; without loss there are always finitely many.
MOST_IN_A_ROW = 4096
# With e < 1 so many are a collapse; fewer, where the bodies have all but come to rest together.
MOST_WITH_LOSS = 256
SURE_AT_REST = 8


def simulate(table: Table, *, until: Any = None, impacts: int | None = None) -> Run:
    """The motion on a table from time 0, to a time (s), for a number of impacts, or both.

    It ends with whichever comes first; where only ``impacts`` are asked for and no more can
    happen, with the last that does.

    Raises:
        StatementError: neither is given, or not a time or a number of impacts; or no table.
        CollapseError: infinitely many impacts in a finite time; its ``run`` is the motion so far.
        UnsupportedError: exact numbers with too many square roots.
    """
    if not isinstance(table, Table):
        raise StatementError(f"what is simulated is a Table, not {table!r}")
    return _Course(table, *_checked(table, until, impacts)).run()


def _checked(table: Table, until: Any, impacts: int | None) -> tuple[Any, int | None]:
    if until is None and impacts is None:
        raise StatementError("a motion has an end: say until=… (s), or impacts=… (how many)")
    try:
        negative = impacts is not None and index(impacts) < 0
    except TypeError:
        negative = True
    if negative:
        raise StatementError(f"the number of impacts is a whole number from 0, not {impacts!r}")
    if until is None:
        return None, impacts
    kind = table.layout.kind
    end = kind.number(until, "the time of the end")
    if end < 0:
        raise StatementError(
            f"the time of the end is {table.layout.shown(end)}: the motion starts at 0"
        )
    return kind.later(kind.start, end), impacts


# --- the loop ----------------------------------------------------------------------------------


class _Due(NamedTuple):
    """An impact ahead. It is void once either body has changed its velocity since."""

    moment: Any
    first: int
    second: int  # spheres count from 0, obstacles after them
    changes: tuple[int, int]
    apart: Any  # how far apart the bodies are until then
    leeway: Any  # s; impacts nearer in time than this are simultaneous


class _Course:
    """The state of a motion under way, and its history.

    A sphere has the moment, place and velocity of its latest change of velocity, from which any
    later place is derived: nothing is accumulated. Only the spheres just struck are looked at
    anew.
    """

    def __init__(self, table: Table, until: Any, impacts: int | None) -> None:
        self.table, self.until, self.impacts = table, until, impacts
        layout = table.layout
        kind = layout.kind
        self.kind: Arithmetic = kind.copy() if isinstance(kind, ExactNumbers) else kind
        self.balls, self.obstacles = layout.balls, layout.obstacles
        self.inverse_masses = [1 / ball.mass for ball in self.balls]
        self.inside = {
            (i, k)
            for i, ball in enumerate(self.balls)
            for k, (_, shape) in enumerate(self.obstacles, start=len(self.balls))
            if isinstance(shape, Ring) and is_inside(ball, shape, kind)
        }
        self.sides: dict[tuple[int, int], int] = {}
        self.now = self.kind.start
        self.changes = [0] * len(self.balls)
        self.stretches = [
            [_Stretch(self.now, ball.place, self.kind.settled(ball.velocity, 0.0))]
            for ball in self.balls
        ]
        # The speeds that a velocity was made from: it is exact to TOLERANCE times these.
        self.speeds = [_size(ball.velocity) for ball in self.balls]
        self.in_a_row = [0] * len(self.balls)
        # Pairs in contact whose approach is rounding; until one of them has a true impact.
        self.at_rest: set[tuple[int, int]] = set()
        self.struck: list[Struck] = []
        self.due: list[_Due] = []
        for i in range(len(self.balls)):
            self.look(i, range(i + 1, self.bodies))

    @property
    def bodies(self) -> int:
        return len(self.balls) + len(self.obstacles)

    def run(self) -> Run:
        while self.impacts is None or len(self.struck) < self.impacts:
            due = self.next()
            if due is None or (self.until is not None and due.moment > self.until):
                return self.so_far(self.now if self.until is None else self.until)
            self.strike(due)
        return self.so_far(self.now)

    def so_far(self, end: Any) -> Run:
        stretches = tuple(tuple(stretch) for stretch in self.stretches)
        return Run(self.table, end, tuple(self.struck), stretches, self.kind)

    def name(self, body: int) -> str:
        if body < len(self.balls):
            return self.balls[body].name
        return self.obstacles[body - len(self.balls)].name

    def place(self, ball: int) -> Vector:
        """Where a sphere is now."""
        start, place, velocity = self.stretches[ball][-1]
        moved: Vector = velocity * self.kind.since(self.now, start)
        return place + moved

    def velocity(self, ball: int) -> Vector:
        return self.stretches[ball][-1].velocity

    # -- what is ahead ------------------------------------------------------------------------

    def look(self, ball: int, others: Any) -> None:
        """Foresee the impacts of a sphere with others, from now."""
        place, velocity = self.place(ball), self.velocity(ball)
        for other in others:
            first, second = sorted((ball, other))
            if (first, second) in self.at_rest:
                continue
            ahead = (
                self.with_sphere(ball, other, place, velocity)
                if other < len(self.balls)
                else self.with_obstacle(ball, other, place, velocity)
            )
            if ahead is None:
                continue
            contact, rounding, speed = ahead
            if contact.after - contact.after != 0:
                continue  # infinite: later than any float
            moment = self.kind.later(self.now, contact.after)
            leeway = rounding / speed if rounding else 0
            changes = self.changes_of(first, second)
            heappush(self.due, _Due(moment, first, second, changes, contact.apart, leeway))

    def with_sphere(
        self, ball: int, other: int, place: Vector, velocity: Vector
    ) -> tuple[Contact, Any, Any] | None:
        relative = self.velocity(other) - velocity
        there = self.place(other)
        reach = self.balls[ball].radius + self.balls[other].radius
        rounding = self.kind.rounding((*place, *there, reach))
        contact = meeting(there - place, relative, reach, self.kind.root_to_compare, rounding)
        return contact and (contact, rounding, _size(velocity) + _size(self.velocity(other)))

    def with_obstacle(
        self, ball: int, other: int, place: Vector, velocity: Vector
    ) -> tuple[Contact, Any, Any] | None:
        shape = self.obstacles[other - len(self.balls)].shape
        radius = self.balls[ball].radius
        root = self.kind.root_to_compare
        if isinstance(shape, Face):
            rounding = self.kind.rounding((*place, *shape.start, *shape.along, radius))
            side = self.side(ball, other, shape, place, rounding)
            contact = shape.reached(place, velocity, side, radius, rounding)
        elif isinstance(shape, Post):
            rounding = self.kind.rounding((*place, *shape.place, radius))
            contact = meeting(shape.place - place, -velocity, radius, root, rounding)
        else:
            rounding = self.kind.rounding((*place, *shape.centre, shape.radius))
            apart = shape.centre - place
            if (ball, other) in self.inside:
                contact = leaving(-apart, velocity, shape.radius - radius, root)
            else:
                contact = meeting(apart, -velocity, shape.radius + radius, root, rounding)
        return contact and (contact, rounding, _size(velocity))

    def side(self, ball: int, other: int, face: Face, place: Vector, rounding: Any) -> int:
        """On which side of a wall a sphere is: 1 left, −1 right.

        One of no size is on the wall when it has struck it; then it is where it was before.
        """
        height = face.height(place)
        known = self.sides.get((ball, other))
        if known is None or abs(height) > rounding:
            if abs(height) <= rounding:  # it starts on the wall, and belongs to where it goes
                height = face.along.cross(self.velocity(ball))
            known = self.sides[ball, other] = 1 if height >= 0 else -1
        return known

    def changes_of(self, first: int, second: int) -> tuple[int, int]:
        return self.changes[first], self.changes[second] if second < len(self.balls) else 0

    def next(self) -> _Due | None:
        """The impact that is next by the rule for simultaneous ones."""
        earliest = self.popped()
        if earliest is None:
            return None
        if not earliest.leeway:
            return earliest  # the order of the queue is that of the rule
        chosen, others = earliest, []
        while (simultaneous := self.popped()) is not None:
            later = self.kind.since(simultaneous.moment, earliest.moment)
            if later > min(simultaneous.leeway, earliest.leeway):
                others.append(simultaneous)
                break
            if (simultaneous.first, simultaneous.second) < (chosen.first, chosen.second):
                chosen, simultaneous = simultaneous, chosen
            others.append(simultaneous)
        for other in others:
            heappush(self.due, other)
        return chosen._replace(moment=max(earliest.moment, self.now))

    def popped(self) -> _Due | None:
        while self.due:
            due = heappop(self.due)
            if due.changes == self.changes_of(due.first, due.second):
                return due
        return None

    def forget(self) -> None:
        """Throw away what is void, when there is much of it."""
        if len(self.due) > 1000 + 64 * self.bodies:
            self.due = [
                prediction
                for prediction in self.due
                if prediction.changes == self.changes_of(*prediction[1:3])
            ]
            heapify(self.due)

    # -- an impact ----------------------------------------------------------------------------

    def strike(self, due: _Due) -> None:
        """The impact that is due: by the law, and from there on."""
        self.now = self.kind.reached(due.moment)
        first, second = due.first, due.second
        place, u1, w1 = self.place(first), self.velocity(first), self.inverse_masses[first]
        if second < len(self.balls):
            struck: tuple[int, ...] = (first, second)
            u2, w2 = self.velocity(second), self.inverse_masses[second]
            c = self.place(second) - place
        else:
            struck = (first,)
            u2, w2 = Vector(w1 * 0, w1 * 0), w1 * 0
            c = self.into_wall(first, second, place)
        unit = c / self.kind.root(c.dot(c))
        approach = (u1 - u2).dot(unit)
        e = self.table.layout.e(self.name(first), self.name(second))
        touching = float(due.apart) <= TOLERANCE * (_size(place) + _size(c))
        speed = sum(self.speeds[ball] for ball in struck)
        faint = float(approach) <= TOLERANCE * speed
        if touching:
            # a chord of a circle that rounding cannot tell from its tangent
            shallow = float(approach) ** 2 <= 8 * TOLERANCE * speed**2
            slides = shallow and (e < 1 or not self.kind.exact or approach == 0)
            self.refuse_collapse(due, e, faint=faint, slides=slides)
        if approach <= 0:
            return
        faint = faint and not self.kind.exact
        if faint:  # take away what rounding left of it
            e = 0
            self.at_rest.add((first, second))
        elif self.at_rest:
            self.at_rest = {pair for pair in self.at_rest if not {*pair} & {*struck}}
        on_second = law.impulse(u1, u2, w1, w2, c, e)
        v1, v2 = law.after_impulse(u1, u2, w1, w2, on_second)
        if not faint:
            time, names = self.kind.time(self.now), (self.name(first), self.name(second))
            contact = place + unit * self.balls[first].radius
            hit = Struck(time, *names, contact, unit, e, on_second, (u1, u2), (v1, v2))
            self.struck.append(hit)
            for ball in struck:
                self.in_a_row[ball] = self.in_a_row[ball] + 1 if touching else 0
        for ball, u, v, w in zip(struck, (u1, u2), (v1, v2), (w1, w2)):
            size = _size(u) + _size(v) + float(w / (w1 + w2)) * _size(u1 - u2)
            self.send(ball, v, max(size, self.speeds[ball] if faint else 0))
        for ball in struck:
            others = set(range(self.bodies)) - {ball}
            if (first, second) not in self.inside:  # they part now, or stay together
                others -= {first, second}
            self.look(ball, sorted(others))
        self.forget()

    def send(self, ball: int, velocity: Vector, speed: float) -> None:
        """Let a sphere go on from where it is, with a velocity made from speeds so large."""
        settled = self.kind.settled(velocity, speed)
        self.stretches[ball].append(_Stretch(self.now, self.place(ball), settled))
        self.speeds[ball] = speed if settled is velocity else 0.0  # rest is exact
        self.changes[ball] += 1

    def into_wall(self, ball: int, other: int, place: Vector) -> Vector:
        """The line of centres from a sphere into what it strikes, of any length."""
        shape = self.obstacles[other - len(self.balls)].shape
        if isinstance(shape, Face):
            return shape.along.turned_left() * -self.sides[ball, other]
        if isinstance(shape, Post):
            return shape.place - place
        return place - shape.centre if (ball, other) in self.inside else shape.centre - place

    def refuse_collapse(self, due: _Due, e: Any, *, faint: bool, slides: bool) -> None:
        """Raise a CollapseError where bodies that touch already strike each other for ever."""
        balls = [number for number in (due.first, due.second) if number < len(self.balls)]
        row = max(self.in_a_row[ball] for ball in balls)
        names = self.name(due.first), self.name(due.second)
        if slides and (due.first, due.second) in self.inside:
            what = f"{names[0]} comes to slide along {names[1]}, in impacts without end"
        elif (
            row >= MOST_IN_A_ROW
            or (e < 1 and row >= MOST_WITH_LOSS)
            or (e < 1 and row >= SURE_AT_REST and faint)
        ):
            what = (
                f"the impacts of {names[0]}, the latest with {names[1]}, follow one another "
                "without end and in no time (inelastic collapse)"
            )
        else:
            return
        time = float(self.kind.time(self.now))
        error = CollapseError(
            f"at {time:.6g} s, after {counted(len(self.struck), 'impact')}, {what}: the motion "
            "cannot be told further; what happened until then is the run of this error"
        )
        error.run = self.so_far(self.now)
        raise error


def _size(vector: Vector) -> float:
    """How large the components are, together."""
    return abs(float(vector.x)) + abs(float(vector.y))


# --- what comes of it --------------------------------------------------------------------------


class _Stretch(NamedTuple):
    """Uniform motion from a moment on."""

    start: Any
    place: Vector
    velocity: Vector


class State(NamedTuple):
    """Where a sphere is (m), and how it moves (m/s)."""

    position: Vector
    velocity: Vector


_PAIRS = ("line", "impulse", "u1", "u2", "v1", "v2")
_COLUMNS = (
    "time",
    "e",
    "x",
    "y",
    *(f"{name}_{axis}" for name in _PAIRS for axis in "xy"),
)


@dataclass(frozen=True, repr=False)
class Run:
    """A motion that has been worked out, from time 0 to ``end`` (s).

    ``impacts`` are all impacts in the order of time, each a value; ``events`` are the same as a
    structured array of NumPy. On an exact table the former are exact, the latter always floats.
    """

    table: Table
    _end: Any = field(repr=False)
    _struck: tuple[Struck, ...] = field(repr=False)
    _stretches: tuple[tuple[_Stretch, ...], ...] = field(repr=False)
    _kind: Arithmetic = field(repr=False)

    @cached_property
    def end(self) -> Any:
        """When the motion ends, in s."""
        return self._kind.shown(self._kind.time(self._end))

    @cached_property
    def impacts(self) -> tuple[Struck, ...]:
        """Every impact: time, bodies, place, line of centres, impulse, velocities."""
        if not self._kind.exact:
            return self._struck
        return tuple(_with_numbers(hit, self._kind.shown) for hit in self._struck)

    @cached_property
    def events(self) -> np.ndarray[Any, Any]:
        """Every impact as a row of a structured array, which pandas and polars take as it is.

        ``time`` (s); ``first`` and ``second``, the names of the bodies; ``e``; ``x`` and ``y``,
        the point of contact (m); ``line_x``, ``line_y``, the unit vector along the line of
        centres from the first body to the second; ``impulse_x``, ``impulse_y``, on the second
        (N s); ``u1_x`` to ``u2_y`` the velocities before, ``v1_x`` to ``v2_y`` after (m/s).
        """
        from numpy import array

        width = max((len(body.name) for body in self.table.bodies), default=1)
        names = [("first", f"U{width}"), ("second", f"U{width}")]
        numbers = [(column, "f8") for column in _COLUMNS]
        rows = []
        for raw in self._struck:
            struck = _with_numbers(raw, float)
            vectors = (struck.line_of_centres, struck.impulse, *struck.before, *struck.after)
            pairs = [component for vector in vectors for component in vector]
            rows.append((struck.time, struck.first, struck.second, struck.e, *struck.place, *pairs))
        events: np.ndarray[Any, Any] = array(rows, dtype=[*numbers[:1], *names, *numbers[1:]])
        return events

    def at(self, time: Any) -> Mapping[str, State]:
        """Position and velocity of every sphere at a time (s), by name; at an impact, after it.

        Exact on an exact table, unless the time is a float. Raises ImpossibleError for a time
        that the motion does not reach.
        """
        kind = self._kind
        if kind.exact and isinstance(given(time, "the time"), float):
            motion = self.motion()
            _check_within(float(time), motion.end)
            return {name: State(*vector) for name, vector in motion.at(float(time)).items()}
        moment = kind.later(kind.start, kind.number(time, "the time"))
        _check_within(kind.time(moment), kind.time(self._end))
        return {
            ball.name: _state(stretches, moment, kind)
            for ball, stretches in zip(self.table.layout.balls, self._stretches)
        }

    def motion(self) -> Motion:
        """The motion in straight pieces, in floats, as the player plays it."""
        end = float(self._kind.time(self._end))
        tracks = tuple(
            Track(
                ball.name,
                float(ball.radius),
                float(ball.mass),
                tuple(self._pieces(stretches, end)),
            )
            for ball, stretches in zip(self.table.layout.balls, self._stretches)
        )
        struck = tuple(_with_numbers(hit, float) for hit in self._struck)
        return Motion(tracks, struck, tuple(_walls(self.table, tracks)), 0.0, end)

    def _pieces(self, stretches: tuple[_Stretch, ...], end: float) -> Iterator[Piece]:
        starts = [float(self._kind.time(stretch.start)) for stretch in stretches]
        for start, stop, stretch in zip(starts, [*starts[1:], end], stretches):
            yield Piece(start, stop, _floats(stretch.place), _floats(stretch.velocity))

    def __repr__(self) -> str:
        count = len(self._struck)
        end = float(self._kind.time(self._end))
        spheres, impacts = counted(len(self.table.spheres), "sphere"), counted(count, "impact")
        lines = [f"Motion of {spheres} from 0 to {end:.6g} s, {impacts}"]
        rows = range(count) if count <= 12 else [*range(8), None, *range(count - 3, count)]
        for n in rows:
            if n is None:
                lines.append(f"  … {count - 11} more")
                continue
            struck = _with_numbers(self._struck[n], float)
            x, y = struck.place
            size = hypot(*struck.impulse)
            lines.append(
                f"  {struck.time:10.6g} s  {struck.first} hits {struck.second} "
                f"at ({x:.4g}, {y:.4g}), impulse {size:.4g} N s"
            )
        return "\n".join(lines)


def _check_within(time: Any, end: Any) -> None:
    if time < 0 or time > end:
        raise ImpossibleError(
            f"the motion goes from 0 to {float(end):.6g} s, and says nothing of {float(time):.6g} s"
        )


def _state(stretches: tuple[_Stretch, ...], moment: Any, kind: Arithmetic) -> State:
    # By the time that a user sees: a moment may lie a little behind its own.
    time = kind.time(moment)
    latest = stretches[
        bisect_right(stretches, time, key=lambda stretch: kind.time(stretch.start)) - 1
    ]
    elapsed = max(kind.since(moment, latest.start), 0)
    place = latest.place + latest.velocity * elapsed
    shown = kind.shown
    return State(
        Vector(shown(place.x), shown(place.y)),
        Vector(shown(latest.velocity.x), shown(latest.velocity.y)),
    )


def _floats(vector: Vector) -> Vector:
    return Vector(float(vector.x), float(vector.y))


def _with_numbers(struck: Struck, number: Callable[[Any], Any]) -> Struck:
    """The same impact in other numbers."""

    def converted(vector: Vector) -> Vector:
        return Vector(number(vector.x), number(vector.y))

    (u1, u2), (v1, v2) = struck.before, struck.after
    return Struck(
        number(struck.time),
        struck.first,
        struck.second,
        converted(struck.place),
        converted(struck.line_of_centres),
        number(struck.e),
        converted(struck.impulse),
        (converted(u1), converted(u2)),
        (converted(v1), converted(v2)),
    )


def _walls(
    table: Table, tracks: tuple[Track, ...]
) -> Iterator[pieces.WallLine | pieces.WallCircle]:
    """The walls as they are drawn; a whole line as far as there is something to see."""
    shapes = table.layout.obstacles[: len(table.walls)]
    seen = [track.at(piece.start) for track in tracks for piece in track.pieces]
    seen += [track.at(track.pieces[-1].end) for track in tracks]
    for _, shape in shapes:
        if isinstance(shape, Face):
            seen.append(_floats(shape.start))
            seen += [_floats(shape.start + shape.along)] if shape.bounded else []
    for name, shape in shapes:
        if isinstance(shape, Ring):
            yield pieces.WallCircle(name, _floats(shape.centre), float(shape.radius))
        elif isinstance(shape, Face):
            start, along = _floats(shape.start), _floats(shape.along)
            if shape.bounded:
                yield pieces.WallLine(name, (start, start + along))
            else:
                feet = [along.dot(point - start) / along.dot(along) for point in seen]
                yield pieces.WallLine(name, (start + along * min(feet), start + along * max(feet)))
