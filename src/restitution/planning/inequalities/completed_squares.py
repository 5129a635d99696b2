"""Bounds by a square that is completed: of a speed or an energy over a coefficient, or others."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Quantity,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.oracle.roles import Role
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.definitions import Formula
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.inequalities.letter_ties import is_square
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.inequalities import completed_parts
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.solving.story.letters import roles


def write_completed(claims: Comparing, line: int, relation: Relation) -> int | None:
    """The ends of a speed, of which the square is of the second degree in a coefficient.

    Of an energy, or of a share of one, it is that itself. It is both ends, or the greater one where
    only that is wanted. None where the coefficient is at neither end least, or letters stand beside
    it in the sum.
    """
    asked = claims.scene.desk.last_link(line).left
    kinds = {node.kind for node in quantities_in(asked)} - {"mass"}
    if (
        not kinds
        or not kinds <= {"speed", "energy"}
        or (kinds == {"speed"}) != is_quantity(asked, "speed")
    ):
        return None
    first, *more = relation.only
    if not more and (first.left != asked or first.sign[0] != "<"):
        return None  # that a square is not negative is seen at once
    mark = claims.worths.mark()
    written = _written(claims, asked, line, relation)
    if written is None:
        claims.worths.back(mark)
    return written


def write_square(
    claims: Comparing, line: int, symbol: sp.Symbol, relation: Relation, least: bool
) -> int | None:
    """The bound of a quadratic in a letter, or of the root of one, by its square completed."""
    scene, judge = claims.scene, claims.judge
    last = scene.desk.last_link(line)
    x = claims.worths.value(last.right)
    for value in (x, x**2):
        above, below = sp.fraction(factored(one_fraction(value)))
        if symbol in below.free_symbols:
            continue
        try:
            poly = polynomial_in(expanded(above), symbol)
        except sp.PolynomialError:
            continue
        if poly.degree() != 2 or poly.nth(1) == 0:
            continue
        outside = cancelled(value / poly.as_expr())
        if scene.model.sign(poly.LC() * outside) != (1 if least else -1):
            continue
        primitive = poly.primitive()[1]
        a, b, c = (primitive.nth(n) for n in (2, 1, 0))
        common, inner = polynomial_in(2 * a * symbol + b, symbol).primitive()
        factor = tidy(sp.sympify(common, strict=True) ** 2 / (4 * a))
        squared = product(tree_of(factor), square(tree_of(tidy(inner.as_expr()))))
        own = total((squared, tree_of(tidy(c - b**2 / (4 * a)))))
        outer = tidy(cancelled(value / primitive.as_expr()))
        if value != x:
            own, outer = Apply("sqrt", own), tidy(sp.sqrt(outer))
        known = claims.worths.known_in(x)
        link = Link(last.left, "=", product(tree_of(outer), own))
        completed = judge.write((Move("rearrange"),), [line, *known], Relation(((link,),)))
        if completed is None:
            continue
        bound = judge.write((Move("sign"),), [completed, *known], relation)
        if bound is not None:
            return bound
    return None


def _written(claims: Comparing, asked: Expression, line: int, relation: Relation) -> int | None:
    power, subject = (2, square(asked)) if is_quantity(asked, "speed") else (1, asked)
    own = None
    if isinstance(asked, Quantity):
        claims.worths.determine(asked)
        own = formula(claims.scene, asked)
    value = claims.worths.value(claims.scene.desk.last_link(line).right)
    parts = _completed(claims, tidy((own.value if own else value) ** power))
    if parts is None:
        return None
    symbol, lead, least, more = parts
    below = least.as_numer_denom()[1]
    base = square(difference(tree_of(least * below), tree_of(below * symbol)))
    rest = tree_of(factored(lead * more))
    whole = Binary("+", product(tree_of(factored(lead / below**2)), base), rest)
    most = max(least**2, (1 - least) ** 2)
    ends = Link(ZERO, "<=", base), Link(base, "<=", tree_of(most * below**2))
    known = claims.judge.known([symbol.name])
    mark = claims.worths.mark()
    between = claims.judge.write((Move("sign"),), known, Relation((ends,)))
    if between is not None and _shows(claims, line, symbol):
        at_once = claims.judge.write((Move("compare"),), [line, between], relation)
        if at_once is not None:
            return at_once
    claims.worths.back(mark)
    completed = _standing(claims, subject, symbol)
    if completed is None and own is not None:
        completed = _square_of(claims, own, whole)
    elif completed is None:
        completed = claims.judge.write(
            (Move("rearrange"),), [line, *known], chain(asked, (whole, None))
        )
    between = claims.judge.write((Move("sign"),), known, Relation((ends,)))
    if completed is None or between is None:
        return None
    low, high = (tree_of(factored(lead * (remainder + more))) for remainder in (0, most))
    both = Link(low, "<=", subject), Link(subject, "<=", high)
    wanted = both[2 - len(relation.only) :] if power > 1 else relation.only
    last = claims.compared([completed, between], Relation((wanted,)))
    return last if last is None or power == 1 else claims.compared([last], relation)


def _standing(claims: Comparing, subject: Expression, symbol: sp.Symbol) -> int | None:
    """The line above in which a coefficient stands in one square of what is bounded; or None."""
    desk = claims.scene.desk
    for line in reversed(desk.lines):
        own = line.relation
        if isinstance(own, Relation) and len(own.options) == 1 and desk.holds(line.number):
            is_equation = own.only[0].left == subject and own.only[0].sign == "="
            if is_equation and _shows(claims, line.number, symbol):
                return line.number
    return None


def _shows(claims: Comparing, line: int, symbol: sp.Symbol) -> bool:
    """Whether a coefficient stands in one square of a line alone, which is not multiplied out."""
    right = claims.scene.desk.last_link(line).right
    squares = [node for node in walk(right) if is_square(node) and symbol.name in letters(node)]
    outside = rebuilt(right, lambda tree: ZERO if tree in squares else tree)
    return len(squares) == 1 and symbol.name not in letters(outside)


def _square_of(claims: Comparing, own: Formula, whole: Expression) -> int | None:
    """The line of an energy, or of the square of a speed, as a square plus a constant.

    That of a speed perhaps comes from a line above.
    """
    right, speed = swept(own.right), own.left
    if not is_quantity(speed, "speed"):
        sides = chain(own.left, (right, None), (whole, "rearrange"))
        return claims.judge.write((own.move,), own.refs, sides, own.refs)
    if is_function(right, "sqrt"):
        sides = chain(square(speed), (right.argument, None), (whole, "rearrange"))
        line = claims.judge.write((own.move,), own.refs, sides, own.refs)
        if line is not None:
            return line
    squared = claims.worths.squared(speed)
    moves = (Move("rearrange"),)
    return squared and claims.judge.write(moves, [squared], chain(square(speed), (whole, None)))


def _completed(
    claims: Comparing, value: sp.Expr
) -> tuple[sp.Symbol, sp.Expr, sp.Expr, sp.Expr] | None:
    """A coefficient, and a, p and r of the a((e − p)² + r) that a square is, with p inside."""
    known = {name for name, role in roles(claims.scene.problem).items() if _is_coefficient(role)}
    symbols = [symbol for symbol in value.free_symbols if symbol.name in known]
    parts = completed_parts(value, symbols[0]) if len(symbols) == 1 else None
    if parts is None or not (0 < parts[1] < 1 and parts[2] > 0):
        return None
    return symbols[0], *parts


def _is_coefficient(role: Role) -> bool:
    return role.kind == "restitution" and (role.low, role.high) == (0, 1)
