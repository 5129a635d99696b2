"""Systems of equations made polynomial, and solved by elimination with every root kept.

Angles that are sought become tangents, or pairs of cosine and sine; roots of expressions with
unknowns are squared away. What is found satisfies the polynomials; whether it also satisfies the
facts as they were told, signs and ranges, is for the caller to check.

Equations are made polynomial in ``clearing``; degrees, coefficients and factors come from
``polynomials``, over the rationals and in letters of which nothing is assumed. All work is counted
before it is begun: what is too hard is refused after the same steps on every machine.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import field

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.exact import in_sines
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra.clearing import (
    Known,
    angle_of,
    by_tangent,
    in_range,
    least_denominator,
    polynomial_of,
    trig_in,
    without_bars,
)
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.polynomials import (
    TOO_HARD,
    TooLargeError,
    afford,
    coefficients,
    degree,
    factors,
    numerator,
    terms_in,
)
from restitution.solving.algebra.real_roots import roots, square_roots
from restitution.solving.algebra.resultants import resultant
from restitution.solving.algebra.signs import definite, sign
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
    current = [without_bars(equation, known) for equation in equations]
    generators: list[sp.Symbol] = []
    pairs: dict[sp.Symbol, tuple[sp.Symbol, sp.Symbol]] = {}
    tangents: dict[sp.Symbol, sp.Symbol] = {}
    scale: dict[sp.Symbol, int] = {}
    for symbol in sought:
        if symbol not in angles or not any(value.has(symbol) for value in current):
            continue
        q = least_denominator(current, symbol)
        scale[symbol] = q
        sign = {"positive": True} if symbol in acute or q > 1 else {"real": True}
        c = sp.Symbol(f"cos_{symbol.name}", **sign)
        s = sp.Symbol(f"sin_{symbol.name}", **(sign if symbol in acute else {"real": True}))
        half = symbol / q
        current = [trig_in(in_sines(value), symbol, half, c, s) for value in current]
        pairs[symbol] = (c, s)
    # Roots and sizes of what is unknown are squared away.
    everything = set(sought) | {x for pair in pairs.values() for x in pair}
    polynomials = [polynomial_of(value, everything) for value in current]
    for symbol, (c, s) in pairs.items():
        if any(polynomial.has(symbol) for polynomial in polynomials):
            raise UnsupportedError(
                f"the angle {symbol.name} stands both as itself and under a sine"
            )
        if scale[symbol] == 1 and symbol in acute:
            t = sp.Symbol(f"tan_{symbol.name}", positive=True)
            rewritten = [by_tangent(polynomial, c, s, t) for polynomial in polynomials]
            if all(value is not None for value in rewritten):
                polynomials = [value for value in rewritten if value is not None]
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
                values[symbol.name] = in_range(q * angle_of(c, s, roles), roles[symbol.name])
                known_angles[symbol.name] = _multiple_of(q, c, s)
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


def _multiple_of(q: int, c: sp.Expr, s: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The cosine and sine of a multiple of an angle of which these are given."""
    if q == 1:
        return c, s
    x = sp.Dummy("cosine")
    whole = (sp.chebyshevt(q, x), s * sp.chebyshevu(q - 1, x))
    multiple_c, multiple_s = (neat(sp.expand(value.xreplace({x: c}))) for value in whole)
    return multiple_c, multiple_s


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
    others = [value for value in simple if value is not equation] + rest
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
            for candidate in square_roots(value, x):
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
        for equation in equations
        if equation.has(x)
        for power, c in enumerate(reversed(coefficients(equation, x)))
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
    for other in with_x:
        r = resultant(equation, other, x)
        if r == 0:
            raise UnsupportedError("equations with a common part")
        without.append(r)
    results = []
    for values, rest in _reduce(without, left, assignment, known):
        candidates = [numerator(value.xreplace(values)) for value in (equation, *with_x)]
        candidates = [candidate for candidate in candidates if candidate.has(x)] or candidates
        simplest = min(candidates, key=lambda e: degree(e, x) if e.has(x) else 99)
        if not simplest.has(x):
            continue
        for value in roots(simplest, x):
            if all(known.zero(candidate.xreplace({x: value})) for candidate in candidates):
                results.append(({**values, x: neat(value)}, rest))
    return results
