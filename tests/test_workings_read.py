"""What readers found amiss in printed workings, each on a statement of its own."""

from __future__ import annotations

import re
from functools import cache

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SHARE = """
wall W: along j
sphere P: mass 0.25, velocity 20 at arccos(0.6)
P hits W: e = 1/4
find energy_lost, energy_lost/energy(0) as a percentage
"""
SHARE_BOUNDED = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/2
given energy_lost/energy(0) >= 30%
find range of sin(alpha)
"""
LOSS_GIVEN = """
sphere A: mass m, velocity 5u i
sphere B: mass 4m, velocity -u i
A hits B: along i
given energy_lost = 60% energy(0)
find e
"""
TURNED = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
given tan(alpha) = 1/3
A hits B: along i, e = 1/2
given tan(deflection(A)) = 1/2
find k
"""
TURNED_AGAIN = """
sphere A: mass 3m, velocity u at alpha
sphere B: mass 4m, at rest
A hits B: along i
given tan(alpha) = 1/2, deflection(A) = alpha
find e
"""
PLACES = """
wall R: along j, through (8, 0)
sphere P: at (2, 1), velocity 4i + j
P hits R: e = 1/2
find position(P), position(P, at 3)
"""
SIZES = """
wall W: along i
sphere P: mass 3, velocity 5i - 4j
P hits W: e = 1/2
find impulse(P), speed(P), impulse
"""
BLOW = """
sphere P: mass 2, velocity 3i - j
P receives 8i + 6j
find velocity(P), deflection(P), impulse
"""
NO_MOMENTUM = """
sphere A: mass m, velocity 3u i + 6u j
sphere B: mass 3m, velocity -u i - 2u j
A hits B: along i, e = 1/2
find momentum
"""
BACK = """
wall W: along j
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i, e = 3/4
B hits W: e = f
part a
given f = 1/2
A hits B: along i, e = 3/4
find velocity(A), velocity(B)
"""
SLANTED = """
wall AB: along i
wall BC: along 4059i + 4060j
sphere P: velocity u at 45° to AB
P hits AB: e = 1/3
P hits BC: e = 1/2
find speed(P)
"""
TOUCHING = """
sphere A: mass 2, at (0, 0), velocity 5i, radius 1
sphere B: mass 1, at (8, 6/5), at rest, radius 1
A hits B: e = 1/2
find line_of_centres
"""
CUSHION = """
wall W: along i, through (0, 0)
point N: (9, 2)
sphere P: at (0, 3), velocity u at alpha to W
P hits W: e = 1/2
P reaches N
find alpha, distance(N, position(P, 1))
"""
LATE = """
sphere A: mass 2, velocity 5i + 3j
sphere B: mass 3, velocity -2i - 2j
A hits B: along i
part a
find maximum of energy_lost over e
part b
given energy_lost = 18.9
find e, velocity(A), deflection(B)
"""

ASIDE = """
sphere A: mass 2m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
find direction(B), speed(B)
"""
BLOW_OF_A_SIZE = """
sphere P: mass 3, velocity 4i
P receives J at theta
given J = 6, speed(P) = 5
find cos(theta)
"""
LOSS_AS_A_NUMBER = """
sphere A: mass 2, velocity 5i + j
sphere B: mass 1, velocity -i
A hits B: along i
given energy_lost = 9
find e
"""

