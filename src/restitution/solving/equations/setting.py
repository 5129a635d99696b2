"""One part as one of its items sees it, and the trial of values for its unknowns."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from fractions import Fraction

import sympy as sp

from restitution.errors import ImpossibleError, RestitutionError, StatementError
from restitution.exact.symbols import operations_in
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.oracle import BeyondError, Point, Relation
from restitution.oracle.roles import Role
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
from restitution.records import dataclass
from restitution.solving.algebra.numbers import FIELD, Sample, at, bound, number_of, sample
from restitution.solving.algebra.systems import Root
from restitution.solving.equations.facts import givens, needs_of_motion, requirements
from restitution.solving.equations.stages import by_nested_roots
from restitution.solving.story.admission import (
    COEFFICIENT_RULE,
    EQUATION,
    Admission,
    demands_for,
    demands_of,
)
from restitution.solving.story.conditions import AnyOf, Condition, Equation
from restitution.solving.story.contacts import ends_at_a_point
from restitution.solving.story.forward import Story, lets_of
from restitution.solving.story.letters import narrowed_by, roles
from restitution.solving.story.unknowns import SYMBOLIC, Letters, Numbers

SAMPLES_WANTED = 4
SAMPLES_TRIED = 160
POINTS_TRIED = 48
# What is longer than this nobody would read, and takes long to put into a tidy form.
UNWIELDY = 120
EDGES_TRIED = 4

NOT_DECIDED = "whether it is possible for any values of the letters is not decided"
"""Of a solution that is neither seen to be possible nor proved to be impossible."""


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
    taken to fix. After ``sloped_after`` events no fact speaks of a motion: a line of centres that
    is open then may be any, and is told by its slope.
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
    sloped_after: int | None = None

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
        return Story(
            self.problem,
            self.part,
            arithmetic,
            unknowns,
            self.lets,
            sloped_after=self.sloped_after,
        )

    def requirements(self, story: Story) -> list[Equation | Condition | AnyOf]:
        """Requirements of the facts and of the names in force, in this story."""
        requirements_: list[Equation | Condition | AnyOf] = []
        for given, now in self.facts:
            for relation in given.relations:
                requirements_ += requirements(relation, story, now, given.place)
                requirements_ += needs_of_motion(relation, story, now)
        for let, now in self.named:
            relation = Compare((Letter(let.letter), let.expression), ("=",))
            requirements_ += requirements(relation, story, now, let.place)
        return requirements_

    # --- checking --------------------------------------------------------------------------

    def examine(
        self,
        values: Mapping[str, Enclosed],
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
            return next((letter for letter in outside if letter[1] != "coefficient"), outside[0])
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
        if any(value.has(sp.I) for value in assignment.values.values()):
            return Trial(assignment, (), "it has no real value", "equation")
        long = any(operations_in(value) > UNWIELDY for value in assignment.values.values())
        if long or by_nested_roots(assignment.values):
            return self.try_at_points(assignment, letters_)
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
            return self.try_at_points(assignment, letters_)
        if admission is None:
            return self.try_at_points(assignment, letters_)
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
        # A working is written at the first of the samples: there signs are as they look.
        as_they_look: Sample | None = None
        for attempt in range(POINTS_TRIED if free else 1):
            values = sample(free, known, rng)
            plain = as_they_look is None and attempt % 2 == 0
            if plain:
                values = {n: x if x.sign >= 0 else -x for n, x in values.items()}
            numbers = stories[0] if stories else None
            trial = Trial(assignment, (), None, None, admission, story, None, numbers)
            reason = self._objection(trial, values, stories)
            if reason is None:
                accepted.append(values)
                if plain:
                    as_they_look = values
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
                values |= {name: number_of(number) for name, number in possible.witness.items()}
                trial = Trial(assignment, (), None, None, admission, story)
                reason = self._objection(trial, values, stories, possible.witness)
                if reason is None:
                    accepted.append(values)
                else:
                    reasons[reason] += 1
            by_formulas = possible.answer == "undecided" or reasons[EQUATION]
            if not accepted and by_formulas and not _is_refuted(admission):
                return Trial(assignment, (), NOT_DECIDED, "undecided", admission)
        if as_they_look is not None and as_they_look is not accepted[0]:
            accepted.sort(key=lambda attempt: attempt is not as_they_look)
            stories.insert(0, self.tell(Numbers(as_they_look)))
        if accepted and reasons[EQUATION]:
            admission = admission.with_senses(accepted)
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

    def try_at_points(
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


def _is_refuted(admission: Admission) -> bool:
    """Whether it is proved that no values of the letters satisfy all that is asked."""
    if admission.oracle.possible.answer == "refuted":
        return True
    equations = [Relation(equation, "=") for equation in admission.equations]
    return admission.oracle.with_facts(equations).possible.answer == "refuted"


def _needs_no_numbers(story: Story | None) -> bool:
    return story is not None and not story.needs_numbers


def _is_empty(role: Role) -> bool:
    return role.low is not None and role.high is not None and bool(role.low > role.high)


def holds(condition: Condition) -> bool:
    """Whether a condition holds, in numbers."""
    sign = Enclosed.of(condition.value).sign
    return {">": sign > 0, ">=": sign >= 0, "!=": sign != 0}[condition.relation]


def is_met(requirement: Equation | Condition | AnyOf) -> bool:
    """Whether a requirement is met, in numbers."""
    match requirement:
        case Equation(value):
            return Enclosed.of(value).sign == 0
        case AnyOf(options):
            return any(map(holds, options))
    return holds(requirement)


def out_of_range(name: str, value: Enclosed, role: Role | None) -> tuple[str, str] | None:
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
        known = {name: narrowed_by(role, name, given, known) for name, role in known.items()}
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
        carried - protected,
        _claims(part, item),
        _sloped_after(problem, part, facts, lets_of(problem, part), named),
    )


def _sloped_after(
    problem: Problem,
    part: Part,
    facts: Sequence[tuple[Given, int]],
    lets: Mapping[str, tuple[Let, int]],
    named: Sequence[tuple[Let, int]],
) -> int | None:
    """After how many events no fact speaks of a motion; None where no line of centres is open."""
    placed = {sphere.name for sphere in problem.spheres if sphere.position is not None}
    spheres = {sphere.name for sphere in problem.spheres}
    open_ = [
        number
        for number, step in enumerate(problem.events, 1)
        if isinstance(step, Impact)
        and step.along is None
        and step.offset is None
        and step.second in spheres
        and not {step.first, step.second} <= placed
    ]
    if not open_ or ends_at_a_point(problem, part):
        return None
    of_motion = [
        now
        for given, now in facts
        for relation in given.relations
        if not isinstance(relation, Compare)
        or any(has_quantity(side) or letters(side) & lets.keys() for side in relation.operands)
    ]
    last = max([0, *of_motion, *(now for _, now in named)])
    return last if last < max(open_) else None


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
