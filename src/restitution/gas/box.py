"""The gas itself: many discs in a box, what can be asked of them, and the run."""

from __future__ import annotations

import contextlib
import math
import zipfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from restitution.errors import (
    CollapseError,
    ImpossibleError,
    StatementError,
    UnsupportedError,
)
from restitution.gas import arguments, record
from restitution.gas import kernel as k
from restitution.gas.estimates import epoch_of, expected_rate, kinetic_energy, packing
from restitution.gas.pauses import pauses
from restitution.gas.start import centred, lattice, random_velocities
from restitution.gas.state import (
    SMALLEST,
    Discs,
    Rules,
    aligned,
    box_for,
    check,
    fresh,
    overlap,
)
from restitution.gas.windows import COUNTED, Counts, Engine

# A run of no more than so many impacts, among so many discs, is over in plain Python before a
# compiler is even loaded.
FEW_IMPACTS, FEW_DISCS = 1000, 1000

# After so many epochs without an impact one is no longer waited for.
QUIET = 10_000

# Before a collapse, as a part of an epoch.
SHORTLY = 2.0**-20

# What a file raises that is no saved gas.
_FAILURES = (
    *(OSError, ValueError, EOFError, zipfile.BadZipFile),
    *(KeyError, IndexError, TypeError, AttributeError, ImpossibleError),
)

# Discs of a large gas are put in the order of their cells, when an epoch ends.
MANY = 20_000

# Version of the files of saved gases.
FORMAT = 1

_ARRAYS = ("row", "small", "tally", "names")


