"""Impulses, by their definitions."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    walk,
)
from restitution.planning.formulas.components_of_data import as_in_the_data
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.standing_vectors import change_as_vectors
from restitution.planning.formulas.velocity_formulas import velocity_source
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    difference,
    negative,
    product,
    square,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import unit_tree, whole_direction
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


def impulse_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The impulse of an event, or its size."""
    event = quantity.stage
    assert isinstance(event, int)
    if quantity.arguments:
        return _impulse_vector(scene, quantity, event)
    if event not in scene.model.frames:
        return _size_of_blow(scene, quantity, event)
    whole = _size_of_impulse(scene, quantity, event)
    if whole is None:
        _write_vector_before(scene, event)
        whole = _size_of_impulse(scene, quantity, event) or _size_by_vectors(scene, quantity, event)
    if whole is None:
        whole = _size_of_change(scene, quantity, event)
    if whole is not None:
        return whole
    return impulse_on(scene, quantity, body_of_impulse(scene, event), event)


def body_of_impulse(scene: Scene, event: int) -> str:
    """The body by whose change of momentum the size of an impulse is written.

    It is the one of which all is given, or that with the fewest unknowns: its mass, its velocity
    before, its velocity after; of several one that was at rest, or whose component stands above,
    and else that of the shortest numbers.
    """
    frame = scene.frame(event)
    spheres = scene.spheres(event)
    given = [sphere for sphere in spheres if _is_all_given(scene, sphere, event)]
    if len(given) == 1:
        return given[0]
    best = min(_unknowns(scene, sphere, event) for sphere in spheres)
    fewest = [sphere for sphere in spheres if _unknowns(scene, sphere, event) == best]
    at_rest = [
        sphere
        for sphere in fewest
        if in_direction(scene, "along", sphere, event - 1, frame).value == 0
    ]
    earlier = [sphere for sphere in fewest if _stands_above(scene, sphere, event)]
    if len(earlier) == 1 and not at_rest:
        return earlier[0]
    closed = [sphere for sphere in fewest if not _is_open(scene, sphere, event)]
    if len(closed) == len(fewest) and not at_rest:
        return min(fewest, key=lambda sphere: _length_of_change(scene, sphere, event))
    body = (at_rest or fewest)[-1 if at_rest else 0]
    return closed[0] if closed and body not in closed else body


def _is_all_given(scene: Scene, sphere: str, event: int) -> bool:
    """Whether the data tell the mass of a sphere and its velocity before and after an impact."""
    mark = scene.desk.mark()
    after = velocity_given(scene, sphere, event)
    scene.desk.back(mark)
    if after is None or scene.last_event(sphere, event - 1):
        return False
    sources = (*scene.mass(sphere).refs, *after[2], *scene.initial(sphere).refs)
    lines = any(isinstance(ref, int) for ref in sources)
    return not lines and not any(map(scene.unknown, (scene.mass(sphere).value, *after[1])))


def _stands_above(scene: Scene, sphere: str, event: int) -> bool:
    """Whether an item above has the component along the line of centres after an impact."""
    component = scene.model.components.get((event, sphere))
    known = None if component is None else scene.desk.known(Letter(component.symbol.name))
    lines = [ref for ref in ([] if known is None else known.refs) if isinstance(ref, int)]
    return bool(lines) and all(scene.desk.line(ref).item != scene.desk.item for ref in lines)


def _length_of_change(scene: Scene, sphere: str, event: int) -> int:
    """How much there is to read in the mass of a sphere and its components along the line."""
    frame = scene.frame(event)
    ends = (in_direction(scene, "along", sphere, k, frame).value for k in (event - 1, event))
    return sum(len(walk(tree_of(tidy(x)))) for x in (*ends, scene.mass(sphere).value))


def _unknowns(scene: Scene, sphere: str, event: int) -> tuple[bool, int]:
    """Whether a mass is unknown, and how many letters of a velocity before an impact are."""
    mass = scene.model.story.mass(sphere)
    early = scene.velocity(sphere, event - 1).dot(scene.model.frames[event].n)
    return bool(scene.unknown(mass)), len(scene.unknown(early))


def impulse_in_sense(scene: Scene, own: Formula) -> Formula:
    """An impulse by a change of momentum that is positive in the first of several solutions."""
    (body,), event = own.move.bodies, own.move.event
    assert event is not None
    assert isinstance(own.quantity, Quantity)
    return impulse_on(scene, own.quantity, body, event, scene.first)


