"""Lines of a part that rest on lines of earlier parts, the student's own mistakes included."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from restitution.expression.tree import Expression
from restitution.practice.judgement import JudgedLine, Judgement, false_roots
from restitution.practice.judging.judging import judge
from restitution.practice.script import Script, ScriptLine
from restitution.problem import Given, Unknown
from restitution.solving.equations.solution import Solution

_TROUBLED = frozenset({"false", "follows", "asks", "unsupported"})


def judge_part(
    solution: Solution,
    script: Script,
    part: str | None = None,
    letters: Mapping[str, Expression | Sequence[Expression]] | None = None,
    judged: dict[str | None, Judgement] | None = None,
) -> Judgement:
    """The verdicts on the lines of a part, which may rest on the lines of earlier parts.

    Earlier lines are looked at where one of them, or of the part's own, is not plainly true; they
    are left out again where more lines would be false with them. The source of a line is then a
    false one of an earlier part. ``judged`` keeps the verdicts on each part by itself, for the
    parts of the same script that are judged next. Raises KeyError for a part that
    is not there, and the error of a question that has no answer.
    """
    known = {} if judged is None else judged

    def by_itself(label: str | None) -> Judgement:
        if label not in known:
            known[label] = judge(solution, script, label, letters)
        return known[label]

    alone = by_itself(part)
    labels = [label for label in _earlier(solution, part) if script.of(label).lines]
    if not labels or script.of(part) is script:
        return alone
    if not any(_is_troubled(by_itself(label).lines) for label in (part, *labels)):
        return alone
    whole = judge(solution, _joined(script, [*labels, part], part), part, letters)
    numbers = {line.line.number for line in alone.lines}
    roots = false_roots(whole.lines)
    own = tuple(
        _with_roots(line, numbers, roots) for line in whole.lines if line.line.number in numbers
    )
    if _falses(own) > _falses(alone.lines):
        return alone
    return replace(whole, lines=own)


def _with_roots(
    line: JudgedLine, numbers: Collection[int], roots: Mapping[int, frozenset[int]]
) -> JudgedLine:
    """A line with the false lines of earlier parts in place of what follows from them there."""
    sources = [
        root
        for source in line.sources
        for root in ([source] if source in numbers else sorted(roots.get(source, ())))
    ]
    return replace(line, sources=tuple(dict.fromkeys(sources)))


def _earlier(solution: Solution, part: str | None) -> list[str]:
    """The parts before one of which nothing given is out of force in it."""
    labels = list(solution.parts)
    return [
        label
        for label in labels[: labels.index(part)]
        if label is not None
        and not any(isinstance(step, Given | Unknown) for step in solution.parts[label].part.steps)
    ]


def _joined(script: Script, labels: Sequence[str | None], part: str | None) -> Script:
    """The lines of several parts as lines of one."""
    literal = None if script.literal is None else _joined(script.literal, labels, part)
    lines = (replace(line, part=part) for line in _of(script.lines, labels))
    return Script(tuple(lines), literal)


def _of(lines: Iterable[ScriptLine], labels: Sequence[str | None]) -> list[ScriptLine]:
    return [line for label in labels for line in lines if line.part == label]


def _is_troubled(lines: Iterable[JudgedLine]) -> bool:
    return any(line.verdict in _TROUBLED for line in lines)


def _falses(lines: Iterable[JudgedLine]) -> int:
    return sum(line.verdict == "false" for line in lines)
