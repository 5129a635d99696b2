"""Angles, directions, deflections and scalar products, by their definitions."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    is_quantity,
    is_zero,
    walk,
)
from restitution.oracle.formula import compared
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.impacts import after, in_direction
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    component_formula,
    frame_after,
    in_the_plane,
    parts,
    velocity_formula,
    velocity_source,
)
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    difference,
    negative,
    product,
    square,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def tangent(tree: Expression) -> Expression:
    """The tangent of an angle."""
    return Apply("tan", tree)


def _frame_of_line(scene: Scene, body: str, stage: int, line: Expression) -> Frame:
    """The frame in which the angle to a wall or a line of centres is taken."""
    for event in sorted({stage, *scene.model.frames}):
        if event not in scene.model.frames or body not in scene.bodies(event):
            continue
        if stage not in (event, scene.last_event(body, event - 1)):
            continue
        frame = scene.model.frames[event]
        if line == Quantity("line_of_centres", (), event) or (
            isinstance(line, Name) and line.name == frame.wall
        ):
            return scene.frame(event)
    return frame_after(scene, body, stage)


def components_to_a_line(
    scene: Scene, body: str, stage: int, line: Expression
) -> tuple[Source, Source, tuple[Ref, ...]]:
    """The components of a velocity across a line and along it, and the walls that they rest on.

    The line is **i**, **j**, a wall or a line of centres. Raises NotPlannedError for another.
    """
    if isinstance(line, Unit):
        x, y = in_the_plane(scene, body, stage)
        return (y, x, ()) if line.axis == "i" else (x, y, ())
    frame = _frame_of_line(scene, body, stage, line)
    along, across = parts(scene, body, stage, frame)
    if isinstance(line, Name) and line.name == frame.wall:
        return along, across, ()
    if isinstance(line, Name) and _is_beside(scene, line, frame):
        return along, across, (f"wall {line.name}", f"wall {frame.wall}")
    if is_quantity(line, "line_of_centres"):
        return across, along, ()
    if isinstance(line, Name) and (side := _by_another(scene, line, frame)) is not None:
        above, below = (along, across) if side == "across" else (across, along)
        return above, below, (f"wall {line.name}", f"axis {frame.number}")
    raise NotPlannedError(f"an angle to {line}")


def angle_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The angle of a velocity with a line, or between two velocities."""
    velocity, line = quantity.arguments
    body, stage = body_and_stage(scene, velocity)
    if isinstance(line, Unit):
        return _angle_to_unit(scene, quantity, body, stage, line)
    if isinstance(line, Negate) and isinstance(line.operand, Unit):
        return _angle_to_unit(scene, quantity, body, stage, line.operand, sense=-1)
    if is_quantity(line, "velocity"):
        return _angle_between(scene, quantity)
    frame = _frame_of_line(scene, body, stage, line)
    above, below, walls = components_to_a_line(scene, body, stage, line)
    trees = []
    for source in (above, below):
        tree = tree_of(source.value)
        if _is_backwards(scene, source.value):
            # A sum of numbers alone has its terms the other way round: (√6 − √2)u/12.
            sums = sp.sympify(source.value, strict=True).atoms(sp.Add)
            numbers = sums and not any(own.free_symbols for own in sums)
            tree = tree_of(-source.value) if numbers else negative(tree)
        trees.append(tree)
    if is_zero(trees[1]):
        raise NotPlannedError("a right angle")
    value = tidy(above.value / below.value)
    value = -value if _is_backwards(scene, value) else value
    if not is_zero(trees[0]) and not _of_one_sign(scene, above.value):
        if not isinstance(line, Name):
            raise NotPlannedError("a tangent of open sign")
        # From which side the body comes to the wall is open.
        trees[0] = Apply("abs", tree_of(above.value))
        value = sp.Abs(above.value, evaluate=False) / tidy(below.value)
        value = -value if scene.model.sign(below.value) < 0 else value
        above = replace(above, value=sp.Abs(above.value, evaluate=False))
    both = {model.sign(model.in_data(below.value)) for model in scene.others} >= {1, -1}
    if (both and isinstance(line, Name)) or not _of_one_sign(scene, below.value):
        # Which way the body goes along the line is open, or not the same in each solution.
        size = sp.Abs(below.value, evaluate=False)
        trees[1], value = Apply("abs", tree_of(below.value)), tidy(above.value) / size
        value = -value if scene.model.sign(above.value) < 0 else value
    # Of what moves along the line the other component does not matter.
    sources = (above,) if is_zero(trees[0]) else (above, below)
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    refs = together(*(source.whole for source in sources), names, walls)
    if isinstance(line, Name) and not above.value.has(sp.Abs):
        refs = together(refs, _approach(scene, body, above.value, frame))
    return Formula(
        Move("define", "tan", frame.number, (body,)),
        tangent,
        quantity,
        Binary("/", *trees),
        value if value.has(sp.Abs) else tidy(value),
        refs,
    )


