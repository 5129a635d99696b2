"""Workings of questions in letters: what is shown, ranges, and greatest and least values."""

from __future__ import annotations

import pytest

from restitution import parse, solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\n"
IN_LINE = "sphere P: mass m, velocity 2u i\nsphere Q: mass 3m, velocity u i\nP hits Q: along i\n"
BACK = """
wall W: along j
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i
part a
find velocity(A), velocity(B)
"""

# What stands in a working, and what does not.
SAYS: dict[str, tuple[str, list[str], list[str]]] = {
    "a sign that the range of a coefficient tells is no matter of growth": (
        IN_LINE + "part a\nfind velocity(P)\npart b\nshow along(velocity(P), i) > 0\n",
        ["v > 0, as e ≤ 1 (as required)"],
        ["increases"],
    ),
    "a multiple of a coefficient is at most what it multiplies": (
        WALL + "P hits W\nlet beta = angle(velocity(P), W)\nshow beta <= alpha\n",
        ["tan β ≤ tan α, as α is acute and e ≤ 1"],
        ["increases"],
    ),
    "in which direction a sphere moves is the sign of its component, in the part that asks it": (
        BACK + "part b\ngiven e > 1/2\nshow velocity(A) in the direction of -i\n",
        ["A1 (b) From (3): v < 0, as e > ½", "So 𝐯_A is in the direction of −𝐢, as required."],
        [],
    ),
    # v > -(1 + e)u/6 as e < 1.
    "a part in which more is known of a letter goes on with what stands": (
        BACK + "part b\nB hits W: e = 1/2\ngiven e > 1/2, A and B collide again\nfind range of e\n",
        [
            "A is behind B, so they collide again if the component of",
            "(1 − 2e)u/3 > −(1 + e)u/6",
            "e < 1",
            "½ < e < 1",
        ],
        ["not written out"],
    ),
    # v = (1 - 2e)u, so A loses all that it has along i.
    "what a sphere loses has the coefficient of its part, though its component is zero": (
        """
sphere A: mass 2m, velocity 3u i + u j
sphere B: mass m, velocity -3u i + 2u j
A hits B: along i
part a
find velocity(A)
part b
given e = 1/2
find energy_lost(A), energy_lost(B)
""",
        ["v = 0", "lost by A = ½ × 2m(3u)² = 9mu²", "lost by B = ½m((3u)² − (3u)²) = 0"],
        ["not written out", "does not follow"],
    ),
    "the direction of a wall is shown as it is found": (
        """
wall W
sphere P: mass 2, velocity 7i - j
P hits W
given velocity(P) = 2i + 4j
find impulse(P)
show direction(W) parallel to i + j
""",
        ["At right angles to the normal: (ii) W is parallel to 𝐢 + 𝐣 (as required)"],
        ["not written out", "So W is"],
    ),
    "a multiple of an equation is shown before that is solved": (
        WALL
        + """P hits W: e = 1/3
given tan(deflection(P)) = 2
part a
show 2tan^2(alpha) + 4tan(alpha) - 6 = 0
part b
find alpha
""",
        [
            "Since tan δ = 2, substituting for tan β: 2 = (tan α + ⅓ tan α)/(1 − ⅓ tan²α)",
            "3 − tan²α = 2 tan α 2 tan²α + 4 tan α − 6 = 0 (as required)",
            ": tan²α + 2 tan α − 3 = 0 (tan α − 1)(tan α + 3) = 0",
        ],
        ["scalar product"],
    ),
    "a deflection at a wall is the sum of two angles, whatever tells the path": (
        """
wall W: along j
sphere P: mass m, velocity u i + 2u j
P hits W
show tan(deflection(P)) = 2(1 + e)/(4 - e)
""",
        ["δ = β + θ", "tan δ = (½ + e/2)/(1 − e/4) = 2(1 + e)/(4 − e) (as required)"],
        ["vector product"],
    ),
    "the tangent of an angle less some degrees is that of a difference": (
        WALL + "P hits W: e = 1/3\ngiven angle(velocity(P), W) = alpha - 30°\nfind alpha\n",
        [
            "By the formula for the tangent of a difference: (tan α − √3/3)/(1 + (√3/3) tan α)",
            "tan²α − 2√3 tan α + 3 = 0",
            "α = 60°",
        ],
        ["sin²α"],
    ),
    "a square that is put in goes for the fourth power too": (
        """
wall W: along i
sphere P: mass m, velocity a i - b j
given a > 0, b > 0
P hits W
given velocity(P) perpendicular to velocity(P, 0)
part a
show e = a^2/b^2
show b >= a
part b
show energy_lost = m(b^4 - a^4)/(2b^2)
part c
given energy_lost = 1/2 energy(0)
find e
""",
        [
            "b ≥ a, as a > 0 and b > 0 (as required)",
            "2b⁴ − 2(eb²)² = b⁴ + b²e × b²",
            "Dividing by b⁴, which is not zero as b > 0: e = ½",
        ],
        ["as a > 0:"],
    ),
    "a side with the factor sin² + cos² goes on without that": (
        WALL
        + """P hits W
given speed(P) = 3/4 u, velocity(P) perpendicular to velocity(P, 0)
show tan(alpha) = 4/3
""",
        ["(sin²α + cos²α) = 16 cos²α, as sin²α + cos²α = 1", "tan α = 4/3 (as required)"],
        ["1 − cos²α"],
    ),
    "what is to be shown is not solved for something else before": (
        WALL + "P hits W\ngiven deflection(P) = 90°\nshow e = cot^2(alpha)\n",
        ["e sin²α = cos²α e = cot²α (as required)"],
        ["tan²α"],
    ),
    "a ratio of an angle may be bounded": (
        WALL
        + """given sin(alpha) <= 3/5
P hits W: e = 1/2
find range of energy_lost
find range of tan(angle(velocity(P), W))
""",
        [
            "0 < kinetic energy lost ≤ 27mu²/200 as α is acute and sin α ≤ ⅗",
            "0 < tan β ≤ ⅜, as α is acute and sin α ≤ ⅗",
        ],
        ["not written out"],
    ),
    "what a later part gives chooses between values of an earlier one": (
        """
wall W: along i
sphere P: mass m, velocity 3i + q j
P hits W: e = 1/2
part a
given speed(P) = 5
find q
part b
given speed(P) = 5, q > 0
find impulse
""",
        [
            "q = 8 or q = −8 (both are possible, as q may have either sign)",
            "q = 8, as q > 0",
            "m(8 + 4) = 12m",
        ],
        ["does not follow"],
    ),
    "a direction that a later part gives chooses too": (
        """
sphere A: mass m, velocity 2u i
sphere B: mass k m, velocity -u i
A hits B: along i, e = 1/2
part a
given speed(A) = u/2
find k
part b
given speed(A) = u/2, velocity(A) in the direction of i
find k
""",
        ["k = ½ or k = 5/4", "k = ½, as A moves in the direction of 𝐢"],
        ["does not follow", "(b) From part (a): k = ½ or"],
    ),
    "of an angle that cancels no ratio is put in": (
        WALL
        + """P hits W
given impulse = 4/3 m u sin(alpha), tan(alpha) = 3/2
find e
""",
        ["(4/3)mu sin α", "e = ⅓"],
        ["√13"],
    ),
    "a condition by a complement is one of tan²": (
        WALL
        + """P hits W
given angle(velocity(P), W) = 90° - alpha
show tan(alpha) >= 1
""",
        ["1/tan α = e tan α tan²α = 1/e tan²α ≥ 1, as e ≤ 1", "tan α ≥ 1, as α is acute"],
        ["tan(90° − α) ≤"],
    ),
    # tan²α = e, and the speed is u/(2 cos α).
    "a range goes without a letter that is tied to another one": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given speed(A) = speed(B)
find range of alpha
find range of speed(A)
""",
        ["0° < α ≤ 45°", "Substituting for e in (3)", "u/2 < speed of A ≤ √2 u/2"],
        ["not written out", "does not follow"],
    ),
    "a bound is seen where the difference is a product": (
        WALL
        + """P hits W
show impulse <= 2 m u sin(alpha)
show m u sin(alpha) <= impulse
""",
        ["2mu sin α as α is acute and e ≤ 1", "as α is acute and e ≥ 0 (as required)"],
        ["increases"],
    ),
    "a speed of one component is that with either sign, and no more": (
        """
sphere A: mass m, velocity 4u i + 3u j
sphere B: mass k m, velocity -u i
A hits B: along i
given velocity(A) = -u i + 3u j, speed(B) = 3/2 u
find k, e
""",
        ["w = ±3u/2 (1)", "w = 3u/2, as w = −3u/2 would give e = −1/10"],
        ["2w"],
    ),
    "a product with what a quantity is stands before that with the quantity": (
        """
sphere A: mass m, velocity u i
sphere B: mass 3m, at rest
A hits B: along i
show energy_lost = 1/2 (1 - e) u impulse
""",
        ["½(1 − e)u(3(1 + e)mu/4)", "= ½(1 − e)u × magnitude of the impulse (as required)"],
        [],
    ),
    "two angles that make 90° are both acute": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - beta
A hits B: along i, e = 1
given velocity(A) perpendicular to velocity(B)
show alpha + beta = 90°
""",
        ["α = 90° − β"],
        ["does not follow"],
    ),
    "the known angle is taken from the bound of a deflection first": (
        """
wall W: along i
sphere P: mass m, velocity u at 45° to W
P hits W
given deflection(P) < 75°
find range of e
""",
        ["Since δ < 75°: 45° + β < 75°", "β < 30° tan β < √3/3", "0 ≤ e < √3/3"],
        ["tan δ"],
    ),
    "what was shown of letters is put in last": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - alpha
