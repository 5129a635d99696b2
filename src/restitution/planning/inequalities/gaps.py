"""A bound by what is left to it: the difference in factors, of which each has a certain sign."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.errors import StatementError
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Number,
    Quantity,
    has_quantity,
    is_function,
    walk,
)
from restitution.planning.angles.turn_lines import meeting
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.inequalities.bounded_gaps import (
    is_of_a_given_gap,
    of_both_squares,
    write_least,
)
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import ZERO, square, tree_of
from restitution.planning.writing.one_tangent import in_one_tangent
from restitution.planning.writing.polynomials import (
    derivative,
    expanded,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

_TO_FORM = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))


def is_plain(scene: Scene, line: int, relation: Relation) -> bool:
    """Whether a bound of what a line says is seen at once.

    It is where one is the other times factors with one letter each, and what holds a letter only
    grows with it, or only falls: each has its own bound. An angle is compared by its tangent.
    """
    whole = scene.desk.last_link(line)
    value = scene_value(scene, whole.right)
    known = roles(scene.problem)
    for link in relation.only:
        bound = _bound(link, whole.left)
        own: sp.Expr | None = None
        if bound is not None:
            own = scene_value(scene, bound[1])
        elif is_function(whole.left, "tan"):
            turn = _bound(link, whole.left.argument)
            own = None if turn is None else tidy(sp.tan(scene_value(scene, turn[1])))
        if own is None or own.has(sp.zoo):
            return True
        if value == 0 or own == 0:
            continue
        ratio = sp.factor(one_fraction(value / own))
        if any(known[s.name].kind == "positive" for s in ratio.free_symbols if s.name in known):
            return False
        if any(len(factor.free_symbols) > 1 for factor in sp.Mul.make_args(ratio)):
            return False
        if any(has_root(factor) for factor in sp.Mul.make_args(ratio)):
            return False
        if not all(_is_monotone(scene, ratio, symbol) for symbol in ratio.free_symbols):
            return False
    return True


def _is_monotone(scene: Scene, product: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether the factors with a letter together only grow with it, or only fall.

    It is asked only where several have it, or one is a polynomial with several powers of it.
    """
    own = [factor for factor in sp.Mul.make_args(product) if symbol in factor.free_symbols]
    if len(own) < 2 and not any(_has_powers(factor, symbol) for factor in own):
        return True
    slope = sp.factor(derivative(expanded(sp.Mul(*own)), symbol))
    return bool(proved_sign(scene.model.inside, slope))


