"""Lines of centres, and walls, whose direction is worked out: by an impulse or a change."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Literal

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, equality
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.axes.offsets import frame_by_offset
from restitution.planning.axes.radii import frame_by_places, is_by_places
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impulse_formulas import impulse_by_vectors
from restitution.planning.formulas.resolving import along_axis
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.either_side import frame_on_one_side, write_sides
from restitution.planning.writing.forms import product, total, tree_of, vector
from restitution.planning.writing.frames import Frame, frame_of
from restitution.planning.writing.place_trees import AXES
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.unit_vectors import plain_direction, whole_direction
from restitution.planning.writing.vectors import velocity_given
from restitution.solving.story.letters import roles
from restitution.vector import Vector


def frame_at(scene: Scene, number: int) -> Frame:
    """The frame of an impact; where its line is worked out, with the line that finds it.

    Raises NotPlannedError where no impulse and no change of a velocity is known.
    """
    own = scene.model.frames.get(number)
    if own is not None and is_by_places(scene, number):
        return frame_by_places(scene, number, own)
    if own is None:
        return frame_of(scene.model, scene.facts, number)
    if (line := _along_a_velocity(scene, number)) is not None:
        return _frame_by(scene, number, line)
    if f"axis {number}" in scene.facts:
        if number in scene.desk.paths:
            return frame_by_offset(scene, number)
        return _beside_the_path(scene, number)
    if (sided := frame_on_one_side(scene, number)) is not None:
        return sided
    if own.angle is not None or not all(component.is_number for component in own.n):
        raise NotPlannedError(f"the line of centres of event {number} is to be worked out")
    for writer in _WAYS:
        line = writer(scene, number)
        if line is not None:
            return _frame_by(scene, number, line)
    raise NotPlannedError(f"the line of centres of event {number} is to be worked out")


def _frame_by(scene: Scene, number: int, line: int) -> Frame:
    """The frame of an impact of which a line tells the line of centres."""
    own = scene.model.frames[number]
    n = -own.n if own.wall is not None else own.n
    refs = (_plainly(scene, number, line, n),)
    centres = Quantity("line_of_centres", (), number)
    sign = 1 if scene.model.sign(n.dot(own.n)) > 0 else -1
    return Frame(number, own.wall, centres, None, n, n.turned_left(), refs, sign)


def _along_a_velocity(scene: Scene, number: int) -> int | None:
    """The line of centres along a velocity after an earlier impact, as that is, by components.

    None of any other line, and where the velocity is not known yet, or is along an axis.
    """
    own, fact = scene.model.frames[number], scene.facts.get(f"axis {number}")
    match None if fact is None else fact.relation.only:
        case (Link(_, "parallel to", Quantity("velocity", (Name(body),), int(stage))),):
            pass
        case _:
            return None
    assert fact is not None
    if not stage or not all(component.is_number for component in own.n) or 0 in own.n:
        return None
    parts = [along_axis(scene, body, stage, axis) for axis in AXES]
    if any(scene.unknown(part.value) for part in parts):
        return None
    value = Vector(*(part.value for part in parts))
    relation = Relation(
        ((Link(fact.relation.only[0].left, "parallel to", tree_of(plain_direction(value))),),)
    )
    refs = together((fact.id,), *(part.refs for part in parts))
    return scene.judge.write((Move("put"),), refs, relation, refs)


def _beside_the_path(scene: Scene, number: int) -> Frame:
    """The frame of the data; where it is told by an offset, the line of centres is a line first."""
    frame = frame_of(scene.model, scene.facts, number)
    match scene.facts[f"axis {number}"].relation.only:
        case (Link(_, "=", Polar(_, Apply("arcsin"))),):
            return replace(frame, write=lambda: (write_axis(scene, number),))
    return frame


def _plainly(scene: Scene, number: int, line: int, n: Vector) -> int:
    """The direction by a vector of whole numbers, where there is one."""
    centres = Quantity("line_of_centres", (), number)
    tree = vector(*map(tree_of, plain_direction(n)))
    relation = Relation(((Link(centres, "parallel to", tree),),))
    if scene.desk.relation(line) == relation:
        return line
    return scene.desk.write(Move("rearrange"), (line,), relation)


# --- ways --------------------------------------------------------------------------------------


def _by_impulse(scene: Scene, number: int) -> int | None:
    """An impulse that is given as a vector, or as parallel to one, or that a line tells."""
    for equation in scene.given:
        match equation.link:
            case Link(Quantity("impulse", (Name(body),), event), "=" | "parallel to", right):
                if event == number:
                    return _parallel(scene, "across-the-impulse", number, body, (equation,), right)
    for body in scene.spheres(number):
        known = scene.desk.known(Quantity("impulse", (Name(body),), number))
        if known is None or not isinstance(known.value, Vector):
            continue
        if not any(map(scene.unknown, known.value)):
            tree = tree_of(known.value)
            return _write(scene, "across-the-impulse", number, body, known.refs, tree)
    return None


def _by_change(scene: Scene, number: int) -> int | None:
    """A velocity that is known before and after; where its impulse is asked too, by that."""
    for body in scene.spheres(number):
        late = velocity_given(scene, body, number)
        if late is None:
            continue
        fact = scene.facts.get(f"velocity {body}")
        if fact is None or scene.last_event(body, number - 1):
            continue
        early = fact.relation.only[0].right
        source = scene.initial(body)
        if any(scene.unknown(value) for value in (*source.value, *late[1])):
            continue
        line = _by_its_impulse(scene, number, body)
        if line is not None:
            return line
        value = scene.model.story.evaluator(scene.events).vector(early)
        change: Expression = late[0]
        if any(value):
            change = Binary("-", late[0], early)
        refs = together(source.refs, late[2])
        line = _write(scene, "along-the-change", number, body, refs, change)
        return _worked_out(scene, number, line, late[1] - value) if any(value) else line
    return None


def _by_its_impulse(scene: Scene, number: int, body: str) -> int | None:
    """The impulse on a body that is asked, and the line along it: its change is found once.

    None where neither it nor its size is asked, or the mass is open.
    """
    impulse = Quantity("impulse", (Name(body),), number)
    size = Quantity("impulse", (), number)
    if not {impulse, size} & set(scene.asked_alone) or scene.unknown(scene.mass(body).value):
        return None
    own = impulse_by_vectors(scene, impulse, body, number)
    line = write_formula(scene, own)
    right = scene.desk.last_link(line).right
    return _write(scene, "across-the-impulse", number, body, (line,), right)


def _worked_out(scene: Scene, number: int, line: int, change: Vector) -> int:
    """The line of what a change of velocity comes to, where that is not the direction itself."""
    put, refs = scene.put(change)
    whole = Vector(*(tidy(component) for component in put))
    own = scene.model.frames[number]
    final = plain_direction(-own.n if own.wall is not None else own.n)
    if refs or whole == final:
        return line
    centres = Quantity("line_of_centres", (), number)
    relation = Relation(((Link(centres, "parallel to", tree_of(whole)),),))
    return scene.judge.write((Move("rearrange"),), (line,), relation) or line


def _by_who_rested(scene: Scene, number: int) -> int | None:
    """The direction after the impact of a sphere that was at rest: it moves off along the line."""
    for body in scene.spheres(number):
        if scene.last_event(body, number - 1) or f"velocity {body}" not in scene.facts:
            continue
        source = scene.initial(body)
        velocity = Quantity("velocity", (Name(body),), number)
        if any(source.value):
            continue
        for equation in scene.given:
            match equation.link:
                case Link(Quantity("direction", (Name(name),), event), "=", angle) if (
                    name == body and event == number
                ):
                    turn = scene.scalar(angle)
                    right: Any = Vector(tidy(sp.cos(turn)), tidy(sp.sin(turn)))
                    more: tuple[Ref, ...] = ()
                case Link(left, "parallel to" | "perpendicular to", other) if velocity in (
                    left,
                    other,
                ):
                    known = _direction(scene, other if left == velocity else left)
                    if known is None:
                        continue
                    right, more = known.value, known.refs
                case _:
                    continue
            refs = together(source.refs, (equation.fact.id,), more)
            tree = tree_of(tuple(map(tidy, plain_direction(right))))
            sign: Literal["parallel to", "perpendicular to"] = "parallel to"
            if equation.link.sign == "perpendicular to":
                sign = "perpendicular to"
            return _write(scene, "along-the-change", number, body, refs, tree, sign)
    return None


def _direction(scene: Scene, tree: Expression) -> Source | None:
    """A direction of the plane, or that of a velocity that is known; None of any other."""
    match tree:
        case Quantity("velocity", (Name(body),), int(stage)):
            velocity = Quantity("velocity", (Name(body),), scene.last_event(body, stage))
            known = scene.desk.known(velocity)
            if known is None:
                return None
            value, refs = scene.put(known.value)
            return Source(value, together(known.refs, refs))
    if has_quantity(tree):
        return None
    return Source(scene.model.story.direction(tree, scene.events), ())


def _parallel(
    scene: Scene,
    record: str,
    number: int,
    body: str,
    given: Iterable[GivenEquation],
    right: Expression,
) -> int:
    refs = together(equation.fact.id for equation in given)
    value = scene.value(right)
    if not isinstance(value, Vector):
        raise NotPlannedError("an impulse along a direction at an angle")
    return _write(scene, record, number, body, refs, by_components(scene, right))


def by_components(scene: Scene, tree: Expression) -> Expression:
    """A vector by its components, where it is typed by a size and an angle."""
    if not any(isinstance(node, Polar) for node in walk(tree)):
        return tree
    return tree_of(tuple(map(tidy, scene.vector(tree))))


def _write(
    scene: Scene,
    record: str,
    number: int,
    body: str,
    refs: Iterable[Ref],
    right: Expression,
    sign: Literal["parallel to", "perpendicular to"] = "parallel to",
) -> int:
    centres = Quantity("line_of_centres", (), number)
    move, refs = Move("law", record, number, (body,)), tuple(refs)
    plain = _without_a_scalar(scene, right)
    shorter = None if plain is None else Relation(((Link(centres, sign, plain),),))
    if shorter is not None and scene.judge.follows(move, refs, shorter):
        return scene.desk.write(move, refs, shorter)
    return scene.desk.write(move, refs, Relation(((Link(centres, sign, right),),)))


def _without_a_scalar(scene: Scene, tree: Expression) -> Expression | None:
    """The direction of a multiple of a vector of numbers by letters, in its sense; None of another.

    A scalar of which the sign is open leaves the sense open too. A difference of two vectors is to
    be worked out first.
    """
    units = [node for node in walk(tree) if isinstance(node, Unit)]
    if len(units) > len(set(units)):
        return None
    if not letters(tree) or not isinstance(value := scene.value(tree), Vector):
        return None
    plain = plain_direction(value)
    if not all(component.is_number for component in plain):
        return None
    scalar = value.dot(plain)
    if scalar.free_symbols & set(scene.model.final):
        # Its sign is not known yet: how the bodies approach tells the sense.
        sense = -1 if next(filter(None, plain)) < 0 else 1
    else:
        sense = -1 if proved_sign(Oracle(roles(scene.problem)), scalar) == -1 else 1
    return vector(*(tree_of(sense * component) for component in plain))


_WAYS: tuple[Callable[[Scene, int], int | None], ...] = (
    _by_impulse,
    _by_who_rested,
    _by_change,
)


def write_wall(scene: Scene, wall: str) -> int:
    """The direction of a wall that is found: perpendicular to the line of the impulse."""
    number = next((n for n, frame in scene.model.frames.items() if frame.wall == wall), None)
    if number is None or f"axis {number}" in scene.facts:
        return _wall_of_the_data(scene, wall)
    if (sides := write_sides(scene, number)) is not None:
        return sides
    frame = scene.frame(number)
    direction = Quantity("direction", (Name(wall),))
    (body,) = scene.spheres(number)
    known = scene.desk.known(Quantity("line_of_centres", (), number))
    normal = whole_direction(frame.n)[0] if known is None else known.value
    line = scene.desk.write(
        Move("law", "wall-direction", number, (body,)),
        frame.refs,
        Relation(((Link(direction, "perpendicular to", vector(*map(tree_of, normal))),),)),
        "silent" if any(isinstance(ref, int) for ref in frame.refs) else "line",
    )
    along = whole_direction(frame.t)[0] if known is None else normal.turned_left()
    if scene.model.sign(along.x) < 0:
        along = -along
    return scene.desk.write(
        Move("rearrange"),
        (line,),
        Relation(((Link(direction, "parallel to", vector(*map(tree_of, along))),),)),
    )


def _wall_of_the_data(scene: Scene, wall: str) -> int:
    """The direction of a wall that is given in letters, with those put in that are known.

    Raises NotPlannedError where none of them is.
    """
    direction = Quantity("direction", (Name(wall),))
    fact = scene.facts.get(f"wall {wall}")
    known = None if fact is None else scene.value(fact.relation.only[0].right)
    if fact is None or not isinstance(known, Vector):
        raise NotPlannedError("the direction of a wall of the data")
    put, refs = scene.put(known)
    line: int | None = None
    for tree in dict.fromkeys(tree_of(change) for change in (put, plain_direction(put))):
        relation = Relation(((Link(direction, "parallel to", tree),),))
        move = Move("put") if line is None else Move("rearrange")
        sources = together((fact.id,), refs) if line is None else (line,)
        sources = (*sources, *background(scene, letters(tree)))
        line = scene.judge.write((move,), sources, relation) or line
    if line is None or not refs:
        raise NotPlannedError("the direction of a wall of the data")
    return line


def write_axis(scene: Scene, number: int) -> int:
    """A line of centres of the data as a line, from the first sphere to the second, or to the wall.

    Raises NotPlannedError where the statement gives its direction in the other sense.
    """
    fact = scene.facts.get(f"axis {number}")
    if fact is None:
        raise NotPlannedError("a line of centres that is not given")
    centres = Quantity("line_of_centres", (), number)
    own, refs = scene.put(scene.vector(centres))
    link = fact.relation.only[0]
    if link.sign == "=":
        given = scene.vector(link.right)
        if scene.model.sign(given.dot(own)) < 0:
            raise NotPlannedError("a line of centres that is given in the other sense")
        move = Move("fact")
    else:
        own, _ = whole_direction(own)
        move = Move("rearrange")
    final = tree_of(tuple(map(tidy, own)))
    relation = Relation(((Link(centres, link.sign, final),),))
    if (turned := _turned_from_the_path(scene, link.right)) is not None:
        relation = chain(centres, (turned, None), (final, "rearrange"))
    premises = together((fact.id,), refs)
    frame = scene.model.frames[number]
    if frame.angle is not None:
        # By its angle with the path: the letter of that has its meaning in a line.
        turned = tree_of(tuple(frame.n))
        relation = chain(centres, (turned, None), (final, "put"))
        premises = together(premises, scene.frame(number).refs)
    names = {symbol.name for x in own for symbol in sp.sympify(x, strict=True).free_symbols}
    enough = scene.judge.enough(move, premises, relation, background(scene, names))
    return scene.desk.write(move, premises if enough is None else enough, relation)


def _turned_from_the_path(scene: Scene, given: Expression) -> Expression | None:
    """A line of centres by an offset as the direction of a slanting path, turned by an angle.

    That is its cosine times one unit vector and its sine times the other. None of a path along
    **i** or **j**, or with letters.
    """
    match given:
        case Polar(_, Apply("arcsin", sine), path) if path is not None:
            turn, direction = tidy(sp.asin(scene.scalar(sine))), scene.vector(path)
        case _:
            return None
    whole, length = whole_direction(direction)
    if turn == 0 or turn.free_symbols or not all(whole) or any(x.free_symbols for x in whole):
        return None
    angle = tree_of(turn, angle=True)
    ratios: list[Expression] = [Apply(name, angle) for name in ("cos", "sin")]
    if not (turn / sp.pi).is_Rational:
        ratios = [tree_of(tidy(ratio(turn))) for ratio in (sp.cos, sp.sin)]
    units = (tree_of(whole), tree_of(whole.turned_left()))
    return total(
        product(ratio, Binary("/", unit, tree_of(length)))
        for ratio, unit in zip(ratios, units, strict=True)
    )


# --- impulses that are given --------------------------------------------------------------------


def take_impulse(scene: Scene, given: GivenEquation) -> None:
    """The velocity after an impulse that is given as a vector: impulse = change of momentum."""
    match given.link:
        case Link(Quantity("impulse", (Name(body),), int(event)), "=", right):
            _take(scene, body, event, right, given.refs)
        case _:
            raise NotPlannedError("no impulse of a body")


def take_known_impulse(scene: Scene, body: str, event: int) -> bool:
    """The velocity of a sphere by the impulse on it, where a line tells that as a vector.

    Nothing is written, and False returned, where the impulse comes by components, its mass or its
    velocity before is open, or the velocity before is no vector of the data.
    """
    known = scene.desk.known(Quantity("impulse", (Name(body),), event))
    velocity = scene.facts.get(f"velocity {body}")
    if known is None or not isinstance(known.value, Vector) or velocity is None:
        return False
    if not rests_on_vectors(scene, known):
        return False
    if scene.last_event(body, event - 1) or scene.unknown(scene.mass(body).value):
        return False
    if any(isinstance(node, Polar) for node in walk(velocity.relation.only[0].right)):
        return False
    early = scene.initial(body).value
    if any(map(scene.unknown, (*early, *known.value))) or any(scene.put(known.value)[1]):
        return False
    _take(scene, body, event, tree_of(known.value), known.refs)
    return True


def rests_on_vectors(scene: Scene, impulse: Source) -> bool:
    """Whether an impulse comes by changes of velocities as vectors, with no component under it."""
    records = {line.move.record for line in scene.desk.lines_under(impulse)}
    return records <= {None, "impulse-vector", "impulse-direction", "opposite-impulses"}


def take_opposite(scene: Scene, given: GivenEquation) -> str | None:
    """The same of the other sphere, on which the impulse is equal and opposite: which one that is.

    None where nothing is written, as its mass is open, or its velocity before is not of the data.
    """
    match given.link:
        case Link(Quantity("impulse", (Name(body),), int(event)), "=", right):
            others = [sphere for sphere in scene.spheres(event) if sphere != body]
        case _:
            return None
    if len(others) != 1:
        return None
    (other,) = others
    velocity = f"velocity {other}"
    if scene.last_event(other, event - 1) or velocity not in scene.facts:
        return None
    (start,) = scene.facts[velocity].relation.only
    polar = any(isinstance(node, Polar) for node in walk(start.right))
    if polar or scene.unknown(scene.mass(other).value):
        return None
    opposite = tree_of(tuple(tidy(-value) for value in scene.vector(right)))
    plain = isinstance(right, Negate) and not isinstance(right.operand, Polar)
    impulse = right.operand if isinstance(right, Negate) and plain else opposite
    line = scene.desk.write(
        Move("law", "opposite-impulses", event, scene.bodies(event)),
        given.refs,
        equality(Quantity("impulse", (Name(other),), event), impulse),
    )
    _take(scene, other, event, impulse, (line,))
    return other


def _take(scene: Scene, body: str, event: int, impulse: Expression, refs: tuple[Ref, ...]) -> None:
    mass, early = scene.mass(body), scene.initial(body)
    if scene.last_event(body, event - 1):
        raise NotPlannedError("an impulse after an earlier event")
    velocity = Quantity("velocity", (Name(body),), event)
    if scene.unknown(mass.value):
        raise NotPlannedError("an impulse on a sphere whose mass is open")
    push, impulse = scene.vector(impulse), by_components(scene, impulse)
    late = Vector(*(tidy(u + p / mass.value) for u, p in zip(early.value, push, strict=True)))
    before = tree_of(early.value)
    change: Expression = velocity
    if any(early.value):
        change = Binary("-", velocity, before)
        if isinstance(before, Negate):
            change = Binary("+", velocity, before.operand)
    line = scene.desk.write(
        Move("law", "impulse-vector", event, (body,)),
        together(refs, mass.refs, early.refs),
        equality(impulse, Binary("*", tree_of(mass.value), change)),
    )
    line = scene.desk.write(Move("rearrange"), (line,), equality(velocity, tree_of(late)))
    scene.desk.know(velocity, late, (line,))


__all__ = [
    "frame_at",
    "rests_on_vectors",
    "take_impulse",
    "take_known_impulse",
    "take_opposite",
    "write_axis",
]
