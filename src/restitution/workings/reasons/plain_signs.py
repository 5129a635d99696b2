"""Signs that are seen at once: of products of letters that are positive, and of roots."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Line, Link, Relation, Sign, turned
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Rounded,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.oracle.roles import Role
from restitution.planning.writing.forms import ZERO, factors_above, tree_of
from restitution.workings.naming.measured import number_carried
from restitution.workings.naming.quantities import Naming

# Fractions of so many parts are not compared at sight, and of so many not by their parts.
_MANY_PARTS, _TOO_MANY_PARTS = 30, 2000


def is_never_negative(tree: Expression, roles: Mapping[str, Role]) -> bool:
    """Whether a reader sees that an expression is not negative: nothing is taken away in it."""
    match tree:
        case Number(value):
            return value >= 0
        case Letter(name):
            return name in roles and roles[name].kind == "positive"
        case Binary("*" | "/" | "+", left, right):
            return is_never_negative(left, roles) and is_never_negative(right, roles)
        case Binary("^", base, Number(power)):
            return power.numerator % 2 == 0 or is_never_negative(base, roles)
        case Apply("sqrt"):
            return True
    return False


def multiples_compared(line: Relation, cited: Sequence[Relation]) -> Relation | None:
    """``511/1296 < 648/1296 = ½``, where two multiples of one thing are compared, not at sight.

    Of long fractions and of roots, to some figures: ``3√1409/35 ≈ 3.22 < 10/3``. None of what are
    no multiples of one thing, and of what is seen, as each sign is.
    """
    match line.options:
        case ((Link(Letter(), _, Letter()),),):
            return None  # what they are stands beside them
        case ((Link(_, "<" | "<=" | ">" | ">=") as link,),):
            pass
        case _:
            return None
    values = {own.only[0].left: own.only[-1].right for own in cited if len(own.options) == 1}
    sides = [_multiple(values.get(side, side)) for side in (link.left, link.right)]
    if sides[0] is None or sides[1] is None or sides[0][1] != sides[1][1]:
        return None
    one, other = (side[0] for side in sides if side is not None)
    gap = sp.sign(one - other)
    if gap == 0 or one == 0 or other == 0:
        return None
    sign: Sign = "<" if gap < 0 else ">"
    if one.is_Rational and other.is_Rational:
        parts = int(sp.ilcm(one.q, other.q))
        if parts < _MANY_PARTS:
            return None
        if parts < _TOO_MANY_PARTS:
            first, second = (_quotient(int(x * parts), parts) for x in (one, other))
            links = [Link(first, sign, second)]
            if other.q != parts:
                links.append(Link(second, "=", tree_of(other)))
            return Relation((tuple(links),))
    last = tree_of(other)
    for figures in range(3, 7) if other.is_Rational else ():
        number = number_carried(one, figures)
        if number is not None and (number < other if sign == "<" else number > other):
            near = Rounded(number, figures)
            return Relation(((Link(tree_of(one), "≈", near), Link(near, sign, last)),))
    return None


def _multiple(tree: Expression) -> tuple[sp.Expr, sp.Expr] | None:
    """A positive number, and the letters of which a value is so many times their product."""
    if has_quantity(tree):
        return None
    try:
        value = sp.sympify(in_letters(tree, positive=True), strict=True)
    except (RestitutionError, TypeError):
        return None
    number, rest = value.as_independent(*value.free_symbols) if value.free_symbols else (value, 1)
    return (number, sp.sympify(rest, strict=True)) if value.is_Mul or not value.is_Add else None


def _quotient(above: int, below: int) -> Expression:
    return Binary("/", Number(Fraction(above)), Number(Fraction(below)))


def are_squares(squared: Relation, plain: Relation, roles: Mapping[str, Role]) -> bool:
    """Whether an inequality has the squares of both sides of another, none of them negative.

    On one side a root of letters is gone by that.
    """
    match squared.options, plain.options:
        case ((Link(left, sign, right),),), ((Link(one, own, other),),) if sign == own:
            pass
        case _:
            return False
    nodes = (*walk(one), *walk(other))
    if not any(is_function(node, "sqrt") for node in nodes):
        return False
    if not (is_never_negative(one, roles) and is_never_negative(other, roles)):
        return False
    return _is_square_of(left, one) and _is_square_of(right, other)


def _is_square_of(square: Expression, tree: Expression) -> bool:
    try:
        whole, root = (in_letters(form, positive=True) for form in (square, tree))
    except (RestitutionError, TypeError, ValueError):
        return False
    if not isinstance(whole, sp.Expr) or not isinstance(root, sp.Expr):
        return False
    return bool(sp.cancel(whole - root**2) == 0)


def bounds_said(line: Line) -> Iterator[Relation]:
    """The bounds of a range that a line says itself: in the same symbols they are no reasons."""
    match line.relation:
        case Relation((links,)) if line.move.id == "compare" and len(links) > 1:
            for link in links:
                yield Relation(((link,),))
                yield Relation(((turned(link),),))


def bound_in_words(bound: Relation, roles: Mapping[str, Role], naming: Naming) -> Sentence | None:
    """Why a bound that a range says holds of its letter: *as e cannot exceed 1*."""
    link = bound.only[0]
    if not isinstance(link.left, Letter):
        link = turned(link)
    match link:
        case Link(Letter(name) as letter, sign, Number(end)) if name in roles:
            words: SentenceId | None = None
            match roles[name].kind, sign:
                case "positive", ">" if end == 0:
                    words = "derived.positive"
                case "restitution", ">=" if end == 0:
                    words = "derived.cannot-be-negative"
                case "restitution", "<=" if end == 1:
                    words = "derived.cannot-exceed-one"
            return None if words is None else say(words, letter=naming.layout(letter))
    return None


def positive_letters(value: Expression, roles: Mapping[str, Role]) -> Iterator[Letter]:
    """The positive letters that are factors of a value above, where nothing else tells its sign."""
    if is_never_negative(value, roles):
        yield from (factor for factor in factors_above(value) if isinstance(factor, Letter))


def signs_in_a_sum(cited: Relation, roles: Mapping[str, Role]) -> Iterator[Relation]:
    """The signs of letters in a sum that is seen to be positive by them, none of which is cited.

    Those of coefficients of restitution in a sum without ratios of angles, as in 1 + e + e². Where
    the sum is a difference of two quantities, those of positive letters added to numbers too.
    """
    whole = cited.options[0][-1].right
    nodes = list(walk(whole))
    ops = {node.op for node in nodes if isinstance(node, Binary)}
    if "-" in ops or "+" not in ops or any(isinstance(node, Negate) for node in nodes):
        return
    kinds = {name: roles[name].kind for name in sorted(letters(whole)) if name in roles}
    if not any(isinstance(node, Apply) for node in nodes):
        for name in (name for name, kind in kinds.items() if kind == "restitution"):
            yield Relation(((Link(Letter(name), ">=", ZERO),),))
    if not is_binary(cited.options[0][0].left, "-"):
        return
    sums = (node for node in nodes if is_binary(node, "+") and isinstance(node.left, Number))
    beside = {name for node in sums for name in letters(node)}
    for name in (name for name, kind in kinds.items() if kind == "positive" and name in beside):
        yield Relation(((Link(Letter(name), ">", ZERO),),))
