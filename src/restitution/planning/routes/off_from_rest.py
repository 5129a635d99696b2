"""A speed that is given of a sphere that was at rest: it is the component along its line."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import COMPONENTS, Letter, Name, Quantity
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import GivenEquation, Scene


def write_speed_from_rest(scene: Scene, given: GivenEquation, symbol: sp.Symbol) -> int | None:
    """The line ``w = u/2`` of the speed that is given of the second sphere of an impact.

    None where that was moving, or where the speed is not known.
    """
    match given.link.left:
        case Quantity("speed", (Name(body),), int(number)) if given.link.sign == "=":
            pass
        case _:
            return None
    component = scene.model.components.get((number, body))
    own = scene.model.frames.get(number)
    if component is None or component.symbol != symbol or own is None or own.wall is not None:
        return None
    if body != scene.bodies(number)[-1] or scene.last_event(body, number - 1):
        return None
    rest = f"velocity {body}"
    if rest not in scene.facts or any(scene.initial(body).value):
        return None
    value, refs = scene.put(scene.scalar(given.link.right))
    if scene.unknown(value):
        return None
    mark, frame = scene.desk.mark(), scene.frame(number)
    along, across = (in_direction(scene, kind, body, number, frame) for kind in COMPONENTS)
    if frame.letter_sign == 1 and along.value == symbol and across.value == 0:
        move = Move("define", "component", number, (body,))
        relation = chain(Letter(symbol.name), (tree_of(value), None))
        pool = together(given.refs, refs, (rest,), across.whole, along.whole)
        premises = scene.judge.needed(move, pool, relation)
        if premises is not None:
            line = scene.desk.write(move, premises, relation)
            scene.desk.know(Letter(symbol.name), value, (line,))
            return line
    scene.desk.back(mark)
    return None


__all__ = ["write_speed_from_rest"]
