"""By what a line is divided that loses a factor, so that its words can say so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import FLIPPED, Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import exchanged, trees_of
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    is_binary,
    is_function,
    is_zero,
    letters,
    walk,
)
from restitution.oracle import REAL, BeyondError, Oracle, Role, compared
from restitution.planning.writing.forms import UnwrittenError, factors_above, tree_of
from restitution.work import remembered
from restitution.workings.reasons.right_angles import in_letters_alone


def factor_cancelled(derivation: Derivation, line: Line) -> Expression | None:
    """The factor in letters by which a line was divided; None where it has no short form.

    Beside a sum nothing is said of letters of which nothing is cited: they are positive. Who takes
    the root of a square divides by nothing.
    """
    both = _before_and_after(derivation, line)
    if both is not None and _is_root_of(*both):
        return None
    facts = (ref for ref in line.premises if isinstance(ref, str))
    cited = frozenset(word.strip(":") for fact in facts for word in fact.split())
    return None if both is None else _cancelled(*both, cited)


def _is_root_of(above: Relation, line: Relation) -> bool:
    """Whether one relation says of the square of a side what the other says of the side."""
    links = (*above.options[0], *line.options[0])
    if len(links) != 2 or any(link.sign != "=" for link in links):
        return False
    square, root = links
    match square.left:
        case Binary("^", base, Number(power)):
            return power == 2 and base == root.left
    return False


def _before_and_after(derivation: Derivation, line: Line) -> tuple[Relation, Relation] | None:
    """What stands in the first line that a line cites, and in itself; None where one has roots."""
    first = line.premises[0] if line.premises else None
    above = derivation.line(first)
    if above is None or not isinstance(above.relation, Relation):
        return None
    assert isinstance(line.relation, Relation)
    if len(above.relation.options) != 1 or len(line.relation.options) != 1:
        return None
    return above.relation, line.relation


@remembered(1024)
def _cancelled(above: Relation, line: Relation, cited: frozenset[str]) -> Expression | None:
    """The factor by which one relation was divided to be the other."""
    try:
        own, back = _with_letters_for_tangents(above, line)
        before, after = map(_residual, own)
        numerator, _ = sp.fraction(sp.cancel(before / after))
        _, factor = sp.factor_list(numerator)
        whole = [(exchanged(tree_of(base**power), back), base) for base, power in factor]
        if any(base.is_Add for _, base in whole):
            # Of the factor of which something is cited, that is why it is not zero.
            about = [e for e in whole if letters(e[0]) & cited]
            whole = about or [e for e in whole if not e[1].is_Symbol]
        return whole[0][0] if len(whole) == 1 else None
    except (RestitutionError, UnwrittenError, ZeroDivisionError, TypeError, sp.PolynomialError):
        return None


def cosine_divided(derivation: Derivation, line: Line) -> Letter | None:
    """The angle by whose squared cosine an equation was divided, to have its tangent alone.

    None where only squares stand in it: that a tangent is a quotient is seen there.
    """
    both = _before_and_after(derivation, line)
    return None if both is None else _cosine(*both)


@remembered(1024)
def _cosine(above: Relation, line: Relation) -> Letter | None:
    """The angle by whose squared cosine one relation was divided to be the other."""
    ratios = [_ratios(own) for own in (above, line)]
    angles = {function.argument for function in ratios[1] if function.function == "tan"}
    if len(angles) != 1 or any(function.function == "tan" for function in ratios[0]):
        return None
    (angle,) = angles
    own = {function.function for function in ratios[1] if function.argument == angle}
    if not isinstance(angle, Letter) or own != {"tan"}:
        return None
    symbol = sp.Symbol(angle.name, positive=True)
    tangent, cosine = sp.Dummy(positive=True), sp.Dummy(positive=True)
    put = {sp.sin(symbol): tangent * cosine, sp.cos(symbol): cosine, sp.tan(symbol): tangent}
    try:
        before, after = (_residual(relation).xreplace(put) for relation in (above, line))
        ratio = sp.cancel(before / after)
    except (RestitutionError, ZeroDivisionError, TypeError, sp.PolynomialError):
        return None
    divided = sp.cancel(ratio / cosine**2)
    mixed = sp.expand(after).coeff(tangent, 1) != 0
    return angle if mixed and not divided.has(cosine, tangent) else None


def _with_letters_for_tangents(
    *relations: Relation,
) -> tuple[tuple[Relation, ...], dict[Expression, Expression]]:
    """The same with letters for the tangents of angles of which nothing else stands there."""
    nodes = {ratio for own in relations for ratio in _ratios(own)}
    mixed = {node.argument for node in nodes if node.function != "tan"}
    alone = [node for node in nodes if node.argument not in mixed]
    put: dict[Expression, Expression] = {e: Letter(f"tangent_{n}") for n, e in enumerate(alone)}
    whole = tuple(
        Relation(
            tuple(
                tuple(
                    replace(e, left=exchanged(e.left, put), right=exchanged(e.right, put))
                    for e in links
                )
                for links in own.options
            )
        )
        for own in relations
    )
    return whole, {letter: tangent for tangent, letter in put.items()}


def _ratios(relation: Relation) -> list[Apply]:
    """The sines, cosines and tangents in a relation."""
    nodes = (node for tree in trees_of(relation) for node in walk(tree))
    return [e for e in nodes if is_function(e, "sin", "cos", "tan")]


def _residual(relation: Relation) -> sp.Expr:
    """Left minus right. Raises RestitutionError where a quantity of the motion stands in it."""
    link = relation.only[0]
    left, right = (in_letters(side, positive=True) for side in (link.left, relation.only[-1].right))
    return sp.sympify(left - right, strict=True)


def factor_left(derivation: Derivation, line: Line) -> Expression | None:
    """The sum that is left out of a product that is zero, where a line takes the root of the other.

    None where there is no such factor, or more than one.
    """
    return _factor_beside(derivation, line, frozenset("="))


def positive_factor_left(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> Expression | None:
    """The factor that is positive and left out of a product of which the sign is known.

    None where there is no such factor, and where it is a sum that is positive by more than what its
    letters may be.
    """
    factor = _factor_beside(derivation, line, frozenset(FLIPPED))
    if factor is None or not any(
        isinstance(e, Negate | Apply) or is_binary(e, "-") for e in walk(factor)
    ):
        return factor
    if any(isinstance(node, Apply) for node in walk(factor)):
        return None
    try:
        value = sp.sympify(evaluate(factor, lambda n: roles.get(n, REAL).symbol(n)), strict=True)
        return factor if Oracle(roles).proves(compared(value, ">", sp.Integer(0))) else None
    except (RestitutionError, BeyondError):
        return None


def sums_left(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> Iterator[Expression]:
    """The positive sums left out of a product compared with 0, of which another sum remains."""
    above = derivation.line(line.premises[0]) if line.premises else None
    if above is None or line.move.id not in ("rearrange", "cancel"):
        return
    match above.relation, line.relation:
        case (
            Relation(((Link(product, one, zero),),)),
            Relation(((Link(Binary() as rest, other, right),),)),
        ) if is_zero(zero) and is_zero(right) and {one, other} <= FLIPPED.keys():
            sums = [e for e in factors_above(product) if is_binary(e, "+") or is_binary(e, "-")]
        case _:
            return
    kept = in_letters_alone(rest)
    values = {tree: value for tree in sums if (value := in_letters_alone(tree)) is not None}
    if kept is None or not kept.free_symbols:
        return
    gone = [(e, value) for e, value in values.items() if sp.cancel(value / kept).free_symbols]
    if len(gone) == len(values):
        return
    for tree, value in gone:
        names = {str(symbol) for symbol in value.free_symbols}
        own = Oracle({name: roles[name] for name in names}) if names <= roles.keys() else None
        if own is not None and own.proves(compared(value, ">", sp.Integer(0))):
            yield tree


def _factor_beside(derivation: Derivation, line: Line, signs: frozenset[str]) -> Expression | None:
    """The other sum of a product compared with zero, where a line bounds a letter by one.

    The one may be the letter itself.
    """
    (first, *rest) = line.premises or ("",)
    above = derivation.line(first)
    if above is None or line.move.id not in ("rearrange", "cancel"):
        return None
    # Of an inequality the bounds of its letters are cited besides.
    if rest and ("=" in signs or any(isinstance(ref, int) for ref in rest)):
        return None
    match above.relation, line.relation:
        case (
            Relation((((Link(product, one, right)),),)),
            Relation(((Link(Letter(name), other, value), *_),)),
        ) if is_zero(right) and {one, other} <= signs:
            parts = factors_above(product)
            sums = [e for e in parts if isinstance(e, Binary) or e == Letter(name)]
        case _:
            return None
    put = [in_letters_alone(exchanged(addend, {Letter(name): value})) for addend in sums]
    left = [
        addend
        for addend, own in zip(sums, put, strict=True)
        if name in letters(addend) and own is not None and sp.cancel(own) != 0
    ]
    return left[0] if len(sums) == 2 and len(left) == 1 else None


__all__ = ["cosine_divided", "factor_cancelled", "factor_left", "positive_factor_left", "sums_left"]
