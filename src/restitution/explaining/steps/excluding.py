"""What a note says cannot be: premises that do not hold together, or not with a claim."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.explaining.data.paths_and_lines import in_degrees
from restitution.explaining.data.setting import Cited
from restitution.explaining.lines.derivation import Link, Meaning, Note, Relation
from restitution.explaining.lines.generators import Value
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.lines.trees import of_relation
from restitution.explaining.steps.step import Step
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import Name, Number, Quantity, Unit, walk
from restitution.oracle import BeyondError, Oracle, compared, negation

_WORDS = frozenset({"parallel to", "perpendicular to", "≈"})
_ZERO = Number(Fraction(0))


def excludes(note: Note, step: Step, unknown: bool = False, *, quickly: bool = False) -> bool:
    """Whether what a step cites cannot hold together, nor with the claim of a note.

    Letters have the values of its instance. ``unknown`` is the answer for what cannot be compared:
    directions, decimals, and angles. Of what is ``quickly`` seen, values are put into the claim.
    """
    claim = None if note.claim is None else _at(note, note.claim)
    if claim is not None and any(_is_beyond(e) for links in claim.options for e in links):
        return unknown
    cited = tuple(
        Cited(e.ref, e.relation if isinstance(e.relation, Meaning) else _at(note, e.relation))
        for e in step.cited
    )
    there = step.under(cited=cited)
    try:
        if claim is not None and len(claim.options) == 1 and _is_refuted(there, claim.only):
            return True
        if claim is None and any(_is_against(there, premise) for premise in cited):
            return True
        if quickly:
            return False
        facts = (*there.facts, *(() if claim is None else (there.formula(claim),)))
        return Oracle(there.roles, facts).possible.answer == "refuted"
    except (NotComparableError, BeyondError):
        return unknown


def holds_anyway(step: Step) -> bool:
    """Whether a fact that a step cites says only what the lines beside it come to."""
    for own in step.cited:
        relation = own.relation
        if isinstance(own.ref, int) or isinstance(relation, Meaning) or len(relation.options) != 1:
            continue
        others = step.under(cited=tuple(premise for premise in step.cited if premise is not own))
        try:
            gaps = [others.residual(link, others.rules()) for link in relation.only]
        except NotComparableError:
            continue
        if all(_holds(others, link, gap) for link, gap in zip(relation.only, gaps, strict=True)):
            return True
    return False


def _holds(step: Step, link: Link, gap: Value) -> bool:
    """Whether a relation holds by the difference of its sides, with all values put in."""
    if isinstance(gap, Plane):
        return False
    match link.sign:
        case "=":
            return gap.vanishes
        case "<" | "<=" | ">" | ">=":
            sign = step.signs.of(gap)
            return sign == (-1 if link.sign in ("<", "<=") else 1)
    return False


def _is_beyond(link: Link) -> bool:
    """Whether a claim is of what the oracle does not know."""
    return link.sign in _WORDS or any(
        isinstance(node, Quantity) and node.kind in ANGLES
        for side in (link.left, link.right)
        for node in walk(side)
    )


def _is_against(step: Step, own: Cited) -> bool:
    """Whether a fact of the statement is false with the values put in that are cited beside it."""
    relation = own.relation
    if isinstance(own.ref, int) or isinstance(relation, Meaning) or len(relation.options) != 1:
        return False
    others = step.under(cited=tuple(premise for premise in step.cited if premise is not own))
    if any(_points_elsewhere(others, link) for link in relation.only):
        return True
    if any(map(_is_beyond, relation.only)):
        return False
    return _is_refuted(others, relation.only)


def _points_elsewhere(step: Step, link: Link) -> bool:
    """Whether a velocity has a component against the direction that is given of it in degrees."""
    oracle = Oracle(step.roles)
    for component, cosine in _components_told(link):
        value = step.residual(Link(step.setting.quantity(component), "=", _ZERO), step.rules())
        if isinstance(value, Plane):
            continue
        gap = step.world.expression(value, step.roles)
        signs = {1: ("<=",), -1: (">=",), 0: ("<", ">")}[cosine]
        if symbol_names(gap) <= step.roles.keys() and any(
            oracle.proves(compared(gap, sign, sp.Integer(0))) for sign in signs
        ):
            return True
    return False


def _components_told(link: Link) -> Iterator[tuple[Quantity, int]]:
    """Components of a velocity, each with the sign that its direction in degrees gives it."""
    degrees = in_degrees(link.right) if link.sign == "=" else None
    if degrees is None:
        return
    match link.left:
        case Quantity("direction", (Name() as body,), int(stage)):
            velocity = Quantity("velocity", (body,), stage)
            for axis, turn in ((Unit("i"), degrees), (Unit("j"), degrees - 90)):
                yield Quantity("along", (velocity, axis)), _sign_of_cosine(turn)
        case Quantity("angle", (Quantity("velocity") as velocity, Unit() as unit)) | Quantity(
            "angle", (Unit() as unit, Quantity("velocity") as velocity)
        ):
            yield Quantity("along", (velocity, unit)), _sign_of_cosine(degrees)


def _sign_of_cosine(degrees: Fraction) -> int:
    turn = abs((degrees + 180) % 360 - 180)
    return 1 if turn < 90 else -1 if turn > 90 else 0


def _is_refuted(step: Step, links: tuple[Link, ...]) -> bool:
    """Whether one of some links is false with the values put in that are cited: the quick way."""
    oracle = Oracle(step.roles)
    zero = sp.Integer(0)
    for link in links:
        value = step.residual(link, step.rules())
        parts = (value.x, value.y) if isinstance(value, Plane) else (value,)
        for part in parts:
            gap = step.world.expression(part, step.roles)
            plain = symbol_names(gap) <= step.roles.keys()
            if plain and oracle.proves(negation(compared(gap, link.sign, zero))):
                return True
    return False


def _at(note: Note, relation: Relation) -> Relation:
    """A relation with the values of an instance for its letters."""
    values = {link.left: link.right for link in note.instance}
    return of_relation(relation, lambda tree: values.get(tree, tree)) if values else relation
