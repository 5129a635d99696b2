"""The guides, as pages: the package's own documentation, for students and for teachers."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Mapping, Sequence
from html import escape
from itertools import pairwise
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token

from restitution.records import dataclass

_PACKAGE = Path(__file__).parents[1]
_DOCS = _PACKAGE.parents[1] / "docs"


@dataclass(frozen=True)
class Guide:
    """One of them: what a link to it is called, the file, and where a wheel carries it."""

    name: str
    file: str
    inside: Path

    @property
    def path(self) -> Path:
        """Where it is: in an installed package, or in the documentation of a clone."""
        return self.inside if self.inside.exists() else _DOCS / self.file

    def text(self) -> str:
        """What it says, in Markdown."""
        return self.path.read_text(encoding="utf-8")

    def rendered(self) -> tuple[str, str]:
        """Its title and its HTML, with its pictures in it."""
        return rendered(self.text(), self.path.parent)


def _carried(name: str, file: str) -> Guide:
    return Guide(name, file, _PACKAGE / "web" / "guides" / file)


GUIDES: Mapping[str, Guide] = {
    "students": _carried("For students", "page.md"),
    "practice": _carried("Practice", "practice.md"),
    "teachers": _carried("For teachers", "teachers.md"),
    "marking": _carried("Marking", "marking.md"),
    "language": Guide("The language", "language.md", _PACKAGE / "language" / "reference.md"),
    "lab": _carried("The Lab", "lab.md"),
    "experiment": _carried("Experiments", "experiment.md"),
    "glossary": _carried("Glossary", "glossary.md"),
}
"""By their addresses, which are relative to each other."""

_ADDRESSES = {guide.file: address for address, guide in GUIDES.items()}


def rendered(text: str, folder: Path | None = None) -> tuple[str, str]:
    """The title and the HTML of a text in Markdown.

    Headings have the anchors that links in the documentation use, links to what is not served are
    plain words, and behind each statement stands a link that opens it in the editor, from a page
    one folder below it. Pictures in SVG of the ``folder`` stand in the page; others are their
    descriptions.
    """
    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    tokens = reader.parse(text)
    title = ""
    for token, content in pairwise(tokens):
        if token.type == "heading_open":
            token.attrSet("id", _anchor(content.content))
            title = title or content.content
    for token in tokens:
        if token.children:
            _linked(token.children)
            _pictured(token.children, folder)
    reader.add_render_rule("fence", _fence)
    return title, str(reader.renderer.render(tokens, reader.options, {}))


def _fence(renderer: RendererHTML, tokens: Sequence[Token], index: int, *more: Any) -> str:
    token = tokens[index]
    shown = f"<pre><code>{escape(token.content)}</code></pre>\n"
    if token.info.strip() != "impact":
        return shown
    address = escape(f"../#{urlencode({'statement': token.content})}")
    return f'{shown}<p class="opens"><a href="{address}">Solve this</a></p>\n'


def _anchor(heading: str) -> str:
    """The anchor of a heading, as it is known where the documentation is read in a repository."""
    return re.sub(r"[^\w -]", "", heading.lower()).strip().replace(" ", "-")


def _pictured(tokens: Sequence[Token], folder: Path | None) -> None:
    """Puts the files of pictures into the page: they are few and small."""
    for token in tokens:
        if token.type != "image":
            continue
        picture = folder / str(token.attrGet("src")) if folder else Path()
        if picture.suffix == ".svg" and picture.is_file():
            content = b64encode(picture.read_bytes()).decode()
            token.attrSet("src", f"data:image/svg+xml;base64,{content}")
        else:
            token.type, token.tag = "text", ""


def _linked(tokens: Sequence[Token]) -> None:
    plain: list[bool] = []
    for token in tokens:
        if token.type == "link_open":
            file, sign, anchor = str(token.attrGet("href")).partition("#")
            known = _ADDRESSES.get(file)
            plain.append(bool(file) and known is None and "://" not in file)
            if known is not None:
                token.attrSet("href", f"{known}{sign}{anchor}")
            if plain[-1]:
                token.tag, token.attrs = "span", {}
        elif token.type == "link_close" and plain.pop():
            token.tag = "span"
