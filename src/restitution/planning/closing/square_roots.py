"""Equations of squares: the root of both sides is taken, and nothing is multiplied out."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbols_in
from restitution.explaining.lines.derivation import Link, Move, Relation, equality
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    children,
    is_binary,
    is_zero,
    letters,
    terms_of,
)
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.between import is_square
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import (
    TWO,
    factors,
    factors_above,
    negative,
    outer_terms,
    product,
    swept,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    IN_PLACE,
    cancelled,
    coefficients_in_place,
    expanded,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.work import remembered


def root_taken(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """The line with the root taken of both sides, as a line; the same line where there is none.

    It is taken where both sides are squares, or where the unknown stands in one square of a sum
    alone, and where it is certain which of the two roots it is.
    """
    for shape in _SHAPES:
        taken = shape(scene, number, symbol)
        if taken is not None:
            return taken
    return number


def without_equal_squares(scene: Scene, line: int) -> int:
    """Two equal sums of two squares, of which one stands in both: the others are equal too."""
    link = scene.desk.last_link(line)
    match link.left, link.right:
        case Binary("+", a, b), Binary("+", c, d):
            pairs = [((a, b), (c, d)), ((a, b), (d, c)), ((b, a), (c, d)), ((b, a), (d, c))]
        case _:
            return line
    for (own, left), (other, right) in pairs:
        match left, right:
            case Binary("^", one, power), Binary("^", two, exponent) if (
                own == other and power == exponent == TWO
            ):
                break
    else:
        return line
    first = scene.judge.write((Move("rearrange"),), (line,), chain(left, (right, None)))
    if first is None:
        return line
    if isinstance(one, Letter) or isinstance(two, Letter):
        return first  # a component, of which the root has two signs
    known = background(scene, letters(one) | letters(two))
    relation = chain(one, (two, None))
    return scene.judge.write((Move("rearrange"),), (first, *known), relation) or first


def _of_one_square(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The unknown stands in the square of one sum: that is made the subject, and its root taken."""
    if speed_of_one_component(scene, number, symbol) is not None:
        return None
    link = scene.desk.last_link(number)
    sums = {base for side in (link.left, link.right) for base in _sums(side, symbol.name)}
    if len(sums) != 1:
        return None
    (base,) = sums
    sides = [rebuilt(side, _replace(base, Letter("_sum"))) for side in (link.left, link.right)]
    if any(symbol.name in letters(side) for side in sides):
        return None
    left, right = (scene_value(scene, side, {"_sum": IN_PLACE}) for side in sides)
    parts = coefficients_in_place(left - right)
    power = 0 if parts is None else len(parts) - 1
    if parts is None or power not in (2, 4) or any(part != 0 for part in parts[1:-1]):
        return None
    whole = Binary("^", base, Number(Fraction(power)))
    value = tidy(-parts[0] / parts[-1])
    root = tidy(sp.root(value, power))
    if scene.model.sign(scene_value(scene, base).xreplace(dict(scene.model.final))) < 0:
        root = -root
    plain = all(_is_plain(atom) for atom in root.atoms(sp.Pow))
    if symbol in value.free_symbols or root.atoms(sp.Abs) or not plain:
        return None
    squared = equality(whole, tree_of(value))
    mark = scene.desk.mark()
    own = (
        number
        if scene.desk.relation(number) == squared
        else in_another_form(scene, number, squared)
    )
    if own is None:
        return None
    standing = scene.desk.mark()
    taken = in_another_form(scene, own, equality(base, tree_of(root)))
    if taken is not None and _follows_too(scene, taken, equality(base, tree_of(-root))):
        scene.desk.back(standing)  # what is known excludes both: neither is taken for certain
        taken = None
    if taken is None and own != number and power != 2:
        scene.desk.back(mark)
        return None
    return taken or own


def _follows_too(scene: Scene, number: int, other: Relation) -> bool:
    """Whether another relation follows just as a line does, as what it rests on cannot all be."""
    line = scene.desk.line(number)
    return scene.judge.follows(line.move, line.premises, other)


def as_square(value: sp.Expr) -> Expression | None:
    """A number with roots, times letters, as a square: 7 − √33 = (√33 − 3)²/6.

    None where the root is seen, or is no shorter.
    """
    if not any(isinstance(e, sp.Add) and e.is_number for e in sp.preorder_traversal(value)):
        return None
    root = tidy(sp.sqrt(value))
    powers = [power for power in root.atoms(sp.Pow) if not power.exp.is_Integer]
    if root.atoms(sp.Abs) or not all(power.base.is_Rational for power in powers):
        return None
    return Binary("^", tree_of(root), TWO)


