"""Which meanings of a student's letters make most of the lines true: a beam search.

Every letter without a meaning is a slot with candidates; every link of a line in which one stands
is an item. Items are taken in the order in which they have fewest letters that are still open, and
each is tried, at once, over all candidates of these and over all interpretations so far.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import product
from typing import Any

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import Nature
from restitution.expression.tree import Negate, is_binary, letters, walk
from restitution.practice.letters.candidates import Candidate
from restitution.practice.letters.slots import Slot, shaped
from restitution.practice.letters.trial import Frame, Tester, everywhere
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim, Decimal
from restitution.practice.worlds.arrays import Array
from restitution.records import dataclass
from restitution.vector import Vector

# Interpretations that are kept from item to item, and the best ways to satisfy one item.
_WIDTH, _WAYS = 80, 60
# Of those beyond, one in so many is kept that does best without the lines that break a law.
_SOUND = 4
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
# That the letters are components along i or j, where the line of centres is along neither.
_BESIDE = 0.6
# Of two letters in the order of the alphabet the first mostly belongs to the first body.
_OTHER_ORDER = 0.97
# Nearly always so where the letters are numbered: v_1 and v_2.
_OTHER_NUMBERS = 0.4
# A line that defines its letter explains nothing, and less than a line that breaks a known law; one
# that gives it a known value of the start explains as much as that.
_DEFINED, _STARTED = -0.15, 0.6
# What is left of the worth of a line that is true in a less usual reading alone.
_UNUSUAL = 0.75
# What is left of the worth of a line that is true to two figures alone.
_FIGURES, _COARSE = 3, 0.6
# What it costs that a line would be true in the other sense of its letters; less in one that may
# be of restitution, as it is that of momentum that tells the sense.
_WRONG_SENSE, _OTHER_WAY = 1.0, 0.3
# What it costs that the same quantities explain more if the letters share them otherwise.
_WORSE = 1.0
_VELOCITIES = ("component", "speed", "relative")
# What has another dimension than a velocity: nobody adds the two.
_APART = ("time", "place", "distance", "energy", "angle", "deflection", "tangent")


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
    ``shown`` tells that it is no line, but what a vector shows of a letter.
    """

    line: int
    readings: tuple[Claim, ...]
    slots: Mapping[str, int]
    weight: float = 1.0
    decimals: tuple[Decimal, ...] = ()
    frame: Frame = field(default_factory=Frame)
    pair: LinearPair | None = None
    fresh: bool = True
    shown: bool = False


Broken = Callable[[Item, Sequence[Slot]], Mapping[tuple[int, ...], float]]
"""The options of the slots of an item for which it breaks a law, and what it is worth then."""


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


# --- the search -----------------------------------------------------------------------------------


def search(
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Broken | None = None,
    width: int = _WIDTH,
) -> list[State]:
    """The best interpretations, at most ``width`` of them: the best one, then varied ones.

    ``broken`` has, for an item that is an instance of an altered law, the options of its slots (in
    their order) for which it is, and what share of a true item it is worth then.
    """
    with np.errstate(all="ignore"):
        return _searched(items, slots, tester, broken, width)


def _searched(
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Broken | None,
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
            and not all(number in state.satisfied for state in extended)
        ):
            extended += _breaking(states, number, item, slots, broken(item, slots))
        states = _pruned(extended, width)
    states += [
        swap
        for state in states[:1]
        for place in range(len(slots))
        for swap in _swaps(state, place, items, slots, tester, broken)
    ]
    states = _sensed(states, items, slots, tester)
    states = _pruned(_arranged(states, items, slots), len(states))
    return list(_varied(states))[:width]


def _swaps(
    state: State,
    place: int,
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Broken | None,
) -> Iterator[State]:
    """An interpretation with every other meaning of one letter.

    Where many letters are in doubt, those kept so far may agree on the meaning of one of them.
    """
    own = [n for n, item in enumerate(items) if place in item.slots.values()]
    before = _contribution(state, own, items, slots, tester, broken)
    rest = state.satisfied - set(own)
    for places, _ in slots[place].values.values():
        choices = [_with_option(state.options, place, option) for option in places]
        swaps = [
            State(options, 0.0, rest, {n: x for n, x in state.broken.items() if n not in own})
            for options in choices
            if options != state.options and _allowed(options, slots, [place])
        ]
        for number in own if swaps else ():
            swaps = _with_item(swaps, number, items[number], slots, tester, broken)
        for swap in swaps:
            if swap.satisfied.isdisjoint(own) and swap.broken.keys().isdisjoint(own):
                continue  # it explains no line
            score = state.score - before + swap.score - _price(swap, place, slots)
            yield replace(swap, score=score + _price(state, place, slots))


