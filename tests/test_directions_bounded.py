"""Ranges of directions: on both sides of **i** and **j**, each with a working and a proof."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from workings import planned, solved

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain

SPHERES = """
sphere A: mass {m}, velocity {a}i + {b}j
sphere B: mass {n}, velocity {c}i + {d}j
A hits B: along {axis}
find range of direction(A), range of direction(B)
"""
# Masses and velocities; A is ahead, at right angles to the line of centres, or comes back.
CASES = [
    (4, 3, 4, 1, -2, 1, "i"),
    (4, 3, -4, 1, -2, -1, "i"),
    (2, 3, 4, 3, -2, 1, "i"),
    (1, 3, 4, 9, -2, -5, "i"),
    (1, 3, -4, 2, 0, 1, "i"),
    (1, 3, 4, 3, 2, -2, "j"),
]


def directions(
    m: int, a: int, b: int, n: int, c: int, d: int, axis: str
) -> tuple[list[float], list[float]]:
    """The directions after the impact for many e, by momentum and the law of restitution."""
    if axis == "j":
        a, b, c, d = b, a, d, c
    first, second = [], []
    for step in range(1001):
        e = step / 1000
        v = (m * a + n * c - n * e * (a - c)) / (m + n)
        w = v + e * (a - c)
        pairs = ((b, v), (d, w)) if axis == "i" else ((v, b), (w, d))
        for angles, (y, x) in zip((first, second), pairs, strict=True):
            angles.append(math.atan2(y, x))
    return first, second


@pytest.mark.parametrize("case", CASES)
def test_the_ends_are_those_of_all_coefficients(case: tuple[int, ...]) -> None:
    m, a, b, n, c, d, axis = case
    statement = SPHERES.format(m=m, a=a, b=b, n=n, c=c, d=d, axis=axis).replace("+ -", "- ")
    solution = solved(statement)
    for item, seen in zip(solution.parts[None].items, directions(*case), strict=True):
        values = item.distinct[0].value
        assert (float(values.inf), float(values.sup)) == pytest.approx((min(seen), max(seen)))
        assert item.proof != "undecided"  # that the ends are right is proved
    planned(statement)


def last(derivation: Derivation) -> Line:
    return derivation.lines[derivation.items[0].line - 1]


def complaints(statement: str, line: Line, derivation: Derivation) -> set[str]:
    lines = tuple(line if each.number == line.number else each for each in derivation.lines)
    oracle = Oracle(roles(parse(statement)))
    return {each.reason for each in follow(replace(derivation, lines=lines), oracle)}


SQUARE = SPHERES.format(m=2, a=3, b=4, n=3, c=-2, d=1, axis="i").replace("+ -", "- ")


@pytest.mark.parametrize(
    "wrong",
    [
        "90° <= direction(A, 1) <= 180° - arctan(3/4)",
        "-90° <= direction(A, 1) <= -arctan(4/3)",
        "arctan(4/3) <= direction(A, 1) <= 90°",
        "90° < direction(A, 1) <= 180° - arctan(4/3)",
    ],
)
def test_another_bound_of_the_cotangent_is_refused(wrong: str) -> None:
    _, derivation = planned(SQUARE)
    own = last(derivation)
    assert isinstance(own.relation, Relation)
    assert write_relation(own.relation) == "90° <= direction(A, 1) <= 180° - arctan(4/3)"
    false = replace(own, relation=read_relation(wrong, {"A": "sphere"}))
    assert "does-not-follow" in complaints(SQUARE, false, derivation)


def test_a_cotangent_alone_does_not_tell_on_which_side_a_velocity_points() -> None:
    _, derivation = planned(SQUARE)
    own = last(derivation)
    component = next(
        each
        for each in derivation.lines
        if each.move.record == "unchanged" and each.number in own.premises
    )
    rest = tuple(each for each in own.premises if each != component.number)
    assert "does-not-follow" in complaints(SQUARE, replace(own, premises=rest), derivation)


def test_in_letters_the_component_itself_tells_the_side() -> None:
    _, derivation = planned(
        """
        sphere A: mass m, velocity u at alpha
        sphere B: mass 2m, at rest
        A hits B: along i
        find range of direction(A)
        """
    )
    relation = derivation.lines[-1].relation
    assert isinstance(relation, Relation)
    assert write_relation(relation) == (
        "90° - arctan(1/(3tan(alpha))) <= direction(A, 1) <= 90° + arctan(1/(3tan(alpha)))"
    )
    across = next(each for each in derivation.lines if each.move.record == "unchanged")
    assert {across.number, "acute: alpha"} <= {*derivation.lines[-1].premises}


def test_a_right_angle_that_is_not_reached() -> None:
    statement = SQUARE.replace("find", "given e > 0\nfind")
    _, derivation = planned(statement)
    assert [write_relation(each.answer) for each in derivation.items] == [
        "90° < direction(A, 1) <= 180° - arctan(4/3)",
        "arctan(1/2) <= direction(B, 1) < 90°",
    ]


@pytest.mark.parametrize(
    "claim",
    [
        "alpha <= 180° - direction(A) <= 90°",
        "180° - direction(A) <= 90°",
        "direction(A) - 90° >= 0",
    ],
)
def test_a_claim_of_what_a_direction_is_taken_from(claim: str) -> None:
    _, derivation = planned(
        f"""
        sphere A: mass m, velocity u at alpha
        sphere B: mass m, velocity u at alpha from -i
        A hits B: along i
        show {claim}
        """
    )
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert any(each.startswith(("90° <= direction", "direction(A, 1) >= 90°")) for each in said)


IN_K = """
sphere A: mass m, velocity 3u i - 4u j
sphere B: mass k m, velocity -2u i + u j
A hits B: along i, e = 1/3
find direction(A), direction(B)
"""


def test_a_direction_on_either_side_of_j_is_told_by_its_cotangent() -> None:
    _, derivation = planned(IN_K)
    items = solved(IN_K).parts[None].items
    (k,) = items[0].distinct[0].value.free_symbols
    for ratio in (0.1, 0.8, 1.0, 4.0):
        v = (3 - 2 * ratio - ratio * 5 / 3) / (1 + ratio)  # momentum, and w - v = 5u/3
        for item, angle in zip(items, (math.atan2(-4, v), math.atan2(1, v + 5 / 3)), strict=True):
            assert float(item.distinct[0].value.subs(k, ratio)) == pytest.approx(angle)
    assert [write_relation(each.answer) for each in derivation.items] == [
        "theta = arctan((9 - 11k)/(12(1 + k))) - 90°",
        "phi = 90° - arctan(2(7 - 3k)/(3(1 + k)))",
    ]


@pytest.mark.parametrize(
    "wrong",
    ["theta = 90° + arctan((9 - 11k)/(12(1 + k)))", "theta = arctan((9 - 11k)/(12(1 + k)))"],
)
def test_another_angle_with_that_cotangent_is_refused(wrong: str) -> None:
    _, derivation = planned(IN_K)
    own = last(derivation)
    false = replace(own, relation=read_relation(wrong, {}))
    assert "does-not-follow" in complaints(IN_K, false, derivation)


OPEN = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
find {0}
"""


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        ("angle(velocity(A), velocity(B))", "beta = 90° - arctan((1 - 3e)/(4tan(alpha)))"),
        ("angle(velocity(A), i)", "beta = 90° - arctan((1 - 3e)/(4tan(alpha)))"),
        ("deflection(A)", "delta = 90° - arctan((1 - 3e)/(4tan(alpha))) - alpha"),
    ],
)
def test_an_angle_that_may_be_obtuse_is_told_by_its_cotangent(asked: str, answer: str) -> None:
    statement = OPEN.format(asked)
    _, derivation = planned(statement)
    assert [write_relation(each.answer) for each in derivation.items] == [answer]
    value = solved(statement).parts[None].items[0].distinct[0].value
    names = {each.name: each for each in value.free_symbols}
    for e, alpha in ((0, 0.3), (0.2, 1.1), (0.6, 0.7), (1, 0.2)):
        v = (1 - 3 * e) * math.cos(alpha) / 4  # momentum, and w - v = e cos(alpha)
        angle = math.atan2(math.sin(alpha), v) - (alpha if "deflection" in asked else 0)
        put = {names["e"]: e, names["alpha"]: alpha}
        assert float(value.subs(put)) == pytest.approx(angle)


