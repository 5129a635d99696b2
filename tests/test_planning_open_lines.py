"""Lines of centres, and walls, that come of a velocity which is known but for its sense.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.explaining.lines.derivation import Relation
from restitution.explaining.lines.notation import write_relation
from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "a velocity by its speed and direction": (
        """
sphere A: mass 2, velocity 4i
sphere B: mass 2, at rest
A hits B
given speed(A) = 2, direction(A) = -60°
find e, line_of_centres
""",
        (
            "𝐯_A = 2 cos 60° 𝐢 − 2 sin 60° 𝐣 = (𝐢 − √3 𝐣) m s⁻¹",
            "the line of centres is parallel to (𝐢 − √3 𝐣) − 4𝐢",
            "e = 1",
        ),
    ),
    "a change whose length has roots below a root": (
        """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B
given speed(A) = u/2, direction(A) = 30°
find e
""",
        (
            "= (u/4)((4 − √3)𝐢 − 𝐣)",
            "((4 − √3)u/4 − √3 u/4)(4 − √3) − (−u/4 − u/4) = eu(4 − √3)",
            "= 3(5 − 2√3)/13",
        ),
    ),
    "the angle of a line of centres by a change of velocity": (
        """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 2m, velocity -u i
A hits B: along theta
given velocity(A) = -u j
find theta, e, velocity(B), impulse
""",
        (
            "the line of centres is parallel to (2u𝐢 + u𝐣) + u𝐣",
            "The line of centres is at θ to 𝐢:",
            "tan θ = 1",
            "u + u = e(2u + u + u)",
            "magnitude of the impulse = 2mu√(1² + 1²)",
        ),
    ),
    "a velocity that is turned away from who is struck": (
        """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along theta
given deflection(A) = 45°, speed(A) = u/2
find theta, e
""",
        (
            "away from B, so A is turned clockwise:",
            "𝐯_A = (u/2) cos 45° 𝐢 − (u/2) sin 45° 𝐣 = (√2 u/4)𝐢 − (√2 u/4)𝐣",
            "tan θ = 1/(2√2 − 1) = (1 + 2√2)/((2√2 − 1)(1 + 2√2)) = (1 + 2√2)/7",
            "= (20 − 9√2)/28",
        ),
    ),
    "turned through a right angle, with its speed": (
        """
sphere C: mass 3, velocity 4i - 2j
sphere D: mass M, at rest
C hits D: e = 1/3
given velocity(C) perpendicular to velocity(C, 0), speed(C) = sqrt(5)
find velocity(C), line_of_centres, M, speed(D)
""",
        (
            "component of 𝐯_C in the direction of 2𝐢 − 𝐣 = 0",
            "𝐯_C = s((𝐢 + 2𝐣)/√5)",
            "s = ±√5",
            "parallel to (4𝐢 − 2𝐣) − (−𝐢 − 2𝐣) = 5𝐢\n",
            "the line of centres is parallel to (4𝐢 − 2𝐣) − (𝐢 + 2𝐣) = 3𝐢 − 4𝐣",
            "M = 45",
            # Along a line that is known no vector is multiplied.
            "Newton's experimental law:",
        ),
    ),
    "a wall that turns through a right angle": (
        """
wall W
sphere P: mass 2, velocity 12i - 5j
P hits W
given deflection(P) = 90°, speed(P) = 26/3
find velocity(P), direction(W), e, impulse
""",
        ("s = ±26/3", "W is parallel to 3𝐢 + 2𝐣", "W is parallel to 9𝐢 − 46𝐣", "e = 4/9"),
    ),
    "a letter of the statement times a vector": (
        """
wall W
sphere P: velocity 7i + j
P hits W: e = 1
given velocity(P) = k (i + 7j), k > 0
find k, direction(W)
""",
        (
            "𝐯_P = k(𝐢 + 7𝐣)",
            "k(k − 7) + 7k(7k − 1) = −7(k − 7) − (7k − 1)",
            "W is parallel to 𝐢 + 𝐣",
        ),
    ),
    "a letter of the statement times the velocity of one of two": (
        """
sphere A: mass 2, velocity 3i + j
sphere B: mass 1, at rest
A hits B: e = 1/2
given velocity(B) = k (i + j)
find k, line_of_centres, velocity(A)
""",
        ("2(3𝐢 + 𝐣) = 2𝐯_A + k𝐢 + k𝐣", "k = 2", "𝐯_A = 2𝐢 m s⁻¹"),
    ),
    "momentum across": (
        """
sphere P: mass 2m, velocity 3u i
sphere Q: mass m, velocity -u i
P hits Q
given momentum(Q) perpendicular to i, speed(Q) = 2u
find velocity(P), impulse, e
""",
        ("the momentum of Q is perpendicular to 𝐢", "component of 𝐯_Q along 𝐢 = 0", "s = ±2u"),
    ),
    "one of both senses contradicts the law": (
        """
sphere P: mass 4, velocity 2i + j
sphere Q: mass 5, velocity -i + 3j
P hits Q
given velocity(P) parallel to i - j, speed(P) = sqrt(2)
find e, energy_lost
""",
        (
            "𝐯_P = k(𝐢 − 𝐣)",
            "k² + k² = (√2)²",
            "as k = 1 would give e = −10 by (3), but e ≥ 0",
            "e = ⅘",
        ),
    ),
    "a slanting line without a speed": (
        """
sphere A: mass 2, velocity 5i
sphere B: mass 3, velocity -2i + j
A hits B: e = 1/2
given velocity(A) parallel to i + 2j
find velocity(A), velocity(B)
""",
        ("parallel to 𝐢 + 2𝐣, so for some number k:", "𝐯_A = k(𝐢 + 2𝐣)", "by scalar products"),
    ),
    "an angle between velocities that is right": (
        """
sphere A: mass 1, velocity 3i + 4j
sphere B: mass 2, velocity -2i
A hits B
given angle(velocity(A), velocity(A, 0)) = 90°, speed(A) = 5/2
find velocity(A), velocity(B), e
""",
        ("in the direction of 4𝐢 − 3𝐣", "s = ±5/2"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_velocity_is_known_but_for_its_sense(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text


def test_a_speed_is_the_value_of_the_one_component_without_a_vector_between() -> None:
    problem, derivation = planned(
        """
        wall W: along phi
        sphere Q: velocity 6 j
        Q hits W: e = 1/3
        given velocity(Q) perpendicular to j
        find phi, speed(Q)
        """
    )
    assert [write_relation(each.answer) for each in derivation.items][1] == "speed(Q, 1) = 2sqrt(3)"
    vectors = [
        line
        for line in derivation.lines
        if isinstance(line.relation, Relation)
        and write_relation(line.relation).startswith("velocity(Q, 1) = ")
    ]
    assert len(vectors) == 1  # by its letter
    text = to_text(explanation_of(derivation, problem))
    assert "2√3 𝐢" not in text
    assert "    V cos φ = 6 sin φ" in text  # and not with a minus on both sides