def impulse_on(
    scene: Scene, quantity: Quantity, body: str, event: int, model: Model | None = None
) -> Formula:
    """The size of an impulse, as the change of momentum of one of the bodies.

    The change is positive in the solution that is written, or in that of another ``model``.
    """
    model = model or scene.model
    frame = scene.frame(event)
    early, late = (in_direction(scene, "along", body, k, frame) for k in (event - 1, event))
    change = late.value - early.value
    mass = scene.mass(body)
    first, last = tree_of(early.value), tree_of(late.value)
    forms = [(first, last)]
    by_data = as_in_the_data(scene, body, frame, early)
    if by_data is not None:
        forms.insert(0, (by_data, last))
    if model.sign(model.in_data(change)) < 0:
        forms, change = [(end, begin) for begin, end in forms], -change
    # At a wall the two point opposite ways: sizes are added.
    walled = frame.wall is not None
    trees = [
        product(
            tree_of(mass.value),
            total((end, negative(begin))) if walled else difference(end, begin),
        )
        for begin, end in forms
    ]
    tree, value = trees[0], tidy(mass.value * change)
    if not scene.unknown(value) and not model.decide(change, ">=", 0):
        # Which way the body comes is open.
        tree, value = Apply("abs", tree), sp.Abs(value)
    return Formula(
        Move("law", "impulse", event, (body,)),
        itself,
        quantity,
        tree,
        value,
        together(mass.refs, early.whole, late.whole, frame.names_axis("along")),
        trees[1] if by_data is not None and tree == trees[0] else None,
    )


def _is_open(scene: Scene, body: str, event: int) -> bool:
    """Whether the component along the line of centres after an impact is not known yet."""
    component = scene.model.components.get((event, body))
    return component is not None and bool(scene.unknown(component.symbol))


def _write_vector_before(scene: Scene, event: int) -> None:
    """Writes the impulse on a body before its size, where both are asked and the line is slanting.

    It is written where it comes by velocities that stand as vectors, or is a multiple of a vector
    of whole numbers.
    """
    for body in scene.spheres(event) if scene.frame(event).is_slanted else ():
        vector = Quantity("impulse", (Name(body),), event)
        if vector not in scene.asked_alone or scene.desk.known(vector) is not None:
            continue
        whole = whole_direction(scene.frame(event).n)[1] != 1 and _has_components(
            scene, body, event
        )
        if not whole and not _comes_by_vectors(scene, body, event):
            continue
        own = _impulse_vector(scene, vector, event)
        if not any(map(scene.unknown, own.value)):
            write_formula(scene, own)
            return


