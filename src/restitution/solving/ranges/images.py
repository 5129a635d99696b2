"""The values of an expression as letters vary freely: sought at a few points, then proved."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import field
from fractions import Fraction
from functools import cached_property, partial
from itertools import pairwise, product
from types import MappingProxyType

import sympy as sp

from restitution import exact
from restitution.errors import ContradictionError, UnsupportedError
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Proof,
    Relation,
    Verdict,
    joined,
    letters_of,
)
from restitution.oracle.roles import DIRECTION, REAL, TO_180, Role
from restitution.records import dataclass
from restitution.solving.algebra.intervals import (
    INFINITE,
    End,
    Piece,
    inside_of,
    joined_cells,
    reconcile,
    same_values_at,
    with_existence,
)
from restitution.solving.algebra.numbers import (
    Sample,
    angle_at,
    at,
    draw,
    number_of,
    sample,
    sign_beyond,
)
from restitution.solving.equations.part import Outcome
from restitution.solving.ranges.limits import TwoForms, breaks, limit_at, limits, turning
from restitution.solving.ranges.regions import DRAWS, DRAWS_TRIED, ROUNDS, Region
from restitution.solving.ranges.zeros import zeros


@dataclass(frozen=True)
class Candidate:
    """A value that may bound an image, with the letters' values there; reached or approached.

    ``sides`` tells from which side (1 is from above) a letter has to come to its value.
    """

    value: sp.Expr
    where: Mapping[str, sp.Expr]
    sides: Mapping[str, int] = field(default_factory=dict)


TRIED = 60
"""Random places at which a value is worked out."""


MOST_LOOKED_AT = 12
"""Of more candidates the values close to them are not worked out."""


OTHERS_TRIED = 12
"""Values of the data at which intervals that are not proved are looked for again."""


PAIRS = 6
HALVINGS = 40
CLOSE = 10**6
"""So many ways between two places are halved, each so often, to find a value between two others."""


Seen = tuple[Enclosed, Sample]
"""A value that occurs, and the running letters there."""


Border = tuple[Enclosed, sp.Expr, bool]
"""A value that may bound an image, in numbers and as it is, and whether it occurs."""


class Image:
    """The values of an expression: intervals, sought at a few values of the data, then proved.

    ``proof`` tells after `pieces` what it rests on.
    """

    def __init__(
        self,
        outcome: Outcome,
        value: TwoForms,
        free: list[str],
        angle: bool,
    ) -> None:
        self.value, self.whole, self.free = value.textbook, value.whole, free
        self.region = Region(outcome, free[0], tuple(free[1:]))
        self.region.free = tuple(free[1:])  # to the value all of them matter
        self.candidates = list(_candidates(outcome, self.value, free, self.region))
        self.angle = angle
        self.proof: Proof = "undecided"
        self.known: list[Point] = []  # places that are known to be possible
        self.role, self.roles = REAL, self.region.roles
        self.data, self.given = self.region.data, self.region.given
        self.formula, self.of_data = self.region.formula, self.region.of_data
        running = {self.roles[name].symbol(name) for name in free}
        ends = (candidate.value for candidate in self.candidates)
        self.critical_groups = [[end for end in ends if not end.free_symbols & running]]

    def pieces(self) -> list[Piece]:
        """The intervals. Raises ContradictionError where nothing is possible."""
        shapes = self.shapes
        if not shapes:
            raise ContradictionError("no values satisfy all that is told")
        for _ in range(ROUNDS):
            pieces = reconcile(shapes)
            verdict = self.proved(pieces)
            self.proof = verdict.proof if verdict else "undecided"
            if verdict.answer != "refuted" or verdict.witness is None:
                break
            self.known.append(verdict.witness)
            drawn = self.region._drawn(verdict.witness)
            shape = self._shape(drawn)
            if shape is None or shape in shapes:
                break
            # With no data, all that is known is of the same values.
            shapes = [*shapes, shape] if drawn else [shape]
        if self.proof == "undecided":
            shapes = [*shapes, *self._others(reconcile(shapes))]
        return reconcile(shapes)

    def _others(self, pieces: Sequence[Piece]) -> Iterator[tuple[list[Piece], Sample]]:
        """Values of the data for which intervals that are not proved are seen to be others."""
        data, rng = self.region.data(), random.Random(53)
        for number in range(OTHERS_TRIED if data else 0):
            drawn = sample(data, self.region.roles, rng, number % 3 == 2)
            shape = self._shape(drawn)
            if shape is not None and not same_values_at(shape[0], pieces, drawn):
                yield shape
                return

    @cached_property
    def shapes(self) -> list[tuple[list[Piece], Sample]]:
        """The intervals for some values of the data."""
        data = self.region.data()
        rng = random.Random(23)
        shapes: list[tuple[list[Piece], Sample]] = []
        for _ in range(DRAWS_TRIED if data else 1):
            shape = self._shape(sample(data, self.region.roles, rng))
            if shape is not None:
                shapes.append(shape)
            if len(shapes) == DRAWS:
                break
        if shapes or self.region.formula is None:
            return shapes
        possible = Oracle(self.region.roles, (self.region.formula,)).possible
        if possible.witness is None:
            return []
        self.known.append(possible.witness)
        shape = self._shape(self.region._drawn(possible.witness))
        return [] if shape is None else [shape]

    def pieces_at(
        self, drawn: Sample, put: Mapping[sp.Symbol, sp.Expr] = MappingProxyType({})
    ) -> list[Piece]:
        """The intervals for these values of the data, or none; ``put`` has some exactly.

        What an expression comes to may be another thing there than next to it.
        """
        candidates = None
        if put and self.value.has(*put):
            value = self.value.xreplace(put)
            candidates = _candidates(self.region.outcome, value, self.free, self.region)
        shape = self._shape(drawn, candidates)
        return [] if shape is None else shape[0]

    def _shape(
        self, drawn: Sample, candidates: Sequence[Candidate] | None = None
    ) -> tuple[list[Piece], Sample] | None:
        """The intervals for some values of the data, between candidates next to each other."""
        candidates = self.candidates if candidates is None else candidates
        seen = self._seen(drawn)
        if not seen:
            return None
        seen += self._seen_near(candidates, drawn)
        borders = self._borders(candidates, seen, drawn)
        numbers = [number for number, _, _ in borders]
        values = [value for value, _ in seen]
        if not borders or min(values) < numbers[0] or max(values) > numbers[-1]:
            raise UnsupportedError("the ends of this range have no exact form that is found here")
        gaps = [
            any(low < value < high for value in values) or self._meets(low, high, seen, drawn)
            for low, high in pairwise(numbers)
        ]
        around = [False, *gaps, False]
        cells: list[tuple[sp.Expr | None, bool]] = [(None, False)]
        for n, (number, end, reached) in enumerate(borders):
            within = around[n] and around[n + 1] and not end.is_infinite
            inside = reached or (within and self._occurs(number, end, seen, drawn))
            cells += [(end, inside), (None, around[n + 1])]
        return joined_cells(cells), drawn

    def _borders(
        self, candidates: Sequence[Candidate], seen: Sequence[Seen], drawn: Sample
    ) -> list[Border]:
        """The candidates in order, and which of them are reached."""
        borders: list[Border] = []
        for candidate in candidates:
            number = limit_at(candidate.value, drawn)
            if number is None or not is_near(self.region, candidate, drawn):
                continue
            reached = reaches(self.region, self.whole, candidate, number, drawn) or any(
                not (value - number).sign for value, _ in seen
            )
            end = sp.oo * number.sign if abs(number) == INFINITE else candidate.value
            for n, (other, value, already) in enumerate(borders):
                if not (number - other).sign:
                    borders[n] = (other, end if reached else value, reached or already)
                    break
            else:
                borders.append((number, end, reached))
        return sorted(borders, key=lambda border: border[0])

    def _seen(self, drawn: Sample) -> list[Seen]:
        """Values that do occur, and where: at many random points, and at those that are known."""
        rng = random.Random(29)
        roles = self.region.setting.roles
        points = [{name: draw(roles[name], rng) for name in self.free} for _ in range(TRIED)]
        points += [
            {name: number_of(point[name]) for name in self.free}
            for point in self.known
            if set(self.free) <= set(point)
        ]
        seen = []
        for point in points:
            value = self._value_at({**drawn, **point})
            if value is not None:
                seen.append((value, point))
        return seen

    def _seen_near(self, candidates: Sequence[Candidate], drawn: Sample) -> list[Seen]:
        """Values that occur close to candidates: what is beyond the random points shows there."""
        seen: list[Seen] = []
        for candidate in candidates[:MOST_LOOKED_AT]:
            if set(candidate.where) != set(self.free):
                continue
            for point in _nearby(self.region, candidate, drawn):
                with suppress(UndefinedError, KeyError):
                    seen.append((at(self.value, point), {n: point[n] for n in self.free}))
        return seen

    def _value_at(self, values: Sample) -> Enclosed | None:
        """The value at some values of all letters; None where they are not possible."""
        if not self.region._possible(values):
            return None
        try:
            return angle_at(self.whole, values)
        except (UndefinedError, KeyError):
            return None

    def _meets(self, low: Enclosed, high: Enclosed, seen: Sequence[Seen], drawn: Sample) -> bool:
        """Whether a value between two occurs on the way from a place of less to one of more."""
        return any(
            low < value < high
            for pair in _nearest_pairs(seen, low, high)
            for value, _ in self._halved(pair, low, high, drawn)
        )

    def _occurs(self, number: Enclosed, end: sp.Expr, seen: Sequence[Seen], drawn: Sample) -> bool:
        """Whether a value occurs that has others close to it on both sides."""
        facts = (*self.given, Relation(self.value - end, "="))
        if self.formula is not None:
            with suppress(BeyondError):
                possible = Oracle(self.roles, (*facts, self.formula)).possible
                if possible.answer != "undecided":
                    return possible.answer == "proved"
        for pair in _nearest_pairs(seen, number, number):
            met = [*pair, *self._halved(pair, number, number, drawn)]
            value, place = met[-1]
            if len(met) < HALVINGS + 2 and (value - number).sign:
                continue  # not every place on the way is possible
            least, most = (
                min(abs(value - number) for value, _ in met if side * (value - number) >= 0)
                for side in (1, -1)
            )
            if least + most < abs(pair[1][0] - pair[0][0]) / CLOSE and not any(
                self._is_close(candidate, place, drawn) for candidate in self.candidates
            ):
                return True
        return False

    def _is_close(self, candidate: Candidate, place: Sample, drawn: Sample) -> bool:
        """Whether a place is the candidate's, or next to it."""
        values = _numbers(self.region, candidate, {**place, **drawn})
        return values is not None and all(
            abs(values[name] - place[name]) < Fraction(1, CLOSE) for name in self.free
        )

    def _halved(
        self, pair: tuple[Seen, Seen], low: Enclosed, high: Enclosed, drawn: Sample
    ) -> Iterator[Seen]:
        """Values on the way from a place of less than two numbers to one of more."""
        (_, start), (_, end) = pair
        for _ in range(HALVINGS):
            middle = {name: (start[name] + end[name]) / 2 for name in self.free}
            value = self._value_at({**drawn, **middle})
            if value is None:
                return
            yield value, middle
            if value <= low:
                start = middle
            elif value >= high:
                end = middle
            else:
                return

    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict:
        """Whether just these values occur, whatever the data are; ``more`` are facts of them."""
        for form, ends, role in self._forms(pieces, more):
            verdict = self._proved(form, ends, role, more)
            if verdict.answer != "undecided":
                return verdict
        return Verdict("undecided", "undecided")

    def _forms(
        self, pieces: Sequence[Piece], more: Sequence[Formula]
    ) -> Iterator[tuple[sp.Expr, Sequence[Piece], Role]]:
        """What grows or falls with the value, and the values of that: one may be decided sooner.

        A textbook form has no value at a pole, where the angle has one.
        """
        if not self.angle:
            yield self.value, pieces, REAL
            return
        role = _role_of_angle(pieces)
        if not self._has_poles:
            yield self.value, pieces, role
        is_never_negative = partial(self._is_never_negative, more=more)
        tangent = _tangent_of(self.value, pieces, is_never_negative)
        if tangent is not None:
            yield *tangent, REAL
        cosine = _square_of_cosine(self.whole, pieces, is_never_negative)
        if cosine is not None:
            yield *cosine, REAL
        if self._has_poles:
            yield self.whole, pieces, role

    @cached_property
    def _has_poles(self) -> bool:
        symbols = [self.roles[name].symbol(name) for name in self.free]
        return any(breaks(self.value, symbol, self.roles) for symbol in symbols)

    def _is_never_negative(self, value: sp.Expr, more: Sequence[Formula]) -> bool:
        """Whether a value is proved to be 0 or more, for all that is allowed."""
        formula = self.region.formula
        if value.is_nonnegative or formula is None:
            return bool(value.is_nonnegative)
        try:
            return bool(Oracle(self.region.roles, (*more, formula)).decide(Relation(value, ">=")))
        except BeyondError:
            return False

    def _proved(
        self, value: sp.Expr, pieces: Sequence[Piece], role: Role, more: Sequence[Formula]
    ) -> Verdict:
        """Whether just some values of an expression occur, whatever the data are."""
        formula = self.region.formula
        if formula is None:
            return Verdict("undecided", "undecided")
        roles = {**self.region.roles, _NAME: role}
        symbol = role.symbol(_NAME)
        # What is asked of the data alone holds whether or not a value occurs.
        of_data = tuple(
            other
            for other in (formula.parts if isinstance(formula, All) else (formula,))
            if letters_of(other) and not letters_of(other) & set(self.free)
        )
        try:
            inside = with_existence(inside_of(value, pieces), pieces)
            outer = Oracle(roles, (*more, formula)).decide(inside)
            if not outer:
                return outer
            inner = Oracle(roles, (*more, *of_data, inside_of(symbol, pieces))).decide_some(
                joined((formula, Relation(value - symbol, "="))), frozenset(self.free)
            )
        except BeyondError:
            return Verdict("undecided", "undecided")
        return inner


