"""For which meanings of its letters a line is an instance of an altered law."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product

import numpy as np

from restitution.practice.arrays import Array
from restitution.practice.inference import Item, Slot, shaped
from restitution.practice.states import States, states
from restitution.practice.trial import Tester
from restitution.practice.world import World

# A line that breaks a known law explains a meaning nearly as well as a true one.
_SHARE = 0.7
# So many options of a letter are tried, the most usual ones, and so many numbers at once.
_OPTIONS, _ROOM = 14, 2_000_000
_USUAL = 0.35


class Instances:
    """Lines tried on the random states of the altered laws of a world."""

    def __init__(self, world: World) -> None:
        self.states: States = states(world, altered=True)
        self.tester = Tester(self.states.world)
        blocks = self.states.blocks
        self.altered = np.array([block.variant is not None for block in blocks], dtype=bool)
        self.valid = np.array([block.valid for block in blocks], dtype=bool)
        self.known: dict[int, Mapping[tuple[int, ...], float]] = {}

    def ways(self, item: Item, slots: Sequence[Slot]) -> Mapping[tuple[int, ...], float]:
        """The options of the slots of an item for which it breaks a known law.

        Each comes with what share of a true item it is worth.
        """
        if id(item) not in self.known:
            self.known[id(item)] = self._ways(item, slots)
        return self.known[id(item)]

    def _ways(self, item: Item, slots: Sequence[Slot]) -> Mapping[tuple[int, ...], float]:
        used = sorted(set(item.slots.values()))
        if not self.altered.any() or len(used) > 3 or item.readings[0].sign != "=":
            return {}
        found: dict[tuple[int, ...], float] = {}
        for natures in product(*(list(slots[s].values) for s in used)):
            chosen = dict(zip(used, natures, strict=True))
            found.update(dict.fromkeys(self._tried(item, slots, chosen), _SHARE))
        return found

    def _tried(
        self, item: Item, slots: Sequence[Slot], chosen: Mapping[int, str]
    ) -> list[tuple[int, ...]]:
        places: list[list[int]] = []
        values = {}
        for axis, (s, nature) in enumerate(chosen.items()):
            slot = slots[s]
            usual = [
                place
                for place in slot.values[nature][0]  # type: ignore[index]
                if slot.options[place].cost <= _USUAL and slot.options[place].kind != "definition"
            ][:_OPTIONS]
            if not usual:
                return []
            places.append(usual)
            stacked = slot.stacked(self.tester, usual)
            values[s] = shaped(stacked, None, len(chosen), axis)
        sizes = [len(each) for each in places]
        if int(np.prod(sizes)) * self.tester.world.samples > _ROOM:
            return []
        put = {name: values[s] for name, s in item.slots.items()}
        broken = self._broken(item, put, sizes)
        return [
            tuple(each[k] for each, k in zip(places, way, strict=True))
            for way in np.argwhere(broken)[:200]
        ]

    def _broken(self, item: Item, put: Mapping[str, object], sizes: Sequence[int]) -> Array:
        """For which options an item holds in all states of an altered law."""
        total = np.zeros(tuple(sizes), dtype=bool)
        rows = self.states.rows
        for reading in item.readings[:2]:
            held = self.tester.holds(reading, put, item.decimals, item.frame)
            if held is None:
                continue
            held = np.broadcast_to(held, (*sizes, self.tester.world.samples))
            blocks = held.reshape(*sizes, -1, rows)[..., 1:, :]
            instance = np.all(blocks | ~self.valid, axis=-1) & (self.valid.sum(axis=-1) >= 3)
            total = total | np.any(instance & self.altered, axis=-1)
        return total
