"""Answers in letters, against those of the same statement in which the letters are numbers.

Numbers are put in by a line ``given k = 2, …`` where a part begins. Whatever was solved in letters
is solved once more without them: the values agree, and where the condition of an answer does not
hold, that answer is not there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from random import Random
from typing import Any

import sympy as sp
from laws_of_contract import CALLED, read_back
from statements import FILES, law, solved

from restitution.export import contract
from restitution.language import parse
from restitution.solving import solve

DRAWS = 2
DIGITS = 30
ANGLES = frozenset(("alpha", "beta", "gamma", "delta", "theta", "phi", "psi", "omega"))
DEGREES = ("20°", "30°", "45°", "60°", "70°")
COEFFICIENTS = ("0", "1/5", "1/4", "1/2", "3/4", "1")
OTHERS = ("1/10", "1/3", "1/2", "1", "2", "3", "7/2", "5", "10")
KINDS = ("value", "vector", "point")
_SIGNS = re.compile(r"\s*(<=|>=|!=|<|>|=)\s*")


@law(FILES)
def numbers_for_letters_give_the_same(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    whole = contract.solved(path.name, solved(path))
    for label, numbers in draws(path):
        given = ", ".join(f"{letter} = {number}" for letter, number in numbers.items())
        given = given.replace("lambda_", "lambda")  # no name of Python
        part = part_of(contract.solved("numbers", solve(parse(stated(text, label, given)))), label)
        exact = {sp.Symbol(letter): amount(number) for letter, number in numbers.items()}
        for item, own in zip(part_of(whole, label)["items"], part["items"], strict=True):
            if item["kind"] in KINDS and item["answers"] and not is_excluded(text, own, numbers):
                wanted = admissible(item, exact)
                values = [value(answer, {}) for answer in own["answers"]]
                case = f"{path.stem} {label}: {item['text']} for {given}"
                assert not apart(wanted, values), f"{case}: {wanted}, not {own}"
                assert not apart(values, wanted), f"{case}: {own}, not {wanted}"


def draws(path: Path) -> Iterator[tuple[str | None, dict[str, str]]]:
    """Parts that have letters in their answers, and numbers for all of these."""
    text = path.read_text(encoding="utf-8")
    coefficients = set(re.findall(r"\be = ([a-z]\d?)\b", text))
    # A letter that has a value stands in an answer where that is asked in terms of it.
    valued = set(re.findall(r"^given (\w+) = ", text, re.MULTILINE))
    whole = contract.solved(path.name, solved(path))
    items = [item for part in whole["parts"] for item in part["items"]]
    asked = {word for item in items for word in names(item["text"].removeprefix("range of "))}
    for part in whole["parts"]:
        letters = {
            name
            for item in part["items"]
            if item["kind"] in KINDS
            for answer in item["answers"]
            for expression in (*texts(answer["exact"]), *answer["condition"])
            for name in names(expression)
        }
        random = Random(f"{path.stem}{part['part']}")
        if (
            letters
            and not letters & asked
            and not {name.replace("_", "") for name in letters} & valued
        ):
            for _ in range(DRAWS):
                yield (
                    part["part"],
                    {
                        name: drawn(name, random, name.startswith("e") or name in coefficients)
                        for name in sorted(letters)
                    },
                )


def names(expression: str) -> set[str]:
    return set(re.findall(r"[A-Za-z_]\w*", expression)) - CALLED - {"or"}


def texts(exact: Any) -> list[str]:
    return exact if isinstance(exact, list) else [exact]


def drawn(letter: str, random: Random, is_coefficient: bool) -> str:
    if letter in ANGLES:
        return random.choice(DEGREES)
    return random.choice(COEFFICIENTS if is_coefficient else OTHERS)


def amount(number: str) -> Any:
    return sp.rad(sp.Integer(number[:-1])) if number.endswith("°") else sp.Rational(number)


def stated(text: str, label: str | None, given: str) -> str:
    """The statement with a fact where its part begins, or in front of all questions."""
    begins = r"(find|show)\b" if label is None else rf"part\s+{re.escape(label)}\b"
    lines = text.splitlines()
    at = next(n for n, line in enumerate(lines) if re.match(begins, line.strip()))
    at += 0 if label is None else 1
    return "\n".join((*lines[:at], f"given {given}", *lines[at:]))


def part_of(whole: Any, label: str | None) -> Any:
    (part,) = (each for each in whole["parts"] if each["part"] == label)
    return part


def is_excluded(text: str, item: Any, numbers: Mapping[str, str]) -> bool:
    """Whether numbers are excluded by what is given, or by the story as it is told.

    An answer in letters need not speak of these: that bodies approach, and that who has to move on
    is not brought to rest.
    """
    if item["error"] is None or item["error"]["kind"] != "contradiction":
        return False
    if "separating" in item["error"]["message"] or "0" in numbers.values():
        return True
    facts = (line for line in text.splitlines() if line.strip().startswith("given"))
    return any(set(numbers) & names(fact) for fact in facts)


def admissible(item: Any, numbers: dict[Any, Any]) -> list[tuple[complex, ...]]:
    """Values of the answers of which the condition holds for these numbers."""
    return [
        value(answer, numbers)
        for answer in item["answers"]
        if all(holds(condition, numbers) for condition in answer["condition"])
    ]


def value(answer: Any, numbers: dict[Any, Any]) -> tuple[complex, ...]:
    return tuple(
        map(complex, (number(read_back(each), numbers) for each in texts(answer["exact"])))
    )


def number(expression: Any, numbers: dict[Any, Any]) -> Any:
    """The value of an expression; arctan(x/0) is a right angle."""
    amount = expression.subs(numbers)
    return sp.pi / 2 if amount.has(sp.AccumBounds) else sp.N(amount, DIGITS)


def apart(values: list[tuple[complex, ...]], others: list[tuple[complex, ...]]) -> list[Any]:
    """Values that are not among the others."""
    return [each for each in values if not any(is_equal(each, other) for other in others)]


def is_equal(one: tuple[complex, ...], other: tuple[complex, ...]) -> bool:
    return all(abs(a - b) <= 1e-9 * max(1, abs(a)) for a, b in zip(one, other, strict=True))


def holds(condition: str, numbers: dict[Any, Any]) -> bool:
    """Whether a chain of relations holds, or one of several."""
    return any(holds_chain(each, numbers) for each in condition.split(" or "))


def holds_chain(chain: str, numbers: dict[Any, Any]) -> bool:
    sides = _SIGNS.split(chain)
    for left, sign, right in zip(sides[::2], sides[1::2], sides[2::2], strict=False):
        gap = sp.N(read_back(left).subs(numbers) - read_back(right).subs(numbers), DIGITS)
        is_zero = abs(gap) < 1e-20
        if {
            "=": not is_zero,
            "!=": is_zero,
            "<": is_zero or gap > 0,
            ">": is_zero or gap < 0,
            "<=": not is_zero and gap > 0,
            ">=": not is_zero and gap < 0,
        }[sign]:
            return False
    return True
