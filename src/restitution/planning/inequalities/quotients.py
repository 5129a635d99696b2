"""``c t/(a + d t + b t²)``: divided by t, and a/t + b t as a square and what is left."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation, equality
from restitution.expression.tree import Apply, Binary, Expression, Letter
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.inequalities.over_offsets import role_of
from restitution.planning.writing.forms import product, square, total, tree_of
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
    role = role_of(scene, symbol)
    t = sp.Dummy("t", positive=True)
    value = scene_value(scene, scene.desk.last_link(line).right)
    known_letters = {*roles(scene.problem), symbol.name}
    names = sorted(s.name for s in value.free_symbols if s.name in known_letters)
    x = by_tangent(value, symbol, t) if role.kind == "angle" else value.subs(symbol, t)
    above, below = sp.fraction(sp.factor(sp.together(x)))
    try:
        top, poly = (sp.Poly(sp.expand(value), t) for value in (above, below))
    except sp.PolynomialError:
        return None
    if end.sign[0] != "<" or stated not in ("=", "<="):
        return None
    if top.monoms() != [(1,)] or poly.degree() != 2:
        return None
    a, d, b = (tidy(sp.factor(poly.nth(n))) for n in (0, 1, 2))
    if a == 0:
        return None
    c = tidy(top.nth(1))
    common = sp.gcd(sp.gcd(a, b), sp.gcd(c, d)) if all(e.is_Rational for e in (a, b)) else 1
    a, b, c, d = (tidy(value / common) for value in (a, b, c, d))
    if scene.model.sign(a) < 0:
        a, b, c, d = (tidy(-value) for value in (a, b, c, d))
    lettered = bool(a.free_symbols | b.free_symbols)
    share: sp.Expr = sp.Integer(1)
    if lettered:
        share = _number_in_common(a, b, d)
        a, b, d = (tidy(value / share) for value in (a, b, d))
        above, share = sp.fraction(c / share)
        c = tidy(above)
    letter: Expression = Letter(symbol.name)
    own: Expression = Apply("tan", letter) if role.kind == "angle" else letter
    terms = [Binary("/", tree_of(a), own), product(tree_of(b), own)]
    if d != 0:
        terms.append(tree_of(d))
    known = judge.known([*names, symbol.name])
    whole = total(terms)

    def shared(tree: Expression) -> Expression:
        return tree if share == 1 else product(tree_of(share), tree)

    divided = judge.write(
        (Move("rearrange"),),
        [line, *known],
        Relation(((Link(end.left, stated, Binary("/", tree_of(c), shared(whole))),),)),
    )
    name = _letter_for(scene, whole)
    let = scene.desk.write(Move("let"), (), Meaning(name, whole))
    by_letter = Binary("/", tree_of(c), shared(Letter(name)))
    by_name = Relation(((Link(end.left, stated, by_letter),),))
    above = line if divided is None else divided
    quotient = judge.write((Move("put"),), [above, let, *known], by_name)
    if quotient is None:
        return None
    front = _common(a, b)
    roots = [tree_of(tidy(sp.sqrt(value / front))) for value in (a, b)]
    gap = product(tree_of(front), square(Binary("-", roots[0], product(roots[1], own))))
    rest = tree_of(tidy(2 * sp.sqrt(a) * sp.sqrt(b) + d))
    if a.free_symbols and b.free_symbols:
        # A root of a product is not that of its factors: both are as in the square.
        rest = total((product(tree_of(2), *roots), tree_of(d)))
    squared = equality(Letter(name), total((Binary("/", gap, own), rest)))
    texts = [ref for ref in known if ref not in scene.facts]
    complete = judge.write((Move("complete"),), [let, *texts], squared)
    if complete is None:
        return None
    least = Relation(((Link(Letter(name), ">=", rest),),))
    bound = judge.write((Move("sign"),), [complete, *known], least)
    if bound is None:
        return None
    if a.free_symbols and b.free_symbols and not printed:
        end = Link(end.left, end.sign, Binary("/", tree_of(c), shared(rest)))
    most = tidy(c / (share * (2 * sp.sqrt(a) * sp.sqrt(b) + d)))
    base = [quotient, bound]
    if end.sign == "<" and most.is_number:
        greatest = Relation(((Link(end.left, "<=", tree_of(most)),),))
        first = judge.write((Move("compare"),), [*base, *known], greatest)
        base = base if first is None else [first]
    with judge.ranges_as_one():
        last = judge.write((Move("compare"),), [*base, *known], Relation(((end,),)))
    if last is None:
        return None
    plain = tree_of(tidy(sp.sqrt(a / b))) if b.is_number else Binary("/", *roots)
    place = Link(own, "=", plain) if lettered else None
    return Bound(last, (quotient, bound), place, end.right)


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
    return sp.together(x.xreplace(dict(put)))
