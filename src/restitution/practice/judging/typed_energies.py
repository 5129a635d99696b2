"""Lines of energies as they are typed: their halves, their squares, and what is given of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations

from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    is_binary,
    is_quantity,
    letters,
    unsigned_terms,
    walk,
)
from restitution.practice.judgement import JudgedLine, Meaning
from restitution.practice.judging.claimed import has_value, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.reading.relations import worked_out
from restitution.practice.reading.vocabulary import HEADS, STAGES
from restitution.practice.script import Script, ScriptLine
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Problem

_TWO = Number(Fraction(2))

_ALONG = "along line of centres"


def is_given_energy(tree: Expression, world: World) -> bool:
    """Whether a number is that of an energy, or of a loss of it, which the question gives."""
    return any(are_one_number(value, tree) for _, value in given_energies(world))


def are_one_number(one: Expression, other: Expression) -> bool:
    """Whether two trees are alike, or numbers of one value: 45/4 and 11.25."""
    return one == other or (worked_out(one) is not None and worked_out(one) == worked_out(other))


def given_energies(world: World) -> Iterator[tuple[Quantity, Expression]]:
    """The energies, and losses of it, that the question gives, with their values."""
    given = (
        pair
        for _, step in world.problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare)
        for pair in permutations(relation.operands, 2)
    )
    for one, other in given:
        if isinstance(one, Quantity) and "energy" in one.kind:
            yield one, other


def is_loss_of_known(entry: Entry, entries: Sequence[Entry]) -> bool:
    """Whether a number is given for a loss of which both energies stand above, rightly."""
    lost = meant_by(entry)
    match lost:
        case Quantity("energy_lost", (), int(number)) if isinstance(entry.claim.right, Number):
            wanted = {number - 1, number}
        case Quantity("total_energy_lost", (), int(number)) if isinstance(
            entry.claim.right, Number
        ):
            wanted = {0, number}
        case _:
            return False
    known = (meant_by(other) for other in entries if other.right and other.is_value)
    stages = {x.stage for x in known if is_quantity(x, "energy") and not x.arguments}
    return wanted <= stages


_HALVES = (Number(Fraction(1, 2)), Binary("/", Number(Fraction(1)), Number(Fraction(2))))


def is_halved(entry: Entry, world: World) -> bool:
    """Whether every term with a square, or a product, has its ½: none is left out there.

    It may be a mass of ½ instead.
    """
    if any(sphere.mass in _HALVES for sphere in world.problem.spheres):
        return False
    sides = entry.claim.left, entry.claim.right
    terms = [
        term
        for side in sides
        for term in unsigned_terms(side)
        if not isinstance(term, Number | Letter | Quantity)  # no energy is worked out there
    ]
    return bool(terms) and all(map(has_half, terms))


def has_half(tree: Expression) -> bool:
    """Whether a factor ½ stands in a tree."""
    halves = (Number(Fraction(1, 2)), Binary("/", Number(Fraction(1)), _TWO))
    return any(node in halves for node in walk(tree))


def are_energies(entry: Entry) -> bool:
    """Whether either side of a claim has masses or halves, and squares, as energies have."""
    sides = entry.claim.left, entry.claim.right
    massive = all(has_half(side) or letters(side) & {"m", "M"} for side in sides)
    return massive and all(map(has_square, sides))


def has_square(tree: Expression) -> bool:
    """Whether something is squared in a tree."""
    return any(is_binary(node, "^") and node.right == _TWO for node in walk(tree))


def is_what_is_left(entry: Entry, world: World) -> bool:
    """Whether a share that is lost is given the number of the share that is left."""
    if worked_out(entry.claim.right) is None:
        return False
    match meant_by(entry):
        case Binary("/", Quantity(kind) as lost, Quantity("energy") as whole) if kind in LOSSES:
            left = Binary("/", Binary("-", whole, lost), whole)
            return has_value(left, entry.claim.right, entry, world)
    return False


def of_whole_energies(lines: Sequence[JudgedLine]) -> Script | None:
    """A script in which no energy is along a line alone, as another one is of whole speeds.

    Behind ``before 25 + 13 = 38`` the energy *after* has all components as well. None where the
    true lines do not differ so.
    """
    energies = [
        (_ALONG in left.name, left.name.split()[-1], line.line.number)
        for line in lines
        if line.verdict == "true"
        for link in line.line.links[:1]
        if isinstance(left := link.readings[0].left, Letter) and left.name[:3].upper() == "KE "
    ]
    whole = {stage for along, stage, _ in energies if not along}
    along = {number for along, stage, number in energies if along and stage not in whole}
    if not whole or not along:
        return None
    return Script(
        tuple(
            _without_along(line.line) if line.line.number in along else line.line for line in lines
        )
    )


def of_energies_along(
    lines: Sequence[JudgedLine], problem: Problem
) -> tuple[Script, tuple[Meaning, ...]] | None:
    """A script in which the energies before and after are of the components along the line.

    So they are where both leave the others out: what is lost is right. With it is what its
    phrases mean. None where one energy has all components.
    """
    partial = {
        line.line.number: energy
        for line in lines
        if line.verdict == "false" and line.mistake is not None
        if line.mistake.id == "energy-component-missing"
        if (energy := _energy_along(line.line, problem)) is not None
    }
    stages = {
        stage
        for line in lines
        for stage in ("before", "after")
        if line.line.number in partial and stage in _label(line.line).split()
    }
    whole = any(
        HEADS.get(words[0]) == "energy" and not STAGES.keys().isdisjoint(words)
        for line in lines
        if line.verdict == "true" and (words := _label(line.line).split())
    )
    if stages != {"before", "after"} or whole:
        return None
    renamed = Script(
        tuple(
            _with_label(line.line, partial[number].letter) if number in partial else line.line
            for line in lines
            for number in (line.line.number,)
        )
    )
    return renamed, tuple(dict.fromkeys(partial.values()))


def _label(line: ScriptLine) -> str:
    """The phrase with which a line begins; nothing where it begins with none."""
    left = line.links[0].readings[0].left if line.links else None
    return left.name.casefold() if isinstance(left, Letter) and is_phrase(left.name) else ""


def _energy_along(line: ScriptLine, problem: Problem) -> Meaning | None:
    """The energy that a line names, of the components along the line of centres alone."""
    label = _label(line)
    if not label or _ALONG in label:
        return None
    name = f"{label} {_ALONG}"
    energy = next(iter(read_phrase(name, problem, line.scope.event)), None)
    return None if energy is None else Meaning(name, energy, name, "default")


def _with_label(line: ScriptLine, label: str) -> ScriptLine:
    """A line whose first relation begins with another label."""
    first, *others = line.links
    readings = tuple(replace(claim, left=Letter(label)) for claim in first.readings)
    return replace(line, links=(replace(first, readings=readings), *others))


def _without_along(line: ScriptLine) -> ScriptLine:
    """A line of an energy without its readings along a line."""
    first, *others = line.links
    readings = tuple(
        claim
        for claim in first.readings
        if not (isinstance(claim.left, Letter) and _ALONG in claim.left.name)
    )
    return replace(line, links=(replace(first, readings=readings or first.readings), *others))
