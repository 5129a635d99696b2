"""What a sentence says a body has: ``A has 3i + 2j``, ``hits V with -6i + 4j``, ``A loses …``."""

from __future__ import annotations

import re

from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Quantity, walk
from restitution.problem import Find, Problem, trees_of_step

_NUMBER = r"[\d./√½⅓⅔¼¾]*"
_TERM = rf"{_NUMBER}\s?[a-zA-Z]?\s?"
_VECTOR = rf"(?:[-−]?\s?{_TERM}i\b(?:\s*[-+−]\s*{_TERM}j\b)?|[-−]?\s?{_TERM}j\b)"
_SO = r"(?:so|hence|therefore|thus|then|finally|and)"
# A vector that a body comes to a wall with, or leaves it with.
COMES_WITH = re.compile(
    rf"^\s*(?:{_SO}\s+)?(?:(?:it|[A-Z]|(?:the\s+)?(?:ball|sphere|particle|puck))\s+)?"
    r"(?:hits|strikes|meets|reaches|arrives\s+at|comes\s+to|gets\s+to)\s+"
    r"(?:(?:the\s+)?(?:(?:first|second|other)\s+)?wall|([A-Z]\w?))\s+(?:with|at)\s+"
    rf"(?:velocity\s+)?(?={_VECTOR}\s*$)",
)
LEAVES_WITH = re.compile(
    rf"^\s*(?:{_SO}\s+)?(?:(?:it|(?:the\s+)?(?:ball|sphere|particle|puck))\s+|([A-Z])\s+)?"
    r"(?:leaves(?:\s+(?:it|(?:the\s+)?wall|[A-Z]\w?))?|rebounds|bounces\s+off|comes\s+off|goes\s+off)"
    rf"\s+(?:with|at)\s+(?:velocity\s+)?(?=[-−\d√(][^=<>]*[ij]\s*(?:=|$))",
)
HAS_VECTOR = re.compile(
    rf"(^|[,;]|\b(?:{_SO})\b)\s*([A-Z])\s+(?:now\s+)?"
    r"(?:has|gets|is|is\s+left\s+with|moves\s+(?:with|at))\s+"
    rf"(?={_VECTOR}\s*(?:$|[,;.]|and\b))",
)
TWO_VECTORS = re.compile(rf"^\s*(?:{_SO}\s+)?({_VECTOR})\s+and\s+({_VECTOR})\s*$")
LOSES_WORKED = re.compile(
    rf"(^|[,;]|\b(?:{_SO})\b)\s*([A-Z])\s+(?:loses|lost|gains|gained)\s+(?=[\d(½][^=,;<>]*=)"
    r"(?=[^=]*(?:1/2|½|0?\.5|²|\^2))(?![^=]*[A-Za-z]{3})",
)
TOTAL = re.compile(
    rf"^\s*(?:{_SO}\s+)?total\s*(?:(?:is|of|=|:)\s*)?(?=\d[\d./+=\smu²^]*(?:J\b\s*)?$)",
    re.IGNORECASE,
)
# The label says already what is lost: ``total = 756/512 = 189/128 lost``.
LOST_BEHIND = re.compile(
    rf"^(\s*(?:{_SO}\s+)?(?:total|loss|KE|energy)(?:\s+lost)?\s*[=:].*[\w)²])\s+(?:is\s+)?lost\s*\.?\s*$",
    re.IGNORECASE,
)
IN_TOTAL = re.compile(
    rf"^\s*(?:{_SO}\s+)?(\d[\d./]*)\s*(?:J\s+)?(?:is\s+|are\s+)?lost\s+"
    r"(?:in\s+(?:total|all)|altogether|overall)[\s.]*$"
)
# A formula in words, between a label and its value: ``time = distance/speed = 4/2``.
FORMULA = re.compile(
    r"=\s*(?:distance|dist)\s*[/÷]\s*(?:speed|velocity|time)\s*(?==)"
    r"|=\s*(?:(?:the\s+)?change\s+(?:in|of)\s+(?:the\s+)?(?:momentum|mom|m\s?v)"
    r"|(?:final|new)\s+(?:momentum|mom)\s*[-−]\s*(?:initial|old|original)\s+(?:momentum|mom)"
    r"|(?:momentum|mom)\s+after\s*[-−]\s*(?:momentum|mom)\s+before)\s*(?==[^=]*\d[ij]\b)",
    re.IGNORECASE,
)
# A word of which the letters are no product: ``cos(def) = 0.6``.
SHORT_DEFLECTION = re.compile(
    r"(?<![\w.])def(?:n|lect)?\b\.?(?=\s*(?:[=:)]|is\b|of\b|angle\b))", re.IGNORECASE
)
# What two components come to: ``resultant = √(3² + 4²) = 5``.
RESULTANT = re.compile(
    rf"(^|[,;])\s*((?:{_SO}\s+)?)(?:the\s+)?resultant(?=\s*(?:[=:]|is\b)\s*(?:√|sqrt|root|[\d.]+u?\s*(?:m|$)))",
    re.IGNORECASE,
)
# The name of a body for its speed, of which the first is worked out as a root.
SPEEDS = re.compile(rf"^\s*(?:{_SO}\s+)?[A-Z]\s*=\s*√.*$")
_NAMED = re.compile(r"(?<![\w|])([A-Z])\s*=\s*(?=[√\d])")
CHANGE_BEHIND = re.compile(
    r"(?<==)(\s*-?[\d./]+)\s+(?:is\s+(?:the\s+)?)?change\s+in\s+(?:perp\w*\s+)?(?:velocity|speed)\s*$"
)
TURN = re.compile(r"\b(?:total\s+)?(?:angle\s+of\s+)?turn(?=\s*[=:])", re.IGNORECASE)
OF_SIZE = re.compile(
    r"\b((?:component|comp|cpt|part)\s[^=:,;]*?)\s+(?:has|is\s+of)\s+(?:size|magnitude)\s*[:=]?\s*(?=\d)"
)
# A list of components with a common factor, or along a vector: ``components × √2: A 8 before``.
LISTED_COMPONENTS = re.compile(
    r"^\s*(?:components?|comps?)\s+(?:(?:[x×*]\s*√?\d+|along\s+n))\s*:(?=[^=]*$)", re.IGNORECASE
)


