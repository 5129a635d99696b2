"""The API of experiments: its contract and its refusals."""

from __future__ import annotations

from collections.abc import Iterator

import httpx
import pytest

WALL = "alpha,beta\n30,22\n45,36\n60,50\n"


@pytest.fixture(scope="module")
def client(served: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=served, timeout=100) as client:
        yield client


def test_a_table_gives_the_result_of_the_library_in_words_and_pictures(client) -> None:
    import restitution

    reply = client.post("/api/experiment", json={"data": WALL, "angle_error": 1})
    assert reply.status_code == 200, reply.text
    content = reply.json()
    own = restitution.experiment(WALL, angle_error=1)
    assert content["e"] == pytest.approx(own.e)
    assert content["interval"]["low"] == pytest.approx(own.interval.low)
    assert content["words"][0] == f"e = {own.e:.3f} ± {own.standard_error:.3f}"
    assert [check["id"] for check in content["checks"]] == [check.id for check in own.checks]
    assert content["pictures_error"] is None
    for picture in content["pictures"]:
        assert picture["svg"].lstrip().startswith("<svg"), picture["svg"][:80]
        assert picture["title"]
        assert picture["description"]
    assert content["pictures"]


def test_angles_from_the_normal_are_turned(client) -> None:
    turned = "alpha,beta\n60,68\n45,54\n30,40\n"
    own, other = (
        client.post("/api/experiment", json=body).json()["e"]
        for body in ({"data": WALL}, {"data": turned, "from_normal": True})
    )
    assert own == pytest.approx(other)


@pytest.mark.parametrize(
    ("body", "status", "words"),
    [
        ({}, 400, '"data"'),
        ({"data": 3}, 400, "a text"),
        ({"data": WALL, "angle_error": "1"}, 400, "a number"),
        ({"data": WALL, "angle_error": True}, 400, "a number"),
        ({"data": WALL, "angle_error": -1}, 422, "more than 0"),
        ({"data": WALL, "angle_error": 10**400}, 422, "more than 0"),
        ({"data": WALL, "kind": "floor"}, 400, "kind"),
        ({"data": WALL, "kind": "tracks"}, 422, "no column"),
        ({"data": ""}, 422, "empty"),
        ({"data": "alpha,beta\n"}, 422, "no rows"),
        ({"data": "alpha,beta\nx,y\n"}, 422, "no number"),
        ({"data": "\0"}, 422, "code 0"),
        ({"data": WALL, "more": 1}, 400, "not known"),
    ],
)
def test_what_is_no_experiment_is_refused_with_its_reason(client, body, status, words) -> None:
    reply = client.post("/api/experiment", json=body)
    assert reply.status_code == status, reply.text
    assert words in reply.json()["error"]["message"]


def test_a_bad_row_is_left_out_and_named(client) -> None:
    content = client.post("/api/experiment", json={"data": WALL + "50,x\n"}).json()
    (fault,) = content["table"]["faults"]
    assert fault["message"] == "line 5, column beta: 'x': this is no number"
    assert len(content["points"]) == 3


def test_a_report_is_a_pdf_or_says_why_there_is_none(client) -> None:
    from io import BytesIO

    from pypdf import PdfReader

    reply = client.post("/api/report", json={"data": WALL, "angle_error": 1})
    assert reply.headers["content-type"] == "application/pdf"
    text = "".join(page.extract_text() for page in PdfReader(BytesIO(reply.content)).pages)
    assert "Check of the model" in text
    reply = client.post("/api/report", json={"data": "alpha,beta\nx,y"})
    assert reply.status_code == 422
    assert "no row can be read" in reply.json()["error"]["message"]
