"""Expressions: numbers, letters and vectors as trees, read from text and written back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from restitution.expression.reading import read_expression as read_expression
    from restitution.expression.writing import write_expression as write_expression

__all__ = ["read_expression", "write_expression"]


def __getattr__(name: str) -> Any:
    # Reading loads lark: only when it is wanted.
    if name == "read_expression":
        from restitution.expression.reading import read_expression

        return read_expression
    if name == "write_expression":
        from restitution.expression.writing import write_expression

        return write_expression
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
