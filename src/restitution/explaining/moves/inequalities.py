"""Lines that the oracle proves by what they cite."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from restitution.explaining.data.setting import Cited
from restitution.explaining.lines.derivation import BEARINGS, Link, Meaning, Relation, turned
from restitution.explaining.lines.quotients import NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import (
    exchanged,
    of_relation,
    trees_of,
)
from restitution.explaining.moves.bases import FLIPPED, equal_in
from restitution.explaining.moves.directions import (
    between_ratios,
    is_bounded_cotangent,
    speaks_of_an_angle,
)
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import Role


def is_of_vectors(link: Link) -> bool:
    """Whether an inequality is about a scalar product, such as that bodies approach."""
    return (
        link.sign in ("<", "<=", ">", ">=")
        and isinstance(link.left, Quantity)
        and (link.left.kind == "dot")
    )


def is_contradicted(step: Step, option: tuple[Link, ...], bound: Link) -> bool:
    """Whether an inequality is false, with an option and all else that is cited put in."""
    chosen = step.under(cited=(*step.cited, Cited("", Relation((option,)))))
    try:
        value = chosen.residual(bound, chosen.rules())
    except NotComparableError:
        return False
    if isinstance(value, Plane):
        return False
    if value.vanishes:
        return bound.sign in ("<", ">")
    if any(key[0] in ("quantity", "x", "y") for key in chosen.world.keys(value.above).values()):
        return False
    sign = chosen.signs.of(value)
    return sign is not None and sign != 0 and (sign > 0) == (bound.sign[0] == "<")


def is_at_rest_in(step: Step, option: tuple[Link, ...], bearing: Link) -> bool:
    """Whether an option leaves a body at rest that has, by what is cited, a direction."""
    if bearing.sign not in BEARINGS:
        return False
    chosen = step.under(cited=(*step.cited, Cited("", Relation((option,)))))
    rules = chosen.rules()
    for side in (bearing.left, bearing.right):
        if not isinstance(side, Quantity) or side.kind != "velocity":
            continue
        value = rules.put_into(chosen.world.value(side))
        if isinstance(value, Plane) and value.x.vanishes and value.y.vanishes:
            return True
    return False


def same_option(step: Step, a: tuple[Link, ...], b: tuple[Link, ...]) -> bool:
    """Whether two options say the same, link by link."""
    if len(a) != len(b):
        return False
    for one, other in zip(a, b, strict=True):
        if one == other:
            continue
        if one.sign != other.sign or one.sign != "=":
            return False
        if step.is_multiple(step.residual(one), step.residual(other)) is None:
            return False
    return True


_RATIOS = ("sin", "cos", "tan")


def by_oracle(step: Step, relation: Relation) -> bool:
    """Whether a relation is proved by what is cited, and by that alone.

    Of directions, and of decimals, there is nothing to prove in this way.
    """
    if any(link.sign not in FLIPPED for links in relation.options for link in links):
        return False
    if _by_ratios_as_letters(step, relation):
        return True
    return step.oracle.proves(step.formula(relation))


def _by_ratios_as_letters(step: Step, relation: Relation) -> bool:
    """Whether a relation is proved with a letter for each ratio of a sum of angles in it.

    What holds whatever tan(α − β) is needs no formula for that, and is proved sooner.
    """
    sums = [
        node
        for tree in trees_of(relation)
        for node in walk(tree)
        if isinstance(node, Apply) and node.function in _RATIOS
        if is_binary(node.argument, "+", "-")
    ]
    if not sums:
        return False
    names: dict[Expression, Expression] = {
        node: Letter(f"ratio_{n}") for n, node in enumerate(dict.fromkeys(sums))
    }

    def change(tree: Expression) -> Expression:
        return exchanged(tree, names)

    cited = tuple(
        replace(premise, relation=of_relation(premise.relation, change))
        if isinstance(premise.relation, Relation)
        else premise
        for premise in step.cited
    )
    plain = step.under(cited=cited)
    return plain.oracle.proves(plain.formula(of_relation(relation, change)))


def is_comparison(step: Step, relation: Relation) -> bool:
    """Whether an inequality is proved by the lines that are cited."""
    # The direction of a line of centres is no line that is compared.
    lines = [
        premise
        for premise in step.cited
        if isinstance(premise.relation, Relation) and not str(premise.ref).startswith("axis ")
    ]
    relations = [*(line.relation for line in lines), *(premise.relation for premise in step.known)]
    if number_compared(relations) > MOST_COMPARED:
        return False
    signs = {link.sign for links in relation.options for link in links}
    if "≈" in signs or ("=" in signs and any(_is_equation(line.relation) for line in lines)):
        return False
    # No less than a value, and no more: so it is that.
    return is_certain(step, relation)


def number_compared(relations: Iterable[Relation | Meaning]) -> int:
    """How many relations are compared: both ends of the range of a letter are one."""
    ranges: set[Expression] = set()
    others = 0
    for relation in relations:
        match relation:
            case Relation(((Link(Letter() as letter, sign, bound),),)) if (
                sign in FLIPPED and not letters(bound)
            ):
                ranges.add(letter)
            case _:
                others += 1
    return others + len(ranges)


def _is_equation(relation: Relation | Meaning) -> bool:
    return isinstance(relation, Relation) and any(
        link.sign == "=" for links in relation.options for link in links
    )


def is_certain(step: Step, relation: Relation) -> bool:
    """Whether what is cited proves a relation: of inverse tangents first by the tangents."""
    if speaks_of_an_angle(step, relation) and between_ratios(step, relation):
        return True
    if is_bounded_cotangent(step, relation) or _is_tangent_of_a_bound(step, relation):
        return True
    proofs = [by_oracle, between_tangents]
    if any(
        is_function(node, "arctan")
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
        for node in walk(side)
    ):
        proofs.reverse()
    return any(proof(step, relation) for proof in proofs)


def between_tangents(step: Step, relation: Relation) -> bool:
    """An angle of up to 180° between bounds of which its tangent is between the tangents.

    A difference of two may be above -90° as well. What bounds it is at least 0 and less than 90°,
    and the least tangent is not negative, or the tangent is cited as positive: so the angle is
    acute too, and grows with its tangent.
    """
    if len(relation.options) != 1:
        return False
    named: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    cited = {named.get(Letter(n), Letter(n)) for n, r in step.roles.items() if r.kind == "angle"}
    ratios = [
        (named.get(side.argument, side.argument), link)
        for other in step.links
        for link in (other, turned(other))
        for side in (link.left,)
        if is_function(side, "tan") and link.sign in FLIPPED
    ]
    positive = False
    for link in relation.only:
        for angle, own in (
            (link.left, link),
            (link.right, turned(link)),
        ):
            role = step.setting.of_angle(named.get(angle, angle))
            if role is None and isinstance(angle, Letter):
                role = step.setting.role(angle.name)  # a letter of the statement
            if named.get(angle, angle) not in cited:
                continue
            if role is None or not _is_acute_or_has_a_negative_tangent(role):
                continue
            tangents = [r for a, r in ratios if a == named.get(angle, angle) and r.sign == own.sign]
            if not any(_is_tangent_below_90(step, own.right, r.right) for r in tangents):
                return False
            above = (r.right for a, r in ratios if a == named.get(angle, angle) and r.sign == ">")
            positive = positive or own.sign[0] == ">" or role.high == sp.pi / 2
            positive = positive or any(_is_never_negative(step, tree) for tree in above)
            break
        else:
            return False
    return positive


def _is_tangent_of_a_bound(step: Step, relation: Relation) -> bool:
    """Whether a tangent is bounded by that of a bound below 90° of an angle from 0°, as tan β ≤
    2 + √3 where β ≤ 75°. For a least value the angle is at most 90° as well.
    """
    named: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    bounds = [own for other in step.links for own in (other, turned(other))]
    for links in relation.options:
        for link in links:
            if not is_function(link.left, "tan") or link.sign not in FLIPPED:
                return False
            angle = named.get(link.left.argument, link.left.argument)
            role = step.setting.of_angle(angle)
            if role is None or role.low != 0 or role.high not in (sp.pi / 2, sp.pi):
                return False
            if link.sign[0] == ">" and role.high != sp.pi / 2:
                return False
            if not any(
                named.get(own.left, own.left) == angle
                and own.sign == link.sign
                and _is_tangent_below_90(step, own.right, link.right)
                for own in bounds
            ):
                return False
    return len(relation.options) == 1


def _is_acute_or_has_a_negative_tangent(role: Role) -> bool:
    """Whether an angle is from 0, or above -90°, to 90° or 180°."""
    from_zero = role.low == 0
    from_below = role.low == -sp.pi / 2 and not role.closed[0]
    return (from_zero or from_below) and role.high in (sp.pi / 2, sp.pi)


def _is_tangent_below_90(step: Step, angle: Expression, ratio: Expression) -> bool:
    """Whether a ratio is the tangent of an angle that is certain to be acute, or 0."""
    bound, value = (
        step.world.expression(step.world.scalar(tree), step.roles) for tree in (angle, ratio)
    )
    tangent = sp.tan(bound).replace(sp.cot, lambda x: 1 / sp.tan(x))
    if isinstance(bound, sp.atan):
        inside = step.oracle.proves(Claim(bound.args[0], ">="))
    else:
        inside = step.oracle.proves(Claim(bound, ">=")) and step.oracle.proves(
            Claim(sp.pi / 2 - bound, ">")
        )
    return inside and equal_in(step, tangent, value)


def _is_never_negative(step: Step, tree: Expression) -> bool:
    value = step.world.expression(step.world.scalar(tree), step.roles)
    return step.oracle.proves(Claim(value, ">="))


MOST_COMPARED = 3


def is_completed(step: Step, relation: Relation) -> bool:
    """A square and a constant, or a sum of two that is least where they are equal."""
    if all(link.sign == "=" for links in relation.options for link in links):
        if step.links or len(relation.options) != 1:
            return False
        return all(_is_identical(step, link) for link in relation.only)
    return not step.links and by_oracle(step, relation)


def _is_identical(step: Step, link: Link) -> bool:
    """Whether both sides are one as soon as the letter for them is put in."""
    value = step.residual(link, step.rules())
    return isinstance(value, Quotient) and value.vanishes
