"""What is known by now, put into an equation before it is closed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbols_in
from restitution.explaining.lines.derivation import (
    Link,
    Move,
    MoveId,
    Ref,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_quantity,
    is_binary,
    is_function,
    letters,
)
from restitution.planning.closing.ratios import (
    with_tangents,
    without_sums,
)
from restitution.planning.closing.settled_letters import settled_letter
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.writing.angle_ratios import write_other_ratio
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    ZERO,
    swept,
    tree_of,
)
from restitution.planning.writing.scene import Scene


def with_known(scene: Scene, number: int, symbol: sp.Symbol | None = None) -> int:
    """The line with everything put in that is known, as a line; the same line without that."""
    number = with_tangents(scene, _with_angles(scene, number, symbol))
    link = scene.desk.last_link(number)
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    trees = list(_open_trees(link))
    for tree in trees:
        if isinstance(tree, Apply) and tree.argument in trees and _is_known(scene, tree.argument):
            continue  # beside sin(60° − 45°) stands sin 45°
        source = _known_tree(scene, tree, symbol)
        if source is not None:
            angle = isinstance(tree, Letter) and is_angle(scene, tree.name)
            values[tree] = tree_of(source.value, angle=angle)
            refs += source.refs
    if not values or number in refs:
        return number
    left, right = (_settled(swept(_replaced(e, values))) for e in (link.left, link.right))
    own = scene.desk.line(number)
    start: tuple[Ref, ...] = own.premises if own.move.id == "fact" else (number,)
    relation = chain(left, (right, None), *_worked_out(scene, left, right))
    return scene.desk.write(Move("put"), (*start, *together(refs)), relation)


def _worked_out(
    scene: Scene, left: Expression, right: Expression
) -> list[tuple[Expression, MoveId]]:
    """The number that a ratio of an angle, or its square, is by a sum of numbers."""
    base = left.left if is_binary(left, "^") else left
    if not isinstance(base, Apply) or letters(right) or has_quantity(right):
        return []
    value = tree_of(tidy(scene_value(scene, right)))
    return [] if value == right else [(value, "rearrange")]


def _settled(tree: Expression) -> Expression:
    """A side in which nothing is left: 0."""
    match tree:
        case Binary("-", left, right) if left == right:
            return ZERO
    return tree


def _with_angles(scene: Scene, number: int, symbol: sp.Symbol | None) -> int:
    """The line with sums of angles by the formulae, where an angle is known."""
    for other in sorted(symbols_in(residual(scene, number)), key=lambda s: s.name):
        known = scene.desk.known(Letter(other.name))
        if _is_known(scene, Letter(other.name)):
            continue  # 60° − 45° is an angle by itself
        if other != symbol and known is not None and is_angle(scene, other.name):
            written = without_sums(scene, number, other)
            if written is not None:
                number = written
    return number


def _is_known(scene: Scene, letter: Expression) -> bool:
    """Whether a letter is known as a number of degrees."""
    known = scene.desk.known(letter)
    return known is not None and _is_in_whole_degrees(known.value)


def _is_in_whole_degrees(angle: sp.Expr) -> bool:
    """Whether an angle is a number of degrees, and no inverse of a ratio."""
    degrees = sp.sympify(angle, strict=True) * 180 / sp.pi
    return bool(degrees.is_Integer and degrees != 0)


def _open_trees(link: Link) -> Iterable[Expression]:
    """Letters, and ratios of letters as one, for which values may be put in."""
    pending: list[Expression] = [link.left, link.right]
    seen: dict[Expression, None] = {}
    while pending:
        tree = pending.pop()
        if isinstance(tree, Letter) or is_ratio(tree):
            seen[tree] = None
        else:
            if _is_of_a_multiple(tree):
                seen[tree] = None
            pending += _parts(tree)
    return seen


def _is_of_a_multiple(tree: Expression) -> bool:
    """Whether a tree is a ratio of a multiple of a letter, or of half of it."""
    match tree:
        case Apply(
            "sin" | "cos" | "tan", Binary("*", Number(), Letter()) | Binary("/", Letter(), Number())
        ):
            return True
    return False


def _parts(tree: Expression) -> list[Expression]:
    values = (getattr(tree, field.name) for field in fields(tree) if field.name != "place")
    return [value for value in values if isinstance(value, Expression)]


def is_angle(scene: Scene, name: str) -> bool:
    """Whether a letter stands for an angle."""
    role = scene.model.unknowns.roles.get(name)
    return role is not None and role.kind == "angle"


def is_ratio(tree: Expression) -> bool:
    """Whether a tree is the sine, cosine or tangent of a letter."""
    return is_function(tree, "sin", "cos", "tan") and isinstance(tree.argument, Letter)


def _with(tree: Expression, values: Mapping[Expression, Expression]) -> Expression:
    return rebuilt(tree, lambda tree: values.get(tree, tree))


def _replaced(tree: Expression, values: Mapping[Expression, Expression]) -> Expression:
    """A tree with values for ratios, and then for letters."""
    for ratios in (True, False):
        chosen = {tree: value for tree, value in values.items() if is_ratio(tree) is ratios}
        tree = _with(tree, chosen)
    return tree


def _known_tree(scene: Scene, tree: Expression, symbol: sp.Symbol | None) -> Source | None:
    match tree:
        case Apply("sin" | "cos" | "tan" as kind, Binary() as multiple) if _is_of_a_multiple(tree):
            if symbol is not None and symbol.name in letters(multiple):
                return None
            value, refs = scene.put(getattr(sp, kind)(scene.scalar(multiple)))
            return Source(value, refs) if refs and value.is_number else None
        case Letter(name) if symbol is None or name != symbol.name:
            known = scene.desk.known(tree)
            if known is None or isinstance(known.value, tuple):
                return None
            value, refs = scene.put(known.value)
            if value != known.value and not value.free_symbols & scene.model.final.keys():
                return settled_letter(scene, tree, known, Source(value, refs))
            return Source(value, together(known.refs, refs))
        case Apply("sin" | "cos" | "tan" as kind, Letter(name)):
            if symbol is not None and name == symbol.name:
                return None
            letter = scene.model.unknowns.letter(name)
            known = scene.desk.known(tree)
            if known is None and scene.desk.known(Letter(name)) is not None:
                write_other_ratio(scene, letter, kind)
            value, refs = scene.put(getattr(sp, kind)(letter))
            return Source(value, refs) if refs else None
    return None


def unknown_of(scene: Scene, number: int, symbol: sp.Symbol) -> sp.Symbol:
    """The unknown of a line; it may be another than that of the equation behind it."""
    own = scene.unknown(residual(scene, number))
    if symbol in own or len(own) != 1:
        return symbol
    (other,) = own
    return other
