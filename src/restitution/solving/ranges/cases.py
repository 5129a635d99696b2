"""A range whose form depends on the data: one form for each interval of one letter of the data.

Where the form changes, two of its ends meet, or an end begins to have a value. Those borders are
found exactly; between them, and at them, the form is sought at one point and then proved.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, pairwise
from typing import Protocol

import sympy as sp

from restitution.errors import RestitutionError, UnsupportedError
from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle import BeyondError, Formula, Oracle, Proof, Relation, Verdict, joined
from restitution.oracle.roles import Role
from restitution.records import dataclass
from restitution.solving.algebra import forms
from restitution.solving.algebra.intervals import (
    End,
    Piece,
    existence,
    inside_of,
    same_at,
    to_set,
    with_existence,
)
from restitution.solving.algebra.numbers import Sample, at, bound, sample
from restitution.solving.ranges.zeros import deciding, zeros

KINDS = ("positive", "real", "angle", "restitution")
MOST_BORDERS = 10
MOST_ENDS = 8
_NO_NUMBERS = (sp.oo, sp.nan, sp.zoo)
SAMPLES = 4


class Family(Protocol):
    """Intervals of values that depend on data: of a letter (`Region`) or of a quantity.

    ``shapes`` are their forms at some values of the data, and ``critical`` all that may be an end,
    in groups of those that may meet; the signs of those ``of_data`` decide too, whatever varies;
    ``given`` are facts of the data, and ``formula`` is all that
    is asked, if letters can say it.
    """

    @property
    def role(self) -> Role: ...
    @property
    def shapes(self) -> list[tuple[list[Piece], Sample]]: ...
    @property
    def critical_groups(self) -> Sequence[Sequence[sp.Expr]]: ...
    @property
    def of_data(self) -> Sequence[sp.Expr]: ...
    @property
    def roles(self) -> Mapping[str, Role]: ...
    @property
    def given(self) -> tuple[Formula, ...]: ...
    @property
    def formula(self) -> Formula | None: ...
    def data(self) -> list[str]: ...
    def pieces_at(self, drawn: Sample, put: Mapping[sp.Symbol, sp.Expr] = ...) -> list[Piece]: ...
    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict: ...


@dataclass(frozen=True)
class Case:
    """The form of a range for some values of one letter of the data.

    ``covered`` tells whether the cases of this letter, and those of which it is proved that nothing
    is possible there, are all that there are.
    """

    letter: str
    where: Piece
    pieces: tuple[Piece, ...]
    proof: Proof
    covered: bool = True

    @property
    def values(self) -> sp.Set:
        """The values of the letter of the data."""
        return to_set([self.where])


def cases(region: Family) -> list[Case]:
    """The forms of a range, each proved; none, where that is not possible.

    For the values of the data that no case has, nothing is possible; where that is not proved, the
    forms are not. Forms whose ends have values for all data come before others: u < 1/(1 − e) says
    nothing for e = 1.
    """
    partial: list[Case] = []
    groups = groups_of_ends(region)
    names = symbol_names(*(end for ends in groups for end in ends), *region.of_data)
    names &= set(region.data())
    # For e = 0 or e = 1 a range may have another form, whatever its ends are.
    names |= {name for name in region.data() if region.roles[name].kind == "restitution"}
    for name in sorted(names, key=lambda n: (KINDS.index(region.roles[n].kind), n)):
        borders = _borders(region, groups, name)
        if 0 < len(borders) <= MOST_BORDERS:
            try:
                cases_ = _along(region, name, borders)
            except (RestitutionError, BeyondError, UndefinedError):
                continue
            complete = bool(cases_) and _is_complete(region, cases_)
            if complete and all(_always_exists(region, case) for case in cases_):
                return cases_
            if cases_ and not partial:
                partial = cases_ if complete else _not_proved(cases_)
    return partial


def _is_complete(region: Family, cases_: Sequence[Case]) -> bool:
    """Whether it is proved that nothing is possible for the data that no case has.

    Borders have to have values for all data for which something is possible.
    """
    if cases_[0].covered or region.formula is None:
        return cases_[0].covered
    symbol = region.roles[cases_[0].letter].symbol(cases_[0].letter)
    oracle = Oracle(region.roles, (*region.given, region.formula))
    where = [case.where for case in cases_]
    try:
        return bool(oracle.decide(with_existence(inside_of(symbol, where), where)))
    except BeyondError:
        return False


def _not_proved(cases_: Sequence[Case]) -> list[Case]:
    return [replace(case, proof="undecided") for case in cases_]


def _always_exists(region: Family, case: Case) -> bool:
    """Whether the ends of a form have values wherever it holds."""
    inside = inside_of(region.roles[case.letter].symbol(case.letter), [case.where])
    oracle = Oracle(region.roles, (*region.given, inside))
    powers = {power for piece in case.pieces for end in piece for power in end.value.atoms(sp.Pow)}
    below = [power.base for power in powers if power.exp.is_negative and power.base.free_symbols]
    return all(oracle.decide(Relation(base, "!=")) for base in below)


def _finite_ends(region: Family, critical: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The ends of intervals that may meet: those that they have somewhere, then others."""
    occurring = {end.value for pieces, _ in region.shapes for piece in pieces for end in piece}
    ends = occurring if len(region.critical_groups) == 1 else occurring & set(critical)
    ends |= {x for x in (region.role.low, region.role.high) if x is not None}
    more = [x for x in dict.fromkeys(critical) if x not in ends]
    ends |= set(more[: max(0, MOST_ENDS - len(ends))])
    return sorted((end for end in ends if not end.has(*_NO_NUMBERS)), key=sp.default_sort_key)


