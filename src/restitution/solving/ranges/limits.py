"""Where an expression can turn, and its limits there and at the ends."""

from __future__ import annotations

import random
from collections.abc import Mapping
from itertools import product

import sympy as sp

from restitution import exact
from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra.intervals import INFINITE
from restitution.solving.algebra.numbers import Sample, at, sign_at
from restitution.solving.ranges.zeros import zeros

_INFINITIES = {sp.oo: sp.Integer(1), -sp.oo: sp.Integer(-1)}


LONG = 60
"""What has more operations has no limit that is found by series in any time that is left."""


_NO_VALUE = (sp.nan, sp.zoo, sp.oo, -sp.oo)


@dataclass(frozen=True)
class TwoForms:
    """A value in textbook form, and as it is worked out.

    The other form has a value also where an angle is one at which the textbook form has a pole.
    """

    textbook: sp.Expr
    whole: sp.Expr

    def put(self, values: Mapping[sp.Symbol, sp.Expr]) -> TwoForms:
        """Both forms with values for letters."""
        return TwoForms(self.textbook.xreplace(values), self.whole.xreplace(values))

    def without_poles(self, symbol: sp.Symbol, roles: Mapping[str, Role]) -> sp.Expr:
        """The textbook form, or the other one where that can jump as a letter varies."""
        return self.whole if breaks(self.textbook, symbol, roles) else self.textbook


def breaks(expression: sp.Expr, symbol: sp.Symbol, roles: Mapping[str, Role]) -> list[sp.Expr]:
    """Where an expression can jump: its poles, and where the angle of a vector passes 180°."""
    parts: dict[sp.Expr, None] = {}
    for node in sp.preorder_traversal(exact.in_sines(expression)):
        if isinstance(node, sp.Pow) and node.exp.is_negative:
            parts[node.base] = None
        elif isinstance(node, sp.sign):
            parts[node.args[0]] = None
        elif isinstance(node, sp.atan2):
            above, along = node.args
            parts[along if above == 0 else above] = None
        elif isinstance(node, sp.tan | sp.cot):
            parts[(sp.cos if isinstance(node, sp.tan) else sp.sin)(node.args[0])] = None
    numerators = [sp.together(part).as_numer_denom()[0] for part in parts]
    return list(
        dict.fromkeys(
            point
            for value in numerators
            if value.has(symbol)
            for point in zeros([value], [symbol], roles, symbol.name)
        )
    )


def turning(expression: sp.Expr, symbol: sp.Symbol, roles: Mapping[str, Role]) -> list[sp.Expr]:
    """Where an expression can turn: its stationary points, and the kinks where a bar vanishes."""
    bars = sorted((bar for bar in expression.atoms(sp.Abs) if bar.has(symbol)), key=str)
    points: list[sp.Expr] = []
    # A sign is constant but where it jumps, which is a break.
    expression = expression.xreplace({atom: sp.Dummy() for atom in expression.atoms(sp.sign)})
    for bar in bars:
        points += zeros(
            [sp.together(bar.args[0]).as_numer_denom()[0]], [symbol], roles, symbol.name
        )
    for signs in product((1, -1), repeat=len(bars)):
        put = {bar: sign * bar.args[0] for bar, sign in zip(bars, signs, strict=True)}
        slope = _derivative(expression.xreplace(put), symbol)
        points += zeros([slope], [symbol], roles, symbol.name)
    return list(dict.fromkeys(points))


