"""A picture in words: its title, and a sentence or two for those who do not see it."""

from __future__ import annotations

from fractions import Fraction

from restitution.draw.values import Chosen, Motion
from restitution.render import layout as lay
from restitution.render.layout import Layout


def title(motion: Motion, number: int) -> str:
    return "x"


def description(motion: Motion, number: int) -> str:
    return "x"


def value_of(chosen: Chosen) -> Layout:
    """The value at which a letter is drawn."""
    if isinstance(chosen.value, Fraction):
        value = lay.from_sympy(chosen.value)
    else:
        value = lay.decimal_number(chosen.value)
    return lay.Degrees(value) if chosen.angle else value
