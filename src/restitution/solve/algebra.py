"""Systems of equations made polynomial, and solved by elimination with every root kept.

Angles that are sought become tangents, or pairs of cosine and sine; roots of expressions with
unknowns are squared away. What is found satisfies the polynomials; whether it also satisfies the
facts as they were told, signs and ranges, is for the caller to check.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.exact import denested
from restitution.oracle.roles import Role
from restitution.solve.neat import factors, neat, numerator
from restitution.solve.numbers import changes_sign, vanishes

MOST_BRANCHES = 24
MOST_STEPS = 400

Assignment = dict[sp.Symbol, sp.Expr]


@dataclass
class Budget:
    """Bounds the work of one system: elimination on bad systems grows without end."""

    steps: int = MOST_STEPS

    def spend(self) -> None:
        self.steps -= 1
        if self.steps < 0:
            raise UnsupportedError("the equations of this question are too hard to solve exactly")


@dataclass(frozen=True)
class Found:
    """One solution: letters by name; angles also as (cos, sin); letters left free."""

    values: Mapping[str, sp.Expr]
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]] = field(default_factory=dict)
    leftover: tuple[sp.Expr, ...] = ()


Zero = Callable[[sp.Expr], bool]


def solve_system(
    equations: Iterable[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    angles: frozenset[sp.Symbol],
    acute: frozenset[sp.Symbol],
    roles: Mapping[str, Role],
) -> list[Found]:
    """All solutions of equations (each = 0) for the unknowns, earliest eliminated first.

    An unknown that the equations do not fix is absent from a solution. Equations without
    unknowns that do not vanish are handed back as ``leftover``: facts about the data.
    Raises UnsupportedError where elimination meets what it cannot solve.
    """

    def zero(x: sp.Expr) -> bool:
        return vanishes(x, roles)

    sought = list(unknowns)
    current = [sp.sympify(each, strict=True) for each in equations]
    generators: list[sp.Symbol] = []
    pairs: dict[sp.Symbol, tuple[sp.Symbol, sp.Symbol]] = {}
    tangents: dict[sp.Symbol, sp.Symbol] = {}
    scale: dict[sp.Symbol, int] = {}
    for symbol in sought:
        if symbol not in angles or not any(each.has(symbol) for each in current):
            continue
        q = _denominator(current, symbol)
        scale[symbol] = q
        sign = {"positive": True} if symbol in acute or q > 1 else {"real": True}
        c = sp.Symbol(f"cos_{symbol.name}", **sign)
        s = sp.Symbol(f"sin_{symbol.name}", **(sign if symbol in acute else {"real": True}))
        half = symbol / q
        replaced = []
        for each in current:
            each = each.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))
            each = each.replace(sp.cot, lambda a: sp.cos(a) / sp.sin(a))
            replaced.append(_trig_in(each, symbol, half, c, s))
        current = replaced
        pairs[symbol] = (c, s)
    # Roots and sizes of what is unknown are squared away.
    everything = set(sought) | {x for pair in pairs.values() for x in pair}
    current = [_rational(each, everything) for each in current]
    polynomials = [numerator(each) for each in current]
    for symbol, (c, s) in pairs.items():
        if any(each.has(symbol) for each in polynomials):
            raise UnsupportedError(
                f"the angle {symbol.name} stands both as itself and under a sine"
            )
        if scale[symbol] == 1 and symbol in acute:
            t = sp.Symbol(f"tan_{symbol.name}", positive=True)
            rewritten = [_by_tangent(each, c, s, t) for each in polynomials]
            if all(each is not None for each in rewritten):
                polynomials = [each for each in rewritten if each is not None]
                tangents[symbol] = t
                generators.append(t)
                continue
        polynomials.append(c**2 + s**2 - 1)
        generators += [s, c]
    gens = [x for x in sought if x not in pairs]
    order = gens + generators
    solutions: list[Found] = []
    budget = Budget()
    for assignment, rest in _reduce(polynomials, order, {}, zero, budget):
        values: dict[str, sp.Expr] = {}
        found_angles: dict[str, tuple[sp.Expr, sp.Expr]] = {}
        for symbol in sought:
            if symbol in tangents:
                t = assignment.get(tangents[symbol])
                if t is None:
                    continue
                values[symbol.name] = sp.atan(t)
                size = sp.sqrt(neat(1 + t**2))
                found_angles[symbol.name] = (1 / size, t / size)
            elif symbol in pairs:
                c, s = (assignment.get(x) for x in pairs[symbol])
                if c is None or s is None:
                    continue
                q = scale[symbol]
                values[symbol.name] = _within(q * _angle_of(c, s), roles[symbol.name])
                if q == 1:
                    found_angles[symbol.name] = (c, s)
            elif symbol in assignment:
                values[symbol.name] = assignment[symbol]
        # What stays free is spoken of as the angle, not as its tangent.
        names = {t: sp.tan(symbol) for symbol, t in tangents.items()}
        for symbol, (c, s) in pairs.items():
            names |= {c: sp.cos(symbol / scale[symbol]), s: sp.sin(symbol / scale[symbol])}
        values = {name: value.xreplace(names) for name, value in values.items()}
        found_angles = {
            name: (c.xreplace(names), s.xreplace(names)) for name, (c, s) in found_angles.items()
        }
        solutions.append(Found(values, found_angles, tuple(rest)))
    return solutions


def _within(angle: sp.Expr, role: Role) -> sp.Expr:
    """The same direction, where more than 180° are allowed, a turn further on if need be."""
    wide = role.low is not None and role.high is not None and bool(role.high > sp.pi)
    if wide and angle.is_number and bool(angle < role.low):
        return angle + 2 * sp.pi
    return angle


def _angle_of(c: sp.Expr, s: sp.Expr) -> sp.Expr:
    if c.is_zero:
        return sp.pi / 2 if s.is_positive is not False else -sp.pi / 2
    if c.is_number and s.is_number:
        return sp.atan2(sp.radsimp(s), sp.radsimp(c))
    if c.is_positive:
        return sp.atan(neat(s / c))
    return sp.atan2(s, c)


def _denominator(equations: Sequence[sp.Expr], symbol: sp.Symbol) -> int:
    """The least q such that every sine and cosine is of a whole multiple of symbol/q."""
    q = 1
    for each in equations:
        for node in each.atoms(sp.sin, sp.cos, sp.tan, sp.cot):
            coefficient = sp.expand(node.args[0]).coeff(symbol)
            if coefficient.is_Rational and coefficient != 0:
                q = int(sp.ilcm(q, coefficient.q))
    return q


def _trig_in(x: sp.Expr, symbol: sp.Symbol, base: sp.Expr, c: sp.Symbol, s: sp.Symbol) -> sp.Expr:
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


def _rational(x: sp.Expr, unknowns: set[sp.Symbol]) -> sp.Expr:
    """An equation freed of roots and sizes of expressions in the unknowns, by squaring."""
    for _ in range(6):
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
            return x
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
        poly = sp.Poly(numerator(replaced), mark)
        even = odd = sp.Integer(0)
        for (power,), coefficient in poly.terms():
            if power % 2:
                odd += coefficient * square ** ((power - 1) // 2)
            else:
                even += coefficient * square ** (power // 2)
        x = odd if even == 0 else (even if odd == 0 else even**2 - odd**2 * square)
        if odd == 0 and even == 0:
            return sp.Integer(0)
        if even == 0:
            x = odd * square
    raise UnsupportedError("too many roots of what is sought in one equation")


def _by_tangent(x: sp.Expr, c: sp.Symbol, s: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    """A polynomial in cosine and sine as one in the tangent, if its terms allow it."""
    if not x.has(c, s):
        return x
    poly = sp.Poly(x, c, s)
    degrees = {sum(powers) % 2 for powers in poly.monoms()}
    if len(degrees) > 1:
        return None
    top = max(sum(powers) for powers in poly.monoms())
    result = sp.Integer(0)
    for (a, b), coefficient in poly.terms():
        lack = (top - a - b) // 2
        result += coefficient * t**b * (1 + t**2) ** lack
    return sp.expand(result)


# --- elimination ------------------------------------------------------------------------------


def _reduce(
    equations: list[sp.Expr],
    unknowns: list[sp.Symbol],
    found: Assignment,
    zero: Zero,
    budget: Budget,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    """Branches of (assignment, equations left over)."""
    budget.spend()
    simple: list[sp.Expr] = []
    rest: list[sp.Expr] = []
    free = set(unknowns)
    for index, equation in enumerate(equations):
        parts = _factors(equation, free, zero)
        if parts is None:
            continue  # it vanishes
        if not parts:
            return []  # it cannot vanish
        if len(parts) > 1 and any(f.free_symbols & free for f in parts):
            results = []
            for factor in parts:
                others = simple + rest + equations[index + 1 :]
                results += _reduce([factor, *others], unknowns, found, zero, budget)
                if len(results) > MOST_BRANCHES:
                    raise UnsupportedError("too many cases to distinguish")
            return results
        factor = sp.Mul(*parts) if len(parts) > 1 else parts[0]
        if factor.free_symbols & free:
            if factor not in simple:
                simple.append(factor)
        elif factor.free_symbols:
            rest.append(factor)
        else:
            return []
    if not simple:
        return [(found, rest)]
    pivot = _pivot(simple, unknowns)
    kind, equation, x = pivot
    others = [each for each in simple if each is not equation] + rest
    left = [u for u in unknowns if u != x]
    if kind == "roots":
        return _by_roots(equation, x, others, left, found, zero, budget)
    if kind == "linear":
        a, b = _linear(equation, x)
        return _substitute(x, neat(-b / a), others, left, found, zero, budget)
    if kind == "linear?":
        a, b = _linear(equation, x)
        results = _substitute(x, neat(-b / a), others, left, found, zero, budget)
        results = [(values, more) for values, more in results if not _lost(a, values, zero)]
        if not _nonzero(a):
            results += _reduce([a, b, *others], unknowns, found, zero, budget)
        return results
    if kind == "square":
        poly = sp.Poly(equation, x)
        a, b = poly.coeff_monomial(x**2), poly.coeff_monomial(1)
        square = neat(-b / a)
        mapped = [numerator(_even(each, x, square)) for each in others]
        results = []
        for values, more in _reduce(mapped, left, found, zero, budget):
            value = neat(square.xreplace(values))
            for candidate in _square_roots(value, x):
                results.append(({**values, x: candidate}, more))
        return results
    return _by_resultant(equation, x, others, left, found, zero, budget)


def _lost(a: sp.Expr, values: Assignment, zero: Zero) -> bool:
    try:
        return zero(sp.sympify(a.xreplace(values), strict=True))
    except (ZeroDivisionError, TypeError):
        return False


def _even(x: sp.Expr, symbol: sp.Symbol, square: sp.Expr) -> sp.Expr:
    poly = sp.Poly(x, symbol)
    return sp.Add(*[c * square ** (p // 2) for (p,), c in poly.terms()])


def _square_roots(value: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    if value == 0:
        return [] if x.is_positive else [sp.Integer(0)]
    if value.is_negative:
        return []
    size = _sqrt(value)
    if x.is_nonnegative:
        return [size]
    return [size, -size]


def _sqrt(value: sp.Expr) -> sp.Expr:
    value = sp.factor(value) if value.free_symbols else sp.radsimp(value)
    result = sp.sqrt(value)
    return denested(result) if not value.free_symbols else result


def _substitute(
    x: sp.Symbol,
    value: sp.Expr,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    found: Assignment,
    zero: Zero,
    budget: Budget,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    if value.is_number and not _admissible(value, x):
        return []
    put = {x: value}
    mapped = [numerator(each.xreplace(put)) if each.has(x) else each for each in others]
    results = []
    for values, rest in _reduce(mapped, left, found, zero, budget):
        own = value.xreplace(values) if value.free_symbols else value
        if own.has(sp.zoo, sp.nan, sp.oo):
            continue
        results.append(({**values, x: neat(own)}, rest))
    return results


def _admissible(value: sp.Expr, x: sp.Symbol) -> bool:
    """Whether a number fits what is known of an unknown that people never see the value of."""
    if not value.is_real and value.is_real is not None:
        return False
    trigonometric = x.name.startswith(("cos_", "sin_", "tan_"))
    return not (trigonometric and x.is_positive and not value.is_positive)


def _linear(equation: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    poly = sp.Poly(equation, x)
    return poly.coeff_monomial(x), poly.coeff_monomial(1)


def _factors(equation: sp.Expr, free: set[sp.Symbol], zero: Zero) -> list[sp.Expr] | None:
    """The factors that may vanish; None if the equation holds by itself."""
    if equation == 0:
        return None
    if not equation.free_symbols & free:
        return None if zero(equation) else [equation]
    parts: Sequence[sp.Expr] = [equation]
    with suppress(sp.PolynomialError, NotImplementedError):
        if sp.count_ops(equation) < 1500:
            parts = factors(equation)
    kept = []
    # A factor that cannot vanish for admissible letters is left out; were it the only one, its
    # root is kept, to be refused with a reason.
    able = [factor for factor in parts if not _nonzero(factor)]
    if not any(factor.free_symbols & free for factor in able):
        of_data = [factor for factor in able if factor.free_symbols]
        if of_data:
            return None if any(zero(factor) for factor in of_data) else of_data
        able = [f for f in parts if any(not s.name.startswith("_") for s in f.free_symbols)]
    else:
        able += [f for f in parts if f not in able and _told_of(f, free)]
    for factor in able:
        inside = factor.free_symbols & free
        if not inside:
            if zero(factor):
                return None
            continue  # a factor of data alone is not zero in general
        kept.append(factor)
    if not kept and zero(equation):
        return None
    return _truly(kept, free, zero)


def _told_of(factor: sp.Expr, free: set[sp.Symbol]) -> bool:
    """Whether the root of a factor that cannot vanish is a value people meet and have to reject.

    It is one of a letter that is sought, by an equation of degree 1 with numbers alone; but not
    nothing, and not e = −1, which is no impact at all.
    """
    if factor.is_Symbol or len(factor.free_symbols) != 1 or not factor.free_symbols <= free:
        return False
    (x,) = factor.free_symbols
    if x.name.startswith(("_", "cos_", "sin_", "tan_")) or not factor.is_polynomial(x):
        return False
    poly = sp.Poly(factor, x)
    return bool(poly.degree() == 1 and poly.eval(-1) != 0)


def _truly(parts: list[sp.Expr], free: set[sp.Symbol], zero: Zero) -> list[sp.Expr] | None:
    """Drops coefficients that are zero in disguise (sin² + cos² − 1)."""
    cleaned = []
    for factor in parts:
        if factor.free_symbols <= free:
            cleaned.append(factor)  # its coefficients are numbers
            continue
        gens = sorted(factor.free_symbols & free, key=lambda s: s.name)
        poly = sp.Poly(factor, *gens)
        terms = [(m, c) for m, c in poly.terms() if not (not c.is_number and zero(c))]
        if len(terms) == len(poly.terms()):
            cleaned.append(factor)
            continue
        if not terms:
            return None
        rebuilt = sp.Add(
            *[c * sp.Mul(*[g**p for g, p in zip(gens, m, strict=True)]) for m, c in terms]
        )
        if rebuilt.free_symbols & free:
            cleaned.append(rebuilt)
    return cleaned


@lru_cache(maxsize=2048)
def _nonzero(x: sp.Expr) -> bool:
    if x.is_Add and changes_sign(x):
        return False  # which SymPy would take long to give up
    return bool(x.is_nonzero) or bool(x.is_positive) or bool(x.is_negative)


def _pivot(equations: list[sp.Expr], unknowns: list[sp.Symbol]) -> tuple[str, sp.Expr, sp.Symbol]:
    """Which unknown to remove next, from which equation, and how: the cheapest."""
    best: tuple[tuple[int, int, int], str, sp.Expr, sp.Symbol] | None = None
    free = set(unknowns)
    for equation in equations:
        inside = equation.free_symbols & free
        size = len(equation.args) if equation.is_Add else 1
        for rank, x in enumerate(unknowns):
            if x not in inside:
                continue
            poly = sp.Poly(equation, x)
            degree = poly.degree()
            if len(inside) == 1:
                kind, cost = "roots", (0 if degree == 1 else 2 if degree <= 2 else 6)
            elif degree == 1:
                a = poly.coeff_monomial(x)
                if not a.free_symbols & free:
                    kind, cost = "linear", 1
                elif _nonzero(a):
                    kind, cost = "linear", 3
                else:
                    kind, cost = "linear?", 4
            elif degree == 2 and _only_even(equations, x):
                a = poly.coeff_monomial(x**2)
                kind, cost = (
                    ("square", 3) if not a.free_symbols & free or _nonzero(a) else ("resultant", 8)
                )
            else:
                kind, cost = "resultant", 8 + int(degree)
            key = (cost, size, rank)
            if best is None or key < best[0]:
                best = (key, kind, equation, x)
    assert best is not None
    return best[1], best[2], best[3]


def _only_even(equations: list[sp.Expr], x: sp.Symbol) -> bool:
    return all(
        power % 2 == 0
        for each in equations
        if each.has(x)
        for (power,) in sp.Poly(each, x).monoms()
    )


def _by_roots(
    equation: sp.Expr,
    x: sp.Symbol,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    found: Assignment,
    zero: Zero,
    budget: Budget,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    results = []
    for value in roots(equation, x):
        results += _substitute(x, value, others, left, found, zero, budget)
    return results


def _by_resultant(
    equation: sp.Expr,
    x: sp.Symbol,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    found: Assignment,
    zero: Zero,
    budget: Budget,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    with_x = [each for each in others if each.has(x)]
    without = [each for each in others if not each.has(x)]
    if not with_x:
        # The only equation that holds x: the rest is solved first, then x from it.
        results = []
        for values, rest in _reduce(without, left, found, zero, budget):
            reduced = numerator(equation.xreplace(values))
            for value in roots(reduced, x):
                results.append(({**values, x: neat(value)}, rest))
        return results
    for each in with_x:
        budget.spend()
        if sp.count_ops(each) * sp.count_ops(equation) > 400_000:
            raise UnsupportedError("the equations of this question are too hard to solve exactly")
        r = sp.expand(sp.resultant(equation, each, x))
        if r == 0:
            raise UnsupportedError("equations with a common part")
        without.append(r)
    results = []
    for values, rest in _reduce(without, left, found, zero, budget):
        candidates = [numerator(each.xreplace(values)) for each in (equation, *with_x)]
        candidates = [each for each in candidates if each.has(x)] or candidates
        simplest = min(candidates, key=lambda e: sp.degree(e, x) if e.has(x) else 99)
        if not simplest.has(x):
            continue
        for value in roots(simplest, x):
            if all(zero(each.xreplace({x: value})) for each in candidates):
                results.append(({**values, x: neat(value)}, rest))
    return results


# --- roots of one polynomial ------------------------------------------------------------------


def roots(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The real roots of a polynomial in ``x``, exact; coefficients may hold letters and surds.

    Raises UnsupportedError where there is no formula for people (degree above 2 with letters).
    """
    poly = sp.Poly(equation, x)
    degree = poly.degree()
    if degree == 0:
        return []
    if degree == 1:
        a, b = poly.all_coeffs()
        return [_tidy_root(-b / a)]
    found: list[sp.Expr] = []
    for factor in _factors_of(poly, x):
        found += [each for each in _roots_of(factor, x) if each not in found]
    return found


