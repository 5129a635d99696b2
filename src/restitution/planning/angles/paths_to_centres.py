"""The direction of a sphere that is given, as its angle to a line of centres that slants."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.data.offset_angles import offset_angle
from restitution.explaining.data.paths_and_lines import in_degrees, turn_of_line
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Apply, Binary, Degrees, Letter, Name, Quantity
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import negative, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.solving.story.letters import roles


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
    turn = None if line is None else in_degrees(line)
    axis: tuple[Ref, ...] = (f"axis {event}",)
    if line is None:
        turn, axis = _turn_by_its_letter(scene, event)
    path = in_degrees(given.link.right)
    if path is None or turn is None:
        return None
    size: Fraction = (path - turn) % 180
    if size % 90 == 0:
        return None
    along, across = (
        in_direction(scene, kind, body, event, scene.frame(event)) for kind in ("along", "across")
    )
    above = tree_of(across.value)
    tangent = Apply("tan", Degrees(size if size < 90 else 180 - size))
    right = Binary("/", above if size < 90 else negative(above), tree_of(along.value))
    relation = chain(tangent, (swept(right), None))
    pool = together(given.refs, along.whole, across.whole, axis)
    return scene.judge.write((Move("define", "tan-direction", event, (body,)),), pool, relation)


def _turn_by_its_letter(scene: Scene, event: int) -> tuple[Fraction | None, tuple[Ref, ...]]:
    """The angle from **i** of a line of centres by an offset, where its letter has a value.

    With what says so.
    """
    fact, letter = scene.facts.get(f"axis {event}"), scene.model.frames[event].angle
    own = None if fact is None else offset_angle(fact.relation.only[0], roles(scene.problem))
    known = None if letter is None else scene.desk.known(Letter(letter.name))
    if own is None or known is None:
        return None, ()
    turn = own.turn(tree_of(known.value, angle=True))
    return turn, together(scene.frame(event).refs, known.refs)


__all__ = ["write_to_centres"]