A hits B: along i
given velocity(A) perpendicular to velocity(A, 0)
show tan^2(alpha) = e
show speed(A)^2 = e u^2
""",
        ["(ii) (speed of A)² = eu² (as required)"],
        ["not written out"],
    ),
    "where a tangent has no value is said by a letter": (
        """
sphere A: mass m, velocity u i, radius a
sphere B: mass 2m, at rest, radius a
A hits B: offset a
show tan(deflection(A)) = (1 + e)/(sqrt(3)(1 - e))
""",
        ["and δ = 90° if e = 1"],
        ["= 0 (as required)"],
    ),
    "the range of a tangent may have two parts": (
        """
sphere A: mass m, velocity u at 45°
sphere B: mass 4m, at rest
A hits B: along i
find range of tan(angle(velocity(A), i))
""",
        ["tan β = (√2 u/2)/(√2(1 − 4e)u/10) = 5/(1 − 4e)", "tan β ≤ −5/3 or tan β ≥ 5, as 0 ≤ e"],
        ["not written out"],
    ),
    "an angle that a part gives is put in before the laws": (
        """
wall AB: along i
wall BC: along 120°
sphere P: mass m, velocity u at alpha to AB
P hits AB: e = 1/3
part a
find speed(P)
part b
P hits BC: e = 1/3
given alpha = 60°
find speed(P)
""",
        ["(u/2)(√3/2) + ½(√3 u/6) = √3 u/3"],
        ["3√3 cos α"],
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_it_says_what_a_teacher_would_write(name: str) -> None:
    text, says, never = SAYS[name]
    working = " ".join(to_text(explain(solve(parse(text)), check=True)).split())
    assert [words for words in says if words not in working] == []
    assert [words for words in never if words in working] == []
