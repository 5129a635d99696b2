"""The motion of a solved problem: when and where everything is that its story tells.

Velocities are those of the solution; places and times are the statement's where it gives them.
What it leaves open is chosen so that the motion is clear to see, and so that no body strikes
another one of which the story does not speak.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np

from restitution.errors import RestitutionError, UnsupportedError
from restitution.expression.tree import AtTime, Name, Quantity, walk
from restitution.motion.overlap import Overlap, overlaps
from restitution.motion.pieces import Blow, Circle, Line, Motion, Piece, Reached, Struck, Track
from restitution.problem import Arrival, Impact, Kick, Problem, trees
from restitution.solve.solution import Branch, PartSolution, Solution
from restitution.solve.story import Story
from restitution.staging import flights, values
from restitution.staging.flights import Given, Move
from restitution.staging.geometry import floats, length, still, unit
from restitution.staging.plan import Leg
from restitution.staging.planning import (
    box,
    connected,
    ends_at_wall,
    free_way,
    raise_walls,
    stop_of,
    wall_lines,
)
from restitution.staging.walls import Line as Wall
from restitution.vector import Vector

# Where nothing is said of lengths they are chosen in units that a plan on paper has: the radius of
# a sphere, how far the fastest one comes and goes, the flights between events.
_RADIUS, _AMONG_WALLS = 4.5, 3.0
_APPROACH, _FLIGHT, _EXIT = 30.0, 30.0, 34.0
_SHORTEST = 8.0
_WIDTH, _HEIGHT = 80.0, 60.0
# The time before the first event and that after the last are no more than so many times each other.
_SLOWER = 2.5
# Seconds that the fastest sphere takes for its approach, where nothing is said of lengths.
_SECONDS = 1.0
# Places are known: how far the fastest sphere is seen to go on, as a share of all that is given.
_ONWARD = 0.3
_TRIES = 80
# A motion ends, or begins, so much (of its duration) apart from an impact that is not told.
_APART = 0.02
_PLACES = frozenset(("position", "distance", "time"))


Event: TypeAlias = Struck | Blow | Reached
Staged: TypeAlias = tuple[Motion, tuple[tuple[int, Event], ...]]


@dataclass(frozen=True)
class Told:
    """The motion of one part of a problem, by one of its solutions.

    ``labels`` are those of the parts that have this motion, ``numbers`` the part in numbers.
    ``events`` has every event with its number in the story, in the order of time, and ``masses``
    those that are known, in kg: in the motion the others are 1 kg.
    """

    labels: tuple[str | None, ...]
    part: PartSolution
    branch: Branch
    numbers: values.Motion
    motion: Motion
    events: tuple[tuple[int, Event], ...]
    masses: Mapping[str, float]

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the spheres that are seen."""
        return tuple(track.name for track in self.motion.tracks)


def motions(solution: Solution, part: str | None = None) -> tuple[Told, ...]:
    """Every motion of a solved problem, or of the part with that label, in the order told.

    One for each part and each of its solutions; spheres that have nothing to do with one another,
    and no places, are shown apart. Raises KeyError for a part that is not there; what kept the
    problem from being solved; and UnsupportedError, with the reason, where no motion can be shown.
    """
    if part is not None and part not in solution.parts:
        known = ", ".join(str(label) for label in solution.parts)
        raise KeyError(f"there is no part {part!r}; parts: {known}")
    chosen = [each for label, each in solution.parts.items() if part in (None, label)]
    found: list[Told] = []
    reasons: list[RestitutionError] = []
    for each in chosen:
        if each.error is not None and not each.branches:
            reasons.append(each.error)
        for branch in each.branches:
            try:
                _add(found, list(_told(solution, each, branch)))
            except UnsupportedError as error:
                reasons.append(error)
    if not found:
        raise (reasons or [_no("no event is told")])[0]
    return tuple(found)


