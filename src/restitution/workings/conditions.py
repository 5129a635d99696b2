"""Under which conditions answers hold, as they are said below the lines in which items end."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from restitution.components.letters import protected_letters
from restitution.components.models import Model
from restitution.components.telling import model
from restitution.explaining.derivation import Derivation, Meaning
from restitution.explaining.saying import Sentence, say
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.oracle import BeyondError, Formula, Oracle
from restitution.oracle import Relation as Claim
from restitution.problem import Find, Given, Range, Value
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solving.letters import roles
from restitution.solving.solution import Answer, ItemResult, PartSolution, Solution


def conditions_of(solution: Solution, derivation: Derivation) -> dict[int, Sentence]:
    """The conditions of answers, by the numbers of the lines below which they are said."""
    sentences: dict[int, Sentence] = {}
    subjects = _subjects(derivation)
    for label, part in solution.parts.items():
        names = [each for each, own in derivation.asked.items() if own == label]
        for name, item in zip(names, part.items, strict=True):
            ends = [each.line for each in derivation.items if each.item == name]
            answers = item.distinct
            by_case = isinstance(item.item, Range) and len(answers) > 1
            if by_case or not ends or all(each.condition_layout is None for each in answers):
                continue
            if _is_asked(solution, part, item) or _speaks_of_others(solution, item, answers):
                continue
            if _is_of_itself(item, answers):
                continue
            alike = len({each.condition for each in answers}) == 1
            if not alike and len(answers) != len(ends):
                continue
            pairs = [(ends[-1], answers[0])] if alike else zip(ends, answers, strict=True)
            for line, answer in pairs:
                sentence = _sentence(solution, part, answer, subjects)
                if sentence is not None:
                    sentences[line] = sentence
    return sentences


def _is_asked(solution: Solution, part: PartSolution, item: ItemResult) -> bool:
    """Whether a condition is a range for which the question asks: that item derives it.

    It may be asked in the part, or in a later one in which nothing else is given.
    """
    own = item.item.expression if isinstance(item.item, Value) else None
    tied = frozenset() if own is None else letters(own)
    conditions = {each for answer in item.distinct for each in answer.condition}
    named = [set(_names_in(each)) for each in conditions]
    for other in _parts_with_its_facts(solution, part):
        for each in other.items:
            if not isinstance(each.item, Range) or each.error is not None:
                continue
            names = letters(each.item.expression)
            alone = isinstance(each.item.expression, Letter)
            if has_quantity(each.item.expression) or (alone and len(conditions) > 1):
                continue
            if all(names & own for own in named) or (names and names < tied):
                return True
    return False


def _parts_with_its_facts(solution: Solution, part: PartSolution) -> list[PartSolution]:
    """A part, and those after it in which the same is given."""
    solved = list(solution.parts.values())
    if _has_facts(part):
        return [part]
    later = solved[solved.index(part) + 1 :]
    return [part, *(each for each in later if not _has_facts(each))]


def _has_facts(part: PartSolution) -> bool:
    """Whether a lettered part gives facts of its own."""
    given = any(isinstance(step, Given) for step in part.part.steps)
    return part.part.label is not None and given


def _is_of_itself(item: ItemResult, answers: Sequence[Answer]) -> bool:
    """Whether a condition is that the letter that is asked has an admissible value."""
    own = item.item.expression if isinstance(item.item, Value) else None
    return isinstance(own, Letter) and any(
        lay.from_sympy(sp.Symbol(own.name)) in _sides(answer.condition_layout) for answer in answers
    )


def _sides(condition: Layout | None) -> list[Layout]:
    """What stands between the signs of a condition."""
    match condition:
        case lay.Phrase(items):
            return [side for each in items for side in _sides(each)]
        case lay.Relation(operands):
            return list(operands)
    return []


def _names_in(text: str) -> list[str]:
    """The letters of a condition, which is in the language of statements."""
    return "".join(c if c.isalnum() or c == "_" else " " for c in text).split()


def _speaks_of_others(solution: Solution, item: ItemResult, answers: Sequence[Answer]) -> bool:
    """Whether a condition has letters that an answer must not have.

    Such a condition is one of the data: an answer that is free of these letters needs none.
    """
    asked = next(
        (
            step.in_terms_of
            for _, step in solution.problem.steps()
            if isinstance(step, Find) and any(each is item.item for each in step.items)
        ),
        None,
    )
    if asked is None:
        return False
    names = {each for answer in answers for text in answer.condition for each in _names_in(text)}
    known = set(roles(solution.problem))
    own = item.item.expression if isinstance(item.item, Value) else None
    return bool(names & known - {*asked, own.name if isinstance(own, Letter) else ""})


def _subjects(derivation: Derivation) -> set[str]:
    """The letters of which some line says the value."""
    return {
        link.left.name
        for line in derivation.lines
        if not isinstance(line.relation, Meaning)
        for links in line.relation.options
        for link in links
        if isinstance(link.left, Letter)
    }


def _sentence(
    solution: Solution, part: PartSolution, answer: Answer, subjects: Collection[str]
) -> Sentence | None:
    condition = answer.condition_layout
    if condition is None:
        return None
    branch = next(each for each in part.branches if each.number == answer.solution)
    protected = protected_letters(part.part)
    own = model(solution.problem, part.part, branch, part.roles, protected)
    unknowns = {each for each in own.final if each.name in subjects}
    reasons = coefficients_that_bind(own, unknowns)
    if reasons and condition not in reasons:
        return say("answer.only-as", reasons=reasons, condition=condition)
    return say("answer.only", condition=condition)


def coefficients_that_bind(model: Model, unknowns: Collection[sp.Symbol]) -> list[Layout]:
    """``e ≤ 1``: the bounds of coefficients that were found, if a solution's condition is theirs.

    Empty where it rests on anything else, or on a coefficient that is not yet known.
    """
    if model.branch.oracle is None:
        return []
    bounds: dict[tuple[sp.Symbol, bool], Formula] = {}
    for symbol, value in model.final.items():
        role = model.unknowns.roles.get(symbol.name)
        if role is None or role.kind != "restitution" or (role.low, role.high) != (0, 1):
            continue
        for upper, gap in ((False, value), (True, 1 - value)):
            claim = Claim(gap, ">=" if role.closed[upper] else ">")
            if not _follows(model.ground, claim):
                bounds[symbol, upper] = claim
    for bound in list(bounds):
        fewer = {key: claim for key, claim in bounds.items() if key != bound}
        if all(_follows(model.ground.with_facts(fewer.values()), x) for x in model.oracle.facts):
            bounds = fewer
    known = all(symbol in unknowns for symbol, _ in bounds)
    enough = model.ground.with_facts(bounds.values())
    if not bounds or not known or not all(_follows(enough, fact) for fact in model.oracle.facts):
        return []
    return [_coefficient_range(model, s, bounds) for s in dict.fromkeys(s for s, _ in bounds)]


def _follows(oracle: Oracle, claim: Formula) -> bool:
    try:
        return bool(oracle.decide(claim))
    except BeyondError:
        return False


def _coefficient_range(
    model: Model, symbol: sp.Symbol, bounds: Collection[tuple[sp.Symbol, bool]]
) -> Layout:
    """``0 ≤ e``, ``e ≤ 1`` or both at once."""
    at_low, at_high = (
        "≤" if closed else "<" for closed in model.unknowns.roles[symbol.name].closed
    )
    name, low, high = lay.from_sympy(symbol), lay.Number("0"), lay.Number("1")
    if (symbol, True) not in bounds:
        return lay.Relation((name, low), ("≥" if at_low == "≤" else ">",))
    if (symbol, False) not in bounds:
        return lay.Relation((name, high), (at_high,))
    return lay.Relation((low, name, high), (at_low, at_high))
