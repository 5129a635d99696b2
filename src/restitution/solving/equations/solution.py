"""A solved problem as a value: for every item its answers, and all that explains them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import Any, Literal, TypeAlias

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import Enclosed
from restitution.oracle import Oracle, Proof
from restitution.oracle.points import Value as NumberOfPoint
from restitution.oracle.roles import Role
from restitution.problem import Extremum, Part, Problem, Range, Show, Value
from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.solving.story.forward import Story
from restitution.solving.story.state import Unknowns

ItemKind = Literal["value", "vector", "point", "direction", "range", "extremum", "show"]


Exact: TypeAlias = sp.Expr | sp.Set | tuple[sp.Expr, ...]
"""What an answer is: a number, a range, or a pair."""


@dataclass(frozen=True)
class Answer:
    """One admissible answer to an item.

    ``value`` is a SymPy expression (angles in radians), a pair of them for a vector, a point or
    a direction, or a SymPy set for a range. ``exact`` is the same as text to be read again,
    ``decimal`` in full double precision or None where letters are left, ``display`` what people
    see. ``where`` tells at which values of the letters an extremum is reached; ``reached`` is
    False where it is only approached. ``layout`` is ``display`` as mathematics for a range or an
    extremum, or for one that holds under a condition; other values are set by
    `restitution.render.layout.display` and its kin. ``condition`` lists relations, as ``exact`` is
    written: the answer holds for the letters that satisfy them, and for no others.
    """

    solution: int
    value: Exact
    exact: str | tuple[str, str]
    decimal: float | tuple[float, float] | None
    display: str
    where: Mapping[str, str] | None = None
    reached: bool = True
    angle: bool = False
    layout: Layout | None = None
    condition: tuple[str, ...] = ()
    condition_layout: Layout | None = None

    @property
    def letters(self) -> frozenset[str]:
        """The letters in the value."""
        values = self.value if isinstance(self.value, tuple) else (self.value,)
        return symbol_names(*values)


@dataclass(frozen=True)
class Rejected:
    """A root that is not an answer, and the physical reason."""

    value: Exact
    exact: str | tuple[str, str]
    display: str
    reason: str
    angle: bool = False


@dataclass(frozen=True)
class ItemResult:
    """The result of one item of ``find``, or of one ``show``.

    ``holds`` is None for a claim that is not decided, as for all that is no claim. ``proof`` tells
    what a claim rests on, ``trials`` at how many points it was tried.
    """

    item: Value | Range | Extremum | Show
    line: int | None
    text: str
    kind: ItemKind
    answers: tuple[Answer, ...] = ()
    holds: bool | None = None
    counterexample: Mapping[str, str] | None = None
    rejected: tuple[Rejected, ...] = ()
    error: RestitutionError | None = None
    proof: Proof | None = None
    trials: int = 0

    @property
    def undecided(self) -> bool:
        """Whether this is a claim that is neither proved nor refuted."""
        return self.kind == "show" and self.error is None and self.holds is None

    @property
    def refuted(self) -> bool:
        """Whether this is a claim that is not true."""
        return self.kind == "show" and self.holds is False

    @property
    def not_proved(self) -> str:
        """The warning of a range or an extremum that was sought, and not proved."""
        return f"{self.text} was sought at some values of the letters, not proved"

    @property
    def distinct(self) -> tuple[Answer, ...]:
        """The answers without those that repeat an earlier one's value, as people want them.

        ``answers`` has one for every solution of the part, so that items can be put together.
        """
        first: dict[tuple[str | tuple[str, str], tuple[str, ...]], Answer] = {}
        for answer in self.answers:
            first.setdefault((answer.exact, answer.condition), answer)
        return tuple(first.values())

    @property
    def exact(self) -> Exact:
        """The exact value of the first answer: a SymPy expression, a pair, or a set."""
        return self._first().value

    @property
    def decimal(self) -> float | tuple[float, float] | None:
        """The first answer in double precision, or None where letters are left."""
        return self._first().decimal

    @property
    def display(self) -> str:
        """The first answer as people see it."""
        return self._first().display

    def _first(self) -> Answer:
        if self.error is not None:
            raise self.error
        if not self.answers:
            outcome = "not decided" if self.undecided else f"shown to be {self.holds}"
            raise LookupError(f"{self.text!r} has no value: it is {outcome}")
        return self.answers[0]


@dataclass(frozen=True)
class Branch:
    """One admissible set of values for all that was unknown.

    ``values`` maps letters and hidden unknowns, by name, to exact values; ``letters`` gives
    them to a telling of the story; ``sample`` gives every letter and hidden unknown a number that
    satisfies all facts (the letters left free at a representative value); ``numbers`` is the
    story told with these, in high precision. ``objection`` says why other numbers are
    impossible, as (reason, kind), or None where they would do as well. ``exact`` is the story told
    with ``letters``, where finding them took one. ``oracle`` decides what holds for all letters
    that the solution admits; None where these are not known as formulas.
    """

    number: int
    values: Mapping[str, sp.Expr]
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]]
    letters: Unknowns
    sample: Mapping[str, Enclosed]
    numbers: Story
    tell: Callable[[Any], Story] = field(compare=False, repr=False)
    objection: Callable[[Mapping[str, Enclosed | NumberOfPoint]], tuple[str, str] | None] = field(
        compare=False, repr=False
    )
    oracle: Oracle | None = field(default=None, compare=False, repr=False)
    exact: Story | None = field(default=None, compare=False, repr=False)

    @cached_property
    def story(self) -> Story:
        """The story with these values put in, exactly; told when it is first wanted."""
        return self.exact or self.tell(self.letters)


@dataclass(frozen=True)
class RejectedBranch:
    """Values that satisfy the equations but not the physics."""

    values: Mapping[str, sp.Expr]
    reason: str
    kind: str


@dataclass(frozen=True)
class PartSolution:
    """One part solved.

    ``beyond`` is all that its equations give, where there is no solution because each time a
    letter is out of its range. ``before`` is the part up to an event that cannot happen, by whose
    solutions the items above that event are answered.
    """

    part: Part
    items: tuple[ItemResult, ...]
    branches: tuple[Branch, ...]
    rejected: tuple[RejectedBranch, ...]
    roles: Mapping[str, Role]
    open_story: Story | None = None
    error: RestitutionError | None = None
    beyond: tuple[Branch, ...] = ()
    before: PartSolution | None = None

    def __getitem__(self, text: str) -> ItemResult:
        for item in reversed(self.items):
            if _plain(item.text) == _plain(text):
                return item
        known = ", ".join(repr(item.text) for item in self.items) or "nothing"
        raise KeyError(f"{text!r} is not asked in this part; asked: {known}")


@dataclass(frozen=True)
class Solution:
    """A solved problem. ``solution["speed(P)"]`` is the last item with that text.

    ``mistake`` is the id of the mistake in whose altered world it is solved, None in the true one.
    """

    problem: Problem
    parts: Mapping[str | None, PartSolution]
    warnings: tuple[str, ...] = ()
    error: RestitutionError | None = field(default=None)
    mistake: str | None = None

    def chosen(self, label: str | None) -> list[PartSolution]:
        """The part with a label, or all where it is None. Raises KeyError where there is none."""
        if label is not None and label not in self.parts:
            known = ", ".join(map(str, self.parts))
            raise KeyError(f"there is no part {label!r}; parts: {known}")
        return [part for own, part in self.parts.items() if label in (None, own)]

    def items(self) -> Iterator[tuple[PartSolution, ItemResult]]:
        """Every item with its part, in the order asked."""
        for part in self.parts.values():
            for item in part.items:
                yield part, item

    def refutations(self) -> Iterator[tuple[str, int | None]]:
        """What is to be shown and is not true: said in words, with its line in the statement."""
        for part, item in self.items():
            if item.refuted:
                place = "" if part.part.label is None else f"part {part.part.label}: "
                yield f"{place}{item.text} is to be shown, and is not true", item.line

    def __getitem__(self, text: str) -> ItemResult:
        items = [item for _, item in self.items() if _plain(item.text) == _plain(text)]
        if not items:
            known = ", ".join(repr(item.text) for _, item in self.items()) or "nothing"
            raise KeyError(f"{text!r} is not asked; asked: {known}")
        return items[-1]

    def __str__(self) -> str:
        lines = [self.problem.title] if self.problem.title else []
        if self.mistake is not None:
            lines.append(f"in the altered world of {self.mistake}:")
        for part, item in self.items():
            label = f"({part.part.label}) " if part.part.label else ""
            if item.error is not None:
                shown = f"no answer: {item.error.message}"
            elif item.holds is not None:
                shown = "shown" if item.holds else "false"
            elif item.undecided:
                shown = "not decided"
            else:
                shown = "  or  ".join(answer.display for answer in item.distinct)
            lines.append(
                f"{label}{item.text} = {shown}"
                if item.kind != "show"
                else f"{label}{item.text}: {shown}"
            )
        return "\n".join(lines)

    __repr__ = __str__


def _plain(text: str) -> str:
    return "".join(text.split())
