"""Deflections at a wall as a sum: of the angles of the path to it before and after."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from restitution import exact
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    walk,
)
from restitution.planning.angles.turn_lines import inverse_of_data
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.next_walls import angle_to_a_wall
from restitution.planning.writing.angles import angle_to_a_line, angle_to_its_wall
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import TWO, product, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.given_angles import given_angle, given_by_its_ratio
from restitution.planning.writing.same_angles import by_the_first_letter
from restitution.planning.writing.scene import Scene


def write_sum(scene: Scene, asked: Quantity, angle_line: Callable[[Scene, Quantity], int]) -> int:
    """The line of a deflection at a wall: the angles to it before and after, added.

    ``angle_line`` writes an angle that the data do not give.
    """
    body, event = asked.arguments[0].name, asked.stage  # type: ignore[union-attr]
    assert isinstance(event, int)
    frame = scene.frame(event)
    assert frame.wall is not None
    if (alone := _left_along_the_wall(scene, asked, frame, angle_line)) is not None:
        return alone
    names: list[Expression] = []
    terms: list[Expression] = []
    refs: list[Ref] = []
    total_: Any = 0
    for stage in (event - 1, event):
        velocity = Quantity("velocity", (Name(body),), scene.last_event(body, stage))
        quantity = Quantity("angle", (velocity, Name(frame.wall)))
        inverse = _inverse_as_a_line(scene, quantity)
        if inverse is not None:
            names.append(inverse[0])
            terms.append(scene.desk.last_link(inverse[1][0]).right)
            refs += inverse[1]
            total_ += scene.scalar(terms[-1])
            continue
        given = _given_angle(scene, velocity, frame.wall) or _kept_angle(scene, quantity)
        if given is not None:
            name = tree_of(given.value, angle=True)
            given = _by_its_ratio(scene, given)
            names.append(name)
            terms.append(tree_of(given.value, angle=True))
            refs += given.refs
            total_ += given.value
            continue
        line = angle_line(scene, quantity)
        own = scene.desk.last_link(line)
        value = scene.scalar(own.right)
        total_ += value
        terms.append(own.right)
        if own.left == quantity:
            names.append(own.right)
            refs.append(line)
            continue
        letter, meaning = letter_of(scene, quantity)
        first = None if isinstance(own.right, Degrees) else by_the_first_letter(scene, line)
        if first is not None:
            names.append(first[0])
            refs += [*first[1], meaning]
            continue
        names.append(own.right if isinstance(own.right, Degrees) else Letter(letter))
        refs += [line, meaning]
    right = total(terms)
    value = exact.tidy_angle(total_) if total_.free_symbols else exact.plain_angle(total_)
    if value is None:
        tree = product(TWO, terms[0]) if terms[0] == terms[1] else right
    else:
        tree = tree_of(value, angle=True, as_it_is=True)
    move, pool = Move("define", "sum", event, (body,)), together(refs)
    relation = chain(asked, (right, None), (tree, "rearrange"))
    if not scene.judge.follows(move, pool, relation):
        tree = right  # an inverse ratio by another one
        relation = chain(asked, (right, None))
    named = not any(isinstance(node, Apply) for name in names for node in walk(name))
    if named and total(names) != right:
        by_names = chain(asked, (total(names), None), (right, "put"), (tree, "rearrange"))
        if names[0] == names[-1]:
            twice = product(TWO, names[0])
            by_names = chain(asked, (total(names), None), (twice, "rearrange"), (tree, "put"))
        if scene.judge.follows(move, pool, by_names):
            relation = by_names
    return scene.desk.write(move, pool, relation)


def _inverse_as_a_line(scene: Scene, angle: Quantity) -> tuple[Letter, tuple[int, Ref]] | None:
    """The letter of an angle of which a ratio is given as a number, and the line of its inverse.

    With it what the letter stands for. None where no such ratio is given.
    """
    given = given_by_its_ratio(scene, angle)
    inverse, refs = (None, ()) if given is None else given
    if not isinstance(inverse, Apply):
        return None
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, angle)
    ratio = Apply(inverse.function.removeprefix("arc"), Letter(letter))
    line = scene.judge.write(
        (Move("fact"),), (*refs, meaning), chain(ratio, (inverse.argument, None))
    )
    worth = tree_of(scene.scalar(inverse), angle=True)
    relation = chain(Letter(letter), (worth, None))
    extent = f"0° <= {letter} <= 90°"
    number = line and scene.judge.write((Move("inverse"),), (line, extent), relation)
    if not number:
        scene.desk.back(mark)
        return None
    return Letter(letter), (number, meaning)


def _kept_angle(scene: Scene, angle: Quantity) -> Source | None:
    """The angle after a wall with e = 1 that is a letter of which a ratio is given; else None."""
    match angle.arguments:
        case (Quantity("velocity", (Name(body),), int(stage)), Name(wall)) if stage:
            own = angle_to_a_wall(scene, body, stage, wall)
            return own if own is not None and str(own.value) in scene.ratio_facts else None
    return None


def _left_along_the_wall(
    scene: Scene,
    asked: Quantity,
    frame: Frame,
    angle_line: Callable[[Scene, Quantity], int],
) -> int | None:
    """The deflection of a body that goes on along the wall: the angle to that before."""
    (body,) = asked.arguments
    assert isinstance(body, Name)
    assert frame.wall is not None
    late = in_direction(scene, "along", body.name, frame.number, frame)
    early = Quantity("velocity", (body,), scene.last_event(body.name, frame.number - 1))
    if late.value != 0:
        return None
    angle = _given_angle(scene, early, frame.wall)
    if angle is None:
        line = angle_line(scene, Quantity("angle", (early, Name(frame.wall))))
        named = letter_of(scene, Quantity("angle", (early, Name(frame.wall))))[1]
        own, refs = scene.desk.last_link(line).right, together((line, named))
    else:
        own, refs = tree_of(angle.value, angle=True), angle.refs
    sides = [in_direction(scene, "across", body.name, frame.number - n, frame) for n in (0, 1)]
    pool = together(refs, late.whole, *(side.whole for side in sides), frame.refs)
    move, relation = (
        Move("define", "difference", frame.number, (body.name,)),
        chain(asked, (own, None)),
    )
    premises = scene.judge.needed(move, pool, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def _by_its_ratio(scene: Scene, given: Source) -> Source:
    """An angle by the inverse of a ratio that is given: of itself, its half or its complement."""
    letters = [letter for letter in given.value.free_symbols if str(letter) in scene.ratio_facts]
    if len(letters) != 1:
        return given
    line = inverse_of_data(scene, str(letters[0]))
    value = given.value.subs(letters[0], scene.scalar(scene.desk.last_link(line).right))
    return Source(value, together(given.refs, (line,)))


def _given_angle(scene: Scene, velocity: Quantity, wall: str) -> Source | None:
    """The angle to a wall at which a velocity is given."""
    if velocity.stage:
        angle_ = Quantity("angle", (velocity, Name(wall)))
        own = given_angle(scene, angle_) or given_by_its_ratio(scene, angle_)
        if own is None:
            return None
        value, more = scene.put(scene.scalar(own[0]))
        return Source(value, together(own[1], more))
    (body,) = velocity.arguments
    assert isinstance(body, Name)
    fact = scene.facts.get(f"velocity {body.name}")
    given, line = None, scene.facts.get(f"wall {wall}")
    refs = [ref for ref in (f"velocity {body.name}", f"path {body.name}") if ref in scene.facts]
    match fact.relation.only[0].right if fact is not None else None:
        case Polar(_, angle, wall=Name(name)) if name == wall:
            given = angle_to_its_wall(scene, angle)
        case _ if line is not None:
            given = angle_to_a_line(scene, body.name, line.relation.only[0].right)
            refs.append(line.id)
    if given is None:
        return None
    value, more = scene.put(scene.scalar(given))
    return Source(value, together(refs, more))


__all__ = ["write_sum"]
