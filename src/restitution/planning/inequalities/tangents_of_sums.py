"""The tangent of a sum or a difference of two letters for angles, in the letters of the data."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.explaining.lines.derivation import Move, Relation
from restitution.expression.tree import Apply, Binary, Letter, is_function
from restitution.planning.angles.turn_lines import tangent_of
from restitution.planning.formulas.turns import Form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene


def write_tangent_of_a_sum(scene: Scene, relation: Relation, tangents: Sequence[int]) -> int | None:
    """The line of the tan(α ± β) in an inequality; None where it has none.

    ``tangents`` are the lines that say what the angles are worth of which the letters tell.
    """
    subjects = {
        side: side.argument
        for link in relation.only
        for side in (link.left, link.right)
        if is_function(side, "tan") and isinstance(side.argument, Binary)
    }
    if len(subjects) != 1:
        return None
    ((subject, whole),) = subjects.items()
    if not isinstance(whole.left, Letter) or not isinstance(whole.right, Letter):
        return None
    forms: dict[str, Form] = {"+": "sum", "-": "difference"}
    form = forms.get(whole.op)
    if form is None:
        return None
    ratios = [Apply("tan", side) for side in (whole.left, whole.right)]
    links = {line: scene.desk.last_link(line) for line in tangents}
    worth = {link.left: link.right for link in links.values()}
    lines = [line for line, link in links.items() if link.left in ratios]
    if not lines:
        return None
    mark = scene.desk.mark()
    names = scene.judge.known(side.name for side in (whole.left, whole.right))
    first = scene.judge.write(
        (Move("identity", "sum-of-angles"),),
        names,
        chain(subject, (tangent_of(form, *ratios), None)),
    )
    if first is None:
        return None
    values = [worth.get(ratio, ratio) for ratio in ratios]
    both = tree_of(sp.Mul(*map(scene.scalar, values)))
    put = tangent_of(form, values[0], values[1], both)
    short = tree_of(sp.factor(scene.scalar(put)))
    relation = chain(subject, (put, None), (short, "rearrange"))
    last = scene.judge.write((Move("put"),), (first, *lines), relation)
    if last is None:
        scene.desk.back(mark)
    return last
