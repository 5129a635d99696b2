"""A whole question as a value, which shows itself in a terminal and in Jupyter."""

from __future__ import annotations

from restitution.wording.document import to_fragment, to_markdown, to_text
from restitution.wording.structure import QuestionContent


class Question(QuestionContent):
    """A whole question. It shows itself in a terminal and in Jupyter.

    ``intro`` is what is told before anything is asked.
    """

    def __str__(self) -> str:
        return to_text(self)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return to_fragment(self)

    def _repr_markdown_(self) -> str:
        return to_markdown(self)
