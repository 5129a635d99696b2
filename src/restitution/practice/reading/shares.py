"""What a sentence says of sizes, shares and places: ``so half the KE is lost``, ``so 16``."""

from __future__ import annotations

import re

from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Expression, Quantity, is_binary, letters, walk
from restitution.practice.reading.features import words_of
from restitution.practice.reading.vocabulary import DIRECTIONS
from restitution.problem import Find, Problem, trees_of_step

_SO = r"(?:so|hence|therefore|thus|∴|→|⇒|=>)"
_IN_UNITS = r"(?:\s*(?:N\s?s|m/s|m\s?s\^?-1|ms⁻¹))?"
SIZE_OF_A_VECTOR = re.compile(
    rf",?\s*{_SO}\s*(?:(?:the\s+)?(?:mag(?:nitude)?|size|modulus)\s*(?:is|=)?\s*)?"
    rf"((?:\d[\d./]*)?√?\d[\d./]*){_IN_UNITS}\s*$",
    re.IGNORECASE,
)
_OF_A_VECTOR = re.compile(r"^\s*([A-Za-z](?:_?[A-Z])?)\s*=.*\d?[ij]\)?(?:/\d+)?\s*$")

SHARES_IN_WORDS = {
    "half": "1/2",
    "third": "1/3",
    "quarter": "1/4",
    "two thirds": "2/3",
    "three quarters": "3/4",
}
SHARE_OF_ENERGY = re.compile(
    r"(?:\b(?:so|hence|∴)\s+)?(?<![\w/.])(?:(?:an?|one)\s+)?"
    r"(half|third|quarter|two\s+thirds|three\s+quarters|[½⅓⅔¼¾]|\d+/\d+)"
    r"\s+(?:of\s+)?(?:(?:the|its|all)\s+)*(?:(?:initial|original|total)\s+)*"
    r"(?:KE|kinetic\s+energy|energy)\s+(?:(?:is|was|has\s+been|gets)\s+)?lost\b",
    re.IGNORECASE,
)
LOST = re.compile(
    r"^\s*(?:(?:so|hence|∴)\s+)?([^:,;]*\d[^:,;]*?|[½⅓⅔¼¾])\s*J?\s+(?:is\s+|are\s+)?lost\s*$",
    re.IGNORECASE,
)
FRACTION_OF = re.compile(
    r"\b(fraction|proportion|percentage)\s+of\s+[^:=<>,;]*\d[^:=<>,;]*[:=]\s*(?=[\d(.√]|1/)",
    re.IGNORECASE,
)
# What is not lost, beside a share that is asked: ``fraction of KE remaining = 2/3``.
SHARE_KEPT = re.compile(
    r"\b(?:the\s+)?(?:fraction|proportion|percentage|ratio)\s+"
    r"(?:of\s+(?:the\s+)?(?:total\s+)?(?:KE|kinetic\s+energy|energy)\s+)?"
    r"(?:(?:that|which)\s+(?:is\s+)?)?"
    r"(?:kept|left(?:\s+over)?|remains?|remaining|retained|still\s+there)\b\s*"
    r"(?:(?:=|:|is\b)\s*|(?=[\d(⅓⅔½¼¾]))",
    re.IGNORECASE,
)
NET = re.compile(r"\bnet\s+(?=(?:los[st]|loss|gain|change|KE|energy|impulse)\b)", re.IGNORECASE)
# A way of so many metres, and no component of a velocity: horizontal: 2 m/s × 2.5 s = 5 m.
DISTANCE = re.compile(
    r"(?:^|(?<=[,;]))\s*(?:so\s+)?(?:horizontal(?:ly)?|vertical(?:ly)?|along|across|up|down|sideways)"
    r"\s*[:=]\s*(?=[^,;:]*\d\s*m\s*(?:$|[,;]))",
    re.IGNORECASE,
)
_JOULES = r"\d[\d.]*)\s*(?:J|joules?)\b"
ENERGY_OF_A_BODY = re.compile(
    rf"(^\s*|[,;]\s*|\band\s+)([A-Z])\s*[:=]?\s*({_JOULES}"
    rf"(?:\s*(?:to|==>|=>|->)\s*({_JOULES})?(?=\s*(?:$|[,;]|and\b))"
)
AT_THE_ENDS = re.compile(r"\bE_?([if])(?=\s*[=:])")
HUNDREDTHS = re.compile(r"(\d\)?)\s*[*x×]\s*100\s*=\s*(\d[\d.]*)(?=\s*$)")
SHARE_LOST_IS = re.compile(
    r"^\s*(?:so\s+)?(\(?\d[\d./]*\)?(?:\s*/\s*\(?\d[\d./]*\)?)?)\s+(?:is\s+)?lost\s*=\s*(?=[\d(.½⅓⅔¼¾])",
    re.IGNORECASE,
)
SO_LOST = re.compile(
    rf"\s*,?\s*{_SO}\s+([½⅓⅔¼¾]|\(?\d+/\d+\)?|0?\.\d+)\s+(?:(?:is|was)\s+)?lost\s*$", re.IGNORECASE
)
_WORD = re.compile(r"[A-Za-z]{3,}")
_FUNCTION = re.compile(r"sin|cos|tan|sqrt")
SPEEDS = re.compile(r"^\s*speeds?(?:\s+after)?\s*:\s*(?=[A-Z]\s*[√(\d]).*$")
_OF_A_BODY = re.compile(r"(^|[,;]\s*|\band\s+)([A-Z])\s*(?=[√(\d])")
ROOT_OF_A_BODY = re.compile(
    r"(^\s*|[,;]\s*|\b(?:and|so)\s+)([A-Z])(?:\s+|\s*=\s*)(?=√|sqrt|root\b)(?![^,;=]*[\d)\s][ij]\b)"
)
AT_A_WALL = re.compile(
    r"^\s*at\s+(?:the\s+)?wall\s*:?\s*(?=\([^(),]*,[^(),]*\)\s*$)", re.IGNORECASE
)


