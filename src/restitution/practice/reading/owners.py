"""One letter for the same quantity of two bodies: ``A: u.n = 3, B: u.n = -1``."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from restitution.practice.reading.characters import Plain
from restitution.problem import Problem

# The name of a body as a label, and a velocity that the relation behind it begins with.
_BEGINNING = re.compile(
    r"(?:^|(?<=[,;.])|(?<=\s\s))\s*(?:for\s+)?([A-Z]\w?)\s*:\s*(?:\d\s*)?([uvwUVW])(?=\s*[=.·^])"
)
_LABEL = re.compile(r"(?:^|[,;.]|\s\s)\s*(?:for\s+)?([A-Z]\w?)\s*:")


def with_owners(
    lines: Sequence[Plain], problem: Problem, known: Collection[str]
) -> Sequence[Plain]:
    """The lines, with the body as a subscript of a letter that labels give to several bodies.

    ``known`` are letters that have a meaning of their own.
    """
    spheres = {sphere.name for sphere in problem.spheres}
    owners: dict[str, set[str]] = {}
    for line in lines:
        for match in _BEGINNING.finditer(line.text):
            if match[1] in spheres and match[2] not in known:
                owners.setdefault(match[2], set()).add(match[1])
    shared = {letter for letter, bodies in owners.items() if len(bodies) > 1}
    return [_owned(line, shared, spheres) for line in lines] if shared else lines


def _owned(line: Plain, shared: Collection[str], spheres: Collection[str]) -> Plain:
    labels = [label for label in _LABEL.finditer(line.text) if label[1] in spheres]
    text = ""
    columns: tuple[int, ...] = ()
    start = 0
    letter = re.compile(rf"(?<![A-Za-z_])([{''.join(sorted(shared))}])(?![A-Za-z_0-9'])")
    for place, label in enumerate(labels):
        end = labels[place + 1].start() if place + 1 < len(labels) else len(line.text)
        for match in letter.finditer(line.text, label.end(), end):
            text += line.text[start : match.end()] + f"_{label[1]}"
            columns += line.columns[start : match.end()]
            columns += (line.columns[match.start()],) * (1 + len(label[1]))
            start = match.end()
    if not start:
        return line
    return Plain(text + line.text[start:], (*columns, *line.columns[start:]))
