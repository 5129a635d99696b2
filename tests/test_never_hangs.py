"""Nothing runs for ever: a test that takes too long ends, and says which statement it was."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from restitution.errors import RestitutionError, TimeLimitError
from restitution.export import job, working
from restitution.export.player.data import of_solution
from restitution.export.working import shown
from restitution.language import parse
from restitution.solving import solve
from restitution.work import limited, spend
from restitution.workings import explain

HERE = Path(__file__).parent

# --- the time limit of every test -----------------------------------------------------------------

STATEMENT = """\
sphere A: mass 2, velocity u i
sphere B: mass 3, at rest
A hits B: along i
given energy_lost = 5
find speed(B)
"""
# SymPy's arithmetic never comes back, so that whoever solves in letters is slow.
SLOW = f"""\
import contextlib
import subprocess
import sys
import time

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from restitution.language import parse
from restitution.solving import solve

TEXT = {STATEMENT!r}


@pytest.fixture(autouse=True)
def slow(monkeypatch):
    def wait(*_):
        while True:
            time.sleep(0.01)

    for name in ("__mul__", "__rmul__", "__truediv__", "__add__", "__sub__", "__pow__"):
        monkeypatch.setattr(sympy.Expr, name, wait)


def test_quick():
    time.sleep(0.01)


"""
KINDS = {
    "of a file": """\
@pytest.mark.parametrize("text", [TEXT])
def test_slow(text):
    solve(parse(text))
""",
    "of Hypothesis": """\
@given(st.integers(0, 9))
def test_slow(number):
    solve(parse(TEXT))
""",
    "that goes on after failures": """\
@given(st.integers(0, 9))
def test_slow(number):
    with contextlib.suppress(Exception):
        solve(parse(TEXT))
""",
    "of a command": """\
def test_slow():
    waiting = "import sys, time; sys.stdin.read(); time.sleep(600)"
    subprocess.run([sys.executable, "-c", waiting], input=TEXT.encode())
""",
}


def run(folder: Path, text: str, *options: str) -> tuple[int, str]:
    """The status and output of pytest for one file of tests, with the plugins of these tests."""
    (folder / "test_it.py").write_text(text, encoding="utf-8")
    (folder / "pytest.ini").write_text("[pytest]\nmarkers = nightly\n", encoding="utf-8")
    plugins = [word for name in ("limits", "draws", "no:cacheprovider") for word in ("-p", name)]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *plugins, "-n", "0", *options, "test_it.py"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(HERE)},
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    return done.returncode, done.stdout + done.stderr


HARDEST = "that goes on after failures"


@pytest.mark.parametrize(
    "kind",
    [pytest.param(k, marks=() if k == HARDEST else pytest.mark.nightly) for k in KINDS],
)
def test_a_slow_test_fails_with_its_statement(tmp_path, kind):
    status, out = run(tmp_path, SLOW + KINDS[kind], "--timeout=1", "-m", "not nightly")
    assert status == 1, out
    assert "1 failed, 1 passed" in out
    assert "TooSlow: no end within 1 s" in out
    # As pytest prints it, beside the E of an error.
    assert "".join(f"E       {line}\n" for line in STATEMENT.splitlines()) in out


def test_every_test_has_a_time_limit(pytestconfig):
    assert float(pytestconfig.getini("timeout")) > 0
    assert pytestconfig.getini("timeout_method") == "signal"
    assert pytestconfig.pluginmanager.has_plugin("timeout")
    assert pytestconfig.pluginmanager.has_plugin("limits")


# --- what Hypothesis draws ------------------------------------------------------------------------

DRAWN = """\
from hypothesis import given
from hypothesis import strategies as st

{more}

@given(st.one_of(st.integers(), st.floats(), st.text()))
def test_draws(drawn):
    with open("drawn.txt", "a") as file:
        print(ascii(drawn), file=file)