THREE_DISCS = """
point N: (75, 65)
sphere A: at (8, 14), velocity a i + b j, radius 5
sphere B: at (40, 30), at rest
sphere C: at (66, 53), at rest
A hits B
B hits C
C reaches N
given speed(A, 0) = 13
find velocity(A, 0)
"""
LONG_LOSS = """
sphere S: mass 3m, velocity 5u at theta
sphere T: mass 4m, velocity u at 180° - theta
S hits T: along i, e = 1/3
given energy_lost = 7 m u^2
find cos(theta)
"""
SLOW_BLOW = """
wall W: along i
sphere P: mass m, velocity 4u i - 6u j
P receives lambda m u j
P hits W: e = 1/2
given 0 < lambda < 6, speed(P) = sqrt(17) u
find lambda
"""
ONE_SECOND = """
point T: (12, 6)
wall W: along i, through (0, 0)
sphere P: at (0, 3), velocity 4i - 3j
P hits W
P reaches T
find time(1), position(P, 1)
"""
APART = """
sphere A, B: radius 1/4
sphere A: mass 1, velocity 2i - 4j
sphere B: mass 3, velocity i + 2j
A hits B: along j, e = 1/2
find distance(A, B, at 3)
"""
ACROSS_THE_LINE = """
sphere A: mass m, velocity u i, radius r
sphere B: mass 3m, at rest, radius r
A hits B: offset -r, e = 1/3
find direction(A)
"""
BALANCE = """
sphere A: mass 2, velocity 5i + j
sphere B: mass 3, velocity -i + 2j
A hits B: along i, e = 1/2
show momentum = momentum(0)
"""
SENT_ACROSS = """
sphere A: mass 3m, velocity u at alpha
sphere B: mass 5m, at rest
A hits B: along i
part a
show speed(B) = 3/8 u (1 + e) cos(alpha)
part b
given direction(A) = 90°
find e
"""

IN_TWO_WAYS = """
wall W: along j
sphere P: mass m, velocity u at alpha
P hits W
given velocity(P) perpendicular to velocity(P, 0)
show tan^2(alpha) = e
find energy_lost in terms of m, u, e
find energy_lost/energy(0) in terms of alpha
"""

# What a working says, with the white space as it is printed where there is a line break in it.
SAYS = [
    (SHARE, "percentage lost = 16.875/50"),
    (SHARE, "½ × 0.25 × 20² = 50 J"),
    (SHARE_BOUNDED, "⅜m_P u² sin²α/(½m_P u²) ≥ 3/10"),
    (TURNED, "β = α + δ"),
    (TURNED, "tan β = (⅓ + ½)/(1 − ⅓ × ½) = 1"),
    (TURNED_AGAIN, "tan β = 2 tan α/(1 − tan²α)"),
    (TURNED_AGAIN, "(2 × ½)/(1 − (1/2)²) = 4/3"),
    (PLACES, "position of P at the impact = (8𝐢 + (5/2)𝐣) m"),
    (SIZES, "From (1): (iii) magnitude of the impulse = 18 N s"),
    (BLOW, "Magnitude, from the components: (iii) magnitude of the impulse = √(8² + 6²)"),
    (NO_MOMENTUM, "= 𝟎"),
    (TOUCHING, "From the centre of A to the centre of B: the line of centres is parallel to"),
    (CUSHION, "Substituting for tan α in (1): x-coordinate of P at the impact = 27/7 m"),
    (LATE, "δ = 180° − 45° − θ ≈ 180° − 45° − 38.96° M1 ≈ 96.0°"),
    (LOSS_GIVEN, "72mu²(1 − e²)/5 = 0.6 × (29mu²/2)"),
    (
        ASIDE,
        "so it moves along the line of centres: angle from 𝐢 to 𝐯_B = 30° A1",
    ),
    (THREE_DISCS, "Solving (1) and (2): a = 12 b = 5"),
    (SLOW_BLOW, "6 − λ = 2, as λ < 6"),
    (ONE_SECOND, "x-coordinate of P at the impact = 4 × 1 = 4 m"),
    (
        APART,
        "A approaches B in the direction of −𝐣, and at the impact their centres are ½ m apart. ",
    ),
    (APART, "centres are ½ m apart. So B is then at −½𝐣 m."),
    (ACROSS_THE_LINE, "angle from 𝐢 to 𝐯_A = −30° + 90° = 60°"),
    (BALANCE, "total momentum after the impact = total momentum before the impact"),
    (SENT_ACROSS, "3mu cos α = 5m(⅜(1 + e)u cos α)"),
    (BLOW_OF_A_SIZE, "As sin²θ + cos²θ = 1: 5 = 16 cos θ"),
    (LOSS_AS_A_NUMBER, " = 12(1 − e²)"),
]
SAYS_NOT = [
    (TURNED, "tangent of a difference"),
    (PLACES, "so P is at (8"),
    (NO_MOMENTUM, "Comparing components"),
    (BACK, "Second impact: B hits W Substituting"),
    (SIZES, "3(4 + 2)"),
]
STATEMENTS = list(dict.fromkeys(statement for statement, _ in (*SAYS, *SAYS_NOT)))