def groups_of_ends(region: Family) -> list[list[sp.Expr]]:
    """The ends that intervals of a family may have, in groups of those that may meet."""
    return [_finite_ends(region, critical) for critical in region.critical_groups]


def _borders(region: Family, groups: Sequence[Sequence[sp.Expr]], name: str) -> list[sp.Expr]:
    """Where ends meet or cease to have a value, as values of one letter."""
    symbol = region.roles[name].symbol(name)
    changing = [a - b for ends in groups for a, b in combinations(ends, 2)]
    changing += [end for ends in groups for end in ends]
    changing += region.of_data
    borders: list[sp.Expr] = []
    for value in dict.fromkeys(part for x in changing for part in deciding(x)):
        if value.has(symbol):
            borders += [x for x in zeros([value], [symbol], region.roles, name) if x not in borders]
    role = region.roles[name]
    ends_ = [x for x, is_in in zip((role.low, role.high), role.closed, strict=True) if is_in]
    return [*borders, *(x for x in ends_ if x is not None and x not in borders)]


def _along(region: Family, name: str, borders: Sequence[sp.Expr]) -> list[Case]:
    """The forms as one letter of the data grows, or none where one is not proved."""
    drawn, order = _ordered(region, name, borders)
    role = region.roles[name]
    cells = _merged(list(_cells(region, name, role, order, drawn)), drawn, name)
    cases_: list[Case] = []
    covered = _always_in_order(region, name, cells, order)
    for where, pieces in cells:
        inside = inside_of(role.symbol(name), [where])
        if pieces:
            verdict = region.proved(pieces, (inside,))
            if verdict.answer != "proved":
                return []
            put = {role.symbol(name): where[0].value} if where[0].value == where[1].value else {}
            plain = tuple(_plainer(region, inside, piece, put) for piece in pieces)
            cases_.append(Case(name, where, plain, verdict.proof, covered))
        elif not _empty(region, inside):
            return []
    return cases_


def _always_in_order(
    region: Family, name: str, cells: Sequence[Cell], order: Sequence[sp.Expr]
) -> bool:
    """Whether borders have values, and come in this order, for all data that allow anything."""
    given = Oracle(region.roles, region.given)
    facts = () if region.formula is None else (region.formula,)

    def holds(claim: Relation) -> bool:
        if not claim.value.free_symbols:
            return True  # two numbers, put in order
        return bool(given.decide(claim)) or bool(given.with_facts(facts).decide(claim))

    try:
        for border in order:
            for claim in existence([border]):
                if not holds(claim) and not _goes_on(region, name, cells, border, claim):
                    return False
        return all(holds(Relation(b - a, ">=")) for a, b in pairwise(order))
    except BeyondError:
        return False


def _goes_on(
    region: Family, name: str, cells: Sequence[Cell], border: sp.Expr, claim: Relation
) -> bool:
    """Whether a form goes on without end where its border does: k < 3/e says that of e = 0."""
    where, pieces = next(cell for cell in cells if cell[0][1].value == border)
    if claim.operator != "!=" or where[0].value == border:
        return False
    beyond = inside_of(region.roles[name].symbol(name), [(where[0], End(sp.oo, False))])
    facts = (beyond, Relation(claim.value, "="))
    if pieces:
        return bool(region.proved(pieces, facts))
    return _empty(region, joined(facts))


