"""Workings as a mark scheme sets them out: what each has to say, and in which order.

The values are worked out by hand, beside each statement.
"""

from __future__ import annotations

import re
from functools import cache

import pytest
from workings import planned

from restitution.explaining.awarding.awards import awarded, marks_of
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W{e}
"""
REST = """
sphere A: mass m, velocity u at alpha
sphere B: mass {m}, at rest
A hits B: along i{e}
"""
CORNER = """
wall X: along i
wall Y: along j
sphere P: mass m, velocity u at alpha to X
P hits X: e = e
P hits Y: e = {f}
"""

# Statement, and what its working says, in this order.
SAYS = {
    # cos²α + e² sin²α lost: (1 − e²) sin²α = 1/4, so sin²α is least for e = 0.
    "a bound of a square rests on a square that is not negative": (
        WALL.format(e="") + "given energy_lost = 1/4 energy(0)\nshow alpha >= 30°",
        ["sin²α ≥ ¼, as e² ≥ 0", "sin α ≥ ½, as α is acute", "α ≥ 30°"],
    ),
    # Of 25 J a quarter is lost: e² = 39/64.
    "a share that is given is not found again": (
        WALL.format(e="").replace("u at alpha to W", "3i - 4j").replace("mass m", "mass 2")
        + "given energy(P) = 3/4 energy(0)\nfind e, energy(P), energy_lost",
        [
            "kinetic energy of P after the impact = ¾ × 25 = 75/4 J",
            "kinetic energy lost = 25 − 75/4 = 25/4 J",
        ],
    ),
    # The loss is mu²(1 − e²)/16.
    "an inequality shows what cannot be": (
        REST.format(m="m", e="").replace("alpha", "60°")
        + "given energy_lost > 1/16 m u^2\nfind range of e",
        ["mu²(1 − e²)/16 > mu²/16", "e² < 0", "This cannot be, as a square is not negative."],
    ),
    # 27 > 7k² - 4k + 16.
    "a factor that goes out of an inequality is positive": (
        REST.format(m="k m", e=", e = 1/2").replace("alpha", "30°")
        + "given speed(B) > speed(A)\nfind range of k",
        ["(1 + k)(7k − 11) < 0", "k < 11/7, as 1 + k > 0"],
    ),
    # Which way P comes is open: 𝐭 leads along the wall as its direction is given.
    "a unit vector along a wall has the direction that is given": (
        WALL.format(e="")
        .replace("along i", "along 4i + 3j")
        .replace("u at alpha to W", "a i + b j")
        + "find speed(P)",
        ["𝐭 = (4𝐢 + 3𝐣)/5 one parallel to W", "(4a + 3b)/5"],
    ),
    # So it has in a velocity before the impact that its components make.
    "a velocity before an impact has the unit vector along the wall in one sense": (
        """
