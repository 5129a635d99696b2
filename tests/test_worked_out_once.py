"""Nothing is worked out for nothing, or a second time: readers, rules, stages, letters, forms."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
import sympy as sp
from test_planning_closing import planned

from restitution.exact.symbols import operations_in
from restitution.explaining.awarding.awards import _Awarding
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Line
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.expression.tree import Letter, Quantity, has_quantity, letters, plain_letter
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.closing import complements
from restitution.planning.writing.polynomials import IN_PLACE, coefficients_in_place
from restitution.solving.story.letters import roles

PAIR = (
    "sphere A: mass 2, velocity 3i + j\nsphere B: mass 1, at rest\n"
    "A hits B: along i, e = 1/2\nfind velocity(B), speed(A)"
)


def test_lines_are_read_only_where_one_may_change(monkeypatch: pytest.MonkeyPatch) -> None:
    solution, derivation = planned(PAIR)

    def unread(*values: Any) -> None:
        raise AssertionError("a working without sums of angles is not read")

    monkeypatch.setattr(complements, "reader_of", unread)
    oracle = Oracle(roles(solution.problem))
    assert complements.with_complements(derivation, oracle) is derivation


def test_the_rule_of_a_line_is_looked_for_once(monkeypatch: pytest.MonkeyPatch) -> None:
    _, derivation = planned(PAIR)
    tried: Counter[int] = Counter()
    fitting = _Awarding._fitting

    def counted(self: _Awarding, line: Line) -> Iterator[Any]:
        tried[line.number] += 1
        return fitting(self, line)

    monkeypatch.setattr(_Awarding, "_fitting", counted)
    work = _Awarding(derivation, "fm1", frozenset())
    first = work.proposed()
    for line in derivation.lines:
        work.rule(line)  # once more
    assert max(tried.values()) == 1
    assert first == _Awarding(derivation, "fm1", frozenset()).proposed()


def test_a_tree_without_quantities_has_no_stages() -> None:
    problem = parse(PAIR)
    tree = read_tree("u sin(alpha)", {})
    assert staged(problem, tree, 1) is tree
    speed = Quantity("speed", (read_tree("A", {"A": "sphere"}),))
    now = staged(problem, speed, 1)
    assert isinstance(now, Quantity) and now.stage == 1


def test_letters_of_a_tree_are_those_of_its_parts() -> None:
    part = read_tree("u sin(alpha)", {})
    assert letters(part) == {"u", "alpha"}
    whole = read_tree("e (u sin(alpha)) + 2 v", {})
    assert letters(whole) == {"e", "u", "alpha", "v"}
    assert not has_quantity(whole)
    told = read_tree("e speed(A, 1) + u", {"A": "sphere"})
    assert has_quantity(told) and has_quantity(read_tree("speed(A, 1)", {"A": "sphere"}))
    deep = part
    for n in range(3000):
        deep = type(whole)("+", deep, Letter(f"x_{n}"))  # type: ignore[call-arg, arg-type]
    assert len(letters(deep)) == 3002 and not has_quantity(deep)


def test_letters_of_a_relation_are_those_of_all_its_sides() -> None:
    relation = read_relation("v = e u = 2 w or v = x", {})
    assert relation.letters == {"v", "e", "u", "w", "x"}


def test_a_letter_without_a_place_is_one_object() -> None:
    assert plain_letter("u") is plain_letter("u")
    assert plain_letter("u") == Letter("u") and hash(plain_letter("u")) == hash(Letter("u"))


def test_coefficients_of_what_stands_in_the_place_of_a_sum() -> None:
    a = sp.Symbol("a", positive=True)
    assert coefficients_in_place(IN_PLACE**2 / a - 3) == (-3 * a, 0, 1)
    assert coefficients_in_place(2 * IN_PLACE + a) == (a, 2)
    assert coefficients_in_place(a - 1) == (a - 1,)
    assert coefficients_in_place(sp.Integer(0)) == (0,)
    assert coefficients_in_place(sp.sqrt(IN_PLACE) - a) is None


def test_operations_are_counted_as_sympy_counts_them() -> None:
    x = sp.Symbol("x")
    for value in (x, x**2 + 3 * x, sp.sin(x) / (1 + x)):
        assert operations_in(value) == sp.count_ops(value)
