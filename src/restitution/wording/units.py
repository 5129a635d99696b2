"""Which values of a statement carry a unit.

Everything in a statement is in SI. A value that is a number is printed with its unit (2 kg); a
letter stands for the quantity with its unit (a mass m). Where numbers fix the scale of a
quantity, letters for it stand for numbers, as in a velocity of (p**i** + 3**j**) m s⁻¹.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache

from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from restitution.expression.dimensions import (
    ENERGY,
    IMPULSE,
    LENGTH,
    MASS,
    NONE,
    SPEED,
    TIME,
    Dimension,
)
from restitution.expression.quantities import dimension_of_any
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    walk,
)
from restitution.problem import Compare, Given, Impact, Kick, Problem, once_a_problem, trees
from restitution.records import dataclass
from restitution.wording.letters import acute_letters

_GAP = "\u00a0"
_UNITS = {
    MASS: f"{_GAP}kg",
    LENGTH: f"{_GAP}m",
    TIME: f"{_GAP}s",
    SPEED: f"{_GAP}m{_GAP}s⁻¹",
    IMPULSE: f"{_GAP}N{_GAP}s",
    ENERGY: f"{_GAP}J",
    (0, 2, -2): f"{_GAP}m²{_GAP}s⁻²",
}


def _rank(dimensions: Sequence[Dimension]) -> int:
    rows = [list(map(QQ, dimension)) for dimension in dimensions]
    return int(DomainMatrix(rows, (len(rows), len(NONE)), QQ).rank())


@lru_cache(maxsize=512)
def _fixes(fixed: frozenset[Dimension], dimension: Dimension) -> bool:
    """Whether what has some dimensions has no other scale than they have."""
    known = sorted(fixed)
    return _rank([*known, dimension]) == _rank([NONE, *known])


@dataclass(frozen=True)
class Style:
    """How the values of a statement are printed.

    ``fixed`` are the dimensions for which it has numbers, ``acute`` its letters for acute angles.
    """

    fixed: frozenset[Dimension]
    acute: frozenset[str] = frozenset()

    def fixes(self, dimension: Dimension) -> bool:
        """Whether the numbers of the statement give the scale of a quantity."""
        if dimension == NONE or not self.fixed:
            return False
        return _fixes(self.fixed, dimension)

    def unit(self, dimension: Dimension | None) -> str:
        """The unit to print behind a value of that dimension, with its blank; or nothing."""
        if dimension is None or not self.fixes(dimension):
            return ""
        return _UNITS.get(dimension, "")


@once_a_problem
def style_of(problem: Problem) -> Style:
    """How the values of a statement are to be printed."""
    fixed = frozenset(d for d, tree in _data(problem) if d != NONE and is_number(tree))
    return Style(fixed, acute_letters(problem))


def _data(problem: Problem) -> Iterator[tuple[Dimension, Expression]]:
    data: list[tuple[Dimension, object]] = []
    for sphere in problem.spheres:
        data += [
            (MASS, sphere.mass),
            (SPEED, sphere.velocity),
            (LENGTH, sphere.position),
            (LENGTH, sphere.radius),
        ]
    for wall in problem.walls:
        data += [(LENGTH, length) for length in wall.lengths]
    data += [(LENGTH, point.position) for point in problem.points]
    for _, step in problem.steps():
        if isinstance(step, Kick):
            data.append((IMPULSE, step.impulse))
        elif isinstance(step, Impact):
            data.append((LENGTH, step.offset))
        elif isinstance(step, Given):
            for relation in step.relations:
                if isinstance(relation, Compare):
                    dimension = dimension_of_any(relation.operands)
                    data += [
                        (dimension, operand)
                        for operand in relation.operands
                        if dimension is not None and not has_quantity(operand)
                    ]
    for dimension, value in data:
        if isinstance(value, Expression):
            yield dimension, value
    for node in (node for tree in trees(problem) for node in walk(tree)):
        if isinstance(node, Quantity) and isinstance(node.stage, AtTime):
            yield TIME, node.stage.time


def is_number(tree: Expression) -> bool:
    """Whether a value, or one of its terms or components, is a number other than zero.

    An angle's letter does not count: 5 cos α is a number.
    """
    match tree:
        case Pair(x, y):
            return is_number(x) or is_number(y)
        case Polar(size):
            return is_number(size)
        case Negate(operand):
            return is_number(operand)
        case Binary("+" | "-", left, right):
            return is_number(left) or is_number(right)
        case Binary("*", left, right) if _axes(left) or _axes(right):
            # u(2i + j): a factor with letters leaves no term without them
            plain = [tree for tree in (left, right) if not _axes(tree)]
            return all(not _scaling(tree) for tree in plain) and all(
                is_number(tree) for tree in (left, right) if _axes(tree)
            )
        case Number(value):
            return value != 0
        case Quantity() | Name():
            return False
    return not _scaling(tree)


def _axes(tree: Expression) -> bool:
    """Whether a tree is a vector, from the way it is written."""
    match tree:
        case Unit() | Pair() | Polar():
            return True
        case Negate(operand):
            return _axes(operand)
        case Binary("+" | "-" | "*" | "/", left, right):
            return _axes(left) or _axes(right)
    return False


def _scaling(tree: Expression) -> bool:
    """Whether a term holds a letter that is more than an angle."""
    match tree:
        case Letter():
            return True
        case Apply(function, argument):
            return function in ("sqrt", "abs") and _scaling(argument)
        case Negate(operand):
            return _scaling(operand)
        case Binary(_, left, right):
            return _scaling(left) or _scaling(right)
    return False