wall W: along 4i + 3j
sphere P: mass 2
P hits W: e = 1/4
given velocity(P) = -i + 18j
find velocity(P, 0)
""",
        ["𝐭 = (4𝐢 + 3𝐣)/5", "𝐮_P = −60((−3𝐢 + 4𝐣)/5) + 10((4𝐢 + 3𝐣)/5)", "(44𝐢 − 42𝐣)"],
    ),
    # Of one impact nothing is lost besides.
    "what one impact loses is not called a total": (
        WALL.format(e="") + "find total_energy_lost",
        ["Kinetic energy lost, by the component that changes:", " kinetic energy lost = ½m("],
    ),
    # e = 1/2 in tan β = e tan α.
    "a later part puts its values into a tangent that is shown": (
        WALL.format(e="")
        + "part a\nshow tan(angle(velocity(P), W)) = e tan(alpha)\n"
        + "part b\ngiven e = 1/2, alpha = 45°\nfind angle(velocity(P), W)",
        ["= e tan α", "Since e = ½ and α = 45°, from (1):", "tan β = ½", "arctan(1/2)"],
    ),
    "a later part puts its values into a velocity that stands": (
        REST.format(m="k m", e="").replace("u at alpha", "u i + u j")
        + "part a\nfind velocity(B)\npart b\ngiven e = 1/2, k = 2\nfind velocity(B)",
        ["𝐯_B = ((1 + e)u/(1 + k))𝐢", "Since e = ½ and k = 2, from (3):", "𝐯_B = (u/2)𝐢"],
    ),
    "a later part puts in a tangent that is given": (
        REST.format(m="m", e="")
        + "part a\nshow tan(direction(A)) = 2 tan(alpha)/(1 - e)\n"
        + "part b\ngiven e = 1/2, tan(alpha) = 1/2\nfind direction(A)",
        [
            "= 2 tan α/(1 − e)   (as required), and θ = 90° if e = 1   (4)",
            "Since e = ½ and tan α = ½, from (4):",
            "tan θ = 2",
            "θ = arctan 2",
        ],
    ),
    # v_A = ((5 − 3e)i − √3(1 + e)j)u/8.
    "a deflection from i in letters is read off the velocity": (
        REST.format(m="m", e=", e = e").replace("along i", "offset a").replace("u at alpha", "u i")
        + "sphere A, B: radius a\nfind velocity(A), deflection(A)",
        ["A came in the direction of 𝐢", "√3(1 + e)/(5 − 3e)"],
    ),
    # 2mu cos α − mu = mw and w = e(u cos α + u).
    "a cosine of letters is solved for": (
        REST.format(m="m", e="")
        .replace("at rest", "velocity -u i")
        .replace("A: mass m", "A: mass 2m")
        + "given velocity(A) perpendicular to i\nfind cos(alpha) in terms of e",
        ["2 cos α − 1 = e cos α + e", "cos α = (1 + e)/(2 − e)"],
    ),
    # tan β = e tan α.
    "a tangent that is asked says where its angle is a right one": (
        WALL.format(e="") + "find tan(deflection(P)) in terms of e, alpha",
        ["(1 + e) tan α/(1 − e tan²α), and δ = 90° if e tan²α = 1"],
    ),
    # v + 2w = 3 and w - v = 1.
    "a mass stands before the change of velocity": (
        REST.format(m="2m", e=", e = 1/3").replace("u at alpha", "3i") + "find impulse",
        ["magnitude of the impulse = 2m × (4/3) = 8m/3"],
    ),
    # tan β = 3e/4 and tan 60° = √3.
    "a known tangent is put in beside the other": (
        WALL.format(e="") + "given deflection(P) = 60°, tan(alpha) = 3/4\nfind e",
        ["Since tan α = ¾, substituting for tan β:", "(¾ + 3e/4)/(1 − 9e/16) = √3"],
    ),
    # cos²α = 3/(8(1 − e²)) ≥ 3/8.
    "an angle has the end that the bound of its ratio gives": (
        REST.format(m="2m", e="") + "given energy_lost = 1/4 energy(0)\nfind range of alpha",
        ["cos²α ≥ ⅜, as e² ≥ 0", "cos α ≥ √6/4, as α is acute", "α ≤ arccos(√6/4)"],
    ),
    # cos²α + e² sin²α = 1/2, so tan²α = 1/(1 − 2e²).
    "what stands below a line is positive": (
        WALL.format(e="") + "given speed(P) = u/sqrt(2)\nfind range of e",
        [
            "tan²α = 1/(1 − 2e²)",
            "1/(1 − 2e²) > 0, as tan²α > 0",
            "e² < ½",
            "0 ≤ e < √2/2",
        ],
    ),
    # (u cos α)² = e (u sin α)².
    "a root is taken for a printed form": (
        WALL.format(e="") + "given deflection(P) = 90°\nshow tan(alpha) = 1/sqrt(e)",
        ["tan²α = 1/e", "tan α = 1/√e, as α is acute"],
    ),
    # v = (1 − e)u cos α/2: tan θ = (1 + e)t/(1 − e + 2t²), with e = 2/3 it is 5t/(1 + 6t²).
    "a greatest deflection that the statement names": (
        REST.format(m="m", e="")
        + "let theta = deflection(A)\npart a\n"
        + "show tan(theta) = (1 + e) tan(alpha)/(1 - e + 2 tan^2(alpha))\n"
        + "part b\ngiven e = 2/3\nfind maximum of deflection(A) over alpha",
        [
            "Since e = ⅔, from (3):\n    tan θ = 5 tan α/(1 + 6 tan²α)",
            "S ≥ 2√6",
            "tan θ ≤ 5√6/12",
            "greatest value of θ = arctan(5√6/12)",
        ],
    ),
    # 3t/(1 + 4t²) = 3/(1/t + 4t), and 1/t + 4t is at least 4.
    "a quotient is bounded before its angle is": (
        REST.format(m="m", e=": e = 1/2".replace(":", ","))
        + "let theta = deflection(A)\npart a\n"
        + "show tan(theta) = 3 tan(alpha)/(1 + 4 tan^2(alpha))\n"
        + "part b\nshow theta <= arctan(3/4)",
        ["tan θ = 3/(1/tan α + 4 tan α)", "S ≥ 4", "tan θ ≤ ¾", "θ ≤ arctan(3/4)"],
    ),
    # v = −(4e − 1)u cos α/5: A is sent back.
    "a deflection in letters that may be obtuse": (
        REST.format(m="4m", e="") + "given e > 1/4\nfind deflection(A) in terms of alpha, e",
        [
            "A is sent back",
            "δ = 180° − α − β = 180° − α − arctan(5 tan α/(4e − 1))",
        ],
    ),
    # tan β = tan α/3 and tan α tan β = 1.
    "two angles with the sum 90°": (
        WALL.format(e=": e = 1/3")
        + "let beta = angle(velocity(P), W)\ngiven alpha + beta = 90°\nfind alpha",
        ["Since α + β = 90°:\n    tan α tan β = 1", "tan²α = 3", "α = 60°"],
    ),
    # tan β = tan α/3 with α = 2β: 1 − tan²β = 2/3.
    "an angle that is twice another": (
        WALL.format(e=": e = 1/3")
        + "let beta = angle(velocity(P), W)\ngiven alpha = 2 beta\nfind beta",
        ["Since α = 2β, by the formulae for the double angle:", "tan α = √3", "β = 30°"],
    ),
    "a velocity that is a multiple of another is parallel to it": (
        CORNER.format(f="e") + "show velocity(P) parallel to velocity(P, 0)",
        ["= −e𝐮", "So 𝐯₂ is parallel to 𝐮, as required."],
    ),
    # v₁ = (2 − e)u and v₂ = 2(1 + e)(1 − 4e)u/5: their difference is (8 + e + 8e²)u/5.
    "a condition that always holds": (
        (
            "sphere A: mass 2m, velocity 3u i\nsphere B: mass m, at rest\n"
            "sphere C: mass 4m, at rest\nA hits B: along i\nB hits C: along i\n"
            "given A and B collide again\nfind range of e"
        ),
        ["(2 − e)u > 2(1 + e)(1 − 4e)u/5", "8 + e + 8e² > 0", "This always holds", "0 ≤ e ≤ 1"],
    ),
    # f²cos²α + e²sin²α is e².
    "an angle of the data that goes": (
        CORNER.format(f="f") + "given total_energy_lost = 1/2 energy(0), f = e, e > 0\nfind e",
        [
            "½m((eu cos α)² + (eu sin α)²)",
            "= ½e²mu², as sin²α + cos²α = 1",
            "½mu²(1 − e²) = ½ × ½mu²",
            "e² = ½",
            "e = √2/2",
        ],
    ),
    # e = q/p, and (1 − e²)p² = (p² + q²)/4.
    "a root that the signs of letters exclude": (
        (
            "sphere A: mass m, velocity p i + q j\nsphere B: mass m, velocity -p i + q j\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B), p > 0, q > 0\n"
            "given energy_lost = 1/4 energy(0)\nfind e\nfind p in terms of q"
        ),
        ["e = √15/5", "p = √15 q/3 ≈ 1.29q, as p > 0 and q > 0"],
    ),
    # q² = e²p², and 4(1 − e²)p² = p² + q².
    "two letters of which only the ratio is known both go": (
        (
            "sphere A: mass m, velocity p i + q j\nsphere B: mass m, velocity -p i + q j\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B), p > 0, q > 0\n"
            "given energy_lost = 1/4 energy(0)\nfind e"
        ),
        ["p² = q²/e²", "which is not zero as q > 0", "e² = ⅗", "e = √15/5 ≈ 0.775, as e ≥ 0"],
    ),
    # w = 2 + 4e is 4, and 8m − 2m = 2mv + 4m.
    "what a letter is by now stands before it is put in": (
        (
            "sphere A: mass 2m, velocity 4i + 3j\nsphere B: mass m, velocity -2i + 3j\n"
            "A hits B: along i\npart a\nfind velocity(B)\n"
            "part b\ngiven e = 1/2\nfind velocity(A)"
        ),
        [
            "(b)",
            "Since e = ½, with w = 2 + 4e from part (a):\n    w = 4",
            "4 − v = ½(4 + 2)",
            "v = 1",
        ],
    ),
    # 9 = 3(w + 2) gives w = 1, and the two laws v and x.
    "a component of the data by an impulse": (
        (
            "sphere A: mass 2, velocity x i + 3j\nsphere B: mass 3, velocity -2i + j\n"
            "A hits B: along i, e = 1/2\ngiven impulse = 9, x > 0\nunknown x\nfind x"
        ),
        ["9 = 3(w + 2)", "w = 1 m s⁻¹", "x = 3"],
    ),
    "the size of an impulse that is known as a vector": (
        (
            "wall W\nsphere P: mass 0.5, velocity 6i + 2j\nP hits W\n"
            "given velocity(P) = 2i + 5j\nfind impulse(P), impulse"
        ),
        ["(−2𝐢 + 1.5𝐣) N s", "√(2² + 1.5²) = 2.5 N s"],
    ),
    # 15 = 16(1 - e²).
    "an answer of an earlier part stands again": (
        (
            "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\n"
            "given energy_lost = 15\npart a\nfind velocity(P)\npart b\nfind e\n"
            "part c\nfind deflection(P)"
        ),
        [
            "e = ¼",
            "Substituting in (1):\n    component of 𝐯_P along 𝐣 = 1",
            "(b)\n\nFrom part (a):\n    e = ¼",
            "(c)",
            "by the scalar product, with 𝐯_P\nfrom part (a):",
            "cos δ = (3 × 3 − 4)/(√(3² + 4²)√(3² + 1²)) = √10/10",
        ],
    ),
    # tan²α = 1/e, so sin²α = 1/(1 + e): (1 − e²)/(1 + e) is 1 − e.
    "an answer in letters that the solution has by others": (
        WALL.format(e="")
        + "given deflection(P) = 90°\npart a\nshow tan^2(alpha) = 1/e\n"
        + "part b\nfind energy_lost in terms of m, u, e\n"
        + "part c\nfind speed(P) in terms of u, e",
        [
            "(b)\n\nFrom (1):\n    sin²α = 1/(1 + e)\n    cos²α = e/(1 + e)",
            "= ½(1 − e)mu²",
            "(c)",
            "= u√e",
        ],
    ),
    # tan β = e tan 50°.
    "sines and cosines of degrees": (
        (
            "wall W: along i\nsphere P: velocity 12 at 50° to W\nP hits W: e = 0.6\n"
            "find speed(P), deflection(P)"
        ),
        [
            "√((7.2 sin 50°)² + (12 cos 50°)²) ≈ 9.48",
            "tan β = (7.2 sin 50°)/(12 cos 50°) = 0.6 tan 50°",
            "δ = 50° + β ≈ 50° + 35.57°",
        ],
    ),
    # v = u is needed for the third impact only, and stands with w.
    "both components after an impact are solved in one place": (
        """
