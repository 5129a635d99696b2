"""Components at a wall in the sense in which they are positive: towards it, or away from it."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.saying import operand, say
from restitution.expression.tree import Expression, Negate, Quantity, has_quantity
from restitution.planning.writing.forms import tree_of
from restitution.render import layout as lay
from restitution.workings.naming.measured import worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.row_sides import turned_side


def is_turned(naming: Naming, links: Sequence[Link], sides: Sequence[lay.Layout]) -> bool:
    """Whether a row gives a rebound as a negative component towards a wall, or the reverse."""
    match links[0].left:
        case Quantity("along", (Quantity("velocity", _), axis)):
            turned = all(turned_side(side) is not None for side in sides[1:])
            if not turned and (len(sides) > 2 or _opposite(links) is None):
                return False
            sense = naming.at_the_wall(axis)
            if sense is not None:
                return sense != naming.at_the_wall(Negate(axis))
            event = naming.event_of_axis(axis)
            return event is not None and event.wall and not naming.bold.has_unit(event.number)
    return False


def turned_value(naming: Naming, links: Sequence[Link], side: lay.Layout) -> lay.Layout:
    """A side of a row that is turned, with the other sign."""
    opposite = _opposite(links)
    whole = None if opposite is None else naming.layout(opposite)
    return turned_side(side) or whole or lay.negative(side)


def _opposite(links: Sequence[Link]) -> Expression | None:
    """The only value of a row with the other sign, where it is negative: (2√3 − 3)u/2."""
    if len(links) != 1 or has_quantity(links[0].right):
        return None
    value = worth(links[0].right)
    return tree_of(-value) if value.is_negative else None


def away(naming: Naming, tree: Expression) -> lay.Layout:
    """What a component towards a wall is called in the other sense, or the reverse."""
    assert isinstance(tree, Quantity)
    vector, axis = tree.arguments
    of = naming.layout(vector)
    sense = naming.at_the_wall(Negate(axis))
    if sense is not None:
        name, wall = sense
        return operand(say(name, of=of, wall=wall))
    event = naming.event_of_axis(axis)
    assert event is not None
    return operand(say("derived.component-away", of=of, wall=event.bodies[1]))


__all__ = ["away", "is_turned", "turned_value"]
