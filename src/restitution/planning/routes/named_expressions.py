"""Letters by which a statement calls expressions of quantities: what these come to."""

from __future__ import annotations

from functools import partial

from restitution.explaining.lines.derivation import Fact, Move
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Expression, Letter, has_quantity
from restitution.planning.angles.expressions import write_expression
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene


def end_named_expression(
    scene: Scene, asked: Letter, fact: Fact, expression: Expression, name: str
) -> None:
    """A letter by which the statement calls an expression: what that is worth."""
    expression = rebuilt(expression, partial(_in_quantities, scene))
    known = scene.desk.known(expression)
    if known is not None:
        value, refs = scene.put(known.value)
        refs, tree = together(known.refs, refs), tree_of(value)
    elif has_quantity(expression):
        line, tree = write_expression(scene, expression)
        if _is_ended_by(scene, asked, fact, line, name):
            return
        refs = (line,)
    else:
        raise NotPlannedError("a letter for an expression of letters")
    relation = chain(asked, (tree, None))
    premises = scene.judge.enough(Move("put"), refs, relation, (fact.id,))
    if premises is None:
        raise NotPlannedError("a letter for an expression of quantities")
    scene.desk.end(name, scene.desk.write(Move("put"), premises, relation), relation)


def _in_quantities(scene: Scene, tree: Expression) -> Expression:
    """A letter by which the statement calls a quantity of the motion, as that."""
    fact = scene.facts.get(f"let {tree.name}") if isinstance(tree, Letter) else None
    return tree if fact is None else fact.relation.only[0].left


def _is_ended_by(scene: Scene, asked: Letter, fact: Fact, line: int, name: str) -> bool:
    """Whether the last line, which works an expression out, says what the letter for it is."""
    own = scene.desk.line(line)
    if line != len(scene.desk.lines) or own.move.id != "put":
        return False
    relation = chain(asked, *((link.right, link.by) for link in scene.desk.relation(line).only))
    standing = scene.desk.lines.pop()
    number = scene.judge.write((Move("put"),), (fact.id, *own.premises), relation)
    if number is None:
        scene.desk.lines.append(standing)
        return False
    scene.desk.end(name, number, chain(asked, (scene.desk.last_link(number).right, None)))
    return True


__all__ = ["end_named_expression"]
