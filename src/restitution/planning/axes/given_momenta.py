"""Momenta and impulses that are given as vectors: what they tell of velocities and masses."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, equality
from restitution.expression.tree import Apply, Binary, Expression, Name, Quantity
from restitution.planning.axes.momenta import velocity_as_vector
from restitution.planning.closing.pairs import close_two
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.impacts import before, closing_at_wall, in_direction
from restitution.planning.formulas.velocity_formulas import velocity_source
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import difference, product, square, swept, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import derivative, expanded
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


def take_momentum(scene: Scene, given: GivenEquation) -> bool:
    """What a momentum that is given as a vector tells: a velocity, or what is open in it.

    Nothing is written, and False returned, where it is no vector of what is known.
    """
    match given.link:
        case Link(Quantity("momentum", arguments, int(stage)), "=", right):
            value = scene.value(right)
        case _:
            return False
    if not isinstance(value, Vector) or any(scene.unknown(other) for other in value):
        return False
    if arguments:
        (body,) = arguments
        assert isinstance(body, Name)
        return _of_one(scene, given, body.name, stage, right, value)
    return _of_all(scene, given, stage, right)


def _of_one(
    scene: Scene, given: GivenEquation, body: str, stage: int, right: Expression, value: Vector
) -> bool:
    """The velocity of a sphere by its momentum."""
    mass, last = scene.mass(body), scene.last_event(body, stage)
    velocity = Quantity("velocity", (Name(body),), last)
    if scene.unknown(mass.value):
        return False
    move = Move("define", "momentum-of", stage or None, (body,))
    if not last:
        early = scene.initial(body)
        tree = swept(product(tree_of(mass.value), tree_of(early.value)))
        refs = together(given.refs, mass.refs, early.refs)
        _close_parts(scene, scene.desk.write(move, refs, chain(right, (tree, None))))
        return True
    tree = swept(product(tree_of(mass.value), velocity))
    refs = together(given.refs, mass.refs)
    match right:
        case Binary("+" | "-" as op, Quantity("momentum", (Name(),), 0), other):
            # A change of momentum.
            if scene.last_event(body, last - 1):
                return False
            early = scene.initial(body)
            right = other
            change: Expression = velocity
            if any(early.value):
                before_ = tree_of(early.value)
                change = (
                    difference(before_, velocity) if op == "-" else difference(velocity, before_)
                )
            tree = swept(product(tree_of(mass.value), change))
            refs = together(refs, early.refs)
    line = scene.desk.write(move, refs, equality(right, tree))
    late = Vector(*(tidy(component / mass.value) for component in value))
    line = scene.desk.write(Move("rearrange"), (line,), chain(velocity, (tree_of(late), None)))
    scene.desk.know(velocity, late, (line,))
    _close_across(scene, body, last)
    return True


def _close_across(scene: Scene, body: str, number: int) -> None:
    """A letter in the component that an impact does not change, by the velocity after it."""
    if number not in scene.model.frames:
        return
    frame = scene.frame(number)
    source = before(scene, "across", body, frame)
    open_ = scene.unknown(source.value)
    if len(open_) == 1:
        close(scene, closing_at_wall(scene, body, frame, "across"), next(iter(open_)))


def _of_all(scene: Scene, given: GivenEquation, stage: int, right: Expression) -> bool:
    """The momentum of all spheres at the start, which an impact of two does not change."""
    meeting = [n for n in range(1, stage + 1) if n in scene.model.frames]
    if stage > 1 or any(scene.model.frames[number].wall is not None for number in meeting):
        return False
    if stage and not meeting:
        return False
    refs, terms = list(given.refs), []
    for body in scene.model.story.spheres:
        source = scene.initial(body)
        if not any(source.value):
            refs += source.refs
            continue
        mass = scene.mass(body)
        refs += (*mass.refs, *source.refs)
        terms.append(product(tree_of(mass.value), tree_of(source.value)))
    bodies = scene.bodies(1) if stage else ()
    move = Move("law", "momentum-vector", 1, bodies) if stage else Move("define", "momentum-of")
    line = scene.desk.write(move, together(refs), chain(swept(total(terms)), (right, None)))
    _close_parts(scene, line)
    return True


def write_velocity_by_momentum(scene: Scene, number: int) -> bool:
    """Both letters in a velocity before or after an impact, where all else is known, by momentum.

    Nothing is written, and False returned, where the line of centres is along **i** or **j**, or a
    velocity is no vector.
    """
    own = scene.model.frames.get(number)
    if own is None or own.wall is not None or 0 in own.n:
        return False
    bodies = scene.bodies(number)
    masses = [scene.mass(body) for body in bodies]
    early = [_early_vector(scene, body, number) for body in bodies]
    late = [velocity_as_vector(scene, body, number) for body in bodies]
    vectors = [source.value for source in (*early, *late) if source is not None]
    open_ = [vector for vector in vectors if any(map(scene.unknown, vector))]
    if len(vectors) < len(early) + len(late) or len(open_) != 1:
        return False
    parts = [scene.unknown(component) for component in open_[0]]
    if len(parts[0] | parts[1]) != len(parts) or not all(len(part) == 1 for part in parts):
        return False
    if any(scene.unknown(mass.value) for mass in masses):
        return False
    refs: list[Ref] = [ref for mass in masses for ref in mass.refs]
    sides: list[Expression] = []
    values: list[Vector] = []
    for sources in (early, late):
        terms: list[Expression] = []
        whole = Vector(sp.Integer(0), sp.Integer(0))
        for mass, source in zip(masses, sources, strict=True):
            assert source is not None
            refs += source.refs
            whole += source.value * mass.value
            if any(source.value):
                terms.append(product(tree_of(mass.value), tree_of(source.value)))
        sides.append(swept(total(terms)))
        values.append(whole)
    move = Move("law", "momentum-vector", number, bodies)
    line = scene.desk.write(move, together(refs), chain(sides[0], (sides[1], None)))
    _close_parts(scene, line, values)
    return True


def _early_vector(scene: Scene, body: str, number: int) -> Source | None:
    """A velocity before an impact as a vector, in letters where nothing is said of it."""
    if f"velocity {body}" in scene.facts or scene.last_event(body, number - 1):
        return velocity_as_vector(scene, body, number - 1)
    return scene.initial(body)


def _close_parts(scene: Scene, line: int, values: Sequence[Vector] = ()) -> None:
    """What is open in an equation of vectors: from what stands with **i**, and with **j**.

    ``values`` are those of its sides, where letters in them stand for what is sought.
    """
    link = scene.desk.last_link(line)
    left, right = values or (scene.vector(side) for side in (link.left, link.right))
    open_: list[tuple[int, frozenset[sp.Symbol]]] = []
    for a, b in zip(left, right, strict=True):
        unknown = scene.unknown(expanded(a - b))
        if unknown:
            sides = (tree_of(expanded(value), as_it_is=True) for value in (a, b))
            first, second = sides
            number = scene.desk.write(Move("rearrange"), (line,), equality(first, second))
            open_.append((number, unknown))
    _close_all(scene, open_)


def _close_all(scene: Scene, open_: Sequence[tuple[int, frozenset[sp.Symbol]]]) -> None:
    """Solves some equations, those with one unknown first."""
    waiting = list(open_)
    while waiting:
        now = [(number, own) for number, own in waiting if len(_still_open(scene, own)) <= 1]
        if not now:
            break
        for number, own in now:
            waiting.remove((number, own))
            for symbol in _still_open(scene, own):
                close(scene, number, symbol)
    if not waiting:
        return
    unknowns = sorted({s for _, own in waiting for s in _still_open(scene, own)}, key=str)
    if len(waiting) != 2 or len(unknowns) != 2:
        raise NotPlannedError("an equation of vectors with several letters that are open")
    (first, _), (second, _) = waiting
    close_two(scene, (first, second), (unknowns[0], unknowns[1]))


def _still_open(scene: Scene, symbols: frozenset[sp.Symbol]) -> frozenset[sp.Symbol]:
    return frozenset(s for symbol in symbols for s in scene.unknown(symbol))


# --- masses by impulses ---------------------------------------------------------------------------


def take_mass(scene: Scene, given: GivenEquation) -> bool:
    """A mass that is open, by an impulse that is given and both velocities of the sphere."""
    match given.link:
        case Link(Quantity("impulse", (Name(body),), int(event)), "=", right):
            mass, value = scene.mass(body), scene.value(right)
        case _:
            return False
    open_ = scene.unknown(mass.value)
    if len(open_) != 1 or not isinstance(value, Vector):
        return False
    late = _late(scene, body, event)
    early = velocity_source(scene, body, event - 1)
    if late is None or any(scene.unknown(x) for source in (late, early) for x in source.value):
        return False
    change: Expression = tree_of(late.value)
    if any(early.value):
        change = Binary("-", change, tree_of(early.value))
    line = scene.desk.write(
        Move("law", "impulse-vector", event, (body,)),
        together(given.refs, mass.refs, early.refs, late.refs),
        chain(right, (swept(product(tree_of(mass.value), change)), None)),
    )
    difference_ = Vector(*(tidy(a - b) for a, b in zip(late.value, early.value, strict=True)))
    shorter = swept(product(tree_of(mass.value), tree_of(difference_)))
    line = scene.desk.write(Move("rearrange"), (line,), chain(right, (shorter, None)))
    (symbol,) = open_
    a, b = next((a, b) for a, b in zip(value, difference_, strict=True) if b != 0)
    put, refs = scene.put(a)
    if refs or mass.value != symbol:
        raise NotPlannedError("a mass in several letters")
    quotient = tidy(put / b)
    line = scene.desk.write(
        Move("rearrange"), (line,), chain(tree_of(mass.value), (tree_of(quotient), None))
    )
    scene.desk.know(tree_of(symbol), quotient, (line,))
    return True


def write_masses(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """A mass that is open, by the momentum of both spheres as vectors, where all are known.

    None where a velocity is no vector, or the line of centres is **i** or **j**.
    """
    frame = scene.frame(number)
    bodies = scene.bodies(number)
    if frame.wall is not None or not frame.is_slanted:
        return None
    masses = {body: scene.mass(body) for body in bodies}
    late = {body: _late(scene, body, number) for body in bodies}
    if any(source is None for source in late.values()):
        return None
    early = {body: velocity_source(scene, body, number - 1) for body in bodies}
    sides: list[Expression] = []
    refs: list[Ref] = [ref for source in masses.values() for ref in source.refs]
    residual = Vector(sp.Integer(0), sp.Integer(0))
    for own, sign in ((early, 1), (late, -1)):
        terms = []
        for body in bodies:
            source = own[body]
            assert source is not None
            if any(scene.unknown(value) for value in source.value):
                return None
            refs += source.refs
            residual += source.value * (sign * masses[body].value)
            if any(source.value):
                terms.append(product(tree_of(masses[body].value), tree_of(source.value)))
        sides.append(swept(total(terms)))
    move = Move("law", "momentum-vector", number, bodies)
    line = scene.desk.write(move, together(refs), chain(sides[0], (sides[1], None)))
    part = next((value for value in residual if symbol in expanded(value).free_symbols), None)
    if part is None:
        return None
    expanded_part = expanded(part)
    slope = derivative(expanded_part, symbol)
    value = tidy(-expanded_part.subs(symbol, 0) / slope)
    relation = chain(tree_of(symbol), (tree_of(value), None))
    if symbol in value.free_symbols or not scene.judge.follows(
        Move("rearrange"), (line,), relation
    ):
        return None
    line = scene.desk.write(Move("rearrange"), (line,), relation)
    scene.desk.know(tree_of(symbol), value, (line,))
    return line


def _late(scene: Scene, body: str, event: int) -> Source | None:
    """The velocity after an impact, where it is a vector that is known."""
    known = scene.desk.known(Quantity("velocity", (Name(body),), event))
    if known is not None:
        return known
    given = velocity_given(scene, body, event)
    return None if given is None else Source(given[1], given[2])


def write_impulse(scene: Scene, given: GivenEquation) -> int:
    """An impulse that is given as a vector, along the line of the impact, as an equation."""
    match given.link:
        case Link(Quantity("impulse", (Name(body),), int(event)), "=", right):
            value = scene.value(right)
        case _:
            raise NotPlannedError("no impulse of a body")
    if not isinstance(value, Vector) or event not in scene.model.frames:
        raise NotPlannedError("no impulse at an impact that is a vector")
    frame, mass = scene.frame(event), scene.mass(body)
    size, refs = _size(scene, value, frame)
    first = before(scene, "along", body, frame)
    last = in_direction(scene, "along", body, event, frame)
    late, more = scene.put(last.value)
    early = first.value
    a, b = tree_of(early), tree_of(late)
    sense = scene.model.sign(value.dot(frame.n))
    change = difference(b, a) if sense > 0 else difference(a, b)
    move = Move("law", "impulse", event, (body,))
    pool = together(given.refs, refs, mass.refs, first.whole, last.whole, more)
    relation = chain(size, (swept(product(tree_of(mass.value), change)), None))
    # The impulse itself tells the direction of the line, so that its fact may be one too many.
    premises = scene.judge.needed(move, pool, relation, given.refs)
    return scene.desk.write(move, premises or pool, relation)


def _size(scene: Scene, value: Vector, frame: Frame) -> tuple[Expression, tuple[int | str, ...]]:
    """The size of an impulse, which acts along the line of the impact."""
    put, refs = scene.put(value)
    size = tidy(sp.sqrt(tidy(expanded(put.dot(put)))))
    if any(scene.unknown(value) for value in put) or not size.is_number:
        raise NotPlannedError("an impulse in letters")
    if size.is_Rational and 0 in put:
        return tree_of(size), refs
    return Apply("sqrt", total(square(tree_of(value)) for value in put if value != 0)), refs
