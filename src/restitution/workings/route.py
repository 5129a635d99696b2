"""A solution to its explanation: planned as a derivation, and put on paper."""

from __future__ import annotations

from restitution.errors import TimeLimitError, UnsupportedError, require
from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.marks import STYLES, Style
from restitution.explaining.lines.saying import say
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution
from restitution.solving.story.letters import roles
from restitution.work import confirm, limited, seconds_of
from restitution.workings.backwards import is_told_backwards, steps_backwards
from restitution.workings.conditions import conditions_of
from restitution.workings.derived import steps_of
from restitution.workings.reasons.other_bounds import other_bounds
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.steps import PartExplanation, Step


def explain(
    solution: Solution,
    part: str | None = None,
    time_limit: float | None = None,
    *,
    marks: Style = "fm1",
    route: int = 1,
    check: bool = False,
) -> Explanation:
    """The worked solution of a problem, or of the part with that label.

    ``marks`` is the style in which marks are given, or ``"none"``. ``route`` chooses among the ways
    to the answers, the best being 1, and ``check`` has every line followed exactly.

    It is whole, or there is none: after ``time_limit`` seconds (None or 0 is no limit; it holds in
    any thread) TimeLimitError is raised.

    Every line is checked by numbers that satisfy the facts before it is kept. An item of which no
    line leads to the answer has the answer alone, and says so. Items without an answer are told
    with their reason. Raises UnsupportedError for the altered world of a mistake,
    KeyError for a part that is not there, and ValueError for a style, a route or a limit that
    cannot be.
    """
    require(solution, Solution, "explain")
    if solution.mistake is not None:
        raise UnsupportedError(
            f"this is the altered world of {solution.mistake}, which has answers and no working"
        )
    if marks not in STYLES:
        raise ValueError(f"there is no style of marks {marks!r}; styles: {', '.join(STYLES)}")
    if route < 1:
        raise ValueError(f"routes are counted from 1, not {route}")
    time_limit = seconds_of(time_limit)
    solution.chosen(part)  # before anything is worked out, where there is no such part
    with limited(time_limit, error=None if time_limit is None else _too_late(time_limit)):
        derivation = awarded(plan(solution, route, partial=True), marks)
        explanation = _printed(solution, derivation, part, check)
        confirm()
    return explanation


def _too_late(seconds: float) -> TimeLimitError:
    return TimeLimitError(f"no working within the time limit of {seconds:g} s")


def _printed(
    solution: Solution, derivation: Derivation, part: str | None, check: bool
) -> Explanation:
    """A derivation in steps and rows."""
    conditions = {**other_bounds(solution, derivation), **conditions_of(solution, derivation)}
    written = steps_of(derivation, solution.problem, conditions)
    parts = tuple(
        PartExplanation(
            label,
            tuple(item.text for item in own_label.items),
            (*_before(derivation, own_label), *written.steps.get(label, ())),
            tuple(_answers(item) for item in own_label.items),
            derivation,
        )
        for label, own_label in solution.parts.items()
        if part is None or label == part
    )
    proved = _proved_on_paper(solution, derivation)
    warnings = [warning for warning in solution.warnings if warning not in proved]
    followed: bool | None = None
    if check:
        from restitution.explaining.following.agreeing import agreeing_facts

        oracle = Oracle(roles(solution.problem))
        complaints = follow(derivation, oracle, agreeing_facts(derivation, oracle))
        warnings += [
            str(say("amiss.complaint", complaint=str(complaint))) for complaint in complaints
        ]
        followed = not complaints
    title = solution.problem.title
    return Explanation(title, parts, tuple(warnings), solution, followed, written.naming.letters)


def _proved_on_paper(solution: Solution, derivation: Derivation) -> set[str]:
    """The warnings of what was only sought, of which the lines of the working are the proof."""
    ended = {item.item for item in derivation.items}
    return {
        item.not_proved
        for label, part in solution.parts.items()
        for name, item in zip(
            [key for key, own in derivation.asked.items() if own == label],
            part.items,
            strict=True,
        )
        if name in ended and item.proof == "undecided"
    }


def _before(derivation: Derivation, part: PartSolution) -> tuple[Step, ...]:
    """Where each contact has to be, of a part that nobody would write out."""
    label = part.part.label
    own = {item for item, other in derivation.asked.items() if other == label}
    noted = {note.item for note in derivation.notes if note.kind == "unwritten"}
    return steps_backwards(part) if own <= noted and is_told_backwards(part) else ()


def _answers(item: ItemResult) -> str:
    if item.error is not None:
        return str(say("answer.reason", item=item.text, reason=item.error.message))
    if item.undecided:
        return str(say("answer.undecided", item=item.text))
    displays = [answer.display for answer in item.distinct]
    if item.holds is not None:
        outcome = say("answer.shown" if item.holds else "answer.false")
        return str(say("answer.outcome", item=item.text, outcomes=[outcome, *displays]))
    return str(say("answer.value", item=item.text, values=displays))
