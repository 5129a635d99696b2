"""Words that go back to a value of their line: ``¾ of it = 2.52``, ``= 4.95 - doesn't change``."""

from __future__ import annotations

import re
from fractions import Fraction

from restitution.practice.reading.shares import SHARES_IN_WORDS
from restitution.problem import Problem

_IN_WORDS = "|".join(words.replace(" ", r"\s+") for words in SHARES_IN_WORDS)
_NUMBER = r"\d*\.\d+|\d+"
# A share of the value before it, worked out.
SHARE_OF_IT = re.compile(
    rf"(?<![\w.])(?:(?:an?|one)\s+)?({_IN_WORDS}|\(?(?:{_NUMBER})(?:\s*/\s*\d+)?\)?)"
    rf"\s+of\s+(?:it|this|that|them)\s*(?:=|is\b)\s*(?={_NUMBER})",
    re.IGNORECASE,
)
# A remark behind a dash that the value before it stays as it is.
STAYS_BEHIND = re.compile(
    r"(?<=[\w)])\s+-+\s*(?:(?:so\s+|and\s+)?(?:it|this|which|they)\s+)?(?:"
    r"(?:does\s?n['o]?t|do\s?n['o]?t|does\s+not|do\s+not|will\s+not|won't|never)\s+change|(?:is|are)?\s*unchanged"
    r"|(?:stays?|remains?|is|are|keeps?)\s+(?:the\s+same|constant|as\s+(?:it\s+is|before)|like\s+that)"
    r"|no\s+change|same\s+(?:as\s+before|after|before\s+and\s+after)|not\s+(?:changed|affected))[\s.]*$",
    re.IGNORECASE,
)
# What stays is that after as well, whatever moment a heading names.
BEFORE_A_STAY = re.compile(
    r"^(\s*)(?:just\s+)?before\s+(?=[^:=]+:)(?=.*[,(]\s*(?:unchanged|does\s?n['o]?t\s+change|stays\s+the\s+same)\)?[\s.]*$)",
    re.IGNORECASE,
)
_LAST_NUMBER = re.compile(rf"(?<![\w.])({_NUMBER})(?!.*\d)")
_AS_ROUNDED = 0.02


def share_of_it(match: re.Match[str], _: Problem) -> str:
    """The share of the value before it as a product; nothing where it is of another value."""
    before = _LAST_NUMBER.search(match.string[: match.start()])
    worked = re.match(rf"(?:{_NUMBER})", match.string[match.end() :])
    share = SHARES_IN_WORDS.get(re.sub(r"\s+", " ", match[1].lower()), match[1])
    if before is None or worked is None:
        return ""
    size = Fraction(re.sub(r"[()\s]", "", share)) if "/" not in share else _ratio(share)
    value, stated = float(size * Fraction(before[1])), float(Fraction(worked[0]))
    close = abs(value - stated) <= _AS_ROUNDED * abs(value)
    return f"{share} * {before[1]} = " if close else ""


def _ratio(text: str) -> Fraction:
    above, below = re.sub(r"[()\s]", "", text).split("/")
    return Fraction(above) / Fraction(below)
