"""Runs of letters: whether one is a product, and of which letters, functions and Greek names."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.words import GREEK_BY_NAME
from restitution.practice.reading.tokens import Usage
from restitution.practice.reading.vocabulary import FUNCTION_NAMES

_GREEK = tuple(sorted((*GREEK_BY_NAME, "lamda"), key=len, reverse=True))
# Quantities that people write with one Latin letter.
_USUAL = frozenset("muvweVUWMxyzktpqrsnfghIJTEFPRSdcabRlX")
_FUNCTIONS = tuple(
    sorted(
        (name for name in FUNCTION_NAMES if name not in ("rt", "mod", "sine", "tangent", "cosine")),
        key=len,
        reverse=True,
    )
)
# Only at the beginning of a run: ``tanAtanB`` has no arctan in it.
_SHORT_INVERSES = ("asin", "acos", "atan")


def is_mathematical(run: str, usage: Usage) -> bool:
    """Whether a run of letters is a product, as far as its letters can tell."""
    pieces = list(_pieces(run, usage))
    singles = [text for kind, text in pieces if kind == "letter"]
    functions = any(kind in ("function", "greek") for kind, _ in pieces)
    known = usage.letters | usage.alone | usage.spheres
    known = known | {"m", "u", "v", "w", "e", "i", "j"}
    if functions:
        longest = max((len(part) for part in _stretches(pieces)), default=0)
        return longest <= 5 and (len(singles) <= 4 or all(single in known for single in singles))
    if len(run) == 2 and run[1] in usage.spheres and run[0] in "uvwmUVWMIEJ":
        return True
    if len(run) == 2 and run.isupper() and run[1] in usage.spheres:
        return False  # a line OA
    if len(run) <= 3:
        return all(single in known or single in _USUAL for single in singles)
    return len(run) <= 6 and all(single in known for single in singles)


def _pieces(run: str, usage: Usage) -> Iterator[tuple[str, str]]:
    offset = 0
    while offset < len(run):
        kind, text = piece(run, offset, usage)
        yield kind, text
        offset += len(text)


def piece(run: str, offset: int, usage: Usage, behind: str = "") -> tuple[str, str]:
    """The piece of a run at an offset: its kind (function, greek, pi, letter) and its text.

    ``behind`` is what stands behind the run: ``3atan(θ)`` has no arctan where a is a letter of
    the question, as ``atan(3/4)`` has.
    """
    low = run[offset:].lower()
    for name in _FUNCTIONS:
        short = name in _SHORT_INVERSES and low.startswith(name)
        if short and run[offset] in usage.letters:
            inside = run[offset + len(name) :] or behind.lstrip(" (")
            degrees = name != "atan" and inside[:2].isdigit()  # of 60 there is no arccos
            short = offset > 0 or not (inside[:1].isalpha() or degrees)
            if not short:
                continue
        if low.startswith(name) and not (offset and name in _SHORT_INVERSES):
            return "function", run[offset : offset + len(name)]
    for name in _GREEK:
        if low.startswith(name) and not (name == "eta" and low[3:4] == "n"):
            return "greek", run[offset : offset + len(name)]
    if low.startswith("mu") and "mu" in usage.letters and "u" not in usage.letters:
        return "greek", run[offset : offset + 2]
    own = "p" in usage.alone and behind.lstrip()[:1] in ("+", "-") and run == "pi"
    if low.startswith("pi") and len(run) == 2 and "p" not in usage.letters and not own:
        return "pi", run[offset : offset + 2]
    return "letter", run[offset]


def _stretches(pieces: list[tuple[str, str]]) -> Iterator[str]:
    """The stretches of single letters between functions and Greek letters."""
    stretch = ""
    for kind, text in pieces:
        if kind == "letter":
            stretch += text
        else:
            yield stretch
            stretch = ""
    yield stretch
