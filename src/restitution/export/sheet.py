"""Questions on sheets of A4: wording, a figure, room for working, and worked solutions.

A sheet is made in two steps. `entry` turns a solved problem into markup, in the process that has
solved it; `to_pdf` and `to_html` put entries together, and need no algebra for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from html import escape
from typing import TYPE_CHECKING, Literal

from restitution.records import dataclass
from restitution.render.page import page
from restitution.render.typst import NAME, compiled, literal, paper

if TYPE_CHECKING:
    from restitution.explaining.lines.marks import Style
    from restitution.solving.equations.solution import Solution
    from restitution.wording import Question, QuestionPart

Form = Literal["pdf", "html"]

DEFAULT_TITLE = "Oblique impacts"
_MOST = 20.0  # centimetres of room that are given unasked: nearly a page
FIGURE = 84
"""Width of a figure, in millimetres."""


@dataclass(frozen=True)
class Options:
    """What a sheet holds beside its questions.

    ``space`` is the room for working after each part, in centimetres; None gives a centimetre for
    each mark, and nothing where the solutions or the mark scheme stand behind. ``marks`` is the
    style of marks; in the style ``"none"`` there are none to be seen, and as much room as in
    ``"fm1"``. ``scheme`` sets the mark scheme behind.
    """

    solutions: bool = False
    diagrams: bool = True
    space: float | None = None
    marks: Style = "fm1"
    scheme: bool = False


@dataclass(frozen=True)
class Entry:
    """One question of a sheet as markup of its form; ``working`` is empty where not wanted.

    So is ``scheme``, its mark scheme, and ``close``, the question without room for working, which
    stands before it unless room is asked for.

    ``room`` is that for the working of its last part, in centimetres.
    """

    title: str | None
    question: str
    working: str = ""
    room: float = 0.0
    scheme: str = ""
    close: str = ""

    def asked(self, options: Options) -> tuple[str, float]:
        """The question, and the room behind it, as they stand on a sheet."""
        if options.scheme and options.space is None:
            return self.close, 0.0
        return self.question, self.room


def entry(solution: Solution, form: Form, options: Options) -> Entry:
    """A solved problem as it stands on a sheet.

    Raises RestitutionError where the problem cannot be worded or explained.
    """
    from restitution.wording import question
    from restitution.workings import explain, illustrated
    from restitution.workings.rendering.document import to_body, to_typst

    explanation = explain(solution, marks="fm1" if options.marks == "none" else options.marks)
    marks = {part.label: part.marks for part in explanation.parts if part.marks}
    asked = replace(question(solution.problem, marks=marks), title=None)
    rooms = [_room(part, options) for part in asked.parts]
    if options.marks == "none":
        explanation = explanation.without_marks()
        asked = replace(asked, parts=tuple(replace(part, marks=None) for part in asked.parts))
    explained = replace(explanation, title=None)
    if options.diagrams and options.solutions:
        explained = illustrated(explained)
    figure = _figure(solution) if options.diagrams else None
    room = rooms[-1] if rooms else 0.0
    if form == "pdf":
        working = to_typst(explained) if options.solutions else ""
        written = _typst_question
    else:
        working = to_body(explained) if options.solutions else ""
        written = _html_question
    close = written(asked, figure, [0.0] * len(rooms)) if options.scheme else ""
    text, scheme = written(asked, figure, rooms), _scheme(solution, form, options)
    return Entry(solution.problem.title, text, working, room, scheme, close)


def _scheme(solution: Solution, form: Form, options: Options) -> str:
    """The mark scheme as a table, where it is wanted."""
    if not options.scheme:
        return ""
    from restitution.export import mark_scheme as tables
    from restitution.practice.marking.mark_scheme import mark_scheme

    rows = mark_scheme(solution, "fm1" if options.marks == "none" else options.marks)
    return tables.to_typst(rows) if form == "pdf" else tables.to_html(rows)


def _figure(solution: Solution) -> str | None:
    """The situation before the first impact, as SVG."""
    from restitution.drawing import figure
    from restitution.drawing.svg import to_svg

    scene = figure(solution)
    return None if scene is None else to_svg(scene)


def _room(part: QuestionPart, options: Options) -> float:
    """Centimetres of room for the working of a part."""
    if options.space is not None:
        return options.space
    return 0.0 if options.solutions else min(float(part.marks or 0), _MOST)


_LONG = 4000  # characters of markup that a page may not hold


# --- typst --------------------------------------------------------------------------------------

_SETUP = """\
#let numbered(number, title, body) = block(above: 1.6em, breakable: true, grid(
  columns: (1.8em, 1fr), strong[#number], [#if title != none { block(sticky: true, strong(title)) }
  #body]))
#let figure-of(svg) = align(center, block(above: 1em, below: 1em,
  image(bytes(svg), format: "svg", width: WIDTH)))
