"""A ratio that is to be shown with an angle: its tangent is put in, or its squares are."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial

import sympy as sp

from restitution.exact import in_sines, tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, equality
from restitution.explaining.lines.trees import has_quantity_in, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.angles.expressions import formula_of_squares
from restitution.planning.closing.squared_ratios import KINDS, write_by_squares
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import (
    ONE,
    factors,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.scene import Scene

_OTHER = {"sin": "cos", "cos": "sin"}
_OF = {"sin": "sin", "cosec": "sin", "cos": "cos", "sec": "cos"}
_PYTHAGORAS = Move("identity", "pythagoras")
_TO_CLEAR = (Move("rearrange"), Move("cancel"))


def ratio_by_a_tangent(worths: Worths, link: Link, lines: Sequence[int]) -> int | None:
    """The line cos²α (1 + tan²β) of a ratio, from cos²α + e² sin²α and tan β = e tan α.

    ``lines`` are those of the two quantities and of the tangent. None of another ratio.
    """
    desk = worths.scene.desk
    tangents = [number for number in lines if _is_tangent(desk.last_link(number).left)]
    others = [number for number in lines if number not in tangents]
    if len(tangents) != 1 or not is_binary(link.left, "/"):
        return None
    (tangent,) = tangents
    own = desk.last_link(tangent)
    ratio = worths.value(own.right)
    angles = {sine.args[0] for sine in ratio.atoms(sp.sin, sp.cos, sp.tan)}
    if len(angles) != 1:
        return None
    (angle,) = angles
    ratio = in_sines(ratio, angle)
    factor = cancelled(ratio * sp.cos(angle) / sp.sin(angle))
    mark = worths.mark()
    first = worths.valued(link.left, Move("divide"), others)
    if first is None or factor.has(sp.sin, sp.cos):
        worths.back(mark)
        return None
    t = sp.Dummy("t")
    value = worths.value(desk.last_link(first).right)
    inside = expanded(cancelled(value.subs(sp.sin(angle), t * sp.cos(angle)) / sp.cos(angle) ** 2))
    put = expanded(inside.subs(t, t / factor))
    if put.has(sp.cos(angle), sp.sin(angle)) or put.free_symbols != {t}:
        worths.back(mark)
        return None
    poly = polynomial_in(put, t)
    terms: list[Expression] = []
    for (power,), share in reversed(poly.terms()):
        tree = own.left if power == 1 else square(own.left)
        terms.append(product(tree_of(tidy(share)), *([tree] if power else [])))
    if poly.degree() != 2:
        worths.back(mark)
        return None
    right = product(square(tree_of(sp.cos(angle))), total(terms))
    relation = equality(link.left, right)
    known = worths.known_in(value)
    line = worths.judge.write((Move("put"),), [first, tangent, *known], relation)
    if line is None:
        worths.back(mark)
    return line


def _is_tangent(tree: Expression) -> bool:
    return is_function(tree, "tan") and isinstance(tree.argument, Letter)


def shown_by_squares(worths: Worths, link: Link, quantities: Sequence[Quantity]) -> int | None:
    """An energy, or a speed, by the squares of the ratios of an angle; None of another equation."""
    unknowns = worths.scene.model.unknowns.roles
    open_ = {
        unknowns[symbol.name].kind for symbol in worths.scene.model.final if symbol.name in unknowns
    }
    if "angle" not in open_ or any(quantity.kind not in KINDS for quantity in quantities):
        return None
    mark = worths.mark()
    for quantity in quantities:
        worths.determine_angle(quantity)
    line = write_by_squares(worths.scene, link.left, partial(_as_printed, worths), link.right)
    if line is None:
        worths.back(mark)
    return line


def _as_printed(worths: Worths, scene: Scene, asked: Expression) -> Formula | None:
    """The formula of what stands in a claim: with its letter for a speed, and over the data."""
    opened = worths.opened(asked)
    own = formula_of_squares(scene, opened)
    match opened:
        case Binary("/", above, below) if own is None and not has_quantity(below):
            own = formula_of_squares(scene, above)
            if own is not None:
                value = tidy(expanded(own.value / scene.scalar(below)))
                own = replace(own, right=Binary("/", own.right, below), value=value)
    if own is None or (opened == asked and own.left == asked):
        return own
    lets = (f"let {name}" for name in sorted(letters(asked)))
    refs = together(own.refs, (ref for ref in lets if ref in scene.facts))
    return replace(own, of=itself, quantity=asked, refs=refs)


def in_one_ratio(scene: Scene, numbers: Iterable[int], link: Link) -> int | None:
    """An equation that is to be shown with one ratio of an angle, by squares of two of them.

    The square of the other is 1 less that of this: no tangent is taken of what has none. None
    where no line has both squares, or it is not shown by that at once.
    """
    ratios = {
        (node.function, node.argument)
        for side in (link.left, link.right)
        for node in walk(side)
        if isinstance(node, Apply) and node.function in (*_OF, "tan", "cot")
    }
    kept = {(_OF.get(function), angle) for function, angle in ratios}
    if len(kept) != 1:
        return None
    ((name, angle),) = kept
    if name is None:
        return None
    one, other = Apply(name, angle), Apply(_OTHER[name], angle)
    for number in numbers:
        own = scene.desk.relation(number)
        if len(own.options) > 1 or own.only[0].sign != "=" or has_quantity_in(own):
            continue
        inside = {node for side in (own.only[0].left, own.only[-1].right) for node in walk(side)}
        if not {one, other} <= inside:
            continue
        sides = (_by_the_other(side, other, one) for side in (own.only[0].left, own.only[-1].right))
        whole = Link(next(sides), "=", next(sides))
        if other in {node for side in (whole.left, whole.right) for node in walk(side)}:
            continue
        mark = scene.desk.mark()
        known = scene.judge.known(letters(whole.left) | letters(whole.right))
        middle = scene.judge.write((_PYTHAGORAS,), [number, *known], Relation(((whole,),)))
        if middle is not None:
            line = _cleared(scene, middle, known, link)
            if line is not None:
                return line
        scene.desk.back(mark)
    return None


def _cleared(scene: Scene, line: int, known: Sequence[Ref], link: Link) -> int | None:
    """A power that is a quotient, with what is divided by on the other side before."""
    match link:
        case Link(Binary("^") as power, "=", Binary("/", above, below)) if letters(below):
            between = chain(swept(product(below, power)), (above, None))
            line = scene.judge.write(_TO_CLEAR, [line, *known], between) or line
    return scene.judge.write(_TO_CLEAR, [line, *known], Relation(((link,),)))


def tangent_by_squares(scene: Scene, pool: Sequence[Ref], link: Link) -> int | None:
    """The square of a tangent by that of the sine or the cosine, with the other one between.

    None of another equation, and where the first of the pool gives no such square.
    """
    match link.left, pool:
        case Binary("^", Apply("tan", angle), Number(Fraction(numerator=2, denominator=1))), [
            int(line),
            *others,
        ]:
            pass
        case _:
            return None
    if len(scene.desk.relation(line).options) > 1:
        return None
    own = scene.desk.last_link(line)
    name = next((e for e in _OTHER if own.left == square(Apply(e, angle))), None)
    if name is None or own.sign != "=" or has_quantity(own.right):
        return None
    worth = scene.scalar(own.right)
    rest = tree_of(tidy(one_fraction(expanded(1 - worth))))
    other = chain(
        square(Apply(_OTHER[name], angle)),
        (Binary("-", ONE, own.right), None),
        (rest, "rearrange"),
    )
    mark = scene.desk.mark()
    second = scene.judge.write((_PYTHAGORAS,), [line, *others], other)
    if second is not None:
        pair = (line, second) if name == "sin" else (second, line)
        known = scene.judge.known(letters(own.right))
        quotient = scene.judge.enough(Move("divide"), pair, Relation(((link,),)), [*others, *known])
        if quotient is not None:
            return scene.desk.write(Move("divide"), quotient, Relation(((link,),)))
    scene.desk.back(mark)
    return None


def _by_the_other(tree: Expression, other: Apply, one: Apply) -> Expression:
    """A tree with the squares of one ratio of an angle by those of the other."""

    def change(node: Expression) -> Expression:
        match node:
            case Binary("^", base, Number(Fraction(numerator=2, denominator=1))):
                inside = factors(base)
                if inside.count(other) == 1:
                    rest = [square(factor) for factor in inside if factor != other]
                    return product(*rest, Binary("-", ONE, square(one)))
        return node

    return rebuilt(tree, change)
