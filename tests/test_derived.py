"""Workings by hand on paper: what a reader sees of a derivation, in every format."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from derivations import FOLDER, derivation_of, read_derivation
from pages import too_wide
from playwright.sync_api import Page

import restitution.examples
from restitution.errors import StatementError
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.layouts import Forms, of_tree
from restitution.explaining.lines.saying import Sentence, Slot
from restitution.explaining.lines.sentences import SENTENCES
from restitution.expression import read_expression
from restitution.expression.tree import Letter, Quantity, walk
from restitution.language import parse
from restitution.problem import Problem
from restitution.problem import trees as trees_of_problem
from restitution.render.document.aligned import columns
from restitution.render.document.styles import WORKING
from restitution.render.document.typst import PREAMBLE
from restitution.render.layout import Phrase, Words
from restitution.render.text import to_text as one_line
from restitution.render.text import width
from restitution.solving import solve
from restitution.workings import explain
from restitution.workings.derived import explanation_of
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import (
    Measures,
    as_answer,
    as_decimal,
    percentage,
    rounded,
    with_unit,
)
from restitution.workings.naming.quantities import Naming
from restitution.workings.rendering.document import (
    to_body,
    to_html,
    to_latex,
    to_markdown,
    to_text,
    to_typst,
)
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.principles import about
from restitution.workings.rendering.steps import Step

FILES = sorted(FOLDER.glob("*.txt"))
EACH = pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
FORMATS = (to_text, to_markdown, to_latex, to_html, to_typst)


@cache
def working(path: Path) -> tuple[Problem, Derivation]:
    return read_derivation(path)


@cache
def explained(path: Path) -> Explanation:
    problem, derivation = working(path)
    return explanation_of(derivation, problem)


def steps_of(explanation: Explanation) -> list[Step]:
    return [step for part in explanation.parts for step in part.steps]


def printed(name: str) -> str:
    return to_text(explained(FOLDER / f"{name}.txt"))


# --- laws -----------------------------------------------------------------------------------------


@EACH
def test_no_line_is_wider_than_a_terminal_and_marks_end_it(path: Path) -> None:
    text = to_text(explained(path))
    for line in text.splitlines():
        assert width(line) <= 80, line
        if re.search(r"  (?:D?[MAB]1(?:ft|\*)?)$", line):
            assert width(line) == 80, line
    marks = re.findall(r"(?<!\S)D?[MAB]\d(?:ft|\*)?(?!\S)", text)
    assert len(marks) == explained(path).marks


@EACH
def test_lines_of_latex_leave_room_for_the_marks(path: Path) -> None:
    """What stands between two breaks of a display fits beside the tag."""
    for row in explained(path).rows():
        if row.operands[0] is not None:
            assert columns(row.operands[0]) <= 90
    latex = to_latex(explained(path), document=False)
    assert latex.count(r"\begin{align*}") == latex.count(r"\end{align*}") > 0
    assert "⁻" not in latex


def numbers_in(slot: Slot) -> set[str]:
    """The numbers of equations that a sentence names."""
    if isinstance(slot, tuple):
        return set().union(*map(numbers_in, slot))
    if not isinstance(slot, Sentence):
        return set()
    if slot.id == "derived.number":
        return {str(dict(slot.slots)["number"])}
    return set().union(*(numbers_in(each) for _, each in slot.slots))


@EACH
def test_an_equation_has_a_number_exactly_if_a_later_line_names_it(path: Path) -> None:
    above: list[str] = []
    cited: set[str] = set()
    for step in steps_of(explained(path)):
        spoken = (*step.sentences, *(each for row in step.rows for each in row.reasons))
        named = set().union(*map(numbers_in, spoken))
        assert named <= set(above), "a number is named below its equation"
        cited |= named
        above += [row.number for row in step.rows if row.number]
    assert above == [str(n) for n in range(1, len(above) + 1)]
    assert cited == set(above)


@EACH
def test_no_title_stands_twice_in_succession(path: Path) -> None:
    for part in explained(path).parts:
        last: str | None = None
        for step in part.steps:
            led = step.sentences and step.title is None
            if step.kind in ("heading", "note") or led:
                last = None
            if step.title is not None:
                assert str(step.title) != last, last
                last = str(step.title)


def coordinates(vector: str) -> str:
    """``(21/2)i + 3j`` as ``(21/2, 3)``."""
    parts = dict.fromkeys("𝐢𝐣", "0")
    for above, plain, axis in re.findall(r"(?:\(([^)]*)\)|([^\s𝐢𝐣+]*))([𝐢𝐣])", vector):
        size = above or plain
        parts[axis] = size or "1"
    return f"({parts['𝐢']}, {parts['𝐣']})"


@EACH
def test_every_item_has_a_last_line(path: Path) -> None:
    problem, derivation = working(path)
    text = re.sub(r"\s+", " ", to_text(explained(path)))
    naming = Naming(derivation, problem)
    for end in derivation.items:
        if end.shown:
            assert "as required" in text
            continue
        for links in end.answer.options:
            value = one_line(naming.layout(links[-1].right))
            asked = links[0].left
            if isinstance(asked, Quantity) and asked.kind == "position":
                value = coordinates(value)
            exact = [value]  # a vector stands in decimals that are exact
            exact += [one_line(x) for x, sign in as_answer(links[-1].right) if sign == "="]
            assert any(re.sub(r"\s+", " ", each) in text for each in exact)
    required = text.count("as required")
    assert required == sum(each.shown for each in derivation.items)


@EACH
def test_no_name_of_the_notation_is_printed(path: Path) -> None:
    for form in FORMATS:
        text = form(explained(path))
        visible = re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
        assert not re.search(r"\bevent\b|along\(|None|velocity\(|in the sense of", visible)


@EACH
def test_laws_tell_why(path: Path) -> None:
    laws = [s for s in steps_of(explained(path)) if s.title is not None]
    asked = {"derived-energy", "derived-direction", "derived-speed", "derived-perpendicular"}
    asked |= {"derived-parallel", "derived-assembled", "derived-opposite", "derived-size"}
    for step in laws:
        assert step.title is not None
        assert about(step) or step.title.topic in asked, step.title.id


@EACH
def test_marks_have_reasons_and_belong_to_items(path: Path) -> None:
    for part in explained(path).parts:
        assert sum(part.item_marks) == part.marks
        for step in part.steps:
            points = [mark for each in (step, *step.rows) for mark in each.points]
            assert all(mark.because in SENTENCES for mark in points)


@EACH
def test_paper_is_set(path: Path) -> None:
    typst = pytest.importorskip("typst")
    markup = PREAMBLE + to_typst(explained(path))
    assert typst.compile(markup.encode(), format="pdf", ignore_system_fonts=True)[:4] == b"%PDF"


LONG = """
1 a | let | | let v = c(A, 1)
2 a | rearrange | 1 | energy_lost(1) = 1/2 m u^2 cos^2(alpha) + 1/2 k m w^2 cos^2(beta)\
 - 1/2 m ((1 - k e) u cos(alpha) + k(1 + e) w cos(beta))^2/(1 + k)^2 - 1/2 k m (u + w)^2 | M A
