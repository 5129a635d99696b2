"""The laws that a false line uses by the name of its mistake."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.practice.judgement import Mistake, Use
from restitution.practice.judging.other_forms import kind_of

# What a result is, as the principle of a line.
_PRINCIPLES = {
    "impulse": "impulse",
    "energy_lost": "energy",
    "energy": "energy",
    "speed": "speed",
    "deflection": "deflection",
}


def of_mistake(mistake: Mistake, use: Use) -> Use:
    """An altered law as one of a mistake that has no variant in the line."""
    return replace(use, altered=f"{mistake.id}/1")


def uses_of_variants(variants: Sequence[VariantAt], mistake: Mistake) -> Iterator[Use]:
    """The altered laws and results of a named mistake in a line with numbers put in."""
    for variant in variants:
        if variant.id in mistake.variants:
            for law in variant.laws:
                yield Use(law.law, variant.event.number, law.bodies, variant.id)
            for result in variant.results:
                kind = _PRINCIPLES.get(str(kind_of(result.quantity)))
                if kind is not None:
                    yield Use(kind, variant.event.number, (), variant.id)
