"""A quotient with a sum of roots below, of which the denominator is made rational on paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Link, Relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Binary,
    Expression,
    has_root,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.forms import product, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.solving.equations.coefficients import COEFFICIENTS


def with_conjugates(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a quotient is multiplied by the conjugate of what is below.

    A coefficient that cannot be is seen from the quotient, and has its short form at once.
    """
    lines = list(derivation.lines)
    read = None
    impossible = _impossible_coefficients(derivation)
    for index, line in enumerate(lines):
        if not isinstance(line.relation, Relation) or len(line.relation.options) > 1:
            continue
        if line.number in impossible:
            continue
        links = tuple(_longer(line.relation.only))
        if len(links) > len(line.relation.only):
            own = replace(line, relation=Relation((links,)))
            read = read or reader_of(derivation, oracle)
            lines[index] = own if read.accepts(own) else line
    return replace(derivation, lines=tuple(lines))


def _impossible_coefficients(derivation: Derivation) -> set[int]:
    """The lines that say what a coefficient cannot be, on which no other line rests."""
    cited = {ref for line in derivation.lines for ref in line.premises}
    return {
        number
        for note in derivation.notes
        if note.kind == "impossible" and note.reason == COEFFICIENTS
        for number in note.lines
        if number not in cited
    }


def _longer(links: tuple[Link, ...]) -> Iterator[Link]:
    """The links of a chain, with those that multiply by the conjugate before a rational form."""
    for link in links:
        between = _multiplied(link) if link.sign == "=" and link.by in (None, "rearrange") else None
        if between is None:
            yield link
            continue
        yield replace(link, right=between)
        worked = _worked_out(between, link.right)
        if worked is not None:
            yield Link(between, "=", worked, "rearrange")
        yield replace(link, left=worked or between, by="rearrange")


def _worked_out(quotient: Binary, final: Expression) -> Expression | None:
    """A quotient of products, multiplied out before it is cancelled.

    None where it has letters or fractions in it, or nothing is cancelled.
    """
    if letters(quotient):
        return None
    above, below = (expanded(in_letters(side)) for side in (quotient.left, quotient.right))
    terms = sp.Add.make_args(above)
    if below == 1 or not all(term.as_coeff_Mul()[0].is_Integer for term in terms):
        return None
    cancels = not (is_binary(final, "/") and in_letters(final.right) == below)
    return Binary("/", tree_of(above, as_it_is=True), tree_of(below)) if cancels else None


def _multiplied(link: Link) -> Binary | None:
    """A left side above and below times the conjugate of its denominator; the right has no such.

    None where the denominator is no sum of two numbers of which one at least is a root.
    """
    match link.left:
        case Binary("/", above, Binary("+" | "-") as below) if has_root(below):
            pass
        case _:
            return None
    if letters(below) or any(_is_over_roots(node) for node in walk(link.right)):
        return None
    terms = sp.Add.make_args(expanded(in_letters(below)))
    if len(terms) != 2 or any(abs(term).is_rational is None for term in terms):
        return None
    first, second = sorted(terms, key=lambda term: -float(abs(term)))
    other = abs(first) - abs(second) if first * second > 0 else abs(first) + abs(second)
    content = sp.gcd_list([abs(term.as_coeff_Mul()[0]) for term in terms])
    tree = tree_of(tidy(expanded(other / content)))
    return Binary("/", product(above, tree), product(below, tree))


def _is_over_roots(node: Expression) -> bool:
    """Whether a node is a quotient with a root in a sum below."""
    if not is_binary(node, "/") or not has_root(node.right):
        return False
    return any(is_binary(part, "+", "-") for part in walk(node.right))


__all__ = ["with_conjugates"]
