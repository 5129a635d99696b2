"""Whether the ends of a range belong to it: each case was worked by hand, as its comment says."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
import sympy as sp
from answers import disagreements, expected

from restitution.errors import UnboundedError
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.notation import read_relation
from restitution.export.answers import answers
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.oracle.roles import POSITIVE
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.ranges.limits import limits
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W\n"
REST = """sphere A: mass {}, velocity u at theta
sphere B: mass {}, at rest
A hits B: along i
"""

FREE = """sphere A: mass 1, velocity {}
sphere B: mass k, at rest
A hits B: along i
unknown e, k
"""

CASES = {
    # tan(delta) = 3t/(1 + 4t^2) < 3√2/8 where 4t^2 - 4√2 t + 1 > 0.
    "a tangent that leaves a gap": REST.format("m", "m").rstrip()
    + """, e = 1/2
given tan(deflection(A)) < 3√2/8
find range of tan(theta), range of tan(angle(velocity(A), i))
#= range of tan(theta) -> 0 < X < (√2 - 1)/2 or X > (√2 + 1)/2
#= range of tan(angle(velocity(A), i)) -> 0 < X < 2(√2 - 1) or X > 2(√2 + 1)""",
    # 2t/(1 + 3t^2) is 1/√3 at t = 1/√3 alone, and less elsewhere.
    "a tangent that leaves out one value": REST.format("m", "m").rstrip()
    + """, e = 1/3
given deflection(A) < 30°
find range of tan(theta), range of speed(A)
#= range of tan(theta) -> 0 < X < 1/√3 or X > 1/√3
#= range of speed(A) -> u/3 < X < u/√3 or u/√3 < X < u""",
    # theta comes to 0 as e comes to 1/√2, and does not reach it; e = 0 would need 90°.
    "both ends at ends of the angle": WALL
    + """given e^2 = cos(theta)^2/2
find range of e
#= range of e -> 0 < e < 1/√2""",
    "the same of an angle to be eliminated": WALL
    + """unknown theta
given e^2 = cos(theta)^2/2
find range of e
#= range of e -> 0 < e < 1/√2""",
    # cot(theta) > 0 keeps e below 1/√2; e = 0 is reached where cot^2(theta) = 1/2.
    "one end at 90 degrees": WALL
    + """given 1 - 2e^2 = 2 cot(theta)^2
find range of e, range of theta
#= range of e -> 0 <= e < 1/√2
#= range of theta -> arctan(√2) <= theta < 90°""",
    # e = 1/2 only where theta vanishes; e = 0 at 45°.
    "one end at 0 degrees": REST.format("m", "m")
    + """given tan(theta)^2 = 1 - 2e
find range of e, range of theta
#= range of e -> 0 <= e < 1/2
#= range of theta -> 0 < theta <= 45°""",
    # sin^2(theta) (1 - e^2) = 1/4: e^2 = 1 - 1/(4 sin^2(theta)) < 3/4.
    "energy lost at a wall": WALL
    + """given energy_lost = 1/4 energy(0)
find range of e, range of theta
#= range of e -> 0 <= e < √3/2
#= range of theta -> 30° <= theta < 90°""",
    # cos^2(theta) + e^2 sin^2(theta) = 1/4.
    "speed at a wall": WALL
    + """given speed(P) = u/2
find range of e, range of theta
#= range of e -> 0 <= e < 1/2
#= range of theta -> 60° <= theta < 90°""",
    # A has the component u cos(alpha) (1 - k - 2ek)/(1 + k) along i, which has to be positive.
    "an angle with a name, less than 90 degrees": """sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity u at 180° - alpha
A hits B: along i
let beta = angle(velocity(A), i)
given beta < 90°
find range of k in terms of e
#= range of k -> 0 < k < 1/(1 + 2e)""",
    # Where k > 4, A goes back: its direction is below -90°, and so less than 90° as well.
    "a direction below 0 degrees": """sphere A: mass 2, velocity 3i - 4j
sphere B: mass k, at rest
A hits B: along i, e = 1/2
given direction(A) < 90°
find range of k
#= range of k -> k > 0""",
    # A has the components 3(4 - k)/(2 (2 + k)) and -4: from -90° on while it does not go back.
    "a direction from -90 degrees on": """sphere A: mass 2, velocity 3i - 4j
sphere B: mass k, at rest
A hits B: along i, e = 1/2
given direction(A) >= -90°
find range of k
#= range of k -> 0 < k <= 4""",
    # e = 1: 2 theta = 60°; e = 0: theta = 60°, P goes on along W. There the equation for
    # tan(theta), √3 e t^2 + (1 + e)t - √3 = 0, is no longer quadratic.
    "deflection at a wall": WALL
    + """given deflection(P) = 60°
find range of e, range of theta
#= range of e -> 0 <= e <= 1
#= range of theta -> 30° <= theta <= 60°""",
    # A: (2 - e)/3 along, t across; B: 2(1 + e)/3: 9t^2 = 12e + 3e^2.
    "equal speeds": REST.format("2m", "m")
    + """given speed(A) = speed(B)
find range of e, range of theta
#= range of e -> 0 < e <= 1
#= range of theta -> 0 < theta <= arctan(√15/3)""",
    # 2t^2 - (1 + e)t + 1 - e = 0: e = (2t^2 - t + 1)/(1 + t) is least at t = √2 - 1, and 1 at t = 1
    # and, not reached, at t = 0.
    "a least value inside": REST.format("m", "m")
    + """given deflection(A) = 45°
find range of e, range of theta
#= range of e -> 4√2 - 5 <= e <= 1
#= range of theta -> 0 < theta <= 45°""",
    # t^2 = (2k - 1)/(1 + k).
    "a mass without an upper end": REST.format("m", "k m")
    + """given e = 1/2
given deflection(A) = theta
find range of k, range of theta
#= range of k -> k > 1/2
#= range of theta -> 0 < theta < arctan(√2)""",
    # A goes on with 1 - 3e: 1 where e = 0, at rest where e = 1/3, and 2 backwards where e = 1.
    "a speed that vanishes inside": """sphere A: mass 1, velocity 4i
sphere B: mass 3, at rest
A hits B: along i
find range of speed(A), minimum of speed(A) over e, maximum of speed(A) over e
#= range of speed(A) -> 0 <= speed(A) <= 2
#= minimum of speed(A) over e -> 0 when e = 1/3
#= maximum of speed(A) over e -> 2 when e = 1""",
    # A goes on with (1 - 2e) u/3.
    "the same in letters": """sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i
find range of speed(A), minimum of speed(A) over e
#= range of speed(A) -> 0 <= speed(A) <= u/3
#= minimum of speed(A) over e -> 0 when e = 1/2""",
    # A goes on with u (1 - k/2)/(1 + k).
    "at rest for one mass": """sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
find minimum of speed(A) over k
#= minimum of speed(A) over k -> 0 when k = 2""",
    # A goes on with (m - eM) u/(m + M), back where M/m > 1/e.
    "a ratio by its name": """sphere A: mass m, velocity u i
sphere B: mass M, at rest
A hits B: along i
let k = M/m
let q = k
given velocity(A) opposite to velocity(B)
find range of k, range of q, range of M/m
#= range of k -> k > 1/e
#= range of q -> q > 1/e
#= range of M/m -> M/m > 1/e""",
    # 3(1 - k) e^2 + 6e = 1 + k: e = 1 where k = 2, and e = 1/3 where k = 1, where it is no
    # longer quadratic.
    "a quadratic that is linear inside": """sphere A: mass m, velocity u at 30°
sphere B: mass k m, at rest
A hits B: along i
given speed(A) = speed(B)
find range of k, e
#= range of k -> 0 < k <= 2
#= e -> (1 + k)/(3 + sqrt(12 - 3k^2))""",
    # The line of centres makes theta with i, sin(theta) = d/(2r): B has 3/4 u cos(theta).
    "an offset and a radius that both vary": """sphere A: mass m, radius r, velocity u i
sphere B: mass m, at rest
A hits B: offset d, e = 1/2
find range of speed(B) in terms of u
#= range of speed(B) -> 0 < speed(B) < 3/4 u""",
    # 1 - e^2 = 3/8 (1 + v^2/u^2), and e = 0 where v^2 = 5/3 u^2.
    "a ratio of components of either sign": """sphere A: mass 2m, velocity u i + v j
sphere B: mass m, velocity -u i + v j
A hits B: along i
given energy_lost = 1/3 energy(0)
find range of v/u
#= range of v/u -> -√15/3 <= v/u <= √15/3""",
    # v = 3(1 - ek)/(1 + k) takes all values from -3 to 3, neither included.
    "two letters that leave a gap": FREE.format("3i")
    + """given abs(along(velocity(A), i)) >= 1
find range of along(velocity(A), i)
#= range of along(velocity(A), i) -> -3 < X <= -1 or 1 <= X < 3""",
    # tan = 1/v with the same v.
    "a pole among the values of two letters": FREE.format("3i + j")
    + """find range of tan(direction(A))
#= range of tan(direction(A)) -> X < -1/3 or X > 1/3""",
    # v = 1 - 2e passes 0.
    "a pole among the values of one letter": """sphere A: mass 1, velocity 3i + j
sphere B: mass 2, at rest
A hits B: along i
find range of tan(direction(A)), range of direction(A)
#= range of tan(direction(A)) -> X <= -1 or X >= 1
#= range of direction(A) -> 45° <= X <= 135°""",
    # v = (3 - 3ek)/(1 + k) is 0 at e = 1/k, where nothing has a direction.
    "a direction that is along a line in either sense": FREE.format("3i")
    + """find range of direction(A), range of deflection(A)
#= range of direction(A) -> X = 0° or X = 180°
#= range of deflection(A) -> X = 0° or X = 180°""",
    # The pole k = 25/(16e - 9) is there for e > 9/16; as k grows, tan comes to 12(1 + e)/(16e - 9).
    "a pole for some values of the data": """sphere A: mass 1, velocity u i, radius r
sphere B: mass k, at rest, radius r
A hits B: offset 1.2r, e = 1
unknown k
find range of tan(direction(A))
#= range of tan(direction(A)) -> X < 0 or X > 24/7""",
    # tan = 3 tan(alpha)/(2e - 1).
    "a limit whose sign hangs on another letter": """sphere A: mass 1, velocity u at alpha
sphere B: mass 2, velocity u at 180° - alpha
A hits B: along i
unknown alpha, e
find range of direction(B)
#= range of direction(B) -> 0° < X < 180°""",
    "a quantity in which what varies has no part": """sphere A: mass 2, velocity u at alpha
sphere B: mass 1, at rest
A hits B: along i
unknown e
find range of along(velocity(A), j)
#= range of along(velocity(A), j) -> X = u sin(alpha)""",
    # A goes on with -3i + (2 - 4e)/3 j.
    "a direction that passes 180°": """sphere A: mass 1, velocity -3i + 2j
sphere B: mass 2, at rest
A hits B: along j
find range of direction(A)
#= range of direction(A) -> -180° < X <= arctan(2/9) - 180° or 180° - arctan(2/9) <= X <= 180°""",
    # B goes on with (11M - 10m)u/(5(M + m)), which comes to 11u/5 for masses that are seldom drawn.
    "an end that only a great mass comes near to": """sphere A: mass M, velocity u at arctan(3/4)
sphere B: mass m, velocity -2u i
A hits B: along i, e = 1/2
unknown M
find range of speed(B)
#= range of speed(B) -> 0 <= X < 11u/5""",
    # It starts inside, as it may: beyond the rim it would strike the circle from outside.
    "a place within a circle": """wall C: circle centre (0, 0) radius a
sphere P: mass m, at (0, -d), velocity u at alpha
P hits C
find range of d
#= range of d -> -a < X <= a""",
}


