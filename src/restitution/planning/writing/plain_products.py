"""Laws by scalar products with a plain vector, along the line of centres or along a wall.

Where components stand in one law alone, the length of the vector cancels: with 2**i** + **j** in
place of (2**i** + **j**)/√5 no root is written.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Ref, Relation, citing
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    letters,
    unsigned,
)
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import (
    ZERO,
    coordinates,
    difference,
    negative,
    opposite,
    product,
    swept,
    tree_of,
    vector,
)
from restitution.planning.writing.polynomials import expanded
from restitution.records import dataclass
from restitution.vector import Vector

# Each with the components that it is about.
_LAWS = {"restitution": "along", "restitution-wall": "along", "unchanged": "across"}


@dataclass(frozen=True)
class _Component:
    """A component along the line of centres, or across it: a scalar product over a root ``size``.

    The product is ``above``; ``kind`` is along or across.
    """

    line: Line
    kind: str
    body: str
    stage: int
    velocity: Quantity
    above: Expression
    value: sp.Expr
    size: Apply


def with_plain_products(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no root stands below components that only one law has."""
    for number in [line.number for line in derivation.lines]:
        law = derivation.line(number)
        if law is not None and law.move.id == "law" and law.move.record in _LAWS:
            derivation = _by_products(derivation, law, oracle) or derivation
    return derivation


def _by_products(derivation: Derivation, law: Line, oracle: Oracle) -> Derivation | None:
    """The working with a law by scalar products; None where other lines need a component."""
    cited = derivation.lines_in(law.premises)
    parts = [own for line in cited if (own := _component(line)) is not None]
    kinds = {part.kind for part in parts} - {_LAWS[law.move.record or ""]}
    if kinds or len(parts) != len(cited) or len({part.size for part in parts}) != 1:
        return None
    if any(part.line.number in derivation.held for part in parts):
        return None
    numbers = {part.line.number for part in parts}
    if any(numbers & set(line.premises) for line in derivation.lines if line is not law):
        return None
    along = _along(derivation, parts[0].line)
    if along is not None and parts[0].kind == "across":
        along, parts = _along_the_wall(derivation, law, along, parts)
        relation = _what_stays(law, parts)
    else:
        relation = _law(derivation, law, parts)
    if along is None or relation is None:
        return None
    axis = along[1]
    changed = {part.line.number: _product(part, *along) for part in parts}
    premises = tuple(dict.fromkeys((*law.premises, axis)))
    changed[law.number] = replace(law, relation=relation, premises=premises)
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    again = [e for e in lines if e.premises == (law.number,) and e.relation == relation]
    if any(line.number in derivation.held for line in again):
        return None
    instead: dict[Ref, Ref] = {own.number: law.number for own in again}
    lines = tuple(
        replace(line, premises=citing(line.premises, instead)) if instead else line
        for line in lines
        if line not in again
    )
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    touched = {*changed, *(e.number for e in lines if law.number in e.premises)}
    return whole if all(read.accepts(read.lines[n]) for n in touched) else None


def _component(line: Line) -> _Component | None:
    """The component that a line works out by a scalar product over a root."""
    if line.move.record != "component" or not isinstance(line.relation, Relation):
        return None
    quotient: Expression | None = None
    match line.relation.options[0]:
        case (
            Link(
                Quantity(
                    "along" | "across" as kind,
                    (Quantity("velocity", (Name(body),), int(stage)) as velocity, Quantity()),
                ),
                "=",
                right,
            ),
            *_,
        ):
            quotient = unsigned(right)
    match quotient:
        case Binary("/", above, Apply("sqrt", Number()) as size):
            above = negative(above) if isinstance(right, Negate) else above
            value = tidy(expanded(in_letters(above)))
            return _Component(line, kind, body, stage, velocity, above, value, size)
    return None


def _along(derivation: Derivation, line: Line) -> tuple[Expression, Ref] | None:
    """The vector to which the data, or a line, say that a line of centres is parallel."""
    for ref in line.premises:
        own = derivation.cited(ref)
        match None if own is None else own.relation:
            case Relation(((Link(Quantity("line_of_centres"), "parallel to", parallel),),)):
                whole = coordinates(parallel)
                return None if whole is None else (vector(*whole), ref)
    return None


def _along_the_wall(
    derivation: Derivation, law: Line, axis: tuple[Expression, Ref], parts: list[_Component]
) -> tuple[tuple[Expression, Ref], list[_Component]]:
    """The vector along a wall, in the sense of that, and the components in this sense."""
    parallel, ref = axis
    x, y = coordinates(parallel) or (ZERO, ZERO)
    beside = vector(negative(y), x)
    wall = next((e.bodies[-1] for e in derivation.events if e.number == law.move.event), "")
    fact = derivation.fact(f"wall {wall}")
    along = None if fact is None else in_letters(fact.relation.only[-1].right)
    other = in_letters(beside)
    if isinstance(along, Vector) and isinstance(other, Vector) and along.dot(other).is_negative:
        beside = vector(y, negative(x))
        parts = [
            replace(own, above=opposite(own.above, as_it_stands=True), value=-own.value)
            for own in parts
        ]
    return (beside, ref), parts


def _what_stays(law: Line, parts: list[_Component]) -> Relation | None:
    """That scalar products with a vector along a wall are equal; None where one is not told."""
    values = {part.stage == law.move.event: tree_of(part.value) for part in parts}
    if values.keys() != {True, False}:
        return None
    return chain(values[True], (values[False], None))


def _product(part: _Component, parallel: Expression, axis: Ref) -> Line:
    """The line of a scalar product with a vector, in place of that of a component."""
    subject = Quantity("dot", (part.velocity, parallel))
    return replace(
        part.line,
        premises=tuple(ref for ref in part.line.premises if ref != axis),
        relation=chain(subject, (part.above, None), (tree_of(part.value), "rearrange")),
    )


def _has_others_across(derivation: Derivation, event: int) -> bool:
    """Whether components across the line of an impact are worked out, too."""
    return any(
        line.move.record == "component"
        and line.move.event == event
        and isinstance(line.relation, Relation)
        and isinstance(own := line.relation.options[0][0].left, Quantity)
        and own.kind == "across"
        for line in derivation.lines
    )


def _with_its_value(derivation: Derivation, law: Line, coefficient: Expression) -> Expression:
    """A coefficient, by its value where a fact that the law cites says that."""
    for ref in law.premises:
        own = derivation.cited(ref)
        match None if own is None else own.relation:
            case Relation(((Link(left, "=", right),),)) if left == coefficient:
                return right
    return coefficient


def _law(derivation: Derivation, law: Line, parts: list[_Component]) -> Relation | None:
    """Newton's law by the values of scalar products; None where no letter stands in it."""
    event = law.move.event
    if event is None:
        return None
    values = {(part.body, part.stage == event): tree_of(part.value) for part in parts}
    coefficient = derivation.fact(f"e {event}")
    if coefficient is None:
        return None
    e = _with_its_value(derivation, law, coefficient.relation.only[0].right)
    first, *others = law.move.bodies
    if not others:
        left = negative(values.get((first, True), ZERO))
        approach = values.get((first, False), ZERO)
    else:
        late = [values.get((body, True), ZERO) for body in (others[0], first)]
        early = [values.get((body, False), ZERO) for body in (first, others[0])]
        left, approach = difference(*late), difference(*early)
    if not letters(e) and (
        not letters(left) | letters(approach) or _has_others_across(derivation, event)
    ):
        return None  # components in both directions are resolved alike
    return chain(swept(left), (swept(product(e, approach)), None))


__all__ = ["with_plain_products"]
