"""Tangents of angles of the motion in a relation that is given: *tan α = 2 tan β*."""

from __future__ import annotations

from restitution.explaining.derivation import Link, Ref
from restitution.expression.tree import Apply, Expression, Letter, Quantity, walk
from restitution.planning.desk import NotPlannedError, chain, together
from restitution.planning.forms import in_tangents, neat, swept, tree_of
from restitution.planning.named_angles import letter_known
from restitution.planning.quantities import formula
from restitution.planning.scene import Scene


def write_tangents(scene: Scene, link: Link) -> tuple[dict[Expression, Expression], list[Ref]]:
    """Lines of the tangents in a relation: what each is by them, and the lines.

    Raises NotPlannedError where an angle has no line by its tangent.
    """
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    for node in (node for side in (link.left, link.right) for node in walk(side)):
        match node:
            case Apply("tan", Quantity("angle" | "deflection") as angle) if node not in values:
                own = formula(scene, angle)
                if own.left != node:
                    raise NotPlannedError("a relation with angles")
                final = tree_of(in_tangents(neat(own.value)))
                named = letter_known(scene, angle)
                left = node if named is None else Apply("tan", Letter(named[0]))
                premises = together(own.refs, () if named is None else (named[1],))
                relation = chain(left, (swept(own.right), None), (final, "rearrange"))
                if not scene.judge.follows(own.move, premises, relation):
                    raise NotPlannedError("to which side a sphere turns is open")
                refs.append(scene.desk.write(own.move, premises, relation))
                values[node] = final
    return values, refs
