"""Points at which lines hold, in numbers, by which candidates are tried."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, islice, product
from typing import Protocol

from sympy.polys.rings import PolyElement

from restitution.explaining.data.setting import Cited, Setting
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.derivation import (
    Derivation,
    Link,
    Move,
    Ref,
    Relation,
    whole_of,
)
from restitution.explaining.lines.generators import AngleKey, Atom, Key
from restitution.explaining.lines.quotients import (
    CONSTANT,
    NotComparableError,
    Plane,
    Quotient,
    is_without,
    without_common,
)
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Letter,
    Quantity,
)
from restitution.oracle.roles import REAL
from restitution.records import dataclass

_POINTS = 3


_CLOSE = 1e-9


_PIVOTS = 4
"""So many choices of what is solved for are tried."""


NEAREST = 8
"""So many lines above are taken in twos."""


Levels = tuple[Quotient | None, Quotient | None]
"""A line as residuals: with the data put in, and with what is given too."""


@dataclass(frozen=True)
class _Source:
    """What a line may come from: a law (``move``) or a line above (``cited``), as a residual."""

    value: Quotient
    link: Link
    move: Move | None = None
    cited: Cited = None  # type: ignore[assignment]


class Traced(Protocol):
    """What a statement gives to the lines of its working."""

    statement: Derivation
    setting: Setting
    facts: list[Cited]
    lets: list[Cited]

    @property
    def directions(self) -> list[Cited]:
        """The lines that tell where something points."""

    def laws_of(self, number: int, names: Iterable[str]) -> Iterator[tuple[Move, Link]]:
        """What some records say of an event, each with its move."""


class Numbers:
    """Laws and lines as polynomials, with the statement's facts put in, tried at random points."""

    def __init__(self, statement: Traced, event: int, records: Sequence[str]) -> None:
        given = {fact.id for fact in statement.statement.facts if fact.kind == "given"}
        data = [fact for fact in statement.facts if fact.ref not in given]
        self.steps = [
            Step(
                statement.setting,
                Move("let"),
                (*entries, *statement.lets, *statement.directions),
                (),
            )
            for entries in (data, statement.facts)
        ]
        self.rules = [
            step.rules((*kept, *statement.lets))
            for step, kept in zip(self.steps, (data, statement.facts), strict=True)
        ]
        self.samples = [_Sample(random.Random(seed)) for seed in range(_POINTS)]
        self.sources: list[list[_Source]] = [[], []]
        self.values: list[list[tuple[int, Quotient, Ref]]] = [[], []]
        for fact in statement.facts:
            if fact.ref in given:
                self.add(fact, levels=(0,))
        laws = list(statement.laws_of(event, records))
        for level in (0, 1):
            for move, law in laws:
                value = self._residual(level, law)
                if value is not None:
                    self.sources[level].append(_Source(value, law, move))

    def _residual(self, level: int, link: Link) -> Quotient | None:
        step = self.steps[level]
        try:
            if link.sign in ("parallel to", "perpendicular to"):
                return None
            value = step.residual(link, self.rules[level])
        except NotComparableError:
            return None
        if isinstance(value, Plane):
            # Both components matter; a fixed combination of them tells a stranger.
            value = value.x + value.y * _SKEW
        return None if value.vanishes else value

    def residual(self, link: Link) -> Levels | None:
        """A line as residuals: with the data put in, and with what is given too."""
        own = self._residual(0, link), self._residual(1, link)
        return None if own == (None, None) else own

    def add(self, cited: Cited, levels: Sequence[int] = (0, 1)) -> None:
        """Takes up a line above, or a fact that is used as one."""
        if not isinstance(cited.relation, Relation) or len(cited.relation.options) != 1:
            return
        for level in levels:
            for link in _flat(cited.relation.only):
                if link.sign != "=":
                    continue
                value = self._residual(level, link)
                if value is not None:
                    self.sources[level].append(_Source(value, link, None, cited))
                self.values[level].extend(
                    (number, own, cited.ref) for number, own in self._as_values(level, link)
                )

    def _as_values(self, level: int, link: Link) -> Iterator[tuple[int, Quotient]]:
        """The generators that a line gives, and their values."""
        world = self.steps[level].world
        if not isinstance(link.left, Letter | Quantity | Apply):
            return
        try:
            left = self.rules[level].put_into(world.value(link.left))
            right = self.rules[level].put_into(world.value(link.right))
        except NotComparableError:
            return
        pairs = [(left, right)]
        if isinstance(left, Plane) and isinstance(right, Plane):
            pairs = [(left.x, right.x), (left.y, right.y)]
        for own, value in pairs:
            if isinstance(own, Plane) or isinstance(value, Plane) or len(own.above) != 1:
                continue
            (monomial,) = own.above
            numbers = [n for n, power in enumerate(monomial) if power]
            if len(numbers) == 1 and monomial[numbers[0]] == 1 and own.above.LC == 1:
                yield numbers[0], value

    def single(self, own: Levels) -> Iterator[_Source]:
        """The laws, then the lines, that vanish where the line does: the newest lines first."""
        for values in (False, True):
            for level in (0, 1):
                there = own[level]
                if there is None:
                    continue
                sources = self.sources[level]
                laws = [source for source in sources if source.move is not None]
                lines = [source for source in reversed(sources) if source.move is None]
                for source in (*lines, *laws):
                    if self._agree(level, there, [source], values):
                        yield source

    def pairs(self, own: Levels) -> Iterator[tuple[_Source, _Source]]:
        """Two lines, a line and a law, or two laws: the line vanishes where both of them do."""
        level, there = _first(own)
        sources = self.sources[level]
        lines = [source for source in reversed(sources) if source.move is None][:NEAREST]
        # Which sign a ratio of components has, only the follower decides.
        laws = [e for e in sources if e.move is not None and not isinstance(e.link.left, Apply)]
        principles = [law for law in laws if law.move is not None and law.move.id == "law"]
        for first, second in (
            *combinations(lines, 2),
            *product(lines, laws),
            *combinations(principles, 2),
        ):
            if self._agree(level, there, [first, second], False):
                yield first, second

    def follows_from_both(self, own: Levels, first: _Source, second: _Source) -> bool:
        """Whether a line is zero, exactly, where two others are: one put into both."""
        level, there = _first(own)
        step = self.steps[level]
        shared = sorted(_linear(step.world, first.value) & _linear(step.world, there)) or sorted(
            _linear(step.world, first.value)
        )
        for number in shared:
            if step.signs.of(_slope(first.value, number), sure=False) is None:
                continue
            value = _solved_for(first.value, number)
            rules = Rules(step.world, [(number, 1, value)])
            try:
                line, other = (rules.put_into(quotient) for quotient in (there, second.value))
            except NotComparableError:
                continue
            assert isinstance(line, Quotient)
            assert isinstance(other, Quotient)
            if line.vanishes:
                return True
            if other.vanishes:
                continue
            _, rest = without_common(line.above, other.above)
            if step.signs.of(Quotient(rest, rest.ring.one), sure=False) is not None:
                return True
        return False

    def _agree(self, level: int, own: Quotient, sources: Sequence[_Source], values: bool) -> bool:
        world = self.steps[level].world
        own_refs = {source.cited.ref for source in sources if source.move is None}
        known = {n: x for n, x, ref in self.values[level] if values and ref not in own_refs}
        used = {n for x in known.values() for n in world.keys(x.above, x.below)}
        for pivots in islice(self._pivots(world, own, sources, known), _PIVOTS):
            if used & set(pivots):
                break
            conditions = [(source.value, n) for source, n in zip(sources, pivots, strict=True)]
            verdicts = [sample.agrees(world, own, conditions, known) for sample in self.samples]
            if None not in verdicts:
                return all(verdicts)
        return len(sources) == 1 and self._agree_put_in(level, own, sources[0].value, known)

    def _agree_put_in(
        self, level: int, own: Quotient, other: Quotient, known: dict[int, Quotient]
    ) -> bool:
        """As `_agree`, where nothing can be solved for before what is known is put in."""
        step = self.steps[level]
        if known:
            rules = Rules(step.world, [(n, 1, value) for n, value in known.items()])
            try:
                line, law = (rules.put_into(quotient) for quotient in (own, other))
            except NotComparableError:
                return False
            assert isinstance(line, Quotient)
            assert isinstance(law, Quotient)
            own, other = line, law
            if own.vanishes or other.vanishes:
                return False
        if not set(step.world.keys(own.above)) <= set(step.world.keys(other.above)):
            return False
        rest, _ = without_common(own.above, other.above)
        # Common factors are not seen beside roots.
        roots = any(key[0] == "root" for key in step.world.keys(own.above).values())
        return is_without(rest, own.above) or roots

    def _pivots(
        self, world: World, own: Quotient, sources: Sequence[_Source], known: dict[int, Quotient]
    ) -> Iterator[tuple[int, ...]]:
        """A generator for each source to be solved for, those of the line first."""
        in_line = set(world.keys(own.above))
        linear = [
            sorted(
                _linear(world, source.value) - known.keys(),
                key=lambda n: (_is_ratio(world, n), n not in in_line, _is_positive(world, n)),
            )
            for source in sources
        ]
        if len(linear) == 1:
            yield from ((n,) for n in linear[0] if n in in_line)
            return
        for a, b in product(*linear):
            if a != b and not any(m[a] and m[b] for source in sources for m in source.value.above):
                yield a, b


