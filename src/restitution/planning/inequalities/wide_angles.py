"""Bounds of an angle that may be obtuse: by those of its cosine, which falls as the angle grows."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, turned
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    walk,
)
from restitution.planning.angles.scalar_angles import write_cosine, write_product_as_it_stands
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.turns import velocities_of
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.records import dataclass


@dataclass(frozen=True)
class Cosine:
    """The line ``cos(β) = …`` of an angle, its letter, and what is known of that."""

    line: int
    letter: Letter
    known: tuple[Ref, ...]

    @property
    def tree(self) -> Expression:
        """The cosine of the letter."""
        return Apply("cos", self.letter)


def cosine_of(claims: Comparing, angle: Quantity) -> Cosine | None:
    """The lines of the cosine of an angle between two velocities; None of another one."""
    claims.worths.determine_angle(angle)
    line = write_cosine(claims.scene, angle)
    if line is None:
        return None
    letter, meaning = letter_of(claims.scene, angle)
    return Cosine(line, Letter(letter), (meaning, f"0° <= {letter} <= 180°"))


def write_by_a_product(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """That an angle between velocities is more than 90°, or less, by the sign of their product.

    None for another inequality, or another angle.
    """
    match relation.options, quantities:
        case ((Link(Quantity() as angle, "<" | ">" as sign, right),),), [asked] if angle == asked:
            pair = velocities_of(claims.scene, angle)
        case _:
            return None
    if pair is None or right != RIGHT_ANGLE:
        return None
    mark = claims.worths.mark()
    claims.worths.determine_angle(angle)
    number = write_product_as_it_stands(claims.scene, pair)
    if number is not None:
        product = claims.scene.desk.relation(number).only[0].left
        signed = claims.compared([number], Relation(((Link(product, FLIPPED[sign], ZERO),),)))
        move = Move(
            "define",
            "perpendicular",
            max(stage for _, stage in pair) or None,
            tuple(dict.fromkeys(body for body, _ in pair)),
        )
        last = None if signed is None else claims.judge.write((move,), [signed], relation)
        if last is not None:
            return last
    claims.worths.back(mark)
    return None


def write_by_cosine(
    claims: Comparing, quantities: Sequence[Quantity], relation: Relation
) -> int | None:
    """The bounds of an angle between velocities, of which one is an obtuse angle, or a right one.

    The cosine only grows, or only falls, with a letter; of a right angle it has a sign. None for
    another angle.
    """
    if len(quantities) != 1 or not any(_is_obtuse(claims, link) for link in relation.only):
        return None
    (angle,) = quantities
    mark = claims.worths.mark()
    own = cosine_of(claims, angle)
    if own is not None:
        links = [link if link.left == angle else turned(link) for link in relation.only]
        ends = [Link(own.tree, FLIPPED[e.sign], _cosine(claims, e.right)) for e in links]
        # The least angle has the greatest cosine: of two ends the second comes first.
        ends = [turned(ends[1]), ends[0]] if len(ends) == 2 else ends
        within = Relation((tuple(ends),))
        signed = len(ends) == 1 and ZERO in (ends[0].left, ends[0].right)
        if signed:
            bounds = claims.compared([own.line], within)
        else:
            bounds = claims.monotone(own.line, within)
        if bounds is not None:
            last = compared_by_cosine(claims, own, bounds, relation)
            if last is not None:
                return last
    claims.worths.back(mark)
    return None


def compared_by_cosine(
    claims: Comparing, own: Cosine, bounds: int, relation: Relation
) -> int | None:
    """Bounds of an angle by those of its cosine: an end that needs it is its inverse cosine."""
    links = tuple(
        Link(_plain(claims, link.left), link.sign, _plain(claims, link.right))
        for link in relation.only
    )
    for target in (relation, Relation((links,))):
        last = claims.judge.write((Move("compare"),), [bounds, *own.known], target)
        if last is not None:
            return last
    return None


def _plain(claims: Comparing, side: Expression) -> Expression:
    """An obtuse angle as an inverse cosine, unless it is in degrees; any other side itself."""
    if isinstance(side, Binary) and any(isinstance(node, Apply) for node in walk(side)):
        return Apply("arccos", _cosine(claims, side))
    return side


def _is_obtuse(claims: Comparing, link: Link) -> bool:
    """Whether a bound is an angle of 90° or more."""
    for side in (link.left, link.right):
        if not has_quantity(side):
            value = sp.sympify(claims.scene.scalar(side), strict=True)
            return bool(value.is_number and value >= sp.pi / 2)
    return False


def _cosine(claims: Comparing, bound: Expression) -> Expression:
    return tree_of(tidy(sp.cos(sp.sympify(claims.scene.scalar(bound), strict=True))))