_NAME = "value sought"  # no name that a letter can have


def _role_of_angle(pieces: Sequence[Piece]) -> Role:
    """What an angle may be that lies in some intervals; the narrower, the sooner it is decided."""
    plain = [end.value for piece in pieces for end in piece if end.value.is_number]
    if any(at(x, {}) < 0 for x in plain):
        return DIRECTION
    if len(plain) == 2 * len(pieces) and all(at(x, {}) < at(sp.pi / 2, {}) for x in plain):
        return Role("angle", sp.Integer(0), sp.pi / 2, (True, False))
    return TO_180


def _tangent_of(
    value: sp.Expr, pieces: Sequence[Piece], is_never_negative: Callable[[sp.Expr], bool]
) -> tuple[sp.Expr, list[Piece]] | None:
    """What stands in the inverse tangent of which an angle is made, with its values.

    It grows with that, or falls: ``180° − arctan(4/(3e))`` is ``90° + arctan(3e/4)``, also where e
    is 0 and the direction 90°. None of another angle.
    """
    whole, rest = value.as_independent(*value.free_symbols, as_Add=True)
    factor, arc = rest.as_coeff_Mul()
    if factor not in (1, -1) or not isinstance(arc, sp.atan) or whole.free_symbols:
        return None
    tangent = arc.args[0]
    above, below = sp.fraction(sp.together(tangent))
    if above.is_number and below.free_symbols and is_never_negative(below):
        # The reciprocal may be 0: then the angle is the right angle to which the arc comes.
        whole += factor * sp.sign(above) * sp.pi / 2
        tangent, factor = below / above, -factor
    parts: list[Piece] = []
    for piece in pieces:
        own = [exact.tidy_angle((end.value - whole) * factor) for end in piece]
        tangents = [_tangent_at(value, end.closed) for value, end in zip(own, piece, strict=True)]
        ends = [
            End(value, end.closed)
            for value, end in zip(tangents, piece, strict=True)
            if value is not None
        ]
        if len(ends) < 2:
            return None
        parts.append((ends[0], ends[1]) if factor == 1 else (ends[1], ends[0]))
    return tangent, parts[::factor]


