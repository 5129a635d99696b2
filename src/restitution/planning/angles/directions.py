"""The direction in which a sphere moves: along a line of centres, an axis, or by its tangent."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy, tidy_angle
from restitution.explaining.definitions.turnings import direction_from_i
from restitution.explaining.lines.derivation import Move, MoveId, Ref, numbers_in
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Quantity,
    unsigned,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.walls_at_right_angles import by_a_given_ratio
from restitution.planning.closing.cotangents import write_by_cotangent
from restitution.planning.closing.ratios import inverse
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import (
    letter_of,
    tangent_line,
)
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    in_the_plane,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.either_side import angle_of_centres
from restitution.planning.writing.forms import (
    difference,
    in_tangents,
    is_in_degrees,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.premises import nonzero
from restitution.planning.writing.ratio_of_an_angle import RANGES, Ratio
from restitution.planning.writing.scene import Scene

Components = tuple[Source, Source]


def direction_ratio(scene: Scene, asked: Quantity, wanted: str | None) -> Ratio | int:
    """The direction of a velocity, from **i**: by its tangent, on the side to which it points."""
    body, stage = body_and_stage(scene, asked)
    x, y = in_the_plane(scene, body, stage)
    if scene.model.identically_zero(x.value):
        return _along_j(scene, asked, x, y)
    before_j = scene.model.sign(x.value) > 0
    open_ = not scene.model.decide(x.value, ">=" if before_j else "<=", 0)
    turned = write_by_cotangent(scene, asked, x, y) if open_ and wanted is None else None
    if turned is not None:
        return turned
    own = formula(scene, asked)
    model_frame = scene.model.frames.get(stage)
    if model_frame is not None and model_frame.angle is not None:
        own = _needed(scene, asked, own)
    line, letter = tangent_line(scene, asked, own, own.move)
    extent = RANGES["direction"].format(letter)
    value = own.value
    if before_j:
        right = in_degrees_of(sp.atan(value), value)
    else:
        # On the other side of j the angle is measured from −i.
        sign = scene.model.sign(y.value)
        size = in_degrees_of(sp.atan(-value * sign), -value * sign)
        straight = STRAIGHT_ANGLE
        if isinstance(size, Degrees):
            right = Degrees(straight.value - size.value)
            right = Negate(right) if sign < 0 else right
        elif sign == 0:
            right = straight
        else:
            right = difference(straight, size) if sign > 0 else difference(size, straight)
    side = together(x.whole, nonzero(scene, x.value))
    return Ratio(line, letter, "tan", value, extent, side, right, open_)


def _needed(scene: Scene, asked: Quantity, own: Formula) -> Formula:
    """A tangent without the premises that it can do without."""
    letter, meaning = letter_of(scene, asked)
    relation = chain(Apply("tan", Letter(letter)), (own.right, None))
    refs = scene.judge.needed(own.move, together(own.refs, (meaning,)), relation)
    return own if refs is None else replace(own, refs=refs)


def along_the_centres(scene: Scene, asked: Quantity) -> int | None:
    """The line of a direction along a line of centres that is told by its angle."""
    body, stage = body_and_stage(scene, asked)
    model_frame = scene.model.frames.get(stage)
    if model_frame is None or model_frame.wall is not None or model_frame.axis is not None:
        return None
    if _goes_aslant(scene, body, stage):
        return None
    frame = scene.frame(stage)
    along, across = (in_direction(scene, kind, body, stage, frame) for kind in COMPONENTS)
    angle = angle_of_the_line(scene, frame)
    if angle is None:
        return None
    if along.value == 0 and across.value != 0:
        return _across_the_centres(scene, asked, angle, (along, across))
    if across.value != 0 or scene.model.proved_sign(scene.model.in_data(along.value)) != 1:
        return None
    known = scene.desk.known(angle) if isinstance(angle, Letter) else None
    steps: list[tuple[Expression, MoveId | None]] = [(angle, None)]
    if known is not None:
        steps.append((tree_of(known.value, angle=True, as_it_is=True), "put"))
    relation = chain(asked, *steps)
    move = Move("define", "parallel", stage, (body,))
    pool = together(across.whole, along.whole, frame.refs, () if known is None else known.refs)
    premises = scene.judge.needed(move, [*pool, *nonzero(scene, along.value)], relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def _goes_aslant(scene: Scene, body: str, stage: int) -> bool:
    """Whether a body goes neither along the line of centres nor at right angles to it."""
    own, frame = scene.velocity(body, stage), scene.model.frames[stage]
    parts = (own.dot(vector) for vector in (frame.n, frame.t))
    return all(scene.model.sign(scene.model.in_data(part)) for part in parts)


def angle_of_the_line(scene: Scene, frame: Frame) -> Expression | None:
    """The angle of a line of centres from **i**, by its letter or in degrees; None without."""
    angle = angle_of_centres(scene, frame.number)
    return _in_whole_degrees(frame) if angle is None else angle


def _in_whole_degrees(frame: Frame) -> Expression | None:
    """The direction of a line of centres that was worked out, if it is one of degrees."""
    x, y = (sp.sympify(component, strict=True) for component in frame.n)
    if x.free_symbols | y.free_symbols:
        return None
    angle = tree_of(tidy(sp.atan2(y, x)), angle=True)
    size = unsigned(angle)
    return angle if isinstance(size, Degrees) else None


def _across_the_centres(
    scene: Scene, asked: Quantity, angle: Expression, parts: Components
) -> int | None:
    """The line of a direction perpendicular to a line of centres that is told by its angle."""
    body, stage = body_and_stage(scene, asked)
    sign = scene.model.proved_sign(scene.model.in_data(parts[1].value))
    if not sign:
        return None
    turn = sp.pi / 2 if sign > 0 else -sp.pi / 2
    right = Binary("+" if sign > 0 else "-", angle, RIGHT_ANGLE)
    known = scene.desk.known(angle) if isinstance(angle, Letter) else None
    steps: list[tuple[Expression, MoveId | None]] = [(right, None)]
    if known is not None:
        steps.append((tree_of(tidy(known.value + turn), angle=True, as_it_is=True), "put"))
    elif not isinstance(angle, Letter):
        whole = tidy(scene.scalar(angle) + turn)
        steps.append((tree_of(whole, angle=True, as_it_is=True), "rearrange"))
    relation, move = chain(asked, *steps), Move("define", "parallel", stage, (body,))
    refs = () if known is None else known.refs
    pool = together(*(part.whole for part in parts), scene.frame(stage).refs, refs)
    premises = scene.judge.needed(move, [*pool, *nonzero(scene, parts[1].value)], relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def direction_of_data(scene: Scene, asked: Quantity) -> int | None:
    """The line that a direction at the start is an acute angle of the data, with what that is.

    None of another direction, and where the angle stands for all that it may be.
    """
    body, stage = body_and_stage(scene, asked)
    fact = scene.facts.get(f"velocity {body}") if not stage else None
    angle = None if fact is None else direction_from_i(fact.relation.only[0].right)
    if fact is None or not isinstance(angle, Letter):
        return None
    move, relation = Move("define", "difference", None, (body,)), chain(asked, (angle, None))
    if not scene.judge.follows(move, (fact.id,), relation):
        return None
    return by_a_given_ratio(scene, asked, write_read_off(scene, asked, angle, move, (fact.id,)))


def write_read_off(
    scene: Scene, asked: Quantity, angle: Letter | Degrees, move: Move, refs: Sequence[Ref]
) -> int:
    """The line that an angle is one of the data, with what a letter for that has come to."""
    relation = chain(asked, (angle, None))
    known = None
    if isinstance(angle, Letter) and angle.name not in scene.ratio_facts:
        known = scene.desk.known(angle) or _by_its_ratio(scene, angle)
    if known is None:
        return scene.desk.write(move, refs, relation)
    line = scene.desk.write(move, refs, relation, shown="inline")
    right = tree_of(known.value, angle=True, as_it_is=True)
    return scene.desk.write(Move("put"), (line, *known.refs), chain(asked, (right, None)))


def _by_its_ratio(scene: Scene, angle: Letter) -> Source | None:
    """An angle of which a line gives the tangent, the sine or the cosine as a number."""
    symbol = scene.model.unknowns.letter(angle.name)
    for ratio in ("tan", "sin", "cos"):
        known = scene.desk.known(Apply(ratio, angle))
        lines = () if known is None else numbers_in(known.refs)
        if known is None or len(lines) != 1 or known.value.free_symbols:
            continue
        if scene.desk.last_link(lines[0]).left == Apply(ratio, angle):  # and no other ratio of it
            return inverse(scene, lines[0], symbol)
    return None


def along_an_axis(scene: Scene, asked: Quantity) -> int | None:
    """The line of a direction along **i** or **j**, which is read off: one component is 0."""
    body, stage = body_and_stage(scene, asked)
    x, y = in_the_plane(scene, body, stage)
    angle: Expression
    if y.value == 0 and scene.model.proved_sign(scene.model.in_data(x.value)):
        angle = Degrees(Fraction(0 if scene.model.sign(x.value) > 0 else 180))
    elif x.value == 0 and scene.model.proved_sign(scene.model.in_data(y.value)):
        x, y = y, x
        angle = RIGHT_ANGLE
        angle = angle if scene.model.sign(x.value) > 0 else Negate(angle)
    else:
        return None
    move = Move("define", "parallel", stage or None, (body,))
    relation = chain(asked, (angle, None))
    pool = (*y.whole, *x.whole)
    premises = scene.judge.needed(move, [*pool, *nonzero(scene, x.value)], relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def _along_j(scene: Scene, asked: Quantity, x: Source, y: Source) -> Ratio:
    """A direction of 90° or −90°, which has no tangent: by its cosine, which is 0."""
    body, stage = body_and_stage(scene, asked)
    letter, meaning = letter_of(scene, asked)
    zero = sp.Integer(0)
    line = scene.desk.write(
        Move("define", "scalar-angle", stage or None, (body,)),
        together((meaning,), x.whole),
        chain(Apply("cos", Letter(letter)), (tree_of(zero), None)),
    )
    right = RIGHT_ANGLE
    up = scene.model.sign(y.value) > 0
    side = together(y.whole, nonzero(scene, y.value))
    extent = RANGES["direction"].format(letter)
    return Ratio(line, letter, "cos", zero, extent, side, right if up else Negate(right))


def in_degrees_of(angle: sp.Expr, value: sp.Expr) -> Expression:
    """An inverse tangent, sine or cosine: in degrees where it is plain, else as it is."""
    if is_in_degrees(angle):
        plain = tidy_angle(angle)  # arctan(tan 50°) is 50°
        angle = plain if (plain / sp.pi).is_Rational else angle
    inverse = angle.has(sp.atan, sp.acos, sp.asin)
    degrees = None if inverse else sp.nsimplify(angle * 180 / sp.pi)
    if degrees is not None and degrees.is_Rational:
        number = Fraction(int(degrees.p), int(degrees.q))
        return Negate(Degrees(-number)) if number < 0 else Degrees(number)
    function = "arccos" if angle.has(sp.acos) else "arcsin" if angle.has(sp.asin) else "arctan"
    tree = tree_of(in_tangents(value) if value.is_number else value)
    if function == "arctan" and isinstance(tree, Negate):
        return Negate(Apply(function, tree.operand))
    return Apply(function, tree)
