"""Solving one part: which letters are unknown, what they are, and which roots are admissible."""

from __future__ import annotations

import random
from collections import ChainMap, Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp

from restitution.errors import (
    ContradictionError,
    ImpossibleError,
    RestitutionError,
    StatementError,
    UnsupportedError,
)
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.evaluate import Symbolic, Value
from restitution.expression.tree import Expression, Letter, Place, has_quantity, letters
from restitution.oracle import BeyondError, Formula, Oracle, Point, Relation
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.problem import (
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Let,
    Part,
    Problem,
    Range,
    Show,
    Unknown,
)
from restitution.problem import Value as ValueItem
from restitution.solving import missing
from restitution.solving.admission import (
    COEFFICIENT_RULE,
    Admission,
    demands_for,
    demands_of,
    formula_of,
)
from restitution.solving.algebra import Root, solve_system
from restitution.solving.conditions import AnyOf, Condition, Equation
from restitution.solving.contacts import ends_at_a_point, rests_on
from restitution.solving.facts import givens, requirements
from restitution.solving.letters import (
    narrowed_by,
    roles,
)
from restitution.solving.numbers import (
    FIELD,
    Sample,
    at,
    bound,
    number_of,
    plain_sign,
    sample,
    sign_at,
)
from restitution.solving.stages import by_nested_roots, fixed_besides, solve_in_stages
from restitution.solving.story import Sign, Story, lets_of

SAMPLES_WANTED = 4
# Where the form of an answer hangs on a sign, four points are too few.
SAMPLES_FOR_SIGNS = 24
SAMPLES_TRIED = 160
POINTS_TRIED = 48
# What is longer than this nobody would read, and takes long to put into a tidy form.
UNWIELDY = 120
EDGES_TRIED = 4
SYMBOLIC = Symbolic()


@dataclass
class Letters:
    """Letters and hidden unknowns as symbols, or as values where they are known."""

    roles: Mapping[str, Role]
    values: Mapping[str, sp.Expr] = field(default_factory=dict)
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]] = field(default_factory=dict)
    samples: Sequence[Sample] = ()
    phrases: dict[str, str] = field(default_factory=dict)
    hidden_roles: dict[str, Role] = field(default_factory=dict)
    ground: Oracle | None = None
    assumed: list[Formula] = field(default_factory=list)
    undecided: list[sp.Expr] = field(default_factory=list)
    sought: frozenset[str] | None = None  # letters on which places of contact are not to rest

    def letter(self, name: str) -> Value:
        if name in self.angles:
            c, s = self.angles[name]
            from restitution.expression.evaluate import Angle

            return Angle(c, s, lambda: self.values[name])
        if name in self.values:
            return self.values[name]
        return self.roles.get(name, POSITIVE).symbol(name)

    def hidden(self, key: str, phrase: str, sign: Sign) -> sp.Expr:
        name = f"_{key}"
        self.phrases[name] = phrase
        self.hidden_roles[name] = POSITIVE if sign == "positive" else REAL
        if name in self.values:
            return self.values[name]
        return self.hidden_roles[name].symbol(name)

    def all_roles(self) -> dict[str, Role]:
        return {**self.roles, **self.hidden_roles}

    @property
    def certain(self) -> bool:
        """Whether all signs that a telling rests on are proved."""
        return not self.undecided and not self.assumed

    def seeks_contact(self, number: int, values: Iterable[sp.Expr]) -> bool:
        """Whether the place of an event is an unknown of its own; once found, it is known."""
        if f"_c_{number}x" in self.values:
            return True
        return self.sought is not None and rests_on(values, self.sought)

    def sign(self, x: sp.Expr, given: Sequence[Condition | AnyOf] = ()) -> int | None:
        """The sign of an expression where conditions hold; None where it depends on the letters.

        One that is seen at usual values, but is not proved for all, is among ``assumed``; what
        has different signs is among ``undecided``.
        """
        x = sp.sympify(x, strict=True)
        plain = plain_sign(x)
        if plain is not None:
            return plain
        if self.ground is None:
            self.ground = Oracle(ChainMap(dict(self.roles), self.hidden_roles))
        proved = self.ground.sign(x)
        if proved is None and given:
            facts = [formula_of(each) for each in given]
            proved = self.ground.with_facts(dict.fromkeys(facts)).sign(x)
        if proved is not None:
            return proved
        points: Iterable[Sample] = self.samples
        if not points:
            rng = random.Random(7)
            names = sorted(s.name for s in x.free_symbols)
            known = self.all_roles()
            points = [sample(names, known, rng) for _ in range(8)]
        usual = sign_at(x, points)
        if usual is None:
            self.undecided.append(x)
        else:
            self.assumed.append(Relation(usual * x, ">") if usual else Relation(x, "="))
        return usual


@dataclass
class Numbers:
    """Letters and hidden unknowns as numbers."""

    values: Mapping[str, Any]

    def letter(self, name: str) -> Any:
        if name not in self.values:
            raise UndefinedError(name)
        return self.values[name]

    def hidden(self, key: str, phrase: str, sign: Sign) -> Any:
        name = f"_{key}"
        if name not in self.values:
            raise UndefinedError(name)
        return self.values[name]

    def sign(self, x: Any, given: Sequence[Condition | AnyOf] = ()) -> int:
        return Enclosed.of(x).sign


