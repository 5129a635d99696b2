"""What lines cite is mended after a working is written: no more than they need, and no less."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.explaining.following.follower import Reader, reader_of
from restitution.explaining.following.trials import names_in
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
    citing,
)
from restitution.explaining.lines.trees import angles_with_both_ratios, trees_of
from restitution.expression.tree import Apply, Expression, Letter, is_binary, letters, walk
from restitution.oracle import Oracle

# What is below these has a sign that may have to be known.
_RANGED = ("sqrt", "abs", "arcsin", "arccos", "arctan")


def without_spare(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no line cites of letters and angles what it does not need.

    Where two terms cancel, no line cites what is given of a letter that was in them alone.

    Lines that do not follow are left as they are.
    """
    ratios = {
        line.number
        for line in derivation.lines
        if isinstance(line.relation, Relation)
        and len(line.relation.options) == 1
        and isinstance(line.relation.only[0].left, Apply)
    }
    facts = {fact.id for fact in derivation.facts if not _is_ratio(fact.relation)}
    given = {fact.id for fact in derivation.facts if fact.kind == "given"}
    read: Reader | None = None
    lines = []
    for line in derivation.lines:
        known = [
            ref
            for ref in line.premises
            if ref in ratios or (isinstance(ref, str) and ref not in facts)
        ]
        if given & set(line.premises) and _cancels(line):
            known += [ref for ref in line.premises if ref in given]
        if line.move.id in ("inverse", "triangle"):
            # The range of an angle is needed wherever it is told by a ratio.
            read = read or reader_of(derivation, oracle)
            own = names_in(line.relation)
            known = [ref for ref in known if not read.speaks_of(ref, own)]
        if known and isinstance(line.relation, Relation):
            read = read or reader_of(derivation, oracle)
            line = replace(line, premises=read.needed(line.number, known))
        lines.append(line)
    return replace(derivation, lines=tuple(lines))


def with_ranges(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which lines with roots of letters cite the ranges of these.

    Lines that follow, and those that do not even with that, are left as they are.
    """
    read: Reader | None = None
    lines = []
    for line in derivation.lines:
        names = _below_roots(line)
        ranges = [ref for name in sorted(names) for ref in _ranges(name, oracle)]
        if ranges and isinstance(line.relation, Relation):
            read = read or reader_of(derivation, oracle)
            line = replace(line, premises=read.completed(line.number, ranges))
        lines.append(line)
    return replace(derivation, lines=tuple(lines))


def with_identities(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a line that takes sin² + cos² = 1 to follow says so."""
    read: Reader | None = None
    lines = []
    for line in derivation.lines:
        other = _by_identity(line)
        if other is not None:
            read = read or reader_of(derivation, oracle)
            settled_ = read.lines[line.number]
            if not read.accepts(settled_):
                named = _by_identity(settled_)
                line = other if named is not None and read.accepts(named) else line
        lines.append(line)
    return replace(derivation, lines=tuple(lines))


def with_given_ratios(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a ratio that is given is put in itself, where that is enough.

    Then no line needs the other ratios of its angle.
    """
    for line in derivation.lines:
        given = [
            fact.id
            for ref in line.premises
            if (fact := derivation.fact(ref)) is not None and _is_ratio(fact.relation)
        ]
        users = [other for other in derivation.lines if line.number in other.premises]
        if line.move.id != "triangle" or len(given) != 1 or line.number in derivation.held:
            continue
        if any(user.move.id != "put" for user in users):
            continue
        numbers: dict[Ref, Ref] = {line.number: given[0]}
        changed = {
            user.number: replace(user, premises=citing(user.premises, numbers)) for user in users
        }
        lines = tuple(changed.get(line.number, line) for line in derivation.lines)
        whole = replace(derivation, lines=lines)
        read = reader_of(whole, oracle)
        if all(read.accepts(read.lines[number]) for number in changed):
            derivation = whole
    return derivation


def without_idle_ratios(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which of a sine and a cosine that are found together none is idle.

    Of what was asked for, the answer stays.
    """
    asked: dict[int, set[Expression]] = {}
    for end in derivation.items:
        asked.setdefault(end.line, set()).update(e[0].left for e in end.answer.options)
    for line in derivation.lines:
        own = line.relation
        if (
            line.move.id != "triangle"
            or not isinstance(own, Relation)
            or len(own.options) != 1
            or len(own.only) != 2
        ):
            continue
        users = [other.number for other in derivation.lines if line.number in other.premises]
        for link in own.only:
            if not asked.get(line.number, set()) <= {link.left}:
                continue
            alone = replace(line, relation=Relation(((link,),)))
            lines = tuple(alone if other is line else other for other in derivation.lines)
            shorter = replace(derivation, lines=lines)
            read = reader_of(shorter, oracle)
            if all(read.accepts(read.lines[user]) for user in (line.number, *users)):
                derivation = shorter
                break
    return derivation


def _by_identity(line: Line) -> Line | None:
    """A line with sines and cosines of one angle, by the identity and not by arithmetic."""
    if isinstance(line.relation, Meaning) or not angles_with_both_ratios(trees_of(line.relation)):
        return None
    if line.move.id == "rearrange":
        return replace(line, move=replace(line.move, id="identity", record="pythagoras"))
    if len(line.relation.options) != 1 or line.relation.only[-1].by != "rearrange":
        return None
    *links, last = line.relation.only
    return replace(line, relation=Relation(((*links, replace(last, by="identity")),)))


def _below_roots(line: Line) -> set[str]:
    """The letters in roots, sizes and inverse ratios of a line."""
    return {
        name
        for tree in trees_of(line.relation)
        for node in walk(tree)
        if isinstance(node, Apply) and node.function in _RANGED
        for name in letters(node)
    }


def _ranges(name: str, oracle: Oracle) -> tuple[Ref, ...]:
    role = oracle.roles.get(name)
    if role is not None and role.kind == "restitution":
        return f"{name} >= 0", f"{name} <= 1"
    if role is not None and role.kind == "angle":
        acute = (role.low, role.high, *role.closed) == (0, sp.pi / 2, False, False)
        return (f"acute: {name}",) if acute else ()
    return ()


def _is_ratio(relation: Relation) -> bool:
    """Whether a fact is a sine, cosine or tangent of an angle."""
    match relation.options:
        case ((Link(Apply("sin" | "cos" | "tan", Letter())),),):
            return True
    return False


def _cancels(line: Line) -> bool:
    """Whether a line takes a term away from itself."""
    return any(
        is_binary(node, "-") and node.left == node.right
        for tree in trees_of(line.relation)
        for node in walk(tree)
    )
