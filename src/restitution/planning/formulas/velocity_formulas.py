"""Velocities, speeds and components, by their definitions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from restitution.components.telling import without_bars
from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged, trees_of
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.formulas.assembling import put_together
from restitution.planning.formulas.changed_velocities import by_change_along
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.impacts import blown, in_direction
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.formulas.speeds_of_one_component import (
    is_in_a_sum,
    is_squared,
    of_given_sign,
    of_one_component,
    root_of_one_square,
)
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    difference,
    is_in_degrees,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


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
    return [in_direction(scene, kind, body, stage, own) for kind in COMPONENTS]


def _velocity_at_the_start(scene: Scene, quantity: Quantity, body: str) -> Formula:
    """The velocity of the data, with the letters put in that have been found."""
    source = scene.initial(body)
    value, refs = scene.put(source.value)
    fact = scene.facts.get(f"velocity {body}")
    if not refs and not (fact is not None and isinstance(fact.relation.only[0].right, Polar)):
        raise NotPlannedError("a velocity that is given")
    whole = Vector(*(tidy(component) for component in value))
    own = Quantity(quantity.kind, quantity.arguments, 0)
    move = Move("define", "assemble", None, (body,))
    if fact is not None:
        move = Move("put") if refs else Move("rearrange")
    return Formula(move, itself, own, tree_of(whole), whole, together(source.refs, refs))


def _once_more(scene: Scene, quantity: Quantity, body: str, stage: int, known: Source) -> Formula:
    """A velocity that is a line already, perhaps in letters that are known by now."""
    value, refs = scene.put(known.value)
    own = Quantity(quantity.kind, quantity.arguments, stage)
    whole = Vector(*(tidy(component) for component in value))
    move = Move("put") if refs else Move("rearrange")
    # What is put in comes after the line into which it is.
    lines = sorted(known.refs, key=lambda ref: isinstance(ref, str))
    premises = tuple(dict.fromkeys((*lines, *refs)))
    return Formula(move, itself, own, tree_of(whole), whole, premises)


def velocity_formula(scene: Scene, quantity: Quantity) -> Formula:
    """A velocity as a vector, of its components."""
    body, stage = body_and_stage(scene, quantity)
    if not stage:
        return _velocity_at_the_start(scene, quantity, body)
    known = scene.desk.known(Quantity("velocity", (Name(body),), stage))
    if stage not in scene.model.frames and known is None:
        known = blown(scene, body, stage)
    if known is not None:
        return _once_more(scene, quantity, body, stage, known)
    frame = frame_after(scene, body, stage)
    changed = by_change_along(scene, body, stage, frame)
    if changed is not None:
        return replace(changed, quantity=quantity)
    along, across = parts(scene, body, stage, frame)
    return replace(put_together(body, stage, frame, (along, across)), quantity=quantity)


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
        alone = sum(other != 0 for other in value) == 1
        tree = total(
            square(_with_numbers(scene, own) if alone and own != other else tree_of(other))
            for own, other in zip(struck.value, value, strict=True)
            if other != 0
        )
        return tree, sum(other**2 for other in value), together(struck.refs, more)
    frame = frame_after(scene, body, stage)
    own = parts(scene, body, stage, frame)
    if known and (shown := shown_square(scene, body, stage)) is not None:
        return tree_of(shown.value), shown.value, shown.refs
    speed = known_speed(scene, body, stage) if known else None
    if known and speed is None:
        speed = _speed_by_a_multiple(scene, body, stage)
    if speed is not None and _is_plain(scene, speed, own):
        squared = tidy(speed.value**2)
        tree = square(tree_of(speed.value))
        return tree_of(squared) if is_root_of_a_sum(speed.value) else tree, squared, speed.refs
    refs = together(*(source.refs for source in own), _bridge(frame, own))
    tree = total(square(tree_of(source.value)) for source in own if source.value != 0)
    return tree, sum(source.value**2 for source in own), refs


def _with_numbers(scene: Scene, component: sp.Expr) -> Expression:
    """A component with the numbers for its letters, not worked out: (1 + 6 × ⅔)u."""
    tree = tree_of(component)
    known = {name: scene.desk.known(Letter(name)) for name in letters(tree)}
    put: dict[Expression, Expression] = {
        Letter(name): tree_of(own.value)
        for name, own in known.items()
        if own is not None and own.value.is_number
    }
    return exchanged(tree, put) if put else tree_of(scene.put(component)[0])


def shown_square(scene: Scene, body: str, stage: int) -> Source | None:
    """The square of a speed that has been shown; None without such a line."""
    known = scene.desk.known(square(Quantity("speed", (Name(body),), stage)))
    if known is None:
        return None
    value, refs = scene.put(known.value)
    return Source(tidy(value), together(known.refs, refs))


def _is_plain(scene: Scene, speed: Source, components: Iterable[Source]) -> bool:
    """Whether a speed is known, or its square has no root of what is open.

    A root of a sum of ratios of angles such as 37° is longer than the components themselves.
    """
    if not any(scene.unknown(component.value) for component in components):
        roots = sp.sympify(speed.value, strict=True).atoms(sp.Pow)
        ratios = (
            ratio
            for root in roots
            if root.base.is_Add
            for ratio in root.base.atoms(sp.sin, sp.cos, sp.tan)
        )
        return all(ratio.free_symbols for ratio in ratios)
    if any(_is_of_the_motion(scene, ref) for ref in scene.desk.under(*speed.refs)):
        return False  # the fact that gives the speed is still to tell the components
    squared = sp.sympify(tidy(speed.value**2), strict=True)
    return all(power.exp.is_Integer or not power.free_symbols for power in squared.atoms(sp.Pow))


def _is_of_the_motion(scene: Scene, ref: Ref) -> bool:
    """Whether a premise is a given fact about the motion, and not about letters alone."""
    fact = scene.facts.get(ref) if isinstance(ref, str) and ref.startswith("given ") else None
    return fact is not None and any(map(has_quantity, trees_of(fact.relation)))


def is_root_of_a_sum(value: object) -> bool:
    """Whether a speed is the root of a sum in which letters stand."""
    roots = sp.sympify(value, strict=True).atoms(sp.Pow)
    return any(root.exp == sp.S.Half and root.base.is_Add and root.free_symbols for root in roots)


def _speed_by_a_multiple(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed by a line that has its velocity as a multiple of that at the start: **v** = −e**u**.

    Its line is written. None without one, and where the size of the first is not given.
    """
    velocity = Quantity("velocity", (Name(body),), stage)
    fact = scene.facts.get(f"velocity {body}")
    match fact and fact.relation.only[0].right:
        case Polar(Letter() | Number() as size):
            pass
        case _:
            return None
    for line in reversed(scene.desk.lines):
        if not isinstance(line.relation, Relation) or len(line.relation.options) > 1:
            continue
        match scene.desk.last_link(line.number):
            case Link(left, "=", Negate(Binary("*", factor, Quantity() as other))) | Link(
                left, "=", Binary("*", factor, Quantity() as other)
            ) if left == velocity and other == replace(velocity, stage=0):
                pass
            case _:
                continue
        if not scene.desk.holds(line.number):
            continue
        own, value = replace(velocity, kind="speed"), tidy(scene.scalar(product(factor, size)))
        move, pool = Move("define", "speed", stage, (body,)), (line.number, f"velocity {body}")
        relation = chain(own, (tree_of(value), None))
        known = background(scene, letters(factor))
        refs = scene.judge.enough(move, pool, relation, known)
        if refs is not None:
            return scene.desk.know(own, value, (scene.desk.write(move, refs, relation),))
    return None


