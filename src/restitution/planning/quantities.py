"""What is asked or given, by its definition, with the components put in that are known."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from restitution.errors import StatementError
from restitution.exact import tidy
from restitution.explaining.derivation import Move, MoveId, Ref
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    children,
    has_quantity,
    is_zero,
    letters,
    walk,
)
from restitution.planning import journeys, place_trees
from restitution.planning.desk import NotPlannedError, Source, chain, together
from restitution.planning.forms import (
    difference,
    negative,
    number,
    product,
    square,
    swept,
    total,
    tree_of,
    vector,
)
from restitution.planning.frames import Frame
from restitution.planning.impacts import after, blown, in_direction, whole_direction
from restitution.planning.polynomials import expanded, one_fraction
from restitution.planning.premises import background, not_negative, sign_known
from restitution.planning.scene import Scene
from restitution.planning.vectors import velocity_given
from restitution.vector import Vector


@dataclass(frozen=True)
class Formula:
    """A definition with values put in: ``left`` is the quantity, a power or a ratio of it.

    ``value`` is what the right side is worth; ``of`` makes the left side of any tree that stands
    for the quantity.
    """

    move: Move
    of: Callable[[Expression], Expression]
    quantity: Expression
    right: Expression
    value: Any
    refs: tuple[Ref, ...]

    @property
    def left(self) -> Expression:
        """The left side, of the quantity itself."""
        return self.of(self.quantity)


def _itself(tree: Expression) -> Expression:
    return tree


def formula(scene: Scene, quantity: Quantity) -> Formula:
    """The definition by which a quantity is worked out. Raises NotPlannedError without one."""
    if place_trees.serves(quantity):
        return _of_journey(scene, quantity)
    own = _FORMULAS.get(quantity.kind)
    if own is None:
        raise NotPlannedError(f"no definition of {quantity.kind}")
    return own(scene, quantity)


def _of_journey(scene: Scene, quantity: Quantity) -> Formula:
    """A time, a place or a distance, as the line has it that is written for it."""
    return _of_line(scene, quantity, *journeys.write(scene, quantity))


def known_vector(scene: Scene, body: str, stage: int) -> Source | None:
    """A velocity that is known as a vector: after a blow, or by a line, in a slanting frame."""
    velocity = Quantity("velocity", (Name(body),), stage)
    if not stage:
        return None
    if stage in scene.model.frames:
        if not scene.frame(stage).is_slanted:
            return None
        both = {sphere: _source_of(scene, sphere, stage) for sphere in scene.spheres(stage)}
        # By momentum as vectors the second velocity has no components: then both are vectors.
        vectors = [own for own in both.values() if own and not _by_components(scene, own)]
        return both[body] if vectors else None
    known = blown(scene, body, stage)
    value, refs = scene.put(known.value)
    if (
        len(known.refs) != 1
        or not isinstance(known.refs[0], int)
        or not refs
        or scene.unknown(value)
    ):
        return known
    relation = chain(velocity, (tree_of(Vector(*map(tidy, value))), None))
    line = scene.desk.write(Move("put"), (*known.refs, *refs), relation)
    return scene.desk.know(velocity, value, (line,))


def _source_of(scene: Scene, body: str, stage: int) -> Source | None:
    return scene.desk.known(Quantity("velocity", (Name(body),), stage))


def _by_components(scene: Scene, source: Source) -> bool:
    """Whether the line of a velocity puts it together of its components along a slanting line."""
    below: list[Ref] = [*source.refs]
    while below:
        ref = below.pop()
        if isinstance(ref, int):
            own = scene.desk.line(ref)
            if own.move.record == "assemble" and len(own.premises) > 2:
                return True
            if own.move.id in ("rearrange", "put"):
                below += own.premises[:1]
    return False


def _of_line(scene: Scene, quantity: Quantity, number_: int, value: Any) -> Formula:
    """What a line says that stands, as a definition."""
    line = scene.desk.line(number_)
    right = scene.desk.relation(number_).only[0].right
    return Formula(line.move, _itself, quantity, right, value, line.premises)


# --- velocities --------------------------------------------------------------------------------


def body_and_stage(scene: Scene, velocity: Expression) -> tuple[str, int]:
    """The body of a velocity, and the last event that changed it."""
    match velocity:
        case Quantity("velocity" | "speed" | "direction", (Name(body),), int(stage)):
            return body, scene.last_event(body, stage)
    raise NotPlannedError(f"{velocity} is no velocity of a body")


def frame_after(scene: Scene, body: str, stage: int) -> Frame:
    """The frame in which a velocity is known: of its impact, or of the next of an initial one."""
    if stage in scene.model.frames:
        return scene.frame(stage)
    for event in range(stage + 1, scene.events + 1):
        if body in scene.bodies(event) and event in scene.model.frames:
            return scene.frame(event)
    # Who meets nothing is told by **i** and **j**.
    return scene.frame(stage)


def parts(scene: Scene, body: str, stage: int, frame: Frame | None = None) -> list[Source]:
    """The components of a velocity, along and across, with all known values put in."""
    own = frame or frame_after(scene, body, stage)
    return [in_direction(scene, kind, body, stage, own) for kind in ("along", "across")]


def _velocity_at_the_start(scene: Scene, quantity: Quantity, body: str) -> Formula:
    """The velocity of the data, with the letters put in that have been found."""
    source = scene.initial(body)
    value, refs = scene.put(source.value)
    if not refs:
        raise NotPlannedError("a velocity that is given")
    whole = Vector(*(tidy(each) for each in value))
    own = Quantity(quantity.kind, quantity.arguments, 0)
    is_given = f"velocity {body}" in scene.facts
    move = Move("put") if is_given else Move("define", "assemble", None, (body,))
    return Formula(move, _itself, own, tree_of(whole), whole, together(source.refs, refs))


def _once_more(scene: Scene, quantity: Quantity, body: str, stage: int, known: Source) -> Formula:
    """A velocity that is a line already, perhaps in letters that are known by now."""
    value, refs = scene.put(known.value)
    own = Quantity(quantity.kind, quantity.arguments, stage)
    whole = Vector(*(tidy(each) for each in value))
    move = Move("put") if refs else Move("rearrange")
    return Formula(move, _itself, own, tree_of(whole), whole, together(known.refs, refs))


def _velocity(scene: Scene, quantity: Quantity) -> Formula:
    body, stage = body_and_stage(scene, quantity)
    if not stage:
        return _velocity_at_the_start(scene, quantity, body)
    known = scene.desk.known(Quantity("velocity", (Name(body),), stage))
    if stage not in scene.model.frames and known is None:
        known = blown(scene, body, stage)
    if known is not None:
        return _once_more(scene, quantity, body, stage, known)
    frame = frame_after(scene, body, stage)
    along, across = parts(scene, body, stage, frame)
    value = frame.n * along.value + frame.t * across.value
    refs = together(along.refs, across.refs, frame.unit_free if stage else ())
    aligned = frame.across is not None or frame.n in (Vector(1, 0), Vector(0, 1))
    if aligned:
        right = vector(tree_of(value.x), tree_of(value.y))
    else:
        right = total(
            product(tree_of(own.value), _unit_tree(direction))
            for own, direction in ((along, frame.n), (across, frame.t))
        )
    move = Move("define", "assemble", stage or None, (body,))
    return Formula(move, _itself, quantity, right, Vector(*map(tidy, value)), refs)


def _unit_tree(direction: Vector) -> Expression:
    """A unit vector as a whole number of **i** and **j** over its length."""
    whole, length = whole_direction(direction)
    tree = vector(*map(tree_of, whole))
    return tree if length == 1 else Binary("/", tree, tree_of(length))


def squares(
    scene: Scene, body: str, stage: int, *, known: bool = False
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The square of a speed by its components: as a tree, as a value, and what it rests on.

    With ``known`` a speed that is given, or a line, is taken.
    """
    if not stage:
        return _initial_square(scene, body)
    struck = known_vector(scene, body, stage)
    if struck is not None:
        value, more = scene.put(struck.value)
        tree = total(square(tree_of(each)) for each in value if each != 0)
        return tree, sum(each**2 for each in value), together(struck.refs, more)
    frame = frame_after(scene, body, stage)
    own = parts(scene, body, stage, frame)
    known = known and not any(scene.unknown(each.value) for each in own)
    speed = known_speed(scene, body, stage) if known else None
    if speed is not None:
        return square(tree_of(speed.value)), speed.value**2, speed.refs
    refs = together(*(each.refs for each in own), _bridge(frame, own))
    tree = total(square(tree_of(each.value)) for each in own if each.value != 0)
    return tree, sum(each.value**2 for each in own), refs


