"""A working whose lines stand: what nobody needs goes, and each line gets its last form."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.premises import (
    with_given_ratios,
    with_identities,
    with_ranges,
    without_idle_ratios,
    without_spare,
)
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Quantity,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.cases import without_idle
from restitution.planning.closing.complements import with_complements
from restitution.planning.closing.wanted_letters import with_wanted_letters
from restitution.planning.latest_forms import (
    with_factors_kept,
    with_latest_forms,
    with_squares_of_speeds,
)
from restitution.planning.writing.angles_of_paths import with_angles_of_paths
from restitution.planning.writing.conjugates import with_conjugates
from restitution.planning.writing.desk import Desk
from restitution.planning.writing.direct_impacts import with_direct_impacts
from restitution.planning.writing.direct_ratios import with_direct_ratios
from restitution.planning.writing.direct_slopes import with_direct_slopes
from restitution.planning.writing.direct_tangents import with_direct_tangents
from restitution.planning.writing.factors_out import with_factors_out
from restitution.planning.writing.facts_once import (
    with_distances_once,
    with_facts_once,
    with_laws_once,
)
from restitution.planning.writing.gathering import gathered, numbered_anew
from restitution.planning.writing.kept_ratios import with_kept_ratios, with_one_angle
from restitution.planning.writing.known_directions import (
    with_known_directions,
    with_lines_from_rest,
)
from restitution.planning.writing.one_component import with_one_component
from restitution.planning.writing.plain_products import with_plain_products
from restitution.planning.writing.printed_eliminations import with_printed_eliminations
from restitution.planning.writing.ratios_put_in import with_ratios_put_in
from restitution.planning.writing.squares_of_surds import with_squares_of_surds
from restitution.planning.writing.squares_together import with_squares_together
from restitution.planning.writing.sums_apart import with_sums_apart
from restitution.planning.writing.values_first import with_values_first
from restitution.planning.writing.values_out import with_values_out
from restitution.problem import Problem
from restitution.solving.story.letters import roles


def finished(problem: Problem, desk: Desk) -> Derivation:
    """The derivation of a desk, without what nobody needs, and with all that is needed."""
    whole = pruned(
        Derivation(
            desk.facts,
            tuple(desk.lines),
            tuple(desk.ends),
            desk.events,
            tuple(desk.cases),
            tuple(dict.fromkeys(desk.others)),
            tuple(desk.notes),
        )
    )
    oracle = Oracle(roles(problem))
    whole = without_idle(whole)
    for shortened in (
        *(with_direct_slopes, with_direct_tangents, with_direct_ratios),
        *(with_plain_products, with_wanted_letters),
        *(with_latest_forms, with_factors_kept, with_squares_of_speeds, with_given_ratios),
        *(
            with_ratios_put_in,
            with_values_first,
            with_known_directions,
            with_complements,
            with_squares_of_surds,
            with_conjugates,
            with_sums_apart,
            with_one_component,
        ),
        *(
            with_values_out,
            with_factors_out,
            with_angles_of_paths,
            with_kept_ratios,
            with_one_angle,
            with_squares_together,
            with_printed_eliminations,
        ),
    ):
        shorter = shortened(whole, oracle)
        whole = whole if shorter is whole else pruned(shorter)
    for mended in (without_idle_ratios, with_ranges, with_identities, without_spare):
        whole = mended(whole, oracle)
    once = with_laws_once(whole)
    whole = whole if once is whole else pruned(once)
    whole = _without_idle_arctangents(_without_unprinted_letters(whole))
    whole = gathered(with_direct_impacts(with_distances_once(with_facts_once(whole))))
    # What stands above a line is known only now.
    shorter = with_lines_from_rest(whole, oracle)
    return whole if shorter is whole else pruned(shorter)


def pruned(derivation: Derivation) -> Derivation:
    """The same working without lines on which no item rests, numbered anew."""
    lines = {line.number: line for line in derivation.lines}
    pending = [item.line for item in derivation.items] + [e.line for e in derivation.cases]
    pending += [line for note in derivation.notes for line in note.lines]
    kept: set[int] = set()
    while pending:
        number = pending.pop()
        if number not in kept:
            kept.add(number)
            pending += numbers_in(lines[number].premises)
    return numbered_anew(derivation, [line for line in derivation.lines if line.number in kept])


def _without_unprinted_letters(derivation: Derivation) -> Derivation:
    """The same working, in which an angle or a component that no line prints gets no letter."""
    printed = {
        name
        for line in derivation.lines
        if isinstance(line.relation, Relation) and line.shown != "silent"
        for tree in trees_of(line.relation)
        for name in letters(tree)
    }
    printed |= {
        name for end in derivation.items for t in trees_of(end.answer) for name in letters(t)
    }

    def mended(line: Line) -> Line:
        match line.relation:
            case Meaning(
                letter, Quantity("angle" | "deflection" | "direction" | "along" | "across")
            ) if letter not in printed:
                return replace(line, shown="silent")
        return line

    return replace(derivation, lines=tuple(map(mended, derivation.lines)))


def _without_idle_arctangents(derivation: Derivation) -> Derivation:
    """The same working without the lines that only turn a ratio round on the way to a sum.

    Where the arctangent, or the arcsine or arccosine, stands in every line that rests on such a
    line, nobody needs it.
    """
    ends = {item.line for item in derivation.items}
    ends |= {case.line for case in derivation.cases}
    ends |= {number for note in derivation.notes for number in note.lines}

    def mended(line: Line) -> Line:
        match line.move.id, line.relation:
            case "inverse", Relation(
                ((Link(Letter(), "=", Apply("arctan" | "arcsin" | "arccos") as angle),),)
            ):
                pass
            case _:
                return line
        later = [other for other in derivation.lines if line.number in other.premises]
        sums = all(_sums_up(line, angle) for line in later)
        if not later or not sums or line.number in ends:
            return line
        return replace(line, shown="silent")

    return replace(derivation, lines=tuple(map(mended, derivation.lines)))


def _sums_up(line: Line, angle: Expression) -> bool:
    """Whether a line is one of a sum of angles, in which an arctangent stands."""
    if not isinstance(line.relation, Relation):
        return False
    trees = (node for tree in trees_of(line.relation) for node in walk(tree))
    return any(is_binary(node, "+", "-") and angle in walk(node) for node in trees)


__all__ = ["finished"]
