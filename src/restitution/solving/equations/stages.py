"""Systems solved in stages: the fewest equations that fix their unknowns first.

Where the place of a contact is an unknown (``contacts``), few unknowns stand in each equation. The
fact at the end of the story fixes the last place by itself, this place the one before, and so on
back to what is asked. Elimination would mix them all; here each stage is solved by itself, and
what it gives is put in before the next.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from restitution.expression.enclosed import UndefinedError
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.numbers import at
from restitution.solving.algebra.polynomials import numerator
from restitution.solving.algebra.systems import Root, solve_system
from restitution.solving.story.conditions import AnyOf, Condition
from restitution.work import remembered

# Equations that are solved together in one stage, at most.
_LARGEST = 4
# The sign of an expression in letters with more operations than these is hardly plain.
_PLAIN = 60


@dataclass(frozen=True)
class _System:
    angles: frozenset[sp.Symbol]
    acute: frozenset[sp.Symbol]
    roles: Mapping[str, Role]
    conditions: tuple[sp.Expr, ...]  # not negative in what is possible


def solve_in_stages(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    angles: frozenset[sp.Symbol],
    acute: frozenset[sp.Symbol],
    roles: Mapping[str, Role],
    conditions: Sequence[Condition | AnyOf] = (),
) -> list[Root]:
    """All solutions of equations (each = 0), as ``algebra.solve_system`` gives them.

    It is asked at once where no place of contact is among the unknowns. ``conditions`` leave out,
    on the way, places of contact on the far side. Raises UnsupportedError where elimination meets
    what it cannot solve.
    """
    if not any(symbol.name.startswith("_c_") for symbol in unknowns):
        return solve_system(equations, unknowns, angles, acute, roles)
    values = tuple(
        sp.sympify(condition.value, strict=True)
        for condition in conditions
        if isinstance(condition, Condition) and condition.relation in (">", ">=")
    )
    ranked = sorted(unknowns, key=_rank)
    return _staged(list(equations), ranked, _System(angles, acute, roles, values))


def _rank(symbol: sp.Symbol) -> int:
    """Unknowns of contacts first, then other hidden ones, then letters."""
    if symbol.name.startswith(("_c_", "_w_", "_s_")):
        return 0
    return 1 if symbol.name.startswith("_") else 2


def _staged(equations: list[sp.Expr], unknowns: Sequence[sp.Symbol], system: _System) -> list[Root]:
    current = [_without_signs(equation) for equation in equations]
    current = [value for value in current if value != 0]
    free = set(unknowns)
    group = _smallest([frozenset(value.free_symbols & free) for value in current])
    if group is None:
        return _solved(current, unknowns, system)
    inside = {symbol for n in group for symbol in current[n].free_symbols & free}
    block = [x for x in unknowns if x in inside]
    assignments = _solved([current[n] for n in group], block, system)
    if any(one.leftover or len(one.values) < len(block) for one in assignments):
        return _solved(current, unknowns, system)
    rest = [value for n, value in enumerate(current) if n not in group]
    left = [x for x in unknowns if x not in inside]
    if all(x.name.startswith("_") for x in block):
        assignments = [one for one in assignments if _possible(one, block, system)] or assignments
    results: list[Root] = []
    for one in assignments:
        put = _replacing(one, block)
        if any(has_roots(value) for value in one.values.values()) and rest:
            # Roots of roots grow by being worked out: they are put in when all is solved.
            put_in_later = _later(one, block, put, rest, left, system)
            if put_in_later is not None:
                results += put_in_later
                continue
        narrowed = _System(
            system.angles,
            system.acute,
            system.roles,
            tuple(_put(condition, put) for condition in system.conditions),
        )
        for further in _staged([_put(value, put) for value in rest], left, narrowed):
            results.append(
                Root(
                    {**one.values, **further.values},
                    {**one.angles, **further.angles},
                    further.leftover,
                )
            )
    return results


def _later(
    one: Root,
    block: Sequence[sp.Symbol],
    put: Mapping[sp.Expr, sp.Expr],
    rest: list[sp.Expr],
    left: Sequence[sp.Symbol],
    system: _System,
) -> list[Root] | None:
    """The other stages with these unknowns as letters, whose values are put in at the end.

    None where that fails: where what divides is zero for these values.
    """
    results = []
    for further in _staged(rest, left, system):
        values = {name: _put(value, put) for name, value in further.values.items()}
        pairs = {name: (_put(c, put), _put(s, put)) for name, (c, s) in further.angles.items()}
        leftover = tuple(_put(value, put) for value in further.leftover)
        if any(value.has(sp.zoo, sp.nan, sp.oo) for value in values.values()):
            return None
        if any(x.name in values and _is_negative(values[x.name]) for x in system.acute):
            continue  # as a negative tangent of an acute angle is left out where it is a number
        results.append(Root({**one.values, **values}, {**one.angles, **pairs}, leftover))
    return results


def has_roots(x: sp.Expr) -> bool:
    """Whether square roots stand in an expression."""
    return any(atom.exp.is_Rational and not atom.exp.is_Integer for atom in x.atoms(sp.Pow))


def by_nested_roots(values: Mapping[str, sp.Expr], start: str = "") -> bool:
    """Whether places of contact were found, and of the values some hold roots of roots.

    Of those whose names begin with ``start``. They are too unwieldy to be told again.
    """
    return any(name.startswith("_c_") for name in values) and any(
        has_roots(power.base)
        for name, value in values.items()
        if name.startswith(start)
        for power in value.atoms(sp.Pow)
        if power.exp.is_Rational and not power.exp.is_Integer
    )


def _solved(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], system: _System
) -> list[Root]:
    own = frozenset(unknowns)
    return solve_system(equations, unknowns, system.angles & own, system.acute & own, system.roles)


def _smallest(inside: Sequence[frozenset[sp.Symbol]]) -> tuple[int, ...] | None:
    """The first of the smallest groups of equations with as many unknowns as equations."""
    usable = [n for n, letters in enumerate(inside) if letters]
    for size in range(1, min(_LARGEST, len(usable)) + 1):
        for group in combinations(usable, size):
            if len(frozenset[sp.Symbol]().union(*(inside[n] for n in group))) == size:
                return group
    return None


@remembered(512)
def _without_signs(equation: sp.Expr) -> sp.Expr:
    """An equation as a polynomial, without factors that are positive."""
    above = numerator(equation)
    if above == 0 or not above.free_symbols:
        return above
    terms = sp.Mul.make_args(sp.factor_terms(above))
    return sp.expand(sp.Mul(*[term for term in terms if not term.is_positive]))


def _replacing(one: Root, block: Sequence[sp.Symbol]) -> dict[sp.Expr, sp.Expr]:
    put: dict[sp.Expr, sp.Expr] = {}
    for symbol in block:
        put[symbol] = one.values[symbol.name]
        if symbol.name in one.angles:
            c, s = one.angles[symbol.name]
            put |= {sp.cos(symbol): c, sp.sin(symbol): s, sp.tan(symbol): s / c}
    return put


def _put(x: sp.Expr, values: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    return sp.sympify(x.xreplace(values), strict=True)


def _possible(one: Root, block: Sequence[sp.Symbol], system: _System) -> bool:
    """Whether no condition is plainly broken by these values, whatever the other letters are."""
    put = _replacing(one, block)
    for name, value in one.values.items():
        role = system.roles.get(name)
        if role is not None and role.low == 0 and _is_negative(value):
            return False
    for condition in system.conditions:
        if condition.free_symbols.isdisjoint(block):
            continue
        value = _put(condition, put)
        if _is_negative(value):
            return False
    return True


def _is_negative(value: sp.Expr) -> bool:
    if value.free_symbols:
        return bool(sp.count_ops(value) < _PLAIN and neat(value).is_negative)
    try:
        return at(value, {}).sign < 0
    except UndefinedError:
        return False


def fixed_besides(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> frozenset[str]:
    """Letters of which one is fixed too, as there are more equations than they have unknowns.

    Only where places of contact are unknown is that told by the shape of the equations: by which
    unknowns stand in which. Empty where none is, or where no letter would serve.
    """
    if not any(symbol.name.startswith("_c_") for symbol in unknowns):
        return frozenset()
    current = [value for value in map(_without_signs, equations) if value != 0]
    free = set(unknowns)
    every = {symbol for value in current for symbol in value.free_symbols}
    most = _matched(current, free)
    if most == len([value for value in current if value.free_symbols]):
        return frozenset()
    return frozenset(x.name for x in every - free if _matched(current, free | {x}) > most)


def _matched(equations: Sequence[sp.Expr], free: set[sp.Symbol]) -> int:
    """How many equations can have an unknown each to themselves."""
    owner: dict[sp.Symbol, int] = {}

    def placed(n: int, seen: set[sp.Symbol]) -> bool:
        for x in sorted(equations[n].free_symbols & free, key=lambda s: s.name):
            if x not in seen:
                seen.add(x)
                if x not in owner or placed(owner[x], seen):
                    owner[x] = n
                    return True
        return False

    return sum(placed(n, set()) for n in range(len(equations)))
