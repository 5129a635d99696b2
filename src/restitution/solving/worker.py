"""One part worked on: every item with its answers, the roots refused, and its errors."""

from __future__ import annotations

import functools
import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from functools import partial
from itertools import chain
from typing import Any

import sympy as sp
from sympy.polys.polyerrors import BasePolynomialError

from restitution import exact, work
from restitution.errors import (
    ContradictionError,
    ImpossibleError,
    MissingError,
    RestitutionError,
    StatementError,
    UnsupportedError,
)
from restitution.exact.symbols import symbol_names
from restitution.expression.evaluate import Angle, Evaluator
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.oracle.roles import Role
from restitution.problem import (
    Extremum,
    Find,
    Given,
    Item,
    Let,
    Part,
    Problem,
    Range,
    Show,
    Value,
)
from restitution.records import dataclass
from restitution.solving.above_events import answered_above
from restitution.solving.algebra import forms
from restitution.solving.algebra.numbers import sample
from restitution.solving.equations.answers import (
    answer_of,
    has_dimension,
    is_same_value,
    is_unit,
    missing_for,
    phrase_of,
    value_layout,
)
from restitution.solving.equations.coefficients import (
    coefficient_letters,
    impossible_coefficients,
    outside,
    require_possible_value,
    warning_of,
    without_impossible,
)
from restitution.solving.equations.part import Desk, Outcome, impossible, solved_texts
from restitution.solving.equations.setting import (
    NOT_DECIDED,
    UNWIELDY,
    Setting,
    Trial,
)
from restitution.solving.equations.solution import (
    Answer,
    Branch,
    ItemKind,
    ItemResult,
    PartSolution,
    Rejected,
    RejectedBranch,
)
from restitution.solving.equations.stages import by_nested_roots
from restitution.solving.equations.trial_numbers import example_of
from restitution.solving.equations.verify import verify_principles, verify_value
from restitution.solving.ranges.validity import (
    Limitation,
    are_all_known,
    limitations,
    of_a_time,
    with_condition,
)
from restitution.solving.story import missing
from restitution.solving.story.forward import Story
from restitution.solving.story.impacts import SLOPE
from restitution.solving.story.letters import is_angle
from restitution.solving.story.quantities import stage_number
from restitution.solving.story.unknowns import SYMBOLIC, Letters, Numbers
from restitution.vector import Vector

# A speed that is more to read than this may be shorter in other components.
LONG = 16


def asks(part: Part) -> bool:
    """Whether a part has a question."""
    return any(isinstance(step, Find | Show) for step in part.steps)


# What a defect here, or an expression that the algebra cannot take, would raise: it costs one
# item its answer, and no other.
UNFORESEEN = (
    ArithmeticError,
    AttributeError,
    LookupError,
    NotImplementedError,
    RecursionError,
    TypeError,
    ValueError,
    BasePolynomialError,
)


def _no_story(unknowns: object) -> Story:
    """Where places are roots of roots, the story is told in numbers alone."""
    raise UnsupportedError(
        "the places in this story are roots of roots: only letters that are sought, and no "
        "velocities, times or places, are given exactly"
    )


def unforeseen(error: BaseException, line: int | None = None) -> UnsupportedError:
    """The error that reports a defect of the program."""
    message = "this could not be solved, by a fault of the program: please report the question"
    answer = UnsupportedError(message, line)
    answer.__cause__ = error  # for those who mend it
    return answer


