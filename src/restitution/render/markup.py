"""Elements of HTML, MathML and SVG as trees, and their text.

A tree is a text, or a list ``[name, {attribute: value}, child, …]``: pages that make no markup of
text build it from these.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape
from typing import Any, TypeAlias

Tree: TypeAlias = "str | list[Any]"


class Raw(str):
    """The text of one element that is written already, such as a picture."""

    __slots__ = ()


# Elements of HTML that have no end tag.
_VOID = frozenset(("br", "wbr", "hr", "img"))
# Signs that nobody sees, by number: a reader of the text sees that they are there.
_UNSEEN = str.maketrans({"\u2061": "&#x2061;", "\u2062": "&#x2062;"})


def element(
    name: str, children: Iterable[Tree] = (), attributes: Mapping[str, str] | None = None
) -> Tree:
    """An element with what stands in it; texts next to each other are one."""
    node: list[Any] = [name, dict(attributes or {})]
    for child in children:
        if isinstance(child, str) and len(node) > 2 and _is_text(child) and _is_text(node[-1]):
            node[-1] += child
        elif child != "":
            node.append(child)
    return node


def _is_text(tree: Tree) -> bool:
    return isinstance(tree, str) and not isinstance(tree, Raw)


def to_markup(*trees: Tree) -> str:
    """Trees as text, one behind the other; every text in them is escaped."""
    return "".join(map(_markup, trees))


def _markup(tree: Tree) -> str:
    if isinstance(tree, Raw):
        return tree
    if isinstance(tree, str):
        return escape(tree, quote=False).translate(_UNSEEN)
    name, attributes, *children = tree
    within = "".join(f' {key}="{escape(value)}"' for key, value in attributes.items())
    start = f"<{name}{within}>"
    return start if name in _VOID else f"{start}{''.join(map(_markup, children))}</{name}>"


def together(trees: Iterable[Tree]) -> Tree:
    """Trees as one: the only one, or a ``span`` of all."""
    own = list(trees)
    return own[0] if len(own) == 1 else element("span", own)


__all__ = ["Raw", "Tree", "element", "to_markup", "together"]