def known_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that is given, or a line already; None where it is neither."""
    quantity = Quantity("speed", (Name(body),), stage)
    known = scene.desk.known(quantity)
    if known is not None:
        value, refs = scene.put(known.value)
        return Source(value, together(known.refs, refs))
    for each in scene.given:
        if each.link.sign == "=" and each.link.left == quantity:
            if has_quantity(each.link.right):
                continue
            value, refs = scene.put(scene.scalar(each.link.right))
            return Source(value, together((each.fact.id,), refs))
    return None


def _bridge(frame: Frame, components: Iterable[Source]) -> tuple[Ref, ...]:
    """The axis, where one component is named by it and the other by **i** or **j**."""
    mixed = isinstance(frame.along, Quantity) and frame.across is not None
    return frame.refs if mixed and not any(component.axis for component in components) else ()


def _initial_square(scene: Scene, body: str) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The square of the speed at the start, by its size or by its components."""
    fact = f"velocity {body}"
    initial = scene.initial(body)
    if fact not in scene.facts:
        value, refs = scene.put(initial.value)
        tree = total(square(tree_of(each)) for each in value if each != 0)
        return tree, sum(each**2 for each in value), together(initial.refs, refs)
    (link,) = scene.facts[fact].relation.only
    if isinstance(link.right, Polar):
        size, refs = scene.put(scene.scalar(link.right.size))
        return square(tree_of(size)), size**2, together((fact,), refs)
    value, refs = scene.put(initial.value)
    tree = total(square(tree_of(each)) for each in value if each != 0)
    return tree, sum(each**2 for each in value), together((fact,), refs)


def _speed(scene: Scene, quantity: Quantity) -> Formula:
    body, stage = body_and_stage(scene, quantity)
    tree, value, refs = squares(scene, body, stage)
    move = Move("define", "speed", stage or None, (body,))
    size = tidy(sp.sqrt(tidy(expanded(value))))
    if len({atom.args for atom in value.atoms(sp.sin, sp.cos)}) > 1:
        # Products of ratios of several angles are longer multiplied out.
        size = min(size, _with_factor_outside(value), key=lambda each: each.count_ops())
    return Formula(move, _itself, quantity, Apply("sqrt", tree), size, refs)


