"""The answers written in the comments of a statement, and how they compare with a solution.

``#= ITEM -> ANSWER`` stands once for every item, in order. An answer is an expression of the
statement language, several solutions apart by ``;``; for a range a relation; for an extremum
``VALUE when a = X`` or ``VALUE approached …``; for a show ``true`` or ``false``; or
``error KIND``.
"""

from __future__ import annotations

import random
import re
from dataclasses import dataclass
from typing import Any

import sympy as sp

from restitution.expression import read_expression
from restitution.expression.evaluate import evaluate
from restitution.oracle.roles import Role
from restitution.solving import ItemResult, Solution
from restitution.solving.algebra.numbers import UndefinedError, at, sample


@dataclass(frozen=True)
class Expected:
    """One line ``#= text -> answer``."""

    line: int
    text: str
    answer: str


def expected(text: str) -> list[Expected]:
    """The answers written in a statement."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        match = re.match(r"#=\s*(.*?)\s*->\s*(.*?)\s*$", line)
        if match:
            found.append(Expected(number, match[1], match[2]))
    return found


def disagreements(solution: Solution, wanted: list[Expected]) -> list[str]:
    """What differs between a solution and the answers written for it, in words."""
    items = [(part, item) for part, item in solution.items()]
    found = []
    if len(items) != len(wanted):
        found.append(f"{len(items)} items, but {len(wanted)} answers")
    for (part, item), want in zip(items, wanted, strict=False):
        if _plain(item.text) != _plain(want.text):
            found.append(f"item {item.text!r} has the answer of {want.text!r}")
            continue
        problem = _differs(item, want.answer, dict(part.roles))
        if problem:
            found.append(f"{want.text} -> {want.answer}: {problem}")
    return found


def _plain(text: str) -> str:
    return re.sub(r"(?<=\D)|\s", "", "".join(text.split()))


def _differs(item: ItemResult, answer: str, roles: dict[str, Role]) -> str | None:
    if answer.startswith("error"):
        kind = answer.split()[1]
        if item.error is None:
            return f"answered {[a.display for a in item.answers]}"
        return None if item.error.kind == kind else f"error {item.error.kind}: {item.error}"
    if item.error is not None:
        return f"error {item.error.kind}: {item.error}"
    if answer in ("true", "false"):
        return None if item.holds is (answer == "true") else f"holds is {item.holds}"
    if item.kind == "range":
        return _range_differs(item, answer, roles)
    if item.kind == "extremum":
        return _extremum_differs(item, answer, roles)
    wanted = [_value(each) for each in answer.split(" ; ")]
    got = [each.value for each in item.answers]
    for value in wanted:
        if not any(_same(value, each, roles, item.kind) for each in got):
            return f"got {[a.display for a in item.answers]}"
    for value, shown in zip(got, item.answers, strict=True):
        if not any(_same(each, value, roles, item.kind) for each in wanted):
            return f"too many: {shown.display}"
    return None


def _value(text: str) -> Any:
    return evaluate(read_expression(text), lambda name: sp.Symbol(name, positive=True))


def _points(symbols: set[str], roles: dict[str, Role], count: int = 5) -> list[dict[str, Any]]:
    rng = random.Random(3)
    return [sample(sorted(symbols), roles, rng) for _ in range(count)]


def _same(a: Any, b: Any, roles: dict[str, Role], kind: str) -> bool:
    a = tuple(a) if isinstance(a, tuple) else (a,)
    b = tuple(b) if isinstance(b, tuple) else (b,)
    if len(a) != len(b):
        return len(b) == 2 and a == (0,) and all(x == 0 for x in b)
    names = {s.name for each in (*a, *b) for s in sp.sympify(each).free_symbols}
    agreed = 0
    for values in _points(names, roles, 40):
        try:
            x = [at(each, values) for each in a]
            y = [at(each, values) for each in b]
        except (UndefinedError, KeyError):
            continue
        if kind == "direction":
            size = abs(x[0]) + abs(x[1])
            close = abs(x[0] * y[1] - x[1] * y[0]) < 1e-20 * size * (abs(y[0]) + abs(y[1]))
        else:
            close = all(abs(p - q) <= 1e-18 * (1 + abs(p)) for p, q in zip(x, y, strict=True))
        if not close:
            return False
        agreed += 1
        if agreed == 5:
            break
    return agreed > 0


def _range_differs(item: ItemResult, answer: str, roles: dict[str, Role]) -> str | None:
    if len(item.answers) != 1:
        return f"{len(item.answers)} ranges: {[a.display for a in item.answers]}"
    got = item.answers[0].value
    shown = item.answers[0].display
    subject = item.text.removeprefix("range of").strip()
    intervals = [_interval(each, subject) for each in answer.split(" or ")]
    names = {
        s.name
        for interval in intervals
        for end in interval[:2]
        if end is not None
        for s in end.free_symbols
    } | {s.name for s in got.free_symbols}
    agreed = 0
    for values in _points(names, roles, 40):
        try:
            want_ends = sorted(
                ((_at(a, values, -1), c), (_at(b, values, 1), d)) for a, b, c, d in intervals
            )
        except UndefinedError:
            continue  # with such data there is no such motion
        got_ends = sorted(
            ((_at(low, values, -1), closed), (_at(high, values, 1), shut))
            for low, high, closed, shut in _pieces(got)
        )
        if len(want_ends) != len(got_ends):
            return f"got {shown}"
        for w, g in zip(want_ends, got_ends, strict=True):
            for (p, closed), (q, shut) in zip(w, g, strict=True):
                infinite = abs(p) > 1e30 and abs(q) > 1e30
                if not infinite and (abs(p - q) > 1e-15 * (1 + abs(p)) or closed != shut):
                    return f"got {shown}"
        agreed += 1
        if agreed == 6:
            break
    return None if agreed else "no numbers to compare with"


def _at(end: Any, values: dict[str, Any], sign: int) -> Any:
    if end is None or end in (sp.oo, -sp.oo):
        return sign * 10**40
    return at(end, values)


def _pieces(values: Any) -> list[tuple[Any, Any, bool, bool]]:
    if isinstance(values, sp.Union):
        return [piece for arg in values.args for piece in _pieces(arg)]
    if isinstance(values, sp.FiniteSet):
        return [(x, x, True, True) for x in values]
    if isinstance(values, sp.Interval):
        return [(values.start, values.end, not values.left_open, not values.right_open)]
    raise AssertionError(f"a range given as {values}")


def _interval(text: str, subject: str) -> tuple[Any, Any, bool, bool]:
    parts = re.split(r"(<=|>=|<|>|=)", text)
    names = {"X", _plain(subject)}
    where = next(i for i, part in enumerate(parts) if _plain(part) in names)
    low = high = None
    low_closed = high_closed = False
    if where >= 2:
        op, bound = parts[where - 1], _value(parts[where - 2])
        if op == "=":
            return bound, bound, True, True
        if op.startswith("<"):
            low, low_closed = bound, op == "<="
        else:
            high, high_closed = bound, op == ">="
    if where + 2 < len(parts):
        op, bound = parts[where + 1], _value(parts[where + 2])
        if op == "=":
            return bound, bound, True, True
        if op.startswith("<"):
            high, high_closed = bound, op == "<="
        else:
            low, low_closed = bound, op == ">="
    return low, high, low_closed, high_closed


def _extremum_differs(item: ItemResult, answer: str, roles: dict[str, Role]) -> str | None:
    match = re.match(r"(.*?)\s+(when|approached)\s*(.*)$", answer)
    value, how = (match[1], match[2]) if match else (answer, "when")
    got = item.answers[0]
    if not _same(_value(value), got.value, roles, "value"):
        return f"got {got.display}"
    if (how == "when") != got.reached:
        return f"reached is {got.reached}: {got.display}"
    return None
