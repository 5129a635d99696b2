"""``maximum of Q over X``: stationary points and the ends of what X may be."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import islice
from types import MappingProxyType

import sympy as sp

from restitution import exact
from restitution.errors import (
    ContradictionError,
    ImpossibleError,
    UnboundedError,
    UnsupportedError,
)
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Proof,
    Relation,
    Verdict,
    joined,
    letters_of,
)
from restitution.oracle.roles import REAL, Role
from restitution.problem import Extremum
from restitution.render.layout import (
    Layout,
    Phrase,
    Words,
    display,
    display_named,
    equation,
    from_sympy,
)
from restitution.render.text import to_text
from restitution.solving.algebra import forms
from restitution.solving.algebra.intervals import (
    INFINITE,
    End,
    Piece,
    inside_of,
    same_at,
    to_set,
)
from restitution.solving.algebra.neat import neat
from restitution.solving.algebra.numbers import Sample, at, sample, sign_beyond
from restitution.solving.equations.part import Desk, Outcome
from restitution.solving.equations.setting import Setting, Trial
from restitution.solving.equations.solution import Answer, ItemResult
from restitution.solving.ranges.allowed_values import (
    fixed_values,
    require_stated,
    values_in,
    values_of_trials,
)
from restitution.solving.ranges.cases import Case, cases
from restitution.solving.ranges.images import Candidate, is_near, reaches, tends
from restitution.solving.ranges.limits import LONG, TwoForms, breaks, limit_at, limits, turning
from restitution.solving.ranges.regions import DRAWS, DRAWS_TRIED, Region
from restitution.solving.ranges.validity import Limitation, bounds_of, defined, with_condition
from restitution.solving.story.admission import Admission, Demand
from restitution.solving.story.letters import is_angle
from restitution.solving.story.unknowns import Letters

Extreme = tuple[Candidate, bool, Enclosed, Sample]
"""The best candidate, whether it is reached, its value at some data, and these data."""

Best = tuple[Extreme, tuple[sp.Expr, ...]]
"""The extreme of one solution, and the further numbers at which it is reached."""


def find_extremum(
    desk: Desk, item: Extremum, now: int, in_terms_of: tuple[str, ...] | None
) -> ItemResult:
    """The greatest or least value of a quantity as one letter varies, and where it is reached."""
    line = None if item.place is None else item.place.line
    if not isinstance(item.over, Letter):
        raise UnsupportedError("an extremum is sought over a letter")
    if not (has_quantity(item.expression) and letters(item.over) <= letters(item.expression)):
        require_stated(desk.problem, item.over)  # else a time, say, of which the question speaks
    name = item.over.name
    setting = desk.settle(in_terms_of, item)
    if name not in setting.roles:
        raise UnsupportedError(f"nothing depends on {name}")
    outcome = _with_a_letter_to_vary(desk, name, setting)
    walls = frozenset(wall.name for wall in desk.problem.walls)
    angles = {n for n, role in setting.roles.items() if role.kind == "angle"}
    angle = is_angle(item.expression, angles, walls)
    sign = 1 if item.kind == "maximum" else -1
    candidates: list[tuple[Trial, Best]] = []
    values: dict[int, TwoForms] = {}
    trials = values_of_trials(outcome, item.expression, now, f"the {item.kind}")
    for trial, value in trials:
        values[id(trial)] = value
        own = replace(outcome, trials=(trial,))
        try:
            best = _best(own, value, name, sign)
        except DependsOnDataError:
            several = [] if len(trials) > 1 else cases(_Winners(own, value, name, sign))
            if not several or any(case.pieces[0][0].value.is_infinite for case in several):
                raise
            return _in_cases(own, item, several, angle)
        if best is not None:
            candidates.append((trial, best))
    if not candidates:
        raise ContradictionError("no values satisfy all that is told")
    trial, ((candidate, reached, number, data), further) = max(
        candidates, key=lambda candidate: sign * candidate[1][0][2]
    )
    if abs(number) == INFINITE:  # its sign may hang on the data, as one of 1 − e² does
        raise _unbounded(replace(outcome, trials=(trial,)), item, candidate, number)
    own = replace(outcome, trials=(trial,))
    place = candidate.where[name]
    answer = _answer(own, item, candidate.value, (place, *further), reached, angle)
    proof, limits = _proved(own, values[id(trial)], candidate, reached, sign)
    if reached and not place.is_infinite:
        limits = (*defined(outcome, trial, (forms.bound(place), answer.value)), *limits)
    elsewhere = _elsewhere(own, values[id(trial)], name, (candidate, reached), data, sign)
    existing = _where_it_is_defined(own, item, now)
    limits = tuple({limit.text: limit for limit in (*limits, *elsewhere, *existing)}.values())
    assert answer.layout is not None
    answer = with_condition(answer, answer.layout, limits)
    return ItemResult(item, line, item.text, "extremum", (answer,), proof=proof)


def _unbounded(
    outcome: Outcome, item: Extremum, candidate: Candidate, number: Enclosed
) -> UnboundedError:
    """That there is no extremum, and on the way to what place it grows or falls."""
    region = Region(outcome, next(iter(candidate.where)))
    place = forms.bound(candidate.where[region.letter])
    angle = region.role.kind == "angle"
    there = (
        equation(region.symbol, from_sympy(place))
        if place.is_infinite
        else display_named(region.symbol, place, angle=angle)
    )
    grows = "grows" if number > 0 else "falls"
    because = to_text(Phrase((Words(f"it {grows} without bound as"), replace(there, signs=("→",)))))
    limits = [to_text(limit.layout) for limit in _where_it_does(region, candidate.value)]
    if limits:
        because = f"for {' and '.join(limits)} {because}"
    error = UnboundedError(f"it has no {item.kind}: {because}")
    error.because = because
    return error


def _where_it_does(region: Region, infinite: sp.Expr) -> Iterator[Limitation]:
    """That coefficients are not at ends of their ranges at which nothing grows: 1 − e² is 0."""
    signs = [atom.args[0] for atom in infinite.atoms(sp.sign)]
    for name in region.data():
        role = region.roles[name]
        if role.kind != "restitution" or role.low is None or role.high is None:
            continue
        kept = [
            closed and not any(sign.xreplace({role.symbol(name): end}) == 0 for sign in signs)
            for end, closed in zip((role.low, role.high), role.closed, strict=True)
        ]
        if tuple(kept) != role.closed:
            piece = End(role.low, kept[0]), End(role.high, kept[1])
            yield bounds_of(name, to_set([piece]), region.roles)


def _answer(
    outcome: Outcome,
    item: Extremum,
    value: sp.Expr,
    places: tuple[sp.Expr, ...],
    reached: bool,
    angle: bool,
) -> Answer:
    """An extremum with the values of the letter at which it is reached, or the one it is near."""
    assert isinstance(item.over, Letter)
    (trial,) = outcome.trials
    name, (place, *further) = item.over.name, places
    if sp.count_ops(value) > LONG and Oracle(_roles(outcome)).vanishes(value):
        value = sp.S.Zero
    value = forms.plain(_without_squares_in_roots(outcome, value), outcome.witnesses(trial))
    if angle:
        value = exact.tidy_angle(value)
    place = forms.bound(place)
    role = outcome.setting.roles[name]
    symbol = role.symbol(name)
    there = (
        equation(symbol, from_sympy(place))
        if place.is_infinite
        else display_named(symbol, place, angle=role.kind == "angle")
    )
    places_ = [there, *(display_named(symbol, x, angle=role.kind == "angle") for x in further)]
    if not reached:
        places_ = [replace(other, signs=("→", *other.signs[1:])) for other in places_]
    where: Layout = Phrase(tuple(places_), " or ") if further else places_[0]
    most = display(value, angle=angle, percentage=item.percentage)
    layout = Phrase((most, Words("when" if reached else "approached as"), where))
    return Answer(
        1,
        value,
        exact.sympy_text(value),
        exact.decimal(value),
        to_text(layout),
        {name: exact.sympy_text(place)},
        reached,
        angle,
        layout,
    )


def _without_squares_in_roots(outcome: Outcome, value: sp.Expr) -> sp.Expr:
    """√((1 − e)/(3 − e)²) as √(1 − e)/(3 − e), where the sign of what is squared is known."""
    oracle = Oracle(_roles(outcome))

    def taken(base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        inside, outside = [], []
        for factor in sp.Mul.make_args(sp.factor(base)):
            own, power = factor.as_base_exp()
            if own.is_Add and power.is_Integer and not power % 2:
                sign = next((s for s in (1, -1) if oracle.proves(Relation(s * own, ">"))), 0)
                if sign:
                    outside.append((sign * own) ** (power * exponent))
                    continue
            inside.append(factor)
        return sp.Mul(*outside) * sp.Mul(*inside) ** exponent if outside else base**exponent

    own = value.replace(lambda x: x.is_Pow and abs(x.exp) == sp.S.Half, lambda x: taken(*x.args))
    return value if own == value else own.replace(sp.atan, lambda x: sp.atan(neat(x)))


def _in_cases(outcome: Outcome, item: Extremum, several: list[Case], angle: bool) -> ItemResult:
    """An extremum that lies elsewhere for other data, with the values of these for each place."""
    answers = []
    for case in several:
        ((best, place),) = case.pieces
        value = best.value.replace(sp.atan, lambda x: sp.atan(neat(x)))
        value = min(best.value, value, key=exact.cost)
        if angle:
            inside = inside_of(outcome.setting.roles[case.letter].symbol(case.letter), [case.where])
            value = _as_one_arctangent(Oracle(_roles(outcome), (inside,)), value)
        answer = _answer(outcome, item, value, (place.value,), best.closed, angle)
        bounds = bounds_of(case.letter, case.values, outcome.setting.roles)
        assert answer.layout is not None
        limits = () if bounds.text == case.letter else (bounds,)
        answers.append(with_condition(answer, answer.layout, limits))
    line = None if item.place is None else item.place.line
    proofs: list[Proof] = [case.proof for case in several]
    proof = next((kind for kind in proofs if kind != "algebra"), proofs[0])
    return ItemResult(item, line, item.text, "extremum", tuple(answers), proof=proof)


def _as_one_arctangent(oracle: Oracle, angle: sp.Expr) -> sp.Expr:
    """90° − arctan x as arctan 1/x, where x is positive for all data."""
    rest = sp.expand(sp.pi / 2 - angle)
    if not isinstance(rest, sp.atan) or not rest.free_symbols:
        return angle
    above, below = sp.together(rest.args[0]).as_numer_denom()
    positive = oracle.proves(Relation(rest.args[0], ">"))
    return sp.atan(neat(below / above)) if positive else angle


def _with_a_letter_to_vary(desk: Desk, name: str, setting: Setting) -> Outcome:
    """What solving gives where a letter may vary. Raises UnsupportedError where facts fix it."""
    clash: ContradictionError | None = None
    try:
        outcome = desk.outcome(setting)
        values = values_in(name, outcome.accepted)
    except ContradictionError as error:
        clash = error
        values = fixed_values(desk, name, setting)
    if values is not sp.S.EmptySet:
        raise UnsupportedError(
            f"what is given fixes {name}, so there is nothing to vary: what is given only for "
            "later belongs in a part of its own"
        )
    if clash is not None:
        raise clash
    return outcome


def _proved(
    outcome: Outcome, value: TwoForms, best: Candidate, reached: bool, sign: int
) -> tuple[Proof, tuple[Limitation, ...]]:
    """The proof that no value lies beyond an extremum, or equals one that is only approached.

    With it stands what that asks of a coefficient of the data: for e = 1 a speed may be the same
    at all angles. Raises UnsupportedError where some value is beyond for other data.
    """
    region = Region(outcome, next(iter(best.where)))
    if region.formula is None:
        return "undecided", ()
    own = value.without_poles(region.symbol, region.roles)
    claim = Relation(sign * (best.value - own), ">=" if reached else ">")
    try:
        verdict = Oracle(region.roles, (region.formula,)).decide(claim)
        for inside, limitation in _without_an_end(region, verdict):
            limited = Oracle(region.roles, (region.formula, inside)).decide(claim)
            if limited:
                return limited.proof, (limitation,)
    except BeyondError:
        return "undecided", ()
    if verdict.answer == "refuted":
        raise UnsupportedError("the extremum has no exact form that is found here")
    return (verdict.proof if verdict else "undecided"), ()


def _elsewhere(
    outcome: Outcome,
    value: TwoForms,
    name: str,
    best: tuple[Candidate, bool],
    data: Sample,
    sign: int,
) -> Iterator[Limitation]:
    """That coefficients of the data are not at the ends of their ranges for which the extremum
    is another one: a wall with e = 0 turns no path back, however steep it is.
    """
    region = Region(outcome, name)
    roles_, (candidate, reached) = _roles(outcome), best
    for coefficient in region.data():
        role = roles_[coefficient]
        if role.kind != "restitution" or role.low is None or role.high is None:
            continue
        symbol = role.symbol(coefficient)
        if not any(
            expression.has(symbol)
            for expression in (value.textbook, candidate.value, *candidate.where.values())
        ):
            continue
        kept = [
            closed and _is_best_at(region, value, (candidate, reached), {symbol: end}, data, sign)
            for end, closed in zip((role.low, role.high), role.closed, strict=True)
        ]
        if tuple(kept) != role.closed:
            piece = End(role.low, kept[0]), End(role.high, kept[1])
            yield bounds_of(coefficient, to_set([piece]), region.roles)


def _where_it_is_defined(outcome: Outcome, item: Extremum, now: int) -> Iterator[Limitation]:
    """That coefficients of the data are not at ends of their ranges for which there is no quantity.

    A ball that comes to rest in a corner with e = 0 has no deflection.
    """
    assert isinstance(item.over, Letter)
    region = Region(outcome, item.over.name)
    (trial,) = outcome.trials
    for coefficient in region.data():
        role = region.roles[coefficient]
        if role.kind != "restitution" or role.low is None or role.high is None:
            continue
        symbol = role.symbol(coefficient)
        kept = [
            closed and _exists_at(region, trial, item, now, {symbol: end})
            for end, closed in zip((role.low, role.high), role.closed, strict=True)
        ]
        if tuple(kept) != role.closed:
            piece = End(role.low, kept[0]), End(role.high, kept[1])
            yield bounds_of(coefficient, to_set([piece]), region.roles)


def _exists_at(
    region: Region, trial: Trial, item: Extremum, now: int, put: Mapping[sp.Symbol, sp.Expr]
) -> bool:
    """Whether a quantity has a value for this value of a letter, or the letter may not have it."""
    setting, root = region.outcome.setting, trial.root
    values = {name: value.xreplace(put) for name, value in root.values.items()}
    angles = {name: (c.xreplace(put), s.xreplace(put)) for name, (c, s) in root.angles.items()}
    values |= {symbol.name: value for symbol, value in put.items()}
    try:
        story = setting.tell(Letters(setting.roles, values, angles))
    except ImpossibleError:
        return True
    try:
        story.evaluator(now).value(item.expression)
    except ImpossibleError:
        facts = () if region.formula is None else (region.formula,)
        differs = joined(Relation(symbol - value, "!=") for symbol, value in put.items())
        return bool(Oracle(region.roles, facts).decide(differs))
    return True


def _is_best_at(
    region: Region,
    value: TwoForms,
    best: tuple[Candidate, bool],
    put: Mapping[sp.Symbol, sp.Expr],
    data: Sample,
    sign: int,
) -> bool:
    """Whether an extremum is one for these values of some data, where there is one at all."""
    candidate, reached = best
    there = value.put(put)
    drawn = {**data, **{symbol.name: at(x, {}) for symbol, x in put.items()}}
    if not there.textbook.has(region.symbol):
        number = limit_at(there.textbook, drawn)
        own = limit_at(candidate.value.xreplace(put), drawn)
        return number is None or (own is not None and not (own - number).sign)
    try:
        winner = _winner(region, there, _candidates(region, there.textbook), drawn, sign)
    except UnsupportedError:
        return False
    if winner is None:
        return True
    own = limit_at(candidate.value.xreplace(put), drawn)
    return own is not None and winner[1] == reached and not (winner[2] - own).sign


def _without_an_end(region: Region, verdict: Verdict) -> Iterator[tuple[Formula, Limitation]]:
    """That a coefficient of the data is not at the end of its range at which a claim fails."""
    witness = verdict.witness or {}
    for name in region.data() if witness else ():
        role = region.roles[name]
        if role.kind != "restitution" or role.low is None or role.high is None:
            continue
        for end in (role.low, role.high):
            if witness.get(name) == end:
                pieces = [
                    (
                        End(role.low, end != role.low and role.closed[0]),
                        End(role.high, end != role.high and role.closed[1]),
                    )
                ]
                bounds = bounds_of(name, to_set(pieces), region.roles)
                yield inside_of(role.symbol(name), pieces), bounds


def _further(
    region: Region,
    value: TwoForms,
    candidates: list[Candidate],
    extreme: tuple[Candidate, bool],
    data: Sample,
) -> tuple[sp.Expr, ...]:
    """The other numbers at which an extremum is reached, or approached: both ends, say."""
    places: list[sp.Expr] = []
    best, reached = extreme
    for candidate in candidates:
        place = candidate.where[region.letter]
        if place == best.where[region.letter] or not place.is_number or place.is_infinite:
            continue
        if candidate.value != best.value or place in places:
            continue
        number = limit_at(candidate.value, data)
        if number is None:
            continue
        if not reached:
            close = is_near(region, candidate, data) and tends(
                region, value.textbook, candidate, data
            )
        else:
            close = reaches(region, value.whole, candidate, number, data)
        if close:
            places.append(place)
    return tuple(places)


class DependsOnDataError(UnsupportedError):
    """The place of an extremum is another one for other data."""


class _Winners:
    """Where a quantity is greatest or least, by the data: as the family of one interval.

    Its ends are the extremum and its place; the first is closed where the extremum is reached.
    """

    def __init__(self, outcome: Outcome, value: TwoForms, name: str, sign: int) -> None:
        self._region = Region(outcome, name)
        self._value, self._sign = value, sign
        self._candidates = _candidates(self._region, value.textbook)
        self.role, self.roles = REAL, self._region.roles
        self.data, self.given = self._region.data, self._region.given
        self.formula, self.of_data = self._region.formula, self._region.of_data
        values = [candidate.value for candidate in self._candidates]
        places = [candidate.where[name] for candidate in self._candidates]
        self.critical_groups = [
            [end for end in ends if not end.has(self._region.symbol)] for ends in (values, places)
        ]

    @cached_property
    def shapes(self) -> list[tuple[list[Piece], Sample]]:
        """The extremum at some values of the data."""
        rng = random.Random(31)
        drawn = [sample(self.data(), _roles(self._region.outcome), rng) for _ in range(DRAWS_TRIED)]
        shapes = ((self.pieces_at(drawing), drawing) for drawing in drawn)
        return list(islice((shape for shape in shapes if shape[0]), DRAWS))

    def pieces_at(
        self, drawn: Sample, put: Mapping[sp.Symbol, sp.Expr] = MappingProxyType({})
    ) -> list[Piece]:
        """The extremum for these values of the data, or none; ``put`` has some exactly."""
        value, candidates = self._value, self._candidates
        if put and value.textbook.has(*put):
            value = value.put(put)
            if not value.textbook.has(self._region.symbol):
                return []
            candidates = _candidates(self._region, value.textbook)
        winner = _winner(self._region, value, candidates, drawn, self._sign)
        if winner is None:
            return []
        best, reached, _, _ = winner
        own = _with_signs(best.value, drawn)
        return [(End(own, reached), End(best.where[self._region.letter], True))]

    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict:
        """Whether an extremum is one for all data: no value lies beyond it, and it occurs.

        That it occurs is seen at some data where it is no question for a decision.
        """
        ((best, _),) = pieces
        open_ = Verdict("undecided", "undecided")
        if self.formula is None or best.value.is_infinite:
            return open_
        value = self._value.without_poles(self._region.symbol, self.roles)
        claim = Relation(self._sign * (best.value - value), ">=" if best.closed else ">")
        parts = self.formula.parts if isinstance(self.formula, All) else (self.formula,)
        letter = self._region.letter
        of_data = [part for part in parts if letters_of(part) and letter not in letters_of(part)]
        there = joined((self.formula, Relation(value - best.value, "=")))
        around = Oracle(self.roles, (*more, *of_data))
        try:
            outer = Oracle(self.roles, (*more, self.formula)).decide(claim)
            if not outer:
                return outer
            if best.closed and (inner := around.decide_some(there, frozenset({letter}))):
                return inner
        except BeyondError:
            return open_
        return outer if self._occurs(pieces, (*more, *of_data)) else open_

    def _occurs(self, pieces: Sequence[Piece], facts: Sequence[Formula]) -> bool:
        """Whether the extremum is this one at all data that are tried, usual and extreme ones."""
        rng = random.Random(41)
        asked = Admission(self.roles, tuple(Demand(fact, "", "fact") for fact in facts), ())
        seen = 0
        for number in range(_TRIED):
            drawn = sample(self.data(), self.roles, rng, number % 3 == 2)
            put = {symbol: x for symbol, x in _solved_letters(facts) if symbol.name in drawn}
            drawn |= {symbol.name: at(x, drawn) for symbol, x in put.items()}
            if asked.objection(drawn) is not None:
                continue
            try:
                own = self.pieces_at(drawn, put)
            except UnsupportedError:
                continue
            if own and not same_at(own, pieces, drawn):
                return False
            seen += bool(own)
            if seen == 2 * DRAWS:
                break
        return seen >= DRAWS


def _with_signs(value: sp.Expr, drawn: Sample) -> sp.Expr:
    """A limit with the signs that something in the data has at some values of these."""
    return value.replace(sp.sign, lambda x: sp.Integer(at(x, drawn).sign))


def _solved_letters(facts: Sequence[Formula]) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The letters of which an equation among facts tells the value."""
    for fact in facts:
        if isinstance(fact, Relation) and fact.operator == "=":
            for symbol in fact.value.free_symbols:
                x = sp.expand(symbol - fact.value)
                if not x.has(symbol):
                    yield symbol, x
                    break


