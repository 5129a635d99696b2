"""Further kinds of statements that have a whole working, and what the follower takes of it."""

from __future__ import annotations

import pytest
from laws_of_workings import answers, complaints, printed_results

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Move, Relation
from restitution.explaining.lines.notation import read_relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import walk
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

STATEMENTS = {
    "a range that is one value": """
wall W: along i
sphere P: velocity u at 45° to W
P hits W
given speed(P) >= u
find range of e
""",
    "a range that is one value, of a mass ratio": """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1
given energy(B) >= energy(A, 0)
find range of k
""",
    "a range that is one value, beyond an end": """
wall V: along j, through (0, 0)
wall G: from (-a, 3a) to (a, 3a)
sphere P: at (2a, 0), velocity u at 135°
P hits V
given P will not hit G
find range of e
""",
    "the size of a letter of either sign": """
wall W: along j
sphere P: mass 2, velocity p i + 3j
P hits W: e = 1/2
given deflection(P) = 90°
find p, abs(p)
""",
    "an angle to a wall along which it may go either way": """
wall W: along i
sphere P: velocity p i - 4j
P hits W: e = 1/2
given angle(velocity(P), W) = 30°
find p
""",
    "its tangent": """
wall W: along i
sphere P: velocity p i - 4j
P hits W: e = 1/2
given tan(angle(velocity(P), W)) = 1/2
find p
""",
    "components of momenta": """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 3, velocity -i
A hits B: along i, e = 1/2
find along(momentum(A), i), along(momentum(A), j), along(momentum(B), line_of_centres)
""",
    "a component of a momentum that is given": """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given along(momentum(P), j) = 1/2 m u sin(alpha)
find e, across(momentum(P), line_of_centres)
""",
    "an angle of which the ratios are roots of sums with roots": """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
given deflection(P) = 45°
find tan(alpha), speed(P), energy_lost/energy(0)
""",
    "a meeting of two that both move, which tells a component": """
wall W: along i, through (0, 0)
sphere A: mass 1, at (0, 4), velocity 3i - 2j
sphere B: mass 1, at (12, 4), velocity p i - j
A hits W: e = 1/2
A hits B: along i, e = 1
find p, time(2)
""",
    "a meeting of two with radii that both move": """
sphere A: mass 1, radius 1, at (0, 0), velocity 2i
sphere B: mass 2, at (6, 8), velocity -2j
A hits B: along j, e = 1/2
find time(1), position(A, 1), speed(B)
""",
    "a place at a wall, from a height in a letter": """
wall W: along i, through (0, 0)
sphere P: at (0, h), velocity u i - v j
P hits W
P reaches (d, h/2)
find e in terms of d, h, u, v
""",
    "an angle that a let names, between two bounds": """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W: e = e
let theta = angle(velocity(P), W)
given 30° <= theta <= 45°
find range of e
""",
    "an equation with a cosine that is not zero on both sides": """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 90°
A hits B: along i, e = 1/2
given velocity(A) parallel to velocity(B)
find tan(alpha)
""",
    "two solutions that approach from either side": """
sphere A: mass m, velocity p i + 3j
sphere B: mass 2m, velocity i - j
A hits B: along i, e = 1/3
given speed(A) = speed(B)
find p
""",
    "a ratio of losses in letters": """
wall V: along i
wall W: along j
sphere P: mass m, velocity u at theta to V
P hits V: e = e
P hits W: e = e
show speed(P) = e u
find energy_lost(2)/energy_lost(1)
""",
    "an impulse that is a multiple of what would stop": """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = e
given impulse = 3/2 m u sin(alpha), energy_lost = 1/4 energy(0)
find e, alpha
""",
    "a speed that leaves no component, so that a square is zero": """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i, e = e
given speed(A) = u sin(alpha)
find e
find speed(B) in terms of u, alpha
""",
    "the same at a wall": """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = e
given speed(P) = u cos(alpha)
find e, energy_lost/energy(0)
""",
    "a deflection by a letter that makes a right angle": """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given deflection(A) = 90° - alpha
find e
""",
    "an obtuse angle with who moves along the line of centres": """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1
given angle(velocity(A), velocity(B)) = 120°, alpha = 30°
find k
""",
    "equal deflections": """
wall W: along i
wall X: along j
sphere P: velocity u at alpha to W
P hits W: e = 1/2
P hits X: e = 1/3
given deflection(P, 1) = deflection(P, 2)
find tan(alpha)
""",
}


