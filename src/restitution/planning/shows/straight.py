"""Equations that are to be shown, from the line in which they stand already: with no detour."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.lines.derivation import Link, Move, Relation, numbers_in
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.forms import alike
from restitution.planning.writing.polynomials import cancelled, expanded
from restitution.planning.writing.scene import Scene

_WORKED = frozenset({"rearrange", "cancel", "put", "identity"})


def is_turned(own: Link, shown: Link) -> bool:
    """Whether a link says what is to be shown from the other side."""
    return alike(own.left, shown.right) and alike(own.right, shown.left)


def turned_round(scene: Scene, shown: Link, above: int) -> int | None:
    """What is to be shown, in place of a line below another one that says it from the other side.

    None where there is no such line, or where it is a law.
    """
    desk = scene.desk
    for line in desk.lines[above:]:
        if line.move.id not in _WORKED or not isinstance(line.relation, Relation):
            continue
        if len(line.relation.options) > 1 or len(line.relation.only) > 1:
            continue
        if line.relation.only[0].sign == "=" and is_turned(line.relation.only[0], shown):
            relation = Relation(((shown,),))
            if not scene.judge.follows(line.move, line.premises, relation):
                continue
            desk.lines[line.number - 1] = replace(line, relation=relation)
            return line.number
    return None


def shown_by_a_multiple(scene: Scene, shown: Link, number: int) -> int | None:
    """What is to be shown, from a multiple of it, in place of what stands below that.

    So the equation is not solved before. None where the line is no multiple.
    """
    relation, desk = Relation(((shown,),)), scene.desk
    if not _is_multiple(scene, shown, number):
        return None
    if not scene.judge.follows(Move("rearrange"), [number], relation):
        return None
    while len(desk.lines) > number:
        desk.take_last()
    known = scene.judge.known(letters(shown.left) | letters(shown.right))
    return scene.judge.write((Move("rearrange"),), [number, *known], relation)


def _is_multiple(scene: Scene, shown: Link, number: int) -> bool:
    """Whether what is to be shown is a number times an equation."""
    relation = scene.desk.relation(number)
    link = relation.options[0][-1]
    if len(relation.options) > 1 or link.sign != "=" or is_turned(link, shown):
        return False
    if has_quantity(link.left) or has_quantity(link.right):
        return False
    own, wanted = (scene.scalar(e.left) - scene.scalar(e.right) for e in (link, shown))
    return bool(expanded(own) != 0 and cancelled(wanted / own).is_number)


def without_a_detour(scene: Scene, shown: Link, number: int) -> int:
    """What is to be shown, from the line before one that is solved for something else.

    The line itself where there is none such between, or where something else ends in that.
    """
    desk, move = scene.desk, Move("rearrange")
    own = desk.line(number)
    lines = numbers_in(own.premises)
    if number < len(desk.lines) or len(lines) != 1:
        return number
    between = desk.line(lines[0])
    above = numbers_in(between.premises)
    forms = own.move.id == between.move.id == "rearrange" and own.item == between.item
    if not forms or len(above) != 1 or any(end.line >= between.number for end in desk.ends):
        return number
    links = desk.relation(between.number).options[0]
    solved = len(links) == 1 and _is_subject(links[0].left, links[0].right)
    if not solved or links[0].left == shown.left:
        return number
    relation = Relation(((shown,),))
    known = [ref for ref in (*own.premises, *between.premises) if isinstance(ref, str)]
    refs = scene.judge.enough(move, above, relation, known)
    if refs is None:
        return number
    while len(desk.lines) >= between.number:
        desk.take_last()
    return desk.write(move, refs, relation)


def _is_subject(tree: Expression, other: Expression) -> bool:
    """Whether an equation is solved for a side of it: a letter, a ratio, or a power of one."""
    own = tree.left if is_binary(tree, "^") else tree
    match own:
        case Letter() | Apply(_, Letter()):
            return own not in set(walk(other))
    return False
