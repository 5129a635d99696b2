"""Workings as they would stand in a book: reasons, labels and letters of the question."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution import explain, parse, solve
from restitution.render import layout as lay
from restitution.render.document import Chain
from restitution.render.document.columns import aligned
from restitution.workings import to_text

# A statement, what its working says, and what it does not say: lines, or parts of them.
CASES = {
    "why a sphere moves off along an axis": (
        (
            "sphere P: velocity -5j\nsphere Q: at rest\nP hits Q: along j, e = 1/3\n"
            "find velocity(P) - velocity(Q), angle(velocity(Q), j)"
        ),
        (
            (
                "Q was at rest, so it moves off along the line of centres, in the direction of −𝐣: "
                "angle between 𝐯_Q and 𝐣 = 180°"
            ),
        ),
        ("Q moves in",),
    ),
    "the sense of a line of centres that is given": (
        (
            "sphere A: mass 2m, velocity 3u at 30° from i\nsphere B: mass m, velocity u j\n"
            "A hits B: along i + j, e = 1/2\nfind line_of_centres"
        ),
        (
            (
                "As (((3√3 u/2)𝐢 + (3u/2)𝐣) − u𝐣) · (𝐢 + 𝐣) = (1 + 3√3)u/2 > 0, A and B approach "
                "each other along 𝐢 + 𝐣: the direction from A to B is that of 𝐢 + 𝐣"
            ),
        ),
        ("is parallel to 𝐢 + 𝐣",),
    ),
    # The second sphere comes from below: from the first to the second it is −j.
    "an axis typed against the approach": (
        (
            "sphere A: mass 2, velocity -4i\nsphere B: mass 1, velocity i + 2j\n"
            "A hits B: along j, e = 1/3\nfind line_of_centres, impulse"
        ),
        ("unit vector along the line of centres = −𝐣", "impulse = 2 − 2/9 = 16/9"),
        ("not written out",),
    ),
    "an axis of the data is a unit vector": (
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, at rest\n"
            "A hits B: along i\nfind line_of_centres"
        ),
        ("unit vector along the line of centres = 𝐢",),
        (),
    ),
    "a claim below the line of another item has its own number": (
        (
            "wall X: along i\nwall Y: along j\nsphere P: velocity u at alpha to X\n"
            "given e > 0\nP hits X: e = e\nP hits Y: e = e\n"
            "show velocity(P) = -e velocity(P, 0)\n"
            "show velocity(P) opposite to velocity(P, 0)\nfind speed(P)"
        ),
        (
            "(i) 𝐯₂ = −e𝐮 (as required)",
            "(ii) So 𝐯₂ is opposite to 𝐮, since e > 0, as required.",
            "(iii) speed",
        ),
        ("(i), (ii)",),
    ),
    "a speed by a kinetic energy": (
        (
            "wall X: along i\nwall Y: along j\nsphere P: velocity u at alpha from -i\n"
            "P hits X\nP hits Y\ngiven total_energy_lost = 75% energy(0)\nfind e, speed(P)"
        ),
        ("Speed, from the kinetic energy: (speed of P)² = e²u² = u²/4",),
        (),
    ),
    "times of the question by its letters": (
        (
            "wall L: along j, through (0, 0)\nwall M: along j, through (a, 0)\n"
            "sphere P: at (b, 0), velocity -u i\ngiven 0 < b < a\nP hits L: e = e\n"
            "P hits M: e = f\nP hits L: e = e\nshow time(2) - time(1) = (a/b) time(1)/e\n"
            "show time(3) - time(2) = (time(2) - time(1))/f"
        ),
        (
            "t₂ − t₁ = (a/b)t₁/e = (a/b)T/e, as T = t₁ (as required)",
            "t₃ − t₂ = (t₂ − t₁)/f = t/f, as t = t₂ − t₁ (as required)",
        ),
        (),
    ),
    "squares stand apart before a coefficient is a quotient of them": (
        (
            "wall W: along i\nsphere P: mass 2m, velocity 3u at theta to W\nP hits W: e = f\n"
            "given velocity(P) perpendicular to velocity(P, 0)\nfind f in terms of theta\n"
            "find speed(P)"
        ),
        (
            "f sin²θ = cos²θ (i) f = 1/tan²θ",
            # 9u² cos²θ(1/tan²θ + 1) = 9u²/tan²θ
            "√(((3u cos θ)/tan θ)² + (3u cos θ)²) = 3u/tan θ, as sin²θ + cos²θ = 1",
        ),
        ("does not follow",),
    ),
    "squares stand apart in an inequality": (
        (
            "wall W: along i\nsphere P: velocity u at alpha to W\ngiven alpha > 45°\nP hits W\n"
            "given deflection(P) > 90°\nfind range of e in terms of alpha"
        ),
        ("cos²α < e sin²α e > 1/tan²α",),
        (),
    ),
    "quotients over one root": (
        (
            "wall W: along i\nwall X: along j\nsphere P: velocity u at alpha to W\nP hits W\n"
            "P hits X\ngiven deflection(P, 1) = deflection(P, 2)\n"
            "find tan(alpha) in terms of e"
        ),
        ("cos²α − e sin²α = e sin²α − cos²α tan²α = 1/e",),
        (),
    ),
    # u sin²θ/cos θ, by the scalar product.
    "a sine and a tangent": (
        (
            "sphere A: mass m, velocity u at theta\nsphere B: mass k m, at rest\n"
            "A hits B: along i, e = 1/2\ngiven deflection(A) = 90°\nfind k in terms of theta"
        ),
        ("v = −u sin θ tan θ",),
        ("cos θ tan²θ",),
    ),
    "a cube stays below its root": (
        (
            "wall C: circle centre (0, 0) radius a\npoint S: (-a, 0)\n"
            "sphere P: at (-a, 0), velocity u at alpha\nP hits C\nP hits C\nP reaches S\n"
            "find tan(alpha) in terms of e"
        ),
        ("tan α = √(e³/(1 + e + e²)), as α is acute",),
        ("e√(e/",),
    ),
    "tangents stay tangents beside another unknown": (
        (
            "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
            "A hits B: along i\ngiven deflection(A) = 30°, energy_lost = 1/3 energy(0)\n"
            "find alpha, e"
        ),
        ("3e tan α + 3 tan α = 2√3 tan²α − √3 e + √3",),
        ("sin α cos α",),
    ),
    # ke > 1 from the right angle: k > 1/e ≥ 1.
    "a claim rests on a bound that stands": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\n"
            "A hits B: along i\ngiven deflection(A) = 90°\nfind range of k in terms of e\n"
            "find e in terms of k, alpha\nshow k > 1"
        ),
        ("(iii) k > 1, as 0 ≤ e ≤ 1 (as required)",),
        ("ek − 1 > 0, as α is acute (iii)",),
    ),
    "vectors that are added are in brackets": (
        (
            "wall C: circle centre (2, 1) radius 5\nsphere P: mass 2, at (2, 1), "
            "velocity 3i + 4j\nP hits C: e = 1/2\nfind position(P), velocity(P)"
        ),
        ("position of P at the impact = (2𝐢 + 𝐣) + (3𝐢 + 4𝐣)", "= (5𝐢 + 5𝐣) m"),
        ("4𝐣) m",),
    ),
    "letters in the order of what is shown": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass M, at rest\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to velocity(A, 0)\n"
            "show tan^2(alpha) = (M e - m)/(M + m)\nfind tan(alpha)"
        ),
        ("(M + m) sin²α = (Me − m) cos²α", "tan α = √((Me − m)/(M + m))"),
        ("eM", "m + M"),
    ),
    # 3/(4(1 + e₁)) is greatest for e₁ = 0.
    "a coefficient that stays below 1": (
        (
            "wall X: along i\nwall Y: along j\nsphere P: mass m, velocity u at alpha to X\n"
            "P hits X: e = e1\nP hits Y: e = e2\ngiven e2 = 3/(4(1 + e1))\nfind range of e1"
        ),
        ("e₂ ≤ ¾ < 1, as e₁ ≥ 0", "So every value of e₁ is possible: 0 ≤ e₁ ≤ 1"),
        (),
    ),
    # (q − 4, 4)·(q, 2) = −½(q − 4, 4)·(4, −2)
    "a wall by a velocity of which a component is unknown": (
        (
            "wall W\nsphere P: velocity 4i - 2j\nP hits W: e = 1/2\n"
            "given velocity(P) = q i + 2j\nfind q, direction(W)"
        ),
        (
            "the normal to W is parallel to (q𝐢 + 2𝐣) − (4𝐢 − 2𝐣)",
            "q(q − 4) + 2 × 4 = ½(−4(q − 4) + 2 × 4)",
            (
                "q = 1 + √5 ≈ 3.24 or q = 1 − √5 ≈ −1.24 (both are possible, as q may have either "
                "sign)"
            ),
            "W is parallel to 4𝐢 + (3 − √5)𝐣",
        ),
        ("not written out",),
    ),
    "a line of centres by a velocity of which a component is unknown": (
        (
            "sphere A: mass 1, velocity 4i - 2j\nsphere B: mass 2, at rest\n"
            "A hits B: e = 1/2\ngiven velocity(A) = q i + j\nfind q"
        ),
        ("𝐯_B = ((4 − q)/2)𝐢 − (3/2)𝐣", "(q − 1)(q − 3) = 0 q = 1 or q = 3"),
        ("not written out",),
    ),
    "a wall by an unknown multiple of a speed": (
        (
            "wall W\nsphere P: mass m, velocity u(4i - 2j)\nP hits W: e = 1/2\n"
            "given velocity(P) = k u i + 2u j\nfind k, direction(W)"
        ),
        (
            "k² − 2k − 4 = 0",
            "k = 1 + √5 ≈ 3.24, as k is positive",
            "W is parallel to (3 + √5)𝐢 + 𝐣",
        ),
        ("not written out",),
    ),
    "a velocity that no wall allows": (
        (
            "wall W\nsphere P: velocity 4i - 2j\nP hits W: e = 1/2\n"
            "given velocity(P) = q i + 3j\nfind q, direction(W)"
        ),
        (
            (
                "This cannot be, as the discriminant of q² − 2q + 2 = 0 is negative: "
                "2² − 4 × 2 = −4. So what is described cannot happen. A1"
            ),
        ),
        ("other data",),
    ),
    "a velocity that no line of centres allows": (
        (
            "sphere A: mass 1, velocity 4i - 2j\nsphere B: mass 2, at rest\n"
            "A hits B: e = 1/2\ngiven velocity(A) = q i + 6j\nfind q"
        ),
        ("q² − 4q + 48 = 0 This cannot be, as the discriminant",),
        ("other data",),
    ),
    "a bound of a quantity that has no letter": (
        (
            "wall W: along i\nsphere P: mass m, velocity p i - 4j\nP hits W\n"
            "given speed(P, 0) >= 5, p > 0\nfind range of p"
        ),
        ("as the speed of P before the impact is at least 5 m s⁻¹",),
        ("as speed",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_it_would_be_printed_as_it_stands(name: str) -> None:
    text, lines, others = CASES[name]
    shown = " ".join(to_text(explain(solve(parse(text)), check=True), 80).split())
    for line in lines:
        assert line in shown
    for other in others:
        assert other not in shown


def test_no_line_ends_within_a_product_with_a_sine() -> None:
    value = sp.sympify("(a + b)*(u*sin(alpha)*(1 + e) + v*cos(alpha)*(1 - e) + u*sin(alpha))")
    chain = Chain((lay.letter("E"), lay.from_sympy(value)), ("=",))
    for width in range(24, 60):
        for line in aligned([chain], width, 0):
            assert not line.text.startswith(("sin", "cos"))
            assert line.text.strip().split(" ")[0] not in ("sin", "cos")
