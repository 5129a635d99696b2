"""What is asked or given, by its definition, with the components put in that are known."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from restitution.expression.tree import (
    Quantity,
)
from restitution.planning.formulas.angle_formulas import (
    angle_formula,
    deflection_formula,
    direction_formula,
    product_formula,
)
from restitution.planning.formulas.components_of_impulses import any_component_formula
from restitution.planning.formulas.definitions import Formula, formula_of_line
from restitution.planning.formulas.energy_formulas import (
    energy_formula,
    energy_lost_formula,
    total_energy_lost_formula,
)
from restitution.planning.formulas.impulse_formulas import impulse_formula
from restitution.planning.formulas.momentum_formulas import momentum_formula
from restitution.planning.formulas.velocity_formulas import (
    speed_formula,
    velocity_formula,
)
from restitution.planning.journeys import journeys
from restitution.planning.writing import place_trees
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene


def formula(scene: Scene, quantity: Quantity) -> Formula:
    """The definition by which a quantity is worked out. Raises NotPlannedError without one."""
    if place_trees.serves(quantity):
        return _of_journey(scene, quantity)
    own = _FORMULAS.get(quantity.kind)
    if own is None:
        raise NotPlannedError(f"no definition of {quantity.kind}")
    return own(scene, quantity)


def _of_journey(scene: Scene, quantity: Quantity) -> Formula:
    """A time, a place or a distance, as the line has it that is written for it."""
    return formula_of_line(scene, quantity, *journeys.write(scene, quantity))


_FORMULAS: Mapping[str, Callable[[Scene, Quantity], Formula]] = {
    "velocity": velocity_formula,
    "speed": speed_formula,
    "along": any_component_formula,
    "across": any_component_formula,
    "angle": angle_formula,
    "direction": direction_formula,
    "deflection": deflection_formula,
    "impulse": impulse_formula,
    "energy": energy_formula,
    "energy_lost": energy_lost_formula,
    "total_energy_lost": total_energy_lost_formula,
    "momentum": momentum_formula,
    "dot": product_formula,
}
