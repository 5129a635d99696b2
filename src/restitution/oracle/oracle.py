"""Claims about letters decided: proved, refuted by values of the letters, or left undecided."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import chain
from threading import local
from typing import Literal

import sympy as sp

from restitution.oracle import decision, intervals
from restitution.oracle.common_points import seem_to_hold_together
from restitution.oracle.draws import Draw, draws
from restitution.oracle.eliminated import bearing_on, hold_together
from restitution.oracle.formula import (
    All,
    Formula,
    Relation,
    joined,
    letters_of,
    negation,
    relations,
)
from restitution.oracle.least_true import descents
from restitution.oracle.points import (
    BeyondError,
    Point,
    Program,
    Value,
    as_number,
)
from restitution.oracle.polynomials import Polynomials, TooLargeError
from restitution.oracle.roles import REAL, Role
from restitution.oracle.scaled import scaled_sign
from restitution.oracle.simple import simpler
from restitution.oracle.sums_of_angles import (
    angle_within,
    is_never_negative,
    sine_of_share,
    with_sines,
    without_numbers,
)
from restitution.oracle.testers import (
    Tester,
    holds_with,
    tester_of,
)
from restitution.records import dataclass
from restitution.work import remembered, spend

Answer = Literal["proved", "refuted", "undecided"]
Proof = Literal["algebra", "decision", "intervals", "witness", "undecided"]

# So many points are tried before a question is put to the decision procedure; so many in all,
# where that has no answer.
FEW, MANY = 24, 160
# What a claim, and what a question to the decision procedure, counts in steps of work.
_CLAIM, _QUESTION = 100, 2000


@dataclass(frozen=True)
class Verdict:
    """What became of a claim.

    ``proof`` is what the answer rests on: exact algebra, a decision procedure for polynomials,
    interval arithmetic, or a point that refutes it (``witness``: a value for each letter).
    ``trials`` counts the points at which it was tried.
    """

    answer: Answer
    proof: Proof
    witness: Point | None = None
    trials: int = 0

    def __bool__(self) -> bool:
        """Whether the claim is proved."""
        return self.answer == "proved"


@dataclass
class Oracle:
    """Decides claims for all values of the letters that ``roles`` and ``facts`` allow.

    ``roles`` tells what each letter may be; any other letter is any real number. What has no real
    value at a point speaks neither for a claim there nor against it.
    """

    roles: Mapping[str, Role]
    facts: tuple[Formula, ...] = ()
    _verdicts: dict[Formula, Verdict] = field(default_factory=dict, repr=False)
    _signs: dict[sp.Expr, int | None] = field(default_factory=dict, repr=False)
    _about: dict[frozenset[str], Oracle] = field(default_factory=dict, repr=False)
    _plain: bool = field(default=True, repr=False)

    def with_facts(self, facts: Iterable[Formula]) -> Oracle:
        """The same letters, under more facts."""
        return Oracle(self.roles, (*self.facts, *facts))

    def about(self, letters: frozenset[str]) -> Oracle:
        """The same letters, under the facts alone on which a claim about some of them rests."""
        if letters not in self._about:
            facts = bearing_on(letters, self.facts, self.roles)
            self._about[letters] = self if facts == self.facts else Oracle(self.roles, facts)
        return self._about[letters]

    def _known(self, letters: frozenset[str]) -> _Known:
        """What an answer about these letters rests on."""
        names = sorted(letters | self._every.letters)
        return tuple((name, self.roles.get(name)) for name in names), self.facts

    # --- points ----------------------------------------------------------------------------------

    @cached_property
    def _every(self) -> Tester:
        return tester_of(joined(self.facts))

    def _drawn(self, names: frozenset[str], first: int, last: int) -> Iterator[Draw]:
        """Draws at which all facts hold for certain."""
        wanted = sorted(names | self._every.letters)
        if not wanted:
            last = min(last, 1)
        for draw in draws(wanted, self.roles, last - first, first):
            if self._every.holds(draw.point, draw.balls) is True:
                yield draw

    def points(self, names: frozenset[str], count: int = FEW) -> list[Point]:
        """Points at which all facts hold for certain, with a value for each of these letters."""
        return [draw.point for draw in self._drawn(names, 0, count)]

    @cached_property
    def possible(self) -> Verdict:
        """Whether some values satisfy the facts: refuted means that none do."""
        try:
            return _possible(self._known(frozenset()))
        except _OpenError as open_:
            return open_.verdict

    @cached_property
    def by_elimination(self) -> Literal["yes", "no", "unknown"]:
        """Whether some values satisfy the facts, as linear equations among them alone show."""
        return hold_together(self.facts, self.roles)

    def _satisfied(self) -> Verdict:
        names = self._every.letters
        for draw in self._drawn(names, 0, FEW):
            return Verdict("proved", "witness", draw.point, 1)
        if self.by_elimination == "no":
            return Verdict("refuted", "algebra")
        reply, world = self._asked(())
        if reply.satisfiable == "no":
            return Verdict("refuted", "decision" if names else "algebra")
        if reply.satisfiable == "yes" and world is not None:
            point = self._simple(self._point(reply, world, names), ())
            if self._every.holds(point) is True:
                return Verdict("proved", "witness", point)
            if not world.loose:
                return Verdict("proved", "decision", point)
        for draw in self._drawn(names, FEW, MANY):
            return Verdict("proved", "witness", draw.point, 1)
        if intervals.refutes(joined(self.facts), self.roles):
            return Verdict("refuted", "intervals")
        return Verdict("undecided", "undecided")

    def admits(self, point: Point) -> bool:
        """Whether every letter has a value that its role allows."""
        return all(_allowed(value, self.roles.get(name, REAL)) for name, value in point.items())

    # --- claims ----------------------------------------------------------------------------------

    def decide(self, claim: Formula) -> Verdict:
        """Whether a claim holds wherever the facts do."""
        if claim not in self._verdicts:
            try:
                verdict = _decided(self._known(_letters_of(claim)), claim)
            except _OpenError as open_:
                verdict = open_.verdict
            self._verdicts[claim] = verdict
        return self._verdicts[claim]

    def proves(self, claim: Formula) -> bool:
        """Whether a claim is proved, for who needs no counter-example: finding a plain one takes
        longer than the rest.
        """
        if claim in self._verdicts:
            return bool(self._verdicts[claim])
        try:
            own = self.about(_letters_of(claim))
            return bool(_proved(own._known(_letters_of(claim)), claim))
        except _OpenError:
            return False

    def decide_some(self, claim: Formula, free: frozenset[str]) -> Verdict:
        """Whether wherever the facts hold, some values of the free letters satisfy a claim."""
        try:
            return _decided_some(self._known(_letters_of(claim)), claim, free)
        except _OpenError as open_:
            return open_.verdict

    def _decide_some(self, claim: Formula, free: frozenset[str]) -> Verdict:
        formulas = [without_numbers(fact) for fact in (*self.facts, claim)]
        values = [relation.value for relation in relations(joined(formulas))]
        try:
            world = Polynomials([sine_of_share(value, self.roles) for value in values], self.roles)
            prepared = [with_sines(formula, self.roles) for formula in formulas]
            answer = decision.covers(world, prepared[:-1], prepared[-1], free)
        except (TooLargeError, BeyondError):
            answer = "unknown"
        if answer == "yes" and not world.loose:
            return Verdict("proved", "decision")
        return Verdict("undecided", "undecided")

    def _decide(self, claim: Formula) -> Verdict:
        spend(_CLAIM)
        if isinstance(claim, All):
            return self._all(claim)
        algebra = self._by_algebra(claim)
        names = _letters_of(claim) | self._every.letters
        if algebra is not None and (algebra.answer == "proved" or not names):
            return algebra
        tester = tester_of(claim)
        tried = 0
        drawn: list[Point] = []
        for first, last in ((0, FEW), (FEW, MANY)):
            for draw in self._drawn(names, first, last):
                tried += 1
                drawn.append(draw.point)
                if tester.holds(draw.point, draw.balls) is False:
                    witness = self._simple(draw.point, (claim,))
                    return Verdict("refuted", "witness", witness, tried)
            if not first:
                verdict = self._by_decision(claim, names, tester, tried)
                if verdict is not None:
                    return verdict
        if intervals.proves(claim, joined(self.facts), self.roles):
            return Verdict("proved", "intervals", None, tried)
        if self._plain and isinstance(claim, Relation):
            for point in descents(claim, self.roles, drawn, self._allows):
                tried += 1
                if tester.holds(point) is False:
                    return Verdict("refuted", "witness", self._simple(point, (claim,)), tried)
        return Verdict("undecided", "undecided", None, tried)

    def _allows(self, point: Point) -> bool:
        """Whether roles and facts certainly allow a point."""
        return self._every.holds(point) is True and self.admits(point)

    def _all(self, claim: All) -> Verdict:
        decide = self.decide if self._plain else self._decide
        parts = [decide(part) for part in claim.parts]
        tried = max((part.trials for part in parts), default=0)
        for part in parts:
            if part.answer == "refuted":
                return part
        for part in parts:
            if part.answer == "undecided":
                return Verdict("undecided", "undecided", None, tried)
        order: tuple[Proof, ...] = ("intervals", "decision", "algebra")
        proofs = {part.proof for part in parts}
        return Verdict("proved", next((p for p in order if p in proofs), "algebra"), None, tried)

    def _by_decision(
        self, claim: Formula, names: frozenset[str], tester: Tester, tried: int
    ) -> Verdict | None:
        formulas = (*self.facts, negation(claim))
        if (together := hold_together(formulas, self.roles)) == "no":
            return Verdict("proved", "algebra", None, tried)
        if not self._plain and (together == "yes" or seem_to_hold_together(formulas, self.roles)):
            # Who needs no counter-example loses at most a proof.
            return Verdict("undecided", "undecided", None, tried)
        reply, world = self._asked((negation(claim),))
        if reply.satisfiable == "no":
            return Verdict("proved", "decision" if names else "algebra", None, tried)
        if reply.satisfiable == "yes" and world is not None:
            point = self._simple(self._point(reply, world, names), (claim,))
            if self._every.holds(point) is True and tester.holds(point) is False:
                return Verdict("refuted", "witness", point, tried)
            if not world.loose and self._every.holds(point) is not False:
                return Verdict("refuted", "decision", point, tried)
        return None

    def _by_algebra(self, claim: Formula) -> Verdict | None:
        """What coefficients and normal forms alone show."""
        if not isinstance(claim, Relation):
            return None
        own = scaled_sign(claim.value, self.roles)
        if own is not None:
            return Verdict("proved", "algebra") if holds_with(claim, {claim.value: own}) else None
        try:
            world = Polynomials([claim.value], self.roles)
            above, below = world.quotient(claim.value)
            if world.vanishes(above):
                holds = claim.operator in ("=", ">=")
                return Verdict("proved" if holds else "refuted", "algebra")
            if claim.operator == "=":
                equal = _is_a_root(claim.value, self.roles)
                return Verdict("proved", "algebra") if equal else None
            sign = 1
            weak = False
            for polynomial, part in ((above, 1), (below, -1)):
                for factor, power in world.factors(polynomial):
                    own = world.sign(factor)
                    if own is not None:
                        sign *= own**power
                    elif (power % 2 == 0 and part == 1) or (
                        part == 1 and claim.operator == ">=" and world.not_negative(factor)
                    ):
                        weak = True
                    elif part == 1 and claim.operator == ">=" and world.not_negative(-factor):
                        weak, sign = True, -sign
                    else:
                        return None
        except (TooLargeError, BeyondError):
            return None
        if sign == 1 and (claim.operator == ">=" or not weak):
            return Verdict("proved", "algebra")
        if claim.operator == "!=" and not weak:
            return Verdict("proved", "algebra")
        return None

    def sign(self, x: sp.Expr) -> int | None:
        """The sign of an expression wherever the facts hold, if it is proved to be one, else None.

        0 is for what vanishes throughout.
        """
        x = sp.sympify(x, strict=True)
        if x not in self._signs:
            self._signs[x] = self._sign(x)
        return self._signs[x]

    def _sign(self, x: sp.Expr) -> int | None:
        if x.is_Rational:
            return int(sp.sign(x))
        scaled = scaled_sign(x, self.roles)
        if scaled is not None:
            return scaled
        positive, negative, zero = Relation(x, ">"), Relation(-x, ">"), Relation(x, "=")
        seen = _seen(self._known(_letters_of(positive)), x)
        if len(seen) > 1:
            return None
        for sign, claim in ((1, positive), (-1, negative), (0, zero)):
            if (not seen or sign in seen) and self.decide(claim):
                return sign
        return None

    def _seen(self, x: sp.Expr) -> frozenset[int]:
        """The signs of an expression at some points: as many as show that it has several."""
        claim = Relation(x, "=")
        tester = tester_of(claim)
        drawn = (draw.point for draw in self._drawn(tester.letters, 0, FEW))
        seen: set[int] = set()
        for point in chain(drawn, self._at_ends(tester.letters)):
            sign = tester.signs(point)[0]
            if sign is not None:
                seen.add(sign)
            if len(seen) > 1:
                break
        return frozenset(seen)

    def _at_ends(self, names: frozenset[str]) -> Iterator[Point]:
        """The ends of the values that one letter may have, where the facts hold there."""
        if len(names) != 1 or not self._every.letters <= names:
            return
        (name,) = names
        role = self.roles.get(name, REAL)
        for end, closed in zip((role.low, role.high), role.closed, strict=True):
            if closed and end is not None and end.is_Rational:
                point: Point = {name: Fraction(int(end.p), int(end.q))}
                if self._every.holds(point) is True:
                    yield point

    def vanishes(self, x: sp.Expr) -> bool:
        """Whether an expression is proved to be zero wherever the facts hold."""
        return bool(self.decide(Relation(sp.sympify(x, strict=True), "=")))

    # --- asking Z3 -------------------------------------------------------------------------------

    def _asked(self, more: Sequence[Formula]) -> tuple[decision.Reply, Polynomials | None]:
        spend(_QUESTION)
        formulas = [without_numbers(formula) for formula in (*self.facts, *more)]
        values = [relation.value for formula in formulas for relation in relations(formula)]
        try:
            world = Polynomials([sine_of_share(value, self.roles) for value in values], self.roles)
            prepared = [with_sines(formula, self.roles) for formula in formulas]
            reply = decision.satisfy(world, prepared)
            if "memory" in reply.reason:
                _OPEN.count = broken_off() + 1
            return reply, world
        except (TooLargeError, BeyondError):
            return decision.UNKNOWN, None

    def _point(
        self, reply: decision.Reply, world: Polynomials, names: frozenset[str]
    ) -> dict[str, Value]:
        assert reply.model is not None
        point: dict[str, Value] = {}
        for name in sorted(names):
            if name in world.letters:
                value = reply.model.get(world.letters[name])
                if value is not None:
                    point[name] = (
                        Fraction(int(value.p), int(value.q)) if value.is_Rational else value
                    )
            elif name in world.angles:
                cosine, sine = (reply.model.get(ratio) for ratio in world.angles[name][:2])
                if cosine is not None and sine is not None:
                    point[name] = angle_within(
                        world.angles[name][2] * sp.atan2(sine, cosine), self.roles.get(name, REAL)
                    )
        missing = sorted(names - set(point))
        if missing:
            usual = next(draws(missing, self.roles, 1))
            point.update(usual.point)
        return point

    def _simple(self, point: Point, against: Sequence[Formula]) -> dict[str, Value]:
        """A point of the same kind in plainer numbers."""
        if not self._plain:
            return dict(point)
        testers = [tester_of(formula) for formula in against]

        def serves(candidate: Point) -> bool:
            return (
                self.admits(candidate)
                and self._every.holds(candidate, exactly=True) is True
                and all(tester.holds(candidate, exactly=True) is False for tester in testers)
            )

        return simpler(point, self.roles, serves)


def _is_a_root(x: sp.Expr, roles: Mapping[str, Role]) -> bool:
    """Whether an expression ``b√c − a`` is seen to vanish, as b²c = a² and neither is negative.

    The root is the longest one in it: what stands under that has roots of its own.
    """
    roots = [power for power in x.atoms(sp.Pow) if power.exp == sp.S.Half and power.free_symbols]
    if not roots:
        return False
    root, letter = max(roots, key=lambda root: (sp.count_ops(root), str(root))), sp.Dummy()
    own = x.xreplace({root: letter})
    rest, factor = own.xreplace({letter: sp.S.Zero}), sp.diff(own, letter)
    if factor == 0 or factor.has(letter) or rest.has(sp.nan, sp.zoo):
        return False
    if not any(
        is_never_negative(sense * factor, roles) and is_never_negative(-sense * rest, roles)
        for sense in (1, -1)
    ):
        return False
    gap = rest**2 - factor**2 * root.base
    world = Polynomials([gap], roles)
    return world.vanishes(world.quotient(gap)[0])


# --- what is remembered --------------------------------------------------------------------------

# A verdict follows from the claim, the facts, and what the letters in them may be; so it is kept,
# with the work that it took, for the next who asks: solving again, explaining what was solved.
_Known = tuple[tuple[tuple[str, Role | None], ...], tuple[Formula, ...]]


class _OpenError(Exception):
    """A verdict that is not kept: the memory of this process has ended the search."""

    def __init__(self, verdict: Verdict) -> None:
        self.verdict = verdict


def _oracle(known: _Known) -> Oracle:
    letters, facts = known
    return Oracle({name: role for name, role in letters if role is not None}, facts)


@remembered(2048)
def _decided(known: _Known, claim: Formula) -> Verdict:
    return _kept(_oracle(known), lambda own: own._decide(claim))


@remembered(2048)
def _proved(known: _Known, claim: Formula) -> Verdict:
    oracle = _oracle(known)
    oracle._plain = False
    return _kept(oracle, lambda own: own._decide(claim))


@remembered(512)
def _decided_some(known: _Known, claim: Formula, free: frozenset[str]) -> Verdict:
    return _kept(_oracle(known), lambda own: own._decide_some(claim, free))


@remembered(512)
def _possible(known: _Known) -> Verdict:
    return _kept(_oracle(known), lambda own: own._satisfied())


_OPEN = local()


def broken_off() -> int:
    """How many questions have been given up in this thread so far for want of memory.

    That is shared by all of a process: what follows may be another time's proof.
    """
    return int(getattr(_OPEN, "count", 0))


def _kept(oracle: Oracle, decide: Callable[[Oracle], Verdict]) -> Verdict:
    before = broken_off()
    verdict = decide(oracle)
    if verdict.answer == "undecided" and broken_off() != before:
        raise _OpenError(verdict)
    return verdict


@lru_cache(maxsize=2048)
def _seen(known: _Known, x: sp.Expr) -> frozenset[int]:
    return _oracle(known)._seen(x)


@lru_cache(maxsize=4096)
def _letters_of(formula: Formula) -> frozenset[str]:
    return letters_of(formula)


def _allowed(value: Value, role: Role) -> bool:
    ends = [
        (end, sense, closed)
        for end, sense, closed in ((role.low, 1, role.closed[0]), (role.high, -1, role.closed[1]))
        if end is not None
    ]
    number = as_number(value)
    signs = Program.of([sense * (number - end) for end, sense, _ in ends]).signs({})
    return all(
        sign is not None and (sign > 0 or (closed and sign == 0))
        for sign, (_, _, closed) in zip(signs, ends, strict=True)
    )