def _derivative(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """What vanishes at stationary points: the numerator of the derivative.

    A number times a root or an inverse function, and a number more, turns where that does of
    which it is made.
    """
    core = expression
    while True:
        core = core.as_independent(symbol, as_Add=True)[1]
        core = core.as_independent(symbol, as_Add=False)[1]
        is_root = isinstance(core, sp.Pow) and core.exp == sp.S.Half
        if not is_root and not isinstance(core, sp.atan | sp.asin | sp.acos):
            break
        core = core.args[0]
    above, below = sp.together(core).as_numer_denom()
    slope = sp.diff(above, symbol) * below - above * sp.diff(below, symbol)
    return sp.together(slope).as_numer_denom()[0]


def limit(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool = False
) -> sp.Expr | None:
    """The value of an expression at a point, or its limit there (from below if so asked)."""
    quick = _approached(exact.in_sines(expression), symbol, sp.sympify(point, strict=True), below)
    if quick is not None:
        return quick if quick.has(*_INFINITIES) else exact.tidy(quick)
    if sp.count_ops(expression) > LONG or not _is_real_near(expression, symbol, point, below):
        return None
    try:
        side = "-" if below or point == sp.oo else "+"
        value = sp.limit(expression, symbol, point, side)
    except (NotImplementedError, ValueError, TypeError, RecursionError):
        return None
    return None if value.has(sp.nan, sp.zoo, sp.Limit) else value


def limits(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, role: Role, *, broken: bool
) -> list[tuple[sp.Expr, dict[str, int]]]:
    """The limit at a point, or one for each side of a break, with the side that it belongs to.

    None at a point that lies out of the letter's range, whatever the data are.
    """
    if _is_beyond(point, role):
        return []
    if not broken or point in (sp.oo, -sp.oo, role.low, role.high):
        value = limit(expression, symbol, point, point == role.high)
        return [] if value is None else [(value, {})]
    both = ((limit(expression, symbol, point, side < 0), side) for side in (1, -1))
    return [(value, {symbol.name: side}) for value, side in both if value is not None]


def _is_beyond(point: sp.Expr, role: Role) -> bool:
    """Whether a letter never comes near to a point: −3m to a mass."""
    if point in (sp.oo, -sp.oo):
        return False
    below = role.low is not None and (role.low - point).is_positive
    return bool(below or (role.high is not None and (point - role.high).is_positive))


def _approached(x: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool) -> sp.Expr | None:
    """The limit where it can be had by putting in; None where it takes more."""
    if not x.has(symbol):
        return x
    if point in (sp.oo, -sp.oo):
        return None
    if x.is_Add or (x.is_Mul and x.args[0].is_number and not x.args[0].has(symbol)):
        parts = [_approached(argument, symbol, point, below) for argument in x.args]
        if all(part is not None and part.is_finite is not False for part in parts):
            return x.func(*parts)
    if isinstance(x, sp.atan):
        inner = _approached(x.args[0], symbol, point, below)
        if inner is not None and inner.has(*_INFINITIES):
            return None if inner.is_Add else inner.xreplace(_INFINITIES) * sp.pi / 2
        return None if inner is None else sp.atan(inner)
    if isinstance(x, sp.sign):
        inner = _approached(x.args[0], symbol, point, below)
        if inner is None or inner.has(*_INFINITIES):
            return None
        if inner != 0:
            return sp.sign(inner)
        side = _sign_near(x.args[0], symbol, point, below)
        return None if side is None else sp.Integer(side)
    if isinstance(x, sp.atan2):
        above, along = (_approached(argument, symbol, point, below) for argument in x.args)
        if above is None or along is None or not (above.is_finite and along.is_finite):
            return None
        if above != 0 or (x.args[0] == 0 and along != 0):
            return sp.atan2(above, along)
        ahead = _sign_near(x.args[1], symbol, point, below)
        side = 1 if x.args[0] == 0 else _sign_near(x.args[0], symbol, point, below)
        return None if ahead is None or side is None else (1 - ahead) * side * sp.pi / 2
    top, bottom = sp.together(x).as_numer_denom()
    try:
        value, under = (value.xreplace({symbol: point}) for value in (top, bottom))
        value, under = sp.expand(value), sp.expand(under)
        if under.free_symbols and sp.expand(sp.fraction(sp.together(under))[0]) == 0:
            under = sp.S.Zero
    except (ZeroDivisionError, TypeError):
        return None
    if any(form.has(*_NO_VALUE) for form in (value, under)):
        return None
    if under != 0:
        return value / under
    if value == 0:
        return None
    sign = _sign_near(bottom, symbol, point, below, value)
    if sign is not None:
        return sign * sp.oo
    # It hangs on the data: the denominator rises through 0 there, or falls.
    slope = sp.factor(value * sp.diff(bottom, symbol).xreplace({symbol: point}))
    if slope == 0 or slope.has(*_NO_VALUE):
        return None
    return sp.oo * sp.sign(-slope if below else slope)


def _is_real_near(x: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool) -> bool:
    """Whether an expression has a real value close to a point, for some data.

    Where it has none, its limit is that of a complex number, which takes long and is of no use.
    """
    if point in _INFINITIES:
        near = _INFINITIES[point] * sp.Integer(10) ** 8
    else:
        near = point + sp.Rational(-1 if below else 1, 10**8)
    there = x.xreplace({symbol: near})
    rng = random.Random(53)
    names = sorted(symbol_names(there))
    for _ in range(_DRAWN):
        small = {name: rng.uniform(0, 1) for name in names}
        wide = {name: 10 ** rng.uniform(-2, 2) for name in names}
        drawn = {name: Enclosed.of(rng.choice((small, wide))[name]) for name in names}
        try:
            at(there, drawn)
        except (UndefinedError, KeyError):
            continue
        return True
    return False


_DRAWN = 60


def _sign_near(
    x: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool, factor: sp.Expr = sp.S.One
) -> int | None:
    """The sign of an expression close to a point, times a factor; None where there is not one."""
    step = sp.Rational(-1 if below else 1, 10**8)
    near = factor * x.xreplace({symbol: point + step})
    rng = random.Random(47)
    names = sorted(symbol_names(near))
    points = [{name: Enclosed.of(rng.uniform(0, 1)) for name in names} for _ in range(16)]
    return sign_at(near, points) or None


def limit_at(value: sp.Expr, drawn: Sample) -> Enclosed | None:
    """A limit as a number at some values of the data; None where it has none."""
    infinite = value.has(*_INFINITIES)
    if infinite:  # with a sign that may hang on the data
        terms = [term for term in sp.Add.make_args(value) if term.has(*_INFINITIES)]
        value = sp.Add(*terms).xreplace(_INFINITIES).replace(sp.sign, lambda x: x)
    try:
        number = at(value, drawn)
        return Enclosed.of(INFINITE * number.sign) if infinite else number
    except (UndefinedError, KeyError):
        return None