def size_of_a_vector(match: re.Match[str], _: Problem) -> str:
    """The size behind a vector: ``I = -16i so 16`` is ``|I| = 16`` as well."""
    before = _OF_A_VECTOR.match(match.string[: match.start()])
    return f"; |{before[1]}| = {match[1]}" if before else match[0]


def share_of_energy(match: re.Match[str], _: Problem) -> str:
    """The share that is lost, as a label with its value."""
    share = " ".join(match[1].lower().split())
    return f"; fraction lost = {SHARES_IN_WORDS.get(share, share)}"


def lost(match: re.Match[str], problem: Problem) -> str:
    """What is lost by a line that ends with that word: a share where one is asked, or energy."""
    if any(not _FUNCTION.search(word) for word in _WORD.findall(match[1])):
        return match[0]
    asked = [
        tree
        for _, step in problem.steps()
        if isinstance(step, Find)
        for tree in trees_of_step(step)
        if any(isinstance(x, Quantity) and x.kind in LOSSES for x in walk(tree))
    ]
    if not asked:
        return match[0]
    shares = [is_binary(tree, "/") for tree in asked]
    if any(shares) != all(shares):
        return match[0]
    return f"{'fraction' if all(shares) else 'KE'} lost = {match[1]}"


def distance(match: re.Match[str], problem: Problem) -> str:
    """Nothing in place of a label for a distance, where the question tells places."""
    places = any(sphere.position is not None for sphere in problem.spheres)
    masses = {
        name for x in problem.spheres if isinstance(x.mass, Expression) for name in letters(x.mass)
    }
    return "" if places and "m" not in masses else match[0]


def energy_of_a_body(match: re.Match[str], problem: Problem) -> str:
    """The energy of the sphere that labels joules, before and after: ``A: 29 J to 4 J``."""
    before, name, first, last = match.groups()
    if name not in {sphere.name for sphere in problem.spheres}:
        return match[0]
    if last is None:
        return f"{before}KE of {name} = {first}"
    return f"{before}KE of {name} before = {first}, KE of {name} after = {last}"


def at_the_ends(match: re.Match[str], problem: Problem) -> str:
    """The energy before, or after, that ``Ei`` or ``Ef`` is."""
    bodies = {sphere.name for sphere in problem.spheres} | {wall.name for wall in problem.walls}
    stage = {"i": "initial", "f": "final"}[match[1]]
    return match[0] if "E" in bodies else f"{stage} KE"


def hundredths(match: re.Match[str], problem: Problem) -> str:
    """A percentage with its sign, where one is asked: ``3.4/20 × 100 = 17``."""
    asked = (step for _, step in problem.steps() if isinstance(step, Find))
    percentage = any(getattr(item, "percentage", False) for step in asked for item in step.items)
    return f"{match[1]} = {match[2]}%" if percentage else match[0]


def share_lost_is(match: re.Match[str], problem: Problem) -> str:
    """The share lost that a line goes on to work out, where one is asked: ``8/12 lost = 2/3``."""
    as_whole = lost(re.compile(r"^(.*)$").match(match[1]), problem)  # type: ignore[arg-type]
    return f"{as_whole} = " if as_whole.startswith("fraction") else match[0]


def so_lost(match: re.Match[str], problem: Problem) -> str:
    """The share lost at the end of a line, where one is asked: ``KE ratio = 1/3 so 2/3 lost``."""
    as_whole = lost(re.compile(r"^(.*)$").match(match[1]), problem)  # type: ignore[arg-type]
    return f"; {as_whole}" if as_whole.startswith("fraction") else match[0]


def speeds_of_bodies(match: re.Match[str], problem: Problem) -> str:
    """The speed of each sphere in a list of them: ``speeds: A √(4 + 9), B 2``."""
    spheres = {sphere.name for sphere in problem.spheres}
    listed = match[0].partition(":")[2].strip()
    if not {own[2] for own in _OF_A_BODY.finditer(listed)} <= spheres:
        return match[0]
    return _OF_A_BODY.sub(r"\1speed of \2 = ", listed)


def root_of_a_body(match: re.Match[str], problem: Problem) -> str:
    """The speed that a root behind the name of a sphere is: ``A √(4 + 9)``, not ``perp: A √2``."""
    spheres = {sphere.name for sphere in problem.spheres}
    resolved = not DIRECTIONS.keys().isdisjoint(words_of(match.string[: match.start()].lower()))
    known = match[2] in spheres and not resolved
    return f"{match[1]}speed of {match[2]} = " if known else match[0]


def at_a_wall(match: re.Match[str], problem: Problem) -> str:
    """The place at which a sphere comes to a wall, where the question tells places."""
    places = any(sphere.position is not None for sphere in problem.spheres)
    return "hits at " if places else match[0]
