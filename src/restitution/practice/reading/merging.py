"""Words that name a quantity, and what goes with them, made one token each."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from restitution.practice.reading.phrase_names import names_quantity
from restitution.practice.reading.tokens import Token
from restitution.practice.reading.vocabulary import (
    DIRECTIONS,
    EQUALS,
    EVENT_WORDS,
    HEADS,
    ORDINALS,
    PHRASE_WORDS,
    STAGES,
)
from restitution.problem import Problem

_TRAILING = frozenset(
    ("of", "the", "in", "to", "from", "for", "on", "with", "its", "by", "between", "at", "and")
    + ("just", "immediately", "which", "it", "that", "their", "moves", "moving", "into", "makes")
    + ("made", "s", "given", "line", "through", "sum", "one", "two", "three", "side", "both")
)
_BEFORE_AXIS = frozenset(
    ("along", "of", "to", "in", "direction", "parallel", "perpendicular", "perp", "the", "with")
    + ("from", "and", "-", "positive", "negative", "between")
)
_BEHIND_AXIS = frozenset(
    ("component", "components", "comp", "comps", "direction", "dir", "dirn", "axis", "cpt")
    + ("distance", "velocity", "vel", "speed", "momentum")
)
_MOVING = frozenset(("velocity", "vel", "speed", "momentum"))
_STARTS = frozenset(
    ("total", "overall", "combined", "resultant", "relative", "rel", "horizontal", "vertical")
    + ("line", "reduced")
)
# Words behind ``v after`` that say after what.
_OF_ONE_EVENT = ORDINALS.keys() | {"wall", "cushion", "barrier"}
_OF_AN_EVENT = EVENT_WORDS | _OF_ONE_EVENT | {"the"}
_WAYS = frozenset(("parallel", "along", "perpendicular", "perp", "in"))
_NEAR_A_NAME = frozenset(
    ("after", "before", "at", "for", "to", "from", "with", "of", "by", "hits", "wall", "sphere")
    + ("ball", "particle", "strikes", "point", "on", "and", "between", "about", "spheres", "then")
    + ("towards", "so", "since", "hence", "that", "means", "as", "because")
)
_ENERGIES = frozenset(word for word, head in HEADS.items() if head in ("loss", "gain", "energy"))
# What may be along a vector that is written out, and the words before one.
_ALONG = frozenset(("component", "velocity", "speed", "momentum"))
_BEFORE_VECTOR = frozenset(("along", "to", "of", "direction"))
# The words around a time.
_BEFORE_TIME = frozenset(("after", "at", "in", "time", "apart"))
_SECONDS = frozenset(("s", "sec", "secs", "second", "seconds"))
_LATER = frozenset(("later", "after", "afterwards"))
_KINDS = {"(": "(", ")": ")", "-": "-", "+": "+", "number": "n", "unit": "i"}
_OF = frozenset(
    ("of", "on", "in", "for", "to", "from", "by", "with", "at", "hits", "after", "before")
)
_OF_COMPONENTS = frozenset(("perpendicular", "parallel", "horizontal", "vertical"))
_OF_CASES = frozenset(("at", "when", "where", "if", "for"))
_PLURALS = frozenset(f"the {word}" for word in HEADS if word.endswith("s") and word != "loss")
_OPERANDS = frozenset(("number", "letter", "name", "unit", "pi", "phrase", "function", "("))
_CLOSING = frozenset(("number", "letter", "name", "unit", "pi", ")", "phrase", "percent"))


def with_phrases(tokens: Sequence[Token], text: str, problem: Problem) -> list[Token]:
    """The tokens, with the words that name a quantity made one token each."""
    merged: list[Token] = []
    place = 0
    tokens = [
        _as_body(tokens, n, problem)
        for n in range(len(tokens))
        if not (_is_kind_of_body(tokens, n) or _is_copula(tokens, n))
    ]
    while place < len(tokens):
        if _is_aside(tokens, place):
            place = tokens_behind(tokens, place)
            continue
        joined = (
            _size(tokens, place)
            or _owned(tokens, place)
            or _moved(tokens, place)
            or _staged(tokens, place, text)
            or _directed(tokens, place)
            or _deflected(tokens, place)
        )
        energy = _quotient_of_energies(tokens, place)
        if energy is not None:
            joined = energy, place + 1
        if joined is not None:
            merged.append(joined[0])
            place = joined[1]
            continue
        end = _phrase_end(tokens, place, problem)
        if end > place:
            first = place
            if len(merged) > 1 and merged[-1].word in ("has", "had") and merged[-2].kind == "name":
                merged.pop()
                first -= 1
            if merged and _is_owner(merged, tokens[place]):
                merged.pop()
                first -= 1
            end = _with_letter(tokens, end)
            merged.append(_phrase(tokens[first:end], text))
            place = _behind_time(tokens, place, end)
            continue
        token = tokens[place]
        merged.append(_prose_name(merged, token, tokens[place + 1 : place + 2]))
        place += 1
    merged = [token for n, token in enumerate(merged) if not _is_article(merged, n)]
    return _with_order([_equality(merged, place) for place in range(len(merged))])


def tokens_behind(tokens: Sequence[Token], place: int) -> int:
    """The place behind the bracket that closes the one at a place."""
    depth = 0
    for end in range(place, len(tokens)):
        depth += {"(": 1, ")": -1}.get(tokens[end].kind, 0)
        if not depth:
            return end + 1
    return len(tokens)


def _is_aside(tokens: Sequence[Token], place: int) -> bool:
    """Whether brackets hold words and state nothing: ``v (speed of A) = 3``."""
    if tokens[place].kind != "(" or not place or not tokens[place].gap:
        return False
    inside = tokens[place + 1 : tokens_behind(tokens, place) - 1]
    signs = any(token.kind in ("relation", "arrow") for token in inside)
    return not signs and any(token.kind == "word" for token in inside)


def _behind_time(tokens: Sequence[Token], place: int, end: int) -> int:
    """The place behind the time at which a distance is told: ``distance after 3 secs = 2.12``.

    That of the phrase's own end where no time, with a value behind it, stands there.
    """
    if "distance" not in {HEADS.get(token.word) for token in tokens[place:end]}:
        return end
    behind = end
    while behind < len(tokens) and tokens[behind].word in _BEFORE_TIME:
        behind += 1
    lettered = [token.name for token in tokens[behind : behind + 2]] == ["t", "="]
    behind += 2 if lettered else 0
    if behind >= len(tokens) or tokens[behind].kind != "number":
        return end
    behind += 1
    seconds = behind < len(tokens) and tokens[behind].word in _SECONDS
    behind += 1 if seconds else 0
    while seconds and behind < len(tokens) and tokens[behind].word in _LATER:
        behind += 1
    stops = behind < len(tokens) and tokens[behind].kind in ("relation", ":")
    return behind if stops and (seconds or lettered) else end


def _with_letter(tokens: Sequence[Token], end: int) -> int:
    """Where a phrase ends that goes on with a letter: ``x component of v = 3``.

    The letter of a direction says along what it is: ``approach along n = 3``.
    """
    kinds = [token.kind for token in tokens[end : end + 3]]
    if kinds == ["word", "letter", "relation"] and tokens[end].word == "of":
        return end + 2
    words = [token.word for token in tokens[end - 1 : end + 1]]
    behind = end + (1 if words[1:] == ["to"] else 0)
    kinds = [token.kind for token in tokens[behind : behind + 2]]
    if kinds == ["letter", "relation"] and words[0] in _WAYS - {"in"}:
        return behind + 1 if tokens[behind].name == "n" else end
    return end


def _deflected(tokens: Sequence[Token], place: int) -> tuple[Token, int] | None:
    """``A is deflected by`` as the name of the angle."""
    words = [token.word for token in tokens[place + 1 : place + 4]]
    if tokens[place].kind != "name" or len(words) < 2 or words[0] not in ("is", "was"):
        return None
    if HEADS.get(words[1]) != "deflection":
        return None
    name = f"deflection of {tokens[place].name}"
    end = place + (4 if words[2:] in (["by"], ["through"]) else 3)
    last = tokens[end - 1]
    return replace(tokens[place], kind="phrase", name=name, end=last.end), end


def _quotient_of_energies(tokens: Sequence[Token], place: int) -> Token | None:
    """The ``initial`` of ``loss/initial``: the energy before."""
    if place < 2 or tokens[place].kind != "word" or tokens[place - 1].kind != "/":
        return None
    if place + 1 < len(tokens) and tokens[place + 1].word in HEADS:
        return None  # energy lost/initial energy
    above = set(tokens[place - 2].word.split())
    if STAGES.get(tokens[place].word) != "before" or not above & _ENERGIES:
        return None
    return replace(tokens[place], kind="phrase", name=f"{tokens[place].word} ke")


def _with_order(tokens: list[Token]) -> list[Token]:
    """The tokens of a line that has ``e => 1/3`` for its only sign, which then is no arrow."""
    arrows = [n for n, token in enumerate(tokens) if token.kind == "arrow"]
    if any(token.kind == "relation" for token in tokens) or len(arrows) != 1:
        return tokens
    place = arrows[0]
    if tokens[place].text != "=>" or not 0 < place < len(tokens) - 1:
        return tokens
    if tokens[place - 1].kind != "letter":
        return tokens
    tokens[place] = replace(tokens[place], kind="relation", name=">=")
    return tokens


def _is_kind_of_body(tokens: Sequence[Token], place: int) -> bool:
    """Whether a word only says what a named body is: ``sphere A``."""
    behind = tokens[place + 1].kind if place + 1 < len(tokens) else ""
    return behind == "name" and tokens[place].word in ("sphere", "ball", "particle", "disc")


def _as_body(tokens: Sequence[Token], place: int, problem: Problem) -> Token:
    """A token; the v_B of ``angle vB makes with i`` as the name of its body."""
    token = tokens[place]
    base, _, body = token.name.partition("_")
    moving = token.kind == "letter" and base in ("v", "V")
    if not moving or body not in {sphere.name for sphere in problem.spheres}:
        return token
    before = [token.word for token in tokens[max(0, place - 2) : place]]
    behind = tokens[place + 1].word if place + 1 < len(tokens) else ""
    if "angle" in {HEADS.get(word) for word in before} and behind in ("makes", "with", "to"):
        return replace(token, kind="name", name=body, text=body)
    if _is_end_of_angle(tokens, place):
        return replace(token, kind="name", name=body, text=body)
    return token


def _is_end_of_angle(tokens: Sequence[Token], place: int) -> bool:
    """Whether an angle is measured to or from a token: ``angle between v_A and i``."""
    words = [token.word for token in tokens[:place]]
    if "between" not in words:
        return False
    start = len(words) - 1 - words[::-1].index("between")
    behind = tokens[place + 1].word if place + 1 < len(tokens) else ""
    first = start + 1 == place and behind == "and"
    last = words[-1] == "and" and "and" not in words[start + 1 : -1]
    return (first or last) and "angle" in {HEADS.get(word) for word in words[:start]}


def _is_copula(tokens: Sequence[Token], place: int) -> bool:
    """Whether a word only joins the line of centres to its way: ``is parallel to 3i + 4j``."""
    if tokens[place].word not in ("is", "lies", "points", "acts") or not place:
        return False
    behind = tokens[place + 1].word if place + 1 < len(tokens) else ""
    return tokens[place - 1].word in ("centres", "centers", "loc") and behind in _WAYS


def _size(tokens: Sequence[Token], place: int) -> tuple[Token, int] | None:
    """``magnitude of I`` as a function of what stands behind it."""
    if tokens[place].kind != "word" or HEADS.get(tokens[place].word) != "magnitude":
        return None
    behind = place + 1
    while behind < len(tokens) and tokens[behind].word in ("of", "the"):
        behind += 1
    if behind >= len(tokens) or tokens[behind].kind not in ("letter", "(", "number", "-"):
        return None
    if tokens[behind].kind == "number" and behind == place + 1:
        return None  # mag 4√2
    return replace(tokens[place], kind="function", name="abs"), behind


def _owned(tokens: Sequence[Token], place: int) -> tuple[Token, int] | None:
    """``I on B`` and ``v of A`` as a letter with a subscript."""
    if place + 2 >= len(tokens):
        return None
    letter, word, name = tokens[place : place + 3]
    if letter.kind != "letter" or name.kind != "name" or word.word not in ("on", "of", "for"):
        return None
    if "_" in letter.name or len(letter.name) > 1:
        return None
    if word.word == "for" and place and tokens[place - 1].kind == "number" and not letter.gap:
        return None  # 1.2u for A and 0.8u for B
    return replace(letter, name=f"{letter.name}_{name.name}", end=name.end), place + 3


def _moved(tokens: Sequence[Token], place: int) -> tuple[Token, int] | None:
    """``final v = 2i + j`` as the velocity after: v may be that before as well."""
    kinds = [token.kind for token in tokens[place : place + 3]]
    if kinds != ["word", "letter", "relation"] or tokens[place].word not in STAGES:
        return None
    base, _, owner = tokens[place + 1].name.partition("_")
    vector = any(token.kind == "unit" for token in tokens[place + 3 :])
    if base not in ("u", "v", "w", "V") or not vector or owner.isdigit():
        return None
    name = " ".join(["velocity", *(["of", owner] if owner else []), tokens[place].word])
    end = tokens[place + 1].end
    return replace(tokens[place], kind="phrase", name=name, end=end), place + 2


def _staged(tokens: Sequence[Token], place: int, text: str) -> tuple[Token, int] | None:
    """``v before`` and ``v after`` as phrases, where a line has the same letter at both."""
    if not _has_stage(tokens, place):
        return None
    name = tokens[place].name
    end = place + 2
    while end < len(tokens) and tokens[end].word in _OF_AN_EVENT:
        end += 1
    of_one_event = not _OF_ONE_EVENT.isdisjoint(token.word for token in tokens[place + 2 : end])
    of_one_event = of_one_event and end < len(tokens) and tokens[end].kind in ("relation", ":")
    if of_one_event and name in ("u", "v", "w", "V"):
        phrase = _phrase(tokens[place:end], text)
        return replace(phrase, name=f"velocity {phrase.name.partition(' ')[2]}"), end
    stages = {
        STAGES[tokens[n + 1].word]
        for n in range(len(tokens) - 1)
        if _has_stage(tokens, n) and tokens[n].name == name
    }
    if len(stages) < 2:
        return None
    return _phrase(tokens[place : place + 2], text), place + 2


def _directed(tokens: Sequence[Token], place: int) -> tuple[Token, int] | None:
    """``v perp`` and ``uA along loc`` as the component of a velocity, after and before."""
    letter = tokens[place]
    base, _, owner = letter.name.partition("_")
    if letter.kind != "letter" or base not in ("u", "v", "U", "V") or owner[:1].islower():
        return None
    end = place + 1
    while end < len(tokens) and tokens[end].kind == "word" and _is_of_a_way(tokens[end].word):
        end += 1
    words = [token.word for token in tokens[place + 1 : end]]
    allowed = _OF_COMPONENTS | ({"along"} if owner else set())
    if (
        owner.isdigit()
        or not words
        or DIRECTIONS.get(words[0]) not in allowed
        or end == len(tokens)
    ):
        return None
    if (tokens[end].kind, tokens[end].name) not in (("relation", "="), (":", ":")):
        return None
    when = ["before"] if base in "uU" else []
    name = " ".join(["velocity", *(["of", owner] if owner else []), *words, *when])
    return replace(letter, kind="phrase", name=name, end=tokens[end - 1].end), end


def _is_of_a_way(word: str) -> bool:
    return word in DIRECTIONS or word in ("to", "the", "line", "of", "wall")


def _has_stage(tokens: Sequence[Token], place: int) -> bool:
    if place + 1 >= len(tokens) or tokens[place].kind != "letter":
        return False
    return tokens[place + 1].kind == "word" and tokens[place + 1].word in STAGES


def _is_owner(merged: Sequence[Token], token: Token) -> bool:
    """Whether the last token is the name of a body before its quantity: ``B perp``, ``A's KE``."""
    if merged[-1].kind != "name" or not token.gap:
        return False
    return len(merged) == 1 or merged[-2].kind in (",", ";", ":", "arrow", "stop")


