"""Workings as a teacher prints them: what stands once, in one form, under one heading."""

from __future__ import annotations

from workings import printed_with


def test_one_identity_for_two_equations_has_one_heading() -> None:
    printed_with(
        """
        wall V: along i
        wall W: along 180° - phi
        sphere Q: velocity v at beta to V
        Q hits V: e = 1
        Q hits W: e = 1
        given velocity(Q) parallel to i
        find phi in terms of beta
        """,
        [
            "From (1) and (2), by the formulae for a sum of angles: 𝐯₁ · 𝐧 = v sin(β + φ)",
            "𝐯₁ · 𝐭 = −v cos(β + φ)",
            "Parallel to W",
        ],
    )
