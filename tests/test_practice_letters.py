"""What a student's letters mean: declared, usual, inferred; the letters box."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from lines_of_practice import in_script

import restitution as r
from restitution.errors import LettersError, StatementError
from restitution.expression import read_expression, write_expression
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Expression
from restitution.practice.letters.candidates import is_odd
from restitution.practice.letters.declaring import letters_from_mapping, letters_from_text
from restitution.practice.letters.interpretation import Interpretations
from restitution.practice.letters.letters import meanings_of
from restitution.practice.letters.letters_box import letters_box
from restitution.practice.script import (
    ANYWHERE,
    Claim,
    Decimal,
    Declaration,
    Link,
    Scope,
    Script,
    ScriptLine,
)
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.sampling import true_worlds
from restitution.problem import Problem
from restitution.solving.equations.solution import Solution

SPHERES = """\
sphere A: mass 3, velocity 4i - 3j
sphere B: mass 5, velocity -i + 2j
A hits B: along i, e = 3/5
find velocity(A), velocity(B), impulse
"""
WALL = """\
wall W: along i
sphere P: mass 3, velocity 8 at 35° to W
P hits W: e = 3/4
find speed(P), angle(velocity(P), W)
"""
TWO_WALLS = """\
wall AB: along i
wall BC: along 70°
sphere P: velocity u at 40° to AB
P hits AB: e = 2/3
P hits BC: e = 1/4
find speed(P)
"""


@lru_cache
def solved(statement: str) -> tuple[Problem, Solution]:
    problem = r.parse(statement)
    return problem, r.solve(problem)


def script_of(text: str, problem: Problem, scopes: Mapping[int, Scope] | None = None) -> Script:
    """Lines of plain relations in the language of statements: a small double of the reader."""
    names = {each.name for each in (*problem.spheres, *problem.walls)}
    lines = []
    for number, line in enumerate(text.splitlines(), 1):
        column, sides = 1, []
        for side in line.split("="):
            shift = len(side) - len(side.lstrip())
            sides.append(
                in_script(read_expression(side.strip(), names=names, column=column + shift))
            )
            column += len(side) + 1
        decimals = tuple(
            Decimal(
                match.start() + 1,
                Fraction(match.group()),
                len(match.group().replace(".", "").lstrip("0")),
                Fraction(1, 2 * 10 ** len(match.group(1))),
            )
            for match in re.finditer(r"\d*\.(\d+)", line)
        )
        links = tuple(Link((Claim(a, "=", b),), 1, len(line), decimals) for a, b in pairwise(sides))
        scope = (scopes or {}).get(number, ANYWHERE)
        lines.append(ScriptLine(number, line, "relations", scope=scope, links=links))
    return Script(tuple(lines))


def inferred(
    statement: str,
    text: str,
    declared: Mapping[str, tuple[Expression, ...]] | None = None,
    scopes: Mapping[int, Scope] | None = None,
) -> Interpretations:
    problem, solution = solved(statement)
    return meanings_of(script_of(text, problem, scopes), problem, solution, None, declared)


def quantities(each: Interpretations, line: int = 99) -> dict[str, str]:
    return {name: write_expression(tree) for name, tree in each.best.trees(line).items()}


@pytest.mark.parametrize(
    "text",
    [
        "3v + 5w = 3*4 - 5\nw - v = 3/5*5",
        "3v + 5w = 7\nv = w - 3\nv = -1\nw = 2",
        "3x + 5y = 3*4 + 5*-1\ny - x = 3\ny = 2",
        "3v_1 + 5v_2 = 7\nv_2 - v_1 = 3",
    ],
)
def test_components_after_are_inferred_from_the_two_laws(text: str) -> None:
    inference = inferred(SPHERES, text)
    first, second = sorted(inference.best.trees(1))
    assert quantities(inference)[first] == "along(velocity(A, 1), i)"
    assert quantities(inference)[second] == "along(velocity(B, 1), i)"
    assert not inference.asks


def test_a_sense_is_turned_where_the_equation_of_momentum_says_so() -> None:
    inference = inferred(SPHERES, "-3v + 5w = 7\nw + v = 3\nv = 1")
    assert quantities(inference) == {
        "v": "-along(velocity(A, 1), i)",
        "w": "along(velocity(B, 1), i)",
    }


def test_a_wrong_equation_of_momentum_does_not_turn_the_letters() -> None:
    inference = inferred(SPHERES, "3v + 5w = 17\nw - v = 3\n8w = 26")
    assert quantities(inference)["w"] == "along(velocity(B, 1), i)"
    assert all(write_expression(each.trees(1)["w"]) != "speed(A, 1)" for each in inference)


def test_a_speed_and_an_angle_at_a_wall() -> None:
    inference = inferred(WALL, "v cos(beta) = 8 cos(35°)\nv sin(beta) = 3/4*8 sin(35°)")
    assert quantities(inference)["v"] == "speed(P, 1)"
    assert quantities(inference)["beta"] == "angle(velocity(P, 1), W)"


def test_an_angle_to_the_normal_is_one() -> None:
    inference = inferred(WALL, "v sin(t) = 8 cos(35°)\nv cos(t) = 6 sin(35°)")
    assert quantities(inference)["t"] == "90° - angle(velocity(P, 1), W)"


def test_a_declared_letter_is_not_inferred() -> None:
    problem, _ = solved(SPHERES)
    declared = letters_from_mapping({"v": "along(velocity(B), i)"}, problem)
    inference = inferred(SPHERES, "3v + 5w = 7\nw - v = 3", declared)
    meaning = inference.best.at(1)["v"]
    assert (write_expression(meaning.quantity), meaning.by) == (
        "along(velocity(B, 1), i)",
        "declared",
    )


def test_what_no_line_explains_has_to_be_asked() -> None:
    assert inferred(SPHERES, "3k + q = 17.3").asks == {"k", "q"}


def test_a_known_value_that_fits_no_quantity_defines_a_letter() -> None:
    inference = inferred(SPHERES, "n = (-3i + 4j)/5\nv = 1/7")
    assert {each.letter: each.by for each in inference.best.meanings} == {
        "n": "declared",
        "v": "declared",
    }


def test_a_usual_letter_has_its_meaning_also_in_a_wrong_line() -> None:
    inference = inferred(SPHERES, "v_A = 17")
    assert inference.best.at(1)["v_A"].by == "default"
    assert quantities(inference)["v_A"] == "along(velocity(A, 1), i)"


def test_a_quantity_of_the_start_is_only_for_u() -> None:
    assert "0" in quantities(inferred(SPHERES, "u = 4"))["u"]
    assert all(
        "0" not in write_expression(each.trees(1)["x"]) for each in inferred(SPHERES, "x = 4")
    )


def test_a_heading_opens_a_scope() -> None:
    text = "v cos(b) = u cos(40°)\nv sin(b) = 2/3*u sin(40°)\nv cos(c) = v cos(c)"
    scopes = {1: Scope(event=1), 2: Scope(event=1), 3: Scope(event=2)}
    inference = inferred(TWO_WALLS, text, scopes=scopes)
    assert quantities(inference, 1)["v"] == "speed(P, 1)"


def test_a_letter_of_the_statement_is_fixed_until_it_comes_again() -> None:
    problem, solution = solved(TWO_WALLS)
    plain = script_of("x = 1\ny = 2\nz = u", problem)
    take = Declaration("u", (read_expression("5"),), "5")
    lines = (
        ScriptLine(1, "take u = 5", "declaration", declarations=(take,)),
        *plain.lines[1:],
    )
    inference = meanings_of(Script(lines), problem, solution)
    assert [dict(inference.best.fixed(number)) for number in (1, 2, 3)] == [{"u": 5}, {"u": 5}, {}]


@pytest.mark.parametrize(
    "text",
    ["v along", "12: speed(A)", "v: speed(Q)", "v:", "v: speed(A)\nv: speed(B)", "v: quux blah"],
)
def test_a_bad_line_of_a_letters_file_is_an_error_with_its_line(text: str) -> None:
    with pytest.raises(StatementError) as error:
        letters_from_text(text, solved(SPHERES)[0])
    assert error.value.line == text.count("\n") + 1


@pytest.mark.parametrize(
    ("text", "column", "rule"),
    [
        ("v: speed(A)\n  w =  velocity(A", 18, "the meaning of w: expected ')' or ',' after 'A'"),
        ("\nw: component of Q along i after", 17, "names Q, which is not in the question"),
    ],
)
def test_what_is_wrong_in_a_letters_file_is_told_at_its_place(
    text: str, column: int, rule: str
) -> None:
    with pytest.raises(LettersError, match=re.escape(rule)) as error:
        letters_from_text(text, solved(SPHERES)[0])
    assert (error.value.line, error.value.column) == (2, column)


def test_what_is_wrong_in_one_meaning_has_no_line() -> None:
    with pytest.raises(StatementError, match="the meaning of w: expected") as error:
        letters_from_mapping({"w": "velocity(A"}, solved(SPHERES)[0])
    assert error.value.line is None


def test_letters_of_a_file_have_canonical_names() -> None:
    text = "vA: speed(A)\nβ = angle(velocity(A), i)  # a remark\n\nv_{1}: speed(B)\nv': speed(A)"
    assert list(letters_from_text(text, solved(SPHERES)[0])) == ["v_A", "beta", "v_1", "v'"]


def test_the_letters_box_has_the_letters_of_the_working() -> None:
    rows = letters_box(*solved(SPHERES))
    assert [(row.letter, row.meaning, row.turned) for row in rows] == [
        ("v", "along(velocity(A, 1), i)", "-along(velocity(A, 1), i)"),
        ("w", "along(velocity(B, 1), i)", "-along(velocity(B, 1), i)"),
    ]
    assert rows[0].words == "component of A in the direction of i after"
    assert rows[0].turned_words == "component of A in the direction of −i after"


def test_the_letters_box_has_speeds_and_angles_where_the_question_speaks_of_them() -> None:
    rows = {row.meaning: row for row in letters_box(*solved(WALL))}
    assert rows["speed(P, 1)"].words == "speed of P after"
    assert rows["angle(velocity(P, 1), W)"].turned is None


def test_what_the_letters_box_says_is_read_again() -> None:
    problem, solution = solved(WALL)
    rows = letters_box(problem, solution)
    again = letters_from_mapping({row.letter: row.meaning for row in rows}, problem)
    assert [write_expression(again[row.letter][0]) for row in rows] == [r.meaning for r in rows]


@pytest.mark.parametrize("text", ["3v + 5w = 7\nw - v = 3\nv = 4", "-3v + 5w = 7\nw - v = 3"])
def test_a_wrong_line_is_not_made_true_by_an_absurd_meaning(text: str) -> None:
    inference = inferred(SPHERES, text)
    script = script_of(text, solved(SPHERES)[0])
    world = true_worlds(solved(SPHERES)[1])[0]
    claim = script.lines[-1].links[0].readings[0]
    assert agrees(claim, world, inference.best.trees(len(script.lines))) is None


def test_a_letter_of_any_look_may_be_a_quantity_that_varies() -> None:
    inference = inferred(TWO_WALLS, "k = 2/3*u sin(40°)\nb = arctan(2/3*tan(40°))")
    assert "velocity(P, 1)" in quantities(inference)["k"]
    assert quantities(inference)["b"] == "angle(velocity(P, 1), AB)"


def test_a_letter_that_is_rare_for_a_velocity_may_be_one() -> None:
    inference = inferred(SPHERES, "3T + 5y = 3*4 - 5\ny - T = 3/5*5\nT = -1")
    assert quantities(inference) == {
        "T": "along(velocity(A, 1), i)",
        "y": "along(velocity(B, 1), i)",
    }


def test_what_is_asked_may_have_any_letter() -> None:
    inference = inferred(SPHERES, "v = -1\nk = 3*(4 + 1)")
    assert quantities(inference)["k"] == "impulse(1)"


def test_a_letter_may_be_said_to_be_zero_in_other_words() -> None:
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given tan(alpha) = 1/2, along(velocity(A), i) = 0\nfind e"
    )
    inference = inferred(text, "-h = 0\n3*m*r = m*(2*sqrt(5)*u/5)")
    assert quantities(inference)["h"] == "along(velocity(A, 1), i)"


def test_components_that_a_fact_makes_equal_are_two_quantities() -> None:
    text = (
        "wall W: along i\nsphere P: mass m, velocity u at 60° to W\nP hits W\n"
        "given angle(velocity(P), W) = 45°\nfind e"
    )
    inference = inferred(text, "v = u*cos(60°)\nw = e*u*sin(60°)\nv = w")
    assert {quantities(inference)[name].partition("(")[0] for name in "vw"} == {"along", "across"}


def test_an_equation_of_momentum_tells_more_than_wrong_values_above_it() -> None:
    """b = 9/2 is right and a = 3 is not; by the values alone, a could be B's component along j."""
    statement = (
        "sphere A: mass 3, velocity 4i + j\nsphere B: mass M, velocity -2i + 3j\n"
        "A hits B: along i\ngiven velocity(B) perpendicular to velocity(B, 0), e = 3/4\n"
        "find M, velocity(B)\n"
    )
    text = "b = 9/2\nb - a = 3/4*(4 - 2)\na = 3\n12 - 2M = 3a + b M"
    assert quantities(inferred(statement, text)) == {
        "a": "along(velocity(A, 1), i)",
        "b": "along(velocity(B, 1), i)",
    }


