"""Lines of mathematics in the columns of a terminal: aligned at their signs, broken before them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from restitution.records import dataclass
from restitution.render.document import (
    Cell,
    CellPiece,
    Chain,
    Emphasis,
    LineBreak,
    Strong,
    Typed,
    pieces,
)
from restitution.render.layout import Brackets, Fraction, Layout, Phrase, Relation, Sum, Words
from restitution.render.text import NO_BREAK, wrapped
from restitution.render.text import to_text as one_line
from restitution.render.text import width as columns

# Where lines of mathematics begin; the numbers of items stand in front of them.
INDENT = 4
# Where the right sides stand below a left side that is too long.
_BELOW = 6
# So many columns more than the shortest left side has are far.
_APART = 28
# Before these a line may end.
_FUNCTIONS = frozenset({"sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan"})
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


@dataclass(frozen=True)
class TextLine:
    """A line of text, the mark at its end, and whether it is a heading."""

    text: str = ""
    mark: str = ""
    strong: bool = False


def plain(texts: Sequence[str]) -> list[TextLine]:
    """Texts as lines without marks."""
    return [TextLine(text) for text in texts]


def _labelled(lines: Sequence[TextLine], label: str, margin: int) -> Iterator[TextLine]:
    """Lines of mathematics moved to the right, with the number of an item in front of the first."""
    for number, line in enumerate(lines):
        text = " " * margin + line.text if line.text else line.text
        if label and number == 0:
            text = label + text[columns(label) :]
        yield line if text == line.text else replace(line, text=text)


def inline(words: Cell) -> str:
    """Words with their mathematics, as one string; formulas are not to be broken."""
    return "".join(map(_piece, pieces(words)))


def _piece(piece: CellPiece) -> str:
    if isinstance(piece, str):
        return piece
    if isinstance(piece, LineBreak):
        return "\n"
    return piece.text if isinstance(piece, Emphasis | Typed | Strong) else _unbroken(piece)


def _unbroken(layout: Layout) -> str:
    """A formula on one line; only among words, and at the signs of a chain, a line may end."""
    if isinstance(layout, Words):
        return layout.text
    if isinstance(layout, Phrase) and NO_BREAK not in layout.separator:
        return layout.separator.join(map(_unbroken, layout.items))
    if isinstance(layout, Relation):
        first, *rest = map(_unbroken, layout.operands)
        signs = zip(layout.signs, rest, strict=True)
        pieces = [f"{sign}{NO_BREAK}{side}" for sign, side in signs]
        if not pieces:
            return first
        # An equation goes to the next line as a whole, a chain only if it is short.
        whole = NO_BREAK.join((first, *pieces))
        if columns(whole) <= (_ALONE if len(pieces) == 1 else _SHORT):
            return whole
        short = columns(first) + columns(rest[0]) <= _SHORT
        return f"{first}{NO_BREAK if short else ' '}{' '.join(pieces)}"
    return one_line(layout).replace(" ", NO_BREAK)


def aligned(chains: Sequence[Chain], width: int, margin: int) -> list[TextLine]:
    """Lines of at most ``width`` columns; ``margin`` more stand in front, for labels."""
    width -= margin
    lefts = [_operand(chain.operands[0]) for chain in chains]
    # The columns left of a right side, for it to stand beside.
    rooms = [width - _margin(chain) - INDENT - _widest(chain) for chain in chains]
    fitting = [
        columns(left)
        for chain, left, most in zip(chains, lefts, rooms, strict=True)
        if chain.signs and columns(left) <= most
    ]
    # One left side that is far longer than others does not push them aside.
    near = min(fitting, default=INDENT) + _APART
    room = max((number for number in fitting if number <= near), default=INDENT)
    lines: list[TextLine] = []
    own = room
    for chain, left, most in zip(chains, lefts, rooms, strict=True):
        if chain.operands[0] is not None:
            # What does not fit beside the others goes on below its left side.
            own = max(room, columns(left))
            if own > most:
                own = _BELOW
        own_lines = _row(chain, left, own if chain.signs else columns(left), width)
        lines += _labelled(own_lines, chain.label, margin)
    return lines


def _margin(chain: Chain) -> int:
    """The columns kept for the marks."""
    return max(_MARKS, columns(chain.mark) + 2)


def _widest(chain: Chain) -> int:
    return max((columns(_operand(operand)) + 3 for operand in chain.operands[1:]), default=0)


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else one_line(layout)


def _row(chain: Chain, left: str, room: int, width: int) -> list[TextLine]:
    """One chain; what does not fit goes on below, under its own sign."""
    first = chain.operands[0]
    if isinstance(first, Fraction) and INDENT + columns(left) > width:
        return _over_a_bar(chain, first, width)
    pad = " " * (INDENT + max(0, room - columns(left)))
    limit = width - _margin(chain)
    lines: list[str] = []
    if first is not None and INDENT + columns(left) > width:
        *above, left = _broken(first, limit - INDENT)
        lines += [" " * INDENT + line for line in above]
        pad = " " * INDENT
    current = pad + left
    start = " " * (INDENT + room)
    if columns(left) > room:
        lines.append(" " * INDENT + left)
        current = start
    note = _held(inline(chain.note))
    gap = "" if chain.goes_on else "   "
    # Behind a line that is alone, marks need no more room than they have.
    own = width - (columns(chain.mark) + 2 if chain.mark else 0)
    room_behind = own if chain.number or not (chain.mark and chain.goes_on) else limit
    cut = False
    for index, (sign, operand) in enumerate(zip(chain.signs, chain.operands[1:], strict=True), 1):
        piece = f" {sign} {_operand(operand)}"
        last = index == len(chain.signs)
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
    rows = [*plain(lines[:-1]), TextLine(lines[-1], strong=chain.answer)]
    if note:
        # Words go on below the right side where they have room there.
        words = note.removeprefix(",").lstrip()
        right = columns(start) + 1 + max(map(columns, chain.signs), default=0) + 1
        indent = right if right + columns(words) <= own else INDENT + 2
        rows += plain([" " * indent + line for line in wrapped(words, own - indent)])
    if chain.mark:
        rows[-1] = replace(rows[-1], mark=chain.mark)
    return rows


def _over_a_bar(chain: Chain, left: Fraction, width: int) -> list[TextLine]:
    """A chain whose left side is one long name over another: with a bar between them."""
    above, below = (one_line(_bare(side)) for side in (left.above, left.below))
    bar = "─" * max(columns(above), columns(below))
    room = columns(bar)
    right = "".join(
        f" {sign} {_operand(e)}" for sign, e in zip(chain.signs, chain.operands[1:], strict=True)
    )
    beside = INDENT + room + columns(right) <= width - _margin(chain)
    rest = _row(
        replace(chain, operands=(Words(bar), *chain.operands[1:])),
        bar,
        room if beside else _BELOW,
        width,
    )
    top, under = (
        TextLine(" " * (INDENT + (room - columns(line)) // 2) + line) for line in (above, below)
    )
    return [top, rest[0], under, *rest[1:]]


def _bare(layout: Layout) -> Layout:
    """What stands in brackets, without them."""
    return layout.inside if isinstance(layout, Brackets) else layout


def _held(words: str) -> str:
    """Words behind a line of which a few in brackets at the end stay on one line."""
    before, bracket, last = words.rpartition(" (")
    return before + bracket + last.replace(" ", NO_BREAK) if len(last) <= _SHORT else words


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
            indent = " " * INDENT if depth > 0 else ""
            lines.append(indent + piece if columns(piece) + INDENT <= room else piece)
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
        words = words and token not in _FUNCTIONS  # of u sin α no line ends within
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