def _is_ratio(world: World, number: int) -> bool:
    """Whether a generator is a sine or a cosine: it is solved for where nothing else can be."""
    return bool(world.keys_by_number()[number][0] in ("sin", "cos"))


def _is_positive(world: World, number: int) -> bool:
    """Whether a generator is a mass, a speed or another letter that is positive."""
    key = world.keys_by_number()[number]
    return bool(key[0] == "letter" and world.roles.get(key[1], REAL).kind == "positive")


def _solved_for(x: Quotient, number: int) -> Quotient:
    """The value of a generator at which what is linear in it vanishes."""
    lead = {(*m[:number], 0, *m[number + 1 :]): v for m, v in x.above.items() if m[number]}
    rest = {m: v for m, v in x.above.items() if not m[number]}
    ring = x.above.ring
    return Quotient(-ring.from_dict(rest), ring.one) / Quotient(ring.from_dict(lead), ring.one)


def _flat(links: tuple[Link, ...]) -> Iterator[Link]:
    whole = whole_of(links)
    yield links[0]
    if len(links) > 1:
        yield from links[1:] if whole is None else (whole,)


def _slope(x: Quotient, number: int) -> Quotient:
    """The factor of a generator in what is linear in it."""
    lead = {(*m[:number], 0, *m[number + 1 :]): v for m, v in x.above.items() if m[number]}
    return Quotient(x.above.ring.from_dict(lead), x.above.ring.one)


