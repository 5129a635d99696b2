"""Angles between a velocity and a line, as the data tell them."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Unit,
    has_unit_vector,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene

STRAIGHT, RIGHT = (Degrees(Fraction(size)) for size in (180, 90))

# A path and a line may be told by angles of up to 360° each, of either sign.
_HALF_TURNS = (0, 1, -1, 2, -2, 3, -3)


def angle_to_a_line(scene: Scene, body: str, line: Expression) -> Expression | None:
    """The angle of up to 90° to a line at which the velocity of a body at the start is given.

    None where it is not given by an angle, nor along **i** or **j**.
    """
    fact = scene.facts.get(f"velocity {body}")
    right = None if fact is None else fact.relation.only[0].right
    angle: Expression = Degrees(Fraction(0))
    origin: Expression | None = None
    if isinstance(right, Polar):
        if right.wall is not None:
            return None
        angle, origin = right.angle, right.origin
        given = scene.model.story.direction(origin or Unit("i"), 0)
    elif right is not None and has_unit_vector(right):
        given = scene.initial(body).value
        if given.x != 0 and given.y != 0:
            return None
    else:
        return None
    turned = scene.scalar(angle)
    if all(isinstance(node, Degrees | Letter | Binary | Negate) for node in walk(line)):
        if given.x != 0 and given.y != 0:
            return None
        across = Binary("-", line, RIGHT) if given.x == 0 else line
        angle, turned = Binary("-", angle, across), turned - scene.scalar(across)
    else:
        direction = scene.model.story.direction(line, 0)
        if given.cross(direction) != 0:
            if not isinstance(line, Unit) or given.dot(direction) != 0:
                return None
            angle, turned = Binary("-", RIGHT, angle), sp.pi / 2 - turned
        elif not isinstance(line, Unit | Negate) and origin != line:
            return None
    return _within_a_right_angle(scene, angle, turned)


def angle_to_its_wall(scene: Scene, angle: Expression) -> Expression:
    """The angle of up to 90° to a wall at which a velocity is given from it, as α of 180° + α.

    One of which letters leave it open stands as it is given.
    """
    return _within_a_right_angle(scene, angle, scene.scalar(angle)) or angle


def _within_a_right_angle(scene: Scene, angle: Expression, turned: sp.Expr) -> Expression | None:
    """The angle of up to 90° between a line and what is turned from it; None of an open one."""
    turns = _HALF_TURNS[:3] if turned.free_symbols else _HALF_TURNS
    forms = (
        (angle, turned),
        (Binary("-", STRAIGHT, angle), sp.pi - turned),
        *((None, value + number * sp.pi) for number in turns for value in (turned, -turned)),
    )
    for form, value in forms:
        if scene.model.decide(value, ">=", 0) and scene.model.decide(value, "<=", sp.pi / 2):
            own = tidy(value)
            plain = form is None or own.is_number or own.is_Symbol
            return tree_of(own, angle=True) if plain else form
    return None


def angle_of_approach(scene: Scene, body: str, frame: Frame) -> Expression | None:
    """The angle to a wall at which a body comes, where the data tell it as a letter or in degrees.

    It may be a multiple of a letter, such as 2θ.

    The velocity may be given by that angle, or by one to a direction of the plane.
    """
    fact, wall = scene.facts.get(f"velocity {body}"), scene.facts.get(f"wall {frame.wall}")
    if fact is None or scene.last_event(body, frame.number - 1):
        return None
    angle: Expression | None = None
    match fact.relation.only[0].right:
        case Polar(_, size, wall=Name(name)) if name == frame.wall:
            angle = angle_to_its_wall(scene, size)
        case right if wall is not None:
            line = wall.relation.only[0].right
            # One along an axis is read off: u at θ to a wall that makes θ with it.
            plain = isinstance(right, Polar) or isinstance(unsigned(line), Letter | Degrees)
            angle = angle_to_a_line(scene, body, line) if plain else None
    match angle:
        case Letter() | Degrees() | Binary("*", Number(), Letter()):
            return angle
    return None


def data_of_approach(scene: Scene, body: str, frame: Frame) -> tuple[str, ...]:
    """The facts that tell the angle at which a body comes to a wall.

    That of a path such as 2θ is acute is one of its own.
    """
    velocity, path = f"velocity {body}", f"path {body}"
    right = scene.facts[velocity].relation.only[0].right
    more = (path,) if path in scene.facts else ()
    by_the_wall = isinstance(right, Polar) and right.wall is not None
    return (velocity, *more) if by_the_wall else (velocity, f"wall {frame.wall}", *more)
