"""The bound of a coefficient that makes no end of a range: it holds in the range as well."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.derivation import Derivation, Line, Link, Relation
from restitution.explaining.saying import Sentence, say
from restitution.explaining.unused import lines_under
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Binary, Expression, Letter, Number, has_quantity, walk
from restitution.oracle import BeyondError, Oracle, compared
from restitution.problem import Range
from restitution.solving.letters import roles
from restitution.solving.solution import Solution
from restitution.workings.ends import Ends
from restitution.workings.naming import Naming

_OTHER = {"<=": (">=", Number(Fraction(0))), ">=": ("<=", Number(Fraction(1)))}
_ORDER = ("<", "<=", ">", ">=")


def other_bounds(solution: Solution, derivation: Derivation) -> dict[int, Sentence]:
    """What is said below the lines of ranges that come of one bound of a coefficient alone."""
    naming = Naming(derivation, solution.problem, None)
    ends = Ends(derivation, solution.problem, naming)
    sentences: dict[int, Sentence] = {}
    for end in derivation.items:
        line = derivation.line(end.line)
        if line is None or not isinstance(ends.item(end.item), Range):
            continue
        bounds = [each for each in _bounds(derivation, line) if _holds(solution, line, *each)]
        if bounds:
            laid = tuple(
                naming.relation(Relation(((Link(letter, *_OTHER[sign]),),)))  # type: ignore[arg-type]
                for letter, _, sign in bounds
            )
            sentences[line.number] = say("range.also", bounds=laid)
    return sentences


def _bounds(derivation: Derivation, line: Line) -> Iterator[tuple[Letter, Expression, str]]:
    """The coefficients that a range bounds on one side: with its value, and that side."""
    under = sorted(each for each in lines_under(derivation, line.number) if isinstance(each, int))
    lines = [own for each in under if (own := derivation.line(each)) is not None]
    cited = {ref for own in lines for ref in own.premises if isinstance(ref, str)}
    for own in lines:
        named = [ref for ref in own.premises if isinstance(ref, str)]
        above = [derivation.line(ref) for ref in own.premises if isinstance(ref, int)]
        if own.move.id != "sign" or len(named) != 1 or len(above) != 1 or above[0] is None:
            continue
        match above[0].relation:
            case Relation(((Link(Letter(name) as letter, "="), *_),)):
                value = above[0].relation.only[-1].right
            case _:
                continue
        for sign, (other, far) in _OTHER.items():
            near = "1" if sign == "<=" else "0"
            cites = f"{name} {other} {far.value}" in cited
            told = named[0] == f"{name} {sign} {near}" and not cites
            if told and _has_difference(value) and not has_quantity(value):
                yield letter, value, sign


def _has_difference(tree: Expression) -> bool:
    return any(isinstance(each, Binary) and each.op == "-" for each in walk(tree))


def _holds(solution: Solution, line: Line, letter: Letter, value: Expression, sign: str) -> bool:
    """Whether a value keeps the other bound wherever a range holds."""
    own = roles(solution.problem)
    role = own.get(letter.name)
    if role is None or role.kind != "restitution" or not isinstance(line.relation, Relation):
        return False
    if len(line.relation.options) != 1:
        return False
    other, far = _OTHER[sign]

    def symbol(name: str) -> sp.Expr:
        return own[name].symbol(name)

    try:
        within = [
            compared(evaluate(each.left, symbol), each.sign, evaluate(each.right, symbol))
            for each in line.relation.only
            if each.sign in _ORDER
        ]
        claim = compared(evaluate(value, symbol), other, evaluate(far, symbol))
        return Oracle(own).with_facts(within).proves(claim)
    except (RestitutionError, BeyondError, KeyError, TypeError, ValueError):
        return False