"""


def drawn(folder: Path, *options: str, more: str = "") -> tuple[list[str], str]:
    """What is drawn for a test in a file of its own, and the output of pytest."""
    status, out = run(folder, DRAWN.format(more=more), *options)
    assert status == 0, out
    file = folder / "drawn.txt"
    lines = file.read_text().splitlines()
    file.unlink()
    assert len(lines) >= 25
    return lines, out


def test_the_same_is_drawn_everywhere(tmp_path):
    first, _ = drawn(tmp_path, "-m", "not nightly")
    # Whatever constants stand in the modules that are loaded by then.
    (tmp_path / "mine.py").write_text("NUMBERS = [31415926, 2.71828182, 'a word of mine']\n" * 20)
    again, _ = drawn(tmp_path, "-m", "not nightly", "--hypothesis-seed=5", more="import mine")
    assert first == again


@pytest.mark.nightly
def test_what_is_drawn_at_night_is_new_and_can_be_drawn_again(tmp_path):
    normal, _ = drawn(tmp_path, "-m", "not nightly")
    first, out = drawn(tmp_path, "-m", "nightly")
    second, _ = drawn(tmp_path, "-m", "nightly")
    (option,) = {word for word in out.split() if word.startswith("--hypothesis-seed=")}
    again, _ = drawn(tmp_path, "-m", "nightly", option)
    assert first == again
    assert first not in (normal, second)


# --- statements that have hung --------------------------------------------------------------------


def solved(statement: str, seconds: float) -> dict[str, list[str]]:
    """The exact answers by item, from a process that is killed if it takes longer."""
    code = (
        "import json, sys\n"
        "from restitution.language import parse\n"
        "from restitution.solving import solve\n"
        "solution = solve(parse(sys.stdin.read()))\n"
        "items = {item.text: [a.exact for a in item.answers] for _, item in solution.items()}\n"
        "print(json.dumps(items))\n"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(
        command, input=statement.encode(), stdout=subprocess.PIPE, timeout=seconds, check=True
    )
    return json.loads(done.stdout)


def test_a_speed_and_a_coefficient_from_a_deflection_and_a_speed_in_surds():
    """It was drawn by a property test, which was not back after 50 minutes.

    By hand: forward, with u = 5/3 and e = 1/6, it has the given deflection and speed.
    """
    answers = solved(
        "sphere A: mass 5, velocity u at 150°\n"
        "sphere B: mass 1/3, velocity (3, -1)\n"
        "A hits B: along (3, 4)\n"
        "given deflection(A) = arctan(7*(159175*sqrt(3) + 395472)/89618797)\n"
        "given speed(A) = sqrt(8652*sqrt(3) + 897583)/576\n"
        "find u, e\n",
        seconds=60,
    )
    assert "5/3" in answers["u"]
    assert "1/6" in answers["e"]


# --- what the clock breaks off is told ------------------------------------------------------------

# Where the time of one who waits is over, something may be left out; never in silence.


def until_it_rings() -> None:
    """As a part of the program does that takes any error of the package for a reason to go on."""
    with contextlib.suppress(RestitutionError):
        for _ in range(10**6):
            spend()
            time.sleep(0.001)


def test_a_limit_that_is_caught_in_silence_is_known():
    for seconds in (0.01, 0):
        with limited(seconds, error=TimeLimitError("over")) as limit:
            until_it_rings()
        assert limit.broken
    with limited(None, error=TimeLimitError("over")) as limit:
        spend()
    assert not limit.broken


def warnings_of(task: job.Task) -> tuple[str, ...]:
    reply = job.serve(job.Job("-", parse(STATEMENT), task, limit=1.0))
    assert reply.tired
    return reply.warnings


def test_solving_in_a_hurry_is_told(monkeypatch):
    def hurried(problem):
        until_it_rings()
        return solution

    solution = solve(parse(STATEMENT))
    monkeypatch.setattr(sys.modules["restitution.solving"], "solve", hurried)
    warning = "the time limit of 1 s was near while it was solved: something may be left out"
    for task in (job.Writing(), job.Drawing(), job.Playing(), job.Picturing(), job.Showing()):
        assert warning in warnings_of(task)
    reply = job.serve(job.Job("-", parse(STATEMENT), job.Writing("json"), limit=1.0))
    assert json.loads(reply.content)["warnings"] == [warning]


@pytest.mark.parametrize("caught", [True, False])
def test_a_working_in_a_hurry_is_told(monkeypatch, caught):
    def hurried(solution, part=None, **options):
        """Goes on until the time limit is met, and makes as if nothing had been."""
        if caught:
            until_it_rings()
            return explanation
        while True:
            spend()
            time.sleep(0.001)

    explanation = explain(solve(parse(STATEMENT)))
    monkeypatch.setattr(sys.modules["restitution.workings"], "explain", hurried)
    reply = job.serve(job.Job("-", parse(STATEMENT), job.Writing(), limit=1.0))
    reason = "the time limit of 1 s was near while it was written"
    assert reply.warnings == (f"here are the answers without their working: {reason}",)
    assert "speed(B)" in reply.content
    assert reply.tired


def test_a_working_has_what_solving_leaves_of_the_time(monkeypatch):
    """It takes longer than the share that it has in any case, and is written."""

    def slow(solution, part=None, **options):
        """Takes half of the time limit."""
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            spend()
            time.sleep(0.001)
        return explanation

    explanation = explain(solve(parse(STATEMENT)))
    monkeypatch.setattr(sys.modules["restitution.workings"], "explain", slow)
    monkeypatch.setattr(sys.modules["restitution.solving"], "solve", lambda problem: solution)
    solution = solve(parse(STATEMENT))
    for form in ("text", "json"):
        task = job.Writing(form, working=form == "json")
        reply = job.serve(job.Job("-", parse(STATEMENT), task, limit=1.0))
        assert not reply.warnings
        assert not reply.tired


PIECES = {
    "question": "question",
    "wording of the items": "_names",
    "pictures": "pictured",
    "working": "_worked",
    "LaTeX": "to_latex",
    "motion": "of_solution",
}


@pytest.mark.parametrize("piece", PIECES)
@pytest.mark.parametrize("caught", [True, False])
def test_a_piece_of_a_page_that_is_broken_off_is_told(monkeypatch, piece, caught):
    solution = solve(parse(STATEMENT))
    began = time.monotonic()
    whole = shown(solution)
    # All other pieces are there in time, however busy the machine is.
    limit = max(1.0, 5 * (time.monotonic() - began))
    assert not whole.tired
    assert not [text for text in whole.pieces.warnings if "time" in text]

    def hurried(*arguments, **named):
        if caught:
            until_it_rings()
            return make(
                *arguments, **{**named, **({"seconds": None} if "seconds" in named else {})}
            )
        while True:
            spend()
            time.sleep(0.001)

    make = getattr(working, PIECES[piece])
    monkeypatch.setattr(working, PIECES[piece], hurried)
    page = shown(solution, limit)
    assert page.tired
    reason = getattr(page.pieces, f"{piece}_error", None)
    left_out = [text for text in page.pieces.warnings if f"the {piece} is left out" in text]
    assert left_out or reason == "there was no time left for it"


def test_exact_values_that_are_left_out_are_told():
    solution = solve(parse(STATEMENT))
    note = "Some exact values are left out: there was no time left for them."
    (motion,) = of_solution(solution)["motions"]
    assert note not in motion["notes"]
    assert any(said for sphere in motion["spheres"] for said in sphere["said"])
    (motion,) = of_solution(solution, seconds=0)["motions"]
    assert note in motion["notes"]


def test_a_page_without_all_exact_values_is_not_kept(monkeypatch):
    solution = solve(parse(STATEMENT))
    monkeypatch.setattr(working, "of_solution", lambda each, seconds: of_solution(each, seconds=0))
    assert shown(solution).tired
