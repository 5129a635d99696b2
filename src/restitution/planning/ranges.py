"""The range of a letter or of a quantity, as one relation with its ends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from restitution.explaining.derivation import Link, Relation, Sign
from restitution.expression.tree import Expression
from restitution.planning.claims import Claims
from restitution.planning.desk import NotPlannedError
from restitution.planning.forms import tree_of
from restitution.planning.order import Solver
from restitution.planning.scene import Scene
from restitution.solve.solution import ItemResult


def write_range(
    scene: Scene,
    solver: Solver,
    asked: Expression,
    links: Sequence[Link],
    name: str,
    shown: bool = False,
) -> None:
    """Writes the lines of a range, of which the last says both ends."""
    relation = Relation((tuple(links),))
    with Claims(scene, solver) as claims:
        line = claims.write(relation)
        line = claims.join_the_rest(line, relation)
    scene.desk.end(name, line, relation, shown=shown)


def relation_of(asked: Expression, result: ItemResult) -> tuple[Link, ...]:
    """The range as links: ``a < x <= b``. Raises NotPlannedError for what is no interval."""
    if len(result.distinct) != 1 or result.distinct[0].condition:
        raise NotPlannedError("a range in cases")
    answer = result.distinct[0]
    own = answer.value
    if not isinstance(own, sp.Interval):
        raise NotPlannedError("a range in several parts")
    links: list[Link] = []
    low, high = (_end(each, answer.angle) for each in (own.start, own.end))
    if low is not None and high is not None:
        left: Sign = "<" if own.left_open else "<="
        right: Sign = "<" if own.right_open else "<="
        return Link(low, left, asked), Link(asked, right, high)
    if low is not None:
        links.append(Link(asked, ">" if own.left_open else ">=", low))
    if high is not None:
        links.append(Link(asked, "<" if own.right_open else "<=", high))
    if not links:
        raise NotPlannedError("a range without ends")
    return tuple(links)


def _end(value: Any, angle: bool) -> Expression | None:
    if value in (sp.oo, -sp.oo):
        return None
    return tree_of(value, angle=angle, as_it_is=angle)
