"""A velocity after a wall of which the direction is given: its size is a letter, resolved first."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Link, Move
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    Expression,
    Letter,
    Name,
    Quantity,
)
from restitution.oracle.roles import REAL
from restitution.planning.axes.open_lines import as_a_multiple, ray_of, tried, write_ray
from restitution.planning.closing.pairs import close_two
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.impacts import before, closing_at_wall, residual
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector

_LETTERS = ("V", "v", "s", "k", "b", "c", "q", "r")


def wall_of(scene: Scene, given: GivenEquation) -> int | None:
    """The impact with a slanting wall after which a fact gives the direction of a velocity."""
    for number, own in scene.model.frames.items():
        if own.wall is None or own.n.x == 0 or own.n.y == 0 or len(scene.spheres(number)) != 1:
            continue
        (body,) = scene.spheres(number)
        ray = ray_of(scene, body, number)
        if ray is not None and ray.given is given and ray.letter is None:
            # Of a right angle the scalar product tells as much with the components themselves.
            square = _is_square(given) and 0 not in ray.direction
            return None if square else number
    return None


def _is_square(given: GivenEquation) -> bool:
    """Whether a fact says that a body turns through a right angle."""
    match given.link:
        case Link(Quantity("deflection"), "=", angle):
            return angle == RIGHT_ANGLE
        case Link(Quantity("velocity", (one,)), "perpendicular to", Quantity("velocity", (other,))):
            return one == other
    return False


def write_resolved(scene: Scene, number: int, symbol: sp.Symbol | None) -> bool:
    """Whether the laws of a wall, of the velocity V**j** after it, are solved.

    Without a letter to be found by both laws what stays parallel to the wall tells V.
    """
    return tried(scene, lambda: _written(scene, number, symbol))


def _written(scene: Scene, number: int, symbol: sp.Symbol | None) -> bool:
    frame = scene.frame(number)
    (body,) = scene.spheres(number)
    ray = ray_of(scene, body, number)
    if ray is None or not frame.is_slanted:
        return False
    if ray.role is not REAL and 0 not in ray.direction:
        return False  # told by an angle: there would be roots in both components
    early = [before(scene, kind, body, frame).value for kind in COMPONENTS]
    if any(value.has(sp.Add) for value in early):
        return False  # both laws would be long
    ray = as_a_multiple(ray)
    size, line = write_ray(scene, number, ray, _LETTERS, "silent")
    velocity = Quantity("velocity", (Name(body),), number)
    late = Vector(*(expanded(component * size) for component in ray.direction))
    scene.desk.know(velocity, late, (line,))
    across = _law(scene, body, frame, "across")
    if set(scene.unknown(residual(scene, across))) == {size}:
        close(scene, across, size)
    elif symbol is None:
        return False
    else:
        along = _law(scene, body, frame, "along")
        close_two(scene, (across, along), (size, symbol))
    _put_in(scene, velocity, late, line)
    letter = scene.model.components[number, body].symbol
    known = scene.desk.known(velocity)
    assert known is not None
    value = frame.letter_sign * known.value.dot(frame.n)
    scene.desk.know(Letter(letter.name), value, (*known.refs, *frame.refs))
    if symbol is not None and scene.unknown(symbol):
        close(scene, closing_at_wall(scene, body, frame, "along"), symbol)
    return True


def _law(scene: Scene, body: str, frame: Frame, kind: str) -> int:
    """A law of the wall for the velocity that is resolved.

    In directions that are told in letters that at the start is a vector too.
    """
    standing = scene.desk.mark()
    number = closing_at_wall(scene, body, frame, kind)
    line, relation = scene.desk.line(number), scene.desk.relation(number)
    if scene.judge.follows(line.move, line.premises, relation):
        return number
    scene.desk.back(standing)
    last = scene.last_event(body, frame.number - 1)
    late = scene.desk.known(Quantity("velocity", (Name(body),), frame.number))
    early = scene.initial(body) if not last else None
    if early is None or late is None:
        raise NotPlannedError("a law for a velocity that is resolved")
    e = scene.coefficient(frame.number).refs if kind == "along" else ()
    refs = together(early.refs, late.refs, e, frame.refs)
    premises = scene.judge.needed(line.move, refs, relation)
    if premises is None:
        raise NotPlannedError("a law for a velocity that is resolved")
    return scene.desk.write(line.move, premises, relation)


def _put_in(scene: Scene, velocity: Quantity, late: Vector, line: int) -> None:
    """The velocity with its size that has been found."""
    value, refs = scene.put(late)
    if any(map(scene.unknown, value)) or not refs:
        raise NotPlannedError("the size of a velocity of which the direction is given")
    tree: Expression = tree_of(value)
    number = scene.desk.write(Move("put"), (line, *refs), chain(velocity, (tree, None)))
    scene.desk.know(velocity, value, (number,))
