"""A relation of two sides: its claims, its decimals, and what kind of statement it is."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from operator import add, mul, sub, truediv

from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Measured,
    Number,
    Pi,
    is_function,
    letters,
    walk,
)
from restitution.practice.reading.angles import angular, is_angle, without_marks
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.readings import Side
from restitution.practice.reading.tokens import Token
from restitution.practice.reading.vocabulary import DIRECTIONS, HEADS
from restitution.practice.script import Claim, Decimal, Link, Sign, column_of

_OPERATIONS: Mapping[str, Callable[[Fraction, Fraction], Fraction]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
}


def sides_of(tokens: Sequence[Token]) -> tuple[list[list[Token]], list[Sign]]:
    """The sides of a chain, and the signs between them."""
    sides: list[list[Token]] = [[]]
    signs: list[Sign] = []
    for token in tokens:
        if token.kind == "relation":
            sides.append([])
            signs.append(token.name)  # type: ignore[arg-type]
        else:
            sides[-1].append(token)
    return sides, signs


def is_letter(tree: Expression) -> bool:
    """Whether a side is a letter, and no phrase."""
    return isinstance(tree, Letter) and not is_phrase(tree.name)


def is_numeric(tree: Expression) -> bool:
    """Whether no letter stands in a side."""
    return not letters(tree)


def worked_out(tree: Expression) -> Fraction | None:
    """The value of sums, products and quotients of numbers."""
    match tree:
        case Number(value) | Degrees(value):
            return value
        case Binary("+" | "-" | "*" | "/" as op, left, right):
            one, other = worked_out(left), worked_out(right)
            if one is None or other is None or (op == "/" and not other):
                return None
            return _OPERATIONS[op](one, other)
    return None


def is_identity(tokens: Sequence[Token]) -> bool:
    """Whether a relation is one of functions without their angle: ``sin² + cos² = 1``.

    One alone on its side, ``tan = 3/4``, is that of an angle which is not named.
    """
    for place, token in enumerate(tokens):
        if token.kind != "function":
            continue
        behind = place + 1
        first = not place or token.gap or tokens[place - 1].kind == "relation"
        if first and behind < len(tokens) and tokens[behind].kind == "relation":
            continue
        if [token.kind for token in tokens[behind : behind + 2]] == ["^", "number"]:
            behind += 2
        if behind >= len(tokens) or tokens[behind].kind in ("+", "=", "relation", "/", ")"):
            return True
    return False


def is_percentage(tree: Expression) -> bool:
    """Whether a side is a phrase such as *percentage lost*, whose value people give in percent."""
    return isinstance(tree, Letter) and bool({"percentage", "percent"} & set(tree.name.split()))


def hundredth(tree: Expression) -> Expression:
    """A number of percent as a number; anything else over a hundred."""
    if isinstance(tree, Number):
        return replace(tree, value=tree.value / 100)
    return Binary("/", tree, Number(Fraction(100)))


def finished(link: Link) -> Link:
    """A link without the marks that only reading needs."""
    readings = dict.fromkeys(
        Claim(
            without_marks(reading.left),
            reading.sign,
            without_marks(reading.right),
            tuple(map(without_marks, reading.others)),
        )
        for reading in link.readings
    )
    return replace(link, readings=tuple(readings))


def has_head(label: Token) -> bool:
    """Whether a label names more than a direction."""
    if label.kind == "name":
        return True
    return any(HEADS.get(word, "direction") != "direction" for word in label.name.split())


def is_heading(label: Token) -> bool:
    """Whether a label names a direction and no component: ``opposite direction:``."""
    words = set(label.name.split())
    named = words & (DIRECTIONS.keys() - {"opposite"} | {"i", "j"})
    return not has_head(label) and bool(words & {"direction", "opposite"}) and not named


def is_ratio(tree: Expression) -> bool:
    """Whether a side is a sine, cosine or tangent."""
    return is_function(tree, "sin", "cos", "tan")


def is_law(read: Sequence[tuple[Side, ...]]) -> bool:
    """Whether a relation has the same unknown letters in sums on both sides: a law, no value."""
    sides = [letters(sides[0].tree) for sides in read[1:]]
    return bool(sides) and sides[0] == letters(read[0][0].tree) and len(sides[0]) > 1


def turned(tree: Expression, angles: frozenset[str]) -> Expression:
    """A side beside an angle: its bare numbers are degrees."""
    if any(isinstance(node, Pi | Degrees | Measured) for node in walk(tree)):
        return tree
    if any(isinstance(node, Apply) for node in walk(tree)):
        return tree
    return angular(tree, angles)


def decimals(tokens: Sequence[Token], readings: Sequence[Claim]) -> Iterator[Decimal]:
    """The decimals of a link, and whole degrees that are a side by themselves."""
    alone = {
        column_of(side)
        for claim in readings
        for side in (claim.left, claim.right, *claim.others)
        if isinstance(side, Degrees)
    }
    for place, token in enumerate(tokens):
        if token.kind != "number":
            continue
        whole, _, places = token.text.partition(".")
        percent = place + 1 < len(tokens) and tokens[place + 1].kind == "percent"
        scale = Fraction(1, 100) if percent else Fraction(1)
        if not places and not percent and token.column not in alone:
            continue
        digits = (whole + places).lstrip("0")
        half = Fraction(1, 2 * 10 ** len(places)) * scale
        yield Decimal(token.column, token.value * scale, max(1, len(digits)), half)


def claims(
    left: Side,
    sign: Sign,
    right: Side,
    angle: bool,
    angles: frozenset[str],
    percent: bool = False,
) -> Iterator[Claim]:
    """A claim; where one side is an angle, bare numbers on the other are degrees first.

    In a chain that works out a percentage, ``% lost = 4/5 = 80``, a number may count hundredths.
    """
    others = (right.other,) if right.other is not None and right.other != right.tree else ()
    first, second = left.tree, right.tree
    if angle or is_angle(first, angles) or is_angle(second, angles):
        sides = turned(first, angles), turned(second, angles)
        more = tuple(turned(tree, angles) for tree in others)
        yield Claim(sides[0], sign, sides[1], more)
        if sides == (first, second):
            return
    yield Claim(first, sign, second, others)
    hundredths = percent and is_numeric(first) and isinstance(second, Number)
    if (is_percentage(first) or hundredths) and not others:
        yield Claim(first, sign, hundredth(second))
    if left.other is not None and left.other != left.tree:
        yield Claim(left.other, sign, second, others)
