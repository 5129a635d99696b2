"""For which meanings of its letters a line is an instance of an altered law or result."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import permutations, product
from typing import Any

import numpy as np

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.misconceptions import ResultAt, variants_at
from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import Nature
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    unsigned,
)
from restitution.practice.letters.inference import Item
from restitution.practice.letters.options import staged
from restitution.practice.letters.slots import Slot, shaped, stacked
from restitution.practice.letters.trial import Tester, everywhere
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array, angle
from restitution.practice.worlds.states import States, states
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Kick
from restitution.vector import Vector

# A line that breaks a known law explains a meaning nearly as well as a true one.
_SHARE = 0.7
# So many options of a letter are tried, the most usual ones, and so many numbers at once.
_WAYS, _OPTIONS, _ROOM = 200, 14, 2_000_000
_USUAL = 0.35
_CLOSE = 1e-9
_RESULTS = frozenset(("impulse", "energy", "deflection"))

Shares = Mapping[tuple[int, ...], float]


class Instances:
    """Lines tried on altered laws: in random states under one, or with the value of a result."""

    def __init__(self, world: World) -> None:
        self.true = Tester(world)
        self.states: States = states(world, altered=True)
        self.tester = Tester(self.states.world)
        blocks = self.states.blocks
        self.altered = np.array([block.variant is not None for block in blocks], dtype=bool)
        self.valid = np.array([block.valid for block in blocks], dtype=bool)
        self.known: dict[Any, Shares] = {}
        self.values: dict[Any, list[tuple[int, Value]]] = {}

    def shares(self, item: Item, slots: Sequence[Slot]) -> Shares:
        """The options of the slots of an item, in their order, for which it breaks a known law.

        Each comes with what share of a true item it is worth.
        """
        used = sorted(set(item.slots.values()))
        key = item.readings, item.line, tuple(id(slots[s].options) for s in used)
        if key not in self.known:
            self.known[key] = self._shares(item, slots, used)
        return self.known[key]

    def _shares(self, item: Item, slots: Sequence[Slot], used: Sequence[int]) -> Shares:
        if len(used) > 3 or item.readings[0].sign != "=":
            return {}
        shares: dict[tuple[int, ...], float] = {}
        for natures in product(*(list(slots[s].values) for s in used)):
            chosen = dict(zip(used, natures, strict=True))
            shares.update(dict.fromkeys(self._of_law(item, slots, chosen), _SHARE))
            shares.update(dict.fromkeys(self._of_given(item, slots, chosen), _SHARE))
            for result in (s for s in used if _stands_alone(item, s)):
                meant = self._of_result(item, slots, chosen, result)
                shares.update(dict.fromkeys(meant, _SHARE))
        return shares

    # --- laws ---------------------------------------------------------------------------------

    def _of_law(
        self, item: Item, slots: Sequence[Slot], chosen: Mapping[int, Nature]
    ) -> list[tuple[int, ...]]:
        """The options for which an item holds in all states of an altered law."""
        places = [_usual(slots[s], nature) for s, nature in chosen.items()]
        if not self.altered.any() or not self._fits(places, self.tester):
            return []
        values = {
            s: shaped(slots[s].values_of(self.tester, own), None, len(chosen), axis)
            for axis, (s, own) in enumerate(zip(chosen, places, strict=True))
        }
        total = np.zeros([len(place) for place in places], dtype=bool)
        for held in self._held(item, values, self.tester, total.shape):
            blocks = held.reshape(*total.shape, -1, self.states.rows)[..., 1:, :]
            instance = np.all(blocks | ~self.valid, axis=-1) & (self.valid.sum(axis=-1) >= 3)
            total |= np.any(instance & self.altered, axis=-1)
        return _chosen(total, places)

    def _of_given(
        self, item: Item, slots: Sequence[Slot], chosen: Mapping[int, Nature]
    ) -> list[tuple[int, ...]]:
        """The options for which a result that the question gives has an altered definition."""
        readings = [
            (event, claim)
            for reading in item.readings[:3]
            for event, claim in self._with_altered_given(reading)
        ]
        places = [_usual(slots[s], nature) for s, nature in chosen.items()]
        if not readings or not self._fits(places, self.tester):
            return []
        put = {
            name: shaped(slots[s].values_of(self.tester, places[axis]), None, len(chosen), axis)
            for axis, s in enumerate(chosen)
            for name, slot in item.slots.items()
            if slot == s
        }
        total = np.zeros([len(place) for place in places], dtype=bool)
        whole = (*total.shape, self.tester.world.samples)
        for event, claim in readings:
            held = self.tester.holds(claim, put, item.decimals, item.frame)
            if held is not None:
                loose = np.broadcast_to(held, whole)[..., self.states.loose(event)]
                total |= everywhere(loose)
        return _chosen(total, places)

    def _with_altered_given(self, claim: Claim) -> Iterator[tuple[int, Claim]]:
        """A claim with a given value as the altered definition of what has it, with its event."""
        for quantity, value in self.given:
            sides = claim.left, claim.right
            for one, other in (sides, sides[::-1]):
                if one == value:
                    for event, result in self.altered_results:
                        if result.quantity == quantity:
                            # Of a size people may write the difference in either order.
                            size = quantity.kind == "impulse" and not quantity.arguments
                            yield (
                                event,
                                Claim(result.value, "=", Apply("abs", other) if size else other),
                            )

    @cached_property
    def given(self) -> tuple[tuple[Quantity, Expression], ...]:
        """The results that the question gives, with their values."""
        world = self.true.world
        return tuple(
            (quantity, other)
            for step, now, _ in world.problem.timeline(world.part)
            if isinstance(step, Given)
            for relation in step.relations
            if isinstance(relation, Compare) and set(relation.operators) == {"="}
            for one, other in permutations(relation.operands, 2)
            if isinstance(quantity := staged(one, world.problem, world.part, now), Quantity)
        )

    @cached_property
    def altered_results(self) -> tuple[tuple[int, ResultAt], ...]:
        """The altered results of the events, each with the number of its event."""
        world = self.true.world
        events = events_of(world.problem)
        return tuple(
            (event.number, result)
            for event in events[: len(world.events)]
            for variant in variants_at(event, events)
            for result in variant.results
        )

    def _fits(self, places: Sequence[Sequence[int]], tester: Tester) -> bool:
        size = int(np.prod([len(place) for place in places]))
        return 0 < size * tester.world.samples <= _ROOM

    def _held(
        self, item: Item, values: Mapping[int, Value], tester: Tester, shape: tuple[int, ...]
    ) -> list[Array]:
        """Where the readings of an item hold, for every option and sample."""
        put = {name: values[s] for name, s in item.slots.items()}
        truths = [
            tester.holds(reading, put, item.decimals, item.frame) for reading in item.readings[:3]
        ]
        whole = (*shape, tester.world.samples)
        return [np.broadcast_to(held, whole) for held in truths if held is not None]

    # --- results ------------------------------------------------------------------------------

    def _of_result(
        self, item: Item, slots: Sequence[Slot], chosen: Mapping[int, Nature], result: int
    ) -> list[tuple[int, ...]]:
        """The options for which an item is true of an altered impulse, energy or deflection."""
        places: list[Sequence[int]] = []
        values: dict[int, Value] = {}
        for axis, (s, nature) in enumerate(chosen.items()):
            if s == result:
                pairs = self._altered_values(slots[s], nature)
                own = [place for place, _ in pairs]
            else:
                own = _usual(slots[s], nature)
                pairs = []
            if not own:
                return []
            value = stacked(self.true, pairs) if pairs else slots[s].values_of(self.true, own)
            values[s] = shaped(value, None, len(chosen), axis)
            places.append(own)
        if not self._fits(places, self.true):
            return []
        total = np.zeros([len(place) for place in places], dtype=bool)
        for held in self._held(item, values, self.true, total.shape):
            total |= everywhere(held)
        return _chosen(total, places)

    def _altered_values(self, slot: Slot, nature: Nature) -> list[tuple[int, Value]]:
        """The options of a slot that are results, each with the values that mistakes give it."""
        key = id(slot.options), nature
        if key not in self.values:
            places = [p for p in slot.values[nature][0] if slot.options[p].kind in _RESULTS]
            self.values[key] = [
                *((place, value) for place in places for value in self._mistaken(slot, place)),
                *self._taken_for_given(slot, nature),
                *self._without_mass(slot, nature),
            ]
        return self.values[key]

    def _taken_for_given(self, slot: Slot, nature: Nature) -> Iterator[tuple[int, Value]]:
        """The angles that are taken for a deflection that the question gives, with its value."""
        given = {quantity for quantity, _ in self.given}
        for _, result in self.altered_results if nature == "angle" else ():
            if result.quantity not in given:
                continue
            true, value = (self.true.value(x, {}) for x in (result.quantity, result.value))
            for place in slot.values[nature][0]:
                own = self.true.value(slot.options[place].quantity, {})
                if true is not None and value is not None and own is not None and _same(own, value):
                    yield place, true

    def _without_mass(self, slot: Slot, nature: Nature) -> Iterator[tuple[int, Value]]:
        """The velocities after blows, each as that before with the impulse and no mass."""
        events = self.true.world.events
        for place in slot.values[nature][0] if nature == "vector" else ():
            match slot.options[place].quantity:
                case Quantity("velocity", (Name(),) as body, stage):
                    number = len(events) if stage is None else stage
                case _:
                    continue
            if not isinstance(number, int) or not 0 < number <= len(events):
                continue
            if isinstance(events[number - 1], Kick):
                before, blow = (
                    Quantity("velocity", body, number - 1),
                    Quantity("impulse", body, number),
                )
                value = self.true.value(Binary("+", before, blow), {})
                if value is not None:
                    yield place, value

    def _mistaken(self, slot: Slot, place: int) -> Iterator[Value]:
        own = self.true.value(slot.options[place].quantity, {})
        if own is None or isinstance(own, Vector):
            return
        for true, value in self.results:
            if isinstance(true, Angle) or isinstance(own, Angle):
                if isinstance(own, Angle) and _same(own, true):
                    yield value
            elif _same(own, true) or _same(-own, true):
                # A student's size may come out with either sign.
                yield value
                yield -value

    @cached_property
    def results(self) -> Sequence[tuple[Value, Value]]:
        """True values of results in the world, each with one that a mistake gives it."""
        pairs: list[tuple[Value, Value]] = []
        for _, result in self.altered_results:
            true, value = (self.true.value(x, {}) for x in (result.quantity, result.value))
            if true is None or value is None or isinstance(true, Vector):
                continue
            if isinstance(true, Angle) and not isinstance(value, Angle | Vector):
                value = angle(value)
            if isinstance(true, Angle) == isinstance(value, Angle):
                pairs.append((true, value))
        return pairs


def _stands_alone(item: Item, slot: int) -> bool:
    """Whether a letter, or its size, is one side of an item."""
    names = {name for name, s in item.slots.items() if s == slot}
    for claim in item.readings:
        for side in (claim.left, claim.right):
            inner = unsigned(side)
            inner = inner.argument if isinstance(inner, Apply) else inner
            if isinstance(inner, Letter) and inner.name in names:
                return True
    return False


def _usual(slot: Slot, nature: Nature) -> list[int]:
    """The most usual options of a slot of one nature."""
    return [
        place
        for place in slot.values[nature][0]
        if slot.options[place].cost <= _USUAL and slot.options[place].kind != "definition"
    ][:_OPTIONS]


def _chosen(total: Array, places: Sequence[Sequence[int]]) -> list[tuple[int, ...]]:
    return [
        tuple(own[k] for own, k in zip(places, choice, strict=True))
        for choice in np.argwhere(total)[:200]
    ]


def _same(one: Value, other: Value) -> bool:
    """Whether two scalars, or two angles, are equal at all samples."""
    if isinstance(one, Angle) != isinstance(other, Angle):
        return False
    a, b = (x.measure() if isinstance(x, Angle) else x for x in (one, other))
    return bool(np.all(np.abs(a - b) <= _CLOSE * (1 + np.abs(a))))
