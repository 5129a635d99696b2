"""What a sentence says of amounts: ``KE before 25 KE after 13 lost 12``, ``it loses 12 J``."""

from __future__ import annotations

import re

from restitution.practice.reading.bodies import places_of
from restitution.problem import Problem

_KE = r"(?:K\.?E\.?|Ek|(?:kinetic\s+)?energy)"
_VALUE = r"(?:\d[\d./]*(?:\s?[a-z]{1,2}(?:\^2|²))?|[½⅓⅔¼¾]|\(\d+/\d+\))"
_JOULES = r"(?:J|joules?)\b"
_SO = r"(?:so|hence|therefore|thus|and|then)"
_LISTED_AFTER = re.compile(rf"{_KE} after = ", re.IGNORECASE)
_ENERGY = re.compile(rf"\b{_KE}(?![a-z])", re.IGNORECASE)
_WORD = re.compile(r"[A-Za-z]{2,}")
# Words among the energies of a list, which say nothing of another quantity.
_LISTING = frozenset(
    ("before", "after", "initially", "finally", "and", "so", "then", "is", "was", "total", "hence")
    + ("joules", "joule", "the", "afterwards", "ke", "energy", "kinetic", "ek")
)
LISTED_ENERGY = re.compile(
    rf"[,;]?\s*(?:{_SO}\s+)?(?:\b{_KE}\s+)?\b(before|after|initially|finally)\s+({_VALUE})"
    rf"(?=\s*(?:{_JOULES})?\s*(?:$|[,;→]|->|(?:{_SO}|after|finally|lost|loss|{_KE})\b))",
    re.IGNORECASE,
)
LISTED_LOSS = re.compile(
    rf"[,;]?\s*(?:{_SO}\s+)?(?:(?:{_KE}\s+)?(?:lost|loss(?:\s+of)?|loses|diff(?:erence)?)\s+"
    rf"({_VALUE})(?=\s*(?:{_JOULES})?[\s.]*$)"
    rf"|({_VALUE})\s*(?:{_JOULES})?\s+(?:is\s+|was\s+)?lost(?=[\s.]*$))",
    re.IGNORECASE,
)
LOSES = re.compile(
    rf"(^|[,;]|\b{_SO}\b)\s*(?:(?:it|they|both|the\s+(?:ball|sphere|particle|puck|system)|([A-Z]))"
    r"\s+)?(?:loses|lose|has\s+lost|have\s+lost)\s+(?:(?:a\s+total\s+of|about)\s+)?"
    rf"({_VALUE})\s*({_JOULES}|%|per\s?cent\b)?(\s+of\s+(?:(?:its|the|their)\s+)?"
    rf"(?:(?:initial|original|total)\s+)?{_KE})?(?=\s*(?:$|[.,;]|\band\b))",
    re.IGNORECASE,
)
# ``increase in KE of B = 6``, ``B's KE goes down by 12.5 - 6.5 = 6``
CHANGE_IN_ENERGY = re.compile(
    rf"\b(?:(increase|rise)|(?:decrease|reduction|fall|drop))\s+(?:in|of)\s+(?=(?:the\s+)?{_KE}(?![a-z]))",
    re.IGNORECASE,
)
ENERGY_CHANGES_BY = re.compile(
    rf"(^|[,;]|\b{_SO}\b)\s*(?:(?:the\s+)?{_KE}\s+(?:of|for)\s+([A-Z])|([A-Z])['’]?s\s+{_KE})\s+(?:is\s+)?"
    r"(?:(increase[sd]|rises|rose|goes\s+up|went\s+up)"
    r"|(?:decrease[sd]|reduced|falls|fell|drops|dropped|goes\s+down|went\s+down))"
    r"\s+by\s*[:=]?\s*(?=[\d(½.])",
    re.IGNORECASE,
)
KEEPS = re.compile(
    r"(^|[,;]|\bso\b)\s*(?:(?:it|the\s+(?:ball|sphere|particle|puck))\s+)?(?:keeps|retains)\s+"
    rf"({_VALUE})\s*(%|per\s?cent\b)?\s+of\s+(?:(?:its|the)\s+)?(?:(?:initial|original|total)\s+)?"
    rf"{_KE}",
    re.IGNORECASE,
)
# A time, or a way, by a speed: ``2 more in y at 1 m/s = 2 s``, ``3 s at 2 m/s = 6 m``.
_SPEED = r"(\d[\d./]*)\s*(?:m/s|ms\s?\^?-1|m\s?s\s?\^?-1|ms⁻¹|m\s?s⁻¹)"
AT_A_SPEED = re.compile(
    r"(?:\bdistance\s+(?:(?:of|is)\s+)?)?(?<![\w.])(\d[\d./]*)(?:\s*(s|secs?|seconds?)|m)?(?![\w/.])"
    rf"[^=<>\d,;]*\bat\s+{_SPEED}\s*"
    r"(?:=|is|takes?)\s*(?=\d)"
)
# A velocity by its size and direction: ``7.12 m/s at 25.5° to the gate``.
SPEED_AT_AN_ANGLE = re.compile(
    r"^\s*((?:so|hence|therefore|∴)\s+)?(?:(?:the\s+)?(?:speed|velocity)\s*(?:is\s+|[=:]\s*)?)?"
    r"(\d[\d.]*)\s*(?:m\s?/\s?s|m\s?s\s?(?:\^?-1|⁻¹))?,?\s+at\s+(?:an?\s+angle\s+(?:of\s+)?)?"
    r"(\d[\d.]*)\s*(?:°|deg(?:ree)?s?)?\s+(?:to|with|from)\s+(?:the\s+)?([A-Za-z]+)\s*\.?\s*$"
)
SETS_OFF = re.compile(
    r"\b([A-Z])\s+(?:goes|moves|sets|travels|flies|shoots)(?:\s+(?:off|away|on|out))?\s+"
    r"(?:at|with)\s+(?:an?\s+)?(speed\s+(?:of\s+)?)?"
    r"(√?[\d(][\d.()/√]*\s?[a-z]?(?:/[\d√]+)?)(\s*m/s|\s*m\s?s\^?-1|\s*ms⁻¹)?"
    r"(?=\s*(?:$|[.,;]|\band\b))"
)
WHICH_IS = re.compile(
    r",?\s*\b(?:which\s+is|that\s+is|that's|i\.e\.|ie)\s+(\d[\d.]*)\s*%(?=[\s.]*$)", re.IGNORECASE
)
STAGE_BEHIND = re.compile(
    rf"^\s*{_KE}\s+({_VALUE})\s*(?:{_JOULES})?\s+before\s*,?\s*(?:and\s+)?({_VALUE})\s*"
    rf"(?:{_JOULES})?\s+after(?=\s*(?:$|[,;]|{_SO}\b))",
    re.IGNORECASE,
)
CHANGES_TO = re.compile(
    r"(?:^|[,;]|\bso\b)\s*(?:the\s+)?(?:(?:component|comp|velocity|speed|part)\s+)?"
    r"(along|parallel\s+to|perp(?:endicular)?\s+to)\s+(?:the\s+)?(wall|cushion|line\s+of\s+centres)\s+"
    r"(?:changes\s+to|becomes|drops\s+to|is\s+reduced\s+to|is\s+now|stays(?:\s+at)?|remains(?:\s+at)?)"
    r"\s+(?=[-\d√(])",
    re.IGNORECASE,
)
_PART = r"half|an?\s+third|a\s+quarter|double|twice"
_FACTORS = {"half": "1/2", "third": "1/3", "quarter": "1/4", "double": "2", "twice": "2"}
SHARE_OF_BEFORE = re.compile(
    rf"(\d[\d.]*)?\s*([,;]?)\s*(?:and\s+|so\s+)?\b({_PART})\s*(?:of\s+(?:it|this|that)\s*)?"
    r"(?:is|=|gives)\s*(?=\d)",
    re.IGNORECASE,
)
_VECTOR = r"(?:-?\s?[\d./√]*\s?i(?:\s*[-+]\s*[\d./√]*\s?j)?|-?\s?[\d./√]*\s?j)\b"
GOES_AS = re.compile(
    r"\b([A-Z])\s+(?:now\s+)?(?:goes|moves|travels|ends\s+up|comes)"
    rf"(?:\s+(?:off|away))?\s+(?:with|at|as)?\s*(?={_VECTOR}\s*(?:$|[,;.]|and\b|m))"
)
_PAIR = rf"\([^(),=]*,[^(),=]*\)|{_VECTOR}"
VECTOR_FOR = re.compile(
    rf"(^|[,;]|\band\b|\bso\b)\s*({_PAIR})\s+for\s+([A-Z])(?=\s*(?:$|[,;.]|and\b))"
)
TOTAL_IN_JOULES = re.compile(
    r"(?<![\w=])\s*(total)(?:(?=\s*=\s*[^=,;]*\d\s*(?:J|joules?)\b)"
    r"|\s+(?:is\s+|of\s+)?(?=\d[\d./]*\s*(?:J|joules?)[\s.]*$))",
    re.IGNORECASE,
)
IS_A_SHARE = re.compile(
    rf"(?:^|(?<=[,;]))\s*(?:so\s+)?(?:the\s+)?(?:final\s+|new\s+)?{_KE}(?:\s+(?:after|left|now))?\s+is\s+"
    rf"(?:only\s+)?({_VALUE})\s*(%)?\s*of\s+(?:it|this|that|before|the\s+original|what\s+it\s+was"
    r"(?:\s+before)?)(?![\w])",
    re.IGNORECASE,
)
_ENERGY_VALUE = r"[\d./]*\s*[mM]\s*\w?(?:\^2|²)"
# What the components along the line have of the energies: ``along the line: 32mu² at first …``.
ENERGIES_ALONG = re.compile(
    r"\b(along\s+(?:the\s+)?(?:line(?:\s+of\s+centres)?|LOC))\s*[:=]?\s*"
    rf"({_ENERGY_VALUE})\s+(?:at\s+first|before|initially|at\s+the\s+start)\s*(?:,|and|,\s*and)\s*"
    rf"({_ENERGY_VALUE})\s+(?:at\s+last|after|finally|at\s+the\s+end|in\s+the\s+end)",
    re.IGNORECASE,
)
_LOSS = re.compile(r"\b(?:lost|loss|loses)\b", re.IGNORECASE)


