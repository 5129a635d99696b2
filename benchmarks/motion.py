"""How fast motion is, against others: ``uv run --group bench python benchmarks/motion.py``.

Contenders take turns in one run, and what is told is the median of the ratios of neighbours, with
the quarter below and above: what the machine does beside hits both alike. One thread unless said.

A batch of impacts is measured against a copy of memory that moves the same bytes, and against the
obvious NumPy; a gas against ``billiards`` and ``pymunk``, from the same places and velocities.
"""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from statistics import median, quantiles
from typing import Any

import numpy as np

from restitution import Gas

BATCH = 10**7
PACKING = 0.3
# The spread of each component of the velocities, in diameters a second: in the units of the field,
# where kT, mass and diameter are 1, and, since pymunk gains by larger steps, five times as fast.
SPEED, FAST = 1.0, 5.0
STEP = 0.01  # of pymunk
SLICE = 0.4  # seconds that each contender works at a turn


@dataclass(frozen=True)
class Row:
    """What was measured, and what it was to be."""

    what: str
    ratios: Sequence[float]
    goal: float | None
    unit: str = ""
    at_most: bool = False

    def __str__(self) -> str:
        middle = median(self.ratios)
        low, _, high = quantiles(self.ratios) if len(self.ratios) > 1 else [middle] * 3
        goal, met = "", ""
        if self.goal is not None:
            sign = "≤" if self.at_most else "≥"
            goal = f"{sign} {_short(self.goal)}"
            met = "yes" if (middle <= self.goal if self.at_most else middle >= self.goal) else "no"
        cells = (self.what, _short(middle) + self.unit, f"{_short(low)} to {_short(high)}")
        return f"| {' | '.join((*cells, goal, met))} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=list(SECTIONS), action="append", help="may be repeated")
    parser.add_argument("--repeat", type=int, default=15, help="turns of each contender")
    options = parser.parse_args()
    rows = [
        row for name in options.only or SECTIONS for row in SECTIONS[name](max(options.repeat, 2))
    ]
    print("| | measured | quartiles | goal | met |\n|---|---:|---:|---:|---|")
    for row in rows:
        print(row)


def _short(number: float) -> str:
    if number and not 1e-3 <= abs(number) < 1e9:
        return f"{number:.1e}"
    return f"{number:,.0f}" if abs(number) >= 100 else f"{number:.3g}"


def taking_turns(contenders: dict[str, Callable[[], float]], turns: int) -> dict[str, list[float]]:
    """What each contender returns at each turn, after one turn that is not counted."""
    measured: dict[str, list[float]] = {name: [] for name in contenders}
    for turn in range(turns + 1):
        for name, contender in contenders.items():
            value = contender()
            if turn:
                measured[name].append(value)
    return measured


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def quotients(above: Sequence[float], below: Sequence[float]) -> list[float]:
    return [a / b for a, b in zip(above, below)]


# --- a batch of impacts ------------------------------------------------------------------------


