"""The scanner: a logical line of text to tokens.

It is written by hand because what a run of letters is depends on the names the text declares.
Multiplication that was left out becomes a token of its own (IMPLICIT), so that the grammar is
one of ordinary operators.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping

from lark import Token

from restitution.expression.letter_runs import (
    letter_run,
    letter_token,
    next_character,
)
from restitution.expression.limits import MAX_DIGITS, MAX_NESTING, MAX_TOKENS_PER_LINE
from restitution.expression.quantities import KINDS, QUANTITIES
from restitution.expression.signs import (
    CURES,
    FRACTIONS,
    HINTS,
    LOOK_ALIKES,
    PASTED,
    SIGNS,
    SUPERSCRIPT_DIGITS,
)
from restitution.expression.source import Source, end_of, start_of, token_at
from restitution.expression.units import at_the_end, measure
from restitution.expression.words import (
    FRAGMENTS,
    GREEK_SIGNS,
    KEYWORDS,
    MEANT,
    NAME,
    PHRASES,
    PROPERTY_WORDS,
)
from restitution.mending import Note
from restitution.records import dataclass

_WORD = re.compile(r"[A-Za-z]{2,}(?:_[A-Za-z]{2,})+|[A-Za-z]+")
_NUMBER = re.compile(r"\d+(?:\.\d+)?|\.\d+", re.ASCII)
_PERCENT = re.compile(r"\s*(?:%|per\s?cent(?!\w))")
_DEGREES = re.compile(r"\s*(?:[°º˚]|deg(?:rees?)?(?!\w))")
_SUPERSCRIPT = re.compile(r"([⁺⁻]?)([⁰¹²³⁴-⁹]+)")
_MISSING_UNDERSCORE = re.compile(
    r"(?:total\s+)?energy\s+lost(?!\w)|line\s+of\s+cent(?:re|er)s(?!\w)"
)
_AXIS = re.compile(r"([xy])[\s–-]*axis(?!\w)")

_LOOK_ALIKE = re.compile(rf"[{''.join(LOOK_ALIKES)}][^\W\d_]*")

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
class Scan:
    """The tokens of a logical line, and the runs of letters that were split into products.

    ``warnings`` tells of letters that look like a unit.
    """

    source: Source
    names: Mapping[str, str]
    tokens: tuple[Token, ...]
    runs: tuple[tuple[int, str], ...]
    warnings: tuple[Note, ...] = ()


def scan(source: Source, names: Mapping[str, str]) -> Scan:
    """The tokens of a line; ``names`` maps each declared name to what it is (``sphere``, …).

    Raises StatementError for a character or a word that means nothing, with its place.
    """
    _refuse_look_alikes(source)
    tokens: list[Token] = []
    runs: list[tuple[int, str]] = []
    warnings: list[Note] = []
    depth = 0
    for token in _raw_tokens(source, names, tokens, runs, warnings):
        if token.type == "LPAR":
            depth += 1
            if depth > MAX_NESTING:
                raise source.error(
                    f"brackets are nested more than {MAX_NESTING} deep", start_of(token)
                )
        elif token.type == "RPAR":
            depth -= 1
        tokens.append(token)
        if len(tokens) > MAX_TOKENS_PER_LINE:
            raise source.error(
                f"the line is too long: at most {MAX_TOKENS_PER_LINE} words and signs",
                start_of(token),
            )
    return Scan(source, names, tuple(_with_products(source, tokens)), tuple(runs), tuple(warnings))


def _refuse_look_alikes(source: Source) -> None:
    """Raises StatementError for a letter that only looks like a Latin one: nobody sees which."""
    match = None if source.plain.isascii() else _LOOK_ALIKE.search(source.plain)
    if match is None:
        return
    at, end = match.span()
    script, *rest = unicodedata.name(source.plain[at]).split()
    raise source.error(
        f"'{source.plain[at]}' is U+{ord(source.plain[at]):04X}, {script.capitalize()} "
        f"{' '.join(rest).lower()}: did you mean '{LOOK_ALIKES[source.plain[at]]}'?",
        at,
        source.fix(at, end, "".join(LOOK_ALIKES.get(letter, letter) for letter in match.group())),
    )


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
            tokens = [letter_token(source, GREEK_SIGNS[character], at, at + 1)]
        elif character == "π":
            tokens = [token_at(source, "PI", "pi", at, at + 1)]
        elif number := _NUMBER.match(text, at):
            tokens = [_number(source, number)]
        elif character in FRACTIONS:
            if before and before[-1].type == "NUMBER" and end_of(before[-1]) == at:
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
        at = end_of(tokens[-1])


def _sign(source: Source, at: int) -> Token:
    text = source.plain
    for sign in (text[at : at + 2], PASTED.get(text[at], text[at])):
        if sign in SIGNS:
            length = len(sign) if text.startswith(sign, at) else 1
            return token_at(source, SIGNS[sign], sign, at, at + length)
    character = text[at]
    shown = repr(character) if character.isprintable() else f"U+{ord(character):04X}"
    hint = HINTS.get(character)
    fixes = [source.fix(at, at + 1, CURES[character])] if character in CURES else []
    raise source.error(f"unexpected character {shown}" + (f": {hint}" if hint else ""), at, *fixes)


def _number(source: Source, match: re.Match[str]) -> Token:
    text, start, end = source.plain, match.start(), match.end()
    if end - start > MAX_DIGITS:
        raise source.error(f"a number has at most {MAX_DIGITS} digits", start)
    digits = match.group()
    if percent := _PERCENT.match(text, end):
        return token_at(source, "NUMBER", digits + "%", start, percent.end())
    if degrees := _DEGREES.match(text, end):
        return token_at(source, "DEGREES", digits, start, degrees.end())
    return token_at(source, "NUMBER", digits, start, end)


def _fraction(source: Source, at: int) -> Token:
    fraction = FRACTIONS[source.plain[at]]
    if degrees := _DEGREES.match(source.plain, at + 1):
        return token_at(source, "DEGREES", fraction, at, degrees.end())
    return token_at(source, "FRACTION", fraction, at, at + 1)


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
        return token_at(source, "MEASURE", unit, at, end)
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
    tokens = [token_at(source, "POW", "^", start, end)]
    if sign == "⁻":
        tokens.append(token_at(source, "MINUS", "-", start, end))
    tokens.append(token_at(source, "NUMBER", digits.translate(SUPERSCRIPT_DIGITS), start, end))
    return tokens


def _root(source: Source, at: int) -> Token:
    following = next_character(source.plain, at + 1)
    kind = "FUNCTION_CALL" if following == "(" else "FUNCTION"
    return token_at(source, kind, "√" if kind == "FUNCTION" else "sqrt", at, at + 1)


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
        return [token_at(source, "NAME", name.group(), at, name.end())]
    for pattern, kind in PHRASES:
        phrase = pattern.match(text, at)
        if phrase:
            return [token_at(source, kind, " ".join(phrase.group().split()), at, phrase.end())]
    unit = at_the_end(text, at + 1) if text[at] in "ij" else None
    if unit and len(unit.group()) > 1:
        return [token_at(source, "UNIT", text[at], at, at + 1)]  # ``4jms^-1``
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
        return [token_at(source, run.upper(), run, at, end)]
    if run in PROPERTY_WORDS and _tells_properties(before) and not text.startswith("(", end):
        return [token_at(source, run.upper(), run, at, end)]
    if run in QUANTITIES or names.get(run) == "quantity":
        return [_quantity(source, run, at, end)]
    if run in KEYWORDS:
        return [token_at(source, KEYWORDS[run], run, at, end)]
    if run == "of" and _is_a_share(before):
        return [token_at(source, "STAR", "*", at, end)]  # ``60% of energy(0)``
    if run in FRAGMENTS:
        return [token_at(source, "WORD", run, at, end)]
    return letter_run(source, names, run, at, runs)


def _is_a_share(before: list[Token]) -> bool:
    """Whether a percentage or a fraction of numbers stands before *of*."""
    if not before or before[-1].type not in ("NUMBER", "FRACTION"):
        return False
    types = [token.type for token in before[-3:]]
    return (
        types[-1] == "FRACTION"
        or before[-1].endswith("%")
        or types == ["NUMBER", "SLASH", "NUMBER"]
    )


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
        call = call or next_character(source.plain, end) == "("
    return token_at(source, "QUANTITY_CALL" if call else "QUANTITY", kind, start, end)


def _with_products(source: Source, tokens: list[Token]) -> Iterator[Token]:
    """The tokens with IMPLICIT wherever multiplication was left out."""
    previous: Token | None = None
    vector = ""  # the unit vector among the factors that stand side by side
    for index, token in enumerate(tokens):
        if previous is not None and _joins(previous, token):
            if token.type in _NUMERIC and previous.type in _NUMERIC:
                raise source.error(
                    "two numbers stand side by side: an operator is missing", start_of(token)
                )
            if token.type in _NUMERIC and vector:
                # ``along i 1/2`` is no vector of half the length.
                raise source.error(
                    f"a number stands behind {vector}: a sign or a comma is missing",
                    start_of(token),
                )
            gap = source.plain[end_of(previous) : start_of(token)]
            yield token_at(source, "IMPLICIT", gap, end_of(previous), start_of(token))
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
