"""What a sentence says of bodies that meet again: a speed behind a wall, and the condition."""

from __future__ import annotations

import re

from restitution.expression.tree import Expression, Polar, Unit, walk
from restitution.problem import Given, Impact, Meets, Problem

_WALL = r"(?:hitting\s+|it\s+hits\s+|the\s+impact\s+with\s+)?(?:the\s+)?wall"
_HAS = r"(?:now\s+)?(?:has|moves\s+(?:at|with)|goes\s+(?:at|with)|is)"
_SPEED = r"(?:a\s+|the\s+)?(?:speed\s+)?(?:of\s+)?"
HAS_AFTER = re.compile(
    rf"(?:^|(?<=[,;]))\s*(?:so\s+|then\s+)?"
    rf"(?:after\s+{_WALL}\s*[:,]?\s*(?:([A-Z])\s*(?:{_HAS}\s+|[:=]\s*))?"
    rf"|([A-Z])\s+after\s+{_WALL}\s*[:=]?\s*(?:{_HAS}\s+)?){_SPEED}"
    r"(?=-?\s*[\d(]*[\d/.]*[a-z(]*(?:\d|[ue]\b))(?!\S*[ij]\b)(?![^,;<>=]*,\s*[\d√])(?![^,;]*[<>])"
)
MEETS_IF = re.compile(
    r"^\s*(?:(?:so|they|will|only|again|it|and|[A-Z])\s+)*"
    r"(?:collides?|collision|hits?|meets?|catch(?:es)?(?:\s+up)?)\b[^=<>:]*?"
    r"\b(?:only\s+if|if|when|provided(?:\s+that)?)\s+(?=[^,;]*[<>])",
    re.IGNORECASE,
)


def has_after(match: re.Match[str], problem: Problem) -> str:
    """The velocity of a sphere behind a wall, where all move along one line."""
    struck = {
        event.first
        for event in problem.events
        if isinstance(event, Impact) and any(wall.name == event.second for wall in problem.walls)
    }
    name = match[1] or match[2] or (next(iter(struck)) if len(struck) == 1 else "")
    known = name in struck and _moves_in_one_line(problem)
    return f" velocity of {name} after wall = " if known else match[0]


def _moves_in_one_line(problem: Problem) -> bool:
    """Whether all spheres move along i, or all along j, at the start."""
    velocities = [sphere.velocity for sphere in problem.spheres]
    units = [
        {node.axis for node in walk(velocity) if isinstance(node, Unit)}
        for velocity in velocities
        if isinstance(velocity, Expression)
    ]
    polar = any(isinstance(velocity, Polar) for velocity in velocities)
    return not polar and len(set().union(*units)) == 1


def meets_if(match: re.Match[str], problem: Problem) -> str:
    """A condition under which two meet, where the question says that they do."""
    meets = any(
        isinstance(relation, Meets) and relation.happens
        for _, step in problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
    )
    return "needs " if meets else match[0]
