"""The cosine of an angle with a velocity along an axis, which takes one component of the other.

Where a velocity has letters, *(5 + 4 cos θ)**i** + 4 sin θ **j***, and its speed is known, the
angle that it makes with 5**i** needs no sin θ.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    is_quantity,
)
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import product, swept, tree_of
from restitution.vector import Vector


def with_one_component(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no component is worked out that such a cosine does not need."""
    if derivation.cases:
        return derivation
    for line in derivation.lines:
        if line.move.record == "scalar-angle":
            derivation = _by_one_component(derivation, line, oracle)
    return derivation


def _by_one_component(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation:
    """The working with a cosine by the component along an axis, if that follows."""
    match line.relation:
        case Relation(((Link(Apply("cos", Letter()) as cosine, "="), *_),)):
            final = line.relation.only[-1].right
        case _:
            return derivation
    for own in derivation.lines_in(line.premises):
        source = _source_of(derivation, own, line)
        right = None if source is None else _by_the_axis(derivation, line, own, source)
        if source is None or right is None:
            continue
        _, *values = own.premises
        kept: list[Ref] = [ref for ref in line.premises if ref != own.number]
        for spare in values:
            rest = [ref for ref in values if ref != spare]
            put = exchanged(right[0], _values(derivation, rest))
            relation = chain(cosine, (put, None), (final, "rearrange"))
            refs = together(kept, right[1], (source.number,), rest)
            direct = replace(line, premises=refs, relation=relation)
            lines = tuple(direct if other == line else other for other in derivation.lines)
            whole = replace(derivation, lines=lines)
            read = reader_of(whole, oracle)
            if read.accepts(read.lines[line.number]):
                return whole
    return derivation


def _values(derivation: Derivation, refs: Iterable[Ref]) -> dict[Expression, Expression]:
    """What facts and lines say that letters and ratios are."""
    values: dict[Expression, Expression] = {}
    for ref in refs:
        own = derivation.line(ref) or derivation.fact(ref)
        match None if own is None else own.relation:
            case Relation(((Link(Letter() | Apply() as left, "="), *_),) as options):
                values[left] = options[0][-1].right
    return values


def _source_of(derivation: Derivation, own: Line, user: Line) -> Line | None:
    """The line of a velocity in letters, into which another one puts values for a cosine alone."""
    if own.move.id != "put" or own.number in derivation.held or len(own.premises) < 2:
        return None
    if any(own.number in e.premises for e in derivation.lines if e != user):
        return None
    source = derivation.line(own.premises[0])
    match own.relation, None if source is None else source.relation:
        case (
            Relation(((Link(Quantity("velocity", (Name(),)) as velocity, "="),),)),
            Relation(((Link(other, "="),),)),
        ) if velocity == other:
            return source
    return None


def _by_the_axis(
    derivation: Derivation, line: Line, own: Line, source: Line
) -> tuple[Expression, tuple[Ref, ...]] | None:
    """The cosine as (component × component)/(speed × speed), with what gives the second speed.

    None where the other velocity is along no axis, or the speed is not known.
    """
    assert isinstance(own.relation, Relation)
    assert isinstance(source.relation, Relation)
    velocity = own.relation.only[0].left
    early = _other_velocity(derivation, line, velocity)
    late = in_letters(source.relation.only[0].right)
    speed = _speed_of(derivation, line, velocity)
    if early is None or speed is None or not isinstance(late, Vector):
        return None
    (size,) = (part for part in early if part != 0)
    component = late.x if early.y == 0 else late.y
    above = product(tree_of(size), tree_of(component))
    below = product(tree_of(abs(size)), speed[0])
    return swept(Binary("/", above, below)), speed[1]


def _other_velocity(derivation: Derivation, line: Line, velocity: Expression) -> Vector | None:
    """The velocity of the data with which a velocity makes an angle, where it is along an axis."""
    for meaning in (own.relation for own in derivation.lines_in(line.premises)):
        match None if not isinstance(meaning, Meaning) else meaning.quantity:
            case Quantity("deflection", (Name(body),)):
                names = [body]
            case Quantity("angle", (one, other)) if velocity in (one, other):
                names = [
                    e.arguments[0].name
                    for e in (one, other)
                    if is_quantity(e, "velocity") and e.stage == 0
                    if isinstance(e.arguments[0], Name)
                ]
            case _:
                continue
        for name in names:
            fact = derivation.fact(f"velocity {name}")
            if fact is None or fact.id not in line.premises:
                continue
            value = in_letters(fact.relation.only[-1].right, positive=True)
            if isinstance(value, Vector) and [part == 0 for part in value].count(True) == 1:
                return value
    return None


def _speed_of(
    derivation: Derivation, line: Line, velocity: Expression
) -> tuple[Expression, tuple[Ref, ...]] | None:
    """The speed of a velocity that is given, or that a line above one of its part has."""
    assert isinstance(velocity, Quantity)
    speed = Quantity("speed", velocity.arguments, velocity.stage)
    part = derivation.asked.get(line.item or "")
    sources: list[tuple[Relation | Meaning, Ref]] = [
        (fact.relation, fact.id) for fact in derivation.facts if fact.part in (None, part)
    ]
    sources += [
        (own.relation, own.number)
        for own in derivation.lines
        if own.number < line.number and derivation.asked.get(own.item or "") == part
    ]
    for relation, ref in sources:
        match relation:
            case Relation(((Link(left, "=", right),),)) if left == speed:
                return right, (ref,)
    return None


__all__ = ["with_one_component"]
