"""The API and what guards it: the same answers as the command, clear refusals, no way to harm."""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from unittest import mock

import httpx
import pytest
from hosts import static_of
from loops import completed
from pypdf import PdfReader
from serving import serving
from test_hostile import STATEMENTS as HOSTILE

from restitution import examples
from restitution.killable import LostError
from restitution.render.markup import element, to_markup, together
from restitution.web import Settings, api
from restitution.web.pool import BusyError, pool
from restitution.web.replies import Replies
from restitution.web.serving import listening, reach
from restitution.web.work import Payload

STATEMENT = examples.text("two-spheres-with-vectors")
UNFINISHED = "sphere P: velocity 2i\nwall W: along j\nP hits W: e = 1/2\nfind impulse, speed(P)\n"
UNREADABLE = "sphere A: mass 2, velocity 3i - 4j\nspher B: mass 3\nA hits C: along j\n"


@pytest.fixture(scope="module")
def client(served: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=served, timeout=100) as client:
        yield client


def said(client: httpx.Client, what: str, statement: str, **more: object) -> httpx.Response:
    """The reply, of which nothing is left out for want of time."""
    reply = client.post(f"/api/{what}", json={"statement": statement, **more})
    assert not re.search("time limit|no time left|left out: there was no time", reply.text)
    return reply


def command(statement: str, *arguments: str) -> dict:
    """What the command says of a statement, in JSON."""
    done = subprocess.run(
        [
            *(sys.executable, "-m", "restitution", "solve", "-"),
            *("--format", "json", "--time-limit", "50", *arguments),
        ],
        input=statement,
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    return json.loads(done.stdout)


# --- in pieces ------------------------------------------------------------------------------------


def test_a_statement_is_taken_apart(client) -> None:
    """Bodies and steps as text, stages as numbers; or the mistakes."""
    found = said(
        client,
        "outline",
        "sphere A, B: mass 2m\nsphere A: velocity -3u cos(alpha) i - 4j\nsphere B: at rest\n"
        "wall W: along 60°\nA hits B: along j, e = 3/7\nfind speed(A), impulse\nB hits W\n"
        "given energy_lost = 3\nunknown μ\nfind speed(B, before), direction(W)\n"
        "show A at rest\n",
    ).json()
    assert found["errors"] == []
    told = found["outline"]
    assert [each["mass"] for each in told["spheres"]] == ["2m", "2m"]
    assert told["spheres"][0]["velocity"] == {
        "way": "components",
        "x": "-3u cos(alpha)",
        "y": "-4",
    }
    assert told["spheres"][1]["velocity"] == {"way": "rest"}
    assert told["walls"][0]["along"] == {"way": "angle", "text": "60°"}
    steps = told["steps"]
    assert [each["kind"] for each in steps] == [
        *("impact", "find", "impact", "given", "unknown", "find", "show")
    ]
    assert [each["staged"] for each in steps[1]["items"]] == ["speed(A, 1)", "impulse(1)"]
    assert (steps[3]["relations"][0]["left"], steps[3]["relations"][0]["right"]) == (
        "energy_lost(2)",
        "3",
    )
    assert steps[4]["letters"] == "μ"
    assert [each["staged"] for each in steps[5]["items"]] == ["speed(B, 1)", "direction(W)"]
    assert steps[6]["relations"][0]["staged"] is None
    found = said(client, "outline", UNREADABLE).json()
    assert found["outline"] is None
    assert [each["line"] for each in found["errors"]]


# --- answers --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "statement",
    [
        STATEMENT,
        examples.text("corner"),
        examples.text("rejected-root"),
        examples.text("range-of-deflection"),
        UNFINISHED,
        UNREADABLE,
        "",
    ],
)
def test_same_contract_as_the_command(client, statement):
    wanted = {**command(statement), "file": "statement"}
    assert said(client, "solve", statement).json() == wanted
    assert said(client, "explain", statement).json()["answer"] == wanted
    drawn = said(client, "draw", statement).json()
    assert {name: drawn[name] for name in wanted} == wanted


