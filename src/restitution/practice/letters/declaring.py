"""Meanings that a user gives in text: a letters file, or a mapping."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence

from restitution.errors import LettersError, StatementError
from restitution.expression.limits import MAX_LINE_LENGTH
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    GREEK,
    Expression,
    Name,
    Negate,
    Quantity,
    Unit,
    has_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.letters.surroundings import letters_of
from restitution.practice.reading.phrase_names import names_quantity
from restitution.practice.reading.phrases import read_phrase, words_of
from restitution.problem import Problem

MAX_LETTERS = 60
_LETTER = re.compile(
    r"(?P<base>[^\W\d_]+)(?:_?\{?(?P<below>(?<=[_{])\w+|\d+)\}?)?(?P<dashes>'{0,2})"
)
# α is alpha, by the names that Unicode has for them; its lambda is spelt another way.
_GREEK = {
    unicodedata.lookup(f"GREEK SMALL LETTER {'LAMDA' if name == 'lambda' else name.upper()}"): name
    for name in GREEK
} | {"ϕ": "phi", "ϑ": "theta", "ϵ": "epsilon"}
_CALL = re.compile(r"\b(" + "|".join(sorted(KINDS, key=len, reverse=True)) + r")\s*\(")
_OF_A_BODY = frozenset(
    word for word, kind in KINDS.items() if kind.arguments[1] == 1 and "sphere" in kind.names
)
_BODY = re.compile(r"(?<![\w'])[A-Z]\d?(?![\w'.])")
_NO_BODIES = frozenset("EIJKN")  # as units, impulses and energies have them
_FORM = "a line is a letter, a colon and its meaning, such as v: component of A along i after"


def letters_from_text(text: str, problem: Problem) -> dict[str, tuple[Expression, ...]]:
    """The meanings of a letters file: for every letter the quantities that its words may name.

    A line is ``v: component of A along i after`` or ``v = along(velocity(A), i)``; blank lines
    and what stands behind # are left out. Raises LettersError, with line and rule.
    """
    meanings: dict[str, tuple[Expression, ...]] = {}
    for number, whole in enumerate(text.splitlines(), 1):
        line = whole.partition("#")[0].rstrip()
        if not line.strip():
            continue
        letter, meaning, before = _divided(line, problem, number)
        if letter in meanings:
            raise LettersError(f"the letter {letter} has a meaning already", number, 1)
        if len(meanings) == MAX_LETTERS:
            raise LettersError(f"at most {MAX_LETTERS} letters have a meaning", number, 1)
        try:
            meanings[letter] = meaning_from_text(meaning, problem, letter)
        except StatementError as error:
            column = before + (error.column or 1)
            raise LettersError(error.message, number, column) from None
    return meanings


def letters_from_mapping(
    given: Mapping[str, str | Expression], problem: Problem
) -> dict[str, tuple[Expression, ...]]:
    """The meanings of a mapping: texts of the statement language, phrases, or trees.

    Raises StatementError that names the letter and the rule.
    """
    if len(given) > MAX_LETTERS:
        raise StatementError(f"at most {MAX_LETTERS} letters have a meaning")
    return {
        letter_from_text(letter, problem): (
            (meaning,)
            if isinstance(meaning, Expression)
            else meaning_from_text(meaning, problem, letter)
        )
        for letter, meaning in given.items()
    }


def _divided(line: str, problem: Problem, number: int) -> tuple[str, str, int]:
    """A letter, its meaning, and how many characters stand before that."""
    if len(line) > MAX_LINE_LENGTH:
        rule = f"the line is too long: at most {MAX_LINE_LENGTH} characters"
        raise LettersError(rule, number, 1)
    start = len(line) - len(line.lstrip())
    places = [place for place in (line.find(":"), line.find("=")) if place >= 0]
    if not places:
        raise LettersError(f"{line.strip()!r} has no colon: {_FORM}", number, start + 1)
    place = min(places)
    meaning = line[place + 1 :].strip()
    if not meaning:
        rule = f"the meaning of {line[:place].strip()} is missing: {_FORM}"
        raise LettersError(rule, number, place + 1)
    try:
        letter = letter_from_text(line[:place], problem)
    except StatementError as error:
        raise LettersError(error.message, number, start + 1) from None
    return letter, meaning, len(line) - len(meaning)


def letter_from_text(text: str, problem: Problem) -> str:
    """A letter by its canonical name: ``v_A`` for vA and v_{A}, ``beta`` for β.

    Raises StatementError for what is no letter.
    """
    plain = unicodedata.normalize("NFKC", text).strip()
    match = _LETTER.fullmatch(plain)
    if match is None or len(plain) > 20:
        raise StatementError(f"{plain!r} is no letter: {_FORM}")
    base, below, dashes = match["base"], match["below"] or "", match["dashes"]
    if not below and base.casefold() not in GREEK and len(base) > 1:
        rest = base[1:]
        if rest in {sphere.name for sphere in problem.spheres} or rest in ("x", "y"):
            base, below = base[0], rest
    base = _GREEK.get(base, base.casefold() if base.casefold() in GREEK else base)
    return (f"{base}_{below}" if below else base) + dashes


def meaning_from_text(text: str, problem: Problem, letter: str) -> tuple[Expression, ...]:
    """The quantities that a meaning may name, the most natural first.

    Raises StatementError, with column and rule, for what names none.
    """
    if len(text) > MAX_LINE_LENGTH:
        rule = f"the meaning of {letter} is too long: at most {MAX_LINE_LENGTH} characters"
        raise StatementError(rule)
    fault: StatementError | None = None
    try:
        tree = _expression(text, problem)
        if has_quantity(tree) or letters(tree) <= letters_of(problem):
            return (tree,)
    except StatementError as error:
        rule = f"the meaning of {letter}: {error.message}"
        fault = StatementError(rule, None, error.column)
        if _CALL.search(text):
            raise fault from None
    bodies = _bodies(problem).keys() | letters_of(problem)
    strange = [name for name in _BODY.findall(text) if name not in bodies | _NO_BODIES]
    if strange:
        rule = (
            f"the meaning of {letter}, {text!r}, names {strange[0]}, which is not in the question"
        )
        raise StatementError(rule, None, text.index(strange[0]) + 1)
    known = names_quantity(words_of(text), problem)
    meanings = read_phrase(text, problem) if known else ()
    if meanings:
        return _in_one_sense(meanings)
    if fault is not None and not re.search(r"[A-Za-z]{3}", text):
        raise fault
    rule = (
        f"the meaning of {letter}, {text!r}, names no quantity that is known here: say, for "
        "example, component of A along i after, speed of A after, angle of A to the wall after"
    )
    raise StatementError(rule)


def _in_one_sense(meanings: Sequence[Expression]) -> tuple[Expression, ...]:
    """Meanings without the opposites of those above them: along i or j there is one sense."""
    kept: list[Expression] = []
    for meaning in meanings:
        inside = unsigned(meaning)
        opposite = inside if isinstance(meaning, Negate) else Negate(meaning)
        if not (_is_along_a_unit(inside) and opposite in kept):
            kept.append(meaning)
    return tuple(kept)


def _is_along_a_unit(tree: Expression) -> bool:
    match tree:
        case Quantity("along", (_, Unit() | Negate(Unit()))):
            return True
    return False


def _bodies(problem: Problem) -> dict[str, str]:
    """What each name of the question is the name of."""
    return {
        **{sphere.name: "sphere" for sphere in problem.spheres},
        **{wall.name: "wall" for wall in problem.walls},
        **{point.name: "point" for point in problem.points},
    }


def _expression(text: str, problem: Problem) -> Expression:
    from restitution.expression.reading import read_expression

    names = _bodies(problem)
    tree = read_expression(text, names=names)
    for node in walk(tree):
        if isinstance(node, Quantity) and node.kind in _OF_A_BODY and node.arguments:
            body = node.arguments[0]
            if not isinstance(body, Name) or body.name not in names:
                rule = f"{node.kind}(…) needs the name of a sphere of the question"
                raise StatementError(rule)
    return tree
