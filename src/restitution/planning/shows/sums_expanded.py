"""What is shown with a sum of two angles: the letter that goes, and the sum written out, first."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.exact.trigonometry import in_sines
from restitution.explaining.lines.derivation import Link, Move, Ref, numbers_in
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Apply, Binary, Expression, Letter, letters
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import product, tree_of
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.polynomials import expanded, one_fraction, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

_SUMS = Move("identity", "sum-of-angles")


def with_sums_expanded(scene: Scene, judge: Judge, number: int, link: Link) -> int:
    """The last line, with a sum of angles, by lines on the way: by a tangent a letter goes, and
    then the sum is written out.

    The line as it is where it rests on one line alone, or where there is no such way.
    """
    own = scene.desk.line(number)
    refs = numbers_in(own.premises)
    if own.move != _SUMS or len(refs) < 2 or number != len(scene.desk.lines):
        return number
    first, *others = refs
    scene.desk.lines.pop()
    mark = scene.desk.mark()
    for tie in others:
        gone = _gone(scene, first, tie, link)
        if gone is None:
            continue
        line = _by_the_tie(scene, judge, (first, tie), gone, link, own.premises)
        if line is not None:
            return line
        scene.desk.back(mark)
    return scene.desk.write(own.move, own.premises, chain(link.left, (link.right, None)))


def _gone(scene: Scene, first: int, tie: int, link: Link) -> tuple[sp.Symbol, sp.Expr] | None:
    """The letter that the tangent of an angle of the result tells, and its value by that."""
    match scene.desk.relation(tie).options:
        case ((Link(Apply("tan", Letter(name)), "=", _), *_),):
            pass
        case _:
            return None
    right = scene.scalar(scene.desk.last_link(tie).right)
    before = letters(scene.desk.last_link(first).right)
    names = [
        symbol
        for symbol in right.free_symbols
        if symbol.name in before and symbol.name not in letters(link.right)
    ]
    if len(names) != 1 or name not in letters(link.right):
        return None
    (symbol,) = names
    above, below = sp.fraction(one_fraction(right))
    tangent = sp.tan(sp.Symbol(name, positive=True))
    whole = polynomial_in(expanded(tangent * below - above), symbol)
    if whole.degree() != 1:
        return None
    return symbol, expanded(-whole.nth(0) / whole.nth(1))


def _by_the_tie(
    scene: Scene,
    judge: Judge,
    lines: tuple[int, int],
    gone: tuple[sp.Symbol, sp.Expr],
    link: Link,
    premises: tuple[Ref, ...],
) -> int | None:
    first, tie = lines
    symbol, value = gone
    known = [ref for ref in premises if isinstance(ref, str)]
    stated = chain(Letter(symbol.name), (tree_of(tidy(value)), None))
    pool = (tie, *known, *background(scene, symbol_names(value)))
    letter = judge.write((Move("rearrange"), Move("cancel")), pool, stated)
    if letter is None:
        return None
    whole = scene.scalar(scene.desk.last_link(first).right)
    put = sp.factor(one_fraction(in_sines(whole.subs(symbol, value))))
    above, below = sp.fraction(put)
    plain = _grouped(above) / below
    written = tree_of(plain, as_it_is=True)
    between = judge.write(
        (Move("put"),), (first, letter, *known), chain(link.left, (written, None))
    )
    if between is None:
        return None
    open_ = rebuilt(link.right, _written_out)
    if open_ != written:
        line = judge.write((Move("rearrange"),), (between, *known), chain(link.left, (open_, None)))
        between = between if line is None else line
    return judge.write((_SUMS,), (between, *known), chain(link.left, (link.right, None)))


def _grouped(above: sp.Expr) -> sp.Expr:
    """A product of sums with sines and cosines as one sum, with the other factors in front."""
    factors = sp.Mul.make_args(above)
    sums = [factor for factor in factors if factor.has(sp.sin, sp.cos)]
    rest = sp.Mul(*(factor for factor in factors if factor not in sums))
    whole = expanded(sp.Mul(*sums))
    return -rest * expanded(-whole) if rest.could_extract_minus_sign() else rest * whole


def _written_out(tree: Expression) -> Expression:
    """The sine, or the cosine, of a sum or a difference of two angles by theirs."""
    match tree:
        case Apply("sin" | "cos" as function, Binary("+" | "-" as sign, one, other)):
            pass
        case _:
            return tree
    sines, cosines = ([Apply(ratio, e) for e in (one, other)] for ratio in ("sin", "cos"))
    if function == "sin":
        terms = product(sines[0], cosines[1]), product(cosines[0], sines[1])
        return Binary("+" if sign == "+" else "-", *terms)
    terms = product(cosines[0], cosines[1]), product(sines[0], sines[1])
    return Binary("-" if sign == "+" else "+", *terms)


__all__ = ["with_sums_expanded"]
