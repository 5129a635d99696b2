"""Changes of a velocity, or of a momentum, that are given: as what it is after them."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.lines.derivation import Link
from restitution.expression.tree import Binary, Expression, Name, Quantity, has_quantity
from restitution.planning.writing.forms import product


def by_its_change(link: Link) -> Link:
    """``**v** − **u** = **x**`` as ``**v** = **u** + **x**``; any other link as it is."""
    for change, other in ((link.left, link.right), (link.right, link.left)):
        match change:
            case Binary("-", Quantity() as one, Quantity() as two) if link.sign == "=":
                pass
            case _:
                continue
        if has_quantity(other):
            continue
        right: Expression | None = None
        if _is_after(one, two):
            right = Binary("+", two, other)
        elif _is_after(two, one):
            one, right = two, Binary("-", one, other)
        if right is not None:
            return Link(one, "=", right, link.by)
    return link


def _is_after(late: Quantity, early: Quantity) -> bool:
    """Whether two are the velocities, or the momenta, of one body at different times."""
    match late, early:
        case (
            Quantity("velocity" | "momentum" as kind, (Name(body),), int(last)),
            Quantity(other, (Name(name),), int(first)),
        ):
            return kind == other and body == name and last > first
    return False


__all__ = ["by_its_change"]


def by_a_multiple(link: Link) -> Link:
    """A given ratio of speeds as one speed by the other: *speed of A = 2 × speed of B*."""
    match link:
        case Link(Binary("/", Quantity("speed") as above, Quantity("speed") as below), "=", ratio):
            if not has_quantity(ratio):
                return replace(link, left=above, right=product(ratio, below))
    return link
