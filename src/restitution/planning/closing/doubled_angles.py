"""Equations in the ratios of an angle and of its double: tan θ = k tan 2θ, and tan θ tan 2θ = k."""

from __future__ import annotations

from typing import Any, NamedTuple

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Meaning, Move, Relation
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import Apply, Binary, Expression, Letter, Number, walk
from restitution.planning.closing.ratios import functions_of, inverse, ratio, write_identity
from restitution.planning.closing.roots import known_as
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.named_angles import letters_taken
from restitution.planning.writing.angle_ratios import range_of
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    difference,
    number,
    product,
    square,
    tree_of,
)
from restitution.planning.writing.polynomials import cancelled, numerator, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


class SingleAndDouble(NamedTuple):
    """An equation in the tangents of an angle and of its double, with the smaller angle's factor.

    The first generator is the tangent of the smaller angle.
    """

    poly: sp.Poly
    small: sp.Rational


def in_single_and_double(scene: Scene, line: int, symbol: sp.Symbol) -> SingleAndDouble | None:
    """A line in the tangents of an angle and of its double; None where it is not so."""
    own = _by_angles(scene, line, symbol)
    functions = functions_of(scene, own, symbol)
    if functions is None:
        return None
    factors = {function.args[0] / symbol for function in functions}
    if not all(factor.is_Rational for factor in factors) or len(factors) != 2:
        return None
    small, large = sorted(factors)
    if large != 2 * small:
        return None
    t, double_t = sp.Dummy("t", positive=True), sp.Symbol("T")
    x, double = small * symbol, large * symbol
    single = {sp.sin(x): t * sp.cos(x), sp.tan(x): t}
    doubled = {sp.sin(double): double_t * sp.cos(double), sp.tan(double): double_t}
    factor = cancelled(numerator(own.subs(single).subs(doubled)))
    return SingleAndDouble(polynomial_in(factor, t, double_t), small)


def without_doubles(scene: Scene, line: int) -> int:
    """The line with sin 2θ and cos 2θ by θ; the same line, where it has none."""
    link = scene.desk.last_link(line)
    put = {
        node: own
        for side in (link.left, link.right)
        for node in walk(side)
        if (own := _by_the_half(node)) is not None
    }
    if link.sign != "=" or not put:
        return line
    left, right = (exchanged(side, put) for side in (link.left, link.right))
    return write_identity(scene, line, "double-angle", chain(left, (right, None))) or line


def _by_the_half(node: Expression) -> Expression | None:
    """2 sin θ cos θ for sin 2θ, and 1 − 2 sin²θ for cos 2θ; None for all else."""
    match node:
        case Apply("sin", Binary("*", Number(value), Letter() as half)) if value == 2:
            return product(TWO, Apply("sin", half), Apply("cos", half))
        case Apply("cos", Binary("*", Number(value), Letter() as half)) if value == 2:
            return difference(ONE, product(TWO, square(Apply("sin", half))))
    return None


