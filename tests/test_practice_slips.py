"""Slips: each change at one place is offered, and none that changes nothing."""

from __future__ import annotations

from fractions import Fraction

import pytest

from restitution.expression import read_expression
from restitution.practice.judging.slips import (
    LIMIT,
    corrections,
    misreadings,
    near_numbers,
    read_as_datum,
)
from restitution.practice.reading.lines import read_as, text_of
from restitution.practice.script import Claim


def _claim(left: str, right: str) -> Claim:
    return Claim(read_expression(left), "=", read_expression(right))


@pytest.mark.parametrize(
    ("wrong", "right", "change"),
    [
        ("2v + 3w", "2v - 3w", "sign"),
        ("-v", "v", "sign"),
        ("3.2 + 4", "3.5 + 4", "figure"),
        ("21 v", "12 v", "figure"),
        ("0.4 v", "4 v", "figure"),
        ("m v", "m v^2", "power"),
        ("sqrt(u)", "u", "power"),
        ("2 v + w", "v + w", "factor"),
        ("m v + w", "m v + v", "letter"),
        ("3/5", "1/(3/5)", "turned"),
    ],
)
def test_a_change_at_one_place_is_offered(wrong: str, right: str, change: str) -> None:
    offered = {(each.change, each.claim.right) for each in corrections(_claim("m", wrong))}
    assert (change, read_expression(right)) in offered


def test_no_correction_is_the_claim_itself() -> None:
    claim = _claim("2 u + 3 v", "0.25 w - 7 sin(30°)")
    assert all(each.claim != claim for each in corrections(claim))


def test_corrections_are_bounded() -> None:
    many = " + ".join(f"{n}.25 v" for n in range(100, 140))
    assert sum(1 for _ in corrections(_claim("u", many))) == LIMIT


def test_the_calculator_in_radians_takes_degrees_for_radians() -> None:
    offered = [each for each in corrections(_claim("v", "5 sin(30°)")) if each.change == "radians"]
    assert [each.claim.right for each in offered] == [read_expression("5 sin(30*180°/pi)")]


def test_near_numbers_differ_by_one_figure() -> None:
    near = near_numbers(Fraction("0.45"))
    assert {Fraction("0.54"), Fraction("0.46"), Fraction("4.5")} <= set(near)
    assert Fraction("0.45") not in near
    assert near_numbers(Fraction(1, 3)) == ()


def test_a_number_typed_twice_may_stand_for_a_datum() -> None:
    typed = [Fraction(5), Fraction(5), Fraction(3), Fraction(7)]
    assert list(misreadings(typed, [Fraction(3), Fraction(4)])) == [(Fraction(5), Fraction(4))]
    assert read_as_datum(_claim("5 v", "w + 5"), Fraction(5), Fraction(4)) == _claim("4 v", "w + 4")


def test_a_line_is_written_as_it_was_read() -> None:
    u, v = read_expression("1/2 u"), read_expression("v_1")
    assert text_of(v) == "v₁"
    assert read_as([Claim(v, "=", u), Claim(u, "<=", read_expression("3"))]) == "v₁ = ½u ≤ 3"