def _approach(scene: Scene, body: str, component: sp.Expr, frame: Frame) -> tuple[Ref, ...]:
    """That a body moves towards a wall, where that alone tells the sense of a component."""
    fact, sign = f"approach {frame.number}", scene.model.sign(component)
    if frame.wall is None or fact not in scene.facts or not component.free_symbols:
        return ()
    if scene.model.ground.decide(compared(sign * component, ">=", sp.S.Zero)):
        return ()
    return together((fact,), in_direction(scene, "along", body, frame.number - 1, frame).whole)


def _is_beside(scene: Scene, line: Name, frame: Frame) -> bool:
    """Whether a name is that of a wall parallel to the wall of an impact."""
    if frame.wall is None or line.name not in scene.model.story.walls:
        return False
    direction = scene.model.story.direction(line, scene.events)
    return bool(tidy(direction.dot(frame.n)) == 0)


def _by_another(scene: Scene, line: Name, frame: Frame) -> str | None:
    """How a wall of another event lies to a line of centres: along it, or across it; else None."""
    if line.name not in scene.model.story.walls or f"wall {line.name}" not in scene.facts:
        return None
    direction = scene.model.story.direction(line, scene.events)
    if tidy(direction.dot(frame.n)) == 0:
        return "across"
    return "along" if tidy(direction.cross(frame.n)) == 0 else None


def _angle_between(scene: Scene, quantity: Quantity) -> Formula:
    """The tangent of the angle between two velocities at one impact, by their components.

    Raises NotPlannedError where they belong to no impact, or it is open which leads the other.
    """
    pair = [body_and_stage(scene, argument) for argument in quantity.arguments]
    (first, late), (second, other) = pair
    event = max(late, other)
    together_ = late == other and event in scene.model.frames and first != second
    if not together_ or {first, second} != set(scene.bodies(event)):
        return _by_product(scene, quantity, pair)
    frame = scene.frame(event)
    (a, b), (c, d) = own = [parts(scene, *state, frame) for state in pair]
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    move = Move("define", "tan", event, (first, second))
    for body, (along, across), zero, worth in ((second, (a, b), d, c), (first, (c, d), b, a)):
        if zero.value == 0:
            own_line = after(scene, "along", body, frame)
            if scene.model.sign(scene.model.in_data(own_line.value)) < 0:
                own_line = worth  # who moves against the line does so by a value
            right, value = _to_the_line(scene, along, across, own_line)
            refs = together(*(source.whole for source in (along, across, zero, own_line)), names)
            return Formula(move, tangent, quantity, right, value, refs)
    cross = tidy(expanded(a.value * d.value - b.value * c.value))
    if not _of_one_sign(scene, cross):
        raise NotPlannedError("to which side a sphere turns is open")
    terms = [product(tree_of(x.value), tree_of(y.value)) for x, y in ((a, d), (b, c))]
    if scene.model.sign(cross) < 0:
        terms, cross = terms[::-1], -cross
    below = total(product(tree_of(x.value), tree_of(y.value)) for x, y in ((a, c), (b, d)))
    value = tidy(cross / tidy(expanded(a.value * c.value + b.value * d.value)))
    refs = together(*(source.whole for one in own for source in one), names)
    return Formula(move, tangent, quantity, Binary("/", difference(*terms), below), value, refs)


