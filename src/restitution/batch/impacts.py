"""Many impacts at once, each a row of arrays.

>>> import numpy as np
>>> from restitution import impacts
>>> u1 = np.array([[3.0, -4.0], [1.0, 2.5]])
>>> v1, v2 = impacts(u1, (2, 3), (0, 1), 0.5, 0.5, [0.5, 1])
>>> v1
array([[3.  , 1.25],
       [1.  , 3.  ]])

Every kind of array goes through the law of impact as it stands. Large batches of doubles are
worked out by a kernel that is compiled from the same lines and gives the same numbers, bit by bit,
as fast as memory delivers them; it needs the extra ``fast``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from typing import Any, NoReturn

import numpy as np
import numpy.typing as npt

from restitution import law
from restitution.batch.possible import possible
from restitution.errors import ImpossibleError, StatementError, UnsupportedError
from restitution.vector import Vector

LARGE = 100_000
"""From so many impacts on the compiled kernel is worth the half second that loading it takes."""

CHUNK = 8_192
"""How many impacts NumPy works out at a time, so that what lies between stays in the cache."""

_NAMES = ("u1", "u2", "c", "w1", "w2", "e")
_VECTORS = 3  # so many of them, from the left
_KERNEL = 8  # rows that the kernel takes at a time
_ROW = 16  # bytes of a row of the results, which it wants at multiples of that
_LINE = 64  # bytes of a line of the cache

_Array = npt.NDArray[Any]


def impacts(
    u1: Any,
    u2: Any,
    c: Any,
    w1: Any,
    w2: Any,
    e: Any,
    *,
    out: tuple[_Array, _Array] | None = None,
    threads: int = 1,
) -> tuple[Any, Any]:
    """The velocities just after many impacts, as a pair of arrays (v1, v2), in m/s.

    Bodies 1 and 2 have velocities ``u1``, ``u2`` just before (m/s) and *inverse* masses ``w1``,
    ``w2`` (1/kg; a fixed wall has w = 0 and u = 0); ``c`` is a vector along the line of centres, of
    any length and in either sense; ``e`` is the coefficient of restitution. Vectors have shape
    (n, 2) or (2,), the others (n,) or none, where what is not given for each row is the same in
    all; further axes in front, and axes of length 1, are broadcast as NumPy does.

    As c has no sense, whether the bodies approach each other is not asked: bodies that separate
    would pass through one another. With c from body 1 to body 2 they approach where
    ``((u1 - u2) * c).sum(axis=-1) > 0``.

    Doubles come out as the law gives them, each operation rounded once, the same with and without
    the compiled kernel and with any number of threads. The impulse has a relative error below
    8 units in the last place, beside what cancels in u1 − u2 and in its scalar product with c. The
    length of c is to be between 1e-150 and 1e150. Other kinds of number, fractions among them, stay
    what they are; integers become doubles. Arrays of another library (those with
    ``__array_namespace__`` or ``__array_function__``) come out as arrays of that library, and are
    asked for their shapes only, as their values may not be known yet.

    ``out`` is a pair of arrays to write the results to, which may be u1 and u2 themselves; reusing
    it saves the time that fresh memory takes, as much as all the rest. ``threads`` is how many the
    compiled kernel may use.

    Raises:
        StatementError: something is not a number or has the wrong shape.
        ImpossibleError: e is not in [0, 1], an inverse mass is negative, both are zero, or c is
            zero; the first such row is named. ``out`` then holds nothing of use.
        UnsupportedError: ``out`` for arrays of another library.
    """
    given = (u1, u2, c, w1, w2, e)
    foreign = [value for value in given if _is_foreign(value)]
    if foreign:
        if out is not None:
            raise UnsupportedError(f"out is for NumPy's arrays, not {type(foreign[0]).__name__}")
        return _by_another_library(given, foreign[0])
    if not isinstance(threads, int | np.integer):
        raise StatementError(f"threads is a whole number, not {threads!r}")
    if threads < 1:
        raise StatementError(f"threads = {threads}: at least one is needed")
    kind = _kind_of_number(given)
    data = [np.asarray(value, dtype=kind) for value in given]
    shape = _common_shape([array.shape for array in data])
    results = _room(out, data, shape, kind)
    with np.errstate(all="ignore"):  # as compiled code does; what is not a number stays so
        if kind == np.float64 and math.prod(shape) >= LARGE and find_spec("numba"):
            good = _by_kernel(data, results, shape, threads)
        else:
            good = _by_numpy(data, results, shape)
        if not good:
            _blame(data, shape)
    if out is None:
        return results
    for place, result in zip(out, results):
        if place is not result:
            place[...] = result
    return out


# --- what was given ----------------------------------------------------------------------------


def _is_foreign(value: Any) -> bool:
    if isinstance(value, np.ndarray | np.generic):
        return False
    return hasattr(value, "__array_namespace__") or hasattr(value, "__array_function__")


def _kind_of_number(given: tuple[Any, ...]) -> np.dtype[Any]:
    """The type of the results: NumPy's for the data together, but never integers."""
    kinds: list[Any] = []
    for name, value in zip(_NAMES, given):
        kind = _array(name, value).dtype
        if kind.kind not in "biufO":
            raise StatementError(f"{name} holds {kind}, not real numbers")
        # Python's own numbers take the type of the arrays that they meet.
        kinds.append(value if type(value) in (int, float) else kind)
    kind = np.result_type(*kinds)
    return np.dtype(np.float64) if kind.kind in "biu" else kind.newbyteorder("=")


