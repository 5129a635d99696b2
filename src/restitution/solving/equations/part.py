"""Solving one part: its unknowns worked out, and which of their roots are admissible."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from functools import cached_property

import sympy as sp

from restitution import exact
from restitution.errors import ContradictionError, ImpossibleError, RestitutionError
from restitution.exact.symbols import symbol_names
from restitution.expression.tree import Place, letters
from restitution.oracle import Oracle
from restitution.oracle.roles import REAL, Role
from restitution.problem import Extremum, Part, Problem, Range, Show
from restitution.records import dataclass
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.algebra.numbers import Sample
from restitution.solving.algebra.systems import Root
from restitution.solving.equations.answers import value_layout
from restitution.solving.equations.roots import (
    Decision,
    equations_of_letters,
    letter_branches,
    letters_of_pair,
    put_back,
    solve_equations,
    to_fix,
)
from restitution.solving.equations.setting import SAMPLES_WANTED, UNWIELDY, Setting, Trial, settle
from restitution.solving.story.admission import reason_outside
from restitution.solving.story.conditions import Equation
from restitution.solving.story.forward import Story
from restitution.solving.story.letters import narrowed_by
from restitution.solving.story.unknowns import Letters

# Where the form of an answer hangs on a sign, four points are too few.
SAMPLES_FOR_SIGNS = 24

EVERY_SOLUTION = "in every solution of the equations"
"""How a reason begins that holds of all that was sought."""


@dataclass(frozen=True)
class Outcome:
    """All that solving the unknowns of a part gave.

    ``equations`` are those that do not hold by themselves, where the story is told once, with
    ``deciding`` as the letters in all that were told; ``decisions`` is what was decided on the way.
    """

    setting: Setting
    trials: tuple[Trial, ...]
    letters: Letters
    open_story: Story
    deciding: frozenset[str]
    decisions: tuple[Decision, ...]
    equations: tuple[sp.Expr, ...] = ()

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
        return [
            trial
            for trial in self.trials
            if not trial.samples and trial.kind not in ("equation", "undecided")
        ]

    @property
    def undecided(self) -> list[Trial]:
        """What is neither accepted nor refused, nor the same as what is wherever it is possible."""
        return [
            trial
            for trial in self.trials
            if trial.kind == "undecided"
            and not any(_repeats(trial, other) for other in self.accepted)
        ]

    def serves(self, setting: Setting) -> bool:
        """Whether solving in another setting of the same part would give just this."""
        own = self.setting
        among = {name for pair in equations_of_letters(setting) for name in letters_of_pair(pair)}
        return (
            own.sloped_after == setting.sloped_after
            and own.lets.keys() == setting.lets.keys()
            and own.asked & self.deciding == setting.asked & self.deciding
            and own.unknown & self.deciding == setting.unknown & self.deciding
            and (own.protected | own.spared) & among == (setting.protected | setting.spared) & among
            and all(
                to_fix(setting, decision.present, decision.chosen) == decision.letter
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
        tried = outcome.setting.try_at_points(
            self.trial.root, outcome.letters, SAMPLES_FOR_SIGNS, self.trial
        )
        return tried.samples[len(known) :]


def work_out(setting: Setting) -> Outcome:
    """Every set of values for the unknowns that satisfies the equations, examined.

    Raises ContradictionError where there is none.
    """
    trials: list[Trial] = []
    last: tuple[Letters, Story] | None = None
    equations: list[sp.Expr] = []
    deciding = {name for pair in equations_of_letters(setting) for name in letters_of_pair(pair)}
    decisions: list[Decision] = []
    failed: ImpossibleError | None = None
    branches = letter_branches(setting)
    for values, angles in branches:
        letters_ = Letters(setting.roles, values, angles, sought=setting.sought)
        try:
            story = setting.tell(letters_)
        except ImpossibleError as error:
            failed = failed or error  # other values may still do
            continue
        wanted = setting.requirements(story)
        equations = [
            sp.sympify(condition.value, strict=True)
            for condition in (*story.equations, *wanted)
            if isinstance(condition, Equation)
        ]
        deciding |= symbol_names(*equations)
        for assignment in solve_equations(
            setting, letters_, equations, decisions, story.conditions
        ):
            # Letters replaced by what the facts between letters say are back-substituted.
            combined = put_back(values, angles, assignment)
            trials.append(setting.try_out(combined, letters_, story, wanted))
        if not any(trial.samples for trial in trials):
            # The equation may hold by a letter that is no unknown, which is zero then.
            for zero in _letters_of_zero(setting, letters_, equations):
                combined = put_back(values, angles, zero)
                trials.append(setting.try_out(combined, letters_, story, wanted))
        # What is asked of the story later, such as an impulse, names unknowns of its own.
        kept = replace(
            letters_, hidden_roles=dict(letters_.hidden_roles), phrases=dict(letters_.phrases)
        )
        last = kept, story
    if last is None or not trials:
        raise failed or (last and _missed(last[1])) or _clash(setting)
    trials = _without_touching(_distinct(trials))
    left = tuple(equation for equation in equations if equation != 0 and len(branches) == 1)
    return Outcome(setting, tuple(trials), *last, frozenset(deciding), tuple(decisions), left)


def _letters_of_zero(
    setting: Setting, letters_: Letters, equations: Sequence[sp.Expr]
) -> Iterator[Root]:
    """The letters of either sign that are a factor of the only equation, each as zero."""
    open_ = [equation for equation in equations if equation != 0]
    if len(open_) != 1:
        return
    for factor in sp.Mul.make_args(sp.factor_terms(open_[0])):
        name = str(factor)
        role = setting.roles.get(name)
        if factor.is_Symbol and role == REAL and name not in letters_.values:
            yield Root({name: sp.Integer(0)}, {}, ())


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


def _repeats(trial: Trial, other: Trial) -> bool:
    """Whether one solution has the values of another wherever it is one at all."""
    values, known = trial.root.values, other.root.values
    if trial.admission is None or trial.root.angles or values.keys() != known.keys():
        return False
    return all(trial.admission.is_zero(value - known[name]) for name, value in values.items())


def _missed(story: Story) -> ImpossibleError | None:
    """Why a sphere does not come where it is told to come, if the data alone say so."""
    for equation in story.equations:
        if equation.kind == "path" and not equation.fact:
            value = sp.sympify(equation.value, strict=True)
            if value.is_number and not exact.is_zero(value):
                return ImpossibleError(
                    equation.reason, None if equation.place is None else equation.place.line
                )
    return None


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
        bounds = [(narrowed_by(REAL, name, given, setting.roles), line) for given, line in facts]
        for low, one in bounds:
            for high, other in bounds:
                if one == other or low.low is None or high.high is None:
                    continue
                touching = low.low == high.high and not (low.closed[0] and high.closed[1])
                if touching or bool(low.low > high.high):
                    return sorted((one, other))
    return []


def impossible(setting: Setting, trials: Sequence[Trial], place: Place | None) -> RestitutionError:
    """Why none of the solutions can be: the commonest physical reason."""
    named = [t for t in trials if t.reason is not None and t.kind != "equation"]
    reasons = Counter((t.reason, t.kind) for t in named if not _has_a_letter_of_zero(setting, t))
    line = None if place is None else place.line
    clash = _clashing_bounds(setting)
    if clash:
        text = f"the facts clash: no number is within the bounds of {_lines(clash)}"
        return ContradictionError(text, line)
    if not reasons:
        return ContradictionError("the facts clash: no real values satisfy them all", line)
    (reason, kind), _ = reasons.most_common(1)[0]
    if kind in ("fact", "rest"):
        clash_ = ContradictionError(f"the facts clash: {reason}", line)
        clash_.because = f"{EVERY_SOLUTION} {reason}" if kind == "rest" else ""
        return clash_
    values = list(dict.fromkeys(filter(None, (_value_out_of_range(t, reason) for t in named))))
    if kind != "range" or not values:
        error = ImpossibleError(str(reason), line)
        if len(reasons) == 1 and any(t.root.values for t in named):
            # What was sought has such values only: of others that is not said.
            error.because = f"{EVERY_SOLUTION} {reason}"
        return error
    listed = " or ".join(values)
    hint = next(iter(_senses_to_free(setting, named, reason)), "")
    error = ImpossibleError(f"{listed} rejected: {reason}{hint}", line)
    error.because = f"the data give {listed}, and {reason}"
    return error


def _senses_to_free(setting: Setting, trials: Sequence[Trial], reason: str | None) -> Iterator[str]:
    """How a letter that is the speed of a velocity may be negative, where it would have to be."""
    speeds = {
        name
        for sphere in setting.problem.spheres
        if sphere.velocity is not None
        for name in letters(sphere.velocity)
    }
    for trial in trials:
        for name, value in trial.root.values.items():
            if name in speeds and reason == f"{name} must be positive" and value.is_negative:
                yield f", as it is a speed here; write 'given {name} < 0' if it need not be"


def _has_a_letter_of_zero(setting: Setting, trial: Trial) -> bool:
    """Whether a letter that nobody asks for would be zero: that solves what is homogeneous."""
    values = trial.root.values
    return any(values[name] == 0 for name in values.keys() & (set(setting.roles) - setting.asked))


def _value_out_of_range(trial: Trial, reason: str | None) -> str | None:
    """The value of the letter for which a trial was refused for a reason, as an equation."""
    for name, value in trial.root.values.items():
        role = None if trial.admission is None else trial.admission.roles.get(name)
        if role is None or reason_outside(name, role)[0] != reason:
            continue
        if sp.count_ops(value) <= UNWIELDY:
            return _solved_text(name, value, role)
    return None


def solved_texts(trial: Trial) -> Iterator[str]:
    """The values that a trial has for letters of the statement, as equations."""
    for name, value in trial.root.values.items():
        role = None if trial.admission is None else trial.admission.roles.get(name)
        if role is not None and not name.startswith("_") and sp.count_ops(value) <= UNWIELDY:
            yield _solved_text(name, value, role)


def _solved_text(name: str, value: sp.Expr, role: Role) -> str:
    letter = to_text(display(role.symbol(name)))
    angle = role.kind == "angle"
    plain = exact.tidy_angle(value) if angle else exact.tidy(value)
    return f"{letter} = {to_text(value_layout(plain, 'value', angle, percentage=False))}"
