"""Markup of this package's own writing as nested lists, for pages that make no markup of text.

A tree is a text, or a list ``[name, {attribute: value}, child, …]``.
"""

from __future__ import annotations

from html.parser import HTMLParser
from typing import Any, TypeAlias

Tree: TypeAlias = "str | list[Any]"

# Elements of HTML that have no end tag.
_VOID = frozenset(("br", "wbr", "hr", "img"))


class _Grower(HTMLParser):
    """Puts each element into the one that is open."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[list[Any]] = [["", {}]]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        node: list[Any] = [tag, {name: value or "" for name, value in attrs}]
        self.open[-1].append(node)
        if tag not in _VOID:
            self.open.append(node)

    def handle_endtag(self, tag: str) -> None:
        if len(self.open) == 1 or self.open[-1][0] != tag:
            raise ValueError(f"</{tag}> ends what is not open")
        self.open.pop()

    def handle_data(self, data: str) -> None:
        if data.strip() or "\n" not in data:  # blank lines between elements say nothing
            self.open[-1].append(data)


def trees(markup: str) -> list[Tree]:
    """What stands in a fragment, one after another. Raises ValueError where it is not nested."""
    grower = _Grower()
    grower.feed(markup)
    grower.close()
    if len(grower.open) != 1:
        raise ValueError(f"<{grower.open[-1][0]}> is not ended")
    return grower.open[0][2:]


def tree(markup: str) -> Tree:
    """A fragment as one tree: its only node, or a ``span`` of all."""
    top = trees(markup)
    return top[0] if len(top) == 1 else ["span", {}, *top]
