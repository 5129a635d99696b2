"""Angles that are added up, and what those may be that are not named: ``tan = 3/4``."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    is_binary,
    walk,
)
from restitution.practice.judging.entries import Entry, names_of
from restitution.practice.letters.candidates import TURNS, Candidate
from restitution.practice.reading.phrase_names import UNNAMED_ANGLE, UNNAMED_DIRECTION
from restitution.practice.script import Claim
from restitution.practice.worlds.world import World

INVERSE = {"sin": "arcsin", "cos": "arccos", "tan": "arctan"}
"""The function that gives an angle by its sine, its cosine or its tangent."""

# Right and straight angles, and whole turns, in degrees.
_TURNED = (90, 180, 270, 360)
_UNNAMED = frozenset({UNNAMED_ANGLE, UNNAMED_DIRECTION})


def unnamed_in(claim: Claim) -> frozenset[str]:
    """The angles without a name in a claim."""
    return names_of(claim) & _UNNAMED


def with_angles(
    claim: Claim, world: World, known: Iterator[Candidate]
) -> Iterator[tuple[Expression, Claim]]:
    """Each angle that may be meant, of the statement or of the motion, and the claim with it."""
    angles: list[Expression] = [Letter(name) for name in sorted(world.angles)]
    angles += [candidate.quantity for candidate in known if candidate.kind in TURNS]
    turned = UNNAMED_DIRECTION in unnamed_in(claim)
    for angle in angles:
        forms: list[Expression] = [angle, Binary("-", RIGHT_ANGLE, angle)]
        if turned:
            forms += [*map(Negate, forms), Binary("-", STRAIGHT_ANGLE, angle)]
        for form in forms:
            put: dict[Expression, Expression] = {Letter(name): form for name in _UNNAMED}
            left, right = (exchanged(side, put) for side in (claim.left, claim.right))
            yield form, replace(claim, left=left, right=right)


def is_sum_of_angles(entry: Entry) -> bool:
    """Whether a claim gives an angle as a sum of angles: no law of an impact is in it."""
    left, right = entry.claim.left, entry.claim.right
    meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
    angle = any(isinstance(node, Quantity) and node.kind in ANGLES for node in walk(meant))
    sums = is_binary(right, "+", "-")
    return angle and sums and not any(isinstance(node, Apply | Letter) for node in walk(right))


def adds_two_angles(tree: Expression) -> bool:
    """Whether two angles that are not right or straight ones are added up: ``β + α``."""
    if not is_binary(tree, "+", "-"):
        return False
    pending: list[Expression] = [tree.left, tree.right]
    own = 0
    while pending:
        node = pending.pop()
        if is_binary(node, "+", "-"):
            pending += [node.left, node.right]
        elif not (isinstance(node, Number | Degrees) and node.value in _TURNED):
            own += 1
    return own > 1