@pytest.mark.parametrize("name", STATEMENTS)
def test_it_is_whole(name: str) -> None:
    solution = solve(parse(STATEMENTS[name]))
    derivation = plan(solution)
    assert complaints(solution, derivation) == []
    assert answers(solution, derivation) == []
    assert printed_results(solution, derivation) == []


def test_a_bound_is_said_of_the_letter_over_which_it_is_sought() -> None:
    statement = """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest
A hits B: offset d, e = 1/2
find maximum of speed(B) over d
"""
    problem = parse(statement)
    text = to_text(explanation_of(plan(solve(problem)), problem))
    assert "decreases with increasing d" in text


def test_a_place_that_is_given_at_an_impact() -> None:
    """4 = 2q, 9 = 3p with d = 9: and half of q for 1 s is 1."""
    statement = """
wall W: along i, through (0, 0)
wall X: along j, through (d, 0)
sphere P: at (0, 4), velocity p i - q j
P hits W: e = 1/2
P hits X
given time(1) = 2, time(2) = 3, position(P, 2) = (9, 1)
find p, q, d
"""
    solution = solve(parse(statement))
    assert [solution[name].exact for name in "pqd"] == [3, 2, 9]
    derivation = plan(solution)
    assert not derivation.notes


# --- what the follower takes ----------------------------------------------------------------------

PUCK = """
wall W: along i
sphere P: mass m, velocity p i - 4j
P hits W: e = e
given tan(angle(velocity(P), W)) = 1/2, e = 1/2
given e >= 1/2, p^2 = 9, energy_lost = e p, energy(P) = 4e
find p
"""
AFTER = (
    (Move("law", "restitution-wall", 1, ("P",)), ("velocity P", "axis 1", "e 1")),
    (Move("law", "unchanged", 1, ("P",)), ("velocity P", "axis 1")),
)
COMPONENTS = (
    (*AFTER[0], "along(velocity(P, 1), j) = 4e"),
    (*AFTER[1], "along(velocity(P, 1), i) = p"),
)


def refused(*lines: tuple[Move, tuple[object, ...], str]) -> set[int | None]:
    problem = parse(PUCK)
    names = {"P": "sphere", "W": "wall"}
    written = tuple(
        Line(number, "1", move, refs, read_relation(text, names))  # type: ignore[arg-type]
        for number, (move, refs, text) in enumerate(lines, 1)
    )
    whole = Derivation(facts_of(problem), written, (), events_of(problem))
    complaints_ = follow(whole, Oracle(roles(problem)))
    return {each.line for each in complaints_ if each.reason == "does-not-follow"}


@pytest.mark.parametrize(
    ("above", "known", "below", "right"),
    [
        ("e >= 1", ("e <= 1",), "e = 1", True),
        ("e >= 1/2", ("e <= 1",), "e = 1", False),
        ("e > 0", ("e <= 1",), "e = 1", False),
        ("e >= 1", (), "e = 1", False),
        ("e = 1 or e = 1/2", ("e <= 1",), "e = 1", False),
        ("2e = 2", ("e <= 1",), "e = 1", False),
    ],
)
def test_no_less_than_a_value_and_no_more_is_that_value(
    above: str, known: tuple[str, ...], below: str, right: bool
) -> None:
    lines = refused((Move("fact"), ("given 3",), above), (Move("compare"), (1, *known), below))
    assert (2 not in lines) == right


@pytest.mark.parametrize(
    ("above", "below", "right"),
    [
        ("p = 3 or p = -3", "abs(p) = 3", True),
        ("p = 3 or p = -3", "p^2 + 1 = 10", True),
        ("p = 3 or p = -3", "abs(p) = -3", False),
        ("p = 3 or p = -2", "abs(p) = 3", False),
        ("p = 3 or p = -3", "p = 3", False),
        ("p = 3 or p = -3", "2p = 6", False),
    ],
)
def test_an_expression_that_has_one_value_by_all_alternatives(
    above: str, below: str, right: bool
) -> None:
    lines = refused((Move("roots"), ("given 4",), above), (Move("put"), (1,), below))
    assert (2 not in lines) == right


