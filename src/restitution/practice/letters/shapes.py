"""Letters of two laws that are both wrong, known by the shapes of the laws alone.

``2·6 - 3 = 2p + q`` above ``q - p = ⅓(6 - 3)`` has the masses before p and q, and their difference
where Newton's law has that of separation: p and q are the components of the first body and of the
second, whatever the numbers are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    letters,
)
from restitution.practice.letters.inference import linear_coefficients
from restitution.practice.letters.trial import Frame, Tester
from restitution.practice.script import Claim, Scope
from restitution.practice.worlds.arrays import Array
from restitution.problem import Event, Impact
from restitution.records import dataclass

_SAME = 1e-3


@dataclass(frozen=True)
class EquationInLetters:
    """An equation of a script in two letters of unknown meaning, and where it stands."""

    claim: Claim
    names: tuple[str, str]
    scope: Scope
    frame: Frame


def components_by_shape(
    equations: Iterable[EquationInLetters], events: Iterable[Event], tester: Tester
) -> dict[str, Expression]:
    """The components along the line of centres that letters are by the shapes of two laws."""
    numbered = tuple(enumerate(events, 1))
    momenta: dict[tuple[str, str], int] = {}
    separations: dict[tuple[str, str], tuple[str, str]] = {}
    for equation in equations:
        coefficients = linear_coefficients(equation.claim, equation.names, tester, equation.frame)
        if coefficients is None:
            continue
        a, b, _ = coefficients
        if np.all(np.abs(a + b) < _SAME * np.abs(a)):
            separations.setdefault(equation.names, _in_order(equation, a))
        for number, masses in _masses(numbered, equation.scope, tester):
            if _are_in_ratio(a, b, *masses):
                momenta.setdefault(equation.names, number)
    known: dict[str, Expression] = {}
    for names in momenta.keys() & separations.keys():
        number = momenta[names]
        event = dict(numbered)[number]
        assert isinstance(event, Impact)
        for letter, body in zip(separations[names], (event.first, event.second), strict=True):
            velocity = Quantity("velocity", (Name(body),), number)
            line = Quantity("line_of_centres", (), number)
            known.setdefault(letter, Quantity("along", (velocity, line)))
    return known


def is_of_squares(claim: Claim, name: str) -> bool:
    """Whether a letter is given as the root of a sum, or its square as a sum."""
    match claim:
        case Claim(Letter(own), "=", Apply("sqrt", Binary("+"))):
            return own == name
        case Claim(Letter(own), "=", Binary("*", Apply("sqrt", Binary("+")), Letter())):
            return own == name
        case Claim(Binary("^", Letter(own), Number(power)), "=", Binary("+")):
            return own == name and power == 2
    return False


def _in_order(equation: EquationInLetters, a: Array) -> tuple[str, str]:
    """The letters of a difference, the one that is taken away first: p and q of ``q - p``."""
    first, second = equation.names
    on_the_right = not letters(equation.claim.left) & {first, second}
    positive = bool(np.all(a > 0)) != on_the_right
    return (second, first) if positive else (first, second)


def _masses(
    numbered: Iterable[tuple[int, Event]], scope: Scope, tester: Tester
) -> Iterator[tuple[int, tuple[Array, Array]]]:
    """The masses of the spheres that meet in the only impact of two, or in that of a heading."""
    spheres = {sphere.name for sphere in tester.world.problem.spheres}
    pairs = [
        (number, event)
        for number, event in numbered
        if isinstance(event, Impact) and event.second in spheres
    ]
    if scope.event is not None:
        pairs = [pair for pair in pairs if pair[0] == scope.event]
    if len(pairs) != 1:
        return
    number, event = pairs[0]
    try:
        first, second = (
            tester.world.scalar(Quantity("mass", (Name(body),)))
            for body in (event.first, event.second)
        )
    except RestitutionError:
        return
    yield number, (np.asarray(first), np.asarray(second))


def _are_in_ratio(a: Array, b: Array, first: Array, second: Array) -> bool:
    """Whether coefficients are the masses, in whichever order."""
    return any(
        bool(np.all(np.abs(a * one - b * other) <= _SAME * np.abs(a * one)))
        for one, other in ((first, second), (second, first))
    )
