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
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np

from restitution.errors import RestitutionError, UnsupportedError
from restitution.expression.quantities import PLACED
from restitution.expression.tree import AtTime, Quantity, walk
from restitution.motion.pieces import Motion
from restitution.motion.stage import WIDTH, Attempt, Event, Stage, cleared, numbered, settled
from restitution.problem import Problem, trees
from restitution.records import dataclass
from restitution.solving.equations.solution import Branch, PartSolution, Solution
from restitution.solving.story.forward import Story
from restitution.staging import flights, values
from restitution.staging.flights import Given, Move
from restitution.staging.geometry import floats, length, still
from restitution.staging.planning import box, connected
from restitution.vector import Vector

# Where nothing is said of lengths they are chosen in units that a plan on paper has: the radius of
# a sphere, how far the fastest one comes and goes, the flights between events.
_RADIUS, _AMONG_WALLS = 4.5, 3.0
# Smaller spheres, as shares of that radius, are tried where these are in one another's way.
_SIZES = (1.0, 0.6, 0.35)
_APPROACH, _FLIGHT, _EXIT = 30.0, 30.0, 34.0
_SHORTEST = 8.0
# For this share of the rest of it, a motion stays where everything is at rest at first or at last.
_REST = 0.4
# The time before the first event and that after the last are no more than so many times each other.
_SLOWER = 2.5
# Seconds that the fastest sphere takes for its approach, where nothing is said of lengths.
_SECONDS = 1.0
# Places are known: how far the fastest sphere is seen to go on, as a share of all that is given.
_ONWARD = 0.3
_TRIES = 80


Staged: TypeAlias = tuple[Motion, tuple[tuple[int, Event], ...]]


