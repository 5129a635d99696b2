"""``maximum of Q over X``: stationary points and the ends of what X may be."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from restitution import exact
from restitution.errors import ContradictionError, ImpossibleError, UnsupportedError
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.oracle import BeyondError, Formula, Oracle, Proof, Relation, Verdict
from restitution.oracle.roles import Role
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
from restitution.solving.algebra.intervals import End, inside_of, to_set
from restitution.solving.algebra.numbers import Sample, at, sample
from restitution.solving.equations.part import Desk, Outcome
from restitution.solving.equations.setting import Setting, Trial
from restitution.solving.equations.solution import Answer, ItemResult
from restitution.solving.ranges.allowed_values import (
    fixed_values,
    require_stated,
    values_in,
    values_of_trials,
)
from restitution.solving.ranges.images import Candidate, is_near, reaches, tends
from restitution.solving.ranges.limits import breaks, limit_at, limits, turning
from restitution.solving.ranges.regions import DRAWS, DRAWS_TRIED, Region
from restitution.solving.ranges.validity import Limitation, bounds_of, defined, with_condition
from restitution.solving.story.letters import is_angle

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
    values: dict[int, sp.Expr] = {}
    for trial, value in values_of_trials(outcome, item.expression, now, f"the {item.kind}"):
        values[id(trial)] = value
        best = _best(replace(outcome, trials=(trial,)), value, name, sign)
        if best is not None:
            candidates.append((trial, best))
    if not candidates:
        raise ContradictionError("no values satisfy all that is told")
    trial, ((candidate, reached, _, _), further) = max(
        candidates, key=lambda each: sign * each[1][0][2]
    )
    if candidate.value.is_infinite:
        grows = "grows" if candidate.value == sp.oo else "falls"
        raise ImpossibleError(f"it has no {item.kind}: it {grows} without bound")
    value = forms.plain(candidate.value, outcome.witnesses(trial))
    if angle:
        value = exact.tidy_angle(value)
    place = forms.bound(candidate.where[name])
    role = setting.roles[name]
    symbol = role.symbol(name)
    there = (
        equation(symbol, from_sympy(place))
        if place.is_infinite
        else display_named(symbol, place, angle=role.kind == "angle")
    )
    where: Layout = there if reached else replace(there, signs=("→", *there.signs[1:]))
    if further:
        others = (display_named(symbol, each, angle=role.kind == "angle") for each in further)
        where = Phrase((where, *others), " or ")
    most = display(value, angle=angle, percentage=item.percentage)
    layout = Phrase((most, Words("when" if reached else "approached as"), where))
    answer = Answer(
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
    own = replace(outcome, trials=(trial,))
    proof, limits = _proved(own, values[id(trial)], candidate, reached, sign)
    if reached and not place.is_infinite:
        limits = (*defined(outcome, trial, (place, value)), *limits)
    answer = with_condition(answer, layout, limits)
    return ItemResult(item, line, item.text, "extremum", (answer,), proof=proof)


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
    outcome: Outcome, value: sp.Expr, best: Candidate, reached: bool, sign: int
) -> tuple[Proof, tuple[Limitation, ...]]:
    """The proof that no value lies beyond an extremum, or equals one that is only approached.

    With it stands what that asks of a coefficient of the data: for e = 1 a speed may be the same
    at all angles. Raises UnsupportedError where some value is beyond for other data.
    """
    region = Region(outcome, next(iter(best.where)))
    if region.formula is None:
        return "undecided", ()
    claim = Relation(sign * (best.value - value), ">=" if reached else ">")
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
    region: Region, value: sp.Expr, candidates: list[Candidate], best: Candidate, data: Sample
) -> tuple[sp.Expr, ...]:
    """The other numbers at which an extremum is reached: both ends, say."""
    places: list[sp.Expr] = []
    for candidate in candidates:
        place = candidate.where[region.letter]
        if place == best.where[region.letter] or not place.is_number or place.is_infinite:
            continue
        if candidate.value != best.value or place in places:
            continue
        number = limit_at(candidate.value, data)
        if number is not None and reaches(region, value, candidate, number, data):
            places.append(place)
    return tuple(places)


def _best(outcome: Outcome, value: sp.Expr, name: str, sign: int) -> Best | None:
    region = Region(outcome, name)
    roles = _roles(outcome)
    if not value.has(region.symbol):
        raise UnsupportedError(f"the quantity does not depend on {name}")
    candidates = _candidates(region, value)
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
        raise UnsupportedError("where the extremum lies depends on the values of the data")
    best, reached, _, drawn = first
    return first, _further(region, value, candidates, best, drawn) if reached else ()


def _roles(outcome: Outcome) -> dict[str, Role]:
    return {**outcome.setting.roles, **outcome.letters.hidden_roles}


def _candidates(region: Region, value: sp.Expr) -> list[Candidate]:
    """What a quantity comes to where it may be greatest or least: it turns, or is at an end."""
    roles = _roles(region.outcome)
    broken = breaks(value, region.symbol, roles)
    points = turning(value, region.symbol, roles) + broken
    points += region.critical
    points += [-sp.oo] * (region.role.low is None) + [sp.oo] * (region.role.high is None)
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
    region: Region, value: sp.Expr, candidates: list[Candidate], drawn: Sample, sign: int
) -> Extreme | None:
    best: Extreme | None = None
    for candidate in candidates:
        number = limit_at(candidate.value, drawn)
        if number is None or not is_near(region, candidate, drawn):
            continue
        reached = reaches(region, value, candidate, number, drawn)
        if not reached and not tends(region, value, candidate, drawn):
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
            seen = at(value, values)
        except (UndefinedError, KeyError):
            continue
        if sign * seen > sign * best[2]:
            raise UnsupportedError("the extremum has no exact form that is found here")
    return best