def speed_at_an_angle(match: re.Match[str], problem: Problem) -> str:
    """The speed and the angle to the only wall, which has its name or that of the title."""
    start, speed, angle, noun = match.groups()
    walls = [wall.name for wall in problem.walls]
    title = {word.lower() for word in _WORD.findall(problem.title or "")}
    known = noun in walls or noun.lower() in {"wall", "cushion", "barrier", *title}
    if len(walls) != 1 or len(problem.spheres) != 1 or not known:
        return match[0]
    return f"{start or ''}speed = {speed}, angle to wall = {angle}"


def at_a_speed(match: re.Match[str], _: Problem) -> str:
    """A way divided by a speed, or multiplied by a time."""
    return f"{match[1]}{'*' if match[2] else '/'}{match[3]} = "


def changes_to(match: re.Match[str], _: Problem) -> str:
    """The component after an impact in a sentence about what it changes to."""
    start = match[0][:1] if match[0][:1] in ",;" else ""
    return f"{start} component {match[1]} the {match[2]} after = "


def which_is(match: re.Match[str], _: Problem) -> str:
    """The percentage that a loss is: ``lost 0.526 which is 21%``."""
    lost = _LOSS.search(match.string, 0, match.start())
    return f"; percentage lost = {match[1]}%" if lost else match[0]


