"""Scripts in which one law of an impact is altered, typed out line by line.

The laws of an impact stand as equations in letters, each declared; one of them is that of a
misconception. Below stand the components after, as they follow from these equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp
from derived_scripts import planned

from restitution.explaining.lines.derivation import Event
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.mistakes.misconceptions import LawAt, VariantAt, laws_at, variants_at
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    rational,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Impact

POOL = "vwpqrszyabcdfhkntVWTHSKYZ"


@dataclass(frozen=True)
class AlteredScript:
    """A script with lines that are altered, counted from 1, and the ids that may name them.

    The lines before the first altered one are true; those behind the last one follow.
    """

    statement: str
    part: str | None
    variant: str
    letters: Mapping[str, str]
    lines: tuple[str, ...]
    altered: tuple[int, ...]
    names: frozenset[str]

    @property
    def working(self) -> str:
        return "\n".join(self.lines)


@dataclass(frozen=True)
class _Impact:
    """An impact of a question, with the letters and the numbers that stand for quantities."""

    statement: str
    part: str | None
    world: World
    event: Event
    events: tuple[Event, ...]

    def variants(self) -> Iterator[VariantAt]:
        yield from (each for each in variants_at(self.event, self.events) if each.laws)

    def holds(self, law: LawAt) -> bool:
        left, right = (self.world.scalar(side) for side in law.sides)
        return bool(np.allclose(left, right, rtol=1e-7, atol=1e-9))

    def script(self, variant: VariantAt) -> AlteredScript | None:
        """The laws with those of a variant in place of theirs; None where none is altered here."""
        put, declared = self._letters(variant)
        laws = [self._replaced(law, variant) for law in laws_at(self.event)]
        wrong = tuple(n for n, law in enumerate(laws, 1) if not self.holds(law))
        if not wrong:
            return None
        sides = [tuple(exchanged(side, put) for side in law.sides) for law in laws]
        lines = [f"{write_expression(left)} = {write_expression(right)}" for left, right in sides]
        lines += _solved(sides, [put[q] for q in self._after(variant)])
        if len(set(lines[: len(laws)])) < len(laws):
            return None
        alike = [each for each in self.variants() if self._same(each, variant, wrong)]
        names = frozenset(each.mistake for each in alike)
        if self.event.wall and any(law.law == "restitution" for law in variant.laws):
            # At a wall, e times the speed is one mistake, whatever it is called.
            names |= {"restitution-whole-speed"} if "speed-for-component" in names else set()
        used = {name for side in sides for tree in side for name in _names(tree)}
        letters = {letter: text for letter, text in declared.items() if letter in used}
        return AlteredScript(
            self.statement, self.part, variant.id, letters, tuple(lines), wrong, names
        )

    def _same(self, one: VariantAt, other: VariantAt, wrong: tuple[int, ...]) -> bool:
        """Whether a variant has the same first altered line, by numbers."""
        law = laws_at(self.event)[wrong[0] - 1]
        first, second = self._replaced(law, one), self._replaced(law, other)
        if first.relation == law.relation:
            return False
        a = self.world.scalar(Binary("-", *first.sides))
        b = self.world.scalar(Binary("-", *second.sides))
        return bool(np.allclose(np.abs(a), np.abs(b), rtol=1e-6, atol=1e-9))

    def _replaced(self, law: LawAt, variant: VariantAt) -> LawAt:
        same = (each for each in variant.laws if (each.law, each.bodies) == (law.law, law.bodies))
        return next(same, law)

    def _after(self, variant: VariantAt) -> list[Quantity]:
        """The components after the impact, of which the laws speak."""
        found = dict.fromkeys(
            node
            for law in laws_at(self.event)
            for node in _quantities(law)
            if _is_after(node, self)
        )
        return list(found)

    def _letters(self, variant: VariantAt) -> tuple[dict[Expression, Expression], dict[str, str]]:
        """A letter, or a number, for each quantity of the laws."""
        taken = set(self.statement) | set("eijmu")
        pool = [letter for letter in POOL if letter not in taken]
        pool += [f"{letter}_{number}" for letter in "pqrs" for number in (1, 2)]
        put: dict[Expression, Expression] = {}
        declared: dict[str, str] = {}
        laws = (*laws_at(self.event), *variant.laws)
        for quantity in dict.fromkeys(node for law in laws for node in _quantities(law)):
            number = None if _is_after(quantity, self) else self._number(quantity)
            given = self._given(quantity)
            if given is not None:
                put[quantity] = given
            elif number is not None:
                put[quantity] = rational(number)
            elif pool:
                letter = pool.pop(0)
                put[quantity] = Letter(letter)
                declared[letter] = write_expression(quantity)
        return put, declared

    def _number(self, quantity: Quantity) -> Fraction | None:
        values = self.world.scalar(quantity)
        number = Fraction(float(values[0])).limit_denominator(60)
        return number if np.allclose(values, float(number), rtol=1e-9, atol=1e-12) else None

    def _given(self, quantity: Quantity) -> Expression | None:
        """A mass, or a coefficient of restitution, as the statement has it."""
        problem = self.world.problem
        if quantity.kind == "mass":
            name = quantity.arguments[0].name  # type: ignore[union-attr]
            return next((s.mass for s in problem.spheres if s.name == name), None)
        if quantity.kind == "restitution":
            step = problem.events[self.event.number - 1]
            return (step.e if isinstance(step, Impact) else None) or Letter("e")
        return None


def _is_after(quantity: Quantity, impact: _Impact) -> bool:
    stages = {
        node.stage for node in walk(quantity) if getattr(node, "kind", "") in ("velocity", "speed")
    }
    return stages == {impact.event.number} and quantity.kind != "restitution"


def _quantities(law: LawAt) -> Iterator[Quantity]:
    """The outermost quantities of a law."""
    for side in law.sides:
        inner = {
            each
            for node in walk(side)
            if isinstance(node, Quantity)
            for argument in node.arguments
            for each in walk(argument)
        }
        for node in walk(side):
            if isinstance(node, Quantity) and node not in inner:
                yield node


def _names(tree: Expression) -> set[str]:
    return {node.name for node in walk(tree) if isinstance(node, Letter)}


def _sympy(tree: Expression) -> sp.Expr:
    match tree:
        case Number(value):
            return sp.Rational(value.numerator, value.denominator)
        case Letter(name):
            return sp.Symbol(name)
        case Negate(operand):
            return -_sympy(operand)
        case Binary(op, left, right):
            a, b = _sympy(left), _sympy(right)
            match op:
                case "+":
                    return a + b
                case "-":
                    return a - b
                case "*":
                    return a * b
                case "/":
                    return a / b
                case "^":
                    return a**b
    raise ValueError(tree)


def only_values(
    sides: list[tuple[Expression, ...]], symbols: list[sp.Symbol]
) -> tuple[sp.Expr, ...] | None:
    """The values to which linear equations lead; None where they are others, or lead to several."""
    try:
        equations = [_sympy(left) - _sympy(right) for left, right in sides]
        solutions = sp.linsolve(equations, symbols)
    except (ValueError, sp.SympifyError, NotImplementedError):
        return None
    if not isinstance(solutions, sp.FiniteSet) or len(solutions) != 1:
        return None
    (values,) = solutions
    return None if any(value.free_symbols & set(symbols) for value in values) else tuple(values)


def _solved(sides: list[tuple[Expression, ...]], unknown: list[Expression]) -> list[str]:
    """What the equations lead to, where they are linear and lead to one value of each letter."""
    symbols = [sp.Symbol(each.name) for each in unknown if isinstance(each, Letter)]
    values = only_values(sides, symbols)
    if values is None:
        return []
    return [
        f"{symbol} = {_text(value)}"
        for symbol, value in zip(symbols, values, strict=True)
        if sp.simplify(value - symbol) != 0
    ]


def _text(value: sp.Expr) -> str:
    return str(sp.factor(value)).replace("**", "^").replace("*", " ")


def altered_scripts(statement: str) -> Iterator[AlteredScript]:
    """One script for each impact of a question and each variant that alters a law of it."""
    for impact in impacts(statement):
        for variant in impact.variants():
            script = impact.script(variant)
            if script is not None:
                yield script


def impacts(statement: str) -> Iterator[_Impact]:
    solution, derivation = planned(statement)
    part, solved = next(iter(solution.parts.items()))
    worlds = true_worlds(solution, solved)
    if len(worlds) != 1:
        return
    for event in derivation.events:
        if event.kind == "impact" and event.number <= len(worlds[0].events):
            yield _Impact(statement, part, worlds[0], event, derivation.events)