def is_square_of_sum(scene: Scene, number: int, symbol: sp.Symbol) -> bool:
    """Whether a line says what the square of a sum with the unknown is: its roots are read off."""
    match scene.desk.last_link(number):
        case Link(Binary("^", Binary("+" | "-") as base, Number(power)), "=", right):
            if power != 2:
                return False
            return symbol.name in letters(base) and symbol.name not in letters(right)
    return False


def is_product_of_sums(scene: Scene, number: int, symbol: sp.Symbol) -> bool:
    """Whether a line says that a product of sums with the unknown is zero: so are its roots."""
    return len(linear_factors(scene, number, symbol)) > 1


def linear_factors(scene: Scene, number: int, symbol: sp.Symbol) -> list[sp.Expr]:
    """The factors with the unknown of a product that is zero, where all are linear; else none."""
    link = scene.desk.last_link(number)
    match link if is_zero(link.right) else Link(link.right, link.sign, link.left):
        case Link(whole, "=", zero) if is_zero(zero):
            factors = [factor for factor in factors_above(whole) if symbol.name in letters(factor)]
            values = [sp.sympify(scene_value(scene, factor), strict=True) for factor in factors]
            if all(
                value.is_polynomial(symbol) and polynomial_in(value, symbol).degree() == 1
                for value in values
            ):
                return values
    return []


def _sums(tree: Expression, name: str) -> Iterator[Expression]:
    """The smallest sums in which a letter stands."""
    if not is_binary(tree, "+", "-"):
        for child in children(tree):
            yield from _sums(child, name)
        return
    terms = list(terms_of(tree))
    inside = [list(_sums(term, name)) for term in terms]
    if any(name in letters(a) and not b for a, b in zip(terms, inside, strict=True)):
        yield tree
    else:
        yield from (base for own in inside for base in own)


def _is_plain(power: sp.Expr) -> bool:
    """Whether it is a power of letters, or the root of a whole number."""
    return bool(power.exp.is_Integer or power.base.is_Integer)


