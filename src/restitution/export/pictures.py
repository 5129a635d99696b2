"""The pictures of a solved problem as files: SVG, and PNG or PDF made of it by typst."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from restitution.errors import StatementError, UnsupportedError
from restitution.render.typst import literal

if TYPE_CHECKING:
    from restitution.solve.solution import Solution

Form = Literal["svg", "png", "pdf"]

MISSING_TYPST = "{form} needs typst: pip install 'restitution[pdf]', or take SVG"
SHARPNESS = 300.0
"""Pixels to an inch, for print."""


def picture(solution: Solution, event: int | None = None) -> str:
    """All pictures of a solved problem in one SVG file, or that of one event.

    Raises StatementError where there is nothing to draw, and what kept the problem from being
    solved.
    """
    from restitution.draw import scenes
    from restitution.draw.svg import stacked

    found = scenes(solution)
    if event is not None:
        numbers = [scene.event for scene in found if scene.event is not None]
        found = tuple(scene for scene in found if scene.event == event)
        if not found:
            known = f"pictured are {', '.join(map(str, numbers))}" if numbers else "none is"
            raise StatementError(f"there is no picture of event {event}: {known}")
    if not found:
        raise StatementError("there is nothing to draw: no impact is told")
    return stacked(found)


def converted(svg: str, form: Literal["png", "pdf"]) -> bytes:
    """A picture as PNG on white or as PDF; the same bytes for the same picture.

    Raises UnsupportedError where typst is not installed.
    """
    try:
        import typst
    except ImportError:
        raise UnsupportedError(MISSING_TYPST.format(form=form.upper())) from None
    source = (
        "#set document(date: none)\n#set page(width: auto, height: auto, margin: 2mm)\n"
        f'#image(bytes({literal(svg)}), format: "svg")\n'
    )
    made = typst.compile(source.encode(), format=form, ppi=SHARPNESS, ignore_system_fonts=True)
    return bytes(made)