def _is_article(tokens: Sequence[Token], place: int) -> bool:
    """Whether a word is the article before a phrase: ``v is the speed of A``."""
    behind = tokens[place + 1].kind if place + 1 < len(tokens) else ""
    articles = ("the", "a", "an", "its", "their", "that")
    if tokens[place].word == "of" and place and tokens[place - 1].kind == "function":
        return True
    return tokens[place].word in articles and behind == "phrase"


def _phrase(tokens: Sequence[Token], text: str) -> Token:
    """A phrase as a token: its words in small letters, but for names, as its name."""
    words = [token.text if token.kind in ("name", "unit") else token.word for token in tokens]
    joined = re.sub(r"(?<=\d) (?=[ij]\b)", "", " ".join(words).replace(" - c", " c"))
    joined = re.sub(r"(?<![ij] )- ([ij])\b", r"-\1", joined)
    first, last = tokens[0], tokens[-1]
    name = joined if " " in joined else f"the {joined}"
    return replace(first, kind="phrase", text=text[first.start : last.end], end=last.end, name=name)


def _phrase_end(tokens: Sequence[Token], place: int, problem: Problem) -> int:
    """Where a phrase that begins at a place ends; the place itself where none does."""
    if not _begins_phrase(tokens, place):
        return place
    end = place
    while end < len(tokens) and end - place < 16 and _goes_on(tokens, place, end):
        end += 1
    if (behind := _vector_end(tokens, place, end)) is not None:
        return behind
    while end > place and _is_trailing(tokens, end - 1):
        end -= 1
    stretch = tokens[place:end]
    if not any(token.kind == "word" for token in stretch):
        return place
    if _is_sum_of_energy(tokens, place):
        return place + 1
    words = [token.text if token.kind == "name" else token.word for token in stretch]
    if end > place and names_quantity(words, problem):
        return end
    return place


