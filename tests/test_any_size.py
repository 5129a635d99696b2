"""Answers do not hang on the units: an electron's mass is no reason for another verdict."""

from __future__ import annotations

import pytest
import sympy

import restitution
from restitution.explain import explain

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
    assert "left out" not in str(other)
    assert one.marks == other.marks
