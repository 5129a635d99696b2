"""Velocities of the mass centre, and relative to it, as labels: ``mass centre moves with 3.6``."""

from __future__ import annotations

import re

from restitution.problem import Problem

_CENTRE = (
    r"(?:the\s+)?(?:cent(?:re|er)\s+of\s+mass|mass\s+cent(?:re|er)|(?:CM|CoM|c\.?o\.?m\.)(?!\w))"
)
_VALUE = r"(?:[-−]?\s?[\d./√½⅓⅔¼¾]+[a-z]?)"
_BODY = r"(?:v_?|u_?)?([A-Z])"
OF_BOTH = re.compile(
    rf"^\s*(?:(before|after)\s*:?\s*)?(?:in\s+{_CENTRE}\s+frame|(?:velocit\w+\s+)?rel(?:ative|\.)?\s+to\s+"
    rf"(?:{_CENTRE}|it))(?:\s+(before|after))?\s*[:,]?\s*{_BODY}\s*[:=]?\s*({_VALUE})\s*(?:,|;|and)?\s*"
    rf"{_BODY}\s*[:=]?\s*({_VALUE})\s*$"
)
BOTH_BEHIND = re.compile(
    rf"^\s*(?:(before|after)\s*:?\s*)?(){_BODY}\s*[:=]?\s*({_VALUE})\s*(?:,|;|and)?\s*"
    rf"{_BODY}\s*[:=]?\s*({_VALUE})\s*rel(?:ative|\.)?\s+to\s+(?:{_CENTRE}|it)\s*$"
)
OF_ONE = re.compile(
    rf"\b(?:v_?|u_?|vel(?:ocity)?\s+of\s+)([A-Z])\s+(?=rel(?:ative|\.)?\s+to\s+{_CENTRE})"
)
OF_CENTRE = re.compile(
    rf"^(\s*(?:so\s+)?){_CENTRE}(?:\s+(?:(?:moves|goes)\s+(?:with|at)|has|velocity|speed|vel)"
    rf"(\s+along\s+[ij])?\s*[:=]?|(\s+along\s+[ij])?\s*(?:=|:?(?=[^=]*$)))\s*(?={_VALUE})",
)
"""Without a word and a sign before the value, *CoM 6 = 2v + w*, it is conservation of momentum."""
NAMED = re.compile(r"(?<![A-Za-ln-z])[vVU]_?\{?(?:cm|CM|com|CoM|COM)\}?(?![A-Za-z\d])")


def of_both(match: re.Match[str], problem: Problem) -> str:
    """The velocities of both spheres relative to the mass centre."""
    when = match[1] or match[2]
    one, first, other, second = match.groups()[2:]
    if {one, other} != {sphere.name for sphere in problem.spheres}:
        return match[0]
    label = f"relative to centre of mass {when}" if when else "relative to centre of mass"
    return f"velocity of {one} {label} = {first}, velocity of {other} {label} = {second}"


def of_one(match: re.Match[str], problem: Problem) -> str:
    """The velocity of one sphere relative to the mass centre: ``v_A relative to …``."""
    known = match[1] in {sphere.name for sphere in problem.spheres}
    return f"velocity of {match[1]} " if known else match[0]


def named(match: re.Match[str], problem: Problem) -> str:
    """The velocity of the mass centre by its letter: ``Vcm = (3 - 6)u/5``."""
    return match[0] if len(problem.spheres) < 2 else " velocity of centre of mass"


def of_centre(match: re.Match[str], problem: Problem) -> str:
    """The velocity of the mass centre, of two spheres."""
    if len(problem.spheres) < 2:
        return match[0]
    return f"{match[1]}velocity of centre of mass{match[2] or match[3] or ''} = "
