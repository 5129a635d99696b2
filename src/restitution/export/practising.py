"""What a page that practises asks for: a question with its letters box, and how sure one is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from restitution.errors import StatementError
from restitution.export.lab.reading import a_list, an_object
from restitution.language import parse
from restitution.practice.letters.letters_box import letters_box
from restitution.practice.questions.choosing import next_question, sureness
from restitution.practice.questions.generate import practice_question
from restitution.practice.questions.shown_mistakes import shows
from restitution.practice.questions.topics import LEVELS, topic
from restitution.solving import solve

Object = dict[str, Any]

_ATTEMPTS = 2000
_LARGEST_SEED = 10**9
_LONGEST = 20_000  # characters of a statement


def asked(wanted: object) -> Object:
    """A question to practise.

    ``wanted`` may have a ``statement``, or a ``topic``, ``level`` and ``seed``; of these, what is
    missing is chosen by the ``attempts`` so far and the ``day``. The question is::

        {"statement", "topic", "level", "seed", "version": null for a statement of one's own,
         "letters": [{"letter", "meaning", "words", "turned", "turned_words"}]}

    Raises StatementError.
    """
    fields = an_object(wanted, "a question to practise")
    if "statement" in fields:
        return _own(_text(fields["statement"], "the statement", _LONGEST))
    attempts = a_list(fields.get("attempts", []), "attempts", _ATTEMPTS)
    following = next_question(attempts, _whole(fields.get("day", 0), "the day", 0, 10**8))
    name, level = following.topic, following.level
    if "topic" in fields:
        name = topic(_text(fields["topic"], "the topic", 60)).id
        level = LEVELS[0] if name != following.topic else level
    if "level" in fields:
        level = _whole(fields["level"], "the level", LEVELS[0], LEVELS[-1])
    tried = sum(_is_of(attempt, name, level) for attempt in attempts)
    seed = _whole(fields.get("seed", tried + 1), "the seed", 0, _LARGEST_SEED)
    mistake = None if "seed" in fields or name != following.topic else following.mistake
    if mistake is not None and not shows(mistake, name, level):
        mistake = None
    drawn = practice_question(name, level, seed, mistake)
    return {
        "statement": drawn.statement,
        "topic": name,
        "level": level,
        "seed": seed,
        "version": drawn.version,
        "letters": _letters(drawn.statement),
    }


def progress(record: object) -> Object:
    """How sure one is of each topic, 0 to 1, by ``attempts`` and ``day``. Raises StatementError."""
    fields = an_object(record, "a record")
    attempts = a_list(fields.get("attempts", []), "attempts", _ATTEMPTS)
    return {"sureness": sureness(attempts, _whole(fields.get("day", 0), "the day", 0, 10**8))}


def _own(statement: str) -> Object:
    nothing = dict.fromkeys(("topic", "level", "seed", "version"))
    return {"statement": statement, **nothing, "letters": _letters(statement)}


def _letters(statement: str) -> list[Object]:
    """The rows of the letters box, of all parts: a letter has one row."""
    problem = parse(statement)
    solution = solve(problem)
    rows = {
        row.letter: row.json()
        for label in reversed(list(solution.parts))
        for row in reversed(letters_box(problem, solution, label))
    }
    return list(reversed(rows.values()))


def _is_of(attempt: object, name: str, level: int) -> bool:
    return (
        isinstance(attempt, Mapping)
        and attempt.get("topic") == name
        and attempt.get("level") == level
    )


def _whole(value: object, what: str, least: int, most: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise StatementError(f"{what} is a whole number from {least} to {most}")
    return value


def _text(value: object, what: str, most: int) -> str:
    if not isinstance(value, str):
        raise StatementError(f"{what} is a text")
    if len(value) > most:
        raise StatementError(f"{what} has at most {most} characters, this one {len(value)}")
    return value
