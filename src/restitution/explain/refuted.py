"""A claim that is not true in words: what is true instead, or numbers for which it fails."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explain.ends import Ends, claim_of_meeting
from restitution.explain.measured import as_answer
from restitution.explain.naming import Naming
from restitution.explaining.derivation import Derivation, Link, Note, Relation
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Negate, Quantity, has_quantity, letters
from restitution.problem import Aligned, AtRest, Compare, Extremum, Meets, Show
from restitution.render import layout as lay

_DENIED = {
    "perpendicular to": "claim.not-perpendicular",
    "parallel to": "claim.not-parallel",
    "in the direction of": "claim.not-same-direction",
    "opposite to": "claim.not-opposite",
}


def claim_of(note: Note, naming: Naming, ends: Ends) -> Sentence | lay.Layout | str:
    """What a claim says."""
    asked = ends.item(note.item)
    if isinstance(asked, Show) and isinstance(asked.relation, Meets):
        return claim_of_meeting(asked.relation, naming)
    if note.claim is not None and isinstance(asked, Show) and isinstance(asked.relation, Compare):
        laid = naming.relation(note.claim)
        return _with_article(laid)
    return ends.text(note.item)


def _with_article(laid: lay.Layout) -> Sentence | lay.Layout:
    """An equation among words: where it begins with words, they have their article."""
    if isinstance(laid, lay.Relation) and isinstance(laid.operands[0], lay.Words | lay.Phrase):
        return say("derived.the", quantity=laid)
    return laid


def refutation(note: Note, derivation: Derivation, naming: Naming, ends: Ends) -> Sentence:
    """That a claim is not true, and why."""
    asked = ends.item(note.item)
    relation = asked.relation if isinstance(asked, Show) else None
    claim = claim_of(note, naming, ends)
    values = tuple(_side(each, naming) for each in note.instance)
    equations = (_side(each, naming) for each in note.sides)
    sides = tuple(_with_article(each) for each in equations if len(each.operands) > 1)
    match relation:
        case Compare() if isinstance(asked, Show) and asked.subject is not None:
            return _of_subject(asked, claim, note, naming)
        case Compare(operators=("=",)):
            value = _value(note, derivation, naming)
            if value is not None:
                return value
        case AtRest(body) if note.lines:
            link = _link_of(derivation, note.lines[-1])
            return say("refuted.rest", body=body.name, velocity=_side(link, naming))
        case Aligned(left, how, right):
            one, other_ = map(naming.side, _sides_of(note, left, right, how))
            denied = say(_DENIED[how], left=one, right=other_)
            if values and sides:
                return say("refuted.direction-instance", claim=denied, values=values, sides=sides)
            return say("refuted.direction", claim=denied)
        case Meets() if not values and note.lines:
            other = replace(relation, happens=not relation.happens)
            return say("refuted.opposite", claim=claim_of_meeting(other, naming))
    if values and sides:
        return say("refuted.general", claim=claim, values=values, sides=sides)
    if values:
        return say("refuted.instance", claim=claim, values=values)
    if sides:
        return say("refuted.claim", claim=claim, sides=sides)
    return say("refuted.plainly", claim=claim)


def _of_subject(
    asked: Show, claim: Sentence | lay.Layout | str, note: Note, naming: Naming
) -> Sentence:
    """That a range, or a greatest or least value, is another."""
    if isinstance(asked.subject, Extremum) and note.claim is not None:
        link = note.claim.only[0]
        kind = "derived.greatest" if asked.subject.kind == "maximum" else "derived.least"
        extreme = say(kind, quantity=naming.laid(link.left))
        claimed = naming.laid(link.right)
        if not note.sides:
            return say("refuted.extreme", quantity=extreme, claimed=claimed)
        (true,) = note.sides
        value = naming.laid(true.right)
        return say("refuted.value", quantity=extreme, claimed=claimed, value=value)
    if note.sides:
        true_range = naming.relation(Relation((note.sides,)))
        return say("refuted.range-is", range=claim, true=true_range)
    return say("refuted.range", range=claim)


def _value(note: Note, derivation: Derivation, naming: Naming) -> Sentence | None:
    """What a quantity is worth of which another value is claimed."""
    assert note.claim is not None
    link = note.claim.only[0]
    if not isinstance(link.left, Quantity) or has_quantity(link.right) or not note.lines:
        return None
    own = _link_of(derivation, note.lines[-1])
    if own.left != link.left:
        return None
    claimed, value = naming.laid(link.right), naming.laid(own.right)
    added = as_answer(own.right)
    if note.sides and note.sides[0].sign == "≈":
        value = naming.laid(note.sides[0].right)
    elif added:
        value = lay.Relation((value, *(e for e, _ in added)), tuple(s for _, s in added))
    name = naming.laid(link.left)
    plain, general = (
        ("refuted.vector", "refuted.vector-general")
        if isinstance(name, lay.Bold)
        else ("refuted.value", "refuted.value-general")
    )
    sentence = general if _may_agree(link.right, own.right) else plain
    return say(sentence, quantity=name, claimed=claimed, value=value)


def _may_agree(claimed: Expression, value: Expression) -> bool:
    """Whether two values in letters may be equal for some: their ratio is no number."""
    if not letters(claimed) | letters(value):
        return False
    try:
        ends: list[Any] = [
            evaluate(each, lambda name: sp.Symbol(name, positive=True)) for each in (claimed, value)
        ]
    except RestitutionError:
        return True
    if not all(isinstance(each, sp.Expr) and each != 0 for each in ends):
        return True
    return bool(tidy(ends[0] / ends[1]).free_symbols)


def _link_of(derivation: Derivation, number: int) -> Link:
    """A line as one link, from its first side to its last."""
    line = derivation.line(number)
    assert line is not None
    assert isinstance(line.relation, Relation)
    links = line.relation.only
    return Link(links[0].left, links[0].sign, links[-1].right)


def _sides_of(
    note: Note, left: Expression, right: Expression, how: str
) -> tuple[Expression, Expression]:
    """The two directions of a claim, with the stages that are meant."""
    if note.claim is None:
        return left, right
    link = note.claim.only[0]
    turned = how == "opposite to" and isinstance(link.right, Negate)
    return link.left, link.right.operand if turned else link.right  # type: ignore[union-attr]


def _side(link: Link, naming: Naming) -> lay.Relation:
    """``tan β = 3/4 = 0.75``: what a letter or a quantity is worth.

    What is worth itself, as ``u/3``, is not said twice.
    """
    added = as_answer(link.right) if link.sign == "=" else ()
    operands = [naming.laid(link.left), naming.laid(link.right), *(e for e, _ in added)]
    signs = [lay.SIGNS.get(link.sign, link.sign), *(s for _, s in added)]
    if operands[0] == operands[1]:
        del operands[0], signs[0]
    return lay.Relation(tuple(operands), tuple(signs))