def _with_factor_outside(square_: sp.Expr) -> sp.Expr:
    """The root of a sum of squares, with the positive letters outside that all of them have."""
    terms = sp.Add.make_args(square_)
    powers = [sp.Mul(*sp.Mul.make_args(term)).as_powers_dict() for term in terms]
    common = [s for s in powers[0] if s.is_Symbol and s.is_positive]
    shared = sp.Mul(*(s ** (min(power[s] for power in powers) // 2) for s in common))
    return shared * sp.sqrt(sp.Add(*(term / shared**2 for term in terms)))


def _component(scene: Scene, quantity: Quantity) -> Formula:
    velocity, direction = quantity.arguments
    body, stage = body_and_stage(scene, velocity)
    frame = frame_after(scene, body, stage)
    wanted = scene.model.story.direction(direction, scene.events)
    if quantity.kind == "across":
        wanted = wanted.turned_left()
    size = scene.model.story.size(wanted)
    unit = Vector(tidy(wanted.x / size), tidy(wanted.y / size))
    own = parts(scene, body, stage, frame)
    shares = [tidy(each.dot(unit)) for each in (frame.n, frame.t)]
    axis: tuple[Ref, ...] = ()
    if isinstance(direction, Quantity) and direction.kind == "line_of_centres" and -1 in shares:
        axis = _as_in_the_statement(scene, direction, wanted)
    elif isinstance(direction, Quantity) and isinstance(frame.along, Unit):
        axis = frame.refs
    used = [(a, b) for a, b in zip(own, shares, strict=True) if b != 0]
    right = total(product(tree_of(a.value), tree_of(b)) for a, b in used)
    value = tidy(sum(a.value * b for a, b in used))
    walls = (
        f"wall {node.name}"
        for node in walk(direction)
        if isinstance(node, Name) and f"wall {node.name}" in scene.facts
    )
    refs = together(*(a.refs for a, _ in used), frame.unit_free, walls, axis)
    return Formula(
        Move("define", "component", stage or None, (body,)), _itself, quantity, right, value, refs
    )


def _as_in_the_statement(scene: Scene, centres: Quantity, wanted: Vector) -> tuple[Ref, ...]:
    """The fact that gives a line of centres, from the first sphere to the second.

    Raises NotPlannedError where it has the other sense, as it was typed.
    """
    name = f"axis {centres.stage}"
    fact = scene.facts.get(name)
    direction = (
        None if fact is None else scene.model.story.direction(fact.relation.only[0].right, 0)
    )
    if direction is None or scene.model.sign(direction.dot(wanted)) <= 0:
        raise NotPlannedError("a component against the line of centres")
    return (name,)


# --- angles ------------------------------------------------------------------------------------


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


def _angle(scene: Scene, quantity: Quantity) -> Formula:
    velocity, line = quantity.arguments
    body, stage = body_and_stage(scene, velocity)
    if isinstance(line, Unit):
        return _angle_to_unit(scene, quantity, body, stage, line)
    if isinstance(line, Quantity) and line.kind == "velocity":
        return _angle_between(scene, quantity)
    frame = _frame_of_line(scene, body, stage, line)
    along, across = parts(scene, body, stage, frame)
    walls: tuple[Ref, ...] = ()
    if isinstance(line, Name) and line.name == frame.wall:
        above, below = along, across
    elif isinstance(line, Name) and _is_beside(scene, line, frame):
        above, below, walls = along, across, (f"wall {line.name}", f"wall {frame.wall}")
    elif isinstance(line, Quantity) and line.kind == "line_of_centres":
        above, below = across, along
    else:
        raise NotPlannedError(f"an angle to {line}")
    trees = []
    for each in (above, below):
        tree = tree_of(each.value)
        trees.append(negative(tree) if scene.model.sign(each.value) < 0 else tree)
    if is_zero(trees[1]):
        raise NotPlannedError("a right angle")
    value = tidy(above.value / below.value)
    value = -value if scene.model.sign(value) < 0 else value
    if not is_zero(trees[0]) and not _of_one_sign(scene, above.value):
        raise NotPlannedError("a tangent of open sign")
    if not _of_one_sign(scene, below.value):
        # Which way the body goes along the line is open.
        size = sp.Abs(below.value, evaluate=False)
        trees[1], value = Apply("abs", trees[1]), tidy(above.value) / size
        value = -value if scene.model.sign(above.value) < 0 else value
    # Of what moves along the line the other component does not matter.
    sources = (above,) if is_zero(trees[0]) else (above, below)
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    refs = together(*(source.whole for source in sources), names, walls)
    return Formula(
        Move("define", "tan", frame.number, (body,)),
        tangent,
        quantity,
        Binary("/", *trees),
        value if value.has(sp.Abs) else tidy(value),
        refs,
    )


def _is_beside(scene: Scene, line: Name, frame: Frame) -> bool:
    """Whether a name is that of a wall parallel to the wall of an impact."""
    if frame.wall is None or line.name not in scene.model.story.walls:
        return False
    direction = scene.model.story.direction(line, scene.events)
    return bool(tidy(direction.dot(frame.n)) == 0)


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
    (a, b), (c, d) = own = [parts(scene, *each, frame) for each in pair]
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    move = Move("define", "tan", event, (first, second))
    for body, (along, across), zero in ((second, (a, b), d), (first, (c, d), b)):
        if zero.value == 0:
            own_line = after(scene, "along", body, frame)
            right, value = _to_the_line(scene, along, across, own_line)
            refs = together(*(each.whole for each in (along, across, zero, own_line)), names)
            return Formula(move, tangent, quantity, right, value, refs)
    cross = tidy(expanded(a.value * d.value - b.value * c.value))
    if not _of_one_sign(scene, cross):
        raise NotPlannedError("to which side a sphere turns is open")
    terms = [product(tree_of(x.value), tree_of(y.value)) for x, y in ((a, d), (b, c))]
    if scene.model.sign(cross) < 0:
        terms, cross = terms[::-1], -cross
    below = total(product(tree_of(x.value), tree_of(y.value)) for x, y in ((a, c), (b, d)))
    value = tidy(cross / tidy(expanded(a.value * c.value + b.value * d.value)))
    refs = together(*(each.whole for one in own for each in one), names)
    return Formula(move, tangent, quantity, Binary("/", difference(*terms), below), value, refs)


def _by_product(scene: Scene, quantity: Quantity, pair: Iterable[tuple[str, int]]) -> Formula:
    """The cosine of the angle between two velocities as vectors, by their scalar product."""
    pair = list(pair)
    sources = [_as_a_line(scene, *each) for each in pair]
    (a, b), (c, d) = ([tree_of(each) for each in source.value] for source in sources)
    squares_ = [tidy(expanded(sum(each**2 for each in source.value))) for source in sources]
    if any(scene.model.identically_zero(each) for each in squares_):
        raise NotPlannedError("an angle to what is at rest")
    above = total((product(a, c), product(b, d)))
    sizes = [
        Apply("sqrt", total(square(tree_of(each)) for each in source.value if each != 0))
        for source in sources
    ]
    dot = sum(x * y for x, y in zip(sources[0].value, sources[1].value, strict=True))
    value = tidy(expanded(dot) / tidy(sp.sqrt(squares_[0])) / tidy(sp.sqrt(squares_[1])))
    bodies = tuple(dict.fromkeys(body for body, _ in pair))
    move = Move("define", "scalar-angle", max(stage for _, stage in pair) or None, bodies)
    refs = together(*(each.whole for each in sources))
    right = Binary("/", above, product(*sizes))
    return Formula(move, cosine, quantity, right, value, refs)


def cosine(tree: Expression) -> Expression:
    """The cosine of an angle."""
    return Apply("cos", tree)


def _as_a_line(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector; where it is put together of components, by a line of its own."""
    source = velocity_source(scene, body, stage)
    if stage not in scene.model.frames or len(source.refs) == 1:
        return source
    number_ = write_formula(scene, formula(scene, Quantity("velocity", (Name(body),), stage)))
    return Source(source.value, (number_,))


def _product(scene: Scene, quantity: Quantity) -> Formula:
    """The scalar product of two vectors, each as a line has it."""
    refs: list[Ref] = []
    vectors: list[Vector] = []
    bodies: list[str] = []
    late = 0
    for argument in quantity.arguments:
        for node in walk(argument):
            match node:
                case Quantity("velocity", (Name(body),), int(stage)):
                    last = scene.last_event(body, stage)
                    refs += _as_a_line(scene, body, last).refs
                    bodies.append(body)
                    late = max(late, last)
                case Quantity("line_of_centres", (), int(number_)):
                    refs += scene.frame(number_).refs
                case Quantity() | Letter():
                    raise NotPlannedError("a scalar product of other vectors")
        put, _ = scene.put(scene.vector(argument))
        vectors.append(Vector(*(tidy(expanded(each)) for each in put)))
    if not refs:
        raise NotPlannedError("a scalar product of data")
    (a, b), (c, d) = ([tree_of(each) for each in own] for own in vectors)
    value = tidy(expanded(sum(x * y for x, y in zip(*vectors, strict=True))))
    move = Move("define", "product", late or None, tuple(dict.fromkeys(bodies)))
    right = total((product(a, c), product(b, d)))
    return Formula(move, _itself, quantity, right, value, together(refs))


def _to_the_line(
    scene: Scene, along: Source, across: Source, other: Source
) -> tuple[Expression, sp.Expr]:
    """The tangent of the angle to a velocity along the line of centres, of which the size cancels.

    ``other`` is that velocity; of its component no more than the sign is needed.
    """
    side = scene.model.sign(across.value)
    sense = scene.model.sign(scene.model.in_data(other.value))
    if not side or not sense or not _of_one_sign(scene, across.value):
        raise NotPlannedError("to which side a sphere turns is open")
    trees = [
        negative(tree_of(each.value)) if sign < 0 else tree_of(each.value)
        for each, sign in ((across, side), (along, sense))
    ]
    return Binary("/", *trees), tidy(side * sense * across.value / along.value)


def _of_one_sign(scene: Scene, value: sp.Expr) -> bool:
    """Whether a component has one sign, or is 0 at most at an end, for all admissible letters."""
    return scene.model.proved_sign(value) is not None or bool(
        scene.model.decide(scene.model.sign(value) * scene.model.in_data(value), ">=", 0)
    )


def _angle_to_unit(scene: Scene, quantity: Quantity, body: str, stage: int, line: Unit) -> Formula:
    """The angle to **i** or **j**, of up to 180°: what stands above is taken positive."""
    x, y = in_the_plane(scene, body, stage)
    above, below = (y, x) if line.axis == "i" else (x, y)
    if scene.model.identically_zero(below.value):
        raise NotPlannedError("a right angle")
    if scene.model.identically_zero(above.value):
        # Of 0° and 180°, which have one tangent, the scalar product tells which it is.
        own, sense = _as_a_line(scene, body, stage), sp.Integer(scene.model.sign(below.value))
        move = Move("define", "scalar-angle", stage or None, (body,))
        return Formula(move, cosine, quantity, tree_of(sense), sense, own.whole)
    size = -above.value if scene.model.sign(above.value) < 0 else above.value
    return Formula(
        Move("define", "tan", stage or None, (body,)),
        tangent,
        quantity,
        Binary("/", tree_of(size), tree_of(below.value)),
        tidy(size / below.value),
        together(above.whole, below.whole),
    )


def in_the_plane(scene: Scene, body: str, stage: int) -> tuple[Source, Source]:
    """The components of a velocity in the directions of **i** and **j**."""
    if stage and stage not in scene.model.frames:
        struck = velocity_source(scene, body, stage)
        return Source(struck.value.x, struck.refs), Source(struck.value.y, struck.refs)
    frame = frame_after(scene, body, stage)
    if frame.across is None and frame.n.x != 0 and frame.n.y != 0:
        vector = scene.desk.known(Quantity("velocity", (Name(body),), stage))
        if vector is not None and scene.desk.known(frame.component("across", body, stage)) is None:
            own, refs = scene.put(vector.value)
            return Source(own.x, together(vector.refs, refs)), Source(
                own.y, together(vector.refs, refs)
            )
        along, across = parts(scene, body, stage, frame)
        whole = (
            Source(
                Vector(*map(tidy, frame.n * along.value)),
                together(along.refs, across.refs, frame.unit_free),
            )
            if across.value == 0
            else velocity_source(scene, body, stage)
        )
        return Source(whole.value.x, whole.refs), Source(whole.value.y, whole.refs)
    along, across = parts(scene, body, stage, frame)
    first, second = (along, across) if frame.n.x != 0 else (across, along)
    signs = (frame.n.x + frame.t.x, frame.n.y + frame.t.y)
    # A component that is named by the line of centres needs it; one of a vector does not.
    plane = {id(along): isinstance(frame.along, Quantity), id(across): frame.across is None}
    x, y = (
        Source(
            tidy(sign * each.value),
            each.refs,
            frame.refs if plane[id(each)] and not each.axis else (),
        )
        for sign, each in zip(signs, (first, second), strict=True)
    )
    return x, y


def _direction(scene: Scene, quantity: Quantity) -> Formula:
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
            plain = all(each.is_number for each in frame_.n)
            other = "along" if kind == "across" else "across"
            whole = () if plain else after(scene, other, body, frame).refs
            return together(own.refs, whole, frame.refs)
    return ()


# --- impulses and energies ---------------------------------------------------------------------


def _impulse(scene: Scene, quantity: Quantity) -> Formula:
    event = quantity.stage
    assert isinstance(event, int)
    if quantity.arguments:
        return _impulse_vector(scene, quantity, event)
    if event not in scene.model.frames:
        return _size_of_blow(scene, quantity, event)
    whole = _size_of_impulse(scene, quantity, event)
    if whole is not None:
        return whole
    frame = scene.frame(event)
    spheres = scene.spheres(event)
    body = spheres[0]
    for sphere in spheres[1:]:
        if in_direction(scene, "along", sphere, event - 1, frame).value == 0:
            body = sphere
    if scene.unknown(scene.mass(body).value):
        # A mass that is known leaves one unknown less.
        body = next((own for own in spheres if not scene.unknown(scene.mass(own).value)), body)
    closed = [sphere for sphere in spheres if not _is_open(scene, sphere, event)]
    if closed and body not in closed:
        body = closed[0]
    return impulse_on(scene, quantity, body, event)


def impulse_on(scene: Scene, quantity: Quantity, body: str, event: int) -> Formula:
    """The size of an impulse, as the change of momentum of one of the bodies."""
    frame = scene.frame(event)
    early, late = (in_direction(scene, "along", body, k, frame) for k in (event - 1, event))
    change = late.value - early.value
    mass = scene.mass(body)
    first, last = tree_of(early.value), tree_of(late.value)
    if scene.model.sign(change) < 0:
        first, last, change = last, first, -change
    # At a wall the two point opposite ways: sizes are added.
    walled = frame.wall is not None
    change_tree = total((last, negative(first))) if walled else difference(last, first)
    return Formula(
        Move("law", "impulse", event, (body,)),
        _itself,
        quantity,
        product(tree_of(mass.value), change_tree),
        tidy(mass.value * change),
        together(mass.refs, early.whole, late.whole, frame.names_axis("along")),
    )


def _is_open(scene: Scene, body: str, event: int) -> bool:
    """Whether the component along the line of centres after an impact is not known yet."""
    component = scene.model.components.get((event, body))
    return component is not None and bool(scene.unknown(component.symbol))


def _size_of_impulse(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """The size of an impulse of which a line tells both components."""
    for body in scene.spheres(event):
        known = scene.desk.known(Quantity("impulse", (Name(body),), event))
        if known is None or not isinstance(known.value, Vector) or 0 in tuple(known.value):
            continue
        if not any(sp.sympify(each, strict=True).free_symbols for each in known.value):
            return _size(Move("define", "size", event, (body,)), quantity, known)
    return None


def _size_of_blow(scene: Scene, quantity: Quantity, event: int) -> Formula:
    """The size of a blow that is given as a vector."""
    blow = scene.data(f"impulse {event}")
    if not isinstance(blow.value, Vector):
        raise NotPlannedError("the size of a blow")
    return _size(Move("define", "size", event, scene.bodies(event)), quantity, blow)


def _size(move: Move, quantity: Quantity, vector: Source) -> Formula:
    """The size of a vector by its components."""
    tree = Apply("sqrt", total(square(tree_of(each)) for each in vector.value if each != 0))
    value = tidy(sp.sqrt(tidy(expanded(vector.value.dot(vector.value)))))
    return Formula(move, _itself, quantity, tree, value, vector.refs)


def _impulse_vector(scene: Scene, quantity: Quantity, event: int) -> Formula:
    (name,) = quantity.arguments
    assert isinstance(name, Name)
    body = name.name
    mass = scene.mass(body)
    late, early = (velocity_source(scene, body, stage) for stage in (event, event - 1))
    change = Binary("-", tree_of(late.value), tree_of(early.value))
    value = Vector(*(tidy(mass.value * each) for each in late.value - early.value))
    return Formula(
        Move("law", "impulse-vector", event, (body,)),
        _itself,
        quantity,
        product(tree_of(mass.value), change),
        value,
        together(mass.refs, late.refs, early.refs),
    )


def velocity_source(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector, from the data or from a line."""
    last = scene.last_event(body, stage)
    quantity = Quantity("velocity", (Name(body),), last)
    known = scene.desk.known(quantity)
    if known is not None:
        value, more = scene.put(known.value)
        return Source(value, together(known.refs, more))
    if last == 0:
        source = scene.initial(body)
        value, refs = scene.put(source.value)
        return Source(value, together(source.refs, refs))
    given = velocity_given(scene, body, last)
    if given is not None:
        return Source(given[1], given[2])
    if last not in scene.model.frames:
        return blown(scene, body, last)
    own = _velocity(scene, quantity)
    if scene.frame(last).is_slanted:
        # What is put together of slanting components has a line of its own.
        return Source(own.value, (write_formula(scene, own),))
    return Source(own.value, own.refs)


def _half(mass: Expression, squares: Expression) -> Expression:
    """Half of a mass times squares of speeds, in this order: ½ × 2(3² − 1²)."""
    if is_zero(squares):
        return squares
    if isinstance(squares, Negate):
        return Negate(_half(mass, squares.operand))
    factor: Expression = Binary("/", number(1), number(2))
    if mass != number(1):
        factor = Binary("*", factor, mass)
    return Binary("*", factor, squares)


def _energy(scene: Scene, quantity: Quantity) -> Formula:
    assert isinstance(quantity.stage, int)
    names = [argument.name for argument in quantity.arguments if isinstance(argument, Name)]
    bodies = names or list(scene.model.story.spheres)
    terms, values, refs = [], [], []
    for body in bodies:
        stage = scene.last_event(body, quantity.stage)
        tree, value, own = squares(scene, body, stage, known=len(bodies) == 1)
        if stage and stage != quantity.stage:
            own = together(own, scene.frame(stage).unit_free)
        mass = scene.mass(body)
        terms.append(_half(tree_of(mass.value), tree))
        values.append(mass.value * value / 2)
        refs += [*(() if value == 0 else mass.refs), *own]
    move = Move("define", "energy" if names else "total", quantity.stage or None, tuple(names))
    return Formula(
        move, _itself, quantity, total(terms), tidy(expanded(sum(values))), together(refs)
    )


def _energy_lost(scene: Scene, quantity: Quantity) -> Formula:
    """Components across the line do not change, so that they cancel."""
    event = quantity.stage
    assert isinstance(event, int)
    by_speeds = _lost_by_given_speeds(scene, quantity, event)
    if by_speeds is not None:
        return by_speeds
    frame = scene.frame(event)
    terms: list[Expression] = []
    values: list[Any] = []
    refs: list[Any] = [*frame.names_axis("along")]
    for body in scene.spheres(event):
        early, late = (in_direction(scene, "along", body, k, frame) for k in (event - 1, event))
        mass = scene.mass(body)
        squared = [square(tree_of(each.value)) for each in (early, late)]
        change = difference(*squared)
        terms.append(_half(tree_of(mass.value), change))
        values.append(mass.value * (early.value**2 - late.value**2) / 2)
        own = () if values[-1] == 0 else mass.refs
        refs += [*own, *early.whole, *late.whole]
    return Formula(
        Move("define", "energy-lost", event, scene.spheres(event)),
        _itself,
        quantity,
        total(terms),
        tidy(expanded(sum(values))),
        together(refs),
    )


def energy_change(scene: Scene, asked: Expression) -> Formula | None:
    """The change of the energy of one body at an impact, by the component that changes.

    None of another difference, and where one of the two energies is a line, or is asked too.
    """
    match asked:
        case Binary(
            "-",
            Quantity("energy", (Name(body),), int(late)) as first,
            Quantity("energy", (Name(other),), int(early)) as second,
        ) if body == other:
            pass
        case _:
            return None
    event = scene.last_event(body, max(late, early))
    frame = scene.frame(event) if event in scene.model.frames else None
    if frame is None or scene.last_event(body, event - 1) != scene.last_event(
        body, min(late, early)
    ):
        return None
    if any(
        scene.desk.known(each) is not None or each in scene.asked_alone for each in (first, second)
    ):
        return None
    ends = [in_direction(scene, "along", body, k, frame) for k in (event, event - 1)]
    ends = ends if late > early else ends[::-1]
    mass = scene.mass(body)
    squared = difference(*(square(tree_of(end.value)) for end in ends))
    value = mass.value * (ends[0].value ** 2 - ends[1].value ** 2) / 2
    refs = together(frame.names_axis("along"), mass.refs, *(end.whole for end in ends))
    move = Move("define", "energy-change", event, (body,))
    right = _half(tree_of(mass.value), squared)
    return Formula(move, _itself, asked, right, tidy(expanded(value)), refs)


def _lost_by_given_speeds(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """Where every speed is given, before and after: ½mu² − ½mv²; None otherwise."""
    terms: list[Expression] = []
    values: list[Any] = []
    refs: list[Any] = []
    for body in scene.spheres(event):
        mass = scene.mass(body)
        early, late = (_given_speed(scene, body, k) for k in (event - 1, event))
        if early is None or late is None:
            return None
        halves = [_half(tree_of(mass.value), square(tree_of(e.value))) for e in (early, late)]
        terms.append(difference(*halves))
        values.append(mass.value * (early.value**2 - late.value**2) / 2)
        refs += [*mass.refs, *early.refs, *late.refs]
    move = Move("define", "energy-lost", event, scene.spheres(event))
    value = tidy(expanded(sum(values)))
    return Formula(move, _itself, quantity, total(terms), value, together(refs))


def _given_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that the data give, with a direction at an angle or as a fact about the motion."""
    last = scene.last_event(body, stage)
    size: Any = None
    refs: tuple[Ref, ...] = ()
    if not last and (fact := scene.facts.get(f"velocity {body}")) is not None:
        match fact.relation.only[0].right:
            case Polar(size) if not isinstance(size, Unit):
                refs = (fact.id,)
    for each in scene.given if last else ():
        if each.link.left == Quantity("speed", (Name(body),), last) and each.link.sign == "=":
            size, refs = each.link.right, each.refs
    if size is None or has_quantity(size):
        return None
    value, more = scene.put(scene.scalar(size))
    return None if scene.unknown(value) else Source(value, together(refs, more))


def _total_energy_lost(scene: Scene, quantity: Quantity) -> Formula:
    """The energy of all spheres at the start, less that after an event: each a line before it."""
    assert isinstance(quantity.stage, int)
    if quantity.stage == 1 and 1 in scene.model.frames:
        own = _energy_lost(scene, Quantity("energy_lost", (), 1))
        return replace(own, quantity=quantity, move=Move("define", "total-lost", 1))
    terms, values, refs = [], [], []
    for stage in (0, quantity.stage):
        own = _energy(scene, Quantity("energy", (), stage))
        number = write_formula(scene, own)
        terms.append(tree_of(own.value))
        values.append(own.value)
        refs.append(number)
    return Formula(
        Move("define", "total-lost", quantity.stage),
        _itself,
        quantity,
        difference(*terms),
        tidy(expanded(values[0] - values[1])),
        together(refs),
    )


def _momentum(scene: Scene, quantity: Quantity) -> Formula:
    """The momentum of a sphere, by its velocity as a vector."""
    if not quantity.arguments:
        return _momentum_of_all(scene, quantity)
    (name,) = quantity.arguments
    assert isinstance(name, Name)
    assert isinstance(quantity.stage, int)
    velocity = velocity_source(scene, name.name, quantity.stage)
    mass = scene.mass(name.name)
    return Formula(
        Move("define", "momentum-of", quantity.stage or None, (name.name,)),
        _itself,
        quantity,
        product(tree_of(mass.value), tree_of(velocity.value)),
        Vector(*(tidy(mass.value * each) for each in velocity.value)),
        together(mass.refs, velocity.refs),
    )


def _momentum_of_all(scene: Scene, quantity: Quantity) -> Formula:
    """The momentum of all spheres, by their velocities as vectors."""
    stage = quantity.stage
    assert isinstance(stage, int)
    terms: list[Expression] = []
    refs: list[Ref] = []
    x = y = sp.Integer(0)
    for body in scene.model.story.spheres:
        velocity = _as_a_line(scene, body, scene.last_event(body, stage))
        refs += velocity.refs
        if all(each == 0 for each in velocity.value):
            continue
        mass = scene.mass(body)
        refs += mass.refs
        terms.append(product(tree_of(mass.value), tree_of(velocity.value)))
        x, y = (a + mass.value * b for a, b in zip((x, y), velocity.value, strict=True))
    whole = Vector(*(tidy(expanded(each)) for each in (x, y)))
    move = Move("define", "momentum-of", stage or None, ())
    return Formula(move, _itself, quantity, total(terms), whole, together(refs))


def _deflection(scene: Scene, quantity: Quantity) -> Formula:
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
    trees = [tree_of(each.value) for each in (c, s, d, t)]
    above = [product(trees[0], trees[3]), product(trees[1], trees[2])]
    if scene.model.sign(cross) < 0:
        above, cross = above[::-1], -cross
    below = total((product(trees[0], trees[2]), product(trees[1], trees[3])))
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    return Formula(
        Move("define", "tan-deflection", event, (body,)),
        tangent,
        quantity,
        Binary("/", difference(*above), below),
        tidy(cross / dot),
        together(*(each.whole for each in (*early, *late)), names),
    )


_FORMULAS: Mapping[str, Callable[[Scene, Quantity], Formula]] = {
    "velocity": _velocity,
    "speed": _speed,
    "along": _component,
    "across": _component,
    "angle": _angle,
    "direction": _direction,
    "deflection": _deflection,
    "impulse": _impulse,
    "energy": _energy,
    "energy_lost": _energy_lost,
    "total_energy_lost": _total_energy_lost,
    "momentum": _momentum,
    "dot": _product,
}


# --- lines ---------------------------------------------------------------------------------------


# A speed from components with roots is a line that people write; deeper roots are not.
_MOST_ROOTS = 2


def write_formula(scene: Scene, own: Formula) -> int:
    """A quantity by its definition, and what that comes to."""
    final = tree_of(own.value)
    right = swept(own.right)
    if _depth_of_roots(right) > _MOST_ROOTS:
        raise NotPlannedError("a root of sums of roots")
    if isinstance(own.value, Vector):
        number = scene.desk.write(own.move, own.refs, chain(own.left, (right, None)))
        if right != final:
            link = chain(own.left, (final, None))
            move = Move("rearrange")
            pythagoras = Move("identity", "pythagoras")
            ratios = any(sp.sympify(each, strict=True).atoms(sp.sin, sp.cos) for each in own.value)
            if ratios and not scene.judge.follows(move, (number,), link):
                move = pythagoras if scene.judge.follows(pythagoras, (number,), link) else move
            number = scene.desk.write(move, (number,), link)
    else:
        refs = own.refs
        if isinstance(right, Apply) and right.function == "sqrt":
            refs = together(
                refs, not_negative(scene, own.value), sign_known(scene, _before_root(own.value))
            )
        if _trivial(own.right, final):
            right = final
        elif _is_figure(own.value) and isinstance(right, Apply):
            final = right  # what follows is its decimal: no other form of it is plainer
        by: MoveId = "identity" if _by_pythagoras(scene, own) else "rearrange"
        relation = chain(own.left, (right, None), (final, by))
        if _has_roots_of_letters(own.right):
            known = background(scene, letters(right))
            refs = scene.judge.enough(own.move, refs, relation, known) or refs
        number = scene.desk.write(own.move, refs, relation)
    scene.desk.know(own.quantity, own.value, (number,))
    return number


def _has_roots_of_letters(tree: Expression) -> bool:
    """Whether a root of letters stands in it, below the root of the whole if it is one."""
    inside = tree.argument if isinstance(tree, Apply) else tree
    return any(
        isinstance(node, Apply) and node.function == "sqrt" and letters(node.argument)
        for node in walk(inside)
    )


def _is_figure(value: Any) -> bool:
    """Whether a number is made of sines and cosines of degrees that have no exact values."""
    own = sp.sympify(value, strict=True)
    return bool(own.is_number and own.atoms(sp.sin, sp.cos, sp.tan))


def _trivial(right: Expression, final: Expression) -> bool:
    """Whether a root is that of one square."""
    match right:
        case Apply("sqrt", Binary("^", base, _)):
            return base == final
    return False


def _before_root(value: sp.Expr) -> sp.Expr:
    """The factors of a value that are not roots."""
    return sp.Mul(
        *(
            factor
            for factor in sp.Mul.make_args(value)
            if not (factor.is_Pow and factor.exp.is_Rational and factor.exp.q == 2)
        )
    )


def _by_pythagoras(scene: Scene, own: Formula) -> bool:
    """Whether a value comes of its formula by sin² + cos² = 1 alone."""
    value = sp.sympify(own.value, strict=True)
    try:
        right = scene.scalar(own.right)
    except StatementError:
        return False
    ratios = right.atoms(sp.sin, sp.cos) | value.atoms(sp.sin, sp.cos, sp.tan)
    angles = {ratio.args[0] for ratio in ratios}
    if len(ratios) == len(angles):
        return False
    put: dict[sp.Basic, sp.Expr] = {}
    for angle in angles:
        s, c = sp.Dummy("s", positive=True), sp.Dummy("c", positive=True)
        put |= {sp.sin(angle): s, sp.cos(angle): c, sp.tan(angle): s / c}
    gap = right.xreplace(put) ** 2 - value.xreplace(put) ** 2
    return bool(expanded(sp.fraction(one_fraction(expanded(gap)))[0]) != 0)


def _depth_of_roots(tree: Expression) -> int:
    """How many roots stand in one another in a tree."""
    below = max(map(_depth_of_roots, children(tree)), default=0)
    return below + (isinstance(tree, Apply) and tree.function == "sqrt")