def test_a_speed_that_is_resolved_is_that_after_the_wall() -> None:
    statement = (
        "wall W: along i\nsphere P: mass m, velocity u at 75° to W\nP hits W\n"
        "given angle(velocity(P), W) = 45°\nfind e\n"
    )
    text = "u sin(75°) = v sin(45°)"
    assert quantities(inferred(statement, text)) == {"v": "speed(P, 1)"}


def test_components_of_an_oblique_impact_are_along_its_line_of_centres() -> None:
    statement = (
        "sphere A: mass m, velocity u i\nsphere B: mass 2m, at rest\n"
        "A hits B: along 30°, e = 3/4\nfind speed(B)\n"
    )
    found = quantities(inferred(statement, "m u = m v + 2 m w\nw - v = 3/4 u"))
    assert found["v"] == "along(velocity(A, 1), line_of_centres(1))"
    assert found["w"] == "along(velocity(B, 1), line_of_centres(1))"


def test_a_whole_turning_after_two_walls_may_be_meant() -> None:
    statement = (
        "wall W: along i\nwall V: along j\nsphere P: mass 2, velocity 8i - 6j\n"
        "P hits W: e = 1/2\nP hits V: e = 3/4\nfind angle(velocity(P), velocity(P, 0))\n"
    )
    found = quantities(inferred(statement, "cos(phi) = (-48 - 18)/(10*sqrt(45))"))
    assert found == {"phi": "angle(velocity(P, 2), velocity(P, 0))"}


