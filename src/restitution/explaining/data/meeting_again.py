"""That two bodies that have met meet again: the one behind is the faster, or one comes back.

Two spheres that separate meet again only by way of a wall: the one ahead comes back from it, and
the gap between them closes then.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from restitution.explaining.data.arrangement import Arrangement
from restitution.explaining.data.one_line import is_direct, side_along, with_lines_of_centres
from restitution.explaining.lines.derivation import FLIPPED, Event, Link, Sign
from restitution.explaining.lines.trees import settled
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    is_zero,
)
from restitution.problem import Impact, Meets, Problem, once_a_problem
from restitution.shapes import Circle

_ZERO = Number(Fraction(0))
_ONE = Number(Fraction(1))


@dataclass(frozen=True)
class Return:
    """A sphere that comes back from a wall, if it moves towards it, to one that follows or waits.

    All move on one line. ``side`` is 1 where the wall lies in the direction of ``axis``, else −1;
    ``hit`` is the last event at the wall.
    """

    returning: str
    other: str
    wall: str
    hit: int
    e: Expression
    axis: Expression
    side: int

    def component(self, body: str, events: int) -> Quantity:
        """The component of a velocity after some events along the line."""
        return Quantity("along", (Quantity("velocity", (Name(body),), events), self.axis))

    def towards(self, events: int) -> Link:
        """That the sphere moves towards the wall."""
        return Link(self.component(self.returning, events), self.sign(">"), _ZERO)

    def closing(self, events: int, happens: bool) -> Link:
        """That the gap closes when the sphere comes back, or that it does not.

        It says all of spheres that separate: who separates, and is met on the way back, moved
        towards the wall.
        """
        own, other = (self.component(body, events) for body in (self.returning, self.other))
        return Link(self.gap(own, other), self.sign(">" if happens else "<="), _ZERO)

    def gap(self, own: Expression, other: Expression) -> Expression:
        """How fast the gap closes when a component has turned, as its size times *e*."""
        if is_zero(self.e):
            return other
        back = own if self.e == _ONE else Binary("*", self.e, own)
        return Binary("+", other, back)

    def sign(self, sign: Sign) -> Sign:
        """The sign of an inequality in the direction of the axis, from one towards the wall."""
        return sign if self.side > 0 else FLIPPED[sign]


def return_of(given: Arrangement, pair: tuple[str, str], events: int) -> Return | None:
    """Who of two spheres that have met may come back to the other from a wall.

    None where neither has a wall ahead on their line that it has struck before, or each of them has
    one, or where it is not plain that all move on that line.
    """
    met = [event for event in given.events[:events] if set(event.bodies) == set(pair)]
    if not met or met[-1].wall:
        return None
    returns = [own for body in pair if (own := _returning(given, met[-1], body, events))]
    return returns[0] if len(returns) == 1 else None


@once_a_problem
def _arrangement(problem: Problem) -> Arrangement:
    return Arrangement(with_lines_of_centres(Arrangement(problem)))


def returning(problem: Problem, relation: Meets, events: int) -> Return | None:
    """Who of two spheres of a statement may come back to the other from a wall."""
    return return_of(_arrangement(problem), _names(relation), events)


def catching_up(problem: Problem, relation: Meets, events: int) -> Link | None:
    """That the one behind is the faster of two that have met, or that it is not."""
    return _faster(_arrangement(problem), _names(relation), relation.happens, events)


def _returning(given: Arrangement, met: Event, body: str, events: int) -> Return | None:
    """How a sphere comes back from the wall that it struck last, to one that it has met.

    On one line no other is between it and that wall. Who has just struck it is on the way back.
    """
    own = [event for event in given.events[:events] if body in event.bodies]
    hits = [event for event in own if event.wall]
    step = given.problem.events[hits[-1].number - 1] if hits else None
    if not isinstance(step, Impact) or isinstance(given.walls[step.second].shape, Circle):
        return None
    normal = given.into_the_wall(step, hits[-1].number)
    if own[-1] is hits[-1] or normal is None or not is_direct(given, events + 1, normal):
        return None
    behind, ahead, axis = _order_of(given, met)
    (other,) = {behind, ahead} - {body}
    e = step.e if isinstance(step.e, Expression) else Letter("e")
    side = 1 if body == ahead else -1
    return Return(body, other, step.second, hits[-1].number, e, axis, side)


def _order_of(given: Arrangement, met: Event) -> tuple[str, str, Expression]:
    """Who is behind and who ahead of two bodies that have met, in the direction of their line.

    A line of centres leads from the first to the second; one that is told in the other direction
    keeps that.
    """
    step = given.problem.events[met.number - 1]
    behind, ahead = met.bodies
    along = step.along if isinstance(step, Impact) and not met.wall else None
    if isinstance(step, Impact) and along is not None and side_along(given, step, along) == -1:
        return ahead, behind, settled(along, given.events)
    return behind, ahead, Quantity("line_of_centres", (), met.number)


def separation(given: Arrangement, relation: Meets, events: int) -> Link | None:
    """Two that have met meet again if the one behind is the faster, or if one comes back.

    None where they have not met: who is ahead is not plain then. None too where one has hit a wall,
    and it is not plain how it would come back, or that they separate.
    """
    pair, happens = _names(relation), relation.happens
    own = [event for event in given.events[:events] if set(event.bodies) & set(pair)]
    separate = bool(own) and set(own[-1].bodies) == set(pair) and not own[-1].wall
    back = return_of(given, pair, events)
    if back is not None and separate:
        closing = back.closing(events, happens)
        return replace(closing, left=settled(closing.left, given.events))
    by_a_wall = back is not None or (separate and any(event.wall for event in own))
    return None if happens and by_a_wall else _faster(given, pair, happens, events)


def _faster(given: Arrangement, pair: tuple[str, str], happens: bool, events: int) -> Link | None:
    """That the one behind of two that have met is the faster, or moves to the wall."""
    met = [event for event in given.events[:events] if set(event.bodies) == set(pair)]
    if not met:
        return None
    behind, ahead, axis = _order_of(given, met[-1])
    components = (
        Quantity("along", (Quantity("velocity", (Name(body),), events), axis))
        for body in (behind, ahead)
    )
    left, right = (settled(component, given.events) for component in components)
    return Link(left, ">" if happens else "<=", _ZERO if met[-1].wall else right)


def _names(relation: Meets) -> tuple[str, str]:
    return relation.first.name, relation.second.name
