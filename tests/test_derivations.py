"""Workings by hand: the follower finds nothing to complain of, and refuses what is spoiled."""

from __future__ import annotations

import pickle
import random
from functools import cache
from pathlib import Path

import pytest
from corruptions import corruptions
from derivations import (
    FOLDER,
    derivation_of,
    disagreement,
    names_of,
    oracle_of,
    read_derivation,
)

import restitution.examples
from restitution.errors import StatementError
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation, numbers_in
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.expression.writing import write_expression
from restitution.language.reading import parse
from restitution.problem import Problem
from restitution.solving import solve

FILES = sorted(FOLDER.glob("*.txt"))
SAMPLE = 12

# What is let through, by kind, file and line, and rightly. Of a line left out, what remains is one
# move: two small steps fit into it, such as a component that goes straight into a law, or an
# inequality solved and joined at once. Of the others, what is spoiled says the same (sin 45° for
# cos 45°, ± (2·2 − 4), a direction and its opposite for a line), or another true thing as plain
# as the first ((2e − 1)/4 > 0, 0 < sin α).
ONE_MOVE: dict[str, dict[str, tuple[int, ...]]] = {
    "line left out, premises inherited": {
        "brought-to-rest": (6,),
        "centres-from-the-impulse": (2,),
        "centres-slanted": (1, 2, 8),
        "corner": (10,),
        "corner-of-120": (3, 4),
        "direction-reversed": (6, 7, 8),
        "energy-inequality": (10,),
        "greatest-deflection": (14,),
        "parallel-walls": (7, 9),
        "perpendicular-afterwards": (7,),
        "range-of-an-angle": (10, 11),
        "reaches-a-point": (7,),
        "rejected-root": (8,),
        "right-angle": (9, 11, 13),
        "sphere-then-wall": (13,),
        "struck-ball": (2, 3),
        "struck-beside-its-path": (3,),
        "three-in-line": (12, 13, 15),
        "three-spheres": (7, 14),
        "turned-by-a-wall": (5, 6),
        "two-angles": (6,),
        "two-conditions": (8, 13),
        "wall-energy": (4,),
        "wall-impulse": (4,),
        "wall-slanted": (1, 2),
        "wall-sum-of-angles": (5,),
    },
    "sign": {
        "centres-from-the-impulse": (4, 6),
        "times-between-walls": (5,),
    },
    "sine for cosine": {
        "perpendicular-afterwards": (4, 5, 7, 9),
        "range-of-an-angle": (11,),
    },
    "digit": {
        "right-angle": (10,),
    },
}


def test_there_are_workings_of_every_topic() -> None:
    assert len(FILES) >= 36


@cache
def working(path: Path) -> tuple[Problem, Derivation]:
    return read_derivation(path)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_working_by_hand_is_followed(path: Path) -> None:
    problem, derivation = working(path)
    assert [str(each) for each in follow(derivation, oracle_of(problem))] == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_working_reaches_the_answers_of_the_solver(path: Path) -> None:
    problem, derivation = working(path)
    items = list(solve(problem).items())
    names = list(dict.fromkeys(each.item for each in derivation.items))
    assert len(names) == len(items), "a working answers every item, in order"
    for name, (part, item) in zip(names, items, strict=True):
        ends = [each for each in derivation.items if each.item == name]
        assert item.error is None, item.error
        assert disagreement(item, ends, dict(part.roles)) is None, (name, item.text)


def spoiled_line(derivation: Derivation, spoiled: Derivation) -> int:
    """The number of the line that was changed, moved or left out; 0 for none."""
    for a, b in zip(derivation.lines, (*spoiled.lines, None), strict=False):
        if a != b:
            return a.number
    return 0


@pytest.mark.nightly
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_spoiled_working_is_refused(path: Path) -> None:
    problem, derivation = working(path)
    every = [(kind, each) for kind, each in corruptions(derivation) if each != derivation]
    chosen = random.Random(path.stem).sample(every, min(SAMPLE, len(every)))
    through = [
        (kind, spoiled_line(derivation, spoiled))
        for kind, spoiled in chosen
        if not follow(spoiled, oracle_of(problem))
    ]
    faults = [
        (kind, line)
        for kind, line in through
        if line not in ONE_MOVE.get(kind, {}).get(path.stem, ())
    ]
    assert faults == []


