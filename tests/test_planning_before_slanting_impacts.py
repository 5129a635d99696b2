"""Velocities before spheres meet along a line that slants: by their components along it."""

from __future__ import annotations

from workings import printed_with


def test_both_velocities_by_those_after() -> None:
    printed_with(
        "sphere A: mass 2\nsphere B: mass 1\nA hits B: along 4i + 3j, e = 1/2\n"
        "given velocity(A) = i - 3j, velocity(B) = 6i + 2j\n"
        "find velocity(A, 0), velocity(B, 0)",
        (
            "Let p be the component of 𝐮_A along the line of centres",
            "2p + q = 2(−1) + 6",
            "6 + 1 = ½(p − q)",
            "p = 6 m s⁻¹",
            "The velocity changes along the line of centres only: 𝐮_A = (𝐢 − 3𝐣) +",
            "= (6.6𝐢 + 1.2𝐣) m s⁻¹",
        ),
    )


def test_one_sphere_was_at_rest() -> None:
    printed_with(
        "sphere A: mass 3\nsphere B: mass 2, at rest\nA hits B: along i - j, e = 1/4\n"
        "given velocity(A) = 3i - j\nfind velocity(A, 0), velocity(B)",
        ("3p = 3 × 2√2 + 2w", "w − 2√2 = ¼p", "= (5𝐢 − 3𝐣) m s⁻¹", "= (3𝐢 − 3𝐣) m s⁻¹"),
    )


def test_the_coefficient_is_to_be_found() -> None:
    printed_with(
        "sphere A: mass 4\nsphere B: mass 3, velocity -i + 2j\nA hits B: along i - 2j\n"
        "given velocity(A) = i + j, velocity(B) = 2i - 4j\nfind velocity(A, 0), e",
        ("4p + 3(−√5) = 4(−√5/5) + 3 × 2√5", "((13/4)𝐢 − (7/2)𝐣) m s⁻¹", "e = 44/61"),
    )


def test_letters_of_the_data_and_of_masses() -> None:
    printed_with(
        "sphere A: mass m, velocity a i + b j\nsphere B: mass 2m\n"
        "A hits B: along 3i + 4j, e = 1/2\n"
        "given velocity(A) = i - 2j, velocity(B) = 3i + 4j\nfind a, b",
        ("mp + 2mq = −m + 2m × 5", "Comparing components: a =", "b ="),
    )


def test_a_vector_across_the_line_of_centres_is_said_to_be_that() -> None:
    printed_with(
        "sphere A: mass 2, velocity 7i + b j\nsphere B: mass 3, at rest\n"
        "A hits B: along i + j\ngiven velocity(A) = 3i - j\nfind b",
        ("Scalar product with −𝐢 + 𝐣, perpendicular to the line of centres, before the impact:",),
    )
