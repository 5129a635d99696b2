"""The pictures of a solved problem with the letters of its working."""

from __future__ import annotations

from typing import TYPE_CHECKING

from restitution.errors import RestitutionError, require
from restitution.solving.worker import UNFORESEEN
from restitution.work import limited
from restitution.workings.route import explain

if TYPE_CHECKING:
    from collections.abc import Mapping

    from restitution.drawing import Drawings
    from restitution.expression.tree import Expression
    from restitution.solving.equations.solution import Solution


def draw(solution: Solution, part: str | None = None) -> Drawings:
    """The pictures of a solved problem, or of the part with that label.

    There is a plan of the paths where there are walls or places, and each impact before and after,
    to scale. Components and angles have the letters of the working. Raises KeyError for a part that
    is not there, and what kept it from being solved where nothing can be drawn.
    """
    from restitution.drawing import Drawings, scenes
    from restitution.solving.equations.solution import Solution

    require(solution, Solution, "draw")
    return Drawings(scenes(solution, part, letters_of_working(solution)))


def letters_of_working(
    solution: Solution, seconds: float | None = None
) -> Mapping[Expression, str] | None:
    """The letters that the working introduces, by the quantities for which they stand.

    None where there is no working, or none within so many ``seconds``.
    """
    try:
        with limited(seconds):
            return explain(solution, marks="none").letters
    except (RestitutionError, *UNFORESEEN):
        return None
