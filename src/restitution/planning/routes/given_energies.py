"""Kinetic energies that are given as shares of others: without the mass, by squares of speeds."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Move
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.formulas.fractions_lost import fraction_lost
from restitution.planning.formulas.velocity_formulas import squares
from restitution.planning.routes.quoted import as_shown
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import ONE, product, product_without, swept, tree_of
from restitution.planning.writing.polynomials import factored
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def write_share_of_energy(scene: Scene, equation: GivenEquation, left: Quantity) -> int | None:
    """The line of an energy, or of a loss, that is a multiple of an energy before it.

    None of anything else, and where the mass does not cancel.
    """
    if left.kind == "energy":
        return _of_two_energies(scene, equation, left)
    return _of_a_loss(scene, equation, left) if left.kind in LOSSES else None


def _other_energy(equation: GivenEquation) -> tuple[Quantity, Expression] | None:
    """The one energy on the right of a given equation, and its factor; None without one."""
    others = [node for node in walk(equation.link.right) if is_quantity(node, "energy")]
    if len(others) != 1:
        return None
    factor = product_without(equation.link.right, others[0])
    return None if factor is None else (others[0], factor)


def _of_a_loss(scene: Scene, equation: GivenEquation, lost: Quantity) -> int | None:
    """The loss of the only sphere as a multiple of its energy before: that of the squares."""
    pair = _other_energy(equation)
    own = (
        None if pair is None else fraction_lost(scene, Binary("/", lost, pair[0]), equation.fact.id)
    )
    if pair is None or own is None or not isinstance(own.right, Binary):
        return None
    whole = own.right.right
    right = whole if pair[1] == ONE else swept(product(pair[1], whole))
    relation = chain(own.right.left, (right, None))
    refs = scene.judge.enough(
        own.move, together(equation.refs, own.refs), relation, background(scene, letters(right))
    )
    if refs is None:
        return None
    line = scene.desk.write(own.move, refs, relation)
    fraction = factored(own.value)
    sums = {frozenset(argument.free_symbols) for argument in fraction.args if argument.is_Add}
    if not fraction.is_Mul or len(sums) != 1:
        return line
    # What is common to the squares is taken out before anything is divided by it.
    worth = scene.scalar(right)
    if worth.is_number:
        # Numbers are multiplied out: 64(1 - e^2) = 40 is not divided by 100.
        share = chain(tree_of(fraction * scene.scalar(whole)), (tree_of(worth), None))
    else:
        share = chain(tree_of(fraction), (pair[1], None))
    return (
        scene.judge.write((Move("rearrange"),), (line, *background(scene, letters(right))), share)
        or line
    )


def _of_two_energies(scene: Scene, equation: GivenEquation, left: Quantity) -> int | None:
    """The energy of a body as a multiple of what it was: the ratio is that of speeds squared."""
    pair = _other_energy(equation)
    if as_shown(scene, left) is not None:
        return None  # it is quoted
    if pair is None or len(left.arguments) != 1 or pair[0].arguments != left.arguments:
        return None
    (other, factor), (name,) = pair, left.arguments
    if not isinstance(name, Name):
        return None
    stages = [quantity.stage for quantity in (left, other) if isinstance(quantity.stage, int)]
    if len(stages) != 2:
        return None
    (a, _, a_refs), (b, _, b_refs) = (
        squares(scene, name.name, scene.last_event(name.name, stage), known=True)
        for stage in stages
    )
    right = b if factor == ONE else swept(product(factor, b))
    relation = chain(swept(a), (right, None))
    move = Move("define", "energy-ratio", max(stages), (name.name,))
    refs = scene.judge.enough(
        move, together(equation.refs, a_refs, b_refs), relation, background(scene, letters(a))
    )
    return None if refs is None else scene.desk.write(move, refs, relation)


__all__ = ["write_share_of_energy"]
