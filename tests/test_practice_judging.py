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
from restitution.practice.judging import doubts, judging
from restitution.practice.judging.bench import bench_of
from restitution.practice.judging.judging import judge
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.declaring import letters_from_mapping
from restitution.practice.reading.working import read_working
from restitution.practice.worlds.effort import ExhaustedError
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


FACING = """sphere A: mass 2, velocity 3i + 2j
sphere B: mass 4, velocity -i + j
A hits B: along i, e = 1/2
find velocity(A), velocity(B)"""


def test_of_a_long_text_the_first_lines_are_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    working = ["2*3 + (-4) = 2v + 4w", "w - v = 2", "w = 1", "v = -1", *["v + 2w = 7"] * 20]
    long = restitution.mark(solved(FACING), working).json()["lines"]
    assert [line["verdict"] for line in long[:5]] == ["true"] * 4 + ["false"]
    monkeypatch.setattr(judging, "_EFFORT", 3_000)
    marking = restitution.mark(solved(FACING), working, hints=1)
    judged = [line.verdict for line in marking.lines if line.remark != judging.NOT_JUDGED]
    assert 0 < len(judged) < len(working)
    assert judged[:4] == ["true"] * min(4, len(judged))
    assert {line.verdict for line in marking.lines[len(judged) :]} == {"unread"}
    assert judging.NOT_JUDGED in {message.text for message in marking.messages}
    assert all(point.state != "lost" or point.line for point in marking.marks.points)
    monkeypatch.setattr(judging, "_EFFORT", 0)
    lines = restitution.mark(solved(FACING), working).lines
    assert {line.verdict for line in lines} == {"unread"}


def test_a_letter_of_too_many_meanings_to_be_tried_is_asked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    working = ["6 - 4 = 2p + 4q", "q - p = 4"]
    statement = FACING.replace("e = 1/2", "e = 1/4")
    assert [line.verdict for line in restitution.mark(solved(statement), working).lines] == [
        "true",
        "false",
    ]

    def exhausted(*_: object) -> None:
        raise ExhaustedError

    monkeypatch.setattr(doubts.Doubts, "_asked_by_rivals", exhausted)
    lines = restitution.mark(solved(statement), working).lines
    assert "false" not in {line.verdict for line in lines}
