"""When a body comes to a circular wall: along a chord, or from a point beside it."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Relation
from restitution.expression.tree import Binary
from restitution.planning.circles import circle_of, from_centre
from restitution.planning.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.forms import difference, product, square, swept, total, tree_of
from restitution.planning.impacts import after, in_direction
from restitution.planning.place_trees import place_tree, time_tree
from restitution.planning.premises import background
from restitution.planning.scene import Scene


def time_on_a_chord(scene: Scene, body: str, number: int, since: int, early: Source) -> Source:
    """The time from one point of a circular wall to the next: the chord over the speed.

    The chord is 2r cos φ, where φ is the angle with the radius; cos φ is a component over the
    speed.
    """
    circle = circle_of(scene, number)
    assert circle is not None
    refs = [f"contact {number}", *early.refs]
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
        towards, _ = scene.put(in_direction(scene, "along", body, 0, frame).value)
        refs += [f"position {body}", *scene.initial(body).refs]
        size, used = scene.put(scene.model.story.size(scene.initial(body).value))
        refs += used
        below, squared = square(tree_of(size)), size**2
    above = product(tree_of(sp.Integer(2)), tree_of(radius), tree_of(towards))
    value = tidy(early.value + 2 * radius * towards / squared)
    t = time_tree(number)
    line = scene.desk.write(
        Move("define", "chord", number, (body,)),
        together(refs, more),
        chain(
            t,
            (swept(total((tree_of(early.value), Binary("/", above, below)))), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(t, value, (line,))


def time_to_circle(
    scene: Scene, body: str, number: int, first: Source, pace: Source, early: Source
) -> Source:
    """The time at which a body is at the distance of the radius from the centre.

    Of the two times one is before the last event, or that at which it would leave the circle.
    """
    circle = circle_of(scene, number)
    if circle is None:
        raise NotPlannedError("the time to a wall whose place is not given")
    t = time_tree(number)
    flight = difference(t, tree_of(early.value))
    open_ = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(first.refs, pace.refs, early.refs),
        chain(
            place_tree(body, number),
            (swept(total((tree_of(first.value), product(flight, tree_of(pace.value))))), None),
        ),
    )
    way = from_centre(scene, number, first.value)
    sides = []
    for a, v in zip(way, pace.value, strict=True):
        own = swept(total((tree_of(tidy(a)), product(tree_of(v), flight))))
        if a != 0 or v != 0:
            sides.append(square(own))
    radius, refs = scene.put(scene.scalar(circle[1]))
    fact = scene.desk.write(
        Move("fact"),
        together((f"contact {number}", open_), refs),
        Relation(((link(swept(total(sides)), square(tree_of(radius))),),)),
    )
    speed = tidy(sp.expand(pace.value.dot(pace.value)))
    both = tidy(-2 * way.dot(pace.value) / speed)
    when, _ = scene.put(scene.value(t))
    if scene.unknown(when):
        raise NotPlannedError("a time to a circular wall that is open")
    other = tidy(2 * early.value + both - when)
    roots = Relation(tuple((Link(t, "=", tree_of(each)),) for each in (when, other)))
    letters = {each.name for each in (when - other).free_symbols}
    premises = scene.judge.enough(Move("roots"), (fact,), roots, background(scene, letters))
    if premises is None:
        raise NotPlannedError("the times at which a circle is met")
    line = scene.desk.write(Move("roots"), premises, roots)
    inside = f"order {number}" in scene.facts
    why = (f"order {number}", *early.refs) if inside else (f"towards {number}", *pace.refs, open_)
    chosen = chain(t, (tree_of(when), None))
    kept = scene.judge.enough(Move("reject"), (line,), chosen, (*why, *background(scene, letters)))
    if kept is None:
        raise NotPlannedError("which of two times it is")
    line = scene.desk.write(Move("reject"), kept, chosen)
    return scene.desk.know(t, when, (line,))
