"""The header of a table: which quantity a column holds, in which unit, as a value or as an error.

A header cell is a name, perhaps with a unit in brackets or after a stroke, and perhaps with a mark
of an error: ``alpha``, ``α (deg)``, ``u / m s^-1``, ``± alpha``, ``beta_error``, ``alpha from
normal``.
"""

from __future__ import annotations

import math
import re
from typing import Literal

from restitution.records import dataclass

Dimension = Literal["angle", "speed", "length", "time", "mass", "name"]

WALL = ("alpha", "beta", "u", "v")
TRACKS = ("t", "x", "y", "body", "trial", "wall", "m")
VELOCITIES = ("u_A", "u_B", "v_A", "v_B")
SPHERES = (
    "m_A",
    "m_B",
    *(f"{velocity}{part}" for velocity in VELOCITIES for part in ("", "_angle", "_x", "_y")),
    "line",
)
DIMENSIONS: dict[str, Dimension] = {
    **dict.fromkeys(("alpha", "beta", "line", "wall"), "angle"),
    **dict.fromkeys(("u", "v"), "speed"),
    **{name: "angle" if name.endswith("_angle") else "speed" for name in SPHERES[2:-1]},
    **dict.fromkeys(("m_A", "m_B", "m"), "mass"),
    **dict.fromkeys(("x", "y"), "length"),
    "t": "time",
    **dict.fromkeys(("body", "trial"), "name"),
}
"""The quantities that a column may hold."""

_OTHER_NAMES = {
    "α": "alpha",
    "angle_before": "alpha",
    "β": "beta",
    "angle_after": "beta",
    "speed_before": "u",
    "speed_after": "v",
    "time": "t",
    "object": "body",
    "ball": "body",
    "sphere": "body",
    "puck": "body",
    "run": "trial",
    "mass": "m",
    "line_of_centres": "line",
    "line_of_centers": "line",
}
_NAMES = {name.lower(): name for name in DIMENSIONS} | _OTHER_NAMES

_UNITS: dict[Dimension, dict[str, tuple[float, str]]] = {
    "angle": {
        **dict.fromkeys(("deg", "degs", "degree", "degrees", "°", "º"), (1.0, "degrees")),
        **dict.fromkeys(("rad", "rads", "radian", "radians"), (math.degrees(1), "degrees")),
    },
    "speed": {
        "m/s": (1.0, "m/s"),
        "cm/s": (0.01, "m/s"),
        "mm/s": (0.001, "m/s"),
        "km/h": (1 / 3.6, "m/s"),
        "px/s": (1.0, "px/s"),
    },
    "length": {
        "m": (1.0, "m"),
        "cm": (0.01, "m"),
        "mm": (0.001, "m"),
        "px": (1.0, "px"),
    },
    "time": {"s": (1.0, "s"), "sec": (1.0, "s"), "ms": (0.001, "s")},
    "mass": {"kg": (1.0, "kg"), "g": (0.001, "kg")},
    "name": {},
}
_USUAL = {"angle": "degrees", "speed": "m/s", "length": "m", "time": "s", "mass": "kg", "name": ""}


class UnitError(ValueError):
    """A unit that is not known for the quantity; its message names both and the units that are."""


@dataclass(frozen=True)
class Column:
    """What one column holds. ``quantity`` is None for a column that is not read.

    ``factor`` takes its numbers to ``unit``. ``stated`` says whether the header has the unit.
    """

    header: str
    quantity: str | None
    is_error: bool = False
    factor: float = 1.0
    unit: str = ""
    stated: bool = False
    from_normal: bool = False


_NORMAL = re.compile(r"\b(?:from|to|off)\s+(?:the\s+)?normal\b", re.IGNORECASE)
_WALL = re.compile(r"\b(?:from|to|off)\s+(?:the\s+)?wall\b", re.IGNORECASE)
_BRACKETED = re.compile(r"[(\[]([^)\]]*)[)\]]")
_IN_UNIT = re.compile(r"\s+in\s+(\S.*)$", re.IGNORECASE)
_ERROR_BEFORE = re.compile(r"^(?:±|error(?:\s+(?:of|in))?[\s_]+|σ[\s_]*)\s*", re.IGNORECASE)
_ERROR_AFTER = re.compile(r"[\s_]*(?:±|[\s_](?:error|err|sd|uncertainty))$", re.IGNORECASE)


def column_of(header: str) -> Column:
    """What a cell of the header says. Raises UnitError for a unit that does not fit."""
    text = " ".join(header.replace("+/-", "±").replace("+-", "±").split())
    from_normal = _NORMAL.search(text.replace("_", " ")) is not None
    text = _WALL.sub("", _NORMAL.sub("", text.replace("_from_normal", " from normal")))
    text, unit = _parted(text)
    bare = _ERROR_BEFORE.sub("", text)
    name = _ERROR_AFTER.sub("", bare)
    quantity = _quantity(name)
    if quantity is None:
        return Column(header, None)
    dimension = DIMENSIONS[quantity]
    factor, shown = _scale(header, dimension, unit)
    return Column(header, quantity, name != text, factor, shown, bool(unit), from_normal)


def _parted(text: str) -> tuple[str, str]:
    """The name and the unit of a header cell; "" where it has none."""
    unit = ""
    bracketed = _BRACKETED.search(text)
    if bracketed:
        unit = bracketed[1]
        text = text[: bracketed.start()] + text[bracketed.end() :]
    elif "/" in text:
        text, _, unit = text.partition("/")
    elif words := _IN_UNIT.search(text):
        text, unit = text[: words.start()], words[1]
    return text.strip(" ,;:"), unit.strip(" ,;:")


def _quantity(name: str) -> str | None:
    key = re.sub(r"[\s\-,{}]+", "_", name.strip().lower().replace("{", "").replace("}", ""))
    return _NAMES.get(key.strip("_"))


def _scale(header: str, dimension: Dimension, unit: str) -> tuple[float, str]:
    if not unit:
        return 1.0, _USUAL[dimension]
    key = unit if unit in _UNITS[dimension] else _plain_unit(unit)
    if key not in _UNITS[dimension]:
        known = ", ".join(_shown_units(dimension)) or "no unit"
        raise UnitError(f"column {header!r}: {unit!r} is no unit for it; known are {known}")
    return _UNITS[dimension][key]


def _plain_unit(unit: str) -> str:
    """A unit as a quotient: m s^-1, m s⁻¹, ms-1 and m·s**-1 are m/s."""
    text = unit.lower().replace("⁻¹", "-1").replace("−", "-").replace("^", "").replace("*", " ")
    text = text.replace("·", " ").replace(".", " ").replace("per", "/")
    text = re.sub(r"[{}()\s]+", "", text)
    return re.sub(r"([a-z]+?)(s|h)-1$", r"\1/\2", text)


def _shown_units(dimension: Dimension) -> list[str]:
    if dimension == "angle":
        return ["deg", "rad"]
    return [unit for unit in _UNITS[dimension] if unit != "sec"]
