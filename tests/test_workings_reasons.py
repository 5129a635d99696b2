"""Why a line of a working holds: reasons, steps between, and letters that a reader has met.

The values are worked out by hand, beside each statement.
"""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

REST = """
sphere A: mass m, velocity u at {angle}
sphere B: mass {m}, at rest
A hits B: along i{e}
"""
OFFSET = """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
"""
STOPPED = """
sphere P: mass 2, velocity 3i + 2j
P receives p i + q j
given P at rest
"""
HALF_KNOWN = """
wall W1: along i
wall W2: along i
sphere P: velocity u at 60° to W1
P hits W1: e = e1
P hits W2: e = e2
given angle(velocity(P), W2) = 30°
"""

TABLE = """
wall AB: from (0, 0) to (a, 0)
wall BC: from (a, 0) to (a, 2a)
sphere P: at (0, a/4), velocity u at 45° to AB
P hits AB: e = e1
P hits BC: e = e2
P reaches (0, a)
"""
RIGHT_ANGLE = """
wall W: along j
sphere B: mass m, velocity U at theta
B hits W
given velocity(B) perpendicular to velocity(B, 0)
show tan^2(theta) = e
"""

# Statement, and what its working says, in this order.
SAYS = {
    # mMu²(1 − e²)/(2(m + M)) is between 0 (m → 0) and ½Mu²(1 − e²) (m → ∞).
    "where a value is only approached, and what varies on the way to it": (
        """
sphere A: mass M, velocity u i
sphere B: mass m, at rest
A hits B: along i
find maximum of energy_lost over m, minimum of energy_lost over m, maximum of energy(B) over M
""",
        [
            "kinetic energy lost → ½Mu²(1 − e²)",
            "as m → ∞, so there is no greatest value",
            "increases with m, m > 0 and 0 ≤ e ≤ 1",
            "kinetic energy lost → 0",
            "as m → 0, but m > 0, so there is no least value",
            "kinetic energy of B → ½(1 + e)²mu²",
            "as M → ∞, so there is no greatest value",
        ],
    ),
    # e₂ = 4e₁/(4 − 3e₁), where 4 − 3e₁ ≥ 1; P is at (a, 3e₁a/4), and e₁ ≤ 1.
    "by what an inequality is multiplied, and ends of walls that are out of reach": (
        TABLE + "find e2 in terms of e1\nfind range of e1",
        [
            "4e₁/(4 − 3e₁) ≤ 1",
            "e₁ ≤ 4/7, as 4 − 3e₁ > 0",
            "In this range e₂ ≥ 0 and 3e₁a/4 < 2a as well.",
            "P hits AB between its ends too",
        ],
    ),
    # tan δ = (1 + e)/(3 − 2e), where tan α = ½.
    "an angle of positive tangent is acute": (
        REST.format(angle="alpha", m="m", e="")
        + "given tan(alpha) = 1/2, deflection(A) > 30°\nfind range of e",
        [
            "so δ is acute",
            "tan δ > √3/3, as δ > 30°",
            "(1 + e)/(3 − 2e) > √3/3",
            "(3 + 2√3)e > 3√3 − 3, as 3 − 2e > 0",
        ],
    ),
    # tan β ≤ tan 75°, as β is from 0° to 75°.
    "a given bound of an angle is the end of its range": (
        REST.format(angle="45°", m="m", e="") + "given deflection(A) <= 30°\nfind range of e",
        ["β − 45° ≤ 30°", "β ≤ 75°", "tan β ≤ 2 + √3"],
    ),
    # δ = θ + β, where θ is given as a letter, and tan β = e tan 60° < 1.
    "a letter in degrees is taken from the bound of a deflection": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W\n"
            "given theta = 60°, deflection(P) < 105°\nfind range of e"
        ),
        ["δ = θ + β", "Since θ = 60° and δ < 105°:\n    60° + β < 105°", "β < 45°", "e < √3/3"],
    ),
    # The gap closes if 0 > 2(9 − 2k)u/(9(3 + k)).
    "a sum by which an inequality is multiplied is positive": (
        """
sphere P: mass 2m, velocity u i
sphere Q: mass 3m, at rest
sphere R: mass k m, at rest
P hits Q: along i, e = 2/3
Q hits R: along i, e = 2/3
given Q and P collide again
find range of k
""",
        ["0 > 2(9 − 2k)u/(9(3 + k))", "k > 9/2, as 3 + k > 0"],
    ),
    # sin²α < 1 makes 1/(4(1 − e²)) < 1, where e = 1 is no value.
    "what stands below a line is not zero": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy_lost = 1/4 energy(0)
find sin^2(alpha)
find range of e
""",
        ["1/(4(1 − e²)) < 1", "e² < ¾, as 1 − e² > 0"],
    ),
    # m + M and Me − m are those of tan²α.
    "the sign of the top of a quotient comes before what it makes": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass M, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(A, 0)
show tan^2(alpha) = (M e - m)/(M + m)
show M > m
""",
        ["(Me − m)/(M + m) > 0", "M > m, as Me − m > 0 and e ≤ 1"],
    ),
    # tan α = ⅓ tan 2α.
    "a tangent is divided by as it is not zero": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/3
given angle(velocity(A), i) = 2 alpha
find alpha
""",
        ["Dividing by tan α, which is not zero as α is acute:", "1 − tan²α = ⅔"],
    ),
    # The question says V for the speed of P.
    "a speed has the letter that it has in the question": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
show speed(P)/u <= 1
""",
        ["Speed of P, from its components:\n      V = √((eu sin α)² + (u cos α)²)", "V/u ≤ 1"],
    ),
    # A direction of −60° is not one of 120°.
    "a direction by a tangent has its quadrant": (
        """
sphere A: mass m, velocity 4u i, radius r
sphere B: mass 2m, velocity -u i, radius r
A hits B: offset -r, e = 1/5
find direction(B)
""",
        ["θ = −60°, as 𝐯_B has a positive 𝐢-component"],
    ),
    # v = (1 − ek)u cos α/(1 + k) is zero for k = 1/e.
    "a place that is missing for one coefficient is said to be": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
find minimum of speed(A) over k
""",
        ["when k = 1/e", "This holds for e > 0 only, as there is no such k otherwise."],
    ),
    "a condition is not a reason too": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) < 0
find range of k
""",
        ["k > 1/e  ", "This holds for e > 0 only"],
    ),
    "of two at right angles each is named": (
        """
sphere A: mass m, velocity v i, radius R
sphere B: mass m, at rest, radius R
A hits B: offset R, e = 1
find angle(velocity(A), velocity(B))
""",
        ["B moves along the line of centres, and A at right angles to it:\n"],
    ),
    "an angle that has a tangent is not 90°": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
