"""Under which conditions answers hold, as they are said below the lines in which items end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from functools import reduce

import sympy as sp

from restitution.components.letters import protected_letters
from restitution.components.models import Model
from restitution.components.telling import model
from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.data.unused import first_lines_of_letters, lines_under
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_quantity,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.oracle import BeyondError, Formula, Oracle, compared
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import ACUTE, Role
from restitution.planning.inequalities.forms_of_ranges import relation_of_condition
from restitution.planning.inequalities.ranges import general_answer
from restitution.planning.writing.forms import ONE
from restitution.problem import Extremum, Find, Given, Impact, Range, Value, trees_of_step
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solving.equations.solution import Answer, ItemResult, PartSolution, Solution
from restitution.solving.ranges.validity import always_exist
from restitution.solving.story.letters import roles
from restitution.workings.excluded_ends import excluded_end
from restitution.workings.naming.in_force import inequalities
from restitution.workings.naming.measured import scalar_worth
from restitution.workings.reasons.binding_bounds import follows, motions, reasons_that_bind

_TANGENTS = ("tan", "tan-direction")


def conditions_of(solution: Solution, derivation: Derivation) -> dict[int, Sentence]:
    """The conditions of answers, by the numbers of the lines below which they are said."""
    sentences: dict[int, Sentence] = {}
    subjects, squares = first_lines_of_letters(derivation), _squares_of_ratios(derivation)
    for label, part in solution.parts.items():
        names = [item for item, own in derivation.asked.items() if own == label]
        for name, item in zip(names, part.items, strict=True):
            ends = [item.line for item in derivation.items if item.item == name]
            answers = item.distinct
            by_case = isinstance(item.item, Range) and len(answers) > 1
            general = general_answer(item) if by_case else None
            if general is not None and ends:
                sentences[ends[-1]] = _by_case(item, general)
            if by_case or not ends or all(answer.condition_layout is None for answer in answers):
                continue
            if _is_asked(solution, part, item) or _speaks_of_others(solution, item, answers):
                continue
            if _are_given(solution, derivation, label, ends[0], answers):
                continue
            if _are_of_places(solution, part, answers):
                continue
            if _is_of_itself(item, answers) or _is_derived(derivation, name, ends, answers):
                continue
            alike = len({answer.condition for answer in answers}) == 1
            if not alike and len(ends) == 1 and isinstance(item.item, Value):
                above = {subject for subject, first in subjects.items() if first <= ends[0]}
                known = Known(subjects.keys(), above, squares)
                sentences[ends[0]] = _by_values(solution, part, item, answers, known)
                continue
            if not alike and len(answers) != len(ends):
                continue
            pairs = [(ends[-1], answers[0])] if alike else zip(ends, answers, strict=True)
            for line, answer in pairs:
                above = {subject for subject, first in subjects.items() if first <= line}
                bounds = _bounds_of_squares(derivation, line)
                known = Known(subjects.keys(), above, squares, bounds)
                sentence = _sentence(solution, part, item, answer, known)
                if sentence is not None and not _is_plain(derivation, line, answer, sentence):
                    sentences[line] = sentence
    return sentences


def _is_plain(derivation: Derivation, last: int, answer: Answer, sentence: Sentence) -> bool:
    """Whether a condition is that of a letter by which lines divide.

    ``tan²α = 1/e``, from which a line goes on, has no value for e = 0; and where a sphere would be
    at rest at the end, the tangent of its direction is a quotient in which that is seen.
    """
    reasons = dict(sentence.slots).get("reasons", ())
    if sentence.id != "answer.only-as" or not isinstance(reasons, tuple):
        return False
    why = {reason.id if isinstance(reason, Sentence) else "" for reason in reasons}
    moving = why == {"answer.moving"}
    if not moving and why != {"derived.acute"}:
        return False
    own = derivation.line(last)
    for ref in lines_under(derivation, last):
        line = derivation.line(ref)
        if own is None or line is None or not isinstance(line.relation, Relation):
            continue
        tangent = moving and line.move.record in _TANGENTS
        if line.item == own.item and not tangent:
            continue
        for link in (link for option in line.relation.options for link in option):
            if link.sign != "=" or has_quantity(link.right):
                continue
            for tree in (link.right, *(_divisors_of(link.right) if tangent else ())):
                if any(
                    answer.condition == (f"0 < {name}",) and _is_infinite_without(tree, name)
                    for name in letters(tree)
                ):
                    return True
    return False


def _divisors_of(tree: Expression) -> Iterator[Expression]:
    """One over each divisor in a tree, before anything cancels."""
    for node in walk(tree):
        if is_binary(node, "/"):
            yield Binary("/", ONE, node.right)


def _is_infinite_without(tree: Expression, name: str) -> bool:
    """Whether a value has a divisor that is zero where a letter is."""
    value = scalar_worth(tree)
    if value is None:
        return False
    divisor = sp.fraction(sp.together(value))[1]
    return bool(divisor.subs(sp.Symbol(name, positive=True), 0) == 0)


def _are_given(
    solution: Solution,
    derivation: Derivation,
    label: str | None,
    last: int,
    answers: Sequence[Answer],
) -> bool:
    """Whether the conditions of answers are given, or follow from results above.

    What the statement gives holds in the part or for all. From *k = 1/e*, which was shown, it
    follows that *k ≥ 1*.
    """
    given = (
        *inequalities(derivation, label, lambda side: evaluate(side, sp.Symbol)),
        *_results_above(derivation, last),
    )
    return bool(given) and all(
        _is_alike(Oracle(roles(solution.problem), given), answer, ())
        for answer in answers
        if answer.condition
    )


def _results_above(derivation: Derivation, last: int) -> Iterator[Formula]:
    """The letters that items above a line have found, or shown, in others."""
    for end in derivation.items:
        line = derivation.line(end.line)
        if end.line >= last or line is None or not isinstance(line.relation, Relation):
            continue
        match line.relation.options:
            case (((Link(Letter(), "=", right)),),) if not has_quantity(right):
                (link,) = line.relation.only
                yield compared(evaluate(link.left, sp.Symbol), "=", evaluate(link.right, sp.Symbol))


def _are_of_places(solution: Solution, part: PartSolution, answers: Sequence[Answer]) -> bool:
    """Whether conditions are of lengths in the places alone, which the answers do not have.

    A sphere that starts between two walls has ``h <= d``, whatever is asked.
    """
    problem = solution.problem
    places: list[object] = [sphere.position for sphere in problem.spheres]
    for wall in problem.walls:
        places += [wall.through, wall.start, wall.end]
    own = {name for tree in places if isinstance(tree, Expression) for name in letters(tree)}
    steps = (*part.part.steps, *(e for e in problem.parts[0].steps if isinstance(e, Given)))
    asked = {name for step in steps for tree in trees_of_step(step) for name in letters(tree)}
    asked |= {name for answer in answers for name in answer.letters}
    conditions = {
        word for answer in answers for text in answer.condition for word in _names_in(text)
    }
    named = {word for word in conditions if not word.isdigit()}
    return bool(named) and named <= own - asked


def is_same(one: Sentence, other: Sentence) -> bool:
    """Whether two sentences say one condition, perhaps with more or less of its reasons."""
    kinds = ("answer.only", "answer.only-as", "answer.only-at", "answer.only-leaving")
    conditions = [dict(sentence.slots).get("condition") for sentence in (one, other)]
    return one == other or (
        one.id in kinds and other.id in kinds and conditions[0] == conditions[1] is not None
    )


def _is_asked(solution: Solution, part: PartSolution, item: ItemResult) -> bool:
    """Whether a condition is a range for which the question asks: that item derives it.

    It may be asked in the part, or in a later one in which nothing else is given.
    """
    own = item.item.expression if isinstance(item.item, Value) else None
    tied = frozenset() if own is None else letters(own)
    conditions = {condition for answer in item.distinct for condition in answer.condition}
    named = [set(_names_in(condition)) for condition in conditions]
    for other in _parts_with_its_facts(solution, part):
        for result in other.items:
            if not isinstance(result.item, Range) or result.error is not None:
                continue
            names = letters(result.item.expression)
            alone = isinstance(result.item.expression, Letter)
            if has_quantity(result.item.expression) or (alone and len(conditions) > 1):
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
    return [part, *(part for part in later if not _has_facts(part))]


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


def _is_derived(
    derivation: Derivation, item: str, ends: Sequence[int], answers: Sequence[Answer]
) -> bool:
    """Whether a line below, of what is to be shown, tells from a sign what the condition does."""
    names = [set(_names_in(text)) for answer in answers for text in answer.condition]
    shown = {item.item for item in derivation.items if item.shown}
    for line in derivation.lines:
        if line.item in shown - {item} and line.move.id == "sign" and line.number > max(ends):
            match line.relation:
                case Relation(((Link(left, ">" | "<", right),),)) if is_zero(right):
                    if len(names) == 1 and letters(left) == names[0]:
                        return True
    return False


def _sides(condition: Layout | None) -> list[Layout]:
    """What stands between the signs of a condition."""
    match condition:
        case lay.Phrase(items):
            return [side for item in items for side in _sides(item)]
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
            if isinstance(step, Find) and any(other is item.item for other in step.items)
        ),
        None,
    )
    if asked is None:
        return False
    names = {name for answer in answers for text in answer.condition for name in _names_in(text)}
    known = set(roles(solution.problem))
    own = item.item.expression if isinstance(item.item, Value) else None
    return bool(names & known - {*asked, own.name if isinstance(own, Letter) else ""})


@dataclass(frozen=True)
class Known:
    """The letters whose values a working says: anywhere, and above a condition.

    ``squares`` are those of ratios of angles, between their ends; ``bounds`` are what squares of
    ratios must be that lines above give, each with the claims that it makes of letters.
    """

    anywhere: AbstractSet[str]
    above: AbstractSet[str]
    squares: Mapping[str, Layout]
    bounds: Sequence[tuple[Layout, tuple[Formula, ...]]] = ()


def _squares_of_ratios(derivation: Derivation) -> dict[str, Layout]:
    """``0 < sin²α = (u² − v²)/((1 − e²)u²) < 1``, of angles whose sine or cosine is a root."""
    squares = filter(None, map(_square_of_a_ratio, derivation.lines))
    return {name: layout for name, layout, _ in squares}


def _square_of_a_ratio(line: Line) -> tuple[str, Layout, sp.Expr] | None:
    """The angle whose sine or cosine a line gives as a root of letters, with its square.

    That stands between its ends, and as a value. None of another line.
    """
    match line.relation:
        case Relation(((Link(Apply("sin" | "cos" as ratio, Letter(name)), "=", right),),)):
            value = in_letters(right, positive=True)
        case _:
            return None
    roots = (power for power in value.atoms(sp.Pow) if not power.exp.is_Integer)
    if not any(root.free_symbols for root in roots):
        return None
    whole = (sp.sin if ratio == "sin" else sp.cos)(sp.Symbol(name)) ** 2
    sides = (lay.Number("0"), lay.from_sympy(whole), lay.from_sympy(value**2), lay.Number("1"))
    return name, lay.Relation(sides, ("<", "=", "<")), value**2


def _bounds_of_squares(
    derivation: Derivation, last: int
) -> list[tuple[Layout, tuple[Formula, ...]]]:
    """``tan²α > 0`` and ``0 < sin²α = … < 1`` of the lines as far as one, with what that claims."""
    bounds: list[tuple[Layout, tuple[Formula, ...]]] = []
    for line in derivation.lines[:last]:
        match line.relation:
            case Relation(
                ((Link(Binary("^", Apply("tan", Letter()), Number()) as left, "=", right),),)
            ) if not has_quantity(right):
                positive = lay.Relation((lay.from_tree(left), lay.Number("0")), (">",))
                bounds.append((positive, (Claim(in_letters(right, positive=True), ">"),)))
            case _ if (own := _square_of_a_ratio(line)) is not None:
                _, layout, value = own
                bounds.append((layout, (Claim(value, ">"), Claim(1 - value, ">"))))
    return bounds


def _bound_alike(
    solution: Solution,
    answer: Answer,
    bounds: Sequence[tuple[Layout, tuple[Formula, ...]]],
) -> tuple[Layout, ...]:
    """``tan²α > 0``, where that is just what a condition says; nothing of another condition."""
    oracle = Oracle(roles(solution.problem))
    for layout, claims in bounds:
        if _is_alike(oracle, answer, claims):
            return (layout,)
    return ()


def _motion_alike(model: Model, answer: Answer) -> tuple[Sentence, ...]:
    """That a body has to move towards what it hits, or at the end, if a condition is just that."""
    for happening in model.branch.story.happenings:
        if isinstance(happening.step, Impact) and happening.closing is not None:
            closing = Claim(tidy(model.in_data(happening.closing)), ">")
            if _is_alike(model.ground, answer, (closing,), model):
                one, two = happening.step.first, happening.step.second
                return (say("answer.approaching", one=one, two=two),)
    for claim, (body, _) in motions(model):
        if _is_alike(model.ground, answer, (claim,), model):
            return (say("answer.moving", body=body.name),)
    return ()


def _is_alike(
    oracle: Oracle, answer: Answer, claims: Sequence[Formula], known: Model | None = None
) -> bool:
    """Whether claims of letters are just what the condition of an answer says.

    Of a ``known`` model the values of letters that were found are put into the condition.
    """
    try:
        conditions = [
            compared(
                _side_of_a_condition(e.left, known), e.sign, _side_of_a_condition(e.right, known)
            )
            for text in answer.condition
            for e in relation_of_condition(text).only
        ]
    except (RestitutionError, ValueError):
        return False
    both, other = oracle.with_facts(conditions), oracle.with_facts(claims)
    return bool(conditions) and all(
        (*(follows(both, e) for e in claims), *(follows(other, e) for e in conditions))
    )


def _side_of_a_condition(side: Expression, known: Model | None) -> sp.Expr:
    """A side in letters, or in those in which a model has its values."""
    if known is None:
        return evaluate(side, sp.Symbol)
    return tidy(known.in_data(evaluate(side, known.unknowns.letter)))


def _ends_meet(solution: Solution, values: sp.Set) -> bool:
    """Whether the ends of a range are one where a coefficient is 0 or 1: that value may be had."""
    if not isinstance(values, sp.Interval):
        return False
    known = roles(solution.problem)
    gap = values.end - values.start
    return any(
        sp.simplify(gap.subs(symbol, end)) == 0
        for symbol in gap.free_symbols
        if symbol.name in known and known[symbol.name].kind == "restitution"
        for end in (0, 1)
    )


def _sentence(
    solution: Solution,
    part: PartSolution,
    item: ItemResult,
    answer: Answer,
    known: Known,
) -> Sentence | None:
    condition = answer.condition_layout
    if condition is None:
        return None
    if isinstance(item.item, Range):
        asked = item.item.expression
        exist = isinstance(answer.value, sp.Set) and always_exist(
            answer.value, Oracle(roles(solution.problem))
        )
        if not isinstance(asked, Letter) or not exist or _ends_meet(solution, answer.value):
            return _at_the_end(solution, part, item, answer)
        letter = lay.from_sympy(sp.Symbol(asked.name))
        return say("answer.only-range", condition=condition, letter=letter)
    place = _place_missing(item, answer)
    if place is not None:
        return say("answer.only-range", condition=condition, letter=lay.from_sympy(place))
    branch = next(branche for branche in part.branches if branche.number == answer.solution)
    protected = protected_letters(part.part)
    own = model(solution.problem, part.part, branch, part.roles, protected)
    unknowns, above = (
        {value for value in own.final if value.name in names}
        for names in (known.anywhere, known.above)
    )
    reasons = reasons_that_bind(own, unknowns, above)
    if not all(_is_of_what_is_found(own, text) for text in answer.condition):
        reasons = ()  # it is one of the equation, which holds of itself otherwise
    tied = {value.name for value in own.final}
    if any(tied.intersection(_names_in(text)) for text in answer.condition):
        # The condition is one of the coefficient itself.
        reasons = tuple(_acute_behind(own, answer.condition))
    for name, square in known.squares.items():
        acute = say("derived.acute", angle=lay.from_sympy(sp.Symbol(name)))
        reasons = tuple(square if reason == acute else reason for reason in reasons)
    reasons = reasons or _bound_alike(solution, answer, known.bounds)
    reasons = reasons or _motion_alike(own, answer)
    if reasons and condition not in reasons:
        by_angle, condition = _below_a_right_angle(part.roles, condition)
        return say("answer.only-as", reasons=(*reasons, *by_angle), condition=condition)
    return _at_the_end(solution, part, item, answer)


def _below_a_right_angle(
    known: Mapping[str, Role], condition: Layout
) -> tuple[tuple[Sentence, ...], Layout]:
    """A condition θ > 60° of an acute angle as 60° < θ < 90°, and that the angle is acute."""
    match condition:
        case lay.Relation((angle, lay.Degrees() as least), (">",)):
            pass
        case _:
            return (), condition
    for name, role in known.items():
        if role == ACUTE and lay.from_sympy(sp.Symbol(name)) == angle:
            right_angle = lay.Degrees(lay.Number("90"))
            both = lay.Relation((least, angle, right_angle), ("<", "<"))
            return (say("derived.acute", angle=angle),), both
    return (), condition


def _at_the_end(
    solution: Solution, part: PartSolution, item: ItemResult, answer: Answer
) -> Sentence:
    """A condition with what is so where it does not hold, as far as that is one end."""
    condition = answer.condition_layout or ""
    end = excluded_end(solution, part, item, answer)
    asked = item.item.expression if isinstance(item.item, Range | Value) else None
    if end is None:
        return say("answer.only", condition=condition)
    if end.answer is not None:
        return say("answer.only-at", condition=condition, end=end.end, there=end.answer)
    if isinstance(item.item, Range) and isinstance(asked, Letter):
        letter = lay.from_sympy(sp.Symbol(asked.name))
        return say("answer.only-range", condition=condition, letter=letter)
    if end.staying is not None:
        body, wall = end.staying
        return say("answer.only-leaving", condition=condition, end=end.end, body=body, wall=wall)
    return say("answer.only", condition=condition)


def _place_missing(item: ItemResult, answer: Answer) -> sp.Symbol | None:
    """The letter whose value at an extremum divides by the one that a condition keeps from zero."""
    if not isinstance(item.item, Extremum) or not answer.reached or len(answer.where or {}) != 1:
        return None
    ((name, value),) = (answer.where or {}).items()
    below = _names_below(value)
    if any(
        text in (f"0 < {letter}", f"{letter} != 0") for text in answer.condition for letter in below
    ):
        return sp.Symbol(name)
    return None


def _names_below(text: str) -> list[str]:
    """The letters behind the last division of an expression."""
    _, sign, below = text.rpartition("/")
    return _names_in(below) if sign else []


def _by_values(
    solution: Solution,
    part: PartSolution,
    item: ItemResult,
    answers: Sequence[Answer],
    known: Known,
) -> Sentence:
    """The conditions of several values that one line gives, each with its value."""
    sentences: list[Sentence] = []
    for answer in answers:
        own = _sentence(solution, part, item, answer, known)
        if own is not None:
            slots = {n: slot for n, slot in own.slots if n in ("condition", "reasons")}
            name = "answer.value-only-as" if "reasons" in slots else "answer.value-only"
            sentences.append(say(name, **slots, value=_as_equation(item, answer)))
    return reduce(lambda first, second: say("answer.both", first=first, second=second), sentences)


def _as_equation(item: ItemResult, answer: Answer) -> Layout:
    """``e = (3 − k)/(4k)``, or the value of what is no letter."""
    asked = item.item.expression if isinstance(item.item, Value) else None
    if not isinstance(asked, Letter):
        return lay.display(answer.value, angle=answer.angle)
    name = lay.from_sympy(sp.Symbol(asked.name))
    return lay.display_named(name, answer.value, angle=answer.angle)


def _is_of_what_is_found(model: Model, text: str) -> bool:
    """Whether no values that the letters may have, by those that were found, break a condition."""
    try:
        links = relation_of_condition(text).only
    except (RestitutionError, ValueError):
        return True  # it is none of one relation
    letter = model.unknowns.letter
    claims = (compared(evaluate(e.left, letter), e.sign, evaluate(e.right, letter)) for e in links)
    try:
        return not any(model.oracle.decide(claim).answer == "refuted" for claim in claims)
    except BeyondError:
        return True


def _by_case(item: ItemResult, general: Answer) -> Sentence:
    """For which values of the data a range holds, and all its forms."""
    forms = tuple(answer.layout or "" for answer in item.distinct)
    return say("answer.by-case", condition=general.condition_layout or "", forms=forms)


def _acute_behind(model: Model, condition: Sequence[str]) -> Iterator[Sentence]:
    """The acute angles by which a letter is positive, where that is the condition."""
    for symbol, value in model.final.items():
        if tuple(condition) != (f"0 < {symbol.name}",):
            continue
        roles_ = {symbol: model.unknowns.roles.get(symbol.name) for symbol in value.free_symbols}
        if all(role == ACUTE for role in roles_.values()) and roles_:
            yield from (say("derived.acute", angle=lay.from_sympy(value)) for value in roles_)
