"""The tracks of a trial as a picture to scale: positions, straight lines, angles, wall or centres.

The picture shows paths of centres. So a wall is drawn through the place where the centre turned
back, one radius away from where it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import field

from restitution.counting import counted, listed
from restitution.drawing.bodies import name_of
from restitution.drawing.geometry import sides_towards
from restitution.drawing.scene import (
    WIDTH,
    Arc,
    Arrow,
    Disc,
    Dot,
    Label,
    Line,
    Scene,
    Shape,
    StraightWall,
)
from restitution.experiments.numbers import fixed
from restitution.experiments.records import Track
from restitution.experiments.results import FittedTrack, StraightLine
from restitution.experiments.whole import Experiment
from restitution.records import dataclass
from restitution.render.layout import Degrees, Layout, Letter, Number, Phrase, Relation, Words
from restitution.staging.geometry import direction, length
from restitution.vector import Vector

MOST_DOTS = 150
"""Positions of one body that are drawn; of more, some are left out evenly."""

_HEIGHT = 88.0  # the most of a picture, in millimetres
_MARGIN = 7.0
_DOT = 0.55
_WALL = 14.0  # the least to each side of an impact
_CENTRES = 9.0  # of the line of centres, beyond each centre
_ARC = 7.0
_STILL = 0.02  # of the largest speed of a trial; below it, a body has no direction to be seen
_NARROW = math.radians(2)  # an angle that is too narrow for an arc


def track_scenes(experiment: Experiment) -> tuple[Scene, ...]:
    """A picture of each trial, in the order of the trials; none where there are no tracks."""
    trials = dict.fromkeys(track.trial for track in experiment.tracks)
    return tuple(_scene(experiment, trial) for trial in trials)


def track_scene(experiment: Experiment, trial: str) -> Scene:
    """The picture of one trial. Raises KeyError where there is none of that name."""
    if not any(track.trial == trial for track in experiment.tracks):
        known = ", ".join(dict.fromkeys(track.trial for track in experiment.tracks)) or "none"
        raise KeyError(f"there is no trial {trial!r}; trials: {known}")
    return _scene(experiment, trial)


def _scene(experiment: Experiment, trial: str) -> Scene:
    fits = [track for track in experiment.tracks if track.trial == trial]
    tracks = [
        _Drawn(fit, track)
        for fit in fits
        for track in experiment.table.tracks
        if (track.trial, track.body) == (fit.trial, fit.body)
    ]
    unit = experiment.table.units
    speed = f"{unit.get('x', 'm')} {unit.get('t', 's')}⁻¹"
    drawing = _Drawing(tracks, _Scale.of(tracks), speed)
    drawing.everything()
    named = f" of trial {trial}" if trial else ""
    return drawing.scene(f"Tracks{named}")


@dataclass(frozen=True)
class _Drawn:
    """A fitted track beside what was measured."""

    fit: FittedTrack
    track: Track

    @property
    def impact(self) -> Vector:
        return Vector(self.fit.x, self.fit.y)

    @property
    def start(self) -> Vector:
        """Where the straight line before the impact begins."""
        return _at(self.fit.before, self.track.positions[0].t)

    @property
    def end(self) -> Vector:
        return _at(self.fit.after, self.track.positions[-1].t)

    @property
    def velocities(self) -> tuple[Vector, Vector]:
        before, after = self.fit.before, self.fit.after
        return (
            Vector(before.velocity_x, before.velocity_y),
            Vector(after.velocity_x, after.velocity_y),
        )

    @property
    def places(self) -> list[Vector]:
        positions = self.track.positions
        step = max(1, math.ceil(len(positions) / MOST_DOTS))
        return [Vector(position.x, position.y) for position in positions[::step]]


def _at(line: StraightLine, t: float) -> Vector:
    passed = t - line.t
    return Vector(line.x + line.velocity_x * passed, line.y + line.velocity_y * passed)


@dataclass(frozen=True)
class _Scale:
    """From the units of the table to millimetres on paper."""

    origin: Vector
    factor: float

    @classmethod
    def of(cls, tracks: Sequence[_Drawn]) -> _Scale:
        places = [
            p for track in tracks for p in (*track.places, track.impact, track.start, track.end)
        ]
        xs, ys = [p.x for p in places], [p.y for p in places]
        width, height = max(xs) - min(xs), max(ys) - min(ys)
        room = WIDTH - 2 * _MARGIN, _HEIGHT - 2 * _MARGIN
        fits = [r / size for r, size in zip(room, (width, height)) if size > 0]
        return cls(Vector(min(xs), min(ys)), min(fits, default=1.0))

    def on_paper(self, place: Vector) -> Vector:
        return (place - self.origin) * self.factor


@dataclass
class _Drawing:
    """Shapes and labels as they are put down."""

    tracks: Sequence[_Drawn]
    scale: _Scale
    speed_unit: str
    shapes: list[Shape] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)
    words: list[str] = field(default_factory=list)

    @property
    def pair(self) -> bool:
        """Whether two spheres meet, and not one body a wall."""
        return len(self.tracks) == 2

    def everything(self) -> None:
        """Draws all of it."""
        for track in self.tracks:
            if not self.pair:
                self._wall(track)
            self._path(track)
            self._angles(track)
        if self.pair:
            self._line_of_centres()

    def scene(self, title: str) -> Scene:
        xs, ys = zip(*(p for p in self._corners()))
        middle = (min(xs) + max(xs)) / 2
        half = max((max(xs) - min(xs)) / 2 + _MARGIN, WIDTH / 2)
        box = middle - half, min(ys) - _MARGIN / 2, middle + half, max(ys) + _MARGIN / 2
        names = listed([track.fit.body or "the body" for track in self.tracks])
        count = counted(sum(len(track.track.positions) for track in self.tracks), "position")
        description = f"{count} of {names}, to scale. " + " ".join(self.words)
        note = None if self.pair else Words(_NOTE)
        return Scene(title, description, box, tuple(self.shapes), tuple(self.labels), note=note)

    def _corners(self) -> Iterable[Vector]:
        for track in self.tracks:
            yield from map(
                self.scale.on_paper, (*track.places, track.impact, track.start, track.end)
            )
        for shape in self.shapes:
            if isinstance(shape, StraightWall | Line):
                yield from (shape.start, shape.end)

    # --- what the bodies meet -----------------------------------------------------------------

    def _wall(self, drawn: _Drawn) -> None:
        along, impact = _unit(drawn.fit.wall), self.scale.on_paper(drawn.impact)
        away = self.scale.on_paper(drawn.start) - impact
        if length(away) < 1e-9:
            away = self.scale.on_paper(drawn.end) - impact
        across = along.turned_left()
        far = across * (-1.0 if across.dot(away) > 0 else 1.0)
        reach = [(self.scale.on_paper(p) - impact).dot(along) for p in (drawn.start, drawn.end)]
        low, high = min(-_WALL, *reach), max(_WALL, *reach)
        self.shapes.append(StraightWall("", impact + along * low, impact + along * high, far))

    def _line_of_centres(self) -> None:
        one, other = (self.scale.on_paper(track.impact) for track in self.tracks)
        across = _unit(self.tracks[0].fit.wall).turned_left()
        apart = (other - one).dot(across)
        direction = across if apart > 0 else -across
        beyond = max(
            [_CENTRES, *(shape.radius + 2.0 for shape in self.shapes if isinstance(shape, Arc))]
        )
        self.shapes.append(
            Line(
                "line_of_centres", one - direction * beyond, one + direction * (abs(apart) + beyond)
            )
        )
        if abs(apart) > 2.0:
            for track in self.tracks:
                centre = self.scale.on_paper(track.impact)
                self.shapes.append(Disc(track.fit.body, centre, abs(apart) / 2, ghost=True))

    # --- paths and angles ---------------------------------------------------------------------

    def _path(self, drawn: _Drawn) -> None:
        start, impact, end = map(self.scale.on_paper, (drawn.start, drawn.impact, drawn.end))
        largest = self._largest_speed()
        for (a, b), velocity in zip(((start, impact), (impact, end)), drawn.velocities):
            if length(velocity) < _STILL * largest or length(b - a) < 0.5:
                continue
            if b is end:
                self.shapes.append(Arrow("path", a, b))
            else:
                middle = a + (b - a) * 0.55
                self.shapes += [Arrow("path", a, middle), Line("path", middle, b)]
            self._speed(a, b, velocity)
        self.shapes += [Dot("", self.scale.on_paper(place), _DOT) for place in drawn.places]
        if drawn.fit.body:
            at = start if length(start - impact) > length(end - impact) else end
            away = direction(at - impact)
            label = Label(name_of(drawn.fit.body), at, sides_towards(away), gap=1.4)
            self.labels.append(label)

    def _largest_speed(self) -> float:
        return max(length(v) for track in self.tracks for v in track.velocities) or 1.0

    def _speed(self, start: Vector, end: Vector, velocity: Vector) -> None:
        across = direction(end - start).turned_left()
        across = across if across.y > 0 else -across
        spots = [start + (end - start) * share for share in (0.5, 0.4, 0.62, 0.3, 0.75)]
        sides = (*sides_towards(across)[:3], *sides_towards(-across)[:3])
        text = Phrase((Number(f"{length(velocity):.3g}"), Words(self.speed_unit)))
        self.labels.append(Label(text, spots[0], sides, 1.0, 2.7, moves=tuple(spots[1:])))

    def _angles(self, drawn: _Drawn) -> None:
        """α before and β after: with the wall, or with the line of centres."""
        impact = self.scale.on_paper(drawn.impact)
        subscript = drawn.fit.body if self.pair and len(drawn.fit.body) == 1 else ""
        before, after = drawn.velocities
        least = _STILL * self._largest_speed()
        reference = _unit(drawn.fit.wall)
        reference = reference.turned_left() if self.pair else reference
        for name, words, course in (("alpha", "before", -before), ("beta", "after", after)):
            if length(course) < least:
                continue
            legs = length(
                self.scale.on_paper(drawn.start if name == "alpha" else drawn.end) - impact
            )
            # Both angles of a sphere may lie on one side of the line: then the second is wider.
            least_radius = _ARC + (2.4 if self.pair and name == "beta" else 0.0)
            letter = Letter(name, subscript)
            angle = self._angle(impact, reference, direction(course), letter, legs, least_radius)
            line = "line of centres" if self.pair else "wall"
            who = f"{drawn.fit.body} is" if drawn.fit.body else "the path is"
            self.words.append(f"{words.capitalize()}, {who} at {fixed(angle, 1)}° to the {line}.")

    def _angle(
        self,
        at: Vector,
        reference: Vector,
        course: Vector,
        letter: Layout,
        leg: float,
        least: float,
    ) -> float:
        """An arc between a line and a way from one of its points, with its label, in degrees."""
        line = reference if reference.dot(course) >= 0 else -reference
        between = math.atan2(line.cross(course), line.dot(course))
        degrees = math.degrees(abs(between))
        if abs(between) < _NARROW:
            return degrees
        radius = max(4.0, min(max(least, 1.5 / math.tan(abs(between) / 2)), 0.6 * leg))
        a, b = math.atan2(line.y, line.x), math.atan2(course.y, course.x)
        self.shapes.append(Arc("angle", at, radius, *((a, b) if between > 0 else (b, a))))
        middle = direction(line + course)
        spot, *moves = (at + middle * (radius + out) for out in (0.0, 1.2, 2.4))
        text = Relation((letter, Degrees(Number(fixed(degrees, 1)))), ("=",))
        sides = sides_towards(middle)
        self.labels.append(Label(text, spot, sides, 0.8, 2.8, moves=tuple(moves)))
        return degrees


_NOTE = "The path is that of the centre, and the wall is drawn where the centre turned back."


def _unit(degrees: float) -> Vector:
    angle = math.radians(degrees)
    return Vector(math.cos(angle), math.sin(angle))
