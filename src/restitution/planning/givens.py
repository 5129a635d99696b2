"""A given fact becomes an equation in letters: a definition closed by what is given."""

from __future__ import annotations

from restitution.explaining.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Quantity,
    has_quantity,
    walk,
)
from restitution.planning import journeys
from restitution.planning.deflections import write_deflection
from restitution.planning.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.forms import ONE, ZERO, product, square, swept, total, tree_of
from restitution.planning.impacts import in_direction
from restitution.planning.quantities import Formula, body_and_stage, formula, frame_after
from restitution.planning.routes import Candidate
from restitution.planning.scene import GivenEquation, Scene

_COSTS = {"along": 1.0, "across": 1.0, "angle": 1.0, "speed": 1.5, "impulse": 2.0, "energy": 2.4}


def candidate(each: GivenEquation) -> Candidate:
    """A given fact as an equation of which routes are made."""
    kinds = [
        node.kind
        for side in (each.link.left, each.link.right)
        for node in walk(side)
        if isinstance(node, Quantity) and node.kind not in ("mass", "position")
    ]
    cost = sum(_COSTS.get(kind, 1.5) for kind in kinds) or 0.5
    return Candidate(each.fact.id, cost, each.residuals)


def move_of(each: GivenEquation) -> Move:
    """The definition by which a fact becomes an equation, as far as its kind tells it."""
    kinds = [
        node.kind
        for side in (each.link.left, each.link.right)
        for node in walk(side)
        if isinstance(node, Quantity)
    ]
    if each.link.sign != "=":
        return Move("define", each.link.sign.removesuffix(" to"))
    record = next((_RECORDS[kind] for kind in kinds if kind in _RECORDS), None)
    return Move("fact") if record is None else Move("define", record)


_RECORDS = {
    "angle": "tan",
    "speed": "speed",
    "impulse": "impulse",
    "energy": "total",
    "energy_lost": "energy-lost",
    "total_energy_lost": "total-lost",
    "deflection": "sum",
}


def write_given(scene: Scene, each: GivenEquation) -> int:
    """Writes the line in which a fact becomes an equation, and returns its number."""
    own = each.link
    if own.sign in ("perpendicular to", "parallel to"):
        return _tie(scene, each)
    if not has_quantity(own.left) and not has_quantity(own.right):
        return _between_letters(scene, each)
    if isinstance(own.left, Quantity):
        if own.left.kind == "deflection" and not has_quantity(own.right):
            return write_deflection(scene, each)
        if own.left.kind == "velocity":
            return _velocity(scene, each)
        if own.left.kind in ("along", "across") and not has_quantity(own.right):
            return _component(scene, each)
        if not has_quantity(own.right) and not journeys.serves(own.left):
            return _closed(scene, each, formula(scene, own.left))
    return _of_several(scene, each)


def _between_letters(scene: Scene, each: GivenEquation) -> int:
    return scene.desk.write(Move("fact"), (each.fact.id,), Relation(((each.link,),)))


def _closed(scene: Scene, each: GivenEquation, own: Formula) -> int:
    """The definition of what is given, with its value on the left."""
    value, refs = scene.put(scene.scalar(each.link.right))
    left = each.link.right if not refs else tree_of(value)
    if (
        isinstance(left, Apply)
        and own.left == Apply("tan", own.quantity)
        and left.function == "arctan"
    ):
        relation = chain(left.argument, (swept(own.right), None))
    elif own.move.record == "speed":
        right: Expression = own.right.argument if hasattr(own.right, "argument") else own.right
        relation = chain(square(left), (swept(right), None))
    else:
        relation = chain(own.of(left), (swept(own.right), None))
    return scene.desk.write(own.move, together((each.fact.id,), refs, own.refs), relation)


def _component(scene: Scene, each: GivenEquation) -> int:
    """A component that is given: the law or the letter that it is."""
    quantity = each.link.left
    assert isinstance(quantity, Quantity)
    own = formula(scene, quantity)
    value, refs = scene.put(scene.scalar(each.link.right))
    left, right = tree_of(own.value), tree_of(value)
    return scene.desk.write(
        Move("put"), together((each.fact.id,), refs, own.refs), chain(left, (right, None))
    )


def _velocity(scene: Scene, each: GivenEquation) -> int:
    raise NotPlannedError("a velocity that is given is put into the laws")


