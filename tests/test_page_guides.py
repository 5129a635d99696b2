"""The guides on the page: the documentation itself, with links that lead somewhere."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from urllib.parse import parse_qs, urldefrag, urljoin, urlparse

import httpx
import pytest
from pages import accessible, minding, too_wide
from playwright.sync_api import Page, expect

from restitution import parse
from restitution.web.guides import GUIDES, rendered


class Marks(HTMLParser):
    """The links and the anchors of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        told = dict(attrs)
        if tag == "a" and told.get("href"):
            self.links.append(told["href"] or "")
        if told.get("id"):
            self.anchors.add(told["id"] or "")


@pytest.mark.parametrize("name", GUIDES)
def test_a_guide_says_what_the_documentation_says(name: str, served: str) -> None:
    reply = httpx.get(f"{served}/guides/{name}", timeout=100)
    assert reply.headers["content-type"].startswith("text/html")
    text = GUIDES[name].text()
    title, content = GUIDES[name].rendered()
    assert text.startswith(f"# {title}\n")
    assert content in reply.text
    assert content.count("<h2") == len(re.findall(r"^## ", text, re.MULTILINE))


@pytest.mark.parametrize("name", GUIDES)
def test_no_link_of_a_guide_is_dead(name: str, served: str) -> None:
    here = f"{served}/guides/{name}"
    for link in Marks(httpx.get(here, timeout=100).text).links:
        address, anchor = urldefrag(urljoin(here, link))
        if not address.startswith(served):
            assert address.startswith("https://")
            continue
        reply = httpx.get(address, timeout=100)
        assert reply.status_code == 200, link
        if anchor.startswith("statement="):
            assert urlparse(address).path == "/"
            parse(parse_qs(anchor)["statement"][0])
        elif anchor:
            assert anchor in Marks(reply.text).anchors, link


def test_what_is_not_served_is_no_link() -> None:
    _, content = rendered("# One\n\n[a](api.md#x), [b](language.md#y), [c](#one) <b>no</b>\n")
    links = '<span>a</span>, <a href="language#y">b</a>, <a href="#one">c</a>'
    assert content == f'<h1 id="one">One</h1>\n<p>{links} &lt;b&gt;no&lt;/b&gt;</p>\n'


def test_a_picture_stands_in_the_page_or_is_told(tmp_path) -> None:
    (tmp_path / "a.svg").write_text("<svg/>", encoding="utf-8")
    (tmp_path / "b.png").write_bytes(b"")
    text = "![one](a.svg) ![two](b.png) ![three](c.svg)\n"
    picture = '<img src="data:image/svg+xml;base64,PHN2Zy8+" alt="one" />'
    assert rendered(text, tmp_path)[1] == f"<p>{picture} two three</p>\n"
    assert rendered(text)[1] == "<p>one two three</p>\n"


def test_a_statement_of_a_guide_is_solved_with_one_click(page: Page, served: str) -> None:
    with minding(page, served):
        page.goto(f"{served}/")
        page.get_by_role("link", name="for teachers").click()
        page.get_by_role("link", name="Solve this").first.click()
        expect(page.locator("#title")).to_have_text("A ball and a cushion")
        page.get_by_role("link", name="Guides").click()
        expect(page.get_by_role("heading", level=1)).to_have_text("The page")


def test_anyone_can_read_them(page: Page, served: str) -> None:
    with minding(page, served):
        for name in GUIDES:
            page.goto(f"{served}/guides/{name}")
            for width, scheme in ((320, "light"), (1280, "dark")):
                page.set_viewport_size({"width": width, "height": 800})
                page.emulate_media(color_scheme=scheme)
                assert not too_wide(page), (name, width)
            accessible(page)
