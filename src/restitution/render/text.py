"""Mathematics on one line of Unicode text: ``½mu²(1 − e²) sin²α``, ``√103 u/16``, ``3𝐢 − 4𝐣``.

Written so that it can be read in one way only: whatever a fraction bar or a root would join in
print is put in brackets here.
"""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache

from restitution.render.layout import (
    Bold,
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Function,
    Layout,
    Letter,
    Number,
    Percent,
    Phrase,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Words,
)

GREEK = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "epsilon": "ε",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "iota": "ι",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "upsilon": "υ",
    "phi": "φ",
    "chi": "χ",
    "psi": "ψ",
    "omega": "ω",
}
VULGAR = {
    ("1", "2"): "½",
    ("1", "3"): "⅓",
    ("2", "3"): "⅔",
    ("1", "4"): "¼",
    ("3", "4"): "¾",
    ("1", "5"): "⅕",
    ("2", "5"): "⅖",
    ("3", "5"): "⅗",
    ("4", "5"): "⅘",
    ("1", "6"): "⅙",
    ("5", "6"): "⅚",
    ("1", "8"): "⅛",
    ("3", "8"): "⅜",
    ("5", "8"): "⅝",
    ("7", "8"): "⅞",
}
MINUS = "\u2212"
NO_BREAK = "\u00a0"
_UP = dict(zip("0123456789+-n", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ", strict=True))
_UP[MINUS] = "⁻"
_DOWN = dict(zip("0123456789aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))
_ROOTS = {2: "√", 3: "∛", 4: "∜"}


@lru_cache(maxsize=4096)
def to_text(layout: Layout) -> str:
    """The layout on one line of Unicode text."""
    return _text(layout)


def _text(layout: Layout) -> str:
    match layout:
        case Number(digits):
            return digits
        case Letter(name, subscript):
            return GREEK.get(name, name) + _subscript(subscript)
        case Bold(name, subscript):
            return bold(name) + _subscript(subscript)
        case Words(text):
            return text
        case Sum(terms):
            return _sum(terms)
        case Product():
            return _product(layout)
        case Fraction(Number(a), Number(b)) if (a, b) in VULGAR:
            return VULGAR[a, b]
        case Fraction():
            return _slash(layout)
        case Root(inside, index):
            return _root(inside, index)
        case Power(base, exponent):
            return _text(base) + _superscript(exponent)
        case Function():
            return _function(layout)
        case Brackets(Fraction() as inside, "()"):
            return f"({_slash(inside)})"
        case Brackets(inside, kind):
            return f"{kind[0]}{_text(inside)}{kind[1]}"
        case Degrees(inside):
            return f"{_unit_number(inside)}°"
        case Percent(inside):
            return f"{_unit_number(inside)}%"
        case Coordinates(items):
            return f"({', '.join(_text(item) for item in items)})"
        case Relation(operands, signs):
            parts = [_text(operands[0])]
            for sign, operand in zip(signs, operands[1:], strict=True):
                parts += [sign, _text(operand)]
            return " ".join(parts)
        case Phrase(items, separator):
            return separator.join(_text(item) for item in items)


@lru_cache(maxsize=4096)
def width(text: str) -> int:
    """The number of columns that a text takes in a terminal."""
    return len(text) if text.isascii() else sum(map(_columns, text))


@lru_cache(maxsize=1024)
def _columns(character: str) -> int:
    if unicodedata.combining(character) or unicodedata.category(character) in ("Cf", "Mn"):
        return 0
    return 2 if unicodedata.east_asian_width(character) in ("W", "F") else 1


def wrapped(text: str, columns: int) -> list[str]:
    """Lines of at most so many columns; what no-break spaces join stays whole."""
    lines: list[str] = []
    current = ""
    taken = 0
    for word in text.split(" "):
        more = width(word)
        if current and taken + 1 + more > columns:
            lines.append(current)
            current, taken = word, more
        elif current:
            current, taken = f"{current} {word}", taken + 1 + more
        else:
            current, taken = word, more
    lines.append(current)
    return [line.replace(NO_BREAK, " ") for line in lines]


_WITHIN_FORMULAS = re.compile(
    r" (?=[=+−×÷·≤≥<>≠≈*/^])| (?=- )|(?<=[=+−×÷·≤≥<>≠≈*/^]) |(?<= -) |(?<=sin|cos|tan) "
    r"| (?=(?:sin|cos|tan)\b)"
)
_AT_RELATIONS = re.compile(f"{NO_BREAK}(?=[=≤≥<>≠≈])")


def with_whole_formulas(text: str, columns: int) -> str:
    """A text in which no-break spaces hold formulas together, if they have room in a line.

    One that is longer may be broken before a relation; one that is longer still, anywhere.
    """
    words: list[str] = []
    for word in _WITHIN_FORMULAS.sub(NO_BREAK, text).split(" "):
        pieces = [word] if width(word) <= columns else _AT_RELATIONS.sub(" ", word).split(" ")
        words += (
            piece if width(piece) <= columns else piece.replace(NO_BREAK, " ") for piece in pieces
        )
    return " ".join(words)


def bold(name: str) -> str:
    """Upright bold letters and digits of Unicode's mathematical alphabet."""
    out = []
    for character in name:
        if "a" <= character <= "z":
            out.append(chr(0x1D41A + ord(character) - ord("a")))
        elif "A" <= character <= "Z":
            out.append(chr(0x1D400 + ord(character) - ord("A")))
        elif character.isdigit() and character.isascii():
            out.append(chr(0x1D7CE + int(character)))
        else:
            out.append(character)
    return "".join(out)


def _subscript(subscript: str) -> str:
    if not subscript:
        return ""
    if all(character in _DOWN for character in subscript):
        return "".join(_DOWN[character] for character in subscript)
    return f"_{GREEK.get(subscript, subscript)}"


def _superscript(exponent: Layout) -> str:
    text = _text(exponent)
    if all(character in _UP for character in text):
        return "".join(_UP[character] for character in text)
    return f"^({_slash(exponent) if isinstance(exponent, Fraction) else text})"


def _sum(terms: tuple[tuple[str, Layout], ...]) -> str:
    out = ""
    for index, (sign, term) in enumerate(terms):
        text = _text(term)
        if index == 0:
            out = (MINUS if sign == "-" else "") + text
        else:
            out += f" {MINUS if sign == '-' else '+'} {text}"
    return out


def _product(layout: Product) -> str:
    texts = [_factor(factor, layout.sign) for factor in layout.factors]
    if layout.sign:
        return f" {layout.sign} ".join(texts)
    out = texts[0]
    for before, factor, text in zip(layout.factors, layout.factors[1:], texts[1:], strict=False):
        out += (" " if _apart(before, factor, out, text) else "") + text
    return out


def _apart(before: Layout, factor: Layout, left: str, right: str) -> bool:
    """Whether a space is needed between two factors."""
    if isinstance(factor, Function) or isinstance(before, Words) or isinstance(factor, Words):
        return True
    if isinstance(before, Function):
        return not left.endswith(")") or not right.startswith("(")
    if isinstance(before, Root):
        return not left.endswith(")") and not right.startswith(("(", "√"))
    if left[-1:].isdigit() and right[:1].isdigit():
        return True
    # A subscript that could not be lowered, as in v_A, would run into the next letter.
    return isinstance(before, Letter | Bold) and "_" in _subscript(before.subscript)


def _factor(factor: Layout, sign: str) -> str:
    if isinstance(factor, Fraction):
        text = _text(factor)
        return text if len(text) == 1 else f"({text})"
    if isinstance(factor, Product) and factor.sign and not sign:
        return f"({_text(factor)})"
    return _text(factor)


def _slash(fraction: Fraction) -> str:
    if isinstance(fraction.below, Product) and fraction.below.factors[0] == Words("d"):
        return f"d/d{_text(fraction.below.factors[1])}"  # a rate of change
    # A fraction in a fraction is written once: to write it twice takes ages where it is deep.
    above, below = (
        _slash(side) if isinstance(side, Fraction) else _text(side)
        for side in (fraction.above, fraction.below)
    )
    simple = isinstance(fraction.below, Number | Letter | Brackets | Power | Bold | Function | Root)
    if not simple:
        below = f"({below})"
    # The angle of (u sin α)/2 ends at the bracket; that of u sin α/(1 + k) ends at the slash.
    ended = below.startswith("(") and _ends_in_a_letter(fraction.above)
    if isinstance(fraction.above, Fraction | Sum | Relation | Phrase) or (
        _open_ended(fraction.above) and not ended
    ):
        above = f"({above})"
    return f"{above}/{below}"


def _ends_in_a_letter(layout: Layout) -> bool:
    """Whether a product without a sign ends in the sine, cosine or tangent of a letter."""
    if isinstance(layout, Product):
        return not layout.sign and _ends_in_a_letter(layout.factors[-1])
    return isinstance(layout, Function) and isinstance(layout.argument, Letter)


def _open_ended(layout: Layout) -> bool:
    """Whether a slash after the layout would seem to belong to its last part only."""
    if isinstance(layout, Function):
        return not isinstance(layout.argument, Brackets)
    if isinstance(layout, Product):
        return bool(layout.sign) or _open_ended(layout.factors[-1])
    return False


def _root(inside: Layout, index: int) -> str:
    sign = _ROOTS.get(index)
    text = _text(inside)
    if sign is None:
        return f"({text})^(1/{index})"
    if isinstance(inside, Number) or (isinstance(inside, Letter) and "_" not in text):
        return sign + text
    if isinstance(inside, Fraction):
        text = _slash(inside)
    return f"{sign}({text})"


def _function(layout: Function) -> str:
    power = "" if layout.power is None else _superscript(layout.power)
    argument = _text(layout.argument)
    if isinstance(layout.argument, Brackets):
        return f"{layout.name}{power}{argument}"
    if power and isinstance(layout.argument, Letter):
        return f"{layout.name}{power}{argument}"
    return f"{layout.name}{power} {argument}"


def _unit_number(inside: Layout) -> str:
    """A number before ° or %, in brackets if it is more than one thing."""
    if isinstance(inside, Fraction):
        return f"({_slash(inside)})"
    return _text(inside)
