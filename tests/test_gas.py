"""Many discs: against closed forms, the engine for few, published physics, and themselves.

A run that is cut into tiles, threads, windows or runs has to be the same to the last bit; that is
what finds a fault which energy and overlaps do not show.
"""

from __future__ import annotations

import math
import re
import signal
import subprocess
import sys
import textwrap
from fractions import Fraction

import numpy as np
import pytest
import strategies
from hypothesis import given, settings

from restitution import Sphere, Table, law, simulate
from restitution import gas as package
from restitution.errors import CollapseError, ImpossibleError, StatementError, UnsupportedError
from restitution.gas import Gas, box, windows
from restitution.vector import Vector

HARD, PERIODIC, CHANNEL = False, True, (True, False)


@pytest.fixture
def narrow(monkeypatch):
    """Halos so narrow that small gases can be cut too, and tiles have to be done again."""
    monkeypatch.setattr(windows, "MARGIN", 1)


def state(gas):
    """All that has to agree to the last bit."""
    counts = gas.counts.pairs, gas.counts.walls, gas.counts.elastic
    return gas.unwrapped, gas.velocities, gas.time, counts


def assert_same(one, other):
    for a, b in zip(state(one), state(other)):
        np.testing.assert_array_equal(a, b)


def mixture(n=300, packing=0.5, seed=3, **rules):
    """Discs of random radii and masses on a square lattice with random velocities."""
    rng = np.random.default_rng(seed)
    radii, masses = rng.uniform(0.2, 0.5, n), rng.uniform(0.1, 5, n)
    side = math.ceil(math.sqrt(n))
    scale = max(1.001, math.sqrt(math.pi * (radii**2).sum() / packing) / side)
    places = (np.stack(np.divmod(np.arange(n), side), axis=1) + 0.5) * scale
    return Gas(
        places, rng.normal(size=(n, 2)), width=side * scale, radius=radii, mass=masses, **rules
    )


