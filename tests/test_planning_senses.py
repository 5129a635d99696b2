"""Angles and senses of a working: nothing is worked out that is told, and no sign is left open.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says; what a teacher does not say is not in it.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, what its working says, and what it does not say: lines, or parts of them.
CASES = {
    "an angle to i that an earlier part shows": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
part a
show tan(angle(velocity(A), i)) = 2 tan(alpha)/(1 - e)
part b
given tan(alpha) = 1/2, deflection(A) = 45°
find e
""",
        ("Since tan α = ½, from (3):\n    tan β = 1/(1 − e)", "β = α + 45°"),
        ("to that line", "θ", "cos α = 2√5/5", "With v from part (a)"),
    ),
    "a deflection where the struck sphere shows the line of centres in degrees": (
        """
sphere A, B: mass m
sphere A: velocity 6i
sphere B: at rest
A hits B
given direction(B) = -50°, deflection(A) = 20°
find e
""",
        ("is parallel to cos 50° 𝐢 − sin 50° 𝐣", "β = 50°", "θ = 20° + 50° = 70°", "e ≈ 0.132"),
        ("the direction from A to B is that of", "tan θ − tan"),
    ),
    "a letter of an earlier part for an angle": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = e
part a
let theta = angle(velocity(A), i)
show tan(theta) = 3tan(alpha)/(1 - 2e)
part b
given e = 1/4
find tan(deflection(A)) in terms of alpha
""",
        ("Since e = ¼, from (3):\n    tan θ = 6 tan α", "δ = θ − α"),
        ("β",),
    ),
    "a wall at a letter": (
        """
wall W: along phi
sphere Q: velocity 3w i
Q hits W: e = 1/2
given velocity(Q) perpendicular to i
find tan(phi)
""",
        ("V cos φ = ½ × 3w sin φ", "tan φ = 2/tan φ", "as φ is taken to be acute"),
        ("away from W",),
    ),
    "a wall of which the side is open": (
        """
wall AB: along i
wall BC: along phi
sphere P: velocity u at 30° to AB
P hits AB: e = 1/2
P hits BC: e = 1/3
given velocity(P) perpendicular to i
find tan(phi)
""",
        ("be a unit vector perpendicular to BC",),
        ("towards it",),
    ),
    "a wall that stops what comes towards it": (
        """
wall AB: along i
wall BC: along 30°
sphere P: velocity u at beta to AB
P hits AB: e = 1/4
P hits BC: e = 0
find maximum of speed(P) over beta
""",
        ("vector perpendicular to BC, and", "speed of P = u(4√3 cos β + sin β)/8"),
        ("towards it",),
    ),
    "a wall at 75° that is approached or left": (
        """
wall AB: along i
wall BC: along 75°
sphere P: velocity u at beta to AB
P hits AB: e = 1/3
P hits BC: e = 1/2
find speed(P)
""",
        ("component of 𝐯₁ perpendicular to BC\n",),
        ("towards BC",),
    ),
    "a wall that is approached by what is given": (
        """
wall AB: along i
wall BC: along 45°
sphere P: velocity u at beta to AB
given beta < 30°
P hits AB: e = 1/3
P hits BC: e = 1/2
find velocity(P)
""",
        ("towards it",),
        (),
    ),
    "a line of centres at a letter": (
        """
sphere A: mass m, velocity 4u i
sphere B: mass m, at rest
A hits B: along phi, e = 1/2
given speed(A) = 3u
find tan(phi)
""",
        ("𝐭 = −sin φ 𝐢 + cos φ 𝐣", "in the direction of 𝐭 stays −4u sin φ"),
        (),
    ),
    "a line of centres on either side": (
        """
sphere A: mass 2m, velocity 5u i
sphere B: mass 2m, at rest
A hits B: e = 1/5
given speed(A) = 4u
find speed(B)
""",
        ("𝐭 = −sin θ 𝐢 + cos θ 𝐣",),
        (),
    ),
    "to the left of j": (
        """
