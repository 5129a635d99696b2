"""The values that a letter can take: intervals with exact ends, sought and then proved.

Where a condition can change from true to false, one of the expressions in it vanishes, or has no
value. Those points are found exactly; between them one trial by numbers decides. Data letters are
tried at several random values. What is found so is a guess: the oracle proves it for all values of
the data, or gives values for which it is wrong, from which a better guess is made.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import pairwise, product, zip_longest
from types import MappingProxyType

import sympy as sp

from restitution.errors import ImpossibleError, RestitutionError, UnsupportedError
from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle import (
    BeyondError,
    Formula,
    Oracle,
    Point,
    Proof,
    Relation,
    Some,
    Verdict,
    as_number,
    joined,
    letters_of,
    put_in,
    relations,
)
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra import forms
from restitution.solving.algebra.intervals import (
    Piece,
    inside_of,
    joined_cells,
    reconcile,
    same_values_at,
    with_existence,
)
from restitution.solving.algebra.numbers import Sample, at, number_of, sample
from restitution.solving.equations.part import Outcome
from restitution.solving.equations.setting import Setting, Trial, out_of_range
from restitution.solving.ranges.zeros import (
    at_end,
    at_infinity,
    deciding,
    essential_factors,
    numeric_zeros,
    representatives,
    told_apart,
    zeros,
)
from restitution.solving.story.admission import Admission, Demand
from restitution.solving.story.conditions import AnyOf, Condition
from restitution.solving.story.unknowns import Letters
from restitution.work import spend

DRAWS = 4


DRAWS_TRIED = 60


OTHERS_TRIED = 16
"""Values of the data at which intervals that are not proved are looked for again."""


ROUNDS = 4


MOST_CHOICES = 200
"""So many choices of free letters are tried at one value."""


MOST_AT_ENDS = 2
"""Of more free letters no choice at the ends of all of them is tried."""


# Far above rounding, and as nothing beside what is known with so many digits.
ASIDE = Fraction(1, 10**196)


Border = tuple[Enclosed, sp.Expr]
"""A critical value of a letter, in numbers and as it is."""


def _has_values(trial: Trial) -> bool:
    """Whether what a solution asks of the letters has a value: with no mass, some has none."""
    if trial.admission is None:
        return True
    values = [relation.value for d in trial.admission.demands for relation in relations(d.formula)]
    return not any(value.has(sp.nan, sp.zoo) for value in (*values, *trial.admission.equations))


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
        self.trials = [
            trial
            for trial in self.outcome.trials
            if trial.kind != "equation" and _has_values(trial) and self._can_happen(trial)
        ]
        self._kept_atoms = self._atoms()
        matter = symbol_names(*self._kept_atoms)
        self.free = tuple(name for name in self.free if name in matter)
        self.critical = self._critical()
        self._chosen: list[dict[sp.Expr, sp.Expr]] = []  # what free letters are at ends

    def _can_happen(self, trial: Trial) -> bool:
        """Whether a motion can be told with a solution: who is at rest, by e = 0, reaches nothing.

        Where it cannot, the solution is none for any values of the letters.
        """
        if trial.samples or self._demands(trial) is not None:
            return True
        try:
            self.setting.tell(Letters(self.setting.roles, trial.root.values, trial.root.angles))
        except ImpossibleError:
            return False
        return True

    # --- where truth can change --------------------------------------------------------------

    def _atoms(self) -> list[sp.Expr]:
        """The expressions whose signs decide, with what was solved put in."""
        atoms: list[sp.Expr] = []
        for trial in self.trials:
            demands = self._demands(trial)
            if demands is not None:
                atoms += [relation.value for d in demands for relation in relations(d.formula)]
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
            role, symbol = self.roles[name], self.roles[name].symbol(name)
            for bound in (role.low, role.high):
                if bound is not None and name in symbol_names(*atoms):
                    atoms.append(symbol - bound)
        unique: list[sp.Expr] = []
        oracle = Oracle(self.roles)
        for atom in atoms:
            atom = atom.xreplace(forms.bars_of(atom, oracle))
            for part in (*deciding(atom), *told_apart(atom)):
                for factor in essential_factors(part):
                    if factor not in unique:
                        unique.append(factor)
        return unique

    @property
    def critical_groups(self) -> list[list[sp.Expr]]:
        """All that may be an end of an interval; any two of these may meet."""
        return [self.critical]

    @cached_property
    def of_data(self) -> list[sp.Expr]:
        """The expressions that decide whatever varies: whether anything is possible at all."""
        varying = {self.symbol, *(self.roles[name].symbol(name) for name in self.free)}
        return [atom for atom in self._kept_atoms if not atom.free_symbols & varying]

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
        free = {self.roles[name].symbol(name) for name in self.free}
        atoms = [*atoms, *self._at_ends(atoms)]
        plain = [atom for atom in atoms if not atom.free_symbols & free]
        mixed = [atom for atom in atoms if atom.free_symbols & free]
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
            if not any(point == value for value in unique):
                unique.append(point)
        return unique

    def _at_ends(self, atoms: Sequence[sp.Expr]) -> list[sp.Expr]:
        """The expressions where free letters come to the ends of what they may be."""
        reached = list(atoms)
        for name in self.free:
            role = self.roles[name]
            symbol = role.symbol(name)
            for atom in [value for value in reached if value.has(symbol)]:
                for end in (role.low, role.high):
                    own = at_infinity(atom, symbol) if end is None else at_end(atom, symbol, end)
                    if own is not None:
                        reached += [x for x in essential_factors(own) if x not in reached]
        return reached[len(atoms) :]

    def _at_closed_ends(self) -> Iterator[dict[sp.Expr, sp.Expr]]:
        """The free letters at ends that they have: one choice may serve for all values."""
        names = {name: self.roles[name] for name in self.free}
        ends = [
            [
                (role.symbol(name), end)
                for end, closed in zip((role.low, role.high), role.closed, strict=True)
                if end is not None and closed
            ]
            for name, role in names.items()
        ]
        if len(ends) <= MOST_AT_ENDS:
            yield from map(dict, product(*ends))

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

    def allowed(self, value: Enclosed, drawn: Sample) -> bool:
        """Whether the letter may have this numerical value, the data being as drawn."""
        if not self.free:
            return self._possible({**drawn, self.letter: value})
        return any(
            self._possible({**drawn, self.letter: value, **extra})
            for extra in self._choices(value, drawn)
        )

    def _choices(self, value: Enclosed, drawn: Sample) -> list[Sample]:
        """Values of the free letters that stand for all: between and at the critical ones."""
        chosen: list[Sample] = [{}]
        for name in self.free:
            inner = Region.__new__(Region)
            inner.outcome, inner.letter, inner.free = self.outcome, name, ()
            inner.setting, inner.role = self.setting, self.roles[name]
            inner.symbol = inner.role.symbol(name)
            inner.trials = self.trials
            rows: list[list[Sample]] = []
            for known in chosen:
                spend()
                values = {**drawn, self.letter: value, **known}
                numbers = numeric_zeros(self._kept_atoms, inner.symbol, values)
                role = inner.role
                for bound in (role.low, role.high):
                    if bound is not None:
                        numbers.append(at(bound, {}))
                rows.append([{**known, name: x} for x in representatives(sorted(numbers), role)])
            # Of too many those are left out that are close to others, in whatever letter.
            columns = zip_longest(*rows)
            chosen = [one for column in columns for one in column if one is not None][:MOST_CHOICES]
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
                            with_solved(trial, {**values, name: values[name] + number})
                            for number in (step, step / 4)
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
        if self.proof == "undecided":
            shapes += self._others(reconcile(shapes))
        return reconcile(shapes)

    def _others(self, pieces: Sequence[Piece]) -> Iterator[tuple[list[Piece], Sample]]:
        """Values of the data for which intervals that are not proved are seen to be others."""
        data, rng = self.data(), random.Random(53)
        for number in range(OTHERS_TRIED if data else 0):
            drawn = sample(data, self.roles, rng, number % 3 == 2)
            if self.base is not None and not self._in_base(drawn):
                continue
            own = self.pieces_at(drawn)
            if not same_values_at(own, pieces, drawn):
                yield own, drawn
                return

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
        if shapes or self.formula is None:
            return shapes
        try:
            possible = Oracle(self.roles, (*self.given, self.formula)).possible
        except BeyondError:
            return []
        if data and possible.witness is not None:
            drawn = self._drawn(possible.witness)
            pieces = self.pieces_at(drawn)
            if pieces:
                return [(pieces, drawn)]
        if possible.answer == "proved":
            # There are values, and they lie between ends that were not found.
            raise UnsupportedError(
                f"the ends of the range of {self.letter} have no exact form that is found here"
            )
        return []

    @property
    def given(self) -> tuple[Formula, ...]:
        return () if self.base is None else self.base.facts

    @cached_property
    def _base(self) -> Admission:
        given = [formula for formula in self.given if self.letter not in letters_of(formula)]
        demands = tuple(Demand(formula, "", "fact") for formula in given)
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
            outer = Oracle(self.roles, (*given, self.formula)).decide(
                with_existence(inside, pieces)
            )
            if outer.answer != "proved":
                return outer
            if self.free:
                within = Oracle(self.roles, (*given, inside))
                inner = within.decide_some(self.formula, frozenset(self.free))
                for chosen in (*self._chosen, *self._at_closed_ends()):
                    if inner.answer == "undecided":
                        inner = _as_proof(within.decide(put_in(self.formula, chosen)))
            else:
                inner = Oracle(self.roles, (*given, inside)).decide(self.formula)
        except BeyondError:
            return Verdict("undecided", "undecided")
        if inner.answer != "proved":
            return inner
        return inner if outer.proof == "algebra" else outer

    def pieces_at(
        self, drawn: Sample, put: Mapping[sp.Symbol, sp.Expr] = MappingProxyType({})
    ) -> list[Piece]:
        """The allowed values for these values of the data; ``put`` has some exactly."""
        numbered: list[Border] = []
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
        edges: list[Border | None] = [None, *numbered, None]
        for left, right in pairwise(edges):
            beyond = (left is None and low is not None) or (right is None and high is not None)
            inside = False if beyond else self._gap(left, right, drawn)
            cells.append((None, inside))
            if right is not None:
                cells.append((right[1], self.allowed(right[0], drawn)))
        for n, (point, inside) in enumerate(cells):
            if point is None or inside or not (cells[n - 1][1] or cells[n + 1][1]):
                continue
            if out_of_range(self.letter, at(point, drawn), self.role) is None:
                cells[n] = (point, self._is_reached(point, drawn))
        return joined_cells(cells)

    def _is_reached(self, end: sp.Expr, drawn: Sample) -> bool:
        """Whether a value next to an allowed one is allowed, with one choice of free letters.

        There an expression touches zero, and numbers tell no more than that it comes near to it.
        """
        if not self.free or self.formula is None:
            return False
        there = put_in(self.formula, {self.symbol: end})
        try:
            possible = Oracle(self.roles, (*self.given, there)).possible
            if possible.witness is None:
                return False
            # The free letters may have the same values whatever the data are.
            chosen: dict[sp.Expr, sp.Expr] = {
                self.roles[name].symbol(name): as_number(possible.witness[name])
                for name in self.free
                if name in possible.witness
            }
            if Oracle(self.roles, self.given).decide(put_in(there, chosen)):
                if chosen not in self._chosen:
                    self._chosen.append(chosen)
                return True
            data = {
                self.roles[name].symbol(name): sp.Rational(value.fraction)
                for name, value in drawn.items()
            }
            return bool(Oracle(self.roles, (put_in(there, data),)).possible)
        except BeyondError:
            return False

    def _gap(self, left: Border | None, right: Border | None, drawn: Sample) -> bool:
        match left, right:
            case (low, _), (high, _):
                width = high - low
                points = [low + width / 2, low + width / 7, high - width / 9]
            case (low, _), None:
                points = [low + abs(low) + 1, low + 17]
            case None, (high, _):
                points = [high - 1, high - 5]
            case _:
                points = [Enclosed.of(x) for x in (-7, 1, 11)]
        truths = {self.allowed(x, drawn) for x in points}
        if len(truths) > 1:
            raise UnsupportedError(
                f"the ends of the range of {self.letter} have no exact form that is found here"
            )
        return truths.pop()


def _as_proof(verdict: Verdict) -> Verdict:
    """The verdict on one choice of free letters, which proves and refutes nothing of others."""
    return verdict if verdict else Verdict("undecided", "undecided")


def with_solved(trial: Trial, values: Sample) -> Sample:
    """Values of the free letters with those of the letters that were solved for."""
    numbers = dict(values)
    for name, value in trial.root.values.items():
        numbers[name] = at(value, numbers)
    return numbers