@pytest.mark.parametrize("text", CASES.values(), ids=CASES.keys())
def test_ends(text: str) -> None:
    assert disagreements(solve(parse(text)), expected(text)) == []


def test_a_range_with_a_pole_for_some_data_is_told_case_by_case() -> None:
    """With e above 9/16 a heavy B sends A back, and the tangent goes through infinity."""
    text = "sphere A: mass 1, velocity u i, radius r\nsphere B: mass k, at rest, radius r\n"
    text += "A hits B: offset 1.2r\nunknown k\nfind range of tan(direction(A))"
    answers = solve(parse(text))["range of tan(direction(A))"].answers
    assert [each.condition for each in answers] == [("e < 9/16",), ("e = 9/16",), ("9/16 < e",)]
    assert isinstance(answers[2].value, sp.Union)


def test_a_range_has_a_form_of_its_own_where_there_is_no_rebound() -> None:
    item = solve(parse(WALL + "unknown theta\nfind range of angle(velocity(P), i)"))[
        "range of angle(velocity(P), i)"
    ]
    forms = {answer.condition: answer.value for answer in item.answers}
    acute = sp.Interval.open(0, sp.pi / 2)
    assert forms == {("e = 0",): sp.FiniteSet(0), ("0 < e",): acute}
    assert item.proof == "decision"


