"""Values with labels in words: ``components x 8, y 2``, ``perp before/after: 6, 2``."""

from __future__ import annotations

import re

from restitution.problem import Problem

_NUMBER = r"[-−]?\s?(?:[\d.√½⅓⅔¼¾]+(?:/\d+)?[a-z]?|[a-z])"
_APART = r"\s*(?:,|;|and|&)?\s*"
COMPONENTS = re.compile(
    r"(^|[,;]|\bso\b)\s*(?:the\s+)?(?:components?|comps?|cpts?)(?:\s+of\s+([A-Z]))?"
    rf"(?:\s+(before|after|now|initially|finally))?\s*:?\s*([xi])\s*[:=]?\s*({_NUMBER}){_APART}"
    rf"([yj])\s*[:=]?\s*({_NUMBER})(?:\s+(before|after))?\s*$",
    re.IGNORECASE,
)
_LABEL = (
    r"((?:components?|comps?|perp\w*|para?\w*|along|speed|KE|[xyij])"
    r"(?:\s+(?:components?|comps?|cpt|(?:to\s+)?(?:the\s+)?(?:wall|[A-Z]{1,2})))?)"
)
_FIGURES = r"(\d[\d.]*)"
_SIGNED = r"([-−]?\d[\d.]*)"
_BOTH = r"before\s*(?:/|,|and|&|->|→)\s*after"
# With an equals sign a slash would be of a ratio.
_PAIR = (
    rf"(?:\s*[:=]?\s*{_FIGURES}\s*(?:,|->|→|and)\s*{_SIGNED}"
    rf"|\s*:?\s*{_FIGURES}\s*/\s*{_SIGNED})\s*$"
)
BEFORE_AND_AFTER = re.compile(rf"^\s*{_BOTH}\s*:?\s*{_LABEL}{_PAIR}")
AFTER_A_LABEL = re.compile(rf"^\s*{_LABEL}\s+{_BOTH}{_PAIR}")
EACH_BEHIND = re.compile(
    rf"^\s*{_LABEL}\s*[:=]?\s*before\s*[:=]?\s*{_FIGURES}{_APART}after\s*[:=]?\s*{_SIGNED}()()\s*$"
)
EACH_IN_FRONT = re.compile(
    rf"^\s*{_LABEL}\s*[:=]?\s*{_FIGURES}\s+before{_APART}{_SIGNED}\s+after()()\s*$"
)
# A moment behind a label and its value: ``perp: 14 sin 50 = 10.7 after the impact``.
MOMENT_BEHIND = re.compile(
    rf"^\s*((?:so|hence|∴)\s+)?{_LABEL}\s*[:=]\s*([^,;:<>]*[\d°)])\s*(?:m\s?/\s?s|m\s?s\s?(?:\^?-1|⁻¹))?"
    r"\s+(before|after)(?:\s+(?:the\s+)?(?:impact|collision|bounce|hit|rebound))?\s*\.?\s*$"
)
_AXES = {"x": "i", "y": "j"}


def components(match: re.Match[str], problem: Problem) -> str:
    """The components along i and j, each with its value."""
    start, body, stage, first, one, second, other, behind = match.groups()
    if body is not None and body not in {sphere.name for sphere in problem.spheres}:
        return match[0]
    whose = f" of {body}" if body else ""
    when = {"now": "after", "initially": "before", "finally": "after"}.get(stage or "", stage)
    when = f" {when or behind}" if when or behind else ""
    labels = (f"{_AXES.get(axis, axis)} component{whose}{when}" for axis in (first, second))
    return f"{start} {next(labels)} = {one}, {next(labels)} = {other}"


def moment_behind(match: re.Match[str], _: Problem) -> str:
    """The label with its moment before what it is worth."""
    start, label, value, stage = match.groups()
    axis = _AXES.get(label, label)
    label = f"{axis} component" if axis in ("i", "j") else label
    return f"{start or ''}{label} {stage} = {value}"


def before_and_after(match: re.Match[str], problem: Problem) -> str:
    """What a label is worth before an impact, and after it.

    Of the components of one sphere that perpendicular to the wall changes.
    """
    label, *values = match.groups()
    before, after = (value for value in values if value)
    if label.startswith("comp"):
        if len(problem.spheres) > 1 or before == after:
            return match[0]
        label = "perp component"
    axis = _AXES.get(label, label)
    label = f"{axis} component" if axis in ("i", "j") else label
    return f"{label} before = {before}, {label} after = {after}"
