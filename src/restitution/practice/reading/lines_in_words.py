"""The line of centres as a label, of sentences that say which way it goes."""

from __future__ import annotations

import re

from restitution.problem import Impact, Problem

_NUMBER = r"[\d./√½⅓⅔¼¾]*"
_VECTOR = rf"\(?\s*[-−]?\s*{_NUMBER}\s*i\s*[-+−]\s*{_NUMBER}\s*j\b"
# ``line of centres is parallel to -i + 2j``; what is perpendicular to it is no value of it.
LINE_OF_CENTRES = re.compile(
    r"\b(?:the\s+)?(?:line\s+of\s+(?:the\s+)?cent(?:re|er)s|l\.?o\.?c\.?)\s*"
    r"(?:(?:is|has|lies|goes|must\s+be|,|so)\s*)?"
    r"(?:(?:in|has|of)\s+)?(?:the\s+|a\s+)?"
    r"(?:parallel(?:\s+to|\s+with)?|∥|//|\|\||along|direction(?:\s+(?:of|is|vector))?)"
    rf"\s*(?:the\s+)?(?:vector\s+)?[:=]?\s*(?={_VECTOR})",
    re.IGNORECASE,
)

_ONE = r"\b(?:the\s+|a\s+)?unit\s+vec(?:tor)?\s*"
_IS = r"\s*(?:is\s*|=\s*|:\s*)(?=[-−]?\s*[\d(½⅓⅔¼¾√][^=]*[ij]\b)"
# ``unit vector along the impulse = (3i + 4j)/5``; spheres are smooth, it is that of their line.
UNIT_ALONG_IMPULSE = re.compile(
    rf"{_ONE}(?:along|parallel\s+to|in\s+(?:the\s+)?direction\s+of|of|∥)\s*"
    rf"(?:the\s+)?(?:impulse|I|J)(?:\s+on\s+[A-Z])?{_IS}"
)
# Of which line a unit vector is, is not said: its value stands by itself.
UNIT_ALONE = re.compile(rf"{_ONE}{_IS}", re.IGNORECASE)


def line_of_centres(match: re.Match[str], problem: Problem) -> str:
    """The label of the only line of centres of two spheres."""
    walls = {wall.name for wall in problem.walls}
    impacts = [step for _, step in problem.steps() if isinstance(step, Impact)]
    between = [impact for impact in impacts if impact.second not in walls]
    return "direction of line of centres: " if len(between) == 1 else match[0]