def divided_angle(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """The tangent of an angle by that of its double: an equation in the tangent of the smaller."""
    own = in_single_and_double(scene, line, symbol)
    if own is None or set(own.poly.monoms()) != {(1, 0), (0, 1)}:
        return None
    k = cancelled(-own.poly.coeff_monomial((0, 1)) / own.poly.coeff_monomial((1, 0)))
    if k.has(symbol):
        return None
    link = scene.desk.last_link(line)
    angle = link.left.argument if isinstance(link.left, Apply) else None
    return _by_double(scene, line, symbol, own.small, tidy(k), angle)


def _by_angles(scene: Scene, line: int, symbol: sp.Symbol) -> sp.Expr:
    """A line as an expression that is zero, in which the sine of 2θ is not that of θ."""
    multiples: dict[sp.Symbol, sp.Expr] = {}
    names: dict[str, sp.Symbol] = {}

    def change(tree: Expression) -> Expression:
        match tree:
            case Apply("sin" | "cos" | "tan" as kind, argument) if not isinstance(argument, Letter):
                angle = scene_value(scene, argument)
                if angle.free_symbols == {symbol}:
                    own = sp.Dummy(real=True)
                    name = f"_{len(names)}"
                    names[name] = own
                    multiples[own] = getattr(sp, kind)(angle, evaluate=False)
                    return Letter(name)
        return tree

    link = scene.desk.last_link(line)
    left, right = (scene_value(scene, rebuilt(e, change), names) for e in (link.left, link.right))
    return (left - right).xreplace(multiples)


def _by_double(
    scene: Scene, line: int, symbol: sp.Symbol, small: sp.Rational, k: sp.Expr, angle: Any
) -> Source | None:
    """From tan x = k tan 2x: the quadratic in tan x without the root 0."""
    letter = Letter(symbol.name)
    if small == 1:
        subject: Expression = Apply("tan", letter)
        record = "double-angle"
        meaning: tuple[int, ...] = ()
    else:
        if angle is None:
            return None
        name = _free_letter(scene)
        subject, record = Letter(name), "half-angle"
        meaning = (scene.desk.write(Move("let"), (), Meaning(name, Apply("tan", angle))),)
    # t = 2kt/(1 − t²), divided by t, which is not 0 for an acute angle: t² = 1 − 2k.
    two = product(number(2), subject)
    below = difference(ONE, square(subject))
    right: Expression = Binary("/", product(tree_of(k), two), below)
    if k.is_Rational and k.q != 1:
        right = product(tree_of(k), Binary("/", two, below))
    relation = chain(subject, (right, None))
    if small == 1 and scene.desk.last_link(line).left != subject:
        # The tangent of the double angle stays on the side where it stands.
        relation = chain(Binary("/", two, below), (product(tree_of(1 / k), subject), None))
    first = write_identity(scene, line, record, relation, *meaning)
    if first is None:
        return None
    shorter = chain(below, (tree_of(2 * k), None))
    known = range_of(scene, symbol.name)
    second = scene.desk.write(Move("cancel"), (first, *meaning, known), shorter)
    value = tidy(sp.sqrt(1 - 2 * k))  # the tangent of an acute angle
    others = [Link(subject, "=", tree_of(root)) for root in (value, -value)]
    alternatives = Relation(tuple((other,) for other in others))
    third = scene.desk.write(Move("roots"), (second,), alternatives)
    only = Relation(((others[0],),))
    last = scene.desk.write(Move("reject"), (third, *meaning, known), only)
    if small == 1:
        scene.desk.know(subject, value, (last,))
        return inverse(scene, last, symbol)
    _write_double(scene, line, last, meaning, Apply("tan", letter), tidy(value / k))
    final = scene.final(symbol)
    relation = chain(letter, (tree_of(final, angle=True, as_it_is=True), None))
    written = scene.desk.write(Move("inverse"), (last, *meaning, known), relation)
    return known_as(scene, symbol, final, written)


def _write_double(
    scene: Scene,
    line: int,
    last: int,
    meaning: tuple[int, ...],
    subject: Apply,
    value: sp.Expr,
) -> None:
    """The tangent of the whole angle, by that of its half."""
    relation = chain(subject, (tree_of(value), None))
    tangent = scene.desk.write(Move("put"), (line, last, *meaning), relation)
    scene.desk.know(subject, value, (tangent,))


def _free_letter(scene: Scene) -> str:
    """A letter that stands for nothing yet: t where it is free."""
    taken = letters_taken(scene)
    return next(letter for letter in ("t", "T", "k", "z") if letter not in taken)


def product_of_tangents(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """The tangent of an angle, where its product with that of the double is told.

    By the formula for the double angle an equation in the square of that tangent is left. None of
    another equation.
    """
    own = in_single_and_double(scene, line, symbol)
    if own is None or own.small != 1 or set(own.poly.monoms()) != {(1, 1), (0, 0)}:
        return None
    value = cancelled(-own.poly.coeff_monomial((0, 0)) / own.poly.coeff_monomial((1, 1)))
    if value.has(symbol) or value.free_symbols:
        return None
    mark, angle = scene.desk.mark(), Letter(symbol.name)
    single, double = Apply("tan", angle), Apply("tan", product(TWO, angle))
    right = tree_of(tidy(value))
    opened = Binary("/", product(TWO, single), difference(ONE, square(single)))
    known = background(scene, {symbol.name})
    written: int | None = line
    for move, left in (
        (Move("rearrange"), Binary("*", single, double)),
        (Move("identity", "double-angle"), Binary("*", single, opened)),
    ):
        if written is not None:
            written = scene.judge.write((move,), (written, *known), chain(left, (right, None)))
    source = None if written is None else ratio(scene, written, symbol)
    if source is None:
        scene.desk.back(mark)
    return source


__all__ = ["divided_angle", "product_of_tangents"]
