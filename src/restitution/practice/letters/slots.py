"""An undeclared letter with what it may mean, and the values of each meaning."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import Nature
from restitution.expression.tree import Expression, Quantity, is_component, unsigned
from restitution.practice.letters.candidates import AXES, Candidate
from restitution.practice.letters.trial import Tester
from restitution.practice.worlds.arrays import Array, angle
from restitution.records import dataclass
from restitution.vector import Vector

_SAME = 1e-9
# What a meaning costs more that is zero whatever happens: lines of it say that zero is zero.
_IDLE = 2.5


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
        values = [(place, tester.value(self.options[place].quantity, {})) for place in places]
        return stacked(tester, values)


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
    components: dict[Any, Any] = {}
    for candidate in sorted(candidates, key=lambda candidate: candidate.cost):
        value = tester.value(candidate.quantity, {})
        key = _key(tester, value)
        if value is None or key is None:
            continue
        same = (candidate.body, candidate.event, key, _direction_key(tester, candidate.quantity))
        if same in seen:
            continue
        seen.add(same)
        if candidate.kind == "component":
            components.setdefault(same[:3], same)
        right_angle = candidate.asked and isinstance(value, Angle)
        awaited = may_vanish or (candidate.stopped and not candidate.unchanged) or right_angle
        if not awaited and makes_idle(value, tester):
            candidate = replace(candidate, cost=candidate.cost + _IDLE)
        for sense in (1, -1) if candidate.sensed else (1,):
            chosen = candidate if sense > 0 else candidate.turned()
            nature = _nature(value)
            options.append(chosen)
            # Letters that their lines define may have one value: r = u cos 45°, s = u sin 45°.
            roots.append((letter, same) if candidate.kind == "definition" else same)
            turns.append(len(options) - 1 + (sense if candidate.sensed else 0))
            values[nature].append((len(options) - 1, value if sense > 0 else -value))
    if not options:
        return None
    # The speed of a sphere that moves along one line is its component there.
    roots = [
        components.get(root[:3], root) if option.kind == "speed" else root
        for root, option in zip(roots, options, strict=True)
    ]
    known = {
        nature: (tuple(place for place, _ in value), stacked(tester, value))
        for nature, value in values.items()
    }
    return Slot(letter, tuple(options), known, tuple(roots), tuple(turns), segment)


def makes_idle(value: Value, tester: Tester) -> bool:
    """Whether a value is zero, or a right angle, at all samples: much is true of it by accident."""
    parts = [tester.world.spread(part) for part in _parts(value)]
    if isinstance(value, Angle):
        return bool(np.all(np.abs(np.sin(2 * parts[0])) < _SAME))
    return all(bool(np.all(np.abs(part) < _SAME)) for part in parts)


def _nature(value: Value) -> Nature:
    return (
        "vector" if isinstance(value, Vector) else "angle" if isinstance(value, Angle) else "scalar"
    )


def _parts(value: Value) -> tuple[Array, ...]:
    if isinstance(value, Vector):
        return (value.x, value.y)
    return (value.measure(),) if isinstance(value, Angle) else (value,)


def _key(tester: Tester, value: Value | None) -> Any:
    """A key that values share which are equal up to sign; None for a value that is not a number."""
    if value is None:
        return None
    parts = [tester.world.spread(part) for part in _parts(value)]
    if not all(np.all(np.isfinite(part)) for part in parts):
        return None
    flat = np.concatenate(parts)
    first = next((x for x in flat if abs(x) > 1e-9), 1.0)
    return _nature(value), tuple(np.round(flat * np.sign(first), 7))


def _direction_key(tester: Tester, tree: Expression) -> Any:
    """A key of the line along which a component is taken, None for what is no component.

    A fact may make the components along two lines equal: they are two quantities all the same.
    """
    inner = unsigned(tree)
    if not is_component(inner):
        return None
    units = (Quantity(inner.kind, (unit, inner.arguments[1])) for unit in AXES)
    values = [tester.value(unit, {}) for unit in units]
    if any(value is None or isinstance(value, Vector | Angle) for value in values):
        return None
    return _key(tester, Vector(*values))


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


def stacked(tester: Tester, values: Sequence[tuple[int, Value]]) -> Value:
    """Values of one nature, with shape (options, samples)."""
    columns = [
        np.stack([tester.world.spread(part) for part in parts])
        for parts in zip(*(_parts(value) for _, value in values), strict=True)
    ]
    if len(columns) == 2:
        return Vector(*columns)
    return angle(columns[0]) if isinstance(values[0][1], Angle) else columns[0]


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
