"""Sheets as a teacher gets them: the PDF read back as text, and the page of HTML."""

from __future__ import annotations

import io
import re
import subprocess
import sys
import unicodedata
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator

import pypdf
import pytest

import restitution as r
from restitution import examples
from restitution.errors import UnsupportedError
from restitution.export.sheet import Entry, Options, entry, to_document
from restitution.render.document import (
    Block,
    Inset,
    Picture,
    Room,
    Together,
    html,
    latex,
    markdown,
    typst,
)
from restitution.render.document.text import to_text as as_text
from restitution.wording import question, to_text

PLAIN, ANSWERS = Options(), Options(solutions=True)
NAMES = list(examples.names())
SOME = ("corner", "two-spheres-with-vectors", "right-angles-afterwards", "second-wall")


def made(name: str, options: Options = PLAIN) -> Entry:
    return entry(r.solve(r.parse(examples.text(name))), options)


def to_pdf(entries: list[Entry], title: str | None, options: Options) -> bytes:
    return typst.to_pdf(to_document(entries, title, options))


def to_html(entries: list[Entry], title: str | None, options: Options) -> str:
    return html.to_html(to_document(entries, title, options))


def within(blocks: Iterable[Block]) -> Iterator[Block]:
    """All blocks, and those that stand in others."""
    for block in blocks:
        yield block
        if isinstance(block, Inset):
            yield from within(block.document.blocks)
        elif isinstance(block, Together):
            yield from within(block.blocks)


def pages(pdf: bytes) -> list[str]:
    """The text of every page, letters of mathematical alphabets as plain ones."""
    read = pypdf.PdfReader(io.BytesIO(pdf))
    assert all(tuple(map(round, page.mediabox[2:])) == (595, 842) for page in read.pages)  # A4
    return [unicodedata.normalize("NFKC", page.extract_text()) for page in read.pages]


def words(text: str) -> list[str]:
    """Words long enough to be no mathematics; a line may end within one at a hyphen."""
    return re.findall(r"[A-Za-z]{4,}", unicodedata.normalize("NFKC", text))


def in_order(wanted: list[str], found: list[str]) -> bool:
    rest = iter(found)
    return all(word in rest for word in wanted)


@pytest.mark.parametrize("name", SOME)
def test_the_wording_and_the_marks_stand_on_the_sheet(name: str) -> None:
    solution = r.solve(r.parse(examples.text(name)))
    told = r.explain(solution)
    text = "\n".join(pages(to_pdf([made(name)], None, PLAIN)))
    assert in_order(words(to_text(question(solution.problem))), words(text))
    marks = [int(each) for each in re.findall(r"\((\d+) marks?\)", text)]
    assert marks == [part.marks for part in told.parts]
    assert not re.search(r"\b(DM1|M1|A1|B1)\b", text)


def test_solutions_have_their_marks_in_the_margin() -> None:
    text = "\n".join(pages(to_pdf([made("corner", ANSWERS)], None, ANSWERS)))
    question_text, solution = text.split("Solutions")
    assert "M1" not in question_text
    assert len(re.findall(r"\b(?:DM1|M1|A1|B1)", solution)) == 11
    assert "Newton's experimental law" in solution.replace("’", "'")


def test_pages_are_numbered_beneath_a_header() -> None:
    read = pages(to_pdf([made(name) for name in SOME], "Homework 7", PLAIN))
    assert len(read) > 2
    for number, text in enumerate(read, 1):
        assert text.startswith("Homework 7 Name")
        assert text.rstrip().endswith(f"{number} of {len(read)}")


def test_without_marks_there_is_the_same_room() -> None:
    name = "right-angles-afterwards"
    bare = Options(marks="none")
    usual, without = made(name), made(name, bare)
    assert "mark" in typst.to_blocks(usual.question)
    assert "mark" not in typst.to_blocks(without.question)
    assert without.room == usual.room and usual.room.height > 0
    rooms = [[b for b in e.question if isinstance(b, Room)] for e in (usual, without)]
    assert rooms[0] == rooms[1] and len(rooms[0]) == 1
    solved = made(name, Options(True, diagrams=False, marks="none"))
    assert not re.search(r"\b(?:DM1|M1|A1|B1)", typst.to_blocks(solved.working))


def test_room_for_working() -> None:
    name = "right-angles-afterwards"  # it has two parts
    sizes = []
    for space in (0, 5, 30):
        options = Options(space=space)
        sizes.append(len(pages(to_pdf([made(name, options)] * 2, None, options))))
    assert sizes == sorted(sizes)
    assert sizes[0] == 1 and sizes[-1] >= 4
    marked = len(pages(to_pdf([made(name)] * 2, None, PLAIN)))
    assert marked > 1, "a centimetre for each mark"


