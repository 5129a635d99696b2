"""Both laws of an impact on their way to its components: tidied, and one put into the other."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Negate,
    is_binary,
    letters,
    walk,
)
from restitution.planning.formulas.impacts import residual
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import difference, product, total, tree_of
from restitution.planning.writing.polynomials import derivative, expanded, one_fraction
from restitution.planning.writing.scene import Scene

_PAIR = 2


def tidied_law(scene: Scene, number: int, symbols: Sequence[sp.Symbol]) -> int:
    """A law whose known side holds sums within sums, as a line in which that is worked out.

    Without what all its terms have in common; the line itself where there is nothing to do.
    """
    link = scene.desk.last_link(number)
    names = {symbol.name for symbol in symbols}
    sides = [side for side in (link.left, link.right) if letters(side).isdisjoint(names)]
    if len(sides) != 1 or not _has_sums_in_a_sum(sides[0]):
        return number
    own = residual(scene, number)
    coefficients = [derivative(own, symbol) for symbol in symbols]
    if any(
        coefficient.free_symbols & set(symbols) or coefficient.has(sp.Add)
        for coefficient in coefficients
    ):
        return number
    rest = own.subs(dict.fromkeys(symbols, 0))
    shared = sp.gcd_list(coefficients)
    if shared == 0:
        return number
    sign = -1 if sides[0] == link.left else 1
    worth = tidy(one_fraction(expanded(-sign * rest / shared)))
    terms = [
        product(tree_of(tidy(sign * coefficient / shared)), Letter(symbol.name))
        for coefficient, symbol in zip(coefficients, symbols, strict=True)
    ]
    if isinstance(terms[0], Negate):
        terms.reverse()
    open_, known = total(terms), tree_of(worth)
    relation = chain(*((known, (open_, None)) if sign < 0 else (open_, (known, None))))
    if len(walk(known)) >= len(walk(sides[0])):
        return number
    return in_another_form(scene, number, relation) or number


def _has_sums_in_a_sum(tree: Expression) -> bool:
    """Whether terms are added of which one holds a sum of letters or roots itself."""
    return any(
        is_binary(node, "+", "-")
        and any(_is_sum(tree) for side in (node.left, node.right) for tree in walk(side))
        for node in walk(tree)
    )


def _is_sum(tree: Expression) -> bool:
    return is_binary(tree, "+", "-") and (
        bool(letters(tree)) or any(isinstance(node, Apply) for node in walk(tree))
    )


def put_into_restitution(
    scene: Scene, symbol: sp.Symbol, other: sp.Symbol, known: Source, law: int
) -> bool:
    """Whether a component is the other one, which is a line, and what they differ by.

    It is written so only where the other is plain enough to be added to that in the head.
    """
    own = residual(scene, law)
    slope = derivative(own, symbol)
    if slope not in (1, -1) or derivative(own, other) != -slope or not _is_plain(known.value):
        return False
    apart = tidy(one_fraction(-own.subs({symbol: 0, other: 0}) * slope))
    components = {component.symbol for component in scene.model.components.values()}
    if apart == 0 or apart.free_symbols & components:
        return False
    lead = apart.as_coeff_Mul()[0].is_negative
    tree = tree_of(known.value)
    stated = None if lead else _as_stated(scene, law, apart)
    form = difference(tree, tree_of(-apart)) if lead else total((tree, stated or tree_of(apart)))
    value = tidy(one_fraction(expanded(known.value + apart)))
    relation = chain(Letter(symbol.name), (form, None), (tree_of(value), "rearrange"))
    refs = scene.judge.enough(Move("put"), (law, *known.refs), relation)
    if refs is None or len(refs) != _PAIR:
        return False
    line = scene.desk.write(Move("put"), refs, relation)
    scene.desk.know(Letter(symbol.name), value, (line,))
    return True


def _as_stated(scene: Scene, law: int, apart: sp.Expr) -> Expression | None:
    """A speed of separation as the law has it, ``0.65(u cos 25° + 0.8u cos 40°)``.

    None without ratios of degrees that only a calculator knows.
    """
    right = scene.desk.last_link(law).right
    if not apart.atoms(sp.sin, sp.cos) or apart.atoms(sp.sin, sp.cos) & _of_letters(apart):
        return None
    return right if tidy(scene.scalar(right) - apart) == 0 else None


def _of_letters(value: sp.Expr) -> set[sp.Basic]:
    """The ratios of angles that are no numbers."""
    return {ratio for ratio in value.atoms(sp.sin, sp.cos) if ratio.free_symbols}


def _is_plain(value: sp.Expr) -> bool:
    """Whether a value is one fraction of products, or of sums with one letter and no ratio."""
    above = sp.fraction(one_fraction(value))[0]
    return not above.is_Add or (len(above.free_symbols) == 1 and not above.has(sp.Function))


__all__ = ["put_into_restitution", "tidied_law"]
