"""Numbers as they are printed with their errors."""

from __future__ import annotations

import math


def decimals(error: float) -> int:
    """Places behind the point at which an error has two digits."""
    if not 0 < error < math.inf:
        return 3
    return max(0, min(6, 1 - math.floor(math.log10(error))))


def with_error(value: float, error: float | None, unit: str = "") -> str:
    """``0.703 ± 0.012``, with the unit behind; a dash where there is no value."""
    if not math.isfinite(value):
        return "–"
    if error is None:
        return f"{value:.3g}{unit}"
    places = decimals(error)
    return f"{fixed(value, places)}{unit} ± {fixed(error, places)}{unit}"


def fixed(value: float, places: int) -> str:
    """A number with so many places, with a true minus, and never minus nought."""
    text = f"{value:.{places}f}"
    if float(text) == 0:
        text = text.removeprefix("-")
    return text.replace("-", "−")


def probability(p: float) -> str:
    """``p = 0.031``, or ``p < 0.0001``."""
    return "p < 0.0001" if p < 1e-4 else f"p = {p:.2g}"


def percent(value: float) -> str:
    """A share as a percentage, with two digits below ten."""
    return f"{100 * value:.1f}%" if abs(value) < 0.0995 else f"{100 * value:.0f}%"