sphere A, B: mass m
sphere C: mass 2m, at rest
sphere A: velocity 4u i
sphere B: at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
find velocity(B)
A hits B: along i, e = 1/2
find velocity(A)
""",
        ["First impact", "w₁ = 3u", "v₁ = u", "Second impact", "Third impact"],
    ),
    "an impulse between two impacts has a heading": (
        """
wall W: along i
sphere P: mass 2, velocity 3i - 4j
P hits W: e = 1/2
P receives -8i - 12j
P hits W: e = 1/2
find velocity(P)
""",
        ["First impact: P hits W", "Impulse given to P", "Second impact: P hits W"],
    ),
    # tan θ = −2 − √3 for 105° and for −75°.
    "a direction beyond 90° has the sign of its component": (
        """
sphere A: mass m, velocity 2u at 30°
sphere B: mass 2m, velocity u at 120°
A hits B: along i
given deflection(B) = 60°
find e, direction(A)
""",
        ["tan θ = ", "θ = 105°, as v < 0"],
    ),
    "a direction beyond 90° has that of a velocity put together": (
        """
wall C: circle centre (0, 0) radius a
sphere P: at (a/2, 0), velocity u at 90°
P hits C: e = 1/2
find direction(P)
""",
        ["= −(3√3 u/8)𝐢 − (u/8)𝐣", "≈ −169°, as 𝐯_P has a negative 𝐢-component"],
    ),
    "a direction that the statement has a letter for has its reason": (
        """
