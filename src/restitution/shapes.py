"""Where a wall is: a whole line, a segment or a circle, in any kind of number."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

from restitution.records import dataclass

Reader: TypeAlias = Callable[[Any, str], Any]


@dataclass(frozen=True)
class Line:
    """A whole line ``along`` a direction, ``through`` a point; each None where it is not given."""

    along: Any = None
    through: Any = None

    @property
    def point(self) -> Any:
        """A point of the line; None where none is given."""
        return self.through

    @property
    def is_placed(self) -> bool:
        return self.through is not None

    def read(self, name: str, point: Reader, number: Reader) -> Line:
        """The same with its point read, by a reader of points that is given a name for errors."""
        through = None if self.through is None else point(self.through, f"a point of {name}")
        return Line(self.along, through)


@dataclass(frozen=True)
class Segment:
    """A straight piece from the point ``start`` to the point ``end``."""

    start: Any
    end: Any

    @property
    def along(self) -> Any:
        """From the start to the end, where these are vectors."""
        return self.end - self.start

    @property
    def point(self) -> Any:
        """A point of its line: the start."""
        return self.start

    @property
    def is_placed(self) -> bool:
        return True

    def read(self, name: str, point: Reader, number: Reader) -> Segment:
        """The same with its ends read."""
        return Segment(
            point(self.start, f"the start of {name}"), point(self.end, f"the end of {name}")
        )


@dataclass(frozen=True)
class Circle:
    """A circle about the point ``centre``, with a ``radius``."""

    centre: Any
    radius: Any

    @property
    def point(self) -> None:
        """No point of it is given, only its centre."""
        return None

    @property
    def is_placed(self) -> bool:
        return True

    def read(self, name: str, point: Reader, number: Reader) -> Circle:
        """The same with its centre and its radius read."""
        return Circle(
            point(self.centre, f"the centre of {name}"),
            number(self.radius, f"the radius of {name}"),
        )


Shape: TypeAlias = Line | Segment | Circle
