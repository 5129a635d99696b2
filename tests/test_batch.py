"""Many impacts at once: as the law has them one by one, however they are worked out."""

from __future__ import annotations

import subprocess
import sys
from fractions import Fraction

import array_api_strict
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution import ImpossibleError, StatementError, UnsupportedError, impacts, law
from restitution.batch import impacts as batch
from restitution.vector import Vector

VECTORS, SCALARS = ("u1", "u2", "c"), ("w1", "w2", "e")
MANY = batch.LARGE + 3  # with some left over from steps of eight


def made_up(count: int, seed: int = 0) -> dict[str, np.ndarray]:
    """Doubles that lie on a grid, so that sums and products of a few have no rounding to hide."""
    rng = np.random.default_rng(seed)
    data = {name: rng.integers(-999, 1000, (count, 2)) / 64 for name in VECTORS}
    data["c"][(data["c"] == 0).all(axis=1)] = 1
    data["w1"], data["w2"] = (rng.integers(1, 1000, count) / 32 for _ in range(2))
    data["w2"][::3], data["u2"][::3] = 0, 0  # walls
    data["e"] = rng.integers(0, 65, count) / 64
    return data


def exactly(data: dict[str, np.ndarray], row: int) -> tuple[Vector, Vector]:
    """One row by the law, in fractions."""
    u1, u2, c = (Vector(*map(Fraction, data[name][row])) for name in VECTORS)
    w1, w2, e = (Fraction(data[name][row]) for name in SCALARS)
    return law.impact(u1, u2, w1, w2, c, e)


def assert_same(one: tuple, two: tuple) -> None:
    for left, right in zip(one, two, strict=True):
        np.testing.assert_array_equal(left, right)


@pytest.fixture
def small(monkeypatch):
    """Batches of any size go through the kernel."""
    monkeypatch.setattr(batch, "LARGE", 1)


# --- right ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("large", [1, 10**9], ids=["kernel", "numpy"])
def test_as_the_law_in_fractions(large, monkeypatch):
    monkeypatch.setattr(batch, "LARGE", large)
    data = made_up(203)
    v1, v2 = impacts(**data)
    for row in range(203):
        exact = exactly(data, row)
        scale = max(abs(float(each)) for each in (*exact[0], *exact[1], 1))
        got = [*v1[row], *v2[row]]
        for value, wanted in zip(got, (*exact[0], *exact[1]), strict=True):
            assert abs(Fraction(value) - wanted) <= Fraction(1, 10**13) * Fraction(scale), row


def test_fractions_stay_exact():
    data = made_up(20)
    v1, v2 = impacts(**{name: np.vectorize(Fraction)(each) for name, each in data.items()})
    assert v1.dtype == object
    assert [(Vector(*v1[row]), Vector(*v2[row])) for row in range(20)] == [
        exactly(data, row) for row in range(20)
    ]


def test_principles_hold_in_a_large_batch():
    """Momentum, Newton's experimental law and what does not change, none of them as the law."""
    data = made_up(MANY, seed=1)
    u1, u2, c, w1, w2, e = data.values()
    v1, v2 = impacts(**data)
    unit = c / np.hypot(c[:, 0], c[:, 1])[:, None]
    across = unit[:, ::-1] * (-1, 1)
    scale = 1e-13 * (1 + np.abs(np.hstack([u1, u2, v1, v2])).max())
    for u, v in (u1, v1), (u2, v2):
        assert np.abs(((v - u) * across).sum(axis=1)).max() < scale
    approach, separation = (((x - y) * unit).sum(axis=1) for x, y in ((u1, u2), (v2, v1)))
    assert np.abs(separation - e * approach).max() < scale
    both = w2 > 0
    change_1, change_2 = ((v - u) / w[:, None] for u, v, w in ((u1, v1, w1), (u2, v2, w2 + ~both)))
    assert np.abs((change_1 + change_2)[both]).max() < 32 * scale  # the heaviest has 32 kg
    assert (v2[~both] == u2[~both]).all()
    still = made_up(MANY, seed=1) | {"e": 1.0}
    w1, w2 = impacts(**still)
    mass_1, mass_2 = 1 / data["w1"][both], 1 / data["w2"][both]
    energies = [
        (mass_1 * (one[both] ** 2).sum(axis=1) + mass_2 * (two[both] ** 2).sum(axis=1)) / 2
        for one, two in ((u1, u2), (w1, w2))
    ]
    np.testing.assert_allclose(*energies, rtol=1e-12)


# --- the same, whatever works it out -------------------------------------------------------------


def test_kernel_gives_the_same_bits(monkeypatch):
    rng = np.random.default_rng(2)
    data = {name: rng.normal(size=(MANY, 2)) for name in VECTORS}
    data |= {name: rng.random(MANY) for name in SCALARS}
    compiled = [impacts(**data, threads=threads) for threads in (1, 2, 3)]
    monkeypatch.setattr(batch, "LARGE", 10**9)
    plain = impacts(**data)
    for each in compiled:
        assert_same(each, plain)


