"""Systems of equations made polynomial, and solved by elimination with every root kept.

Angles that are sought become tangents, or pairs of cosine and sine; roots of expressions with
unknowns are squared away. What is found satisfies the polynomials; whether it also satisfies the
facts as they were told, signs and ranges, is for the caller to check.

Degrees, coefficients, factors, resultants and zeros are asked of ``polynomials``, over the
rationals and in letters of which nothing is assumed. All work is counted before it is begun: what
is too hard is refused after the same steps on every machine.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.exact import denested
from restitution.expression.enclosed import Enclosed
from restitution.oracle.roles import Role
from restitution.solving.cosines import gathered, has_cosines, without_cosines
from restitution.solving.neat import neat
from restitution.solving.numbers import at, vanishes
from restitution.solving.polynomials import (
    TOO_HARD,
    TooLargeError,
    afford,
    coefficients,
    definite,
    degree,
    factors,
    isolating,
    norm,
    numerator,
    plain_number,
    rational_below,
    resultant,
    sign,
    split_over_numbers,
    terms_in,
    vanishing,
)
from restitution.work import limited, remembered

MOST_BRANCHES = 24
MOST_OPERATIONS = 8_000_000
"""Operations that one system may take: elimination on bad systems grows without end."""
REDUCING = 20_000
"""Operations that a round of elimination counts for, beside the steps in it."""

Assignment = dict[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class Root:
    """One solution: letters by name; angles also as (cos, sin); letters left free."""

    values: Mapping[str, sp.Expr]
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]] = field(default_factory=dict)
    leftover: tuple[sp.Expr, ...] = ()


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


def _positive(roles: Mapping[str, Role], unknowns: frozenset[sp.Symbol]) -> frozenset[sp.Expr]:
    """The sines and cosines of data that are positive, by the ranges of the angles."""
    positive: set[sp.Expr] = set()
    names = {x.name for x in unknowns}
    for name, role in roles.items():
        if role.kind != "angle" or name in names or role.low is None or role.high is None:
            continue
        for function, low, high in ((sp.sin, 0, sp.pi), (sp.cos, -sp.pi / 2, sp.pi / 2)):
            above = role.low > low or (role.low == low and not role.closed[0])
            below = role.high < high or (role.high == high and not role.closed[1])
            if bool(above) and bool(below):
                positive.add(function(role.symbol(name)))
    return frozenset(positive)


def solve_system(
    equations: Iterable[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    angles: frozenset[sp.Symbol],
    acute: frozenset[sp.Symbol],
    roles: Mapping[str, Role],
) -> list[Root]:
    """All solutions of equations (each = 0) for the unknowns, earliest eliminated first.

    An unknown that the equations do not fix is absent from a solution. Equations without
    unknowns that do not vanish are handed back as ``leftover``: facts about the data.
    Raises UnsupportedError where elimination meets what it cannot solve, or is too much work.
    """
    with limited(operations=MOST_OPERATIONS, error=UnsupportedError(TOO_HARD)):
        try:
            return list(
                _solved(
                    tuple(sp.sympify(equation, strict=True) for equation in equations),
                    tuple(unknowns),
                    angles,
                    acute,
                    tuple(roles.items()),
                )
            )
        except sp.PolynomialError as error:
            raise UnsupportedError("these equations cannot be made polynomial") from error


@remembered(512)
def _solved(
    equations: tuple[sp.Expr, ...],
    unknowns: tuple[sp.Symbol, ...],
    angles: frozenset[sp.Symbol],
    acute: frozenset[sp.Symbol],
    every_role: tuple[tuple[str, Role], ...],
) -> tuple[Root, ...]:
    roles = dict(every_role)
    known = Known(roles, _positive(roles, frozenset(unknowns)))

    sought = list(unknowns)
    current = [_without_bars(equation, known) for equation in equations]
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
    polynomials = [_polynomial(each, everything) for each in current]
    for symbol, (c, s) in pairs.items():
        if any(polynomial.has(symbol) for polynomial in polynomials):
            raise UnsupportedError(
                f"the angle {symbol.name} stands both as itself and under a sine"
            )
        if scale[symbol] == 1 and symbol in acute:
            t = sp.Symbol(f"tan_{symbol.name}", positive=True)
            rewritten = [_by_tangent(polynomial, c, s, t) for polynomial in polynomials]
            if all(each is not None for each in rewritten):
                polynomials = [each for each in rewritten if each is not None]
                tangents[symbol] = t
                generators.append(t)
                continue
        polynomials.append(c**2 + s**2 - 1)
        generators += [s, c]
    gens = [x for x in sought if x not in pairs]
    order = gens + generators
    solutions: list[Root] = []
    for assignment, rest in _reduce(polynomials, order, {}, known):
        values: dict[str, sp.Expr] = {}
        known_angles: dict[str, tuple[sp.Expr, sp.Expr]] = {}
        for symbol in sought:
            if symbol in tangents:
                t = assignment.get(tangents[symbol])
                if t is None:
                    continue
                values[symbol.name] = sp.atan(t)
                size = sp.sqrt(neat(1 + t**2))
                known_angles[symbol.name] = (1 / size, t / size)
            elif symbol in pairs:
                c, s = (assignment.get(x) for x in pairs[symbol])
                if c is None or s is None:
                    continue
                q = scale[symbol]
                values[symbol.name] = _within(q * _angle_of(c, s), roles[symbol.name])
                if q == 1:
                    known_angles[symbol.name] = (c, s)
            elif symbol in assignment:
                values[symbol.name] = assignment[symbol]
        # What stays free is spoken of as the angle, not as its tangent.
        names = {t: sp.tan(symbol) for symbol, t in tangents.items()}
        for symbol, (c, s) in pairs.items():
            names |= {c: sp.cos(symbol / scale[symbol]), s: sp.sin(symbol / scale[symbol])}
        values = {name: value.xreplace(names) for name, value in values.items()}
        known_angles = {
            name: (c.xreplace(names), s.xreplace(names)) for name, (c, s) in known_angles.items()
        }
        solution = Root(values, known_angles, tuple(rest))
        if solution not in solutions:  # two factors may have a root in common
            solutions.append(solution)
    return tuple(solutions)


def _without_bars(x: sp.Expr, known: Known) -> sp.Expr:
    """|w| is w or −w where what is known of the letters tells which."""
    signs = {bar: definite(bar.args[0], known.positive) for bar in x.atoms(sp.Abs)}
    return x.xreplace({bar: bar.args[0] * own for bar, own in signs.items() if own})


def _within(angle: sp.Expr, role: Role) -> sp.Expr:
    """The same direction, where more than 180° are allowed, a turn further on if need be."""
    wide = role.low is not None and role.high is not None and bool(role.high > sp.pi)
    if wide and angle.is_number and bool(angle < role.low):
        return angle + 2 * sp.pi
    return angle


def _angle_of(c: sp.Expr, s: sp.Expr) -> sp.Expr:
    if vanishing(c):
        return sp.pi / 2 if definite(s) >= 0 else -sp.pi / 2
    if c.is_number and s.is_number:
        return sp.atan2(rational_below(s), rational_below(c))
    if definite(c) > 0:
        return sp.atan(neat(s / c))
    return sp.atan2(s, c)


def _denominator(equations: Sequence[sp.Expr], symbol: sp.Symbol) -> int:
    """The least q such that every sine and cosine is of a whole multiple of symbol/q."""
    q = 1
    for equation in equations:
        for node in equation.atoms(sp.sin, sp.cos, sp.tan, sp.cot):
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


def _polynomial(x: sp.Expr, unknowns: set[sp.Symbol]) -> sp.Expr:
    """A polynomial that vanishes where an equation holds: a product, where that is known."""
    return sp.Mul(*[gathered(numerator(each)) for each in _rational(x, unknowns)])


def _rational(x: sp.Expr, unknowns: set[sp.Symbol], depth: int = 6) -> list[sp.Expr]:
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
        conjugate = _hasrational_below(rational[0]) and not _hasrational_below(whole)
        if conjugate and not has_cosines(whole):
            rational = [whole]  # conjugates of each other, which are solved as one
    else:
        afford(sp.count_ops(even) ** 2 + sp.count_ops(odd) ** 2 * sp.count_ops(square))
        rational = [even**2 - odd**2 * square]
    return [part for each in rational for part in _rational(each, unknowns, depth - 1)]


def _hasrational_below(x: sp.Expr) -> bool:
    return any(atom.is_number and not atom.exp.is_Integer for atom in x.atoms(sp.Pow))


def _by_tangent(x: sp.Expr, c: sp.Symbol, s: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    """A polynomial in cosine and sine as one in the tangent, if its terms allow it."""
    if not x.has(c, s):
        return x
    if x.is_Mul:
        parts = [_by_tangent(argument, c, s, t) for argument in x.args if argument.is_Add]
        rest = _by_tangent_of_sum(sp.Mul(*[f for f in x.args if not f.is_Add]), c, s, t)
        whole = [each for each in (rest, *parts) if each is not None]
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


# --- elimination ------------------------------------------------------------------------------


def _reduce(
    equations: list[sp.Expr],
    unknowns: list[sp.Symbol],
    assignment: Assignment,
    known: Known,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    """Branches of (assignment, equations left over)."""
    afford(REDUCING)
    simple: list[sp.Expr] = []
    rest: list[sp.Expr] = []
    free = set(unknowns)
    for index, equation in enumerate(equations):
        parts = _factors(equation, free, known)
        if parts is None:
            continue  # it vanishes
        if not parts:
            return []  # it cannot vanish
        if len(parts) > 1 and any(f.free_symbols & free for f in parts):
            results = []
            for factor in parts:
                others = simple + rest + equations[index + 1 :]
                results += _reduce([factor, *others], unknowns, assignment, known)
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
        return [(assignment, rest)]
    pivot = _pivot(simple, unknowns, known)
    kind, equation, x = pivot
    others = [each for each in simple if each is not equation] + rest
    left = [u for u in unknowns if u != x]
    if kind == "roots":
        return _by_roots(equation, x, others, left, assignment, known)
    if kind == "linear":
        a, b = _linear(equation, x)
        return _substitute(x, neat(-b / a), others, left, assignment, known)
    if kind == "linear?":
        a, b = _linear(equation, x)
        results = _substitute(x, neat(-b / a), others, left, assignment, known)
        results = [(values, more) for values, more in results if not _lost(a, values, known)]
        if not known.nonzero(a):
            results += _reduce([a, b, *others], unknowns, assignment, known)
        return results
    if kind == "square":
        a, _, b = coefficients(equation, x)
        square = neat(-b / a)
        mapped = [numerator(_even(other, x, square)) for other in others]
        results = []
        for values, more in _reduce(mapped, left, assignment, known):
            value = neat(square.xreplace(values))
            for candidate in _square_roots(value, x):
                results.append(({**values, x: candidate}, more))
        return results
    return _by_resultant(equation, x, others, left, assignment, known)


def _lost(a: sp.Expr, values: Assignment, known: Known) -> bool:
    try:
        return known.zero(sp.sympify(a.xreplace(values), strict=True))
    except (ZeroDivisionError, TypeError):
        return False


def _even(x: sp.Expr, symbol: sp.Symbol, square: sp.Expr) -> sp.Expr:
    parts = coefficients(x, symbol)
    return sp.Add(*[c * square ** (p // 2) for p, c in enumerate(reversed(parts))])


def _square_roots(value: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    if vanishing(value):
        return [] if x.is_positive else [sp.Integer(0)]
    if definite(value) < 0:
        return []
    size = _sqrt(value)
    if x.is_nonnegative:
        return [size]
    return [size, -size]


def _sqrt(value: sp.Expr) -> sp.Expr:
    if value.has(sp.CRootOf):
        return sp.sqrt(value)
    if not value.free_symbols:
        return denested(sp.sqrt(rational_below(value)))
    afford(sp.count_ops(value) ** 2)
    return sp.sqrt(sp.factor(value))


def _substitute(
    x: sp.Symbol,
    value: sp.Expr,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    assignment: Assignment,
    known: Known,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    if value.is_number and not _admissible(value, x):
        return []
    put = {x: value}
    mapped = [numerator(other.xreplace(put)) if other.has(x) else other for other in others]
    results = []
    for values, rest in _reduce(mapped, left, assignment, known):
        own = value.xreplace(values) if value.free_symbols else value
        if own.has(sp.zoo, sp.nan, sp.oo):
            continue
        results.append(({**values, x: neat(own)}, rest))
    return results


def _admissible(value: sp.Expr, x: sp.Symbol) -> bool:
    """Whether a number suits a hidden unknown, by what is known of it."""
    own = sign(value)
    if own is None:
        return False
    trigonometric = x.name.startswith(("cos_", "sin_", "tan_"))
    return not (trigonometric and x.is_positive and own <= 0)


def _linear(equation: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    a, b = coefficients(equation, x)
    return a, b


def _factors(equation: sp.Expr, free: set[sp.Symbol], known: Known) -> list[sp.Expr] | None:
    """The factors that may vanish; None if the equation holds by itself."""
    if equation == 0:
        return None
    if not equation.free_symbols & free:
        return None if known.zero(equation) else [equation]
    parts: Sequence[sp.Expr] = [equation]
    with suppress(sp.PolynomialError, TooLargeError):  # then it stays whole
        parts = factors(equation)
    kept = []
    # A factor that cannot vanish for admissible letters is left out; were it the only one, its
    # root is kept, to be refused with a reason.
    able = [
        factor
        for factor in parts
        if not (definite(factor) if factor.free_symbols & free else known.nonzero(factor))
    ]
    if not any(factor.free_symbols & free for factor in able):
        of_data = [factor for factor in able if factor.free_symbols]
        if of_data:
            return None if any(known.zero(factor) for factor in of_data) else of_data
        able = [f for f in parts if any(not s.name.startswith("_") for s in f.free_symbols)]
    else:
        able += [f for f in parts if f not in able and _is_worth_rejecting(f, free)]
    for factor in able:
        inside = factor.free_symbols & free
        if not inside:
            if known.zero(factor):
                return None
            continue  # a factor of data alone is not zero in general
        kept.append(factor)
    if not kept and known.zero(equation):
        return None
    return _truly(kept, free, known)


def _is_worth_rejecting(factor: sp.Expr, free: set[sp.Symbol]) -> bool:
    """Whether the root of a factor that cannot vanish is a value people meet and have to reject.

    It is one of a letter that is sought, by an equation of degree 1 with numbers alone; but not
    nothing, and not e = −1, which is no impact at all.
    """
    if factor.is_Symbol or len(factor.free_symbols) != 1 or not factor.free_symbols <= free:
        return False
    (x,) = factor.free_symbols
    if x.name.startswith(("_", "cos_", "sin_", "tan_")) or not factor.is_polynomial(x):
        return False
    parts = coefficients(factor, x)
    return len(parts) == 2 and parts[0] != parts[1]


def _truly(parts: list[sp.Expr], free: set[sp.Symbol], known: Known) -> list[sp.Expr] | None:
    """Drops coefficients that are zero in disguise (sin² + cos² − 1)."""
    cleaned = []
    for factor in parts:
        if factor.free_symbols <= free:
            cleaned.append(factor)  # its coefficients are numbers
            continue
        gens = sorted(factor.free_symbols & free, key=lambda s: s.name)
        whole = terms_in(factor, gens)
        terms = [(m, c) for m, c in whole.items() if not (not c.is_number and known.zero(c))]
        if len(terms) == len(whole):
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


def _pivot(
    equations: list[sp.Expr], unknowns: list[sp.Symbol], known: Known
) -> tuple[str, sp.Expr, sp.Symbol]:
    """Which unknown to remove next, from which equation, and how: the cheapest."""
    best: tuple[tuple[int, int, int], str, sp.Expr, sp.Symbol] | None = None
    free = set(unknowns)
    for equation in equations:
        inside = equation.free_symbols & free
        size = len(equation.args) if equation.is_Add else 1
        for rank, x in enumerate(unknowns):
            if x not in inside:
                continue
            a, *rest = coefficients(equation, x)
            top = len(rest)
            if len(inside) == 1:
                kind, cost = "roots", (0 if top == 1 else 2 if top <= 2 else 6)
            elif top == 1:
                if not a.free_symbols & free:
                    kind, cost = "linear", 1
                elif known.nonzero(a):
                    kind, cost = "linear", 3
                else:
                    kind, cost = "linear?", 4
            elif top == 2 and _only_even(equations, x):
                kind, cost = (
                    ("square", 3)
                    if not a.free_symbols & free or known.nonzero(a)
                    else ("resultant", 8)
                )
            else:
                kind, cost = "resultant", 8 + top
            key = (cost, size, rank)
            if best is None or key < best[0]:
                best = (key, kind, equation, x)
    assert best is not None
    return best[1], best[2], best[3]


def _only_even(equations: list[sp.Expr], x: sp.Symbol) -> bool:
    return all(
        c == 0 or power % 2 == 0
        for each in equations
        if each.has(x)
        for power, c in enumerate(reversed(coefficients(each, x)))
    )


def _by_roots(
    equation: sp.Expr,
    x: sp.Symbol,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    assignment: Assignment,
    known: Known,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    results = []
    for value in roots(equation, x):
        results += _substitute(x, value, others, left, assignment, known)
    return results


def _by_resultant(
    equation: sp.Expr,
    x: sp.Symbol,
    others: list[sp.Expr],
    left: list[sp.Symbol],
    assignment: Assignment,
    known: Known,
) -> list[tuple[Assignment, list[sp.Expr]]]:
    with_x = [other for other in others if other.has(x)]
    without = [other for other in others if not other.has(x)]
    if not with_x:
        # The only equation that holds x: the rest is solved first, then x from it.
        results = []
        for values, rest in _reduce(without, left, assignment, known):
            reduced = numerator(equation.xreplace(values))
            for value in roots(reduced, x):
                results.append(({**values, x: neat(value)}, rest))
        return results
    for each in with_x:
        r = resultant(equation, each, x)
        if r == 0:
            raise UnsupportedError("equations with a common part")
        without.append(r)
    results = []
    for values, rest in _reduce(without, left, assignment, known):
        candidates = [numerator(each.xreplace(values)) for each in (equation, *with_x)]
        candidates = [candidate for candidate in candidates if candidate.has(x)] or candidates
        simplest = min(candidates, key=lambda e: degree(e, x) if e.has(x) else 99)
        if not simplest.has(x):
            continue
        for value in roots(simplest, x):
            if all(known.zero(candidate.xreplace({x: value})) for candidate in candidates):
                results.append(({**values, x: neat(value)}, rest))
    return results


# --- roots of one polynomial ------------------------------------------------------------------


def roots(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The real roots of a polynomial in ``x``, exact; coefficients may hold letters and surds.

    Raises UnsupportedError where there is no formula for people (degree above 2 with letters).
    """
    parts = coefficients(equation, x)
    if len(parts) < 2:
        return []
    if len(parts) == 2:
        a, b = parts
        return _in_degrees(equation, x, [_tidy_root(-b / a)])
    equation = gathered(equation)
    values: list[sp.Expr] = []
    for factor in _factors_of(equation, x):
        values += [each for each in _roots_of(factor, x) if each not in values]
    return _in_degrees(equation, x, values)


