"""``show``: a claim decided for all admissible letters, by the oracle.

A false claim is answered with values that refute it; one that is neither proved nor refuted is
said to be undecided.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Protocol

import sympy as sp

from restitution import exact
from restitution.errors import UnsupportedError
from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Angle, Evaluator, evaluate
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import Degrees, Expression, Quantity, letters, walk
from restitution.oracle import (
    BeyondError,
    Formula,
    Oracle,
    Point,
    Relation,
    Verdict,
    joined,
    relations,
)
from restitution.oracle.roles import REAL, Role
from restitution.problem import (
    Aligned,
    Compare,
    Extremum,
    Impact,
    Item,
    Problem,
    Range,
    Show,
    trees,
    trees_of_relation,
)
from restitution.problem import (
    Relation as Said,
)
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.numbers import at
from restitution.solving.claimed import claimed_set, same_set, same_value
from restitution.solving.equations.coefficients import without_impossible
from restitution.solving.equations.facts import requirements
from restitution.solving.equations.part import Desk, Outcome
from restitution.solving.equations.solution import Branch, ItemResult
from restitution.solving.story import missing
from restitution.solving.story.admission import formula_of
from restitution.solving.story.conditions import Equation
from restitution.solving.story.unknowns import SYMBOLIC, Letters
from restitution.vector import Vector

# What is longer than this is not factorised to see which letters matter.
LONG = 400
UNDECIDED = Verdict("undecided", "undecided")


class Results(Protocol):
    """The results of one part so far, by which a claim is decided."""

    desk: Desk

    @property
    def problem(self) -> Problem: ...

    def solved(
        self, in_terms_of: tuple[str, ...] | None, claim: Show | None = None
    ) -> tuple[Outcome, list[Branch]]: ...

    def item_result(
        self, item: Item, now: int, in_terms_of: tuple[str, ...] | None
    ) -> ItemResult: ...

    def warn(self, text: str) -> None: ...


def show(results: Results, step: Show, now: int) -> ItemResult:
    """Whether a claim follows from the facts, for all admissible values of its letters."""
    line = None if step.place is None else step.place.line
    if step.subject is not None:
        return _show_set_or_extremum(results, step, now, line)
    outcome, branches = results.solved(step.in_terms_of, step)
    if not outcome.accepted:
        trees_ = list(trees_of_relation(step.relation))
        branches = without_impossible(branches, outcome.setting, trees_, now)
    verdicts: list[Verdict] = []
    for branch in branches:
        verdict, claim = _verdict(outcome, branch, step, now)
        if verdict.answer == "refuted":
            values = _counterexample(results, outcome, branch, verdict.witness or {}, claim, step)
            signed = _if_positive(outcome, branch, verdict.witness or {}, claim)
            if signed:
                results.warn(_of_any_sign(step, signed))
            return ItemResult(
                step,
                line,
                step.text,
                "show",
                holds=False,
                counterexample=values,
                proof=verdict.proof,
                trials=verdict.trials,
            )
        verdicts.append(verdict)
    worst = max(verdicts, key=lambda verdict: _WEAKNESS.index(verdict.proof))
    return ItemResult(
        step,
        line,
        step.text,
        "show",
        holds=None if worst.answer == "undecided" else True,
        proof=worst.proof,
        trials=max(verdict.trials for verdict in verdicts),
    )


_WEAKNESS = ("algebra", "decision", "intervals", "witness", "undecided")


def _verdict(outcome: Outcome, branch: Branch, step: Show, now: int) -> tuple[Verdict, Formula]:
    """The verdict on a claim in one solution, and the claim as a formula in its letters."""
    letters_ = branch.letters
    if isinstance(letters_, Letters) and not letters_.certain:
        # Signs may have been taken for granted for other questions: told anew, for this one alone.
        letters_ = replace(letters_, assumed=[], undecided=[])
        branch = replace(branch, letters=letters_, exact=branch.tell(letters_))
    claim = _formula(step, branch, now)
    oracle = _oracle(outcome, branch)
    try:
        verdict = oracle.decide(claim)
        if verdict.answer == "refuted" and (existence := _existence(branch, step, now)):
            # Where an angle has no value, a claim about it says nothing.
            oracle = oracle.with_facts(existence)
            verdict = oracle.decide(claim)
        if verdict.answer == "refuted" and (sizes := _sizes(branch, step, now)):
            # What is at rest has no direction, and a claim of directions says nothing of it.
            oracle = oracle.with_facts(sizes)
            verdict = oracle.decide(claim)
        if verdict.answer == "refuted":
            verdict = _least_signed(oracle, outcome, claim, verdict)
    except BeyondError:
        return UNDECIDED, claim
    if verdict and not (isinstance(letters_, Letters) and letters_.certain):
        return UNDECIDED, claim
    if verdict and not _has_value(claim, branch):
        raise UnsupportedError("a tangent or a quotient in this claim has no value")
    return verdict, claim


def _least_signed(oracle: Oracle, outcome: Outcome, claim: Formula, verdict: Verdict) -> Verdict:
    """The same refutation at a point where letters of either sign are positive, else −1.

    Where neither may be, the point is left as it is.
    """
    for name in _signed(outcome, verdict.witness or {}):
        symbol = REAL.symbol(name)
        for fact in (Relation(symbol, ">"), Relation(symbol + 1, "=")):
            if fact == claim:
                continue
            try:
                other = oracle.with_facts((fact,)).decide(claim)
            except BeyondError:
                continue
            if other.answer == "refuted" and other.witness is not None:
                oracle, verdict = oracle.with_facts((fact,)), other
                break
    return verdict


def _signed(outcome: Outcome, witness: Point) -> list[str]:
    """The letters of either sign that are not positive at a point."""
    roles = outcome.setting.roles
    return [
        name
        for name in sorted(witness)
        if name in roles and roles[name] == REAL and not _number(witness[name]).is_positive
    ]


def _has_value(claim: Formula, branch: Branch) -> bool:
    """Whether what is claimed has a value in a solution, so that the claim says something."""
    try:
        for relation in relations(claim):
            at(relation.value, branch.sample)
    except UndefinedError:
        return False
    except KeyError:
        return True
    return True


def _existence(branch: Branch, step: Show, now: int) -> list[Formula]:
    """That the angles in a claim have values: neither of their directions is that of a rest."""
    evaluator = branch.story.evaluator(now)
    facts: list[Formula] = []
    for tree in trees_of_relation(step.relation):
        for node in walk(tree):
            if isinstance(node, Quantity) and node.kind in ANGLES:
                value = evaluator.value(node)
                if isinstance(value, Angle):
                    size = sp.sympify(value.x**2 + value.y**2, strict=True)
                    if size.free_symbols:
                        facts.append(Relation(size, ">"))
    return facts


def _sizes(branch: Branch, step: Show, now: int) -> list[Formula]:
    """That neither vector of a claim about directions is zero."""
    claim = step.relation
    if not isinstance(claim, Aligned):
        return []
    evaluator = branch.story.evaluator(now)
    values = (evaluator.value(side) for side in (claim.left, claim.right))
    sizes = (
        sp.sympify(value.x**2 + value.y**2, strict=True)
        for value in values
        if isinstance(value, Vector)
    )
    return [Relation(size, ">") for size in sizes if size.free_symbols]


def _oracle(outcome: Outcome, branch: Branch) -> Oracle:
    """The oracle for the letters of a solution."""
    if outcome.accepted:
        admission = outcome.accepted[branch.number - 1].admission
        if admission is not None:
            return admission.oracle
    return Oracle({**outcome.letters.all_roles(), **_hidden_roles(branch)})


def _if_positive(outcome: Outcome, branch: Branch, witness: Point, claim: Formula) -> list[str]:
    """The letters of either sign for whose positive values alone a claim is proved."""
    roles = outcome.setting.roles
    every = [name for name in sorted(witness) if name in roles and roles[name] == REAL]
    signed = _signed(outcome, witness)
    for names in (signed, every) if signed else ():
        positive = [Relation(REAL.symbol(name), ">") for name in names]
        try:
            if claim not in positive and _oracle(outcome, branch).with_facts(positive).decide(
                claim
            ):
                return names
        except BeyondError:
            return []
    return []


def _of_any_sign(step: Show, names: list[str]) -> str:
    shown = [to_text(display(sp.Symbol(name))) for name in names]
    facts = ", ".join(f"{name} > 0" for name in shown)
    which = "it stands for a component with its sign"
    if len(shown) > 1:
        which = "they stand for components with their signs"
    return (
        f"{step.text}: it holds for {facts}, but {' and '.join(shown)} need not be, "
        f"as {which}: write 'given {facts}' if that is meant"
    )


def _formula(step: Show, branch: Branch, now: int) -> Formula:
    claim = step.relation
    if isinstance(claim, Compare) and claim.figures is not None:
        return _rounded(claim, branch, now)
    needs = requirements(claim, branch.story, now, step.place)
    return joined(
        Relation(sp.sympify(need.value, strict=True), "=")
        if isinstance(need, Equation)
        else formula_of(need)
        for need in needs
    )


def _rounded(claim: Compare, branch: Branch, now: int) -> Formula:
    """The sides agree when rounded to so many figures."""
    evaluator = branch.story.evaluator(now)
    left, right = (sp.sympify(evaluator.scalar(tree), strict=True) for tree in claim.operands)
    assert claim.figures is not None
    if right == 0:
        return Relation(left, "=")
    # The right side is a rounded number times a monomial: half a unit of its last figure.
    coefficient = abs(_leading(claim.operands[-1]))
    unit = Fraction(10) ** (_exponent(coefficient) - claim.figures + 1)
    share = sp.Rational(unit.numerator, unit.denominator) / (
        2 * sp.Rational(coefficient.numerator, coefficient.denominator)
    )
    ratio = left / right
    return joined([Relation(share - (ratio - 1), ">="), Relation(share + (ratio - 1), ">=")])


def _exponent(size: Fraction) -> int:
    """The power of ten of the first figure."""
    power = len(str(size.numerator)) - len(str(size.denominator))
    return power if size >= Fraction(10) ** power else power - 1


def _counterexample(
    results: Results,
    outcome: Outcome,
    branch: Branch,
    witness: Point,
    claim: Formula,
    step: Show,
) -> dict[str, str]:
    """The values of the letters that matter, as exact text."""
    matters = _matters(step.relation, claim)
    _complete(matters, branch)
    roles = outcome.setting.roles
    put = {name: _number(value) for name, value in witness.items()}
    shown = {name: value for name, value in put.items() if name in roles}
    for name, value in branch.values.items():
        if not name.startswith("_"):
            there = value.xreplace({s: put[s.name] for s in value.free_symbols if s.name in put})
            shown[name] = exact.tidy_angle(there) if there.has(sp.atan) else exact.tidy(there)
            matters |= symbol_names(value) if name in matters else set()
    # It rests on a letter that cannot be positive there, as one would take it to be.
    used = _used(results, outcome) & (matters | {*_signed(outcome, witness)})
    return {name: exact.sympy_text(shown[name]) for name in sorted(shown) if name in used}


def _number(value: sp.Expr | Fraction) -> sp.Expr:
    """The value of a letter at a point as a SymPy number; a root without a formula in figures."""
    if isinstance(value, sp.Expr):
        return sp.N(value, 30) if value.has(sp.CRootOf) else value
    fraction = Fraction(value)
    return sp.Rational(fraction.numerator, fraction.denominator)


def _complete(matters: set[str], branch: Branch) -> None:
    """Raises MissingError where a claim rests on what the statement leaves open."""
    phrases = branch.letters.phrases if isinstance(branch.letters, Letters) else {}
    open_ = sorted(name for name in matters if name.startswith("_"))
    if open_:
        raise missing.needs("this claim", (phrases.get(name, name.lstrip("_")) for name in open_))


def _hidden_roles(branch: Branch) -> Mapping[str, Role]:
    return branch.letters.hidden_roles if isinstance(branch.letters, Letters) else {}


def _matters(claim: Said, formula: Formula) -> set[str]:
    """The letters and hidden unknowns on which a claim depends, with those that it names."""
    names: set[str] = set()
    for tree in trees_of_relation(claim):
        names |= letters(tree)
    for relation in relations(formula):
        names |= _deciding(relation.value)
    return names


def _deciding(value: sp.Expr) -> frozenset[str]:
    """The letters on which it depends whether a value is 0, or which sign it has."""
    if sp.count_ops(value) > LONG:
        return symbol_names(value)
    parts = [
        factor for side in sp.fraction(sp.factor(neat(value))) for factor in sp.Mul.make_args(side)
    ]
    return symbol_names(*(part for part in parts if not (part.is_positive or part.is_negative)))


def _used(results: Results, outcome: Outcome) -> set[str]:
    """The letters of the statement."""
    used: set[str] = set()
    for tree in trees(results.problem):
        used |= letters(tree)
    if any(isinstance(s, Impact) and s.e is None for _, s in results.problem.steps()):
        used.add("e")
    return used - set(outcome.setting.lets)


def _leading(tree: Expression) -> Fraction:
    value = sp.sympify(evaluate(tree, lambda name: sp.Symbol(name, positive=True)), strict=True)
    if any(isinstance(node, Degrees) for node in walk(tree)):
        value = value * 180 / sp.pi  # an angle is printed in degrees
    coefficient, _ = value.as_coeff_Mul()
    if not coefficient.is_Rational or coefficient == 0:
        raise UnsupportedError("a rounded result is a number, perhaps times letters")
    return Fraction(int(coefficient.p), int(coefficient.q))


def _show_set_or_extremum(results: Results, step: Show, now: int, line: int | None) -> ItemResult:
    """``show range of e: …`` and ``show maximum of Q over X = …``."""
    subject = step.subject
    assert subject is not None
    assert isinstance(step.relation, Compare)
    result = results.item_result(subject, now, step.in_terms_of)
    if result.error is not None:
        raise result.error
    if isinstance(subject, Range) and step.in_terms_of is None:
        claimed_in = set[str]().union(*map(letters, step.relation.operands))
        in_them = tuple(sorted(claimed_in - letters(subject.expression)))
        if in_them and not _is_in(result, claimed_in):
            # A claim whose ends are in some letters is for each of their values, and no others.
            return _show_set_or_extremum(results, replace(step, in_terms_of=in_them), now, line)
    roles = results.desk.settle(step.in_terms_of, subject).roles
    letters_ = Letters(roles)
    evaluator = Evaluator(SYMBOLIC, letters_.letter)
    if isinstance(subject, Extremum):
        claimed = evaluator.scalar(step.relation.operands[-1])
        verdicts = [same_value(claimed, answer.value, roles) for answer in result.answers]
        if len(verdicts) > 1 and not all(verdicts):
            raise UnsupportedError(
                f"the {subject.kind} has another form for other data: {result.answers[0].display}; "
                "give bounds for these, in a part for each form"
            )
        return _compared(step, line, result, verdicts[0])
    assert isinstance(subject, Range)
    claimed = claimed_set(step.relation, subject, evaluator)
    (first, *more) = [answer.value for answer in result.answers]
    ok = same_set(claimed, first, roles)
    if more:  # its form depends on the data: one without max and min is not that of all
        ok = None if claimed.has(sp.Max, sp.Min) else False
    return _compared(step, line, result, ok)


def _is_in(result: ItemResult, names: set[str]) -> bool:
    """Whether a range has no other letters in it."""
    return all(
        symbol_names(answer.value) <= names
        for answer in result.answers
        if isinstance(answer.value, sp.Set)
    )


def _compared(step: Show, line: int | None, result: ItemResult, ok: bool | None) -> ItemResult:
    """A claim beside the result: where the claim is false, the result is its answer."""
    if result.proof == "undecided" or ok is None:
        return ItemResult(step, line, step.text, "show", proof="undecided")
    true = () if ok else result.answers
    return ItemResult(step, line, step.text, "show", true, holds=ok, proof=result.proof)
