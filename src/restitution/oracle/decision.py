"""Polynomial real arithmetic decided by Z3, which is loaded when it is first asked.

A question is the facts together with the contrary of a claim: where no values satisfy it, the
claim is proved; values that do refute it. Before asking, letters that only set a scale are 1, and
factors whose sign is plain are left out.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping, Sequence
from math import gcd
from typing import Any, Literal

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement

from restitution.oracle.formula import All, Formula, Relation, Some
from restitution.oracle.polynomials import Polynomials, TooLargeError
from restitution.records import dataclass
from restitution.work import seconds_left, spend

STEPS = 1_200_000
"""The work of one attempt at a question, as Z3 counts it: about half a second where numbers are
small. Four fifths of it are the most that an answer takes in the tests."""

SECONDS = 1.0
"""The outer guard of an attempt, as its numbers may grow beyond all bounds: time of the processor,
which is no more on a busy machine. What is too large is not asked at all, and an answer comes in a
quarter of that."""

# An attempt that had so much of its time is not made again, and the next one is so much longer.
_NEARLY = 0.8
_LEAST_TIMES_LONGER, _MOST_TIMES_LONGER = 1.5, 8.0

MOST_GENERATORS = 14
MOST_DEGREE = 40
MOST_MONOMIALS = 1500
MOST_BITS = 128
# Roots beside numbers of which only bounds are known: with five or more, none of the questions
# that were met was decided within the guard; with two, some are.
MOST_ROOTS_OF_BOUNDS = 4
# With "for all" and "there is" it becomes hard much sooner.
MOST_QUANTIFIED = 10
MOST_EFFORT = 50


@dataclass(frozen=True)
class Reply:
    """What Z3 says: no values satisfy the formula, some do (``model``), or it does not know.

    ``model`` gives each generator a SymPy number, ``reason`` why nothing is known.
    """

    satisfiable: Literal["no", "yes", "unknown"]
    model: Mapping[str, sp.Expr] | None = None
    reason: str = ""


UNKNOWN = Reply("unknown", None, "too large")
LATE = "timeout"
"""The reason of what took all its seconds."""


@dataclass(frozen=True)
class _Condition:
    """A polynomial in some relation to zero, factors of plain sign left out."""

    polynomial: PolyElement
    operator: str


_Tree = Any  # _Condition | bool | ("and" | "or", list of trees)


def satisfy(world: Polynomials, formulas: Sequence[Formula]) -> Reply:
    """Whether some values of the letters satisfy all formulas."""
    try:
        trees = [_conditions(world, formula) for formula in formulas]
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
            return ("and", [_conditions(world, part) for part in parts])
        case Some(parts):
            return ("or", [_conditions(world, part) for part in parts])


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
    for value in rest:
        product = world._product(product, value)
    touching = [*([_Condition(value, "=") for value in rest]), *zero]
    touching = [value for value in touching if _Condition(value.polynomial, "!=") not in defined]
    apart = [_Condition(value.polynomial, "!=") for value in zero]
    match relation.operator:
        case "=":
            own: _Tree = ("or", touching)
        case "!=":
            own = ("and", [_Condition(value.polynomial, "!=") for value in touching])
        case ">":
            own = ("and", [_Condition(product, ">"), *apart] if rest else [sign > 0, *apart])
        case _:
            inner = _Condition(product, ">=") if rest else sign > 0
            own = ("or", [inner, *[value for value in zero if value in touching]])
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
        simple = _simplified(part)
        if isinstance(simple, bool):
            if simple is not neutral:
                return not neutral
        elif isinstance(simple, tuple) and simple[0] == kind:
            kept.extend(simple[1])
        else:
            kept.append(simple)
    if not kept:
        return neutral
    return kept[0] if len(kept) == 1 else (kind, kept)


def _polynomials(tree: _Tree) -> list[PolyElement]:
    if isinstance(tree, _Condition):
        return [tree.polynomial]
    if isinstance(tree, bool):
        return []
    return [polynomial for part in tree[1] for polynomial in _polynomials(part)]


def _names(world: Polynomials, polynomial: PolyElement) -> set[str]:
    return {
        name
        for n, name in enumerate(world.names)
        if any(monomial[n] for monomial in polynomial.monoms())
    }


def _used(world: Polynomials, tree: _Tree) -> list[str]:
    """The generators of a question, with those that define them."""
    used: set[str] = set()
    for polynomial in _polynomials(tree):
        used |= _names(world, polynomial)
    while True:
        before = len(used)
        for value in (*world.relations, *(bound.polynomial for bound in world.bounds)):
            names = _names(world, value)
            if names & used:
                used |= names
        if len(used) == before:
            return [name for name in world.names if name in used]


def _worth_asking(world: Polynomials, used: Sequence[str], tree: _Tree) -> bool:
    polynomials = _polynomials(tree)
    roots = sum(name.startswith("root") for name in used)
    return (
        len(used) <= MOST_GENERATORS
        and not (world.loose and roots > MOST_ROOTS_OF_BOUNDS)
        and sum(len(polynomial) for polynomial in polynomials) <= MOST_MONOMIALS
        and all(
            sum(polynomial.degrees()) <= MOST_DEGREE for polynomial in polynomials if polynomial
        )
    )


def _scale(world: Polynomials, used: Sequence[str], tree: _Tree) -> list[str]:
    """Positive letters that may be taken as 1, as only ratios to them matter."""
    places = [world.names.index(name) for name in used]
    span = _Span()
    every = [*_polynomials(tree), *world.relations, *(b.polynomial for b in world.bounds)]
    for polynomial in every:
        monomials = polynomial.monoms()
        if not monomials or not _names(world, polynomial) <= set(used):
            continue
        first = monomials[0]
        for other in monomials[1:]:
            span.add(tuple(other[n] - first[n] for n in places))
    for name, (low, high, *_rest) in world.between.items():
        if name in used and (low or high is not None):
            span.add(tuple(int(name == letter) for letter in used))
    # A letter is free to be 1 if no pivot is needed for it: weights are what the rows leave open.
    return [
        name
        for n, name in enumerate(used)
        if world.senses[name] == "+"
        and name in world.letters.values()
        and span.add(tuple(int(k == n) for k in range(len(used))))
    ]


def _joined(world: Polynomials, used: Sequence[str], tree: _Tree) -> dict[str, list[str]]:
    """Roots of whole numbers that stand in products with the same others alone, by the first.

    The root of a product of seven primes is one letter then, and not seven.
    """
    own = {}
    for relation in world.relations:
        names = _names(world, relation)
        if len(names) == 1 and set(relation.degrees()) <= {0, 2} and len(relation) == 2:
            (name,) = names
            if name not in world.letters.values() and world.senses[name] == "0+":
                own[name] = relation
    own = {name: value for name, value in own.items() if name in used and name not in world.between}
    others = [relation for relation in world.relations if relation not in own.values()]
    every = [*_polynomials(tree), *others, *(bound.polynomial for bound in world.bounds)]
    monomials = [value for polynomial in every for value in polynomial.monoms()]
    groups: dict[tuple[int, ...], list[str]] = {}
    for name in own:
        n = world.names.index(name)
        groups.setdefault(tuple(monomial[n] for monomial in monomials), []).append(name)
    return {group[0]: group for group in groups.values() if len(group) > 1}


class _Span:
    """The span of rows of whole numbers, each reduced once."""

    def __init__(self) -> None:
        self._seen: set[tuple[int, ...]] = set()
        self._basis: list[tuple[int, tuple[int, ...]]] = []

    def add(self, row: tuple[int, ...]) -> bool:
        """Takes up a row; False where the span had it already."""
        if row in self._seen:
            return False
        self._seen.add(row)
        for column, other in self._basis:
            if row[column]:
                row = tuple(
                    a * other[column] - b * row[column] for a, b in zip(row, other, strict=True)
                )
        pivot = next((n for n, value in enumerate(row) if value), None)
        if pivot is None:
            return False
        divisor = gcd(*row)
        self._basis.append((pivot, tuple(value // divisor for value in row)))
        return True


def covers(
    world: Polynomials, facts: Sequence[Formula], claim: Formula, free: frozenset[str]
) -> Literal["yes", "no", "unknown"]:
    """Whether for all values that satisfy the facts some of the free letters satisfy the claim."""
    try:
        outer = _simplified(("and", [_conditions(world, fact) for fact in facts]))
        inner = _simplified(_conditions(world, claim))
    except TooLargeError:
        return "unknown"
    both = ("and", [outer, inner])
    used = _used(world, both)
    degree = max(
        (sum(polynomial.degrees()) for polynomial in _polynomials(both) if polynomial), default=0
    )
    if len(used) > MOST_QUANTIFIED or len(used) * degree > MOST_EFFORT:
        return "unknown"
    import z3

    question = _Question(world, used, [])
    bound = [name for name in used if world.depends(name, free)]
    rest = [name for name in used if name not in bound]
    outside = z3.And(question.statement(outer), *question.definitions(rest, rest))
    inside = z3.And(question.statement(inner), *question.definitions(bound, used))
    some = z3.Exists([question.numbers[name] for name in bound], inside) if bound else inside
    every = z3.Implies(outside, some)
    if rest:
        every = z3.ForAll([question.numbers[name] for name in rest], every)
    answer, _, _ = _answer(z3.Tactic("nlqsat", ctx=question.context), [every])
    return {"sat": "yes", "unsat": "no"}.get(answer, "unknown")  # type: ignore[return-value]


def _ask(world: Polynomials, tree: _Tree, used: Sequence[str], scale: Sequence[str]) -> Reply:
    import z3

    question = _Question(world, used, scale, _joined(world, used, tree))
    formulas = [*question.definitions(used, used), question.statement(tree)]
    # The decision procedure itself takes half as long as with what Z3 does before it elsewhere,
    # which finds more where there is much to decide.
    own = z3.Tactic("qfnra-nlsat", ctx=question.context)
    before = [z3.Tactic(name, ctx=question.context) for name in ("simplify", "propagate-values")]
    inlined = z3.With(own, inline_vars=True)
    for tactic in (own, z3.Then(*before, inlined, ctx=question.context)):
        answer, reason, solver = _answer(tactic, formulas)
        if answer != "unknown" or reason == LATE:
            break
    if answer == "unsat":
        return Reply("no")
    if answer != "sat":
        return Reply("unknown", None, reason)
    model = solver.model()
    values = {
        name: _exact(model.eval(number, model_completion=True))
        for name, number in question.numbers.items()
    }
    return Reply("yes", values)


def _answer(tactic: Any, formulas: Sequence[Any]) -> tuple[str, str, Any]:
    """What a tactic makes of formulas, why it does not know, and its solver, which has a model."""
    solver = tactic.solver()
    solver.set("rlimit", STEPS)
    solver.add(*formulas)
    seconds = SECONDS
    while True:
        # The clock of Z3 is that on the wall; where others had the processor, it is set anew.
        left = seconds_left()
        wall = seconds if left is None else max(0.0, min(seconds, left))
        solver.set("timeout", 1 + int(1000 * wall))
        start, began = time.monotonic(), time.thread_time()
        answer, reason = checked(solver)
        # Had a limit of time ended it, this raises its error.
        spend(0)
        ended = answer == "unknown" and time.monotonic() - start >= wall
        if not ended:
            return answer, reason, solver
        own = time.thread_time() - began
        if own >= _NEARLY * SECONDS:
            return answer, LATE, solver
        # As long as it takes by the share of the processor that there was.
        seconds *= min(_MOST_TIMES_LONGER, max(_LEAST_TIMES_LONGER, SECONDS / max(own, 0.001)))


def checked(solver: Any) -> tuple[str, str]:
    """What a solver of Z3 answers (sat, unsat or unknown), and why it does not know."""
    answer = str(solver.check())
    return answer, solver.reason_unknown() if answer == "unknown" else ""


def limit_memory(megabytes: int) -> None:
    """Bound the memory of Z3 in this process, which is for whoever runs the process to say."""
    import z3

    z3.set_param("memory_max_size", megabytes)


class _Question:
    """Generators as numbers of Z3, in a context of their own."""

    def __init__(
        self,
        world: Polynomials,
        used: Sequence[str],
        scale: Sequence[str],
        joined: Mapping[str, Sequence[str]] | None = None,
    ) -> None:
        import z3

        self.world, self.scale, self.joined = world, scale, joined or {}
        left_out = {name for group in self.joined.values() for name in group[1:]}
        used = [name for name in used if name not in left_out]
        self.context = z3.Context()
        self.numbers: dict[str, Any] = {}
        self._places: list[tuple[int, Any]] = []
        for n, name in enumerate(world.names):
            if name in used:
                self.numbers[name] = z3.Real(f"v{n}", ctx=self.context)
                self._places.append((n, self.numbers[name]))

    def value(self, polynomial: PolyElement) -> Any:
        """A polynomial as a term."""
        total = self._number(0)
        for monomial, coefficient in polynomial.terms():
            term = self._number(coefficient)
            for n, number in self._places:
                for _ in range(monomial[n]):
                    term = term * number
            total = total + term
        return total

    def _number(self, value: Any) -> Any:
        import z3

        return z3.RealVal(str(value), ctx=self.context)

    def statement(self, tree: _Tree) -> Any:
        """A tree of conditions as a formula."""
        import z3

        if isinstance(tree, bool):
            return z3.BoolVal(tree, ctx=self.context)
        if isinstance(tree, _Condition):
            return _related(self.value(tree.polynomial), tree.operator)
        join = z3.And if tree[0] == "and" else z3.Or
        return join(*[self.statement(value) for value in tree[1]])

    def definitions(self, names: Iterable[str], known: Iterable[str]) -> list[Any]:
        """What these generators are, by their signs, bounds and relations among the known ones."""
        world, names, known = self.world, set(names), set(known)
        formulas = []
        for name in sorted(names & set(self.numbers)):
            number = self.numbers[name]
            if name in self.scale:
                formulas.append(number == 1)
            elif world.senses[name] != "real":
                formulas.append(_related(number, ">" if world.senses[name] == "+" else ">="))
            low, high, closed_low, closed_high = world.between.get(name, (None, None, False, False))
            if low is not None and (low != 0 or world.senses[name] == "real"):
                formulas.append(_related(number - self._number(low), ">=" if closed_low else ">"))
            if high is not None:
                formulas.append(_related(self._number(high) - number, ">=" if closed_high else ">"))
        defining = [(relation, "=") for relation in world.relations] + [
            (bound.polynomial, ">" if bound.strict else ">=") for bound in world.bounds
        ]
        grouped = {name for group in self.joined.values() for name in group}
        for first, group in self.joined.items():
            square = QQ(1)
            for relation in world.relations:
                if len(own := _names(world, relation)) == 1 and own <= set(group):
                    square *= -relation.coeff(1) / relation.LC
            formulas.append(self.numbers[first] * self.numbers[first] == self._number(square))
        for polynomial, operator in defining:
            own = _names(world, polynomial)
            if len(own) == 1 and own <= grouped:
                continue
            if own & names and own <= known:
                formulas.append(_related(self.value(polynomial), operator))
        return formulas


def _related(number: Any, operator: str) -> Any:
    if operator == "=":
        return number == 0
    if operator == "!=":
        return number != 0
    return number > 0 if operator == ">" else number >= 0


def _exact(number: Any) -> sp.Expr:
    """A value of a model as a SymPy number.

    Raises TooLargeError for a root of a polynomial with long numbers: SymPy factors these.
    """
    if hasattr(number, "numerator_as_long"):
        return sp.Rational(number.numerator_as_long(), number.denominator_as_long())
    x = sp.Dummy("x")
    coefficients = [
        sp.Rational(value.numerator_as_long(), value.denominator_as_long())
        for value in number.poly()
    ]
    polynomial = sp.Poly(list(reversed(coefficients)), x)
    if any(max(abs(c.p), c.q).bit_length() > MOST_BITS for c in coefficients):
        raise TooLargeError("a root of a polynomial with long numbers")
    roots = polynomial.real_roots(multiple=False)
    return roots[number.index() - 1][0]
