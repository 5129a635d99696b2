"""Values put in, sides rearranged, squares undone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.explaining.data.offset_angles import named_angles
from restitution.explaining.lines.derivation import BEARINGS, Link, Relation, Sign
from restitution.explaining.lines.generators import Value
from restitution.explaining.lines.quotients import CONSTANT, NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.moves.bases import (
    FLIPPED,
    base_of,
    expected_residual,
    flat,
    from_base,
    matches,
    others_cited,
    with_base,
    without_angles,
)
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    is_function,
    walk,
)
from restitution.oracle import Relation as Claim


def is_put(step: Step, line: Link) -> bool:
    """Whether a line is its base with values put in that are cited."""
    step = from_base(step)
    base = base_of(step)
    if base is None or len(base.options) != 1:
        return False
    if step.move.id == "put" and len(step.cited) < 2:
        return False
    if step.move.id == "fact" and line.sign in BEARINGS:
        return line in base.only  # a direction is printed as it is given
    if step.move.id == "fact":
        for meaning, own in named_angles(step.lets, step.links, step.setting):
            if own.axis == line.left:
                # The angle that the offset gives has a letter.
                return is_put(with_base(step, (Link(own.axis, "=", own.at(meaning.letter)),)), line)
    if _is_in_letters(step, line, base):
        return True
    rules = step.rules(others_cited(step))
    if line.sign == "parallel to":
        return any(points_along(step, line, link, rules) for link in base.only)
    _note_divisor(step, line, rules)
    alone = _without_values(without_angles(step), line)
    if step.move.id == "put" and any(
        matches(alone, line, expected, link.sign)
        and (link.sign == "=" or not _is_replaced(alone, line, expected))
        for link in flat(base.only)
        for expected in (expected_residual(alone, link, Rules(alone.world)),)
    ):
        return False  # nothing is put in
    # A value may be put in, or its name for it.
    return any(
        matches_with(step, line, expected, rules, link.sign)
        and (link.sign in ("=", "!=") or not _is_replaced(step, line, expected))
        for link in (*flat(base.only), *_below_roots(step, base))
        for expected in (expected_residual(step, link, rules),)
    ) or _is_ratio_of_powers(step, line)


def _without_values(step: Step, line: Link) -> Step:
    """The step with its base alone, for an equation that cannot hold: k = −75/19 of a mass km.

    With the values that are put in it would be a multiple of any equation that cannot hold either.
    """
    own = step.residual(line) if line.sign == "=" else None
    if isinstance(own, Quotient) and step.signs.of(own, sure=False) is not None:
        base = base_of(step)
        return step.under(cited=tuple(one for one in step.cited if one.relation is base))
    return step


def _is_in_letters(step: Step, line: Link, base: Relation) -> bool:
    """Whether a line is its base with a letter for a sum or a difference of angles."""
    sums: dict[Expression, Expression] = {
        Letter(let.letter): let.quantity for let in step.lets if isinstance(let.quantity, Binary)
    }
    if not sums:
        return False
    left, right = (exchanged(side, sums) for side in (line.left, line.right))
    return Link(left, line.sign, right) in flat(base.only) and (left, right) != (
        line.left,
        line.right,
    )


def _is_ratio_of_powers(step: Step, line: Link) -> bool:
    """Whether a quotient of powers of quantities is what it is with the values that are cited.

    Of the square of a speed the line of the speed is no factor: what they come to is compared.
    """
    match line.left:
        case Binary("/", Binary("^", Quantity(), _), Binary("^", Quantity(), _)):
            pass
        case _:
            return False
    before, after = step.residual(line), step.residual(line, step.rules())
    return (
        line.sign == "="
        and isinstance(before, Quotient)
        and isinstance(after, Quotient)
        and after.vanishes
        and not before.vanishes
    )


def _below_roots(step: Step, base: Relation) -> Iterator[Link]:
    """A line with the values of letters below its roots, before roots of factors are taken.

    Of √(4a² − d²), in factors, the roots of both sums hold d, and their product would not be seen.
    An inverse sine has such a root for its cosine.
    """
    values: dict[Expression, Expression] = {
        link.left: link.right
        for premise in others_cited(step)
        if isinstance(premise.relation, Relation) and len(premise.relation.options) == 1
        for link in flat(premise.relation.only)
        if link.sign == "=" and isinstance(link.left, Letter)
    }
    for link in flat(base.only):
        below = {
            node
            for side in (link.left, link.right)
            for root in walk(side)
            if is_function(root, "sqrt", "arcsin", "arccos")
            for node in walk(root.argument)
        }
        if link.sign == "=" and below & values.keys():
            left, right = (exchanged(side, values) for side in (link.left, link.right))
            yield Link(left, "=", right)


def _note_divisor(step: Step, line: Link, rules: Rules) -> None:
    """Who writes the ratio of two quantities says that there is one: it is not divided by 0."""
    match line.left:
        case Binary("/", Quantity(), Quantity() as below):
            value = rules.put_into(step.world.value(below))
            if isinstance(value, Quotient) and not value.vanishes:
                step.world.denominators.append(value.above)


def points_along(step: Step, line: Link, base: Link, rules: Rules) -> bool:
    """Whether a line gives a direction of its base, with values put in: in the same sense."""
    if line.right == base.left:
        line = Link(line.right, line.sign, line.left)
    if base.sign != "parallel to" or line.left != base.left:
        return False
    own, other = step.world.pointing(line.right), step.world.pointing(base.right)
    own, other = rules.put_into(own), rules.put_into(other)
    if not (isinstance(own, Plane) and isinstance(other, Plane)):
        return False
    if not step.world.reduced(own.x * other.y - own.y * other.x).vanishes:
        return False
    pairs = [(a, b) for a, b in ((own.x, other.x), (own.y, other.y)) if not b.vanishes]
    # They are parallel: what one component is times the other, the second is too.
    return all(not a.vanishes for a, _ in pairs) and any(
        step.signs.of(a / b) == 1 for a, b in pairs
    )


def _is_replaced(step: Step, line: Link, expected: Value) -> bool:
    """Whether a quantity of an inequality stands no more in a line.

    Of two positive values either is the other times what is positive.
    """
    own = step.residual(line)
    if isinstance(own, Plane) or isinstance(expected, Plane):
        return False
    ours, theirs = (set(step.world.keys(quotient.above).values()) for quotient in (own, expected))
    named = {("letter", let.letter) for let in step.lets}
    return any(key[0] in ("quantity", "x", "y") or key in named for key in theirs - ours)


def is_rearrangement(step: Step, line: Link) -> bool:
    """Whether a line is its base with terms moved, multiplied through or simplified."""
    step = from_base(step)
    base = base_of(step)
    if base is None or len(base.options) != 1:
        return False
    if (
        step.move.id == "rearrange"
        and sum(isinstance(premise.relation, Relation) for premise in step.cited) > 1
    ):
        return _with_factor_known(step, line)
    return any(
        _same_direction(step, line, link)
        or _is_ratio_of_both(line, link)
        or _is_multiplied(step, line, link)
        or _is_squared(step, line, link)
        or is_root_of(step, line, link)
        or _is_size_of(step, line, link)
        or matches(step, line, expected_residual(step, link, Rules(step.world)), link.sign)
        for link in flat(base.only)
        if link.sign != "≈"
    )


def _is_ratio_of_both(line: Link, base: Link) -> bool:
    """Whether a line has the same ratio of both sides: of an angle, and of its degrees."""
    match line, base:
        case (
            Link(Apply("sin" | "cos" | "tan" as one, left), "=", Apply(other, right)),
            Link(angle, "=", Degrees(value) as degrees),
        ):
            return (one, left, right) == (other, angle, degrees) and (
                one != "tan" or value % 180 != 90
            )
    return False


def _is_multiplied(step: Step, line: Link, base: Link) -> bool:
    """Whether a line has both sides times a factor that stands beside the left one.

    The factor may vanish somewhere, as 1 − e² does.
    """
    match line.left:
        case Binary("*", first, second) if base.left in (first, second):
            factor = step.world.value(second if first == base.left else first)
        case _:
            return False
    own, other = (step.world.value(link.right) for link in (line, base))
    if line.sign != "=" or base.sign != "=":
        return False
    if not all(isinstance(value, Quotient) for value in (factor, own, other)):
        return False
    return step.world.reduced(own - factor * other).vanishes  # type: ignore[operator]


def _is_squared(step: Step, line: Link, base: Link) -> bool:
    """Whether a line has the squares of both sides, of which one has a root or a size in it."""
    if line.sign != "=" or base.sign != "=":
        return False
    if not any(map(_is_size_or_root, (*walk(base.left), *walk(base.right)))):
        return False
    values = [step.world.value(side) for link in (base, line) for side in (link.left, link.right)]
    if not all(isinstance(value, Quotient) for value in values):
        return False
    a, b, c, d = values
    # Where a side may be negative this brings in a root, which the line of the sides excludes.
    return all(step.world.reduced(x**2 - y).vanishes for x, y in ((a, c), (b, d)))  # type: ignore[operator]


def is_root_of(step: Step, line: Link, base: Link) -> bool:
    """Whether a line gives a speed of which its base gives the square, or as the root of that."""
    match base:
        case Link(Binary("^", Quantity("speed") as speed, Number(2)), "=", square):
            pass
        case Link(Quantity("speed") as speed, "=", Apply("sqrt", square)):
            pass
        case _:
            return False
    if (line.left, line.sign) != (speed, "="):
        return False
    root, below = step.world.scalar(line.right), step.world.scalar(square)
    return step.world.reduced(root**2 - below).vanishes and _never_negative(step, line.right)


def _is_size_of(step: Step, line: Link, base: Link) -> bool:
    """Whether a line gives the size of a number of which its base says what it is."""
    if line.left != Apply("abs", base.left) or (line.sign, base.sign) != ("=", "="):
        return False
    size, number = (step.world.value(link.right) for link in (line, base))
    if not isinstance(size, Quotient) or not isinstance(number, Quotient):
        return False
    if not step.world.reduced(size**2 - number**2).vanishes:
        return False
    if size.vanishes or step.signs.of(size) == 1:
        return True
    return step.oracle.proves(Claim(step.world.expression(size, step.oracle.roles), ">="))


def _is_size_or_root(tree: Expression) -> bool:
    return is_function(tree, "sqrt", "abs")


def _never_negative(step: Step, tree: Expression) -> bool:
    """Whether a side is a root or a size, or what is positive, or a product of such."""
    match tree:
        case Binary("*" | "/", left, right):
            return _never_negative(step, left) and _never_negative(step, right)
    return _is_size_or_root(tree) or step.signs.of(step.world.scalar(tree)) == 1


def _same_direction(step: Step, line: Link, base: Link) -> bool:
    """Whether a line gives a direction of its base by another vector."""
    if line.sign not in BEARINGS or base.sign not in BEARINGS or line.left != base.left:
        return False
    own, other = step.world.pointing(line.right), step.world.pointing(base.right)
    if not (isinstance(own, Plane) and isinstance(other, Plane)):
        return False
    if line.sign != base.sign:
        # What is perpendicular to one vector is parallel to it turned.
        other = Plane(CONSTANT(-1) * other.y, other.x)
    if not step.world.reduced(own.x * other.y - own.y * other.x).vanishes:
        return False
    pairs = ((own.x, other.x), (own.y, other.y))
    if all(step.world.reduced(a - b).vanishes for a, b in pairs):
        return True
    return any(
        not (a.vanishes or b.vanishes) and step.signs.of(a / b, sure=False) is not None
        for a, b in pairs
    )


def _with_factor_known(step: Step, line: Link) -> bool:
    return is_rearrangement(step.under(move=replace(step.move, id="cancel")), line)


def by_values(step: Step, line: Link, base: Relation) -> bool:
    """Whether a line is its base, with what is cited put in."""
    rules = step.rules(others_cited(step))
    try:
        return any(
            matches_with(step, line, expected_residual(step, link, rules), rules, link.sign)
            for link in base.only
            if not step.world.is_angle(link.left)
        )
    except NotComparableError:
        return False


def matches_with(step: Step, line: Link, expected: Value, rules: Rules, sign: Sign) -> bool:
    """As `matches`, with values put into the line too: an identity may keep either form."""
    if matches(step, line, expected, sign):
        return True
    if sign not in FLIPPED:
        return False
    own = step.residual(line, rules)
    if sign == "=":
        return line.sign == "=" and step.is_multiple(own, expected) is not None
    k = step.is_multiple(own, expected, sign=True)
    return k is not None and line.sign == (sign if k == 1 else FLIPPED[sign])