PLACED = (
    "wall W: along i, through (0, 0)\nsphere P: mass 1, at (0, 2), velocity 3i - 3j, radius 1/2\n"
    "P hits W: e = 1\nfind position(P, 1), time(1)\n"
)


def test_letters_may_be_times_and_places() -> None:
    found = quantities(inferred(PLACED, "t = 1/2\nx = 3*(1/2)\ny = 2 - 3/2\nr = 3/2 i + 1/2 j"))
    assert found == {
        "t": "time(1)",
        "x": "along(position(P, 1), i)",
        "y": "along(position(P, 1), j)",
        "r": "position(P, 1)",
    }
    words = {
        each.letter: each.words for each in inferred(PLACED, "r = 3/2 i + 1/2 j").best.meanings
    }
    assert words == {"r": "position of P at the impact with W"}


def test_a_line_is_not_false_by_a_meaning_that_nothing_else_supports() -> None:
    """T is a letter that nobody takes for a place, and no other line tells what it is."""
    _, solution = solved(PLACED)
    lines = ["f = 1/2", "z = 3", "k = 3", "T = 3(1/2) = 3/2"]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert "false" not in verdicts


def test_the_look_of_a_letter_is_odd_for_some_quantities() -> None:
    tangent = "tan(angle(velocity(P), W))"
    for letter, quantity, odd in (
        ("T", tangent, True),
        ("t", tangent, True),
        ("v", "along(velocity(P), i)", False),
        ("T", "along(velocity(P), i)", True),
        ("T", "time(1)", False),
        ("theta", "angle(velocity(P), W)", False),
        ("c", "angle(velocity(P), W)", True),
        ("b", "angle(velocity(P), W)", False),
    ):
        assert is_odd(letter, read_expression(quantity, names={"P", "W"})) is odd, letter