def _no(reason: str) -> UnsupportedError:
    return UnsupportedError(f"no motion can be shown: {reason}")


def _add(found: list[Told], new: Sequence[Told]) -> None:
    """Adds motions; one that another part has had already gets its label too."""
    for told in new:
        same = next((k for k, each in enumerate(found) if _alike(each.motion, told.motion)), None)
        if same is None:
            found.append(told)
        elif told.labels[0] not in found[same].labels:
            found[same] = replace(found[same], labels=(*found[same].labels, *told.labels))


def _alike(one: Motion, other: Motion) -> bool:
    """Whether two motions show the same."""
    first, second = list(_all_numbers(one)), list(_all_numbers(other))
    return len(first) == len(second) and bool(np.allclose(first, second, rtol=1e-9, atol=1e-9))


def _all_numbers(motion: Motion) -> Iterator[float]:
    yield from (motion.start, motion.end)
    for track in motion.tracks:
        yield from (track.mass, track.radius)
        for piece in track.pieces:
            yield from (piece.start, piece.end, *piece.place, *piece.velocity)


def _told(solution: Solution, part: PartSolution, branch: Branch) -> Iterator[Told]:
    told = values.motion(solution, part, branch)
    own = sum(isinstance(step, Impact | Kick | Arrival) for step in part.part.steps)
    since = len(told.story.happenings) - own
    timed = not any(
        name.startswith("_t_") and name not in branch.values for name in part.roles
    )  # a time that is free is chosen here, with the places
    masses = {name: _mass(told.story, told.numbers, name) for name in told.story.spheres}
    known = {name: mass for name, mass in masses.items() if mass is not None}
    for motion, events in staged(told.story, known, since, timed=timed):
        yield Told((part.part.label,), part, branch, told, motion, events, known)


def _mass(story: Story, numbers: Mapping[str, Any], name: str) -> float | None:
    """The mass of a sphere, in kg; None where nothing is known of it and nothing depends on it."""
    given = story.spheres[name].mass
    if given is not None:
        return float(story.read(given, ""))
    hidden = numbers.get(f"_m_{name}")
    return None if hidden is None else float(hidden)


# --- one story ------------------------------------------------------------------------------------


def staged(
    story: Story, masses: Mapping[str, float], since: int = 0, *, timed: bool = True
) -> list[Staged]:
    """The motions of a story that is told in numbers, each with its numbered events.

    Of spheres that have nothing to do with one another, in a story without places, those are shown
    to whom something happens after event ``since``. ``timed`` tells whether the times in the story
    follow from what is given; ``masses`` are in kg. Raises UnsupportedError with the reason why
    there is no motion to be seen.
    """
    if not story.happenings:
        raise _no("no event is told")
    for each in story.happenings:
        if each.e is not None and not -1e-9 <= float(each.e) <= 1 + 1e-9:
            raise _no(f"e would be {float(each.e):.3g}, and it lies in [0, 1]")
    try:
        moves, given = flights.events(story), flights.told_places(story)
    except (RestitutionError, ArithmeticError) as error:
        raise _no(f"a place does not follow from what is given ({error})") from error
    if all(still(v) for m in moves for v in (*m.before.values(), *m.after.values())):
        raise _no("nothing moves")
    try:
        if given.placed:
            return [_placed(story, moves, given, masses, timed)]
        given = replace(given, origins={}, points={})
        groups = connected(moves)
        recent = [g for g in groups if any(move.number > since for move in g)] or groups
        return [_freely(story, group, given, masses) for group in recent]
    except np.linalg.LinAlgError as error:
        raise _no("its places could not be worked out") from error


@dataclass(frozen=True)
class _Stage:
    """Where and when everything happens, in m and s; ``scale`` is units on paper for a metre."""

    story: Story
    moves: Sequence[Move]
    given: Given
    masses: Mapping[str, float]
    where: Mapping[tuple[str, int], Vector]
    times: Mapping[int, float]
    radius: float
    scale: float
    start: float
    end: float


