"""A solved problem as pictures to scale: scenes of shapes as data, and SVG made of them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from restitution.records import dataclass

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from restitution.drawing.scene import Scene
    from restitution.expression.tree import Expression
    from restitution.solving.equations.solution import PartSolution, Solution
    from restitution.staging.values import When
    from restitution.vector import Vector

__all__ = ["Drawings", "figure", "scenes", "thumbnail"]


@dataclass(frozen=True)
class Drawings:
    """The pictures of a solved problem, in the order of its events. They show themselves in
    Jupyter.
    """

    scenes: tuple[Scene, ...]

    @property
    def svgs(self) -> tuple[str, ...]:
        """Each picture as the text of an SVG file."""
        from restitution.drawing.svg import to_svg

        return tuple(to_svg(scene) for scene in self.scenes)

    def _repr_mimebundle_(self, **wanted: Any) -> dict[str, Any]:
        """For Jupyter: PNG on white, which every theme shows; SVG where typst is not installed."""
        from restitution.drawing.convert import converted
        from restitution.drawing.svg import stacked
        from restitution.errors import UnsupportedError

        svg = stacked(self.scenes)
        try:
            return {"image/png": converted(svg, "png", 160)}
        except UnsupportedError:
            return {"image/svg+xml": svg}


def scenes(
    solution: Solution,
    part: str | None = None,
    letters: Mapping[Expression, str] | None = None,
) -> tuple[Scene, ...]:
    """A plan of the paths, and then for each impact and blow from outside one of before and after.

    A plan is drawn of a story with places, or of several events with a wall; its ``event`` is None.

    An impact for which a coefficient of restitution outside [0, 1] is found is shown as before, and
    says so; no event after it is drawn.

    ``letters`` are those that the working introduces, by the quantities for which they stand: what
    has none there is shown by its value, or without a letter. None where no working is at hand.

    An event is drawn by the values of the first part that is solved with it; with ``part``, all
    events up to that part by its values. Raises KeyError for a part that is not there, and what
    kept it from being solved (ContradictionError, ImpossibleError, …) where nothing can be drawn.
    """
    pictures = _pictures(solution, _parts(solution, part), letters)
    return tuple(sorted(pictures, key=lambda scene: scene.event is not None))


def thumbnail(solution: Solution) -> Scene | None:
    """The first picture of a solved problem, small and without words; None where there is none.

    Raises what kept the problem from being solved where nothing can be drawn.
    """
    from restitution.drawing.small import small

    first = next(_pictures(solution, _parts(solution, None), None), None)
    return None if first is None else small(first)


def figure(solution: Solution) -> Scene | None:
    """What the question tells, and nothing of its answers.

    A plan of walls and places for a story of several events or with places; else the first event
    as it is before. None where nothing can be drawn.
    """
    from restitution.drawing.path import path_figure

    solved = [part for part in solution.parts.values() if part.branches]
    if solved and _says_more(solution, solved[-1]):
        plan = path_figure(solution, solved[-1], solved[-1].branches[0])
        if plan is not None:
            return plan
    return _before(solution, solved[0]) if solved else None


def _before(solution: Solution, part: PartSolution) -> Scene | None:
    """The first event as it is before; None where the line of centres or the wall is sought."""
    from restitution.drawing.before_after import before_and_after
    from restitution.drawing.sayings import sayings
    from restitution.problem import Impact, Kick
    from restitution.staging.values import motion

    branch, still_open = part.branches[0], part.open_story
    numbers = motion(solution, part, branch)
    for happening in numbers.story.happenings:
        if not isinstance(happening.step, Impact | Kick):
            continue
        number, sought = happening.number, set(branch.values)
        before: list[Vector] = []
        if still_open is not None:
            first = still_open.happenings[number - 1]
            before = list(first.before.values())
            if first.centres is not None and _letters([first.centres]) & sought:
                return None
        scene = before_and_after(
            numbers,
            sayings(numbers),
            number,
            ("before",),
            question=True,
            to_scale=not _letters(before) & sought,
        )
        return replace(scene, part=part.part.label, event=number)
    return None


def _letters(vectors: Iterable[Vector]) -> frozenset[str]:
    from restitution.exact.symbols import symbol_names

    return symbol_names(*(component for vector in vectors for component in vector))


def _says_more(solution: Solution, part: PartSolution) -> bool:
    """Whether a plan says more than the picture of one impact does."""
    placed = any(sphere.position is not None for sphere in solution.problem.spheres)
    return placed or len(part.branches[0].numbers.happenings) > 1


def _parts(solution: Solution, part: str | None) -> list[PartSolution]:
    """The parts to be drawn: those that have values."""
    parts = solution.chosen(part)
    solved = [part for part in parts if part.branches]
    errors = [part.error for part in parts if part.error is not None]
    if errors and not solved:
        raise errors[0]
    return solved


def _pictures(
    solution: Solution,
    parts: Iterable[PartSolution],
    letters: Mapping[Expression, str] | None,
) -> Iterator[Scene]:
    """The plan and a picture of each event, by the values of the first part that has it."""
    from restitution.drawing.before_after import before_and_after
    from restitution.drawing.describe import is_possible
    from restitution.drawing.path import path_scene
    from restitution.drawing.sayings import sayings
    from restitution.problem import Impact, Kick
    from restitution.staging.values import motion

    drawn = 0
    for part in parts:
        branch = part.branches[0]
        if len(branch.numbers.happenings) == drawn:
            continue
        numbers = motion(solution, part, branch)
        question_words = sayings(numbers, letters)
        possible = all(
            is_possible(numbers, happening.number) for happening in numbers.story.happenings
        )
        if possible and _says_more(solution, part):
            plan = path_scene(solution, part, branch, numbers)
            if plan is not None:
                yield replace(plan, part=part.part.label)
        for happening in numbers.story.happenings[drawn:]:
            if isinstance(happening.step, Impact | Kick):
                panels: Sequence[When] = ("before", "after")
                panels = panels if is_possible(numbers, happening.number) else panels[:1]
                scene = before_and_after(
                    numbers, question_words, happening.number, panels, letters=letters
                )
                yield replace(scene, part=part.part.label, event=happening.number)
            if not is_possible(numbers, happening.number):
                return
        drawn = len(numbers.story.happenings)
