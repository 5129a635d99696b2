"""Lines of energies that say only when: ``before = 54.5``, ``after = 35.3``, ``lost 19.2 J``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from restitution.expression.tree import Quantity, is_binary, walk
from restitution.practice.reading.characters import Plain
from restitution.problem import Find, Problem, trees_of_step

_TITLE = r"(?:(?:(?:kinetic\s+)?energy|KE|loss|lost)\b[^:=]{0,30}:\s*)?"
_ENDS = r"initial(?:ly)?|final(?:ly)?|at\s+(?:the\s+)?(?:start|first|beginning|end)"
_STAGE = re.compile(
    rf"\s*{_TITLE}(?:so\s+)?(?:total\s+)?(before|after|{_ENDS})(?:wards)?\s*[:=]?\s*(?=[\d(.√])(?!.*:)",
    re.IGNORECASE,
)
# Energies of one direction, of all spheres: ``along j: before 16 + 2 = 18``.
_STAGE_ALONG = re.compile(
    r"\s*(?:so\s+)?(?:(?:along|in|parallel\s+to)\s+)?(?:the\s+)?"
    r"(?:([ij])(?:[-\s]+(?:direction|axis))?|(line\s+of\s+centres|LOC))\s*[:,]?\s*"
    r"(before|after)\s*[:=]?\s*(?=[\d(.½])(?!.*:)",
    re.IGNORECASE,
)
_SUM = re.compile(r"[^-−=]*\+[^-−=]*=(?:[^=]*=)*\s*(\d[\d./]*)\s*(?:J\b\s*)?")
_JOULES = re.compile(r"\d\s*(?:J|joules?)\b")
# What an energy is written with: numbers, masses and speeds, and no unit vectors.
_AMOUNT = re.compile(r"(?:[\d\s.+*/x·÷()^²=√|-]|(?<![A-Za-z])[emMuUkv]{1,3}(?![A-Za-z])|J\b)+")
_LETTER = re.compile(r"(?<![A-Za-z])[muvMU]{1,3}(?![A-Za-z])")
_HALF = re.compile(r"(?<!\d)1/2(?!\d)|½|(?<!\d)0?\.5(?!\d)")
_LOSS = re.compile(r"\b(?:los[st]|loss|loses|gain(?:ed)?|difference)\b", re.IGNORECASE)


def with_energy_labels(
    lines: Sequence[Plain], problem: Problem
) -> tuple[Sequence[Plain], frozenset[int]]:
    """The lines with ``before:`` for ``before =``, and the places of those that are energies.

    They are where the question asks for an energy, there is a line of each stage, and they are
    halves of products, in joules, or followed by what is lost. Of a share that is asked numbers
    alone may be in other units; letters of masses and speeds tell that they are energies.
    """
    asked = [tree for tree in _asked(problem) if _is_of_energy(tree)]
    lines = _with_energies_along(lines) if asked and len(problem.spheres) > 1 else lines
    staged = {
        place: match
        for place, line in enumerate(lines)
        if (match := _STAGE.match(line.text)) and _AMOUNT.fullmatch(line.text[match.end() :])
    }
    if not asked or len({_stage(match) for match in staged.values()}) < 2:
        return lines, frozenset()
    texts = [lines[place].text[match.end() :] for place, match in staged.items()]
    halved = all(_HALF.search(text) for text in texts)
    joules = any(_JOULES.search(line.text) for line in lines)
    whole = not any(is_binary(tree, "/") for tree in asked)
    whole = whole or all(map(_LETTER.search, texts))
    lost = whole and any(_LOSS.search(line.text) for line in lines)
    if not (halved or joules or lost):
        return lines, frozenset()
    labelled = [
        _labelled(line, staged[place], problem) if place in staged else line
        for place, line in enumerate(lines)
    ]
    return labelled, frozenset(staged) if joules or lost else frozenset()


def _with_energies_along(lines: Sequence[Plain]) -> Sequence[Plain]:
    """The lines with ``KE along j before =`` for ``along j: before``, where they are of energies.

    They are sums before and after of which something is lost: all of a momentum stays.
    """
    sums = {
        place: (match, total[1])
        for place, line in enumerate(lines)
        if (match := _STAGE_ALONG.match(line.text))
        and _AMOUNT.fullmatch(text := line.text[match.end() :])
        and (total := _SUM.fullmatch(text))
    }
    ends = [
        {total for match, total in sums.values() if match[3].lower() == stage}
        for stage in ("before", "after")
    ]
    lost = any(_LOSS.search(line.text) for line in lines)
    if not lost or not all(ends) or ends[0] & ends[1]:
        return lines
    return [
        _put(line, sums[place][0], _label_along(sums[place][0])) if place in sums else line
        for place, line in enumerate(lines)
    ]


def _label_along(match: re.Match[str]) -> str:
    """The name of an energy of one direction."""
    direction = match[1].lower() if match[1] else "line of centres"
    return f"KE along {direction} {match[3].lower()} = "


def _put(line: Plain, match: re.Match[str], label: str) -> Plain:
    """A line that begins with a label in place of a match."""
    columns = (line.columns[match.start(match.lastindex or 0)],) * len(label) + line.columns[
        match.end() :
    ]
    return Plain(label + line.text[match.end() :], columns)


def _stage(match: re.Match[str]) -> str:
    """The stage of a line, by whatever word."""
    word = match[1].lower()
    return "after" if word in ("after", "final", "finally") or word.endswith("end") else "before"


def _labelled(line: Plain, match: re.Match[str], problem: Problem) -> Plain:
    """A line with its stage as a label; of several impacts the start is before all of them."""
    stage = _stage(match)
    first = stage == "before" != match[1].lower() and len(problem.events) > 1
    label = "KE at the start = " if first else f"{stage}: "
    return _put(line, match, label)


def asks_energy(problem: Problem) -> bool:
    """Whether a part of a question asks for an energy, a loss of it or a share."""
    return any(map(_is_of_energy, _asked(problem)))


def _asked(problem: Problem) -> Sequence[object]:
    finds = (step for _, step in problem.steps() if isinstance(step, Find))
    return [tree for step in finds for tree in trees_of_step(step)]


def _is_of_energy(tree: object) -> bool:
    return any(isinstance(node, Quantity) and "energy" in node.kind for node in walk(tree))  # type: ignore[arg-type]
