"""The mistakes as text for a terminal: all of them, or one with its variants."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from textwrap import wrap

from restitution.explaining.mistakes.alteration import Alteration
from restitution.explaining.mistakes.misconceptions import (
    MISCONCEPTIONS,
    SLIPS,
    Misconception,
    misconception,
    mistake_id,
)

_WORLDS = {
    "motion": "It alters the motion: solve --as and play --as show it.",
    "result": "It alters a result alone: solve --as shows it.",
    "none": "It has no world of its own.",
}


def all_mistakes(columns: int = 80) -> str:
    """Every misconception and slip, by id and in a sentence."""
    longest = max(map(len, MISCONCEPTIONS))
    lines: list[str] = []
    for mistake in MISCONCEPTIONS.values():
        lines += _beside(mistake.id, mistake.sentence, longest, columns)
    lines += ["", "Slips, which have no world of their own:"]
    for slip in SLIPS.values():
        lines += _beside(slip.id, slip.sentence, longest, columns)
    return "\n".join(lines) + "\n"


def _beside(name: str, text: str, room: int, columns: int) -> list[str]:
    return wrap(
        text,
        max(columns, room + 20),
        initial_indent=f"{name:<{room}}  ",
        subsequent_indent=" " * (room + 2),
    )


def about_mistake(name: str, columns: int = 80) -> str:
    """One misconception, or one variant of it, by its id or title.

    Raises StatementError for one that is not there.
    """
    name = mistake_id(name)
    if name in SLIPS:
        return f"{name}: {SLIPS[name].sentence} It is a slip, and has no world of its own.\n"
    about = misconception(name)
    return "\n".join(_about(about, name, columns)) + "\n"


def _about(about: Misconception, name: str, columns: int) -> Iterator[str]:
    yield f"{about.title} ({about.id})"
    yield ""
    yield from wrap(about.sentence, columns)
    yield from wrap(about.consequence, columns)
    yield from wrap(_WORLDS[about.world], columns)
    yield ""
    yield f"A usual line:  {about.line}"
    marks = "; ".join(f"{mark} in {principle}" for principle, mark in about.marks)
    yield from wrap(f"Marks:         {marks}. {about.rule}".rstrip(), columns)
    variants = [variant for variant in about.variants if name in (variant.id, about.id)]
    if not variants:
        return
    yield ""
    groups: dict[tuple[str, str, bool], list[Alteration]] = {}
    for variant in variants:
        groups.setdefault((variant.where, variant.words, variant.solvable), []).append(variant)
    room = max(len(variant.id) for variant in variants)
    for alteration in variants:
        place = {"wall": "wall", "spheres": "spheres", "impact": ""}[alteration.where]
        known = "" if alteration.solvable else " (lines only)"
        group = groups[alteration.where, alteration.words, alteration.solvable]
        which = f"{group.index(alteration) + 1} of {len(group)}, which {_difference(group)}"
        differ = f" ({which})" if len(group) > 1 else ""
        yield from _beside(
            alteration.id, f"{place}: {alteration.words}{known}{differ}", room, columns
        )


def _difference(variants: Sequence[Alteration]) -> str:
    """In what variants differ that have the same words."""
    plain = {re.sub(r"[-+() ]", "", f"{variant.laws}{variant.results}") for variant in variants}
    return "differ in signs" if len(plain) == 1 else "differ in the terms altered"