SPHERES = """
sphere A: mass m, velocity u at {angle}
sphere B: mass {mass}, at rest
A hits B: along i{e}
{rest}
"""
LAWS = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
3 a | law unchanged 1 A | velocity A, axis 1 | s(A, 1) = u sin({angle}) | B
4 a | law momentum 1 A B | mass A, mass B, velocity A, velocity B, axis 1, 1, 2 | {mass} | M A
5 a | law restitution 1 A B | velocity A, velocity B, axis 1, e 1, 1, 2 | {e} | M A
6 a | combine w | 4, 5 | {v} | DM
"""


def complaints(statement: str, working: str) -> list[str]:
    problem = parse(statement)
    return [str(each) for each in follow(derivation_of(problem, working), oracle_of(problem))]


@pytest.mark.parametrize(
    ("tangent", "refused"),
    [
        ("tan | given 1, 1, 3 | 4 = u sin(45°)/v", True),
        ("tan-squared | given 1, 1, 3 | 16 = (u sin(45°))^2/v^2", False),
    ],
)
def test_a_component_of_open_sign_is_not_taken_positive(tangent: str, refused: bool) -> None:
    """With e open, A may go on or come back at this angle: there are two values of e."""
    record, premises, relation = tangent.split(" | ")
    statement = SPHERES.format(
        angle="45°",
        mass="2m",
        e="",
        rest="given angle(velocity(A), line_of_centres) = arctan(4)\nfind e",
    )
    working = (
        LAWS.format(
            angle="45°",
            mass="m u cos(45°) = m v + 2m w",
            e="w - v = e u cos(45°)",
            v="v = (1 - 2e)u cos(45°)/3",
        )
        + f"7 a | define {record} 1 A | {premises} | {relation} | M\n"
    )
    answer = complaints(statement, working)
    assert ("line 7: does not follow" in answer) == refused


@pytest.mark.parametrize(
    ("deflection", "refused"),
    [("beta - alpha", False), ("alpha - beta", True), ("alpha + beta", True)],
)
def test_the_greater_angle_comes_first(deflection: str, refused: bool) -> None:
    statement = SPHERES.format(angle="alpha", mass="m", e=", e = 1/2", rest="find deflection(A)")
    working = (
        LAWS.format(
            angle="alpha",
            mass="m u cos(alpha) = m v + m w",
            e="w - v = 1/2 u cos(alpha)",
            v="v = 1/4 u cos(alpha)",
        )
        + "7 a | let | | let beta = angle(velocity(A, 1), line_of_centres(1))\n"
        + "8 a | define difference 1 A | velocity A, axis 1, 1, 3, 6, 7"
        + f" | deflection(A, 1) = {deflection} | M\n"
    )
    assert ("line 8: does not follow" in complaints(statement, working)) == refused


@pytest.mark.parametrize(
    ("axis", "tangent", "refused"),
    [
        ("i", "u sin(alpha)/v", False),
        ("i", "-u sin(alpha)/v", True),
        ("line_of_centres(1)", "u sin(alpha)/v", True),
        ("line_of_centres(1)", "-u sin(alpha)/v", True),
        ("line_of_centres(1)", "2u sin(alpha)/(u cos(alpha))", False),
        ("line_of_centres(1)", "-2u sin(alpha)/(u cos(alpha))", True),
    ],
)
def test_who_is_turned_back_moves_at_an_obtuse_angle_to_i(
    axis: str, tangent: str, refused: bool
) -> None:
    """With a line of centres, the angle is the acute one."""
    statement = SPHERES.format(angle="alpha", mass="3m", e=", e = 1", rest="find tan(beta)")
    named = f"let beta = angle(velocity(A), {axis.removesuffix('(1)')})"
    statement = statement.replace("find", f"{named}\nfind")
    premises = "let beta, axis 1, 1, 3" + ("" if "v" in tangent else ", 6")
    working = (
        LAWS.format(
            angle="alpha",
            mass="m u cos(alpha) = m v + 3m w",
            e="w - v = u cos(alpha)",
            v="v = -1/2 u cos(alpha)",
        )
        + f"7 a | define tan 1 A | {premises} | tan(beta) = {tangent} | M\n"
    )
    assert ("line 7: does not follow" in complaints(statement, working)) == refused


def test_an_angle_of_more_than_90_degrees_to_a_wall_is_not_taken_forward() -> None:
    statement = """
wall W: along i
sphere P: velocity u at 2theta to W
P hits W: e = 4/9
given angle(velocity(P), W) = theta
find theta
"""
    working = """
