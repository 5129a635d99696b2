"""Whether a reader sees that an expression only grows, or only falls, with a letter.

That is seen where every place of the letter works in one sense: of (1 + e)/(2 − e) both do, of
3k/(4 + k) they work against each other. Then another form of the same may show it, or else its
derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import in_one_ratio, tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Letter, has_quantity
from restitution.oracle import REAL, BeyondError, Formula, Oracle, Role, compared
from restitution.planning.writing.forms import tree_of
from restitution.records import dataclass
from restitution.render import layout as lay

_MOST = 24


@dataclass(frozen=True)
class Shown:
    """What shows how an expression goes: the expression itself, a form of it, or a derivative."""

    value: sp.Expr
    form: sp.Expr | None = None
    derivative: sp.Expr | None = None


def shown(
    tree: Expression, name: str, sense: int, ends: Sequence[Link], roles: Mapping[str, Role]
) -> Shown | None:
    """What shows that a tree grows (1) or falls (-1) with a letter; None where nothing does.

    ``ends`` are what is cited of letters.
    """
    try:
        value, facts = _read(tree, roles), list(_facts(ends, roles))
    except (RestitutionError, TypeError, ValueError):
        return None
    if has_quantity(tree) or not isinstance(value, sp.Expr):
        return None
    symbol = roles.get(name, REAL).symbol(name)
    sight = _Sight(symbol, roles.get(name, REAL).kind == "angle", Oracle(roles).with_facts(facts))
    if sight.sense(value) == sense:
        return Shown(value)
    core = sight.core(value)
    for form in map(sight.oriented, _forms(core, symbol)):
        if sight.sense(form) == sense:
            return Shown(core, form)
    derivative = sp.factor(sp.together(tidy(sp.diff(core, symbol))))
    has_values = sight.sign(sp.fraction(sp.together(core))[1]) is not None
    if has_values and sight.sign(derivative) == sense and sp.count_ops(derivative) < _MOST:
        return Shown(core, derivative=derivative)
    return None


def growth_said(
    tree: Expression,
    name: str,
    sense: int,
    ends: Sequence[Link],
    roles: Mapping[str, Role],
    layout: Callable[[Expression], lay.Layout],
) -> tuple[Sentence, bool]:
    """That a tree grows (1), or falls (-1), with a letter, by what shows that.

    Beside it whether that is said of the tree itself, and of no part of it.
    """
    quantity, letter = layout(tree), layout(Letter(name))
    own = shown(tree, name, sense, ends, roles)
    if own is not None and own.derivative is not None:
        quantity, slope = (layout(tree_of(value)) for value in (own.value, own.derivative))
        relation = lay.Relation((slope, lay.Number("0")), (">" if sense > 0 else "<",))
        return say("derived.slope", quantity=quantity, letter=letter, slope=relation), False
    if own is not None and own.form is not None:
        sides = layout(tree_of(own.value)), layout(tree_of(own.form, as_it_is=True))
        quantity = lay.Relation(sides, ("=",)) if sides[0] != sides[1] else sides[0]
    id_ = "derived.increases" if sense > 0 else "derived.decreases"
    return say(id_, quantity=quantity, letter=letter), own is None or own.form is None


def less_than_its_limit(
    tree: Expression, name: str, sense: int, ends: Sequence[Link], roles: Mapping[str, Role]
) -> Relation | None:
    """That a tree is a number less something, where it grows to that number without limit.

    None where no form of it shows that.
    """
    own = shown(tree, name, sense, ends, roles)
    if own is None or own.form is None or sense < 0:
        return None
    symbol = roles.get(name, REAL).symbol(name)
    most, rest = own.form.as_independent(symbol, as_Add=True)
    if most.free_symbols or not rest.is_rational_function(symbol) or rest.is_Add:
        return None
    above, below = sp.fraction(sp.together(rest))
    if sp.degree(above, symbol) >= sp.degree(below, symbol):
        return None
    form = tree_of(own.form, as_it_is=True)
    return Relation(((Link(tree_of(own.value), "=", form), Link(form, "<", tree_of(most))),))


def _read(tree: Expression, roles: Mapping[str, Role]) -> sp.Expr:
    value = sp.sympify(evaluate(tree, lambda n: roles.get(n, REAL).symbol(n)), strict=True)
    return value.replace(sp.Mul, _under_one_root) if isinstance(value, sp.Expr) else value


def _under_one_root(*factors: sp.Expr) -> sp.Expr:
    """√(4a² − d²) for √(2a − d) √(2a + d), as it is printed."""
    roots = [factor for factor in factors if factor.is_Pow and factor.exp == sp.Rational(1, 2)]
    sums = [root for root in roots if root.base.is_Add]
    if len(sums) < 2:
        return sp.Mul(*factors)
    rest = [factor for factor in factors if factor not in sums]
    return sp.Mul(*rest, sp.sqrt(sp.expand(sp.Mul(*(addend.base for addend in sums)))))


def _facts(ends: Sequence[Link], roles: Mapping[str, Role]) -> Iterator[Formula]:
    for end in ends:
        if end.sign in FLIPPED and not any(map(has_quantity, (end.left, end.right))):
            yield compared(_read(end.left, roles), end.sign, _read(end.right, roles))


def _forms(value: sp.Expr, symbol: sp.Symbol) -> Iterator[sp.Expr]:
    """Other forms of an expression, in which a letter may work in one sense."""
    cosine, sine = sp.cos(symbol), sp.sin(symbol)
    if value.has(cosine) and value.has(sine):
        for one, other in ((cosine, sine), (sine, cosine)):
            poly = in_one_ratio(value, other, one)
            yield sp.Add(*(sp.factor(c) * other**n for (n,), c in _terms(poly, other)))
    elif value.is_rational_function(symbol):
        whole = sp.apart(sp.together(value), symbol)
        if whole.is_Add:
            yield whole
    squares = {
        other: _square(other, symbol)
        for other in (node.base for node in value.atoms(sp.Pow))
        if other.is_polynomial(symbol) and sp.degree(other, symbol) == 2
    }
    if squares:
        yield value.xreplace(squares)
    if value.is_polynomial(symbol) and sp.degree(value, symbol) == 2:
        yield _square(value, symbol)


def _terms(value: sp.Expr, ratio: sp.Expr) -> list[tuple[tuple[int, ...], sp.Expr]]:
    if not value.is_polynomial(ratio):
        return []
    return list(sp.Poly(value, ratio).terms())


def _square(quadratic: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """A quadratic with its square completed."""
    a, b, c = sp.Poly(quadratic, symbol).all_coeffs()
    root, size = symbol + b / (2 * a), sp.sqrt(a)
    if size.is_Rational and size != 1:
        a, root = sp.Integer(1), size * symbol + b / (2 * size)
        c, b = c - b**2 / (4 * size**2), sp.Integer(0)
        if root.subs(symbol, 0).is_positive:
            return root**2 + sp.factor(c)
        return (-root) ** 2 + sp.factor(c)
    if b.is_negative:
        root = -root
    return a * root**2 + sp.factor(c - b**2 / (4 * a))


@dataclass(frozen=True)
class _Sight:
    """What is seen of expressions in one letter, an angle perhaps, under what is known."""

    symbol: sp.Symbol
    angle: bool
    oracle: Oracle

    def sign(self, x: sp.Expr) -> int | None:
        """The sign of an expression, which may be zero besides; None where it is open."""
        for sign in (1, -1):
            if (sign * x).is_nonnegative:
                return sign
            claim = compared(sign * x, ">=", sp.Integer(0))
            for oracle in (Oracle(self.oracle.roles), self.oracle):
                with suppress(BeyondError):
                    if oracle.proves(claim):
                        return sign
        return None

    def core(self, x: sp.Expr) -> sp.Expr:
        """The factor that has the letter; of a root, what stands under it."""
        factor, own = sp.factor_terms(x).as_independent(self.symbol, as_Add=False)
        if self.sign(factor) != 1:
            return x
        if own.is_Pow and own.exp == sp.Rational(1, 2):
            return self.core(own.base)
        return own

    def oriented(self, x: sp.Expr) -> sp.Expr:
        """A sum whose terms have factors that are not negative, as far as that is known."""
        terms = []
        for term in sp.Add.make_args(x):
            sign, factors = 1, []
            for factor in sp.Mul.make_args(term):
                base, power = factor.as_base_exp()
                negative = base.is_Add and power.is_Integer and self.sign(base) == -1
                sign *= (-1) ** int(power) if negative else 1
                factors.append((-base) ** power if negative else factor)
            # The sign goes to the numbers first: SymPy multiplies a single sum by it.
            terms.append(sp.Mul(*factors) if sign == 1 else sp.Mul(*_negated(factors)))
        return sp.Add(*terms)

    def sense(self, x: sp.Expr) -> int | None:
        """1 where an expression is seen to grow, -1 to fall, 0 without the letter, else None."""
        if self.symbol not in x.free_symbols:
            return 0
        if x == self.symbol:
            return 1
        if x.is_Add:
            return _together([self.sense(argument) for argument in x.args])
        if x.is_Mul:
            return self._of_product(x)
        if x.is_Pow and x.exp.is_Rational:
            own = self.sense(x.base)
            sign = 1 if own is None or x.exp.q == 2 else self.sign(x.base)
            if own is None or (sign is None and x.exp != 1):
                return None
            turned = own if x.exp > 0 else -own
            return turned * (sign or 1) if x.exp.is_even else turned
        if isinstance(x, sp.atan):
            return self.sense(x.args[0])
        if isinstance(x, (sp.sin, sp.cos, sp.tan)) and self.angle:
            acute = self.sign(sp.cos(self.symbol)) == 1 == self.sign(sp.sin(self.symbol))
            if acute and x.args[0] == self.symbol:
                return -1 if isinstance(x, sp.cos) else 1
        return None

    def _of_product(self, x: sp.Expr) -> int | None:
        factor, own = x.as_independent(self.symbol, as_Add=False)
        factors = sp.Mul.make_args(own)
        sign, senses = self.sign(factor), [self.sense(factor) for factor in factors]
        if sign is None or None in senses:
            return None
        if len(factors) == 1:
            return sign * (senses[0] or 0)
        signs = [self.sign(factor) for factor in factors]
        if None in signs:
            return None
        sizes = [sense * own for sense, own in zip(senses, signs, strict=True)]  # type: ignore[operator]
        whole = _together(sizes)
        return None if whole is None else sign * int(sp.prod(signs)) * whole


def _negated(factors: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Factors of the opposite of a product."""
    numbers = [factor for factor in factors if factor.is_Number]
    return [-sp.Mul(*numbers), *(factor for factor in factors if not factor.is_Number)]


def _together(senses: Sequence[int | None]) -> int | None:
    """The sense of a sum, by those of its terms."""
    if None in senses:
        return None
    own = {sense for sense in senses if sense}
    return None if len(own) > 1 else next(iter(own), 0)


__all__ = ["Shown", "growth_said", "less_than_its_limit", "shown"]