sphere A: mass 2, velocity 3i - 2j
sphere B: mass 8, velocity -5i + j
B hits A: along i, e = 1/2
let theta = direction(B)
find theta
""",
        ["tan θ = 1/(−13/5) = −5/13", "≈ 159°, as v < 0"],
    ),
    "a tangent by the direction across the line of centres says so": (
        """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along beta, e = 1
given direction(A) = -60°
find beta
""",
        [
            "v = 0",
            "A moves perpendicular to the line of centres, where its component is −u sin β:",
            "angle from 𝐢 to 𝐯_A = β − 90°",
            "β − 90° = −60°",
        ],
    ),
    "a side that the question leaves open is taken as one of two": (
        """
sphere A: mass m, velocity 3u i, radius a
sphere B: mass 4m, velocity -u i, radius a
A hits B: offset 6/5 a
given deflection(A) = 90°
find e
""",
        ["the centre of B is 6a/5 from the\npath of A, say to the left of it. So"],
    ),
    "a side that the question tells is that of the working": (
        """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset -a, e = 1/2
find velocity(B)
""",
        ["the centre of B is a to the right of\nthe path of A. So"],
    ),
    "a tangent over the size of a component says where the angle is a right one": (
        """
wall AB: along i
wall BC: along 120°
sphere P: velocity u at alpha to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find tan(angle(velocity(P), BC))
""",
        ["as α is acute, and β = 90° if tan α = 2√3/3"],
    ),
    "a right angle where two components cancel": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity u at 180° - beta
A hits B: along i, e = e
find tan(angle(velocity(A), line_of_centres))
""",
        ["and θ = 90° if (2e − 1) cos α + 2(1 + e) cos β = 0"],
    ),
    "what is asked once more is said once more, where it stands far above": (
        """
sphere P: mass 2, velocity 3i
wall W: along i
P receives 2i - 8j
find velocity(P), energy(P)
P hits W: e = 1/2
find velocity(P), velocity(P, before)
""",
        ["𝐯₂ = (4𝐢 + 2𝐣) m s⁻¹", "From above:", "𝐯₁ = (4𝐢 − 4𝐣) m s⁻¹"],
    ),
    "where a greatest value is reached is an angle in degrees": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1/3