show angle(velocity(P), W) <= alpha
""",
        ["as 0° ≤ β < 90° and α is acute"],
    ),
    # tan²θ = e: the loss is ½mU² cos²θ (1 − e²), with cos²θ = 1/(1 + e).
    "the squares of sine and cosine come of that of the tangent": (
        RIGHT_ANGLE + "find energy_lost in terms of m, U, e",
        [
            "tan²θ = e   (as required)   (1)",
            "From (1):\n",
            "cos²θ = 1/(1 + e)",
            "As θ is acute, this holds for e > 0 only.",
        ],
    ),
    # v = (2 − k)u/(2(1 + k)) is u/3 or −u/3.
    "the sides of equal squares are equal or opposite": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
            "A hits B: along i, e = 1/2\ngiven speed(A) = u/3\nfind k"
        ),
        ["(2 − k)u/(2(1 + k)) = ±u/3", "2(1 + k) = ±3(2 − k)", "k = 8 or k = ⅘"],
    ),
    # The ratio is 27(1 − e²)/100.
    "a percentage with which a ratio of energies is compared makes no decimals": (
        REST.format(angle="alpha", m="3m", e="")
        + "given tan(alpha) = 4/3\nshow energy_lost/energy(0) <= 27%",
        ["cos α = ⅗", "≤ 27%"],
    ),
    # 3(1 + e)² = 3(1 − ek)² + (1 + k)²; 2 − k = 3(1 − e)²/(1 + 3e²).
    "a bound that is not seen at once is told by the difference to it": (
        REST.format(angle="30°", m="k m", e="") + "given speed(A) = speed(B)\nfind range of k",
        [
            "3(1 + e)² = 3(1 − ek)² + (1 + k)²",
            "= (1 + 3e²)k² + (2 − 6e)k + 4",
            "(1 + 3e²)k² + (2 − 6e)k + 1 − 6e − 3e² = 0",
            "(k + 1)((1 + 3e²)k + 1 − 6e − 3e²) = 0",
            "k = (3e² + 6e − 1)/(1 + 3e²)",
            "2 − k = 3(1 − e)²/(1 + 3e²)",
            "k ≤ 2\n                               as (1 − e)² ≥ 0, with equality when e = 1",
        ],
    ),
    # tan δ = 3d√(4a² − d²)/(4a² + 3d²), of which the square leaves (3(4a² − 5d²)/(4(…)))² to 9/16.
    "a tangent over an offset is bounded by the angle of the line of centres": (
        OFFSET + "find maximum of deflection(A) over d",
        [
            "tan δ = 3/(1/tan φ + 4 tan φ)",
            "S = (1 − 2 tan φ)²/tan φ + 4",
            "S ≥ 4, as (1 − 2 tan φ)² ≥ 0 and φ is acute",
            "tan δ ≤ ¾",
        ],
    ),
    # v = √2(1 − 2e)u/6 along the line, u/√2 across it.
    "the square that is not negative stands in the line that is cited": (
        REST.format(angle="45°", m="2m", e="") + "show speed(A) >= 1/2 sqrt(2) u",
        ["speed of A ≥ ½√2 u, as (√2(1 − 2e)u/6)² ≥ 0"],
    ),
    # tan δ = 3(1 + e)/(11 − 9e) is at most 1/√3: 3√3(1 + e) ≤ 11 − 9e.
    "terms are collected before a sum with roots divides": (
        REST.format(angle="alpha", m="m", e="")
        + "given tan(alpha) = 1/3, deflection(A) <= 30°\nfind range of e",
        [
            "3(1 + e)/(11 − 9e) ≤ √3/3",
            "(9 + 9√3)e ≤ 11√3 − 9, as 11 − 9e > 0",
            "e ≤ (21 − 10√3)/9",
        ],
    ),
    "at right angles to who moves along the line there is no component": (
        REST.format(angle="45°", m="2m", e="")
        + "given velocity(A) perpendicular to velocity(B)\nfind e",
        [
            "B was at rest, so it moves along",
            "the line of centres, and A perpendicular to it:\n    v = 0",
        ],
    ),
    # v = −(1 + 9e)u/4 and w = (3e − 1)u/4.
    "what always holds has its reason": (
        (
            "sphere A: mass m, velocity 2u i\nsphere B: mass 3m, velocity -u i\nA hits B: along i\n"
            "given velocity(A) opposite to i, velocity(B) in the direction of i\n"
            "find range of e"
        ),
        ["v < 0 in any case, as e ≥ 0."],
    ),
    # w − v = e(…): 14w = −7, as 𝐯_A = 2𝐯_B.
    "a velocity that is a multiple of another gives a component": (
        (
            "sphere A: mass 1, velocity 5i + 2j\nsphere B: mass 12, velocity -i + j\n"
            "A hits B: along i\ngiven velocity(A) = 2 velocity(B)\nfind e"
        ),
        ["𝐯_A = 2𝐯_B, so the component of 𝐯_A along 𝐢 is 2w.", "5 + 12(−1) = 2w + 12w"],
    ),
    "who is brought to rest is named": (
        STOPPED + "find p, q",
        ["It is given that P is at rest afterwards.", "Impulse = change of momentum of P:"],
    ),
    # tan 30° = √3 e₁e₂.
    "a coefficient that divides is not zero": (
        HALF_KNOWN + "part a\nfind e1 e2\npart b\nunknown e2\nfind range of e1",
        ["e₁e₂ = ⅓", "e₁ = 1/(3e₂), as e₂ ≠ 0"],
    ),
    # sin²α + 4e₂² cos²α = 1, and so (4e₂² − 1) cos²α = 0.
    "a factor that sin² + cos² = 1 leaves is not zero": (
        (
            "wall W1: along i\nwall W2: along j\nsphere P: velocity u at alpha to W1\n"
            "P hits W1: e = e1\nP hits W2: e = e2\n"
            "given energy(P) = 1/4 energy(P, 0), e1 = 1/2\nfind e2"
        ),
        ["4e₂² − 1 = 0, as α is acute"],
    ),
    # cos²α = 3/((1 + e)(3 − e)) < 1: 3 < 3 + 2e − e².
    "a bound that is a product of the letter is one before it is solved": (
        REST.format(angle="alpha", m="m", e="")
        + "given speed(A) = u/2\nfind cos(alpha) in terms of e\nfind range of e",
        [
            "e(2 − e) > 0, as 3 − e > 0",
            "e > 0, as 2 − e > 0",
            "0 < e ≤ 1",
        ],
    ),
    # v = (1 − 3e)u cos α/4.
    "why a coefficient that a range bounds is at most 1": (
        REST.format(angle="alpha", m="3m", e="")
        + "given along(velocity(A), i) < 0\nfind range of e",
        ["e > ⅓", "⅓ < e ≤ 1, as e cannot exceed 1"],
    ),
    "why a coefficient that a range bounds is not below 0": (
        REST.format(angle="alpha", m="3m", e="")
        + "given along(velocity(A), i) > 0\nfind range of e",
        ["e < ⅓", "0 ≤ e < ⅓, as e cannot be negative"],
    ),
    # v = (2 − k)u cos α/(2(1 + k)).
    "why a ratio of masses that a range bounds is above 0": (
        REST.format(angle="alpha", m="k m", e=", e = 1/2")
        + "given along(velocity(A), i) > 0\nfind range of k",
        ["k < 2", "0 < k < 2, as k is positive"],
    ),
    # v² = ½u²(1 + cos²α), and not u² cos²α for any acute angle.
    "what is never equal is not denied in general only": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/sqrt(2)\n"
            "show speed(P) = u cos(alpha)"
        ),
        ["The speed of P is not u cos α: it is"],
    ),
    # u²(cos²α + e² sin²α) − e²u² = u²(1 − e²) cos²α, which is positive for e < 1.
    "what is never equal under a given bound is not denied in general only": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given 0 < e < 1\nshow speed(P) = e u"
        ),
        ["The speed of P is not eu: it is"],
    ),
    "a speed of the statement has no components put in": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "show impulse = m speed(P, 0) - m speed(P)"
        ),
        ["    V₁ = u\n"],
    ),
    # cot 0° and cot 180° have no value.
    "a cotangent has a value between its ends alone": (
        (
            "sphere A: mass m, velocity u at 60°\nsphere B: mass k m, at rest\n"
            "A hits B: along i, e = 1/2\ngiven 1 <= k <= 8\n"
            "find range of angle(velocity(A), velocity(B))"
        ),
        ["as the cotangent decreases between 0° and 180° and 0° < β < 180°"],
    ),
    "components of a direction in letters stand before the laws of a slanting wall": (
        (
            "wall W: along i - j\nsphere P: velocity v at theta\nP hits W: e = 1/4\n"
            "given velocity(P) = 3i, 180° < theta < 270°\nfind v, theta"
        ),
        ["Component before the impact:", "= (−v cos θ − v sin θ)/√2", "Parallel to W"],
    ),
    # 4 + M = 1 + 2M and 3 + M = 6.
    "momentum as vectors is compared by its components": (
        (
            "sphere A: mass 1, velocity 4i + 3j\nsphere B: mass M, velocity i + j\nA hits B\n"
            "given velocity(A) = i + 6j, velocity(B) = 2i\nfind M"
        ),
        ["Comparing components, 4 + M = 1 + 2M and 3 + M = 6:", "M = 3"],
    ),
    "who starts from the origin was there at an impact": (
        (
            "wall W: along j, through (6, 0)\nsphere A: mass 2, at (-3, -1), velocity 3i + j\n"
            "sphere B: mass 1, at (0, 0), at rest\nA hits B: along i, e = 1/2\nB hits W: e = 1/2\n"
            "find position(A), distance(A, B)"
        ),
        ["for A, which is at the origin at the first impact:"],
    ),
    "a component of what has been found is written before its value": (
        (
            "sphere A: mass 2m, velocity u at 45°\nsphere B: mass m, velocity v at 135°\n"
            "A hits B: along i, e = 1/2\ngiven direction(B) = 45°\nfind u/v, speed(A)/v"
        ),
        ["of A in the direction of 𝐣 stays u sin 45° = √2 v/2."],
    ),
    # 2(b + 1)b with b = (6a − 13)/3, beside (a − 3)a.
    "a product of sums with fractions is multiplied out by itself": (
        (
            "sphere A: mass 2, velocity a i + b j\nsphere B: mass 3, velocity -i + 2j\nA hits B\n"
            "given impulse(A) = -6i + 3j, e = 1/2\n"
            "given velocity(A) perpendicular to velocity(A, 0)\nfind a"
        ),
        ["a² − 3a + (72a² − 258a + 221)/18 = 0", "90a² − 312a + 221 = 0"],
    ),
    "an item is finished before the next one is begun": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\n"
            "sphere Q: mass m, at rest\nP hits W: e = 1/3\nP hits Q: along j, e = 1\n"
            "find energy(Q)/energy(P, 0)\nfind energy(P) in terms of m, u, alpha\n"
            "given tan(alpha) = 3"
        ),
        ["/(kinetic energy of P at the start) = 1/10", "Substituting for w in (2):"],
    ),
    "ratios of an angle stand under the impact for which they are needed": (
        (
            "wall W: along i\nsphere P: mass 2, velocity 8i - 6j\n"
            "sphere Q: velocity v_Q at alpha to W\ngiven tan(alpha) = 3/4\nP hits W: e = 1/2\n"
            "find impulse\nQ hits W: e = 1/2\nfind speed(Q)"
        ),
        ["Second impact: Q hits W", "sin α = ⅗", "Parallel to W the velocity"],
    ),
    "the square of a coefficient bounds a loss": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given e < 1\nfind maximum of energy_lost over e\n"
            "find maximum of energy_lost/energy(0) over alpha"
        ),
        ["kinetic energy lost ≤ ½mu² sin²α, as e² ≥ 0  ", "as sin²α < 1 for acute α and 0 ≤ e < 1"],
    ),
    "an inequality that is divided has its reasons": (
        (
            "sphere A: mass m, velocity u at alpha\n"
            "sphere B: mass k m, velocity 2u at 180° - alpha\nA hits B: along i\n"
            "let beta = angle(velocity(A), i)\ngiven beta < 90°\nfind range of k in terms of e"
        ),
        ["Since β < 90°, 𝐯_A has a positive 𝐢-component:", "> 0, as α is acute and 1 + k > 0"],
    ),
    "an obtuse angle has a negative tangent": (
        (
            "wall W: along 5i + 12j\nsphere P: mass 2, velocity 13 i\nP hits W: e = 5/12\n"
            "find velocity(P), deflection(P)"
        ),
        ["δ = 180° − arctan(17/7) ≈ 112°, as tan δ < 0"],
    ),
    "an angle of deflection is between the velocities before and after": (
        (
            "wall W: along i\nsphere P: mass 1, velocity 5i - 3j\nP hits W: e = 1/3\n"
            "find velocity(P), deflection(P)"
        ),
        ["Angle between the velocities before and after, by the scalar product:"],
    ),
    "velocities of a scalar product are written out": (
        (
            "sphere A: mass 2m, velocity u i + 2u j\nsphere B: mass 3m, velocity -2u i - u j\n"
            "A hits B: along i, e = 2/3\nlet theta = angle(velocity(A), velocity(B))\n"
            "find cos(theta)"
        ),
        ["By the scalar product of 𝐯_A = −2u𝐢 + 2u𝐣 and 𝐯_B = −u𝐣:"],
    ),
    "by which component a share of the energy is lost at a wall is said": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given energy_lost = q energy(0)\nfind e in terms of alpha, q"
        ),
        ["By the component that changes, dividing by half the mass:"],
    ),
    "who moves along the line of centres was at rest": (
        (
            "sphere A: mass m, velocity u at 45°\nsphere B: mass 3m, at rest\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B)\nfind e"
        ),
        ["B was at rest, so it moves along", "the line of centres, and A perpendicular to it:"],
    ),
    "who takes no part in an impact keeps its velocity": (
        (
            "sphere A: mass m, at (0, 0), velocity u i\nsphere B: mass m, at (d, 0), at rest\n"
            "sphere C: mass 3m, at (2d, 0), at rest\nA hits B: along i, e = 1/2\n"
            "B hits C: along i, e = 1/2\nA hits B: along i, e = 1/2\n"
            "find velocity(A), velocity(C)"
        ),
        ["C takes no part in the third impact, so its velocity is still:"],
    ),
    "a part of an angle leaves a factor positive": (
        (
            "wall W: along i\nsphere P: velocity u at theta to W\nP hits W\n"
            "given angle(velocity(P), W) = theta/3\nfind range of e"
        ),
        ["e < ⅓, as 3 − tan²(θ/3) > 0, because θ is acute"],
    ),
    "components along the axes stand in their order": (
        (
            "point N: (4, 3)\nwall W: along i, through (0, -2)\n"
            "sphere A: mass 1, at (-3, 0), velocity 6i\nsphere B: mass 1, at (0, 0), at rest\n"
            "A hits B: along 4i + 3j, e = 1/2\nA hits W: e = 1/2\nfind time(2), position(A)"
        ),
        ["component of 𝐯_A along 𝐢", "component of 𝐯_A along 𝐣"],
    ),
    "an impulse with a letter has its direction without that": (
        (
            "sphere A: mass m, velocity 2u i + u j\nsphere B: mass 2m, velocity -u i + 2u j\n"
            "A hits B\ngiven impulse(A) = -lambda m u (i + j), e = 1/2\nfind lambda"
        ),
        ["the line of centres is parallel to 𝐢 + 𝐣", "Scalar products with 𝐢 + 𝐣, along the"],
    ),
    "a speed towards a wall by its ends has its direction": (
        (
            "point O: (0, 0)\nwall OY: from O to (0, 8)\n"
            "sphere P: at (4, 6), velocity -2i - 2j\nP hits OY: e = 1/2\nfind time(1)"
        ),
        ["Time = distance ÷ speed parallel to the x-axis:"],
    ),
    "an arccosine is the one of an acute angle, as its sine is positive": (
        (
            "wall V: along i\nsphere P: mass 2, velocity 13 at arccos(-5/13)\n"
            "sphere Q: mass 1, velocity 10 at arcsin(4/5) to V\nP hits V: e = 1/3\n"
            "Q hits V: e = 1/3\nfind velocity(P)\nfind speed(Q)"
        ),
        [
            "An angle between 0° and 180° with cosine −5/13 has sine 12/13.",
            "An acute angle with sine ⅘ has cosine ⅗.",
        ],
    ),
    "one component by a wall is called the one that it is": (
        (
            "wall V: along -3i + 4j\nsphere P: mass 1, velocity 5j\nP hits V: e = 1/2\n"
            "find across(velocity(P), V)"
        ),
        ["Component perpendicular to V:"],
    ),
    "tangents of open sense are squared for a reason": (
        (
            "sphere A: mass m, velocity u at 30°\nsphere B: mass m, velocity u at 60° from -i\n"
            "A hits B: along i\nfind e\n"
            "given angle(velocity(A), line_of_centres) = angle(velocity(B), line_of_centres)"
        ),
        ["Direction of motion, in squares, as the sense of a component is not known:", "tan²β"],
    ),
    "the other bound of a square over that of a cosine is seen by the sine": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at theta from j\nP hits W\n"
            "given energy(P) = (1/3) energy(P, 0)\nfind e in terms of theta\nfind range of theta"
        ),
        ["In this range e² ≤ 1 as well, as 1 − 3 sin²θ < 3 − 3 sin²θ = 3 cos²θ."],
    ),
    "the sense along a circle is said where a component has it": (
        (
            "wall C: circle centre (0, 0) radius 2a\nsphere P: at (2a, 0), velocity u at alpha "
            "from -i\nP hits C: e = 1/3\nfind time(1), speed(P)"
        ),
        [
            "A chord makes equal angles with the radii at its ends:",
            "The component along the tangent before the impact, taken anticlockwise:",
        ],
    ),
    "energies of velocities that are given are lost by the component that changes": (
        (
            "wall W: along i\nsphere P: mass 2, velocity 3i - 2j\nP hits W\n"
            "given velocity(P) = 3i + j\nfind energy_lost"
        ),
        ["Kinetic energy lost, by the component that changes:"],
    ),
    "the sign of a difference from what is claimed has its reasons": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given e < 1/2\nshow impulse = m u sin(alpha) + m u sin(alpha)"
        ),
        ["= −(1 − e)mu sin α < 0, as e < ½ and α is acute."],
    ),
    "what only grows has a strict bound where it does not stay the same": (
        (
            "wall L: along i\nwall M: along i\nsphere P: velocity 5u at arctan(4/3) to L\n"
            "P hits L: e = e1\nP hits M: e = e2\ngiven e1 > 0, e2 > 0\n"
            "find range of speed(P) in terms of u"
        ),
        ["speed of P > 3u", "e₁ > 0", "e₂ > 0"],
    ),
    "a coordinate is that of the other sphere by the line of centres": (
        (
            "sphere A: mass 1, radius 1, at (0, 0), velocity 3j\nsphere B: mass 2, radius 1, "
            "at (10, 12), velocity -v i\nA hits B: along i, e = 1/2\nfind v"
        ),
        [
            "The line of centres is parallel to 𝐢, so at the impact the y-coordinates are\nequal.",
            "t = 12/3 = 4 s",
        ],
    ),
    "an impulse at an angle is put in by its components": (
        (
            "sphere P: mass 2, velocity 3j\nP receives J at theta\n"
            "given velocity(P) = 2i + 5j\nfind impulse(P), J, theta"
        ),
        ["The impulse given to P, from its magnitude and direction:", "J cos θ 𝐢 + J sin θ 𝐣"],
    ),
    "a factor of both sides is divided out in words": (
        (
            "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
            "A hits B: along i\ngiven deflection(A) = 30°, energy_lost = 1/4 energy(0)\n"
            "find alpha"
        ),
        ["By the difference of two squares:", "Dividing by tan²α + 1:"],
    ),
    "one ratio of an angle gives another": (
        (
            "wall W: along i\nsphere P: velocity u at alpha to W\ngiven cot(alpha) = 3/4\n"
            "P hits W: e = 1/2\nfind speed(P)\nshow tan(alpha) > 1"
        ),
        ["cot α = ¾\nSo\n", "tan α = 4/3"],
    ),
    "a direction that is shown has its sense by an acute angle": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = 1\nshow velocity(B) in the direction of i"
        ),
        ["w = u cos α > 0, as α is acute", "So 𝐯_B is in the direction of 𝐢, as required."],
    ),
    "the other bound of the square of a coefficient holds as well": (
        (
            "sphere A: mass 2m, velocity u i + v j\nsphere B: mass m, velocity -u i + v j\n"
            "A hits B: along i\ngiven energy_lost = 1/3 energy(0), u > 0\nfind range of v/u"
        ),
        ["In this range e² ≤ 1 as well, as 5u² − 3v² < 8u²."],
    ),
    "a coordinate is by the component as the angle of the data has it": (
        (
            "wall W: along j, through (d, 0)\nsphere P: at (0, 0), velocity u at 60°\n"
            "P hits W: e = 1/2\nfind time(1), position(P)"
        ),
        ["= (u sin 60°)(2d/u) = √3 d"],
    ),
    "a velocity along the line of centres has its reason": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\n"
            "A hits B: along i, e = 1/2\nfind velocity(B), speed(B)"
        ),
        ["B was at rest, so it moves along the line of centres:\n", "𝐯_B = ½u cos α 𝐢"],
    ),
    "a ball that comes back shows that e is not zero": (
        (
            "wall F: along i, through (0, 0)\nwall C: along i, through (0, h)\n"
            "sphere Q: at (0, 0), velocity u at beta\nQ hits C\nQ hits F\n"
            "find minimum of time(2) over beta"
        ),
        ["e > 0, since Q", "reaches F"],
    ),
    "a tangent in place of a cosine comes of their own identity": (
        (
            "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
            "A hits B: along i\ngiven deflection(A) = 30°, energy_lost = 1/3 energy(0)\n"
            "find alpha, e"
        ),
        ["As 1/cos²α = 1 + tan²α:\n    (3 tan α + √3)²"],
    ),
    # The first impact gives 3 m s⁻¹ to B; the wall sends it back with 1 m s⁻¹.
    "each sphere keeps its letter when they meet again": (
        (
            "wall W: along j, through (10, 0)\nsphere A: mass 1, at (0, 0), velocity 6i\n"
            "sphere B: mass 2, at (6, 0), at rest\nA hits B: along i, e = 1/2\nB hits W: e = 1/3\n"
            "B hits A: along i, e = 1/2\nfind velocity(A), velocity(B)"
        ),
        ["6 = v₁ + 2w₁", "2(−1) = 2w₃ + v₃", "w₃ − v₃ = ½"],
    ),
    "a speed of the statement is no velocity after": (
        (
            "wall W: along i\nsphere P: mass 1, velocity v_P at 45° to W\nP hits W: e = 1/2\n"
            "find speed(P)"
        ),
        ["component of 𝐯₁ away from W = ½v_P sin 45°"],
    ),
    # cos(arctan 4√3) = 1/7, and v = 7/2.
    "a component has the ratio by which it comes of its speed": (
        (
            "sphere A: mass 1, velocity 4 at 60°\nsphere B: mass 1, at rest\nA hits B: along i\n"
            "given velocity(A) = v at arctan(4√3)\nfind v, e"
        ),
        ["v = 7/2", "4 cos 60° = (7/2) × (1/7) + x"],
    ),
    # At 60° to i, with components √3u/2 and u/4.
    "scalar products have the numbers of the unit vectors": (
        (
            "wall W: along i\nwall X: along 60°\nsphere P: velocity u at 30° to W\n"
            "P hits W: e = 1/2\nP hits X: e = 1/2\nfind speed(P)"
        ),
        ["𝐯₁ · 𝐧 = (√3 u/2)(√3/2) − ½(u/4) = 5u/8"],
    ),
    # 𝐯_A − 𝐮_A = (1 − 4)𝐢 − √3 𝐣.
    "no angle is used that stands nowhere": (
        (
            "sphere A: mass 3, velocity 4i\nsphere B: mass 5, at rest\nA hits B\n"
            "given deflection(A) = 60°, speed(A) = 2, direction(A) < 0\nfind line_of_centres, e"
        ),
        ["𝐮_A · 𝐧 = 4(√3/2) = 2√3"],
    ),
    "a component that is zero has its own sign": (
        (
            "wall W: along theta\nsphere P: mass 1, velocity 2i + j\nP hits W: e = 1/2\n"
            "given theta > 30°, theta < 90°, velocity(P) parallel to j\nfind tan(theta)"
        ),
        ["so the component in the direction of 𝐢 is\nzero:", "(sin θ)((cos θ − 2 sin θ)/2)"],
    ),
    # (1 + e)² k cos²α = (1 − ek)² cos²α + (1 + k)² sin²α.
    "terms of one ratio stand on one side before its tangent": (
        REST.format(angle="alpha", m="k m", e="")
        + "given energy(A) = energy(B)\nfind tan(alpha) in terms of e, k",
        ["((1 + e)²k − (1 − ek)²) cos²α = (1 + k)² sin²α", "tan²α = (k − 1 + 4ek"],
    ),
    # v² = e²u² sin²α + u² cos²α.
    "a square has its factor that may be zero beside it": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given speed(P) = v\nfind sin(alpha) in terms of u, v, e"
        ),
        ["u²(1 − e²) sin²α = u² − v²", "sin α = √((u² − v²)/(1 − e²))/u, as α is acute"],
    ),
    # tan α + ¾ tan α = √3(1 − ¾ tan²α).
    "the formula for the roots stands before they are without roots below": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 3/4\n"
            "let beta = angle(velocity(P), W)\n"
            "given alpha + beta = 60°\nfind tan(alpha)"
        ),
        ["tan α = (−7 + √193)/(6√3) or tan α = (−7 − √193)/(6√3)", "= (√579 − 7√3)/18"],
    ),
    # 9d²(4a² − d²)/(4a² + 3d²)² ≥ 1/3, and (√33 ± 3)² = 6(7 ± √33).
    "an inequality of the fourth degree is solved by the square": (
        OFFSET + "given d > 0, deflection(A) >= 30°\nfind range of d",
        [
            "4a⁴ − 21a²d² + 9d⁴ ≤ 0",
            "(7 − √33)a²/6 ≤ d² ≤ (7 + √33)a²/6",
            "((√33 − 3)a/6)² ≤ d² ≤ ((3 + √33)a/6)²",
        ],
    ),
    # d² = r²: the line of centres is at 30° to the path.
    "a root of the other sign is rejected, with letters in it": (
        (
            "sphere A: mass m, velocity u i, radius r\nsphere B: mass 2m, at rest, radius r\n"
            "A hits B: offset d, e = 1\ngiven d > 0, velocity(A, 0) perpendicular to velocity(A)\n"
            "find d"
        ),
        ["tan φ = √3/3, as φ is acute"],
    ),
    # Of w = ±4u/5 the law of restitution, w = e(u + 4u/5), leaves one.
    "a component is not called positive without a reason": (
        (
            "sphere A: mass k m, velocity u i\n"
            "sphere B: mass m, velocity u at beta from -i\nA hits B: along i\n"
            "given sin(beta) = 3/5, A at rest, speed(B) = u\nfind k, e"
        ),
        ["as w = −4u/5 would give e = −4/9 by (3), but e ≥ 0"],
    ),
    # tan β = 3 tan α: both angles come to 0.
    "what comes to its end with an angle is said": (
        REST.format(angle="alpha", m="2m", e=", e = 1")
        + "find maximum of deflection(A) over alpha",
        ["as α → 0° and so β → 0°, but α > 0°, so there is no greatest value"],
    ),
    # (u/2)((1 − e) + (1 + e)f)(t₃ − t₂) = d − (1 − e)d/(1 + e).
    "the time of a meeting is collected": (
        (
            "wall W: along j, through (d, 0)\nsphere A: mass m, at (-c, 0), velocity u i\n"
            "sphere B: mass m, at (0, 0), at rest\ngiven c > 0\nA hits B: along i\n"
            "B hits W: e = f\nB hits A: along i\nfind time(3) - time(2)"
        ),
        ["((1 − e + f + ef)u/2)(t₃ − t₂) = 2ed/(1 + e)", "t₃ − t₂ = 4ed/"],
    ),
    "a quotient by a sum with roots stands before it is rationalised": (
        (
            "sphere A: mass m, velocity 2u at 30°\nsphere B: mass 2m, velocity u at 120°\n"
            "A hits B: along i\ngiven deflection(B) = 60°\nfind direction(A)"
        ),
        [
            "B turns through the",
            "tan θ = u/((√3 − 2)u) = 1/(√3 − 2) = (2 + √3)/((√3 − 2)(2 + √3))",
        ],
    ),
    # Equal spheres with e = 1 exchange their components: w = 3u.
    "a direction below i has its sense": (
        (
            "sphere A: mass m, velocity 3u i\nsphere B: mass m, velocity u at -30°\n"
            "A hits B: along i, e = 1\nfind direction(B)"
        ),
        ["tan θ = −(u/2)/(3u)", "θ = −arctan(1/6) ≈ −9.46°, as w > 0"],
    ),
    "a sense that is shown rests on what is given": (
        (
            "wall X: along i\nwall Y: along j\nsphere P: mass m, velocity u at alpha to X\n"
            "given e > 0\nP hits X: e = e\nP hits Y: e = e\n"
            "show velocity(P) opposite to velocity(P, 0)"
        ),
        ["is opposite to 𝐮, since e > 0, as required."],
    ),
    "a number is put in before an equation is rearranged into what is shown": (
        (
            "wall W1: along i\nwall W2: along j\nsphere P: mass m, velocity u at theta to W1\n"
            "P hits W1: e = e1\nP hits W2: e = e2\ngiven impulse(1) = impulse(2)\n"
            "part a\nfind tan(theta) in terms of e1, e2\n"
            "part b\ngiven theta = 45°\nshow e1 = e2"
        ),
        ["1 = (1 + e₂)/(1 + e₁)"],
    ),
    # e² = 1 − 3/(4 sin²α) is the printed equation: no other is made for the bounds.
    "a bound rests on the equation that is shown": (
        (
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
            "given speed(P) = 1/2 u\nshow e^2 = 1 - 3/(4 sin^2(alpha))\nshow e <= 1/2\n"
            "find range of alpha"
        ),
        ["e² < ¼, as sin²α < 1", "1 − 3/(4 sin²α) ≥ 0", "sin²α ≥ ¾"],
    ),
    "a deflection that may be obtuse is bounded as a sum": (
        (
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
            "given tan(alpha) = 2\nfind range of deflection(P)"
        ),
        ["arctan 2 ≤ δ ≤ 2 arctan 2", "as arctan 2 + arctan(2e) increases with e"],
    ),
    "the least angle by the square of its sine": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given energy_lost = 1/4 m u^2\nfind minimum of alpha over e"
        ),
        ["sin²α ≥ ½, as e² ≥ 0", "least value of α = 45°, when e = 0"],
    ),
    "a component before a slanting wall is worked out for the impulse": (
        (
            "wall W: along i - j\nsphere P: mass 2\nP hits W: e = 1/2\n"
            "given velocity(P) = -i + 3j\nfind impulse(P)"
        ),
        ["√2 = −½(𝐮_P · 𝐧)", "𝐮_P · 𝐧 = −2√2 m s⁻¹", "(6𝐢 + 6𝐣) N s"],
    ),
    "a speed by an angle that a deflection tells": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at 40° to W\nP hits W\n"
            "given deflection(P) = 65°\nfind e\nfind speed(P)/u"
        ),
        ["β = 65° − 40° = 25°", "V = (u cos 40°)/cos 25°", "V/u = (cos 40°)/cos 25°"],
    ),
    "a letter for a component is no name of a wall": (
        (
            "wall W: along i\nwall V: along 60°\nsphere P: velocity u at 30° to W\n"
            "P hits W: e = 1\nP hits V: e = e\ngiven velocity(P) perpendicular to W\nfind e"
        ),
        ["𝐯₂ = s𝐣", "s = u"],
    ),
    # Only in the tangent of θ alone is it seen that e < ½.
    "the tangents of an angle and of twice it are one tangent before a bound": (
        (
            "wall W: along i\nsphere P: velocity u at 2theta to W\nP hits W\n"
            "given angle(velocity(P), W) = theta\nfind range of e"
        ),
        ["tan²θ = 1 − 2e", "1 − 2e > 0", "e > 0, as tan θ < 1 since 2θ is acute"],
    ),
    "a square that is taken away bounds what is left": (
        (
            "wall W: along i\nsphere P: velocity u at 2theta to W\nP hits W\n"
            "given angle(velocity(P), W) = theta\npart a\nshow e = (1 - tan^2 theta)/2\n"
            "part b\nshow e < 1/2"
        ),
        ["e < ½, as tan²θ > 0"],
    ),
    # With e = 0 it is at rest in the corner, and has no direction.
    "what may be at rest has a direction unless it is": (
        (
            "wall X: along i\nwall Y: along j\nsphere P: mass m, velocity u at alpha to X\n"
            "P hits X: e = e\nP hits Y: e = e\n"
            "show velocity(P) opposite to velocity(P, 0)\n"
            "show velocity(P) in the direction of -velocity(P, 0)"
        ),
        ["is opposite to 𝐮 unless P is at rest", "is in the direction of −𝐮 unless P is at rest"],
    ),
    "equal spheres, of which the striking one may stop": (
        (
            "sphere A, B: mass m\nsphere A: velocity u i\nsphere B: at rest\n"
            "A hits B: along i\nshow velocity(A) in the direction of i"
        ),
        ["𝐯_A is in the direction of 𝐢 unless A is at rest, as required."],
    ),
    # 𝐯_A = (√2u/6)(−𝐢 + 3𝐣) and 𝐯_B = (√2u/3)𝐢, with e = 1, k = 2 and α = 45°.
    "two velocities that are not perpendicular have a scalar product": (
        REST.format(angle="alpha", m="k m", e="") + "show velocity(A) perpendicular to velocity(B)",
        ["is not perpendicular to 𝐯_B in general: with", "so 𝐯_A · 𝐯_B = ", "≠ 0."],
    ),
    # sin γ = 3/5 = d/10.
    "a unit vector has one form": (
        (
            "sphere A: mass 2m, velocity 3u i, radius 5\nsphere B: mass m, at rest, radius 5\n"
            "A hits B: offset d, e = 1/4\ngiven angle(line_of_centres, i) = arcsin(3/5), d > 0\n"
            "find d, velocity(B)"
        ),
        ["unit vector along the line of centres = (4𝐢 + 3𝐣)/5", "((4𝐢 + 3𝐣)/5)"],
    ),
    "a unit vector has another letter than the time": (
        (
            "wall W: along 4i + 3j, through (0, 0)\nsphere P: mass 1, at (0, 2), velocity i - j\n"
            "P hits W: e = 1/2\nfind time(1), speed(P)"
        ),
        ["𝐧 = (3𝐢 − 4𝐣)/5", "𝐬 = (4𝐢 + 3𝐣)/5", "𝐮_P · 𝐬 = (4 − 3)/5 = ⅕ m s⁻¹"],
    ),
    # The angle of 𝐮 = u𝐢 + 2u𝐣 and 𝐯_A = v𝐢 + 2u𝐣, before u² goes.
    "a quotient of squares is multiplied by what stands below": (
        (
            "sphere A: mass m, velocity u i + 2u j\nsphere B: mass m, velocity -3u i\n"
            "A hits B: along i\ngiven cos(deflection(A)) = 1/sqrt(10)\nfind e"
        ),
        ["5(4u² + v²) = 10(4u + v)²", "v² + 16uv + 28u² = 0"],
    ),
    # tan 2α = tan β, where tan β = (1 + k) tan α/(1 − ek).
    "tangents stay tangents where an equation is multiplied out": (
        REST.format(angle="alpha", m="k m", e="")
        + "given deflection(A) = alpha\nfind k in terms of e, alpha",
        ["1 − tan²α + (1 − tan²α)k = 2 − 2ek", "k = (tan²α + 1)/(1 − tan²α + 2e)"],
    ),
    # e = 3/(2 cos α) − 1, so v = 5 cos α − 5.
    "what is squared is in its shortest form first": (
        (
            "sphere A: mass m, velocity 5 at alpha\nsphere B: mass 2m, at rest\nA hits B: along i\n"
            "given speed(A) = 3, speed(B) = 5/2\nfind e, alpha"
        ),
        ["= (5(1 − cos α))² + (5 sin α)²", "50 cos α = 41"],
    ),
    "a letter that is asked stands before it is used": (
        (
            "sphere A: mass m, velocity u at 60°\nsphere B: mass m, at rest\nA hits B: along i\n"
            "let v = along(velocity(A), i)\nlet w = along(velocity(B), i)\ngiven w = 3v\n"
            "find e, v, w"
        ),
        ["v = u/8", "w = 3u/8", "3u/8 − u/8 = eu cos 60°"],
    ),
    # 𝐯_P = (k² − 2, 3k)u/(2(1 + k²)), with the other sign along i.
    "nothing but minuses stands below a line": (
        "wall W: along i + k j\nsphere P: velocity u i\nP hits W: e = 1/2\nfind velocity(P)",
        ["𝐯_P = ", "(u(2 − k²)/(2(k² + 1)))𝐢"],
    ),
    # tan²α = (ke − 1)/(1 + k), and e ≤ 1.
    "a divisor that a bound leaves out is more than 1": (
        REST.format(angle="alpha", m="k m", e="")
        + "given deflection(A) = 90°\nshow tan(alpha) <= sqrt(k - 1)",
        ["tan²α ≤ (k − 1)/(1 + k)", "tan α ≤ √(k − 1), as 1 + k > 1 (as required)"],
    ),
    "a bound in degrees comes of one that stands": (
        REST.format(angle="alpha", m="k m", e="")
        + "given deflection(A) = 90°\nshow tan(alpha)^2 <= (k - 1)/(k + 1)\nshow alpha < 45°",
        ["(as required)", "tan²α ≤ (k − 1)/(k + 1) < 1\n", "tan α < 1\n", "α < 45°"],
    ),
    "of a range over a mass both ends have a reason": (
        REST.format(angle="45°", m="k m", e=", e = 1/3") + "unknown k\nfind range of deflection(A)",
        ["increases with k, k > 0 and tan δ tends", "grows"],
    ),
    # sin²α = (u² − v²)/((1 − e²)u²) is between 0 and 1.
    "the condition of an acute angle stands by the square of its sine": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
            "given speed(P) = w\nfind sin(alpha) in terms of u, w, e"
        ),
        ["As 0 < sin²α = (u² − w²)/(u²(1 − e²)) < 1, this holds for eu < w < u and"],
    ),
    # tan δ = 3d√(4a² − d²)/(4a² + 3d²) is at least 1/√3.
    "an inequality is squared, and cleared, in steps": (
        OFFSET + "given deflection(A) >= 30°\nfind range of d",
        [
            "tan δ > 0, as d > 0",
            "≥ ⅓, as neither side is negative",
            "27d²(4a² − d²) ≥ (4a² + 3d²)²\n",
            "as (√33 − 3)² = 6(7 − √33) and (3 + √33)² = 6(7 + √33)",
        ],
    ),
    # (speed of A)² = u²((1 − 3e)² + 16)/32 at 45°, with B three times as heavy.
    "both ends of a speed come of one square": (
        REST.format(angle="45°", m="3m", e="") + "find range of speed(A)",
        [
            "= (u²/32)(1 − 3e)² + u²/2",
            "0 ≤ (1 − 3e)² ≤ 4, as 0 ≤ e ≤ 1",
            "u²/2 ≤ (speed of A)² ≤ 5u²/8\n",
            "√2 u/2 ≤ speed of A ≤ √10 u/4",
        ],
    ),
    "an extremum that is only approached is a bound": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/2\n"
            "show maximum of energy_lost over alpha = 3/8 m u^2"
        ),
        ["as α → 90°: a bound that is approached and not reached"],
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_a_working_says(name: str) -> None:
    text, fragments = SAYS[name]
    problem = parse(text)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    working = to_text(explain(solution))
    places = [working.find(each) for each in fragments]
    assert -1 not in places, (working, fragments)
    assert places == sorted(places), working


def test_a_double_root_has_no_root_of_nothing() -> None:
    text = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/3\n"
    text += "let beta = angle(velocity(P), W)\ngiven alpha - beta = 30°\nfind alpha"
    assert "√0" not in to_text(explain(solve(parse(text))))


def test_a_tangent_is_no_factor_that_is_gone() -> None:
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
    text += "given direction(A) = beta, 0° < beta < 90°\nfind e in terms of alpha, beta"
    assert "(tan β)v = " not in to_text(explain(solve(parse(text))))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            (
                "wall F: along i\nwall S: along 150°\nsphere P: velocity u at alpha to F\n"
                "P hits F: e = 1/2\nP hits S: e = 1/3\ngiven velocity(P) parallel to F\n"
                "find tan(alpha)"
            ),
            "is parallel to F, so the component in the direction of 𝐣 is zero:",
        ),
        (
            (
                "wall W: along j\nsphere P: velocity u at 90° - theta to W\nP hits W\n"
                "given angle(velocity(P), W) = 90° - 2theta\nshow e = tan(theta)/tan(2theta)"
            ),
            "By the complement of the angle: 1/tan 2θ = e/tan θ DM1 e = (tan θ)/tan 2θ",
        ),
        (
            (
                "sphere A: mass m, velocity u at theta\n"
                "sphere B: mass m, velocity u at theta from -i\nA hits B: along i\n"
                "given deflection(A) = 90°\nshow tan^2(theta) = e\nfind deflection(B)"
            ),
            "Substituting for e",
        ),
        (  # smooth spheres: what gives the direction is that of the line of centres
            (
                "sphere A: mass 2m, velocity 3u i + u j\nsphere B: mass 3m, velocity -u i\n"
                "A hits B: along i + j, e = 1/2\nfind impulse(B)"
            ),
            "Impulse = change of momentum of B along the line of centres: impulse on B = 3m(",
        ),
    ],
)
def test_what_a_line_comes_of(text: str, reason: str) -> None:
    shown = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert reason in shown
    assert "Substituting for tan²θ" not in shown


def test_what_is_positive_below_a_component_is_said() -> None:
    statement = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
        "given along(velocity(A), i) < 0\nfind range of e\n"
    )
    text = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "1 − ek < 0, as α is acute and 1 + k > 0" in text


def test_a_sphere_with_a_component_that_is_still_a_letter_moves_along_no_line() -> None:
    statement = (
        "sphere A: mass 3, velocity 5i + 2j\nsphere B: mass 1, velocity -3i + 4j\n"
        "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B, 0)\nfind e\n"
    )
    text = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "v = 8/3" in text
    assert "moves perpendicular to the line of centres" not in text


@pytest.mark.parametrize(
    ("speeds", "reason"),
    [
        (("3u", "4u"), "as 3 cos α + 4 sin α = 5 cos(α − arctan(4/3)) ≤ 5"),
        (("u", "sqrt(3) u"), "as cos α + √3 sin α = 2 cos(α − 60°) ≤ 2"),
    ],
)
def test_the_greatest_value_of_a_sum_of_a_cosine_and_a_sine_is_told_by_one_cosine(
    speeds: tuple[str, str], reason: str
) -> None:
    text = """
sphere A: mass m, velocity {} at alpha
sphere B: mass m, velocity {} at 90° + alpha
A hits B: along i, e = e
find maximum of impulse over alpha
"""
    assert reason in " ".join(to_text(explain(solve(parse(text.format(*speeds))))).split())