def batch(turns: int) -> Iterator[Row]:
    """All data given for every row, results into arrays that are there: 104 bytes an impact."""
    from restitution import impacts

    rng = np.random.default_rng(1)
    data = [rng.normal(size=(BATCH, 2)) for _ in range(3)] + [rng.random(BATCH) for _ in range(3)]
    out = np.zeros((BATCH, 2)), np.zeros((BATCH, 2))
    moved = sum(each.nbytes for each in (*data, *out)) // 2  # a copy reads and writes
    source, target = np.ones(moved // 8), np.zeros(moved // 8)
    halves = [slice(0, moved // 16), slice(moved // 16, None)]

    def copy_by_two() -> None:
        list(pool.map(lambda half: np.copyto(target[half], source[half]), halves))

    def naive() -> tuple[np.ndarray, np.ndarray]:
        u1, u2, c, w1, w2, e = data
        approach = ((u1 - u2) * c).sum(axis=1)
        impulse = c * ((1 + e) * approach / ((w1 + w2) * (c * c).sum(axis=1)))[:, None]
        return u1 - impulse * w1[:, None], u2 + impulse * w2[:, None]

    error = max(float(np.abs(a - b).max()) for a, b in zip(impacts(*data, out=out), naive()))
    with ThreadPoolExecutor(2) as pool:
        took = taking_turns(
            {
                "copy": lambda: seconds(lambda: np.copyto(target, source)),
                "one": lambda: seconds(lambda: impacts(*data, out=out)),
                "copy by two": lambda: seconds(copy_by_two),
                "two": lambda: seconds(lambda: impacts(*data, out=out, threads=2)),
            },
            turns,
        )
    few = taking_turns(
        {"naive": lambda: seconds(naive), "one": lambda: seconds(lambda: impacts(*data, out=out))},
        max(3, turns // 4),
    )
    what = f"batch of {BATCH:.0e}"
    yield Row(
        f"{what} against a copy of memory, one thread", quotients(took["copy"], took["one"]), 0.6
    )
    yield Row(
        f"{what} against a copy of memory, two threads",
        quotients(took["copy by two"], took["two"]),
        0.85,
    )
    yield Row(f"{what} against NumPy", quotients(few["naive"], few["one"]), 5, " ×")
    yield Row(
        f"{what}: difference from NumPy", [error], 1e-13 * float(np.abs(out).max()), at_most=True
    )
    yield Row(f"{what}, ns an impact, one thread", [t / BATCH * 1e9 for t in took["one"]], None)


# --- a gas -------------------------------------------------------------------------------------

Rate = Callable[[], float]
"""Goes on for some time with a run of its own, and returns its impacts per second."""


@dataclass(frozen=True)
class Start:
    """Discs of diameter 1 and mass 1 in a square box with hard walls and a corner at the origin."""

    side: float
    places: np.ndarray
    velocities: np.ndarray


def start(discs: int, packing: float = PACKING, speed: float = SPEED) -> Start:
    """Discs off the places of a lattice, with the velocities of Maxwell."""
    rng = np.random.default_rng(discs)
    side = math.sqrt(discs * math.pi / 4 / packing)
    columns = math.ceil(math.sqrt(discs))
    room = side / columns
    lattice = np.stack(np.divmod(np.arange(discs), columns)[::-1], axis=1)
    shaken = rng.uniform(-0.45, 0.45, (discs, 2)) * (room - 1)
    return Start(side, (lattice + 0.5) * room + shaken, rng.normal(0, speed, (discs, 2)))


def gas_rate(begin: Start, threads: int = 1) -> Rate:
    """The package's own, a slice at a turn; a large gas goes on for some impacts of each disc."""
    gas = gas_of(begin)
    least = 2 * len(gas)

    def rate() -> float:
        before, start = gas.impacts, time.perf_counter()
        while (took := time.perf_counter() - start) < SLICE or gas.impacts - before < least:
            gas.run(impacts=max(least, 200_000), threads=threads, progress=False)
        return (gas.impacts - before) / took

    return rate


def gas_of(begin: Start) -> Gas:
    return Gas(begin.places, begin.velocities, width=begin.side)


def gas_outgoing(begin: Start, end: float) -> np.ndarray:
    """The velocities at a time, by the package's own."""
    gas = gas_of(begin)
    gas.run(end, progress=False)
    return gas.velocities


def billiards_rate(begin: Start) -> Rate:
    import billiards
    from billiards.obstacles import InfiniteWall

    side = begin.side
    corners = [(0, 0), (side, 0), (side, side), (0, side)]
    walls = [InfiniteWall(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    table = billiards.Billiard(walls)
    for place, velocity in zip(begin.places, begin.velocities):
        table.add_ball(place, velocity, 0.5)

    def rate() -> float:
        count, before = 0, time.perf_counter()
        while (took := time.perf_counter() - before) < SLICE:
            following = min(table.toi_next[0], table.obstacles_next[0])
            count += len(table.evolve(following))
        return count / took

    return rate


def pymunk_rate(begin: Start) -> Rate:
    """Impacts are counted in a second space beside the first, so that counting takes no time."""
    timed, counted = pymunk_space(begin), pymunk_space(begin)
    count = 0

    def begun(*_: object) -> None:
        nonlocal count
        count += 1

    counted.on_collision(None, None, begin=begun)

    def rate() -> float:
        nonlocal count
        count, steps, before = 0, 0, time.perf_counter()
        while (took := time.perf_counter() - before) < SLICE:
            timed.step(STEP)
            steps += 1
        for _ in range(steps):
            counted.step(STEP)
        return count / took

    return rate


def pymunk_space(begin: Start) -> Any:
    import pymunk

    space = pymunk.Space()
    space.collision_slop = 0  # discs are rigid: what touches has to part
    corners = [(0, 0), (begin.side, 0), (begin.side, begin.side), (0, begin.side)]
    shapes = [
        pymunk.Segment(space.static_body, a, b, 0)
        for a, b in zip(corners, corners[1:] + corners[:1])
    ]
    for place, velocity in zip(begin.places.tolist(), begin.velocities.tolist()):
        body = pymunk.Body(1, math.inf)
        body.position, body.velocity = tuple(place), tuple(velocity)
        shapes.append(pymunk.Circle(body, 0.5))
        space.add(body)
    for shape in shapes:
        shape.elasticity, shape.friction = 1, 0
    space.add(*shapes)
    return space


def pymunk_outgoing(begin: Start, end: float) -> np.ndarray:
    space = pymunk_space(begin)
    for _ in range(round(end / STEP)):
        space.step(STEP)
    return np.array([body.velocity for body in space.bodies])


def gas(turns: int) -> Iterator[Row]:
    """Impacts per second, those with walls among them, against others from the same start."""
    for discs, goal in (100, 1000), (1000, 8000):
        yield from rates(f"`billiards`, {discs} discs", billiards_rate, start(discs), goal, turns)
    for speed, goal in (SPEED, 8), (FAST, None):
        peer = f"`pymunk` at dt = 0.01, 1000 discs, speed {speed:g}"
        yield from rates(peer, pymunk_rate, start(1000, speed=speed), goal, turns)


def rates(
    peer: str, made: Callable[[Start], Rate], begin: Start, goal: float | None, turns: int
) -> Iterator[Row]:
    measured = taking_turns({"peer": made(begin), "ours": gas_rate(begin)}, turns)
    yield Row(f"gas against {peer}", quotients(measured["ours"], measured["peer"]), goal, " ×")
    yield Row(f"{peer}: impacts a second", measured["peer"], None)


def scale(turns: int) -> Iterator[Row]:
    """The package's own at 10³ and 10⁶ discs, with one thread and two."""
    small, large = start(1000), start(10**6)
    measured = taking_turns(
        {
            "10³": gas_rate(small),
            "10⁶": gas_rate(large),
            "10⁶ by two": gas_rate(large, threads=2),
            "10³, dense": gas_rate(start(1000, 0.6)),
            "10⁶, dense": gas_rate(start(10**6, 0.6)),
        },
        turns,
    )
    by_one, by_two = gas_of(large), gas_of(large)
    by_one.run(impacts=10**6, progress=False)
    by_two.run(impacts=10**6, threads=2, progress=False)
    different = int((by_one.velocities != by_two.velocities).sum())
    one = measured["10⁶"]
    dense = quotients(measured["10⁶, dense"], measured["10³, dense"])
    yield Row("gas of 10⁶ discs over one of 10³, packing 0.6", dense, 0.4)
    thin = quotients(one, measured["10³"])
    yield Row("gas of 10⁶ discs over one of 10³, packing 0.3", thin, 0.4)
    yield Row("gas of 10⁶ discs, two threads over one", quotients(measured["10⁶ by two"], one), 1.4)
    yield Row("gas of 10⁶ discs, two threads: velocities that differ", [different], 0, at_most=True)
    yield Row("gas of 10³, packing 0.6: impacts a second", measured["10³, dense"], 3e6)
    yield Row("gas of 10⁶, packing 0.6: impacts a second", measured["10⁶, dense"], 1.4e6)


# --- a second process ----------------------------------------------------------------------------

FIRST_RESULTS = {
    "batch of 10⁶": """
import numpy as np
from restitution import impacts
impacts(np.ones((10**6, 2)), (0, 0), (1, 0), 1, 0, 0.5)
""",
    "gas of 10⁴ discs": """
from restitution import Gas
Gas.fluid(10**4, 0.6, seed=1).run(impacts=10**5)
""",
    "gas of 100 discs, in plain Python": """
from restitution import Gas
Gas.fluid(100, 0.3, seed=1).run(impacts=300)
""",
}
"""What a process is to do, by what it is called; none of it compiles when the cache is filled."""


def cold(turns: int) -> Iterator[Row]:
    """Seconds from the start of an interpreter to the end of its first result."""
    runs = {
        name: lambda code=code: seconds(
            lambda: subprocess.run([sys.executable, "-c", code], check=True)
        )
        for name, code in FIRST_RESULTS.items()
    }
    for name, took in taking_turns(runs, max(3, turns // 3)).items():
        yield Row(f"second process, {name}: seconds", took, 3, at_most=True)


# --- how exact -----------------------------------------------------------------------------------

THROWS = 200


def exact(_: int) -> Iterator[Row]:
    """Velocities after an impact of two discs, against exact ones: difference over speed before."""
    for speed, goal in (SPEED, 1e-3), (FAST, None):
        rng = np.random.default_rng(7)
        theirs, ours = [], []
        for _ in range(THROWS):
            begin, end, right = throw(rng, speed)
            scale = np.hypot(*begin.velocities.T).max()
            theirs.append(np.abs(pymunk_outgoing(begin, end) - right).max() / scale)
            ours.append(np.abs(gas_outgoing(begin, end) - right).max() / scale)
        pair = f"two discs, speed {speed:g}"
        yield Row(f"`pymunk`, {pair}: error of velocities, relative", theirs, goal)
        yield Row(f"gas, {pair}: greatest error, relative", [max(ours)], 1e-13, at_most=True)


def throw(rng: np.random.Generator, typical: float) -> tuple[Start, float, np.ndarray]:
    """Two discs that hit each other far from all walls; a time just after, the velocities then."""
    import mpmath

    from restitution import law
    from restitution.vector import Vector

    side = 60.0
    turn, offset = rng.uniform(0, math.tau), rng.uniform(-0.95, 0.95)
    towards = np.array([math.cos(turn), math.sin(turn)])
    aside = np.array([-towards[1], towards[0]])
    middle, drift = np.full(2, side / 2), rng.normal(0, typical, 2)
    apart = towards * rng.uniform(2, 3) + aside * offset
    speed = rng.uniform(1, 2) * typical
    begin = Start(
        side,
        np.array([middle - apart / 2, middle + apart / 2]),
        np.array([drift + towards * speed / 2, drift - towards * speed / 2]),
    )
    with mpmath.workdps(40):
        (p1, p2), (u1, u2) = (
            [Vector(*map(mpmath.mpf, row)) for row in rows.tolist()]
            for rows in (begin.places, begin.velocities)
        )
        between, approach = p2 - p1, u2 - u1
        b, speed_2 = between.dot(approach), approach.dot(approach)
        root = mpmath.sqrt(b * b - speed_2 * (between.dot(between) - 1))
        moment = (-b - root) / speed_2
        exact = law.impact(u1, u2, 1, 1, between + approach * moment, 1)
        velocities = np.array([[float(x) for x in v] for v in exact])
    return begin, math.ceil(float(moment) / STEP + 10) * STEP, velocities


SECTIONS: dict[str, Callable[[int], Iterator[Row]]] = {
    "batch": batch,
    "gas": gas,
    "scale": scale,
    "exact": exact,
    "cold": cold,
}

if __name__ == "__main__":
    main()