def test_the_working_comes_as_data_where_it_is_asked_for(client):
    plain = said(client, "solve", STATEMENT).json()
    assert all("derivation" not in part for part in plain["parts"])
    for statement in (STATEMENT, UNFINISHED):
        reply = said(client, "solve", statement, working=True).json()
        assert {**reply, "file": "-"} == command(statement, "--working")
        assert all("derivation" in part for part in reply["parts"])
    assert said(client, "solve", UNREADABLE, working=True).json()["parts"] == []


def test_styles_of_marks_are_named(client):
    reply = client.post("/api/sheet", json={"statement": "", "marks": "ocr"})
    message = '"marks" has to be one of "fm1", "m4", "caie", "none"'
    assert (reply.status_code, reply.json()["error"]["message"]) == (400, message)


def test_one_part(client):
    name = next(n for n in examples.names() if "\npart b" in examples.text(n))
    wanted = {**command(examples.text(name), "--part", "b"), "file": "statement"}
    assert said(client, "solve", examples.text(name), part="b").json() == wanted
    missing = said(client, "solve", examples.text(name), part="nought").json()
    assert "there is no part 'nought'" in missing["error"]["message"]


def test_check_tells_all_mistakes_with_their_places(client):
    found = said(client, "check", UNREADABLE).json()
    assert [(each["line"], each["column"]) for each in found["errors"]] == [(2, 1), (3, 8)]
    assert found["error"] == found["errors"][0]
    assert "did you mean 'sphere'?" in found["error"]["message"]


def test_check_of_what_reads_well(client):
    found = said(client, "check", UNFINISHED).json()
    assert found["errors"] == []
    assert found["error"] is None
    (part,) = found["parts"]
    assert [item["text"] for item in part["items"]] == ["impulse", "speed(P)"]
    assert all(item["answers"] == [] and item["error"] is None for item in part["items"])


def test_check_warns(client):
    found = said(client, "check", "sphere P: velocity u i\nlet k = u^2/2g\nfind k\n").json()
    assert any("2g" in warning for warning in found["warnings"])


def texts(of: object) -> str:
    """All that a tree says."""
    return of if isinstance(of, str) else "".join(texts(child) for child in of[2:])


def test_everything_a_page_shows(client):
    shown = said(client, "explain", STATEMENT).json()
    assert texts(shown["question"]).startswith("Velocities as vectors")
    assert [each["event"] for each in shown["pictures"]] == [1]
    assert all(each["svg"].startswith("<svg") and each["description"] for each in shown["pictures"])
    (part,) = shown["working"]
    assert texts(part["answers"][0]["item"]) == (
        "the velocity of A immediately after the collision"
    )
    assert [texts(value) for value in part["answers"][0]["values"]] == ["3\u2062𝐢+2\u2062𝐣"]
    named = [step for step in part["steps"] if step["principle"]]
    assert "Newton's experimental law" in [step["principle"] for step in named]
    assert all(step["about"] for step in named)
    rows = [row["row"] for step in part["steps"] for row in step["rows"]]
    assert rows
    for row in rows:
        several = row if isinstance(row[0], list) else [row]
        assert {each[0] for each in several} == {"tr"}
    assert part["marks"] == sum(
        len(each.split())
        for step in part["steps"]
        for each in (step["mark"], *(row["mark"] for row in step["rows"]))
    )
    assert shown["latex"].startswith(r"\documentclass")
    assert [each["name"] for each in shown["motion"]["motions"][0]["spheres"]] == ["A", "B"]
    errors = ("pictures_error", "working_error", "motion_error")
    assert [shown[name] for name in errors] == [None] * 3


def slowly(statement: str, limit: float, early: str) -> Payload:
    """As the page is explained; the working waits for a file that the statement names."""
    from restitution.export import working
    from restitution.web import work
    from restitution.workings import explain

    door = Path(statement.rpartition("# ")[2].strip())

    def patient(*arguments: object) -> object:
        while not door.exists():
            time.sleep(0.01)
        return explain(*arguments)

    with mock.patch.object(working, "explain", patient):
        return work.explained(statement, limit, early)


