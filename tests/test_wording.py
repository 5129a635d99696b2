"""Questions worded from statements: nothing lost, nothing invented, and in good English.

What a statement says is read here from its own text, not from what the wording was made of.
"""

from __future__ import annotations

import doctest
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from hypothesis import given, settings
from laws_of_questions import fragment, plain, sentences, worded
from statements import FILES
from strategies import problems

import restitution as r
from restitution.errors import StatementError
from restitution.language import parse
from restitution.render.text import to_text as one_line
from restitution.wording import (
    Emphasis,
    question,
    telling,
    to_html,
    to_markdown,
    to_text,
    to_typst,
)

ROOT = Path(__file__).parent
GOLDEN = sorted((ROOT / "wordings").glob("*.txt"))

IMPACT = r"[A-Z]\w*(?: then)? (?:hits|collides with) [A-Z]"


# --- nothing lost ---------------------------------------------------------------------------------


def test_the_sides_of_an_angle_are_told_where_they_matter():
    """A wall and an angle, mirrored, is the same question; with a vector asked for it is not."""
    lines = "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
    assert "clockwise" not in to_text(question(parse(lines + "find speed(P)")))
    said = to_text(question(parse(lines + "find velocity(P)")), 1000)
    assert "towards W at an acute angle α clockwise from 𝐢" in said
    assert "𝐣 at 90° anticlockwise from 𝐢" in said


@pytest.mark.parametrize("asked", ["speed(P)", "angle(velocity(P), OY), energy_lost"])
def test_towards_the_first_of_two_perpendicular_walls(asked):
    """Mirrored, it is the same question, so that the angle is told with the wall alone."""
    walls = "wall OX: along i\nwall OY: along j\nsphere P: mass 2, velocity 5 at alpha from -i\n"
    text = f"{walls}P hits OX: e = 1/2\nP hits OY: e = 1/3\nfind {asked}"
    said = to_text(question(parse(text)), 1000)
    assert "towards OX at an acute angle α to OX" in said and "clockwise" not in said
    said = to_text(question(parse(text + "\nfind velocity(P)")), 1000)
    assert "at an acute angle α anticlockwise from −𝐢" in said


def test_the_side_of_parallel_paths_is_told_where_it_matters():
    text = (
        "sphere A: mass 2m, radius r, velocity u i\nsphere B: mass m, radius r, velocity -3u i\n"
        "A hits B: offset 1.2r, e = 1/4\nfind speed(A)"
    )
    assert "a distance 1.2r apart." in to_text(question(parse(text)), 1000)
    said = to_text(question(parse(text + "\nfind velocity(A)")), 1000)
    assert "that of B on the left as seen by A" in said
    assert "with 𝐣 at 90° anticlockwise from 𝐢" in said


def test_nothing_is_called_a_value_that_may_hold_a_coefficient():
    text = (
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 7m, at rest\n"
        "A hits B: along i{e}\ngiven deflection(A) = 90°\npart a\nfind tan(alpha)"
    )
    said = to_text(question(parse(text.format(e=""))), 1000)
    assert "Find tan α." in said
    said = to_text(question(parse(text.format(e=", e = 6/7"))), 1000)
    assert "Find the value of tan α." in said


def test_a_fact_stands_beside_the_angle_that_it_tells():
    text = (
        "sphere A: mass 4, velocity 13 at alpha\nsphere B: mass 1, velocity -6i\n"
        "given tan(alpha) = 12/5\nA hits B: along i\nfind e"
    )
    said = to_text(question(parse(text)), 1000)
    assert "from 𝐢, where tan α = 12/5, and B is moving with velocity −6𝐢 m s⁻¹." in said


@pytest.mark.parametrize(
    ("mass", "velocity", "facts", "wanted"),
    [
        ("2", "3i - 4j", "", ["2 kg", "(3𝐢 − 4𝐣) m s⁻¹"]),
        ("m", "u i", "", ["mass m,", "velocity u𝐢."]),
        ("2m", "3u at 60°", "", ["mass 2m,", "speed 3u towards W at"]),
        ("m", "p i + 3j", "", ["(p𝐢 + 3𝐣) m s⁻¹", "p is a constant"]),
        ("2", "u i", "given speed(P) = 3", ["u𝐢 m s⁻¹", "u is a positive constant"]),
        ("2", "u at 60°", "given impulse = 12", ["speed u m s⁻¹", "12 N s"]),
        ("2", "5 at alpha", "", ["5 m s⁻¹ towards W at an acute angle α"]),
        ("2", "3i", "given energy_lost = 6", ["6 J"]),
        ("m", "6i", "given impulse = 12", ["m kg", "12 N s"]),
        ("m", "u cos(alpha) i + u sin(alpha) j", "", ["where α is acute"]),
        ("2", "u i - j", "", ["(u𝐢 − 𝐣) m s⁻¹"]),
        ("m", "u(2i + j)", "", ["velocity u(2𝐢 + 𝐣)."]),
        ("m", "-v j", "find v", ["velocity −v𝐣, where v is a positive constant."]),
    ],
)
def test_units_stand_behind_numbers(mass, velocity, facts, wanted):
    text = f"wall W: along i\nsphere P: mass {mass}, velocity {velocity}\nP hits W\n{facts}\nfind e"
    said = to_text(question(parse(text)), 1000).replace("\u00a0", " ")
    said = re.sub(r", where p is", "\n p is", said)
    for each in wanted:
        assert each in said


