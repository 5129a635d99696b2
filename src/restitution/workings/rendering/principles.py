"""More about the principles that a step of the working uses: why each holds, and what goes wrong.

The texts are for students, in words alone. They belong to the topics of `SENTENCES`, so that a
step needs nothing beyond what it says anyway.
"""

from __future__ import annotations

from restitution.explaining.lines.saying import Sentence
from restitution.explaining.lines.sentences import SENTENCES
from restitution.workings.rendering.steps import Step


def about(step: Step | Sentence) -> str | None:
    """A few sentences on the principle of a step, or None where the step uses none of them.

    In place of a step a sentence will do: the title of a principle, or one that uses it.
    """
    for sentence in (step,) if isinstance(step, Sentence) else _sentences(step):
        texts = [
            SENTENCES[name]
            for name in (f"{sentence.topic}.why", f"{sentence.topic}.mistakes")
            if name in SENTENCES
        ]
        if texts:
            return " ".join(texts)
    return None


def _sentences(step: Step) -> tuple[Sentence, ...]:
    return step.sentences if step.title is None else (step.title, *step.sentences)
