"""Letters whose kind is certain: t for a time that is asked, I for an impulse, v for a vector.

A value that no quantity of that kind has in the story is false, whichever of them was meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Negate,
    is_binary,
    is_function,
    is_vector,
    letters,
)
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.letters.candidates import Candidate, Kind, kinds_of, velocity
from restitution.practice.script import ANYWHERE, Claim, Link, Scope
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.world import World

_VELOCITIES: frozenset[Kind] = frozenset(("component", "speed", "velocity", "relative"))
_OF_TIME: frozenset[Kind] = frozenset(("time", "tangent"))


def asked_by_look(name: str, value: Expression, asked: Sequence[Expression]) -> Expression | None:
    """The only thing asked for that a letter can mean beside its value; None where none is sure."""
    kinds, vector = kinds_of(name, False), is_vector(value)
    if kinds[0] == "time" and name.startswith("t"):  # T may be a kinetic energy
        wanted = None if vector else "time"
    elif kinds[0] == "impulse":
        wanted = "impulse"
    elif set(kinds) == _VELOCITIES and vector:
        wanted = "velocity"
    else:
        wanted = "speed" if set(kinds) == _VELOCITIES and is_root_of_a_sum(value) else None
    own = [tree for tree in asked if wanted is not None and kind_of(tree) == wanted]
    return own[0] if len(own) == 1 else None


def has_no_such_value(
    meant: Expression,
    link: Link,
    candidates: Sequence[Candidate],
    worlds: Sequence[World],
    scope: Scope = ANYWHERE,
) -> bool:
    """Whether nothing of the kind of what is meant has the value that a relation gives it."""
    claim = link.readings[0]
    own = {letter for world in worlds for letter in world.letters}
    if claim.sign != "=" or not letters(claim.right) <= own:
        return False
    vector = is_vector(claim.right)
    return not any(
        _is_worth(tree, reading, link, world, scope)
        for quantity in _of_the_kind(meant, vector, candidates, worlds[0])
        for tree in (quantity, Negate(quantity))
        for reading in link.readings
        for world in worlds
    )


def _of_the_kind(
    meant: Expression, vector: bool, candidates: Sequence[Candidate], world: World
) -> Iterator[Expression]:
    """The quantities of the story that are of one kind with what is meant."""
    match kind_of(meant):
        case "time":
            yield from (x.quantity for x in candidates if x.kind in _OF_TIME)
        case "impulse":
            own = [x.quantity for x in candidates if x.kind == "impulse"]
            yield from own
            yield from () if vector else map(_size, own)
        case "velocity":
            vectors = (x for x in candidates if x.nature == "vector" and x.kind != "impulse")
            yield from (x.quantity for x in vectors)
            yield from _changes(world)
        case "speed":
            yield from (_size(x.quantity) for x in candidates if x.kind in ("speed", "relative"))


def _changes(world: World) -> Iterator[Expression]:
    """The changes of velocity of each body, from any moment to any other."""
    for body in world.start:
        stages = permutations(range(len(world.events) + 1), 2)
        for one, other in stages:
            yield Binary("-", velocity(body, one), velocity(body, other))


def is_root_of_a_sum(tree: Expression) -> bool:
    """Whether a tree is made as a speed is of two components: ``√(12 + 4)``."""
    return is_function(tree, "sqrt") and is_binary(tree.argument, "+")


def _size(tree: Expression) -> Expression:
    return Apply("abs", tree)


def _is_worth(tree: Expression, claim: Claim, link: Link, world: World, scope: Scope) -> bool:
    """Whether a quantity has the value that a claim gives its letter, to two figures at least."""
    try:
        return agrees(Claim(tree, "=", claim.right), world, {}, link.decimals, scope) is not None
    except RestitutionError:
        return False
