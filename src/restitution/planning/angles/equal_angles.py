"""Two angles that are equal: so are their tangents, and their cosines where there are none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from restitution.explaining.lines.derivation import Move, Ref, equality
from restitution.expression.tree import Binary, Letter, Quantity
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.scalar_angles import write_cosine
from restitution.planning.angles.turn_lines import write_turn_tangent
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.turns import turns_of
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import square, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene


def write_equal_angles(scene: Scene, equation: GivenEquation) -> int:
    """Two angles that are equal, as an equation in components."""
    angles = [a for a in (equation.link.left, equation.link.right) if isinstance(a, Quantity)]
    if len(angles) != 2:
        raise NotPlannedError("equal angles without tangents")
    right_angles = any(scene.model.sign(sp.cos(scene.scalar(angle))) == 0 for angle in angles)
    for lines in (_cosines,) if right_angles else (_by_turns, _tangents, _squared_tangents):
        mark = scene.desk.mark()
        refs = lines(scene, angles)
        if refs is not None:
            left, right = (scene.desk.last_link(ref).right for ref in refs)
            relation = equality(left, right)
            named = lines in (_cosines, _by_turns)
            equal = _named(scene, equation, angles) if named else equation.fact.id
            premises = scene.judge.enough(Move("put"), [*refs, equal], relation)
            if premises is not None:
                return scene.desk.write(Move("put"), premises, relation)
        scene.desk.back(mark)
    raise NotPlannedError("a relation with angles")


_BY_TANGENTS = ("tan", "tan-deflection")


def _named(scene: Scene, equation: GivenEquation, angles: Sequence[Quantity]) -> Ref:
    """That the letters of two angles are equal."""
    (first, *one), (second, *other) = (letter_of(scene, angle) for angle in angles)
    relation = chain(Letter(first), (Letter(second), None))
    return scene.desk.write(Move("fact"), (equation.fact.id, *one, *other), relation)


def _cosines(scene: Scene, angles: Sequence[Quantity]) -> list[int] | None:
    refs = [write_cosine(scene, angle) for angle in angles]
    return [ref for ref in refs if ref is not None] if None not in refs else None


def _formulas(scene: Scene, angles: Sequence[Quantity]) -> list[Formula]:
    formulas = [formula(scene, angle) for angle in angles]
    if any(own.move.record not in _BY_TANGENTS for own in formulas):
        raise NotPlannedError("equal angles without tangents")
    return formulas


def _by_turns(scene: Scene, angles: Sequence[Quantity]) -> list[int] | None:
    """Deflections by the angles of both velocities to one line; None of other angles."""
    if any(own.move.record != "tan-deflection" for own in _formulas(scene, angles)):
        return None
    refs: list[int] = []
    for angle in angles:
        letter, _ = letter_of(scene, angle)
        tangents = (write_turn_tangent(scene, e, Letter(letter)) for e in turns_of(scene, angle))
        line = next((tangent for tangent in tangents if tangent is not None), None)
        if line is None:
            return None
        refs.append(line)
    return refs


def _tangents(scene: Scene, angles: Sequence[Quantity]) -> list[int] | None:
    refs: list[int] = []
    for own in _formulas(scene, angles):
        relation = chain(own.left, (swept(own.right), None), (tree_of(own.value), "rearrange"))
        if not scene.judge.follows(own.move, own.refs, relation):
            return None
        refs.append(scene.desk.write(own.move, own.refs, relation))
    return refs


def _squared_tangents(scene: Scene, angles: Sequence[Quantity]) -> list[int] | None:
    """The squares, where it is open on which side of a line a sphere goes."""
    refs: list[int] = []
    for own in _formulas(scene, angles):
        if not isinstance(own.right, Binary):
            return None
        right = Binary("/", *(square(part) for part in (own.right.left, own.right.right)))
        move = replace(own.move, record="tan-squared")
        relation = chain(square(own.left), (swept(right), None))
        if not scene.judge.follows(move, own.refs, relation):
            return None
        refs.append(scene.desk.write(move, own.refs, relation))
    return refs


__all__ = ["write_equal_angles"]
