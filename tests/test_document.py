"""Documents: what they hold stands in HTML and in print, and nothing of it is read as markup."""

from __future__ import annotations

import io
import re
import unicodedata
from html.parser import HTMLParser

import pypdf
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution.render.document import (
    Chain,
    Document,
    Emphasis,
    Entries,
    Equations,
    Heading,
    Item,
    Labelled,
    Listing,
    NewPage,
    Paragraph,
    Picture,
    Table,
    latex,
    markdown,
    text,
)
from restitution.render.document.html import to_html
from restitution.render.document.typst import to_markup, to_pdf
from restitution.render.layout import Function, Letter

SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" id="rabc" width="10mm" height="5mm" '
    'viewBox="0 0 10 5"><path d="M0 0L10 5" stroke="#1a1a1a"/></svg>\n'
)
TAN = Function("tan", Letter("alpha"))
ALL = Document(
    "A <title> of #all",
    (
        Heading("First"),
        Paragraph(("where ", TAN, " grows"), "result"),
        Paragraph("a remark", "remark"),
        Table(("n", TAN), (("1", "0.577"), ("2", "")), "lr", height=8, ruled=True),
        Picture(SVG, 60, "beneath"),
        Listing((Item("one", 20), Item("two")), numbered=True, first=3),
        Listing((Item("dot"),)),
        NewPage(),
        Heading("Second"),
    ),
    "Name",
)


def printed(document: Document) -> list[str]:
    read = pypdf.PdfReader(io.BytesIO(to_pdf(document)))
    return [
        " ".join(unicodedata.normalize("NFKC", page.extract_text()).split()) for page in read.pages
    ]


@pytest.mark.parametrize("above", range(28, 34))
def test_a_table_of_marks_is_begun_where_it_has_room_for_some_rows(above):
    """However much stands above it, and with its heading."""
    rows = tuple((f"M{n}", f"row {n}", "note") for n in range(1, 9))
    table = Table(("Marks", "For", "Notes"), rows, "lll", ruled=True, remarks=(2,))
    lines = tuple(Paragraph(f"line {n}") for n in range(above))
    pages = printed(Document("", (*lines, Heading("Scheme"), table)))
    (begun,) = (page for page in pages if "Scheme" in page)
    assert "row 3" in begun


def test_all_blocks_are_printed_in_order():
    first, second = printed(ALL)
    places = [
        first.index(each)
        for each in ("Name", "A <title> of #all", "First", "where tan", "a remark", "0.577")
    ]
    assert places[0] < places[2] < places[3] < places[4] < places[5]
    assert re.search(r"3\. one\s+4\. two", first) and "• dot" in first
    assert "Second" in second and "Second" not in first


def test_all_blocks_stand_on_the_page():
    page = to_html(ALL)
    for wanted in (
        "<title>A &lt;title&gt; of #all</title>",
        "<h2>First</h2>",
        '<p class="result">where <math',
        '<ol start="3"><li>one<div style="height:20mm"></div></li><li>two</li></ol>',
        '<tr style="height:8mm"><td class="l">1</td><td class="r">0.577</td></tr>',
        'width:60mm" xmlns',
        "<figcaption>beneath</figcaption>",
        '<div class="break"></div>',
    ):
        assert wanted in page


def test_all_blocks_are_written_as_text_markdown_and_latex():
    page, marks, tex = text.to_text(ALL, 40), markdown.to_markdown(ALL), latex.to_latex(ALL)
    for written in (page, marks, tex):
        words = ["First", "where", "grows", "a remark", "0.577", "one", "two", "dot", "Second"]
        places = [written.index(word) for word in words]
        assert places == sorted(places)
    assert "n  tan α\n1  0.577\n2" in page
    assert "3. one\n4. two\n\n- dot" in page and "3. one\n4. two\n\n- dot" in marks
    assert "| n | $\\tan\\alpha$ |\n| :-- | --: |\n| 1 | 0.577 |" in marks
    assert "![](data:image/svg+xml;base64," in marks
    assert r"n & $\tan\alpha$ \\" in tex and r"\item one" in tex and r"\newpage" in tex


QUESTION = Document(
    "Two parts",
    (
        Paragraph(("A ball ", Emphasis("P"), " moves.")),
        Labelled(
            "(a)", (Entries((("(i)", ("one,",)), ("(ii)", ("two.",))), ("Find",)),), "(2 marks)"
        ),
    ),
    kind="question",
)
WORKING = Document(
    "",
    (
        Heading("(a)"),
        Paragraph((Emphasis("A law"), ": in words"), mark="B1"),
        Equations((Chain((Letter("v"), TAN), ("=",), "A1", (", as v > 0",), label="(i)"),)),
        Paragraph("Nothing more.", "note"),
    ),
    kind="working",
)


def test_a_question_stands_behind_its_labels():
    assert text.to_text(QUESTION, 30).splitlines() == [
        "Two parts",
        "",
        "A ball P moves.",
        "",
        "(a)  Find",
        "     (i)  one,",
        "     (ii) two.",
        "                     (2 marks)",
    ]
    assert "A ball *P* moves.\n\n**(a)** Find\n\n(i) one," in markdown.to_markdown(QUESTION)
    assert '<div class="row"><span>(i)</span><div><p>one,</p></div></div>' in to_html(QUESTION)
    assert r"\textbf{(a)} Find" in latex.to_latex(QUESTION, whole=False)
    assert "(a) Find" in " ".join(printed(QUESTION))


def test_a_working_has_its_marks_at_the_right():
    assert text.to_text(WORKING, 40).splitlines() == [
        "(a)",
        "",
        "A law: in words                       B1",
        "(i) v = tan α, as v > 0               A1",
        "Nothing more.",
    ]
    assert r"v &= \tan\alpha\text{, as v > 0} &&\quad\text{A1}" in markdown.to_markdown(WORKING)
    assert r"\tag*{\textbf{A1}}" in latex.to_latex(WORKING)
    assert '<p><span class="mark">B1</span><i>A law</i>: in words</p>' in to_html(WORKING)
    assert "A1" in " ".join(printed(WORKING))


def test_a_row_without_a_cell_is_refused():
    with pytest.raises(ValueError):
        to_html(Document("", (Table(("a", "b"), (("1",),), "ll"),)))


class _Tags(HTMLParser):
    """The names of all elements of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.names: set[str] = set()

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.names.add(tag)


def of_words(words: str) -> Document:
    return Document("t", (Paragraph(words), Table((words,), ((words,),), "l")))


@given(st.text(min_size=1, max_size=40))
@settings(max_examples=80)
def test_words_are_never_markup(words):
    tags, usual = _Tags(), _Tags()
    tags.feed(to_html(of_words(words)))
    usual.feed(to_html(of_words("usual")))
    assert tags.names == usual.names
    literals = re.compile(r'"(?:\\.|[^"\\])*"')
    bare, other = (literals.sub('""', to_markup(of_words(each))) for each in (words, "usual"))
    assert bare == other
    assert to_pdf(of_words(words))


@pytest.mark.parametrize("words", ["#set page()", "*bold*", "$x$", "\\", '"', "[", "]"])
def test_signs_of_typst_are_printed_as_they_are(words):
    (page,) = printed(Document("t", (Paragraph(f"before {words} after"),)))
    assert f"before {words} after" in page.replace("”", '"').replace("“", '"')