def _in_degrees(equation: sp.Expr, x: sp.Symbol, values: list[sp.Expr]) -> list[sp.Expr]:
    """Roots that are tangents of whole degrees as such, where degrees stand in the equation."""
    if equation.free_symbols != {x} or not x.name.startswith("tan_") or not has_cosines(equation):
        return values
    parts = coefficients(equation, x)
    numbers = [float(at(value, {}).fraction) for value in values]
    in_degrees = list(values)
    for number in numbers:
        angle = sp.Rational(round(2 * math.degrees(math.atan(number))), 360) * sp.pi
        c, s = sp.cos(angle), sp.sin(angle)
        powers = [c**n * s ** (len(parts) - 1 - n) for n in range(len(parts))]
        total = sp.Add(*[each * power for each, power in zip(parts, powers, strict=True)])
        if gathered(sp.expand(total)) == 0:
            # It is a root: that which is nearest to it.
            gaps = [abs(other - math.tan(float(angle))) for other in numbers]
            in_degrees[gaps.index(min(gaps))] = sp.tan(angle)
    return in_degrees


def _factors_of(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    if degree(equation, x) > 2 and equation.free_symbols == {x}:
        return split_over_numbers(equation, x)
    try:
        parts = factors(equation)
    except (sp.PolynomialError, TooLargeError):
        return [equation]
    return [factor for factor in parts if factor.has(x)]


def _roots_of(equation: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    parts = coefficients(equation, x)
    top = len(parts) - 1
    if top == 1:
        return [_tidy_root(-parts[1] / parts[0])]
    if top == 2:
        return _quadratic(*parts)
    if top == 4 and parts[1] == 0 and parts[3] == 0:
        squares = _quadratic(parts[0], parts[2], parts[4])
        values = []
        for square in squares:
            if definite(square) < 0:
                continue
            size = _sqrt(square)
            values += [size, -size] if size != 0 else [size]
        return values
    if equation.free_symbols != {x}:
        if any(part != 0 for part in parts[1:-1]):
            raise UnsupportedError(
                f"an equation of degree {top} with letters has no usable exact solution"
            )
        return _of_binomial(parts[0], parts[-1], top)
    lone = without_cosines(equation, x) if has_cosines(equation) else None
    rational = norm(equation if lone is None else lone, x)
    afford(isolating(rational, x))
    values = []
    for value, _ in sp.Poly(rational, x, domain="QQ").real_roots(multiple=False):
        if degree(rational, x) == top or (_may_be_root(parts, value) and _is_root(parts, value)):
            values.append(value)
    return values


def _of_binomial(a: sp.Expr, b: sp.Expr, power: int) -> list[sp.Expr]:
    """The real roots of a xⁿ + b: one if n is odd and the sign is known, else two or none."""
    value = neat(-b / a)
    known = definite(value)
    if known == 0 or (known < 0 and power % 2 == 0):
        if known < 0:
            return []
        raise UnsupportedError(
            f"an equation of degree {power} with letters has no usable exact solution"
        )
    size = sp.Pow(value if known > 0 else neat(-value), sp.Rational(1, power))
    if power % 2:
        return [size if known > 0 else -size]
    return [size, -size]


def _may_be_root(parts: Sequence[sp.Expr], value: sp.Expr) -> bool:
    """Whether 20 digits cannot distinguish a polynomial from zero at a number."""
    x, total, size = value.evalf(20), sp.Float(0, 20), sp.Float(0, 20)
    for part in parts:
        c = part.evalf(20)
        total, size = total * x + c, size * abs(x) + abs(c)
    return bool(abs(total) <= size * sp.Float("1e-12"))


def _is_root(parts: Sequence[sp.Expr], value: sp.Expr) -> bool:
    """Whether a root of the norm is a root of the polynomial and not of a conjugate."""
    x, total = at(value, {}), Enclosed.of(0)
    for part in parts:
        total = total * x + at(part, {})
    return not total.sign


def _quadratic(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> list[sp.Expr]:
    if a.has(sp.CRootOf):
        b, c = (rational_below(each / a) if each.is_number else each / a for each in (b, c))
        a = sp.Integer(1)
    elif a.is_number and not a.is_Rational and not has_cosines(a):
        # Dividing first keeps surds out of the denominator under the root.
        over = plain_number(1 / a)
        b, c = (
            sp.radsimp(sp.expand(each / a if over is None else each * over), max_terms=4)
            for each in (b, c)
        )
        a = sp.Integer(1)
    discriminant = gathered(sp.expand(b * b - 4 * a * c))
    if discriminant.is_number:
        discriminant = rational_below(discriminant)
        if sign(discriminant) in (-1, None):
            return []
    elif definite(discriminant) < 0:
        return []
    if vanishing(discriminant):
        return [_tidy_root(-b / (2 * a))]
    d = _sqrt(discriminant)
    return [_tidy_root((-b + d) / (2 * a)), _tidy_root((-b - d) / (2 * a))]


def _tidy_root(value: sp.Expr) -> sp.Expr:
    if value.is_number:
        value = rational_below(value)
        return value if value.has(sp.CRootOf) else denested(value)
    return neat(value)
