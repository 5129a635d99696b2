"""Angles of the motion that the data give: to the wall or the axis by which a velocity is told."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Move
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    Unit,
    is_quantity,
    unsigned,
    walk,
)
from restitution.planning.angles.directions import write_read_off
from restitution.planning.angles.walls_at_right_angles import by_a_given_ratio
from restitution.planning.writing.angles import angle_to_a_line
from restitution.planning.writing.desk import chain
from restitution.planning.writing.scene import Scene


def angle_as_given(scene: Scene, asked: Expression) -> Letter | Degrees | None:
    """The letter or the degrees that the data have for an angle at the start; None without."""
    match asked:
        case Quantity("angle", (Quantity("velocity", (Name(body),), 0), line)):
            fact = scene.facts.get(f"velocity {body}")
        case _:
            return None
    right = None if fact is None else fact.relation.only[0].right
    angle: Expression | None = None
    match right, line:
        case Polar(_, size, _, Name() as wall), Name():
            angle = size if wall == line else None
        case Polar(_, size, origin, None), Unit():
            own = Unit("i") if origin is None else origin
            angle = unsigned(size) if own == line else None
        case Polar(), Name(wall_name):
            wall_fact = scene.facts.get(f"wall {wall_name}")
            along = None if wall_fact is None else wall_fact.relation.only[0].right
            angle = None if along is None else angle_to_a_line(scene, body, along)
        case Polar(), Quantity("line_of_centres", (), int(number)):
            axis = scene.facts.get(f"axis {number}")
            along = None if axis is None else axis.relation.only[0].right
            angle = None if along is None else angle_to_a_line(scene, body, unsigned(along))
    return angle if isinstance(angle, Letter | Degrees) else None


def write_as_given(scene: Scene, asked: Quantity) -> int | None:
    """The line that an angle is that of the data, which nobody works out; None of another one."""
    angle = angle_as_given(scene, asked)
    if angle is None:
        return None
    facts = [f for f in scene.facts if f.partition(" ")[0] in ("velocity", "wall", "axis")]
    bodies = tuple(sorted(n.name for n in walk(asked.arguments[0]) if isinstance(n, Name)))
    move = Move("define", "difference", None, bodies)
    refs = scene.judge.needed(move, facts, chain(asked, (angle, None)))
    if refs is None:
        return None
    line = write_read_off(scene, asked, angle, move, refs)
    return by_a_given_ratio(scene, asked, line)


def with_angles_given(scene: Scene, asked: Expression) -> Expression:
    """A sum of angles, or a difference, with those that the data give as they give them.

    Another expression as it is, and so is one in which no angle is left to be worked out.
    """
    if not isinstance(asked, Binary) or asked.op not in ("+", "-"):
        return asked

    def change(tree: Expression) -> Expression:
        return angle_as_given(scene, tree) or tree

    own = rebuilt(asked, change)
    return own if any(is_quantity(node, *ANGLES) for node in walk(own)) else asked


__all__ = ["angle_as_given", "with_angles_given", "write_as_given"]
