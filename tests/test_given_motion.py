"""Facts of directions: what is at rest has none, so both of which they speak do move."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.errors import ContradictionError
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass {masses[0]}, velocity {u}
sphere B: mass {masses[1]}, velocity {v}
A hits B: along i{e}
given velocity(A) {relation} velocity(B)
"""


def after(m: float, n: float, u: float, v: float, e: float) -> tuple[float, float]:
    """The components along the line of centres after an impact, of both spheres."""
    common = (m * u + n * v) / (m + n)
    return common - e * n * (u - v) / (m + n), common + e * m * (u - v) / (m + n)


PERPENDICULAR = [
    # A speed, a coefficient and a ratio of masses; 2, 2 and 4/5 would leave a sphere at rest.
    ("u", ("1", "1"), "u at 60°", "-3i", "1/2", "18", "2"),
    ("k", ("m", "k m"), "3i + 2j", "-2i", "1/5", "1", "2"),
    ("k", ("m", "k m"), "4i", "-2i + 3j", "1/2", "7/2", "4/5"),
]


@pytest.mark.parametrize(("name", "masses", "u", "v", "e", "answer", "other"), PERPENDICULAR)
def test_a_sphere_at_rest_is_perpendicular_to_nothing(
    name: str, masses: tuple[str, str], u: str, v: str, e: str, answer: str, other: str
) -> None:
    """Of two roots the one with a sphere at rest is rejected with that reason."""
    text = SPHERES.format(masses=masses, u=u, v=v, e=f", e = {e}", relation="perpendicular to")
    item = solve(parse(text + f"find {name}"))[name]
    assert [found.exact for found in item.distinct] == [answer]
    (refused,) = item.rejected
    assert refused.exact == other
    assert "would be at rest, and nothing is perpendicular to a body at rest" in refused.reason
    sideways, straight = (1, 0) if "j" in v else (0, 1)
    for value, zero, moves in ((answer, sideways, straight), (other, straight, sideways)):
        number = float(sp.Rational(value))
        before = (number / 2 if name == "u" else float(u[0]), float(v[:2]))
        ends = after(1, number if name == "k" else 1, *before, float(sp.Rational(e)))
        assert ends[zero] == pytest.approx(0)
        assert ends[moves] != pytest.approx(0)


def test_the_steps_are_written_where_one_root_is_left() -> None:
    text = SPHERES.format(
        masses=("m", "m"), u="u at alpha", v="-v i", e="", relation="perpendicular to"
    )
    shown = " ".join(
        to_text(explain(solve(parse(text + "given e < 1\nfind u/v")), check=True)).split()
    )
    assert "u/v = (1 + e)/((1 − e) cos α)" in shown
    assert "As B is still moving at the end, this holds for 0 < e < 1 only." in shown
    assert "not written out" not in shown


@pytest.mark.parametrize(
    ("relation", "masses", "u", "asked", "e"),
    [
        ("perpendicular to", ("2", "3"), "3i + 2j", "e", ""),
        ("parallel to", ("m", "k m"), "3i + 2j", "k", ", e = 1/5"),
    ],
)
def test_nothing_is_left(
    relation: str, masses: tuple[str, str], u: str, asked: str, e: str
) -> None:
    """B would be at rest: w = 2e = 0 in one, and w = (1/5)(…)/(1 + k) = 0 in the other."""
    text = SPHERES.format(masses=masses, u=u, v="-2i", e=e, relation=relation)
    with pytest.raises(ContradictionError, match="B would be at rest, and nothing is"):
        _ = solve(parse(text + f"find {asked}"))[asked].exact


def test_a_claim_need_not_hold_where_a_given_direction_is_that_of_a_rest() -> None:
    """With e = 3 − 2√2 and α = 45°, u = v leaves B at rest; for all others the claim holds."""
    text = SPHERES.format(
        masses=("m", "m"), u="u at alpha", v="-v i", e=", e = e", relation="perpendicular to"
    )
    claim = "u/v = (1 + e)/(1 - e) * sec(alpha)"
    assert solve(parse(text + f"show {claim}"))[claim].holds is True


def test_a_sphere_that_may_stop() -> None:
    """A moves along i with (4 − 4k/3)/(1 + k): not for k = 3."""
    text = """
sphere A: mass 1, velocity 4i
sphere B: mass k, at rest
A hits B: along i, e = 1/3
given velocity(A) parallel to velocity(B)
find range of k
"""
    assert after(1, 3, 4, 0, 1 / 3)[0] == pytest.approx(0)
    item = solve(parse(text))["range of k"]
    assert item.exact == sp.Union(sp.Interval.open(0, 3), sp.Interval.open(3, sp.oo))
