"""The values that a letter can take: intervals with exact ends, sought and then proved.

Where a condition can change from true to false, one of the expressions in it vanishes, or has no
value. Those points are found exactly; between them one trial by numbers decides. Data letters are
tried at several random values. What is found so is a guess: the oracle proves it for all values of
the data, or gives values for which it is wrong, from which a better guess is made.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath.libmp import NoConvergence

from restitution import exact
from restitution.errors import RestitutionError, UnsupportedError
from restitution.expression.enclosed import DIGITS, Enclosed, UndefinedError
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Proof,
    Relation,
    Some,
    Verdict,
    joined,
    letters_of,
    relations,
)
from restitution.oracle.roles import Role
from restitution.solving import forms
from restitution.solving.admission import Admission, Demand
from restitution.solving.algebra import solve_system
from restitution.solving.conditions import AnyOf, Condition
from restitution.solving.numbers import Sample, at, number_of, sample
from restitution.solving.part import Outcome
from restitution.solving.setting import Setting, Trial, out_of_range
from restitution.solving.unknowns import Letters

DRAWS = 4
DRAWS_TRIED = 60
ROUNDS = 4
NEAR = (1, 3, 7, 13)
INFINITE = 10**1000
# Far above rounding, and as nothing beside what is known with so many digits.
ASIDE = Fraction(1, 10**196)


@dataclass(frozen=True)
class End:
    """One end of an interval, exact, and whether it belongs to it."""

    value: sp.Expr
    closed: bool


Piece = tuple[End, End]


@dataclass
class Region:
    """The values that one letter can take, in the setting of a part.

    ``free`` letters may have any admissible value; all others are data, of which ``base`` holds.
    With ``only``, these demands alone are asked of the letters, and not all that the solutions do.
    After `pieces`, ``proof`` tells what the answer rests on.
    """

    outcome: Outcome
    letter: str
    free: tuple[str, ...] = ()
    base: Oracle | None = None
    only: tuple[Demand, ...] | None = None
    proof: Proof = "undecided"

    def __post_init__(self) -> None:
        self.setting: Setting = self.outcome.setting
        self.role: Role = self.setting.roles[self.letter]
        self.symbol = self.role.symbol(self.letter)
        self.trials = [t for t in self.outcome.trials if t.kind != "equation"]
        self._kept_atoms = self._atoms()
        matter = {s.name for each in self._kept_atoms for s in each.free_symbols}
        self.free = tuple(name for name in self.free if name in matter)
        self.critical = self._critical()

    # --- where truth can change --------------------------------------------------------------

    def _atoms(self) -> list[sp.Expr]:
        """The expressions whose signs decide, with what was solved put in."""
        atoms: list[sp.Expr] = []
        for trial in self.trials:
            demands = self._demands(trial)
            if demands is not None:
                atoms += [each.value for d in demands for each in relations(d.formula)]
                continue
            solved_letters = Letters(self.setting.roles, trial.root.values, trial.root.angles)
            story = self.setting.tell(solved_letters)
            needs = [*story.conditions, *self.setting.requirements(story)]
            for need in needs:
                if isinstance(need, Condition):
                    atoms.append(sp.sympify(need.value, strict=True))
                elif isinstance(need, AnyOf):
                    atoms += [sp.sympify(option.value, strict=True) for option in need.options]
            for name, value in trial.root.values.items():
                role = self.setting.roles.get(name) or solved_letters.hidden_roles.get(name)
                if role is None:
                    continue
                if role.kind == "angle":
                    if name in trial.root.angles:
                        atoms += list(trial.root.angles[name])
                    continue
                if role.low is not None:
                    atoms.append(value - role.low)
                if role.high is not None:
                    atoms.append(value - role.high)
        for name in self.free:
            role, symbol = self.setting.roles[name], self.setting.roles[name].symbol(name)
            for bound in (role.low, role.high):
                if bound is not None and name in {
                    s.name for each in atoms for s in each.free_symbols
                }:
                    atoms.append(symbol - bound)
        unique: list[sp.Expr] = []
        for atom in atoms:
            for part in deciding(atom):
                for factor in _essential(part):
                    if factor not in unique:
                        unique.append(factor)
        return unique

    def _demands(self, trial: Trial) -> tuple[Demand, ...] | None:
        if self.only is not None:
            return self.only
        return None if trial.admission is None else trial.admission.demands

    @cached_property
    def roles(self) -> dict[str, Role]:
        """What every letter and hidden unknown may be."""
        hidden = {
            name: role
            for trial in self.trials
            if trial.admission is not None
            for name, role in trial.admission.roles.items()
        }
        return {**self.outcome.letters.hidden_roles, **hidden, **self.setting.roles}

    @cached_property
    def formula(self) -> Formula | None:
        """What is asked of the letters; None where it is too unwieldy to be told in letters."""
        cases: list[Formula] = []
        for trial in self.trials:
            demands = self._demands(trial)
            if demands is None or (trial.admission is not None and trial.admission.assumed):
                return None  # it would be proved on what nobody has proved
            parts = [d.formula for d in demands]
            if self.only is None and trial.admission is not None:
                parts += [Relation(equation, "=") for equation in trial.admission.equations]
            cases.append(joined(dict.fromkeys(parts)))
        return cases[0] if len(cases) == 1 else Some(tuple(cases))

    @cached_property
    def _own(self) -> Admission:
        return Admission(self.roles, self.only or (), ())

    def _critical(self) -> list[sp.Expr]:
        atoms = self._kept_atoms
        points: list[sp.Expr] = [x for x in (self.role.low, self.role.high) if x is not None]
        free = {self.setting.roles[name].symbol(name) for name in self.free}
        atoms = [*atoms, *self._at_ends(atoms)]
        plain = [each for each in atoms if not each.free_symbols & free]
        mixed = [each for each in atoms if each.free_symbols & free]
        for atom in plain:
            if atom.has(self.symbol):
                points += self._zeros([atom], [self.symbol])
        if mixed:
            symbols = sorted(free, key=lambda s: s.name)
            for i, one in enumerate(mixed):
                own = [s for s in symbols if one.has(s)]
                if len(own) == 1 and one.has(self.symbol):
                    points += self._zeros([one, sp.diff(one, own[0])], [*own, self.symbol])
                for other in mixed[i + 1 :]:
                    if one.has(self.symbol) or other.has(self.symbol):
                        points += self._zeros([one, other], [*symbols, self.symbol])
        unique: list[sp.Expr] = []
        for point in points:
            if not any(point == each for each in unique):
                unique.append(point)
        return unique

    def _at_ends(self, atoms: Sequence[sp.Expr]) -> list[sp.Expr]:
        """The expressions where free letters come to the ends of what they may be."""
        reached = list(atoms)
        for name in self.free:
            role = self.roles[name]
            symbol = role.symbol(name)
            for atom in [each for each in reached if each.has(symbol)]:
                for end in (role.low, role.high):
                    own = _at_infinity(atom, symbol) if end is None else _at_end(atom, symbol, end)
                    if own is not None:
                        reached += [x for x in _essential(own) if x not in reached]
        return reached[len(atoms) :]

    def _zeros(self, equations: list[sp.Expr], unknowns: list[sp.Symbol]) -> list[sp.Expr]:
        return zeros(equations, unknowns, self.setting.roles, self.letter)

    # --- deciding ----------------------------------------------------------------------------

    def data(self) -> list[str]:
        """The letters that stay data."""
        solved = {name for trial in self.trials for name in trial.root.values}
        hidden = set(self.outcome.letters.hidden_roles)
        return sorted(
            (set(self.setting.roles) | hidden)
            - solved
            - set(self.setting.lets)
            - {self.letter, *self.free}
        )

    def allowed(self, value: Any, drawn: Mapping[str, Any]) -> bool:
        """Whether the letter may have this numerical value, the data being as drawn."""
        if not self.free:
            return self._possible({**drawn, self.letter: value})
        return any(
            self._possible({**drawn, self.letter: value, **extra})
            for extra in self._choices(value, drawn)
        )

    def _choices(self, value: Any, drawn: Mapping[str, Any]) -> list[Sample]:
        """Values of the free letters that stand for all: between and at the critical ones."""
        chosen: list[Sample] = [{}]
        for name in self.free:
            inner = Region.__new__(Region)
            inner.outcome, inner.letter, inner.free = self.outcome, name, ()
            inner.setting, inner.role = self.setting, self.setting.roles[name]
            inner.symbol = inner.role.symbol(name)
            inner.trials = self.trials
            extended: list[Sample] = []
            for known in chosen:
                values = {**drawn, self.letter: value, **known}
                numbers = _numeric_zeros(self._kept_atoms, inner.symbol, values)
                role = inner.role
                for bound in (role.low, role.high):
                    if bound is not None:
                        numbers.append(at(bound, {}))
                extended += [{**known, name: x} for x in _representatives(sorted(numbers), role)]
            chosen = extended[:200]
        return chosen

    def _solved(self, trial: Trial, values: Sample) -> Sample:
        """These values with all that was solved.

        Where a formula has none (0/0 where a quadratic equation becomes a linear one), what it
        comes near to is taken; whether that is a solution is for the facts to say.
        """
        solved = trial.root.values
        try:
            return with_solved(trial, values)
        except UndefinedError as error:
            for name in (self.letter, *self.free):
                for step in (ASIDE, -ASIDE):
                    try:
                        aside, nearer = (
                            with_solved(trial, {**values, name: values[name] + each})
                            for each in (step, step / 4)
                        )
                    except UndefinedError:
                        continue
                    # The limit lies between, whether it is come to straight or like a root.
                    between = {n: aside[n].hull(4 * nearer[n] - 3 * aside[n]) for n in solved}
                    return {**between, **values}
            raise error

    def _possible(self, values: Sample) -> bool:
        if any(
            out_of_range(name, values[name], self.setting.roles.get(name)) is not None
            for name in (self.letter, *self.free)
            if name in values
        ):
            return False
        if self.only is not None:
            try:
                return self._own.objection(values) is None
            except (UndefinedError, LookupError):
                return False
        for trial in self.trials:
            if trial.admission is not None:
                try:
                    if trial.admission.objection(values) is None:
                        return True
                    continue
                except (UndefinedError, LookupError):
                    pass  # where a formula has no value, what it comes near to may have
            try:
                numbers = self._solved(trial, values)
                solved = [n for n in trial.root.values if not n.startswith("_")]
                known = self.outcome.letters.hidden_roles
                if any(
                    not numbers[n] > 0
                    for n in trial.root.values
                    if n in known and known[n].low is not None
                ):
                    continue
                if self.setting.examine(numbers, [*solved, self.letter, *self.free]) is None:
                    return True
            except (UndefinedError, ArithmeticError, KeyError):
                continue
            except RestitutionError:
                continue
        return False

    # --- the set -------------------------------------------------------------------------------

    def pieces(self) -> list[Piece]:
        """The allowed values as intervals with exact ends, in order.

        They are sought at a few values of the data, and then proved for all; values of the data
        for which they are others are taken in, and the form is sought again.
        """
        shapes = self.shapes
        if not shapes:
            return []
        for _ in range(ROUNDS):
            pieces = reconcile(shapes)
            verdict = self.proved(pieces)
            self.proof = verdict.proof if verdict else "undecided"
            if verdict.answer != "refuted" or verdict.witness is None:
                break
            drawn = self._drawn(verdict.witness)
            shape = self.pieces_at(drawn)
            if any(shape == known for known, _ in shapes) and any(drawn == d for _, d in shapes):
                break
            if shape:
                shapes.append((shape, drawn))
            else:
                self.proof = "undecided"
                break
        else:
            self.proof = "undecided"
        return reconcile(shapes)

    @cached_property
    def shapes(self) -> list[tuple[list[Piece], Sample]]:
        """The allowed values for some values of the data."""
        shapes: list[tuple[list[Piece], Sample]] = []
        data = self.data()
        rng = random.Random(17)
        for _ in range(DRAWS_TRIED if data else 1):
            drawn = sample(data, self.roles, rng)
            if self.base is not None and not self._in_base(drawn):
                continue
            pieces = self.pieces_at(drawn)
            if pieces:
                shapes.append((pieces, drawn))
            if len(shapes) == DRAWS:
                return shapes
        if shapes or not data or self.formula is None:
            return shapes
        possible = Oracle(self.roles, (*self.given, self.formula)).possible
        if possible.witness is not None:
            drawn = self._drawn(possible.witness)
            pieces = self.pieces_at(drawn)
            return [(pieces, drawn)] if pieces else []
        return []

    @property
    def given(self) -> tuple[Formula, ...]:
        return () if self.base is None else self.base.facts

    @cached_property
    def _base(self) -> Admission:
        given = [each for each in self.given if self.letter not in letters_of(each)]
        demands = tuple(Demand(each, "", "fact") for each in given)
        return Admission(self.roles, demands, ())

    def _in_base(self, drawn: Sample) -> bool:
        try:
            return self._base.objection(drawn) is None
        except (UndefinedError, KeyError):
            return False

    def _drawn(self, witness: Point) -> Sample:
        """The data of a point, with usual values for what it leaves out."""
        drawn = sample(self.data(), self.roles, random.Random(19))
        return drawn | {name: number_of(value) for name, value in witness.items() if name in drawn}

    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict:
        """Whether just these values are allowed: nothing outside, and everything inside.

        ``more`` are facts about the data, for which alone this is asked.
        """
        if self.formula is None:
            return Verdict("undecided", "undecided")
        inside = inside_of(self.symbol, pieces)
        given = (*self.given, *more)
        try:
            outer = Oracle(self.roles, (*given, self.formula)).decide(inside)
            if outer.answer != "proved":
                return outer
            if self.free:
                inner = Oracle(self.roles, (*given, inside)).decide_some(
                    self.formula, frozenset(self.free)
                )
            else:
                inner = Oracle(self.roles, (*given, inside)).decide(self.formula)
        except BeyondError:
            return Verdict("undecided", "undecided")
        if inner.answer != "proved":
            return inner
        return inner if outer.proof == "algebra" else outer

    def pieces_at(self, drawn: Sample) -> list[Piece]:
        """The allowed values for these values of the data."""
        numbered: list[tuple[Any, sp.Expr]] = []
        for point in self.critical:
            try:
                value = at(point, drawn)
            except (UndefinedError, KeyError):
                continue
            if not any(not (value - other).sign for other, _ in numbered):
                numbered.append((value, point))
        low = None if self.role.low is None else at(self.role.low, {})
        high = None if self.role.high is None else at(self.role.high, {})
        numbered = sorted(
            (
                pair
                for pair in numbered
                if (low is None or pair[0] >= low) and (high is None or pair[0] <= high)
            ),
            key=lambda pair: pair[0],
        )
        cells: list[tuple[sp.Expr | None, bool]] = []  # alternating: gap, point, gap, …
        edges = [None, *numbered, None]
        for left, right in pairwise(edges):
            beyond = (left is None and low is not None) or (right is None and high is not None)
            inside = False if beyond else self._gap(left, right, drawn)
            cells.append((None, inside))
            if right is not None:
                cells.append((right[1], self.allowed(right[0], drawn)))
        return _joined(cells)

    def _gap(self, left: Any, right: Any, drawn: Sample) -> bool:
        if left is None and right is None:
            points = [-7, 1, 11]
        elif left is None:
            points = [right[0] - 1, right[0] - 5]
        elif right is None:
            points = [left[0] + abs(left[0]) + 1, left[0] + 17]
        else:
            width = right[0] - left[0]
            points = [left[0] + width / 2, left[0] + width / 7, right[0] - width / 9]
        truths = {self.allowed(x, drawn) for x in points}
        if len(truths) > 1:
            raise UnsupportedError(
                f"the ends of the range of {self.letter} have no exact form that is found here"
            )
        return truths.pop()


def _at_end(x: sp.Expr, symbol: sp.Symbol, end: sp.Expr) -> sp.Expr | None:
    value = sp.together(x.xreplace({symbol: end})).as_numer_denom()[0]
    return None if value.has(sp.nan, sp.zoo, sp.oo) else sp.expand(value)


def _at_infinity(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """What decides the sign of a polynomial as a letter grows without end."""
    return sp.Poly(x, symbol).LC() if x.is_polynomial(symbol) else None


def inside_of(x: sp.Expr, pieces: Sequence[Piece]) -> Formula:
    """The claim that a value lies in one of some intervals."""
    parts: list[Formula] = []
    for low, high in pieces:
        if low.value == high.value:
            parts.append(Relation(x - low.value, "="))
            continue
        ends: list[Formula] = []
        if low.value != -sp.oo:
            ends.append(Relation(x - low.value, ">=" if low.closed else ">"))
        if high.value != sp.oo:
            ends.append(Relation(high.value - x, ">=" if high.closed else ">"))
        parts.append(All(tuple(ends)))
    return parts[0] if len(parts) == 1 else Some(tuple(parts))


def zeros(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    roles: Mapping[str, Role],
    wanted: str,
) -> list[sp.Expr]:
    """The values of one letter at which expressions vanish together."""
    angles = frozenset(s for s in unknowns if s.name in roles and roles[s.name].kind == "angle")
    acute = frozenset(
        s
        for s in angles
        if roles[s.name].low == 0
        and roles[s.name].high is not None
        and bool(roles[s.name].high <= sp.pi / 2)
    )
    bare = any(
        each.xreplace({f: sp.Integer(1) for f in each.atoms(sp.Function)}).has(s)
        for s in angles
        for each in equations
    )
    if bare:
        angles = acute = frozenset()
    values = []
    try:
        for solution in solve_system(list(equations), list(unknowns), angles, acute, roles):
            value = solution.values.get(wanted)
            if value is not None:
                values.append(exact.tidy_angle(value) if value.has(sp.atan, sp.atan2) else value)
    except (UnsupportedError, sp.PolynomialError, NotImplementedError):
        return []
    return values


@lru_cache(maxsize=1024)
def deciding(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """An expression's numerator and denominator, and what stands under its roots and bars."""
    top, bottom = sp.together(x).as_numer_denom()
    parts = [top, bottom]
    for node in sp.preorder_traversal(x):
        if node.is_Pow and node.exp.is_Rational and not node.exp.is_Integer:
            parts.append(sp.together(node.base).as_numer_denom()[0])
        elif isinstance(node, sp.Abs):
            parts.append(sp.together(node.args[0]).as_numer_denom()[0])
    return tuple(part for part in parts if part.free_symbols)


