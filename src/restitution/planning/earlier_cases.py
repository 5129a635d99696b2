"""What one case of an earlier part says, for the solution of a later part that goes on from it."""

from __future__ import annotations

from contextlib import suppress

from restitution.explaining.lines.derivation import Case, Link, Relation
from restitution.expression.tree import Letter
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene


def recall_case(scene: Scene) -> None:
    """Has the values of the case of an earlier part in which the solution of a scene stands.

    Nothing is recalled where the lines of several cases are true of it, or of none.
    """
    desk = scene.desk
    if not desk.apart or not desk.cases:
        return
    last = max(case.line for case in desk.cases)
    cases = [case for case in desk.cases if case.line == last]
    own = [case for case in cases if _is_true(scene, case)]
    if len(own) != 1 or len(cases) < 2:
        return
    (case,) = own
    desk.splits += ((case.line, case.option),)
    desk.within |= {*case.lines}
    options = {case.line: case.option} | dict.fromkeys(case.lines, 0)
    for number, option in options.items():
        relation = desk.line(number).relation
        if not isinstance(relation, Relation):
            continue
        if number == case.line or len(relation.options) == 1:
            _know_value(scene, number, relation.options[option])


def _know_value(scene: Scene, number: int, links: tuple[Link, ...]) -> None:
    """Has the value that a line gives to a letter."""
    letter, value = links[0].left, links[-1].right
    if isinstance(letter, Letter) and all(link.sign == "=" for link in links):
        own = scene.scalar(value)
        if not own.free_symbols & scene.model.final.keys():
            scene.desk.know(letter, own, (number,))


def _is_true(scene: Scene, case: Case) -> bool:
    """Whether all that a case says is true at the numbers of the solution."""
    lines = [scene.desk.line(number) for number in case.lines]
    with suppress(NotPlannedError):
        require_true(scene.model, lines, scene.desk.lines, scene.desk.facts)
        return True
    return False


__all__ = ["recall_case"]