class Gas:
    """Smooth discs in a rectangular box, from (0, 0) to (width, height), in SI units.

    ``positions`` (m) and ``velocities`` (m/s) have the shape (n, 2), ``radius`` (m) and ``mass``
    (kg) are numbers or have the shape (n,). ``periodic`` says for x and y, or for both, whether
    what leaves the box on one side enters on the other; if not, there are walls. ``e`` is the
    coefficient of restitution between discs, ``e_walls`` that at walls (left out, it is e). With
    e = 0 discs separate with the machine's tolerance, 2e-15, so that they do not meet again by
    rounding.

    With e < 1 a gas collapses: infinitely many impacts in a finite time. ``contact_time`` (s)
    avoids it: impacts that follow one of the same disc within this time are elastic (the TC model:
    S. Luding and S. McNamara, Granular Matter 1, 1998). Nothing of the kind is done unasked.

    Sides are rounded by less than the machine epsilon, and positions to multiples of
    ``resolution`` (m), about as far as floats of the box's size are apart.

    Raises:
        StatementError: something is not a finite number, or has the wrong shape.
        ImpossibleError: discs overlap, reach beyond a wall, have no mass or no size; e is not in
            [0, 1]; a periodic box is narrower than four diameters.
    """

    def __init__(
        self,
        positions: Any,
        velocities: Any,
        *,
        width: float,
        height: float | None = None,
        radius: Any = 0.5,
        mass: Any = 1.0,
        periodic: bool | tuple[bool, bool] = False,
        e: float = 1.0,
        e_walls: float | None = None,
        contact_time: float = 0.0,
    ) -> None:
        width = arguments.number(width, "width")
        height = width if height is None else arguments.number(height, "height")
        e = arguments.number(e, "e")
        e_walls = e if e_walls is None else arguments.number(e_walls, "e_walls")
        contact_time = arguments.number(contact_time, "contact_time")
        positions, velocities = (
            arguments.numbers(values, name)
            for values, name in ((positions, "positions"), (velocities, "velocities"))
        )
        n = len(positions) if positions.ndim else 0
        if n == 0:
            raise StatementError("a gas has at least one disc: positions have the shape (n, 2)")
        radii, masses = (
            np.array(np.broadcast_to(values, (n,))) if values.ndim == 0 else values
            for values in (arguments.numbers(radius, "radius"), arguments.numbers(mass, "mass"))
        )
        check(positions, velocities, radii, masses, width, height)
        for name, value in (("e", e), ("e_walls", e_walls)):
            if not 0 <= value <= 1:
                raise ImpossibleError(f"{name} is {value:g}; it has to be from 0 to 1")
        if not (math.isfinite(contact_time) and contact_time >= 0):
            raise ImpossibleError(f"contact_time is {contact_time:g}; it is a time from 0")
        wraps = arguments.both(periodic)
        self.box = box_for(width, height, wraps, float(radii.max()), n)
        places = centred(positions, radii, self.box)
        row, small, tally = fresh(places, velocities, radii, masses, self.box)
        self._discs = Discs(row, small, tally, np.arange(n, dtype=np.int32))
        deep, one, two = overlap(
            row[:, k.X], row[:, k.Y], radii, (small[:, k.COLUMN], small[:, k.LINE]), self.box
        )
        if deep > 4 * self.box.resolution:
            raise ImpossibleError(
                f"discs {min(one, two)} and {max(one, two)} overlap by {deep:.3g}: their centres "
                f"are {radii[one] + radii[two] - deep:.6g} apart, which has to be at least "
                f"{radii[one] + radii[two]:.6g}"
            )
        self.rules = Rules(e, e_walls, contact_time, epoch_of(self._discs))
        self.counts = Counts()
        self._rate = expected_rate(self._discs, self.box)
        self._engine: Engine | None = None
        self._plainly = 0.0  # impacts expected of runs in plain Python
        self._logs: list[np.ndarray] = []  # impacts recorded and not yet returned
        self.begin()

    @classmethod
    def fluid(
        cls,
        n: int,
        packing: float,
        *,
        radius: float = 0.5,
        mass: float = 1.0,
        temperature: float = 1.0,
        aspect: float = 1.0,
        periodic: bool | tuple[bool, bool] = False,
        seed: int | np.random.Generator | None = None,
        **rules: Any,
    ) -> Gas:
        """A gas of n equal discs that cover the share ``packing`` of the box.

        They start on a lattice, with random velocities of ``temperature`` (J): the mean kinetic
        energy of a disc. Where both sides are periodic the centre of mass is at rest. ``aspect`` is
        the ratio of the sides; ``rules`` are e, e_walls and contact_time. The same seed gives the
        same gas. Some ten impacts a disc melt the lattice.

        Raises as ``Gas`` does, and ImpossibleError where so many discs have no room on a lattice.
        """
        n = arguments.whole(n, "the number of discs")
        values = {
            "packing": packing,
            "radius": radius,
            "mass": mass,
            "aspect": aspect,
            "temperature": temperature,
        }
        values = {name: arguments.number(value, name) for name, value in values.items()}
        for name, value in values.items():
            if not (math.isfinite(value) and value > 0):
                raise ImpossibleError(f"{name} is {value:g}; it has to be positive")
            if not SMALLEST <= value <= 1 / SMALLEST:
                raise StatementError(
                    f"{name} is {value:g}; that is beyond what is reckoned with, {SMALLEST:g} to "
                    f"{1 / SMALLEST:g}"
                )
        packing, radius, mass, aspect, temperature = values.values()
        area = n * math.pi * radius**2 / packing
        width, height = math.sqrt(area * aspect), math.sqrt(area / aspect)
        wraps = arguments.both(periodic)
        try:
            rng = np.random.default_rng(seed)
        except (TypeError, ValueError) as error:
            raise StatementError(f"seed is {seed!r}: {error}") from error
        return cls(
            lattice(n, width, height, radius, wraps, rng),
            random_velocities(np.full(n, mass), temperature, all(wraps), rng),
            width=width,
            height=height,
            radius=radius,
            mass=mass,
            periodic=wraps,
            **rules,
        )

    # --- the state -------------------------------------------------------------------------------

    def __len__(self) -> int:
        return len(self._discs.row)

    @property
    def time(self) -> float:
        """The present time, in s."""
        return self._discs.epoch + self._discs.now

    @property
    def positions(self) -> np.ndarray:
        """Where the centres are, in m: shape (n, 2), within the box."""
        x, y = self._places()
        box = self.box
        if box.periodic_x:
            x -= box.width * np.floor(x / box.width + 0.5)
        if box.periodic_y:
            y -= box.height * np.floor(y / box.height + 0.5)
        return self._by_name(np.stack((x + box.width / 2, y + box.height / 2), axis=1))

    @property
    def unwrapped(self) -> np.ndarray:
        """Where the centres would be if periodic walls were not passed through: (n, 2), in m."""
        x, y = self._places()
        turns = self._discs.small[:, [k.TURNS_X, k.TURNS_Y]]
        sides = np.array((self.box.width, self.box.height))
        return self._by_name(np.stack((x, y), axis=1) + (turns + 0.5) * sides)

    @property
    def velocities(self) -> np.ndarray:
        """The velocities, in m/s: shape (n, 2)."""
        return self._by_name(self._discs.row[:, [k.VX, k.VY]])

    @property
    def radii(self) -> np.ndarray:
        """The radii, in m: shape (n,)."""
        return self._by_name(self._discs.row[:, k.RADIUS])

    @property
    def masses(self) -> np.ndarray:
        """The masses, in kg: shape (n,)."""
        return self._by_name(self._discs.row[:, k.MASS])

    @property
    def packing(self) -> float:
        """The share of the box that the discs cover."""
        return packing(self._discs, self.box)

    @property
    def kinetic_energy(self) -> float:
        """In J. The sum is rounded once, so that it does not depend on the order of the discs."""
        return kinetic_energy(self._discs)

    @property
    def momentum(self) -> tuple[float, float]:
        """In N s; rounded once."""
        row = self._discs.row
        return (
            math.fsum(row[:, k.MASS] * row[:, k.VX]),
            math.fsum(row[:, k.MASS] * row[:, k.VY]),
        )

    def deepest_overlap(self) -> float:
        """How far (m) two discs overlap at most; negative is the least gap between neighbours."""
        x, y = self._places()
        small = self._discs.small
        cells = small[:, k.COLUMN].astype(int), small[:, k.LINE].astype(int)
        return overlap(x, y, self._discs.row[:, k.RADIUS], cells, self.box)[0]

    def reverse(self) -> None:
        """Turn every velocity round: with e = 1 the gas goes back the way it came."""
        row, small = self._discs.row, self._discs.small
        x, y = self._places()
        resolution = self.box.resolution
        row[:, k.X], row[:, k.Y] = (np.round(array / resolution) * resolution for array in (x, y))
        row[:, k.T] = self._discs.now
        row[:, k.VX] *= -1
        row[:, k.VY] *= -1
        row[:, k.NEXT] = self._discs.now
        small[:, k.PARTNER] = k.UNASKED
        small[:, k.COUNT] += 1
        self._engine = None

    # --- the run ---------------------------------------------------------------------------------

    def run(
        self,
        duration: float | None = None,
        *,
        until: float | None = None,
        impacts: int | None = None,
        threads: int = 1,
        tiles: int | None = None,
        record_impacts: bool = False,
        progress: bool | None = None,
    ) -> np.ndarray | None:
        """Let the gas move: for a time (s), to a time, or for a number of impacts.

        For a number of impacts it goes on to the next whole 64th of an epoch, a time of some
        hundredths of an impact to some tenths. The result is the same to the last bit however it
        is cut into runs, and for any number of ``threads`` and ``tiles`` (left out, as many as suit
        the machine). ``record_impacts`` returns every impact, of the type ``gas.IMPACT``: walls
        are -1 (x = 0), -2, -3 (y = 0) and -4. ``progress`` shows a bar; left out, it comes on a
        terminal when a run is long. Ctrl-C stops between two windows of time; the gas is then as
        it was at ``time``, and can be run on or saved. What was recorded until then comes with the
        impacts of the next run that records.

        Raises:
            CollapseError: infinitely many impacts in a finite time; the gas is then as it was
                shortly before.
            StatementError: not exactly one of the three is said, or it is no time ahead.
            UnsupportedError: so long a run needs Numba, and it is not installed.
        """
        end = self._end(duration, until, impacts)
        threads = arguments.whole(threads, "the number of threads")
        if tiles is not None:
            tiles = min(
                arguments.whole(tiles, "the number of tiles"), self.box.columns * self.box.lines
            )
        with contextlib.ExitStack() as stack:
            pool = stack.enter_context(ThreadPoolExecutor(threads)) if threads > 1 else None
            engine = self._engine_for(end, impacts, threads, tiles, record_impacts)
            engine.pool = pool
            pause = stack.enter_context(
                pauses(lambda: (self.time, self.impacts), end, impacts, progress)
            )
            stack.callback(engine.store)
            stack.callback(self._read, engine)
            begun = self.time, self.impacts
            wanted = None if impacts is None else self.impacts + impacts
            if impacts and self.kinetic_energy == 0:
                raise UnsupportedError(
                    "no disc moves, so there is no impact to come: say a duration instead"
                )
            quiet = begun  # when there was an impact last
            while self.time < end if wanted is None else self.impacts < wanted:
                if self.impacts > quiet[1]:
                    quiet = (self.time, self.impacts)
                elif wanted is not None and self.time - quiet[0] > QUIET * self.rules.epoch:
                    raise UnsupportedError(
                        f"there has been no impact for {self.time - quiet[0]:.3g} s, and perhaps "
                        "there is none to come: say a duration instead of a number of impacts"
                    )
                discs, epoch = self._discs, self.rules.epoch
                step = math.inf if wanted is None else self._step(begun, wanted - self.impacts)
                target = min(step, end - discs.epoch, epoch)
                if target <= discs.now:
                    break
                engine.run(target, pause)
                self._read(engine)
                if (collapsed := engine.collapsed) is not None:
                    # to shortly before, at a time that does not depend on windows and tiles
                    engine.collapsed = None
                    engine.run(collapsed.time - epoch * SHORTLY, pause)
                    engine.collapsed = None
                    self._read(engine)
                    raise self._collapse(collapsed.disc, discs.epoch + collapsed.time)
                if discs.now >= epoch:
                    engine.store()
                    self._new_epoch()
                    engine.rules = self.rules
                    engine.load()
            self._rate = engine.rate
        if not record_impacts:
            return None
        logs, self._logs = self._logs, []
        return record.impacts_from(logs, self.masses, self.radii, self.box)

    def _step(self, begun: tuple[float, int], impacts: int) -> float:
        """A time in this epoch when there will not have been so many more impacts, most likely.

        It is a whole 64th, goes by what there has been since the run was ``begun`` (at a time,
        after impacts), and at most doubles that: so it depends neither on tiles nor on windows.
        """
        epoch, now = self.rules.epoch, self._discs.now
        elapsed, struck = self.time - begun[0], self.impacts - begun[1]
        ahead = min(elapsed, 0.9 * impacts * elapsed / struck if struck else math.inf)
        last = math.floor((now + ahead) / epoch * 64)
        return max(math.floor(now / epoch * 64) + 1, last) * (epoch / 64)

    def _read(self, engine: Engine) -> None:
        for log in engine.logs:
            log[:, 0] += self._discs.epoch
        self._logs += engine.logs
        engine.logs.clear()

    def _engine_for(
        self, end: float, impacts: int | None, threads: int, tiles: int | None, logging: bool
    ) -> Engine:
        expected = impacts or self._rate * len(self) * (end - self.time) / 2
        few = self._plainly + expected <= FEW_IMPACTS and len(self) <= FEW_DISCS
        plain = few and tiles is None
        if plain:
            self._plainly += expected
        engine = self._engine
        if (
            engine is None
            or engine.plain != plain
            or (engine.threads, engine.tiles, engine.logging) != (threads, tiles, logging)
        ):
            engine = Engine(
                self._discs,
                self.box,
                self.rules,
                self._rate,
                self.counts,
                plain=plain,
                tiles=tiles,
                threads=threads,
                logging=logging,
            )
            self._engine = engine
        elif plain:
            engine.load()
        return engine

    def _end(self, duration: float | None, until: float | None, impacts: int | None) -> float:
        if sum(limit is not None for limit in (duration, until, impacts)) != 1:
            raise StatementError("say one of duration (s), until (s) and impacts (how many)")
        if impacts is not None:
            arguments.whole(impacts, "the number of impacts", least=0)
            return math.inf
        if duration is not None:
            end = self.time + arguments.number(duration, "duration")
        else:
            end = arguments.number(until, "until")
        if not (math.isfinite(end) and end >= self.time):
            raise StatementError(f"the end is at {end:g}, but it is {self.time:g} s already")
        return end

    @property
    def impacts(self) -> int:
        """How many impacts there have been, those with walls among them."""
        return self.counts.pairs + self.counts.walls

    def _collapse(self, disc: int, time: float) -> CollapseError:
        impacts = (self.counts.pairs * 2 + self.counts.walls) / len(self)
        rules = self.rules
        if rules.e == rules.e_walls == 1 or rules.contact_time > 0:
            why = "discs that touch are jammed, or as good as"
        else:
            why = (
                f"with e = {rules.e:g} the gas collapses, with infinitely many impacts in a finite "
                "time. contact_time=… takes impacts as elastic that follow one another within that "
                "time (s), a small part of the time between impacts"
            )
        error = CollapseError(
            f"disc {disc} is struck more than {rules.at_once} times at what is one time, "
            f"{time:.6g} s, after {impacts:.3g} impacts a disc: {why}"
        )
        error.run = self
        return error

    def _new_epoch(self) -> None:
        """Count times anew, which is exact; where it has cooled, in longer epochs."""
        discs, epoch = self._discs, self.rules.epoch
        row, small, tally = discs.row, discs.small, discs.tally
        row[:, k.T] -= epoch
        row[:, k.NEXT] -= epoch
        tally[:, k.LAST_HIT] -= epoch
        discs.epoch += epoch
        discs.now = 0.0
        # Who has not been struck for long: its place from now on, while that is still exact.
        old = row[:, k.T] < -4 * epoch
        for place, speed in ((k.X, k.VX), (k.Y, k.VY)):
            gone = np.round(row[old, speed] * -row[old, k.T] / self.box.resolution)
            row[old, place] += gone * self.box.resolution
        row[old, k.T] = 0.0
        if self.rules.e < 1 or self.rules.e_walls < 1:
            self.rules = replace(self.rules, epoch=max(epoch, epoch_of(discs)))
        if len(row) >= MANY:
            order = np.lexsort((small[:, k.COLUMN], small[:, k.LINE]))
            place_of = np.empty_like(order)
            place_of[order] = np.arange(len(order))
            discs.row[:], discs.small[:], discs.tally[:] = row[order], small[order], tally[order]
            discs.names[:] = discs.names[order]
            struck = discs.small[:, k.PARTNER] >= 0
            discs.small[struck, k.PARTNER] = place_of[discs.small[struck, k.PARTNER]]

    # --- what is measured ------------------------------------------------------------------------

    def begin(self) -> None:
        """Begin to measure: what follows is counted from now."""
        self._began = self.time
        self._from = self.unwrapped
        self._counts_then = (self.counts.pairs, self.counts.walls, self.counts.elastic)
        self._discs.tally[:, [k.VIRIAL, k.WALL_X, k.WALL_Y]] = 0.0
        self._engine = None

    @property
    def measured(self) -> float:
        """For how long has been measured, in s."""
        return self.time - self._began

    @property
    def rate(self) -> float:
        """Impacts of two discs in a second, since ``begin``."""
        return self._per_time(self.counts.pairs - self._counts_then[0])

    @property
    def elastic_fraction(self) -> float:
        """The share of all impacts since ``begin`` that ``contact_time`` made elastic."""
        pairs, walls, elastic = self._counts_then
        all_of_them = self.impacts - pairs - walls
        return (self.counts.elastic - elastic) / all_of_them if all_of_them else 0.0

    @property
    def pressure(self) -> float:
        """The mean pressure since ``begin``, in N/m, from the impacts of discs (the virial).

        (kinetic energy + half the sum of impulse times distance of centres, over time) / area, in
        two dimensions; the energy is today's. Exact with periodic walls; with hard ones it is that
        of the interior, to the order of a diameter over the side.
        """
        area = self.box.width * self.box.height
        virial = self._per_time(math.fsum(self._discs.tally[:, k.VIRIAL]))
        return (self.kinetic_energy + virial / 2) / area

    @property
    def wall_pressure(self) -> tuple[float, float]:
        """The mean force on a metre of the walls across x, and of those across y, in N/m.

        Since ``begin``; nan for periodic sides.
        """
        tally, box = self._discs.tally, self.box
        across_x = self._per_time(math.fsum(tally[:, k.WALL_X])) / (2 * box.height)
        across_y = self._per_time(math.fsum(tally[:, k.WALL_Y])) / (2 * box.width)
        return (
            math.nan if box.periodic_x else across_x,
            math.nan if box.periodic_y else across_y,
        )

    @property
    def mean_square_displacement(self) -> float:
        """The mean square of how far discs have come since ``begin``, in m²."""
        return float(((self.unwrapped - self._from) ** 2).sum(axis=1).mean())

    def speeds(self, bins: int = 50) -> tuple[np.ndarray, np.ndarray]:
        """The distribution of speeds: edges of bins (m/s), and densities (s/m) between them."""
        density, edges = np.histogram(
            np.hypot(*self.velocities.T),
            bins=arguments.whole(bins, "the number of bins"),
            density=True,
        )
        return edges, density

    def _per_time(self, amount: float) -> float:
        return amount / self.measured if self.measured > 0 else math.nan

    def snapshot(self) -> np.ndarray:
        """All discs as they are: disc, x, y (m), vx, vy (m/s), radius (m), mass (kg)."""
        names = ("x", "y", "vx", "vy", "radius", "mass")
        out = np.empty(len(self), dtype=[("disc", "i8"), *((name, "f8") for name in names)])
        out["disc"] = np.arange(len(self))
        columns = (*self.positions.T, *self.velocities.T, self.radii, self.masses)
        for name, values in zip(names, columns):
            out[name] = values
        return out

    # --- saved states ----------------------------------------------------------------------------

    def save(self, path: str | Path) -> None:
        """Writes all that is needed to go on, to the last bit, into an ``.npz`` file."""
        if Path(path).suffix != ".npz":
            raise StatementError(f"the file {Path(path).name} has to end in .npz")
        box, rules, counts = self.box, self.rules, self.counts
        np.savez_compressed(
            path,
            format=FORMAT,
            sides=[box.width, box.height],
            periodic=[box.periodic_x, box.periodic_y],
            rules=[rules.e, rules.e_walls, rules.contact_time, rules.epoch],
            times=[self._discs.epoch, self._discs.now, self._began],
            counts=[getattr(counts, name) for name in COUNTED],
            counts_then=self._counts_then,
            start=self._from,
            rate=self._rate,
            **{name: getattr(self._discs, name) for name in _ARRAYS},
        )

    @classmethod
    def load(cls, path: str | Path) -> Gas:
        """The gas that was saved. Raises StatementError for any other file."""
        try:
            with zipfile.ZipFile(path), np.load(path, allow_pickle=False) as file:
                data = {name: file[name] for name in file.files}
            if int(data["format"]) != FORMAT:
                raise StatementError(f"{Path(path).name} is a saved gas of another version")
            return cls._restored(data)
        except _FAILURES as error:
            raise StatementError(f"{path} is no saved gas: {error}") from error

    @classmethod
    def _restored(cls, data: dict[str, np.ndarray]) -> Gas:
        gas = cls.__new__(cls)
        row, small, tally, names = (_aligned_copy(data[name]) for name in _ARRAYS)
        epoch, now, gas._began = (float(x) for x in data["times"])
        gas._discs = Discs(row, small, tally, names, epoch, now)
        width, height = (float(x) for x in data["sides"])
        wraps = bool(data["periodic"][0]), bool(data["periodic"][1])
        gas.box = box_for(width, height, wraps, float(row[:, k.RADIUS].max()), len(row))
        gas.rules = Rules(*(float(x) for x in data["rules"]))
        gas.counts = Counts()
        for name, value in zip(COUNTED, data["counts"]):
            setattr(gas.counts, name, int(value))
        pairs, walls, elastic = (int(x) for x in data["counts_then"])
        gas._counts_then = pairs, walls, elastic
        gas._from, gas._rate = data["start"], float(data["rate"])
        gas._engine, gas._plainly, gas._logs = None, 0.0, []
        return gas

    def __repr__(self) -> str:
        box = self.box
        sides = {
            (False, False): "hard walls",
            (True, True): "periodic walls",
            (True, False): "periodic in x",
            (False, True): "periodic in y",
        }[box.periodic_x, box.periodic_y]
        return (
            f"Gas of {len(self)} discs, packing {self.packing:.3g}, {sides}, e = {self.rules.e:g}, "
            f"at {self.time:.6g} s after {self.counts.pairs} impacts of discs"
        )

    # --- small things ----------------------------------------------------------------------------

    def _places(self) -> tuple[np.ndarray, np.ndarray]:
        """Where the discs' rows are now, from the middle of the box."""
        row = self._discs.row
        since = self._discs.now - row[:, k.T]
        return row[:, k.X] + row[:, k.VX] * since, row[:, k.Y] + row[:, k.VY] * since

    def _by_name(self, values: np.ndarray) -> np.ndarray:
        out = np.empty_like(values)
        out[self._discs.names] = values
        return out


def _aligned_copy(values: np.ndarray) -> np.ndarray:
    copy = aligned(values.shape, values.dtype)
    copy[...] = values
    return copy