def _plainer(
    region: Family, inside: Formula, piece: Piece, put: Mapping[sp.Symbol, sp.Expr]
) -> Piece:
    """The ends of an interval with a value put in, which the letter of this form alone has.

    There are no bars around what has one sign where the form holds.
    """
    oracle = Oracle(region.roles, (*region.given, inside))
    low, high = (
        End(
            forms.tidy(end.value.xreplace(forms.bars_of(end.value, oracle)).xreplace(put)),
            end.closed,
        )
        if end.value.has(sp.Abs, *put) and not end.value.is_infinite
        else end
        for end in piece
    )
    return low, high


def _empty(region: Family, inside: Formula) -> bool:
    if region.formula is None:
        return False
    facts = (*region.given, inside, region.formula)
    return Oracle(region.roles, facts).possible.answer == "refuted"


def _ordered(region: Family, name: str, borders: Sequence[sp.Expr]) -> tuple[Sample, list[sp.Expr]]:
    """Values of the other data, and the borders in the order that they always seem to have."""
    rng = random.Random(31)
    role = region.roles[name]
    others = [letter for letter in region.data() if letter != name]
    seen: list[tuple[Sample, list[sp.Expr]]] = []
    for _ in range(SAMPLES if others else 1):
        drawn = sample(others, region.roles, rng)
        numbers: list[tuple[Enclosed, sp.Expr]] = []
        for border in borders:
            try:
                value = at(border, drawn)
            except UndefinedError:
                continue
            if _within(value, role) and all((value - n).sign for n, _ in numbers):
                numbers.append((value, border))
        seen.append((drawn, [border for _, border in sorted(numbers, key=lambda pair: pair[0])]))
    if any(order != seen[0][1] for _, order in seen):
        raise UnsupportedError("the form of the range depends on the values of the data")
    return seen[0]


def _within(value: Enclosed, role: Role) -> bool:
    """Whether a letter may have a value, which may be a closed end of its range."""
    low, high = bound(role.low), bound(role.high)
    above = low is None or value > low or (role.closed[0] and not (value - low).sign)
    return above and (high is None or value < high or (role.closed[1] and not (value - high).sign))


Cell = tuple[Piece, list[Piece]]


def _cells(
    region: Family, name: str, role: Role, order: Sequence[sp.Expr], drawn: Sample
) -> Iterator[Cell]:
    """Gaps between borders and the borders by turns, each with the form of the range there."""
    low = End(-sp.oo, False) if role.low is None else End(role.low, role.closed[0])
    last = End(sp.oo, False) if role.high is None else End(role.high, role.closed[1])
    for border in order:
        point = End(border, False)
        if border != low.value:
            yield (low, point), region.pieces_at({**drawn, name: _between(low, point, drawn)})
        yield (
            (End(border, True), End(border, True)),
            region.pieces_at({**drawn, name: at(border, drawn)}, {role.symbol(name): border}),
        )
        low = point
    if low.value == last.value:
        return
    yield (low, last), region.pieces_at({**drawn, name: _between(low, last, drawn)})


def _between(low: End, high: End, drawn: Sample) -> Enclosed:
    if low.value == -sp.oo:
        return Enclosed.of(0) if high.value == sp.oo else at(high.value, drawn) - 1
    if high.value == sp.oo:
        return 2 * at(low.value, drawn) + 1
    return (2 * at(low.value, drawn) + 3 * at(high.value, drawn)) / 5


def _merged(cells: list[Cell], drawn: Sample, name: str) -> list[Cell]:
    """The cells, neighbours of one form as one."""
    merged: list[Cell] = []
    for where, pieces in cells:
        if merged:
            (low, high), known = merged[-1]
            place = None if high.value.is_infinite else {**drawn, name: at(high.value, drawn)}
            point = where[0].value == where[1].value
            if pieces == known or (point and place and same_at(known, pieces, place)):
                merged[-1] = ((low, where[1]), known)
                continue
            was_point = low.value == high.value
            if was_point and place and same_at(pieces, known, place):
                merged[-1] = ((low, where[1]), pieces)
                continue
        merged.append((where, pieces))
    return merged