def _by_product(scene: Scene, quantity: Quantity, pair: Iterable[tuple[str, int]]) -> Formula:
    """The cosine of the angle between two velocities as vectors, by their scalar product."""
    pair = list(pair)
    sources = [velocity_as_a_line(scene, *state) for state in pair]
    (a, b), (c, d) = ([tree_of(value) for value in source.value] for source in sources)
    squares_ = [tidy(expanded(sum(value**2 for value in source.value))) for source in sources]
    if any(scene.model.identically_zero(size) for size in squares_):
        raise NotPlannedError("an angle to what is at rest")
    above = total((product(a, c), product(b, d)))
    sizes = [
        Apply("sqrt", total(square(tree_of(value)) for value in source.value if value != 0))
        for source in sources
    ]
    dot = sum(x * y for x, y in zip(sources[0].value, sources[1].value, strict=True))
    value = tidy(expanded(dot) / tidy(sp.sqrt(squares_[0])) / tidy(sp.sqrt(squares_[1])))
    bodies = tuple(dict.fromkeys(body for body, _ in pair))
    move = Move("define", "scalar-angle", max(stage for _, stage in pair) or None, bodies)
    refs = together(*(source.whole for source in sources))
    right = Binary("/", above, product(*sizes))
    return Formula(move, cosine, quantity, right, value, refs)


def cosine(tree: Expression) -> Expression:
    """The cosine of an angle."""
    return Apply("cos", tree)


