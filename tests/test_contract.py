"""The JSON object is what other programs were promised, for every error and condition."""

from __future__ import annotations

import json

import pytest
from laws_of_contract import check_condition, read_back

import restitution
from restitution.errors import StatementError
from restitution.export import contract


def content_of(text, file="some.impact", **options):
    line = contract.to_json(
        contract.solved(file, restitution.solve(restitution.parse(text)), **options)
    )
    assert "\n" not in line
    return json.loads(line)


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


NORMAL = "wall W: along i\nsphere P: mass 1, velocity -u j\nP hits W\n"
ALONG = "velocity a i - 4j\nP hits W\n"
TWO = """\
sphere P: mass m, velocity u i
sphere Q: mass k m, velocity -u i
P hits Q: along i, e = 1/2
given speed(P) = v
"""
OPPOSED = """\
sphere A: mass m, velocity u i
sphere B: mass M, at rest
A hits B: along i
given velocity(A) = a i, velocity(B) = b i
find e
"""


OBLIQUE = """\
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
"""
SQUARE = (
    "(u(k cos α + √(1 − k² sin²α))/(k² − 1))𝐢, "
    "for k sin α ≤ 1, k > 1 and ((k − 2) cos α − √(1 − k² sin²α))/(k − 1) ≥ 0"
)
SHARE = OBLIQUE + "given energy_lost = 1/4 energy(0)\n"
EQUAL_SPEEDS = """\
sphere A: mass m, velocity u i
sphere B: mass k m, velocity -v i
A hits B: along i
given speed(A) = speed(B)
"""


@pytest.mark.parametrize(
    ("text", "exact", "condition", "display"),
    [
        (
            NORMAL + "given impulse = 50\nfind e\n",
            "(50 - u)/u",
            ["25 <= u <= 50"],
            "(50 − u)/u, for 25 ≤ u ≤ 50",
        ),
        (
            "wall W: along i\nsphere P: " + ALONG + "given speed(P) = 5\nfind e\n",
            "sqrt(25 - a**2)/4",
            ["-5 <= a <= -3 or 3 <= a <= 5"],
            "√(25 − a²)/4, for −5 ≤ a ≤ −3 or 3 ≤ a ≤ 5",
        ),
        (
            OPPOSED,
            "(-a + b)/u",
            ["b >= a", "u > a", "a - b + u >= 0"],
            "(b − a)/u, for b ≥ a, u > a and a − b + u ≥ 0",
        ),
        (NORMAL + "given impulse = u\nfind e\n", "0", [], "0"),
        (  # what bounds the answer itself is said by its letter
            EQUAL_SPEEDS + "find e\n",
            "2*(-k*v + u)/((k - 1)*(u + v))",
            ["0 <= 2*(-k*v + u)/((k - 1)*(u + v)) <= 1"],
            "2(u − kv)/((k − 1)(u + v)), for 0 ≤ e ≤ 1",
        ),
        (  # no bounds with roots in them where the inequality is shorter; no positive factors
            SHARE + "find e\n",
            "sqrt(4*k*cos(alpha)**2 - k - 1)/(2*sqrt(k)*cos(alpha))",
            ["4*k*cos(alpha)**2 - k - 1 >= 0"],
            "√((4k cos²α − 1 − k)/k)/(2 cos α), for 4k cos²α − 1 − k ≥ 0",
        ),
        (  # k = 1 would have no answer of this form: what divides is not zero
            OBLIQUE + "given speed(A) = speed(B)\nfind velocity(B)\n",
            ("u*(k*cos(alpha) + sqrt(-k**2*sin(alpha)**2 + 1))/(k**2 - 1)", "0"),
            [
                "k*sin(alpha) <= 1",
                "k > 1",
                "((k - 2)*cos(alpha) - sqrt(-k**2*sin(alpha)**2 + 1))/(k - 1) >= 0",
            ],
            SQUARE,
        ),
    ],
)
def test_condition_of_an_answer(text, exact, condition, display):
    (item,) = content_of(text)["parts"][0]["items"]
    answers = {str(each["exact"]): each for each in item["answers"]}
    answer = answers[exact if isinstance(exact, str) else str(list(exact))]
    assert answer["condition"] == condition
    assert answer["display"] == display
    check_condition(answer["condition"])


def test_each_solution_has_its_own_value_and_condition():
    k, speed = content_of(TWO + "find k, speed(P)\n")["parts"][0]["items"]
    assert [answer["condition"] for answer in k["answers"]] == [["v/2 < u"], ["v < u"]]
    assert [answer["solution"] for answer in speed["answers"]] == [1, 2]
    assert [answer["exact"] for answer in speed["answers"]] == ["v", "v"]
    assert [answer["condition"] for answer in speed["answers"]] == [["v/2 < u"], ["v < u"]]


def test_undecided_show_is_answered():
    content = content_of(NORMAL.replace("-u j", "u at alpha to W") + "show sin(alpha) < alpha\n")
    (item,) = content["parts"][0]["items"]
    assert (item["holds"], item["proof"], item["counterexample"]) == (None, "undecided", None)
    assert item["trials"] > 0
    assert item["error"] is None
    assert any("not decided" in warning for warning in content["warnings"])
    assert contract.all_answered(content)


@pytest.mark.parametrize(
    ("claim", "holds", "proof"),
    [
        ("speed(P)^2 = u^2 (cos^2(alpha) + e^2 sin^2(alpha))", True, "algebra"),
        ("speed(P) <= u", True, "decision"),
        ("speed(P) < 51", False, "witness"),
    ],
)
def test_what_a_verdict_rests_on(claim, holds, proof):
    text = NORMAL.replace("-u j", "u at alpha to W")
    (item,) = content_of(text + f"show {claim}\n")["parts"][0]["items"]
    assert (item["holds"], item["proof"]) == (holds, proof)
    assert (item["counterexample"] is not None) == (not holds)


def test_unreadable():
    error = StatementError("unknown word", 3, 7)
    content = json.loads(contract.to_json(contract.unreadable("-", error)))
    assert content == {
        "file": "-",
        "title": None,
        "parts": [],
        "warnings": [],
        "notes": [],
        "error": {
            "kind": "syntax",
            "message": "unknown word",
            "line": 3,
            "column": 7,
            "fixes": [],
        },
    }
    assert not contract.all_answered(content)
