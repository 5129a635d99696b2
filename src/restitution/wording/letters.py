"""The letters of a statement: which are acute angles, which name something else."""

from __future__ import annotations

from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Negate,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
    letters,
    walk,
)
from restitution.problem import Compare, Given, Impact, Let, Problem, trees


def named_letters(problem: Problem) -> frozenset[str]:
    """Letters that are names of quantities: those of ``let``."""
    return frozenset(step.letter for _, step in problem.steps() if isinstance(step, Let))


def acute_letters(problem: Problem) -> frozenset[str]:
    """Letters in the directions of what is given, which are acute angles by themselves.

    A fact may let one be wider: ``given 0 < theta < 180°``.
    """
    nodes = [
        node.angle for tree in trees(problem) for node in walk(tree) if isinstance(node, Polar)
    ]
    for sphere in problem.spheres:
        if isinstance(sphere.velocity, Expression):
            nodes += [node for node in walk(sphere.velocity) if is_ratio(node)]
    runs = [wall.along for wall in problem.walls]
    runs += [step.along for _, step in problem.steps() if isinstance(step, Impact)]
    nodes += [run for run in runs if isinstance(run, Expression) and not _has_axes(run)]
    names = frozenset().union(*(letters(node) for node in nodes)) - named_letters(problem)
    return frozenset(name for name in names if not _wide(problem, name))


def is_ratio(tree: Expression) -> bool:
    """Whether a tree is the sine, cosine or tangent of an angle, or the like."""
    return isinstance(tree, Apply) and tree.function not in ("sqrt", "abs")


def _has_axes(tree: Expression) -> bool:
    return any(isinstance(node, Unit | Pair | Polar | Quantity) for node in walk(tree))


def _wide(problem: Problem, name: str) -> bool:
    """Whether a fact lets an angle be other than acute."""
    facts = [
        relation
        for part, step in problem.steps()
        if part.label is None and isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare) and Letter(name) in relation.operands
    ]
    return any(_not_acute(operand) for fact in facts for operand in fact.operands)


def _not_acute(tree: Expression) -> bool:
    match tree:
        case Degrees(value):
            return value > 90
        case Negate() | Pi():
            return True
    return False
