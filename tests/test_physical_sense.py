"""What a motion has to be to be possible, and what is said where it is not.

Roots and times were worked out by hand from the two equations of an impact.
"""

from __future__ import annotations

import pytest
import sympy

import restitution
from restitution.errors import ContradictionError, ImpossibleError, MissingError
from restitution.solving.equations.solution import ItemResult


def answer(text: str) -> ItemResult:
    """The first item of a statement, solved."""
    (part, *_) = restitution.solve(restitution.parse(text)).parts.values()
    return part.items[0]


def rejected(text: str) -> list[tuple[str, str]]:
    return [(root.exact, root.reason) for root in answer(text).rejected]


COEFFICIENT = "a coefficient of restitution lies in [0, 1]"


def test_a_coefficient_below_zero_is_told_of() -> None:
    # 4i becomes v i with v**2 = 10 - 9: v = -1 gives e = 1/2, v = 1 gives e = -1/10.
    text = """sphere A: mass 1, velocity 4i+3j
sphere B: mass 2, velocity -i
A hits B: along i
given speed(A) = √10
find e"""
    assert [each.exact for each in answer(text).answers] == ["1/2"]
    assert rejected(text) == [("-1/10", COEFFICIENT)]


def test_so_it_is_at_a_wall() -> None:
    # 9 (1 - e**2) = 5
    text = """wall W: along i
sphere P: mass 2, velocity 5i - 3j
P hits W
given energy_lost = 5
find e"""
    assert [each.exact for each in answer(text).answers] == ["2/3"]
    assert rejected(text) == [("-2/3", COEFFICIENT)]


def test_a_root_is_told_of_though_it_is_the_only_one() -> None:
    # 3 (m - 3)/(m + 3) = -4
    text = """sphere A: mass m, velocity 3i
sphere B: mass 3, at rest
A hits B: along i, e = 1
given velocity(A) = -4i
find m"""
    assert isinstance(answer(text).error, ImpossibleError)
    assert rejected(text) == [("-3/7", "m must be positive")]


@pytest.mark.parametrize("mass", ["-2", "0"])
def test_a_mass_at_a_wall_is_positive(mass: str) -> None:
    error = answer(f"""wall W: along i
sphere P: mass {mass}, velocity 5i - 3j
P hits W: e = 1/2
find impulse""").error
    assert isinstance(error, ImpossibleError)
    shown = mass.replace("-", "−")
    assert error.message == f"the mass of P is {shown}: a mass must be positive"
    assert (error.line, error.column) == (2, 16)


@pytest.mark.parametrize(
    ("one", "other", "said"),
    [
        ("1", "3", "all spheres have one radius: A has 1, B has 3"),
        ("r", "s", "all spheres have one radius: A has r, B has s"),
        ("0", "0", "the radius of A is 0: a radius must be positive"),
        ("-1", "-1", "the radius of A is −1: a radius must be positive"),
    ],
)
def test_all_spheres_have_one_positive_radius(one: str, other: str, said: str) -> None:
    error = answer(f"""sphere A: mass 1, velocity i, radius {one}
sphere B: mass 1, at rest, radius {other}
A hits B: along i, e = 1
find velocity(B)""").error
    assert isinstance(error, ImpossibleError)
    assert said in str(error)


IN_A_ROW = """sphere A: mass 1, at (0, 0), velocity 2i{size}
sphere B: mass 1, at (5, {aside}), at rest{size}
sphere C: mass 1, at (12, 0), at rest{size}
"""


@pytest.mark.parametrize("size", ["", ", radius 1"])
def test_a_sphere_may_stand_in_the_way(size: str) -> None:
    text = IN_A_ROW.format(size=size, aside=0)
    error = answer(text + "A hits C: along i, e = 1\nfind velocity(C)").error
    assert isinstance(error, ImpossibleError)
    assert "A strikes B first" in str(error)


@pytest.mark.parametrize(("size", "aside"), [("", 1), (", radius 1", 3), (", radius 1", 2)])
def test_or_beside_it(size: str, aside: int) -> None:
    text = IN_A_ROW.format(size=size, aside=aside)
    assert answer(text + "A hits C: along i, e = 1\nfind velocity(C)").error is None