def test_one_coincidence_of_numbers_does_not_tell_a_letter_of_an_odd_look() -> None:
    statement = (
        "sphere A: mass 2, velocity 3i - 4j\nsphere B: mass 3, velocity 2i + 3j\n"
        "A hits B: along j, e = 3/7\nfind total_energy_lost, impulse, velocity(A)\n"
    )
    _, solution = solved(statement)
    lines = ["p_1 = 1/2*2 (4^2 - 2^2) + 1/2*3 (3^2 - 1^2) = 24", "I = 12"]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert verdicts[0] in ("true", "asks")
    assert verdicts[1] == "true"


def test_a_place_may_have_a_letter_for_velocities() -> None:
    _, solution = solved(PLACED)
    lines = ["w = 3/2 i + 1/2 j + (2 - 1/2)(3i + 3j)", "w = 6i + 5j"]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert "false" not in verdicts


def test_letters_that_their_lines_define_may_have_one_value() -> None:
    """All components before are u/√2, and V and W are still those along the line of centres."""
    statement = (
        "sphere A: mass m, velocity u i\nsphere B: mass m, velocity u j\n"
        "A hits B: along i - j, e = 1/2\nfind velocity(A)\n"
    )
    _, solution = solved(statement)
    lines = [
        *("s = u cos 45 = u/√2", "H = u sin 45 = u/√2", "h = -u cos 45 = -u/√2"),
        *("k = u sin 45 = u/√2", "d = u/√2", "q = u/√2", "m V + m W = m u/√2 - m u/√2"),
        *("W - V = 1/2 (u/√2 + u/√2)", "V = -√2 u/4", "W = √2 u/4"),
    ]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert set(verdicts) == {"true"}


