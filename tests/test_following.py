"""What a follower has to refuse though it looks right, and what it must not refuse."""

from __future__ import annotations

import pytest
from derivations import derivation_of, names_of, oracle_of

from restitution.errors import StatementError
from restitution.explaining.following.follower import follow
from restitution.explaining.following.tracing import Tracer
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.quotients import NotComparableError
from restitution.explaining.lines.storing import from_json, to_json
from restitution.language.reading import parse
from restitution.oracle.roles import POSITIVE
from restitution.solving import solve
from restitution.workings import explain

WHOLE = ("leads-nowhere", "fact-not-used", "answer-missing")

SPHERES = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity -i + j
A hits B: along i, e = 1/2
find velocity(A)
"""
LETTERS = """
sphere A: mass m, velocity U at alpha
sphere B: mass 2m, at rest
A hits B: along i
find speed(A)
"""
PARTS = """
sphere A: mass m, velocity U at alpha
sphere B: mass 2m, at rest
A hits B: along i
part a
given e = 1/2
find velocity(A)
part b
find velocity(B)
"""
THREE = """
wall W: along j
sphere A: mass 2, velocity 3i + 4j
sphere C: mass 1, velocity 5i + j
A hits W: e = 1/2
find velocity(A)
"""
OFF_A_LINE = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along 30°
find angle(velocity(B), j)
"""
OFF = """
1 a | let | | let w = along(velocity(B, 1), line_of_centres(1))
2 a | law unchanged 1 B | velocity B | across(velocity(B, 1), line_of_centres(1)) = 0
3 a | define parallel 1 B | axis 1, 1, 2 | angle(velocity(B, 1), j) = {}
"""
TWICE_REFLECTED = """
wall X: along i
wall Y: along 180° - theta
sphere P: velocity u at alpha to X
P hits X: e = 1
P hits Y: e = 1
given tan(theta) = 1/tan(theta + alpha)
find theta
"""
ZERO_OF_A_SUM = """
1 a | identity sum-of-angles | given 1 | cos(alpha + 2theta) = 0
2 a | inverse | 1, acute: alpha, acute: theta | alpha + 2theta = {}
"""
OPEN_RATIO = """
wall W: along i
sphere P: velocity 3u i - 5u j
P hits W
find angle(velocity(P), W)
"""
ARC = """
1 a | let | | let beta = angle(velocity(P, 1), W)
2 a | law unchanged 1 P | velocity P, axis 1 | along(velocity(P, 1), i) = 3u
3 a | law restitution-wall 1 P | velocity P, axis 1, e 1 | along(velocity(P, 1), j) = 5e u
4 a | define tan 1 P | axis 1, 1, 2, 3 | tan(beta) = 5e u/(3u) = 5e/3 [rearrange]
5 a | inverse | 0° <= beta <= 90°, 4 | beta = arctan({})
"""
SAID_IN_BOTH = """
wall W: along i
sphere P: velocity 3i - 5j
P hits W
part a
given speed(P) = 5
find e
part b
given speed(P) = {}
find velocity(P)
"""
AGAIN = """
1 a | law restitution-wall 1 P | velocity P, axis 1, e 1 | along(velocity(P, 1), j) = 5e
2 a | law unchanged 1 P | velocity P, axis 1 | along(velocity(P, 1), i) = 3
3 a | define speed 1 P | given 1, 1, 2 | 5^2 = (5e)^2 + 3^2
4 {item} | define speed 1 P | given {fact}, 1, 2 | 5^2 = (5e)^2 + 3^2
a: 3 e = 4/5
b: 4 e = 4/5
"""
SQUARE = """
wall W: along i
wall X: along j
sphere P: velocity u at alpha to W
P hits W: e = 1/2
P hits X: e = 1/3
let phi = angle(velocity(P), W)
find phi
"""
TO_THE_FIRST = """
1 a | law unchanged 1 P | velocity P, wall W, axis 1 | along(velocity(P, 1), i) = u cos(alpha)
2 a | law restitution-wall 1 P | velocity P, wall W, axis 1, e 1 \
| along(velocity(P, 1), j) = 1/2 u sin(alpha)
3 a | law unchanged 2 P | axis 2, 2 | along(velocity(P, 2), j) = 1/2 u sin(alpha)
4 a | law restitution-wall 2 P | axis 2, e 2, 1 | along(velocity(P, 2), i) = -1/3 u cos(alpha)
5 a | define {}
"""
BY_ITS_TANGENT = "tan 2 P | axis 2, wall W, let phi, 3, 4 | tan(phi) = {}"
BY_ITS_SPEED = "speed 2 P | axis 2, let psi, {} | speed(P, 2) {}"
TO_THE_SECOND = SQUARE.replace(
    "phi = angle(velocity(P), W)", "psi = angle(velocity(P), X)"
).replace("find phi", "find psi")
PARALLEL = """
wall W: along i
wall X: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/2
P hits X: e = 2/3
given angle(velocity(P), X) = theta
find theta
"""
LEFT = """
wall W: along i
sphere P: velocity -3i - 4j
P hits W: e = 1/2
given angle(velocity(P), W) = theta
find theta
"""
SUPPLEMENT = """
sphere A: mass 2m, velocity U at 180° - alpha
sphere B: mass m, velocity -2U i
A hits B: along i
given tan(beta) = 2
find direction(A), beta
"""
OF_A_SUPPLEMENT = """
1 a | law unchanged 1 A | velocity A, axis 1 | s(A, 1) = {}
2 a | law restitution 1 A B | velocity A, velocity B, axis 1, e 1 | c(B, 1) - c(A, 1) = e ({} + 2U)
"""
TWO_RATIOS = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity -i + j
A hits B: along i
given tan(alpha) = 2, cos(alpha) = 1/sqrt(5)
given velocity(A) = cos(alpha) i + sin(alpha) j
find direction(A)
"""
FROM_TWO_RATIOS = """
1 a | let | | let theta = direction(A, 1)
2 a | define tan-direction 1 A | given 3, 1 | tan(theta) = sin(alpha)/cos(alpha)
3 a | put | 2, given 1 | tan(theta) = 2
4 a | inverse | given 2, -180° < theta <= 180°, 3, given 3 | theta = {}
"""
A_ROOT = """
sphere A: mass m, velocity U at alpha
sphere B: mass 2m, at rest
A hits B: along i
given sqrt(e) = {}
find e
"""
NAMED = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass m, velocity -u i + 2u j
A hits B: along i
let phi = angle(velocity(A), velocity(B))
given phi = {}
find e
"""
BY_ITS_NAME = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
3 a | law unchanged 1 A | velocity A, axis 1 | s(A, 1) = u
4 a | law unchanged 1 B | velocity B, axis 1 | s(B, 1) = 2u
5 a | define perpendicular 1 A B | let phi, given 1, 1, 2, 3, 4 | v w + u (2u) = 0
"""
UPWARDS = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find impulse
"""
UNKNOWN_AXIS = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity -i + j
A hits B
given velocity(A) = i + 4j
find e
"""
WALL = """
wall W: along i
sphere P: mass 1, velocity u at alpha to W
P hits W
given {}
find alpha
"""
BACKWARDS = """
wall W: along i
sphere P: mass 1, velocity 3 at 120° to W
P hits W: e = 1/2
find velocity(P)
"""

LOST = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
find energy_lost
"""
LOST_AT_AN_END = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
3 a | law momentum 1 A B | mass A, velocity A, axis 1, mass B, velocity B, 1, 2 | m u = m v + k m w
4 a | law restitution 1 A B | e 1, velocity A, axis 1, velocity B, 1, 2 | w - v = e u
5 a | combine w | 3, 4 | v = (1 - e k) u/(1 + k)
6 a | put | 4, 5 | w = (1 - e k) u/(1 + k) + e u = (1 + e) u/(1 + k) [rearrange]
7 a | define energy-lost 1 A B | mass A, velocity A, axis 1, mass B, velocity B, 1, 2, 5, 6 \
| energy_lost(1) = 1/2 m (u^2 - ((1 - e k) u/(1 + k))^2) - 1/2 (k m) ((1 + e) u/(1 + k))^2 \
= k m u^2 (1 - e^2)/(2(1 + k)) [rearrange]
8 a | put | 7 | {}
"""

STEEP = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 0
given alpha > 30°
find speed(P)
"""
ONE_COMPONENT = """
1 a | law unchanged 1 P | velocity P, wall W, axis 1 | along(velocity(P, 1), i) = u cos(alpha)
2 a | law restitution-wall 1 P | axis 1, e 1 | along(velocity(P, 1), j) = 0
3 a | define speed 1 P | 30° < alpha < 90°, 2, 1 | speed(P, 1) = u cos(alpha)
"""

