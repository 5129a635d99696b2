"""Facts that clash: a set of them from which none can be left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from restitution.errors import ContradictionError, ImpossibleError, RestitutionError
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.language.writing import relation_text
from restitution.problem import Arrival, Compare, Given, Impact, Kick, Part, Problem, Relation
from restitution.records import dataclass
from restitution.render.document.columns import inline
from restitution.solving.algebra.numbers import at
from restitution.solving.equations.facts import givens
from restitution.solving.equations.part import EVERY_SOLUTION, work_out
from restitution.solving.equations.setting import Setting, out_of_range
from restitution.solving.story.letters import narrowed_by, roles
from restitution.wording.clauses import clause
from restitution.wording.scene import scene_of

MOST_FACTS = 8


@dataclass(frozen=True)
class Fact:
    """One relation of a line of facts."""

    given: Given
    relation: Relation


def named(setting: Setting, error: RestitutionError) -> RestitutionError:
    """The error with the facts that clash, in the statement's own words and by their lines.

    The error itself where the story is impossible without any of them, where one of them alone has
    a physical reason to be impossible, or where there are too many facts to leave each of them out
    in turn.
    """
    facts = [Fact(given, relation) for given, _ in setting.facts for relation in given.relations]
    if not facts or len(facts) > MOST_FACTS or _possible(setting, []) is not True:
        return error
    core = list(facts)
    for fact in facts:
        rest = [other for other in core if other is not fact]
        if _possible(setting, rest) is False:
            core = rest
    physical = isinstance(error, ImpossibleError)
    if physical and len(core) == 1:
        return error
    words = [_words(setting.problem, fact) for fact in core]
    clauses = [clause_of(setting.problem, fact.given, fact.relation) for fact in core]
    place = core[-1].given.place
    line = None if place is None else place.line
    reason = _of_a_letter(setting.problem, core[0].relation) if len(core) == 1 else None
    if reason is not None:
        text = f"the facts clash: {words[0]} cannot be, as {reason}"
        because = f"it cannot be that {clauses[0]}, as {reason}"
    elif len(words) == 1:
        why = f": {error.because}" if error.because.startswith(EVERY_SOLUTION) else ""
        text = f"the facts clash: {words[0]} cannot be together with the rest of the statement{why}"
        because = f"the other data make it impossible that {clauses[0]}{why}"
    else:
        several = " and that ".join(clauses)
        because = f"the data contradict each other: it cannot be that {several}"
        text = f"the facts clash: {', '.join(words[:-1])} and {words[-1]} cannot all be"
        text = text.replace("cannot all", "cannot both") if len(words) == 2 else text
    clash = ContradictionError(f"{text}: {error.message}" if physical else text, line)
    clash.because = f"{because}: {error.because or error.message}" if physical else because
    return clash


def _of_a_letter(problem: Problem, relation: Relation) -> str | None:
    """Why a letter cannot have the number that a fact gives it, by what letters may be."""
    match relation:
        case Compare((Letter(name), value), ("=",)) if not has_quantity(value):
            role = roles(problem).get(name)
            if letters(value) or role is None:
                return None
            number = sp.sympify(evaluate(value, sp.Symbol), strict=True)
            refused = out_of_range(name, at(number, {}), role)
            if refused is None or role.kind != "angle":
                return None if refused is None else refused[0]
            return f"{refused[0]}: write the direction itself in place of {name}"
    return None


def _words(problem: Problem, fact: Fact) -> str:
    text = f"'{relation_text(problem, fact.relation)}'"
    place = fact.given.place
    return text if place is None else f"{text} (line {place.line})"


def clause_of(problem: Problem, given: Given, relation: Relation) -> str:
    """A relation of a line of facts in the words of the question."""
    events = 0
    for _, step in problem.steps():
        if step is given:
            break
        events += isinstance(step, Impact | Kick | Arrival)
    return inline(clause(scene_of(problem).at(events), relation))


def _possible(setting: Setting, facts: Sequence[Fact]) -> bool | None:
    """Whether some values satisfy these facts alone; None where that is too hard to tell."""
    kept = {(id(fact.given), id(fact.relation)) for fact in facts}
    inside = {id(given) for given, _ in setting.facts}

    def part_with(part: Part) -> Part:
        steps = []
        for step in part.steps:
            if isinstance(step, Given) and id(step) in inside:
                left = tuple(r for r in step.relations if (id(step), id(r)) in kept)
                if not left:
                    continue
                step = replace(step, relations=left)
            steps.append(step)
        return replace(part, steps=tuple(steps))

    parts = {id(part): part_with(part) for part in setting.problem.parts}
    problem = replace(setting.problem, parts=tuple(parts.values()))
    part = parts[id(setting.part)]
    known = roles(problem)
    in_force = givens(problem, part)
    for given, _ in in_force:
        known = {name: narrowed_by(role, name, given, known) for name, role in known.items()}
    own = replace(setting, problem=problem, part=part, facts=in_force, roles=known)
    try:
        return bool(work_out(own).accepted)
    except (ContradictionError, ImpossibleError):
        return False
    except RestitutionError:
        return None