@settings(max_examples=60, deadline=None)
@given(
    count=st.integers(1, 40),
    single=st.sets(st.sampled_from(VECTORS + SCALARS)),
    gaps=st.sets(st.sampled_from(VECTORS + SCALARS)),
    threads=st.integers(1, 5),
)
def test_broadcast_and_scattered_data(count, single, gaps, threads):
    """What is given once is the same in every row; data with gaps are as good as without."""
    data = made_up(count)
    full = {n: np.broadcast_to(x[0], x.shape) if n in single else x for n, x in data.items()}
    given_ = {n: x[0] if n in single else x for n, x in data.items()}
    for name in gaps - single:
        given_[name] = np.repeat(data[name], 2, axis=0)[::2]
    with pytest.MonkeyPatch.context() as patch:
        plain = impacts(**full)
        patch.setattr(batch, "LARGE", 1)
        got = impacts(**given_, threads=threads)
    if single != {*VECTORS, *SCALARS}:
        assert_same(got, plain)
    else:
        assert_same(got, tuple(each[0] for each in plain))


def test_more_axes(small):
    data = {name: each.reshape(4, 5, *each.shape[1:]) for name, each in made_up(20).items()}
    data["e"] = data["e"][:, :1]
    flat = {
        name: np.broadcast_to(each, (4, 5)).ravel()
        for name, each in data.items()
        if name in SCALARS
    }
    flat |= {name: data[name].reshape(20, 2) for name in VECTORS}
    v1, v2 = impacts(**data)
    assert v1.shape == v2.shape == (4, 5, 2)
    assert_same((v1.reshape(20, 2), v2.reshape(20, 2)), impacts(**flat))


def test_chunks_of_numpy(monkeypatch):
    data = {name: each.reshape(8, 25, *each.shape[1:]) for name, each in made_up(200).items()}
    whole = impacts(**data)
    monkeypatch.setattr(batch, "CHUNK", 60)
    assert_same(impacts(**data), whole)


@pytest.mark.parametrize("large", [1, 10**9], ids=["kernel", "numpy"])
def test_no_rows(large, monkeypatch):
    monkeypatch.setattr(batch, "LARGE", large)
    v1, v2 = impacts(np.empty((0, 2)), (0, 0), (1, 0), 1, 0, 1)
    assert v1.shape == v2.shape == (0, 2)


def test_types():
    one = np.array([[3, -4]])
    assert impacts(one, (2, 3), (0, 1), 1, 1, 1)[0].dtype == np.float64
    single = one.astype(np.float32)
    assert impacts(single, single, single, 1, 0, 0.5)[0].dtype == np.float32
    swapped = one.astype(">f8")
    assert_same(impacts(swapped, (2, 3), (0, 1), 1, 1, 1), impacts(one, (2, 3), (0, 1), 1, 1, 1))


# --- out -----------------------------------------------------------------------------------------


def test_results_go_where_they_should(small):
    data = made_up(50)
    fresh = impacts(**data)
    out = np.empty((50, 2)), np.empty((50, 2))
    got = impacts(**data, out=out)
    assert got is out
    assert_same(out, fresh)
    wide = np.zeros((50, 5))
    impacts(**data, out=(wide[:, :2], wide[:, 3:]))
    assert_same((wide[:, :2], wide[:, 3:]), fresh)
    assert (wide[:, 2] == 0).all()


@pytest.mark.parametrize("large", [1, 10**9], ids=["kernel", "numpy"])
@pytest.mark.parametrize("names", [("u1", "u2"), ("u2", "u1"), ("c", "u1")])
def test_results_over_data(large, names, monkeypatch):
    monkeypatch.setattr(batch, "LARGE", large)
    monkeypatch.setattr(batch, "CHUNK", 16)
    data = made_up(50)
    fresh = impacts(**data)
    assert_same(impacts(**data, out=tuple(data[name] for name in names)), fresh)
    data = made_up(51)
    fresh = impacts(**data)
    longer = np.vstack([data["u1"][:1], data["u1"]])
    data["u1"] = longer[1:]
    assert_same(impacts(**data, out=(longer[:-1], data["u2"])), fresh)  # a row further up


def test_out_that_does_not_fit():
    data = made_up(5)
    right = np.empty((5, 2))
    for wrong, told in (
        (np.empty((4, 2)), r"out has shape \(4, 2\)"),
        (np.empty((5, 2), int), "holds int64"),
        (right, "share memory"),
    ):
        with pytest.raises(StatementError, match=told):
            impacts(**data, out=(right, wrong))
    with pytest.raises(StatementError, match="written"):
        impacts(**data, out=(right, np.broadcast_to(0.0, (5, 2))))


# --- what cannot be ------------------------------------------------------------------------------


