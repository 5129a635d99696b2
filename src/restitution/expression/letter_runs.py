"""Runs of letters: functions, Greek letters and single letters side by side, or an unknown word."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import chain

from lark import Token

from restitution.errors import StatementError
from restitution.expression.limits import MAX_DIGITS
from restitution.expression.quantities import QUANTITIES
from restitution.expression.signs import (
    SUBSCRIPT_DIGITS,
    SUPERSCRIPT_DIGITS,
)
from restitution.expression.source import Source, start_of, token_at
from restitution.expression.tree import FUNCTIONS
from restitution.expression.words import (
    GREEK_BY_NAME,
    MEANT,
    WORDS,
    guess,
    meant_name,
    near,
    one_slip,
    unknown_name,
)

_SUBSCRIPT = re.compile(r"_?([0-9]+)|_([A-Za-z])(?![A-Za-z0-9])|([₀-₉]+)")

_FUNCTION_POWER = re.compile(r"\s*(?:\^|\*\*)\s*(\d+)|([⁰¹²³⁴-⁹]+)")

_INVERSE = re.compile(r"\s*(?:\^|\*\*)\s*(?:\(\s*[-−–]\s*1\s*\)|\{\s*[-−–]\s*1\s*\}|[-−–]\s*1)|⁻¹")

_POWER_SIGN = re.compile(r"\s*(?:\^|\*\*|[⁰¹²³⁴-⁹⁻])")

_NEXT = re.compile(r"\s*(.?)", re.DOTALL)

_FUNCTION = re.compile("|".join(sorted(FUNCTIONS, key=len, reverse=True)))


def next_character(text: str, at: int) -> str:
    """The first character from an offset on that is not blank; empty at the end."""
    match = _NEXT.match(text, at)
    return match.group(1) if match else ""


def letter_token(source: Source, name: str, start: int, end: int) -> Token:
    """A letter that ends at ``end``, with the subscript that may follow."""
    match = _SUBSCRIPT.match(source.plain, end)
    if match:
        digits, letter, low = match.groups()
        subscript = digits or letter or low.translate(SUBSCRIPT_DIGITS)
        if len(subscript) > MAX_DIGITS:
            raise source.error(f"a subscript has at most {MAX_DIGITS} digits", end)
        return token_at(source, "LETTER", f"{name}_{subscript}", start, match.end())
    if source.plain.startswith("_", end):
        raise source.error("a subscript is digits or one letter", end)
    return token_at(source, "LETTER", name, start, end)


def letter_run(
    source: Source, names: Mapping[str, str], run: str, at: int, runs: list[tuple[int, str]]
) -> list[Token]:
    """A run of letters that is neither a name nor a keyword."""
    called = source.plain.startswith("(", at + len(run))
    if "_" in run:
        raise _unknown(source, run, names, at)
    pieces = _split(run)
    if pieces is None or (len(run) > 2 and _is_a_slip(run, called)):
        raise _unknown(source, run, names, at)
    tokens: list[Token] = []
    for piece in pieces:
        end = at + len(piece)
        if piece in FUNCTIONS:
            tokens.append(_function(source, piece, at, end))
        elif piece == "pi":
            tokens.append(token_at(source, "PI", "pi", at, end))
        elif piece in names and not source.plain.startswith("_", end):
            if run[0].isupper() and len(run) > 1:
                raise _unknown(source, run, names, at - run.index(piece))
            raise source.error(
                f"'{piece}' is the name of a {names[piece]} and cannot be a letter too", at
            )
        elif piece in ("i", "j"):
            if _SUBSCRIPT.match(source.plain, end):
                raise source.error(f"'{piece}' is a unit vector and never a letter", at)
            tokens.append(token_at(source, "UNIT", piece, at, end))
        else:
            tokens.append(letter_token(source, piece, at, end))
        at = end
    if len(run) > 1 and len(tokens) > 1:
        runs.append((start_of(tokens[0]), run))
    return tokens


def _split(run: str) -> list[str] | None:
    """A run of letters as functions, Greek letters and single letters; None if it is no such run.

    >>> _split("eusintheta")
    ['e', 'u', 'sin', 'theta']
    """
    pieces: list[str] = []
    at = 0
    after_function = False
    while at < len(run) or not pieces:
        match = _FUNCTION.search(run, at)
        end = match.start() if match else len(run)
        between = run[at:end]
        if between in GREEK_BY_NAME or between == "pi":
            pieces.append(between)
        elif len(between) <= (1 if after_function else 4):
            pieces.extend(between)
        else:
            return None
        if match is None:
            break
        pieces.append(match.group())
        after_function = True
        at = match.end()
    return pieces


def _is_a_slip(run: str, called: bool) -> bool:
    """Whether a short run is so near a word of the language that it is surely a mistake.

    Ordinary products (``emu``, ``mgh``, ``kmu``) must not be taken for one.
    """
    if run in GREEK_BY_NAME or (called and run in FUNCTIONS):
        return False
    if any(piece in FUNCTIONS for piece in _split(run) or ()):
        return False
    if called and run in MEANT:
        return True
    if len(run) == 4 and any(
        one_slip(run, word) and len(word) >= 4 for word in WORDS if len(word) in (4, 5)
    ):
        return True
    return called and any(
        one_slip(run, word)
        for word in chain(FUNCTIONS, QUANTITIES)
        if len(word) >= 4 or len(word) == len(run)
    )


def _unknown(source: Source, run: str, names: Mapping[str, str], at: int) -> StatementError:
    """What to say of a run of letters at an offset, and what was probably meant."""
    known = (*WORDS, *MEANT)
    if run[0].isupper() and not (len(run) > 3 and near(run.lower(), known, cutoff=0.9)):
        message, meant = unknown_name(run, names), meant_name(run, names)
    else:
        meant = MEANT.get(run.lower()) or _spaced(run) or guess(run)
        message = f"unknown word '{run}'" + (f": did you mean '{meant}'?" if meant else "")
    fixes = [source.fix(at, at + len(run), meant)] if meant else []
    return source.error(message, at, *fixes)


def _spaced(run: str) -> str | None:
    """Letters run together with the name of a Greek letter, put apart: ``mtheta``."""
    for greek in sorted(GREEK_BY_NAME, key=len, reverse=True):
        rest = run.removesuffix(greek)
        if rest != run and 0 < len(rest) <= 3:
            return f"{' '.join(rest)} {greek}"
    return None


def _function(source: Source, function: str, start: int, end: int) -> Token:
    """A function with the power that may stand between it and its argument."""
    text = source.plain
    if inverse := _INVERSE.match(text, end):
        remedy = (
            f"write arc{function}(x)"
            if f"arc{function}" in FUNCTIONS
            else f"write 1/{function}(x), or use an arc function"
        )
        shown = text[start : inverse.end()]
        inversely = f"arc{function}"
        fixes = [source.fix(start, inverse.end(), inversely)] if inversely in FUNCTIONS else []
        raise source.error(f"'{shown}' can be misunderstood: {remedy}", start, *fixes)
    power = _FUNCTION_POWER.match(text, end)
    if power:
        digits = (power.group(1) or power.group(2)).translate(SUPERSCRIPT_DIGITS)
        if len(digits) > MAX_DIGITS:
            raise source.error(f"a number has at most {MAX_DIGITS} digits", end)
        value, end = f"{function}^{digits}", power.end()
    elif _POWER_SIGN.match(text, end):
        raise source.error(
            f"the power after '{function}' is a whole number: otherwise write ({function}(x))^n",
            end,
        )
    else:
        value = function
    kind = "FUNCTION_CALL" if next_character(text, end) == "(" else "FUNCTION"
    return token_at(source, kind, value, start, end)