def melted(n, packing, impacts=20, **rules):
    """A gas that has forgotten the lattice, and begins to measure."""
    gas = Gas.fluid(n, packing, periodic=rules.pop("periodic", True), **{"seed": 1, **rules})
    gas.run(impacts=impacts * n // 2, tiles=1)
    gas.begin()
    return gas


# --- closed forms -----------------------------------------------------------------------------


@pytest.mark.parametrize("tiles", [None, 1], ids=["plain", "compiled"])
@pytest.mark.parametrize("e", [Fraction(1), Fraction(3, 5), Fraction(0)])
def test_two_discs_as_in_fractions(e, tiles):
    """The line of centres is (3, 4)/5: masses 2 and 3, radii 1 and 1/4, all in fractions."""
    m1, m2 = Fraction(2), Fraction(3)
    u1, u2 = Vector(Fraction(7, 3), Fraction(1, 2)), Vector(Fraction(-1, 5), Fraction(-2))
    c = Vector(Fraction(3, 4), Fraction(1))
    v1, v2 = law.impact(u1, u2, 1 / m1, 1 / m2, c, e)
    at, ahead, then = Vector(Fraction(8), Fraction(9)), Fraction(3, 2), Fraction(1, 2)
    gas = Gas(
        [[float(x) for x in p] for p in (at - u1 * ahead, at + c - u2 * ahead)],
        [[float(x) for x in u] for u in (u1, u2)],
        width=20,
        radius=[1, 0.25],
        mass=[2, 3],
        e=float(e),
    )
    (hit,) = gas.run(float(ahead + then), tiles=tiles, record_impacts=True)
    expected = [[float(x) for x in v] for v in (v1, v2)]
    np.testing.assert_allclose(gas.velocities, expected, rtol=0, atol=1e-13)
    places = [[float(x) for x in p] for p in (at + v1 * then, at + c + v2 * then)]
    np.testing.assert_allclose(gas.positions, places, rtol=0, atol=1e-13)
    assert hit["time"] == pytest.approx(float(ahead), abs=1e-13)
    assert (hit["first"], hit["second"]) == (0, 1)
    impulse = law.impulse(u1, u2, 1 / m1, 1 / m2, c, e)
    for name, vector in (("impulse", impulse), ("u1", u1), ("u2", u2), ("v1", v1), ("v2", v2)):
        assert [hit[f"{name}_x"], hit[f"{name}_y"]] == pytest.approx(
            [float(x) for x in vector], abs=1e-13
        )
    assert [hit["line_x"], hit["line_y"]] == pytest.approx([0.6, 0.8], abs=1e-13)
    assert [hit["x"], hit["y"]] == pytest.approx([8.6, 9.8], abs=1e-13)
    assert hit["e"] == pytest.approx(float(e), abs=1e-13)


@pytest.mark.parametrize("tiles", [None, 1], ids=["plain", "compiled"])
def test_a_disc_in_a_corner(tiles):
    gas = Gas([[2, 5]], [[-1, 2]], width=4, height=8, radius=0.5, e=0.2, e_walls=0.5)
    hits = gas.run(4, tiles=tiles, record_impacts=True)
    # x = 1/2 at 1.5, back at 1/2; y = 7.5 at 1.25, back at 1
    np.testing.assert_allclose(hits["time"], [1.25, 1.5], rtol=0, atol=1e-13)
    assert hits["second"].tolist() == [-4, -1]
    np.testing.assert_allclose(gas.velocities, [[0.5, -1]], rtol=0, atol=1e-13)
    np.testing.assert_allclose(gas.positions, [[1.75, 4.75]], rtol=0, atol=1e-13)
    np.testing.assert_allclose(hits["e"], 0.5)
    assert gas.wall_pressure == pytest.approx((1.5 / 4 / 16, 3 / 4 / 8))


def test_no_collapse_of_two_discs_with_e_0():
    """They stay in contact and go on side by side."""
    rng = np.random.default_rng(5)
    for offset in (*rng.uniform(-0.99, 0.99, 20), 0.0):
        gas = Gas(
            [[3, 5], [6, 5 + offset]],
            [[1, 0.3], rng.normal(size=2) / 9],
            width=16,
            mass=rng.uniform(0.1, 3, 2),
            e=0,
            periodic=True,
        )
        gas.run(30, tiles=1)
        assert gas.deepest_overlap() < 1e-12


@pytest.mark.parametrize(("discs", "impacts"), [(2, 40), (3, 30)])
@pytest.mark.parametrize("tiles", [None, 1], ids=["plain", "compiled"])
@pytest.mark.parametrize("e", [1.0, 0.9])
def test_as_few_discs_go_by_the_other_engine(discs, impacts, tiles, e):
    """Every impact with discs multiplies what rounding leaves by some 2 path / radius, here 10."""
    rng = np.random.default_rng(discs)
    places = [[2, 3], [7, 4], [4.5, 8]][:discs]
    velocities, masses = rng.normal(size=(discs, 2)), rng.uniform(0.5, 2, discs)
    radii = [1.0, 1.25, 0.75][:discs]
    spheres = [
        Sphere(f"S{n}", mass=m, radius=r, position=tuple(p), velocity=tuple(map(float, v)))
        for n, (p, v, m, r) in enumerate(zip(places, velocities, masses, radii))
    ]
    few = simulate(Table.box(9, 10, spheres, e=e), impacts=impacts).events
    gas = Gas(places, velocities, width=9, height=10, radius=radii, mass=masses, e=e)
    many = gas.run(until=float(few["time"][-1]) + 1e-6, tiles=tiles, record_impacts=True)
    pairs = few["second"].astype(str)
    names = {"Left": -1, "Right": -2, "Bottom": -3, "Top": -4, "S1": 1, "S2": 2}
    assert many["second"].tolist() == [names[each] for each in pairs]
    assert [f"S{first}" for first in many["first"]] == few["first"].astype(str).tolist()
    grown = 1e-13 * 10.0 ** np.cumsum(many["second"] >= 0)
    assert grown[len(grown) // 3] < 1e-5  # a third of them, at least, says something
    for name in ("time", "x", "y", "impulse_x", "impulse_y", "v1_x", "v1_y"):
        assert (np.abs(many[name] - few[name]) <= grown).all(), name


# --- the same to the last bit -----------------------------------------------------------------


@pytest.mark.parametrize("periodic", [HARD, PERIODIC, CHANNEL])
@pytest.mark.parametrize("rules", [{}, {"e": 0.8, "contact_time": 0.01}], ids=["e=1", "e<1"])
def test_plain_python_is_the_same(periodic, rules):
    plain, compiled = (mixture(60, periodic=periodic, **rules) for _ in range(2))
    plain.run(2)
    assert plain._engine.plain
    compiled.run(2, tiles=1)
    assert not compiled._engine.plain
    assert plain.impacts > 100
    assert_same(plain, compiled)


GASES = {
    "hard": lambda: Gas.fluid(2000, 0.5, seed=2),
    "periodic": lambda: Gas.fluid(2000, 0.5, seed=2, periodic=True),
    "channel": lambda: Gas.fluid(2000, 0.3, seed=2, periodic=CHANNEL, aspect=3),
    "thin": lambda: Gas.fluid(1500, 0.1, seed=2, periodic=True),
    "dense": lambda: Gas.fluid(1500, 0.75, seed=2, periodic=True),
    "unequal": lambda: mixture(1500, 0.6),
    "unequal, periodic": lambda: mixture(1500, 0.6, periodic=True),
    "lossy": lambda: mixture(1500, 0.6, periodic=True, e=0.7, contact_time=1e-3),
    "lossy, hard": lambda: mixture(1500, 0.3, e=0.9, e_walls=0.5, contact_time=1e-3),
}


@pytest.mark.parametrize("make", GASES.values(), ids=GASES)
def test_tiles_and_threads_are_the_same(make, narrow):
    alone = make()
    impacts = alone.run(2.5, tiles=1, record_impacts=True)
    assert len(impacts) == alone.impacts > 100
    for tiles, threads in ((2, 1), (4, 2), (9, 2), (30, 1)):
        tiled = make()
        seen = tiled.run(2.5, tiles=tiles, threads=threads, record_impacts=True)
        assert tiled.counts.tiles > tiled.counts.windows
        assert_same(alone, tiled)
        np.testing.assert_array_equal(impacts, seen)
        assert tiled.pressure == alone.pressure


@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
@pytest.mark.parametrize("velocities", ["axes", "diagonals"])
def test_ties_are_the_same(periodic, velocities, narrow):
    """A lattice with all speeds equal: any number of impacts at one time, and exactly on edges."""
    side = 32
    places = 2.0 * np.stack(np.divmod(np.arange(side**2), side), axis=1) + 1
    rng = np.random.default_rng(4)
    if velocities == "axes":
        turns = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])[rng.integers(0, 4, side**2)]
    else:
        turns = rng.choice([-1, 1], (side**2, 2))
    alone, *others = (
        Gas(places, turns, width=2 * side, radius=0.5, periodic=periodic) for _ in range(3)
    )
    alone.run(7, tiles=1)
    assert alone.impacts > 1000
    for gas, tiles in zip(others, (4, 12)):
        gas.run(7, tiles=tiles)
        assert gas.counts.tiles > gas.counts.windows
        assert_same(alone, gas)