find maximum of deflection(A) over alpha
""",
        ["greatest value of δ = arctan(4/3)", "when 1 − 3 tan α = 0, so tan α = ⅓ and α ≈ 18.4°"],
    ),
    # v = (1 - k)u/3 is u/2 or -u/2 only for k < 0: so e = 1/2 and u/4.
    "of several values it is said that all are possible": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
            "A hits B: along i, e = 1/2\ngiven speed(A) = u/4\nfind k"
        ),
        ["1 + k = ±2(2 − k)", "k = 5 or k = 1\n", "(both are possible, as both are positive)"],
    ),
    # mu²/2 - 3mu²/16 is 5mu²/16; of all 37.5 % is lost.
    "a percentage is called so, and what is left is what was there less what is lost": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = 1/2\n"
            "find energy_lost/energy(0) as a percentage, energy(A), energy"
        ),
        [
            "Percentage of the kinetic energy that is lost:",
            "total kinetic energy after the impact = ½mu² − 3mu²/16",
        ],
    ),
    "masses of 1 kg are said to be these, as no line has them": (
        (
            "sphere A: mass 1, velocity 3i\nsphere B: mass 1, at rest\nA hits B: along i, e = 1/3\n"
            "find velocity(A)"
        ),
        [
            "Conservation of momentum along the line of centres, as both masses are 1 kg:",
            "3 = v + w",
        ],
    ),
    # A stops: 2u = 2v + 4w and w - v = u/2.
    "who is at rest does not come back, and 0 is compared with nothing": (
        (
            "wall W: along j, through (0, 0)\nsphere A: mass 2m, at (a, 0), velocity u i\n"
            "sphere B: mass 4m, at (3a, 0), at rest\nA hits B: along i, e = 1/2\n"
            "show A will not hit W"
        ),
        ["not move towards W.\n    v = 0\n", "So A will not hit W, as required."],
    ),
    "a greatest value at an angle that is known by heart": (
        REST.format(m="m", e=", e = 1/3") + "find maximum of deflection(A) over alpha",
        ["greatest value of δ = 30°, when 1 − √3 tan α = 0, so α = 30°"],
    ),
    "a tangent of an earlier part has the angle of its own put in": (
        REST.format(m="m", e="")
        + """part a
show tan(deflection(A)) = (1 + e) tan(alpha)/(1 - e + 2tan^2(alpha))
part b
given alpha = 45°
find range of deflection(A)""",
        [
            "Since α = 45°, from (3):",
            "tan δ = (1 + e)/(3 − e)",
            "⅓ ≤ tan δ ≤ 1",
            "as (1 + e)/(3 − e) increases with e and 0 ≤ e ≤ 1",
            "arctan(1/3) ≤ δ ≤ 45°, as tan δ > 0 and so δ is acute",
        ],
    ),
    # B comes back with (1 + e)u/5, and 3e - 2 < 1 + e.
    "what holds anyway is said of a further condition, in a part of its own": (
        """
sphere A: mass 2m, velocity u i
sphere B: mass 3m, at rest
wall W: along j
A hits B: along i
part a
given velocity(A) opposite to i
find range of e
B hits W: e = 1/2
part b
given velocity(A, 1) opposite to i, A and B collide again
find range of e
""",
        [
            "(b)",
            "In the direction of 𝐢, A is behind B, so they collide again if the component of\n",
            "A is greater than that of B. (2 − 3e)u/5 > −(1 + e)u/5 in any case, as e ≤ 1.",
            "⅔ < e ≤ 1",
        ],
    ),
    "equal velocities are said to be equal": (
        """
sphere P: mass 4m, velocity u i
sphere Q: mass 2m, at rest
sphere R: mass m, at rest
P hits Q: along i, e = 1/2
Q hits R: along i, e = 1/2
show P and Q do not collide again
""",
        ["v₁ = u/2 = v₂", "So P and Q will not collide again, as required."],
    ),
    "a place at a time is one before the next wall": (
        """
wall L: along j, through (0, 0)
wall R: along j, through (6, 0)
sphere P: at (2, 0), velocity -3i + j
P hits L: e = 1/3
find position(P, at 4)
""",
        ["= ((10/3)𝐢 + 4𝐣) m", "and P has not reached R by then, as 10/3 < 6"],
    ),
    "an inequality is divided by what is positive": (
        """
