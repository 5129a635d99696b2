"""What is required of the end of an item: that it is the answer of the solver, in its letters."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.exact.symbols import symbols_in
from restitution.explaining.lines.derivation import ItemEnd, Link, Relation, equality
from restitution.expression.tree import Apply, Expression, letters, walk
from restitution.planning.writing.checking import measured
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import derivative
from restitution.planning.writing.scene import Scene
from restitution.solving.equations.solution import ItemResult


def require_found(scene: Scene, asked: Expression) -> None:
    """Refuses an answer with a letter that the solution finds."""
    own = letters(asked)
    open_letters = {value.name for value in scene.model.final if value not in scene.free} - own
    for links in scene.desk.ends[-1].answer.options:
        if any(open_letters & letters(link.right) for link in links):
            raise NotPlannedError(f"an answer with {', '.join(sorted(open_letters))}")


def require_answer(scene: Scene, result: ItemResult) -> None:
    """Refuses an answer that is not that of the solver for all letters which a solution admits.

    That its lines are true is seen at the numbers of the solution, where signs may be others.
    """
    number, options = scene.model.branch.number, scene.desk.ends[-1].answer.options
    answer = next((answer for answer in result.answers if answer.solution == number), None)
    if answer is None or len(options) != 1 or options[0][-1].sign != "=":
        return
    written, wanted = (
        value if isinstance(value, tuple) else (value,)
        for value in (measured(scene.value(options[0][-1].right)), answer.value)
    )
    if len(written) != len(wanted):
        return  # nothing, for a vector
    for one, other in zip(written, wanted, strict=True):
        if symbols_in(other) and scene.model.differ(sp.sympify(one, strict=True), other):
            raise NotPlannedError("an answer that is another for some values of the letters")


def require_letters(scene: Scene, result: ItemResult) -> None:
    """Refuses an answer in letters that are not those of the solver's, which were asked for."""
    if not result.answers:
        return  # a value that cannot be, of which the solver gives no letters
    asked = {name for answer in result.answers for name in answer.letters}
    for links in scene.desk.ends[-1].answer.options:
        for link in links:
            named = {name for name in letters(link.right) - asked if f"let {name}" in scene.facts}
            if named:
                raise NotPlannedError(f"an answer in {', '.join(sorted(named))}")
            value = measured(scene.value(link.right))
            parts = value if isinstance(value, tuple) else (value,)
            others = {
                symbol.name
                for value in map(sp.sympify, parts)
                for symbol in symbols_in(value)
                if symbol.name not in asked and symbol.name in letters(link.right)
                # What cancels in the value is no letter of the answer.
                if not scene.model.identically_zero(derivative(value, symbol))
            }
            if others:
                raise NotPlannedError(f"an answer in {', '.join(sorted(others))}")


def require_form(scene: Scene, result: ItemResult) -> None:
    """Refuses a place or a length whose ratios of angles are not those of the answer.

    One in tangents, of an answer in sines and cosines, ends in the answer, and so does one in
    sines and cosines of an answer in tangents.
    """
    end = scene.desk.ends[-1]
    values = {answer.value for answer in result.answers if not isinstance(answer.value, tuple)}
    if len(values) != 1 or len(end.answer.options) != 1 or result.kind != "value":
        return
    (value,) = values
    kinds = {node.function for node in walk(end.answer.only[0].right) if isinstance(node, Apply)}
    ratios = {type(atom).__name__ for atom in value.atoms(*_RATIOS)}
    if ("tan" in kinds and ratios == {"sin", "cos"}) or (
        kinds & _NAMES == {"sin", "cos"} and ratios == {"tan"}
    ):
        _end_in(scene, end, value)
    elif kinds & _NAMES != ratios:
        raise NotPlannedError("an answer in another form")


def _end_in(scene: Scene, end: ItemEnd, value: Any) -> None:
    """Ends the last line of an item in the form of its answer, sines and cosines for a tangent."""
    line = scene.desk.line(end.line)
    assert isinstance(line.relation, Relation)
    last = Link(line.relation.only[-1].right, "=", tree_of(value), "rearrange")
    whole = replace(line, relation=Relation(((*line.relation.only, last),)))
    subject = end.answer.only[0].left
    scene.desk.lines[end.line - 1] = whole
    scene.desk.ends[-1] = replace(end, answer=equality(subject, last.right))
    scene.desk.know(subject, value, (end.line,))


_RATIOS = (sp.sin, sp.cos, sp.tan)
_NAMES = {"sin", "cos", "tan"}
