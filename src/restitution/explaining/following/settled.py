"""A derivation with each velocity at the last event that changed it."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.trees import settled, trees_of
from restitution.expression.tree import (
    Expression,
)


def settled_derivation(derivation: Derivation) -> Derivation:
    """The same working, with each velocity numbered by the last event that changed it."""

    def of(relation: Relation | Meaning) -> Relation | Meaning:
        return _settled(relation, derivation.events) or relation

    def fact_of(fact: Fact) -> Fact:
        own = of(fact.relation)
        return fact if own is fact.relation else replace(fact, relation=own)  # type: ignore[arg-type]

    def line_of(line: Line) -> Line:
        own = of(line.relation)
        return line if own is line.relation else replace(line, relation=own)

    return replace(
        derivation,
        facts=tuple(map(fact_of, derivation.facts)),
        lines=tuple(map(line_of, derivation.lines)),
        items=tuple(replace(item, answer=of(item.answer)) for item in derivation.items),  # type: ignore[arg-type]
        notes=tuple(
            replace(note, claim=None if note.claim is None else of(note.claim))  # type: ignore[arg-type]
            for note in derivation.notes
        ),
    )


@lru_cache(maxsize=4096)
def _settled(relation: Relation | Meaning, events: tuple[Event, ...]) -> Relation | Meaning | None:
    """What a line says, so settled; None where nothing is changed."""

    def change(tree: Expression) -> Expression:
        return settled(tree, events)

    if all(change(tree) is tree for tree in trees_of(relation)):
        return None
    if isinstance(relation, Meaning):
        return replace(relation, quantity=change(relation.quantity))
    return Relation(
        tuple(
            tuple(Link(change(e.left), e.sign, change(e.right), e.by) for e in links)
            for links in relation.options
        )
    )
