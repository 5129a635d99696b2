"""A line of tokens as segments of mathematics, and the words and signs between them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Literal

from restitution.practice.reading.tokens import Token
from restitution.practice.reading.vocabulary import (
    HEADS,
    SWALLOWING,
)
from restitution.records import dataclass

_OPERANDS = frozenset(("number", "letter", "name", "unit", "pi", "phrase", "function", "("))
_OF_NUMBERS = frozenset(("number", "+", "-", "*", "times", "dot", "/", "(", ")"))
_CLOSING = frozenset(("number", "letter", "name", "unit", "pi", ")", "phrase", "percent"))


# Words that say of the relation before them that it cannot be, and those that lead to them.
_REJECTING = frozenset(
    ("impossible", "rejected", "reject", "invalid", "discard", "ignore", "would", "cannot")
)
_TOO = frozenset(("big", "large", "great", "high", "small", "much"))
# What a fraction before them is of: ``KE after = 0.36 of it``.
_WHOLES = frozenset(("it", "that", "this", "them", "these", "those", "what"))
_LEADING = frozenset(("which", "is", "means", "mean", "so", "but", "gives", "therefore"))


@dataclass(frozen=True)
class Segment:
    """Tokens without words; ``before`` are the words and signs that part it from the last one.

    ``rejected`` tells that the words behind it say it cannot be: ``v = 2u means no collision``.
    """

    tokens: tuple[Token, ...]
    before: tuple[str, ...] = ()
    rejected: bool = False

    @property
    def has_relation(self) -> bool:
        """Whether it states something."""
        return any(token.kind == "relation" for token in self.tokens)

    @property
    def is_phrase(self) -> bool:
        """Whether it is nothing but the name of a quantity, or of a body."""
        return len(self.tokens) == 1 and self.tokens[0].kind in ("phrase", "name")


def segments(tokens: Sequence[Token], case: bool = False) -> list[Segment]:
    """The segments of a line, with what parts them; ``case`` tells that it opens a case."""
    pieces: list[Segment] = []
    pending: list[Token] = []
    before: list[str] = []
    loose = _loose_brackets(tokens)
    depth = 0
    for place, token in enumerate(tokens):
        if place in loose or (not depth and _begins_sentence(tokens, place, pending)):
            separator = True
        elif token.kind == "(":
            depth, separator = depth + 1, False
        elif token.kind == ")":
            depth, separator = max(0, depth - 1), False
        else:
            separator = _separates(tokens, place, depth, pending)
        if not depth and _begins_body(tokens, place, pending):
            pieces.append(Segment(tuple(pending), tuple(before)))
            pending, before = [token], [","]
            continue
        if not separator:
            pending.append(token)
            continue
        if pending:
            pieces.append(Segment(tuple(pending), tuple(before)))
            pending, before = [], []
        before.append(token.word if token.kind in ("word", "phrase") else token.text)
    if pending:
        pieces.append(Segment(tuple(pending), tuple(before)))
        before = []
    pieces = [_with_verdict(piece, pieces, place, before) for place, piece in enumerate(pieces)]
    pieces = list(_with_case(pieces, case))
    return [
        segment
        for segment in map(_without_number, map(_without_swallowed, pieces))
        if segment.tokens
    ]


def _with_verdict(
    segment: Segment, pieces: Sequence[Segment], place: int, last: Sequence[str]
) -> Segment:
    """A segment with what the words behind it say of it; ``last`` are those that end the line."""
    behind = pieces[place + 1].before if place + 1 < len(pieces) else tuple(last)
    words = [word for word in behind if word.isalpha()]
    while words and words[0] in _LEADING:
        words = words[1:]
    denied = len(words) > 1 and words[0] in ("no", "not")
    denied = denied or (words[:1] == ["too"] and bool(_TOO & set(words[1:2])))
    denied = denied or (words[:1] == ["of"] and words[1:2] != [] and words[1] in _WHOLES)
    rejected = segment.has_relation and (denied or (bool(words) and words[0] in _REJECTING))
    return replace(segment, rejected=True) if rejected else segment


def _with_case(pieces: Sequence[Segment], opened: bool) -> Iterator[Segment]:
    """The segments, all of a case rejected where the last one is: ``or v = 2u, e = 4 too big``."""
    opens = [(opened and not place) or "or" in piece.before for place, piece in enumerate(pieces)]
    for place, piece in enumerate(pieces):
        end = next((n for n in range(place + 1, len(pieces)) if opens[n]), len(pieces))
        rejected = any(opens[: place + 1]) and pieces[end - 1].rejected and piece.has_relation
        yield replace(piece, rejected=True) if rejected else piece


def _without_number(segment: Segment) -> Segment:
    """A segment without the number of its equation: ``v + w = 3 (1), w - v = 1 (2)``."""
    tokens = segment.tokens
    if len(tokens) < 6 or not segment.has_relation:
        return segment
    opening, number, closing = tokens[-3:]
    plain = (opening.kind, number.kind, closing.kind) == ("(", "number", ")")
    whole = number.value.denominator == 1 and number.value < 10
    if plain and whole and opening.gap and tokens[-4].kind not in ("relation", "function"):
        return replace(segment, tokens=tokens[:-3])
    return segment


def _separates(tokens: Sequence[Token], place: int, depth: int, pending: Sequence[Token]) -> bool:
    token = tokens[place]
    if token.kind in ("word", "arrow", "stop"):
        return True
    if token.kind in (";", ","):
        return depth == 0
    if token.kind == ":":
        return not _is_proportion(tokens, place)
    if token.kind == "phrase" and pending and pending[-1].kind in (*_CLOSING, "measure", "degrees"):
        return not _is_factor(tokens, place, pending)
    return False


def _begins_body(tokens: Sequence[Token], place: int, pending: Sequence[Token]) -> bool:
    """Whether the name of another body begins a relation: ``A = 3i + j  B = 2i``.

    Behind a relation it does so without a sign as well: ``A 5 sin α = 3  B 4``.
    """
    token = tokens[place]
    if token.kind != "name" or not token.gap or place + 1 >= len(tokens):
        return False
    behind = tokens[place + 1].kind
    ended = len(pending) > 1 and pending[-1].kind in (*_CLOSING, "measure")
    stated = any(token.kind == "relation" for token in pending)
    return ended and (behind in ("relation", ":") or (stated and behind in ("number", "function")))


def _begins_sentence(tokens: Sequence[Token], place: int, pending: Sequence[Token]) -> bool:
    """Whether words of a body begin behind a relation: ``1.5u > -0.4u A catches B``."""
    token = tokens[place]
    spoken = place + 1 < len(tokens) and tokens[place + 1].kind == "word"
    ended = bool(pending) and pending[-1].kind in (*_CLOSING, "measure")
    stated = any(token.kind == "relation" for token in pending)
    return token.kind == "name" and token.gap > 0 and spoken and ended and stated


def _is_proportion(tokens: Sequence[Token], place: int) -> bool:
    """Whether a colon is one between numbers or letters: ``3:5``, ``w:u``."""
    if not 0 < place < len(tokens) - 1 or _ends_a_title(tokens, place):
        return False
    letters = tokens[place - 1].kind == tokens[place + 1].kind == "letter"
    if letters and place + 5 < len(tokens) + 1 and tokens[place + 2].kind == "relation":
        behind = [token.kind for token in tokens[place + 3 : place + 6]]
        if behind == ["number", ":", "number"]:
            return True  # m_A : m_B = 3 : 4
    if [token.kind for token in tokens[place - 1 : place + 2]] == ["number", ":", "number"]:
        return True
    if tokens[place].gap or tokens[place + 1].gap:
        return False
    if tokens[place - 1].kind == "number" and tokens[place + 1].name == "sqrt":
        return True
    kinds = {tokens[place - 1].kind, tokens[place + 1].kind}
    return kinds in ({"number"}, {"letter"})


def _ends_a_title(tokens: Sequence[Token], place: int) -> bool:
    """Whether a colon stands behind prose and before a relation: ``product is -1: 3/b = 2``."""
    apart = not tokens[place].gap and tokens[place + 1].gap > 0
    words = any(token.kind in ("word", "phrase") for token in tokens[:place])
    before = any(token.kind == "relation" for token in tokens[:place])
    behind = any(token.kind == "relation" for token in tokens[place:])
    case = before and tokens[place - 1].kind in ("number", "letter")  # a = u/5: 1 = 4 - 6e
    return apart and behind and (case or (words and not before))


def _is_factor(tokens: Sequence[Token], place: int, pending: Sequence[Token]) -> bool:
    """Whether a phrase behind an operand is multiplied by it: ``e approach``."""
    words = tokens[place].name.split()
    if not set(words) & HEADS.keys():
        return False
    behind = tokens[place + 1].kind if place + 1 < len(tokens) else ""
    if behind in _OPERANDS:
        return False
    if behind == "relation" and any(token.kind == "relation" for token in pending):
        return False
    return pending[-1].kind in ("letter", "number", "percent")


def _loose_brackets(tokens: Sequence[Token]) -> set[int]:
    """The brackets that hold words or a relation: a remark, not a group."""
    loose: set[int] = set()
    open_at: list[int] = []
    for place, token in enumerate(tokens):
        if token.kind == "(":
            open_at.append(place)
        elif token.kind == ")" and open_at:
            first = open_at.pop()
            inside = tokens[first + 1 : place]
            if any(token.kind in ("relation", "arrow") for token in inside) or (
                any(token.kind == "word" for token in inside)
            ):
                loose |= {first, place}
    return loose


# One of these alone tells which way a component is: off the wall, or towards it.
_WAYS_OUT = (("out",), ("into",), ("in",))


def _without_swallowed(segment: Segment) -> Segment:
    """A segment without what belongs to the prose before it: ``divide by m  2v + 3w = 6``."""
    tokens = segment.tokens
    begins = tokens[0].kind in ("/", "*") and len(tokens) > 2 and tokens[2].gap
    if begins and tokens[2].kind != "relation" and segment.has_relation:
        return replace(segment, tokens=tokens[2:])  # ÷ m  u = v + 2w
    if not segment.before or segment.before[-1] not in SWALLOWING or not segment.has_relation:
        return segment
    if segment.before in _WAYS_OUT:
        return segment  # out 3.06 tan 26 = 1.49
    end = 1
    while end < len(tokens) and tokens[end].gap == 0:
        end += 1
    if end < len(tokens) and tokens[end - 1].kind == "letter" and tokens[end].kind == "function":
        return segment  # from v cos x = u cos α
    if end >= len(tokens) or end > 4 or any(token.kind == "relation" for token in tokens[:end]):
        return segment
    begins = tokens[end].kind in _OPERANDS or tokens[end].kind == "|"
    return replace(segment, tokens=tokens[end:]) if begins else segment


Parting = Literal["certain", "likely", "doubtful"]


def split_at_spaces(
    segment: Segment, vectors: Collection[str] = ()
) -> Iterator[tuple[Segment, Parting]]:
    """A segment parted where several relations stand beside each other.

    ``q = 1/6   p = -1/3`` is two. So, likely, is ``w = 2u v = u``, in which the second may also be
    the end of a chain; ``tan b = 1/3 tan a = 1/4`` is rather a chain, and so is
    ``v = 7/10 n = 2i + j`` with the letter of one of the ``vectors``. The word beside a segment
    tells how certain it is that it is a relation of its own.
    """
    tokens = segment.tokens
    places = [n for n, token in enumerate(tokens) if token.kind == "relation"]
    start, parting = 0, _CERTAIN
    for first, second in pairwise(places):
        cut = _cut(tokens[start:], first - start, second - start, vectors)
        if cut is not None:
            place = start + cut[0]
            yield _without_number(Segment(tokens[start:place], segment.before)), parting
            start, parting = place, cut[1]
    yield Segment(tokens[start:], segment.before), parting


_CERTAIN: Parting = "certain"
# Letters of speeds and velocities.
_OF_VELOCITIES = frozenset("uvwUVW")


def _cut(
    tokens: Sequence[Token], first: int, second: int, vectors: Collection[str]
) -> tuple[int, Parting] | None:
    """Where a side between two relations is parted, and how certain that is."""
    depth, gaps = 0, []
    for place in range(first + 1, second):
        kind = tokens[place].kind
        if kind == ")":
            depth -= 1
        if depth == 0 and place > first + 1 and tokens[place].gap and _may_part(tokens, place):
            gaps.append(place)
        if kind == "(":
            depth += 1
    wide = [place for place in gaps if tokens[place].gap >= 2]
    if wide:
        return max(wide, key=lambda place: tokens[place].gap), "certain"
    for place in gaps:
        if _is_solved_for(tokens, first, place, second):
            return place, "certain"
        if _begins_another(tokens, first, place, second):
            if tokens[place].name in vectors and _is_velocity_along(tokens, first, place, second):
                return None
            return place, _parting(tokens, first, place, second)
    return None


def _is_velocity_along(tokens: Sequence[Token], first: int, place: int, second: int) -> bool:
    """Whether a velocity is a multiple of a direction: ``v = 7/10 n = 2i + j``."""
    start = max((n for n in range(first) if tokens[n].kind == "relation"), default=-1) + 1
    moving = tokens[start].kind == "phrase" or tokens[start].name[:1] in _OF_VELOCITIES
    return moving and second == place + 1 and tokens[place].name[:1] not in _OF_VELOCITIES


def _parting(tokens: Sequence[Token], first: int, place: int, second: int) -> Parting:
    """How certain it is that a relation begins at a place."""
    right = tokens[place:second]
    if right[0].name in ("sin", "cos") and first + 2 == place:
        value = tokens[second + 1 : second + 2]
        if value and value[0].kind == "number" and value[0].value > 1:
            return "doubtful"  # along = 13 sin α = 12: no sine is 12
    if right[0].kind == "function":
        start = max((n for n in range(first) if tokens[n].kind == "relation"), default=-1) + 1
        same = {token.name for token in tokens[start:first] if token.kind == "letter"} == {
            token.name for token in right if token.kind == "letter"
        }
        both = tokens[start].kind == "function"
        return "doubtful" if both and not same else "likely"
    letter = any(token.kind == "letter" for token in tokens[first + 1 : place])
    return "likely" if letter else "certain"


def _begins_another(tokens: Sequence[Token], first: int, place: int, second: int) -> bool:
    """Whether a relation for something new begins at a place.

    It does in ``a = 3 × 2 = 6 b = 2``. None does in ``speed = √7/4 u = 7u/16``, nor in
    ``h = u/4 cos(t) - u/2 sin(t) = u (cos(t) - 2sin(t))/4``, whose angle goes on in the next side.
    """
    start = max((n for n in range(first) if tokens[n].kind == "relation"), default=-1) + 1
    right = tokens[place:second]
    if start and _are_numbers(tokens[start:first]) and _are_numbers(tokens[first + 1 : place]):
        start, first = 0, next(n for n in range(first) if tokens[n].kind == "relation")
    if not (_is_simple(right) and _is_simple(tokens[start:first])):
        return False
    if _ends_a_formula(tokens, first, place, second):
        return False
    own = {token.name for token in right if token.kind == "letter"}
    other = {token.name for token in tokens[start:place] if token.kind == "letter"}
    behind = {token.name for token in tokens[second:] if token.kind == "letter"}
    if right[0].kind == "function":
        return not own & behind and not (tokens[place - 1].kind == "letter" and other & behind)
    return tokens[start].kind == "function" or not own & (other | behind)


def _ends_a_formula(tokens: Sequence[Token], first: int, place: int, second: int) -> bool:
    """Whether a letter is the last factor of a formula with its value: ``J = μ(1 + e) w = 14``."""
    stop = next((n for n in range(second + 1, len(tokens)) if tokens[n].kind == "relation"), None)
    formula, value = tokens[first + 1 : place], tokens[second + 1 : stop]
    in_letters = any(token.kind == "letter" for token in formula)
    return in_letters and tokens[place - 1].kind == ")" and _are_numbers(value)


def _is_solved_for(tokens: Sequence[Token], first: int, place: int, second: int) -> bool:
    """Whether a relation for a letter begins behind one for a multiple, or the square, of it.

    It does in ``5a = -7.5 a = -1.5``: as a chain, 5a would be -7.5a.
    """
    start = max((n for n in range(first) if tokens[n].kind == "relation"), default=-1) + 1
    if second != place + 1 or tokens[place].kind != "letter":
        return False
    own = tokens[place].name
    stop = next((n for n in range(second + 1, len(tokens)) if tokens[n].kind == "relation"), None)
    value, behind = tokens[first + 1 : place], tokens[second + 1 : stop]
    left = tokens[start:first]
    if _is_contradicted(left, value, behind, own):
        return True
    given = {token.name for token in value if token.kind == "letter"}
    plain = given <= {token.name for token in behind if token.kind == "letter"} - {own}
    elsewhere = any(token.kind == "letter" and token.name == own for token in behind)
    kinds = [token.kind for token in left if token.kind != "-"]
    multiple = kinds in (["number", "letter"], ["letter", "^", "number"])
    return multiple and plain and not elsewhere and any(token.name == own for token in left)


def _is_contradicted(
    left: Sequence[Token], value: Sequence[Token], behind: Sequence[Token], own: str
) -> bool:
    """Whether a chain would say of a number that it is another: ``14 = 5a + 4 a = 2``."""
    end = next((n for n, token in enumerate(behind) if n and token.gap), len(behind))
    sides = (left, behind[:end])
    numbers = [side[0].value for side in sides if [x.kind for x in side] == ["number"]]
    return len(numbers) == 2 and numbers[0] != numbers[1] and any(x.name == own for x in value)


def _may_part(tokens: Sequence[Token], place: int) -> bool:
    before, token = tokens[place - 1], tokens[place]
    return before.kind in (*_CLOSING, "measure", "degrees") and (
        token.kind in _OPERANDS or token.kind == "|" or (token.kind == "-" and token.gap >= 2)
    )


def _are_numbers(tokens: Sequence[Token]) -> bool:
    """Whether a side is worked out from numbers alone."""
    return all(token.kind in _OF_NUMBERS for token in tokens)


def _is_simple(tokens: Sequence[Token]) -> bool:
    """Whether a side is a letter, or a sine, cosine or tangent of one: something to be found."""
    kinds = [token.kind for token in tokens if token.kind not in ("(", ")")]
    if kinds == ["letter"] or kinds == ["phrase"]:
        return True
    angles: tuple[list[str], ...] = ([], ["letter"], ["^", "number", "letter"])
    return kinds[:1] == ["function"] and kinds[1:] in angles
