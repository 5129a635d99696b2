"""Data that imply an impossible coefficient of restitution: what rests on it has no value.

The facts may fix a quantity without it: where a velocity after the impact is given, momentum tells
the other, and the coefficient is only what Newton's law makes of the two. So every impact in
question gets a coefficient of its own, and a quantity is kept if the facts fix it all the same.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution import exact
from restitution.errors import ImpossibleError, RestitutionError
from restitution.expression.enclosed import Enclosed
from restitution.expression.evaluate import Angle
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Expression, Letter, Quantity, letters, line_and_column, walk
from restitution.expression.writing import write_expression
from restitution.problem import Event, Impact, Step
from restitution.records import dataclass
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.algebra.numbers import Sample
from restitution.solving.algebra.signs import sign
from restitution.solving.equations.part import Outcome
from restitution.solving.equations.setting import Setting
from restitution.solving.equations.solution import Branch
from restitution.solving.story.bodies import coefficient_outside
from restitution.solving.story.conditions import Equation
from restitution.solving.story.happenings import Happening
from restitution.solving.story.unknowns import Numbers

COEFFICIENTS = "a coefficient of restitution lies in [0, 1]"
OWN = "coefficient {}"  # no name that a letter can have
STEP = Fraction(1, 10**190)
SMALL = Fraction(1, 10**47)
Numeric = tuple[Enclosed, ...]


@dataclass(frozen=True)
class Impossible:
    """A coefficient outside [0, 1]: what it is, as text, where, and the letters in it."""

    text: str
    event: int
    step: Impact
    letters: frozenset[str]


def warning_of(wrong: Sequence[Impossible]) -> str:
    """What to say of coefficients outside [0, 1]: that they are given, or follow from the data."""
    values = " or ".join(dict.fromkeys(coefficient.text for coefficient in wrong))
    verb = "the statement gives" if _are_given(wrong) else "the data imply"
    return f"{verb} {values}, and {COEFFICIENTS}"


def _are_given(wrong: Sequence[Impossible]) -> bool:
    return all(coefficient_outside(coefficient.step) for coefficient in wrong)


def impossible_coefficients(branch: Branch) -> list[Impossible]:
    """The coefficients outside [0, 1], in the order of the impacts."""
    impossible = []
    for happening, exactly in zip(branch.numbers.happenings, branch.story.happenings, strict=True):
        beyond = outside(happening) or _outside_by_little(happening, exactly)
        if beyond and isinstance(happening.step, Impact):
            e = happening.step.e
            if e is not None and coefficient_outside(happening.step):
                shown = write_expression(e)  # as typed: rounded, it may be 1.00
            else:
                shown = to_text(display(exact.tidy(exactly.e)))
            name = to_text(display(sp.Symbol(e.name))) if isinstance(e, Letter) else "e"
            impossible.append(
                Impossible(
                    f"{name} = {shown}",
                    happening.number,
                    happening.step,
                    coefficient_letters(happening.step),
                )
            )
    return impossible


def outside(happening: Happening) -> bool:
    """Whether an event, told in numbers, has an impossible coefficient."""
    given = isinstance(happening.step, Impact) and coefficient_outside(happening.step)
    return happening.e is not None and (given or not 0 <= happening.e <= 1)


def _outside_by_little(happening: Happening, exactly: Happening) -> bool:
    """Whether a coefficient is outside [0, 1] by less than its digits in numbers show."""
    if happening.e is None or (happening.e > 0 and happening.e < 1):
        return False
    e = sp.sympify(exactly.e, strict=True)
    return not e.free_symbols and -1 in (sign(e), sign(1 - e))


def coefficient_letters(step: Event) -> frozenset[str]:
    """The letters in the coefficient of an impact."""
    if not isinstance(step, Impact):
        return frozenset()
    return frozenset({"e"}) if step.e is None else letters(step.e)


def without_impossible(
    branches: Sequence[Branch], setting: Setting, trees: Sequence[Expression], now: int
) -> list[Branch]:
    """The branches in which expressions do not rest on an impossible coefficient.

    Raises ImpossibleError where there is none.
    """
    kept = [
        branch for branch in branches if not any(_rests(branch, setting, t, now) for t in trees)
    ]
    if branches and not kept:
        named = {name for tree in trees for name in letters(tree)}
        every = [_blamed(branch, named) for branch in branches]
        blamed = every[0]
        e = blamed.step.e
        place = line_and_column(e.place if e is not None and not blamed.letters else None)
        values = " or ".join(dict.fromkeys(wrong.text for wrong in every))
        rejected = "" if _are_given(every) else " rejected"
        error = ImpossibleError(f"{values}{rejected}: {COEFFICIENTS}", *place)
        error.because = f"the data give {values}, and {COEFFICIENTS}"
        raise error
    return kept


def require_possible_value(
    solved: Callable[[], tuple[Outcome, list[Branch]]], tree: Expression, now: int
) -> None:
    """Raises ImpossibleError for the letter of a coefficient that is one number outside [0, 1].

    ``solved`` gives what solving the part gives.
    """
    try:
        outcome, branches = solved()
    except RestitutionError:
        return
    if isinstance(tree, Letter) and not outcome.accepted and branches:
        values = [branch.values.get(tree.name) for branch in branches]
        if all(value is not None and value.is_number for value in values):
            without_impossible(branches, outcome.setting, [tree], now)


def _blamed(branch: Branch, named: set[str]) -> Impossible:
    """The impossible coefficient of a solution: one with a letter that is named, if there is."""
    wrong = impossible_coefficients(branch)
    return next((impossible for impossible in wrong if impossible.letters & named), wrong[0])


def _rests(branch: Branch, setting: Setting, tree: Expression, now: int) -> bool:
    """Whether the facts leave an expression open, were the coefficients no longer tied together.

    To first order, at this solution: they fix it if its gradient is made up of theirs. With −1
    nothing happens at the impact: then what tells of it fixes nothing.
    """
    if any(letters(tree) & wrong.letters for wrong in impossible_coefficients(branch)):
        return True
    if any(isinstance(node, Quantity) and node.kind in LOSSES for node in walk(tree)):
        return True  # nothing is lost where a coefficient is above 1
    freed, own = _freed(branch, setting)
    values = {**branch.sample, **own}
    unknowns = [*branch.values, *own]

    def facts(at: Sample) -> Numeric:
        story = freed.tell(Numbers(at))
        wanted = (*story.equations, *freed.requirements(story))
        return tuple(condition.value for condition in wanted if isinstance(condition, Equation))

    def asked(at: Sample) -> Numeric:
        value = freed.tell(Numbers(at)).evaluator(now).value(tree)
        if isinstance(value, Angle):
            return (value.measure(),)
        return value if isinstance(value, tuple) else (value,)

    try:
        fixed = _gradients(facts, values, unknowns)
        if any((coefficient + 1).sign == 0 for coefficient in own.values()):
            fixed = [row for row in fixed if not any(row[len(branch.values) :])]
        return any(not _is_combination(row, fixed) for row in _gradients(asked, values, unknowns))
    except (RestitutionError, ArithmeticError):
        return True


def _freed(branch: Branch, setting: Setting) -> tuple[Setting, Sample]:
    """The setting with a coefficient of its own for every impact in question, and their values."""
    wrong = impossible_coefficients(branch)
    events = {impossible.event for impossible in wrong}
    names = {name for impossible in wrong for name in impossible.letters}
    own: Sample = {}
    parts = []
    number = 0
    for part in setting.problem.parts:
        steps: list[Step] = []
        for step in part.steps:
            number += isinstance(step, Event)
            if (
                isinstance(step, Impact)
                and number <= len(branch.numbers.happenings)
                and (number in events or coefficient_letters(step) & names)
            ):
                name = OWN.format(number)
                own[name] = branch.numbers.happenings[number - 1].e
                step = replace(step, e=Letter(name))
            steps.append(step)
        parts.append(replace(part, steps=tuple(steps)))
    part = parts[setting.problem.parts.index(setting.part)]
    problem = replace(setting.problem, parts=tuple(parts))
    return replace(setting, problem=problem, part=part), own


def _gradients(
    function: Callable[[Sample], Numeric], values: Sample, names: Sequence[str]
) -> list[list[Fraction]]:
    """For every component of a function its changes with each name, the largest as 1.

    Every name is changed in the same proportion, so that nothing hangs on the units.
    """
    here = function(values)
    moved = [
        function(
            {**values, name: values[name] * (1 + STEP) if values[name].sign else Enclosed.of(STEP)}
        )
        for name in names
    ]
    rows = [[(point[n] - here[n]).fraction for point in moved] for n in range(len(here))]
    sizes = [max(map(abs, row), default=Fraction(0)) for row in rows]
    return [[x / size if size else x for x in row] for row, size in zip(rows, sizes, strict=True)]


def _is_combination(row: Sequence[Fraction], of: Sequence[Sequence[Fraction]]) -> bool:
    """Whether a row is a linear combination of others: by elimination."""
    rest = [list(gradient) for gradient in of]
    row = list(row)
    for column in range(len(row)):
        sizes = [abs(line[column]) for line in rest]
        if not sizes or max(sizes) < SMALL:
            if abs(row[column]) > SMALL:
                return False
            continue
        pivot = rest[sizes.index(max(sizes))]
        rest = [line for line in rest if line is not pivot]
        for line in (*rest, row):
            share = line[column] / pivot[column]
            line[:] = [a - share * b for a, b in zip(line, pivot, strict=True)]
    return True