def test_what_is_struck_in_turn_is_in_nobody_s_way() -> None:
    text = IN_A_ROW.format(size="", aside=0)
    found = answer(text + "A hits B: along i, e = 1\nB hits C: along i, e = 1\nfind time(2)")
    assert found.exact == 6


def test_a_wall_that_was_reached_is_hit_then_and_there() -> None:
    text = """wall S: along j, through (4, 0)
sphere P: mass 1, at (0, 0), velocity 2i + j
P reaches S
P hits S: e = 1/4
find """
    assert answer(text + "time(1)").exact == answer(text + "time(2)").exact == 2
    assert answer(text + "velocity(P)").answers[0].exact == ("-1/2", "1")


UNWEIGHED = """sphere A: mass 1, velocity i
sphere B: mass 1, at rest
sphere C: velocity i
A hits B: along i, e = 1
show energy(C) > """


def test_a_claim_on_a_mass_that_is_not_told() -> None:
    assert answer(UNWEIGHED + "0").holds
    error = answer(UNWEIGHED + "1").error
    assert isinstance(error, MissingError)
    assert "the mass of C" in str(error)


@pytest.mark.parametrize("line", ["e = 1", "along i, e = 1"])
def test_one_does_not_catch_the_other(line: str) -> None:
    error = answer(f"""sphere A: mass 1, at (0, 0), velocity 2i
sphere B: mass 1, at (5, 0), velocity 3i
A hits B: {line}
find velocity(B)""").error
    assert isinstance(error, ImpossibleError)
    assert "separating" in str(error)


@pytest.mark.parametrize("offset", ["2", "3"])
def test_an_offset_of_two_radii_is_a_miss(offset: str) -> None:
    error = answer(f"""sphere A: mass 1, velocity 2i, radius 1
sphere B: mass 1, at rest
A hits B: offset {offset}, e = 1
find velocity(B)""").error
    assert isinstance(error, ImpossibleError)
    assert "less than 2r" in str(error)


def test_a_counterexample_tells_what_matters() -> None:
    text = """sphere A: mass m, velocity u i
sphere B: mass k*m, at rest
A hits B: along i, e = e
show energy_lost > energy(0)/2"""
    # (1 - e**2) k/(1 + k) > 1/2
    assert set(answer(text).counterexample or ()) == {"e", "k"}


def test_bounds_that_clash_are_named() -> None:
    error = answer("""sphere A: mass 1, velocity u i
sphere B: mass k, at rest
A hits B: along i, e = 1
given u > 1
given k > 2
given k < 1
find velocity(A)""").error
    assert isinstance(error, ContradictionError)
    assert "'k > 2' (line 5) and 'k < 1' (line 6) cannot both be" in str(error)


# --- the side on which a sphere is struck ---------------------------------------------------------

SIDE = """sphere A: mass 1, at (10, 0), velocity p i + q j, radius 1
sphere B: mass 1, at {at}, at rest, radius 1
A hits B: along i, e = 1
"""


@pytest.mark.parametrize(
    ("at", "facts", "expected"),
    [
        # 10 + 2p is 2 where B is on the left, and 18 where it is on the right.
        ("(0, 0)", "time(1) = 2", -4),
        ("(20, 0)", "time(1) = 2", 4),
        ("(0, 0)", "velocity(B) = -4i, time(1) = 2", -4),
        ("(0, 0)", "speed(B) = 4, time(1) = 2", -4),
    ],
)
def test_a_velocity_to_be_found_may_point_either_way(at: str, facts: str, expected: int) -> None:
    item = answer(SIDE.format(at=at) + f"given {facts}\nfind p, q")
    assert [each.exact for each in item.answers] == [str(expected)]


def test_a_letter_on_which_the_side_depends_keeps_it() -> None:
    """Towards the left, p is negative, and the centres come to 2 apart after 8/(−p)."""
    item = answer(SIDE.format(at="(0, 0)") + "given q = 0\nfind time(1)")
    assert [each.exact for each in item.answers] == ["-8/p"]


def test_a_place_is_found_on_either_side() -> None:
    item = answer(SIDE.format(at="(c, 0)") + "given q = 0, time(1) = 2, p = -3\nfind c")
    assert [each.exact for each in item.answers] == ["2"]