@dataclass(frozen=True)
class PartMotion:
    """The motion of one part of a problem, by one of its solutions.

    ``labels`` are those of the parts that have this motion, ``numbers`` the part in numbers.
    ``events`` has every event with its number in the story, in the order of time, and ``masses``
    those that are known, in kg: in the motion the others are 1 kg.
    """

    labels: tuple[str | None, ...]
    part: PartSolution
    branch: Branch
    numbers: values.PartInNumbers
    motion: Motion
    events: tuple[tuple[int, Event], ...]
    masses: Mapping[str, float]

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the spheres that are seen."""
        return tuple(track.name for track in self.motion.tracks)


def motions(
    solution: Solution, part: str | None = None, wanted: Mapping[str, Any] | None = None
) -> tuple[PartMotion, ...]:
    """Every motion of a solved problem, or of the part with that label, in the order told.

    One for each part and each of its solutions; spheres that have nothing to do with one another,
    and no places, are shown apart. ``wanted`` are values for letters that are taken where they are
    possible. Raises KeyError for a part that is not there; what kept the
    problem from being solved; and UnsupportedError, with the reason, where no motion can be shown.
    """
    chosen = solution.chosen(part)
    part_motions: list[PartMotion] = []
    reasons: list[RestitutionError] = []
    for solved in chosen:
        if solved.error is not None and not solved.branches:
            reasons.append(solved.error)
        for branch in solved.branches:
            try:
                _add(part_motions, list(_of_branch(solution, solved, branch, wanted)))
            except UnsupportedError as error:
                reasons.append(error)
    if not part_motions:
        raise (reasons or [_no("no event is told")])[0]
    return tuple(part_motions)


def _no(reason: str) -> UnsupportedError:
    return UnsupportedError(f"no motion can be shown: {reason}")


def _add(part_motions: list[PartMotion], new: Sequence[PartMotion]) -> None:
    """Adds motions; one that another part has had already gets its label too."""
    for motion in new:
        same = next(
            (k for k, known in enumerate(part_motions) if _alike(known.motion, motion.motion)), None
        )
        if same is None:
            part_motions.append(motion)
        elif motion.labels[0] not in part_motions[same].labels:
            part_motions[same] = replace(
                part_motions[same], labels=(*part_motions[same].labels, *motion.labels)
            )


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


def _of_branch(
    solution: Solution, part: PartSolution, branch: Branch, wanted: Mapping[str, Any] | None
) -> Iterator[PartMotion]:
    numbers = values.motion(solution, part, branch, wanted)
    own = len(part.part.events)
    since = len(numbers.story.happenings) - own
    timed = not any(
        name.startswith("_t_") and name not in branch.values for name in part.roles
    )  # a time that is free is chosen here, with the places
    masses = {name: _mass(numbers.story, numbers.numbers, name) for name in numbers.story.spheres}
    known = {name: mass for name, mass in masses.items() if mass is not None}
    for motion, events in staged(numbers.story, known, since, timed=timed):
        yield PartMotion((part.part.label,), part, branch, numbers, motion, events, known)


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
    for happening in story.happenings:
        if happening.e is not None and not -1e-9 <= float(happening.e) <= 1 + 1e-9:
            raise _no(f"e would be {float(happening.e):.3g}, and it lies in [0, 1]")
    try:
        moves, given = flights.events(story), flights.given_places(story)
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
    layout = flights.unknowns(story, moves, given.starts, given.origins, radius)
    if timed:
        for move in moves:
            time = story.happenings[move.number - 1].time
            if time is not None:
                layout.fix(layout.times[move.number], float(time))
    left, bottom, right, top = box(_known(given))
    extent = max(right - left, top - bottom) or 1.0
    x = flights.solve(layout, [0.6 * extent] * len(layout.lengths), 0.02 * extent)
    if x is None:
        raise _no("no places fit to all that is told")
    where = {key: floats(p @ x + c) for key, (p, c) in layout.where.items()}
    times = {number: float(row @ x) for number, row in layout.times.items()}
    left, bottom, right, top = box([*_known(given), *where.values()])
    extent = max(right - left, top - bottom)
    goes = max(length(v) for v in _last(moves).values())
    fastest = max(length(v) for m in moves for v in (*m.before.values(), *m.after.values()))
    last = max(times.values())
    tail = min(_ONWARD * extent / (goes or fastest), max(last / 2, _ONWARD * extent / fastest))
    end = max([last + tail, *(1.05 * time for time in _asked(story))])
    scale = WIDTH / extent
    stage = settled(Stage(story, moves, given, masses, where, times, radius, scale, 0.0, end))
    return _possible(cleared(stage), story), tuple(numbered(stage))


def _possible(attempt: Attempt, story: Story) -> Motion:
    """The motion of an attempt. Raises UnsupportedError where bodies are in the way.

    Where laws are altered, they pass through each other.
    """
    if attempt.in_the_way is not None and not story.problem.altered:
        raise _no(f"{attempt.in_the_way}, which the question does not tell")
    return attempt.motion


def _last(moves: Sequence[Move]) -> dict[str, Vector]:
    """The last velocity of every body."""
    return {name: velocity for move in moves for name, velocity in move.after.items()}


def _known(given: Given) -> list[Vector]:
    """Every place that a statement gives."""
    known = [*given.starts.values(), *given.points.values(), *given.origins.values()]
    known += [end for ends in given.segments.values() for end in ends]
    known += [c + d * r for c, r in given.circles.values() for d in (Vector(1, 1), Vector(-1, -1))]
    return known


def _without_doubles(moves: Sequence[Move]) -> list[Move]:
    """The events without an arrival at a wall that the impact with it follows at once."""
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
    usual = 0.0 if points else _AMONG_WALLS if walled else _RADIUS
    best: tuple[Attempt, Stage] | None = None
    for share in _SIZES:
        best = _clearest(story, moves, given, masses, usual * share) or best
        if best is None or best[0].in_the_way is None or points:
            break
    if best is None:
        raise _no("no places fit to all that is told")
    attempt, stage = best
    return _possible(attempt, story), tuple(numbered(stage))


def _clearest(
    story: Story,
    moves: Sequence[Move],
    given: Given,
    masses: Mapping[str, float],
    radius: float,
) -> tuple[Attempt, Stage] | None:
    """The best of several choices of lengths, for spheres of one size in the units on paper."""
    layout = flights.unknowns(story, moves, {}, {}, radius)
    fastest = max(length(v) for m in moves for v in (*m.before.values(), *m.after.values()))
    unit_length = (
        given.radius / radius if given.radius and radius else fastest * _SECONDS / _APPROACH
    )
    best: tuple[float, Attempt, Stage] | None = None
    for factors in _factors(len(layout.lengths)):
        x = flights.solve(layout, [_FLIGHT * factor for factor in factors], _SHORTEST)
        if x is None:
            continue
        where = {key: floats(p @ x + c) * unit_length for key, (p, c) in layout.where.items()}
        times = {number: float(row @ x) * unit_length for number, row in layout.times.items()}
        size, scale = radius * unit_length, 1 / unit_length
        stage = _in_time(Stage(story, moves, given, masses, where, times, size, scale, 0.0, 0.0))
        attempt = cleared(stage)
        cost = attempt.cost + 2 * sum(abs(math.log(factor)) for factor in factors)
        if best is None or cost < best[0]:
            best = cost, attempt, stage
        if best[0] < 1.0:
            break
    return None if best is None else best[1:]


def _factors(flights: int) -> Iterator[tuple[float, ...]]:
    """Lengths of the flights to be tried, as multiples of the usual one; the usual ones first."""
    if flights <= 3:
        every = itertools.product((1.0, 0.7, 1.4, 0.45, 2.2), repeat=flights)
        yield from sorted(every, key=lambda factors: sum(abs(math.log(x)) for x in factors))[
            :_TRIES
        ]
        return
    rng = random.Random(5)
    yield (1.0,) * flights
    for _ in range(_TRIES):
        yield tuple(rng.choice((0.45, 0.7, 1.0, 1.0, 1.4, 2.2)) for _ in range(flights))


def _in_time(stage: Stage) -> Stage:
    """The stage with a beginning and an end that show how the spheres come and go.

    The clock starts with the motion, or at the first impact where the language says so.
    """
    unit_length = 1 / stage.scale
    initial = {name: v for move in reversed(stage.moves) for name, v in move.before.items()}
    comes = max(map(length, initial.values()))
    goes = max(map(length, _last(stage.moves).values()))
    first, last = min(stage.times.values()), max(stage.times.values())
    lead = _APPROACH * unit_length / comes if comes else 0.0
    tail = _EXIT * unit_length / goes if goes else 0.0
    if not lead and not tail:  # at rest before, and in the end
        lead = tail = _REST * ((last - first) or _SECONDS)
    lead, tail = lead or _REST * tail, tail or _REST * lead
    lead, tail = min(lead, _SLOWER * tail), min(tail, _SLOWER * lead)
    zero = first if stage.story.implied else first - lead
    times = {number: time - zero for number, time in stage.times.items()}
    start, end = first - lead - zero, last + tail - zero
    if stage.story.implied:
        end = max([end, *(1.05 * time for time in _asked(stage.story))])
    return settled(replace(stage, times=times, start=start, end=end))


def _asked(story: Story) -> list[float]:
    """The times of which a statement speaks, as in ``at 2``."""
    asked = []
    for tree in trees(story.problem):
        for node in walk(tree):
            if isinstance(node, Quantity) and isinstance(node.stage, AtTime):
                try:
                    asked.append(float(story.evaluator(0).scalar(node.stage.time)))
                except (RestitutionError, ArithmeticError, LookupError, TypeError):
                    continue
    return asked


def _speaks_of_places(problem: Problem) -> bool:
    return any(
        isinstance(node, Quantity) and node.kind in PLACED
        for tree in trees(problem)
        for node in walk(tree)
    )
