"""Data that imply a coefficient outside [0, 1]: a warning, and no value for what rests on it."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.language import parse
from restitution.solving import Solution, solve
from restitution.workings import explain, to_text


def solved(text: str) -> Solution:
    return solve(parse(text))


def refused(solution: Solution, item: str) -> str:
    error = solution[item].error
    assert error is not None, solution[item].answers
    assert error.kind == "impossible"
    return error.message


CORNER = """wall AB: along i
wall BC: along j
sphere P: mass 2, velocity 3i - 4j
P hits AB
given speed(P, 1) = 15
P hits BC
find e, velocity(P), speed(P), impulse, impulse(1), speed(P, 1), velocity(P, 1), speed(P, 0)
find along(velocity(P), j), along(velocity(P), i)
show speed(P) > 1
show speed(P, 1) > 1
show velocity(P) perpendicular to j
"""


def test_in_a_corner() -> None:
    """9 + 16e² = 225 gives e = 3√6/2: what needs it again, at the second wall, has no value."""
    solution = solved(CORNER)
    assert solution.warnings == (
        "the data imply e = 3√6/2 = 3.67, and a coefficient of restitution lies in [0, 1]",
    )
    for item in ("e", "velocity(P)", "speed(P)", "impulse", "along(velocity(P), i)"):
        assert refused(solution, item).startswith("e = 3√6/2 = 3.67 rejected")
    # what the given speed and the principles without it tell
    assert solution["speed(P, 1)"].exact == 15
    assert solution["velocity(P, 1)"].exact == (3, 6 * sp.sqrt(6))
    assert sp.expand(solution["impulse(1)"].exact) == 8 + 12 * sp.sqrt(6)
    assert solution["along(velocity(P), j)"].exact == 6 * sp.sqrt(6)
    assert solution["speed(P, 0)"].exact == 5
    assert refused(solution, "speed(P) > 1")
    assert solution["speed(P, 1) > 1"].holds is True


def test_given_outright() -> None:
    solution = solved(
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 2\n"
        "find speed(P), speed(P, 0), along(velocity(P), W), tan(deflection(P))"
    )
    assert refused(solution, "speed(P)") == "e = 2: a coefficient of restitution lies in [0, 1]"
    (warning,) = solution.warnings
    assert warning.startswith("the statement gives e = 2, and a coefficient")
    assert refused(solution, "tan(deflection(P))")
    assert solution["speed(P, 0)"].exact == 5
    assert solution["along(velocity(P), W)"].exact == 3


def test_of_several_only_the_impossible_one_is_named() -> None:
    """4e = 2 at the first wall; at the second 3f = 6."""
    solution = solved(
        "wall AB: along i\nwall BC: along j\nsphere P: velocity 3i - 4j\nP hits AB\n"
        "P hits BC: e = f\ngiven velocity(P) = -6i + 2j\nfind e, f, speed(P, 1), speed(P)"
    )
    assert solution.warnings == (
        "the data imply f = 2, and a coefficient of restitution lies in [0, 1]",
    )
    assert solution["e"].exact == sp.Rational(1, 2)
    assert refused(solution, "f").startswith("f = 2 rejected")
    assert solution["speed(P, 1)"].exact == sp.sqrt(13)
    assert solution["speed(P)"].exact == 2 * sp.sqrt(10)


@pytest.mark.parametrize("item", ["speed(A)", "speed(B)", "energy_lost", "impulse"])
def test_in_letters(item: str) -> None:
    """e = k/2 with k = 3 is impossible, whichever letter it is made of."""
    text = (
        "sphere A: mass 1, velocity 4i\nsphere B: mass 2, at rest\nA hits B: along i, e = k/2\n"
        f"given k = 3\nfind {item}"
    )
    assert refused(solved(text), item).startswith("e = 3/2 rejected")


def test_what_does_not_rest_on_an_impossible_coefficient_earns_its_marks() -> None:
    text = (
        "sphere A: mass 1, velocity 3i + j\nsphere B: mass 2, at rest\nA hits B: along i\n"
        "given {}\nfind e, across(velocity(A), i), speed(A)"
    )
    shown = " ".join(to_text(explain(solve(parse(text.format("2e = 5/2"))))).split())
    assert "component of 𝐯_A along 𝐣 = 1 m s⁻¹ B1" in shown


def test_a_coefficient_in_letters_is_worked_out() -> None:
    """v = −3u/2 and w = 2u/k."""
    text = (
        "sphere A: mass m, velocity u at 60°\nsphere B: mass k m, at rest\n"
        "A hits B: along i\ngiven velocity(A) perpendicular to velocity(A, 0)\n"
        "find e in terms of k"
    )
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "2u/k + 3u/2 = eu cos 60°" in shown
    assert (
        "e = (4 + 3k)/k > 1 is impossible, as a coefficient of restitution is at most 1." in shown
    )
    assert "So no value of e is possible: what is given cannot occur." in shown


def test_an_impulse_square_to_the_approach_is_a_clash() -> None:
    """Along the change of velocity −2i + 2j the spheres would not come nearer to each other."""
    solution = solve(
        parse(
            "sphere A: mass 1, velocity 4i + j\nsphere B: mass 2, velocity i - 2j\nA hits B\n"
            "given velocity(A) = 2i + 3j\nfind velocity(B), e\n"
        )
    )
    (part,) = solution.parts.values()
    assert {type(item.error).__name__ for item in part.items} == {"ContradictionError"}
