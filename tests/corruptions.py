"""Workings spoiled by machine, each in one place: a follower has to refuse them.

Of a line left out, what remains may itself be one move; all else says something false, or rests on
what is not there, or on too much.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.lines.derivation import (
    Derivation,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    walk,
)

_TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "=": "<"}
_EXCHANGED = {"sin": "cos", "cos": "sin", "tan": "sin"}


def corruptions(derivation: Derivation) -> Iterator[tuple[str, Derivation]]:
    """Every spoiled version of a working, with the kind of what was done."""
    for n, line in enumerate(derivation.lines):
        yield "line left out, premises inherited", _left_out(derivation, n, inherit=True)
        yield "line left out, premises kept", _left_out(derivation, n, inherit=False)
        yield "line doubled", _doubled(derivation, n)
        for m, ref in enumerate(line.premises):
            rest = (*line.premises[:m], *line.premises[m + 1 :])
            kind = "premise dropped" if isinstance(ref, int) else "fact dropped"
            yield kind, _with(derivation, n, replace(line, premises=rest))
        if not isinstance(line.relation, Meaning):
            yield from _about_premises(derivation, n, line)
            for kind, relation in _spoiled(line.relation):
                yield kind, _with(derivation, n, replace(line, relation=relation))
    for end in derivation.items:
        yield "answer first", _answer_first(derivation, end)
        yield (
            "answer missing",
            replace(derivation, lines=tuple(x for x in derivation.lines if x.number != end.line)),
        )
    for fact in derivation.facts:
        if any(fact.id in line.premises for line in derivation.lines):
            facts = tuple(each for each in derivation.facts if each is not fact)
            yield "fact not of the statement", replace(derivation, facts=facts)


def _about_premises(derivation: Derivation, n: int, line: Line) -> Iterator[tuple[str, Derivation]]:
    above = [
        each.number
        for each in derivation.lines[:n]
        if each.number not in line.premises and not isinstance(each.relation, Meaning)
    ]
    below = [each.number for each in derivation.lines[n + 1 :]]
    if above:
        more = (*line.premises, above[-1])
        yield "premise too many", _with(derivation, n, replace(line, premises=more))
    others = [each.id for each in derivation.facts if each.id not in line.premises]
    for fact in dict.fromkeys((*others[:1], *others[-1:])):
        more = (*line.premises, fact)
        yield "fact too many", _with(derivation, n, replace(line, premises=more))
    if below:
        own = [ref for ref in line.premises if isinstance(ref, int)]
        for ref in own[:1]:
            later = tuple(below[0] if each == ref else each for each in line.premises)
            yield "later line cited", _with(derivation, n, replace(line, premises=later))


def _with(derivation: Derivation, n: int, line: Line) -> Derivation:
    return replace(derivation, lines=(*derivation.lines[:n], line, *derivation.lines[n + 1 :]))


def _left_out(derivation: Derivation, n: int, inherit: bool) -> Derivation:
    """Without a line; those that cite it cite what it cited, or go on citing it."""
    gone = derivation.lines[n]
    lines = []
    for each in derivation.lines:
        if each is gone:
            continue
        if inherit and gone.number in each.premises:
            put = [
                ref
                for own in each.premises
                for ref in (gone.premises if own == gone.number else (own,))
            ]
            each = replace(each, premises=tuple(dict.fromkeys(put)))
        lines.append(each)
    return replace(derivation, lines=tuple(lines))


def _doubled(derivation: Derivation, n: int) -> Derivation:
    line = derivation.lines[n]
    number = max(each.number for each in derivation.lines) + 1
    again = replace(line, number=number)
    return replace(
        derivation, lines=(*derivation.lines[: n + 1], again, *derivation.lines[n + 1 :])
    )


def _answer_first(derivation: Derivation, end: ItemEnd) -> Derivation:
    line = next(each for each in derivation.lines if each.number == end.line)
    rest = tuple(each for each in derivation.lines if each is not line)
    return replace(derivation, lines=(line, *rest))


def _spoiled(relation: Relation) -> Iterator[tuple[str, Relation]]:
    """A relation with one thing wrong in it."""
    for o, links in enumerate(relation.options):
        for k, link in enumerate(links):
            for kind, new in _spoiled_link(link):
                own = (*links[:k], new, *links[k + 1 :])
                yield kind, Relation((*relation.options[:o], own, *relation.options[o + 1 :]))
    if len(relation.options) > 1:
        yield "root dropped", Relation(relation.options[1:])
        yield "root dropped", Relation(relation.options[:-1])


def _spoiled_link(link: Link) -> Iterator[tuple[str, Link]]:
    if link.sign in _TURNED:
        yield "relation turned", replace(link, sign=_TURNED[link.sign])  # type: ignore[arg-type]
    for side in ("left", "right"):
        tree = getattr(link, side)
        for kind, new in _spoiled_tree(tree):
            other = link.right if side == "left" else link.left
            if (new == Negate(tree) or tree == Negate(new)) and _is_zero(other):
                continue  # −x = 0 is the same equation
            yield kind, replace(link, **{side: new})


def _spoiled_tree(tree: Expression) -> Iterator[tuple[str, Expression]]:
    """A tree with a sign, a digit or a sine wrong: the first of each kind, and the last."""
    nodes = list(walk(tree))
    if not _is_zero(tree):
        yield "sign", tree.operand if isinstance(tree, Negate) else Negate(tree)
    for kind, own, new in (
        ("sign", _is_sum, _other_sign),
        ("digit", lambda x: isinstance(x, Number | Degrees) and bool(x.value), _other_digit),
        ("sine for cosine", lambda x: isinstance(x, Apply) and x.function in _EXCHANGED, _other),
    ):
        fitting = [each for each in nodes if own(each)]
        for each in (*fitting[:1], *fitting[1:][-1:]):
            yield kind, _exchanged(tree, each, new(each))


def _is_zero(tree: Expression) -> bool:
    return isinstance(tree, Number) and not tree.value


def _is_sum(tree: Expression) -> bool:
    return isinstance(tree, Binary) and tree.op in "+-"


def _other_sign(tree: Expression) -> Expression:
    assert isinstance(tree, Binary)
    return Binary("-" if tree.op == "+" else "+", tree.left, tree.right)


def _other_digit(tree: Expression) -> Expression:
    assert isinstance(tree, Number | Degrees)
    return type(tree)(tree.value + Fraction(1))


def _other(tree: Expression) -> Expression:
    assert isinstance(tree, Apply)
    return Apply(_EXCHANGED[tree.function], tree.argument)


def _exchanged(tree: Expression, old: Expression, new: Expression) -> Expression:
    """A tree with one node exchanged, and not others that are equal to it."""
    return rebuilt(tree, lambda each: new if each is old else each)


__all__ = ["Letter", "corruptions"]