def test_an_extremum_is_not_approached_where_nothing_varies() -> None:
    # P keeps u cos θ, and eu sin θ: for e = 1 its speed is u, whatever θ is.
    ((_, item),) = solve(parse(WALL + "find minimum of speed(P) over theta")).items()
    (answer,) = item.answers
    assert (str(answer.value), answer.condition, answer.reached) == ("e*u", ("e < 1",), False)
    assert item.proof == "decision"


def test_an_equation_that_holds_of_itself_for_some_data_says_nothing_there() -> None:
    solution = solve(
        parse(
            """
            sphere A: mass m, velocity u at alpha
            sphere B: mass k m, velocity u at 180° - alpha
            A hits B: along i
            given speed(A) = speed(B)
            find k
            """
        )
    )
    answer = solution["k"].answers[0]
    assert answer.display == "1, for e > 0"
    assert answer.condition == ("0 < e",)


def test_one_value_that_is_left_out_of_all_is_told_alone() -> None:
    solution = solve(
        parse(
            """
            sphere A: mass m, velocity u i + v j
            sphere B: mass m, at rest
            A hits B: along i
            given tan(angle(velocity(A), i)) = 4 tan(angle(velocity(A, 0), i))
            find e
            """
        )
    )
    assert solution["e"].answers[0].display == "½, for v ≠ 0"


