"""Statements: the text of a question to a Problem, and a Problem to its text."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from restitution.language.checking import check as check
    from restitution.language.reading import parse as parse
    from restitution.language.reading import read as read
    from restitution.language.writing import to_statement as to_statement

__all__ = ["check", "parse", "read", "to_statement"]


def __getattr__(name: str) -> Any:
    # Reading loads lark: only when it is wanted.
    if name in ("parse", "read"):
        from restitution.language import reading

        return getattr(reading, name)
    if name == "check":
        from restitution.language.checking import check

        return check
    if name == "to_statement":
        from restitution.language.writing import to_statement

        return to_statement
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
