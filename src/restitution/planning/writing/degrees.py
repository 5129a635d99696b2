"""Components at the start by an angle of the data: ``u cos 60°``, ``5 × 0.6``."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.explaining.data.paths_and_lines import (
    angle_between,
    angles_between,
    degrees_of,
    in_degrees,
    turn_of_line,
    turn_of_path,
)
from restitution.explaining.lines.derivation import Ref, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    has_standard_ratios,
    letters,
    walk,
)
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.forms import negative, product, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector

_PLAIN = 15


def by_degrees(
    scene: Scene, kind: str, body: str, frame: Frame, value: sp.Expr
) -> Expression | None:
    """A component at the start by the angle, a number: ``u cos 60°``, ``5 × 0.6``.

    None without one.
    """
    initial = scene.initial(body).value
    fact = scene.facts.get(f"velocity {body}")
    if fact is None:
        return None
    (link,) = fact.relation.only
    component = _by_the_angle_between(scene, kind, body, frame, value)
    if component is not None:
        return component
    if isinstance(link.right, Polar):
        size = scene.scalar(link.right.size)
    elif initial.x == 0 or initial.y == 0:
        size = initial.x + initial.y
    else:
        return None
    size = -size if scene.model.sign(size) < 0 else size
    ratio = tidy(value / size) if size != 0 else size
    share = _share_from_the_data(scene, link.right, frame.direction(kind), ratio)
    if share is None:
        # At a straight wall, angles are measured from it.
        straight = frame.wall is not None and circle_of(scene, frame.number) is None
        function = "sin" if straight == (kind == "along") else "cos"
        share = share_by_degrees(ratio, function) or _share_in_numbers(link.right, size, ratio)
        if share is not None and not _names_an_angle(scene, frame):
            share = tree_of(abs(ratio)) if initial.x and initial.y else None
    if share is None:
        return None
    own = product(tree_of(size), share)
    return negative(own) if scene.model.sign(value) < 0 else own


def angle_to_the_line(scene: Scene, body: str, frame: Frame) -> Expression | None:
    """The angle of the path at the start with a slanting wall, or line of centres.

    Both are told by their angles from **i**, in degrees or in letters. It is a number of degrees,
    or a sum or a difference that is certain to be an angle of at most 90°; None without one.
    """
    if not frame.is_slanted or frame.write is not None or circle_of(scene, frame.number):
        return None
    if frame.wall is None and _meet_again(scene, frame.number):
        return None  # components are written in one way in the whole working
    own = f"axis {frame.number}" if frame.wall is None else f"wall {frame.wall}"
    path, line = turn_of_path(scene.facts.get(f"velocity {body}")), scene.facts.get(own)
    turn = turn_of_line(line) or _turn_of_a_vector(scene, body, frame)
    if path is None or turn is None:
        return None
    whole = angle_between(path, turn)
    if whole is not None:
        return Degrees(degrees_of(whole))
    angles = [scene.scalar(tree) for tree in (path, turn)]
    is_open = any(scene.unknown(angle) or scene.put(angle)[1] for angle in angles)
    if is_open or {*letters(path), *letters(turn)} & {*scene.ratio_facts}:
        return None  # a letter that is sought, or has a number that is put in
    is_polar = isinstance(scene.facts[f"velocity {body}"].relation.only[-1].right, Polar)
    for tree in angles_between(path, turn):
        if not is_polar and not isinstance(tree, Letter):
            continue  # beside j the sine is read off as well: u sin θ
        angle = scene.model.in_data(scene.scalar(tree))
        if scene.model.decide(angle, ">=", 0) and scene.model.decide(angle, "<=", sp.pi / 2):
            return tree
    return None


def _turn_of_a_vector(scene: Scene, body: str, frame: Frame) -> Expression | None:
    """The angle of a line along **i** + **j** from **i**, where a velocity is told by degrees.

    Only of multiples of 15° is what it comes to compared with scalar products.
    """
    path = turn_of_path(scene.facts.get(f"velocity {body}"))
    right = scene.facts[f"velocity {body}"].relation.only[-1].right
    own = None if path is None or not isinstance(right, Polar) else in_degrees(path)
    direction = frame.direction("along" if frame.wall is None else "across")
    if own is None or own % _PLAIN or own % 90 == 0 or direction.x == 0:
        return None  # along an axis a scalar product is as short
    degrees = sp.deg(sp.atan(tidy(direction.y / direction.x)))
    return Degrees(Fraction(int(degrees))) if degrees.is_Integer and not degrees % _PLAIN else None


def _meet_again(scene: Scene, number: int) -> bool:
    """Whether a body of an impact has another one."""
    bodies = set(scene.bodies(number))
    others = (n for n in range(1, scene.events + 1) if n != number)
    return any(bodies & set(scene.bodies(n)) for n in others)


def _by_the_angle_between(
    scene: Scene, kind: str, body: str, frame: Frame, value: sp.Expr
) -> Expression | None:
    """A component at the start by the angle of the path with the line: u cos(α − β)."""
    angle = angle_to_the_line(scene, body, frame)
    initial = scene.initial(body).value
    if angle is None or angle in (RIGHT_ANGLE, Degrees(Fraction(0))) or value == 0:
        return None
    right = scene.facts[f"velocity {body}"].relation.only[-1].right
    if isinstance(right, Polar):
        size = scene.scalar(right.size)
    else:
        size = initial.x + initial.y
        size = -size if scene.model.sign(size) < 0 else size
    function = "sin" if (frame.wall is not None) == (kind == "along") else "cos"
    own = product(tree_of(size), Apply(function, angle))
    return negative(own) if scene.model.sign(value) < 0 else own


def _names_an_angle(scene: Scene, frame: Frame) -> bool:
    """Whether a reader has an angle of the directions of a frame, and not their vectors alone."""
    if not frame.is_slanted:
        return True
    refs: list[Ref] = [f"axis {frame.number}", *frame.refs]
    lines = [scene.desk.line(ref) for ref in refs if isinstance(ref, int)]
    refs += [ref for line in lines for ref in line.premises]
    facts = [scene.facts[ref] for ref in refs if isinstance(ref, str) and ref in scene.facts]
    relations = [line.relation for line in lines] + [fact.relation for fact in facts]
    return any(
        isinstance(node, Degrees | Polar)
        for relation in relations
        if isinstance(relation, Relation)
        for tree in trees_of(relation)
        for node in walk(tree)
    )


def _share_from_the_data(
    scene: Scene, velocity: Expression, direction: Vector, ratio: sp.Expr
) -> Expression | None:
    """The size of a ratio by the very angle of the data, along or across what that is from."""
    start = reference_of(scene, velocity)
    if start is None:
        return None
    parts = {"cos": tidy(start.cross(direction)), "sin": tidy(start.dot(direction))}
    for function, other in parts.items():
        share = share_by_degrees(ratio, function) if other == 0 else None
        if share is not None and set(walk(share)) & angles_in(velocity):
            return share
    return None


def reference_of(scene: Scene, velocity: Expression) -> Vector | None:
    """The direction from which the angle of a velocity is measured; None where it has none."""
    if not isinstance(velocity, Polar):
        return None
    if isinstance(velocity.wall, Name):
        fact = scene.facts.get(f"wall {velocity.wall.name}")
        value = None if fact is None else scene.value(fact.relation.only[-1].right)
    else:
        value = Vector(1, 0) if velocity.origin is None else scene.value(velocity.origin)
    return value if isinstance(value, Vector) else None


def by_the_angle_from(
    scene: Scene, kind: str, body: str, frame: Frame, value: sp.Expr
) -> tuple[Expression, sp.Expr] | None:
    """A component at the start by the angle from the very line of an impact: ``5 cos 25°``.

    With it what it is worth. None where the angle is measured from another line.
    """
    fact = scene.facts.get(f"velocity {body}")
    polar = None if fact is None else fact.relation.only[-1].right
    start = None if polar is None else reference_of(scene, polar)
    if not isinstance(polar, Polar) or start is None or not frame.is_slanted:
        return None
    direction = frame.direction(kind)
    function = "cos" if tidy(start.cross(direction)) == 0 else "sin"
    if function == "sin" and tidy(start.dot(direction)) != 0:
        return None
    match polar.angle:
        case Degrees(degrees) if degrees % 90:
            angle: Expression = Degrees(abs((degrees + 90) % 180 - 90))
        case Letter() as angle:
            pass
        case _:
            return None
    own = product(polar.size, Apply(function, angle))
    worth = scene.scalar(own)
    for sign in (1, -1):
        if scene.model.identically_zero(value - sign * worth):
            return (own if sign == 1 else negative(own)), tidy(sign * worth)
    return None


def has_standard_angles(tree: Expression) -> bool:
    """Whether all angles in degrees that a tree has are those of the table, as 30° and 45°."""
    return all(has_standard_ratios(node.value) for node in walk(tree) if isinstance(node, Degrees))


def angles_in(tree: Expression) -> set[Expression]:
    """The angles in degrees that a tree has."""
    return {node for node in walk(tree) if isinstance(node, Degrees)}


def _share_in_numbers(velocity: Expression, size: sp.Expr, ratio: sp.Expr) -> Expression | None:
    """The size of a ratio of an angle that is told by another of its ratios: ``arccos(0.6)``.

    None where a letter is the speed: ``12u/13`` is read off.
    """
    match velocity:
        case Polar(angle=Apply("arcsin" | "arccos" | "arctan")) if (
            size.is_number and ratio.is_Rational and abs(ratio) not in (0, 1)
        ):
            return tree_of(abs(ratio))
    return None


def share_by_degrees(ratio: sp.Expr, function: str) -> Expression | None:
    """The size of a ratio as the sine or cosine of whole degrees; None where it is none."""
    if not ratio.is_number or atoms_in(ratio, sp.sin, sp.cos, sp.tan) or abs(ratio) in (0, 1):
        return None
    size = sp.Abs(ratio)
    angle = (sp.asin if function == "sin" else sp.acos)(size) * 180 / sp.pi
    if not angle.is_Integer:
        return None
    return Apply(function, Degrees(Fraction(int(angle))))


def share_in_degrees(scene: Scene, body: str, ratio: sp.Expr) -> Expression | None:
    """The size of a cosine at the start by the angle in degrees that the velocity is given by."""
    fact = scene.facts.get(f"velocity {body}")
    share = share_by_degrees(ratio, "cos")
    if fact is None or share is None:
        return None
    return share if set(walk(share)) & angles_in(fact.relation.only[0].right) else None


def on_a_chord_by_degrees(
    scene: Scene, kind: str, body: str, velocity: Vector, direction: Vector
) -> Expression | None:
    """A component on a chord by its angle with the radius, one of the data in degrees: 3 cos 30°.

    ``direction`` is that of the component, along the radius at the start or across it. None where
    there is no such angle.
    """
    speed, value = tidy(scene.model.story.size(velocity)), tidy(velocity.dot(direction))
    towards = value if kind == "along" else tidy(velocity.cross(direction))
    match share_in_degrees(scene, body, tidy(towards / speed)):
        case Apply(_, angle):
            function = "cos" if kind == "along" else "sin"
            own = product(tree_of(speed), Apply(function, angle))
            return negative(own) if scene.model.sign(value) < 0 else own
    return None


__all__ = [
    "angle_to_the_line",
    "angles_in",
    "by_degrees",
    "by_the_angle_from",
    "has_standard_angles",
    "on_a_chord_by_degrees",
    "reference_of",
    "share_by_degrees",
    "share_in_degrees",
]
