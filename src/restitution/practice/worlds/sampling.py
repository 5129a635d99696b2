"""The true worlds of a part: one for each of its solutions, at scattered values of its letters."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.enclosed import UndefinedError
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.world import World, stacked, world_of
from restitution.solving.algebra.numbers import FIELD, at, bound, sample
from restitution.solving.equations.solution import Branch, PartSolution, Solution
from restitution.solving.story.forward import lets_up_to
from restitution.solving.story.unknowns import Numbers

NO_VALUES: Mapping[str, Fraction] = {}
SAMPLES = 4
_TRIES = 240
# As many samples are drawn as leave a choice, and those are kept that show least by chance.
_DRAWN = 12
# Two quantities as near to each other as this are equal by chance, where they are not always.
_NEAR = 0.02
_FAILURES = (RestitutionError, UndefinedError, ArithmeticError, LookupError)


def true_worlds(
    solution: Solution,
    part: str | PartSolution | None = None,
    fixed: Mapping[str, Fraction] = NO_VALUES,
) -> tuple[World, ...]:
    """The worlds of a part, one for each of its solutions; none where it has none.

    Letters that are free take scattered values that satisfy all facts; a letter of the statement
    that has one value only has it in every sample. ``fixed`` are values for free letters, angles in
    radians; where they are impossible, so is the solution, and it is left out. Raises
    KeyError for a part that is not there.
    """
    solved = part if isinstance(part, PartSolution) else solution.parts[part]
    worlds = (_world(solution, solved, branch, fixed) for branch in solved.branches)
    return tuple(world for world in worlds if world is not None)


def _world(
    solution: Solution, solved: PartSolution, branch: Branch, fixed: Mapping[str, Fraction]
) -> World | None:
    roles = _roles(solution, solved, branch)
    free = sorted(set(roles) - set(branch.values) - set(lets_up_to(solution.problem, solved.part)))
    angles = frozenset(name for name, role in roles.items() if role.kind == "angle")
    seed = f"{solution.problem.title} {solved.part.label} {branch.number} {sorted(roles)}"
    rng = random.Random(seed)
    worlds: list[World] = []
    put = {name: FIELD.number(value) for name, value in fixed.items() if name in free}
    for picked in _draws(free, roles, branch, rng):
        values = _admitted(branch, {**picked, **put}, roles)
        if values is None:
            continue
        try:
            story = branch.tell(Numbers(values))
            worlds.append(world_of(story, solved.part, branch.number, values, angles))
        except _FAILURES:
            continue
        if len(worlds) == _DRAWN:
            break
    if not worlds and put:
        return None
    if not worlds:
        sampled = dict(branch.sample)
        masses = {name: roles[name] for name in roles if name not in sampled}
        sampled |= {name: FIELD.number(_number(role, rng)) for name, role in masses.items()}
        worlds = [world_of(branch.numbers, solved.part, branch.number, sampled, angles)]
    return replace(stacked(_telling_most(worlds)), determined=frozenset(branch.values))


def _roles(solution: Solution, solved: PartSolution, branch: Branch) -> Mapping[str, Role]:
    """What each letter, each hidden unknown and each mass of which nothing is known may be."""
    roles = dict.fromkeys(branch.sample, REAL) | dict(solved.roles)
    if branch.oracle is not None:
        roles = {**roles, **{name: branch.oracle.roles[name] for name in branch.oracle.roles}}
    for sphere in solution.problem.spheres:
        if sphere.mass is None:
            roles.setdefault(f"_m_{sphere.name}", POSITIVE)
    return roles


# --- drawing --------------------------------------------------------------------------------------


def _draws(
    free: Sequence[str], roles: Mapping[str, Role], branch: Branch, rng: random.Random
) -> Iterator[dict[str, Any]]:
    """Values for the free letters: scattered ones, then others that letters may have.

    The last are near those by which the solution was found.
    """
    if not free:
        for _ in range(SAMPLES):
            yield {}
        return
    for _ in range(_TRIES):
        yield {name: FIELD.number(_number(roles[name], rng)) for name in free}
    for _ in range(_TRIES):
        yield sample(free, roles, rng)
    for share in (0.3, 0.1, 0.03, 0.01):
        for _ in range(_TRIES // 4):
            yield {
                name: branch.sample[name] * FIELD.number(_few(1 + rng.uniform(-share, share)))
                if name in branch.sample
                else FIELD.number(_number(roles[name], rng))
                for name in free
            }


def _few(x: float) -> Fraction:
    """A number of a few figures: exact ones cost time."""
    return Fraction(round(x * 10**7), 10**7)


def _number(role: Role, rng: random.Random) -> Fraction:
    """A scattered value: 0.7 to 4; of a coefficient 0.1 to 0.95, of an angle 9° to 80°."""
    low, high = (None if end is None else float(end) for end in (bound(role.low), bound(role.high)))
    if role.kind == "restitution":
        usual = (0.1, 0.95)
    elif role.kind == "angle":
        usual = (math.radians(9), math.radians(80))
    else:
        usual = (0.7, 4.0)
    if role.kind == "real" and low is None and high is None:
        return _few(rng.choice((-1, 1)) * rng.uniform(*usual))
    start = usual[0] if low is None else max(low, usual[0])
    end = usual[1] if high is None else min(high, usual[1])
    if start >= end:  # an end beyond what is usual
        if low is not None and high is not None:
            start, end = low + 0.1 * (high - low), high - 0.1 * (high - low)
        elif low is not None:
            start, end = low + 0.3, low + 3
        else:
            start, end = end - 3, end - 0.3
    return _few(rng.uniform(start, end))


def _admitted(
    branch: Branch, picked: Mapping[str, Any], roles: Mapping[str, Role]
) -> dict[str, Any] | None:
    """All values with those of the free letters; None where they are impossible."""
    values: dict[str, Any] = dict(picked)
    try:
        for name, value in branch.values.items():
            values[name] = at(value, values)
            positive = name.startswith("_") and name in roles and roles[name].kind == "positive"
            if positive and not float(values[name]) > 0:
                return None
        return None if branch.objection(values) is not None else values
    except _FAILURES:
        return None


# --- choosing -------------------------------------------------------------------------------------


def _telling_most(worlds: Sequence[World]) -> list[World]:
    """The samples with the fewest coincidences of quantities that differ in general."""
    tables = np.array([_sizes(world) for world in worlds])
    if len(worlds) == 1 or tables.ndim != 2 or tables.shape[1] < 2:
        return [worlds[k % len(worlds)] for k in range(SAMPLES)]
    first, second = np.array(list(combinations(range(tables.shape[1]), 2))).T
    a, b = tables[:, first], tables[:, second]
    near = np.abs(a - b) <= _NEAR * np.maximum(np.maximum(a, b), 1e-9)
    chance = (near & ~near.all(axis=0)).sum(axis=1)
    order = np.argsort(chance, kind="stable")
    return [worlds[order[k % len(worlds)]] for k in range(SAMPLES)]


def _sizes(world: World) -> list[float]:
    """The sizes of what a student could take for one another: components, speeds, masses, e."""
    telling = Telling(world)
    sizes: list[float] = []
    for number, line in world.lines.items():
        happening = telling.happenings[number - 1]
        for name in happening.before:
            for v in (happening.before[name], happening.after[name]):
                sizes += [abs(v.dot(line)), abs(v.cross(line)), float(np.hypot(v.x, v.y))]
    masses = [telling.mass(name) for name in telling.spheres]
    numbers = [*masses, *world.letters.values()]
    return [float(np.ravel(x)[0]) for x in (*sizes, *numbers)]