SPEED_SQUARED = """
wall W: along j
sphere P: mass m, velocity u at theta
P hits W
given speed(P)^2 = u^2 (1 - 2e)^2
find theta
"""


def complaints(statement: str, working: str) -> list[str]:
    """What is wrong with the lines of a working, by reason."""
    problem = parse(statement)
    found = follow(derivation_of(problem, working), oracle_of(problem))
    return [each.reason for each in found if each.reason not in WHOLE]


RESTITUTION = "law restitution 1 A B | velocity A, velocity B, axis 1, e 1"
BOTH_SENSES = """
1 a | law along-the-change 1 A | velocity A, given 1 | line_of_centres(1) parallel to i
2 a | law along-the-change 1 A | velocity A, given 1 | line_of_centres(1) parallel to -i
3 a | law unchanged 1 B | 1, velocity B | s(B, 1) = 1
4 a | law unchanged 1 B | 2, velocity B | s(B, 1) = -1
"""
IMPULSE = """
1 a | let | | let v = c(A, 1)
2 a | law momentum 1 A B | mass A, mass B, velocity A, velocity B, axis 1, 1 | 1 = 2v + 3*c(B, 1)
3 a | law restitution 1 A B | velocity A, velocity B, axis 1, e 1, 1 | c(B, 1) - v = -3
4 a | combine c(B, 1) | 2, 3 | v = 2
5 a | law impulse 1 A | mass A, velocity A, axis 1, 1, 4 | impulse(1) = {}
"""
SECOND_WALL = """
1 a | let | | let V = speed(P, 2)
2 a | law unchanged 1 P | velocity P, wall W, axis 1 | along(velocity(P, 1), i) = u cos(alpha)
3 a | law unchanged 2 P | 2, 1, axis 2, given 1 | V cos(theta) = {}
"""
ALONG_A_WALL = """
1 a | let | | let V = speed(P, 1)
2 a | law unchanged 1 P | velocity P, axis 1, given 1, 1 | V cos(theta) = {}
"""
AGAINST = """
1 a | let | | let q = along(velocity(A, 0), i) in the sense of -i
2 a | sign | 1, velocity A | q {} 0
"""
DECIMAL = f"""
1 a | {RESTITUTION} | c(B, 1) - c(A, 1) = 2
2 a | value | 1 | c(B, 1) - c(A, 1) ≈ 2
3 a | fact | 2 | 1000(c(B, 1) - c(A, 1)) ≈ 2000
"""


