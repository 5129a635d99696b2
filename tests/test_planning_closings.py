"""Equations that are closed by one more step: a square, a double root, an angle that falls out.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

import pytest
import sympy as sp
from workings import planned

from restitution.planning.closing.roots import in_sines, varies_with_angles
from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "a tangent of components of which one is 1": (
        """
wall W: along i
sphere P: mass 2, velocity i - 6j
P hits W: e = 1/2
find angle(velocity(P), W)
""",
        ("tan β = 3/1 = 3",),
    ),
    "the cosine whose square is one over a sum": (
        """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given energy_lost = 1/9 m u^2
find cos(alpha) in terms of e
""",
        ("cos²α = 1/(3(1 − e²))", "cos α = 1/√(3(1 − e²)), as α is acute"),
    ),
    "a ratio of which the equation has one root twice": (
        """
sphere A: mass p, velocity 2u i + u j
sphere B: mass q, velocity -u i + u j
A hits B: along i, e = 2/3
part a
given energy_lost = 1/7 energy(0)
find p/q
part b
given velocity(A) perpendicular to velocity(B)
find p/q
""",
        ("p/q = (14 + √186)/5", "9p² − 12qp + 4q² = 0", "p/q = ⅔"),
    ),
    "a coefficient of whose equation a letter is the square": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i
given energy(B) = f energy(A, 0)
find e in terms of f, alpha
""",
        ("e = (3√(2f) − 2 cos α)/(2 cos α)",),
    ),
    "a coefficient by the tangents of an angle and of its double": (
        """
sphere P: mass m, velocity u at 2theta to W
wall W
P hits W
given angle(velocity(P), W) = theta
find e in terms of theta
""",
        ("By the formulae for the double angle:", "e = (1 − tan²θ)/2"),
    ),
    "a square without a factor that is positive as the spheres approach": (
        """
sphere A: mass m, velocity u i + v j
sphere B: mass k m, at rest
A hits B: along i
given energy_lost = 0
find e
""",
        ("A and B approach each other before the impact:\n    e² = 1", "e = 1, as e ≥ 0"),
    ),
    "a component that stands in both equations as the law of restitution has it": (
        """
sphere P: mass m, velocity u at alpha to W
wall W
P hits W
given angle(velocity(P), W) = 30°, energy_lost = 1/3 energy(0)
find alpha, e
""",
        ("Substituting in (2):", "3 sin²α − cos²α = 1", "cos²α = ½", "α = 45°", "e = √3/3"),
    ),
    "an equation that holds of itself for one coefficient, which is left out": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity u at 180° - alpha
A hits B: along i
given speed(A) = speed(B)
find k
""",
        ("Dividing by e, which is not zero as e > 0:", "k = 1"),
    ),
    "a share of the energy that is lost, where any is": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy_lost = (1-e^2)/3 energy(A, 0)
find k
""",
        ("kmu²/(2(1 + k)) = mu²/6, as 0 ≤ e < 1", "k = ½"),
    ),
    "an angle that falls out": (
        """
sphere A: mass 2m, velocity 4u at alpha
sphere B: mass m, velocity v at alpha from -i
A hits B: along i, e = 1
given speed(A) = 4u
find v
show speed(B) = v
""",
        ("As sin²α + cos²α = 1:", "(v − 8u)(4u + v) = 0", "v = 8u", "speed of B = v"),
    ),
    "a coefficient by whole degrees without surds": (
        """
sphere A: mass 4, velocity 6 at 50°
sphere B: mass 3, at rest
A hits B: along i
given deflection(A) = 15°
find e, speed(A)
""",
        ("v = (6 sin 50°)/tan 65° ≈ 2.143", "e ≈ 0.0366", "≈ 5.07 m s⁻¹"),
    ),
    "a mass by whole degrees without surds": (
        """
sphere A: mass 0.4, velocity 3 at 25°
sphere B: mass M, at rest
A hits B: along i, e = 0.5
given direction(A) = 70°
find M, speed(B)
""",
        (
            "0.4 × 3 cos 25° ≈ 0.4 × 0.4615 + 1.821M",
            "M ≈ 0.496",
        ),
    ),
    "two speeds that are apart by a number": (
        """
sphere A: mass 2, velocity 4i + 4j
sphere B: mass 2, velocity -2i + 6j
A hits B: along i
given speed(B) - speed(A) = 2
find e
""",
        (
            "(1 + 3e)² + 6² = (1 − 3e)² + 4² + 4 + 4√((1 − 3e)² + 4²)",
            "√(17 − 6e + 9e²) = 4 + 3e",
            "17 − 6e + 9e² = (4 + 3e)²",
            "e = 1/30",
        ),
    ),
    "two speeds at a wall, of which a root is brought in by squares": (
        """
wall W: along i
sphere P: mass 2, velocity 5i - 6j
sphere Q: mass 2, velocity 3i - 8j
P hits W: e = e
Q hits W: e = e
given speed(P) = speed(Q) + 1
find e
""",
        ("2√(9 + 64e²) = 15 − 28e²   (1)", "does not satisfy (1)", "e ≈ 0.449, as e ≥ 0"),
    ),
    "a loss of energy with a square, and spheres that approach": (
        """
sphere A: mass 2, velocity 4i + j
sphere B: mass 3, velocity v i - 2j
A hits B: along i, e = 1/2
given energy_lost = 18
find v
""",
        (
            "= ½ × 2(16 − (16 + 72v + 81v²)/100) + ½ × 3(v² − 4(36 + 12v + v²)/25)",
            "(v − 4)² = 40",
            "as A and B approach each other before they collide",
        ),
    ),
    "an inequality that holds anyway": (
        """
sphere A: mass 2, velocity 5i + 3j
sphere B: mass 1, velocity -i + 4j
A hits B: along i, e = 1/2
given speed(B) > speed(A)
find velocity(A)
""",
        (
            "speed of B = √(5² + 4²) = √41",
            "speed of A = √(2² + 3²) = √13",
            "which agrees with this",
        ),
    ),
    "twice an angle of the data, after an impact": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given tan(alpha) = 1/2, angle(velocity(A), line_of_centres) = 2alpha