@pytest.mark.parametrize("per_day", [1.5, 40.0])
def test_full_pages_of_the_calendar_are_the_same(monkeypatch, per_day):
    """What is spilt from a full page waits for its own day."""
    one, other = (mixture(1000, 0.6, periodic=True) for _ in range(2))
    one.run(3, tiles=1)
    monkeypatch.setattr(windows, "PAGE", 4)
    monkeypatch.setattr(windows, "PER_DAY", per_day)
    other.run(3, tiles=1)
    assert one.impacts > 1000
    assert_same(one, other)


def test_cuts_into_runs_are_the_same(narrow):
    whole, cut, seldom = (Gas.fluid(800, 0.4, seed=3, periodic=CHANNEL) for _ in range(3))
    whole.run(10.0)
    for part in (0.3, 0.7, 1e-9, 2.0):
        cut.run(part, tiles=5)
    cut.run(until=10.0, tiles=1)
    seldom.run(impacts=500)
    seldom.begin()
    seldom.run(until=10.0, threads=2)
    assert_same(whole, cut)
    assert_same(whole, seldom)


@pytest.mark.parametrize("tiles", [None, 4])
def test_a_collapse_leaves_the_gas_shortly_before_it(tiles):
    gas = Gas.fluid(3000, 0.3, seed=1, e=0.3)
    with pytest.raises(CollapseError) as caught:
        gas.run(100, tiles=tiles)
    assert caught.value.run is gas
    collapse = float(re.search(r"one time, (.*?) s,", str(caught.value))[1])
    assert collapse - 1e-3 < gas.time <= collapse
    one = Gas.fluid(3000, 0.3, seed=1, e=0.3)
    one.run(until=gas.time, tiles=1)
    assert_same(gas, one)


def test_a_number_of_impacts_is_the_same_however_tiled():
    one, other = (Gas.fluid(1000, 0.4, seed=3, periodic=True) for _ in range(2))
    one.run(impacts=4000)
    other.run(impacts=4000, tiles=6)
    assert one.impacts >= 4000
    assert_same(one, other)


def test_the_order_of_rows_does_not_matter(monkeypatch):
    """Neither that in which discs are given, nor that into which a large gas is put."""
    gas, again = mixture(1200, periodic=True), mixture(1200, periodic=True)
    order = np.random.default_rng(1).permutation(1200)
    mixed = Gas(
        gas.positions[order],
        gas.velocities[order],
        width=gas.box.width,
        radius=gas.radii[order],
        mass=gas.masses[order],
        periodic=True,
    )
    for each in (gas, mixed):
        each.run(until=30, tiles=1)
    np.testing.assert_array_equal(gas.unwrapped[order], mixed.unwrapped)
    np.testing.assert_array_equal(gas.velocities[order], mixed.velocities)
    monkeypatch.setattr(box, "MANY", 1)
    again.run(until=30, tiles=4)
    assert (again._discs.names != np.arange(1200)).any()
    assert_same(gas, again)


@pytest.mark.parametrize("tiles", [None, 5])
def test_from_a_file_on_it_is_the_same(tmp_path, tiles, narrow):
    gas = mixture(400, periodic=CHANNEL, e=0.9, contact_time=1e-3)
    gas.run(until=21)
    gas.begin()
    gas.run(until=23)
    gas.save(tmp_path / "gas.npz")
    other = Gas.load(tmp_path / "gas.npz")
    assert repr(other) == repr(gas)
    for each in (gas, other):
        each.run(until=45, tiles=tiles)
    assert_same(gas, other)
    for name in ("pressure", "rate", "elastic_fraction", "mean_square_displacement", "measured"):
        assert getattr(gas, name) == getattr(other, name), name


