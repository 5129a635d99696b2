"""What is said of spheres of which one lies beside the other's path: how that gives the line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Fact, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Polar,
    Quantity,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.render import layout as lay
from restitution.wording.scene import is_mirrored, scene_of
from restitution.workings.naming.measured import vector_worth, with_unit, worth
from restitution.workings.naming.quantities import Naming


def is_offset(fact: Fact) -> bool:
    """Whether a line of centres is given by how far it lies beside a path."""
    match fact.relation.options:
        case ((Link(_, "=", Polar(_, Apply("arcsin"))),),):
            return True
    return False


def angle_of_offset(fact: Fact, known: Mapping[str, sp.Expr], naming: Naming) -> Sentence | None:
    """The angle that an offset gives, or its sine and cosine, with letters that are known.

    None where others are left.
    """
    match fact.relation.only[0].right:
        case Polar(_, Apply(_, sine_), origin):
            sine = worth(sine_)
        case _:
            return None
    sine = sine.subs(
        {symbol: known[symbol.name] for symbol in sine.free_symbols if symbol.name in known}
    )
    sine = tidy(sp.cancel(sine))
    if not sine.is_number:
        return None
    one, other = naming.events[int(fact.id.partition(" ")[2])].bodies
    angle = sp.asin(abs(sine))
    if (angle / sp.pi).is_Rational:
        degrees = naming.layout(tree_of(angle, angle=True))
        path = _path(naming, one, other, origin)
        return say("offset.angle-in-degrees", angle=degrees, path=path)
    ratios = (tree_of(value) for value in (abs(sine), tidy(sp.sqrt(1 - sine**2))))
    sides = dict(zip(("sine", "cosine"), map(naming.layout, ratios), strict=True))
    return say("offset.angle", path=_path(naming, one, other, origin), **sides)


def offset_sentence(fact: Fact, naming: Naming, given: bool, letter: str | None = None) -> Sentence:
    """How an offset gives a line of centres: by the sine of the angle to the path.

    Where the angle is ``given``, that is said next. It may have a ``letter``; there all that is
    ``given`` has been said.
    """
    match fact.relation.only[0].right:
        case Polar(_, Apply(_, Binary("/", beside, apart)), origin):
            pass
        case _:
            raise ValueError(fact)
    one, other = naming.events[int(fact.id.partition(" ")[2])].bodies
    path = _path(naming, one, other, origin)
    if worth(beside) == 0:
        return say("offset.none", other=other, path=path)
    right = worth(beside).as_coeff_Mul()[0] < 0
    if isinstance(beside, Negate):
        beside = beside.operand
    elif right:
        beside = tree_of(tidy(-worth(beside)))
    sine = tidy(worth(beside) / worth(apart))
    sides = naming.layout(Binary("/", beside, apart)), naming.layout(tree_of(sine))
    # On which side B is a question does not say where that makes no difference.
    either = path.id == "offset.path" and is_mirrored(scene_of(naming.problem))
    slots: dict[str, Any] = {
        "other": other,
        "beside": say(
            "offset.beside-either" if either else "offset.beside",
            offset=_length(naming, beside),
            side=say("offset.right" if right else "offset.left"),
            path=path,
        ),
        "apart": _length(naming, tree_of(tidy(worth(apart)))),
        "sine": sides[0] if sides[0] == sides[1] else lay.Relation(sides, ("=",)),
    }
    if letter is not None and given:
        return say("offset.letter-again", letter=naming.layout(Letter(letter)), path=path)
    if letter is not None:
        del slots["sine"]
        return say("offset.letter", letter=naming.layout(Letter(letter)), **slots)
    if given:
        return say("offset.sine-alone", **slots)
    angle = sp.asin(sine) if sine.is_number else sp.nan
    if not (angle / sp.pi).is_Rational:
        return say("offset.sine", **slots)
    return say("offset.degrees", angle=naming.layout(tree_of(angle, angle=True)), **slots)


def turned_sentence(fact: Fact, naming: Naming, relation: Relation) -> Sentence | None:
    """How a line of centres stands to the path, where its unit vector has a letter for the angle.

    None where it has none.
    """
    match fact.relation.only[0].right, relation.only:
        case Polar(_, Apply(_, Binary("/", beside)), origin), (Link(_, "=", unit), _):
            pass
        case _:
            return None
    letters = [
        node.argument
        for node in walk(unit)
        if isinstance(node, Apply) and isinstance(node.argument, Letter)
    ]
    if not letters:
        return None
    one, other = naming.events[int(fact.id.partition(" ")[2])].bodies
    return say(
        "offset.turned",
        letter=naming.layout(letters[0]),
        path=_path(naming, one, other, origin),
        side=say("offset.right" if isinstance(beside, Negate) else "offset.left"),
    )


def _length(naming: Naming, tree: Expression) -> lay.Layout:
    """A length with its unit, where numbers of the statement fix the scale."""
    return with_unit(naming.layout(tree), naming.unit(Quantity("distance", ())))


def _path(naming: Naming, one: str, other: str, origin: Expression | None) -> Sentence:
    """The path of the one sphere, relative to the other where that moves across it or faster."""
    match origin:
        case Binary("-", own, _):
            displacement = vector_worth(origin)
            first = vector_worth(own)
            if displacement is None or first is None:
                return say(
                    "offset.relative", body=one, other=other, direction=naming.layout(origin)
                )
            if (
                tidy(first.cross(displacement)) != 0
                or tidy(first.dot(displacement)).as_coeff_Mul()[0] < 0
            ):
                direction = naming.layout(tree_of(displacement))
                return say("offset.relative", body=one, other=other, direction=direction)
    return say("offset.path", body=one)


__all__ = ["angle_of_offset", "is_offset", "offset_sentence", "turned_sentence"]
