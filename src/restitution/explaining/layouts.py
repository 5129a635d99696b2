"""What a line says, laid out: its relation as chains, alternatives joined by *or*."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import fields, replace
from typing import Any

from restitution.explaining.derivation import Link, Relation
from restitution.expression.tree import Expression
from restitution.render import layout as lay

_SIGNS = {
    "<=": "≤",
    ">=": "≥",
    "!=": "≠",
    "parallel to": "is parallel to",
    "perpendicular to": "is perpendicular to",
}


def of_tree(tree: Expression, vectors: AbstractSet[str] = frozenset()) -> lay.Layout:
    """A tree as it is written; the letters that are ``vectors`` stand in bold type."""
    own = lay.from_tree(tree)
    return _bold(own, vectors) if vectors else own


def _bold(layout: Any, vectors: AbstractSet[str]) -> Any:
    if isinstance(layout, lay.Letter):
        name = f"{layout.name}_{layout.subscript}" if layout.subscript else layout.name
        return lay.Bold(layout.name, layout.subscript) if name in vectors else layout
    if isinstance(layout, tuple):
        return tuple(_bold(each, vectors) for each in layout)
    if isinstance(layout, lay.Layout):
        put = {each.name: _bold(getattr(layout, each.name), vectors) for each in fields(layout)}
        return replace(layout, **put)
    return layout


def chains(links: tuple[Link, ...]) -> list[tuple[Link, ...]]:
    """Links that hold together, as chains: each goes on where the one before it ends."""
    found: list[list[Link]] = []
    for link in links:
        if found and found[-1][-1].right == link.left:
            found[-1].append(link)
        else:
            found.append([link])
    return [tuple(each) for each in found]


def of_chain(links: tuple[Link, ...], vectors: AbstractSet[str] = frozenset()) -> lay.Relation:
    """A chain: operands with signs between them."""
    operands = [links[0].left, *(each.right for each in links)]
    return lay.Relation(
        tuple(of_tree(each, vectors) for each in operands),
        tuple(_SIGNS.get(each.sign, each.sign) for each in links),
    )


def of_relation(relation: Relation, vectors: AbstractSet[str] = frozenset()) -> lay.Layout:
    """A whole relation in one line."""
    options = [
        _joined([of_chain(each, vectors) for each in chains(links)], ", ")
        for links in relation.options
    ]
    return _joined(options, " or ")


def _joined(layouts: list[Any], separator: str) -> lay.Layout:
    return layouts[0] if len(layouts) == 1 else lay.Phrase(tuple(layouts), separator)
