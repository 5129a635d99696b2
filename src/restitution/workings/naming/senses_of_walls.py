"""The unit vector along a slanting wall: in the sense in which the question has the wall.

Lines of a derivation take components across the normal, that is along it turned to the left. Where
that is against the vector of the wall, 4**i** − 3**j**, they are printed with the other sign, so
that **t** = (4**i** − 3**j**)/5. Each line that this touches is read once more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Event,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Binary,
    Expression,
    Negate,
    Quantity,
    has_quantity,
    has_unit_vector,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.forms import opposite, swept
from restitution.problem import Problem
from restitution.records import dataclass
from restitution.solving.story.letters import roles
from restitution.vector import Vector
from restitution.workings.naming.bold_letters import direction_in_numbers, direction_of_event
from restitution.workings.naming.measured import vector_worth


@dataclass(frozen=True)
class Turned:
    """A working in which components along the walls of some ``events`` have the other sign.

    ``printed`` names them as before; in ``followed`` they are across the opposite of the normal,
    so that each line can be read.
    """

    printed: Derivation
    followed: Derivation
    events: frozenset[int] = frozenset()


def in_senses_of_walls(derivation: Derivation, problem: Problem) -> Turned:
    """The working with components along slanting walls in the senses of these."""
    turned = Turned(derivation, derivation)
    for event in derivation.events:
        beside = _against(derivation, event) if event.wall else None
        if beside is not None:
            turned = _turned(turned, event, beside, problem)
    return turned


def _against(derivation: Derivation, event: Event) -> Vector | None:
    """The unit vector along a slanting wall in numbers, where it is against that of the question.

    None where it is not, and where something else than a line has a component in its direction.
    """
    fact = derivation.fact(f"wall {event.bodies[-1]}")
    own = None if fact is None else direction_in_numbers(fact.relation.only[-1].right)
    normal = None if own is None else direction_of_event(derivation, event.number)
    if own is None or normal is None or not all(part.is_number for part in (*own, *normal)):
        return None
    beside = normal.turned_left()
    if not own.dot(beside).is_negative:
        return None
    relations = [fact.relation for fact in derivation.facts]
    relations += [end.answer for end in derivation.items]
    relations += [note.claim for note in derivation.notes if note.claim is not None]
    trees = [tree for relation in relations for tree in relation.trees]
    trees += [e.relation.quantity for e in derivation.lines if isinstance(e.relation, Meaning)]
    return None if any(_is_across(node, event) for tree in trees for node in walk(tree)) else beside


def _is_across(tree: Expression, event: Event) -> bool:
    """Whether a tree is the component of something across the normal at an event."""
    match tree:
        case Quantity("across", (_, Quantity("line_of_centres", (), number))):
            return number == event.number
    return False


def _turned(turned: Turned, event: Event, beside: Vector, problem: Problem) -> Turned:
    """A working with the components along one more wall turned; the same where that fails."""
    changed: dict[int, Line] = {}
    values = set(_values_across(turned.printed, event))
    if not any(_is_resolved(line, event) for line in turned.printed.lines):
        return turned  # the body may come in either sense: in that it is taken to go
    for line in turned.printed.lines:
        if isinstance(line.relation, Meaning):
            continue
        own = _turned_line(line, event, beside, values)
        if own is not line:
            changed[line.number] = own
    followed = {
        number: replace(line, relation=_opposite_axes(line.relation, event))
        for number, line in changed.items()
    }
    whole = _with_lines(turned.followed, followed)
    read = reader_of(whole, Oracle(roles(problem)))
    touched = [e for e in whole.lines if {e.number, *e.premises} & changed.keys()]
    if not changed or not all(map(read.accepts, touched)):
        return turned
    return Turned(
        _with_lines(turned.printed, changed), whole, turned.events | frozenset((event.number,))
    )


def _is_resolved(line: Line, event: Event) -> bool:
    """Whether a line makes a component along a wall of a vector."""
    if line.move.record != "component" or not isinstance(line.relation, Relation):
        return False
    return _is_across(line.relation.options[0][0].left, event)


def _with_lines(derivation: Derivation, changed: Mapping[int, Line]) -> Derivation:
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    return replace(derivation, lines=lines)


def _opposite_axes(relation: Relation | Meaning, event: Event) -> Relation:
    """A relation with components across the opposite of the normal at an event."""
    assert isinstance(relation, Relation)

    def change(tree: Expression) -> Expression:
        if isinstance(tree, Quantity) and _is_across(tree, event):
            vector, axis = tree.arguments
            return replace(tree, arguments=(vector, Negate(axis)))
        return tree

    return _mapped(relation, lambda tree: rebuilt(tree, change))


def _values_across(derivation: Derivation, event: Event) -> Iterator[Expression]:
    """What the components along a wall come to."""
    for line in derivation.lines:
        if isinstance(line.relation, Relation) and len(line.relation.options) == 1:
            links = line.relation.only
            if _is_across(links[0].left, event):
                yield links[-1].right


def _turned_line(line: Line, event: Event, beside: Vector, values: set[Expression]) -> Line:
    """A line with the other sign for components along a wall; the line itself without any.

    What stays along the wall is an equation of two of the ``values``; both may have the other sign.
    """
    relation = line.relation
    assert isinstance(relation, Relation)
    options: list[tuple[Link, ...]] = []
    # A velocity before the impact is of an earlier event, and rests on the axis of this one.
    is_own = line.move.event == event.number or f"axis {event.number}" in line.premises
    for links in relation.options:
        if _is_across(links[0].left, event):
            # A scalar product keeps the order of its terms.
            resolved = line.move.record == "component"
            turned = [_opposite_link(links[0], is_first=True, as_it_stands=resolved)]
            turned += [_opposite_link(link) for link in links[1:]]
        elif is_own and line.move.record == "unchanged" and links[-1].right in values:
            turned = [_opposite_link(link) for link in links]
        else:
            turned = [_turned_link(link, event, beside if is_own else None) for link in links]
        options.append(tuple(turned))
    put = Relation(tuple(options))
    return line if put == relation else replace(line, relation=put)


def _opposite_link(link: Link, *, is_first: bool = False, as_it_stands: bool = False) -> Link:
    """A link with the other sign on both sides; a component on the first side has it anyway."""
    left = link.left if is_first else opposite(link.left, as_it_stands=True)
    sign = FLIPPED.get(link.sign, link.sign)
    right = opposite(link.right, as_it_stands=as_it_stands)
    return replace(link, left=left, sign=sign, right=right)


def _turned_link(link: Link, event: Event, beside: Vector | None) -> Link:
    """A link with the opposites of components, and of the unit vector, in the middle of it."""

    def change(tree: Expression) -> Expression:
        if _is_across(tree, event):
            return Negate(tree)
        match tree:
            case Binary("/" | "+" | "-") if beside and _is_beside(tree, beside):
                return Negate(opposite(tree, as_it_stands=True))
        return tree

    sides = (link.left, link.right)
    left, right = (
        side if own == side or (beside and _is_beside(side, beside)) else swept(own)
        for side, own in ((side, rebuilt(side, change)) for side in sides)
    )
    return replace(link, left=left, right=right) if (left, right) != sides else link


def _is_beside(tree: Expression, beside: Vector) -> bool:
    """Whether a tree is the unit vector along a wall, or a multiple of it in its sense."""
    if has_quantity(tree) or not has_unit_vector(tree):
        return False
    own = vector_worth(tree)
    if own is None or not all(part.is_number for part in own):
        return False
    return tidy(own.cross(beside)) == 0 and bool(own.dot(beside).is_positive)


def _mapped(relation: Relation, change: Callable[[Expression], Expression]) -> Relation:
    """A relation with each of its trees changed."""
    return Relation(
        tuple(
            tuple(replace(e, left=change(e.left), right=change(e.right)) for e in links)
            for links in relation.options
        )
    )


__all__ = ["Turned", "in_senses_of_walls"]
