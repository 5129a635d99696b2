"""An angle as a decimal number of degrees."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import sympy as sp

from restitution import exact
from restitution.exact.symbols import symbols_in
from restitution.explaining.lines.derivation import Link, Move, Relation, equality
from restitution.expression.tree import (
    Degrees,
    Expression,
    Negate,
)
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene

_FIGURES = 3


def write_decimal(scene: Scene, line: int) -> tuple[int, Relation]:
    """The line again in figures, where it says a number that needs them, and the answer."""
    own = scene.desk.last_link(line)
    answer = equality(own.left, own.right)
    value = scene.scalar(own.right)
    if symbols_in(value) or _in_degrees(own.right):
        return line, answer
    whole = tree_of(exact.tidy(value), angle=True)
    if _in_degrees(whole):
        answer = equality(own.left, whole)
        return scene.desk.write(Move("rearrange"), (line,), answer), answer
    rounded = _rounded(value * 180 / sp.pi)
    answer = Relation(((Link(own.left, "≈", rounded),),))
    return scene.desk.write(Move("value"), (line,), answer), answer


def _in_degrees(tree: Expression) -> bool:
    return isinstance(tree, Degrees) or (
        isinstance(tree, Negate) and isinstance(tree.operand, Degrees)
    )


def _rounded(degrees: Any) -> Expression:
    """An angle to three figures."""
    number = Fraction(str(exact.significant(degrees, _FIGURES)).replace("−", "-"))
    return Negate(Degrees(-number)) if number < 0 else Degrees(number)
