"""The words of the language: what each is to the grammar, and which word was probably meant."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from difflib import get_close_matches

from restitution.expression.quantities import QUANTITIES
from restitution.expression.tree import FUNCTIONS, GREEK

NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
"""The name of a body, a wall or a point."""

# The names of μ, ν and ξ are products (m times u) where they stand as Latin letters.
GREEK_BY_NAME = frozenset(GREEK) - {"mu", "nu", "xi"}

GREEK_SIGNS: Mapping[str, str] = {
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "ε": "epsilon",
    "ϵ": "epsilon",
    "ζ": "zeta",
    "η": "eta",
    "θ": "theta",
    "ϑ": "theta",
    "ι": "iota",
    "κ": "kappa",
    "ϰ": "kappa",
    "λ": "lambda",
    "μ": "mu",
    "µ": "mu",
    "ν": "nu",
    "ξ": "xi",
    "ρ": "rho",
    "ϱ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "υ": "upsilon",
    "φ": "phi",
    "ϕ": "phi",
    "χ": "chi",
    "ψ": "psi",
    "ω": "omega",
}

LINE_WORDS = ("title", "sphere", "wall", "point", "let", "given", "unknown", "find", "show", "part")
EVENT_WORDS = ("hits", "receives", "reaches")
PROPERTY_WORDS = (
    "mass",
    "velocity",
    "at",
    "radius",
    "along",
    "through",
    "from",
    "circle",
    "centre",
    "offset",
)

# Words that are one token wherever they stand.
KEYWORDS: Mapping[str, str] = {
    **{word: word.upper() for word in LINE_WORDS if word not in ("title", "part")},
    **{word: word.upper() for word in EVENT_WORDS},
    **{word: word.upper() for word in PROPERTY_WORDS if word not in QUANTITIES},
    "to": "TO",
    "over": "OVER",
    "and": "AND",
    "again": "AGAIN",
    "before": "BEFORE",
}

# Words that mean something only together with others; alone they are a mistake.
FRAGMENTS = (
    "title",
    "part",
    "in",
    "of",
    "is",
    "as",
    "or",
    "if",
    "by",
    "rest",
    "terms",
    "range",
    "maximum",
    "minimum",
    "percentage",
    "perpendicular",
    "parallel",
    "opposite",
    "collide",
    "does",
    "do",
    "not",
    "will",
    "hit",
    "deg",
    "with",
    "on",
    "for",
    "the",
    "when",
    "that",
    "then",
    "lost",
    "loss",
    "half",
    "two",
    "zero",
    "only",
    "max",
    "min",
    "spin",
    "roll",
    "KE",
)

# The words that may be suggested, and those near which a run of letters is a slip.
WORDS = frozenset(
    (*LINE_WORDS, *EVENT_WORDS, *PROPERTY_WORDS, *KEYWORDS, "deg")
    + (*FUNCTIONS, *QUANTITIES, *GREEK_BY_NAME, "pi")
)

_PHRASES = (
    (r"in\s+terms\s+of", "IN_TERMS_OF"),
    (r"in\s+the\s+direction\s+of", "ALIGN"),
    (r"perpendicular\s+to", "ALIGN"),
    (r"parallel\s+to", "ALIGN"),
    (r"opposite\s+to", "ALIGN"),
    (r"do\s+not\s+collide\s+again", "COLLIDE_AGAIN"),
    (r"collide\s+again", "COLLIDE_AGAIN"),
    (r"does\s+not\s+hit", "DOES_NOT_HIT"),
    (r"will\s+not\s+hit", "WILL_HIT"),
    (r"will\s+hit", "WILL_HIT"),
    (r"(?:is\s+)?at\s+rest", "AT_REST"),
    (r"as\s+a\s+percentage", "PERCENTAGE"),
    (r"range\s+of", "RANGE_OF"),
    (r"maximum\s+of", "EXTREME_OF"),
    (r"minimum\s+of", "EXTREME_OF"),
    (r"to\s+\d{1,2}\s*(?:s\.?\s?f\.?|significant\s+figures?)", "FIGURES"),
)
PHRASES = tuple((re.compile(rf"{text}(?!\w)"), kind) for text, kind in _PHRASES)

# What people write for a word of the language.
MEANT: Mapping[str, str] = {
    "center": "centre",
    "centres": "line_of_centres",
    "line_of_centers": "line_of_centres",
    "line of centres": "line_of_centres",
    "line of centers": "line_of_centres",
    "energy lost": "energy_lost",
    "total energy lost": "total_energy_lost",
    "energy_loss": "energy_lost",
    "kinetic_energy": "energy",
    "kinetic_energy_lost": "energy_lost",
    "degree": "deg",
    "degrees": "deg",
    **dict.fromkeys(("ball", "particle", "disc", "disk", "puck", "marble"), "sphere"),
    "strikes": "hits",
    "collides": "hits",
    **dict.fromkeys(("calculate", "determine", "compute", "evaluate", "obtain"), "find"),
    **dict.fromkeys(("prove", "verify", "deduce"), "show"),
    **dict.fromkeys(("assume", "suppose", "where", "if", "when"), "given"),
    "KE": "energy",
    "loss": "energy_lost",
    "half": "1/2",
    "two": "2",
    "zero": "0",
    **dict.fromkeys(("magnitude", "mag", "modulus"), "abs"),
    "csc": "cosec",
    "range": "range of",
    "maximum": "maximum of",
    "minimum": "minimum of",
    "max": "maximum of",
    "min": "minimum of",
    "perpendicular": "perpendicular to",
    "parallel": "parallel to",
    "opposite": "opposite to",
    "collide": "collide again",
    "terms": "in terms of",
    "percentage": "as a percentage",
    "rest": "at rest",
    "stationary": "at rest",
    "arcsine": "arcsin",
    "arccosine": "arccos",
    "arctangent": "arctan",
}


def near(word: str, words: Iterable[str], cutoff: float = 0.7) -> str | None:
    """The one of ``words`` that was probably meant, or None."""
    known = list(words)
    if word.lower() in known:
        return word.lower()
    matches = get_close_matches(word, known, n=1, cutoff=cutoff)
    if not matches and word.lower() != word:
        matches = get_close_matches(word.lower(), known, n=1, cutoff=cutoff)
    return matches[0] if matches else None


def one_slip(word: str, target: str) -> bool:
    """Whether one letter left out, put in, or exchanged with its neighbour parts the two."""
    if len(word) == len(target):
        differ = [k for k in range(len(word)) if word[k] != target[k]]
        return (
            len(differ) == 2
            and differ[1] == differ[0] + 1
            and word[differ[0]] == target[differ[1]]
            and word[differ[1]] == target[differ[0]]
        )
    shorter, longer = sorted((word, target), key=len)
    return len(longer) == len(shorter) + 1 and any(
        longer[:k] + longer[k + 1 :] == shorter for k in range(len(longer))
    )


def guess(word: str) -> str | None:
    """The word of the language that was probably meant by ``word``, or None."""
    if word in MEANT:
        return MEANT[word]
    slips = [other for other in sorted(WORDS) if len(other) > 2 and one_slip(word, other)]
    return slips[0] if len(slips) == 1 else near(word, slips or sorted(WORDS))


def meant_name(name: str, names: Mapping[str, str]) -> str | None:
    """The declared name that was probably meant, or None."""
    if name.capitalize() in names:
        return name.capitalize()
    return near(name, sorted(names), cutoff=0.5)


def unknown_name(name: str, names: Mapping[str, str]) -> str:
    """What to say of a name that no line declares."""
    meant = meant_name(name, names)
    message = f"unknown name '{name}': no sphere, wall or point is called that"
    if meant is None and 0 < len(names) <= 6:
        return f"{message}; there {'is only' if len(names) == 1 else 'are'} {', '.join(names)}"
    return message + (f"; did you mean '{meant}'?" if meant else "")
