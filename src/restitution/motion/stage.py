"""A story on its stage: the pieces of all paths, the walls between them, and what ends them.

Everything is computed in SI units; only how far walls go on is decided as on paper, with the rules
that pictures have.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias

from restitution.expression.tree import Name
from restitution.motion.overlap import overlaps
from restitution.motion.pieces import (
    Blow,
    Motion,
    Piece,
    Reached,
    Struck,
    Track,
    WallCircle,
    WallLine,
)
from restitution.problem import Impact, Kick
from restitution.records import dataclass
from restitution.solving.story.forward import Story
from restitution.staging.flights import Given, Move
from restitution.staging.geometry import floats, length, still, unit
from restitution.staging.plan import Leg
from restitution.staging.planning import (
    box,
    ends_at_wall,
    free_way,
    raise_walls,
    stop_of,
    wall_lines,
)
from restitution.staging.walls import DrawnWall as Wall
from restitution.vector import Vector

#: What a motion may fill, in the units on paper.
WIDTH, HEIGHT = 80.0, 60.0
# A motion ends, or begins, so much (of its duration) apart from an impact that is not told.
_APART = 0.02
# This share of the time before the first event, and after the last, is to be seen if possible.
_SEEN = 0.3
# Times come from a system of equations: those that differ by less (of a motion) are one time.
_AT_ONCE = 1e-9
# Before a wall, a sphere stops at this share of its way there.
_SHORT_OF = 0.95

Event: TypeAlias = Struck | Blow | Reached


@dataclass(frozen=True)
class Stage:
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


@dataclass(frozen=True)
class Attempt:
    """A motion, how far it is from a clear one, and who is in the way, if anybody is."""

    motion: Motion
    cost: float
    in_the_way: str | None = None


def settled(stage: Stage) -> Stage:
    """The stage with one time for all events that only rounding sets apart, or from the start.

    Else a body would have a piece of its path that lasts for 10⁻¹⁶ s, on some machines.
    """
    slack = _AT_ONCE * (stage.end - stage.start)
    times, latest = {}, stage.start
    for number in sorted(stage.times, key=lambda number: stage.times[number]):
        if abs(stage.times[number] - latest) > slack:
            latest = stage.times[number]
        times[number] = latest
    return replace(stage, times=times)


def cleared(stage: Stage) -> Attempt:
    """The motion on a stage, without impacts that the story does not have.

    It begins later and ends sooner where that is needed. Walls without ends are drawn as far as
    the paths go; only where they are struck, if that is better.
    """
    long = _trimmed(*_performed(stage, short=False), stage)
    if long.cost < 1.0 or (stage.given.placed and long.in_the_way is None):
        return long
    short = _trimmed(*_performed(stage, short=True), stage)
    return min(long, replace(short, cost=short.cost + 5), key=lambda attempt: attempt.cost)


def _seen(motion: Motion) -> Iterator[Vector]:
    for track in motion.tracks:
        for piece in track.pieces:
            yield from (piece.place, piece.at(piece.end))
    for wall in motion.walls:
        if isinstance(wall, WallLine):
            yield from wall.points
        else:
            yield from (wall.centre + d * wall.radius for d in (Vector(1, 1), Vector(-1, -1)))


def _trimmed(motion: Motion, stopped: str | None, stage: Stage) -> Attempt:
    """The motion begun after, and ended before, impacts that the story does not have.

    ``stopped`` says before which one it ends already.
    """
    left, bottom, right, top = box(_seen(motion))
    fill = max((right - left) / WIDTH, (top - bottom) / HEIGHT) * stage.scale
    cost = 0.0 if stage.given.placed else 15 * max(0.0, fill - 1.3)
    first, last = min(stage.times.values()), max(stage.times.values())
    start, end = motion.start, motion.end
    span = end - start
    for overlap in overlaps(motion, max(right - left, top - bottom)):
        if overlap.start >= last - 1e-9 * span:
            if overlap.start < end:
                end = max(overlap.start - _APART * span, (last + overlap.start) / 2)
                stopped = _meeting(overlap.first, overlap.second, stage)
        elif overlap.end <= first + 1e-9 * span and not stage.given.placed:
            start = max(start, min(overlap.end + _APART * span, (first + overlap.end) / 2))
        else:
            return Attempt(motion, math.inf, _meeting(overlap.first, overlap.second, stage))
    if stopped is not None:
        caption = f"It ends before {stopped}, which the question does not tell."
        motion = replace(motion, notes=(*motion.notes, caption))
    lost = (start - motion.start) / span + (motion.end - end) / span
    return Attempt(_cut(motion, start, end), cost + 30 * lost)


def _meeting(first: str, second: str, stage: Stage) -> str:
    """An impact that the story does not have, in words."""
    other = f"the wall {second}" if second in stage.story.walls else second
    return f"{first} comes to {other}"


def _cut(motion: Motion, start: float, end: float) -> Motion:
    """A part of a motion, from one time to another."""
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


def _performed(stage: Stage, *, short: bool) -> tuple[Motion, str | None]:
    """Every body's pieces and every event, between walls that are as short as wanted.

    It ends before a wall is in the way; with it comes who would come to which wall.
    """
    moves, given, where, scale = stage.moves, stage.given, stage.where, stage.scale
    on_paper = {key: place * scale for key, place in where.items()}
    stops = [stop_of(move, on_paper, stage.radius * scale) for move in moves]
    lines = wall_lines(stage.story, moves, given, stops, scale)
    start, end = stage.start, stage.end
    first, last = min(stage.times.values()), max(stage.times.values())
    stopped = None
    for body in dict.fromkeys(name for move in moves for name in move.bodies):
        own = [move for move in moves if body in move.bodies]
        if ends_at_wall(own[-1], given, on_paper, body, scale):
            end = min(end, last)
        if given.placed:
            continue
        # Stopping for a wall that may as well end elsewhere must leave enough to be seen.
        comes, _ = _free_time(stage, own[0], body, lines, -1)
        since = stage.times[own[0].number] - comes
        if start < since < first - _SEEN * (first - stage.start):
            start = since
        goes, wall = _free_time(stage, own[-1], body, lines, 1)
        until = stage.times[own[-1].number] + goes
        if last + _SEEN * (stage.end - last) < until < end:
            end, stopped = until, _meeting(body, wall, stage)
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
    events = [event for _, event in numbered(stage)]
    motion = Motion(
        tracks,
        tuple(event for event in events if isinstance(event, Struck)),
        (*(_as_wall(line, scale) for line in lines), *_circles(given)),
        start,
        end,
        tuple(_notes(stage, tracks)),
        tuple(event for event in events if isinstance(event, Blow)),
        tuple(event for event in events if isinstance(event, Reached)),
        dict(given.points),
    )
    return motion, stopped


def _notes(stage: Stage, tracks: Sequence[Track]) -> Iterator[str]:
    """What those who look at it ought to know."""
    if not stage.given.placed:
        yield "Lengths and times are free: the question gives none."
    seen = {track.name for track in tracks}
    for name in stage.story.spheres:
        if name not in seen and not any(
            name in happening.bodies for happening in stage.story.happenings
        ):
            yield f"{name} is not shown: its place is not told."


def _free_time(
    stage: Stage, move: Move, body: str, lines: Sequence[Wall], sense: int
) -> tuple[float, str]:
    """For how long a sphere comes, or goes, without another wall in its way (s), and which."""
    velocity = (move.before if sense < 0 else move.after)[body]
    if still(velocity):
        return math.inf, ""
    place, course = stage.where[body, move.number] * stage.scale, unit(velocity) * sense
    far = 10 * (WIDTH + HEIGHT)
    free = {line.name: free_way(place, course, far, [line], move.wall) for line in lines}
    nearest = min(free, key=lambda name: free[name], default="")
    if free.get(nearest, far) == far:
        return math.inf, ""
    return _SHORT_OF * free[nearest] / (length(velocity) * stage.scale), nearest


def _shorten(line: Wall, beyond: float) -> None:
    """Leaves of a wall without ends what is near to where it is struck."""
    if not line.fixed and line.hits:
        line.low = max(line.low, min(line.hits) - beyond)
        line.high = min(line.high, max(line.hits) + beyond)


def _as_wall(line: Wall, scale: float) -> WallLine:
    return WallLine(line.name, (line.at(line.low) / scale, line.at(line.high) / scale))


def _circles(given: Given) -> Iterator[WallCircle]:
    for name, (centre, radius) in given.circles.items():
        yield WallCircle(name, centre, radius)


def _tracks(stage: Stage, start: float, end: float) -> Iterator[Track]:
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


def numbered(stage: Stage) -> Iterator[tuple[int, Event]]:
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
