"""The JSON object is what other programs were promised, for every example and every error."""

from __future__ import annotations

import json
import re

import pytest
import sympy

import restitution
from restitution import examples
from restitution.errors import StatementError, TimeLimitError
from restitution.export import contract

KINDS = {"value", "vector", "point", "direction", "range", "extremum", "show"}
ERRORS = {"syntax", "missing", "contradiction", "impossible", "unsupported", "time limit"}
CALLED = {"sqrt", "sin", "cos", "tan", "atan", "asin", "acos", "Abs", "pi", "oo", "Interval",
          "Union", "FiniteSet", "Lopen", "Ropen", "open", "EmptySet", "E", "Min", "Max",
          "cot", "sec", "csc",
          "CRootOf", "Piecewise", "True", "Reals", "Rational", "x"}  # fmt: skip


def read_back(text):
    """SymPy's expression, with every letter passed in as a Symbol, as a program would read it."""
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - CALLED
    return sympy.sympify(text, locals={name: sympy.Symbol(name) for name in names})


def content_of(text, file="some.impact", **options):
    line = contract.to_json(
        contract.solved(file, restitution.solve(restitution.parse(text)), **options)
    )
    assert "\n" not in line
    return json.loads(line)


def check_error(error):
    assert error is None or (
        list(error) == ["kind", "message", "line", "column"]
        and error["kind"] in ERRORS
        and error["message"]
        and all(error[key] is None or error[key] > 0 for key in ("line", "column"))
    ), error


def check_exact(exact, kind):
    if isinstance(exact, list):
        assert kind in ("vector", "point", "direction")
        assert len(exact) == 2
        for each in exact:
            assert isinstance(read_back(each), sympy.Expr)
    elif kind == "range":
        assert isinstance(read_back(exact), sympy.Set), exact
    else:
        assert isinstance(read_back(exact), sympy.Expr), exact


def check_decimal(answer, kind):
    exact, number = answer["exact"], answer["decimal"]
    if kind == "range":
        assert number is None
        return
    pairs = zip(exact, number or [None, None]) if isinstance(exact, list) else [(exact, number)]
    for text, value in pairs:
        expression = read_back(text)
        if number is None:
            continue
        assert not expression.free_symbols
        assert value == pytest.approx(float(expression), rel=1e-12, abs=1e-14)
    if number is None:
        texts = exact if isinstance(exact, list) else [exact]
        assert any(read_back(text).free_symbols for text in texts), exact


@pytest.mark.parametrize("name", examples.names())
def test_object_of_every_example(name):
    content = content_of(examples.text(name), file=name)
    assert list(content) == ["file", "title", "parts", "warnings", "error"]
    assert content["file"] == name
    assert content["error"] is None
    assert all(isinstance(warning, str) for warning in content["warnings"])
    lines = examples.text(name).splitlines()
    for part in content["parts"]:
        assert list(part) == ["part", "items"]
        for item in part["items"]:
            assert list(item) == [
                "line", "text", "kind", "answers", "holds", "counterexample", "rejected", "error"
            ]  # fmt: skip
            assert item["kind"] in KINDS
            assert "".join(item["text"].split()) in "".join(lines[item["line"] - 1 :]).replace(
                " ", ""
            )
            check_error(item["error"])
            assert (item["holds"] is None) == (item["kind"] != "show" or bool(item["error"]))
            for answer in item["answers"]:
                assert list(answer) == ["solution", "exact", "decimal", "display", "where"]
                assert answer["solution"] >= 1
                assert answer["display"]
                check_exact(answer["exact"], item["kind"])
                check_decimal(answer, item["kind"])
                for letter, value in (answer["where"] or {}).items():
                    assert isinstance(read_back(letter), sympy.Symbol)
                    assert isinstance(read_back(value), sympy.Expr)
                assert (answer["where"] is None) == (item["kind"] != "extremum")
            for root in item["rejected"]:
                assert list(root) == ["exact", "reason"]
                assert root["reason"]
                check_exact(root["exact"], item["kind"])
            for letter, value in (item["counterexample"] or {}).items():
                assert isinstance(read_back(letter), sympy.Symbol)
                assert not read_back(value).free_symbols
            assert not (item["error"] and item["answers"])
    assert [p["part"] for p in content["parts"]] == list(
        dict.fromkeys(p["part"] for p in content["parts"])
    )


WALL = "wall W: along i\nsphere P: velocity u_1 at λ to W\nP hits W\n"


def test_letters_are_named_for_sympy():
    content = content_of(WALL + "find angle(velocity(P), W), speed(P)\n")
    first, second = content["parts"][0]["items"]
    names = {str(s) for item in (first, second) for s in read_back(item["answers"][0]["exact"])
             .free_symbols}  # fmt: skip
    assert names == {"u_1", "lambda_", "e"}


def test_part_asked_for():
    text = WALL + "part a\nfind speed(P)\npart b\nfind angle(velocity(P), W)\n"
    both, one = content_of(text), content_of(text, label="b")
    assert [part["part"] for part in both["parts"]] == ["a", "b"]
    assert one["parts"] == both["parts"][1:]


def test_item_with_an_error_takes_no_other_with_it():
    content = content_of(WALL + "find impulse, speed(P)\n")
    missing, found = content["parts"][0]["items"]
    assert missing["error"]["kind"] == "missing"
    assert missing["error"]["line"] == 4
    assert missing["answers"] == []
    assert found["error"] is None
    assert found["answers"]
    assert not contract.all_answered(content)


def test_refuted_show_is_answered():
    content = content_of(WALL + "show speed(P) = u_1\n")
    (item,) = content["parts"][0]["items"]
    assert item["holds"] is False
    assert item["counterexample"]
    assert contract.all_answered(content)


def test_unreadable():
    error = StatementError("unknown word", 3, 7)
    content = json.loads(contract.to_json(contract.unreadable("-", error)))
    assert content == {
        "file": "-",
        "title": None,
        "parts": [],
        "warnings": [],
        "error": {"kind": "syntax", "message": "unknown word", "line": 3, "column": 7},
    }
    assert not contract.all_answered(content)


@pytest.mark.parametrize("name", examples.names())
def test_unfinished_names_the_same_items(name):
    problem = restitution.parse(examples.text(name))
    solved = contract.solved(name, restitution.solve(problem))
    unfinished = contract.unfinished(name, problem, TimeLimitError("too long"))

    def items(content):
        return [
            (part["part"], item["line"], item["text"], item["kind"])
            for part in content["parts"]
            for item in part["items"]
        ]

    assert items(unfinished) == items(solved)
    assert unfinished["error"]["kind"] == "time limit"
    assert not contract.all_answered(unfinished)
