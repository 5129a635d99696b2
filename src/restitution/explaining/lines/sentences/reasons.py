"""Reasons for which a line holds, or a root is left out."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "derived.not-negative": "a coefficient of restitution is not negative",
    "derived.at-most-one": "a coefficient of restitution is at most 1",
    "derived.it-is": "it is {value} if {at}",
    "derived.from-to": "{growth}, from {low} if {first} to {high} if {last}",
    "derived.no-value": "there is no {letter} if {bound}",
    "derived.negative": "the {component} is negative",
    "derived.above-zero": "the {component} is positive",
    "derived.along-unit": "{velocity} is in the direction of {unit}",
    "derived.negative-part": "{velocity} has a negative {axis}-component",
    "derived.side-of-blow": (
        "the impulse has a component in the direction of {axis}, since {bounds:and}"
    ),
    "derived.positive-part": "{velocity} has a positive {axis}-component",
    "derived.gained": "kinetic energy is gained",
    "derived.both-possible": "both are possible",
    "derived.both-positive": "both are possible, as both are positive",
    "derived.both-coefficients": "both are possible, as both are from 0 to 1",
    "derived.either-sign": "both are possible, as {letter} may have either sign",
    "derived.all-possible": "all are possible",
    "derived.anyway": "{fact} in any case.",
    "derived.anyway-as": "{fact} in any case, as {ground}.",
    "derived.reached": "{bound}, since {body} reaches {wall}",
    "derived.not-yet": "and {body} has not reached {wall} by then, as {bound}",
    "derived.right-angle": "and {angle} if {at}",
    "derived.tangent-for": "for {condition}",
    "derived.upright-too": "which holds if {at} too, where {angle}",
    "derived.cotangent": "the cotangent decreases between 0° and 180°",
    "derived.as": "as {reasons:and}",
    "derived.as-because": "as {reasons:and}, because {causes:and}",
    "derived.no-root": "{value} does not satisfy {equation}",
    "derived.would": "{value} would give {results:and} by {equations:and}",
    "derived.would-beyond": "{value} would give {results:and} by {equations:and}, but {bound}",
    "derived.for": "when {places:or}",
    "derived.from-then": "for {time}",
    "derived.acute": "{angle} is acute",
    "derived.half-acute": "{bound} since {angle} is acute",
    "derived.both-acute": "{angles:and} are acute",
    "derived.every-positive": ("and it takes every positive value as {angle} goes from 0° to 90°"),
    "derived.every-between": (
        "and it takes every value between, as it tends to {first} as {angle} → 0° and to {last} as "
        "{angle} → 90°"
    ),
    "derived.so-acute": "so {angle} is acute",
    "derived.acute-by-tangent": "{bound} and so {angle} is acute",
    "derived.positive": "{letter} is positive",
    "derived.cannot-be-negative": "{letter} cannot be negative",
    "derived.cannot-exceed-one": "{letter} cannot exceed 1",
    "derived.given": "this is given",
    "derived.not-at-rest": "{body} is not at rest",
    "derived.fact": "{fact}",
    "derived.fact-equal": "{fact}, with equality when {place}",
    "derived.increases": "{quantity} increases with {letter}",
    "derived.slope": "the derivative of {quantity} with respect to {letter} is {slope}",
    "derived.its": "{quantity} ",
    "derived.tends-to": "{first}tends to {value} as {letter} → {end}",
    "derived.squared": "neither side is negative",
    "derived.tends": "{first}tends to {value} as {letter} grows",
    "derived.decreases": "{quantity} decreases as {letter} increases",
}
