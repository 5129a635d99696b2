"""A problem taken apart into the pieces of which a form is made: the page's form reads these.

Every expression is text, which reads back as an equal tree; nothing here loads SymPy.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import TYPE_CHECKING, Any

from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
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
    has_unit_vector,
    is_quantity,
    negated,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.language.writing import item_text, relation_text
from restitution.problem import (
    Arrival,
    AtRest,
    Compare,
    Find,
    Given,
    Impact,
    Item,
    Kick,
    Meets,
    Problem,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Value,
    Wall,
)

if TYPE_CHECKING:
    from restitution.export.objects import (
        AskedObject,
        DirectionObject,
        OutlineObject,
        RelationOutline,
        SphereObject,
        StepOutline,
        VelocityObject,
        WallObject,
    )


def outline(problem: Problem) -> OutlineObject:
    """The pieces of a problem, as an object of JSON.

    A velocity and a direction tell by their ``way`` how they are given. An item and a relation have
    their ``text``, and ``staged``, the same with every stage as a number.
    """
    steps = _Steps(problem)
    return {
        "title": problem.title,
        "parts": [part.label for part in problem.parts],
        "spheres": [_sphere(sphere) for sphere in problem.spheres],
        "walls": [_wall(wall) for wall in problem.walls],
        "points": [point.name for point in problem.points],
        "steps": list(steps.steps()),
    }


def _text(value: Any) -> str | None:
    return write_expression(value) if isinstance(value, Expression) else None


def _line(step: Any) -> int | None:
    return step.place.line if step.place is not None else None


def _sphere(sphere: Sphere) -> SphereObject:
    return {
        "name": sphere.name,
        "line": _line(sphere),
        "mass": _text(sphere.mass),
        "radius": _text(sphere.radius),
        "placed": sphere.position is not None,
        "velocity": _velocity(sphere.velocity),
    }


def _wall(wall: Wall) -> WallObject:
    return {
        "name": wall.name,
        "line": _line(wall),
        "along": _direction(wall.along),
        "placed": wall.shape.is_placed,
    }


def _velocity(tree: Any) -> VelocityObject | None:
    if not isinstance(tree, Expression):
        return None
    if isinstance(tree, Polar):
        return {
            "way": "polar",
            "size": _text(tree.size),
            "angle": _text(tree.angle),
            "origin": _text(tree.origin),
            "wall": _text(tree.wall),
            "text": _text(tree),
        }
    if isinstance(tree, Pair):
        zero = all(
            isinstance(component, Number) and not component.value for component in (tree.x, tree.y)
        )
        if zero:
            return {"way": "rest"}
        return {"way": "components", "x": _text(tree.x), "y": _text(tree.y)}
    components = _components(tree)
    if components is None:
        return {"way": "vector", "text": _text(tree)}
    x, y = components
    return {"way": "components", "x": _text(x) or "0", "y": _text(y) or "0"}


def _components(tree: Expression) -> tuple[Expression | None, Expression | None] | None:
    """The factors of **i** and **j** in a sum of their multiples; None for any other vector."""
    match tree:
        case Unit(axis):
            one = _number(1)
            return (one, None) if axis == "i" else (None, one)
        case Negate(operand):
            inner = _components(operand)
            return None if inner is None else (_negative(inner[0]), _negative(inner[1]))
        case Binary("*", left, Unit(axis)) if not has_unit_vector(left):
            return (left, None) if axis == "i" else (None, left)
        case Binary("+" | "-", left, right):
            first, second = _components(left), _components(right)
            if first is None or second is None:
                return None
            if tree.op == "-":
                second = (_negative(second[0]), _negative(second[1]))
            if any(a is not None and b is not None for a, b in zip(first, second, strict=True)):
                return None
            return (first[0] or second[0], first[1] or second[1])
    return None


def _number(value: int) -> Expression:
    from fractions import Fraction

    return Number(Fraction(value))


def _negative(tree: Expression | None) -> Expression | None:
    return None if tree is None else negated(tree)


def _direction(tree: Any) -> DirectionObject | None:
    if not isinstance(tree, Expression):
        return None
    if isinstance(tree, Unit):
        return {"way": tree.axis, "text": tree.axis}
    is_vector = any(
        isinstance(node, Unit | Pair | Polar) or is_quantity(node, "velocity", "line_of_centres")
        for node in walk(tree)
    )
    is_angle = not is_vector and not any(isinstance(node, Name) for node in walk(tree))
    return {"way": "angle" if is_angle else "vector", "text": _text(tree)}


class _Steps:
    """The steps of a problem in order, and which events each body takes part in."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._bodies: dict[str, list[int]] = {sphere.name: [] for sphere in problem.spheres}
        self._now = 0

    def steps(self) -> Iterator[StepOutline]:
        for part, step in self._problem.steps():
            kind = type(step).__name__.lower()
            head: StepOutline = {
                "kind": kind,
                "part": part.label,
                "line": _line(step),
                "after": self._now,
            }
            yield {**head, **self._step(step)}

    def _step(self, step: Step) -> StepOutline:
        match step:
            case Impact():
                self._event(step.first, step.second)
                return {
                    "first": step.first,
                    "second": step.second,
                    "e": _text(step.e),
                    "along": _direction(step.along),
                    "offset": _text(step.offset),
                }
            case Kick() | Arrival():
                self._event(step.body)
            case Unknown(letters):
                return {"letters": _letters(letters)}
            case Given():
                return {"relations": [self._relation(relation) for relation in step.relations]}
            case Find():
                return {
                    "items": [self._item(item) for item in step.items],
                    "in_terms_of": _letters(step.in_terms_of),
                }
            case Show():
                return {
                    "relations": [self._relation(step.relation)],
                    "subject": None if step.subject is None else item_text(step.subject),
                    "in_terms_of": _letters(step.in_terms_of),
                }
        return {}

    def _event(self, *bodies: str) -> None:
        self._now += 1
        for body in self._bodies.keys() & set(bodies):  # walls have no stages
            self._bodies[body].append(self._now)

    def _item(self, item: Item) -> AskedObject:
        staged = self._staged(item)
        return {
            "text": item_text(item),
            "staged": item_text(staged),
            "value": _text(staged.expression) if isinstance(staged, Value) else None,
            "percentage": item.percentage,
        }

    def _relation(self, relation: Relation) -> RelationOutline:
        content: RelationOutline = {"text": relation_text(self._problem, relation), "staged": None}
        if isinstance(relation, AtRest | Meets):
            return content
        staged = self._staged(relation)
        content["staged"] = relation_text(self._problem, staged)
        if isinstance(staged, Compare) and len(staged.operands) == 2:
            left, right = staged.operands
            figures = "" if staged.figures is None else f" to {staged.figures} s.f."
            content["left"], content["sign"] = _text(left), staged.operators[0]
            content["right"] = f"{_text(right)}{figures}"
        return content

    def _staged(self, value: Any) -> Any:
        """The same with the stage of each quantity told by the number of its event."""
        if isinstance(value, tuple):
            return tuple(map(self._staged, value))
        if not is_dataclass(value) or isinstance(value, type | AtTime):
            return value
        changes = {
            field.name: self._staged(getattr(value, field.name))
            for field in fields(value)
            if field.name not in ("place", "stage")
        }
        staged = replace(value, **changes)
        if not isinstance(staged, Quantity) or not KINDS[staged.kind].staged:
            return staged
        if any(isinstance(n, Name) and n.name not in self._bodies for n in staged.arguments):
            return staged  # the direction of a wall
        return replace(staged, stage=self._stage(staged))

    def _stage(self, quantity: Quantity) -> Any:
        if isinstance(quantity.stage, AtTime):
            return quantity.stage
        stage = quantity.stage
        last = stage if isinstance(stage, int) else self._now
        own: Sequence[int] = range(1, last + 1)
        if len(quantity.arguments) == 1 and isinstance(quantity.arguments[0], Name):
            own = [n for n in self._bodies.get(quantity.arguments[0].name, []) if n <= last]
        latest = own[-1] if own else 0
        return max(latest - 1, 0) if stage == "before" else latest


def _letters(letters: Sequence[str] | None) -> str | None:
    return ", ".join(write_expression(Letter(letter)) for letter in letters) if letters else None
