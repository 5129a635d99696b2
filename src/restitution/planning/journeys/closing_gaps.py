"""When two bodies meet, by the gap between them and the speed at which it closes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Binary, Name, Negate, Quantity
from restitution.planning.formulas.whereabouts import (
    last_move,
    offset_at,
    standing,
    start,
    velocity,
)
from restitution.planning.journeys.flights import time_since
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    negative,
    product,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.forms import number as number_tree
from restitution.planning.writing.place_trees import Axis, time_tree
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def time_of_closing(
    scene: Scene,
    number: int,
    pair: tuple[str, str],
    begin: int,
    axis: Axis,
    places: Mapping[str, Source],
) -> Source | None:
    """The time from an event to the impact of a pair that moves along an axis.

    ``places`` are the coordinates of both at that event. None where it does not follow: where they
    move in two directions.
    """
    beside: Axis = "j" if axis == "i" else "i"
    paces = {body: velocity(scene, body, begin, axis) for body in pair}
    closing = tidy(paces[pair[0]].value - paces[pair[1]].value)
    if scene.unknown(closing) or not scene.model.sign(closing):
        return None
    behind, ahead = pair if scene.model.sign(closing) > 0 else pair[::-1]
    apart = _distance(scene, pair, begin)
    if apart is None:
        first, last = places[behind], places[ahead]
        gap = tidy(last.value - first.value)
        above = difference(tree_of(last.value), tree_of(first.value))
        refs = together(first.refs, last.refs)
    else:
        gap, above, refs = apart.value, tree_of(apart.value), apart.refs
    radii = tidy(scene.put(-offset_at(scene, behind, number, axis))[0])
    if radii != 0:
        gap, above = (
            tidy(gap - radii),
            difference(above, product(number_tree(2), tree_of(radii / 2))),
        )
    if scene.unknown(gap) or scene.unknown(radii):
        return None
    terms = [tree_of(paces[behind].value), negative(tree_of(paces[ahead].value))]
    if isinstance(swept(terms[0]), Negate) and not isinstance(swept(terms[1]), Negate):
        terms.reverse()  # 1 − ½, where both go back: and not −½ + 1
    below = total(terms)
    flight = time_since(scene, number, begin)
    value = tidy(gap / tidy(paces[behind].value - paces[ahead].value))
    right = swept(Binary("/", above, below))
    relation = chain(flight, (right, None), (tree_of(value), "rearrange"))
    pool = together(
        refs,
        *(source.refs for source in paces.values()),
        *(velocity(scene, body, begin, beside).refs for body in pair),
        (f"contact {number}",),
        start(scene)[1],
        background(scene, symbol_names(closing)),
    )
    line = scene.judge.write((Move("define", "straight-line", number, pair),), pool, relation)
    return None if line is None else scene.desk.know(flight, value, (line,))


def time_at_once(scene: Scene, number: int, pair: tuple[str, str]) -> Source | None:
    """The time of an impact of spheres that start at one place and part: 0; None of others."""
    facts = [f"{kind} {body}" for body in pair for kind in ("position", "velocity")]
    if any(last_move(scene, body, number) for body in pair) or not facts_hold(scene, facts):
        return None
    first, other = (scene.value(scene.facts[ref].relation.only[0].right) for ref in facts[::2])
    if any(tidy(a - b) != 0 for a, b in zip(first, other, strict=True)):
        return None
    when = time_tree(number)
    relation = chain(when, (ZERO, None))
    pool = (*facts, f"contact {number}", *start(scene)[1])
    line = scene.judge.write((Move("define", "straight-line", number, pair),), pool, relation)
    return None if line is None else scene.desk.know(when, sp.Integer(0), (line,))


def facts_hold(scene: Scene, refs: Iterable[str]) -> bool:
    """Whether facts are of the statement, and in force."""
    return all(ref in scene.facts and scene.desk.holds(ref) for ref in refs)


def _distance(scene: Scene, pair: tuple[str, str], stage: int) -> Source | None:
    """How far apart two bodies are at an event, where a line says it."""
    names = tuple(map(Name, pair))
    lines = (
        standing(scene, Quantity("distance", spheres, stage)) for spheres in (names, names[::-1])
    )
    return next((line for line in lines if line is not None), None)


__all__ = ["time_at_once", "time_of_closing"]
