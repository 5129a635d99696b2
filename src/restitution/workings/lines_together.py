"""Which lines stand together: under a heading, in a sentence, above a line of centres."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import takewhile

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Line, Link, Meaning, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Expression,
    Letter,
    Quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.writing.forms import alike, negative, product, tree_of
from restitution.vector import Vector


def first_under_its_heading(
    lines: Sequence[Line], index: int, meanings: Mapping[str, Meaning]
) -> Line:
    """The line whose impact a line stands under: its own, or the next, for ratios put into that.

    Components of an impact into which values are put stand under the same heading as its laws.
    """
    line = lines[index]
    number = impact_of_a_value(line, meanings)
    if number is not None:
        below = (own for own in lines[index:] if impact_of_a_value(own, meanings) != number)
        after = next(below, line)
        return after if after.move.id == "law" and after.move.event == number else line
    ratios = list(takewhile(lambda line: line.move.id == "triangle", lines[index:]))
    after = lines[index + len(ratios)] if index + len(ratios) < len(lines) else line
    own = {ratio.number for ratio in ratios}
    of_an_impact = after.move.id in ("law", "define") and after.move.event is not None
    return after if of_an_impact and own.intersection(after.premises) else line


def impact_of_a_value(line: Line, meanings: Mapping[str, Meaning]) -> int | None:
    """The impact after which a component has the value that a line puts in; None of others."""
    match line.move.id, line.relation:
        case "put" | "rearrange", Relation(((Link(Letter(name), "="), *_),)) if name in meanings:
            own = meanings[name].quantity
        case "put", Relation(((Link(left, "="), *_),)):
            named = [letter for letter in sorted(letters(left)) if letter in meanings]
            own = meanings[named[0]].quantity if len(named) == 1 else left
        case _:
            return None
    match own:
        case Quantity("along" | "across", (Quantity("velocity", _, int(stage)), *_)):
            return stage
    return None


def resolved_with(lines: Sequence[Line]) -> Iterator[Line]:
    """A line; with what goes on in one row, or of a component those that are resolved with it."""
    first, *rest = lines
    yield first
    while first.shown == "inline" and rest:
        first, *rest = rest
        yield first
    if first.move.record == "component":
        for line in rest:
            if line.move.record != "component" or line.move.event != first.move.event:
                return
            if _is_afterwards(line) != _is_afterwards(first):
                return
            yield line


def _is_afterwards(line: Line) -> bool:
    """Whether a component is that of a velocity after the event of its line."""
    return isinstance(line.relation, Relation) and any(
        is_quantity(node, "velocity") and node.stage == line.move.event
        for node in walk(line.relation.options[0][0].left)
    )


def is_worked_out_below(lines: Sequence[Line], index: int) -> bool:
    """Whether the next line works out the vector to which a line of centres is parallel.

    Both then are one line: *parallel to (𝐢 + 𝐣) − (4𝐢 + 2𝐣) = −3𝐢 − 𝐣*.
    """
    line, below = lines[index], lines[index + 1 : index + 2]
    match line.relation, *(own.relation for own in below):
        case (
            Relation(((Link(one, "parallel to", first),),)),
            Relation(((Link(other, "parallel to", last),),)),
        ) if one == other and is_of_centres(line) and below[0].move.id == "rearrange":
            return between_parallels(first, last) is not None and below[0].premises == (
                line.number,
            )
    return False


def is_of_centres(line: Line) -> bool:
    """Whether a line says by a law, or by places, to what a line of centres is parallel."""
    match line.relation:
        case Relation(((Link(Quantity("line_of_centres"), "parallel to", _),),)):
            return line.move.id in ("law", "put")
    return False


def between_parallels(first: Expression, last: Expression) -> tuple[Expression, ...] | None:
    """What stands between a vector and a shorter one that is parallel to it.

    That is its value, and how many times the shorter one that is: *1.6𝐢 + 1.2𝐣 = 0.4(4𝐢 + 3𝐣)*.
    None of vectors that are not parallel.
    """
    a, b = in_letters(first), in_letters(last)
    if not (isinstance(a, Vector) and isinstance(b, Vector)) or not any(b):
        return None
    if sp.expand(a.x * b.y - a.y * b.x) != 0:
        return None
    factor = tidy((a.x if b.x != 0 else a.y) / (b.x if b.x != 0 else b.y))
    if factor == 1:
        return ()
    value = tree_of(Vector(tidy(a.x), tidy(a.y)))
    multiple = negative(last) if factor == -1 else product(tree_of(factor), last)
    return (multiple,) if alike(value, first) or value == multiple else (value, multiple)


def before_their_line(lets: Sequence[Meaning], lines: Sequence[Line]) -> bool:
    """Whether components along a line of centres stand above the line that says where it lies.

    Of letters that are used before that it is not so.
    """
    nodes = (node for meaning in lets for node in walk(meaning.quantity))
    axes = {node for node in nodes if is_quantity(node, "line_of_centres")}
    if len(axes) != 1:
        return False
    names = {meaning.letter for meaning in lets}
    for line in lines:
        if not isinstance(line.relation, Relation):
            continue
        trees = tuple(trees_of(line.relation))
        if any(names & letters(tree) for tree in trees):
            return False
        if line.relation.options[0][0].left in axes:
            return True
    return False
