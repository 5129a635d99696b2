"""The pictures of a solved problem in one file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from restitution.errors import StatementError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from restitution.drawing.scene import Scene
    from restitution.expression.tree import Expression
    from restitution.solving.equations.solution import Solution


def picture(solution: Solution, event: int | None = None, seconds: float | None = None) -> str:
    """All pictures of a solved problem in one SVG file, or that of one event.

    Their letters are those of the working, if that is planned within so many ``seconds``.

    Raises StatementError where there is nothing to draw, and what kept the problem from being
    solved.
    """
    from restitution.drawing.svg import stacked
    from restitution.workings.pictures import letters_of_working

    return stacked(chosen(solution, event, letters_of_working(solution, seconds)))


def chosen(
    solution: Solution,
    event: int | None = None,
    letters: Mapping[Expression, str] | None = None,
) -> tuple[Scene, ...]:
    """All pictures of a solved problem, or that of one event; raises as ``picture`` does."""
    from restitution.drawing import scenes

    pictures = scenes(solution, letters=letters)
    if event is not None:
        numbers = [scene.event for scene in pictures if scene.event is not None]
        pictures = tuple(scene for scene in pictures if scene.event == event)
        if not pictures:
            known = f"pictured are {', '.join(map(str, numbers))}" if numbers else "none is"
            raise StatementError(f"there is no picture of event {event}: {known}")
    if not pictures:
        raise StatementError("there is nothing to draw: no impact is told")
    return pictures
