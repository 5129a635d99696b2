"""What quantities are called, and the letters that stand for them."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "let.component": (
        "Let {letter} be the component of the velocity of {body} in the direction of {axis} "
        "after the impact."
    ),
    "let.components": (
        "Let {letters:and} be the components of the velocities of {bodies:and} in the direction "
        "of {axis} after the impact."
    ),
    "let.component-parallel": (
        "Let {letter} be the component of the velocity of {body} parallel to {wall} after the "
        "impact."
    ),
    "let.component-centres": (
        "Let {letter} be the component of the velocity of {body} along the line of centres, in "
        "the sense from {first} to {second}, after the impact."
    ),
    "let.components-centres": (
        "Let {letters:and} be the components of the velocities of {bodies:and} along the line of "
        "centres, in the sense from {first} to {second}, after the impact."
    ),
    "let.component-centres-towards": (
        "Let {letter} be the component of the velocity of {body} along the line of centres, in "
        "the direction of {axis}, after the impact."
    ),
    "let.components-centres-towards": (
        "Let {letters:and} be the components of the velocities of {bodies:and} along the line of "
        "centres, in the direction of {axis}, after the impact."
    ),
    "let.component-centres-at": (
        "Let {letter} be the component of the velocity of {body} along the line of centres, in "
        "the direction at {axis} anticlockwise from {unit}, after the impact."
    ),
    "let.components-centres-at": (
        "Let {letters:and} be the components of the velocities of {bodies:and} along the line of "
        "centres, in the direction at {axis} anticlockwise from {unit}, after the impact."
    ),
    "let.component-centres-clockwise": (
        "Let {letter} be the component of the velocity of {body} along the line of centres, in "
        "the direction at {axis} clockwise from {unit}, after the impact."
    ),
    "let.components-centres-clockwise": (
        "Let {letters:and} be the components of the velocities of {bodies:and} along the line of "
        "centres, in the direction at {axis} clockwise from {unit}, after the impact."
    ),
    "let.masses": "Let {letters:and} be the masses of {bodies:and}.",
    "derived.let": "Let {meanings:and}.",
    "derived.meaning": "{letter} be the {quantity}",
    "derived.name": "Let {equations:and}.",
    "derived.towards": (
        "Let {letter} be the component of the velocity of {body} perpendicular to {wall}, towards "
        "it, after the impact."
    ),
    "derived.away": (
        "Let {letter} be the component of the velocity of {body} perpendicular to {wall}, away "
        "from it, after the impact."
    ),
    "derived.value": "{value}",
    "derived.sentence": "{sentence:capital}",
    "derived.velocity": "velocity of {bodies:and}",
    "derived.velocities": "velocities of {bodies:and}",
    "derived.meanings": "{letters:and} be the {quantity}",
    "derived.coefficient": "coefficient of restitution",
    "derived.of-bodies": "{noun} {of:and}",
    "derived.of-all": "{noun}",
    "derived.speed": "speed of {of:and}",
    "derived.energy": "kinetic energy",
    "derived.energy-of": "kinetic energy of {bodies:and}",
    "derived.energy-all": "total kinetic energy",
    "derived.energy-lost": "kinetic energy lost",
    "derived.energy-lost-by": "kinetic energy lost by {body}",
    "derived.energy-gained-by": "kinetic energy gained by {body}",
    "derived.energy-lost-all": "total kinetic energy lost",
    "derived.angle": "angle between {of:and}",
    "derived.acute-angle": "acute angle between {of:and}",
    "derived.direction": "angle from {unit} to {velocity}",
    "derived.kick-size": "magnitude of {event}",
    "derived.fraction-lost": "fraction lost",
    "derived.percentage-lost": "percentage lost",
    "derived.impulse-given": "impulse given to {of:and}",
    "derived.impulse-size": "magnitude of the impulse",
    "derived.time": "time {event}",
    "derived.position": "position of {body}",
    "derived.coordinate-x": "x-coordinate of {body}",
    "derived.coordinate-y": "y-coordinate of {body}",
    "derived.displacement": "displacement of {body} along {axis} from {early} to {late}",
    "derived.distance-of": "distance between the positions of {body} {early} and {late}",
    "derived.distance": "distance between {of:and}",
    "derived.line": "line of centres",
    "derived.line-unit": "unit vector along the line of centres",
    "derived.normal-unit": "unit vector perpendicular to {wall}, towards it",
    "derived.centres": "the line of centres",
    "derived.normal": "the normal to {wall}",
    "derived.radius": "the radius to {body}",
    "derived.component-along": "component of {of} along the line of centres",
    "derived.component-across": "component of {of} perpendicular to the line of centres",
    "derived.component-towards": "component of {of} towards {wall}",
    "derived.component-away": "component of {of} away from {wall}",
    "derived.component-parallel": "component of {of} parallel to {wall}",
    "derived.component-tangent": "component of {of} along the tangent to {wall}",
    "derived.component-unit": "component of {of} along {axis}",
    "derived.component-along-vector": "component of {of} in the direction of {axis}",
    "derived.component-across-sense": (
        "component of {of} perpendicular to {axis} in the direction of {way}"
    ),
    "derived.component-across-vector": "component of {of} perpendicular to {axis}",
    "derived.called": "the {quantity}",
    "derived.is": "the {quantity} is {value}",
    "derived.sine-is": "the sine of the {angle} is {value}",
    "derived.cosine-is": "the cosine of the {angle} is {value}",
    "derived.tangent-is": "the tangent of the {angle} is {value}",
    "derived.more": "the {quantity} is more than {value}",
    "derived.at-least": "the {quantity} is at least {value}",
    "derived.less": "the {quantity} is less than {value}",
    "derived.at-most": "the {quantity} is at most {value}",
    "derived.part": "{share} of the {value}",
    "derived.times-the": "{share} times the {value}",
    "derived.same": "the {quantity} is equal to the {value}",
    "derived.share": "the {quantity} is {share} of the {value}",
    "derived.times": "the {quantity} is {share} times the {value}",
    "derived.twice": "the {quantity} is twice the {value}",
    "derived.times-that": "the {quantity} is {share} times that {when}",
    "derived.share-of-that": "the {quantity} is {share} of that {when}",
    "derived.the": "the {quantity}",
    "derived.greatest": "greatest value of {quantity}",
    "derived.least": "least value of {quantity}",
    "derived.greatest-named": "greatest {quantity}",
    "derived.least-named": "least {quantity}",
}
