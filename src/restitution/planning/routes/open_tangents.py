"""Tangents of angles whose side is open: a component below may have either sense."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.explaining.lines.derivation import Ref
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    unsigned,
)
from restitution.oracle import Oracle, compared
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import neat, square, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.solving.story.letters import roles


def is_of_open_sense(scene: Scene, own: Formula) -> bool:
    """Whether the sense of a component in a tangent is not certain."""
    open_ = scene.unknown(own.value)
    components = {component.symbol for component in scene.model.components.values()}
    match own.quantity:
        case Quantity("angle", (_, Unit() | Negate(Unit()))):
            # Up to 180° the tangent has the sign of what stands below.
            assert isinstance(own.right, Binary)
            if scene.unknown(scene_value(scene, own.right.left)) & components:
                raise NotPlannedError("to which side of a direction an angle lies is open")
            return False
    if open_ & components:
        return True
    match own.quantity:
        case Quantity("angle", (_, Name())):
            return False  # a wall: who hits it goes away from it
    if not open_:
        return False
    known = Oracle({**roles(scene.problem), **scene.model.unknowns.roles})
    value = sp.sympify(own.value, strict=True)
    return not any(known.proves(compared(value, sign, sp.Integer(0))) for sign in (">=", "<="))


def write_squared_tangent(
    scene: Scene, equation: GivenEquation, own: Formula, tangent: Expression, refs: tuple[Ref, ...]
) -> int:
    """The square of a tangent that is given: on which side the angle lies is open."""
    match own.quantity:
        case Quantity("angle", (_, Quantity("velocity"))):
            # Up to 180° the tangent has the sign of the component along the line of centres.
            premises = together(equation.refs, refs, own.refs)
            relation = chain(tangent, (swept(own.right), None))
            if scene.judge.follows(own.move, premises, relation):
                return scene.desk.write(own.move, premises, relation)
            raise NotPlannedError("an angle between velocities that are both open")
    assert isinstance(own.right, Binary)
    right = swept(Binary("/", *(square(part) for part in (own.right.left, own.right.right))))
    last = tree_of(neat(own.value**2))
    # Of a component that is a letter the square is read off the quotient.
    steps = () if isinstance(unsigned(own.right.right), Letter) else ((last, "rearrange"),)
    return scene.desk.write(
        replace(own.move, record="tan-squared"),
        together(equation.refs, refs, own.refs),
        chain(square(tangent), (right, None), *steps),
    )


__all__ = ["is_of_open_sense", "write_squared_tangent"]
