"""Steps that follow each other without a word, as one; a row that says again what stands above."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise

from restitution.explaining.lines.saying import Sentence, Slot, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.render import layout as lay
from restitution.workings.rendering.steps import Row, Step

# What is said before several rows, and in its place before one.
_ONE: Mapping[tuple[str, Slot], tuple[str, Slot]] = {
    ("components", say("resolved.several")): ("components", say("resolved.one")),
    ("products", say("resolved.several-products")): ("products", say("resolved.one-product")),
}

# Which of its bodies a sentence says to move along the line of centres, and which across it.
_WAYS: Mapping[SentenceId, Mapping[str, str]] = {
    "moves-along.from-rest": {"body": "along"},
    "derived-speed.along-from-rest": {"body": "along"},
    "derived.along-centres-from-rest": {"body": "along"},
    "moves-along.title": {"body": "along"},
    "derived-speed.along": {"body": "along"},
    "derived.along-centres": {"body": "along"},
    "derived-speed.across": {"body": "across"},
    "derived.across-centres": {"body": "across"},
    "derived.apart": {"one": "across", "other": "along"},
    "derived.apart-from-rest": {"one": "across", "other": "along"},
}
_FROM_REST = frozenset(name for name in _WAYS if name.endswith("from-rest"))


def joined(steps: Iterable[Step]) -> Iterator[Step]:
    """Steps with the rows that follow without a word among the rows above them.

    What earns nothing stands with the rows above, whatever item it belongs to, unless the next row
    of its own item goes on from it.
    """
    last: Step | None = None
    known = frozenset[tuple[str, Slot]]()
    for step, after in pairwise((*steps, None)):
        assert step is not None
        own = _only_words(step)
        if own is not None and own.id in _WAYS and own.id not in _FROM_REST and _ways(own) <= known:
            step = replace(step, title=None, sentences=())
        elif step.title or step.sentences:
            ways = frozenset().union(*map(_ways, step.sentences))
            ways |= _ways(step.title) if step.title else frozenset()
            known = ways | known if step.kind == "note" else ways
        if (
            last is not None
            and last.kind == step.kind == "setting"
            and not (last.rows or step.rows)
        ):
            # What letters stand for is said in one paragraph.
            last = replace(last, sentences=(*last.sentences, *step.sentences))
            continue
        wordless = step.rows and not (step.title or step.sentences or step.source)
        alone = not (step.marks or _goes_on(step, after))
        joins = last is not None and (step.item == last.item or alone)
        if last is not None and last.rows and wordless and joins:
            *above, row = last.rows
            whole = _as_one(row, step.rows[0])
            if whole is None and above and _is_between(above[-1], row, step.rows[0]):
                whole = replace(
                    step.rows[0], operands=(row.operands[0], *step.rows[0].operands[1:])
                )
            rows = (row, *step.rows) if whole is None else (whole, *step.rows[1:])
            last = replace(last, rows=(*above, *rows))
            continue
        if last is not None:
            yield _counted(last)
        last = step
    if last is not None:
        yield _counted(last)


def _ways(sentence: Sentence) -> frozenset[tuple[str, Slot]]:
    """Which bodies a sentence says to move along the line of centres, or across it."""
    ways = _WAYS.get(sentence.id, {})
    return frozenset((ways[name], body) for name, body in sentence.slots if name in ways)


def _only_words(step: Step) -> Sentence | None:
    """The title of a step, or its only sentence; None where there are more words, or none."""
    words = [*step.sentences, *([step.title] if step.title else ())]
    return words[0] if len(words) == 1 and step.source is None else None


def _goes_on(step: Step, after: Step | None) -> bool:
    """Whether the rows of the next step begin without a left side, and are of the same item."""
    if after is None or not after.rows or after.item != step.item:
        return False
    return after.rows[0].operands[0] is None


def _counted(step: Step) -> Step:
    """A step whose words before its rows know whether they stand before one component."""
    rows = [row for row in step.rows if row.operands[0] is not None]
    if len(rows) != 1 or not any(
        slot in _ONE for sentence in step.sentences for slot in sentence.slots
    ):
        return step
    sentences = (
        replace(sentence, slots=tuple(_ONE.get(slot, slot) for slot in sentence.slots))
        for sentence in step.sentences
    )
    return replace(step, sentences=tuple(sentences))


def _as_one(row: Row, other: Row) -> Row | None:
    """Two rows as one, where the second says what the first says, or goes on from it."""
    length = len(row.operands)
    if _goes_on_rounded(row, other):
        assert other.operands[-1] is not None
        return replace(
            other,
            operands=(*row.operands, *other.operands[1:]),
            signs=(*row.signs, *other.signs),
            reasons=(*row.reasons, *other.reasons),
            label=other.label or row.label,
        )
    if _says_the_end(row, other):
        number = row.number or other.number
        points, asides = (*row.points, *other.points), (*row.asides, *other.asides)
        answer, label = row.answer or other.answer, row.label or other.label
        return replace(row, points=points, asides=asides, number=number, answer=answer, label=label)
    again = (
        length > 1
        and other.operands[0] in (None, row.operands[0])
        and [_bare(operand) for operand in other.operands[1:length]]
        == [_bare(operand) for operand in row.operands[1:]]
        and other.signs[: length - 1] == row.signs
    )
    if not again or row.reasons or row.asides or (row.number and other.number):
        return None
    operands = (row.operands[0], *other.operands[1:])
    number = row.number or other.number
    points, label = (*row.points, *other.points), other.label or row.label
    return replace(other, operands=operands, points=points, number=number, label=label)


def _goes_on_rounded(row: Row, other: Row) -> bool:
    """Whether a row gives no more than the decimal of the value above it."""
    bare = not (row.points or row.asides or row.number or row.answer)
    same = other.operands[0] in (None, row.operands[0]) and other.signs == ("≈",)
    return bare and same and set(row.signs) == {"="} and not row.alternatives


def _is_between(ratio: Row, row: Row, other: Row) -> bool:
    """Whether a row is no more than the inverse of the ratio above it, before its degrees."""
    bare = not (row.points or row.asides or row.number or row.answer or row.reasons or row.label)
    match row, other:
        case Row((_, lay.Function(name, size)), ("≈",)), Row((left, lay.Degrees()), ("≈",)) if (
            bare and left in (None, row.operands[0]) and name.startswith("arc")
        ):
            first = lay.Function(name.removeprefix("arc"), row.operands[0] or size)
            value = ratio.operands[-1]
            return first == ratio.operands[0] and size in (value, lay.Brackets(value or size))
    return False


def _says_the_end(row: Row, other: Row) -> bool:
    """Whether a row says no more than that the left side of one above it is its last."""
    match other.operands:
        case (left, right) if left in (None, row.operands[0]):
            same = _bare(right) == _bare(row.operands[-1]) and {*row.signs, *other.signs} == {"="}
            return same and not (row.reasons or other.reasons or (row.number and other.number))
    return False


def _bare(layout: lay.Layout | None) -> lay.Layout | None:
    """An operand without its unit."""
    match layout:
        case lay.Phrase((value, lay.Words()), "\u00a0"):
            return value
    return layout


__all__ = ["joined"]
