"""Ways to a wall or off it as labels, and squares of what words name: ``perp² = 36``."""

from __future__ import annotations

import re

from restitution.problem import Problem

# What begins a value, and is no word of a sentence.
_VALUE = (
    r"(?=[-−(√\d½⅓⅔¼¾]"
    r"|(?!(?:at|it|is|we|so|as|by|in|on|to|an?|he|if|of)\b)(?:[a-z]{1,2}\b|[a-zA-Z]{0,3}(?:sin|cos)))"
)
TO_A_WALL = re.compile(
    r"(^|[,;]|\b(?:so|and)\b)\s*"
    r"(?:(away\s+from|out\s+from|out\s+of|off)|into|towards?|onto)\s+(?:the\s+)?"
    r"(wall|cushion|[A-Z]\w{0,2})\s*[:=]?\s*" + _VALUE
)
SQUARED_THEN = re.compile(
    r"\b(after|before|afterwards|initially|finally)(?:\s*(?:\^\s*2|²)|\s+squared\b)(?=\s*[=:])"
)
SQUARED_WAY = re.compile(
    r"(?<![\w])(perp(?:endicular)?|parallel|para?|normal|along|across)(?:\s*(?:\^\s*2|²)|\s+squared\b)"
    r"(?=\s*[=:])",
    re.IGNORECASE,
)

# The angle at which a sphere comes to a wall: ``hits BC at 18.4°``.
HITS_AT = re.compile(
    r"(^|[,;]|\b(?:so|and|then|now)\b)\s*(?:(?:it|[A-Z]|the\s+(?:ball|sphere|particle))\s+)?(?:then\s+)?"
    r"(?:hits|strikes|meets|reaches)\s+(?:the\s+)?(wall|cushion|[A-Z]\w{0,2})\s+at\s+"
    r"(?:an\s+angle\s+(?:of\s+)?)?(?=[^,;=]*\d\s*(?:°|deg))"
)

# The angle at which a wall or a line of centres lies: ``angle of wall: 63.4° to i``.
_LINE = r"(?:the\s+)?(wall|cushion|barrier|line\s+of\s+cent(?:re|er)s|LOC|[A-Z]\w{0,2})"
_LONGEST_NAME = 3
_SIZE = (
    r"((?=[^,;:]*\d)(?:[-−+\d.°/()^⁻¹²√½⅓⅔¼¾×*=≈\s]"
    r"|(?:arc|a)?(?:tan|sin|cos)(?:inv)?|deg(?:rees)?)+?)"
)
_TO_AN_AXIS = (
    r"\s*(?:to|with|from)\s+(?:the\s+)?"
    r"(i|j|horizontal|vertical|[xy](?=[-\s]axis))(?:[-\s](?:axis|direction))?(?![\w(])"
)
ANGLE_OF_A_LINE = re.compile(
    rf"\b(?:angle|inclination)\s+of\s+{_LINE}\s*(?:[:=]|is\b)\s*{_SIZE}{_TO_AN_AXIS}"
)
LIES_AT = re.compile(
    rf"(?:(?<=[,;])|^)\s*(?:so|hence|then|therefore)?\s*{_LINE}\s+"
    r"(?:(?:is|lies|runs|must\s+be)\s+)?(?:inclined\s+|slopes\s+)?at\s+(?:an\s+angle\s+(?:of\s+)?)?"
    rf"{_SIZE}{_TO_AN_AXIS}"
)

# How a wall lies, by a vector: ``so the wall is parallel to 2i + j``.
_PART = r"[-+−]?\s*[\d./√½⅓⅔¼¾()]*\s*"
LIES_ALONG = re.compile(
    r"(^|[,;]|\band\b)(\s*(?:so|hence|then|therefore)?\s*)(?:(?:the\s+)?direction\s+of\s+)?(?:the\s+)?(wall|cushion|barrier|[A-Z]\w{0,2})\s*"
    r"(?:=|:|is|runs|lies|goes)?\s*"
    r"(?:along|parallel\s+to|∥|//|(?:in\s+the\s+)?direction(?:\s+of)?)?\s*(?:=|:|is)?\s*"
    rf"(?=[(<]?\s*{_PART}[a-hk-z]?i\s*[-+−]{_PART}[a-hk-z]?j\b|[(<]\s*-?\d+\s*,\s*-?\d+\s*[)>]\s*$)"
)

# The same from what is at right angles to it: ``wall is perp to I so parallel to i + 2j``.
_A_VECTOR = (
    rf"[(<]?\s*{_PART}[a-hk-z]?i\s*[-+−]{_PART}[a-hk-z]?j\s*[)>]?|[(<]\s*-?\d+\s*,\s*-?\d+\s*[)>]"
)
LIES_ACROSS = re.compile(
    r"(^|[,;]|\band\b)\s*(?:so|hence|then|therefore)?\s*(?:(?:the\s+)?direction\s+of\s+)?"
    r"(?:the\s+)?(wall|cushion|barrier|[A-Z]\w{0,2})\s+(?:(?:is|must\s+be|lies|runs)\s+)?"
    r"(?:perp(?:endicular)?|at\s+(?:right\s+angles|90\s*(?:°|degrees)?)|normal)(?:\s+to)?\s+"
    rf"(?:({_A_VECTOR})|(?:the\s+)?(?:impulse|change\s+(?:in|of)\s+(?:velocity|momentum|v)|[IJ]|this|that"
    r"|it|v\s*-\s*u|line\s+of\s+(?:the\s+)?impulse))\s*"
    r"(?:[,;:]\s*|=+>\s*|\b(?:so|hence|therefore|thus|and|i\.?e\.?|which\s+is|that\s+is)\b\s*)+"
    r"(?:(?:it|the\s+wall|wall|direction)\s*(?:'s|\s+is|\s+lies|\s+runs|=|:)?\s+)?"
    r"(?:along|parallel\s+to|parallel|(?:in\s+the\s+)?direction(?:\s+of)?)?\s*[:=]?\s*"
    rf"(?={_A_VECTOR})"
)