_SKEW = CONSTANT(7919)


def _linear(world: World, x: Quotient) -> set[int]:
    """The generators in which a numerator is linear, and which no root and no sine hides."""
    keys = world.keys(x.above)
    inside = {
        n
        for key in world.keys(x.above, x.below).values()
        if key[0] in ("root", "size")
        for n in world.keys(key[1])
    }
    return {
        n
        for n, key in keys.items()
        if key[0] in ("letter", "quantity", "x", "y", "angle", "sin", "cos")
        and n not in inside
        and max(m[n] for m in x.above) == 1
    }


class _Sample:
    """Random values of generators: consistent for sines and cosines of one angle, and for roots."""

    def __init__(self, random_: random.Random) -> None:
        self.random = random_
        self.atoms: dict[Atom, float] = {}
        self.values: dict[Key, complex] = {}

    def agrees(
        self,
        world: World,
        own: Quotient,
        conditions: Sequence[tuple[Quotient, int]],
        known: dict[int, Quotient],
    ) -> bool | None:
        """Whether a quotient vanishes where others do, each solved for a generator.

        What is ``known`` has the value that a line above gives it. None where the others vanish
        only for masses or speeds of nothing, which tells nothing.
        """
        point: dict[int, complex] = {}
        gone = {number for _, number in conditions}
        polynomials = [own.above, *(quotient.above for quotient, _ in conditions)]
        try:
            for number in world.keys(*polynomials):
                if number not in gone:
                    point[number] = self._known(world, number, known, 0)
        except ZeroDivisionError:
            return False
        try:
            solved = _solved(conditions, point)
        except ZeroDivisionError:
            return False
        if any(abs(x) < _CLOSE and _is_positive(world, n) for n, x in solved.items()):
            return None
        point |= solved
        value, size = _at(own.above, point)
        return abs(value) <= _CLOSE * max(size, 1.0)

    def _known(self, world: World, number: int, known: dict[int, Quotient], depth: int) -> complex:
        key = world.keys_by_number()[number]
        if key[0] in ("root", "size") and known and depth <= 8:
            below = {n: self._known(world, n, known, depth + 1) for n in world.keys(key[1])}
            value = _at(key[1], below)[0]
            return cmath.sqrt(value) if key[0] == "root" else abs(value)
        if number not in known or depth > 8:
            return self._value(world, key)
        x = known[number]
        own = {n: self._known(world, n, known, depth + 1) for n in world.keys(x.above, x.below)}
        return _at(x.above, own)[0] / _at(x.below, own)[0]

    def _value(self, world: World, key: Key) -> complex:
        if key not in self.values:
            self.values[key] = self._new(world, key)
        return self.values[key]

    def _new(self, world: World, key: Key) -> complex:
        match key:
            case ("cos", turn):
                return math.cos(self._angle(turn))
            case ("sin", turn):
                return math.sin(self._angle(turn))
            case ("root", inside):
                own = {n: self._value(world, k) for n, k in world.keys(inside).items()}
                return cmath.sqrt(_at(inside, own)[0])
            case ("size", inside):
                own = {n: self._value(world, k) for n, k in world.keys(inside).items()}
                return abs(_at(inside, own)[0])
            case ("degree",):
                return math.pi / 180
            case ("angle", atom):
                return self._atom(atom)
        return self.random.uniform(0.7, 4)

    def _angle(self, turn: AngleKey) -> float:
        terms, degrees = turn
        total = float(degrees) * math.pi / 180
        for term in terms:
            if term:
                atom, count = term
                total += float(count) * self._atom(atom)
        return total

    def _atom(self, atom: Atom) -> float:
        if atom not in self.atoms:
            self.atoms[atom] = self.random.uniform(0.2, 1.3)
        return self.atoms[atom]


