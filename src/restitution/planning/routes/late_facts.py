"""Items that stand above a given fact of their part: their answers with that put in."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.lines.derivation import ItemEnd, Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    Letter,
    Quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.planning.routes.given_shares import write_given_share
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def write_with_facts(scene: Scene, solver: Solver, name: str) -> bool:
    """Ends an item by its answer without the facts below it, with these put in.

    False where there is none, or where they cannot be put in.
    """
    end = scene.desk.early.get(name)
    if end is None or len(end.answer.options) != 1:
        return False
    links = end.answer.only
    link = replace(links[-1], left=links[0].left)
    value = scene.value(link.right)
    if (
        any(link.sign != "=" for link in links)
        or isinstance(value, Vector)
        or hasattr(value, "measure")
    ):
        return False
    standing = solver.mark()
    subject = link.left
    shared = (
        write_given_share(scene, subject, early=True) if isinstance(subject, Quantity) else None
    )
    if shared is not None:
        scene.desk.end(name, shared, chain(subject, (scene.desk.last_link(shared).right, None)))
        return True
    try:
        solver.determine([value])
        put, refs = scene.put(value)
    except NotPlannedError:
        solver.back(standing)
        return False
    relation = chain(link.left, (tree_of(put), None))
    # A tangent is put in as it is given, or stands, without the sine and the cosine.
    given = [ref for letter in sorted(letters(link.right)) for ref in _tangent_of(scene, letter)]
    pools = (given, refs) if given else (refs,)
    tried = (scene.judge.enough(Move("put"), (end.line, *pool), relation) for pool in pools)
    premises = next((enough for enough in tried if enough is not None), None)
    if put == value or premises is None:
        solver.back(standing)
        return False
    if _is_said_by_a_fact(scene, relation):
        line = scene.desk.write(Move("put"), premises, relation, "silent")
        scene.desk.ends.append(ItemEnd(name, line, relation, scene.desk.part))
    else:
        scene.desk.end(name, scene.desk.write(Move("put"), premises, relation), relation)
    return True


def _is_said_by_a_fact(scene: Scene, relation: Relation) -> bool:
    """Whether a given fact says an answer by itself: then no line says it once more."""
    asked = set(quantities_in(relation.only[0].left))
    for equation in scene.given if asked else ():
        fact = equation.fact.relation.only[0]
        if asked <= {*walk(fact.left), *walk(fact.right)}:
            moves = (Move("fact"), Move("rearrange"))
            if any(scene.judge.follows(move, (equation.fact.id,), relation) for move in moves):
                return True
    return False


def _tangent_of(scene: Scene, name: str) -> tuple[Ref, ...]:
    """The fact that gives a ratio of an angle, or the line that says what its tangent is."""
    fact = scene.ratio_facts.get(name)
    known = scene.desk.known(Apply("tan", Letter(name)))
    if fact is not None or known is None:
        return () if fact is None else (fact.id,)
    return known.refs


__all__ = ["write_with_facts"]
