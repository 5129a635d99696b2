"""In which directions the velocities at an impact are resolved, and what the components are."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, lru_cache

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.exact.symbols import symbols_in
from restitution.explaining.data.paths_and_lines import turn_of_path
from restitution.explaining.lines.derivation import Fact, Ref
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Expression,
    Name,
    Negate,
    Quantity,
    Unit,
    unsigned,
)
from restitution.planning.writing.desk import NotPlannedError
from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True)
class Frame:
    """Two directions at an impact: along the line of centres, or the normal of a wall, and across.

    ``along`` is the direction as lines say it, a unit vector or ``line_of_centres(n)``; ``across``
    is one where it is a unit vector, and None where it is the line of centres turned to the left.
    ``n`` and ``t`` are the same as vectors of length 1. ``letter_sign`` is −1 where the letters of
    the components count against ``n``. ``told`` is the fact that gives the axis; where a line has
    to work it out, ``write`` writes that.
    """

    number: int
    wall: str | None
    along: Expression
    across: Expression | None
    n: Vector
    t: Vector
    sources: tuple[Ref, ...]
    letter_sign: int
    write: Callable[[], tuple[Ref, ...]] | None = None

    @cached_property
    def is_slanted(self) -> bool:
        """Whether the directions are given as vectors beside **i** and **j**."""
        return self.across is None and self.n.x != 0 and self.n.y != 0

    @cached_property
    def has_letters(self) -> bool:
        """Whether letters stand in the directions, of which more may be known later."""
        return any(symbols_in(component) for component in self.n)

    @property
    def refs(self) -> tuple[Ref, ...]:
        """The fact, or the line, that gives the axis."""
        return self.sources if self.write is None else self.write()

    def component(self, kind: str, body: str, stage: int) -> Quantity:
        """The component of a velocity, as lines say it: ``kind`` is along or across."""
        if kind == "along":
            return _component("along", body, stage, self.along)
        if self.across is not None:
            return _component("along", body, stage, self.across)
        return _component("across", body, stage, self.along)

    @property
    def unit_free(self) -> tuple[Ref, ...]:
        """The axis, where components are named by it."""
        return self.refs if isinstance(self.along, Quantity) else ()

    def names_axis(self, kind: str) -> tuple[Ref, ...]:
        """The axis, where a component of that kind is not named by it: a law needs it then."""
        return (
            self.refs if (kind == "across" and self.across) or isinstance(self.along, Unit) else ()
        )

    def direction(self, kind: str) -> Vector:
        """The direction in which a component counts as positive."""
        return self.n if kind == "along" else self.t

    @property
    def sense(self) -> Expression | None:
        """The sense of the letters of components, where it is not that of ``along``."""
        return None if self.letter_sign == 1 else Negate(self.along)


@lru_cache(maxsize=1024)
def _component(kind: str, body: str, stage: int, direction: Expression) -> Quantity:
    """A component of a velocity: always the same object, which is found without comparing."""
    return Quantity(kind, (Quantity("velocity", (Name(body),), stage), direction))


_I, _J = (Vector(sp.Integer(x), sp.Integer(y)) for x, y in ((1, 0), (0, 1)))


def frame_of(model: Model, facts: dict[str, Fact], number: int) -> Frame:
    """The frame of an impact; of a blow, **i** and **j**.

    Raises NotPlannedError where the line of centres is not among the data.
    """
    own = model.frames.get(number)
    if own is None:
        return Frame(number, None, Unit("i"), Unit("j"), _I, _J, (), 1)
    fact = facts.get(f"axis {number}")
    if fact is None or own.by_values or own.angle is not None:
        raise NotPlannedError(f"the line of centres of event {number} is to be worked out")
    refs = (fact.id,)
    towards = fact.relation.only[0].right
    if own.axis is not None:
        i, j = (Vector(sp.Integer(x), sp.Integer(y)) for x, y in ((1, 0), (0, 1)))
        n, t = (i, j) if own.axis == "i" else (j, i)
        unit = Unit(own.axis)
        other = Unit("j" if own.axis == "i" else "i")
        sign = 1 if own.wall is None or own.n == n else -1
        if own.wall is None and towards == unit:
            centres = Quantity("line_of_centres", (), number)
            turned = None if own.axis == "i" else other
            return Frame(number, None, centres, turned, n, t, refs, sign)
        return Frame(number, own.wall, unit, other, n, t, refs, sign)
    direction = model.story.evaluator(number).direction(towards)
    size = model.story.size(direction)
    n = Vector(tidy(direction.x / size), tidy(direction.y / size))
    sign = 1 if model.sign(n.dot(own.n)) > 0 else -1
    if own.wall is not None and not _is_along_j(facts, model, number):
        n = own.n if sign > 0 else -own.n  # in sines and cosines of the angle of the wall itself
    centres = Quantity("line_of_centres", (), number)
    return Frame(number, own.wall, centres, None, n, n.turned_left(), refs, sign)


def _is_along_j(facts: dict[str, Fact], model: Model, number: int) -> bool:
    """Whether what strikes a wall starts along **j**: its path and the wall make the complement."""
    (body, *_) = model.happening(number).bodies
    turn = turn_of_path(facts.get(f"velocity {body}"))
    return turn is not None and unsigned(turn) == RIGHT_ANGLE
