"""A velocity of one component, as a vector, where it is resolved at the next impact."""

from __future__ import annotations

from typing import Literal

from restitution.explaining.derivation import Derivation, Event, Line, Link, Meaning, Relation
from restitution.expression.tree import Expression, Letter, Quantity, Unit, is_zero
from restitution.render import layout as lay
from restitution.workings.naming import Naming


def vector_resolved(
    derivation: Derivation, naming: Naming, line: Line, event: Event
) -> lay.Layout | None:
    """The velocity that a line resolves before an impact, if it has one component only.

    It is that after an earlier impact, along the line of that or across it. None where both
    components stand, or where the velocity stands as a vector.
    """
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].left:
        case Quantity(_, (Quantity("velocity", _, int(stage)) as velocity, _)):
            pass
        case _:
            return None
    if not 0 < stage < event.number:
        return None
    parts: dict[Literal["along", "across"], Expression] = {}
    for ref in line.premises:
        own = derivation.line(ref) if isinstance(ref, int) else None
        match own.relation if own is not None else None:
            case Relation(((Link(left), *_) as links,)):
                quantity = _component_of(naming, left)
            case _:
                continue
        match quantity:
            case Quantity("along" | "across" as kind, (other, Quantity("line_of_centres", (), n))):
                if other == velocity and n == stage:
                    parts[kind] = links[-1].right
    whole = [(kind, value) for kind, value in parts.items() if not is_zero(value)]
    if len(parts) != 2 or len(whole) != 1:
        return None
    ((only, value),) = whole
    unit = _unit(derivation, naming, stage, only)
    if unit is None:
        return None
    sign, size = lay.split_sign(naming.layout(value))
    term = lay.product(size, unit)
    vector = lay.negative(term) if sign == "-" else term
    return lay.Relation((naming.layout(velocity), vector), ("=",))


def _component_of(naming: Naming, tree: Expression) -> Expression:
    """The component of which a line says the value, perhaps by its letter."""
    meaning = naming.meanings.get(tree.name) if isinstance(tree, Letter) else None
    if not isinstance(meaning, Meaning):
        return tree
    return tree if meaning.sense is not None else meaning.quantity


def _unit(derivation: Derivation, naming: Naming, number: int, kind: str) -> lay.Layout | None:
    """The unit vector along the line of an impact, or across it; None where it has no letter."""
    axis = derivation.fact(" ".join(("axis", str(number))))
    if axis is not None and axis.relation.options[0][-1].right == Unit("i"):
        return lay.Bold("i" if kind == "along" else "j")
    return naming.bold.unit(number, kind)


__all__ = ["vector_resolved"]
