"""Claims and facts: relations of one expression to zero, joined by *and* and *or*."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Literal

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.records import dataclass

Operator = Literal["=", "!=", ">", ">="]


@dataclass(frozen=True)
class Relation:
    """``value`` stands in this relation to zero. Angles are in radians."""

    value: sp.Expr
    operator: Operator


@dataclass(frozen=True)
class All:
    """Every part holds; of no parts, this is true."""

    parts: tuple[Formula, ...]


@dataclass(frozen=True)
class Some:
    """At least one part holds; of no parts, this is false."""

    parts: tuple[Formula, ...]


Formula = Relation | All | Some

TRUE = All(())
FALSE = Some(())


def compared(left: sp.Expr, operator: str, right: sp.Expr) -> Formula:
    """The relation between two expressions, ``left operator right``.

    Raises KeyError for an operator other than ``= != < <= > >=``.
    """
    if operator in ("<", "<="):
        left, right, operator = right, left, {"<": ">", "<=": ">="}[operator]
    operators: dict[str, Operator] = {"=": "=", "!=": "!=", ">": ">", ">=": ">="}
    return Relation(sp.sympify(left - right, strict=True), operators[operator])


def negation(formula: Formula) -> Formula:
    """The formula that holds exactly where this one does not."""
    match formula:
        case Relation(value, "="):
            return Relation(value, "!=")
        case Relation(value, "!="):
            return Relation(value, "=")
        case Relation(value, ">"):
            return Relation(-value, ">=")
        case Relation(value, _):
            return Relation(-value, ">")
        case All(parts):
            return Some(tuple(negation(part) for part in parts))
        case Some(parts):
            return All(tuple(negation(part) for part in parts))


def conjuncts(formulas: Iterable[Formula]) -> list[Formula]:
    """Formulas without an *and* around them."""
    return [
        own
        for formula in formulas
        for own in (conjuncts(formula.parts) if isinstance(formula, All) else [formula])
    ]


def joined(formulas: Iterable[Formula]) -> Formula:
    """All of the formulas, without an *and* inside an *and*."""
    parts: list[Formula] = []
    for formula in formulas:
        parts.extend(formula.parts if isinstance(formula, All) else (formula,))
    return parts[0] if len(parts) == 1 else All(tuple(parts))


def relations(formula: Formula) -> Iterator[Relation]:
    """The relations of a formula, from left to right."""
    if isinstance(formula, Relation):
        yield formula
    else:
        for part in formula.parts:
            yield from relations(part)


def put_in(formula: Formula, values: Mapping[sp.Symbol, sp.Expr]) -> Formula:
    """A formula with values put in."""
    match formula:
        case Relation(value, operator):
            put = value.xreplace(values)
            return formula if put == value else Relation(sp.factor_terms(put), operator)
        case All(parts):
            return All(tuple(put_in(part, values) for part in parts))
        case Some(parts):
            return Some(tuple(put_in(part, values) for part in parts))


def letters_of(formula: Formula) -> frozenset[str]:
    """The names of the letters in a formula."""
    return symbol_names(*(relation.value for relation in relations(formula)))