def test_a_letter_is_fixed_though_one_value_of_another_leaves_it_open() -> None:
    """Where e = 1 no energy is lost, whatever k is: the reason of that is not k > 0."""
    text = """
        sphere A: mass m, velocity u i
        sphere B: mass k m, velocity -w i
        A hits B: along i
        given energy_lost = m (1-e^2) u^2
        find k"""
    shown = "2u²/(2uw − u² + w²), for e ≠ 1 and 2uw − u² + w² > 0"
    for terms in ("", " in terms of u, w", " in terms of e, u, w"):
        assert solve(parse(text + terms))["k"].answers[0].display == shown
    assert "As k > 0" not in to_text(explain(solve(parse(text))))


def test_where_a_least_value_is_reached_has_to_exist() -> None:
    """A goes on with (1 - ek)u cos(alpha)/(1 + k), which vanishes for no k where e = 0."""
    text = """sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
find minimum of speed(A) over k"""
    solution = solve(parse(text))
    (result,) = solution.parts[None].items
    (answer,) = result.answers
    assert answer.condition == ("0 < e",)
    assert answer.display == "u sin α when k = 1/e, for e > 0"
    assert "when k = 1/e A1 A1 This holds for e > 0 only, as there is no such k" in " ".join(
        to_text(explain(solution)).split()
    )