# --- good English ---------------------------------------------------------------------------------


@settings(max_examples=40, deadline=None)
@given(problems())
def test_whatever_the_language_can_say_has_words(problem):
    asked = question(problem)
    for each in sentences(asked):
        assert re.match(r"[A-Z]", plain(each)) and plain(each).endswith((".", ","))
    ET.fromstring(fragment(asked).replace("<wbr>", ""))  # HTML has no end of such a tag
    assert to_markdown(asked) and to_typst(asked)


@pytest.mark.parametrize("path", GOLDEN, ids=[each.stem for each in GOLDEN])
def test_wordings_that_have_been_read(path):
    (source,) = [each for each in FILES if each.stem == path.stem]
    assert to_text(worded(source)) + "\n" == path.read_text(encoding="utf-8")


def test_there_are_wordings_to_compare_with():
    assert len(GOLDEN) >= 15


# --- how it looks ---------------------------------------------------------------------------------


def test_text_of_a_user_is_never_markup():
    problem = parse("title <b>*x*</b> $y$ #z\nsphere P: velocity i\nfind speed(P)")
    asked = question(problem)
    assert "<b>" not in to_html(asked)
    assert r"\<b\>\*x\*\</b\> \$y\$ \#z" in to_markdown(asked)
    assert '#strong[#"<b>*x*</b> $y$ #z";]' in to_typst(asked)


@pytest.mark.parametrize("columns", [40, 80])
def test_lines_keep_to_the_width(columns):
    for path in FILES[::7]:
        asked = worded(path)
        pieces = [piece for each in sentences(asked) for piece in each]
        formulas = [one_line(each) for each in pieces if not isinstance(each, str | Emphasis)]
        for line in to_text(asked, columns).splitlines():
            # A long formula is not broken; nothing but its number and full stop stands beside it.
            whole = max((len(each) for each in formulas if each in line), default=0)
            assert len(line) <= columns or len(line) - whole < 14, line


def test_marks_are_printed():
    text = (ROOT.parent / "src/restitution/examples/mass-ratio.impact").read_text("utf-8")
    asked = question(parse(text), marks={"a": 5, "b": 1})
    said = to_text(asked)
    assert "(5 marks)" in said and "(1 mark)" in said
    assert [part.marks for part in asked.parts] == [5, 1, None]
    for made in (to_html(asked), to_markdown(asked), to_typst(asked)):
        assert "(5 marks)" in made and "(1 mark)" in made


def test_parts_have_the_labels_of_the_statement():
    text = "sphere P: velocity 3i\nfind speed(P)\npart i\nfind energy(P), energy, momentum(P)"
    asked = question(parse(text))
    assert [part.label for part in asked.parts] == [None, "i"]
    (listing,) = asked.parts[1].body
    assert [entry.number for entry in listing.entries] == ["a", "b", "c"]


def test_the_front_door():
    asked = r.question(r.parse("sphere P: velocity 3i\nfind speed(P)"))
    assert str(asked) == to_text(asked)
    assert "<article" in asked._repr_html_()
    assert asked._repr_markdown_() == to_markdown(asked)
    assert doctest.testmod(telling).failed == 0


@pytest.mark.parametrize(
    "problem",
    [
        r.Problem(spheres=(r.Sphere("P", mass=0.1),)),
        r.Problem(spheres=(r.Sphere("P"),), walls=(r.Wall("P"),)),
    ],
)
def test_what_no_statement_could_say_is_refused(problem):
    with pytest.raises(StatementError):
        question(problem)


def test_typst_sets_every_question(tmp_path):
    typst = pytest.importorskip("typst")
    source = tmp_path / "all.typ"
    source.write_text("\n".join(to_typst(worded(each)) for each in FILES), encoding="utf-8")
    assert typst.compile(str(source))[:5] == b"%PDF-"


