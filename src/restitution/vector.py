"""Vectors of the plane, over any kind of number.

A ``Vector`` is a pair of components along **i** and **j**. They may be floats, fractions, arrays
of any library or symbols: nothing here asks which, and no number library is imported.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class Vector(NamedTuple):
    """The vector x **i** + y **j**.

    It unpacks and compares as the pair ``(x, y)``; ``+``, ``-``, ``*`` and ``/`` are those of
    vectors, not of tuples. With arrays as components it stands for as many vectors at once.
    """

    x: Any
    y: Any

    def __add__(self, other: tuple[Any, Any]) -> Vector:  # type: ignore[override]
        x, y = other
        return Vector(self.x + x, self.y + y)

    def __radd__(self, other: tuple[Any, Any]) -> Vector:
        x, y = other
        return Vector(x + self.x, y + self.y)

    def __sub__(self, other: tuple[Any, Any]) -> Vector:
        x, y = other
        return Vector(self.x - x, self.y - y)

    def __rsub__(self, other: tuple[Any, Any]) -> Vector:
        x, y = other
        return Vector(x - self.x, y - self.y)

    def __neg__(self) -> Vector:
        return Vector(-self.x, -self.y)

    def __pos__(self) -> Vector:
        return self

    def __mul__(self, factor: Any) -> Vector:
        if isinstance(factor, tuple):  # which product is meant, has to be said
            return NotImplemented
        return Vector(self.x * factor, self.y * factor)

    def __rmul__(self, factor: Any) -> Vector:
        if isinstance(factor, tuple):
            return NotImplemented
        return Vector(factor * self.x, factor * self.y)

    def __truediv__(self, divisor: Any) -> Vector:
        if isinstance(divisor, tuple):
            return NotImplemented
        return Vector(self.x / divisor, self.y / divisor)

    def dot(self, other: tuple[Any, Any]) -> Any:
        """The scalar product."""
        x, y = other
        return self.x * x + self.y * y

    def cross(self, other: tuple[Any, Any]) -> Any:
        """The third component of the vector product: positive where other lies to the left."""
        x, y = other
        return self.x * y - self.y * x

    def turned_left(self) -> Vector:
        """This vector turned by a right angle, anticlockwise."""
        return Vector(-self.y, self.x)


# An array on the left of an operator would take a pair for an array of two numbers and spread
# over it; this tells it to leave the operation to the vector. (Within the class it would be
# taken for a third component.)
Vector.__array_ufunc__ = None  # type: ignore[attr-defined]
