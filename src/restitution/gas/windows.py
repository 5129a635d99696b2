"""The run of a gas: window of time after window of time, in tile after tile.

How long a window is, how many tiles there are and how many threads is a matter of speed only: the
result is the same to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from itertools import pairwise
from operator import attrgetter
from typing import Any

import numpy as np

from restitution.errors import UnsupportedError
from restitution.gas import kernel as k
from restitution.gas import tiles as t
from restitution.gas.compiled import compiled
from restitution.gas.state import Box, Discs, Rules, aligned
from restitution.motion.contact import TOLERANCE
from restitution.records import dataclass

# Changes of a disc's velocity in one window, on average. In a tile alone only the calendar has
# to be made anew; a halo has to last for the whole window.
ALONE, TILED = 8.0, 2.0
# Cells that the fastest disc goes in a window of tiles, at most: the halo is as wide as that.
FARTHEST = 3.0
# Changes of velocity of all discs in a window alone, at least: it takes some time to begin one.
WORTHWHILE = 4000
# Events of one day of the calendar, on average.
PER_DAY = 2.5
# Ids of a day's page and of a cell's block: 64 bytes, with their number.
PAGE = 32
# Discs that a tile owns, at most, so that with their halo they fit the second-level cache.
TILE = 20_000
# Discs that there can be in a tile at all, by 16-bit ids.
MOST = 65_000
# How many cells a halo is wider, at first, than discs can come from that touch the tile's own:
# what goes wrong at its outer edge, where neighbours are missing, must not reach these.
MARGIN = 6
# After so many windows without a tile done again, a narrower halo is tried.
CALM = 40
# A tile is not worth a thread for fewer discs.
FEW = 2_000


# What is counted, in the order of saved files.
COUNTED = (
    *("pairs", "walls", "elastic", "predictions", "events", "crossings"),
    *("windows", "tiles", "redone"),
)


class Counts:
    """Numbers of impacts and of the work that they took.

    Impacts of discs and of discs with walls, how many of both were made elastic for following one
    another within the contact time, and the work that they took.
    """

    def __init__(self) -> None:
        self.pairs = self.walls = self.elastic = 0
        self.predictions = self.events = self.crossings = 0
        self.windows = self.tiles = self.redone = 0


@dataclass(frozen=True)
class Plan:
    """A tile by the columns and lines that are its own, each from the first to before the last."""

    columns: tuple[int, int]
    lines: tuple[int, int]


@dataclass(frozen=True)
class Collapsed:
    """A disc that is struck again and again at one time: its name, and the time."""

    disc: int
    time: float


@dataclass(frozen=True)
class Done:
    """The result of a tile in a window."""

    totals: list[int]
    fastest: float
    copies: Any
    log: np.ndarray
    whole: bool  # it came to the end of the window
    collapsed: Collapsed | None = None


class TooWideError(Exception):
    """A tile with so wide a halo has more discs than ids: the window has to be shorter."""


@dataclass
class Arrays:
    """One thread's arrays, for one tile at a time; plain lists for a run without a compiler."""

    local_of: Any
    slot_of: Any
    row: Any
    small: Any
    tally: Any
    names: Any
    blocks: Any
    width: int
    edges_x: Any
    edges_y: Any
    west: Any
    east: Any
    south: Any
    north: Any
    seams_x: Any
    seams_y: Any
    disc_counts: Any
    calendar: Any
    spill: Any
    agenda_times: Any
    agenda_discs: Any
    log: Any
    totals: Any
    fastest: Any
    copies: Any
    room: tuple[int, int, int, int]  # for discs, cells, days, impacts in the log

    def fits(self, discs: int, cells: int, days: int, width: int, logged: int) -> bool:
        """Whether there is room for so many discs, cells, days, ids of a block and impacts."""
        needed = (discs, cells, days, logged)
        return self.width == width and all(a >= b for a, b in zip(self.room, needed))


