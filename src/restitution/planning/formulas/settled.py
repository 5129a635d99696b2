"""Components with what is given of letters put in, where that makes them no longer."""

from __future__ import annotations

import sympy as sp

from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import Move, numbers_in
from restitution.explaining.lines.trees import has_ratio_of_a_sum
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Quantity,
    plain_letter,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    tree_of,
)
from restitution.planning.writing.scene import Scene
from restitution.problem import Find, Value


def settled(scene: Scene, tree: Expression) -> Source | None:
    """What a component, or a letter, is known to be; None where it is not.

    Where letters in it have been found since, what that makes of it is a line of its own, unless
    a number only takes the place of a letter in a line of the same part.
    """
    known = scene.desk.known(tree)
    if known is None:
        return None
    own = known.value if known.value.is_Symbol else -known.value
    if own.is_Symbol:
        last = settled(scene, plain_letter(own.name))
        if last is None or own == known.value or not isinstance(tree, Letter):
            return known  # w = v says it; of w = −v the value is a line
    if known.form is not None and has_ratio_of_a_sum(known.form):
        return _by_a_sum(scene, tree, known, known.form)
    value, refs = scene.put(known.value)
    lines = numbers_in(known.refs)
    if value == known.value or len(lines) != 1:
        return known
    (line,) = lines
    if (
        _is_plain(known.value, value)
        and scene.desk.is_of_this_part(line)
        and not _is_asked(scene, tree)
    ):
        return known
    link = scene.desk.last_link(line)
    if link.left != tree and (link.right != tree or value.free_symbols):
        return known
    move, relation = Move("put"), chain(tree, (tree_of(value), None))
    if not scene.judge.follows(move, (line, *refs), relation):
        # What an identity makes shorter stands as it is first: ½(1 + tan²α)u cos α.
        put = known.value.xreplace({e: scene.put(e)[0] for e in known.value.free_symbols})
        longer = (tree_of(put, as_it_is=True), None)
        relation = chain(tree, longer, (tree_of(value), "identity"))
    line = scene.desk.write(move, (line, *refs), relation)
    return scene.desk.know(tree, value, (line,))


def _by_a_sum(scene: Scene, tree: Expression, known: Source, form: Expression) -> Source:
    """A component after a wall by the sine of a difference: ``5 sin(60° − α)``, in a line.

    It goes on to what that comes to, if α has been found.
    """
    match tree:
        case Quantity(_, (Quantity("velocity", (Name(body),), int(event)), _)):
            pass
        case _:
            return known
    value, more = scene.put(known.value)
    expanded, worth = tree_of(known.value), tree_of(value)
    relation = chain(tree, (form, None), (expanded, "identity"), (worth, "put"))
    move = Move("define", "component", event, (body,))
    sources = [ref for ref in known.refs if not str(ref).startswith(_OF_THE_DATA)]
    axis = scene.frame(event).names_axis("along")
    refs = scene.judge.enough(move, together(sources, more), relation, axis)
    if refs is None:
        return known
    return scene.desk.know(tree, value, (scene.desk.write(move, refs, relation),))


# What a speed and an angle tell, with no need of how the body came.
_OF_THE_DATA = ("velocity ", "wall ", "axis ")


def _is_asked(scene: Scene, tree: Expression) -> bool:
    """Whether a letter is asked: its value then stands before it is used."""
    asked = [item for step in scene.part.steps if isinstance(step, Find) for item in step.items]
    values = [item.expression for item in asked if isinstance(item, Value)]
    return isinstance(tree, Letter) and tree in values


# With a denominator up to this, numbers are multiplied in one's head.
_EASY = 12


def _is_plain(before_: sp.Expr, after_: sp.Expr) -> bool:
    """Whether a product of letters and a rational number still is one, of one letter less."""
    return bool(after_.free_symbols) and not (
        sp.Mul.make_args(before_)[0].is_Add
        or atoms_in(before_, sp.Add, sp.Function, sp.Pow)
        or atoms_in(after_, sp.Add, sp.Function, sp.Pow)
        or after_.as_coeff_Mul()[0].q > _EASY
        or len(before_.free_symbols - after_.free_symbols) != 1
    )
