"""Lines about impacts: components before and after, and the laws that tie them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import (
    Meaning,
    Move,
    MoveId,
    Ref,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    letters,
    unsigned,
    walk,
)
from restitution.planning.formulas.assembling import put_together
from restitution.planning.formulas.components_of_data import (
    by_its_ratio,
    has_a_speed_put_in,
    has_ratios,
    is_polar,
    with_its_ratio,
)
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.next_walls import component_by_angle
from restitution.planning.formulas.scalar_products import (
    body_of,
    by_scalar_product,
    by_the_angle_of_the_line,
    scalar_product,
)
from restitution.planning.formulas.settled import settled
from restitution.planning.formulas.square_impacts import component_at_right_angles
from restitution.planning.formulas.unknown_lines import law_by_vectors
from restitution.planning.writing.circles import chord_from, from_centre
from restitution.planning.writing.degrees import (
    angle_to_the_line,
    by_degrees,
    by_the_angle_from,
    has_standard_angles,
    on_a_chord_by_degrees,
    share_by_degrees,
)
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    ONE,
    ZERO,
    difference,
    factors,
    is_one,
    neat,
    negative,
    product,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.planning.writing.vectors import initial_as_a_line, velocity_given
from restitution.problem import Impact
from restitution.vector import Vector

# --- components ---------------------------------------------------------------------------------


def before(scene: Scene, kind: str, body: str, frame: Frame) -> Source:
    """A component of a velocity just before the impact of a frame.

    Where it takes a line, that of the other one stands beside it.
    """
    lines = len(scene.desk.lines)
    source = in_direction(scene, kind, body, frame.number - 1, frame)
    if len(scene.desk.lines) > lines and frame.is_slanted:
        other = "across" if kind == "along" else "along"
        in_direction(scene, other, body, frame.number - 1, frame)
    if kind == "along" and frame.wall is None:
        hidden = source.form is not None and not has_ratios(source.form)
        if hidden or has_a_speed_put_in(scene, body, frame, source):
            return _worked_out(scene, body, frame, source)
    return source


def _worked_out(scene: Scene, body: str, frame: Frame, source: Source) -> Source:
    """A component of the data by a cosine in numbers, in a line: both laws use what it comes to."""
    quantity = frame.component("along", body, 0)
    own = neat(scene.initial(body).value.dot(frame.direction("along")))
    relation = chain(quantity, (tree_of(own), None), (tree_of(source.value), "define"))
    if own == source.value and source.form is not None:
        relation = chain(quantity, (source.form, None), (tree_of(own), "rearrange"))
    move = Move("define", "component", frame.number, (body,))
    number = scene.desk.write(move, source.whole, relation)
    return scene.desk.know(quantity, source.value, (number,))


def in_direction(scene: Scene, kind: str, body: str, stage: int, frame: Frame) -> Source:
    """A component, after ``stage`` events, in one of the directions of a frame."""
    last = scene.last_event(body, stage)
    tree = frame.component(kind, body, last)
    known = settled(scene, tree)
    if known is not None:
        return _put(scene, known)
    direction = frame.direction(kind)
    if stage == frame.number - 1 and (begin := chord_from(scene, body, frame.number)) is not None:
        return _on_a_chord(scene, kind, body, begin, frame)
    if last == 0 and (sought := _sought(scene, body, direction)) is not None:
        return _put(scene, sought)
    if last == 0:
        initial = scene.initial(body)
        if not any(initial.value):
            return Source(sp.Integer(0), initial.refs)  # at rest: in every direction
        value = neat(initial.value.dot(direction))
        form = by_degrees(scene, kind, body, frame, value)
        if form is not None and not has_standard_angles(form):
            value = tidy(scene.scalar(form))  # u sin 15°, in which no roots are to be seen
        form = form or by_the_angle_of_the_line(scene, kind, body, frame)
        in_a_line = frame.write is not None or not is_polar(scene, body)
        # Who moves along the line of centres, by its angle, has its speed as its component.
        in_a_line |= frame.wall is None and not any(
            _parallel(scene, initial.value, vector) for vector in (frame.n, frame.t)
        )
        # Of a direction in letters a sum of its ratios has to be seen: −v(cos θ + sin θ)/√2.
        in_a_line |= any(addend.has(sp.cos, sp.sin) for addend in atoms_in(value, sp.Add))
        # One by the angle of its path with the line is read off: u cos(α − β).
        in_a_line &= form is None or angle_to_the_line(scene, body, frame) is None
        if frame.is_slanted and in_a_line:
            exact = None
            if form is None and (read := by_the_angle_from(scene, kind, body, frame, value)):
                form, exact = read
            initial = initial_as_a_line(scene, body) if form is None else initial
            return by_scalar_product(scene, tree, initial, frame, direction, form, exact)
        source = _put(scene, Source(value, initial.refs, frame.refs, form))
        if form is None and kind == "along":
            return replace(source, form=with_its_ratio(value, source.value, frame))
        return source
    vector = scene.desk.known(Quantity("velocity", (Name(body),), last))
    if last not in scene.model.frames:
        blow = blown(scene, body, last) if vector is None else vector
        return _of_vector(scene, kind, body, frame, blow, last)
    own = scene.frame(last)
    both_slant = own.is_slanted and frame.is_slanted
    in_numbers = vector is not None and both_slant and all(x.is_number for x in vector.value)
    for own_kind in COMPONENTS:
        sign = _parallel(scene, own.direction(own_kind), direction)
        if sign:
            standing = settled(scene, own.component(own_kind, body, last))
            if standing is None and in_numbers and last != frame.number:
                break  # the vector is resolved: nothing of the last impact is worked out for it
            source = standing or after(scene, own_kind, body, own)
            axis = source.axis
            if own.component(own_kind, body, last) != tree:
                axis = together(axis, own.unit_free, frame.unit_free)
            turned = _put(scene, Source(sign * source.value, source.refs, axis))
            if (own_kind, sign) != (kind, 1) and frame.is_slanted and turned.value != 0:
                return _as_a_line(scene, tree, turned, frame)
            return turned
    if vector is not None and not (direction.x and direction.y):
        return _put(scene, Source(vector.value.dot(direction), vector.refs, frame.unit_free))
    if vector is not None and in_numbers:
        return by_scalar_product(scene, tree, vector, frame, direction, None)
    return _resolved(scene, kind, body, last, frame)


def _as_a_line(scene: Scene, quantity: Quantity, source: Source, frame: Frame) -> Source:
    """A component that is known in another direction, or in the other sense, in a line."""
    number = scene.desk.write(
        Move("define", "component", frame.number, body_of(quantity)),
        source.whole,
        chain(quantity, (tree_of(source.value), None)),
    )
    return scene.desk.know(quantity, source.value, (number,))


def _on_a_chord(scene: Scene, kind: str, body: str, since: int, frame: Frame) -> Source:
    """A component before an impact with a circular wall, from another point of it.

    A chord makes equal angles with the radii at its ends.
    """
    refs: tuple[Ref, ...] = (f"contact {frame.number}",)
    form: Expression | None = None
    by: MoveId = "rearrange"
    if since:
        own = scene.frame(since)
        source = _put(scene, after(scene, kind, body, own))
        value, refs = source.value, (*refs, f"contact {since}", *source.whole)
        value = neat(-value if kind == "along" else value)
    else:
        place, velocity = scene.data(f"position {body}"), scene.initial(body)
        radius_vector = from_centre(scene, frame.number, place.value)
        unit = radius_vector / scene.model.story.size(radius_vector)
        direction = -unit if kind == "along" else unit.turned_left()
        value, more = scene.put(velocity.value.dot(direction))
        refs = together(refs, place.refs, velocity.refs, more)
        share = on_a_chord_by_degrees(scene, kind, body, velocity.value, direction)
        form = scalar_product(velocity.value, direction) if share is None else share
        value = neat(value)
        by = "put" if more else "rearrange"
    quantity = frame.component(kind, body, since)
    steps: list[tuple[Expression, MoveId | None]] = [(tree_of(value), None)]
    if form is not None:
        steps = [(form, None), (tree_of(value), by)]
    line = scene.desk.write(
        Move("define", "chord", frame.number, (body,)), refs, chain(quantity, *steps)
    )
    return scene.desk.know(quantity, value, (line,))


def _sought(scene: Scene, body: str, direction: Vector) -> Source | None:
    """A component along **i** or **j** of a velocity at the start that is to be found."""
    if f"velocity {body}" in scene.facts or direction.x * direction.y != 0:
        return None
    own = scene.sought(body, "j" if direction.x == 0 else "i")
    return Source(own.value * (direction.x + direction.y), own.refs)


def _put(scene: Scene, source: Source) -> Source:
    value, refs = scene.put(source.value)
    form = source.form if not refs else None
    return Source(value, together(source.refs, refs), source.axis, form)


def tree_in_law(source: Source) -> Expression:
    """A component as a law has it: as it comes of the data, or as what it is worth."""
    return tree_of(source.value) if source.form is None else source.form


def _product_of_units(a: Vector, b: Vector, value: sp.Expr) -> Expression:
    """The scalar product of two unit vectors: as products, where neither is along an axis."""
    (one, size), (other, length) = whole_direction(a), whole_direction(b)
    if not all((*one, *other)):
        return tree_of(value)
    minus = bool(value.is_negative)
    terms = (
        product(tree_of(-p if minus else p), tree_of(q)) for p, q in zip(one, other, strict=True)
    )
    quotient = swept(Binary("/", total(terms), tree_of(tidy(size * length))))
    return Negate(quotient) if minus else quotient


def _parallel(scene: Scene, a: Vector, b: Vector) -> int:
    """1 or −1 where two unit vectors are parallel, 0 where they are not."""
    if tidy(a.cross(b)) != 0:
        return 0
    return 1 if scene.model.sign(a.dot(b)) > 0 else -1


def _resolved(scene: Scene, kind: str, body: str, stage: int, frame: Frame) -> Source:
    """A component of a velocity of which the components in other directions are known."""
    own = scene.frame(stage)
    parts = [after(scene, axis, body, own) for axis in COMPONENTS]
    direction = frame.direction(kind)
    shares = [tidy(own.direction(axis).dot(direction)) for axis in COMPONENTS]
    put = [_put(scene, part) for part in parts]
    straight = component_at_right_angles(scene, kind, body, stage, frame, put)
    if straight is not None:
        return straight
    value = tidy(sum(a.value * b for a, b in zip(put, shares, strict=True)))
    if kind == "along" and frame.wall is not None and frame.number == stage + 1:
        velocity = Vector(*(part.value for part in put))
        directions = own.direction("along"), own.direction("across")
        beside = sum(a * b.cross(direction) for a, b in zip(velocity, directions, strict=True))
        speed = _whole_speed(scene, body, stage, frame) if tidy(beside) == 0 else None
        if speed is not None:
            return speed
    by_angle = component_by_angle(scene, kind, body, stage, frame, value)
    if by_angle is not None:
        return by_angle
    in_degrees = _are_in_degrees(scene, own, frame) and sum(part.value != 0 for part in put) == 1
    functions = ("cos", "sin") if kind == "along" else ("sin", "cos")
    if in_degrees:
        # By the angle of the velocity to this line of centres, or to this wall.
        functions = (
            ("cos", "cos") if (kind == "along") != (frame.wall is not None) else ("sin", "sin")
        )
    terms = [
        product(
            tree_of(a.value),
            _share_of_degrees(b, function, short=in_degrees)
            or _product_of_units(own.direction(axis), direction, b),
        )
        for axis, a, b, function in zip(COMPONENTS, put, shares, functions, strict=True)
        if a.value
    ]
    if own.direction("along").x == 0:
        terms.reverse()  # along **i** first
    terms.sort(key=lambda term: isinstance(term, Negate))
    quantity = frame.component(kind, body, stage)
    if own.is_slanted and frame.is_slanted and _are_two_terms([source.value for source in put]):
        # Instead of four products of the unit vectors of two slanting lines.
        whole = put_together(body, stage, own, (put[0], put[1]))
        vector = Source(whole.value, (write_formula(scene, whole),))
        return by_scalar_product(scene, quantity, vector, frame, direction)
    refs = together(*(source.whole for source in put), own.unit_free, frame.unit_free)
    move = Move("define", "component", frame.number, (body,))
    first, last = swept(total(terms)), tree_of(value)
    if any(ratio.args[0].is_Add for ratio in value.atoms(sp.sin, sp.cos)):
        number = scene.desk.write(move, refs, chain(quantity, (first, None)))
        refs, move, first = (number,), Move("identity", "sum-of-angles"), last
    exact = {tree: tree_of(tidy(scene.scalar(tree))) for tree in _of_degrees(first)}
    between: tuple[tuple[Expression, MoveId | None], ...] = ()
    if exact and not in_degrees:
        between = ((swept(exchanged(first, exact)), "rearrange"),)
    relation = chain(quantity, (first, None), *between, (last, "rearrange"))
    number = scene.desk.write(move, refs, relation)
    return scene.desk.know(quantity, value, (number,))


def _whole_speed(scene: Scene, body: str, stage: int, frame: Frame) -> Source | None:
    """The component towards a wall of what strikes it at right angles: the speed that stands."""
    speed = scene.desk.known(Quantity("speed", (Name(body),), stage))
    if speed is None or scene.put(speed.value)[1]:
        return None  # a speed in letters that are known now is worked out once more
    beside = in_direction(scene, "across", body, stage, frame)
    quantity = frame.component("along", body, stage)
    relation = chain(quantity, (tree_of(speed.value), None))
    move = Move("define", "component", frame.number, (body,))
    refs = scene.judge.needed(move, together(speed.refs, beside.whole), relation)
    if refs is None:
        return None
    number = scene.desk.write(move, refs, relation)
    return scene.desk.know(quantity, speed.value, (number,))


def _of_degrees(tree: Expression) -> list[Expression]:
    """The sines and cosines of degrees in a tree."""
    return [
        node
        for node in walk(tree)
        if isinstance(node, Apply) and isinstance(node.argument, Degrees)
    ]


def _are_two_terms(values: list[sp.Expr]) -> bool:
    """Whether two components are other than 0, and no sums."""
    return all(values) and not any(value.has(sp.Add) for value in values)


def _are_in_degrees(scene: Scene, *frames: Frame) -> bool:
    """Whether the data tell the lines of impacts by angles, and are not all along the axes."""
    axes = []
    for frame in frames:
        fact = scene.facts.get(f"axis {frame.number}")
        right = None if fact is None else fact.relation.only[-1].right
        axes.append(unsigned(right))
    plain = all(isinstance(axis, Unit | Degrees) for axis in axes)
    return plain and any(isinstance(axis, Degrees) for axis in axes)


def _share_of_degrees(share: sp.Expr, function: str, *, short: bool) -> Expression | None:
    """The sine or cosine of an angle such as 75°, of which the number is long; None of others.

    With ``short`` that of 60° too.
    """
    tree = share_by_degrees(share, function) if short or share.has(sp.Add) else None
    return negative(tree) if tree is not None and share < 0 else tree


def after(scene: Scene, kind: str, body: str, frame: Frame) -> Source:
    """A component just after the impact of a frame, by the law, or by the letter that names it."""
    quantity = frame.component(kind, body, frame.number)
    known = scene.desk.known(quantity)
    if known is not None:
        return known
    given = _given_after(scene, kind, body, frame)
    if given is not None:
        return given
    if frame.number not in scene.model.frames:
        return _of_vector(scene, kind, body, frame, blown(scene, body, frame.number))
    if kind == "across":
        return unchanged(scene, body, frame)
    if frame.wall is not None:
        return rebound(scene, body, frame)
    return named(scene, body, frame)


def _given_after(scene: Scene, kind: str, body: str, frame: Frame) -> Source | None:
    """A component of a velocity after an impact that is given as a vector."""
    velocity = Quantity("velocity", (Name(body),), frame.number)
    given = velocity_given(scene, body, frame.number)
    if given is not None and scene.desk.known(velocity) is None:
        speed = Quantity("speed", velocity.arguments, frame.number)
        is_given = any(equation.link.left == speed for equation in scene.given)
        along = is_given and tidy(given[1].cross(frame.direction(kind))) == 0
        # Along its own direction a velocity has its speed as its component.
        size = tree_of(tidy(given[1].dot(frame.direction(kind)))) if along else None
        return _of_vector(scene, kind, body, frame, Source(given[1], given[2], form=size))
    known = scene.desk.known(velocity)
    if known is None or (
        kind == "across"
        and (_is_by_momentum(scene, known, frame) or _stands_before(scene, known, body, frame))
    ):
        return None  # what stays is known from before
    return _of_vector(scene, kind, body, frame, known)


def _stands_before(scene: Scene, velocity: Source, body: str, frame: Frame) -> bool:
    """Whether the component of a velocity across the impulse has a line before the impact.

    Along a slanting wall in numbers; of spheres where the velocity is what the impulse makes of
    the one before.
    """
    before_ = frame.component("across", body, scene.last_event(body, frame.number - 1))
    known = scene.desk.known(before_)
    if known is None:
        return False
    if frame.wall is None:
        return _rests_on(scene, velocity, "changed-velocity")
    return known.value.is_number and not any(part.free_symbols for part in velocity.value)


def _is_by_momentum(scene: Scene, velocity: Source, frame: Frame) -> bool:
    """Whether a velocity after an impact of two spheres is what is left of the momentum."""
    return frame.wall is None and _rests_on(scene, velocity, "momentum-vector")


def _rests_on(scene: Scene, velocity: Source, record: str) -> bool:
    """Whether a line of this record is among those from which a velocity comes."""
    return any(line.move.record == record for line in scene.desk.lines_under(velocity))


def _of_vector(
    scene: Scene, kind: str, body: str, frame: Frame, source: Source, stage: int | None = None
) -> Source:
    """A component after an event of a velocity that is known as a vector."""
    direction = frame.direction(kind)
    if frame.is_slanted and all(x.is_number for x in frame.n):
        source = _with_its_values(scene, body, frame.number if stage is None else stage, source)
        quantity = frame.component(kind, body, frame.number if stage is None else stage)
        return by_scalar_product(scene, quantity, source, frame, direction, source.form)
    own = Source(tidy(source.value.dot(direction)), source.refs, frame.refs)
    last = _put(scene, own)
    share, letter = own.value.as_coeff_Mul()
    if letter.is_Symbol and last.value.is_number and share not in (0, 1, -1):
        # The size that has been found times the ratio: a reader sees where the number comes from.
        size = tree_of(tidy(last.value / share))
        return replace(last, form=product(size, tree_of(share)))
    return last


def _with_its_values(scene: Scene, body: str, stage: int, source: Source) -> Source:
    """A velocity that is asked with the letters put in that are known: its line stands first."""
    velocity = Quantity("velocity", (Name(body),), stage)
    value, refs = scene.put(source.value)
    line = source.refs[0] if len(source.refs) == 1 else None
    if velocity not in scene.asked_alone or not isinstance(line, int) or source.form is not None:
        return source
    if not refs or scene.unknown(value) or scene.desk.known(velocity) is not source:
        return source
    whole = Vector(*map(tidy, value))
    relation = chain(velocity, (tree_of(whole), None))
    number = scene.desk.write(Move("put"), (line, *refs), relation)
    return scene.desk.know(velocity, whole, (number,))


def blown(scene: Scene, body: str, number: int) -> Source:
    """A velocity after a blow: the impulse is the change of momentum."""
    velocity = Quantity("velocity", (Name(body),), number)
    known = scene.desk.known(velocity)
    if known is not None:
        return known
    given = velocity_given(scene, body, number)
    if given is not None:
        return scene.desk.know(velocity, given[1], given[2])
    fact = scene.facts.get(f"impulse {number}")
    if fact is None:
        raise NotPlannedError(f"the velocity of {body} after event {number}")
    plain = scene.frame(number)
    parts = [in_direction(scene, axis, body, number - 1, plain) for axis in COMPONENTS]
    early = Vector(*(part.value for part in parts))
    mass = scene.mass(body)
    right = fact.relation.only[0].right
    impulse, refs = scene.put(scene.value(right))
    late = Vector(*(tidy(u + j / mass.value) for u, j in zip(early, impulse, strict=True)))
    walls = [
        f"wall {node.name}"
        for node in walk(right)
        if isinstance(node, Name) and f"wall {node.name}" in scene.facts
    ]
    change = difference(velocity, tree_of(early)) if any(early) else velocity
    move = Move("law", "impulse-vector", number, (body,))
    used = together((fact.id,), walls, refs, mass.refs, *(part.whole for part in parts))
    change = swept(product(tree_of(mass.value), change))
    if change == velocity:
        # Of a mass of 1 at rest the impulse is the velocity.
        line = scene.desk.write(move, used, chain(velocity, (tree_of(late), None)))
        return scene.desk.know(velocity, late, (line,))
    left = tree_of(impulse) if refs or isinstance(right, Polar) else right
    line = scene.desk.write(move, used, chain(left, (change, None)))
    line = scene.desk.write(Move("rearrange"), (line,), chain(velocity, (tree_of(late), None)))
    return scene.desk.know(velocity, late, (line,))


def named(scene: Scene, body: str, frame: Frame) -> Source:
    """The letter for a component along the line of centres after an impact, introduced here."""
    symbol = scene.model.components[frame.number, body].symbol
    quantity = frame.component("along", body, frame.number)
    fact = f"let {symbol.name}"
    if fact in scene.facts:
        return scene.desk.know(quantity, frame.letter_sign * symbol, (fact,))
    meaning = Meaning(symbol.name, quantity, frame.sense)
    number = scene.desk.write(Move("let"), (), meaning)
    return scene.desk.know(quantity, frame.letter_sign * symbol, (number,))


def component_letter(scene: Scene, body: str, frame: Frame) -> sp.Symbol:
    """The letter of the model for a component along the line of centres."""
    return scene.model.components[frame.number, body].symbol


# --- laws --------------------------------------------------------------------------------------


def _as_first_written(
    scene: Scene, kind: str, body: str, frame: Frame, source: Source
) -> tuple[Expression, MoveId]:
    """A component before an impact as it comes of the data, and the move to what it is worth."""
    ratio = by_its_ratio(scene, kind, body, frame, source)
    return (tree_in_law(source), "rearrange") if ratio is None else (ratio, "put")


def unchanged(scene: Scene, body: str, frame: Frame) -> Source:
    """The component across the line of centres, or parallel to a wall, is the same after."""
    source = before(scene, "across", body, frame)
    own, by = _as_first_written(scene, "across", body, frame, source)
    quantity = frame.component("across", body, frame.number)
    number = scene.desk.write(
        Move("law", "unchanged", frame.number, (body,)),
        together(source.whole, frame.names_axis("across")),
        chain(quantity, (own, None), (tree_of(source.value), by)),
    )
    return scene.desk.know(quantity, source.value, (number,))


def rebound(scene: Scene, body: str, frame: Frame) -> Source:
    """The component perpendicular to a wall after an impact: −e times the one before."""
    source = before(scene, "along", body, frame)
    e = scene.coefficient(frame.number)
    quantity = frame.component("along", body, frame.number)
    value = neat(-e.value * source.value)
    own, by = _as_first_written(scene, "along", body, frame, source)
    first = product(tree_of(e.value), negative(own))
    last = tree_of(value)
    if is_one(unsigned(own)) and e.value.is_number and e.value not in (0, 1):
        # What e is of is seen: −½ × 1.
        worked = Binary("*", tree_of(e.value), unsigned(own))
        first = worked if isinstance(own, Negate) else Negate(worked)
    elif factors(first) == factors(last):
        first = last  # nothing is worked out
    # Where e is 0 nothing is said of the velocity before.
    before_ = () if e.value == 0 else source.whole
    number = scene.desk.write(
        Move("law", "restitution-wall", frame.number, (body,)),
        together(before_, frame.names_axis("along"), e.refs),
        chain(quantity, (first, None), (last, by)),
    )
    letter = component_letter(scene, body, frame)
    scene.desk.know(Letter(letter.name), frame.letter_sign * value, (number,))
    return scene.desk.know(quantity, value, (number,))


def closing_at_wall(scene: Scene, body: str, frame: Frame, kind: str) -> int:
    """A law at a wall as an equation, where the component after it is known."""
    by_vectors = law_by_vectors(scene, kind, body, frame)
    if by_vectors is not None:
        return by_vectors
    quantity = frame.component(kind, body, frame.number)
    known = scene.desk.known(quantity) or _given_after(scene, kind, body, frame)
    if known is None:
        raise NotPlannedError(f"the component of {body} after event {frame.number}")
    later, earlier = _put(scene, known), before(scene, kind, body, frame)
    refs = together(later.whole, earlier.whole, frame.names_axis(kind))
    if kind == "across":
        move = Move("law", "unchanged", frame.number, (body,))
        sides = [tree_of(later.value), tree_in_law(earlier)]
        open_ = scene.unknown(earlier.value) and not scene.unknown(later.value)
        if open_ or isinstance(sides[1], Letter):
            sides.reverse()
        if all(isinstance(side, Negate) for side in sides):
            sides = [negative(side) for side in sides]  # along the wall in the other sense
        relation = chain(sides[0], (sides[1], None))
        if not scene.judge.follows(move, refs, relation):
            # Beside a vector that is given, one of the data is resolved in the same line.
            whole = (*refs, f"velocity {body}")
            refs = scene.judge.needed(move, whole, relation) or refs
        return scene.desk.write(move, refs, relation)
    e = scene.coefficient(frame.number)
    move = Move("law", "restitution-wall", frame.number, (body,))
    left, right = tree_of(later.value), tree_in_law(earlier)
    back = product(tree_of(e.value), negative(right))
    if scene.model.sign(later.value) < 0:
        if isinstance(right, Negate) and e.value != 1:
            back = Negate(Binary("*", tree_of(e.value), right))  # −⅓(−v cos θ), as it is read off
        else:
            left, back = negative(left), negative(back)
    relation = chain(left, (back, None))
    return scene.desk.write(move, together(refs, e.refs), relation)


def momentum(scene: Scene, frame: Frame) -> int:
    """Conservation of momentum along the line of centres."""
    sides: list[list[Expression]] = [[], []]
    refs: list[Any] = []
    for body in scene.spheres(frame.number):
        mass = scene.mass(body)
        refs += mass.refs
        ends = (before(scene, "along", body, frame), _now(scene, body, frame))
        for side, source in zip(sides, ends, strict=True):
            refs += source.whole
            side.append(_momentum_of(tree_of(mass.value), tree_in_law(source)))
    left, right = map(total, sides)
    return scene.desk.write(
        Move("law", "momentum", frame.number, scene.bodies(frame.number)),
        together(refs, frame.names_axis("along")),
        chain(left, (right, None)),
    )


def _momentum_of(mass: Expression, velocity: Expression) -> Expression:
    """Mass times velocity; of numbers, a negative velocity keeps its sign: 3 × (−2)."""
    if isinstance(velocity, Negate) and mass != ONE and not (letters(mass) or letters(velocity)):
        return Binary("*", mass, velocity)
    return swept(product(mass, velocity))


def restitution(scene: Scene, frame: Frame, separation: sp.Expr | None = None) -> int:
    """Newton's law of restitution between two spheres; with what the ``separation`` comes to."""
    first, second = scene.bodies(frame.number)
    step = scene.model.happening(frame.number).step
    assert isinstance(step, Impact)
    e = scene.coefficient(frame.number)
    early = [before(scene, "along", body, frame) for body in (first, second)]
    late = [_now(scene, body, frame) for body in (first, second)]
    # Where e is 0 nothing is said of the velocities before.
    order = late if e.value == 0 else (*early, *late)
    refs = together(e.refs, *(source.whole for source in order), frame.names_axis("along"))
    v, w = (tree_of(source.value) for source in late)
    u, x = (tree_in_law(source) for source in early)
    approach = difference(u, x)
    # As long as solutions have their lines in common, all write it as the first one does.
    chosen = scene.others[0] if scene.others else scene.model
    if chosen.sign(early[0].value - early[1].value) < 0:
        v, w, approach = w, v, difference(x, u)
        separation = None if separation is None else -separation
    law = chain(ZERO if w == v else difference(w, v), (product(tree_of(e.value), approach), None))
    if separation is not None and scene.judge.standing(law) is None:
        law = chain(law.only[0].left, (law.only[0].right, None), (tree_of(separation), "rearrange"))
    return scene.desk.write(Move("law", "restitution", frame.number, (first, second)), refs, law)


def _now(scene: Scene, body: str, frame: Frame) -> Source:
    """A component after an impact: its value if it is known, else its letter."""
    source = after(scene, "along", body, frame)
    if source.value.is_Symbol:
        settled(scene, Letter(source.value.name))
    return _put(scene, source)


def residual(scene: Scene, number: int) -> sp.Expr:
    """A line as an expression that is zero."""
    own = scene.desk.last_link(number)
    return scene.gap(own.left, own.right)


def scene_value(
    scene: Scene, tree: Expression, others: Mapping[str, sp.Symbol] | None = None
) -> sp.Expr:
    """The value of a tree of a line, with the letters of components, and others, as letters."""
    return scene.worth(tree, others)