@pytest.mark.parametrize(
    ("statement", "working", "expected"),
    [
        # two lines of one number would let a line rest on itself
        (
            SPHERES,
            (
                "1 a | let | | let v = c(A, 1)\n"
                f"5 a | {RESTITUTION}, 1 | c(B, 1) - v = 2\n"
                "4 a | rearrange | 5 | v = 7\n5 a | rearrange | 4 | v - 7 = 0"
            ),
            "number-twice",
        ),
        # a fact of another part, through a line
        (
            PARTS,
            (
                f"1 a | {RESTITUTION}, given 1 | c(B, 1) - c(A, 1) = 1/2 U cos(alpha)\n"
                "2 b | rearrange | 1 | c(B, 1) = c(A, 1) + 1/2 U cos(alpha)\n"
                "a: 1 c(B, 1) - c(A, 1) = 1/2 U cos(alpha)\n"
                "b: 2 c(B, 1) = c(A, 1) + 1/2 U cos(alpha)"
            ),
            "premise-of-another-part",
        ),
        # a value beyond all places is not that at another end of a range
        (
            LOST,
            LOST_AT_AN_END.format("k != 0 or energy_lost(1) = 1/2 m u^2 (1 - e^2)"),
            "does-not-follow",
        ),
        (LOST, LOST_AT_AN_END.format("1/k != 0 or energy_lost(1) = 0"), "does-not-follow"),
        # directions are not proved by having nothing to prove
        (SPHERES, "1 a | sign | | velocity(A, 1) parallel to i", "does-not-follow"),
        (SPHERES, "1 a | complete | | speed(A, 1) ≈ 55", "does-not-follow"),
        # letters for what there is not
        (LETTERS, "1 a | let | | let q = sqrt(e - 2)", "does-not-follow"),
        (LETTERS, "1 a | let | | let q = 1/(e - 1)", "does-not-follow"),
        (SPHERES, "1 a | let | | let q = q^2 + 1", "does-not-follow"),
        (SPHERES, "1 a | let | | let q = impulse(1) in the sense of j", "does-not-follow"),
        (SPHERES, "1 a | let | | let vector R = speed(A, 1)", "does-not-follow"),
        (SPHERES, AGAINST.format(">"), "does-not-follow"),
        # a body that takes no part
        (
            THREE,
            "1 a | law restitution-wall 1 C | | c(C, 0@1) = -restitution(1) c(C, 0@1)",
            "does-not-follow",
        ),
        # half of an acute angle is acute, twice it need not be
        (
            WALL.format("sin(2alpha) = 1/2"),
            "1 a | inverse | given 1, acute: alpha | alpha = 15°",
            "does-not-follow",
        ),
        # the sense along a wall is that of the velocity before
        (PARALLEL, SECOND_WALL.format("-u cos(alpha)"), "does-not-follow"),
        (LEFT, ALONG_A_WALL.format("-3"), "does-not-follow"),
        (UPWARDS, IMPULSE.format("-12"), "does-not-follow"),
        (UNKNOWN_AXIS, BOTH_SENSES, "axis-turned"),
        # a tangent that cancels divides by nothing
        (
            WALL.format("cos(2alpha) * u = cos(2alpha)"),
            "1 a | rearrange | given 1 | u + 0*tan(2alpha) = 1",
            "does-not-follow",
        ),
        # an angle to a wall is at most a right angle
        (
            BACKWARDS,
            (
                "1 a | define sum 1 P | velocity P"
                " | deflection(P, 1) = 120° + angle(velocity(P, 1), W)"
            ),
            "does-not-follow",
        ),
        (SPHERES, DECIMAL, "does-not-follow"),
        # circles among what is cited
        (
            WALL.format("beta = 2alpha, alpha = beta/2"),
            "1 a | law unchanged 1 P | given 1, given 2, velocity P | cos(beta) = sin(alpha)",
            "does-not-follow",
        ),
        (OPEN_RATIO, ARC.format("3/(5e)"), "does-not-follow"),
        # 270° lies at the end of what the sum may be
        (TWICE_REFLECTED, ZERO_OF_A_SUM.format("270°"), "does-not-follow"),
        (TWICE_REFLECTED, ZERO_OF_A_SUM.format("180°"), "does-not-follow"),
        # the angle to **i**, that to −**j**, and one to the other side
        (OFF_A_LINE, OFF.format("30°"), "does-not-follow"),
        (OFF_A_LINE, OFF.format("120°"), "does-not-follow"),
        (OFF_A_LINE, OFF.format("-60°"), "does-not-follow"),
        (LETTERS, "1 a | define speed | velocity A | speed(A, 0) = 2U", "does-not-follow"),
        # at 180° less an angle one component has the other sign, and one has not
        (SUPPLEMENT, OF_A_SUPPLEMENT.format("-U sin(alpha)", "-U cos(alpha)"), "does-not-follow"),
        (SUPPLEMENT, OF_A_SUPPLEMENT.format("U cos(alpha)", "-U cos(alpha)"), "does-not-follow"),
        (SUPPLEMENT, OF_A_SUPPLEMENT.format("U sin(alpha)", "U cos(alpha)"), "does-not-follow"),
        # both sides are squared
        (A_ROOT.format("1/2"), "1 a | rearrange | given 1 | e = 1/2", "does-not-follow"),
        # a letter for another angle is no right angle
        (NAMED.format("80°"), BY_ITS_NAME, "does-not-follow"),
        # the ratio of another angle tells nothing
        (TWO_RATIOS, FROM_TWO_RATIOS.format("arctan(2) - 180°"), "does-not-follow"),
        (TWO_RATIOS, FROM_TWO_RATIOS.format("arctan(3)"), "does-not-follow"),
        # the angle to the other wall has the other tangent, and no sign
        *(
            (SQUARE, TO_THE_FIRST.format(BY_ITS_TANGENT.format(ratio)), "does-not-follow")
            for ratio in (
                "1/3 u cos(alpha)/(1/2 u sin(alpha))",
                "1/2 u sin(alpha)/(-1/3 u cos(alpha))",
                "1/2 u cos(alpha)/(1/3 u cos(alpha))",
            )
        ),
        # of a wall that is not cited nothing is known
        (
            SQUARE,
            TO_THE_FIRST.format(
                BY_ITS_TANGENT.replace("wall W, ", "").format("1/2 u sin(alpha)/(1/3 u cos(alpha))")
            ),
            "does-not-follow",
        ),
        # along a wall is the cosine, away from it the sine, and neither has a sign
        *(
            (TO_THE_SECOND, TO_THE_FIRST.format(BY_ITS_SPEED.format(line, form)), "does-not-follow")
            for line, form in (
                (3, "sin(psi) = 1/2 u sin(alpha)"),
                (3, "cos(psi) = -1/2 u sin(alpha)"),
                (4, "cos(psi) = 1/3 u cos(alpha)"),
                (4, "sin(psi) = -1/3 u cos(alpha)"),
                (3, "cos(psi) = u sin(alpha)"),
            )
        ),
        (
            TO_THE_SECOND,
            TO_THE_FIRST.format(
                "speed 2 P | axis 2, let psi, 3 | speed(P, 1) cos(psi) = 1/2 u sin(alpha)"
            ),
            "does-not-follow",
        ),
    ],
)
def test_what_only_looks_right_is_refused(statement: str, working: str, expected: str) -> None:
    assert expected in complaints(statement, working)


