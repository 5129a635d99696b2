"""Scripts with slips by machine: a sign, a number, a power or a function is another in a line.

The lines are those of a working, typed as derived scripts are; the line with the slip is not true,
by numbers worked out from the derivation, and all others are.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import permutations
from random import Random
from typing import Literal

from derived_scripts import (
    derive,
    holds,
    in_senses,
    planned,
    quantities_of,
    rows,
    senses_of,
)

from restitution.explaining.lines.derivation import Derivation, Link, Relation, of_part
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Apply, Binary, Expression, Negate, Number
from restitution.practice.worlds.sampling import true_worlds

Kind = Literal["sign", "digit", "power", "function"]
LIKE_LAWS: Mapping[Kind, frozenset[str]] = {
    "sign": frozenset({"momentum-sign", "restitution-sign", "impulse-sign"}),
    "digit": frozenset(),
    "power": frozenset({"square-not-taken"}),
    "function": frozenset({"sine-cosine", "angle-from-normal"}),
}
"""Misconceptions that a slip of a kind may be, where it makes their law."""

_OTHER = {"sin": "cos", "cos": "sin"}
_TRIES = 30


@dataclass(frozen=True)
class SlippedScript:
    """A script with slips: the numbers of their lines, counted from 1, with their kinds."""

    statement: str
    part: str | None
    letters: Mapping[str, str]
    lines: tuple[str, ...]
    slips: Mapping[int, Kind]

    @property
    def working(self) -> str:
        return "\n".join(self.lines)


def slipped(
    statement: str, part: str | None, random: Random, number: int = 1
) -> SlippedScript | None:
    """A script of a part with so many slips; None where none were made that are not true."""
    solution, derivation = planned(statement)
    own = of_part(derivation, part)
    worlds = true_worlds(solution, solution.parts[part])
    written = list(rows(own))
    senses, quantities = senses_of(solution, derivation, part), quantities_of(derivation)

    def is_true(link: Link) -> bool:
        sides = (in_senses(exchanged(x, quantities), senses) for x in (link.left, link.right))
        return holds(tuple(sides), worlds)

    chosen: dict[int, tuple[Relation, Kind]] = {}
    for _ in range(_TRIES):
        line, relation = random.choice(written)
        edits = list(_slips(line.move.id, relation))
        if len(chosen) == number or line.number in chosen or not edits:
            continue
        if any(
            _rests_on(own, one, other) for one, other in permutations((line.number, *chosen), 2)
        ):
            continue  # the later slip might follow from the earlier one
        kind = random.choice(sorted({each for each, _, _ in edits}))
        _, link, whole = random.choice([each for each in edits if each[0] == kind])
        if not is_true(link) and all(is_true(each) for each in relation.options[0]):
            chosen[line.number] = whole, kind
    if len(chosen) < number:
        return None
    script = derive(statement, part, random, {n: whole for n, (whole, _) in chosen.items()})
    if len(script.lines) < len(written):
        return None  # a line was too long to be read
    first = len(script.lines) - len(written) + 1
    slips = {
        place: chosen[line.number][1]
        for place, (line, _) in enumerate(written, first)
        if line.number in chosen
    }
    return SlippedScript(statement, part, script.letters, script.lines, slips)


def _rests_on(derivation: Derivation, number: int, other: int) -> bool:
    """Whether a line rests on another, over all lines between."""
    pending, seen = [number], set[int]()
    while pending:
        line = derivation.line(pending.pop())
        for premise in line.premises if line is not None else ():
            if isinstance(premise, int) and premise not in seen:
                seen.add(premise)
                pending.append(premise)
    return other in seen


def _slips(move: str, relation: Relation) -> Iterator[tuple[Kind, Link, Relation]]:
    """Every slip in the last side of a line, with the link in which it is."""
    (links,) = relation.options
    if move in ("fact", "let") or links[-1].sign != "=":
        return
    for kind, tree in _edits(links[-1].right):
        link = replace(links[-1], right=tree)
        yield kind, link, Relation(((*links[:-1], link),))


def _edits(tree: Expression) -> Iterator[tuple[Kind, Expression]]:
    """A tree with one slip in it, in every way."""
    match tree:
        case Number(value) if value.denominator == 1 and value > 1:
            yield "digit", replace(tree, value=value + 1)
            yield "digit", replace(tree, value=value + 3)
        case Negate(operand):
            yield "sign", operand
            yield from ((kind, Negate(x)) for kind, x in _edits(operand))
        case Binary("^", left, Number() as power):
            if power.value == 2:
                yield "power", left
            yield from ((kind, replace(tree, left=x)) for kind, x in _edits(left))
        case Binary(op, left, right):
            if op in ("+", "-"):
                yield "sign", replace(tree, op="-" if op == "+" else "+")
            yield from ((kind, replace(tree, left=x)) for kind, x in _edits(left))
            yield from ((kind, replace(tree, right=x)) for kind, x in _edits(right))
        case Apply(function, argument):
            if function in _OTHER:
                yield "function", replace(tree, function=_OTHER[function])
            else:
                yield from ((kind, replace(tree, argument=x)) for kind, x in _edits(argument))
