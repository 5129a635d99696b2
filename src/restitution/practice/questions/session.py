"""Practice as a conversation: a question, working, marks, a hint, the working, the next question.

What was done is plain data, for `choosing` and for a file that the user names.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from restitution.errors import RestitutionError, StatementError, TimeLimitError
from restitution.practice.questions.choosing import next_question
from restitution.practice.questions.generate import MOST_SEED, PracticeQuestion, practice_question
from restitution.practice.questions.topics import LEVELS
from restitution.work import limited

if TYPE_CHECKING:
    from restitution.practice.marking.marking import Marking

Attempt = dict[str, Any]
Outcome = Literal["another", "next", "quit"]
Word = Literal["hint", "show", "another", "next", "quit"]

_MARKING = 10.0  # seconds
_LATE = TimeLimitError("the working was not marked in time: take a line away, and try again")
_NOTHING = "nothing yet"  # a remark, so that the first step may be hinted at
_MOST_BYTES = 4_000_000
WORDS: dict[str, Word] = {
    "hint": "hint",
    "?": "hint",
    "show": "show",
    "working": "show",
    "another": "another",
    "next": "next",
    "skip": "next",
    "quit": "quit",
    "q": "quit",
    "exit": "quit",
}
GUIDE = (
    "Type your working, one step a line; an empty line hands it in.\n"
    "Words for you alone on a line: hint, show (the working), another (like this),\n"
    "next, quit."
)


@dataclass
class State:
    """What a user has done, and the question that is open."""

    attempts: list[Attempt] = field(default_factory=list)
    open: dict[str, Any] | None = None

    def to_json(self) -> str:
        return json.dumps({"version": 1, "attempts": self.attempts, "open": self.open}, indent=1)

    @staticmethod
    def of_json(text: str) -> State:
        """Raises StatementError for a text that is no such state."""
        if len(text) > _MOST_BYTES:
            raise StatementError("this is no file of practice: it is too long")
        try:
            data = json.loads(text)
        except (ValueError, RecursionError):
            raise StatementError("this is no file of practice: it is not JSON") from None
        if not isinstance(data, dict) or not isinstance(data.get("attempts"), list):
            raise StatementError("this is no file of practice: it has no list of attempts")
        opened = data.get("open")
        attempts = [each for each in data["attempts"] if isinstance(each, dict)]
        return State(attempts, opened if isinstance(opened, dict) else None)


@dataclass(frozen=True)
class Wanted:
    """What is asked for when practice begins; None is chosen from what was done."""

    topic: str | None = None
    level: int | None = None
    seed: int | None = None
    mistake: str | None = None


def first_question(wanted: Wanted, state: State, day: int, seed: int) -> PracticeQuestion:
    """The question with which practice begins: one that was left open, or the next one.

    ``seed`` is taken where none is wanted.
    """
    opened = state.open
    if opened is not None and wanted == Wanted():
        try:
            return practice_question(
                _text(opened.get("topic")),
                _whole(opened.get("level")),
                _whole(opened.get("seed")),
                opened.get("mistake") if isinstance(opened.get("mistake"), str) else None,
            )
        except RestitutionError:
            state.open = None
    return chosen(wanted, state, day, seed)


def chosen(wanted: Wanted, state: State, day: int, seed: int) -> PracticeQuestion:
    """The next question, by what is wanted and what was done."""
    following = next_question(state.attempts, day)
    topic, level, mistake = following
    if wanted.topic is not None:
        topic, mistake = (
            wanted.topic,
            following.mistake if wanted.topic == following.topic else None,
        )
        level = following.level if mistake else _level_in(state, topic)
    if wanted.level is not None:
        level = wanted.level
    number = seed if wanted.seed is None else wanted.seed
    return practice_question(topic, level, number, wanted.mistake or mistake)


def _level_in(state: State, topic: str) -> int:
    """The level of the last attempt in a topic, or the first."""
    for each in reversed(state.attempts):
        if each.get("topic") == topic and each.get("level") in LEVELS:
            return int(each["level"])
    return LEVELS[0]


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""


def _whole(value: object) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) else -1


def another(question: PracticeQuestion) -> PracticeQuestion:
    """Another question like one: the next seed."""
    return practice_question(question.topic, question.level, (question.seed + 1) % MOST_SEED)


# --- one question -------------------------------------------------------------------------------


@dataclass
class Conversation:
    """One question being worked on.

    ``read`` gives the next line, or None at the end of the input; ``write`` shows a text.
    """

    question: PracticeQuestion
    read: Callable[[str], str | None]
    write: Callable[[str], None]
    width: int = 80
    lines: dict[str | None, list[str]] = field(default_factory=dict)
    first: dict[str | None, Marking] = field(default_factory=dict)

    def hold(self) -> Outcome:
        """Ask every part, and say what is wanted next."""
        from restitution.wording import to_text

        self.write(to_text(self.question.question, self.width))
        labels = [part.label for part in self.question.question.parts if part.marks is not None]
        for label in labels or [None]:
            outcome = self._part(label)
            if outcome is not None:
                return outcome
        return self._end()

    def _part(self, label: str | None) -> Outcome | None:
        """One part, until it is right or left; what is wanted where the question is left."""
        if label is not None:
            self.write(f"Part ({label})")
        level, handed_in = 0, False
        draft: list[str] = []
        while True:
            before = len(draft)
            word = self._working(draft)
            level = level if len(draft) == before else 0
            if word == "show":
                self.write(self._solution(label))
                return None
            if word == "hint":
                level = min(level + 1, 4)
                self._mark(label, draft or self.lines.get(label, []), level)
            elif word is not None:
                return word
            elif draft:
                marking, draft, handed_in = self._mark(label, draft, 0), [], True
                if marking is not None and marking.marks.earned == marking.marks.of:
                    return None
                self.write("Try again, or an empty line to go on. (hint, show)")
            elif handed_in:
                return None
            else:
                self.write("Nothing was typed: hint, show, next or quit?")
                handed_in = True

    def _working(self, draft: list[str]) -> Word | None:
        """Add lines to a draft up to an empty one; the word that ended them instead, if one did."""
        while True:
            line = self.read("> ")
            if line is None:
                return None if draft else "quit"
            if not line.strip():
                return None
            word = WORDS.get(line.strip().lower())
            if word is not None:
                return word
            draft.append(line)

    def _mark(self, label: str | None, typed: list[str], hints: int) -> Marking | None:
        """The marks of a part, shown; None where it cannot be marked, which is told."""
        from restitution.practice.marking.marking import mark
        from restitution.render.text import wrapped

        if typed:
            self.lines[label] = typed
        try:
            with limited(_MARKING, error=_LATE):
                script = list(self._script()) if typed else [_NOTHING]
                marking = mark(self.question.solution, script, label, hints=hints)
        except RestitutionError as error:
            self.write(error.message)
            return None
        if hints:
            own = dict.fromkeys(message.text for message in marking.messages if message.text)
            lines = [line for text in own for line in wrapped(text, self.width)]
            self.write("\n".join(lines) or "There is no hint for this.")
            return marking
        self.write(str(marking))
        if typed:
            self.first.setdefault(label, marking)
        return marking

    def _script(self) -> Iterable[str]:
        """All that was typed so far, part by part."""
        for label, typed in self.lines.items():
            if label is not None:
                yield f"({label})"
            yield from typed

    def _solution(self, label: str | None) -> str:
        from restitution.workings import explain, to_text

        explanation = explain(self.question.solution, label)
        return to_text(explanation, self.width)

    def _end(self) -> Outcome:
        earned = sum(marking.marks.earned for marking in self.first.values())
        self.write(f"{earned} of {self.question.marks} marks at the first go.")
        while True:
            line = self.read("Another like this, next (an empty line), show or quit? ")
            if line is None:
                return "quit"
            word = WORDS.get(line.strip().lower(), None if line.strip() else "next")
            if word == "show":
                self.write(self._solution(None))
            elif word is not None and word != "hint":
                return word

    def attempt(self, day: int) -> Attempt | None:
        """What came of it, as data for `choosing`; None where nothing was handed in."""
        if not self.first:
            return None
        markings = self.first.values()
        points = [point for marking in markings for point in marking.marks.points]
        return {
            "topic": self.question.topic,
            "level": self.question.level,
            "seed": self.question.seed,
            "day": day,
            "earned": sum(marking.marks.earned for marking in markings),
            "of": max(self.question.marks, sum(marking.marks.of for marking in markings)),
            "lost_method": any(
                each.point.letter == "M" and each.state == "lost" for each in points
            ),
            "mistakes": list(dict.fromkeys(n for marking in markings for n in marking.mistakes)),
        }
