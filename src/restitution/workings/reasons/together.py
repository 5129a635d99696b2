"""Reasons of a line that are told together: *α and φ are acute*, *0 ≤ e ≤ 1*."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.workings.reasons.shape_reasons import UP


def with_acute_angles_together(sentence: Sentence) -> Sentence:
    """The same reasons, of which those that angles are acute are one, or part of a limit."""
    slots = dict(sentence.slots)
    reasons = slots.get("reasons")
    if sentence.id != "derived.as" or not isinstance(reasons, tuple):
        return sentence
    acute = [
        reason
        for reason in reasons
        if isinstance(reason, Sentence) and reason.id == "derived.acute"
    ]
    match reasons, acute:
        case (Sentence("derived.limit") as limit, *others), [one]:
            own = say("derived.limit-acute", fact=dict(limit.slots)["fact"], **dict(one.slots))
            return say("derived.as", reasons=(own, *(e for e in others if e != one)))
    if len(acute) < 2:
        return sentence
    both = say("derived.both-acute", angles=tuple(dict(e.slots)["angle"] for e in acute))
    first = reasons.index(acute[0])
    rest = tuple(reason for reason in reasons[first:] if reason not in acute)
    return say("derived.as", reasons=(*reasons[:first], both, *rest))


def merged(bounds: list[Link]) -> Iterator[Relation]:
    """Bounds of one letter as one chain: 0 ≤ e ≤ 1."""
    rest = list(bounds)
    while rest:
        link = rest.pop(0)
        for other in rest:
            low, high = (_upwards(own) for own in (link, other))
            if low.right != high.left:
                low, high = high, low
            if low.right == high.left:
                rest.remove(other)
                yield Relation(((low, high),))
                break
        else:
            yield Relation(((link,),))


def _upwards(link: Link) -> Link:
    """A bound with its lower side on the left."""
    if link.sign in UP:
        return link
    return Link(link.right, "<" if link.sign == ">" else "<=", link.left)


__all__ = ["merged", "with_acute_angles_together"]