def _factors_of(poly: sp.Poly, x: sp.Symbol) -> list[sp.Poly]:
    expression = poly.as_expr()
    letters = expression.free_symbols - {x}
    surds = sorted(
        {
            node
            for node in expression.atoms(sp.Pow)
            if node.is_number and node.exp == sp.S.Half and node.base.is_Rational
        },
        key=sp.default_sort_key,
    )
    try:
        if surds and poly.degree() > 2 and not letters and len(surds) <= 2:
            _, pairs = sp.factor_list(expression, x, extension=surds)
            parts = tuple(factor for factor, _ in pairs)
        else:
            parts = factors(expression)
    except (sp.PolynomialError, NotImplementedError):
        return [poly]
    return [sp.Poly(factor, x) for factor in parts if factor.has(x)]


def _roots_of(poly: sp.Poly, x: sp.Symbol) -> list[sp.Expr]:
    degree = poly.degree()
    coefficients = poly.all_coeffs()
    letters = poly.as_expr().free_symbols - {x}
    if degree == 1:
        return [_tidy_root(-coefficients[1] / coefficients[0])]
    if degree == 2:
        a, b, c = coefficients
        return _quadratic(a, b, c)
    if degree == 4 and coefficients[1] == 0 and coefficients[3] == 0:
        squares = _quadratic(coefficients[0], coefficients[2], coefficients[4])
        found = []
        for square in squares:
            if square.is_number and square.is_negative:
                continue
            size = _sqrt(square)
            found += [size, -size] if size != 0 else [size]
        return found
    if letters:
        named = sp.roots(poly)
        if sum(named.values()) == degree:
            return [each for each in named if each.is_real is not False]
        raise UnsupportedError(
            f"an equation of degree {degree} with letters has no usable exact solution"
        )
    rational = _rational_multiple(poly, x)
    found = []
    for candidate in sp.Poly(rational, x).real_roots(multiple=False):
        value = candidate[0]
        if rational.as_expr() == poly.as_expr() or _is_root(poly, value):
            found.append(value)
    return found


