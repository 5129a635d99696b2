"""How plain the values of a question are, beside those of another."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution.expression.tree import Binary, Number, walk
from restitution.practice.questions import doubles
from restitution.problem import Problem, trees
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.solving.equations.solution import Solution

_SHORT = 9  # a denominator of one digit is no long fraction
_TINY = 1e-7
_SMALL = 100  # and a number up to this is no large one under a root


@dataclass(frozen=True)
class _Kind:
    """The kind of a value: its roots, the largest number under one, its denominator."""

    roots: int = 0
    under: int = 0
    denominator: int = 1


def excess(solution: Solution, original: Solution) -> tuple[int, ...]:
    """By how much the values of a question are less plain than those of another like it.

    How many answers have more roots; how many have a longer fraction or a larger number under a
    root; how much longer the fractions of the data and of the route are. All are 0 where no value
    is less plain.
    """
    pairs = list(zip(_answers(solution), _answers(original), strict=True))
    roots = sum(one.roots > other.roots for one, other in pairs)
    long = sum(
        one.denominator > max(_SHORT, other.denominator) or one.under > max(_SMALL, other.under)
        for one, other in pairs
    )
    longest = max((kind.denominator for kind in _answers(original)), default=1)
    allowed = max(_SHORT, longest, *_route(original))
    return roots, long, max(0, max(_route(solution)) - allowed)


class Screen:
    """A quick look in doubles at whether answers that were fractions would be none."""

    def __init__(self, original: Solution) -> None:
        from restitution.practice.questions.diagnosis import samples

        self._samples = tuple(samples(original))
        self._fractions = {
            index: tuple(_fractions_of(original, index))
            for index in {sample.index for sample in self._samples}
        }

    def passes(self, problem: Problem) -> bool:
        """Whether each answer that was a fraction may be one in a question with other numbers."""
        for sample in self._samples:
            part = problem.parts[sample.index]
            story = doubles.fitted(problem, part, sample.values, sample.sought)
            try:
                numbers = () if story is None else doubles.answers(problem, part, story)
            except doubles.REFUSALS:
                continue
            expected = self._fractions[sample.index]
            if len(numbers) == len(expected) and any(
                longest and not _is_fraction(number, longest)
                for number, longest in zip(numbers, expected, strict=True)
            ):
                return False
        return True


def _fractions_of(solution: Solution, index: int) -> Iterator[int]:
    """For each answer in numbers of a part, component by component, the largest denominator of a
    fraction as plain; 0 where it is no fraction.
    """
    part = solution.problem.parts[index]
    for item in solution.parts[part.label].items:
        if item.kind in ("value", "vector"):
            for answer in item.answers[:1]:
                for number in _numbers(answer.value):
                    fraction = not answer.angle and isinstance(number, sp.Rational)
                    yield max(_SHORT, int(number.q)) if fraction else 0


def _is_fraction(number: float, longest: int) -> bool:
    near = Fraction(number).limit_denominator(longest)
    return abs(float(near) - number) < _TINY * max(1.0, abs(number))


def _answers(solution: Solution) -> list[_Kind]:
    """The kind of the first answer to each item."""
    kinds = []
    for part in solution.parts.values():
        for item in part.items:
            values = [answer.value for answer in item.answers[:1]]
            plain = item.kind in ("value", "vector")
            kinds.append(_kind(_numbers(values)) if plain else _Kind())
    return kinds


def _route(solution: Solution) -> list[int]:
    """The denominators of the data, and of the velocities after each event."""
    denominators = [1]
    for tree in trees(solution.problem):
        for node in walk(tree):
            match node:
                case Binary("/", Number(top), Number(under)) if under:
                    denominators.append(Fraction(top / under).denominator)
    for part in solution.parts.values():
        for branch in part.branches[:1]:
            for happening in branch.story.happenings:
                for velocity in happening.after.values():
                    denominators.append(_kind(_numbers(tuple(velocity))).denominator)
    return denominators


def _numbers(value: Any) -> Iterator[sp.Expr]:
    """The exact numbers and terms of a value, of a vector one by one."""
    if isinstance(value, tuple | list):
        for part in value:
            yield from _numbers(part)
    else:
        yield sp.sympify(value, strict=True)


def _kind(values: Iterator[sp.Expr]) -> _Kind:
    roots: set[sp.Expr] = set()
    denominator = 1
    for value in values:
        for node in sp.preorder_traversal(value):
            if isinstance(node, sp.Rational):
                denominator = max(denominator, int(node.q))
            if node.is_Pow and node.exp.is_Rational and node.exp.q != 1 and node.base.is_number:
                roots.add(node.base)
    under = [int(max(abs(base.p), base.q)) for base in roots if isinstance(base, sp.Rational)]
    return _Kind(len(roots), max(under, default=0), denominator)
