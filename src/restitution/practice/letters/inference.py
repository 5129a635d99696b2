"""Which meanings of a student's letters make most of the lines true: a beam search.

Every letter without a meaning is a slot with candidates; every link of a line in which one stands
is an item. Items are taken in the order in which they have fewest letters that are still open, and
each is tried, at once, over all candidates of these and over all interpretations so far.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import Nature
from restitution.expression.tree import Negate
from restitution.practice.letters.candidates import Candidate
from restitution.practice.letters.trial import Frame, Tester, everywhere
from restitution.practice.script import Claim, Decimal
from restitution.practice.worlds.arrays import Array, angle
from restitution.vector import Vector

# Interpretations that are kept from item to item, and the best ways to satisfy one item.
_WIDTH, _WAYS = 80, 60
# So many numbers are worked out at once, at most.
# An item tells the meanings of so many letters at most, and a script is tried in so many ways.
_MOST_OPEN = 5
_TRIES = 1500
_ROOM = 600_000
# What an unusual meaning costs, in true lines.
COST = 0.3
# What is left of the worth of an equation of momentum or restitution whose letters belong to one
# sphere, or to two lines, and of one in which the senses differ.
_ODD_PAIR = 0.05
_OTHER_SENSE = 0.8
# Of two letters in the order of the alphabet the first mostly belongs to the first body.
_OTHER_ORDER = 0.97
# A line that defines its letter explains nothing, and less than a line that breaks a known law; one
# that gives it a known value of the start explains as much as that.
_DEFINED, _STARTED = -0.15, 0.6
# What is left of the worth of a line that is true in a less usual reading alone.
_UNUSUAL = 0.75
# What is left of the worth of a line that is true to two figures alone.
_FIGURES, _COARSE = 3, 0.6
_SAME = 1e-9
# What a meaning costs more that is zero whatever happens: lines of it say that zero is zero.
_IDLE = 2.5
# What it costs that a line would be true in the other sense of its letters; less in one that may
# be of restitution, as it is that of momentum that tells the sense.
_WRONG_SENSE, _OTHER_WAY = 1.0, 0.3
# What it costs that the same quantities explain more if the letters share them otherwise.
_WORSE = 1.0
_VELOCITIES = ("component", "speed", "relative")


@dataclass(frozen=True)
class Slot:
    """An undeclared letter, in lines in which its meaning stays the same.

    ``options`` are its candidates, each sense on its own; ``values`` their values by nature, with
    the places of these among the options. ``roots`` tell which options are one quantity, and
    ``turns`` the option in the other sense, or the same where there is none.
    """

    letter: str
    options: tuple[Candidate, ...]
    values: Mapping[Nature, tuple[tuple[int, ...], Value]]
    roots: tuple[Any, ...]
    turns: tuple[int, ...]
    segment: int = 0

    def values_of(self, tester: Tester, places: Sequence[int]) -> Value:
        """The values of some options, of one nature, in a world."""
        each = [(place, tester.value(self.options[place].quantity, {})) for place in places]
        return stacked(tester, each)


@dataclass(frozen=True)
class LinearPair:
    """Two letters in an equation a v + b w = c with c not zero.

    ``sign`` is that of a b where the sizes of a and b differ, as they do with masses, and 0 where
    they are equal.
    """

    names: tuple[str, str]
    sign: int


@dataclass(frozen=True)
class Item:
    """A link of a line, in all its readings; ``slots`` are the places of the letters in it.

    ``weight`` is what it is worth if true. ``line`` is the number of its line. ``fresh`` tells that
    the lines above do not decide it. ``pair`` is there where it is linear in two letters alone.
    """

    line: int
    readings: tuple[Claim, ...]
    slots: Mapping[str, int]
    weight: float = 1.0
    decimals: tuple[Decimal, ...] = ()
    frame: Frame = field(default_factory=Frame)
    pair: LinearPair | None = None
    fresh: bool = True


@dataclass(frozen=True)
class State:
    """An interpretation: the option of each slot, -1 where it has none yet.

    ``score`` is what its true items are worth, less what its meanings cost. ``broken`` has what
    those are worth that break a known law.
    """

    options: tuple[int, ...]
    score: float = 0.0
    satisfied: frozenset[int] = frozenset()
    broken: Mapping[int, float] = field(default_factory=dict, compare=False, hash=False)


def slot_of(
    letter: str,
    candidates: Iterable[Candidate],
    tester: Tester,
    segment: int = 0,
    *,
    may_vanish: bool = False,
) -> Slot | None:
    """A slot with the values of its candidates; None where none of them has any.

    ``may_vanish`` tells that the script says of the letter that it is zero.
    """
    options: list[Candidate] = []
    roots: list[Any] = []
    turns: list[int] = []
    values: dict[Nature, list[tuple[int, Value]]] = defaultdict(list)
    seen: set[Any] = set()
    for candidate in sorted(candidates, key=lambda each: each.cost):
        value = tester.value(candidate.quantity, {})
        key = _key(tester, value)
        if value is None or key is None or (same := (candidate.body, candidate.event, key)) in seen:
            continue
        seen.add(same)
        if not may_vanish and _makes_idle(value, tester):
            candidate = replace(candidate, cost=candidate.cost + _IDLE)
        for sense in (1, -1) if candidate.sensed else (1,):
            chosen = candidate if sense > 0 else candidate.turned()
            nature = _nature(value)
            options.append(chosen)
            roots.append(same)
            turns.append(len(options) - 1 + (sense if candidate.sensed else 0))
            values[nature].append((len(options) - 1, value if sense > 0 else -value))
    if not options:
        return None
    known = {
        nature: (tuple(place for place, _ in each), stacked(tester, each))
        for nature, each in values.items()
    }
    return Slot(letter, tuple(options), known, tuple(roots), tuple(turns), segment)


def _makes_idle(value: Value, tester: Tester) -> bool:
    """Whether a value is zero, or a right angle, at all samples: much is true of it by accident."""
    parts = [tester.world.spread(each) for each in _parts(value)]
    if isinstance(value, Angle):
        return bool(np.all(np.abs(np.sin(2 * parts[0])) < _SAME))
    return all(bool(np.all(np.abs(each) < _SAME)) for each in parts)


def _nature(value: Value) -> Nature:
    return (
        "vector" if isinstance(value, Vector) else "angle" if isinstance(value, Angle) else "scalar"
    )


def _parts(value: Value) -> tuple[Array, ...]:
    if isinstance(value, Vector):
        return (value.x, value.y)
    return (value.measure(),) if isinstance(value, Angle) else (value,)


def _key(tester: Tester, value: Value | None) -> Any:
    """A key that values equal up to sign share; None for a value that is no number."""
    if value is None:
        return None
    parts = [tester.world.spread(each) for each in _parts(value)]
    if not all(np.all(np.isfinite(each)) for each in parts):
        return None
    flat = np.concatenate(parts)
    first = next((x for x in flat if abs(x) > 1e-9), 1.0)
    return _nature(value), tuple(np.round(flat * np.sign(first), 7))


def same_size(one: Value, other: Value) -> bool:
    """Whether two values of one nature are equal up to sign at all samples."""
    a, b = _parts(one), _parts(other)
    if _nature(one) != _nature(other):
        return False
    return any(
        all(
            bool(np.all(np.abs(x - sense * y) <= _SAME * (1 + np.abs(x))))
            for x, y in zip(a, b, strict=True)
        )
        for sense in (1, -1)
    )


def stacked(tester: Tester, each: Sequence[tuple[int, Value]]) -> Value:
    """Values of one nature, with shape (options, samples)."""
    columns = [
        np.stack([tester.world.spread(part) for part in parts])
        for parts in zip(*(_parts(value) for _, value in each), strict=True)
    ]
    if len(columns) == 2:
        return Vector(*columns)
    return angle(columns[0]) if isinstance(each[0][1], Angle) else columns[0]


def shaped(value: Value, rows: Any, axes: int, axis: int) -> Value:
    """The rows of a stacked value, along one of several axes before that of the samples."""

    def one(x: Array) -> Array:
        x = x[rows] if rows is not None else x
        return x.reshape((1,) * axis + (len(x),) + (1,) * (axes - axis - 1) + x.shape[-1:])

    if isinstance(value, Vector):
        return Vector(one(value.x), one(value.y))
    if isinstance(value, Angle):
        return angle(one(value.measure()))
    return one(value)


# --- the search -----------------------------------------------------------------------------------


def search(
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Callable[[Item, Sequence[Slot]], Mapping[tuple[int, ...], float]] | None = None,
    width: int = _WIDTH,
) -> list[State]:
    """The best interpretations, best first; at most ``width`` of them.

    ``broken`` has, for an item that is an instance of an altered law, the options of its slots (in
    their order) for which it is, and what share of a true item it is worth then.
    """
    with np.errstate(all="ignore"):
        return _searched(items, slots, tester, broken, width)


def _searched(
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Callable[[Item, Sequence[Slot]], Mapping[tuple[int, ...], float]] | None,
    width: int,
) -> list[State]:
    states = [State((-1,) * len(slots))]
    tries = iter(range(_TRIES))
    for number in _order(items):
        item = items[number]
        extended = list(_extended(states, number, item, slots, tester, tries))
        if (
            broken is not None
            and item.fresh
            and not all(number in each.satisfied for each in extended)
        ):
            extended += _breaking(states, number, item, slots, broken(item, slots))
        states = _pruned(extended, width)
    states = _sensed(states, items, slots, tester)
    return _pruned(_arranged(states, items, slots), width)


def _arranged(states: Sequence[State], items: Sequence[Item], slots: Sequence[Slot]) -> list[State]:
    """Interpretations worth less where the same quantities, shared out otherwise, do better.

    Senses and the order of bodies are told by the lines that no line above decides.
    """
    worths = [
        sum(
            item.weight
            for number, item in enumerate(items)
            if item.fresh and number in state.satisfied and _is_natural(item, state, slots)
        )
        for state in states
    ]
    keys = [
        frozenset(slots[s].roots[o] for s, o in enumerate(state.options) if o >= 0)
        for state in states
    ]
    best: dict[Any, float] = {}
    for key, worth in zip(keys, worths, strict=True):
        best[key] = max(worth, best.get(key, 0.0))
    return [
        replace(state, score=state.score - _WORSE) if worth < best[key] - 0.5 else state
        for state, key, worth in zip(states, keys, worths, strict=True)
    ]


def _sensed(
    states: Sequence[State], items: Sequence[Item], slots: Sequence[Slot], tester: Tester
) -> list[State]:
    """Interpretations worth less for every item that only the other sense of its letters breaks.

    Such an item has told in which sense its letters are meant.
    """
    lost = dict.fromkeys(states, 0.0)
    for number, item in enumerate(items):
        used = sorted(set(item.slots.values()))
        loose = item.pair is not None and not item.pair.sign
        wrong = _OTHER_WAY if loose else _WRONG_SENSE
        groups: dict[tuple[Any, ...], list[State]] = defaultdict(list)
        for state in states:
            options = [state.options[s] for s in used]
            turned_ = [slots[s].turns[o] for s, o in zip(used, options, strict=True) if o >= 0]
            if (
                item.fresh
                and number not in state.satisfied
                and min(options) >= 0
                and turned_ != options
            ):
                natures = tuple(_nature_at(slots[s], state.options[s]) for s in used)
                groups[natures].append(state)
        for members in groups.values():
            turned_states = [_turned(state, used, slots) for state in members]
            for state, true in zip(members, _held(item, turned_states, slots, tester), strict=True):
                if true:
                    own = 0.0 if loose else state.broken.get(number, 0.0)
                    lost[state] += wrong * item.weight + own
    return [replace(state, score=state.score - lost[state]) for state in states]


def _turned(state: State, used: Iterable[int], slots: Sequence[Slot]) -> State:
    options = list(state.options)
    for s in used:
        options[s] = slots[s].turns[options[s]]
    return replace(state, options=tuple(options))


def _breaking(
    states: Sequence[State],
    number: int,
    item: Item,
    slots: Sequence[Slot],
    ways: Mapping[tuple[int, ...], float],
) -> Iterator[State]:
    """The interpretations in which an item is an instance of an altered law."""
    used = sorted(set(item.slots.values()))
    for state, (way, share) in product(states, ways.items()):
        free = [s for s in used if state.options[s] < 0]
        options = list(state.options)
        for s, option in zip(used, way, strict=True):
            if options[s] not in (-1, option):
                break
            options[s] = option
        else:
            if _allowed(options, slots, free):
                cost = COST * sum(slots[s].options[options[s]].cost for s in free)
                worth = share * max(0.0, _worth(item, options, slots))
                yield State(
                    tuple(options),
                    state.score + worth - cost,
                    state.satisfied,
                    {**state.broken, number: worth},
                )


def _order(items: Sequence[Item]) -> Iterator[int]:
    """The items in the order in which each has fewest letters that are still open."""
    left, covered = list(range(len(items))), set[int]()
    while left:
        number = min(left, key=lambda n: (len(set(items[n].slots.values()) - covered), n))
        left.remove(number)
        covered |= set(items[number].slots.values())
        yield number


def _pruned(states: Iterable[State], width: int) -> list[State]:
    best: dict[tuple[int, ...], State] = {}
    for state in states:
        known = best.get(state.options)
        if known is None or state.score > known.score:
            best[state.options] = state
    return sorted(best.values(), key=lambda state: -state.score)[:width]


def _extended(
    states: Sequence[State],
    number: int,
    item: Item,
    slots: Sequence[Slot],
    tester: Tester,
    tries: Iterator[int],
) -> Iterator[State]:
    """The interpretations with one more item: as they are, and in every way that makes it true.

    An item with too many open letters, and one for which no ``tries`` are left, tells nothing.
    """
    used = sorted(set(item.slots.values()))
    groups: dict[tuple[Any, ...], list[State]] = defaultdict(list)
    for state in states:
        groups[tuple(_nature_at(slots[s], state.options[s]) for s in used)].append(state)
    for natures, members in groups.items():
        free = [s for s, nature in zip(used, natures, strict=True) if nature is None]
        if not free:
            yield from _judged(members, number, item, slots, tester)
            continue
        yield from members
        if len(free) > _MOST_OPEN:
            continue
        for chosen in product(*(list(slots[s].values) for s in free)):
            if next(tries, None) is None:
                break
            yield from _tried(
                members, number, item, slots, tester, dict(zip(free, chosen, strict=True))
            )


def _nature_at(slot: Slot, option: int) -> Nature | None:
    if option < 0:
        return None
    return next(nature for nature, (places, _) in slot.values.items() if option in places)


def _rows(slot: Slot, states: Sequence[State], place: int) -> tuple[Nature, list[int]]:
    """The rows of the values of a slot in several interpretations."""
    nature = _nature_at(slot, states[0].options[place])
    assert nature is not None
    places = slot.values[nature][0]
    return nature, [places.index(state.options[place]) for state in states]


def _truth(item: Item, put: Mapping[str, Value], tester: Tester) -> Array | None:
    """What an item is worth for every meaning: 1 where it is true, less in an unusual reading."""
    truth: Array | None = None
    for place, reading in enumerate(item.readings):
        for decimals, share in _by_fineness(item.decimals):
            held = tester.holds(reading, put, decimals, item.frame)
            if held is None:
                break
            true = everywhere(held) * (_UNUSUAL if place else 1.0) * share
            truth = true if truth is None else np.maximum(truth, true)
    return truth


def _by_fineness(decimals: Sequence[Decimal]) -> Iterator[tuple[Sequence[Decimal], float]]:
    """The decimals that may be rounded, with what a line is worth that holds by these alone."""
    fine = [each for each in decimals if each.figures >= _FIGURES]
    yield fine, 1.0
    if len(fine) < len(decimals):
        yield decimals, _COARSE


def _held(item: Item, states: Sequence[State], slots: Sequence[Slot], tester: Tester) -> Array:
    """How true an item is in interpretations, whose letters have values of one nature each."""
    put: dict[str, Value] = {}
    for name, s in item.slots.items():
        nature, rows = _rows(slots[s], states, s)
        put[name] = shaped(slots[s].values[nature][1], rows, 1, 0)
    held = _truth(item, put, tester)
    return np.broadcast_to(0.0 if held is None else held, (len(states),))


def _judged(
    states: Sequence[State],
    number: int,
    item: Item,
    slots: Sequence[Slot],
    tester: Tester,
) -> Iterator[State]:
    """Interpretations that leave no letter of an item open."""
    for state, true in zip(states, _held(item, states, slots, tester), strict=True):
        if not true:
            yield state
            continue
        yield replace(
            state,
            score=state.score + _worth(item, state.options, slots) * float(true),
            satisfied=state.satisfied | {number},
        )


def _tried(
    states: Sequence[State],
    number: int,
    item: Item,
    slots: Sequence[Slot],
    tester: Tester,
    chosen: Mapping[int, Nature],
) -> Iterator[State]:
    """Interpretations in every way of giving the open letters of an item a meaning."""
    free = list(chosen)
    axes = 1 + len(free)
    sizes = _sizes([len(slots[s].values[chosen[s]][0]) for s in free], len(states), tester)
    put: dict[str, Value] = {}
    for name, s in item.slots.items():
        if s in chosen:
            value = slots[s].values[chosen[s]][1]
            put[name] = shaped(value, slice(sizes[free.index(s)]), axes, 1 + free.index(s))
        else:
            nature, rows = _rows(slots[s], states, s)
            put[name] = shaped(slots[s].values[nature][1], rows, axes, 0)
    held = _truth(item, put, tester)
    if held is None or held.ndim != axes:
        held = np.broadcast_to(0.0 if held is None else held, (1,) * axes)
    truth = np.broadcast_to(held, (len(states), *sizes))
    for row, state in enumerate(states):
        ways = list(_ways(state, number, item, slots, chosen, truth[row]))
        ways.sort(key=lambda way: -way.score)
        yield from ways[:_WAYS]


def _sizes(sizes: list[int], states: int, tester: Tester) -> list[int]:
    """How many options of each letter are tried, the most usual first, where all are too many."""
    while states * tester.world.samples * int(np.prod(sizes)) > _ROOM and max(sizes) > 8:
        largest = sizes.index(max(sizes))
        sizes[largest] = max(8, sizes[largest] * 2 // 3)
    return sizes


def _ways(
    state: State,
    number: int,
    item: Item,
    slots: Sequence[Slot],
    chosen: Mapping[int, Nature],
    truth: Array,
) -> Iterator[State]:
    free = list(chosen)
    for way in np.argwhere(truth)[: 20 * _WAYS]:
        options = list(state.options)
        for s, row in zip(free, way, strict=True):
            options[s] = slots[s].values[chosen[s]][0][row]
        if not _allowed(options, slots, free):
            continue
        cost = COST * sum(slots[s].options[options[s]].cost for s in free)
        yield State(
            tuple(options),
            state.score + _worth(item, options, slots) * float(truth[tuple(way)]) - cost,
            state.satisfied | {number},
            state.broken,
        )


def _allowed(options: Sequence[int], slots: Sequence[Slot], free: Sequence[int]) -> bool:
    """Whether no two letters of one scope are one quantity up to sign."""
    for s in free:
        root = slots[s].roots[options[s]]
        for other, option in enumerate(options):
            if other == s or option < 0 or slots[other].letter == slots[s].letter:
                continue
            if slots[other].segment == slots[s].segment and slots[other].roots[option] == root:
                return False
    return True


# --- what a true item is worth --------------------------------------------------------------------


def _worth(item: Item, options: Sequence[int], slots: Sequence[Slot]) -> float:
    means = {name: slots[s].options[options[s]] for name, s in item.slots.items()}
    if any(each.kind == "definition" for each in means.values()) and len(means) == 1:
        return _STARTED if any(each.start for each in means.values()) else _DEFINED
    return item.weight * _naturalness(item, means)


def _is_natural(item: Item, state: State, slots: Sequence[Slot]) -> bool:
    return _worth(item, state.options, slots) > 0.9 * item.weight


def _naturalness(item: Item, means: Mapping[str, Candidate]) -> float:
    """How natural it is, from 0 to 1, that two letters stand together in a linear equation."""
    if item.pair is None:
        return 1.0
    one, other = (means[name] for name in item.pair.names)
    if one.kind not in _VELOCITIES or other.kind not in _VELOCITIES:
        return 1.0
    if one.kind != "component" or other.kind != "component" or one.body == other.body:
        return _ODD_PAIR
    if one.event != other.event or one.axis != other.axis or (one.unchanged and other.unchanged):
        return _ODD_PAIR
    order = 1.0 if (one.body or "") < (other.body or "") else _OTHER_ORDER
    same = isinstance(one.quantity, Negate) == isinstance(other.quantity, Negate)
    if item.pair.sign:
        return order if same == (item.pair.sign > 0) else _ODD_PAIR
    return order if same else _OTHER_SENSE


def linear_pair(
    claim: Claim, names: Sequence[str], tester: Tester, frame: Frame
) -> LinearPair | None:
    """Two letters as they stand in a linear equation with a constant; None in any other."""
    if len(names) != 2 or claim.sign != "=":
        return None
    # At (0, 0), (1, 0), (0, 1), (1, 1), (2, 3): shape (5, 1), as the samples are on the last axis.
    points = np.array([(0, 0), (1, 0), (0, 1), (1, 1), (2, 3)], dtype=float)
    put = {name: points[:, k : k + 1] for k, name in enumerate(names)}
    left, right = (tester.value(side, put, frame) for side in (claim.left, claim.right))
    if left is None or right is None or isinstance(left, Vector | Angle):
        return None
    if isinstance(right, Vector | Angle):
        return None
    if not np.all(np.isfinite(left)) or not np.all(np.isfinite(right)):
        return None
    gap = np.broadcast_to(np.subtract(left, right), (5, tester.world.samples))
    c, a, b = gap[0], gap[1] - gap[0], gap[2] - gap[0]
    size = np.abs(a) + np.abs(b) + np.abs(c)
    linear = np.abs(gap[3] - a - b - c) + np.abs(gap[4] - 2 * a - 3 * b - c) < 1e-9 * size
    if not (np.all(linear) and np.all(np.abs(a * b * c) > 1e-9 * size**3)):
        return None
    equal = np.abs(np.abs(a) - np.abs(b)) < 1e-9 * size
    return LinearPair((names[0], names[1]), 0 if np.any(equal) else int(np.sign(a[0] * b[0])))
