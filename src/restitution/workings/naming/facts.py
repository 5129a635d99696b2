"""Given facts in words: who meets, what is at rest, parallel or a share of something."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.lines.derivation import Fact, Link, turned
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    has_quantity,
    is_quantity,
    is_zero,
)
from restitution.problem import Given, Meets
from restitution.render import layout as lay
from restitution.workings.naming.measured import is_plain, with_unit
from restitution.workings.naming.quantities import Naming


def meeting_of(naming: Naming, fact: Fact) -> Meets | None:
    """The meeting of which a given fact tells; None where it tells of something else."""
    for _, step in naming.problem.steps():
        if isinstance(step, Given) and step.place == fact.place:
            beside = [own for own in naming.derivation.facts if own.place == fact.place]
            # A bound of a letter is a fact of its range, and so may be more than is given.
            for kinds in (("given",), ("given", "range")):
                facts = [own for own in beside if own.kind in kinds]
                if fact in facts and len(facts) == len(step.relations):
                    relation = step.relations[facts.index(fact)]
                    return relation if isinstance(relation, Meets) else None
    return None


def _sense_beside(naming: Naming, fact: Fact) -> str:
    """The sign by which the data tell the sense of a common direction; empty without one."""
    given = fact.id.startswith("given")
    sense = naming.derivation.fact(fact.id.replace("given", "sense")) if given else None
    return "" if sense is None else sense.relation.only[0].sign


def fact_in_words(naming: Naming, fact: Fact) -> Sentence | lay.Layout:
    """A given fact, in words where it is told in words."""
    match meeting_of(naming, fact):
        case Meets(Name(one), Name(other), again, happens):
            more = say("again") if again else ""
            if naming.bodies.get(other) == "wall":
                name = "claim.hits" if happens else "claim.does-not-hit"
                return say(name, body=one, wall=other, again=more)
            if happens:
                return say("claim.collide", one=one, other=other, again=more)
            return say("claim.not-collide", one=one, other=other, again=more)
    link = fact.relation.options[0][0]
    if len(fact.relation.options) > 1 or len(fact.relation.options[0]) > 1:
        return naming.relation(fact.relation)
    if link.sign in _BOUNDS and not has_quantity(link.left):
        link = turned(link)
    match link:
        case Link(Quantity("velocity", (Name(body),), _), "=", value) if _is_rest(value):
            return say("claim.rest", body=body)
    sense = _sense_beside(naming, fact)
    if sense == "<" and isinstance(link.right, Negate):
        link = Link(link.left, link.sign, link.right.operand)
    left, right = naming.side(link.left), naming.side(link.right)
    if link.sign in ("parallel to", "perpendicular to"):
        left, right = (
            say("derived.the", quantity=side) if is_quantity(own, "momentum") else side
            for own, side in ((link.left, left), (link.right, right))
        )
        name = "claim.parallel" if link.sign == "parallel to" else "claim.perpendicular"
        name = {">": "claim.same-direction", "<": "claim.opposite"}.get(sense, name)
        return say(name, left=left, right=right)
    match link:
        case Link(Apply("sin" | "cos" | "tan" as ratio, Quantity() as angle), "=", value) if (
            isinstance(named := naming.side(angle), lay.Words | lay.Phrase)
            and not has_quantity(value)
        ):
            return say(_RATIOS[ratio], angle=named, value=right)
    if link.sign == "=" and isinstance(left, lay.Words | lay.Phrase):
        match _as_a_multiple(link.right):
            case Quantity() if isinstance(right, lay.Words | lay.Phrase):
                return say("derived.same", quantity=left, value=right)
            case Binary("*", size, Quantity() as whole) if _is_share(size):
                share = _percentage(naming.as_typed(size))
                if (when := _when_the_same(naming, link.left, whole)) is not None:
                    return say("derived.share-of-that", quantity=left, share=share, when=when)
                return say("derived.share", quantity=left, share=share, value=naming.side(whole))
            case Binary("*", Letter() | Number() as size, Quantity() as whole) if isinstance(
                multiple := naming.side(whole), lay.Words | lay.Phrase
            ):
                share = naming.as_typed(size)
                if (when := _when_the_same(naming, link.left, whole)) is not None:
                    return say("derived.times-that", quantity=left, share=share, when=when)
                if size == _TWO:
                    return say("derived.twice", quantity=left, value=multiple)
                return say("derived.times", quantity=left, share=share, value=multiple)
        return say("derived.is", quantity=left, value=_measured(naming, link, right))
    if link.sign in _BOUNDS and isinstance(left, lay.Words | lay.Phrase):
        bound: Sentence | lay.Layout | str = _measured(naming, link, right)
        match link.right:
            case Quantity() if isinstance(right, lay.Words | lay.Phrase):
                bound = say("derived.called", quantity=right)
            case Binary("*", size, Quantity() as whole) if _is_share(size):
                share = _percentage(naming.as_typed(size))
                bound = say("derived.part", share=share, value=naming.side(whole))
            case Binary("*", Letter() | Number() as size, Quantity() as whole) if isinstance(
                multiple := naming.side(whole), lay.Words | lay.Phrase
            ):
                bound = say("derived.times-the", share=naming.as_typed(size), value=multiple)
        return say(_BOUNDS[link.sign], quantity=left, value=bound)
    return naming.relation(fact.relation)


def _as_a_multiple(tree: Expression) -> Expression:
    """A quotient of a quantity by a number as a part of it: a half of it; any other tree itself."""
    match tree:
        case Binary("/", Quantity() as whole, Number(size)) if size > 1:
            return Binary("*", Number(1 / size), whole)
    return tree


def _when_the_same(naming: Naming, one: Expression, other: Expression) -> Sentence | None:
    """When a distance is as another is said, of the same ends; None of others."""
    same = is_quantity(one, "distance") and _without_stages(one) == _without_stages(other)
    return naming.when(other) if same else None


def _without_stages(tree: Expression) -> Expression:
    return rebuilt(tree, lambda own: replace(own, stage=None) if isinstance(own, Quantity) else own)


def velocity_given(naming: Naming, fact: Fact) -> lay.Layout:
    """A velocity that is given as a vector: *𝐯 = (2𝐢 + 3𝐣) m s⁻¹*."""
    (link,) = fact.relation.only
    left, value = naming.layout(link.left), naming.layout(link.right)
    unit = naming.unit(link.left) if is_plain(value) else ""
    if unit and isinstance(value, lay.Sum) and len(value.terms) > 1:
        value = lay.Brackets(value)
    # A unit is no part of a formula.
    return with_unit(lay.Relation((left, value), ("=",)), unit)


def _measured(
    naming: Naming, link: Link, right: Sentence | lay.Layout | str
) -> Sentence | lay.Layout | str:
    """A given number with the unit of the quantity of which it is the value."""
    if not isinstance(right, lay.Layout) or not is_plain(right) or is_zero(link.right):
        return right
    return with_unit(right, naming.unit(link.left))


def _is_rest(tree: Expression) -> bool:
    """Whether a velocity is that of a body at rest."""
    match tree:
        case Number(value):
            return not value
        case Pair(Number(x), Number(y)):
            return not x and not y
    return False


# What is said of the ratio of an angle without a letter.
_TWO = Number(Fraction(2))
_RATIOS: Mapping[str, str] = {
    "sin": "derived.sine-is",
    "cos": "derived.cosine-is",
    "tan": "derived.tangent-is",
}
# How a quantity is bounded, in words.
_BOUNDS: Mapping[str, str] = {
    ">": "derived.more",
    ">=": "derived.at-least",
    "<": "derived.less",
    "<=": "derived.at-most",
}


def _percentage(share: lay.Layout) -> lay.Layout:
    """A part in decimals as a percentage; any other as it is written."""
    if isinstance(share, lay.Number) and "." in share.digits:
        percent = 100 * Fraction(share.digits)
        if percent.denominator == 1:
            return lay.Percent(lay.Number(str(percent)))
    return share


def _is_share(tree: Expression) -> bool:
    """Whether a number is a part of a whole."""
    match tree:
        case Number(value):
            return 0 < value < 1
        case Binary("/", Number(above), Number(below)):
            return 0 < above < below
    return False