def arrays_for(
    make: Callable[[int, Any], Any],
    local_of: Any,
    room: tuple[int, int, int, int],
    width: int,
) -> Arrays:
    """Arrays for a tile; ``make(length, dtype)`` makes one."""
    discs, cells, days, logged = room
    side = cells + 2
    return Arrays(
        local_of=local_of,
        slot_of=make(discs, np.int32),
        row=make(8 * discs, np.float64),
        small=make(8 * discs, np.int32),
        tally=make(4 * discs, np.float64),
        names=make(discs, np.int32),
        blocks=make(cells * width, np.uint16),
        width=width,
        edges_x=make(side, np.float64),
        edges_y=make(side, np.float64),
        west=make(side, np.int64),
        east=make(side, np.int64),
        south=make(side, np.int64),
        north=make(side, np.int64),
        seams_x=make(side, np.int64),
        seams_y=make(side, np.int64),
        disc_counts=make(3, np.int64),
        calendar=make(days * PAGE, np.uint16),
        spill=make(4 * discs + 64, np.uint16),
        agenda_times=make(2 * discs + 128, np.float64),
        agenda_discs=make(2 * discs + 128, np.uint16),
        log=make(max(logged, 1) * k.LOGGED, np.float64),
        totals=make(8, np.int64),
        fastest=make(2, np.float64),
        copies=make(t.COPIED * discs, np.float64),
        room=room,
    )


