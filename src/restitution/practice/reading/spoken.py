"""What is said in a sentence, as the label that it amounts to: ``the 6 becomes 1/4 x 6 = 1.5``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from difflib import SequenceMatcher
from fractions import Fraction

from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    walk,
)
from restitution.practice.reading import (
    amounts,
    attributions,
    back_references,
    components_in_words,
    lines_in_words,
    listed_values,
    mass_centres,
    meetings,
    pairs_in_words,
    right_angles,
    shares,
    walls_in_words,
)
from restitution.practice.reading.characters import Plain
from restitution.practice.reading.usage import letters_of_question
from restitution.problem import Find, Problem, trees_of_step

Put = Callable[[re.Match[str], Problem], str]

_NUMBER = r"\d+(?:\.\d+)?"
_OF_A_SPEED = re.compile(
    rf"\b(?:components?|comp|cpt|part)\s+of\s+([A-Za-z]|{_NUMBER})\s+"
    r"(?=along|parallel|perp|across|in\s+the|normal)",
    re.IGNORECASE,
)
_IT_IS = re.compile(
    r"^(\s*(?:so\s+)?(?:after|before)\s+\w+),?\s+it(?:\s+is|'s|\s+has|\s+moves\s+(?:with|at))\s+"
    r"(?=.*\d[ij]\b)",
    re.IGNORECASE,
)
_BECOMES = re.compile(
    rf"\bthe\s+({_NUMBER})\s+(?:becomes|turns\s+into|changes\s+to|goes\s+to)\s+", re.IGNORECASE
)
# The next of the vectors that a velocity becomes: ``(6, -3) becomes (6, 2) then (-3, 2)``.
_VECTOR = r"\(\s*[-−]?[\d./√]+\s*,\s*[-−]?[\d./√]+\s*\)|[-−]?[\d./√]*i\s*[-+−]\s*[\d./√]*j\b"
_THEN = re.compile(rf"(\bbecomes\s+(?:{_VECTOR}))\s*,?\s*(?:and\s+)?then\s+(?={_VECTOR})")
# What an impulse is only parallel to: ``impulse direction is -3i + 4j``.
_DIRECTION_OF_IMPULSE = re.compile(
    r"\b(?:direction\s+of\s+(?:the\s+)?impulse|impulse\s+(?:is\s+)?(?:in\s+(?:the\s+)?)?direction)"
    r"\s*(?:is|=|:|of)?\s*(?=\(?\s*-?\s*[\d./√]*[ij]\b)",
    re.IGNORECASE,
)
_SPEED_SQUARED = re.compile(
    r"\b(speed(?:\s+(?:of\s+[A-Z]|before|after|initially|finally|afterwards))*)\s+squared\b",
    re.IGNORECASE,
)
# What is said of the part of a velocity along an axis: ``j becomes 1/3 × 9 = 3``, ``i stays -12``.
_AXIS_BECOMES = re.compile(
    r"(^|[,;]|\band\b|\bso\b)\s*(?:the\s+)?([ij])\s+(?:(?:part|bit|component|comp|cpt)\s+)?"
    r"(?:now\s+)?(?:becomes|stays(?:\s+at)?|remains(?:\s+at)?|changes\s+to|goes\s+to|turns\s+into)"
    r"\s+(?=[-−\d(√½⅓¼⅔¾])",
)
_TURNED = re.compile(
    r"\b(?:(?:it(?:'s|’s)?|they|(?:the\s+)?(?:ball|sphere|particle|puck|path))\s+|([A-Z])\s+)?"
    r"(?:(?:is|are|was|gets|has|has\s+been)\s+)?(?:turned|turns|deflected)\s+(?:(?:through|by)\s+)?"
    r"(?:an?\s+(?:total\s+)?angle\s+(?:of\s+)?)?(?:[=:]\s*)?"
    r"(?=\d|\(|(?:arc)?(?:sin|cos|tan))",
    re.IGNORECASE,
)
_AXIS = re.compile(r"(?:^|(?<=[,;:]))\s*([ijy])\s*:(?=\s*[^\s:=<>])(?=[^:]*=)")
_OTHER_AXIS = re.compile(r"(?<=[,;])\s*([ijy])\s*:(?=\s*-?[\d./½]+\s*(?:[,;]|$))")
_AT_AN_END = re.compile(r"\b(KE|Ek|ke)\s+([if])(?=\s*[=:])(?!.*\b(?:KE|Ek|ke)\s+j\b)")
# A relative speed is along the line of centres, whatever vector says so.
_ALONG_A_VECTOR = re.compile(
    r"\b((?:sep|app|closing)\w*(?:\s+speed)?)\s+(?:along|parallel\s+to|in\s+direction(?:\s+of)?)\s+"
    r"\(?-?\s*[\d.]*[ij]\s*[+-]\s*[\d.]*[ij]\)?(?=\s*[:=])",
    re.IGNORECASE,
)
_ENERGY = re.compile(r"(?<![\w'])E\s+(?=(?:lost|loss|before|after|initially|finally)\b)")
_DIRECTION = re.compile(r"(^\s*|[,;]\s*)([A-Z])\s+dir(?:n|ection)?(?=\s*[:=])")
_SHARE = r"\d[\d./]*(?:[A-Za-z]{1,2}(?:\^?2|²)?)*"
_OUT_OF = re.compile(rf"({_SHARE})\s+out\s+of\s+(?:the\s+)?({_SHARE})(?![A-Za-z])", re.IGNORECASE)
_MAKES_AN_ANGLE = re.compile(
    r"(?:\bthe\s+)?\b(wall|line\s+of\s+centres|LOC|[A-Z]\w*)\s+(?:makes|is\s+at|lies\s+at|is)\s+"
    r"(?:(?:an?\s+)?angle\s+(?:of\s+)?|(?<=makes\s)(?=\d))([^,;=]*\d[^,;]*?|\w+)\s+(?:with|to)\s+(?:the\s+)?"
    r"(i|j|horizontal|vertical|[xy][-\s]axis|wall|line\s+of\s+centres|[A-Z]\w*)(?![\w(])"
)
_ANGLE_OF_A_VELOCITY = re.compile(
    r"\b(angle\s+(?:between|of)\s+)([uv])\s+"
    r"(?=(?:and|to|with)\s+(?:the\s+)?(?:[ij]|wall|[A-Z]|LOC|loc|line\s+of\s+centres)\b)"
)
_TIME_TO = re.compile(
    r"\b(time)(?:\s+taken)?\s+(?:for\s+)?(?:([A-Z])\w*\s+|it\s+)?(?:takes?\s+)?(?:to|until|till)\s+"
    r"(?:reach|hit|meet|strike|get\s+to|collide\s+with|catch(?:\s+up(?:\s+with)?)?)\s+"
    r"(?:the\s+)?(wall|[A-Z])\b",
    re.IGNORECASE,
)
_TIME_TO_GO = re.compile(
    r"\btime(?:\s+taken)?\s+(?:for\s+(?:\w+\s+)?)?to\s+(?:go|get|travel|move|come|return|cross)\b"
    r"(?:\s+(?:across|over|back|there|it))?(?=\s*[=:])"
    r"|\btime\s+(?:taken\s+)?for\s+(?:the\s+)?(?:return|way\s+back)(?:\s+\w+)?(?=\s*[=:])",
    re.IGNORECASE,
)
_TIME_OF_EVENT = re.compile(r"\btime\(([1-4])\)(?=\s*[=+\-])")
# What a derivative is of, and that it is one, which no claim says: dy/dt, d/dt(...), d(tan δ)/dα.
_DERIVATIVE = re.compile(
    r"\bd\s*(?:\([^()]*\)|(?:tan\s*)?[A-Za-zα-ω]{0,5})\s*/\s*d\s*(?:[a-zα-ω]|alpha|theta)(?![\w])"
    r"\s*(?:\([^=]*\)|\[[^=]*\])?\s*[=:]"
)
_PART = re.compile(r"\b([ij])[- ]part\b(?=[^:=]*=)")
# The part of a vector, behind which it is worked out as a vector: ``perp part of 5i = ...``.
_PART_OF_A_VECTOR = re.compile(
    r"(?:\b(?:the\s+)?(?:parallel|para?|perp(?:endicular)?|normal|tangential|resolved)\s+)"
    r"(?:part|bit|component|comp|vector)\s+of\s+"
    r"\(?\s*[-−]?[\d./√]*[uU]?[ij](?:\s*[-+−]\s*[\d./√]*[uU]?[ij])?\s*\)?\s*="
    r"(?=[^=]*[ij])",
    re.IGNORECASE,
)
_COUNTED = re.compile(
    r"\b(deflection|loss|energy\s+lost|KE\s+lost|impulse)\s?([1-4])(?=\s*=)", re.IGNORECASE
)
# The velocities at the beginning and at the end, of which an angle is one between.
_FIRST_AND_LAST = re.compile(
    r"\b(?:first|original|starting)\s+and\s+(?:last|final|new)\s+"
    r"(?=velocit|direction|path|vel\b)",
    re.IGNORECASE,
)
_BETWEEN_U_AND_V = re.compile(r"\b(angle\s+between)\s+u\s+and\s+v(?=\s*[=:])", re.IGNORECASE)
_REBOUNDS = re.compile(
    r"(?:\b([A-Z])\s+|\b(?:it|(?:the\s+)?(?:ball|sphere|particle|puck|disc))\s+|(?<![\w\s])\s*|^)"
    r"(?:(?:now|then|will|must|so)\s+)?"
    r"(?:rebounds?|bounces?(?:\s+(?:back|off))?|(?:comes?|goes|travels?|moves?)\s+(?:back|off|away)"
    r"|returns?)"
    r"(?:\s+(?:off|from)\s+(?:the\s+)?(?:wall|cushion|[A-Z]\w*))?\s+(?:with|at)\s+"
    r"(?:an?\s+|the\s+)?(?:speed\s+(?:of\s+)?)?(?=[\du(½⅓¼⅔¾√])(?![^,;=]*(?:°|deg|[αβθφ]))",
)
# The other end of a range: ``f > 1/3 up to 1``.
_UP_TO = re.compile(
    r"(?<![\w])([a-zA-Zα-ω])\s*(>=?|≥)\s*([\d./√]+)\s*,?\s*(?:and\s+|but\s+)?"
    r"(?:up\s+to|at\s+most|(?:no|not)\s+more\s+than)\s+([\d./√]+)(?=[\s.)]*$)"
)
_COORDINATE = re.compile(r"\b([xy])[\s-]*co-?ord(?:inate)?\b(?!s)", re.IGNORECASE)
_SQUARE_ROOT = re.compile(r"\bsq(?:uare)?\.?\s?(?:root|rt)\s*(?:of\s+)?(?=[\d(a-z])", re.IGNORECASE)
_IN_ALL = re.compile(
    r"(?<!\w)(total|altogether)(?=\s*[=:]|\s+[\d½⅓⅔¼¾][\d./]*\s*(?:s(?:ecs?|econds?)?\b|$))",
    re.IGNORECASE,
)
_NAME = r"[A-Za-z](?:_?\w)?"
_IN_UNITS = re.compile(
    rf"(?:[;,(]\s*)?\b(?:where|with|taking)\s+{_NAME}(?:\s*(?:,|and\b|&)\s*{_NAME}){{0,3}}\s+"
    r"(?:(?:are|is|both|all)\s+){0,2}"
    r"(?:in\s+terms\s+of|in\s+units\s+of|(?:as\s+)?multiples\s+of)\s+([A-Za-z])\b\)?"
)
# The same behind an equation: ``6 - 2 = 3v + w (in u)``.
_IN_UNITS_BEHIND = re.compile(
    r"\(\s*(?:all\s+)?in\s+(?:(?:terms|units|multiples)\s+of\s+)?([A-Za-z])(?:'?s)?\s*\)\s*$"
)
_ARGUMENT = re.compile(r"\barg\s*\(?\s*[uvwV](?:_?[A-Z])?\s*\)?(?=\s*=)")
# The title of a ratio: ``angle between 5i and LOC: cosθ = 4/5``.
_TITLE_OF_RATIO = re.compile(
    rf"\bangle\s+between\s+(?:{_VECTOR}|[-−]?\s?[\d./√]*[a-z]?\s?[ij])\s+and\s+(?:the\s+)?"
    r"(?:LOC|loc|line\s+of\s+centres|wall|[ijn]|[A-Z])\s*:\s*(?=(?:cos|sin|tan))"
)
# How far apart centres are, which is no component along them.
_APART = re.compile(r"\b(?:the\s+)?cent(?:re|er)s\s+are\s+[\w./]+\s+apart\b")
_RATIOS = re.compile(r"^\s*(\w{1,4})\s*:\s*(\w{1,4})\s*=\s*([-−]?\s?\d+)\s*:\s*([-−]?\s?\d+)\s*$")
# A formula in words within a chain: J = m × (sum of the speeds) = 2(5 + 3).
_FORMULA = re.compile(
    r"=\s*(?:m|mass)\s*[×x*]?\s*\(?\s*(?:the\s+)?(?:sum|difference|change)\s+(?:of|in)\s+(?:the\s+)?"
    r"(?:[a-z]+\.?\s+){0,2}(?:speeds?|velocit(?:y|ies)|vels?|comp(?:onent)?s?)\s*\)?\s*(?==)",
    re.IGNORECASE,
)
_RATIO_OF = re.compile(r"\b(sin|cos|tan)\s+of\s+(?:the\s+)?(?=angle\b)")
_TANGENT_OF_WALL = re.compile(
    r"\btan\s+(?:of\s+)?(?:the\s+)?(?:wall\s+angle|angle\s+of\s+(?:the\s+)?wall)(?=\s*[=:])"
)
_CHANGE = re.compile(
    r"\bchange\s+(?:in\s+v(?:(?:_?|\s+(?:of|for)\s+)([A-Z]))?|for\s+([A-Z]))(?=\s*=)"
)


def _change_of_velocity(match: re.Match[str], _: Problem) -> str:
    """A change of velocity by its words; a *change for A* alone may be one of momentum too."""
    if match[2]:
        return f"change of {match[2]}"
    return f"change in velocity of {match[1]}" if match[1] else "change in velocity"


def with_labels(line: Plain, problem: Problem) -> Plain:
    """A line in which sentences are labels; the rest is as typed."""
    for pattern, put in _RULES:
        start = 0
        while (match := pattern.search(line.text, start)) is not None:
            text = put(match, problem)
            line = _replaced(line, match, text)
            start = match.start() + max(1, len(text))
    return line


def _replaced(line: Plain, match: re.Match[str], text: str) -> Plain:
    """A line with another text in place of a match; what stands in both keeps its columns."""
    start, end = match.span()
    own = [line.columns[start]] * len(text)
    for there, here, size in SequenceMatcher(None, match[0], text, False).get_matching_blocks():
        own[here : here + size] = line.columns[start + there : start + there + size]
    behind = 0
    for number, group in enumerate(match.groups(), 1):
        place = text.find(group, behind) if group else -1
        if place >= 0:
            behind = place + len(group)
            own[place:behind] = line.columns[match.start(number) : match.end(number)]
    columns = (*line.columns[:start], *own, *line.columns[end:])
    return Plain(line.text[:start] + text + line.text[end:], columns)


def _component(match: re.Match[str], problem: Problem) -> str:
    """The component of a speed: of the sphere that has it at the start, where one has."""
    if match[1] in {sphere.name for sphere in problem.spheres}:
        return match[0]
    speed = _tree(match[1])
    owners = [sphere.name for sphere in problem.spheres if speed in _speeds(sphere.velocity)]
    return f"component of {owners[0]} before " if len(owners) == 1 else "component "


def _turned(match: re.Match[str], problem: Problem) -> str:
    """The deflection of the sphere that is named, or of one."""
    spheres = {sphere.name for sphere in problem.spheres}
    return f" deflection of {match[1]} = " if match[1] in spheres else " deflection = "


def _unit_of_letters(match: re.Match[str], problem: Problem) -> str:
    """A letter of the question as the unit of others: ``where v, w are in terms of u``."""
    return f"; take {match[1]} = 1" if match[1] in letters_of_question(problem) else match[0]


def _after(match: re.Match[str], problem: Problem) -> str:
    """The component along i or j that a number was at the start."""
    units = {
        unit
        for sphere in problem.spheres
        for size, unit in _components(sphere.velocity)
        if size == _tree(match[1])
    }
    return f"{units.pop()} component after is " if len(units) == 1 else " "


def _becoming(match: re.Match[str], _: Problem) -> str:
    """What a vector becomes after the next impact."""
    return f"{match[1]} becomes "


def _tree(text: str) -> Expression:
    return Letter(text) if text.isalpha() else Number(Fraction(text))


def _speeds(velocity: Expression | None) -> Iterator[Expression]:
    if isinstance(velocity, Polar):
        yield velocity.size
    elif velocity is not None:
        yield from (size for size, _ in _components(velocity))


def _components(velocity: Expression | None) -> Iterator[tuple[Expression, str]]:
    """The sizes along i and j as they stand in a velocity."""
    match velocity:
        case Binary("+" | "-", left, right):
            yield from _components(left)
            yield from _components(right)
        case Negate(operand):
            yield from _components(operand)
        case Binary("*", Negate(size) | size, Unit(name)):
            yield size, name


def _direction(match: re.Match[str], problem: Problem) -> str:
    """The direction of a sphere, of ``S dir:``."""
    spheres = {sphere.name for sphere in problem.spheres}
    return f"{match[1]}direction of {match[2]}" if match[2] in spheres else match[0]


def _other_axis(match: re.Match[str], _: Problem) -> str:
    """The other component of a line that works out one: ``i: 2/3 × 3 = 2, j: 2``."""
    first = re.search(r"\b[ijy]\s*(?:direction)?\s*:[^:]*=", match.string[: match.start()])
    return f" {match[1]} direction: " if first else match[0]


def _speed_after(match: re.Match[str], problem: Problem) -> str:
    """The speed with which a sphere rebounds: of ``B rebounds with 2``."""
    spheres = {sphere.name: sphere for sphere in problem.spheres}
    name = match[1] or (next(iter(spheres)) if len(spheres) == 1 else "")
    if name not in spheres:
        return match[0]
    # Of one that comes at an angle the speed away from a wall may be meant.
    whole = match[1] or len(list(_components(spheres[name].velocity))) == 1
    return f"speed of {name} after = " if whole else match[0]


def _in_all(match: re.Match[str], problem: Problem) -> str:
    """The whole time, where the question asks for a time and for no energy."""
    finds = (step for _, step in problem.steps() if isinstance(step, Find))
    asked = {
        node.kind
        for step in finds
        for tree in trees_of_step(step)
        for node in walk(tree)
        if isinstance(node, Quantity)
    }
    timed = "time" in asked and not any("energy" in kind for kind in asked)
    return f"{match[1]} time" if timed else match[0]


def _returns(text: str) -> bool:
    """Whether words tell of a way back."""
    return bool({"back", "return"} & set(text.casefold().split()))


def _at_the_end(match: re.Match[str], _: Problem) -> str:
    """The energy before, or the one after, of ``KE i`` and ``KE f``."""
    return f"{'initial' if match[2] == 'i' else 'final'} KE "


def _names(problem: Problem) -> set[str]:
    """The names of the spheres and walls."""
    return {sphere.name for sphere in problem.spheres} | {wall.name for wall in problem.walls}


def _energy(match: re.Match[str], problem: Problem) -> str:
    """The energy that E is before its moment, where no body has that name."""
    return match[0] if "E" in _names(problem) else "energy "


def _angle(match: re.Match[str], problem: Problem) -> str:
    """The angle of what a sentence begins with to what it ends with."""
    known = {"wall", "LOC", "i", "j"} | _names(problem)
    subject, value, other = match.groups()
    if not all(name in known or len(name) > 3 for name in (subject, other)):
        return match[0]
    axis = {"h": "i", "x": "i", "v": "j", "y": "j"}.get(other[0], other)
    return f"angle of {subject} to {axis} = {value}"


def _of_a_velocity(match: re.Match[str], problem: Problem) -> str:
    """The velocity that a letter is, of the only sphere or of the one with its speed."""
    when = "before" if match[2] == "u" else "after"
    if len(problem.spheres) == 1:
        return f"{match[1]}velocity {when} "
    speed = _tree(match[2])
    owners = [sphere.name for sphere in problem.spheres if speed in _speeds(sphere.velocity)]
    return f"{match[1]}velocity of {owners[0]} {when} " if len(owners) == 1 else match[0]


def _of_both(match: re.Match[str], problem: Problem) -> str:
    """The angle between the velocities before and after of the only sphere."""
    known = len(problem.spheres) == 1
    return f"{match[1]} initial and final velocities" if known else match[0]


_ORDINALS = ("first", "second", "third", "fourth")
_RULES: tuple[tuple[re.Pattern[str], Put], ...] = (
    (attributions.COMES_WITH, attributions.comes_with),
    (attributions.LEAVES_WITH, attributions.leaves_with),
    (attributions.HAS_VECTOR, attributions.has_vector),
    (attributions.TWO_VECTORS, attributions.two_vectors),
    (attributions.CHANGE_BEHIND, lambda match, _: match[1]),
    (attributions.FORMULA, lambda _, __: ""),
    (attributions.SPEEDS, attributions.speeds),
    (attributions.LOSES_WORKED, attributions.loses_worked),
    (attributions.SHORT_DEFLECTION, lambda _, __: "deflection"),
    (attributions.RESULTANT, attributions.resultant),
    (attributions.LOST_BEHIND, lambda match, _: match[1]),
    (attributions.TOTAL, attributions.total),
    (attributions.IN_TOTAL, lambda match, _: f"total KE lost = {match[1]}"),
    (right_angles.SCALAR_PRODUCT, right_angles.scalar_product),
    (right_angles.OF_PAIRS, right_angles.of_pairs),
    (attributions.OF_SIZE, lambda match, _: f"{match[1]} = "),
    (attributions.TURN, lambda _, __: "deflection"),
    (attributions.LISTED_COMPONENTS, lambda _, __: ""),
    (components_in_words.KE_ALONG, components_in_words.energy_along),
    (components_in_words.RESOLVED, lambda match, _: f"{match[1]}: "),
    (components_in_words.SPEED_TIMES, lambda match, _: f"{match[1]} * "),
    (components_in_words.WAY_BEHIND, components_in_words.way_behind),
    (components_in_words.BY_SQUARES, components_in_words.by_squares),
    (components_in_words.STAYS, components_in_words.stays),
    (components_in_words.HAS_ALONG, components_in_words.has_along),
    (components_in_words.OF_A_BODY_ALONG, components_in_words.of_a_body_along),
    (components_in_words.HAS_A_WAY, components_in_words.has_a_way),
    (components_in_words.GOES_BACK, components_in_words.goes_back),
    (amounts.STAGE_BEHIND, amounts.stage_behind),
    (amounts.LISTED_ENERGY, amounts.listed_energy),
    (meetings.HAS_AFTER, meetings.has_after),
    (meetings.MEETS_IF, meetings.meets_if),
    (amounts.WHICH_IS, amounts.which_is),
    (amounts.LISTED_LOSS, amounts.listed_loss),
    (amounts.LOSES, amounts.loses),
    (amounts.CHANGE_IN_ENERGY, amounts.change_in_energy),
    (amounts.ENERGY_CHANGES_BY, amounts.energy_changes_by),
    (amounts.ENERGIES_ALONG, amounts.energies_along),
    (amounts.KEEPS, amounts.keeps),
    (amounts.SPEED_AT_AN_ANGLE, amounts.speed_at_an_angle),
    (amounts.AT_A_SPEED, amounts.at_a_speed),
    (amounts.SETS_OFF, amounts.sets_off),
    (amounts.IS_A_SHARE, amounts.is_a_share),
    (amounts.SHARE_OF_BEFORE, amounts.share_of_before),
    (amounts.GOES_AS, amounts.goes_as),
    (amounts.VECTOR_FOR, amounts.vector_for),
    (amounts.TOTAL_IN_JOULES, amounts.total_in_joules),
    (amounts.CHANGES_TO, amounts.changes_to),
    (back_references.SHARE_OF_IT, back_references.share_of_it),
    (back_references.STAYS_BEHIND, lambda _, __: ", unchanged"),
    (back_references.BEFORE_A_STAY, lambda match, _: f"{match[1]}at "),
    (_OF_A_SPEED, _component),
    (_IT_IS, lambda match, _: f"{match[1]} the velocity is "),
    (_BECOMES, _after),
    (_THEN, _becoming),
    (listed_values.ARROW, listed_values.from_one_to_another),
    (listed_values.STAGE_BEFORE_A_NAME, listed_values.stage_before_a_name),
    (listed_values.BY_NUMBER, listed_values.by_number),
    (listed_values.TWO_BODIES, lambda match, _: f"{match[1]}, "),
    (listed_values.HEADING_IS, lambda match, _: f"{match[1]}: "),
    (listed_values.AFTER_A_WALL, listed_values.after_a_wall),
    (listed_values.OF_BODIES, listed_values.of_bodies),
    (listed_values.LINE_BEHIND, listed_values.line_behind),
    (listed_values.LINE_ALONE, listed_values.line_alone),
    (listed_values.NORMAL_BEHIND, listed_values.normal_behind),
    (lines_in_words.LINE_OF_CENTRES, lines_in_words.line_of_centres),
    (lines_in_words.UNIT_ALONG_IMPULSE, lines_in_words.line_of_centres),
    (lines_in_words.UNIT_ALONE, lambda _, __: ""),
    (_DIRECTION_OF_IMPULSE, lambda _, __: "impulse is parallel to "),
    (_SPEED_SQUARED, lambda match, _: f"{match[1]} ^2"),
    (pairs_in_words.COMPONENTS, pairs_in_words.components),
    (pairs_in_words.BEFORE_AND_AFTER, pairs_in_words.before_and_after),
    (pairs_in_words.AFTER_A_LABEL, pairs_in_words.before_and_after),
    (pairs_in_words.MOMENT_BEHIND, pairs_in_words.moment_behind),
    (pairs_in_words.EACH_BEHIND, pairs_in_words.before_and_after),
    (pairs_in_words.EACH_IN_FRONT, pairs_in_words.before_and_after),
    (mass_centres.OF_BOTH, mass_centres.of_both),
    (mass_centres.BOTH_BEHIND, mass_centres.of_both),
    (mass_centres.OF_ONE, mass_centres.of_one),
    (mass_centres.NAMED, mass_centres.named),
    (mass_centres.OF_CENTRE, mass_centres.of_centre),
    (walls_in_words.LIES_ACROSS, walls_in_words.lies_across),
    (walls_in_words.LIES_ALONG, walls_in_words.lies_along),
    (walls_in_words.ANGLE_OF_A_LINE, walls_in_words.lies_at),
    (walls_in_words.LIES_AT, walls_in_words.lies_at),
    (walls_in_words.NORMAL, walls_in_words.normal),
    (walls_in_words.GRADIENT, walls_in_words.gradient),
    (walls_in_words.GRADIENT_OF_IMPULSE, walls_in_words.gradient_of_impulse),
    (walls_in_words.IMPULSE_HAS_GRADIENT, walls_in_words.gradient_of_impulse),
    (walls_in_words.GRADIENTS_OF_PERPENDICULARS, lambda _, __: ""),
    (walls_in_words.TO_A_WALL, walls_in_words.to_a_wall),
    (walls_in_words.HITS_AT, walls_in_words.hits_at),
    (walls_in_words.SQUARED_THEN, lambda match, _: f"{match[1]} ^2"),
    (walls_in_words.SQUARED_WAY, lambda match, _: f"{match[1]} component ^2"),
    (_AXIS_BECOMES, lambda match, _: f"{match[1]} {match[2]} component after = "),
    (_TURNED, _turned),
    (_AXIS, lambda match, _: f" {match[1]} direction: "),
    (_OTHER_AXIS, _other_axis),
    (_AT_AN_END, _at_the_end),
    (_ALONG_A_VECTOR, lambda match, _: match[1]),
    (_ENERGY, _energy),
    (_DIRECTION, _direction),
    (_OUT_OF, lambda match, _: f"({match[1]})/({match[2]})"),
    (_MAKES_AN_ANGLE, _angle),
    (_ANGLE_OF_A_VELOCITY, _of_a_velocity),
    (_TIME_TO, lambda match, _: f"time for {match[2] or 'it'} to {match[3]}"),
    (_TIME_TO_GO, lambda match, _: "time back" if _returns(match[0]) else "time"),
    (_TIME_OF_EVENT, lambda match, _: f"time of {_ORDINALS[int(match[1]) - 1]} impact "),
    (_DERIVATIVE, lambda _, __: "derivative: "),
    (_PART, lambda match, _: f"{match[1]} component"),
    (_PART_OF_A_VECTOR, lambda _, __: ""),
    (_COUNTED, lambda match, _: f"{match[1]} of the {_ORDINALS[int(match[2]) - 1]} impact"),
    (_FIRST_AND_LAST, lambda _, __: "initial and final "),
    (_BETWEEN_U_AND_V, _of_both),
    (_SQUARE_ROOT, lambda _, __: "root "),
    (_UP_TO, lambda match, _: f"{match[4]} >= {match[1]} {match[2]} {match[3]}"),
    (_COORDINATE, lambda match, _: f"{'ij'['xy'.index(match[1].lower())]} component of position"),
    (_REBOUNDS, _speed_after),
    (_IN_ALL, _in_all),
    (_APART, lambda _, __: ""),
    (_RATIOS, lambda match, _: f"{match[1]}/({match[2]}) = ({match[3]})/({match[4]})"),
    (_IN_UNITS, _unit_of_letters),
    (_IN_UNITS_BEHIND, _unit_of_letters),
    (_ARGUMENT, lambda _, __: "angle"),
    (_TITLE_OF_RATIO, lambda _, __: ""),
    (shares.SHARE_KEPT, lambda _, __: "KE after/KE before = "),
    (shares.SIZE_OF_A_VECTOR, shares.size_of_a_vector),
    (shares.SHARE_OF_ENERGY, shares.share_of_energy),
    (shares.LOST, shares.lost),
    (shares.ENERGY_OF_A_BODY, shares.energy_of_a_body),
    (shares.AT_THE_ENDS, shares.at_the_ends),
    (shares.HUNDREDTHS, shares.hundredths),
    (shares.FRACTION_OF, lambda match, _: f"{match[1]} = "),
    (shares.NET, lambda match, _: "" if match.string[match.end() :][:2] == "im" else "total "),
    (shares.DISTANCE, shares.distance),
    (shares.SHARE_LOST_IS, shares.share_lost_is),
    (shares.SO_LOST, shares.so_lost),
    (shares.SPEEDS, shares.speeds_of_bodies),
    (shares.ROOT_OF_A_BODY, shares.root_of_a_body),
    (shares.AT_A_WALL, shares.at_a_wall),
    (_FORMULA, lambda _, __: ""),
    (_TANGENT_OF_WALL, lambda _, __: "gradient of wall"),
    (_RATIO_OF, lambda match, _: f"{match[1]} "),
    (_CHANGE, _change_of_velocity),
)
