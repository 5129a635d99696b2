"""Equations made polynomial: trigonometry, roots and bars cleared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.oracle import Oracle, compared
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra.cosines import gathered, has_cosines
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.numbers import vanishes
from restitution.solving.algebra.polynomials import afford, coefficients, numerator, terms_in
from restitution.solving.algebra.signs import definite, rational_below, vanishing
from restitution.work import remembered


@dataclass(frozen=True)
class Known:
    """What is known of the letters: their ranges, and sines and cosines that are positive."""

    roles: Mapping[str, Role]
    positive: frozenset[sp.Expr]

    def zero(self, x: sp.Expr) -> bool:
        """Whether an expression vanishes whatever its letters are."""
        decided = vanishing(x)
        return vanishes(x, self.roles) if decided is None else decided

    def nonzero(self, x: sp.Expr) -> bool:
        """Whether an expression is seen never to vanish."""
        return definite(x, self.positive) != 0


def without_bars(x: sp.Expr, known: Known) -> sp.Expr:
    """|w| is w or −w where what is known of the letters tells which."""
    signs = {bar: definite(bar.args[0], known.positive) for bar in x.atoms(sp.Abs)}
    return x.xreplace({bar: bar.args[0] * own for bar, own in signs.items() if own})


def in_range(angle: sp.Expr, role: Role) -> sp.Expr:
    """The same direction, where more than 180° are allowed, a turn further on if need be."""
    wide = role.low is not None and role.high is not None and bool(role.high > sp.pi)
    if wide and angle.is_number and bool(angle < role.low):
        return angle + 2 * sp.pi
    return angle


def angle_of(c: sp.Expr, s: sp.Expr, roles: Mapping[str, Role]) -> sp.Expr:
    """The angle of a cosine and a sine, from −180° to 180°."""
    if vanishing(c):
        return sp.pi / 2 if definite(s) >= 0 else -sp.pi / 2
    if c.is_number and s.is_number:
        return sp.atan2(rational_below(s), rational_below(c))
    if definite(c) > 0 or Oracle(roles).proves(compared(c, ">=", sp.Integer(0))):
        return sp.atan(neat(s / c))
    return sp.atan2(s, c)


def least_denominator(equations: Sequence[sp.Expr], symbol: sp.Symbol) -> int:
    """The least q such that every sine and cosine is of a whole multiple of symbol/q."""
    q = 1
    for equation in equations:
        for node in equation.atoms(sp.sin, sp.cos, sp.tan, sp.cot):
            coefficient = sp.expand(node.args[0]).coeff(symbol)
            if coefficient.is_Rational and coefficient != 0:
                q = int(sp.ilcm(q, coefficient.q))
    return q


def trig_in(x: sp.Expr, symbol: sp.Symbol, base: sp.Expr, c: sp.Symbol, s: sp.Symbol) -> sp.Expr:
    """Sines and cosines of multiples of ``base`` as polynomials in its cosine and sine."""
    mapping = {}
    for node in x.atoms(sp.sin, sp.cos):
        argument = sp.expand(node.args[0])
        if not argument.has(symbol):
            continue
        n = argument.coeff(symbol) * symbol / base
        rest = argument - n * base
        n = sp.nsimplify(n)
        if not n.is_Integer or abs(n) > 12 or rest.has(symbol):
            raise UnsupportedError(f"{node} cannot be solved for {symbol.name}")
        cn, sn = sp.Integer(1), sp.Integer(0)
        for _ in range(abs(int(n))):
            cn, sn = sp.expand(cn * c - sn * s), sp.expand(sn * c + cn * s)
        if n < 0:
            sn = -sn
        cr, sr = sp.cos(rest), sp.sin(rest)
        mapping[node] = cn * cr - sn * sr if node.func is sp.cos else sn * cr + cn * sr
    return x.xreplace(mapping)


def polynomial_of(x: sp.Expr, unknowns: set[sp.Symbol]) -> sp.Expr:
    """A polynomial that vanishes where an equation holds: a product, where that is known."""
    return _polynomial_of(x, frozenset(unknowns))


@remembered(1024)
def _polynomial_of(x: sp.Expr, unknowns: frozenset[sp.Symbol]) -> sp.Expr:
    return sp.Mul(*[gathered(numerator(value)) for value in _rational(x, unknowns)])


def _rational(x: sp.Expr, unknowns: AbstractSet[sp.Symbol], depth: int = 6) -> list[sp.Expr]:
    """The factors of an equation freed of roots and sizes of expressions in the unknowns.

    A root is squared away. The size of w is w or −w, which gives two factors of half the degree.
    """
    x = sp.sympify(x, strict=True)
    radicals = sorted(
        (
            node
            for node in sp.preorder_traversal(x)
            if (
                (node.is_Pow and node.exp.is_Rational and not node.exp.is_Integer)
                or isinstance(node, sp.Abs)
            )
            and node.free_symbols & unknowns
        ),
        key=lambda node: (-sp.count_ops(node), sp.default_sort_key(node)),
    )
    if not radicals:
        return [x]
    if depth == 0:
        raise UnsupportedError("too many roots of what is sought in one equation")
    chosen = radicals[0]
    if isinstance(chosen, sp.Abs):
        base, square = chosen, chosen.args[0] ** 2
    elif chosen.exp.q == 2:
        base, square = sp.sqrt(chosen.base), chosen.base
    else:
        raise UnsupportedError("a root other than a square root of what is sought")
    mark = sp.Dummy("root", nonnegative=True)
    replaced = x.replace(
        lambda n, b=base: (
            n == b
            or (
                n.is_Pow
                and b.is_Pow
                and n.base == b.base
                and n.exp.is_Rational
                and not n.exp.is_Integer
            )
        ),
        lambda n, b=base, mark=mark: mark if n == b else mark ** (n.exp / b.exp),
    )
    even = odd = sp.Integer(0)
    parts = coefficients(numerator(replaced), mark)
    for power, coefficient in enumerate(reversed(parts)):
        if power % 2:
            odd += coefficient * square ** ((power - 1) // 2)
        else:
            even += coefficient * square ** (power // 2)
    if odd == 0:
        rational = [even]
    elif even == 0:
        rational = [odd, square]
    elif isinstance(chosen, sp.Abs):
        inside = chosen.args[0]
        rational = [even - odd * inside, even + odd * inside]
        whole = numerator(sp.Mul(*rational))
        conjugate = _has_radicals(rational[0]) and not _has_radicals(whole)
        if conjugate and not has_cosines(whole):
            rational = [whole]  # conjugates of each other, which are solved as one
    else:
        afford(sp.count_ops(even) ** 2 + sp.count_ops(odd) ** 2 * sp.count_ops(square))
        rational = [even**2 - odd**2 * square]
    return [part for value in rational for part in _rational(value, unknowns, depth - 1)]


def _has_radicals(x: sp.Expr) -> bool:
    return any(atom.is_number and not atom.exp.is_Integer for atom in x.atoms(sp.Pow))


def by_tangent(x: sp.Expr, c: sp.Symbol, s: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    """A polynomial in cosine and sine as one in the tangent, if its terms allow it."""
    if not x.has(c, s):
        return x
    if x.is_Mul:
        parts = [by_tangent(argument, c, s, t) for argument in x.args if argument.is_Add]
        rest = _by_tangent_of_sum(sp.Mul(*[f for f in x.args if not f.is_Add]), c, s, t)
        whole = [part for part in (rest, *parts) if part is not None]
        return sp.Mul(*whole) if len(whole) > len(parts) else None
    return _by_tangent_of_sum(x, c, s, t)


def _by_tangent_of_sum(x: sp.Expr, c: sp.Symbol, s: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    terms = terms_in(x, [c, s])
    if not terms:
        return sp.Integer(0)
    if len({sum(powers) % 2 for powers in terms}) > 1:
        return None
    top = max(sum(powers) for powers in terms)
    afford(len(terms) * (top + 1) ** 2)
    result = sp.Integer(0)
    for (a, b), coefficient in terms.items():
        lack = (top - a - b) // 2
        result += coefficient * t**b * (1 + t**2) ** lack
    return sp.expand(result)