def _tie(scene: Scene, each: GivenEquation) -> int:
    """A right angle, or a common direction, in components."""
    left, right = each.link.left, each.link.right
    record = each.link.sign.removesuffix(" to")
    pair = [_directed(scene, side) for side in (left, right)]
    moving = [own for own in pair if own is not None]
    if not moving:
        raise NotPlannedError("a tie of two directions that are given")
    body, stage = moving[0]
    frame = frame_after(scene, *max(moving, key=lambda own: own[1]))
    move = Move("define", record, frame.number, tuple(dict.fromkeys(b for b, _ in moving)))
    if len(moving) == 1:
        other = right if pair[0] is not None else left
        centres = other == Quantity("line_of_centres", (), frame.number)
        wall = isinstance(other, Name) and other.name == frame.wall
        if not centres and not wall:
            raise NotPlannedError("a tie to a direction in the plane")
        kind = "along" if (record == "perpendicular") != wall else "across"
        own = in_direction(scene, kind, body, stage, frame)
        return scene.desk.write(
            move, together((each.fact.id,), own.whole), Relation(((_zero(tree_of(own.value)),),))
        )
    sources = [
        [in_direction(scene, kind, name, when, frame) for kind in ("along", "across")]
        for name, when in moving
    ]
    (a, b), (c, d) = sources
    pairs = ((a, c), (b, d)) if record == "perpendicular" else ((a, d), (b, c))
    refs = together((each.fact.id,), *(_needed(*pair) for pair in pairs))
    if record == "perpendicular":
        tree = total(product(tree_of(p.value), tree_of(q.value)) for p, q in pairs)
        return scene.desk.write(move, refs, Relation(((_zero(tree),),)))
    first, second = (product(tree_of(p.value), tree_of(q.value)) for p, q in pairs)
    return scene.desk.write(move, refs, Relation(((link(first, second),),)))


def _needed(*factors: Source) -> tuple[Ref, ...]:
    """What a product rests on: where a factor is 0, on that alone."""
    for each in factors:
        if each.value == 0:
            return each.whole
    return together(*(each.whole for each in factors))


def _zero(tree: Expression) -> Link:
    return link(tree, ZERO)


def _directed(scene: Scene, tree: Expression) -> tuple[str, int] | None:
    match tree:
        case Quantity("velocity" | "direction", (Name(body),), int()):
            if body in scene.model.story.walls:
                return None
            return body_and_stage(scene, tree)
    return None


def _of_two_speeds(scene: Scene, each: GivenEquation, left: Quantity) -> int | None:
    """A speed as a multiple of another, in their squares."""
    others = [
        node
        for node in walk(each.link.right)
        if isinstance(node, Quantity) and node.kind == "speed" and isinstance(node.stage, int)
    ]
    if len(others) != 1 or not isinstance(left.stage, int):
        return None
    (other,) = others
    factor = product_without(each.link.right, other)
    if factor is None:
        return None
    a, b = (formula(scene, one) for one in (left, other))
    if not all(isinstance(own.right, Apply) for own in (a, b)):
        return None
    inside = [swept(own.right.argument) for own in (a, b)]  # type: ignore[union-attr]
    known = scene.desk.write(b.move, b.refs, chain(square(other), (inside[1], None)))
    right = inside[1] if factor == ONE else swept(product(square(factor), inside[1]))
    return scene.desk.write(
        a.move, together((each.fact.id,), a.refs, (known,)), chain(right, (inside[0], None))
    )


def product_without(tree: Expression, factor: Expression) -> Expression | None:
    """What a product is without one of its factors; None where it is no such product."""
    if tree == factor:
        return ONE
    match tree:
        case Binary("*", left, right) if right == factor and not has_quantity(left):
            return left
        case Binary("/", above, below) if not has_quantity(below):
            rest = product_without(above, factor)
            return None if rest is None else Binary("/", rest, below)
    return None


def _of_several(scene: Scene, each: GivenEquation) -> int:
    """A relation between quantities: each is defined, and put into what is given."""
    own = each.link
    if isinstance(own.left, Quantity) and own.left.kind == "speed":
        number = _of_two_speeds(scene, each, own.left)
        if number is not None:
            return number
    refs: list[int] = []
    values: dict[Expression, Expression] = {}
    for side in (own.left, own.right):
        for node in walk(side):
            if (
                not isinstance(node, Quantity)
                or node.kind in ("mass", "position")
                or node in values
            ):
                continue
            if journeys.serves(node):
                number, value = journeys.write(scene, node)
                values[node] = tree_of(value)
                refs.append(number)
                continue
            if not isinstance(node.stage, int):
                continue
            made = formula(scene, node)
            number = scene.desk.write(
                made.move, made.refs, chain(made.left, (swept(made.right), None))
            )
            values[node] = made.right
            refs.append(number)
    from restitution.explaining.trees import rebuilt

    left, right = (
        swept(rebuilt(side, lambda node: values.get(node, node))) for side in (own.left, own.right)
    )
    return scene.desk.write(
        Move("put"), together((each.fact.id,), refs), chain(left, (right, None))
    )