def _square_of_cosine(
    whole: sp.Expr, pieces: Sequence[Piece], is_never_negative: Callable[[sp.Expr], bool]
) -> tuple[sp.Expr, list[Piece]] | None:
    """The product cos θ |cos θ| for the angle θ of two vectors, with its values.

    It falls as θ grows, and has a value at 0°, 90° and 180° too, without a root in it.
    """
    if not isinstance(whole, sp.atan2) or not is_never_negative(whole.args[0]):
        return None
    above, along = whole.args
    size = along if is_never_negative(along) else sp.Abs(along)
    parts: list[Piece] = []
    for low, high in pieces:
        cosines = (exact.tidy(sp.cos(end.value)) for end in (high, low))
        ends = [
            End(exact.tidy(cosine * sp.Abs(cosine)), end.closed)
            for cosine, end in zip(cosines, (high, low), strict=True)
        ]
        parts.append((ends[0], ends[1]))
    return along * size / (along**2 + above**2), parts[::-1]


def _tangent_at(end: sp.Expr, closed: bool) -> sp.Expr | None:
    """The tangent of an end up to a right angle, which is reached at no arctangent."""
    if end.free_symbols:
        return end.args[0] if isinstance(end, sp.atan) else None
    if abs(end) == sp.pi / 2:
        return None if closed else sp.sign(end) * sp.oo
    return None if abs(at(end, {})) >= at(sp.pi / 2, {}) else exact.tidy(sp.tan(end))


