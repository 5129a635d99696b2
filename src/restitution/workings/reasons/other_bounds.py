"""What makes no end of a range, and holds in it: a bound of a coefficient, a wall with ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.data.unused import lines_under
from restitution.explaining.lines.derivation import Derivation, Event, Line, Link, Ref, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_operator,
    has_quantity,
    is_quantity,
    letters,
)
from restitution.oracle import BeyondError, Oracle, compared
from restitution.problem import Find, Range
from restitution.solving.equations.solution import Solution
from restitution.solving.story.letters import roles
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.quantities import Naming

_OTHER = {"<=": (">=", Number(Fraction(0))), ">=": ("<=", Number(Fraction(1)))}
_WITHIN: Mapping[tuple[str, bool], SentenceId] = {
    ("range", False): "range.within",
    ("range", True): "range.within-all",
    ("anyway", False): "range.within-anyway",
    ("anyway", True): "range.within-all-anyway",
    ("before", False): "range.within-before",
    ("before", True): "range.within-all-before",
}
_ZERO, _ONE, _TWO = (Number(Fraction(value)) for value in range(3))
_ORDER = ("<", "<=", ">", ">=")


def other_bounds(solution: Solution, derivation: Derivation) -> dict[int, Sentence]:
    """What is said below the lines of ranges that come of one bound of a coefficient alone."""
    finds = (step for _, step in solution.problem.steps() if isinstance(step, Find))
    if not any(isinstance(item, Range) for step in finds for item in step.items):
        return {}
    naming = Naming(derivation, solution.problem)
    ends = Ends(derivation, solution.problem, naming)
    sentences: dict[int, Sentence] = {}
    for end in derivation.items:
        line = derivation.line(end.line)
        if line is None or not isinstance(ends.item(end.item), Range):
            continue
        kept = [
            (bounded, value, sign)
            for bounded, value, sign in _bounds(derivation, line)
            if _holds(solution, line, bounded, value, sign)
        ]
        bounds = [Link(bounded, *_OTHER[sign]) for bounded, _, sign in kept]  # type: ignore[arg-type]
        reasons = [_reasons(solution, line, value, sign) for _, value, sign in kept]
        ends_of_walls = list(_other_ends(solution, derivation, line))
        bounds += ends_of_walls
        reached = list(_other_walls(solution, derivation, line))
        notes = []
        for number, own in _by_home(derivation, line, reached).items():
            note = _note_of_walls(naming, line, own, before=number != line.number)
            if number == line.number:
                notes.append(note)
            else:
                sentences.setdefault(number, note)
        if bounds:
            relations, why = (
                tuple(naming.relation(Relation((own,))) for own in links)
                for links in (
                    [(own,) for own in bounds],
                    [own for grounds in reasons for own in grounds],
                )
            )
            if ends_of_walls or not all(reasons):
                notes.insert(0, say("range.also", bounds=relations))
            else:
                notes.insert(0, say("range.also-as", bounds=relations, reasons=why))
        if notes:
            both = len(notes) > 1
            sentences[line.number] = (
                say("range.both", one=notes[0], two=notes[1]) if both else notes[0]
            )
    return sentences


def _other_ends(solution: Solution, derivation: Derivation, line: Line) -> Iterator[Link]:
    """The ends of walls that a place cannot pass, where a line tests the other end alone."""
    for ref in lines_under(derivation, line.number):
        own = derivation.line(ref)
        premises = () if own is None else own.premises
        facts = (_ends_of_a_wall(derivation, ref) for ref in premises)
        tested = next((fact for fact in facts if fact is not None), None)
        if own is None or tested is None or not isinstance(own.relation, Relation):
            continue
        if own.move.id != "compare" or [len(option) for option in own.relation.options] != [1]:
            continue
        (link,), (low, high) = own.relation.only, tested
        if link.left == low.left:
            other = Link(link.right, high.sign, high.right)
        elif link.right == high.right:
            other = Link(low.left, low.sign, link.left)
        else:
            continue
        if _follows(solution, line, other.left, other.sign, other.right):
            yield other


def _ends_of_a_wall(derivation: Derivation, ref: Ref) -> tuple[Link, Link] | None:
    """That a place lies between the ends of a wall, as a fact says it."""
    fact = derivation.fact(ref)
    if (
        fact is None
        or fact.id.partition(" ")[0] != "within"
        or len(fact.relation.options) != 1
        or len(fact.relation.only) != 2
    ):
        return None
    low, high = fact.relation.only
    return low, high


Chain = tuple[Link, ...]
"""A comparison with what its last side is equal to."""

Reached = tuple[Event, tuple[Link, ...]]
"""The event of a wall, and that the place there lies between its ends."""


def _by_home(
    derivation: Derivation, line: Line, reached: Sequence[Reached]
) -> dict[int, list[Reached]]:
    """Walls by the line below which their note stands.

    That is the end of the item of an earlier part that tells where the body hits, if the range has
    no part in it.
    """
    homes: dict[int, list[Reached]] = {}
    for wall_end in reached:
        _, links = wall_end
        homes.setdefault(_home(derivation, line, links), []).append(wall_end)
    return homes


def _home(derivation: Derivation, line: Line, links: Sequence[Link]) -> int:
    under = lines_under(derivation, line.number)
    places = {link.right for link in links} | {link.left for link in links}
    items = [
        own.item
        for own in derivation.lines
        if own.number in under
        and own.item != line.item
        and isinstance(own.relation, Relation)
        and len(own.relation.options) == 1
        and is_quantity(own.relation.only[0].left, "along")
        and own.relation.only[-1].right in places
    ]
    part = derivation.asked.get(line.item or "")
    ends = [e.line for e in derivation.items if e.item in items[-1:] and e.part != part]
    return ends[-1] if ends and not _varies(line, links) else line.number


def _varies(line: Line, links: Sequence[Link]) -> bool:
    """Whether places have letters of a range in them."""
    assert isinstance(line.relation, Relation)
    sides, places = (
        {name for e in own for tree in (e.left, e.right) for name in letters(tree)}
        for own in (line.relation.options[0], links)
    )
    return bool(sides & places)


def _note_of_walls(
    naming: Naming, line: Line, reached: Sequence[Reached], *, before: bool
) -> Sentence:
    """That the body which comes first to such a wall comes there between its ends."""
    body = reached[0][0].bodies[0]
    own = [wall_end for wall_end in reached if wall_end[0].bodies[0] == body]
    walls = tuple(dict.fromkeys(event.bodies[1] for event, _ in own))
    bounds = tuple(naming.relation(Relation(((*links,),))) for _, links in own)
    varies = _varies(line, [link for _, links in own for link in links])
    name = _WITHIN["before" if before else "range" if varies else "anyway", len(walls) > 1]
    return say(name, bounds=bounds, body=body, walls=walls)


def _other_walls(solution: Solution, derivation: Derivation, line: Line) -> Iterator[Reached]:
    """Walls with ends that no line tests, where a sphere comes between them in a whole range."""
    under = lines_under(derivation, line.number)
    cited = {
        ref
        for other in under
        if isinstance(other, int) and (own := derivation.line(other)) is not None
        for ref in own.premises
    }
    if not any(str(ref).partition(" ")[0] == "within" for ref in cited):
        return
    values = {
        own.relation.only[0].left: own.relation.only[-1].right
        for own in derivation.lines
        if own.number in under
        and isinstance(own.relation, Relation)
        and len(own.relation.options) == 1
        and own.relation.only[0].sign == "="
    }
    for event in derivation.events:
        fact = derivation.fact(f"within {event.number}")
        if fact is None or fact.id in cited or len(fact.relation.options) != 1:
            continue
        links = tuple(
            replace(e, left=values.get(e.left, e.left), right=values.get(e.right, e.right))
            for e in fact.relation.only
        )
        if not any(has_quantity(side) for e in links for side in (e.left, e.right)) and all(
            _follows(solution, line, e.left, e.sign, e.right) for e in links
        ):
            yield event, links


def _bounds(derivation: Derivation, line: Line) -> Iterator[tuple[Expression, Expression, str]]:
    """The coefficients, or their squares, that a range bounds on one side: with value and side."""
    under = sorted(ref for ref in lines_under(derivation, line.number) if isinstance(ref, int))
    lines = [own for number in under if (own := derivation.line(number)) is not None]
    cited = {ref for own in lines for ref in own.premises if isinstance(ref, str)}
    for own in lines:
        named = [ref for ref in own.premises if isinstance(ref, str)]
        above = derivation.lines_in(own.premises)
        if own.move.id != "sign" or len(named) > 1 or len(above) != 1 or above[0] is None:
            continue
        match above[0].relation:
            case Relation(((Link(Binary("^", Letter(name), power) as squared, "="), *_),)) if (
                power == _TWO and not named
            ):
                value = above[0].relation.only[-1].right
                if f"{name} <= 1" not in cited and has_operator(value, "-"):
                    yield squared, value, ">="
                continue
            case Relation(((Link(Letter(name) as letter, "="), *_),)):
                value = above[0].relation.only[-1].right
            case _:
                continue
        for sign, (other, far) in _OTHER.items():
            near = "1" if sign == "<=" else "0"
            cites = f"{name} {other} {far.value}" in cited
            stated = named[:1] == [f"{name} {sign} {near}"] and not cites
            if stated and has_operator(value, "-") and not has_quantity(value):
                yield letter, value, sign


def _holds(
    solution: Solution, line: Line, bounded: Expression, value: Expression, sign: str
) -> bool:
    """Whether a value keeps the other bound wherever a range holds."""
    own = roles(solution.problem)
    kinds = {own[name].kind if name in own else None for name in letters(bounded)}
    if kinds != {"restitution"} or not isinstance(line.relation, Relation):
        return False
    return _follows(solution, line, value, *_OTHER[sign])


def _reasons(solution: Solution, line: Line, value: Expression, sign: str) -> tuple[Chain, ...]:
    """Why a quotient keeps the other bound: it is less than 1, or its factors are not negative.

    That it is less than 1 is seen where what is below exceeds what is above by terms of which none
    is negative, perhaps with the square of a cosine by that of the sine, or the other way round.
    Empty where no such reason is seen.
    """
    match value:
        case Binary("/", above, below) if _follows(solution, line, below, ">", _ZERO):
            pass
        case _:
            return ()
    if sign == ">=":
        if _exceeds(solution, below, above):
            return ((Link(above, "<", below),),)
        same = _by_the_other_square(below)
        if same is None or not _exceeds(solution, same, above):
            return ()
        return ((Link(above, "<", same), Link(same, "=", below)),)
    reasons: list[Link] = []
    for side in (above, below):
        if has_operator(side, "-"):
            positive = _follows(solution, line, side, ">", _ZERO)
            reasons.append(Link(side, ">" if positive else ">=", _ZERO))
    holds = all(_follows(solution, line, own.left, own.sign, own.right) for own in reasons)
    return tuple((own,) for own in reasons) if holds else ()


def _by_the_other_square(tree: Expression) -> Expression | None:
    """A multiple of the square of a cosine by that of the sine, or the other way round."""
    match tree:
        case Binary("*", multiple, square):
            pass
        case _:
            multiple, square = _ONE, tree
    match square:
        case Binary("^", Apply("sin" | "cos" as ratio, angle), power) if power == _TWO:
            other = Binary("^", Apply("cos" if ratio == "sin" else "sin", angle), _TWO)
            less = other if multiple == _ONE else Binary("*", multiple, other)
            return Binary("-", multiple, less)
    return None


def _exceeds(solution: Solution, more: Expression, less: Expression) -> bool:
    """Whether a difference is a sum of which no term is negative, and not all are zero."""
    own = roles(solution.problem)
    try:
        sides = [evaluate(side, lambda name: own[name].symbol(name)) for side in (more, less)]
        terms = sp.Add.make_args(sp.expand(sides[0] - sides[1]))
    except (RestitutionError, KeyError, TypeError, ValueError):
        return False
    return all(term.is_nonnegative for term in terms) and any(term.is_positive for term in terms)


def _follows(
    solution: Solution, line: Line, left: Expression, sign: str, right: Expression
) -> bool:
    """Whether a comparison is proved wherever a range holds."""
    own = roles(solution.problem)
    if not isinstance(line.relation, Relation) or len(line.relation.options) != 1:
        return False

    def symbol(name: str) -> sp.Expr:
        return own[name].symbol(name)

    try:
        within = [
            compared(evaluate(link.left, symbol), link.sign, evaluate(link.right, symbol))
            for link in line.relation.only
            if link.sign in _ORDER
        ]
        claim = compared(evaluate(left, symbol), sign, evaluate(right, symbol))
        return Oracle(own).with_facts(within).proves(claim)
    except (RestitutionError, BeyondError, KeyError, TypeError, ValueError):
        return False
