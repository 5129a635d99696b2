"""Versions of a sheet with other numbers, and mark schemes."""

from __future__ import annotations

import re

import pytest
from commands import run

import restitution as r
from restitution.export import sheet
from restitution.export.mark_scheme import to_table
from restitution.practice.marking import mark_scheme as schemes
from restitution.practice.marking.mark_scheme import mark_scheme
from restitution.practice.questions.varying import variant
from restitution.render.document import Document, Numbered, Room, html, typst
from restitution.render.document.text import to_text
from restitution.workings import explain

STATEMENT = """title A ball & a cushion
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W: e = 1/3
part a
find velocity(P)
part b
find energy_lost
"""

AT_AN_ANGLE = """sphere A: mass 5, velocity 5 at alpha
sphere B: mass 1, velocity -3i
given tan(alpha) = 4/3
A hits B: along i, e = 1/3
find speed(A), speed(B)
"""  # 13/3 and 7
TANGENTS = {"3/4": 5, "4/3": 5, "5/12": 13, "12/5": 13}


@pytest.fixture(scope="module")
def rows():
    return mark_scheme(r.solve(r.parse(STATEMENT)))


def test_a_scheme_has_the_marks_of_the_working(rows):
    parts = explain(r.solve(r.parse(STATEMENT))).parts
    for part in parts:
        own = [row for row in rows if row.part == part.label]
        assert sum(len(row.marks) for row in own) == part.marks


def test_a_scheme_names_usual_wrong_answers(rows):
    notes = " ".join(note for row in rows for note in row.notes)
    assert "5𝐢 + 9𝐣 (restitution upside down)" in notes  # 3 ÷ ⅓ = 9
    assert "M0: " in notes


@pytest.fixture
def notes(monkeypatch):
    """The notes of a scheme, whatever time it takes: worlds are counted, and operations."""
    monkeypatch.setattr(schemes, "_SECONDS", 120)

    def of(text):
        return [note for row in mark_scheme(r.solve(r.parse(text))) for note in row.notes]

    return of


def test_usual_wrong_answers_can_happen(notes):
    text = STATEMENT.replace("energy_lost", "energy_lost/energy(0)")
    *_, lost = (note for note in notes(text) if "wrong answers" in note)
    assert "(restitution without e)" in lost
    assert "upside down" not in lost and "−" not in lost  # e = 3: kinetic energy would be gained


def test_worlds_of_mistakes_are_counted(notes, monkeypatch):
    every = sum(note.count(" (") for note in notes(AT_AN_ANGLE) if "wrong answers" in note)
    monkeypatch.setattr(schemes, "_WORLDS", 1)
    one = sum(note.count(" (") for note in notes(AT_AN_ANGLE) if "wrong answers" in note)
    assert one < every
    monkeypatch.setattr(schemes, "_WORLDS", 24)
    monkeypatch.setattr(schemes, "_OPERATIONS", 1)
    assert not any("wrong answers" in note for note in notes(AT_AN_ANGLE))


def test_usual_wrong_answers_are_short(notes):
    text = " ".join(notes(AT_AN_ANGLE))
    assert "4.24 (restitution with whole speeds)" in text  # (5√1153 − 17)/36
    assert "√1513/9 = 4.32 (restitution in the wrong direction)" in text


def test_a_mistake_that_keeps_its_method_is_not_condoned(notes):
    text = " ".join(notes(AT_AN_ANGLE))
    assert "Allow M1 (A0) for: a sign in momentum" in text and "Condone" not in text


def test_tables_are_escaped(rows):
    table = to_table(rows)
    assert html.to_blocks([table]).count("<tr>") == len(rows) + 2
    assert typst.to_blocks([table]).count("table(") == 1
    text = to_text(Document("", (table,)))
    assert max(map(len, text.splitlines())) <= 80 and "Newton" in text


def test_the_command_sets_versions_with_their_schemes(tmp_path):
    path = tmp_path / "ball.impact"
    path.write_text(STATEMENT, encoding="utf-8")
    output = tmp_path / "test.html"
    status, _, messages = run("sheet", path, "-o", output, "--variants", "2", "--seed", "7")
    assert status == 0, messages
    assert "the wall stays as it is, as velocities are told by it" in messages
    names = sorted(each.name for each in tmp_path.glob("*.html"))
    assert names == ["test-1-scheme.html", "test-1.html", "test-2-scheme.html", "test-2.html"]
    one, other = (tmp_path / f"test-{n}.html" for n in (1, 2))
    assert one.read_text(encoding="utf-8") != other.read_text(encoding="utf-8")
    assert "Mark scheme" in (tmp_path / "test-1-scheme.html").read_text(encoding="utf-8")
    assert "Mark scheme" not in one.read_text(encoding="utf-8")
    room = re.compile(r'<div style="height:[^0]')
    assert room.search(one.read_text(encoding="utf-8"))
    assert not room.search((tmp_path / "test-1-scheme.html").read_text(encoding="utf-8"))


def test_a_title_with_a_number_is_left_out_and_that_is_said(tmp_path):
    rest = re.sub("^title .*\n", "", STATEMENT, flags=re.MULTILINE)
    titled, plain = (r.parse(f"title {title}\n{rest}") for title in ("Test 3", "A test"))
    assert any("title is left out" in note for note in variant(titled, 1).notes)
    assert not any("title" in note for note in variant(plain, 1).notes)


def test_a_seed_needs_versions(tmp_path):
    path = tmp_path / "ball.impact"
    path.write_text(STATEMENT, encoding="utf-8")
    status, _, messages = run("sheet", path, "-o", tmp_path / "x.html", "--seed", "3")
    assert status == 2 and "this needs --variants" in messages