@pytest.mark.parametrize(
    ("above", "known", "below", "right"),
    [
        ("p = -3", (), "abs(p) = 3", True),
        ("p = -3", (), "abs(p) = -3", False),
        ("p = -3", (), "abs(p) = 2", False),
        ("p = -4e", ("e >= 0",), "abs(p) = 4e", True),
        ("p = -4e", (), "abs(p) = 4e", False),
        ("p = -4e", ("e >= 0",), "abs(p) = -4e", False),
        ("p = 2e - 1", ("e <= 1",), "abs(p) = 2e - 1", False),
        ("2p = -6", (), "abs(p) = 3", False),
    ],
)
def test_the_size_of_what_a_line_tells(
    above: str, known: tuple[str, ...], below: str, right: bool
) -> None:
    lines = refused((Move("fact"), ("given 4",), above), (Move("rearrange"), (1, *known), below))
    assert (2 not in lines) == right


@pytest.mark.parametrize("asked", ["velocity(P), i", "velocity(P), j", "position(P), j"])
def test_the_size_of_a_component_is_read_off(asked: str) -> None:
    text = (
        "wall W: along i, through (0, 0)\nwall V: along j, through (15, 0)\n"
        "sphere P: velocity 3i - 4j, at (0, 8)\nP hits W: e = 1/2\nP hits V: e = f\n"
        f"find abs(along({asked}))\n"
    )
    assert explain(solve(parse(text)), check=True).followed


@pytest.mark.parametrize(
    ("tangent", "right"),
    [
        ("1/2 = 4e/abs(p)", True),
        ("1/2 = 4e/p", False),
        ("1/2 = -4e/p", False),
        ("1/2 = abs(p)/(4e)", False),
        ("1/2 = -4e/abs(p)", False),
    ],
)
def test_a_tangent_to_a_wall_has_the_size_of_what_is_of_either_sign(
    tangent: str, right: bool
) -> None:
    move = Move("define", "tan", 1, ("P",))
    lines = refused(*COMPONENTS, (move, ("given 1", "axis 1", 1, 2), tangent))
    assert (3 not in lines) == right


def test_no_line_is_a_tangle() -> None:
    statement = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/7
find tan(deflection(P)) in terms of alpha
given deflection(P) = 75°
find alpha
"""
    solution = solve(parse(statement))
    whole = plan(solution)
    longest = max(
        sum(1 for _ in walk(tree))
        for line in whole.lines
        if isinstance(line.relation, Relation)
        for tree in trees_of(line.relation)
    )
    assert longest <= 120


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("energy_lost(1)/energy(P, 1) = p/4", True),
        ("energy_lost(1)/energy(P, 1) = p/5", False),
        ("energy_lost(1) = p/4 energy(P, 1)", True),
        ("1/energy(P, 1) = 1/(4e)", False),
    ],
)
def test_who_writes_a_ratio_does_not_divide_by_zero(text: str, right: bool) -> None:
    lines = refused(
        (Move("fact"), ("given 5",), "energy_lost(1) = e p"),
        (Move("fact"), ("given 6",), "energy(P, 1) = 4e"),
        (Move("put"), (1, 2), text),
    )
    assert (3 not in lines) == right


@pytest.mark.parametrize(
    ("premises", "right"),
    [
        (("position P", "contact 1", "velocity P"), True),
        # Where it comes to a point nothing says that it moves in that direction.
        (("position P", "contact 2", "velocity P"), False),
    ],
)
def test_who_comes_to_a_wall_moves_towards_it(premises: tuple[str, ...], right: bool) -> None:
    problem = parse(
        "wall W: along i, through (0, 0)\nsphere P: at (0, h), velocity u i - v j\nP hits W\n"
        "P reaches (d, k)\nfind e"
    )
    number = int(premises[1].split()[1])
    move = Move("define", "straight-line", number, ("P",))
    start = "0" if number == 1 else "along(position(P, 1), i)"
    above = "h" if number == 1 else "k"
    text = f"along(position(P, {number}), i) - {start} = {above} u/v"
    names = {"P": "sphere", "W": "wall"}
    line = Line(1, "1", move, premises, read_relation(text, names))
    whole = Derivation(facts_of(problem), (line,), (), events_of(problem))
    reasons = {each.reason for each in follow(whole, Oracle(roles(problem)))}
    assert ("does-not-follow" not in reasons) == right


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("along(momentum(P, 1), j) = m 4e", True),
        ("along(momentum(P, 1), j) = 4e", False),
        ("along(momentum(P, 1), i) = m 4e", False),
        ("across(momentum(P, 1), i) = m 4e", True),
        ("along(momentum(P, 0), j) = m 4e", False),
    ],
)
def test_a_component_of_a_momentum(text: str, right: bool) -> None:
    move = Move("define", "momentum-of", 1, ("P",))
    lines = refused(*COMPONENTS[:1], (move, ("mass P", 1), text))
    assert (2 not in lines) == right
