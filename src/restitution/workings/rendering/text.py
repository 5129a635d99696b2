"""A worked solution for the terminal: sentences wrapped, equations aligned at their signs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from string import ascii_letters, digits

from restitution.explaining.lines.saying import note
from restitution.records import dataclass
from restitution.render.layout import Brackets, Fraction, Layout, Phrase, Relation, Sum
from restitution.render.layout import Words as Upright
from restitution.render.text import NO_BREAK, bold, wrapped
from restitution.render.text import to_text as one_line
from restitution.render.text import width as columns
from restitution.workings.rendering.steps import PartExplanation, Row, Step, Words, Working

# Where lines of mathematics begin; the numbers of items stand in front of them.
_INDENT = 4
# Where the right sides stand below a left side that is too long.
_BELOW = 6
# So many columns more than the shortest left side has are far.
_APART = 28
# Before these a line may end.
_BREAKS = frozenset(("+", "−", "×", "÷", "·", "=", "≠", "<", "≤", ">", "≥", "≈", "or", "and"))
_MARKS = 8
# An equation among words that is no longer stands on one line.
_SHORT = 30
# One that goes to the next line as a whole, rather than to end a line with its left side.
_ALONE = 60
# What is no longer stays behind the stroke of a fraction.
_SHORT_BELOW = 8
# Within more brackets no line ends.
_DEEPEST = 4

_BOLD, _FAINT, _NORMAL = "\x1b[1m", "\x1b[2m", "\x1b[0m"
_LETTERS = {bold(c): c for c in ascii_letters + digits}


@dataclass(frozen=True)
class _Line:
    """A line of text, the mark at its end, and whether it is a heading."""

    text: str = ""
    mark: str = ""
    strong: bool = False


def to_text(explanation: Working, width: int = 80, styled: bool = False) -> str:
    """The whole working as Unicode text, at most ``width`` columns wide where that can be.

    With ``styled``, for a terminal: headings and vectors in bold type, by ANSI sequences, where
    plain text has the bold letters of Unicode, which not every terminal shows.
    """
    lines: list[_Line] = []
    if explanation.title:
        lines += [*_strong(wrapped(explanation.title, width)), _Line()]
    labels = [row.label for row in explanation.rows()]
    margin = max(0, max(map(columns, labels), default=0) + 1 - _INDENT)
    for part in explanation.parts:
        lines += _part(part, width, margin)
    for warning in explanation.left_over:
        lines += _plain(wrapped(note(warning), width))
    while lines and lines[-1] == _Line():
        lines.pop()
    return "\n".join(_finished(line, width, styled) for line in lines).replace(NO_BREAK, " ")


def _plain(texts: Sequence[str]) -> list[_Line]:
    return [_Line(text) for text in texts]


def _strong(texts: Sequence[str]) -> list[_Line]:
    return [_Line(text, strong=True) for text in texts]


def _finished(line: _Line, width: int, styled: bool) -> str:
    gap = " " * max(2, width - columns(line.text) - columns(line.mark)) if line.mark else ""
    if not styled:
        return f"{line.text}{gap}{line.mark}"
    text, mark = line.text, line.mark
    text = "".join(_LETTERS.get(c, c) for c in text) if line.strong else _with_bold(text)
    if line.strong and text:
        text = f"{_BOLD}{text}{_NORMAL}"
    return f"{text}{gap}{_FAINT}{mark}{_NORMAL}" if mark else text


def _with_bold(text: str) -> str:
    """Bold type for the bold letters of Unicode."""
    return "".join(f"{_BOLD}{_LETTERS[c]}{_NORMAL}" if c in _LETTERS else c for c in text)


def _part(part: PartExplanation, width: int, margin: int) -> list[_Line]:
    lines: list[_Line] = []
    if part.label:
        lines += [_Line(f"({part.label})", strong=True), _Line()]
    for step in part.steps:
        printed = _step(step, width, margin)
        idle = printed and printed[0] == _Line() and not (lines and lines[-1] != _Line())
        lines += printed[1:] if idle else printed
    if lines and lines[-1] != _Line():
        lines.append(_Line())
    return lines


def _step(step: Step, width: int, margin: int) -> list[_Line]:
    """The lines of a step; its mathematics has so many columns more in front, for labels."""
    lines: list[_Line] = []
    if step.picture is not None:
        return []
    if step.kind == "heading":
        return [_Line(), *_strong(wrapped(inline(step.words), width))]
    intro = inline(step.words)
    if step.principle:
        named = f"{step.principle}{step.sign}"
        intro = f"{named} {intro}" if intro else named
    if intro:
        lines += _plain(wrapped(intro, width - (columns(step.mark) + 2 if step.mark else 0)))
        if step.mark:
            lines[-1] = replace(lines[-1], mark=step.mark)
    lines += _rows(step.rows, width, margin)
    return lines


def _labelled(lines: Sequence[_Line], label: str, margin: int) -> Iterator[_Line]:
    """Lines of mathematics moved to the right, with the number of an item in front of the first."""
    for number, line in enumerate(lines):
        text = " " * margin + line.text if line.text else line.text
        if label and number == 0:
            text = label + text[columns(label) :]
        yield line if text == line.text else replace(line, text=text)


def inline(words: Words) -> str:
    """Words with their mathematics, as one string; formulas are not to be broken."""
    return "".join(word if isinstance(word, str) else _unbroken(word) for word in words)


def _unbroken(layout: Layout) -> str:
    """A formula on one line; only among words, and at the signs of a chain, a line may end."""
    if isinstance(layout, Upright):
        return layout.text
    if isinstance(layout, Phrase) and NO_BREAK not in layout.separator:
        return layout.separator.join(map(_unbroken, layout.items))
    if isinstance(layout, Relation):
        first, *rest = map(_unbroken, layout.operands)
        signs = zip(layout.signs, rest, strict=True)
        pieces = [f"{sign}{NO_BREAK}{each}" for sign, each in signs]
        if not pieces:
            return first
        # An equation goes to the next line as a whole, a chain only if it is short.
        whole = NO_BREAK.join((first, *pieces))
        if columns(whole) <= (_ALONE if len(pieces) == 1 else _SHORT):
            return whole
        short = columns(first) + columns(rest[0]) <= _SHORT
        return f"{first}{NO_BREAK if short else ' '}{' '.join(pieces)}"
    return one_line(layout).replace(" ", NO_BREAK)


def _rows(rows: Sequence[Row], width: int, margin: int) -> list[_Line]:
    width -= margin
    lefts = [_operand(row.operands[0]) for row in rows]
    fitting = [
        columns(left)
        for row, left in zip(rows, lefts, strict=True)
        if row.signs and not _is_wide(row, columns(left), width)
    ]
    # One left side that is far longer than others does not push them aside.
    near = min(fitting, default=_INDENT) + _APART
    room = max((number for number in fitting if number <= near), default=_INDENT)
    lines: list[_Line] = []
    own = room
    for row, left in zip(rows, lefts, strict=True):
        if row.operands[0] is not None:
            # What does not fit beside the others goes on below its left side.
            own = max(room, columns(left))
            if _is_wide(row, own, width):
                own = _BELOW
        own_lines = _row(row, left, own if row.signs else columns(left), width)
        lines += _labelled(own_lines, row.label, margin)
    return lines


def _is_wide(row: Row, room: int, width: int) -> bool:
    """Whether a right side does not fit beside left sides of a width."""
    return _INDENT + room + _widest(row) > width - _margin(row)


def _margin(row: Row) -> int:
    """The columns kept for the marks."""
    return max(_MARKS, columns(row.mark) + 2)


def _widest(row: Row) -> int:
    return max((columns(_operand(operand)) + 3 for operand in row.operands[1:]), default=0)


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else one_line(layout)


def _row(row: Row, left: str, room: int, width: int) -> list[_Line]:
    """One chain; what does not fit goes on below, under its own sign."""
    first = row.operands[0]
    if isinstance(first, Fraction) and _INDENT + columns(left) > width:
        return _over_a_bar(row, first, width)
    pad = " " * (_INDENT + max(0, room - columns(left)))
    limit = width - _margin(row)
    lines: list[str] = []
    if first is not None and _INDENT + columns(left) > width:
        *above, left = _broken(first, limit - _INDENT)
        lines += [" " * _INDENT + each for each in above]
        pad = " " * _INDENT
    current = pad + left
    start = " " * (_INDENT + room)
    if columns(left) > room:
        lines.append(" " * _INDENT + left)
        current = start
    note = _held(inline(row.note))
    gap = "" if goes_on(row.note) else "   "
    # Behind a line that is alone, marks need no more room than they have.
    own = width - (columns(row.mark) + 2 if row.mark else 0)
    room_behind = own if row.number or not (row.mark and goes_on(row.note)) else limit
    cut = False
    for index, (sign, operand) in enumerate(zip(row.signs, row.operands[1:], strict=True), 1):
        piece = f" {sign} {_operand(operand)}"
        last = index == len(row.signs)
        fresh = current.strip() == "" or current == pad + left
        behind = columns(gap) + columns(note) if note and last else 0
        # The last piece goes to a line of its own, if what stands behind it fits there.
        far = columns(current + piece) + behind > room_behind
        alone = sign in ("=", "≈") and "or" not in piece.split()  # values side by side stay
        apart = far and alone and columns(start + piece) + behind <= room_behind
        if (columns(current + piece) > limit or (behind and apart) or cut) and not fresh:
            lines.append(current)
            current = start
        cut = False
        # Rather than to be broken, a side takes the room of the marks.
        if columns(current + piece) > (own if last else width) and operand is not None:
            broken = _broken(operand, limit - columns(current) - columns(sign) - 2)
            current = f"{current} {sign} {broken[0]}"
            for more in broken[1:]:
                lines.append(current)
                current = f"{start} {' ' * columns(sign)} {more}"
            cut = len(broken) > 1  # what follows has its sign below the one above
            continue
        current += piece
    lines.append(current)
    if note and columns(lines[-1]) + columns(gap) + columns(note) <= room_behind:
        lines[-1] = f"{lines[-1]}{gap}{note}"
        note = ""
    rows = [*_plain(lines[:-1]), _Line(lines[-1], strong=row.answer)]
    if note:
        # Words go on below the right side where they have room there.
        words = note.removeprefix(",").lstrip()
        right = columns(start) + 1 + max(map(columns, row.signs), default=0) + 1
        indent = right if right + columns(words) <= own else _INDENT + 2
        rows += _plain([" " * indent + each for each in wrapped(words, own - indent)])
    if row.mark:
        rows[-1] = replace(rows[-1], mark=row.mark)
    return rows


def _over_a_bar(row: Row, left: Fraction, width: int) -> list[_Line]:
    """A chain whose left side is one long name over another: with a bar between them."""
    above, below = (one_line(_bare(side)) for side in (left.above, left.below))
    bar = "─" * max(columns(above), columns(below))
    room = columns(bar)
    chain = "".join(
        f" {sign} {_operand(e)}" for sign, e in zip(row.signs, row.operands[1:], strict=True)
    )
    beside = _INDENT + room + columns(chain) <= width - _margin(row)
    rest = _row(
        replace(row, operands=(Upright(bar), *row.operands[1:])),
        bar,
        room if beside else _BELOW,
        width,
    )
    top, under = (
        _Line(" " * (_INDENT + (room - columns(each)) // 2) + each) for each in (above, below)
    )
    return [top, rest[0], under, *rest[1:]]


def _bare(layout: Layout) -> Layout:
    """What stands in brackets, without them."""
    return layout.inside if isinstance(layout, Brackets) else layout


def _held(words: str) -> str:
    """Words behind a line of which a few in brackets at the end stay on one line."""
    before, bracket, last = words.rpartition(" (")
    return before + bracket + last.replace(" ", NO_BREAK) if len(last) <= _SHORT else words


def goes_on(words: Words) -> bool:
    """Whether words behind a line begin with a comma."""
    return bool(words) and isinstance(words[0], str) and words[0].startswith(",")


def _broken(layout: Layout, room: int) -> list[str]:
    """A long operand in lines, broken before signs; words between any two."""
    lines = [line for piece in _terms(layout, room) for line in _cut(piece, room)]
    return lines or [""]


def _cut(text: str, room: int) -> list[str]:
    """A line that is too long, broken before a sign, or between words: in brackets last."""
    lines: list[str] = []
    depth = 0
    for piece in _pieces(text, room, 0):
        if lines and columns(lines[-1]) + 1 + columns(piece) <= room:
            lines[-1] += f" {piece}"
        else:
            indent = " " * _INDENT if depth > 0 else ""
            lines.append(indent + piece if columns(piece) + _INDENT <= room else piece)
        depth += _opened(piece)
    return lines


def _pieces(text: str, room: int, depth: int) -> Iterator[str]:
    """Pieces that fit, between which a line may end: within so many brackets, or more of them."""
    for chunk in _chunks(text, depth):
        if columns(chunk) > room and depth < _DEEPEST:
            yield from _pieces(chunk, room, depth + 1)
        else:
            yield chunk


def _chunks(text: str, most: int) -> list[str]:
    """Pieces between which a line may end within at most so many brackets."""
    tokens = text.split(" ")
    chunks = [tokens[0]]
    depth = _opened(tokens[0])
    for before, token in pairwise(tokens):
        words = before.isalpha() and token.isalpha() and len(token) > 1
        if (token in _BREAKS or words) and depth <= most:
            chunks.append(token)
        else:
            chunks[-1] += f" {token}"
        depth += _opened(token)
    return chunks


def _opened(token: str) -> int:
    return token.count("(") - token.count(")")


def _terms(layout: Layout, room: int) -> list[str]:
    """A long sum broken before a sign."""
    if isinstance(layout, Sum) and len(layout.terms) > 1:
        pieces: list[str] = []
        for index, term in enumerate(layout.terms):
            text = (
                one_line(Sum((term,)))
                if index == 0
                else (f"{'−' if term[0] == '-' else '+'} {one_line(term[1])}")
            )
            if pieces and columns(f"{pieces[-1]} {text}") <= room:
                pieces[-1] = f"{pieces[-1]} {text}"
            else:
                pieces.append(text)
        return pieces
    text = one_line(layout)
    return [_divided(text) if isinstance(layout, Fraction) else text]


def _divided(text: str) -> str:
    """A long quotient with a sign before which a line may end."""
    depth = 0
    for index, character in enumerate(text):
        if character == "/" and depth == 0 and len(text) - index > _SHORT_BELOW:
            return f"{text[:index]} ÷ {text[index + 1 :]}"
        depth += _opened(character)
    return text