@dataclass(frozen=True)
class Trial:
    """The outcome of a set of values: accepted with samples, or refused for a reason.

    ``story`` is told with the values, ``numbers`` with the first of the samples. ``rare`` says why
    it is impossible at usual values of the letters, where it is.
    """

    root: Root
    samples: tuple[Sample, ...]
    reason: str | None = None
    kind: str | None = None
    admission: Admission | None = field(default=None, compare=False, repr=False)
    story: Story | None = field(default=None, compare=False, repr=False)
    rare: tuple[str, str] | None = None
    numbers: Story | None = field(default=None, compare=False, repr=False)

    @property
    def formulas_suffice(self) -> bool:
        """Whether the formulas say all that is asked of the letters, as far as one telling shows.

        Where that is so, numbers need not be put into the story to see whether they are possible.
        """
        return (
            self.admission is not None
            and _needs_no_numbers(self.story)
            and _needs_no_numbers(self.numbers)
        )


@dataclass
class Setting:
    """One part as one of its items sees it: what is data, what is unknown, what is in force.

    ``protected`` letters are data; ``spared`` ones too, unless nothing else is left that the facts
    could fix; so are those that answers are to be written in, but not the ``fixed`` ones, over
    which a range or an extremum runs. ``shows`` are the claims that tell which letter a fact is
    taken to fix.
    """

    problem: Problem
    part: Part
    protected: frozenset[str]
    spared: frozenset[str]
    fixed: frozenset[str]
    extra_unknown: frozenset[str]
    roles: dict[str, Role]
    lets: dict[str, tuple[Let, int]]
    named: list[tuple[Let, int]]
    facts: list[tuple[Given, int]]
    asked: frozenset[str]
    carried: frozenset[str]
    shows: tuple[Show, ...]

    @property
    def unknown(self) -> frozenset[str]:
        """The letters that are solved for wherever the equations hold them."""
        return self.extra_unknown | self.asked | self.carried

    @property
    def sought(self) -> frozenset[str] | None:
        """The letters on which no place of contact is to rest; None where none is sought."""
        if not ends_at_a_point(self.problem, self.part):
            return None
        return self.unknown or frozenset(self.roles) - self.protected - self.spared

    # --- telling ---------------------------------------------------------------------------

    def tell(self, unknowns: Letters | Numbers) -> Story:
        """The story with these values, symbolically or in numbers."""
        arithmetic = FIELD if isinstance(unknowns, Numbers) else SYMBOLIC
        return Story(self.problem, self.part, arithmetic, unknowns, self.lets)

    def requirements(self, story: Story) -> list[Equation | Condition | AnyOf]:
        """Requirements of the facts and of the names in force, in this story."""
        requirements_: list[Equation | Condition | AnyOf] = []
        for given, now in self.facts:
            for relation in given.relations:
                requirements_ += requirements(relation, story, now, given.place)
        for let, now in self.named:
            relation = Compare((Letter(let.letter), let.expression), ("=",))
            requirements_ += requirements(relation, story, now, let.place)
        return requirements_

    # --- checking --------------------------------------------------------------------------

    def examine(
        self,
        values: Mapping[str, Any],
        solved: Iterable[str],
        story: Story | None = None,
        stories: list[Story] | None = None,
    ) -> tuple[str, str] | None:
        """Why these numbers are impossible, as (reason, kind); None if they are not.

        ``story`` is what they lead to, where that has been told already; it is added to ``stories``
        where nothing speaks against it. Raises UndefinedError where something has no real value.
        """
        outside = [
            problem
            for name in solved
            if (problem := out_of_range(name, values[name], self.roles.get(name))) is not None
        ]
        if outside:
            # An impossible coefficient is blamed only where nothing else is wrong.
            return next((each for each in outside if each[1] != "coefficient"), outside[0])
        try:
            story = story or self.tell(Numbers(values))
        except ImpossibleError as error:
            return error.message, "place"
        wanted = self.requirements(story)
        for need in (*story.conditions, *wanted):
            if isinstance(need, Condition) and not holds(need):
                return need.reason, need.kind
            if isinstance(need, AnyOf) and not any(holds(option) for option in need.options):
                return need.reason, need.kind
        for need in (*story.equations, *wanted):
            if isinstance(need, Equation) and Enclosed.of(need.value).sign:
                return need.reason, "equation"
        if stories is not None:
            stories.append(story)
        return None

    def admission(
        self,
        assignment: Root,
        letters_: Letters,
        solved_letters: Letters,
        story: Story,
        needs: Sequence[Equation | Condition | AnyOf] | None = None,
    ) -> Admission | None:
        """What a solution asks of the letters left free, where the story is told with it.

        ``needs`` are its requirements, where they are known already.
        None where the telling hangs on a sign that differs with the letters.
        Raises ImpossibleError where the facts are impossible whatever they are.
        """
        if needs is None:
            needs = self.requirements(story)
        if solved_letters.undecided:
            return None
        demands, equations = demands_for([*story.conditions, *story.equations, *needs])
        known = {**letters_.all_roles(), **solved_letters.all_roles()}
        own = demands_of(assignment.values, assignment.angles, known, letters_.phrases)
        assumed = tuple(dict.fromkeys(solved_letters.assumed))
        return Admission(known, (*own, *demands), tuple(equations), assumed)

    def try_out(
        self,
        assignment: Root,
        letters_: Letters,
        open_story: Story | None = None,
        wanted: Sequence[Equation | Condition | AnyOf] | None = None,
    ) -> Trial:
        """Whether a solution is admissible for some values of the data.

        ``open_story`` is the story told with ``letters_``, ``wanted`` its requirements: nothing
        new is told where no values have been added to those of the letters.
        """
        long = any(sp.count_ops(value) > UNWIELDY for value in assignment.values.values())
        if long or by_nested_roots(assignment.values):
            return self._tried(assignment, letters_)
        solved_letters = Letters(self.roles, assignment.values, assignment.angles)
        alike = letters_.values == assignment.values and letters_.angles == assignment.angles
        if open_story is not None and alike and letters_.sought is None:
            solved_letters, story = letters_, open_story
        else:
            wanted = None
            try:
                story = self.tell(solved_letters)
            except ImpossibleError as error:
                return Trial(assignment, (), error.message, "place")
        try:
            admission = self.admission(assignment, letters_, solved_letters, story, wanted)
        except ImpossibleError as error:
            return Trial(assignment, (), error.message, "equation")
        except BeyondError:
            return self._tried(assignment, letters_)
        if admission is None:
            return self._tried(assignment, letters_)
        return self._admitted(assignment, letters_, admission, story)

    def _admitted(
        self, assignment: Root, letters_: Letters, admission: Admission, story: Story
    ) -> Trial:
        known = admission.roles
        if any(role.kind == "restitution" and _is_empty(role) for role in known.values()):
            return Trial(assignment, (), COEFFICIENT_RULE, "coefficient", admission)
        free = sorted((set(self.roles) | set(known)) - set(assignment.values) - set(self.lets))
        reasons: Counter[tuple[str, str]] = Counter()
        accepted: list[Sample] = []
        stories: list[Story] = []
        rng = random.Random(11)
        for attempt in range(POINTS_TRIED if free else 1):
            values = sample(free, known, rng)
            if not attempt:  # a working is written at the first: where signs are as they look
                values = {n: x if x.sign >= 0 else -x for n, x in values.items()}
            numbers = stories[0] if stories else None
            trial = Trial(assignment, (), None, None, admission, story, None, numbers)
            reason = self._objection(trial, values, stories)
            if reason is None:
                accepted.append(values)
                if len(accepted) == SAMPLES_WANTED:
                    break
            else:
                reasons[reason] += 1
        if not accepted:
            pinned = self._pinned(assignment, letters_, admission, free)
            if pinned is not None:
                return pinned
            possible = admission.oracle.possible
            if possible.answer == "proved" and possible.witness is not None:
                values = sample(free, known, rng)
                values |= {name: number_of(each) for name, each in possible.witness.items()}
                trial = Trial(assignment, (), None, None, admission, story)
                reason = self._objection(trial, values, stories, possible.witness)
                if reason is None:
                    accepted.append(values)
                else:
                    reasons[reason] += 1
        if accepted:
            rare = reasons.most_common(1)[0][0] if len(accepted) == 1 and free else None
            return Trial(
                assignment, tuple(accepted), None, None, admission, story, rare, stories[0]
            )
        (reason_, kind), _ = reasons.most_common(1)[0]
        refusal = None if kind == "equation" else admission.refusal()
        if refusal is not None:
            return Trial(assignment, (), refusal.reason, refusal.kind, admission)
        return Trial(assignment, (), reason_, kind, admission)

    def _pinned(
        self, assignment: Root, letters_: Letters, admission: Admission, free: Sequence[str]
    ) -> Trial | None:
        """The solution in which letters that are sought have the one value that is possible.

        e₁e₂ = 1 leaves one of them open, until 0 ≤ e ≤ 1 of both is used.
        """
        possible = admission.oracle.possible
        if possible.answer != "proved" or possible.witness is None:
            return None
        pinned: dict[str, sp.Expr] = {}
        for name in free:
            value = possible.witness.get(name)
            if name not in self.unknown or not isinstance(value, Fraction):
                continue
            number = sp.Rational(value.numerator, value.denominator)
            symbol = admission.roles[name].symbol(name)
            if admission.oracle.decide(Relation(symbol - number, "=")):
                pinned[name] = number
        if not pinned:
            return None
        put = {admission.roles[name].symbol(name): value for name, value in pinned.items()}
        values = {name: value.xreplace(put) for name, value in assignment.values.items()}
        angles = {
            name: (c.xreplace(put), s.xreplace(put)) for name, (c, s) in assignment.angles.items()
        }
        return self.try_out(Root({**values, **pinned}, angles, assignment.leftover), letters_)

    def _objection(
        self, trial: Trial, values: Sample, stories: list[Story], point: Point | None = None
    ) -> tuple[str, str] | None:
        """Why these values of the free letters are impossible; the solved ones are added.

        ``point`` has the exact values of some of them. The story told with them is added to
        ``stories``, where it takes one to see that they are possible.
        """
        assignment, suffices = trial.root, trial.formulas_suffice and self.sought is None
        try:
            if trial.admission is not None:
                try:
                    reason = trial.admission.objection({**values, **(point or {})})
                    if reason is not None:
                        return reason
                except LookupError:
                    suffices = False
            for name, value in assignment.values.items():
                values[name] = at(value, values)
            if suffices:
                return None
            solved = [name for name in assignment.values if not name.startswith("_")]
            return self.examine(values, solved, None, stories)
        except (StatementError, ImpossibleError) as error:
            return error.message, "equation"
        except (UndefinedError, ArithmeticError):
            return "it would not be real", "equation"

    def _tried(
        self,
        assignment: Root,
        letters_: Letters,
        wanted: int = SAMPLES_WANTED,
        trial: Trial | None = None,
    ) -> Trial:
        """The trial by points alone, for values too unwieldy for a story in letters.

        ``trial`` is one with the same values where they could be told; more samples are sought.
        """
        known = letters_.all_roles()
        rng = random.Random(11)
        free = sorted(
            (set(self.roles) | set(letters_.hidden_roles)) - set(assignment.values) - set(self.lets)
        )
        solved = [name for name in assignment.values if not name.startswith("_")]
        hidden = [name for name in assignment.values if name.startswith("_")]
        reasons: Counter[tuple[str, str]] = Counter()
        accepted: list[Sample] = []
        last_error: RestitutionError | None = None
        depends = any(name in self._used_letters() for name in free) or any(
            name.startswith("_") for name in free
        )
        tries = SAMPLES_TRIED if depends else 1
        edges_left = EDGES_TRIED
        for attempt in range(tries):
            # Signs that hold at a few typical values may fail near the ends.
            at_edge = len(accepted) >= SAMPLES_WANTED and (attempt % 2 == 0 or edges_left > 0)
            if len(accepted) >= wanted and not edges_left:
                break
            edges_left -= at_edge and edges_left > 0
            values = sample(free, known, rng, at_edge)
            try:
                for name, value in assignment.values.items():
                    values[name] = at(value, values)
                wrong = next(
                    (
                        (f"{letters_.phrases.get(name, name)} would be negative", "sign")
                        for name in hidden
                        if known[name].low is not None and not values[name] > 0
                    ),
                    None,
                )
                if trial is not None and trial.formulas_suffice and self.sought is None:
                    wrong = wrong or self._objection(trial, values, [])
                else:
                    wrong = wrong or self.examine(values, solved)
            except (StatementError, ImpossibleError) as error:
                reasons[error.message, "equation"] += 1
                last_error = error
                continue
            except (UndefinedError, ArithmeticError):
                reasons["it would not be real", "equation"] += 1
                continue
            if wrong is None:
                accepted.append(values)
            else:
                reasons[wrong] += 1
        if accepted:
            return Trial(assignment, tuple(accepted))
        (reason, kind), _ = reasons.most_common(1)[0]
        if last_error is not None and not assignment.values:
            raise last_error
        return Trial(assignment, (), reason, kind)

    def _used_letters(self) -> set[str]:
        return set(self.roles) - set(self.lets)


