"""Altered laws by what they replace: which misconception one is, and what speaks against it."""

from __future__ import annotations

from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS, VariantAt
from restitution.practice.judgement import Use
from restitution.practice.judging.explained import Stated


def kinds_of(variant: VariantAt) -> set[str]:
    """The principles whose lines a misconception fits."""
    return set(MISCONCEPTIONS[variant.mistake].kinds)


def family_of(variant: VariantAt) -> str:
    """The misconception of a variant; at a wall, e × speed is one, whatever it is called."""
    restitution = any(law.law == "restitution" for law in variant.laws)
    if variant.mistake == "speed-for-component" and variant.event.wall and restitution:
        return "restitution-whole-speed"
    return variant.mistake


def family_beside(variant: VariantAt, stated: Stated) -> str:
    """The misconception of a variant: beside momentum in components it is the law's alone.

    Who has whole speeds in both laws takes speeds for components.
    """
    family = family_of(variant)
    if family != "speed-for-component" or not replaces(variant, "restitution"):
        return family
    momentum = ("momentum", variant.event.number)
    resolved = any((law, event) == momentum for law, event, _ in stated)
    return "restitution-whole-speed" if resolved else family


def contradicts(variant: VariantAt, stated: Stated) -> bool:
    """Whether a law that a variant replaces is stated rightly, or momentum at a later impact.

    Who has that has the right velocity from before it.
    """
    later = any(
        principle == "momentum"
        and event is not None
        and event > variant.event.number
        and set(bodies) & set(variant.event.bodies)
        for principle, event, bodies in stated
    )
    return later or any(
        (law.law, variant.event.number) == (principle, event)
        and (law.law != "unchanged" or not bodies or set(bodies) & set(law.bodies))
        for law in variant.laws
        for principle, event, bodies in stated
    )


def is_stated(use: Use, stated: Stated) -> bool:
    """Whether the law of which a claim is an instance is stated rightly above it."""
    return any(use.principle == law and use.event == event for law, event, _ in stated)


def replaces(variant: VariantAt, law: str) -> bool:
    """Whether a variant has another law in place of one."""
    return any(other.law == law for other in variant.laws)
