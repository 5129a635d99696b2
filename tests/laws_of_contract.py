"""Laws of the JSON object: it is what other programs were promised."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
import sympy
from statements import EXAMPLES, law, solved

from restitution.errors import TimeLimitError
from restitution.export import contract

KINDS = {"value", "vector", "point", "direction", "range", "extremum", "show"}
ERRORS = {"syntax", "missing", "contradiction", "impossible", "unsupported", "time limit"}
PROOFS = {None, "algebra", "decision", "intervals", "witness", "undecided"}
CALLED = {"sqrt", "sin", "cos", "tan", "atan", "asin", "acos", "Abs", "pi", "oo", "Interval",
          "Union", "FiniteSet", "Lopen", "Ropen", "open", "EmptySet", "E", "Min", "Max",
          "cot", "sec", "csc",
          "CRootOf", "Piecewise", "True", "Reals", "Rational", "x"}  # fmt: skip


def read_back(text: str) -> Any:
    """SymPy's expression, with every letter passed in as a Symbol, as a program would read it."""
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - CALLED
    return sympy.sympify(text, locals={name: sympy.Symbol(name) for name in names})


def check_error(error: Any) -> None:
    assert error is None or (
        list(error) == ["kind", "message", "line", "column", "fixes"]
        and error["kind"] in ERRORS
        and error["message"]
        and all(error[key] is None or error[key] > 0 for key in ("line", "column"))
    ), error


def check_exact(exact: Any, kind: str) -> None:
    if isinstance(exact, list):
        assert kind in ("vector", "point", "direction")
        assert len(exact) == 2
        for each in exact:
            assert isinstance(read_back(each), sympy.Expr)
    elif kind == "range":
        assert isinstance(read_back(exact), sympy.Set), exact
    else:
        assert isinstance(read_back(exact), sympy.Expr), exact


def check_decimal(answer: Any, kind: str) -> None:
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


def check_condition(condition: Any) -> None:
    """Relations, or chains of them, between texts that SymPy reads; several joined by "or"."""
    for each in condition:
        for chain in each.split(" or "):
            sides = re.split(" (?:<=?|>=?|=|!=) ", chain)
            assert len(sides) > 1
            assert all(isinstance(read_back(side), sympy.Expr) for side in sides)


@law(EXAMPLES)
def the_object_is_what_was_promised(path: Path) -> None:
    name = path.stem
    content = json.loads(contract.to_json(contract.solved(name, solved(path))))
    assert list(content) == ["file", "title", "parts", "warnings", "notes", "error"]
    assert content["file"] == name
    assert content["error"] is None
    assert all(isinstance(warning, str) for warning in content["warnings"])
    lines = path.read_text(encoding="utf-8").splitlines()
    for part in content["parts"]:
        assert list(part) == ["part", "items"]
        for item in part["items"]:
            assert list(item) == [
                "line", "text", "kind", "unit", "answers", "holds", "proof", "trials",
                "counterexample", "rejected", "error",
            ]  # fmt: skip
            assert item["kind"] in KINDS
            assert "".join(item["text"].split()) in "".join(lines[item["line"] - 1 :]).replace(
                " ", ""
            )
            check_error(item["error"])
            assert (item["holds"] is None) == (
                item["kind"] != "show" or bool(item["error"]) or item["proof"] == "undecided"
            )
            assert item["proof"] in PROOFS
            if item["kind"] == "show":
                assert (item["proof"] is None) == bool(item["error"])
            assert item["trials"] >= 0
            for answer in item["answers"]:
                assert list(answer) == [
                    "solution", "exact", "decimal", "display", "where", "condition"
                ]  # fmt: skip
                check_condition(answer["condition"])
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


@law(EXAMPLES)
def an_unfinished_object_names_the_same_items(path: Path) -> None:
    finished = contract.solved(path.stem, solved(path))
    unfinished = contract.unfinished(path.stem, solved(path).problem, TimeLimitError("too long"))

    def items(content: Any) -> list[tuple[object, ...]]:
        return [
            (part["part"], item["line"], item["text"], item["kind"])
            for part in content["parts"]
            for item in part["items"]
        ]

    assert items(unfinished) == items(finished)
    assert unfinished["error"]["kind"] == "time limit"
    assert not contract.all_answered(unfinished)
