"""Angles between directions: velocities, lines of centres, walls, and those of the plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.data.offset_angles import offset_angle
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    is_quantity,
    unsigned,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.axes.by_changes import write_wall
from restitution.planning.formulas.angle_formulas import cosine
from restitution.planning.formulas.definitions import Formula, write_formula
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    size_that_stands,
    velocity_source,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import product, square, total, tree_of
from restitution.planning.writing.polynomials import expanded, polynomial_in
from restitution.planning.writing.ratio_of_an_angle import Ratio
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.solving.story.letters import roles
from restitution.vector import Vector


def is_moving(tree: Expression) -> bool:
    """Whether a direction is that of a velocity."""
    return is_quantity(tree, "velocity")


def is_line(tree: Expression) -> bool:
    """Whether a direction has two senses: that of a wall, or of a line of centres."""
    return isinstance(tree, Name) or is_quantity(tree, "line_of_centres")


def has_angle(tree: Expression) -> bool:
    """Whether degrees, or the angle of a ratio, stand in an expression."""
    inverse = ("arcsin", "arccos", "arctan")
    return any(
        isinstance(node, Degrees) or (isinstance(node, Apply) and node.function in inverse)
        for node in walk(tree)
    )


def angle_of_lines(scene: Scene, quantity: Quantity) -> Formula:
    """The cosine of the angle between two directions, by their scalar product."""
    sources = [_source(scene, argument) for argument in quantity.arguments]
    a, b = (source.value for source in sources)
    sizes = [
        size_that_stands(scene, *body_and_stage(scene, argument)) if is_moving(argument) else None
        for argument in quantity.arguments
    ]
    pairs = [(tree_of(p), tree_of(q)) for p, q in zip(a, b, strict=True)]
    right, value = cosine_of(pairs, a, b, sizes)
    if any(map(is_line, quantity.arguments)) and scene.model.sign(value) < 0:
        b = -b
        pairs = [(tree_of(p), tree_of(q)) for p, q in zip(a, b, strict=True)]
        right, value = cosine_of(pairs, a, b, sizes)
    moving = [
        body_and_stage(scene, argument) for argument in quantity.arguments if is_moving(argument)
    ]
    event = max((stage for _, stage in moving), default=0) or None
    move = Move("define", "scalar-angle", event, tuple(dict.fromkeys(body for body, _ in moving)))
    return Formula(
        move,
        cosine,
        quantity,
        right,
        value,
        together(*(e.whole for e in sources)),
    )


def _source(scene: Scene, tree: Expression) -> Source:
    if is_moving(tree):
        return whole_velocity(scene, *body_and_stage(scene, tree))
    return line_source(scene, tree)


def line_source(scene: Scene, tree: Expression) -> Source:
    """A direction of the plane, by whole numbers where there are any."""
    refs: tuple[Ref, ...] = ()
    match tree:
        case Quantity("line_of_centres", (), int(number)):
            frame = scene.frame(number)
            return Source(whole_direction(frame.n)[0], frame.refs)
        case Name(wall) if f"wall {wall}" in scene.facts:
            refs = (f"wall {wall}",)
        case Name(wall):
            refs = (write_wall(scene, wall),)
    value, more = scene.put(scene.model.story.direction(tree, scene.events))
    whole, _ = whole_direction(Vector(*map(tidy, value)))
    return Source(whole, together(refs, more))


def whole_velocity(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector; where its components are not along **i** and **j**, by a line."""
    source = velocity_source(scene, body, stage)
    if stage not in scene.model.frames or len(source.refs) == 1:
        return source
    frame = scene.frame(stage)
    if frame.across is not None or frame.n.x == 0 or frame.n.y == 0:
        return source
    number = write_formula(scene, formula(scene, Quantity("velocity", (Name(body),), stage)))
    return Source(source.value, (number,))


def cosine_of(
    pairs: list[tuple[Expression, Expression]],
    a: Any,
    b: Any,
    known: Sequence[Expression | None] = (None, None),
) -> tuple[Expression, sp.Expr]:
    """The cosine of the angle between two vectors: as it is written, and what it comes to.

    ``known`` are their sizes, where they are known.
    """
    above = total(product(p, q) for p, q in pairs)
    sizes = []
    for n in (0, 1):
        if (size_ := known[n]) is not None:
            sizes.append(size_)
            continue
        own = [square(pair[n]) for pair, value in zip(pairs, (a, b)[n], strict=True) if value != 0]
        one = [pair[n] for pair, value in zip(pairs, (a, b)[n], strict=True) if value != 0]
        alone = unsigned(one[0])
        if len(one) != 1 and tidy(sum(value**2 for value in (a, b)[n])) == 1:
            continue  # a unit vector
        sizes.append(alone if len(one) == 1 else Apply("sqrt", total(own)))
    dot = expanded(sum(p * q for p, q in zip(a, b, strict=True)))
    squares = [expanded(sum(p**2 for p in own)) for own in (a, b)]
    dot, *squares = _without_common_factors(dot, *squares)
    size = sp.sqrt(squares[0]) * sp.sqrt(squares[1])
    return Binary("/", above, product(*sizes)) if sizes else above, tidy(dot / size)


