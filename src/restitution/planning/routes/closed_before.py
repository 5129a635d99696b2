"""What a given fact came to in an earlier part: an equation between letters of the statement."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

import sympy as sp

from restitution.explaining.following.trials import names_in
from restitution.explaining.lines.derivation import Move, Relation
from restitution.expression.tree import has_quantity, is_function, letters, walk
from restitution.planning.formulas.impacts import residual
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.solving.story.letters import roles


def closed_before(scene: Scene, given: GivenEquation, open_: AbstractSet[sp.Symbol]) -> int | None:
    """The last such line without a root, in which something is open; None where there is none.

    It is not worked out again by the motion.
    """
    desk, known = scene.desk, set(roles(scene.problem))
    for line in reversed(desk.lines):
        own = line.relation
        if not isinstance(own, Relation) or line.shown == "silent" or line.item is None:
            continue
        if desk.is_of_this_part(line.number) or not desk.holds(line.number):
            continue
        if len(own.options) != 1 or any(link.sign != "=" for link in own.only):
            continue
        sides = [side for link in own.only for side in (link.left, link.right)]
        names = {name for side in sides for name in letters(side)}
        nodes = [node for side in sides for node in walk(side)]
        rooted = any(is_function(node, "sqrt") for node in nodes)
        if rooted or not names <= known or any(map(has_quantity, sides)):
            continue
        if given.fact.id not in desk.under(line.number):
            continue
        if residual(scene, line.number).free_symbols & open_:
            return line.number
    return None


def write_from_above(scene: Scene, move: Move, first: int, relation: Relation) -> int | None:
    """A form of what a line says, or of the square above it of which that is a root.

    None where it follows from neither.
    """
    above = sorted((ref for ref in scene.desk.under(first) if isinstance(ref, int)), reverse=True)
    for source in above:
        own = scene.desk.line(source).relation
        if not isinstance(own, Relation) or (len(own.options) > 1 and source != first):
            continue
        known = scene.judge.known(names_in(own) | names_in(relation))
        premises = scene.judge.enough(move, (source,), relation, known)
        if premises is not None:
            return scene.desk.write(move, premises, relation)
    return None


__all__ = ["closed_before", "write_from_above"]
