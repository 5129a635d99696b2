"""How a question and a script use their letters, found before any line is read."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import chain

from restitution.expression.tree import (
    GREEK,
    Apply,
    Expression,
    Letter,
    Polar,
    letters,
    walk,
)
from restitution.expression.words import GREEK_SIGNS
from restitution.practice.reading.angles import is_angle
from restitution.practice.reading.tokens import Usage
from restitution.practice.reading.vocabulary import PHRASE_WORDS, PROSE
from restitution.problem import Impact, Let, Problem, trees

_TRIGONOMETRIC = ("sin", "cos", "tan", "cot", "sec", "cosec")
_NO_ANGLES = frozenset(
    ("lambda", "mu", "rho", "epsilon", "eta", "nu", "xi", "kappa", "tau", "sigma", "pi", "chi")
)
GREEK_ANGLES = frozenset(GREEK) - _NO_ANGLES
_RUN = re.compile(r"[A-Za-z]+")
_COUNTED = re.compile(r"([A-Za-z])(?:_\s?\{?)?1(?![\d.])")
_ALONE = re.compile(r"(?<![A-Za-z_])([A-Za-z])(?![A-Za-z_0-9'])")
_IN_FUNCTION = re.compile(
    r"(?:sin|cos|tan|cot|sec)(?: *\^? *(?:\(?- ?1\)?|[23]))? *\(? *\d* *([A-Za-z])(?!rc)"
)
# An x that can only be a letter: beside a relation, an operation, a power, or at an end.
_LETTER_X = re.compile(
    r"(?:^|[=+\-/^(<>,]|\blet\b|\b(?:sin|cos|tan))\s*x(?![A-Za-z-])(?!\s*(?:comp|dir|axis|:))"
    r"|(?<![A-Za-z])x\s*(?:[=+/^)<>,]|-\s|_|'|²|$)|\dx\s*(?:[=+/^)<>,]|-\s|$)",
    re.IGNORECASE,
)
# A J that can only be a letter, and no unit.
_JOULES = re.compile(r"(?:^|[=;,(:]|so|let|=>)\s*-?J\s*[=/]|=\s*J\s*$", re.MULTILINE)
_VECTOR = re.compile(
    r"(?<![\w'])([A-Za-z])(?:_?(\w))?\s*=\s*[^=<>|·.]*(?<![A-Za-z])\d*[ij](?![A-Za-z])"
)
_AT_AN_ANGLE = re.compile(
    r"(?:sin|cos|tan)\s*(?:\^?\s*\d|[²³])?\s*\(?\s*\d*\s*@|^\s*@\s*=", re.IGNORECASE
)
# The same with a pair of components: ``n = (3, 4)/5``, ``v = 5(0.6, 0.8)``.
_PAIR = re.compile(
    r"(?<![\w'])([A-Za-z])(?:_?(\w))?\s*=\s*(?:[\d./]*\s*\*?\s*|-\s*)[(\[][^(),=\[\]]+,[^(),=\[\]]+[)\]]"
    r"(?!\s*[.·(\[*])"
)
_LATIN_FOR = {
    "a": "alpha",
    "b": "beta",
    "B": "beta",
    "d": "delta",
    "p": "phi",
    "g": "gamma",
    "th": "theta",
    "o": "theta",
}

# Between these a letter is a unit: time = 4 s, and 1 m from W.
_BEFORE_A_UNIT = re.compile(r"\d\s+$")
# Metres a second, which are no letters: ``at 6 m/s:``, ``4ms^-1``.
_SPEED_UNIT = re.compile(r"(?<=\d)\s*m\s?(?:/\s?s\b|s\s?\^?\(?-1\)?)")
_BEFORE_METRES = re.compile(r"(?:^|[=:,]|[a-z]{2} )[\s\d.+*×()-]*\d\s*$")
_BEFORE_GLUED = re.compile(r"\d\)?\s*$")
_BEHIND_A_UNIT = re.compile(r"$|[,;=)]|\.(?:\s|$)|[A-Za-z]{2,}")


def usage_of(lines: Sequence[str], problem: Problem) -> Usage:
    """How the lines of a script (in plain characters) and its question use their letters."""
    of_question = letters_of_question(problem)
    text = "\n".join(lines)
    runs = _RUN.findall(text)
    numeric = all(sphere.mass and not letters(sphere.mass) for sphere in problem.spheres)
    metres = numeric or all(sphere.mass is None and sphere.position for sphere in problem.spheres)
    alone = _alone(lines, metres)
    trigonometric = set(_in_functions(text))
    greek = {GREEK_SIGNS[sign] for sign in text if sign in GREEK_SIGNS}
    greek |= {
        letter for letter in GREEK if any(letter in run.lower() for run in runs if len(letter) > 2)
    }
    spheres = frozenset(sphere.name for sphere in problem.spheres)
    aliases = _aliases(of_question | greek, of_question, trigonometric, alone, text)
    aliases |= _subscripts(spheres, of_question | (alone - trigonometric), runs)
    angles = GREEK_ANGLES | _angles(problem) | (trigonometric - spheres - set("uvwme"))
    return Usage(
        spheres=spheres,
        walls=frozenset(wall.name for wall in problem.walls),
        points=frozenset(point.name for point in problem.points),
        letters=of_question,
        angles=frozenset(angles),
        vectors=frozenset(_vectors(text, spheres)),
        alone=frozenset(alone),
        aliases=aliases,
        counted=frozenset(_COUNTED.findall(text)),
        times=not ("x" in of_question or _uses_x(lines)),
        joules=bool(_JOULES.search(text)),
        metres=metres,
        squares=_squares(text, of_question | alone),
        powers=bool(re.search(r"(?:sin|cos)2.*\+.*(?:sin|cos)2", text)),
    )


def with_angles(lines: Sequence[str], problem: Problem) -> list[str]:
    """The lines with the sign of an angle for an @ that stands for one: ``cos@``, ``@ = 30``."""
    if not any(_AT_AN_ANGLE.search(line) for line in lines):
        return list(lines)
    angles = GREEK_ANGLES & letters_of_question(problem)
    signs = [sign for sign, name in GREEK_SIGNS.items() if name in angles]
    sign = signs[0] if len(signs) == 1 else "θ"
    return [line.replace("@", sign) for line in lines]


def _vectors(text: str, spheres: frozenset[str]) -> Iterator[str]:
    """The letters that the script equates with vectors: ``n = (3i + 4j)/5``, ``vA = 3i``."""
    for match in chain(_VECTOR.finditer(text), _PAIR.finditer(text)):
        if (
            match[2]
            and not match[0][1:].startswith("_")
            and not (match[2].isdigit() or match[2] in spheres)
        ):
            continue
        yield f"{match[1]}_{match[2]}" if match[2] else match[1]


def _squares(text: str, letters: frozenset[str] | set[str]) -> frozenset[str]:
    """The letters of which a 2 behind is a power: ``1/2mv2`` where there is no ``v1``."""
    typed = {match[1] for match in re.finditer(r"([A-Za-z])_?[13]", text)}
    return frozenset(set("uvwVUWxyt") & letters - typed)


def letters_of_question(problem: Problem) -> frozenset[str]:
    """The letters of a question, e of an impact without a number among them."""
    names: set[str] = set()
    for tree in trees(problem):
        names |= letters(tree)
    for _, step in problem.steps():
        if isinstance(step, Let):
            names.add(step.letter)
        elif isinstance(step, Impact) and step.e is None:
            names.add("e")
    return frozenset(names)


def _angles(problem: Problem) -> set[str]:
    """The letters of the question that are angles."""
    angles: set[str] = set()
    for tree in trees(problem):
        for node in walk(tree):
            angles |= _angle_letters(node)
    for _, step in problem.steps():
        if isinstance(step, Let) and is_angle(step.expression, frozenset()):
            angles.add(step.letter)
    return angles


def _angle_letters(node: Expression) -> set[str]:
    if isinstance(node, Apply) and node.function in _TRIGONOMETRIC:
        return {tree.name for tree in walk(node.argument) if isinstance(tree, Letter)}
    if isinstance(node, Polar):
        return {tree.name for tree in walk(node.angle) if isinstance(tree, Letter)}
    return set()


def _alone(lines: Sequence[str], metres: bool) -> set[str]:
    """The Latin letters that stand alone in lines, and are no units.

    ``metres`` tells that an m directly behind a number may be one.
    """
    glued = {"m": _BEFORE_METRES if metres else _BEFORE_A_UNIT, "s": _BEFORE_GLUED}
    alone: set[str] = set()
    for line in lines:
        for match in _ALONE.finditer(_SPEED_UNIT.sub(lambda unit: " " * len(unit[0]), line)):
            behind = line[match.end() :].lstrip()
            word = re.match(r"[A-Za-z]{3,}", behind)
            if match[1] in "aI" and word and word[0].lower() in PROSE | PHRASE_WORDS:
                continue
            before = glued.get(match[1])
            measures = before is not None and before.search(line[: match.start(1)])
            if measures and _BEHIND_A_UNIT.match(behind):
                continue  # t = 4 s
            alone.add(match[1])
    return alone - {"x", "X"}


def _in_functions(text: str) -> Iterator[str]:
    """The letters that stand inside a sine, cosine or tangent."""
    for match in _IN_FUNCTION.finditer(text):
        start = match.start()
        while start and text[start - 1].isalpha() and text[start - 1].isascii():
            start -= 1
        run = _RUN.match(text, start)
        if run and run[0].lower() in PROSE | PHRASE_WORDS:
            continue
        rest = _RUN.match(text, match.start(1))
        if rest and any(
            rest[0].lower().startswith(function) for function in ("sin", "cos", "tan", *GREEK)
        ):
            continue
        yield match[1]


def _uses_x(lines: Sequence[str]) -> bool:
    """Whether an x of the script can only be a letter."""
    return any(_LETTER_X.search(_without_labels(line)) for line in lines)


def _without_labels(line: str) -> str:
    return re.sub(r"\bx[\s-]*(?:comp\w*|dir\w*|axis)|^\s*x\s*:|~~.*?~~", " ", line, flags=re.I)


def _aliases(
    greek: frozenset[str] | set[str],
    of_question: frozenset[str],
    trigonometric: set[str],
    alone: set[str],
    text: str,
) -> dict[str, str]:
    """Latin letters that stand for the Greek ones of the question: ``usina`` for u sin α."""
    aliases: dict[str, str] = {}
    for latin, name in _LATIN_FOR.items():
        if name not in greek or latin in of_question or len(latin) > 1:
            continue
        if latin in trigonometric:
            aliases[latin] = name
    return aliases


def _subscripts(
    spheres: frozenset[str], letters: frozenset[str], runs: Sequence[str]
) -> dict[str, str]:
    """``va`` and ``vb`` where A and B are spheres, and no product of two letters is meant."""
    small = {sphere.lower(): sphere for sphere in spheres if len(sphere) == 1}
    pairs = [run for run in runs if len(run) == 2 and run[0] in "uvwmUV" and run[1] in small]
    of_both = len({run[1] for run in pairs}) > 1
    if any({*run} <= letters for run in pairs) or not of_both:
        return {}
    return {run: f"{run[0]}_{small[run[1]]}" for run in pairs}