def test_interrupted_it_goes_on_to_the_same(monkeypatch):
    whole, broken = (Gas.fluid(500, 0.4, seed=3, periodic=True) for _ in range(2))
    impacts = whole.run(20, tiles=1, record_impacts=True)
    run, passes = windows.Engine.run, 0

    def stopped(engine, until, pause):
        def after_some():
            nonlocal passes
            passes += 1
            if passes == 5:
                raise KeyboardInterrupt
            pause()

        run(engine, until, after_some)

    monkeypatch.setattr(windows.Engine, "run", stopped)
    with pytest.raises(KeyboardInterrupt):
        broken.run(20, tiles=4, record_impacts=True)
    assert 0 < broken.time < 20
    assert broken.deepest_overlap() < 1e-12
    seen = broken.run(until=20, tiles=1, record_impacts=True)
    assert_same(whole, broken)
    np.testing.assert_array_equal(impacts, seen)


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")
def test_ctrl_c_leaves_a_state_to_go_on_from(tmp_path):
    script = textwrap.dedent("""
        import sys
        from restitution.gas import Gas
        gas = Gas.fluid(2000, 0.5, seed=1)
        print("ready", flush=True)
        try:
            gas.run(1e9)
        except KeyboardInterrupt:
            gas.save(sys.argv[1])
            print(gas.impacts)
    """)
    path = tmp_path / "gas.npz"
    with subprocess.Popen(
        [sys.executable, "-c", script, str(path)], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout.readline() == "ready\n"
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(1.5)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=100)
    saved = Gas.load(path)
    assert saved.impacts == int(out) > 0
    again = Gas.fluid(2000, 0.5, seed=1)
    again.run(until=saved.time, tiles=1)
    assert again.impacts == saved.impacts
    np.testing.assert_array_equal(saved.velocities, again.velocities)
    # the time, as one number, is rounded
    np.testing.assert_allclose(saved.unwrapped, again.unwrapped, rtol=0, atol=1e-12)


def test_long_flights_are_rounded_as_short_ones():
    """Across a whole box places still are multiples of the resolution, which makes tiles exact."""
    rng = np.random.default_rng(8)
    for speed in rng.uniform(0.5, 1, 20):
        gas = Gas([[0.9, 0.5]], [[-speed, 1e-3]], width=1, radius=0.01)
        gas.run(1.5, tiles=1)
        place = gas._discs.row[0, :2] / gas.box.resolution
        assert (place == np.round(place)).all()
    # and in a large box, where one disc flies far past all others at rest
    one, other = (
        Gas(
            np.vstack(([[1.0, 1.0]], 4.0 * np.stack(np.divmod(np.arange(900), 30), axis=1) + 3)),
            np.vstack(([[-0.77, 0]], np.zeros((900, 2)))),
            width=130,
            radius=0.4,
            periodic=True,
        )
        for _ in range(2)
    )
    one.run(400, tiles=1)
    other.run(400, tiles=4)
    place = one._discs.row[:, :2] / one.box.resolution
    assert (place == np.round(place)).all()
    assert_same(one, other)


def test_crowds_are_cut_into_more_tiles(monkeypatch, narrow):
    """More discs than a tile's ids can count: more tiles, without end where nothing helps."""
    crowd = Gas.fluid(3000, 0.5, seed=1)
    apart, whole = (
        Gas(crowd.positions, crowd.velocities, width=3 * crowd.box.width) for _ in range(2)
    )
    whole.run(0.5, tiles=1)
    monkeypatch.setattr(windows, "MOST", 1600)
    apart.run(0.5, tiles=1)
    assert apart.counts.tiles > apart.counts.windows
    assert_same(apart, whole)
    monkeypatch.setattr(windows, "MOST", 3)
    with pytest.raises(UnsupportedError, match="too close together"):
        Gas.fluid(700, 0.5, seed=1).run(1, tiles=1)


# --- what is conserved ------------------------------------------------------------------------


@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
def test_energy_and_momentum_after_ten_thousand_impacts_a_disc(periodic):
    gas = mixture(60, 0.6, periodic=periodic)
    energy, momentum = gas.kinetic_energy, gas.momentum
    gas.run(impacts=60 * 6_000, tiles=1)  # those of two discs are impacts of both
    assert 2 * gas.counts.pairs + gas.counts.walls >= 60 * 10_000
    assert gas.kinetic_energy == pytest.approx(energy, rel=1e-12, abs=0)
    if periodic:
        size = math.sqrt(2 * energy * gas.masses.sum())
        np.testing.assert_allclose(gas.momentum, momentum, rtol=0, atol=1e-12 * size)
    assert gas.deepest_overlap() < 1e-12


@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
def test_time_can_be_turned_round(periodic):
    """Rounding of 1e-16 grows some fivefold with each impact of a disc at this packing.

    So six impacts a disc forth and six back leave some eight figures of the start at the worst.
    """
    gas = Gas.fluid(200, 0.3, seed=6, periodic=periodic)
    gas.run(impacts=2000)
    start, velocities, then = gas.positions, gas.velocities, gas.time
    each = 2 * gas.rate / len(gas)
    errors = []
    for impacts in (1, 6):
        for _ in range(2):
            gas.run(impacts / each)
            gas.reverse()
        apart = gas.positions - start
        if periodic:
            apart -= gas.box.width * np.round(apart / gas.box.width)
        errors.append(np.abs(apart).max())
        assert np.abs(gas.velocities - velocities).max() < 100 * errors[-1]
    assert then < gas.time
    assert errors[0] < 1e-11 and errors[1] < 1e-7


