"""What a contact tells of the place of a body: that of a sphere, on a wall, or at a circle."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Fact, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Quantity,
    is_zero,
)
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.straight_walls import equation_of_line
from restitution.render import layout as lay
from restitution.shapes import Circle
from restitution.workings.naming.measured import is_plain, vector_worth, with_unit, worth
from restitution.workings.naming.quantities import Naming


def at_contact(naming: Naming, fact: Fact) -> Sentence | None:
    """What a contact tells of the place of a body: how far it is from a centre, or on a wall.

    None of another fact.
    """
    kind, _, number = fact.id.partition(" ")
    event = naming.events.get(int(number)) if kind == "contact" else None
    match fact.relation.only[0]:
        case Link(Quantity("position"), "=", Binary("+" | "-", Quantity("position"), _)) if (
            event is not None
        ):
            one, other = event.bodies
            return say("touch.place", one=one, other=other)
        case Link(Quantity("position"), "=", Quantity("position")) if event is not None:
            one, other = event.bodies
            return say("touch.meet", one=one, other=other)
        case Link(Quantity("dot", (Binary("-", Quantity("position"), _), _)), "=", right) if (
            event is not None and naming.bodies.get(event.bodies[-1]) == "wall" and is_zero(right)
        ):
            body, wall = event.bodies
            line = _line_of(naming, fact.relation.only[0])
            if line is None:
                return say("contact.wall", body=body, wall=wall)
            return say("contact.wall-line", body=body, wall=wall, line=line)
        case Link(Quantity("dot"), "=", Binary("^", radius, _)) if event is not None:
            one, other = event.bodies
            length = naming.layout(tree_of(worth(radius)))
            if is_plain(length):
                length = with_unit(length, naming.unit(Quantity("distance", ())))
            if other not in naming.circles:
                return say("touch.apart", one=one, other=other, distance=length)
            both = _both_radii(naming, one, other, radius)
            if both is None:
                return say("circle.at", body=one, wall=other, radius=length)
            equation = lay.Relation((naming.layout(both), length), ("=",))
            return say("circle.centre-at", body=one, wall=other, radius=equation)
    return None


def _both_radii(naming: Naming, body: str, wall: str, distance: Expression) -> Expression | None:
    """How far the centre of a ball is from that of a circular wall; None without a radius."""
    shape = next(other.shape for other in naming.problem.walls if other.name == wall)
    radius = next(sphere.radius for sphere in naming.problem.spheres if sphere.name == body)
    if not isinstance(shape, Circle) or not isinstance(radius, Expression) or not worth(radius):
        return None
    sums = Binary("-", shape.radius, radius), Binary("+", shape.radius, radius)
    return next((radii for radii in sums if worth(radii) == worth(distance)), None)


def _line_of(naming: Naming, contact: Link) -> lay.Layout | None:
    """The equation of the line of a straight wall; None where x or y stands for something."""
    match contact.left:
        case Quantity("dot", (Binary("-", _, through), normal)):
            x, y = Letter("x"), Letter("y")
            if naming.has_taken(x.name) or naming.has_taken(y.name):
                return None
            across, place = vector_worth(normal), vector_worth(through)
            if across is None or place is None:
                return None
            line = equation_of_line(across, place, (x, y), by_slope=True)
            return naming.relation(Relation(((line,),)))
    return None