wall W1: along i
wall W2: along j
sphere P: mass m, velocity u at alpha to W1
P hits W1: e = e
P hits W2: e = 1/2
given energy(P) <= 1/4 energy(P, 0)
find range of e
""",
        [
            "(4e² − 1) sin²α ≤ 0",
            "Dividing by sin²α, which is positive as α is acute:",
            "4e² − 1 ≤ 0",
            "e² ≤ ¼",
            "0 ≤ e ≤ ½",
        ],
    ),
    "a direction beyond 90° is that of a negative component": (
        REST.format(m="3m", e="") + "given direction(A) > 90°\nfind range of e",
        [
            "is more than 90°, so 𝐯_A has a negative\ncomponent along 𝐢:",
            "¼(1 − 3e)u cos α < 0",
            "⅓ < e ≤ 1",
        ],
    ),
    "who was at rest has the direction of the line of centres": (
        """
sphere A: mass m, velocity u i, radius r
sphere B: mass 2m, at rest, radius r
A hits B: offset 1, e = 1
given direction(B) = 30°
find r
""",
        ["B was at rest, so it moves along the line of centres:", "φ = 30°"],
    ),
    "a velocity that points back has the sign below the line": (
        """
sphere A: mass 1, velocity 10i, radius 1
sphere B: mass 4, at rest, radius 1
A hits B: offset 6/5, e = 1
find velocity(A), deflection(A)
""",
        ["tan δ = 7.68/(−0.24)"],
    ),
    "a bound of cos 2α names the formula": (
        WALL.format(e=": e = 2/3")
        + "given energy_lost/energy(0) >= 20%\nfind range of sin(alpha), range of cos(2alpha)",
        ["⅗ ≤ sin α < 1", "−1 < cos 2α ≤ 7/25, as cos 2α = 1 − 2 sin²α and α is acute"],
    ),
    "a root that has to be real says why it is": (
        REST.format(m="k m", e="") + "given e k < 1\nfind maximum of tan(deflection(A)) over alpha",
        ["√(1 − ek)√(1 + k)", "as ek < 1"],
    ),
    # cos δ = (v + 4u)/(√5 √(v² + 4u²)) is negative for v = −14u.
    "a root that comes of squaring is none of the line that was squared": (
        """
sphere A: mass m, velocity u i + 2u j
sphere B: mass m, velocity -3u i
A hits B: along i
given cos(deflection(A)) = 1/sqrt(10)
find e
""",
        ["(1)", "v = −2u or v = −14u", "v = −2u, as v = −14u does not satisfy (1)", "e = ½"],
    ),
    "a root is chosen by the direction of motion that is given": (
        """
sphere A: mass 3m, velocity 2u i
sphere B: mass 2m, velocity -5u i
A hits B: along i
given velocity(A) opposite to i, speed(A) = 11/5 u
find e
""",
        ["11u/5 = −v, as A moves in the direction of −𝐢", "v = −11u/5", "e = ½"],
    ),
    "an inequality divided by a coefficient says that it is positive": (
        REST.format(m="k m", e="") + "given along(velocity(A), i) < 0\nfind range of k",
        ["1 − ek < 0, as α is acute", "k > 1/e, as e > 0"],
    ),
    "the size of a component in letters rests on the angles": (
        """
wall AB: along i
wall BC: along 180° - phi
sphere P: velocity u at alpha to AB
P hits AB: e = e
P hits BC: e = e
find tan(angle(velocity(P, 2), BC))
""",
        ["|1 − e tan α tan φ|", "as α and φ are acute"],
    ),
    "a sphere that goes on is told by the value of its component": (
        """
wall W: along j
sphere A: mass m, velocity u i
sphere B: mass 3m, at rest
A hits B: along i, e = 1/2
show B will hit W
show A will not hit W
""",
        ["w = 3u/8 > 0", "v = −u/8 < 0"],
    ),
    "components have one notation in the whole working": (
        """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along 30°, e = 1
A hits C: along -30°, e = 1
find velocity(A)
""",
        ["𝐮_A · 𝐧₁ = u cos 30°", "𝐯_A1 · 𝐧₂"],
    ),
    "places have one notation in the whole working": (
        """
wall L: along j, through (0, 0)
wall R: along j, through (6, 0)
sphere P: at (2, 0), velocity 3i + j
P hits R: e = 2/3
find position(P)
P hits L: e = 1/2
find position(P, at 10)
""",
        ["= (6𝐢 + (4/3)𝐣) m", "= ((17/3)𝐢 + 10𝐣) m"],
    ),
}

# What no such working says.
NEVER = {
    "a condition that the question asks for as a range": (
        """
sphere A: mass 3m, velocity u at alpha
sphere B: mass m, velocity v at alpha from -i
A hits B: along i
given velocity(A) perpendicular to i
find e in terms of u, v
find range of u/v
""",
        "this holds for",
    ),
    "a condition that a later part asks for as a range": (
        """
wall W1: along i
wall W2: along i
sphere P: velocity u at 60° to W1
P hits W1: e = e1
P hits W2: e = e2
given angle(velocity(P), W2) = 30°
part a
find e1 e2
part b
unknown e2
find range of e1
""",
        "this holds for",
    ),
    "a tangent along a line of centres twice": (
        """