def known_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that is given, or a line already; None where it is neither."""
    quantity = Quantity("speed", (Name(body),), stage)
    known = scene.desk.known(quantity)
    if known is not None:
        value, refs = scene.put(known.value)
        return Source(value, together(known.refs, refs))
    for equation in scene.given:
        if equation.link.sign == "=" and equation.link.left == quantity:
            if has_quantity(equation.link.right):
                continue
            value, refs = scene.put(scene.scalar(equation.link.right))
            return Source(value, together((equation.fact.id,), refs))
    return None


def size_that_stands(scene: Scene, body: str, stage: int) -> Expression | None:
    """The size of a velocity that a line or the question gives; None of a sum, or a long root."""
    if scene.last_event(body, stage):
        known = known_speed(scene, body, stage)
        size = known.value if known is not None else None
    else:
        fact = scene.facts.get(f"velocity {body}")
        given = fact.relation.only[0].right if fact is not None else None
        size = scene.put(scene.scalar(given.size))[0] if isinstance(given, Polar) else None
    value = sp.sympify(size or 0, strict=True)
    long = any(root.base.is_Integer and root.base >= 10000 for root in value.atoms(sp.Pow))
    return None if size is None or long or value.has(sp.Add, sp.Abs) else tree_of(size)


def _bridge(frame: Frame, components: Iterable[Source]) -> tuple[Ref, ...]:
    """The axis, where one component is named by it and the other by **i** or **j**."""
    mixed = isinstance(frame.along, Quantity) and frame.across is not None
    return frame.refs if mixed and not any(component.axis for component in components) else ()


def _initial_square(scene: Scene, body: str) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The square of the speed at the start, by its size or by its components."""
    fact = f"velocity {body}"
    if fact not in scene.facts and (pair := _start_at_a_wall(scene, body)) is not None:
        tree = total(square(tree_of(source.value)) for source in pair)
        refs = together(*(source.refs for source in pair))
        return tree, sum(source.value**2 for source in pair), refs
    initial = scene.initial(body)
    if fact not in scene.facts:
        value, refs = scene.put(initial.value)
        tree = total(square(tree_of(other)) for other in value if other != 0)
        return tree, sum(other**2 for other in value), together(initial.refs, refs)
    (link,) = scene.facts[fact].relation.only
    if isinstance(link.right, Polar):
        size, refs = scene.put(scene.scalar(link.right.size))
        return square(tree_of(size)), size**2, together((fact,), refs)
    value, refs = scene.put(initial.value)
    tree = total(square(tree_of(other)) for other in value if other != 0)
    return tree, sum(other**2 for other in value), together((fact,), refs)


