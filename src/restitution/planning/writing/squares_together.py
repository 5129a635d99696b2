"""sin² + cos² on paper: a sum that the identity shortens has it as a factor first."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Binary, Expression, has_quantity, walk
from restitution.oracle import Oracle
from restitution.planning.writing.forms import product, swept, tree_of
from restitution.planning.writing.polynomials import cancelled, expanded

_PYTHAGORAS = Move("identity", "pythagoras")
_MOST = 60  # nodes of a sum of which a reader sees the factors


def with_squares_together(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a line by sin² + cos² = 1 has that sum as a factor before.

    Of u² cos⁴α/sin²α + u² cos²α = u² cot²α nobody sees how it is shortened; of u² cos²α (cos²α +
    sin²α)/sin²α it is seen.
    """
    lines = list(derivation.lines)
    read = None
    for index, line in enumerate(lines):
        between = _factored(derivation, line)
        if between is None:
            continue
        assert isinstance(line.relation, Relation)
        (link,) = line.relation.only
        links = (replace(link, right=between), Link(between, "=", link.right, "identity"))
        own = replace(line, move=Move("rearrange"), relation=Relation((links,)))
        read = read or reader_of(derivation, oracle)
        lines[index] = own if read.accepts(own) else line
    return replace(derivation, lines=tuple(lines))


def _factored(derivation: Derivation, line: Line) -> Expression | None:
    """The right side above a line as a product with sin² + cos²; None where it is no such product.

    It is none either where that is seen at once: where both squares stand alone in their terms.
    """
    if line.move != _PYTHAGORAS or len(derivation.lines_in(line.premises)) != 1:
        return None
    (above,) = derivation.lines_in(line.premises)
    match above.relation, line.relation:
        case Relation((links,)), Relation(((Link(left, "=", short),),)) if links[0].left == left:
            long = links[-1].right
        case _:
            return None
    if has_quantity(long) or has_quantity(short) or not isinstance(long, Binary) or long.op != "+":
        return None
    whole, rest = in_letters(long), in_letters(short)
    if not (isinstance(whole, sp.Expr) and isinstance(rest, sp.Expr)) or len(walk(long)) > _MOST:
        return None
    angles = {ratio.args[0] for ratio in whole.atoms(sp.sin, sp.cos)}
    if len(angles) != 1 or whole.has(sp.tan, sp.cot):
        return None
    (angle,) = angles
    s, c = sp.Dummy("s", positive=True), sp.Dummy("c", positive=True)
    put = {sp.sin(angle): s, sp.cos(angle): c, sp.tan(angle): s / c, sp.cot(angle): c / s}
    quotient = cancelled(whole.xreplace(put) / rest.xreplace(put))
    if expanded(quotient - s**2 - c**2) != 0:
        return None
    outside = cancelled(rest.xreplace(put)).xreplace({s: sp.sin(angle), c: sp.cos(angle)})
    above_, below = sp.fraction(outside)
    if not outside.has(sp.sin, sp.cos):
        return None
    squares = Binary("+", *(tree_of(f(angle) ** 2) for f in (sp.sin, sp.cos)))
    tree = product(tree_of(tidy(above_), as_it_is=True), squares)
    return swept(tree if below == 1 else Binary("/", tree, tree_of(below, as_it_is=True)))


__all__ = ["with_squares_together"]