def _array(name: str, value: Any) -> _Array:
    try:
        return np.asarray(value)
    except ValueError as error:  # a list of lists of several lengths
        raise StatementError(f"{name} is not an array: {error}") from None


def _common_shape(shapes: list[tuple[int, ...]]) -> tuple[int, ...]:
    """The shape of the batch: that of the results, without the last axis."""
    for name, shape in zip(_NAMES[:_VECTORS], shapes):
        if not shape or shape[-1] != 2:
            raise StatementError(
                f"{name} has shape {shape}: a vector has two components, "
                "n vectors are an array of shape (n, 2)"
            )
    rows = [shape[:-1] for shape in shapes[:_VECTORS]] + shapes[_VECTORS:]
    try:
        return np.broadcast_shapes(*rows)
    except ValueError:
        listed_shapes = ", ".join(f"{name} {shape}" for name, shape in zip(_NAMES, shapes))
        raise StatementError(f"the shapes do not fit each other: {listed_shapes}") from None


def _room(
    out: Sequence[Any] | None,
    data: Sequence[_Array],
    shape: tuple[int, ...],
    kind: np.dtype[Any],
) -> tuple[_Array, _Array]:
    """Arrays to write to: those of ``out``, unless writing there spoils what is still to read."""
    full = (*shape, 2)
    if out is None:
        return np.empty(full, kind), np.empty(full, kind)
    if len(out) != 2 or not all(isinstance(room, np.ndarray) for room in out):
        raise StatementError("out is a pair of NumPy arrays, for v1 and v2")
    for part in out:
        if part.shape != full or not np.can_cast(kind, part.dtype, "same_kind"):
            raise StatementError(
                f"out has shape {part.shape} and holds {part.dtype}: needed is {full}, {kind}"
            )
        if not part.flags.writeable:
            raise StatementError("out cannot be written to")
    if np.shares_memory(*out):
        raise StatementError("the two arrays of out share memory")
    first, second = (
        room
        if room.dtype == kind
        and room.flags.c_contiguous
        and room.ctypes.data % _ROW == 0
        and not _in_the_way(room, data)
        else np.empty(full, kind)
        for room in out
    )
    return first, second


def _in_the_way(result: _Array, data: Sequence[_Array]) -> bool:
    """Whether a result would be written over data, other than the velocities of its own rows."""

    def place(array: _Array) -> tuple[Any, ...]:
        return array.ctypes.data, array.shape, array.strides

    return any(
        np.may_share_memory(result, array) and not (k < 2 and place(array) == place(result))
        for k, array in enumerate(data)
    )


# --- two ways for NumPy's arrays ---------------------------------------------------------------


def _by_numpy(data: Sequence[_Array], results: Sequence[_Array], shape: tuple[int, ...]) -> bool:
    """Fill the results chunk by chunk; false, before they are full, if an impact is impossible."""
    for rows, (u1, u2, c, w1, w2, e) in _chunks(data, shape):
        if not np.all(possible(w1, w2, c, e)):
            return False
        for result, velocity in zip(results, law.impact(u1, u2, w1, w2, c, e)):
            part = result[rows]
            part[..., 0], part[..., 1] = velocity
    return True