def _needs_no_numbers(story: Story | None) -> bool:
    return story is not None and not story.needs_numbers


def _is_empty(role: Role) -> bool:
    return role.low is not None and role.high is not None and bool(role.low > role.high)


def holds(condition: Condition) -> bool:
    """Whether a condition holds, in numbers."""
    sign = Enclosed.of(condition.value).sign
    return {">": sign > 0, ">=": sign >= 0, "!=": sign != 0}[condition.relation]


def out_of_range(name: str, value: Any, role: Role | None) -> tuple[str, str] | None:
    """Why a letter may not have this value."""
    if role is None:
        return None
    low, high = bound(role.low), bound(role.high)
    value = Enclosed.of(value)
    below = low is not None and (value < low if role.closed[0] else not value > low)
    above = high is not None and (value > high if role.closed[1] else not value < high)
    if not below and not above:
        return None
    if role.kind == "restitution":
        if 0 <= value <= 1:
            return "a given inequality does not hold", "fact"
        return COEFFICIENT_RULE, "coefficient"
    if role.kind == "angle":
        ends = [f"{float(x) * 180 / 3.141592653589793:.4g}°" for x in (low, high) if x is not None]
        return f"the angle must lie between {' and '.join(ends)}", "range"
    if below and low == 0:
        return f"{name} must be positive", "range"
    return f"{name} is outside the range given for it", "range"


