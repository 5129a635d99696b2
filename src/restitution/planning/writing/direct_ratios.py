"""Ratios of two quantities by components in letters, where an angle that was found cancels."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Ref,
    Relation,
    citing,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Binary, Expression, Quantity, has_quantity, letters
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.direct_tangents import (
    PutIn,
    components_put_in,
    without_value,
)
from restitution.planning.writing.forms import tree_of


def with_direct_ratios(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no component is worked out for a ratio in which it cancels."""
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(Binary("/", Quantity(), Quantity()), "="), *_),)):
                if line.move.id == "put":
                    derivation = _shortened(derivation, line, oracle) or derivation
    return derivation


def _shortened(derivation: Derivation, ratio: Line, oracle: Oracle) -> Derivation | None:
    if len(ratio.premises) != 2 or not isinstance(ratio.relation, Relation):
        return None
    pair = [derivation.line(ref) for ref in ratio.premises]
    changed: dict[int, Line] = {}
    values: dict[Expression, Expression] = {}
    for own in pair:
        short = None if own is None else _in_letters(derivation, own, ratio)
        if own is None or short is None:
            return None
        changed[own.number], (before, after) = short
        values[before] = after
    links = ratio.relation.only
    quotient = rebuilt(links[0].right, lambda tree: values.get(tree, tree))
    final = links[-1].right
    if letters(final) or has_quantity(quotient) or quotient == links[0].right:
        return None
    if tidy(in_letters(quotient, positive=True) - in_letters(final)) != 0:
        return None
    relation = chain(links[0].left, (quotient, None), (final, "rearrange"))
    changed[ratio.number] = replace(ratio, relation=relation)
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    ranges = dict.fromkeys(r for own in pair if own for r in _ranges(derivation, own))
    mended = {
        number: replace(own, premises=read.completed(number, ranges))
        for number, own in changed.items()
    }
    whole = replace(whole, lines=tuple(mended.get(line.number, line) for line in lines))
    read = reader_of(whole, oracle)
    return whole if all(read.accepts(read.lines[number]) for number in changed) else None


def _ranges(derivation: Derivation, line: Line) -> list[Ref]:
    """What the ratios rest on that were put into a quantity, of the ranges of angles."""
    parts = components_put_in(derivation, line)
    ratios = [ratio for part in parts for ratio in part.ratios]
    return [ref for ratio in ratios for ref in ratio.premises if isinstance(ref, str)]


def _in_letters(
    derivation: Derivation, line: Line, ratio: Line
) -> tuple[Line, tuple[Expression, Expression]] | None:
    """The line of a quantity with nothing put into its components, and its values with and so.

    None where it is used for more than the ratio, or is asked.
    """
    users = [other.number for other in derivation.lines if line.number in other.premises]
    parts = list(components_put_in(derivation, line))
    if (
        line.move.id != "define"
        or users != [ratio.number]
        or line.number in derivation.held
        or not parts
    ):
        return None
    if not isinstance(line.relation, Relation) or len(line.relation.options) != 1:
        return None
    first, value = line.relation.only[0], line.relation.only[-1].right
    right: Expression = first.right
    for part in parts:
        right = rebuilt(right, _replacing(part))
    if has_quantity(right):
        return None
    short = tree_of(tidy(in_letters(right, positive=True)))
    numbers: dict[Ref, Ref] = {part.number: part.line.number for part in parts}
    relation = chain(first.left, (right, None), (short, "rearrange"))
    own = replace(line, relation=relation, premises=citing(line.premises, numbers))
    return own, (value, short)


def _replacing(part: PutIn) -> Callable[[Expression], Expression]:
    return lambda tree: without_value(tree, part)


__all__ = ["with_direct_ratios"]
