"""What a letter comes to by now, in a line of its own."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, numbers_in
from restitution.expression.tree import Letter, letters
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene


def settled_letter(scene: Scene, letter: Letter, known: Source, final: Source) -> Source:
    """What a letter is by now, in a line of its own before that is put in."""
    whole = together(known.refs, final.refs)
    lines = numbers_in(known.refs)
    relation = chain(letter, (tree_of(final.value), None))
    if len(lines) != 1 or scene.desk.last_link(lines[0]).left != letter:
        return Source(final.value, whole)
    # Where it comes to 0, nothing tells which line is put into but that it stands first.
    pools: tuple[tuple[Ref, ...], ...] = (whole, (*lines, *(e for e in whole if e not in lines)))
    later = _said_since(scene, letter, lines[0])
    if later is not None:
        pools = ((later, *(e for e in final.refs if e not in lines)), *pools)
    line = next(filter(None, (scene.judge.write((Move("put"),), e, relation) for e in pools)), None)
    if line is None:
        return Source(final.value, whole)
    scene.desk.know(letter, final.value, (line,))
    return Source(final.value, (line,))


def _said_since(scene: Scene, letter: Letter, first: int) -> int | None:
    """The line behind another one that says more shortly what the same letter is: v = −p/2."""
    own = len(letters(scene.desk.last_link(first).right))
    for line in reversed(scene.desk.lines):
        if line.number <= first:
            break
        match line.relation:
            case Relation(((Link(left, "=", right),),)) if (
                left == letter and scene.desk.holds(line.number) and len(letters(right)) < own
            ):
                return line.number
    return None