sphere A, B: radius 0.1
sphere A: at (0, 0), velocity 2i
sphere B: at (0.72, 0.12), mass m, at rest
sphere A: mass m
A hits B: e = 0.9
find direction(B)
""",
        "¾ = 0.75",
    ),
    "a component that is to be shown": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass m, velocity v at beta from -i\n"
            "A hits B: along i, e = 1\nshow along(velocity(A), i) = -v cos(beta)"
        ),
        "Components along the axes",
    ),
    "what only a later part needs": (
        (
            "sphere A: mass 2, velocity 5i - 2j\nsphere B: mass 4, velocity -i + 2j\nA hits B\n"
            "given velocity(A) = -i + 2j\npart a\nfind velocity(B)\npart b\nfind e"
        ),
        "𝐣)) m s⁻¹\n\n(b)",
    ),
}


@cache
def text(statement: str) -> str:
    """The working of a statement that the follower accepts, as text without line ends in it."""
    problem, derivation = planned(statement)
    return to_text(explanation_of(awarded(derivation), problem))


def without_marks(working: str) -> str:
    """A working without its column of marks, and with rows that were broken in one line."""
    plain = re.sub(r" {2,}(D?[MAB]\d\S*( |$))+", "", working, flags=re.MULTILINE)
    return re.sub(r" {2,}(?==|as )", " ", plain)


@pytest.mark.parametrize("name", SAYS)
def test_it_says_what_a_mark_scheme_says(name: str) -> None:
    statement, phrases = SAYS[name]
    working, at = without_marks(text(statement)), 0
    for phrase in phrases:
        found = working.find(phrase, at)
        assert found >= 0, f"{phrase!r} is not in\n{working[at:]}"
        at = found + len(phrase)
    assert "not written out" not in working


@pytest.mark.parametrize("name", NEVER)
def test_it_has_no_needless_line(name: str) -> None:
    statement, phrase = NEVER[name]
    assert phrase not in text(statement)


def test_what_only_a_later_part_needs_stands_there() -> None:
    statement, _ = NEVER["what only a later part needs"]
    first, _, second = text(statement).partition("(b)")
    assert "·" not in first
    assert second.count("𝐯_A ·") == 1


def test_a_part_whose_answer_stands_already_has_a_mark() -> None:
    statement, _ = SAYS["an answer of an earlier part stands again"]
    _, derivation = planned(statement)
    assert marks_of(awarded(derivation))["b"] == 1


def test_data_beside_those_that_are_needed_agree() -> None:
    statement = """
wall W: along i, through (0, 0)
sphere P: mass 2, at (0, 4), velocity u at 30° to W
P hits W: e = 1/2
given time(1) = 2, impulse = 6
find u
"""
    working = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "u = 4" in working
    assert "It is also given that the magnitude of the impulse is 6 N s, which agrees" in working


# f = (19 - 8e)/(8(1 + e)) is at most 1 for e >= 11/16, and at least 3/8 wherever e <= 1.
def test_a_bound_that_makes_no_end_of_a_range_holds_there() -> None:
    statement = """
sphere A: mass 4m, velocity u i
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = e
B hits C: along i, e = f
given velocity(C) = 3/2 u i
find f in terms of e
find range of e
"""
    working = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "11/16 ≤ e ≤ 1" in working
    assert working.endswith("In this range f ≥ 0 as well, as 19 − 8e > 0.")


def test_a_time_has_the_letter_of_the_statement_and_a_ratio_of_times_is_a_quotient() -> None:
    text = """
