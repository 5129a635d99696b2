"""Lines that start from the latest form of another line, where several forms of it stand.

From the last one of an equation; of an inequality from its factors, which are not multiplied out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Line,
    Link,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Negate,
    Number,
    has_quantity,
    is_binary,
    is_zero,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.forms import factors_above

_FORMS = frozenset({"rearrange", "cancel", "identity"})
_TWO = Number(Fraction(2))
_STARTING = frozenset({"rearrange", "put"})


def with_latest_forms(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no line goes back behind a form of its equation for that form."""
    if derivation.cases:
        return derivation
    for line in derivation.lines:
        first = line.premises[0] if line.premises else None
        if line.move.id in _STARTING and isinstance(first, int) and first < line.number - 1:
            derivation = _from_a_form(derivation, line, first, oracle)
    return derivation


def with_factors_kept(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which factors of which the signs tell a range are not multiplied out."""
    for line in derivation.lines:
        if line.move.id == "compare":
            derivation = _from_factors(derivation, line, oracle)
    return derivation


def with_squares_of_speeds(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no root is taken of a speed of which only the square is used."""
    for line in derivation.lines:
        if line.move.record == "speed":
            derivation = _without_its_root(derivation, line, oracle)
    return derivation


def _without_its_root(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation:
    """With the square of a speed by its components, where the line below it is that square."""
    users = [other for other in derivation.lines if line.number in other.premises]
    if len(users) != 1 or derivation.held & {line.number, users[0].number}:
        return derivation
    (user,) = users
    match line.relation, user.relation:
        case (
            Relation(((Link(speed, "=", Apply("sqrt", squares)), *_),)),
            Relation(((Link(Binary("^", base, power) as own, "=", value),),)),
        ) if base == speed and power == _TWO and has_quantity(speed):
            pass
        case _:
            return derivation
    if user.move.id != "rearrange" or user.premises != (line.number,):
        return derivation
    links = [Link(own, "=", squares)]
    if value != squares:
        links.append(Link(squares, "=", value, "rearrange"))
    direct = replace(line, relation=Relation((tuple(links),)))
    lines = tuple(
        replace(
            other, premises=tuple(line.number if e == user.number else e for e in other.premises)
        )
        for other in (direct if other == line else other for other in derivation.lines)
        if other.number != user.number
    )
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    return whole if read.accepts(read.lines[line.number]) else derivation


def _from_factors(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation:
    for ref in line.premises:
        form = derivation.line(ref)
        if form is None or form.move.id != "rearrange" or len(form.premises) != 1:
            continue
        users = [line for line in derivation.lines if form.number in line.premises]
        fixed = any(end.line == form.number for end in derivation.items)
        (first,) = form.premises
        product = derivation.line(first)
        if len(users) > 1 or fixed or product is None or not _is_multiplied_out(product, form):
            continue
        direct = replace(line, premises=tuple(first if e == ref else e for e in line.premises))
        lines = tuple(direct if other == line else other for other in derivation.lines)
        whole = replace(derivation, lines=lines)
        read = reader_of(whole, oracle)
        if read.accepts(read.lines[line.number]):
            return whole
    return derivation


def _is_multiplied_out(product: Line, form: Line) -> bool:
    """Whether a line has as a sum what another has as a product of sums, compared with zero."""
    match product.relation, form.relation:
        case (
            Relation(((Link(left, sign, right),),)),
            Relation(((Link(Binary("+" | "-"), other, zero),),)),
        ) if is_zero(right) and is_zero(zero):
            sums = [factor for factor in factors_above(left) if isinstance(factor, Binary)]
            ordered = sign in FLIPPED and other in FLIPPED
            return ordered and len(sums) > 1 and not isinstance(left, Negate)
    return False


def _from_a_form(derivation: Derivation, line: Line, first: int, oracle: Oracle) -> Derivation:
    """The working in which a line starts from the last form of its equation, if it follows."""
    subject = _subject(line)
    same = subject is not None and subject == _subject(derivation.line(first))
    if _is_quoted(derivation.line(first), line):
        return derivation
    for form in reversed(list(_forms(derivation, first, line.number))):
        if form in line.premises:
            return derivation
        if same and _subject(derivation.line(form)) != subject:
            continue  # the first line says what the letter is, into which values are put
        if same and _sums_shared(derivation, line, first) > _sums_shared(derivation, line, form):
            continue  # it has the factors of the first line, which the form has not
        direct = replace(line, premises=(form, *line.premises[1:]))
        lines = tuple(direct if other == line else other for other in derivation.lines)
        whole = replace(derivation, lines=lines)
        read = reader_of(whole, oracle)
        if read.accepts(read.lines[line.number]):
            return whole
    return derivation


def _sums_shared(derivation: Derivation, line: Line, form: int) -> int:
    """How many sums a line has in common with a form of its equation."""
    return len(_sums_in(line) & _sums_in(derivation.line(form)))


def _sums_in(line: Line | None) -> set[Expression]:
    """The sums and differences in the relation of a line."""
    if line is None or not isinstance(line.relation, Relation):
        return set()
    nodes = (node for tree in trees_of(line.relation) for node in walk(tree))
    return {node for node in nodes if is_binary(node, "+", "-")}


def _is_quoted(first: Line | None, line: Line) -> bool:
    """Whether a line has a value in the form in which another gives it."""
    match first and first.relation:
        case Relation(((*_, Link(_, "=", value)),)):
            pass
        case _:
            return False
    own = line.relation
    return (
        isinstance(own, Relation)
        and len(own.options) == 1
        and isinstance(value, Binary)
        and value in {side for link in own.only for side in (link.left, link.right)}
    )


def _forms(derivation: Derivation, first: int, end: int) -> Iterator[int]:
    """The lines between two that say what the first one says, each made of one before it."""
    own = {first}
    for line in derivation.lines:
        if not first < line.number < end or line.move.id not in _FORMS:
            continue
        above = numbers_in(line.premises)
        if len(above) == 1 and above[0] in own and _is_equation(line):
            own.add(line.number)
            yield line.number


def _subject(line: Line | None) -> Expression | None:
    """The left side of a line that is one equation."""
    match line and line.relation:
        case Relation((((Link(left, "="), *_)),)):
            return left
    return None


def _is_equation(line: Line) -> bool:
    """Whether a line is one equation, in one solution."""
    match line.relation:
        case Relation((links,)):
            return all(link.sign == "=" for link in links)
    return False


__all__ = ["with_factors_kept", "with_latest_forms"]
