"""The time between two events: from when it counts, and by which distance and speed."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Expression,
    Polar,
    walk,
)
from restitution.planning.formulas.resolving import unit_of
from restitution.planning.formulas.whereabouts import (
    standing,
    start,
    velocity,
)
from restitution.planning.writing.degrees import angles_in, share_by_degrees
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.flights import (
    divisor_refs,
    time_quotient,
    time_relation,
)
from restitution.planning.writing.forms import (
    product,
    tree_of,
)
from restitution.planning.writing.place_trees import (
    Axis,
    duration_tree,
    time_tree,
)
from restitution.planning.writing.scene import Scene


def time_since(scene: Scene, number: int, begin: int) -> Expression:
    """The time from one event to another, as lines write it: from the start, the time itself."""
    first, _ = start(scene)
    return time_tree(number) if begin == first else duration_tree(number, begin)


def begin_of(scene: Scene, begin: int) -> tuple[Ref, ...]:
    """What tells when a way begins, where that is the start."""
    first, refs = start(scene)
    if begin < first:
        raise NotPlannedError("a time before the clock starts")
    return refs if begin == first else ()


def flight_by_axis(
    scene: Scene,
    number: int,
    body: str,
    ends: tuple[Source, Source],
    since: int,
    axis: Axis,
    begin: tuple[Ref, ...],
    end: Expression | None = None,
) -> Source:
    """The time of a flight by how far it goes along an axis and the component of the velocity.

    ``ends`` are the coordinates at its begin and at its end.
    """
    first, last = ends
    pace = velocity(scene, body, since, axis)
    form = by_degrees(scene, body, since, axis)
    tree = time_quotient(scene, last.value, first.value, pace.value, form, end)
    value = tidy((last.value - first.value) / pace.value)
    refs = together(
        first.refs,
        last.refs,
        pace.refs,
        begin,
        divisor_refs(scene, tidy(last.value - first.value), pace.value),
    )
    quantity = time_since(scene, number, since)
    relation = time_relation(quantity, tree, value, pace.value, in_degrees=form is not None)
    line = scene.desk.write(Move("define", "straight-line", number, (body,)), refs, relation)
    return scene.desk.know(quantity, value, (line,))


def by_degrees(scene: Scene, body: str, since: int, axis: Axis) -> Expression | None:
    """The size of a component at the start by an angle in degrees; None without one."""
    velocity_ = scene.facts.get(f"velocity {body}")
    if since or velocity_ is None:
        return None
    right = velocity_.relation.only[0].right
    if not isinstance(right, Polar):
        return None
    size = scene.scalar(right.size)
    ratio = tidy(scene.initial(body).value.dot(unit_of(axis)) / size)
    for function in ("cos", "sin") if axis == "i" else ("sin", "cos"):
        share = share_by_degrees(ratio, function)
        if share is not None and set(walk(share)) & angles_in(right):
            return product(tree_of(size), share)
    return None


def collected(scene: Scene, met: int, closing: sp.Expr, flight: Expression, apart: sp.Expr) -> int:
    """When two meet, with the terms of the time on one side, where its factor is a sum."""
    above = sp.fraction(sp.factor(closing))[0]
    if not any(factor.is_Add and factor.free_symbols for factor in sp.Mul.make_args(above)):
        return met
    if scene.model.sign(closing) < 0:
        closing, apart = tidy(-closing), tidy(-apart)
    left = product(tree_of(tidy(sp.factor(closing))), flight)
    relation = chain(left, (tree_of(apart), None))
    return scene.judge.write((Move("rearrange"),), [met], relation) or met


def standing_leg(scene: Scene, number: int) -> tuple[int, Source] | None:
    """The event at which a way to another begins whose time a line says; None without one."""
    for begin in range(number - 1, start(scene)[0], -1):
        known = standing(scene, duration_tree(number, begin))
        if known is not None:
            return begin, known
    return None
