"""Answers alone: a value given for what is asked, right or as if a mistake had been made."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from restitution.errors import StatementError
from restitution.expression.tree import Expression, Letter, Name, Quantity, Stage, is_quantity, walk
from restitution.practice.judgement import Accuracy, JudgedLine, Judgement
from restitution.practice.judging.bench import Bench, bench_of
from restitution.practice.judging.judging import judge
from restitution.practice.marking.values import Values
from restitution.practice.reading.lines import text_of
from restitution.practice.reading.working import read_working
from restitution.practice.script import Claim, Link
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import UnvaluedError
from restitution.practice.worlds.world import World
from restitution.problem import Problem, Value
from restitution.records import dataclass
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution
from restitution.solving.solver import solve

if TYPE_CHECKING:
    from restitution.practice.marking.objects import AnswerMarkObject

_GRADES: tuple[Accuracy, ...] = ("exact", "rounded", "coarse")
_LONGEST = 200


@dataclass(frozen=True)
class AnswerMark:
    """The value that a student gives for an item.

    ``accuracy`` tells how exactly it is right, None where it is not. ``as_if`` names the mistakes
    that lead to it, none where it is right.
    """

    item: str
    value: str
    right: bool
    accuracy: Accuracy | None = None
    as_if: tuple[str, ...] = ()
    part: str | None = None

    def json(self) -> AnswerMarkObject:
        """As plain data; ``as_if`` is one name, a list where several lead to it, or null."""
        names: str | list[str] | None = list(self.as_if) or None
        if names is not None and len(names) == 1:
            names = names[0]
        return {
            "item": self.item,
            "value": self.value,
            "right": self.right,
            "accuracy": self.accuracy,
            "as_if": names,
        }


def answers_of(
    solved: PartSolution, judgement: Judgement, values: Values, bench: Bench
) -> Iterator[AnswerMark]:
    """The last value that a working gives for each item of its part."""
    for item in solved.items:
        if not isinstance(item.item, Value):
            continue
        last = _last(item.item.expression, judgement.lines, values)
        if last is None:
            continue
        line, value = last
        asked, place = item.item.expression, judgement.lines.index(line) + 1
        open_ = values.leaves_open(asked, line)
        open_ = open_ and not values.is_decided_below(asked, judgement.lines[place:])
        right = line.verdict in ("true", "unsupported") and not open_
        names: tuple[str, ...] = ()
        if not right:
            link = replace(line.line.links[-1], readings=(Claim(value, "=", value),))
            names = tuple(_leading(item.item.expression, value, link, bench))
        yield AnswerMark(item.text, text_of(value), right, line.accuracy, names, solved.part.label)


def mark_answers(
    question: Problem | Solution, answers: Sequence[str], part: str | None = None
) -> tuple[AnswerMark, ...]:
    """Answers such as ``speed(P) = 4.51`` or ``speed of P is 4.51``, each of an item that is asked;
    a value alone where one thing is asked.

    Raises StatementError for what is no answer to an item that is asked, and the error of a
    question that has no answer.
    """
    solution = question if isinstance(question, Solution) else solve(question)
    benches = [bench_of(solution, label) for label in solution.parts if part in (None, label)]
    return tuple(_marked(answer, benches) for answer in answers)


def _marked(answer: str, benches: Sequence[Bench]) -> AnswerMark:
    asked, value = _sides(answer)
    items = [
        (item, item.item.expression, bench)
        for bench in reversed(benches)
        for item in bench.solved.items
        if isinstance(item.item, Value)
    ]
    known = ", ".join(item.text for bench in benches for item in bench.solved.items)
    if not value or len(answer) > _LONGEST or (not asked and len(items) != 1):
        which = f"; asked: {known}" if known else ""
        raise StatementError(
            f"the answer {answer[:60]!r} does not tell what it is: an answer is such as "
            f"speed(P) = 4.51{which}"
        )
    for item, expression, bench in items:
        if not asked or _plain(item.text) == _plain(asked):
            return _judged(item, expression, value, bench)
    for item, expression, bench in items:
        if item is _meant(asked, value, bench):
            return _judged(item, expression, value, bench)
    raise StatementError(f"{asked!r} is not asked; asked: {known or 'nothing'}")


def _sides(answer: str) -> tuple[str, str]:
    """What an answer is of, and its value: ``speed of A is 4.5``; a value alone is of nothing."""
    for sign in ("=", " is ", ":"):
        asked, between, value = answer.partition(sign)
        if between and (sign != ":" or any(map(str.isalpha, asked))):  # 3:4 is a ratio
            return asked.strip(), value.strip()
    return "", answer.strip()


def _meant(asked: str, value: str, bench: Bench) -> ItemResult | None:
    """The item that a phrase or a letter means, as a working would; None where none or several.

    A letter v with the name of a body is its speed or velocity, whichever is asked.
    """
    script = read_working([f"{asked} = {value}"], bench.problem)
    meanings = judge(bench.solution, script, bench.solved.part.label).letters
    for quantity in (meaning.quantity for meaning in meanings):
        if not isinstance(quantity, Quantity):
            continue
        bodies = {node.name for node in walk(quantity) if isinstance(node, Name)}
        if not all(name.casefold() in asked.casefold() for name in bodies):
            continue  # of which body it is was only guessed
        alike = [item for item in bench.solved.items if _is_alike(item, quantity)]
        exact = [item for item in alike if _stage(item) == quantity.stage]
        for chosen in (exact, alike):
            if len(chosen) == 1:
                return chosen[0]
    motions = [
        item
        for item in bench.solved.items
        if isinstance(item.item, Value)
        and is_quantity(item.item.expression, "speed", "velocity")
        and isinstance(body := item.item.expression.arguments[0], Name)
        and _plain(asked).replace("_", "") == f"v{body.name}".casefold()
    ]
    return motions[0] if len(motions) == 1 else None


def _is_alike(item: ItemResult, quantity: Quantity) -> bool:
    """Whether an item is of the kind and the bodies of a quantity, whenever that is."""
    if not isinstance(item.item, Value) or not isinstance(item.item.expression, Quantity):
        return False
    asked = item.item.expression
    return (asked.kind, asked.arguments) == (quantity.kind, quantity.arguments)


def _stage(item: ItemResult) -> Stage:
    expression = item.item.expression if isinstance(item.item, Value) else None
    return expression.stage if isinstance(expression, Quantity) else None


def _plain(text: str) -> str:
    return "".join(text.split()).casefold()


def _judged(item: ItemResult, asked: Expression, typed: str, bench: Bench) -> AnswerMark:
    if item.error is not None:
        raise item.error
    link = _read(typed, bench.problem)
    grade = _grade(asked, link, bench.worlds)
    several = any(claim.others for claim in link.readings)
    names = () if grade or several else tuple(_leading(asked, None, link, bench))
    return AnswerMark(item.text, typed, grade is not None, grade, names, bench.solved.part.label)


def _read(typed: str, problem: Problem) -> Link:
    """The value of an answer, in every sensible reading, as the right side of a claim."""
    (line,) = read_working([f"x = {typed}"], problem).lines or (None,)
    if line is None or not line.links:
        fault = "" if line is None or line.fault is None else f": {line.fault}"
        raise StatementError(f"the value {typed!r} cannot be read{fault}")
    return line.links[-1]


def _grade(asked: Expression, link: Link, worlds: Sequence[World]) -> Accuracy | None:
    """How exactly a value is right in one of the worlds; None where it is in none.

    Of several, ``9 or 10``, each has to be the value in one of the worlds.
    """
    grades: list[Accuracy] = []
    for claim in link.readings:
        by_value = [
            [grade for world in worlds if (grade := _agrees(Claim(asked, "=", x), link, world))]
            for x in (claim.right, *claim.others)
        ]
        if all(by_value):
            grades += [grade for of_value in by_value for grade in of_value]
    return min(grades, key=_GRADES.index, default=None)


def _agrees(claim: Claim, link: Link, world: World) -> Accuracy | None:
    try:
        return agrees(claim, world, {}, link.decimals)
    except UnvaluedError:
        return None


def _leading(
    asked: Expression, value: Expression | None, link: Link, bench: Bench
) -> Iterator[str]:
    """The mistakes in whose world an item has the value of a link."""
    if value is not None and isinstance(value, Letter):
        return
    seen: set[str] = set()
    for variant in bench.names.variants:
        if variant.mistake in seen:
            continue
        for base in bench.worlds:
            if variant.laws and variant.alteration.solvable:
                world = bench.names.altered(base, variant)
                claims = [Claim(asked, "=", claim.right) for claim in link.readings]
                hit = world is not None and any(_agrees(c, link, world) for c in claims)
            else:
                hit = any(
                    result.quantity == asked
                    and any(
                        _agrees(Claim(result.value, "=", claim.right), link, base)
                        for claim in link.readings
                    )
                    for result in variant.results
                )
            if hit:
                seen.add(variant.mistake)
                yield variant.mistake
                break


def _last(
    asked: Expression, lines: Sequence[JudgedLine], values: Values
) -> tuple[JudgedLine, Expression] | None:
    for line in reversed(lines):
        if line.verdict in ("remark", "unread"):
            continue
        value = values.value_of(asked, line)
        if value is not None:
            return line, value
    return None