wall L: along i, through (0, 0)
wall R: along i, through (0, d)
sphere P: at (0, d/3), velocity u at theta
P hits R: e = e
P hits L: e = e
let T = time(2)
find T, (time(2) - time(1))/time(1)
"""
    words = to_text(explain(solve(parse(text))), 80)
    assert "t₂" not in words
    assert words.count(" T = ") == 1
    assert "Dividing (2) by (1):" in words


def test_an_answer_that_needs_another_letter_says_so_in_words() -> None:
    statement = REST.format(m="2m", e="") + "find speed(A), speed(B) in terms of e, alpha"
    working = " ".join(to_text(explain(solve(parse(statement)))).split())
    reason = "cannot be found, as the answer depends on u, and cannot be given in terms of"
    assert reason in working


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        (
            WALL.format(e="").replace("mass m", "mass 0.5")
            + "given speed(P) = 1/2 speed(P, 0)\nfind e in terms of alpha",
            "It is given that the speed of P is ½ of the speed of P before the impact",
        ),
        (
            WALL.format(e=": e = 1/2")
            .replace("along i", "along theta")
            .replace("u at alpha to W", "2u i - u j")
            + "find velocity(P)",
            "+ u(2 cos θ − sin θ) cos θ)𝐢",
        ),
    ],
)
def test_figures_stay_as_they_are_given(statement: str, words: str) -> None:
    assert words in " ".join(to_text(explain(solve(parse(statement)))).split())


def test_letters_for_components_come_after_the_line_of_centres_that_is_found() -> None:
    own = text("""
        sphere A, B: mass m, radius r
        sphere A: velocity u i
        sphere B: at rest
        A hits B: offset r, e = 1/2
        find speed(B)
        """)
    assert own.index("unit vector along the line of centres =") < own.index("Let v and w")


def test_a_sphere_that_was_at_rest_moves_after_its_impact() -> None:
    own = text("""
        sphere A, B: mass m, radius 1
        sphere A: at (0, 0), velocity 5 i
        sphere B: at (6.6, 1.2), at rest
        A hits B: e = 1/2
        find distance(A, B, at 2)
        """)
    assert "stays where it is" not in own
    assert "New position = old position + velocity × time, for B:" in own


def test_motion_in_a_line_says_each_velocity_below_its_component() -> None:
    own = text("""
        sphere A: mass m, velocity u i
        sphere B: mass 2m, at rest
        A hits B: along i, e = 1/2
        find velocity(A), velocity(B)
        """)
    assert "The velocity, from its components" not in own
    assert "𝐯_A = 𝟎" in own


def test_an_angle_is_finished_before_the_speed_is_found() -> None:
    own = text("""
        wall W: along i
        sphere P: mass m, velocity u at alpha to W
        P hits W
        given velocity(P) = 3i + 2j, impulse = 8m
        find u, alpha
        """)
    assert own.index("α = arctan 2") < own.index("u² =")


def test_a_ratio_of_components_is_shown_as_the_spheres_approach() -> None:
    own = text("""
        sphere A: mass m, velocity u i + v j
        sphere B: mass 3m, at rest
        A hits B: along i, e = e
        given velocity(A) perpendicular to velocity(A, 0)
        show v^2/u^2 = (3e - 1)/4
        """)
    assert "not written out" not in own
    assert "v²/u² = (3e − 1)/4" in own and "(as required)" in own


def test_a_velocity_along_the_line_follows_its_component_at_every_impact() -> None:
    own = text("""
        wall W: along j
        sphere A: mass 3m, velocity u i
        sphere B: mass m, at rest
        A hits B: along i, e = 1
        B hits W: e = 1/2
        A hits B: along i, e = 1
        find velocity(A), velocity(B)
        """)
    assert "from its components" not in own
    assert "𝐯_B3 = (9u/8)𝐢" in own


def test_a_title_says_what_a_line_rests_on() -> None:
    """No title stands above a position just below its coordinate, nor is a line spoken of twice."""
    own = text("""
        wall W: along j, through (10, 0)
        sphere P: mass 1, at (0, 0), velocity 3i + 4j
        P hits W: e = 1/3
        find time(1), position(P)
        """)
    assert "from its coordinates" not in own
    in_a_line = text("""
        sphere A: mass m, velocity u i
        sphere B: mass k m, at rest
        sphere C: mass 4m, at rest
        A hits B: along i, e = e
        given velocity(A) = 0
        find e, velocity(B)
        B hits C: along i, e = 1/2
        find speed(C)
        """)
    assert "moves along the line of centres" not in in_a_line
    assert "Since w₁ = u/k:" in in_a_line
    one = text("""
        wall W
        sphere P: mass 1, velocity 4i - 2j
        P hits W
        given velocity(P) = 2i + 2j
        find e
        """)
    assert "Scalar product with 𝐢 − 2𝐣, after the impact:" in one
    difference = text("""
        sphere A: mass 2, velocity 3i + j
        sphere B: mass 1, at rest
        A hits B: along i, e = 1/2
        find velocity(A) - velocity(B)
        """)
    assert "The relative velocity, from its components:" in difference


def test_why_one_of_two_points_of_a_rim_is_struck_and_why_both_values_hold() -> None:
    outside = text("""
        wall C: circle centre (0, 0) radius 1
        sphere P: at (-3, 3/5), velocity u i
        P hits C: e = 1/4
        find position(P)
        """)
    assert "x = ±⅘" in outside
    assert "x = −⅘ m, as P reaches that point first" in outside
    inside = text("""
        wall C: circle centre (0, 0) radius 5
        sphere P: at (3, 0), velocity -2j
        P hits C: e = 3/4
        find position(P)
        """)
    assert "y = −4 m, as P is moving in the direction of −𝐣" in inside
    both = text("""
        wall W
        sphere P: velocity u at alpha to W
        P hits W: e = 1/3
        let beta = angle(velocity(P), W)
        given alpha - beta = arctan(1/2)
        find tan(alpha)
        """)
    assert "(both are possible, as both are positive)" in both