# --- setting up ---------------------------------------------------------------------------------


def settle(
    problem: Problem,
    part: Part,
    in_terms_of: tuple[str, ...] | None,
    item: Range | Extremum | Show | None = None,
    data: frozenset[str] = frozenset(),
    carried: frozenset[str] = frozenset(),
) -> Setting:
    """What is known, asked and unknown in a part, for one item.

    The values that a part asks for share their unknowns and so their solutions: for them ``item``
    is None. A range, an extremum or a claim is settled by itself, beside those values alone: no
    other item changes its answer. ``data`` are further letters to be held as data.
    """
    known = roles(problem)
    facts = givens(problem, part)
    for given, _ in facts:
        for name, role in known.items():
            known[name] = narrowed_by(role, name, given)
    lets = lets_of(problem, part)
    listed = frozenset(in_terms_of or ())
    named = [pair for name, pair in lets.items() if name in listed]
    lets = {name: pair for name, pair in lets.items() if name not in listed}
    asked, spared = _asked(part)
    fixed = data
    if isinstance(item, Range) and isinstance(item.expression, Letter):
        fixed |= {item.expression.name}
    elif isinstance(item, Extremum):
        fixed |= letters(item.over)
        if not has_quantity(item.expression):
            asked |= letters(item.expression)
    protected = listed | fixed
    asked -= set(lets) | protected
    extra = declared(problem, part) - set(lets)
    if in_terms_of is not None:
        extra |= set(known) - listed - set(lets)
    return Setting(
        problem,
        part,
        protected,
        frozenset() if item is not None else spared - protected - asked - extra,
        fixed,
        extra - fixed,
        known,
        lets,
        named,
        facts,
        asked,
        carried,
        _claims(part, item),
    )


