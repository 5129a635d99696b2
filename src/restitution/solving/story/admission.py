"""Which values of the letters left free a solution admits, and why not the others.

The story is told once with what was found put in. What the physics and the facts then ask for are
formulas in the letters that stay free: the oracle decides whether any values satisfy them, and
points are tried in compiled form.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import sympy as sp

from restitution.exact.symbols import atoms_in, symbols_in
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle import (
    BeyondError,
    Formula,
    Oracle,
    Program,
    Relation,
    Some,
    holds_with,
    joined,
    negation,
    relations,
)
from restitution.oracle.points import Value
from restitution.oracle.roles import COEFFICIENT, Role
from restitution.records import dataclass
from restitution.solving.algebra.forms import bars_of, tidy
from restitution.solving.algebra.numbers import sign_at
from restitution.solving.algebra.signs import sign as sign_of
from restitution.solving.story.conditions import AnyOf, Condition, Equation

EQUATION = ("a fact", "equation")
"""Why a point is refused at which an equation does not hold."""

COEFFICIENT_RULE = "a coefficient of restitution lies in [0, 1]"

# Of more than these it takes long to find the few that clash.
MOST_DEMANDS = 12

Requirement = Equation | Condition | AnyOf


@dataclass(frozen=True)
class Demand:
    """Something that the letters left free have to satisfy; else ``reason``, of some kind."""

    formula: Formula
    reason: str
    kind: str


def formula_of(need: Condition | AnyOf) -> Formula:
    """A condition as a formula."""
    if isinstance(need, AnyOf):
        return Some(tuple(formula_of(option) for option in need.options))
    return Relation(sp.sympify(need.value, strict=True), need.relation)


@dataclass
class Admission:
    """What is asked of the free letters of one solution.

    ``equations`` vanish if the solution is one. ``assumed`` are signs that were taken for granted
    while the story was told: where one is different, the rest says nothing.
    """

    roles: Mapping[str, Role]
    demands: tuple[Demand, ...]
    equations: tuple[sp.Expr, ...]
    assumed: tuple[Formula, ...] = ()

    @cached_property
    def oracle(self) -> Oracle:
        """Decides what follows wherever the demands are satisfied."""
        return Oracle(
            self.roles, tuple(dict.fromkeys((*(d.formula for d in self.demands), *self.assumed)))
        )

    @cached_property
    def _solved(self) -> Oracle:
        """Decides what follows wherever this is a solution; sizes of a certain sign are no bars."""
        facts = [
            Relation(self._without_bars(relation.value), relation.operator)
            for demand in self.demands
            if not isinstance(demand.formula, Some)
            for relation in relations(demand.formula)
        ]
        facts += [Relation(self._without_bars(value), "=") for value in self.equations]
        return Oracle(self.roles, tuple(dict.fromkeys((*facts, *self.assumed))))

    def _without_bars(self, value: sp.Expr) -> sp.Expr:
        """A value without the sizes |x| of which the sign follows from the demands."""
        while known := bars_of(value, self.oracle):
            value = tidy(value.xreplace(known))
        return value

    def is_zero(self, value: sp.Expr) -> bool:
        """Whether a value is zero wherever this is a solution."""
        try:
            return bool(self._solved.decide(Relation(self._without_bars(value), "=")))
        except BeyondError:
            return False

    @cached_property
    def _program(self) -> tuple[tuple[sp.Expr, ...], Program]:
        values = dict.fromkeys(
            relation.value
            for formula in (*(d.formula for d in self.demands), *self.assumed)
            for relation in relations(formula)
        )
        every = tuple(values)
        return every, Program.of((*every, *self.equations))

    @cached_property
    def _constants(self) -> dict[int, int]:
        """The exact signs, by their places, of what is a number and looks like zero."""
        every = (*self._program[0], *self.equations)
        numbers = [x if not symbols_in(x) else sp.Integer(1) for x in every]
        seen = Program.of(numbers).near_signs({})
        exactly = ((n, sign_of(x)) for n, x in enumerate(numbers) if seen[n] == 0)
        return {n: own for n, own in exactly if own is not None}

    def objection(self, point: Mapping[str, Enclosed | Value]) -> tuple[str, str] | None:
        """Why the letters may not have these values, as (reason, kind); None if they may.

        Raises UndefinedError where something has no real value, and LookupError where the story
        goes another way than it was told.
        """
        every, program = self._program
        near = program.sure_signs(point)
        for n, own in self._constants.items():
            near[n] = own
        program.search(point, near, range(len(every)))
        signs = dict(zip(every, near, strict=False))
        if not all(holds_with(formula, signs) for formula in self.assumed):
            raise LookupError("another telling")
        for demand in self.demands:
            holds = holds_with(demand.formula, signs)
            if holds is None:
                raise UndefinedError(demand.reason)
            if not holds:
                return demand.reason, demand.kind
        # Equations hold where the rest does, which takes all digits to see: they come last.
        program.search(point, near, range(len(every), len(near)))
        for sign in near[len(every) :]:
            if sign is None:
                raise UndefinedError("an equation")
            if sign:
                return EQUATION
        return None

    def with_senses(self, points: Iterable[Mapping[str, Enclosed]]) -> Admission:
        """The same with the signs of what equations have sizes of, where they rest on these.

        A solution of v² = w² is one of v = |w| only where v is not negative, as at ``points``.
        """
        senses: list[Demand] = []
        for equation in self.equations:
            rest = tidy(equation)
            signs = {
                node: sense * node.args[0]
                for node in rest.atoms(sp.Abs)
                if (sense := sign_at(node.args[0], points)) is not None
            }
            if signs and tidy(rest.xreplace(signs)) == 0:
                reason, kind = EQUATION
                senses += [Demand(Relation(x, ">="), reason, kind) for x in signs.values()]
        return replace(self, demands=(*self.demands, *senses)) if senses else self

    def refusal(self) -> Demand | None:
        """The first demand that no values of the letters satisfy; None if none is known.

        Of several that cannot be satisfied together, it is the last of a few of which none can be
        left out. An impossible coefficient is blamed only where nothing else is wrong.
        """
        alone = Oracle(self.roles, self.assumed)
        by_blame = sorted(self.demands, key=lambda demand: demand.kind == "coefficient")
        refused = next(
            (demand for demand in by_blame if alone.decide(negation(demand.formula))), None
        )
        if refused is not None or len(by_blame) > MOST_DEMANDS or not self._clash(by_blame):
            return refused
        core = by_blame
        for demand in reversed(by_blame):
            rest = [other for other in core if other is not demand]
            core = rest if self._clash(rest) else core
        return core[-1]

    def _clash(self, demands: Sequence[Demand]) -> bool:
        """Whether it is proved that no values of the letters satisfy these demands together."""
        facts = (*dict.fromkeys(demand.formula for demand in demands), *self.assumed)
        return Oracle(self.roles, facts).possible.answer == "refuted"


def demands_of(
    values: Mapping[str, sp.Expr],
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]],
    roles: Mapping[str, Role],
    phrases: Mapping[str, str],
) -> list[Demand]:
    """What the role of each letter that was solved for asks of its value."""
    hidden = [
        Demand(Relation(radicand, ">="), "it would not be real", "equation")
        for value in values.values()
        for radicand in _radicands(value)
    ]
    hidden += [
        Demand(Relation(below, "!="), "it would not be real", "equation")
        for value in values.values()
        for below in _divisors(value)
    ]
    plain: list[Demand] = []
    coefficients: list[Demand] = []
    for name, value in values.items():
        role = roles.get(name)
        if role is None:
            continue
        if name.startswith("_"):
            if role.low is not None:
                reason = f"{phrases.get(name, name)} would be negative"
                hidden.append(Demand(Relation(value, ">"), reason, "sign"))
            continue
        if role.kind == "restitution":
            coefficients.append(
                Demand(joined(_within(value, None, COEFFICIENT)), COEFFICIENT_RULE, "coefficient")
            )
            if role == COEFFICIENT:
                continue
        # Three times an angle may have gone round, and its cosine and sine do not tell.
        angle = None if _is_multiple(value) else angles.get(name)
        formula = joined(_within(value, angle, role))
        reason, kind = reason_outside(name, role)
        plain.append(Demand(formula, reason, kind))
    # An impossible coefficient is blamed only where nothing else is wrong.
    return [*hidden, *plain, *coefficients]


def _radicands(value: sp.Expr) -> list[sp.Expr]:
    """What stands under the square roots of a value, where it has letters."""
    return sorted(
        {
            node.base
            for node in atoms_in(value, sp.Pow)
            if node.exp.is_Rational and node.exp.q % 2 == 0 and node.base.free_symbols
        },
        key=sp.default_sort_key,
    )


def _divisors(value: sp.Expr) -> list[sp.Expr]:
    """The divisors of a value and of what stands under its roots, where they have letters."""
    radicands = (
        node.base
        for node in atoms_in(value, sp.Pow)
        if node.exp.is_positive and not node.exp.is_Integer
    )
    below = (sp.fraction(sp.together(radicand))[1] for radicand in (value, *radicands))
    return sorted({value for value in below if value.free_symbols}, key=sp.default_sort_key)


def _below_radicands(value: sp.Expr) -> list[sp.Expr]:
    """The divisors within the square roots by which a value is divided, where they have letters."""
    below = (
        sp.fraction(sp.together(node.base))[1]
        for node in value.atoms(sp.Pow)
        if node.exp.is_negative and node.exp.is_Rational and node.exp.q == 2
    )
    return sorted({value for value in below if value.free_symbols}, key=sp.default_sort_key)


def _is_multiple(value: sp.Expr) -> bool:
    """Whether a value is a multiple of an arctangent, and perhaps a number more."""
    arc = value.as_independent(sp.atan, sp.atan2, as_Add=True)[1]
    return arc.as_coeff_Mul()[0] not in (1, -1)


def _within(value: sp.Expr, angle: tuple[sp.Expr, sp.Expr] | None, role: Role) -> Iterable[Formula]:
    if angle is not None and role.low == 0 and role.high == sp.pi / 2:
        c, s = (sp.sympify(value, strict=True) for value in angle)
        yield Relation(c, ">=" if role.closed[1] else ">")
        if not role.closed[1]:
            # Where the tangent has no value, the cosine is zero: 1/√(1 + (a/b)²) = |b|/√(a² + b²).
            yield from (Relation(radicand, "!=") for radicand in _below_radicands(c))
        yield Relation(s, ">=" if role.closed[0] else ">")
        return
    if role.low is not None:
        yield Relation(value - role.low, ">=" if role.closed[0] else ">")
    if role.high is not None:
        yield Relation(role.high - value, ">=" if role.closed[1] else ">")


def reason_outside(name: str, role: Role) -> tuple[str, str]:
    """Why a letter may not have a value outside its range."""
    if role.kind == "restitution":
        return "a given inequality does not hold", "fact"
    if role.kind == "angle":
        ends = [
            f"{float(x) * 180 / float(sp.pi):.4g}°" for x in (role.low, role.high) if x is not None
        ]
        return f"the angle must lie between {' and '.join(ends)}", "range"
    if role.low == 0:
        return f"{name} must be positive", "range"
    return f"{name} is outside the range given for it", "range"


def demands_for(needs: Sequence[Requirement]) -> tuple[list[Demand], list[sp.Expr]]:
    """The conditions among some requirements as demands, and the values that must vanish."""
    demands = [
        Demand(formula_of(need), need.reason, need.kind)
        for need in needs
        if not isinstance(need, Equation)
    ]
    equations = [
        sp.sympify(need.value, strict=True) for need in needs if isinstance(need, Equation)
    ]
    return demands, [equation for equation in equations if equation != 0]