def _nearest_pairs(seen: Sequence[Seen], low: Enclosed, high: Enclosed) -> list[tuple[Seen, Seen]]:
    """Places of values up to one number and from another on, the nearest pairs first."""
    below = [point for point in seen if point[0] <= low]
    above = [point for point in seen if point[0] >= high]

    def distance(pair: tuple[Seen, Seen]) -> float:
        (_, one), (_, other) = pair
        return sum((float(one[name]) - float(other[name])) ** 2 for name in one)

    return sorted(product(below, above), key=distance)[:PAIRS]


def _candidates(
    outcome: Outcome, value: sp.Expr, free: list[str], region: Region
) -> list[Candidate]:
    """Stationary points and ends, letter by letter."""
    roles = outcome.setting.roles
    atoms = region._kept_atoms
    open_: list[Candidate] = [Candidate(value, {}), *_at_poles(value, free, roles)]
    for name in free:
        symbol = roles[name].symbol(name)
        after: list[Candidate] = []
        for candidate in open_:
            expression = candidate.value
            if not expression.has(symbol):
                after.append(candidate)
                continue
            points = turning(expression, symbol, roles)
            broken = breaks(expression, symbol, roles)
            points += broken
            role = roles[name]
            points += [-sp.oo if role.low is None else role.low]
            points += [sp.oo if role.high is None else role.high]
            if expression.xreplace({symbol: 2 * symbol}) == expression:
                # v/|v| depends on the sign alone, and so it is reached in the midst of a letter.
                points += [sp.Integer(1), sp.Integer(-1)]
            for atom in atoms:
                put = {roles[n].symbol(n): v for n, v in candidate.where.items()}
                try:
                    own = atom.xreplace(put)
                except (TypeError, ZeroDivisionError):
                    continue
                if own.has(symbol):
                    points += zeros([own], [symbol], roles, name)
            for point in dict.fromkeys(points):
                where = {
                    n: sp.sympify(v, strict=True).xreplace({symbol: point})
                    for n, v in candidate.where.items()
                }
                sided = limits(expression, symbol, point, role, broken=point in broken)
                for reduced, sides in sided:
                    after.append(
                        Candidate(reduced, {**where, name: point}, {**candidate.sides, **sides})
                    )
        open_ = after[:80]
    return open_