def comes_with(match: re.Match[str], problem: Problem) -> str:
    """The velocity with which a body comes to a wall, or leaves one before."""
    walls = {wall.name for wall in problem.walls}
    known = match[1] is None or match[1] in walls
    return "velocity = " if known and len(problem.spheres) == 1 else match[0]


def leaves_with(match: re.Match[str], problem: Problem) -> str:
    """The velocity with which the only body, or that which is named, leaves."""
    spheres = {sphere.name for sphere in problem.spheres}
    if match[1]:
        return f"velocity of {match[1]} = " if match[1] in spheres else match[0]
    return "velocity = " if len(spheres) == 1 else match[0]


def has_vector(match: re.Match[str], problem: Problem) -> str:
    """The velocity of a sphere, of ``A has 3i + 2j``."""
    spheres = {sphere.name for sphere in problem.spheres}
    return f"{match[1]} velocity of {match[2]} = " if match[2] in spheres else match[0]


def two_vectors(match: re.Match[str], problem: Problem) -> str:
    """The velocities of both spheres, where the question asks for both."""
    names = [sphere.name for sphere in problem.spheres]
    asked = {
        str(node.arguments[0].name)
        for node in _asked(problem)
        if node.kind == "velocity" and hasattr(node.arguments[0], "name")
    }
    if len(names) != 2 or not set(names) <= asked:
        return match[0]
    return f"velocity of {names[0]} = {match[1]}, velocity of {names[1]} = {match[2]}"


def speeds(match: re.Match[str], problem: Problem) -> str:
    """The speeds of the spheres of which the names are put for them: ``A = √5 u, B = 2u``."""
    names = {sphere.name for sphere in problem.spheres}
    if not {own[1] for own in _NAMED.finditer(match[0])} <= names:
        return match[0]

    def put(own: re.Match[str]) -> str:
        before = match[0][: own.start()].rstrip()
        apart = not before or before.endswith((",", ";", "so", "and"))
        return f"{'' if apart else ', '}speed of {own[1]} = "

    return _NAMED.sub(put, match[0])


def loses_worked(match: re.Match[str], problem: Problem) -> str:
    """The energy that one of several spheres loses, as it is worked out."""
    names = [sphere.name for sphere in problem.spheres]
    if match[2] not in names or not _asks_for_a_loss(problem):
        return match[0]
    change = "gained" if "gain" in match[0] else "lost"
    whole = f" by {match[2]}" if len(names) > 1 else ""
    return f"{match[1]} KE {change}{whole} = "


def resultant(match: re.Match[str], _: Problem) -> str:
    """The speed that a resultant is."""
    return f"{match[1]} {match[2]} speed"


def total(match: re.Match[str], problem: Problem) -> str:
    """The energy that a total is, where the question asks for an energy lost and for no time."""
    kinds = {node.kind for node in _asked(problem)}
    return "total KE = " if _asks_for_a_loss(problem) and "time" not in kinds else match[0]


def _asked(problem: Problem) -> list[Quantity]:
    """The quantities in what the question asks for."""
    return [
        node
        for _, step in problem.steps()
        if isinstance(step, Find)
        for tree in trees_of_step(step)
        for node in walk(tree)
        if isinstance(node, Quantity)
    ]


def _asks_for_a_loss(problem: Problem) -> bool:
    return any(node.kind in LOSSES for node in _asked(problem))
