"""A range of several forms in the one that has letters in its ends, or another answer that has a
condition, where that takes this.

What is divided by has its sign only there: *e < 3/(2k − 1), as k ≥ 2*.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial

from restitution.components.models import Model
from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Ref, Relation, turned
from restitution.explaining.lines.notation import read_relation
from restitution.expression.tree import Apply, Expression, Letter, has_quantity, letters
from restitution.oracle import BeyondError, Formula, compared
from restitution.planning.routes.order import Solver
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk, NotPlannedError
from restitution.planning.writing.forms import square, tree_of
from restitution.planning.writing.scene import Scene
from restitution.solving.equations.solution import Answer

_ARCS = re.compile(r"\ba(sin|cos|tan)\(")


def write_form(
    scene: Scene, solver: Solver, write: Callable[[], None], answer: Answer, name: str
) -> bool:
    """Writes an answer that holds under a condition; False where that is not possible."""
    condition = None if len(answer.condition) != 1 else _condition(answer.condition[0])
    if condition is None:
        return False
    condition = _in_degrees(scene, condition)
    standing, facts, assumed = solver.mark(), scene.desk.facts, scene.desk.assumed
    with suppress(*UNPLANNED, RestitutionError, BeyondError):
        with _assumed(scene, _case(scene.desk, condition, name)):
            write()
            lines = scene.desk.lines
            require_true(scene.model, lines[standing.desk.lines :], lines, scene.desk.facts)
        return True
    solver.back(standing)
    scene.desk.facts, scene.desk.assumed = facts, assumed
    return False


def write_forms(
    scene: Scene,
    solver: Solver,
    write: Callable[[Answer], None],
    answers: Sequence[Answer],
    name: str,
) -> None:
    """Writes an answer in cases, each under its condition.

    Raises NotPlannedError where one of them cannot be written so.
    """
    standing, facts, assumed = solver.mark(), scene.desk.facts, scene.desk.assumed
    start = len(scene.desk.lines)

    def refused(why: str) -> NotPlannedError:
        """As if none had been tried: of those before it nothing stays in force."""
        solver.back(standing)
        scene.desk.facts, scene.desk.assumed = facts, assumed
        return NotPlannedError(why)

    for number, answer in enumerate(answers, 1):
        own = name if number == 1 else f"{name} {number}"
        if not write_form(scene, solver, partial(write, answer), answer, own):
            raise refused("an answer in cases")
    cases: dict[int, set[Ref]] = {}
    for line in scene.desk.lines[start:]:
        refs = {ref for ref in line.premises if str(ref).startswith("case ")}
        refs.update(*(cases.get(ref, set()) for ref in line.premises if isinstance(ref, int)))
        cases[line.number] = refs
        if len(refs) > 1:
            raise refused("a case that rests on another")


def is_in_a_form(desk: Desk, name: str) -> bool:
    """Whether an item has its lines under such a condition, and has been tried there."""
    return f"case {name}" in desk.assumed


def relation_of_condition(text: str) -> Relation:
    """A condition of an answer as a relation. Raises StatementError for a text that says none."""
    return read_relation(_ARCS.sub(r"arc\1(", text).replace("**", "^"), {})


def _in_degrees(scene: Scene, condition: Relation) -> Relation:
    """A condition, with numbers that bound the letter of an angle in degrees."""
    roles = scene.model.unknowns.roles

    def is_angle(tree: Expression) -> bool:
        return isinstance(tree, Letter) and tree.name in roles and roles[tree.name].kind == "angle"

    def side(tree: Expression, other: Expression) -> Expression:
        return tree_of(scene.scalar(tree), angle=True) if is_angle(other) else tree

    return Relation(
        tuple(
            tuple(
                replace(link, left=side(link.left, link.right), right=side(link.right, link.left))
                for link in links
            )
            for links in condition.options
        )
    )


def _case(desk: Desk, condition: Relation, name: str) -> Fact:
    """A condition as a fact: that of an item above with the same one, whose lines hold here too."""
    own = Fact(f"case {name}", "case", condition, desk.part)
    cases = (fact for fact in desk.facts if fact.id in desk.assumed and fact.kind == "case")
    return next((e for e in cases if (e.relation, e.part) == (condition, desk.part)), own)


def _condition(text: str) -> Relation | None:
    """A condition of an answer as a relation of letters; None of one that has several parts."""
    try:
        condition = relation_of_condition(text)
    except RestitutionError:
        return None
    if len(condition.options) > 1 or any(link.sign not in FLIPPED for link in condition.only):
        return None
    if len(condition.only) > 1:
        return condition
    return Relation(((_by_its_ratio(condition.only[0]),),))


def _by_its_ratio(link: Link) -> Link:
    """A bound of a letter, which stands first; of an acute angle that of its tangent."""
    own = link if letters(link.left) == {getattr(link.left, "name", "")} else turned(link)
    match own:
        case Link(Letter() as angle, sign, Apply("arctan", Apply("sqrt", inside))):
            return Link(square(Apply("tan", angle)), sign, inside)
        case Link(Letter() as angle, sign, Apply("arctan", inside)):
            return Link(Apply("tan", angle), sign, inside)
    return own


@contextmanager
def _assumed(scene: Scene, fact: Fact) -> Iterator[None]:
    """Has a condition in force for a while."""
    own, model = scene.desk, scene.model
    assumed = _within(scene, fact.relation)
    if fact.id in own.assumed:
        own.assumed -= {fact.id}
        own.version += 1
    else:
        own.assume(fact)
    scene.__dict__.pop("facts", None)
    scene.__dict__.pop("judge", None)
    scene.model = assumed
    try:
        yield
    finally:
        scene.model = model
        own.assumed |= {fact.id}
        own.version += 1
        scene.__dict__.pop("facts", None)
        scene.__dict__.pop("judge", None)


def _within(scene: Scene, condition: Relation) -> Model:
    """The solution where a condition of its letters holds.

    Raises UnsupportedError, by a quantity, for a condition that is none of letters.
    """
    assert not any(has_quantity(e) for link in condition.only for e in (link.left, link.right))
    model = scene.model
    claims: list[Formula] = [
        compared(scene.scalar(link.left), link.sign, scene.scalar(link.right))
        for link in condition.only
    ]
    return model.under(claims)