def test_a_place_of_two_letters_is_found_from_a_velocity_afterwards() -> None:
    text = """sphere A: mass 1, at (0, 0), velocity 2i, radius 1
sphere B: mass 1, at rest, at (p, q), radius 1
A hits B: e = 1
given velocity(A) = i + j, time(1) = 2
find p, q"""
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    assert [item.answers[0].exact for item in part.items] == ["sqrt(2) + 4", "-sqrt(2)"]


def test_a_claim_that_holds_for_positive_components_is_said_to():
    """tan of the angle to the wall is ev/|u|: v/(2u) for e = 1/2 where u and v are positive."""
    text = "wall W: along i\nsphere P: velocity u i - v j\nP hits W: e = 1/2\nshow {}\n"
    claim = "tan(angle(velocity(P), W)) = v/(2u)"
    solution = restitution.solve(restitution.parse(text.format(claim)))
    ((_, result),) = solution.items()
    assert result.holds is False
    (note,) = [each for each in solution.warnings if "holds for" in each]
    assert "u > 0, v > 0" in note
    given = text.format(claim).replace("show", "given u > 0, v > 0\nshow")
    ((_, result),) = restitution.solve(restitution.parse(given)).items()
    assert result.holds is True
    # False for all signs: nothing is said of them.
    solution = restitution.solve(restitution.parse(text.format("speed(P) > 2v")))
    assert not any("holds for" in each for each in solution.warnings)


def test_a_speed_is_never_zero_in_what_refutes():
    """The letters of speeds, masses and lengths have values of their kind in a counter-example."""
    text = """sphere A: mass m, velocity u at 30°
sphere B: mass M, velocity -v i
A hits B: along i
show speed(A) < u
show energy_lost > 0
show speed(B) > v
"""
    for step, result in restitution.solve(restitution.parse(text)).items():
        assert result.holds is False, step
        values = {name: sympy.sympify(each) for name, each in result.counterexample.items()}
        assert all(values[name] > 0 for name in values.keys() & set("muvM"))
        assert all(0 <= values[name] <= 1 for name in values.keys() & {"e"})


def test_what_stands_in_the_way_is_blamed():
    """To T it takes u > 0, and then W is met first: no demand alone is impossible, two are."""
    text = """wall W: along j, through (10, 0)
wall T: from (1000, -1) to (1000, 1)
sphere P: velocity (u, v), at (0, 0)
P hits T
find time(1)
"""
    ((_, result),) = restitution.solve(restitution.parse(text)).items()
    assert "P strikes W first" in str(result.error)


BELOW = ("(u/2, -sqrt(3)*u/4)", "2*sqrt(3)*a/(3*u)")
EAST = ("(sqrt(3)*u/4, -u/2)", "4*sqrt(3)*a/(3*u)")
WEST = ("(-sqrt(3)*u/4, -u/2)", "2*sqrt(3)*a/(3*u)")
# A wall, a place and what follows: half the component into the wall comes back, and the time is
# the distance over that component, √3 u/2.
SIDES = [
    ("along i, through (0, 2a)", "(-3a, a)", BELOW),
    ("along i, through (0, 2a)", "(b, a)", BELOW),
    ("along 0°, through (a, 2a)", "(b, a)", BELOW),
    ("from (-9a, 2a) to (9a, 2a)", "(-3a, a)", BELOW),
    ("along -j, through (-2a, a)", "(0, 0)", EAST),
    ("along -j, through (-2a, a)", "(-3a, a)", WEST),
]


@pytest.mark.parametrize(("wall", "place", "expected"), SIDES)
def test_a_sphere_comes_at_a_wall_from_where_it_is(
    wall: str, place: str, expected: tuple[str, str]
) -> None:
    text = f"""wall W: {wall}
sphere P: mass m, velocity u at 60° to W, at {place}
P hits W: e = 1/2
find velocity(P), time(1)"""
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    velocity, time = (str(item.answers[0].exact).replace("'", "") for item in part.items)
    assert (velocity, time) == expected


