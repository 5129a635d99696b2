"""What a letter of a vector may be rests on the data that introduce it, and on nothing later.

A line that says no more than the data (a true ``show``, a ``given`` that follows, a wall that
nothing hits) changes neither what a letter may be nor any other answer.
"""

from __future__ import annotations

from functools import cache

import pytest

from restitution.language import parse
from restitution.oracle.roles import ACUTE, POSITIVE, REAL, TO_180, Role
from restitution.solving import solve
from restitution.solving.story.letters import roles

STORIES = {
    "a wall along i + j": """
        wall W: along i + j
        sphere P: mass m, velocity p i + 2j
        P hits W: e = 1/2
        """,
    "a wall along j": """
        wall W: along j
        sphere P: mass m, velocity p i - q j
        P hits W: e = 1
        """,
    "two spheres": """
        sphere A: mass m, velocity p i + q j
        sphere B: mass m, at rest
        A hits B: along i, e = 1
        """,
    "a line of centres in letters": """
        sphere A: mass m, velocity u i
        sphere B: mass 2m, at rest
        A hits B: along k i + j, e = 1/2
        """,
    "a blow in letters": """
        sphere P: mass m, at (0, 0), velocity 3i
        P receives m a i + m b j
        """,
    "a velocity that is given": """
        wall W: along j
        sphere P: mass m
        P hits W: e = 1/2
        given velocity(P) = -2i + b j
        """,
}
VELOCITY = "a wall along i + j", "a wall along j", "two spheres"
STEPS = (
    "show velocity({body}) = {letter} i",
    "show velocity({body}) = -2{letter} j",
    "show velocity({body}) = ({letter} + 1) i + {letter} j",
    "show velocity({body}) + velocity({body}, 0) = {letter} at 30°",
    "show along(velocity({body}), i) = {letter}",
    "show speed({body}) = {letter}",
    "given velocity({body}) parallel to ({letter} + 6) i + {letter} j",
    "{body} receives {letter} m i + {letter} m j",
    "find dot(velocity({body}), ({letter} + 1, {letter}))",
)
DECLARED = ("wall V: along ({letter} + 6) i + {letter} j", "point C: ({letter}, 1)")


def _leaves_letters(name: str, line: str) -> bool:
    story = STORIES[name]
    alone = roles(parse(story))
    body = "P" if "P" in story else "A"
    for letter in alone.keys() - {"m"}:
        more = line.format(body=body, letter=letter)
        text = f"{more}\n{story}" if line in DECLARED else f"{story}\n{more}"
        if {letter: roles(parse(text))[letter] for letter in alone} != alone:
            return False
    return True


@pytest.mark.parametrize("line", STEPS)
@pytest.mark.parametrize("name", STORIES)
def test_a_later_line_leaves_what_a_letter_may_be(name: str, line: str) -> None:
    assert _leaves_letters(name, line)


@pytest.mark.parametrize("line", DECLARED)
@pytest.mark.parametrize("name", VELOCITY)
def test_what_is_declared_leaves_the_letters_of_velocities(name: str, line: str) -> None:
    assert _leaves_letters(name, line)


@cache
def _last_answer(text: str) -> tuple[object, ...]:
    item = solve(parse(text)).parts[None].items[-1]
    return item.holds, item.error, *((a.exact, a.condition) for a in item.distinct)


@pytest.mark.parametrize(
    ("story", "asked", "lines"),
    [
        (
            "a wall along i + j",
            ("show p > -6", "find speed(P)"),
            (
                "show velocity(P) = (p/4 + 3/2) i + (3p/4 + 1/2) j",
                "given velocity(P) parallel to (p + 6) i + (3p + 2) j",
            ),
        ),
        (
            "a wall along i + j",
            ("given speed(P)^2 = 5/2, find p",),
            ("show p^2 i + 2p j = p^2 i + 2p j",),
        ),
        ("a wall along j", ("show q > -6",), ("show velocity(P) + velocity(P, 0) = -2q j",)),
        (
            "two spheres",
            ("show direction(A) = 90°",),
            ("show velocity(A) = q j", "given velocity(B) parallel to p i"),
        ),
        (
            "a line of centres in letters",
            ("given velocity(B) = 2u/5 i + u/5 j, find k",),
            ("show velocity(B, 0) + 2k i = 2k i", "given velocity(B) parallel to k^2 i + k j"),
        ),
    ],
)
def test_what_follows_changes_no_other_answer(
    story: str, asked: tuple[str, ...], lines: tuple[str, ...]
) -> None:
    for question in asked:
        *given, last = question.split(", ") if question.startswith("given") else (question,)
        before = "\n".join((STORIES[story], *given))
        alone = _last_answer(f"{before}\n{last}")
        for line in lines:
            assert _last_answer(f"{before}\n{line}\n{last}") == alone, line


@pytest.mark.parametrize(
    ("statement", "letter", "role"),
    [
        ("sphere P: velocity u i", "u", POSITIVE),
        ("sphere P: velocity -2u j", "u", POSITIVE),
        ("sphere P: velocity u i + 3u j", "u", POSITIVE),
        ("sphere P: velocity 3p i - 4j", "p", REAL),
        ("sphere P: velocity p i + 2j\nsphere Q: velocity -p i", "p", POSITIVE),
        ("sphere P: mass p, velocity p i + 2j", "p", POSITIVE),
        ("sphere P: at (d, 0), velocity i", "d", REAL),
        ("sphere P: at (d, 2d), velocity i", "d", POSITIVE),
        ("sphere P: velocity i\nshow velocity(P) = p i + 2j", "p", REAL),
        ("sphere P: velocity i\ngiven deflection(P) = t\nshow tan(t) = 2", "t", TO_180),
        ("sphere P: velocity i\ngiven deflection(P) = t, tan(t) = 2", "t", ACUTE),
        ("sphere P: velocity i\ngiven t = s, speed(P) = 1\nshow tan(t) = 2", "t", ACUTE),
        (
            "sphere P: velocity i\ngiven speed(P) = k/2\nshow along(velocity(P), i) = k",
            "k",
            POSITIVE,
        ),
    ],
)
def test_what_introduces_a_letter_says_what_it_may_be(
    statement: str, letter: str, role: Role
) -> None:
    assert roles(parse(statement))[letter] == role
