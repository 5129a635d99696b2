"""Messages about lines: short, about the line and not the person, one thing at a time.

Levels: 0 says nothing, 1 names the principle, 2 asks a question, 3 names the mistake and what it
leads to, 4 gives the line itself. A true line gets no words unless it wants some.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from restitution.explaining.lines.trees import exchanged
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS, SLIPS
from restitution.expression.tree import Expression, Letter, Quantity, letter_nodes, walk
from restitution.practice.judgement import JudgedLine, Use, false_roots
from restitution.practice.judging.judged_link import REPEATED
from restitution.practice.letters.wordings import words_in_hints, words_of
from restitution.practice.marking import next_steps
from restitution.practice.marking.marks import PointMark
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.marking.values import Values
from restitution.practice.reading.lines import text_of
from restitution.problem import Find, Impact, Problem, Value
from restitution.records import dataclass

LEVELS = (0, 1, 2, 3, 4)

_PRINCIPLES: Mapping[str, str] = {
    "momentum": "conservation of momentum along the line of centres",
    "restitution": "Newton's experimental law",
    "unchanged": "the component that the impact does not change",
    "impulse": "the impulse as a change of momentum",
    "energy": "kinetic energy",
    "angle": "an angle between directions",
    "direction": "a direction of motion",
    "deflection": "the angle of deflection",
    "speed": "a speed from its components",
    "velocity": "a velocity from its components",
    "fact": "what the question gives",
    "arithmetic": "arithmetic",
}

_MISFITS: Mapping[str, str] = {
    "momentum": "One term does not fit.",
    "restitution": "One term, or the place of e, does not fit.",
    "unchanged": "The two sides are not the same component.",
    "impulse": "The difference does not fit.",
    "energy": "One term does not fit.",
    "deflection": "The angles are not put together as the path turns.",
    "arithmetic": "The two sides do not agree.",
}

_QUESTIONS: Mapping[str, str] = {
    "deflection-is-after": "Between which two directions is the angle of deflection?",
    "deflection-difference": "Which way did it move before, and which way after? Draw both "
    "arrows from one point.",
    "restitution-parallel": "In which direction does the wall, or the other sphere, push?",
    "restitution-whole-speed": "Which component of the velocity does the impulse change?",
    "restitution-inverted": "Which is larger, the speed of approach or that of separation? On "
    "which side does e stand?",
    "restitution-omitted": "What does e do in this impact?",
    "momentum-sign": "Which way is each sphere moving? What does that do to the signs?",
    "restitution-sign": "Which way does each sphere move along the line? Is the speed of "
    "approach a sum or a difference?",
    "impulse-sign": "Does the component keep its direction? What does that do to the change?",
    "speed-for-component": "Which component of the velocity lies along the line of centres?",
    "sine-cosine": "Which side of the triangle lies beside the angle?",
    "angle-from-normal": "From which line is the angle measured?",
    "across-exchanged": "Is there a force across the line of centres?",
    "across-changed": "Is there a force in this direction? The surfaces are smooth.",
    "mass-omitted": "What is momentum the product of?",
    "masses-exchanged": "Whose mass goes with which velocity?",
    "energy-of-difference": "Is the square of a difference the difference of the squares?",
    "energy-one-sphere": "Whose kinetic energy changes?",
    "energy-fraction-of-line": "A fraction of which energy is asked for?",
    "energy-component-missing": "Which components does the kinetic energy need?",
    "energy-ratio-as-speed": "How does kinetic energy depend on the speed?",
    "energy-conserved": "Is kinetic energy conserved when e is less than 1?",
    "energy-no-half": "What is the formula of kinetic energy?",
    "square-not-taken": "Is every term squared that has to be?",
    "impulse-of-speeds": "Is the change of a velocity the change of its size?",
    "second-wall-angle": "What angle does the path make with this wall?",
    "rounding-early": "How many figures does this value have?",
    "sign": "Check the signs, one after the other.",
    "arithmetic": "Work this out once more.",
    "algebra": "Compare this line with the one above, term by term.",
    "misread": "Read the numbers of the question once more.",
    "calculator": "Is the calculator set to degrees?",
    "root": "A square has two roots. Which of them is meant?",
    "copied": "Compare this line with the one that it was copied from.",
}


@dataclass(frozen=True)
class Message:
    """Words on a line, at a level of hints; ``line`` None is a hint for the whole."""

    line: int | None
    level: int
    text: str


@dataclass(frozen=True)
class _Words:
    """Quantities in the student's letters, or else in words."""

    values: Values
    problem: Problem

    def put(self, side: Expression) -> Expression:
        names: dict[Expression, Expression] = {}
        for node in walk(side):
            if isinstance(node, Quantity) and not _is_inside(node, side):
                words = Letter(words_in_hints(node, self.problem))
                names[node] = self.values.letter_of(node) or words
        return exchanged(side, names)


