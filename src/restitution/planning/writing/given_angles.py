"""Angles of velocities to walls and lines that the facts give: no tangent has to find them."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Link, Ref
from restitution.expression.tree import Apply, Expression, Letter, Quantity, has_quantity, letters
from restitution.planning.writing.scene import Scene


def given_angle(scene: Scene, angle: Quantity) -> tuple[Expression, tuple[Ref, ...]] | None:
    """What an angle is given as, in numbers or in letters for angles, and the facts.

    None where it is not given, or as a letter alone: that is its name.
    """
    for equation in scene.given:
        left, right = equation.link.left, equation.link.right
        if left != angle or equation.link.sign != "=" or isinstance(right, Letter):
            continue
        roles = scene.model.unknowns.roles
        of_angles = all(name in roles and roles[name].kind == "angle" for name in letters(right))
        if of_angles and not has_quantity(right):
            return right, equation.refs
    return None


def given_by_its_ratio(scene: Scene, angle: Quantity) -> tuple[Expression, tuple[Ref, ...]] | None:
    """An angle to a wall as the inverse of its ratio that is given in numbers, and the facts.

    None where no ratio of it is given.
    """
    for equation in scene.given:
        match equation.link:
            case Link(Apply("sin" | "cos" | "tan" as ratio, own), "=", right) if own == angle:
                if not (letters(right) or has_quantity(right)):
                    return Apply(f"arc{ratio}", right), equation.refs
    return None


__all__ = ["given_angle", "given_by_its_ratio"]
