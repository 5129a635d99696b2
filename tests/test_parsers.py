"""The parsers that are stored when the package is built: the same as those made of the grammar."""

from __future__ import annotations

import importlib.util
from fnmatch import fnmatch
from pathlib import Path

import lark
import pytest
from lark.parsers.lalr_analysis import Shift

import restitution
from restitution.errors import StatementError
from restitution.expression import parsers
from restitution.expression.grammar import EXPRESSION
from restitution.expression.parsers import built, loaded, make_parser, saved
from restitution.expression.reading import expression_parser, read_expression
from restitution.language.grammar import STATEMENT

ROOT = Path(__file__).parents[1]
GRAMMARS = {"expression": EXPRESSION, "line": STATEMENT}
SMALL = "%declare NAME\nstart: NAME+"
OTHER = "%declare NAME\nstart: NAME NAME"


def same(one, other, start):
    """Whether two tables are one, but for the numbers of their states."""
    first, second = one.parser.parser._parse_table, other.parser.parser._parse_table
    pairs = {first.start_states[start]: second.start_states[start]}
    waiting = list(pairs)
    while waiting:
        state = waiting.pop()
        here, there = first.states[state], second.states[pairs[state]]
        if here.keys() != there.keys():
            return False
        for token, (action, goal) in here.items():
            action_there, goal_there = there[token]
            if action is not action_there:
                return False
            if action is not Shift:
                if goal != goal_there or goal.alias != goal_there.alias:
                    return False
            elif goal not in pairs:
                pairs[goal] = goal_there
                waiting.append(goal)
            elif pairs[goal] != goal_there:
                return False
    return len(pairs) == len(first.states) == len(second.states) == len(set(pairs.values()))


@pytest.mark.parametrize(("start", "grammar"), GRAMMARS.items(), ids=GRAMMARS)
def test_stored_parser_is_the_one_of_the_grammar(start, grammar):
    stored = loaded(saved(grammar, start), grammar, start)
    assert stored is not None
    fresh = built(grammar, start)
    assert same(stored, fresh, start)
    assert stored.rules == fresh.rules
    assert vars(stored.options) == vars(fresh.options)


def test_tables_that_differ_are_seen_to_differ():
    changed = EXPRESSION.replace("| PLUS signed -> positive", "", 1)
    assert changed != EXPRESSION
    assert not same(built(changed, "expression"), built(EXPRESSION, "expression"), "expression")
    # a table in which one way is missing, or leads elsewhere
    one, other = built(EXPRESSION, "expression"), built(EXPRESSION, "expression")
    states = other.parser.parser._parse_table.states
    crossing = next(s for s in states.values() if s.get("PLUS") != s.get("MINUS"))
    crossing["PLUS"], crossing["MINUS"] = crossing["MINUS"], crossing["PLUS"]
    assert not same(one, other, "expression")


def test_an_expression_and_a_mistake_are_read_with_a_stored_parser(monkeypatch, tmp_path):
    text, mistake = "2u sin 30° + v^2/(1 + e)", "2u + )"
    expected = read_expression(text)
    with pytest.raises(StatementError) as first:
        read_expression(mistake)
    (tmp_path / "expression.table").write_bytes(saved(EXPRESSION, "expression"))
    monkeypatch.setattr(parsers, "FOLDER", tmp_path)
    monkeypatch.setattr(parsers, "built", None)  # so it can come from the table only
    expression_parser.cache_clear()
    try:
        assert read_expression(text) == expected
        with pytest.raises(StatementError) as second:
            read_expression(mistake)
    finally:
        expression_parser.cache_clear()
    assert str(second.value) == str(first.value)


def test_a_table_of_another_grammar_is_not_used(monkeypatch, tmp_path):
    monkeypatch.setattr(parsers, "FOLDER", tmp_path)
    (tmp_path / "start.table").write_bytes(saved(OTHER, "start"))
    three = [lark.Token("NAME", each) for each in "ABC"]
    with pytest.raises(lark.UnexpectedToken):
        make_parser(OTHER, "start").parse(three)
    assert [str(each) for each in make_parser(SMALL, "start").parse(three).children] == list("ABC")


def test_a_table_of_another_lark_or_another_start_is_not_used(monkeypatch):
    table = saved(SMALL, "start")
    assert loaded(table, SMALL, "start") is not None
    assert loaded(table, SMALL, "line") is None
    assert loaded(table, SMALL + "\n", "start") is None
    monkeypatch.setattr(lark, "__version__", "0.0")
    assert loaded(table, SMALL, "start") is None


@pytest.mark.parametrize(
    "stored",
    [b"", b"\x80\x05K\x01.", saved(SMALL, "start")[1:]],
    ids=["nothing", "a number", "a table without its first byte"],
)
def test_what_is_no_table_is_never_loaded(monkeypatch, tmp_path, stored):
    monkeypatch.setattr(parsers, "FOLDER", tmp_path)
    monkeypatch.setattr(lark.Lark, "load", None)
    (tmp_path / "start.table").write_bytes(stored)
    assert loaded(stored, SMALL, "start") is None
    assert make_parser(SMALL, "start").parse([lark.Token("NAME", "A")])


def test_the_build_makes_a_table_for_every_parser():
    """Where it is looked for, of the grammar that is asked for, and kept out of the history."""
    spec = importlib.util.spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    hook = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(hook)
    made = hook.tables(ROOT / "src")
    folder = "src" / parsers.FOLDER.relative_to(Path(restitution.__file__).parents[1])
    assert made.keys() == {f"{folder.as_posix()}/{start}.table" for start in GRAMMARS}
    for name, table in made.items():
        start = Path(name).stem
        assert loaded(table, GRAMMARS[start], start) is not None
        project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
        assert f'"{Path(name).parent.as_posix()}/*.table",' in project
        ignored = (ROOT / ".gitignore").read_text(encoding="utf-8").split()
        assert any(fnmatch(name, each + "*" * each.endswith("/")) for each in ignored)
