"""Scripts of one's own, marked by hand, and what is said of their lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

import restitution
from restitution.practice.declaring import letters_from_mapping
from restitution.practice.judgement import Judgement
from restitution.practice.judging import judge
from restitution.practice.working import read_working
from restitution.solving.solution import Solution

_FOLDER = Path(__file__).parent / "judged"
_VERDICTS = {
    "T": "true",
    "F": "false",
    ">": "follows",
    "?": "asks",
    "-": "remark",
    "U": "unsupported",
    "X": "unread",
}


@dataclass(frozen=True)
class Trial:
    """A script with the verdict that each line has by hand, and the name of its mistake."""

    statement: str
    title: str
    letters: dict[str, str]
    lines: tuple[tuple[str, str, str | None], ...]

    def judged(self) -> Judgement:
        """What the program says of it."""
        solution = solved(self.statement)
        script = read_working("\n".join(text for text, _, _ in self.lines), solution.problem)
        declared = letters_from_mapping(self.letters, solution.problem)
        return judge(solution, script, None, declared)


@cache
def solved(statement: str) -> Solution:
    return restitution.solve(restitution.parse(statement))


def _trials() -> Iterator[Trial]:
    for path in sorted(_FOLDER.glob("*.txt")):
        for chunk in re.split(r"(?m)^=== ", path.read_text(encoding="utf-8"))[1:]:
            head, *scripts = re.split(r"(?m)^--- ", chunk)
            statement = head.partition("\n")[2]
            for script in scripts:
                yield _trial(statement, script)


def _trial(statement: str, script: str) -> Trial:
    title, _, body = script.partition("\n")
    letters: dict[str, str] = {}
    lines: list[tuple[str, str, str | None]] = []
    for text in filter(None, map(str.strip, body.splitlines())):
        if " | " in text:
            typed, _, verdict = text.rpartition(" | ")
            code, *name = verdict.split()
            lines.append((typed, _VERDICTS[code], name[0] if name else None))
        else:
            letter, _, meaning = text.partition(":")
            letters[letter] = meaning.strip()
    return Trial(statement, title, letters, tuple(lines))


TRIALS = tuple(_trials())


@pytest.mark.parametrize("trial", TRIALS, ids=lambda trial: trial.title)
def test_no_right_line_is_called_false(trial: Trial) -> None:
    judgement = trial.judged()
    accused = [
        text
        for (text, verdict, _), line in zip(trial.lines, judgement.lines, strict=True)
        if verdict != "false" and line.verdict == "false"
    ]
    assert not accused
