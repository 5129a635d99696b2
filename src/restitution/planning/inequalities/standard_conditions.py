"""Inequalities in the form that is solved: as a product of sums, or in powers of one letter."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Apply, Binary, Expression, Letter, walk
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import ZERO, outer_terms, product, square, total, tree_of
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.solving.algebra.numbers import plain_sign
from restitution.solving.story.letters import roles

_MOVES = (Move("rearrange"), Move("cancel"), Move("compare"))


def in_factors(worths: Worths, line: int, known: Sequence[Ref]) -> int:
    """``(1 − 2e)(2 − e) ≤ 0``, ``e(2 − e) > 0``: an inequality as a product; or the line itself.

    What is positive in any case, and is no sum, is left out.
    """
    link = worths.scene.desk.last_link(line)
    gap = factored(one_fraction(worths.value(link.left) - worths.value(link.right)))
    if (angle := _angle_of_tangents(worths, link)) is not None:
        return _in_tangents(worths, line, known, angle, gap)
    above, _ = sp.fraction(gap)
    factors = list(sp.Mul.make_args(above))
    sums = [factor for factor in factors if factor.as_base_exp()[0].is_Add]
    sums = [
        factor for factor in factors if factor.is_Symbol and not factor.is_positive and sums
    ] + sums
    if len(sums) < 2 or link.right == ZERO:
        return line
    if (
        all(factor.as_base_exp()[0].is_Add for factor in sums)
        and len(expanded(sp.Mul(*sums)).args) == 2
    ):
        return line  # of the difference of two squares the root is taken
    own = _in_one_letter(worths, line, known, sums, gap)
    if own is not None:
        return own
    sums = [-factor if factor.is_Add and _begins_below_zero(factor) else factor for factor in sums]
    rest = proved_sign(worths.scene.model.inside, cancelled(gap / sp.Mul(*sums)))
    if not rest:
        return line
    sign = link.sign if rest > 0 else FLIPPED[link.sign]
    trees = sorted(map(tree_of, sums), key=lambda tree: not isinstance(tree, Letter))
    relation = Relation(((Link(product(*trees), sign, ZERO),),))
    written = worths.judge.write(_MOVES, [line, *known], relation)
    return line if written is None else _open_factor(worths, written, sums, sign, known)


def _in_one_letter(
    worths: Worths, line: int, known: Sequence[Ref], sums: Sequence[sp.Expr], gap: sp.Expr
) -> int | None:
    """``2k² − 5k + 2 < 0``, and its factors: a quadratic in a letter that has no upper bound.

    None of another product. Of a coefficient of restitution the factors have its bounds.
    """
    symbols = {symbol for factor in sums for symbol in factor.free_symbols}
    if len(symbols) != 1 or len(sums) != 2 or not all(map(is_linear, sums)):
        return None
    (symbol,) = symbols
    role = roles(worths.scene.problem).get(symbol.name)
    if role is None or role.kind != "positive" or any(map(plain_sign, sums)):
        return None
    rising = [factor if polynomial_in(factor, symbol).LC() > 0 else -factor for factor in sums]
    poly = polynomial_in(expanded(sp.Mul(*rising)), symbol)
    rest = proved_sign(worths.scene.model.inside, cancelled(gap / sp.Mul(*rising)))
    sides = None if 0 in poly.all_coeffs() else _in_order(symbol, poly)
    if not rest or sides is None:
        return None
    link = worths.scene.desk.last_link(line)
    sign = link.sign if rest > 0 else FLIPPED[link.sign]
    in_factors_ = tree_of(sp.factor(poly.as_expr()), as_it_is=True)
    for left in (sides[0], in_factors_):
        relation = Relation(((Link(left, sign, ZERO),),))
        line = worths.judge.write(_MOVES, [line, *known], relation) or line
    return line


def _open_factor(
    worths: Worths, line: int, factors: Sequence[sp.Expr], sign: Sign, known: Sequence[Ref]
) -> int:
    """``5 − 4e < 0`` for ``(1 + 4e)(5 − 4e) < 0``: the one factor whose sign is not known."""
    ground = worths.scene.model.ground
    # 1 + 4e is positive at sight, 5 − 4e only as e is not more than 1.
    senses = {factor: plain_sign(factor) for factor in factors}
    if list(senses.values()).count(None) > 1:
        senses = {factor: proved_sign(ground, factor) for factor in factors}
    open_ = [factor for factor in factors if not senses[factor]]
    if len(open_) != 1 or not is_linear(open_[0]):
        return line
    for factor in factors:
        sign = FLIPPED[sign] if senses[factor] == -1 else sign
    relation = Relation(((Link(tree_of(open_[0]), sign, ZERO),),))
    mark = worths.mark()
    after = worths.judge.write((Move("cancel"), Move("compare")), [line, *known], relation)
    if after is not None and worths.scene.desk.line(after).premises == (line,):
        worths.back(mark)  # nothing would say why the factor is positive
        return line
    return line if after is None else after


def is_linear(x: sp.Expr) -> bool:
    """Whether an expression is of the first degree in its one letter."""
    if len(x.free_symbols) != 1:
        return False
    (symbol,) = x.free_symbols
    return bool(x.is_polynomial(symbol) and sp.degree(x, symbol) == 1)


def _angle_of_tangents(worths: Worths, link: Link) -> sp.Symbol | None:
    """The angle of which tangents, and no other ratios, stand in an inequality; or None."""
    ratios = {e for side in (link.left, link.right) for e in walk(side) if isinstance(e, Apply)}
    arguments = {e.argument for e in ratios if e.function == "tan"}
    if len(arguments) != 1 or any(e.function in ("sin", "cos") for e in ratios):
        return None
    (argument,) = arguments
    return (
        worths.scene.model.unknowns.letter(argument.name) if isinstance(argument, Letter) else None
    )


def _in_tangents(
    worths: Worths, line: int, known: Sequence[Ref], angle: sp.Symbol, gap: sp.Expr
) -> int:
    """``4 tan²α − 5 tan α + 1 ≤ 0``, and its factors: an inequality in one tangent, with numbers.

    The line itself where it has no two factors.
    """
    tangent = sp.Dummy("t", positive=True)
    own = sp.factor(one_fraction(gap.subs(sp.sin(angle), tangent * sp.cos(angle))))
    above, _ = sp.fraction(own)
    sums = [factor for factor in sp.Mul.make_args(above) if factor.is_Add]
    if own.free_symbols != {tangent} or len(sums) != 2 or not all(_is_linear(e) for e in sums):
        return line
    sums = [-factor if sp.Poly(factor).LC() < 0 else factor for factor in sums]
    rest = cancelled(own / sp.Mul(*sums)).subs(tangent, sp.tan(angle))
    sense = proved_sign(worths.scene.model.inside, rest.rewrite(sp.cos))
    if not sense:
        return line
    link = worths.scene.desk.last_link(line)
    sign = link.sign if sense > 0 else FLIPPED[link.sign]
    poly = polynomial_in(expanded(sp.Mul(*sums)), tangent)
    if 0 in poly.all_coeffs():
        return line  # of the difference of two squares the root is taken
    sums.sort(key=lambda factor: -sp.Poly(factor).nth(0) / sp.Poly(factor).LC())
    factors = product(*(tree_of(factor.subs(tangent, sp.tan(angle))) for factor in sums))
    for left in (_in_order(sp.tan(angle), poly)[0], factors):
        relation = Relation(((Link(left, sign, ZERO),),))
        line = worths.judge.write(_MOVES, [line, *known], relation) or line
    return line


def _is_linear(factor: sp.Expr) -> bool:
    return bool(sp.Poly(factor).degree() == 1)


def _begins_below_zero(value: sp.Expr) -> bool:
    number, _ = value.as_coeff_Add()
    return bool(number.is_negative) if number else value.could_extract_minus_sign()


def as_quadratic(
    worths: Worths,
    line: int,
    sign: Sign,
    x: sp.Expr,
    wanted: Expression | None,
    known: Sequence[Ref],
) -> int:
    """``x sign 0`` of the second degree: its terms in their order, or its square completed.

    It is one of a letter, or of one ratio of an angle. The line itself where ``x`` is none.
    """
    own = _polynomial(expanded(x), wanted)
    if own is None:
        return line
    generator, poly = own
    stated = worths.scene.desk.last_link(line)
    links = worths.scene.desk.relation(line).options[0]
    if any(tree_of(generator) in (link.left, link.right) for link in links):
        return line  # it is solved, perhaps between two bounds
    if _is_of_factors(stated, generator):
        return line
    if poly.degree() != 2 or 0 in poly.all_coeffs():
        return line
    sides = _in_order(generator, poly) if poly.LC().is_number else _as_square(generator, poly)
    if sides is None:
        return line
    turned = poly.LC().could_extract_minus_sign()
    link = Link(sides[0], FLIPPED[sign] if turned else sign, sides[1])
    alike = (stated.sign, stated.right) == (link.sign, link.right) == (sign, ZERO)
    if alike and set(outer_terms(stated.left)) == set(outer_terms(link.left)):
        return line  # only the order of its terms is another
    relation = Relation(((link,),))
    above = worths.judge.standing(relation)
    if above is not None and above < line:
        return line  # it has the factors of that
    written = worths.judge.write(_MOVES, [line, *known], relation)
    return line if written is None else written


def _is_of_factors(link: Link, generator: sp.Expr) -> bool:
    """Whether an inequality says the sign of a product of two sums with a ratio of an angle."""
    match link:
        case Link(Binary("*", one, other), _, right) if right == ZERO and generator.is_Function:
            ratio = tree_of(generator)
            return all(ratio in set(walk(side)) and side != ratio for side in (one, other))
    return False


def _polynomial(x: sp.Expr, wanted: Expression | None) -> tuple[sp.Expr, sp.Poly] | None:
    """The variable in which ``x`` is a polynomial: its one letter, the wanted one, or one ratio."""
    ratios = x.atoms(sp.sin, sp.cos, sp.tan)
    angles = {ratio.args[0] for ratio in ratios}
    letters = x.free_symbols - {symbol for angle in angles for symbol in angle.free_symbols}
    try:
        if not ratios and len(letters) > 1:
            own = next((letter for letter in letters if wanted == Letter(letter.name)), None)
            return None if own is None else (own, polynomial_in(x, own))
        if letters and not ratios:
            return (own := letters.pop()), polynomial_in(x, own)
        if len(ratios) == 1 and not letters:
            return (own := ratios.pop()), polynomial_in(x, own)
        if len(angles) != 1 or letters:
            return None
        angle = angles.pop()
        mixed = polynomial_in(x, sp.sin(angle), sp.cos(angle))
    except sp.PolynomialError:
        return None
    if {sum(powers) for powers in mixed.monoms()} != {2}:
        return None
    tangent = sp.tan(angle)
    return tangent, sp.Poly({(n,): c for (n, _), c in mixed.terms()}, tangent)


def _in_order(generator: sp.Expr, poly: sp.Poly) -> tuple[Expression, Expression]:
    """``a t² + b t + c``, in whole numbers as far as there are no roots, and 0."""
    shares = [tidy(coefficient / poly.LC()) for coefficient in poly.all_coeffs()]
    below = sp.ilcm(*(share.as_coeff_Mul()[0].q for share in shares))
    a, b, c = (tree_of(tidy(share * below)) for share in shares)
    tree = tree_of(generator)
    return total([product(a, square(tree)), product(b, tree), c]), ZERO


def _as_square(generator: sp.Expr, poly: sp.Poly) -> tuple[Expression, Expression] | None:
    """``e(k + 1)²`` and ``(1 + e)²``; None where what is added to the letter is no number."""
    a, b, c = poly.all_coeffs()
    shift = cancelled(b / (2 * a))
    rest = factored(a * shift**2 - c)
    if not shift.is_number:
        return None
    turn = -1 if a.could_extract_minus_sign() else 1
    left = product(tree_of(turn * a), square(tree_of(generator + shift)))
    return left, tree_of(factored(turn * rest))