def _with_option(options: Sequence[int], place: int, option: int) -> tuple[int, ...]:
    return (*options[:place], option, *options[place + 1 :])


def _price(state: State, place: int, slots: Sequence[Slot]) -> float:
    option = state.options[place]
    return 0.0 if option < 0 else COST * slots[place].options[option].cost


def _contribution(
    state: State,
    numbers: Iterable[int],
    items: Sequence[Item],
    slots: Sequence[Slot],
    tester: Tester,
    broken: Broken | None,
) -> float:
    """What some items add to the score of an interpretation."""
    bare = [State(state.options)]
    for number in numbers:
        bare = _with_item(bare, number, items[number], slots, tester, broken)
    return bare[0].score


def _with_item(
    states: Sequence[State],
    number: int,
    item: Item,
    slots: Sequence[Slot],
    tester: Tester,
    broken: Broken | None,
) -> list[State]:
    """Interpretations whose letters have values of one nature each, with one more item."""
    used = sorted(set(item.slots.values()))
    if any(states[0].options[s] < 0 for s in used):
        return list(states)
    judged = list(_judged(states, number, item, slots, tester))
    if broken is None or not item.fresh:
        return judged
    broken_by = broken(item, slots)
    return [_broken_or_not(state, number, item, slots, broken_by) for state in judged]


def _broken_or_not(
    state: State,
    number: int,
    item: Item,
    slots: Sequence[Slot],
    shares: Mapping[tuple[int, ...], float],
) -> State:
    """An interpretation, with an item that is not true in it where that breaks a known law."""
    share = shares.get(tuple(state.options[s] for s in sorted(set(item.slots.values()))), 0.0)
    if number in state.satisfied or not share:
        return state
    worth = share * max(0.0, _worth(item, state.options, slots))
    return replace(state, score=state.score + worth, broken={**state.broken, number: worth})


def _varied(states: Sequence[State]) -> Iterator[State]:
    """The interpretations in their order, before others those that give a letter a new meaning."""
    seen: set[tuple[int, int]] = set()
    late: list[State] = []
    for state in states:
        pairs = set(enumerate(state.options))
        if pairs <= seen:
            late.append(state)
        else:
            seen |= pairs
            yield state
    yield from late