def test_versions_need_a_file_each(tmp_path):
    path = tmp_path / "ball.impact"
    path.write_text(STATEMENT, encoding="utf-8")
    status, _, _ = run("sheet", path, "-o", "-", "--format", "html", "--variants", "2")
    assert status == 2


@pytest.mark.parametrize("seed", [7, 8, 9])
def test_a_version_has_values_as_plain_as_the_question(seed):
    text = variant(r.parse(AT_AN_ANGLE), seed).statement
    varied = r.parse(text)
    tangent = next(sides for sides in TANGENTS if f"tan(alpha) = {sides}\n" in text)
    hypotenuse = TANGENTS[tangent]
    speed = varied.spheres[0].velocity.size.value
    assert speed % hypotenuse == 0  # so that its components are whole
    (part,) = r.solve(varied).parts.values()
    for item in part.items:
        assert item.distinct[0].value.is_Rational and item.distinct[0].value.q <= 15


def test_notes_speak_of_angles_only_where_the_question_has_one(notes):
    text = """
sphere A: mass 2, velocity 5i + 2j
sphere B: mass 3, velocity -i + 4j
A hits B: along i, e = 1/3
find velocity(A)
"""
    own = " ".join(notes(text))
    assert "M0: " in own and "sine and cosine" not in own and "wrong line" not in own
    own = " ".join(notes(text.replace("5i + 2j", "5 at 30°")))
    assert "sine and cosine" in own


def test_a_version_without_a_question_says_so_and_keeps_the_numbers(tmp_path):
    wrong, right = tmp_path / "wrong.impact", tmp_path / "right.impact"
    wrong.write_text(STATEMENT.replace("find velocity(P)", "find v"), encoding="utf-8")
    right.write_text(STATEMENT, encoding="utf-8")
    output = tmp_path / "test.html"
    _, _, messages = run("sheet", wrong, right, "-o", output, "--variants", "1", "--seed", "7")
    assert messages.startswith("version 1: question 1 left out: ")
    entry = sheet.Entry(None, (), Room(0))
    assert sheet.to_document([None, entry], None, sheet.Options()).blocks == (Numbered(2, "", ()),)


@pytest.mark.parametrize("seed", [2, 3, 4])
def test_a_given_speed_without_a_root_has_none_in_a_version(seed):
    text = """
wall F: along 4i + 3j
sphere Q: mass 3, velocity i + 7j
Q hits F
given speed(Q) = 5
find e
"""
    assert "sqrt" not in variant(r.parse(text), seed).statement


def test_a_mass_of_one_m_is_m():
    text = AT_AN_ANGLE.replace("mass 5", "mass 2m").replace("mass 1", "mass 3m")
    drawn = [variant(r.parse(text), seed).statement for seed in range(1, 7)]
    assert any("mass m," in each for each in drawn)
    assert not any("1m" in each or "1 m" in each for each in drawn)


RANGES = {
    "a mass of which one is stopped by a wall": """
wall W: along j
sphere A: mass m, velocity -u i
sphere B: mass k m, at rest
A hits W: e = 2/3
A hits B: along i, e = 1/4
given A and W collide again
find range of k
""",
    "a ratio of masses by a turned velocity": """
sphere P: mass q m, velocity w j
sphere Q: mass m, velocity -2w j
P hits Q: along j, e = 2/5
given velocity(P) opposite to velocity(P, 0)
find range of q
""",
    "a coefficient by a second collision behind a wall": """
wall F: along i
sphere R: mass 2m, velocity v j
sphere S: mass 3m, at rest
R hits S: along j
S hits F: e = 3/4
given R and S collide again
find range of e
""",
}


@pytest.mark.parametrize("text", RANGES.values(), ids=RANGES)
def test_a_range_has_a_scheme_and_worlds_of_mistakes(text):
    solution = r.solve(r.parse(text))
    # In this mistake's law a letter decides which root is taken.
    assert [*schemes._worlds(solution, "restitution-whole-speed")]
    *_, last = mark_scheme(solution)
    assert last.marks[-1] == "A1"
    assert solution.parts[None].items[0].answers[0].display.startswith(last.working)


def test_no_world_is_worked_out_where_nothing_has_a_usual_wrong_answer(monkeypatch):
    monkeypatch.setattr(schemes, "_worlds", lambda *_: pytest.fail("a world is worked out"))
    assert mark_scheme(r.solve(r.parse(RANGES["a ratio of masses by a turned velocity"])))


FALSE = {
    "part b: speed(P) = 6 is to be shown, and is not true": STATEMENT.replace(
        "find energy_lost", "show speed(P) = 6"
    ),
    "deflection(S) = 90° is to be shown, and is not true": """
wall F: along j
sphere S: mass m, velocity u at theta
S hits F
show speed(S) <= u
show deflection(S) = 90°
""",
    "range of e: 1/2 < e <= 1 is to be shown, and is not true": """
wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W
given speed(P) > 26/5
show range of e: 1/2 < e <= 1
""",
}


@pytest.mark.parametrize(("words", "text"), FALSE.items(), ids=["value", "letters", "range"])
def test_a_sheet_warns_of_what_is_to_be_shown_and_is_not_true(words, text, tmp_path):
    path, output = tmp_path / "false.impact", tmp_path / "sheet.html"
    path.write_text(text, encoding="utf-8")
    status, _, messages = run("sheet", path, "-o", output, "--no-diagrams")
    assert status == 0 and output.exists()
    assert messages == f"{path}: warning: {words}\n"
    # Nothing is drawn for it: a value that is worked out again would make it true.
    with pytest.raises(
        r.UnsupportedError, match=re.escape(f"cannot be varied: {words}")
    ) as refused:
        variant(r.parse(text))
    assert text.splitlines()[refused.value.line - 1].startswith("show ")
