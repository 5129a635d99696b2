"""The words of the language as the editor and its help need them, each with what it means.

Which words there are is the language's business: the tables here are read by its own, so a word
that it gains and that is not described here stops the application at its start.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from restitution.expression.quantities import KINDS, Kind
from restitution.expression.tree import FUNCTIONS, Name, Quantity
from restitution.expression.words import (
    EVENT_WORDS,
    GREEK_BY_NAME,
    GREEK_SIGNS,
    KEYWORDS,
    LINE_WORDS,
)
from restitution.expression.writing import write_expression

# What each line says, how one begins, and an example.
_LINES: Mapping[str, tuple[str, str, str]] = {
    "title": ("a name for people", "title ", "title Two spheres collide"),
    "sphere": (
        "a smooth sphere: mass, velocity or at rest, at (x, y), radius",
        "sphere A: velocity ",
        "sphere A: mass 2, velocity 3i - 4j",
    ),
    "wall": (
        "a smooth wall: along a vector or an angle, or from a point to another",
        "wall W: along ",
        "wall W: along 60°",
    ),
    "point": ("a named point", "point O: (", "point O: (2a, a)"),
    "let": ("a letter for a quantity", "let ", "let beta = angle(velocity(P), W)"),
    "given": ("facts", "given ", "given tan(alpha) = 3/4, e < 1"),
    "unknown": ("letters that are neither given nor asked for", "unknown ", "unknown u, v"),
    "find": ("what is asked for", "find ", "find speed(P), energy_lost"),
    "show": ("a result to be shown", "show ", "show speed(P) = sqrt(7)/4 u"),
    "part": ("a part of the question begins", "part ", "part a"),
}

_EVENTS: Mapping[str, tuple[str, str]] = {
    "hits": ("an impact with a sphere or a wall", "A hits B: along j, e = 3/7"),
    "receives": ("an impulse from outside", "P receives 4i + 6j"),
    "reaches": ("its centre comes to a point or a wall", "P reaches (3, 2)"),
}

_PROPERTIES: Mapping[str, Mapping[str, str]] = {
    "sphere": {
        "velocity": "a vector, such as 3i - 4j or u at 60° to W",
        "mass": "its mass",
        "at rest": "it does not move at first",
        "at": "where its centre is at first: (x, y)",
        "radius": "its radius; negligible if left out",
    },
    "wall": {
        "along": "its direction: a vector or an angle",
        "through": "a point of it: (x, y)",
        "from": "a segment: from (x, y) to (x, y)",
        "circle centre": "a round wall: circle centre (x, y) radius a",
        "radius": "of a round wall",
    },
    "hits": {
        "e": "the coefficient of restitution: e = 3/7",
        "along": "the line of centres: a vector or an angle",
        "offset": "how far B's centre lies from A's path, to the left",
    },
}

_FUNCTIONS: Mapping[str, str] = {
    "sqrt": "square root",
    "abs": "size of a number or a vector",
    "sin": "sine",
    "cos": "cosine",
    "tan": "tangent",
    "cot": "cotangent",
    "sec": "secant",
    "cosec": "cosecant",
    "arcsin": "inverse sine",
    "arccos": "inverse cosine",
    "arctan": "inverse tangent",
}

# Phrases, by the kinds of line in which they stand.
_PHRASES: Iterable[tuple[str, str, str]] = (
    ("find", "range of", "all values that the facts allow"),
    ("find", "maximum of", "the greatest value: maximum of Q over x"),
    ("find", "minimum of", "the least value: minimum of Q over x"),
    ("find show", "in terms of", "letters that the answer may have"),
    ("find", "as a percentage", "after what is asked for"),
    ("given show", "perpendicular to", "two directions at right angles"),
    ("given show", "parallel to", "two directions, in either sense"),
    ("given show", "in the direction of", "two directions, in the same sense"),
    ("given show", "opposite to", "two directions, in opposite senses"),
    ("given show", "at rest", "A at rest"),
    ("given show", "collide again", "A and B collide again"),
    ("given show", "will hit", "A will hit W"),
)

_EXPRESSIONS = (
    ("3/7, 0.6, 60%", "numbers, which are exact; no units are typed"),
    ("60° or 60 deg", "an angle; without a sign it is in radians"),
    ("3i - 4j or (3, -4)", "a vector by its components"),
    ("5 at 60°", "a vector by its size and its angle from i"),
    ("u at 45° from -i", "a vector at an angle from any other"),
    ("u at alpha to W", "a vector towards the wall W, at an angle to it"),
    ("3m u, sqrt(7)/4 u, u^2", "multiplication may be left out"),
    ("alpha or α, u_1, v_A", "letters: one character, perhaps with a subscript"),
    ("speed(P, 0), speed(P, 1)", "at the start, just after event 1"),
    ("speed(P, before)", "just before the latest event of P"),
    ("# words", "a comment"),
)


def vocabulary() -> dict[str, Any]:
    """All words by their kinds, as JSON takes them: ``word``, ``about``, and how it is used."""
    greek: dict[str, str] = {}
    for sign, name in GREEK_SIGNS.items():
        if name in GREEK_BY_NAME:
            greek.setdefault(name, sign)
    return {
        "lines": [_line(word) for word in LINE_WORDS],
        "events": [
            {"word": word, "about": _EVENTS[word][0], "example": _EVENTS[word][1]}
            for word in EVENT_WORDS
        ],
        "properties": {
            kind: [{"word": word, "about": about} for word, about in described.items()]
            for kind, described in _PROPERTIES.items()
        },
        "quantities": [
            {
                "word": kind.word,
                "about": kind.about,
                "usage": kind.usage,
                "alone": kind.stands_alone,
            }
            for kind in KINDS.values()
            if kind.in_statements
        ],
        "offered": [_offered(kind) for kind in KINDS.values() if _is_of_bodies(kind)],
        "functions": [{"word": word, "about": _FUNCTIONS[word]} for word in FUNCTIONS],
        "phrases": [
            {"word": word, "about": about, "lines": lines.split()}
            for lines, word, about in _PHRASES
        ],
        "greek": greek,
        "keywords": sorted(KEYWORDS),
        "expressions": [{"example": example, "about": about} for example, about in _EXPRESSIONS],
    }


# What a form puts in for: names of bodies, and the events before and after which they are meant.
_BODIES, _EARLY, _LATE = ("ONE", "OTHER"), 10**6 - 1, 10**6


def _is_of_bodies(kind: Kind) -> bool:
    """Whether a form can offer a quantity by its record: of bodies, after an event or in one."""
    named = kind.definition is None or bool(kind.noun)
    of_spheres = kind.names == {"sphere"} and kind.arguments[1] > 0
    return kind.in_statements and kind.staged and named and of_spheres and not kind.at_time


def _offered(kind: Kind) -> dict[str, Any]:
    """A quantity as a form offers it; ``key`` is what it is, with all stages told."""
    bodies = tuple(Name(name) for name in _BODIES[: kind.arguments[1]])
    defined = kind.written_out(bodies, _LATE, _LATE)
    key = write_expression(defined or Quantity(kind.word, bodies, _LATE))
    return {
        "word": kind.word,
        "noun": kind.in_formulas,
        "bodies": len(bodies),
        "key": key.replace(str(_EARLY), "EARLY").replace(str(_LATE), "LATE"),
        "vector": kind.nature == "vector",
        "angle": kind.nature == "angle",
        "in_event": kind.of_an_event,
    }


def _line(word: str) -> dict[str, str]:
    about, begin, example = _LINES[word]
    return {"word": word, "about": about, "begin": begin, "example": example}