def _has_powers(factor: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether a factor is a polynomial in a letter, with more than one of its powers."""
    if not factor.is_polynomial(symbol):
        return False
    return len([power for (power,) in polynomial_in(factor, symbol).monoms() if power]) > 1


def is_left(worths: Worths, tree: Expression, value: sp.Expr) -> bool:
    """Whether a value is what is left of a sum, or of its root, without one of the squares."""
    if is_function(tree, "sqrt"):
        tree, value = tree.argument, value**2
    for term in walk(tree):
        match term:
            case Binary("^", _, Number(Fraction(numerator=2))):
                rest = rebuilt(tree, lambda tree: ZERO if tree == term else tree)  # noqa: B023
                try:
                    left = worths.value(rest)
                except StatementError:  # the square stands below a bar
                    continue
                if tidy(left - value) == 0:
                    return True
    return False


def has_root(x: sp.Expr) -> bool:
    """Whether letters stand below a root."""
    return any(p.free_symbols and not p.exp.is_Integer for p in x.atoms(sp.Pow))


def _bound(link: Link, subject: Expression) -> tuple[Sign, Expression] | None:
    """How an inequality bounds a subject, and by what."""
    if link.left == subject:
        return link.sign, link.right
    if link.right == subject:
        return FLIPPED[link.sign], link.left
    return None


def write_difference(claims: Comparing, line: int, relation: Relation) -> int | None:
    """A bound by the difference to it, which is a product of factors of certain signs.

    Of a speed that is a root, by the difference of squares. None where there is no such product.
    """
    scene, worths = claims.scene, claims.worths
    whole = scene.desk.last_link(line)
    bound = _bound(relation.only[0], whole.left)
    if bound is None:
        return None
    by_a_square = _by_a_square(claims, line, relation)
    if by_a_square is not None:
        return by_a_square
    sign, other = bound
    value, most = (scene_value(scene, tree) for tree in (whole.right, other))
    mark = worths.mark()
    sides: list[Expression] = [other, whole.left]
    start: int | None = line
    if has_root(value) or has_root(most):
        start = _squared_line(claims, line)
        sides = [_squared(scene, other), square(whole.left)]
        value, most = value**2, most**2
    gap = most - value
    if sign[0] == ">":
        sides.reverse()
        gap = -gap
    known = worths.known_in(gap)
    both = of_both_squares(scene, gap)
    for form in (*(() if both is None else (both,)), *sorted(_forms(gap), key=_mixed)):
        if start is None or not _is_signed(scene, form):
            continue
        equation = equality(Binary("-", *sides), tree_of(form, as_it_is=form is both))
        difference = claims.judge.write(_TO_FORM, [start, *known], equation)
        if difference is None:
            continue
        strict: Sign = ">" if len(sign) == 1 else ">="
        least = write_least(claims, difference, tuple(_ranges(scene, form)), strict)
        last = None if least is None else claims.compared([difference, least], relation)
        last = last or claims.compared([difference], relation)
        if last is None:
            pool = [difference, *_ranges(scene, form)]
            last = claims.judge.write((Move("sign"),), pool, relation)
        if last is None:
            with claims.judge.ranges_as_one():
                last = claims.compared([difference], relation)
        if last is not None:
            return last
    worths.back(mark)
    return None


def _by_a_square(claims: Comparing, line: int, relation: Relation) -> int | None:
    """The least value of a speed by its components, of which one may come to nothing.

    None of a bound that is not the square of the other one.
    """
    scene, desk = claims.scene, claims.scene.desk
    first, *further = desk.relation(line).only
    bound = _bound(relation.only[0], first.left) if len(relation.only) == 1 else None
    if not further or bound is None or bound[0][0] != ">" or not is_function(first.right, "sqrt"):
        return None
    if not is_left(claims.worths, first.right, scene_value(scene, bound[1])):
        return None
    mark = claims.worths.mark()
    equation = equality(square(first.left), first.right.argument)
    squared = claims.judge.write((Move("rearrange"),), [line], equation)
    last = None if squared is None else claims.judge.write((Move("sign"),), [squared], relation)
    if last is None:
        claims.worths.back(mark)
    return last


def write_given_gap(claims: Comparing, line: int, relation: Relation) -> int | None:
    """A bound by the difference to it, of which an inequality between letters is a factor.

    None of any other bound: what only grows with one letter is compared at its ends.
    """
    whole = claims.scene.desk.last_link(line)
    bound = None if len(relation.only) > 1 else _bound(relation.only[0], whole.left)
    if bound is None or has_quantity(bound[1]):
        return None
    value, most = (scene_value(claims.scene, tree) for tree in (whole.right, bound[1]))
    if has_root(value) or has_root(most) or not is_of_a_given_gap(claims.scene, most - value):
        return None
    return write_difference(claims, line, relation)


def _ranges(scene: Scene, x: sp.Expr) -> Iterator[Ref]:
    """What may be cited of letters, both ends of a coefficient of restitution as one range."""
    known = roles(scene.problem)
    for name in sorted(symbol.name for symbol in x.free_symbols if symbol.name in known):
        role = known[name]
        if role.kind == "restitution" and (role.low, role.high, *role.closed) == (0, 1, True, True):
            yield f"0 <= {name} <= 1"
        else:
            yield from scene.judge.known([name])


def _squared_line(claims: Comparing, line: int) -> int | None:
    """The line of the square of a speed, or of a tangent that is a root; None of anything else."""
    whole = claims.scene.desk.last_link(line)
    match whole.left:
        case Quantity("speed"):
            return claims.worths.squared(whole.left)
        case Apply("tan"):
            worth = _squared(claims.scene, whole.right)
            relation = equality(square(whole.left), worth)
            positive = Relation(((Link(whole.left, ">", ZERO),),))
            signed = claims.compared([line, *meeting(claims.scene)], positive)
            if signed is None:
                return None
            return claims.judge.write((Move("rearrange"),), [line, signed], relation)
    return None


def _squared(scene: Scene, tree: Expression) -> Expression:
    return tree_of(sp.powdenest(sp.expand_power_base(scene_value(scene, tree) ** 2)))


def _forms(gap: sp.Expr) -> Iterator[sp.Expr]:
    """A difference in factors, as it is, with sines or cosines alone, or with one tangent."""
    whole = one_fraction(gap)
    angles = sorted({f.args[0] for f in whole.atoms(sp.sin, sp.cos)}, key=str)
    forms = [whole]
    for angle in angles:
        forms += [
            expanded(form).subs(kind(angle) ** 2, 1 - other(angle) ** 2)
            for form in list(forms)
            for kind, other in ((sp.sin, sp.cos), (sp.cos, sp.sin))
        ]
    for form in forms:
        own = _factored(form)
        for angle in angles:
            own = own.replace(
                lambda x: x.is_Add and expanded(x - (1 - sp.sin(angle) ** 2)) == 0,  # noqa: B023
                lambda x: sp.cos(angle) ** 2,  # noqa: B023
            )
        yield own
    by_tangent = in_one_tangent(whole)
    if by_tangent is not None:
        yield _factored(by_tangent)


def _factored(form: sp.Expr) -> sp.Expr:
    """A form in factors, over the roots that stand in it."""
    roots = {x for x in form.atoms(sp.Pow) if x.is_number and not x.exp.is_Integer}
    return sp.factor(form, extension=sorted(roots, key=str)) if roots else sp.factor(form)


def _mixed(x: sp.Expr) -> tuple[int, int]:
    """How many letters stand together in a factor, and how long the whole is."""
    return max(len(factor.free_symbols) for factor in sp.Mul.make_args(x)), sp.count_ops(x)


def _is_signed(scene: Scene, x: sp.Expr) -> bool:
    """Whether each factor has a certain sign, or may be zero at an end of a letter."""
    above, below = sp.fraction(x)
    known = roles(scene.problem)
    for factor in (*sp.Mul.make_args(above), *sp.Mul.make_args(below)):
        if len(symbol_names(factor) & set(known)) < len(factor.free_symbols):
            return False
        base, power = factor.as_base_exp()
        if power.is_Integer and power % 2 == 0:
            continue
        if proved_sign(scene.model.inside, base) is None and not is_of_a_given_gap(scene, base):
            return False
    return True
