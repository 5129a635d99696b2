"""Angles by their ratios, and ratios by each other."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.explaining.definitions.senses import ranges_cited
from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.moves.bases import base_of, flat
from restitution.explaining.moves.directions import is_of_a_cotangent
from restitution.explaining.moves.inequalities import by_oracle
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    is_zero,
    letters,
    rational,
    walk,
)
from restitution.oracle import Oracle, compared
from restitution.oracle import Relation as Claim

RATIOS = ("sin", "cos", "tan")


def is_triangle(step: Step, relation: Relation) -> bool:
    """The ratios of an angle, or their squares, where one of them is known, and its range."""
    base = base_of(step)
    if base is None or len(base.options) != 1 or len(relation.options) != 1 or not step.known:
        return False
    known = {_argument(link.left) for link in base.only}
    return all(
        link.sign == "="
        and (angle := _argument(link.left)) is not None
        and angle in known
        and not any(isinstance(node, Apply) and _is_open(node) for node in walk(link.right))
        for link in relation.only
    ) and by_oracle(step, relation)


def _is_open(node: Apply) -> bool:
    """Whether a function is none of a number: no root, and no cos 25°."""
    return node.function != "sqrt" and not (node.function in RATIOS and not letters(node))


def _argument(tree: Expression) -> Expression | None:
    """The angle of a ratio, or of the square of one."""
    match tree:
        case Binary("^", Apply() as ratio, Number(2)):
            return _argument(ratio)
        case Apply(function, angle) if function in RATIOS:
            return angle
    return None


def is_inverse(step: Step, relation: Relation) -> bool:
    """The angle of a ratio: the only one in the range that is cited."""
    if len(relation.options) != 1:
        return False
    cited = [
        link
        for premise in step.cited
        if isinstance(premise.relation, Relation) and len(premise.relation.options) == 1
        for link in flat(premise.relation.only)
    ]
    if len(relation.only) != 1:
        return False
    (link,) = relation.only
    if is_of_a_cotangent(step, link) or _is_zero_of_a_sum(step, link, cited):
        return True
    ratios_ = filter(None, (_ratio_of(step, link) for link in cited))
    ratios = [ratio for ratio in ratios_ if _is_multiple_of(step, link, ratio[0].argument)]
    if not ratios or link.sign != "=":
        return False
    # Of a chain the last side is the shortest.
    ratio_, value = [ratio for ratio in ratios if ratio[0] == ratios[0][0]][-1]
    angle = in_radians(step, _scaled_angle(step, link, ratio_.argument))
    exact = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}[ratio_.function](angle)
    low, high, closed = _range_of(step, ratio_.argument)
    if low is None or high is None:
        return False
    if not (
        _only_there(ratio_.function, low, high)
        or _but_straight(step, ratio_, value, high)
        or _in_its_quadrant(step, ratio_, angle)
        or _by_its_other_ratio(step, ratio_, angle, high - low)
    ):
        return False
    if link.left == ratio_.argument and _is_principal(ratio_.function, low, high):
        # Of what stands on paper as the ratio nothing else has to be known.
        values = [tree for other, tree in ratios if other == ratio_]
        if any(link.right == Apply(f"arc{ratio_.function}", value) for value in values):
            return True
    sign = "<=" if closed else "<"
    return _equal(step, exact, in_radians(step, value)) and all(
        step.oracle.proves(compared(a, sign, b)) for a, b in _bounds_of(angle, low, high)
    )


def _is_zero_of_a_sum(step: Step, link: Link, cited: Sequence[Link]) -> bool:
    """Whether a sum of acute angles has the one value at which its sine, or cosine, is zero."""
    ratios = (_ratio_of(step, link) for link in cited)
    functions = [
        ratio_.function
        for ratio_, value in filter(None, ratios)
        if ratio_.argument == link.left and is_zero(value)
    ]
    turn = step.world.turn(link.left)
    if link.sign != "=" or not functions or not isinstance(link.left, Binary):
        return False
    acute = {
        atom
        for premise in step.known
        if premise.ref.startswith("acute")
        for atom, _ in step.world.turn(premise.relation.only[0].left).terms
    }
    if not acute.issuperset(atom for atom, _ in turn.terms):
        return False
    # In half turns, from the first zero on.
    start = Fraction(1, 2) if functions[0] == "cos" else Fraction(0)
    shift = Fraction(turn.degrees) / 180 - start
    counts = [Fraction(count) / 2 for _, count in turn.terms]
    low = shift + sum((count for count in counts if count < 0), Fraction(0))
    high = shift + sum((count for count in counts if count > 0), Fraction(0))
    zeros = [n for n in range(math.floor(low), math.ceil(high) + 1) if low < n < high]
    if len(zeros) != 1 or functions[0] not in ("sin", "cos"):
        return False
    exact = (sp.Rational(start.numerator, start.denominator) + zeros[0]) * sp.pi
    return _equal(step, in_radians(step, link.right), exact)


def _bounds_of(angle: sp.Expr, low: sp.Expr, high: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """What has to be in order for an angle to lie in a range: of arctan x, x and 0 for 0°."""
    plain = isinstance(angle, sp.atan)
    yield (sp.Integer(0), angle.args[0]) if plain and low == 0 else (low, angle)
    if not (plain and bool(high > sp.pi / 2)):
        yield angle, high


def _ratio_of(step: Step, link: Link) -> tuple[Apply, Expression] | None:
    """A sine, cosine or tangent and its value, where a link gives one; also by its letter."""
    left = link.left
    if isinstance(left, Letter):
        left = next((let.quantity for let in step.lets if let.letter == left.name), left)
    if link.sign == "=" and isinstance(left, Apply) and left.function in RATIOS:
        return left, link.right
    return None


def _is_multiple_of(step: Step, link: Link, argument: Expression) -> bool:
    a, b = step.world.turn(link.left), step.world.turn(argument)
    return bool(a.terms) and len(a.terms) == len(b.terms) == 1 and a.terms[0][0] == b.terms[0][0]


def _scaled_angle(step: Step, link: Link, argument: Expression) -> Expression:
    if link.left == argument:
        return link.right
    a, b = step.world.turn(link.left), step.world.turn(argument)
    factor = b.terms[0][1] / a.terms[0][1]
    scaled = Binary("*", rational(factor), link.right)
    shift = b.degrees - a.degrees * factor
    return scaled if not shift else Binary("+", scaled, Degrees(shift))


def in_radians(step: Step, tree: Expression) -> sp.Expr:
    """The value of a tree that is an angle, in radians."""
    value = step.world.scalar(tree)
    return step.world.expression(value, step.setting.roles)


def _equal(step: Step, a: sp.Expr, b: sp.Expr) -> bool:
    oracle = Oracle(step.setting.roles)
    return oracle.proves(Claim(a - b, "="))


def _range_of(step: Step, angle: Expression) -> tuple[Any, Any, bool]:
    """The range of an angle, as it is cited."""
    turn = step.world.turn(angle)
    if turn.degrees or len(turn.terms) != 1:
        return None, None, False
    ((atom, count),) = turn.terms
    for premise in step.known:
        if not premise.ref.startswith("acute"):
            continue
        own = step.world.turn(premise.relation.only[0].left)
        if not own.degrees and len(own.terms) == 1 and own.terms[0][0] == atom:
            part = count / own.terms[0][1]  # of an angle that is acute
            ends = sorted(
                (sp.Integer(0), sp.Rational(part.numerator, part.denominator) * sp.pi / 2)
            )
            return ends[0], ends[1], False
    role = step.setting.role(getattr(atom, "name", ""))
    cited = any(getattr(atom, "name", "") in entry.letters for entry in step.known)
    if role.low is None or role.high is None or not cited:
        return None, None, False
    factor = sp.Rational(count.numerator, count.denominator)
    ends = sorted((role.low * factor, role.high * factor))
    return ends[0], ends[1], any(role.closed)


def _is_principal(function: str, low: sp.Expr, high: sp.Expr) -> bool:
    """Whether a range lies within that of the inverse of a ratio."""
    if function == "cos":
        return bool(low >= 0 and high <= sp.pi)
    return bool(low >= -sp.pi / 2 and high <= sp.pi / 2)


def _only_there(function: str, low: sp.Expr, high: sp.Expr) -> bool:
    """Whether a ratio has no more than one angle in a range: it is monotone, or tan in less."""
    if function == "tan" and bool(high - low < sp.pi):
        return True
    # As far as the range is turned by half turns, the ratio is that of the inverse or its opposite.
    start = sp.Integer(0) if function == "cos" else -sp.pi / 2
    turns = sp.floor((low - start) / sp.pi)
    return _is_principal(function, low - turns * sp.pi, high - turns * sp.pi)


def _by_its_other_ratio(step: Step, ratio_: Apply, angle: sp.Expr, width: sp.Expr) -> bool:
    """Whether a line tells the quadrant of an angle with a tangent, within one turn.

    It says that a positive multiple of the sine or the cosine of the angle has some value.
    """
    if ratio_.function != "tan" or not bool(width <= 2 * sp.pi):
        return False
    own = in_radians(step, ratio_.argument)
    for link in step.links:
        if link.sign != "=":
            continue
        try:
            left, right = (in_radians(step, side) for side in (link.left, link.right))
        except NotComparableError:
            continue
        for function in (sp.sin, sp.cos):
            share = sp.cancel(left / function(own))
            if own.free_symbols & share.free_symbols or not step.oracle.proves(Claim(share, ">")):
                continue
            if step.oracle.proves(Claim(right * function(angle), ">")):
                return True
    return False


def _but_straight(step: Step, ratio_: Apply, value: Expression, high: sp.Expr) -> bool:
    """Whether an angle of up to 180° has a tangent that is not zero: there is one such angle."""
    number = in_radians(step, value)
    low = _range_of(step, ratio_.argument)[0]
    if ratio_.function != "tan" or low != 0 or not bool(high <= sp.pi):
        return False
    return Oracle(step.setting.roles).proves(Claim(number, "!="))


def _in_its_quadrant(step: Step, ratio_: Apply, angle: sp.Expr) -> bool:
    """Whether the direction of a velocity lies on the side to which its component points.

    Of the two directions with one tangent, the component in the direction of **i** tells which; of
    the two with one cosine, that in the direction of **j**.
    """
    match _meaning_of(step, ratio_.argument):
        case Quantity("direction", (Name() as body,), int(stage)) if ratio_.function != "sin":
            velocity = step.world.value(Quantity("velocity", (body,), stage))
        case _:
            return False
    known = step.rules().put_into(velocity)
    if not (isinstance(velocity, Plane) and isinstance(known, Plane)):
        return False
    if ratio_.function == "tan":
        before, after, side = velocity.x, known.x, sp.cos(angle)
    else:
        before, after, side = velocity.y, known.y, sp.sin(angle)
    if before == after:
        return False
    share = step.world.expression(after, step.roles)
    return step.oracle.proves(Claim(share * side, ">"))


def _meaning_of(step: Step, angle: Expression) -> Expression | None:
    """What a letter stands for: one of the working, or of the statement where that is cited."""
    meaning = step.setting.meanings.get(getattr(angle, "name", ""))
    if meaning is not None:
        return meaning.quantity
    for premise in step.cited:
        match premise.ref, premise.relation:
            case str(ref), Relation(((Link(quantity, "=", named),),)) if (
                named == angle and ref.startswith("let ")
            ):
                return quantity
    return None


def is_ratio_of(step: Step, value: Link, end: Link) -> bool:
    """Whether a ratio tells that an angle has a value: the only one in its range.

    A sine does so of an angle of up to 90°.
    """
    cosine, sine = (value.left == Apply(ratio, end.left) for ratio in ("cos", "sin"))
    if not cosine and not sine and value.left != Apply("tan", end.left):
        return False
    angle, ratio_ = in_radians(step, end.right), in_radians(step, value.right)
    oracle = Oracle(step.setting.roles, tuple(ranges_cited(step, given=True)))
    role = step.setting.of_angle(end.left)
    if isinstance(end.left, Letter):
        role = role or step.setting.role(end.left.name)
    if role is None or role.low is None or role.high is None:
        return False
    if cosine:
        within = (compared(angle, ">=", sp.Integer(0)), compared(angle, "<=", sp.pi))
        is_of_one = role.low >= 0 and role.high <= sp.pi
        return is_of_one and _equal(step, sp.cos(angle), ratio_) and all(map(oracle.proves, within))
    if sine:
        within = (compared(angle, ">=", sp.Integer(0)), compared(angle, "<=", sp.pi / 2))
        is_of_one = role.low >= 0 and role.high <= sp.pi / 2
        return is_of_one and _equal(step, sp.sin(angle), ratio_) and all(map(oracle.proves, within))
    below_right = isinstance(angle, sp.atan) or (angle.is_number and bool(abs(angle) < sp.pi / 2))
    if role.low >= -sp.pi / 2 and role.high <= sp.pi / 2 and below_right:
        return _equal(step, sp.tan(angle), ratio_)
    if role.low == -sp.pi / 2 and role.high == sp.pi and below_right:
        # A difference with an angle of up to 180°: of a positive tangent it is acute.
        return _equal(step, sp.tan(angle), ratio_) and oracle.proves(Claim(ratio_, ">"))
    if role.low != 0:
        return False
    inside = (compared(angle, ">", sp.Integer(0)), compared(angle, "<", sp.pi))
    return _equal(step, sp.tan(angle), ratio_) and all(map(oracle.proves, inside))
