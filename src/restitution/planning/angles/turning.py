"""Angles that are asked: a letter, a ratio of it by components, the angle, and its decimal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import sympy as sp

from restitution.exact import tidy, tidy_angle
from restitution.explaining.lines.derivation import Meaning, Move, Ref, Relation, equality
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    is_function,
    letters,
    unsigned,
    walk,
)
from restitution.planning.angles.along_lines import angle_along_the_centres
from restitution.planning.angles.at_sight import (
    angle_at_sight,
    angle_of_a_multiple,
    angle_on_one_line,
)
from restitution.planning.angles.data_angles import write_as_given
from restitution.planning.angles.decimal_angles import write_decimal
from restitution.planning.angles.directions import (
    along_an_axis,
    along_the_centres,
    direction_of_data,
    direction_ratio,
    in_degrees_of,
)
from restitution.planning.angles.directions_from_walls import direction_from_a_wall
from restitution.planning.angles.from_axes import from_an_axis
from restitution.planning.angles.kept_tangents import multiple_of_a_tangent
from restitution.planning.angles.letters_put import (
    ratio_of_an_answer,
    ratio_that_stands,
    with_letters_put,
)
from restitution.planning.angles.lines_between import (
    angle_of_lines,
    cosine_of,
    is_line,
    is_moving,
    ratio_by_an_offset,
    whole_velocity,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.scalar_angles import (
    write_right_angle,
    write_right_angle_of_axes,
    write_right_angle_of_two,
)
from restitution.planning.angles.standing_turns import turn_of_standing_angles
from restitution.planning.angles.sums_at_walls import write_sum
from restitution.planning.angles.turn_lines import write_turn, write_turn_tangent
from restitution.planning.angles.turned_directions import turn_of_directions
from restitution.planning.angles.vectors_between import (
    by_cosine,
    by_scalar,
    has_its_product,
    is_nested,
    is_right_angle,
    is_vector_in_numbers,
    own_size,
    vectors_in_numbers,
)
from restitution.planning.angles.wall_turns import tangent_at_a_wall
from restitution.planning.angles.walls_at_right_angles import angle_by_walls
from restitution.planning.axes.offsets import turns_from_an_offset
from restitution.planning.closing.cotangents import write_open_angle
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import (
    ANGLES,
    letter_of,
    ratio_line,
    tangent_line,
)
from restitution.planning.formulas.standing_vectors import stand_as_vectors, stand_beside_the_line
from restitution.planning.formulas.turns import turns_of
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    known_speed,
    known_vector,
    size_that_stands,
    velocity_source,
)
from restitution.planning.writing.angle_ratios import range_of
from restitution.planning.writing.angles import angle_of_approach
from restitution.planning.writing.circles import chord_from
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    difference,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.ratio_of_an_angle import RANGES, Ratio
from restitution.planning.writing.same_angles import angle_by_the_same, write_same_angle
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def write_angle(scene: Scene, asked: Expression) -> tuple[int, Relation]:
    """The lines of an angle that is asked: the number of the last, and the answer that it says.

    Raises NotPlannedError where there is no plan for it.
    """
    line = angle_line(scene, quantity_of(scene, asked))
    scene.desk.show(line)
    return write_decimal(scene, line)


def quantity_of(scene: Scene, asked: Expression) -> Quantity:
    """The angle that is asked, or for which a letter of the statement stands."""
    if isinstance(asked, Quantity):
        return asked
    fact = scene.facts.get(f"let {asked.name}") if isinstance(asked, Letter) else None
    quantity = None if fact is None else fact.relation.only[0].left
    if not isinstance(quantity, Quantity):
        raise NotPlannedError("a letter that stands for no angle")
    return quantity


def is_angle(scene: Scene, tree: Expression) -> bool:
    """Whether a tree is an angle of the motion, or a letter of the statement for one."""
    try:
        return quantity_of(scene, tree).kind in ANGLES
    except NotPlannedError:
        return False


def angle_line(scene: Scene, asked: Quantity) -> int:
    """The line that says what an angle is, exactly; it is written once."""
    known = scene.desk.known(asked) or _by_its_letter(scene, asked)
    standing = None if known is None else _with_values(scene, asked, known)
    if standing is not None:
        return standing
    line = None
    if asked.kind == "direction":
        line = direction_of_data(scene, asked) or along_the_centres(scene, asked)
        line = line or direction_from_a_wall(scene, asked, angle_line)
        line = line or along_an_axis(scene, asked)
    for at_once in _AT_ONCE:
        line = line or at_once(scene, asked)
    line = line or angle_by_walls(scene, asked, angle_line)
    if line is None:
        line = turn_of_directions(scene, asked) or _same_angle(scene, asked)
    if line is None:
        known_ratio = ratio_that_stands(scene, asked)
        known_ratio = known_ratio or ratio_of_an_answer(scene, asked, ("cos", "tan"))
        own = known_ratio or _ratio(scene, asked)
        line = own if isinstance(own, int) else _by_inverse(scene, with_letters_put(scene, own))
    scene.desk.know(asked, scene.scalar(scene.desk.last_link(line).right), (line,))
    return line


_AT_ONCE = (
    write_as_given,
    write_right_angle_of_axes,
    angle_at_sight,
    angle_of_a_multiple,
    angle_on_one_line,
    angle_along_the_centres,
)


def _with_values(scene: Scene, asked: Quantity, known: Source) -> int | None:
    """The line of an angle that stands, with the letters put in that have values by now.

    None where they cannot be put in.
    """
    number = next(ref for ref in known.refs if isinstance(ref, int))
    value, refs = scene.put(known.value)
    if not refs:
        return number
    subject = scene.desk.last_link(number).left
    relation = chain(subject, (tree_of(tidy_angle(value), angle=True, as_it_is=True), None))
    premises = scene.judge.enough(Move("put"), (number, *refs), relation)
    if premises is None:
        return None
    line = scene.desk.write(Move("put"), premises, relation)
    scene.desk.know(asked, value, (line,))
    return line


def _same_angle(scene: Scene, asked: Quantity) -> int | None:
    """The line that an angle is one that is known already; None where it is none."""
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, asked)
    line = write_same_angle(scene, asked, letter, meaning)
    value = None if line is None else angle_by_the_same(scene, line)
    if line is None or value is None:
        scene.desk.back(mark)
    elif value == line + 1:
        scene.desk.lines[line - 1] = replace(scene.desk.line(line), shown="inline")
    return value


def _by_its_letter(scene: Scene, asked: Quantity) -> Source | None:
    """An angle for which the working has a letter that is known."""
    for line in scene.desk.lines:
        if isinstance(line.relation, Meaning) and line.relation.quantity == asked:
            return scene.desk.known(Letter(line.relation.letter))
    return None


def _ratio_of_its_letter(
    scene: Scene, function: str, asked: Quantity
) -> tuple[int, Relation] | None:
    """A ratio that stands in a line already, of an angle for which the working has a letter."""
    for other in scene.desk.lines:
        if isinstance(other.relation, Meaning) and other.relation.quantity == asked:
            tree = Apply(function, Letter(other.relation.letter))
            source = scene.desk.known(tree)
            line = None if source is None or len(source.refs) != 1 else source.refs[0]
            if source is None or not isinstance(line, int):
                return None
            relation = scene.desk.relation(line)
            if len(relation.options) > 1:
                return line, relation
            return line, chain(tree, (tree_of(source.value), None))
    return None


def _by_inverse(scene: Scene, own: Ratio) -> int:
    """The line of an angle by its ratio; NotPlannedError where its quadrant is open."""
    if own.open:
        raise NotPlannedError("it is open on which side of j a direction is")
    if own.function == "tan" and own.angle is None:
        try:
            _sign_of_tangent(scene, own)
        except NotPlannedError:
            line = write_open_angle(scene, own.line, own.letter, own.extent)
            if line is None:
                raise
            return line
    angle = own.angle or _angle_of(scene, own)
    if not own.value.free_symbols:
        # The ratio stands as in the line above: 3.2 sin 37° over a component.
        angle = exchanged(angle, {tree_of(own.value): scene.desk.last_link(own.line).right})
    right = rebuilt(angle, _without_inverse)
    named: tuple[Ref, ...] = ()
    if isinstance(right, Binary) and isinstance(right.right, Letter):
        named = (range_of(scene, right.right.name),)  # of 90° − α
    pool = background(scene, letters(right))
    if f"let {own.letter}" in scene.facts:
        pool = (*pool, f"let {own.letter}")  # what the letter stands for tells its quadrant
    refs = together((own.line, own.extent), own.side, named)
    relation, move = chain(Letter(own.letter), (right, None)), Move("inverse")
    premises = scene.judge.enough(move, refs, relation, pool)
    if premises is None:
        raise NotPlannedError("an angle that does not follow from its ratio")
    return scene.desk.write(move, premises, relation)


def _without_inverse(tree: Expression) -> Expression:
    """The angle itself, where its inverse tangent is taken of its tangent."""
    match tree:
        case Apply("arctan", Apply("tan", Letter() as angle)):
            return angle
    return tree


def _sign_of_tangent(scene: Scene, own: Ratio) -> int:
    """The sign of a tangent; NotPlannedError where it is open whether the angle is obtuse."""
    if own.extent.startswith("0°") and "90°" in own.extent:
        return 1
    value = scene.model.in_data(own.value)
    sign = scene.model.proved_sign(value)
    if sign is None:
        raise NotPlannedError("it is open whether an angle is obtuse")
    return sign


def write_ratio(scene: Scene, function: str, angle: Expression) -> tuple[int, Relation]:
    """The line that gives a sine, cosine or tangent of an angle of the motion, and the answer."""
    known = _ratio_of_its_letter(scene, function, quantity_of(scene, angle))
    if known is not None:
        return known
    quantity = quantity_of(scene, angle)
    own = ratio_of_an_answer(scene, quantity, (function,)) or _ratio(scene, quantity, function)
    if isinstance(own, int):
        raise NotPlannedError(f"the {function} of a sum")
    tree = Apply(function, Letter(own.letter))
    if own.function == function:
        value, line = own.value, own.line
        right = scene.desk.last_link(line).right
        if any(is_function(node, "tan") for node in walk(right)):
            return line, chain(tree, (right, None))  # in tan 2α, as the line has it
    else:
        at = {"tan": sp.atan, "cos": sp.acos, "sin": sp.asin}[own.function](own.value)
        if own.function == "tan" and _sign_of_tangent(scene, own) < 0:
            at += sp.pi
        value = tidy({"tan": sp.tan, "cos": sp.cos, "sin": sp.sin}[function](at))
        relation = equality(tree, tree_of(value))
        if not scene.judge.follows(Move("triangle"), (own.line, own.extent), relation):
            raise NotPlannedError(f"the {function} by another ratio")
        line = scene.desk.write(Move("triangle"), (own.line, own.extent), relation)
    return line, chain(tree, (tree_of(value), None))


def _ratio(scene: Scene, asked: Quantity, wanted: str | None = None) -> Ratio | int:
    match asked:
        case Quantity("deflection", (Name(body),), int(event)):
            return _deflection(scene, body, event, asked, wanted)
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity"))):
            return _between(scene, asked, wanted)
        case Quantity("angle", (first, _)) if not is_moving(first):
            return _between_lines(scene, asked)
        case Quantity("angle"):
            try:
                return _to_a_line(scene, asked)
            except NotPlannedError:
                if not isinstance(asked.arguments[1], Name):
                    raise
            return _between_lines(scene, asked)
        case Quantity("direction", (Name(),), int()):
            return direction_ratio(scene, asked, wanted)
    raise NotPlannedError(f"no way to the {asked.kind}")


# --- ratios ------------------------------------------------------------------------------------


def _angle_of(scene: Scene, own: Ratio) -> Expression:
    """The angle of a ratio, of up to 180°."""
    value = own.value
    if own.function == "tan" and (scene.model.proved_sign(value) or 0) < 0:
        size = in_degrees_of(sp.atan(-value), -value)
        if isinstance(size, Degrees):
            return Degrees(STRAIGHT_ANGLE.value - size.value)
        return difference(STRAIGHT_ANGLE, size)
    if own.function == "tan" and value.func is sp.tan and value.args[0].is_Symbol:
        return tree_of(value.args[0])
    if own.function == "tan" and (1 / value).func is sp.tan and (1 / value).args[0].is_Symbol:
        return difference(RIGHT_ANGLE, tree_of((1 / value).args[0]))
    return in_degrees_of(
        {"tan": sp.atan, "cos": sp.acos, "sin": sp.asin}[own.function](value), value
    )


def _to_a_line(scene: Scene, asked: Quantity) -> Ratio:
    """The angle to a wall, to the line of centres, or to **i** or **j**."""
    line_ = asked.arguments[1]
    if (ratio := ratio_by_an_offset(scene, asked, "0° <= {} <= 90°")) is not None:
        return ratio
    to_i_or_j = isinstance(unsigned(line_), Unit)
    extent = RANGES["deflection"] if to_i_or_j else "0° <= {} <= 90°"
    kept = multiple_of_a_tangent(scene, asked, extent)
    if kept is not None:
        return kept
    own = formula(scene, asked)
    if own.move.record == "scalar-angle":
        letter, meaning = letter_of(scene, asked)
        refs = together((meaning,), own.refs)
        line = ratio_line(scene, own.move, refs, Apply("cos", Letter(letter)), own.right, own.value)
        return Ratio(line, letter, "cos", own.value, RANGES["deflection"].format(letter))
    move = Move("define", "tan", own.move.event, own.move.bodies)
    line, letter = tangent_line(scene, asked, own, move)
    return Ratio(line, letter, "tan", own.value, extent.format(letter))


def _between(scene: Scene, asked: Quantity, wanted: str | None) -> Ratio | int:
    """The angle between two velocities, by their tangents or their scalar product."""
    square = write_right_angle_of_two(scene, asked) if wanted is None else None
    if square is not None:
        return square
    pair = [body_and_stage(scene, argument) for argument in asked.arguments]
    in_numbers = all(is_vector_in_numbers(scene, body) for body, _ in pair)
    in_numbers |= stand_as_vectors(scene, pair) or stand_beside_the_line(scene, pair)
    if in_numbers and wanted != "cos" and _is_along_the_line(scene, asked, pair):
        in_numbers = False  # its angle to the line of centres is that of the other one
    turned = _by_turn(scene, asked, wanted) if wanted != "cos" and not in_numbers else None
    if turned is None and wanted == "tan":
        turned = _by_turn(scene, asked, wanted)
    if turned is not None:
        return turned
    if wanted == "tan" or (wanted is None and not in_numbers):
        try:
            own = formula(scene, asked)
        except NotPlannedError:
            pass
        else:
            if own.move.record == "tan" and not is_right_angle(scene, own):
                line, letter = tangent_line(scene, asked, own, own.move)
                return Ratio(line, letter, "tan", own.value, RANGES["deflection"].format(letter))
    sources = [whole_velocity(scene, *state) for state in pair]
    event = max(stage for _, stage in pair) or None
    bodies = tuple(dict.fromkeys(body for body, _ in pair))
    move = Move("define", "scalar-angle", event, bodies)
    one, other = (size_that_stands(scene, *state) for state in pair)
    return by_scalar(scene, move, sources, asked, (one, other))


def _is_along_the_line(scene: Scene, asked: Quantity, pair: Sequence[tuple[str, int]]) -> bool:
    """Whether one of two spheres that have met moves along the line of centres, and one does not.

    Their scalar product is none that a line has, nor are they vectors beside a slanting line of
    centres of which no line has the components.
    """
    (first, late), (second, other) = pair
    if late != other or late not in scene.model.frames or has_its_product(scene, asked):
        return False
    if {first, second} != set(scene.bodies(late)):
        return False
    frame = scene.frame(late)
    components = [frame.component(k, b, s) for k in COMPONENTS for b, s in pair]
    are_new = any(scene.desk.known(component) is None for component in components)
    if frame.is_slanted and are_new and stand_as_vectors(scene, pair):
        return False
    own = [[in_direction(scene, k, b, late, frame) for k in COMPONENTS] for b, _ in pair]
    across = [parts[1].value == 0 for parts in own]
    return across.count(True) == 1 and all(parts[0].value != 0 for parts in own)


def _between_lines(scene: Scene, asked: Quantity) -> Ratio:
    """The angle between directions of the plane, walls and lines of centres, by their product."""
    to_a_line = any(map(is_line, asked.arguments))
    extent = "0° <= {} <= 90°" if to_a_line else RANGES["deflection"]
    if (sine := ratio_by_an_offset(scene, asked, extent)) is not None:
        return sine
    letter, meaning = letter_of(scene, asked)
    own = angle_of_lines(scene, asked)
    refs = together((meaning,), own.refs)
    line = ratio_line(scene, own.move, refs, Apply("cos", Letter(letter)), own.right, own.value)
    return Ratio(line, letter, "cos", own.value, extent.format(letter))


# --- deflections -------------------------------------------------------------------------------


def _deflection(
    scene: Scene, body: str, event: int, asked: Quantity, wanted: str | None
) -> Ratio | int:
    """The cosine or tangent of a deflection; the line of one that is made of two angles."""
    if event not in scene.model.frames:
        from_axis = None if wanted == "cos" else from_an_axis(scene, body, event, asked)
        return from_axis or _turned_by_a_blow(scene, body, event, asked)
    frame = scene.frame(event)
    angle = None if wanted else _by_angles_that_stand(scene, body, event, asked, frame)
    if angle is not None:
        return angle
    turn = _turn(scene, body, event, asked, wanted)
    own_ratio = _by_scalar_product(scene, turn)
    if own_ratio is None and wanted is None and turns_from_an_offset(scene, body, event):
        own_ratio = _by_turn(scene, asked, wanted)
    if own_ratio is None:
        own_ratio = _by_an_angle_that_stands(scene, turn)
    if own_ratio is None:
        own_ratio = _by_whole_velocities(scene, turn)
    if own_ratio is not None:
        return own_ratio
    turned = _by_turn(scene, asked, wanted)
    if turned is not None:
        return turned
    own = formula(scene, asked)
    line, letter = tangent_line(scene, asked, own, own.move)
    return Ratio(line, letter, "tan", own.value, RANGES["deflection"].format(letter))


class _Turn(NamedTuple):
    """A deflection in the frame of its event: the components before and after it."""

    body: str
    event: int
    asked: Quantity
    wanted: str | None
    frame: Frame
    early: tuple[Source, ...]
    late: tuple[Source, ...]
    a: Vector
    b: Vector
    dot: sp.Expr
    cross: sp.Expr


def _turn(scene: Scene, body: str, event: int, asked: Quantity, wanted: str | None) -> _Turn:
    frame = scene.frame(event)
    early, late = (
        tuple(in_direction(scene, kind, body, stage, frame) for kind in COMPONENTS)
        for stage in (event - 1, event)
    )
    a, b = (Vector(*(source.value for source in own)) for own in (early, late))
    dot, cross = tidy(expanded(a.dot(b))), tidy(expanded(a.cross(b)))
    return _Turn(body, event, asked, wanted, frame, early, late, a, b, dot, cross)


def _by_angles_that_stand(
    scene: Scene, body: str, event: int, asked: Quantity, frame: Frame
) -> int | None:
    """A deflection at a wall as a sum of angles that are known, and a right one by squares."""
    if frame.wall and isinstance(angle_of_approach(scene, body, frame), Degrees):
        return write_sum(scene, asked, angle_line)
    if frame.wall and _are_exact(scene, body, event, frame):
        return write_sum(scene, asked, angle_line)
    if frame.wall and chord_from(scene, body, event) is not None:
        beside = in_direction(scene, "across", body, event - 1, frame)
        if not scene.model.identically_zero(beside.value):
            return write_sum(scene, asked, angle_line)  # they are known before the place is
    return write_right_angle(scene, asked, by_squares=True)


def _by_scalar_product(scene: Scene, turn: _Turn) -> Ratio | int | None:
    """The cosine, where it is wanted, or the angle is 0°, 90° or 180°."""
    asked, wanted, frame = turn.asked, turn.wanted, turn.frame
    names = together(frame.names_axis("along"), frame.names_axis("across"))
    refs = together(*(source.whole for source in (*turn.early, *turn.late)), names)
    is_straight = scene.model.identically_zero(turn.cross)
    if wanted is None and is_straight:
        straight = _by_turn(scene, asked, wanted)
        if straight is not None:
            return straight
    is_right = scene.model.identically_zero(turn.dot)
    if is_right and wanted is None:
        line = write_right_angle(scene, asked)
        if line is not None:
            return line
    if wanted == "cos" and frame.wall is None:
        own_ratio = by_cosine(scene, asked)
        if own_ratio is not None:
            return own_ratio
    # A right angle has no tangent, and that of 0° and 180° is the same: cosines tell them apart.
    if not (is_right or wanted == "cos" or is_straight):
        return None
    if frame.wall is not None:
        refs = together(*(source.refs for source in (*turn.early, *turn.late)))
    pairs = [
        (tree_of(p.value), tree_of(q.value)) for p, q in zip(turn.early, turn.late, strict=True)
    ]
    sizes = [size_that_stands(scene, turn.body, stage) for stage in (turn.event - 1, turn.event)]
    right, value = cosine_of(pairs, turn.a, turn.b, sizes)
    if wanted != "cos":
        value = sp.Integer(scene.model.sign(value))
    letter, meaning = letter_of(scene, asked)
    move = Move("define", "scalar-angle", turn.event, (turn.body,))
    refs = together((meaning,), refs, *(own_size(scene, vector) for vector in (turn.a, turn.b)))
    line = ratio_line(scene, move, refs, Apply("cos", Letter(letter)), right, value)
    return Ratio(line, letter, "cos", value, RANGES["deflection"].format(letter))


def _by_an_angle_that_stands(scene: Scene, turn: _Turn) -> Ratio | int | None:
    """A deflection beside an angle to the line of centres, or to an axis."""
    to_the_line = (
        Quantity("velocity", (Name(turn.body),), turn.event),
        Quantity("line_of_centres", (), turn.event),
    )
    first = turn.early[0].value
    if first == 0 and scene.desk.known(Quantity("angle", to_the_line)) and not turn.wanted:
        turned = _by_turn(scene, turn.asked, turn.wanted)  # 90° less an angle that stands
        if turned is not None:
            return turned
    if turn.wanted != "cos" and (turn.frame.is_slanted or first == 0):
        return from_an_axis(scene, turn.body, turn.event, turn.asked)
    return None


def _by_whole_velocities(scene: Scene, turn: _Turn) -> Ratio | int | None:
    """A deflection between two velocities that stand as vectors, or by two angles at a wall."""
    body, event, asked, wanted = turn.body, turn.event, turn.asked, turn.wanted
    both = [(body, event - 1), (body, event)]
    if wanted is None and (beside := turn_of_standing_angles(scene, asked, angle_line)) is not None:
        return beside
    if wanted is None and stand_as_vectors(scene, both):
        sources = [whole_velocity(scene, *state) for state in both]
        return by_scalar(scene, Move("define", "scalar-angle", event, (body,)), sources, asked)
    if turn.frame.wall is not None and wanted is None:
        return write_sum(scene, asked, angle_line)
    if turn.frame.wall is not None and wanted == "tan":
        number = tangent_at_a_wall(scene, asked, turn.frame)
        if number is not None:
            letter, _ = letter_of(scene, asked)
            value = tidy(scene.scalar(scene.desk.last_link(number).right))
            return Ratio(number, letter, "tan", value, RANGES["deflection"].format(letter))
    if (
        wanted != "tan"
        and vectors_in_numbers(scene, body, event, turn.a, turn.b)
        and not is_nested(turn.dot**2 / (turn.dot**2 + turn.cross**2))
    ):
        sources = [velocity_source(scene, body, stage) for stage in (event - 1, event)]
        move = Move("define", "scalar-angle", event, (body,))
        return by_scalar(scene, move, sources, asked)
    return None


def _are_exact(scene: Scene, body: str, event: int, frame: Frame) -> bool:
    """Whether the angle to a wall before an impact is told by another one, and both are degrees.

    That before is told by the angle to the wall from which the body comes, or by its line of
    centres.
    """
    last = scene.last_event(body, event - 1)
    if not last or frame.wall is None:
        return False
    late = [in_direction(scene, kind, body, event, frame) for kind in COMPONENTS]
    if late[0].value == 0 or late[1].value == 0:
        return False
    after = sp.sympify(tidy(late[0].value / late[1].value), strict=True)
    if not after.is_number or not (sp.atan(after) / sp.pi).is_Rational:
        return False
    early = Quantity("angle", (Quantity("velocity", (Name(body),), last), Name(frame.wall)))
    line = angle_along_the_centres(scene, early) or angle_by_walls(scene, early, angle_line)
    if line is None:
        return False
    value = scene.scalar(scene.desk.last_link(line).right)
    scene.desk.know(early, value, (line,))
    return bool(value.is_number)


def _turned_by_a_blow(scene: Scene, body: str, event: int, asked: Quantity) -> Ratio | int:
    """The angle between the velocities before and after a blow; a speed that is given is one."""
    early = velocity_source(scene, body, event - 1)
    late = known_vector(scene, body, event) or velocity_source(scene, body, event)
    speed = known_speed(scene, body, event)
    move = Move("define", "scalar-angle", event, (body,))
    plain = speed is not None and sp.sympify(speed.value, strict=True).is_Rational
    sizes = (None, tree_of(speed.value) if speed is not None and plain else None)
    return by_scalar(scene, move, [early, late], asked, sizes)


def _by_turn(scene: Scene, asked: Quantity, wanted: str | None) -> Ratio | int | None:
    """An angle of two to the line of centres: its line in numbers, in letters its tangent."""
    mark = scene.desk.mark()
    for turn in turns_of(scene, asked):
        line = write_turn(scene, turn, angle_line) if wanted is None else None
        if line is not None:
            return line
        letter, _ = letter_of(scene, asked)
        line = write_turn_tangent(scene, turn, Letter(letter))
        if line is not None:
            value = tidy(scene.scalar(scene.desk.last_link(line).right))
            if wanted is not None or scene.model.proved_sign(scene.model.in_data(value)):
                break
            # Its tangent does not tell whether it is obtuse: the angles themselves do.
            scene.desk.back(mark)
            line = write_turn(scene, turn, angle_line, in_letters=True)
            if line is not None:
                return line
        scene.desk.back(mark)
    else:
        return None
    return Ratio(line, letter, "tan", value, RANGES["deflection"].format(letter))


def turn_in_letters(scene: Scene, asked: Quantity) -> int | None:
    """The line of a deflection by the angles of both paths to one line, with what letters tell.

    Like ``δ = 120° − arctan(√3/e)``; None where both angles are not known so.
    """
    number = asked.stage
    own = scene.model.frames.get(number) if isinstance(number, int) else None
    if own is not None and own.wall is not None:
        return write_sum(scene, asked, angle_line)
    for turn in turns_of(scene, asked):
        mark = scene.desk.mark()
        line = write_turn(scene, turn, angle_line, in_letters=True)
        if line is not None:
            return line
        scene.desk.back(mark)
    return None


__all__ = ["angle_line", "is_angle", "write_angle", "write_decimal", "write_ratio"]
