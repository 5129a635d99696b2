"""Deflections: one that is given, as an equation in components; the cosine of one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Name,
    Negate,
    Quantity,
    is_zero,
    letters,
)
from restitution.planning.angles.angles_after_walls import (
    given_by_the_angle_after,
    given_by_the_sum,
)
from restitution.planning.angles.given_turns import given_turn
from restitution.planning.angles.wall_turns import given_at_a_wall, goes_on, related_at_a_wall
from restitution.planning.formulas.angle_formulas import cosine
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def write_deflection(scene: Scene, equation: GivenEquation) -> int:
    """The line of a deflection that is given: a right angle by the scalar product, else tan δ."""
    quantity = equation.link.left
    assert isinstance(quantity, Quantity)
    (name,), event = quantity.arguments, quantity.stage
    if not isinstance(name, Name) or event not in scene.model.frames:
        raise NotPlannedError("a deflection by a blow")
    assert isinstance(event, int)
    frame = scene.frame(event)
    early, late = (
        tuple(in_direction(scene, kind, name.name, stage, frame) for kind in COMPONENTS)
        for stage in (event - 1, event)
    )
    (c, s), (d, t) = early, late
    angle, refs = scene.put(scene.scalar(equation.link.right))
    if angle == sp.pi / 2:
        return _at_right_angles(scene, equation, name.name, event, early, late)
    line = _from_an_axis(scene, equation, name.name, event, early, late)
    if line is not None:
        return line
    components = {own.symbol for own in scene.model.components.values()}
    if d.value in components and scene.model.sign(d.value) < 0:
        raise NotPlannedError("a component that is drawn in the other sense")
    # With e < 0 it would turn through no sum of angles.
    if frame.wall is not None and not goes_on(scene, name.name, frame):
        line = given_at_a_wall(scene, equation, name.name, frame, angle)
        line = line or related_at_a_wall(scene, equation)
        worth = Source(angle, together(equation.refs, refs))
        line = line or given_by_the_angle_after(scene, equation, name, frame, worth)
        line = line or given_by_the_sum(scene, equation, name, frame, worth)
    elif frame.wall is None:
        line = given_turn(scene, equation)
    if line is not None:
        return line
    cross = c.value * t.value - s.value * d.value
    trees = [tree_of(own.value) for own in (c, s, d, t)]
    above = [product(trees[0], trees[3]), product(trees[1], trees[2])]
    if scene.model.sign(cross) < 0:
        above.reverse()
    below = total((product(trees[0], trees[2]), product(trees[1], trees[3])))
    left, more = _tangent_of(scene, angle)
    relation = chain(left, (swept(Binary("/", difference(*above), below)), None))
    move = Move("define", "tan-deflection", event, (name.name,))
    sources = together(equation.refs, refs, *(own.refs for own in (*early, *late)))
    return _written(scene, move, sources, relation, (*frame.refs, *more))


def _tangent_of(scene: Scene, angle: sp.Expr) -> tuple[Expression, tuple[Ref, ...]]:
    """``tan 60°``, or what the tangent of an angle is worth, with what that rests on."""
    tangent, more = scene.put(tangent_of_angle(angle))
    degrees = tree_of(angle, angle=True)
    named = isinstance(degrees, Degrees)
    return Apply("tan", degrees) if named else tree_of(tidy(tangent)), more


def _from_an_axis(
    scene: Scene,
    equation: GivenEquation,
    body: str,
    event: int,
    early: tuple[Source, ...],
    late: tuple[Source, ...],
) -> int | None:
    """The tangent of a deflection of a sphere that came across the line of centres.

    It keeps that component. None of another, and where it is open to which side it turns.
    """
    (c, s), (d, t) = early, late
    frame = scene.frame(event)
    if frame.wall or frame.is_slanted or c.value != 0 or s.value != t.value:
        return None
    aside, ahead = (
        tree_of(-own.value if scene.model.sign(own.value) < 0 else own.value) for own in (d, t)
    )
    angle, refs = scene.put(scene.scalar(equation.link.right))
    left, more = _tangent_of(scene, angle)
    sources = together(equation.refs, refs, *(own.refs for own in (*early, *late)))
    move = Move("define", "tan-from-axis", event, (body,))
    relation = chain(left, (swept(Binary("/", aside, ahead)), None))
    try:
        return _written(scene, move, sources, relation, (*frame.refs, *more))
    except NotPlannedError:
        return None


def _at_right_angles(
    scene: Scene,
    equation: GivenEquation,
    body: str,
    event: int,
    early: tuple[Source, ...],
    late: tuple[Source, ...],
) -> int:
    pairs = list(zip(early, late, strict=True))
    tree: Any = total(product(tree_of(p.value), tree_of(q.value)) for p, q in pairs)
    used: list[Any] = []
    for p, q in pairs:
        zero = next((own for own in (p, q) if own.value == 0), None)
        used += [zero] if zero is not None else [p, q]
    refs = together(equation.refs, *(own.refs for own in used))
    move = Move("define", "perpendicular", event, (body,))
    relation = Relation(((link(swept(tree), ZERO),),))
    return _written(scene, move, refs, relation, scene.frame(event).refs)


def _written(
    scene: Scene, move: Move, refs: Sequence[Ref], relation: Relation, axis: tuple[Ref, ...]
) -> int:
    names = {
        name
        for links in relation.options
        for equation in links
        for side in (equation.left, equation.right)
        for name in letters(side)
    }
    own = scene.judge.enough(move, refs, relation, (*axis, *background(scene, names)))
    if own is None:
        raise NotPlannedError("a deflection to either side")
    return scene.desk.write(move, own, relation)


# --- the cosine ---------------------------------------------------------------------------------


def _pair(scene: Scene, body: str, stage: int, frame: Frame) -> tuple[Source, Source]:
    along, across = (in_direction(scene, axis, body, stage, frame) for axis in COMPONENTS)
    return along, across


def _product(a: Source, b: Source) -> Expression:
    trees = tree_of(a.value), tree_of(b.value)
    if a.value == b.value and a.value.is_Symbol:
        return square(trees[0])
    return trees[0] if is_zero(trees[0]) else product(*trees)


def scalar_product(
    scene: Scene, pair: Sequence[tuple[str, int]], event: int, *, signed: bool = False
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The scalar product of two velocities, each of a body after an event, by components.

    As a tree, as a value that is not worked out, and what it rests on. In a ``signed`` one of which
    a product has two minus signs all components stand as they are above.
    """
    frame = scene.frame(event)
    (a, b), (c, d) = (_pair(scene, body, stage, frame) for body, stage in pair)
    value = a.value * c.value + b.value * d.value
    refs = together(*(source.whole for source in (a, b, c, d)), frame.names_axis("along"))
    trees = [tuple(tree_of(own.value) for own in both) for both in ((a, c), (b, d))]
    if signed and any(all(isinstance(own, Negate) for own in both) for both in trees):
        terms = (Binary("*", *both) for both in trees if not any(map(is_zero, both)))
        return total(terms), value, refs
    tree = total(_product(x, y) for x, y in ((a, c), (b, d)))
    return swept(tree) if signed else tree, value, refs


def cosine_of_deflection(scene: Scene, quantity: Quantity) -> Formula:
    """``cos(deflection) = (a c + b d)/(√(a² + b²) √(c² + d²))``; the value is what stands above."""
    (name,) = quantity.arguments
    if not isinstance(name, Name) or not isinstance(quantity.stage, int):
        raise NotPlannedError("the deflection of what is no body")
    event = quantity.stage
    frame = scene.frame(event)
    early = _pair(scene, name.name, event - 1, frame)
    late = _pair(scene, name.name, event, frame)
    both = ((name.name, event - 1), (name.name, event))
    above, value, refs = scalar_product(scene, both, event)
    sizes = (
        Apply("sqrt", total(square(tree_of(source.value)) for source in pair if source.value != 0))
        for pair in (early, late)
    )
    value = tidy(value)
    move = Move("define", "scalar-angle", event, (name.name,))
    return Formula(move, cosine, quantity, Binary("/", above, product(*sizes)), value, refs)
