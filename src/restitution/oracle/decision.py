"""Polynomial real arithmetic decided by Z3, which is loaded when it is first asked.

A question is the facts together with the contrary of a claim: where no values satisfy it, the
claim is proved; values that do refute it. Before asking, letters that only set a scale are 1, and
factors whose sign is plain are left out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement

from restitution.oracle.formula import All, Formula, Relation, Some
from restitution.oracle.polynomials import Polynomials, TooLargeError

MILLISECONDS = 2000
"""The outer guard of one question; what is too large is not asked at all."""

MOST_GENERATORS = 14
MOST_DEGREE = 40
MOST_MONOMIALS = 1500


@dataclass(frozen=True)
class Reply:
    """What Z3 says: no values satisfy the formula, some do (``model``), or it does not know.

    ``model`` gives each generator a SymPy number.
    """

    satisfiable: Literal["no", "yes", "unknown"]
    model: Mapping[str, sp.Expr] | None = None


UNKNOWN = Reply("unknown")


@dataclass(frozen=True)
class _Condition:
    """A polynomial in some relation to zero, factors of plain sign left out."""

    polynomial: PolyElement
    operator: str


_Tree = Any  # _Condition | bool | ("and" | "or", list of trees)


def satisfy(world: Polynomials, formulas: Sequence[Formula]) -> Reply:
    """Whether some values of the letters satisfy all formulas."""
    try:
        trees = [_conditions(world, each) for each in formulas]
    except TooLargeError:
        return UNKNOWN
    tree = _simplified(("and", trees))
    if tree is False:
        return Reply("no")
    used = _used(world, tree)
    scale = _scale(world, used, tree)
    if not _worth_asking(world, used, tree):
        return UNKNOWN
    return _ask(world, tree, used, scale)


def _conditions(world: Polynomials, formula: Formula) -> _Tree:
    match formula:
        case Relation():
            return _condition(world, formula)
        case All(parts):
            return ("and", [_conditions(world, each) for each in parts])
        case Some(parts):
            return ("or", [_conditions(world, each) for each in parts])


def _condition(world: Polynomials, relation: Relation) -> _Tree:
    above, below = world.quotient(relation.value)
    defined: list[_Tree] = []
    sign = 1
    rest: list[PolyElement] = []
    powers: dict[PolyElement, int] = {}
    for polynomial, weight in ((above, 1), (below, -1)):
        for factor, power in world.factors(polynomial):
            powers[factor] = powers.get(factor, 0) + power
            if weight < 0 and world.sign(factor) is None:
                defined.append(_Condition(factor, "!="))
    zero: list[_Tree] = []
    for factor, power in powers.items():
        if not factor:
            return _settled(relation.operator, 0, defined)
        plain = world.sign(factor)
        if plain is not None:
            sign *= plain ** (power % 2) if plain else 0
        elif power % 2:
            rest.append(factor)
        else:
            zero.append(_Condition(factor, "="))
    if not rest and not zero:
        return _settled(relation.operator, sign, defined)
    product = world.ring.ground_new(QQ(sign))
    for each in rest:
        product = world._product(product, each)
    touching = [*([_Condition(each, "=") for each in rest]), *zero]
    touching = [each for each in touching if _Condition(each.polynomial, "!=") not in defined]
    apart = [_Condition(each.polynomial, "!=") for each in zero]
    match relation.operator:
        case "=":
            own: _Tree = ("or", touching)
        case "!=":
            own = ("and", [_Condition(each.polynomial, "!=") for each in touching])
        case ">":
            own = ("and", [_Condition(product, ">"), *apart] if rest else [sign > 0, *apart])
        case _:
            inner = _Condition(product, ">=") if rest else sign > 0
            own = ("or", [inner, *[each for each in zero if each in touching]])
    return ("and", [*defined, own])


def _settled(operator: str, sign: int, defined: list[_Tree]) -> _Tree:
    holds = {"=": sign == 0, "!=": sign != 0, ">": sign > 0, ">=": sign >= 0}[operator]
    return ("and", [*defined, holds])


def _simplified(tree: _Tree) -> _Tree:
    if isinstance(tree, bool | _Condition):
        return tree
    kind, parts = tree
    neutral = kind == "and"
    kept: list[_Tree] = []
    for part in parts:
        each = _simplified(part)
        if isinstance(each, bool):
            if each is not neutral:
                return not neutral
        elif isinstance(each, tuple) and each[0] == kind:
            kept.extend(each[1])
        else:
            kept.append(each)
    if not kept:
        return neutral
    return kept[0] if len(kept) == 1 else (kind, kept)


def _polynomials(tree: _Tree) -> list[PolyElement]:
    if isinstance(tree, _Condition):
        return [tree.polynomial]
    if isinstance(tree, bool):
        return []
    return [each for part in tree[1] for each in _polynomials(part)]


def _names(world: Polynomials, polynomial: PolyElement) -> set[str]:
    return {
        name
        for n, (_, name) in enumerate(world._order)
        if any(monomial[n] for monomial in polynomial.monoms())
    }


def _used(world: Polynomials, tree: _Tree) -> list[str]:
    """The generators of a question, with those that define them."""
    used: set[str] = set()
    for each in _polynomials(tree):
        used |= _names(world, each)
    while True:
        before = len(used)
        for each in (*world.relations, *(bound.polynomial for bound in world.bounds)):
            names = _names(world, each)
            if names & used:
                used |= names
        if len(used) == before:
            return [name for _, name in world._order if name in used]


def _worth_asking(world: Polynomials, used: Sequence[str], tree: _Tree) -> bool:
    polynomials = _polynomials(tree)
    return (
        len(used) <= MOST_GENERATORS
        and sum(len(each) for each in polynomials) <= MOST_MONOMIALS
        and all(sum(each.degrees()) <= MOST_DEGREE for each in polynomials if each)
    )


def _scale(world: Polynomials, used: Sequence[str], tree: _Tree) -> list[str]:
    """Positive letters that may be taken as 1, as only ratios to them matter."""
    order = [name for _, name in world._order]
    places = [order.index(name) for name in used]
    rows: list[list[Fraction]] = []
    every = [*_polynomials(tree), *world.relations, *(b.polynomial for b in world.bounds)]
    for polynomial in every:
        monomials = polynomial.monoms()
        if not monomials or not _names(world, polynomial) <= set(used):
            continue
        first = monomials[0]
        for other in monomials[1:]:
            row = [Fraction(other[n] - first[n]) for n in places]
            if any(row):
                rows.append(row)
    for name, (low, high, *_rest) in world.between.items():
        if name in used and (low or high is not None):
            rows.append([Fraction(int(name == each)) for each in used])
    # A letter is free to be 1 if no pivot is needed for it: weights are what the rows leave open.
    chosen: list[str] = []
    for n, name in enumerate(used):
        if world.senses[name] != "+" or name not in world.letters.values():
            continue
        unit = [Fraction(int(k == n)) for k in range(len(used))]
        if _rank([*rows, unit]) > _rank(rows):
            rows.append(unit)
            chosen.append(name)
    return chosen


def _rank(rows: Sequence[Sequence[Fraction]]) -> int:
    left = [list(row) for row in rows]
    rank = 0
    for column in range(len(left[0]) if left else 0):
        pivot = next((row for row in left if row[column]), None)
        if pivot is None:
            continue
        left = [
            [a - b * row[column] / pivot[column] for a, b in zip(row, pivot, strict=True)]
            for row in left
            if row is not pivot
        ]
        rank += 1
    return rank


def _ask(world: Polynomials, tree: _Tree, used: Sequence[str], scale: Sequence[str]) -> Reply:
    import z3

    context = z3.Context()
    solver = z3.SolverFor("QF_NRA", ctx=context)
    solver.set("timeout", MILLISECONDS)
    places = [n for n, (_, name) in enumerate(world._order) if name in used]
    numbers = {world._order[n][1]: z3.Real(f"v{n}", ctx=context) for n in places}
    named = [(n, numbers[world._order[n][1]]) for n in places]

    def value(polynomial: PolyElement) -> Any:
        total = z3.RealVal(0, ctx=context)
        for monomial, coefficient in polynomial.terms():
            term = z3.RealVal(str(coefficient), ctx=context)
            for n, number in named:
                for _ in range(monomial[n]):
                    term = term * number
            total = total + term
        return total

    def statement(part: _Tree) -> Any:
        if isinstance(part, bool):
            return z3.BoolVal(part, ctx=context)
        if isinstance(part, _Condition):
            number = value(part.polynomial)
            return {
                "=": lambda: number == 0,
                "!=": lambda: number != 0,
                ">": lambda: number > 0,
                ">=": lambda: number >= 0,
            }[part.operator]()
        join = z3.And if part[0] == "and" else z3.Or
        return join(*[statement(each) for each in part[1]])

    for name in used:
        number = numbers[name]
        if name in scale:
            solver.add(number == 1)
        elif world.senses[name] == "+":
            solver.add(number > 0)
        elif world.senses[name] == "0+":
            solver.add(number >= 0)
        low, high, closed_low, closed_high = world.between.get(name, (None, None, False, False))
        if low is not None and (low != 0 or world.senses[name] == "real"):
            end = z3.RealVal(str(low), ctx=context)
            solver.add(number >= end if closed_low else number > end)
        if high is not None:
            end = z3.RealVal(str(high), ctx=context)
            solver.add(number <= end if closed_high else number < end)
    for relation in world.relations:
        if _names(world, relation) <= set(used):
            solver.add(value(relation) == 0)
    for bound in world.bounds:
        if _names(world, bound.polynomial) <= set(used):
            number = value(bound.polynomial)
            solver.add(number > 0 if bound.strict else number >= 0)
    solver.add(statement(tree))
    answer = solver.check()
    if answer == z3.unsat:
        return Reply("no")
    if answer != z3.sat:
        return UNKNOWN
    model = solver.model()
    return Reply(
        "yes",
        {
            name: _exact(model.eval(number, model_completion=True))
            for name, number in numbers.items()
        },
    )


def _exact(number: Any) -> sp.Expr:
    """A value of a model as a SymPy number."""
    if hasattr(number, "numerator_as_long"):
        return sp.Rational(number.numerator_as_long(), number.denominator_as_long())
    x = sp.Dummy("x")
    coefficients = [
        sp.Rational(each.numerator_as_long(), each.denominator_as_long()) for each in number.poly()
    ]
    polynomial = sp.Poly(list(reversed(coefficients)), x)
    roots = polynomial.real_roots(multiple=False)
    return roots[number.index() - 1][0]
