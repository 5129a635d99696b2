"""A sum or a difference of an angle of the motion and another one, as an angle."""

from __future__ import annotations

from typing import Any

from restitution.exact import plain_angle, tidy_angle
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Quantity,
    letters,
)
from restitution.planning.angles.decimal_angles import write_decimal
from restitution.planning.angles.turn_lines import inverse_of_data
from restitution.planning.angles.turning import angle_line
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene


def made_of_angles(scene: Scene, asked: Expression) -> Binary | None:
    """The sum or difference of two angles that is asked, perhaps by a letter for it.

    One of them at least is an angle of the motion, the other one of the motion or of the data.
    None of another expression.
    """
    fact = scene.facts.get(f"let {asked.name}") if isinstance(asked, Letter) else None
    whole = asked if fact is None else fact.relation.only[0].left
    match whole:
        case Binary("+" | "-", left, right):
            moving = [_moving(scene, side) is not None for side in (left, right)]
            plain = all(isinstance(side, Letter | Degrees | Quantity) for side in (left, right))
            lettered = any(isinstance(side, Letter | Degrees) for side in (left, right))
            return whole if any(moving) and plain and lettered else None
    return None


def angles_in(scene: Scene, whole: Binary) -> tuple[Quantity, ...]:
    """The angles of the motion of which a sum is made."""
    sides = (_moving(scene, side) for side in (whole.left, whole.right))
    return tuple(side for side in sides if side is not None)


def write_sum_of_angles(scene: Scene, asked: Expression) -> tuple[int, Relation] | None:
    """The line of such a sum, and the answer that it says; None where an angle has letters.

    Raises NotPlannedError where an angle is open.
    """
    whole = made_of_angles(scene, asked)
    if whole is None:
        return None
    mark = scene.desk.mark()
    refs: list[Ref] = [f"let {asked.name}"] if isinstance(asked, Letter) else []
    terms: list[Expression] = []
    for side in (whole.left, whole.right):
        term, own = _term(scene, side)
        terms.append(term)
        refs += own
    right = Binary(whole.op, *terms)
    whole_value: Any = scene.scalar(right)
    if whole_value.free_symbols or any(letters(term) for term in terms):
        scene.desk.back(mark)
        return None
    value = plain_angle(whole_value)
    final = right if value is None else tree_of(value, angle=True, as_it_is=True)
    for last in ((final,), ()) if final != right else ((),):
        relation = chain(asked, (right, None), *((tree, "rearrange") for tree in last))
        for move in (Move("put"), Move("rearrange")):
            line = scene.judge.write((move,), together(refs), relation)
            if line is not None:
                return write_decimal(scene, line)
    scene.desk.back(mark)
    return None


def _moving(scene: Scene, side: Expression) -> Quantity | None:
    """The angle of the motion that a side is, or for which a letter stands."""
    if isinstance(side, Letter):
        fact = scene.facts.get(f"let {side.name}")
        side = side if fact is None else fact.relation.only[0].left
    return side if isinstance(side, Quantity) and side.kind in ANGLES else None


def _term(scene: Scene, side: Expression) -> tuple[Expression, tuple[Ref, ...]]:
    """An angle as degrees or an inverse ratio, and what it rests on."""
    angle = _moving(scene, side)
    if angle is not None:
        line = angle_line(scene, angle)
        own = scene.desk.last_link(line)
        named = letter_of(scene, angle)[1] if own.left not in (angle, side) else None
        return own.right, (line,) if named is None else (line, named)
    if isinstance(side, Degrees | Negate):
        return side, ()
    assert isinstance(side, Letter)
    symbol = scene.model.unknowns.letter(side.name)
    if side.name in scene.ratio_facts:
        line = inverse_of_data(scene, side.name)
        return scene.desk.last_link(line).right, (line,)
    value, refs = scene.put(symbol)
    if value == symbol:
        raise NotPlannedError(f"{side.name} is open")
    return tree_of(tidy_angle(value), angle=True, as_it_is=True), refs
