"""Kinetic energies, and what is lost of them, by their definitions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, TypeAlias

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, numbers_in
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_zero,
    negated,
    walk,
)
from restitution.planning.formulas.components_of_data import before_a_wall, by_its_angle
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.given_values import given_energy
from restitution.planning.formulas.impacts import before, in_direction
from restitution.planning.formulas.standing_vectors import change_as_vectors
from restitution.planning.formulas.velocity_formulas import (
    known_speed,
    known_vector,
    parts,
    shown_square,
    speed_formula,
    squares,
    velocity_source,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    difference,
    number,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.problem import Arrival

_PAIR = 2


def half(mass: Expression, squares: Expression) -> Expression:
    """Half of a mass times squares of speeds, in this order: ½ × 2(3² − 1²)."""
    if is_zero(squares):
        return squares
    if isinstance(squares, Negate):
        return Negate(half(mass, squares.operand))
    factor: Expression = Binary("/", number(1), number(2))
    if mass != number(1):
        factor = Binary("*", factor, mass)
    return Binary("*", factor, squares)


def energy_formula(scene: Scene, quantity: Quantity) -> Formula:
    """A kinetic energy, ½mv²."""
    assert isinstance(quantity.stage, int)
    names = [argument.name for argument in quantity.arguments if isinstance(argument, Name)]
    alone = tuple(names) == tuple(scene.model.story.spheres)
    if (alone or not names) and (left := _left_of_energy(scene, quantity)) is not None:
        return left
    if (whole := _all_of_it(scene, quantity)) is not None:
        return whole
    bodies = names or list(scene.model.story.spheres)
    terms: list[Expression] = []
    values: list[Any] = []
    refs: list[Ref] = []
    for body in bodies:
        stage = scene.last_event(body, quantity.stage)
        known = _known_energy(scene, quantity.stage, body) if len(bodies) > 1 else None
        if known is not None:
            terms.append(tree_of(known.value))
            values.append(known.value)
            refs += known.refs
            continue
        if len(bodies) == 1:
            _speed_before(scene, body, stage)
        tree, value, own = squares(scene, body, stage, known=len(bodies) == 1)
        if stage and stage != quantity.stage and known_vector(scene, body, stage) is None:
            own = together(own, scene.frame(stage).unit_free)
        mass = scene.mass(body)
        terms.append(half(tree_of(mass.value), tree))
        values.append(mass.value * value / 2)
        refs += [*(() if value == 0 else mass.refs), *own]
    move = Move("define", "energy" if names else "total", quantity.stage or None, tuple(names))
    return Formula(
        move, itself, quantity, total(terms), tidy(expanded(sum(values))), together(refs)
    )


def _all_of_it(scene: Scene, quantity: Quantity) -> Formula | None:
    """The energy of one sphere by a line of that of all, where the others are at rest."""
    match quantity:
        case Quantity("energy", (Name(body),), int(stage)) if len(scene.model.story.spheres) > 1:
            known = scene.desk.known(Quantity("energy", (), stage))
        case _:
            return None
    if known is None or len(numbers_in(known.refs)) != 1 or scene.unknown(known.value):
        return None
    refs: list[Ref] = []
    for other in scene.model.story.spheres:
        if other != body:
            velocity = velocity_source(scene, other, scene.last_event(other, stage))
            if any(velocity.value):
                return None
            refs += velocity.refs
    move = Move("define", "total", stage or None, (body,))
    value = tidy(known.value)
    return Formula(move, itself, quantity, tree_of(value), value, together(known.refs, refs))


def _speed_before(scene: Scene, body: str, stage: int) -> None:
    """Writes a speed of two components that the part asks too, before the energy that has it."""
    speed = Quantity("speed", (Name(body),), stage)
    if (
        stage not in scene.model.frames
        or speed not in scene.asked_alone
        or known_speed(scene, body, stage)
    ):
        return
    if any(scene.unknown(part.value) or part.value == 0 for part in parts(scene, body, stage)):
        return
    own = speed_formula(scene, speed)
    scene.desk.know(speed, own.value, (write_formula(scene, own),))


def _known_energy(scene: Scene, stage: int, *bodies: str) -> Source | None:
    """A kinetic energy that is a line already, with nothing open in it; of all without a body."""
    names = tuple(map(Name, bodies))
    stages = (stage, *(scene.last_event(body, stage) for body in bodies))
    for earlier in dict.fromkeys(stages):
        known = _known_value(scene, Quantity("energy", names, earlier))
        if known is not None:
            return known
    if not bodies and len(scene.model.story.spheres) == 1:
        return _known_energy(scene, stage, *scene.model.story.spheres)  # that of all is its own
    return None


def _known_value(scene: Scene, tree: Expression) -> Source | None:
    """What a line, or a given fact, says of an expression, with nothing open in it."""
    known = scene.desk.known(tree)
    if known is None:
        return given_energy(scene, tree)
    value, more = scene.put(known.value)
    return None if scene.unknown(value) else Source(value, together(known.refs, more))


def _left_of_energy(scene: Scene, quantity: Quantity) -> Formula | None:
    """The energy of all after an impact: that before it less what is lost, if both are lines.

    None where the energies of the spheres are lines too, and their sum is no longer.
    """
    stage = quantity.stage
    if not isinstance(stage, int) or stage not in scene.model.frames:
        return None
    before = _known_energy(scene, stage - 1)
    lost = _known_value(scene, Quantity("energy_lost", (), stage))
    if before is None or lost is None:
        return None
    right = difference(tree_of(before.value), tree_of(lost.value))
    own = [_known_energy(scene, stage, body) for body in scene.model.story.spheres]
    shares = [tree_of(source.value) for source in own if source is not None]
    if len(shares) == len(own) and len(walk(total(shares))) <= len(walk(right)):
        return None
    value = tidy(expanded(before.value - lost.value))
    move, refs = Move("define", "total", stage), together(before.refs, lost.refs)
    return Formula(move, itself, quantity, right, value, refs)


def _lost_by_changes(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """What is lost, of the changes of the kinetic energy of each sphere that are lines."""
    terms: list[Expression] = []
    values: list[Any] = []
    refs: list[Ref] = []
    bodies = tuple(scene.spheres(event))
    for body in bodies:
        late, early = (
            Quantity("energy", (Name(body),), n) for n in (event, scene.last_event(body, event - 1))
        )
        for one, other, sign in ((early, late, 1), (late, early, -1)):
            known = _known_value(scene, Binary("-", one, other))
            if known is not None:
                terms.append(tree_of(sign * known.value))
                values.append(sign * known.value)
                refs += known.refs
                break
        else:
            return None
    move = Move("define", "energy-lost", event, bodies)
    value = tidy(expanded(sum(values)))
    return Formula(move, itself, quantity, total(terms), value, together(refs))


def _lost_by_losses(scene: Scene, quantity: Quantity, stage: int) -> Formula | None:
    """What all impacts take, where what each of them takes is a line.

    Where that of one impact alone is none yet, it is written.
    """
    happenings = (scene.model.happening(number).step for number in range(1, stage + 1))
    if any(isinstance(happening, Arrival) for happening in happenings):
        return None
    if stage == 1 and given_energy(scene, Quantity("energy_lost", (), 1)) is None:
        return None
    losses = [Quantity("energy_lost", (), n) for n in range(1, stage + 1)]
    lost = [_known_value(scene, quantity) for quantity in losses]
    missing = [quantity for quantity, known in zip(losses, lost, strict=True) if known is None]
    if len(missing) == 1 < stage:
        own_loss = energy_lost_formula(scene, missing[0])
        if not scene.unknown(own_loss.value):
            number_ = write_formula(scene, own_loss)
            scene.desk.know(missing[0], own_loss.value, (number_,))
            lost = [_known_value(scene, quantity) for quantity in losses]
    own = [source for source in lost if source is not None]
    if len(own) != stage:
        return None
    right = total(tree_of(source.value) for source in own)
    value = tidy(expanded(sum(source.value for source in own)))
    refs = together(*(source.refs for source in own))
    return Formula(Move("define", "total-lost", stage), itself, quantity, right, value, refs)


def _lost_by_energies(
    scene: Scene, quantity: Quantity, stages: tuple[int, int], bodies: tuple[str, ...]
) -> Formula | None:
    """What is lost, of kinetic energies that are lines already; None where one of them is not."""
    for group in ([()], [(body,) for body in bodies]):
        ends = [[_known_energy(scene, stage, *names) for names in group] for stage in stages]
        early, late = ([source for source in own if source is not None] for own in ends)
        if len(early) != len(group) or len(late) != len(group):
            continue
        pairs = list(zip(early, late, strict=True))
        terms = [difference(*(tree_of(source.value) for source in pair)) for pair in pairs]
        value = sum(one.value - other.value for one, other in pairs)
        refs = together(*(source.refs for pair in pairs for source in pair))
        record = "energy-lost" if quantity.kind == "energy_lost" else "total-lost"
        move = Move("define", record, stages[1], bodies if quantity.kind == "energy_lost" else ())
        return Formula(move, itself, quantity, total(terms), tidy(expanded(value)), refs)
    return None


def _write_energies_after(scene: Scene, event: int) -> None:
    """Writes the kinetic energies after an impact before what is lost, where all are asked anyway.

    With them that of all spheres, where it is asked too: it is their sum.
    """
    bodies = scene.spheres(event)
    own = [Quantity("energy", (Name(body),), event) for body in bodies]
    if event not in scene.model.frames or len(own) < _PAIR or not scene.asked.issuperset(own):
        return
    whole = Quantity("energy", (), event)
    if whole in scene.asked and len(own) == len(scene.model.story.spheres):
        own.append(whole)
    for quantity in own:
        if scene.desk.known(quantity) is None:
            formula = energy_formula(scene, quantity)
            if scene.unknown(formula.value):
                return
            write_formula(scene, formula)


def _lost_by_energies_after(
    scene: Scene, quantity: Quantity, event: int, bodies: tuple[str, ...]
) -> Formula | None:
    """What an impact takes of two spheres, of their energies after it that are lines.

    The energy before it is a line, or is made of the speeds. None where one after it is no line.
    """
    late = [_known_energy(scene, event, body) for body in bodies]
    kept = [source for source in late if source is not None]
    if len(bodies) < _PAIR or len(kept) < len(bodies):
        return None
    first = (
        _known_energy(scene, event - 1) if len(bodies) == len(scene.model.story.spheres) else None
    )
    if first is None:
        formulas = [
            energy_formula(scene, Quantity("energy", (Name(body),), event - 1)) for body in bodies
        ]
        before = total(formula.right for formula in formulas)
        value = sum(formula.value for formula in formulas)
        refs = together(*(formula.refs for formula in formulas))
    else:
        before, value, refs = tree_of(first.value), first.value, first.refs
    right = difference(before, total(tree_of(source.value) for source in kept))
    value = tidy(expanded(value - sum(source.value for source in kept)))
    move = Move("define", "energy-lost", event, bodies)
    pool = together(refs, *(source.refs for source in kept))
    own = Formula(move, itself, quantity, right, value, pool)
    return own if not scene.unknown(value) and _follows(scene, own) else None


def energy_lost_formula(scene: Scene, quantity: Quantity) -> Formula:
    """Components across the line do not change, so that they cancel."""
    event = quantity.stage
    assert isinstance(event, int)
    _write_energies_after(scene, event)
    bodies = tuple(scene.spheres(event))
    known = (
        _lost_by_energies(scene, quantity, (event - 1, event), bodies)
        or _lost_by_changes(scene, quantity, event)
        or _lost_by_energies_after(scene, quantity, event, bodies)
    )
    if known is not None:
        return known
    by_speeds = _lost_by_speeds(scene, quantity, event, given_speed)
    if by_speeds is not None:
        return by_speeds
    if event not in scene.model.frames:
        return _lost_by_velocities(scene, quantity, event)
    by_shown = _lost_by_squares(scene, quantity, event, partial(_square_that_was_shown, scene))
    if by_shown is not None and _follows(scene, by_shown):
        return by_shown
    frame = scene.frame(event)
    if len(scene.spheres(event)) == 1 and _is_open(scene, scene.spheres(event)[0], frame):
        by_speeds = _lost_by_speeds(scene, quantity, event, _plain_speed)
        if by_speeds is not None and _follows(scene, by_speeds):
            return by_speeds
    if all(change_as_vectors(scene, body, event) for body in scene.spheres(event)):
        by_vectors = _lost_by_squares(scene, quantity, event, partial(_square_of_vector, scene))
        if by_vectors is not None and _follows(scene, by_vectors):
            return by_vectors
    for known_in in (_read_off, _short_speed) if frame.is_slanted else ():
        by_speeds = _lost_by_speeds(scene, quantity, event, known_in)
        if by_speeds is not None and _follows(scene, by_speeds):
            return by_speeds
    by_speeds = _lost_by_speeds(scene, quantity, event, _speed_that_was_asked)
    if by_speeds is not None and _follows(scene, by_speeds):
        return by_speeds
    terms: list[Expression] = []
    first: Expression | None = None  # at a wall, with the component before as the data have it
    values: list[Any] = []
    refs: list[Any] = [*frame.names_axis("along")]
    for body in scene.spheres(event):
        early = before(scene, "along", body, frame)
        late = in_direction(scene, "along", body, event, frame)
        mass = scene.mass(body)
        begin = by_its_angle(scene, body, frame, early) or tree_of(early.value)
        squared = [square(begin), square(tree_of(late.value))]
        terms.append(half(tree_of(mass.value), difference(*squared)))
        by_data = before_a_wall(scene, body, frame, early)
        if by_data is not None:
            first = half(tree_of(mass.value), difference(square(by_data), squared[1]))
        values.append(mass.value * (early.value**2 - late.value**2) / 2)
        own = () if values[-1] == 0 else mass.refs
        refs += [*own, *early.whole, *late.whole]
    move = Move("define", "energy-lost", event, scene.spheres(event))
    pool = together(refs)
    axis = frame.refs if 0 in frame.n else ()
    if axis:
        # Along i, or j, the velocities tell the same without what gives the axis.
        bare = tuple(ref for ref in pool if ref not in axis)
        if scene.judge.follows(move, bare, chain(quantity, (swept(total(terms)), None))):
            pool = bare
    value, whole = tidy(expanded(sum(values))), total(terms)
    if first is not None:
        return Formula(move, itself, quantity, first, value, pool, whole)
    return Formula(move, itself, quantity, whole, value, pool)


def loss_by_given_speeds(scene: Scene, asked: Quantity) -> int | None:
    """What an impact takes, where the speeds after it are given; None where they are not."""
    match asked:
        case Quantity("energy_lost", (), int(event)) if event in scene.model.frames:
            pass
        case _:
            return None
    own = _lost_by_squares(scene, asked, event, partial(_square_of_data, scene))
    known = scene.desk.known(asked) is not None
    return write_formula(scene, own) if own and not known and _follows(scene, own) else None


def stands(scene: Scene, body: str, stage: int) -> bool:
    """Whether a line has the component that an impact has changed, with nothing open in it."""
    last = scene.last_event(body, stage)
    if last not in scene.model.frames:
        return False
    component = scene.desk.known(scene.frame(last).component("along", body, last))
    return component is not None and not scene.unknown(component.value)


def _square_of_data(scene: Scene, body: str, stage: int) -> _Square | None:
    """The square of a speed that is given; at the start by the components of the data too.

    None after an impact for which a line has the component that changed: by that it is shorter.
    """
    given = given_speed(scene, body, stage)
    if given is not None and not stands(scene, body, stage):
        return square(tree_of(given.value)), given.value**2, given.refs
    if scene.last_event(body, stage):
        return None
    own = squares(scene, body, 0)
    return None if scene.unknown(own[1]) else own


def _square_that_was_shown(scene: Scene, body: str, stage: int) -> _Square | None:
    """The square of a speed that was to be shown; at the start, of one that the data give."""
    last = scene.last_event(body, stage)
    if not last:
        given = given_speed(scene, body, stage)
        return None if given is None else (square(tree_of(given.value)), given.value**2, given.refs)
    shown = shown_square(scene, body, last)
    if shown is not None:
        return tree_of(shown.value), shown.value, shown.refs
    speed = scene.desk.known(Quantity("speed", (Name(body),), last))
    lines = () if speed is None else numbers_in(speed.refs)
    if speed is None or not any(end.shown and end.line in lines for end in scene.desk.ends):
        return None
    value, refs = scene.put(speed.value)
    squared = tidy(value**2)
    return tree_of(squared), squared, together(speed.refs, refs)


def _square_of_vector(scene: Scene, body: str, stage: int) -> _Square:
    """The square of a speed by the components of a velocity that stands as a vector."""
    source = velocity_source(scene, body, stage)
    tree = total(square(tree_of(part)) for part in source.value if part != 0)
    return tree, sum(part**2 for part in source.value), source.refs


def _lost_by_velocities(scene: Scene, quantity: Quantity, event: int) -> Formula:
    """What an impulse from outside takes: it changes the whole velocity."""

    def square_of(body: str, stage: int) -> _Square:
        return squares(scene, body, scene.last_event(body, stage), known=True)

    whole = _lost_by_squares(scene, quantity, event, square_of)
    assert whole is not None
    return whole


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
        scene.desk.known(quantity) is not None or quantity in scene.asked_alone
        for quantity in (first, second)
    ):
        return None
    ends = [in_direction(scene, "along", body, k, frame) for k in (event, event - 1)]
    ends = ends if late > early else ends[::-1]
    mass = scene.mass(body)
    squared = difference(*(square(tree_of(end.value)) for end in ends))
    value = tidy(expanded(mass.value * (ends[0].value ** 2 - ends[1].value ** 2) / 2))
    own = () if value == 0 else mass.refs  # of nothing no mass is needed
    refs = together(frame.names_axis("along"), own, *(end.whole for end in ends))
    move = Move("define", "energy-change", event, (body,))
    right = half(tree_of(mass.value), squared)
    return Formula(move, itself, asked, right, value, refs)


def _lost_by_speeds(
    scene: Scene,
    quantity: Quantity,
    event: int,
    known: Callable[[Scene, str, int], Source | None],
) -> Formula | None:
    """Where every speed is known, before and after: ½mu² − ½mv²; None otherwise."""

    def square_of(body: str, stage: int) -> _Square | None:
        speed = known(scene, body, stage)
        if speed is None:
            return None
        return square(tree_of(speed.value)), speed.value**2, speed.refs

    return _lost_by_squares(scene, quantity, event, square_of)


_Square: TypeAlias = tuple[Expression, Any, tuple[Ref, ...]]
"""The square of a speed, its value, and what says it."""


def _lost_by_squares(
    scene: Scene,
    quantity: Quantity,
    event: int,
    square_of: Callable[[str, int], _Square | None],
) -> Formula | None:
    """What is lost, by the squares of the speeds before an event and after it.

    None where one of the squares is not known.
    """
    terms: list[Expression] = []
    values: list[Any] = []
    refs: list[Ref] = []
    after: list[tuple[Expression, tuple[Ref, ...]]] = []
    bodies = tuple(scene.spheres(event))
    for body in bodies:
        mass = scene.mass(body)
        early, late = (square_of(body, stage) for stage in (event - 1, event))
        if early is None or late is None:
            return None
        terms.append(difference(*(half(tree_of(mass.value), speed[0]) for speed in (early, late))))
        values.append(mass.value * (early[1] - late[1]) / 2)
        needed = () if tidy(expanded(values[-1])) == 0 else mass.refs  # of nothing no mass
        refs += [*needed, *early[2], *late[2]]
        after.append((half(tree_of(mass.value), late[0]), together(mass.refs, late[2])))
    move = Move("define", "energy-lost", event, bodies)
    value = tidy(expanded(sum(values)))
    own = Formula(move, itself, quantity, total(terms), value, together(refs))
    return _with_energy_before(scene, own, after) or own


def _with_energy_before(
    scene: Scene, own: Formula, after: Sequence[tuple[Expression, tuple[Ref, ...]]]
) -> Formula | None:
    """What two spheres lose, where a line has their energy before, and ``after`` is that after.

    Each term of that comes with what says it. None where there is no such line.
    """
    event = own.move.event
    assert event is not None
    if len(after) < _PAIR or len(after) < len(scene.model.story.spheres):
        return None
    known = _known_energy(scene, event - 1)
    if known is None:
        return None
    terms = [tree for tree, _ in after if not is_zero(tree)]
    right = total([tree_of(known.value), *map(negated, terms)])
    refs = together(known.refs, *(refs for _, refs in after))
    shorter = replace(own, right=right, refs=refs)
    return shorter if _follows(scene, shorter) else None


def _follows(scene: Scene, own: Formula) -> bool:
    """Whether a quantity is what a formula makes of it, with no identity between."""
    return scene.judge.follows(own.move, own.refs, chain(own.left, (swept(own.right), None)))


def _is_open(scene: Scene, body: str, frame: Frame) -> bool:
    """Whether the component that changed stands in a letter that has been worked out since."""
    own = scene.desk.known(frame.component("along", body, frame.number))
    return own is not None and bool(scene.put(own.value)[1])


def _plain_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that is given, or a line with nothing open in it."""
    given = given_speed(scene, body, stage)
    if given is not None:
        return given
    known = known_speed(scene, body, scene.last_event(body, stage))
    return None if known is None or scene.unknown(known.value) else known


