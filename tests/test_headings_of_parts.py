"""Headings in late parts: each impact has its own above all that is said of it there."""

from __future__ import annotations

import restitution as r
from restitution.language import parse

THREE = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
sphere C: mass {c}m, at rest
part a
A hits B: along i, e = {e}
find speed(B)
part b
B hits C: along i, e = {f}
find speed(C)
part c
{last}
"""
FIRST, SECOND = "First impact: A hits B", "Second impact: B hits C"


def part_c(last: str, c: str = "", e: str = "1/2", f: str = "1/3") -> str:
    statement = THREE.format(c=c, e=e, f=f, last=last)
    explanation = r.explain(r.solve(parse(statement)), check=True)
    assert not explanation.warnings
    return " ".join(str(explanation).split()).partition("(c) ")[2]


def test_values_of_an_impact_stand_under_its_heading() -> None:
    text = part_c("given tan(alpha) = 3/4\nfind deflection(A)")
    assert text.index("cos α = ⅘") < text.index(FIRST) < text.index("w₁ = 3u/5")
    assert text.index(FIRST) < text.index("v₁ = u/5") < text.index("stays u sin α")


def test_values_of_the_other_impact_have_a_heading_too() -> None:
    text = part_c("given tan(alpha) = 3/4\nfind deflection(A), energy_lost(2)")
    assert text.count(FIRST) == text.count(SECOND) == 1
    assert text.index("≈ 34.7°") < text.index(SECOND) < text.index("w₂ = 2u/5")


def test_a_part_below_says_once_more_of_which_impact_it_speaks() -> None:
    text = part_c("find velocity(B)", c="2")
    assert SECOND not in text  # what it needs stands above
    statement = THREE.format(c="2", e="1/2", f="1/3", last="find velocity(C)").replace(
        "find speed(C)", "find speed(A)"
    )
    text = " ".join(str(r.explain(r.solve(parse(statement)))).split()).partition("(c) ")[2]
    assert text.startswith(SECOND)


def test_what_is_put_in_is_the_ratio_that_stands_there() -> None:
    text = part_c("given tan(alpha) = 3/4, e = 1/2\nfind deflection(A)", e="e", f="e")
    assert "Since e = ½, substituting for cos α" in text
    assert "substituting for sin α" not in text
