"""Many impacts in one pass over memory, compiled: each number is read once and written once.

An impact takes some thirty operations for a hundred bytes of data, so memory sets the pace. The
kernel reads ahead of its needs, works out eight impacts in registers, and writes the results past
the caches. Three ways of doing it were slower: one loop in the compiler's own vectors, blocks with
a buffer that is copied out, and either with ordinary stores, for which every line of the results
is read before it is overwritten.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit, types

from restitution import law
from restitution.batch.compiled_law import as_it_stands
from restitution.batch.lanes import (
    BYTES,
    COUNT,
    finish_streams,
    load,
    load_pairs,
    prefetch,
    stream_pairs,
)
from restitution.batch.possible import possible
from restitution.vector import Vector

AHEAD = np.uintp(16)
"""How many steps of the loop ahead memory is asked for: some 13 kB, well within any first cache."""

_ALL = np.uint8(2**COUNT - 1)  # a bit for each lane
_PAIRS = np.uintp(2 * BYTES)

as_it_stands(possible)


@njit(
    types.boolean(
        types.UniTuple(types.uintp, 6),
        types.UniTuple(types.uintp, 6),
        types.UniTuple(types.uintp, 2),
        types.uintp,
    ),
    nogil=True,
    cache=True,
    error_model="numpy",
)
def fused(data: Any, strides: Any, results: Any, steps: Any) -> Any:
    """Eight impacts in each step; whether all of them were possible.

    ``data`` are the addresses of u1, u2, c, w1, w2 and e, and ``strides`` the bytes by which each
    moves on in a step, none for what is the same in every row; ``results`` are the addresses of v1
    and v2. All numbers are doubles without gaps; 8 divides the addresses of the data, 16 those of
    the results. Results may overwrite data of their own rows.
    """
    u1, u2, c, w1, w2, e = data
    u1_stride, u2_stride, c_stride, w1_stride, w2_stride, e_stride = strides
    v1, v2 = results
    good = _ALL
    for _ in range(steps):
        for address, stride in (u1, u1_stride), (u2, u2_stride), (c, c_stride):
            prefetch(address + AHEAD * stride)
            prefetch(address + AHEAD * stride + BYTES)
        for address, stride in (w1, w1_stride), (w2, w2_stride), (e, e_stride):
            prefetch(address + AHEAD * stride)
        centres = Vector(*load_pairs(c))
        inverse_1, inverse_2, restitution = load(w1), load(w2), load(e)
        good &= possible(inverse_1, inverse_2, centres, restitution)
        first, second = law.impact(
            Vector(*load_pairs(u1)),
            Vector(*load_pairs(u2)),
            inverse_1,
            inverse_2,
            centres,
            restitution,
        )
        stream_pairs(v1, first.x, first.y)
        stream_pairs(v2, second.x, second.y)
        u1 += u1_stride
        u2 += u2_stride
        c += c_stride
        w1 += w1_stride
        w2 += w2_stride
        e += e_stride
        v1 += _PAIRS
        v2 += _PAIRS
    finish_streams()
    return good == _ALL
