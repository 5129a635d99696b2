"""Slips: what people write in place of the language, consulted only where a line fails to read."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache

from restitution.errors import StatementError
from restitution.expression.source import Source
from restitution.expression.words import LINE_WORDS
from restitution.language.lines import shortened
from restitution.language.outside import outside
from restitution.language.slip_tables import NAME, SLIPS, Cure
from restitution.mending import Fix
from restitution.records import dataclass


@dataclass(frozen=True)
class _Slip:
    lines: frozenset[str]
    pattern: re.Pattern[str]
    cure: Cure | str


@cache
def _slips() -> tuple[_Slip, ...]:
    """The table, compiled when the first mistake is met: most statements have none."""
    return tuple(
        _Slip(frozenset(lines.split()), re.compile(pattern), cure) for lines, pattern, cure in SLIPS
    )


_EVENT = re.compile(rf"\s*{NAME}\s+(?:hits|receives|reaches)\b")


_ALTERNATIVES = 3


_TWO = 2


_LONGEST = 300  # what people write in one line; a longer one is not searched


def with_guess(
    source: Source, word: str, mistake: StatementError, names: Mapping[str, str]
) -> StatementError:
    """The mistake in a line, told by what was probably meant where that is known, with its cure.

    ``word`` is the first word of the line, ``names`` are those declared. A slip counts only where
    the mistake was met, a word that is outside the model wherever it stands.
    """
    if beyond := outside(source):
        return beyond
    first_word = word.lower()  # ``Find the value of e``
    kind = "event" if _EVENT.match(source.plain) else first_word
    if kind not in (*LINE_WORDS, "event"):
        kind = "other"
    start_of_line = source.place(len(source.text) - len(source.text.lstrip()))
    if (mistake.line, mistake.column) == (start_of_line.line, start_of_line.column) and (
        mistake.message.endswith(tuple(f"did you mean '{word}'?" for word in LINE_WORDS))
    ):
        return mistake  # the first word is known already
    before: list[tuple[_Slip, re.Match[str], int, int]] = []
    at = (mistake.line, mistake.column)
    for slip, match in _matches(source, kind):
        start, end = match.span("x" if "x" in slip.pattern.groupindex else 0)
        first, last = source.place(match.start()), source.place(match.end())
        if (first.line, first.column) <= at <= (last.line, last.column):
            return _mistake(source, slip, match, start, end, names)
        if (first.line, first.column) <= at and isinstance(slip.cure, Cure):
            before.append((slip, match, start, end))
    if not mistake.fixes:
        # A word that cannot be read may stand behind a slip with which it would be read.
        mistake.hints = tuple(_mistake(source, *slip, names) for slip in before[:_ALTERNATIVES])
    return mistake


def _mistake(
    source: Source,
    slip: _Slip,
    match: re.Match[str],
    start: int,
    end: int,
    names: Mapping[str, str],
) -> StatementError:
    """The mistake that a slip is, from one offset to another."""
    parts = {
        name: source.text[slice(*match.span(name))] if match[name] else ""
        for name in slip.pattern.groupindex
    }
    parts["x"] = source.text[start:end]
    share = parts.get("share", "").startswith("percent")
    parts["gap"] = " " if parts.get("v", "")[-1:].isalpha() else ""
    parts["as_share"] = " as a percentage" if share else ""
    shown = {name: shortened(text) for name, text in parts.items()}
    cure = slip.cure
    if isinstance(cure, str):
        message = f"cannot read '{shown['x']}': {cure.format(**shown)}" if shown["x"] else cure
        text = _the_only_one(parts["x"], names)
        if text:
            message = f"cannot read '{shown['x']}': did you mean '{text}'?"
        return source.error(message, start, *([source.fix(start, end, text)] if text else []))
    spheres = [name for name, kind in names.items() if kind == "sphere"]
    subjects = spheres if "{sphere}" in cure.text else [""]
    if "{second}" in cure.text and len(spheres) != _TWO:
        return source.error(f"cannot read '{shown['x']}': {cure.message}", start)
    parts["first"], parts["second"] = (*spheres, "A", "B")[:_TWO]
    texts = [
        text.format(**parts, sphere=sphere).rstrip(" ")
        for text in (cure.text, *cure.more)
        for sphere in subjects
    ]
    texts = [", ".join(texts)] if cure.together else texts[:_ALTERNATIVES]
    listed = " or ".join(f"'{text}'" for text in texts)
    text_ = cure.message.format(**shown, sphere=spheres[0] if spheres else "A", each=listed)
    message = f"cannot read '{shown['x']}': {text_}" if shown["x"] else text_
    fixes = [_fix(source, cure, text, match, start, end) for text in texts]
    return source.error(message, start, *fixes)


def _fix(source: Source, cure: Cure, text: str, match: re.Match[str], start: int, end: int) -> Fix:
    """The edit that a cure is, where ``x`` stands from one offset to another."""
    typed = source.text[start:end]
    if cure.of != "x":
        start, end = match.span(cure.of)
    if cure.tight:
        begin = len(source.text[:start].rstrip(" \t,"))
        if text.endswith(typed):
            label = "Begin a line" if text.startswith("\n") else ""
            return source.fix(begin, start, text.removesuffix(typed), label)
        start = begin
    if text.endswith("\n"):
        end += len(source.text[end:]) - len(source.text[end:].lstrip())
    elif text and (
        source.text[end - 1 : end].isspace()
        or (text[-1].isalnum() and source.text[end : end + 1].isalnum())
    ):
        text += " "
    return source.fix(start, end, text)


def _the_only_one(words: str, names: Mapping[str, str]) -> str | None:
    """The name of the only wall or sphere there is, where ``the wall`` speaks of it."""
    match = re.fullmatch(r"(?:the\s+)?(wall|sphere|ball|particle|it)", words, re.IGNORECASE)
    if match is None:
        return None
    kind = "wall" if match.group(1).lower() == "wall" else "sphere"
    known = [name for name, own in names.items() if own == kind]
    return known[0] if len(known) == 1 else None


def _matches(source: Source, kind: str) -> Iterator[tuple[_Slip, re.Match[str]]]:
    if len(source.plain) > _LONGEST:
        return
    for slip in _slips():
        if not slip.lines or kind in slip.lines:
            for match in slip.pattern.finditer(source.plain):
                yield slip, match