def _at_poles(
    value: sp.Expr, free: Sequence[str], roles: Mapping[str, Role]
) -> Iterator[Candidate]:
    """Limits at a pole in one of several letters, if they are the same whatever the others are."""
    for name in free[1:]:
        symbol = roles[name].symbol(name)
        others = {roles[other].symbol(other) for other in free} - {symbol}
        for point in breaks(value, symbol, roles):
            if point.free_symbols & others:
                continue
            for reduced, sides in limits(value, symbol, point, roles[name], broken=True):
                if not reduced.free_symbols & others:
                    yield Candidate(reduced, {name: point}, sides)


def _numbers(region: Region, candidate: Candidate, drawn: Sample) -> Sample | None:
    values = dict(drawn)
    try:
        for name, point in candidate.where.items():
            if point in (sp.oo, -sp.oo):
                return None
            values[name] = at(point, values)
    except (UndefinedError, KeyError):
        return None
    return values


def is_reached(region: Region, candidate: Candidate, drawn: Sample) -> bool:
    """Whether the letters may have the values at which a candidate lies."""
    if candidate.value.has(sp.oo, -sp.oo):
        return False
    for known in _others(region, candidate, drawn):
        values = _numbers(region, candidate, known)
        if values is not None and region._possible(values):
            return True
    return False