def _asked(part: Part) -> tuple[frozenset[str], frozenset[str]]:
    """Letters asked for in a part, and those over which it has ranges and extrema."""
    asked: set[str] = set()
    together: list[frozenset[str]] = []
    over: set[str] = set()
    for step in part.steps:
        items: tuple[object, ...] = ()
        if isinstance(step, Find):
            items = step.items
        elif isinstance(step, Show):
            items = (step.subject,)
        for item in items:
            match item:
                case ValueItem(Letter(name)):
                    asked.add(name)
                case ValueItem(tree) if not has_quantity(tree):
                    together.append(letters(tree))
                case Range(Letter(name)):
                    over.add(name)
                case Extremum():
                    over |= letters(item.over)
    for group in together:
        # Of the letters in M/m one is sought; what else the facts fix is found as they are used.
        if group and not group & asked:
            asked.add(min(group))
    return frozenset(asked), frozenset(over)


def _claims(part: Part, item: Range | Extremum | Show | None) -> tuple[Show, ...]:
    if isinstance(item, Show):
        return (item,)
    if item is not None:
        return ()
    return tuple(step for step in part.steps if isinstance(step, Show))


def declared(problem: Problem, part: Part) -> frozenset[str]:
    """The letters that lines in force in a part declare unknown."""
    return frozenset(
        letter
        for step, _, _ in problem.timeline(part)
        if isinstance(step, Unknown)
        for letter in step.letters
    )


# --- solving ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Decision:
    """The choice of one letter that the left-over facts are taken to fix."""

    present: frozenset[str]
    chosen: frozenset[str]
    letter: str | None


@dataclass(frozen=True)
class Outcome:
    """All that solving the unknowns of a part gave.

    ``deciding`` are the letters in its equations, ``decisions`` what was decided on the way.
    """

    setting: Setting
    trials: tuple[Trial, ...]
    letters: Letters
    open_story: Story
    deciding: frozenset[str]
    decisions: tuple[Decision, ...]

    @property
    def accepted(self) -> list[Trial]:
        return [trial for trial in self.trials if trial.samples]

    def witnesses(self, trial: Trial) -> Witnesses:
        """The samples of an accepted trial, with more to be had; drawn once for all items."""
        return self._witnesses.setdefault(id(trial), Witnesses(self, trial))

    @cached_property
    def _witnesses(self) -> dict[int, Witnesses]:
        return {}

    @property
    def refused(self) -> list[Trial]:
        return [trial for trial in self.trials if not trial.samples and trial.kind != "equation"]

    def serves(self, setting: Setting) -> bool:
        """Whether solving in another setting of the same part would give just this."""
        own = self.setting
        among = {name for pair in _equations_of_letters(setting) for name in _named(pair)}
        return (
            own.lets.keys() == setting.lets.keys()
            and own.asked & self.deciding == setting.asked & self.deciding
            and own.unknown & self.deciding == setting.unknown & self.deciding
            and (own.protected | own.spared) & among == (setting.protected | setting.spared) & among
            and all(
                _to_fix(setting, decision.present, decision.chosen) == decision.letter
                for decision in self.decisions
            )
        )


@dataclass
class Desk:
    """The work on one part: every setting is solved once, and shared where it makes no odds."""

    problem: Problem
    part: Part
    carried: frozenset[str] = frozenset()
    outcomes: list[Outcome] = field(default_factory=list)
    failures: list[tuple[Setting, RestitutionError]] = field(default_factory=list)
    # Of the values asked for, which share them.
    settings: dict[tuple[str, ...] | None, Setting] = field(default_factory=dict)

    def settle(
        self,
        in_terms_of: tuple[str, ...] | None,
        item: Range | Extremum | Show | None = None,
        data: frozenset[str] = frozenset(),
    ) -> Setting:
        """What is known and unknown for one item: see the function of that name."""
        if item is not None or data:
            return settle(self.problem, self.part, in_terms_of, item, data, self.carried)
        if in_terms_of not in self.settings:
            self.settings[in_terms_of] = settle(
                self.problem, self.part, in_terms_of, carried=self.carried
            )
        return self.settings[in_terms_of]

    def outcome(self, setting: Setting) -> Outcome:
        """All that solving gives. Raises RestitutionError, again for what failed before."""
        for known in self.outcomes:
            if known.setting is setting:
                return known
            if known.serves(setting):
                return replace(known, setting=setting)
        for failed, error in self.failures:
            if failed == setting:
                raise error
        try:
            outcomes = work_out(setting)
        except RestitutionError as error:
            self.failures.append((setting, error))
            raise
        self.outcomes.append(outcomes)
        return outcomes


