"""Claims over bounded letters by interval arithmetic, where nothing is polynomial.

A box of values is cut in halves until the claim is certain on every piece, or there are too many.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.oracle.formula import All, Formula, Relation, Some, letters_of, negation, relations
from restitution.oracle.points import BeyondError, Program, box_signs
from restitution.oracle.roles import REAL, Role

MOST_BOXES = 600


def proves(claim: Formula, facts: Formula, roles: Mapping[str, Role]) -> bool:
    """Whether the claim is certain at every point of every box in which the facts can hold."""
    # A fact about other letters can be left out; these need not be bounded then.
    names = letters_of(claim)
    parts = facts.parts if isinstance(facts, All) else (facts,)
    kept = tuple(part for part in parts if letters_of(part) <= names)
    return refutes(All((*kept, negation(claim))), roles)


def refutes(formula: Formula, roles: Mapping[str, Role]) -> bool:
    """Whether a formula is certain to hold nowhere: every letter in it has to be bounded."""
    names = sorted(letters_of(formula))
    box = []
    for name in names:
        role = roles.get(name, REAL)
        if role.low is None or role.high is None:
            return False
        box.append((float(role.low), float(role.high)))
    values = tuple(dict.fromkeys(relation.value for relation in relations(formula)))
    try:
        program = Program.of(values)
    except BeyondError:
        return False
    pending = [box]
    for _ in range(MOST_BOXES):
        if not pending:
            return True
        current = pending.pop()
        signs = dict(
            zip(values, box_signs(program, dict(zip(names, current, strict=True))), strict=True)
        )
        if _nowhere(formula, signs):
            continue
        if not current:
            return False
        widest = max(range(len(current)), key=lambda n: current[n][1] - current[n][0])
        low, high = current[widest]
        middle = (low + high) / 2
        if not low < middle < high:
            return False
        for half in ((low, middle), (middle, high)):
            pending.append([*current[:widest], half, *current[widest + 1 :]])
    return False


def _nowhere(formula: Formula, signs: Mapping[sp.Expr, frozenset[int]]) -> bool:
    """Whether a formula fails for every sign that its expressions may have in a box."""
    match formula:
        case Relation(value, operator):
            allowed = {"=": {0}, "!=": {1, -1}, ">": {1}, ">=": {0, 1}}[operator]
            return not signs[value] & allowed
        case All(parts):
            return any(_nowhere(part, signs) for part in parts)
        case Some(parts):
            return all(_nowhere(part, signs) for part in parts)
