"""A condition that an earlier item shows as an inequality between letters."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Move, Relation, numbers_in
from restitution.expression.tree import letters
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import Desk
from restitution.planning.writing.forms import tree_of
from restitution.solving.story.letters import roles

_FORMS = ("rearrange", "cancel")


def write_shown(worths: Worths, fact: Fact) -> int | None:
    """The line of a given inequality as an earlier item shows it, with values of letters put in.

    None where none shows it: what only follows from it says less.
    """
    scene = worths.scene
    known = set(roles(scene.problem))
    for end in reversed(scene.desk.ends):
        if not end.shown or not scene.desk.holds(end.line):
            continue
        own = scene.desk.relation(end.line)
        if len(own.options) != 1 or len(own.only) != 1 or own.only[0].sign not in FLIPPED:
            continue
        (link,) = own.only
        if letters(link.left) | letters(link.right) <= known and _says(scene.desk, end.line, fact):
            return _with_values(worths, end.line, link)
    return None


def _says(desk: Desk, number: int, fact: Fact) -> bool:
    """Whether a line is another form of the one that is written by a fact."""
    while desk.line(number).move.id in _FORMS:
        above = numbers_in(desk.line(number).premises)
        if len(above) != 1:
            return False
        (number,) = above
    return fact.id in desk.line(number).premises


def _with_values(worths: Worths, number: int, link: Link) -> int:
    scene = worths.scene
    sides = (link.left, link.right)
    final = scene.model.final.keys()
    inside = {s for side in sides for s in worths.value(side).free_symbols}
    worths.solver.determine(sorted(inside & final, key=str))
    put = [scene.put(worths.value(side)) for side in sides]
    refs = [ref for _, more in put for ref in more]
    if not refs:
        return number
    trees = [
        tree_of(tidy(value)) if more else side
        for side, (value, more) in zip(sides, put, strict=True)
    ]
    own = Relation(((Link(trees[0], link.sign, trees[1]),),))
    return worths.judge.write((Move("put"),), [number, *refs], own) or number


__all__ = ["write_shown"]