3 a | rearrange | 2 | energy_lost(1) = (((1 - k e) u cos(alpha) + k(1 + e) w cos(beta)\
 + u sin(alpha))((1 + e) u cos(alpha) + (k - e) w cos(beta) + w sin(beta)) + m k) (u + 2w) | A
4 a | rearrange | 3 | m u cos(alpha) + k m w cos(beta) + 3m u sin(alpha) + 5 k m w sin(beta)\
 + energy_lost(1) + 2m u = 1/2 k m w^2 + 1/2 k m w^2 sin^2(beta) = 3 [put]\
 = energy_lost(1) + energy(0) [put] = 77 m k w^2 cos(beta) + 3 m k w^2 [put] | DM A
5 b | shown | 4 | speed(A, 1) = u | A*
a: 4 energy_lost(1) = 3
b: 5 shown speed(A, 1) = u
""".replace("\\\n", "")


@cache
def long_working() -> Explanation:
    """Lines that nobody would print, to see where they end."""
    problem = parse(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, velocity w at beta\n"
        "A hits B: along i\nfind energy_lost\nshow speed(A) = u"
    )
    return explanation_of(derivation_of(problem, LONG), problem)


def test_long_lines_end_before_the_margin_with_their_marks() -> None:
    lines = to_text(long_working()).splitlines()
    assert max(map(width, lines)) == 80
    marked = [line for line in lines if re.search(r" D?[MAB]1\*?$", line)]
    assert len(marked) == 4 and {width(line) for line in marked} == {80}
    latex = to_latex(long_working(), document=False)
    assert latex.count(r"\qquad {}-") == 2


@pytest.mark.parametrize(("wide", "medium"), [(320, "screen"), (680, "print")])
def test_marks_are_in_sight_on_a_phone_and_on_paper(page: Page, wide: int, medium: str) -> None:
    every = [*(explained(path) for path in FILES), long_working()]
    body = "".join(map(to_body, every[: -1 if wide < 600 else None]))
    page.set_viewport_size({"width": wide, "height": 800})
    page.emulate_media(media=medium)  # type: ignore[arg-type]
    page.set_content(f"<!DOCTYPE html><style>body {{ margin: 0 }} {WORKING}</style>{body}")
    assert not too_wide(page)
    hidden = page.evaluate(
        """() => [...document.querySelectorAll("td.m, .mark")].filter((each) => {
          const box = each.getBoundingClientRect();
          return each.textContent && (box.width === 0 || box.right > innerWidth || box.left < 0);
        }).map((each) => each.parentElement.textContent)"""
    )
    assert hidden == []
    scrolled = page.evaluate(
        """() => [...document.querySelectorAll("table, tbody")].filter(
          (each) => each.scrollWidth > each.clientWidth + 1).map((each) => each.textContent)"""
    )
    assert scrolled == []


# --- classes of faults ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("centres-from-the-impulse", ["M = 2", "e = ⅔ "]),
        (
            "centres-slanted",
            ["= (1.4𝐢 + 0.2𝐣) m s⁻¹", "= 7 − 1 = 6 N s", "v = 1 m s⁻¹"],
        ),
        ("times-between-walls", ["t₂ = 7/2 s", "= (21/2, 3) m "]),
        (
            "wall-impulse",
            ["= 2√13 ≈ 7.21 m s⁻¹", "= 3 J", "e = 0.5 ", "stays 8 cos 30° = 4√3 m s⁻¹"],
        ),
        ("find-the-blow", ["= (−1.5𝐢 + 2𝐣) N s", "J = 2.5, as J is positive", "≈ 36.9°"]),
        ("distance-afterwards", ["≈ 7.21 m "]),
        ("both-moving", ["= √17 u ≈ 4.12u ", "= m(4u + 4u) = 8mu "]),
        ("sphere-then-wall", ["𝐯_A = −¼u𝐢 "]),
        ("wall-percentage", ["= ⅕ = 20% "]),
    ],
)
def test_units_stand_with_numbers_and_not_with_letters(name: str, lines: list[str]) -> None:
    text = re.sub(r"\s+", " ", printed(name)) + " "
    for each in lines:
        assert each in text
    if name in ("both-moving", "sphere-then-wall"):
        assert not re.search(r" m s| N s| J ", text)


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("either-sign", ["If p = 4:", "If p = −4:", "𝐯_P = (4𝐢 + 2𝐣) m s⁻¹"]),
        ("rejected-root", ["e = ½, as e ≤ 1"]),
        ("half-angle", ["t = √3/3, as α/2 is acute"]),
        (
            "brought-to-rest",
            ["3u/(2 − e) − u increases with e, from u/2 if e = 0 to 2u if e = 1 (as required)"],
        ),
        ("greatest-deflection", ["when 1 − 2 tan α = 0, so tan α = ½ and α"]),
        (
            "direction-reversed",
            ["Let v and w be the components of the velocities of A and B", "Since v < 0:"],
        ),
        ("heavier-sphere-before-a-wall", ["So B will hit W, as required."]),
        ("three-in-line", ["A is behind B, so they do not collide again if the"]),
        ("corner-of-60", ["It is given that 𝐯_P is perpendicular to BC. BC is parallel to"]),
        ("turned-by-a-wall", ["the angle of deflection of P is 90°", "From (1): tan²α ≥ 1"]),
        ("find-the-blow", ["Comparing components: J sin θ = 1.5", "Dividing (1) by (2):"]),
        ("right-angle", ["0 < tan α ≤ 1/√3, as α is acute (as required)"]),
        (
            "velocities-before",
            [
                "Let 𝐮_A and 𝐮_B be the velocities of A and B before the impact.",
                "It is given that 𝐯_A = (−𝐢 + 2𝐣) m s⁻¹ and 𝐯_B = (2𝐢 − 3𝐣) m s⁻¹.",
            ],
        ),
        (
            "two-coefficients",
            ["Let 𝐯₁ be the velocity of P after the first impact."],
        ),
        ("corner-of-120", ["𝐯₂ · 𝐧 = −(√3/16)u"]),
        ("energy-inequality", ["≤ ½ × total kinetic energy before the impact"]),
        ("wall-by-angles", ["(the speed of P)"]),
        (
            "struck-ball",
            ["Component after the impact: 𝐯_B · 𝐧 ="],
        ),
    ],
)
def test_a_working_says_what_a_reader_looks_for(name: str, lines: list[str]) -> None:
    text = re.sub(r"\s+", " ", printed(name))
    for each in lines:
        assert each in text


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        ("1/sqrt(3)", "√3/3"),
        ("u/sqrt(2)", "√2 u/2"),
        ("3u/(4sqrt(2))", "3√2 u/8"),
        ("2u/sqrt(13)", "2√13 u/13"),
        ("6/sqrt(3)", "2√3"),
        ("sqrt(12)/sqrt(3)", "2"),
        ("u/(v sqrt(2))", "√2 u/(2v)"),
        ("0.5/sqrt(2)", "0.5/√2"),
        ("sqrt(3)/2 * 1/3 u", "(√3/2) × ⅓u"),
        ("7/16 * 1/2 m u^2", "(7/16) × ½mu²"),
        ("2 * 3/5", "2 × ⅗"),
        ("8/3 i + 0j", "(8/3)𝐢"),
        ("5i - 0j", "5𝐢"),
        ("u cos(alpha) v", "(u cos α)v"),
        ("u sin(alpha) u sin(alpha)", "(u sin α)(u sin α)"),
        ("(8 - x) 1/2 u", "½(8 − x)u"),
        ("0.2 v", "0.2v"),
        ("1/5 v", "⅕v"),
    ],
)
def test_a_number_has_one_form(tree: str, text: str) -> None:
    assert one_line(of_tree(read_expression(tree))) == text


def test_a_form_that_was_typed_is_kept_everywhere() -> None:
    forms = Forms([read_expression("tan(alpha) - 1/sqrt(3)")])
    for each in ("1/sqrt(3)", "sqrt(3)/3", "2/(2sqrt(3))"):
        assert one_line(of_tree(read_expression(each), forms=forms)) == "1/√3"
    assert one_line(of_tree(read_expression("1/sqrt(2)"), forms=forms)) == "√2/2"


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        ("sqrt(181)", "13.5"),
        ("8/17", "0.471"),
        ("7/5", None),
        ("1/3", None),
        ("15", None),
        ("sqrt(17) u", "4.12u"),
        ("u cos(alpha)", None),
        ("arctan(3/4)", "36.9°"),
        ("60°", None),
        ("2i + sqrt(3) j", "2.00𝐢 + 1.73𝐣"),
        ("2i + 1/4 j", None),
        ("sqrt(3) j", "1.73𝐣"),
        ("u i + sqrt(3) j", None),
    ],
)
def test_three_figures_in_every_component_or_none(tree: str, text: str | None) -> None:
    decimal = rounded(read_expression(tree))
    assert (None if decimal is None else one_line(decimal)) == text


def test_a_percentage() -> None:
    for tree, shown, sign in (("1/5", "20%", "="), ("1/3", "33.3%", "≈"), ("48/85", "56.5%", "≈")):
        value = percentage(read_expression(tree))
        assert value is not None
        assert (one_line(value[0]), value[1]) == (shown, sign)


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        ("3/2", "1.5"),
        ("-1/8", "−0.125"),
        ("1/3", "⅓"),
        ("3/2 i - 1/4 j", "1.5𝐢 − 0.25𝐣"),
        ("1/2 * 3", "½ × 3"),
        ("(3/8) cos(20°)", "0.375 cos 20°"),
    ],
)
def test_beside_decimals_a_quantity_is_a_decimal(tree: str, text: str) -> None:
    assert one_line(of_tree(as_decimal(read_expression(tree)))) == text


def test_decimals_stay_as_they_were_typed() -> None:
    statement = SPHERES.replace("mass m, velocity u i", "mass 0.2, velocity 3i")
    problem = parse(statement.replace("mass m, at rest", "mass 0.4, at rest"))
    lines = LINES.replace("m u = m v + m w", "0.2 * 3 = 0.2v + 0.4w").replace("1/2 u", "1/2 * 3")
    text = to_text(explanation_of(derivation_of(problem, lines.replace("1/4 u", "-0")), problem))
    assert "0.2 × 3 = 0.2v + 0.4w" in text
    lines = lines.replace("1/4 u", "3/4")
    text = to_text(explanation_of(derivation_of(problem, lines), problem))
    assert "v = 0.75 m s⁻¹" in text and "w − v = ½ × 3" in text


def test_units_follow_what_a_letter_stands_for() -> None:
    problem, derivation = working(FOLDER / "unknown-wall.txt")
    measures = Measures(problem, derivation.meanings)
    assert measures.unit(Letter("R")) == "N\u00a0s"
    assert measures.unit(Letter("x")) == ""
    assert with_unit(Words("v"), "") == Words("v")
    assert with_unit(Words("v"), "m") == Phrase((Words("v"), Words("m")), "\u00a0")


# --- what the notation can hold -------------------------------------------------------------------

SPHERES = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find along(velocity(A), i)
"""
LINES = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
3 a | law momentum 1 A B | mass A, mass B, velocity A, velocity B, axis 1, 1, 2 | m u = m v + m w
4 a | law restitution 1 A B | velocity A, velocity B, axis 1, e 1, 1, 2 | w - v = 1/2 u
5 a | combine w | 3, 4 | 2v = 1/2 u
6 a | rearrange | 5 | v = 1/4 u
a: 6 v = 1/4 u
"""


def shown_as(shown: str, number: int) -> str:
    problem = parse(SPHERES)
    derivation = derivation_of(problem, LINES)
    lines = tuple(
        replace(each, shown=shown) if each.number == number else each for each in derivation.lines
    )
    return to_text(explanation_of(replace(derivation, lines=lines), problem))


def test_a_silent_line_is_not_printed() -> None:
    assert "2v = ½u" in shown_as("line", 5)
    assert "2v = ½u" not in shown_as("silent", 5)


def test_an_inline_line_joins_the_next_as_a_chain() -> None:
    problem = parse(SPHERES)
    text = LINES.replace("2v = 1/2 u\n", "v = 1/2 * 1/2 u\n")
    derivation = derivation_of(problem, text)
    lines = tuple(
        replace(each, shown="inline") if each.number == 5 else each for each in derivation.lines
    )
    assert "v = ½ × ½u = ¼u" in to_text(explanation_of(replace(derivation, lines=lines), problem))


def test_the_sense_of_a_component_is_told() -> None:
    problem = parse(SPHERES)
    text = LINES.replace("let v = c(A, 1)", "let v = c(A, 1) in the sense of -line_of_centres(1)")
    told = re.sub(r"\s+", " ", to_text(explanation_of(derivation_of(problem, text), problem)))
    assert "Let v be the component of the velocity of A along the line of centres" in told
    assert "in the direction of −𝐢" in told and "in the direction of 𝐢" in told


def test_a_component_at_a_wall_counts_away_from_it() -> None:
    problem = parse(
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)"
    )
    text = """