def test_an_extreme_that_is_reached_at_both_ends() -> None:
    """A has (1 - 2e)u/6 along the line of centres: as fast where e = 0 as where e = 1."""
    text = """sphere A: mass m, velocity u at 60°
sphere B: mass 2m, at rest
A hits B: along i
find maximum of speed(A) over e, minimum of speed(A) over e"""
    solution = solve(parse(text))
    greatest, least = solution.parts[None].items
    assert greatest.display == "√7 u/3 = 0.882u when e = 0 or e = 1"
    assert least.display.endswith(" when e = ½")
    assert "≈ 0.882u, when e = 0 or e = 1" in to_text(explain(solution))
    derivation = plan(solution)
    oracle = Oracle(roles(solution.problem))
    assert follow(derivation, oracle) == ()
    last = next(e.line for e in derivation.items if e.item == "1")
    wrong = [
        replace(
            each,
            relation=read_relation("e != 1/3 or speed(A, 1) = sqrt(7) u/3", {"A": "sphere"}),
        )
        if each.number == derivation.lines[last - 1].premises[-1]
        else each
        for each in derivation.lines
    ]
    assert follow(replace(derivation, lines=tuple(wrong)), oracle)


# Both grow with what they are sought over, which has no upper end.
@pytest.mark.parametrize("item", ["speed(B) over u", "k u over k", "k over k"])
def test_no_greatest_value(item: str) -> None:
    text = f"""sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
find maximum of {item}"""
    (result,) = solve(parse(text)).parts[None].items
    assert result.error is not None
    assert result.error.kind == "impossible"
    assert "no maximum" in result.error.message


@pytest.mark.parametrize("item", ["range of e", "maximum of e over e", "range of x"])
def test_letter_of_questions_only(item: str) -> None:
    (result,) = solve(parse(f"{WALL.strip()}: e = 1\nfind {item}")).parts[None].items
    assert result.error is not None
    assert result.error.kind == "missing"


# A turns back where e > 1/2; B goes on with 2(1 + e).
@pytest.mark.parametrize(
    ("claim", "truth"),
    [
        ("range of e: 0 < e < 1", sp.Interval.Lopen(sp.Rational(1, 2), 1)),
        ("maximum of speed(B) over e = 2", 4),
    ],
)
def test_false_claim_is_answered_with_the_truth(claim: str, truth: object) -> None:
    text = f"""sphere A: mass m, velocity 6i
sphere B: mass 2m, at rest
A hits B: along i
given velocity(A) opposite to velocity(B)
show {claim}"""
    solution = solve(parse(text))
    (shown,) = solution.parts[None].items
    assert shown.holds is False
    assert shown.counterexample is None
    assert [each.value for each in shown.answers] == [truth]
    assert shown.answers[0].display in answers(solution)


def test_a_right_angle_at_a_pole_has_one_sense() -> None:
    # A keeps (1 - e)u cos(theta)/2 along i: the tangent is 2 tan(theta)/(1 - e).
    text = REST.format("m", "m") + "find {} of angle(velocity(A), i) over e"
    ((_, least),) = solve(parse(text.format("minimum"))).items()
    ((_, greatest),) = solve(parse(text.format("maximum"))).items()
    assert least.answers[0].display == "arctan(2 tan θ) when e = 0"
    assert greatest.answers[0].display == "90° when e = 1"


def test_a_place_beyond_a_circle_is_no_place_of_an_extremum() -> None:
    """It lies at d = a√((1 + sin α)/2)/cos α, and that is within the circle for α < 30° alone.

    From the lowest point P goes on at 3α: by the centre of the chord it turns through 2α.
    """
    text = """wall C: circle centre (0, 0) radius a
sphere P: mass m, at (0, -d), velocity u at alpha
P hits C: e = 1
{}
find maximum of along(velocity(P), j) over d"""
    ((_, item),) = solve(parse(text.format(""))).items()
    within, beyond = item.answers
    assert within.display == "u when d = a√((1 + sin α)/2)/cos α, for α ≤ 30°"
    assert beyond.condition == ("pi/6 < alpha",)
    alpha, u = sp.symbols("alpha u")
    assert sp.expand_trig(sp.sympify(beyond.exact) - u * sp.sin(3 * alpha)).equals(0)
    ((_, item),) = solve(parse(text.format("given alpha = 10°"))).items()
    assert item.answers[0].reached


