"""The moment of which a phrase speaks: its event, the bodies that meet there, before or after."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Binary,
    Expression,
    Name,
    Quantity,
    Stage,
    Unit,
    is_quantity,
    letters,
)
from restitution.practice.reading.features import Features
from restitution.problem import Compare, Find, Impact, Kick, Problem, Range, Show, Value


class Moments:
    """The events, bodies and stages of which a phrase may speak, and what the question asks."""

    def __init__(self, features: Features, problem: Problem, until: int | None = None) -> None:
        self.features, self.problem, self.until = features, problem, until
        self.events = problem.events
        self.spheres = tuple(sphere.name for sphere in problem.spheres)
        self.walls = tuple(wall.name for wall in problem.walls)

    def asked(self, kind: str) -> Iterator[Expression]:
        """The quantities of a kind for which the question asks."""
        for tree in self.values_asked():
            if is_quantity(tree, kind):
                yield tree

    def values_asked(self) -> Iterator[Expression]:
        """The values for which the question asks, and those of which it prints a relation."""
        for _, step in self.problem.steps():
            for item in step.items if isinstance(step, Find) else ():
                if isinstance(item, Value | Range):
                    yield item.expression
            if isinstance(step, Show) and isinstance(step.relation, Compare):
                yield from step.relation.operands

    def numbers(self) -> list[int]:
        """The events of which the phrase may speak, the latest first."""
        kicks = [n for n, event in enumerate(self.events, 1) if isinstance(event, Kick)]
        if self.features.blow and kicks:
            return list(reversed(kicks))
        impacts = [n for n, event in enumerate(self.events, 1) if isinstance(event, Impact)]
        if self.features.event is not None and self.features.event <= len(impacts):
            return [impacts[self.features.event - 1]]
        named = [n for n in impacts if self.met(n) and self.met(n) <= set(self.features.names)]
        if named and len(named) < len(impacts):
            return named
        bodies = {name for name in self.features.names if name in self.spheres}
        if self.features.at_wall:
            known = [n for n in impacts if self.met(n) & set(self.walls)]
            struck = [n for n in known if not bodies or bodies & self.met(n)]
            if struck:
                return list(reversed(struck))
        walled = [n for n in impacts if self.met(n) & set(self.walls) & set(self.features.names)]
        if walled:
            return list(reversed(walled))
        known = [n for n in impacts if self.until is None or n <= self.until]
        known = known or [n for n in kicks if n == self.until] or impacts
        taking_part = [n for n in known if not bodies or bodies & self.met(n)] or known
        return list(reversed(taking_part)) or [max(len(self.events), 1)]

    def met(self, number: int) -> set[str]:
        """The two that meet in an event."""
        event = self.events[number - 1]
        return {event.first, event.second} if isinstance(event, Impact) else set()

    def blows(self) -> Iterator[Expression]:
        """The impulses that bodies receive, and the components of those that are to be found."""
        for number, event in enumerate(self.events, 1):
            if isinstance(event, Kick):
                blow = Quantity("impulse", (Name(event.body),), self.after(number))
                yield blow
                for axis in (Unit("i"), Unit("j")) if letters(event.impulse) else ():
                    yield Quantity("along", (blow, axis))

    def bodies(self, event: int) -> list[str]:
        """The spheres of which the phrase may speak."""
        named = [name for name in self.features.names if name in self.spheres]
        if self.features.target in named and len(named) > 1:
            named.remove(self.features.target or "")
        if named:
            return named[:1]
        match self.events[event - 1] if 0 < event <= len(self.events) else None:
            case Impact(first, second):
                return [body for body in (first, second) if body in self.spheres]
            case Kick(body):
                return [body]
        return list(self.spheres)

    def stage(self, event: int) -> Stage:
        """The stage of which the phrase speaks: after the event unless it says *before*."""
        if self.features.stage == "before":
            return event - 1
        return None if event == len(self.events) else event

    def before(self, event: int) -> Stage:
        """The stage just before an event."""
        return event - 1

    def of(self, kind: str, body: str, event: int) -> Expression:
        """A quantity of a body at the stage."""
        return Quantity(kind, (Name(body),), self.stage(event))

    def line(self, event: int) -> Expression:
        """The line of centres of an event."""
        return Quantity("line_of_centres", (), None if event == len(self.events) else event)

    def wall(self, event: int) -> Expression | None:
        """The wall that is named, or that is struck."""
        named = [name for name in self.features.names if name in self.walls]
        if named:
            return Name(named[0])
        struck = self.met(event) & set(self.walls)
        return Name(struck.pop()) if struck else None

    def angles_of_wall(self, event: int) -> Iterator[Expression]:
        """The angles of a wall to an axis that is named: ``angle of W with i``.

        Those of a wall that slants are to either axis where none is: ``angle of the wall``.
        """
        features, wall = self.features, self.wall(event)
        named = features.wall or not set(features.names).isdisjoint(self.walls)
        if not named or wall is None:
            return
        axes = [features.axis] if isinstance(features.axis, Unit) else []
        if features.lies and features.axis is None and not features.timed:
            axes = [Unit("i"), Unit("j")] if self.is_slanting(wall) else []
        for axis in axes:
            own = Quantity("angle", (wall, axis))
            yield own
            yield Binary("-", STRAIGHT_ANGLE, own)

    def is_slanting(self, wall: Expression | None) -> bool:
        """Whether something is a wall that is not along an axis."""
        beside = {Name(body.name) for body in self.problem.walls if isinstance(body.along, Unit)}
        return wall is not None and wall not in beside

    def after(self, event: int) -> Stage:
        """The stage just after an event."""
        return None if event == len(self.events) else event

    def bodies_met(self, event: int) -> list[str]:
        """The spheres that meet in an event, in its order."""
        if not 0 < event <= len(self.events):
            return []
        impact = self.events[event - 1]
        if not isinstance(impact, Impact):
            return []
        return [body for body in (impact.first, impact.second) if body in self.spheres]
