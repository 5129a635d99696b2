"""The working of a range ends in the range, and no claim beside it contradicts it."""

from __future__ import annotations

import math
import re

import pytest

import restitution
from restitution.language import parse
from restitution.workings import explain, to_text


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            """
            wall W: along i
            sphere P: mass m, velocity u at alpha to W
            P hits W: e = 1/2
            unknown alpha
            find range of angle(velocity(P), W)
            """,
            [
                "tan β > 0 as α is acute, and it takes every positive value as α goes from 0°",
                "0° < β < 90°",
            ],
        ),
        (
            """
            sphere A: mass m, velocity u i
            sphere B: mass k m, at rest
            A hits B: along i
            given energy_lost < 500
            find range of u
            """,
            ["the kinetic energy lost is less than 500", "kmu²(1 − e²)/(2(1 + k)) < 500"],
        ),
        (
            """
            wall W: from (1, 0) to (4, 0)
            sphere P: at (0, 1), velocity a i - j
            P hits W
            find range of a
            """,
            ["P hits W between its ends: 1 < a < 4"],
        ),
        (
            """
            wall W: along i
            sphere P: mass m, velocity u at alpha to W
            P hits W
            given speed(P) = v
            find range of v in terms of u, e
            """,
            [
                "v² − e²u² = u²(1 − e²) cos²α",
                "u² − v² = u²(1 − e²) sin²α",
                "for e < 1 only: if e = 1, v = u.",
            ],
        ),
        (
            """
            sphere A: mass 2m, velocity u at alpha
            sphere B: mass m, velocity u at beta from -i
            A hits B: along i, e = e
            given alpha + beta = 90°, velocity(A) parallel to j
            find e in terms of alpha
            """,
            ["Since α + β = 90°: cos β = sin α", "e = (2 − tan α)/(1 + tan α)"],
        ),
        (
            """
            wall W: along i
            sphere P: velocity u at alpha to W
            P hits W
            given e > 0
            let beta = angle(velocity(P), W)
            show tan(alpha - beta) <= (1 - e)/(2 sqrt(e))
            """,
            [
                "By the formula for the tangent of a difference:",
                "(tan α − e tan α)/(1 + e tan²α) = (1 − e) tan α/(1 + e tan²α)",
                "S ≥ 2√e, as (1 − √e tan α)² ≥ 0 and α is acute",
            ],
        ),
        (
            """
            wall W: along i
            sphere P: velocity u at alpha to W
            P hits W
            given angle(velocity(P), W) = alpha/2
            show tan(alpha/2)^2 = 1 - 2e
            """,
            ["e = tan(α/2)/(2 tan(α/2)/(1 − tan²(α/2)))", "tan²(α/2) = 1 − 2e (as required)"],
        ),
        (
            """
            wall W: along i
            sphere P: velocity u at alpha to W
            P hits W
            given angle(velocity(P), W) = alpha/3
            find range of e
            """,
            [
                "by the formulae for multiple angles",
                "⅓ − e = 8 tan²(α/3)/(3(3 − tan²(α/3)))",
                "e < ⅓, as 3 − tan²(α/3) > 0, because α is acute",
            ],
        ),
        (
            """
            wall W: along i
            sphere P: mass m, velocity u at alpha to W
            P hits W
            given energy_lost = 1/4 energy(0)
            find range of e
            """,
            ["sin²α = 1/(4(1 − e²))", "0 ≤ e < √3/2", "as α is acute"],
        ),
        (
            """
            wall X: along i
            wall Y: along j
            sphere P: velocity u at 60° to X
            P hits X: e = e
            P hits Y: e = 2e
            find range of e
            """,
            ["A coefficient of restitution is at most 1: 2e ≤ 1 e ≤ ½ 0 ≤ e ≤ ½"],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity u i
            sphere B: mass 2m, at rest
            A hits B: along i, e = e
            B hits W: e = 1/2
            A hits B: along i, e = e
            find range of e
            """,
            [
                "A and B approach each other before the third impact: (1 − 2e)u/3 > −(1 + e)u/6",
                "e < 1",
            ],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity u i
            sphere B: mass 2m, at rest
            A hits B: along i, e = e
            B hits W: e = 1/2
            B hits A: along i, e = e
            find range of e
            """,
            [
                "B and A approach each other before the third impact: −(1 + e)u/6 < (1 − 2e)u/3",
                "e < 1",
            ],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity u i
            sphere B: mass k m, at rest
            A hits B: along i, e = 1/2
            A hits W: e = 1/2
            find range of k
            """,
            [
                "A moves towards W before the second impact: (2 − k)u/(2(1 + k)) < 0",
                "k > 2, as 1 + k > 0",
            ],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity 2u i
            sphere B: mass 5m, velocity u i
            B hits W: e = 1/2
            A hits B: along i, e = e
            B hits W: e = 1/2
            find range of e
            """,
            ["B moves towards W before the third impact: (5e − 1)u/12 > 0", "⅕ < e ≤ 1"],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity u at alpha
            sphere B: mass 2m, at rest
            A hits B: along i, e = e
            B hits W: e = 1/2
            A hits W: e = 1/2
            find range of e
            """,
            [
                "A moves towards W before the third impact: ⅓(1 − 2e)u cos α > 0",
                "0 ≤ e < ½, as",
            ],
        ),
        (
            """
            wall W: along j
            sphere A: mass m, velocity u i
            sphere B: mass k m, at rest
            A hits B: along i, e = e
            A hits W: e = e
            show k e > 1
            """,
            ["(1 − ke)u/(1 + k) < 0 ke > 1, as 1 + k > 0"],
        ),
        (
            """
            wall W: along i
            wall V: along i
            sphere P: velocity u at alpha to W
            P hits W: e = e
            P hits V: e = 1/2
            find range of e
            """,
            ["P moves towards V before the second impact: eu sin α > 0 e > 0", "0 < e ≤ 1"],
        ),
        (
            """
            wall X: along i, through (0, 0)
            wall Y: along 60°, through (0, 0)
            sphere P: at (3, 1), velocity u at -alpha
            P hits X: e = e
            P hits Y: e = 1/2
            given tan(alpha) = 3
            find range of e
            """,
            [
                "the unit vector perpendicular to Y, towards it",
                "P moves towards Y before the second impact: √10(3e − √3)u/20 > 0",
                "√3/3 < e ≤ 1",
            ],
        ),
        (
            """
            wall X: along i
            wall Y: along 60°
            sphere P: velocity u at alpha to X
            P hits X: e = 1/2
            P hits Y: e = 1/2
            find range of alpha
            """,
            [
                "P does not move parallel to Y before the second impact:",
                "tan α ≠ 2√3",
                "0° < α < arctan(2√3) or arctan(2√3) < α < 90°",
            ],
        ),
        (
            """
            sphere A: mass 4m, velocity u i
            sphere B: mass 2m, at rest
            sphere C: mass 3m, at rest
            A hits B: along i, e = e
            B hits C: along i, e = e
            given A and B collide again
            find range of e
            """,
            ["2 − e + 2e² > 0 2(e − ¼)² + 15/8 > 0 This always holds"],
        ),
        (
            """
            sphere A: mass m, velocity u i, radius r
            sphere B: mass 3m, at rest, radius r
            A hits B: offset d, e = 1
            unknown d
            find range of angle(velocity(B), i)
            """,
            ["tan β > 0, as d > 0 0° < β < 90°, as 0° ≤ β ≤ 180°"],
        ),
    ],
)
def test_conditions_that_fail_only_far_away_are_told(text: str, lines: list[str]) -> None:
    working = " ".join(str(explain(restitution.solve(parse(text)), marks="none")).split())
    for line in lines:
        assert line in working


@pytest.mark.parametrize(
    ("facts", "condition"),
    [
        ("given velocity(A) perpendicular to velocity(B)\nfind e in terms of k", "As e ≤ 1, "),
        ("given velocity(A) perpendicular to i\nfind e in terms of k", "As e ≤ 1, "),
    ],
)
def test_a_condition_says_which_coefficient_it_comes_from(facts: str, condition: str) -> None:
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
    working = " ".join(str(explain(restitution.solve(parse(text + facts)))).split())
    assert f"{condition}this holds for k ≥ 1 only." in working


IMPACT = "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"


@pytest.mark.parametrize(
    ("fact", "claims"),
    [
        (
            "given velocity(A) = -u/10 i\nfind range of k",
            {"k > 1": True, "k >= 11/9": True, "k < 50": False, "k > 11/9": False},
        ),
        (
            "given speed(B) = 3/4 u\nfind range of k",
            {"k < 2": True, "k <= 5/3": True, "k < 5/3": False, "e >= 0": True},
        ),
        (
            "given energy_lost = 1/2 energy(0)\nunknown e\nfind range of k",
            {"k >= 1": True, "k > 1": False, "k < 50": False},
        ),
    ],
)
def test_claims_beside_a_range_agree_with_it(fact: str, claims: dict[str, bool]) -> None:
    shows = "".join(f"\nshow {claim}" for claim in claims)
    solution = restitution.solve(parse(IMPACT + fact + shows))
    assert {claim: solution[claim].holds for claim in claims} == claims
    working = " ".join(str(explain(solution, marks="none")).split())
    for claim, holds in claims.items():
        shown = claim.replace(">=", "≥").replace("<=", "≤")
        false = f"It is not true that {shown}:"
        reason = r"(,? as .+?)?"
        assert bool(re.search(rf"{shown}{reason} \(as required\)", working)) is holds
        assert (false in working) is not holds


OBLIQUE = """\
sphere P: mass m, velocity u at alpha
sphere Q: mass {}, at rest
P hits Q: along i, e = e"""
CUSHION = """\
wall W: along i
sphere P: velocity u at (-alpha)
P hits W: e = e"""


@pytest.mark.parametrize(
    ("setting", "claim"),
    [
        (CUSHION, "deflection(P) > 90°"),
        (OBLIQUE.format("k m"), "deflection(P) < 60°"),
        (OBLIQUE.format("3 m"), "angle(velocity(P), velocity(Q)) < 100°"),
    ],
)
def test_an_angle_beside_a_counterexample_is_that_of_its_letters(setting: str, claim: str) -> None:
    solution = restitution.solve(parse(f"{setting}\nshow {claim}"))
    item = solution[claim]
    assert item.holds is False
    working = " ".join(str(explain(solution)).split())
    # "β ≈ 117°, which is more than 100°.": the value, and then the bound that was claimed.
    degrees = float(re.findall(r"([\d.]+)°(?:, which is (?:more|less) than \d+°)?\.", working)[-1])
    asked, sign, bound = re.fullmatch(r"(.*) ([<>]) (\d+)°", claim).groups()
    assert degrees >= float(bound) if sign == "<" else degrees <= float(bound)
    put = "".join(f"\ngiven {name} = {text}" for name, text in item.counterexample.items())
    exact = restitution.solve(parse(f"{setting}{put}\nfind {asked}"))[asked]
    assert math.degrees(exact.decimal) == pytest.approx(degrees, rel=5e-3)


def test_what_is_bounded_as_a_whole_is_said_once():
    text = """sphere A: mass m, velocity u i
sphere B: mass k m, velocity -v i
A hits B: along i
given speed(A) = speed(B)
find e, velocity(B)
"""
    working = " ".join(str(explain(restitution.solve(restitution.parse(text)))).split())
    assert working.lower().count("this holds for") == 1
    assert "As 0 ≤ e ≤ 1, this holds for 0 ≤ 2(u − kv)/((k − 1)(u + v)) ≤ 1 only." in working
    assert "As 0 ≤ e ≤ 1, this holds for 0 ≤ e ≤ 1" not in working


def test_a_condition_is_not_said_where_the_part_asks_for_it() -> None:
    text = "sphere A: mass m, velocity u at 30°\nsphere B: mass k m, at rest\nA hits B: along i\n"
    text += "given velocity(A) perpendicular to i\nfind e in terms of k\nfind range of k"
    working = str(explain(restitution.solve(parse(text))))
    assert "this holds for" not in working
    assert "k ≥ 1" in working


def test_a_condition_is_true_at_the_ends_of_the_letters_and_speaks_of_no_others() -> None:
    text = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
    text += "given speed(P) = v\nfind sin(alpha) in terms of u, v, e\n"
    text += "find energy_lost in terms of m, u, v"
    working = " ".join(str(explain(restitution.solve(parse(text)))).split())
    assert "< 1, this holds for eu < v < u and e < 1 only." in working
    assert working.lower().count("this holds for") == 1


def test_which_way_a_body_moves_gives_the_sign_and_what_holds_anyway_is_said() -> None:
    text = "sphere A: mass m, velocity 3u i\nsphere B: mass 4m, velocity -u i\n"
    text += (
        "A hits B: along i\ngiven velocity(A) opposite to i, velocity(B) in the direction of i\n"
    )
    text += "find range of e"
    working = " ".join(str(explain(restitution.solve(parse(text)))).split())
    assert "B moves in the direction of 𝐢, so w > 0:" in working
    assert "v < 0 in any case, as e ≥ 0." in working


def test_pieces_of_a_range_whose_order_rests_on_letters_have_no_working() -> None:
    text = "sphere A: mass 2, velocity 3i\nsphere B: velocity -2i\nA hits B: along i, e = 1/2\n"
    text += "given speed(A)/speed(B) = m u\nfind range of energy(A) + energy(B) in terms of m, u"
    working = " ".join(str(explain(restitution.solve(parse(text)))).split())
    assert "The steps from here are not written out." in working


def test_what_grows_and_falls_is_not_said_to_fall() -> None:
    """√(1 + 8 sin²α) cos α grows to 9√2/8 at sin²α = 7/16 first."""
    first, most = (math.sqrt(1 + 8 * s) * math.sqrt(1 - s) for s in (0, 7 / 16))
    assert most > first == 1
    text = """
sphere P: mass m, velocity u at alpha
sphere Q: mass m, at rest
P hits Q: along i, e = 1/3
find minimum of speed(P)*speed(Q) over alpha
"""
    shown = " ".join(str(explain(restitution.solve(parse(text)), check=True)).split())
    assert "decreases" not in shown
    assert "> 0, as α is acute" in shown


def test_a_product_is_divided_by_the_factor_whose_sign_is_plain() -> None:
    text = """
sphere A: mass m, velocity 3u i + u j
sphere B: mass 2m, velocity -u i + u j
A hits B: along i
given energy(B) < energy(A)
find range of e
"""
    explanation = explain(restitution.solve(parse(text)), check=True)
    assert explanation.warnings == ()
    lines = " ".join(to_text(explanation).split())
    assert (
        "(1 + 4e)(5 − 4e) < 0 Dividing by 1 + 4e, which is positive as e ≥ 0: 5 − 4e < 0 e > 5/4 "
        "But e ≤ 1. So what is described cannot happen."
    ) in lines


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            """
            wall W: along i
            sphere P: mass m, velocity u at 30° to W
            P hits W
            given deflection(P) > 20°
            find range of e
            """,
            "δ = 30° + β M1 δ > 20°, as 0° ≤ β ≤ 90° So it always holds that δ > 20°, as is given,",
        ),
        (
            """
            sphere A: mass 2m, velocity u at 30°
            sphere B: mass m, at rest
            A hits B: along i
            given angle(velocity(A), line_of_centres) > 25°
            find range of e
            """,
            "β > 25°, as 0° ≤ β < 90° So it always holds that β > 25°, as is given,",
        ),
    ],
)
def test_an_angle_given_that_every_value_allows_is_derived(text: str, lines: str) -> None:
    explanation = explain(restitution.solve(parse(text)), check=True)
    assert explanation.warnings == ()
    ending = " and every value of e is possible: 0 ≤ e ≤ 1"
    assert lines + ending in " ".join(to_text(explanation).split())


def test_conditions_are_written_again_after_their_lines_were_taken_away() -> None:
    """An attempt at the least angle goes back behind them; the next one needs them."""
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - alpha
A hits B: along i
given deflection(A) > 90°
find minimum of angle(velocity(A), velocity(B)) over e
"""
    printed = " ".join(to_text(explain(restitution.solve(parse(text)))).split())
    assert "v = −eu cos α" in printed
    assert "2α" in printed


def test_a_value_is_put_into_the_form_that_has_its_factors() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
sphere C: mass 9m, at rest
A hits B: along i, e = e
B hits C: along i, e = e
part a
find maximum of speed(C) over k
part b
given e = 1/3
show speed(C) < k u/4
"""
    working = " ".join(to_text(explain(restitution.solve(parse(text)))).split())
    form = "speed of C = (1 + e)²ku/((1 + k)(9 + k)) ("
    number = working[working.index(form) + len(form)]
    assert f"Since e = ⅓, from ({number}): speed of C = 16ku/(9(1 + k)(9 + k))" in working