def _vector_end(tokens: Sequence[Token], place: int, end: int) -> int | None:
    """Where a phrase ends that goes on with a vector along which it is: ``comp of A along 2i + j``.

    A moment may stand behind it, and a value has to.
    """
    stretch = tokens[max(0, place - 1) : end]
    owned = any(token.kind == "name" or HEADS.get(token.word) in _ALONG for token in stretch)
    if not owned or end == place or tokens[end - 1].word not in _BEFORE_VECTOR:
        return None
    kinds = "".join(_KINDS.get(token.kind, "?") for token in tokens[end : end + 9])
    match = re.match(r"\(-?n?i[+-]n?i\)|-?n?i[+-]n?i", kinds)
    if match is None:
        return None
    behind = end + match.end()
    while behind < len(tokens) and tokens[behind].word in STAGES:
        behind += 1
    stops = behind < len(tokens) and tokens[behind].kind in ("relation", ":")
    spoken = behind < len(tokens) and tokens[behind].word in EQUALS
    return behind if stops or spoken else None


def _begins_phrase(tokens: Sequence[Token], place: int) -> bool:
    token = tokens[place]
    if token.kind in ("unit", "letter", "times"):
        return token.text in ("i", "j", "x", "y", "X", "Y") and _has_axis_behind(tokens, place)
    if token.kind != "word":
        return False
    low = token.word
    if low in ("change", "gain"):
        return _is_sum_of_energy(tokens, place) or (
            place + 1 < len(tokens) and tokens[place + 1].word in ("in", "of")
        )
    known = low in HEADS or low in DIRECTIONS or low in STAGES or low in _STARTS
    return known and low not in ("right", "left", "up", "down", "turned", "end", "normal")


