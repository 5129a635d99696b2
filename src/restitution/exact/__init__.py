"""Exact numbers and expressions in the form a textbook would print, compared and rounded."""

from __future__ import annotations

from restitution.exact.angles import plain_angle, tidy_angle
from restitution.exact.numbers import denested, is_nested
from restitution.exact.orientation import forward
from restitution.exact.plain_angles import merged, plain_angles_in
from restitution.exact.quotients import reduced_over_surds
from restitution.exact.rounding import decimal, significant
from restitution.exact.rules_of_cosines import mend_rules_of_cosines
from restitution.exact.simplicity import cost
from restitution.exact.surds import rationalised, root_is_nested
from restitution.exact.textbook import tidy
from restitution.exact.trigonometry import in_one_ratio, in_sines
from restitution.exact.writing import canonical_name, sympy_text
from restitution.exact.zero import digits_apart, is_zero, same

__all__ = [
    "canonical_name",
    "cost",
    "decimal",
    "denested",
    "digits_apart",
    "forward",
    "in_one_ratio",
    "in_sines",
    "is_nested",
    "is_zero",
    "merged",
    "plain_angle",
    "plain_angles_in",
    "rationalised",
    "reduced_over_surds",
    "root_is_nested",
    "same",
    "significant",
    "sympy_text",
    "tidy",
    "tidy_angle",
]

mend_rules_of_cosines()
