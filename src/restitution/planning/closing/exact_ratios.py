"""Ratios such as tan 75°, which have roots, beside ratios that have no exact value."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Apply, Degrees, Expression, Letter, walk
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import one_fraction, polynomial_in
from restitution.planning.writing.scene import Scene


def by_ratios_as_they_are(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The line ``v = u sin 50°/tan 75°`` of a linear equation, with the ratio as it is given.

    None where no ratio has roots, where all have exact values, and where it does not follow.
    """
    link = scene.desk.last_link(number)
    nodes = {node for side in (link.left, link.right) for node in walk(side)}
    ratios = {e: scene.scalar(e) for e in nodes if isinstance(e, Apply) and _is_of_degrees(e)}
    rooted = [e for e, value in ratios.items() if value.is_Add or sp.fraction(value)[1].is_Add]
    if not rooted or not any(value.has(sp.sin, sp.cos, sp.tan) for value in ratios.values()):
        return None
    aside: dict[Expression, Expression] = {e: Letter(f"ratio_{n}") for n, e in enumerate(rooted)}
    put = {f"ratio_{n}": sp.Dummy(f"ratio_{n}", positive=True) for n in range(len(rooted))}
    sides = [scene_value(scene, exchanged(e, aside), put) for e in (link.left, link.right)]
    above = sp.fraction(one_fraction(sides[0] - sides[1]))[0]
    if not above.is_polynomial(symbol) or sp.degree(above, symbol) != 1:
        return None
    poly = polynomial_in(above, symbol)
    named = {own: sp.Symbol(name, positive=True) for name, own in put.items()}
    own = sp.factor(-poly.nth(0) / poly.nth(1)).xreplace(named)
    tree = exchanged(tree_of(own), {letter: node for node, letter in aside.items()})
    last = tree_of(tidy(scene.scalar(tree)))
    move = ((tree, None), (last, "rearrange"))
    return scene.judge.write((Move("rearrange"),), (number,), chain(Letter(symbol.name), *move))  # type: ignore[arg-type]


def _is_of_degrees(ratio: Apply) -> bool:
    return ratio.function in ("sin", "cos", "tan") and isinstance(ratio.argument, Degrees)


__all__ = ["by_ratios_as_they_are"]
