"""Correct scripts, derived from workings of the planner as students vary them.

Letters get other names, senses are turned, terms moved, sides exchanged, equations multiplied
through, values rounded to three figures, independent lines exchanged, lines left out, words put in
front: what comes is true all the same.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from random import Random

import numpy as np
import sympy as sp
from handwriting import Hand

import restitution
from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Relation,
    of_part,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    letters,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.planning.planner import plan
from restitution.practice.reading.working import MAX_LENGTH
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Impact
from restitution.solving.equations.solution import Solution

POOL = "vwpqabchrsynzfkdtVWTH"
NEEDED = frozenset({"law", "define", "answer", "shown", "value", "fact", "let", "roots", "reject"})
ANNOUNCED = ("", "", "", "so ", "hence ", "(1) ", "=> ", "therefore ", "now ", "also ", "we get ")
LAWS = {"momentum": ("CLM: ", "PCLM ", "momentum: "), "restitution": ("NEL: ", "NLR: ")}
_SIGNS = frozenset({"perpendicular to", "≈"})
_NO_NUMBER = (RestitutionError, ArithmeticError, LookupError, TypeError, ValueError, AttributeError)
Row = tuple[Line, Relation]
Senses = dict[tuple[str, Expression], Expression]


@dataclass(frozen=True)
class DerivedScript:
    """A correct script; ``whole`` tells that nothing was left out that earns marks."""

    statement: str
    part: str | None
    letters: Mapping[str, str]
    lines: tuple[str, ...]
    whole: bool

    @property
    def working(self) -> str:
        return "\n".join(self.lines)


@cache
def planned(statement: str, route: int = 1) -> tuple[Solution, Derivation]:
    if route > 1:
        solution, _ = planned(statement)
        return solution, plan(solution, route)
    solution = restitution.solve(restitution.parse(statement))
    return solution, plan(solution)


def parts_of(statement: str) -> tuple[str | None, ...]:
    """The parts that have a working without cases and notes."""
    _, derivation = planned(statement)
    parts = dict.fromkeys(derivation.asked.values())
    return tuple(part for part in parts if _plain(of_part(derivation, part)))


def _plain(derivation: Derivation) -> bool:
    return not derivation.cases and not derivation.notes and bool(list(rows(derivation)))


def rows(derivation: Derivation) -> Iterator[Row]:
    """The lines that a student would write, with what each says."""
    for line, relation in _said(derivation):
        if _typed(relation):
            yield line, Relation(tuple(tuple(map(_plainly, links)) for links in relation.options))


def _said(derivation: Derivation) -> Iterator[Row]:
    for line in derivation.lines:
        if isinstance(line.relation, Relation) and line.shown != "silent":
            yield line, line.relation


def _typed(relation: Relation) -> bool:
    signs = {link.sign for links in relation.options for link in links}
    return len(relation.options) == 1 and signs <= {"=", "<", ">", "<=", ">=", *_SIGNS}


def _plainly(link: Link) -> Link:
    """A link with a sign that is typed: right angles as a scalar product that is 0."""
    match link.sign:
        case "perpendicular to":
            return Link(Quantity("dot", (link.left, link.right)), "=", Number(Fraction(0)))
        case "≈":
            return Link(link.left, "=", link.right)
    return link


def derive(
    statement: str,
    part: str | None,
    random: Random,
    slips: Mapping[int, Relation] | None = None,
    hand: Hand | None = None,
    route: int = 1,
) -> DerivedScript:
    """A correct script of a part, varied; with ``slips`` by line, one with these, in its order.

    It is typed as the ``hand`` types, if there is one.
    """
    solution, derivation = planned(statement, route)
    senses = senses_of(solution, derivation, part)
    own = of_part(derivation, part)
    written = list(rows(own))
    taken = _letters_of(written, derivation, statement)
    pool = [letter for letter in POOL if letter not in taken]
    random.shuffle(pool)
    below = [f"{letter}_{number}" for number in (4, 3, 2, 1) for letter in "pqrs"]
    pool = [letter for letter in below if letter not in taken] + pool
    put: dict[Expression, Expression] = {}
    declared: dict[str, str] = {}
    lets: list[str] = []
    for meaning in own.meanings.values():
        _declare(meaning, pool, put, declared, random, senses)
        letter = put.get(Letter(meaning.letter))
        if isinstance(letter, Letter) and not isinstance(meaning.quantity, Quantity):
            # An expression, perhaps of other letters of the working, is declared as people do.
            del declared[letter.name]
            lets.append(f"let {letter.name} = {write_expression(exchanged(meaning.quantity, put))}")
    for _, relation in written:
        for tree in _sides(relation):
            for quantity in _quantities(tree):
                own_sense = _in_the_sense(quantity, senses)
                if quantity not in put and own_sense in put:
                    put[quantity] = put[own_sense]
                elif quantity not in put and pool:
                    letter = _letter(pool, own_sense)
                    put[quantity] = put[own_sense] = Letter(letter)
                    declared[letter] = write_expression(own_sense)
    if slips:
        written = [(line, slips.get(line.number, relation)) for line, relation in written]
    written = [(line, _put(relation, put)) for line, relation in written]
    kept = written
    if not slips:
        kept = _left_out(kept, random) if random.random() < 0.3 else kept
        kept = _reordered(kept, random) if random.random() < 0.3 else kept
    text = [_text(line, relation, random, hand) for line, relation in kept]
    short = [line for line in text if len(line) <= MAX_LENGTH]
    whole = len(short) == len(list(_said(own)))
    if hand is not None and not slips:
        short = list(hand.script(short, random, MAX_LENGTH))
    return DerivedScript(statement, part, declared, (*lets, *short), whole)


def senses_of(solution: Solution, derivation: Derivation, part: str | None) -> Senses:
    """For components of each kind at each impact the line in whose sense a working is true.

    It is written as in the statement where that is its sense.
    """
    worlds = true_worlds(solution, solution.parts[part])
    quantities = quantities_of(derivation)
    sides = [
        (exchanged(link.left, quantities), exchanged(link.right, quantities))
        for _, relation in rows(of_part(derivation, part))
        for links in relation.options
        for link in links
        if link.sign == "="
    ]
    senses: Senses = {}
    for number, step in enumerate(worlds[0].events if worlds else (), 1):
        line = Quantity("line_of_centres", (), number)
        lines: list[Expression] = [line, Negate(line)]
        if isinstance(step, Impact) and step.along is not None:
            lines[:0] = [step.along, Negate(step.along)]
        for kind in ("along", "across"):
            own = [pair for pair in sides if _kinds_along(pair, line) == {kind}]
            for sense in lines:
                turned = {(kind, line): sense}
                if all(holds(tuple(in_senses(x, turned) for x in pair), worlds) for pair in own):
                    senses[kind, line] = sense
                    break
    return senses


def quantities_of(derivation: Derivation) -> dict[Expression, Expression]:
    """What the letters of a working mean, components in their sense."""
    return {Letter(name): _quantity(each) for name, each in derivation.meanings.items()}


def _quantity(meaning: Meaning) -> Expression:
    quantity = meaning.quantity
    if meaning.sense is not None and isinstance(quantity, Quantity) and not meaning.vector:
        return Quantity("along", (quantity.arguments[0], meaning.sense))
    return quantity


def _kinds_along(sides: Iterable[Expression], line: Expression) -> set[str]:
    """Whether sides hold components along a line of centres, or across it."""
    return {
        node.kind
        for side in sides
        for node in walk(side)
        if isinstance(node, Quantity) and node.kind in ("along", "across")
        if node.arguments[1] == line
    }


def in_senses(tree: Expression, senses: Senses) -> Expression:
    """A tree whose components are taken in given senses."""
    components = {
        node: _in_the_sense(node, senses) for node in walk(tree) if isinstance(node, Quantity)
    }
    return exchanged(tree, components)


def holds(sides: Sequence[Expression], worlds: Sequence[World]) -> bool:
    """Whether sides have the same value in a world; True of what is no number."""
    for world in worlds:
        try:
            left, right = (world.scalar(side) for side in sides)
        except _NO_NUMBER:
            return True
        if np.allclose(left, right, rtol=1e-7, atol=1e-9):
            return True
    return False


def _in_the_sense(quantity: Expression, senses: Senses) -> Expression:
    """A component along or across a line of centres in the sense in which it is meant."""
    if not isinstance(quantity, Quantity) or quantity.kind not in ("along", "across"):
        return quantity
    of, axis = quantity.arguments
    return replace(quantity, arguments=(of, senses.get((quantity.kind, axis), axis)))


def _letters_of(written: Sequence[Row], derivation: Derivation, statement: str) -> set[str]:
    found = {name[0] for _, r in written for tree in _sides(r) for name in letters(tree)}
    given = set(re.findall(r"(?<![A-Za-z])[A-Za-z](?![A-Za-z])", statement))
    own = set(derivation.meanings)
    return (found - own) | given | set("eijmuxg")


def _sides(relation: Relation) -> Iterator[Expression]:
    for links in relation.options:
        for link in links:
            yield link.left
            yield link.right


def _declare(
    meaning: Meaning,
    pool: list[str],
    put: dict[Expression, Expression],
    declared: dict[str, str],
    random: Random,
    senses: Senses,
) -> None:
    """A letter of the working under another name, some in the other sense."""
    if not pool:
        return
    quantity = _quantity(meaning)
    letter = _letter(pool, quantity)
    turned = (
        isinstance(quantity, Quantity)
        and quantity.kind in ("along", "across")
        and random.random() < 0.3
    )
    quantity = _in_the_sense(quantity, senses)
    put[Letter(meaning.letter)] = Negate(Letter(letter)) if turned else Letter(letter)
    if isinstance(quantity, Quantity):
        put[quantity] = put[Letter(meaning.letter)]
    declared[letter] = ("-" if turned else "") + write_expression(quantity)


def _letter(pool: list[str], quantity: Expression) -> str:
    """A letter taken from a pool; nobody calls an impulse or a place v."""
    of_velocities = any(
        isinstance(node, Quantity) and node.kind in ("velocity", "speed") for node in walk(quantity)
    )
    places = range(len(pool) - 1, -1, -1)
    place = next((n for n in places if of_velocities or pool[n] not in "vwVW"), len(pool) - 1)
    return pool.pop(place)


def _quantities(tree: Expression) -> Iterator[Quantity]:
    """The outermost quantities of a tree, those inside a scalar product on their own."""
    if isinstance(tree, Quantity):
        if tree.kind == "dot":
            for argument in tree.arguments:
                yield from _quantities(argument)
        else:
            yield tree
        return
    inner = {each for node in walk(tree) if isinstance(node, Quantity) for each in walk(node)}
    outer = [node for node in walk(tree) if isinstance(node, Quantity)]
    covered = {e for node in outer for e in walk(node) if e != node and isinstance(e, Quantity)}
    yield from (node for node in outer if node not in covered and node in inner)


def _put(relation: Relation, put: Mapping[Expression, Expression]) -> Relation:
    return Relation(
        tuple(
            tuple(
                replace(link, left=exchanged(link.left, put), right=exchanged(link.right, put))
                for link in links
            )
            for links in relation.options
        )
    )


def _left_out(written: list[Row], random: Random) -> list[Row]:
    """Without some of the lines that only rearrange others."""
    return [
        (line, relation)
        for line, relation in written
        if line.move.id in NEEDED or line.marks or random.random() < 0.6
    ]


def _reordered(written: list[Row], random: Random) -> list[Row]:
    rows_ = list(written)
    for k in range(len(rows_) - 1):
        first, second = rows_[k][0], rows_[k + 1][0]
        independent = first.number not in second.premises and first.item == second.item
        if independent and random.random() < 0.5 and first.number < second.number:
            rows_[k], rows_[k + 1] = rows_[k + 1], rows_[k]
    return rows_


def _text(line: Line, relation: Relation, random: Random, hand: Hand | None) -> str:
    (links,) = relation.options
    if len(links) == 1:
        link = _varied(links[0], random, line.move.id == "law")
        body = f"{write_expression(link.left)} {link.sign} {_right(link, random)}"
    else:
        body = _chain(links)
    body = re.sub(r"dot\(([^(),]+), ([^(),]+)\)", _dotted, body)
    if hand is not None:
        return hand.line(body, line.move.record or "", random)
    announced = random.choice(LAWS.get(line.move.record or "", ANNOUNCED))
    return (announced if random.random() < 0.4 else "") + styled(body, random)


def _dotted(match: re.Match[str]) -> str:
    """A scalar product with its dot, sums in brackets."""
    sides = (f"({side})" if " " in side else side for side in match.groups())
    return " . ".join(sides)


def _chain(links: Sequence[Link]) -> str:
    text, before = "", None
    for link in links:
        right = f"{link.sign} {write_expression(link.right)}"
        if before is not None and before.right == link.left:
            text += f" {right}"
        else:
            text += f"{' and ' if text else ''}{write_expression(link.left)} {right}"
        before = link
    return text


def _varied(link: Link, random: Random, law: bool) -> Link:
    change = random.random()
    if link.sign != "=" or isinstance(link.left, Letter):
        return link
    if change < 0.15:
        return Link(link.right, "=", link.left)
    if change < 0.3 and isinstance(link.right, Binary) and link.right.op == "+":
        return Link(Binary("-", link.left, link.right.right), "=", link.right.left)
    if change < 0.45 and law:
        factor = Number(sp.Integer(2).p if random.random() < 0.5 else 3)  # type: ignore[arg-type]
        return Link(Binary("*", factor, link.left), "=", Binary("*", factor, link.right))
    return link


def _right(link: Link, random: Random) -> str:
    """The right side; a number that is no fraction to three figures, some of the time."""
    irrational = any(type(node).__name__ == "Apply" for node in walk(link.right))
    if link.sign == "=" and irrational and not letters(link.right) and random.random() < 0.4:
        value = _value(link.right)
        if value is not None and abs(value) > 1e-9:
            return (
                f"{value:#.3g}".rstrip(".") if abs(value) < 1000 else write_expression(link.right)
            )
    return write_expression(link.right)


def _value(tree: Expression) -> float | None:
    """A number without letters, in degrees where it is an arc; None for what is no number."""
    text = write_expression(tree)
    if "°" in text or "arc" in text or "i" in re.sub("sin|pi", "", text) or "j" in text:
        return None
    try:
        return float(sp.sympify(_as_sympy(tree)))
    except (TypeError, ValueError):
        return None


def _as_sympy(tree: Expression) -> sp.Expr:
    kind = type(tree).__name__
    if isinstance(tree, Number):
        return sp.Rational(tree.value.numerator, tree.value.denominator)
    if isinstance(tree, Negate):
        return -_as_sympy(tree.operand)
    if isinstance(tree, Binary):
        left, right = _as_sympy(tree.left), _as_sympy(tree.right)
        return {"+": left + right, "-": left - right, "*": left * right}.get(
            tree.op, left / right if tree.op == "/" else left**right
        )
    if kind == "Apply" and tree.function == "sqrt":  # type: ignore[union-attr]
        return sp.sqrt(_as_sympy(tree.argument))  # type: ignore[union-attr]
    raise ValueError(kind)


def styled(text: str, random: Random) -> str:
    """The text as a student types it."""
    if random.random() < 0.6:
        text = text.replace("sqrt", "√")
        text = re.sub(r"√\((\d+)\)", r"√\1", text)
    if random.random() < 0.4:
        text = re.sub(r"\^2(?!\d)", "²", text)
    if random.random() < 0.4:
        text = re.sub(r"(sin|cos|tan)\((\d+)°\)", r"\1\2", text)
    if random.random() < 0.4:
        text = re.sub(r"(?<=[A-Za-z)])(?<!and)(?<!_.) (?=[a-z(])(?!and )", "", text)
    if random.random() < 0.4:
        text = re.sub(r" ([=+-]) ", r"\1", text)
    for name, sign in (("alpha", "α"), ("beta", "β"), ("theta", "θ")):
        if random.random() < 0.5:
            text = text.replace(name, sign)
    return text