@lru_cache(maxsize=1024)
def _essential(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of an expression that can change sign."""
    try:
        factors = [f for f, _ in sp.factor_list(x)[1]] if sp.count_ops(x) < 400 else [x]
    except (sp.PolynomialError, NotImplementedError):
        factors = [x]
    return tuple(f for f in factors if f.free_symbols and not f.is_positive and not f.is_negative)


def _numeric_zeros(atoms: Sequence[sp.Expr], x: sp.Symbol, values: Mapping[str, Any]) -> list[Any]:
    """Where expressions vanish, in numbers, as one letter varies and the others are put in."""
    roots = []
    for atom in atoms:
        if not atom.has(x):
            continue
        others = {
            s: sp.Float(str(values[s.name]), DIGITS)
            for s in atom.free_symbols
            if s != x and s.name in values
        }
        if len(others) != len(atom.free_symbols) - 1:
            continue
        expression = atom.xreplace(others)
        angle = expression.has(sp.sin, sp.cos, sp.tan)
        if angle:
            t = sp.Dummy("t")
            expression = expression.xreplace(
                {
                    sp.sin(x): 2 * t / (1 + t**2),
                    sp.cos(x): (1 - t**2) / (1 + t**2),
                    sp.tan(x): 2 * t / (1 - t**2),
                }
            )
            variable = t
        else:
            variable = x
        try:
            poly = sp.Poly(sp.together(expression).as_numer_denom()[0], variable)
            roots_ = poly.nroots(n=35, maxsteps=200)
        except (
            sp.PolynomialError,
            sp.GeneratorsNeeded,
            ValueError,
            NotImplementedError,
            NoConvergence,
        ):
            continue
        for root in roots_:
            if abs(sp.im(root)) < 1e-18:
                value = at(sp.re(root), {})
                roots.append(2 * at(sp.atan(sp.re(root)), {}) if angle else value)
    return roots


def _representatives(numbers: list[Any], role: Role) -> list[Any]:
    """Numbers, points between them and points beyond them."""
    if not numbers:
        return [at(sp.Rational(1, 3), {})]
    points = [numbers[0] - 1, numbers[-1] + 1, numbers[-1] * 2 + 3]
    for a, b in pairwise(numbers):
        points += [a, (a + b) / 2]
        # Where a root hides a border, it may lie as near to an end as one likes.
        for power in NEAR:
            points += [a + (b - a) / 10**power, b - (b - a) / 10**power]
    points.append(numbers[-1])
    low = None if role.low is None else at(role.low, {})
    high = None if role.high is None else at(role.high, {})
    return [x for x in points if (low is None or x >= low) and (high is None or x <= high)]


def _joined(cells: list[tuple[sp.Expr | None, bool]]) -> list[Piece]:
    """Alternating gaps and points, true or false, as intervals."""
    pieces: list[Piece] = []
    start: End | None = None
    for index, (point, inside) in enumerate(cells):
        if point is None:  # a gap between points
            if inside and start is None:
                before = cells[index - 1][0] if index else None
                start = End(-sp.oo if before is None else before, False)
            continue
        if inside:
            if start is None:
                start = End(point, True)
            after = cells[index + 1][1] if index + 1 < len(cells) else False
            if not after:
                pieces.append((start, End(point, True)))
                start = None
        elif start is not None:
            pieces.append((start, End(point, False)))
            start = None
    if start is not None:
        pieces.append((start, End(sp.oo, False)))
    return pieces


def reconcile(shapes: list[tuple[list[Piece], Sample]]) -> list[Piece]:
    """One form for all the trials; ends that change places become the larger or the smaller."""
    counts = Counter(tuple(pieces) for pieces, _ in shapes)
    if len(counts) == 1:
        return shapes[0][0]
    sizes = {len(pieces) for pieces, _ in shapes}
    if sizes != {1}:
        raise UnsupportedError("the form of the range depends on the values of the data")
    lows = {pieces[0][0] for pieces, _ in shapes}
    highs = {pieces[0][1] for pieces, _ in shapes}
    low = _extreme(lows, [(p[0][0], d) for p, d in shapes], sp.Max, max)
    high = _extreme(highs, [(p[0][1], d) for p, d in shapes], sp.Min, min)
    return [(low, high)]


def _extreme(ends: set[End], seen: list[tuple[End, Sample]], form: Any, pick: Any) -> End:
    if len(ends) == 1:
        return next(iter(ends))
    for end, drawn in seen:
        values = [_end_at(each, drawn) for each in ends]
        if (_end_at(end, drawn) - pick(values)).sign:
            raise UnsupportedError("the form of the range depends on the values of the data")
    return End(form(*[each.value for each in ends]), all(each.closed for each in ends))


def _end_at(end: End, drawn: Sample) -> Any:
    if end.value in (sp.oo, -sp.oo):
        return Enclosed.of(INFINITE if end.value == sp.oo else -INFINITE)
    try:
        return at(end.value, drawn)
    except UndefinedError:
        raise UnsupportedError("the form of the range depends on the values of the data") from None


def to_set(pieces: Sequence[Piece]) -> sp.Set:
    """Intervals as one SymPy set, the ends in textbook form."""
    sets = []
    for low, high in pieces:
        a, b = (forms.bound(each.value) for each in (low, high))
        if a == b:
            sets.append(sp.FiniteSet(a))
        else:
            sets.append(sp.Interval(a, b, not low.closed, not high.closed))
    return sp.Union(*sets) if sets else sp.S.EmptySet


def with_solved(trial: Trial, values: Sample) -> Sample:
    """Values of the free letters with those of the letters that were solved for."""
    numbers = dict(values)
    for name, each in trial.root.values.items():
        numbers[name] = at(each, numbers)
    return numbers