def _start_at_a_wall(scene: Scene, body: str) -> tuple[Source, Source] | None:
    """The components of a velocity of which nothing is told, at the first wall, as lines of it."""
    number = next((n for n in sorted(scene.model.frames) if body in scene.bodies(n)), None)
    if number is None or scene.model.frames[number].wall is None:
        return None
    frame = scene.frame(number)
    along, across = (scene.desk.known(frame.component(kind, body, 0)) for kind in COMPONENTS)
    if along is None or across is None or not all((along.value, across.value)):
        return None
    if any(scene.unknown(source.value) for source in (along, across)):
        return None
    return along, across


def speed_formula(scene: Scene, quantity: Quantity) -> Formula:
    """A speed, by Pythagoras."""
    body, stage = body_and_stage(scene, quantity)
    move = Move("define", "speed", stage or None, (body,))
    by_angle = _by_its_angle(scene, body, stage)
    if by_angle is not None:
        right, size, refs = by_angle
        needed = scene.judge.needed(move, refs, chain(quantity, (right, None)), refs[:1])
        if needed is not None:
            return Formula(move, itself, quantity, right, size, needed)
    tree, value, refs = squares(scene, body, stage)
    size = root_of_one_square(scene, tree) or tidy(sp.sqrt(tidy(expanded(value))))
    if len({atom.args for atom in atoms_in(value, sp.sin, sp.cos)}) > 1:
        # Products of ratios of several angles are longer multiplied out.
        size = min(size, _with_factor_outside(value), key=lambda value: value.count_ops())
    right = tree if value == 0 else Apply("sqrt", tree)
    match tree:
        case Binary("^", base, _) if base != tree_of(size) and scene.scalar(base) == size:
            right = base
        case Binary("^", base, _) if letters(base) and is_in_a_sum(scene, quantity):
            one = of_one_component(scene, move, quantity, base, refs)
            if one is not None:
                return Formula(move, itself, quantity, base, without_bars(scene.model, size), one)
        case Binary("^", base, _) if (
            signed := of_given_sign(scene, move, quantity, base, refs)
        ) is not None:
            return Formula(move, itself, quantity, *signed)
        case Binary("^", base, _) if size.has(sp.Abs) and not is_squared(scene, quantity):
            bars = Apply("abs", base)  # which way it goes is open
            if scene.judge.follows(move, refs, chain(quantity, (bars, None))):
                right = bars
    own = Formula(move, itself, quantity, right, without_bars(scene.model, size), refs)
    return _by_its_square(scene, own) or own


