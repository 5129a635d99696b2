"""What letters and components of a row are worth, where it compares them or turns them round."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, Sign
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_quantity,
    is_zero,
    walk,
)
from restitution.planning.writing.forms import negative
from restitution.solving.story.letters import roles
from restitution.workings.naming.quantities import Naming

# What two values are that are known to differ.
_STRICT: Mapping[str, Sign] = {"<": "<", "<=": "<", ">": ">", ">=": ">"}


def _stands_just_above(derivation: Derivation, line: Line) -> bool:
    """Whether the line of a value is the last one above, in the same item: it is read there."""
    above = derivation.line(line.number - 1)
    return (
        above is not None
        and above.number in line.premises
        and above.item == line.item
        and above.shown == "line"
    )


def with_values(
    derivation: Derivation, naming: Naming, line: Line, links: tuple[Link, ...]
) -> tuple[Link, ...]:
    """A comparison of two letters with what they are worth: ``w₃ = ¾u < 3u/2 = w₂``.

    A sign is told with its value too: ``w = 3u/8 > 0``. Only products are put in: a sum is too
    long beside its name.
    """
    if line.move.id not in ("sign", "compare") or len(links) != 1:
        return links
    (own,) = links
    known: dict[Expression, Expression] = {}
    for ref in line.premises:
        above = derivation.line(ref)
        match above.relation if above is not None else None:
            case Relation(((Link(Letter() as letter, "="), *_),) as options):
                known[letter] = options[0][-1].right
            case Relation(((Link(Quantity("along", (_, axis)) as whole, "="), *_),)) as own_ if (
                line.move.id == "sign" and _is_line(axis)
            ):
                known[whole] = own_.options[0][-1].right
    if line.move.id == "sign" and own.left in known and is_zero(own.right):
        value = known[own.left]
        if has_quantity(value) or any(is_binary(e, "+", "-") for e in walk(value)):
            return links
        if isinstance(own.left, Quantity) and _stands_just_above(derivation, line):
            return links
        named = Link(own.left, "=", value)
        return (named,) if is_zero(value) else (named, Link(value, own.sign, own.right))
    if own.sign not in _STRICT or own.left not in known or own.right not in known:
        return links
    left, right = known[own.left], known[own.right]
    signs = ("+", "-")
    if any(isinstance(e, Binary) and e.op in signs for tree in (left, right) for e in walk(tree)):
        return links
    if left == right:
        return Link(own.left, "=", left), Link(left, "=", own.right)
    return (
        Link(own.left, "=", left),
        Link(left, _STRICT[own.sign] if _differ(naming, left, right) else own.sign, right),
        Link(right, "=", own.right),
    )


def in_the_other_sense(
    derivation: Derivation, naming: Naming, line: Line, links: Sequence[Link]
) -> Expression | None:
    """What a component is in the sense opposite to a unit vector: −**u** · **n**."""
    own = links[0]
    if line.move.record != "component" or len(links) > 1 or not isinstance(own.left, Quantity):
        return None
    for ref in line.premises:
        above = derivation.line(ref)
        match above.relation if above is not None else None:
            case Relation(((Link(Quantity("along" | "across") as whole, "="), *_),)) as component:
                value = component.only[-1].right
            case _:
                continue
        same = own.left.arguments[0] == whole.arguments[0]
        number = 0 if above is None else above.move.event or 0
        if same and not is_zero(value) and naming.bold.has_unit(number):
            return Negate(whole) if own.right in (Negate(value), negative(value)) else None
    return None


def _differ(naming: Naming, left: Expression, right: Expression) -> bool:
    """Whether two values are known to differ: what has a coefficient in it may be zero."""
    known = roles(naming.problem)

    def letter(name: str) -> sp.Symbol:
        positive = name in known and known[name].kind == "positive"
        return sp.Symbol(name, positive=True) if positive else sp.Symbol(name, real=True)

    try:
        one, other = (sp.sympify(evaluate(e, letter), strict=True) for e in (left, right))
    except RestitutionError:
        return False
    return bool((one - other).is_nonzero)


def _is_line(axis: Expression) -> bool:
    """Whether a component is along a line of centres, or along **i** or **j**."""
    return isinstance(axis, Unit) or is_quantity(axis, "line_of_centres")
