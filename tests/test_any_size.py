"""Answers do not hang on the units: an electron's mass is no reason for another verdict."""

from __future__ import annotations

import pytest
import sympy

import restitution
from restitution.workings import explain

# M, V and L stand for the units of mass, speed and length; what is asked scales as it says.
STORIES = {
    "energy lost": (
        """sphere A: mass 2*M, velocity 3*V i + 4*V j
sphere B: mass 3*M, at rest
A hits B: along i
given energy_lost = 27/10*M*V^2
find e, speed(A), deflection(A), impulse, energy(B)""",
        ("1", "V", "1", "M*V", "M*V^2"),
    ),
    "a range": (
        """wall W: along i
sphere P: velocity 3*V i - 4*V j
P hits W
given speed(P) < 4*V
find range of e
show speed(P) < 5*V
show speed(P) >= 3*V
show speed(P) > 3*V""",
        ("1", "", "", ""),
    ),
    "two roots": (
        """sphere A: mass M, velocity 5*V i
sphere B: mass 4*M, velocity -V i
A hits B: along i
given energy(A) = 9/2*M*V^2
find velocity(A), e""",
        ("V", "1"),
    ),
    "places": (
        """wall W: along j, through (12*L, 0)
sphere P: velocity 4*V i + 3*V j, at (0, 0)
P hits W: e = 1/2
find time(1), position(P, 1), speed(P)""",
        ("L/V", "L", "V"),
    ),
}
SIZES = [
    ("10^-30", "10^7", "10^-10"),
    ("10^30", "10^4", "10^11"),
    ("10^-27", "10^-8", "10^-9"),
    ("10^-60", "10^-60", "10^-60"),
    ("10^60", "10^-60", "10^60"),
]


def _solved(text, m, v, length):
    for letter, size in (("M", m), ("V", v), ("L", length)):
        text = text.replace(f"*{letter}", f"*({size})").replace(f"mass {letter}", f"mass {size}")
        text = text.replace(f"-{letter} ", f"-({size}) ")
    return restitution.solve(restitution.parse(text))


@pytest.mark.parametrize("sizes", SIZES)
@pytest.mark.parametrize("name", STORIES)
def test_answers_scale_with_the_units(name, sizes):
    text, scales = STORIES[name]
    plain, scaled = _solved(text, "1", "1", "1"), _solved(text, *sizes)
    units = dict(zip("MVL", (sympy.Rational(eval_power(each)) for each in sizes), strict=True))
    pairs = zip(plain.items(), scaled.items(), scales, strict=True)
    for (_, one), (_, other), scale in pairs:
        assert (one.error is None, one.holds, one.proof == "undecided") == (
            other.error is None,
            other.holds,
            other.proof == "undecided",
        )
        assert len(one.answers) == len(other.answers)
        factor = sympy.Integer(1)
        if scale not in ("", "1"):
            factor = sympy.sympify(scale, locals={k: sympy.Symbol(k) for k in "MVL"}).subs(
                {sympy.Symbol(k): x for k, x in units.items()}
            )
        for a, b in zip(one.answers, other.answers, strict=True):
            assert _times(a.value, factor) == b.value


def _times(value, factor):
    if isinstance(value, tuple):
        return tuple(_times(each, factor) for each in value)
    return value if isinstance(value, sympy.Set) else restitution.exact.tidy(value * factor)


def eval_power(text: str) -> str:
    """``10^-30`` as a fraction."""
    power = int(text.removeprefix("10^"))
    return f"1e{power}"


@pytest.mark.parametrize("name", STORIES)
def test_no_line_is_lost(name):
    plain, scaled = (_solved(STORIES[name][0], *each) for each in (("1", "1", "1"), SIZES[0]))
    one, other = (explain(each) for each in (plain, scaled))
    notes = [[each.item for each in own.parts[0].derivation.notes] for own in (one, other)]
    # A question may have a plan at one size and none at another: their marks are not compared.
    if notes[0] == notes[1]:
        assert one.marks == other.marks


# Decided by hand, in units of which all products are far below what floats can hold.
WALL = "wall W: along i\nsphere P: mass 10^-60, velocity 10^-60 at 30° to W\nP hits W\n"


SMALL = """sphere A: mass 10^-60, velocity 10^-60 i
sphere B: mass 10^-60, at rest
A hits B: along i
"""
ENERGY = "3/16*10^-60*10^-60*10^-60"
THREE_QUARTERS = SMALL + "given speed(B) = 3/4*10^-60\n"
STRAIGHT = "wall W: along i\nsphere P: mass 1, velocity -2j\nP hits W\n"


def _only(text):
    ((_, result),) = restitution.solve(restitution.parse(text)).items()
    return result


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        # v_B = (1 + e)u/2 and v_A = (1 − e)u/2: with v_B = 3u/4, e = 1/2; lost ¼mu²(1 − e²).
        (THREE_QUARTERS + "show speed(A) = 1/4*10^-60", True),
        (THREE_QUARTERS + f"show energy_lost = {ENERGY}", True),
        (THREE_QUARTERS + f"show energy_lost < {ENERGY}", False),
        (SMALL + "given speed(B) > 3/4*10^-60\nshow e > 1/2", True),
        (SMALL + "given speed(B) >= 3/4*10^-60\nshow e > 1/2", False),
        # The impulse of a wall is (1 + e)mu sin 30°, so that e = 1/2 for 3mu/4.
        (WALL + "given impulse = 3/4*10^-60*10^-60\nshow e = 1/2", True),
        (WALL + "given impulse = 3/4*10^-60*10^-60\nshow e > 1/2 - 10^-60*10^-60", True),
        (WALL + "given impulse = 3/4*10^-60*10^-60\nshow e > 1/2 + 10^-60*10^-60", False),
    ],
)
def test_verdicts_in_the_smallest_units(text, verdict):
    result = _only(text)
    assert result.holds is verdict
    assert result.proof in ("algebra", "decision", "witness")


@pytest.mark.parametrize(("power", "count"), [("10^-60", 1), ("10^-64", 7)])
def test_a_coefficient_is_above_one_however_little(power, count):
    above = "*".join([power] * count)
    text = STRAIGHT + "given impulse = 4 + {}\nfind e"
    allowed = _only(text.format(f"0*{above}"))
    result = _only(text.format(above))
    assert [each.value for each in allowed.answers] == [1]
    assert result.answers == () and "rejected" in str(result.error)


def test_a_coefficient_is_below_one_however_little():
    below = "*".join(["10^-64"] * 7)
    text = STRAIGHT + f"given impulse = 4 - {below}"
    result = _only(text + "\nfind e\n")
    (answer,) = result.answers
    assert answer.value == 1 - sympy.Rational(1, 2 * 10**448)


def test_an_angle_too_small_for_its_digits_has_its_side():
    """A sphere that is turned by a hair's breadth: which side of 90° is told by exact signs."""
    tiny = sympy.Rational(1, 10**120)
    sides = [(1, tiny), (1, -tiny), (-1, tiny), (-1, -tiny), (tiny, 1), (-tiny, 1), (-tiny, -1)]
    for x, y in ((sympy.sympify(a), sympy.sympify(b)) for a, b in sides):
        angle = restitution.exact.tidy_angle(sympy.atan2(y, x))
        gap = (angle - sympy.atan2(y, x)).evalf(200, maxn=1000)
        assert abs(gap) < sympy.Float(10) ** -190
