"""The angle of a path to a wall by that to the wall from which it comes, and components by it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy, tidy_angle
from restitution.exact.symbols import symbol_names
from restitution.explaining.definitions.next_walls import made_of
from restitution.explaining.lines.derivation import Move, MoveId, Ref, Showing, numbers_in
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    Unit,
    letters,
)
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.writing.angles import angle_of_approach, data_of_approach
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import negative, product, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.given_angles import given_angle
from restitution.planning.writing.scene import Scene

_RATIOS = (sp.sin, sp.cos, sp.tan)


def angle_to_a_wall(scene: Scene, body: str, stage: int, wall: str) -> Source | None:
    """The angle to a wall of a velocity after a wall, in degrees or in letters; None without one.

    It is one that stands, that of the path before at a wall with e = 1, or is made of the angle to
    the wall from which the body comes.
    """
    frame = scene.model.frames.get(stage)
    if frame is None or frame.wall is None or circle_of(scene, stage) is not None:
        return None
    asked = Quantity("angle", (Quantity("velocity", (Name(body),), stage), Name(wall)))
    known = standing_angle(scene, asked)
    if known is not None:
        return known if _is_plain(scene, known) else None
    if wall == frame.wall:
        return _kept(scene, asked, body, stage)
    return _by_the_last(scene, asked, body, stage)


def standing_angle(scene: Scene, angle: Quantity) -> Source | None:
    """What an angle is by a line, of it or of the letter that names it, or by a given fact."""
    known = scene.desk.known(angle) or _given(scene, angle)
    named = letter_known(scene, angle)
    if named is None:
        return known
    by_letter = scene.desk.known(Letter(named[0]))
    own = by_letter or known
    return None if own is None else Source(own.value, together(own.refs, (named[1],)))


def _given(scene: Scene, angle: Quantity) -> Source | None:
    """What an angle is given as."""
    given = given_angle(scene, angle)
    return None if given is None else Source(scene.scalar(given[0]), given[1])


def _is_plain(scene: Scene, angle: Source) -> bool:
    """Whether an angle is a number of degrees, or made of letters for angles that are given."""
    value = sp.sympify(angle.value, strict=True)
    if value.is_number:
        return _is_by_calculator(value) or bool(sp.sympify(value / sp.pi, strict=True).is_Rational)
    return value.is_polynomial(*value.free_symbols) and not scene.unknown(value)


def _is_by_calculator(angle: sp.Expr) -> bool:
    """Whether an angle is made of the inverse of a tangent that only a calculator knows."""
    return any(inverse.has(*_RATIOS) for inverse in angle.atoms(sp.atan))


def _kept(scene: Scene, asked: Quantity, body: str, stage: int) -> Source | None:
    """The angle after a wall with e = 1: it is that before, which the data tell, or a line."""
    if scene.coefficient(stage).value != 1:
        return None
    frame = scene.frame(stage)
    last = scene.last_event(body, stage - 1)
    if last:
        assert frame.wall is not None
        own = angle_to_a_wall(scene, body, last, frame.wall)
        if own is None:
            return None
    else:
        angle = angle_of_approach(scene, body, frame)
        if angle is None:
            return None
        own = Source(scene.scalar(angle), data_of_approach(scene, body, frame))
    move = Move("define", "difference", stage, (body,))
    relation = chain(asked, (tree_of(own.value, angle=True), None))
    refs = scene.judge.needed(move, together(own.refs, scene.coefficient(stage).refs), relation)
    if refs is None:
        return None
    return scene.desk.know(asked, own.value, (scene.desk.write(move, refs, relation),))


def _by_the_last(scene: Scene, asked: Quantity, body: str, stage: int) -> Source | None:
    """The angle to a wall by that to the wall from which a body comes, and their directions."""
    frame = scene.frame(stage)
    velocity, wall = asked.arguments
    assert isinstance(wall, Name)
    assert frame.wall is not None
    here, there = (turn_of_wall(scene, name) for name in (frame.wall, wall.name))
    if here is None or there is None:
        return None
    mark = scene.desk.mark()
    known = angle_to_a_wall(scene, body, stage, frame.wall)
    if known is None:
        return None
    first = Quantity("angle", (velocity, Name(frame.wall)))
    walls = (f"wall {frame.wall}", f"wall {wall.name}")
    letters_in = {name for tree in (here, there) for name in letters(tree)}
    pool = together(known.refs, walls, _ranges(scene, letters_in | _names(known)))
    move = Move("define", "difference", stage, (body,))
    by_calculator = _is_by_calculator(known.value)
    size = _on_paper(scene, known, "inverse") if by_calculator else tree_of(known.value, angle=True)
    for sense in (1, -1):
        for difference in made_of(here, there, first, sense):
            tree = _in_the_corner(exchanged(difference, {first: size}))
            value = scene.scalar(tree) if by_calculator else tidy_angle(scene.scalar(tree))
            if value.is_number and not 0 <= value <= sp.pi / 2:
                continue
            final = tree if by_calculator else tree_of(value, angle=True, as_it_is=True)
            relation = chain(asked, (tree, None), (final, "rearrange"))
            refs = scene.judge.needed(move, pool, relation, known.refs)
            if refs is not None:
                return scene.desk.know(asked, value, (scene.desk.write(move, refs, relation),))
    scene.desk.back(mark)
    return None


def _in_the_corner(angle: Expression) -> Expression:
    """What a corner and the angle before leave of a triangle: ``180° − 72° − β`` for ``108° − β``.

    So the angle of the corner is the one in which the body runs.
    """
    match angle:
        case Binary("-", Degrees(turn), early) if turn != RIGHT_ANGLE.value:
            corner = Degrees(STRAIGHT_ANGLE.value - turn)
            return Binary("-", Binary("-", STRAIGHT_ANGLE, corner), early)
    return angle


def _on_paper(scene: Scene, known: Source, *moves: MoveId) -> Expression:
    """What stands as a line by one of the moves says it."""
    lines = (scene.desk.line(ref) for ref in known.refs if isinstance(ref, int))
    sides = (scene.desk.last_link(e.number).right for e in lines if e.move.id in moves)
    return next(sides, tree_of(known.value, angle="inverse" in moves))


def _names(angle: Source) -> frozenset[str]:
    return symbol_names(sp.sympify(angle.value, strict=True))


def _ranges(scene: Scene, names: Iterable[str]) -> list[Ref]:
    """The inequalities that are given of letters."""
    return [ref for name in sorted(names) for ref in scene.judge.ranges_given(name)]


def turn_of_wall(scene: Scene, wall: str) -> Expression | None:
    """The angle from **i** at which a wall is given, in degrees or as a letter."""
    fact = scene.facts.get(f"wall {wall}")
    right = None if fact is None else fact.relation.only[0].right
    match right:
        case Unit(axis):
            return Degrees(Fraction(90 if axis == "j" else 0))
        case Degrees() | Letter():
            return right
    return None


def component_by_angle(
    scene: Scene, kind: str, body: str, stage: int, frame: Frame, value: sp.Expr
) -> Source | None:
    """A component before a wall, of a body that comes from another one: u sin 30°, by a line.

    None where its angle to the wall is not exact, or its speed does not stand.
    """
    if frame.wall is None or circle_of(scene, frame.number) is not None:
        return None
    mark = scene.desk.mark()
    source = _by_angle(scene, kind, body, stage, frame, value)
    if source is None:
        scene.desk.back(mark)
    return source


def _by_angle(
    scene: Scene, kind: str, body: str, stage: int, frame: Frame, value: sp.Expr
) -> Source | None:
    assert frame.wall is not None
    angle = angle_to_a_wall(scene, body, stage, frame.wall)
    speed = None if angle is None else _speed(scene, body, stage)
    if speed is None or angle is None:
        return None
    if (tidy(value) == 0) != (kind == "across" and angle.value == sp.pi / 2):
        return None
    function = "sin" if kind == "along" else "cos"
    ratio = (sp.sin if kind == "along" else sp.cos)(angle.value)
    size = speed.value * ratio
    sign = -1 if scene.model.sign(value) < 0 else 1
    by_calculator = _is_by_calculator(angle.value)
    whole = _on_paper(scene, speed, "define") if by_calculator else tree_of(speed.value)
    form = product(whole, Apply(function, tree_of(angle.value, angle=True)))
    if angle.value == sp.pi / 2:
        form = tree_of(tidy(size))  # it strikes the wall at right angles
    form = form if sign == 1 else negative(form)
    final = value if angle.value.is_number else sign * size
    quantity = frame.component(kind, body, stage)
    move = Move("define", "component", frame.number, (body,))
    last = tidy(final)
    kept = angle.value.is_number and last.has(sp.sin, sp.cos)  # u sin 55°, and not u cos 35°
    relation = chain(quantity, (form, None), (form if kept else tree_of(last), "rearrange"))
    pool = together(speed.refs, angle.refs, _ranges(scene, _names(angle)))
    refs = scene.judge.needed(move, pool, relation, (*speed.refs, *angle.refs))
    if refs is None:
        return None
    # Who strikes a wall at right angles has no component along it, which nobody writes down.
    shown: Showing = "silent" if tidy(final) == 0 else "line"
    return scene.desk.know(quantity, final, (scene.desk.write(move, refs, relation, shown),))


def _speed(scene: Scene, body: str, stage: int) -> Source | None:
    """A speed that stands, or that at a wall with e = 1, which is the one before it."""
    speed = Quantity("speed", (Name(body),), stage)
    known = scene.desk.known(speed)
    if known is not None:
        return known
    if scene.coefficient(stage).value != 1:
        return _by_what_stays(scene, speed, body, stage)
    before = _speed_before(scene, body, scene.last_event(body, stage - 1))
    if before is None:
        return None
    move = Move("define", "speed", stage, (body,))
    relation = chain(speed, (tree_of(before.value), None))
    refs = scene.judge.needed(move, together(before.refs, scene.coefficient(stage).refs), relation)
    if refs is None:
        return None
    return scene.desk.know(speed, before.value, (scene.desk.write(move, refs, relation),))


def _speed_before(scene: Scene, body: str, last: int) -> Source | None:
    """A speed with which a body comes to a wall: by a line, of the data, or kept at walls."""
    if last:
        known = scene.desk.known(Quantity("speed", (Name(body),), last))
        return known or (_speed(scene, body, last) if _is_elastic(scene, last) else None)
    fact = scene.facts.get(f"velocity {body}")
    right = None if fact is None else fact.relation.only[0].right
    size = right.size if isinstance(right, Polar) else None
    return None if size is None else Source(scene.scalar(size), (f"velocity {body}",))


def _is_elastic(scene: Scene, number: int) -> bool:
    """Whether an impact is one with a wall that has e = 1."""
    frame = scene.model.frames.get(number)
    return frame is not None and frame.wall is not None and scene.coefficient(number).value == 1


def speed_kept(scene: Scene, asked: Quantity) -> int | None:
    """The line of a speed after walls with e = 1, which is that before; None of any other."""
    match asked:
        case Quantity("speed", (Name(body),), int(stage)):
            last = scene.last_event(body, stage)
        case _:
            return None
    if scene.desk.known(replace(asked, stage=last)) is not None or not _is_elastic(scene, last):
        return None
    mark = scene.desk.mark()
    own = _speed(scene, body, last)
    line = None if own is None else next(iter(numbers_in(own.refs)), None)
    if own is None or scene.unknown(own.value) or line is None:
        scene.desk.back(mark)
        return None
    return line


def _by_what_stays(scene: Scene, speed: Quantity, body: str, stage: int) -> Source | None:
    """A speed after a wall by the component along it and the angle with it, one of degrees."""
    frame = scene.frame(stage)
    stays = scene.desk.known(frame.component("across", body, stage))
    asked = Quantity("angle", (Quantity("velocity", (Name(body),), stage), Name(frame.wall or "")))
    angle = standing_angle(scene, asked)
    if stays is None or angle is None or not _is_plain(scene, angle) or not angle.value.is_number:
        return None
    component, more = scene.put(stays.value)
    size = -component if scene.model.sign(component) < 0 else component
    value = tidy(size / sp.cos(angle.value))
    if value.has(sp.Add, sp.sin, sp.cos) or scene.unknown(value):
        return None
    whole = Binary("/", tree_of(size), Apply("cos", tree_of(angle.value, angle=True)))
    move = Move("define", "speed", stage, (body,))
    relation = chain(speed, (whole, None), (tree_of(value), "rearrange"))
    pool = together(angle.refs, stays.whole, more, frame.refs)
    refs = scene.judge.needed(move, pool, relation, angle.refs)
    if refs is None:
        return None
    return scene.desk.know(speed, value, (scene.desk.write(move, refs, relation),))


__all__ = [
    "angle_to_a_wall",
    "component_by_angle",
    "speed_kept",
    "standing_angle",
    "turn_of_wall",
]