def test_what_is_there_before_the_working_comes_first(monkeypatch, tmp_path):
    own = replace(api._EXPLAINING, function=slowly)
    monkeypatch.setattr(api, "_EXPLAINING", own)
    body = {"statement": f"{STATEMENT}\n# {tmp_path}/door\n"}
    with (
        serving(Settings(workers=1, time_limit=60)) as address,
        httpx.Client(base_url=address, timeout=100) as client,
        client.stream("POST", "/api/explain", json={**body, "early": True}) as reply,
        ThreadPoolExecutor(1) as threads,
    ):
        lines = reply.iter_lines()
        early = json.loads(next(lines))
        # Whoever asks just the same meanwhile, and wants it whole, has the same work done.
        whole = threads.submit(client.post, "/api/explain", json=body)
        (tmp_path / "door").touch()
        last = json.loads(next(lines))
        assert list(lines) == []
        assert whole.result().json() == last
        # What is at hand comes at once, and is one line.
        again = client.post("/api/explain", json={**body, "early": True})
        assert again.json() == last
        assert again.headers["content-type"] == "application/json"
    # The pictures have the letters of the working as soon as that is there.
    late = {"working", "motion", "latex", "warnings", "pictures"}
    assert {name for name in last if last[name] != early[name]} <= late
    assert [part["answers"] for part in early["working"]] == [p["answers"] for p in last["working"]]
    assert not any(part["steps"] for part in early["working"])
    assert any(part["steps"] for part in last["working"])
    assert early["pictures"]
    events = [[picture["event"] for picture in each["pictures"]] for each in (early, last)]
    assert events[0] == events[1]


def test_rejected_roots_come_with_their_reasons(client):
    shown = said(client, "explain", examples.text("rejected-root")).json()
    (rejected,) = shown["working"][0]["answers"][0]["rejected"]
    assert texts(rejected["value"]) == "32"  # a fraction: 3 over 2
    assert rejected["reason"] == "a coefficient of restitution lies in [0, 1]"


def test_what_cannot_be_shown_leaves_the_rest(client):
    known = "wall W: along i\nsphere P: mass 2, velocity 3i - 3j\nP hits W\ngiven impulse = 30\n"
    shown = said(client, "explain", known + "find e, energy_lost\nfind speed(P)\n").json()
    assert shown["motion"] is None
    assert "e would be 4" in shown["motion_error"]
    assert shown["working"]
    assert shown["question"]


def test_pictures(client):
    corner = examples.text("corner")
    drawn = said(client, "draw", corner).json()
    assert [each["event"] for each in drawn["pictures"]] == [None, 1, 2]
    assert [e["event"] for e in said(client, "draw", corner, event=2).json()["pictures"]] == [2]


def test_an_event_that_is_not_there_is_named(client):
    corner = examples.text("corner")
    for event, name in ((0, "0"), (-1, "-1"), (3, "3"), (10**30, str(10**30))):
        reply = said(client, "draw", corner, event=event)
        assert reply.status_code == 422
        error = reply.json()["error"]
        assert error["message"] == f"there is no event {name}: the statement tells of 2 events"
    reply = said(client, "draw", corner, event=10**3000)
    assert "… (3001 digits): " in reply.json()["error"]["message"]
    assert len(reply.text) < 200
    # What is wrong with the statement goes first.
    reply = said(client, "draw", UNREADABLE, event=7)
    assert (reply.status_code, reply.json()["error"]["line"]) == (200, 2)


def test_sheet(client):
    reply = said(client, "sheet", STATEMENT, solutions=True, title="Friday’s homework")
    assert reply.headers["content-type"] == "application/pdf"
    text = "\n".join(page.extract_text() for page in PdfReader(BytesIO(reply.content)).pages)
    assert "Friday’s homework" in text
    assert "Solutions" in text
    refused = said(client, "sheet", UNREADABLE)
    assert refused.status_code == 422
    assert refused.json()["error"]["line"] == 2


def test_packed_only_for_those_who_can_unpack(client):
    for what in ("solve", "explain"):
        packed = said(client, what, STATEMENT)
        assert packed.headers["content-encoding"] == "gzip"
        plain = client.post(
            f"/api/{what}", json={"statement": STATEMENT}, headers={"Accept-Encoding": "identity"}
        )
        assert "content-encoding" not in plain.headers
        assert plain.json() == packed.json()


