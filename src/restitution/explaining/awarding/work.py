"""What a condition of a mark may ask about: the derivation, and sides of its lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Protocol

from restitution.explaining.awarding.mark_rules import Rule
from restitution.explaining.lines.derivation import (
    Derivation,
    Fact,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Relation,
    is_same_identity,
)
from restitution.explaining.lines.marks import Style
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    letters,
)


class Work(Protocol):
    """A derivation on its way to its marks."""

    derivation: Derivation
    style: Style
    justify: frozenset[str]
    ends: dict[int, ItemEnd | None]
    shown: set[int]
    walls: dict[int, bool]
    parts: Mapping[str, str | None]
    new: frozenset[str]
    solved: dict[int, frozenset[int | None]]
    """The events whose principles a line solves, of the lines that were asked of."""

    def rule(self, line: Line) -> Rule | None:
        """The first rule that fits a line."""

    def part(self, line: Line) -> str | None:
        """The part to which a line belongs."""

    def above(self, line: Line) -> Sequence[Line]:
        """The lines above one."""

    def cited(self, line: Line) -> Sequence[Line]:
        """The lines that one cites."""

    def facts(self, line: Line) -> Iterator[Fact]:
        """The facts that a line cites."""


def length(line: Line) -> int:
    """How many lines of a page a line takes: one for each link of its chains."""
    if line.shown == "silent":
        return 0
    return 1 if isinstance(line.relation, Meaning) else max(map(len, line.relation.options))


def is_settled(work: Work, line: Line) -> bool:
    """Whether a line says what an unknown is, with no unknown on its other side."""
    sides = line.relation.sides
    return sides is not None and isinstance(sides[0], Letter) and not letters(sides[1]) & work.new


def subject_of(line: Line) -> Expression | None:
    """The letter or quantity that a line is about: its left side."""
    sides = line.relation.sides
    if sides is None or not isinstance(sides[0], Letter | Quantity):
        return None
    return sides[0]


def is_an_equation(line: Line) -> bool:
    """Whether a line is an equation of which the left side is no letter or quantity alone."""
    sides = line.relation.sides
    return sides is not None and not isinstance(sides[0], Letter | Quantity)


def has_bound_and_place(work: Work, line: Line) -> bool:
    """Whether a greatest or least value is found with where it is reached.

    Not where the bound is the answer of an item above: then only the place is new.
    """
    cited = list(work.cited(line))
    return any(map(_is_where_reached, cited)) and not any(own.number in work.ends for own in cited)


def _is_where_reached(line: Line) -> bool:
    """Whether a line says that a value is reached at one of a letter, without being printed."""
    return (
        line.shown == "silent"
        and line.move.id == "put"
        and isinstance(line.relation, Relation)
        and len(line.relation.options) == 2
    )


def says_a_value_again(work: Work, line: Line) -> bool:
    """Whether a line says of one value that it is at least, or at most, what it is."""
    cited = [own.relation for own in work.cited(line) if isinstance(own.relation, Relation)]
    if line.move.id != "sign" or len(cited) != 1 or not isinstance(line.relation, Relation):
        return False
    sides = cited[0].sides
    links = [link for option in line.relation.options for link in option]
    return sides is not None and [(e.left, e.right) for e in links] == [sides]


def is_sum_that_is_positive(line: Line) -> bool:
    """Whether it is only said that a sum of letters is positive, as 1 − e² is."""
    match line.relation:
        case Relation((((Link(Binary("+" | "-"), ">", right)),),)):
            return right == Number(Fraction(0))
    return False


def says_a_quantity_is_positive(line: Line) -> bool:
    """Whether it is only said that a quantity, such as a loss, is not zero."""
    match line.relation:
        case Relation((((Link(Quantity(kind), ">", right)),),)) if kind in LOSSES:
            return right == Number(Fraction(0))
    return False


def tells_a_quadrant(relation: Relation | Meaning) -> bool:
    """Whether it is only said that a tangent is positive, or not negative: its angle is acute."""
    match relation:
        case Relation((((Link(Apply("tan"), ">" | ">=", right)),),)):
            return right == Number(Fraction(0))
    return False


def earning_under(work: Work, line: Line, points: Mapping[int, Sequence[str]]) -> tuple[int, ...]:
    """The numbers of the lines that a line joins: of each that it cites, the nearest with points.

    What has no points leads on where it rests on one line alone.
    """
    numbers = []
    for own in work.cited(line):
        below = [own]
        while len(below) == 1 and not points[below[0].number]:
            below = list(work.cited(below[0]))
        if len(below) == 1:
            numbers.append(below[0].number)
    return tuple(numbers)


def grounds(work: Work, line: Line, within: Callable[[Line], bool]) -> Iterator[Line]:
    """The lines on which a line rests, each once; what they rest on only of those ``within``."""
    seen, open_ = set[int](), list(work.cited(line))
    while open_:
        premise = open_.pop()
        if premise.number not in seen and within(premise):
            seen.add(premise.number)
            yield premise
            open_ += work.cited(premise)


def is_like_one_above(work: Work, line: Line) -> bool:
    """Whether a line above in the same part is a method by the same definition and event."""
    return any(
        replace(other.move, bodies=()) == replace(line.move, bodies=())
        and work.part(other) == work.part(line)
        and (rule := work.rule(other)) is not None
        and "M" in rule.earned(work.style)
        for other in work.above(line)
    )


def is_identity_again(work: Work, line: Line) -> bool:
    """Whether the line just above applies the same identity to another equation."""
    above = [other for other in work.above(line) if other.shown != "silent"]
    return bool(above) and is_same_identity(above[-1], line)


def is_another_assembled(work: Work, line: Line) -> bool:
    """A velocity is put together below another one of the same impact, in the same part."""
    if getattr(subject_of(line), "kind", None) != "velocity":
        return False
    return any(
        other.move.record in ("assemble", "changed-velocity")
        and other.move.event == line.move.event
        and work.part(other) == work.part(line)
        and other.number not in work.ends
        for other in work.above(line)
    )
