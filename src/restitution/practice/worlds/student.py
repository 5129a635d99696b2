"""The student's own world: the values at which the lines of a script hold.

Unknown are the velocities after each event, and the letters that the part has to find. The lines
of the student come first, then the laws and the facts that they leave standing. Of these equations,
in this order, each is kept that is independent of those before it, so that none is contradicted;
they are solved by Gauss-Newton from the true values, in every sample.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.tree import has_quantity
from restitution.practice.judging.entries import Entry, is_of_a_journey
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import as_vector, difference
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.timing import retimed
from restitution.practice.worlds.world import World
from restitution.problem import Aligned, AtRest, Compare, Given, Impact, Kick, Relation
from restitution.records import dataclass
from restitution.vector import Vector

Array = Any
Residual = Callable[[World], Array]

_STEPS = 14
_LINES = 24
_CHOOSING = 3
"""In so many steps the equations are chosen anew; after that they stay."""
_INDEPENDENT = 1e-5
_SMALL = 1e-6
# So far from the true values equations are that cannot hold: ``4.8 cos θ = 5.07``.
_FAR = 1e3
_NEAR = 1e-9


@dataclass(frozen=True)
class SampledEquation:
    """An equation by its residual in a world, shape (samples, equations)."""

    residual: Residual
    law: str | None = None
    event: int | None = None
    bodies: tuple[str, ...] = ()


def student_world(
    base: World,
    entries: Sequence[Entry],
    unknown: Collection[str] = (),
    *,
    latest: bool = True,
    broken: Collection[tuple[str, int | None]] = (),
    laws_first: bool = False,
) -> World | None:
    """The world in which the lines of a student hold, as far as they hold together.

    ``unknown`` are the letters of the statement that the part has to find. Where lines clash those
    that are not true win, of these the ``latest`` or the first.
    Laws that are ``broken``, each at an event, do not hold beside them. Where facts of the question
    and laws clash, the facts win, unless ``laws_first``. None where there are no such values.
    """
    order = list(reversed(entries)) if latest else list(entries)
    own = [entry for entry in order if not entry.right] + [entry for entry in order if entry.right]
    own = own[:_LINES]
    equations = [
        _of_entry(entry) for entry in own if entry.claim.sign == "=" and not entry.claim.others
    ]
    laws = [law for law in laws_of(base) if (law.law, law.event) not in broken]
    facts = list(facts_of(base))
    rest = [*facts, *laws]
    if laws_first:
        moving = [fact for fact in facts if fact.law]
        rest = [*(fact for fact in facts if not fact.law), *laws, *moving]
    timed = any(map(is_of_a_journey, own))
    return _solved(base, [*equations, *rest], unknown, timed=timed)


def world_of_lines(base: World, entries: Sequence[Entry], unknown: Collection[str]) -> World | None:
    """A world in which lines hold and no law but that components across lines of centres stay.

    Nobody writes for a sphere that was at rest that its speed is its component.
    """
    equations = [_of_entry(entry) for entry in entries if entry.claim.sign == "="]
    smooth = [law for law in laws_of(base) if law.law == "unchanged"] if equations else []
    return _solved(scattered_world(base, unknown), [*equations, *smooth], unknown)


def world_without(
    base: World,
    entries: Sequence[Entry],
    broken: Collection[tuple[str, int | None]],
    unknown: Collection[str],
) -> World | None:
    """A world of scattered values in which lines, facts and all laws but the broken ones hold."""
    lines = [_of_entry(entry) for entry in entries if entry.claim.sign == "="]
    laws = [law for law in laws_of(base) if (law.law, law.event) not in broken]
    return _solved(scattered_world(base, unknown), [*lines, *facts_of(base), *laws], unknown)


def lawful_world(
    base: World, kept: Collection[tuple[str, int, tuple[str, ...]]], unknown: Collection[str]
) -> World | None:
    """A world of scattered values in which the facts and the kept laws hold.

    Laws are named with their event and bodies.
    """
    laws = (law for law in laws_of(base) if (law.law, law.event, law.bodies) in kept)
    return _solved(scattered_world(base, unknown), [*facts_of(base), *laws], unknown)


def told_world(base: World, unknown: Collection[str]) -> World | None:
    """A world of other unknown letters, in which every law holds, whatever the question states."""
    return _solved(scattered_world(base, unknown), list(laws_of(base)), unknown)


def smooth_world(base: World, unknown: Collection[str]) -> World | None:
    """A world of scattered values in which components across lines of centres do not change."""
    laws = (law for law in laws_of(base) if law.law == "unchanged")
    return _solved(scattered_world(base, unknown), list(laws), unknown)


def altered_world(base: World, variant: VariantAt, unknown: Collection[str] = ()) -> World | None:
    """The world in which a variant of a mistake stands in place of the laws that it replaces."""
    altered = [_of_claim(Claim(law.sides[0], "=", law.sides[1])) for law in variant.laws]
    replaced = {(law.law, variant.event.number, law.bodies) for law in variant.laws}
    laws = [
        other
        for other in laws_of(base)
        if not any(
            (other.law, other.event) == (law, event) and set(other.bodies) <= set(bodies)
            for law, event, bodies in replaced
        )
    ]
    return _solved(base, [*altered, *facts_of(base), *laws], unknown)


# --- equations --------------------------------------------------------------------------------


def _of_entry(entry: Entry) -> SampledEquation:
    return SampledEquation(
        lambda world: difference(entry.claim, world, entry.meanings, entry.scope)[0]
    )


def _of_claim(claim: Claim) -> SampledEquation:
    return SampledEquation(lambda world: difference(claim, world)[0])


def laws_of(world: World) -> Iterator[SampledEquation]:
    """The laws of every impact and blow: momentum, restitution, components that do not change."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and number in world.lines:
            wall = step.second in world.walls or step.second not in world.start
            spheres = (step.first,) if wall else (step.first, step.second)
            for body in spheres:
                yield SampledEquation(_unchanged(number, body), "unchanged", number, (body,))
            yield SampledEquation(_restitution(number, spheres), "restitution", number, spheres)
            if not wall:
                yield SampledEquation(_momentum(number, spheres), "momentum", number, spheres)
        elif isinstance(step, Kick):
            yield SampledEquation(_blow(number, step), "blow", number, (step.body,))


