"""Angles made of others that have letters, by these letters: the arctangents are left out."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Expression, Letter, letters, walk
from restitution.planning.writing.desk import chain
from restitution.planning.writing.scene import Scene


def write_by_equal_letters(scene: Scene, lines: Sequence[int]) -> list[int] | None:
    """Two angles by the letters of the angles they are made of, and that these letters are equal.

    ``lines`` say what the two angles are; None where they are not made of equal arctangents.
    """
    mark = scene.desk.mark()
    pairs = [_by_a_letter(scene, line) for line in lines]
    own = [pair for pair in pairs if pair is not None]
    if len(own) == len(lines) == len({inverse for _, inverse in own}):
        (first, one), (second, other) = own
        values = [scene.desk.last_link(number) for number in (one, other)]
        if values[0].right == values[1].right:
            relation = chain(values[1].left, (values[0].left, None))
            equal = scene.judge.write((Move("put"),), (other, one), relation)
            if equal is not None:
                return [first, second, equal]
    scene.desk.back(mark)
    return None


def _by_a_letter(scene: Scene, line: int) -> tuple[int, int] | None:
    """An angle with the letter for an arctangent in it, and the line of that; None without one.

    It is left out where it holds letters, for which it may have no value.
    """
    own = scene.desk.line(line)
    if own.move.id != "define" or not isinstance(own.relation, Relation):
        return None
    link = own.relation.only[-1]
    for ref in own.premises:
        inverse = scene.desk.line(ref) if isinstance(ref, int) else None
        if inverse is None or inverse.move.id != "inverse":
            continue
        value = scene.desk.last_link(inverse.number)
        if not isinstance(value.left, Letter) or not letters(value.right):
            continue
        if value.right not in set(walk(link.right)):
            continue
        put: dict[Expression, Expression] = {value.right: value.left}
        relation = chain(own.relation.only[0].left, (exchanged(link.right, put), None))
        pool: list[Ref] = [other for other in own.premises if other != ref]
        pool += scene.desk.introducing({value.left.name})
        refs = scene.judge.needed(own.move, dict.fromkeys(pool), relation)
        return (
            None if refs is None else (scene.desk.write(own.move, refs, relation), inverse.number)
        )
    return None


__all__ = ["write_by_equal_letters"]
