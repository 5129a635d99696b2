"""The laws that a false line uses by the name of its mistake."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.tree import Number, is_binary
from restitution.practice.judgement import Mistake, Use
from restitution.practice.judging.entries import is_numeric
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.script import Claim

# What a result is, as the principle of a line.
_PRINCIPLES = {
    "impulse": "impulse",
    "energy_lost": "energy",
    "energy": "energy",
    "speed": "speed",
    "deflection": "deflection",
}


_LAWS = frozenset({"momentum", "restitution", "unchanged"})
# The name of a law before its equation.
_NAMES: Mapping[str, re.Pattern[str]] = {
    "momentum": re.compile(r"\b(p?\.?c\.?l\.?m|co[ml]|mtm|mom|momentum)\b", re.IGNORECASE),
    "restitution": re.compile(
        r"\b(n\.?e\.?l|n\.?l\.?r|n\.?l\.?i|restitution|newton'?s?)\b", re.IGNORECASE
    ),
}


def as_labelled(variants: Sequence[VariantAt], text: str) -> tuple[VariantAt, ...]:
    """The altered laws of a line, those of the law that it names if there are some: ``CLM: …``."""
    named = [law for law, pattern in _NAMES.items() if pattern.search(text)]
    own = tuple(
        variant
        for variant in variants
        if len(named) == 1 and any(x.law == named[0] for x in variant.laws)
    )
    return own or tuple(variants)


def is_bare_value(claim: Claim, uses: Sequence[Use]) -> bool:
    """Whether a claim gives one number as a value, and no law with it: ``separation 3``."""
    return isinstance(claim.right, Number) and any(use.principle == "value" for use in uses)


def is_e_times(claim: Claim, uses: Sequence[Use]) -> bool:
    """Whether a product of numbers is the law of restitution in numbers: ``¾ × 8 = 6``."""
    law = bool(uses) and uses[0].principle == "restitution"
    return law and is_binary(claim.left, "*") and is_numeric(claim.left)


def of_mistake(mistake: Mistake, use: Use) -> Use:
    """An altered law as one of a mistake that has no variant in the line."""
    return replace(use, altered=f"{mistake.id}/1")


def with_variants(
    uses: Sequence[Use], variants: Sequence[VariantAt], mistake: Mistake
) -> tuple[Use, ...]:
    """What a line uses with the altered laws of its mistake.

    Of a result that is defined wrongly, the laws that it would have otherwise are no mistake.
    """
    own = tuple(_of_variants(variants, mistake))
    others = uses if any(use.principle in _LAWS for use in own) else _without_laws(uses)
    return tuple(dict.fromkeys((*own, *others)))


def _without_laws(uses: Sequence[Use]) -> Iterator[Use]:
    return (use for use in uses if use.principle not in _LAWS)


def _of_variants(variants: Sequence[VariantAt], mistake: Mistake) -> Iterator[Use]:
    """The altered laws and results of a named mistake in a line with numbers put in."""
    for variant in variants:
        if variant.id in mistake.variants:
            for law in variant.laws:
                yield Use(law.law, variant.event.number, law.bodies, variant.id)
            for result in variant.results:
                kind = _PRINCIPLES.get(str(kind_of(result.quantity)))
                if kind is not None:
                    yield Use(kind, variant.event.number, (), variant.id)


def repeated_in(variants: Sequence[VariantAt], uses: Sequence[Use]) -> frozenset[str]:
    """The mistakes of an earlier line that a line has once more, at the same event.

    Whoever exchanges sine and cosine in one component does so in the other.
    """
    return frozenset(
        variant.id
        for variant in variants
        for use in uses
        if variant.id == use.altered and variant.event.number == use.event
    )
