"""Bounds of an angle that are right angles: by the signs of components, or of a scalar product."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Quantity, Unit, has_quantity
from restitution.planning.angles.scalar_angles import write_product_of_two
from restitution.planning.formulas.turns import velocities_of
from restitution.planning.formulas.velocity_formulas import body_and_stage, in_the_plane
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.desk import Source
from restitution.planning.writing.forms import ZERO
from restitution.solving.story.letters import is_vector


def write_by_components(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """The bounds of an angle by signs, where all are multiples of 90°; None of another angle.

    In which quadrant a direction is, both components tell; whether an angle between velocities is
    obtuse, their scalar product does; whether one to **i** or **j** is, one component.
    """
    if len(quantities) != 1 or not all(_is_of_right_angles(claims, e) for e in relation.only):
        return None
    (angle,) = quantities
    mark = claims.worths.mark()
    signs = _signs(claims, angle)
    if signs is not None:
        last = claims.judge.write((Move("compare"),), signs, relation)
        if last is not None:
            return last
    claims.worths.back(mark)
    return None


def _signs(claims: Comparing, angle: Quantity) -> list[Ref] | None:
    """What tells the signs on which an angle hangs; None where there is nothing that does."""
    scene = claims.scene
    match angle:
        case Quantity("direction", _, int(stage)):
            axes = "xy"
        case Quantity("angle", (Quantity("velocity", _, int(stage)), Unit(axis))):
            axes = "x" if axis == "i" else "y"
        case _:
            pair = velocities_of(scene, angle)
            if pair is None:
                return None
            claims.worths.determine_angle(angle)
            line = write_product_of_two(scene, pair)
            return None if line is None else list(_signed(claims, line))
    subject = angle if angle.kind == "direction" else angle.arguments[0]
    assert isinstance(subject, Quantity)
    claims.worths.determine(Quantity("velocity", subject.arguments, stage))
    components = dict(zip("xy", in_the_plane(scene, *body_and_stage(scene, subject)), strict=True))
    return [ref for axis in axes for ref in _sign_of(claims, components[axis])]


def _sign_of(claims: Comparing, component: Source) -> Iterator[Ref]:
    """What tells the sign of a component: a line of its own, or its value and what is known."""
    signs = [own for ref in component.whole for own in _signed(claims, ref)]
    yield from signs
    if tuple(signs) == component.whole:
        yield from claims.worths.known_in(component.value)


def _signed(claims: Comparing, ref: Ref) -> Iterator[Ref]:
    """A premise; of a line whose value is a sum, the line that compares that with zero."""
    scene = claims.scene
    own = scene.desk.line(ref).relation if isinstance(ref, int) else None
    is_plain = isinstance(own, Relation) and own.only[0].sign == "="
    if isinstance(own, Relation) and is_plain and not is_vector(own.only[-1].right):
        value = claims.worths.value(own.only[-1].right)
        if any(isinstance(factor, sp.Add) for factor in sp.Mul.make_args(value)):
            order: Sign = ">" if scene.model.sign(value) > 0 else "<"
            compared = Relation(((Link(own.only[0].left, order, ZERO),),))
            line = claims.compared([ref], compared)
            if line is not None:
                yield line
                return
    yield ref


def _is_of_right_angles(claims: Comparing, link: Link) -> bool:
    """Whether a bound is a multiple of 90°."""
    bounds = [side for side in (link.left, link.right) if not has_quantity(side)]
    if link.sign not in FLIPPED or len(bounds) != 1:
        return False
    value = sp.sympify(claims.scene.scalar(bounds[0]), strict=True)
    return bool((value / (sp.pi / 2)).is_Integer)