#let together(body) = block(breakable: false, width: 100%, body)
#let room(height) = block(height: height, width: 100%, breakable: true)
"""


def to_pdf(entries: Sequence[Entry], title: str | None, options: Options) -> bytes:
    """The sheet as a PDF of A4 pages, the same bytes for the same entries.

    Raises UnsupportedError where typst is not installed.
    """
    return compiled(_typst_document(entries, title or _title(entries), options), "pdf", "HTML")


def _typst_document(entries: Sequence[Entry], title: str, options: Options) -> str:
    from restitution.render.document.typst import PREAMBLE

    head = "" if options.solutions or options.scheme else NAME
    setup = paper(title, head) + _SETUP.replace("WIDTH", f"{FIGURE}mm")
    blocks = [setup, PREAMBLE]
    alone = len(entries) == 1
    for number, each in enumerate(entries, 1):
        question, room = each.asked(options)
        blocks.append(_typst_numbered(number, each.title, question, alone, title))
        # What is left of the last page is room enough, whatever it is.
        blocks.append(f"#room({room:g}cm)" if number < len(entries) else "")
    if options.solutions:
        blocks.append("#pagebreak(weak: true)\n#heading(numbering: none)[Solutions]")
        for number, each in enumerate(entries, 1):
            blocks.append(_typst_numbered(number, each.title, each.working, alone, title))
    if options.scheme:
        blocks.append("#pagebreak(weak: true)\n#heading(numbering: none)[Mark scheme]")
        for number, each in enumerate(entries, 1):
            blocks.append(_typst_numbered(number, each.title, each.scheme, alone, title))
    return "\n\n".join(blocks) + "\n"


def _typst_numbered(number: int, title: str | None, body: str, alone: bool, sheet: str) -> str:
    named = "none" if title is None or (alone and title == sheet) else literal(title)
    return f"#numbered({literal(f'{number}')}, {named})[\n{body}\n]"


def _typst_question(question: Question, figure: str | None, rooms: Sequence[float]) -> str:
    from restitution.render.document.typst import to_blocks
    from restitution.wording import document

    opening = to_blocks(document.opening(question))
    parts = [to_blocks([document.part(part)]) for part in question.parts]
    first = parts[0] if parts else ""
    short = len(opening) + len(first) < _LONG
    if figure is not None:
        opening += f"\n\n#figure-of({literal(figure)})"
    start = f"{opening}\n\n{first}"
    blocks = [_together(start) if short else start]
    for room, part in zip(rooms, parts[1:], strict=False):
        blocks.append(f"#room({room:g}cm)")
        blocks.append(_together(part) if len(part) < _LONG else part)
    return "\n\n".join(blocks)


def _together(body: str) -> str:
    return f"#together[\n{body}\n]"


# --- HTML ---------------------------------------------------------------------------------------

_STYLE = """
body { margin: 0; background: #fff } main { max-width: 46rem; margin: 0 auto; padding: 1rem }
main > h1 { font: 600 1.3rem/1.3 Georgia, serif; margin: .5rem 0 1rem }
main > h2 { font: 600 1.15rem/1.3 Georgia, serif; break-before: page }
.entry { display: grid; grid-template-columns: 2rem 1fr; margin: 1.4rem 0 }
.entry > .number { font: 600 1.05rem/1.6 Georgia, serif }
.entry h3 { font: 600 1.05rem/1.6 Georgia, serif; margin: 0 }
.entry .question, .entry .restitution { padding: 0; margin: 0; max-width: none }
.figure { text-align: center; margin: 1rem 0; break-inside: avoid } .figure svg { width: 84mm;
  max-width: 100%; height: auto }
@media (prefers-color-scheme: dark) { body { background: #17181c; color: #e8e8ec } }
@media print { @page { size: A4; margin: 20mm } main { padding: 0; max-width: none }
  body { background: #fff; color: #000 } }
"""


def to_html(entries: Sequence[Entry], title: str | None, options: Options) -> str:
    """The sheet as one page that needs nothing else and prints on A4."""
    from restitution.export.mark_scheme import STYLE as SCHEME
    from restitution.render.document.styles import QUESTION, WORKING

    named = title or _title(entries)
    alone = len(entries) == 1
    body = [f"<h1>{escape(named)}</h1>"]
    for number, each in enumerate(entries, 1):
        question, room = each.asked(options)
        body.append(_html_numbered(number, each.title, question, alone, named))
        body.append(_html_room(room))
    if options.solutions:
        body.append("<h2>Solutions</h2>")
        body += [
            _html_numbered(n, e.title, e.working, alone, named) for n, e in enumerate(entries, 1)
        ]
    if options.scheme:
        body.append("<h2>Mark scheme</h2>")
        body += [
            _html_numbered(n, e.title, e.scheme, alone, named) for n, e in enumerate(entries, 1)
        ]
    inside = "\n".join(body)
    scheme = SCHEME if options.scheme else ""
    return page(named, f"{QUESTION}{WORKING}{_STYLE}{scheme}", f"<main>\n{inside}\n</main>")


def _html_numbered(number: int, title: str | None, body: str, alone: bool, sheet: str) -> str:
    named = "" if title is None or (alone and title == sheet) else f"<h3>{escape(title)}</h3>"
    return (
        f'<section class="entry"><div class="number">{number}</div><div>{named}\n{body}\n'
        "</div></section>"
    )


def _html_question(question: Question, figure: str | None, rooms: Sequence[float]) -> str:
    from restitution.render.document.html import to_blocks
    from restitution.wording import document

    blocks = [to_blocks(document.opening(question))]
    if figure is not None:
        blocks.append(f'<div class="figure">{figure}</div>')
    for index, part in enumerate(question.parts):
        if index:
            blocks.append(_html_room(rooms[index - 1]))
        blocks.append(to_blocks([document.part(part)]))
    return '<article class="question">' + "\n".join(blocks) + "</article>"


def _html_room(height: float) -> str:
    return f'<div style="height: {height:g}cm"></div>' if height else ""


def _title(entries: Sequence[Entry]) -> str:
    return (entries[0].title if len(entries) == 1 else None) or DEFAULT_TITLE