def test_the_bounds_of_an_angle_that_may_be_obtuse() -> None:
    _, derivation = planned(OPEN.format("range of angle(velocity(A), velocity(B))"))
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert said[-2] == "-1/(2tan(alpha)) <= cot(beta) <= 1/(4tan(alpha))"


def test_the_range_of_an_angle_that_comes_to_90_degrees_is_proved() -> None:
    """Its tangent stands, and is put into its cotangent, which there is 0."""
    statement = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let beta = angle(velocity(A), i)
show tan(beta) = 2 tan(alpha)/(1 - e)
given tan(alpha) = 1/3
find range of beta
"""
    _, derivation = planned(statement)
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert said[-2] == "0 <= cot(beta) <= 3/2"
    solution = solved(statement)
    assert not solution.warnings
    low, high = solution.parts[None].items[1].distinct[0].value.args[:2]
    # v = ½(1 − e)u cos α, so that tan β is 2 tan α = ⅔ at e = 0, and v = 0 at e = 1.
    assert float(low) == pytest.approx(math.atan2(2, 3))
    assert float(high) == pytest.approx(math.pi / 2)


def test_no_value_grows_through_what_is_divided_by_zero() -> None:
    between = "angle(velocity(A), velocity(B))"
    statement = OPEN.format(f"tan({between}), range of {between}")
    _, derivation = planned(statement)
    bounded = next(each for each in derivation.lines if each.move.id == "monotone")
    tangent = derivation.items[0].line
    cotangent, *rest = bounded.premises
    assert tangent < cotangent  # type: ignore[operator]
    # The derivative has one sign, but between the ends 1 - 3e is zero.
    false = replace(
        bounded,
        premises=(tangent, *rest),
        relation=read_relation("4tan(alpha) <= tan(beta) <= -2tan(alpha)", {}),
    )
    assert ("does-not-follow", false.number) in {
        (each.reason, each.line)
        for each in follow(
            replace(
                derivation,
                lines=tuple(
                    false if each.number == false.number else each for each in derivation.lines
                ),
            ),
            Oracle(roles(parse(statement))),
        )
    }


VECTORS = """
sphere A: mass 2, velocity 5i + 2j
sphere B: mass 3, velocity -i - 2j
A hits B: along i
find {0}
"""


def test_an_angle_before_the_impact_has_the_definition_of_one_after_it() -> None:
    _, derivation = planned(VECTORS.format("deflection(A)"))
    assert [write_relation(each.answer) for each in derivation.items] == [
        "delta = 90° - arctan((7 - 18e)/10) - arctan(2/5)"
    ]


def test_a_sum_of_angles_may_be_more_than_half_a_turn() -> None:
    (item,) = solve(parse(VECTORS.format("deflection(A) + deflection(B)"))).parts[None].items
    value = item.distinct[0].value
    (letter,) = value.free_symbols
    for e in (0.05, 0.5, 0.95):
        v = (7 - 18 * e) / 5  # momentum, and w - v = 6e
        after = math.atan2(2, v) - math.atan2(2, 5), math.atan2(-2, v + 6 * e) - math.atan2(-2, -1)
        assert float(value.subs(letter, e)) == pytest.approx(sum(map(abs, after)))


def test_an_angle_and_that_of_a_velocity_that_is_turned_round() -> None:
    statement = """
    wall W: along i
    wall V: along j
    sphere P: velocity u at alpha to W
    P hits W: e = 1/2
    P hits V: e = 1/3
    find angle(velocity(P), velocity(P, 0)) + alpha
    """
    (item,) = solve(parse(statement)).parts[None].items
    value = item.distinct[0].value
    (letter,) = value.free_symbols
    for alpha in (0.2, 0.8, 1.4):
        late = math.atan2(math.sin(alpha) / 2, math.cos(alpha) / 3)  # to W, and turned round
        assert float(value.subs(letter, alpha)) == pytest.approx(math.pi - (late - alpha) + alpha)


TURNED = """
sphere A: mass m, velocity {velocity}
sphere B: mass 3m, at rest
A hits B: along i
given {given}
show {claim}
"""


@pytest.mark.parametrize(
    ("velocity", "given", "claim", "sign", "words"),
    [
        (
            "u at alpha",
            "e > 1/3",
            "direction(A) > 90°",
            "v < 0",
            "in the direction of 𝐢 and a positive component in the direction of 𝐣:",
        ),
        ("3u i - u j", "e > 1/3", "-180° < direction(A) < -90°", "v < 0", "a negative component"),
        ("3u i + u j", "e < 1/3", "direction(A) < 90°", "v > 0", "a positive component"),
        ("3u i + u j", "e > 1/3", "angle(velocity(A), i) > 90°", "v < 0", "a negative component"),
        (
            "3u i + u j",
            "e > 1/2",
            "deflection(A) > 90°",
            "dot(velocity(A, 0), velocity(A, 1)) < 0",
            "𝐮_A · 𝐯_A < 0, as e > ½ DM1 So angle of deflection of A > 90°",
        ),
    ],
)
def test_signs_of_components_tell_an_angle_beyond_a_right_angle(
    velocity: str, given: str, claim: str, sign: str, words: str
) -> None:
    statement = TURNED.format(velocity=velocity, given=given, claim=claim)
    _, derivation = planned(statement)
    lines = {
        each.number: write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation)
    }
    assert sign in [lines[ref] for ref in derivation.lines[-1].premises if ref in lines]
    assert words in " ".join(str(explain(solve(parse(statement)))).split())
    assert "cot" not in " ".join(lines.values())


@pytest.mark.parametrize(
    "wrong", ["direction(A, 1) < 90°", "direction(A, 1) > 180°", "direction(A, 1) > 100°"]
)
def test_another_quadrant_is_refused(wrong: str) -> None:
    statement = TURNED.format(velocity="u at alpha", given="e > 1/3", claim="direction(A) > 90°")
    _, derivation = planned(statement)
    own = derivation.lines[-1]
    other = read_relation(wrong, {"A": "sphere", "B": "sphere"})
    assert "does-not-follow" in complaints(statement, replace(own, relation=other), derivation)
