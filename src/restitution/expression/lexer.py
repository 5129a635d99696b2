"""The scanner: a logical line of text to tokens.

It is written by hand because what a run of letters is depends on the names the text declares.
Multiplication that was left out becomes a token of its own (IMPLICIT), so that the grammar is
one of ordinary operators.
"""

from __future__ import annotations

import re
import unicodedata
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain

from lark import Token

from restitution.errors import StatementError
from restitution.expression.limits import MAX_DIGITS, MAX_NESTING, MAX_TOKENS_PER_LINE
from restitution.expression.quantities import KINDS, QUANTITIES
from restitution.expression.tree import FUNCTIONS, Place
from restitution.expression.units import at_the_end, measure
from restitution.expression.words import (
    FRAGMENTS,
    GREEK_BY_NAME,
    GREEK_SIGNS,
    KEYWORDS,
    MEANT,
    NAME,
    PHRASES,
    PROPERTY_WORDS,
    WORDS,
    guess,
    meant_name,
    near,
    one_slip,
    unknown_name,
)
from restitution.mending import Edit, Fix, Note

_WORD = re.compile(r"[A-Za-z]{2,}(?:_[A-Za-z]{2,})+|[A-Za-z]+")
_NUMBER = re.compile(r"\d+(?:\.\d+)?|\.\d+", re.ASCII)
_PERCENT = re.compile(r"\s*(?:%|per\s?cent(?!\w))")
_DEGREES = re.compile(r"\s*(?:[°º˚]|deg(?:rees?)?(?!\w))")
_SUBSCRIPT = re.compile(r"_?([0-9]+)|_([A-Za-z])(?![A-Za-z0-9])|([₀-₉]+)")
_SUPERSCRIPT = re.compile(r"([⁺⁻]?)([⁰¹²³⁴-⁹]+)")
_FUNCTION_POWER = re.compile(r"\s*(?:\^|\*\*)\s*(\d+)|([⁰¹²³⁴-⁹]+)")
_INVERSE = re.compile(r"\s*(?:\^|\*\*)\s*(?:\(\s*[-−–]\s*1\s*\)|\{\s*[-−–]\s*1\s*\}|[-−–]\s*1)|⁻¹")
_POWER_SIGN = re.compile(r"\s*(?:\^|\*\*|[⁰¹²³⁴-⁹⁻])")
_NEXT = re.compile(r"\s*(.?)", re.DOTALL)
_FUNCTION = re.compile("|".join(sorted(FUNCTIONS, key=len, reverse=True)))
_MISSING_UNDERSCORE = re.compile(
    r"(?:total\s+)?energy\s+lost(?!\w)|line\s+of\s+cent(?:re|er)s(?!\w)"
)
_AXIS = re.compile(r"([xy])[\s–-]*axis(?!\w)")

