"""An exam-style question made from a statement: Problem → text, Markdown, HTML, Typst."""

from __future__ import annotations

from restitution.wording.html import to_fragment, to_html
from restitution.wording.markup import to_markdown
from restitution.wording.structure import (
    Block,
    Listing,
    Named,
    Paragraph,
    QuestionPart,
    Sentence,
    Words,
)
from restitution.wording.telling import asked, question
from restitution.wording.text import to_text
from restitution.wording.typst import to_typst
from restitution.wording.whole import Question

__all__ = [
    "Block",
    "Listing",
    "Named",
    "Paragraph",
    "Question",
    "QuestionPart",
    "Sentence",
    "Words",
    "asked",
    "question",
    "to_fragment",
    "to_html",
    "to_markdown",
    "to_text",
    "to_typst",
]
