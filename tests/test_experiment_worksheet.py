"""The worksheet of the experiment: what it holds, and that its answers are right."""

from __future__ import annotations

import io
import math
import re
import unicodedata

import pypdf
import pytest
from commands import run

from restitution import law
from restitution.drawing.scene import Line
from restitution.errors import StatementError
from restitution.experiments import questions
from restitution.experiments.formulas import FORMULAS, mixed
from restitution.experiments.worksheet import MOST_TRIALS, _Grid, _grid, worksheet
from restitution.render.document import Document, Heading, Item, Listing, Table
from restitution.render.document.html import to_html
from restitution.render.document.typst import to_pdf
from restitution.render.layout import Letter
from restitution.render.text import to_text
from restitution.vector import Vector


def printed(document: Document) -> list[str]:
    """The text of each page of A4."""
    read = pypdf.PdfReader(io.BytesIO(to_pdf(document)))
    assert all(tuple(map(round, page.mediabox[2:])) == (595, 842) for page in read.pages)
    return [
        " ".join(unicodedata.normalize("NFKC", page.extract_text()).split()) for page in read.pages
    ]


def words(template: str) -> list[str]:
    """Words of a template that stand outside its formulas, with no hyphen in them."""
    return re.findall(r"(?<![\w-])[A-Za-z]{4,}(?![\w-])", re.sub(r"\{\w+\}", " ", template))


def in_order(wanted: list[str], found: str) -> bool:
    rest = iter(re.findall(r"[A-Za-z]{4,}", found.replace("ﬁ", "fi")))
    return all(word in rest for word in wanted)


@pytest.mark.parametrize("trials", [3, 8, 9, 40])
def test_the_table_has_a_row_for_each_trial(trials):
    document = worksheet(trials)
    (table,) = (each for each in document.blocks if isinstance(each, Table))
    assert len(table.rows) == trials
    assert all(len(row) == 7 and row[2:] == ("",) * 5 for row in table.rows)
    angles = [float(str(row[1]).removesuffix("°")) for row in table.rows]
    assert angles == sorted(angles) and angles[-1] - angles[0] >= 20
    assert printed(document)


def test_all_that_is_said_and_asked_is_printed():
    document = worksheet()
    text = " ".join(printed(document))
    said = [questions.AIM, questions.APPARATUS, *questions.METHOD]
    assert in_order([word for each in said for word in words(each)], text)
    asked = [word for each in questions.QUESTIONS for word in words(each.words)]
    assert in_order(asked, text[text.index("Questions") :])
    page = to_html(document)
    assert page.count("<li>") == len(questions.METHOD) + len(questions.QUESTIONS)
    assert page.count("<svg") == 2


def test_answers_stand_behind_for_the_teacher_alone():
    plain, answers = printed(worksheet()), printed(worksheet(solutions=True))
    assert all(re.search(r"Name \.{10}", page) for page in plain)
    assert not any("Name ...." in page for page in answers)
    assert "For the teacher" not in " ".join(plain)
    assert len(answers) > len(plain)
    behind = " ".join(answers[len(plain) :])
    assert in_order([word for each in questions.QUESTIONS for word in words(each.answer)], behind)
    assert "--angle-error 1" in behind


def test_the_law_is_what_the_two_equations_give():
    assert to_text(FORMULAS["along"]) == "v cos β = u cos α"
    assert to_text(FORMULAS["across"]) == "v sin β = eu sin α"
    assert to_text(FORMULAS["law"]) == "tan β = e tan α"


def test_words_with_formulas():
    assert mixed("the slope is {e}.") == ("the slope is ", Letter("e"), ".")
    with pytest.raises(KeyError):
        mixed("{f}")


def answer_to(start: str) -> str:
    (question,) = (each for each in questions.QUESTIONS if start in each.words)
    return question.answer


def test_tangents_of_the_answer():
    answer = answer_to("tan 44°")
    for angle, value in re.findall(r"tan (\d+)° = ([\d.]+\d)", answer):
        places = len(value.partition(".")[2])
        assert f"{math.tan(math.radians(int(angle))):.{places}f}" == value
    for angle, size, share in ((45, "0.035", "3.5%"), (80, "0.6", "10%")):
        low, high = (math.tan(math.radians(angle + d)) for d in (-1, 1))
        half = (high - low) / 2
        assert half == pytest.approx(float(size), abs=0.5 * 10 ** -len(size.partition(".")[2]))
        assert f"±{size}, or {share}" in answer
        middle = math.tan(math.radians(angle))
        assert 100 * half / middle == pytest.approx(float(share[:-1]), rel=0.04)


