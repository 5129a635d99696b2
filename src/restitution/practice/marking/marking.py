"""A working marked: its lines with verdicts, its marks point by point, and messages about them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from restitution.errors import MissingError, RestitutionError, StatementError, require
from restitution.explaining.mistakes.consequences import altered_world
from restitution.explaining.mistakes.misconceptions import alteration
from restitution.expression.tree import Expression
from restitution.expression.writing import write_expression
from restitution.practice.judgement import JudgedLine, Judgement
from restitution.practice.judging.bench import bench_of
from restitution.practice.judging.earlier_parts import judge_part
from restitution.practice.letters.declaring import letters_from_mapping
from restitution.practice.letters.letters_box import letters_box
from restitution.practice.marking.answers import answers_of
from restitution.practice.marking.content import Ask, MarkingContent
from restitution.practice.marking.messages import LEVELS, messages_of
from restitution.practice.marking.points import marked
from restitution.practice.marking.showing import to_html, to_text
from restitution.practice.marking.values import Values
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.quoted import vectors_in
from restitution.practice.reading.working import Working, read_working
from restitution.practice.script import Script
from restitution.problem import Problem
from restitution.solving.equations.solution import Solution
from restitution.solving.solver import solve

Meant = str | Expression | tuple[Expression, ...]
"""A meaning: a quantity as text, a phrase, or trees that it may be."""

_PROPOSALS = 6
_CONSEQUENCE = 1.0  # seconds for the world of a mistake; without it only this is left out


class Marking(MarkingContent):
    """A working of one part, marked.

    ``lines`` have their verdicts, ``letters`` are their meanings, ``answers`` the values given for
    what is asked, ``marks`` the points. It shows itself in a terminal and in Jupyter.
    """

    def __str__(self) -> str:
        return to_text(self)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return to_html(self)


def mark(
    question: Problem | Solution,
    working: Working,
    part: str | None = None,
    letters: Mapping[str, Meant] | None = None,
    *,
    hints: int | Mapping[int | None, int] = 0,
) -> Marking:
    """A student's working of one part, marked line by line and point by point.

    ``working`` is text, a step a line, or lists of lines by the label of their part. ``part`` is
    the label of the part; left out, it is the part that the working opens, or the first.
    ``letters`` maps a letter to a quantity of the statement language (``along(velocity(A), i)``) or
    to a phrase (``component of A along i after``). ``hints`` is the level of messages, 0 to 4, for
    all lines or by line (None: for the next step).

    Raises TypeError for what is no question, KeyError for a part that is not there, StatementError
    for a meaning that cannot be read, MissingError where nothing is asked, and the error of a
    question that has no answer.
    """
    solution = _solved(question, "mark")
    script = read_working(working, solution.problem, letters or ())
    labels = _labels(solution)
    if part is None and None not in labels:
        opened = [line.part for line in script.lines if line.part in labels]
        part = opened[0] if opened else labels[0]
    return _marked(solution, script, part, letters, hints)


def mark_parts(
    question: Problem | Solution,
    working: Working,
    letters: Mapping[str, Meant] | None = None,
    *,
    hints: int | Mapping[int | None, int] = 0,
) -> tuple[Marking, ...]:
    """Markings of every part that a working opens, in the order of the question.

    A working that opens none is one of the first part.
    """
    solution = _solved(question, "mark_parts")
    markings = markings_of_parts(solution, working, letters, hints=hints)
    return tuple(marking() for _, marking in markings)


def markings_of_parts(
    solution: Solution,
    working: Working,
    letters: Mapping[str, Meant] | None = None,
    *,
    hints: int | Mapping[int | None, int] = 0,
) -> Iterator[tuple[str | None, Callable[[], Marking]]]:
    """The label of every part that a working opens, and what marks it when it is called."""
    script = read_working(working, solution.problem, letters or ())
    opened = {line.part for line in script.lines}
    labels = [label for label in _labels(solution) if label in opened] or _labels(solution)[:1]
    judged: dict[str | None, Judgement] = {}
    for label in labels:
        yield label, partial(_marked, solution, script, label, letters, hints, judged)


def _solved(question: Problem | Solution, taker: str) -> Solution:
    require(question, (Problem, Solution), taker)
    return question if isinstance(question, Solution) else solve(question)


def _labels(solution: Solution) -> list[str | None]:
    return list(solution.parts)


def _marked(
    solution: Solution,
    script: Script,
    part: str | None,
    letters: Mapping[str, Meant] | None,
    hints: int | Mapping[int | None, int],
    judged: dict[str | None, Judgement] | None = None,
) -> Marking:
    if part not in solution.parts:
        known = ", ".join(str(label) for label in _labels(solution) if label is not None)
        parts = f"parts: {known}" if known else "the question has no parts"
        raise KeyError(f"there is no part {part!r}; {parts}")
    levels, usual = ({}, hints) if isinstance(hints, int) else (dict(hints), 0)
    for level in (usual, *levels.values()):
        if level not in LEVELS:
            raise StatementError(f"hints have the levels 0 to 4, not {level}")
    bench = bench_of(solution, part)
    solved = bench.solved
    without = [item.error for item in solved.items if item.error is not None]
    error = solved.error or (without[0] if len(without) == len(solved.items) > 0 else None)
    if error is not None:
        raise error
    if not solved.items:
        raise MissingError("nothing is asked: a line such as 'find velocity(A)' would ask for it")
    meanings = _meanings(letters or {}, solution.problem)
    judgement = judge_part(bench.solution, script, part, meanings, judged)
    judgement = _with_consequence(judgement, solution, part)
    unknown = bench.question.unknown - bench.question.given
    values = Values(bench.worlds, unknown, judgement.letters)
    marks = marked(judgement, bench.schemes, values)
    return Marking(
        part,
        judgement.lines,
        judgement.letters,
        tuple(answers_of(solved, judgement, values, bench)),
        marks,
        tuple(
            messages_of(
                judgement.lines,
                marks.points,
                values,
                levels,
                usual,
                solution.problem,
            )
        ),
        tuple(_asks(judgement, bench.solution, part)),
    )


def _with_consequence(judgement: Judgement, solution: Solution, part: str | None) -> Judgement:
    """The judgement with the answers to which the first named mistake leads, where it has some."""
    for place, line in enumerate(judgement.lines):
        mistake = line.mistake
        if mistake is None or mistake.kind != "misconception" or not mistake.variants:
            continue
        leads_to = _consequence(mistake.variants[0], line, solution, part)
        explained = replace(line, mistake=replace(mistake, leads_to=leads_to))
        lines = (*judgement.lines[:place], explained, *judgement.lines[place + 1 :])
        return replace(judgement, lines=lines)
    return judgement


def _consequence(
    variant: str, line: JudgedLine, solution: Solution, part: str | None
) -> Mapping[str, str]:
    """The answers of a part in the world of a variant, by item; none where it has no world.

    The law is altered from the event on at which a line has it so: at earlier ones nothing was.
    """
    own = [use.event for use in line.uses if use.altered == variant and use.event is not None]
    after = range(min(own), len(solution.problem.events) + 1) if own else None
    try:
        world = altered_world(solution, alteration(variant), after, _CONSEQUENCE)
    except RestitutionError:
        return {}
    return {
        item.text: item.altered.answers[0].display
        for item in world.items
        if item.part == part and item.altered.answers
    }


def _meanings(
    letters: Mapping[str, Meant], problem: Problem
) -> Mapping[str, Expression | Sequence[Expression]]:
    texts = {name: meant for name, meant in letters.items() if not isinstance(meant, tuple)}
    trees = {name: meant for name, meant in letters.items() if isinstance(meant, tuple)}
    return {**letters_from_mapping(texts, problem), **trees}


def _asks(judgement: Judgement, solution: Solution, part: str | None) -> list[Ask]:
    if not judgement.asks:
        return []
    known = {write_expression(meaning.quantity) for meaning in judgement.letters}
    rows = [
        (row.meaning, row.words)
        for row in letters_box(solution.problem, solution, part)
        if row.meaning not in known
    ]
    velocities = [
        (f"velocity({sphere.name})", f"velocity of {sphere.name} after")
        for sphere in solution.problem.spheres
    ]
    vectors = {name for line in judgement.lines for name in vectors_in(line.line)}
    return [
        Ask(letter, _question(letter, fitting), tuple(fitting[:_PROPOSALS]))
        for letter in judgement.asks
        for fitting in (velocities if letter in vectors else rows,)
    ]


def _question(letter: str, rows: Sequence[tuple[str, str]]) -> str:
    """What is asked about a letter, or a phrase, and how to answer in a line."""
    if is_phrase(letter):
        return f"What is {letter} here? Say there of what it is, and when: before or after."
    words = rows[0][1] if rows else "speed after"
    return f"What is {letter} here? Say it in a line above, such as: let {letter} = {words}."


# --- plain data -----------------------------------------------------------------------------------