@pytest.mark.parametrize(
    ("statement", "working"),
    [
        (SPHERES, AGAINST.format("<")),
        (
            SPHERES,
            (
                "1 a | let | | let q = c(A, 1) in the sense of -i\n"
                "2 a | law momentum 1 A B | 1, velocity A, mass A, mass B, axis 1, velocity B"
                " | 2 = -2q + 4*c(B, 1)"
            ),
        ),
        (PARALLEL, SECOND_WALL.format("u cos(alpha)")),
        (LEFT, ALONG_A_WALL.format("3")),
        (UPWARDS, IMPULSE.format("12")),
        (OPEN_RATIO, ARC.format("5e/3")),
        (OFF_A_LINE, OFF.format("90° - 30°")),
        (TWICE_REFLECTED, ZERO_OF_A_SUM.format("90°")),
        (LETTERS, "1 a | define speed | velocity A | speed(A, 0) = U"),
        (SUPPLEMENT, OF_A_SUPPLEMENT.format("U sin(alpha)", "-U cos(alpha)")),
        (TWO_RATIOS, FROM_TWO_RATIOS.format("arctan(2)")),
        (A_ROOT.format("1/2"), "1 a | rearrange | given 1 | e = 1/4"),
        (NAMED.format("90°"), BY_ITS_NAME),
        (SPHERES, f"1 a | {RESTITUTION} | c(B, 1) - c(A, 1) = 2 ≈ 2 [value]"),
        (
            WALL.format("sin(2alpha) = u cos(2alpha)"),
            "1 a | rearrange | given 1 | tan(2alpha) = u",
        ),
        (
            SQUARE,
            TO_THE_FIRST.format(
                BY_ITS_TANGENT.format("1/2 u sin(alpha)/(1/3 u cos(alpha))")
                + "\na: 5 tan(phi) = 1/2 u sin(alpha)/(1/3 u cos(alpha))"
            ),
        ),
        (LOST, LOST_AT_AN_END.format("k != 0 or energy_lost(1) = 0")),
        (STEEP, ONE_COMPONENT),
        (LOST, LOST_AT_AN_END.format("1/k != 0 or energy_lost(1) = 1/2 m u^2 (1 - e^2)")),
        *(
            (
                TO_THE_SECOND,
                TO_THE_FIRST.format(BY_ITS_SPEED.format(line, form) + f"\na: 5 speed(P, 2) {form}"),
            )
            for line, form in (
                (3, "cos(psi) = 1/2 u sin(alpha)"),
                (4, "sin(psi) = 1/3 u cos(alpha)"),
            )
        ),
    ],
)
def test_what_is_right_is_followed(statement: str, working: str) -> None:
    assert complaints(statement, working) == []