@pytest.mark.nightly  # that a scene is the same in every process, the normal run asks too
def test_the_same_bytes_for_the_same_questions() -> None:
    code = (
        "import hashlib, sys, restitution as r\n"
        "from restitution import examples\n"
        "from restitution.export.sheet import Options, entry, to_document\n"
        "from restitution.render.document.html import to_html\n"
        "from restitution.render.document.typst import to_pdf\n"
        "o = Options(solutions=True)\n"
        "s = r.solve(r.parse(examples.text('corner')))\n"
        "sheet = to_document([entry(s, o)], None, o)\n"
        "print(hashlib.sha256(to_pdf(sheet)).hexdigest())\n"
        "print(hashlib.sha256(to_html(sheet).encode()).hexdigest())\n"
    )
    runs = {
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            check=True,
            text=True,
            env={"PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2")
    }
    assert len(runs) == 1


HOSTILE = '#panic("x") "quoted" \\ $x$ [#] <b>& */ _y_ \u2028 @ref'


def test_titles_are_never_markup() -> None:
    text = f"title {HOSTILE}\nwall W: along i\nsphere P: velocity 3i - 4j\nP hits W\nfind speed(P)"
    solution = r.solve(r.parse(text))
    pdf = to_pdf([entry(solution, ANSWERS)] * 2, HOSTILE, ANSWERS)
    assert '#panic("x")' in "".join(pages(pdf))
    page = to_html([entry(solution, ANSWERS)] * 2, HOSTILE, ANSWERS)
    assert "<b>&" not in page and "&lt;b&gt;&amp;" in page


@pytest.mark.parametrize("options", [PLAIN, ANSWERS], ids=["questions", "solutions"])
def test_a_page_of_html_needs_nothing_else(options: Options) -> None:
    page = to_html([made(name, options) for name in SOME], None, options)
    assert page.count("<html") == 1 and "<script" not in page
    assert not re.search(r"""(?:href|src)=["'](?!#)""", page)
    outside = set(re.findall(r"https?://[^\s\"'<]+", page))
    assert outside <= {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"}
    for svg in re.findall(r"<svg.*?</svg>", page, re.DOTALL):
        ET.fromstring(svg)
    assert ("Solutions" in page) == options.solutions


def test_diagrams_can_be_left_out() -> None:
    bare = Options(solutions=True, diagrams=False)
    assert "<svg" not in to_html([made("corner", bare)], None, bare)
    assert any(isinstance(block, Picture) for block in within(made("corner", ANSWERS).working))
    # the figure of a question does not give its answers away
    for name in ("corner", "two-spheres-with-vectors"):
        (figure,) = (b for b in within(made(name).question) if isinstance(b, Picture))
        assert "After" not in figure.svg


@pytest.mark.parametrize("names", [NAMES[::18], pytest.param(NAMES, marks=pytest.mark.nightly)])
def test_many_examples_on_one_sheet(names: list[str]) -> None:
    entries = [made(name, ANSWERS) for name in names]
    text = "\n".join(pages(to_pdf(entries, "All", ANSWERS)))
    titles = [t for name in names if (t := r.parse(examples.text(name)).title)]
    found = " ".join(text.split())
    missing = [t for t in titles if " ".join(unicodedata.normalize("NFKC", t).split()) not in found]
    assert missing == []


def test_without_typst_there_is_a_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(UnsupportedError, match=r"pip install 'restitution\[pdf\]'"):
        to_pdf([made("corner")], None, PLAIN)
    assert "<svg" in to_html([made("corner")], None, PLAIN)


def test_a_picture_that_stands_twice_on_a_page_has_ids_of_its_own() -> None:
    page = to_html([made("corner", ANSWERS)] * 2, None, ANSWERS)
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    assert set(re.findall(r'href="#([^"]+)"', page)) <= set(ids)
    assert set(re.findall(r'aria-labelledby="(\S+) ', page)) <= set(ids)


def test_a_sheet_is_a_document_in_every_format() -> None:
    options = Options(solutions=True, scheme=True, diagrams=False)
    sheet = to_document([made(name, options) for name in SOME], "Homework", options)
    for written in (as_text(sheet), markdown.to_markdown(sheet), latex.to_latex(sheet)):
        assert written.index("Homework") < written.index("Solutions") < written.index("Mark scheme")
        assert in_order(["Newton", "experimental"], words(written.split("Mark scheme")[1]))
    assert max(map(len, as_text(sheet).splitlines())) <= 90