def _placed(
    story: Story,
    moves: Sequence[Move],
    given: Given,
    masses: Mapping[str, float],
    timed: bool,
) -> Staged:
    """The motion where places are given."""
    radius = given.radius or 0.0
    moves = _without_doubles(moves)
    made = flights.unknowns(story, moves, given.starts, given.origins, radius)
    if timed:
        for move in moves:
            time = story.happenings[move.number - 1].time
            if time is not None:
                made.fix(made.times[move.number], float(time))
    left, bottom, right, top = box(_known(given))
    extent = max(right - left, top - bottom) or 1.0
    x = flights.solve(made, [0.6 * extent] * len(made.lengths), 0.02 * extent)
    if x is None:
        raise _no("no places fit to all that is told")
    where = {key: floats(p @ x + c) for key, (p, c) in made.where.items()}
    times = {number: float(row @ x) for number, row in made.times.items()}
    left, bottom, right, top = box([*_known(given), *where.values()])
    extent = max(right - left, top - bottom)
    last = max(times.values())
    asked = [time for time in _asked(story) if time > 0]
    fastest = max(length(v) for m in moves for v in m.after.values()) or 1.0
    end = max([last + _ONWARD * extent / fastest, *(1.05 * time for time in asked)])
    scale = _WIDTH / extent
    stage = _Stage(story, moves, given, masses, where, times, radius, scale, 0.0, end)
    motion, cost = _cleared(stage)
    if math.isinf(cost):
        raise _no(_in_the_way(motion))
    return motion, tuple(_events(stage))


def _known(given: Given) -> list[Vector]:
    """Every place that a statement gives."""
    known = [*given.starts.values(), *given.points.values(), *given.origins.values()]
    known += [end for ends in given.segments.values() for end in ends]
    known += [c + d * r for c, r in given.circles.values() for d in (Vector(1, 1), Vector(-1, -1))]
    return known


def _without_doubles(moves: Sequence[Move]) -> list[Move]:
    """Without coming to a wall where the very next thing is the impact with it."""
    kept = []
    for k, move in enumerate(moves):
        following = next((m for m in moves[k + 1 :] if move.bodies[0] in m.bodies), None)
        if not (
            move.kind == "arrival"
            and move.wall is not None
            and following is not None
            and following.wall == move.wall
        ):
            kept.append(move)
    return kept


def _freely(
    story: Story, moves: Sequence[Move], given: Given, masses: Mapping[str, float]
) -> Staged:
    """The motion where a statement gives directions only: the clearest of several."""
    moves = _without_doubles(moves)
    points = given.radius is None and _speaks_of_places(story.problem)
    walled = any(move.wall is not None for move in moves)
    radius = 0.0 if points else _AMONG_WALLS if walled else _RADIUS
    made = flights.unknowns(story, moves, {}, {}, radius)
    fastest = max(length(v) for m in moves for v in (*m.before.values(), *m.after.values()))
    unit_length = (
        given.radius / radius if given.radius and radius else fastest * _SECONDS / _APPROACH
    )
    best: tuple[float, Motion, _Stage] | None = None
    for factors in _factors(len(made.lengths)):
        x = flights.solve(made, [_FLIGHT * factor for factor in factors], _SHORTEST)
        if x is None:
            continue
        where = {key: floats(p @ x + c) * unit_length for key, (p, c) in made.where.items()}
        times = {number: float(row @ x) * unit_length for number, row in made.times.items()}
        size, scale = radius * unit_length, 1 / unit_length
        stage = _in_time(_Stage(story, moves, given, masses, where, times, size, scale, 0.0, 0.0))
        motion, cost = _cleared(stage)
        cost += 2 * sum(abs(math.log(factor)) for factor in factors)
        if best is None or cost < best[0]:
            best = cost, motion, stage
        if best[0] < 1.0:
            break
    if best is None:
        raise _no("no places fit to all that is told")
    cost, motion, stage = best
    if math.isinf(cost):
        raise _no(_in_the_way(motion))
    return motion, tuple(_events(stage))