def _is_inside(quantity: Quantity, tree: Expression) -> bool:
    """Whether a quantity stands only within others: the velocity of which a component is taken."""
    return any(
        isinstance(node, Quantity) and node != quantity and quantity in walk(node)
        for node in walk(tree)
    )


def messages_of(
    lines: Sequence[JudgedLine],
    points: Sequence[PointMark],
    values: Values,
    levels: Mapping[int | None, int],
    usual: int,
    problem: Problem,
) -> Iterator[Message]:
    """The messages on a working: ``levels`` by line, and the ``usual`` one for all others."""
    accused: int | None = None
    words = _Words(values, problem)
    roots = false_roots(lines)
    for line in lines:
        number = line.line.number
        level = levels.get(number, usual)
        if level == 0:
            continue
        text = _of_line(line, points, words, level, roots)
        if text:
            yield Message(number, level, text)
        if line.verdict == "false" and accused is None:
            accused = number
    level = levels.get(None, usual)
    if level and accused is None and lines:
        text = _next_step(points, words, level)
        if text:
            yield Message(None, level, text)


def _of_line(
    line: JudgedLine,
    points: Sequence[PointMark],
    letters: _Words,
    level: int,
    roots: Mapping[int, frozenset[int]],
) -> str | None:
    match line.verdict:
        case "true":
            return _of_true(line)
        case "follows":
            return _following(sorted(roots[line.line.number]), line.remark)
        case "unread":
            if line.remark:
                return line.remark
            where = "" if line.line.column is None else f", column {line.line.column}"
            return f"This could not be read{where}: {line.line.fault or 'a relation is expected'}."
        case "unsupported":
            return "This does not follow from your lines above."
        case "false":
            return _of_mistake(line, points, letters, level)
    return None


def _of_true(line: JudgedLine) -> str | None:
    if line.accuracy == "coarse":
        return "True, but keep more figures until the end."
    return line.remark if line.remark and " " in line.remark else None


def _following(mistakes: Sequence[int], remark: str | None) -> str:
    if not mistakes:
        return "Right, with your values."
    where = " and ".join(str(number) for number in mistakes)
    if remark == REPEATED:
        return f"This has the mistake of line {where} once more."
    is_in = "mistakes are in lines" if len(mistakes) > 1 else "mistake is in line"
    impossible = f" {remark}" if remark and " " in remark else ""
    return f"Right, with your values.{impossible} The {is_in} {where}."


def _of_mistake(line: JudgedLine, points: Sequence[PointMark], letters: _Words, level: int) -> str:
    principle = _principle(line)
    if level == 1:
        if principle is None:
            return "This does not hold, and does not follow from the lines above."
        misfit = _MISFITS.get(principle, "It does not fit.")
        return f"This is {_PRINCIPLES[principle]}. {misfit}"
    mistake = line.mistake
    name = mistake.id if mistake is not None else None
    if level == 2:
        default = "Which law is this, and what does each term stand for?"
        return _QUESTIONS.get(name or "", default)
    if level == 3 and mistake is not None:
        return (
            _named(line, letters.problem)
            or "It is not clear which mistake this is; compare each term."
        )
    right = _right_line(line, points, letters)
    if right is None:
        return _named(line, letters.problem) or "Compare each term with the diagram."
    return f"The line is {right}."


