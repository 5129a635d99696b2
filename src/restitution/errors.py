"""What can go wrong, as one small tree.

    RestitutionError
    ├── StatementError      the text cannot be read                      (kind "syntax")
    │   └── LettersError    what letters mean cannot be read             (kind "syntax")
    ├── MissingError        too little is known                          (kind "missing")
    ├── ContradictionError  the facts clash                              (kind "contradiction")
    ├── ImpossibleError     it cannot happen, for a physical reason      (kind "impossible")
    │   └── UnboundedError  it has no greatest, or no least, value       (kind "impossible")
    ├── UnsupportedError    well stated, but beyond what is solved here  (kind "unsupported")
    ├── CollapseError       impacts without end in a finite time         (kind "collapse")
    └── TimeLimitError      the solving was stopped                      (kind "time limit")

Each names the quantity, its value, the rule and, where it was said in a text, the place.
"""

from __future__ import annotations

from typing import Any, ClassVar, Self

from restitution.mending import Fix


class RestitutionError(Exception):
    """Any mistake in what was asked for; ``line`` and ``column`` count from 1, or are None.

    ``fixes`` are cures for it in the text, the likeliest first. ``because`` says why something has
    no value, for a reader who has the question in words; empty where the message does.
    """

    kind: ClassVar[str] = "error"
    fixes: tuple[Fix, ...] = ()
    because: str = ""

    def __init__(self, message: str, line: int | None = None, column: int | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.line = line
        self.column = column

    def __str__(self) -> str:
        if self.line is None:
            return self.message
        if self.column is None:
            return f"line {self.line}: {self.message}"
        return f"line {self.line}, column {self.column}: {self.message}"

    def __reduce__(
        self,
    ) -> tuple[type[RestitutionError], tuple[str, int | None, int | None], dict[str, Any]]:
        state = {name: value for name in ("fixes", "because") if (value := getattr(self, name))}
        return type(self), (self.message, self.line, self.column), state

    def at(self, line: int | None, column: int | None) -> Self:
        """The same error at a place of the text."""
        moved = type(self)(self.message, line, column)
        moved.fixes, moved.because = self.fixes, self.because
        return moved


class StatementError(RestitutionError):
    """A text that cannot be read, or that contradicts the rules of the language.

    ``others`` are further mistakes in the same text, ``hints`` other ways to see this one while a
    cure is sought.
    """

    kind = "syntax"
    others: tuple[StatementError, ...] = ()
    hints: tuple[StatementError, ...] = ()


class LettersError(StatementError):
    """A text of what letters mean that cannot be read: its lines are those of that text."""


class MissingError(RestitutionError):
    """An answer depends on something that was not said."""

    kind = "missing"


class ContradictionError(RestitutionError):
    """No values satisfy all that was said."""

    kind = "contradiction"


class ImpossibleError(RestitutionError):
    """What was told cannot happen."""

    kind = "impossible"


class UnboundedError(ImpossibleError):
    """What is asked for its greatest, or its least, value grows, or falls, without bound."""


class UnsupportedError(RestitutionError):
    """A question that is well stated but that cannot be solved here."""

    kind = "unsupported"


class CollapseError(RestitutionError):
    """A motion in which infinitely many impacts happen before some moment.

    ``run`` is the motion up to where it was given up; of a gas, the gas itself, as it was then.
    """

    kind = "collapse"
    run: Any = None


class TimeLimitError(RestitutionError):
    """Solving took longer than its limit."""

    kind = "time limit"


_MADE_BY = {
    "Problem": "restitution.parse(text) makes one",
    "Solution": "restitution.solve(problem) makes one",
    "str": "restitution.read(path) reads a file",
}


def require(value: object, kind: type | tuple[type, ...], taker: str) -> None:
    """Raise TypeError where a function, the ``taker``, was given something of another kind."""
    if not isinstance(value, kind):
        name = (kind[0] if isinstance(kind, tuple) else kind).__name__
        wanted = "text" if name == "str" else name
        given = type(value).__name__
        raise TypeError(f"{taker} takes a {wanted}, and not {given}: {_MADE_BY[name]}")
