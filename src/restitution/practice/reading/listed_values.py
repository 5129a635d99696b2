"""Values that a line only lists: of bodies, ``B u/2 and C 2u``, of moments, of directions."""

from __future__ import annotations

import re

from restitution.expression.tree import Quantity, is_quantity, letters
from restitution.problem import Find, Problem, Value

_PART = r"[-−]?\s?[\d./√]*\s?[a-z]?\s?"
_VECTOR = rf"\(?{_PART}i\s*[-+−]\s*{_PART}j\)?(?:\s?/\s?[\d√]+)?"
_MULTIPLE = r"[-−]?\s?[\d./√]*\s?[a-zα-ω](?![a-z])(?:\s?/\s?[\d√]+)?"
_ONE = rf"(?:{_VECTOR}|{_MULTIPLE})"
# ``before: speed 10, after: speed √68``
STAGE_BEFORE_A_NAME = re.compile(
    r"\b(before|after)\s*:\s*(?:the\s+)?(speed|velocity|KE|(?:kinetic\s+)?energy)\s*[:=]?\s*"
    r"(?=[-−]?[\d(√½⅓⅔¼¾])",
    re.IGNORECASE,
)
# ``after AB: 8i + 3/5(5)j = 8i + 3j``, where one sphere comes to walls
AFTER_A_WALL = re.compile(
    r"^(\s*(?:after|at)\s+(?:wall\s+)?([A-Z]\w{0,2})\s*:)\s*(?!.*\bbecomes\b)"
    r"(?=[^=:a-hk-z]*\di\s*[-+−][^=:a-hk-z]*j\b(?:[^:]*j)?[\s.]*$)"
)
OF_BODIES = re.compile(
    rf"^\s*(?:so\s+)?([A-Z])\s+({_ONE})\s*(?:[,;]\s*(?:and\s+)?|\s+and\s+)([A-Z])\s+({_ONE})[\s.]*$"
)
# ``-3i + 4j which is the direction of the line of centres``
LINE_BEHIND = re.compile(
    rf"({_VECTOR})\s*,?\s*(?:which|this|that|and\s+this|so\s+this)\s+is\s+(?:in\s+)?"
    r"(?:the\s+direction\s+of|along|parallel\s+to)\s+(?:the\s+)?"
    r"(?:line\s+of\s+cent(?:re|er)s|LOC)[\s.]*$",
    re.IGNORECASE,
)
# ``parallel to i + j`` where a line of centres is asked for
LINE_ALONE = re.compile(
    rf"^\s*(?:so\s+)?(?:it\s+is\s+)?parallel\s+to\s+(?=(?:the\s+vector\s+)?{_VECTOR}[\s.]*$)"
)
# ``-4i + 8j ∥ -i + 2j is normal to the wall``
NORMAL_BEHIND = re.compile(
    rf"(?:∥|\|\||//|\bparallel\s+to)\s*({_VECTOR})\s*,?\s*(?:which\s+)?is\s+"
    r"(?:the\s+)?(?:normal|perp(?:endicular)?)\s+to\s+(?:the\s+)?(?:wall|cushion|barrier)[\s.]*$",
    re.IGNORECASE,
)

# From one velocity to the next: ``at W: (6, -10) → (6, 0.4 × 10)``, ``B: 4i → 2i + j``.
_OF_ANY = r"\([^(),=<>]{1,20},[^(),=<>]{1,20}\)|[-−]?[\d./√]*[a-z]?i\s*[-+−]\s*[\d./√]*[a-z]?j\b"
ARROW = re.compile(
    rf"(^\s*(?:([A-Z]\w?)\s*:\s*)?|:\s*|(?<=\bbecomes ))({_OF_ANY})\s*"
    r"(?:=+>|-+>)\s*(?=\([^(),=<>]+,|[-−]?\s?[\d./√½⅓⅔¼¾×*]*[a-z]?i\b)"
)