_SIGNS = {
    "+": "PLUS",
    "-": "MINUS",
    "*": "STAR",
    "**": "POW",
    "^": "POW",
    "/": "SLASH",
    "(": "LPAR",
    ")": "RPAR",
    ",": "COMMA",
    ":": "COLON",
    "=": "EQUAL",
    "<": "ORDER",
    ">": "ORDER",
    "<=": "ORDER",
    ">=": "ORDER",
}
_PASTED = {
    **dict.fromkeys("−–‐‑", "-"),
    **dict.fromkeys("×·⋅∙•∗", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    **dict.fromkeys("≤⩽", "<="),
    **dict.fromkeys("≥⩾", ">="),
}
_FRACTIONS = {
    "½": "1/2",
    "⅓": "1/3",
    "⅔": "2/3",
    "¼": "1/4",
    "¾": "3/4",
    "⅕": "1/5",
    "⅖": "2/5",
    "⅗": "3/5",
    "⅘": "4/5",
    "⅙": "1/6",
    "⅚": "5/6",
    "⅐": "1/7",
    "⅛": "1/8",
    "⅜": "3/8",
    "⅝": "5/8",
    "⅞": "7/8",
    "⅑": "1/9",
    "⅒": "1/10",
}
_HINTS = {
    **dict.fromkeys("[]{}", "use round brackets"),
    **dict.fromkeys("|‖", "write abs(x) for a size"),
    **dict.fromkeys("'’′", "a letter has no dash: use another letter or a subscript"),
    **dict.fromkeys("°º˚", "a degree sign stands directly after a number"),
    **dict.fromkeys('“”„"‘', "leave out the quotation marks"),
    **dict.fromkeys("≈~", "write = … to 3 s.f."),
    **dict.fromkeys("@∠", "write a vector as u at 30°"),
    "%": "a percent sign stands directly after a number",
    "_": "a subscript follows a letter directly and is digits or one letter",
    "≠": "the relations are =, <, <=, > and >=",
    "!": "the relations are =, <, <=, > and >=",
    "\\": "a backslash stands at the end of a line that goes on in the next",
    ".": "a decimal point stands between digits",
    "#": "a comment cannot stand here",
}

_CURES = {**dict.fromkeys("[{", "("), **dict.fromkeys("]}", ")"), **dict.fromkeys('“”„"‘', "")}

_SUBSCRIPT_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_SUPERSCRIPT_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")

_STARTS_OPERAND = frozenset(
    [
        "NUMBER",
        "DEGREES",
        "FRACTION",
        "COEFFICIENT",
        "PI",
        "LETTER",
        "UNIT",
        "NAME",
        "LPAR",
        "FUNCTION",
        "FUNCTION_CALL",
        "QUANTITY",
        "QUANTITY_CALL",
    ]
)
_ENDS_OPERAND = frozenset(
    ["NUMBER", "DEGREES", "FRACTION", "PI", "LETTER", "UNIT", "NAME", "RPAR", "QUANTITY", "MEASURE"]
)
# What a value of numbers is made of; signs and commas in brackets too.
_IN_A_NUMBER = frozenset(
    ["NUMBER", "DEGREES", "FRACTION", "PI", "UNIT", "LPAR", "RPAR", "FUNCTION", "FUNCTION_CALL"]
    + ["STAR", "SLASH", "POW", "MEASURE"]
)
_NO_NUMBER = frozenset(["LETTER", "NAME", "QUANTITY", "QUANTITY_CALL"])
_NUMERIC = frozenset(("NUMBER", "DEGREES", "FRACTION"))
_BODY_LINES = frozenset(("SPHERE", "WALL", "POINT"))


@dataclass(frozen=True)
class Source:
    """A logical line: its text, and where each stretch of it stands in the file.

    ``plain`` is the text with typographical variants of letters and digits made ordinary,
    character by character, so that offsets agree.
    """

    text: str
    pieces: tuple[tuple[int, int, int], ...] = ((0, 1, 1),)  # offset, line, column
    plain: str = field(init=False)

    def __post_init__(self) -> None:
        plain = self.text if self.text.isascii() else "".join(map(_plain, self.text))
        object.__setattr__(self, "plain", plain)

    def place(self, offset: int) -> Place:
        """The line and column of an offset of the text."""
        start, line, column = self.pieces[bisect_right(self.pieces, (offset, 10**9, 0)) - 1]
        return Place(line, column + offset - start)

    def error(self, message: str, offset: int, *fixes: Fix) -> StatementError:
        """A mistake at an offset of the text, and what would cure it."""
        place = self.place(offset)
        mistake = StatementError(message, place.line, place.column)
        mistake.fixes = fixes
        return mistake

    def stretch(self, start: int, end: int) -> tuple[int, int, int, int]:
        """Line and column of an offset, and of another behind it."""
        first = self.place(start)
        if end <= start:
            return first.line, first.column, first.line, first.column
        last = self.place(end - 1)
        return first.line, first.column, last.line, last.column + 1

    def fix(self, start: int, end: int, text: str, label: str = "") -> Fix:
        """The cure that puts a text in the place of another, or takes that out."""
        typed = " ".join(self.text[start:end].split())
        if not text:
            while start and self.text[start - 1].isspace():
                start -= 1
            while not start and end < len(self.text) and self.text[end].isspace():
                end += 1
        if not label:
            label = (
                f"Leave out '{typed}'"
                if not text
                else f"Replace '{typed}' by '{text.strip()}'"
                if typed
                else f"Put in '{text.strip()}'"
            )
        return Fix(label, (Edit(*self.stretch(start, end), text),))


@dataclass(frozen=True)
class Scan:
    """The tokens of a logical line, and the runs of letters that were split into products.

    ``warnings`` tells of letters that look like a unit.
    """

    source: Source
    names: Mapping[str, str]
    tokens: tuple[Token, ...]
    runs: tuple[tuple[int, str], ...]
    warnings: tuple[Note, ...] = ()


def _plain(character: str) -> str:
    """A letter or digit in ordinary type for one in bold, italic or full-width type."""
    code = ord(character)
    if code < 0x80:
        return character
    if 0x1D400 <= code <= 0x1D7FF or 0xFF01 <= code <= 0xFF5E or code == 0x210E:
        normal = unicodedata.normalize("NFKC", character)
        return normal if len(normal) == 1 else character
    if character in "îĵ":
        return "i" if character == "î" else "j"
    if character.isspace() or unicodedata.category(character) == "Cf":
        return " "
    return character


def scan(source: Source, names: Mapping[str, str]) -> Scan:
    """The tokens of a line; ``names`` maps each declared name to what it is (``sphere``, …).

    Raises StatementError for a character or a word that means nothing, with its place.
    """
    tokens: list[Token] = []
    runs: list[tuple[int, str]] = []
    warnings: list[Note] = []
    depth = 0
    for token in _raw_tokens(source, names, tokens, runs, warnings):
        if token.type == "LPAR":
            depth += 1
            if depth > MAX_NESTING:
                raise source.error(
                    f"brackets are nested more than {MAX_NESTING} deep", _start(token)
                )
        elif token.type == "RPAR":
            depth -= 1
        tokens.append(token)
        if len(tokens) > MAX_TOKENS_PER_LINE:
            raise source.error(
                f"the line is too long: at most {MAX_TOKENS_PER_LINE} words and signs",
                _start(token),
            )
    return Scan(source, names, tuple(_with_products(source, tokens)), tuple(runs), tuple(warnings))


def _start(token: Token) -> int:
    return token.start_pos or 0


def _end(token: Token) -> int:
    return token.end_pos or 0


def _raw_tokens(
    source: Source,
    names: Mapping[str, str],
    before: list[Token],
    runs: list[tuple[int, str]],
    warnings: list[Note],
) -> Iterator[Token]:
    """The tokens as they stand; ``before`` is what has been taken so far."""
    text = source.plain
    at = 0
    while at < len(text):
        character = text[at]
        if character.isspace():
            at += 1
            continue
        if character.isascii() and character.isalpha():
            unit = _unit(source, names, at, before, warnings)
            tokens = [unit] if unit else _letters(source, names, at, before, runs)
        elif character in GREEK_SIGNS:
            tokens = [_letter(source, GREEK_SIGNS[character], at, at + 1)]
        elif character == "π":
            tokens = [_token(source, "PI", "pi", at, at + 1)]
        elif number := _NUMBER.match(text, at):
            tokens = [_number(source, number)]
        elif character in _FRACTIONS:
            if before and before[-1].type == "NUMBER" and _end(before[-1]) == at:
                raise source.error(
                    "a mixed number is not read: write it as one fraction, such as 5/2", at
                )
            tokens = [_fraction(source, at)]
        elif character == "√":
            tokens = [_root(source, at)]
        elif power := _SUPERSCRIPT.match(text, at):
            tokens = _superscript(source, power)
        else:
            tokens = [_sign(source, at)]
        yield from tokens
        at = _end(tokens[-1])


def _token(source: Source, kind: str, value: str, start: int, end: int) -> Token:
    place = source.place(start)
    return Token(kind, value, start, place.line, place.column, end_pos=end)


def _sign(source: Source, at: int) -> Token:
    text = source.plain
    for sign in (text[at : at + 2], _PASTED.get(text[at], text[at])):
        if sign in _SIGNS:
            length = len(sign) if text.startswith(sign, at) else 1
            return _token(source, _SIGNS[sign], sign, at, at + length)
    character = text[at]
    shown = repr(character) if character.isprintable() else f"U+{ord(character):04X}"
    hint = _HINTS.get(character)
    fixes = [source.fix(at, at + 1, _CURES[character])] if character in _CURES else []
    raise source.error(f"unexpected character {shown}" + (f": {hint}" if hint else ""), at, *fixes)


def _number(source: Source, match: re.Match[str]) -> Token:
    text, start, end = source.plain, match.start(), match.end()
    if end - start > MAX_DIGITS:
        raise source.error(f"a number has at most {MAX_DIGITS} digits", start)
    digits = match.group()
    if percent := _PERCENT.match(text, end):
        return _token(source, "NUMBER", digits + "%", start, percent.end())
    if degrees := _DEGREES.match(text, end):
        return _token(source, "DEGREES", digits, start, degrees.end())
    return _token(source, "NUMBER", digits, start, end)


def _fraction(source: Source, at: int) -> Token:
    fraction = _FRACTIONS[source.plain[at]]
    if degrees := _DEGREES.match(source.plain, at + 1):
        return _token(source, "DEGREES", fraction, at, degrees.end())
    return _token(source, "FRACTION", fraction, at, at + 1)


def _unit(
    source: Source,
    names: Mapping[str, str],
    at: int,
    before: list[Token],
    warnings: list[Note],
) -> Token | None:
    """A unit that ends a value: a token where the value is made of numbers alone.

    Of a letter it may be a product that is meant: that draws a warning. Between the two (``k/2
    kg``) it is refused.
    """
    if not before or before[-1].type not in _ENDS_OPERAND or before[-1].type == "MEASURE":
        return None
    match = at_the_end(source.plain, at)
    if match is None or match.group() in names:
        return None
    unit, end = match.group(), match.end()
    if len(unit) == 1 and not _may_be_a_letter_of_unit(before):
        return None
    exponent = len(before) > 1 and before[-2].type == "POW"
    if _is_plain(before) and not exponent:
        return _token(source, "MEASURE", unit, at, end)
    if len(unit) == 1 or measure(unit).dimension is None:
        return None
    if _is_a_value(before):
        leave_out = source.fix(at, end, "")
        raise source.error(unit_refused(unit), at, leave_out)
    place = source.place(at)
    message = f"'{unit}' was read as a product of letters; no units are typed (all is in SI)"
    warnings.append(Note(message, place.line, place.column, (source.fix(at, end, ""),)))
    return None


def _may_be_a_letter_of_unit(before: list[Token]) -> bool:
    """Whether a unit of one letter may follow: not an angle, nor ``sin 2m``."""
    if before[-1].type == "DEGREES":
        return False
    return len(before) < 2 or before[-2].type != "FUNCTION" or before[-2] == "√"


def _is_plain(before: list[Token]) -> bool:
    """Whether the value that stands last is made of numbers and **i**, **j** alone."""
    depth = 0
    for index, token in reversed(list(enumerate(before))):
        if token.type == "QUANTITY" and index and before[index - 1].type in ("COLON", "COMMA"):
            return True  # ``speed 3 m/s``, where a property was meant
        if token.type in _NO_NUMBER:
            return False
        if token.type == "LPAR" and depth == 0:
            return True
        depth += {"RPAR": 1, "LPAR": -1}.get(token.type, 0)
        if depth == 0 and token.type not in _IN_A_NUMBER:
            return True
    return True


def _is_a_value(before: list[Token]) -> bool:
    """Whether what stands last is surely a number or a vector, and no letter of a product."""
    last = before[-1]
    if last.type in _NUMERIC:
        return len(before) < 2 or before[-2].type != "POW"
    if last.type != "RPAR":
        return last.type == "UNIT"
    depth = 0
    inside: set[str] = set()
    for token in reversed(before):
        depth += {"RPAR": 1, "LPAR": -1}.get(token.type, 0)
        if depth == 0:
            break
        inside.add(token.type)
    return bool(inside & {"UNIT", "COMMA"}) or not inside & {"LETTER", "NAME", "QUANTITY"}


def unit_refused(unit: str) -> str:
    """What to say of a unit that cannot be read as one."""
    if unit == "rad":
        return "no units are typed: leave out 'rad' (an angle without ° is in radians)"
    return f"no units are typed (all is in SI): leave out '{unit}'"


def _tells_properties(before: list[Token]) -> bool:
    """Whether a line is one whose properties stand behind a colon."""
    return bool(before) and (
        before[0].type in _BODY_LINES
        or (len(before) > 1 and before[1].type in ("HITS", "RECEIVES") and before[0].type == "NAME")
    )


def _superscript(source: Source, match: re.Match[str]) -> list[Token]:
    start, end = match.span()
    sign, digits = match.groups()
    if len(digits) > MAX_DIGITS:
        raise source.error(f"a number has at most {MAX_DIGITS} digits", start)
    tokens = [_token(source, "POW", "^", start, end)]
    if sign == "⁻":
        tokens.append(_token(source, "MINUS", "-", start, end))
    tokens.append(_token(source, "NUMBER", digits.translate(_SUPERSCRIPT_DIGITS), start, end))
    return tokens


def _root(source: Source, at: int) -> Token:
    following = _next_character(source.plain, at + 1)
    kind = "FUNCTION_CALL" if following == "(" else "FUNCTION"
    return _token(source, kind, "√" if kind == "FUNCTION" else "sqrt", at, at + 1)


def _next_character(text: str, at: int) -> str:
    match = _NEXT.match(text, at)
    return match.group(1) if match else ""


def _letter(source: Source, name: str, start: int, end: int) -> Token:
    """A letter that ends at ``end``, with the subscript that may follow."""
    match = _SUBSCRIPT.match(source.plain, end)
    if match:
        digits, letter, low = match.groups()
        subscript = digits or letter or low.translate(_SUBSCRIPT_DIGITS)
        if len(subscript) > MAX_DIGITS:
            raise source.error(f"a subscript has at most {MAX_DIGITS} digits", end)
        return _token(source, "LETTER", f"{name}_{subscript}", start, match.end())
    if source.plain.startswith("_", end):
        raise source.error("a subscript is digits or one letter", end)
    return _token(source, "LETTER", name, start, end)


def _letters(
    source: Source,
    names: Mapping[str, str],
    at: int,
    before: list[Token],
    runs: list[tuple[int, str]],
) -> list[Token]:
    """What stands at a Latin letter: a name, a phrase, a word, a function, letters."""
    text = source.plain
    name = NAME.match(text, at)
    if name and name.group() in names and not text.startswith("_", name.end()):
        return [_token(source, "NAME", name.group(), at, name.end())]
    for pattern, kind in PHRASES:
        phrase = pattern.match(text, at)
        if phrase:
            return [_token(source, kind, " ".join(phrase.group().split()), at, phrase.end())]
    unit = at_the_end(text, at + 1) if text[at] in "ij" else None
    if unit and len(unit.group()) > 1:
        return [_token(source, "UNIT", text[at], at, at + 1)]  # ``4jms^-1``
    axis = _AXIS.match(text, at)
    if axis:
        vector = {"x": "i", "y": "j"}[axis.group(1)]
        fix = source.fix(at, axis.end(), vector)
        raise source.error(f"unknown words '{axis.group()}': did you mean '{vector}'?", at, fix)
    loose = _MISSING_UNDERSCORE.match(text, at)
    if loose:
        words = " ".join(loose.group().split())
        fix = source.fix(at, loose.end(), MEANT[words])
        raise source.error(f"unknown words '{words}': did you mean '{MEANT[words]}'?", at, fix)
    word = _WORD.match(text, at)
    assert word is not None
    run, end = word.group(), word.end()
    if run in PROPERTY_WORDS and _property_stands_here(before):
        return [_token(source, run.upper(), run, at, end)]
    if run in PROPERTY_WORDS and _tells_properties(before) and not text.startswith("(", end):
        return [_token(source, run.upper(), run, at, end)]
    if run in QUANTITIES or names.get(run) == "quantity":
        return [_quantity(source, run, at, end)]
    if run in KEYWORDS:
        return [_token(source, KEYWORDS[run], run, at, end)]
    if run == "of" and before and before[-1].type == "NUMBER" and before[-1].endswith("%"):
        return [_token(source, "STAR", "*", at, end)]  # ``60% of energy(0)``
    if run in FRAGMENTS:
        return [_token(source, "WORD", run, at, end)]
    return _run(source, names, run, at, runs)


def _property_stands_here(before: list[Token]) -> bool:
    """Whether the next word is a property: after the colon, or after a comma not in brackets."""
    if not before or before[-1].type not in ("COLON", "COMMA") or not _tells_properties(before):
        return False
    depth = 0
    colon = False
    for token in before:
        if token.type == "COLON":
            colon = True
        elif token.type in ("LPAR", "RPAR"):
            depth += 1 if token.type == "LPAR" else -1
    return colon and depth == 0


def _quantity(source: Source, kind: str, start: int, end: int) -> Token:
    call = source.plain.startswith("(", end)
    if not KINDS[kind].stands_alone:
        # A blank before the bracket is harmless here: without arguments it means nothing.
        call = call or _next_character(source.plain, end) == "("
    return _token(source, "QUANTITY_CALL" if call else "QUANTITY", kind, start, end)


def _run(
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
            tokens.append(_token(source, "PI", "pi", at, end))
        elif piece in names and not source.plain.startswith("_", end):
            if run[0].isupper() and len(run) > 1:
                raise _unknown(source, run, names, at - run.index(piece))
            raise source.error(
                f"'{piece}' is the name of a {names[piece]} and cannot be a letter too", at
            )
        elif piece in ("i", "j"):
            if _SUBSCRIPT.match(source.plain, end):
                raise source.error(f"'{piece}' is a unit vector and never a letter", at)
            tokens.append(_token(source, "UNIT", piece, at, end))
        else:
            tokens.append(_letter(source, piece, at, end))
        at = end
    if len(run) > 1 and len(tokens) > 1:
        runs.append((_start(tokens[0]), run))
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
        digits = (power.group(1) or power.group(2)).translate(_SUPERSCRIPT_DIGITS)
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
    kind = "FUNCTION_CALL" if _next_character(text, end) == "(" else "FUNCTION"
    return _token(source, kind, value, start, end)


def _with_products(source: Source, tokens: list[Token]) -> Iterator[Token]:
    """The tokens with IMPLICIT wherever multiplication was left out."""
    previous: Token | None = None
    vector = ""  # the unit vector among the factors that stand side by side
    for index, token in enumerate(tokens):
        if previous is not None and _joins(previous, token):
            if token.type in _NUMERIC and previous.type in _NUMERIC:
                raise source.error(
                    "two numbers stand side by side: an operator is missing", _start(token)
                )
            if token.type in _NUMERIC and vector:
                # ``along i 1/2`` is no vector of half the length.
                raise source.error(
                    f"a number stands behind {vector}: a sign or a comma is missing", _start(token)
                )
            gap = source.plain[_end(previous) : _start(token)]
            yield _token(source, "IMPLICIT", gap, _end(previous), _start(token))
        else:
            vector = ""
        if token.type == "UNIT":
            vector = str(token)
        if (
            previous is not None
            and previous.type == "FUNCTION"
            and previous != "√"
            and token.type == "NUMBER"
            and index + 1 < len(tokens)
            and tokens[index + 1].type in ("LETTER", "PI")
        ):
            # ``sin 2θ``: the number belongs to the one letter after it.
            token = Token.new_borrow_pos("COEFFICIENT", str(token), token)
        yield token
        previous = token


def _joins(left: Token, right: Token) -> bool:
    return left.type in _ENDS_OPERAND and right.type in _STARTS_OPERAND