def _first(own: Levels) -> tuple[int, Quotient]:
    """A line with the data put in, or else with what is given too, and which of these it is."""
    level = 0 if own[0] is not None else 1
    there = own[level]
    assert there is not None
    return level, there


def _at(polynomial: PolyElement, point: dict[int, complex]) -> tuple[complex, float]:
    """The value of a polynomial, and the size of its greatest term."""
    total, size = 0j, 0.0
    for powers, coefficient in polynomial.items():
        term = complex(float(coefficient))
        for n, power in enumerate(powers):
            if power:
                term *= point[n] ** power
        total += term
        size = max(size, abs(term))
    return total, size


def _solved(
    conditions: Sequence[tuple[Quotient, int]], point: dict[int, complex]
) -> dict[int, complex]:
    """Values of one or two generators at which polynomials that are linear in them vanish."""
    numbers = [number for _, number in conditions]
    zero = {**point, **dict.fromkeys(numbers, 0j)}
    constant = [_at(quotient.above, zero)[0] for quotient, _ in conditions]
    slopes = [
        [_at(quotient.above, {**zero, n: 1 + 0j})[0] - c for n in numbers]
        for (quotient, _), c in zip(conditions, constant, strict=True)
    ]
    if len(numbers) == 1:
        return {numbers[0]: -constant[0] / slopes[0][0]}
    (a, b), (c, d) = slopes
    p, q = constant
    determinant = a * d - b * c
    return {numbers[0]: (b * q - d * p) / determinant, numbers[1]: (c * p - a * q) / determinant}
