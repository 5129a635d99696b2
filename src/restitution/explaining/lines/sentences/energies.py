"""Kinetic energies, and what is lost of them."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "loss-spheres.why": (
        "Kinetic energy is ½m × (sum of the squares of the components). Those across the line "
        "of centres stay, so what is lost comes from those along it, of both spheres."
    ),
    "loss-spheres.title": "Kinetic energy lost, by the components that change",
    "loss-wall.why": (
        "Kinetic energy is ½m × (sum of the squares of the components). The one along the wall "
        "stays, so what is lost comes from the perpendicular one alone: ½m × (its square before "
        "− its square after)."
    ),
    "loss-wall.title": "Kinetic energy lost, by the component that changes",
    "energy-ratio.title": "Ratio of kinetic energies, in which the mass cancels",
    "energy-ratio.why": (
        "The kinetic energy of one body is half its mass times the square of its speed. In the "
        "ratio of two of its energies the factor ½m cancels, and the squares of its speeds are "
        "left."
    ),
    "fraction-lost.title": "Fraction of the kinetic energy that is lost, in which the mass cancels",
    "fraction-lost.percentage": (
        "Percentage of the kinetic energy that is lost, in which the mass cancels"
    ),
    "fraction-lost.at-a-wall": (
        "Only one component changes, and the mass cancels. Fraction of the kinetic energy that is "
        "lost"
    ),
    "fraction-lost.percentage-at-a-wall": (
        "Only one component changes, and the mass cancels. Percentage of the kinetic energy that "
        "is lost"
    ),
    "fraction-lost.together": "Fractions of the same kinetic energy are added",
    "fraction-lost.left": "What is lost is what is not kept",
    "fraction-lost.kept": "What is kept is what is not lost",
    "fraction-lost.at": "the fraction lost at {event}",
    "fraction-lost.of-energies": "the ratio of the energies",
    "fraction-lost.why": (
        "The kinetic energy of one body is half its mass times the square of its speed. Where one "
        "body loses energy, half its mass stands above and below in the fraction that is lost, and "
        "squares of speeds are left."
    ),
    "change-of-energy.title": "Change of kinetic energy, by the component that changes",
    "change-of-energy.why": (
        "The component that does not change adds the same to the kinetic energy before and after, "
        "so only the component along the line of centres counts. The energy after is put first: "
        "what is lost is negative."
    ),
    "derived-energy.title": "Kinetic energy",
    "derived-energy.why": (
        "Kinetic energy is half the mass times the square of the speed, and that square is the sum "
        "of the squares of the components. It has no direction: the energies of several bodies "
        "are added."
    ),
    "derived-energy.other-at-rest": (
        "As {other} is then at rest, the total kinetic energy is that of {body}"
    ),
    "derived-energy.others-at-rest": (
        "As {others:and} are then at rest, the total kinetic energy is that of {body}"
    ),
    "derived-energy.speed": "Speed, from the kinetic energy",
}
