"""Equations in tangents alone, one of them of an angle and some degrees: by the formula for it.

``tan(α − 30°) = ⅓ tan α`` becomes ``(tan α − √3/3)/(1 + √3/3 tan α) = ⅓ tan α``, with no sine and
no cosine on the way.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Move
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    is_function,
    letters,
    walk,
)
from restitution.planning.closing.ratios import ratio
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import ONE, difference, product, swept, total, tree_of
from restitution.planning.writing.scene import Scene


def tangent_of_a_sum(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """An angle by its tangent, where one of a sum with it stands; None of any other equation."""
    link = scene.desk.last_link(line)
    nodes = [node for side in (link.left, link.right) for node in walk(side)]
    functions = [node for node in nodes if is_function(node, "sin", "cos", "tan", "cot")]
    angle = Letter(symbol.name)
    whole = Apply("tan", angle)
    sums = [node for node in functions if node != whole and symbol.name in letters(node)]
    opened = {node: _opened(node, angle) for node in sums}
    # What is 90° less an angle has a plainer form.
    if not sums or whole not in functions or None in opened.values():
        return None
    left, right = (swept(exchanged(side, opened)) for side in (link.left, link.right))  # type: ignore[arg-type]
    move = Move("identity", "sum-of-angles")
    standing = scene.desk.mark()
    written = scene.judge.write((move,), (line,), chain(left, (right, None)))
    own = None if written is None else ratio(scene, written, symbol)
    if own is None:
        scene.desk.back(standing)
    return own


def _opened(node: Expression, angle: Letter) -> Expression | None:
    """The tangent of a sum, or a difference, of an angle and some degrees, by those of both."""
    match node:
        case Apply("tan", Binary("+" | "-" as sign, one, other)) if angle in (one, other):
            degrees = other if one == angle else one
        case _:
            return None
    if not isinstance(degrees, Degrees) or degrees.value % 90 == 0:
        return None
    number = tidy(tangent_of_angle(sp.pi * sp.Rational(str(degrees.value)) / 180))
    if number.has(sp.tan):
        return None
    sides = [Apply("tan", angle) if e == angle else tree_of(number) for e in (one, other)]
    below = product(tree_of(number), Apply("tan", angle))
    if sign == "+":
        return Binary("/", total(sides), difference(ONE, below))
    return Binary("/", difference(*sides), total((ONE, below)))
