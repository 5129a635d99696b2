"""``restitution mark`` as a teacher meets it: scripts, folders, answers alone, statuses."""

from __future__ import annotations

import csv
import json

import pytest
from commands import run

from restitution import parse, solve
from restitution.cli import marking
from restitution.cli.asking import Answer
from restitution.cli.marking import Scripts
from restitution.errors import TimeLimitError
from restitution.export.marking import Workings, written
from restitution.practice.marking import marking as marking_of_parts

QUESTION = """sphere A: mass 2, velocity 3i + 2j
sphere B: mass 4, velocity -i + j
A hits B: along i, e = 1/2
part a
find velocity(A), velocity(B)
part b
find energy_lost
"""
GOOD = "6 - 4 = 2v + 4w\nw - v = 2\nv = -1\nw = 1\n"
WRONG = "6 + 4 = 2v + 4w\nw - v = 2\n"


@pytest.fixture
def folder(tmp_path):
    scripts = tmp_path / "scripts"
    scripts.mkdir()
    (tmp_path / "pair.impact").write_text(QUESTION)
    (tmp_path / "letters.txt").write_text(
        "v: component of A along i after\nw: along(velocity(B), i)\n"
    )
    (scripts / "ann.txt").write_text(GOOD)
    (scripts / "bob.txt").write_text(WRONG)
    return tmp_path


def test_a_script_is_marked(folder):
    status, out, err = run(
        *("mark", "pair.impact", "scripts/bob.txt", "--letters", "letters.txt", "--part", "a"),
        cwd=folder,
    )
    assert (status, err) == (0, "")
    assert "1 ✗ 6 + 4 = 2v + 4w" in out
    assert "Marks: 3 of 8" in out
    assert max(map(len, out.splitlines())) <= 80


def test_what_is_wrong_in_the_letters_is_told_of_their_file(folder):
    (folder / "letters.txt").write_text("v: component of A along i after\nw: the wobble of B\n")
    status, _, err = run(
        "mark", "pair.impact", "scripts/bob.txt", "--letters", "letters.txt", cwd=folder
    )
    assert status == 2
    assert err.startswith("letters.txt:2:4: syntax: the meaning of w, 'the wobble of B', names no")
    assert "    2 | w: the wobble of B\n      |    ^" in err


def test_several_parts_are_an_object_a_line(folder):
    typed = f"(a)\n{GOOD}(b)\nKE lost = 8\n".encode()
    status, out, _ = run("mark", "pair.impact", "-", "--format", "json", stdin=typed, cwd=folder)
    assert status == 0
    assert [json.loads(line)["part"] for line in out.splitlines()] == ["a", "b"]


def test_each_script_of_a_folder_has_the_time_of_one(folder, monkeypatch):
    limits = []

    def answered(worker, file, job, limit, letters):
        limits.append(limit)
        return Answer(0, "")

    monkeypatch.setattr(marking, "answer", answered)
    task = Workings((), (), None, "", 1, "csv", 80)
    for working in ("scripts/ann.txt", "scripts"):
        scripts = Scripts(str(folder / "pair.impact"), str(folder / working), None, task)
        marking.mark(None, scripts, 10.0)
    marking.mark(None, scripts, None)
    assert limits == [10.0, 20.0, None]


def test_parts_that_are_marked_are_kept_where_the_time_ends_in_a_later_one(monkeypatch):
    """The clock stops at the second part that is marked, as if that took all the time."""
    solution = solve(parse(QUESTION))
    seen = []

    def marked(solution, script, label, *rest):
        seen.append(label)
        if len(seen) == 2:
            raise TimeLimitError("stopped")
        return real(solution, script, label, *rest)

    real = marking_of_parts._marked
    monkeypatch.setattr(marking_of_parts, "_marked", marked)
    script = f"(a)\n{GOOD}(b)\nKE lost = 8\n"
    for part, late in ((None, ("ann.txt, part (b)",)), ("b", ())):
        seen.clear()
        task = Workings((("ann.txt", script),), (), part, "", 1, "json", 80)
        text, left_out = written(solution, task, 60.0)
        (line,) = text.splitlines()
        assert (json.loads(line)["part"], left_out) == (part or "a", late)


def test_a_folder_is_one_table(folder):
    status, out, _ = run(
        *("mark", "pair.impact", "scripts", "--letters", "letters.txt", "--csv"), cwd=folder
    )
    rows = [row for row in csv.DictReader(out.splitlines()) if row["part"] == "a"]
    assert status == 0
    assert [row["script"] for row in rows] == ["ann.txt", "bob.txt"]
    assert [row["mistakes"] for row in rows] == ["", "momentum-sign"]
    assert int(rows[0]["earned"]) > int(rows[1]["earned"])


