"""What a mistake leads to: a question solved in its world, beside the true answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

from restitution import work
from restitution.errors import (
    RestitutionError,
    TimeLimitError,
    UnsupportedError,
)
from restitution.exact import same
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.alteration import Alteration
from restitution.explaining.mistakes.altered import AlteredProblem, altered
from restitution.explaining.mistakes.misconceptions import (
    MISCONCEPTIONS,
    VariantAt,
    misconception,
    mistake_id,
)
from restitution.expression.enclosed import UndefinedError
from restitution.problem import Problem
from restitution.records import dataclass
from restitution.solving.equations.solution import Answer, ItemResult, Solution
from restitution.solving.solver import solve

_SECONDS = 4.0
"""For each variant, where no other limit is set."""


@dataclass(frozen=True)
class ChangedItem:
    """An item with another answer in the world of a mistake than in the true one."""

    part: str | None
    true: ItemResult
    altered: ItemResult

    @property
    def text(self) -> str:
        return self.true.text


@dataclass(frozen=True)
class AlteredWorld:
    """A question in the world of one variant of a mistake, solved.

    ``items`` are those of which the answer changes.
    """

    alteration: Alteration
    at: tuple[VariantAt, ...]
    solution: Solution
    items: tuple[ChangedItem, ...]

    @property
    def id(self) -> str:
        return self.alteration.id

    @property
    def words(self) -> str:
        """What the variant does, with the names of the bodies where they are the same all along."""
        pairs = {variant.event.bodies[:2] for variant in self.at}
        words = self.alteration.words
        if len(pairs) != 1:
            return words
        for name, body in zip(("the first body", "the second body"), *pairs, strict=False):
            words = words.replace(name, body)
        return words

    @property
    def events(self) -> tuple[int, ...]:
        """The numbers of the events at which something is altered."""
        return tuple(variant.event.number for variant in self.at)


def altered_world(
    solution: Solution,
    variant: Alteration,
    only: Iterable[int] | None = None,
    time_limit: float | None = _SECONDS,
) -> AlteredWorld:
    """A solved question in the world of a variant, at all impacts or at those in ``only``.

    Raises UnsupportedError, with the reason, where the variant has no world, or does not apply.
    """
    if not variant.solvable:
        raise UnsupportedError(
            f"{variant.id} alters lines of working, and has no world of its own: its equations "
            "do not tell the motion"
        )
    changed = altered(solution.problem, variant, only)
    if changed is None:
        raise UnsupportedError(
            f"{variant.id} does not apply here: {_needs(variant, solution.problem)}"
        )
    solved = _solved(changed, time_limit)
    if not _sensible(changed, solved):
        raise UnsupportedError(
            f"{variant.id} does not apply here: its signs are those of other directions"
        )
    return AlteredWorld(variant, changed.at, solved, tuple(_changed(solution, solved)))


def _solved(changed: AlteredProblem, time_limit: float | None) -> Solution:
    return replace(solve(changed.problem, time_limit), mistake=changed.alteration.id)


def _needs(variant: Alteration, problem: Problem) -> str:
    """What a question lacks to which a variant does not apply."""
    if variant.results and not _has(variant, problem):
        return f"{NO_IMPACT} {_PLACES[variant.where]}"
    if variant.results:
        kinds = dict.fromkeys(result.quantity.partition("(")[0] for result in variant.results)
        spoken = " or ".join(kind.replace("_", " ") for kind in kinds)
        return f"the statement does not speak of {spoken} in a way that it alters"
    if variant.mistake == "second-wall-angle":
        return "no sphere goes from one wall to another"
    return f"{NO_IMPACT} {_PLACES[variant.where]}"


NO_IMPACT = "there is no impact"
_PLACES = {"wall": "with a wall", "spheres": "of two spheres", "impact": ""}


def _has(variant: Alteration, problem: Problem) -> bool:
    """Whether there is an impact of the kind at which a variant is made."""
    wall = variant.where == "wall"
    return any(event.kind == "impact" and event.wall == wall for event in events_of(problem))


def _sensible(changed: AlteredProblem, solution: Solution) -> bool:
    """Whether angles that are subtracted come out positive, as far as numbers tell."""
    senses = [
        result.sense for at in changed.at for result in at.results if result.sense is not None
    ]
    for part in solution.parts.values():
        for branch in part.branches:
            story = branch.numbers
            for sense in senses:
                try:
                    value = story.evaluator(len(story.happenings)).scalar(sense)
                except (RestitutionError, UndefinedError, ArithmeticError):
                    continue
                if value.sign < 0:
                    return False
    return True


def _changed(true: Solution, altered_: Solution) -> Iterator[ChangedItem]:
    for (part, one), (_, other) in zip(true.items(), altered_.items(), strict=True):
        if one.error is None and _differs(one, other):
            yield ChangedItem(part.part.label, one, other)


def _differs(true: ItemResult, other: ItemResult) -> bool:
    """Whether an item has another answer, or a value that was rejected in place of one."""
    if other.error is not None:
        return bool(other.rejected)
    if true.holds is not None or other.holds is not None:
        return true.holds != other.holds
    if len(true.distinct) != len(other.distinct):
        return True
    pairs = zip(true.distinct, other.distinct, strict=True)
    return any(not _equal(one, another) for one, another in pairs)


def _equal(one: Answer, other: Answer) -> bool:
    if one.exact == other.exact and one.display == other.display:
        return True
    if isinstance(one.decimal, float) and isinstance(other.decimal, float):
        return abs(one.decimal - other.decimal) <= 1e-9 * max(1.0, abs(one.decimal))
    values = [
        answer.value if isinstance(answer.value, tuple) else (answer.value,)
        for answer in (one, other)
    ]
    try:
        return len(values[0]) == len(values[1]) and all(
            bool(same(a, b)) for a, b in zip(*values, strict=True)
        )
    except (AttributeError, TypeError, ValueError):
        return False


def altered_worlds(
    solution: Solution,
    name: str,
    only: Iterable[int] | None = None,
    time_limit: float | None = None,
    part: str | None = None,
) -> tuple[AlteredWorld, ...]:
    """The worlds of a mistake, or of one variant ``ID/N``, in which an answer changes.

    With ``part``, a label, only items of that part count. Raises StatementError for an unknown id,
    UnsupportedError, with the reason and the mistakes that apply, where there is no such world.
    """
    time_limit = work.seconds_of(time_limit)
    worlds: list[AlteredWorld] = []
    reasons: dict[str, None] = {}
    with (
        suppress(TimeLimitError),  # what was solved by then is kept
        work.limited(time_limit, error=TimeLimitError(_LATE)),
    ):
        for world in _worlds(solution, name, only, part, reasons, time_limit):
            worlds.append(world)  # noqa: PERF402 - each is kept, also where the next is broken off
    return tuple(worlds) or _none(solution, name, reasons)


def first_world(solution: Solution, name: str, time_limit: float | None = None) -> AlteredWorld:
    """The first world of a mistake, or of one variant ``ID/N``, in which an answer changes.

    Raises what `altered_worlds` raises.
    """
    time_limit = work.seconds_of(time_limit)
    reasons: dict[str, None] = {}
    with work.limited(time_limit, error=TimeLimitError(_LATE)):
        world = next(_worlds(solution, name, None, None, reasons, time_limit), None)
    return world or _none(solution, name, reasons)[0]


def _worlds(
    solution: Solution,
    name: str,
    only: Iterable[int] | None,
    part: str | None,
    reasons: dict[str, None],
    time_limit: float | None,
) -> Iterator[AlteredWorld]:
    """The worlds in which an answer changes, as they are solved; why others are none.

    One that takes long leaves time for the others.
    """
    seconds = _SECONDS if time_limit is None else min(_SECONDS, time_limit / 4)
    record = misconception(name)
    for variant in record.variants:
        if name not in (variant.id, record.id):
            continue
        try:
            world = altered_world(solution, variant, only, seconds)
        except UnsupportedError as error:
            reasons[error.message] = None
            continue
        items = tuple(item for item in world.items if part in (None, item.part))
        if items:
            yield replace(world, items=items)
        else:
            reasons[_unchanged(world)] = None


def _none(solution: Solution, name: str, reasons: Iterable[str]) -> tuple[AlteredWorld, ...]:
    """Raises UnsupportedError: why there is no world, and which mistakes apply."""
    record = misconception(name)
    if record.world == "none":
        why = (
            f"{name} has no world of its own: {record.sentence[:1].lower()}{record.sentence[1:-1]}"
        )
    else:
        wanted = [variant for variant in record.variants if name in (variant.id, record.id)]
        why = _why_not(name, wanted, list(reasons) or [_LATE])
    raise UnsupportedError(f"{why}; {_those_that_apply(solution.problem)}")


def solve_as(problem: Problem, mistake: str, time_limit: float | None = None) -> Solution:
    """Solves a problem as someone would who makes a mistake: its answers in an altered world.

    ``mistake`` is the id of one, such as ``"momentum-sign"`` (its first variant that changes an
    answer), or of a variant, ``"momentum-sign/2"``. Raises StatementError for an unknown id, and
    UnsupportedError, with the reason, for a mistake without a world, or that changes nothing here.
    """
    misconception(mistake)
    mistake = mistake_id(mistake)
    return first_world(solve(problem, time_limit), mistake, time_limit).solution


_LATE = "no answer in the world of the mistake within the time limit"


def _unchanged(world: AlteredWorld) -> str:
    errors = [item.error for _, item in world.solution.items() if item.error is not None]
    if errors:
        return f"{world.id} leads to no answer: {errors[0].message}"
    return f"{world.id} changes no answer here"


def _why_not(name: str, wanted: list[Alteration], reasons: list[str]) -> str:
    if len(wanted) == 1:
        return reasons[0]
    apply = [
        reason
        for reason in reasons
        if "does not apply" not in reason and "has no world" not in reason
    ]
    if not apply:
        nearest = next((reason for reason in reasons if NO_IMPACT not in reason), reasons[0])
        return f"{name} does not apply here: {nearest.partition(': ')[2]}"
    if all("leads to no answer" in reason for reason in apply):
        return f"{name} leads to no answer here: {apply[0].partition(': ')[2]}"
    return f"{name} changes no answer here"


def _those_that_apply(problem: Problem) -> str:
    names = applying(problem)
    return f"these apply: {', '.join(names)}" if names else "no mistake applies"


def applying(problem: Problem) -> tuple[str, ...]:
    """The ids of the mistakes that can be made in a problem."""
    return tuple(name for name in MISCONCEPTIONS if can_be_made(name, problem))


def can_be_made(name: str, problem: Problem) -> bool:
    """Whether a mistake, by its id, can be made in a problem."""
    return bool(events_of(problem)) and any(
        variant.solvable and altered(problem, variant) is not None
        for variant in MISCONCEPTIONS[name].variants
    )