def stage_behind(match: re.Match[str], _: Problem) -> str:
    """The energies of ``KE 2.5 before, 1.97 after``."""
    return f"KE before = {match[1]}; KE after = {match[2]}"


def listed_energy(match: re.Match[str], _: Problem) -> str:
    """The energy that is meant in a list: *after 13* behind *KE before 25*."""
    known = [amount[0] for amount in _ENERGY.finditer(match.string, 0, match.end())]
    if not known or not _only_lists(match.string[: match.start()]):
        return match[0]
    stage = {"initially": "before", "finally": "after"}.get(match[1].lower(), match[1].lower())
    return f"; {known[-1]} {stage} = {match[2]}"


def listed_loss(match: re.Match[str], _: Problem) -> str:
    """The energy lost at the end of a list of energies."""
    above = match.string[: match.start()]
    if not _LISTED_AFTER.search(above) or not _only_lists(above):
        return match[0]
    return f"; KE lost = {match[1] or match[2]}"


def _only_lists(text: str) -> bool:
    """Whether a text has no words but those of a list of energies."""
    return all(word.lower() in _LISTING for word in _WORD.findall(text))


def loses(match: re.Match[str], problem: Problem) -> str:
    """What a sentence says to be lost: an energy, or a share of one."""
    before, body, value, unit, whole = match.groups()
    spheres = {sphere.name for sphere in problem.spheres}
    if body and body not in spheres:
        return match[0]
    start = "; " if before else ""
    if unit and unit[0] not in "Jj":
        return f"{start}percentage lost = {value}%"
    if unit:
        several = body and len(spheres) > 1
        return f"{start}KE lost{f' by {body}' if several else ''} = {value}"
    if whole:
        return f"{start}fraction lost = {value}"
    return match[0]