def test_a_line_that_is_true_of_another_quantity_is_a_question() -> None:
    """V may be the speed before, as no other line tells; y the angle from the other direction."""
    statement = (
        "wall W: along i\nsphere P: mass 1, velocity p i - 4j\ngiven 3 <= p <= 4\n"
        "P hits W: e = 1/2\nfind range of speed(P)\n"
    )
    _, solution = solved(statement)
    lines = ["V² = p² + 4²", "p² + 2² >= 13", "p² + 2² <= 20"]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert "false" not in verdicts
    statement = (
        "wall C: circle centre (0, 0) radius a\nsphere P: at (a/2, 0), velocity u at 90°\n"
        "P hits C: e = 1/2\nfind direction(P)\n"
    )
    _, solution = solved(statement)
    lines = ["tan y = (-u/8)/(-3√3 u/8) = √3/9 so y = arctan(√3/9) - 180°"]
    verdicts = [each["verdict"] for each in r.mark(solution, lines).json()["lines"]]
    assert "false" not in verdicts


# --- meanings in words, and the letters of diagrams -----------------------------------------------


def _wordings() -> Iterator[tuple[str, str, str]]:
    text = (Path(__file__).parent / "letter_meanings.txt").read_text(encoding="utf-8")
    for chunk in text.split("=== ")[1:]:
        statement, _, table = chunk.partition("\n")[2].partition("---\n")
        for row in table.splitlines():
            words, _, meant = row.partition(" | ")
            yield statement, words, meant


def test_there_are_fifty_wordings() -> None:
    assert len(list(_wordings())) >= 50


@pytest.mark.parametrize(("statement", "words", "meant"), list(_wordings()))
def test_words_name_the_quantity_that_is_meant(statement: str, words: str, meant: str) -> None:
    problem, solution = solved(statement)
    (world,) = true_worlds(solution, None)
    trees = {}
    for text in (words, meant):
        found = letters_from_mapping({"z": text}, problem)["z"]
        trees[text] = found[0] if isinstance(found, tuple | list) else found
    own, wanted = (world.value(trees[text]) for text in (words, meant))
    assert type(own) is type(wanted)
    if isinstance(own, Angle):
        own, wanted = own.measure(), wanted.measure()
    assert np.allclose(np.array(own), np.array(wanted))


DIAGRAMS = (
    *("two-spheres-with-vectors", "sphere-at-rest", "wall-with-vectors", "right-angled-corner"),
    *("both-moving-at-angles", "wall-in-letters", "slanting-wall", "speeds-and-angles"),
    *("find-e-at-a-wall", "three-spheres-oblique", "parallel-walls"),
)


@pytest.mark.parametrize("name", DIAGRAMS)
def test_the_letters_of_a_diagram_are_read_again(name: str) -> None:
    folder = Path(__file__).parents[1] / "src" / "restitution" / "examples"
    problem, solution = solved((folder / f"{name}.impact").read_text(encoding="utf-8"))
    rows = letters_box(problem, solution)
    assert rows
    assert len({row.letter for row in rows}) == len(rows)
    assert letters_from_mapping({row.letter: row.meaning for row in rows}, problem).keys() == {
        row.letter for row in rows
    }


