"""What a note says cannot be: premises that do not hold together, or not with a claim."""

from __future__ import annotations

from restitution.explaining.algebra import NotComparableError
from restitution.explaining.derivation import Meaning, Note, Relation
from restitution.explaining.step import Cited, Step
from restitution.explaining.trees import of_relation
from restitution.oracle import BeyondError, Oracle

_WORDS = frozenset({"parallel to", "perpendicular to", "≈"})


def excludes(note: Note, step: Step, unknown: bool = False) -> bool:
    """Whether what a step cites cannot hold together, nor with the claim of a note.

    Letters have the values of its instance. ``unknown`` is the answer for what cannot be compared.
    """
    claim = None if note.claim is None else _at(note, note.claim)
    if claim is not None and any(e.sign in _WORDS for links in claim.options for e in links):
        return unknown
    cited = tuple(
        Cited(e.ref, e.relation if isinstance(e.relation, Meaning) else _at(note, e.relation))
        for e in step.cited
    )
    there = step.under(cited=cited)
    try:
        facts = (*there.facts, *(() if claim is None else (there.formula(claim),)))
        return Oracle(there.roles, facts).possible.answer == "refuted"
    except (NotComparableError, BeyondError):
        return unknown


def _at(note: Note, relation: Relation) -> Relation:
    """A relation with the values of an instance for its letters."""
    values = {each.left: each.right for each in note.instance}
    return of_relation(relation, lambda tree: values.get(tree, tree)) if values else relation