def _factors(flights: int) -> Iterator[tuple[float, ...]]:
    """Lengths of the flights to be tried, as multiples of the usual one; the usual ones first."""
    if flights <= 3:
        every = itertools.product((1.0, 0.7, 1.4, 0.45, 2.2), repeat=flights)
        yield from sorted(every, key=lambda each: sum(abs(math.log(x)) for x in each))[:_TRIES]
        return
    rng = random.Random(5)
    yield (1.0,) * flights
    for _ in range(_TRIES):
        yield tuple(rng.choice((0.45, 0.7, 1.0, 1.0, 1.4, 2.2)) for _ in range(flights))


def _in_time(stage: _Stage) -> _Stage:
    """With a beginning and an end that show how the spheres come and go.

    The clock starts with the motion, or at the first impact where the language says so.
    """
    unit_length = 1 / stage.scale
    bodies = dict.fromkeys(name for move in stage.moves for name in move.bodies)
    comes, goes = [], []
    for body in bodies:
        own = [move for move in stage.moves if body in move.bodies]
        comes.append(length(own[0].before[body]))
        goes.append(length(own[-1].after[body]))
    first, last = min(stage.times.values()), max(stage.times.values())
    usual = _SECONDS if not any((*comes, *goes)) else 0.0
    lead = _APPROACH * unit_length / max(comes) if any(comes) else usual
    tail = _EXIT * unit_length / max(goes) if any(goes) else usual
    lead = lead or 0.4 * tail  # everything is at rest until something is struck
    tail = tail or 0.4 * lead
    lead, tail = min(lead, _SLOWER * tail), min(tail, _SLOWER * lead)
    zero = first if stage.story.implied else first - lead
    times = {number: time - zero for number, time in stage.times.items()}
    start, end = first - lead - zero, last + tail - zero
    if stage.story.implied:
        end = max([end, *(1.05 * time for time in _asked(stage.story))])
    return replace(stage, times=times, start=start, end=end)


def _asked(story: Story) -> list[float]:
    """The times of which a statement speaks, as in ``at 2``."""
    found = []
    for tree in trees(story.problem):
        for node in walk(tree):
            if isinstance(node, Quantity) and isinstance(node.stage, AtTime):
                try:
                    found.append(float(story.evaluator(0).scalar(node.stage.time)))
                except (RestitutionError, ArithmeticError, LookupError, TypeError):
                    continue
    return found


def _speaks_of_places(problem: Problem) -> bool:
    return any(
        isinstance(node, Quantity) and node.kind in _PLACES
        for tree in trees(problem)
        for node in walk(tree)
    )


# --- from places and times to pieces --------------------------------------------------------------


def _cleared(stage: _Stage) -> tuple[Motion, float]:
    """The motion on a stage, without impacts that are not told, and how far from a clear one it is.

    It begins later and ends sooner where that is needed; the cost is infinite where it is not
    enough. Walls without ends are first drawn as far as the paths go, else only where they are
    struck.
    """
    best: tuple[float, Motion] | None = None
    for short in (False, True):
        motion = _performed(stage, short)
        left, bottom, right, top = box(_seen(motion))
        extent = max(right - left, top - bottom)
        fill = max((right - left) / _WIDTH, (top - bottom) / _HEIGHT) * stage.scale
        motion, cost = _trimmed(motion, stage, extent)
        if not stage.given.placed:
            cost += 15 * max(0.0, fill - 1.3) + 5 * short
        if best is None or cost < best[0]:
            best = cost, motion
        if best[0] < 1.0 or (not stage.given.placed and cost < 8):
            break
    assert best is not None
    return best[1], best[0]