def _is_root(poly: sp.Poly, value: sp.Expr) -> bool:
    size = sum(abs(sp.N(c, 40)) for c in poly.all_coeffs())
    return bool(abs(sp.N(poly.as_expr().xreplace({poly.gen: sp.N(value, 60)}), 40)) < size * 1e-25)


def _rational_multiple(poly: sp.Poly, x: sp.Symbol) -> sp.Poly:
    """A multiple with rational coefficients: the product over conjugate surds."""
    expression = poly.as_expr()
    for _ in range(3):
        surd = next(
            (
                node
                for node in expression.atoms(sp.Pow)
                if node.is_number and node.exp == sp.S.Half and node.base.is_Rational
            ),
            None,
        )
        if surd is None:
            break
        expression = sp.expand(expression * expression.xreplace({surd: -surd}))
    result = sp.Poly(expression, x)
    if not all(c.is_Rational for c in result.all_coeffs()):
        raise UnsupportedError("an equation whose coefficients hold nested roots")
    return result


def _quadratic(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> list[sp.Expr]:
    if a.is_number and not a.is_Rational:
        # Dividing first keeps surds out of the denominator under the root.
        b, c = (sp.radsimp(sp.expand(each / a), max_terms=4) for each in (b, c))
        a = sp.Integer(1)
    discriminant = sp.expand(b * b - 4 * a * c)
    if discriminant.is_number:
        discriminant = sp.radsimp(discriminant)
        if discriminant.is_negative:
            return []
    if discriminant == 0:
        return [_tidy_root(-b / (2 * a))]
    d = _sqrt(discriminant)
    return [_tidy_root((-b + d) / (2 * a)), _tidy_root((-b - d) / (2 * a))]


def _tidy_root(value: sp.Expr) -> sp.Expr:
    if value.is_number:
        return denested(sp.radsimp(sp.expand(value), max_terms=4))
    return neat(value)
