"""When a body touches a circular wall, or another body: along a chord, or from beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression
from restitution.planning.circles import circle_of, from_centre
from restitution.planning.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.flights import added
from restitution.planning.forms import difference, product, square, swept, total, tree_of
from restitution.planning.impacts import after, in_direction
from restitution.planning.place_trees import place_tree, time_tree
from restitution.planning.polynomials import expanded
from restitution.planning.premises import background
from restitution.planning.scene import Scene
from restitution.vector import Vector


def time_on_a_chord(scene: Scene, body: str, number: int, since: int, flight: Expression) -> Source:
    """The time from one point of a circular wall to the next: the chord over the speed.

    It is written as the value of ``flight``.

    The chord is 2r cos φ, where φ is the angle with the radius; cos φ is a component over the
    speed.
    """
    circle = circle_of(scene, number)
    assert circle is not None
    refs: list[Ref] = [f"contact {number}"]
    radius, more = scene.put(scene.scalar(circle[1]))
    if since:
        frame = scene.frame(since)
        parts = [after(scene, kind, body, frame) for kind in ("along", "across")]
        values = []
        refs.append(f"contact {since}")
        for each in parts:
            value, used = scene.put(each.value)
            values.append(value)
            refs += [*each.whole, *used]
        towards = -values[0]
        below = total(square(tree_of(each)) for each in values if each != 0)
        squared = sum(each**2 for each in values)
    else:
        frame = scene.frame(number)
        refs.append("start")
        towards, _ = scene.put(in_direction(scene, "along", body, 0, frame).value)
        refs += [f"position {body}", *scene.initial(body).refs]
        size, used = scene.put(scene.model.story.size(scene.initial(body).value))
        refs += used
        below, squared = square(tree_of(size)), size**2
    above = product(tree_of(sp.Integer(2)), tree_of(radius), tree_of(towards))
    value = tidy(2 * radius * towards / squared)
    line = scene.desk.write(
        Move("define", "chord", number, (body,)),
        together(refs, more),
        chain(
            flight,
            (swept(Binary("/", above, below)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(flight, value, (line,))


@dataclass(frozen=True)
class Way:
    """How a body comes to an event: from where, how fast, and since when; at rest without that."""

    body: str
    first: Source
    pace: Source
    early: Source | None


def time_of_touching(scene: Scene, number: int, ways: Sequence[Way]) -> Source:
    """The time at which a body is so far from a centre, or from that of another body.

    Of the two times of the equation one is before the last event, or that at which they would
    part again.
    """
    circle = circle_of(scene, number)
    if circle is None:
        raise NotPlannedError("the time of a contact whose place is not given")
    t = time_tree(number)
    refs: list[Ref] = [f"contact {number}"]
    begins = [each.early for each in ways if each.early is not None]
    begin = begins[0]
    flight = difference(t, tree_of(begin.value))
    lines: list[Ref] = []
    at, pace = Vector(sp.Integer(0), sp.Integer(0)), Vector(sp.Integer(0), sp.Integer(0))
    for way, sign in zip(ways, (1, -1), strict=False):
        if way.early is None:
            refs += [*way.first.refs, *way.pace.refs]
            at += sign * way.first.value
            continue
        own = difference(t, tree_of(way.early.value))
        open_ = scene.desk.write(
            Move("define", "straight-line", number, (way.body,)),
            together(way.first.refs, way.pace.refs, way.early.refs),
            chain(
                place_tree(way.body, number),
                (added(way.first.value, own, way.pace.value), None),
            ),
        )
        lines.append(open_)
        late = tidy(begin.value - way.early.value)
        at += sign * (way.first.value + way.pace.value * late)
        pace += sign * way.pace.value
    if len(ways) == 1:
        at = from_centre(scene, number, at)
    sides = []
    for a, v in zip(at, pace, strict=True):
        a, v = tidy(a), tidy(v)
        if a != 0 or v != 0:
            sides.append(square(swept(total((tree_of(a), product(tree_of(v), flight))))))
    radius, more = scene.put(scene.scalar(circle[1]))
    fact = scene.desk.write(
        Move("fact"),
        together(refs, lines, more),
        Relation(((link(swept(total(sides)), square(tree_of(radius))),),)),
    )
    speed = tidy(expanded(pace.dot(pace)))
    both = tidy(-2 * at.dot(pace) / speed)
    when, _ = scene.put(scene.value(t))
    if scene.unknown(when):
        raise NotPlannedError("a time of a contact that is open")
    other = tidy(2 * begin.value + both - when)
    roots = Relation(tuple((Link(t, "=", tree_of(each)),) for each in (when, other)))
    letters = {each.name for each in (when - other).free_symbols}
    premises = scene.judge.enough(Move("roots"), (fact,), roots, background(scene, letters))
    if premises is None:
        raise NotPlannedError("the times of a contact")
    line = scene.desk.write(Move("roots"), premises, roots)
    chosen = chain(t, (tree_of(when), None))
    if f"order {number}" in scene.facts:
        why: tuple[Ref, ...] = (f"order {number}", *begin.refs)
    else:
        why = (f"towards {number}", *lines)
        why = together(why, refs[1:], *(each.pace.refs for each in ways))
    kept = scene.judge.enough(Move("reject"), (line,), chosen, (*why, *background(scene, letters)))
    if kept is None:
        raise NotPlannedError("which of two times it is")
    line = scene.desk.write(Move("reject"), kept, chosen)
    return scene.desk.know(t, when, (line,))
