"""Several solutions: why none is rejected, and what they are together."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.data.unused import lines_under
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, equality
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Apply, Letter, is_quantity, letters
from restitution.oracle.roles import COEFFICIENT, Role
from restitution.planning.writing.forms import ONE, ZERO, tree_of
from restitution.solving.story.letters import roles
from restitution.workings.naming.measured import Measures, worth
from restitution.workings.naming.quantities import Naming


def why_possible(derivation: Derivation, naming: Naming, line: Line) -> Sentence:
    """Why both of two values hold, where that is seen; that all do, where there are more."""
    assert isinstance(line.relation, Relation)
    relation = line.relation
    if len(relation.options) != 2:
        return say("derived.all-possible")
    left = relation.options[0][0].left
    values = [worth(links[-1].right) for links in relation.options]
    positive = all(value.is_positive for value in values)
    inside = left.argument if isinstance(left, Apply) else left
    role = roles(naming.problem).get(inside.name) if isinstance(inside, Letter) else None
    match left, role:
        case Letter(), Role("restitution") if all(value.is_nonnegative for value in values):
            return say("derived.both-coefficients")
        case Letter(), Role("real") if not positive and any(v.is_positive for v in values):
            return say("derived.either-sign", letter=naming.layout(left))
        case Letter(), Role("positive"):
            bounded = positive
        case Apply("tan"), Role("angle"):
            bounded = positive and role.high == sp.pi / 2
        case _:
            bounded = positive and is_quantity(left, "speed", "mass")
    tied = _coefficient(derivation, naming, line) if positive and len(letters(left)) == 1 else None
    if tied is not None:
        equation, outcomes = tied
        (e,) = {links[0].left for links in outcomes.options}
        within = Relation(((Link(ZERO, "<=", e), Link(e, "<=", ONE)),))
        slots = {"equation": equation, "values": outcomes, "bound": within}
        return say("derived.both-give", **{n: naming.relation(own) for n, own in slots.items()})
    if not bounded and _gives_lines_of_centres(derivation, naming, line):
        return say("derived.both-approach")
    return say("derived.both-positive" if bounded else "derived.both-possible")


def _gives_lines_of_centres(derivation: Derivation, naming: Naming, line: Line) -> bool:
    """Whether the values in a line lead to several lines of centres, each from sphere to sphere."""
    walls = {number for number, event in naming.events.items() if event.wall}
    below = {n for case in derivation.cases if case.line == line.number for n in case.lines}
    return any(
        isinstance(own.relation, Relation)
        and is_quantity(centres := own.relation.options[0][0].left, "line_of_centres")
        and centres.stage not in walls
        for own in derivation.lines_in(below)
    )


def _coefficient(
    derivation: Derivation, naming: Naming, line: Line
) -> tuple[Relation, Relation] | None:
    """A line above that gives a coefficient by the letter of two roots, and what both make of it.

    That the roots are positive is not enough then: the coefficient has to be from 0 to 1.
    """
    assert isinstance(line.relation, Relation)
    part, left = derivation.asked.get(line.item or ""), line.relation.options[0][0].left
    known = roles(naming.problem)
    for own in derivation.lines:
        match own.relation:
            case Relation(((Link(Letter(name) as e, "="), *_) as links,)) if (
                own.number < line.number and known.get(name) == COEFFICIENT
            ):
                value = links[-1].right
            case _:
                continue
        facts = derivation.facts_in(lines_under(derivation, own.number))
        if letters(value) != letters(left) or any(f.part not in (None, part) for f in facts):
            continue
        outcomes = [exchanged(value, {left: links[-1].right}) for links in line.relation.options]
        numbers = [tidy(worth(tree)) for tree in outcomes]
        if all(number.is_Rational and 0 <= number <= 1 for number in numbers):
            options = tuple((Link(e, "=", tree_of(number)),) for number in numbers)
            return equality(e, value), Relation(options)
    return None


def cases_together(
    derivation: Derivation, naming: Naming, measures: Measures, part: str | None
) -> Sentence | None:
    """What the cases of a part come to together, where each gives several letters a number."""
    ends = [end for end in derivation.items if derivation.asked.get(end.item) == part]
    by_case: dict[int, list[Link]] = {}
    for end in ends:
        match end.case, end.answer:
            case int(number), Relation(((Link(Letter() as left, "=" | "≈"), *_) as links,)):
                value = links[-1].right
            case _:
                continue
        if letters(value) or measures.unit(left):
            return None
        by_case.setdefault(number, []).append(Link(left, links[-1].sign, value))
    cases = list(by_case.values())
    if len(cases) != 2 or any(len(links) < 2 or len(links) != len(cases[0]) for links in cases):
        return None
    slots: dict[str, Any] = {
        name: say("derived.case", values=[naming.relation(Relation(((e,),))) for e in links])
        for name, links in zip(("first", "second"), cases, strict=True)
    }
    known = roles(naming.problem)
    for e in (link.left for link in cases[0]):
        if isinstance(e, Letter) and known.get(e.name) == COEFFICIENT:
            within = Relation(((Link(ZERO, "<=", e), Link(e, "<=", ONE)),))
            return say("derived.cases-possible", **slots, bound=naming.relation(within))
    return say("derived.cases", **slots)


__all__ = ["cases_together", "why_possible"]
