"""The numbers of a counter-example, as people see them."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.expression.tree import Expression
from restitution.render import layout as lay
from restitution.render.layout import Layout


def _number(text: str) -> sp.Expr | None:
    """A number of a counter-example that was chosen: ``9/10``, ``pi/18``; None for a surd."""
    try:
        number = sp.Rational(text.replace("*pi", "").replace("pi", "1"))
    except (TypeError, ValueError):
        return None
    return number * sp.pi if "pi" in text else number


def instances(given: Mapping[str, str]) -> list[Layout]:
    """The numbers of a counter-example, each with its letter: ``α = 10°``, ``e = 9/10``."""
    return [
        lay.equation(
            lay.letter(name),
            lay.from_tree(_read(text)) if _number(text) is None else _number_look(text),
        )
        for name, text in given.items()
    ]


def _read(text: str) -> Expression:
    # It loads the parser, which a working seldom needs.
    from restitution.expression.reading import read_number

    return read_number(text)


def _number_look(text: str) -> Layout:
    return lay.from_sympy(_number(text), degrees="pi" in text)