def _chunks(data: Sequence[_Array], shape: tuple[int, ...]) -> Iterator[tuple[Any, list[Any]]]:
    """Which rows, and the data of these: vectors by components, all broadcast."""
    size = math.prod(shape)
    whole = [
        np.broadcast_to(array, (*shape, 2) if k < _VECTORS else shape)
        for k, array in enumerate(data)
    ]
    if size <= CHUNK:
        parts: list[Any] = [...]
    else:
        step = max(1, CHUNK * shape[0] // size)
        parts = [slice(start, start + step) for start in range(0, shape[0], step)]
    for rows in parts:
        vectors = [Vector(array[rows][..., 0], array[rows][..., 1]) for array in whole[:_VECTORS]]
        yield rows, [*vectors, *(array[rows] for array in whole[_VECTORS:])]


def _by_kernel(
    data: Sequence[_Array], results: Sequence[_Array], shape: tuple[int, ...], threads: int
) -> bool:
    """Fill the results by compiled code; false if an impact is impossible."""
    from restitution.batch.fused import fused

    count = math.prod(shape)
    flat = [_flat(array, shape, vectors=k < _VECTORS) for k, array in enumerate(data)]
    pairs = [result.reshape(count, 2) for result in results]
    # The results are written line by line of the cache: the first row starts one.
    first = min(count, -pairs[0].ctypes.data % _LINE // _ROW)
    steps = (count - first) // _KERNEL
    strides = [0 if same else array.strides[0] * _KERNEL for array, same in flat]

    def work(part: int) -> bool:
        start, stop = (steps * end // threads for end in (part, part + 1))
        row = first + start * _KERNEL
        return bool(
            fused(
                tuple(
                    array.ctypes.data + (not same) * row * array.strides[0] for array, same in flat
                ),
                tuple(strides),
                tuple(pair.ctypes.data + row * _ROW for pair in pairs),
                stop - start,
            )
        )

    if threads == 1:
        good = work(0)
    else:
        with ThreadPoolExecutor(threads) as pool:
            good = all(pool.map(work, range(threads)))
    for start, stop in (0, first), (first + steps * _KERNEL, count):
        edge = [array[: stop - start] if same else array[start:stop] for array, same in flat]
        good = good and _by_numpy(edge, [pair[start:stop] for pair in pairs], (stop - start,))
    return good


def _flat(array: _Array, shape: tuple[int, ...], *, vectors: bool) -> tuple[_Array, bool]:
    """A row for each impact, without gaps; or, where all are the same, as many as a step takes."""
    row = (2,) if vectors else ()
    same = array.size == math.prod(row)
    full = (_KERNEL, *row) if same else (*shape, *row)
    rows = np.require(np.broadcast_to(array, full), requirements=("C", "ALIGNED"))
    return rows.reshape(-1, *row), same


def _blame(data: Sequence[_Array], shape: tuple[int, ...]) -> NoReturn:
    """Name the first row that is impossible, and why."""
    for rows, (_, _, c, w1, w2, e) in _chunks(data, shape):
        bad = np.argwhere(~np.asarray(possible(w1, w2, c, e)))
        if len(bad):
            at = tuple(bad[0])
            reason = _reason(w1[at], w2[at], Vector(c.x[at], c.y[at]), e[at])
            place = [int(k) for k in at]
            if place and rows is not ...:
                place[0] += rows.start
            row = f"row {', '.join(map(str, place))}: " if place else ""
            raise ImpossibleError(row + reason)
    raise AssertionError("no row is impossible")


def _reason(w1: Any, w2: Any, c: Vector, e: Any) -> str:
    if not 0 <= e <= 1:
        return f"e = {e}: a coefficient of restitution lies in [0, 1]"
    for name, w in ("w1", w1), ("w2", w2):
        if not 0 <= w < math.inf:
            return f"{name} = {w}: an inverse mass is a number, and not negative"
    if w1 + w2 == 0:
        return "w1 = w2 = 0: of two fixed bodies neither can hit the other"
    return f"c = ({c.x}, {c.y}): such a vector gives the line of centres no direction"


# --- other libraries ---------------------------------------------------------------------------


def _by_another_library(given: Sequence[Any], sample: Any) -> tuple[Any, Any]:
    data = [value if _is_foreign(value) else np.asarray(value) for value in given]
    _common_shape([array.shape for array in data])
    u1, u2, c = (Vector(_number(v[..., 0]), _number(v[..., 1])) for v in data[:_VECTORS])
    w1, w2, e = map(_number, data[_VECTORS:])
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    space = getattr(sample, "__array_namespace__", None)
    stack = space().stack if space else np.stack  # which asks the library of its arguments
    return stack(tuple(v1), axis=-1), stack(tuple(v2), axis=-1)


def _number(value: Any) -> Any:
    """A single number as Python's own, with which every library computes."""
    return value.item() if not _is_foreign(value) and value.ndim == 0 else value
