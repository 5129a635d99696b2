"""Places, times and distances: flights, contacts, walls that are circles."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "offset.sine": (
        "At the impact the centres are {apart} apart, and the centre of {other} is {beside}. "
        "So the angle between the line of centres and that path has sine {sine}:"
    ),
    "offset.degrees": (
        "At the impact the centres are {apart} apart, and the centre of {other} is {beside}. "
        "So the angle between the line of centres and that path has sine {sine}, "
        "and is {angle}:"
    ),
    "offset.angle": (
        "The angle between the line of centres and {path} has sine {sine} and cosine {cosine}:"
    ),
    "offset.angle-in-degrees": "The line of centres makes an angle of {angle} with {path}:",
    "offset.letter": (
        "At the impact the centres are {apart} apart, and the centre of {other} is {beside}. "
        "Let {letter} be the angle between the line of centres and that path:"
    ),
    "offset.letter-again": "Let {letter} be the angle between the line of centres and {path}:",
    "offset.none": (
        "At the impact the centre of {other} is on {path}. So the line of centres is along that "
        "path:"
    ),
    "offset.turned": (
        "The line of centres makes the angle {letter} with {path}, to the {side} of it:"
    ),
    "offset.sine-alone": (
        "At the impact the centres are {apart} apart, and the centre of {other} is {beside}. "
        "So the angle between the line of centres and that path has sine {sine}."
    ),
    "offset.beside": "{offset} to the {side} of {path}",
    "offset.beside-either": "{offset} from {path}, say to the {side} of it",
    "offset.left": "left",
    "offset.right": "right",
    "offset.path": "the path of {body}",
    "offset.relative": (
        "the path of {body} relative to {other}, which is in the direction of {direction}"
    ),
    "offset.why": (
        "At the impact the centres are two radii apart: the longest side of a right-angled "
        "triangle whose other side, across the path, is the offset. So the sine of the angle "
        "between the path and the line of centres is offset/(2r)."
    ),
    "round.title": (
        "At the centre a chord subtends 180° less twice its angle with the radii, and the three "
        "chords subtend 360°, so the three angles have the sum 90°"
    ),
    "round.three": (
        "At the centre a chord subtends 180° less twice its angle with the radii, and the three "
        "chords subtend 360°, so the three angles have the sum 90°:"
    ),
    "round.same": (
        "As the impacts are perfectly elastic, each chord makes the same angle with the radius as "
        "the one before. So all three make the same angle with the radii at their ends: {angle}, "
        "that of the first chord with the radius at the start. Each subtends {span} at the centre, "
        "and the three subtend 360°:"
    ),
    "round.why": (
        "A chord and the radii to its ends form an isosceles triangle, so at the centre the chord "
        "subtends 180° less twice its angle with the radii. Three chords that close subtend 360° "
        "together. So their three angles with the radii make 90°."
    ),
    "chord.title": "A chord makes equal angles with the radii at its ends",
    "chord.title-sense": (
        "A chord makes equal angles with the radii at its ends. Components along {wall} are taken "
        "anticlockwise"
    ),
    "chord.again": "The next chord makes equal angles with the radii at its ends too",
    "chord.along-tangent": "The component along the tangent before the impact",
    "chord.along-tangent-sense": (
        "The component along the tangent before the impact, taken anticlockwise"
    ),
    "chord.along-radius": "The component along the radius before the impact",
    "chord.length": "Chord = diameter × cosine of its angle with the radius",
    "chord.diameter": ("{body} moves along the radius, so it passes through the centre of {wall}"),
    "chord.through": "{body} moves through the centre",
    "chord.time": "Time = length of the chord ÷ speed",
    "chord.from-centre": (
        "{body} starts at the centre of {wall}, so it moves along a radius. Time = radius ÷ speed"
    ),
    "chord.as-before": (
        "The impact changes the size of neither component, so the next chord is as long, and takes "
        "as long"
    ),
    "chord.why": (
        "The radius to the point of impact is perpendicular to the wall there. Two radii and "
        "the path between their ends form an isosceles triangle, so the path makes the same "
        "angle with the radius where it arrives as where it set out. Where that angle is φ, the "
        "path is 2r cos φ long."
    ),
    "flight.why": (
        "Between impacts nothing acts on a sphere on a smooth table, so its velocity stays the "
        "same: distance = speed × time, for each component by itself."
    ),
    "flight.title": "Distance = speed × time",
    "flight.title-of": "Distance = speed × time, for {body}",
    "flight.displacement": "Displacement = velocity × time",
    "flight.displacement-of": "Displacement = velocity × time, for {body}",
    "flight.several-ways": "Time = distance ÷ {speed}, which no impact in between changes",
    "flight.whole-way": "Time = distance ÷ {speed}, which no impact changes",
    "flight.between-impacts": "As {times}, {body} is then between {one} and {other}:",
    "flight.past-one": "Time = distance ÷ {speed}, which the impact with {other} does not change",
    "flight.closing": "Time = gap ÷ speed at which it closes",
    "flight.time": "Time = distance ÷ {speed}",
    "flight.time-of": "Time = distance ÷ {speed}, for {body}",
    "flight.time-to-rest": (
        "{other} is at rest, so it stays where it is. Time = distance ÷ {speed}, for {body}"
    ),
    "flight.time-to-rest-until": (
        "{other} is at rest until {event}. Time = distance ÷ {speed}, for {body}"
    ),
    "flight.speed": "speed",
    "flight.speed-along": "speed parallel to the {axis}-axis",
    "flight.speed-across-wall": "speed perpendicular to {wall}",
    "flight.speed-along-wall": "speed parallel to {wall}",
    "flight.speed-there": "speed in that direction",
    "flight.at-once": "{bodies:and} start at the same point, so they collide at once",
    "flight.still-in-contact": "{bodies:and} are still in contact, so they collide at once",
    "flight.rest": "{body} is at rest, so it stays where it is",
    "flight.rest-beside": "{body} is at rest, so it stays where it touched {other}",
    "flight.origin-taken": (
        "Position = velocity × time, for {body}, with the origin where {body} is at the impact"
    ),
    "flight.meets-level": "{body} meets {other}, which moves parallel to the {axis}-axis",
    "flight.both-level": (
        "{body} moves parallel to the {axis}-axis, and {other} parallel to the {second}-axis"
    ),
    "flight.level": "{body} moves parallel to the {axis}-axis",
    "flight.origin": "Position = velocity × time, from the origin",
    "flight.origin-of": "Position = velocity × time, for {body} from the origin",
    "flight.origin-since": (
        "Position = velocity × time, for {body}, which is at the origin {event}"
    ),
    "flight.from-zero": (
        "Position = velocity × time, for {body}, whose {axis}-coordinate is 0 {event}"
    ),
    "flight.place": "New position = old position + velocity × time",
    "flight.place-of": "New position = old position + velocity × time, for {body}",
    "flight.same-time": "The path is in the direction of the velocity",
    "flight.add": "Putting the times together:",
    "flight.subtract": "Subtracting the times:",
    "collide-again.if": (
        "{one} and {other} collide again if the gap between them along the line of centres closes:"
    ),
    "collide-again.unless": (
        "{one} and {other} do not collide again if the gap between them along the line of "
        "centres does not close:"
    ),
    "collide-again.if-behind": (
        "In the direction of {axis}, {behind} is behind {ahead}, so they collide again if the "
        "component of {behind} is greater than that of {ahead}:"
    ),
    "collide-again.unless-behind": (
        "In the direction of {axis}, {behind} is behind {ahead}, so they do not collide again if "
        "the component of {behind} is at most that of {ahead}:"
    ),
    "collide-again.why": (
        "After an impact the spheres separate. They meet again only if the one behind, after "
        "what happened in between, moves faster along the line than the one in front: it is "
        "velocities with their signs that are compared, and not speeds."
    ),
    "meeting.towards": "{body} hits {wall}{again} if it moves towards {wall}.",
    "meeting.away": "{body} does not hit {wall}{again} if it does not move towards {wall}.",
    "meeting.collide": (
        "{one} and {other} collide again if the gap between them along the line of centres closes."
    ),
    "meeting.apart": (
        "{one} and {other} do not collide again if the gap between them along the line of "
        "centres does not close."
    ),
    "meeting.collide-behind": (
        "In the direction of {axis}, {behind} is behind {ahead}, so they collide again if the "
        "component of {behind} is greater than that of {ahead}."
    ),
    "meeting.apart-behind": (
        "In the direction of {axis}, {behind} is behind {ahead}, so they do not collide again if "
        "the component of {behind} is at most that of {ahead}."
    ),
    "return.collide": (
        "{one} and {other} collide again if {body} moves towards {wall} and the gap between them "
        "closes as it comes back with speed {speed}."
    ),
    "return.collide-back": (
        "{one} and {other} collide again if the gap between them closes as {body} comes back from "
        "{wall} with speed {speed}."
    ),
    "return.apart": (
        "{one} and {other} do not collide again if the gap between them does not close as {body} "
        "comes back from {wall} with speed {speed}."
    ),
    "return.collide-when": (
        "{one} and {other} collide again if the gap between them closes as {body} comes back from "
        "{wall}."
    ),
    "return.apart-when": (
        "{one} and {other} do not collide again if the gap between them does not close as {body} "
        "comes back from {wall}."
    ),
    "return.collide-if": (
        "{one} and {other} collide again if the gap between them closes as {body} comes back from "
        "{wall}:"
    ),
    "return.apart-if": (
        "{one} and {other} do not collide again if the gap between them does not close as {body} "
        "comes back from {wall}:"
    ),
    "condition.towards-if": (
        "{body} hits {wall}{again} if it moves towards {wall}, that is, if {told}:"
    ),
    "condition.away-if": (
        "{body} does not hit {wall}{again} if it does not move towards {wall}, that is, if {told}:"
    ),
    "condition.towards": "{body} hits {wall}{again} if it moves towards {wall}:",
    "condition.away": "{body} does not hit {wall}{again} if it does not move towards {wall}:",
    "condition.between": (
        "{body} hits {wall} if, where {line}, its {axis}-coordinate is between those of the ends:"
    ),
    "condition.beyond": (
        "{body} does not hit {wall} if, where {line}, its {axis}-coordinate is not between those "
        "of the ends:"
    ),
    "touch.place": (
        "{one} and {other} touch when their centres are two radii apart, on the line of centres:"
    ),
    "touch.level": (
        "The line of centres is parallel to {axis}, so at the impact the {coordinate}-coordinates "
        "are equal:"
    ),
    "touch.level-then": (
        "The line of centres is parallel to {axis}, so at the impact the {coordinate}-coordinates "
        "are equal."
    ),
    "touch.along": (
        "At the impact the {coordinate}-coordinate of {more} is greater than that of {less} by two "
        "radii, as {approach}:"
    ),
    "touch.comes": "{one} comes towards {other} in the direction of {axis}",
    "touch.gains": "{one} gains on {other} in the direction of {axis}",
    "derived.approach": "{one} and {other} approach each other before they collide",
    "derived.comes": "{one} moves towards {other} before it hits it",
    "touch.towards": "{one} and {other} are approaching then",
    "touch.wall": (
        "At the impact with {wall} the centre of {body} is {radius} from {wall}, so its "
        "{axis}-coordinate is {value}."
    ),
    "touch.reached": (
        "When {body} reaches {wall}, its centre is {radius} from {wall}, so its {axis}-coordinate "
        "is {value}."
    ),
    "touch.spheres": (
        "{one} approaches {other} in the direction of {way}, and at the impact their centres are "
        "{distance} apart. So {other} is then at {place}."
    ),
    "touch.gap": "When {one} and {other} touch, their centres are {distance} apart.",
    "touch.gap-to-zero": (
        "When {one} and {other} touch, their centres are {distance} apart, so the "
        "{axis}-coordinate of {body} is then {zero}."
    ),
    "touch.at": "The {position} is {place}.",
    "touch.both-at": "At {event} {bodies:and} are both at {place}.",
    "touch.origin": "The {position} is the origin.",
    "touch.meet": "{one} and {other} meet when their coordinates are equal:",
    "touch.apart": "{one} and {other} touch when their centres are {distance} apart:",
    "contact.wall": "{body} is then on the line of {wall}:",
    "contact.wall-line": "{body} is then on the line of {wall}, {line}:",
    "circle.at": "{body} is then at a distance {radius} from the centre of {wall}:",
    "circle.centre-at": (
        "The centre of {body} is then at a distance {radius} from the centre of {wall}:"
    ),
    "circle.first": "{body} reaches that point first",
    "circle.ahead": "{body} is moving in the direction of {axis}",
    "circle.towards": "{body} is moving towards {wall} then",
    "backwards.solution": "Solution {number}.",
    "backwards.wall": "For what follows, {first} has to strike {second}.",
    "backwards.wall-at": "For what follows, {first} has to strike {second} at {point}.",
    "backwards.sphere": (
        "{second} is at rest when {first} strikes it, and moves off along the line of centres: so "
        "{first} has to be on that line, in contact then."
    ),
    "backwards.sphere-along": (
        "{second} is at rest when {first} strikes it, and moves off along the line of centres, "
        "along {way}: so {first} has to be on that line, in contact then."
    ),
    "backwards.sphere-at": (
        "{second} is at rest when {first} strikes it, and moves off along the line of centres, "
        "along {way}: so {first} has to be at {point} then."
    ),
    "distance.relative": (
        "The spheres are taken as particles, so they are together at {event}. Distance apart = "
        "relative speed × time"
    ),
    "distance.level": (
        "Perpendicular to the line of centres {one} and {other} keep level, so with the spheres as "
        "particles distance apart = relative speed along the line of centres × time"
    ),
    "distance.together": (
        "{bodies:and} are together {event}, so distance apart = relative speed × time"
    ),
    "distance.none": "With the spheres as particles {bodies:and} are together {event}",
    "distance.level-together": (
        "Perpendicular to the line of centres {one} and {other} keep level, so distance apart = "
        "relative speed along the line of centres × time"
    ),
    "distance.particles": "The spheres are taken as particles.",
    "distance.why": (
        "The distance of two points follows from their coordinates by Pythagoras. Two bodies that "
        "were together and move on at constant velocities are apart by the size of their relative "
        "velocity times the time since."
    ),
    "distance.along-one": "The positions differ in their {axis}-coordinates alone",
    "distance.displacements": "Distance, by Pythagoras",
    "distance.coordinates": "Distance, from the coordinates",
    "derived-place.title": "Position, from its coordinates",
    "derived-place.why": (
        "A position on the table is fixed by its two coordinates. Each is found by itself, as the "
        "motion in one direction does not depend on that in the other."
    ),
    "derived.chord": "length of the chord",
}
