"""Roots as a formula gives them: what is rejected is not put in order first."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.lines.derivation import Relation
from restitution.planning.writing.forms import alike
from restitution.planning.writing.scene import Scene


def put_in_order_last(scene: Scene, standing: int, last: int) -> None:
    """Rejects roots before the one that is left is put in its own form, and not after that.

    ``standing`` is the line of all roots, ``last`` the next one, of the root that is kept. Nothing
    changes where the roots had one form only, or where several are kept.
    """
    desk = scene.desk
    own, rest = desk.line(standing), desk.line(last)
    if last != standing + 1 or own.move.id != "rearrange" or rest.move.id != "reject":
        return
    if own.premises != (standing - 1,) or desk.line(standing - 1).move.id != "roots":
        return
    first, kept = desk.relation(standing - 1), desk.relation(last)
    if len(kept.options) != 1 or kept.options[0] not in desk.relation(standing).options:
        return
    index = desk.relation(standing).options.index(kept.options[0])
    (before,), (after,) = first.options[index], kept.options[0]
    if alike(before.right, after.right):
        return
    plain = Relation((first.options[index],))
    premises = tuple(standing - 1 if ref == standing else ref for ref in rest.premises)
    if not scene.judge.follows(rest.move, premises, plain):
        return
    desk.rewrite(replace(own, move=rest.move, premises=premises, relation=plain))
    if scene.judge.follows(own.move, (standing,), kept):
        desk.rewrite(replace(rest, move=own.move, premises=(standing,)))
    else:
        desk.rewrite(own)


__all__ = ["put_in_order_last"]
