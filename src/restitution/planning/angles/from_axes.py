"""Deflections of bodies that came along **i** or **j**: the angle to that of the velocity after."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Apply, Binary, Letter, Name, Quantity
from restitution.planning.formulas.named_angles import letter_of, ratio_line
from restitution.planning.formulas.velocity_formulas import (
    in_the_plane,
    known_vector,
    velocity_source,
)
from restitution.planning.writing.desk import Source, chain, is_value_of, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.ratio_of_an_angle import RANGES, Ratio
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def from_an_axis(scene: Scene, body: str, event: int, asked: Quantity) -> Ratio | None:
    """The tangent of a deflection of a body that came along **i** or **j**, by its velocity after.

    That is one after a blow, a vector, or has components along and across a line of centres at
    right angles to which the body came. None of another, and where the tangent has letters that
    leave a sign open.
    """
    early = in_the_plane(scene, body, event - 1)
    axis = next((n for n in (0, 1) if early[1 - n].value == 0 != early[n].value), None)
    if axis is None:
        return None
    velocity = Quantity("velocity", (Name(body),), event)
    known = scene.desk.known(velocity) or _given(scene, velocity)
    if event not in scene.model.frames:
        blown = known_vector(scene, body, event) or velocity_source(scene, body, event)
        late, rest = blown.value, blown.whole
    elif scene.frame(event).is_slanted and known is not None and isinstance(known.value, Vector):
        late, rest = known.value, known.refs
    elif not scene.frame(event).is_slanted and scene.frame(event).n[axis] == 0:
        components = in_the_plane(scene, body, event)
        late = Vector(*(component.value for component in components))
        rest = together(*(component.whole for component in components))
    else:
        return None
    ahead, aside = late[axis], late[1 - axis]
    if scene.model.sign(early[axis].value) < 0:
        ahead = -ahead
    if scene.model.sign(aside) < 0:
        aside = -aside
    value = tidy(aside / ahead)
    if not value.is_number and not _is_certain(scene, aside, ahead):
        return None
    if event not in scene.model.frames and not value.is_Rational:
        return None  # of roots the scalar product with a speed that is known is plainer
    letter, meaning = letter_of(scene, asked)
    move = Move("define", "tan-from-axis", event, (body,))
    # A negative component ahead keeps its sign below the line: it makes the angle obtuse.
    subject, right = Apply("tan", Letter(letter)), Binary("/", tree_of(aside), tree_of(ahead))
    whole = together((meaning,), rest, *(source.whole for source in early))
    refs = scene.judge.needed(move, whole, chain(subject, (right, None)))
    if refs is None:
        return None
    line = ratio_line(scene, move, refs, subject, right, value)
    return Ratio(line, letter, "tan", value, RANGES["deflection"].format(letter))


def _given(scene: Scene, velocity: Quantity) -> Source | None:
    """A velocity that is given as a vector without unknowns; None of another."""
    for equation in scene.given:
        if is_value_of(equation.link, velocity):
            value = scene.value(equation.link.right)
            return None if scene.unknown(value) else Source(value, equation.refs)
    return None


def _is_certain(scene: Scene, aside: sp.Expr, ahead: sp.Expr) -> bool:
    """Whether a velocity in letters is turned to one side, and goes on, whatever they are."""
    signs = (
        scene.model.proved_sign(scene.model.in_data(value)) for value in (aside, aside / ahead)
    )
    return all(sign is not None for sign in signs)


__all__ = ["from_an_axis"]
