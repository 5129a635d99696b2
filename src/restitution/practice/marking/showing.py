"""Markings shown: in a terminal, as HTML, answers on a line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from textwrap import wrap

from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.practice.marking.answers import AnswerMark
from restitution.practice.marking.content import MarkingContent
from restitution.practice.marking.marks import Marks
from restitution.render.text import NO_BREAK, with_whole_formulas

SIGNS: Mapping[str, str] = {
    "true": "✓",
    "follows": "→",
    "false": "✗",
    "asks": "?",
    "unread": "…",
    "remark": " ",
    "unsupported": "!",
}
"""The sign of each verdict: a shape, so that no colour is needed."""

_STATES = {"earned": "✓", "lost": "✗", "open": "?"}
_WIDTH = 80
_NAMING = 3  # the first level of hints at which a mistake is named


def to_text(marking: MarkingContent, width: int = _WIDTH) -> str:
    """A marking for a terminal, ``width`` characters wide."""
    rows: list[str] = [] if marking.part is None else [f"({marking.part})"]
    texts: dict[int | None, list[str]] = {}
    for message in marking.messages:
        texts.setdefault(message.line, []).append(message.text)
    for number, name in _named(marking).items():
        texts[number].append(f"Mistake: {name}.")
    margin = len(str(max((line.line.number for line in marking.lines), default=1)))
    for line in marking.lines:
        number = line.line.number
        start = f"{number:>{margin}} {SIGNS[line.verdict]} "
        rows += _wrapped(line.line.text.strip(), start, width)
        for text in texts.get(number, ()):
            rows += _wrapped(text, " " * len(start) + "  ", width)
    for text in texts.get(None, ()):
        rows += ["", *_wrapped(text, "", width)]
    rows += ["" for _ in marking.asks[:1]]
    for ask in marking.asks:
        rows += _wrapped(ask.text, "", width)
    marks = marking.marks
    rows += ["", _total(marks)]
    longest = max((len(point.point.kind) for point in marks.points), default=2)
    for point in marks.points:
        where = f" (line {point.line})" if point.line is not None else ""
        why = f": {point.why}" if point.why else ""
        start = f"  {point.point.kind:<{longest}} {_STATES[point.state]} "
        rows += _wrapped(f"{point.point.purpose}{where}{why}", start, width)
    return "\n".join(rows)


def _named(marking: MarkingContent) -> dict[int, str]:
    """The mistakes that messages name, each by its id at the first line that has it."""
    telling = {message.line for message in marking.messages if message.level >= _NAMING}
    first: dict[str, int] = {}
    for line in marking.lines:
        name = None if line.mistake is None else line.mistake.id
        if name is not None and name in MISCONCEPTIONS and line.line.number in telling:
            first.setdefault(name, line.line.number)
    return {number: name for name, number in first.items()}


def _total(marks: Marks) -> str:
    if marks.open:
        return f"Marks: {marks.earned} to {marks.earned + marks.open} of {marks.of}"
    return f"Marks: {marks.earned} of {marks.of}"


def _wrapped(text: str, start: str, width: int) -> list[str]:
    whole = with_whole_formulas(text, width - len(start))
    rows = wrap(whole, width, initial_indent=start, subsequent_indent=" " * len(start))
    return [row.replace(NO_BREAK, " ") for row in rows] or [start.rstrip()]


def to_html(marking: MarkingContent) -> str:
    """A marking as a fragment of HTML."""
    texts: dict[int | None, list[str]] = {}
    for message in marking.messages:
        texts.setdefault(message.line, []).append(message.text)
    lines = "".join(
        f"<tr><td>{line.line.number}</td><td>{SIGNS[line.verdict]}</td>"
        f"<td><code>{escape(line.line.text.strip())}</code>"
        + "".join(f"<br>{escape(text)}" for text in texts.get(line.line.number, ()))
        + "</td></tr>"
        for line in marking.lines
    )
    rest = "".join(f"<p>{escape(text)}</p>" for text in texts.get(None, ()))
    asks = "".join(f"<p>{escape(ask.text)}</p>" for ask in marking.asks)
    points = "".join(
        f"<tr><td><b>{point.point.kind}</b></td><td>{_STATES[point.state]}</td>"
        f"<td>{escape(point.point.purpose)}</td><td>{escape(point.why)}</td>"
        f"<td>{'' if point.line is None else f'line {point.line}'}</td></tr>"
        for point in marking.marks.points
    )
    heading = "" if marking.part is None else f"<h3>Part ({escape(marking.part)})</h3>"
    return (
        f'<section class="marking">{heading}<table class="lines">{lines}</table>{rest}{asks}'
        f'<h4>{_total(marking.marks)}</h4><table class="points">{points}</table></section>'
    )


def document(
    marked: Sequence[tuple[str, MarkingContent]], title: str | None = None, question: str = ""
) -> str:
    """Markings, each with the name of its script, as a page of HTML beneath the question."""
    body: list[str] = [f"<h1>{escape(title or 'Marking')}</h1>", question]
    names = [None, *(name for name, _ in marked)]
    for before, (name, marking) in zip(names, marked, strict=False):
        if name != before:
            body.append(f"<h2>{escape(name)}</h2>")
        body.append(to_html(marking))
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{escape(title or 'Marking')}</title><style>{_STYLE}</style></head>"
        f"<body>{''.join(body)}</body></html>\n"
    )


_STYLE = (
    "body{font:1rem/1.5 Georgia,serif;max-width:48rem;margin:2rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;width:100%}td{padding:.2rem .6rem;vertical-align:baseline;"
    "border-bottom:1px solid #ddd}code{font-size:1rem}.row{display:flex;gap:.8rem}.row p{margin:0}"
)


def answer_line(answer: AnswerMark) -> str:
    """An answer and what is said of it."""
    start = f"{answer.item} = {answer.value}: "
    if answer.right:
        return start + ("right, but give more figures" if answer.accuracy == "coarse" else "right")
    titles = [f"{MISCONCEPTIONS[name].title} ({name})" for name in answer.as_if]
    if not titles:
        return start + "not right"
    return f"{start}not right; it is what comes of: {' or '.join(titles)}"
