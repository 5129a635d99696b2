"""The pictures of a solved problem in one file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from restitution.errors import StatementError

if TYPE_CHECKING:
    from restitution.drawing.scene import Scene
    from restitution.solving.equations.solution import Solution


def picture(solution: Solution, event: int | None = None) -> str:
    """All pictures of a solved problem in one SVG file, or that of one event.

    Raises StatementError where there is nothing to draw, and what kept the problem from being
    solved.
    """
    from restitution.drawing.svg import stacked

    return stacked(chosen(solution, event))


def chosen(solution: Solution, event: int | None = None) -> tuple[Scene, ...]:
    """All pictures of a solved problem, or that of one event; raises as ``picture`` does."""
    from restitution.drawing import scenes

    pictures = scenes(solution)
    if event is not None:
        numbers = [scene.event for scene in pictures if scene.event is not None]
        pictures = tuple(scene for scene in pictures if scene.event == event)
        if not pictures:
            known = f"pictured are {', '.join(map(str, numbers))}" if numbers else "none is"
            raise StatementError(f"there is no picture of event {event}: {known}")
    if not pictures:
        raise StatementError("there is nothing to draw: no impact is told")
    return pictures
