"""Both ends of a letter whose square an equation gives, that only grows or falls with a letter."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Relation
from restitution.expression.tree import Expression, Letter
from restitution.planning.inequalities.claims_eliminated import Eliminated
from restitution.planning.writing.forms import square, tree_of
from restitution.planning.writing.inequalities import subject_of


def write_by_its_square(claims: Eliminated, relation: Relation) -> int | None:
    """The range ``u cos α <= v <= u`` of v² = u² cos²α + e²u² sin²α, which grows with e.

    None of another relation, and without such an equation; nor of an end that is not reached, which
    may hang on the other letters too.
    """
    subject = subject_of(relation)
    if len(relation.options) != 1 or len(relation.only) != 2 or not isinstance(subject, Letter):
        return None
    if any(link.sign not in ("<=", ">=") for link in relation.only):
        return None
    mark = claims.worths.mark()
    for line in claims.ties.lines():
        if claims.scene.desk.last_link(line).left != square(subject):
            continue
        ends = Relation((tuple(_squared(claims, link, subject) for link in relation.only),))
        bounds = claims.monotone(line, ends)
        last = None if bounds is None else claims.compared([bounds], relation)
        if last is not None:
            return last
    claims.worths.back(mark)
    return None


def _squared(claims: Eliminated, link: Link, subject: Expression) -> Link:
    """A bound of a letter as one of its square."""

    def squared(side: Expression) -> Expression:
        if side == subject:
            return square(subject)
        return tree_of(tidy(claims.worths.value(side) ** 2))

    return Link(squared(link.left), link.sign, squared(link.right))


__all__ = ["write_by_its_square"]
