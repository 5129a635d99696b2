"""Points moved to where a claim is least true: there it fails, if it does so in a narrow place.

The draws come as near to a greatest value as chance has it. From the nearest one bounded letter is
moved after another, in steps that become smaller. It refutes; it never proves.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product

from restitution.oracle.formula import Relation
from restitution.oracle.points import BeyondError, Point, Program, Value, ball
from restitution.oracle.roles import REAL, Role

# From so many points; the first step is this share of a letter's range, the last one the other.
_STARTS, _FIRST, _LAST = 3, 2.0**-4, 2.0**-34


def descents(
    claim: Relation,
    roles: Mapping[str, Role],
    starts: Sequence[Point],
    admits: Callable[[Point], bool],
) -> Iterator[Point]:
    """The last points of descents in bounded letters: where a claim fails, if it does."""
    try:
        program = Program.of([claim.value])
    except BeyondError:
        return
    widths = {name: width for name in program.letters if (width := _width(roles.get(name, REAL)))}
    if not widths or claim.operator not in (">", ">="):
        return
    ranked = sorted(((_margin(program, point), n) for n, point in enumerate(starts)))
    for margin, n in ranked[:_STARTS]:
        point = dict(starts[n])
        step = _FIRST
        while step > _LAST and margin > 0:
            better = False
            for (name, width), sense in product(widths.items(), (1, -1)):
                moved = _moved(point[name], sense * step * width, roles[name])
                trial = {**point, name: moved}
                if _margin(program, trial) < margin and admits(trial):
                    point, margin, better = trial, _margin(program, trial), True
            step = step if better else step / 2
        yield point


def _width(role: Role) -> float | None:
    if role.low is None or role.high is None:
        return None
    return float(role.high - role.low)


def _margin(program: Program, point: Point) -> float:
    """By how much a value is above zero, in terms of its error in floats, which goes by its size.

    So it does not matter in which units it is.
    """
    value = program.balls(point)[0]
    if value is None or not all(map(math.isfinite, value)):
        return math.inf
    middle, error = value
    return middle / error if error else math.copysign(math.inf, middle) if middle else 0.0


def _moved(value: Value, by: float, role: Role) -> Value:
    """A value a little further on; it stays at a rational end that is allowed."""
    moved = Fraction(ball(value)[0]) + Fraction(by)
    for end, sense, closed in ((role.low, 1, role.closed[0]), (role.high, -1, role.closed[1])):
        assert end is not None
        if closed and end.is_Rational and sense * (moved - Fraction(int(end.p), int(end.q))) <= 0:
            return Fraction(int(end.p), int(end.q))
    return moved