@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
@pytest.mark.parametrize("packing", [0.1, 0.5, 0.75])
def test_no_overlap_ever(periodic, packing):
    equal = Gas.fluid(400, packing, periodic=periodic, seed=1)
    for gas in (equal, mixture(400, min(packing, 0.5), periodic=periodic)):
        for _ in range(60):
            gas.run(impacts=700, tiles=1)
            assert gas.deepest_overlap() < 1e-12
            if not periodic:
                inside = np.minimum(gas.positions, gas.box.width - gas.positions)
                assert (inside.min(axis=1) - gas.radii).min() > -1e-12


@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
@pytest.mark.parametrize("make", [lambda **how: Gas.fluid(300, 0.6, seed=1, **how), mixture])
def test_at_impacts_discs_just_touch(periodic, make):
    """At any other time the least gap says little."""
    gas, again = (make(periodic=periodic) for _ in range(2))
    hits = gas.run(impacts=3000, tiles=1, record_impacts=True)
    for time in hits["time"][hits["second"] >= 0][-1000::10]:
        again.run(until=float(time), tiles=1)
        assert abs(again.deepest_overlap()) < 1e-12


@settings(max_examples=100, deadline=None)
@given(strategies.gases())
def test_any_small_gas(case):
    gas, again = (Gas(**case) for _ in range(2))
    energy, momentum = gas.kinetic_energy, gas.momentum
    for _ in range(3):
        try:
            gas.run(2.0, tiles=1)
        except CollapseError:
            assert case["e"] < 1 or case["e_walls"] < 1
            break
        assert gas.deepest_overlap() < 1e-12
        assert gas.kinetic_energy <= energy * (1 + 1e-12)
        energy = gas.kinetic_energy
        if case["periodic"] == (True, True):
            np.testing.assert_allclose(gas.momentum, momentum, rtol=0, atol=1e-11)
    again.run(until=gas.time, tiles=3)
    assert_same(gas, again)


@pytest.mark.parametrize("light", [1.0, 0.01, 1e-4])
def test_touching_discs_without_loss_are_no_collapse(light):
    """A light disc between two heavy ones, all touching: as often as a wedge is folded up into π.

    In coordinates √m x the discs are a point between two planes, at the angle arccos M/(M + m).
    """
    heavy = 100.0
    places, velocities = [(1, 2), (2, 2), (3, 2)], [(1, 0), (0, 0), (0, 0)]
    gas = Gas(places, velocities, width=8, mass=[heavy, light, heavy])
    gas.run(0.5, tiles=1)
    assert gas.impacts == math.ceil(math.pi / math.acos(heavy / (heavy + light))) - 1
    assert gas.kinetic_energy == pytest.approx(heavy / 2, rel=1e-12)


# --- collapse ---------------------------------------------------------------------------------


@pytest.mark.parametrize("tiles", [None, 1, 4])
@pytest.mark.parametrize("periodic", [HARD, PERIODIC])
def test_collapse_is_told(tiles, periodic):
    gas = Gas.fluid(1200, 0.4, e=0.5, seed=1, periodic=periodic)
    with pytest.raises(CollapseError, match="collapses") as caught:
        gas.run(1000, tiles=tiles)
    assert "contact_time" in str(caught.value)
    assert caught.value.run is gas
    assert 0 < gas.time < 1000 and gas.impacts > 1200
    assert gas.deepest_overlap() < 1e-12
    again = Gas.fluid(1200, 0.4, e=0.5, seed=1, periodic=periodic)
    again.run(until=gas.time, tiles=1)
    np.testing.assert_array_equal(gas.velocities, again.velocities)
    # the time, as one number, is rounded
    np.testing.assert_allclose(gas.unwrapped, again.unwrapped, rtol=0, atol=1e-12)
    with pytest.raises(CollapseError):
        gas.run(1000, tiles=tiles)


def test_contact_time_avoids_it():
    gas = Gas.fluid(1200, 0.4, e=0.5, seed=1, periodic=True, contact_time=1e-3)
    energy = gas.kinetic_energy
    gas.run(impacts=60_000)
    assert gas.kinetic_energy < energy / 10
    assert 0 < gas.elastic_fraction < 1
    assert gas.deepest_overlap() < 1e-12
    always = Gas.fluid(300, 0.4, e=0.5, seed=1, periodic=True, contact_time=1e9)
    always.run(impacts=3000, tiles=3)
    # every impact but the first ones of a pair
    assert 1 - 300 / 3000 <= always.elastic_fraction < 1
    assert Gas.fluid(300, 0.4, seed=1).elastic_fraction == 0


# --- physics ----------------------------------------------------------------------------------


