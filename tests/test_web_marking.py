"""The API of marking and practice: its contract, its refusals, and that nothing typed is kept."""

from __future__ import annotations

import logging
from collections.abc import Iterator

import httpx
import pytest

from restitution.web import api, work

SPHERES = """\
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 1, velocity -4i + j
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
PARTS = """\
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/3
part a
find velocity(P)
part b
find impulse
"""
SLIP = "CLM: 2*3 + 4 = 2v + w\nw - v = 0.5(3 + 4)\nv = 13/6"
LETTERS = {"v": "along(velocity(A), i)", "w": "component of B along i after"}
OF_A_MARKING = {"part", "letters", "lines", "answers", "marks", "messages", "asks", "error"}
OF_A_LINE = {
    *("n", "text", "read_as", "verdict", "accuracy", "principle", "event", "link", "from"),
    "mistake",
}


@pytest.fixture(scope="module")
def client(served: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=served, timeout=100) as client:
        yield client


def marked(client: httpx.Client, working: str, **more: object) -> dict:
    body = {"statement": SPHERES, "working": working, **more}
    reply = client.post("/api/mark", json=body)
    assert reply.status_code == 200, reply.text
    return reply.json()


def refused(client: httpx.Client, what: str, status: int, **body: object) -> str:
    reply = client.post(f"/api/{what}", json=body)
    assert reply.status_code == status, reply.text
    return reply.json()["error"]["message"]


def test_every_key_is_always_there(client) -> None:
    for working in ("", SLIP, "hello", "= = =", "w = v\n\nq = 7"):
        marking = marked(client, working)
        assert set(marking) == OF_A_MARKING
        assert all(set(line) == OF_A_LINE for line in marking["lines"])
        counts = marking["marks"]
        assert counts["earned"] + counts["lost"] + counts["open"] == counts["of"]
        assert counts["of"] == len(counts["points"])


def test_a_mistake_is_found_at_its_line_and_the_rest_follows(client) -> None:
    marking = marked(client, SLIP, letters=LETTERS)
    assert [line["verdict"] for line in marking["lines"]] == ["false", "true", "follows"]
    assert marking["lines"][0]["mistake"]["id"] == "momentum-sign"
    assert {letter["by"] for letter in marking["letters"]} == {"declared"}
    assert marking["messages"] == []


def test_hints_are_given_for_all_lines_or_for_one(client) -> None:
    everywhere = marked(client, SLIP, letters=LETTERS, hints=1)["messages"]
    assert {message["line"] for message in everywhere} >= {1, 3}
    (only,) = marked(client, SLIP, letters=LETTERS, hints={"1": 3})["messages"]
    assert (only["line"], only["level"]) == (1, 3)


def test_parts_of_a_working_are_marked_each(client) -> None:
    working = "(a)\nv = 5i + j\n(b)\nI = 2(1 + 3) = 8"
    reply = marked(client, working, statement=PARTS)
    assert [part["part"] for part in reply["parts"]] == ["a", "b"]
    assert marked(client, "v = 5i + j", statement=PARTS, part="a")["part"] == "a"


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"statement": PARTS, "part": "z"}, "no part 'z'"),
        ({"letters": {"v": "blah of nothing"}}, "v"),
        ({"letters": {"v": 3}}, "v"),
        ({"hints": 7}, "levels 0 to 4"),
        ({"hints": {"1": "much"}}, "level"),
        ({"hints": {"first": 1}}, "by number"),
        ({"statement": "sphere A: mass"}, ""),
        ({"statement": SPHERES.replace("1/2", "3/2")}, "e"),
    ],
)
def test_what_cannot_be_marked_is_said(client, more, said) -> None:
    body = {"statement": SPHERES, "working": "v = 1", **more}
    assert said in refused(client, "mark", 422, **body)


@pytest.mark.parametrize(
    "more", [{"working": 3}, {"letters": []}, {"hints": "2"}, {"hints": True}, {"color": "red"}]
)
def test_what_is_no_request_is_refused(client, more) -> None:
    refused(client, "mark", 400, **{"statement": SPHERES, "working": "v = 1", **more})


def test_a_question_to_practise_is_the_same_for_the_same_seed(client) -> None:
    wanted = {"topic": "wall-forward", "level": 1, "seed": 4, "attempts": [], "day": 20_000}
    replies = [client.post("/api/practise", json={"wanted": wanted}).json() for _ in range(2)]
    assert replies[0] == replies[1]
    assert set(replies[0]) == {"statement", "topic", "level", "seed", "version", "letters"}
    solved = client.post("/api/solve", json={"statement": replies[0]["statement"]}).json()
    assert solved["error"] is None


@pytest.mark.parametrize(
    "wanted",
    [
        {"topic": "astrology"},
        {"topic": "wall-forward", "level": 9},
        {"topic": "wall-forward", "seed": -1},
        {"topic": 3},
        {"statement": 3},
        {"statement": "nonsense"},
        {"attempts": "many"},
        {"day": 1e9},
    ],
)
def test_a_question_that_cannot_be_had_is_said(client, wanted) -> None:
    assert refused(client, "practise", 422, wanted=wanted)


def test_how_sure_one_is_takes_any_record(client) -> None:
    odd = [None, 3, {}, {"topic": "wall-forward"}, {"topic": [], "level": "x"}]
    reply = client.post("/api/progress", json={"record": {"attempts": odd, "day": 20_000}})
    assert reply.status_code == 200
    assert set(reply.json()["sureness"].values()) == {0.0}


def test_the_motion_of_a_mistake_stands_beside_the_true_one(client) -> None:
    body = {"statement": SPHERES, "mistake": "momentum-sign/2"}
    motion = client.post("/api/mistake", json=body).json()["motion"]
    assert motion["motions"][0]["beside"]["says"]
    assert "did you mean" in refused(
        client, "mistake", 422, statement=SPHERES, mistake="momentum-sing"
    )


def test_nothing_that_is_typed_is_kept_or_logged(caplog) -> None:
    secret = "v = 123454321"
    with caplog.at_level(logging.DEBUG):
        reply = work.marked(SPHERES, 60, secret)
    assert reply.status == 200
    assert secret not in caplog.text
    assert [name for name, task in api._TASKS.items() if not task.kept] == [
        "mark",
        "practise",
        "progress",
        "experiment",
        "report",
    ]