1 a | let | | let V = speed(P, 1)
2 a | law unchanged 1 P | velocity P, wall W, axis 1, given 1, 1 | V cos(theta) = u cos(2theta)
"""
    assert "line 2: does not follow" in complaints(statement, working)
    narrowed = statement.replace("= theta\n", "= theta, theta < 45°\n")
    assert "line 2: does not follow" not in complaints(narrowed, working)


@pytest.mark.parametrize(
    ("line", "refused"),
    [
        ("u/2 <= v <= 2u", False),
        ("u/2 < v < 2u", True),
        ("u/3 <= v <= 2u", True),
        ("u/2 <= v <= 3u", True),
    ],
)
def test_the_ends_of_what_grows_are_its_bounds(line: str, refused: bool) -> None:
    text = (FOLDER / "brought-to-rest.txt").read_text().replace("u/2 <= v <= 2u", line)
    statement, _, lines = text.partition("\n---\n")
    assert ("line 7: does not follow" in complaints(statement, lines)) == refused


def test_premises_are_cited_by_number_and_by_name() -> None:
    _, derivation = read_derivation(FOLDER / "corner.txt")
    line, fact = derivation.lines[0], derivation.facts[0]
    refs = [line.number, fact.id, "0 <= e"]
    assert [derivation.cited(ref) for ref in refs] == [line, fact, None]
    assert (derivation.lines_in(refs), derivation.facts_in(refs)) == ([line], [fact])
    assert derivation.line(fact.id) is None and derivation.fact(line.number) is None
    assert numbers_in(refs) == [line.number]


def test_every_case_is_reached() -> None:
    statement, _, text = (FOLDER / "either-sign.txt").read_text().partition("\n---\n")
    without = "\n".join(
        each for each in text.splitlines() if not each.startswith(("6 b", "case 2", "b: 6"))
    )
    assert "line 4: case missing (1)" in complaints(statement, without)
    unreached = "\n".join(each for each in text.splitlines() if not each.startswith("b: 6"))
    assert "line 4: case missing (b)" in complaints(statement, unreached)


def test_a_fact_of_one_part_holds_in_no_other() -> None:
    statement, _, text = (FOLDER / "direction-reversed.txt").read_text().partition("\n---\n")
    answer = complaints(statement, text.replace("given 1, axis 1, 1, 5, acute", "8, 5, acute"))
    assert "line 11: premise of another part (given 2)" in answer


@pytest.mark.parametrize(("sign", "refused"), [("", False), ("-", True)])
def test_components_count_in_one_sense(sign: str, refused: bool) -> None:
    """Who takes the line of centres the other way round for B has a wrong velocity for A."""
    statement, _, text = (FOLDER / "struck-ball.txt").read_text().partition("\n---\n")
    again = f"9 a | rearrange | 1 | line_of_centres(1) parallel to {sign}(i + sqrt(3) j)\n"
    lines = text.replace("3 a | define", again + "3 a | define").replace(
        "given 1, given 2, 1 | c(B, 1) = 3/8 u", f"given 1, given 2, 9 | c(B, 1) = {sign}3/8 u"
    )
    assert ("line 3: axis turned (9)" in complaints(statement, lines)) == refused


def test_a_greatest_value_is_reached() -> None:
    path = FOLDER / "greatest-deflection.txt"
    statement, _, text = path.read_text().partition("\n---\n")
    assert complaints(statement, text) == []
    elsewhere = text.replace("!= 1/2 or", "!= 1/3 or")
    assert "line 17: does not follow" in complaints(statement, elsewhere)
    least = text.replace("answer greatest", "answer least")
    assert "line 18: does not follow" in complaints(statement, least)


def test_the_links_of_a_relation_without_alternatives() -> None:
    with pytest.raises(ValueError):
        _ = Relation(((), ())).only


@pytest.mark.nightly
def test_facts_of_all_statements_are_written_and_read_back() -> None:
    folders = (Path(restitution.examples.__file__).parent, FOLDER.with_name("questions"))
    for path in sorted(each for folder in folders for each in folder.glob("*.impact")):
        try:
            problem = parse(path.read_text(encoding="utf-8"))
        except StatementError:
            continue
        facts = facts_of(problem)
        assert len({each.id for each in facts}) == len(facts), path.name
        for each in facts:
            text = write_relation(each.relation)
            assert read_relation(text, names_of(problem)) == each.relation, (path.name, text)


@pytest.mark.parametrize(
    ("statement", "name", "text"),
    [
        ("given velocity(A) opposite to i", "sense 1", "along(velocity(A, 1), i) < 0"),
        (
            "given A and B collide again",
            "given 1",
            "along(velocity(A, 1), line_of_centres(1)) > along(velocity(B, 1), line_of_centres(1))",
        ),
        ("given k > 1", "given 1", "k > 1"),
        ("find k", "contact 1", "position(A, 1) = position(B, 1)"),
        ("find k", "start", "time(1) = 0"),
    ],
)
def test_a_fact_of_a_statement(statement: str, name: str, text: str) -> None:
    problem = parse(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
        + statement
        + ("" if statement.startswith("find") else "\nfind e")
    )
    (fact,) = (each for each in facts_of(problem) if each.id == name)
    assert fact.relation == read_relation(text, names_of(problem))


@pytest.mark.parametrize(
    ("walls", "axis"),
    [
        ("wall W: along i", "-j"),
        ("wall W: along j\nwall V: along i", "i"),
        ("wall W: along 150°\nwall V: along i", "60°"),
        ("wall W: along 3i + 4j", "4i - 3j"),
    ],
)
def test_the_normal_of_a_wall_points_into_it(walls: str, axis: str) -> None:
    """P comes down to the right; from another wall it comes up to the right."""
    first = "P hits V: e = 1/2\n" if "wall V" in walls else ""
    problem = parse(
        f"{walls}\nsphere P: velocity 9i - 4j\n{first}P hits W: e = 1/2\nfind velocity(P)\n"
    )
    number = 2 if first else 1
    (fact,) = (each for each in facts_of(problem) if each.id == f"axis {number}")
    assert write_expression(fact.relation.only[0].right) == axis


def test_the_hash_of_a_relation_stays_in_its_process() -> None:
    relation = read_relation("v = 2u/3", {})
    own = hash(relation)
    other = pickle.loads(pickle.dumps(relation))
    assert "_hash" in vars(relation), "it is worked out once"
    assert "_hash" not in vars(other), "strings have another hash elsewhere"
    assert "_hash" not in vars(other.only[0])
    assert other == relation
    assert hash(other) == own
