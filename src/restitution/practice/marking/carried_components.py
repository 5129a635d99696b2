"""Components that a line carries: in a velocity, a speed or a tangent, or seen in a remark."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import permutations

from restitution.explaining.lines.derivation import FLIPPED
from restitution.expression.tree import (
    Expression,
    Number,
    Quantity,
    is_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.judging.entries import is_monomial
from restitution.practice.marking.alternatives import Alternatives
from restitution.practice.marking.line_contents import (
    listed_numbers,
    numbers_into_a_wall,
    sizes_of,
)
from restitution.practice.marking.lines import chains, is_slip
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.marking.sides import (
    is_fine,
    names_in,
)
from restitution.records import dataclass

_STAYING = re.compile(r"\b(perp\w*|across|parallel|unchanged|stays?|same)\b", re.IGNORECASE)
_SEVERAL = 2
_OF_ACROSS = ("across-changed", "across-exchanged")


@dataclass(frozen=True, eq=False)
class CarriedComponents(Alternatives):
    """Whether a line has the component of a point, though it states nothing about it."""

    def is_seen(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the value of a point stands in a line that states nothing about it.

        A whole number is none, as too many are alike, but beside a word such as *perp*.
        """
        link = point.link
        slipped = line.verdict == "false" and is_slip(line) and bool(line.line.links)
        if link is None or point.shown or not (line.verdict in ("remark", "true") or slipped):
            return False
        if not isinstance(link.left, Quantity) or self.is_direction(point):
            return False
        if line.verdict == "true" and self.is_product(point, line):
            return True
        # What is worked out without a name is seen as it stands, and so if wrongly: 0.6 × 8 sin 40.
        bare = bool(line.uses) and all(use.principle == "arithmetic" for use in line.uses)
        worked = slipped or (line.verdict == "true" and bare and not line.line.values)
        left = line.line.links[0].readings[0].left if worked and line.line.links else None
        values = line.line.values if left is None else () if any(names_in(left)) else (left,)
        across = point.principle == "unchanged" and bool(_STAYING.search(line.line.text))
        at_wall = point.principle in ("component", "restitution") and len(point.bodies) < _SEVERAL
        before = point.principle == "component"
        into = numbers_into_a_wall(line.line.text, before=before) if at_wall else frozenset[int]()
        if before and line.verdict == "remark":
            own = (x.stage for x in quantities_in(link.left) if x.kind == "velocity")
            start = set(own) == {0}
            into |= listed_numbers(line.line.text, before=start)
        return any(
            any(
                self._is_worth(value, tree, line)
                or (is_fine(value) and self._is_rounded_to(value, tree, line))
                for tree in sizes_of(link.left)
            )
            or self._is_vector_part(value, point, line)
            for value in values
            if across
            or not (isinstance(value, Number) and value.value.denominator == 1)
            or value.value in into
        )

    def is_product(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line works out the scalar product of a point, over the size of its vector too.

        ``(5i + j).(2i - j)/√5 = 9/√5``: the velocity stands in it by its components.
        """
        product = None if point.link is None else point.link.left
        if not is_quantity(product, "dot", "along"):
            return False
        return any(
            any(self._is_product_of(node, product, line) for node in walk(chain[0].left))
            and (
                product.kind == "along"
                or any(self._is_worth(chain[0].left, size, line) for size in sizes_of(product))
            )
            for chain in chains(line)
            if product.kind == "dot" or is_monomial(chain[0].left)
        )

    def _is_product_of(self, node: Expression, product: Quantity, line: JudgedLine) -> bool:
        """Whether a tree is the scalar product of the velocity of a point with a vector.

        For a component along a line that vector is along the line, and of any length:
        ``(5, 1).(3, 4) = 19``.
        """
        if not is_quantity(node, "dot"):
            return False
        velocity, axis = product.arguments
        for own, other in permutations(node.arguments):
            if self._is_worth(own, velocity, line) and (
                product.kind == "dot" or self._is_parallel(other, axis, self._meanings(line), line)
            ):
                return True
        return False

    def is_at_a_wall(self, point: MarkPoint) -> bool:
        """Whether a point is for the component of one velocity alone, as at a wall."""
        link = point.link
        if link is None:
            return False
        after = {quantity for quantity in quantities_in(link.left) if quantity.kind == "velocity"}
        return len(after) == 1 and len(point.bodies) < _SEVERAL

    def carries(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line uses the component of a point: in a velocity, a speed, or as a remark."""
        link = point.link
        if link is None or point.principle not in ("unchanged", "restitution"):
            return False
        own = point.principle == "unchanged"
        velocity = next(
            (quantity for quantity in quantities_in(link.left) if quantity.kind == "velocity"), None
        )
        if line.verdict == "remark":
            return any(
                (own and self._is_worth(value, link.right, line))
                or (velocity is not None and self._has_part(value, velocity, point, line))
                for value in line.line.values
            )
        if velocity is None or line.verdict not in ("true", "follows", "false"):
            return False
        wrong = line.verdict == "false"
        nameless = line.mistake is not None and line.mistake.id in (None, *_OF_ACROSS)
        if wrong and not own and not nameless:
            return False  # what is wrong in a velocity is most often the component that changes
        kinds = ("speed", "energy") if own and not wrong else ()
        if any(self.value_of(replace(velocity, kind=kind), line) is not None for kind in kinds):
            return True
        if not wrong and self._has_square(link.right, line):
            return True
        if not wrong and own and self._is_in_a_tangent(link.right, line):
            return True
        vector = self.value_of(velocity, line, open_=own and not wrong)
        return vector is not None and self._has_part(vector, velocity, point, line)

    def bounds_component(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true inequality has the component of a point in letters: ``5fu/12 > u/4``."""
        link = point.link
        if link is None or line.verdict != "true" or not isinstance(link.left, Quantity):
            return False
        known = letters(link.right)
        return any(
            claim.sign in FLIPPED
            and any(
                letters(side) == known and self._is_worth(side, link.left, line)
                for side in (claim.left, claim.right)
            )
            for chain in chains(line)
            for claim in chain
        )

    def gives_part(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true vector in numbers has the component for whose value a point is.

        ``v_A = -2i + 3j`` tells that of A along i.
        """
        link = point.link
        if link is None or line.verdict != "true" or point.letter != "A" or point.equation:
            return False
        match link.left:
            case Quantity("along" | "across", (Quantity("velocity") as velocity, _)):
                vector = self.value_of(velocity, line)
                return vector is not None and self._has_part(vector, velocity, point, line)
        return False