def _is_sum_of_energy(tokens: Sequence[Token], place: int) -> bool:
    """Whether ``gain`` stands alone before its value: ``gain = 22.5``."""
    behind = tokens[place + 1] if place + 1 < len(tokens) else None
    return tokens[place].word == "gain" and behind is not None and behind.kind == "relation"


def _has_axis_behind(tokens: Sequence[Token], place: int) -> bool:
    """Whether an axis has its quantity behind it: ``y velocity``; ``mass x velocity`` has not."""
    before = tokens[place - 1] if place else None
    multiplied = before is not None and (before.kind in _CLOSING or before.word in HEADS)
    if multiplied and tokens[place].kind != "unit":
        return False
    behind = place + 1
    apart = behind < len(tokens) and tokens[behind].kind == "-" and tokens[behind].gap > 0
    if behind < len(tokens) and tokens[behind].kind == "-":
        behind += 1
    known = _BEHIND_AXIS - _MOVING if apart else _BEHIND_AXIS  # x - velocity of B = 3
    return behind < len(tokens) and tokens[behind].word in known


def _goes_on(tokens: Sequence[Token], place: int, end: int) -> bool:
    """Whether the token at an end still belongs to the phrase that began at a place."""
    token = tokens[end]
    before = tokens[end - 1].word if end > place else ""
    if token.kind == "word":
        low = token.word
        if low == "com" and before in ("of", "the"):
            return True
        if low == "at" and _is_angle_behind(tokens, end):
            return False  # the velocity after, at angle θ: the angle is another quantity
        if low in PHRASE_WORDS or re.fullmatch(r"\d(?:st|nd|rd|th)", low):
            return True
        return low == "a" or (low.isalpha() and token.text.isupper() and len(low) <= 3)
    if token.kind == "name":
        behind = tokens[end + 1] if end + 1 < len(tokens) else None
        between = any(token.word == "between" for token in tokens[place:end])
        named = any(token.kind == "name" for token in tokens[place:end])
        if before == "and" and not (named or between) and behind and behind.kind == "number":
            return False  # in the opposite direction and B 5 m/s
        return between or before != "and" or behind is None or behind.kind not in ("relation", "+")
    if token.kind in ("unit", "letter", "times") and token.text in ("i", "j", "x", "y"):
        return end == place or before in _BEFORE_AXIS or _has_axis_behind(tokens, end)
    if token.kind == "-":
        behind = tokens[end + 1] if end + 1 < len(tokens) else None
        if behind is None:
            return False
        if behind.word in _BEHIND_AXIS and before in ("i", "j", "x", "y"):
            return not (token.gap and behind.word in _MOVING)
        return behind.kind == "unit" and before in _BEFORE_AXIS and behind.gap == 0
    return False


