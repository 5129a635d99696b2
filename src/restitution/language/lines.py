"""A text to its logical lines: comments taken off, continued lines joined, sizes checked."""

from __future__ import annotations

import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterator

from restitution.errors import StatementError, require
from restitution.expression.limits import MAX_LINE_LENGTH, MAX_LINES, MAX_TEXT_BYTES
from restitution.expression.signs import LOOK_ALIKES
from restitution.expression.source import Source
from restitution.expression.words import MEANT, NAME, near
from restitution.records import dataclass

_BREAK = re.compile(r"\r\n|\r|\n")
_FIRST_WORD = re.compile(r"\s*(\w+)")
_UTF_16 = (BOM_UTF16_LE, BOM_UTF16_BE)
_LATIN = str.maketrans(LOOK_ALIKES)
_DECLARATION = re.compile(r"\s*(sphere|wall|point)\b([^:]*)")
_SHOWN = 60  # characters of a text in a message


@dataclass(frozen=True)
class LogicalLine:
    """A logical line, its first word, and what follows that word."""

    source: Source
    word: str
    rest: str

    @property
    def start(self) -> int:
        """The offset of the first character that is not blank."""
        return len(self.source.text) - len(self.source.text.lstrip())


def decode(text: str | bytes) -> str:
    """The text itself, of a bearable size. Raises StatementError for bytes that are not UTF-8."""
    require(text, (str, bytes), "parse")
    if len(text) > MAX_TEXT_BYTES:
        raise StatementError(f"the text is too long: at most {MAX_TEXT_BYTES} bytes", 1, 1)
    if isinstance(text, bytes):
        if text.startswith(_UTF_16):
            raise StatementError("the text is in UTF-16: save it in UTF-8")
        try:
            text = text.decode("utf-8")
        except UnicodeDecodeError as error:
            before = _BREAK.split(error.object[: error.start].decode("utf-8"))
            raise StatementError(
                f"the text is not UTF-8: byte {error.object[error.start]:#04x} cannot stand here",
                len(before),
                len(before[-1]) + 1,
            ) from None
    return text.removeprefix("\ufeff")


def logical_lines(text: str) -> Iterator[LogicalLine]:
    """The lines that say something, in order. Raises StatementError where a limit is exceeded."""
    physical = _BREAK.split(text)
    if len(physical) > MAX_LINES:
        raise StatementError(f"a statement has at most {MAX_LINES} lines", MAX_LINES + 1, 1)
    for number, line in enumerate(physical, start=1):
        if len(line) > MAX_LINE_LENGTH:
            raise StatementError(
                f"the line is too long: at most {MAX_LINE_LENGTH} characters", number, 1
            )
    at = 0
    while at < len(physical):
        is_title = _first_word(physical[at]) == "title"
        joined = ""
        pieces: list[tuple[int, int, int]] = []
        while True:
            line = physical[at] if is_title else physical[at].partition("#")[0]
            at += 1
            pieces.append((len(joined), at, 1))
            goes_on = line.rstrip().endswith("\\") and at < len(physical)
            joined += line.rstrip()[:-1] + " " if goes_on else line
            if not goes_on:
                break
            if len(joined) > MAX_TEXT_BYTES:
                break
        word = _first_word(joined)
        if joined.strip():
            rest = joined.strip()[len(word) :] if word else joined
            yield LogicalLine(Source(joined, tuple(pieces)), word, rest)


def _first_word(line: str) -> str:
    match = _FIRST_WORD.match(line)
    return match.group(1) if match else ""


def declared_names(lines: list[LogicalLine]) -> dict[str, str]:
    """Every name declared anywhere, with what it is; the first declaration counts.

    A name in a line that was meant as a declaration and cannot be read is known all the same: the
    mistake is told where it stands, and not again wherever the name does.
    """
    names: dict[str, str] = {}
    for line in lines:
        match = _DECLARATION.match(_in_latin(line))
        if match:
            for declared in match.group(2).split(","):
                # What follows a name without a colon is a mistake, but not of the name.
                name = declared.split()[0] if declared.strip() else ""
                if NAME.fullmatch(name):
                    names.setdefault(name, match.group(1))
    for line in lines:
        for name, kind in _meant_names(line):
            names.setdefault(name, kind)
    for kind, name in _NAMELESS.items():
        if kind not in names.values() and name not in names and is_nameless(lines, kind):
            names[name] = kind
    return names


def _in_latin(line: LogicalLine) -> str:
    """A line with Latin letters for those that look like them, of which a mistake tells."""
    return line.source.plain.translate(_LATIN)


# --- names in lines that cannot be read ---------------------------------------------------------

_KINDS = ("sphere", "wall", "point")
_LIST = re.compile(rf"{NAME.pattern}(?:\s*(?:,|&|\band\b)\s*{NAME.pattern}\b)*")
_ADJECTIVES = (
    r"(?:(?i:let|there\s+(?:is|are)|the|an?|another|two|three|four|smooth|uniform|small|identical"
    r"|equal|solid|fixed|vertical|straight)\s+)*"
)
_KIND_FIRST = re.compile(rf"\s*{_ADJECTIVES}(?P<kind>[A-Za-z]{{3,}})\s+(?={NAME.pattern}\b)")
_NAME_FIRST = re.compile(
    rf"\s*(?:let\s+)?(?P<list>{_LIST.pattern})\s+(?:is|are|be)\s+{_ADJECTIVES}(?P<kind>[a-z]{{3,}})\b"
)
_NAME_ALONE = re.compile(rf"\s*(?P<list>{_LIST.pattern})\s*:\s*(?P<first>[(a-z]\w*)?")
_NAMELESS = {"sphere": "P", "wall": "W"}
_WITHOUT_A_NAME = re.compile(r"\s*(?:an?\s+)?(?P<kind>sphere|wall)\s*(?::|$)")


def _meant_names(line: LogicalLine) -> Iterator[tuple[str, str]]:
    """The names that a line would declare if it could be read, each with what it would be."""
    text = _in_latin(line)
    kind, start = None, 0
    if match := _KIND_FIRST.match(text):
        kind, start = _kind(match["kind"]), match.end()
    if kind is None and (match := _NAME_FIRST.match(text)):
        kind, start = _kind(match["kind"]), match.start("list")
    if kind is None and (match := _NAME_ALONE.match(text)):
        first = match["first"] or ""
        kind = "point" if first == "(" else "wall" if first in _OF_WALLS else "sphere"
        start = match.start("list")
    listed = _LIST.match(text, start)
    if kind is not None and listed is not None:
        for name in NAME.findall(listed.group()):
            yield name, kind


_OF_WALLS = frozenset(("along", "parallel", "through", "from"))


def _kind(word: str) -> str | None:
    """What a word that stands before a name, or behind one, is a slip for or another word for."""
    word = word.lower()
    for form in (word, word.removesuffix("s")):
        meant = MEANT.get(form, form)
        if meant in _KINDS:
            return meant
    return near(word, _KINDS, cutoff=0.8)


def is_nameless(lines: list[LogicalLine], kind: str) -> bool:
    """Whether a line declares a sphere, or a wall, without a name."""
    matches = (_WITHOUT_A_NAME.match(line.source.plain) for line in lines)
    return any(match is not None and match["kind"] == kind for match in matches)


def shortened(text: str) -> str:
    """A text on one line, cut off where it is too long for a message."""
    text = " ".join(text.split())
    return text if len(text) <= _SHOWN else text[: _SHOWN - 1] + "…"
