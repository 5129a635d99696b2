"""Published tariffs, read from a file of short blocks, and how workings compare with them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from derivations import FOLDER, derivation_of, read_derivation

from restitution.explaining.awarding.awards import awarded, marks_of
from restitution.explaining.lines.derivation import Derivation, of_part
from restitution.explaining.lines.marks import STYLES, Style
from restitution.language.reading import parse

FILE = Path(__file__).with_name("tariffs.txt")
MOVES = frozenset("UWMNSvVzRTAEFQPItBrd")


@dataclass(frozen=True)
class Tariff:
    """What a paper gives for a question, and a question of the same structure.

    ``marks`` are those of each part, by its label (None: the one part). ``working`` is a working by
    hand of the same structure, and ``of`` the part to which it belongs (None: to all of them);
    ``own`` tells that it is a working of this very statement.
    """

    name: str
    source: str
    style: Style
    marks: Mapping[str | None, int]
    moves: tuple[tuple[str, ...], ...]
    statement: str
    working: Derivation | None = None
    of: str | None = None
    own: bool = False


def by_rule(derivation: Derivation, style: Style) -> dict[str | None, int]:
    """The marks of each part by rule."""
    return marks_of(awarded(derivation, style))


def off_by(tariff: Tariff, derivation: Derivation) -> int:
    """By how many marks a working differs from the tariff.

    The hand's may be for one part; any other is for the whole question.
    """
    of = tariff.of if derivation is tariff.working else None
    wanted = sum(tariff.marks.values()) if of is None else tariff.marks[of]
    return sum(by_rule(derivation, tariff.style).values()) - wanted


def near(
    tariffs: tuple[Tariff, ...], derivation: Callable[[Tariff], Derivation | None], most: int = 2
) -> dict[str, bool | None]:
    """Of each tariff, whether its derivation differs by at most so many; None without one."""
    made = {each.name: (each, derivation(each)) for each in tariffs}
    return {
        name: None if working is None else abs(off_by(each, working)) <= most
        for name, (each, working) in made.items()
    }


def read_tariffs() -> tuple[Tariff, ...]:
    """The tariffs of the file, in order. Raises ValueError for a block that is none."""
    return tuple(_blocks(FILE.read_text()))


def _blocks(text: str) -> Iterator[Tariff]:
    for block in re.split(r"^== ", text, flags=re.MULTILINE)[1:]:
        head, _, rest = block.partition("\n\n")
        name, *fields = head.splitlines()
        told = dict(line.split(": ", 1) for line in fields)
        statement, _, working = rest.partition("\n---\n")
        style: Style = next(each for each in STYLES if each == told["style"])
        moves = tuple(tuple(part.split()) for part in told["moves"].split(" / "))
        if any(each not in MOVES for part in moves for each in part):
            raise ValueError(f"{name}: unknown moves {told['moves']}")
        marks = _marks(told["marks"])
        derivation, of = None, None
        if working.strip():
            derivation = derivation_of(parse(statement), working)
        elif "working" in told:
            derivation, of = _of_a_file(told["working"], marks)
        yield Tariff(
            name,
            told["source"],
            style,
            marks,
            moves,
            statement + "\n",
            derivation,
            of,
            bool(working),
        )


def _of_a_file(text: str, marks: Mapping[str | None, int]) -> tuple[Derivation, str | None]:
    """A working by hand, and the part of the tariff for which it is."""
    file, _, label = text.removesuffix(")").partition(" (")
    derivation = read_derivation(FOLDER / f"{file}.txt")[1]
    if not label or label in marks:
        return derivation, label or None
    return of_part(derivation, label), None


def _marks(text: str) -> dict[str | None, int]:
    if text.isdigit():
        return {None: int(text)}
    return {label: int(number) for label, number in (each.split() for each in text.split(", "))}
