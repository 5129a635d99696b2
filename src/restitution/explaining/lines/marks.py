"""Marks as data: what an examiner would give for a line, and why."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Literal, get_args

from restitution.explaining.lines.sentences import SentenceId
from restitution.records import dataclass

MarkKind = Literal["M", "A", "B"]


@dataclass(frozen=True)
class Mark:
    """One mark: M for a method, A for accuracy, B for what stands by itself.

    ``dependent`` needs an earlier method mark, that of the lines ``on`` if they are named; ``star``
    goes to a printed result that is to be shown; ``ft`` follows through from an earlier slip.
    ``because`` is the id of a sentence.
    """

    kind: MarkKind
    number: int = 1
    dependent: bool = False
    star: bool = False
    ft: bool = False
    because: SentenceId = ""
    on: tuple[int, ...] = ()

    def __str__(self) -> str:
        before, star, ft = "D" * self.dependent, "*" * self.star, "ft" * self.ft
        return f"{before}{self.kind}{self.number}{star}{ft}"


Marks = tuple[Mark, ...]

Style = Literal["fm1", "m4", "caie", "none"]
"""Whose habits marks follow: Further Mechanics 1, the older M4, Cambridge; or no marks at all."""
STYLES: tuple[Style, ...] = get_args(Style)


def written(marks: Sequence[Mark]) -> str:
    """Marks as they stand beside a line: ``M1 A1ft``."""
    return " ".join(map(str, marks))


def reasoned(mark: Mark) -> Mark:
    """A mark with the id of the sentence that says what it is given for."""
    if mark.star:
        return replace(mark, because="mark.printed")
    if mark.ft:
        return replace(mark, because="mark.follow-through")
    if mark.dependent:
        return replace(mark, because="mark.dependent")
    return replace(mark, because=_BECAUSE[mark.kind])


_BECAUSE: Mapping[str, SentenceId] = {
    "M": "mark.method",
    "A": "mark.accuracy",
    "B": "mark.independent",
}
