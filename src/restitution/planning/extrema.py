"""Greatest and least values."""

from __future__ import annotations

from typing import Any

from restitution.expression.tree import Expression
from restitution.planning.desk import NotPlannedError
from restitution.planning.order import Solver
from restitution.planning.scene import Scene
from restitution.solve.solution import Answer, ItemResult


def only_answer(result: ItemResult) -> Answer:
    """The one answer of an item. Raises NotPlannedError where there are several, or conditions."""
    if len(result.distinct) != 1 or result.distinct[0].condition:
        raise NotPlannedError("an answer in cases")
    return result.distinct[0]


def write_extremum(
    scene: Scene,
    solver: Solver,
    kind: str,
    asked: Expression,
    over: Expression,
    value: Any,
    where: Any,
    name: str,
    shown: bool = False,
) -> None:
    """Writes the lines of a greatest or least value."""
    raise NotPlannedError("Extremum")
