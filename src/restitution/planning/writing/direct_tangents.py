"""Tangents of directions by components in letters, where their values would cancel.

Of components such as v = ⅓u sin θ and u cos θ the tangent is ⅓ tan θ. Neither the sine nor the
cosine is wanted then, nor what they make of the components.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Move,
    Ref,
    Relation,
    citing,
    numbers_in,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, one_fraction
from restitution.records import dataclass

_TANGENTS = ("tan", "tan-direction")


@dataclass(frozen=True)
class PutIn:
    """A line that puts ratios of an angle into a component: ``plain`` is that in letters.

    ``line`` is what says it so: another line, or this one without its end.
    """

    value: Expression
    plain: Expression
    number: int
    line: Line
    ratios: tuple[Line, ...]


def with_direct_tangents(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no component is worked out for a tangent in which it cancels."""
    for line in derivation.lines:
        if line.move.record in _TANGENTS and line.move.id == "define":
            shorter = _shortened(derivation, line, oracle)
            derivation = shorter or derivation
    return derivation


def _shortened(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation | None:
    relation = line.relation
    match relation:
        case Relation(((Link(left, "=", Binary("/") as quotient), *_),)):
            value = relation.only[-1].right
        case _:
            return None
    parts = list(components_put_in(derivation, line))
    if len(parts) != 2 or (letters(value) and not any(map(_has_root, parts))):
        return None
    plain: Expression = quotient
    for part in parts:
        plain = rebuilt(plain, lambda node, part=part: without_value(node, part))  # type: ignore[misc]
    names = {name for part in parts for name in _angles(part.plain)}
    if plain == quotient or len(names) != 1 or names & letters(value):
        return None
    (name,) = names
    short = _multiple_of_tangent(plain, name)
    if short is None:
        return None
    fact = _tangent_given(derivation, name, parts)
    known = None if fact is not None else _tangent_line(derivation, name, parts)
    numbers: dict[Ref, Ref] = {part.number: part.line.number for part in parts}
    free = max(line.number for line in derivation.lines) + 1
    stands = known is None or 0 < known.number < line.number
    if known is not None and not known.number:
        known = replace(known, number=free + 1)
    own = replace(
        line,
        number=free,
        relation=chain(left, (plain, None), (short, "rearrange")),
        premises=citing(line.premises, numbers),
    )
    tangent = fact if known is None else known.number
    if tangent is None:
        return None
    put = replace(
        line,
        move=Move("put"),
        relation=chain(left, (value, None)),
        premises=(own.number, tangent),
    )
    sources = [ratio for part in parts for ratio in part.ratios] if known is None else [known]
    ranges = [ref for source in sources for ref in source.premises if ref != fact]
    ranges = [ref for ref in ranges if isinstance(ref, str)]
    lines: list[Line] = []
    here = derivation.asked.get(line.item or "")
    for other in derivation.lines:
        at_home = derivation.asked.get(other.item or "") == here
        premises = citing(other.premises, numbers) if at_home else other.premises
        if premises != other.premises and other.move.id == "inverse":
            # The sign of a component in letters is that of a ratio of the angle.
            premises = tuple(dict.fromkeys((*premises, *ranges)))
        if other.number == line.number:
            lines += [own, put] if known is None or stands else [own, known, put]
        elif known is not None and other.number == known.number and not stands:
            continue
        elif other.number in numbers:
            shorter = next(part.line for part in parts if part.number == other.number)
            lines += [shorter] if shorter.number == other.number else []
        else:
            again = line.number in other.premises and _closes_with(other, value)
            relation = chain(again, (_cancelled(value), None)) if again else other.relation
            lines.append(replace(other, premises=premises, relation=relation))
    for part in parts:
        once_needed(lines, derivation, part)
    whole = replace(derivation, lines=tuple(lines))
    read = reader_of(whole, oracle)
    touched: set[Ref] = {own.number, put.number, *numbers.values()}
    touched |= set() if known is None else {known.number}
    touched |= {user.number for user in _users(derivation, {part.number for part in parts})}
    return whole if all(read.accepts(read.lines[n]) for n in touched) else None  # type: ignore[index]


def _closes_with(line: Line, value: Expression) -> Expression | None:
    """The tangent that a line sets equal to a quotient in which u is not cancelled yet."""
    match line.move.id, line.relation:
        case "put", Relation(((Link(left, "=", right),),)) if right == value:
            return left
    return None


def _cancelled(quotient: Expression) -> Expression:
    return tree_of(tidy(cancelled(one_fraction(in_letters(quotient)))))


def once_needed(lines: list[Line], derivation: Derivation, part: PutIn) -> None:
    """Puts a component that another part needs, with its ratios, before the line that does."""
    own = derivation.line(part.number)
    first = next((n for n, line in enumerate(lines) if part.number in line.premises), None)
    if own is None or own.number == part.line.number or first is None:
        return
    lines.insert(first, replace(own, item=lines[first].item))


def components_put_in(derivation: Derivation, line: Line) -> Iterator[PutIn]:
    """The components in a tangent into which ratios were put for it alone."""
    part = derivation.asked.get(line.item or "")
    for ref in line.premises:
        own = derivation.line(ref)
        if own is None or not isinstance(own.relation, Relation) or len(own.relation.options) > 1:
            continue
        users = [
            user
            for user in _users(derivation, {own.number})
            if user is not line and derivation.asked.get(user.item or "") == part
        ]
        if any(user.move.id != "inverse" for user in users) or own.number in derivation.held:
            continue
        links = own.relation.only
        numbers = numbers_in(own.premises)
        cited = [premise for number in numbers if (premise := derivation.line(number)) is not None]
        ratios = tuple(line for line in cited if _is_ratio(line))
        if not ratios:
            continue
        if own.move.id == "put" and len(links) == 1:
            base = derivation.line(own.premises[0])
            match None if base is None else base.relation:
                case Relation(((*_, last),)) as above if above.only[0].left == links[0].left:
                    assert base is not None
                    yield PutIn(links[0].right, last.right, own.number, base, ratios)
        elif own.move.id == "law" and len(links) == 2 and links[-1].by == "put":
            rest = {ratio.number for ratio in ratios}
            shorter = replace(
                own,
                relation=Relation((links[:1],)),
                premises=tuple(ref for ref in own.premises if ref not in rest),
            )
            yield PutIn(links[-1].right, links[0].right, own.number, shorter, ratios)


def _users(derivation: Derivation, numbers: set[int]) -> list[Line]:
    return [line for line in derivation.lines if numbers & set(line.premises)]


def _is_ratio(line: Line) -> bool:
    """Whether a line gives a sine, cosine or tangent of a letter."""
    match line.relation:
        case Relation(((Link(Apply("sin" | "cos" | "tan", Letter()), "="), *_),)):
            return True
    return False


def without_value(tree: Expression, part: PutIn) -> Expression:
    """A component in letters for its value; its size for the size of that."""
    if tree == part.value:
        return part.plain
    match part.value, part.plain:
        case Negate(value), Negate(plain) if tree == value:
            return plain
    return tree


def _has_root(part: PutIn) -> bool:
    """Whether a ratio that was put into a component is a root."""
    sides = (
        ratio.relation.only[-1].right
        for ratio in part.ratios
        if isinstance(ratio.relation, Relation)
    )
    return any(is_function(node, "sqrt") for side in sides for node in walk(side))


def _angles(tree: Expression) -> set[str]:
    """The letters of which sines and cosines stand in a tree."""
    return {
        name
        for node in walk(tree)
        if is_function(node, "sin", "cos")
        for name in letters(node.argument)
    }


def _multiple_of_tangent(quotient: Expression, name: str) -> Expression | None:
    """A quotient as a multiple of the tangent of an angle, or over it; None where it is none."""
    if has_quantity(quotient):
        return None
    value, angle = in_letters(quotient), sp.Symbol(name)
    for ratio in (sp.tan(angle), 1 / sp.tan(angle)):
        factor = cancelled(one_fraction(value * sp.cos(angle) / sp.sin(angle)))
        if ratio != sp.tan(angle):
            factor = cancelled(one_fraction(value * sp.sin(angle) / sp.cos(angle)))
        if angle not in factor.free_symbols:
            return tree_of(tidy(factor * ratio))
    return None


def _tangent_given(derivation: Derivation, name: str, parts: list[PutIn]) -> Ref | None:
    """The fact that gives the tangent of an angle, where ratios of it with roots come of that."""
    cited = {ref for part in parts for ratio in part.ratios for ref in ratio.premises}
    for fact in derivation.facts:
        match fact.relation:
            case Relation(((Link(Apply("tan", Letter(own)), "=", right),),)) if own == name:
                if fact.id in cited and not letters(right) and any(map(_has_root, parts)):
                    return fact.id
    return None


def _tangent_line(derivation: Derivation, name: str, parts: list[PutIn]) -> Line | None:
    """The line that gives the tangent of an angle: one that stands, or one by another ratio."""
    ratios = {ratio.number: ratio for part in parts for ratio in part.ratios}
    tangent = Apply("tan", Letter(name))
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(left, "="), *_),)) if left == tangent:
                above = line.number <= max(ratios) and not letters(line.relation.only[-1].right)
                if above or line.move.id == "triangle":
                    return line
    source = next((line for line in ratios.values() if line.move.id == "triangle"), None)
    if source is None or not isinstance(source.premises[0], int):
        return None  # the angle is one of the data
    first = derivation.line(source.premises[0])
    match None if first is None else first.relation:
        case Relation(((Link(Apply(kind, Letter()), "="), *_),)) as relation:
            size = in_letters(relation.only[-1].right)
        case _:
            return None
    if not size.is_number or kind not in ("sin", "cos"):
        return None
    other = sp.sqrt(1 - size**2)
    worth = size / other if kind == "sin" else other / size
    relation = chain(tangent, (tree_of(tidy(worth)), None))
    return Line(0, source.item, Move("triangle"), source.premises, relation)


__all__ = ["with_direct_tangents"]
