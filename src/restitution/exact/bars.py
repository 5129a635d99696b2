"""Sizes: |u| for u²/|u|, and bars inside bars."""

from __future__ import annotations

import sympy
from sympy import Expr, Mul


def _factor_without_bars(factor: Expr) -> Expr:
    return factor.args[0] if isinstance(factor, sympy.Abs) and factor.args[0].is_real else factor


def has_bars_inside(value: Expr) -> bool:
    """Whether a factor of what stands in bars has bars itself."""
    return isinstance(value, sympy.Abs) and any(
        _factor_without_bars(factor) != factor for factor in Mul.make_args(value.args[0])
    )


def without_bars_inside(value: Expr) -> Expr:
    """|uv| for |u |v||."""
    return sympy.Abs(Mul(*map(_factor_without_bars, Mul.make_args(value.args[0]))))


def has_square_beside_size(value: Expr) -> bool:
    """Whether a size and an even power of the same stand in a product."""
    return _beside_square(value) is not None


def with_one_size(value: Expr) -> Expr:
    """|u| for u²/|u|, and u² for |u|³/|u|."""
    bar = _beside_square(value)
    if bar is None:
        return value
    powers, inside = value.as_powers_dict(), bar.args[0]
    total = powers[bar] + powers[inside]
    own = inside if total % 2 == 0 else bar
    return value / (bar ** powers[bar] * inside ** powers[inside]) * own**total


def _beside_square(value: Expr) -> Expr | None:
    if not isinstance(value, Mul) or not value.has(sympy.Abs):
        return None
    powers = dict(value.as_powers_dict())
    for bar, power in powers.items():
        if isinstance(bar, sympy.Abs) and bar.args[0].is_real:
            inside = bar.args[0]
            whole = (power + powers.get(inside, 0)).is_Integer
            if inside in powers and powers[inside].is_even and whole:
                return bar
    return None


__all__ = [
    "has_bars_inside",
    "has_square_beside_size",
    "with_one_size",
    "without_bars_inside",
]