sphere A: mass m, velocity u at 45°
sphere B: mass 3m, at rest
A hits B: along i, e = 2/3
find direction(A)
""",
        ("tan θ = (√2 u/2)/(−√2 u/8) = −4", "θ = 180° − arctan 4"),
        (),
    ),
    "a given angle is not worked out": (
        """
sphere A: mass 5m, velocity u at 30°
sphere B: mass 3m, at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = 45°
find e, deflection(A)
""",
        ("45° − 30° = 15°",),
        ("tan β",),
    ),
    "a direction tells the angle to the line of centres": (
        """
sphere A: mass m, velocity 2u at 30°
sphere B: mass m, velocity u at 60° from -i
A hits B: along i, e = 1/2
find direction(B), deflection(B)
""",
        ("As w > 0, B is sent back along the line of centres",),
        ("angle between 𝐯_B and the line",),
    ),
    "along j before a line at an angle": (
        """
sphere A: mass 2m, velocity 3u j
sphere B: mass m, at rest
A hits B: along 60°, e = 1/2
find deflection(A), angle(velocity(A), velocity(B))
""",
        ("− 30°", "it moves along the line of centres:\n    θ = β = arctan(2√3/3)"),
        ("tan θ",),
    ),
    "a velocity from i at a slanting wall": (
        """
wall W: along 30°
sphere P: velocity u at 75°
P hits W: e = 1/3
find speed(P), deflection(P)
""",
        ("P moves at 75° − 30° = 45° to W.", "45° + arctan(1/3)"),
        ("angle between 𝐮_P",),
    ),
    "a tangent of the data at a wall along j": (
        """
wall W: along j
sphere P: velocity 2u at alpha from j
given tan(alpha) = 3/4
P hits W: e = 1/3
find tan(deflection(P))
""",
        ("δ = α + β", "(¾ + ¼)/(1 − ¾ × ¼) = 16/13"),
        ("Angle of deflection:",),
    ),
    "straight back": (
        """
wall W: along i
sphere P: mass m, velocity -3u j
P hits W: e = 1/2
find velocity(P), deflection(P)
""",
        ("P hits W at right angles, so it is sent straight back:\n    δ = 180°",),
        ("cos δ",),
    ),
    "along the wall": (
        """
wall W: along j
sphere P: velocity 2u at 35° to W
P hits W: e = 0
find deflection(P)
""",
        ("P goes on along W", "= 35°"),
        ("tan",),
    ),
    "a slanting wall after a blow": (
        """
wall W: along 45°
sphere P: mass 1/2, velocity 4j
P receives -3i + 2j
P hits W: e = 1/2
find velocity(P), direction(P, 1)
""",
        ("𝐯₁ · 𝐧 = ", "tan θ = 8/(−6)"),
        (),
    ),
    "two lines of centres at right angles": (
        """
sphere A, B, C: mass m
sphere A: velocity 8u i
sphere B, C: at rest
A hits B: along 30°, e = 1/2
A hits C: along -60°, e = 1/2
find speed(C)
""",
        ("at right angles to the\nlast one:", "𝐯_A · 𝐧₂ = −𝐯_A · 𝐭₁ = 4u"),
        (),
    ),
    "the speed after a blow": (
        """
sphere P: mass 2, velocity 5i
P receives J at theta
given J = 8, speed(P) = 7
find cos(theta), velocity(P), deflection(P)
""",
        ("𝐯_P = (29/5)𝐢 + (8√6/5)𝐣", "cos δ = (5 × (29/5))/(5 × 7)"),
        (),
    ),
    "why a deflection is a difference": (
        """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/2
given deflection(A) = arctan(3/5)
find tan(alpha)
""",
        ("is arctan(3/5). As v > 0, A keeps\nits sense along the line of centres",),
        (),
    ),
    "a body that keeps its sense may have no velocity along the line": (
        """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = e
