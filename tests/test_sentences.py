"""The sentences of a working: each is used, is filled as it asks, and stands in one package."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import restitution.examples
from restitution import examples
from restitution.explaining.lines.marks import Mark, written
from restitution.explaining.lines.saying import Sentence, operand, say, slots_of, topic_of, words_of
from restitution.explaining.lines.sentences import SENTENCES, SUBJECTS
from restitution.explaining.lines.usual_mistakes import USUAL_MISTAKES
from restitution.language import parse
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.solving import solve
from restitution.workings import explain

# Who reads and writes lines in the language of statements, and judges them, writes no sentences.
NOT_FOR_READERS = {
    "principles.py",
    "algebra.py",
    "at_events.py",
    "awards.py",
    "derivation.py",
    "facts.py",
    "follower.py",
    "layouts.py",
    "mark_conditions.py",
    "mark_rules.py",
    "notation.py",
    "quotients.py",
    "rules.py",
    "samples_of_lines.py",
    "senses.py",
    "signs.py",
    "step.py",
    "storing.py",
    "tracing.py",
    "trees.py",
    "trials.py",
}
# What is said of mistakes, and of their worlds, stands in files of its own.
OF_MISTAKES = {
    "alterations.py",
    "consequences.py",
    "listing.py",
    "misconceptions.py",
    "usual_mistakes.py",
}
SOURCE = Path(restitution.examples.__file__).parent.parent
PACKAGE = SOURCE / "workings"


@cache
def modules() -> dict[Path, ast.Module]:
    """The modules that have sentences for readers, as trees."""
    return {
        path: ast.parse(path.read_text(encoding="utf-8"))
        for folder in (PACKAGE, SOURCE / "components", SOURCE / "explaining")
        for path in sorted(folder.rglob("*.py"))
        if folder.name != "explaining"
        or (
            path.parent.name not in ("moves", "sentences")
            and path.name not in NOT_FOR_READERS | OF_MISTAKES
        )
    }


# Two words that are no sentence: how statements are written, markup, and what errors call things.
NO_SENTENCES = {
    "perpendicular to",
    "parallel to",
    "in the direction of",
    "opposite to",
    "the centre",
    "the radius",
    "the end",
    "the end of a wall",
    *("approach ", "axis ", "contact ", "impulse ", "let ", "mass "),  # how facts are named
    *("position ", "velocity ", "wall ", "within "),
}
RENDERERS = {"html.py", "markup.py", "typst.py"}
MARKUP = {"STYLE", "_PAGE", "PREAMBLE", "_PREAMBLE"}


def calls_of_say() -> Iterator[tuple[Path, ast.Call, str]]:
    """Every place where a sentence is put together, with each id that it may have there."""
    for path, tree in modules().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "say":
                name = node.args[0]
                for each in (name.body, name.orelse) if isinstance(name, ast.IfExp) else (name,):
                    if isinstance(each, ast.Constant):
                        yield path, node, each.value


def test_every_sentence_is_filled_as_it_asks() -> None:
    places = list(calls_of_say())
    assert len(places) > 150
    for path, call, name in places:
        where = f"{path.name}:{call.lineno}"
        assert name in SENTENCES, (where, name)
        filled = {each.arg for each in call.keywords}
        if None not in filled:  # what ``**`` brings is seen only when it runs
            assert filled == slots_of(name), (where, name)


def test_every_sentence_is_used() -> None:
    written_there = {
        node.value
        for tree in modules().values()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    topics = {topic_of(each) for each in written_there if each in SENTENCES}
    joined = {f"list.{how}" for text in SENTENCES.values() for how in re.findall(r":(\w+)}", text)}
    for name in SENTENCES:
        topic, _, rest = name.partition(".")
        used = name in written_there or name in joined or topic == "ordinal"
        assert used or (rest in ("why", "mistakes") and topic in topics), name


def test_a_sentence_stands_in_one_module() -> None:
    """An id that two modules had would be that of the last one, without a word."""
    ids = [name for subject in SUBJECTS for name in subject.SENTENCES]
    assert sorted([*ids, *USUAL_MISTAKES]) == sorted(SENTENCES)


def test_sentences_stand_in_one_package() -> None:
    """No two words in a row among the strings of the modules, but for a few that are none."""
    for path, tree in modules().items():
        excepted = {id(each) for each in silent(tree)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                several = re.search(r"[A-Za-z]{2,},? [a-z]|[a-z]{2,} $|^ [a-z]{2,}", node.value)
                fine = not several or id(node) in excepted or node.value in NO_SENTENCES
                fine = fine or (path.name in RENDERERS and any(c in node.value for c in "<#\\"))
                assert fine, (path.name, node.lineno, node.value)


def silent(tree: ast.Module) -> Iterator[ast.AST]:
    """The strings that no reader of a working sees: documentation, errors, markup."""
    for node in ast.walk(tree):
        error = isinstance(node, ast.Call) and str(getattr(node.func, "id", "")).endswith("Error")
        markup = isinstance(node, ast.Assign) and any(
            isinstance(each, ast.Name) and each.id in MARKUP for each in node.targets
        )
        remark = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if error or markup or remark or isinstance(node, ast.Raise):
            yield from ast.walk(node)


def test_nothing_reads_words_again() -> None:
    for path, tree in modules().items():
        imported = {
            name.name
            for node in ast.walk(tree)
            if isinstance(node, ast.Import)
            for name in node.names
        }
        assert "re" not in imported, path.name


@pytest.mark.parametrize("name", SENTENCES)
def test_sentences_are_fit_to_print(name: str) -> None:
    text = SENTENCES[name]
    assert text and "  " not in text
    assert not re.search(r" [.,:;]", text) or topic_of(name) == "list"
    assert text.count("{") == text.count("}")
    assert topic_of(name) == name.split(".")[0]
    if name.endswith(".mistakes"):
        assert f"{topic_of(name)}.why" in SENTENCES
        assert text.startswith("Usual mistake")


def test_a_sentence_is_a_value() -> None:
    one = say("touch.apart", one="A", other="B", distance=lay.Number("3"))
    assert one == say("touch.apart", distance=lay.Number("3"), other="B", one="A")
    assert len({one, say("so"), say("so")}) == 2
    assert one.topic == "touch"
    assert one.words == (
        "A and B touch when their centres are ",
        lay.Number("3"),
        " apart:",
    )


def test_lists_capitals_and_sentences_in_slots() -> None:
    three = say("given.fact", fact=say("claim.rest", body="A"))
    assert str(three) == "It is given that A is at rest:"
    assert str(say("answer.value", item="v", values=["1", "2", "3"])) == "v = 1 or 2 or 3"
    heading = say("heading.impact", order=say("ordinal.2"), first="A", second="B")
    assert str(heading) == "Second impact: A hits B"
    components = [say("unchanged.component", value=lay.Number("1"), body=each) for each in "ABC"]
    words = say("unchanged.components", components=components).words
    spoken = "".join(each if isinstance(each, str) else to_text(each) for each in words)
    assert spoken == "the components stay 1 for A, 1 for B and 1 for C."
    assert words_of([say("so"), say("given.data")]) == ("So It is given that",)
    one = say("unchanged.component", value=lay.Letter("v"), body="A")
    assert to_text(operand(one)) == "v for A"


def test_a_sentence_that_is_not_there_or_not_filled_is_refused() -> None:
    with pytest.raises(KeyError):
        say("no.such-sentence")
    with pytest.raises(TypeError, match="label"):
        say("carried.part")
    with pytest.raises(TypeError, match="label"):
        say("so", label="a")
    with pytest.raises(TypeError):
        str(say("note.above-one", value=lay.Bold("i")))  # mathematics is no string


def test_marks_are_data() -> None:
    methods = (Mark("M"), Mark("M", dependent=True))
    answers = (Mark("A"), Mark("A", star=True), Mark("A", ft=True), Mark("B", number=2))
    assert written((*methods, *answers)) == "M1 DM1 A1 A1* A1ft B2"
    assert written(()) == ""


@pytest.mark.parametrize("name", list(examples.names())[::9])
def test_every_step_of_a_working_is_made_of_sentences_and_reasoned_marks(name: str) -> None:
    explanation = explain(solve(parse(examples.text(name))))
    steps = [step for part in explanation.parts for step in part.steps]
    points = [mark for step in steps for each in (step, *step.rows) for mark in each.points]
    assert len(points) == explanation.marks > 0
    assert all(mark.because in SENTENCES for mark in points)
    for step in steps:
        assert all(isinstance(each, Sentence) for each in step.sentences)
        spoken = "".join(each if isinstance(each, str) else "…" for each in step.words)
        assert "{" not in spoken and "  " not in spoken
