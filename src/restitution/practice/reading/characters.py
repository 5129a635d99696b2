"""What is typed on phones and pasted from anywhere, as plain characters with their columns."""

from __future__ import annotations

import re
import unicodedata

from restitution.records import dataclass

_SAME: dict[str, str] = {
    **dict.fromkeys("−–—‐‑‒﹣－➖", "-"),
    **dict.fromkeys("×✕✖⨯⨉", "*"),
    **dict.fromkeys("⋅∙•∗·⸱・", "·"),
    **dict.fromkeys("∕⁄", "/"),
    "➗": "÷",
    **dict.fromkeys("≤⩽≦", "<="),
    **dict.fromkeys("≥⩾≧", ">="),
    "≠": "!=",
    **dict.fromkeys("≈≃≅≡≒", "="),
    **dict.fromkeys("⇒⟹→⟶⇨➜➔➡∴⇔↔", " ==> "),
    "∵": " because ",
    **dict.fromkeys("°º˚", "°"),
    **dict.fromkeys("’′´`‘ʹ", "'"),
    "″": "''",
    **dict.fromkeys("∣｜¦", "|"),
    **dict.fromkeys('“”„"✓✔✗✘☑↑↓…', " "),
    "⊥": " perp ",
    "⟂": " perp ",
    **dict.fromkeys("∥‖", " parallel "),
    "∠": " angle ",
    "∆": " change in ",
    "Δ": " change in ",
    **dict.fromkeys("∑Σ", " total "),
    "@": " at ",
    "&": " and ",
    "\t": "   ",
    "ß": "β",
    "∓": "±",
    "ı": "i",
    "ȷ": "j",
    "∞": " infinity ",
    "⟨": "(",
    "⟩": ")",
    "←": " ",
}
# What is typed for want of a sign, and what is meant.
_TYPED = (
    (  # a vector, and no two inequalities: 1 - 4e < 0, e > 1/4
        re.compile(r"(^|[=+(:*/-]\s*|[A-Za-z]\s)<([^<>=,]{1,20}),([^<>=,]{1,20})>(?!\s*[\w√(.])"),
        r"\1(\2,\3)",
    ),
    (re.compile(r"(?<=\d)\.\.(?=\d)"), "."),
    (  # a decimal, and no two values: those have a blank between them
        re.compile(r"(=\s*-?\d+),(\d{2,})(?=\s*(?:$|[=°mNJ]|deg))"),
        r"\1.\2",
    ),
    (re.compile(r"\b(sep)\s?/\s?(app)\b", re.IGNORECASE), r"\1/\2roach"),
    (re.compile(r"(?<![*\w])\*\*([A-Za-z]\w{0,3})\*\*(?![*\w])"), r" \1 "),
    (re.compile(r"(?<![A-Za-z])([ij])\^(?=\s*(?:[-+=)\s,]|$))"), r"\1 "),
    # ``|3i + 4j||i - j|``: two sizes, and nothing parallel
    (re.compile(r"(\|[^|=]*[\dijuvw)])\|\|(?=[^|=]*[\dijuvw)]\|)"), r"\1| |"),
    # ``wall // 3i + 4j``: before a vector it is a sign between two directions
    (
        re.compile(
            r"(?<=[A-Za-z])(?:\s*(?:[∥‖]|//)|\s+\|\|(?=\s))\s*(?:to\s+)?"
            r"(?=[-−([]*\s*[\d.√½]*\s*[ij\d])"
        ),
        " parallel to ",
    ),
    (re.compile(r"(?<=[A-Za-z])(?:⊥|\s⊥(?=\s*[=)]))"), "_perp "),
    (re.compile(r"(?<=[A-Za-z])(?:[∥‖]|\|\|(?=\s*[=+\-]))"), "_par "),
    (re.compile(r"[①-⑨]"), lambda match: f" ({ord(match[0]) - 0x245F})"),
)
_FRACTIONS = re.compile(r"(\d*)([½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅐⅛⅜⅝⅞⅑⅒])")
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ⁿ"
_LOWERED = "₀₁₂₃₄₅₆₇₈₉ₐₑₓ"
_RAISED_PLAIN = str.maketrans(_RAISED, "0123456789+-()n")
_LOWERED_PLAIN = str.maketrans(_LOWERED, "0123456789aex")

