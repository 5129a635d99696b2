"""``range of X``: all values of a letter or of a quantity that the facts and the physics allow."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from restitution import exact
from restitution.errors import (
    ContradictionError,
    MissingError,
    RestitutionError,
    UnsupportedError,
)
from restitution.exact.symbols import symbol_names
from restitution.expression.dimensions import NONE
from restitution.expression.evaluate import Evaluator, Symbolic
from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.language.measuring import dimensions_of_letters
from restitution.oracle import Oracle, Proof, Relation
from restitution.oracle.roles import Role
from restitution.problem import Compare, Find, Problem, Range, Show
from restitution.render.layout import display_set, from_tree
from restitution.render.text import to_text
from restitution.solving.algebra import forms
from restitution.solving.algebra.intervals import to_set
from restitution.solving.equations.part import Desk, Outcome
from restitution.solving.equations.setting import Setting, Trial, declared
from restitution.solving.equations.solution import Answer, ItemResult
from restitution.solving.ranges.by_signs import HalfForm, forms_by_signs
from restitution.solving.ranges.cases import Case, cases
from restitution.solving.ranges.images import Image
from restitution.solving.ranges.limits import TwoForms, limit
from restitution.solving.ranges.open_lines import open_slopes, with_lines_chosen
from restitution.solving.ranges.regions import Region
from restitution.solving.ranges.validity import (
    Limitation,
    always_exist,
    bounds_of,
    defined,
    half_limitations,
    range_limitations,
    with_condition,
)
from restitution.solving.story import missing
from restitution.solving.story.letters import is_angle, roles
from restitution.solving.story.unknowns import Letters

# Values of what is asked, with what they ask of the other letters.
Form = tuple[sp.Set, tuple[Limitation, ...]]


def find_range(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> ItemResult:
    """All values of a letter, or of a quantity, that the facts allow."""
    line = None if item.place is None else item.place.line
    require_stated(desk.problem, item.expression)
    meant = _meant(desk, item, in_terms_of)
    tree = meant.expression
    base = desk.settle(in_terms_of, meant)
    pieces: list[Form]
    if isinstance(tree, Letter) and tree.name not in base.lets:
        pieces, proof = _range_of_letter(desk, tree.name, in_terms_of, base)
        angle = base.roles[tree.name].kind == "angle"
    else:
        pieces, angle, proof = _range_of_quantity(desk, meant, now, in_terms_of)
    answers = []
    for values, limits in pieces:
        if values is sp.S.EmptySet:
            name = item.text.removeprefix("range of ")
            raise ContradictionError(f"no value of {name} is possible")
        values = values.xreplace(forms.bars_of(values, Oracle(base.roles)))
        layout = display_set(values, from_tree(item.expression), angle=angle)
        text = exact.sympy_text(values)
        answer = Answer(1, values, text, None, to_text(layout), angle=angle, layout=layout)
        answers.append(with_condition(answer, layout, limits))
    return ItemResult(item, line, item.text, "range", tuple(answers), proof=proof)


def require_stated(problem: Problem, tree: Expression) -> None:
    """Raise MissingError for a letter that only questions mention: nothing gives it a meaning."""
    stated = roles(
        replace(
            problem,
            parts=tuple(
                replace(part, steps=tuple(s for s in part.steps if not isinstance(s, Find | Show)))
                for part in problem.parts
            ),
        )
    )
    for name in sorted(letters(tree) - set(stated)):
        if name == "e":
            raise MissingError("no collision has e for its coefficient of restitution")
        raise MissingError(f"nothing is told of {name}")


def _meant(desk: Desk, item: Range, in_terms_of: tuple[str, ...] | None) -> Range:
    """An item with the definition of its letter put in: the range of a ratio, not of its name."""
    lets = desk.settle(in_terms_of, item).lets
    tree = item.expression
    while isinstance(tree, Letter) and tree.name in lets:
        tree = lets[tree.name][0].expression
    return item if has_quantity(tree) else replace(item, expression=tree)


def _range_of_ratio(desk: Desk, item: Range) -> tuple[sp.Set, Proof] | None:
    """The range of q/p from that of q, where it does not depend on p but through q/p."""
    tree = item.expression
    roles = desk.settle(None, item).roles
    value = Evaluator(Symbolic(), Letters(roles).letter).scalar(tree)
    for name in sorted(letters(tree)):
        symbol = roles[name].symbol(name)
        slope = sp.diff(value, symbol)
        if not slope.is_positive:
            continue  # rising with this letter, whatever the others are
        try:
            pieces, proof = _range_of_letter(
                desk, name, None, desk.settle(None, item, letters(tree))
            )
        except RestitutionError:
            continue
        values = pieces[0][0]
        if len(pieces) > 1 or not isinstance(values, sp.Interval):
            continue
        ends = [limit(value, symbol, end, end == sp.oo) for end in (values.start, values.end)]
        if any(end is None or (end.free_symbols & value.free_symbols) for end in ends):
            continue
        image = sp.Interval(ends[0], ends[1], values.left_open, values.right_open)
        # It rises with this letter, so what is proved of that is proved of the ratio.
        return image, proof
    return None


def _range_of_letter(
    desk: Desk, name: str, in_terms_of: tuple[str, ...] | None, setting: Setting
) -> tuple[list[Form], Proof]:
    """The values of a letter, each set of them with what it asks of the other letters."""
    region: Region | None = None  # there is none where the motion itself cannot be worked out
    try:
        outcome = desk.outcome(setting)
        values = values_in(name, outcome.accepted)
        if values is not sp.S.EmptySet:
            _require_visible(outcome, symbol_names(values))
            return [(values, ())], "algebra"
        free = _free(outcome, in_terms_of) - {name}
        tied = _tied_to_data(desk, name, in_terms_of, outcome)
        if tied is not sp.S.EmptySet:
            return [(tied, ())], "algebra"
        outcome = with_lines_chosen(outcome)
        slopes = open_slopes(outcome)
        if len(slopes) > 1:
            _require_visible(outcome, slopes)
        free |= slopes
        region = Region(outcome, name, tuple(sorted(free)))
        values, several = _forms(region)
    except UnsupportedError:
        if region is None or not (halves := forms_by_signs(region)):
            raise
        return _by_sign(outcome, region.trials[0], region, halves)
    except ContradictionError:
        values = fixed_values(desk, name, setting)
        if values is sp.S.EmptySet:
            raise
        return [(values, ())], "algebra"
    if several:
        if any(case.proof == "undecided" for case in several) and (
            halves := forms_by_signs(region)
        ):
            return _by_sign(outcome, region.trials[0], region, halves)
        return _by_case(outcome, region, several)
    if values is sp.S.EmptySet:
        return [(fixed_values(desk, name, setting), ())], "algebra"  # the facts alone fix it
    if region.proof == "undecided" and (halves := forms_by_signs(region)):
        return _by_sign(outcome, region.trials[0], region, halves)
    if not _is_general(region, values):
        several = cases(region)
        if len(several) > 1:
            return _by_case(outcome, region, several)
    _require_visible(outcome, symbol_names(values))
    return [(values, range_limitations(outcome, region, values))], region.proof


def _tied_to_data(
    desk: Desk, name: str, in_terms_of: tuple[str, ...] | None, outcome: Outcome
) -> sp.Set:
    """The values of a letter that the facts tie to data which do not vary: v = u, say.

    Where letters are listed, these are the data; else what has no dimension varies, and is asked
    for all that it can be.
    """
    setting = outcome.setting
    ratios = _without_dimension(outcome)
    if in_terms_of is None and name in ratios:
        return sp.S.EmptySet
    data = set(in_terms_of or setting.roles.keys() - ratios)
    data -= declared(setting.problem, setting.part)
    if not any(data & trial.root.values.keys() for trial in outcome.accepted):
        return sp.S.EmptySet
    values = fixed_values(desk, name, setting)
    inside = symbol_names(values)
    return values if inside <= data else sp.S.EmptySet


def _is_general(region: Region, values: sp.Set) -> bool:
    """Whether the ends of a range have values, and lie in the range of the letter, for all data."""
    if values.has(sp.Min, sp.Max) or not always_exist(values, Oracle(region.roles, region.given)):
        return False
    if not isinstance(values, sp.Interval) or region.formula is None:
        return True
    oracle = Oracle(region.roles, (*region.given, region.formula))
    ends = ((values.start, region.role.low, 1), (values.end, region.role.high, -1))
    claims = [
        Relation(sense * (end - bound), ">=")
        for end, bound, sense in ends
        if bound is not None and end.free_symbols
    ]
    if (values.left_open or values.right_open) and not values.end.is_infinite:
        claims.append(Relation(values.end - values.start, ">"))  # not one value alone
    return all(oracle.decide(claim).answer != "refuted" for claim in claims)


def _by_case(outcome: Outcome, region: Region, several: Sequence[Case]) -> tuple[list[Form], Proof]:
    """The values in each case with what it asks of the data, and what they all rest on.

    A hidden unknown may have any of its values: where one case has all that a letter may be, these
    are the values.
    """
    hidden = {case.letter for case in several if case.letter.startswith("_")}
    whole = _all_values(region.role)
    every = next((case for case in several if hidden and to_set(case.pieces) == whole), None)
    if every is not None:
        return [(whole, ())], every.proof
    _require_visible(outcome, hidden.union(*(symbol_names(to_set(c.pieces)) for c in several)))
    return _with_bounds(several, region.roles)


def _all_values(role: Role) -> sp.Set:
    """What a letter may be by its role."""
    low = -sp.oo if role.low is None else role.low
    high = sp.oo if role.high is None else role.high
    return sp.Interval(low, high, not role.closed[0], not role.closed[1])


def _require_visible(outcome: Outcome, names: Iterable[str]) -> None:
    """Raise MissingError where a range rests on what the text leaves open."""
    phrases = outcome.letters.phrases
    hidden = sorted({phrases.get(name, name) for name in names if name.startswith("_")})
    if hidden:
        raise missing.needs("the range", hidden)


def _with_bounds(several: Sequence[Case], roles: Mapping[str, Role]) -> tuple[list[Form], Proof]:
    """The values in each case with the bounds of the letter of the data."""
    forms: list[Form] = []
    for case in several:
        bounds = bounds_of(case.letter, case.values, roles)
        # A case that holds for all values of its letter asks nothing of it.
        forms.append((to_set(case.pieces), () if bounds.text == case.letter else (bounds,)))
    proofs: list[Proof] = [case.proof for case in several]
    return forms, next((proof for proof in proofs if proof != "algebra"), proofs[0])


def _by_sign(
    outcome: Outcome, trial: Trial, region: Region | Image, halves: Sequence[HalfForm]
) -> tuple[list[Form], Proof]:
    """The values by the sign of something in the data, with what each form asks of these."""
    forms: list[Form] = []
    for half in halves:
        values = to_set(half.pieces)
        limits = half_limitations(outcome, trial, region, half.relation, values)
        forms.append((values, limits))
    proofs: list[Proof] = [half.proof for half in halves]
    return forms, next((proof for proof in proofs if proof != "algebra"), proofs[0])


def _forms(region: Region | Image) -> tuple[sp.Set, list[Case]]:
    """The values in one form; in several, where one is not proved or not to be had."""
    try:
        values = to_set(region.pieces())
    except UnsupportedError:
        several = cases(region)
        if several:
            return sp.S.EmptySet, several
        raise
    if region.proof != "undecided" or values is sp.S.EmptySet:
        return values, []
    return values, cases(region)


def fixed_values(desk: Desk, name: str, setting: Setting) -> sp.Set:
    """The values of a letter that the facts fix, though it was to run over a range."""
    own = frozenset({name})
    sought = replace(
        setting,
        protected=setting.protected - own,
        fixed=setting.fixed - own,
        asked=setting.asked | own,
    )
    try:
        accepted = desk.outcome(sought).accepted
    except RestitutionError:
        return sp.S.EmptySet
    return values_in(name, accepted)


def values_in(name: str, accepted: Sequence[Trial]) -> sp.Set:
    """The values that a letter has in all solutions; none where it is open in one of them."""
    values = [trial.root.values[name] for trial in accepted if name in trial.root.values]
    return sp.FiniteSet(*map(exact.tidy, values)) if len(values) == len(accepted) else sp.S.EmptySet


def _free(outcome: Outcome, in_terms_of: tuple[str, ...] | None) -> set[str]:
    """Letters that vary freely: declared unknown, or not listed, and not fixed by the facts."""
    setting = outcome.setting
    solved = {name for trial in outcome.trials for name in trial.root.values}
    free = set(declared(setting.problem, setting.part))
    if in_terms_of is not None:
        free |= set(setting.roles) - set(in_terms_of)
    return free - solved - set(setting.lets)


def _range_of_quantity(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> tuple[list[Form], bool, Proof]:
    tree = item.expression
    setting = desk.settle(in_terms_of, item)
    named = letters(tree) - set(setting.lets) if not has_quantity(tree) else frozenset()
    if len(named) > 1 and not letters(tree) & set(setting.lets):
        answer = _range_of_ratio(desk, item)
        if answer is not None:
            return [(answer[0], ())], False, answer[1]
    walls = frozenset(wall.name for wall in desk.problem.walls)
    angles = {name for name, role in setting.roles.items() if role.kind == "angle"}
    angle = is_angle(tree, angles, walls)
    # What varies freely must not be solved for: where the facts fix it, that is found out.
    first = desk.outcome(setting)
    fixed = {name for trial in first.trials for name in trial.root.values}
    outcome = desk.outcome(desk.settle(in_terms_of, item, named)) if named else first
    values = values_of_trials(outcome, tree, now)
    present = {s.name for _, value in values for s in value.textbook.free_symbols}
    freed = _free(first, in_terms_of) | named
    free = (freed & present) - (fixed - named)
    free = free or _restricted(outcome) & present
    if not freed:
        free = free or _without_dimension(outcome) & present
    free -= set(in_terms_of or ())
    if not free:
        return [(sp.FiniteSet(*[value.textbook for _, value in values]), ())], angle, "algebra"
    _require_visible(outcome, present)
    image, proof = _image(outcome, values, sorted(free), angle)
    return image, angle, proof


def _restricted(outcome: Outcome) -> set[str]:
    """Letters that a fact keeps between bounds, and coefficients: what a range is asked over."""
    setting = outcome.setting
    names = {name for name, role in setting.roles.items() if role.kind == "restitution"}
    for given, _ in setting.facts:
        for relation in given.relations:
            if isinstance(relation, Compare) and set(relation.operators) != {"="}:
                names |= {
                    operand.name for operand in relation.operands if isinstance(operand, Letter)
                }
    return names


def _without_dimension(outcome: Outcome) -> set[str]:
    """Angles and ratios among the letters: over these a range goes where nothing else varies."""
    dimensions = dimensions_of_letters(outcome.setting.problem)
    return {name for name in outcome.setting.roles if dimensions.get(name, NONE) == NONE}


def values_of_trials(
    outcome: Outcome, tree: Expression, now: int, asked: str = "the range"
) -> list[tuple[Trial, TwoForms]]:
    """The value of a quantity in each accepted trial.

    Raises MissingError where the value rests on what is open, ContradictionError where there is no
    trial, and UnsupportedError for a vector.
    """
    images = []
    for trial in outcome.accepted:
        solved_letters = Letters(
            outcome.setting.roles, trial.root.values, trial.root.angles, trial.samples
        )
        story = outcome.setting.tell(solved_letters)
        raw = story.evaluator(now).value(tree)
        phrases = {**outcome.letters.phrases, **solved_letters.phrases}
        needed = [phrases.get(name, name) for name in forms.open_in(raw, trial.samples)]
        if needed:
            raise missing.needs(asked, needed)
        value = forms.plain(raw, outcome.witnesses(trial))
        if isinstance(value, tuple):
            raise UnsupportedError("the range of a vector is not a set of numbers")
        directions = forms.by_directions(raw, outcome.witnesses(trial))
        images.append((trial, TwoForms(value, value if directions is None else directions)))
    if not images:
        raise ContradictionError("no values satisfy all that is told")
    return images


def _image(
    outcome: Outcome, values: list[tuple[Trial, TwoForms]], free: list[str], angle: bool
) -> tuple[list[Form], Proof]:
    """The values of expressions as letters vary freely within what is allowed."""
    sets: list[sp.Set] = []
    proofs: list[Proof] = []
    limits: tuple[Limitation, ...] = ()
    for trial, value in values:
        own = replace(outcome, trials=(trial,))
        used = [name for name in free if any(s.name == name for s in value.textbook.free_symbols)]
        if not used:
            sets.append(sp.FiniteSet(value.textbook))
            proofs.append("algebra")
            continue
        image = Image(own, value, used, angle)
        one, several = _forms(image)
        if len(values) == 1 and not always_exist(one, Oracle(image.roles, image.given)):
            several = [] if len(own_cases := cases(image)) < 2 else own_cases
            limits = defined(outcome, trial, one.args[:2])
        if several and len(values) == 1:
            _require_visible(outcome, (case.letter for case in several))
            return _with_bounds(several, image.roles)
        if several:
            raise UnsupportedError("the form of the range depends on the values of the data")
        sets.append(one)
        proofs.append(image.proof)
    return [(sp.Union(*sets), limits)], "undecided" if "undecided" in proofs else proofs[0]
