"""Random states after an event in which some laws hold, or an altered one, and all else is loose.

The states of an event keep what was before it, and the letters. Each block of samples obeys one
set of laws; a line that holds in a block is a consequence of these laws and of nothing else.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import chain, combinations
from typing import Any

import numpy as np

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.misconceptions import LawAt, VariantAt, variants_at
from restitution.expression.tree import Number, Quantity, is_quantity
from restitution.practice.script import Claim, Scope
from restitution.practice.worlds.agreement import difference
from restitution.practice.worlds.arrays import Array, UnvaluedError
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.world import World
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Event,
    Given,
    Impact,
    Kick,
    Relation,
)
from restitution.records import dataclass
from restitution.vector import Vector

# The share by which components are scattered, and the samples of a block for one of the world.
_SCATTER = 0.3
_COPIES = 2
_STEP = 1e-3
# In place of a component: the speed, with its direction kept.
_ALL = 2
_TURNS = 8
_CLOSE = 1e-9

Parts = Mapping[str, tuple[Array, Array]]
"""By sphere, its components along the line of centres and across it, after an event."""


@dataclass(frozen=True, eq=False)
class Block:
    """States after an event in which some laws hold.

    ``laws`` are names of laws, each with its bodies. In a block of an altered law these are none,
    and ``variant`` and ``law`` tell which it is; in one of a fact ``given`` is True. ``valid`` are
    the samples in which the states exist.
    """

    event: int
    laws: tuple[tuple[str, tuple[str, ...]], ...] = ()
    variant: VariantAt | None = None
    law: LawAt | None = None
    given: bool = False
    valid: Array = None


@dataclass(frozen=True, eq=False)
class States:
    """The blocks of a world, stacked: ``rows`` samples each, those of ``base`` first.

    ``base`` is the world itself, with its samples repeated.
    """

    base: World
    world: World
    rows: int
    blocks: tuple[Block, ...]

    @cached_property
    def places(self) -> Mapping[int, int]:
        """The places of the blocks, by their identity."""
        return {id(block): place for place, block in enumerate(self.blocks)}

    def loose(self, event: int) -> slice:
        """The samples after an event in which no law holds."""
        place = next(
            k for k, block in enumerate(self.blocks) if block.event == event and not block.laws
        )
        return slice((place + 1) * self.rows, (place + 2) * self.rows)

    def holding(self, in_samples: Array) -> Array:
        """In which blocks something holds, from the samples in which it does."""
        table = in_samples.reshape(-1, self.rows)[1:]
        return np.array(
            [
                bool(np.all(row | ~block.valid)) and int(np.sum(block.valid)) >= 3
                for row, block in zip(table, self.blocks, strict=True)
            ],
            dtype=bool,
        )


def states(world: World, *, altered: bool = False) -> States:
    """The random states of every event of a world; with ``altered`` those of altered laws too."""
    key = "altered states" if altered else "states"
    if key not in world._known:
        with np.errstate(all="ignore"):
            world._known[key] = _states(world, altered)
    known: States = world._known[key]
    return known


def _states(world: World, altered: bool) -> States:
    base = world.repeated(_COPIES)
    rng = np.random.default_rng(20)
    blocks: list[Block] = []
    tables: list[Mapping[tuple[int, str], Vector]] = [{}]
    for number, step in enumerate(base.events, 1):
        if isinstance(step, Arrival):
            continue
        loose = _scattered(base, number, step, rng)
        later = _later(base, number, rng)
        pairs = list(_lawful(base, number, step, loose))
        if altered and isinstance(step, Impact):
            pairs += _unlawful(base, number, step, loose)
        pairs += _factual(base, number, step, loose)
        for block, parts in pairs:
            after = {(number, name): _velocity(base, number, *parts[name]) for name in parts}
            blocks.append(block if block.valid is not None else _valid(base, block))
            tables.append({**after, **_carried(base, number, after, later)})
    return States(base, assembled(base, tables), base.samples, tuple(blocks))


def _valid(base: World, block: Block) -> Block:
    return replace(block, valid=np.ones(base.samples, dtype=bool))


def assembled(base: World, tables: Sequence[Mapping[tuple[int, str], Vector]]) -> World:
    """Copies of a world, one after another, each with some velocities after events replaced."""
    n = len(tables)

    def tiled(x: Array) -> Array:
        return np.tile(base.spread(x), n)

    def of(value: Any) -> Any:
        if value is None:
            return None
        return Vector(tiled(value.x), tiled(value.y)) if isinstance(value, Vector) else tiled(value)

    def joined(key: tuple[int, str]) -> Vector:
        own = [table.get(key, base.after[key]) for table in tables]
        return Vector(*(np.concatenate([base.spread(v[k]) for v in own]) for k in (0, 1)))

    copied = {
        name: {key: of(value) for key, value in getattr(base, name).items()}
        for name in ("letters", "start", "lines", "walls", "times")
    }
    stops = {
        name: tuple(replace(stop, where=of(stop.where), jump=of(stop.jump)) for stop in known)
        for name, known in base.stops.items()
    }
    put: dict[str, Any] = {**copied, "after": {key: joined(key) for key in base.after}}
    return replace(base, samples=n * base.samples, stops=stops, **put)


# --- components -----------------------------------------------------------------------------------


def _line(base: World, number: int) -> Vector:
    """The unit vector by which velocities after an event are resolved."""
    return base.lines.get(number, Vector(np.float64(1), np.float64(0)))


def _velocity(base: World, number: int, along: Array, across: Array) -> Vector:
    line = _line(base, number)
    left = line.turned_left()
    return Vector(line.x * along + left.x * across, line.y * along + left.y * across)


def _parts(base: World, number: int, velocity: Vector) -> tuple[Array, Array]:
    line = _line(base, number)
    return base.spread(velocity.dot(line)), base.spread(velocity.dot(line.turned_left()))


def _scattered(base: World, number: int, step: Event, rng: np.random.Generator) -> Parts:
    """Components after an event, each by itself within 30 % of the true one."""
    telling = Telling(base, degrees=False)
    names = _spheres(base, step)
    speeds = [np.abs(_parts(base, number, telling.velocity(name, number - 1))) for name in names]
    size = np.maximum(np.max([speed.max() for speed in speeds]), 1e-3)
    loose = {}
    for name in names:
        true = _parts(base, number, telling.velocity(name, number))
        loose[name] = (_loose(true[0], size, rng), _loose(true[1], size, rng))
    return loose


def _loose(x: Array, size: Array, rng: np.random.Generator) -> Array:
    factor = 1 + rng.choice((-1, 1), x.shape) * rng.uniform(0.08, _SCATTER, x.shape)
    beside = rng.choice((-1, 1), x.shape) * size * rng.uniform(0.1, _SCATTER, x.shape)
    scattered: Array = np.where(np.abs(x) > 1e-9 * size, x * factor, beside)
    return scattered


def _spheres(base: World, step: Event) -> tuple[str, ...]:
    bodies = (step.first, step.second) if isinstance(step, Impact) else (step.body,)
    return tuple(name for name in bodies if name in base.start)


def _later(base: World, number: int, rng: np.random.Generator) -> Mapping[tuple[int, str], Vector]:
    """What comes after later events, loose too."""
    later: dict[tuple[int, str], Vector] = {}
    for event in range(number + 1, len(base.events) + 1):
        step = base.events[event - 1]
        if isinstance(step, Arrival):
            continue
        for name, (along, across) in _scattered(base, event, step, rng).items():
            later[event, name] = _velocity(base, event, along, across)
    return later


def _carried(
    base: World,
    number: int,
    after: Mapping[tuple[int, str], Vector],
    later: Mapping[tuple[int, str], Vector],
) -> Mapping[tuple[int, str], Vector]:
    """Later velocities, with those that an arrival leaves as they are."""
    table = {**after, **later}
    for event in range(number + 1, len(base.events) + 1):
        step = base.events[event - 1]
        if isinstance(step, Arrival):
            last = max((n for n, name in table if name == step.body and n < event), default=None)
            if last is not None:
                table[event, step.body] = table[last, step.body]
    return table


# --- laws -----------------------------------------------------------------------------------------


def _lawful(base: World, number: int, step: Event, loose: Parts) -> Iterator[tuple[Block, Parts]]:
    """The states under each set of laws, small sets first."""
    if isinstance(step, Kick):
        telling = Telling(base, degrees=False)
        true = _parts(base, number, telling.velocity(step.body, number))
        yield Block(number), loose
        yield Block(number, (("impulse", (step.body,)),)), {step.body: true}
        return
    names = _spheres(base, step)
    laws = [("restitution", names)]
    if len(names) == 2:
        laws.insert(0, ("momentum", names))
    laws += [("unchanged", (name,)) for name in names]
    subsets = chain.from_iterable(combinations(laws, n) for n in range(len(laws) + 1))
    for subset in subsets:
        yield Block(number, subset), _under(base, number, loose, subset, names)
        if subset == (("momentum", names),):  # as vectors
            yield Block(number, subset), _in_all(base, number, loose, names)


def _before(base: World, number: int, name: str) -> tuple[Array, Array]:
    return _parts(base, number, Telling(base, degrees=False).velocity(name, number - 1))


def _under(
    base: World,
    number: int,
    loose: Parts,
    laws: Iterable[tuple[str, tuple[str, ...]]],
    names: tuple[str, ...],
) -> Parts:
    """Loose components, brought under some laws."""
    telling = Telling(base, degrees=False)
    parts = dict(loose)
    kinds = {law for law, _ in laws}
    for law, bodies in laws:
        if law == "unchanged":
            parts[bodies[0]] = parts[bodies[0]][0], _before(base, number, bodies[0])[1]
    p = {name: _before(base, number, name)[0] for name in names}
    e = telling.coefficient(number) if "restitution" in kinds else None
    if len(names) == 1:
        if e is not None:
            parts[names[0]] = -e * p[names[0]], parts[names[0]][1]
        return parts
    first, second = names
    total = apart = None
    m, n = telling.mass(first), telling.mass(second)
    if "momentum" in kinds:
        total = m * p[first] + n * p[second]
    if e is not None:
        apart = e * (p[first] - p[second])
    q1, q2 = _along(parts[first][0], parts[second][0], m, n, total, apart)
    return {first: (q1, parts[first][1]), second: (q2, parts[second][1])}


def _along(
    q1: Array, q2: Array, m: Array, n: Array, total: Array | None, apart: Array | None
) -> tuple[Array, Array]:
    """Two components of which the momentum, the difference or both are given.

    Where one is left open, it is that of the first body in every second sample.
    """
    if total is not None and apart is not None:
        return (total - n * apart) / (m + n), (total + m * apart) / (m + n)
    even = np.arange(len(q1)) % 2 == 0
    if total is not None:
        return np.where(even, q1, (total - n * q2) / m), np.where(even, (total - m * q1) / n, q2)
    if apart is not None:
        return np.where(even, q1, q2 - apart), np.where(even, q1 + apart, q2)
    return q1, q2


def _in_all(base: World, number: int, loose: Parts, names: tuple[str, ...]) -> Parts:
    """Loose components with the momentum conserved along the line of centres and across it."""
    telling = Telling(base, degrees=False)
    m, n = (telling.mass(name) for name in names)
    both = []
    for k in (0, 1):
        total = sum(telling.mass(name) * _before(base, number, name)[k] for name in names)
        both.append(_along(loose[names[0]][k], loose[names[1]][k], m, n, total, None))
    (q1, q2), (r1, r2) = both
    return {names[0]: (q1, r1), names[1]: (q2, r2)}


# --- altered laws and facts -----------------------------------------------------------------------


def _unlawful(
    base: World, number: int, step: Impact, loose: Parts
) -> Iterator[tuple[Block, Parts]]:
    """The states under each altered law of an impact."""
    events = events_of(base.problem)
    event = next(event for event in events if event.number == number)
    search = _Search(base, number, loose)
    seen: dict[Any, tuple[Array, Parts]] = {}
    for variant in variants_at(event, events):
        for law in variant.laws:
            if law.sides not in seen:
                seen[law.sides] = search.under([Claim(law.sides[0], "=", law.sides[1])], number)
            valid, parts = seen[law.sides]
            if valid.any():
                yield Block(number, variant=variant, law=law, valid=valid), parts


def _factual(base: World, number: int, step: Event, loose: Parts) -> Iterator[tuple[Block, Parts]]:
    """The states under each fact of the statement that speaks of them.

    Where it relates the directions of two spheres, there are states as well in which nothing
    changes across the line of centres: components that stay are put into such a fact.
    """
    searches = [_Search(base, number, loose)]
    if isinstance(step, Impact):
        smooth = {
            name: (along, _before(base, number, name)[1]) for name, (along, _) in loose.items()
        }
        searches.append(_Search(base, number, smooth, along=True))
    for given, now, _ in base.problem.timeline(base.part):
        if not isinstance(given, Given) or now < number:
            continue
        for relation in given.relations:
            if isinstance(relation, AtRest):
                name = relation.body.name
                if name in loose and now == number:
                    still = np.zeros(base.samples)
                    yield _valid(base, Block(number, given=True)), {**loose, name: (still, still)}
                continue
            for claim in _claims_of(relation):
                for search in searches if _is_of_two(relation) else searches[:1]:
                    valid, parts = search.under([claim], now)
                    if valid.any():
                        yield Block(number, given=True, valid=valid), parts


def _is_of_two(relation: Relation) -> bool:
    """Whether a fact relates the directions in which two spheres move."""
    if not isinstance(relation, Aligned):
        return False
    moving = [
        side.arguments for side in (relation.left, relation.right) if is_quantity(side, "velocity")
    ]
    return len(moving) == 2 and moving[0] != moving[1]


def _claims_of(relation: Relation) -> Iterator[Claim]:
    """The equations of a fact."""
    if isinstance(relation, Compare):
        for left, op, right in zip(relation.operands, relation.operators, relation.operands[1:]):
            if op == "=":
                yield Claim(left, "=", right)
    elif isinstance(relation, Aligned):
        kind = "dot" if relation.relation == "perpendicular to" else "across"
        yield Claim(Quantity(kind, (relation.left, relation.right)), "=", _ZERO)


_ZERO = Number(Fraction(0))


class _Search:
    """Solves an equation for one component after an event, by Newton's method in every sample.

    With ``along`` it is a component along the line of centres.
    """

    def __init__(self, base: World, number: int, loose: Parts, *, along: bool = False) -> None:
        self.base, self.number, self.loose = base, number, loose
        self.copies: dict[int, World] = {}
        kinds = (0,) if along else (0, 1, _ALL)
        self.places = [(name, k) for k in kinds for name in loose]
        moved = [self._moved(loose, place, self._step(place)) for place in self.places]
        self.slopes = self._world([loose, *moved])

    def _step(self, place: tuple[str, int]) -> Array:
        name, k = place
        if k == _ALL:
            return np.full(self.base.samples, _STEP)
        return _STEP * np.maximum(np.abs(self.loose[name][k]), 1e-3)

    def _moved(self, parts: Parts, place: tuple[str, int], step: Array) -> Parts:
        name, k = place
        if k == _ALL:
            return {**parts, name: (parts[name][0] * (1 + step), parts[name][1] * (1 + step))}
        own = list(parts[name])
        own[k] = own[k] + step
        return {**parts, name: (own[0], own[1])}

    def _world(self, rows: Sequence[Parts]) -> World:
        """Copies of the world under several components, one after another."""
        n = len(rows)
        if n not in self.copies:
            self.copies[n] = assembled(self.base, [{}] * n)
        joined = {
            name: [np.concatenate([parts[name][k] for parts in rows]) for k in (0, 1)]
            for name in rows[0]
        }
        copies = self.copies[n]
        after = {
            (self.number, name): _velocity(copies, self.number, *parts)
            for name, parts in joined.items()
        }
        return copies.replaced(after=after)

    def _residuals(self, claim: Claim, world: World, now: int) -> tuple[Array, Array]:
        apart, size = difference(claim, world, scope=Scope(event=now))
        return apart[:, 0].reshape(-1, self.base.samples), size[:, 0].reshape(-1, self.base.samples)

    def under(self, claims: Sequence[Claim], now: int) -> tuple[Array, Parts]:
        """The samples in which states under an equation exist, and these states."""
        nowhere = np.zeros(self.base.samples, dtype=bool)
        (claim,) = claims
        try:
            table, _ = self._residuals(claim, self.slopes, now)
        except UnvaluedError:
            return nowhere, self.loose
        steps = np.array([self._step(place) for place in self.places])
        slopes = (table[1:] - table[0]) / steps
        worth = np.abs(np.nan_to_num(slopes)).sum(axis=1)
        largest = (nowhere, self.loose)
        count = sum(k != _ALL for _, k in self.places)
        speeds = range(count, len(worth))
        for best in (*np.argsort(-worth[:count])[:2], *speeds):
            if worth[best] < 1e-9:
                continue
            tried = self._solved(claim, now, self.places[best], table[0], slopes[best])
            largest = max(largest, tried, key=lambda attempt: int(attempt[0].sum()))
            if largest[0].sum() > self.base.samples // 2:
                break
        return largest

    def _solved(
        self, claim: Claim, now: int, place: tuple[str, int], left: Array, slope: Array
    ) -> tuple[Array, Parts]:
        """States in which an equation gives one component, from its residual and slope there."""
        parts = self.loose
        for turn in range(_TURNS):
            change = np.nan_to_num(-left / slope)
            parts = self._moved(parts, place, change)
            step = self._step(place)
            residuals, size = self._residuals(
                claim, self._world([parts, self._moved(parts, place, step)]), now
            )
            left, slope = residuals[0], (residuals[1] - residuals[0]) / step
            valid: Array = np.abs(left) <= _CLOSE * np.maximum(size[0], 1e-6)
            if valid.all() or (turn == _TURNS // 2 and not valid.any()):
                break
        return valid, parts
