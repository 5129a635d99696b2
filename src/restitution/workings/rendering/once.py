"""Steps and sentences beside others: a label, a condition or a lead stands once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from operator import is_

from restitution.explaining.lines.saying import Sentence
from restitution.explaining.lines.sentences import SentenceId
from restitution.workings.rendering.steps import Step

_PERCENTAGES: Mapping[SentenceId, SentenceId] = {
    "made.fraction-lost": "made.percentage-lost",
    "fraction-lost.title": "fraction-lost.percentage",
    "fraction-lost.at-a-wall": "fraction-lost.percentage-at-a-wall",
}


def in_turn(first: tuple[Sentence, ...], then: tuple[Sentence, ...]) -> tuple[Sentence, ...]:
    """Sentences before a row: of two that both lead up to it, the first does not."""
    if then:
        first = tuple(
            replace(e, id="extremum.value-there") if e.id == "extremum.value" else e for e in first
        )
    return (*first, *then)


def labelled_once(steps: Iterable[Step]) -> Iterator[Step]:
    """Steps with labels where chains begin; once for what is asked under one number."""
    last = ""
    for step in steps:
        label = "" if step.label == last else step.label
        last = step.label or last
        labels = [""] * len(step.rows)
        start = 0
        for index, row in enumerate(step.rows):
            if row.operands[0] is not None:
                start = index
            if row.label:
                labels[start] = labels[start] if row.label == last else row.label
                last = row.label
        rows = tuple(
            row if row.label == own else replace(row, label=own)
            for row, own in zip(step.rows, labels, strict=True)
        )
        same = label == step.label and all(map(is_, rows, step.rows))
        yield step if same else replace(step, rows=rows, label=label)


def reasoned_once(steps: Iterable[Step]) -> Iterator[Step]:
    """Steps in which a row does not repeat the reason of the row just above it."""
    for step in steps:
        rows = [
            replace(row, reasons=()) if row.reasons and row.reasons == above.reasons else row
            for above, row in pairwise(step.rows)
        ]
        yield replace(step, rows=(*step.rows[:1], *rows)) if rows else step


def without_its_condition(step: Step, condition: Sentence | None) -> Step:
    """A step without the reason that the sentence below it says as a condition."""
    bound = None if condition is None else dict(condition.slots).get("condition")
    if bound is None or not step.rows:
        return step
    last = step.rows[-1]
    kept = tuple(
        reason
        for reason in last.reasons
        if reason.id != "derived.as" or dict(reason.slots).get("reasons") != (bound,)
    )
    return replace(step, rows=(*step.rows[:-1], replace(last, reasons=kept)))


def spoken(sentence: Sentence) -> tuple[object, ...]:
    """What a sentence says, as a title or with the colon that stands behind one."""
    *words, last = sentence.words
    return (*words, last.removesuffix(":") if isinstance(last, str) else last)


def of_a_percentage(sentence: Sentence) -> Sentence:
    """What speaks of a fraction, of a percentage."""
    name = _PERCENTAGES.get(sentence.id)
    return sentence if name is None else Sentence(name, sentence.slots)