def _seen(motion: Motion) -> Iterator[Vector]:
    for track in motion.tracks:
        for piece in track.pieces:
            yield from (piece.place, piece.at(piece.end))
    for wall in motion.walls:
        if isinstance(wall, Line):
            yield from wall.points
        else:
            yield from (wall.centre + d * wall.radius for d in (Vector(1, 1), Vector(-1, -1)))


def _trimmed(motion: Motion, stage: _Stage, extent: float) -> tuple[Motion, float]:
    """Begun after, and ended before, impacts that are not told."""
    first, last = min(stage.times.values()), max(stage.times.values())
    start, end, notes = motion.start, motion.end, list(motion.notes)
    span = end - start
    for each in overlaps(motion, extent):
        if each.start >= last - 1e-9 * span:
            if each.start < end:
                end = max(each.start - _APART * span, (last + each.start) / 2)
                notes = [*motion.notes, _comes_next(each, stage)]
        elif each.end <= first + 1e-9 * span and not stage.given.placed:
            start = max(start, min(each.end + _APART * span, (first + each.end) / 2))
        else:
            return replace(motion, notes=(*motion.notes, _comes_next(each, stage))), math.inf
    lost = (start - motion.start) / span + (motion.end - end) / span
    cut = _cut(motion, start, end)
    return replace(cut, notes=tuple(notes)), 30 * lost


def _comes_next(each: Overlap, stage: _Stage) -> str:
    """What would happen that the story does not tell."""
    walls = stage.story.walls
    second = f"the wall {each.second}" if each.second in walls else each.second
    return f"{each.first} comes to {second} next, which the question does not tell."


def _in_the_way(motion: Motion) -> str:
    return f"{motion.notes[-1].removesuffix('.')}" if motion.notes else "bodies are in the way"


def _cut(motion: Motion, start: float, end: float) -> Motion:
    """The same for a part of its time."""
    return replace(
        motion,
        start=start,
        end=end,
        tracks=tuple(
            replace(track, pieces=tuple(_between(track.pieces, start, end)))
            for track in motion.tracks
        ),
    )


def _between(pieces: Sequence[Piece], start: float, end: float) -> Iterator[Piece]:
    for piece in pieces:
        low, high = max(piece.start, start), min(piece.end, end)
        if high > low or (high == low and piece.start == piece.end):
            yield Piece(low, high, piece.at(low), piece.velocity)


def _performed(stage: _Stage, short: bool) -> Motion:
    """Every body's pieces and every event, between walls that are as short as wanted."""
    moves, given, where, scale = stage.moves, stage.given, stage.where, stage.scale
    on_paper = {key: place * scale for key, place in where.items()}
    stops = [stop_of(move, on_paper, stage.radius * scale) for move in moves]
    lines = wall_lines(stage.story, moves, given, stops, scale)
    start, end = stage.start, stage.end
    for body in dict.fromkeys(name for move in moves for name in move.bodies):
        own = [move for move in moves if body in move.bodies]
        if not given.placed:
            start = max(
                start, stage.times[own[0].number] - _free_time(stage, own[0], body, lines, -1)
            )
        if ends_at_wall(own[-1], given, on_paper, body, scale):
            end = min(end, max(stage.times.values()))
        elif not given.placed:
            end = min(end, stage.times[own[-1].number] + _free_time(stage, own[-1], body, lines, 1))
    start = min(start, *stage.times.values())
    end = max(end, *stage.times.values())
    tracks = tuple(_tracks(stage, start, end))
    legs = [
        Leg(t.name, k, "flight", p.place * scale, p.at(p.end) * scale)
        for t in tracks
        for k, p in enumerate(t.pieces)
        if length(p.velocity) * (p.end - p.start) * scale > 1e-6
    ]
    crossing_ends = [point * scale for point in given.points.values()]
    raise_walls(lines, moves, given, stops, legs, crossing_ends, 1.0)
    if short:
        for line in lines:
            _shorten(line, 2 * stage.radius * scale + 3)
    events = [event for _, event in _events(stage)]
    return Motion(
        tracks,
        tuple(each for each in events if isinstance(each, Struck)),
        (*(_as_wall(line, scale) for line in lines), *_circles(given)),
        start,
        end,
        () if given.placed else ("Lengths and times are free: the question gives none.",),
        tuple(each for each in events if isinstance(each, Blow)),
        tuple(each for each in events if isinstance(each, Reached)),
        dict(given.points),
    )


