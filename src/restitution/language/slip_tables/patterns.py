"""What the tables of slips are made of: cures, and patterns that several of them share."""

from __future__ import annotations

from restitution.records import dataclass


@dataclass(frozen=True)
class Cure:
    """What to say of a slip, and what to write for its ``x``; both may name groups of the pattern.

    ``tight`` takes the place of the blanks before it too. ``of`` is the group that is written anew.
    ``more`` is what else may be meant; ``{sphere}`` in ``text`` is each of the spheres in turn, or
    all of them ``together``.
    """

    message: str
    text: str
    tight: bool = False
    of: str = "x"
    more: tuple[str, ...] = ()
    together: bool = False


Slip = tuple[str, str, Cure | str]
"""The first words of its lines (any, where there is none), a pattern, and what to say: with a cure
where that is certain."""


def meant(text: str, more: str = "") -> Cure:
    """A cure by one text, which is offered with its ``more`` behind it."""
    return Cure(f"did you mean '{text}'?{more}", text)


def either(*texts: str) -> Cure:
    """A cure by any of these texts."""
    listed = " or ".join(f"'{text}'" for text in texts)
    return Cure(f"did you mean {listed}?", texts[0], more=texts[1:])


CUT = Cure("leave out '{x}'", "")

NAME = r"[A-Z][A-Za-z0-9]*"

BODY = rf"(?:the\s+)?(?:(?:sphere|ball|particle|wall)\s+)?(?P<body>{NAME})\b"

KINETIC = r"(?:kinetic\s+energy|KE|K\.E\.|energy)"

LOST = r"(?:(?:that|which)\s+)?(?:(?:is|was|has\s+been)\s+)?(?:lost|loss)\b"

BODY_LINES = "sphere wall"

ASKING_LINES = "find show given let"

STOPS = r"(?:rests|stops|comes\s+to\s+rest|is\s+brought\s+to\s+rest)\b"

NAMES = rf"{NAME}(?:\s*(?:,|&|\band\b)\s*{NAME})*"

BALL = r"(?:spheres?|balls?|particles?|disc?s?|disks?|pucks?|marbles?)"

MANY = (
    r"(?:(?:let|there\s+(?:is|are)|the|[Aa]n?|another|[Tt]wo|[Tt]hree|smooth|uniform|small|identical"
    r"|equal|solid|fixed|vertical|straight)\s+)*"
)

RESTITUTION = r"coefficient\s+of\s+restitution(?:\s+between\s+\w+\s+and\s+\w+)?"

AFTER = (
    r"(?:\s+(?:immediately\s+|just\s+)?after(?:wards)?\b(?!\s+(?:each|every|both|all)\b)"
    r"(?:\s+\w+){0,3})"
)

# A size that is a number or a letter, perhaps with its unit; and what stands before a direction.
SIZE = (
    r"(?P<v>\d[\d.]*(?:/\d+)?(?:\s?[a-z](?![\w/]|\s+s))?|[a-z](?:_?\d)?)"
    r"(?:\s*(?P<unit>m\s*/\s*s|m\s?s\s?\^?-1|ms⁻¹|m\s?s⁻¹|N\s?s))?"
)

ALONG = (
    r"(?:along|in\s+(?:the\s+)?(?:same\s+)?(?:positive\s+)?direction(?:\s+of)?)(?:\s+the)?"
    r"(?:\s+(?:vector|direction(?:\s+of)?))?"
)

# A wall or a ball is struck in many words.
STRIKES = (
    r"(?:(?:then|now|next)\s+)?(?:(?:directly|obliquely|also)\s+)?"
    r"(?:collides?\s+(?:(?:directly|obliquely)\s+)?(?:with|into)|collides?|strikes?|struck|hit"
    r"|impacts?(?:\s+(?:on|with))?|bumps?\s+into|(?:bounces?|rebounds?)\s+(?:off|on|against|from)"
    r"|meets?|impinges?\s+on|hits\s+(?:into|against|with|on))"
)

# What a fact gives of the motion, and its value up to a comma outside brackets.
OF_MOTION = rf"(?:impulse|energy_lost|(?:impulse|velocity|speed|energy|deflection)\({NAME}\))"
VALUE = r"(?:\([^()]*\)|[^(),=])+"
