"""The worlds in which what a part asks for is greatest or least: ``d/dt = 0``, so ``t = 1/2``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression import read_expression
from restitution.expression.tree import Number, letters
from restitution.practice.script import Claim
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Extremum
from restitution.solving.equations.solution import PartSolution, Solution

# As SymPy writes them, and as the statement language does.
_NAMES = (("asin", "arcsin"), ("acos", "arccos"), ("atan", "arctan"), ("**", "^"))


def worlds_at_extremes(
    solution: Solution, solved: PartSolution, worlds: tuple[World, ...]
) -> tuple[World, ...]:
    """The worlds where each extremum that a part asks for is reached; none where that is nowhere.

    ``worlds`` are the true ones, in which values are worked out. An extremum is left out where it
    is reached at no number, or only approached.
    """
    if not worlds:
        return ()
    return tuple(
        world
        for place in _places(solved, worlds[0])
        for world in true_worlds(solution, solved, place)
    )


def speaks_of_any_value(claim: Claim, base: World, worlds: Sequence[World]) -> bool:
    """Whether a claim speaks of any value of a letter that has one in ``worlds``, at an extremum.

    A condition on it has no other letter, ``tan α = 2``, or says that something is zero.
    """
    names = letters(claim.left) | letters(claim.right)
    if Number(Fraction(0)) in (claim.left, claim.right) or len(names) < 2:
        return False
    return any(
        np.ptp(base.letters[name]) > 0 and any(np.ptp(world.letters[name]) == 0 for world in worlds)
        for name in names & base.letters.keys()
    )


def _places(solved: PartSolution, world: World) -> Iterator[dict[str, Fraction]]:
    for result in solved.items:
        for answer in result.answers if isinstance(result.item, Extremum) else ():
            values = {name: _number(text, world) for name, text in (answer.where or {}).items()}
            known = {name: value for name, value in values.items() if value is not None}
            if known and len(known) == len(values):
                yield known


def _number(text: str, world: World) -> Fraction | None:
    """A number as SymPy writes it; None where it has letters, or another form."""
    for name, usual in _NAMES:
        text = text.replace(name, usual)
    try:
        numbers = world.scalar(read_expression(text))
    except (RestitutionError, ArithmeticError):
        return None
    first = float(numbers.flat[0])
    return Fraction(first) if bool((numbers == first).all()) else None
