"""Given facts on which no answer of a working rests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet
from functools import partial
from itertools import permutations

from restitution.explaining.lines.derivation import Derivation, Fact, Meaning, Ref, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Letter, has_quantity, letters


def unused_facts(
    derivation: Derivation, under: Callable[[Ref], AbstractSet[Ref]]
) -> Iterator[Fact]:
    """The given facts on which nothing rests that a working ends with.

    ``under`` gives a line, or a fact, with all that it rests on.
    """
    given = [fact for fact in derivation.facts if fact.kind == "given"]
    if not given:
        return
    used: dict[str | None, set[Ref]] = {}
    for end in derivation.items:
        used.setdefault(end.part, set()).update(under(end.line))
    for note in derivation.notes:
        for ref in note.premises:
            used.setdefault(note.part, set()).update(under(ref))
    # Where an item has no working, or no answer, the facts that it would use may stand idle.
    idle = {e.part for e in derivation.notes if not e.premises or e.kind in _WITHOUT_AN_ANSWER}
    every = set().union(*used.values()) if used else set()
    for fact in given:
        if fact.part in idle or (fact.part is None and idle):
            continue
        own = every if fact.part is None else used.get(fact.part, set())
        # What several parts are given is one fact.
        alike = [e.id for e in derivation.facts if e.relation == fact.relation]
        senses = [source.replace("given", "sense") for source in alike]
        if not own & {*alike, *senses}:
            yield fact


def spare_facts(derivation: Derivation) -> Iterator[Fact]:
    """The given facts that no answer needs, where there are answers; where there are none, none."""
    if derivation.asked and all(note.kind in _OF_A_SOLUTION for note in derivation.notes):
        yield from unused_facts(derivation, partial(lines_under, derivation))


def first_lines_of_letters(
    derivation: Derivation, among: AbstractSet[Ref] | None = None
) -> dict[str, int]:
    """The letters of which, or of a ratio of which, a line says the value, with the first one.

    ``among`` are the lines that count; all of them, if it is left out. A quantity that comes to a
    letter says nothing of it.
    """
    first: dict[str, int] = {}
    for line in derivation.lines:
        if among is not None and line.number not in among:
            continue
        for links in () if isinstance(line.relation, Meaning) else line.relation.options:
            ends = () if has_quantity(links[0].left) else (links[-1].right,)
            for side in (*(link.left for link in links), *ends):
                own = side.argument if isinstance(side, Apply) else side
                if isinstance(own, Letter):
                    first.setdefault(own.name, line.number)
    return first


def is_of_open_data(fact: Fact, derivation: Derivation) -> bool:
    """Whether a fact is about letters of the data alone, of which no line says the value.

    There is nothing with which it would have to agree. A line of another part says nothing of a
    letter in the part in which the fact is given.
    """
    trees = tuple(trees_of(fact.relation))
    among: set[Ref] | None = None
    if fact.part is not None:
        ends = (end.line for end in derivation.items if end.part == fact.part)
        among = set().union(*(lines_under(derivation, line) for line in ends))
    if any(map(has_quantity, trees)):
        return False
    names = frozenset[str]().union(*map(letters, trees))
    valued = names & first_lines_of_letters(derivation, among).keys()
    return not any(name in _valued_without(derivation, among, name) for name in valued)


def _valued_without(
    derivation: Derivation, among: AbstractSet[Ref] | None, name: str
) -> frozenset[str]:
    """The letters of which lines say the value without that of a letter: *β = α* tells neither."""
    sides = [
        (side.name, letters(other))
        for line in derivation.lines
        if (among is None or line.number in among) and isinstance(line.relation, Relation)
        for links in line.relation.options
        for one, other in permutations((links[0].left, links[-1].right))
        if isinstance(side := one.argument if isinstance(one, Apply) else one, Letter)
    ]
    known: set[str] = set()
    while True:
        open_ = {name, *derivation.meanings} - known
        more = {own for own, others in sides if own not in known and not others & open_}
        if not more:
            return frozenset(known)
        known |= more


def lines_under(derivation: Derivation, ref: Ref) -> set[Ref]:
    """A line, or a fact, and all that it rests on."""
    refs: set[Ref] = set()
    pending: list[Ref] = [ref]
    while pending:
        own = pending.pop()
        if own in refs:
            continue
        refs.add(own)
        line = derivation.line(own)
        if line is not None:
            pending.extend(line.premises)
            pending.extend(case.line for case in derivation.cases if own in case.lines)
    return refs


_WITHOUT_AN_ANSWER = frozenset({"unwritten", "impossible", "contradiction"})

# Notes that stand where the data have a solution.
_OF_A_SOLUTION = frozenset({"standing", "refuted", "undecided", "agreeing"})
