"""What a problem must be to make sense: the bodies exist, and names stand only where they may."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from typing import Any

from restitution.errors import StatementError
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Place,
    Polar,
    Quantity,
    Unit,
    children,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.expression.words import meant_name, unknown_name
from restitution.expression.writing import write_expression
from restitution.mending import Edit, Fix
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Item,
    Kick,
    Let,
    Meets,
    Point,
    Problem,
    Range,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Value,
    Wall,
)
from restitution.records import dataclass

_POINT = frozenset(("point",))
_WALL = frozenset(("wall",))
_NOTHING: frozenset[str] = frozenset()
_SPHERE = frozenset(("sphere",))


@dataclass(frozen=True)
class _Bodies:
    """The declared names with what each is, and how many events are told in all."""

    kinds: Mapping[str, str]
    events: int
    lets: AbstractSet[str]


def check(problem: Problem) -> None:
    """Look for the mistakes in a problem that its grammar cannot show.

    Raises StatementError for the first, with its place where the problem was read from a text;
    the rest are its ``others``.
    """
    errors = list(mistakes(problem))
    if errors:
        errors[0].others = tuple(errors[1:20])
        raise errors[0]


def _error(message: str, place: Place | None) -> StatementError:
    return StatementError(message, *((place.line, place.column) if place else (None, None)))


def _unknown_name(bodies: _Bodies, name: str, place: Place | None) -> StatementError:
    """The mistake of a name that no line declares, with the one that was probably meant."""
    mistake = _error(unknown_name(name, bodies.kinds), place)
    meant = meant_name(name, bodies.kinds)
    if meant is not None and place is not None:
        end = place.column + len(name)
        edit = Edit(place.line, place.column, place.line, end, meant)
        mistake.fixes = (Fix(f"Replace '{name}' by '{meant}'", (edit,)),)
    return mistake


def mistakes(problem: Problem, more_events: int = 0) -> Iterator[StatementError]:
    """The mistakes in a problem, in the order of bodies and then of steps.

    ``more_events`` may be told beside those of the problem, in lines that cannot be read yet.
    """
    kinds: dict[str, str] = {}
    bodies_declared: list[Sphere | Wall | Point] = [
        *problem.spheres,
        *problem.walls,
        *problem.points,
    ]
    for body in bodies_declared:
        if body.name in kinds:
            yield _error(f"'{body.name}' is the name of a {kinds[body.name]} already", body.place)
        kinds.setdefault(body.name, _kind(body))
    event_count = len(problem.events) + more_events
    named = frozenset(step.letter for _, step in problem.steps() if isinstance(step, Let))
    bodies = _Bodies(kinds, event_count, named)
    for sphere in problem.spheres:
        for value, what in ((sphere.mass, "mass"), (sphere.radius, "radius")):
            yield from _scalar(bodies, value, what)
        yield from _vector(bodies, sphere.velocity, "velocity")
        yield from _at(bodies, sphere.position, _POINT)
    for wall in problem.walls:
        yield from _wall(bodies, wall)
    for point in problem.points:
        yield from _at(bodies, point.position, _POINT)
    lets: list[dict[str, Let]] = [{}]
    for part in problem.parts:
        if part.label is not None:
            lets = [lets[0], {}]
        for step in part.steps:
            yield from _step(bodies, step)
            if isinstance(step, Let):
                yield from _let(lets, step)


def _kind(body: Sphere | Wall | Point) -> str:
    return {Sphere: "sphere", Wall: "wall", Point: "point"}[type(body)]


def _let(lets: list[dict[str, Let]], step: Let) -> Iterator[StatementError]:
    for known in lets:
        if step.letter in known:
            yield _error(f"'{step.letter}' names something already", step.place)
    lets[-1][step.letter] = step


def _wall(bodies: _Bodies, wall: Wall) -> Iterator[StatementError]:
    straight = wall.along is not None or wall.through is not None
    segment = wall.start is not None or wall.end is not None
    circle = wall.centre is not None or wall.radius is not None
    if straight + segment + circle > 1:
        yield _error(
            f"the wall {wall.name} is either along a direction, or from a point to a point, or a "
            "circle",
            wall.place,
        )
    if (wall.centre is None) != (wall.radius is None):
        yield _error(f"a circle has a centre and a radius: wall {wall.name}", wall.place)
    if (wall.start is None) != (wall.end is None):
        yield _error(f"a segment goes from a point to a point: wall {wall.name}", wall.place)
    yield from _vector(bodies, wall.along, "along", angle=True)
    yield from _scalar(bodies, wall.radius, "radius")
    for point in (wall.through, wall.start, wall.end, wall.centre):
        yield from _at(bodies, point, _POINT)


def _step(bodies: _Bodies, step: Step) -> Iterator[StatementError]:
    match step:
        case Impact():
            yield from _impact(bodies, step)
        case Kick(body, impulse):
            yield from _body(bodies, body, _SPHERE, step.place)
            if isinstance(impulse, Binary) and _first_factor(impulse) == Quantity("impulse"):
                place = _place_of(_first_factor(impulse))
                yield _error("leave out 'impulse': expected a vector after 'receives'", place)
            yield from _vector(bodies, impulse, "receives")
        case Arrival(body, target):
            yield from _body(bodies, body, _SPHERE, step.place)
            yield from _at(bodies, target, _POINT | _WALL)
        case Let(_, expression):
            yield from _in(bodies, expression, _POINT)
        case Given(relations):
            for relation in relations:
                yield from _relation(bodies, relation)
        case Find(items):
            for item in items:
                yield from _item(bodies, item)
        case Show(relation, subject):
            if subject is not None:
                yield from _item(bodies, subject)
            yield from _relation(bodies, relation)
        case Unknown():
            pass


def _wall_first(step: Impact) -> StatementError:
    """The mistake of a wall that hits a sphere, with the names exchanged."""
    typed, meant = f"{step.first} hits {step.second}", f"{step.second} hits {step.first}"
    mistake = _error(f"a sphere hits a wall: did you mean '{meant}'?", step.place)
    if step.place is not None:
        line, column = step.place.line, step.place.column
        mistake.fixes = (
            Fix(f"Write '{meant}'", (Edit(line, column, line, column + len(typed), meant),)),
        )
    return mistake


def _impact(bodies: _Bodies, step: Impact) -> Iterator[StatementError]:
    if [bodies.kinds.get(name) for name in (step.first, step.second)] == ["wall", "sphere"]:
        yield _wall_first(step)
        return
    yield from _body(bodies, step.first, _SPHERE, step.place)
    yield from _body(bodies, step.second, _SPHERE | _WALL, step.place)
    if step.first == step.second:
        yield _error(f"{step.first} cannot hit itself", step.place)
    elif bodies.kinds.get(step.second) == "wall":
        for value, word in ((step.along, "along"), (step.offset, "offset")):
            if value is not None:
                yield _error(
                    f"an impact with a wall takes no '{word}': its line is the normal of the wall",
                    _place_of(value) or step.place,
                )
    elif step.along is not None and step.offset is not None:
        yield _error("an impact takes 'along' or 'offset', not both", step.place)
    yield from _scalar(bodies, step.e, "e")
    yield from _vector(bodies, step.along, "along", angle=True)
    yield from _scalar(bodies, step.offset, "offset")


def _relation(bodies: _Bodies, relation: Relation) -> Iterator[StatementError]:
    match relation:
        case Compare(operands):
            for operand in operands:
                yield from _in(bodies, operand, _POINT)
        case Aligned(left, _, right):
            yield from _in(bodies, left, _WALL)
            yield from _in(bodies, right, _WALL)
        case AtRest(body):
            yield from _body(bodies, body.name, _SPHERE, body.place)
        case Meets(first, second):
            yield from _body(bodies, first.name, _SPHERE, first.place)
            yield from _body(bodies, second.name, _SPHERE | _WALL, second.place)
            if first.name == second.name:
                yield _error(f"{first.name} cannot hit itself", first.place)


def _item(bodies: _Bodies, item: Item) -> Iterator[StatementError]:
    match item:
        case Extremum(_, expression, over):
            yield from _in(bodies, expression, _NOTHING)
            yield from _in(bodies, over, _NOTHING)
        case Range(expression):
            yield from _in(bodies, expression, _NOTHING)
        case Value(expression):
            yield from _in(bodies, expression, _POINT)


def _body(
    bodies: _Bodies, name: str, may_be: AbstractSet[str], place: Place | None
) -> Iterator[StatementError]:
    kind = bodies.kinds.get(name)
    if kind is None:
        yield _unknown_name(bodies, name, place)
    elif kind not in may_be:
        wanted = " or a ".join(sorted(may_be))
        yield _error(f"'{name}' is the name of a {kind}: expected a {wanted} here", place)


def _place_of(value: Any) -> Place | None:
    return getattr(value, "place", None)


def _scalar(bodies: _Bodies, value: Any, what: str) -> Iterator[StatementError]:
    if _is_vector(value) or (isinstance(value, Expression) and _holds_unit(value)):
        yield _error(f"expected a number after '{what}', not a vector", _place_of(value))
    yield from _in(bodies, value, _NOTHING)


def _vector(
    bodies: _Bodies, value: Any, what: str, *, angle: bool = False
) -> Iterator[StatementError]:
    if isinstance(value, Name):
        wanted = "a vector or an angle" if angle else "a vector"
        kind = bodies.kinds.get(value.name)
        remedy = f": write direction({value.name})" if kind == "wall" else ""
        yield _error(
            f"expected {wanted} after '{what}', not the name {value.name}{remedy}", value.place
        )
        return
    if not angle and isinstance(value, Expression) and _is_number(bodies, value):
        message = f"expected a vector after '{what}', such as 3i - 4j"
        if not has_quantity(value):
            size = write_expression(value)
            along = write_expression(Binary("*", value, Unit("i")))
            message = (
                f"expected a vector after '{what}', and {size} has no direction: write "
                f"'{what} {along}' where it is along i, or '{what} {size} at 30°'"
            )
        yield _error(message, _place_of(value))
    yield from _in(bodies, value, _NOTHING)


def _at(bodies: _Bodies, value: Any, may_be: AbstractSet[str]) -> Iterator[StatementError]:
    """Mistakes in what is a point, or the name of a body of the given kinds."""
    if isinstance(value, Expression) and not isinstance(value, Name) and _is_number(bodies, value):
        yield _error("expected a point, such as (2a, a)", _place_of(value))
    yield from _in(bodies, value, may_be)


def _is_vector(tree: Any) -> bool:
    """Whether an expression is surely a vector, from the way it is written."""
    match tree:
        case Pair() | Polar():
            return True
        case Negate(operand):
            return _is_vector(operand)
        case Binary("+" | "-", left, right):
            return _is_vector(left) or _is_vector(right)
    return False


def _is_number(bodies: _Bodies, tree: Expression) -> bool:
    """Whether an expression holds numbers and letters alone, but is not zero."""
    if isinstance(tree, Number) and tree.value == 0:
        return False
    for node in walk(tree):
        if isinstance(node, Quantity | Pair | Polar | Name) or type(node).__name__ == "Unit":
            return False
        if isinstance(node, Letter) and node.name in bodies.lets:
            return False  # it may name a vector
    return True


def _in(bodies: _Bodies, tree: Any, may_be: AbstractSet[str]) -> Iterator[StatementError]:
    """Mistakes in an expression that may itself be the name of a body of the given kinds."""
    if not isinstance(tree, Expression):
        return
    pending: list[tuple[Expression, AbstractSet[str], Expression | None]] = [(tree, may_be, None)]
    while pending:
        node, allowed, parent = pending.pop()
        if isinstance(node, Name):
            yield from _name(bodies, node, allowed, parent)
        elif isinstance(node, Quantity):
            yield from _quantity(bodies, node)
        elif isinstance(node, Polar) and _holds_unit(node.angle):
            yield _direction_for_angle(node.angle)
        elif is_binary(node, "+", "-"):
            yield from _sum(bodies, node)
        elif is_binary(node, "*") and all(map(_holds_unit, (node.left, node.right))):
            yield _error(
                "two vectors cannot be multiplied: dot(…, …) is their product",
                _place_of(node.right) or node.place,
            )
        elif isinstance(node, Pair):
            for component in filter(_holds_unit, (node.x, node.y)):
                yield _error(
                    "expected a number in (x, y), not a vector: write (3, 4) or 3i + 4j",
                    _place_of(component),
                )
        pending.extend((child, _allowed(node, child), node) for child in reversed(children(node)))


def _direction_for_angle(tree: Expression) -> StatementError:
    """The mistake of a vector behind 'at': an angle from it, or its own direction, is meant."""
    mistake = _error(
        "expected an angle after 'at', not a vector: write 'u at 30° from i', or "
        "'u at 0° from 3i + 4j' for its direction",
        _place_of(tree),
    )
    match tree:
        case Binary("*", angle, Unit() as unit) if not _holds_unit(angle):
            at, before = unit.place, "from "
        case _:
            at, before = _place_of(tree), "0° from "
    if at is not None:
        edit = Edit(at.line, at.column, at.line, at.column, before)
        mistake.fixes = (Fix(f"Put in '{before.strip()}'", (edit,)),)
    return mistake


def _first_factor(tree: Expression) -> Expression:
    """What stands first in an expression."""
    while isinstance(tree, Binary):
        tree = tree.left
    return tree


def _sum(bodies: _Bodies, node: Binary) -> Iterator[StatementError]:
    """A vector and a number, added."""
    for vector, number in ((node.left, node.right), (node.right, node.left)):
        if _holds_unit(vector) and _is_number(bodies, number):
            named = sorted(letters(number))
            read = " and ".join(named) + (" is a letter" if len(named) == 1 else " are letters")
            yield _error(
                "a vector and a number cannot be added: a vector is made of i and j"
                + (f", and {read} here" if named else ""),
                _place_of(number) or node.place,
            )


def _holds_unit(tree: Expression) -> bool:
    """Whether an expression is a multiple of i or j, or a sum with one."""
    pending = [tree]
    while pending:
        node = pending.pop()
        if isinstance(node, Unit | Pair):
            return True
        if isinstance(node, Negate) or is_binary(node, "+", "-", "*"):
            pending.extend(children(node))
        elif is_binary(node, "/"):
            pending.append(node.left)
    return False


def _allowed(parent: Expression, child: Expression) -> AbstractSet[str]:
    """What a name may be that stands directly inside ``parent``."""
    match parent:
        case Quantity(kind, arguments):
            allowed = KINDS[kind].names if kind in KINDS else _SPHERE
            return allowed if child in arguments else _NOTHING
        case Polar():
            return _WALL if child is parent.wall else _NOTHING
        case Binary() | Negate():
            return _POINT
        case _:
            return _POINT if type(parent).__name__ == "Apply" else _NOTHING


def _name(
    bodies: _Bodies, node: Name, allowed: AbstractSet[str], parent: Expression | None
) -> Iterator[StatementError]:
    kind = bodies.kinds.get(node.name)
    if kind is None:
        yield _unknown_name(bodies, node.name, node.place)
    elif kind not in allowed:
        of_vectors = kind == "sphere" and isinstance(parent, Quantity) and parent.kind in KINDS
        if isinstance(parent, Polar) and parent.origin is node and kind == "wall":
            message = f"to measure an angle to a wall, write 'to {node.name}'"
        elif of_vectors and isinstance(parent, Quantity):
            message = (
                f"'{parent.kind}' takes no sphere itself: perhaps velocity({node.name}); "
                f"it is written {KINDS[parent.kind].usage}"
            )
        elif isinstance(parent, Quantity):
            wanted = " or a ".join(sorted(allowed)) or "vector"
            message = f"'{node.name}' is the name of a {kind}: '{parent.kind}' takes a {wanted}"
            body = next((other.name for other in _bodies_in(bodies, parent)), None)
            if parent.kind == "distance" and kind == "wall" and body is not None:
                message += f"; 'position({body})' tells how far it is from {node.name}"
        elif parent is None and kind == "sphere":
            message = (
                f"'{node.name}' is the name of a sphere: write which quantity, "
                f"such as velocity({node.name})"
            )
        else:
            message = (
                f"'{node.name}' is the name of a {kind} and cannot stand for a letter or a vector"
            )
        mistake = _error(message, node.place)
        if of_vectors and node.place is not None:
            line, column = node.place.line, node.place.column
            edit = Edit(line, column, line, column + len(node.name), f"velocity({node.name})")
            mistake.fixes = (Fix(f"Write velocity({node.name})", (edit,)),)
        yield mistake


def _bodies_in(bodies: _Bodies, quantity: Quantity) -> Iterator[Name]:
    """The spheres that are arguments of a quantity."""
    for argument in quantity.arguments:
        if isinstance(argument, Name) and bodies.kinds.get(argument.name) == "sphere":
            yield argument


def _quantity(bodies: _Bodies, node: Quantity) -> Iterator[StatementError]:
    """The arguments that must be bodies, and the event that must have been told."""
    record = KINDS.get(node.kind)
    takes_a_body = record is None or (
        record.names <= {"sphere", "wall"} and "sphere" in record.names
    )
    for argument in node.arguments if takes_a_body else ():
        if isinstance(argument, Letter) and (
            argument.name[0].isupper() or argument.name.capitalize() in bodies.kinds
        ):
            yield _unknown_name(bodies, argument.name.replace("_", ""), argument.place)
        elif not isinstance(argument, Name):
            yield _error(
                f"expected the name of a sphere: {KINDS[node.kind].usage}"
                if node.kind in KINDS
                else "expected the name of a sphere",
                _place_of(argument) or node.place,
            )
    if isinstance(node.stage, int):
        if node.stage > bodies.events:
            count = f"{bodies.events} {'event is' if bodies.events == 1 else 'events are'} told"
            yield _error(f"there is no event {node.stage}: {count}", node.place)
        elif node.stage == 0 and record is not None and record.of_an_event:
            yield _error(f"events are numbered from 1: there is no {node.kind} at 0", node.place)
