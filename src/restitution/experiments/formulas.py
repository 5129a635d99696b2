"""The formulas of a wall as they are printed in reports and on worksheets."""

from __future__ import annotations

import re

from restitution.render.document import Inline
from restitution.render.layout import (
    Fraction,
    Function,
    Layout,
    Letter,
    Phrase,
    Product,
    Relation,
)

ALPHA, BETA, E = Letter("alpha"), Letter("beta"), Letter("e")
U, V = Letter("u"), Letter("v")
TAN_ALPHA, TAN_BETA = Function("tan", ALPHA), Function("tan", BETA)
RATIO = Phrase((TAN_BETA, TAN_ALPHA), " / ")


def _equal(*sides: Layout) -> Layout:
    return Relation(sides, ("=",) * (len(sides) - 1))


FORMULAS: dict[str, Layout] = {
    "alpha": ALPHA,
    "beta": BETA,
    "e": E,
    "u": U,
    "v": V,
    "tan_alpha": TAN_ALPHA,
    "tan_beta": TAN_BETA,
    "ratio": RATIO,
    "along": _equal(Product((V, Function("cos", BETA))), Product((U, Function("cos", ALPHA)))),
    "across": _equal(Product((V, Function("sin", BETA))), Product((E, U, Function("sin", ALPHA)))),
    "law": _equal(TAN_BETA, Product((E, TAN_ALPHA))),
    "e_of_angles": _equal(E, Fraction(TAN_BETA, TAN_ALPHA)),
}
"""What may stand in braces in `mixed`."""

_NAME = re.compile(r"\{(\w+)\}")


def mixed(text: str) -> Inline:
    """Words with formulas in them by name: ``"the slope is {e}"``.

    Raises KeyError for a name that FORMULAS does not have.
    """
    pieces = _NAME.split(text)
    return tuple(
        FORMULAS[piece] if index % 2 else piece for index, piece in enumerate(pieces) if piece
    )
