"""``c t/(a + d t + b t²)``: divided by t, and a/t + b t as a square and what is left."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.expression.tree import Apply, Binary, Expression, Letter
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.inequalities.over_offsets import role_of
from restitution.planning.writing.forms import product, square, total, tree_of
from restitution.planning.writing.polynomials import expanded, one_fraction, polynomial_in
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass
from restitution.solving.story.letters import roles


@dataclass(frozen=True)
class Bound:
    """The line of a bound, the lines on which it rests, where it is reached, and the bound."""

    line: int
    support: tuple[Ref, ...]
    place: Link | None
    right: Expression


def write_quotient(
    claims: Comparing, line: int, symbol: sp.Symbol, end: Link, printed: bool = False
) -> Bound | None:
    """The greatest value of a quotient over a letter, or over the tangent of an angle.

    ``line`` says what the left side of ``end`` is, or what it is at most; None where that is no
    such quotient. A bound that is ``printed`` keeps its form.
    """
    scene, judge = claims.scene, claims.judge
    stated = scene.desk.last_link(line).sign
    value = scene_value(scene, scene.desk.last_link(line).right)
    if end.sign[0] != "<" or stated not in ("=", "<="):
        return None
    parts = _parts_of(claims, symbol, value)
    if parts is None or any(map(_is_negative, (parts.a, parts.b))):
        return None
    known_letters = {*roles(scene.problem), symbol.name}
    names = sorted(s.name for s in value.free_symbols if s.name in known_letters)
    known = judge.known([*names, symbol.name])
    named = _write_by_name(claims, line, parts, (end.left, stated), known)
    if named is None:
        return None
    quotient, name, let = named
    bound = _write_square(claims, parts, Letter(name), let, known)
    if bound is None:
        return None
    if parts.has_letters_in_both and not printed:
        end = Link(end.left, end.sign, Binary("/", tree_of(parts.c), parts.shared(parts.rest())))
    base = [quotient, bound]
    most = tidy(parts.c / (parts.share * (2 * sp.sqrt(parts.a) * sp.sqrt(parts.b) + parts.d)))
    if end.sign == "<" and most.is_number:
        greatest = Relation(((Link(end.left, "<=", tree_of(most)),),))
        first = judge.write((Move("compare"),), [*base, *known], greatest)
        base = base if first is None else [first]
    with judge.ranges_as_one():
        last = judge.write((Move("compare"),), [*base, *known], Relation(((end,),)))
    if last is None:
        return None
    ratio = tidy(sp.sqrt(parts.a / parts.b))
    plain = tree_of(ratio) if parts.b.is_number else Binary("/", *parts.roots())
    place = Link(parts.own, "=", plain) if parts.has_letters else None
    return Bound(last, (quotient, bound), place, end.right)


class _Parts(NamedTuple):
    """A quotient c/(k(a/x + bx + d)) with a > 0, where x is a letter or a tangent."""

    own: Expression
    a: sp.Expr
    b: sp.Expr
    c: sp.Expr
    d: sp.Expr
    share: sp.Expr

    @property
    def has_letters(self) -> bool:
        """Whether the terms that grow and fall have letters."""
        return bool(self.a.free_symbols | self.b.free_symbols)

    @property
    def has_letters_in_both(self) -> bool:
        """Whether both terms have letters: a root of their product is not shown as that."""
        return bool(self.a.free_symbols and self.b.free_symbols)

    def shared(self, tree: Expression) -> Expression:
        """What stands below, with the number that its terms have in common."""
        return tree if self.share == 1 else product(tree_of(self.share), tree)

    def below(self) -> Expression:
        """The sum a/x + bx + d."""
        terms = [Binary("/", tree_of(self.a), self.own), product(tree_of(self.b), self.own)]
        return total([*terms, tree_of(self.d)] if self.d != 0 else terms)

    def roots(self) -> list[Expression]:
        """The roots of a and b, without what is common to these."""
        front = _common(self.a, self.b)
        return [tree_of(tidy(sp.sqrt(value / front))) for value in (self.a, self.b)]

    def rest(self) -> Expression:
        """The least value of the sum, 2√(ab) + d."""
        # a/x + bx = (√a − x√b)²/x + 2√(ab), and the square is least where it is 0.
        if self.has_letters_in_both:
            # A root of a product is not that of its factors: both are as in the square.
            return total((product(tree_of(2), *self.roots()), tree_of(self.d)))
        return tree_of(tidy(2 * sp.sqrt(self.a) * sp.sqrt(self.b) + self.d))


def _parts_of(claims: Comparing, symbol: sp.Symbol, value: sp.Expr) -> _Parts | None:
    """The parts of a quotient in a letter; None of what is none."""
    scene = claims.scene
    is_angle = role_of(scene, symbol).kind == "angle"
    t = sp.Dummy("t", positive=True)
    x = by_tangent(value, symbol, t) if is_angle else value.subs(symbol, t)
    above, below = sp.fraction(sp.factor(one_fraction(x)))
    try:
        top, poly = (polynomial_in(expanded(side), t) for side in (above, below))
    except sp.PolynomialError:
        return None
    if top.monoms() != [(1,)] or poly.degree() != 2:
        return None
    a, d, b = (tidy(sp.factor(poly.nth(n))) for n in (0, 1, 2))
    if a == 0:
        return None
    c = tidy(top.nth(1))
    common = sp.gcd(sp.gcd(a, b), sp.gcd(c, d)) if all(e.is_Rational for e in (a, b)) else 1
    a, b, c, d = (tidy(term / common) for term in (a, b, c, d))
    if scene.model.sign(a) < 0:
        a, b, c, d = (tidy(-term) for term in (a, b, c, d))
    share: sp.Expr = sp.Integer(1)
    # So 4(1 + k)² below has its 4 in front of 1/k + k + 2.
    if a.free_symbols | b.free_symbols or (a == b and d != 0):
        share = _number_in_common(a, b, d)
        a, b, d = (tidy(term / share) for term in (a, b, d))
        above, share = sp.fraction(c / share)
        c = tidy(above)
    letter: Expression = Letter(symbol.name)
    return _Parts(Apply("tan", letter) if is_angle else letter, a, b, c, d, share)


def _write_by_name(
    claims: Comparing,
    line: int,
    parts: _Parts,
    stated: tuple[Expression, Sign],
    known: Sequence[Ref],
) -> tuple[int, str, int] | None:
    """The quotient by a letter for what is below: its line, the letter, and what introduces it."""
    scene, judge = claims.scene, claims.judge
    (left, sign), whole = stated, parts.below()
    divided = judge.write(
        (Move("rearrange"),),
        [line, *known],
        Relation(((Link(left, sign, Binary("/", tree_of(parts.c), parts.shared(whole))),),)),
    )
    name = _letter_for(scene, whole)
    let = scene.desk.write(Move("let"), (), Meaning(name, whole))
    by_letter = Binary("/", tree_of(parts.c), parts.shared(Letter(name)))
    by_name = Relation(((Link(left, sign, by_letter),),))
    above = line if divided is None else divided
    quotient = judge.write((Move("put"),), [above, let, *known], by_name)
    return None if quotient is None else (quotient, name, let)


def _is_negative(value: sp.Expr) -> bool:
    """Whether a coefficient is below zero where its letters are above it: it has no root."""
    positive = {x: sp.Symbol(x.name, positive=True) for x in value.free_symbols}
    return bool(sp.sympify(value, strict=True).xreplace(positive).is_negative)


def _write_square(
    claims: Comparing, parts: _Parts, letter: Letter, let: int, known: Sequence[Ref]
) -> int | None:
    """The bound of what is below, as a square and what is left."""
    judge = claims.judge
    one, other = parts.roots()
    front = tree_of(_common(parts.a, parts.b))
    gap = product(front, square(Binary("-", one, product(other, parts.own))))
    squared = equality(letter, total((Binary("/", gap, parts.own), parts.rest())))
    texts = [ref for ref in known if ref not in claims.scene.facts]
    complete = judge.write((Move("complete"),), [let, *texts], squared)
    if complete is None:
        return None
    least = Relation(((Link(letter, ">=", parts.rest()),),))
    return judge.write((Move("sign"),), [complete, *known], least)


def _number_in_common(*terms: sp.Expr) -> sp.Expr:
    """The largest number that divides all terms; 1 where one of them has no rational factor."""
    numbers = [sp.factor(term).as_coeff_Mul()[0] for term in terms if term != 0]
    if not all(number.is_Rational for number in numbers):
        return sp.Integer(1)
    return sp.Abs(sp.gcd_list(numbers))


def _common(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    """What stands before the square: 8(1 − k)² for 8 and 8, and not (2√2 − 2√2 k)²."""
    if not (a.is_Rational and b.is_Rational) or (sp.sqrt(a).is_Rational and sp.sqrt(b).is_Rational):
        return sp.Integer(1)
    both = sp.gcd(a, b)
    plain = all(sp.sqrt(value / both).is_Rational for value in (a, b))
    return both if plain else sp.Integer(1)


def _letter_for(scene: Scene, tree: Expression) -> str:
    """The letter that stands for a tree already, or a free one."""
    for line in scene.desk.lines:
        if isinstance(line.relation, Meaning) and line.relation.quantity == tree:
            return line.relation.letter
    taken = set(roles(scene.problem)) | {
        line.relation.letter for line in scene.desk.lines if isinstance(line.relation, Meaning)
    }
    names = {sphere.name for sphere in scene.problem.spheres}
    names |= {wall.name for wall in scene.problem.walls}
    return next(letter for letter in "SQNKHFG" if letter not in taken | names)


def by_tangent(x: sp.Expr, angle: sp.Symbol, t: sp.Symbol) -> sp.Expr:
    """An expression of the second degree in sine and cosine of an angle by its tangent."""
    put: Mapping[sp.Basic, sp.Expr] = {
        sp.sin(angle): t / sp.sqrt(1 + t**2),
        sp.cos(angle): 1 / sp.sqrt(1 + t**2),
        sp.tan(angle): t,
    }
    return one_fraction(x.xreplace(dict(put)))
