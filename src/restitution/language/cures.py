"""Cures that hold: a fix is offered only where nothing is wrong with the line that it mends.

Where a mended line has another slip, that is mended as well, so that one cure makes it read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from itertools import takewhile

from restitution.errors import StatementError
from restitution.expression.quantities import QUANTITIES
from restitution.expression.words import FRAGMENTS, NAME, WORDS
from restitution.language.lines import LogicalLine, declared_names, logical_lines, shortened
from restitution.mending import Edit, Fix, mended

_STEPS = 8  # slips in one line that are mended one after another
_OFFERED = 3
_BREAK = re.compile(r"\r\n|\r|\n")
_LONGEST = 300  # characters of a line in which a line of centres is sought

FirstMistake = Callable[[LogicalLine, Mapping[str, str]], StatementError | None]
MistakeWithin = Callable[[str, int, int], StatementError | None]


def cured(
    text: str,
    line: LogicalLine,
    mistake: StatementError,
    first_mistake: FirstMistake,
    mistake_within: MistakeWithin,
) -> StatementError:
    """The mistake in a line of a text, with those of its fixes that hold.

    ``first_mistake`` reads a line by itself, ``mistake_within`` a text, and looks at some of its
    lines. Where the whole line was to be another, and that had slips too, the message suggests what
    reads.
    """
    if moved := _into_the_event(text, line, mistake_within):
        mistake.fixes = (moved,)
        return mistake
    candidates = [*mistake.fixes[:_OFFERED], *_with_a_capital(text, line)]
    places = _Region(line, text)
    mistake.fixes = ()
    beside: StatementError | None = None
    for fix in candidates:
        held, left = _carried_on(text, places, fix, first_mistake, mistake_within)
        beside = beside or left
        if held is not None:
            mistake.fixes = (*mistake.fixes, held)
            written = places.lines(mended(text, held))
            if held is not fix and places.is_whole(fix) and len(written) == 1:
                typed, meant = shortened(places.text), shortened(written[0])
                mistake.message = f"cannot read '{typed}': did you mean '{meant}'?"
                mistake.args = (mistake.message,)
    if not mistake.fixes:
        _by_a_hint(text, places, mistake, first_mistake, mistake_within)
    if not mistake.fixes and beside is not None and beside.message != mistake.message:
        stop = "" if mistake.message.endswith("?") else "."
        mistake.message += f"{stop} Besides, {beside.message}"
        mistake.args = (mistake.message,)
    mistake.hints = ()
    return mistake


def _by_a_hint(
    text: str, places: _Region, mistake: StatementError, read: FirstMistake, within: MistakeWithin
) -> None:
    """Replace a mistake by one before it whose cure makes the line read."""
    for hint in mistake.hints:
        for fix in hint.fixes[:1]:
            held, _ = _carried_on(text, places, fix, read, within)
            if held is not None:
                mistake.message, mistake.fixes = hint.message, (held,)
                mistake.line, mistake.column = hint.line, hint.column
                mistake.args = (mistake.message,)
                return


class _Region:
    """The lines of a text that a logical line takes, in whatever the text is mended to."""

    def __init__(self, line: LogicalLine, text: str) -> None:
        self.first = line.source.pieces[0][1]
        self.last = line.source.pieces[-1][1]
        self.after = len(_BREAK.split(text)) - self.last
        self.text = line.source.text

    def lines(self, text: str) -> list[str]:
        every = _BREAK.split(text)
        return every[self.first - 1 : len(every) - self.after]

    def stretch(self, text: str) -> tuple[int, int]:
        """The first and the last of them."""
        return self.first, len(_BREAK.split(text)) - self.after

    def is_whole(self, fix: Fix) -> bool:
        """Whether a fix writes the whole line anew."""
        if len(fix.edits) != 1 or self.first != self.last:
            return False
        edit = fix.edits[0]
        start = len(self.text) - len(self.text.lstrip())
        return (edit.column, edit.end_column) == (start + 1, len(self.text.rstrip()) + 1)

    def holds(self, fix: Fix) -> bool:
        return all(self.first <= edit.line <= edit.end_line <= self.last for edit in fix.edits)

    def first_mistake(self, text: str, read: FirstMistake) -> StatementError | None:
        lines = list(logical_lines(text))
        names = declared_names(lines)
        first, last = self.stretch(text)
        for line in lines:
            if first <= line.source.pieces[0][1] <= last:
                mistake = read(line, names)
                if mistake is not None:
                    return mistake
        return None


def _carried_on(
    text: str, places: _Region, fix: Fix, read: FirstMistake, within: MistakeWithin
) -> tuple[Fix | None, StatementError | None]:
    """A fix, with what else the line needs so that nothing is wrong there.

    Where that fails there is none, but the mistake that is left. A line is read by itself as long
    as it does not read: that costs little.
    """
    step, now = fix, text
    stuck: StatementError | None = None  # where a cure is not plain
    for _ in range(_STEPS):
        then = mended(now, step)
        if then == now:
            break
        try:
            left = places.first_mistake(then, read) or within(then, *places.stretch(then))
        except StatementError:
            break  # the text has grown too long
        if left is None:
            return fix if now is text else _as_one(text, then, places), None
        if not left.fixes:
            stuck = stuck or left
        onward = left.fixes or tuple(cure for hint in left.hints[:1] for cure in hint.fixes)
        if not onward or not places.holds(fix):
            return None, stuck or left
        step, now = onward[0], then
    return None, stuck


def _as_one(text: str, then: str, places: _Region) -> Fix:
    """Several steps as one edit of the line."""
    old, new = "\n".join(places.lines(text)), "\n".join(places.lines(then))
    ahead = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(old, new, strict=False)))
    rest = zip(old[ahead:][::-1], new[ahead:][::-1], strict=False)
    behind = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], rest))
    edit = Edit(
        *_position(old, ahead, places.first),
        *_position(old, len(old) - behind, places.first),
        new[ahead : len(new) - behind],
    )
    return Fix(f"Write '{shortened(new)}'", (edit,))


def _position(text: str, offset: int, first: int) -> tuple[int, int]:
    rows = text[:offset].split("\n")
    return first + len(rows) - 1, len(rows[-1]) + 1


# --- a line of centres on a line of its own -----------------------------------------------------

_CENTRES = re.compile(
    r"\s*(?:[Tt]he\s+)?line\s+(?:of\s+cent(?:re|er)s|joining\s+(?:the(?:ir)?\s+)?cent(?:re|er)s)\b[^=:]*?"
    r"(?:\bis\b|=|:)\s*(?:(?:parallel\s+to|along|in\s+the\s+direction(?:\s+of)?)\b)?\s*(?P<d>[^\s.].*?)"
    r"[\s.]*$"
)
_EVENT = re.compile(
    rf"\s*{NAME.pattern}\s+hits\s+{NAME.pattern}\s*(?P<colon>:)?(?P<rest>[^:]*?)\s*$"
)


def _into_the_event(text: str, line: LogicalLine, within: MistakeWithin) -> Fix | None:
    """The cure that says a line of centres where the only impact is told, if there is one such."""
    if len(line.source.plain) > _LONGEST:
        return None
    match = _CENTRES.match(line.source.plain)
    events = [
        logical_line
        for logical_line in logical_lines(text)
        if " hits " in logical_line.source.plain
    ]
    if match is None or len(events) != 1 or len(line.source.pieces) > 1:
        return None
    source = events[0].source
    event = _EVENT.match(source.plain[:_LONGEST])
    if event is None or "along" in event["rest"] or len(source.pieces) > 1:
        return None
    mark = ":" if not event["colon"] else "," if event["rest"].strip() else ""
    at = source.place(event.end("rest"))
    own = line.source.pieces[0][1]
    edits = (
        Edit(at.line, at.column, at.line, at.column, f"{mark} along {match['d']}"),
        Edit(own, 1, own + 1, 1, ""),
    )
    then = mended(text, Fix("", edits))
    number = at.line - (at.line > own)
    if within(then, number, number) is not None:
        return None
    return Fix(f"Write 'along {match['d']}' on the line of the impact", edits)


# --- a name in small letters ------------------------------------------------------------------

_DECLARED = re.compile(r"\s*(?:sphere|wall|point)\s+(?P<list>[^:#]*)")
_SMALL = re.compile(r"(?<![\w.])[a-z][A-Za-z0-9]*(?!\w)")


def _with_a_capital(text: str, line: LogicalLine) -> Iterator[Fix]:
    """The cure for names that begin with a small letter: a capital, wherever they are names."""
    lines = list(logical_lines(text))
    known = declared_names(lines)
    small = [
        name
        for name in dict.fromkeys(name for line in lines for name in _small_names(line))
        if _capital(name) not in known
    ]
    if not set(small) & set(_small_names(line)):
        return
    edits = []
    for number, row in enumerate(_BREAK.split(text), start=1):
        if row.lstrip().startswith("title"):
            continue
        for name in small:
            for start in sorted(set(_as_a_name(name, row.partition("#")[0]))):
                end = start + len(name)
                edits.append(Edit(number, start + 1, number, end + 1, _capital(name)))
    yield Fix(f"Write {', '.join(map(_capital, small))} with a capital", tuple(edits))


def _small_names(line: LogicalLine) -> Iterator[str]:
    match = _DECLARED.match(line.source.plain)
    if match is not None:
        for item in match["list"].split(","):
            name = item.split()[0] if item.strip() else ""
            if _SMALL.fullmatch(name) and name not in WORDS and name not in FRAGMENTS:
                yield name


def _capital(name: str) -> str:
    return name[0].upper() + name[1:]


def _as_a_name(name: str, row: str) -> Iterator[int]:
    """Where in a line a word stands as the name of a body, not as a letter."""
    word = rf"(?<![\w.])(?P<x>{name})(?!\w)"
    patterns = (
        rf"^\s*(?:sphere|wall|point)\b[^:]*?{word}",
        rf"^\s*(?:then\s+)?{word}\s+(?=[a-z])(?!\s*[=<>])",
        (
            rf"\b(?:hits?|strikes?|struck|reaches|with|by|into|off|wall|sphere|and|to)\s+{word}"
            r"\s*(?=$|[:,.]|at\b|again\b|do\b|collide\b)"
        ),
        rf"\b(?:{'|'.join(QUANTITIES)})\s*\(\s*{word}\s*[,)]",
        rf"\b(?:distance|angle|along|across)\s*\(.*,\s*{word}\s*\)",
        rf"\b(?:given|show)\s+(?:.*,\s*)?{word}\s+(?:is|at|and|hits|will|does)\b",
        rf"\b(?:of|by)\s+{word}(?=\s|$|[,:])",
    )
    for pattern in patterns:
        for match in re.finditer(pattern, row):
            yield match.start("x")