1 a | let | | let v = c(P, 1) in the sense of -line_of_centres(1)
2 a | law restitution-wall 1 P | velocity P, axis 1, e 1, 1 | v = 1/2 * 4
3 a | rearrange | 2 | v = 2
a: 3 v = 2
"""
    lines = to_text(explanation_of(derivation_of(problem, text), problem)).splitlines()
    told = " ".join(lines[:2])
    assert "perpendicular to W, away from it, after the impact" in told
    assert lines[-2:] == ["    v = ½ × 4", "      = 2 m s⁻¹"]


def names(statement: str) -> Naming:
    problem = parse(statement)
    return Naming(Derivation(facts_of(problem), (), (), events_of(problem)), problem)


BLOW = """
wall W: along j, through (5, 0)
point N: (1, 1)
sphere P: mass 2, at (0, 0), velocity 3i
P receives 2j
P hits W: e = 1/2
P reaches N
find speed(P)
"""


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        ("velocity(P, 0)", "𝐮_P"),
        ("speed(P, 0)", "speed of P at the start"),
        ("speed(P, 1)", "speed of P after the impulse"),
        ("speed(P, 2)", "speed of P"),
        ("position(P, 2)", "position of P at the impact"),
        ("position(P, 3)", "position of P when P reaches N"),
        ("impulse(2)", "magnitude of the impulse at the impact"),
        ("along(velocity(P, 2), i)", "component of 𝐯_P along 𝐢"),
        ("along(velocity(P, 2), line_of_centres(2))", "component of 𝐯_P along 𝐢"),
        ("restitution(2)", "coefficient of restitution at the impact"),
        ("energy(0)", "kinetic energy at the start"),
    ],
)
def test_a_quantity_is_called_by_its_time(tree: str, text: str) -> None:
    known = {"P": "sphere", "W": "wall", "N": "point", "restitution": "quantity"}
    assert one_line(names(BLOW).layout(read_expression(tree, names=known))) == text


def test_a_letter_that_is_taken_is_not_given_again() -> None:
    free, taken = names(BLOW), names(BLOW.replace("velocity 3i", "velocity t_2 i"))
    when = read_expression("time(2)", names={})
    assert one_line(free.layout(when)) == "t₂"
    assert [str(each).count("time of the impact") for each in map(said, free.introduced())] == [1]
    assert one_line(taken.layout(when)) == "time of the impact"
    assert taken.introduced() == ()


def said(sentence: Sentence) -> str:
    return "".join(each if isinstance(each, str) else one_line(each) for each in sentence.words)


def every_statement() -> list[Path]:
    folders = (Path(restitution.examples.__file__).parent, FOLDER.with_name("questions"))
    return sorted(each for folder in folders for each in folder.glob("*.impact"))


def test_every_quantity_of_every_statement_has_a_name() -> None:
    """Whatever a working may speak of is called in words that a reader knows."""
    paths = every_statement()
    assert len(paths) > 100
    for path in paths:
        try:
            problem = parse(path.read_text(encoding="utf-8"))
        except StatementError:
            continue
        derivation = Derivation(facts_of(problem), (), (), events_of(problem))
        naming = Naming(derivation, problem)
        said = [
            one_line(naming.layout(each))
            for tree in trees_of_problem(problem)
            for each in walk(tree)
            if isinstance(each, Quantity)
        ]
        for fact in derivation.facts:
            told = fact_in_words(naming, fact)
            words = told.words if isinstance(told, Sentence) else (told,)
            said.append("".join(w if isinstance(w, str) else one_line(w) for w in words))
        for text in said:
            assert not re.search(r"\bevents?\b|\bq_?\d|None|_of_|  ", text), (path.name, text)


def test_a_square_of_a_name_of_several_words_has_brackets() -> None:
    question = """
    sphere A: mass m, velocity u at alpha
    sphere B: mass m, at rest
    A hits B: along i, e = 1/2
    find speed(B)^2
    """
    text = to_text(explain(solve(parse(question))))
    assert "(speed of B)²" in text
    assert "speed of B²" not in text.replace("(speed of B)²", "")


def test_an_answer_that_is_a_difference_of_quantities_has_its_unit() -> None:
    question = """
    wall W: along i
    sphere P: mass 2, velocity 3i - 4j
    P hits W: e = 1/2
    find energy(P, 0) - energy(P), speed(P)/speed(P, 0)
    """
    text = to_text(explain(solve(parse(question))))
    assert re.search(r"= 12 J\b", text)
    assert re.search(r"0\.721 +A1", text), "a ratio has none"


@pytest.mark.parametrize(
    "name",
    [
        "circle-wall",
        "corner",
        "mass-ratio",
        "right-angles-afterwards",
        "three-spheres-oblique",
    ],
)
def test_a_working_is_written_once_where_its_bold_letters_are_foreseen(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    solution = solve(parse(restitution.examples.text(name)))
    written: list[Derivation] = []
    init = Naming.__post_init__

    def counted(naming: Naming) -> None:
        written.append(naming.derivation)
        init(naming)

    monkeypatch.setattr(Naming, "__post_init__", counted)
    assert "𝐯" in str(explain(solution))
    assert len(written) == 1