def henderson(packing):
    """P A / (N k T) of hard discs: D. Henderson, Molecular Physics 30 (1975)."""
    return (1 + packing**2 / 8) / (1 - packing) ** 2


def compressibility(gas):
    return gas.pressure * gas.box.width * gas.box.height / gas.kinetic_energy


def luding(packing):
    """What was fitted to simulations: S. Luding, Physical Review E 63 (2001), 042201."""
    dense = (1 - 7 * packing / 16) / (1 - packing) ** 2
    return dense - packing**3 / 16 / (8 * (1 - packing) ** 4)


@pytest.mark.parametrize(
    ("packing", "known"),
    # Henderson's own error, towards too high a pressure. What the run adds is within 0.4 %.
    [(0.1, 0.001), (0.2, 0.001), (0.3, 0.001), (0.4, 0.002), (0.5, 0.004), (0.6, 0.012)],
)
def test_pressure_is_hendersons_and_rate_is_enskogs(packing, known):
    n = 1024
    gas = melted(n, packing, impacts=100)
    gas.run(impacts=500 * n, tiles=1)
    deviation = compressibility(gas) / henderson(packing) - 1
    assert -known - 0.004 < deviation < 0.004
    assert compressibility(gas) == pytest.approx(1 + 2 * packing * luding(packing), rel=0.005)
    # by Enskog the rate has the factor of the pressure
    enskog = 4 * packing * luding(packing) * math.sqrt(gas.kinetic_energy / n / math.pi)
    assert gas.rate / n == pytest.approx(enskog, rel=0.01)


@pytest.mark.parametrize("packing", [0.1, 0.4])
def test_walls_feel_the_pressure(packing):
    """Centres have the box less a diameter to be in: a correction of the first order."""
    gas = melted(1500, packing, periodic=HARD)
    gas.run(impacts=150_000, tiles=1)
    side = gas.box.width
    assert gas.wall_pressure[0] == pytest.approx(gas.wall_pressure[1], rel=0.03)
    ideal = gas.kinetic_energy / side**2
    assert sum(gas.wall_pressure) / 2 == pytest.approx(henderson(packing) * ideal, rel=4 / side)
    periodic = Gas.fluid(100, 0.2, periodic=CHANNEL, seed=1)
    periodic.run(impacts=500)
    assert math.isnan(periodic.wall_pressure[0]) and periodic.wall_pressure[1] > 0


def test_speeds_are_rayleighs():
    """Kolmogorov and Smirnov: P(v < V) = 1 − exp(−m V² / 2 k T)."""
    n = 4000
    rng = np.random.default_rng(3)
    gas = Gas.fluid(n, 0.3, periodic=True, seed=2)
    # all of one speed, to begin with
    angles = rng.uniform(0, 2 * np.pi, n)
    gas = Gas(
        gas.positions,
        np.stack((np.cos(angles), np.sin(angles)), axis=1),
        width=gas.box.width,
        height=gas.box.height,
        periodic=True,
    )

    def distance():
        v = np.sort(np.hypot(*gas.velocities.T))
        # rounded within 1e-12, so that equal speeds are one step
        expected = 1 - np.exp(-(v**2) / (2 * gas.kinetic_energy / n))
        above = np.arange(1, n + 1) / n - expected
        return max(above.max(), (1 / n - above).max())

    assert distance() > 0.3
    gas.run(impacts=20 * n)
    assert distance() < 1.95 / math.sqrt(n)  # once in a thousand it would be more
    edges, density = gas.speeds(40)
    assert (density * np.diff(edges)).sum() == pytest.approx(1)
    assert edges[np.argmax(density)] == pytest.approx(math.sqrt(gas.kinetic_energy / n), abs=0.3)


@pytest.mark.parametrize("e", [0.9, 0.95])
def test_it_cools_as_haff_says(e):
    """1/√T grows linearly, by (1 − e²)/4 of the impacts of a disc in the time 1/√T sets.

    P. K. Haff, J. Fluid Mech. 134 (1983). An impact of two loses (1 − e²) m g²/4, with a mean
    square approach g² of 4 k T/m: so dT/dt = −(1 − e²) ν T/2 for ν impacts of a disc in a second.
    """
    n, packing = 4000, 0.1
    gas = melted(n, packing)
    velocities, side = gas.velocities, (gas.box.width, gas.box.height)
    gas = Gas(gas.positions, velocities, width=side[0], height=side[1], periodic=True, e=e)
    dense = (1 - 7 * packing / 16) / (1 - packing) ** 2
    times, slow = [0.0], [math.sqrt(n / gas.kinetic_energy)]
    for _ in range(8):
        gas.run(impacts=n)  # two impacts of each disc
        times.append(gas.time)
        slow.append(math.sqrt(n / gas.kinetic_energy))
    rate_over_speed = 8 * packing / math.sqrt(math.pi) * dense
    slope = (1 - e**2) / 4 * rate_over_speed
    fitted = np.polyfit(times, slow, 1)[0]
    assert fitted == pytest.approx(slope, rel=0.04)
    line = np.polyval(np.polyfit(times, slow, 1), times)
    np.testing.assert_allclose(slow, line, rtol=0.02)


