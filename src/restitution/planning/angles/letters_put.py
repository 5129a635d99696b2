"""A ratio of an angle that stands above: as it is, or with the values that a later part gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Apply, Expression, Letter, Quantity, has_quantity, walk
from restitution.planning.axes.offsets import ratios_by_offsets
from restitution.planning.formulas.named_angles import letter_known, letter_of
from restitution.planning.formulas.turns import velocities_of
from restitution.planning.writing.angle_ratios import given_ratio
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.ratio_of_an_angle import RANGES, Ratio
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles


def with_letters_put(scene: Scene, own: Ratio, named: Ref | None = None) -> Ratio:
    """A ratio whose line has letters that are known by now, by a line with their values.

    ``named`` says what the letter of the angle is, where the line has the angle in its place.
    """
    link = scene.desk.last_link(own.line)
    is_of_the_letter = link.left == Apply(own.function, Letter(own.letter))
    if not (is_of_the_letter or named is not None) or link.sign != "=":
        return own
    more = () if named is None else (named,)
    value = sp.sympify(scene.scalar(link.right), strict=True)
    if not value.free_symbols:
        return own
    if value.free_symbols & scene.kept:
        return _by_offsets(scene, own, value)
    values, given = _given_values(scene, link.right)
    whole = rebuilt(link.right, lambda tree: values.get(tree, tree))
    put = tidy(scene.scalar(whole))
    line = None if put.free_symbols else _put(scene, own, whole, put, (*more, *given))
    if line is None:
        put, refs = scene.put(value)
        changed = refs and put != value
        line = _put(scene, own, tree_of(put), put, (*more, *refs)) if changed else None
    return own if line is None else replace(own, line=line, value=tidy(put))


def _by_offsets(scene: Scene, own: Ratio, value: sp.Expr) -> Ratio:
    """The ratio with those of the angle of a line of centres put in by its offset."""
    ratios, refs = ratios_by_offsets(scene, value)
    put = tidy(value.xreplace(ratios))
    line = _put(scene, own, tree_of(put), put, refs)
    return own if line is None else replace(own, line=line, value=put)


def ratio_of_an_answer(scene: Scene, asked: Quantity, functions: Sequence[str]) -> Ratio | None:
    """The ratio of an angle that is an answer in letters, with the numbers put in that these are.

    None where no answer says it, or where letters are left.
    """
    named = letter_known(scene, asked)
    kind = asked.kind if asked.kind in RANGES else "deflection"
    for end in () if named is None else reversed(scene.desk.ends):
        match scene.desk.line(end.line).relation:
            case Relation(((Link(Apply(function, angle), "="), *_),)) if (
                named is not None
                and angle in (Letter(named[0]), asked)
                and function in functions
                and scene.desk.holds(end.line)
            ):
                name, meaning = named[0], None if isinstance(angle, Letter) else named[1]
            case _:
                continue
        value = tidy(scene.scalar(scene.desk.last_link(end.line).right))
        own = Ratio(end.line, name, function, value, RANGES[kind].format(name))
        put = with_letters_put(scene, own, meaning)
        if put is not own and not put.value.free_symbols:
            return put
    return None


def ratio_that_stands(scene: Scene, asked: Quantity) -> Ratio | None:
    """The cosine or tangent of an angle between two velocities that stands in a line already.

    What was to be shown has it of the angle itself, not of its letter, and that in letters too.
    """
    if velocities_of(scene, asked) is None:
        return None
    named = letter_known(scene, asked)
    shown = {end.line for end in scene.desk.ends if end.shown}
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation(((Link(Apply("cos" | "tan" as function, angle), "="), *_),)) if (
                scene.desk.holds(line.number)
                and (angle == asked or (named is not None and angle == Letter(named[0])))
            ):
                right = scene.desk.last_link(line.number).right
            case _:
                continue
        if has_quantity(right):
            continue
        value = tidy(scene.scalar(right))
        if value.free_symbols and (
            line.number not in shown
            or scene.put(value)[1]
            or scene.lets_in(Link(angle, "=", right))
            or scene.model.proved_sign(scene.model.in_data(value)) is None
        ):
            continue
        letter, meaning = named or letter_of(scene, asked)
        side = (meaning,) if angle == asked else ()
        extent = RANGES["deflection"].format(letter)
        return Ratio(line.number, letter, function, value, extent, side)
    return None


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
    subject = Apply(own.function, Letter(own.letter))
    relation = chain(subject, (form, None), (tree_of(value), "rearrange"))
    premises = scene.judge.enough(Move("put"), (own.line, *dict.fromkeys(refs)), relation)
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


__all__ = ["ratio_of_an_answer", "ratio_that_stands", "with_letters_put"]
