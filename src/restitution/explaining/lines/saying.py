"""A sentence put together is a value, its id and what stands in its slots; words come last."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property, lru_cache
from string import Formatter
from typing import TypeAlias

from restitution.explaining.lines.sentences import SENTENCES, SentenceId
from restitution.records import dataclass
from restitution.render.layout import Layout, Phrase
from restitution.render.layout import Words as Text

Words = tuple[str | Layout, ...]
"""Words with mathematics among them, as they are printed."""

Slot: TypeAlias = "str | int | Layout | Sentence | tuple[Slot, ...]"
"""What stands in a slot: a name, a number, mathematics, a sentence, or a list of these."""

_CAPITAL = "capital"


@dataclass(frozen=True)
class Sentence:
    """A sentence of `SENTENCES` with its slots filled; `say` makes one."""

    id: SentenceId
    slots: tuple[tuple[str, Slot], ...] = ()

    @property
    def topic(self) -> str:
        """What the sentence speaks of: the id up to its first dot."""
        return topic_of(self.id)

    @cached_property
    def words(self) -> Words:
        """The sentence in words."""
        return _merged(_spoken(self))

    def __str__(self) -> str:
        """The words of a sentence without mathematics; raises TypeError where there is some."""
        return "".join(self.words)  # type: ignore[arg-type]


def say(name: SentenceId, /, **slots: Slot | Sequence[Slot]) -> Sentence:
    """A sentence by its id; ``say("carried.part", label="a")``.

    Raises KeyError for an id that is not there, and TypeError unless every slot is filled, and
    no other.
    """
    wanted = slots_of(name)
    if wanted != slots.keys():
        raise TypeError(f"{name} has the slots {sorted(wanted)}, and not {sorted(slots)}")
    filled = []
    for other in sorted(slots):
        slot = slots[other]
        filled.append((other, tuple(slot) if isinstance(slot, list) else slot))
    return Sentence(name, tuple(filled))  # type: ignore[arg-type]


def topic_of(name: SentenceId) -> str:
    """The topic of an id: what stands before its first dot."""
    return name.partition(".")[0]


def words_of(sentences: Iterable[Sentence], between: str = " ") -> Words:
    """Several sentences as one run of words."""
    spoken: list[str | Layout] = []
    for sentence in sentences:
        spoken += [between, *sentence.words] if spoken else sentence.words
    return _merged(spoken)


def operand(sentence: Sentence) -> Layout:
    """A sentence as an operand of a line: words and formulas side by side."""
    words = (word.strip() if isinstance(word, str) else word for word in sentence.words)
    items = [Text(word) if isinstance(word, str) else word for word in words if word]
    return items[0] if len(items) == 1 else Phrase(tuple(items))


def note(warning: str) -> str:
    """A warning as it stands under a working."""
    stop = "" if warning.endswith("?") else "."
    return str(say("page.note", warning=warning.removesuffix(".") + stop))


@lru_cache(maxsize=1024)
def _pieces(name: SentenceId) -> tuple[tuple[str, str | None, str], ...]:
    """Words, the slot that follows them (None at the end), and how it is filled."""
    return tuple(
        (text, slot, how or "") for text, slot, how, _ in Formatter().parse(SENTENCES[name])
    )


@lru_cache(maxsize=1024)
def slots_of(name: SentenceId) -> frozenset[str]:
    """The names of the slots of a sentence."""
    return frozenset(slot for _, slot, _ in _pieces(name) if slot is not None)


def _spoken(sentence: Sentence) -> list[str | Layout]:
    slots: Mapping[str, Slot] = dict(sentence.slots)
    words: list[str | Layout] = []
    for text, slot, how in _pieces(sentence.id):
        if text:
            words.append(text)
        if slot is not None:
            words += _filled(slots[slot], how)
    return words


def _filled(slot: Slot, how: str) -> Words:
    if isinstance(slot, tuple):
        return _listed(slot, how)
    if isinstance(slot, Sentence):
        words = slot.words
    else:
        words = (slot,) if isinstance(slot, Layout) else (str(slot),)
    if how == _CAPITAL and words:
        words = (_with_a_capital(words[0]), *words[1:])
    return words


def _with_a_capital(piece: str | Layout) -> str | Layout:
    """Words that begin a sentence; mathematics stays as it is."""
    if isinstance(piece, str):
        return f"{piece[:1].upper()}{piece[1:]}"
    if isinstance(piece, Text):
        return Text(f"{piece.text[:1].upper()}{piece.text[1:]}")
    if isinstance(piece, Phrase):
        first, *rest = piece.items
        begun = _with_a_capital(first)
        return Phrase((begun, *rest), piece.separator) if isinstance(begun, Layout) else piece
    return piece


def _listed(items: tuple[Slot, ...], how: str) -> Words:
    """``a, b and c``, or joined as the template says."""
    last = SENTENCES[f"list.{how}"]
    between = SENTENCES["list.comma"] if how == "and" else last
    spoken: list[str | Layout] = []
    for index, item in enumerate(items):
        if index:
            spoken.append(last if index == len(items) - 1 else between)
        spoken += _filled(item, "")
    return tuple(spoken)


def _merged(words: Iterable[str | Layout]) -> Words:
    """The same words with strings that follow each other as one."""
    merged: list[str | Layout] = []
    for word in words:
        if isinstance(word, str) and merged and isinstance(merged[-1], str):
            merged[-1] += word
        elif word != "":
            merged.append(word)
    return tuple(merged)


__all__ = [
    "Sentence",
    "Slot",
    "Words",
    "note",
    "operand",
    "say",
    "slots_of",
    "topic_of",
    "words_of",
]
