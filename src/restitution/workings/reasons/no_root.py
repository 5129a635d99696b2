"""Why an equation has no root: what no value of its letter can be."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_quantity,
    is_zero,
    walk,
)
from restitution.oracle import REAL
from restitution.solving.story.letters import roles
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.definite_sums import without_root

_UNIT = frozenset({"sin", "cos"})


def reason_of_no_root(relation: Relation, naming: Naming) -> Sentence | None:
    """The reason why no number satisfies an equation in one letter; None where it is another."""
    if len(relation.options) != 1 or len(relation.only) != 1:
        return None
    (link,) = relation.only
    return _of_a_square(link, naming) or _of_a_ratio(link, naming) or _of_a_quadratic(link, naming)


def _of_a_square(link: Link, naming: Naming) -> Sentence | None:
    """cos²α = 16/11 is above 1; no square is negative."""
    match link.left:
        case Binary("^", base, Number(value=power)) if power == 2:
            pass
        case _:
            return None
    if _is_negative(link.right, naming) or (link.sign == "<" and is_zero(link.right)):
        return say("no-root.square")
    value = _number(link.right)
    if value is None:
        return None
    unit = isinstance(base, Apply) and base.function in _UNIT
    if unit and (value - 1).is_positive:
        return say("no-root.unit", square=naming.layout(link.left))
    return None


def _of_a_ratio(link: Link, naming: Naming) -> Sentence | None:
    """A ratio above 1, as cos α = 25/8, or below −1."""
    ratio, value = _ratio_and_value(link)
    if ratio is not None and value is not None and (value - 1).is_positive:
        return say("no-root.unit", square=naming.layout(ratio))
    if ratio is not None and value is not None and (value + 1).is_negative:
        return say("no-root.least", ratio=naming.layout(ratio))
    return None


def _ratio_and_value(link: Link) -> tuple[Expression | None, sp.Expr | None]:
    """The one sine or cosine of an equation without other letters, and what it makes of that."""
    nodes = {node for side in (link.left, link.right) for node in walk(side)}
    ratios = [node for node in nodes if isinstance(node, Apply) and node.function in _UNIT]
    letters = {node for node in nodes if isinstance(node, Letter)}
    if len(ratios) != 1 or letters != {ratios[0].argument}:
        return None, None
    (letter,) = letters
    assert isinstance(letter, Letter)
    symbol, t = sp.Symbol(letter.name, real=True), sp.Dummy("t")
    gap = sp.expand(_value(link.left, symbol) - _value(link.right, symbol))
    gap = gap.subs({"sin": sp.sin, "cos": sp.cos}[ratios[0].function](symbol), t)
    if symbol in gap.free_symbols or not gap.is_polynomial(t) or sp.degree(gap, t) != 1:
        return None, None
    return ratios[0], -gap.subs(t, 0) / sp.diff(gap, t)


def _of_a_quadratic(link: Link, naming: Naming) -> Sentence | None:
    """The discriminant of a quadratic in a letter, or in the tangent of an angle, is negative."""
    letters = {
        node for side in (link.left, link.right) for node in walk(side) if isinstance(node, Letter)
    }
    if len(letters) != 1:
        return None
    (letter,) = letters
    symbol = sp.Symbol(letter.name, real=True)
    zero = sp.expand(_value(link.left, symbol) - _value(link.right, symbol))
    subject: Expression = letter
    if zero.has(sp.sin, sp.cos):
        s, c, t = sp.sin(symbol), sp.cos(symbol), sp.Dummy("t")
        above = sp.expand(sp.fraction(sp.together(zero))[0])  # a tangent is a quotient of both
        whole = sp.Poly(above, s, c) if above.is_polynomial(s, c) else None
        if whole is None or not whole.is_homogeneous or whole.homogeneous_order() != 2:
            return None
        zero = sp.expand(whole.as_expr().xreplace({s: t * c}) / c**2)
        subject, symbol = Apply("tan", letter), t
    if not zero.is_polynomial(symbol) or zero.free_symbols != {symbol}:
        return None
    quadratic = sp.Poly(zero, symbol)
    if quadratic.degree() != 2:
        return None
    discriminant = sp.nsimplify(quadratic.discriminant())
    if not discriminant.is_negative:
        return None
    equation, worth = without_root(quadratic, subject)
    return say(
        "no-root.discriminant",
        equation=naming.relation(equation),
        discriminant=naming.relation(worth),
    )


def _value(tree: Expression, symbol: sp.Symbol) -> sp.Expr:
    return sp.sympify(evaluate(tree, lambda _: symbol), strict=True)


def _is_negative(tree: Expression, naming: Naming) -> bool:
    """Whether each term of a side is seen to be negative, or zero, and not all are zero."""
    if has_quantity(tree) or any(isinstance(node, Apply) for node in walk(tree)):
        number = _number(tree) if not has_quantity(tree) else None
        return number is not None and bool(number.is_negative)
    known = roles(naming.problem)
    value = evaluate(tree, lambda name: known.get(name, REAL).symbol(name))
    return bool(sp.expand(sp.sympify(value, strict=True)).is_negative)


def _number(tree: Expression) -> sp.Expr | None:
    if any(isinstance(node, Letter) for node in walk(tree)):
        return None
    return sp.sympify(evaluate(tree, sp.Symbol), strict=True)


__all__ = ["reason_of_no_root"]