class Engine:
    """Carries discs through time, in windows, tiles and threads.

    ``rate`` is about how often a disc's velocity changes in a second; it sets the lengths of
    windows and is measured as the run goes on. ``plain`` runs without a compiler.
    """

    def __init__(
        self,
        discs: Discs,
        box: Box,
        rules: Rules,
        rate: float,
        counts: Counts,
        *,
        plain: bool = False,
        tiles: int | None = None,
        threads: int = 1,
        logging: bool = False,
    ) -> None:
        self.discs, self.box, self.rules, self.rate = discs, box, rules, rate
        self.plain, self.tiles, self.threads, self.logging = plain, tiles, threads, logging
        self.pool: Executor | None = None  # of so many threads
        self.counts = counts
        self.logs: list[np.ndarray] = []
        self.collapsed: Collapsed | None = None
        self._n = len(discs.row)
        self._cell_side = min(float(np.diff(edges).min()) for edges in (box.edges_x, box.edges_y))
        self._width, self._margin, self._calm = PAGE, MARGIN, 0
        self._fewest = 1  # tiles, where discs are crowded
        self._log_rows = 1024 if logging else 0
        self._use: Callable[[Any], Any] = (lambda function: function) if plain else compiled
        self._starts = self._make(box.columns * box.lines + 1, np.int32)
        self._members = self._make(self._n, np.int32)
        self._spare: list[Arrays] = []
        self._others: list[Any] = []  # where the next state goes, by turns
        self._longest = 0.0  # s; windows grow no faster than twofold, until the rate is known
        self.load()

    def _make(self, length: int, dtype: Any) -> Any:
        return [0] * length if self.plain else aligned((length,), dtype)

    def load(self) -> None:
        """Takes the state from the discs' arrays."""
        discs, box = self.discs, self.box
        flat = [array.reshape(-1) for array in (discs.row, discs.small, discs.tally)]
        if self.plain:
            self._now: list[Any] = [array.tolist() for array in flat]
            self._next: list[Any] = [list(column) for column in self._now]
            self._names = discs.names.tolist()
            self._edges = (box.edges_x.tolist(), box.edges_y.tolist())
        else:
            if not self._others:
                self._others = [aligned(array.shape, array.dtype) for array in flat]
            self._now, self._next = flat, self._others
            self._names = discs.names
            self._edges = (box.edges_x, box.edges_y)
        self._fastest = float(np.hypot(discs.row[:, k.VX], discs.row[:, k.VY]).max())

    def store(self) -> None:
        """Gives the state back to the discs' arrays."""
        discs = self.discs
        for array, values in zip((discs.row, discs.small, discs.tally), self._now):
            array.reshape(-1)[:] = values

    # --- windows ---------------------------------------------------------------------------------

    def run(self, until: float, pause: Callable[[], None]) -> None:
        """Carry all discs to a time (s) counted from the epoch; ``pause`` between windows.

        What ``pause`` raises ends the run between two windows. So does a collapse: then
        ``collapsed`` tells which, and the state is that before its window.
        """
        discs = self.discs
        while discs.now < until:
            tiled = len(self.plans()) > 1
            changes = TILED if tiled else max(ALONE, WORTHWHILE / self._n)
            length = changes / self.rate if self.rate > 0 else math.inf
            if tiled and self._fastest > 0:
                length = min(length, FARTHEST * self._cell_side / self._fastest)
            length = min(length, 2 * self._longest or 0.25 * length)
            while True:
                # one much shorter than the others is as dear as they are
                end = until if discs.now + 1.25 * length > until else discs.now + length
                try:
                    done = self._window(discs.now, end)
                    break
                except TooWideError:
                    # more tiles, and a narrower halo
                    self._fewest = 2 * len(self.plans())
                    if self._fewest >= 2 * self.box.columns * self.box.lines:
                        raise UnsupportedError(
                            f"more than {MOST} discs are too close together in so large a box"
                        ) from None
                    length = (end - discs.now) / 2
            if self.collapsed:
                return
            changed = self._book(done)
            if changed and end > discs.now:
                self.rate = changed / self._n / (end - discs.now)
            self._longest = max(self._longest, end - discs.now) if self._longest else length
            discs.now = end
            pause()

    def _window(self, start: float, end: float) -> list[Done]:
        """One window in all tiles; the state is replaced only when all is well."""
        box = self.box
        self._use(t.index)(
            self._now[1], self._n, box.columns, box.columns * box.lines, self._starts, self._members
        )
        plans = self.plans()
        margins = [self._margin] * len(plans)
        done: dict[int, Done] = {}
        redone = 0
        while True:
            near = self._near(end - start) if len(plans) > 1 else 0
            todo = [number for number in range(len(plans)) if number not in done]
            jobs = [(plans[number], near, margins[number], start, end) for number in todo]
            done.update(zip(todo, self._map(jobs)))
            collapses = [result.collapsed for result in done.values() if result.collapsed]
            self.collapsed = min(collapses, key=attrgetter("time"), default=None)
            if len(plans) == 1 or self.collapsed:
                break
            self._fastest = max(self._fastest, *(result.fastest for result in done.values()))
            if self._near(end - start) > near:
                done.clear()  # discs came from farther than was thought
                continue
            for number in [number for number, result in done.items() if self._differs(result)]:
                del done[number]
                margins[number] += 4
                redone += 1
            if len(done) == len(plans):
                break
        self._learn(redone, len(plans))
        if self.collapsed is None:
            self._now, self._next = self._next, self._now
            self._fastest = max(self._fastest, *(result.fastest for result in done.values()))
        return [done[number] for number in range(len(plans))]

    def _near(self, length: float) -> int:
        """How many cells away from a tile discs matter to it, in a window of so long (s).

        A disc of the tile may leave it by v·Δt; it is in the next cell then, and predicts events
        with discs one cell farther, which may come from v·Δt beyond. Those within a diameter would
        do for impacts in this window, but not for what is predicted of later ones.
        """
        return math.ceil(2 * self._fastest * length / self._cell_side) + 2

    def _differs(self, done: Done) -> bool:
        """Whether a disc of the halo moved otherwise than in the tile that owns it."""
        number = len(done.copies) // t.COPIED
        return not done.whole or bool(
            self._use(t.differing)(done.copies, number, self._next[0], self._next[1])
        )

    def _learn(self, redone: int, tiles: int) -> None:
        """A wider halo where tiles had to be done again, a narrower one after a while."""
        self.counts.redone += redone
        if tiles == 1:
            return
        if redone > 0.02 * tiles:
            self._margin += 1
            self._calm = -4 * CALM
        else:
            self._calm = 0 if redone else self._calm + 1
            if self._calm > CALM and self._margin > 2:
                self._margin -= 1
                self._calm = 0

    def _book(self, done: Sequence[Done]) -> int:
        """Adds up what was done; how many changes of velocity it was."""
        counts, changed = self.counts, 0
        for result in done:
            twice_pairs, walls, _, predictions, events, crossings = result.totals[:6]
            changed += twice_pairs + walls
            counts.walls += walls
            counts.predictions += predictions
            counts.events += events
            counts.crossings += crossings
            if len(result.log):
                self.logs.append(result.log)
        counts.pairs += sum(tile.totals[k.TWICE_PAIRS] for tile in done) // 2
        counts.elastic += sum(tile.totals[k.TWICE_ELASTIC] for tile in done) // 2
        counts.windows += 1
        counts.tiles += len(done)
        return changed

    # --- tiles -----------------------------------------------------------------------------------

    def plans(self) -> list[Plan]:
        """The tiles: few enough, small enough, and as nearly square as may be."""
        box = self.box
        threads = self.threads if self._n > FEW * self.threads else 1
        wanted = max(self.tiles or max(math.ceil(self._n / TILE), threads), self._fewest)
        if self.plain or wanted == 1:
            return [Plan((0, box.columns), (0, box.lines))]
        # the same number for each thread, so that none waits
        wanted = math.ceil(wanted / threads) * threads if self.tiles is None else wanted
        across = max(1, min(wanted, round(math.sqrt(wanted * box.columns / box.lines))))
        up = math.ceil(wanted / across)
        cuts = []
        for parts, cells, wraps in (
            (across, box.columns, box.periodic_x),
            (up, box.lines, box.periodic_y),
        ):
            halo = 2 * (self._margin + 4)
            while wraps and parts > 1 and cells // parts + halo >= cells:
                parts -= 1  # through the periodic wall the halo would meet itself
            parts = min(parts, cells)
            ends = [cells * part // parts for part in range(parts + 1)]
            cuts.append(list(pairwise(ends)))
        return [Plan(columns, lines) for lines in cuts[1] for columns in cuts[0]]

    def _layout(self, plan: Plan, near: int, margin: int) -> list[int]:
        """A tile with its halo in numbers, as ``tiles`` reads it."""
        box = self.box
        sides = []
        for (first, last), cells, wraps in (
            (plan.columns, box.columns, box.periodic_x),
            (plan.lines, box.lines, box.periodic_y),
        ):
            low, high = first - near - margin, last + near + margin
            if not wraps:
                low, high = max(low, 0), min(high, cells)
            elif high - low >= cells or last - first == cells:
                low, high = 0, cells
                if last - first < cells:
                    near = max(box.columns, box.lines)  # through the wall, all are near
            sides.append((low, high - low, first - low, last - first))
        (column, columns, own_column, own_columns), (line, lines, own_line, own_lines) = sides
        return [column, line, columns, lines, own_column, own_line, own_columns, own_lines, near]

    def _map(self, jobs: Sequence[tuple[Plan, int, int, float, float]]) -> Iterable[Done]:
        if self.pool is None or len(jobs) == 1:
            return [self._tile(*job) for job in jobs]
        return list(self.pool.map(lambda job: self._tile(*job), jobs))

    def _arrays(self, discs: int, cells: int, days: int) -> Arrays:
        """Arrays that were used before, if they have room, or new ones."""
        try:
            spare = self._spare.pop()
        except IndexError:
            local_of = self._make(self._n, np.int32 if self.plain else np.uint16)
        else:
            if spare.fits(discs, cells, days, self._width, self._log_rows):
                return spare
            local_of = spare.local_of
            discs, cells, days = (max(a, b) for a, b in zip((discs, cells, days), spare.room))
        room = (discs, cells, days, self._log_rows)
        return arrays_for(self._make, local_of, room, self._width)

    def _tile(self, plan: Plan, near: int, margin: int, start: float, end: float) -> Done:
        """One tile through one window; its results are written into the next state.

        Raises TooWideError.
        """
        layout = self._layout(plan, near, margin)
        cells = layout[t.COLUMNS] * layout[t.LINES]
        density = self._n / (self.box.columns * self.box.lines)
        discs = min(self._n, int(1.1 * cells * density) + 100)
        days = max(8, int(cells * density * self.rate * (end - start) / PER_DAY))
        if not self.plain:
            days = min(days, 40 * discs)
        code = -1
        while code not in (k.DONE, k.COLLAPSE):
            if discs > MOST and not self.plain:
                raise TooWideError
            space = self._arrays(discs, cells, days)
            code = self._fill_and_advance(space, layout, days, start, end)
            if code in (t.NO_ROOM, k.AGENDA_FULL):
                discs = 2 * discs if code == k.AGENDA_FULL else min(self._n, 2 * discs)
            elif code == k.BLOCK_FULL:
                self._width = max(self._width, 2 * space.width)
            elif code == k.LOG_FULL:
                self._log_rows = max(self._log_rows, 2 * space.room[3])
            if code not in (k.DONE, k.COLLAPSE):
                self._spare.append(space)
        own, checked, _ = (int(number) for number in space.disc_counts)
        totals = [int(number) for number in space.totals]
        fastest = math.sqrt(space.fastest[0])
        collapsed = None
        if code == k.COLLAPSE and totals[k.CULPRIT] < own:
            collapsed = Collapsed(int(space.names[totals[k.CULPRIT]]), float(space.fastest[1]))
        self._use(t.scatter)(
            self._given(layout), space.disc_counts,
            space.slot_of, space.row, space.small, space.tally,
            self.box.columns, self.box.lines, self.box.width, self.box.height,
            *self._next, space.copies,
        )  # fmt: skip
        copies = space.copies[: t.COPIED * (checked - own)]
        log = np.array(space.log[: k.LOGGED * totals[k.LOGS]]).reshape(-1, k.LOGGED)
        done = Done(
            totals,
            fastest,
            copies if self.plain else copies.copy(),
            log,
            code == k.DONE,
            collapsed,
        )
        self._spare.append(space)
        return done

    def _given(self, numbers: list[Any]) -> Any:
        return numbers if self.plain else np.array(numbers)

    def _fill_and_advance(
        self, space: Arrays, layout: list[int], days: int, start: float, end: float
    ) -> int:
        """Fill a tile's arrays and carry it through the window; how that ended."""
        box, rules = self.box, self.rules
        code = self._use(t.gather)(
            self._given(layout), *self._now, self._names, self._starts, self._members,
            box.columns, box.lines, not box.periodic_x, not box.periodic_y,
            *self._edges, box.width, box.height, space.local_of, space.slot_of,
            space.row, space.small, space.tally, space.names, space.blocks, space.width,
            space.edges_x, space.edges_y, space.west, space.east, space.south, space.north,
            space.seams_x, space.seams_y, space.disc_counts,
        )  # fmt: skip
        if code != t.FILLED:
            return int(code)
        wraps_x = box.periodic_x and layout[t.COLUMNS] == box.columns
        wraps_y = box.periodic_y and layout[t.LINES] == box.lines
        constants = [0.0] * k.CONSTANTS
        constants[k.LENGTH_X] = box.width if wraps_x else 0.0
        constants[k.LENGTH_Y] = box.height if wraps_y else 0.0
        constants[k.HALF_X] = box.width / 2 if wraps_x else math.inf
        constants[k.HALF_Y] = box.height / 2 if wraps_y else math.inf
        # added and taken away again, these leave whole multiples of the finest length and time
        constants[k.ROUND_PLACE] = 1.5 * 2.0**52 * box.resolution
        constants[k.ROUND_TIME] = 1.5 * 2.0**52 * rules.instant
        constants[k.AT_ONCE] = rules.at_once
        constants[k.FLIGHT] = k.FARTHEST * box.resolution
        constants[k.SAME_TIME] = 2 * rules.instant
        # Nearer to a tangent, what tells a hit from a miss is rounding; a miss overlaps by less
        # than TOLERANCE diameters. Discs that an impact with e = 0 left touching must not meet
        # again by rounding: they separate at a speed that can be told from none.
        constants[k.GRAZING] = TOLERANCE
        constants[k.E_DISCS] = max(rules.e, TOLERANCE)
        constants[k.E_WALLS] = rules.e_walls
        constants[k.CONTACT_TIME] = rules.contact_time
        for number in range(len(space.totals)):
            space.totals[number] = 0
        space.fastest[0] = 0.0
        return int(
            self._use(k.advance)(
                space.row,
                space.small,
                space.tally,
                space.names,
                int(space.disc_counts[2]),
                int(space.disc_counts[0]),
                space.blocks,
                space.width,
                space.calendar,
                days,
                PAGE,
                space.spill,
                space.agenda_times,
                space.agenda_discs,
                space.edges_x,
                space.edges_y,
                space.west,
                space.east,
                space.south,
                space.north,
                space.seams_x,
                space.seams_y,
                layout[t.COLUMNS],
                True if wraps_x or wraps_y else None,
                self._given(constants),
                start,
                end,
                self.logging,
                space.log,
                space.totals,
                space.fastest,
            )
        )
