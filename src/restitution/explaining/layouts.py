"""What a line says, laid out: its relation as chains, alternatives joined by *or*."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import fields, replace
from typing import Any

from restitution.explaining.derivation import Link, Relation
from restitution.explaining.trees import rebuilt
from restitution.expression.tree import Expression, Letter, Quantity
from restitution.render import layout as lay

_SIGNS = {
    "<=": "≤",
    ">=": "≥",
    "!=": "≠",
    "parallel to": "is parallel to",
    "perpendicular to": "is perpendicular to",
}


Names = Callable[[Quantity], lay.Layout | None]
"""How a working calls a quantity of the motion; None where it is written as in a statement."""


def of_tree(
    tree: Expression, vectors: AbstractSet[str] = frozenset(), names: Names | None = None
) -> lay.Layout:
    """A tree as it is written; the letters that are ``vectors`` stand in bold type."""
    called: dict[str, lay.Layout] = {}

    def change(node: Expression) -> Expression:
        name = names(node) if names is not None and isinstance(node, Quantity) else None
        if name is None:
            return node
        called[f"q_{len(called)}"] = name
        return Letter(f"q_{len(called) - 1}")

    own = lay.from_tree(rebuilt(tree, change) if names is not None else tree)
    return _put(own, vectors, called) if vectors or called else own


def _put(layout: Any, vectors: AbstractSet[str], called: Mapping[str, lay.Layout]) -> Any:
    if isinstance(layout, lay.Letter):
        name = f"{layout.name}_{layout.subscript}" if layout.subscript else layout.name
        if name in called:
            return called[name]
        return lay.Bold(layout.name, layout.subscript) if name in vectors else layout
    if isinstance(layout, tuple):
        return tuple(_put(each, vectors, called) for each in layout)
    if isinstance(layout, lay.Function):
        inside = _put(layout.argument, vectors, called)
        words = isinstance(inside, lay.Phrase | lay.Words)
        return replace(layout, argument=lay.Brackets(inside) if words else inside)
    if isinstance(layout, lay.Layout):
        put = {e.name: _put(getattr(layout, e.name), vectors, called) for e in fields(layout)}
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


def of_chain(
    links: tuple[Link, ...],
    vectors: AbstractSet[str] = frozenset(),
    names: Names | None = None,
) -> lay.Relation:
    """A chain: operands with signs between them."""
    operands = [links[0].left, *(each.right for each in links)]
    return lay.Relation(
        tuple(of_tree(each, vectors, names) for each in operands),
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