def _of_two_squares(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """Both sides are squares of products."""
    link = scene.desk.last_link(number)
    if symbol.name not in letters(link.left) | letters(link.right):
        return None
    left, right = (root_of_squares(side) for side in (link.left, link.right))
    if left is None or right is None:
        return None
    relation = equality(left, swept(right))
    if all(is_not_negative(scene, tree) for tree in (left, right)):
        taken = in_another_form(scene, number, relation)
        if taken is not None:
            return taken
    if sides_but_for_sign(scene, number, symbol) is not None:
        return number  # either root may be meant
    # A root that is excluded later is written all the same.
    return in_another_form(scene, number, relation)


def is_not_negative(scene: Scene, tree: Expression) -> bool:
    """Whether what is known of its letters makes a side not negative, without the equation."""
    relation = Relation(((Link(tree, ">=", Number(Fraction(0))),),))
    names = letters(tree)
    # An angle to the line of centres has its letter from the working, which says its range.
    known = together(scene.judge.known(names), background(scene, names))
    return scene.judge.proves(known, relation)


def sides_but_for_sign(
    scene: Scene, number: int, symbol: sp.Symbol
) -> tuple[sp.Expr, sp.Expr] | None:
    """Two sums with the unknown that are equal or opposite, as their squares are equal.

    None of a line that does not say so, and where it is known which of the two they are.
    """
    link = scene.desk.last_link(number)
    left, right = (root_of_squares(side) for side in (link.left, link.right))
    if link.sign != "=" or left is None or right is None:
        return None
    if all(is_not_negative(scene, tree) for tree in (left, right)):
        return None
    sides = (sp.sympify(scene_value(scene, tree), strict=True) for tree in (left, right))
    one, other = side_by_side(*sides)
    for value in (one, other):
        if not value.is_polynomial(symbol) or polynomial_in(value, symbol).degree() > 1:
            return None
        if symbol not in symbols_in(value) and _speeds_of_one_component(scene, number) is None:
            return None
    # Equal and opposite sides are two equations of the first degree.
    ends = (expanded(one - other), expanded(one + other))
    return (one, other) if all(sp.degree(end, symbol) == 1 for end in ends) else None


def speed_of_one_component(
    scene: Scene, number: int, symbol: sp.Symbol
) -> tuple[Expression, Expression] | None:
    """The component with the unknown of who moves along a line, and the speed that is given.

    None of a line that says no square of a speed, and where it is known which of the two signs
    the component has.
    """
    pair = _speeds_of_one_component(scene, number)
    if pair is None or sides_but_for_sign(scene, number, symbol) is None:
        return None
    pair = pair if symbol.name in letters(pair[0]) else pair[::-1]
    return None if symbol.name in letters(pair[1]) else pair


def _speeds_of_one_component(scene: Scene, number: int) -> tuple[Expression, Expression] | None:
    """The two sides of which a line says that their squares are equal, as both are a speed."""
    line = scene.desk.line(number)
    match line.relation:
        case Relation(((Link(Binary("^", one, power), "=", Binary("^", other, exponent)),),)) if (
            line.move.id,
            line.move.record,
        ) == ("define", "speed") and power == exponent == TWO:
            return one, other
    return None


def squares_collected(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """Multiples of two squares of sums, each brought to its own side, where one stands on both.

    So 10(1 + k)² = 4(2 − k)² + 9(1 + k)² is (1 + k)² = 4(2 − k)². The same line where the root is
    not to be taken of both sides then.
    """
    link = scene.desk.last_link(number)
    terms = [*outer_terms(link.left), *map(negative, outer_terms(link.right))]
    if link.sign != "=" or len(terms) < 3:
        return number
    shares: dict[Expression, sp.Expr] = {}
    for term in terms:
        own = factors(term)
        squares = [e for e in own if is_square(e) and symbol.name in letters(e)]
        if len(squares) != 1:
            return number
        share = cancelled(scene_value(scene, term) / scene_value(scene, squares[0]))
        if symbol in share.free_symbols:
            return number
        shares[squares[0]] = shares.get(squares[0], sp.S.Zero) + share
    if len(shares) != 2 or 0 in shares.values():
        return number
    common = sp.gcd_list(list(shares.values()))
    (one, a), (other, b) = ((tree, cancelled(share / common)) for tree, share in shares.items())
    if scene.model.sign(a) < 0:
        a, b = -a, -b
    relation = chain(product(tree_of(a), one), (product(tree_of(-b), other), None))
    mark = scene.desk.mark()
    line = in_another_form(scene, number, relation)
    if line is None or sides_but_for_sign(scene, line, symbol) is None:
        scene.desk.back(mark)
        return number
    return line


@remembered(512)
@remembered(512)
def side_by_side(one: sp.Expr, other: sp.Expr) -> tuple[sp.Expr, ...]:
    """Two sides without what is below a line, and without a common factor."""
    (a, b), (c, d) = (sp.fraction(one_fraction(value)) for value in (one, other))
    if any(
        node.is_number and not node.is_Rational for x in (b, d) for node in sp.preorder_traversal(x)
    ):
        # Of denominators with roots of numbers none is a factor of the other.
        parts = [expanded(a * d), expanded(c * b)]
        contents = [sp.factor_terms(part).as_coeff_Mul()[0] for part in parts]
        common = sp.gcd(*contents)
        return tuple(expanded(part / common) for part in parts)
    below = sp.lcm(b, d)
    parts = [cancelled(value * below) for value in (one, other)]
    common = sp.gcd(*parts)
    return tuple(cancelled(part / common) for part in parts)


def root_of_squares(tree: Expression) -> Expression | None:
    """The root of a product of squares, as a tree; None for any other."""
    match tree:
        case Binary("^", base, _) if is_square(tree):
            return base
        case Binary("*" | "/" as op, left, right):
            roots = [root_of_squares(tree) for tree in (left, right)]
            if None in roots:
                return None
            if op == "*":
                return product(*roots)  # type: ignore[arg-type]
            return Binary(op, *roots)  # type: ignore[arg-type]
        case Number(value):
            root = sp.sqrt(sp.Rational(value.numerator, value.denominator))
            return tree_of(root) if root.is_Rational else None
    return None


def _replace(tree: Expression, other: Expression) -> Callable[[Expression], Expression]:
    return lambda node: other if node == tree else node


_SHAPES = (_of_one_square, _of_two_squares)