def test_before_any_event_is_told_a_quantity_is_an_initial_one():
    text = (
        "let R = energy(P)\nwall W: along i\nsphere P: velocity 3i - j\nP hits W: e = 1/2\nfind R"
    )
    said = " ".join(to_text(question(parse(text))).split())
    assert "Let R denote the initial kinetic energy of P." in said


def test_once_a_quantity_is_the_quantity():
    text = "wall W: along i\nsphere P: velocity 3i - j\nP hits W: e = 1/2\nfind 1 impulse"
    assert "Find the magnitude of the impulse" in to_text(question(parse(text)), 200)


@pytest.mark.parametrize(
    ("bounds", "said"),
    [
        ("1 <= k, k <= 8", "where k is a constant and 1 ≤ k ≤ 8."),
        ("k < 8, k > 1", "where k is a constant and 1 < k < 8."),
        ("k > 1", "where k is a constant and k > 1."),
    ],
)
def test_both_bounds_of_a_letter_are_one_chain(bounds, said):
    text = (
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i, e = 1/2\n"
        f"given {bounds}\nfind range of speed(B)"
    )
    assert said in to_text(question(parse(text)), 1000)


def test_what_all_bodies_have_gained_has_words():
    text = "sphere P: mass 2, velocity 3i\nP receives 2j\nfind energy - energy(0)"
    said = to_text(question(parse(text)), 200)
    assert "Find the increase in the kinetic energy of P due to the impulse" in said


def test_long_labels_have_room_in_print(tmp_path):
    """In Typst's own layout every label of a list ends before the column of the words begins."""
    typst = pytest.importorskip("typst")
    quantities = ", ".join(["speed(P)", "energy(P)", "momentum(P)", "velocity(P)"] * 2)
    text = f"sphere P: velocity 3i\npart p100\nfind {quantities}\npart b\nfind speed(P)"
    made = to_typst(question(parse(text)))
    probe = tmp_path / "probe.typ"
    probe.write_text(
        "#show grid: it => { let (first, ..) = it.columns\n"
        "  assert(first >= measure(it.children.at(0).body).width + 0.5em.to-absolute())\n  it }\n"
        + made,
        encoding="utf-8",
    )
    assert typst.compile(str(probe))[:5] == b"%PDF-"


SPHERES = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let beta = direction(A)
"""


def in_one_line(text):
    return to_text(question(parse(text)), 1000)


def test_a_fact_stands_below_what_is_asked_without_it():
    """It is told where it is needed first, and no part of the opening has it."""
    shown = "show tan(beta) = 2 tan(alpha)/(1 - e)\n"
    asked = in_one_line(SPHERES + shown + "given e = 1/3\nfind tan(beta)")
    opening, first, second = re.split(r"\n+ *\(i+\) +", asked)
    assert "⅓" not in opening + first
    assert second.startswith("Given that e = ⅓, find")
    asked = in_one_line(
        SPHERES
        + "find tan(beta) in terms of e, alpha\nfind alpha\ngiven e = 1/2, deflection(A) = 30°"
    )
    opening, first, second = re.split(r"\n+ *\(i+\) +", asked)
    assert "½" not in opening + first
    assert second.startswith("Given that e = ½ and that A is deflected")


@pytest.mark.parametrize(
    "steps",
    [
        # What is asked in no letters, or not in all, may hang on the fact.
        "find tan(beta)\ngiven e = 1/3\nfind speed(A)",
        "find tan(beta) in terms of alpha\ngiven e = 1/3\nfind speed(A)",
        "show tan(beta) = 3 tan(alpha)\ngiven e = 1/3\nfind speed(A)",
        "show tan(beta) = 2 tan(alpha)/(1 - e)\ngiven e = 1/3",
        "given e = 1/3\nfind tan(beta) in terms of e, alpha\nfind speed(A)",
    ],
)
def test_a_fact_stands_in_the_opening_where_what_is_asked_may_hang_on_it(steps):
    assert "e = ⅓" in in_one_line(SPHERES + steps).partition("Let β")[0]


def test_a_name_stands_below_the_one_by_which_it_is_made():
    asked = in_one_line(SPHERES + "let delta = beta - alpha\nfind tan(delta)")
    assert asked.index("Let β") < asked.index("Let δ")


def test_a_line_of_centres_along_a_path_is_said_by_who_moves_along_it():
    asked = in_one_line(SPHERES.replace("along i", "along velocity(A)") + "find speed(A)")
    assert "when A is moving along the line joining their centres" in asked
