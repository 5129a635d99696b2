"""A time that the statement gives as a multiple of the one before it."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Binary, Quantity, has_quantity, quantities_in
from restitution.planning.journeys import journeys
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import difference, product, product_without, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene


def write_time_since(scene: Scene, equation: GivenEquation) -> int | None:
    """A time that is a multiple of the one before it, by the time between: t₂ − t₁ = 2t₁.

    Where the later one has a line by the fact, the time between is what that is after the one
    before it. None of other times, and where the time between has no line.
    """
    match equation.link:
        case Link(Quantity("time", (), int(late)) as whole, "=", right):
            first = next(quantities_in(right), None)
        case _:
            return None
    if first is None or first != Quantity("time", (), late - 1):
        return None
    factor = product_without(right, first)
    value = None if factor is None or has_quantity(factor) else scene.scalar(factor)
    if value is None or not value.is_number or value <= 1:
        return None
    if equation.lets:
        return None
    desk = scene.desk
    mark = desk.mark()
    between = Binary("-", whole, first)
    times = tree_of(value - 1)
    try:
        (early, time), (gap, apart) = (journeys.write(scene, e) for e in (first, between))
    except NotPlannedError:
        desk.back(mark)
        return None
    later = _by_the_fact(scene, equation, whole)
    if later is not None:
        own = chain(tree_of(apart), (difference(desk.last_link(later).right, tree_of(time)), None))
        put = scene.judge.write((Move("put"),), (gap, later, early), own)
        if put is not None:
            return put
    rest = chain(between, (swept(product(times, first)), None))
    line = scene.judge.write((Move("rearrange"),), (equation.fact.id,), rest)
    relation = chain(tree_of(apart), (swept(product(times, tree_of(time))), None))
    put = line and scene.judge.write((Move("put"),), (line, gap, early), relation)
    if put is None:
        desk.back(mark)
    return put


def _by_the_fact(scene: Scene, equation: GivenEquation, time: Quantity) -> int | None:
    """The line that says what a time is by a given fact; None where that is not yet used."""
    for line in scene.desk.lines:
        match line.relation:
            case Relation(((Link(left, "="), *_),)) if (
                left == time
                and equation.fact.id in line.premises
                and not has_quantity(line.relation.only[-1].right)
                and scene.desk.holds(line.number)
            ):
                return line.number
    return None


__all__ = ["write_time_since"]
