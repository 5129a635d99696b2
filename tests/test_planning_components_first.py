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
                "v ≈ ±1.061 If v ≈ −1.061: Conservation of momentum",
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