def _by_its_square(scene: Scene, own: Formula) -> Formula | None:
    """A speed by a line that gives its square; None where there is none."""
    subject, final = square(own.quantity), tree_of(own.value)
    relation = chain(own.quantity, (final, None))
    for line in scene.desk.lines:
        above = line.relation
        if not isinstance(above, Relation) or not scene.desk.holds(line.number):
            continue
        if len(above.options) > 1 or above.only[0].left != subject or above.only[0].sign != "=":
            continue
        known = scene.judge.known(letters(final))
        for move in (Move("rearrange"), Move("identity", "pythagoras")):
            refs = scene.judge.enough(move, (line.number,), relation, known)
            if refs is not None:
                return replace(own, move=move, right=final, refs=refs)
    return None


def squared_speed(scene: Scene, asked: Expression) -> Formula | None:
    """The square of a speed by its components, without its root.

    None of anything else, where the speed is known or asked by itself, or is no root of a sum.
    """
    match asked:
        case Binary("^", Quantity("speed", _, int()) as speed, Number(2)):
            pass
        case _:
            return None
    if speed in scene.asked_alone or known_speed(scene, *body_and_stage(scene, speed)):
        return None
    own = speed_formula(scene, speed)
    if not is_function(own.right, "sqrt"):
        return None
    value = tidy(expanded(scene.scalar(own.right.argument)))
    return replace(own, quantity=asked, right=own.right.argument, value=value)


def _by_its_angle(
    scene: Scene, body: str, stage: int
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]] | None:
    """A speed by one component and the angle of the velocity to a line, which is in degrees.

    It is given, or worked out and such that its ratios are no roots. Of the two components it is
    one that stands without anything put in. None without such an angle.
    """
    if stage not in scene.model.frames or scene.model.frames[stage].angle is not None:
        return None
    frame = scene.frame(stage)
    velocity = Quantity("velocity", (Name(body),), stage)
    centres = Quantity("angle", (velocity, Quantity("line_of_centres", (), stage)))
    lines: dict[Expression, tuple[str | None, str, tuple[Ref, ...]]] = {centres: ("sin", "cos", ())}
    if frame.wall is not None:
        lines[Quantity("angle", (velocity, Name(frame.wall)))] = ("cos", "sin", ())
    for other in scene.spheres(stage):
        own = [scene.desk.known(frame.component(k, other, stage)) for k in COMPONENTS]
        if other == body or own[0] is None or own[1] is None or own[1].value != 0:
            continue
        second = Quantity("velocity", (Name(other),), stage)
        for pair in ((velocity, second), (second, velocity)):
            refs = together(*(source.whole for source in own if source is not None))
            lines[Quantity("angle", pair)] = (None, "cos", refs)
    given = [
        (own.link.left, own.link.right, own.refs) for own in scene.given if own.link.sign == "="
    ]
    for angle, degrees, angle_refs in (*given, *_angles_worked_out(scene, lines)):
        line = lines.get(angle)
        if line is None or not isinstance(degrees, Degrees):
            continue
        across, along, more = line
        kinds = [(kind, own) for kind, own in (("across", across), ("along", along)) if own]
        stand = [kind for kind in kinds if _stands(scene, frame.component(kind[0], body, stage))]
        for kind, ratio in (stand or kinds)[:1]:
            known = in_direction(scene, kind, body, stage, frame)
            sign = scene.model.proved_sign(scene.model.in_data(known.value))
            if sign and not scene.unknown(known.value):
                size, below = tidy(sign * known.value), Apply(ratio, degrees)
                refs = together(angle_refs, known.whole, more, frame.refs)
                value = tidy(size / scene.scalar(below))
                return swept(Binary("/", tree_of(size), below)), value, refs
    return None


