"""Motions as plain data for the player: straight pieces, events, and what stands beside them.

The object, all numbers in SI units, vectors as pairs::

    {"title": text or null,
     "motions": [{"label", "drawn": at which values, "notes": [text], "start", "end",
                  "spheres": [{"name", "radius", "mass": number or null,
                               "pieces": [[start, end, x, y, velocity x, velocity y]],
                               "said": [exact velocity and speed, for each piece]}],
                  "walls": [{"name", "points", "closed"} or {"name", "centre", "radius"}],
                  "points": [{"name", "at"}],
                  "events": [{"kind": "impact", "time", "bodies", "wall", "place", "line", "e",
                              "impulse", "before": {name: velocity}, "after", "lost", "said"}
                             or {"kind": "blow", "time", "bodies", "place", "impulse", …}
                             or {"kind": "arrival", "time", "bodies", "place", "target", …}]}]}

``said`` holds exact values as text where the solution has short ones. The unit vector ``line``
points from the first body to the second, or into the wall.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from restitution.errors import TimeLimitError, UnsupportedError
from restitution.expression.tree import Expression, letters
from restitution.motion.pieces import Blow, Motion, Reached, Struck, WallCircle, WallLine
from restitution.vector import Vector
from restitution.work import limited

if TYPE_CHECKING:
    from restitution.motion.parts import PartMotion
    from restitution.motion.stage import Event
    from restitution.solving.equations.solution import Solution
    from restitution.staging.values import Chosen

Object = dict[str, Any]

# Longer texts (in characters) say less in a table than the number does.
_SHORT = 22
# What is said where the clock broke them off.
_NO_TIME = "Some exact values are left out: there was no time left for them."
# Steps of work for all exact values of a problem.
_STEPS = 100_000
# Values of more operations than this have no short form.
_LONG = 30


def of_solution(
    solution: Solution, part: str | None = None, seconds: float | None = None
) -> Object:
    """The motions of a solved problem, or of one part of it; ``seconds`` as for `of_motions`.

    Raises KeyError for a part that is not there, what kept the problem from being solved, and
    UnsupportedError with the reason where no motion can be shown.
    """
    from restitution.motion.parts import motions

    return of_motions(motions(solution, part), solution.problem.title, seconds)


def of_motions(
    motions: Sequence[PartMotion], title: str | None, seconds: float | None = None
) -> Object:
    """Motions of one problem, with exact values as far as they are short.

    Those that would take too many steps to work out are left out, as are, on a machine that is
    too slow, those that are not known after so many ``seconds``; a note says so.
    """
    contents = [
        _of_motion(motion, label) for motion, label in zip(motions, _labels(motions), strict=True)
    ]
    try:
        with limited(seconds, _STEPS) as own:
            for shown, motion in zip(contents, motions, strict=True):
                _add_exact(shown, motion)
        hurried = own.broken
    except (TimeLimitError, UnsupportedError):
        hurried = True
    if hurried:  # numbers are there for all of it
        for shown in contents:
            shown["notes"].append(_NO_TIME)
    return {"title": title, "motions": contents}


def is_hurried(data: Object) -> bool:
    """Whether the clock broke off the exact values of motions."""
    return any(_NO_TIME in motion["notes"] for motion in data["motions"])


def of_motion(motion: Motion, title: str | None = None) -> Object:
    """One motion, from wherever it comes."""
    events: list[Event] = [*motion.impacts, *motion.blows, *motion.reached]
    masses = {track.name: track.mass for track in motion.tracks}
    return {
        "title": title,
        "motions": [_motion(motion, sorted(events, key=lambda event: event.time), masses)],
    }


def _motion(motion: Motion, events: Sequence[Event], masses: Mapping[str, float]) -> Object:
    spheres = frozenset(track.name for track in motion.tracks)
    return {
        "label": "",
        "drawn": "",
        "notes": list(motion.notes),
        "start": _number(motion.start),
        "end": _number(motion.end),
        "spheres": [
            {
                "name": track.name,
                "radius": _number(track.radius),
                "mass": masses.get(track.name),
                "pieces": [
                    [*map(_number, (p.start, p.end, *p.place, *p.velocity))] for p in track.pieces
                ],
                "said": [None for _ in track.pieces],
            }
            for track in motion.tracks
        ],
        "walls": [_wall(wall) for wall in motion.walls],
        "points": [{"name": name, "at": _pair(at)} for name, at in motion.points.items()],
        "events": [_event(event, spheres, masses) for event in events],
    }


def _wall(wall: WallLine | WallCircle) -> Object:
    if isinstance(wall, WallCircle):
        return {
            "name": wall.name,
            "centre": _pair(wall.centre),
            "radius": _number(wall.radius),
        }
    return {
        "name": wall.name,
        "points": [_pair(point) for point in wall.points],
        "closed": wall.closed,
    }


def _event(event: Event, names: frozenset[str], masses: Mapping[str, float]) -> Object:
    common = {"time": _number(event.time), "place": _pair(event.place)}
    match event:
        case Struck():
            bodies = [event.first, event.second]
            wall = None if event.second in names else event.second
            spheres = bodies[:1] if wall is not None else bodies
            before = dict(zip(spheres, event.before, strict=False))
            after = dict(zip(spheres, event.after, strict=False))
            known = all(name in masses for name in spheres)
            lost = (
                sum(_energy(masses[n], before[n]) - _energy(masses[n], after[n]) for n in spheres)
                if known
                else None
            )
            return {
                "kind": "impact",
                **common,
                "bodies": spheres,
                "wall": wall,
                "line": _pair(event.line_of_centres),
                "e": _number(event.e),
                "impulse": _pair(event.impulse) if known else None,
                "before": {name: _pair(v) for name, v in before.items()},
                "after": {name: _pair(v) for name, v in after.items()},
                "lost": None if lost is None else _number(lost),
                "said": None,
            }
        case Blow():
            return {
                "kind": "blow",
                **common,
                "bodies": [event.body],
                "impulse": _pair(event.impulse),
                "before": {event.body: _pair(event.before)},
                "after": {event.body: _pair(event.after)},
            }
        case Reached():
            return {
                "kind": "arrival",
                **common,
                "bodies": [event.body],
                "target": event.target,
                "before": {event.body: _pair(event.velocity)},
                "after": {event.body: _pair(event.velocity)},
            }


def _energy(mass: float, velocity: Vector) -> float:
    return mass * float(velocity.dot(velocity)) / 2


def _number(x: float) -> float:
    """A number that is not longer than it is exact, and no negative zero."""
    return float(f"{float(x):.12g}") + 0.0


def _pair(v: Vector) -> list[float]:
    return [_number(v.x), _number(v.y)]


# --- what the solution says of it -----------------------------------------------------------------


def _of_motion(motion: PartMotion, label: str) -> Object:
    from restitution.drawing.describe import values_of
    from restitution.render.layout import Phrase
    from restitution.render.text import to_text

    content = _motion(motion.motion, [event for _, event in motion.events], motion.masses)
    content["label"] = label
    words = values_of(_chosen(motion))
    content["drawn"] = to_text(Phrase(words)) if words else ""
    return content


def _add_exact(content: Object, motion: PartMotion) -> None:
    """Puts exact values into the data of a motion, as far as they are short."""
    exact = _Exact(motion)
    for sphere, track in zip(content["spheres"], motion.motion.tracks, strict=True):
        sphere["said"] = [
            exact.velocity(track.name, stage) for stage in _stages(motion, track.name)
        ]
    for shown, (number, event) in zip(content["events"], motion.events, strict=True):
        if isinstance(event, Struck):
            shown["said"] = exact.impact(number, event)


def _chosen(motion: PartMotion) -> list[Chosen]:
    """The letters at whose values it is shown: those that change anything of it."""
    from restitution.staging.flights import given_places
    from restitution.staging.values import velocities

    numbers = motion.numbers
    spheres = [numbers.story.spheres[name] for name in motion.bodies]
    masses = {
        x for sphere in spheres if isinstance(sphere.mass, Expression) for x in letters(sphere.mass)
    }
    free = [
        chosen
        for chosen, moved in numbers.free
        if moved is None
        or chosen.name in masses
        or velocities(moved) != velocities(numbers.story)
        or given_places(moved) != given_places(numbers.story)
    ]
    return [*free, *(choice for choice in numbers.solved if choice not in free)]


def _stages(motion: PartMotion, body: str) -> list[int]:
    """After which event of the story each piece of a body's motion is."""
    own = [(event.time, number) for number, event in motion.events if body in _bodies(event)]
    track = next(track for track in motion.motion.tracks if track.name == body)
    # Pieces begin at the very numbers that are the times of events.
    return [
        next((n for time, n in reversed(own) if time <= piece.start), 0) for piece in track.pieces
    ]


