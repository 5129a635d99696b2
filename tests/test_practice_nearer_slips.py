"""Slips that are nearer than a misconception, and names that the lines beside a mistake decide."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

DIRECT = """sphere A: mass m, velocity u i
sphere B: mass 3m, at rest
A hits B: along i, e = 3/5
find velocity(A), velocity(B)"""
OBLIQUE = """sphere A: mass 3, velocity 10 at 60°
sphere B: mass 2, velocity 4 at 120°
A hits B: along i, e = 1/3
find speed(A), speed(B)"""
ALONG = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}


def names(statement: str, *lines: str, **letters: str) -> list[str | None]:
    """The name of the mistake in each line, None where there is none."""
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=letters).json()
    return [(line["mistake"] or {}).get("id") for line in marking["lines"]]


def marks(statement: str, *lines: str, part: str | None = None, **letters: str) -> list[str]:
    """The states of the points of a script."""
    marking = restitution.mark(
        solution_of(statement), "\n".join(lines), part=part, letters=letters
    ).json()
    return [point["state"] for point in marking["marks"]["points"]]


@pytest.mark.parametrize(
    "lines",
    [
        ("u = v + 3w", "w = v + 0.6u", "v = -0.2u", "w = 0.2u + 0.6u = 0.8u"),
        ("u = v + 3w", "w - v = 3u/5", "w = 0.4u", "v = 0.6u - 0.4u = 0.2u"),
    ],
)
def test_a_sign_in_a_value_below_its_law_is_a_slip(lines: tuple[str, ...]) -> None:
    assert names(DIRECT, *lines, **ALONG)[-1] in ("sign", "arithmetic", "algebra")


def test_whole_speeds_in_one_law_are_that_laws_alone() -> None:
    law = "w - v = 1/3 × (10 + 4) = 14/3"
    beside = names(OBLIQUE, "3 × 10cos60 - 2 × 4cos60 = 3v + 2w", law, **ALONG)
    assert beside == [None, "restitution-whole-speed"]
    both = names(OBLIQUE, "30 - 8 = 3v + 2w", law, **ALONG)
    assert both == ["speed-for-component", "speed-for-component"]


GIVEN = """sphere A: mass 2, velocity 6i + 4j
sphere B: mass 4, at rest
A hits B
given impulse(A) = -4i - 2j
find velocity(B)"""


def test_a_given_impulse_as_a_column_has_its_sign_lost() -> None:
    lines = ("(-4, -2) = 4v", "v = (-1, -0.5)")
    assert names(GIVEN, *lines, v="velocity(B)")[0] == "sign"
    assert marks(GIVEN, *lines, v="velocity(B)")[0] == "earned"


SEEN = """sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity i - 2j
A hits B: along j
given velocity(A) = 3i
find energy_lost/energy(0) as a percentage"""


def test_energies_of_one_sphere_or_without_its_mass() -> None:
    assert names(SEEN, "A loses 25 - 9 = 16", "percentage lost = 16/25 = 64%")[1] == (
        "energy-one-sphere"
    )
    assert names(SEEN, "KE before = 25 + 1/2(5) = 27.5")[0] == "mass-omitted"


def test_numbers_of_true_lines_put_together_wrongly_are_no_misconception() -> None:
    statement = """sphere A: mass 2, velocity 4i + 2j
sphere B: mass 1, velocity -2i + 3j
wall W: along j
A hits B: along i, e = 1/2
B hits W: e = 3/4
find total_energy_lost"""
    lines = ("A loses 20 - 5 = 15", "B gains 9 - 6.5 = 2.5", "total KE lost = 15 + 2.5 = 17.5")
    assert names(statement, *lines)[2] in (None, "sign", "arithmetic")


def test_a_product_of_surds_worked_out_wrongly_is_gone_on_with() -> None:
    statement = """sphere A: mass 2, velocity 8 at 60°
sphere B: mass 3, at rest
A hits B: along i, e = 1/2
find speed(A), speed(B)"""
    lines = ("8cos60 = 4√3", "2 × 4√3 = 2v + 3w", "w - v = 2√3", "w = 12√3/5", "v = 2√3/5")
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=ALONG).json()
    found = [line["verdict"] for line in marking["lines"]]
    assert found == ["false", "follows", "follows", "follows", "follows"]
    assert [point["state"] for point in marking["marks"]["points"]][4] == "lost"


LOST = """sphere A: mass 2, velocity -i + 5j
sphere B: mass 3, velocity 2i
A hits B: along j
given energy_lost = 14.4
find e"""
UP = {"v": "along(velocity(A), j)", "w": "along(velocity(B), j)"}


@pytest.mark.parametrize(
    "lines",
    [
        ("15 = 3v + 2w", "w - v = 5e", "v = 3 - 2e, w = 3 + 3e",
         "25 - (3 - 2e)² - 3/2(3 + 3e)² = 14.4"),
        ("v = 2 - 3e", "14.4 = 25 - (2 - 3e)²", "(2 - 3e)² = 10.6", "2 - 3e = -3.256"),
    ],
)  # fmt: skip
def test_what_follows_from_values_in_letters_and_by_a_root(lines: tuple[str, ...]) -> None:
    marking = restitution.mark(solution_of(LOST), "\n".join(lines), letters=UP).json()
    assert marking["lines"][-1]["verdict"] == "follows"


def test_a_scalar_product_of_one_is_gone_on_with() -> None:
    statement = "sphere P: mass 2, velocity 8i - 5j\nwall W: along i\nwall V: along j\n"
    statement += "P hits W: e = 3/5\nP hits V: e = 1/4\nfind angle(velocity(P, 0), velocity(P))"
    lines = ("(8i - 5j).(-2i + 3j) = 16 - 15 = 1", "cosθ = 1/(√89 √13) = 0.0294")
    meant = {"θ": "angle(velocity(P, 0), velocity(P, 2))"}
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=meant).json()
    assert [line["verdict"] for line in marking["lines"]] == ["false", "follows"]


TURNED = """sphere A: mass m, velocity 3u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/3
part a
show velocity(A) = (3 - k)u/(1 + k) i
part b
given k = 5
find impulse"""


def test_a_condition_is_used_in_the_component_of_either_sphere() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)", "I": "impulse"}
    for line in ("v = -u/3", "w = 2u/3"):
        assert marks(TURNED, line, "I = 8mu/3", part="b", **letters)[0] == "earned"


def test_the_angle_of_a_line_of_centres_is_worth_its_direction() -> None:
    statement = """sphere A: mass 2m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset 8/5 r, e = 1/4