def _angles_worked_out(
    scene: Scene, angles: Iterable[Expression]
) -> Iterator[tuple[Expression, Expression, tuple[Ref, ...]]]:
    """The angles of which a line says how many degrees they are, such as have no exact ratios."""
    for angle in angles:
        known = letter_known(scene, angle) if isinstance(angle, Quantity) else None
        if known is None:
            continue
        name, introduced = known
        for line in scene.desk.lines:
            own = line.relation
            if not isinstance(own, Relation) or len(own.options) > 1:
                continue
            degrees = own.only[-1].right
            if own.only[0].left != Letter(name) or own.only[-1].sign != "=":
                continue
            if is_in_degrees(tidy(scene.scalar(Apply("cos", degrees)))) and scene.desk.holds(
                line.number
            ):
                yield angle, degrees, (introduced, line.number)


def _stands(scene: Scene, component: Quantity) -> bool:
    """Whether a component is known, and nothing has to be put in."""
    known = scene.desk.known(component)
    if known is None or scene.unknown(known.value):
        return False
    return not scene.put(known.value)[1]


def _with_factor_outside(square_: sp.Expr) -> sp.Expr:
    """The root of a sum of squares, with the positive letters outside that all of them have."""
    terms = sp.Add.make_args(square_)
    powers = [sp.Mul(*sp.Mul.make_args(term)).as_powers_dict() for term in terms]
    common = [s for s in powers[0] if s.is_Symbol and s.is_positive]
    shared = sp.Mul(*(s ** (min(power[s] for power in powers) // 2) for s in common))
    return shared * sp.sqrt(sp.Add(*(term / shared**2 for term in terms)))


def component_formula(scene: Scene, quantity: Quantity) -> Formula:
    """A component of a velocity, or of the momentum of a sphere, along a line or across it."""
    velocity, direction = quantity.arguments
    match velocity:
        case Quantity("momentum", (Name(of),), int(at)):
            return _component_of_momentum(scene, quantity, of, at)
        case Binary("+" | "-") as several:
            return _component_of_two(scene, quantity, several)
    body, stage = body_and_stage(scene, velocity)
    frame = frame_after(scene, body, stage)
    wanted = scene.model.story.direction(direction, scene.events)
    if quantity.kind == "across":
        wanted = wanted.turned_left()
    size = scene.model.story.size(wanted)
    unit = Vector(tidy(wanted.x / size), tidy(wanted.y / size))
    own = parts(scene, body, stage, frame)
    shares = [tidy(vector.dot(unit)) for vector in (frame.n, frame.t)]
    axis: tuple[Ref, ...] = ()
    if is_quantity(direction, "line_of_centres") and -1 in shares:
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
    itself_ = frame.component(quantity.kind, body, stage)
    named = itself_.arguments[-1] == direction and itself_.kind == quantity.kind and shares.count(0)
    unit_free = () if named else frame.unit_free
    refs = together(*(a.refs for a, _ in used), unit_free, walls, axis)
    return Formula(
        Move("define", "component", stage or None, (body,)), itself, quantity, right, value, refs
    )


def _component_of_two(scene: Scene, quantity: Quantity, several: Binary) -> Formula:
    """The sum or the difference of the components of two velocities."""
    one, other = (
        component_formula(scene, replace(quantity, arguments=(side, quantity.arguments[1])))
        for side in (several.left, several.right)
    )
    trees = tree_of(one.value), tree_of(other.value)
    sum_of_both = several.op == "+"
    right = swept(total(trees) if sum_of_both else difference(*trees))
    value = one.value + other.value if sum_of_both else one.value - other.value
    refs, move = together(one.refs, other.refs), Move("define", "component")
    # Who is at rest, or has its velocity among the data, rests on the line of centres as well.
    direction = quantity.arguments[1]
    axis = [f"axis {direction.stage}"] if is_quantity(direction, "line_of_centres") else []
    axis = [name for name in axis if name in scene.facts]
    needed = scene.judge.enough(move, refs, chain(quantity, (right, None)), axis)
    if needed is None:
        raise NotPlannedError("a component of two velocities")
    return Formula(move, itself, quantity, right, tidy(expanded(value)), needed)


def _component_of_momentum(scene: Scene, quantity: Quantity, body: str, stage: int) -> Formula:
    """The mass times the component of the velocity in that direction."""
    velocity = Quantity("velocity", (Name(body),), stage)
    own = component_formula(scene, replace(quantity, arguments=(velocity, quantity.arguments[1])))
    mass = scene.mass(body)
    move = Move("define", "momentum-of", stage or None, (body,))
    right = swept(product(tree_of(mass.value), tree_of(own.value)))
    refs = together(mass.refs, own.refs)
    # A component that is named by the line of centres does not need its direction.
    needed = scene.judge.needed(move, refs, chain(quantity, (right, None)), mass.refs)
    return Formula(move, itself, quantity, right, tidy(mass.value * own.value), needed or refs)


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
        whole = (
            None
            if _comes_by_its_change(scene, body, stage, frame)
            else _along_a_line(scene, body, stage, frame)
        )
        whole = whole or velocity_source(scene, body, stage)
        return Source(whole.value.x, whole.refs), Source(whole.value.y, whole.refs)
    along, across = parts(scene, body, stage, frame)
    first, second = (along, across) if frame.n.x != 0 else (across, along)
    signs = (frame.n.x + frame.t.x, frame.n.y + frame.t.y)
    # A component that is named by the line of centres needs it; one of a vector does not.
    plane = {id(along): isinstance(frame.along, Quantity), id(across): frame.across is None}
    x, y = (
        Source(
            tidy(sign * source.value),
            source.refs,
            frame.refs if plane[id(source)] and not source.axis else (),
        )
        for sign, source in zip(signs, (first, second), strict=True)
    )
    return x, y


def _comes_by_its_change(scene: Scene, body: str, stage: int, frame: Frame) -> bool:
    """Whether a velocity comes of its change along a slanting line, without the other component."""
    across = scene.model.in_data(scene.velocity(body, stage).dot(frame.t))
    if not scene.model.sign(across):
        return False
    return by_change_along(scene, body, stage, frame) is not None


def _along_a_line(scene: Scene, body: str, stage: int, frame: Frame) -> Source | None:
    """The velocity of who moves along a slanting line, as a multiple of its unit vector."""
    along, across = parts(scene, body, stage, frame)
    if across.value != 0:
        return None
    whole = Vector(*map(tidy, frame.n * along.value))
    return Source(whole, together(along.refs, across.refs, frame.unit_free))


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
    own = velocity_formula(scene, quantity)
    if scene.frame(last).is_slanted:
        # What is put together of slanting components has a line of its own.
        return Source(own.value, (write_formula(scene, own),))
    return Source(own.value, own.refs)
