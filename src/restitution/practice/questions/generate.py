"""Practice questions: a statement of a topic and a level that follows from its seed alone.

Numbers come from hashes, so that the same seed gives the same question on every machine for one
version of the generator. A question is drawn again until it is admissible: solved with one answer
to each item, of nice values, and its answers tell mistakes apart (`diagnosis`).
"""

from __future__ import annotations

from collections import Counter
from functools import cached_property
from typing import TYPE_CHECKING

from restitution.errors import RestitutionError, StatementError, UnsupportedError
from restitution.practice.questions.topics import LEVELS, topic
from restitution.records import dataclass

if TYPE_CHECKING:
    from collections.abc import Mapping

    from restitution.problem import Problem
    from restitution.solving.equations.solution import Solution
    from restitution.wording import Question

VERSION = 3
"""The version of the generator: it grows whenever a seed gives another question than before."""

MOST_DRAWS = 2000
MOST_SEED = 10**9


@dataclass(frozen=True)
class PracticeQuestion:
    """A question to practise.

    ``statement`` is its text, with a comment that tells how to make it again.
    """

    topic: str
    level: int
    seed: int
    statement: str
    draws: int = 1
    mistake: str | None = None
    version: int = VERSION

    @property
    def address(self) -> str:
        """What tells this question from all others: ``wall-forward/2/17/v1``."""
        return f"{self.topic}/{self.level}/{self.seed}/v{self.version}"

    @cached_property
    def problem(self) -> Problem:
        """The statement as read."""
        from restitution.language import parse

        return parse(self.statement)

    @cached_property
    def solution(self) -> Solution:
        """The question solved."""
        from restitution.solving import solve

        return solve(self.problem)

    @cached_property
    def part_marks(self) -> Mapping[str | None, int]:
        """The marks of each part, by its label."""
        from restitution.workings import explain

        return {part.label: part.marks for part in explain(self.solution).parts if part.marks}

    @property
    def marks(self) -> int:
        """What the whole question is worth."""
        return sum(self.part_marks.values())

    @cached_property
    def question(self) -> Question:
        """The question in words, with its marks."""
        from dataclasses import replace

        from restitution.wording import question

        return replace(question(self.problem, marks=self.part_marks), title=None)

    def __str__(self) -> str:
        return str(self.question)


def practice_question(
    topic: str, level: int = 1, seed: int = 1, mistake: str | None = None
) -> PracticeQuestion:
    """A question on a topic, the same for the same seed; of several draws, with ``mistake``, that
    in which the mistake shows most.

    ``level`` is 1 to 4, ``seed`` 0 to 10⁹. Raises StatementError for a topic, a level or a seed
    that is not there, and for a mistake that cannot be made there; UnsupportedError, which names
    the pair, where no draw tells mistakes apart.
    """
    known = _topic(topic)
    _require(level in LEVELS, f"the level is {level}: it is 1, 2, 3 or 4")
    if mistake is not None:
        from restitution.explaining.mistakes.misconceptions import misconception

        mistake = misconception(mistake).id
        _require_shown(mistake, known, level)
    _require(0 <= seed <= MOST_SEED, f"the seed is {seed}: it is from 0 to {MOST_SEED}")
    return _question(known, level, seed, mistake)


_topic_of = topic


def _topic(name: str) -> str:
    return _topic_of(name).id


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise StatementError(otherwise)


def _require_shown(mistake: str, topic: str, level: int) -> None:
    from restitution.practice.questions.shown_mistakes import shows, why_not

    if not shows(mistake, topic, level):
        raise StatementError(why_not(mistake, topic, level))


def _question(topic: str, level: int, seed: int, mistake: str | None) -> PracticeQuestion:
    from restitution.explaining.mistakes.consequences import can_be_made
    from restitution.practice.questions.diagnosis import difference
    from restitution.practice.questions.dice import Dice
    from restitution.practice.questions.recipes import RECIPES

    recipes = RECIPES[topic, level]
    clashes: Counter[str] = Counter()
    best: tuple[tuple[bool, float], PracticeQuestion] | None = None
    admitted = 0
    for draw in range(1, MOST_DRAWS + 1):
        dice = Dice(f"{_DRAWS}/{topic}/{level}/{seed}/{draw}")
        # A seed keeps to one recipe for some draws, so that no recipe is crowded out.
        recipe = recipes[Dice(f"{topic}/{level}/{seed}/{draw // 20}").below(len(recipes))]
        text = recipe(dice)
        solution, why_not = admissible(text)
        if solution is None:
            clashes[why_not] += 1
            continue
        question = PracticeQuestion(
            topic, level, seed, _headed(topic, level, seed, mistake, text), draw, mistake
        )
        if mistake is None:
            return question
        admitted += 1
        shown = can_be_made(mistake, solution.problem), difference(solution, mistake)
        if best is None or shown > best[0]:
            best = shown, question
        if admitted >= _CHOICES and best[0][0]:
            return best[1]
    if best is not None:
        return best[1]
    raise UnsupportedError(
        f"no question on {topic} at level {level} was found in {MOST_DRAWS} draws: most often "
        f"{clashes.most_common(1)[0][0]}"
    )


_CHOICES = 4
_DRAWS = 1
"""What the dice are shaken with: most questions of a version are those of the one before."""


def _headed(topic: str, level: int, seed: int, mistake: str | None, text: str) -> str:
    """The statement with the comment that tells how to make it again, and its title."""
    chosen = f" --mistake {mistake}" if mistake else ""
    return (
        f"# restitution practise {topic} --level {level} --seed {seed}{chosen}"
        f"  (generator version {VERSION})\n"
        f"title {_topic_of(topic).title}\n{text}"
    )


def admissible(text: str) -> tuple[Solution | None, str]:
    """A statement solved, if it may be set to practise; else None, and why not."""
    from restitution.language import parse
    from restitution.practice.questions.nice import too_large
    from restitution.solving import solve

    try:
        problem = parse(text)
        if too_large(problem):
            return None, "a component is large"
        solution = solve(problem)
    except RestitutionError as error:
        return None, error.message
    why_not = objection(solution)
    return (None, why_not) if why_not else (solution, "")


def objection(solution: Solution) -> str:
    """Why a solved question may not be set to practise; nothing where it may."""
    from restitution.practice.questions.diagnosis import clash
    from restitution.practice.questions.nice import ugly_value

    if solution.error is not None:
        return solution.error.message
    if solution.problem.notes:
        return "its notation is doubtful"
    for item in (item for part in solution.parts.values() for item in part.items):
        if item.error is not None:
            return item.error.message
        if item.kind == "show" and item.holds is not True:
            return f"{item.text} does not hold"
        if len(item.distinct) > 1:
            return f"{item.text} has several answers"
    ugly = ugly_value(solution)
    if ugly:
        return f"{ugly} is no simple number"
    pair = clash(solution)
    return f"{pair} lead to the same answers" if pair is not None else ""
