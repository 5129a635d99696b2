"""A line of working as tokens: numbers, letters, functions, signs, names, units and words.

What a run of letters is depends on the question and on the whole script (`Usage`): ``mucos30`` is
m times u times cos 30, ``vA`` has the sphere A as its subscript, ``x`` is a sign or a letter.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from restitution.expression.limits import MAX_DIGITS
from restitution.expression.tree import GREEK
from restitution.expression.words import GREEK_SIGNS
from restitution.practice.reading.characters import Plain
from restitution.practice.reading.runs import is_mathematical, piece
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.vocabulary import (
    ABBREVIATED,
    ANNOUNCING,
    CONNECTIVES,
    DECLARES,
    EQUALS,
    FUNCTION_NAMES,
    HEADS,
    PHRASE_WORDS,
    PROSE,
    SHORT,
    SPOKEN,
)

_LONGEST_PRODUCT = 3
"""So many letters, at most, before an exponent may be a product and no word."""
_NUMBER = re.compile(r"\d+\.\d+|\.\d+|\d+", re.ASCII)
_RUN = re.compile(r"[A-Za-z]+(?:'(?=[a-z])[a-z]+)?")
# Behind it a function may stand: u_1cosθ, u_Acosθ.
_SUBSCRIPT = re.compile(
    r"_\s?(?:\{([A-Za-z0-9' ]{1,12})\}|([A-Za-z0-9]{1,2}(?=sin|cos|tan)"
    r"|[0-9](?=[a-wz][0-9_^])|[A-Za-z0-9]{1,6}))"
    r"|([0-9]+)(?![.\d])"
)
_PRIMES = re.compile(r"'{1,2}")
_RELATION = re.compile(r"<=|>=|=<|!=|=\s?/\s?=|:=|==|[<>]|=(?!>)")
_ARROW = re.compile(r"=+>|-+>")
_PLUS_MINUS = re.compile(r"±|\+\s?/\s?-|\+-(?=\s?[\d(√sA-Za-z])")
_FIGURES = re.compile(
    r"[(\[]?\s*(?:to\s+|correct\s+to\s+)?(?:\d|one|two|three|four)\s*"
    r"(?:s\.?\s?f(?:\.|\b)|d\.?\s?p(?:\.|\b)|sig\.?\s?figs?\b\.?|sig(?:nificant)?\s+fig(?:ure)?s?\b"
    r"|decimal\s+places?\b)\s*[)\]]?",
    re.IGNORECASE,
)
_UNIT = re.compile(
    r"(?:kg\s?)?m\s*/\s*s(?![A-Za-z(])|(?:kg\s?)?m\s?s\s*(?:\^\s*\(?\s*-\s?1\s*\)?|-1)(?!\d|\.\d)"
    r"|N\s?s(?![A-Za-z(])|N\s?/\s?s|kg(?![A-Za-z])|[Jj]oules?\b|metres?\b|newtons?\s+seconds?\b"
    r"|kgms(?:\^\s*\(?\s*-\s?1\s*\)?|-1)|J(?![A-Za-z_'\d])|m(?![A-Za-z_'\d(])|s(?![A-Za-z_'\d(])"
    r"|secs?(?![A-Za-z_'\d(])"
)
_SECONDS = ("sec", "secs")
_DEGREES = re.compile(r"°|deg(?:rees?|s)?\b|degress?\b")
_RADIANS = re.compile(r"rads?\b|radians?\b|\^c\b")
_PERCENT = re.compile(r"%|per\s?cent\b")
# Letters that people take for a speed or an impulse, also where a wall has the name.
_SPEEDS_AND_IMPULSES = frozenset("UVIJ")
_BEGINS_A_SIDE = re.compile(r"(?:^|[=,;:]|\b(?:so|hence|then|and))\s*$")
_GOES_ON_AS_A_LETTER = re.compile(r"\s*(?:[=²^]|cos|sin)")
_INVERSE = re.compile(
    r"inv(?:erse)?\s+(sin|cos|tan)e?(?:\s+of\b)?|(sin|cos|tan)\s?inv(?:erse)?(?:\s+of)?\b",
    re.IGNORECASE,
)
_ENERGY = re.compile(
    r"(?:KE|ke|Ke|[Ss]peed|[Vv]el(?:ocity)?|[Mm]omentum|[Ii]mpulse|[Mm]ass|[Aa]ngle)"
    r"_?\{?([A-Z]|(?<=[KEe])[a-z]{1,7}|(?<=_)[a-z]{1,7}|(?<=[EKek_])0)(?![A-Za-z0-9])\}?"
)
_COUNTED_ENERGY = re.compile(r"K\.?E\.?_?\{?([1-9])\}?(?![\d.])")
_OF_BODY = re.compile(
    r"\b(KE|ke|speed|velocity|vel|energy|momentum|impulse|angle|deflection|mass|direction)"
    r"\s?\(\s?([A-Z][A-Za-z0-9]?)\s?\)",
    re.IGNORECASE,
)
_SUFFIXED = re.compile(r"([uvwUVW])(perp|par|para|after|before|rel)(?![A-Za-z])")
_ENERGY_WORDS = {
    **dict.fromkeys(("i", "0", "before", "initial", "bef"), "before"),
    **dict.fromkeys(("f", "after", "final", "aft"), "after"),
    **dict.fromkeys(("lost", "loss"), "lost"),
}
_BRACKETED_UNIT = re.compile(
    r"[(\[]\s*(?:in\s+)?(?:m\s?/\s?s|k?g?\s?m\s?s\s?\^?\s?\(?-\s?1\)?|N\s?s|J|joules?|kg|degrees?)\s*[)\]]"
)
_CENTRES = re.compile(r"\bl\.\s?o\.\s?c\b\.?", re.IGNORECASE)
_THAT_IS = re.compile(r"\bi\.\s?e\.?(?=\s)", re.IGNORECASE)
_POSSESSIVE = re.compile(r"\b([A-Z])'s\b(?=\s+[A-Za-z]{2})")
_DOTTED = re.compile(r"\b([Kk])\.\s?([Ee])\b\.?")
_AMOUNTS = {"half": Fraction(1, 2), "twice": Fraction(2), "quarter": Fraction(1, 4)}
_FROM_AN_AXIS = re.compile(
    r"\b(?:below|above|under)\s+(?:the\s+)?(?:[+-]\s?)?"
    r"(?:[ij]\b(?:\s*-?\s*(?:axis|dir(?:ectio)?n?))?|[xy]\s*-?\s*axis|(?:horizontal|vertical)\b)"
)
_SHORT_FORM = re.compile(
    rf"\b({'|'.join(sorted(ABBREVIATED))})\.(?=\s*(?:[a-z=:]|[A-Z]\b))", re.IGNORECASE
)
_ORDINAL = re.compile(r"(\d)(?:st|nd|rd|th)\b", re.IGNORECASE)

_SIGNS = {
    "+": "+",
    "-": "-",
    "*": "*",
    "/": "/",
    "^": "^",
    "(": "(",
    ")": ")",
    "[": "(",
    "]": ")",
    "{": "(",
    "}": ")",
    "|": "|",
    ",": ",",
    ";": ";",
    ":": ":",
    "√": "function",
    "÷": "/",
    "·": "dot",
}
_CLOSING = frozenset(
    ("number", "letter", "name", "unit", "pi", ")", "phrase", "degrees", "percent")
)


def blanked(text: str) -> str:
    """A plain line with K.E., i.e., A's plainly, at the same offsets.

    Without remarks on accuracy, and on the side of an axis on which an angle lies: *below i*.
    """
    text = _BRACKETED_UNIT.sub(lambda match: " " * len(match[0]), text)
    text = _OF_BODY.sub(lambda match: f"{match[1]} {match[2]}".ljust(len(match[0])), text)
    text = _CENTRES.sub(lambda match: "loc".ljust(len(match[0])), text)
    text = _THAT_IS.sub(lambda match: "so".ljust(len(match[0])), text)
    text = _SHORT_FORM.sub(r"\1 ", text)
    text = _POSSESSIVE.sub(lambda match: match[1].ljust(len(match[0])), text)
    text = _FROM_AN_AXIS.sub(lambda match: " " * len(match[0]), text)
    text = _DOTTED.sub(lambda match: (match[1] + match[2]).ljust(len(match[0])), text)
    return _FIGURES.sub(lambda match: " " * len(match[0]), text)


def scan(line: Plain, usage: Usage) -> tuple[Token, ...]:
    """The tokens of a line. A sign that nobody uses is a token of kind ``strange``."""
    return tuple(_Scanner(line, usage).tokens())


class _Scanner:
    def __init__(self, line: Plain, usage: Usage) -> None:
        self.line, self.usage = line, usage
        self.text = blanked(line.text)
        self.offset = 0
        self.token_list: list[Token] = []

    def tokens(self) -> Iterator[Token]:
        """Every token, in the order of the line."""
        while True:
            start = self.offset
            while self.offset < len(self.text) and self.text[self.offset].isspace():
                self.offset += 1
            if self.offset >= len(self.text):
                break
            gap = self.offset - start
            before = len(self.token_list)
            self._next(gap)
            if len(self.token_list) == before:  # pragma: no cover - every step makes a token
                self._add("strange", self.offset + 1, gap)
        yield from self.token_list

    def _add(
        self, kind: str, end: int, gap: int = 0, name: str = "", value: Fraction = Fraction(0)
    ) -> None:
        text = self.text[self.offset : end]
        column = self.line.column(self.offset)
        self.token_list.append(Token(kind, text, self.offset, end, column, gap, name, value))
        self.offset = end

    def _after_operand(self) -> bool:
        return bool(self.token_list) and self.token_list[-1].kind in _CLOSING

    def _next(self, gap: int) -> None:
        text, offset = self.text, self.offset
        character = text[offset]
        if (character.isdigit() and character.isascii()) or self._is_point():
            self._number(gap)
        elif character.isascii() and character.isalpha():
            self._run(gap)
        elif character in GREEK_SIGNS:
            self._letter(GREEK_SIGNS[character], offset + 1, gap)
        elif character == "π":
            self._add("pi", offset + 1, gap)
        elif match := _ARROW.match(text, offset):
            self._add("arrow", match.end(), gap)
        elif match := _PLUS_MINUS.match(text, offset):
            self._add("±", match.end(), gap)
        elif match := _RELATION.match(text, offset):
            typed = {"=<": "<=", ":=": "=", "==": "="}.get(match[0], match[0])
            sign = "!=" if "/" in typed else typed
            self._add("relation", match.end(), gap, sign)
        elif character == "~":
            self._add("relation", offset + (2 if text.startswith("~=", offset) else 1), gap, "=")
        elif text.startswith("**", offset):
            self._add("^", offset + 2, gap)
        elif self._is_percent() and (match := _PERCENT.match(text, offset)):
            self._add("percent", match.end(), gap)
        elif character == "%":
            self._add("word", offset + 1, gap, "percentage")
        elif character == "°":
            self._add("degrees", offset + 1, gap)
        elif character == ".":
            self._point(gap)
        elif character in "?!":
            self._add("stop", offset + 1, gap)
        elif character in _SIGNS:
            kind = _SIGNS[character]
            self._add(kind, offset + 1, gap, "sqrt" if kind == "function" else "")
        else:
            self._add("strange", offset + 1, gap)

    def _is_percent(self) -> bool:
        """Whether a percent sign belongs to the value before it."""
        return bool(self.token_list) and self.token_list[-1].kind in ("number", ")", "pi")

    def _is_point(self) -> bool:
        """Whether a decimal begins here with its point: ``.5``, not the ``.`` of ``2.v``."""
        text, offset = self.text, self.offset
        if text[offset] != "." or not text[offset + 1 : offset + 2].isdigit():
            return False
        return not (self._after_operand() and self.token_list[-1].end == offset)

    def _point(self, gap: int) -> None:
        """A point: between operands a product, at the end of a sentence a stop."""
        text, offset = self.text, self.offset
        behind = text[offset + 1 : offset + 2]
        tight = bool(behind) and not behind.isspace()
        spaced = gap > 0 and behind.isspace()
        bars = tight and gap == 0 and bool(self.token_list) and self.token_list[-1].kind == "|"
        if (self._after_operand() or bars) and (tight or spaced) and behind not in ".,":
            self._add("dot", offset + 1, gap)
        else:
            self._add("stop", offset + 1, gap)

    # -- numbers and what stands behind them -------------------------------------------------

    def _number(self, gap: int) -> None:
        ordinal = _ORDINAL.match(self.text, self.offset)
        if ordinal:
            self._add("word", ordinal.end(), gap, ordinal[0].lower())
            return
        match = _NUMBER.match(self.text, self.offset)
        assert match is not None
        if len(match[0]) > MAX_DIGITS:
            self._add("strange", match.end(), gap)
            return
        self._add("number", match.end(), gap, value=Fraction(match[0]))

    def _unit(self, gap: int) -> bool:
        """Takes a unit behind a value: ``3 m/s``, ``12Ns``; a letter of the question is none."""
        text, offset = self.text, self.offset
        if not self._after_operand():
            return False
        if self.token_list[-1].kind in ("number", ")", "pi", "letter") and (
            match := _DEGREES.match(text, offset) or _RADIANS.match(text, offset)
        ):
            degrees = bool(_DEGREES.match(text, offset))
            self._add("degrees" if degrees else "radians", match.end(), gap)
            return True
        match = _UNIT.match(text, offset)
        if match is None or not self._is_unit(match[0], gap):
            return False
        if not _ends_a_side(text, match.end()):
            return False
        name = re.sub(r"\s", "", match[0])
        name = "s" if name in _SECONDS else name
        other = any(token.name == "J" for token in self.token_list)
        letter = name == "J" and self.usage.joules
        value = Fraction(2 if letter and not other else 1 if letter else 0)
        self._add("measure", match.end(), gap, name, value)
        return True

    def _is_unit(self, text: str, gap: int) -> bool:
        plain = re.sub(r"\s", "", text)
        known = self.usage.letters
        if plain in ("m", "s"):
            return (
                (gap > 0 or plain == "s" or self._may_be_metres())
                and self.token_list[-1].kind in ("number", ")" if plain == "s" else "number")
                and plain not in (known | self.usage.alone)
            )
        if plain in _SECONDS:
            return self.token_list[-1].kind in ("number", ")")
        if plain in ("Ns", "N/s"):
            return "N" not in known
        if plain == "J":
            return "J" not in known and (self.token_list[-1].kind in ("number", ")", "letter"))
        if plain.startswith(("m/s", "ms")):
            return "s" not in known and (self.token_list[-1].kind != "/")
        return True

    def _may_be_metres(self) -> bool:
        """Whether an m directly behind a number may be metres: its side is of numbers alone."""
        side: list[str] = []
        for token in reversed(self.token_list):
            if token.kind in ("relation", "word", ",", ":"):
                break
            side.append(token.kind)
        return self.usage.metres and "letter" not in side and side[1:2] != ["/"]

    # -- runs of letters --------------------------------------------------------------------

    def _run(self, gap: int) -> None:
        if self._unit(gap) or self._inverse(gap) or self._energy(gap):
            return
        if self._is_percent() and (match := _PERCENT.match(self.text, self.offset)):
            self._add("percent", match.end(), gap)
            return
        if match := _SUFFIXED.match(self.text, self.offset):
            self._add("letter", match.end(), gap, f"{match[1]}_{match[2]}")
            return
        match = _RUN.match(self.text, self.offset)
        assert match is not None
        run, end = match[0], match.end()
        name = self._name(run, end)
        if name:
            self._add("name", self.offset + len(name), gap, name)
            return
        low = run.lower()
        if low in ("mod", "sine", "cosine") and re.match(r"\s*[\w(]", self.text[end:]):
            self._add("function", end, gap, FUNCTION_NAMES[low])
        elif "'" in run or self._is_word(run, low, end, gap):
            self._word(run, low, end, gap)
        else:
            self._product(self.offset + len(run), gap)

    def _inverse(self, gap: int) -> bool:
        """Takes ``inv tan``, ``inverse tan of``, ``tan inverse``."""
        match = _INVERSE.match(self.text, self.offset)
        if match:
            name = FUNCTION_NAMES[(match[1] or match[2]).lower()]
            self._add("function", match.end(), gap, f"arc{name}")
        return match is not None

    def _energy(self, gap: int) -> bool:
        """Takes ``KEA``, ``KE_B``, ``KEf`` as words, and ``KE1`` as a letter."""
        counted = _COUNTED_ENERGY.match(self.text, self.offset)
        if counted is not None:
            self._add("letter", counted.end(), gap, f"E_{counted[1]}")
            return True
        match = _ENERGY.match(self.text, self.offset)
        if match is None:
            return False
        behind = match[1]
        if behind not in self.usage.spheres and behind.lower() not in _ENERGY_WORDS:
            return False
        length = match.start(1) - self.offset
        word = self.text[self.offset : self.offset + length].rstrip("_{")
        self._add("word", self.offset + len(word), gap, word.lower())
        while self.text[self.offset] in "_{ ":
            self.offset += 1
        if behind in self.usage.spheres:
            self._add("name", match.end(), 0, behind)
        else:
            self._add("word", match.end(), 0, _ENERGY_WORDS[behind.lower()])
        return True

    def _name(self, run: str, end: int) -> str:
        """The name of a body that stands here as a whole, or nothing."""
        names = self.usage.names
        behind = re.match(r"[0-9]+", self.text[end : end + 4])
        if behind and run + behind[0] in names:
            return run + behind[0]
        if run in names and not re.match(r"[_0-9]", self.text[end : end + 1]):
            return "" if self._is_speed_of_a_name(run, end) else run
        return ""

    def _is_speed_of_a_name(self, run: str, end: int) -> bool:
        """Whether the name of a wall is a letter here: ``V = √(36 + 16)``, ``V² = 52``."""
        if run not in self.usage.walls or run not in _SPEEDS_AND_IMPULSES:
            return False
        begins = _BEGINS_A_SIDE.search(self.text[: self.offset]) is not None
        return begins and _GOES_ON_AS_A_LETTER.match(self.text, end) is not None

    def _word(self, run: str, low: str, end: int, gap: int) -> None:
        if low in _AMOUNTS:
            self._add("number", end, gap, value=_AMOUNTS[low])
        elif low in SPOKEN and self._after_operand():
            self._add(SPOKEN[low], end, gap)
        elif low == "squared" and self._after_operand():
            self._add("^", end, gap)
            self.token_list.append(
                Token("number", "2", end, end, self.line.column(end), 0, "", Fraction(2))
            )
        else:
            self._add("word", end, gap, low)

    def _is_word(self, run: str, low: str, end: int, gap: int) -> bool:
        behind = self.text[end : end + 1]
        if low in FUNCTION_NAMES and low not in PHRASE_WORDS:
            return low in PROSE and not re.match(r"\s*[\d(√A-Za-zα-ω^]", self.text[end : end + 3])
        if len(run) == 1 and low not in SHORT:
            return False
        if low in SHORT:
            return self._is_short_word(run, low, end)
        if run == "ek" and {"e", "k"} <= self.usage.letters:
            return False
        if low == "ke" and run.islower() and set(run) <= self.usage.letters:
            return not re.match(r"\s*[=<>+*/^)-]|\s*$", self.text[end:])
        if behind in ("^", "²") and low in HEADS and len(low) > _LONGEST_PRODUCT:
            return True  # speed^2 = 9 + 16
        if behind in ("_", "^") or (behind.isdigit() and low not in PHRASE_WORDS):
            return False
        if low == "pi" or low in GREEK:
            return False
        if low in PROSE or low in PHRASE_WORDS or low in CONNECTIVES or low in ANNOUNCING:
            return True
        if low in DECLARES or low in EQUALS:
            return True
        return not is_mathematical(run, self.usage)

    def _is_short_word(self, run: str, low: str, end: int) -> bool:
        """Whether ``a``, ``we``, ``me`` is a word here, by what stands beside it."""
        around = self.text[end:].lstrip()
        before = self.text[: self.offset].rstrip()
        glued = self.text[end : end + 1]
        if glued and (glued in "_'^(²" or glued.isdigit()):
            return False
        if around[:1] and around[0] in "=+-*/^<>|)·,;~":
            return False
        if before[-1:] and before[-1] in "=+-*/^<>(|·√":
            return False
        if self.token_list and self.token_list[-1].kind in ("function", "number"):
            return False
        following = re.match(r"[A-Za-z]{2,}", around)
        declares = any(token.kind == "word" and token.name in DECLARES for token in self.token_list)
        if low == "be" and declares and before != self.text[: self.offset]:
            return True  # let the velocity be ai + bj
        if run in ("i", "j", "a", "k", "s") and self._after_operand():
            return bool(following and following[0].lower() in PROSE and low == "a")
        if not following:
            return len(run) > 1
        word = following[0].lower()
        if word in FUNCTION_NAMES:
            return False
        if low == "i":
            return word in ("think", "used", "get", "got", "know", "am", "have", "guess", "dont")
        return (
            word in PROSE or word in PHRASE_WORDS or not is_mathematical(following[0], self.usage)
        )

    def _product(self, end: int, gap: int) -> None:
        """Takes a run of letters piece by piece."""
        run = self.text[self.offset : end]
        start = self.offset
        while self.offset < end:
            kind, text = piece(run, self.offset - start, self.usage, self.text[end : end + 8])
            stop = self.offset + len(text)
            space = gap if self.offset == start else 0
            if kind == "function":
                self._add("function", stop, space, FUNCTION_NAMES[text.lower()])
            elif kind == "pi":
                self._add("pi", stop, space)
            elif kind == "greek":
                low = text.lower()
                self._letter("lambda" if low == "lamda" else low, stop, space)
            else:
                self._single(text, stop, end, space)
                end = max(end, self.offset)
                if self.offset > end:  # pragma: no cover
                    break

    def _single(self, letter: str, stop: int, end: int, gap: int) -> None:
        """A letter of a run, with the name of a sphere behind it as its subscript."""
        usage, text = self.usage, self.text
        if letter in "xX" and self._is_times(stop):
            self._add("times", stop, gap, "x", Fraction(self._doubt(stop)))
            return
        behind = text[stop : stop + 1]
        if stop < end and behind in usage.spheres and not letter.isspace():
            follows = _PRIMES.match(text, stop + 1)
            last = follows.end() if follows else stop + 1
            if letter in usage.spheres:
                self._add("name", stop, gap, letter)
                return
            axis = text[last : last + 1] if not follows else ""
            if axis in ("x", "y") and last + 1 == end and self._is_component(letter, last + 1):
                self._add("letter", last + 1, gap, f"{letter}_{behind}{axis}")
                return
            self._add("letter", last, gap, f"{letter}_{behind}" + text[stop + 1 : last])
            return
        if behind in ("x", "y") and stop + 1 == end and self._is_component(letter, stop + 1):
            primes = _PRIMES.match(text, stop + 1)
            dash = primes[0] if primes else ""
            self._add("letter", stop + 1 + len(dash), gap, f"{letter}_{behind}{dash}")
            return
        pair = letter + behind
        if stop < end and pair in usage.aliases:
            primes = _PRIMES.match(text, stop + 1)
            dash = primes[0] if primes else ""
            self._add("letter", stop + 1 + len(dash), gap, usage.aliases[pair] + dash)
            return
        if letter in "ij" and text[stop : stop + 1] != "_":
            self._add("unit", stop, gap, letter)
            return
        if letter in usage.spheres and text[stop : stop + 1] not in ("_",):
            self._add("name", stop, gap, letter)
            return
        self._letter(letter, stop, gap)

    def _is_component(self, letter: str, stop: int) -> bool:
        """Whether ``vx`` is the component of v: where no product could be meant."""
        if letter not in "uvwVUIJ" or self.text[stop - 1] in self.usage.letters:
            return False
        if self.text[stop - 1] == "x" and letter in self.usage.letters and not self.usage.times:
            return False  # x² + 16ux = 0
        if self.text[stop - 1] in self.usage.alone and letter in self.usage.letters:
            return False  # 6y² - 2uy = 0
        return bool(re.match(r"\s*(?:$|[=+\-/)^,;<>'*]|\s[a-z]{3,})", self.text[stop:]))

    def _is_times(self, stop: int) -> bool:
        """Whether an x at the offset is a sign, between what stands before and behind it."""
        if not self._after_operand() or self.text[stop : stop + 1] in ("_", "'", "^"):
            return False
        behind = re.match(r"\s*-?\s*([A-Za-z0-9.(√|½α-ω])", self.text[stop:])
        return bool(behind) and (self.usage.times or self._doubt(stop) > 0)

    def _doubt(self, stop: int) -> int:
        """Whether an x between operands is a sign alone (0), may be one (1), or rather is (2)."""
        if self.usage.times:
            return 0
        behind = re.match(r"(\s*)(-?)\s*(\S)", self.text[stop:])
        if behind is None:
            return 0
        number = self.token_list[-1].kind in ("number", ")")
        if behind[3].isdigit() and not behind[1] and not behind[2]:
            return 2
        if behind[2]:
            return 1
        if number and (behind[3].isdigit() or behind[3] in ".("):
            return 2
        apart = self.text[self.offset - 1 : self.offset].isspace() and bool(behind[1])
        return 2 if apart else 0

    def _is_factor(self, name: str, subscript: str, match: re.Match[str]) -> bool:
        """Whether a number behind the letter of a mass is no subscript: so many bodies are none.

        Nor is one glued to a further letter, ``m2u``, where no mass is counted as the first.
        """
        many = subscript.isdigit() and int(subscript) > len(self.usage.spheres) + 1
        glued = subscript.isdigit() and self.text[match.end() : match.end() + 1].isalpha()
        many = many or (glued and name not in self.usage.counted)
        typed = match[0] == subscript
        own = name in self.usage.letters and f"{name}_{subscript}" not in self.usage.letters
        return typed and many and own and name in ("m", "M")

    def _letter(self, name: str, stop: int, gap: int) -> None:
        """Takes a letter with its subscript and its dashes."""
        match = _SUBSCRIPT.match(self.text, stop)
        subscript = ""
        if match:
            subscript = (match[1] or match[2] or match[3]).replace(" ", "").replace("'", "")
            if self._is_factor(name, subscript, match):
                subscript = ""  # ½m9u² is ½ × m × 9u²
            else:
                stop = match.end()
        primes = _PRIMES.match(self.text, stop)
        if primes and self.text[primes.end() : primes.end() + 1] not in ("s", "t"):
            stop = primes.end()
        else:
            primes = None
        if not subscript and not primes:
            name = self.usage.aliases.get(name, name)
        elif subscript and subscript not in self.usage.spheres and len(subscript) == 1:
            upper = subscript.upper()
            known = f"{name}_{subscript}" in self.usage.letters
            subscript = upper if upper in self.usage.spheres and not known else subscript
        full = f"{name}_{subscript}" if subscript else name
        self._add("letter", stop, gap, full + (primes[0] if primes else ""))


_SIDE_END = re.compile(
    r"\s*(?:$|[=<>,;:.)\]!~|(\[+\-*/]|so\b|as\b|if\b|is\b|and\b|or\b|after\b|before\b|to\b|in\b|on\b|at\b|by\b|hence\b|=>|[a-zA-Z]{3,})"
)


def _ends_a_side(text: str, offset: int) -> bool:
    """Whether nothing that could be multiplied stands behind an offset."""
    return bool(_SIDE_END.match(text, offset)) or text[offset : offset + 2].isspace()
