"""Every sensible reading of a side: the grammar is asked for each, a bounded number of times."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from restitution.expression.tree import Expression, is_binary, walk
from restitution.practice.reading.angles import in_degrees
from restitution.practice.reading.cursor import UnreadableError
from restitution.practice.reading.grammar import Parser, is_vector
from restitution.practice.reading.tokens import Token, Usage
from restitution.records import dataclass

MAX_READINGS = 12


@dataclass(frozen=True)
class Side:
    """A side of a relation in one reading; ``other`` is its value with the lower sign of a ±."""

    tree: Expression
    other: Expression | None = None


def read_sides(
    tokens: Sequence[Token], usage: Usage, line: int, end_column: int
) -> tuple[Side, ...]:
    """Every reading of the tokens of one side, the most natural first.

    Raises UnreadableError where no reading of them is an expression.
    """
    sides: dict[Expression, Side] = {}
    fault: UnreadableError | None = None
    pending: list[dict[str, int]] = [{}]
    tried: set[tuple[tuple[str, int], ...]] = set()
    double = any(token.kind == "±" for token in tokens)
    while pending and len(tried) < 3 * MAX_READINGS and len(sides) < MAX_READINGS:
        picks = pending.pop(0)
        key = tuple(sorted(picks.items()))
        if key in tried:
            continue
        tried.add(key)
        parser = Parser(tokens, usage, line, end_column, picks)
        try:
            tree = in_degrees(parser.side(), usage.angles)
            other = None
            if double:
                lower = Parser(tokens, usage, line, end_column, picks, lower=True)
                other = in_degrees(lower.side(), usage.angles)
            if not _is_absurd(tree):
                sides.setdefault(tree, Side(tree, other))
        except UnreadableError as error:
            fault = fault or error
        pending.extend(_further(picks, parser.asked))
    if not sides:
        raise fault or UnreadableError("an expression", tokens[0].column if tokens else end_column)
    return tuple(sides.values())


def _further(picks: dict[str, int], asked: dict[str, int]) -> Iterator[dict[str, int]]:
    """The picks that differ from these by one more question, all of a kind and each alone."""
    if len(picks) >= 3:
        return
    for question, options in asked.items():
        if question in picks:
            continue
        for option in range(1, options):
            yield {**picks, question: option}


def _is_absurd(tree: Expression) -> bool:
    """Whether a reading divides by a vector, which nobody means."""
    return any(is_binary(node, "/") and is_vector(node.right, frozenset()) for node in walk(tree))
