"""Questions in words: what they look like, and what to say of them once, not line by line."""

from __future__ import annotations

import re
from collections.abc import Container

from restitution.errors import StatementError
from restitution.expression.words import KEYWORDS, LINE_WORDS, WORDS
from restitution.language.lines import LogicalLine
from restitution.mending import Edit, Fix

_SURELY = 8  # words that the language has not, in one line
_PROBABLY = 4  # in a line that looks like a sentence besides
_WORD = re.compile(r"[A-Za-z]{2,}(?:['’-][A-Za-z]+)*")
_SENTENCE = re.compile(
    r"^\W*(?:\(?[a-z0-9]{1,3}[).]\W*)?[A-Z][a-z]+\b|[A-Za-z)\d][.?!;]\s*$|[.?!]\s+[A-Z]"
)
_BODY_WORDS = ("sphere", "wall", "point")
_LETTERS = re.compile(r"[A-Z][A-Za-z0-9]*")

_IN_WORDS = (
    "this is a question in words: write one fact a line, such as "
    "'sphere A: mass 2, velocity 3i - 4j', 'A hits B: along j, e = 1/2' and 'find velocity(A)', "
    "or use the form on the page"
)


def is_in_words(line: LogicalLine, bodies: Container[str]) -> bool:
    """Whether a line that cannot be read is English rather than a slip in the language.

    ``bodies`` are the names in lines that can be read.
    """
    if is_of_the_language(line, bodies):
        return False
    text = line.source.plain
    strange = sum(
        1
        for word in _WORD.findall(text)
        if word not in bodies and word.lower() not in WORDS and word.lower() not in KEYWORDS
    )
    return strange >= _SURELY or (strange >= _PROBABLY and bool(_SENTENCE.search(text)))


def is_of_the_language(line: LogicalLine, bodies: Container[str]) -> bool:
    """Whether a line begins as one of the language does, whatever follows."""
    words = line.source.plain.split()
    if line.word in _BODY_WORDS:
        return len(words) > 1 and _LETTERS.match(words[1]) is not None
    if line.word in LINE_WORDS:
        return True
    return words[0] in bodies


def in_words(lines: list[LogicalLine]) -> StatementError:
    """The one mistake that lines in words are, with the cure to keep them as comments."""
    first = lines[0]
    mistake = first.source.error(_IN_WORDS, first.start)
    rows = [row for line in lines for _, row, _ in line.source.pieces]
    edits = tuple(Edit(row, 1, row, 1, "# ") for row in rows)
    mistake.fixes = (Fix("Keep the words as a comment", edits),)
    return mistake
