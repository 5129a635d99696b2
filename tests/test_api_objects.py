"""What is written as JSON has the fields and types that are told of it."""

from __future__ import annotations

import gzip
import json
from typing import Any

import api_objects
import pytest
from typeguard import CollectionCheckStrategy, TypeCheckError, check_type

import restitution
from restitution import examples
from restitution.export.job import Job, Writing, serve
from restitution.export.objects import (
    AlteredObject,
    CheckedObject,
    DrawnObject,
    ExplainedObject,
    FailedObject,
    OutlinedObject,
    SolvedObject,
    WorkedObject,
)
from restitution.practice.marking.objects import MarkingObject, PartsMarkedObject
from restitution.web import work

UNREADABLE = "sphere A: mas 2\nwall W: along i\nA hits V: e = 1/2"
REFUTED = "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow speed(P) < u/2"
CASES = "wall W: along i\nsphere P: mass 1, velocity -u j\nP hits W\ngiven impulse = 50\nfind e"
STATEMENTS = {
    **{
        name: examples.text(name)
        for name in ("corner", "two-unknown-angles", "greatest-deflection")
    },
    "unreadable": UNREADABLE,
    "refuted": REFUTED,
    "cases": CASES,
    "missing": "wall W: along j\nsphere P: velocity 2i\nP hits W: e = 1\nfind impulse",
}


def fits(content: Any, kind: Any) -> None:
    """Raises TypeCheckError where a field is missing, one too many, or of another type."""
    check_type(content, kind, collection_check_strategy=CollectionCheckStrategy.ALL_ITEMS)


def reply(payload: work.Payload) -> Any:
    """The object of a reply, unpacked."""
    content = gzip.decompress(payload.content) if payload.packed else payload.content
    return json.loads(content)


def test_page_is_up_to_date() -> None:
    """The page says what the types say: ``uv run python scripts/api_objects.py`` writes it."""
    assert api_objects.PAGE.read_text(encoding="utf-8") == api_objects.page()


@pytest.mark.parametrize("statement", STATEMENTS.values(), ids=STATEMENTS)
def test_replies_about_a_statement(statement: str) -> None:
    fits(reply(work.solved(statement, 60)), SolvedObject)
    fits(reply(work.solved(statement, 60, working=True)), WorkedObject)
    fits(reply(work.checked(statement)), CheckedObject)
    fits(reply(work.outlined(statement)), OutlinedObject)
    fits(reply(work.drawn(statement, 60)), DrawnObject)
    fits(reply(work.explained(statement, 60)), ExplainedObject)


@pytest.mark.parametrize("name", examples.names())
def test_pieces_of_an_example(name: str) -> None:
    """Steps of every kind are told as they are said to be."""
    outlined = reply(work.outlined(examples.text(name)))
    fits(outlined, OutlinedObject)
    for step in outlined["outline"]["steps"]:
        assert {"kind", "part", "line", "after"} <= step.keys()


def test_replies_about_a_working() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 5i - 3j\nP hits W: e = 1/3\n"
    working = "v = 1\nspeed = 5.01\nI = 2(3 + 1) = 8\nq = 3"
    once = reply(work.marked(f"{statement}find speed(P), impulse", 60, working, hints=4))
    fits(once, MarkingObject)
    assert once["lines"], "nothing was read"
    twice = reply(
        work.marked(
            f"{statement}part a\nfind speed(P)\npart b\nfind impulse",
            60,
            "(a)\nspeed = 5.10\n(b)\nI = 8",
        )
    )
    fits(twice, PartsMarkedObject)
    fits(reply(work.marked(UNREADABLE, 60, working)), FailedObject)


def test_answers_in_an_altered_world() -> None:
    problem = restitution.parse(examples.text("corner"))
    task = Writing("json", mistake="restitution-parallel")
    fits(json.loads(serve(Job("corner", problem, task)).content), AlteredObject)


def test_another_object_does_not_fit() -> None:
    """The check sees a field that is missing, one too many or of another type, far inside."""
    right = reply(work.solved(CASES, 60))
    answer = right["parts"][0]["items"][0]["answers"][0]
    for change in ({"exact": 3}, {"more": 1}):
        kept = dict(answer)
        answer.update(change)
        with pytest.raises(TypeCheckError):
            fits(right, SolvedObject)
        answer.clear()
        answer.update(kept)
    del answer["display"]
    with pytest.raises(TypeCheckError):
        fits(right, SolvedObject)