@dataclass(frozen=True)
class Witnesses:
    """Admissible values of all letters: a few at once, more when the few agree."""

    outcome: Outcome
    trial: Trial

    @property
    def oracle(self) -> Oracle | None:
        """What decides for all admissible values; None where only points are known."""
        return None if self.trial.admission is None else self.trial.admission.oracle

    def __iter__(self) -> Iterator[Sample]:
        yield from self.trial.samples
        yield from self._more

    @cached_property
    def _more(self) -> tuple[Sample, ...]:
        known = self.trial.samples
        if len(known) < SAMPLES_WANTED:
            return ()  # all that could be found
        outcome = self.outcome
        tried = outcome.setting._tried(
            self.trial.root, outcome.letters, SAMPLES_FOR_SIGNS, self.trial
        )
        return tried.samples[len(known) :]


def work_out(setting: Setting) -> Outcome:
    """Every set of values for the unknowns that satisfies the equations, examined.

    Raises ContradictionError where there is none.
    """
    trials: list[Trial] = []
    last: tuple[Letters, Story] | None = None
    deciding = {name for pair in _equations_of_letters(setting) for name in _named(pair)}
    decisions: list[Decision] = []
    failed: ImpossibleError | None = None
    for values, angles in _letter_branches(setting):
        letters_ = Letters(setting.roles, values, angles, sought=setting.sought)
        try:
            story = setting.tell(letters_)
        except ImpossibleError as error:
            failed = failed or error  # other values may still do
            continue
        wanted = setting.requirements(story)
        equations = [
            sp.sympify(each.value, strict=True)
            for each in (*story.equations, *wanted)
            if isinstance(each, Equation)
        ]
        deciding |= {s.name for each in equations for s in each.free_symbols}
        for assignment in _solve_equations(
            setting, letters_, equations, decisions, story.conditions
        ):
            # Letters replaced by what the facts between letters say are back-substituted.
            combined = _combine(values, angles, assignment)
            trials.append(setting.try_out(combined, letters_, story, wanted))
        # What is asked of the story later, such as an impulse, names unknowns of its own.
        kept = replace(
            letters_, hidden_roles=dict(letters_.hidden_roles), phrases=dict(letters_.phrases)
        )
        last = kept, story
    if last is None or not trials:
        raise failed or _clash(setting)
    trials = _without_touching(_distinct(trials))
    return Outcome(setting, tuple(trials), *last, frozenset(deciding), tuple(decisions))


def _distinct(trials: list[Trial]) -> list[Trial]:
    kept: list[Trial] = []
    for trial in trials:
        if not any(_same_values(trial, other) for other in kept):
            kept.append(trial)
    return kept


def _without_touching(trials: list[Trial]) -> list[Trial]:
    """Solutions that are possible only where they are another one are not accepted."""
    kept = list(trials)
    for n, trial in enumerate(trials):
        if trial.rare is None or trial.admission is None:
            continue
        oracle = trial.admission.oracle
        for other in kept:
            if other is trial or not other.samples:
                continue
            names = trial.root.values.keys()
            if other.root.values.keys() == names and all(
                oracle.vanishes(trial.root.values[name] - other.root.values[name]) for name in names
            ):
                kept[n] = replace(trial, samples=(), reason=trial.rare[0], kind=trial.rare[1])
                break
    return kept


def _same_values(a: Trial, b: Trial) -> bool:
    return bool(a.samples) == bool(b.samples) and a.root.values == b.root.values


def _clash(setting: Setting) -> RestitutionError:
    lines = sorted({given.place.line for given, _ in setting.facts if given.place is not None})
    place = setting.facts[-1][0].place if setting.facts else None
    if lines:
        where = _lines(lines)
        message = f"the facts clash: no values satisfy all that is given in {where} and the story"
    else:
        message = "the data clash: no values satisfy all that is told"
    error = ContradictionError(message, None if place is None else place.line)
    error.because = "no values satisfy all the data"
    return error


def _lines(lines: Sequence[int]) -> str:
    if len(lines) == 1:
        return f"line {lines[0]}"
    return "lines " + ", ".join(map(str, lines[:-1])) + f" and {lines[-1]}"


def _clashing_bounds(setting: Setting) -> list[int]:
    """The first two lines of facts whose numerical bounds leave one letter no value."""
    facts = [(given, given.place.line) for given, _ in setting.facts if given.place is not None]
    for name in sorted(setting.roles):
        bounds = [(narrowed_by(REAL, name, given), line) for given, line in facts]
        for low, one in bounds:
            for high, other in bounds:
                if one == other or low.low is None or high.high is None:
                    continue
                touching = low.low == high.high and not (low.closed[0] and high.closed[1])
                if touching or bool(low.low > high.high):
                    return sorted((one, other))
    return []


def _combine(
    values: Mapping[str, sp.Expr], angles: Mapping[str, tuple[sp.Expr, sp.Expr]], assignment: Root
) -> Root:
    put: dict[sp.Symbol, sp.Expr] = {}
    combined = dict(assignment.values)
    pairs = dict(assignment.angles)
    for name, value in values.items():
        symbols = {s for s in value.free_symbols if s.name in assignment.values}
        put = {s: assignment.values[s.name] for s in symbols}
        combined[name] = value.xreplace(put) if put else value
        if name in angles and not put:
            pairs[name] = angles[name]
    return Root(combined, pairs, assignment.leftover)