def _free_time(stage: _Stage, move: Move, body: str, lines: Sequence[Wall], sense: int) -> float:
    """For how long a sphere comes, or goes, without another wall in its way (s)."""
    velocity = (move.before if sense < 0 else move.after)[body]
    if still(velocity):
        return math.inf
    place = stage.where[body, move.number] * stage.scale
    far = 10 * (_WIDTH + _HEIGHT)
    free = free_way(place, unit(velocity) * sense, far, lines, move.wall)
    return math.inf if free == far else free / (length(velocity) * stage.scale)


def _shorten(line: Wall, beyond: float) -> None:
    """Leaves of a wall without ends what is near to where it is struck."""
    if not line.fixed and line.hits:
        line.low = max(line.low, min(line.hits) - beyond)
        line.high = min(line.high, max(line.hits) + beyond)


def _as_wall(line: Wall, scale: float) -> Line:
    return Line(line.name, (line.at(line.low) / scale, line.at(line.high) / scale))


def _circles(given: Given) -> Iterator[Circle]:
    for name, (centre, radius) in given.circles.items():
        yield Circle(name, centre, radius)


def _tracks(stage: _Stage, start: float, end: float) -> Iterator[Track]:
    story, moves = stage.story, stage.moves
    for name in story.spheres:
        own = [move for move in moves if name in move.bodies]
        if not own and (name not in stage.given.starts or story.spheres[name].velocity is None):
            continue
        own.sort(key=lambda move: stage.times[move.number])
        at = start
        velocity = own[0].before[name] if own else floats(story.velocity(name, 0))
        if own:
            first = own[0].number
            place = stage.where[name, first] + velocity * (start - stage.times[first])
        else:
            place = stage.given.starts[name] + velocity * start
        pieces = []
        for move in own:
            time = stage.times[move.number]
            pieces.append(Piece(at, time, place, velocity))
            at, place, velocity = time, stage.where[name, move.number], move.after[name]
        pieces.append(Piece(at, max(end, at), place, velocity))
        kept = tuple(p for p in pieces if p.end > p.start) or (pieces[-1],)
        yield Track(name, stage.radius, stage.masses.get(name, 1.0), kept)


def _events(stage: _Stage) -> Iterator[tuple[int, Event]]:
    """Every event with its number in the story, in the order of time."""
    for move in sorted(stage.moves, key=lambda move: (stage.times[move.number], move.number)):
        happening = stage.story.happenings[move.number - 1]
        step, time, name = happening.step, stage.times[move.number], move.bodies[0]
        place, before, after = stage.where[name, move.number], move.before[name], move.after[name]
        if isinstance(step, Impact):
            assert move.normal is not None
            still_wall = Vector(0.0, 0.0)
            yield (
                move.number,
                Struck(
                    time,
                    name,
                    step.second,
                    place + move.normal * stage.radius,
                    move.normal,
                    float(happening.e),
                    (before - after) * stage.masses.get(name, 1.0),
                    (before, move.before.get(step.second, still_wall)),
                    (after, move.after.get(step.second, still_wall)),
                ),
            )
        elif isinstance(step, Kick):
            assert happening.impulse is not None
            yield (
                move.number,
                Blow(time, name, place, floats(happening.impulse), before, after),
            )
        else:
            target = step.target.name if isinstance(step.target, Name) else None
            yield move.number, Reached(time, name, place, target, after)
