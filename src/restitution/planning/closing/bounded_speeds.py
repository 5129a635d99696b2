"""Speeds that are given as more, or as less, than something: they may exclude a root."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import FLIPPED, Ref
from restitution.expression.tree import Quantity, is_quantity, walk
from restitution.planning.writing.desk import together
from restitution.planning.writing.scene import Scene


def bounded_speeds(scene: Scene) -> Iterator[tuple[Ref, Quantity]]:
    """The given inequalities in force that speak of speeds, each with one of these."""
    for fact in scene.facts.values():
        if fact.kind != "given" or not scene.desk.holds(fact.id) or len(fact.relation.options) > 1:
            continue
        for link in fact.relation.only:
            for side in (link.left, link.right) if link.sign in FLIPPED else ():
                for node in walk(side):
                    if is_quantity(node, "speed"):
                        yield fact.id, node


def bounds_that_stand(scene: Scene) -> Iterator[tuple[Ref, ...]]:
    """The given inequalities of which a speed has a line, each with that line."""
    for fact, speed in bounded_speeds(scene):
        known = scene.desk.known(speed)
        if known is not None:
            yield together((fact,), known.refs)