def velocity_as_a_line(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector; where it is put together of components, by a line of its own."""
    source = velocity_source(scene, body, stage)
    if stage not in scene.model.frames or len(source.refs) == 1:
        return source
    number_ = write_formula(
        scene, velocity_formula(scene, Quantity("velocity", (Name(body),), stage))
    )
    return Source(source.value, (number_,))


def product_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The scalar product of two vectors, each as a line has it.

    That of a velocity and a unit vector along the line of centres or along an axis is a component.
    """
    if (own := _product_along_the_line(scene, quantity)) is not None:
        return own
    if (own := _component_along_an_axis(scene, quantity)) is not None:
        return own
    refs: list[Ref] = []
    vectors: list[Vector] = []
    bodies: list[str] = []
    late = 0
    for argument in quantity.arguments:
        for node in walk(argument):
            match node:
                case Quantity("velocity", (Name(body),), int(stage)):
                    last = scene.last_event(body, stage)
                    refs += velocity_as_a_line(scene, body, last).refs
                    bodies.append(body)
                    late = max(late, last)
                case Quantity("line_of_centres", (), int(number_)):
                    refs += scene.frame(number_).refs
                case Quantity() | Letter():
                    raise NotPlannedError("a scalar product of other vectors")
        put, _ = scene.put(scene.vector(argument))
        vectors.append(Vector(*(tidy(expanded(component)) for component in put)))
    if not refs:
        raise NotPlannedError("a scalar product of data")
    (a, b), (c, d) = ([tree_of(value) for value in own] for own in vectors)
    value = tidy(expanded(sum(x * y for x, y in zip(*vectors, strict=True))))
    move = Move("define", "product", late or None, tuple(dict.fromkeys(bodies)))
    right = total((product(a, c), product(b, d)))
    return Formula(move, itself, quantity, right, value, together(refs))


def _product_along_the_line(scene: Scene, quantity: Quantity) -> Formula | None:
    """A scalar product that is a component along the line of centres, where that is known."""
    match quantity.arguments:
        case (Quantity("velocity", (Name(),), int()) as velocity, axis) | (
            axis,
            Quantity("velocity", (Name(),), int()) as velocity,
        ):
            body, stage = body_and_stage(scene, velocity)
        case _:
            return None
    if axis != Quantity("line_of_centres", (), stage) or stage not in scene.model.frames:
        return None
    frame = scene.frame(stage)
    known = scene.desk.known(frame.component("along", body, stage))
    if known is None or scene.unknown(known.value):
        return None
    own = in_direction(scene, "along", body, stage, frame)
    move = Move("define", "product", stage, (body,))
    right = tree_of(own.value)
    pool = together(known.whole, own.whole, frame.refs, frame.unit_free)
    refs = scene.judge.needed(move, pool, chain(quantity, (right, None)))
    return None if refs is None else Formula(move, itself, quantity, right, own.value, refs)


def _component_along_an_axis(scene: Scene, quantity: Quantity) -> Formula | None:
    """The scalar product of a velocity with **i** or **j**, as the component in that direction.

    None where a line has the velocity as a vector: there the component is read off.
    """
    match quantity.arguments:
        case (Quantity("velocity", (Name(),), int()) as velocity, Unit() as axis) | (
            Unit() as axis,
            Quantity("velocity", (Name(),), int()) as velocity,
        ):
            body, stage = body_and_stage(scene, velocity)
        case _:
            return None
    vector = scene.desk.known(Quantity("velocity", (Name(body),), stage))
    if vector is not None or stage not in scene.model.frames:
        return None
    own = component_formula(scene, Quantity("along", (velocity, axis), quantity.stage))
    move = replace(own.move, record="product")
    refs = scene.judge.needed(move, own.refs, chain(quantity, (own.right, None)))
    return None if refs is None else replace(own, move=move, quantity=quantity, refs=refs)


def _to_the_line(
    scene: Scene, along: Source, across: Source, other: Source
) -> tuple[Expression, sp.Expr]:
    """The tangent of the angle to a velocity along the line of centres, of which the size cancels.

    ``other`` is that velocity; of its component no more than the sign is needed.
    """
    side = scene.model.sign(across.value)
    sense = scene.model.sign(scene.model.in_data(other.value))
    if (
        not side
        or not sense
        or not (_of_one_sign(scene, across.value) and _of_one_sign(scene, other.value))
    ):
        raise NotPlannedError("to which side a sphere turns is open")
    trees = [
        negative(tree_of(source.value)) if sign < 0 else tree_of(source.value)
        for source, sign in ((across, side), (along, sense))
    ]
    return Binary("/", *trees), tidy(side * sense * across.value / along.value)


def _is_backwards(scene: Scene, value: sp.Expr) -> bool:
    """Whether a value is negative, or would be with any other coefficient than 0."""
    symbols = sp.sympify(value, strict=True).free_symbols
    ones = {symbol: sp.S.One for symbol in symbols if scene.model.final.get(symbol) == 0}
    return scene.model.sign(value.xreplace(ones) if ones else value) < 0


def _of_one_sign(scene: Scene, value: sp.Expr) -> bool:
    """Whether a component has one sign, or is 0 at most at an end, for all admissible letters."""
    sign = scene.model.sign(value)
    return (
        scene.model.proved_sign(value) is not None
        or bool(scene.model.decide(sign * scene.model.in_data(value), ">=", 0))
        or bool(scene.model.ground.decide(compared(sign * value, ">=", sp.Integer(0))))
    )


def _angle_to_unit(
    scene: Scene, quantity: Quantity, body: str, stage: int, line: Unit, sense: int = 1
) -> Formula:
    """The angle to **i** or **j**, of up to 180°: what stands above is taken positive.

    With a ``sense`` of −1 it is the angle to −**i** or −**j**.
    """
    above, below, _ = components_to_a_line(scene, body, stage, line)
    below = replace(below, value=sense * below.value)
    if scene.model.identically_zero(below.value):
        raise NotPlannedError("a right angle")
    if scene.model.identically_zero(above.value):
        # Of 0° and 180°, which have one tangent, the scalar product tells which it is.
        own = velocity_as_a_line(scene, body, stage)
        worth = sp.Integer(scene.model.sign(below.value))
        move = Move("define", "scalar-angle", stage or None, (body,))
        return Formula(move, cosine, quantity, tree_of(worth), worth, own.whole)
    size = -above.value if scene.model.sign(above.value) < 0 else above.value
    along_the_line = _along_the_line(scene, body, stage)
    trees = tree_of(size), tree_of(below.value)
    if along_the_line and all(component.is_number for component in scene.frame(stage).n):
        # Along a line of centres the size of the velocity does not matter.
        common = sp.sqrt(size**2 + below.value**2)
        whole, _ = whole_direction(Vector(tidy(below.value / common), tidy(size / common)))
        trees = tree_of(whole.y), tree_of(whole.x)
        # On which side of **i** or **j** the body goes, the sense of the motion tells.
        across = in_direction(scene, "across", body, stage, scene.frame(stage))
        names = {scene.model.components[stage, body].symbol.name}
        sense_of = scene.desk.introducing(names) if across.value == 0 else across.whole
        along_the_line = together(along_the_line, sense_of)
    else:
        along_the_line = ()
    return Formula(
        Move("define", "tan", stage or None, (body,)),
        tangent,
        quantity,
        Binary("/", *trees),
        tidy(size / below.value),
        along_the_line or together(above.whole, below.whole),
    )


def direction_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The direction of a velocity, by the ratio of components."""
    body, stage = body_and_stage(scene, quantity)
    x, y = in_the_plane(scene, body, stage)
    if scene.model.identically_zero(x.value):
        raise NotPlannedError("a direction along j")
    along_the_line = _along_the_line(scene, body, stage)
    return Formula(
        Move("define", "tan-direction", stage or None, (body,)),
        tangent,
        quantity,
        *_slope(y.value, x.value, along_the_line),
        along_the_line or together(x.whole, y.whole),
    )


def _slope(y: sp.Expr, x: sp.Expr, simple: Any) -> tuple[Expression, sp.Expr]:
    """The tangent of a direction; of a line of centres without the size of the velocity."""
    value = tidy(y / x)
    return tree_of(value) if simple else Binary("/", tree_of(y), tree_of(x)), value


def _along_the_line(scene: Scene, body: str, stage: int) -> tuple[Ref, ...]:
    """Why a sphere moves along the line of centres, or across it: the component that is zero.

    () where both components are not zero.
    """
    if stage not in scene.model.frames:
        return ()
    frame = scene.frame(stage)
    if frame.across is not None or frame.n.x == 0 or frame.n.y == 0:
        return ()
    for kind in ("across", "along"):
        own = in_direction(scene, kind, body, stage, frame)
        if own.value == 0:
            # A direction in letters is that of the velocity with both its components.
            frame_ = frame if frame.write is not None else scene.model.frames[stage]
            plain = all(component.is_number for component in frame_.n)
            other = "along" if kind == "across" else "across"
            whole = () if plain else after(scene, other, body, frame).refs
            return together(own.refs, whole, frame.refs)
    return ()


def deflection_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The tangent of a deflection, by the components before and after."""
    (name,) = quantity.arguments
    event = quantity.stage
    assert isinstance(name, Name)
    assert isinstance(event, int)
    body, frame = name.name, scene.frame(event)
    early, late = (parts(scene, body, stage, frame) for stage in (event - 1, event))
    (c, s), (d, t) = early, late
    dot = tidy(expanded(c.value * d.value + s.value * t.value))
    if dot == 0:
        raise NotPlannedError("a deflection of a right angle")
    cross = tidy(expanded(c.value * t.value - s.value * d.value))
    if not _of_one_sign(scene, cross):
        raise NotPlannedError("to which side a sphere turns is open")
    trees = [tree_of(source.value) for source in (c, s, d, t)]
    above = [product(trees[0], trees[3]), product(trees[1], trees[2])]
    if scene.model.sign(cross) < 0:
        above, cross = above[::-1], -cross
    below = total((product(trees[0], trees[2]), product(trees[1], trees[3])))
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    whole = together(*(source.whole for source in (*early, *late)), names)
    if c.value == 0 and s.value == t.value and not (frame.is_slanted or frame.wall):
        # It came across the line of centres, and keeps that component.
        aside, ahead = (
            tree_of(-own.value if scene.model.sign(own.value) < 0 else own.value) for own in (d, t)
        )
        move = Move("define", "tan-from-axis", event, (body,))
        right = Binary("/", aside, ahead)
        return Formula(move, tangent, quantity, right, tidy(cross / dot), whole)
    return Formula(
        Move("define", "tan-deflection", event, (body,)),
        tangent,
        quantity,
        Binary("/", difference(*above), below),
        tidy(cross / dot),
        whole,
    )
