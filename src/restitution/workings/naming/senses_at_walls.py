"""Components at a wall in the sense in which they are positive: towards it, or away from it."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact.symbols import symbols_in
from restitution.explaining.lines.derivation import Line, Link, Relation
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
        case Quantity("across", (Quantity("velocity", _), axis)):
            event = naming.event_of_axis(axis)
            if event is None or not event.wall or not naming.bold.is_read_off(event.number):
                return False
            return _all_are_negative(naming, links, sides)
        case Quantity("along", (Quantity("velocity", _), axis)):
            if not _all_are_negative(naming, links, sides):
                return False
            sense = naming.at_the_wall(axis)
            if sense is not None:
                return sense != naming.at_the_wall(Negate(axis))
            event = naming.event_of_axis(axis)
            return event is not None and event.wall and not naming.bold.has_unit(event.number)
    return False


def is_turned_along(naming: Naming, line: Line) -> bool:
    """Whether a component parallel to a wall is negative, where nothing is said of its sense.

    It is told by the angle of the path with the wall, in the sense in which the body goes.
    """
    match line.relation:
        case Relation(((Link(Quantity("across", (Quantity("velocity", _), axis))), *_),)):
            pass
        case _:
            return False
    event = naming.event_of_axis(axis)
    if event is None or not event.wall or not naming.bold.is_read_off(event.number):
        return False
    return all(
        isinstance(link.right, Negate) or _opposite(link) is not None for link in line.relation.only
    )


def turned_value(naming: Naming, links: Sequence[Link], side: lay.Layout) -> lay.Layout:
    """A side of a row that is turned, with the other sign."""
    opposite = next(
        (
            own
            for link in links
            if naming.layout(link.right) == side and (own := _opposite(link)) is not None
        ),
        None,
    )
    if opposite is None and len(links) == 1:
        opposite = _opposite(links[0])
    whole = None if opposite is None else naming.layout(opposite)
    return turned_side(side) or whole or lay.negative(side)


def _all_are_negative(naming: Naming, links: Sequence[Link], sides: Sequence[lay.Layout]) -> bool:
    """Whether each value of a row has the other sign, or is a number of letters that has it."""
    if all(turned_side(side) is not None for side in sides[1:]):
        return True
    if len(sides) == 2 and len(links) == 1:
        return _opposite(links[0]) is not None
    negative_values = [naming.layout(link.right) for link in links if _opposite(link) is not None]
    return all(turned_side(side) is not None or side in negative_values for side in sides[1:])


def _opposite(link: Link) -> Expression | None:
    """A value with the other sign, where it is negative: (2√3 − 3)u/2."""
    if has_quantity(link.right):
        return None
    value = worth(link.right)
    if value.is_number:
        return tree_of(-value) if value.is_negative else None
    factor, rest = value.as_independent(*symbols_in(value), as_Add=False)
    return tree_of(-value) if factor.is_negative and not rest.has(sp.Add) else None


def away(naming: Naming, tree: Expression) -> lay.Layout:
    """What a component towards a wall is called in the other sense, or the reverse."""
    assert isinstance(tree, Quantity)
    if tree.kind == "across":
        return naming.layout(tree)
    vector, axis = tree.arguments
    of = naming.layout(vector)
    sense = naming.at_the_wall(Negate(axis))
    if sense is not None:
        name, wall = sense
        return operand(say(name, of=of, wall=wall))
    event = naming.event_of_axis(axis)
    assert event is not None
    return operand(say("derived.component-away", of=of, wall=event.bodies[1]))


__all__ = ["away", "is_turned", "is_turned_along", "turned_value"]
