"""A speed that is given beside the angle of its velocity to a line: a component, by the angle."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Move
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import Apply, Degrees, Letter, Name, Quantity
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import negative, product, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene


def write_resolved_speed(scene: Scene, given: GivenEquation) -> int | None:
    """The line ``4.2 cos 35° = u cos 50°`` of a component that does not change.

    None where that does not stand with an unknown in it, or no angle of the velocity is given.
    """
    match given.link.left:
        case Quantity("speed", (Name(body),), int(stage)) if stage in scene.model.frames:
            pass
        case _:
            return None
    turned = next((e for e in scene.given if _is_angle_of(e, body, stage)), None)
    frame = scene.frame(stage)
    quantity = frame.component("across", body, stage)
    known = scene.desk.known(quantity)
    if turned is None or known is None or not scene.unknown(known.value):
        return None
    (line, *_) = known.refs
    start = scene.desk.line(line).premises if isinstance(line, int) else ()
    sign = scene.model.sign(known.value)
    for ratio in ("cos", "sin"):
        size = product(given.link.right, Apply(ratio, turned.link.right))
        gap = sp.sympify(scene.scalar(size), strict=True) - sign * known.value
        if scene.model.sign(scene.model.in_data(gap)) != 0:
            continue
        before = tree_of(known.value)
        relation = chain(size, (before if sign > 0 else negative(before), None))
        pool = together(given.refs, turned.refs)
        move = Move("law", "unchanged", stage, (body,))
        refs = scene.judge.enough(move, pool, relation, together(start, frame.refs))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return None


def _is_angle_of(equation: GivenEquation, body: str, stage: int) -> bool:
    """Whether an angle of a velocity after an event is given, in degrees or as a letter."""
    match equation.link.left:
        case Quantity(kind, (Quantity("velocity", (Name(name),), int(event)), _)) if (
            kind in UNSIGNED_ANGLES
        ):
            own = isinstance(equation.link.right, Degrees | Letter)
            return own and (name, event) == (body, stage) and equation.link.sign == "="
    return False


__all__ = ["write_resolved_speed"]