def test_a_sense_that_hangs_on_the_data_is_no_extremum() -> None:
    # B moves on in the direction of i where ku > 3v: then its greatest angle with i is 0.
    item = solve(
        parse(
            """sphere A: mass k m, velocity u i
sphere B: mass 3m, velocity -v i
sphere C: mass m, at rest
A hits B: along i
B hits C: along i, e = f
find maximum of angle(velocity(B), i) over e"""
        )
    )["maximum of angle(velocity(B), i) over e"]
    assert all(answer.value != sp.pi for answer in item.answers)


def test_a_limit_whose_sign_hangs_on_the_data_is_no_extremum() -> None:
    # A light sphere is turned back from an impact that is nearly direct, a heavy one goes on.
    text = """
sphere A: mass k m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1
{given}
find maximum of deflection(A) over alpha
"""
    # With B of mass 3m usual data are light, and only an extreme one goes on.
    other = text.replace("sphere B: mass m", "sphere B: mass 3m")
    for statement, mass in ((text, 1), (other, 3)):
        ((_, item),) = solve(parse(statement.format(given=""))).items()
        conditions = [answer.condition for answer in item.answers]
        assert conditions == [(f"k < {mass}",), (f"k = {mass}",), (f"{mass} < k",)]
        assert [answer.value for answer in item.answers][:2] == [sp.pi, sp.pi / 2]
    ((_, item),) = solve(parse(text.format(given="given k > 1"))).items()
    assert item.answers[0].display.endswith("when α = arctan(√((k − 1)/(1 + k)))")
    ((_, item),) = solve(parse(text.format(given="given k < 1"))).items()
    assert item.answers[0].display == "180° approached as α → 0°"


@pytest.mark.parametrize(
    ("text", "because"),
    [
        (
            (
                "wall W: along i\nsphere P: mass m, velocity u i - v j\nP hits W\n"
                "find maximum of energy_lost over v"
            ),
            "for e < 1 it grows without bound as v → ∞",
        ),
        (
            (
                "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
                "find maximum of impulse over m"
            ),
            "it grows without bound as m → ∞",
        ),
        (
            REST.format("m", "m").replace("at rest", "velocity -v i")
            + "find minimum of along(velocity(A), i) over v",
            "it falls without bound as v → ∞",
        ),
    ],
)
def test_what_grows_without_bound_has_no_extremum(text: str, because: str) -> None:
    ((_, item),) = solve(parse(text)).items()
    assert isinstance(item.error, UnboundedError)
    assert item.error.because == because
    working = explain(solve(parse(text)), check=True)
    assert working.followed
    printed = " ".join(str(working).split())
    assert "There is no " in printed and because in printed
    assert "cannot happen" not in printed


def test_a_place_at_which_no_impact_is_has_no_limit() -> None:
    """B is missed beyond d = 2r: there the components are complex, and so are their limits.

    The greatest deflection is that of equal spheres, at sin²α = (1 − e)/(3 − e) with d = 2r sin α.
    """
    text = """sphere A: mass m, radius r, velocity u i, at (0, 0)
sphere B: mass m, radius r, at rest, at (10 r, d)
A hits B
find maximum of deflection(A) over d"""
    ((_, item),) = solve(parse(text)).items()
    (answer,) = item.answers
    assert answer.display == (
        "arctan(√2(1 + e)/(4√(1 − e))) when d = 2r√((1 − e)/(3 − e)), for e < 1"
    )


def test_a_small_limit_of_the_other_sign_is_no_extremum() -> None:
    """Near 90° the deflection of A is small, and so is its opposite, that of another form."""
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
    ((_, item),) = solve(parse(text + "find minimum of deflection(A) over e")).items()
    assert item.answers[0].display == "arctan(tan α/(1 + 2 tan²α)) when e = 0"


def test_angles_of_0_and_180_degrees_are_compared() -> None:
    # A goes on in the direction of i for k > 1/2 and comes back for k < 1/2.
    text = """sphere A: mass k m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given k {} 1/2
show angle(velocity(A), i) < 180°
show angle(velocity(A), i) <= angle(velocity(B), i)
show angle(velocity(A), i) <= 90°"""
    for sign, verdict in ((">", True), ("<", False)):
        items = [item for _, item in solve(parse(text.format(sign))).items()]
        assert [item.holds for item in items] == [verdict] * 3


