"""Whether a line about a place, or a distance from one, is of a body that rests."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.expression.tree import Letter, Name, Pair, Quantity, is_zero


def is_of_a_body_at_rest(derivation: Derivation, line: Line) -> bool:
    """Whether a place rests on components of a velocity that are all zero."""
    if line.move.record != "straight-line":
        return False
    still: list[bool] = []
    for ref in line.premises:
        if isinstance(ref, str):
            if ref.partition(" ")[0] == "velocity":
                fact = derivation.fact(ref)
                match None if fact is None else fact.relation.options[0][-1].right:
                    case Pair(x, y) if is_zero(x) and is_zero(y):
                        still.append(True)
                    case _:
                        return False
            continue
        own = derivation.line(ref)
        if own is None or not isinstance(own.relation, Relation) or len(own.relation.options) > 1:
            continue
        match own.relation.only[0].left:
            case Letter(name) if name in derivation.meanings:
                still.append(is_zero(own.relation.only[-1].right))
            case Quantity("velocity") | Quantity("along" | "across", (Quantity("velocity"), _)):
                still.append(is_zero(own.relation.only[-1].right))
    return bool(still) and all(still)


def body_that_rests(derivation: Derivation, line: Line) -> str | None:
    """The body at rest from whose place a line gives a distance, where that is all it rests on."""
    if len(line.premises) != 1:
        return None
    match derivation.lines_in(line.premises):
        case [Line(relation=Relation(((Link(Quantity("position", (Name(body),))), *_),))) as place]:
            return body if is_of_a_body_at_rest(derivation, place) else None
    return None