def test_a_part_that_is_not_attempted_has_its_row(folder):
    (folder / "scripts" / "cy.txt").write_text("")
    arguments = ("mark", "pair.impact", "scripts", "--letters", "letters.txt")
    _, out, _ = run(*arguments, "--csv", cwd=folder)
    rows = list(csv.DictReader(out.splitlines()))
    assert [(row["script"], row["part"]) for row in rows] == [
        (name, part) for name in ("ann.txt", "bob.txt", "cy.txt") for part in "ab"
    ]
    assert len({row["of"] for row in rows if row["part"] == "b"}) == 1
    assert [row["earned"] for row in rows if row["part"] == "b"] == ["0"] * 3
    _, out, _ = run("mark", "pair.impact", "scripts/cy.txt", cwd=folder)
    assert out.count("Marks: 0 of") == 2 and "(b)" in out
    _, out, _ = run("mark", "pair.impact", "scripts/ann.txt", "-f", "json", cwd=folder)
    assert [json.loads(line)["marks"]["of"] for line in out.splitlines()] == [
        int(row["of"]) for row in rows[:2]
    ]


def test_a_script_that_cannot_be_read_does_not_stop_the_others(folder):
    (folder / "scripts" / "anya.txt").write_bytes(b"v = 2\xff")
    status, out, err = run("mark", "pair.impact", "scripts", "--part", "a", "--csv", cwd=folder)
    rows = list(csv.DictReader(out.splitlines()))
    assert status == 2 and "anya.txt: the text is not UTF-8" in err
    assert [row["script"] for row in rows] == ["ann.txt", "anya.txt", "bob.txt"]
    assert set(list(rows[1].values())[1:]) == {""} and rows[2]["of"]
    status, out, _ = run("mark", "pair.impact", "scripts", "--part", "a", cwd=folder)
    assert status == 2 and out.count("Marks:") == 2


def test_a_table_has_no_other_form(folder):
    status, out, err = run("mark", "pair.impact", "scripts", "--csv", "-f", "json", cwd=folder)
    assert (status, out) == (2, "") and "a table has a form of its own" in err


def test_answers_alone(folder):
    status, out, _ = run(
        *("mark", "pair.impact", "--answer", "velocity(A) = -i + 2j"),
        *("--answer", "energy_lost = 9"),
        cwd=folder,
    )
    assert status == 0
    assert out.splitlines()[0] == "velocity(A) = -i + 2j: right"
    assert "not right" in out.splitlines()[1]


@pytest.mark.parametrize(
    ("arguments", "stdin", "status", "said"),
    [
        (["nowhere.impact", "scripts/ann.txt"], b"", 2, "nowhere.impact"),
        (["pair.impact", "nowhere.txt"], b"", 2, "nowhere.txt"),
        (["pair.impact", "-"], b"\xff\xfe", 2, "UTF-8"),
        (["pair.impact", "scripts/ann.txt", "--part", "z"], b"", 2, "z"),
        (["pair.impact", "--answer", "speed = 3"], b"", 2, "asked"),
        (["-", "-"], b"", 2, "standard input"),
        (["-", "scripts/ann.txt"], b"sphere P: velocity 2i\nfind energy(P)\n", 1, ""),
    ],
)
def test_what_cannot_be_marked(folder, arguments, stdin, status, said):
    found, _, err = run("mark", *arguments, stdin=stdin, cwd=folder)
    assert found == status
    assert said in err


def test_a_page_of_markings_has_the_question_and_the_scripts(folder):
    (folder / "pair.impact").write_text(f"title A & B\n{QUESTION}")
    arguments = ("mark", "pair.impact", "scripts", "--letters", "letters.txt", "--format", "html")
    status, out, _ = run(*arguments, cwd=folder)
    assert status == 0
    assert "<h1>A &amp; B</h1>" in out and "Immediately before the collision" in out
    assert out.index("<h2>ann.txt</h2>") < out.index("<h2>bob.txt</h2>")
    assert "<h3>Part (a)</h3>" in out


MOVING = """sphere A: mass 5, velocity 5 at alpha
sphere B: mass 1, velocity -3i
given tan(alpha) = 4/3
A hits B: along i, e = 1/3
find speed(A), speed(B)
"""  # 13/3 and 7


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("speed of A = 4.33", "speed(A) = 4.33: right"),
        ("the speed of A is 13/3 m/s", "speed(A) = 13/3 m/s: right"),
        ("vA = 4.33", "speed(A) = 4.33: right"),
        ("speed of A: 4.33", "speed(A) = 4.33: right"),
        (
            "vA = 4.81",
            "speed(A) = 4.81: not right; it is what comes of: A sign in momentum (momentum-sign)",
        ),
        ("v_B = 3", "speed(B) = 3: not right"),
    ],
)
def test_an_answer_may_be_told_as_in_a_working(tmp_path, typed, said):
    (tmp_path / "q.impact").write_text(MOVING)
    status, out, err = run("mark", "q.impact", "--answer", typed, cwd=tmp_path)
    assert (status, out.startswith(said)) == (0, True), out + err


def test_a_value_alone_is_of_the_one_thing_that_is_asked(tmp_path):
    (tmp_path / "q.impact").write_text(MOVING.replace(", speed(B)", ""))
    _, out, _ = run("mark", "q.impact", "--answer", "13/3", cwd=tmp_path)
    assert out == "speed(A) = 13/3: right\n"
    (tmp_path / "q.impact").write_text(MOVING)
    for typed in ("13/3", "v = 13/3"):  # of which of the two?
        status, _, err = run("mark", "q.impact", "--answer", typed, cwd=tmp_path)
        assert status != 0 and "asked: speed(A), speed(B)" in err
