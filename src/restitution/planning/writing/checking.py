"""Lines tried in numbers: no line is shown that is not true at the numbers of its solution."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from restitution.components.models import Model
from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Fact, Line, Link, Meaning, Relation
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Angle, Evaluator
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Negate,
    Number,
    Quantity,
    letters,
)
from restitution.planning.writing.desk import NotPlannedError
from restitution.solving.story import quantities
from restitution.vector import Vector

# Two sides that agree to this share of the larger are equal in doubles.
_ROUNDING = 1e-8
# What is printed with ≈ has at least three figures.
_PRINTED = 6e-3


class Floats:
    """Double precision, for the evaluation of trees."""

    exact = False
    pi = math.pi
    zero = 0.0

    def number(self, value: Fraction) -> float:
        above, below = value.as_integer_ratio()
        return above / below

    def sqrt(self, x: float) -> float:
        return math.sqrt(x) if x > 0 else 0.0

    def abs(self, x: float) -> float:
        return abs(x)

    def power(self, x: float, y: float) -> float:
        return float(x**y)

    def cos_sin(self, x: float) -> tuple[float, float]:
        return math.cos(x), math.sin(x)

    def arctan2(self, y: float, x: float) -> float:
        return math.atan2(y, x)

    def arc(self, function: str, x: float) -> float:
        return float(getattr(math, function.replace("arc", "a"))(x))

    def is_zero(self, x: float) -> bool:
        return x == 0


def require_true(
    model: Model, lines: Iterable[Line], above: Iterable[Line], facts: Iterable[Fact]
) -> None:
    """Raises NotPlannedError for a line that is false at the numbers of a solution.

    ``above`` are all lines that may introduce letters, ``facts`` tell the senses of axes. A line
    that is true is not tried again, while letters have the same meanings.
    """
    above, facts = tuple(above), tuple(facts)
    meanings = frozenset(line.relation for line in above if isinstance(line.relation, Meaning))
    axes = frozenset(fact.relation for fact in facts if fact.id.startswith(("axis ", "let ")))
    if (meanings, axes) not in model.true:
        model.true[meanings, axes] = set(), _keeping(lambda: evaluator(model, above, facts))
    true, value = model.true[meanings, axes]
    for line in lines:
        if not isinstance(line.relation, Relation) or line.relation in true:
            continue
        if not holds(line.relation, value):
            raise NotPlannedError(f"line {line.number} is not true in numbers")
        true.add(line.relation)


def _keeping(make: Callable[[], Callable[[Expression], Any]]) -> Callable[[Expression], Any]:
    """A function, made when it is wanted, that keeps what trees are worth: sides come again."""
    worth: dict[Expression, Any] = {}
    own: list[Callable[[Expression], Any]] = []

    def kept(tree: Expression) -> Any:
        if tree not in worth:
            if not own:
                own.append(make())
            worth[tree] = own[0](tree)
        return worth[tree]

    return kept


def evaluator(
    model: Model, lines: Iterable[Line], facts: Iterable[Fact]
) -> Callable[[Expression], Any]:
    """What trees of some lines are worth in floats at the sample of a solution."""
    story = model.branch.numbers
    events = len(story.happenings)
    meanings = {
        line.relation.letter: line.relation for line in lines if isinstance(line.relation, Meaning)
    }
    axes = {
        fact.relation.only[0].left: fact.relation.only[0].right
        for fact in facts
        if fact.id.startswith("axis ")
    }
    # What a letter stands for in another part has no number of its own in the sample of this one.
    lets = {
        fact.id.removeprefix("let "): fact.relation.only[0].left
        for fact in facts
        if fact.id.startswith("let ")
        if fact.id.removeprefix("let ") not in model.story.lets
    }
    of_lines: dict[Expression, Any] = {}

    sample: dict[str, float] = {}

    def letter(name: str) -> Any:
        if name in sample:
            return sample[name]
        if name in lets:
            return own.value(lets[name])
        if name in model.sample:
            sample[name] = float(model.sample[name])
            return sample[name]
        if name in meanings:
            return own.value(meanings[name].quantity)
        symbol = model.unknowns.letter(name)
        if symbol in model.final:
            return float(model.number(model.final[symbol]))
        let = model.story.lets.get(name)
        if let is not None:
            return _floats(story.evaluator(let[1]).value(let[0].expression))
        raise KeyError(name)

    def quantity(tree: Quantity) -> Any:
        kept = of_lines if letters(tree) else model.floats
        if tree not in kept:
            if tree.kind == "restitution":
                number = tree.stage or 1
                kept[tree] = float(story.happenings[number - 1].e)  # type: ignore[operator]
            elif tree.kind in COMPONENTS and tree.arguments[1] in axes:
                axis = _floats(numbers.direction(axes[tree.arguments[1]]))
                direction = axis if tree.kind == "along" else axis.turned_left()
                kept[tree] = own.value(tree.arguments[0]).dot(direction) / _size(axis)
            else:
                try:
                    kept[tree] = _floats(quantities.quantity(story, tree, events))
                except UndefinedError:  # it holds a mass that nothing tells
                    kept[tree] = _at_sample(quantities.quantity(model.story, tree, events), model)
        return kept[tree]

    numbers = story.evaluator(events)
    own = Evaluator(
        Floats(),  # type: ignore[arg-type]
        letter,
        quantity,
        lambda tree: _floats(numbers.value(tree)),
        lambda tree: _floats(story.wall_direction(tree)),
    )
    return own.value


def _at_sample(value: Any, model: Model) -> Any:
    """A value in letters at the numbers of a solution."""
    if isinstance(value, Vector):
        return Vector(*(float(model.number(component)) for component in value))
    return float(model.number(value))


def _floats(value: Any) -> Any:
    if isinstance(value, Vector):
        return Vector(float(value.x), float(value.y))
    if isinstance(value, Angle):
        return Angle(float(value.x), float(value.y), lambda: float(value.measure()))
    return float(value)


def holds(relation: Relation, value: Callable[[Expression], Any]) -> bool:
    """Whether some option of a relation holds in numbers."""
    try:
        return any(all(_is_true(link, value) for link in links) for links in relation.options)
    except (
        KeyError,
        ArithmeticError,
        ValueError,
        TypeError,
        AttributeError,
        RestitutionError,
    ) as error:
        raise NotPlannedError(f"a line that cannot be tried: {error!r}") from error


def _is_true(link: Link, value: Callable[[Expression], Any]) -> bool:
    left, right = (measured(value(side)) for side in (link.left, link.right))
    if link.sign in ("parallel to", "perpendicular to"):
        a, b = (_direction(value) for value in (left, right))
        tie = a.cross(b) if link.sign == "parallel to" else a.dot(b)
        return bool(abs(tie) <= _ROUNDING * math.hypot(*a) * math.hypot(*b))
    if isinstance(left, Vector) or isinstance(right, Vector):
        a, b = (
            value if isinstance(value, Vector) else Vector(value, value) for value in (left, right)
        )
        apart = max(abs(a.x - b.x), abs(a.y - b.y))
        near = apart <= _ROUNDING * max(_size(a), _size(b))
        if not near:
            # What is left of vectors that cancel is compared with these.
            terms = (_magnitude(side, value) for side in (link.left, link.right))
            near = apart <= _ROUNDING * max(terms)
        return near if link.sign == "=" else not near
    gap: float = left - right
    size: float = max(abs(left), abs(right))
    match link.sign:
        case "=":
            if abs(gap) <= _ROUNDING * size:
                return True
            whole = (_magnitude(side, value) for side in (link.left, link.right))
            return abs(gap) <= _ROUNDING * max(size, *whole)
        case "≈":
            return abs(gap) <= _PRINTED * size
        case "!=":
            return abs(gap) > _ROUNDING * size
        case "<" | "<=":
            return gap <= _ROUNDING * size
        case _:
            return gap >= -_ROUNDING * size


def _magnitude(tree: Expression, value: Callable[[Expression], Any]) -> float:
    """What a tree would be worth if nothing in it cancelled: rounding is a share of that."""
    match tree:
        case Binary("+" | "-", left, right):
            return _magnitude(left, value) + _magnitude(right, value)
        case Binary("*", left, right):
            return _magnitude(left, value) * _magnitude(right, value)
        case Binary("/", left, right):
            return _magnitude(left, value) / _size(measured(value(right)))
        case Binary("^", base, Number(power)) if power > 0:
            return float(_magnitude(base, value) ** float(power))
        case Negate(operand):
            return _magnitude(operand, value)
        case Apply("sin" | "cos"):
            return 1.0
        case Quantity("along" | "across", (vector, _)):
            return _magnitude(vector, value)
    return max(_size(measured(value(tree))), 1e-300)


def measured(value: Any) -> Any:
    """A value; of an angle that in radians."""
    return value.measure() if isinstance(value, Angle) else value


def _direction(value: Any) -> Vector:
    return value if isinstance(value, Vector) else Vector(math.cos(value), math.sin(value))


def _size(value: Any) -> float:
    return math.hypot(*value) if isinstance(value, Vector) else abs(value)
