"""Facts that are given, or come from an earlier part."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "given.data": "It is given that",
    "given.turned-wall": "{body} moves at {angle} to {wall}.",
    "given.along-centres": (
        "{body} moves towards {wall} at {angle} to it, that is at {direction} to {unit}: along the "
        "line of centres."
    ),
    "given.turned-centres": "{body} moves at {angle} to the line of centres.",
    "given.tangent": "{angle:capital} with tangent {value} has sine {sine} and cosine {cosine}.",
    "given.sine": "{angle:capital} with sine {value} has cosine {cosine}.",
    "given.cosine": "{angle:capital} with cosine {value} has sine {sine}.",
    "given.acute-angle": "an acute angle",
    "given.angle-of-an-arcsine": "an angle between −90° and 90°",
    "given.angle-of-an-arccosine": "an angle between 0° and 180°",
    "given.fact-along": ("It is given that {fact}, and {body} moves along the line of centres:"),
    "given.fact-across": (
        "It is given that {fact}, and {body} moves perpendicular to the line of centres:"
    ),
    "given.fact-from-rest": (
        "It is given that {fact}. {body} was at rest, so it moves along the line of centres:"
    ),
    "given.turned-to-centres": (
        "It is given that {fact}, so {velocity} makes {angle} with the line of centres:"
    ),
    "given.fact": "It is given that {fact}:",
    "given.fact-along-one": (
        "It is given that {fact}. These positions differ in their {axis}-coordinates alone:"
    ),
    "given.some-multiple": "It is given that {fact}, so for some number {letter}:",
    "given.fact-across-wall": (
        "It is given that {fact}. By the component that changes, dividing by half the mass:"
    ),
    "given.fact-without-mass": "It is given that {fact}. Dividing by half the mass:",
    "given.fact-from": "It is given that {fact}. So from {equations:and}:",
    "given.fact-sense": "It is given that {fact}, and {sense}, as {bound}:",
    "given.and": "It is given that {fact}.",
    "given.facts": "It is given that {facts:and}.",
    "given.turned": (
        "It is given that {facts:and}. The velocity, from its magnitude and direction:"
    ),
    "given.impulse-turned": "The impulse given to {body}, from its magnitude and direction:",
    "given.by-what-changes": "By the component that changes:",
    "given.by-those-that-change": "By the components that change:",
    "given.agrees": "It is also given that {fact}, which agrees with this.",
    "given.not-needed": "It is also given that {fact}, which is not needed here.",
    "given.direction": (
        "It is given that {fact}, so {velocity} has no component in the direction of {axis}:"
    ),
    "given.component": (
        "It is given that {fact}, so the component in the direction of {axis} is zero:"
    ),
    "given.behind": (
        "It is given that {fact}, so {velocity} has a negative component along {axis}:"
    ),
    "given.not-ahead": (
        "It is given that {fact}, so {velocity} has no positive component along {axis}:"
    ),
    "given.so-signed": "Since {fact}, {sign}:",
    "given.positive-product": "It is given that {fact}, so {product} is positive:",
    "given.negative-product": "It is given that {fact}, so {product} is negative:",
    "given.no-negative-product": "It is given that {fact}, so {product} is not negative:",
    "given.no-positive-product": "It is given that {fact}, so {product} is not positive:",
    "given.none-in": "So {velocity} has no component in the direction of {axis}:",
    "given.none-as-given": "As {fact}, {velocity} has no component in the direction of {axis}:",
    "given.none-along": "So {velocity} has no component along {line}:",
    "given.product": "It is given that {fact}, so {product} is zero:",
    "given.product-by-wall": (
        "It is given that {fact}. {wall} is parallel to {vector}, so the scalar product is zero:"
    ),
    "given.of-cosine": "It is given that {fact}, of which the cosine is {cosine}.",
    "given.by-the-product": "By the scalar product:",
    "given.product-along": (
        "It is given that {fact}. As {body} moves along the line of centres, the scalar product is "
        "that of the components along it, and is zero:"
    ),
    "given.product-from-rest": (
        "It is given that {fact}. {body} was at rest, so it moves along the line of centres; the "
        "scalar product is that of the components along it, and is zero:"
    ),
    "given.square-to-from-rest": (
        "It is given that {fact}. {one} was at rest, so it moves along the line of centres, and "
        "{other} perpendicular to it:"
    ),
    "given.square-to": (
        "It is given that {fact}. {one} moves along the line of centres, so {other} moves "
        "perpendicular to it:"
    ),
    "given.multiple": "It is given that {fact}, so the {component} is {value}.",
    "given.rest": "It is given that {body} is at rest afterwards.",
    "given.component-off": (
        "It is given that {fact}, so the component perpendicular to {wall} is zero:"
    ),
    "given.straight-on": "It is given that {fact}, so {body} hits {wall} at right angles:",
    "given.along-the-line": (
        "It is given that {fact}, so {body} has no component perpendicular to the line of centres:"
    ),
    "given.off-the-line": (
        "It is given that {fact}, so {body} has no component along the line of centres:"
    ),
    "given.proportion": "It is given that {fact}, so their components are in proportion:",
    "given.approach": "{one} and {other} approach each other before {event}:",
    "given.towards-wall": "{body} moves towards {wall} before {event}:",
    "given.not-along-wall": "{body} does not move parallel to {wall} before {event}:",
    "given.offset": "{one} does not pass by {other}:",
    "given.most": "A coefficient of restitution is at most 1:",
    "given.between": "{body} hits {wall} between its ends:",
    "given.compare": "Comparing components:",
    "given.compare-both": "Comparing components, {first} and {second}:",
    "carried.part": "From part ({label}):",
    "carried.above": "From above:",
    "carried.from-part": "{values:and} from part ({label})",
    "carried.from-above": "{values:and} from above",
    "carried.components": "the components of {velocity}",
    "carried.with": "with {sources:and}:",
    "carried.with-sentence": "with {sources:and}, {sentence}",
    "carried.with-alone": "With {sources:and}:",
    "carried.with-anew": "With {sources:and}:",
    "carried.in": "in part ({label}):",
    "carried.in-above": "above:",
}