given tan(alpha) = 2
find tan(deflection(A))
""",
        ("As v ≥ 0 (since e ≤ 1), A keeps its sense", "or has no\nvelocity along it if e = 1,"),
        (),
    ),
    "a sense that a given bound of e makes": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given e < 1/3
find maximum of deflection(A) over alpha
""",
        ("As v > 0 (since e < ⅓), A keeps its sense along the line of centres",),
        ("e ≤ 1",),
    ),
    "a loss that is given, by what changes": (
        """
sphere A: mass 2m, velocity 3u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given energy_lost = m u^2
find cos(alpha)
""",
        ("is mu². By the components that change:",),
        (),
    ),
    "a loss at a wall that is given, by what changes": (
        """
wall W: along i
sphere P: mass m, velocity 2u at 45° to W
P hits W
given energy_lost = 1/2 m u^2
find e
""",
        ("is ½mu². By the component that changes:",),
        (),
    ),
    "a deflection from an axis": (
        """
sphere A: mass m, velocity -2u j
sphere B: mass m, at rest
A hits B: along 3i - 4j, e = 1/2
find velocity(A), deflection(A)
""",
        (
            "A came in the direction of −𝐣, so the angle of deflection is the one",
            "𝐯_A\nand −𝐣:",
        ),
        (),
    ),
    "a tangent in which an angle that was found cancels": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i, e = 1/5
given speed(A) = 3/4 u
find cos(alpha), direction(A)
""",
        ("tan θ = u sin α/((1/10)u cos α) = 10 tan α", "    tan α = "),
        ("sin α = √", "    v = √"),
    ),
    "a tangent at a wall in which an angle that was found cancels": (
        """
wall W: along j
sphere P: mass m, velocity u at theta
P hits W: e = 2/3
given energy_lost = 1/4 energy(0)
find theta, deflection(P)
""",
        ("tan β = ⅔u cos θ/(u sin θ) = 2/(3 tan θ)",),
        ("    sin θ = ",),
    ),
    "components that a speed needs are worked out": (
        """
wall W: along j
sphere P: mass m, velocity u at theta
P hits W: e = 2/3
given energy_lost = 1/4 energy(0)
find speed(P), deflection(P)
""",
        ("speed of P = √3 u/2", "tan θ = √11/3"),
        ("not written out",),
    ),
    "an angle to a wall that is parallel to the line of centres": (
        """
wall W: along i
sphere A: mass m, velocity 2u at 45° to W
sphere B: mass m, at rest
A hits W: e = 1/3
A hits B: along i, e = 1/2
find tan(deflection(A, 1)), tan(deflection(A, 2))
""",
        ("so the angle between 𝐯_A1 and that line is β too.",),
        (),
    ),
    "a deflection from direction to direction": (
        """
wall W: along j
sphere P: velocity u at 135°
P hits W: e = 1/2
find direction(P), deflection(P)
""",
        ("P turns through the difference of its directions", "δ = 135° − arctan 2"),
        ("tan β",),
    ),
    "a deflection from below i": (
        """
wall W: along i
sphere P: velocity u at -40°
P hits W: e = 1/3
find direction(P), deflection(P)
""",
        ("δ ≈ 15.63° + 40°",),
        (),
    ),
    "a deflection from i, with the direction": (
        """
wall W: along 30°
sphere P: mass m, velocity u i
P hits W: e = 1/3
find direction(P), deflection(P)
""",
        ("P came in the direction of 𝐢", "    δ = 30° + arctan(√3/9)"),
        ("tan δ", "turns through"),
    ),
    "a deflection from i to the right": (
        """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset a, e = 2/3
find direction(A), deflection(A)
""",
        ("A came in the direction of 𝐢", "    δ = arctan(5√3/9)"),
        ("= 0°",),
    ),
    "a speed by the angle that is given": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass m, at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = 60°
find e, speed(A)
""",
        ("speed of A = (u/2)/sin 60° = √3 u/3",),
        ("Speed, from its components",),
    ),
    "a speed by the angle to a wall that is given": (
        """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W
given angle(velocity(P), W) = 30°
find speed(P)
""",
        ("speed of P = (u/2)/cos 30°",),
        ("e = ",),
    ),
    "a ratio of speeds in which an angle that was found cancels": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1/4
