"""A ratio of an angle in letters, of which a later part gives the values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Apply, Expression, Letter, walk
from restitution.planning.writing.angle_ratios import given_ratio
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.ratio_of_an_angle import Ratio
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles


def with_letters_put(scene: Scene, own: Ratio) -> Ratio:
    """A ratio whose line has letters that are known by now, by a line with their values."""
    link = scene.desk.last_link(own.line)
    if link.left != Apply(own.function, Letter(own.letter)) or link.sign != "=":
        return own
    value = sp.sympify(scene.scalar(link.right), strict=True)
    if not value.free_symbols:
        return own
    values, given = _given_values(scene, link.right)
    whole = rebuilt(link.right, lambda tree: values.get(tree, tree))
    put = tidy(scene.scalar(whole))
    line = None if put.free_symbols else _put(scene, own, whole, put, given)
    if line is None:
        put, refs = scene.put(value)
        changed = refs and put != value
        line = _put(scene, own, tree_of(put), put, refs) if changed else None
    return own if line is None else replace(own, line=line, value=tidy(put))


def _given_values(
    scene: Scene, tree: Expression
) -> tuple[Mapping[Expression, Expression], list[Ref]]:
    """The values of letters and of ratios of angles that stand in a tree, and what gives them."""
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    for node in walk(tree):
        match node:
            case Apply(_, Letter(name)) if name in scene.ratio_facts:
                ratio, right, ref = given_ratio(scene, name)
                if ratio == node:
                    values[node], refs = right, [*refs, ref]
            case Letter(name):
                known = scene.desk.known(node)
                role = roles(scene.problem).get(name)
                if known is None:
                    continue
                put, more = scene.put(known.value)
                if not put.free_symbols:
                    angle = role is not None and role.kind == "angle"
                    values[node] = tree_of(put, angle=angle)
                    refs += [*known.refs, *more]
    return values, refs


def _put(
    scene: Scene, own: Ratio, form: Expression, value: sp.Expr, refs: Sequence[Ref]
) -> int | None:
    """The line of a ratio with values in it; None where it does not follow."""
    subject = scene.desk.last_link(own.line).left
    relation = chain(subject, (form, None), (tree_of(value), "rearrange"))
    premises = scene.judge.enough(Move("put"), (own.line, *dict.fromkeys(refs)), relation)
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


__all__ = ["with_letters_put"]