def test_no_limit_is_sought_where_a_letter_never_comes() -> None:
    m, k = POSITIVE.symbol("m"), POSITIVE.symbol("k")
    value = (k - m) / (k + m)
    assert limits(value, k, -m, POSITIVE, broken=True) == []
    assert limits(value, k, sp.Rational(-3, 2), POSITIVE, broken=False) == []
    assert limits(value, k, sp.Integer(0), POSITIVE, broken=False) == [(sp.Integer(-1), {})]


@pytest.mark.parametrize(
    ("coefficient", "terms", "ends"),
    [
        ("1", "u", "v = u"),
        ("1/2", "u, alpha", "v = u√(4 − 3 sin²α)/2"),
        ("1/2", "u", "u/2 < v < u"),
    ],
)
def test_a_letter_that_the_facts_tie_to_data_has_one_value(
    coefficient: str, terms: str, ends: str
) -> None:
    text = f"""wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = {coefficient}
given speed(P) = v
find range of v in terms of {terms}"""
    ((_, item),) = solve(parse(text)).items()
    assert item.answers[0].display == ends


def test_a_letter_found_in_an_earlier_part_has_its_range_in_a_later_one() -> None:
    text = """
sphere A: mass k m, velocity 2u i + u j
sphere B: mass m, velocity -u i
A hits B: along i, e = e
given velocity(A) = u j
part a
find k in terms of e
part b
find range of k
"""
    (_, value), (_, values) = solve(parse(text)).items()
    assert [each.display for each in (*value.answers, *values.answers)] == [
        "(1 + 3e)/2",
        "½ ≤ k ≤ 2",
    ]


def test_both_ends_at_which_a_greatest_value_is_approached_are_named() -> None:
    """The angle is 180° − (arctan 2t − arctan t), which goes to 180° for t → 0 and t → ∞."""
    ((_, item),) = solve(
        parse("""
wall V: along i
wall W: along j
sphere P: velocity u at alpha to V
P hits V: e = 1/2
P hits W: e = 1/4
find maximum of angle(velocity(P), velocity(P, 0)) over alpha
""")
    ).items()
    assert not item.answers[0].reached
    assert item.answers[0].display == "180° approached as α → 0° or α → 90°"


@pytest.mark.parametrize(("angle", "mass"), [(27, 3), (33, 2)])
def test_both_speeds_at_angles_with_surds_have_a_range(angle: int, mass: int) -> None:
    text = f"""
sphere A: mass {mass}, velocity 5 at {angle}° from -i
sphere B: mass 1, velocity 2 at 120° from -i
A hits B: along -i
given speed(B) > speed(A)
find range of e
"""
    ((_, item),) = solve(parse(text)).items()
    (own,) = item.distinct

    def excess(e: float) -> float:
        a, b = 5 * math.cos(math.radians(angle)), -1.0
        common, approach = (mass * a + b) / (mass + 1), a - b
        one = common - e * approach / (mass + 1)
        other = common + mass * e * approach / (mass + 1)
        across = 5 * math.sin(math.radians(angle)), math.sqrt(3)
        return math.hypot(other, across[1]) - math.hypot(one, across[0])

    assert own.value.end == 1
    assert excess(float(own.value.start)) == pytest.approx(0, abs=1e-9)
    assert excess(1) > 0


def test_a_root_by_which_a_sphere_is_at_rest_leaves_a_range_to_the_others() -> None:
    """k = (2 tan φ − 1)/(1 − tan φ), which is more than 0; with k = 0 the sphere comes to no Y."""
    text = (
        "wall X: along j, through (2d, 0)\nwall Y: along i, through (0, d)\n"
        "sphere Q: at (0, -d), velocity w at phi\nQ hits X: e = k\nQ hits Y: e = k\n"
        "Q reaches (-2d, -d)\ngiven d > 0\nfind range of phi"
    )
    ((_, item),) = solve(parse(text)).items()
    (answer,) = item.answers
    low, high = answer.value.start, answer.value.end
    assert (sp.tan(low), sp.tan(high)) == (sp.Rational(1, 2), sp.Rational(2, 3))
