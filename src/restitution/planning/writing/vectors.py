"""Velocities that are given as vectors: by their parts, or by a size and a direction."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import negative, product, tree_of, vector
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector


def velocity_given(
    scene: Scene, body: str, number: int
) -> tuple[Expression, Vector, tuple[Ref, ...]] | None:
    """A velocity after an event that is given: as a vector, or by its size and direction."""
    velocity = Quantity("velocity", (Name(body),), number)
    parts: dict[str, GivenEquation] = {}
    for equation in scene.given:
        if equation.link.sign != "=":
            continue
        if equation.link.left == velocity and common_velocity(equation) is None:
            value = scene.model.story.evaluator(scene.events).vector(equation.link.right)
            tree = tree_of(tuple(tidy(part) for part in value))
            started = _started(scene, equation.link.right)
            if started and (line := _by_its_change(scene, equation, tree, value)) is not None:
                return tree, value, (line,)
            return tree, value, together(equation.refs, started)
        match equation.link.left:
            case Quantity("speed" | "direction" as kind, (Name(name),), event) if (
                name == body and event == number
            ):
                parts[kind] = equation
    if len(parts) != 2:
        return turned_velocity(scene, body, number)
    angle = scene.scalar(parts["direction"].link.right)
    direction = Vector(tidy(sp.cos(angle)), tidy(sp.sin(angle)))
    size = scene.scalar(parts["speed"].link.right)
    refs = tuple(equation.fact.id for equation in parts.values())
    value = direction * size
    if any(scene.initial(body).value) and not scene.last_event(body, number - 1):
        line = _by_its_size(scene, velocity, size, angle, refs)
        if line is not None:
            return tree_of(value), value, (line,)
    return vector(*map(tree_of, direction)), value, together(refs)


def _by_its_size(
    scene: Scene, velocity: Quantity, size: sp.Expr, angle: sp.Expr, facts: tuple[Ref, ...]
) -> int | None:
    """The line of a velocity by its size and direction, where these are known."""
    value = Vector(tidy(size * sp.cos(angle)), tidy(size * sp.sin(angle)))
    if angle.free_symbols or scene.unknown(size) or not isinstance(velocity.stage, int):
        return None
    sign = scene.model.sign(value.y)
    tree = tree_of(value)
    by_degrees = _by_degrees(size, abs(angle), sign)
    relation = chain(velocity, (by_degrees or tree, None), (tree, "rearrange"))
    (body,) = (argument.name for argument in velocity.arguments if isinstance(argument, Name))
    move = Move("define", "turned", velocity.stage, (body,))
    line = scene.judge.write((move,), facts, relation)
    if line is not None:
        scene.desk.know(velocity, value, (line,))
    return line


def _by_its_change(
    scene: Scene, given: GivenEquation, tree: Expression, value: Vector
) -> int | None:
    """The line of a velocity by that at the start and its change: ``(2i + j) + (3i - j)``."""
    velocity = given.link.left
    known = scene.desk.known(velocity)
    if known is not None:
        return next((ref for ref in known.refs if isinstance(ref, int)), None)
    if any(scene.unknown(other) or scene.put(other)[1] for other in value):
        return None
    early: dict[Expression, Expression] = {}
    for node in walk(given.link.right):
        match node:
            case Quantity("velocity", (Name(body),), 0):
                early[node] = tree_of(scene.initial(body).value)
            case Quantity():
                return None
    steps = ((exchanged(given.link.right, early), None), (tree, "rearrange"))
    relation = chain(velocity, *steps)  # type: ignore[arg-type]
    pool = together(given.refs, _started(scene, given.link.right))
    line = scene.judge.write((Move("put"),), pool, relation)
    if line is not None:
        scene.desk.know(velocity, value, (line,))
    return line


def turned_velocity(
    scene: Scene, body: str, number: int
) -> tuple[Expression, Vector, tuple[Ref, ...]] | None:
    """A velocity by its size and by how far, and to which side, it is turned from **i**."""
    quantities = [Quantity(kind, (Name(body),), number) for kind in ("speed", "deflection")]
    velocities = [
        next((e for e in scene.given if e.link.sign == "=" and e.link.left == quantity), None)
        for quantity in quantities
    ]
    fact = scene.facts.get(f"velocity {body}")
    fast, turned = velocities
    if fast is None or turned is None or fact is None or scene.last_event(body, number - 1):
        return None
    early = scene.initial(body)
    if early.value.y != 0 or scene.model.sign(early.value.x) <= 0:
        return None
    if any(has_quantity(equation.link.right) for equation in (fast, turned)):
        return None
    size, angle = (scene.scalar(equation.link.right) for equation in (fast, turned))
    late = scene.model.branch.story.velocity(body, number)
    side = _side(scene, body, number)
    if angle.free_symbols or scene.unknown(size) or side is None:
        return None
    sign = scene.model.sign(late.y)
    value = Vector(tidy(size * sp.cos(angle)), tidy(sign * size * sp.sin(angle)))
    tree = tree_of(value)
    move = Move("define", "turned", number, (body,))
    relation = chain(
        Quantity("velocity", (Name(body),), number),
        (_by_degrees(size, angle, sign) or tree, None),
        (tree, "rearrange"),
    )
    certain = together(fast.refs, turned.refs, early.refs)
    premises = scene.judge.needed(move, (*certain, *side), relation, side)
    if premises is None:
        return None
    return tree, value, (scene.desk.write(move, premises, relation),)


def _by_degrees(size: sp.Expr, angle: sp.Expr, sign: int) -> Expression | None:
    """A vector by its size and an angle in degrees: ``2cos 60° i − 2sin 60° j``."""
    degrees = angle * 180 / sp.pi
    if not degrees.is_Integer or degrees % 90 == 0:
        return None
    turn = Degrees(Fraction(int(degrees)))
    x, y = (product(tree_of(size), Apply(ratio, turn)) for ratio in ("cos", "sin"))
    return vector(x, y if sign > 0 else negative(y))


def _side(scene: Scene, body: str, number: int) -> tuple[Ref, ...] | None:
    """What tells to which side a sphere is turned: a given fact, or that one side is taken.

    It may be the impulse given to it, where the range of its angle tells that.
    """
    direction = Quantity("direction", (Name(body),), number)
    for fact in scene.desk.facts:
        if fact.kind == "given" and scene.desk.holds(fact.id) and len(fact.relation.options) == 1:
            link = fact.relation.only[0]
            if direction in (link.left, link.right) and link.sign in ("<", ">"):
                return (fact.id,)
    blow = scene.facts.get(f"impulse {number}")
    if blow is not None and isinstance(blow.relation.only[0].right, Polar):
        names = letters(blow.relation.only[0].right)
        ranges = [ref for name in sorted(names) for ref in scene.judge.ranges_given(name)]
        return together((blow.id,), ranges, background(scene, names))
    axis = scene.facts.get(f"axis {number}")
    if axis is not None and not scene.events > 1:
        match axis.relation.only:
            case (Link(_, "parallel to", Letter(name)),):
                return (axis.id, *background(scene, {name}))
    return () if scene.sided else None


def common_velocity(given: GivenEquation) -> tuple[str, str, int] | None:
    """Two bodies of which it is given that they have one velocity after an event."""
    match given.link:
        case Link(
            Quantity("velocity", (Name(one),), int(event)),
            "=",
            Quantity("velocity", (Name(other),), int(last)),
        ) if event == last and event and one != other:
            return one, other, event
    return None


def _started(scene: Scene, tree: Expression) -> tuple[Ref, ...]:
    """The velocities at the start in a tree."""
    return tuple(
        f"velocity {node.arguments[0].name}"
        for node in walk(tree)
        if is_quantity(node, "velocity")
        and node.stage == 0
        and isinstance(node.arguments[0], Name)
        and f"velocity {node.arguments[0].name}" in scene.facts
    )


def initial_as_a_line(scene: Scene, body: str) -> Source:
    """A velocity of the data by its size and an angle whose sine and cosine lines give as numbers.

    It is written as a vector before its scalar products; any other one stands as the data give it.
    """
    source = scene.initial(body)
    value, refs = scene.put(source.value)
    fact = f"velocity {body}"
    if fact not in scene.facts or not any(isinstance(ref, int) for ref in refs):
        return source
    if not all(sp.sympify(other, strict=True).is_Rational and other for other in value):
        return source
    quantity = Quantity("velocity", (Name(body),), 0)
    relation = chain(quantity, (tree_of(Vector(*value)), None))
    line = scene.judge.write((Move("put"),), together(source.refs, refs), relation)
    return source if line is None else Source(Vector(*value), (line,))
