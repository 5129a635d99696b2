"""What names of angles may mean: ``angle to the wall after``, ``deflection of A``."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Binary,
    Expression,
    Name,
    Quantity,
    Unit,
    is_quantity,
)
from restitution.practice.reading.energy_names import EnergyNames
from restitution.practice.reading.journeys import names_in
from restitution.problem import Impact, Kick


class AngleNames(EnergyNames):
    """The angles that a phrase may name: to lines and axes, between velocities, deflections."""

    def deflection(self, event: int) -> Iterator[Expression]:
        """Angles of deflection."""
        for body in self.bodies(event):
            yield Quantity("deflection", (Name(body),), self.after(event))
            if event > 1:
                ends = (
                    Quantity("velocity", (Name(body),), stage) for stage in (self.after(event), 0)
                )
                yield Quantity("angle", tuple(ends))

    def angle(self, event: int) -> Iterator[Expression]:
        """Angles to a wall, to the line of centres, to an axis, and between velocities."""
        features, line = self.features, self.line(event)
        spheres = [name for name in features.names if name in self.spheres]
        if len(spheres) > 1 and features.direction is None and features.axis is None:
            first, second = (self.of("velocity", sphere, event) for sphere in spheres[:2])
            yield Quantity("angle", (first, second))
        directed = features.axis is not None or features.direction is not None
        if features.between and not (spheres or directed) and len(self.bodies_met(event)) == 2:
            yield self.angle_between(event)
            if not any(map(_is_of_velocities, self.asked("angle"))):
                yield from self.inclinations(event)
            return
        if features.between and not (spheres or features.wall or features.direction):
            between = [tree for tree in self.asked("angle") if _is_of_velocities(tree)]
            if between and features.axis is None and not features.names:
                yield from between
                return
        if features.axis is not None and "centres" in (features.direction or ""):
            own = Quantity("angle", (line, features.axis))
            yield own
            yield Binary("-", STRAIGHT_ANGLE, own)
        if not spheres:
            own_angles = tuple(self.angles_of_wall(event))
            yield from own_angles
            if own_angles and features.lies and features.axis is not None:
                return
        for body in self.bodies(event):
            velocity = self.of("velocity", body, event)
            other = self.other_direction(event, line)
            value = Quantity("angle", (velocity, other))
            square = Binary("-", RIGHT_ANGLE, value)
            normal = (features.direction or "").startswith("perpendicular")
            to_wall = features.wall or not set(features.names).isdisjoint(self.walls)
            yield square if normal else value
            if features.axis is None and (normal or not to_wall):
                yield value if normal else square
            if features.axis is None:
                yield Binary("-", STRAIGHT_ANGLE, value)
            to_line = to_wall or features.direction or features.axis is not None
            if not (features.timed or to_line):  # that of before or after is to a line
                yield Quantity("deflection", (Name(body),), self.after(event))
        if not spheres and features.direction is None and len(self.bodies_met(event)) == 2:
            yield self.angle_between(event)
        if not spheres and features.axis is None and "centres" in (features.direction or ""):
            own = Quantity("angle", (line, Unit("i")))  # angle of the line of centres
            yield own
            yield Binary("-", RIGHT_ANGLE, own)
        if features.direction is None and not (directed or features.between):
            yield from self.angles_to_axes(event)

    def angles_to_axes(self, event: int) -> Iterator[Expression]:
        """The angles to i, or j, of a line of centres that slants, and of velocities beside it.

        At a wall that slants, and at a blow, they are those of the velocity of the body there.
        """
        met = self.bodies_met(event)
        match self.events[event - 1] if 0 < event <= len(self.events) else None:
            case Kick(body):
                lines = [self.of("velocity", body, event)]
            case Impact(along=along) if len(met) == 2 and not isinstance(along, Unit):
                named = [name for name in self.features.names if name in met]
                lines = [self.of("velocity", name, event) for name in named] or [self.line(event)]
            case Impact() if len(met) == 1 and self.is_beside_a_slant(event):
                lines = [self.of("velocity", met[0], event)]
            case _:
                return
        for line in lines:
            angle = Quantity("angle", (line, Unit("i")))
            yield angle
            yield Binary("-", RIGHT_ANGLE, angle)
            yield Binary("-", STRAIGHT_ANGLE, angle)

    def is_beside_a_slant(self, event: int) -> bool:
        """Whether a wall that is hit slants, and the angle is not said to be to a wall.

        Below a heading that speaks of this wall (``at BC:``) it is not to another one, along an
        axis.
        """
        wall, features = self.wall(event), self.features
        if features.wall or not set(features.names).isdisjoint(self.walls):
            return False
        axes = () if features.event is None else map(Name, self.walls)
        return self.is_slanting(wall) and all(map(self.is_slanting, axes))

    def inclinations(self, event: int) -> Iterator[Expression]:
        """The angles of velocities to the line of centres, measured either way."""
        for body in self.bodies(event):
            angle = Quantity("angle", (self.of("velocity", body, event), self.line(event)))
            yield angle
            yield Binary("-", STRAIGHT_ANGLE, angle)

    def angle_between(self, event: int) -> Expression:
        """The angle between the velocities of two spheres that meet."""
        first, second = (self.of("velocity", body, event) for body in self.bodies_met(event))
        return Quantity("angle", (first, second))

    def other_direction(self, event: int, line: Expression) -> Expression:
        """That to which an angle is measured."""
        if self.features.axis is not None:
            return self.features.axis
        named = self.features.direction or ""
        wall = self.wall(event)
        return line if "centres" in named or wall is None else wall

    def _is_of_another_wall(self, angle: Expression, event: int) -> bool:
        """Whether an angle is to another wall than that of which a heading speaks: ``at BC:``."""
        struck = self.met(event) & set(self.walls)
        own = names_in(angle) & set(self.walls)
        return self.features.event is not None and bool(struck and own) and not struck & own


def _is_of_velocities(angle: Expression) -> bool:
    """Whether an angle is one between two velocities."""
    return isinstance(angle, Quantity) and all(
        is_quantity(argument, "velocity") for argument in angle.arguments
    )
