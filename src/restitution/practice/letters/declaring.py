"""Meanings that a user gives in text: a letters file, or a mapping."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence

from restitution.errors import StatementError
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
_FORM = "a line is a letter, a colon and its meaning, such as v: component of A along i after"


def letters_from_text(text: str, problem: Problem) -> dict[str, tuple[Expression, ...]]:
    """The meanings of a letters file: for every letter the quantities that its words may name.

    A line is ``v: component of A along i after`` or ``v = along(velocity(A), i)``; blank lines
    and what stands behind # are left out. Raises StatementError, with line and rule.
    """
    meanings: dict[str, tuple[Expression, ...]] = {}
    for number, whole in enumerate(text.splitlines(), 1):
        line = whole.partition("#")[0].strip()
        if not line:
            continue
        letter, meaning = _divided(line, problem, number)
        if letter in meanings:
            raise StatementError(f"the letter {letter} has a meaning already", number, 1)
        if len(meanings) == MAX_LETTERS:
            raise StatementError(f"at most {MAX_LETTERS} letters have a meaning", number, 1)
        meanings[letter] = meaning_from_text(meaning, problem, number, letter)
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
            else meaning_from_text(meaning, problem, None, letter)
        )
        for letter, meaning in given.items()
    }


def _divided(line: str, problem: Problem, number: int) -> tuple[str, str]:
    if len(line) > MAX_LINE_LENGTH:
        rule = f"the line is too long: at most {MAX_LINE_LENGTH} characters"
        raise StatementError(rule, number, 1)
    places = [place for place in (line.find(":"), line.find("=")) if place >= 0]
    if not places:
        raise StatementError(f"{line!r} has no colon: {_FORM}", number, 1)
    place = min(places)
    meaning = line[place + 1 :].strip()
    if not meaning:
        raise StatementError(f"the meaning of {line[:place].strip()} is missing: {_FORM}", number)
    return letter_from_text(line[:place], problem, number), meaning


def letter_from_text(text: str, problem: Problem, number: int | None = None) -> str:
    """A letter by its canonical name: ``v_A`` for vA and v_{A}, ``beta`` for β.

    Raises StatementError for what is no letter.
    """
    plain = unicodedata.normalize("NFKC", text).strip()
    match = _LETTER.fullmatch(plain)
    if match is None or len(plain) > 20:
        raise StatementError(f"{plain!r} is no letter: {_FORM}", number, 1 if number else None)
    base, below, dashes = match["base"], match["below"] or "", match["dashes"]
    if not below and base.casefold() not in GREEK and len(base) > 1:
        rest = base[1:]
        if rest in {sphere.name for sphere in problem.spheres} or rest in ("x", "y"):
            base, below = base[0], rest
    base = _GREEK.get(base, base.casefold() if base.casefold() in GREEK else base)
    return (f"{base}_{below}" if below else base) + dashes


def meaning_from_text(
    text: str, problem: Problem, number: int | None, letter: str
) -> tuple[Expression, ...]:
    """The quantities that a meaning may name, the most natural first.

    Raises StatementError, with line and rule, for what names none.
    """
    if len(text) > MAX_LINE_LENGTH:
        rule = f"the meaning of {letter} is too long: at most {MAX_LINE_LENGTH} characters"
        raise StatementError(rule, number)
    fault: StatementError | None = None
    try:
        tree = _expression(text, problem, number)
        if has_quantity(tree) or letters(tree) <= letters_of(problem):
            return (tree,)
    except StatementError as error:
        if _CALL.search(text):
            raise
        fault = error
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
    raise StatementError(rule, number)


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


def _expression(text: str, problem: Problem, number: int | None) -> Expression:
    from restitution.expression.reading import read_expression

    names = {
        **{sphere.name: "sphere" for sphere in problem.spheres},
        **{wall.name: "wall" for wall in problem.walls},
        **{point.name: "point" for point in problem.points},
    }
    tree = read_expression(text, names=names, line=number or 1)
    for node in walk(tree):
        if isinstance(node, Quantity) and node.kind in _OF_A_BODY and node.arguments:
            body = node.arguments[0]
            if not isinstance(body, Name) or body.name not in names:
                rule = f"{node.kind}(…) needs the name of a sphere of the question"
                raise StatementError(rule, number)
    return tree
