"""What sentences say of components: which stay, which a body has, and which turns back."""

from __future__ import annotations

import re

from restitution.expression.tree import Polar
from restitution.problem import Impact, Problem

_VALUE = r"(?=[-−\d√(½⅓¼⅔¾])"
_WAY = r"parallel|para?|tangential|perp(?:endicular)?|normal|along|across"
STAYS = re.compile(
    rf"(^|[,;]|\b(?:and|so)\b)\s*(?:the\s+)?({_WAY})(?:\s+(?:to\s+)?(?:the\s+)?(?:wall|cushion))?"
    r"(?:\s+(?:component|comp|cpt|part|velocity|speed))?\s+(?:still\s+)?"
    rf"(?:stays|remains|keeps|is\s+still|is\s+unchanged)(?:\s+(?:at|as))?\s+{_VALUE}",
    re.IGNORECASE,
)
HAS_ALONG = re.compile(
    r"(^|[,;]|\b(?:and|so)\b)\s*(along|across|parallel\s+to|perp(?:endicular)?\s+to)\s+"
    rf"(?:the\s+)?(line\s+of\s+centres|LOC|it)\s*,?\s*([A-Z])?\s*(?:has\s+)?{_VALUE}",
    re.IGNORECASE,
)
OF_A_BODY_ALONG = re.compile(
    r"(^|[,;]|\b(?:and|so)\b)\s*([A-Z])(?:\s*:)?\s+(?:has\s+)?(along|across|parallel\s+to|perp(?:endicular)?\s+to)"
    rf"\s+(?:the\s+)?(?:line(?:\s+of\s+centres)?|LOC)\s*[:,]?\s*{_VALUE}",
)
# ``A: 3u in the j direction``, ``B has -2 across the line of centres``
_TO_LINE = r"(?:\s+to)?\s+(?:the\s+)?(?:line(?:\s+of\s+centres)?|LOC|loc)"
HAS_A_WAY = re.compile(
    r"(^|[,;]|\b(?:and|so)\b)\s*([A-Z])\s*(?::|=|\b(?:has|keeps|still\s+has))?\s*"
    r"(?<=[\s:=])([-−]?\s?[\d√½⅓¼⅔¾][\w./√()+\-]*)\s+"
    r"(?:(?:in|along|parallel\s+to)\s+(?:the\s+)?([ij])\b(?:[-\s]*(?:direction|dirn?|axis))?"
    rf"|(along|parallel|across|perp(?:endicular)?){_TO_LINE}|(across|perp(?:endicular)?))"
    r"(?:\s+(?:too|still|unchanged|after))*(?=\s*(?:$|[,;.]|\band\b))"
)
_RELATIVE = re.compile(
    r"\brel(?:ative)?\b|\bmass\s+centre|\bcentre\s+of\s+mass|\bC(?:O?|of)M\b", re.I
)
GOES_BACK = re.compile(
    r"\b([A-Z])\s+(?:goes|moves|comes|travels|bounces|rebounds|flies)\s+(?:straight\s+)?back(?:wards)?"
    r"\s+(?:at|with)\s+(?:an?\s+)?(?:speed\s+(?:of\s+)?)?(?!angle\b)(?=[\d√(½⅓¼⅔¾a-z])"
)
KE_ALONG = re.compile(
    r"\balong\s+(?:the\s+)?(?:line(?:\s+of\s+centres)?|LOC)(?:\s+(?:only|alone))?\s*[:,]?\s*"
    r"((?:total\s+)?(?:KE|kinetic\s+energy))\s+(before|after)\b",
    re.IGNORECASE,
)

# A way in which a speed is resolved behind it: ``across the line speed of A × sin 60 = ½u``.
RESOLVED = re.compile(
    rf"((?:^|[,;]|\b(?:and|so)\b)\s*(?:{_WAY})(?:\s+to)?"
    r"(?:\s+(?:the\s+)?(?:line(?:\s+of\s+cent(?:re|er)s)?|LOC|wall|cushion|[A-Z]{1,2}))?)\s*,?\s+"
    r"(?=(?:the\s+)?speed(?:\s+of\s+[A-Z])?(?:\s+(?:before|after))?\s*[×*x.]?\s*(?:sin|cos)\b)",
    re.IGNORECASE,
)

