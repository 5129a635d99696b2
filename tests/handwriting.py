"""How one student types: the same signs, words and habits in every line of a script.

A line comes as the statement language writes it, and is typed as seventeen-year-olds type: powers,
roots, products, degrees, decimals and vectors in one of the usual spellings, words in front, units
and numbers of equations behind, several lines on one. What a line says stays the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from random import Random

_ANNOUNCING = (
    *("so ", "hence ", "therefore ", "=> ", "∴ ", "thus ", "then ", "now ", "we get ", "giving "),
    *("⇒ ", "this gives ", "so we have ", "which gives ", "also ", "and ", "-> ", "i.e. ", "ie "),
    *("rearranging: ", "simplify: ", "solving, ", "sub in: ", "subbing in ", "from above ", "but "),
    *("using this, ", "(1) ", "[2] ", "Now, ", "Answer: ", "ans: ", "=> so ", "this means "),
)
_LAWS = {
    "momentum": (
        *("CLM: ", "PCLM: ", "clm ", "COLM ", "momentum: ", "cons of mom: ", "by CLM, "),
        *("conservation of momentum: ", "Momentum conserved: ", "mom along loc: ", "CLM (→): "),
        *("using conservation of linear momentum ", "p.c.l.m. ", "CLM along line of centres: "),
    ),
    "restitution": (
        *("NEL: ", "NLR: ", "nel ", "restitution: ", "newton's law: ", "Newton: ", "by NEL, "),
        *("Newton's law of restitution: ", "using NEL ", "NEL (→) ", "NLI: ", "law of rest: "),
    ),
    "restitution-wall": ("NEL: ", "nel ", "restitution: ", "perp to wall: ", "Newton's law: "),
    "unchanged": (
        *("unchanged: ", "no impulse in this direction so ", "stays the same: ", "no change: "),
        *("component unchanged so ", "smooth so ", "this one stays: "),
    ),
    "energy": ("KE: ", "energy: ", "using KE "),
}
_BEHIND = (" (1)", "  (2)", " ...(1)", " [1]", " — (3)", " (*)", "  ①", " (as required)", " ✓")
_JOINTS = (
    ", ",
    "; ",
    " and ",
    " so ",
    " => ",
    " ∴ ",
    "   ",
    " ⇒ ",
    " therefore ",
    ", so ",
    " hence ",
)
_GREEK = (("alpha", "α"), ("beta", "β"), ("theta", "θ"), ("phi", "φ"), ("gamma", "γ"))
_HALVES = {"1/2": "½", "1/3": "⅓", "2/3": "⅔", "1/4": "¼", "3/4": "¾", "1/5": "⅕", "3/5": "⅗"}
_VECTOR = re.compile(
    r"(?<![\w)./^] )(?<![\w)./^])(-?)((?:[\d./]+ )?)i ([+-]) ((?:[\d./]+ )?)j(?![\w(])"
)
_FRACTION = re.compile(r"(?<![\w.)/^])(\d+)/(\d+)(?![\w.(/^]| ?\()")
_ROOT = re.compile(r"sqrt\((\d+)\)")
_TRIG = re.compile(r"(sin|cos|tan)(\^\d)?\(([a-z]+|[α-ω]|\d+°)\)")
_PRODUCT = re.compile(r"(?<=[A-Za-z)α-ω²]) (?=[A-Za-z(α-ω√])(?!at )")
_FACTOR = re.compile(r"(?<=(?<![\d_])\d) (?=[A-Za-z(α-ω√])")


@dataclass(frozen=True)
class Hand:
    """The habits of one student; each is a change of the text of a line."""

    habits: tuple[Callable[[str], str], ...]
    announces: float
    numbers: float
    joins: float

    def line(self, text: str, record: str, random: Random) -> str:
        """A line typed; ``record`` is the principle that it states."""
        for habit in self.habits:
            text = habit(text)
        words = _LAWS.get(record, ()) if random.random() < 0.7 else ()
        if random.random() < self.announces:
            text = random.choice(words or _ANNOUNCING) + text
        if random.random() < self.numbers:
            text += random.choice(_BEHIND)
        return text

    def script(self, lines: Sequence[str], random: Random, most: int) -> tuple[str, ...]:
        """Lines of a script, some of them two on one; none longer than ``most``."""
        typed: list[str] = []
        for line in lines:
            joint = random.choice(_JOINTS)
            joined = typed and random.random() < self.joins and not _is_open(line)
            if joined and len(typed[-1]) + len(line) + len(joint) <= most:
                typed[-1] = typed[-1] + joint + line
            else:
                typed.append(line)
        return tuple(typed)


def _is_open(line: str) -> bool:
    """Whether words stand before a line, or it declares a letter."""
    return line.startswith(("let ", "(", "[")) or ":" in line


def hand_of(random: Random, statement: str) -> Hand:
    """The habits of a student, who writes on a question."""
    numeric = not re.search(r"(?<![\w])[muk](?![\w])", statement)
    habits: list[Callable[[str], str]] = []
    if numeric and random.random() < 0.4:
        habits.append(lambda text: _FRACTION.sub(_decimal, text))
    elif random.random() < 0.2:
        habits.append(lambda text: _FRACTION.sub(lambda m: _HALVES.get(m[0], m[0]), text))
    if random.random() < 0.3:
        style = random.choice(("({}, {})", "({},{})", "<{}, {}>", "[{}, {}]"))
        habits.append(lambda text: _VECTOR.sub(lambda m: _column(m, style), text))
    elif random.random() < 0.5:
        habits.append(lambda text: _VECTOR.sub(_tight, text))
    root = random.choice(("sqrt({})", "√{}", "√({})", "root{}", "root({})", "√{}"))
    habits.append(lambda text: _rooted(text, root))
    angle = random.choice(("{}{}({})", "{}{}({})", "{}{} {}", "{}{}{}", "{}{} {}"))
    bare = random.random() < 0.5
    habits.append(lambda text: _TRIG.sub(lambda m: _sine(m, angle, bare), text))
    if random.random() < 0.7:
        for name, sign in _GREEK:
            habits.append(lambda text, a=name, b=sign: text.replace(a, b))
    power = random.choice(("^2", "²", "²", "**2", "^{2}"))
    habits.append(lambda text: re.sub(r"\^2(?![\d.])", power, text))
    if random.random() < 0.6:
        habits.append(lambda text: _FACTOR.sub("", text))
    product = random.choice((" ", " ", "", "", "*", "×"))
    habits.append(lambda text: _multiplied(text, product))
    times = random.choice(("*", "*", " * ", "×", " × ", " x ", "x"))
    if "x" not in times or not re.search(r"\bx\b", statement):
        habits.append(lambda text: _timed(text, times))
    if random.random() < 0.4:
        habits.append(lambda text: re.sub(r" ([=+-]) ", r"\1", text))
    if random.random() < 0.3:
        dash = random.choice("−–")
        habits.append(lambda text: text.replace("-", dash))
    if random.random() < 0.2:
        habits.append(lambda text: text.replace("<=", "≤").replace(">=", "≥"))
    return Hand(
        tuple(habits),
        announces=random.choice((0.0, 0.3, 0.6)),
        numbers=random.choice((0.0, 0.0, 0.3)),
        joins=random.choice((0.0, 0.0, 0.2, 0.5)),
    )


def _decimal(match: re.Match[str]) -> str:
    above, below = int(match[1]), int(match[2])
    value = above / below
    return f"{value:g}" if round(value, 4) == value else match[0]


def _column(match: re.Match[str], style: str) -> str:
    sign, x, between, y = match.groups()
    first, second = (part.strip() or "1" for part in (x, y))
    return style.format(f"{sign}{first}", f"{'-' if between == '-' else ''}{second}")


def _tight(match: re.Match[str]) -> str:
    sign, x, between, y = match.groups()
    return f"{sign}{x.strip()}i {between} {y.strip()}j"


def _rooted(text: str, root: str) -> str:
    """Roots of whole numbers in a spelling; all others keep their brackets."""

    def put(match: re.Match[str]) -> str:
        before = text[: match.start()][-1:]
        written = root.format(match[1])
        alone = match.end() == len(text) or text[match.end()] in " )+-/=*"
        if not alone and root == "root{}":
            return f"√{match[1]}"
        return f" {written}" if before.isalnum() and written[0].isalnum() else written

    return _ROOT.sub(put, text).replace("sqrt", "√" if "√" in root else "sqrt")


def _sine(match: re.Match[str], style: str, bare: bool) -> str:
    function, power, angle = match[1], match[2] or "", match[3]
    if bare and angle.endswith("°"):
        angle = angle[:-1]
    if style == "{}{}{}" and not angle[0].isdigit() and angle.isascii():
        style = "{}{} {}"
    if power and angle[0].isdigit() and "(" not in style:
        style = "{}{}({})"
    closed = match.end() == len(match.string) or match.string[match.end()] in ")+-/= *^"
    spaced = match.string[match.end() : match.end() + 1] == " "
    after = match.string[match.end() + 1 : match.end() + 2]
    if "(" not in style and (not closed or (spaced and after not in "=+-<>)")):
        style = "{}{}({})"  # what stands behind it would be read as more of the angle
    return style.format(function, power, angle)


def _multiplied(text: str, sign: str) -> str:
    if sign == " ":
        return text

    def put(match: re.Match[str]) -> str:
        before, after = text[: match.start()], text[match.end() :]
        word = re.search(r"[A-Za-z]{2,}$", before)
        next_word = re.match(r"[A-Za-z]{2,}", after)
        if (word and word[0] not in ("sin", "cos")) or re.search(
            r"_\w+$|(sin|cos|tan)[²\d^]*$", before
        ):
            return match[0]
        if next_word and next_word[0] not in ("sin", "cos", "tan", "sqrt"):
            return match[0]
        if sign == "" and before[-1:] in "ij" and re.search(r"(?<![A-Za-z])[ij]$", before):
            return match[0]
        return sign

    return _PRODUCT.sub(put, text)


def _timed(text: str, sign: str) -> str:
    """The sign between two numbers, or before a bracket."""
    if sign.strip() == "x":
        return re.sub(r"(?<=[\d)])\*(?=[\d(])", sign, text)
    return re.sub(r"(?<!\*)\*(?!\*)", sign, text)
