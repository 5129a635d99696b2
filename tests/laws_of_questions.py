"""A question worded from a statement: nothing lost, nothing invented, and in good English."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path

from statements import FILES, law

from restitution.language import parse
from restitution.problem import trees
from restitution.render import layout as lay
from restitution.wording import (
    Block,
    Emphasis,
    Listing,
    Question,
    question,
    to_html,
    to_markdown,
    to_text,
    to_typst,
)
from restitution.wording.words import number_of_words


@cache
def worded(path: Path) -> Question:
    return question(parse(path.read_text(encoding="utf-8")))


def lines_of(path: Path) -> list[str]:
    """The lines of a statement that say something, without comments and title."""
    text = path.read_text(encoding="utf-8").replace("\\\n", " ")
    lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    return [line for line in lines if line and not line.startswith("title")]


def sentences(asked: Question) -> list[tuple]:
    """Every sentence, and every entry of a list together with its lead."""
    out = list(asked.intro)
    for part in asked.parts:
        for block in part.body:
            if isinstance(block, Listing):
                out += [(*block.lead, " ", *entry) for _, entry in block.rows()]
            else:
                out += block.sentences
    return out


def leaves(value: object, kind: type) -> list:
    """All nodes of a kind inside pieces and layouts."""
    found = [value] if isinstance(value, kind) else []
    if isinstance(value, tuple):
        found += [one for each in value for one in leaves(each, kind)]
    elif is_dataclass(value):
        found += [one for each in fields(value) for one in leaves(getattr(value, each.name), kind)]
    return found


@law(FILES)
def every_number_of_the_statement_is_told(path: Path) -> None:
    asked = worded(path)
    said = {Fraction(each.digits) for each in leaves(asked, lay.Number)}
    text = to_text(asked, 10_000)
    said |= {Fraction(each) / 100 for each in re.findall(r"(\d+)%", text)}
    said |= {Fraction(2)} if "twice" in text else set()
    said |= {Fraction(1), Fraction(2)} if "half of" in text.lower() else set()
    said |= {Fraction(0)} if re.search("negative|positive", text) else set()
    # The square of a quantity, and "correct to 3 significant figures".
    said |= {Fraction(2)} if "the square of" in text or "m²" in text else set()
    said |= {Fraction(each) for each in re.findall(r"correct to (\d+)", text)}
    said |= {Fraction(2)} if "²" in text else set()
    said |= {Fraction(0)} if "(1, 0)" in path.read_text(encoding="utf-8") else set()
    for line in lines_of(path):
        for number in numbers_in(line):
            assert number in said, (line, number)


def numbers_in(line: str) -> list[Fraction]:
    """The numbers of a line but those of names, subscripts and stages."""
    line = re.sub(r"part \w+|\b[A-Z]\w*|\b[a-z]\w*?_?\d+\b", " ", line)
    line = re.sub(r"\((\s*,)?\s*\d+\s*\)(?!/)|,\s*\d+\)", ")", line) if "find" in line else line
    line = re.sub(r"([a-z]\( *),? *\d+\)", r"\1)", line)
    return [
        Fraction(number) / (100 if percent else 1)
        for number, percent in re.findall(r"(?<![\w.])(\d+(?:\.\d+)?)(%?)", line)
    ]


@law(FILES)
def every_letter_and_name_of_the_statement_is_told(path: Path) -> None:
    problem = parse(path.read_text(encoding="utf-8"))
    asked = question(problem)
    said = {f"{x.name}_{x.subscript}".rstrip("_") for x in leaves(asked, lay.Letter)}
    told = {letter for tree in trees(problem) for letter in letters_of(tree)}
    for _, step in problem.steps():
        told |= {getattr(step, "letter", None) or "", *(getattr(step, "letters", None) or ())}
        told |= set(getattr(step, "in_terms_of", None) or ())
    assert told - {""} <= said
    names = {each.text for each in leaves(asked, Emphasis)}
    assert names == {each.name for each in (*problem.spheres, *problem.walls, *problem.points)}


def letters_of(tree: object) -> set[str]:
    if type(tree).__name__ == "Letter":
        return {tree.name}
    found: set[str] = set()
    for each in fields(tree) if is_dataclass(tree) else ():
        value = getattr(tree, each.name)
        for one in value if isinstance(value, tuple) else (value,):
            found |= letters_of(one)
    return found


@law(FILES)
def every_event_and_every_item_is_told(path: Path) -> None:
    lines = lines_of(path)
    asked = worded(path)
    text = " ".join(to_text(asked, 10_000).split())
    told = " ".join(
        text
        for text in map(plain, sentences(asked))
        if not text.startswith(("Given", "Find", "Show"))
    )
    hits = sum(bool(re.match(r"[A-Z]\w* hits ", each)) for each in lines)
    assert (
        len(re.findall(r"\b(?<!when )[A-Z]\w*(?: then)? (?:hits|collides with) [A-Z]", told))
        >= hits
    )
    assert text.count("receives an impulse") == sum(" receives " in each for each in lines)
    shows = [each for each in lines if each.startswith("show ")]
    assert len(re.findall(r"[Ss]how(?:, [^.]*?,)? that", text)) == len(shows)
    finds = ", ".join(each for each in lines if each.startswith("find "))
    assert text.count("range of possible values") >= finds.count("range of")
    assert len(re.findall("greatest possible|least possible", text)) == sum(
        each.count("maximum of") + each.count("minimum of") for each in lines
    )
    assert text.count("in terms of") == sum(" in terms of " in each for each in lines)
    assert text.count("percentage") == sum(each.count("as a percentage") for each in lines)
    rests = sum(each.startswith("sphere") and "at rest" in each for each in lines)
    assert text.count("at rest") >= (1 if rests else 0)
    for word in ("perpendicular", "parallel"):
        if any(f" {word} to" in each for each in lines):
            assert word in text


def plain(sentence: tuple) -> str:
    asked = replace(EMPTY, intro=(sentence,))
    return to_text(asked, 10_000)


EMPTY = Question(None, (), ())


@law(FILES)
def sentences_are_sentences(path: Path) -> None:
    asked = worded(path)
    for each in sentences(asked):
        text = plain(each)
        assert re.match(r"[A-Z]", text), text
        assert text.endswith((".", ",")), text
        check_english(each)


def check_english(said: tuple) -> None:
    text = plain(said)
    for wrong in ("  ", " ,", " .", ",,", "..", ", .", "None", "event", "( "):
        assert wrong not in text, (wrong, text)
    # Articles before words: names and mathematics may look like letters.
    words = "".join(each if isinstance(each, str) else "#" for each in said)
    assert not re.search(r"\b[Aa] (?!uni)[aeiou]", words), text
    assert not re.search(r"\b[Aa]n [^aeiou]", words), text
    assert not re.search(r"\b([a-z]{2,}) \1\b", words), text
    assert text.count("(") == text.count(")"), text


def fragment(asked: Question) -> str:
    return re.sub(r"<!DOCTYPE html>|<meta[^>]*>", "", to_html(asked))


@law(FILES)
def html_and_markdown_say_the_same(path: Path) -> None:
    asked = worded(path)
    # A long formula stands in pieces, between which a line may end.
    whole = re.sub(r"</math>(<wbr>)?<math[^>]*>", "", fragment(asked))
    page = ET.fromstring(whole.replace("<wbr>", ""))
    assert not page.findall(".//script")
    words = [
        re.findall(r"[A-Za-z]{3,}", " ".join(each for each in one if isinstance(each, str)))
        for one in sentences(asked)
    ]
    seen = "".join(page.itertext())
    markdown = to_markdown(asked)
    typst = to_typst(asked)
    for each in {word for one in words for word in one}:
        assert each in seen and each in markdown and each in typst
    assert markdown.replace("\\$", "").count("$") % 2 == 0
    rows = [
        *asked.intro,
        *(row for part in asked.parts for block in part.body for row in told(block)),
    ]
    assert len(page.findall(".//math")) == sum(
        not isinstance(piece, str | Emphasis) for row in rows for piece in row
    )


def told(block: Block) -> list[tuple]:
    if isinstance(block, Listing):
        return [block.lead, *(entry.words for entry in block.entries)]
    return list(block.sentences)


# More than a long sentence of an examination paper has; a formula counts as one word.
LONGEST = 60


TANGLES = (
    "𝟎 minus",
    "minus 𝟎",
    "minus the coordinates",
    "negative of the coordinates",
    "the direction to the coordinates",
    "the sum of the sum",
    "the product of the product",
    "is negative of",
    "the magnitude of the vector from",
)


def read_through(asked_question: Question) -> None:
    for each in sentences(asked_question):
        text = plain(each)
        assert number_of_words(each) <= LONGEST, (number_of_words(each), text)
        for tangle in TANGLES:
            assert tangle not in text, (tangle, text)
        # Two names side by side belong to two clauses.
        for one, between, other in zip(each, each[1:], each[2:], strict=False):
            assert not (
                between == " " and isinstance(one, Emphasis) and isinstance(other, Emphasis)
            ), text


@law(FILES)
def what_is_printed_can_be_read(path: Path) -> None:
    read_through(worded(path))
