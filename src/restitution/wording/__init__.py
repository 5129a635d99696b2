"""An exam-style question made from a statement: Problem → text, Markdown, HTML, Typst."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from restitution.wording.document import to_fragment as to_fragment
    from restitution.wording.document import to_html as to_html
    from restitution.wording.document import to_markdown as to_markdown
    from restitution.wording.document import to_text as to_text
    from restitution.wording.document import to_typst as to_typst
    from restitution.wording.structure import Block as Block
    from restitution.wording.structure import Emphasis as Emphasis
    from restitution.wording.structure import Listing as Listing
    from restitution.wording.structure import Paragraph as Paragraph
    from restitution.wording.structure import QuestionPart as QuestionPart
    from restitution.wording.structure import Sentence as Sentence
    from restitution.wording.structure import Words as Words
    from restitution.wording.telling import asked as asked
    from restitution.wording.telling import question as question
    from restitution.wording.whole import Question as Question

__all__ = [
    "Block",
    "Emphasis",
    "Listing",
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

_MODULES = {
    "Block": "structure",
    "Listing": "structure",
    "Emphasis": "structure",
    "Paragraph": "structure",
    "Question": "whole",
    "QuestionPart": "structure",
    "Sentence": "structure",
    "Words": "structure",
    "asked": "telling",
    "question": "telling",
    "to_fragment": "document",
    "to_html": "document",
    "to_markdown": "document",
    "to_text": "document",
    "to_typst": "document",
}


def __getattr__(name: str) -> Any:
    # Who only asks for the units of a statement needs no question in words.
    if name in _MODULES:
        from importlib import import_module

        return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
