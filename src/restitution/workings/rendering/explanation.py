"""A worked solution that shows itself: in a terminal, in Jupyter, on a page."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.awarding.awards import awarded
from restitution.records import dataclass
from restitution.workings.rendering.document import to_fragment, to_latex, to_markdown, to_text
from restitution.workings.rendering.steps import PartExplanation, Working


@dataclass(frozen=True, repr=False)
class Explanation(Working):
    """A whole worked solution, and what it explains. It shows itself in a terminal and in Jupyter.

    Pictures are not among its steps until ``illustrated`` puts them there.
    """

    def without_marks(self) -> Explanation:
        """The same without any marks."""
        return replace(self, parts=tuple(map(_unmarked, self.parts)))

    def __str__(self) -> str:
        return to_text(self)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from restitution.workings.rendering.illustrate import illustrated

        return to_fragment(illustrated(self))

    def _repr_markdown_(self) -> str:
        from restitution.workings.rendering.illustrate import illustrated

        return to_markdown(illustrated(self))

    def _repr_latex_(self) -> str:
        return to_latex(self, document=False)


def _unmarked(part: PartExplanation) -> PartExplanation:
    steps = tuple(
        replace(step, points=(), rows=tuple(replace(row, points=()) for row in step.rows))
        for step in part.steps
    )
    return replace(part, steps=steps, derivation=awarded(part.derivation, "none"))
