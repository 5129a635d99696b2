"""Directions that are read off, where a scalar product or a tangent would be a detour."""

from __future__ import annotations

import pytest
from test_planning_closing import lines, planned, said

from restitution.workings import explain, to_text

AT_REST = "sphere A: mass {a}, velocity u at alpha\nsphere B: mass {b}, at rest\nA hits B: along i"


@pytest.mark.parametrize(("a", "b", "e"), [("m", "5m", "1/5"), ("2m", "3m", "2/3")])
def test_at_right_angles_to_who_moves_along_the_line_of_centres(a: str, b: str, e: str) -> None:
    text = f"{AT_REST.format(a=a, b=b)}\ngiven velocity(A) perpendicular to velocity(B)\nfind e"
    solution, derivation = planned(text)
    (square,) = lines(derivation, "define")
    assert square.relation.only[-1].right.value == 0  # type: ignore[union-attr]
    assert "v = 0" in said(derivation)
    assert not lines(derivation, "combine")
    assert not lines(derivation, "roots")
    assert said(derivation)[-1] == f"e = {e}"
    words = " ".join(to_text(explain(solution), 200).split())
    assert "B moves along the line of centres, so A moves perpendicular to it: v = 0 B1" in words


def test_both_components_count_where_both_spheres_move_across() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity -i - j\n"
        "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B)\nfind e"
    )
    assert "v = 0" not in said(derivation)