@dataclass
class Worker:
    """The work on the items of one part: their answers, warnings, and the branches shared."""

    desk: Desk
    warnings: list[str] = field(default_factory=list)
    # By the identity of the trials that they are made from, which settings may share.
    branches: dict[int, list[Branch] | RestitutionError] = field(default_factory=dict)
    limits: dict[int, tuple[Limitation, ...]] = field(default_factory=dict)
    # Of trials of which it is not decided for which letters they hold.
    not_proved: set[int] = field(default_factory=set)
    clashes: dict[Any, RestitutionError] = field(default_factory=dict)

    @property
    def problem(self) -> Problem:
        return self.desk.problem

    @property
    def part(self) -> Part:
        return self.desk.part

    def solve(self) -> PartSolution:
        results: list[ItemResult] = []
        for step, now, _ in self.problem.timeline(self.part):
            if isinstance(step, Find):
                for item in step.items:
                    results.append(
                        self._kept(partial(self.item_result, item, now, step.in_terms_of))
                    )
            elif isinstance(step, Show):
                results.append(self._kept(partial(self._show, step, now)))
        whole = self._whole(tuple(results))
        if whole.branches or not isinstance(whole.error, ImpossibleError):
            return whole
        items, before = answered_above(self.problem, self.part, whole.items, self._solved_apart)
        return whole if before is None else replace(whole, items=items, before=before)

    def _solved_apart(self, problem: Problem, part: Part) -> PartSolution:
        """A part of another problem, under what earlier parts have found here."""
        return Worker(Desk(problem, part, self.desk.carried)).solve()

    def _kept(self, make: Callable[[], ItemResult]) -> ItemResult:
        """An item, unless something of it was broken off and passed over."""
        result = make()
        try:
            work.confirm()
        except RestitutionError as error:
            if result.error is None or result.error.kind != error.kind:
                error.line = result.line
                result = ItemResult(result.item, result.line, result.text, result.kind, error=error)
        return result

    def _whole(self, results: tuple[ItemResult, ...]) -> PartSolution:
        """The part as it is explained: with what all the values asked for have in common."""
        error: RestitutionError | None = None
        beyond: tuple[Branch, ...] = ()
        try:
            outcome, branches = self.solved(None)
        except (RestitutionError, *UNFORESEEN) as failure:
            error = failure if isinstance(failure, RestitutionError) else unforeseen(failure)
            pairs = (
                (known_outcome, self.branches.get(id(known_outcome.trials)))
                for known_outcome in self.desk.outcomes
            )
            pair = next(((one, kept) for one, kept in pairs if isinstance(kept, list)), None)
            if pair is None:
                known, beyond = self._beyond()
                return PartSolution(self.part, results, (), (), known, None, error, beyond=beyond)
            outcome, branches = pair
        return PartSolution(
            self.part,
            results,
            tuple(branches),
            tuple(
                RejectedBranch(t.root.values, t.reason or "", t.kind or "") for t in outcome.refused
            ),
            outcome.letters.all_roles(),
            outcome.open_story,
            error,
        )

    def asked_of_all(self) -> frozenset[str]:
        """Letters asked for here whose values rest on facts of the whole statement."""
        if any(isinstance(step, Given) for step in self.part.steps):
            return frozenset()
        asked: set[str] = set()
        for step in self.part.steps:
            if isinstance(step, Find):
                for item in step.items:
                    if isinstance(item, Value) and isinstance(item.expression, Letter):
                        asked.add(item.expression.name)
        return frozenset(asked)

    # --- solving once for each setting ---------------------------------------------------------

    def solved(
        self, in_terms_of: tuple[str, ...] | None, claim: Show | None = None
    ) -> tuple[Outcome, list[Branch]]:
        """What solving gives for the values asked for, or for a claim. Raises RestitutionError."""
        setting = self.desk.settle(in_terms_of, claim)
        try:
            outcome = self.desk.outcome(setting)
            key = id(outcome.trials)
            if key not in self.branches:
                try:
                    self.branches[key] = self._branches(outcome)
                except RestitutionError as error:
                    self.branches[key] = error
            branches = self.branches[key]
            if isinstance(branches, RestitutionError):
                raise branches
        except (ContradictionError, ImpossibleError) as error:
            raise self._clash(setting, error) from error
        return outcome, branches

    def _clash(self, setting: Setting, error: RestitutionError) -> RestitutionError:
        """The facts that clash; sought once for the same facts."""
        key = (error.message, tuple(id(given) for given, _ in setting.facts))
        if key not in self.clashes:
            from restitution.solving.equations import clash

            self.clashes[key] = clash.named(setting, error)
        return self.clashes[key]

    def _branches(self, outcome: Outcome) -> list[Branch]:
        accepted = outcome.accepted
        for trial in outcome.undecided:
            solved = ", ".join(solved_texts(trial)) or "this"
            if not accepted:
                raise UnsupportedError(f"{solved}: {NOT_DECIDED}")
            self.warn(f"{solved}: {NOT_DECIDED}")
        if not accepted:
            # Where the data imply an impossible coefficient, that is said, and the rest answered.
            accepted = self._with_impossible_coefficient(outcome)
            if not accepted:
                raise impossible(outcome.setting, outcome.trials, self.part.place)
        branches = [self._branch(outcome.setting, trial, n) for n, trial in enumerate(accepted, 1)]
        if not outcome.accepted:
            self._warn_of_coefficient(branches)
        return branches

    def _branch(self, setting: Setting, trial: Trial, number: int) -> Branch:
        solved_letters = Letters(setting.roles, trial.root.values, trial.root.angles, trial.samples)
        story = trial.story
        if story is not None and isinstance(story.unknowns, Letters) and story.unknowns.certain:
            # With other samples it would be told alike; these are for what is asked of it later.
            solved_letters = story.unknowns
            solved_letters.samples = trial.samples
        else:
            story = None
        tell = _no_story if by_nested_roots(trial.root.values, "_c_") else setting.tell
        numbers = trial.numbers or setting.tell(Numbers(trial.samples[0]))
        verify_principles(numbers)
        solved = tuple(name for name in trial.root.values if not name.startswith("_"))
        return Branch(
            number,
            trial.root.values,
            trial.root.angles,
            solved_letters,
            trial.samples[0],
            numbers,
            tell,
            partial(setting.examine, solved=solved),
            None if trial.admission is None else trial.admission.oracle,
            story,
        )

    def _with_impossible_coefficient(self, outcome: Outcome) -> list[Trial]:
        """What only a coefficient speaks against; passing through each other is out of question."""
        kept: list[Trial] = []
        through: list[Trial] = []
        known = outcome.letters.all_roles()
        for trial in outcome.refused:
            if trial.kind != "coefficient":
                continue
            example = example_of(outcome.setting, trial, known)
            if example is None:
                continue
            values, story = example
            wrong = [happening for happening in story.happenings if outside(happening)]
            implied = set(trial.root.values)
            if not all(coefficient_letters(h.step) <= implied for h in wrong):
                continue  # a letter that is data: the facts about it clash
            negative = any(happening.e < 0 for happening in wrong)
            (through if negative else kept).append(
                replace(trial, samples=(values,), admission=None, story=None, numbers=None)
            )
        return kept or through

    def _beyond(self) -> tuple[Mapping[str, Role], tuple[Branch, ...]]:
        """All that the equations of the part give, where each time a letter is out of its range.

        With the roles of the letters; nothing where some of it is impossible for another reason.
        """
        try:
            outcome = self.desk.outcome(self.desk.settle(None))
            known = outcome.letters.all_roles()
            branches: list[Branch] = []
            for trial in outcome.refused:
                if trial.kind != "range" or 0 in trial.root.values.values():
                    return known, ()
                example = example_of(outcome.setting, trial, known, out_of_range=True)
                if example is None:
                    continue  # no value of the motion: a factor that the equations have lost
                values, story = example
                whole = replace(trial, samples=(values,), admission=None, story=None, numbers=story)
                branches.append(self._branch(outcome.setting, whole, len(branches) + 1))
        except (RestitutionError, *UNFORESEEN):
            return {}, ()
        return known, () if outcome.accepted else tuple(branches)

    def _warn_of_coefficient(self, branches: list[Branch]) -> None:
        if wrong := tuple(chain.from_iterable(map(impossible_coefficients, branches))):
            self.warn(warning_of(wrong))

    def warn(self, text: str) -> None:
        if text not in self.warnings:
            self.warnings.append(text)

    # --- items --------------------------------------------------------------------------------

    def item_result(self, item: Item, now: int, in_terms_of: tuple[str, ...] | None) -> ItemResult:
        kind: ItemKind = "value"
        line = None if item.place is None else item.place.line
        try:
            if isinstance(item, Range | Extremum):
                kind = "range" if isinstance(item, Range) else "extremum"
                bounds = self._bounds(item, now, in_terms_of)
                if bounds.proof == "undecided":
                    self.warn(bounds.not_proved)
                return bounds
            kind = self._kind(item.expression)
            return self._value(item, now, in_terms_of, kind)
        except RestitutionError as error:
            column = None if item.place is None else item.place.column
            if error.line is None:
                error = error.at(line, column)
            refused = self._all_refused(item, now, in_terms_of, kind, error)
            return ItemResult(item, line, item.text, kind, rejected=refused, error=error)
        except UNFORESEEN as error:
            return ItemResult(item, line, item.text, kind, error=unforeseen(error, line))

    def _bounds(
        self, item: Range | Extremum, now: int, in_terms_of: tuple[str, ...] | None
    ) -> ItemResult:
        """A range or an extreme value; a range is empty where a coefficient is impossible."""
        if isinstance(item, Extremum):
            from restitution.solving.ranges.extrema import find_extremum

            return find_extremum(self.desk, item, now, in_terms_of)
        from restitution.solving.ranges.allowed_values import find_range

        try:
            return find_range(self.desk, item, now, in_terms_of)
        except ContradictionError:
            require_possible_value(partial(self.solved, in_terms_of), item.expression, now)
            raise

    def _all_refused(
        self,
        item: Any,
        now: int,
        in_terms_of: tuple[str, ...] | None,
        kind: ItemKind,
        error: RestitutionError,
    ) -> tuple[Rejected, ...]:
        """The roots for a letter, where for none of them the motion is possible."""
        if not isinstance(error, ImpossibleError) or not isinstance(item.expression, Letter):
            return ()
        try:
            outcome = self.desk.outcome(self.desk.settle(in_terms_of))
            solved = all(item.expression.name in t.root.values for t in outcome.refused)
            if outcome.accepted or not solved:
                return ()
            if any(value.startswith("_c_") for t in outcome.refused for value in t.root.values):
                return ()  # of the places of contact those that cannot be are left out earlier
            angle = self._is_angle(item.expression, outcome.setting)
            return self._rejected(item, outcome, [], now, kind, angle)
        except (RestitutionError, *UNFORESEEN):
            return ()

    def _kind(self, tree: Expression) -> ItemKind:
        if isinstance(tree, Negate):
            return self._kind(tree.operand)
        if isinstance(tree, Quantity):
            if tree.kind == "line_of_centres":
                return "direction"
            if tree.kind == "direction" and self._is_wall(tree.arguments):
                return "direction"
            if tree.kind == "position":
                return "point"
        if isinstance(tree, Name):
            return "direction" if self._is_wall((tree,)) else "point"
        return "value"

    def _is_wall(self, arguments: tuple[Expression, ...]) -> bool:
        names = {wall.name for wall in self.problem.walls}
        return bool(arguments) and isinstance(arguments[0], Name) and arguments[0].name in names

    def _value(
        self, item: Value, now: int, in_terms_of: tuple[str, ...] | None, kind: ItemKind
    ) -> ItemResult:
        outcome, branches = self.solved(in_terms_of)
        line = None if item.place is None else item.place.line
        angle = self._is_angle(item.expression, outcome.setting)
        if item.percentage and (angle or has_dimension(item.expression)):
            raise StatementError(
                "a percentage needs a ratio, such as energy_lost/energy(0) as a percentage"
            )
        if not outcome.accepted:
            branches = without_impossible(branches, outcome.setting, [item.expression], now)
        answers: list[Answer] = []
        branches = self._that_fix(item, branches, outcome)
        for branch in branches:
            trial = outcome.accepted[branch.number - 1] if outcome.accepted else None
            samples = (branch.sample,) if trial is None else outcome.witnesses(trial)
            value = self._evaluate(item, branch, now, samples, kind)
            self._complete(item, value, outcome, branch, in_terms_of)
            if kind != "direction":
                verify_value(value, item, branch, now)
            answer = answer_of(branch.number, value, kind, angle, item.percentage)
            twin = next(
                (other for other in answers if is_same_value(other.value, answer.value)), None
            )
            if twin is not None:
                answer = replace(twin, solution=answer.solution)
            if trial is not None:
                answer = self._limited(answer, item, kind, outcome, trial)
            answers.append(answer)
        if answers and isinstance(answers[0].value, tuple) and kind == "value":
            kind = "vector"
        rejected = self._rejected(item, outcome, answers, now, kind, angle)
        return ItemResult(item, line, item.text, kind, tuple(answers), rejected=rejected)

    def _that_fix(self, item: Value, branches: list[Branch], outcome: Outcome) -> list[Branch]:
        """The solutions without those in which a letter is open by the value of an eliminated one.

        Where ``(1 − e²)(3k − 1 − k) = 0`` gives k, the other solution is that of e = 1 alone.
        """
        own = letters(item.expression) & outcome.setting.asked
        fixed = [branche for branche in branches if own <= branche.values.keys()]
        if not own or not fixed or has_quantity(item.expression):
            return branches
        eliminated = outcome.setting.extra_unknown - outcome.setting.asked
        special = [
            branche
            for branche in branches
            if not own & branche.values.keys()
            and any(branche.values[name].is_number for name in eliminated & branche.values.keys())
            and all(eliminated & branche.values.keys() - one.values.keys() for one in fixed)
        ]
        return [branche for branche in branches if branche not in special]

    def _limited(
        self, answer: Answer, item: Value, kind: ItemKind, outcome: Outcome, trial: Trial
    ) -> Answer:
        """An answer with the condition under which it holds, if there is one."""
        key = id(trial)
        if key not in self.limits:
            self.limits[key] = limitations(outcome, trial) if trial.root.values else ()
            if trial.root.values and not are_all_known(outcome, trial):
                self.not_proved.add(key)
        if key in self.not_proved and answer.letters:
            self.warn(
                f"{item.text}: for which values of the letters this holds is not decided; it was "
                "tried at some of them"
            )
        limits = self.limits[key] or of_a_time(outcome, trial, item.expression, answer.value)
        if not limits:
            return answer
        plain = value_layout(answer.value, kind, answer.angle, item.percentage)
        own = item.expression.name if isinstance(item.expression, Letter) else None
        return with_condition(answer, plain, limits, own)

    def _evaluate(self, item: Value, branch: Branch, now: int, samples: Any, kind: ItemKind) -> Any:
        tree = item.expression
        if self._of_letters(tree):
            value = Evaluator(SYMBOLIC, branch.letters.letter).value(tree)
        else:
            value = branch.story.evaluator(now).value(tree)
        open_ = forms.open_in(value, samples)
        if open_:
            raise missing_for(item, branch, open_)
        sign = functools.partial(forms.sign_of, samples=samples)
        if isinstance(tree, Letter) and isinstance(value, Angle):
            measured = value.measure()
            if not measured.has(sp.atan2, sp.Abs):
                return forms.acute_angle(exact.tidy_angle(measured), sign)
        if kind == "direction" and isinstance(value, Vector) and not is_unit(tree):
            return forms.direction(value, samples)
        result = forms.plain(value, samples)
        if isinstance(tree, Letter) and not isinstance(result, tuple) and result.has(sp.atan):
            return forms.acute_angle(exact.tidy_angle(result), sign)
        if is_quantity(tree, "speed") and _is_long(result):
            return min((result, *self._resolved(tree, branch, now, samples)), key=exact.cost)
        return result

    def _resolved(
        self, tree: Quantity, branch: Branch, now: int, samples: Any
    ) -> Iterator[sp.Expr]:
        """A speed by components along and across the line of centres of the latest event."""
        name = tree.arguments[0]
        assert isinstance(name, Name)
        stage = stage_number(branch.story, tree, now, name.name)
        event = branch.story.latest(name.name, stage)
        if event is not None and event.centres is not None and not event.unknown_line:
            velocity = branch.story.velocity(name.name, stage)
            yield forms.along_and_across(velocity, event.centres, samples)

    def _of_letters(self, tree: Expression) -> bool:
        """Whether an expression needs no telling of the story: its letters are enough."""
        lets = {step.letter for _, step in self.problem.steps() if isinstance(step, Let)}
        return not any(
            isinstance(node, Quantity | Name | Polar)
            or (isinstance(node, Letter) and node.name in lets)
            for node in walk(tree)
        )

    def _is_angle(self, tree: Expression, setting: Setting) -> bool:
        walls = frozenset(wall.name for wall in self.problem.walls)
        angles = {name for name, role in setting.roles.items() if role.kind == "angle"}
        return is_angle(tree, angles, walls)

    def _complete(
        self,
        item: Value,
        value: Any,
        outcome: Outcome,
        branch: Branch,
        in_terms_of: tuple[str, ...] | None,
    ) -> None:
        """Everything in an answer must be data."""
        parts = value if isinstance(value, tuple) else (value,)
        present = symbol_names(*parts)
        hidden = sorted(name for name in present if name.startswith("_"))
        if hidden:
            raise missing_for(item, branch, hidden)
        own, lets = letters(item.expression), set(outcome.setting.lets)
        # A letter that is let be a quantity is one: β − α rests on α, which is not sought.
        if not has_quantity(item.expression) and not own & lets and own & outcome.setting.asked:
            unsolved = own - set(branch.values)
            loose = present & outcome.setting.asked
            if unsolved == own or loose:
                name = min(loose or own)
                tied = [{key, *symbol_names(x)} for key, x in branch.values.items()]
                beside = sorted(set().union(*(names for names in tied if name in names)))
                beside += sorted(x for x in outcome.letters.hidden_roles if x.startswith(SLOPE))
                beside = [phrase_of(branch, letter) for letter in beside if letter.startswith("_")]
                raise missing.is_open(name, beside)
        if in_terms_of is not None:
            extra = sorted(present - set(in_terms_of))
            if extra:
                raise MissingError(
                    f"the answer depends on {' and '.join(extra)}, and cannot be given "
                    f"in terms of {', '.join(in_terms_of)} alone"
                )

    def _rejected(
        self,
        item: Value,
        outcome: Outcome,
        answers: list[Answer],
        now: int,
        kind: ItemKind,
        angle: bool,
    ) -> tuple[Rejected, ...]:
        if not outcome.refused:
            return ()
        rejected: list[Rejected] = []
        known = outcome.letters.all_roles()
        rng = random.Random(43)
        samples = [sample(sorted(known), known, rng) for _ in range(3)]
        for trial in outcome.refused:
            if any(sp.count_ops(value) > UNWIELDY for value in trial.root.values.values()):
                continue  # nobody would read it, and it takes long to put into a tidy form
            try:
                solved_letters = Letters(
                    outcome.setting.roles, trial.root.values, trial.root.angles
                )
                if self._of_letters(item.expression):
                    value = Evaluator(SYMBOLIC, solved_letters.letter).value(item.expression)
                else:
                    story = outcome.setting.tell(solved_letters)
                    value = story.evaluator(now).value(item.expression)
                value = forms.plain(value, samples)
            except (RestitutionError, ArithmeticError, TypeError, ValueError):
                continue
            if any(is_same_value(value, answer.value) for answer in answers):
                continue
            if isinstance(item.expression, Letter) and item.expression.name not in {
                *trial.root.values,
                *outcome.setting.lets,
            }:
                continue  # the letter is open there
            parts = value if isinstance(value, tuple) else (value,)
            if any(s.name.startswith("_") for p in parts for s in p.free_symbols):
                continue
            if any(part.has(sp.nan, sp.zoo) for part in parts):
                continue
            answer = answer_of(0, value, kind, angle, item.percentage)
            if not any(answer.exact == root.exact for root in rejected):
                reason = trial.reason or ""
                rejected.append(
                    Rejected(answer.value, answer.exact, answer.display, reason, answer.angle)
                )
        return tuple(rejected)

    # --- show ---------------------------------------------------------------------------------

    def _show(self, step: Show, now: int) -> ItemResult:
        from restitution.solving.showing import show

        line = None if step.place is None else step.place.line
        try:
            try:
                result = show(self, step, now)
            except StatementError:
                # A tangent may have no value by the facts below, which the claim is not about.
                above = self._above_facts(step, now)
                if above is None:
                    raise
                result = above
            if result.undecided:
                self.warn(f"{step.text}: this is not decided; nothing that was tried refutes it")
            return result
        except RestitutionError as error:
            column = None if step.place is None else step.place.column
            if error.line is None:
                error = error.at(line, column)
            return ItemResult(step, line, step.text, "show", error=error)
        except UNFORESEEN as error:
            return ItemResult(step, line, step.text, "show", error=unforeseen(error, line))

    def _above_facts(self, step: Show, now: int) -> ItemResult | None:
        """A claim as it holds without the facts below it in its part; None where it does not."""
        from restitution.solving.showing import show

        steps = self.part.steps
        cut = next(n for n, other in enumerate(steps, 1) if other is step)
        rest = tuple(step for step in steps[cut:] if not isinstance(step, Given | Find | Show))
        if not any(isinstance(step, Given) for step in steps[cut:]):
            return None
        own = replace(self.part, steps=(*steps[:cut], *rest))
        parts = tuple(own if part is self.part else part for part in self.problem.parts)
        without = Worker(Desk(replace(self.problem, parts=parts), own, self.desk.carried))
        try:
            result = show(without, step, now)
        except RestitutionError:
            return None
        return result if result.holds else None


def _is_long(value: sp.Expr) -> bool:
    """Whether another form of a value may be shorter; of what nobody reads none is looked for."""
    return exact.cost(value) > LONG and not forms.is_for_a_calculator(value)