given angle(velocity(A), velocity(B)) = 60°
find tan(alpha), speed(A)/speed(B)
""",
        ("(⅙u cos α)/cos 60° = ⅓u cos α", "= ⅓u cos α/((5/12)u cos α) = ⅘"),
        ("√39",),
    ),
    "a given angle to the line, and the sense of the component": (
        """
sphere A: mass 2m, velocity u at 30°
sphere B: mass m, at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = 45°
find e
""",
        ("v = ±u/2", "as v = −u/2 would give w = (1 + √3)u and e = 2 + √3", "but e ≤ 1"),
        (),
    ),
    "twice one angle to the line of centres": (
        """
sphere A: mass m, velocity 2u i + u j
sphere B: mass m, velocity -2u i - u j
A hits B: along i, e = 1
find deflection(A)
""",
        (" = 180° − 2 arctan(1/2)",),
        (),
    ),
    "twice one angle to a wall": (
        """
wall W: along i
sphere P: velocity 3i - 2j
P hits W: e = 1
find deflection(P)
""",
        ("δ = β + θ = arctan(2/3) + arctan(2/3) = 2 arctan(2/3)",),
        (),
    ),
    "an offset that is found by its angle": (
        """
sphere A: mass m, velocity 5u i, radius 10
sphere B: mass m, at rest, radius 10
A hits B: offset d, e = 1/2
given angle(line_of_centres, i) = arcsin(4/5)
find d, speed(B)
""",
        ("d/20 = ⅘", "d = 16\n", "unit vector along the line of centres = (3𝐢 + 4𝐣)/5"),
        (),
    ),
    "an offset by its angle with the velocity, of which both ratios have one root": (
        """
sphere A: mass m, velocity 5u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset d, e = 1/2
given angle(line_of_centres, velocity(A, 0)) = 45°
find d, speed(B)
""",
        ("d/(2r) = √2/2", "d = √2 r", "makes an angle of 45° with the path of A"),
        ("d²", "does not follow"),
    ),
    "two roots by the formula, in one order": (
        """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset d, e = 2/3
given deflection(A) = 30°
find d
""",
        ("tan φ = (√51 + 5√3)/12 or tan φ = (5√3 − √51)/12",),
        ("(5√3 + √51)/12",),
    ),
    "a speed in what is to be shown stands before no energy": (
        """
wall W: along j
sphere P: velocity u at 90° - alpha
P hits W: e = e
let beta = angle(velocity(P), W)
show cos(beta) * speed(P) = u cos(alpha)
find energy(P)/energy(P, 0)
""",
        ("kinetic energy of P",),
        ("Speed, from its components",),
    ),
    "a speed that is asked after the energy": (
        """
wall W: along i
sphere P: mass m, velocity u at 30° to W
P hits W: e = 1/3
find energy(P), speed(P)
""",
        ("kinetic energy of P = ½m(√7 u/3)²",),
        (),
    ),
    "beyond a right angle": (
        """
sphere P: mass 2, velocity 3i + j
P receives J at theta
given direction(P) = 90°, speed(P) = 4, 0 < theta < 180°
find J, theta
""",
        ("θ = 135°, as 0° < θ < 180°",),
        (),
    ),
    "a cosine that stands": (
        """
sphere A: mass 2m, velocity u i + 2u j
sphere B: mass 3m, velocity -2u i - u j
A hits B: along i, e = 2/3
let theta = angle(velocity(A), velocity(B))
find cos(theta), theta
""",
        ("cos θ", "θ = 135°"),
        ("tan",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_no_sense_is_left_open(name: str) -> None:
    statement, said, unsaid = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for each in said:
        assert each in text, text
    for each in unsaid:
        assert each not in text, text
