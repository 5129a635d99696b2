"""Formulas of the book, quoted in the middle of a chain: ``I = m(v - u) = 0.5(5.2 + 6.9)``."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from collections.abc import Set as AbstractSet
from dataclasses import replace
from fractions import Fraction

from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    has_unit_vector,
    is_zero,
    letters,
    walk,
)
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim, Link, Script, ScriptLine

# Distance, speed and time, as books have them, with nothing put in: ``s = ut so 3 = 4t``.
_OF_STEADY_MOTION = re.compile(
    r"(?<![\w.])(?:[sd]\s*=\s*[usv]\s*[x×*]?\s*t|t\s*=\s*[sd]\s*/\s*[usv]|[usv]\s*=\s*[sd]\s*/\s*t)"
    r"(?=\s*(?:$|[,;:)∴]|=>|so\b|hence\b|therefore\b))"
)
_NUMBERS_OF_FORMULAS = frozenset((Fraction(0), Fraction(1, 2), Fraction(1), Fraction(2)))


def without_steady_motion(line: str, known: Collection[str]) -> str:
    """A line with blanks for ``s = ut`` where the question has no letter for any of these."""
    if not {"s", "d", "t", "u", "v"}.isdisjoint(known):
        return line
    return _OF_STEADY_MOTION.sub(lambda match: " " * len(match[0]), line)


def has_data(line: ScriptLine) -> bool:
    """Whether a line has numbers in it that no formula has by itself, or a value alone: 2i + j."""
    sides = [
        side
        for link in line.links
        for side in (link.readings[0].left, link.readings[0].right)
        if not is_zero(side)
    ]
    return any(
        (not letters(side) and not has_quantity(side)) or any(map(_is_datum, walk(side)))
        for side in sides
    )


def vectors_in(line: ScriptLine) -> frozenset[str]:
    """The letters that a line says to be vectors of **i** and **j**: ``v = 2i + j``."""
    return frozenset(
        one.name
        for link in line.links
        for claim in link.readings[:1]
        for one, other in ((claim.left, claim.right), (claim.right, claim.left))
        if isinstance(one, Letter) and has_unit_vector(other)
    )


def is_of_impulse(line: ScriptLine) -> bool:
    """Whether a line is ``I = m(v - u)`` or ``I = mv - mu`` and no more.

    That is the formula of the book, in vectors, whatever the question calls by these letters.
    """
    if len(line.links) != 1:
        return False
    match line.links[0].readings[0]:
        case Claim(Letter(name), "=", Binary("*", Letter(mass), Binary("-", Letter(), Letter()))):
            own = {mass}
        case Claim(
            Letter(name),
            "=",
            Binary("-", Binary("*", Letter(a), Letter()), Binary("*", Letter(b), Letter())),
        ):
            own = {a, b}
        case _:
            return False
    return own <= {"m", "M"} and (name in ("I", "J") or "impulse" in name)


def is_formula(tree: Expression, known: Collection[str]) -> bool:
    """Whether a tree is of letters that are not all known, and of no data."""
    own = letters(tree)
    if not own - set(known) or any(map(is_phrase, own)):
        return False
    return not any(isinstance(node, Quantity) or _is_datum(node) for node in walk(tree))


def _is_datum(tree: Expression) -> bool:
    """Whether a number is none of those of formulas."""
    of_formulas = isinstance(tree, Number) and abs(tree.value) in _NUMBERS_OF_FORMULAS
    return isinstance(tree, Number | Degrees) and not of_formulas


def is_quoted(before: Link, behind: Link, known: Collection[str]) -> bool:
    """Whether two links are a chain with a formula in its middle, which goes on with no other."""
    first, second = before.readings[0], behind.readings[0]
    return (
        first.sign == second.sign == "="
        and first.right == second.left
        and not first.others
        and is_formula(first.right, known)
        and not is_formula(second.right, known)
    )


def beyond_formula(before: Link, behind: Link) -> Link:
    """What the start of a chain says of its end, the formula between them left out."""
    left = before.readings[0].left
    readings = tuple(dict.fromkeys(replace(reading, left=left) for reading in behind.readings))
    return replace(behind, readings=readings, start=before.start)


def without_quoted(script: Script, known: Collection[str]) -> Script:
    """The script, without formulas whose letters stand nowhere else.

    ``known`` are the letters of the question, and those that are declared.
    """
    known = {
        *known,
        *(declaration.letter for line in script.lines for declaration in line.declarations),
    }
    elsewhere = frozenset[str]().union(
        *(letters(side) for line in script.lines for side in _sides(line, known))
    )
    return replace(script, lines=tuple(_shorter(line, known, elsewhere) for line in script.lines))


def _sides(line: ScriptLine, known: Collection[str]) -> Iterator[Expression]:
    """The sides of a line's relations, without formulas in the middle of a chain."""
    for place, link in enumerate(line.links):
        left, right = (link.readings[0].left, link.readings[0].right)
        if not (place and is_quoted(line.links[place - 1], link, known)):
            yield left
        if not any(is_quoted(link, other, known) for other in line.links[place + 1 : place + 2]):
            yield right
        yield from link.readings[0].others


def _shorter(line: ScriptLine, known: Collection[str], elsewhere: AbstractSet[str]) -> ScriptLine:
    """A line without the formulas of which no letter that is not known stands elsewhere."""
    links: list[Link] = []
    for link in line.links:
        quoted = bool(links) and is_quoted(links[-1], link, known)
        if quoted and not (letters(link.readings[0].left) - set(known)) & elsewhere:
            links[-1] = beyond_formula(links[-1], link)
        else:
            links.append(link)
    return replace(line, links=tuple(links))
