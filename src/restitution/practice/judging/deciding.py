"""Which of several altered laws a mistake is, by the lines that follow from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.practice.judgement import Mistake
from restitution.practice.judging.claimed import holds_in
from restitution.practice.judging.explained import JudgedSoFar


def decided(
    mistake: Mistake, variants: Sequence[VariantAt], line: int, judge: JudgedSoFar
) -> Mistake:
    """A mistake with the only name in whose world all lines hold that follow below it."""
    if mistake.id is not None or len(mistake.also) < 2 or not mistake.variants:
        return mistake
    below = [entry for entry in judge.entries if entry.number > line and not entry.right]
    if not below or any(entry.wrong for entry in below):
        return mistake
    fitting = [
        variant
        for variant in variants
        if variant.id in mistake.variants
        and (world := judge.altered(variant)) is not None
        and all(holds_in(entry, world) for entry in below)
    ]
    names = {variant.mistake for variant in fitting}
    if len(names) != 1 or not names <= set(mistake.also):
        return mistake
    ids = tuple(dict.fromkeys(variant.id for variant in fitting))
    (name,) = names
    return replace(mistake, id=name, variants=ids, also=(), sure=True)