def _arranged(states: Sequence[State], items: Sequence[Item], slots: Sequence[Slot]) -> list[State]:
    """Interpretations worth less where the same quantities, shared out otherwise, do better.

    Senses and the order of bodies are told by the lines that no line above decides.
    """
    worths = [
        sum(
            item.weight
            for number, item in enumerate(items)
            if (item.fresh or item.shown)
            and number in state.satisfied
            and _is_natural(item, state, slots)
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
    shares: Mapping[tuple[int, ...], float],
) -> Iterator[State]:
    """The interpretations in which an item is an instance of an altered law."""
    used = sorted(set(item.slots.values()))
    for state, (choice, share) in product(states, shares.items()):
        free = [s for s in used if state.options[s] < 0]
        options = list(state.options)
        for s, option in zip(used, choice, strict=True):
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
    ranked = sorted(best.values(), key=lambda state: -state.score)
    if len(ranked) <= width or not any(state.broken for state in ranked[:width]):
        return ranked[:width]
    # A letter that a false line gives a meaning may be another's by a line that is yet to come.
    sound = sorted(ranked[width:], key=lambda state: sum(state.broken.values()) - state.score)
    return ranked[:width] + sound[: width // _SOUND]


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
    fine = [decimal for decimal in decimals if decimal.figures >= _FIGURES]
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
        choices = list(_choices(state, number, item, slots, chosen, truth[row]))
        choices.sort(key=lambda interpretation: -interpretation.score)
        yield from choices[:_WAYS]


def _sizes(sizes: list[int], states: int, tester: Tester) -> list[int]:
    """How many options of each letter are tried, the most usual first, where all are too many."""
    while states * tester.world.samples * int(np.prod(sizes)) > _ROOM and max(sizes) > 8:
        largest = sizes.index(max(sizes))
        sizes[largest] = max(8, sizes[largest] * 2 // 3)
    return sizes


def _choices(
    state: State,
    number: int,
    item: Item,
    slots: Sequence[Slot],
    chosen: Mapping[int, Nature],
    truth: Array,
) -> Iterator[State]:
    free = list(chosen)
    for choice in np.argwhere(truth)[: 20 * _WAYS]:
        options = list(state.options)
        for s, row in zip(free, choice, strict=True):
            options[s] = slots[s].values[chosen[s]][0][row]
        if not _allowed(options, slots, free):
            continue
        cost = COST * sum(slots[s].options[options[s]].cost for s in free)
        yield State(
            tuple(options),
            state.score + _worth(item, options, slots) * float(truth[tuple(choice)]) - cost,
            state.satisfied | {number},
            state.broken,
        )


def _allowed(options: Sequence[int], slots: Sequence[Slot], free: Sequence[int]) -> bool:
    """Whether no two letters of one scope are one quantity up to sign.

    A phrase may be that of a letter: ``tan θ = 0.372 so angle = 20.4``.
    """
    for s in free:
        root, named = slots[s].roots[options[s]], is_phrase(slots[s].letter)
        for other, option in enumerate(options):
            if other == s or option < 0 or slots[other].letter == slots[s].letter:
                continue
            if is_phrase(slots[other].letter) is not named:
                continue
            if slots[other].segment == slots[s].segment and slots[other].roots[option] == root:
                return False
    return True


# --- what a true item is worth --------------------------------------------------------------------


def _worth(item: Item, options: Sequence[int], slots: Sequence[Slot]) -> float:
    means = {name: slots[s].options[options[s]] for name, s in item.slots.items()}
    defined = [
        name
        for name, candidate in means.items()
        if candidate.kind == "definition" and not (is_phrase(name) and candidate.nature == "vector")
    ]
    if defined and len(means) == 1:
        return _STARTED if any(candidate.start for candidate in means.values()) else _DEFINED
    if len(means) == 1 and all(candidate.unchanged for candidate in means.values()) and _adds(item):
        return _STARTED * item.weight  # what stays nobody works out by a difference
    return item.weight * _naturalness(item, means)


def _adds(item: Item) -> bool:
    """Whether an item gives its letter the value of a sum, or of a difference."""
    sides = (item.readings[0].left, item.readings[0].right)
    return any(
        is_binary(node, "+", "-")
        for side in sides
        if letters(side).isdisjoint(item.slots)
        for node in walk(side)
    )


def _is_natural(item: Item, state: State, slots: Sequence[Slot]) -> bool:
    return _worth(item, state.options, slots) > 0.9 * item.weight


def _naturalness(item: Item, means: Mapping[str, Candidate]) -> float:
    """How natural it is, from 0 to 1, that two letters stand together in a linear equation."""
    if item.pair is None:
        return 1.0
    one, other = (means[name] for name in item.pair.names)
    kinds = {one.kind, other.kind}
    if not kinds <= set(_VELOCITIES):
        apart = not kinds.isdisjoint(_VELOCITIES) and not kinds.isdisjoint(_APART)
        return _ODD_PAIR if apart else 1.0
    if one.kind != "component" or other.kind != "component" or one.body == other.body:
        return _ODD_PAIR
    if one.event != other.event or one.axis != other.axis or (one.unchanged and other.unchanged):
        return _ODD_PAIR
    order = 1.0
    if (one.body or "") >= (other.body or ""):
        order = _OTHER_NUMBERS if _are_numbered(item.pair.names) else _OTHER_ORDER
    if one.beside and one.axis is not None:
        order *= _BESIDE
    same = isinstance(one.quantity, Negate) == isinstance(other.quantity, Negate)
    if item.pair.sign:
        return order if same == (item.pair.sign > 0) else _ODD_PAIR
    return order if same else _OTHER_SENSE


def _are_numbered(names: Sequence[str]) -> bool:
    """Whether letters are one with numbers in their order: v_1 and v_2."""
    first, second = (name.partition("_") for name in names)
    return first[0] == second[0] and (first[2], second[2]) == ("1", "2")


def linear_pair(
    claim: Claim, names: Sequence[str], tester: Tester, frame: Frame
) -> LinearPair | None:
    """Two letters as they stand in a linear equation with a constant; None in any other."""
    coefficients = linear_coefficients(claim, names, tester, frame)
    if coefficients is None:
        return None
    a, b, size = coefficients
    equal = np.abs(np.abs(a) - np.abs(b)) < 1e-9 * size
    return LinearPair((names[0], names[1]), 0 if np.any(equal) else int(np.sign(a[0] * b[0])))


def is_of_difference(claim: Claim, names: Sequence[str], tester: Tester, frame: Frame) -> bool:
    """Whether two letters stand in an equation as their difference, as in Newton's law."""
    coefficients = linear_coefficients(claim, names, tester, frame)
    if coefficients is None:
        return False
    a, b, size = coefficients
    return bool(np.all(np.abs(a + b) < 1e-9 * size))


def linear_coefficients(
    claim: Claim, names: Sequence[str], tester: Tester, frame: Frame
) -> tuple[Array, Array, Array] | None:
    """The coefficients a, b of two letters in a v + b w = c, and |a| + |b| + |c|, at all samples.

    All on the left side; None where it is no such equation, or c is zero.
    """
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
    return a, b, size
