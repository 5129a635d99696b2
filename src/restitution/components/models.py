"""A part of a problem told in components."""

from __future__ import annotations

import contextlib
import random
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import field, replace
from typing import Any

import sympy as sp

from restitution.components.frames import Component, Frame, Law, component
from restitution.components.hidden import NamedUnknowns
from restitution.components.verdicts import (
    ARCS,
    LONG,
    PLAIN_SIGNS,
    PROVED,
    REFUTED,
    UNDECIDED,
    admitted_points,
    is_less_than_a_turn,
    proved_sign,
    renamed_formula,
)
from restitution.exact import is_zero, tidy
from restitution.exact.symbols import atoms_in, expression_of, substituted, symbol_names, symbols_in
from restitution.expression.enclosed import UndefinedError
from restitution.expression.tree import (
    Expression,
)
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Relation,
    Verdict,
    compared,
)
from restitution.problem import Part, Problem
from restitution.records import dataclass
from restitution.shapes import Circle
from restitution.solving.algebra.numbers import at, number_of, sign_there
from restitution.solving.equations.solution import Branch
from restitution.solving.story.forward import Story
from restitution.solving.story.happenings import Happening
from restitution.solving.story.unknowns import Numbers
from restitution.vector import Vector


@dataclass
class Model:
    """One part of a problem told in components.

    ``final`` gives the value of every unknown symbol in the data; ``sample`` a number for
    every symbol, satisfying all facts.
    """

    problem: Problem
    part: Part
    branch: Branch
    unknowns: NamedUnknowns
    frames: dict[int, Frame]
    components: dict[tuple[int, str], Component]
    laws: list[Law]
    final: dict[sp.Symbol, sp.Expr]
    sample: dict[str, Any]
    story: Story = field(init=False)
    _across: dict[tuple[int, str], sp.Expr] = field(default_factory=dict)
    _oracles_of_names: dict[tuple[int, int], tuple[Oracle, Oracle]] = field(
        default_factory=dict, repr=False
    )
    _inside: dict[int, Oracle] = field(default_factory=dict, repr=False)
    _verdicts: dict[tuple[sp.Expr, str], Verdict] = field(default_factory=dict, repr=False)
    _numbers: dict[sp.Expr, Any] = field(default_factory=dict, repr=False)
    floats: dict[Expression, Any] = field(default_factory=dict, repr=False)
    """What quantities without letters are worth at the sample in floats, as lines are tried."""
    true: dict[object, tuple[set[object], Callable[[Expression], Any]]] = field(
        default_factory=dict, repr=False
    )
    """What has been seen to be true at the sample, by what its letters and axes mean; and what
    trees are worth there."""

    # --- what is proved -----------------------------------------------------------------------

    @property
    def ground(self) -> Oracle:
        """What every letter may be by its role alone, whatever is given and asked."""
        return self._oracles[0]

    @property
    def oracle(self) -> Oracle:
        """What the letters may be wherever this solution is one."""
        return self._oracles[1]

    @property
    def _oracles(self) -> tuple[Oracle, Oracle]:
        """The oracles for the letters, renewed when the story meets a new hidden unknown."""
        names = len(self.unknowns.roles), len(self.unknowns.hidden_roles)
        if names not in self._oracles_of_names:
            ground = Oracle({**self.unknowns.roles, **self.unknowns.hidden_roles})
            known = self.branch.oracle
            self._oracles_of_names[names] = (
                ground,
                ground if known is None else self._renamed(known),
            )
        return self._oracles_of_names[names]

    @property
    def inside(self) -> Oracle:
        """What every letter may be by its role, but for the ends of its range."""
        ground = self.ground
        if id(ground) not in self._inside:
            roles = {
                name: replace(role, closed=(False, False)) for name, role in ground.roles.items()
            }
            self._inside[id(ground)] = Oracle(roles)
        return self._inside[id(ground)]

    def under(self, conditions: Sequence[Formula]) -> Model:
        """The same solution where some conditions of the letters hold as well."""
        own = copy(self)
        own._oracles_of_names, own._inside, own._verdicts = {}, {}, {}
        own._numbers, own.floats, own.true = {}, {}, {}
        names = len(self.unknowns.roles), len(self.unknowns.hidden_roles)
        ground, known = (oracle.with_facts(conditions) for oracle in self._oracles)
        own._oracles_of_names[names] = ground, known
        own._inside[id(ground)] = self.inside.with_facts(conditions)
        witness = known.possible.witness
        if witness is not None:
            own.sample = self._completed(witness)
            there = {name: own.sample[name] for name in self.branch.sample}
            numbers = self.branch.tell(Numbers(there))
            own.branch = replace(self.branch, sample=there, numbers=numbers)
        return own

    def _renamed(self, known: Oracle) -> Oracle:
        put = self._presented(known)
        if not put:
            return known
        names = {old.name: new.name for old, new in put.items()}
        roles = {names.get(name, name): role for name, role in known.roles.items()}
        return Oracle(roles, tuple(renamed_formula(fact, put) for fact in known.facts))

    def _presented(self, known: Oracle) -> dict[sp.Symbol, sp.Symbol]:
        """Hidden unknowns by the names that people see."""
        return {
            role.symbol(name): role.symbol(self.unknowns.names[name[1:]])
            for name, role in known.roles.items()
            if name.startswith("_") and name[1:] in self.unknowns.names
        }

    def in_data(self, x: Any) -> sp.Expr:
        """An expression with the final value of every unknown put in."""
        x = expression_of(x)
        for _ in range(6):
            inside = {s: self.final[s] for s in symbols_in(x) if s in self.final}
            if not inside:
                break
            x = substituted(x, inside)
        return self.presentable(x)

    def decide(self, left: Any, sign: str, right: Any) -> Verdict:
        """Whether ``left sign right`` holds for all letters that the solution admits."""
        gap = self.in_data(left) - self.in_data(right)
        if (gap, sign) not in self._verdicts:
            self._verdicts[gap, sign] = self._decide(gap, sign)
        return self._verdicts[gap, sign]

    def _decide(self, gap: sp.Expr, sign: str) -> Verdict:
        operator = PLAIN_SIGNS.get(sign, sign)
        if operator == "=" and not gap.free_symbols:
            if self._is_not_zero(gap):
                return REFUTED
            if sp.count_ops(gap) > LONG:
                return UNDECIDED
            return PROVED if is_zero(gap) else REFUTED
        try:
            if operator == "=" and gap.has(*ARCS):
                verdict = self._no_angle(gap)
            else:
                verdict = self.oracle.decide(compared(gap, operator, sp.Integer(0)))
        except BeyondError:
            return UNDECIDED
        # Where it is not known what the solution admits, other letters refute nothing.
        open_ = self.branch.oracle is None and bool(gap.free_symbols)
        return UNDECIDED if open_ and not verdict else verdict

    def _is_not_zero(self, constant: sp.Expr) -> bool:
        """Whether a constant is seen not to vanish, in numbers of many digits."""
        try:
            return bool(self.number(constant).sign)
        except (UndefinedError, ArithmeticError):
            return False

    def _points(self, names: frozenset[str]) -> Sequence[tuple[Point, Mapping[str, Any]]]:
        """Points that the solution admits, with each as numbers of many digits."""
        oracle = self.oracle
        return admitted_points(tuple(oracle.roles.items()), oracle.facts, names)

    def _no_angle(self, angle: sp.Expr) -> Verdict:
        """Whether an angle is 0: its sine vanishes, its cosine is positive, and it is no turn."""
        with contextlib.suppress(UndefinedError, KeyError, ArithmeticError):
            if abs(self.number(angle)) > 1:
                return REFUTED
        sine, cosine = (sp.expand_trig(f(angle)) for f in (sp.sin, sp.cos))
        upright = self.oracle.decide(All((Relation(sine, "="), Relation(cosine, ">"))))
        return upright if not upright or is_less_than_a_turn(angle, self.oracle) else UNDECIDED

    def proved_sign(self, x: Any) -> int | None:
        """The sign of an expression for all letters that the solution admits; None if open."""
        return proved_sign(self.oracle, self.in_data(x))

    def witnesses(self, *parts: Any) -> list[Mapping[str, Any]]:
        """The sample, with another for every part of which the sign may be the opposite.

        So whoever looks at the signs of the parts, and of the sizes in them, at all of these sees
        those that are proved; a part may vanish at an end of what is admitted.
        """
        points: list[Mapping[str, Any]] = [self.sample]
        whole = [self.in_data(part) for part in parts]
        sizes = {size.args[0] for x in whole for size in atoms_in(x, sp.Abs)}
        for x in (*whole, *sorted(sizes, key=sp.default_sort_key)):
            sign = self.sign(x)
            if x.is_positive or x.is_negative or not x.free_symbols:
                continue
            witness = self.decide(sign * x if sign else x, ">=" if sign else "=", 0).witness
            if witness is not None:
                with contextlib.suppress(UndefinedError, KeyError, ArithmeticError, TypeError):
                    points.append(self._completed(witness))
        return points

    def _completed(self, witness: Point) -> dict[str, Any]:
        """A point with the numbers of all that follows from the letters there."""
        there = {**self.sample, **{name: number_of(value) for name, value in witness.items()}}
        values = {symbol.name: at(self.in_data(symbol), there) for symbol in self.final}
        return {**there, **values}

    # --- the parts of the story ---------------------------------------------------------------

    def happening(self, number: int) -> Happening:
        return self.story.happenings[number - 1]

    def before(self, number: int, body: str) -> tuple[sp.Expr, sp.Expr]:
        """The components of a velocity just before an impact, along and across."""
        chord = self._chord(number, body)
        if chord is not None:
            return chord
        frame = self.frames[number]
        u = self.happening(number).before[body]
        return tidy(component(u, frame.n)), tidy(component(u, frame.t))

    def altered_across(self, number: int, body: str) -> sp.Expr:
        """The component across just after an impact at which other laws hold."""
        t = self.frames[number].t
        side = Vector(t.x.xreplace(self.final), t.y.xreplace(self.final))
        return self.presentable(tidy(component(self.branch.story.velocity(body, number), side)))

    def _chord(self, number: int, body: str) -> tuple[sp.Expr, sp.Expr] | None:
        """Components at the far end of a chord of a circular wall: those at its near end.

        A chord makes equal angles with the radii at its ends.
        """
        frame = self.frames[number]
        wall = self.story.walls.get(frame.wall or "")
        if wall is None or not isinstance(wall.shape, Circle):
            return None
        latest = self.story.latest(body, number - 1)
        if latest is not None:
            earlier = self.frames.get(latest.number)
            if earlier is None or earlier.wall != frame.wall:
                return None
            if self.sign(latest.after[body].dot(earlier.n)) <= 0:
                return None
            across = tidy(latest.before[body].dot(earlier.t))
            if (latest.number, body) in self._across:
                across = self._across[latest.number, body]
            self._across[number, body] = across
            return -self.components[latest.number, body].symbol, across
        start = self.story.place(body, 0)
        if start is None or self.story.radius(body) is not None:
            return None
        circle = self.story.circle(wall.name)
        inwards, size = circle.centre - start[0], circle.radius
        u = self.happening(number).before[body]
        if tidy(inwards.dot(inwards) - size**2) != 0 or self.sign(u.dot(inwards)) <= 0:
            return None
        across = tidy(u.cross(inwards) / size)
        across = -across if self.sign(across) < 0 else across
        self._across[number, body] = across
        return tidy(-u.dot(inwards) / size), across

    def after(self, number: int, body: str) -> sp.Expr:
        """The component along the line of centres just after."""
        return self.components[number, body].symbol

    def spheres(self, number: int) -> list[str]:
        return [name for name in self.happening(number).bodies if name in self.story.spheres]

    def number(self, x: Any) -> Any:
        """A numerical value by the sample; raises UndefinedError where there is none."""
        x = sp.sympify(x, strict=True)
        # A letter may still come to the sample; one that is there keeps its number.
        if x not in self._numbers:
            self._numbers[x] = at(x, self.sample)
        return self._numbers[x]

    def sign(self, x: Any) -> int:
        """The sign of an expression at the sample (0 where it has no value)."""
        try:
            x = sp.sympify(x, strict=True)
            known = self._numbers.get(x)
            return int(sign_there(x, self.sample) if known is None else known.sign)
        except (UndefinedError, KeyError, ArithmeticError):
            return 0

    def presentable(self, x: sp.Expr) -> sp.Expr:
        """An expression of the solution with the names of hidden unknowns that people see."""
        put = {}
        for symbol in symbols_in(x):
            key = symbol.name[1:]
            if symbol.name.startswith("_") and key in self.unknowns.names:
                put[symbol] = self.unknowns.hidden(
                    key, "", "positive" if symbol.is_positive else "real"
                )
        return x.xreplace(put) if put else x

    def differ(self, one: sp.Expr, other: sp.Expr) -> bool:
        """Whether two values are seen to differ at a point that the solution admits.

        Points of either sign of what stands between bars are among those looked at.
        """
        gap = self.in_data(one) - self.in_data(other)
        if gap == 0:
            return False
        names = symbol_names(gap)
        points = [numbers for _, numbers in self._points(names)]
        for point in (*self.witnesses(one, other), *points):
            with contextlib.suppress(UndefinedError, KeyError, ArithmeticError):
                if sign_there(gap, {**self.sample, **point}):
                    return True
        return False

    def identically_zero(self, x: sp.Expr) -> bool:
        """Whether an expression is proved to vanish whatever its letters and unknowns are."""
        rng = random.Random(41)
        names = sorted(symbol_names(x) & set(self.sample))
        for _ in range(2):
            point = {
                name: self.sample[name] * (1 + rng.random()) + rng.random() / 16 for name in names
            }
            try:
                if sign_there(x, point):
                    return False
            except (UndefinedError, KeyError, ArithmeticError):
                return False
        try:
            return self.ground.vanishes(x)
        except BeyondError:
            return False
