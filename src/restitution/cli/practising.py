"""The command ``practise``: questions in the terminal, or as statements in a file."""

from __future__ import annotations

import sys
import time
from datetime import datetime
from functools import partial
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING

from restitution.cli.files import parse, pointed, read, say, shown_name, terminal_width
from restitution.cli.output import put, write_file
from restitution.cli.statuses import UNANSWERED, UNREADABLE
from restitution.errors import RestitutionError, StatementError
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.practice.questions.generate import PracticeQuestion
    from restitution.practice.questions.session import Conversation, Progress, State, Wanted
    from restitution.problem import Problem

_SEEDS = 1_000_000  # of those that are taken where none is wanted


@dataclass(frozen=True)
class Practising:
    """What the command was asked for."""

    topic: str | None = None
    level: int | None = None
    seed: int | None = None
    like: str | None = None
    output: str | None = None
    state: str | None = None
    mistake: str | None = None


def list_topics() -> None:
    """Writes down the topics by group, with their ids, no wider than the terminal."""
    from restitution.practice.questions.topics import TOPICS

    group = ""
    longest = max(len(topic.id) for topic in TOPICS)
    width = terminal_width()
    for topic in TOPICS:
        if topic.group != group:
            group = topic.group
            put(f"{group}\n")
        start = f"  {topic.id:<{longest}}  "
        rows = wrap(topic.asks, width, initial_indent=start, subsequent_indent=" " * len(start))
        put("".join(f"{row}\n" for row in rows))


def practise(asked: Practising) -> int:
    """Does what was asked, and gives the exit status."""
    try:
        if asked.like is not None:
            return _like(asked, asked.like)
        state = _State(asked.state)
        if asked.output is not None:
            question = _chosen(asked, state.state)
            write_file(asked.output, question.statement.encode(), [])
            return 0
        return _hold(asked, state)
    except StatementError as error:
        say(error.message)
        return UNREADABLE
    except RestitutionError as error:
        say(error.message)
        return UNANSWERED


def _like(asked: Practising, file: str) -> int:
    """One like a statement, to be written down; without a file for it, to be practised."""
    from restitution.practice.questions.varying import variant

    text = read(file)
    try:
        problem = parse(text)
    except StatementError as error:
        for message in pointed(file, text, error):
            say(message)
        return UNREADABLE
    seed = _seed(asked)
    varied = variant(problem, seed)
    for note in varied.notes:
        say(f"{shown_name(file)}: {note}")
    if asked.output is None and file != "-":
        return _hold_like(file, problem, seed, varied.statement)
    write_file(asked.output or "-", varied.statement.encode(), [] if file == "-" else [file])
    return 0


def _hold_like(file: str, problem: Problem, seed: int, statement: str) -> int:
    """Questions like a statement, one after the other, until the user ends it.

    ``statement`` is the first of them, of that seed.
    """
    from restitution.practice.questions.generate import PracticeQuestion
    from restitution.practice.questions.session import GUIDE, Conversation
    from restitution.practice.questions.varying import variant

    width = min(terminal_width(), 80)
    put(f"{GUIDE}\n\n")
    try:
        while True:
            put(f"--- Like {shown_name(file)}, seed {seed} ---\n\n")
            question = PracticeQuestion("", 0, seed, statement)
            if Conversation(question, _line, _shown, width).hold() == "quit":
                break
            seed += 1
            statement = variant(problem, seed).statement
    except KeyboardInterrupt:
        put("\n")
    again = f"restitution practise --like {shown_name(file)} --seed {seed}"
    put(f"Good-bye. Go on with: {again}\n")
    return 0


def _seed(asked: Practising) -> int:
    return time.time_ns() // 1000 % _SEEDS if asked.seed is None else asked.seed


def _chosen(asked: Practising, state: State) -> PracticeQuestion:
    from restitution.practice.questions.session import Wanted, first_question

    wanted = Wanted(asked.topic, asked.level, asked.seed, asked.mistake)
    return first_question(wanted, state, _today(), _seed(asked))


