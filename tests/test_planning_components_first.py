"""Components along the line of centres that are given by speeds, energies or angles come first."""

from __future__ import annotations

import pytest

from restitution import explain, parse, solve
from restitution.workings import to_text


def working(statement: str) -> str:
    explanation = explain(solve(parse(statement)), check=True)
    assert not explanation.warnings
    return " ".join(to_text(explanation, 100).split())


BOTH = """sphere A: mass 2, velocity 6 at 25°
sphere B: mass 3, velocity 4 at 180° - 40°
A hits B: along i
"""


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            # v² = 3.2² − 25 sin² 35° = 2.0152; 2v + 3w = 0.80415; w − v = 6.5584e.
            (
                "sphere A: mass 2, velocity 5 at 35°\nsphere B: mass 3, velocity 4 at 180° - 52°\n"
                "A hits B: along i\ngiven speed(A) = 3.2\nfind e, speed(B)\n"
            ),
            (
                "v² ≈ 2.015 v ≈ ±1.420 (1)",
                "as v ≈ 1.420 would give w ≈ −0.6785 and e ≈ −0.3199 by (2) and (3), but e ≥ 0",
                "2.634 ≈ 6.558e e ≈ 0.402",
                "≈ √(1.214² + (4 sin 52°)²) ≈ 3.38",
            ),
        ),
        (
            # w² = 0.9025u² − u² sin² 65° = 0.08111u², with letters for speed and mass.
            (
                "sphere A: mass m, velocity u at 35°\nsphere B: mass 2m, velocity u at 180° - 65°\n"
                "A hits B: along i\ngiven speed(B) = 0.95 u\nfind e\n"
            ),
            (
                "w² ≈ 0.08111u² w ≈ ±0.2848u (1)",
                "as w ≈ −0.2848u would give v ≈ 0.5435u and e ≈ −0.6670 by",
                "0.8805u ≈ 1.242eu e ≈ 0.709",
            ),
        ),
        (
            # v = ±1.0612 are both possible: 6 cos 40° = 4.5963 = v + 2w.
            (
                "sphere P: mass m, velocity 6 at 40°\nsphere Q: mass 2m, at rest\n"
                "P hits Q: along i\ngiven speed(P) = 4\nfind e\n"
            ),
            (
                "v ≈ ±1.061 (both are possible) If v ≈ −1.061: Conservation of momentum",
                "e ≈ 0.846 A1 If v ≈ 1.061: Conservation of momentum",
                "e ≈ 0.154",
            ),
        ),
        (
            BOTH + "given energy_lost = 20\nfind e\n",
            # 29.57 + 14.08 − v² − 1.5w² = 20 with 2v + 3w = 1.6832.
            (
                "≈ 43.65 − 1.5w² − v² (2)",
                "w ≈ 0.5611 − 0.6667v (3)",
                "5v² − 3.366v − 69.55 ≈ 0",
                "as v ≈ 4.081 would give w ≈ −2.160 and e ≈ −0.7341",
                "6.241 ≈ 8.502e e ≈ 0.734",
            ),
        ),
        (
            # 7.2309/8.5021 is 0.85049, and 7.231/8.502 would be 0.851.
            BOTH + "given energy_lost = 20% of energy(0)\nfind e\n",
            ("43.65 − 1.5w² − v² ≈ 0.2 × 60 (2)", "7.231 ≈ 8.502e e ≈ 0.850"),
        ),
        (
            (
                "sphere A: mass 2, velocity 6 at 24°\nsphere B: mass 5, velocity 3 at 180° - 35°\n"
                "A hits B: along i\ngiven speed(A) = 1.5 speed(B)\nfind e\n"
            ),
            ("64v² − 47.69v − 86.43 ≈ 0", "0.9220 ≈ 7.939e e ≈ 0.116"),
        ),
    ],
)
def test_squares_beside_angles_of_a_calculator_give_components_first(
    statement: str, says: tuple[str, ...]
) -> None:
    text = working(statement)
    assert "not written out" not in text
    for words in says:
        assert words in text


PARTED = """sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(B)
"""


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        (
            "show e = 1/k\nfind speed(B)\n",
            ("v = 0 B1", "mu cos α = kmw", "(u cos α)/k = eu cos α M1 A1 1 = ek", "e = 1/k"),
        ),
        ("unknown e\nfind range of k\n", ("v = 0 B1", "(u cos α)/k = eu cos α", "k ≥ 1")),
        (
            "show e k = 1\nfind energy_lost\n",
            ("(u cos α)/k = eu cos α M1 A1 (i) ek = 1 (as required)",),
        ),
        # The letters of the claim are those of the law of restitution.
        (
            "show speed(B) = e u cos(alpha)\n",
            ("v = 0 B1 Newton's experimental law: w = eu cos α M1 A1", "speed of B = eu cos α (as"),
        ),
        (
            "show energy_lost = 1/2 m u^2 (1 - e) cos^2(alpha)\n",
            ("k = 1/e", "Substituting for k: kinetic energy lost = ½mu²(1 − e) cos²α (as"),
        ),
    ],
)
def test_a_component_of_zero_comes_before_the_laws(asked: str, says: tuple[str, ...]) -> None:
    text = working(PARTED + asked)
    assert "not written out" not in text
    assert "(1 − ek)" not in text
    for words in says:
        assert words in text


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            # v = ±5/(2 tan 70°) = ±0.90993; 10 cos 30° = 2v + 3w.
            (
                "sphere A: mass 2, velocity 5 at 30°\nsphere B: mass 3, at rest\n"
                "A hits B: along i\ngiven angle(velocity(A), line_of_centres) = 70°\nfind e\n"
            ),
            (
                "tan² 70° = (5/2)²/v² M1",
                "as v ≈ −0.9099 would give w ≈ 3.493 and e ≈ 1.017 by (2) and (3), but e ≤ 1",
                "2 × 5 cos 30° ≈ 2 × 0.9099 + 3w",
                "1.370 ≈ 4.330e e ≈ 0.316",
            ),
        ),
        (
            # Both senses are possible: e = 0 for v = √3 u/6, and e = 1 for v = −√3 u/6.
            (
                "sphere A: mass m, velocity u at 30°\nsphere B: mass 2m, at rest\n"
                "A hits B: along i\ngiven angle(velocity(A), line_of_centres) = 60°\nfind e\n"
            ),
            (
                "tan² 60° = (u/2)²/v²",
                "v = ±√3 u/6 (both are possible) If v = √3 u/6: Conservation",
                "e = 0",
                "e = 1",
            ),
        ),
        (
            (
                "sphere A: mass m, velocity u at 30°\nsphere B: mass 2m, at rest\n"
                "A hits B: along i\ngiven tan(angle(velocity(A), line_of_centres)) = 4\nfind e\n"
            ),
            ("4² = (u/2)²/v²", "v = ±u/8", "e = (4 + √3)/8 ≈ 0.717", "e = (4 − √3)/8 ≈ 0.283"),
        ),
        (
            (
                "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\n"
                "A hits B: along i\ngiven angle(velocity(A), line_of_centres) = beta\nfind e\n"
            ),
            (
                "v = ±(u sin α)/tan β (both are possible) If v = −(u sin α)/tan β:",
                "e = ((1 + k) tan α + tan β)/(k tan β)",
                "e = (tan β − (1 + k) tan α)/(k tan β)",
            ),
        ),
    ],
)
def test_an_angle_with_the_line_of_centres_gives_a_component_first(
    statement: str, says: tuple[str, ...]
) -> None:
    text = working(statement)
    assert "not written out" not in text
    for words in says:
        assert words in text