@pytest.mark.parametrize(
    ("root", "right"),
    [("abs(1 - 2e) u", True), ("(1 - 2e) u", False), ("-(1 - 2e) u", False), ("(2 - e) u", False)],
)
def test_a_speed_is_the_root_of_its_square_that_is_not_negative(root: str, right: bool) -> None:
    working = f"1 a | rearrange | given 1 | speed(P, 1) = {root}"
    assert (complaints(SPEED_SQUARED, working) == []) == right


def test_what_rests_on_a_fact_of_another_part_may_be_said_again() -> None:
    statement = SAID_IN_BOTH.format("5")
    again, twice = (AGAIN.format(item=n, fact=k) for n, k in (("b", 2), ("a", 1)))
    assert "said-before" not in complaints(statement, again)
    assert "said-before" in complaints(statement, twice)


# --- cases ----------------------------------------------------------------------------------------

EITHER = """
wall W: along i
sphere P: velocity p i - 4j
P hits W: e = 1/2
given speed(P) = 2sqrt(5)
find p
"""
SQUARES = """
1 a | law unchanged 1 P | velocity P, axis 1 | along(velocity(P, 1), i) = p
2 a | law restitution-wall 1 P | velocity P, axis 1, e 1 | along(velocity(P, 1), j) = 2
3 a | define speed 1 P | given 1, 1, 2 | (2sqrt(5))^2 = p^2 + 2^2
4 a | roots | 3 | p = 4 or p = -4
"""


@pytest.mark.parametrize(
    ("cases", "expected"),
    [
        ("case 1: line 4 option 0 lines 5", "case-missing"),
        ("case 1: line 4 option 0 lines 5\ncase 2: line 4 option 2 lines 6", "case-unknown"),
        # a line that stands in both cases does not rest on one of them
        ("case 1: line 4 option 0 lines 5\ncase 2: line 4 option 1 lines 5", "does-not-follow"),
    ],
)
def test_cases_are_all_there_and_apart(cases: str, expected: str) -> None:
    lines = f"{SQUARES}5 a | put | 1, 4 | along(velocity(P, 1), i) = 4\n"
    ends = "a: 5 case 1 along(velocity(P, 1), i) = 4"
    assert expected in complaints(EITHER, f"{lines}{cases}\n{ends}")


# --- what is compared -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("left", "right", "equal"),
    [
        ("sqrt(x/y)", "sqrt(x y)/y", False),
        ("sqrt((e - 1)/(2e - 3))", "sqrt((e - 1)(2e - 3))/(2e - 3)", False),
        ("sqrt(x^2/y^4)", "abs(x)/y^2", True),
        ("sqrt((2e - 1)/3)", "sqrt(3(2e - 1))/3", True),
    ],
)
def test_a_root_is_not_negative(left: str, right: str, equal: bool) -> None:
    world = World({})
    gap = world.scalar(read_tree(left, {})) - world.scalar(read_tree(right, {}))
    assert world.reduced(gap).vanishes == equal


