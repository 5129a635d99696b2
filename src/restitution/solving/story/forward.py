"""The story of a problem, told forward: velocities, places and times after every event.

The same telling serves exact symbols and numbers of high precision, so what was solved in symbols
can be checked by telling it again in numbers. What the text leaves open and the motion needs (a
velocity before, a line of centres, a mass) becomes a *hidden* unknown; each comes with a phrase
that says what it is. While telling, the story collects

- equations, which hold whatever is asked (the law for an unknown line of centres, a sphere that
  does come to the point it is said to reach), and
- conditions, the physics that has to be possible (bodies approach before they collide, times are
  in order, coefficients lie in [0, 1]).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any, Protocol

from restitution import work
from restitution.errors import ImpossibleError
from restitution.expression.evaluate import Numeric, Symbolic, Value
from restitution.expression.tree import Apply, Expression, Name, Quantity, letters
from restitution.problem import Arrival, Event, Impact, Kick, Let, Part, Problem, Sphere, Unknown
from restitution.solving.story import bodies, places, quantities
from restitution.solving.story.conditions import Condition
from restitution.solving.story.happenings import Happening, Standing
from restitution.solving.story.impacts import impact
from restitution.solving.story.paths_to_walls import angle_to_be_acute
from restitution.solving.story.state import State, Unknowns
from restitution.vector import Vector


class Frames(Protocol):
    """Frames in which the impacts of a story are told, in place of the law's velocities alone."""

    def standing(self, story: Story, number: int, step: Impact) -> Mapping[str, Standing]:
        """The velocities, and places if known, by which the line of centres is worked out."""

    def resolved(self, story: Story, happening: Happening) -> Happening:
        """An impact with the velocities after it in components of one's own."""


