"""Energies that are compared with each other: all by sin²α and cos²α, and neither by the other.

``cos²α + 16 sin²α`` is equal to ``9 cos²α``: so tan²α comes at once. With ``1 + 15 sin²α`` for it
the 1 would be changed back.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import Expression, Quantity, has_quantity, is_binary, walk
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.definitions import Formula
from restitution.planning.writing.desk import UNPLANNED, chain
from restitution.planning.writing.forms import ZERO, swept, tree_of
from restitution.planning.writing.polynomials import expanded, factored, polynomial_in
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass

_SQUARES = 2


@dataclass
class InSquares:
    """An energy by its definition, which comes to a sum of squares of ratios of one angle."""

    own: Formula
    value: sp.Expr

    def write(self, scene: Scene) -> tuple[int, Expression]:
        """The line of the energy, and what it comes to."""
        final = tree_of(self.value, as_it_is=True)
        relation = chain(self.own.left, (swept(self.own.right), None), (final, "rearrange"))
        number = scene.desk.write(self.own.move, self.own.refs, relation)
        scene.desk.know(self.own.quantity, self.own.value, (number,))
        return number, final


def energies_in_squares(scene: Scene, equation: GivenEquation) -> dict[Expression, InSquares]:
    """The energies of an equation as sums of squares of sines and cosines, by their quantities.

    Nothing where a term of it is no energy, or a ratio of two, where one is not homogeneous in
    both ratios of one angle, or is asked for itself.
    """
    sides = (equation.link.left, equation.link.right)
    energies = [
        node
        for side in sides
        for node in walk(side)
        if isinstance(node, Quantity) and node.kind in ENERGIES
    ]
    without: dict[Expression, Expression] = dict.fromkeys(energies, ZERO)
    rests = [exchanged(side, without) for side in sides]
    if not energies or any(energy in scene.asked_alone for energy in energies):
        return {}
    if any(
        is_binary(node, "/") and has_quantity(node.right) for side in sides for node in walk(side)
    ):
        return {}
    if any(map(has_quantity, rests)) or any(map(scene.scalar, rests)):
        return {}
    kept: dict[Expression, InSquares] = {}
    angles: set[Any] = set()
    for energy in dict.fromkeys(energies):
        known = scene.desk.known(energy)
        try:
            own = None if known is not None else formula(scene, energy)
        except UNPLANNED:
            return {}
        raw = scene.scalar(own.right) if own is not None else known and known.value
        value = expanded(scene.put(raw)[0])
        if not _is_of_squares(value):
            return {}
        angles |= {ratio.args[0] for ratio in value.atoms(sp.sin, sp.cos)}
        if own is not None:
            kept[energy] = InSquares(own, factored(value))
    both = any(own.value.has(sp.sin) and own.value.has(sp.cos) for own in kept.values())
    return kept if both and len(angles) == 1 else {}


def _is_of_squares(value: sp.Expr) -> bool:
    """Whether each term has the square of a sine or of a cosine, of one angle all."""
    angles = {ratio.args[0] for ratio in value.atoms(sp.sin, sp.cos)}
    if len(angles) != 1 or value.has(sp.tan):
        return False
    (angle,) = angles
    if not angle.is_Symbol:
        return False
    sine, cosine = sp.Dummy(), sp.Dummy()
    plain = value.xreplace({sp.sin(angle): sine, sp.cos(angle): cosine})
    if plain.has(angle) or not plain.is_polynomial(sine, cosine):
        return False
    return {sum(powers) for powers in polynomial_in(plain, sine, cosine).monoms()} == {_SQUARES}


__all__ = ["energies_in_squares"]
