"""``show``: decided by the values. A false claim is answered with numbers that refute it."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution import exact
from restitution.errors import MissingError, RestitutionError, UnsupportedError
from restitution.expression.tree import letters
from restitution.problem import Compare, Extremum, Range, Show, trees_of_relation
from restitution.solve.coefficients import without_impossible
from restitution.solve.conditions import AnyOf, Condition, Equation
from restitution.solve.facts import requirements
from restitution.solve.neat import neat
from restitution.solve.numbers import FIELD, TINY, UndefinedError, at
from restitution.solve.part import Letters, Numbers, holds
from restitution.solve.solution import Branch, ItemResult

if TYPE_CHECKING:
    from restitution.solve.solver import _Worker

TRIALS = 160
FEW = 16
# What is longer than this is not factorised to see which letters matter.
LONG = 400


def show(worker: _Worker, step: Show, now: int) -> ItemResult:
    """Whether a claim follows from the facts, for all admissible values of its letters."""
    line = None if step.place is None else step.place.line
    if step.subject is not None:
        return _show_found(worker, step, now, line)
    outcome, branches = worker.solved(step.in_terms_of, step)
    if not outcome.accepted:
        trees = list(trees_of_relation(step.relation))
        branches = without_impossible(branches, outcome.setting, trees, now)
    for branch in branches:
        refuted = _refute(worker, outcome, branch, step, now)
        if refuted is not None:
            return ItemResult(step, line, step.text, "show", holds=False, counterexample=refuted)
    return ItemResult(step, line, step.text, "show", holds=True)


def _refute(
    worker: _Worker, outcome: Any, branch: Branch, step: Show, now: int
) -> dict[str, str] | None:
    """Values of the letters for which a claim is false; None if it holds for all."""
    claim = step.relation
    setting = outcome.setting
    free = sorted(
        name for name in setting.roles if name not in branch.values and name not in setting.lets
    )
    needs = _needs(claim, branch, now, step)
    hidden_roles = {**outcome.letters.hidden_roles, **_hidden_roles(branch)}
    hidden = sorted(name for name in hidden_roles if name not in branch.values)
    roles = {**setting.roles, **hidden_roles}
    trials = FEW if isinstance(claim, Compare) and claim.figures is not None else TRIALS
    if isinstance(claim, Compare) and set(claim.operators) == {"="} and claim.figures is None:
        wanted = requirements(claim, branch.story, now, step.place)
        symbolic = [need for need in wanted if isinstance(need, Equation)]
        conditions = [need for need in wanted if not isinstance(need, Equation)]
        if all(_is_identity(need.value, roles) for need in symbolic):
            if not conditions:
                return None
            trials = FEW  # the equation holds; only a sign is left to be tried
    rng = random.Random(5)
    checked = 0
    points = trials if free or hidden else 1
    for n in range(points):
        values: dict[str, Any] = {}
        shown: dict[str, str] = {}
        for name in free:
            number = _nice(roles[name], rng, n)
            shown[name] = number[0]
            values[name] = number[1]
        for name in hidden:
            values[name] = _nice(roles[name], rng, n)[1]
        try:
            for name, value in branch.values.items():
                values[name] = at(value, values)
            solved = [name for name in branch.values if not name.startswith("_")]
            story = setting.tell(Numbers(values))
            if outcome.accepted and setting.examine(values, solved, story) is not None:
                continue
            if claim_fails(claim, story, now, step):
                for name, value in branch.values.items():
                    if not name.startswith("_"):
                        shown[name] = exact.sympy_text(exact.tidy(_with(value, shown, roles)))
                used = _used(worker, outcome)
                if needs is not None:
                    matters = _matters(claim, needs)
                    _complete(matters, branch)
                    used &= matters
                return {k: v for k, v in shown.items() if k in used}
        except MissingError:
            raise
        except (UndefinedError, ArithmeticError, KeyError, RestitutionError):
            continue
        checked += 1
    if checked == 0:
        # No simple numbers satisfy the facts: those serve by which the solution was accepted.
        found = outcome.accepted[branch.number - 1].samples if outcome.accepted else ()
        stories = [setting.tell(Numbers(each)) for each in (*found, branch.sample)]
        return {} if any(claim_fails(claim, story, now, step) for story in stories) else None
    return None


def _complete(matters: set[str], branch: Branch) -> None:
    """Raises MissingError where a claim rests on what the statement leaves open."""
    phrases = branch.letters.phrases if isinstance(branch.letters, Letters) else {}
    open_ = sorted(name for name in matters if name.startswith("_"))
    if open_:
        needed = dict.fromkeys(phrases.get(name, name.lstrip("_")) for name in open_)
        raise MissingError(f"this claim needs {' and '.join(needed)}")


def _hidden_roles(branch: Branch) -> dict[str, Any]:
    return branch.letters.hidden_roles if isinstance(branch.letters, Letters) else {}


def _needs(claim: Any, branch: Branch, now: int, step: Show) -> list[Any] | None:
    """What a claim asks for, in letters; None where it cannot be told so."""
    try:
        return requirements(claim, branch.story, now, step.place)
    except (RestitutionError, ArithmeticError, TypeError, ValueError):
        return None


def _matters(claim: Any, needs: list[Any]) -> set[str]:
    """The letters and hidden unknowns on which a claim depends, with those that it names."""
    found: set[str] = set()
    for tree in trees_of_relation(claim):
        found |= letters(tree)
    for need in needs:
        for each in need.options if isinstance(need, AnyOf) else (need,):
            found |= _deciding(sp.sympify(each.value, strict=True))
    return found


def _deciding(value: sp.Expr) -> set[str]:
    """The letters on which it depends whether a value is 0, or which sign it has."""
    if sp.count_ops(value) > LONG:
        return {s.name for s in value.free_symbols}
    parts = [
        each for side in sp.fraction(sp.factor(neat(value))) for each in sp.Mul.make_args(side)
    ]
    return {
        s.name
        for each in parts
        if not (each.is_positive or each.is_negative)
        for s in each.free_symbols
    }


def _used(worker: _Worker, outcome: Any) -> set[str]:
    from restitution.problem import Impact, trees

    used: set[str] = set()
    for tree in trees(worker.problem):
        used |= letters(tree)
    if any(isinstance(s, Impact) and s.e is None for _, s in worker.problem.steps()):
        used.add("e")
    return used - set(outcome.setting.lets)


def _with(value: sp.Expr, shown: dict[str, str], roles: Any) -> sp.Expr:
    put = {}
    for symbol in value.free_symbols:
        if symbol.name in shown:
            put[symbol] = _number_of(shown[symbol.name])
    return value.xreplace(put)


def _number_of(text: str) -> sp.Expr:
    if "pi" in text:
        head = text.replace("*pi", "").replace("pi", "1")
        return sp.Rational(head) * sp.pi
    return sp.Rational(text)


def claim_fails(claim: Any, story: Any, now: int, step: Show) -> bool:
    """Whether a claim is false in a story told in numbers."""
    if isinstance(claim, Compare) and claim.figures is not None:
        return _figures_fail(claim, story, now)
    for need in requirements(claim, story, now, step.place):
        if isinstance(need, Equation) and abs(need.value) > TINY * 10**5:
            return True
        if isinstance(need, Condition) and not _holds_firmly(need):
            return True
        if isinstance(need, AnyOf) and not any(holds(each) for each in need.options):
            return True
    return False


def _holds_firmly(condition: Condition) -> bool:
    return holds(condition)


def _figures_fail(claim: Compare, story: Any, now: int) -> bool:
    """Whether the sides differ when rounded to so many figures."""
    evaluator = story.evaluator(now)
    left, right = (evaluator.scalar(tree) for tree in claim.operands)
    assert claim.figures is not None
    if right == 0:
        return bool(abs(left) > TINY)
    ratio = FIELD.context.mpf(left) / right
    # The right side is a rounded number times a monomial: half a unit of its last figure.
    coefficient = _leading(claim.operands[-1])
    unit = Fraction(1)
    size = abs(coefficient)
    if size == 0:
        return True
    exponent = 0
    while size >= 10:
        size /= 10
        exponent += 1
    while size < 1:
        size *= 10
        exponent -= 1
    unit = Fraction(10) ** (exponent - claim.figures + 1)
    share = FIELD.number(unit / (2 * abs(coefficient)))
    return bool(abs(ratio - 1) > share * (1 + TINY))


def _leading(tree: Any) -> Fraction:
    from restitution.expression.evaluate import evaluate

    value = evaluate(tree, lambda name: sp.Symbol(name, positive=True))
    coefficient, _ = sp.sympify(value, strict=True).as_coeff_Mul()
    if not coefficient.is_Rational or coefficient == 0:
        raise UnsupportedError("a rounded result is a number, perhaps times letters")
    return Fraction(int(coefficient.p), int(coefficient.q))


def _is_identity(value: Any, roles: Any) -> bool:
    from restitution.solve.numbers import vanishes

    value = sp.sympify(value, strict=True)
    if value == 0:
        return True
    return vanishes(value, roles) or bool(exact.is_zero(value))


def _nice(role: Any, rng: random.Random, n: int) -> tuple[str, Any]:
    """A simple admissible number, exactly as text and in high precision."""
    if role.kind == "angle":
        degrees = rng.choice((30, 45, 60, 15, 75, 20, 40, 50, 70, 10, 80, 5, 85, 1, 89))
        if role.high is not None and role.high > sp.pi / 2 and rng.random() < 0.5:
            degrees = 180 - degrees
        value = sp.Rational(degrees, 180) * sp.pi
        return exact.sympy_text(value), at(value, {})
    low = Fraction(0) if role.low is None else _fraction(role.low)
    high = None if role.high is None else _fraction(role.high)
    if role.kind == "restitution" or high is not None:
        top = high if high is not None else Fraction(1)
        choices = (
            Fraction(1, 2),
            Fraction(1, 4),
            Fraction(3, 4),
            Fraction(1, 3),
            Fraction(9, 10),
            Fraction(1, 10),
            Fraction(0),
            Fraction(1),
            Fraction(1, 100),
            Fraction(99, 100),
        )
        share = rng.choice(choices)
        if share == 0 and not role.closed[0]:
            share = Fraction(1, 50)
        if share == 1 and not role.closed[1]:
            share = Fraction(49, 50)
        value = low + share * (top - low)
    else:
        above = rng.choice((1, 2, 3, 4, 5, 1, 2, 10, 20, 50))
        value = Fraction(above, rng.choice((1, 1, 1, 2, 3, 7, 20)))
        value = low + value if role.low is not None else value * rng.choice((1, -1))
    return str(sp.Rational(value.numerator, value.denominator)), FIELD.number(value)


def _fraction(x: sp.Expr) -> Fraction:
    if x.is_Rational:
        return Fraction(int(x.p), int(x.q))
    return Fraction(float(x)).limit_denominator(1000)


def _show_found(worker: _Worker, step: Show, now: int, line: int | None) -> ItemResult:
    """``show range of e: …`` and ``show maximum of Q over X = …``."""
    subject = step.subject
    assert subject is not None
    assert isinstance(step.relation, Compare)
    found = worker._item(subject, now, step.in_terms_of)
    if found.error is not None:
        raise found.error
    roles = worker.desk.settle(step.in_terms_of, subject).roles
    letters_ = Letters(roles)
    from restitution.expression.evaluate import Evaluator, Symbolic

    evaluator = Evaluator(Symbolic(), letters_.letter)
    if isinstance(subject, Extremum):
        claimed = evaluator.scalar(step.relation.operands[-1])
        value = found.answers[0].value
        ok = bool(exact.same(claimed, value))
        return _compared(step, line, found, ok)
    assert isinstance(subject, Range)
    from restitution.solve.ranges import claimed_set, same_set

    claimed = claimed_set(step.relation, subject, evaluator)
    sets = [each.value for each in found.answers]
    ok = same_set(claimed, sp.Union(*sets) if sets else sp.S.EmptySet, roles)
    return _compared(step, line, found, ok)


def _compared(step: Show, line: int | None, found: ItemResult, ok: bool) -> ItemResult:
    """A claim beside what was found: where it is false, the truth is its answer."""
    return ItemResult(step, line, step.text, "show", () if ok else found.answers, holds=ok)