def _parts(world: World, number: int, body: str) -> tuple[Vector, Vector, Vector]:
    telling = Telling(world)
    return telling.velocity(body, number - 1), telling.velocity(body, number), world.lines[number]


def _unchanged(number: int, body: str) -> Residual:
    def residual(world: World) -> Array:
        before, after, c = _parts(world, number, body)
        return _column(world, (after - before).cross(c))

    return residual


def _momentum(number: int, bodies: tuple[str, ...]) -> Residual:
    def residual(world: World) -> Array:
        telling, total = Telling(world), 0.0
        for body in bodies:
            before, after, c = _parts(world, number, body)
            total = total + telling.mass(body) * (after - before).dot(c)
        return _column(world, total)

    return residual


def _restitution(number: int, bodies: tuple[str, ...]) -> Residual:
    def residual(world: World) -> Array:
        before, after, c = _parts(world, number, bodies[0])
        if len(bodies) == 2:
            other_before, other_after, _ = _parts(world, number, bodies[1])
            before, after = before - other_before, after - other_after
        return _column(world, after.dot(c) + Telling(world).coefficient(number) * before.dot(c))

    return residual


def _blow(number: int, step: Kick) -> Residual:
    def residual(world: World) -> Array:
        telling = Telling(world, degrees=False)
        change = telling.velocity(step.body, number) - telling.velocity(step.body, number - 1)
        apart = change * telling.mass(step.body) - telling.read(step.impulse, number - 1)
        return np.stack([world.spread(apart.x), world.spread(apart.y)], axis=1)

    return residual


def facts_of(world: World) -> Iterator[SampledEquation]:
    """The equations that the statement gives for this part; of the motion, or of letters alone."""
    for step, now, _ in world.problem.timeline(world.part):
        if isinstance(step, Given):
            for relation in step.relations:
                residual = _fact(relation, now)
                if residual is not None:
                    moving = not isinstance(relation, Compare) or any(
                        map(has_quantity, relation.operands)
                    )
                    yield SampledEquation(residual, "motion" if moving else None)


def _fact(relation: Relation, now: int) -> Residual | None:
    if isinstance(relation, AtRest):
        name = relation.body.name

        def at_rest(world: World) -> Array:
            v = Telling(world).velocity(name, now)
            return np.stack([world.spread(v.x), world.spread(v.y)], axis=1)

        return at_rest
    if isinstance(relation, Aligned):
        across = relation.relation == "perpendicular to"

        def aligned(world: World) -> Array:
            telling = Telling(world, degrees=False)
            a, b = telling.direction(relation.left, now), telling.direction(relation.right, now)
            return _column(world, a.dot(b) if across else a.cross(b))

        return aligned
    if isinstance(relation, Compare) and set(relation.operators) == {"="}:
        left, right = relation.operands[:2]

        def equal(world: World) -> Array:
            a = world.value(left, now=now, degrees=False)
            b = world.value(right, now=now, degrees=False)
            if isinstance(a, Vector) or isinstance(b, Vector):
                apart = as_vector(a) - as_vector(b)
                return np.stack([world.spread(apart.x), world.spread(apart.y)], axis=1)
            return _column(world, _plain(a) - _plain(b))

        return equal
    return None


def _plain(value: Any) -> Array:
    return value.measure() if hasattr(value, "measure") else value


def _column(world: World, value: Array) -> Array:
    return world.spread(value)[:, None]


