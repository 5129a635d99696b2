"""Practice as a conversation: a question, working, marks, a hint, the working, the next question.

What was done is plain data, for `choosing` and for a file that the user names.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import field
from typing import TYPE_CHECKING, Any, Literal

from restitution.errors import RestitutionError, StatementError, TimeLimitError
from restitution.explaining.mistakes.misconceptions import misconception
from restitution.practice.questions.choosing import next_question
from restitution.practice.questions.generate import MOST_SEED, PracticeQuestion, practice_question
from restitution.practice.questions.shown_mistakes import shows, topic_that_shows
from restitution.practice.questions.topics import LEVELS
from restitution.records import dataclass
from restitution.work import limited

if TYPE_CHECKING:
    from restitution.practice.marking.marking import Marking

Attempt = dict[str, Any]
Outcome = Literal["another", "next", "quit"]
Word = Literal["hint", "show", "another", "next", "quit", "help"]

_MARKING = 10.0  # seconds
_LATE = TimeLimitError("the working was not marked in time: take a line away, and try again")
_NO_HINT = "There is no hint for this: show gives the working."
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
    "help": "help",
    "words": "help",
}
GUIDE = (
    "Type your working, one step a line; an empty line hands it in.\n"
    "Words for you alone on a line: hint, show (the working), another (like this),\n"
    "next, quit, help (these words)."
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
        """Raises StatementError for a text that holds no such state."""
        if len(text) > _MOST_BYTES:
            raise StatementError("this is no file of practice: it is too long")
        try:
            data = json.loads(text)
        except (ValueError, RecursionError):
            raise StatementError("this is no file of practice: it is not JSON") from None
        if not isinstance(data, dict) or not isinstance(data.get("attempts"), list):
            raise StatementError("this is no file of practice: it has no list of attempts")
        opened = data.get("open")
        attempts = [attempt for attempt in data["attempts"] if isinstance(attempt, dict)]
        return State(attempts, opened if isinstance(opened, dict) else None)


@dataclass
class Progress:
    """How far a question is done: the part that is open, with the lines typed and not handed in,
    the lines of each part, and the whole working as each part was first handed in.
    """

    part: str | None = None
    draft: list[str] = field(default_factory=list)
    lines: dict[str | None, list[str]] = field(default_factory=dict)
    first: dict[str | None, list[str]] = field(default_factory=dict)

    def data(self) -> dict[str, Any]:
        """As plain data; the only part of a question is called by an empty text."""
        return {
            "part": self.part or "",
            "draft": self.draft,
            "lines": {label or "": typed for label, typed in self.lines.items()},
            "first": {label or "": typed for label, typed in self.first.items()},
        }

    @staticmethod
    def of(data: object) -> Progress:
        """From plain data; what is none is left out."""
        if not isinstance(data, dict):
            return Progress()
        lines, first = (_by_part(data.get(name)) for name in ("lines", "first"))
        return Progress(_text(data.get("part")) or None, _lines(data.get("draft")), lines, first)


def _by_part(value: object) -> dict[str | None, list[str]]:
    if not isinstance(value, dict):
        return {}
    return {_text(label) or None: _lines(typed) for label, typed in value.items()}


def _lines(value: object) -> list[str]:
    return [line for line in value if isinstance(line, str)] if isinstance(value, list) else []


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


def progress_of(state: State, question: PracticeQuestion) -> Progress:
    """How far a question is done that was left open; nothing of any other."""
    opened = state.open or {}
    same = (opened.get("topic"), opened.get("level"), opened.get("seed"))
    if same != (question.topic, question.level, question.seed):
        return Progress()
    return Progress.of(opened.get("progress"))


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
    if wanted.mistake is not None:
        mistake = misconception(wanted.mistake).id
        if wanted.topic is None:
            topic = topic_that_shows(mistake, topic, level)
    elif mistake is not None and not shows(mistake, topic, level):
        mistake = None
    return practice_question(topic, level, number, mistake)


def _level_in(state: State, topic: str) -> int:
    """The level of the last attempt in a topic, or the first."""
    for attempt in reversed(state.attempts):
        if attempt.get("topic") == topic and attempt.get("level") in LEVELS:
            return int(attempt["level"])
    return LEVELS[0]


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""


def _whole(value: object) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) else -1


def another(question: PracticeQuestion) -> PracticeQuestion:
    """Another question like one: the next seed."""
    return practice_question(question.topic, question.level, (question.seed + 1) % MOST_SEED)


# --- one question -------------------------------------------------------------------------------


def _nothing_to_keep() -> None:
    """What keeps a conversation that is kept nowhere."""


@dataclass
class Conversation:
    """One question being worked on.

    ``read`` gives the next line, or None at the end of the input; ``write`` shows a text, and
    ``keep`` is called whenever the progress is another.
    """

    question: PracticeQuestion
    read: Callable[[str], str | None]
    write: Callable[[str], None]
    width: int = 80
    progress: Progress = field(default_factory=Progress)
    first: dict[str | None, Marking] = field(default_factory=dict)
    hinted: tuple[str, ...] = ()
    ended: bool = False
    keep: Callable[[], None] = _nothing_to_keep

    @property
    def lines(self) -> dict[str | None, list[str]]:
        """What was typed, part by part."""
        return self.progress.lines

    def hold(self) -> Outcome:
        """Ask every part from the one that is open on, and say what is wanted next."""
        from restitution.wording import to_text

        self.write(to_text(self.question.question, self.width))
        labels = [part.label for part in self.question.question.parts if part.marks is not None]
        self._mark_again(labels or [None])
        if self.progress.part in labels:
            labels = labels[labels.index(self.progress.part) :]
        for label in labels or [None]:
            if label != self.progress.part:
                self.progress.part, self.progress.draft = label, []
                self.keep()
            outcome = self._part(label)
            if outcome is not None:
                return outcome
        return self._end()

    def _part(self, label: str | None) -> Outcome | None:
        """One part, until it is right or left; what is wanted where the question is left."""
        if label is not None:
            self.write(f"Part ({label})")
        level, handed_in = 0, label in self.progress.first
        draft = self.progress.draft
        typed = draft or self.lines.get(label, [])
        if typed:
            head = "Your lines so far:" if draft else "Handed in:"
            self.write("\n".join((head, *(f"> {line}" for line in typed))))
        while True:
            before = len(draft)
            word = self._working(draft)
            level = level if len(draft) == before else 0
            if word == "help":
                self.write(GUIDE)
            elif word == "show":
                self.write(self._solution(label))
                return None
            elif word == "hint":
                level = self._hint(label, draft or self.lines.get(label, []), level)
            elif word is not None:
                return word
            elif draft:
                marking, handed_in = self._mark(label, list(draft), 0), True
                draft.clear()
                self.keep()
                if marking is not None and marking.marks.earned == marking.marks.of:
                    return None
                self.write("Try again, or an empty line to go on. (hint, show)")
            elif handed_in:
                return None
            else:
                self.write("Nothing was typed: hint, show, next or quit?")
                handed_in = True

    def _working(self, draft: list[str]) -> Word | None:
        """Adds lines to a draft up to an empty one; the word that ended them instead, or None."""
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
            self.keep()

    def _mark(self, label: str | None, typed: list[str], hints: int) -> Marking | None:
        """The marks of a part, shown but for hints; None where it cannot be marked, as is told."""
        from restitution.practice.marking.marking import mark

        if typed:
            self.lines[label] = list(typed)
        try:
            with limited(_MARKING, error=_LATE):
                working = self.lines if typed else {label: [_NOTHING]}
                marking = mark(self.question.solution, working, label, hints=hints)
        except RestitutionError as error:
            self.write(error.message)
            return None
        if hints:
            return marking
        self.write(str(marking))
        if typed and label not in self.first:
            self.first[label] = marking
            self.progress.first[label] = list(self._script())
        return marking

    def _mark_again(self, labels: Sequence[str | None]) -> None:
        """The marks at the first go of what was handed in before the question was left open."""
        from restitution.practice.marking.marking import mark

        for label in labels:
            script = self.progress.first.get(label)
            if script is not None:
                with suppress(RestitutionError), limited(_MARKING, error=_LATE):
                    self.first[label] = mark(self.question.solution, script, label)

    def _hint(self, label: str | None, typed: list[str], level: int) -> int:
        """The first hint above a level that says more than that at the level; its own level."""
        from restitution.render.text import with_whole_formulas, wrapped

        before = self.hinted if level else ()
        for longer in range(level + 1, 5):
            hints = self._hints(label, typed, longer)
            if hints is None:
                return level
            if hints and hints != before:
                whole = [with_whole_formulas(text, self.width) for text in hints]
                lines = [line for text in whole for line in wrapped(text, self.width)]
                self.write("\n".join(lines))
                self.hinted = hints
                return longer
        none = "There is no longer hint: show gives the working." if level else _NO_HINT
        self.write(none)
        return level

    def _hints(self, label: str | None, typed: list[str], level: int) -> tuple[str, ...] | None:
        """The hints at a level; None where the working cannot be marked, which is told."""
        marking = self._mark(label, typed, level)
        if marking is None:
            return None
        return tuple(
            dict.fromkeys(
                text if message.line is None else f"Line {message.line}: {text}"
                for message in marking.messages
                if (text := message.text)
            )
        )

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
        self.ended = True
        earned = sum(marking.marks.earned for marking in self.first.values())
        self.write(f"{earned} of {self.question.marks} marks at the first go.")
        while True:
            line = self.read("Another like this, next (an empty line), show or quit? ")
            if line is None:
                return "quit"
            word = WORDS.get(line.strip().lower(), None if line.strip() else "next")
            if word == "show":
                self.write(self._solution(None))
            elif word == "help":
                self.write("Words: another (a question like this), next, show (the working), quit.")
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
                point.point.letter == "M" and point.state == "lost" for point in points
            ),
            "mistakes": list(dict.fromkeys(n for marking in markings for n in marking.mistakes)),
        }
