"""Angles between bounds: a ratio of them grows, or falls, on one side of a line."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.explaining.lines.derivation import FLIPPED, Link, Relation, Sign, turned
from restitution.explaining.lines.quotients import NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import settled
from restitution.explaining.moves.bases import equal_in
from restitution.explaining.steps.step import Step
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    is_function,
)
from restitution.oracle import Relation as Claim
from restitution.oracle import compared
from restitution.records import dataclass

RIGHT = sp.pi / 2
ZERO = Number(Fraction(0))


def speaks_of_an_angle(step: Step, relation: Relation) -> bool:
    """Whether a relation bounds an angle of the motion."""
    return any(
        _angle(step, side) is not None
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
    )


def between_ratios(step: Step, relation: Relation) -> bool:
    """An angle between bounds of which its tangent, or cotangent, is between those ratios.

    The tangent grows with a direction on either side of **j**, the cotangent falls on either side
    of **i**: on which side a velocity points, a component of it tells that is cited. Of an angle of
    up to 180° the cotangent falls.
    """
    if len(relation.options) != 1:
        return False
    angles = {
        angle
        for link in relation.only
        for side in (link.left, link.right)
        for angle in (_angle(step, side),)
        if angle is not None
    }
    if len(angles) != 1:
        return False
    (angle,) = angles
    if _is_in_a_half_plane(step, relation, angle) or _is_by_components(step, relation, angle):
        return True
    for function in ("tan", "cot"):
        ratios = list(_bounds_of(step, Apply(function, angle)))
        window = _window(step, angle, function, ratios) if ratios else None
        if window is not None and all(
            _is_bounded(step, link, angle, function, ratios, window) for link in relation.only
        ):
            return True
    return False


def is_bounded_cotangent(step: Step, relation: Relation) -> bool:
    """A bound of a cotangent by one of its angle that is cited: from 0° to 180° it falls.

    So it does with a direction on either side of **i**. The line that gives the cotangent is cited
    too.
    """
    match relation.options:
        case ((Link(Apply("cot", side), sign, right),),) if sign in FLIPPED:
            angle = _angle(step, side)
        case _:
            return False
    if angle is None:
        return False
    defined = any(
        link.sign == "="
        and is_function(link.left, "cot")
        and _angle(step, link.left.argument) == angle
        for link in step.links
    )
    window = _window(step, angle, "cot", [])
    if not defined or window is None:
        return False
    for link in step.links:
        own = link if _angle(step, link.left) == angle else turned(link)
        if _angle(step, own.left) != angle or own.sign != FLIPPED[sign]:
            continue
        bound = _value(step, own.right)
        inside = compared(bound, ">", window.low), compared(bound, "<", window.high)
        between = bound.is_number and all(map(step.oracle.proves, inside))
        if between and equal_in(step, sp.cot(bound), _value(step, right)):
            return True
    return False


def is_of_a_cotangent(step: Step, link: Link) -> bool:
    """Whether an angle of up to 180° is 90° less the inverse tangent of its cited cotangent.

    So is a direction above **i**; below it, it is that less 180°. A component that is cited tells
    on which side it is.
    """
    angle = _angle(step, link.left)
    if angle is None or link.sign != "=":
        return False
    ratios = [
        link.right
        for link in step.links
        if link.sign == "="
        and is_function(link.left, "cot")
        and _angle(step, link.left.argument) == angle
    ]
    if angle.kind == "direction":
        up = {_UP: 1, _DOWN: -1}.get(_half_plane(step, angle), 0)  # type: ignore[arg-type]
    else:
        up = 1 if ratios and _is_cited_to_180(step, angle) else 0
    value = _value(step, link.right)
    whole, arc = value.as_independent(*value.free_symbols, as_Add=True)
    factor, inverse = arc.as_coeff_Mul()
    if not ratios or not up or whole != up * RIGHT or not isinstance(inverse, sp.atan):
        return False
    return factor in (1, -1) and any(
        equal_in(step, -factor * inverse.args[0], _value(step, ratio)) for ratio in ratios
    )


def _angle(step: Step, side: Expression) -> Quantity | None:
    """An angle of the motion that a side is, or for which it is a letter."""
    if isinstance(side, Letter):
        side = next((let.quantity for let in step.lets if let.letter == side.name), side)
    if isinstance(side, Quantity) and side.kind in ANGLES:
        return side
    return None


def _is_cited_to_180(step: Step, angle: Quantity) -> bool:
    """Whether it is cited that an angle is from 0° to 180°, or less."""
    role = step.setting.of_angle(angle)
    names = {let.letter for let in step.lets if let.quantity == angle}
    cited = any(names & premise.letters for premise in step.known)
    return cited and role is not None and role.low == 0


def _bounds_of(step: Step, ratio: Apply) -> Iterator[Link]:
    """What is cited of a ratio of a direction, with that on the left."""
    for link in step.links:
        for own in (link, turned(link)):
            match own.left:
                case Apply(function, argument) if function == ratio.function:
                    if own.sign in FLIPPED and _angle(step, argument) == ratio.argument:
                        yield Link(ratio, own.sign, own.right)


@dataclass(frozen=True)
class _Window:
    """The directions between two in which a ratio only grows, or only falls."""

    low: sp.Expr
    high: sp.Expr
    closed: bool = False  # whether the greatest belongs to them
    from_low: bool = False  # whether the least does


_UP, _DOWN = _Window(sp.Integer(0), sp.pi), _Window(-sp.pi, sp.Integer(0))


def _is_in_a_half_plane(step: Step, relation: Relation, angle: Quantity) -> bool:
    """Whether a relation only says to which side a velocity points, as a component of it tells."""
    if angle.kind != "direction":
        return False
    if len(relation.only) != 2 or not all(
        isinstance(side, Degrees | Negate) or _angle(step, side) is not None
        for link in relation.only
        for side in (link.left, link.right)
    ):
        return False
    window = _Window(*(_value(step, end) for end in _ends(relation)))
    return window in (_UP, _DOWN) and window == _half_plane(step, angle)


def _is_by_components(step: Step, relation: Relation, angle: Quantity) -> bool:
    """Whether the signs of components that are cited bound an angle by right angles.

    A direction lies in the quadrant that both components tell. An angle between two velocities, or
    of one to a direction, is obtuse where the scalar product is negative.
    """
    bounds: list[tuple[Sign, sp.Expr]] = []
    for link in relation.only:
        own = link if _angle(step, link.left) == angle else turned(link)
        if own.sign not in FLIPPED or not isinstance(own.right, Degrees | Negate | Number):
            return False
        bounds.append((own.sign, _value(step, own.right)))
    if not all((bound / RIGHT).is_Integer for _, bound in bounds):
        return False
    extent = _quadrant(step, angle)
    return extent is not None and all(
        (extent.low >= bound and (sign == ">=" or not extent.from_low)) or extent.low > bound
        if sign[0] == ">"
        else (extent.high <= bound and (sign == "<=" or not extent.closed)) or extent.high < bound
        for sign, bound in bounds
    )


def _quadrant(step: Step, angle: Quantity) -> _Window | None:
    """The angles that the cited signs of components, or of a scalar product, leave."""
    if angle.kind == "direction":
        velocity = Quantity("velocity", angle.arguments, angle.stage)
        x, y = (
            _proved_sign(step, Quantity("along", (velocity, Unit(unit)))) for unit in ("i", "j")
        )
        return {
            (1, 1): _Window(sp.Integer(0), RIGHT),
            (-1, 1): _Window(RIGHT, sp.pi),
            (-1, -1): _Window(-sp.pi, -RIGHT),
            (1, -1): _Window(-RIGHT, sp.Integer(0)),
            (1, 0): _Window(-RIGHT, RIGHT),
        }.get((x, y))
    product = _product_of(step, angle)
    if product is None:
        return None
    windows = {1: (sp.Integer(0), RIGHT), -1: (RIGHT, sp.pi)}
    if (window := windows.get(_proved_sign(step, product))) is not None:
        low, high = window
        return _Window(low, high, from_low=low == 0, closed=low == RIGHT)
    # Where it may be zero the angle may be a right angle.
    window = windows.get(_proved_sign(step, product, _WEAK))
    return None if window is None else _Window(*window, from_low=True, closed=True)


def _product_of(step: Step, angle: Quantity) -> Quantity | None:
    """The scalar product of what an angle is between, or the component of which it has the sign."""
    match angle:
        case Quantity("deflection", (body,), int(event)):
            pair = tuple(Quantity("velocity", (body,), number) for number in (event - 1, event))
        case Quantity("angle", (Quantity("velocity") as velocity, Unit() as axis)):
            return Quantity("along", (velocity, axis))
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity")) as pair):
            pass
        case _:
            return None
    own = settled(Quantity("dot", pair), step.setting.events)
    assert isinstance(own, Quantity)
    return own


_STRICT: tuple[tuple[int, Sign], ...] = ((1, ">"), (-1, "<"))
_WEAK: tuple[tuple[int, Sign], ...] = ((1, ">="), (-1, "<="))


def _proved_sign(
    step: Step, scalar: Expression, orders: tuple[tuple[int, Sign], ...] = _STRICT
) -> int:
    """1 or −1 where what is cited proves that a scalar has this sign; 0 where it does not."""
    for sign, order in orders:
        try:
            claim = step.formula(Relation(((Link(scalar, order, ZERO),),)))
        except NotComparableError:
            return 0
        if step.oracle.proves(claim):
            return sign
    return 0


def _ends(relation: Relation) -> tuple[Expression, Expression]:
    """The bounds of what stands between two."""
    return relation.only[0].left, relation.only[-1].right


def _cited_half_plane(step: Step, angle: Quantity) -> _Window | None:
    """Between which directions a velocity points, where a line tells it."""
    for premise in step.cited:
        match premise.relation:
            case Relation(((Link(Degrees() | Negate(), "<", one), Link(two, "<", _)),)):
                if one == two and _angle(step, one) == angle:
                    return _Window(*(_value(step, end) for end in _ends(premise.relation)))
    return None


def _half_plane(step: Step, angle: Quantity) -> _Window | None:
    """On which side of **i** a velocity points, as far as its cited component tells."""
    return {1: _UP, -1: _DOWN}.get(_sign(step, _components(step, angle)[1]))


def _components(step: Step, angle: Quantity) -> tuple[Quotient | None, Quotient | None]:
    """The components of a velocity as lines give them; None for one that is not cited."""
    velocity = step.world.value(Quantity("velocity", angle.arguments, angle.stage))
    known = step.rules().put_into(velocity) if isinstance(velocity, Plane) else None
    if not isinstance(velocity, Plane) or not isinstance(known, Plane):
        return None, None
    return (
        None if known.x == velocity.x else known.x,
        None if known.y == velocity.y else known.y,
    )


def _window(step: Step, angle: Quantity, function: str, ratios: list[Link]) -> _Window | None:
    """Where a velocity points, as far as is cited; None where that is open."""
    if angle.kind != "direction":
        return _UP if function == "cot" and _is_cited_to_180(step, angle) else None
    x, y = _components(step, angle)
    side = _cited_half_plane(step, angle)
    up = _sign(step, y) or {_UP: 1, _DOWN: -1}.get(side, 0)  # type: ignore[arg-type]
    if function == "cot":
        return {1: _UP, -1: _DOWN}.get(up)
    ahead = _sign(step, x) or up * _sign_of_bounds(step, ratios)
    if ahead == 1:
        return _Window(-RIGHT, RIGHT)
    if ahead == -1 and up == 1:
        return _Window(RIGHT, sp.pi, closed=True)
    return _Window(-sp.pi, -RIGHT) if ahead == -1 and up == -1 else None


def _sign(step: Step, component: Quotient | None) -> int:
    """The sign of a component that is cited and cannot be zero; 0 where that is open."""
    if component is None:
        return 0
    try:
        value = step.world.expression(component, step.roles)
    except NotComparableError:
        return 0
    if step.oracle.proves(Claim(value, ">")):
        return 1
    return -1 if step.oracle.proves(Claim(-value, ">")) else 0


def _sign_of_bounds(step: Step, ratios: list[Link]) -> int:
    """The sign that bounds of a tangent tell: 0 where they allow both."""
    for sign, bound in ((1, ">"), (-1, "<")):
        for ratio in ratios:
            if ratio.sign[0] != bound:
                continue
            value = sign * _value(step, ratio.right)
            if step.oracle.proves(Claim(value, ">=")):
                return sign
    return 0


def _is_bounded(
    step: Step, link: Link, angle: Quantity, function: str, ratios: list[Link], window: _Window
) -> bool:
    """Whether a bound of a direction lies in a window, and its ratio is a bound of the ratio."""
    own = link if _angle(step, link.left) == angle else turned(link)
    if own.sign not in FLIPPED:
        return False
    bound = _value(step, own.right)
    upper = "<=" if window.closed else "<"
    inside = compared(bound, ">", window.low), compared(bound, upper, window.high)
    there = sp.tan(bound) if function == "tan" else sp.cot(bound)
    sign = own.sign if function == "tan" else FLIPPED[own.sign]
    return (
        all(map(step.oracle.proves, inside))
        and not there.has(sp.zoo)
        and any(
            ratio.sign == sign and equal_in(step, there, _value(step, ratio.right))
            for ratio in ratios
        )
    )


def _value(step: Step, tree: Expression) -> sp.Expr:
    return step.world.expression(step.world.scalar(tree), step.roles)


__all__ = ["between_ratios", "is_bounded_cotangent", "is_of_a_cotangent", "speaks_of_an_angle"]