def _short_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that is given or a line, and no sum."""
    plain = _plain_speed(scene, body, stage)
    return None if plain is None or plain.value.has(sp.Add) else plain


def _speed_that_was_asked(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed with which an item ends, that is no sum; at the start one that the data give."""
    last = scene.last_event(body, stage)
    if not last:
        still = all(part == 0 for part in scene.velocity(body, 0))
        return _read_off(scene, body, 0) if still else given_speed(scene, body, 0)
    known = _short_speed(scene, body, stage)
    lines = () if known is None else numbers_in(known.refs)
    return known if any(end.line in lines for end in scene.desk.ends) else None


def _read_off(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that is read off a velocity along **i** or **j**."""
    last = scene.last_event(body, stage)
    known = scene.desk.known(Quantity("velocity", (Name(body),), last)) if last else None
    if not last and f"velocity {body}" in scene.facts:
        known = scene.initial(body)
    if known is None:
        return None
    value, refs = scene.put(known.value)
    sizes = [other for other in value if other != 0]
    if len(sizes) > 1 or any(map(scene.unknown, value)):
        return None
    sign = scene.model.proved_sign(scene.model.in_data(sizes[0])) if sizes else 1
    size = tidy(sign * sizes[0]) if sizes and sign else sp.Integer(0)
    return Source(size, together(known.refs, refs)) if sign else None


def given_speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that the data give, with a direction at an angle or as a fact about the motion."""
    last = scene.last_event(body, stage)
    size: Any = None
    refs: tuple[Ref, ...] = ()
    if not last and (fact := scene.facts.get(f"velocity {body}")) is not None:
        match fact.relation.only[0].right:
            case Polar(size) if not isinstance(size, Unit):
                refs = (fact.id,)
    for equation in scene.given if last else ():
        if (
            equation.link.left == Quantity("speed", (Name(body),), last)
            and equation.link.sign == "="
        ):
            size, refs = equation.link.right, equation.refs
    if size is None or has_quantity(size):
        return None
    value, more = scene.put(scene.scalar(size))
    return None if scene.unknown(value) else Source(value, together(refs, more))


def total_energy_lost_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The energy of all spheres at the start, less that after an event: each a line before it."""
    assert isinstance(quantity.stage, int)
    spheres = tuple(scene.model.story.spheres)
    known = _lost_by_energies(scene, quantity, (0, quantity.stage), spheres) or _lost_by_losses(
        scene, quantity, quantity.stage
    )
    if known is not None:
        return known
    if quantity.stage == 1 and 1 in scene.model.frames:
        own = energy_lost_formula(scene, Quantity("energy_lost", (), 1))
        return replace(own, quantity=quantity, move=Move("define", "total-lost", 1))
    terms, values, refs = [], [], []
    # Lines for speeds that the second takes stand above both.
    both = [energy_formula(scene, Quantity("energy", (), stage)) for stage in (0, quantity.stage)]
    for own in both:
        number = write_formula(scene, own)
        # A long number with ratios of a calculator stays as it stands: its digits are printed.
        digits = own.value.is_number and own.value.has(sp.sin, sp.cos)
        terms.append(scene.desk.last_link(number).right if digits else tree_of(own.value))
        values.append(own.value)
        refs.append(number)
    return Formula(
        Move("define", "total-lost", quantity.stage),
        itself,
        quantity,
        difference(*terms),
        tidy(expanded(values[0] - values[1])),
        together(refs),
    )
