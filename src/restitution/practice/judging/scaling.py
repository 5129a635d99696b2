"""Letters of the question to which a script gives a size by a vector: ``before: i - 2j``.

Where the question leaves a speed open, as the u of *velocity u at α*, people put numbers for the
velocity that have the right direction, and so take u = √5.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import Expression, Letter, Name, Quantity, letters
from restitution.practice.judging.bench import Bench
from restitution.practice.letters.surroundings import rational_value
from restitution.practice.reading.grammar import is_vector
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.script import Script
from restitution.practice.worlds.world import World
from restitution.vector import Vector

_CLOSE = 1e-9


def sizes_taken(script: Script, bench: Bench) -> dict[str, Fraction]:
    """The letters of the question that a script gives a size, each with the first one."""
    sizes: dict[str, Fraction] = {}
    if not bench.worlds:
        return sizes
    world = bench.worlds[0]
    open_letters = {
        name
        for name, value in world.letters.items()
        if name not in world.determined and np.ptp(world.spread(value)) > 0
    }
    for name, tree in _numbers_typed(script, bench, open_letters):
        with suppress(RestitutionError):
            for letter, size in _taken(name, tree, world, open_letters):
                sizes.setdefault(letter, size)
    return sizes


def _numbers_typed(
    script: Script, bench: Bench, open_letters: set[str]
) -> Iterator[tuple[str, Expression]]:
    """The letters of the question, and the bodies' velocities before, that get plain numbers."""
    spheres = [sphere.name for sphere in bench.problem.spheres]
    for line in script.lines:
        for declaration in line.declarations:
            for tree in declaration.meanings[:1]:
                plain = rational_value(tree) is not None or letters(tree)
                if declaration.letter in open_letters and not plain:
                    yield declaration.letter, tree
        for link in line.links:
            claim = link.readings[0]
            if claim.sign != "=" or not isinstance(claim.left, Letter) or letters(claim.right):
                continue
            name = claim.left.name
            if name in open_letters and is_vector(claim.right, frozenset()):
                yield name, claim.right  # a number alone may be what is worked out
            elif is_phrase(name):
                meant = next(iter(read_phrase(name, bench.problem, line.scope.event)), None)
                for body in spheres:
                    if meant == Quantity("velocity", (Name(body),), 0):
                        yield body, claim.right


def _taken(
    name: str, tree: Expression, world: World, open_letters: set[str]
) -> Iterator[tuple[str, Fraction]]:
    """What a number or a vector for a letter, or for a body's velocity, makes of the letters."""
    value = world.value(tree)
    if not isinstance(value, Vector):
        if name in open_letters:
            yield name, _fraction(world.scalar(tree))
        return
    bodies = [name] if name in world.start else list(world.start)
    for body in bodies:
        velocity = world.value(Quantity("velocity", (Name(body),), 0))
        if not isinstance(velocity, Vector):
            continue
        size = np.hypot(_array(value.x), _array(value.y))
        speed = np.hypot(_array(velocity.x), _array(velocity.y))
        turned = _array(value.x) * velocity.y - _array(value.y) * velocity.x
        ahead = _array(value.x) * velocity.x + _array(value.y) * velocity.y
        if np.any(np.abs(turned) > _CLOSE * size * speed) or np.any(ahead <= 0):
            continue
        for letter in [name] if name in open_letters else sorted(open_letters):
            multiple = speed / world.spread(world.letters[letter])
            alike = np.ptp(multiple) <= _CLOSE * np.max(multiple)
            if alike and (letter != name or np.allclose(multiple, 1)):
                yield letter, _fraction(size / multiple)


def _array(value: object) -> np.ndarray:
    return np.asarray(value, dtype=float)


def _fraction(values: object) -> Fraction:
    """A number that is the same in all samples."""
    return Fraction(float(np.ravel(_array(values))[0]))