def reaches(
    region: Region, value: sp.Expr, candidate: Candidate, number: Enclosed, drawn: Sample
) -> bool:
    """Whether a candidate's value occurs at its place, and is not only come near to there.

    The value is as it is worked out, which tells an angle at a pole of its tangent.
    """
    if not is_reached(region, candidate, drawn):
        return False
    for known in _others(region, candidate, drawn):
        values = _numbers(region, candidate, known)
        try:
            if values is None:
                continue
            if value.has(sp.atan2):
                if not (angle_at(value, values) - number).sign:
                    return True
            elif not sign_beyond(value, values, number):
                return True
        except (UndefinedError, KeyError):
            if value.has(sp.atan2):
                continue
            # An angle at a pole of its tangent, which it has as 90° if it comes near to that.
            return not candidate.sides and tends(region, value, candidate, drawn)
    return False


def is_near(region: Region, candidate: Candidate, drawn: Sample) -> bool:
    """Whether allowed values come as near to a candidate's place as one likes."""
    return is_reached(region, candidate, drawn) or any(
        _is_near(region, candidate, known) for known in _others(region, candidate, drawn)
    )


def _others(region: Region, candidate: Candidate, drawn: Sample) -> list[Sample]:
    """The data with a few values of the running letters to which a candidate gives none.

    An offset of 0 is a place for every radius, and yet a radius is needed to try it.
    """
    names = [
        name
        for name in (region.letter, *region.free)
        if name not in candidate.where and name not in drawn
    ]
    if not names:
        return [drawn]
    rng = random.Random(31)
    roles = region.setting.roles
    return [{**drawn, **{name: draw(roles[name], rng) for name in names}} for _ in range(8)]


def _is_near(region: Region, candidate: Candidate, drawn: Sample) -> bool:
    return any(True for _ in _nearby(region, candidate, drawn))


def tends(region: Region, value: sp.Expr, candidate: Candidate, drawn: Sample) -> bool:
    """Whether a quantity is seen to come near to a candidate's value at its place.

    Of what a limit is, the sign of something in the data may decide.
    """
    number, near = limit_at(candidate.value, drawn), list(_nearby(region, candidate, drawn))
    if number is None or abs(number) == INFINITE or not near:
        return True
    for values in near:
        try:
            there = at(value, values)
            if there.sign * number.sign < 0:
                continue  # however small both are, it is the limit of another form
            if abs(float(there - number)) < _CLOSE * (1 + abs(float(number))):
                return True
        except (UndefinedError, KeyError):
            continue
    return False


# A limit is not reached; values at a place 10⁻⁷ from its own are this near to it.
_CLOSE = 1e-2


def _nearby(region: Region, candidate: Candidate, drawn: Sample) -> Iterator[Sample]:
    """Allowed values that are as near to a candidate's place as is looked at."""
    values: Sample = dict(drawn)
    names = list(candidate.where)
    for step in (at(sp.Rational(1, 10**7), {}),):
        for n in range(3 ** len(names)):
            trial = dict(values)
            code = n
            ok = True
            for name in names:
                shift = (code % 3) - 1
                code //= 3
                ok = ok and shift == candidate.sides.get(name, shift)
                point = candidate.where[name]
                if point == sp.oo:
                    trial[name] = at(sp.Integer(10**7), {}) * (1 + shift * step)
                elif point == -sp.oo:
                    trial[name] = -at(sp.Integer(10**7), {}) * (1 + shift * step)
                else:
                    try:
                        trial[name] = at(point, trial) + shift * step
                    except (UndefinedError, KeyError):
                        ok = False
                        break
            if ok and region._possible(trial):
                yield trial
