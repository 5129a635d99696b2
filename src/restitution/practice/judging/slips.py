"""Slips: a line that one sign, one figure or one factor away would be true.

A slip is not a misconception. What is offered here are corrections of a claim, each a change at
one place; whether the line is true with one of them is tried by the caller. Corrections are
offered in the order in which people make the slips, and never more than `LIMIT` of them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from typing import Literal

from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pi,
    Quantity,
    children,
    is_binary,
    letter_nodes,
    rational,
    walk,
)
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.records import dataclass

Change = Literal["sign", "figure", "power", "square", "factor", "letter", "radians", "turned"]

LIMIT = 400
_TWO = Number(Fraction(2))
_ZERO, _ONE = Number(Fraction(0)), Number(Fraction(1))
_TURNING = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})
_INVERSE = frozenset({"arcsin", "arccos", "arctan"})


@dataclass(frozen=True)
class Correction:
    """A claim as it would be with one thing changed: what kind of change, and of which part."""

    change: Change
    claim: Claim
    part: Expression
    put: Expression


Edit = tuple[Change, Expression, Expression, Expression]  # the tree, the part and what replaces it


def corrections(claim: Claim) -> Iterator[Correction]:
    """Every claim that differs from this one at one place, by one sign, figure, power or factor."""
    return islice(_corrections(claim), LIMIT)


def _corrections(claim: Claim) -> Iterator[Correction]:
    for changes in (_signs, _letters_of(claim), _figures, _powers, _factors):
        for left in (True, False):
            side = claim.left if left else claim.right
            for change, tree, part, put in _everywhere(side, changes):
                yield Correction(change, _with_side(claim, left, tree), part, put)
    yield from _turned(claim)
    yield from _in_radians(claim)


def _with_side(claim: Claim, left: bool, tree: Expression) -> Claim:
    return replace(claim, left=tree) if left else replace(claim, right=tree)


Changes = Callable[[Expression], Iterator[Edit]]


def _everywhere(tree: Expression, changes: Changes) -> Iterator[Edit]:
    """A tree with one of its parts changed, each in turn."""
    yield from changes(tree)
    if isinstance(tree, Quantity):
        return
    for place, child in enumerate(children(tree)):
        for change, new, part, put in _everywhere(child, changes):
            yield change, with_child(tree, place, new), part, put


def with_child(tree: Expression, place: int, child: Expression) -> Expression:
    """A tree with another one in the place of one of its parts, counted from 0."""
    match tree:
        case Binary(op, left, right):
            return Binary(op, child, right) if place == 0 else Binary(op, left, child)
        case Negate():
            return Negate(child)
        case Apply(function):
            return Apply(function, child)
    return exchanged(tree, {children(tree)[place]: child})


def _signs(tree: Expression) -> Iterator[Edit]:
    match tree:
        case Binary("+", left, right):
            yield "sign", Binary("-", left, right), right, Negate(right)
            if _is_first_term(left):
                yield "sign", Binary("+", Negate(left), right), left, Negate(left)
        case Binary("-", left, right):
            yield "sign", Binary("+", left, right), right, right
            if _is_first_term(left):
                yield "sign", Binary("-", Negate(left), right), left, Negate(left)
        case Negate(operand):
            yield "sign", operand, tree, operand


def _is_first_term(tree: Expression) -> bool:
    """Whether the first of two terms may have lost its sign: it has none, and is no sum."""
    return not isinstance(tree, Negate) and not is_binary(tree, "+", "-")


def _turned(claim: Claim) -> Iterator[Correction]:
    """The whole right side with the other sign, or as one over it."""
    tree = claim.right
    if not isinstance(tree, Negate):
        put: Expression = Negate(tree)
        yield Correction("sign", replace(claim, right=put), tree, put)
    put = Binary("/", Number(Fraction(1)), tree)
    yield Correction("turned", replace(claim, right=put), tree, put)


def _figures(tree: Expression) -> Iterator[Edit]:
    if isinstance(tree, Number):
        for value in near_numbers(tree.value):
            put = Number(value)
            yield "figure", put, tree, put
    elif isinstance(tree, Degrees):
        for value in near_numbers(tree.value):
            angle = Degrees(value)
            yield "figure", angle, tree, angle


def near_numbers(value: Fraction) -> tuple[Fraction, ...]:
    """The numbers that differ by one figure: changed, exchanged with its neighbour, or left out.

    The decimal point may have moved by one place as well.
    """
    text = _written(value)
    if text is None:
        return ()
    near: dict[Fraction, None] = {}
    for other in _near_texts(text):
        with_figures = other.strip(".")
        if with_figures and with_figures.count(".") <= 1:
            near[Fraction(with_figures)] = None
    for moved in (value * 10, value / 10):
        near[moved] = None
    near.pop(value, None)
    near.pop(Fraction(0), None)
    return tuple(near)


def _near_texts(text: str) -> Iterator[str]:
    for place, figure in enumerate(text):
        if figure == ".":
            continue
        for other in "0123456789":
            if other != figure:
                yield text[:place] + other + text[place + 1 :]
        if len(text) > 1:
            yield text[:place] + text[place + 1 :]
        if place + 1 < len(text) and text[place + 1] not in (".", figure):
            yield text[:place] + text[place + 1] + figure + text[place + 2 :]


def _written(value: Fraction) -> str | None:
    """A number as a decimal that ends, of at most six figures; None for others."""
    for places in range(7):
        scaled = value * 10**places
        if scaled.denominator == 1:
            text = str(abs(scaled.numerator)).rjust(places + 1, "0")
            if len(text) > 6:
                return None
            return text if not places else f"{text[:-places]}.{text[-places:]}"
    return None


def _powers(tree: Expression) -> Iterator[Edit]:
    match tree:
        case Binary("^", base, Number(exponent)) if exponent == 2:
            yield "power", base, tree, base
        case Apply("sqrt", argument):
            yield "power", argument, tree, argument
        case Letter() | Quantity():
            put = Binary("^", tree, _TWO)
            yield "power", put, tree, put
        case Binary("/", Number(), Number()) | Number() if tree not in (_ZERO, _ONE):
            put = Binary("^", tree, _TWO)
            yield "square", put, tree, put


def _factors(tree: Expression) -> Iterator[Edit]:
    match tree:
        case Binary("*", Number() | Letter() as factor, rest):
            yield "factor", rest, factor, rest
        case Binary("*", rest, Number() | Letter() as factor):
            yield "factor", rest, factor, rest
        case Binary("/", rest, Number() | Letter() as factor):
            yield "factor", rest, factor, rest
        case Letter() | Number() | Quantity():
            for put in (Binary("*", _TWO, tree), Binary("/", tree, _TWO)):
                yield "factor", put, tree, put


def _letters_of(claim: Claim) -> Changes:
    """One letter of a claim written for another."""
    names = sorted(
        {letter.name for side in (claim.left, claim.right) for letter in letter_nodes(side)}
    )

    def changes(tree: Expression) -> Iterator[Edit]:
        if isinstance(tree, Letter) and " " not in tree.name:
            for name in names:
                if name != tree.name and " " not in name:
                    put = Letter(name)
                    yield "letter", put, tree, put

    return changes


# --- the calculator in radians ----------------------------------------------------------------


def _in_radians(claim: Claim) -> Iterator[Correction]:
    """The claim as a calculator in radians worked it out."""
    left, right = (rebuilt(side, _radians) for side in (claim.left, claim.right))
    if left != claim.left or right != claim.right:
        yield Correction("radians", replace(claim, left=left, right=right), claim.right, right)


def _radians(tree: Expression) -> Expression:
    match tree:
        case Apply(function, argument) if function in _TURNING:
            return Apply(function, rebuilt(argument, _plain))
        case Apply(function) if function in _INVERSE:
            degrees = Binary("/", Number(Fraction(180)), Pi())
            return Binary("/", tree, degrees)
    return tree


def _plain(tree: Expression) -> Expression:
    """Degrees taken for radians."""
    if isinstance(tree, Number | Degrees):
        return Binary("/", Binary("*", Number(tree.value), STRAIGHT_ANGLE), Pi())
    return tree


# --- one datum for another --------------------------------------------------------------------


def misreadings(
    typed: Iterable[Fraction], data: Iterable[Fraction]
) -> Iterator[tuple[Fraction, Fraction]]:
    """Pairs of a number that is not in the question and the datum that it may misread.

    ``typed`` are the numbers of the script, once for each time that they stand there.
    """
    given = tuple(dict.fromkeys(data))
    times: dict[Fraction, int] = {}
    for value in typed:
        times[value] = times.get(value, 0) + 1
    for value, count in times.items():
        if count >= 2 and value not in given:
            yield from ((value, datum) for datum in given if datum and datum not in times)


def read_as_datum(claim: Claim, typed: Fraction, datum: Fraction) -> Claim:
    """A claim with a datum in place of the number that was read instead."""

    def change(tree: Expression) -> Expression:
        if isinstance(tree, Number) and tree.value == typed:
            return rational(datum)
        if isinstance(tree, Degrees) and tree.value == typed:
            return Degrees(datum)
        return tree

    left, right, *others = (
        rebuilt(tree, change) for tree in (claim.left, claim.right, *claim.others)
    )
    return Claim(left, claim.sign, right, tuple(others))


def in_datum(part: Expression, entry: Entry, data: Collection[Fraction]) -> bool:
    """Whether a number stands above or below the line of a fraction of the statement."""
    for side in (entry.claim.left, entry.claim.right):
        for node in walk(side):
            match node:
                case Binary("/", Number(above) as a, Number(below) as b):
                    if part in (a, b) and below and above / below in data:
                        return True
    return False
