"""Which component a letter is, as a vector shows in which its value stands again.

Behind ``p = 1.5`` the line ``velocity of A = 1.5i + j`` says that p is the component of A along i,
whether it is right or wrong. So does ``velocity of A = p i + q j``, of both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from collections.abc import Set as AbstractSet

import numpy as np

from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Pair,
    Quantity,
    Unit,
    is_quantity,
    letters,
    unsigned,
)
from restitution.practice.letters.candidates import Candidate
from restitution.practice.letters.trial import NOWHERE, Frame, Tester
from restitution.practice.script import Claim, Scope, ScriptLine
from restitution.practice.worlds.arrays import Array
from restitution.problem import Impact, Problem
from restitution.records import dataclass
from restitution.vector import Vector

# A number may stand in the vector with fewer figures.
_CLOSE = 6e-3
_TINY = 1e-9


@dataclass(frozen=True)
class NamedComponent:
    """A letter whose value is, in a line with a velocity, that of a component of it."""

    line: ScriptLine
    letter: str
    component: Expression


def named_components(
    lines: Iterable[ScriptLine],
    problem: Problem,
    tester: Tester,
    usual: Callable[[str, Scope], Candidate | None],
    is_open: Callable[[str], bool],
) -> Iterator[NamedComponent]:
    """The letters whose values stand again in a velocity, along the line of centres or the wall.

    ``usual`` is what a letter or phrase means where no line tells, ``is_open`` whether a name is a
    letter of the student's own.
    """
    values: dict[str, list[Array]] = {}
    for line in lines:
        for link in line.links:
            claim = link.readings[0]
            if claim.sign != "=" or claim.others or not isinstance(claim.left, Letter):
                continue
            name = claim.left.name
            yield from _lettered(line, claim.right, usual(name, line.scope), is_open)
            value = tester.value(claim.right, {}, NOWHERE) if not _own(claim, tester) else None
            if isinstance(value, Vector):
                meant = usual(name, line.scope)
                for axis, size in zip((Unit("i"), Unit("j")), (value.x, value.y), strict=True):
                    component = None if meant is None else _component(meant, axis, problem)
                    alike = [x for x, known in values.items() if any(_is(size, k) for k in known)]
                    if component is not None and len(alike) == 1:
                        yield NamedComponent(line, alike[0], component)
            elif value is not None and not isinstance(value, Angle) and is_open(name):
                values.setdefault(name, []).append(np.asarray(value, dtype=float))


def _lettered(
    line: ScriptLine,
    vector: Expression,
    meant: Candidate | None,
    is_open: Callable[[str], bool],
) -> Iterator[NamedComponent]:
    """The letters of which a velocity is made: ``v = x i - y j``, ``v = (x, y)``."""
    match meant:
        case Candidate(quantity=Quantity("velocity") as velocity):
            pass
        case _:
            return
    for component, axis in _parts(vector):
        inner = unsigned(component)
        along: Expression = Quantity("along", (velocity, axis))
        match inner:
            case Binary("*", Letter(name) as letter, Letter() as unit) if is_open(name):
                if not is_open(unit.name):
                    inner, along = letter, Binary("/", along, unit)  # v = x u i + y u j
            case _:
                pass
        if isinstance(inner, Letter) and is_open(inner.name):
            value = Negate(along) if isinstance(component, Negate) else along
            yield NamedComponent(line, inner.name, value)


def _parts(vector: Expression) -> Iterator[tuple[Expression, Unit]]:
    """The components of a vector as typed, each with its axis."""
    match vector:
        case Pair(x, y):
            yield from ((x, Unit("i")), (y, Unit("j")))
        case Binary("+", left, right):
            yield from (*_parts(left), *_parts(right))
        case Binary("-", left, right):
            yield from (*_parts(left), *((Negate(size), axis) for size, axis in _parts(right)))
        case Negate(operand):
            yield from ((Negate(size), axis) for size, axis in _parts(operand))
        case Binary("*", size, Unit() as axis) | Binary("*", Unit() as axis, size):
            yield size, axis


def vector_letters(
    claim: Claim,
    names: AbstractSet[str],
    tester: Tester,
    frame: Frame,
    known: AbstractSet[str] = frozenset(),
) -> Iterator[str]:
    """The letters that a claim makes vectors: ``I = 2(v - 3i + 5j)``, ``v = x i + y j``.

    ``names`` are those whose meanings are open, ``known`` those of them that are vectors. Of
    several that is one alone on its side.
    """
    samples = tester.world.samples
    number, vector = np.ones(samples), Vector(np.ones(samples), 2 * np.ones(samples))
    sides = claim.left, claim.right
    alone = {side.name for side in sides if isinstance(side, Letter)}
    for name in names if len(names) == 1 else names & alone:
        others = {other: vector if other in known else number for other in names - {name}}
        as_number, as_vector = (
            [
                isinstance(tester.value(side, {**others, name: value}, frame), Vector)
                for side in sides
            ]
            for value in (number, vector)
        )
        if claim.sign == "=" and all(as_vector) and not all(as_number):
            yield name


def _own(claim: Claim, tester: Tester) -> bool:
    """Whether letters of the student's own stand on the right side of a claim."""
    return not letters(claim.right) <= tester.world.letters.keys()


def _is(size: object, value: Array) -> bool:
    """Whether a component has a value, which is not zero."""
    numbers = np.asarray(size, dtype=float)
    near = np.abs(numbers - value) <= _CLOSE * np.abs(value)
    return bool(np.all(near) and np.all(np.abs(value) > _TINY))


def _component(meant: Candidate, axis: Unit, problem: Problem) -> Expression | None:
    """The component of a velocity along i or j, where an impact may change it.

    None of a story with several events: a vector may be of any of them.
    """
    if len(problem.events) > 1:
        return None
    velocity = meant.quantity
    if not is_quantity(velocity, "velocity"):
        return None
    (body,) = velocity.arguments
    assert isinstance(body, Name)
    walls = {wall.name for wall in problem.walls}
    impacts = [
        event
        for event in problem.events
        if isinstance(event, Impact) and body.name in (event.first, event.second)
    ]
    free = any(impact.second in walls or impact.along in (None, axis) for impact in impacts)
    return Quantity("along", (velocity, axis)) if free else None