_TRIED = 60


def _best(outcome: Outcome, value: TwoForms, name: str, sign: int) -> Best | None:
    region = Region(outcome, name)
    roles = _roles(outcome)
    if not value.textbook.has(region.symbol):
        raise UnsupportedError(f"the quantity does not depend on {name}")
    candidates = _candidates(region, value.textbook)
    data = region.data()
    rng = random.Random(31)
    winners: list[Extreme] = []
    # Usual data first; then such that are very large or small beside others, or near an end.
    for at_edge in (False, True) if data else (False,):
        number = len(winners) + DRAWS
        for _ in range(DRAWS_TRIED if data else 1):
            drawn = sample(data, roles, rng, at_edge)
            chosen = _winner(region, value, candidates, drawn, sign)
            if chosen is not None:
                winners.append(chosen)
            if len(winners) == number:
                break
    if not winners:
        return None
    first = winners[0]
    if any(winner[0] != first[0] for winner in winners[1:]):
        raise DependsOnDataError("where the extremum lies depends on the values of the data")
    best, reached, _, drawn = first
    return first, _further(region, value, candidates, (best, reached), drawn)


def _roles(outcome: Outcome) -> dict[str, Role]:
    return {**outcome.setting.roles, **outcome.letters.hidden_roles}


def _candidates(region: Region, value: sp.Expr) -> list[Candidate]:
    """What a quantity comes to where it may be greatest or least: it turns, or is at an end."""
    roles = _roles(region.outcome)
    broken = breaks(value, region.symbol, roles)
    points = turning(value, region.symbol, roles) + broken
    points += region.critical
    points += [sp.oo] * (region.role.high is None) + [-sp.oo] * (region.role.low is None)
    # The sign of what grows without bound may hang on the data: then either limit is one.
    turned = value.replace(sp.atan, lambda x: -sp.atan(x))
    forms_ = (
        (value, turned) if turned != value and value.free_symbols - {region.symbol} else (value,)
    )
    return list(
        {
            (at_point, point, *sides.items()): Candidate(at_point, {region.letter: point}, sides)
            for point in dict.fromkeys(points)
            for form in forms_
            for at_point, sides in limits(
                form, region.symbol, point, region.role, broken=point in broken
            )
        }.values()
    )


def _winner(
    region: Region,
    value: TwoForms,
    candidates: list[Candidate],
    drawn: Sample,
    sign: int,
) -> Extreme | None:
    """The candidate of the greatest or least value at some data."""
    best: Extreme | None = None
    for candidate in candidates:
        number = limit_at(candidate.value, drawn)
        if number is None or not is_near(region, candidate, drawn):
            continue
        reached = reaches(region, value.whole, candidate, number, drawn)
        if not reached and not tends(region, value.textbook, candidate, drawn):
            continue
        if (
            best is None
            or sign * number > sign * best[2]
            or (not (number - best[2]).sign and reached and not best[1])
        ):
            best = (candidate, reached, number, drawn)
    if best is None:
        return None
    # Nothing that occurs may be beyond it: else a stationary point was missed.
    rng = random.Random(37)
    names = [region.letter]
    for _ in range(24):
        point = sample(names, region.setting.roles, rng)
        values = {**drawn, **point}
        if not region._possible(values):
            continue
        try:
            beyond = sign * sign_beyond(value.textbook, values, best[2])
        except (UndefinedError, KeyError):
            continue
        if beyond > 0:
            raise UnsupportedError("the extremum has no exact form that is found here")
    return best
