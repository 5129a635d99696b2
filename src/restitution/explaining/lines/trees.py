"""Trees of lines rebuilt: other names, other stages, one form for what is the same."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from operator import is_
from typing import Any

from restitution.explaining.lines.derivation import FLIPPED, Event, Line, Link, Meaning, Relation
from restitution.expression.quantities import LASTING, LOSSES
from restitution.expression.tree import (
    LEAVES,
    PARTS,
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Name,
    Number,
    Quantity,
    has_quantity,
    walk,
)


def compounds_rebuilt(tree: Expression, change: Callable[[Expression], Expression]) -> Expression:
    """A tree with each node changed, innermost first, but for letters, numbers and names."""
    if type(tree) in LEAVES:
        return tree
    if type(tree) is Apply:
        argument = compounds_rebuilt(tree.argument, change)
        same = argument is tree.argument
        return change(tree if same else Apply(tree.function, argument, place=tree.place))
    if type(tree) is not Binary:
        return rebuilt(tree, lambda node: node if type(node) in LEAVES else change(node))
    left, right = tree.left, tree.right
    own = left if type(left) in LEAVES else compounds_rebuilt(left, change)
    other = right if type(right) in LEAVES else compounds_rebuilt(right, change)
    if own is not left or other is not right:
        tree = Binary(tree.op, own, other, place=tree.place)
    return change(tree)


def rebuilt(tree: Expression, change: Callable[[Expression], Expression]) -> Expression:
    """A tree with each node changed, innermost first."""
    if type(tree) in LEAVES:
        return change(tree)
    if type(tree) is Binary:
        left, right = rebuilt(tree.left, change), rebuilt(tree.right, change)
        if left is not tree.left or right is not tree.right:
            tree = Binary(tree.op, left, right, place=tree.place)
        return change(tree)
    if type(tree) is Apply:
        argument = rebuilt(tree.argument, change)
        if argument is not tree.argument:
            tree = Apply(tree.function, argument, place=tree.place)
        return change(tree)
    put: dict[str, Any] = {}
    for name in PARTS[type(tree)]:
        value = getattr(tree, name)
        if type(value) in _PLAIN:
            continue
        new = _rebuilt(value, change)
        if new is not value:
            put[name] = new
    return change(replace(tree, **put) if put else tree)


# Of what is inside a node that is no tree.
_PLAIN = frozenset({str, int, type(None)})


def angles_with_both_ratios(trees: Iterable[Expression]) -> frozenset[Expression]:
    """The angles of which both the sine and the cosine stand in some trees."""
    ratios = {
        (e.function, e.argument) for tree in trees for e in walk(tree) if isinstance(e, Apply)
    }
    return frozenset(angle for name, angle in ratios if name == "sin" and ("cos", angle) in ratios)


def has_ratio_of_a_sum(tree: Expression) -> bool:
    """Whether the sine or the cosine of a sum or a difference of angles stands in a tree."""
    return any(
        node.function in ("sin", "cos") and node.argument.op in ("+", "-")
        for node in walk(tree)
        if isinstance(node, Apply) and isinstance(node.argument, Binary)
    )


def degrees_worked_out(tree: Expression) -> Expression:
    """A tree with sums and multiples of degrees as one number of degrees: 90° − 55° as 35°."""
    return rebuilt(tree, _in_degrees)


def _in_degrees(tree: Expression) -> Expression:
    match tree:
        case Binary("+", Degrees(one), Degrees(other)):
            return Degrees(one + other, place=tree.place)
        case Binary("-", Degrees(one), Degrees(other)):
            return Degrees(one - other, place=tree.place)
        case Binary("*", Number(times), Degrees(one)) | Binary("*", Degrees(one), Number(times)):
            return Degrees(one * times, place=tree.place)
        case Binary("/", Degrees(one), Number(parts)) if parts:
            return Degrees(one / parts, place=tree.place)
    return tree


def exchanged(tree: Expression, values: Mapping[Expression, Expression]) -> Expression:
    """A tree with others in place of some of its parts, outermost first."""
    if not values:
        return tree
    if tree in values:
        return values[tree]
    if type(tree) in LEAVES:
        return tree
    if type(tree) is Binary:
        left, right = exchanged(tree.left, values), exchanged(tree.right, values)
        same = left is tree.left and right is tree.right
        return tree if same else Binary(tree.op, left, right, place=tree.place)
    put: dict[str, Any] = {}
    for name in PARTS[type(tree)]:
        value = new = getattr(tree, name)
        if type(value) in PARTS:
            new = exchanged(value, values)
        elif isinstance(value, tuple):
            own = [exchanged(other, values) if type(other) in PARTS else other for other in value]
            new = value if all(map(is_, own, value)) else tuple(own)
        if new is not value:
            put[name] = new
    return replace(tree, **put) if put else tree


def _rebuilt(value: object, change: Callable[[Expression], Expression]) -> object:
    if isinstance(value, tuple):
        new = tuple(_rebuilt(other, change) for other in value)
        return new if any(a is not b for a, b in zip(new, value, strict=True)) else value
    if isinstance(value, AtTime):
        time = rebuilt(value.time, change)
        return value if time is value.time else AtTime(time)
    return rebuilt(value, change) if type(value) in PARTS else value  # type: ignore[arg-type]


def of_relation(relation: Relation, change: Callable[[Expression], Expression]) -> Relation:
    """A relation with each node of its trees changed; the same object where none is."""
    sides = [rebuilt(tree, change) for tree in relation.trees]
    if all(map(is_, sides, relation.trees)):
        return relation
    own = iter(sides)
    return Relation(
        tuple(
            tuple(Link(next(own), link.sign, next(own), link.by) for link in links)
            for links in relation.options
        )
    )


def trees_of(relation: Relation | Meaning) -> tuple[Expression, ...]:
    """The trees of a relation, or of a meaning."""
    return relation.trees


def has_quantity_in(relation: Relation) -> bool:
    """Whether a relation speaks of a quantity of the motion."""
    return any(map(has_quantity, relation.trees))


def is_share_of_energy(line: Line) -> bool:
    """Whether a line says what an energy, or a loss, is as a share of an energy before."""
    match line.relation:
        case Relation(((Link(Binary("/", Quantity(kind), Quantity("energy")), "="), *_),)) if (
            kind == "energy" or kind in LOSSES
        ):
            return True
    return False


def statement_of(relation: Relation) -> frozenset[frozenset[object]]:
    """What a relation says, whichever way round it is written."""
    return frozenset(frozenset(_turned(link) for link in links) for links in relation.options)


def _turned(link: Link) -> object:
    if link.sign in (">", ">="):
        return (FLIPPED[link.sign], link.right, link.left)
    if link.sign in ("=", "!=", "parallel to", "perpendicular to"):
        return (link.sign, frozenset((link.left, link.right)))
    return (link.sign, link.left, link.right)


def renamed(relation: Relation, names: Mapping[str, str], event: int) -> Relation | None:
    """A template for an event: its bodies by name, and its stages by number.

    None where it speaks of a body for which there is no name.
    """
    wanted = {
        node.name for tree in trees_of(relation) for node in walk(tree) if isinstance(node, Name)
    }
    if not wanted <= names.keys():
        return None

    def change(tree: Expression) -> Expression:
        if isinstance(tree, Name):
            return Name(names[tree.name])
        if isinstance(tree, Quantity) and isinstance(tree.stage, int):
            return replace(tree, stage=tree.stage + event - 1)
        return tree

    return of_relation(relation, change)


def settled(tree: Expression, events: tuple[Event, ...]) -> Expression:
    """A tree in which a velocity has the number of the last event that changed it.

    To come to a point, or to a wall, changes none.
    """
    if not has_quantity(tree):
        return tree
    for node in walk(tree):
        if isinstance(node, Quantity) and node is not _settled_alone(node, events):
            return _settled(tree, events)
    return tree  # as most are: nothing is looked up for these


def _settled_alone(tree: Expression, events: tuple[Event, ...]) -> Expression:
    """A velocity with the number of the last event that changed it; anything else as it is."""
    if not (isinstance(tree, Quantity) and tree.kind in LASTING and tree.arguments):
        return tree
    (body,) = tree.arguments
    if not isinstance(tree.stage, int) or not isinstance(body, Name):
        return tree
    last = 0
    for event in events:
        if event.number <= tree.stage and event.kind != "arrival" and body.name in event.bodies[:2]:
            last = max(last, event.number)
    return tree if last == tree.stage else replace(tree, stage=last)


@lru_cache(maxsize=4096)
def _settled(tree: Expression, events: tuple[Event, ...]) -> Expression:
    return rebuilt(tree, lambda node: _settled_alone(node, events))


def squared(tree: Expression) -> Expression:
    """The square of a tree."""
    return Binary("^", tree, Number(Fraction(2)))
