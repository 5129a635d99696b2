"""Directions of motion and of lines, angles between them, and deflections."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "turned-wall.why": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after. The path comes in at one angle to the wall and leaves at another on "
        "the same side: the sphere is turned through both, one after the other."
    ),
    "turned-wall.sum": (
        "{body} turns through the sum of the angles that its path makes with {wall} before and "
        "after:"
    ),
    "turned-wall.straight": "{body} hits {wall} at right angles, so it is sent straight back:",
    "turned-wall.straight-as": (
        "{body} hits {wall} at right angles and {bound}, so it is sent straight back:"
    ),
    "turned-wall.along": (
        "{body} goes on along {wall}, so it turns through the angle that its path made with "
        "{wall} before:"
    ),
    "turned-wall.title": "Angle of deflection",
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
        "If {body} kept its sense along the line of centres, it would turn through the difference "
        "of its angles to that line, which is less than {turn}. So it is sent back, and turns "
        "through 180° less both these angles:"
    ),
    "turned.square": (
        "{body} leaves at right angles to the line of centres, so its angle to that line before "
        "and the angle of deflection add up to 90°:"
    ),
    "turned.from-square": (
        "{body} comes at right angles to the line of centres, so its angle to that line after and "
        "the angle of deflection add up to 90°:"
    ),
    "turned.from-axis": (
        "{body} came in the direction of {axis}, so the angle of deflection is the one between "
        "{velocity} and {axis}:"
    ),
    "turned.directions": (
        "{body} turns through the difference of its directions before and after:"
    ),
    "turned.straight-on": (
        "{body} goes on along the line of centres in the same sense, so it is not turned:"
    ),
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
    "turned.why": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after: by how much the path has turned. It is found by scalar product, or "
        "from the angles that both velocities make with one line."
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
    "turned.on-one-line": (
        "{body} moves along one line before and after the impact, so it goes straight on or "
        "straight back"
    ),
    "turned.products-over": (
        "Cotangent of the angle between two velocities = their scalar product ÷ size of their "
        "vector product"
    ),
    "next-wall.angle": (
        "The angle between the path and {next}, from that between the path and {wall}:"
    ),
    "from-wall.direction": "{wall} is at {angle} to {axis}. Direction of motion:",
    "from-wall.clockwise": (
        "{wall} is at {angle} to {axis}, and {body} leaves it on the side from which it came, "
        "clockwise of {wall}. Direction of motion:"
    ),
    "from-wall.anticlockwise": (
        "{wall} is at {angle} to {axis}, and {body} leaves it on the side from which it came, "
        "anticlockwise of {wall}. Direction of motion:"
    ),
    "from-wall.direction-back": (
        "{wall} is at {angle} to {axis}, and {body} moves the opposite way along it. Direction of "
        "motion:"
    ),
    "next-wall.between": (
        "{wall} and {next} meet at {angle}. The angle between the path and {next}:"
    ),
    "next-wall.exterior": (
        "{wall} and {next} meet at {angle}. Exterior angle of the triangle that they make with the "
        "path:"
    ),
    "next-wall.exterior-before": (
        "{wall} and {next} meet at {angle}. The angle between the path and {wall} is an exterior "
        "angle of the triangle that they make with the path:"
    ),
    "next-wall.corner": (
        "{wall} and {next} meet at {angle}. Third angle of the triangle that they make with the "
        "path:"
    ),
    "between.line": "{body} moves along the line of centres:",
    "between.line-back": (
        "{one} moves along the line of centres, and {other} the opposite way along it:"
    ),
    "between.from": (
        "{bodies:and} move to the same side of the line of centres, so the angle between their "
        "velocities is the difference of those that they make with {axis}:"
    ),
    "between.multiples": "{left} is in the direction of {right}:",
    "between.negative-multiples": "{left} is opposite to {right}:",
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
    "between.along-same": "{bodies:and} both move along the line of centres, the same way:",
    "between.along-opposite": "{bodies:and} both move along the line of centres, opposite ways:",
    "between.along-same-as": (
        "As {reasons:and}, {bodies:and} move along the line of centres, the same way:"
    ),
    "between.along-opposite-as": (
        "As {reasons:and}, {bodies:and} move along the line of centres, opposite ways:"
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
    "same.angle": (
        "The component of {velocity} along {axis} is not negative, so the two angles are equal:"
    ),
    "same.line": (
        "The line of centres is parallel to {axis}, and no component of {velocity} is negative, so "
        "the two angles are equal:"
    ),
    "same.parallel": "{wall} is parallel to the line of centres, so the two angles are equal:",
    "same.one-letter": (
        "{wall} is parallel to the line of centres, so the angle between {velocity} and that line "
        "is {angle} too."
    ),
    "same.letter-of-axis": (
        "{wall} is along {axis}, so the angle between {velocity} and {wall} is {angle} too."
    ),
    "same.wall": "{wall} is along {axis}, so the two angles are equal:",
    "product.plain": "the scalar product",
    "product.of-a-turn": "the scalar product of the velocities before and after",
    "axes.away": (
        "Take {along} parallel to {wall}, {sense} in which {body} first moves, and {across} away "
        "from {wall}."
    ),
    "axes.towards": (
        "Take {along} parallel to {wall}, {sense} in which {body} first moves, and {across} "
        "towards {wall}."
    ),
    "axes.with": "in the direction",
    "axes.against": "opposite to the direction",
    "axes.told.away": (
        "Parallel to {wall}, {body} first moves {sense} {along}, and {across} is away from {wall}."
    ),
    "axes.told.towards": (
        "Parallel to {wall}, {body} first moves {sense} {along}, and {across} is towards {wall}."
    ),
    "axes.told.with": "in the direction of",
    "axes.told.against": "in the direction opposite to",
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
    "centres.along": "The line of centres is along {velocity}:",
    "centres.between": "From the centre of {one} to the centre of {other}:",
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
    "sided.wall-at": "Take {wall} to be at {angle} anticlockwise from 𝐢.",
    "sided.wall-unit": ("Then {along} is the unit vector perpendicular to {wall}, towards it."),
    "sided.spheres-unit": "Then {along} is the unit vector along it.",
    "sided.wall-units": (
        "Then {along} is the unit vector perpendicular to {wall}, towards it, and {across} the "
        "one along it."
    ),
    "sided.spheres": "Take the line of centres to be turned anticlockwise from 𝐢.",
    "sided.spheres-at": "Take the line of centres to be at {angle} anticlockwise from 𝐢.",
    "sided.spheres-units": (
        "Then {along} is the unit vector along it, and {across} the one perpendicular to it."
    ),
    "wall.beside-normal": "At right angles to the normal:",
    "derived-direction.title": "Direction of motion",
    "derived-direction.squared": (
        "Direction of motion, in squares, as the sense of a component is not known"
    ),
    "derived-direction.why": (
        "The components are the two shorter sides of a right-angled triangle, of which the "
        "velocity is the longest. So the tangent of the angle that it makes with a line is the "
        "component across the line divided by the component along it."
    ),
    "derived-perpendicular.title": (
        "The directions are perpendicular, so the scalar product is zero"
    ),
    "derived-perpendicular.why": (
        "Two directions are at right angles exactly if their scalar product is zero: the product "
        "of the components along one line, added to the product of those across it. Neither "
        "angles nor sizes are needed."
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
    "derived-between.title-of": "By the scalar product of {one} and {other}:",
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
    "derived.pushed-from-rest": "{body} was at rest and is pushed away from {other}",
    "derived.pushed": (
        "{body} had no component along the line of centres and is pushed away from {other}"
    ),
    "derived.moving": "{body} moves in the direction of {way}",
    "derived.moves": "{body} moves in the direction of {way}, so {fact}:",
    "derived.moves-put": (
        "{body} moves in the direction of {way}, so {fact}. Substituting for {letters:and}:"
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
    "derived.along-the-path": "The velocity is in the direction of the path:",
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
}