MULTIPLES = """
sphere A: mass 2m, velocity u(2i + j)
sphere B: mass 3m, velocity lambda u(-i + j)
A hits B: along i, e = 1/2
given velocity(A) perpendicular to velocity(A, 0)
find lambda
"""
TIMED = """
wall W: along j, through (4, 0)
sphere A: mass 2, at (-2, -1), velocity 2i + j
sphere B: mass 1, at (0, 0), at rest
A hits B: along i, e = 1/2
B hits W: e = 1/2
find time(2)
"""
SLANTING = """
wall W: along 30°
sphere P: velocity u at 75°
P hits W: e = 1/sqrt(3)
find speed(P), deflection(P)
"""


def marked(statement: str, *lines: str) -> dict[str, Any]:
    return r.mark(r.parse(statement), "\n".join(lines)).json()


def test_a_letter_may_be_a_component_as_a_multiple_of_a_speed() -> None:
    lines = "vA = xui + uj, vB = yui + λuj", "2m(2u) - 3mλu = 2mxu + 3myu", "y - x = ½(2 + λ)"
    found = marked(MULTIPLES, *lines)
    assert [line["verdict"] for line in found["lines"]] == ["true"] * 3
    assert {each["meaning"] for each in found["letters"] if each["letter"] in "xy"} == {
        "along(velocity(A, 1), i)/u",
        "along(velocity(B, 1), i)/u",
    }
    wrong = marked(MULTIPLES, lines[0], "2m(2u) + 3mλu = 2mxu + 3myu", lines[2])
    assert [line["verdict"] for line in wrong["lines"]] == ["true", "false", "true"]


def test_between_momentum_and_restitution_letters_keep_their_meanings() -> None:
    lines = "t = 1 when they collide", "2 = x + y", "y - x = ½(2) = 1", "x = 0.5, y = 1.5"
    found = marked(TIMED, *lines, "time(2) = 1 + 4/1.5 = 3.67")
    said = ["true", "false", "true", "follows", "follows"]
    assert [line["verdict"] for line in found["lines"]] == said
    assert found["lines"][1]["mistake"]["id"] == "mass-omitted"


def test_no_velocity_is_an_impulse_and_no_coefficient_a_mass() -> None:
    lines = "ucos75 = vcosb", "eusin75 = vsinb", "tanb = tan75/√3 = 2.15, b = 65.1"
    meanings = {each["letter"]: each["meaning"] for each in marked(SLANTING, *lines)["letters"]}
    assert meanings["v"] == "speed(P, 1)"
    assert meanings["e"] == "restitution(1)"


def test_a_momentum_that_is_a_vector_is_that_of_both() -> None:
    statement = """
    sphere A: mass 3, velocity 4i - 2j
    sphere B: mass 1, velocity -2i + j
    A hits B: along i - j, e = 1/3
    find momentum
    """
    found = marked(statement, "momentum = 3(-1, 5) + (-1, -1) = (-4, 14)")
    assert [line["verdict"] for line in found["lines"]] == ["false"]
    assert found["letters"][0]["meaning"] == "momentum(1)"


HALF_ACROSS = """
sphere A: mass 2m, velocity u at arccos(12/13)
sphere B: mass 5m, velocity u j
A hits B: along i, e = 3/4
find deflection(B), speed(B)
"""
DOUBLED = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/3
given angle(velocity(A), i) = 2alpha
find alpha, speed(A)
"""


def test_momentum_in_two_letters_tells_both_however_they_look() -> None:
    found = marked(DOUBLED, "s + t = ucosα", "⅓(t - s) = ucosα", "s = -ucosα")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "follows"]
    assert found["lines"][1]["mistake"]["id"] == "restitution-inverted"


def test_no_tangent_of_a_right_angle_breaks_a_law() -> None:
    lines = "24mu/13 = 2ms + 5mt", "t - s = ¾u", "24u/13 = 7s + 3.75u", "s = -0.272u", "t = 0.478u"
    found = marked(HALF_ACROSS, *lines, "vB = √(1 + 0.478²)u = 1.11u")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", *["follows"] * 4]
    assert found["lines"][1]["mistake"]["id"] == "speed-for-component"
    meanings = {each["letter"]: each["meaning"] for each in found["letters"]}
    assert meanings["t"] == "along(velocity(B, 1), i)"
    assert meanings["v_B"] == "speed(B, 1)"


@pytest.mark.parametrize("first", ["a + 2b = 1 + 4", "2a + b = 3", "a + b = 1", "a + 2b = 5"])
def test_letters_are_no_velocities_that_are_given(first: str) -> None:
    """Who is to find the velocities before has no letters for those after, which are numbers."""
    statement = """sphere A: mass 1