@cache
def text(statement: str) -> str:
    return to_text(explain(solve(parse(statement))))


def in_a_row(statement: str) -> str:
    return re.sub(r"\s+", " ", text(statement))


@pytest.mark.parametrize(("statement", "words"), SAYS, ids=[each for _, each in SAYS])
def test_a_working_says(statement: str, words: str) -> None:
    assert words in in_a_row(statement)


@pytest.mark.parametrize(("statement", "words"), SAYS_NOT, ids=[each for _, each in SAYS_NOT])
def test_a_working_does_not_say(statement: str, words: str) -> None:
    assert words not in in_a_row(statement)


def test_an_equation_among_words_goes_to_the_next_line_as_a_whole() -> None:
    assert "Let\n𝐧 = (4060𝐢 − 4059𝐣)/5741 be the unit vector" in text(SLANTED)


def test_a_link_after_a_broken_side_has_its_sign_below_the_one_above() -> None:
    lines = text(LONG_LOSS).splitlines()
    last = next(n for n, line in enumerate(lines) if "cos²θ" in line and line.lstrip()[0] == "=")
    assert lines[last - 1].lstrip().startswith("+")
    assert lines[last].index("=") == lines[last - 2].index("=")


def test_an_answer_is_in_the_letters_that_are_asked_for() -> None:
    """The loss in m, u and e, with e = tan²α put in, and its share in α alone."""
    own = in_a_row(IN_TWO_WAYS)
    assert "= ½(1 − e)mu²" in own
    assert "½mu²(1 − tan²α)/(½mu²) = 1 − tan²α" in own


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            (
                "sphere A: mass 1, velocity 3i + 4j\nsphere B: mass 1, velocity -3i\n"
                "A hits B: along 2i - j, e = 1/2\nfind line_of_centres"
            ),
            "unit vector along the line of centres = (2𝐢 − 𝐣)/√5 B1",
        ),
        (
            (
                "wall W\nsphere P: mass 2, velocity 7i + j\nP hits W\n"
                "given velocity(P) = 3i + 5j\nfind line_of_centres"
            ),
            "unit vector perpendicular to W, towards it = (𝐢 − 𝐣)/√2 A1",
        ),
    ],
)
def test_a_unit_vector_that_is_asked_has_its_length(statement: str, says: str) -> None:
    assert says in " ".join(to_text(explain(solve(parse(statement)))).split())


def test_an_impossible_deflection_has_the_discriminant_of_its_tangent() -> None:
    text = (
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i, e = 1/7\ngiven deflection(A) = 30°\nfind alpha"
    )
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert re.search(r"the discriminant of .*tan α .* = 0 is negative: .* = −108\.", shown)


def test_a_tangent_that_was_shown_is_not_worked_out_again() -> None:
    text = (
        "sphere A: mass m, velocity u at theta\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\npart a\n"
        "show tan(angle(velocity(A), line_of_centres)) = 4 tan(theta)\n"
        "part b\nfind maximum of deflection(A) over theta"
    )
    second = " ".join(to_text(explain(solve(parse(text)))).partition("\n(b)")[2].split())
    assert "tan β = 4 tan θ" in second
    assert "tan β = u sin θ" not in second
