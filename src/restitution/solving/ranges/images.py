"""The values of an expression as letters vary freely: sought at a few points, then proved."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

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
from restitution.solving.algebra.intervals import End, Piece, inside_of, reconcile
from restitution.solving.algebra.numbers import Sample, at, draw, number_of, sample
from restitution.solving.equations.part import Outcome
from restitution.solving.ranges.limits import limit_at, limits, turning
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


class Image:
    """The values of an expression: one interval, sought at a few values of the data, then proved.

    ``proof`` tells after `pieces` what it rests on.
    """

    def __init__(
        self,
        outcome: Outcome,
        value: sp.Expr,
        free: list[str],
        angle: bool,
        region: Region | None = None,
    ) -> None:
        self.value, self.free = value, free
        self.region = region or Region(outcome, free[0], tuple(free[1:]))
        self.candidates = list(_candidates(outcome, value, free, self.region))
        self.angle = angle
        self.proof: Proof = "undecided"
        self.role, self.roles = REAL, self.region.roles
        self.data, self.given = self.region.data, self.region.given
        self.formula = self.region.formula
        running = {self.roles[name].symbol(name) for name in free}
        ends = (candidate.value for candidate in self.candidates)
        self.critical = [end for end in ends if not end.free_symbols & running]

    def pieces(self) -> list[Piece]:
        """The interval. Raises ContradictionError where nothing is possible."""
        shapes = self.shapes
        if not shapes:
            raise ContradictionError("no values satisfy all that is told")
        for _ in range(ROUNDS):
            pieces = reconcile(shapes)
            verdict = self.proved(pieces)
            self.proof = verdict.proof if verdict else "undecided"
            if verdict.answer != "refuted" or verdict.witness is None:
                break
            shape = self._shape(self.region._drawn(verdict.witness), verdict.witness)
            if shape is None or shape in shapes:
                break
            shapes.append(shape)
        return reconcile(shapes)

    @cached_property
    def shapes(self) -> list[tuple[list[Piece], Sample]]:
        """The interval for some values of the data."""
        data = self.region.data()
        rng = random.Random(23)
        shapes: list[tuple[list[Piece], Sample]] = []
        for _ in range(DRAWS_TRIED if data else 1):
            shape = self._shape(sample(data, self.region.roles, rng), {})
            if shape is not None:
                shapes.append(shape)
            if len(shapes) == DRAWS:
                break
        if shapes or self.region.formula is None:
            return shapes
        possible = Oracle(self.region.roles, (self.region.formula,)).possible
        if possible.witness is None:
            return []
        shape = self._shape(self.region._drawn(possible.witness), possible.witness)
        return [] if shape is None else [shape]

    def pieces_at(self, drawn: Sample) -> list[Piece]:
        """The interval for these values of the data, or none."""
        shape = self._shape(drawn, {})
        return [] if shape is None else shape[0]

    def _shape(self, drawn: Sample, point: Point) -> tuple[list[Piece], Sample] | None:
        """The interval for some values of the data; ``point`` has values that do occur."""
        inside = _seen(self.region, self.value, self.free, drawn, point)
        if not inside:
            return None
        ends = []
        for sign, bound in ((-1, min(inside)), (1, max(inside))):
            best = _bounding(self.region, self.candidates, drawn, sign, bound)
            if best is None:
                raise UnsupportedError(
                    "the ends of this range have no exact form that is found here"
                )
            ends.append(End(best.value, is_reached(self.region, best, drawn)))
        return [(ends[0], ends[1])], drawn

    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict:
        """Whether just these values occur, whatever the data are; ``more`` are facts of them."""
        role = _role_of_angle(pieces) if self.angle else REAL
        verdict = self._proved(self.value, pieces, role, more)
        arc = _tangent_of(self.value, pieces) if self.angle else None
        if verdict.answer == "undecided" and arc is not None:
            return self._proved(*arc, REAL, more)
        return verdict

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
            each
            for each in (formula.parts if isinstance(formula, All) else (formula,))
            if letters_of(each) and not letters_of(each) & set(self.free)
        )
        try:
            outer = Oracle(roles, (*more, formula)).decide(inside_of(value, pieces))
            if not outer:
                return outer
            inner = Oracle(roles, (*more, *of_data, inside_of(symbol, pieces))).decide_some(
                joined((formula, Relation(value - symbol, "="))), frozenset(self.free)
            )
        except BeyondError:
            return Verdict("undecided", "undecided")
        return inner


@dataclass
class Within(Region):
    """The values of a letter in one of the pieces of its range, of which the ends are numbers."""

    piece: Piece = (End(sp.Integer(0), True), End(sp.Integer(0), True))

    def _atoms(self) -> list[sp.Expr]:
        ends = [each.value for each in self.piece if each.value.is_finite]
        return [*super()._atoms(), *(self.symbol - end for end in ends)]

    @cached_property
    def formula(self) -> Formula | None:
        """What is asked of the letter: what the region does, and that it is in the piece."""
        whole = Region(self.outcome, self.letter, self.free).formula
        return None if whole is None else joined((whole, inside_of(self.symbol, [self.piece])))

    def _possible(self, values: Sample) -> bool:
        own = values.get(self.letter)
        if own is None:
            return False
        for end, sense in zip(self.piece, (1, -1), strict=True):
            if not end.value.is_finite:
                continue
            beyond = sense * (own - at(end.value, {}))
            if beyond.sign < 0 or (beyond.sign == 0 and not end.closed):
                return False
        return super()._possible(values)


def in_pieces(outcome: Outcome, value: sp.Expr, name: str, angle: bool) -> list[Image]:
    """The images of the pieces in which a letter may be, where there are several.

    Of all values at once the image would be one interval, and what is left out would not be seen.
    """
    pieces = Region(outcome, name).pieces()
    ends = [end.value for piece in pieces for end in piece]
    if len(pieces) < 2 or any(end.free_symbols for end in ends):
        return []
    return [
        Image(outcome, value, [name], angle, Within(outcome, name, piece=piece)) for piece in pieces
    ]


_NAME = "value sought"  # no name that a letter can have


def _role_of_angle(pieces: Sequence[Piece]) -> Role:
    """What an angle may be that lies in some intervals; the narrower, the sooner it is decided."""
    plain = [end.value for piece in pieces for end in piece if end.value.is_number]
    if any(at(x, {}) < 0 for x in plain):
        return DIRECTION
    if len(plain) == 2 * len(pieces) and all(at(x, {}) < at(sp.pi / 2, {}) for x in plain):
        return Role("angle", sp.Integer(0), sp.pi / 2, (True, False))
    return TO_180


def _tangent_of(value: sp.Expr, pieces: Sequence[Piece]) -> tuple[sp.Expr, list[Piece]] | None:
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
    if above.is_number and below.free_symbols and below.is_nonnegative:
        # The reciprocal may be 0: then the angle is the right angle to which the arc comes.
        whole += factor * sp.sign(above) * sp.pi / 2
        tangent, factor = below / above, -factor
    parts: list[Piece] = []
    for piece in pieces:
        own = [exact.tidy_angle((end.value - whole) * factor) for end in piece]
        if any(each.free_symbols or abs(at(each, {})) >= at(sp.pi / 2, {}) for each in own):
            return None
        ends = [
            End(exact.tidy(sp.tan(each)), end.closed) for each, end in zip(own, piece, strict=True)
        ]
        parts.append((ends[0], ends[1]) if factor == 1 else (ends[1], ends[0]))
    return tangent, parts[::factor]


def _bounding(
    region: Region, candidates: list[Candidate], drawn: Sample, sign: int, bound: Enclosed
) -> Candidate | None:
    """The candidate next beyond the values seen, above (sign 1) or below (-1) them."""
    best: tuple[Enclosed, Candidate] | None = None
    for candidate in candidates:
        number = limit_at(candidate.value, drawn)
        if number is None:
            continue
        if sign * number < sign * bound or not is_near(region, candidate, drawn):
            continue
        nearer = best is None or sign * number < sign * best[0]
        if nearer or (
            best is not None
            and not (number - best[0]).sign
            and is_reached(region, candidate, drawn)
        ):
            best = (number, candidate)
    return None if best is None else best[1]


def _seen(
    region: Region, value: sp.Expr, free: list[str], drawn: Sample, known: Point
) -> list[Enclosed]:
    """Values that do occur: at many random points, and at one that is known."""
    rng = random.Random(29)
    seen = []
    points = [{name: draw(region.setting.roles[name], rng) for name in free} for _ in range(60)]
    if known:
        points.append({name: number_of(known[name]) for name in free if name in known})
    for point in points:
        values = {**drawn, **point}
        if not set(free) <= set(values):
            continue
        if region._possible(values):
            try:
                seen.append(at(value, values))
            except (UndefinedError, KeyError):
                continue
    return seen


def _candidates(
    outcome: Outcome, value: sp.Expr, free: list[str], region: Region
) -> list[Candidate]:
    """Stationary points and ends, letter by letter."""
    roles = outcome.setting.roles
    atoms = region._kept_atoms
    open_: list[Candidate] = [Candidate(value, {})]
    for name in free:
        symbol = roles[name].symbol(name)
        after: list[Candidate] = []
        for candidate in open_:
            expression = candidate.value
            if not expression.has(symbol):
                after.append(candidate)
                continue
            points = turning(expression, symbol, roles)
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
                for reduced, sides in limits(expression, symbol, point, role):
                    after.append(
                        Candidate(reduced, {**where, name: point}, {**candidate.sides, **sides})
                    )
        open_ = after[:80]
    return open_


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
    if candidate.value in (sp.oo, -sp.oo):
        return False
    for known in _others(region, candidate, drawn):
        values = _numbers(region, candidate, known)
        if values is not None and region._possible(values):
            return True
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
                return True
    return False
