"""Eight floats in one register, as a kind of number for compiled code.

A processor computes with several floats at once (SIMD), but a compiler seldom finds the way there
by itself where data lie in rows of two. ``Lanes`` is such a register as a number: with its
arithmetic and its comparisons, the law of impact serves it as it serves any other number, and works
out eight impacts in one go. Where registers are narrower, the compiler uses several.

Memory is read and written at addresses (in bytes): who calls sees to it that they are right.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic, models, overload, register_model

COUNT = 8
"""How many floats."""

BYTES = np.uintp(8 * COUNT)

_INT = ir.IntType(32)
_REGISTER = ir.VectorType(ir.DoubleType(), COUNT)
_UNSET = ir.Constant(_REGISTER, ir.Undefined)


class Lanes(types.Type):
    """The type of eight floats."""

    def __init__(self) -> None:
        super().__init__(name="Lanes")


lanes = Lanes()


@register_model(Lanes)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _REGISTER)


def _indices(*numbers: int) -> Any:
    return ir.Constant(ir.VectorType(_INT, len(numbers)), list(numbers))


@intrinsic
def spread(context: Any, number: Any) -> Any:
    """One float in all eight lanes."""

    def generate(_: Any, builder: Any, __: Any, arguments: Any) -> Any:
        first = builder.insert_element(_UNSET, arguments[0], ir.Constant(_INT, 0))
        return builder.shuffle_vector(first, _UNSET, _indices(*[0] * COUNT))

    return lanes(types.float64), generate


# --- arithmetic and comparisons ----------------------------------------------------------------


def _operation(
    operation: Callable[..., Any], result: Any, generate: Callable[[Any, Any, Any], Any]
) -> None:
    """Teach Numba an operation of eight floats with eight others, or with one number."""

    @intrinsic
    def both(context: Any, one: Any, two: Any) -> Any:
        return result(lanes, lanes), lambda _, builder, __, numbers: generate(builder, *numbers)

    @overload(operation, strict=False)
    def _(one: Any, two: Any) -> Callable[..., Any] | None:
        if isinstance(one, Lanes) and isinstance(two, Lanes):
            return lambda one, two: both(one, two)  # noqa: PLW0108 - Numba asks for a function
        if isinstance(one, Lanes) and isinstance(two, types.Number):
            return lambda one, two: both(one, spread(float(two)))
        if isinstance(one, types.Number) and isinstance(two, Lanes):
            return lambda one, two: both(spread(float(one)), two)
        return None


_operation(operator.add, lanes, lambda builder, one, two: builder.fadd(one, two))
_operation(operator.sub, lanes, lambda builder, one, two: builder.fsub(one, two))
_operation(operator.mul, lanes, lambda builder, one, two: builder.fmul(one, two))
_operation(operator.truediv, lanes, lambda builder, one, two: builder.fdiv(one, two))


def _comparison(sign: str) -> Callable[[Any, Any, Any], Any]:
    """One bit for each lane; false where either is not a number."""
    return lambda builder, one, two: builder.bitcast(
        builder.fcmp_ordered(sign, one, two), ir.IntType(COUNT)
    )


_operation(operator.lt, types.uint8, _comparison("<"))
_operation(operator.le, types.uint8, _comparison("<="))
_operation(operator.gt, types.uint8, _comparison(">"))
_operation(operator.ge, types.uint8, _comparison(">="))


# --- memory ------------------------------------------------------------------------------------


def _pointer(builder: Any, address: Any, register: int = 0) -> Any:
    start = builder.inttoptr(address, _REGISTER.as_pointer())
    return builder.gep(start, [ir.Constant(_INT, register)])


def _load(builder: Any, address: Any, register: int = 0) -> Any:
    return builder.load(_pointer(builder, address, register), align=8)


@intrinsic
def load(context: Any, address: Any) -> Any:
    """Eight floats that follow one another."""
    return lanes(types.uintp), lambda _, builder, __, arguments: _load(builder, arguments[0])


@intrinsic
def load_pairs(context: Any, address: Any) -> Any:
    """Eight pairs that follow one another: their first floats, their second floats."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        one, two = (_load(builder, arguments[0], register) for register in (0, 1))
        firsts, seconds = (
            builder.shuffle_vector(one, two, _indices(*range(place, 2 * COUNT, 2)))
            for place in (0, 1)
        )
        return context.make_tuple(builder, signature.return_type, (firsts, seconds))

    return types.UniTuple(lanes, 2)(types.uintp), generate


@intrinsic
def stream_pairs(context: Any, address: Any, firsts: Any, seconds: Any) -> Any:
    """Writes eight pairs past the caches, to an address that 16 divides.

    What is written at length and not read again soon is better not in the caches: to write there,
    a line is first read from memory. ``finish_streams`` follows before others read.
    """

    def generate(context: Any, builder: Any, _: Any, arguments: Any) -> Any:
        address, firsts, seconds = arguments
        mark = builder.module.add_metadata([ir.Constant(_INT, 1)])
        places = [place for k in range(COUNT) for place in (k, COUNT + k)]
        for register in (0, 1):
            half = _indices(*places[register * COUNT : (register + 1) * COUNT])
            pairs = builder.shuffle_vector(firsts, seconds, half)
            stored = builder.store(pairs, _pointer(builder, address, register), align=16)
            stored.set_metadata("nontemporal", mark)
        return context.get_dummy_value()

    return types.void(types.uintp, lanes, lanes), generate


@intrinsic
def finish_streams(context: Any) -> Any:
    """Wait until all that was streamed is where other threads see it."""

    def generate(context: Any, builder: Any, _: Any, __: Any) -> Any:
        builder.fence("seq_cst")
        return context.get_dummy_value()

    return types.void(), generate


@intrinsic
def prefetch(context: Any, address: Any) -> Any:
    """Ask for the line of memory at an address, which need not be one's own, ahead of its use."""

    def generate(context: Any, builder: Any, _: Any, arguments: Any) -> Any:
        place = builder.inttoptr(arguments[0], ir.IntType(8).as_pointer())
        numbers = [_INT] * 3
        function = builder.module.declare_intrinsic(
            "llvm.prefetch", [place.type], ir.FunctionType(ir.VoidType(), [place.type, *numbers])
        )
        read, keep, data = (ir.Constant(_INT, number) for number in (0, 3, 1))
        builder.call(function, [place, read, keep, data])
        return context.get_dummy_value()

    return types.void(types.uintp), generate