def _size_of_impulse(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """The size of an impulse of which a line tells both components; None where none does."""
    for body in scene.spheres(event):
        known = scene.desk.known(Quantity("impulse", (Name(body),), event))
        if known is None or not isinstance(known.value, Vector):
            continue
        if any(map(_has_surd, known.value)) and _has_components(scene, body, event):
            continue  # the change of a component is simpler
        if _is_in_a_plain_direction(known.value):
            return _size(Move("define", "size", event, (body,)), quantity, known)
    return None


def _size_by_vectors(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """The size of m(**v** − **u**), where both are along **i** or **j** and the line in letters.

    The vector has its line. None where components are known, or the velocities are no vectors.
    """
    frame = scene.frame(event)
    if not frame.is_slanted or not any(component.free_symbols for component in frame.n):
        return None
    for body in scene.spheres(event):
        if _has_components(scene, body, event):
            continue
        mark = scene.desk.mark()
        ends = [velocity_source(scene, body, n).value for n in (event - 1, event)]
        plain = all(0 in end for end in ends) and ends[0].dot(ends[1]) == 0
        own = None
        if plain and _comes_by_vectors(scene, body, event):
            own = _impulse_vector(scene, Quantity("impulse", (Name(body),), event), event)
        if own is None or any(map(scene.unknown, own.value)):
            scene.desk.back(mark)
            continue
        line = write_formula(scene, own)
        return _size(Move("define", "size", event, (body,)), quantity, Source(own.value, (line,)))
    return None


def _size_of_change(scene: Scene, quantity: Quantity, event: int) -> Formula | None:
    """The size of m(**v** − **u**), where components along the line would have a root; or None."""
    for body in scene.spheres(event):
        if not change_as_vectors(scene, body, event):
            continue
        own = impulse_by_vectors(scene, Quantity("impulse", (Name(body),), event), body, event)
        if not any(map(scene.unknown, own.value)):
            line = write_formula(scene, own)
            known = Source(own.value, (line,))
            return _size(Move("define", "size", event, (body,)), quantity, known)
    return None


def _comes_by_vectors(scene: Scene, body: str, event: int) -> bool:
    """Whether the impulse on a body comes by its velocities as vectors.

    It does where data or lines tell both as vectors, but for a vector with roots of numbers where
    the size of the impulse is asked too: that has its line of the components anyway.
    """
    before = scene.last_event(body, event - 1)
    known = [scene.desk.known(Quantity("velocity", (Name(body),), n)) for n in (before, event)]
    if known[1] is None or (known[0] is None and before != 0):
        return False
    late = velocity_source(scene, body, event).value
    sized = Quantity("impulse", (), event) in scene.asked_alone
    return not any(map(scene.unknown, late)) and not (sized and any(map(_has_surd, late)))


def _has_components(scene: Scene, body: str, event: int) -> bool:
    """Whether lines tell the component of a body along a slanting line, before and after."""
    stages = (scene.last_event(body, event - 1), event)
    along = scene.frame(event).along
    velocities = [Quantity("velocity", (Name(body),), stage) for stage in stages]
    known = [scene.desk.known(Quantity("along", (velocity, along))) for velocity in velocities]
    return all(
        source is not None and not scene.unknown(scene.put(source.value)[0]) for source in known
    )


def _has_surd(value: Any) -> bool:
    """Whether a root of a number stands in a value."""
    powers = sp.sympify(value, strict=True).atoms(sp.Pow)
    return any(power.is_number and power.exp.is_Rational and power.exp.q != 1 for power in powers)


def _is_in_a_plain_direction(vector: Vector) -> bool:
    """Whether the components of a vector are numbers, or in the ratio of numbers."""
    x, y = (sp.sympify(component, strict=True) for component in vector)
    if not (x.free_symbols | y.free_symbols):
        return True
    return bool(x) and bool(y) and bool(tidy(y / x).is_number)


def _size_of_blow(scene: Scene, quantity: Quantity, event: int) -> Formula:
    """The size of a blow that is given as a vector."""
    blow = scene.data(f"impulse {event}")
    if not isinstance(blow.value, Vector):
        raise NotPlannedError("the size of a blow")
    return _size(Move("define", "size", event, scene.bodies(event)), quantity, blow)


def _size(move: Move, quantity: Quantity, vector: Source) -> Formula:
    """The size of a vector by its components."""
    value = tidy(sp.sqrt(tidy(expanded(vector.value.dot(vector.value)))))
    whole, length = whole_direction(vector.value)
    parts = [value for value in vector.value if value != 0]
    factor: sp.Expr = sp.Integer(1)
    if length != 1 and not all(map(_is_plain_number, parts)):
        # A factor that both components have stands before the root.
        parts, factor = list(whole), tidy(value / length)
    root = Apply("sqrt", total(square(tree_of(part)) for part in parts))
    tree: Expression = product(tree_of(factor), root)
    if len(parts) == 1 and sp.sympify(parts[0], strict=True).is_number:
        tree = tree_of(value)
    return Formula(move, itself, quantity, tree, value, vector.refs)


def _is_plain_number(value: Any) -> bool:
    """Whether a value is a number of at most two decimals: it is squared as it stands."""
    return bool((100 * sp.sympify(value, strict=True)).is_Integer)


def _impulse_vector(scene: Scene, quantity: Quantity, event: int) -> Formula:
    (name,) = quantity.arguments
    assert isinstance(name, Name)
    body = name.name
    along = _along_the_line(scene, quantity, body, event)
    return impulse_by_vectors(scene, quantity, body, event) if along is None else along


def impulse_by_vectors(scene: Scene, quantity: Quantity, body: str, event: int) -> Formula:
    """The impulse on a body as m(**v** − **u**)."""
    mass = scene.mass(body)
    late, early = (velocity_source(scene, body, stage) for stage in (event, event - 1))
    change = Binary("-", tree_of(late.value), tree_of(early.value))
    value = Vector(*(tidy(mass.value * component) for component in late.value - early.value))
    return Formula(
        Move("law", "impulse-vector", event, (body,)),
        itself,
        quantity,
        product(tree_of(mass.value), change),
        value,
        together(mass.refs, late.refs, early.refs),
    )


def _along_the_line(scene: Scene, quantity: Quantity, body: str, event: int) -> Formula | None:
    """The impulse on a body by the change of its component along a line that slants.

    None where no component has been worked out, or where it comes by velocities as vectors.
    """
    velocity = Quantity("velocity", (Name(body),), event)
    component = Quantity("along", (velocity, Quantity("line_of_centres", (), event)))
    if scene.desk.known(component) is None or not scene.frame(event).is_slanted:
        return None
    if _comes_by_vectors(scene, body, event):
        return None
    frame = scene.frame(event)
    mass = scene.mass(body)
    late, early = (in_direction(scene, "along", body, k, frame) for k in (event, event - 1))
    size = tidy(mass.value * (late.value - early.value))
    change = difference(tree_of(late.value), tree_of(early.value))
    tree = product(tree_of(mass.value), change, unit_tree(frame.n))
    move = Move("law", "impulse-vector", event, (body,))
    value = Vector(*(tidy(expanded(size * component)) for component in frame.n))
    pool = together(mass.refs, late.whole, early.whole, frame.refs)
    refs = scene.judge.needed(move, pool, chain(quantity, (tree, None)), mass.refs)
    if refs is None:
        return None
    whole, length = whole_direction(frame.n)
    between = product(tree_of(tidy(size / length)), tree_of(whole))
    return Formula(move, itself, quantity, tree, value, refs, between)
