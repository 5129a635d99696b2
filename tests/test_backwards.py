"""Stories whose facts stand at the end: a direction is sought by which a body reaches a point.

The answers are put into a motion of plain floats, which knows discs and cushions and no equation.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import pytest
import sympy as sp

from restitution.language import parse
from restitution.oracle.roles import POSITIVE, REAL
from restitution.solving import Solution, solve
from restitution.solving.equations.stages import fixed_besides, solve_in_stages
from restitution.workings import explain, to_text

Pair = tuple[float, float]


def _first_touch(place: Pair, velocity: Pair, other: Pair, reach: float) -> float | None:
    """When a centre first is ``reach`` from a resting one; None where it passes."""
    gx, gy = other[0] - place[0], other[1] - place[1]
    ahead = gx * velocity[0] + gy * velocity[1]
    vv = velocity[0] ** 2 + velocity[1] ** 2
    under = ahead**2 - vv * (gx * gx + gy * gy - reach * reach)
    if under < 0 or ahead <= 0:
        return None
    return float((ahead - math.sqrt(under)) / vv)


def _struck(place: Pair, velocity: Pair, discs: Sequence[Pair], r: float) -> tuple[Pair, Pair]:
    """Where the last of some discs is, and its direction, after each struck the next one."""
    for number, other in enumerate(discs):
        time = _first_touch(place, velocity, other, 2 * r)
        assert time is not None, f"disc {number} is missed"
        for later in discs[number + 1 :]:
            before = _first_touch(place, velocity, later, 2 * r)
            assert before is None or before > time, "another disc is struck first"
        x, y = place[0] + velocity[0] * time, place[1] + velocity[1] * time
        place, velocity = other, (other[0] - x, other[1] - y)
    return place, velocity


def _passes(place: Pair, velocity: Pair, point: Pair) -> bool:
    """Whether a body comes to a point ahead of it."""
    gx, gy = point[0] - place[0], point[1] - place[1]
    off = (gx * velocity[1] - gy * velocity[0]) / math.hypot(*velocity)
    return abs(off) < 1e-9 * math.hypot(gx, gy) and gx * velocity[0] + gy * velocity[1] > 0


def _angles(solution: Solution) -> list[float]:
    (item,) = (item for _, item in solution.items())
    assert item.error is None, item.error
    return [float(answer.value) for answer in item.answers]


@pytest.mark.parametrize(
    ("discs", "pocket", "radius"),
    [
        ([(0, 0), (4, 4)], (10, 12), 1),
        ([(0, 0), (4, 4)], (9, 12), 1),
        ([(8, 14), (40, 30), (66, 53)], (75, 65), 5),
        ([(0, 0), (4, 3), (6, 9)], (9, 14), 1),
        ([(0, 0), (5, 4), (6, 11)], (11, 16), 1),
    ],
)
def test_the_last_disc_reaches_the_pocket(discs: list[Pair], pocket: Pair, radius: int) -> None:
    names = "ABC"[: len(discs)]
    lines = [f"sphere A: mass 1, at {discs[0]}, velocity 5 at alpha, radius {radius}"]
    lines += [
        f"sphere {name}: mass 2, at {at}, at rest"
        for name, at in zip(names[1:], discs[1:], strict=True)
    ]
    lines += [f"{one} hits {other}: e = 1/2" for one, other in itertools.pairwise(names)]
    lines += [f"{names[-1]} reaches {pocket}", "find alpha"]
    solution = solve(parse("\n".join(lines)))
    (alpha,) = _angles(solution)
    place, velocity = _struck(discs[0], (math.cos(alpha), math.sin(alpha)), discs[1:], radius)
    assert _passes(place, velocity, pocket)
    text = to_text(explain(solution))
    assert "α = " in text or "α ≈ " in text


def test_a_cushion_a_disc_and_a_pocket() -> None:
    solution = solve(
        parse(
            "wall W: along i, through (0, -3)\n"
            "sphere A: mass 1, at (-8, 0), velocity u at -alpha, radius 1\n"
            "sphere B: mass 1, at (3, 4), at rest\n"
            "A hits W: e = 1/2\nA hits B: e = 1/2\nB reaches (9, 8)\nfind alpha"
        )
    )
    (alpha,) = _angles(solution)
    u, v = math.cos(alpha), -math.sin(alpha)
    place, velocity = _struck((-8 + u * 2 / -v, -2), (u, -v / 2), [(3, 4)], 1)
    assert _passes(place, velocity, (9, 8))


def _beside_the_start(alpha: float, e: float, start: float, radius: float) -> tuple[float, float]:
    """How far beside its start, and how far towards it, a body goes after two cushions."""
    x, y, u, v = start, 0.0, math.cos(alpha), math.sin(alpha)
    for _ in range(2):
        out, speed = x * u + y * v, u * u + v * v
        time = (-out + math.sqrt(out**2 - speed * (x * x + y * y - radius**2))) / speed
        x, y = x + u * time, y + v * time
        push = (1 + e) * (u * x + v * y) / radius**2
        u, v = u - push * x, v - push * y
    size = math.hypot(u, v)
    return ((start - x) * v + y * u) / size, ((start - x) * u - y * v) / size


@pytest.mark.parametrize(("e", "start", "radius"), [("1", -3, 7), ("1/2", -3, 7), ("1", -5, 9)])
def test_back_to_the_start_by_two_cushions_of_a_circle(e: str, start: int, radius: int) -> None:
    solution = solve(
        parse(
            f"wall W: circle centre (0, 0) radius {radius}\n"
            f"sphere P: at ({start}, 0), velocity 5 at alpha\n"
            f"P hits W: e = {e}\nP hits W: e = {e}\nP reaches ({start}, 0)\nfind alpha"
        )
    )
    number = float(sp.Rational(e))
    steps = [math.pi / 2 * n / 4000 for n in range(1, 4000)]
    passing = [_beside_the_start(alpha, number, start, radius) for alpha in steps]
    wanted = [
        (a + b) / 2
        for a, b, (one, ahead), (other, _) in zip(
            steps, steps[1:], passing, passing[1:], strict=False
        )
        if one * other < 0 and ahead > 0
    ]
    found = sorted(_angles(solution))
    assert len(found) == len(wanted)
    for alpha, near in zip(found, wanted, strict=True):
        assert alpha == pytest.approx(near, abs=1e-3)
        beside, ahead = _beside_the_start(alpha, number, start, radius)
        assert abs(beside) < 1e-9
        assert ahead > 0


def test_what_cannot_be_reached_has_its_reason() -> None:
    solution = solve(
        parse(
            "sphere A: mass 1, at (0, 0), velocity u at alpha, radius 1\n"
            "sphere B: mass 1, at (4, 4), at rest\n"
            "A hits B: e = 1/2\nB reaches (-10, 4)\nfind alpha"
        )
    )
    (item,) = (item for _, item in solution.items())
    assert item.error is not None
    assert "moves away" in item.error.message


def test_places_are_given_from_the_end_where_roots_nest() -> None:
    solution = solve(
        parse(
            "sphere A: mass 1, at (0, 0), velocity 5 at alpha, radius 1\n"
            "sphere B: mass 1, at (4, 3), at rest\nsphere C: mass 2, at (6, 9), at rest\n"
            "A hits B: e = 1/2\nB hits C: e = 1/2\nC reaches (9, 14)\nfind alpha"
        )
    )
    lines = " ".join(to_text(explain(solution)).split())
    assert "C is at rest when B strikes it" in lines
    assert "so B has to be at (4.97, 7.29) then" in lines
    assert lines.index("so B has to be") < lines.index("so A has to be at (3.56, 1.05)")


def test_the_fewest_equations_come_first() -> None:
    cx, cy, x = (sp.Symbol(name, real=True) for name in ("_c_2x", "_c_2y", "x"))
    roles = {"_c_2x": REAL, "_c_2y": REAL, "x": POSITIVE}
    equations = [x * cx - cy, cx**2 + cy**2 - 25, 3 * cy - 4 * cx]
    found = solve_in_stages(equations, [cx, cy, x], frozenset(), frozenset(), roles)
    assert {(one.values["_c_2x"], one.values["_c_2y"]) for one in found} == {(3, 4), (-3, -4)}
    assert {one.values["x"] for one in found} == {sp.Rational(4, 3)}


def test_a_letter_is_fixed_where_equations_outnumber_unknowns() -> None:
    cx, cy, x, y = (sp.Symbol(name, real=True) for name in ("_c_2x", "_c_2y", "x", "y"))
    equations = [x * cx - cy, cx**2 + cy**2 - 25, 3 * cy - 4 * cx]
    assert fixed_besides(equations, [cx, cy]) == {"x"}
    assert fixed_besides(equations, [cx, cy, x]) == frozenset()
    assert fixed_besides([*equations, x * y - 1], [cx, cy]) == {"x", "y"}
    assert fixed_besides([x - 1, x - 2], [x]) == frozenset()
