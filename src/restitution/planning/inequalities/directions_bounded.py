"""Bounds of an angle that may be a right angle: by its cotangent, where it has no tangent."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, turned
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    letters,
    walk,
)
from restitution.planning.closing.cotangents import cotangent_of, write_ratio_of
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.velocity_formulas import body_and_stage, in_the_plane
from restitution.planning.inequalities.bounds_by_cotangents import cotangent_line
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.desk import NotPlannedError, Source
from restitution.planning.writing.forms import tree_of


def write_of_direction(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """The bounds of a direction by those of a ratio of it; None of another angle.

    A component that keeps its sign tells on which side the velocity points.
    """
    match quantities:
        case [Quantity("direction", _, int()) as direction] if all(
            link.sign in FLIPPED for link in relation.only
        ):
            pass
        case _:
            return None
    links = [_solved(claims, link, direction) for link in relation.only]
    whole = Relation((tuple(_as_bounds(links)),))
    mark = claims.worths.mark()
    velocity = Quantity("velocity", direction.arguments, direction.stage)
    claims.worths.determine(velocity)
    scene = claims.scene
    body, stage = body_and_stage(scene, direction)
    x, y = in_the_plane(scene, body, stage)
    for function, below in (("tan", x), ("cot", y)):
        if not _keeps_its_sign(claims, below):
            continue
        line = write_ratio_of(scene, direction, function, x, y)
        letter, let = letter_of(scene, direction)
        ratio = Apply(function, Letter(letter))
        ends = [own for link in links if (own := _bound(claims, ratio, link)) is not None]
        if len(ends) < len(links):
            continue
        between = Relation((tuple(_as_bounds(ends)),))
        bounds = claims.monotone(line, between) or claims.compared([line], between)
        if bounds is not None:
            known = claims.worths.known_in(_value(claims, scene.desk.last_link(line).right))
            pool = [bounds, let, *y.whole, *x.whole, *known]
            last = claims.judge.write((Move("compare"),), pool, whole)
            if last is None:
                side = _side(claims, direction, [let, *y.whole, *known], scene.model.sign(y.value))
                names = {name for link in links for name in letters(link.right)}
                pool = [bounds, let, *(() if side is None else (side,)), *claims.judge.known(names)]
                last = claims.judge.write((Move("compare"),), pool, whole)
            if last is not None and whole != relation:
                last = claims.judge.write((Move("compare"), Move("rearrange")), [last], relation)
            if last is not None:
                return last
        claims.worths.back(mark)
        claims.worths.determine(velocity)
    claims.worths.back(mark)
    return None


def write_of_wide_angle(
    claims: Comparing,
    quantities: Sequence[Quantity],
    relation: Relation,
    *,
    also_acute: bool = False,
) -> int | None:
    """The bounds of an angle that may be obtuse, by those of its cotangent, which falls.

    None where a tangent does as well, which it does for ``also_acute`` bounds where the angle is
    acute, and where none is defined by a quotient.
    """
    # The statement may have a letter for the angle.
    opened = [
        Link(claims.worths.opened(link.left), link.sign, claims.worths.opened(link.right))
        for link in relation.only
    ]
    match quantities:
        case [Quantity(kind) as angle] if kind in UNSIGNED_ANGLES and all(
            link.sign in FLIPPED and angle in (link.left, link.right) for link in opened
        ):
            links = [_solved(claims, link, angle) for link in opened]
        case _:
            return None
    to_a_wall = angle.kind == "angle" and any(isinstance(e, Name) for e in angle.arguments)
    if (all(_is_acute(claims, link) for link in links) and not also_acute) or to_a_wall:
        return None
    mark = claims.worths.mark()
    scene = claims.scene
    try:
        tangent = claims.worths.angle_by_letter(angle) or claims.worths.angle(angle)
        letter, let = letter_of(scene, angle)
        line = cotangent_of(scene, tangent, letter)
        if line is None and also_acute:
            claims.worths.back(mark)
            claims.worths.determine_angle(angle)
            letter, let = letter_of(scene, angle)
            line = cotangent_line(scene, angle, letter, let)
    except NotPlannedError:
        claims.worths.back(mark)
        return None
    ratio = Apply("cot", Letter(letter))
    ends = [own for link in links if (own := _bound(claims, ratio, link)) is not None]
    if line is not None and len(ends) == len(links):
        between = Relation((tuple(_as_bounds(ends)),))
        bounds = claims.monotone(line, between) or claims.compared([line], between)
        if bounds is not None:
            names = {name for link in links for name in letters(link.right)}
            pool = [bounds, let, f"0° <= {letter} <= 180°", *claims.judge.known(names)]
            by_tangent = Relation(
                tuple(tuple(_by_tangent(claims, e) for e in links) for links in relation.options)
            )
            last = claims.judge.write((Move("compare"),), pool, by_tangent)
            if last is not None:
                return last
    claims.worths.back(mark)
    return None


def _by_tangent(claims: Comparing, link: Link) -> Link:
    """A bound with an inverse cosine or sine as an inverse tangent."""
    sides: list[Expression] = []
    for side in (link.left, link.right):
        match side:
            case Apply("arccos" | "arcsin"):
                sides.append(Apply("arctan", tree_of(tidy(sp.tan(_value(claims, side))))))
            case _:
                sides.append(side)
    return Link(sides[0], link.sign, sides[1])


def _is_acute(claims: Comparing, link: Link) -> bool:
    """Whether a bound is a number that is less than 90°."""
    value = _value(claims, link.right)
    return bool(value.is_number and value < sp.pi / 2)


def _solved(claims: Comparing, link: Link, direction: Quantity) -> Link:
    """A bound with the direction alone on the left: ``θ ≥ 90°`` of ``180° − θ ≤ 90°``."""
    sides = (link.left, link.right)
    own = link if any(node == direction for node in walk(sides[0])) else turned(link)
    match own.left:
        case Binary("-", other, angle) if angle == direction:
            value, sign = _value(claims, other) - _value(claims, own.right), FLIPPED[own.sign]
        case Binary("-", angle, other) if angle == direction:
            value, sign = _value(claims, own.right) + _value(claims, other), own.sign
        case _:
            return own
    return Link(direction, sign, tree_of(value, angle=True))


def _value(claims: Comparing, tree: Expression) -> sp.Expr:
    return sp.sympify(claims.scene.scalar(tree), strict=True)


def _as_bounds(links: Sequence[Link]) -> Iterator[Link]:
    """Bounds as ``a <= θ <= b``, where there are two."""
    lower = [link for link in links if link.sign in (">", ">=")]
    if len(links) == 2 and len(lower) == 1:
        yield turned(lower[0])
        yield next(link for link in links if link is not lower[0])
    else:
        yield from links


def _side(claims: Comparing, direction: Quantity, pool: Sequence[Ref], sign: int) -> int | None:
    """The line that says on which side of **i** a velocity points."""
    low, high = (0, 180) if sign > 0 else (-180, 0)
    ends = [tree_of(sp.Integer(number) * sp.pi / 180, angle=True) for number in (low, high)]
    links = (Link(ends[0], "<", direction), Link(direction, "<", ends[1]))
    return claims.judge.write((Move("sign"),), pool, Relation((links,)))


def _keeps_its_sign(claims: Comparing, component: Source) -> bool:
    """Whether a component is not zero, whatever the letters are."""
    model = claims.scene.model
    sign = model.sign(component.value)
    return bool(sign) and bool(model.decide(sign * model.in_data(component.value), ">", 0))


def _bound(claims: Comparing, ratio: Apply, link: Link) -> Link | None:
    """The bound of a ratio that belongs to one of its direction, with the ratio on the left.

    None where there is none: a right angle has no tangent.
    """
    angle = _value(claims, link.right)
    there = sp.tan(angle) if ratio.function == "tan" else sp.cot(angle)
    sign = link.sign if ratio.function == "tan" else FLIPPED[link.sign]
    return None if there.has(sp.zoo) else Link(ratio, sign, tree_of(tidy(there)))


__all__ = ["write_of_direction", "write_of_wide_angle"]