def _equations_of_letters(setting: Setting) -> list[tuple[Expression, Expression]]:
    """The sides of what the facts say of letters alone."""
    return [
        (left, right)
        for given, _ in setting.facts
        for relation in given.relations
        if isinstance(relation, Compare)
        for left, op, right in zip(
            relation.operands, relation.operators, relation.operands[1:], strict=False
        )
        if op == "="
        and not has_quantity(left)
        and not has_quantity(right)
        and not _named((left, right)) & set(setting.lets)
    ]


def _named(pair: tuple[Expression, Expression]) -> frozenset[str]:
    return letters(pair[0]) | letters(pair[1])


def _letter_branches(
    setting: Setting,
) -> list[tuple[dict[str, sp.Expr], dict[str, tuple[sp.Expr, sp.Expr]]]]:
    """Values of letters that facts between letters alone give, before the story is told."""
    symbols = Letters(setting.roles)
    equations = _equations_of_letters(setting)
    branches: list[tuple[dict[str, sp.Expr], dict[str, tuple[sp.Expr, sp.Expr]]]] = [({}, {})]
    if not equations:
        return branches
    from restitution.expression.evaluate import Angle, Evaluator

    evaluator = Evaluator(SYMBOLIC, symbols.letter)
    pending: list[sp.Expr] = []
    for left, right in equations:
        try:
            a, b = evaluator.value(left), evaluator.value(right)
        except StatementError:
            continue
        if isinstance(a, tuple) or isinstance(b, tuple):
            continue
        a = a.measure() if isinstance(a, Angle) else a
        b = b.measure() if isinstance(b, Angle) else b
        pending.append(sp.sympify(a - b, strict=True))
    taken: set[str] = set()
    # A letter alone on one side stands for the other side.
    substitutions: dict[sp.Symbol, sp.Expr] = {}
    for left, right in equations:
        for lone, other in ((left, right), (right, left)):
            if not isinstance(lone, Letter) or lone.name in setting.protected | setting.spared:
                continue
            if lone.name in letters(other) or lone.name in taken or not letters(other):
                continue
            if lone.name in setting.asked:
                continue
            value = evaluator.scalar(other).xreplace(substitutions)
            symbol = setting.roles[lone.name].symbol(lone.name)
            if symbol in value.free_symbols:
                continue
            substitutions = {k: v.xreplace({symbol: value}) for k, v in substitutions.items()}
            substitutions[symbol] = value
            taken.add(lone.name)
            break
    for equation in pending:
        _substitute_linear(setting, equation, substitutions)
    branches = [({s.name: v for s, v in substitutions.items()}, {})]
    progress = True
    while progress:
        progress = False
        for equation in list(pending):
            new = []
            for values, angles in branches:
                put = {setting.roles[n].symbol(n): v for n, v in values.items()}
                current = sp.sympify(equation.xreplace(put), strict=True)
                current = current.doit() if current.free_symbols else current
                free = current.free_symbols
                if len(free) != 1:
                    new.append((values, angles))
                    continue
                (x,) = free
                progress = True
                for assignment in _one_letter(setting, current, x):
                    value = assignment.values[x.name]
                    deeper = {n: v.xreplace({x: value}) for n, v in values.items()}
                    new.append(({**deeper, **assignment.values}, {**angles, **assignment.angles}))
            if any(len(b[0]) != len(a[0]) for a, b in zip(branches, new, strict=False)) or len(
                new
            ) != len(branches):
                pending.remove(equation)
            branches = new
    return branches


def _substitute_linear(
    setting: Setting, equation: sp.Expr, substitutions: dict[sp.Symbol, sp.Expr]
) -> None:
    """β = 90° − α from α + β = 90°: angles that stand as themselves are not left under a sine."""
    current = sp.expand(equation.xreplace(substitutions))
    if len(current.free_symbols) < 2:
        return
    for symbol in sorted(
        current.free_symbols, key=lambda s: (s.name in setting.asked, s.name), reverse=False
    ):
        coefficient = current.coeff(symbol)
        rest = sp.expand(current - coefficient * symbol)
        if (
            setting.roles[symbol.name].kind != "angle"
            or symbol.name in setting.protected | setting.spared
            or not coefficient.is_Rational
            or coefficient == 0
            or rest.has(symbol)
        ):
            continue
        value = sp.expand(-rest / coefficient)
        for key, old in substitutions.items():
            substitutions[key] = old.xreplace({symbol: value})
        substitutions[symbol] = value
        return


def _one_letter(setting: Setting, equation: sp.Expr, x: sp.Symbol) -> list[Root]:
    role = setting.roles[x.name]
    is_angle = role.kind == "angle"
    if is_angle and not equation.has(sp.sin, sp.cos, sp.tan, sp.cot):
        is_angle = False
    acute = frozenset({x}) if _acute(role) else frozenset()
    kept = []
    for assignment in solve_system(
        [equation], [x], frozenset({x}) if is_angle else frozenset(), acute, setting.roles
    ):
        if x.name not in assignment.values:
            continue
        try:
            value = at(assignment.values[x.name], {})
        except (UndefinedError, KeyError):
            continue
        wrong = out_of_range(x.name, value, role)
        if wrong is None or wrong[1] == "coefficient":  # which is refused with its reason, later
            kept.append(assignment)
    return kept