def _bodies(event: Event) -> tuple[str, ...]:
    return (event.first, event.second) if isinstance(event, Struck) else (event.body,)


class _Exact:
    """Exact values as text, each worked out once; None where there is no short one."""

    def __init__(self, motion: PartMotion) -> None:
        self.part_motion = motion
        self.known: dict[tuple[str, int], Object | None] = {}

    def velocity(self, body: str, stage: int) -> Object | None:
        """Components along **i** and **j** and speed of a body after an event of the story."""
        if (body, stage) not in self.known:
            story = self._story()
            v = None if story is None else story.velocity(body, stage)
            self.known[body, stage] = v and {
                "x": self.text(lambda: v.x),
                "y": self.text(lambda: v.y),
                "speed": self.text(lambda: story.size(v)),
            }
        return self.known[body, stage]

    def impact(self, number: int, event: Struck) -> Object | None:
        """Components along the line of centres and across it, before and after, and e."""
        story = self._story()
        if story is None:
            return None
        happening = story.happenings[number - 1]
        c = happening.centres
        if c is None:
            return None
        try:
            centres = self.part_motion.numbers.vector(c)
        except (ArithmeticError, LookupError, TypeError):
            return None
        sense = 1 if centres.dot(event.line_of_centres) > 0 else -1

        def components(v: Vector) -> Object:
            return {
                "along": self.text(lambda: v.dot(c) * sense / story.size(c)),
                "across": self.text(lambda: c.cross(v) * sense / story.size(c)),
            }

        spheres = [name for name in happening.bodies if name in story.spheres]
        return {
            "e": self.text(lambda: happening.e),
            "before": {name: components(happening.before[name]) for name in spheres},
            "after": {name: components(happening.after[name]) for name in spheres},
        }

    def _story(self) -> Any:
        from restitution.errors import RestitutionError

        try:
            return self.part_motion.branch.story
        except (RestitutionError, ArithmeticError):
            return None

    def text(self, value: Any) -> str | None:
        """A value as people write it, if it is short."""
        from restitution.errors import RestitutionError
        from restitution.render.layout import from_sympy
        from restitution.render.text import to_text
        from restitution.solving.algebra.forms import plain

        try:
            value_ = value()
            if value_.count_ops() > _LONG:
                return None
            # Of either sign in general, perhaps; at the values that are shown it has to be right.
            exact = plain(
                value_, [self.part_motion.branch.sample, self.part_motion.numbers.numbers]
            )
        except (RestitutionError, ArithmeticError):
            return None
        if any(symbol.name.startswith("_") for symbol in exact.free_symbols):
            return None
        text = to_text(from_sympy(exact))
        return text if len(text) <= _SHORT else None


def _labels(motions: Sequence[PartMotion]) -> list[str]:
    """What tells the motions of a problem apart; nothing where there is one only."""
    labels = [list(_label(motion, motions)) for motion in motions]
    return [", ".join(words) for words in labels] if len(motions) > 1 else [""]


def _label(one: PartMotion, all_: Sequence[PartMotion]) -> Iterator[str]:
    from restitution.counting import listed

    named = [f"({label})" for label in one.labels if label is not None]
    if named:
        yield f"Part{'s' if len(named) > 1 else ''} {listed(named)}"
    elif any(label is not None for motion in all_ for label in motion.labels):
        yield "Before the parts"
    beside = [motion for motion in all_ if motion.labels[0] == one.labels[0]]
    solutions = {motion.branch.number for motion in beside}
    if len(solutions) > 1:
        yield f"solution {one.branch.number}"
    groups = [motion for motion in beside if motion.branch.number == one.branch.number]
    if len(groups) > 1:
        yield listed(one.bodies)