@pytest.mark.parametrize("text", ["((((10^16)^16)^16)^16)^16", "(1 + a + b + c + d + f + g)^16"])
def test_what_is_too_long_is_refused_before_it_is_worked_out(text: str) -> None:
    with pytest.raises(NotComparableError):
        World({}).scalar(read_tree(text, {}))


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("lines", 0, "n"), []),
        (("lines", 0, "n"), True),
        (("lines", 0, "premises"), [["1"]]),
        (("lines", 0, "bodies"), [{}]),
        (("facts", 0, "id"), 3),
        (("facts", 0, "kind"), "rumour"),
        (("events", 0, "n"), "1"),
        (("events", 0, "wall"), 1),
        (("items", 0, "line"), None),
        (("names",), {"A": 1}),
    ],
)
def test_fields_of_the_wrong_kind_are_no_derivation(
    path: tuple[str | int, ...], value: object
) -> None:
    working = f"1 a | {RESTITUTION} | c(B, 1) - c(A, 1) = 2\na: 1 c(B, 1) - c(A, 1) = 2"
    whole = to_json(derivation_of(parse(SPHERES), working))
    from_json(whole)
    at = whole
    for key in path[:-1]:
        at = at[key]  # type: ignore[index]
    at[path[-1]] = value  # type: ignore[index]
    with pytest.raises(StatementError):
        from_json(whole)


# --- lines of students ----------------------------------------------------------------------------