# --- solving ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Unknowns:
    """The unknowns of a world as columns: components after events, then letters."""

    stages: tuple[tuple[int, str], ...]
    starts: tuple[str, ...]
    names: tuple[str, ...]

    def values(self, world: World) -> Array:
        columns = [world.spread(part) for key in self.stages for part in world.after[key]]
        columns += [world.spread(part) for name in self.starts for part in world.start[name]]
        columns += [world.spread(world.letters[name]) for name in self.names]
        return np.stack(columns, axis=1)

    def put(self, world: World, x: Array) -> World:
        after = {
            key: Vector(x[:, 2 * place], x[:, 2 * place + 1])
            for place, key in enumerate(self.stages)
        }
        first = 2 * len(self.stages)
        start = {
            name: Vector(x[:, first + 2 * place], x[:, first + 2 * place + 1])
            for place, name in enumerate(self.starts)
        }
        first += 2 * len(self.starts)
        letters = {name: x[:, first + place] for place, name in enumerate(self.names)}
        moved = world.replaced(after=after, letters=letters)
        return replace(moved, start={**moved.start, **start}) if start else moved


def _unknowns(world: World, unknown: Collection[str]) -> _Unknowns:
    names = tuple(sorted(name for name in unknown if name in world.letters))
    starts = tuple(sphere.name for sphere in world.problem.spheres if sphere.velocity is None)
    return _Unknowns(tuple(world.after), starts, names)


def scattered_world(world: World, unknown: Collection[str]) -> World:
    """The world with other values after its events, by up to a third, and of its unknowns."""
    kinds = _unknowns(world, unknown)
    x = kinds.values(world)
    rng = np.random.default_rng(7)
    return kinds.put(world, x * rng.uniform(0.7, 1.3, x.shape) + rng.uniform(-0.1, 0.1, x.shape))


def _solved(
    base: World,
    equations: Sequence[SampledEquation],
    unknown: Collection[str],
    *,
    timed: bool = False,
) -> World | None:
    """The world in which equations hold; with ``timed`` its velocities tell its times too."""
    kinds = _unknowns(base, unknown)
    if not kinds.stages and not kinds.names:
        return base
    x = kinds.values(base)
    chosen: list[int] = []
    world = base
    for step in range(_STEPS):
        values, slopes = _linearized(base, kinds, x, equations, timed=timed)
        if values.shape[1] == 0:
            return world
        if step < _CHOOSING or not chosen:
            chosen = _independent(slopes)
        if not chosen:
            return world
        r, g = values[:, chosen], slopes[:, chosen]
        size = np.linalg.norm(g, axis=2)
        size = np.where(size > 0, size, 1.0)
        move = np.einsum("sij,sj->si", np.linalg.pinv(g / size[..., None], rcond=1e-10), r / size)
        if not np.all(np.isfinite(move)):
            return None
        x = x - move
        world = _put(kinds, base, x, timed)
        if step >= _CHOOSING - 1 and np.max(np.abs(move)) < _NEAR * (1 + np.max(np.abs(x))):
            break
    start = kinds.values(base)
    lost = not np.all(np.isfinite(x)) or np.max(np.abs(x)) > _FAR * (1 + np.max(np.abs(start)))
    return None if lost else retimed(world, base)


def _put(kinds: _Unknowns, base: World, x: Array, timed: bool) -> World:
    world = kinds.put(base, x)
    return retimed(world, base) if timed else world


def _linearized(
    base: World,
    kinds: _Unknowns,
    x: Array,
    equations: Sequence[SampledEquation],
    *,
    timed: bool,
) -> tuple[Array, Array]:
    """Residuals (samples, equations) and their slopes (samples, equations, unknowns).

    Equations without a value in every sample are left out, with zeros for their slopes.
    """
    samples, count = x.shape
    steps = _SMALL * (1 + np.abs(x))
    blocks = [x] + [x + steps * np.eye(count)[k] for k in range(count)]
    world = _put(kinds, base.repeated(count + 1), np.concatenate(blocks), timed)
    values: list[Array] = []
    slopes: list[Array] = []
    with np.errstate(all="ignore"):
        for equation in equations:
            try:
                residuals = equation.residual(world)
            except RestitutionError:
                continue
            residuals = np.reshape(residuals, (count + 1, samples, -1))
            slope = (residuals[1:] - residuals[0]) / steps.T[..., None]
            if not np.all(np.isfinite(residuals)):
                residuals, slope = np.zeros_like(residuals), np.zeros_like(slope)
            values.append(residuals[0])
            slopes.append(np.transpose(slope, (1, 2, 0)))
    if not values:
        return np.zeros((samples, 0)), np.zeros((samples, 0, count))
    return np.concatenate(values, axis=1), np.concatenate(slopes, axis=1)


def _independent(slopes: Array) -> list[int]:
    """The equations of which none depends on those before it, in any sample."""
    samples, count, unknowns = slopes.shape
    basis = np.zeros((samples, 0, unknowns))
    chosen: list[int] = []
    for place in range(count):
        g = slopes[:, place]
        size = np.linalg.norm(g, axis=1)
        if not np.all(size > 1e-9):
            continue
        g = g / size[:, None]
        for _ in range(2):
            g = g - np.einsum("skj,sk->sj", basis, np.einsum("skj,sj->sk", basis, g))
        left = np.linalg.norm(g, axis=1)
        if np.all(left > _INDEPENDENT):
            basis = np.concatenate([basis, (g / left[:, None])[:, None]], axis=1)
            chosen.append(place)
        if len(chosen) == unknowns:
            break
    return chosen