def _acute(role: Role) -> bool:
    return bool(
        role.kind == "angle"
        and role.low is not None
        and role.high is not None
        and role.low >= 0
        and role.high <= sp.pi / 2
    )


def _solve_equations(
    setting: Setting,
    letters_: Letters,
    equations: Sequence[sp.Expr],
    decisions: list[Decision],
    conditions: Sequence[Condition | AnyOf] = (),
) -> list[Root]:
    """Solutions for hidden unknowns, for letters asked for, and for letters the facts fix."""
    values = [equation for equation in equations if equation != 0]
    known = letters_.all_roles()
    chosen = setting.unknown - set(letters_.values)
    for _ in range(8):
        unknowns = _ranked(setting, letters_, values, chosen)
        angles = frozenset(s for s in unknowns if setting.roles.get(s.name, REAL).kind == "angle")
        acute = frozenset(s for s in angles if _acute(setting.roles[s.name]))
        letter = None
        present = fixed_besides(values, unknowns)
        if present:
            letter = _to_fix(setting, present, chosen)
            decisions.append(Decision(present, chosen, letter))
        if letter is not None:
            chosen = chosen | {letter}
            continue
        try:
            assignments = solve_in_stages(values, unknowns, angles, acute, known, conditions)
        except UnsupportedError as error:
            if len(unknowns) <= len(values):
                raise
            raise missing.too_many(
                letters_.phrases.get(s.name, s.name) for s in unknowns
            ) from error
        leftover = [each for one in assignments for each in one.leftover]
        if not leftover:
            return assignments
        present = frozenset(s.name for each in leftover for s in each.free_symbols)
        letter = _to_fix(setting, present, chosen)
        decisions.append(Decision(present, chosen, letter))
        if letter is None:
            kept = [one for one in assignments if not one.leftover]
            return kept
        chosen = chosen | {letter}
    raise UnsupportedError("the facts fix more letters than can be sorted out")


def _ranked(
    setting: Setting,
    letters_: Letters,
    equations: Sequence[sp.Expr],
    chosen: frozenset[str],
) -> list[sp.Symbol]:
    """The unknowns in these equations, in the order in which to eliminate them."""
    present = {s for each in equations for s in each.free_symbols}

    def rank(symbol: sp.Symbol) -> tuple[int, str]:
        name = symbol.name
        if name.startswith("_"):
            return 0, name
        if name in setting.asked:
            return 2, name
        return 1, name

    return sorted((s for s in present if s.name.startswith("_") or s.name in chosen), key=rank)


def _to_fix(setting: Setting, present: frozenset[str], chosen: frozenset[str]) -> str | None:
    """Which of the letters in left-over facts they are taken to fix."""
    candidates = present - chosen - setting.protected
    candidates = candidates - setting.spared or candidates
    if not candidates:
        # Facts may fix a letter that answers were to be in terms of: then they need not be.
        candidates = present - chosen - setting.fixed
    if not candidates:
        return None
    left_out = any(
        isinstance(step, Impact) and step.e is None for _, step in setting.problem.steps()
    )
    shown = {
        each.name
        for step in setting.shows
        if isinstance(step.relation, Compare)
        for each in step.relation.operands
        if isinstance(each, Letter)
    }
    equated = {
        each.name
        for given, _ in setting.facts
        for relation in given.relations
        if isinstance(relation, Compare) and any(has_quantity(t) for t in relation.operands)
        for each in relation.operands
        if isinstance(each, Letter)
    }
    in_shows = {
        name
        for step in setting.shows
        if isinstance(step.relation, Compare)
        for tree in step.relation.operands
        if not has_quantity(tree)
        for name in letters(tree)
    }

    def priority(name: str) -> tuple[int, str]:
        role = setting.roles[name]
        if name in shown:
            return 0, name
        if name == "e" and left_out:
            return 1, name
        if name in equated:
            return 2, name
        if role.kind == "restitution":
            return 3, name
        if name in in_shows:
            return 4, name
        if role.kind == "angle":
            return 5, name
        if role.kind == "real":
            return 6, name
        return 7, name

    chosen_letter: str = min(candidates, key=priority)
    return chosen_letter


def impossible(setting: Setting, trials: Sequence[Trial], place: Place | None) -> RestitutionError:
    """Why none of the solutions can be: the commonest physical reason."""
    reasons = Counter(
        (t.reason, t.kind) for t in trials if t.reason is not None and t.kind != "equation"
    )
    line = None if place is None else place.line
    clash = _clashing_bounds(setting)
    if clash:
        text = f"the facts clash: no number is within the bounds of {_lines(clash)}"
        return ContradictionError(text, line)
    if not reasons:
        return ContradictionError("the facts clash: no real values satisfy them all", line)
    (reason, kind), _ = reasons.most_common(1)[0]
    if kind == "fact":
        return ContradictionError(f"the facts clash: {reason}", line)
    return ImpossibleError(str(reason), line)