def test_displacements_and_equipartition():
    gas = melted(2000, 0.05)
    speed2 = 2 * gas.kinetic_energy / len(gas)
    time = 0.01 / math.sqrt(speed2)
    gas.run(time)
    assert gas.mean_square_displacement == pytest.approx(speed2 * time**2, rel=0.01)
    gas.run(until=gas.time + 200)
    assert gas.mean_square_displacement < speed2 * gas.measured**2 / 4

    rng = np.random.default_rng(2)
    n = 2000
    start = Gas.fluid(n, 0.3, seed=1)
    heavy = rng.random(n) < 0.5
    # all the energy is that of the light ones
    gas = Gas(
        start.positions,
        rng.normal(size=(n, 2)) * ~heavy[:, None],
        width=start.box.width,
        height=start.box.height,
        mass=np.where(heavy, 5.0, 1.0),
    )
    gas.run(impacts=60 * n)
    energies = gas.masses * (gas.velocities**2).sum(axis=1) / 2
    assert energies[heavy].mean() == pytest.approx(energies[~heavy].mean(), rel=0.15)


# --- what comes out and what is refused -------------------------------------------------------


def test_tables_go_to_files_and_back(tmp_path):
    import pandas as pd  # a second, in every process that collects tests
    import polars as pl

    gas = mixture(50, periodic=CHANNEL)
    impacts = gas.run(3, record_impacts=True)
    assert impacts.dtype == package.IMPACT
    assert (np.diff(impacts["time"]) >= 0).all()
    snapshot = gas.snapshot()
    np.testing.assert_array_equal(snapshot["vx"], gas.velocities[:, 0])
    for table in (impacts, snapshot):
        package.write(table, tmp_path / "table.npz")
        with np.load(tmp_path / "table.npz") as file:
            np.testing.assert_array_equal(file["table"], table)
        package.write(table, tmp_path / "table.parquet")
        for frame in (
            pd.read_parquet(tmp_path / "table.parquet"),
            pl.read_parquet(tmp_path / "table.parquet"),
            pd.DataFrame(table),
            pl.from_numpy(table),
        ):
            assert list(frame.columns) == list(table.dtype.names)
            for name in table.dtype.names:
                np.testing.assert_array_equal(frame[name].to_numpy(), table[name])
    assert Gas.fluid(3, 0.01, seed=1).run(1e-9, record_impacts=True).dtype == package.IMPACT
    with pytest.raises(StatementError, match=r"table\.csv has to end in"):
        package.write(impacts, tmp_path / "table.csv")


ONE = {"positions": [[2, 2]], "velocities": [[1, 0]], "width": 9}
TWO = {"positions": [[2, 2], [5, 5]], "velocities": [[1, 0], [0, 1]], "width": 9}


@pytest.mark.parametrize(
    ("case", "error", "message"),
    [
        ({"width": 1e40}, ImpossibleError, "too large for discs of radius 0.5"),
        ({"width": 1e-70}, StatementError, "width: 1e-70 is beyond what is reckoned with"),
        ({"positions": []}, StatementError, "at least one disc"),
        ({"positions": 3}, StatementError, "at least one disc"),
        ({"positions": [[1, 2], [3, "four"]]}, StatementError, "positions has to be numbers"),
        ({"positions": [[2, 2, 2], [5, 5, 5]]}, StatementError, r"positions has the shape \(2, 3"),
        ({"velocities": [[1, 0]]}, StatementError, r"velocities has the shape \(1, 2\), but 2"),
        ({"radius": [0.5] * 3}, StatementError, r"radius has the shape \(3,\), but 2"),
        ({"velocities": [[1, 0], [0, math.nan]]}, StatementError, "velocities of disc 1 is"),
        ({"mass": [math.inf, 1]}, StatementError, "mass of disc 0 is inf"),
        (
            {"velocities": [[1e200, 0], [0, 0]]},
            StatementError,
            "velocities: 1e\\+200 is beyond what is reckoned with",
        ),
        ({"mass": [1, 0]}, ImpossibleError, "mass of disc 1 is 0; it has to be positive"),
        ({"radius": -1}, ImpossibleError, "radius of disc 0 is -1"),
        ({"width": 0}, ImpossibleError, "width of the box is 0"),
        ({"height": math.nan}, ImpossibleError, "height of the box is nan"),
        ({"radius": 2.5}, ImpossibleError, "disc 0 at x = 2 with radius 2.5 reaches 0.5 beyond"),
        ({"positions": [[2, 2], [8.9, 5]]}, ImpossibleError, "disc 1 at x = 8.9"),
        ({"positions": [[2, 2], [2.5, 2]]}, ImpossibleError, "discs 0 and 1 overlap by 0.5"),
        ({"e": 1.1}, ImpossibleError, "e is 1.1; it has to be from 0 to 1"),
        ({"e": math.nan}, ImpossibleError, "e is nan"),
        ({"e_walls": -0.5}, ImpossibleError, "e_walls is -0.5"),
        ({"e": "half"}, StatementError, "e has to be numbers, not 'half'"),
        ({"width": [9]}, StatementError, r"width is one number, not \[9\]"),
        ({"periodic": "xy"}, StatementError, "periodic is True, False or a pair of them"),
        ({"periodic": (True, False, True)}, StatementError, "a pair of them, not"),
        ({"contact_time": -1}, ImpossibleError, "contact_time is -1"),
        ({"width": 7, "radius": 1, "periodic": True}, ImpossibleError, "more than 4 diameters, 8"),
    ],
)
def test_what_cannot_be_is_refused(case, error, message):
    with pytest.raises(error, match=message):
        Gas(**{**TWO, **case})


