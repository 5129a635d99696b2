"""What a student has claimed so far, line by line, and what may be concluded from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Quantity,
    is_binary,
    is_quantity,
    letters,
    walk,
)
from restitution.practice.script import ANYWHERE, Claim, Decimal, Scope
from restitution.records import dataclass

Meanings = Mapping[str, Expression]


@dataclass(frozen=True)
class Entry:
    """A claim that stands in a line of a script, as it was read, with its letters' meanings.

    ``wrong`` tells that it is neither true nor follows; ``right`` that it is true in fact,
    ``coarse`` that it is so to two figures only.
    """

    number: int
    claim: Claim
    meanings: Meanings = field(default_factory=dict, compare=False)
    scope: Scope = ANYWHERE
    decimals: tuple[Decimal, ...] = ()
    right: bool = True
    wrong: bool = False
    coarse: bool = False

    @property
    def is_value(self) -> bool:
        """Whether it gives a letter or a quantity a value without letters."""
        return (
            self.claim.sign == "="
            and isinstance(self.claim.left, Letter | Quantity | Name)
            and is_numeric(self.claim.right)
        )


def is_numeric(tree: Expression) -> bool:
    """Whether a tree is of numbers alone; scalar products of vectors in numbers are too."""
    return not any(
        isinstance(node, Letter | Name) or (isinstance(node, Quantity) and node.kind != "dot")
        for node in walk(tree)
    )


def has_time_or_place(tree: Expression) -> bool:
    """Whether a quantity is a time or a place, or is made of one."""
    return any(is_quantity(node, "time", "position") for node in walk(tree))


def is_of_a_journey(entry: Entry) -> bool:
    """Whether a claim tells of a time or a place."""
    names = (entry.meanings[name] for name in names_of(entry.claim) if name in entry.meanings)
    return any(map(has_time_or_place, (entry.claim.left, entry.claim.right, *names)))


def is_monomial(tree: Expression) -> bool:
    """Whether a tree adds and subtracts nothing."""
    return not any(is_binary(node, "+", "-") for node in walk(tree))


def names_of(claim: Claim) -> frozenset[str]:
    """The letters and phrases of a claim."""
    sides = (claim.left, claim.right, *claim.others)
    return frozenset().union(*map(letters, sides))


def same_relation(one: Claim, other: Claim) -> bool:
    """Whether two claims are the same as they stand, perhaps with their sides exchanged."""
    if one.sign != other.sign:
        return False
    return (one.left, one.right) in ((other.left, other.right), (other.right, other.left))


def is_root_of(claim: Claim, entry: Entry) -> Claim | None:
    """What an earlier equation says where a letter has the value of a claim; None where neither.

    ``x = 3`` beside ``x² = 9`` gives ``3² = 9``; so does ``2 - x = -3`` where ``(2 - x)²`` is 9.
    """
    square = entry.claim.left
    if is_binary(square, "^") and square.left == claim.left and claim.sign == entry.claim.sign:
        return replace(entry.claim, left=replace(square, left=claim.right))
    if claim.sign != "=" or not isinstance(claim.left, Letter) or entry.claim.sign != "=":
        return None
    if claim.left.name not in names_of(entry.claim) or entry.is_value:
        return None
    put: dict[Expression, Expression] = {claim.left: claim.right}
    return Claim(exchanged(entry.claim.left, put), "=", exchanged(entry.claim.right, put))


def sources_of(claim: Claim, entries: Sequence[Entry]) -> tuple[int, ...]:
    """The numbers of the lines that are not true and share a letter with a claim, at most three."""
    names = names_of(claim)
    untrue = [entry for entry in entries if not entry.right]
    sharing = [entry.number for entry in untrue if names_of(entry.claim) & names]
    chosen = sharing or [entry.number for entry in untrue[-1:]]
    return tuple(dict.fromkeys(chosen[-3:]))
