"""Given facts that a working does not need: each is a line that follows from the others."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from restitution.explaining.data.unused import is_of_open_data, lines_under, unused_facts
from restitution.explaining.following.tracing import explain_line
from restitution.explaining.lines.derivation import Derivation
from restitution.oracle import Oracle


def agreeing_facts(derivation: Derivation, oracle: Oracle) -> frozenset[str]:
    """The given facts on which no answer rests, and which follow from the lines of the working.

    One about letters of the data of which no line says the value has nothing to follow from.
    """
    spare = {fact.id for fact in unused_facts(derivation, partial(lines_under, derivation))}
    rest = tuple(fact for fact in derivation.facts if fact.id not in spare)
    without = replace(derivation, facts=rest)
    return frozenset(
        fact.id
        for fact in derivation.facts
        if fact.id in spare
        and (
            is_of_open_data(fact, derivation)
            or explain_line(fact.relation, without, oracle).kind != "unrecognised"
        )
    )


__all__ = ["agreeing_facts"]
