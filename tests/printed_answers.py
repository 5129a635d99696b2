"""Questions drawn at random, and what is printed for them against `plain_physics` at many points.

A question asks for the range of a letter, or for what a fact makes of a letter, with other letters
as data. What is true at given numbers is found by trying: a point is possible or not, and a value
is where the two sides of a fact cross. What is printed has to say the same inside, outside, and a
billionth from each end.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath as mp
import plain_physics as physics
import sympy as sp
from claims import number_of

from restitution import problem as p
from restitution.expression import tree as t
from restitution.language import parse

GRID = 40
"""Numbers of a letter at which a question is tried."""

NEAR = mp.mpf(10) ** -9
TOLERANCE = mp.mpf(10) ** -12


@dataclass(frozen=True)
class Question:
    """A statement without its question, a letter that varies, and what is asked.

    ``data`` are the letters whose numbers matter; ``fixed`` says that a fact gives the letter.
    """

    shape: str
    story: str
    letter: str
    data: tuple[str, ...]
    asked: str
    fixed: bool

    @property
    def statement(self) -> str:
        unknown = f"unknown {self.letter}\n" if self.fixed and self.asked != self.letter else ""
        return f"{self.story}{unknown}find {self.asked}\n"


# --- numbers of letters --------------------------------------------------------------------------


def kind_of(letter: str) -> str:
    if letter in ("e", "f"):
        return "coefficient"
    return "angle" if letter in ("alpha", "beta") else "positive"


def at_share(letter: str, share: Any) -> Any:
    """The number of a letter at a share of its range, 0 < share < 1."""
    match kind_of(letter):
        case "coefficient":
            return mp.mpf(share)
        case "angle":
            return mp.mpf(share) * mp.pi / 2
    return mp.mpf(share) / (1 - mp.mpf(share))


def drawn(names: tuple[str, ...], rng: random.Random) -> dict[str, Any]:
    """Numbers for the data: usual ones, plain ones, and some near the ends."""
    values: dict[str, Any] = {}
    for name in names:
        if name in "mu":
            values[name] = mp.mpf(rng.choice((1, 2, 3)))
            continue
        if kind_of(name) == "coefficient" and rng.random() < 0.15:
            # With two coefficients of 0 all is at rest, and has no direction.
            values[name] = mp.mpf(rng.choice((0, 1)) if "f" not in names else 1)
            continue
        share = Fraction(rng.randint(1, 99), 100)
        if rng.random() < 0.15:
            share = rng.choice((Fraction(1, 1000), Fraction(999, 1000)))
        values[name] = at_share(name, mp.mpf(share.numerator) / share.denominator)
    return values


def grid(letter: str, count: int = GRID) -> list[Any]:
    shares = [mp.mpf(n) / count for n in range(1, count)]
    shares = [
        mp.mpf(10) ** -6,
        mp.mpf(10) ** -3,
        *shares,
        1 - mp.mpf(10) ** -3,
        1 - mp.mpf(10) ** -6,
    ]
    values = [at_share(letter, share) for share in shares]
    return [mp.mpf(0), *values, mp.mpf(1)] if kind_of(letter) == "coefficient" else values


# --- what is true --------------------------------------------------------------------------------


def world(problem: p.Problem, letters: Mapping[str, Any]) -> physics.World | None:
    """The story in numbers; None where it cannot happen."""
    try:
        return physics.World(problem, letters)
    except physics.ImpossibleWorldError:
        return None


def is_possible(problem: p.Problem, letters: Mapping[str, Any]) -> bool:
    told = world(problem, letters)
    try:
        return told is not None and told.possible()
    except physics.ImpossibleWorldError:
        return False


def borders(truth: Callable[[Any], bool], values: list[Any]) -> list[Any]:
    """Where a truth changes between numbers in order."""
    found = []
    truths = [truth(value) for value in values]
    for low, high, before, after in zip(values, values[1:], truths, truths[1:], strict=False):
        if before is after:
            continue
        for _ in range(50):
            middle = (low + high) / 2
            if truth(middle) is before:
                low = middle
            else:
                high = middle
        found.append((low + high) / 2)
    return found


def residual(told: physics.World) -> Any:
    """What vanishes where the equations that are given hold, the first of them."""
    for relation, now in told.facts:
        match relation:
            case p.Compare(operators=("=",), operands=(left, right)):
                return told.scalar(left, now) - told.scalar(right, now)
            case p.Aligned(relation="perpendicular to"):
                a, b = (told.direction(side, now) for side in (relation.left, relation.right))
                return physics.dot(a, b)
            case p.Aligned():
                a, b = (told.direction(side, now) for side in (relation.left, relation.right))
                return physics.cross(a, b)
    raise NotImplementedError


def roots(problem: p.Problem, letter: str, data: Mapping[str, Any], count: int = GRID) -> list[Any]:
    """The numbers of a letter, in its range, at which a fact becomes true; by crossing zero."""

    def gap(x: Any) -> Any:
        told = world(problem, {**data, letter: x})
        try:
            return None if told is None else residual(told)
        except physics.ImpossibleWorldError:
            return None

    with mp.workdps(30):
        values = grid(letter, count)
        gaps = [gap(value) for value in values]
        found = [
            v
            for v, g in zip(values, gaps, strict=True)
            if g is not None and abs(g) < mp.mpf(10) ** -25
        ]
        for low, high, a, b in zip(values, values[1:], gaps, gaps[1:], strict=False):
            if a is None or b is None or a * b >= 0:
                continue
            for _ in range(80):
                middle = (low + high) / 2
                own = gap(middle)
                if own is None:
                    break
                if own * a > 0:
                    low = middle
                else:
                    high = middle
            else:
                if abs(gap(low)) < mp.mpf(10) ** -12:  # and not a jump
                    found.append(low)
        for n in range(1, len(values) - 1):  # a zero without a change of sign
            around = gaps[n - 1 : n + 2]
            if None in around or not abs(around[1]) <= min(abs(around[0]), abs(around[2])):
                continue
            low, high = values[n - 1], values[n + 1]
            for _ in range(120):
                one, two = low + (high - low) / 3, high - (high - low) / 3
                a, b = gap(one), gap(two)
                if a is None or b is None:
                    break
                low, high = (low, two) if abs(a) < abs(b) else (one, high)
            else:
                if abs(gap(low)) < mp.mpf(10) ** -16:
                    found.append(low)
    return found


# --- what is printed -----------------------------------------------------------------------------


def sets_at(item: Any, data: Mapping[str, Any]) -> list[tuple[Any, Any, bool, bool]]:
    """The intervals that are printed for some data, of the answers whose conditions hold."""
    intervals = []
    for answer in item.answers:
        if not all(holds(condition, data) for condition in answer.condition):
            continue
        parts = answer.value.args if isinstance(answer.value, sp.Union) else (answer.value,)
        for part in parts:
            if isinstance(part, sp.FiniteSet):
                for x in part:
                    x = number(x, data)
                    if x is not None:
                        intervals.append((x, x, False, False))
            elif isinstance(part, sp.Interval):
                low, high = number(part.start, data), number(part.end, data)
                if low is None or high is None:
                    intervals.append((mp.nan, mp.nan, True, True))
                else:
                    intervals.append((low, high, bool(part.left_open), bool(part.right_open)))
    return intervals


LONG = 1500
LEAST = mp.mpf(10) ** -60


def of_text(text: str, data: Mapping[str, Any]) -> Any:
    """The number that an exact text is."""
    if not re.search("CRootOf|Min|Max|atan2", text) and len(text) < LONG:
        return number_of(text.replace("Abs(", "abs("), data)
    letters = {name: sp.Symbol(name) for name in data}
    value = number(sp.sympify(text, locals=letters), data)
    return mp.nan if value is None else value


def holds(condition: str, data: Mapping[str, Any]) -> bool:
    """Whether one of the chains of a condition holds; where a root is not real, it does not."""
    try:
        return any(_chain_holds(chain, data) for chain in condition.split(" or "))
    except physics.ImpossibleWorldError:
        return False


_SIGNS = re.compile(r"\s*(<=|>=|!=|<|>|=)\s*")


def _chain_holds(chain: str, data: Mapping[str, Any]) -> bool:
    sides = _SIGNS.split(chain)
    try:
        numbers = [of_text(side, data) for side in sides[::2]]
    except physics.ImpossibleWorldError:
        data = {n: x or LEAST for n, x in data.items()}  # k < 1/e holds for e = 0 too
        numbers = [of_text(side, data) for side in sides[::2]]
    return all(
        not physics.compared(low, "=", high) if sign == "!=" else physics.compared(low, sign, high)
        for low, sign, high in zip(numbers, sides[1::2], numbers[1:], strict=False)
    )


def answered(item: Any, data: Mapping[str, Any]) -> list[Any]:
    """The values of those answers whose conditions hold."""
    values = []
    for answer in item.answers:
        if all(holds(condition, data) for condition in answer.condition):
            try:
                values.append(of_text(answer.exact, data))
            except physics.ImpossibleWorldError:
                values.append(mp.nan)
    return values


def number(x: sp.Expr, data: Mapping[str, Any]) -> Any:
    """The number that an expression is; None where it is not real."""
    if x in (sp.oo, -sp.oo):
        return mp.inf if x == sp.oo else -mp.inf
    put = {s: sp.Float(mp.nstr(data[s.name], 155), 160) for s in x.free_symbols}
    try:
        value = sp.N(x.xreplace(put), 150)
    except ValueError:  # the greater of two numbers that are not real
        return None
    if value.has(sp.zoo, sp.nan):
        return None
    if value.is_real or abs(sp.im(value)) < sp.Float(10) ** -100 * (1 + abs(value)):
        return mp.mpf(str(sp.re(value)))
    return None


def is_in(x: Any, intervals: list[tuple[Any, Any, bool, bool]]) -> bool:
    for low, high, left_open, right_open in intervals:
        same_low = (
            abs(x - low) <= mp.mpf(10) ** -70 * max(1, abs(low)) if mp.isfinite(low) else False
        )
        same_high = (
            abs(x - high) <= mp.mpf(10) ** -70 * max(1, abs(high)) if mp.isfinite(high) else False
        )
        above = (same_low and not left_open) or (x > low and not same_low)
        below = (same_high and not right_open) or (x < high and not same_high)
        if above and below:
            return True
    return False


# --- both ----------------------------------------------------------------------------------------


def disagreements(question: Question, item: Any, rng: random.Random, count: int) -> Iterator[str]:
    """Where an answer and what is true do not agree."""
    problem = parse(question.statement)
    for _ in range(count):
        data = drawn(question.data, rng)
        if question.fixed and any(question.letter in answer.letters for answer in item.answers):
            return  # the fact is taken to fix another letter
        judge = _of_value if question.fixed else _of_range
        for doubt in judge(question, problem, item, data):
            shown = ", ".join(f"{n} = {mp.nstr(x, 12)}" for n, x in data.items())
            printed = [answer.display for answer in item.answers]
            yield f"{question.shape}: {doubt}, for {shown}; printed: {printed}"
            return


REFUSALS = ("impossible", "contradiction")


def possibilities(question: Question, rng: random.Random, count: int) -> Iterator[str]:
    """Numbers for which what is said to be impossible can be."""
    problem = parse(question.statement)
    letter = question.letter
    for _ in range(count):
        data = drawn(question.data, rng)
        if question.fixed:
            found = [
                x
                for x in roots(problem, letter, data)
                if is_admissible(letter, x) and is_loosely_possible(problem, {**data, letter: x})
            ]
        else:
            found = [x for x in grid(letter) if is_possible(problem, {**data, letter: x})]
        if found:
            shown = ", ".join(f"{n} = {mp.nstr(x, 12)}" for n, x in data.items())
            yield f"{question.shape}: {letter} = {mp.nstr(found[0], 12)} is possible, for {shown}"
            return


def _of_range(
    question: Question, problem: p.Problem, item: Any, data: dict[str, Any]
) -> Iterator[str]:
    letter = question.letter

    def truth(x: Any) -> bool:
        return is_possible(problem, {**data, letter: x})

    if not _speaks_of(letter, problem, data):
        return  # what is given of the data alone goes without saying
    intervals = sets_at(item, data)
    values = grid(letter)
    ends = [x for interval in intervals for x in interval[:2] if mp.isfinite(x)]
    exact = [x for x in ends if is_admissible(letter, x)]
    places = [*borders(truth, values), *ends]
    near = [x * (1 + step) for x in places for step in (NEAR, -NEAR)]
    near += [x + step for x in places if x == 0 for step in (NEAR,)]
    for x in (*values, *exact, *(x for x in near if is_admissible(letter, x))):
        wanted, own = truth(x), is_in(x, intervals)
        if wanted is not own:
            yield f"{letter} = {mp.nstr(x, 15)} is {'' if wanted else 'not '}possible"
            return


def _speaks_of(letter: str, problem: p.Problem, data: Mapping[str, Any]) -> bool:
    """Whether what is given depends on a letter."""
    gaps = set()
    for x in grid(letter, 7):
        told = world(problem, {**data, letter: x})
        for relation, now in () if told is None else told.facts:
            if not isinstance(relation, p.Compare):
                return True
            try:
                left, right = (told.scalar(side, now) for side in relation.operands)
            except physics.ImpossibleWorldError:
                return True
            gaps.add(mp.nstr(left - right, 20))
    return len(gaps) != 1


def is_admissible(letter: str, x: Any) -> bool:
    match kind_of(letter):
        case "coefficient":
            return bool(0 <= x <= 1)
        case "angle":
            return bool(physics.NONE < x < mp.pi / 2 - physics.NONE)
    return bool(x > physics.NONE)


def _of_value(
    question: Question, problem: p.Problem, item: Any, data: dict[str, Any]
) -> Iterator[str]:
    letter = question.letter
    found = [x for x in roots(problem, letter, data) if is_admissible(letter, x)]
    try:
        printed = answered(item, data)
    except Exception as error:  # noqa: BLE001 an answer must have a value wherever it holds
        yield f"no value: {error!r}"
        return
    if question.asked == letter:
        for x in printed:
            if not (mp.isfinite(x) and is_admissible(letter, x)):
                yield f"{letter} = {mp.nstr(x, 12)} is printed, which {letter} cannot be"
                return
            if not is_possible(problem, {**data, letter: x}):
                yield f"{letter} = {mp.nstr(x, 12)} is printed, and not possible"
                return
        wanted = found
    else:
        tree = expression(problem)

        def quantities(found: list[Any]) -> list[Any]:
            values = []
            for x in found:
                told = world(problem, {**data, letter: x})
                if told is not None and is_loosely_possible(problem, {**data, letter: x}):
                    values.append(told.scalar(tree, len(told.events)))
            return values

        wanted = quantities(found)
        if len(wanted) < len(printed):
            wanted = quantities(roots(problem, letter, data, 25 * GRID))
        for y in printed if wanted else ():
            if not any(abs(y - z) <= mp.mpf(10) ** -8 * max(1, abs(y)) for z in wanted):
                yield f"{question.asked} = {mp.nstr(y, 12)} is printed, and not seen"
                return
    for x in wanted:
        if question.asked == letter:
            nearby = [y for y in printed if abs(y - x) <= mp.mpf(10) ** -8 * max(1, abs(x))]
            possible = is_loosely_possible(problem, {**data, letter: x})
        else:
            nearby = [y for y in printed if abs(y - x) <= mp.mpf(10) ** -8 * max(1, abs(x))]
            possible = True
        if not nearby and possible:
            yield f"{question.asked} = {mp.nstr(x, 12)} is possible, and not printed"
            return


def is_loosely_possible(problem: p.Problem, letters: Mapping[str, Any]) -> bool:
    """Whether all inequalities hold where equations do to a few digits."""
    told = world(problem, letters)
    if told is None:
        return False
    for relation, now in told.facts:
        is_equation = (
            isinstance(relation, p.Compare) and relation.operators == ("=",)
        ) or isinstance(relation, p.Aligned)
        if not is_equation and not told.holds(relation, now):
            return False
    return True


def expression(problem: p.Problem) -> t.Expression:
    (step,) = (step for _, step in problem.steps() if isinstance(step, p.Find))
    item: Any = step.items[0]
    return item.expression
