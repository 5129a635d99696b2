"""Claims with squares: each step stands on paper, and a letter for a speed is no obstacle."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\n"
TURNED = "given deflection(P) = 90°\n"


def printed(text: str) -> str:
    """What is printed of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert not explanation.warnings
    printed_ = " ".join(to_text(explanation, 100).split())
    assert "not written out" not in printed_
    return printed_


def test_a_square_over_a_square_is_worked_out_at_once() -> None:
    text = printed(
        f"{WALL}P hits W\nlet v = speed(P)\nshow v^2/u^2 = cos^2(alpha) + e^2 sin^2(alpha)"
    )
    assert "v²/u² = ((eu sin α)² + (u cos α)²)/u² = cos²α + e² sin²α" in text
    assert "v = √" not in text


def test_a_letter_for_a_speed_is_shown_by_squares_of_an_angle() -> None:
    text = printed(
        f"{WALL}P hits W\n{TURNED}let v = speed(P)\npart a\nshow tan^2(alpha) = 1/e\n"
        "part b\nshow v^2 = e u^2\npart c\nshow energy_lost/energy(0) = 1 - e"
    )
    assert "sin²α = 1/(1 + e) cos²α = e/(1 + e)" in text
    assert "v² = (eu sin α)² + (u cos α)² = e²u²/(1 + e) + eu²/(1 + e) = eu²" in text
    assert "from part (a) and sin²α from part (b): fraction lost" in text


def test_what_is_divided_by_stands_on_the_other_side_first() -> None:
    text = printed(f"{WALL}P hits W\ngiven speed(P) = 1/2 u\nshow sin^2(alpha) = 3/(4(1 - e^2))")
    assert "(½u)² = (eu sin α)² + u²(1 − sin²α) DM1 4(1 − e²) sin²α = 3 sin²α = 3/(4" in text


def test_a_tangent_comes_of_the_sine_and_the_cosine() -> None:
    text = printed(
        f"{WALL}P hits W\ngiven energy_lost = 1/2 energy(0)\nshow tan^2(alpha) = 1/(1 - 2e^2)"
    )
    assert "cos²α = 1 − 1/(2(1 − e²)) = (1 − 2e²)/(2(1 − e²)) (2)" in text
    assert "Dividing (1) by (2): tan²α = 1/(1 − 2e²)" in text


def test_the_sum_of_squares_is_a_factor_before_it_is_one() -> None:
    text = printed(
        f"{WALL}P hits W\nlet beta = angle(velocity(P), W)\ngiven beta = 90° - alpha\n"
        "show e = cot^2(alpha)\nshow speed(P) = u cot(alpha)"
    )
    assert "= (u² cos²α)(sin²α + cos²α)/sin²α = u² cot²α, as sin²α + cos²α = 1" in text


def test_a_sine_or_a_cosine_is_a_component_over_the_speed() -> None:
    angle = f"{WALL}P hits W\nlet beta = angle(velocity(P), W)\n"
    text = printed(angle + "find sin(beta), cos(beta)")
    assert "(speed of P) sin β = eu sin α" in text
    assert "sin β = eu sin α/(u√(cos²α + e² sin²α)) = (e sin α)/√(cos²α + e² sin²α)" in text
    assert "(speed of P) cos β = u cos α" in text
    text = printed(angle + "show sin^2(beta) = e^2 sin^2(alpha)/(cos^2(alpha) + e^2 sin^2(alpha))")
    assert "= (e sin α)/√(cos²α + e² sin²α) sin²β = e² sin²α/(cos²α + e² sin²α)" in text
