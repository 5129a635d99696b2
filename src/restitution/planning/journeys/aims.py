"""From its end: where a body has to be struck so that it comes to a point.

Who is at rest moves off along the line of centres. So the way to the point gives that line, the
line the place of who strikes, and so on back to the first.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Degrees, Expression, Name, Negate, Quantity
from restitution.planning.formulas.whereabouts import contact_of
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import product, total, tree_of, vector
from restitution.planning.writing.place_trees import AXES, coordinate_tree, place_tree
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import plain_direction, whole_direction
from restitution.problem import Arrival, Impact
from restitution.vector import Vector


def _next_event(scene: Scene, body: str, number: int) -> int | None:
    """The next event of a body."""
    later = range(number + 1, scene.events + 1)
    return next((number for number in later if body in scene.bodies(number)), None)


def struck(scene: Scene, number: int) -> str | None:
    """The sphere at rest that an impact sends to a known place; None without one."""
    step = scene.model.happening(number).step
    is_circle = circle_of(scene, number) is not None and number in scene.model.frames
    if (
        not isinstance(step, Impact)
        or step.second not in scene.model.story.spheres
        or not is_circle
    ):
        return None
    if any(scene.unknown(component) for component in scene.model.frames[number].n):
        return None
    for body in (step.second, step.first):
        resting = scene.model.story.latest(body, number - 1) is None and scene.velocity(body, 0)
        if not resting or any(value != 0 for value in resting):
            continue
        if f"position {body}" not in scene.facts or f"velocity {body}" not in scene.facts:
            continue
        following = _next_event(scene, body, number)
        if following is not None and _comes_to(scene, body, following):
            return body
        if direction_given(scene, body, number) is not None:
            return body
    return None


def direction_given(scene: Scene, body: str, number: int) -> tuple[str, Expression] | None:
    """The fact that gives the direction in degrees in which a body moves off, and that angle."""
    for fact in scene.desk.facts:
        if fact.kind != "given" or not scene.desk.holds(fact.id) or len(fact.relation.options) > 1:
            continue
        match fact.relation.only:
            case (
                Link(
                    Quantity("direction", (Name(name),), int(event)),
                    "=",
                    (Degrees() | Negate(Degrees())) as angle,
                ),
            ) if (name, event) == (body, number):
                return fact.id, angle
    return None


def _comes_to(scene: Scene, body: str, number: int) -> bool:
    """Whether the place of a body at an event is known from its end."""
    step = scene.model.happening(number).step
    if isinstance(step, Arrival):
        own = next(contact_of(scene, number), None)
        return own is not None and own.left == place_tree(body, number)
    other = struck(scene, number)
    return other is not None and other != body


def striker(scene: Scene, number: int) -> str | None:
    """Who has to be at a known place at an impact, so that the other goes where it is told."""
    hit = struck(scene, number)
    return (
        None if hit is None else next(sphere for sphere in scene.spheres(number) if sphere != hit)
    )


def place_at(scene: Scene, number: int) -> Vector:
    """The place of who strikes, as it follows from the end."""
    hit = struck(scene, number)
    circle = circle_of(scene, number)
    assert hit is not None
    assert circle is not None
    there = scene.vector(scene.facts[f"position {hit}"].relation.only[0].right)
    apart = scene.model.frames[number].n * scene.scalar(circle[1])
    first = scene.spheres(number)[0]
    place = there + apart if hit == first else there - apart
    return Vector(*(tidy(component) for component in place))


def write_centres(scene: Scene, number: int) -> int:
    """The line of centres by the way on which the struck sphere goes."""
    hit = struck(scene, number)
    assert hit is not None
    given = direction_given(scene, hit, number)
    if given is not None:
        return _by_direction(scene, number, hit, *given)
    following = _next_event(scene, hit, number)
    assert following is not None
    end = _place_of(scene, hit, following)
    start = scene.data(f"position {hit}")
    displacement = Binary("-", tree_of(end.value), tree_of(start.value))
    n = scene.model.frames[number].n
    centres = Quantity("line_of_centres", (), number)
    line = scene.desk.write(
        Move("law", "moves-off", number, (hit,)),
        together((f"velocity {hit}",), start.refs, end.refs),
        Relation(((Link(centres, "parallel to", displacement),),)),
    )
    whole, _ = whole_direction(n)
    relation = Relation(((Link(centres, "parallel to", vector(*map(tree_of, whole))),),))
    if scene.desk.relation(line) == relation:
        return line
    return scene.desk.write(Move("rearrange"), (line,), relation)


def _by_direction(scene: Scene, number: int, hit: str, fact: str, angle: Expression) -> int:
    """The line of centres by the direction that is given of the struck sphere."""
    turn = scene.scalar(angle)
    whole = plain_direction(Vector(tidy(sp.cos(turn)), tidy(sp.sin(turn))))
    centres = Quantity("line_of_centres", (), number)
    relation = Relation(((Link(centres, "parallel to", tree_of(whole)),),))
    return scene.desk.write(
        Move("law", "along-the-change", number, (hit,)), (f"velocity {hit}", fact), relation
    )


def _place_of(scene: Scene, body: str, number: int) -> Source:
    """Where a body comes: to a point, or where it has to strike the next one."""
    if isinstance(scene.model.happening(number).step, Arrival):
        own = next(contact_of(scene, number))
        value, refs = scene.put(scene.vector(own.right))
        return Source(value, together((f"contact {number}",), refs))
    return write_aim(scene, number)


def write_aim(scene: Scene, number: int) -> Source:
    """The place of who strikes at an impact: two radii before the other, on the line of centres."""
    body, hit = striker(scene, number), struck(scene, number)
    assert body is not None
    assert hit is not None
    quantity = place_tree(body, number)
    known = scene.desk.known(quantity)
    if known is not None:
        return known
    line = write_centres(scene, number)
    start = scene.data(f"position {hit}")
    circle = circle_of(scene, number)
    assert circle is not None
    both, more = scene.put(scene.scalar(circle[1]))
    n = scene.model.frames[number].n
    n = n if hit != scene.spheres(number)[0] else -n
    whole, length = whole_direction(n)
    unit = vector(*map(tree_of, whole))
    if length != 1:
        unit = Binary("/", unit, tree_of(length))
    value = place_at(scene, number)
    tree = Binary("-", total([tree_of(start.value)]), product(tree_of(both), unit))
    refs: tuple[Ref, ...] = together(
        (f"contact {number}", f"velocity {hit}"), start.refs, more, (line,)
    )
    number_ = scene.desk.write(
        Move("define", "beside", number, (body,)),
        refs,
        chain(quantity, (tree, None), (tree_of(value), "rearrange")),
    )
    for axis, coordinate in zip(AXES, value, strict=True):
        scene.desk.know(coordinate_tree(body, number, axis), coordinate, (number_,))
    return scene.desk.know(quantity, value, (number_,))
