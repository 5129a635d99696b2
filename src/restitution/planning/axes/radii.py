"""Lines of centres that the places at an impact give: of a circular wall, its radius."""

from __future__ import annotations

from restitution.components.frames import Frame as Told
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, Showing
from restitution.expression.tree import Binary, Quantity, is_quantity, walk
from restitution.planning.journeys.aims import struck, write_centres
from restitution.planning.journeys.places import spot
from restitution.planning.writing.forms import swept, tree_of, vector
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def is_by_places(scene: Scene, number: int) -> bool:
    """Whether the places at an impact are what gives its line of centres."""
    fact = scene.facts.get(f"axis {number}")
    return fact is not None and any(
        is_quantity(node, "position") for node in walk(fact.relation.only[0].right)
    )


def frame_by_places(scene: Scene, number: int, model_frame: Told) -> Frame:
    """The frame of an impact whose line of centres is worked out of places, where it is wanted."""
    centres = Quantity("line_of_centres", (), number)
    n = model_frame.n if model_frame.wall is None else -model_frame.n

    def write() -> tuple[Ref, ...]:
        if struck(scene, number) is not None:
            return (write_centres(scene, number),)
        places = [spot(scene, sphere, number) for sphere in scene.spheres(number)]
        refs = (f"axis {number}", *(ref for place in places for ref in place.refs))
        whole, _ = whole_direction(n)
        final = Relation(((Link(centres, "parallel to", vector(*map(tree_of, whole))),),))
        values = [place.value for place in places]
        if model_frame.wall is None and all(isinstance(own, Vector) and own for own in values):
            # From one centre to the other, before what that is parallel to.
            between = swept(Binary("-", tree_of(values[1]), tree_of(values[0])))
            first = Relation(((Link(centres, "parallel to", between),),))
            line = scene.judge.write((Move("put"),), refs, first)
            if line is not None and first != final:
                line = scene.judge.write((Move("rearrange"),), (line,), final)
            if line is not None:
                return (line,)
        shown: Showing = "silent" if _is_from_the_centre(scene, number) else "line"
        return (scene.desk.write(Move("put"), refs, final, shown),)

    sign = 1 if model_frame.wall is None else -1
    return Frame(number, model_frame.wall, centres, None, n, n.turned_left(), (), sign, write)


def _is_from_the_centre(scene: Scene, number: int) -> bool:
    """Whether a line above says that a body starts at the centre of a wall, along a radius."""
    for line in scene.desk.lines:
        match line.relation:
            case Relation(((Link(Quantity("time"), "="), *_),)) if (
                line.shown == "line"
                and (line.move.record, line.move.event) == ("chord", number)
                and f"position {line.move.bodies[0]}" in line.premises
            ):
                return True
    return False