def _today() -> int:
    """The day by the user's own calendar."""
    return datetime.now().astimezone().date().toordinal()


class _State:
    """The state of practice in the file that the user named; without one, for this time alone."""

    def __init__(self, file: str | None) -> None:
        from restitution.practice.questions.session import State

        self.path = None if file is None else Path(file)
        self.state = State()
        if self.path is not None and self.path.exists():
            try:
                self.state = State.of_json(self.path.read_text(encoding="utf-8", errors="replace"))
            except OSError as error:
                raise StatementError(f"{file}: cannot be read: {error.strerror}") from None
            except StatementError as error:
                raise StatementError(f"{file}: {error.message}") from None

    def keep(self) -> None:
        """Writes it down, all or nothing."""
        if self.path is None:
            return
        beside = self.path.with_name(self.path.name + ".new")
        try:
            beside.write_text(self.state.to_json(), encoding="utf-8")
            beside.replace(self.path)
        except OSError as error:
            raise StatementError(f"{self.path}: cannot be written: {error.strerror}") from None


def _hold(asked: Practising, kept: _State) -> int:
    """Question after question, until the user ends it."""
    from restitution.practice.questions.session import (
        GUIDE,
        Conversation,
        Progress,
        another,
        chosen,
        progress_of,
    )

    question = _chosen(asked, kept.state)
    progress = progress_of(kept.state, question)
    width = min(terminal_width(), 80)
    put(f"{GUIDE}\n\n")
    conversation = None
    try:
        while True:
            _leave_open(kept, question, progress)
            put(f"{_heading(question)}\n\n")
            keep = partial(_leave_open, kept, question, progress)
            conversation = Conversation(question, _line, _shown, width, progress, keep=keep)
            outcome = conversation.hold()
            if outcome == "quit" and not conversation.ended:
                _leave_open(kept, question, progress)
                break
            _remember(kept, conversation)
            if outcome == "quit":
                break
            progress = Progress()
            following = asked if asked.seed is None else Practising(asked.topic, asked.level)
            question = (
                another(question)
                if outcome == "another"
                else chosen(
                    _wanted(following),
                    kept.state,
                    _today(),
                    _seed(following),
                )
            )
    except KeyboardInterrupt:
        put("\n")
        if conversation is not None and conversation.ended:
            _remember(kept, conversation)
        else:
            _leave_open(kept, question, progress)
    put(_farewell(question, kept))
    return 0


def _wanted(asked: Practising) -> Wanted:
    from restitution.practice.questions.session import Wanted

    return Wanted(asked.topic, asked.level, None, asked.mistake)


def _remember(kept: _State, conversation: Conversation) -> None:
    attempt = conversation.attempt(_today())
    if attempt is not None:
        kept.state.attempts.append(attempt)
        kept.state.open = None
        kept.keep()


def _leave_open(kept: _State, question: PracticeQuestion, progress: Progress) -> None:
    """Note the question that is open, so that the next start goes on where it was left."""
    kept.state.open = {
        "topic": question.topic,
        "level": question.level,
        "seed": question.seed,
        "mistake": question.mistake,
        "progress": progress.data(),
    }
    kept.keep()


def _heading(question: PracticeQuestion) -> str:
    from restitution.practice.questions.topics import topic

    title = topic(question.topic).title
    return f"--- {title}, level {question.level}, seed {question.seed} ---"


def _farewell(question: PracticeQuestion, kept: _State) -> str:
    if kept.path is not None:
        return f"Good-bye. Go on with: restitution practise --state {kept.path}\n"
    return (
        f"Good-bye. Go on with: restitution practise {question.topic} --level {question.level} "
        f"--seed {question.seed}\n"
    )


def _line(prompt: str) -> str | None:
    """The next line of the input; None at its end."""
    if sys.stdin.isatty():
        try:
            return input(prompt)
        except EOFError:
            return None
    line = sys.stdin.readline(10_000)
    return line.rstrip("\n") if line else None


def _shown(text: str) -> None:
    put(f"{text}\n\n")
