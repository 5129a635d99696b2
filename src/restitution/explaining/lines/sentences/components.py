"""Components of velocities, and velocities and speeds put together from them."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "resolved-spheres.before": (
        "Components before the impact, along and across the line of centres:"
    ),
    "resolved-spheres.why": (
        "Along the line of centres momentum and Newton's experimental law hold; across it "
        "nothing changes. So each velocity is resolved in these two directions first, by sine "
        "and cosine or by scalar product with a unit vector."
    ),
    "resolved-spheres.before-units": "{components:capital} before the impact:",
    "resolved-spheres.before-turned": (
        "{components:capital} before the impact, as this line of centres is at right angles to the "
        "last one:"
    ),
    "resolved-spheres.before-sense": (
        "Components before the impact, those perpendicular to the line of centres in the direction "
        "of {axis}:"
    ),
    "resolved-spheres.before-left": (
        "Components before the impact, with those perpendicular to the line of centres positive to "
        "the left, looking from {first} to {second}:"
    ),
    "resolved-spheres.after-units": "{components:capital} after the impact:",
    "resolved-wall.before": "Components before the impact, towards {wall} and parallel to it:",
    "resolved-wall.why": (
        "The two components behave differently at a wall: the one towards it is reversed and "
        "multiplied by e, the one along it stays. So the velocity is resolved in these two "
        "directions first."
    ),
    "resolved-wall.before-sense": (
        "Components before the impact, those parallel to {wall} in the direction of {axis}:"
    ),
    "resolved-wall.before-units": "{components:capital} before the impact:",
    "resolved-wall.before-rest": (
        "{wall} is at {angle} to {axis}. {components:capital} before the impact:"
    ),
    "resolved-wall.after-units": "{components:capital} after the impact:",
    "resolved.of-another": "{components:capital} of {velocity}:",
    "resolved.several": "components",
    "resolved.one": "component",
    "resolved.several-products": "scalar products",
    "resolved.one-product": "scalar product",
    "resolved.before-vector": "{components:capital} before the impact, as {vector}:",
    "resolved.before-vector-from": (
        "{components:capital} before the impact, as {vector} from part ({label}):"
    ),
    "resolved.products-before": (
        "{products:capital} with {vector}, along the line of centres, before the impact:"
    ),
    "resolved.products-across": (
        "{products:capital} with {vector}, perpendicular to the line of centres, before the impact:"
    ),
    "resolved.products-wall": (
        "{products:capital} with {vector}, perpendicular to {wall}, before the impact:"
    ),
    "resolved.products-along": (
        "{products:capital} with {vector}, parallel to {wall}, before the impact:"
    ),
    "resolved.products-after": "{products:capital} with {vector}, after the impact:",
    "resolved.before-at-centres": (
        "{body} moves at {angle} to the line of centres. {components:capital} before the impact:"
    ),
    "resolved.before-at-wall": (
        "{body} moves at {angle} to {wall}. {components:capital} before the impact:"
    ),
    "resolved.before-across-at-centres": (
        "{body} moves perpendicular to the line of centres of its last impact, at {angle} to this "
        "one. {components:capital} before the impact:"
    ),
    "resolved.direct": "{body} strikes {wall} at right angles. Component before the impact:",
    "resolved.direct-speed": (
        "{body} strikes {wall} at right angles, so its component before the impact is its speed:"
    ),
    "resolved.direct-radius": (
        "{body} moves along the radius, so it strikes {wall} at right angles. Component before the "
        "impact:"
    ),
    "resolved.before-across-at-wall": (
        "{body} moves perpendicular to the line of centres of its last impact, at {angle} to "
        "{wall}. {components:capital} before the impact:"
    ),
    "resolved.before-off-at-centres": (
        "{body} was at rest before {struck}, so it moved off along the line of centres of that "
        "impact, at {angle} to this one. {components:capital} before the impact:"
    ),
    "resolved.before-off-at-wall": (
        "{body} was at rest before {struck}, so it moved off along the line of centres, at {angle} "
        "to {wall}. {components:capital} before the impact:"
    ),
    "resolved.before-moved-off": (
        "{body} was at rest before {struck}, so it moved off along the line of centres: {vector}. "
        "{components:capital} before the impact:"
    ),
    "resolved-axes.along-wall": "{components:capital} parallel to {wall}:",
    "resolved-axes.across-wall": "{components:capital} perpendicular to {wall}:",
    "resolved-axes.title": "Components along the axes:",
    "units.both-spheres": (
        "Let {along} be the unit vector along the line of centres, and {across} the one "
        "perpendicular to it."
    ),
    "units.along-earlier": (
        "Let {along} be the unit vector along the line of centres of {impact}."
    ),
    "units.along-spheres": "Let {along} be the unit vector along the line of centres.",
    "units.across-spheres": (
        "Let {across} be the unit vector perpendicular to the line of centres."
    ),
    "units.both-wall": (
        "Let {along} be the unit vector perpendicular to {wall}, towards it, and {across} the one "
        "parallel to {wall}."
    ),
    "units.both-normal": (
        "Let {along} be a unit vector perpendicular to {wall}, and {across} one parallel to {wall}."
    ),
    "units.both-from": (
        "Let {along} be the unit vector along the line of centres, from {first} to {second}, and "
        "{across} the one perpendicular to it."
    ),
    "units.along-from": (
        "Let {along} be the unit vector along the line of centres, from {first} to {second}."
    ),
    "units.both-above": (
        "Let {along} be that unit vector along the line of centres, and {across} the one "
        "perpendicular to it."
    ),
    "units.along-above": "Let {along} be that unit vector along the line of centres.",
    "units.both-wall-above": (
        "Let {along} be that unit vector perpendicular to {wall}, and {across} the one parallel to "
        "{wall}."
    ),
    "units.along-wall-above": "Let {along} be that unit vector perpendicular to {wall}.",
    "units.both-circle": (
        "Let {along} be the unit vector along the radius, towards the wall {wall}, and {across} "
        "the one along the tangent."
    ),
    "units.along-circle": (
        "Let {along} be the unit vector along the radius, towards the wall {wall}."
    ),
    "units.across-circle": "Let {across} be the unit vector along the tangent to {wall}.",
    "units.along-normal": "Let {along} be a unit vector perpendicular to {wall}.",
    "units.along-wall": "Let {along} be the unit vector perpendicular to {wall}, towards it.",
    "units.plain-spheres": (
        "The unit vector along the line of centres, from {first} to {second}, is {unit}."
    ),
    "units.plain-normal": "A unit vector perpendicular to {wall} is {unit}.",
    "units.plain-wall": "The unit vector perpendicular to {wall}, towards it, is {unit}.",
    "units.across-wall": "Let {across} be the unit vector parallel to {wall}.",
    "turned-velocity.title": "The velocity, from its magnitude and direction",
    "turned-velocity.why": (
        "The angle of deflection is the angle between the directions before and after. From the "
        "direction before it gives the direction after, to one side or the other. With the speed "
        "it gives the velocity, by a cosine and a sine."
    ),
    "derived-speed.one": "The velocity of {body} has one component only",
    "derived-speed.along": "{body} moves along the line of centres",
    "derived-speed.along-from-rest": "{body} was at rest, so it moves along the line of centres",
    "derived-speed.kept": "{wall} is perfectly elastic, so {body} keeps its speed",
    "derived-speed.across": "{body} moves perpendicular to the line of centres",
    "derived-speed.by-cos": "Speed of {body} = component ÷ cosine of its angle",
    "derived-speed.by-sin": "Speed of {body} = component ÷ sine of its angle",
    "derived-speed.resolved": "Component of the velocity of {body}, by its speed and direction",
    "derived-speed.title": "Speed, from its components",
    "derived-speed.title-of": "Speed of {body}, from its components",
    "derived-speed.why": (
        "The components are the two shorter sides of a right-angled triangle, of which the "
        "velocity is the longest. So the square of the speed is the sum of the squares of the "
        "components, by Pythagoras."
    ),
    "derived-size.title": "Magnitude, from the components",
    "derived-size.why": (
        "The components of a vector are the two shorter sides of a right-angled triangle, of which "
        "the vector is the longest. So the square of its magnitude is the sum of the squares of "
        "the components, by Pythagoras."
    ),
    "derived-assembled.still": "{body} takes no part in {event}, so its velocity is still",
    "derived-assembled.at-start": "The velocity of {body} at the start, by its components:",
    "derived-assembled.title": "The velocity, from its components",
    "derived-assembled.why": (
        "A velocity is the sum of its components, each times the unit vector in its direction. "
        "The impact changes one of them and leaves the other; both belong to the velocity."
    ),
    "relative-velocity.title": "The relative velocity, from its components",
    "relative-velocity.why": (
        "Along the line of centres the relative velocity is the velocity of separation, which "
        "Newton's experimental law gives; across it neither velocity has changed."
    ),
    "derived.stays": "the component of {of} stays {value}.",
    "derived.stays-left": (
        "the component of {of} to the left, looking from {first} to {second}, stays {value}."
    ),
    "derived.stays-in": "the component of {of} in the direction of {axis} stays {value}.",
}
