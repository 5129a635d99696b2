"""Mistakes that are more usual than others of which a line may be an instance as well."""

from __future__ import annotations

from collections.abc import Mapping

_BEFORE: Mapping[str, set[str]] = {
    "angle-from-normal": {"sine-cosine"},
    "energy-conserved": {"restitution-omitted", "restitution-inverted"},
    "energy-component-missing": {"energy-fraction-of-line"},
    "speed-for-component": {"momentum-sign", "restitution-sign", "restitution-inverted"},
    "restitution-whole-speed": {"restitution-sign", "restitution-inverted"},
    "impulse-of-speeds": {"impulse-sign"},
    "deflection-difference": {"deflection-is-after"},
    "across-changed": {"mass-omitted"},
    "square-not-taken": {"energy-one-sphere", "energy-of-difference"},
}
_BEFORE_AT_A_WALL: Mapping[str, set[str]] = {
    "angle-from-normal": {"sine-cosine", "second-wall-angle"},
    "sine-cosine": {"second-wall-angle"},  # at walls at right angles both are one
    "across-changed": {"restitution-parallel"},
    "speed-for-component": {"momentum-sign", "restitution-sign", "restitution-whole-speed"},
    "restitution-whole-speed": {"restitution-sign", "restitution-inverted"},
}
_BEFORE_OF_SPHERES: Mapping[str, set[str]] = {
    "restitution-parallel": {"across-changed"},
    "across-exchanged": {"across-changed"},
}
# Where one component stands for the other, r = p, it is these that are taken for one another.
_BEFORE_ACROSS: Mapping[str, set[str]] = {"across-changed": {"sine-cosine"}}


def more_usual_than(family: str, at_wall: bool) -> set[str]:
    """The mistakes that are likelier than one, by their ids, at a wall or between spheres."""
    usual = {**_BEFORE, **(_BEFORE_AT_A_WALL if at_wall else _BEFORE_OF_SPHERES)}
    return usual.get(family, set()) | _BEFORE_ACROSS.get(family, set())


__all__ = ["more_usual_than"]
