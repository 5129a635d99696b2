"""Components in the templates of principles and of altered laws."""

from __future__ import annotations

AXIS = "line_of_centres(1)"


def along_line(body: str, stage: int) -> str:
    """The component along the line of centres, or into the wall."""
    return f"along(velocity({body}, {stage}), {AXIS})"


def across_line(body: str, stage: int) -> str:
    """The component across the line of centres, or parallel to the wall."""
    return f"across(velocity({body}, {stage}), {AXIS})"
