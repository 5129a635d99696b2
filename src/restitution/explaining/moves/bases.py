"""What a move starts from, and what else it cites."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import sympy as sp

from restitution.explaining.data.setting import Cited
from restitution.explaining.lines import derivation
from restitution.explaining.lines.algebra import multiplied
from restitution.explaining.lines.angles import Identity
from restitution.explaining.lines.derivation import (
    BEARINGS,
    Link,
    Meaning,
    Relation,
    Sign,
    whole_of,
)
from restitution.explaining.lines.generators import Value
from restitution.explaining.lines.quotients import CONSTANT, NotComparableError, Plane, Quotient
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Expression,
)
from restitution.oracle import Oracle
from restitution.oracle import Relation as Claim

FLIPPED: Mapping[str, Sign] = {**derivation.FLIPPED, "=": "=", "!=": "!="}
IDENTITIES: Mapping[str, frozenset[Identity]] = {
    "pythagoras": frozenset({"pythagoras"}),
    "double-angle": frozenset({"double-angle"}),
    "half-angle": frozenset({"half-angle"}),
    "sum-of-angles": frozenset({"sum"}),
    "complement": frozenset({"complement"}),
}


def condition(relation: Relation) -> tuple[Link, Link] | None:
    """The place and the value of "x ≠ a or y = b", which says that y is b where x is a."""
    if len(relation.options) != 2 or any(len(links) != 1 for links in relation.options):
        return None
    (unless,), (then,) = relation.options
    if unless.sign != "!=" or then.sign != "=":
        return None
    return Link(unless.left, "=", unless.right), then


def last_side(step: Step, link: Link) -> Expression:
    """The last side of the chain in which a link is cited."""
    for premise in step.cited:
        if isinstance(premise.relation, Relation) and link in premise.relation.options[0]:
            return premise.relation.options[0][-1].right
    return link.right


def bases_of(step: Step) -> tuple[tuple[Link, ...], ...]:
    """The alternatives of the line that a move starts from."""
    if step.move.id not in ("put", "rearrange", "cancel", "identity"):
        return ()
    first = base_of(step)
    return () if first is None else first.options


def base_of(step: Step) -> Relation | None:
    """The relation of the first line that is cited; None where none is."""
    return next((e.relation for e in step.cited if isinstance(e.relation, Relation)), None)


def with_base(step: Step, links: tuple[Link, ...]) -> Step:
    """The step with other links in the place of the relation of its first line."""
    first = next(e for e in step.cited if isinstance(e.relation, Relation))
    chosen = tuple(
        Cited(premise.ref, Relation((links,))) if premise is first else premise
        for premise in step.cited
    )
    return step.under(cited=chosen)


def from_base(step: Step) -> Step:
    """The step, in which an angle that the first line gives is not yet put in."""
    base = base_of(step)
    own = {
        link.left
        for links in (() if base is None else base.options)
        for link in links
        if link.left in step.world.turns
    }
    return step.under(opaque=step.opaque | own) if own else step


def without_angles(step: Step) -> Step:
    """The step in which no line beside the first says what an angle is."""
    base = base_of(step)
    kept = [
        premise
        for premise in step.cited
        if premise.relation is base
        or isinstance(premise.relation, Meaning)
        or not any(link.left in step.world.turns for link in _links(premise.relation))
    ]
    return step.under(cited=tuple(kept)) if len(kept) < len(step.cited) else step


def _links(relation: Relation) -> list[Link]:
    return [link for links in relation.options for link in links]


def others_cited(step: Step) -> tuple[Cited, ...]:
    """What is cited beside the line that a move starts from."""
    first = next((e for e in step.cited if isinstance(e.relation, Relation)), None)
    return tuple(premise for premise in step.cited if premise is not first)


def matches(step: Step, line: Link, expected: Value, sign: Sign = "=") -> bool:
    """Whether a line says the expected residual to stand in that relation to zero."""
    if sign in BEARINGS:
        return False
    step.world.printed = False
    own = step.residual(line)
    step.world.note_tangents(own)
    if sign == "≈":
        gap = plus(own, multiplied(expected, CONSTANT(-1)))
        return line.sign == sign and isinstance(gap, Quotient) and gap.vanishes
    parted = step.move.id in ("rearrange", "fact")
    if isinstance(expected, Plane) and isinstance(own, Quotient) and parted:
        # What stands with i, or with j, on both sides.
        parts = (expected.x, expected.y)
        return sign == line.sign == "=" and any(
            step.is_multiple(own, part) is not None for part in parts
        )
    if sign == "=" or sign == "!=":
        return line.sign == sign and step.is_multiple(own, expected) is not None
    k = step.is_multiple(own, expected, sign=True)
    return k is not None and line.sign == (sign if k == 1 else FLIPPED[sign])


def may_match(step: Step, line: Link, expected: Iterable[Value]) -> bool:
    """Whether a line has a factor in common with one of some residuals, whatever its sign."""
    step.world.printed = False
    own = step.residual(line)
    step.world.printed = True
    return any(step.multiple(own, form) is not None for form in expected)


def expected_residual(step: Step, link: Link, rules: Rules) -> Value:
    """What the left side of a link less the right one comes to, with what is cited put in."""
    step.world.printed = True
    if link.sign in BEARINGS:
        return CONSTANT(0)
    return step.residual(link, rules)


def flat(links: tuple[Link, ...]) -> Iterator[Link]:
    """The links of a relation, and the first side of a chain with its last."""
    yield from links
    whole = whole_of(links)
    if whole is not None and len(links) > 1:
        yield whole


def pair_cited(step: Step) -> tuple[Link, Link] | None:
    """The two equations that are cited."""
    equations = [e.relation for e in step.cited if isinstance(e.relation, Relation)]
    if len(equations) < 2 or any(len(equation.options) != 1 for equation in equations[:2]):
        return None
    first, second = (ends_of(equation.only) for equation in equations[:2])
    return None if first is None or second is None else (first, second)


def ends_of(links: tuple[Link, ...]) -> Link | None:
    """A chain of equations as one: its first side and its last."""
    *_, last = flat(links)
    return last if last.sign == "=" else None


def plus(a: Value, b: Value) -> Value:
    """The sum of two scalars, or of two vectors."""
    if isinstance(a, Plane) and isinstance(b, Plane):
        return Plane(a.x + b.x, a.y + b.y)
    if isinstance(a, Plane) or isinstance(b, Plane):
        raise NotComparableError("a vector beside a number")
    return a + b


def equal_in(step: Step, a: sp.Expr, b: sp.Expr, facts: tuple[Claim, ...] = ()) -> bool:
    """Whether two expressions are proved equal, for what letters may be and by these facts."""
    return Oracle(step.roles, facts).proves(Claim(a - b, "="))