@pytest.mark.parametrize("large", [1, 10**9], ids=["kernel", "numpy"])
@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("e", 1.25, r"row 17: e = 1.25: .* \[0, 1\]"),
        ("e", -0.5, "row 17: e = -0.5"),
        ("e", np.nan, "row 17: e = nan"),
        ("w1", -1, "row 17: w1 = -1"),
        ("w2", np.inf, "row 17: w2 = inf"),
        ("w2", np.nan, "row 17: w2 = nan"),
        ("c", (0, 0), "row 17: c = .*no direction"),
        ("c", (np.nan, 1), "row 17: c = "),
        ("c", (1e200, 0), "row 17: c = "),
    ],
)
def test_what_cannot_be_is_named_with_its_row(large, name, value, told, monkeypatch):
    monkeypatch.setattr(batch, "LARGE", large)
    monkeypatch.setattr(batch, "CHUNK", 10)
    data = made_up(41)
    data[name][[17, 30]] = value
    with pytest.raises(ImpossibleError, match=told):
        impacts(**data)
    data = made_up(41)  # left over from the steps of eight
    data[name][40] = value
    with pytest.raises(ImpossibleError, match=told.replace("17", "40")):
        impacts(**data)


def test_every_row_is_asked(small):
    for row in range(24):
        data = made_up(24)
        data["e"][row] = 2
        with pytest.raises(ImpossibleError, match=f"^row {row}: e = 2"):
            impacts(**data, threads=2)


def test_two_fixed_bodies():
    with pytest.raises(ImpossibleError, match=r"^w1 = w2 = 0"):
        impacts((1, 0), (0, 0), (1, 0), 0, 0, 1)
    rows = np.zeros((3, 4))
    with pytest.raises(ImpossibleError, match=r"^row 0, 0: w1 = w2 = 0"):
        impacts((1, 0), (0, 0), (1, 0), rows, 0, 1)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"u1": np.zeros((4, 3))}, r"u1 has shape \(4, 3\): a vector has two components"),
        ({"c": 1.0}, r"c has shape \(\)"),
        ({"w1": np.ones(3)}, r"do not fit each other: u1 \(4, 2\).* w1 \(3,\)"),
        ({"e": np.ones((4, 1))}, None),  # four by four: as NumPy broadcasts
        ({"u2": [[1, 2], [3]]}, "u2 is not an array"),
        ({"w2": "heavy"}, "w2 holds <U5, not real numbers"),
        ({"e": 1j}, "e holds complex128"),
        ({"threads": 0}, "threads = 0"),
        ({"threads": 1.5}, "threads is a whole number, not 1.5"),
        ({"out": (np.zeros(2),)}, "out is a pair of NumPy arrays"),
    ],
)
def test_what_is_not_understood(change, told):
    data = made_up(4) | change
    if told is None:
        assert impacts(**data)[0].shape == (4, 4, 2)
        return
    with pytest.raises(StatementError, match=told):
        impacts(**data)


# --- other libraries -----------------------------------------------------------------------------


def of_dask(x: np.ndarray) -> object:
    import dask.array  # two seconds, in every process that collects tests

    return dask.array.from_array(x, chunks=7)


@pytest.mark.parametrize("once", [(), ("u2", "w2", "e"), ("c", "w1")])
@pytest.mark.parametrize("make", [of_dask, array_api_strict.asarray])
def test_arrays_of_other_libraries(make, once):
    data = made_up(20)
    kind = type(make(np.ones(2)))
    data |= {name: data[name][0].tolist() for name in once}
    theirs = {name: each if name in once else make(each) for name, each in data.items()}
    got = impacts(**theirs)
    assert all(isinstance(each, kind) and each.shape == (20, 2) for each in got)
    assert_same(tuple(np.asarray(each) for each in got), impacts(**data))
    with pytest.raises(UnsupportedError, match="out"):
        impacts(**theirs, out=(np.empty((20, 2)), np.empty((20, 2))))
    with pytest.raises(StatementError, match="do not fit"):
        impacts(**theirs | {"w1": make(np.ones(3))})


# --- light ---------------------------------------------------------------------------------------


def test_small_batches_wait_for_no_compiler():
    code = """
import sys, numpy as np
from restitution import impacts
impacts(np.ones((99_000, 2)), (0, 0), (1, 0), 1, 0, 1)
assert "numba" not in sys.modules and "sympy" not in sys.modules
impacts(np.ones((100_000, 2)), (0, 0), (1, 0), 1, 0, 1)
assert "numba" in sys.modules and "sympy" not in sys.modules
"""
    subprocess.run([sys.executable, "-W", "error", "-c", code], check=True, timeout=120)


def test_without_the_compiler(monkeypatch):
    data = made_up(MANY)
    compiled = impacts(**data)
    monkeypatch.setattr(batch, "find_spec", lambda name: None)
    assert_same(impacts(**data), compiled)
