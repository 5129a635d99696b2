"""Every sentence of a worked solution, by id: the one file for whoever writes it in other words.

Between braces stand slots, for names, values and sentences. ``{bodies:and}`` is a list, ``a, b and
c``; after a colon ``or``, ``comma`` and ``semicolon`` join in other ways, and ``capital`` begins
with a capital letter. What stands before the first dot of an id is a topic; a topic with a ``why``
is a principle, about which a reader may ask: why it holds and, as ``mistakes``, what goes wrong;
the words of these stand in `usual_mistakes`.
"""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.lines.usual_mistakes import USUAL_MISTAKES

SentenceId = str

SENTENCES: Mapping[SentenceId, str] = {
    **USUAL_MISTAKES,
    # --- joining ----------------------------------------------------------------------------------
    "list.comma": ", ",
    "list.and": " and ",
    "list.or": " or ",
    "list.semicolon": "; ",
    "ordinal.1": "first",
    "ordinal.2": "second",
    "ordinal.3": "third",
    "ordinal.4": "fourth",
    "ordinal.5": "fifth",
    "ordinal.6": "sixth",
    "ordinal.7": "seventh",
    "ordinal.8": "eighth",
    "so": "So",
    "again": " again",
    "page.title": "Worked solution",
    "page.note": "Note: {warning}.",
    # --- events, and the headings of their working ------------------------------------------------
    "heading.impact": "{order:capital} impact: {first} hits {second}",
    "heading.impact-number": "Impact {number}: {first} hits {second}",
    "heading.kick": "Impulse given to {body}",
    "heading.kick-order": "{order:capital} impulse given to {body}",
    "heading.kick-number": "Impulse {number}, given to {body}",
    "heading.case": "If {values:and}:",
    "event.only": "the impact",
    "event.impact": "the {order} impact",
    "event.impact-number": "impact {number}",
    "event.struck": "the impulse",
    "event.struck-order": "the {order} impulse",
    "event.kick": "the impulse given to {body}",
    "event.kick-order": "the {order} impulse given to {body}",
    "event.kick-number": "impulse {number} given to {body}",
    "event.after": "after {event}",
    "event.during": "at {event}",
    "event.due": "due to {event}",
    "event.arrival": "when {body} reaches {target}",
    # --- principles -------------------------------------------------------------------------------
    "restitution.title": "Newton's experimental law",
    "restitution.why": (
        "The speed at which two bodies separate is e times the speed at which they approached, "
        "both measured along the line of centres; e, between 0 and 1, is found by experiment. A "
        "fixed wall does not move, so there it says: speed of rebound = e × speed of approach, "
        "perpendicular to the wall."
    ),
    "momentum.title": "Conservation of momentum along the line of centres",
    "momentum.of-one": (
        "Conservation of momentum along the line of centres, as both masses are 1 kg"
    ),
    "momentum.why": (
        "The spheres push each other with equal and opposite impulses, so what one gains in "
        "momentum the other loses: the total is the same before and after. The impulses act "
        "along the line of centres, so it is in that direction that the principle tells "
        "something new."
    ),
    "unchanged-wall.title": "Parallel to {wall} the velocity does not change",
    "unchanged-wall.circle": "Along the tangent to {wall} the velocity does not change",
    "unchanged-wall.component": "the component stays {value}.",
    "unchanged-wall.component-in": "the component in the direction of {axis} stays {value}.",
    "unchanged-wall.why": (
        "The wall is smooth, so it can push the sphere only perpendicular to itself. No impulse "
        "acts along the wall, and so the component of velocity along it is the same before and "
        "after."
    ),
    "unchanged.title": "Perpendicular to the line of centres the velocities do not change",
    "unchanged.components": "the components stay {components:and}.",
    "unchanged.components-in": ("the components in the direction of {axis} stay {components:and}."),
    "unchanged.component": "{value} for {body}",
    "unchanged.each": "{value} for each",
    "unchanged.why": (
        "The spheres are smooth, so each pushes the other only along the line of centres. No "
        "impulse acts across it, and so each sphere keeps its own component in that direction. "
        "A sphere that was at rest has none, and moves off along the line of centres."
    ),
    "impulse-wall.title": "Impulse = change of momentum of {body} perpendicular to {wall}",
    "impulse-wall.why": (
        "The impulse on a body is its momentum after minus its momentum before. The wall is "
        "smooth, so only the perpendicular component changes, and it is reversed: the two sizes "
        "are added, and the impulse is m × (speed of approach + speed of rebound)."
    ),
    "impulse-spheres.title": "Impulse = change of momentum of {body} along the line of centres",
    "impulse-spheres.why": (
        "The impulse on a sphere is its momentum after minus its momentum before; on the other "
        "sphere it is equal and opposite, so either sphere will do. The spheres are smooth, so "
        "only the components along the line of centres change."
    ),
    "impulse.title": "Impulse = change of momentum of {body}",
    "impulse.why": (
        "The impulse on a body is its momentum after minus its momentum before: a vector, m(v − "
        "u), component by component. Its size is the size of that difference."
    ),
    "resolved-spheres.before": (
        "Components before the impact, along and across the line of centres:"
    ),
    "resolved-spheres.why": (
        "Along the line of centres momentum and Newton's experimental law hold; across it "
        "nothing changes. So each velocity is resolved in these two directions first, by sine "
        "and cosine or by scalar product with a unit vector."
    ),
    "resolved-wall.before": "Components before the impact, towards {wall} and parallel to it:",
    "resolved-wall.why": (
        "The two components behave differently at a wall: the one towards it is reversed and "
        "multiplied by e, the one along it stays. So the velocity is resolved in these two "
        "directions first."
    ),
    "resolved.several": "components",
    "resolved.one": "component",
    "resolved.several-products": "scalar products",
    "resolved.one-product": "scalar product",
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
        "Components before the impact, those perpendicular to the line of centres at 90° "
        "anticlockwise from the sense from {first} to {second}:"
    ),
    "resolved-wall.before-sense": (
        "Components before the impact, those parallel to {wall} in the direction of {axis}:"
    ),
    "resolved.before-vector": "{components:capital} before the impact, as {vector}:",
    "resolved.products-before": (
        "{products:capital} with {vector}, along the line of centres, before the impact:"
    ),
    "resolved.products-wall": (
        "{products:capital} with {vector}, perpendicular to {wall}, before the impact:"
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
    "resolved-axes.wall": "Components along {wall} and perpendicular to it:",
    "resolved-axes.title": "Components along the axes:",
    "resolved-spheres.after-units": "{components:capital} after the impact:",
    "resolved-wall.before-units": "{components:capital} before the impact:",
    "resolved-wall.after-units": "{components:capital} after the impact:",
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
        "Let {along} be the unit vector along the radius, towards {wall}, and {across} the one "
        "along the tangent."
    ),
    "units.along-circle": "Let {along} be the unit vector along the radius, towards {wall}.",
    "units.across-circle": "Let {across} be the unit vector along the tangent to {wall}.",
    "units.along-normal": "Let {along} be a unit vector perpendicular to {wall}.",
    "units.along-wall": "Let {along} be the unit vector perpendicular to {wall}, towards it.",
    "units.across-wall": "Let {across} be the unit vector parallel to {wall}.",
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
    "offset.letter": (
        "At the impact the centres are {apart} apart, and the centre of {other} is {beside}. "
        "Let {letter} be the angle between the line of centres and that path:"
    ),
    "offset.none": (
        "At the impact the centre of {other} is on {path}. So the line of centres is along that "
        "path:"
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
        "A chord subtends 180° less twice its angle with the radii at the centre, and the three "
        "subtend 360°, so their three angles make 90°"
    ),
    "round.same": (
        "As each impact is perfectly elastic, it leaves the angle with the radius as it was. So "
        "all three chords make the same angle with the radii at their ends: {angle}, that of the "
        "first chord with the radius at the start. Each subtends {span} at the centre, and the "
        "three subtend 360°:"
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
    "derived.chord": "length of the chord",
    "chord.why": (
        "The radius to the point of impact is perpendicular to the wall there. Two radii and "
        "the path between their ends form an isosceles triangle, so the path makes the same "
        "angle with the radius where it arrives as where it set out. Where that angle is φ, the "
        "path is 2r cos φ long."
    ),
    "impulse-line.why": (
        "The spheres are smooth, so each pushes the other along the line through their centres. "
        "The impulse is mass × change of velocity; so the change in one sphere's velocity "
        "points along the line of centres, and finds it."
    ),
    "impulse-normal.why": (
        "A smooth wall pushes only perpendicular to itself. The impulse is mass × change of "
        "velocity; so the change of the velocity is perpendicular to the wall, and tells how "
        "the wall runs."
    ),
    "changed-spheres.why": (
        "The spheres are smooth, so the impulse is along the line of centres, and so is the change "
        "of each velocity. What is added to the velocity before is the change of its component "
        "along that line, times the unit vector of the line."
    ),
    "changed-wall.why": (
        "A smooth wall pushes only perpendicular to itself, so the velocity changes in that "
        "direction alone. What is added to the velocity before is the change of its component "
        "in that direction, times the unit vector."
    ),
    "moves-off.why": (
        "Whatever momentum a sphere at rest receives comes from the impulse, and the impulse "
        "acts along the line of centres. So that is the way in which it moves off."
    ),
    "loss-spheres.why": (
        "Kinetic energy is ½m × (sum of the squares of the components). Those across the line "
        "of centres stay, so what is lost comes from those along it, of both spheres."
    ),
    "loss-wall.why": (
        "Kinetic energy is ½m × (sum of the squares of the components). The one along the wall "
        "stays, so what is lost comes from the perpendicular one alone: ½m × (its square before "
        "− its square after)."
    ),
    "turned-wall.why": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after. The path comes in at one angle to the wall and leaves at another on "
        "the same side: the sphere is turned through both, one after the other."
    ),
    "turned-wall.sum": (
        "{body} turns through the sum of the angles that its path makes with {wall} before and "
        "after:"
    ),
    "turned.on": (
        "Along the line of centres {body} keeps its sense, so it turns through the difference of "
        "its angles to that line:"
    ),
    "turned.back": (
        "Along the line of centres {body} is sent back, so it turns through 180° less both its "
        "angles to that line:"
    ),
    "turned.on-or-across": (
        "Along the line of centres {body} keeps its sense, or has no velocity if {at}, so it turns "
        "through the difference of its angles to that line:"
    ),
    "turned.back-or-across": (
        "Along the line of centres {body} is sent back, or has no velocity if {at}, so it turns "
        "through 180° less both its angles to that line:"
    ),
    "turned.on-as": (
        "As {reason}, {body} keeps its sense along the line of centres, so it turns through "
        "the difference of its angles to that line:"
    ),
    "turned.back-by": (
        "As {reason}, {body} is sent back along the line of centres, so it turns through 180° "
        "less both its angles to that line:"
    ),
    "turned.on-or-across-as": (
        "As {reason}, {body} keeps its sense along the line of centres, or has no velocity "
        "along it if {at}, so it turns through the difference of its angles to that line:"
    ),
    "turned.back-or-across-by": (
        "As {reason}, {body} is sent back along the line of centres, or has no velocity along "
        "it if {at}, so it turns through 180° less both its angles to that line:"
    ),
    "turned.sign": "{sign} (since {bound})",
    "turned.back-as": (
        "If {body} kept its sense along the line of centres, it would turn through less than "
        "{turn}. So it is sent back, and turns through 180° less both its angles to that line:"
    ),
    "turned.square": (
        "{body} leaves at right angles to the line of centres, so it turns through 90° less its "
        "first angle to that line:"
    ),
    "turned.from-square": (
        "{body} comes at right angles to the line of centres, so it turns through 90° less its "
        "new angle to that line:"
    ),
    "turned.from-axis": (
        "{body} came in the direction of {axis}, so the angle of deflection is the one between "
        "{velocity} and {axis}:"
    ),
    "turned.directions": (
        "{body} turns through the difference of its directions before and after:"
    ),
    "turned-wall.straight": "{body} hits {wall} at right angles, so it is sent straight back:",
    "turned-wall.straight-as": (
        "{body} hits {wall} at right angles and {bound}, so it is sent straight back:"
    ),
    "turned-wall.along": (
        "{body} goes on along {wall}, so it turns through the angle that its path made with "
        "{wall} before:"
    ),
    "kept.angle": (
        "{wall} is perfectly elastic, so the path of {body} makes the same angle with it after the "
        "impact as before:"
    ),
    "next-wall.angle": "The angle that the path makes with {next}, by the one with {wall}:",
    "turned.straight": "{body} is sent straight back along the line of centres:",
    "turned.from": (
        "{body} turns through the difference of the angles that its velocities make with {axis}:"
    ),
    "turned.pushed-away": (
        "The impulse on {body} is in the direction of {back}, so {body} turns away from {axis}, "
        "through the difference of the angles that its velocities make with {axis}:"
    ),
    "turned.pushed-towards": (
        "The impulse on {body} is in the direction of {axis}, so {body} turns towards {axis}, "
        "through the difference of the angles that its velocities make with {axis}:"
    ),
    "between.line": "{body} moves along the line of centres:",
    "between.line-back": (
        "{one} moves along the line of centres, and {other} the opposite way along it:"
    ),
    "same.angle": (
        "The component of {velocity} along {axis} is not negative, so it is the same angle:"
    ),
    "same.line": (
        "The line of centres is parallel to {axis}, and no component of {velocity} is negative, so "
        "it is the same angle:"
    ),
    "same.parallel": "{wall} is parallel to the line of centres, so it is the same angle:",
    "same.wall": "{wall} is along {axis}, so it is the same angle:",
    "between.from": (
        "{bodies:and} move to the same side of the line of centres, so the angle between their "
        "velocities is the difference of those that they make with {axis}:"
    ),
    "between.opposite-sides": (
        "{bodies:and} move to opposite sides of the line of centres, the same way along it:"
    ),
    "between.one-side": (
        "{bodies:and} move to the same side of the line of centres, the same way along it:"
    ),
    "between.opposite-senses": (
        "{bodies:and} move to the same side of the line of centres, opposite ways along it:"
    ),
    "between.both-opposite": (
        "{bodies:and} move to opposite sides of the line of centres, opposite ways along it:"
    ),
    "between.right": (
        "One of {bodies:and} moves along the line of centres, the other at right angles to it:"
    ),
    "between.right-of": (
        "{one} moves along the line of centres, and {other} at right angles to it:"
    ),
    "between.beside-same": (
        "{one} moves at right angles to the line of centres, and {other} to the same side of it:"
    ),
    "between.beside-opposite": (
        "{one} moves at right angles to the line of centres, and {other} to the opposite side of "
        "it:"
    ),
    "between.square-same": (
        "One of {bodies:and} moves at right angles to the line of centres, both to the same side:"
    ),
    "between.square-opposite": (
        "One of {bodies:and} moves at right angles to the line of centres, the other to the "
        "opposite side:"
    ),
    "turned.why": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after: by how much the path has turned. It is found by scalar product, or "
        "from the angles that both velocities make with one line."
    ),
    "flight.why": (
        "Between impacts nothing acts on a sphere on a smooth table, so its velocity stays the "
        "same: distance = speed × time, for each component by itself."
    ),
    # --- letters and axes -------------------------------------------------------------------------
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
    "collide-again.if": (
        "{one} and {other} collide again if the gap between them along the line of centres closes:"
    ),
    "collide-again.unless": (
        "{one} and {other} do not collide again if the gap between them along the line of "
        "centres does not close:"
    ),
    "collide-again.why": (
        "After an impact the spheres separate. They meet again only if the one behind, after "
        "what happened in between, moves faster along the line than the one in front: it is "
        "velocities with their signs that are compared, and not speeds."
    ),
    "meeting.towards": "{body} hits {wall}{again} if it moves towards {wall}.",
    "meeting.away": "{body} does not hit {wall}{again} if it does not move towards {wall}.",
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
    # --- given facts ------------------------------------------------------------------------------
    "given.data": "It is given that",
    "given.turned-wall": "{body} moves at {angle} to {wall}.",
    "given.along-centres": (
        "{body} moves towards {wall} at {angle} to it, that is at {direction} to {unit}: along the "
        "line of centres."
    ),
    "given.turned-centres": "{body} moves at {angle} to the line of centres.",
    "given.tangent": "An angle with tangent {value} has sine {sine} and cosine {cosine}.",
    "given.sine": "An angle with sine {value} has cosine {cosine}.",
    "given.cosine": "An angle with cosine {value} has sine {sine}.",
    "given.fact-along": ("It is given that {fact}, and {body} moves along the line of centres:"),
    "given.fact-across": (
        "It is given that {fact}, and {body} moves perpendicular to the line of centres:"
    ),
    "given.fact-from-rest": (
        "It is given that {fact}. {body} was at rest, so it moves along the line of centres:"
    ),
    "given.fact": "It is given that {fact}:",
    "given.fact-across-wall": (
        "It is given that {fact}. Half the mass cancels, and the component parallel to {wall} does "
        "not change:"
    ),
    "given.fact-without-mass": "It is given that {fact}. Half the mass cancels:",
    "given.fact-from": "It is given that {fact}. So from {equations:and}:",
    "given.fact-sense": "It is given that {fact}, and {sense}, as {bound}:",
    "given.and": "It is given that {fact}.",
    "given.velocities": "It is given that {facts:and}.",
    "given.turned": (
        "It is given that {facts:and}. The velocity, from its magnitude and direction:"
    ),
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
    "product.plain": "the scalar product",
    "product.of-a-turn": "the scalar product of the velocities before and after",
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
    "axes.away": (
        "Take {along} {sense} in which {body} first moves along {wall}, and {across} away from "
        "{wall}."
    ),
    "axes.towards": (
        "Take {along} {sense} in which {body} first moves along {wall}, and {across} towards "
        "{wall}."
    ),
    "axes.with": "in the direction",
    "axes.against": "opposite to the direction",
    "sense.approach": "{one} and {other} approach each other along {vector}:",
    "sense.approach-as": "As {reason}, {one} and {other} approach each other along {vector}:",
    "sense.into": "As {reason}, {vector} is towards {wall}.",
    "sense.turned-into": "As {reason}, the opposite sense is towards {wall}:",
    "sense.opposite": (
        "The impulse on {body} acts away from {other}, and the direction from {body} to {other} is "
        "opposite to it:"
    ),
    "sense.opposite-wall": (
        "The impulse on {body} acts away from {other}, and the normal towards {other} is opposite "
        "to it:"
    ),
    "sense.away": "The impulse on {body} acts in the direction from {other} to {body}:",
    "sense.of-line": "the direction from {one} to {two} is that of {vector}",
    "sense.of-normal": "the normal towards {wall} is in the direction of {vector}",
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
    "centres.between": "From the centre of {one} to the centre of {other}:",
    # --- equations solved -------------------------------------------------------------------------
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
    # --- places and times -------------------------------------------------------------------------
    "turned-velocity.title": "The velocity, from its magnitude and direction",
    "turned-velocity.why": (
        "The angle of deflection is the angle between the directions before and after. From the "
        "direction before it gives the direction after, to one side or the other. With the speed "
        "it gives the velocity, by a cosine and a sine."
    ),
    "either-side.why": (
        "The data give an angle, or its tangent, and not the side on which it lies. A reflection "
        "of everything in the known direction keeps all data and moves the line to the other "
        "side. So both are answers, and one of them is worked out."
    ),
    "either-side.wall": (
        "{wall} may slope to either side of 𝐢, and the other figure is the reflection in 𝐢"
    ),
    "either-side.title": (
        "The line of centres may be on either side of 𝐢, and the other figure is the reflection "
        "in 𝐢"
    ),
    "sided.wall": "Take {wall} to be turned anticlockwise from 𝐢.",
    "sided.wall-unit": ("Then {along} is the unit vector perpendicular to {wall}, towards it."),
    "sided.spheres-unit": "Then {along} is the unit vector along it.",
    "sided.wall-units": (
        "Then {along} is the unit vector perpendicular to {wall}, towards it, and {across} the "
        "one along it."
    ),
    "sided.spheres": "Take the line of centres to be turned anticlockwise from 𝐢.",
    "sided.spheres-units": (
        "Then {along} is the unit vector along it, and {across} the one perpendicular to it."
    ),
    "restitution.none": "Newton's experimental law, as the coefficient of restitution is 0",
    "restitution.products": "Newton's experimental law, by scalar products with this vector",
    "restitution.products-with": "Newton's experimental law, by scalar products with {vector}:",
    "moves-along.title": "{body} moves along the line of centres",
    "moves-along.from-rest": "{body} was at rest, so it moves along the line of centres",
    "moves-along.why": (
        "Smooth spheres push each other along the line of centres only. A sphere that has no "
        "velocity across that line before the impact has none after it. So it moves along the "
        "line, and its speed is the size of its one component."
    ),
    "moves-off.title": "{body} was at rest, so it moves off along the line of centres",
    "beside.title": "The centres are two radii apart, along the line of centres",
    "beside.why": (
        "When two equal spheres touch, the distance of their centres is twice the radius. So the "
        "place of the one is that of the other, and two radii along the line of centres."
    ),
    "momentum-of.title": "Momentum = mass × velocity",
    "momentum-of.why": (
        "Momentum is a vector, the velocity times the mass. That of several bodies is the sum of "
        "theirs."
    ),
    "touch.place": (
        "{one} and {other} touch when their centres are two radii apart, on the line of centres:"
    ),
    "touch.level": (
        "The line of centres is parallel to {axis}, so at the impact the {coordinate}-coordinates "
        "are equal:"
    ),
    "touch.along": (
        "At the impact the {coordinate}-coordinate of {more} is greater than that of {less} by two "
        "radii, as {approach}:"
    ),
    "touch.comes": "{one} comes towards {other} in the direction of {axis}",
    "touch.gains": "{one} gains on {other} in the direction of {axis}",
    "contact.wall": "{body} is then on the line of {wall}:",
    "contact.wall-line": "{body} is then on the line of {wall}, {line}:",
    "circle.at": "{body} is then at a distance {radius} from the centre of {wall}:",
    "circle.centre-at": (
        "The centre of {body} is then at a distance {radius} from the centre of {wall}:"
    ),
    "circle.first": "{body} reaches that point first",
    "circle.ahead": "{body} is moving in the direction of {axis}",
    "circle.towards": "{body} is moving towards {wall} then",
    "touch.towards": "{one} and {other} are approaching then",
    "touch.wall": (
        "At the impact with {wall} the centre of {body} is {radius} from {wall}, so its "
        "{axis}-coordinate is {value}."
    ),
    "touch.spheres": (
        "{one} approaches {other} in the direction of {way}, and at the impact their centres are "
        "{distance} apart. So {other} is then at {place}."
    ),
    "touch.gap": "When {one} and {other} touch, their centres are {distance} apart.",
    "touch.at": "The {position} is {place}.",
    "touch.origin": "The {position} is the origin.",
    "touch.meet": "{one} and {other} meet when their coordinates are equal:",
    "touch.apart": "{one} and {other} touch when their centres are {distance} apart:",
    # --- conditions, ranges, extrema --------------------------------------------------------------
    "meeting.collide": (
        "{one} and {other} collide again if the gap between them along the line of centres closes."
    ),
    "meeting.apart": (
        "{one} and {other} do not collide again if the gap between them along the line of "
        "centres does not close."
    ),
    "range.every": "So every value of {letter} is possible:",
    "range.every-free": "No condition bounds {letter}, so every value of it is possible:",
    "range.every-holds": "This always holds, so every value of {letter} is possible:",
    "extremum.value": "When {places:or}, {value}. The difference from that value is",
    "extremum.value-there": "When {places:or}, {value}.",
    "extremum.at-zero": "{square}, so {place}",
    "extremum.at-zero-angle": "{square}, so {place} and {angle}",
    "extremum.at-zero-sine": "{square}, so {tangent}, {sine} and {offset}",
    "extremum.by-sine": "{place}, so {offset}",
    "extremum.at-angle": "{place}, so {angle}",
    "extremum.with": "{place} and so {other}",
    "extremum.approached": "as {place}: a bound that is approached and not reached",
    "extremum.no-greatest": "as {place}, so there is no greatest value",
    "extremum.no-least": "as {place}, so there is no least value",
    # --- results that are shown, or are false -----------------------------------------------------
    "shown.required": "as required",
    "shown.figures": "to {figures} s.f.",
    "shown.claim": "So {claim}, as required.",
    "claim.perpendicular": "{left} is perpendicular to {right}",
    "claim.parallel": "{left} is parallel to {right}",
    "claim.same-direction": "{left} is in the direction of {right}",
    "claim.as": "{claim}, since {reason}",
    "claim.unless-at-rest": "{claim} unless {body} is at rest",
    "claim.opposite": "{left} is opposite to {right}",
    "claim.not-perpendicular": "{left} is not perpendicular to {right}",
    "claim.not-parallel": "{left} is not parallel to {right}",
    "claim.not-same-direction": "{left} is not in the direction of {right}",
    "claim.not-opposite": "{left} is not opposite to {right}",
    "claim.rest": "{body} is at rest",
    "claim.collide": "{one} and {other} collide{again}",
    "claim.hits": "{body} hits {wall}{again}",
    "claim.does-not-hit": "{body} does not hit {wall}{again}",
    "claim.not-collide": "{one} and {other} do not collide{again}",
    "claim.will-collide": "{one} and {other} will collide{again}",
    "claim.will-not-collide": "{one} and {other} will not collide{again}",
    "claim.will-hit": "{body} will hit {wall}{again}",
    "claim.will-not-hit": "{body} will not hit {wall}{again}",
    "refuted.rest": "{body} is not at rest: {velocity}.",
    "refuted.direction": "{claim}.",
    "refuted.no-multiple": "{claim}, as {left} is not a multiple of {right}.",
    "refuted.direction-as": "{claim}, as {relation}.",
    "refuted.direction-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}."
    ),
    "refuted.bearing-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}, {bearing}."
    ),
    "refuted.same-direction": "which are in the same direction",
    "refuted.opposite-direction": "which are in opposite directions",
    "refuted.no-multiple-of": "and neither is a multiple of the other",
    "refuted.in-direction-of-one": "which is in the direction of {other}",
    "refuted.opposite-to-one": "which is opposite to {other}",
    "refuted.no-multiple-of-one": "which is not a multiple of {other}",
    "refuted.product-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}, so {product}."
    ),
    "refuted.opposite": "So {claim}, and the claim is not true.",
    "refuted.opposite-above": "It is not true that {claim}, as shown above.",
    "refuted.plainly": "It is not true that {claim}.",
    "refuted.extreme": "The {quantity} is not {claimed}.",
    "refuted.range-is": "The range of possible values is not {range}: it is {true}.",
    "refuted.range": "The range of possible values is not {range}.",
    "refuted.value": "The {quantity} is not {claimed}: it is {value}.",
    "refuted.value-differs": ("The {quantity} is not {claimed}: it is {value}, and {difference}."),
    "refuted.vector-differs": "{quantity} is not {claimed}: it is {value}, and {difference}.",
    "refuted.value-general": "The {quantity} is not {claimed} in general: it is {value}.",
    "refuted.vector": "{quantity} is not {claimed}: it is {value}.",
    "refuted.vector-general": "{quantity} is not {claimed} in general: it is {value}.",
    "refuted.claim": "It is not true that {claim}: {sides}.",
    "refuted.general": ("It is not true that {claim}: with {values:and}, for instance, {sides}."),
    "refuted.possible": "It is not true that {claim}: {letter} may be {value}.",
    "refuted.possible-when": (
        "It is not true that {claim}: {letter} is {value}, for instance, when {values:and}."
    ),
    "refuted.sides": "{sides:and}",
    "refuted.but": "{one}, but {other}",
    "refuted.less": "{sides:and}, which is less",
    "refuted.more": "{sides:and}, which is more",
    "refuted.equal": "{sides:and}, which is the same",
    "refuted.less-than": "{side}, which is less than {bound}",
    "refuted.more-than": "{side}, which is more than {bound}",
    "refuted.not-less-than": "{side}, which is not less than {bound}",
    "refuted.not-more-than": "{side}, which is not more than {bound}",
    "refuted.not-equal-to": "{side}, which is not {bound}",
    "refuted.so": "{sides:and}, so {claim}",
    "claim.gap-closes": "the gap between {one} and {other} closes",
    "claim.gap-does-not-close": "the gap between {one} and {other} does not close",
    "refuted.instance": ("It is not true that {claim}: it fails, for instance, with {values:and}."),
    "undecided.claim": (
        "It is not decided whether {claim}. It fails at none of the values of the letters that "
        "were tried, but that proves nothing."
    ),
    # --- answers ----------------------------------------------------------------------------------
    "note.none-of-two": (
        "{items:capital} cannot be found, as {reason}. That {fact} is one equation for two "
        "unknowns."
    ),
    "note.none": "{items:capital} cannot be found, as {reason}.",
    "note.idle": (
        "It is given that {fact}. That is so for all values of {items}, so {items} cannot be found."
    ),
    "note.impossible": "What is described cannot happen, as {reason}.",
    "note.unbounded": "There is no {extreme}: {reason}.",
    "note.out-of-range": "But {reasons:and}. So what is described cannot happen.",
    "note.beyond-there": (
        "From part ({label}), {relation}. But {reasons:and}. So what is described cannot happen."
    ),
    "note.no-root": "This cannot be, as {reasons:and}. So what is described cannot happen.",
    "note.unreached": "So {reason}: what is described cannot happen.",
    "note.unreached-as": "As {value}, {reason}: what is described cannot happen.",
    "note.unreached-ahead": (
        "{one} moves in the direction of {way} and hits {other}, so {other} is ahead of it. So "
        "{reason}: what is described cannot happen."
    ),
    "note.no-solution": "This has no solution. So what is described cannot happen.",
    "no-root.square": "a square is not negative",
    "no-root.unit": "{square} is at most 1",
    "no-root.least": "{ratio} is at least −1",
    "no-root.discriminant": (
        "the discriminant of this quadratic in {ratio}, {discriminant}, is negative"
    ),
    "note.impossible-above": "What is described cannot happen, as shown above.",
    "note.impossible-there": "What is described cannot happen, as part ({label}) shows.",
    "note.clash": "{reason:capital}.",
    "note.against": "But it is given that {fact}. So the data contradict each other.",
    "note.against-zero": (
        "{value} is not zero, as {reasons:and}. But it is given that {fact}. So the data "
        "contradict each other."
    ),
    "note.unwritten": "{item:capital} is {answer}. The working of this is not written out.",
    "note.unwritten-line": "The working of this is not written out:",
    "note.unwritten-line-from": "The steps from here are not written out:",
    "note.unwritten-from": "{item:capital} is {answer}. The steps from here are not written out.",
    "note.none-shown": "It cannot be shown that {items}, as {reason}.",
    "note.none-either": "{items:capital} cannot be found either, as there is no such impact.",
    "note.none-data-above-one": (
        "{items:capital} cannot be found, as a coefficient of restitution is at most 1, and not "
        "{value}."
    ),
    "note.none-data-below-zero": (
        "{items:capital} cannot be found, as a coefficient of restitution is not negative, and not "
        "{value}."
    ),
    "note.above-one": (
        "{value} is impossible, as a coefficient of restitution is at most 1. So no value of "
        "{letter} is possible."
    ),
    "note.goes-on": "What follows does not rest on {letter}.",
    "note.rests-on": "What follows is implied by what is given all the same.",
    "note.below-zero": (
        "{value} is impossible, as a coefficient of restitution is not negative. So no value of "
        "{letter} is possible."
    ),
    "note.none-above-one": (
        "{items:capital} cannot be found, as {value} is impossible: a coefficient of restitution "
        "is at most 1."
    ),
    "note.none-below-zero": (
        "{items:capital} cannot be found, as {value} is impossible: a coefficient of restitution "
        "is not negative."
    ),
    "answer.by-case": "This holds for {condition}. In all, the range is {forms:semicolon}.",
    "answer.only": "This holds for {condition} only.",
    "answer.only-at": "This holds for {condition} only: if {end}, {there}.",
    "answer.only-possible": (
        "This holds for {condition} only, as what is described cannot happen otherwise."
    ),
    "answer.both": "{first} {second}",
    "answer.value-only": "{value} holds for {condition} only.",
    "answer.value-only-as": "As {reasons:and}, {value} holds for {condition} only.",
    "range.also": "In this range {bounds:and} as well.",
    "range.both": "{one} {two}",
    "answer.only-range": (
        "This holds for {condition} only, as there is no such {letter} otherwise."
    ),
    "answer.approaching": "{one} has to move towards {two} to hit it",
    "answer.moving": "{body} is still moving at the end",
    "answer.no-value": "{place} gives no value of {letter}",
    "answer.divisor": "the divisor {divisor} is not zero",
    "range.within": "In this range {bounds:and}, so {body} hits {walls:and} between its ends too.",
    "range.within-anyway": "{body} hits {walls:and} between its ends too, as {bounds:and}.",
    "range.within-all-anyway": "{body} hits {walls:and} between their ends too, as {bounds:and}.",
    "range.within-all": (
        "In this range {bounds:and}, so {body} hits {walls:and} between their ends too."
    ),
    "answer.only-as": "As {reasons:and}, this holds for {condition} only.",
    "answer.reason": "{item}: {reason}",
    "answer.undecided": "{item}: not decided",
    "answer.outcome": "{item}: {outcomes:comma}",
    "answer.shown": "shown",
    "answer.false": "false",
    "answer.value": "{item} = {values:or}",
    # --- a working from its end -------------------------------------------------------------------
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
    # --- workings that are derivations ------------------------------------------------------------
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
    "derived.when": "{quantity} {when}",
    "derived.before": "before {event}",
    "derived.at-the-start": "at the start",
    "derived.at-time": "at time {time}",
    "derived.later": "{time} after {event}",
    "derived.later-at": "at time {time} after {event}",
    "event.start": "the start",
    "derived.of": "of {event}",
    "derived.velocity": "velocity of {bodies:and}",
    "derived.velocities": "velocities of {bodies:and}",
    "derived.meanings": "{letters:and} be the {quantity}",
    "derived.coefficient": "coefficient of restitution",
    "derived.not-negative": "a coefficient of restitution is not negative",
    "derived.at-most-one": "a coefficient of restitution is at most 1",
    "derived.of-bodies": "{noun} {of:and}",
    "derived.of-all": "{noun}",
    "derived.speed": "speed of {of:and}",
    "derived.energy": "kinetic energy",
    "derived.energy-of": "kinetic energy of {bodies:and}",
    "derived.energy-all": "total kinetic energy",
    "derived.energy-lost": "kinetic energy lost",
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
    "derived.stays": "the component of {of} stays {value}.",
    "derived.stays-in": "the component of {of} in the direction of {axis} stays {value}.",
    "derived.combine": "Eliminating {letter} from {equations:and}:",
    "derived.it-is": "it is {value} if {at}",
    "derived.no-value": "there is no {letter} if {bound}",
    "derived.add": "From {equations:and}:",
    "derived.divided": "Dividing top and bottom by {factor}:",
    "derived.negative": "the {component} is negative",
    "derived.above-zero": "the {component} is positive",
    "derived.along-unit": "{velocity} is in the direction of {unit}",
    "derived.negative-part": "{velocity} has a negative {axis}-component",
    "derived.side-of-blow": (
        "the impulse has a component in the direction of {axis}, since {bounds:and}"
    ),
    "derived.positive-part": "{velocity} has a positive {axis}-component",
    "derived.divide": "Dividing {first} by {second}:",
    "derived.square-add": "Squaring and adding {equations:and}:",
    "made.fraction-lost": "Fraction of the kinetic energy that is lost:",
    "made.percentage-lost": "Percentage of the kinetic energy that is lost:",
    "derived-speed.one": "The velocity of {body} has one component only",
    "derived-speed.along": "{body} moves along the line of centres",
    "derived-speed.along-from-rest": "{body} was at rest, so it moves along the line of centres",
    "derived-speed.kept": "{wall} is perfectly elastic, so {body} keeps its speed",
    "derived-speed.across": "{body} moves perpendicular to the line of centres",
    "derived-speed.by-cos": "Speed of {body} = component ÷ cosine of its angle",
    "derived-speed.by-sin": "Speed of {body} = component ÷ sine of its angle",
    "derived-speed.resolved": "Component of the velocity of {body}, by its speed and direction",
    "wall.beside-normal": "At right angles to the normal:",
    "made.ratio": "Taking the ratio:",
    "made.product": "Multiplying:",
    "made.difference": "Taking the difference:",
    "made.difference-of-energies": "Subtracting the energies:",
    "made.difference-of-velocities": "Subtracting the velocities:",
    "made.by-these": "With these values:",
    "derived.solve": "Solving {equations:and}:",
    "derived.solve-this": "Solving this equation:",
    "derived.formula": "By the quadratic formula:",
    "derived.multiple": "Comparing the two vectors:",
    "derived.put": "Substituting for {letters:and}:",
    "derived.put-in": "Substituting for {letters:and} in {equation}:",
    "derived.put-last": "Substituting in {equation}:",
    "derived.by": "{how:capital}:",
    "derived.by-from": "From {equations:and}, {how}:",
    "derived.gained": "kinetic energy is gained",
    "derived.both-possible": "both are possible",
    "derived.both-positive": "both are possible, as both are positive",
    "derived.both-coefficients": "both are possible, as both are between 0 and 1",
    "derived.all-possible": "all are possible",
    "derived.pythagoras": "as sin² + cos² = 1",
    "derived.double-angle": "by the formulae for the double angle",
    "derived.multiple-angle": "by the formulae for multiple angles",
    "derived.by-formula": "by the formula {formula}",
    "derived.half-angle": "by the formulae for the half angle",
    "derived.tangent-of-sum": "by the formula for the tangent of a sum",
    "derived.tangent-of-difference": "by the formula for the tangent of a difference",
    "derived.sum-of-angles": "by the formulae for a sum of angles",
    "derived.difference-of-angles": "by the formulae for a difference of angles",
    "derived.complement": "by the complement of the angle",
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
    "derived.same": "the {quantity} is equal to the {value}",
    "derived.share": "the {quantity} is {share} of the {value}",
    "derived.times": "the {quantity} is {share} times the {value}",
    "derived.since": "Since {facts:and}:",
    "derived.anyway": "{fact} in any case.",
    "derived.anyway-as": "{fact} in any case, as {ground}.",
    "derived.pushed-from-rest": "{body} was at rest and is pushed away from {other}",
    "derived.pushed": (
        "{body} had no component along the line of centres and is pushed away from {other}"
    ),
    "derived.moving": "{body} moves in the direction of {way}",
    "derived.moves": "{body} moves in the direction of {way}, so {fact}:",
    "derived.moves-put": (
        "{body} moves in the direction of {way}, so {fact}. Substituting for {letters:and}:"
    ),
    "derived.since-put": "Since {facts:and}, substituting for {letters:and}:",
    "derived.since-put-in": ("Since {facts:and}, substituting for {letters:and} in {equation}:"),
    "derived.since-in": "Since {facts:and}, from {equations:and}:",
    "derived.since-by": "Since {facts:and}, {how}:",
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
    "derived.the": "the {quantity}",
    "derived.divided-by": "Dividing by {factor}:",
    "derived.cancel": "Dividing by {factor}, which is not zero as {reasons:and}:",
    "derived.cancel-positive": "Dividing by {factor}, which is positive as {reasons:and}:",
    "derived.cancel-by": (
        "Dividing {first} by {factor}, which is not zero by {equations:and}, as {reasons:and}:"
    ),
    "derived.either": "{values:or}",
    "derived.both": "{values:and}",
    "derived.for": "when {places:or}",
    "derived.from-then": "for {time}",
    "derived.acute": "{angle} is acute",
    "derived.half-acute": "{bound} since {angle} is acute",
    "derived.both-acute": "{angles:and} are acute",
    "derived.every-positive": ("and it takes every positive value as {angle} goes from 0° to 90°"),
    "derived.so-acute": "so {angle} is acute",
    "derived.acute-by-tangent": "{bound} and so {angle} is acute",
    "derived.positive": "{letter} is positive",
    "derived.cannot-be-negative": "{letter} cannot be negative",
    "derived.cannot-exceed-one": "{letter} cannot exceed 1",
    "derived.given": "this is given",
    "derived.fact": "{fact}",
    "derived.fact-equal": "{fact}, with equality when {place}",
    "derived.items": "{items:and}",
    "derived.increases": "{quantity} increases with {letter}",
    "derived.slope": "the derivative of {quantity} with respect to {letter} is {slope}",
    "derived.its": "{quantity} ",
    "derived.tends-to": "{first}tends to {value} as {letter} → {end}",
    "derived.squared": "neither side is negative",
    "derived.tends": "{first}tends to {value} as {letter} grows",
    "derived.decreases": "{quantity} decreases as {letter} increases",
    "derived.number": "({number})",
    "derived.greatest": "greatest value of {quantity}",
    "derived.least": "least value of {quantity}",
    "derived.greatest-named": "greatest {quantity}",
    "derived.least-named": "least {quantity}",
    "momentum.vectors": "Conservation of momentum",
    "changed-spheres.title": "The velocity changes along the line of centres only",
    "changed-wall.title": "The velocity changes perpendicular to {wall} only",
    "impulse-line.title": (
        "The impulse, and so the change of velocity, is along the line of centres"
    ),
    "impulse-normal.title": (
        "The impulse, and so the change of velocity, is perpendicular to {wall}"
    ),
    "turned.by-directions": "Difference of the directions from 𝐢",
    "turned.title": "Angle of deflection",
    "turned.signs": "{velocity} has {components:and}:",
    "turned.negative": "a negative component in the direction of {axis}",
    "turned.positive": "a positive component in the direction of {axis}",
    "turned.not-positive": "no positive component in the direction of {axis}",
    "turned.not-negative": "no negative component in the direction of {axis}",
    "turned.not-acute": "The scalar product is not positive, so the angle is not acute:",
    "turned.not-obtuse": "The scalar product is not negative, so the angle is not obtuse:",
    "turned.obtuse": "The scalar product is negative, so the angle is obtuse:",
    "turned.acute": "The scalar product is positive, so the angle is acute:",
    "turned.products": (
        "Tangent of the angle between two velocities = size of their vector product ÷ their scalar "
        "product"
    ),
    "turned.products-over": (
        "Cotangent of the angle between two velocities = their scalar product ÷ size of their "
        "vector product"
    ),
    "turned-wall.title": "Angle of deflection",
    "loss-spheres.title": "Kinetic energy lost, by the components that change",
    "energy-ratio.title": "Ratio of the kinetic energies, in which half the mass cancels",
    "energy-ratio.why": (
        "The kinetic energy of one body is half its mass times the square of its speed. In the "
        "ratio of two of its energies half the mass cancels, and the squares of its speeds are "
        "left."
    ),
    "fraction-lost.title": "Fraction of the kinetic energy that is lost, in which the mass cancels",
    "fraction-lost.percentage": (
        "Percentage of the kinetic energy that is lost, in which the mass cancels"
    ),
    "fraction-lost.at-a-wall": (
        "Fraction of the kinetic energy that is lost, by the component that changes, as the mass "
        "cancels"
    ),
    "fraction-lost.percentage-at-a-wall": (
        "Percentage of the kinetic energy that is lost, by the component that changes, as the mass "
        "cancels"
    ),
    "fraction-lost.why": (
        "The kinetic energy of one body is half its mass times the square of its speed. Where one "
        "body loses energy, half its mass stands above and below in the fraction that is lost, and "
        "squares of speeds are left."
    ),
    "change-of-energy.title": "Change of kinetic energy, by the component that changes",
    "loss-wall.title": "Kinetic energy lost, by the component that changes",
    "flight.title": "Distance = speed × time",
    "flight.title-of": "Distance = speed × time, for {body}",
    "flight.displacement": "Displacement = velocity × time",
    "flight.displacement-of": "Displacement = velocity × time, for {body}",
    "distance.relative": "Distance apart = relative speed × time",
    "distance.level": (
        "Perpendicular to the line of centres {one} and {other} keep level, so distance apart = "
        "relative speed along it × time"
    ),
    "distance.why": (
        "The distance of two points follows from their coordinates by Pythagoras. Two bodies that "
        "were together and move on at constant velocities are apart by the size of their relative "
        "velocity times the time since."
    ),
    "distance.along-one": "The positions differ in their {axis}-coordinates alone",
    "distance.displacements": "Distance, by Pythagoras",
    "distance.coordinates": "Distance, from the coordinates",
    "flight.several-ways": "Time = distance ÷ {speed}, which no impact in between changes",
    "flight.whole-way": "Time = distance ÷ {speed}, which no impact changes",
    "flight.between-impacts": "As {times}, {body} is then between {one} and {other}:",
    "flight.past-one": "Time = distance ÷ {speed}, which the impact with {other} does not change",
    "flight.closing": "Time = gap ÷ speed at which it closes",
    "flight.time": "Time = distance ÷ {speed}",
    "flight.time-of": "Time = distance ÷ {speed}, for {body}",
    "flight.speed": "speed",
    "flight.speed-along": "speed parallel to the {axis}-axis",
    "flight.speed-across-wall": "speed perpendicular to {wall}",
    "flight.speed-along-wall": "speed parallel to {wall}",
    "flight.speed-there": "speed in that direction",
    "flight.at-once": "{bodies:and} are at one place at the start",
    "flight.rest": "{body} is at rest, so it stays where it is",
    "flight.rest-beside": "{body} is at rest, so it stays where it touched {other}",
    "flight.origin-taken": (
        "Position = velocity × time, for {body}, with the origin where {body} is at the impact"
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
    "derived-energy.title": "Kinetic energy",
    "change-of-energy.why": (
        "The component that does not change adds the same to the kinetic energy before and after, "
        "so only the component along the line of centres counts. The energy after is put first: "
        "what is lost is negative."
    ),
    "derived-energy.why": (
        "Kinetic energy is half the mass times the square of the speed, and that square is the sum "
        "of the squares of the components. It has no direction: the energies of several bodies "
        "are added."
    ),
    "derived-direction.title": "Direction of motion",
    "derived-direction.why": (
        "The components are the two shorter sides of a right-angled triangle, of which the "
        "velocity is the longest. So the tangent of the angle that it makes with a line is the "
        "component across the line divided by the component along it."
    ),
    "derived-speed.title": "Speed, from its components",
    "derived-energy.speed": "Speed, from the kinetic energy",
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
    "derived-perpendicular.title": (
        "The directions are perpendicular, so the scalar product is zero"
    ),
    "derived-perpendicular.why": (
        "Two directions are at right angles exactly if their scalar product is zero: the product "
        "of the components along one line, added to the product of those across it. Neither "
        "angles nor sizes are needed."
    ),
    "derived.along-earlier-centres": "{body} moves along the line of centres of {event}:",
    "derived.along-centres": "{body} moves along the line of centres:",
    "derived.each-along": "{bodies:and} each move along the line of centres of their impact:",
    "derived.each-from-rest": (
        "{bodies:and} were at rest, so each moves along the line of centres of its impact:"
    ),
    "derived.along-centres-from-rest": (
        "{body} was at rest, so it moves along the line of centres:"
    ),
    "derived.across-centres-with": (
        "{body} moves perpendicular to the line of centres, where its component is {value}:"
    ),
    "derived.across-centres": "{body} moves perpendicular to the line of centres:",
    "derived.turned-square": "{body} came parallel to {first} and leaves parallel to {second}. So",
    "derived.axes-apart": "{one} moves parallel to {first}, and {other} parallel to {second}. So",
    "derived.apart-from-rest": (
        "{one} moves perpendicular to the line of centres, and {other}, which was at rest, along "
        "it. So"
    ),
    "derived.apart": ("{one} moves perpendicular to the line of centres, and {other} along it. So"),
    "derived.along-line": "{body} moves parallel to {line}:",
    "derived.across-line": "{body} moves perpendicular to {line}:",
    "derived.line-at": "The line of centres is at {angle} to {axis}:",
    "derived.along-the-path": "The path is in the direction of the velocity:",
    "derived.turned-clockwise": (
        "The impulse on {body} acts along the line of centres, away from {other}, so {body} is "
        "turned clockwise:"
    ),
    "derived.turned-anticlockwise": (
        "The impulse on {body} acts along the line of centres, away from {other}, so {body} is "
        "turned anticlockwise:"
    ),
    "derived.along-axis": "{body} moves in the direction of {axis}:",
    "derived.off-along-axis": (
        "{body} was at rest, so it moves off along the line of centres, in the direction of {axis}:"
    ),
    "derived-parallel.title": "In one direction, the components are in the same ratio",
    "derived-parallel.why": (
        "Two vectors are parallel if one is a number times the other. Then that number is the "
        "ratio of their components in every direction, and the products crosswise are equal."
    ),
    "derived-product.along": "Scalar product with a vector along {wall}",
    "derived-product.title": "Scalar product",
    "derived-product.why": (
        "The scalar product of two vectors is the sum of two products: of their components in one "
        "direction, and of those at right angles to it. It is a number, and no vector."
    ),
    "derived-between.title-of": "Angle between {one} and {other}, by the scalar product:",
    "derived-between.title-along": (
        "Angle between {one} and {other}, by the scalar product of {first} and {second}, which are "
        "in their directions:"
    ),
    "derived-between.title-turned-along": (
        "Angle between the velocities before and after, by the scalar product of {first} and "
        "{second}, which are in their directions:"
    ),
    "derived-between.title-turned": (
        "Angle between the velocities before and after, by the scalar product:"
    ),
    "derived-between.title": "By the scalar product",
    "derived-between.why": (
        "The scalar product of two vectors is the product of their sizes and of the cosine of the "
        "angle between them. So the cosine is the scalar product divided by both sizes."
    ),
    "derived-place.title": "Position, from its coordinates",
    "derived-place.why": (
        "A position on the table is fixed by its two coordinates. Each is found by itself, as the "
        "motion in one direction does not depend on that in the other."
    ),
    "derived-assembled.still": "{body} takes no part in {event}, so its velocity is still",
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
    "derived-opposite.title": "The impulses on the two spheres are equal and opposite",
    "derived-opposite.change": (
        "The impulse on {one} is opposite to that on {other}, which is the change of momentum of "
        "{other}"
    ),
    "derived-opposite.why": (
        "While they touch, each sphere pushes the other with the same force, in opposite "
        "directions and for the same time. So the impulses are equal and opposite, whatever the "
        "masses are."
    ),
    # --- what is amiss ----------------------------------------------------------------------------
    "amiss.complaint": "the working does not follow: {complaint}",
    "amiss.pictures": "the pictures could not be drawn, by a fault of the program",
    # --- what a mark is given for -----------------------------------------------------------------
    "mark.method": "a principle or a method, with its values put in",
    "mark.accuracy": "the line or the answer is right",
    "mark.independent": "right by itself: it needs no method",
    "mark.dependent": "a method that rests on an earlier method of the same part",
    "mark.follow-through": "right for the values found before, even if a slip was made there",
    "mark.printed": "the printed result, reached without a gap",
}
"""What a worked solution says, by the id of the sentence."""
