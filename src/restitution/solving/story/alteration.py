"""An impact at which other laws hold: velocities after it, from the equations that are altered.

Components are those along the line of centres and across it, from the first body to the second,
times the length of the vector along that line: laws are of one degree in them, and no root of that
length is needed. Linear equations are solved by elimination, in any arithmetic. One that holds
speeds after, or energies, leaves one unknown component along a line of values; its root is chosen:

- of a rebound from a wall, the one that leaves the wall;
- where energy is conserved, the one other than *nothing happened*;
- of spheres, the one at which they separate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

from restitution.errors import ImpossibleError, UnsupportedError
from restitution.expression.evaluate import Evaluator, Scalar
from restitution.expression.tree import Binary, Expression, Name, Quantity, quantities_in
from restitution.problem import AlteredEquation, AlteredImpact, Impact
from restitution.records import dataclass
from restitution.solving.story import quantities
from restitution.solving.story.conditions import Condition, Equation
from restitution.solving.story.state import State
from restitution.vector import Vector

_AFTER = frozenset({"speed", "energy"})
Components = Mapping[tuple[str, str], Scalar]
Residual = Callable[[Components], Scalar]


@dataclass
class AlteredLaws:
    """The equations of one impact, in one telling of the story.

    ``before`` are the velocities before of the spheres that take part, ``c`` a vector along the
    line of centres, from the first body to the second.
    """

    state: State
    altered: AlteredImpact
    step: Impact
    before: Mapping[str, Vector]
    c: Vector
    e: Scalar
    after: Components = field(default_factory=dict)

    @property
    def spheres(self) -> tuple[str, ...]:
        return tuple(self.before)

    @cached_property
    def length(self) -> Scalar:
        """The length of ``c``."""
        return self.state.size(self.c)

    @cached_property
    def known(self) -> Components:
        """The components before."""
        return {
            key: value
            for name, u in self.before.items()
            for key, value in (
                ((name, "along"), self.state.rational(u.dot(self.c))),
                ((name, "across"), self.state.rational(u.dot(self.c.turned_left()))),
            )
        }

    # --- the equations ------------------------------------------------------------------------

    @cached_property
    def residuals(self) -> tuple[tuple[Residual, bool], ...]:
        """What vanishes after the impact, and whether it is linear in the components after."""
        number = self.altered.number
        altered = [
            (self._of_trees(equation), _is_linear(equation, number)) for equation in self._equations
        ]
        return (*((law, True) for law in self._laws()), *altered)

    @property
    def _equations(self) -> tuple[AlteredEquation, ...]:
        return self.altered.equations

    def _replaced(self, law: str, body: str | None = None) -> bool:
        return any(
            equation.law == law and (body is None or body in equation.bodies)
            for equation in self._equations
        )

    def _laws(self) -> list[Residual]:
        """The laws that hold on."""
        first, second = self.step.first, self.step.second
        kept: list[Residual] = [
            self._stays(name) for name in self.spheres if not self._replaced("unchanged", name)
        ]
        wall = second not in self.before
        if not wall and not self._replaced("momentum"):
            kept.append(self._momentum(first, second))
        if not self._replaced("restitution"):
            kept.append(self._rebound(first) if wall else self._restitution(first, second))
        return kept

    def _stays(self, name: str) -> Residual:
        return lambda after: after[name, "across"] - self.known[name, "across"]

    def _rebound(self, name: str) -> Residual:
        return lambda after: after[name, "along"] + self.e * self.known[name, "along"]

    def _restitution(self, first: str, second: str) -> Residual:
        approach = self.known[first, "along"] - self.known[second, "along"]
        return lambda after: after[second, "along"] - after[first, "along"] - self.e * approach

    def _momentum(self, first: str, second: str) -> Residual:
        def change(name: str, after: Components) -> Scalar:
            return self.state.mass(name) * (after[name, "along"] - self.known[name, "along"])

        return lambda after: change(first, after) + change(second, after)

    def _of_trees(self, equation: AlteredEquation) -> Residual:
        return _OfTrees(self, Binary("-", equation.left, equation.right))

    def value(self, tree: Expression, after: Components) -> Scalar:
        """What an expression of components is worth, times the length of ``c`` to its degree."""
        self.after = after
        return self._evaluator.scalar(tree)

    @cached_property
    def _evaluator(self) -> Evaluator:
        own = self.state.evaluator(self.altered.number - 1)
        return Evaluator(self.state.field, own._letter, self._quantity, own._name)

    def _quantity(self, tree: Quantity) -> Any:
        number = self.altered.number
        match tree:
            case Quantity("mass", (Name(name),)):
                return self.state.mass(name)
            case Quantity("restitution"):
                return self.e
            case Quantity("along" | "across" as part, (Quantity(_, (Name(name),), stage), line)):
                if isinstance(line, Quantity) and line.stage == number:
                    return (self.after if stage == number else self.known)[name, part]
            case Quantity("speed", (Name(name),), stage) if stage == number:
                return self.state.field.sqrt(self._square(name, self.after))
            case Quantity("speed", (Name(name),), stage) if stage == number - 1:
                return self.state.size(self.before[name]) * self.length
            case Quantity("energy", (Name(name),), stage):
                values = self.after if stage == number else self.known
                return self.state.mass(name) * self._square(name, values) / 2
        return quantities.quantity(self.state, tree, number - 1) * self.length

    def _square(self, name: str, values: Components) -> Scalar:
        return values[name, "along"] ** 2 + values[name, "across"] ** 2

    # --- solving ------------------------------------------------------------------------------

    @cached_property
    def unknowns(self) -> tuple[tuple[str, str], ...]:
        """The components after, those along the line last."""
        names = self.spheres
        return tuple((name, part) for part in ("across", "along") for name in names)

    def solved(self) -> dict[tuple[str, str], Scalar]:
        """The components after.

        Raises ImpossibleError where there are none, UnsupportedError where no square root gives
        them.
        """
        linear = [function for function, is_linear in self.residuals if is_linear]
        rest = [function for function, is_linear in self.residuals if not is_linear]
        if not rest:
            return self._eliminated(linear, {})
        if len(rest) > 1:
            raise UnsupportedError("two of the altered equations are not linear")
        free = self.unknowns[-1]
        start, end = (self._eliminated(linear, {free: self._number(n)}) for n in (0, 1))
        along_line = _Line(start, end, self._number)
        return along_line.at(self._root(along_line, rest[0], free))

    def _number(self, n: int) -> Scalar:
        return self.state.field.number(Fraction(n))

    def _eliminated(
        self, residuals: list[Residual], given: Components
    ) -> dict[tuple[str, str], Scalar]:
        """The components at which linear residuals vanish, some of them given."""
        names = [unknown for unknown in self.unknowns if unknown not in given]
        zero, one = self._number(0), self._number(1)
        at_zero = {**dict.fromkeys(names, zero), **given}
        units = [{**at_zero, name: one} for name in names]
        rows: list[list[Scalar]] = []
        for residual in residuals:
            constant = residual(at_zero)
            inside = names
            if isinstance(residual, _OfTrees):
                inside = [name for name in names if name in residual.components]
            row = [
                residual(unit) - constant if name in inside else zero
                for name, unit in zip(names, units, strict=True)
            ]
            rows.append([self.state.rational(value) for value in (*row, -constant)])
        values = _elimination(rows, self.state)
        if values is None:
            raise ImpossibleError("the altered equations do not determine the motion")
        return {**given, **dict(zip(names, values, strict=True))}

    def _root(self, line: _Line, residual: Residual, free: tuple[str, str]) -> Scalar:
        """The value of the free component at which a residual vanishes, as the module says."""
        number = self.altered.number
        (equation,) = (equation for equation in self._equations if not _is_linear(equation, number))
        sides = (equation.left, equation.right)
        kinds = {node.kind for side in sides for node in quantities_in(side)}
        if "energy" in kinds:
            return self._conserving(line, residual, free)
        if len(self.spheres) == 1:
            return self._rebounding(line, equation)
        return self._separating(line, equation, free)

    def _conserving(self, line: _Line, residual: Residual, free: tuple[str, str]) -> Scalar:
        """The root other than that at which nothing happened: by the sum of the two."""
        a, b, _ = line.quadratic(residual)
        if self.state.field.is_zero(self.state.rational(a)):
            raise ImpossibleError("the altered equations do not determine the motion")
        return self.state.rational(-b / a - self.known[free])

    def _rebounding(self, line: _Line, equation: AlteredEquation) -> Scalar:
        """The root at which a sphere leaves the wall with the speed that is wanted."""
        (name,) = self.spheres
        values = line.at(self._number(0))
        wanted = self.value(equation.right, values)
        under = self.state.rational(wanted * wanted - values[name, "across"] ** 2)
        reason = f"the speed of {name} after would be less than its component along the wall"
        self.state.conditions.append(Condition(under, ">=", reason, "sign"))
        return -self.state.real_root(under, reason)

    def _separating(self, line: _Line, equation: AlteredEquation, free: tuple[str, str]) -> Scalar:
        """The root of an equation of two speeds at which the spheres separate the least."""
        fit = [
            root
            for root, checks in self._roots_of_speeds(line, equation)
            if all(
                self._is_not_negative(check) for check in (*checks, self._separation(line, root))
            )
        ]
        if not fit:
            raise ImpossibleError("the altered equations have no solution for these speeds")
        best = fit[0]
        for root in fit[1:]:
            closer = self._separation(line, best) - self._separation(line, root)
            if self.state.sign(closer) == 1:
                best = root
        return best

    def _roots_of_speeds(
        self, line: _Line, equation: AlteredEquation
    ) -> Iterator[tuple[Scalar, tuple[Scalar, ...]]]:
        """Roots of ``V₂ ± V₁ = w`` made polynomial, each with what must not be negative there."""
        first, second = self.spheres
        assert isinstance(equation.left, Binary)
        sign = self._number(1 if equation.left.op == "+" else -1)
        w = self.value(equation.right, line.at(self._number(0)))

        def square(name: str, t: Scalar) -> Scalar:
            return self._square(name, line.at(t))

        def component(name: str, t: Scalar) -> Scalar:
            return line.at(t)[name, "along"]

        still = [name for name in self.spheres if self._moves_along(name, line)]
        if still:
            name = still[0]
            other = first if name == second else second
            # V of this sphere is τ times its component: what is left is the speed of the other.
            own, theirs = (self._number(1), sign) if name == second else (sign, self._number(1))
            for tau in (self._number(1), self._number(-1)):

                def rest(t: Scalar, tau: Scalar = tau) -> Scalar:
                    return w - own * tau * component(name, t)

                for root in self._quadratic_roots(lambda t: rest(t) ** 2 - square(other, t)):
                    yield root, (tau * component(name, root), theirs * rest(root))
            return

        def twice(t: Scalar) -> Scalar:
            return w * w + square(first, t) - square(second, t)

        for root in self._quadratic_roots(lambda t: twice(t) ** 2 - 4 * w * w * square(first, t)):
            speed = self.state.field.sqrt(square(first, root))
            yield root, (twice(root) * sign * w, w - sign * speed)

    def _moves_along(self, name: str, line: _Line) -> bool:
        """Whether a sphere has no component across the line of centres after."""
        return self.state.field.is_zero(line.at(self._number(0))[name, "across"])

    def _quadratic_roots(self, function: Callable[[Scalar], Scalar]) -> list[Scalar]:
        """The real roots of a polynomial of at most the second degree, given by its values.

        Raises UnsupportedError for one of higher degree.
        """
        values = [self.state.rational(function(self._number(n))) for n in range(-2, 3)]
        fourth = values[0] - 4 * values[1] + 6 * values[2] - 4 * values[3] + values[4]
        third = values[4] - 2 * values[3] + 2 * values[1] - values[0]
        is_zero = self.state.field.is_zero
        if not all(is_zero(self.state.rational(value)) for value in (fourth, third)):
            raise UnsupportedError("the altered equations need a root of the fourth degree")
        a, b, c = _coefficients(values[1:4])
        a, b = self.state.rational(a), self.state.rational(b)
        if is_zero(a):
            return [] if is_zero(b) else [-c / b]
        under = self.state.rational(b * b - 4 * a * c)
        if self.state.sign(under) == -1:
            return []
        root = self.state.field.sqrt(under)
        return [(-b - root) / (2 * a), (-b + root) / (2 * a)]

    def _separation(self, line: _Line, t: Scalar) -> Scalar:
        first, second = self.spheres
        values = line.at(t)
        return values[second, "along"] - values[first, "along"]

    def _is_not_negative(self, x: Scalar) -> bool:
        sign = self.state.sign(self.state.rational(x))
        if sign is None:
            raise UnsupportedError("which root is taken depends on the letters")
        return sign >= 0

    # --- velocities ---------------------------------------------------------------------------

    def velocities(self) -> dict[str, Vector]:
        """The velocities after. Raises what `solved` raises."""
        values = self.solved()
        square = self.c.dot(self.c)
        side = self.c.turned_left()
        return {
            name: self.state.neat(
                (self.c * values[name, "along"] + side * values[name, "across"]) / square
            )
            for name in self.spheres
        }

    def velocities_on_unknown_line(self) -> tuple[dict[str, Vector], list[Equation]]:
        """The velocities after where ``c`` is unknown: the change in velocity of the first sphere.

        What ``c`` must satisfy is an equation. Raises UnsupportedError where a component across
        it changes, or an equation is not linear.
        """
        if self._replaced("unchanged") or not all(linear for _, linear in self.residuals):
            raise UnsupportedError("the line of centres is not known, and would have to be")
        first, *others = self.spheres
        across = {(name, "across"): self.known[name, "across"] for name in self.spheres}
        square = self.c.dot(self.c)
        given = {**across, (first, "along"): self.known[first, "along"] - square}
        after = {first: self.state.neat(self.before[first] - self.c)}
        rows = [function for function, _ in self.residuals[len(self.spheres) :]]
        if others:
            (second,) = others
            if not self._replaced("restitution"):
                rows.reverse()  # momentum, altered or not, gives the second velocity
            values = self._eliminated(rows[:1], given)
            del rows[0]
            gain = (values[second, "along"] - self.known[second, "along"]) / square
            after[second] = self.state.neat(self.before[second] + self.c * self._neat(gain))
        else:
            values = dict(given)
        (left,) = rows
        return after, [Equation(left(values), "the altered law", kind="law")]

    def _neat(self, x: Scalar) -> Scalar:
        return self.state.rational(x)

    def hold(self, after: Mapping[str, Vector]) -> bool:
        """Whether the equations hold, in numbers, for velocities after the impact."""
        values = {
            key: value
            for name in self.spheres
            for key, value in (
                ((name, "along"), after[name].dot(self.c)),
                ((name, "across"), after[name].dot(self.c.turned_left())),
            )
        }
        return not any(residual(values).sign for residual, _ in self.residuals)

    def require_senses(self) -> None:
        """Adds that the signs put in by hand are those of the components."""
        reason = "the signs of this mistake are those of other directions"
        for tree in self.altered.senses:
            value = self.value(tree, self.known)
            self.state.conditions.append(Condition(value, ">=", reason, "fact"))


@dataclass(frozen=True)
class _OfTrees:
    """A residual that is an expression of components."""

    laws: AlteredLaws
    tree: Expression

    def __call__(self, after: Components) -> Scalar:
        return self.laws.value(self.tree, after)

    @property
    def components(self) -> frozenset[tuple[str, str]]:
        """The components after on which a linear one may depend."""
        return _components_after(self.tree, self.laws.altered.number)


@dataclass(frozen=True)
class _Line:
    """Components that are linear in one free component, by their values where it is 0 and 1."""

    zero: Components
    one: Components
    number: Callable[[int], Scalar]

    def at(self, t: Scalar) -> dict[tuple[str, str], Scalar]:
        return {key: start + (self.one[key] - start) * t for key, start in self.zero.items()}

    def quadratic(self, residual: Residual) -> tuple[Scalar, Scalar, Scalar]:
        """The coefficients of a residual that is quadratic in the free component."""
        return _coefficients([residual(self.at(self.number(n))) for n in (-1, 0, 1)])


def _coefficients(values: list[Scalar]) -> tuple[Scalar, Scalar, Scalar]:
    """The coefficients of a quadratic from its values at -1, 0 and 1."""
    low, middle, high = values
    return (high + low) / 2 - middle, (high - low) / 2, middle


@lru_cache(maxsize=4096)
def _components_after(tree: Expression, number: int) -> frozenset[tuple[str, str]]:
    """The components after an event that stand in a tree."""
    components: set[tuple[str, str]] = set()
    for node in quantities_in(tree):
        match node:
            case Quantity("along" | "across" as kind, (Quantity(_, (Name(name),), stage), _)):
                if stage == number:
                    components.add((name, kind))
    return frozenset(components)


@lru_cache(maxsize=4096)
def _is_linear(equation: AlteredEquation, number: int) -> bool:
    return not any(
        node.kind in _AFTER and node.stage == number
        for side in (equation.left, equation.right)
        for node in quantities_in(side)
    )


def _elimination(rows: list[list[Scalar]], state: State) -> list[Scalar] | None:
    """The values at which linear equations hold; None where they do not determine them.

    Each row has the coefficients of one equation, and what they add up to.
    """
    size = len(rows[0]) - 1
    for column in range(size):
        pivot = next(
            (n for n in range(column, len(rows)) if not state.field.is_zero(rows[n][column])), None
        )
        if pivot is None:
            return None
        rows[column], rows[pivot] = rows[pivot], rows[column]
        top = rows[column]
        for n, row in enumerate(rows):
            if n != column and not state.field.is_zero(row[column]):
                factor = row[column] / top[column]
                rows[n] = [state.rational(a - factor * b) for a, b in zip(row, top, strict=True)]
    return [state.rational(rows[n][size] / rows[n][n]) for n in range(size)]