def test_it_comes_from_the_left_where_no_place_tells_the_side() -> None:
    text = """wall W: along i, through (0, b)
sphere P: velocity u at 60° to W, at (0, c)
P hits W: e = 1/2
find velocity(P)"""
    assert str(answer(text).answers[0].exact).replace("'", "") == "(u/2, sqrt(3)*u/4)"


def test_a_claim_of_what_has_no_value_is_not_shown() -> None:
    """The deflection is 90°, which surds hide: a tangent of it is neither less nor more."""
    setting = "wall W: along -i + 2j\nsphere P: mass m, velocity u at alpha\n"
    setting += "P hits W: e = 1/sqrt(3)\ngiven deflection(P) = 90°\n"
    for claim in ("tan(deflection(P)) <= 2/3", "1/cos(deflection(P)) > 1"):
        item = answer(f"{setting}show {claim}")
        assert item.holds is None
        assert "has no value" in str(item.error)


# After L at (0, 2/3) and t = 2/3, P moves with i + j: it comes to R, at x = 6, at t = 20/3.
@pytest.mark.parametrize(("time", "passed"), [("4", False), ("6", False), ("7", True)])
def test_a_place_beyond_a_wall_draws_a_warning(time: str, passed: bool) -> None:
    solution = restitution.solve(
        restitution.parse(
            f"""
wall L: along j, through (0, 0)
wall R: along j, through (6, 0)
sphere P: at (2, 0), velocity -3i + j
P hits L: e = 1/3
find position(P, at {time})
"""
        )
    )
    warned = [each for each in solution.warnings if "P comes to R before the time" in each]
    assert bool(warned) == passed


def test_what_is_at_rest_is_named_where_it_has_no_direction() -> None:
    text = """
sphere A: mass 2, velocity u at alpha
sphere B: mass 4, at rest
A hits B: along i, e = 1/4
find deflection(B)
"""
    assert "B is at rest before the impact, and a body at rest has no" in str(answer(text).error)


@pytest.mark.parametrize(
    ("between", "asked", "held"),
    [
        ("e = 0", "show A and B collide again", True),
        ("e = 1/4", "show A and B collide again", False),
        ("e = 0", "show k < 1", True),
    ],
)
def test_who_hits_a_wall_after_a_direct_impact_goes_away_from_whom_it_met(
    between: str, asked: str, held: bool
) -> None:
    # With k > 1 B comes back behind A, which would be at a wall on that side first.
    text = f"""
sphere A: mass m, velocity u i
sphere B: mass k m, velocity -u i
wall W: along j
A hits B: along i, {between}
B hits W: e = 1/2
{asked}
"""
    assert answer(text).holds is held


def test_what_happens_earlier_than_what_is_told_above_draws_a_warning() -> None:
    text = """
point N: (4, 3)
wall W: along i, through (0, -2)
sphere A: mass 1, at (-3, 0), velocity 6i
sphere B: mass 1, at (0, 0), at rest
A hits B: along 4i + 3j, e = 1/2
{first}
{second}
find velocity(A)
"""
    late, early = "B reaches N", "A hits W: e = 1/2"
    warnings = restitution.solve(restitution.parse(text.format(first=late, second=early))).warnings
    assert any("A hits W at the time 77/54 = 1.43, before B reaches N" in w for w in warnings)
    ordered = restitution.solve(restitution.parse(text.format(first=early, second=late)))
    assert not any("order of time" in each for each in ordered.warnings)


@pytest.mark.parametrize(
    ("wall", "fact", "position"),
    [
        ("along j", "", "the place of the wall OY"),
        ("along j, through (0, 0)", "", "the letters decide whether P has its event 1 before"),
        # At a/u, after a/c, P has gone for a/u - a/c with c/2 away from the wall.
        ("along j, through (0, 0)", "given time(1) < a/u", "Vector(x=a*(c - u)/(2*u), y=a + b)"),
    ],
)
def test_a_time_is_before_an_event_or_after_it(wall: str, fact: str, position: str) -> None:
    item = answer(f"""
        wall OY: {wall}
        sphere P: at (a, b), velocity -c i + u j
        P hits OY: e = 1/2
        {fact}
        find position(P, at a/u)
        """)
    if item.answers:
        assert str(item.answers[0].value) == position
    else:
        assert position in str(item.error)
