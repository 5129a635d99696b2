"""Values that the statement gives: they are quoted, and not worked out."""

from __future__ import annotations

from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import Expression, Quantity
from restitution.planning.writing.desk import Source, is_value_of, together
from restitution.planning.writing.scene import Scene


def given_energy(scene: Scene, quantity: Expression) -> Source | None:
    """The value of an energy, or of a loss, as it is given; None of what no fact says alone."""
    if not isinstance(quantity, Quantity) or quantity.kind not in ENERGIES:
        return None
    return given_value(scene, quantity)


def given_value(scene: Scene, quantity: Quantity) -> Source | None:
    """The value of a quantity as it is given; None where no fact says it, or it is open."""
    for equation in scene.given:
        if is_value_of(equation.link, quantity):
            value, more = scene.put(scene.scalar(equation.link.right))
            return None if scene.unknown(value) else Source(value, together(equation.refs, more))
    return None


__all__ = ["given_energy", "given_value"]