class Story(State):
    """The events of ``problem`` up to and with ``part``, told in one arithmetic.

    With ``frames`` the velocities after each impact are told in components of these.
    Raises StatementError for what makes no sense and UnsupportedError for what is beyond this
    package; what is not known is no error here.
    """

    def __init__(
        self,
        problem: Problem,
        part: Part,
        arithmetic: Symbolic | Numeric,
        unknowns: Unknowns,
        lets: Mapping[str, tuple[Let, int]],
        frames: Frames | None = None,
        sloped_after: int | None = None,
    ) -> None:
        work.spend()
        known = getattr(unknowns, "values", {})
        of_statement = arithmetic.exact and known.keys() <= bodies.fixed_letters(problem, part)
        super().__init__(
            problem,
            arithmetic,
            unknowns,
            lets,
            of_statement=of_statement,
            in_frames=frames is not None,
            sloped_after=sloped_after,
        )
        self.frames = frames
        if of_statement:
            bodies.require_bodies(self)
        self._sizes()
        for sphere in problem.spheres:
            self._start(sphere)
        for step, _, _ in problem.timeline(part):
            if isinstance(step, Event):
                self.tell(step)

    def quantity(self, tree: Quantity, now: int) -> Value:
        """What a quantity of the language is worth after ``now`` events."""
        return quantities.quantity(self, tree, now)

    def _sizes(self) -> None:
        """Radii are positive, and all spheres have one. Raises ImpossibleError for two."""
        radii = {
            sphere.name: self.read(sphere.radius, f"the radius of {sphere.name}")
            for sphere in self.problem.spheres
            if sphere.radius is not None and not _in_lets(sphere.radius, self.lets)
        }
        for name, radius in radii.items():
            what = f"the radius of {name} must be positive"
            self.conditions.append(Condition(radius, ">", what, "sign"))
        for wall in self.problem.walls:
            if wall.radius is not None and not _in_lets(wall.radius, self.lets):
                what = f"the radius of {wall.name}"
                radius = self.read(wall.radius, what)
                self.conditions.append(Condition(radius, ">", f"{what} must be positive", "sign"))
        for (one, r), (other, s) in pairwise(radii.items()):
            if not self.field.is_zero(self.rational(r - s)):
                sizes = (f"{one} has {r}", f"{other} has {s}") if self.field.exact else ()
                listed_sizes = f": {', '.join(sizes)}" if sizes else ""
                raise ImpossibleError(f"all spheres have one radius{listed_sizes}")

    def _start(self, sphere: Sphere) -> None:
        name, track = sphere.name, self.tracks[sphere.name]
        if sphere.velocity is None:
            velocity = Vector(
                self.unknowns.hidden(f"u_{name}x", f"the initial velocity of {name}", "real"),
                self.unknowns.hidden(f"u_{name}y", f"the initial velocity of {name}", "real"),
            )
        else:
            velocity = self.read_vector(sphere.velocity, f"the velocity of {name}")
            if self.field.exact:
                velocity = self.neat(velocity)
            self._aim(sphere)
        track.velocities.append((0, velocity))
        if sphere.position is not None:
            where = self.read_vector(sphere.position, f"the place of {name}")
            track.places.append((0, where, self.field.zero))

    def _aim(self, sphere: Sphere) -> None:
        """An angle of a path to a wall is acute, but where it is told so that it cannot be: 2θ."""
        angle = angle_to_be_acute(self.problem, sphere)
        if angle is not None:
            reason = f"the path of {sphere.name} would make an angle of 90° or more with the wall"
            cosine = self.read(Apply("cos", angle), reason)
            self.conditions.append(Condition(cosine, ">", reason, "fact"))

    def tell(self, step: Event) -> None:
        """Goes on with the next event, by the values that tracks and walls have now."""
        number = len(self.happenings) + 1
        match step:
            case Impact():
                try:
                    happening = self._in_frames(number, step)
                except ImpossibleError as error:
                    raise self.fault or error from None
            case Kick():
                happening = self._kick(number, step)
            case Arrival():
                happening = self._arrival(number, step)
        self.happenings.append(happening)
        if self.frames is not None and isinstance(step, Impact):
            happening = self.frames.resolved(self, happening)
            self.happenings[-1] = happening
        for name, velocity in happening.after.items():
            if name in self.spheres:
                self.tracks[name].velocities.append((number, velocity))

    def _in_frames(self, number: int, step: Impact) -> Happening:
        """An impact by the values in which it stands in its frame, with the velocities as told."""
        if self.frames is None:
            return impact(self, number, step)
        standing = self.frames.standing(self, number, step)
        latest = {name: self.tracks[name].velocities[-1] for name in standing}
        for name, sphere in standing.items():
            track = self.tracks[name]
            track.velocities[-1] = (latest[name][0], sphere.velocity)
            if track.places and sphere.place is not None:
                track.places[-1] = (track.places[-1][0], *sphere.place)
        happening = impact(self, number, step)
        for name, velocity in latest.items():
            self.tracks[name].velocities[-1] = velocity
        before = {name: velocity for name, (_, velocity) in latest.items()}
        return replace(happening, before={**happening.before, **before})

    def _kick(self, number: int, step: Kick) -> Happening:
        name = step.body
        impulse = self.evaluator(number - 1).vector(step.impulse)
        before = self.velocity(name, number - 1)
        after = self.neat(before + impulse / self.mass(name))
        known = None if self.implied else self.place(name, number - 1)
        time = None
        if self.implied:
            self.tracks[name].places.append((number, None, None))
        if known is not None:
            n = self.tracks[name].places[-1][0]
            if n == 0 and self.field.is_zero(known[1]) and self.still(before):
                time = self.field.zero  # at rest until it is struck: the clock starts then
            else:
                time = self.unknowns.hidden(
                    f"t_{number}", f"the time of event {number}", "positive"
                )
            where = known[0] + before * (time - known[1])
            self.tracks[name].places.append((number, where, time))
        return Happening(number, step, {name: before}, {name: after}, impulse=impulse, time=time)

    def _arrival(self, number: int, step: Arrival) -> Happening:
        name = step.body
        velocity = self.velocity(name, number - 1)
        if isinstance(step.target, Name) and step.target.name in self.walls:
            time = places.time_to_wall(self, number, name, self.walls[step.target.name])
        else:
            point = self.evaluator(number - 1).vector(step.target)
            time = places.time_to_point(self, number, name, point, step)
        return Happening(number, step, {name: velocity}, {name: velocity}, time=time)


def _in_lets(value: Any, lets: Mapping[str, object]) -> bool:
    """Whether a property of a body depends on a name that depends on the motion."""
    return isinstance(value, Expression) and not letters(value).isdisjoint(lets)


def lets_of(problem: Problem, part: Part) -> dict[str, tuple[Let, int]]:
    """The names in force in a part, each with the number of events told before its line."""
    return {
        step.letter: (step, events)
        for step, events, _ in problem.timeline(part)
        if isinstance(step, Let)
    }


def lets_up_to(problem: Problem, part: Part) -> dict[str, tuple[Let, int]]:
    """The same with the names of earlier parts that this one does not use, nor takes anew."""
    last = problem.parts.index(part)
    named = {
        step.letter: (step, events)
        for step, events, own in problem.timeline()
        if isinstance(step, Let) and problem.parts.index(own) <= last
    }
    for step in part.steps:
        if isinstance(step, Unknown):
            named = {name: let for name, let in named.items() if name not in step.letters}
    return named | lets_of(problem, part)