_LATEX_BRACES = re.compile(r"\\(?:d|t)?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
# What stands without braces: \\frac12, \\frac{1}2, \\sqrt3, \\sqrt 3.
_LATEX_BARE_FRACTION = re.compile(
    r"\\(?:d|t)?frac\s*(\{[^{}]*\}|\\pi|[A-Za-z0-9])\s*(\{[^{}]*\}|\\pi|[A-Za-z0-9])"
)
_LATEX_BARE_ROOT = re.compile(r"\\sqrt\s*(\d+|[A-Za-z])")
_LATEX_POWER = re.compile(r"\^\{([^{}]*)\}")
_LATEX_DEGREES = re.compile(r"\^\s*(?:\{\s*)?\\(?:circ|degree)\b\s*\}?")
_LATEX_BELOW = re.compile(r"_\{([A-Za-z0-9])\}(?=(\w)?)")
_LATEX_WAY = re.compile(r"_\s*(?:\{\s*)?\\(perp|par)(?:allel)?\b\s*\}?")
# What sets lines and says nothing.
_LATEX_SETTING = re.compile(r"\\(?:begin|end)\{(?:align|aligned|equation|gather)\*?\}|\\\\\s*$")
_LATEX_ROOT = re.compile(r"\\sqrt\s*\{([^{}]*)\}")
_LATEX_COLUMN = re.compile(
    r"\\begin\{[pb]matrix\}(.*?)\\\\(.*?)\\end\{[pb]matrix\}|\\binom\s*\{([^{}]*)\}\s*\{([^{}]*)\}"
)
_LATEX_TEXT = re.compile(
    r"(\\[A-Za-z]+)?"  # that of a command before it: \cdot\mathbf{i}
    r"\\(?:text|mathrm|mathbf|mathit|underline|vec|hat|bar|boxed)\s*\{([^{}]*)\}"
)
_LATEX_SIGNS = {
    "times": "*",
    "cdot": "·",
    "div": "/",
    "leq": "<=",
    "le": "<=",
    "geq": ">=",
    "ge": ">=",
    "neq": "!=",
    "ne": "!=",
    "approx": "=",
    "Rightarrow": "=>",
    "implies": "=>",
    "therefore": "=>",
    "to": "=>",
    "pm": "±",
    "circ": "°",
    "degree": "°",
    "left": "",
    "right": "",
    "quad": "  ",
    "qquad": "  ",
    "lvert": "|",
    "rvert": "|",
    "mid": "|",
    "prime": "'",
    "Delta": "Δ",
    "cdots": " ",
    "dots": " ",
    "parallel": "∥",
    "perp": "⊥",
    "lt": "<",
    "gt": ">",
}
_LATEX_WORD = re.compile(r"\\([A-Za-z]+)")
# Between words one space stands, as more would part relations.
_LATEX_GAP = re.compile(r" ?\0 ?(?:\0 ?)?")


@dataclass(frozen=True)
class Plain:
    """A line in plain characters; ``columns`` has the column, from 1, of each of them."""

    text: str
    columns: tuple[int, ...]

    def column(self, offset: int) -> int:
        """The column of an offset; that behind the last character at the end."""
        if offset < len(self.columns):
            return self.columns[offset]
        return self.columns[-1] + 1 if self.columns else 1


def plain(line: str) -> Plain:
    """A line as typed, with every variant of a sign made one and accents taken off."""
    text = _without_latex(line) if "\\" in line or "$" in line else line
    for pattern, instead in _TYPED:
        text = pattern.sub(instead, text)
    if text.isascii() and "\t" not in text and not _changes(text):
        return Plain(text, tuple(range(1, len(text) + 1)))
    characters: list[str] = []
    columns: list[int] = []

    def add(more: str, column: int) -> None:
        characters.extend(more)
        columns.extend([column] * len(more))

    offset = 0
    while offset < len(text):
        match = _FRACTIONS.match(text, offset)
        if match and match[0] and (offset == 0 or text[offset - 1] not in "0123456789."):
            whole, sign = match[1], match[2]
            above, below = unicodedata.normalize("NFKC", sign).split("⁄")
            add(f"({whole}+{above}/{below})" if whole else f"({above}/{below})", offset + 1)
            offset = match.end()
            continue
        character = text[offset]
        if character in _RAISED or character in _LOWERED:
            end = offset
            kinds = _RAISED if character in _RAISED else _LOWERED
            while end < len(text) and text[end] in kinds:
                end += 1
            stretch = text[offset:end]
            if kinds is _RAISED:
                inside = stretch.translate(_RAISED_PLAIN)
                alone = inside.isdigit() and not text[end : end + 1].isdigit()
                add(f"^{inside}" if alone else f"^({inside})", offset + 1)
            else:
                below = stretch.translate(_LOWERED_PLAIN)
                glued = text[end : end + 1].isalnum()  # e₂ui is no letter with 2ui below
                add(f"_{{{below}}}" if glued else f"_{below}", offset + 1)
            offset = end
            continue
        add(_plain_character(character), offset + 1)
        offset += 1
    return Plain("".join(characters), tuple(columns))


def _changes(text: str) -> bool:
    return any(sign in text for sign in '@&`"')


def _plain_character(character: str) -> str:
    same = _SAME.get(character)
    if same is not None:
        return same
    if character.isascii() or character in "√÷":
        return character
    if unicodedata.combining(character):
        return ""
    compatible = unicodedata.normalize("NFKC", character)
    if compatible in _SAME:
        return _SAME[compatible]
    simple = unicodedata.normalize("NFKD", compatible)
    bare = "".join(part for part in simple if not unicodedata.combining(part))
    if not bare or unicodedata.category(character) in ("So", "Cf", "Cc", "Zs", "Zl", "Zp", "Mn"):
        return bare if bare.isascii() and bare.strip() else " "
    return bare


def _without_latex(text: str) -> str:
    """The usual signs of LaTeX as plain text; columns are then those of the plain text."""
    text = text.replace("$", " ").replace("\\,", " ").replace("\\;", " ").replace("\\!", "")
    text = text.replace("\\%", "%")
    text = _LATEX_COLUMN.sub(_column_of, text)
    text = _LATEX_WAY.sub(r"_\1 ", _LATEX_SETTING.sub(" ", text))
    text = re.sub(r"&\s*(?=[=<>\\])", "", text)
    text = _LATEX_DEGREES.sub("°", text)
    for _ in range(6):
        text = _LATEX_POWER.sub(r"^(\1)", text)
        text = _LATEX_BELOW.sub(lambda below: f"_{below[1]}{' ' if below[2] else ''}", text)
        text, first = _LATEX_TEXT.subn(_bare_text, text)
        text = _LATEX_BARE_ROOT.sub(r"\\sqrt{\1}", text)
        text = _LATEX_BARE_FRACTION.sub(_with_braces, text)
        text, second = _LATEX_ROOT.subn(r"sqrt(\1)", text)
        text, third = _LATEX_BRACES.subn(r"((\1)/(\2))", text)
        if not first + second + third:
            break
    text = _LATEX_WORD.sub(lambda match: _LATEX_SIGNS.get(match[1], f"\0{match[1]}\0"), text)
    return _LATEX_GAP.sub(" ", text)


def _bare_text(match: re.Match[str]) -> str:
    return f"{match[1]} {match[2]}" if match[1] else match[2]


def _with_braces(match: re.Match[str]) -> str:
    above, below = (part if part.startswith("{") else f"{{{part}}}" for part in match.groups())
    return rf"\frac{above}{below}"


def _column_of(match: re.Match[str]) -> str:
    above, below = (match[1], match[2]) if match[1] is not None else (match[3], match[4])
    return f"({above},{below})"