def change_in_energy(match: re.Match[str], _: Problem) -> str:
    """A gain, or a loss, by its usual name."""
    return "gain in " if match[1] else "loss in "


def energy_changes_by(match: re.Match[str], problem: Problem) -> str:
    """What a sphere gains, or loses, of its energy."""
    start, name, owner, gain = match.groups()
    body = name or owner
    share = "%" in match.string or "cent" in match.string
    if share or body not in {sphere.name for sphere in problem.spheres}:
        return match[0]
    return f"{start} KE {'gained' if gain else 'lost'} by {body} = "


def energies_along(match: re.Match[str], _: Problem) -> str:
    """The parts of the energies before and after that components along the line have."""
    return f"KE {match[1]} before = {match[2]}, KE {match[1]} after = {match[3]}"


def keeps(match: re.Match[str], _: Problem) -> str:
    """What a sentence says to be kept of an energy."""
    start = "; " if match[1] else ""
    return f"{start}KE after/KE before = {match[2]}{'%' if match[3] else ''}"


def sets_off(match: re.Match[str], problem: Problem) -> str:
    """The speed with which a sphere goes on: a number alone may be an angle."""
    body, speed, value, unit = match.groups()
    spheres = {sphere.name for sphere in problem.spheres}
    of_speed = bool(speed or unit) or any(character.isalpha() for character in value)
    return f"speed of {body} after = {value}" if body in spheres and of_speed else match[0]


def share_of_before(match: re.Match[str], _: Problem) -> str:
    """The half of the number before it, of ``5.774, half is 2.887``; else what it is worth."""
    number, part = match[1], match[3]
    if number is None:
        return f"{match[2]} so "
    return f"{number}; {_FACTORS[part.split()[-1].lower()]} × {number} = "


def goes_as(match: re.Match[str], problem: Problem) -> str:
    """The velocity of a sphere, of ``A goes 3i + 3j``, or where it has come to."""
    if match[1] not in {sphere.name for sphere in problem.spheres}:
        return match[0]
    return f"{match[1]}: " if places_of(match[1], problem) else f"velocity of {match[1]} = "


def vector_for(match: re.Match[str], problem: Problem) -> str:
    """The velocity of a sphere that is named behind it: ``(13/3, 3) for A``."""
    spheres = {sphere.name for sphere in problem.spheres}
    if match[3] not in spheres:
        return match[0]
    return f"{match[1]} velocity of {match[3]} = {match[2]}"


def total_in_joules(match: re.Match[str], _: Problem) -> str:
    """The energy that a total in joules is: one before or after, or what is lost."""
    return "total KE" if match[0].endswith(match[1]) else "total KE = "


def is_a_share(match: re.Match[str], _: Problem) -> str:
    """The share of an energy that is left, of ``KE after is ⅓ of it``."""
    return f"KE after/KE before = {match[1]}{match[2] or ''}"
