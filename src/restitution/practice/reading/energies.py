"""Energies behind a label that says only when: ``before 0.5*3*16 + 0.5*2*9 = 33``.

A sum whose terms are half a product is a kinetic energy: of all, of one sphere, or of the
components along the line of centres alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    is_binary,
    letters,
    line_and_column,
    terms_of,
    walk,
)
from restitution.practice.reading.tokens import Usage
from restitution.practice.script import Claim, Link, Scope
from restitution.problem import Impact, Problem

_HALF = Fraction(1, 2)


def energy_links(
    links: tuple[Link, ...],
    values: tuple[Expression, ...],
    scope: Scope,
    usage: Usage,
    problem: Problem,
    *,
    known: bool = False,
) -> tuple[Link, ...]:
    """The relations of a line under *before* or *after*: its energy is that of the stage.

    It is ``known`` of some lines that they are energies, whatever they look like.
    """
    if scope.stage is None or (links and values):
        return links
    first = links[0].readings[0] if links else None
    if first is None and len(values) != 1:
        return links
    energy = values[0] if first is None else first.left
    if not known and (not _is_energy(energy) or not letters(energy) <= usage.letters):
        return links
    if not known and (_may_be_a_component(energy, problem) or not _has_squares(energy, problem)):
        return links
    readings = tuple(Claim(name, "=", energy) for name in _names(scope, problem))
    if not links:
        return (Link(readings, 1, 1),)
    columns = {line_and_column(node.place)[1] for node in walk(energy) if isinstance(node, Number)}
    decimals = tuple(decimal for decimal in links[0].decimals if decimal.column in columns)
    return (Link(readings, links[0].start, links[0].end, decimals), *links)


def _has_squares(energy: Expression, problem: Problem) -> bool:
    """Whether every term has a square in it, unless its letters are masses."""
    if is_binary(energy, "+", "-"):
        return _has_squares(energy.left, problem) and _has_squares(energy.right, problem)
    masses = {"m", "M"}.union(
        *(letters(x.mass) for x in problem.spheres if isinstance(x.mass, Expression))
    )
    squared = any(is_binary(node, "^") for node in walk(energy))
    return squared or letters(energy) <= masses


def _may_be_a_component(energy: Expression, problem: Problem) -> bool:
    """Whether the half is a coefficient of the question, and no speed is squared: 0.5 × 2√5."""
    if is_binary(energy, "+", "-"):
        return False
    squared = any(is_binary(factor, "^") for factor in _factors(energy))
    halves = {
        event.e for event in problem.events if isinstance(event, Impact) and event.e is not None
    }
    return not squared and any(_is_half(tree) for tree in halves)


def _is_half(tree: Expression) -> bool:
    match tree:
        case Binary("/", Number(above), Number(below)):
            return below != 0 and above / below == _HALF
    return tree == Number(_HALF)


def _names(scope: Scope, problem: Problem) -> Iterator[Letter]:
    """The phrases for an energy of which a label says only when, the most natural first."""
    spheres = [sphere.name for sphere in problem.spheres]
    owners = [scope.body] if scope.body else [None, *(spheres if len(spheres) > 1 else ())]
    for direction in ("", " along line of centres"):
        for owner in owners:
            of = f" of {owner}" if owner else ""
            yield Letter(f"KE{of}{direction} {scope.stage}")


def _is_energy(tree: Expression) -> bool:
    """Whether every term is half a product, one of two factors at least: a mass may be 1."""
    factors = [list(_factors(term)) for term in terms_of(tree)]
    squares = [sum(is_binary(factor, "^") for factor in term) for term in factors]
    halved = all(term.count(Number(_HALF)) == 1 and len(term) > 1 for term in factors)
    whole = (len(term) + more > 2 for term, more in zip(factors, squares, strict=True))
    return halved and any(whole)


def _factors(tree: Expression) -> Iterator[Expression]:
    """The factors of a product; division by 2 is a factor of a half."""
    match tree:
        case Binary("*", left, right):
            yield from _factors(left)
            yield from _factors(right)
        case Binary("/", left, Number(value)) if value == 2:
            if left != Number(Fraction(1)):
                yield from _factors(left)
            yield Number(_HALF)
        case _:
            yield tree
