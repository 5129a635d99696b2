"""A solution to its explanation: part by part, branch by branch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from restitution.components import Model, model, protected_letters, rejected_values
from restitution.errors import MissingError, RestitutionError, TimeLimitError
from restitution.exact import tidy
from restitution.explain.asked import (
    coefficients_that_bind,
    explain_item,
    speaks_across,
    trees_of,
)
from restitution.explain.backwards import is_told_backwards, steps_backwards
from restitution.explain.derived import explanation_of
from restitution.explain.facts import fact_equations
from restitution.explain.geometry import to_be_found
from restitution.explain.marks import again, in_style, settled
from restitution.explain.quantities import inside
from restitution.explain.steps import Explanation, PartExplanation, Step
from restitution.explain.working import Working
from restitution.explaining.awarding import awarded
from restitution.explaining.derivation import Derivation, Meaning, Note
from restitution.explaining.follower import Complaint, follow
from restitution.explaining.marks import STYLES, Style
from restitution.explaining.printing import look
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Letter, Quantity, has_quantity, letters
from restitution.oracle import Oracle
from restitution.planning.desk import NotPlannedError
from restitution.planning.planner import plan, pruned
from restitution.problem import Part, Range, Value
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solve.forms import signed
from restitution.solve.letters import roles
from restitution.solve.solution import ItemResult, PartSolution, Solution
from restitution.solve.story import lets_of
from restitution.vector import Vector
from restitution.work import confirm, limited

# What algebra may raise on an expression of a form that was not foreseen.
_FAILURES = (
    RestitutionError,
    ArithmeticError,
    AssertionError,
    AttributeError,
    LookupError,
    NotImplementedError,
    RecursionError,
    StopIteration,
    TypeError,
    ValueError,
    sp.PolynomialError,
)

# Steps that need not be said again in a later part.
_ONCE = ("heading", "setting", "principle")

Carried = dict[str, tuple[str, sp.Expr]]


def explain(
    solution: Solution,
    part: str | None = None,
    time_limit: float | None = None,
    *,
    marks: Style = "fm1",
    route: int = 1,
    check: bool = False,
) -> Explanation:
    """The worked solution of a problem, or of the part with that label.

    ``marks`` is the style in which marks are given, or ``"none"``. Where a working is a derivation,
    ``route`` chooses among its ways to the answers, the best being 1, and ``check`` has every line
    followed exactly.

    It is whole, or there is none: after ``time_limit`` seconds (None is no limit; it holds in any
    thread) TimeLimitError is raised.

    Every line is checked by numbers that satisfy the facts before it is kept; one that fails is
    left out, and a warning says so. Items without an answer are told with their reason. Raises
    KeyError for a part that is not there, and ValueError for a style or a route that cannot be.
    """
    if marks not in STYLES:
        raise ValueError(f"there is no style of marks {marks!r}; styles: {', '.join(STYLES)}")
    if route < 1:
        raise ValueError(f"routes are counted from 1, not {route}")
    if part is not None and part not in solution.parts:
        known = ", ".join(str(label) for label in solution.parts)
        raise KeyError(f"there is no part {part!r}; parts: {known}")
    with limited(time_limit, error=None if time_limit is None else _too_late(time_limit)):
        derivation = _planned(solution, route)
        if derivation is None:
            explanation = in_style(_explained(solution, part), marks)
        else:
            explanation = _printed(solution, awarded(derivation, marks), part, check, marks)
        confirm()
    return explanation


def _too_late(seconds: float) -> TimeLimitError:
    return TimeLimitError(f"no working within the time limit of {seconds:g} s")


def _explained(solution: Solution, part: str | None, last: str | None = None) -> Explanation:
    """The working in the older way, of one part, or of all up to the last that is wanted."""
    carried: Carried = {}
    told: list[PartExplanation] = []
    warnings = list(solution.warnings)
    seen: set[Step] = set()
    for label, each in solution.parts.items():
        made, dropped = _part(solution, each, carried, seen)
        if part is None or label == part:
            told.append(made)
            warnings += [str(say("amiss.line", line=line)) for line in dropped]
        if last is not None and label == last:
            break
    return Explanation(solution.problem.title, tuple(told), tuple(warnings), solution)


def _planned(solution: Solution, route: int) -> Derivation | None:
    """The working as a derivation; None where no part has a plan for all of its items.

    A part without one has notes in its place.
    """
    several = len(solution.parts) > 1
    try:
        derivation = plan(solution, route, partial=several)
    except TimeLimitError:
        raise
    except (NotPlannedError, *_FAILURES):
        return None
    if not _unplanned(derivation):
        return derivation
    complaints = follow(derivation, Oracle(roles(solution.problem)))
    for part in {_part_of(derivation, each) for each in complaints}:
        derivation = _without(derivation, part)
    return None if _unplanned(derivation) >= set(derivation.asked.values()) else derivation


def _part_of(derivation: Derivation, complaint: Complaint) -> str | None:
    """The part of which a complaint is."""
    line = None if complaint.line is None else derivation.line(complaint.line)
    return None if line is None else derivation.asked.get(line.item or "")


def _without(derivation: Derivation, part: str | None) -> Derivation:
    """The same working without the lines of a part, which has notes in their place."""
    items = [each for each, own in derivation.asked.items() if own == part]
    notes = tuple(
        Note(each, "unwritten", n, part) for n, each in enumerate(derivation.asked) if each in items
    )
    return pruned(
        replace(
            derivation,
            items=tuple(each for each in derivation.items if each.part != part),
            notes=(*(each for each in derivation.notes if each.part != part), *notes),
        )
    )


def _unplanned(derivation: Derivation) -> set[str | None]:
    """The parts of which some item has no plan."""
    return {each.part for each in derivation.notes if each.kind == "unwritten"}


def _printed(
    solution: Solution, derivation: Derivation, part: str | None, check: bool, marks: Style
) -> Explanation:
    """A derivation in steps and rows; a part without a plan for all of its items the older way."""
    older = _unplanned(derivation) & ({part} if part is not None else solution.parts.keys())
    others: dict[str | None, PartExplanation] = {}
    if older:
        last = max(older, key=list(solution.parts).index)
        others = {e.label: e for e in in_style(_explained(solution, None, last), marks).parts}
    whole = explanation_of(
        derivation, solution.problem, conditions=_conditions(solution, derivation)
    )
    steps = {each.label: each.steps for each in whole.parts}
    parts = tuple(
        others[label]
        if label in older
        else PartExplanation(
            label,
            tuple(_question(item) for item in each.items),
            steps.get(label, ()),
            tuple(_answers(item) for item in each.items),
            derivation,
        )
        for label, each in solution.parts.items()
        if part is None or label == part
    )
    warnings = list(solution.warnings)
    followed: bool | None = None
    if check:
        complaints = follow(derivation, Oracle(roles(solution.problem)))
        warnings += [str(say("amiss.complaint", complaint=str(each))) for each in complaints]
        followed = not complaints
    return Explanation(solution.problem.title, parts, tuple(warnings), solution, followed)


def _conditions(solution: Solution, derivation: Derivation) -> dict[int, Sentence]:
    """Under which conditions the answers hold, by the numbers of their lines."""
    told: dict[int, Sentence] = {}
    subjects = {
        link.left.name
        for line in derivation.lines
        if not isinstance(line.relation, Meaning)
        for links in line.relation.options
        for link in links
        if isinstance(link.left, Letter)
    }
    for label, part in solution.parts.items():
        names = list(dict.fromkeys(e.item for e in derivation.items if e.part == label))
        for name, item in zip(names, part.items, strict=False):
            ends = [each.line for each in derivation.items if each.item == name]
            answers = item.distinct
            by_case = isinstance(item.item, Range) and len(answers) > 1
            if by_case or all(each.condition_layout is None for each in answers):
                continue
            alike = len({each.condition for each in answers}) == 1
            if not alike and len(answers) != len(ends):
                continue
            pairs = [(ends[-1], answers[0])] if alike else zip(ends, answers, strict=True)
            for line, answer in pairs:
                condition = answer.condition_layout
                if condition is None:
                    continue
                own = next(e for e in _models(solution, part) if e.branch.number == answer.solution)
                found = {each for each in own.final if each.name in subjects}
                reasons = coefficients_that_bind(own, found)
                told[line] = (
                    say("answer.only-as", reasons=reasons, condition=condition)
                    if reasons and condition not in reasons
                    else say("answer.only", condition=condition)
                )
    return told


def _part(
    solution: Solution, part: PartSolution, carried: Carried, seen: set[Step]
) -> tuple[PartExplanation, list[str]]:
    asked = tuple(_question(item) for item in part.items)
    answers = tuple(_answers(item) for item in part.items)
    dropped: list[str] = []
    untold = [isinstance(each.error, MissingError) for each in part.items]
    if not part.branches or (untold and all(untold)):
        # Where too little is told there is nothing to work out, though much could be written.
        steps = [
            Step("note", sentences=(say("answer.none", item=item.text, reason=item.error.message),))
            for item in part.items
            if item.error is not None
        ]
        return PartExplanation(part.part.label, asked, tuple(steps), answers), dropped
    if is_told_backwards(part):
        return PartExplanation(
            part.part.label, asked, steps_backwards(part, answers), answers
        ), dropped
    made = workings(solution, part, carried)
    for work in made:
        dropped += [line for line in work.dropped if line not in dropped]
    steps = _merged(made)
    fresh = settled([step for step in steps if step.kind not in _ONCE or step not in seen])
    seen.update(steps)
    _carry(part.part, made, carried)
    return PartExplanation(part.part.label, asked, fresh, answers), dropped


def workings(
    solution: Solution, part: PartSolution, carried: Carried | None = None
) -> list[Working]:
    """The working of a part, one for each of its solutions; ``carried`` are earlier results."""
    models = _models(solution, part)
    return [
        _worked(solution, part, told, [m.final for m in models if m is not told], carried or {})
        for told in models
    ]


def _question(item: ItemResult) -> str:
    return item.text


def _answers(item: ItemResult) -> str:
    if item.error is not None:
        return str(say("answer.reason", item=item.text, reason=item.error.message))
    if item.undecided:
        return str(say("answer.undecided", item=item.text))
    displays = [each.display for each in item.distinct]
    if item.holds is not None:
        outcome = say("answer.shown" if item.holds else "answer.false")
        return str(say("answer.outcome", item=item.text, outcomes=[outcome, *displays]))
    return str(say("answer.value", item=item.text, values=displays))


def _models(solution: Solution, part: PartSolution) -> list[Model]:
    protected = protected_letters(part.part)
    made = []
    for branch in part.branches:
        told = model(solution.problem, part.part, branch, part.roles, protected)
        work = Working(told)
        turned = frozenset(n for n, frame in told.frames.items() if to_be_found(work, frame))
        if turned:
            told = model(solution.problem, part.part, branch, part.roles, protected, turned)
        made.append(_without_bars(told))
    return made


def _without_bars(told: Model) -> Model:
    """Sizes |x| in the values without bars, by the signs that they have in the story."""
    values = {
        symbol: tidy(signed(value, told.witnesses(value))) if value.has(sp.Abs) else value
        for symbol, value in told.final.items()
    }
    plain = replace(told, final=values)
    plain.story = told.story
    return plain


def _worked(
    solution: Solution,
    part: PartSolution,
    told: Model,
    others: Sequence[Mapping[sp.Symbol, sp.Expr]],
    carried: Carried,
) -> Working:
    problem = solution.problem
    rejected = [(each, rejected_values(told, each.values)) for each in part.rejected]
    work = Working(told, alternatives=others, rejected=rejected)
    work.across = speaks_across(problem, part.part)
    work.asked = _asked(work, part)
    protected = frozenset(set(lets_of(problem, part.part)) & protected_letters(part.part))
    work.facts = fact_equations(work, problem, part.part, protected)
    _silent_letters(work)
    _take_over(work, carried)
    listed = list(problem.asked(part.part))
    for item, now in listed:
        for tree in trees_of(item):
            try:
                work.wanted |= inside(work, tree, now)
            except (RestitutionError, ArithmeticError, TypeError, ValueError, AssertionError):
                continue
    for index, ((_, now), result) in enumerate(zip(listed, part.items, strict=False)):
        work.item = index
        try:
            explain_item(work, result, now, told.branch.number)
        except _FAILURES as error:
            # No working is better than none of the answers.
            why = f" ({error.message})" if isinstance(error, RestitutionError) else ""
            work.dropped.append(f"{result.text}{why}")
            work.write("note", sentences=(say("answer.whole", answer=_answers(result)),))
        work.answered |= _given_as_answer(work, result, now)
    return work


def _asked(work: Working, part: PartSolution) -> set[sp.Symbol]:
    """The letters that are asked for by themselves."""
    return {
        work.model.unknowns.letter(name)
        for result in part.items
        if isinstance(result.item, Value) and not has_quantity(result.item.expression)
        for name in letters(result.item.expression)
    }


def _given_as_answer(work: Working, result: ItemResult, now: int) -> set[sp.Symbol]:
    """The unknowns that an answer shows to whoever marks it."""
    item = result.item
    if not isinstance(item, Value) or result.error is not None:
        return set()
    tree = item.expression
    if has_quantity(tree) and not (
        isinstance(tree, Quantity) and tree.kind in ("velocity", "speed", "along", "across")
    ):
        return set()
    value = work.value(tree, now)
    parts = tuple(value) if isinstance(value, Vector) else (value,)
    return {
        symbol
        for each in parts
        if not isinstance(each, Angle)
        for symbol in sp.sympify(each, strict=True).free_symbols
        if symbol in work.model.final
    }


def _silent_letters(work: Working) -> None:
    """Letters that the data simply name (``given e = 1/2``) are known from the start."""
    for symbol, value in list(work.model.final.items()):
        lone = [
            each
            for each in work.facts
            if each.kind == "datum"
            and sp.sympify(each.residual, strict=True).free_symbols >= {symbol}
            and each.step() is None
        ]
        if lone and symbol.name in work.model.unknowns.roles:
            work.determine(symbol, value)
            work.silent.add(symbol)


def _take_over(work: Working, carried: Carried) -> None:
    names = {c.symbol.name: c.symbol for c in work.model.components.values()}
    names.update({s.name: s for s in work.model.final if s.name not in names})
    components = {c.symbol.name for c in work.model.components.values()}
    # What rests on a letter that is data in this part, and was found before, is of no use here.
    stale = {
        label
        for name, (label, _) in carried.items()
        if name not in names and name in work.model.unknowns.roles
    }
    for name, (label, value) in carried.items():
        symbol = names.get(name)
        if symbol is None and name in work.model.unknowns.roles:
            # Found before and data now: this may fix a letter that was data before.
            sought = {s.name for s in work.model.final} & work.model.unknowns.roles.keys()
            if sought & {s.name for s in value.free_symbols}:
                symbol = work.model.unknowns.letter(name)
        if symbol is None or (name in components and label in stale):
            continue
        renamed = value.xreplace(
            {s: work.model.unknowns.letter(s.name) for s in value.free_symbols}
        )
        if work.model.sign(renamed - symbol) == 0 and renamed.free_symbols <= _letters(work):
            try:
                work.model.number(renamed)
            except (KeyError, ArithmeticError):
                continue
            work.carried[symbol] = (label, renamed)


def _letters(work: Working) -> set[sp.Symbol]:
    return {work.model.unknowns.letter(name) for name in work.model.unknowns.roles}


def _carry(part: Part, workings: Sequence[Working], carried: Carried) -> None:
    if len(workings) != 1:
        return
    (work,) = workings
    given = {s for each in work.facts if each.kind == "datum" for s in each.residual.free_symbols}
    for symbol in list(work.known):
        if symbol in given or symbol in work.silent or symbol.name not in work.model.sample:
            continue
        value = work.model.final[symbol]  # as it was printed
        if not work.open(value) and symbol.name not in carried:
            carried[symbol.name] = (part.label or "", value)


def _merged(workings: Sequence[Working]) -> list[Step]:
    """The working of all solutions: what is common once, then each by itself."""
    if len(workings) == 1:
        return workings[0].steps
    common: list[Step] = []
    lists = [work.steps for work in workings]
    while all(len(each) > len(common) for each in lists) and all(
        each[len(common)] == lists[0][len(common)] for each in lists
    ):
        common.append(lists[0][len(common)])
    out = list(common)
    for work, steps in zip(workings, lists, strict=True):
        rest = steps[len(common) :]
        if not rest:
            continue
        out.append(Step("heading", sentences=(_case(work, workings, common),)))
        out += rest if work is workings[0] else again(rest)
    return out


def _case(work: Working, workings: Sequence[Working], common: Sequence[Step]) -> Sentence:
    """``If α = 45°:``: what has just been found to have several values, or the letters."""
    values: list[Layout] = []
    parting = {row.operands[0] for step in common[-1:] for row in step.rows[-1:]}
    just_found = [s for s in work.model.final if look(s) in parting]
    for symbol, value in work.model.final.items():
        if just_found and symbol not in just_found:
            continue
        if not just_found and symbol.name not in work.model.unknowns.roles:
            continue
        if all(other.model.final.get(symbol) == value for other in workings):
            continue
        row = work.value_row(symbol, value=value)
        operands = tuple(o for o in row.operands if o is not None)
        values.append(lay.Relation(operands[:2], ("=",)))
    if not values:
        return say("heading.solution", number=work.model.branch.number)
    return say("heading.case", values=values)
