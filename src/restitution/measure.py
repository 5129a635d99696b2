"""Speeds and angles of velocities: what needs a root or an inverse tangent.

Each function takes the kind of number it is given: symbols and SymPy's exact numbers give an
exact expression, arrays give arrays (of the library they come from), and all other numbers,
fractions among them, give a float. Angles are in radians. No number library is imported unless
an operand is already one of its numbers.
"""

from __future__ import annotations

import math
from typing import Any

from restitution.vector import Vector


def speed(velocity: Vector) -> Any:
    """The size of a velocity, in its unit (m/s)."""
    return _of_two("hypot", velocity.x, velocity.y)


def direction(velocity: Vector) -> Any:
    """The direction of a vector, anticlockwise from **i**, in (−π, π].

    The zero vector has none: it gives 0 in floats and arrays, ``nan`` in SymPy.
    """
    return _of_two("atan2", velocity.y, velocity.x)


def angle_between(first: Vector, second: Vector) -> Any:
    """The angle between two vectors, from 0 to π.

    From the cross and dot products together, as the inverse cosine of the dot product alone
    loses half the figures at small angles. The zero vector makes an angle with none: it gives 0
    in floats and arrays, ``nan`` in SymPy.
    """
    return _of_two("atan2", abs(first.cross(second)), first.dot(second))


def deflection(before: Vector, after: Vector) -> Any:
    """The angle of deflection: between the direction before, continued, and that after, 0 to π."""
    return angle_between(before, after)


def unit(vector: Vector) -> Vector:
    """The vector of size 1 in the same direction. Divides by zero for the zero vector."""
    size = speed(vector)
    return Vector(vector.x / size, vector.y / size)


def at_angle(angle: Any) -> Vector:
    """The unit vector at an angle anticlockwise from **i**."""
    return Vector(_of_one("cos", angle), _of_one("sin", angle))


def _of_one(name: str, value: Any) -> Any:
    return getattr(_library(value), name)(value)


def _of_two(name: str, first: Any, second: Any) -> Any:
    library = _library(first, second)
    if name == "hypot" and not hasattr(library, "hypot"):
        return library.sqrt(first**2 + second**2)  # SymPy has no name for it
    return getattr(library, name)(first, second)


def _library(*values: Any) -> Any:
    """The module whose functions take these numbers: SymPy's, if one of them is SymPy's."""
    if any(hasattr(value, "free_symbols") for value in values):
        import sympy

        return sympy
    for value in values:
        if hasattr(value, "__array_namespace__"):
            return value.__array_namespace__()
    return math
