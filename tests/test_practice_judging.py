"""Scripts of one's own, marked by hand, and what is said of their lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

import restitution
from restitution.practice.judgement import Judgement
from restitution.practice.judging.bench import bench_of
from restitution.practice.judging.judging import judge
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.declaring import letters_from_mapping
from restitution.practice.reading.working import read_working
from restitution.solving.equations.solution import Solution

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


@dataclass(frozen=True, eq=False)
class Trial:
    """A script with the verdict that each line has by hand, and the name of its mistake."""

    statement: str
    title: str
    letters: dict[str, str]
    lines: tuple[tuple[str, str, str | None], ...]

    @cache  # noqa: B019 - there are few, and all are kept anyway
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
def test_every_line_has_the_verdict_that_it_has_by_hand(trial: Trial) -> None:
    verdicts = [line.verdict for line in trial.judged().lines]
    assert verdicts == [verdict for _, verdict, _ in trial.lines]


@pytest.mark.parametrize("trial", TRIALS, ids=lambda trial: trial.title)
def test_no_mistake_has_a_wrong_name(trial: Trial) -> None:
    for (_, verdict, name), line in zip(trial.lines, trial.judged().lines, strict=True):
        if verdict == "false" and line.mistake is not None and line.mistake.id is not None:
            assert name in (line.mistake.id, *line.mistake.also)


def test_most_mistakes_have_their_name() -> None:
    pairs = [
        (name, line.mistake.id if line.mistake else None)
        for trial in TRIALS
        for (_, _, name), line in zip(trial.lines, trial.judged().lines, strict=True)
        if name is not None
    ]
    assert sum(name == judged for name, judged in pairs) >= 0.9 * len(pairs)


UNLIKE = """
wall W: along i
sphere P: mass 1/2, velocity 3i - 4j
P hits W: e = 1/2
find impulse
"""


@pytest.mark.parametrize("middle", ["0.5(v - u)", "0.5((3i + 2j) - (3i - 4j))", "3j"])
@pytest.mark.parametrize("size", ["0.5(4 + 2)", "0.5 x 6 = 3", "0.5(2 - -4) = 3 N s"])
def test_a_number_behind_a_vector_is_that_of_the_start_of_their_chain(
    middle: str, size: str
) -> None:
    assert of_chain(middle, size) == "true"


@pytest.mark.parametrize("size", ["0.5(4 - 2)", "0.5 x 4 = 2", "3.5"])
def test_a_number_behind_a_vector_is_no_mistake_by_the_start_of_their_chain(size: str) -> None:
    """What is neither the size nor anything else that can be compared is not judged."""
    assert of_chain("0.5((3i + 2j) - (3i - 4j))", size) == "unread"
    assert of_chain("3j", size) == "unread"
    # Speeds may be meant by v and u: that is compared, and is not so.
    assert of_chain("0.5(v - u)", size) == "false"


def of_chain(middle: str, size: str) -> str:
    """The verdict on an impulse that is worked out by a vector, and then given its size."""
    letters = {"v": "velocity(P)", "u": "velocity(P, 0)", "I": "impulse"}
    (line,) = Trial(UNLIKE, size, letters, ((f"I = {middle} = {size}", "", None),)).judged().lines
    return line.verdict


def test_letters_in_doubt_are_tried_without_the_laws_of_their_lines() -> None:
    """A meaning that explains too little is given up, and asks for no law and no name."""
    trial = next(each for each in TRIALS if each.title == "a sign in it, and what follows")
    question = bench_of(solved(trial.statement), None)
    script = read_working("\n".join(text for text, _, _ in trial.lines), question.problem)
    judge_ = Judge(question.worlds, {}, question.names, question.question, names=False)
    assert judge_.judged(script, lambda lines: len(lines) == 1) == ()
    assert all(not line.uses for line in judge_.judged(script))
