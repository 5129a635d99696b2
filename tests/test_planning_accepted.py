"""Planned workings that the follower accepts, line by line, with the answers of the solver."""

from __future__ import annotations

import pytest
from laws_of_workings import answers, complaints, printed_results

from restitution.language import parse
from restitution.planning.planner import plan
from restitution.solving import solve

STATEMENTS = {
    "a quotient starts from what is above": """
wall V: along i
wall W: along j
sphere Q: mass k m, velocity -3u i - 4u j
Q hits V
Q hits W
find total_energy_lost/energy(0), impulse(2)/impulse(1)
""",
    "a letter that is another": """
wall V: along i
wall W: along j
sphere Q: velocity 4u i - 3u j
Q hits V: e = f
Q hits W: e = g
given f = g, speed(Q) = 2u
find f
""",
    "a direction after another ratio": """
sphere S: mass 2m, velocity u at theta
sphere T: mass 3m, at rest
S hits T: along i, e = 1/3
given energy(T) = 1/4 energy(0)
find theta, direction(S)
""",
    "velocities at 180° less an angle": """
sphere S: mass m, velocity 2u at theta
sphere T: mass 2m, velocity u at 180° - theta
S hits T: along i, e = 1/4
find velocity(S), speed(T), impulse
""",
    "a velocity at 90° and an angle": """
wall W: along j
sphere P: velocity u at 90° + alpha
P hits W: e = 2/3
find velocity(P)
""",
    "a velocity that a blow leads to": """
sphere A: mass 3, velocity 4i
sphere B: mass 2, velocity -2i + j
A hits B: along i, e = 1/3
B receives p i + q j
given velocity(B) = 2i - 3j
find p, q, energy(B)
""",
    "an impulse of which the size is found": """
wall W: along j
sphere P: mass 2m, at rest
P receives H at 60° to W
P hits W: e = 1/3
given speed(P) = 2u
find H, energy(P, 1) in terms of m, u
""",
    "a deflection whose cosine would be tangled": """
sphere S: mass 0.2, velocity 5i + 3j
sphere T: mass 0.3, velocity -2i - j
S hits T: along j
given energy_lost = 0.84
find e, deflection(T)
""",
    "a bound that is said from both sides": """
sphere A: mass m, velocity u at 45°
sphere B: mass k m, at rest
A hits B: along j, e = 1/3
unknown k
find range of deflection(A)
""",
    "an angle that is let, and asked by its cosine": """
sphere A: mass m, velocity 3u i + 2u j
sphere B: mass 2m, velocity -u i - 2u j
A hits B: along i, e = 1/2
let phi = angle(velocity(A), velocity(B))
find cos(phi), phi
""",
    "an angle that is the same whatever the speeds are": """
sphere A: mass 2m, velocity u at 30°
sphere B: mass 2m, velocity u at 150°
A hits B: along i, e = 1/2
find angle(velocity(A), velocity(B)), speed(B)
""",
    "numbers of which the difference is zero": """
wall W: along j
sphere P: velocity u at alpha
P hits W: e = 1/9
given speed(P) = u/3
find tan(alpha), deflection(P)
""",
    "a speed at which a sphere stops": """
sphere A: mass m, velocity u at 45°
sphere B: mass k m, at rest
A hits B: along i
given deflection(A) = 45°
find e in terms of k
""",
    "a letter that is let before a second wall": """
wall V: along i
wall W: along -60°
sphere P: mass m, velocity v at alpha to V
P hits V: e = 1/3
given tan(alpha) = 3/4
let beta = angle(velocity(P), V)
find tan(beta)
P hits W: e = 1/2
find energy(P)/energy(0), impulse
""",
    "slanting walls, with a velocity before that is open": """
wall V: along i + 2j
wall W: along 3i - j
sphere P: mass 2, velocity p i + q j
P hits V: e = 1/2
P hits W: e = 1/3
given velocity(P) = 2i + j
find p, q
""",
    "an offset, and a right angle": """
sphere A: mass m, velocity u j, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1
find speed(A), angle(velocity(A), velocity(B))
""",
    "no rebound": """
wall W: along i + j
sphere P: mass 2, velocity 3i
P hits W: e = 0
find velocity(P), impulse, energy_lost
""",
    "no rebound, in letters": """
wall W: along j
sphere P: mass k, velocity v at theta
P hits W: e = 0
find speed(P), deflection(P), impulse, energy_lost/energy(0)
""",
    "how fast two spheres part": """
sphere A: mass 1, velocity 2i + 5j
sphere B: mass 2, velocity -i - j
A hits B: along j
given abs(velocity(A) - velocity(B)) = 5
find e
""",
    "an angle by the letter for it": """
sphere A: mass 2m, velocity 2u i + u j
sphere B: mass m, velocity -u i + 3u j
A hits B: along i
let phi = angle(velocity(A), i)
part a
given phi = 45°
find e
part b
given e = 1/2
find tan(phi)
""",
    "an energy by the letter for its share": """
wall W: along j
sphere P: mass m, velocity u at alpha to W
P hits W
let R = energy(P)/energy(P, 0)
part a
given R = 5/8, tan(alpha) = 1
find e
part b
given R = 3/4, e = 1/3
find alpha
""",
    "a condition that another implies": """
sphere A: mass 2m, velocity 3u at 60°
sphere B: mass 3m, velocity u at 60° from -i
A hits B: along i
given along(velocity(A), i) < 0, along(velocity(B), i) > 0
find range of e
""",
    "directions of which one is told by the other": """
sphere A: mass m, velocity 3u i
sphere B: mass 4m, velocity -u i
A hits B: along i
given velocity(A) opposite to i, velocity(B) in the direction of i
find range of e
""",
    "spheres that go on together": """
sphere A: mass 3, velocity 4j + i
sphere B: mass 2, velocity -j + i
A hits B: along j
given velocity(A) = velocity(B)
find e, velocity(B), energy_lost
""",
    "terms that cancel": """
sphere A, B: mass m
sphere A: velocity 2u at alpha
sphere B: velocity 2u at alpha from -i
A hits B: along i
given alpha = 30°
find impulse, speed(A)
""",
    "a root of a product": """
sphere A: mass 5, velocity 3i + 2j
sphere B: mass 1, at rest
A hits B: along j
find angle(velocity(A), velocity(B))
""",
    "a ratio of roots": """
wall V: along i
wall W: along j
sphere P: mass 2, velocity -2i - 3j
P hits V
P hits W: e = 2/3
find speed(P)/speed(P, 0)
""",
    "an angle whose cosine is given": """
wall W: along j
sphere P: mass 2, velocity u at alpha to W
given cos(alpha) = 4/5
P hits W: e = 1/3
find deflection(P)
""",
    "one question in two parts, with two answers": """
sphere A: mass m, velocity i + 4j
sphere B: mass 5m, velocity -5i + j
A hits B: along j
part a
given angle(velocity(A), line_of_centres) = 45°
find e
part b
given angle(velocity(A), line_of_centres) = 45°
find speed(B)
""",
    "an impulse against the line of centres as it is typed": """
sphere A: mass 1, velocity 3i - 3j
sphere B: mass 4, velocity i + 5j
A hits B: along 3i + 4j, e = 1/2
find impulse(A), velocity(A)
""",
    "a deflection in letters": """
sphere A: mass 4, velocity u at 60°
sphere B: mass 1, velocity u at 120°
A hits B: along i
find deflection(A)
""",
    "speeds that are told in two ways": """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity -2u i
A hits B: along i
find energy_lost/energy(0)
""",
    "a wall at an angle in letters": """
wall W: along theta
sphere P: mass 2m, velocity u i
P hits W: e = 1/2
find velocity(P)
""",
    "a deflection that takes an identity": """
sphere A: mass 3m, velocity u at alpha
sphere B: mass 2m, velocity u at 120°
A hits B: along i, e = 1/4
find tan(deflection(A))
""",
    "a line of centres in roots, and letters": """
sphere A: mass 2, velocity a i + b j
sphere B: mass 3, velocity -i + 2j
A hits B
given impulse(A) = -6i + 3j, e = 2/3
given velocity(A) perpendicular to velocity(A, 0)
find a, b
""",
    "an angle of a coefficient that a later part gives": """
wall W: along j
sphere Q: mass m, velocity 2u at alpha to W
Q hits W: e = e
given deflection(Q) = 90°
part a
find tan(alpha)
part b
given e = 1/3
find alpha
""",
    "a cosine that two parts give, of which only the later one needs the sine": """
sphere A: mass m, velocity 2u at alpha
sphere B: mass 3m, at rest
A hits B: along i
part a
given energy_lost = 1/4 energy(0), cos(alpha) = 4/5
find e
part b
given speed(B) = 3/4 u, cos(alpha) = 4/5
find e, direction(A)
""",
    "a share of an energy that may be none of it": """
sphere A: mass m, velocity u i
sphere B: mass M, velocity -v i
A hits B: along i
show energy_lost <= energy(0) (1 - e^2)
""",
    "a value of which a factor is cancelled above and below, beside a root": """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
part a
find along(velocity(B), i)
part b
given velocity(A) perpendicular to velocity(B)
show k = 1/e
part c
given velocity(A) perpendicular to velocity(B), alpha = 45°
find energy(B)/energy(0) in terms of e
""",
    "roots of two factors, and that of their product": """
wall W: along i
sphere P: mass 0.3, velocity 8 at 35° to W
P hits W
given speed(P) = 7
find e
find impulse
""",
    "the cosine of an angle of who moves along an open line": """
sphere P: mass 2m, velocity 3u i
sphere Q: mass m, at rest
P hits Q: along phi
given cos(angle(velocity(Q), velocity(P, 0))) = 4/5, speed(Q) = 2u
find e
""",
    "an angle from j of who moves along an open line": """
sphere P: mass 2m, velocity 3u i
sphere Q: mass m, at rest
P hits Q: along phi, e = 1/2
given angle(velocity(Q), j) = 60°
find phi
find velocity(P)
""",
    "an angle that is no plain one, of a coefficient that a later part gives": """
wall W: along i
sphere P: velocity u at theta to W
P hits W: e = e
given deflection(P) = 90°
part a
find tan(theta)
part b
given e = 2/3
find theta
""",
}


@pytest.mark.parametrize("name", STATEMENTS)
def test_a_planned_working_is_accepted(name: str) -> None:
    solution = solve(parse(STATEMENTS[name]))
    derivation = plan(solution)
    assert complaints(solution, derivation) == []
    assert answers(solution, derivation) == []
    assert printed_results(solution, derivation) == []
