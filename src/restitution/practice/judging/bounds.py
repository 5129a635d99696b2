"""Whether an inequality follows from a student's own values and a condition on them.

``v = (5 - 8e)u/6`` and ``v < 0`` give ``e > 5/8``, whether the value is right or not. Both are
tried at random values of the letters in the inequality: it follows if it holds just where the
condition does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from typing import Any

import numpy as np

from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.practice.judging.entries import Entry
from restitution.practice.letters.trial import inside_angles
from restitution.practice.script import Claim, Decimal, Sign, column_of
from restitution.problem import Aligned, Compare, Given, Part, Problem, Range
from restitution.records import dataclass
from restitution.solving.equations.solution import PartSolution

Array = Any

_POINTS = 400
_FEW = 40
_LARGEST = 6.0
_NEAR = 1e-9
_COMPARISONS: Mapping[Sign, Callable[[Array, Array], Array]] = {
    "<": np.less,
    "<=": np.less_equal,
    ">": np.greater,
    ">=": np.greater_equal,
}
_TURNED: Mapping[Sign, Sign] = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
_WAYS: Mapping[str, Sign] = {"in the direction of": ">", "opposite to": "<"}
_FUNCTIONS: Mapping[str, Callable[[Array], Array]] = {
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
}


@dataclass(frozen=True)
class Bounds:
    """What a part says of the sizes of quantities and letters.

    ``given`` compares quantities with numbers, ``ranges`` are the ends of what a letter may be that
    the part asks for, ``coefficients`` are letters that lie between 0 and 1.
    """

    given: tuple[Claim, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    coefficients: frozenset[str] = frozenset()

    def allows(self, claim: Claim, decimals: Sequence[Decimal] = ()) -> bool:
        """Whether a comparison of a letter with a number leaves out nothing that it may be.

        An end that is a rounded decimal may leave out what rounding does.
        """
        if claim.sign not in _COMPARISONS or not (letters(claim.left) or letters(claim.right)):
            return True
        usual = _usual(claim)
        if not isinstance(usual.left, Letter):
            return self._holds_throughout(claim)
        if usual.left.name not in self.ranges:
            return True
        low, high = self.ranges[usual.left.name]
        try:
            end = float(_worth(usual.right, {}))
            room = sum(_moved(usual.right, end, decimal) for decimal in decimals)
        except _OpenError:
            return True
        if usual.sign in ("<", "<="):
            return end >= high - room - _NEAR * (1 + abs(high))
        return end <= low + room + _NEAR * (1 + abs(low))

    def _holds_throughout(self, claim: Claim) -> bool:
        """Whether a comparison in one letter, ``sin² α > 0.6 cos² α``, holds all over its range.

        What lies near the ends may be left out by rounding.
        """
        names = letters(claim.left) | letters(claim.right)
        (name,) = names if len(names) == 1 else ("",)
        low, high = self.ranges.get(name, (0.0, np.inf))
        if not np.isfinite(high - low) or high <= low:
            return True
        inside = np.linspace(low, high, _POINTS + 2)[1:-1]
        region = _region(claim, {name: inside[_FEW // 10 : -_FEW // 10]})
        return region is None or bool(region.all())


def _moved(tree: Expression, end: float, decimal: Decimal) -> float:
    """By how much the end of an inequality moves where a decimal in it moves by half a unit."""
    put: dict[Expression, Expression] = {
        node: replace(node, value=node.value + decimal.half_unit_of(node.value))
        for node in walk(tree)
        if isinstance(node, Number | Degrees) and column_of(node) == decimal.column
    }
    return abs(float(_worth(exchanged(tree, put), {})) - end) if put else 0.0


def bounds_of(problem: Problem, part: Part, solved: PartSolution) -> Bounds:
    """What a part gives and asks of the sizes of quantities and letters."""
    coefficients = {name for name, role in solved.roles.items() if role.kind == "restitution"}
    return Bounds(
        tuple(_given(problem, part)), dict(_ranges(solved)), frozenset({"e", *coefficients})
    )


def _given(problem: Problem, part: Part) -> Iterator[Claim]:
    for step, _, _ in problem.timeline(part):
        for relation in step.relations if isinstance(step, Given) else ():
            if isinstance(relation, Aligned) and relation.relation in _WAYS:
                part_along = Quantity("along", (relation.left, relation.right))
                yield Claim(part_along, _WAYS[relation.relation], Number(Fraction(0)))
            if not isinstance(relation, Compare):
                continue
            links = zip(relation.operands, relation.operators, relation.operands[1:], strict=False)
            yield from (Claim(*link) for link in links if link[1] != "=")


def _ranges(solved: PartSolution) -> Iterator[tuple[str, tuple[float, float]]]:
    """The letters of which a part asks the range, where that is one interval of numbers."""
    for item in solved.items:
        subject = item.item.expression if isinstance(item.item, Range) else None
        if not isinstance(subject, Letter) or len(item.answers) != 1:
            continue
        value = item.answers[0].value
        if not isinstance(value, tuple) and value.is_Interval:
            ends = value.start, value.end
            if all(end.is_extended_real and not end.free_symbols for end in ends):
                yield subject.name, (float(ends[0]), float(ends[1]))


class _OpenError(Exception):
    """A side that is worth nothing here."""


def bounded_by(
    entry: Entry,
    entries: Sequence[Entry],
    conditions: Sequence[Claim],
    known: Mapping[str, float],
    coefficients: frozenset[str],
) -> int | None:
    """The number of the line whose value, under a condition, gives an inequality; None if none.

    ``conditions`` compare a letter with a number; ``known`` are values of the statement's letters,
    of which those in the inequality are varied. ``coefficients`` lie between 0 and 1.
    """
    claim = entry.claim
    names = sorted(letters(claim.left) | letters(claim.right))
    if claim.sign not in _COMPARISONS or claim.others or not names:
        return None
    if any(name not in known for name in names):
        return None
    put: dict[str, Array] = {name: np.float64(value) for name, value in known.items()}
    own: Array | None = None
    for largest in (1.0, _LARGEST):  # what follows from a mistake may ask for e > 5/3
        rng = np.random.default_rng(5)
        for name in names:
            put[name] = rng.uniform(0, largest if name in coefficients else _LARGEST, _POINTS)
        own = _region(claim, put)
        if own is None or (own.any() and not own.all()):
            break
    if own is None or own.all() or not own.any():
        return None
    there = _allowed(conditions, put)
    stated = [_usual(entry.claim) for entry in entries if entry.claim.sign in _COMPARISONS]
    usual = [Claim(Letter(name), "<=", Number(Fraction(1))) for name in sorted(coefficients)]
    for condition in (*stated, *conditions, *usual):
        if not isinstance(condition.left, Letter):
            continue
        for other in reversed(entries):
            if other.claim.sign != "=" or other.claim.others:
                continue
            value = _value_of(condition.left.name, other.claim, put)
            if value is None:
                continue
            try:
                end = _worth(condition.right, put)
            except _OpenError:
                continue
            region = _COMPARISONS[condition.sign](value, end)
            if np.mean((region == own)[there]) > 1 - 1 / _POINTS:
                return other.number
    for other in reversed(entries):
        sine = _of_a_sine(other.claim, put)
        if sine is not None and np.mean(((np.abs(sine) < 1) == own)[there]) > 1 - 1 / _POINTS:
            return other.number
    return None


def _of_a_sine(claim: Claim, put: Mapping[str, Array]) -> Array | None:
    """What an equation gives a sine, a cosine or the square of one, which is at most 1."""
    if claim.sign != "=" or claim.others:
        return None
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        base = one.left if is_binary(one, "^") else one
        if is_function(base, "sin", "cos"):
            try:
                with np.errstate(all="ignore"):
                    return np.broadcast_to(_worth(other, put), (_POINTS,))
            except _OpenError:
                return None
    return None


def rearranged_from(
    entry: Entry,
    entries: Sequence[Entry],
    known: Mapping[str, float],
    coefficients: frozenset[str],
) -> int | None:
    """The number of the line, an inequality that is not true, of which this is another form.

    Values of earlier lines are put in for the student's own letters. Both hold at the same of many
    random values of the letters; angles among these are acute.
    """
    claim, usual = entry.claim, (0.0, _LARGEST)
    if claim.sign not in _COMPARISONS or claim.others:
        return None
    for other in reversed(entries):
        if other.right or other.claim.sign not in _COMPARISONS or other.claim.others:
            continue
        names = letters(claim.left) | letters(claim.right)
        if not names or not names & (letters(other.claim.left) | letters(other.claim.right)):
            continue
        names |= letters(other.claim.left) | letters(other.claim.right)
        for least, largest in ((0.0, 1.0), (0.0, _LARGEST), (-_LARGEST, _LARGEST)):
            # A mistake may ask for e > 5/3, or for what no coefficient is: -20e > 0.
            rng = np.random.default_rng(7)
            put = {
                name: rng.uniform(*((least, largest) if name in coefficients else usual), _POINTS)
                for name in sorted(names)
            }
            put |= {name: rng.uniform(0, np.pi / 2, _POINTS) for name in _angles(claim, other)}
            own, above = _region(claim, put), _region(other.claim, put)
            if own is None or above is None:
                break
            if own.any() and not own.all() and np.mean(own == above) > 1 - 2 / _POINTS:
                return other.number
    return None


def _angles(claim: Claim, other: Entry) -> frozenset[str]:
    """The letters that stand in a sine, cosine or tangent, or beside degrees."""
    names: set[str] = set()
    for bound in (claim, other.claim):
        sides = bound.left, bound.right
        names |= inside_angles(bound.left) | inside_angles(bound.right)
        if any(isinstance(side, Degrees) for side in sides):
            names |= letters(bound.left) | letters(bound.right)
    return frozenset(names)


def _allowed(conditions: Iterable[Claim], put: Mapping[str, Array]) -> Array:
    """The points at which the conditions on letters of the statement hold."""
    there = np.ones(_POINTS, dtype=bool)
    for condition in conditions:
        region = _region(condition, put)
        if region is not None and region.sum() > _FEW:
            there = there & region
    return there


def _usual(claim: Claim) -> Claim:
    """A comparison with its letter on the left."""
    if isinstance(claim.left, Letter):
        return claim
    return replace(claim, left=claim.right, right=claim.left, sign=_TURNED[claim.sign])


def _region(claim: Claim, put: Mapping[str, Array]) -> Array | None:
    """Where a comparison holds."""
    try:
        with np.errstate(all="ignore"):
            left, right = _worth(claim.left, put), _worth(claim.right, put)
    except _OpenError:
        return None
    points = max(np.size(left), np.size(right), 1)
    points = _POINTS if points == 1 else points
    return np.broadcast_to(_COMPARISONS[claim.sign](left, right), (points,))


def _value_of(name: str, claim: Claim, put: Mapping[str, Array]) -> Array | None:
    """What an equation gives a letter that is linear in it, or a size by its square; else None."""
    inside = letters(claim.left) | letters(claim.right)
    if name not in inside:
        return None
    apart = []
    try:
        with np.errstate(all="ignore"):
            for x in (0.0, 1.0, 2.0):
                there = {**put, name: np.float64(x)}
                apart.append(_worth(claim.left, there) - _worth(claim.right, there))
            slope = apart[1] - apart[0]
            room = _NEAR * (1 + np.abs(slope))
            if np.any(slope == 0):
                return None
            if np.all(np.abs(apart[2] - apart[1] - slope) <= room):
                return np.broadcast_to(-apart[0] / slope, (_POINTS,))
            if np.all(np.abs(apart[2] - apart[1] - 3 * slope) <= room):
                return np.broadcast_to(np.sqrt(-apart[0] / slope), (_POINTS,))
            return None
    except _OpenError:
        return None


def _worth(tree: Expression, put: Mapping[str, Array]) -> Array:
    match tree:
        case Number(value):
            return np.float64(value)
        case Degrees(value):
            return np.radians(np.float64(value))
        case Letter(name) if name in put:
            return put[name]
        case Negate(operand):
            return -_worth(operand, put)
        case Binary(op, left, right):
            a, b = _worth(left, put), _worth(right, put)
            match op:
                case "+":
                    return a + b
                case "-":
                    return a - b
                case "*":
                    return a * b
                case "/":
                    return a / b
            return a**b
        case Apply(function, argument) if function in _FUNCTIONS:
            return _FUNCTIONS[function](_worth(argument, put))
    raise _OpenError


def conditions_of(
    given: Iterable[Claim], letters_of: Callable[[Expression], Iterable[tuple[str, int]]]
) -> Iterator[Claim]:
    """Comparisons of quantities with numbers as those of the student's letters for them.

    ``letters_of`` gives the letters that are worth a quantity, with 1, or its opposite, with -1.
    """
    for claim in given:
        if claim.sign not in _COMPARISONS:
            continue
        for name, sense in letters_of(claim.left):
            if sense > 0:
                yield replace(claim, left=Letter(name))
            else:
                yield Claim(Letter(name), _TURNED[claim.sign], Negate(claim.right))
