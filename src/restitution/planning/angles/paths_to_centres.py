"""The direction of a sphere that is given, as its angle to a line of centres that slants."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.data.paths_and_lines import in_degrees, turn_of_line
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Apply, Binary, Degrees, Name, Quantity
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import negative, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene


def write_to_centres(scene: Scene, given: GivenEquation, own: Quantity) -> int | None:
    """The line of a direction that is given in degrees, by the components at its impact.

    Where the line of centres is given in degrees too, and slants, the path makes an angle with it
    of which they have the tangent. None of another direction, and at a wall.
    """
    match own:
        case Quantity("direction", (Name(body),), int(event)) if event in scene.model.frames:
            pass
        case _:
            return None
    if scene.model.frames[event].wall is not None or scene.frame(event).across is not None:
        return None
    line = turn_of_line(scene.facts.get(f"axis {event}"))
    turns = [None if e is None else in_degrees(e) for e in (given.link.right, line)]
    if turns[0] is None or turns[1] is None:
        return None
    size: Fraction = (turns[0] - turns[1]) % 180
    if size % 90 == 0:
        return None
    along, across = (
        in_direction(scene, kind, body, event, scene.frame(event)) for kind in ("along", "across")
    )
    above = tree_of(across.value)
    tangent = Apply("tan", Degrees(size if size < 90 else 180 - size))
    right = Binary("/", above if size < 90 else negative(above), tree_of(along.value))
    relation = chain(tangent, (swept(right), None))
    pool = together(given.refs, along.whole, across.whole, (f"axis {event}",))
    return scene.judge.write((Move("define", "tan-direction", event, (body,)),), pool, relation)


__all__ = ["write_to_centres"]
