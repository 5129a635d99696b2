"""The mark scheme of a question, as it is published: mark, for what, and notes.

It is made of the data that mark: the points of the usual way, and the table of misconceptions.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.angles import TRIGONOMETRIC
from restitution.explaining.lines.marks import Style
from restitution.explaining.mistakes.consequences import AlteredWorld, altered_world, applying
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.quantities import ANGLES, ENERGIES, LOSSES
from restitution.expression.tree import Apply, Binary, Degrees, Letter, Polar, Quantity, walk
from restitution.practice.marking.scheme import MarkPoint, schemes
from restitution.problem import Problem, Value, trees
from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.solving.equations.solution import Answer, ItemResult, Solution
from restitution.work import limited
from restitution.workings import explain
from restitution.workings.rendering.steps import PartExplanation, Row, Words

_MOST_WRONG = 4
_OF_ANGLES = frozenset({"sine-cosine", "angle-from-normal"})  # these need an angle in the question
_LONGEST = 10  # signs of an exact form beside which three figures stand, and not instead
# Worlds of mistakes that are worked out, and operations in each: so many that a scheme takes a few
# seconds and is the same on every machine. The clock is for what is not counted.
_WORLDS = 24
_OPERATIONS = 100_000
_SECONDS = 5.0


@dataclass(frozen=True)
class SchemeRow:
    """The marks of one line: ``("M1", "A1")``, what they are for, the line itself, and notes."""

    part: str | None
    marks: tuple[str, ...]
    purpose: str
    line: Words
    notes: tuple[str, ...]

    @property
    def working(self) -> str:
        """The line as text."""
        return "".join(
            word if isinstance(word, str) else to_text(word) for word in self.line
        ).strip()


def mark_scheme(solution: Solution, style: Style = "fm1") -> tuple[SchemeRow, ...]:
    """The mark scheme of a solved question, line by line."""
    wrong = _wrong_answers(solution)
    rows: list[SchemeRow] = []
    for part in explain(solution, marks=style).parts:
        points = list(schemes(solution, part.label, style)[0].points)
        for marks, line in _beside(part, points):
            own, points = points[: len(marks)], points[len(marks) :]
            rows.append(_row(part.label, own, line, solution, wrong))
    return tuple(rows)


def _beside(
    part: PartExplanation, points: Sequence[MarkPoint]
) -> Iterator[tuple[Sequence[str], Words]]:
    """The marks of each line with the line; without lines where the working has other marks."""
    lines = [line for line in _lines(part) if line[0]]
    if [mark for marks, _ in lines for mark in marks] == [point.kind for point in points]:
        yield from lines
        return
    for point in points:
        yield [point.kind], ()


def _lines(part: PartExplanation) -> Iterator[tuple[list[str], Words]]:
    for step in part.steps:
        if step.mark:
            yield step.mark.split(), step.words
        for row in step.rows:
            yield row.mark.split(), _words(row)


def _words(row: Row) -> Words:
    """A line of mathematics with its signs."""
    pieces: list[str | Layout] = [operand for operand in row.operands[:1] if operand is not None]
    for sign, operand in zip(row.signs, row.operands[1:], strict=False):
        pieces.append(f" {sign} ")
        if operand is not None:
            pieces.append(operand)
    return tuple(pieces)


def _row(
    part: str | None,
    points: Sequence[MarkPoint],
    line: Words,
    solution: Solution,
    wrong: dict[tuple[str | None, int], list[str]],
) -> SchemeRow:
    purposes = list(dict.fromkeys(point.purpose for point in points))
    notes = dict.fromkeys(note for point in points for note in _notes(part, point, solution, wrong))
    purpose = "; ".join(purposes)
    return SchemeRow(
        part,
        tuple(point.kind for point in points),
        purpose[:1].upper() + purpose[1:],
        line,
        tuple(notes),
    )


def _notes(
    part: str | None,
    point: MarkPoint,
    solution: Solution,
    wrong: dict[tuple[str | None, int], list[str]],
) -> Iterator[str]:
    if point.kind.endswith("*"):
        yield "Printed result: every method before it, and no false line."
    elif point.follows:
        yield "Follows through from earlier values."
    elif point.kind.startswith("DM"):
        yield "Depends on the methods before it."
    if point.letter == "M":
        yield from _allowed(point, solution)
    if point.letter == "B" and point.principle == "unchanged":
        yield "May be implied by a later line, or stand on the diagram."
    if point.item is not None:
        usual = wrong.get((part, point.item), [])
        if usual:
            yield f"Usual wrong answers: {'; '.join(usual)}."


def _allowed(point: MarkPoint, solution: Solution) -> Iterator[str]:
    """Mistakes for which the method is allowed, and mistakes that lose it."""
    here = [
        MISCONCEPTIONS[name]
        for name in applying(solution.problem)
        if point.principle in MISCONCEPTIONS[name].kinds
        and (name not in _OF_ANGLES or _has_angles(solution.problem))
    ]
    keeps = [
        misconception.title
        for misconception in here
        if (misconception.mark_of(point.principle) or "").startswith("M1")
    ]
    loses = [
        misconception.title
        for misconception in here
        if (misconception.mark_of(point.principle) or "") == "M0"
    ]
    if keeps:
        yield f"Allow M1 (A0) for: {_listed(keeps)}."
    if loses:
        yield f"M0: {_listed(loses)}."


def _has_angles(problem: Problem) -> bool:
    """Whether an angle, or a ratio of one, stands in a question."""
    nodes = (node for tree in trees(problem) for node in walk(tree))
    return any(
        isinstance(node, Polar | Degrees)
        or (isinstance(node, Apply) and node.function in TRIGONOMETRIC)
        or (isinstance(node, Quantity) and node.kind in ANGLES)
        for node in nodes
    )


def _listed(titles: Sequence[str]) -> str:
    return "; ".join(title[:1].lower() + title[1:] for title in titles)


def _wrong_answers(solution: Solution) -> dict[tuple[str | None, int], list[str]]:
    """Answers to which mistakes lead, with their names, by part and place of the item."""
    usual: dict[tuple[str | None, int], list[str]] = {
        (part, place): []
        for part, solved in solution.parts.items()
        for place, item in enumerate(solved.items)
        if item.kind in ("value", "vector")
    }
    left = _WORLDS
    with limited(_SECONDS) as clock:
        for name in applying(solution.problem):
            open_ = {key for key, wrong in usual.items() if len(wrong) < _MOST_WRONG}
            if not open_:
                break
            for world in _worlds(solution, name):
                left -= 1
                if clock.broken or left < 0:
                    break
                if world is not None:
                    open_ -= set(_add(usual, solution, world, name, open_))
                if not open_:
                    break
            if clock.broken or left <= 0:
                break
    return {key: wrong for key, wrong in usual.items() if wrong}


def _worlds(solution: Solution, name: str) -> Iterator[AlteredWorld | None]:
    """The worlds of a mistake that apply; None in place of one that takes too many operations."""
    for variant in MISCONCEPTIONS[name].variants:
        if not variant.solvable:
            continue
        world = None
        with limited(operations=_OPERATIONS) as limit:
            try:
                world = altered_world(solution, variant, time_limit=None)
            except RestitutionError:
                if limit.used == 0:
                    continue  # it does not apply
        yield world if limit.used <= _OPERATIONS else None


def _add(
    usual: dict[tuple[str | None, int], list[str]],
    solution: Solution,
    world: AlteredWorld,
    name: str,
    keys: Collection[tuple[str | None, int]],
) -> Iterator[tuple[str | None, int]]:
    """Adds what a world makes of some items, and tells of which it makes something else."""
    for part, place in sorted(keys, key=str):
        item = solution.parts[part].items[place]
        changed = next((other for other in world.items if other.true is item), None)
        if changed is None or not changed.altered.answers:
            continue
        yield part, place
        answer = changed.altered.answers[0]
        if not _possible(item, answer):
            continue
        display, wrong = _shown(answer), usual[part, place]
        if all(not entry.startswith(f"{display} (") for entry in wrong):
            title = MISCONCEPTIONS[name].title
            wrong.append(f"{display} ({title[:1].lower() + title[1:]})")


def _shown(answer: Answer) -> str:
    """An answer as a marker looks for it: three figures, beside an exact form that is short."""
    exact, _, rounded = answer.display.partition(" = ")
    if rounded:
        return rounded if answer.angle or len(exact) > _LONGEST else answer.display
    if len(exact) > 2 * _LONGEST and isinstance(answer.decimal, tuple):
        x, y = (f"{abs(number):.3g}" for number in answer.decimal)
        first, second = (number < 0 for number in answer.decimal)
        return f"{'−' if first else ''}{x}𝐢 {'−' if second else '+'} {y}𝐣"
    return exact


def _possible(item: ItemResult, answer: Answer) -> bool:
    """Whether a value can be meant: no energy lost, mass or coefficient is negative, none of it
    and no fraction of energy more than 1.
    """
    if not isinstance(item.item, Value) or item.kind != "value" or answer.angle:
        return True
    at_most_1 = False
    match item.item.expression:
        case Quantity(kind) if kind in ENERGIES or kind in ("mass", "speed"):
            pass
        case Binary("/", Quantity(kind), Quantity("energy")) if kind in LOSSES:
            at_most_1 = True
        case Letter(name):
            at_most_1 = name.startswith("e")
        case _:
            return True
    value = sp.sympify(answer.value, strict=True)
    too_large = at_most_1 and (value - 1).is_positive
    return not (value.is_negative or too_large)