def _is_angle_behind(tokens: Sequence[Token], place: int) -> bool:
    """Whether ``at`` is followed by an angle: ``at an angle θ``, ``at angle θ``."""
    behind = [token.word for token in tokens[place + 1 : place + 3]]
    if behind and behind[0] in ("a", "an", "the"):
        behind = behind[1:]
    return bool(behind) and HEADS.get(behind[0]) == "angle"


def _is_trailing(tokens: Sequence[Token], place: int) -> bool:
    token = tokens[place]
    if token.word == "between" and place and HEADS.get(tokens[place - 1].word) == "angle":
        return False  # angle between = 60
    return token.kind == "-" or (token.kind == "word" and token.word in _TRAILING)


def _prose_name(merged: Sequence[Token], token: Token, behind: Sequence[Token]) -> Token:
    """A name behind a word of prose is one itself: ``after AB``, ``so B moves``."""
    if token.kind != "name" or not merged or merged[-1].kind != "word":
        return token
    if behind and behind[0].kind in ("relation", "+", "-", "*", "/", "^", ":"):
        owner = merged[-1].text in _OF and behind[0].kind == "relation"
        return replace(token, kind="word") if owner else token
    return replace(token, kind="word") if merged[-1].text in _NEAR_A_NAME else token


def _is_vector_behind(tokens: Sequence[Token], place: int) -> bool:
    """Whether a vector by its components begins behind a place: ``A is 3i + j``."""
    behind = [token.kind for token in tokens[place + 1 : place + 4]]
    behind = behind[1:] if behind[:1] == ["-"] else behind
    factor = behind[:1] in (["number"], ["letter"])
    return "unit" in behind[:1] or (factor and behind[1:2] == ["unit"])


def _equality(tokens: Sequence[Token], place: int) -> Token:
    """``is`` between two values is a sign of equality, ``of`` behind a number a product."""
    token = tokens[place]
    if token.kind != "word" or not 0 < place < len(tokens) - 1:
        return token
    before, behind = tokens[place - 1], tokens[place + 1]
    opens = behind.kind in _OPERANDS or behind.kind in ("-", "|")
    if behind.kind == "phrase" and not set(behind.name.split()) & HEADS.keys():
        return token
    if behind.name in ("the lost", "the gained", "the turned", "the deflected"):
        return token  # energy is lost
    if token.text == "equal" and behind.kind == "phrase" and behind.name in _PLURALS:
        return token  # e = 1, equal masses
    case = [token.kind for token in tokens[max(0, place - 3) : place]]
    if case == ["letter", "relation", "number"] and tokens[place - 4].word in _OF_CASES:
        return token  # least at e = 0 is u sin α
    if token.text in EQUALS and before.kind in _CLOSING and opens:
        if before.kind == "name" and not _is_vector_behind(tokens, place):
            return token  # A is 3 m from B
        return replace(token, kind="relation", name="=")
    if token.text == "of" and before.kind in ("number", "percent", ")") and opens:
        return replace(token, kind="times")
    return token