sphere B: mass 2
A hits B: along i, e = 1/2
given velocity(A) = -i + 2j, velocity(B) = 2i - j
find velocity(A, 0), velocity(B, before)"""
    lines = f"{first}\n2 - -1 = 1/2(a - b)\na - b = 6"
    found = r.mark(r.parse(statement), lines).json()
    assert all("0)" in each["meaning"] for each in found["letters"]), found["letters"]


STRIP = """wall W: along i, through (0, 0)
wall X: along i, through (0, 2)
sphere P: velocity 3i - 4j, at (0, 1)
P hits W: e = 3/4
P hits X: e = 1/2
find speed(P)"""


@pytest.mark.parametrize(
    ("line", "verdict", "mistake"),
    [
        ("vy = ½(3) = 1.5, vx = 3", "true", None),
        ("v_x = 3, v_y = -1.5", "true", None),
        ("vx = ½(3) = 1.5, vy = 3", "false", "restitution-parallel"),
    ],
)
def test_an_x_below_is_along_i_where_the_question_has_vectors(
    line: str, verdict: str, mistake: str | None
) -> None:
    (judged,) = r.mark(r.solve(r.parse(STRIP)), line).lines
    assert judged.verdict == verdict
    assert (judged.mistake.id if judged.mistake else None) == mistake


BENT = """wall AB: along i
wall BC: along 70°
sphere P: velocity 6 at 40° to AB
part a
P hits AB: e = 1/2
find angle(velocity(P), AB)
part b
P hits BC: e = 3/4
find speed(P)"""


def test_the_angle_at_a_wall_is_to_that_wall() -> None:
    solution = r.solve(r.parse(BENT))
    for typed, verdict in (("47.2", "true"), ("22.8", "false")):
        (judged,) = r.mark(solution, f"at BC the angle is {typed}°", part="b").lines
        assert judged.verdict == verdict
    problem = r.parse(
        "wall W: along i\nwall X: along 60°\nsphere P: velocity 4 at 45° to W\n"
        "P hits W: e = 1/3\nP hits X: e = 1/2\nfind speed(P)"
    )
    (judged,) = r.mark(problem, "at X the angle is 18.4°").lines
    assert judged.verdict == "false"


def test_a_letter_that_is_declared_along_i_has_that_sense() -> None:
    """In words as by its quantity: v is not turned round to make a wrong line true."""
    problem = r.parse(
        "sphere A: mass 1, velocity 4i + 3j\nsphere B: mass 3, at rest\nA hits B: along i\n"
        "given energy_lost = 9/2\nfind e"
    )
    working = "4 = 3w - v\nw - v = 4e"
    for body in ("component of {} along i after", "along(velocity({}), i)"):
        declared = {"v": body.format("A"), "w": body.format("B")}
        marking = r.mark(problem, working, letters=declared).json()
        assert [line["verdict"] for line in marking["lines"]] == ["false", "true"], body


@pytest.mark.parametrize(
    "line", ["relative to it A 2.4, B -1.6", "velocity of A relative to centre of mass = 2.4"]
)
def test_a_velocity_relative_to_the_mass_centre_is_known(line: str) -> None:
    problem = r.parse(
        "sphere A: mass 2, velocity 6i + j\nsphere B: mass 3, velocity 2i - 2j\n"
        "A hits B: along i, e = 1/4\nfind velocity(A), velocity(B)"
    )
    working = f"velocity of centre of mass along i = 18/5 = 3.6\n{line}"
    verdicts = [own["verdict"] for own in r.mark(problem, working).json()["lines"]]
    assert verdicts == ["true", "true"]
    wrong = r.mark(problem, working.replace("2.4", "2.5")).json()["lines"]
    assert wrong[-1]["verdict"] != "true"


_ROOM = """\
wall V: along j, through (0, 0)
sphere P: mass 2, at (2, 0), velocity -4i + 3j
P hits V: e = 1/2
find {}
"""
_BLOW = "sphere A: mass 2, at rest\nA receives 10i + 4j\nfind velocity(A)"
_TURN = (
    "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
    "given deflection(P) = 90°, tan(alpha) = 2\nfind e"
)


@pytest.mark.parametrize(
    ("statement", "right", "wrong"),
    [
        (_ROOM.format("time(1), velocity(P)"), "t = 2/4 = 0.5", "t = 2/5 = 0.4"),
        (_ROOM.format("velocity(P), impulse"), "I = 2(4 + 2) = 12", "I = 2(4 - 2) = 4"),
        (_ROOM.format("speed(P)"), "v = √(9 + 4)", "v = √(9 + 2) = 3.32"),
        (_BLOW, "v = 5i + 2j", "v = 10i + 4j"),
        (_TURN, "u cos α = v cos β\neu sin α = v sin β\nβ = 90 - α", "β = 90"),
    ],
)
def test_a_letter_for_what_is_asked_has_no_value_of_nothing(
    statement: str, right: str, wrong: str
) -> None:
    """Whatever time t is, it is not that; so of impulses, vectors and roots of two squares."""
    true = r.mark(solved(statement)[1], right).json()
    assert {line["verdict"] for line in true["lines"]} == {"true"}
    lines = [*right.splitlines()[:-1], wrong]
    marking = r.mark(solved(statement)[1], lines).json()
    assert [line["verdict"] for line in marking["lines"]] == ["true"] * (len(lines) - 1) + ["false"]
    assert not marking["asks"]


@pytest.mark.parametrize("line", ["v = 2", "v = 10i + 4j"])
def test_a_letter_of_no_certain_kind_is_asked_about(line: str) -> None:
    """As a component there is such a value; of two velocities none is sure."""
    both = (
        "sphere A: mass 2, at rest\nsphere B: mass 1, velocity j\nA receives 10i + 4j\n"
        "B receives i\nfind velocity(A), velocity(B)"
    )
    statement = both if "j" in line else _ROOM.format("time(1), speed(P)")
    (verdict,) = (own["verdict"] for own in r.mark(solved(statement)[1], line).json()["lines"])
    assert verdict != "false"


def test_who_adds_two_squares_takes_no_whole_speed() -> None:
    """4 is e times the speed 8 as well, which √(12 + 4) says nothing of."""
    statement = (
        "wall W: along i\nsphere P: velocity 8 at 30° to W\nP hits W: e = 1/2\nfind speed(P)"
    )
    (line,) = r.mark(solved(statement)[1], "v = √(12 + 4) = 4").json()["lines"]
    assert line["verdict"] == "false"
    assert line["mistake"]["id"] in (None, "arithmetic")


def test_no_letter_is_of_an_event_behind_the_question() -> None:
    """*Parallel* in part (a) is not perpendicular to the wall of part (b), whatever its value."""
    statement = (
        "wall AB: along i\nwall BC: along j\nsphere P: velocity u at alpha to AB\n"
        "P hits AB: e = e\npart a\nfind speed(P)\nP hits BC: e = e\npart b\nfind speed(P)"
    )
    solution = solved(statement)[1]
    first, *_ = r.mark(solution, "parallel: e u cos α", part="a").json()["lines"]
    assert first["verdict"] == "false"
    assert first["mistake"]["id"] == "restitution-parallel"
    first, *_ = r.mark(solution, "v = e u cos α", part="b").json()["lines"]
    assert first["verdict"] == "true"


_OFF_A_WALL = """
wall W: along j
sphere P: mass 4, velocity 3i + 2j
P hits W: e = 1/3
find impulse
"""


@pytest.mark.parametrize(
    ("lines", "verdict"),
    [
        (("P: 3 × 1/3 = 1", "I = 3 + 1 = 4"), "false"),
        (("P: 3 × 1/3 = 1", "I = 4(3 + 1) = 16"), "true"),
        (("P: 3 × 1/3 = 1", "I = -4 - 12 = -16"), "true"),
    ],
)
def test_numbers_that_end_a_working_are_no_definition_of_the_impulse(
    lines: tuple[str, ...], verdict: str
) -> None:
    solution = r.solve(r.parse(_OFF_A_WALL))
    found = r.mark(solution, lines).json()["lines"]
    assert found[-1]["verdict"] == verdict
    assert found[0]["verdict"] == "true"
