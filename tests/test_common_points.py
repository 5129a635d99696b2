"""Points on which equations and other formulas hold together, as floats show them."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.oracle import Relation
from restitution.oracle.common_points import seem_to_hold_together
from restitution.oracle.formula import Some
from restitution.oracle.roles import ACUTE, COEFFICIENT, POSITIVE, REAL

E, K, U, V, W, ALPHA = sp.symbols("e k u v w alpha")
ROLES = {"e": COEFFICIENT, "k": POSITIVE, "u": POSITIVE, "v": REAL, "w": REAL, "alpha": ACUTE}


def equation(value: sp.Expr) -> Relation:
    return Relation(value, "=")


IMPACT = (equation(V + K * W - U), equation(W - V - E * U))  # u along the line of centres, mass km


@pytest.mark.parametrize(
    "formulas",
    [
        (*IMPACT, Relation(-V, ">")),  # A turns round: ek > 1
        (*IMPACT, equation(V)),
        (*IMPACT, equation(W - U), equation(E - 1)),  # k = 1
        (equation(sp.tan(ALPHA) ** 2 - E), Relation(sp.tan(ALPHA) - sp.Rational(9, 10), ">")),
        (equation(V - W), equation(2 * V - 2 * W)),  # a consequence closes no gap of its own
        (equation(V**2 - 2 * U**2), Some((Relation(V - U, ">"), equation(V + U)))),
    ],
)
def test_what_holds_somewhere_is_seen(formulas: tuple[Relation, ...]) -> None:
    assert seem_to_hold_together(formulas, ROLES)


@pytest.mark.parametrize(
    "formulas",
    [
        (*IMPACT, Relation(-W, ">")),  # B goes on forwards
        (*IMPACT, Relation(W - V - U, ">")),  # e ≤ 1
        (equation(V**2 + U**2),),
        (equation(K + E),),  # k is positive
        (equation(sp.tan(ALPHA) ** 2 - E), Relation(sp.tan(ALPHA) - 1, ">")),
        (equation(sp.cos(ALPHA) - 2),),
        (equation(sp.sqrt(V) + W**2 + 1),),
        (equation(V), Relation(V, "!=")),
        (equation(V - W), Relation(W - 2, ">"), Relation(1 - V, ">")),  # slopes that depend
        (equation(V - E), Relation(V, ">"), Relation(-E, ">"), Relation(E - 1, ">=")),
        (equation(sp.cos(ALPHA)),),  # at the end of its range, which is open
    ],
)
def test_what_never_holds_is_not_seen(formulas: tuple[Relation, ...]) -> None:
    assert not seem_to_hold_together(formulas, ROLES)


def test_slopes_that_depend_on_each_other_break_nothing_off() -> None:
    """Their rows differ by rounding, by which nothing is divided."""
    e, q = sp.symbols("e1 q")
    formulas = (Relation(q, ">"), Relation(sp.Rational(1, 3) - q, ">"), equation(q - e))
    assert not seem_to_hold_together((*formulas, Relation(e - sp.Rational(1, 3), ">=")), {})
