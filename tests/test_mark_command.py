"""``restitution mark`` as a teacher meets it: scripts, folders, answers alone, statuses."""

from __future__ import annotations

import csv
import json

import pytest
from commands import run

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


def test_several_parts_are_an_object_a_line(folder):
    typed = f"(a)\n{GOOD}(b)\nKE lost = 8\n".encode()
    status, out, _ = run("mark", "pair.impact", "-", "--format", "json", stdin=typed, cwd=folder)
    assert status == 0
    assert [json.loads(line)["part"] for line in out.splitlines()] == ["a", "b"]


def test_a_folder_is_one_table(folder):
    status, out, _ = run(
        *("mark", "pair.impact", "scripts", "--letters", "letters.txt", "--csv"), cwd=folder
    )
    rows = list(csv.DictReader(out.splitlines()))
    assert status == 0
    assert [row["script"] for row in rows] == ["ann.txt", "bob.txt"]
    assert [row["mistakes"] for row in rows] == ["", "momentum-sign"]
    assert int(rows[0]["earned"]) > int(rows[1]["earned"])


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
