"""Inequalities between angles: acute or not by the sign of a tangent, or one of two the greater."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    Sign,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    letters,
)
from restitution.planning.formulas.velocity_formulas import in_the_plane
from restitution.planning.inequalities.angle_pairs import extents, made_of_two
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.desk import NotPlannedError, Source
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.solving.story.letters import roles


def write_of_angles(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """An inequality between angles of the motion; None where there is no way to it."""
    if len(relation.only) != 1 or not quantities:
        return None
    if any(quantity.kind not in UNSIGNED_ANGLES for quantity in quantities):
        return None
    mark = claims.worths.mark()
    for proof in (_by_sign, _by_its_tangent, _by_the_other):
        try:
            line = proof(claims, quantities, relation)
        except NotPlannedError:
            line = None
        if line is not None:
            return line
        claims.worths.back(mark)
    return None


def _by_sign(claims: Comparing, quantities: Sequence[Quantity], relation: Relation) -> int | None:
    """That an angle is acute, or obtuse, by the sign of its tangent."""
    (link,) = relation.only
    match link:
        case Link(Quantity() as angle, "<" | ">" as sign, Degrees(value)) if value == 90:
            pass
        case _:
            return None
    if quantities != [angle]:
        return None
    tangent, letter, extent = _tangent_of(claims, angle)
    tangent_sign = Link(Apply("tan", letter), FLIPPED[sign], ZERO)
    signed = claims.compared([tangent], Relation(((tangent_sign,),)))
    return None if signed is None else claims.judge.write(_COMPARE, [signed, *extent], relation)


def _tangent_of(claims: Comparing, angle: Quantity) -> tuple[int, Expression, tuple[Ref, ...]]:
    """The line of the tangent of an angle by its letter, with the letter and its range."""
    line = claims.worths.angle_by_letter(angle) or claims.worths.angle(angle)
    subject = claims.scene.desk.last_link(line).left
    if not isinstance(subject, Apply):
        raise NotPlannedError("an angle without a tangent")
    return claims.worths.lettered(line, subject.argument)


def _by_its_tangent(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """An angle to a line compared with one of the data, both acute, as their tangents are."""
    (link,) = relation.only
    sides = (link.left, link.right)
    if len(quantities) != 1 or quantities[0] not in sides:
        return None
    (angle,) = quantities
    if not any(isinstance(side, Letter) for side in sides):
        return None
    tangent, letter, extent = _tangent_of(claims, angle)
    left, right = (letter if side == angle else side for side in sides)
    ratios = Link(Apply("tan", left), link.sign, Apply("tan", right))
    compared = claims.compared([tangent], Relation(((ratios,),)))
    if compared is None:
        return None
    names = {tree.name for tree in (left, right) if isinstance(tree, Letter)}
    pool = [compared, *extent, *claims.judge.known(names), *extents(claims.scene, names)]
    return claims.judge.write(_COMPARE, pool, relation)


def write_by_a_right_angle(claims: Comparing, relation: Relation) -> int | None:
    """A deflection beside that of who moves on at right angles to **i** or **j**.

    ``δ = β − 45°`` is at most 45° where β is at most 90°, which the sense of a component tells.
    None of another inequality.
    """
    match relation.options:
        case ((Link(Quantity("deflection", (Name(),), int()), _, Degrees()) as link,),):
            pass
        case _:
            return None
    mark = claims.worths.mark()
    try:
        line = _by_a_right_angle(claims, link)
    except NotPlannedError:
        line = None
    if line is None:
        claims.worths.back(mark)
    return line


def _by_a_right_angle(claims: Comparing, link: Link) -> int | None:
    scene, asked, sign = claims.scene, link.left, link.sign
    assert isinstance(asked, Quantity)
    (name,), stage = asked.arguments, asked.stage
    assert isinstance(name, Name)
    assert isinstance(stage, int)
    claims.worths.determine_angle(asked)
    parts = made_of_two(scene, asked)
    if parts is None or sign not in FLIPPED:
        return None
    whole, _ = parts
    turn, own = scene.desk.last_link(whole).right, Relation(((link,),))
    known = extents(scene, {let.letter for let in _lets(claims)})
    data = claims.judge.known(letters(turn) & roles(scene.problem).keys())
    if (at_once := claims.judge.write(_COMPARE, [whole, *known, *data], own)) is not None:
        return at_once
    named = {Letter(let.letter): let.quantity for let in _lets(claims)}
    match turn:
        case Binary("-", Letter() as angle, Degrees() as early) if angle in named:
            between = named[angle]
        case _:
            return None
    match between:
        case Quantity("angle", (Quantity("velocity"), Unit() as axis)):
            pass
        case _:
            return None
    if scene.scalar(link.right) + scene.scalar(early) != sp.pi / 2:
        return None
    x, y = in_the_plane(scene, name.name, stage)
    component = x if axis == Unit("i") else y
    signed = _signed(claims, component, FLIPPED[sign])
    if signed is None:
        return None
    right = Relation(((Link(angle, sign, RIGHT_ANGLE),),))
    line = claims.judge.write(_COMPARE, [signed, *component.whole, *known], right)
    return None if line is None else claims.judge.write(_COMPARE, [whole, line, *known], own)


def _signed(claims: Comparing, component: Source, sign: Sign) -> int | None:
    """The line that compares a component with zero, from the one that gives it."""
    for ref in component.whole:
        own = claims.scene.desk.line(ref).relation if isinstance(ref, int) else None
        if isinstance(own, Relation) and own.only[0].sign == "=" and isinstance(ref, int):
            subject = own.only[0].left
            line = claims.compared([ref], Relation(((Link(subject, sign, ZERO),),)))
            if line is not None:
                return line
    return None


def _by_the_other(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """An angle that is made of two, of which one is the greater, as its tangent is."""
    scene = claims.scene
    for asked in quantities:
        claims.worths.determine_angle(asked)
        parts = made_of_two(scene, asked)
        if parts is None:
            continue
        line_of_sum, tangents = parts
        if len(tangents) != 1:
            continue
        (tangent,) = tangents
        own = scene.desk.last_link(tangent).left
        assert isinstance(own, Apply)
        less = _which_is_less(claims, relation.only[0], own.argument)
        if less is None:
            continue
        names = {e.name for e in (less.left, less.right) if isinstance(e, Letter)}
        ratios = Link(Apply("tan", less.left), less.sign, Apply("tan", less.right))
        compared = claims.compared([tangent], Relation(((ratios,),)))
        if compared is None:
            continue
        pool = [compared, *claims.judge.known(names), *extents(scene, names)]
        angles = claims.judge.write(_COMPARE, pool, Relation(((less,),)))
        if angles is None:
            continue
        every = {let.letter for let in _lets(claims)} | names
        pool = [line_of_sum, angles, *extents(scene, every)]
        last = claims.judge.write(_COMPARE, pool, relation)
        if last is not None:
            return last
    return None


def _which_is_less(claims: Comparing, link: Link, angle: Expression) -> Link | None:
    """What an inequality says of an angle of the motion and one of the data: ``β <= α``."""
    left, right = (_in_two(claims, side) for side in (link.left, link.right))
    if left is None or right is None or not isinstance(angle, Letter):
        return None
    gap = expanded(left - right)
    if len(gap.free_symbols) != 2 or angle.name not in symbol_names(gap):
        return None
    symbol, other = sorted(gap.free_symbols, key=lambda s: s.name != angle.name)
    factor = gap.coeff(other)
    if not factor.is_number or expanded(gap - factor * (other - symbol)) != 0:
        return None
    sign = link.sign if factor < 0 else FLIPPED[link.sign]
    return Link(angle, sign, tree_of(other, angle=True))


def _in_two(claims: Comparing, tree: Expression) -> sp.Expr | None:
    """A side of an inequality in letters of angles, with those put in that lines make of others."""
    scene = claims.scene
    named = {let.quantity: let.letter for let in _lets(claims)}
    sums = {
        link.left: link.right
        for line in scene.desk.lines
        if isinstance(line.relation, Relation) and len(line.relation.options) == 1
        for link in line.relation.only[:1]
        if line.move.record in ("sum", "difference")
    }

    def change(tree: Expression) -> Expression:
        letter = Letter(named[tree]) if tree in named else tree
        return sums.get(letter, letter)

    put = rebuilt(tree, change)
    symbols = {name: sp.Symbol(name) for name in named.values()}
    try:
        return sp.sympify(scene.worth(put, symbols), strict=True)
    except (KeyError, TypeError):
        return None


def _lets(claims: Comparing) -> list[Meaning]:
    """What the letters of the working stand for."""
    lines = (line.relation for line in claims.scene.desk.lines)
    return [line for line in lines if isinstance(line, Meaning)]


_COMPARE = (Move("compare"),)
