"""The answers alone, without their working: as text, Markdown, LaTeX or HTML."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any, Literal

from restitution.export.units import Units
from restitution.expression.tree import Letter
from restitution.problem import Value
from restitution.records import dataclass
from restitution.render.document import Document, Item, Listing, Piece, Typed
from restitution.render.document.latex import to_latex
from restitution.render.document.markdown import to_markdown
from restitution.render.layout import Layout, Phrase, display, display_point, display_vector
from restitution.render.text import NO_BREAK, to_text, width
from restitution.solving.equations.solution import (
    Answer,
    ItemResult,
    PartSolution,
    Rejected,
    Solution,
)
from restitution.workings.naming.instances import instances

Format = Literal["text", "markdown", "latex", "html"]

UNDECIDED = "not decided, as neither a proof nor a counter-example is known"

_WIDE = 48  # columns of a cell; what is wider stands out of line


@dataclass(frozen=True)
class _Piece:
    """Mathematics with the text that says the same, and the unit behind it."""

    layout: Layout
    text: str
    unit: str = ""


@dataclass(frozen=True)
class _Line:
    """What was asked, as typed, and what is answered; ``label`` is that of the part.

    ``unit`` is that of the one value that stands in ``said``; of several, each has its own there.
    ``beside`` tells what was rejected.
    """

    label: str | None
    asked: str
    pieces: tuple[str | _Piece, ...]
    equal: bool
    unit: str
    beside: tuple[str | _Piece, ...]


def answers(solution: Solution, form: Format = "text", label: str | None = None) -> str:
    """Every item with its answers, one a line; of the part ``label`` only where that is given."""
    lines = list(_lines(solution, label))
    title = solution.problem.title
    if form == "text":
        return _text(title, lines)
    document = _document(title or "", lines)
    match form:
        case "markdown":
            return to_markdown(document)
        case "latex":
            return to_latex(document, whole=False)
        case "html":
            from restitution.render.document.html import to_html

            return to_html(document, "Answers")


def _lines(solution: Solution, label: str | None) -> Iterator[_Line]:
    units = Units(solution)
    for part, item in solution.items():
        if label is None or part.part.label == label:
            unit = units.of(item)
            pieces, beside = tuple(_pieces(item, unit)), tuple(_rejected(part, item, unit))
            equal = is_equal(item) and bool(pieces) and isinstance(pieces[0], _Piece)
            if len(pieces) == 1 and isinstance(pieces[0], _Piece):
                pieces = (replace(pieces[0], unit=""),)
            else:
                unit = ""
            yield _Line(part.part.label, item.text, pieces, equal, unit, beside)


def _pieces(item: ItemResult, unit: str) -> Iterator[str | _Piece]:
    if item.error is not None:
        yield f"no answer: {item.error.message}"
    elif item.holds is not None:
        yield "shown" if item.holds else "not true"
        for number, instance in enumerate(instances(item.counterexample or {})):
            yield ", " if number else ", for instance with "
            yield _Piece(instance, to_text(instance))
        if item.answers:
            yield ": "
    elif item.undecided:
        yield UNDECIDED
    for number, answer in enumerate(item.distinct):
        if number:
            yield "; " if item.kind == "range" else "  or  "  # forms of one range, not choices
        yield from _answer(item, answer, unit)


def _rejected(part: PartSolution, item: ItemResult, unit: str) -> Iterator[str | _Piece]:
    """What was rejected; a consequence of it is not told beside the letter that was asked."""
    reasons = {
        root.reason
        for other in part.items
        if other is not item and isinstance(getattr(other.item, "expression", None), Letter)
        for root in other.rejected
    }
    is_letter = isinstance(getattr(item.item, "expression", None), Letter)
    for root in item.rejected:
        if root.reason in reasons and not is_letter:
            continue
        if item.error is not None and item.error.message.endswith(f"rejected: {root.reason}"):
            continue  # the reason why there is no answer names the values
        yield "  (rejected: "
        yield from _answer(item, root, unit)
        yield f", as {root.reason})"


def _answer(item: ItemResult, answer: Answer | Rejected, unit: str) -> Iterator[str | _Piece]:
    layout, condition = layout_of(item, answer), condition_of(answer)
    if layout is None:
        yield answer.display
    elif condition is None:
        yield _Piece(layout, answer.display, unit)
    else:
        # The words stand outside the mathematics, so that a line may end between them.
        yield _Piece(layout, to_text(layout), unit)
        yield ", for "
        for word in condition:
            yield word if isinstance(word, str) else _Piece(word, to_text(word))


def is_equal(item: ItemResult) -> bool:
    """Whether an item equals its answers: ``speed(P) = …``, but ``range of e: …``."""
    return item.kind not in ("range", "extremum", "show")


def layout_of(item: ItemResult, answer: Answer | Rejected) -> Layout | None:
    """A value as people write it, without its condition.

    None where only its text says it (what was to be shown).
    """
    value: Any = answer.value
    if isinstance(answer, Answer) and answer.layout is not None:
        layout = answer.layout
        if answer.condition_layout is not None and isinstance(layout, Phrase):
            return layout.items[0]
        return layout
    match item.kind:
        case "value" if isinstance(item.item, Value):
            return display(value, angle=answer.angle, percentage=item.item.percentage)
        case "point":
            return display_point(*value)
        case "vector" | "direction":
            return display_vector(*value)
        case _:
            return None


def condition_of(answer: Answer | Rejected) -> tuple[str | Layout, ...] | None:
    """For which letters an answer holds: relations with the words between them.

    None where it holds for all.
    """
    if isinstance(answer, Rejected) or answer.condition_layout is None:
        return None
    return tuple(_apart(answer.condition_layout))


def _apart(layout: Layout) -> Iterator[str | Layout]:
    if not isinstance(layout, Phrase):
        yield layout
        return
    for number, item in enumerate(layout.items):
        if number:
            yield layout.separator
        yield from _apart(item)


def _text(title: str | None, lines: list[_Line]) -> str:
    """A line for each item; those of one value aligned at their signs and units."""
    blocks = [title, ""] if title else []
    asked = {line: f"{_label(line)}{line.asked}" for line in lines}
    texts = {line: _joined(line.pieces) for line in lines}
    first = _room(asked[line] for line in lines if line.equal)
    second = _room(texts[line] for line in lines if line.unit)
    for line in lines:
        left = asked[line]
        if line.equal:
            left += " " * max(0, first - width(left))
        text = f"{left}{_sign(line)}{texts[line]}"
        if line.unit:
            text += " " * max(0, second - width(texts[line])) + f"  {line.unit}"
        text += _joined(line.beside)
        blocks.append(text.replace(NO_BREAK, " "))
    return "\n".join(blocks) + "\n"


def _room(texts: Iterable[str]) -> int:
    """The width of a column: that of the widest text, the very wide ones apart."""
    widths = [width(text) for text in texts]
    return max((number for number in widths if number <= _WIDE), default=0)


def _document(title: str, lines: list[_Line]) -> Document:
    """A list with an entry for each item."""
    items = tuple(
        Item((_label(line), Typed(line.asked), _sign(line), *_words(line))) for line in lines
    )
    return Document(title, (Listing(items),))


def _words(line: _Line) -> Iterator[Piece]:
    """All that is said in a line."""
    for piece in line.pieces:
        yield from _with_unit(piece)
    yield from _behind(line.unit)
    for piece in line.beside:
        yield from _with_unit(piece)


def _with_unit(piece: str | _Piece) -> Iterator[Piece]:
    if isinstance(piece, str):
        yield piece
    else:
        yield piece.layout
        yield from _behind(piece.unit)


def _behind(unit: str) -> tuple[str, ...]:
    """A unit with the blank before it."""
    return (f"{NO_BREAK}{unit}",) if unit else ()


def _label(line: _Line) -> str:
    return f"({line.label}) " if line.label else ""


def _sign(line: _Line) -> str:
    return " = " if line.equal else ": "


def _joined(pieces: tuple[str | _Piece, ...]) -> str:
    return "".join(
        piece if isinstance(piece, str) else "".join((piece.text, *_behind(piece.unit)))
        for piece in pieces
    )
