"""Directions at right angles, or parallel, and angles between them: what they say of components."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.data.offset_angles import angle_with_the_path, named_angles
from restitution.explaining.definitions.common import (
    ZERO,
    axis_of,
    unit_vector,
    whole_links,
)
from restitution.explaining.lines.derivation import BEARINGS, FLIPPED, Event, Link, Sign
from restitution.explaining.lines.quotients import Plane, Quotient
from restitution.explaining.lines.trees import settled
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_quantity,
    unsigned,
)

_TIES: Mapping[Expression, Sign] = {
    RIGHT_ANGLE: "perpendicular to",
    Degrees(Fraction(0)): "parallel to",
    STRAIGHT_ANGLE: "parallel to",
}
"""How directions stand to each other that make an angle of so much."""


def tied(step: Step, event: Event | None) -> Iterator[Link]:
    """What a cited right angle, or a cited common direction, says of components."""
    relation = "perpendicular to" if step.move.record == "perpendicular" else "parallel to"
    for link in (*step.links, *_named_angles(step)):
        tie = tie_of(link)
        if tie is not None and tie[2] == relation:
            yield from ties(step, event, *tie)
            if relation == "perpendicular to" and event is not None and not event.wall:
                yield from _across_who_moves_along(step, event, *tie[:2])
            if relation == "parallel to" and event is not None:
                yield from _without_what_stays(event, *tie[:2])
        past = past_a_right_angle(link)
        if past is not None and step.move.record == "perpendicular":
            for ty in ties(step, event, *past[:2], relation):
                yield replace(ty, sign=past[2])


def _across_who_moves_along(
    step: Step, event: Event, left: Expression, right: Expression
) -> Iterator[Link]:
    """At right angles to who moves along the line of centres, a sphere has no component along it.

    There is a right angle only between spheres that both move.
    """
    axis = axis_of(event)
    for one, other in ((left, right), (right, left)):
        match one, other:
            case (
                Quantity("velocity", (Name(body),), event.number),
                Quantity("velocity", (Name(last),), event.number),
            ) if {body, last} == set(event.bodies):
                across = step.setting.quantity(Quantity("across", (one, axis)))
                value = step.rules().put_into(step.world.value(across))
                if isinstance(value, Quotient) and value.vanishes:
                    yield Link(Quantity("along", (other, axis)), "=", ZERO)


def _without_what_stays(event: Event, left: Expression, right: Expression) -> Iterator[Link]:
    """Who keeps to one line in an impact has no component that it leaves as it is.

    Along the line of centres each velocity changes, as the bodies approach.
    """
    early, late = sorted((unsigned(left), unsigned(right)), key=lambda own: _stage(own) or 0)
    match early, late:
        case (
            Quantity("velocity", (Name() as body,), int(before)),
            Quantity("velocity", (Name() as same,), event.number),
        ) if body == same and before == event.number - 1 and event.kind == "impact":
            for own in (early, late):
                yield Link(Quantity("across", (own, axis_of(event))), "=", ZERO)


def _stage(tree: Expression) -> int | None:
    return tree.stage if isinstance(tree, Quantity) and isinstance(tree.stage, int) else None


def _named_angles(step: Step) -> Iterator[Link]:
    """What is cited of letters for angles, said of the angles."""
    named = {Letter(let.letter): let.quantity for let in step.lets}
    named |= {
        link.right: link.left
        for link in step.links
        if link.sign == "=" and isinstance(link.right, Letter) and isinstance(link.left, Quantity)
    }
    for link in whole_links(step):
        if link.left in named:
            yield Link(named[link.left], link.sign, link.right)


def tie_of(link: Link) -> tuple[Expression, Expression, str] | None:
    """The two directions that a relation compares."""
    if link.sign in BEARINGS:
        return _moving(link.left), _moving(link.right), link.sign
    match link:
        case Link(Quantity("direction", (Name() as body,), int(stage)), "=", angle):
            unit = Polar(Number(Fraction(1)), angle)
            return Quantity("velocity", (body,), stage), unit, "parallel to"
    if link.sign != "=" or link.right not in _TIES:
        return None
    match link.left:
        case Quantity("angle", (left, right)):
            return left, right, _TIES[link.right]
        case Quantity("deflection", (turned,), int(stage)):
            before, after = (
                Quantity("velocity", (turned,), number) for number in (stage - 1, stage)
            )
            return before, after, _TIES[link.right]
    return None


def _moving(tree: Expression) -> Expression:
    """The velocity of a body for its momentum, which has the same direction."""
    match tree:
        case Quantity("momentum", (Name(),)):
            return replace(tree, kind="velocity")
    return tree


def past_a_right_angle(link: Link) -> tuple[Expression, Expression, Sign] | None:
    """The directions of an angle of more than 90°, or less, and the sign of their product.

    A direction beyond 90° is one at more than 90° to **i**; one below it may be so too.
    """
    match link:
        case Link(
            Quantity("direction", (Name() as body,), int(stage)), ">" | ">=" as sign, right
        ) if right == RIGHT_ANGLE:
            return Quantity("velocity", (body,), stage), Unit("i"), FLIPPED[sign]
    turned = FLIPPED.get(link.sign)
    tie = None if turned is None else tie_of(replace(link, sign="="))
    if turned is None or tie is None or tie[2] != "perpendicular to":
        return None
    return tie[0], tie[1], turned


def ties(
    step: Step, event: Event | None, left: Expression, right: Expression, relation: str
) -> Iterator[Link]:
    """What it says of components that two directions are perpendicular, or parallel."""
    for a, b in ((left, right), (right, left)):
        for axis in () if event is None else (axis_of(event),):
            wall = len(event.bodies) > 1 and b == Name(event.bodies[1]) if event else False
            if b == axis or wall:
                square = (relation == "perpendicular to") != wall
                yield Link(
                    Quantity(COMPONENTS[0] if square else COMPONENTS[1], (a, axis)), "=", ZERO
                )
    for axes in (axis_of(event),) if event is not None else ():
        (a, b), (c, d) = ([Quantity(k, (tree, axes)) for k in COMPONENTS] for tree in (left, right))
        if relation == "perpendicular to":
            yield Link(Binary("+", Binary("*", a, c), Binary("*", b, d)), "=", ZERO)
        else:
            yield Link(Binary("-", Binary("*", a, d), Binary("*", b, c)), "=", ZERO)
    if relation == "perpendicular to":
        yield Link(Quantity("dot", (left, right)), "=", ZERO)
    else:
        yield Link(_cross(left, right), "=", ZERO)


def is_no_product(step: Step, left: Expression, right: Expression) -> bool:
    """Whether a line is cited by which the scalar product of two directions is zero."""
    products = [
        settled(Quantity("dot", e), step.setting.events) for e in ((left, right), (right, left))
    ]
    zeros = [e.left for e in whole_links(step) if e.sign == "=" and e.right == ZERO]
    return any(tree in products or _is_along(step, tree, left, right) for tree in zeros)


def is_right_angle(step: Step, left: Expression, right: Expression) -> bool:
    """Whether a line is cited by which the angle between two directions is 90°."""
    wanted = {settled(side, step.setting.events) for side in (left, right)}
    return any(
        link.sign == "="
        and link.right == RIGHT_ANGLE
        and is_quantity(link.left, "angle")
        and {settled(side, step.setting.events) for side in link.left.arguments} == wanted
        for link in whole_links(step)
    )


def has_product(step: Step, left: Expression, right: Expression, sign: Sign) -> bool:
    """Whether a line is cited by which the scalar product of two directions has a sign."""
    products = [
        settled(Quantity("dot", pair), step.setting.events)
        for pair in ((left, right), (right, left))
    ]
    return sign in ("<", ">") and any(
        (link.left, link.sign, link.right) == (product, sign, ZERO)
        for link in whole_links(step)
        for product in products
    )


def _is_along(step: Step, product: Expression, left: Expression, right: Expression) -> bool:
    """Whether a scalar product is that of one direction with a vector along the other one."""
    for moving, line in ((left, right), (right, left)):
        match product:
            case Quantity("dot", (own, along)) if not has_quantity(along):
                if own != settled(moving, step.setting.events) or isinstance(line, Quantity):
                    continue
                a, b = (step.world.pointing(_pointing(step, tree)) for tree in (along, line))
                if isinstance(a, Plane) and isinstance(b, Plane):
                    return (a.x * b.y - a.y * b.x).vanishes and not (a.x.vanishes and a.y.vanishes)
    return False


def _cross(left: Expression, right: Expression) -> Expression:
    x, y = (
        tuple(Quantity("dot", (tree, unit_vector(axis))) for axis in "ij") for tree in (left, right)
    )
    return Binary("-", Binary("*", x[0], y[1]), Binary("*", x[1], y[0]))


def between_directions(step: Step, event: Event | None) -> Iterator[Link]:
    """The angles between velocities, at any two times, or lines, for which letters are cited.

    Of a line of centres by an offset, the sine of the angle with the path.
    """
    for meaning, own in named_angles(step.lets, step.links, step.setting):
        yield Link(Apply("sin", meaning.quantity), "=", own.sine)
    for angle in (
        *(meaning.quantity for meaning in step.lets),
        *(side for link in step.links for side in (link.left, link.right)),
    ):
        match angle:
            case Quantity("angle", (a, b)):
                by_offset = angle_with_the_path(angle, step.links, step.setting.roles)
                if by_offset is not None:
                    yield Link(Apply("sin", angle), "=", by_offset.sine)
                p, q = (_pointing(step, tree) for tree in (a, b))
                sizes = Binary("*", *(_size_of(step, side) for side in (p, q)))
                cosine = Binary("/", Quantity("dot", (p, q)), sizes)
                yield Link(Apply("cos", angle), "=", cosine)
                yield from _by_product_and_speeds(step, angle, a, b)
            case Quantity("deflection", (Name() as body,), int(stage)):
                early, late = (
                    settled(Quantity("velocity", (body,), number), step.setting.events)
                    for number in (stage - 1, stage)
                )
                yield from _by_product_and_speeds(step, angle, early, late)


def _by_product_and_speeds(
    step: Step, angle: Expression, one: Expression, other: Expression
) -> Iterator[Link]:
    """The cosine of an angle between velocities, where a line gives their product, or a speed.

    What a line does not give is that of the velocities.
    """
    wholes = {link.left: link.right for link in whole_links(step) if link.sign == "="}
    product = next(
        (e for e in (Quantity("dot", (one, other)), Quantity("dot", (other, one))) if e in wholes),
        None,
    )
    velocities = [tree for tree in (one, other) if isinstance(tree, Quantity)]
    speeds = [replace(tree, kind="speed") for tree in velocities if tree.kind == "velocity"]
    if len(speeds) < 2 or (product is None and not any(speed in wholes for speed in speeds)):
        return
    sizes = [
        wholes.get(speed, _size_of(step, tree))
        for speed, tree in zip(speeds, velocities, strict=True)
    ]
    dot = Quantity("dot", (one, other)) if product is None else wholes[product]
    yield Link(Apply("cos", angle), "=", Binary("/", dot, Binary("*", *sizes)))


def _size_of(step: Step, vector: Expression) -> Expression:
    """The size of a vector; of a velocity that is cited by its size and an angle, that size."""
    for link in step.links:
        match link:
            case Link(left, "=", Polar(size)) if left == vector:
                return Apply("abs", size)
    return Apply("abs", vector)


def _pointing(step: Step, tree: Expression) -> Expression:
    """A vector in the direction of a wall or a line of centres that is cited; else the tree."""
    directions = step.world.directions
    own: Expression = Quantity("direction", (tree,)) if isinstance(tree, Name) else tree
    seen = 0
    while own in directions and seen < len(directions):
        own, seen = directions[own], seen + 1
    if step.world.is_angle(own):
        return Polar(Number(Fraction(1)), own)
    return own if seen else tree