def _principle(line: JudgedLine) -> str | None:
    return next((use.principle for use in line.uses if use.principle in _PRINCIPLES), None)


def _named(line: JudgedLine, problem: Problem) -> str | None:
    """The name of a mistake, and what it leads to."""
    mistake = line.mistake
    if mistake is None:
        return None
    if mistake.id is None and mistake.also:
        titles = [_title(name) for name in mistake.also]
        return f"Either {' or '.join(titles)}."
    named = MISCONCEPTIONS.get(mistake.id or "")
    slip = SLIPS.get(mistake.id or "")
    if named is None and slip is None:
        return None
    text = named.sentence if named is not None else slip.sentence if slip is not None else ""
    if mistake.at:
        text += f" Check where you write {mistake.at}."
    if mistake.leads_to:
        asked = _asked_in_words(problem)
        values = ", ".join(
            f"{asked.get(what, what)} = {value}" for what, value in mistake.leads_to.items()
        )
        text += f" It leads to {values}."
    if named is not None:
        text += f" {named.consequence}"
    return text


def _asked_in_words(problem: Problem) -> dict[str, str]:
    """The quantities that are asked for in words, by the text that asks for them."""
    return {
        item.text: words_of(item.expression, problem)
        for _, step in problem.steps()
        if isinstance(step, Find)
        for item in step.items
        if isinstance(item, Value) and isinstance(item.expression, Quantity)
    }


def _title(name: str) -> str:
    record = MISCONCEPTIONS.get(name) or SLIPS.get(name)
    title = record.title if record is not None else name
    return title[0].lower() + title[1:]


def _right_line(line: JudgedLine, points: Sequence[PointMark], letters: _Words) -> str | None:
    """The line of the scheme for the principle of a line, in the student's letters."""
    use = next(iter(line.uses), None)
    if use is None:
        return None
    point = next((point.point for point in points if _serves(point.point, use)), None)
    return None if point is None else _written(point, letters)


def _serves(point: MarkPoint, use: Use) -> bool:
    return (
        point.principle == use.principle
        and point.link is not None
        and use.event in (None, point.event)
    )


def _written(point: MarkPoint, words: _Words) -> str | None:
    """The line of a point, with the student's letters for their quantities, others in words."""
    if point.link is None:
        return None
    left, right = (words.put(side) for side in (point.link.left, point.link.right))
    sides = (left, right)
    if any(
        " " in letter.name for side in sides for letter in letter_nodes(side) if letter is not side
    ):
        return None  # words in the middle of a formula are no line
    sign = {"<=": "≤", ">=": "≥", "!=": "≠"}.get(point.link.sign, point.link.sign)
    return f"{text_of(left)} {sign} {text_of(right)}"


def _next_step(points: Sequence[PointMark], letters: _Words, level: int) -> str | None:
    """First a question, then the principle that is missing, what it says, and its equation."""
    missing = next(
        (
            point.point
            for point in points
            if point.state != "earned" and point.point.letter in "MB" and point.line is None
        ),
        None,
    )
    if missing is None or missing.principle not in _PRINCIPLES:
        return None
    principle = missing.principle
    used = f"You have not used {_PRINCIPLES[principle]} yet."
    if level == 1:
        return _at(missing, letters.problem, next_steps.QUESTIONS.get(principle, used))
    if level == 2:
        return used
    written = _written(missing, letters) if level >= LEVELS[-1] else None
    if written is not None:
        return f"The next line is {written}."
    law = next_steps.LAWS.get(principle)
    return used if law is None else f"{used} {_at(missing, letters.problem, law)}"


def _at(point: MarkPoint, problem: Problem, text: str) -> str:
    """A text about an impact, in the words for a wall or for two spheres."""
    events = problem.events
    event = events[point.event - 1] if point.event and point.event <= len(events) else None
    if isinstance(event, Impact):
        walls = {wall.name for wall in problem.walls}
        directions = next_steps.AT_A_WALL if event.second in walls else next_steps.OF_SPHERES
        return text.format(**directions)
    return text.format(**(next_steps.AT_A_WALL if problem.walls else next_steps.OF_SPHERES))