WALL_IN_NUMBERS = """
wall W: along j
sphere P: mass 3, velocity 4i + 3j
P hits W: e = 1/2
find velocity(P)
"""
V_AND_W = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
"""
AFTER = ("v = -1", "along(velocity(A, 1), j) = 4")
LAWS = ("v + 2w = 1", "w - v = 2")


@pytest.mark.parametrize(
    ("statement", "text", "above", "law"),
    [
        (SPHERES, "2*3 - 2v = 4w + 4", (), "momentum"),
        (SPHERES, "2(3 - v) = 4(w + 1)", (), "momentum"),
        (SPHERES, "v = 1 - 2w", (), "momentum"),
        (SPHERES, "2*3 - 4 = 2v - 4w", (), None),
        (SPHERES, "3 - 1 = v + w", (), None),
        (SPHERES, "1/2 = (w - v)/(3 + 1)", (), "restitution"),
        (SPHERES, "0.5*(3 - (-1)) = w - v", (), "restitution"),
        (SPHERES, "(v - w)/4 = 1/2", (), None),
        (SPHERES, "along(velocity(A, 1), j) = 4", (), "unchanged"),
        (SPHERES, "along(velocity(A, 1), j) = 1", (), None),
        (SPHERES, "speed(A, 1)^2 = (-1)^2 + 4^2", AFTER, "speed"),
        (SPHERES, "speed(A, 1)^2 = 15", AFTER, None),
        (SPHERES, "energy(A, 1) = 17", AFTER, "energy"),
        (SPHERES, "energy(A, 1) = 34", AFTER, None),
        (SPHERES, "energy(0) = 29", (), "total"),
        (SPHERES, "energy_lost(1) = 8", ("v = -1", "w = 1"), "energy-lost"),
        (SPHERES, "energy_lost(1) = 12", ("v = -1", "w = 1"), None),
        (SPHERES, "impulse(1) = 4*(w + 1)", (), "impulse"),
        (SPHERES, "impulse(1) = 2*(3 + v)", (), None),
        (SPHERES, "3v = -3", LAWS, "combine"),
        (SPHERES, "v = 1", LAWS, None),
        (LETTERS, "e = (w - v)/(U cos(alpha))", (), "restitution"),
        (LETTERS, "U cos(alpha) = v + 2w", (), "momentum"),
        (LETTERS, "U sin(alpha) = v + 2w", (), None),
        (LETTERS, "v - w = e U cos(alpha)", (), None),
        (
            LETTERS,
            "v = (1 - 2e)U cos(alpha)/3",
            ("U cos(alpha) = v + 2w", "w - v = e U cos(alpha)"),
            "combine",
        ),
        (WALL_IN_NUMBERS, "along(velocity(P, 1), i) = -1/2*4", (), "restitution-wall"),
        (WALL_IN_NUMBERS, "along(velocity(P, 1), i) = 2", (), None),
        (WALL_IN_NUMBERS, "along(velocity(P, 1), i) = -1/2*4 = -2", (), "restitution-wall"),
        (WALL_IN_NUMBERS, "along(velocity(P, 1), i) = -1/2*4 = 2", (), None),
        (WALL_IN_NUMBERS, "impulse(P, 1) = -18i", ("velocity(P, 1) = -2i + 3j",), "impulse-vector"),
        (WALL_IN_NUMBERS, "impulse(P, 1) = 18i", ("velocity(P, 1) = -2i + 3j",), None),
    ],
)
def test_lines_of_students_are_known_by_their_law(
    statement: str, text: str, above: tuple[str, ...], law: str | None
) -> None:
    problem = parse(statement)
    names = names_of(problem)
    tracer = Tracer(derivation_of(problem, ""), oracle_of(problem))
    if "A" in names:
        for line in derivation_of(problem, V_AND_W).lines:
            tracer.add(line.number, line.relation)
    for number, each in enumerate(above, 3):
        tracer.add(number, read_relation(each, names))
    trace = tracer.trace(read_relation(text, names))
    if law is None:
        assert trace.kind == "unrecognised"
    else:
        assert trace.kind == "move"
        assert trace.move is not None
        assert law in (trace.move.record, trace.move.id)


@pytest.mark.parametrize(
    ("left", "right", "same"),
    [
        ("sqrt(8 - 4sqrt(3))", "sqrt(6) - sqrt(2)", True),
        ("sqrt(8 - 4sqrt(3))", "sqrt(2) - sqrt(6)", False),
        ("sqrt(5 + 2sqrt(6))", "sqrt(2) + sqrt(3)", True),
        ("sqrt((1 - sqrt(3))^2)", "sqrt(3) - 1", True),
        ("sqrt((1 - sqrt(3))^2)", "1 - sqrt(3)", False),
        ("sqrt(4 - sqrt(3))", "sqrt(6) - sqrt(2)", False),
        ("u sqrt(7 - 4sqrt(3))", "2u - sqrt(3) u", True),
    ],
)
def test_roots_of_surds_are_undone_with_their_sign(left: str, right: str, same: bool) -> None:
    world = World({"u": POSITIVE})
    gap = world.scalar(read_tree(left, {})) - world.scalar(read_tree(right, {}))
    assert world.reduced(gap).vanishes is same


@pytest.mark.parametrize(
    ("left", "right", "same"),
    [
        ("(1/10)^(1/6)", "100000^(1/6)/10", True),
        ("((1/10)^(1/6))^3", "1/sqrt(10)", True),
        ("(8/27)^(1/3)", "2/3", True),
        ("4^0.25", "sqrt(2)", True),
        ("2^(1/3) 4^(1/3)", "2", True),
        ("((1/10)^(1/6))^2", "1/sqrt(10)", False),
        ("(1/2)^(1/3)", "(1/2)^(1/5)", False),
    ],
)
def test_roots_of_a_higher_index_are_compared(left: str, right: str, same: bool) -> None:
    world = World({})
    gap = world.scalar(read_tree(left, {})) - world.scalar(read_tree(right, {}))
    assert world.reduced(gap).vanishes is same


def test_an_inequality_has_its_values_from_lines_that_it_cites() -> None:
    # Any two positive values are the one times what is positive: that puts nothing in.
    problem = parse(
        """
        wall W: along j
        sphere A: mass 3m, velocity 2u i
        sphere B: mass m, at rest
        A hits B: along i, e = e
        B hits W: e = 1/3
        given A and B collide again
        find range of e
        """
    )
    law = "mass A, velocity A, axis 1, mass B, velocity B, 1, 2"
    lines = f"""
    1 a | let | | let v = along(velocity(A, 1), line_of_centres(1))
    2 a | let | | let w = along(velocity(B, 1), line_of_centres(1))
    3 a | law momentum 1 A B | {law} | 3m (2u) = 3m v + m w
    4 a | law restitution 1 A B | e 1, velocity A, axis 1, velocity B, 1, 2 | w - v = e (2u)
    5 a | combine w | 3, 4 | v = (3 - e) u/2
    6 a | put | 4, 5 | w = 3(1 + e) u/2
    7 a | law restitution-wall 2 B | axis 1, axis 2, e 2, 2, 6 | along(velocity(B, 2), i) = -(1 + e) u/2
    8 a | put | given 1, axis 1, 1, {{}}7 | (3 - e) u/2 > -(1 + e) u/2
    """  # noqa: E501
    for cited, wrong in (("5, ", False), ("", True)):
        complaints = follow(derivation_of(problem, lines.format(cited)), oracle_of(problem))
        bad = {each.line for each in complaints if each.reason == "does-not-follow"}
        assert bad == ({8} if wrong else set())


@pytest.mark.parametrize(
    ("line", "follows"),
    [
        ("energy(0) (1 - e^2) = (m u^2 + M v^2)(1 - e^2)/2", True),
        ("(1 - e^2) energy(0) = (1 - e^2)(m u^2 + M v^2)/2", True),
        ("energy(0) (1 - e^2) = (m u^2 + M v^2)(1 + e^2)/2", False),
        ("energy(0) (1 - e^2) = (m u^2 - M v^2)(1 - e^2)/2", False),
    ],
)
def test_both_sides_times_what_may_vanish(line: str, follows: bool) -> None:
    """1 − e² is 0 for e = 1, and yet an equation may be multiplied by it."""
    problem = parse(
        "sphere A: mass m, velocity u i\nsphere B: mass M, velocity -v i\nA hits B: along i\n"
        "find energy(0) (1 - e^2)"
    )
    lines = f"""
    1 a | define energy | mass A, velocity A, mass B, velocity B | energy(0) = (m u^2 + M v^2)/2
    2 a | rearrange | 1 | {line}
    """
    complaints = follow(derivation_of(problem, lines), oracle_of(problem))
    assert (2 in {each.line for each in complaints if each.reason == "does-not-follow"}) != follows


@pytest.mark.parametrize(
    ("impulse", "follows"),
    [
        ("abs(m (a + e a))", True),
        ("abs(-m (1 + e) a)", True),
        ("abs(m (a - e a))", False),
        ("abs(m a) + abs(e a)", False),
    ],
)
def test_the_size_of_an_impulse_in_either_sense(impulse: str, follows: bool) -> None:
    """The letter a is a component of the data, and P may come from either side."""
    problem = parse("wall W: along j\nsphere P: mass m, velocity a i - b j\nP hits W\nfind impulse")
    lines = f"""
    1 a | law restitution-wall 1 P | axis 1, velocity P, e 1 | along(velocity(P, 1), i) = -e a
    2 a | law impulse 1 P | mass P, velocity P, axis 1, 1 | impulse(1) = {impulse}
    """
    complaints = follow(derivation_of(problem, lines), oracle_of(problem))
    assert (2 in {each.line for each in complaints if each.reason == "does-not-follow"}) != follows


def test_a_fact_of_a_letter_that_nothing_needs_is_no_fault() -> None:
    """With e₂ = e₁ the speed is e₁u at any angle, and the working says so."""
    problem = parse(
        "wall AB: along i\nwall BC: along j\nsphere P: mass m, velocity u at alpha to AB\n"
        "P hits AB: e = e1\nP hits BC: e = e2\nfind speed(P)\n"
        "part b\ngiven e1 = e2, tan(alpha) = 2, speed(P) = 3/5 u\nfind e1"
    )
    explanation = explain(solve(problem), check=True)
    assert explanation.followed
    assert "It is also given that tan α = 2, which is not needed here." in str(explanation)


@pytest.mark.parametrize(
    "statement",
    [
        # |u| of a velocity given by its size and an angle is that size, with no sin² + cos².
        (
            "wall V: along i\nwall W: along j\nsphere P: mass m, velocity 3u at alpha to V\n"
            "P hits V: e = 3/5\nP hits W: e = 3/4\nfind angle(velocity(P), velocity(P, 0))"
        ),
        # (2 + √3)√(8√3 − 13) = √(5 + 4√3)
        (
            "wall W: along 30°\nsphere P: mass 2, velocity -4i + 2j\nP hits W\n"
            "given energy_lost = 2\nfind e, deflection(P)"
        ),
        # v² = −1 is no multiple of another equation that has no solution either.
        (
            "sphere A: mass 3, velocity 5 at alpha\nsphere B: mass 2, at rest\n"
            "A hits B: along 3i + 4j\ngiven tan(alpha) = 1/2, speed(A) = 2\nfind e, impulse"
        ),
        (
            "wall W: along j\nsphere P: mass 0.5, velocity 5 at alpha to W\nP hits W\n"
            "given tan(alpha) = 3/4, speed(P) = 3\nfind e"
        ),
        # β = α and tan α = e tan α say nothing of the size of α.
        (
            "wall W: along i\nsphere P: mass m, velocity 2u at alpha to W\nP hits W\n"
            "given tan(alpha) = 1/2, deflection(P) = 2 angle(velocity(P), W)\nfind e"
        ),
    ],
)
def test_workings_of_which_each_line_is_followed(statement: str) -> None:
    assert explain(solve(parse(statement)), check=True).followed


@pytest.mark.parametrize(
    ("left", "right", "equal"),
    [
        ("abs(2 - 2/tan(40°))", "2/tan(40°) - 2", True),
        ("abs(2 - 2/tan(40°))", "2 - 2/tan(40°)", False),
        ("abs(sqrt(2) sin(25°) - cos(25°))", "cos(25°) - sqrt(2) sin(25°)", True),
        ("abs(2 sin(35°) - 3 cos(20°))", "2 sin(35°) - 3 cos(20°)", False),
    ],
)
def test_digits_tell_the_sign_of_a_number(left: str, right: str, equal: bool) -> None:
    world = World({})
    one, other = (world.scalar(read_tree(text, {})) for text in (left, right))
    assert (one - other).vanishes == equal
