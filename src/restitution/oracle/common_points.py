"""Points at which equations and other formulas hold together, sought by Newton's method in floats.

What follows from equations cannot be tried at points that are drawn, for no draw satisfies them.
A draw is moved onto them. It refutes, as far as floats show it; it never proves.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from restitution.oracle.draws import draws
from restitution.oracle.formula import Formula, Relation, conjuncts, joined
from restitution.oracle.points import BeyondError, ball
from restitution.oracle.roles import REAL, Role
from restitution.oracle.testers import tester_of

_STARTS, _STEPS = 6, 16
# A letter is moved by this share of its size to see how values change.
_SHIFT = 1e-6
# What is below this share of its terms counts as zero, what is above the other as certain.
_ZERO, _CERTAIN = 1e-9, 1e-6
# A letter that comes so near to an end that it may not reach may not be there at all.
_INSIDE = 1e-3
_EPSILON = 2.0**-52
# Products of slopes that are so small a share of the largest one are rounding.
_ROUNDING = 1e-12

# Where a value has to be above zero and is not, it is moved to this share of its terms.
_ABOVE = 0.1

_Numbers = dict[str, float]
_Sized = tuple[float, float]
"""A value, and the size of its terms."""


def seem_to_hold_together(formulas: Sequence[Formula], roles: Mapping[str, Role]) -> bool:
    """Whether some point seems to satisfy all formulas, with letters well within their ranges."""
    try:
        tester = tester_of(joined(formulas))
    except BeyondError:
        return False
    alone = [own for own in conjuncts(formulas) if isinstance(own, Relation)]
    zero = {tester.values.index(own.value): 0.0 for own in alone if own.operator == "="}
    above = [tester.values.index(own.value) for own in alone if own.operator in (">", ">=")]

    def sizes(point: _Numbers) -> list[_Sized]:
        balls = tester.balls({name: ball(value) for name, value in point.items()})
        known = [(math.nan, math.nan) if own is None else own for own in balls]
        return [(middle, abs(middle) + error / _EPSILON) for middle, error in known]

    for draw in draws(sorted(tester.letters), roles, _STARTS):
        start = {name: middle for name, (middle, _) in draw.balls.items()}
        point = _moved(start, zero, sizes)
        if point is None:
            continue
        there = sizes(point)
        if below := {n: _ABOVE for n in above if not there[n][0] > 0}:
            point = _moved(point, zero | below, sizes)
        if (
            point is not None
            and all(_is_within(value, roles.get(name, REAL)) for name, value in point.items())
            and tester.holds_with(
                [
                    _sign(middle, max(size, first))
                    for (middle, size), (_, first) in zip(sizes(point), sizes(start), strict=True)
                ]
            )
        ):
            return True
    return False


def _moved(
    point: _Numbers, aims: Mapping[int, float], sizes: Callable[[_Numbers], list[_Sized]]
) -> _Numbers | None:
    """The point to which Newton's method leads, by the least step each time; None for none.

    ``aims`` are what some values come to there, as shares of their sizes.
    """
    first, usual = sizes(point), {name: abs(value) for name, value in point.items()}
    for _ in range(_STEPS):
        there = sizes(point)
        # A value without terms that cancel is zero as it was not where the search began.
        scales = {n: max(there[n][1], first[n][1]) for n in aims}
        if not all(math.isfinite(scale) and scale for scale in scales.values()):
            return None
        gaps = [there[n][0] / scales[n] - aim for n, aim in aims.items()]
        if all(abs(gap) <= _ZERO for gap in gaps):
            return point
        slopes: list[list[float]] = []
        for name, value in point.items():
            # In terms of its own size a letter changes as much as any other.
            scale = max(abs(value), usual[name])
            moved = sizes({**point, name: value + _SHIFT * scale})
            slopes.append([(moved[n][0] - there[n][0]) / _SHIFT / scales[n] for n in aims])
        by = _least_step(slopes, gaps)
        if by is None:
            return None
        point = {
            name: value - step * max(abs(value), usual[name])
            for (name, value), step in zip(point.items(), by, strict=True)
        }
    return None


def _least_step(slopes: Sequence[Sequence[float]], gaps: Sequence[float]) -> list[float] | None:
    """The shortest step that closes the gaps; ``slopes`` has a row for each letter.

    A gap whose slopes depend on those of others has to be closed by these; None if it is not.
    """
    count = len(gaps)
    rows = [
        [sum(own[a] * own[b] for own in slopes) for b in range(count)] + [gaps[a]]
        for a in range(count)
    ]
    least = max(_ZERO**2, _ROUNDING * max((rows[n][n] for n in range(count)), default=0.0))
    left = set(range(count))
    while left:
        pivot = max(left, key=lambda n: rows[n][n])
        if not rows[pivot][pivot] > least:
            break
        left.remove(pivot)
        for other in range(count):
            if other != pivot:
                share = rows[other][pivot] / rows[pivot][pivot]
                rows[other] = [a - share * b for a, b in zip(rows[other], rows[pivot], strict=True)]
                rows[other][pivot] = 0.0
    if not all(abs(rows[n][-1]) <= _CERTAIN for n in left):
        return None
    weights = [0.0 if n in left else rows[n][-1] / rows[n][n] for n in range(count)]
    return [sum(a * b for a, b in zip(own, weights, strict=True)) for own in slopes]


def _is_within(value: float, role: Role) -> bool:
    """Whether a letter may have a value, and may have those around it or is at a closed end."""
    ends = ((role.low, 1, role.closed[0]), (role.high, -1, role.closed[1]))
    return all(
        end is None
        or sense * (value - float(end)) > (-_ZERO if closed else _INSIDE) * (1 + abs(value))
        for end, sense, closed in ends
    )


def _sign(middle: float, size: float) -> int | None:
    """The sign of a value in floats; None where it may be zero or not."""
    if abs(middle) <= 2 * _ZERO * size:
        return 0
    return None if not abs(middle) > _CERTAIN * size else 1 if middle > 0 else -1
