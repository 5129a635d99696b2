"""Equations that no shape solves: their unknowns in one line, with the values of the solution."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.components.models import Model
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Letter
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.closing.known_values import with_known
from restitution.planning.closing.ratios import inside_functions
from restitution.planning.closing.roots import in_standard_form
from restitution.planning.formulas.impacts import residual
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import expanded, factor_powers, numerator
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def solve_together(scene: Scene, numbers: Sequence[int], asked: frozenset[sp.Symbol]) -> int:
    """Writes the values of all unknowns in some lines; what is ``asked`` comes last.

    Raises NotPlannedError where the lines do not fix as many unknowns as they are.
    """
    lines = list(dict.fromkeys(with_known(scene, number) for number in numbers))
    opened = {number: scene.unknown(residual(scene, number)) for number in lines}
    lines = [number for number in lines if opened[number]]
    unknowns = sorted(
        {symbol for number in lines for symbol in opened[number]},
        key=lambda value: (value in asked, value.name),
    )
    if not lines or len(unknowns) != len(lines):
        raise NotPlannedError(f"{len(lines)} equations for {len(unknowns)} unknowns")
    if len(lines) == 1:
        lines = [as_a_quadratic(scene, lines[0], unknowns[0])]
    models = scene.others or (scene.model,)
    options = [_values(scene, model, unknowns) for model in models]
    relation = Relation(tuple(dict.fromkeys(options)))
    names = symbol_names(*(residual(scene, number) for number in lines))
    refs = scene.judge.enough(Move("solve"), lines, relation, background(scene, names))
    if refs is None:
        raise NotPlannedError(f"{unknowns} are not fixed by their equations alone")
    line = scene.desk.write(Move("solve"), refs, relation)
    own = _values(scene, scene.model, unknowns)
    if len(relation.options) > 1:
        scene.desk.splits += ((line, relation.options.index(own)),)
        scene.others = tuple(
            model for model, option in zip(models, options, strict=True) if option == own
        )
    for symbol in unknowns:
        scene.desk.know(Letter(symbol.name), scene.final(symbol), (line,))
    return line


def as_a_quadratic(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """A line in the form ``ax² + bx + c = 0``, where it is of the second degree in its unknown."""
    above = numerator(residual(scene, number))
    if symbol in inside_functions(above) or not above.is_polynomial(symbol):
        return number
    factors = [base**power for base, power in factor_powers(above) if base.has(symbol)]
    whole = expanded(sp.Mul(*factors))
    if sp.degree(whole, symbol) != 2:
        return number
    number = multiplied_out(scene, number, symbol)
    return in_standard_form(scene, number, whole, symbol, Letter(symbol.name))


def _values(scene: Scene, model: Model, unknowns: Sequence[sp.Symbol]) -> tuple[Link, ...]:
    """The unknowns of a solution, each with its value."""
    roles = scene.model.unknowns.roles
    return tuple(
        Link(
            Letter(unknown.name),
            "=",
            tree_of(
                model.final[unknown],
                angle=unknown.name in roles and roles[unknown.name].kind == "angle",
            ),
        )
        for unknown in unknowns
    )