SPEED_TIMES = re.compile(
    r"(\bspeed(?:\s+of\s+|\s+)(?:[A-Z]|[A-Z]\s+(?:before|after)|before|after))\s+(?=(?:sin|cos)\b)"
)

# A speed by the squares of its components, with no word of when.
BY_SQUARES = re.compile(
    r"^(?!.*\b(?:before|after|initial|final|first|start|original|at)\b)(.*?\bspeed(?:\s+of\s+([A-Z]))?)"
    r"(?=\s*=\s*(?:√|sqrt)\s*\()",
    re.IGNORECASE,
)

# The way of a component behind it: ``A also has 5u sin θ = 3u at right angles``.
WAY_BEHIND = re.compile(
    r"^\s*(?:and\s+|so\s+)?(?:([A-Z])\s+)?(?:also\s+|still\s+)?(?:has|keeps|had)\s+"
    r"([\d√(a-z][^:;,=]*=[^:;,=]*?)\s+"
    r"(?:at\s+right\s+angles|perp(?:endicular)?|across)"
    r"(?:\s+(?:to\s+)?(?:it|this|that|(?:the\s+)?(?:line(?:\s+of\s+cent(?:re|er)s)?|LOC|loc)))?[\s.]*$"
)


def way_behind(match: re.Match[str], problem: Problem) -> str:
    """The component across the line of centres, where there is no wall."""
    name = match[1]
    if problem.walls or name not in {*(sphere.name for sphere in problem.spheres), None}:
        return match[0]
    of = f" of {name}" if name else ""
    return f"component{of} across the line of centres = {match[2]}"


def by_squares(match: re.Match[str], problem: Problem) -> str:
    """The speed after, where that before is given: nobody works it out."""
    spheres = [x for x in problem.spheres if match[2] in (x.name, None)]
    given = [isinstance(sphere.velocity, Polar) for sphere in spheres]
    return f"{match[1]} after" if given and all(given) else match[0]


def stays(match: re.Match[str], _: Problem) -> str:
    """The component after an impact of which a sentence says that it stays."""
    return f"{match[1]} {match[2]} component after = "


def has_along(match: re.Match[str], problem: Problem) -> str:
    """The component that a sphere has along or across the line of centres.

    What is along *it* may be along a wall.
    """
    if match[3].lower() == "it" and problem.walls:
        return match[0]
    spheres = {sphere.name for sphere in problem.spheres}
    if match[4] not in {*spheres, None} or (match[4] is None and match[3].lower() != "it"):
        return match[0]
    direction = "across" if match[2].lower()[:2] in ("ac", "pe") else "along"
    of = f" of {match[4]}" if match[4] else ""
    return f"{match[1]} component{of} {direction} the line of centres = "


def of_a_body_along(match: re.Match[str], problem: Problem) -> str:
    """The component that a sphere has along or across *the line*, where there is no wall."""
    if problem.walls or match[2] not in {sphere.name for sphere in problem.spheres}:
        return match[0]
    direction = "across" if match[3].lower()[:2] in ("ac", "pe") else "along"
    return f"{match[1]} component of {match[2]} {direction} the line of centres = "


def has_a_way(match: re.Match[str], problem: Problem) -> str:
    """The component that a sphere has, of which the way stands behind the value."""
    start, name, value, axis, to_line, across = match.groups()
    if name not in {sphere.name for sphere in problem.spheres} or _RELATIVE.search(match.string):
        return match[0]
    if axis:
        return f"{start} component of {name} along {axis} = {value}"
    if problem.walls:
        return match[0]
    side = "across" if (across or to_line)[:2] in ("ac", "pe") else "along"
    return f"{start} component of {name} {side} the line of centres = {value}"


def goes_back(match: re.Match[str], problem: Problem) -> str:
    """The component of a sphere that is turned round along the line of centres.

    It is as great as the speed where nothing moves across that line.
    """
    impacts = [
        x for x in problem.events if isinstance(x, Impact) and match[1] in (x.first, x.second)
    ]
    walls = {wall.name for wall in problem.walls}
    if len(impacts) != 1 or impacts[0].second in walls:
        return match[0]
    return f"component of {match[1]} along the line of centres after = "


def energy_along(match: re.Match[str], _: Problem) -> str:
    """An energy of the components along the line of centres alone."""
    return f"KE along line of centres {match[2]}"
