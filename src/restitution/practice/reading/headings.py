"""Headings of a working: parts of the question, and the scopes that lines below speak of."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

from restitution.practice.reading.features import features_of, words_of
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.vocabulary import EVENT_WORDS, ORDINALS, STAGES
from restitution.practice.script import Scope
from restitution.problem import Impact, Kick, Problem

_PART = re.compile(
    r"\s*(?:part\s+\(?(\w{1,3})\)?|q(?:uestion)?\s*\d*\s*[.)]?\s*\(?([a-z]{1,3})\)"
    r"|(?:\d{1,2}\s*[.)]?\s*(?=\([a-z]{1,3}\)\s*(?:[^\s=<>+*/^-]|$)))?\(([a-zA-Z]{1,3})\)"
    r"|([a-zA-Z]{1,3})[).](?=\s|$))\s*(?:\((\w{1,3})\))?\s*[:.)-]?",
    re.IGNORECASE,
)
_NUMBERED = re.compile(
    r"\s*(?:\(\d{1,2}\)|\[\d{1,2}\]|\(\*+\)|\d{1,2}[.)](?=\s+\S)|[•▪●◦*·>]\s+|[①-⑳])\s*"
)
_CASE = re.compile(
    r"\s*(?:case\s*(\d|[ivx]+|[a-d])\b|either\b|or\b(?!\s*$))\s*[:.)]?",
    re.IGNORECASE,
)
_CROSSED = re.compile(r"\s*(?:~~(.*?)~~\s*|x:\s*(.*)|<s>(.*?)</s>\s*)$", re.IGNORECASE)
_COMBINED = re.compile(
    r"\s*(?:\d\s*[x×*]?\s*)?[(\[]\d[)\]](?:\s*[x×*/÷]\s*\d)?"
    r"(?:\s*[+\-−–/]\s*(?:\d\s*[x×*]?\s*)?[(\[]\d[)\]](?:\s*[x×*]\s*\d)?)*"
    r"\s*(?::|=>|→|gives|(?=\s[\dA-Za-z(]))"
)
# What is done to equations, and the direction of one: (+), (÷m), (∥), (perpendicular to W).
_ASIDE = re.compile(
    r"\s*[(\[]\s*(?:[+\-−–]|[×*÷/]\s*\w{0,3}|∥|//|\|\||[⟂⊥]r?"
    r"|(?:parallel|perp|along|across|normal|tangential|horizontal|vertical)\b[^()\[\]=<>]*|perpendicular"
    r"[^()\[\]=<>]*)\s*[)\]]\s*:?\s*(?=[^\s=<>+*/^])",
    re.IGNORECASE,
)
# The same with a colon: ``×20: 4 + 16e² = 5``.
_DONE = re.compile(
    r"\s*(?:(?:[*÷/]|(?:both\s+sides\s+)?(?:times|divided\s+by))\s*\(?[\w²^√./]{1,8}\)?|x\s?\d{1,3})"
    r"\s*(?::|=+>|gives)\s*(?=[^\s=<>+*/^])"
)
_BEHIND = re.compile(
    r"(?:[\s.…_-]+|\s)(?:[(\[]\s*(?:(?:eqn?\s*)?(?:\d|[ivx]+|\*+|[A-E])|[×*÷/]\s*\w{1,3}|x\s?\d{2,3})"
    r"\s*[)\]]|[①-⑳])\s*$"
)


def part_of(text: str, problem: Problem) -> tuple[str | None, int]:
    """The part of the question that a line opens, and where the rest of the line begins."""
    labels = {part.label.lower(): part.label for part in problem.parts if part.label}
    alone = text.strip().lower()
    if alone in labels:
        return labels[alone], len(text)
    match = _PART.match(text)
    if not match or not labels:
        return None, 0
    label = next(group for group in match.groups()[:4] if group).lower()
    further = (match[5] or "").lower()
    if further and label + further in labels:
        return labels[label + further], match.end()
    if label in labels:
        return labels[label], match.start(5) - 1 if further else match.end()
    return None, 0


def crossed(text: str) -> str | None:
    """The text of a line that is crossed out, or None."""
    match = _CROSSED.match(text)
    return next((group for group in match.groups() if group is not None), "") if match else None


def without_number(text: str) -> int:
    """Where a line begins behind the number, the bullet, ``(1)+(2):`` or ``(÷m)`` before it."""
    offset = 0
    match = _COMBINED.match(text) or _ASIDE.match(text) or _DONE.match(text)
    if match and re.search(r"[=<>]", text[match.end() :]):
        offset = match.end()
    else:
        match = _NUMBERED.match(text)
        behind = text[match.end() :] if match else ""
        signed = behind != text and re.match(r"-\S", behind) and text[: -len(behind)].endswith(" ")
        if match and (signed or not re.match(r"\s*[=+*/^(\d-]", behind)):
            offset = match.end()
    return offset


def number_behind(text: str) -> int:
    """Where a line ends before the number of an equation, or what is done to it: ``[×10]``."""
    match = _BEHIND.search(text)
    if match and re.search(r"[=<>≤≥]", text[: match.start()]) and text[: match.start()].strip():
        return match.start()
    return len(text)


def case_of(text: str) -> int:
    """Where a line begins behind a word that opens a case; 0 where none does."""
    match = _CASE.match(text)
    return match.end() if match else 0


def scope_of(words: str, problem: Problem, current: Scope) -> Scope | None:
    """The scope that the words of a heading open, or None where they are no heading."""
    listed = words_of(words)
    low = [word.lower() for word in listed]
    features = features_of(listed, problem)
    if features.heads - {"direction"} or len(listed) > 9:
        return None
    spheres = {sphere.name for sphere in problem.spheres}
    event = _event_of(listed, problem, current, features.event)
    bodies = [name for name in features.names if name in spheres]
    stage = _stage(low)
    body = bodies[0] if len(bodies) == 1 and (event is None or "wall" in low) else None
    if event is None and body is None and stage is None:
        return None
    if event is not None:
        return Scope(event=event, body=body, stage=stage)
    return replace(current, body=body, stage=stage or current.stage)


def _stage(words: Sequence[str]) -> Literal["before", "after"] | None:
    stages = {STAGES[word] for word in words if word in STAGES}
    return "before" if "before" in stages else "after" if stages else None


def _event_of(
    words: Sequence[str], problem: Problem, current: Scope, counted: int | None
) -> int | None:
    """The event that a heading names: by its number, by the two that meet, or by its wall."""
    events = problem.events
    impacts = [n for n, event in enumerate(events, 1) if isinstance(event, Impact)]
    walls = {wall.name for wall in problem.walls}
    low = [word.lower() for word in words]
    spoken = any(word in EVENT_WORDS for word in low)
    if counted is None and (spoken or "wall" in low or any(word in STAGES for word in low)):
        counted = next((ORDINALS[word] for word in low if word in ORDINALS), None)
        digits = [int(word) for word in low if word.isdigit()]
        counted = counted or (digits[0] if digits else None)
    kicks = [n for n, event in enumerate(events, 1) if isinstance(event, Kick)]
    if kicks and counted is None and _BLOWS & set(low):
        return _next(kicks, current)
    if counted is not None:
        if "wall" in low or "walls" in low:
            struck = [n for n in impacts if _met(events[n - 1]) & walls]
            return struck[counted - 1] if counted <= len(struck) else None
        return impacts[counted - 1] if 0 < counted <= len(impacts) else None
    features = features_of(words, problem)
    named = set(features.names) | ({features.target} if features.target else set())
    pair = [n for n in impacts if len(named) == 2 and _met(events[n - 1]) == named]
    wall = [n for n in impacts if _met(events[n - 1]) & walls & named]
    if not wall and ("wall" in low or "cushion" in low) and not named & walls:
        wall = [n for n in impacts if _met(events[n - 1]) & walls]
        wall = wall if len({frozenset(_met(events[n - 1])) for n in wall}) == 1 else []
    if not pair and not wall and spoken and len(impacts) == 1 and len(words) <= 3:
        return impacts[0]
    return _next(pair or wall, current)


def _next(numbers: Sequence[int], current: Scope) -> int | None:
    """The first of some events that is not before the current one."""
    later = [number for number in numbers if current.event is None or number > current.event]
    return next(iter(later or numbers), None)


def _met(event: object) -> set[str]:
    return {event.first, event.second} if isinstance(event, Impact) else set()


_BLOWS = frozenset(("kick", "kicked", "blow", "struck"))
_HEADING_WORDS = frozenset(
    ("after", "before", "at", "for", "in", "on", "the", "with", "wall", "between", "and", "of")
    + ("sphere", "ball", "particle", "now", "next", "then", "just", "immediately", "again", "point")
    + ("spheres", "balls", "from", "off", "when", "during", "hitting", "initially", "finally", "to")
    + ("first", "second", "third", "one", "two", "three", "cushion", "both", "against", "another")
    + ("kick", "kicked", "blow", "struck")
)


def heading_end(tokens: Sequence[Token], usage: Usage) -> int:
    """How many tokens at the beginning of a line may be a heading; 0 where there is none.

    A heading is made of words of few kinds and names. It ends at a colon, at the end of the line,
    or where the mathematics begins.
    """
    end = 0
    while end < len(tokens) and end < 10 and _in_heading(tokens[end], usage):
        end += 1
    while end and tokens[end - 1].kind == "number" and end < len(tokens):
        behind = tokens[end].kind
        if behind in (":", ",", "stop"):
            break
        end -= 1
    if not end or not any(token.kind in ("word", "name") for token in tokens[:end]):
        return 0
    if end == 1 and tokens[0].kind == "name" and len(tokens) > 2:
        wall = tokens[0].name in usage.walls and tokens[1].kind == ":"
        return 1 if wall else 0
    if end == len(tokens) or tokens[end].kind in (":", ",", "stop", ";"):
        return end if end == len(tokens) or tokens[end].kind == ":" or end > 1 else 0
    if tokens[end].kind == "word":
        return 0
    operator = tokens[end].kind in ("relation", "+", "*", "/", "^", "percent")
    first_name = tokens[end - 1].kind == "name" and tokens[end - 1].gap == 0
    return 0 if operator or first_name or tokens[0].kind == "name" else end


def _in_heading(token: Token, usage: Usage) -> bool:
    if token.kind == "word":
        low = token.text.lower()
        return (
            low in _HEADING_WORDS
            or low in EVENT_WORDS
            or low in ORDINALS
            or low in STAGES
            or token.text in usage.names
        )
    if token.kind == "name":
        return True
    return token.kind == "number" and token.value.denominator == 1 and token.value < 10