find speed(B)"""
    letters = {
        "v": "along(velocity(A), line_of_centres)",
        "w": "along(velocity(B), line_of_centres)",
    }
    letters["θ"] = "angle(velocity(A, 0), line_of_centres)"
    assert marks(statement, "sinθ = 4/5", "2mu = 2mv + mw", **letters)[:2] == ["earned"] * 2


def test_a_percentage_may_count_hundredths_in_a_chain() -> None:
    statement = "wall W: along i\nsphere P: mass m, velocity 10 at 50° to W\nP hits W: e = 0.4\n"
    statement += "part a\nfind speed(P)\npart b\nfind energy_lost/energy(0) as a percentage"
    line = "% lost = (1 - v²/100) × 100 = 100 - 50.7 = 49.3"
    assert marks(statement, line, part="b", v="speed(P)") == ["earned", "earned"]


def test_words_that_reject_a_value_may_begin_with_which() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 4i - 3j\nP hits W: e = 1/2\n"
    statement += "find angle(velocity(P), W)"
    lines = ("cosβ = 1.147 which is impossible", "cosβ = 1.147, not possible", "tanβ = 3/8")
    assert verdicts(statement, *lines) == ["remark", "remark", "true"]


FOUND = """sphere A: mass 2, velocity 4i + 6j
sphere B: mass 3, velocity i - 2j
A hits B: along j
given velocity(B) = i + 2.8j
find velocity(A), e"""


def test_an_answer_by_another_law_follows_through() -> None:
    lines = ("12 + 6 = 2v + 8.4", "v = 4.8", "A: 4i + 4.8j", "2.8 - 4.8 = 8e", "e = -0.25")
    kinds = marks(FOUND, *lines, v="along(velocity(A), j)")
    assert kinds == ["earned", "earned", "lost", "lost", "earned", "earned", "earned"]


def test_the_laws_at_a_wrong_line_of_centres_follow_through() -> None:
    statement = """sphere A: mass 2m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
find speed(B)"""
    letters = {
        "v": "along(velocity(A), line_of_centres)",
        "w": "along(velocity(B), line_of_centres)",
    }
    letters["θ"] = "angle(velocity(A, 0), line_of_centres)"
    lines = ("tan θ = r/(2r), θ = 26.6°", "2ucos26.6 = 2v + w", "w - v = 1/2 ucos26.6")
    states = marks(statement, *lines, "w = 0.894u", **letters)
    assert states[0] == "lost" and states[3:8] == ["earned"] * 5


def test_decimals_may_have_commas() -> None:
    lines = ("u = v + 3w", "w - v = 0,6u", "4w = 1,6u so w = 0,4u", "v = -0,2u")
    assert verdicts(DIRECT, *lines) == ["true"] * 4
    speeds = ("v cosβ = 4, v sinβ = 3/2", "v = √(4² + 1,5²) = 4,27")
    statement = "wall W: along i\nsphere P: mass 2, velocity 4i - 3j\nP hits W: e = 1/2\n"
    assert verdicts(statement + "find speed(P)", *speeds)[1] == "true"
    columns = ("(-4, -2) = 2(v - (6,4))", "v = (4,3)")
    assert verdicts(GIVEN.replace("velocity(B)", "velocity(A)"), *columns)[1] == "true"


def test_a_wall_across_his_own_direction_follows() -> None:
    statement = """wall W
sphere P: mass 2, velocity 4i - 7j
P hits W
given velocity(P) = 7i - j
find impulse(P), direction(W)"""
    lines = ("I = 2(7i - j - 4i - 7j) = 6i - 16j", "normal 3i - 8j", "wall parallel to 8i + 3j")
    assert verdicts(statement, *lines) == ["false", "follows", "follows"]


def test_energies_in_letters_before_and_after_lead_to_what_is_lost() -> None:
    statement = """sphere A: mass m, velocity 3u i + 2u j
sphere B: mass 2m, velocity -u i + u j
A hits B: along i, e = 1/2
find energy_lost, energy_lost/energy(0)"""
    lines = ("before 17mu²/2", "after 1/2 m(5u²) + m(2u²) = 11mu²/2", "loss 3mu²")
    assert verdicts(statement, *lines) == ["true", "false", "follows"]
