"""The units of answers: where the numbers of a statement give the scale of what is asked."""

from __future__ import annotations

from restitution.expression.quantities import dimension_of
from restitution.language.measuring import dimensions_of_letters
from restitution.problem import Value
from restitution.solving.equations.solution import ItemResult, Solution
from restitution.wording.units import style_of

_WITH_UNIT = frozenset(("value", "vector", "point"))


class Units:
    """The units in which a solution's answers are.

    A letter stands for a quantity with its unit: so there is none where letters alone say how large
    things are, and none behind an angle, a ratio or a percentage.
    """

    def __init__(self, solution: Solution) -> None:
        self._style = style_of(solution.problem)
        self._letters = dimensions_of_letters(solution.problem)

    def of(self, item: ItemResult) -> str:
        """The unit of an item's values, such as ``m s⁻¹`` with blanks that hold; or nothing."""
        asked = item.item
        if item.kind not in _WITH_UNIT or not isinstance(asked, Value) or asked.percentage:
            return ""
        return self._style.unit(dimension_of(asked.expression, self._letters)).lstrip()
