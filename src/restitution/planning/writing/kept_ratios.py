"""A component by the angle at which a body moves, and not by the complement: 4 sin 70° stays so.

Algebra has 4 cos 20° for it, which a reader would have to recognize.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.explaining.lines.trees import exchanged, of_relation, rebuilt, trees_of
from restitution.expression.tree import Apply, Degrees, Expression, has_standard_ratios, walk
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain

_OTHER = {"sin": "cos", "cos": "sin"}
_RIGHT = 90


def with_kept_ratios(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working without sides that say the one before them by the complement."""
    for line in derivation.lines:
        pair = _pair(line)
        if pair is not None:
            derivation = _without(derivation, line, *pair, oracle) or derivation
    return derivation


def with_one_angle(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The working with the ratios of an angle that comes first, and none of its complement.

    An angle of the data comes before any other. It is the same working where several bodies have
    angles of their own, where nothing is to be changed, or where a line would not be accepted.
    """
    if sum(fact.id.startswith("velocity ") for fact in derivation.facts) > 1:
        return derivation
    lines = [line for line in derivation.lines if isinstance(line.relation, Relation)]
    data = [fact.relation for fact in derivation.facts]
    of_data = dict.fromkeys(_angles(tree for relation in data for tree in relation.trees))
    of_lines = dict.fromkeys(_angles(tree for line in lines for tree in trees_of(line.relation)))
    kept = list(dict.fromkeys((*(size for size in of_data if size in of_lines), *of_lines)))
    others = {
        _RIGHT - size
        for n, size in enumerate(kept)
        if _RIGHT - size in kept[n + 1 :] and _RIGHT - size not in of_data
    }
    if not others:
        return derivation

    def change(tree: Expression) -> Expression:
        match tree:
            case Apply("sin" | "cos" as ratio, Degrees(size)) if size in others:
                return Apply(_OTHER[ratio], Degrees(_RIGHT - size))
        return tree

    changed = {line.number: _of_relation(line, change) for line in lines}
    whole = replace(
        derivation,
        lines=tuple(changed.get(line.number, line) for line in derivation.lines),
        items=tuple(
            replace(end, answer=of_relation(end.answer, change)) for end in derivation.items
        ),
    )
    read = reader_of(whole, oracle)
    own = [line for line in lines if changed[line.number] != line]
    return whole if all(read.accepts(changed[line.number]) for line in own) else derivation


def _of_relation(line: Line, change: Callable[[Expression], Expression]) -> Line:
    """A line with each node of its relation changed."""
    assert isinstance(line.relation, Relation)
    return replace(line, relation=of_relation(line.relation, change))


def _angles(trees: Iterable[Expression]) -> Iterator[Fraction]:
    """The numbers of degrees of which sines and cosines stand in trees, in their order."""
    for tree in trees:
        for node in walk(tree):
            match node:
                case Apply("sin" | "cos", Degrees(size)) if not has_standard_ratios(size):
                    yield size


def _pair(line: Line) -> tuple[Expression, Expression] | None:
    """The last side of a line and the one before it, where these differ by complements alone."""
    relation = line.relation
    if not isinstance(relation, Relation) or len(relation.options) > 1:
        return None
    links = relation.only
    if len(links) < 2 or links[-1].by != "rearrange" or links[-1].sign != "=":
        return None
    before, last = links[-2].right, links[-1].right
    is_same = before != last and rebuilt(before, _complement) == rebuilt(last, _complement)
    return (last, before) if is_same else None


def _complement(tree: Expression) -> Expression:
    """A cosine of degrees as a sine; any other tree as it is."""
    match tree:
        case Apply("cos", Degrees(size)) if 0 < size < _RIGHT:
            return Apply("sin", Degrees(_RIGHT - size))
    return tree


def _without(
    derivation: Derivation, line: Line, last: Expression, before: Expression, oracle: Oracle
) -> Derivation | None:
    """The working in which a value is that of the side before the last; None where it cannot be."""
    changed = {line.number: _shortened(line)}
    for other in derivation.lines:
        if line.number in other.premises and _has(other, last):
            changed[other.number] = _put(other, last, before)
    lines = tuple(changed.get(own.number, own) for own in derivation.lines)
    ends = tuple(
        replace(end, answer=_in_relation(end.answer, last, before)) if end.line in changed else end
        for end in derivation.items
    )
    whole = replace(derivation, lines=lines, items=ends)
    read = reader_of(whole, oracle)
    return whole if all(map(read.accepts, changed.values())) else None


def _shortened(line: Line) -> Line:
    assert isinstance(line.relation, Relation)
    first, *links = line.relation.only
    kept = [first, *links[:-1]]
    return replace(line, relation=chain(first.left, *((link.right, link.by) for link in kept)))


def _has(line: Line, tree: Expression) -> bool:
    return any(node == tree for own in trees_of(line.relation) for node in walk(own))


def _put(line: Line, last: Expression, before: Expression) -> Line:
    if not isinstance(line.relation, Relation):
        return line
    return replace(line, relation=_in_relation(line.relation, last, before))


def _in_relation(relation: Relation, last: Expression, before: Expression) -> Relation:
    put = {last: before}
    return Relation(
        tuple(
            tuple(
                replace(link, left=exchanged(link.left, put), right=exchanged(link.right, put))
                for link in links
            )
            for links in relation.options
        )
    )


__all__ = ["with_kept_ratios", "with_one_angle"]
