"""Whatever the bytes, reading answers with a problem or with a StatementError, and at once."""

from __future__ import annotations

from importlib.resources import files

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import NAMES, expressions, problems

from restitution.errors import StatementError
from restitution.expression import read_expression, write_expression
from restitution.expression.words import WORDS
from restitution.language import parse, to_statement
from restitution.language.doubts import doubts

STATEMENTS = sorted(
    each.read_text(encoding="utf-8")
    for each in files("restitution.examples").iterdir()
    if each.name.endswith(".impact")
)
PIECES = sorted(WORDS | set(NAMES)) + [
    "u",
    "v",
    "e",
    "1/2",
    "60°",
    "(",
    ")",
    ",",
    ":",
    "=",
    "<",
    "-",
    "+",
    "*",
    "/",
    "^",
    "√",
    "²",
    "i",
    "j",
    "3i",
    "at",
    "rest",
    "to",
    "3",
    "s.f.",
    "in",
    "terms",
    "of",
    "#",
    "\\",
    "~",
    "π",
    "μ",
    "½",
    "kg",
    "m/s",
    "g",
    "m",
    "cm",
    "J",
    "N s",
    "km/h",
]


def outcome(text: str | bytes) -> str:
    """``read`` or ``refused``; anything else is a fault."""
    try:
        problem = parse(text)
    except StatementError as error:
        assert error.line is not None
        assert error.column is not None
        assert error.line >= 1
        assert error.column >= 1
        return "refused"
    assert parse(to_statement(problem)) == problem
    return "read"


@given(expressions())
@settings(max_examples=300, deadline=None)
def test_expressions_survive_the_round_trip(tree) -> None:
    assert read_expression(write_expression(tree), names=NAMES) == tree


@given(problems())
@settings(max_examples=150, deadline=None)
def test_problems_survive_the_round_trip(problem) -> None:
    text = to_statement(problem)
    again = parse(text)
    assert again == problem
    # What is written is never doubtful; what it says may be.
    assert again.notes == tuple(doubts(again, text))
    assert to_statement(again) == text


@given(st.one_of(st.binary(max_size=300), st.text(max_size=300)))
@settings(max_examples=200, deadline=None)
def test_any_text(text) -> None:
    outcome(text)


@given(
    st.lists(st.lists(st.sampled_from(PIECES), max_size=12).map(" ".join), max_size=6).map(
        "\n".join
    )
)
@settings(max_examples=200, deadline=None)
def test_words_of_the_language_in_any_order(text) -> None:
    outcome("sphere A\nsphere B\nwall W\n" + text)


@st.composite
def mutated(draw: st.DrawFn) -> str:
    """A statement with a few places cut out, doubled or overwritten."""
    text = draw(st.sampled_from(STATEMENTS))
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(text)))
        end = min(len(text), at + draw(st.integers(0, 6)))
        new = draw(
            st.one_of(st.sampled_from(PIECES), st.text(max_size=3), st.just(text[at:end] * 2))
        )
        text = text[:at] + new + text[end:]
    return text


@given(mutated())
@settings(max_examples=300, deadline=None)
def test_statements_with_slips(text) -> None:
    outcome(text)


LONG = "the line is too long: at most 2000 characters"
WORDY = "the line is too long: at most 1000 words and signs"
DEEP = "the expression is too long or nested too deeply: at most 100 operations one upon another"
# Each with the place and the message of its refusal, or without where it is read.
EXTREMES = [
    (b"\xff\xfa\x00", (1, 1), "the text is not UTF-8: byte 0xff"),
    ("title Ä".encode("utf-16"), (None, None), "the text is in UTF-16: save it in UTF-8"),
    (b"title caf\xe9", (1, 10), "the text is not UTF-8: byte 0xe9"),
    ("sphere A: mass \x00", (1, 16), "unexpected character U+0000"),
    ("find " + "x" * 10_000_000, (1, 1), "the text is too long: at most 100000 bytes"),
    ("find " + "x " * 45_000, (1, 1), LONG),
    ("find " + "(" * 1000 + "e" + ")" * 1000, (1, 1), LONG),
    ("find " + "((" * 24 + "e" + "))" * 24, None, None),
    ("find " + "-" * 1900 + "e", (1, 1005), WORDY),
    ("find " + "1+" * 900 + "1", (1, 1005), WORDY),
    ("find " + "e^" * 400 + "e", (1, 606), DEEP),
    ("find " + "sin " * 300 + "e", (1, 806), DEEP),
    ("find " + "√" * 1000 + "e", (1, 1005), WORDY),
    ("find 9^9^9^9^9^9", None, None),
    ("find " + "9" * 1500, (1, 6), "a number has at most 40 digits"),
    ("find " + "\\\n" * 900, (1, 5), "expected what is to be found"),
    (
        "\n".join(f"sphere A{n}: mass {n}" for n in range(300)),
        (101, 1),
        "a statement has at most 100 spheres, walls and points",
    ),
    ("\n".join(["fnd e"] * 900), (1, 1), "unknown word 'fnd': did you mean 'find'?"),
    ("\n" * 90_000, (1001, 1), "a statement has at most 1000 lines"),
    (
        "\n".join(f"sphere {word}: mass 1" for word in sorted(WORDS)),
        (1, 8),
        "expected the name of a sphere",
    ),
    (
        "\n".join(f"find {word}" for word in sorted(WORDS)),
        (1, 9),
        "expected a number, a letter or '(' after 'abs'",
    ),
    (
        "sphere A\nwall W\n" + "A hits W\n" * 900,
        (63, 1),
        "a statement tells at most 60 events",
    ),
    ("find " + "aaaa " * 390, (1, 1254), WORDY),
    ("find " + "unknownword " * 160, (1, 6), "unknown word 'unknownword'"),
    ("\n".join(["find " + "u*" * 40 + "u"] * 900), None, None),
]
MOST_MISTAKES = 20


@pytest.mark.parametrize(("text", "place", "message"), EXTREMES, ids=lambda x: repr(x)[:20])
def test_extremes_are_read_or_refused_at_their_place(text, place, message) -> None:
    """As told, and whole: what is refused says where, and no more mistakes than one reads."""
    if message is None:
        assert outcome(text) == "read"
        return
    with pytest.raises(StatementError) as refused:
        parse(text)
    assert (refused.value.line, refused.value.column) == place
    assert refused.value.message.startswith(message)
    assert 1 + len(refused.value.others) <= MOST_MISTAKES
