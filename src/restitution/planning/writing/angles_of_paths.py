"""The angle of a path with a line in the sense in which it is one: α − β, and never β − α."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.explaining.data.paths_and_lines import (
    angles_between,
    turn_of_line,
    turn_of_path,
)
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import exchanged, trees_of
from restitution.expression.tree import Apply, Binary, Expression, Negate, walk
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import swept


def with_angles_of_paths(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working with the sines of such angles, and not with those of the opposite ones."""
    put = {
        node: own
        for angle in dict.fromkeys(_angles(derivation))
        for node, own in _of_the_opposite(angle)
    }
    if not put:
        return derivation
    changed = {
        line.number: own for line in derivation.lines if (own := _with(line, put)) is not line
    }
    if not changed:
        return derivation
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    ends = tuple(
        replace(end, answer=_answered(end.answer, put)) if end.line in changed else end
        for end in derivation.items
    )
    whole = replace(derivation, lines=lines, items=ends)
    read = reader_of(whole, oracle)
    accepted = all(read.accepts(line) for line in changed.values())
    return whole if accepted else derivation


def _angles(derivation: Derivation) -> Iterator[Binary]:
    """The differences of two letters that lines have as angles of paths with lines."""
    written = {
        node.argument
        for line in derivation.lines
        if line.move.record in ("unchanged", "momentum", "restitution-wall")
        for tree in trees_of(line.relation)
        for node in walk(tree)
        if isinstance(node, Apply)
    }
    for event in derivation.events:
        own = f"wall {event.bodies[1]}" if event.wall else f"axis {event.number}"
        turn = turn_of_line(derivation.fact(own)) if len(event.bodies) > 1 else None
        for body in event.bodies:
            path = turn_of_path(derivation.fact(f"velocity {body}"))
            if path is None or turn is None:
                continue
            angles = [tree for tree in angles_between(path, turn) if tree in written]
            match angles[:1]:
                case [Binary("-", left, right) as first] if Binary("-", right, left) in written:
                    # The first link of a line has it as it is read off.
                    yield first if _is_read_off(derivation, first) else Binary("-", right, left)


def _is_read_off(derivation: Derivation, angle: Binary) -> bool:
    """Whether a line about what stays, or about momentum, has it."""
    return any(
        node == angle
        for line in derivation.lines
        if line.move.record in ("unchanged", "momentum")
        for tree in trees_of(line.relation)
        for node in walk(tree)
    )


def _of_the_opposite(angle: Binary) -> Iterator[tuple[Expression, Expression]]:
    other = Binary("-", angle.right, angle.left)
    yield Apply("cos", other), Apply("cos", angle)
    for function in ("sin", "tan"):
        yield Apply(function, other), Negate(Apply(function, angle))


def _with(line: Line, put: dict[Expression, Expression]) -> Line:
    if not isinstance(line.relation, Relation) or len(line.relation.options) > 1:
        return line
    links = line.relation.only
    if not any(node in put for tree in trees_of(line.relation) for node in walk(tree)):
        return line
    if any(link.sign != "=" for link in links):
        return line
    own = chain(_put(links[0].left, put), *((_put(link.right, put), link.by) for link in links))
    return replace(line, relation=own)


def _put(tree: Expression, put: dict[Expression, Expression]) -> Expression:
    new = exchanged(tree, put)
    return tree if new == tree else swept(new)


def _answered(answer: Relation, put: dict[Expression, Expression]) -> Relation:
    """The answer of an item that a line ends in."""
    (last,) = answer.only[-1:]
    links = (*answer.only[:-1], Link(last.left, last.sign, _put(last.right, put)))
    return Relation((links,))


__all__ = ["with_angles_of_paths"]