find e
""",
        ("tan 2α = 2 tan α/(1 − tan²α) = (2 × ½)/(1 − (1/2)²) = 4/3", "e = ¼"),
    ),
    "half of an angle of the data, at a wall": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given angle(velocity(P), W) = alpha/2, cos(alpha) = 3/5
find e
""",
        ("tan(α/2) = sin α/(1 + cos α) = (4/5)/(1 + ⅗) = ½", "½ = 4e/3", "e = ⅜"),
    ),
    "a speed along the line of centres, in either sense": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
find speed(A)
""",
        ("v = (2 − k)u/(2(1 + k))", "speed of A = |(2 − k)u/(2(1 + k))| = u|k − 2|/(2(1 + k))"),
    ),
    "half of an angle that has a tangent, by a deflection": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 3, deflection(P) = 3/2 alpha
find e
""",
        (
            "tan(α/2) = sin α/(1 + cos α) = (3√10/10)/(1 + √10/10)",
            "= (√10 − 1)/3",
            "tan(α/2) = eu sin α/(u cos α) = e tan α",
            "(√10 − 1)/3 = 3e",
        ),
    ),
    "a component of an impulse": (
        """
wall W: along 3i + 4j
sphere P: mass 2, velocity 5i
P hits W: e = 1/2
find along(impulse(P), 4i - 3j)
""",
        ("= (−(48/5)𝐢 + (36/5)𝐣)", "−(48/5) × ⅘ − (36/5) × ⅗ = −12"),
    ),
    "a letter for a ratio of tangents of angles that have letters": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1/4
let beta = angle(velocity(A), line_of_centres)
let k = tan(beta)/tan(alpha)
find k
""",
        ("tan β = u sin α/(⅙u cos α) = 6 tan α", "k = (6 tan α)/tan α = 6"),
    ),
    "speed, direction and an impulse at a wall": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given speed(P) = 5, angle(velocity(P), W) = 30°, impulse = 8 m
find u, alpha, e
""",
        ("u cos α = 5 cos 30°", "8m = m(5/2 + u sin α)", "tan α = 11√3/15", "u = 7", "e = 5/11"),
    ),
    "speed, direction and a share of energy at a wall": (
        """
wall W: along i
sphere P: mass 2, velocity u at alpha to W
P hits W
given speed(P) = 5, angle(velocity(P), W) = 35°, energy(P) = 0.6 energy(P, 0)
find u, alpha, e
""",
        ("5² = 0.6u²", "cos α = (√15/5) cos 35°", "e ≈ 0.575"),
    ),
    "a range of a loss, where a fact ties the coefficient": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) = 0
find range of energy_lost/energy(0)
""",
        ("e = 1/k", "fraction lost = ((k − 1) cos²α)/k", "k ≥ 1", "0 ≤ fraction lost < 1"),
    ),
    "the sum of two speeds, with an angle": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given speed(A) + speed(B) = 5/4 u
find alpha
""",
        ("speed of B = ¾u cos α", "√(1 + 15 sin²α) = 5 − 3 cos α", "cos α = ½ or cos α = ¾"),
    ),
    "a letter that has to go, by an equation between momenta": (
        """
sphere A: mass M, velocity u at alpha
sphere B: mass m, velocity v at beta from -i
A hits B: along i
given M u cos(alpha) = 2 m v cos(beta)
find impulse in terms of M, m, u, alpha, e
""",
        ("cos β = Mu cos α/(2mv)",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_one_more_step_closes_an_equation(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text


def test_a_discriminant_is_free_of_angles_by_pythagoras_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refused(*_: object) -> None:
        raise AssertionError

    monkeypatch.setattr(sp, "trigsimp", refused)
    a, b, k = sp.symbols("a b k", positive=True)
    free = (k * sp.sin(a)) ** 2 + k**2 * sp.cos(a) ** 2 - 3 * k + sp.cos(b) ** 2 + sp.sin(b) ** 2
    assert not varies_with_angles(free)
    assert sp.expand(in_sines(free) or 0) == k**2 - 3 * k + 1
    assert varies_with_angles(free + sp.cos(a) * sp.sin(b))
    assert varies_with_angles(k * sp.sin(a) ** 2 - sp.cos(a))
