"""Which of two directions an angle is, of a velocity that is along a unit vector or against it."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Letter, Negate, Quantity, is_quantity
from restitution.render import layout as lay
from restitution.workings.naming.quantities import Naming


def along_its_unit(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """That a velocity is in the direction of **n**, or of −**n**, where its direction is told.

    None of other angles, and where no line has the component along a normal with a unit vector.
    """
    match line.relation:
        case Relation(((Link(Letter(name), "="), *_),)) if line.move.id == "inverse":
            meaning = naming.meanings.get(name)
        case _:
            return None
    if meaning is None or not is_quantity(meaning.quantity, "direction"):
        return None
    for ref in line.premises:
        own = derivation.line(ref)
        match own.relation if own is not None else None:
            case Relation(
                (
                    (
                        Link(
                            Quantity(
                                "along",
                                (
                                    Quantity("velocity") as velocity,
                                    Quantity("line_of_centres", (), int(number)),
                                ),
                            ),
                            "=",
                        ),
                        *_,
                    ),
                )
            ):
                unit = naming.bold.unit(number, "along")
                if unit is None:
                    return None
                right = own.relation.only[-1].right  # type: ignore[union-attr]
                along = lay.negative(unit) if isinstance(right, Negate) else unit
                return say("derived.along-unit", velocity=naming.layout(velocity), unit=along)
    return None


__all__ = ["along_its_unit"]
