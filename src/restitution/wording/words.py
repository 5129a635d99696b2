"""Words put together: flattening, lists with "and", sentences with a capital and a full stop."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from restitution.counting import counted
from restitution.wording.structure import Emphasis, Piece, Sentence, Words

_COUNTS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]


def words(*parts: Piece | Words) -> Words:
    """One row of pieces from pieces and rows of them; neighbouring texts become one."""
    flat: list[Piece] = []

    def add(part: Piece | Words) -> None:
        if isinstance(part, tuple):
            for word in part:
                add(word)
        elif isinstance(part, str) and flat and isinstance(flat[-1], str):
            flat[-1] += part
        elif part != "":
            flat.append(part)

    for part in parts:
        add(part)
    return tuple(flat)


def sentence(*parts: Piece | Words) -> Sentence:
    """Words with a capital at the beginning and a full stop at the end."""
    phrase = words(*parts, ".")
    if isinstance(phrase[0], str):
        return (phrase[0][:1].upper() + phrase[0][1:], *phrase[1:])
    return phrase


def listed(phrases: Sequence[Piece | Words], link: str = "and") -> Words:
    """``A``, ``A and B``, ``A, B and C``."""
    if len(phrases) < 2:
        return words(*phrases)
    front: list[Piece | Words] = [phrases[0]]
    for item in phrases[1:-1]:
        front += [", ", item]
    before = "" if link.startswith(",") else " "
    return words(*front, f"{before}{link} ", phrases[-1])


def number_of_words(phrase: Words) -> int:
    """How many words are read; a name, or a piece of mathematics, is one."""
    return sum(len(word.split()) if isinstance(word, str) else 1 for word in phrase)


def names(bodies: Iterable[str]) -> Words:
    """``A, B and C``, in italics."""
    return listed([Emphasis(name) for name in bodies])


def count(number: int) -> str:
    """``two``, ``three``, …"""
    return _COUNTS[number] if number < len(_COUNTS) else str(number)


def roman(number: int) -> str:
    """``i``, ``ii``, ``iii``, ``iv``, …"""
    out = ""
    for value, sign in ((50, "l"), (40, "xl"), (10, "x"), (9, "ix"), (5, "v"), (4, "iv"), (1, "i")):
        while number >= value:
            out += sign
            number -= value
    return out


def alphabetic(number: int) -> str:
    """``a``, ``b``, …, ``z``, ``aa``, …"""
    out = ""
    while number:
        number, rest = divmod(number - 1, 26)
        out = chr(ord("a") + rest) + out
    return out


def count_of_marks(number: int) -> str:
    """``(1 mark)``, ``(5 marks)``."""
    return f"({counted(number, 'mark')})"