def test_from_the_normal_comes_one_over_e():
    alpha, e = math.radians(50), 0.6
    beta = math.atan(e * math.tan(alpha))
    ratio = math.tan(math.pi / 2 - beta) / math.tan(math.pi / 2 - alpha)
    assert ratio == pytest.approx(1 / e)
    assert "one over {e}" in answer_to("from the normal")


def test_friction_makes_the_ratio_larger():
    alpha, e, kept = math.radians(40), 0.6, 0.9
    beta = math.atan2(e * math.sin(alpha), kept * math.cos(alpha))
    assert math.tan(beta) / math.tan(alpha) > e
    assert "{ratio} is larger than {e}" in answer_to("wall is rough")


def test_expected_angles_are_those_of_the_law_of_impact():
    document = worksheet(solutions=True)
    table = [each for each in document.blocks if isinstance(each, Table)][-1]
    assert len(table.rows) > 8
    still, down = Vector(0.0, 0.0), Vector(0.0, -1.0)
    for row in table.rows:
        alpha = math.radians(float(str(row[0]).removesuffix("°")))
        u = Vector(math.cos(alpha), -math.sin(alpha))
        for head, cell in zip(table.heads[1:], row[1:], strict=True):
            e = float(str(head[1]).removeprefix(" = "))
            v, _ = law.impact(u, still, 1.0, 0.0, down, e)
            assert cell == f"{math.degrees(math.atan2(v.y, v.x)):.1f}°"


@pytest.mark.parametrize("most", [1.5, 2.0, 4.5])
def test_axes_have_a_line_every_tenth(most):
    scene = _grid(_Grid(most, 100.0))
    lines = [each for each in scene.shapes if isinstance(each, Line)]
    assert len(lines) == 2 * round(10 * most)
    numbers = [to_text(label.content) for label in scene.labels]
    assert numbers.count("0.0") == 2 and f"{math.floor(most):.1f}" in numbers


@pytest.mark.parametrize("trials", [-1, 0, 2, MOST_TRIALS + 1])
def test_too_few_or_too_many_trials_are_refused(trials):
    with pytest.raises(StatementError, match=f"trials is {trials}"):
        worksheet(trials)


def test_a_title_of_ones_own():
    document = worksheet(title="Lab 3 <A>")
    assert "<h1>Lab 3 &lt;A&gt;</h1>" in to_html(document)
    assert "Lab 3 <A>" in printed(document)[0]
    kinds = [each for each in document.blocks if isinstance(each, Heading)]
    assert [each.words for each in kinds][:3] == ["Aim", "Apparatus", "Method"]
    listings = [each for each in document.blocks if isinstance(each, Listing)]
    assert all(isinstance(item, Item) for each in listings for item in each.items)


# --- the command ------------------------------------------------------------------------------


def test_the_command_writes_worksheets(tmp_path):
    path = tmp_path / "wall.pdf"
    usual = ("sheet", "--experiment", "-o")
    assert run(*usual, path, "--trials", "5") == (0, "", "")
    assert path.read_bytes() == to_pdf(worksheet(5))
    path = tmp_path / "wall.html"
    assert run(*usual, path, "--solutions", "--title", "Lab") == (0, "", "")
    assert path.read_text(encoding="utf-8") == to_html(worksheet(solutions=True, title="Lab"))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--experiment", "-o", "a.pdf", "--trials", "2"), "from 3 to 40"),
        (("--experiment", "-o", "a.pdf", "b.impact"), "no files"),
        (("--experiment", "-o", "a.pdf", "--scheme"), "no --scheme"),
        (("--experiment", "-o", "a.tex"), ".pdf, .html"),
        (("-o", "a.pdf", "--trials", "4", "b.impact"), "--experiment"),
        (("-o", "a.pdf"), "FILE"),
    ],
)
def test_the_command_refuses_what_has_no_meaning(arguments, said, tmp_path):
    status, _, messages = run("sheet", *arguments, cwd=tmp_path)
    assert status == 2 and said in " ".join(messages.split())
    assert not list(tmp_path.iterdir())
