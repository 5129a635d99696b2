"""A noun phrase as a value, and how two become one."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.expression.quantities import KINDS
from restitution.records import dataclass
from restitution.wording.scene import INITIALLY
from restitution.wording.structure import Emphasis, Words
from restitution.wording.words import listed, names, words

INITIAL = "initial "


@dataclass(frozen=True)
class Noun:
    """A noun phrase: ``head`` (the speed of P) and ``when`` (immediately after the impact).

    ``kind`` and ``body`` are there where it can be told together with others of its kind: the
    speeds of A and B. ``tail`` is what follows the body: in the direction of **i**. ``where``
    tells what the letters of a formula denote: where *v* is the speed of A.
    """

    head: Words
    when: Words = ()
    kind: str = ""
    body: str = ""
    tail: Words = ()
    where: Words = ()

    def words(self) -> Words:
        """The whole phrase."""
        phrase = words(self.head, " ", self.when) if self.when else self.head
        return words(phrase, ", ", self.where) if self.where else phrase


def led(words_before: str | Words, inner: Noun) -> Noun:
    """A phrase with words in front."""
    return Noun(words(words_before, inner.head), inner.when)


def pair(lead: str, left: Noun, link: str, right: Noun) -> Noun:
    """Two phrases in one; a moment that both share is told once."""
    if left.when == right.when or not left.when:
        return Noun(words(lead, left.head, link, right.head), right.when)
    return Noun(words(lead, left.words(), link, right.words()))


def at_moment(kind: str, body: str, when: Words) -> Noun:
    """What is said of one body at a moment: ``the initial speed of A``."""
    if when == INITIALLY:
        kind, when = f"{INITIAL}{kind}", ()
    return Noun(of_bodies(kind, (body,)), when, kind, body)


def of_bodies(kind: str, bodies: Sequence[str], *, several: bool = False) -> Words:
    """``the speed of A``, ``the speeds of A and B``; with ``several``, ``the speeds of A``."""
    number = 2 if several else len(bodies)
    return words(f"the {called(kind, number)} of ", names(bodies))


def kinds_of(kinds: Sequence[str], body: str) -> Words:
    """``the speed and the direction of motion of A``."""
    nouns = [f"the {called(kind, 1)}" for kind in kinds]
    return words(listed(nouns), " of ", Emphasis(body))


def called(kind: str, number: int) -> str:
    """``speed``, ``initial speeds``."""
    initial = INITIAL if kind.startswith(INITIAL) else ""
    return initial + KINDS[kind.removeprefix(INITIAL)].called(number)


def of_its_body(one: Noun, other: Noun) -> Words:
    """A second noun, by the body of the first: ``its direction of motion when it hits W``."""
    if one.body != other.body or not other.kind or other.tail:
        return other.words()
    return words(f"its {called(other.kind, 1)}", " " if other.when else "", other.when)
