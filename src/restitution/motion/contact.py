"""Times of impact: when a sphere that moves uniformly comes to what it may strike.

Every function takes any kind of number and is told what needs a kind: how a root is taken, and
how far a position may be wrong by rounding (in m; nothing where numbers are exact). Times (s)
count from the moment at which the positions hold.

**Tolerance.** Positions and velocities are a few roundings away from what they should be, so
that a length is known to about TOLERANCE times the coordinates that it is made from. Nothing
else here is called small.

**Grazing.** A sphere that passes another body by tangent, or overlaps it by no more than
rounding where the paths are closest, does not strike it: no impulse would act.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, NamedTuple

from restitution.vector import Vector

TOLERANCE = 8 * sys.float_info.epsilon

Root = Callable[[Any], Any]


class Contact(NamedTuple):
    """An impact ahead: in how many seconds, and how far apart the bodies are until then (m)."""

    after: Any
    apart: Any


def meeting(apart: Vector, velocity: Vector, reach: Any, root: Root, rounding: Any) -> Any:
    """When two points come within ``reach`` of one another; None if they do not.

    ``apart`` (m) leads from the first to the second, ``velocity`` (m/s) is that of the second
    relative to the first. With a = v², b = r·v and c = r² − reach² the time solves
    a t² + 2 b t + c = 0. The earlier root is taken as c/(√disc − b), in which nothing cancels,
    as b < 0; and disc = b² − a c as a reach² − (r × v)², which is exact to rounding for bodies
    far apart, where b² and a c are large and nearly equal.
    """
    b = apart.dot(velocity)
    if b >= 0:
        return None
    a = velocity.dot(velocity)
    cross = apart.cross(velocity)
    sure = reach - rounding
    if sure <= 0 or cross * cross >= a * sure * sure:
        return None
    c = apart.dot(apart) - reach * reach
    if c <= 0:
        return Contact(c - c, c - c)
    return Contact(c / (root(a * reach * reach - cross * cross) - b), c / (2 * reach))


def leaving(apart: Vector, velocity: Vector, reach: Any, root: Root) -> Any:
    """When a point within a circle comes to it from inside; None if it is at rest.

    ``apart`` leads from the centre to the point, ``reach`` is the radius. The later root of the
    equation above; as −c/(b + √disc) where b > 0, so that nothing cancels. A point on the circle
    that moves along its tangent is there at once.
    """
    a = velocity.dot(velocity)
    if a == 0:
        return None
    b = apart.dot(velocity)
    c = apart.dot(apart) - reach * reach
    cross = apart.cross(velocity)
    disc = a * reach * reach - cross * cross
    if disc <= 0 or (c >= 0 and b >= 0):
        return Contact(a - a, a - a)
    if c >= 0:  # on the circle: a chord
        return Contact(-2 * b / a, disc / (2 * a * reach))
    size = root(disc)
    after = -c / (b + size) if b > 0 else (size - b) / a
    return Contact(after, max(-c / (2 * reach), disc / (2 * a * reach) if b < 0 else c - c))


class Face(NamedTuple):
    """A straight wall: a point of it, its direction of any length, and that length.

    ``bounded`` if it ends where the direction does.
    """

    start: Vector
    along: Vector
    length: Any
    bounded: bool

    def height(self, place: Vector) -> Any:
        """How far a point lies to the left of the wall, in m."""
        return self.along.cross(place - self.start) / self.length

    def reached(
        self, place: Vector, velocity: Vector, side: int, radius: Any, rounding: Any
    ) -> Any:
        """When a sphere on this side of the wall (1 left, −1 right) comes to it; or None."""
        speed = -side * self.along.cross(velocity) / self.length
        if speed <= 0:
            return None
        gap = side * self.height(place) - radius
        apart = gap if gap > 0 else gap - gap
        after = apart / speed
        if not self.bounded:
            return Contact(after, apart)
        foot = self.along.dot(place + velocity * after - self.start) / self.length
        beyond = max(-foot, foot - self.length)
        if beyond <= rounding:
            return Contact(after, apart)
        # So low it meets the end of the wall, unless that is only grazed: then it comes over it.
        back = self.along.dot(velocity) / self.length * (1 if foot < 0 else -1)
        if back <= 0 or apart - gap + speed * beyond / back > 2 * rounding:
            return None
        return Contact(after + beyond / back, apart - apart)