def _without_common_factors(dot: sp.Expr, *squares: sp.Expr) -> list[sp.Expr]:
    """A product and the squares of two sizes without the positive letters that cancel in them."""
    values = [dot, *squares]
    for symbol in sorted(dot.free_symbols, key=lambda symbol: symbol.name):
        if not symbol.is_positive or not all(value.is_polynomial(symbol) for value in values):
            continue
        above, *below = (polynomial_in(value, symbol) for value in values)
        alone = all(len(value.monoms()) == 1 for value in (above, *below))
        if alone and 2 * above.degree() == sum(value.degree() for value in below):
            values = [value.subs(symbol, 1) for value in values]
    return values


def sine_of_the_offset(scene: Scene, equation: GivenEquation) -> int | None:
    """The angle of a line of centres to the path that is given, where an offset tells that line.

    Its sine is the offset over the distance of the centres. None where it is no such angle.
    """
    match equation.link.left:
        case Quantity("angle", arguments):
            pass
        case _:
            return None
    numbers = [side.stage for side in arguments if is_quantity(side, "line_of_centres")]
    fact = scene.facts.get(f"axis {numbers[0]}") if len(numbers) == 1 else None
    match fact and fact.relation.only[0].right:
        case Polar(_, Apply("arcsin", sine)):
            pass
        case _:
            return None
    assert fact is not None
    whole = scene.scalar(sine)
    value, refs = scene.put(scene.scalar(equation.link.right))
    if not scene.model.decide(whole, ">=", 0) or value.free_symbols:
        return None
    left = tree_of(tidy(whole))
    relation = chain(left, (tree_of(tidy(sp.sin(value))), None))
    move = Move("define", "scalar-angle")
    pool = [ref for ref in scene.facts if ref.startswith(("given ", "velocity "))]
    premises = scene.judge.enough(move, together(equation.refs, refs, (fact.id,)), relation, pool)
    return None if premises is None else scene.desk.write(move, premises, relation)


def sine_of_an_offset(scene: Scene, asked: Quantity, letter: str, meaning: Ref) -> int | None:
    """The sine of the angle of a line of centres to a line along the path, by the offset.

    None of another angle, and where an answer has the line of centres itself.
    """
    lines = [side for side in asked.arguments if is_quantity(side, "line_of_centres")]
    impact = lines[0].stage if len(lines) == 1 else None
    fact = scene.facts.get(f"axis {impact}")
    if fact is None or not isinstance(impact, int):
        return None
    if any(end.answer.options[0][0].left in lines for end in scene.desk.ends):
        return None
    own = offset_angle(fact.relation.only[0], roles(scene.problem))
    value = None if own is None else tidy(scene.scalar(own.sine))
    if own is None or value is None or not value.is_number:
        return None
    subject = Apply("sin", Letter(letter))
    whole = chain(subject, (own.sine, None), (tree_of(value), "rearrange"))
    if any(
        line.move.id == "fact" and fact.id in line.premises and scene.desk.holds(line.number)
        for line in scene.desk.lines
    ):
        whole = chain(subject, (tree_of(value), None))  # the offset is in the line of the centres
    moving = (node for node in asked.arguments if is_quantity(node, "velocity"))
    paths = (f"velocity {node.arguments[0].name}" for node in moving)  # type: ignore[union-attr]
    pool = (fact.id, meaning, *(ref for ref in paths if ref in scene.facts))
    return scene.judge.write((Move("define", "scalar-angle", impact),), pool, whole)


def ratio_by_an_offset(scene: Scene, asked: Quantity, extent: str) -> Ratio | None:
    """The sine of an angle with a line of centres by the offset; None where that tells none."""
    if any(is_quantity(node, "velocity") and node.stage for node in asked.arguments):
        return None  # the path is that before the impact
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, asked)
    line = sine_of_an_offset(scene, asked, letter, meaning)
    if line is None:
        scene.desk.back(mark)
        return None
    value = scene.scalar(scene.desk.last_link(line).right)
    return Ratio(line, letter, "sin", value, extent.format(letter))


__all__ = [
    "angle_of_lines",
    "cosine_of",
    "has_angle",
    "is_line",
    "is_moving",
    "line_source",
    "ratio_by_an_offset",
    "sine_of_the_offset",
    "whole_velocity",
]