def test_the_same_question_has_the_same_bytes(client):
    with ThreadPoolExecutor(8) as threads:
        own = f"{STATEMENT}\n# asked by a whole class\n"
        replies = list(threads.map(lambda _: said(client, "explain", own).content, range(16)))
    assert len(set(replies)) == 1


# --- refusals -------------------------------------------------------------------------------------

JSON = {"Content-Type": "application/json"}
REFUSED = {
    "no JSON": (b"find speed(P)", JSON, 400),
    "cut JSON": (b'{"statement": "', JSON, 400),
    "no UTF-8": (b'{"statement": "\xff"}', JSON, 400),
    "UTF-16": ('{"statement": ""}'.encode("utf-16"), JSON, 400),
    "half a character": (b'{"statement": "\\ud800"}', JSON, 400),
    "no object": (b'["statement"]', JSON, 400),
    "nothing": (b"", JSON, 400),
    "no statement": (b"{}", JSON, 400),
    "a number": (b'{"statement": 3}', JSON, 400),
    "nothing for a statement": (b'{"statement": null}', JSON, 400),
    "unknown": (b'{"statement": "", "colour": "red"}', JSON, 400),
    "long unknown": (b'{"statement": "", "%s": 1}' % (b"a" * 5000), JSON, 400),
    "wrong type": (b'{"statement": "", "part": 1}', JSON, 400),
    "unknown style": (b'{"statement": "", "marks": "ocr"}', JSON, 400),
    "style of a wrong type": (b'{"statement": "", "marks": {}}', JSON, 400),
    "deep": (b'{"statement": ' + b"[" * 50_000 + b"]" * 50_000 + b"}", JSON, 400),
    "no number": (b'{"statement": NaN}', JSON, 400),
    "long number": (b'{"statement": ' + b"9" * 5000 + b"}", JSON, 400),
    "a form": (b"statement=x", {"Content-Type": "application/x-www-form-urlencoded"}, 415),
    "plain text": (b'{"statement": ""}', {"Content-Type": "text/plain"}, 415),
    "no type": (b'{"statement": ""}', {}, 415),
    "long": (json.dumps({"statement": "#" * 20_001}).encode(), JSON, 413),
    "large": (b" " * 200_000, JSON, 413),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(client, name):
    content, headers, status = REFUSED[name]
    reply = client.post("/api/solve", content=content, headers=headers)
    assert reply.status_code == status
    error = reply.json()["error"]
    assert set(error) == {"kind", "message"}
    assert 10 < len(error["message"]) < 200


def test_a_statement_may_be_as_long_as_told(client):
    reply = said(client, "check", "#" * 20_000)
    assert reply.status_code == 200


def test_too_large_without_telling_how_large(client):
    def pieces() -> Iterator[bytes]:
        for _ in range(100):
            yield b" " * 5000

    reply = client.post("/api/check", content=pieces(), headers=JSON)
    assert reply.status_code == 413


def test_a_length_that_is_not_true(served):
    host, port = served.removeprefix("http://").split(":")
    for length in ("-1", "1e9", "9" * 5000):
        with socket.create_connection((host, int(port)), timeout=20) as connection:
            head = f"POST /api/check HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\n"
            connection.sendall(f"{head}Content-Length: {length}\r\n\r\n{{}}".encode())
            assert connection.recv(12).split()[1] in (b"400", b"413")


@pytest.mark.parametrize(
    ("method", "path", "status", "kind"),
    [
        ("GET", "/api/solve", 405, "method"),
        ("PUT", "/api/check", 405, "method"),
        ("GET", "/api/nothing", 404, "not found"),
        ("POST", "/api/solve/", 404, "not found"),
        ("POST", "/", 405, "method"),
    ],
)
def test_wrong_methods_and_paths(client, method, path, status, kind):
    reply = client.request(method, path)
    assert reply.status_code == status
    assert reply.json()["error"]["kind"] == kind


def test_health(client):
    assert client.get("/health").json() == {"status": "ok"}


# --- what a browser is told -----------------------------------------------------------------------


def static(client: httpx.Client, path: str) -> str:
    """The address of a file, as the page has it."""
    return f"/{static_of(str(client.base_url).rstrip('/'))}/{path}"


def test_headers_on_every_response(client):
    replies = [
        client.get("/"),
        client.get("/lab"),
        client.get("/no/such/page"),
        client.get("/health"),
        client.get(static(client, "base.css")),
        client.get("/static/x/none.js"),
        client.get("/api/solve"),
        said(client, "check", ""),
        client.post("/api/solve", content=b"", headers=JSON),
    ]
    for reply in replies:
        policy = dict(
            each.partition(" ")[::2]
            for each in reply.headers["content-security-policy"].split("; ")
        )
        assert policy["default-src"] == "'none'"
        assert policy["script-src"] == policy["style-src"] == "'self'"
        assert policy["require-trusted-types-for"] == "'script'"
        assert policy["frame-ancestors"] == policy["base-uri"] == "'none'"
        assert reply.headers["x-content-type-options"] == "nosniff"
        assert reply.headers["referrer-policy"] == "no-referrer"
        assert reply.headers["cross-origin-opener-policy"] == "same-origin"
        assert reply.headers["cross-origin-resource-policy"] == "same-origin"
        assert "server" not in reply.headers
        assert "set-cookie" not in reply.headers


def test_files_are_kept_for_ever_under_their_name(client):
    path = static(client, "base.css")
    reply = client.get(path)
    assert reply.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert reply.headers["content-type"].startswith("text/css")
    assert reply.headers["content-encoding"] == "gzip"
    plain = client.get(path, headers={"Accept-Encoding": "identity"})
    assert plain.content == reply.content
    assert "content-encoding" not in plain.headers
    head = client.head(path)
    assert (head.status_code, head.content) == (200, b"")


def test_a_page_opened_before_an_upgrade_still_finds_its_files(client):
    reply = client.get("/static/0123456789ab/base.css")
    assert reply.content == client.get(static(client, "base.css")).content
    assert reply.headers["cache-control"] == "no-cache"


def test_a_page_is_asked_for_anew_but_not_sent_anew(client):
    reply = client.get("/")
    assert reply.headers["cache-control"] == "no-cache"
    again = client.get("/", headers={"If-None-Match": reply.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert said(client, "check", "").headers["cache-control"] == "no-store"


@pytest.mark.parametrize(
    "path",
    [
        "player/__init__.py",
        "player/data.py",
        "../pages.py",
        "..%2fpages.py",
        "%2e%2e/%2e%2e/pages.py",
        "../templates/base.html",
        "/etc/passwd",
        "fonts/",
        "",
    ],
)
def test_nothing_else_is_served(client, path):
    assert client.get(static(client, "") + path).status_code == 404


def test_a_page_that_is_not_there(client):
    for path in ("/nothing", "/no/such/page"):
        reply = client.get(path)
        assert reply.status_code == 404
        assert reply.headers["content-type"].startswith("text/html")
        assert '<nav aria-label="Pages">' in reply.text
        home = reply.text.partition('<a href="')[2].partition('"')[0]
        assert client.get(str(reply.url.join(home).path)).text == client.get("/").text
    assert client.get("/lab/", follow_redirects=True).url.path == "/lab"


# --- harm -----------------------------------------------------------------------------------------


def test_hostile_statements_leave_the_server_well(client):
    def ask(one: tuple[str, bytes]) -> httpx.Response:
        name, text = one
        what = ("solve", "check", "explain", "draw")[len(name) % 4]
        return said(client, what, text.decode("utf-8", errors="replace"))

    with ThreadPoolExecutor(3) as threads:
        replies = list(threads.map(ask, HOSTILE.items()))
    for (name, text), reply in zip(HOSTILE.items(), replies):
        long = len(text.decode("utf-8", errors="replace")) > 20_000
        assert reply.status_code == (413 if long else 200), name
        assert "internal error" not in reply.text, name
        assert "Traceback" not in reply.text, name
    assert client.get("/health").status_code == 200
    assert said(client, "solve", f"{STATEMENT}# afterwards\n").json()["error"] is None


def patient(seconds: float, begun: Path | None = None) -> Payload:
    """Work that its own limit does not stop; there is a file where it has begun."""
    if begun is not None:
        begun.touch()
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGALRM, signal.SIGTERM})
    time.sleep(seconds)
    return Payload(b"")


def deadly() -> Payload:
    os._exit(3)


def failing() -> Payload:
    raise RuntimeError("nobody has foreseen this")


def tiring() -> Payload:
    return Payload(str(os.getpid()).encode(), tired=True)


def whose() -> Payload:
    return Payload(str(os.getpid()).encode())


def test_processes_are_killed_replaced_and_freed(monkeypatch, tmp_path):
    begun = tmp_path / "begun"
    monkeypatch.setattr("restitution.web.pool._LOADED", "json")
    monkeypatch.setattr("restitution.web.pool._GRACE", 0.0)

    async def story() -> None:
        async with pool(1, 1, 30) as work:
            with pytest.raises(TimeoutError):
                await work.run(patient, 60, limit=0.3)
            with pytest.raises(LostError):
                await work.run(deadly, limit=20)
            with pytest.raises(LostError, match="a fault of the program") as lost:
                await work.run(failing, limit=20)
            assert "nobody has foreseen this" in lost.value.details
            tired = await work.run(tiring, limit=20)
            fresh = await work.run(whose, limit=20)
            assert fresh.content != tired.content
            assert (await work.run(whose, limit=20)).content == fresh.content
            # One works, one waits, and for a third there is no place.
            first = asyncio.create_task(work.run(patient, 60, begun, limit=50))
            second = asyncio.create_task(work.run(whose, limit=20))
            while not begun.exists():
                await asyncio.sleep(0.01)
            with pytest.raises(BusyError) as busy:
                await work.run(whose, limit=20)
            assert 1 <= busy.value.again <= 30
            # Who goes away leaves the place to the next.
            first.cancel()
            assert (await asyncio.wait_for(second, 20)).content != fresh.content

    completed(story())


def test_whoever_worked_last_works_next(monkeypatch):
    monkeypatch.setattr("restitution.web.pool._LOADED", "json")

    async def story() -> None:
        async with pool(3, 5, 30) as work:
            assert len({(await work.run(whose, limit=20)).content for _ in range(6)}) == 1
            both = await asyncio.gather(*(work.run(patiently, 0.3, limit=20) for _ in range(2)))
            assert len({each.content for each in both}) == 2

    completed(story())


def patiently(seconds: float) -> Payload:
    time.sleep(seconds)
    return whose()


def test_no_process_that_ends_takes_the_work_of_another_with_it(monkeypatch):
    monkeypatch.setattr("restitution.web.pool._LOADED", "json")
    monkeypatch.setattr("restitution.web.pool._ABANDONED", 0.0)

    async def story() -> None:
        async with pool(2, 200, 60) as work:

            async def given_up() -> None:
                task = asyncio.create_task(work.run(patiently, 60, limit=50))
                await asyncio.sleep(0.05)
                task.cancel()
                await asyncio.wait([task])

            wanted = [work.run(each, limit=50) for each in (tiring, whose) * 4]
            done = await asyncio.gather(*wanted, *(given_up() for _ in range(4)))
            assert all(made.content for made in done[:8])

    completed(story())


async def losing_all() -> None:
    """The processes of a pool are killed, and what they are forked from; others take the work."""
    async with pool(2, 5, 20) as work:
        lost = int((await work.run(whose, limit=20)).content)
        parent = int(Path(f"/proc/{lost}/stat").read_text().rpartition(")")[2].split()[1])
        os.kill(parent, signal.SIGKILL)
        os.kill(lost, signal.SIGKILL)
        for _ in range(50):
            try:
                fresh = int((await work.run(whose, limit=20)).content)
                break
            except (BusyError, LostError):
                await asyncio.sleep(0.1)
        assert fresh not in (lost, parent)


@pytest.mark.skipif(sys.platform != "linux", reason="finds processes in /proc")
def test_others_begin_when_all_are_lost():
    # In an interpreter of its own: all pools of one are forked from the same process.
    code = "import asyncio, test_web_api as t; asyncio.run(t.losing_all())"
    subprocess.run([sys.executable, "-c", code], cwd=Path(__file__).parent, timeout=100, check=True)


def test_nobody_waits_for_ever(monkeypatch):
    monkeypatch.setattr("restitution.web.pool._LOADED", "json")

    async def story() -> None:
        async with pool(1, 5, 0.2) as work:
            first = asyncio.create_task(work.run(patient, 60, limit=50))
            await asyncio.sleep(0)  # it has its turn
            with pytest.raises(BusyError):
                await work.run(whose, limit=20)
            first.cancel()

    completed(story())


def test_one_solve_for_all_who_ask_the_same():
    async def story() -> None:
        replies = Replies(100)
        begun = 0
        cancelled = asyncio.Event()
        door = asyncio.Event()

        async def make() -> Payload:
            nonlocal begun
            begun += 1
            try:
                await door.wait()
            except asyncio.CancelledError:
                cancelled.set()
                raise
            return Payload(b"x" * 40)

        asking = [asyncio.create_task(replies.get("a", make)) for _ in range(3)]
        await asyncio.sleep(0)
        asking[0].cancel()  # the others still wait
        await asyncio.sleep(0)
        door.set()
        assert [(await each).content for each in asking[1:]] == [b"x" * 40] * 2
        assert begun == 1
        await replies.get("a", make)
        assert begun == 1  # kept
        await replies.get("b", make)
        await replies.get("c", make)  # no room for three
        await replies.get("a", make)
        assert begun == 4
        door.clear()
        alone = asyncio.create_task(replies.get("d", make))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        alone.cancel()
        await asyncio.wait_for(cancelled.wait(), 5)

    completed(story())


def test_what_was_broken_off_is_not_kept():
    async def story() -> None:
        replies = Replies(100)
        made = iter([Payload(b"cut", tired=True), Payload(b"whole")])

        async def make() -> Payload:
            return next(made)

        assert (await replies.get("a", make)).content == b"cut"
        assert (await replies.get("a", make)).content == b"whole"

    completed(story())


# --- the command ----------------------------------------------------------------------------------


def started(*arguments: str) -> tuple[subprocess.Popen[str], str]:
    """The command serving the page, and where."""
    process = subprocess.Popen(
        [sys.executable, "-m", "restitution", "serve", "--no-browser", "--port", "0", *arguments],
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stderr is not None
    line = process.stderr.readline()
    return process, line.partition("at ")[2].partition("/ (")[0]


def family(group: int) -> list[str]:
    """The processes of a group that are alive."""
    told = subprocess.run(
        ["ps", "-eo", "pgid=,stat=,args="], capture_output=True, text=True, check=True
    ).stdout
    lines = (line.split(None, 2) for line in told.splitlines())
    return [line[2] for line in lines if line[0] == str(group) and not line[1].startswith("Z")]


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ends_cleanly_with_all_its_processes(number):
    process, address = started("--workers", "1")
    with process, httpx.Client(base_url=address, timeout=30) as client:
        assert client.get("/health").status_code == 200
        assert said(client, "check", STATEMENT).json()["errors"] == []
        with ThreadPoolExecutor(1) as threads:
            asked = threads.submit(said, client, "explain", examples.text("common-mistakes"))
            time.sleep(0.3)
            os.killpg(process.pid, number)  # as a terminal does
            assert asked.result().status_code in (200, 503)
        _, rest = process.communicate(timeout=20)
    assert process.returncode == 0
    assert "Traceback" not in rest
    for _ in range(100):
        if not family(process.pid):
            break
        time.sleep(0.05)
    assert family(process.pid) == []


def test_port_in_use(served):
    port = served.rpartition(":")[2]
    done = subprocess.run(
        [sys.executable, "-m", "restitution", "serve", "--no-browser", "--port", port],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.startswith(f"cannot serve at 127.0.0.1, port {port}: another program")


def test_only_known_names():
    process, address = started("--workers", "1", "--trusted-host", "Impacts.School.example")
    with process, httpx.Client(base_url=address, timeout=30) as client:
        try:
            status = {
                name: client.get("/", headers={"Host": name}).status_code
                for name in (
                    "localhost:8765",
                    "127.0.0.1",
                    "[::1]:80",
                    "impacts.school.example",
                    "evil.example",
                    "evil.example:127",
                    "localhost.evil.example",
                )
            }
            assert list(status.values()) == [200, 200, 200, 200, 421, 421, 421]
        finally:
            process.terminate()
            process.communicate(timeout=20)


def interpreted(code: str) -> subprocess.CompletedProcess[str]:
    """What a fresh interpreter makes of some code."""
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False
    )


def test_it_says_who_can_reach_it():
    process, address = started("--workers", "1", "--host", "0.0.0.0")
    assert process.stderr is not None
    with process:
        try:
            line = process.stderr.readline()
        finally:
            process.terminate()
            process.communicate(timeout=20)
    port = address.rpartition(":")[2]
    assert re.fullmatch(
        "Everybody who can reach this machine over its network can use it"
        rf"(, at http://[0-9.]+:{port}/)?\.\n",
        line,
    )


def test_the_names_that_are_trusted_are_those_to_ask_for():
    with listening("0.0.0.0", 0) as door:
        port = door.getsockname()[1]
        assert f"at http://impacts.example:{port}/." in reach(door, ["impacts.example"])


def test_without_the_extra():
    code = (
        "import sys; sys.modules['starlette'] = None; sys.argv = ['restitution', 'serve'];"
        "from restitution.cli import main; main()"
    )
    done = interpreted(code)
    assert done.returncode == 2
    assert done.stderr == "the page needs starlette: pip install 'restitution[web]'\n"


def test_the_process_that_serves_knows_no_algebra():
    code = (
        "import sys; from restitution.web import create_app; import restitution.web.serving;"
        "create_app(); print([m for m in ('sympy', 'numpy', 'ziamath') if m in sys.modules])"
    )
    done = interpreted(code)
    assert done.returncode == 0
    assert done.stdout == "[]\n"


def test_settings_are_limits():
    assert Settings().longest * 4 < Settings().largest


# --- trees, the font ------------------------------------------------------------------------------


def test_elements_are_trees_and_text_is_escaped():
    parts = ["a < b", element("br"), "c ", "& d", element("i", ["e"], {"class": 'x"'})]
    whole = element("p", parts)
    assert whole == ["p", {}, "a < b", ["br", {}], "c & d", ["i", {"class": 'x"'}, "e"]]
    assert to_markup(whole) == '<p>a &lt; b<br>c &amp; d<i class="x&quot;">e</i></p>'
    assert together(["a", element("wbr"), "b"]) == ["span", {}, "a", ["wbr", {}], "b"]
    assert together([whole]) == whole


def mathematics(of: object, inside: bool = False) -> str:
    """All characters that stand in the formulas of a tree, or of several."""
    if isinstance(of, str):
        return of if inside else ""
    if of is None:
        return ""
    children = of[2:] if of and isinstance(of[0], str) else of
    return "".join(mathematics(each, inside or of[0] == "math") for each in children)


def test_the_font_has_what_formulas_need(client):
    from fontTools.ttLib import TTFont

    reply = client.get(static(client, "fonts/stix-two-math.woff2"))
    assert reply.status_code == 200, "the font is missing: uv sync --reinstall-package restitution"
    assert reply.headers["content-type"] == "font/woff2"
    assert len(reply.content) < 170_000
    font = TTFont(BytesIO(reply.content))
    assert "Open Font License" in str(font["name"].getDebugName(13))
    assert font["MATH"].table.MathVariants.VertGlyphCoverage.glyphs  # what grows
    used = set()
    for name in examples.names()[::5]:
        shown = said(client, "explain", examples.text(name)).json()
        used |= set(mathematics(shown["question"]))
        for part in shown["working"]:
            used |= set(mathematics([each["item"] for each in part["answers"]]))
            used |= set(mathematics([v for each in part["answers"] for v in each["values"]]))
            for step in part["steps"]:
                used |= set(mathematics([step["said"], *(row["row"] for row in step["rows"])]))
    assert {"√", "\N{GREEK SMALL LETTER ALPHA}"} - set(map(chr, font.getBestCmap())) == set()
    assert used - set(map(chr, font.getBestCmap())) == set()
    # A letter in ``mi`` is shown as an italic one of the plane of mathematics.
    italic = {chr(0x1D44E + n) for n in range(26)} - {chr(0x1D455)} | {"ℎ"}
    assert italic - set(map(chr, font.getBestCmap())) == set()