# What is at right angles to it: ``normal is 2i - j``.
NORMAL = re.compile(
    r"^(\s*(?:so|hence|then|therefore)?\s*)(?:the\s+)?(?:unit\s+)?(?:direction\s+of\s+(?:the\s+)?)?"
    r"normal(?:\s+(?:vector|direction))?(?:\s+to\s+(?:the\s+)?(?:wall|cushion|barrier|[A-Z]\w{0,2}))?\s*"
    r"(?:=|:|is|runs|lies)?\s*(?:along|parallel\s+to|in\s+the\s+direction(?:\s+of)?)?\s*:?\s*"
    rf"(?=\(?\s*{_PART}i\s*[-+−]{_PART}j\b)"
)
GRADIENT = re.compile(
    r"\b(?:the\s+)?(wall|cushion|barrier|[A-Z]\w{0,2})\s+has\s+(?:a\s+)?(?:gradient|slope)\s+(?:of\s+)?"
)
# That of an impulse, which the change of velocity has as well: ``gradient of J = -3/4``.
_IMPULSE = r"([IJ]|impulse|change\s+in\s+(?:velocity|vel|v)|[Δδ]\s?v|v\s*[-−]\s*u)"
GRADIENT_OF_IMPULSE = re.compile(
    rf"\b(?:gradient|grad|slope)\s+of\s+(?:the\s+)?\(?{_IMPULSE}\)?(?=\s*(?:[:=]|is\b|-?\d))"
)
IMPULSE_HAS_GRADIENT = re.compile(
    rf"(?<![\w])(?:the\s+)?{_IMPULSE}\s+has\s+(?:a\s+)?(?:gradient|grad|slope)(?:\s+of)?(?=\s*-?\d)"
)
# That two gradients are of perpendicular lines, before what follows from it.
GRADIENTS_OF_PERPENDICULARS = re.compile(
    r"\bm_?[1₁]\s*[x×*.]?\s*m_?[2₂]\s*=\s*[-−]\s*1\s*(?:[,;:]|so|hence|=>|⇒|∴|therefore)(?=.*=)"
)

# What tells that a label is of the wall itself.
_VERB = re.compile(r"=|∥|//|\b(?:is|runs|lies|goes|along|parallel|direction)\b")


def lies_along(match: re.Match[str], problem: Problem) -> str:
    """The direction of a wall as a label, where the words say it of one."""
    names = {wall.name for wall in problem.walls}
    named = match[3]
    known = named in names or (len(names) == 1 and named in ("wall", "cushion", "barrier"))
    if not known or len(names) > 1:
        return match[0]
    begins = f"{match[1] and ';'}{match[2]}"
    # A label alone, wall: i + j, may be of another vector.
    return f"{begins}parallel to wall: " if _VERB.search(match[0]) else f"{begins}wall: "


def lies_across(match: re.Match[str], problem: Problem) -> str:
    """The direction of the only wall as a label, and that across it where a vector says so."""
    begins, wall, normal = match.groups()
    names = {wall.name for wall in problem.walls}
    if len(names) != 1 or not (wall in names or wall in ("wall", "cushion", "barrier")):
        return match[0]
    across = f"perpendicular to wall: {normal}; " if normal else ""
    return f"{begins and ';'} {across}parallel to wall: "


def lies_at(match: re.Match[str], problem: Problem) -> str:
    """The angle of a wall or a line of centres to an axis, as a label."""
    line, size, other = match.groups()
    if len(line) <= _LONGEST_NAME and line not in {"LOC"} | {wall.name for wall in problem.walls}:
        return match[0]
    axis = {"h": "i", "x": "i", "v": "j", "y": "j"}.get(other[0], other)
    return f" angle of {line} to {axis} = {size}"


def normal(match: re.Match[str], problem: Problem) -> str:
    """The direction across the only wall as a label."""
    return f"{match[1]}perpendicular to wall: " if len(problem.walls) == 1 else match[0]


def gradient(match: re.Match[str], problem: Problem) -> str:
    """The gradient of a wall as a label."""
    names = {wall.name for wall in problem.walls}
    known = match[1] in names or (len(names) == 1 and match[1] in ("wall", "cushion", "barrier"))
    return f"gradient of {match[1]} = " if known else match[0]


def gradient_of_impulse(match: re.Match[str], problem: Problem) -> str:
    """The gradient of an impulse as a label, where no body has the name of its letter."""
    bodies = {sphere.name for sphere in problem.spheres} | {wall.name for wall in problem.walls}
    if match[1] in bodies:
        return match[0]
    return "gradient of impulse =" if " has " in match[0] else "gradient of impulse"


def hits_at(match: re.Match[str], problem: Problem) -> str:
    """The angle to a wall before it is hit."""
    names = {wall.name for wall in problem.walls}
    if match[2] in ("wall", "cushion") and len(names) == 1:
        return f"{match[1]} angle to the wall before = "
    return f"{match[1]} angle to {match[2]} before = " if match[2] in names else match[0]


def to_a_wall(match: re.Match[str], problem: Problem) -> str:
    """The component into a wall before, or away from it after."""
    names = {wall.name for wall in problem.walls}
    known = match[3] in names or (bool(names) and match[3] in ("wall", "cushion"))
    stage = "after" if match[2] else "before"
    wall = match[3] if match[3] in names else f"the {match[3]}"
    return f"{match[1]} perpendicular to {wall} {stage}: " if known else match[0]
