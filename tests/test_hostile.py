"""Whatever bytes come in: an answer or a clear error, and never a traceback.

Each has far more time than the command gives by default, so that nothing is left out for want of
it, and what needs more than that fails.
"""

from __future__ import annotations

import json
import random

import pytest
from commands import run

# Seconds, on a machine that is slow and busy; the longest takes less than 2 s on a quiet one.
LIMIT = 100

STORY = "wall W: along i\nsphere P: mass 2, velocity 5i - 3j\nP hits W: e = 1/3\n"
EXPRESSIONS = {
    "tower of powers": "9^9^9^9",
    "powers of powers": "((9^9)^9)^9",
    "large power of a letter": "(u + 1)^999999999",
    "large power": "2^999999",
    "small base": "0.000001^999",
    "product of powers": "9^99 * 9^99 * 9^99",
    "brackets": "(" * 1000 + "1" + ")" * 1000,
    "roots of roots": "sqrt(" * 45 + "2" + ")" * 45,
    "signs": "-" * 900 + "1",
    "long sum": " + ".join(f"a_{n % 10}" for n in range(300)),
    "long product": "".join(f"(a_{n % 10} + b)" for n in range(60)),
    "nested sines": "sin(" * 40 + "1" + ")" * 40,
    "sines of sums": "sin(a + b + c)^9 cos(a - b)^9",
    "division by zero": "1/0",
    "hidden zero": "1/(sqrt(2)^2 - 2)",
    "long number": "9" * 1000,
    "long decimal": "0." + "3" * 1000,
    "tangent of a right angle": "tan(90°)",
    "arcsine of two": "arcsin(2)",
    "root of a negative": "sqrt(-1)",
    "fractions": "1/(1 + 1/(1 + " * 20 + "1" + "))" * 20,
}
STATEMENTS = {
    "nothing": b"",
    "zeros": b"\0" * 5000,
    "broken UTF-8": b"sphere \xff\xfe: mass 2\n",
    "cut UTF-8": "sphere P: velocity \u03b1".encode()[:-1],
    "surrogate": b"title \xed\xa0\x80\n",
    "UTF-16": STORY.encode("utf-16"),
    "10 MB line": b"a" * 10_000_000,
    "10 MB of sums": b"find " + b"1 + " * 2_500_000 + b"1",
    "10 MB of lines": b"\n" * 10_000_000,
    "10 MB comment": b"#" * 10_000_000,
    "continued for ever": b"\\\n" * 40_000,
    "escape sequences": b"title \x1b[2J\x1b]0;x\x07\nsphere \x1b[31m: mass 1\n",
    "only signs": b"+-*/^(){}[]<>=,:;!?%$&|~`'\"\\" * 60,
    "300 spheres": "".join(f"sphere S{n}: mass {n + 1}\n" for n in range(300)).encode(),
    "90 spheres": (
        "".join(f"sphere S{n}: mass m, velocity {90 - n}i\n" for n in range(90))
        + "".join(f"S{n} hits S{n + 1}: along i, e = 1\n" for n in range(3))
        + "find velocity(S3), momentum\n"
    ).encode(),
    "keywords as names": b"sphere sphere: mass 2\nwall wall: along i\nsphere hits wall\n",
    "keywords as letters": b"sphere P: mass find, velocity show i\nfind range\nlet let = let\n",
    "names as letters": b"sphere P: mass P, velocity P i\nfind P\n",
    "same name twice": b"sphere W: mass 1\nwall W: along i\nW hits W\n",
    "itself": b"sphere P: mass 1, velocity i\nP hits P: e = 1\nfind speed(P)\n",
    "let in a circle": b"let a = b\nlet b = a\nfind a\n",
    "let of itself": b"let a = a + 1\nfind a\n",
    "lets that double": (
        "let a = 2\n"
        + "".join(f"let {y} = {x}^9 {x}^9\n" for x, y in zip("abcdfghklmnopq", "bcdfghklmnopqr"))
        + "find r\n"
    ).encode(),
    "no mass at all": b"sphere A, B: mass 0, velocity i\nA hits B: along i\nfind speed(A)\n",
    "no direction": b"wall W: along 0i + 0j\nsphere P: velocity i\nP hits W\nfind speed(P)\n",
    "a thousand commas": b"sphere P: " + b"," * 1000 + b"\n",
    "as many events as there may be": (
        "wall V: along j\nwall W: along j\nsphere P: mass m, velocity u i\n"
        + "P hits V: e = 1/2\nP hits W: e = 1/2\n" * 29
        + "find speed(P)\n"
    ).encode(),
    "many items": (STORY + "find " + ", ".join(["impulse"] * 200) + "\n").encode(),
    "many facts": (STORY + "".join(f"given a_{n % 10} > {n}\n" for n in range(300))).encode(),
    **{name: f"{STORY}find {text}\n".encode() for name, text in EXPRESSIONS.items()},
    **{
        f"{name} as a mass": f"wall W: along j\nsphere P: mass {text}, velocity 3i\n"
        "P hits W\nfind impulse\n".encode()
        for name, text in EXPRESSIONS.items()
    },
}


@pytest.mark.parametrize("name", STATEMENTS)
def test_answer_or_clear_error(name):
    limit = ("--time-limit", str(LIMIT))
    status, out, err = run("solve", "-", "--format", "json", *limit, stdin=STATEMENTS[name])
    assert status in (0, 1, 2)
    assert "Traceback" not in err
    assert "internal error" not in out + err
    assert "time limit" not in out + err
    content = json.loads(out)
    if status == 2:
        assert content["error"]["kind"] in ("syntax", "unsupported", "impossible")
        assert content["error"]["message"]
        assert err
    assert all(each.isprintable() or each == "\n" for each in out + err)


@pytest.mark.parametrize("seed", range(12))
def test_random_bytes(seed):
    generator = random.Random(seed)
    text = generator.randbytes(generator.choice((10, 1000, 50_000)))
    if seed % 2:
        words = STORY.split() + ["given", "find", "show", "(", ")", "°", "√", "\n", "e", "range of"]
        text = " ".join(generator.choices(words, k=200)).encode()
    status, _, err = run("check", "-", stdin=text)
    assert status in (0, 2)
    assert "Traceback" not in err
    assert "internal error" not in err


def test_names_of_files():
    status, _, err = run("solve", "a\nb", "\x1b[31m", "x" * 5000)
    assert status == 2
    assert "Traceback" not in err
    assert "\x1b" not in err


def test_endless_input():
    status, _, err = run("check", "/dev/zero")
    assert status == 2
    assert "too long" in err