# A heading with a sign behind it: ``after W = 6i + 4j``, ``after 2nd hit = -4i + 4j``.
HEADING_IS = re.compile(
    r"^(\s*(?:so\s+)?(?:just\s+|straight\s+)?(?:after|before)"
    r"(?:\s+(?:the|wall|cushion|impact|collision|hit|bounce|hitting|striking|with|off|on|first|second|third"
    r"|1st|2nd|3rd|[A-Z]\w{0,2}))*)\s*=\s*"
    r"(?=[-−(]?\s?[-−(]?[\d./√½⅓⅔¼¾×*()]*\s?[a-z]?i\s*[-+−]|\([^(),=<>]{1,20},[^(),=<>]{1,20}\))"
)

# A vector behind the number of an event: ``second 4i - j``, ``2nd: 4i - j``.
BY_NUMBER = re.compile(
    r"^\s*(?:and\s+|then\s+)?(first|second|third|fourth|1st|2nd|3rd|4th)"
    r"(?:\s+(?:bounce|hit|impact|collision|wall|cushion))?\s*:?\s+"
    rf"(?=(?:{_OF_ANY})\s*(?:m\s?/\s?s|m\s?s\s?(?:\^?-1|⁻¹))?[\s.]*$)",
    re.IGNORECASE,
)
# Components of two spheres without a comma: ``A perp 4.50 B perp 4.70``.
_OF_A_BODY = r"[A-Z]\s+(?:perp(?:endicular)?|para?(?:llel)?|along|across)\s*[:=]?\s*"
TWO_BODIES = re.compile(rf"^(\s*{_OF_A_BODY}[-−]?[\d./√]+[a-z]?)\s+(?={_OF_A_BODY}[-−\d√])")


def by_number(match: re.Match[str], problem: Problem) -> str:
    """The heading of an event, where one sphere has several."""
    alone = len(problem.spheres) == 1 and len(problem.events) > 1
    return f"after {match[1].lower()}: " if alone else match[0]


def from_one_to_another(match: re.Match[str], problem: Problem) -> str:
    """What a velocity becomes, or the velocities of a sphere before and after."""
    begins, name, vector = match.groups()
    spheres = {sphere.name for sphere in problem.spheres}
    if name not in spheres:
        return f"{begins}{vector} becomes "
    if len(spheres) == 1:
        return f"{vector} becomes "
    return f"velocity of {name} before = {vector}, velocity of {name} after = "


def stage_before_a_name(match: re.Match[str], _: Problem) -> str:
    """A quantity by its name and its moment."""
    return f"{match[2]} {match[1]} = "


def after_a_wall(match: re.Match[str], problem: Problem) -> str:
    """The velocity of the only sphere below the heading of a wall."""
    walls = {wall.name for wall in problem.walls}
    alone = len(problem.spheres) == 1 and match[2] in walls
    return f"{match[1]} velocity after = " if alone else match[0]


def of_bodies(match: re.Match[str], problem: Problem) -> str:
    """The velocities of two spheres in a list: a multiple is one of a speed that is given."""
    spheres = {sphere.name: sphere for sphere in problem.spheres}
    first, one, second, other = match.groups()
    given = frozenset[str]().union(
        *(letters(sphere.velocity) for sphere in problem.spheres if sphere.velocity is not None)
    )
    named = {first, second} <= spheres.keys() and first != second
    moving = all(
        re.search(r"[ij]\b", value) or set(re.findall(r"[a-zα-ω]", value)) <= given
        for value in (one, other)
    )
    if not named or not moving:
        return match[0]
    return f"velocity of {first} = {one}, velocity of {second} = {other}"


def line_behind(match: re.Match[str], _: Problem) -> str:
    """A vector, and that the line of centres is along it."""
    return f"{match[1]}; direction of line of centres: {match[1]}"


def line_alone(match: re.Match[str], problem: Problem) -> str:
    """The direction of the line of centres, where nothing else with a direction is asked for."""
    asked = [
        item.expression
        for _, step in problem.steps()
        if isinstance(step, Find)
        for item in step.items
        if isinstance(item, Value) and isinstance(item.expression, Quantity)
    ]
    lines = [tree for tree in asked if is_quantity(tree, "line_of_centres")]
    others = [tree for tree in asked if is_quantity(tree, "direction", "angle")]
    return "direction of line of centres: " if len(lines) == 1 and not others else match[0]


def normal_behind(match: re.Match[str], problem: Problem) -> str:
    """The direction across the only wall as a label."""
    return f"; perpendicular to wall: {match[1]}" if len(problem.walls) == 1 else match[0]