def test_through_a_periodic_wall_discs_overlap_too():
    with pytest.raises(ImpossibleError, match=r"overlap by 0\.5"):
        Gas([[0.25, 2], [8.75, 2]], np.zeros((2, 2)), width=9, periodic=(True, False), radius=0.5)


@pytest.mark.parametrize(
    ("case", "message"),
    [
        ({"packing": 0.95}, "packing of 0.95"),
        ({"packing": 0}, "packing is 0; it has to be positive"),
        ({"packing": 0.1, "temperature": math.inf}, "temperature is inf"),
        ({"packing": 0.1, "radius": -1}, "radius is -1"),
    ],
)
def test_fluids_that_cannot_be(case, message):
    with pytest.raises(ImpossibleError, match=message):
        Gas.fluid(100, **case)
    with pytest.raises(StatementError, match=r"whole number, not 2\.5"):
        Gas.fluid(2.5, 0.1)
    with pytest.raises(StatementError, match="packing has to be numbers"):
        Gas.fluid(3, "thin")
    with pytest.raises(StatementError, match="seed is -1: "):
        Gas.fluid(3, 0.1, seed=-1)


@pytest.mark.parametrize(
    ("case", "message"),
    [
        ({}, "say one of duration"),
        ({"duration": 1, "impacts": 3}, "say one of duration"),
        ({"duration": -1}, "the end is at -1, but it is 0 s already"),
        ({"until": math.nan}, "the end is at nan"),
        ({"duration": "long"}, "duration has to be numbers, not 'long'"),
        ({"impacts": -1}, "the number of impacts is -1; it has to be at least 0"),
        ({"impacts": 1.5}, "the number of impacts is a whole number"),
        ({"duration": 1, "threads": 0}, "the number of threads is 0"),
        ({"duration": 1, "tiles": -3}, "the number of tiles is -3"),
    ],
)
def test_runs_that_cannot_be(case, message):
    with pytest.raises(StatementError, match=message):
        Gas(**ONE).run(**case)


def test_other_files_are_refused(tmp_path):
    gas = Gas(**TWO)
    with pytest.raises(StatementError, match=r"gas\.txt has to end in \.npz"):
        gas.save(tmp_path / "gas.txt")
    with pytest.raises(StatementError, match=r"none\.npz is no saved gas"):
        Gas.load(tmp_path / "none.npz")
    (tmp_path / "text.npz").write_text("no gas at all")
    with pytest.raises(StatementError, match=r"text\.npz is no saved gas"):
        Gas.load(tmp_path / "text.npz")
    np.save(tmp_path / "array.npy", np.zeros(3))
    with pytest.raises(StatementError, match=r"array\.npy is no saved gas"):
        Gas.load(tmp_path / "array.npy")
    package.write(gas.snapshot(), tmp_path / "table.npz")
    with pytest.raises(StatementError, match=r"table\.npz is no saved gas"):
        Gas.load(tmp_path / "table.npz")


def test_without_numba(monkeypatch):
    """Small runs do without; long ones say what is missing."""
    monkeypatch.setitem(sys.modules, "numba", None)
    windows.compiled.cache_clear()
    try:
        gas = Gas.fluid(30, 0.2, seed=1)
        gas.run(impacts=200)
        with pytest.raises(UnsupportedError, match=r"needs Numba.*restitution\[fast\]"):
            gas.run(impacts=10_000)
        assert gas.impacts >= 200
        gas.run(impacts=10)
    finally:
        windows.compiled.cache_clear()


def test_nothing_that_moves_and_one_that_does():
    still = Gas([[2, 2], [5, 5]], np.zeros((2, 2)), width=9)
    still.run(100, tiles=1)
    assert (still.time, still.impacts, still.pressure) == (100, 0, 0)
    assert "Gas of 2 discs" in repr(still)
    alone = Gas([[2, 2]], [[1, 0.5]], width=9, periodic=True)
    alone.run(1000)
    np.testing.assert_allclose(alone.unwrapped, [[1002, 502]], rtol=0, atol=1e-9)
    assert len(alone) == 1 and alone.packing == pytest.approx(math.pi / 4 / 81)


def test_progress_is_shown(capsys, monkeypatch):
    monkeypatch.setenv("FORCE_COLOR", "1")  # as on a terminal
    Gas.fluid(50, 0.2, seed=1).run(impacts=100, progress=True)
    assert "impacts" in capsys.readouterr().err
