"""Lines between: a line with roots or several letters is one step from the line above it."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

SPHERES = """
sphere A: mass {a}, velocity {u}
sphere B: mass {b}, {w}
A hits B: along i{e}
"""

CASES: dict[str, tuple[str, tuple[str, ...]]] = {
    "squares of sums in their order, in brackets where they are taken away": (
        SPHERES.format(a="m", b="m", u="u at alpha", w="at rest", e="") + "find energy_lost",
        ("= ⅛mu²(4 − (1 − 2e + e²) − (1 + 2e + e²)) cos²α",),
    ),
    "a sum that still cancels": (
        SPHERES.format(a="m", b="k m", u="u i", w="at rest", e="") + "find energy_lost",
        (
            "= mu²((1 + k)² − (1 − 2ek + e²k²) − k(1 + 2e + e²))/(2(1 + k)²)",
            "= k(1 + k)mu²(1 − e²)/(2(1 + k)²)",
        ),
    ),
    "each difference of two squares as a product": (
        SPHERES.format(a="m", b="m", u="u at alpha", w="velocity u at 90° - alpha from -i", e="")
        + "find energy_lost",
        (
            "= ½m(u cos α − v)(u cos α + v) − ½m(w + u sin α)(w − u sin α) (4)",
            "w + u sin α = (1 + e)u(cos α + sin α)/2",
            "= mu²(1 − e²)(cos α + sin α)²/4",
        ),
    ),
    "many terms before they are a product": (
        "wall W: along j"
        + SPHERES.format(a="m", b="m", u="u i", w="at rest", e="")
        + "B hits W\nfind total_energy_lost",
        ("= mu²(3 + 2e − 2e² − 2e³ − e⁴)/8 = mu²(1 − e²)(3 + 2e + e²)/8",),
    ),
    "both squares over one line, before a speed squared that is shown": (
        SPHERES.format(a="m", b="m", u="u at alpha", w="at rest", e=", e = 1/2")
        + "show speed(A)^2 = u^2 (1 + 15 sin^2(alpha))/16",
        ("= u²(cos²α + 16 sin²α)/16 = u²(1 + 15 sin²α)/16",),
    ),
    "a quadratic, before the range of its letter": (
        SPHERES.format(a="m", b="k m", u="u at alpha", w="at rest", e=", e = 1/2")
        + "given energy(B) = 9/32 energy(0)\nunknown alpha\nfind range of k",
        ("(1 + k)²/(8k) < 1, as α is acute k² − 6k + 1 < 0, as k > 0 3 − 2√2 < k < 3 + 2√2",),
    ),
    "squares of numbers with roots": (
        SPHERES.format(
            a="sqrt(3)",
            b="1",
            u="2i + sqrt(3) j",
            w="velocity -sqrt(3) i",
            e=", e = 1/sqrt(3)",
        )
        + "find velocity(A), energy_lost",
        (
            "v = (1/√3 − 1)/(1 + √3) = (1/√3 − 1)(√3 − 1)/((1 + √3)(√3 − 1)) = (3 − 2√3)/3",
            "= ½√3(4 − (7 − 4√3)/3) + ½(3 − 4) = (9 + 5√3)/6",
        ),
    ),
    "a root of roots that is the root of a square": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given deflection(P) = 60°
find tan(alpha), speed(P)
""",
        (
            "tan α = (−2 + √13)/√3 or tan α = (−2 − √13)/√3",
            "= √((14 + 2√13)u²/36) = √(((1 + √13)u/6)²) = (1 + √13)u/6",
        ),
    ),
    "an inequality with roots, its terms collected": (
        SPHERES.format(a="m", b="m", u="u at 45°", w="at rest", e="")
        + "given deflection(A) <= 30°\nfind range of e",
        ("(2 + √3)e ≤ √3", "e ≤ √3/(2 + √3)", "e ≤ 2√3 − 3"),
    ),
    "a square of one component, and a quotient of sums with roots": (
        SPHERES.format(a="5m", b="2m", u="4u at 60°", w="velocity 3u at 30° from -i", e="")
        + "given energy(B) = energy(B, 0)\nfind e",
        (
            "w² = 27u²/4 w = ±3√3 u/2",
            "27√3 − 20 = (20 + 15√3)e e = (27√3 − 20)/(20 + 15√3)",
            "= (27√3 − 20)(3√3 − 4)/((20 + 15√3)(3√3 − 4)) = (323 − 168√3)/55",
        ),
    ),
    "a deflection that an offset tells, and its greatest value": (
        """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
find maximum of deflection(A) over d
""",
        (
            "tan δ = (4 tan φ − tan φ)/(1 + 4 tan²φ)",
            "tan δ ≤ ¾",
            "so tan φ = ½, sin φ = √5/5 and d = 2√5 a/5",
        ),
    ),
    "bounds of a square, and what it is the square of": (
        """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
given deflection(A) >= 30°
find range of d
""",
        (
            "4a⁴ − 21a²d² + 9d⁴ ≤ 0",
            "(7 − √33)a²/6 ≤ d² ≤ (7 + √33)a²/6",
            "((√33 − 3)a/6)² ≤ d² ≤ ((3 + √33)a/6)²",
        ),
    ),
    "a component that is zero, and not what is the negative of it": (
        """
wall W: along theta
sphere P: mass 1, velocity 2 i
P hits W: e = 1/2
given velocity(P) parallel to j
find theta
""",
        ("tan θ = 2/tan θ",),
    ),
    "degrees by their tangent": (
        """
wall W: along j
sphere P: mass 0.5, velocity 4 at 40° to W
P hits W
given angle(velocity(P), W) = 26°
find e
""",
        ("e = (tan 26°)/tan 40°",),
    ),
    "a tangent that is shown in a letter for another": (
        """
let t = tan(alpha)
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/4
show tan(deflection(P)) = 5t/(4 - t^2)
""",
        (
            "tan δ = (tan α + tan β)/(1 − tan α tan β)",
            "= 5 tan α/(4 − tan²α) tan δ = 5t/(4 − t²) (as required)",
        ),
    ),
    "a ratio that is shown, with the tangent put in": (
        """
wall W: along j
sphere P: velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
show energy(P)/energy(P, 0) = (1 + tan^2(beta)) cos^2(alpha)
""",
        ("= cos²α + e² sin²α", "= (1 + tan²β) cos²α"),
    ),
    "a mass that cancels, and terms that stand on both sides": (
        """
sphere A: mass 2, velocity 3i + 2j
sphere B: mass m, velocity -3i - j
A hits B: along i
given impulse(B) = 9i, energy_lost = 27/4
find m, e
""",
        ("= (2m(9 − w²) + 27)/4 w² = 9",),
    ),
    "a law at a wall with the signs of both components": (
        """
wall W: along i - j
sphere P: velocity v at theta
P hits W: e = 1/3
given velocity(P) = 4i, 180° < theta < 270°
find v, theta
""",
        ("−2√2 = −⅓(−√2 v(cos θ + sin θ)/2)",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_line_is_one_step_from_the_line_above(name: str) -> None:
    statement, said = CASES[name]
    solution = solve(parse(statement))
    derivation = plan(solution)
    assert not follow(derivation, Oracle(roles(solution.problem)))
    text = " ".join(to_text(explanation_of(derivation, solution.problem), 160).split())
    for each in said:
        assert each in text, text


@pytest.mark.parametrize("angle", ["150°", "120°", "135°"])
def test_an_impulse_has_degrees_beside_an_angle_in_a_letter(angle: str) -> None:
    """Only cos 30° gets its value between, and cos α stays: nothing that is cited is put in."""
    statement = (
        f"sphere A: mass m, velocity u at alpha\nsphere B: mass k m, velocity u at {angle}\n"
        "A hits B: along i, e = 1/2\nfind impulse"
    )
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "follow" not in said
