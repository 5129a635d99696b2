"""Principles of an impact: momentum, restitution, impulse, and what they leave unchanged."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "restitution.title": "Newton's experimental law",
    "restitution.why": (
        "The speed at which two bodies separate is e times the speed at which they approached, "
        "both measured along the line of centres; e, between 0 and 1, is found by experiment. A "
        "fixed wall does not move, so there it says: speed of rebound = e × speed of approach, "
        "perpendicular to the wall."
    ),
    "restitution.none": "Newton's experimental law, as the coefficient of restitution is 0",
    "restitution.length": "Newton's experimental law, from which the length of {vector} cancels:",
    "restitution.products": "Newton's experimental law, by scalar products with this vector",
    "restitution.products-with": "Newton's experimental law, by scalar products with {vector}:",
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
    "momentum.vectors": "Conservation of momentum",
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
    "unchanged.components-left": (
        "the components to the left, looking from {first} to {second}, stay {components:and}."
    ),
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
    "impulse-spheres.decrease": (
        "Impulse = decrease in the momentum of {body} along the line of centres"
    ),
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
    "impulse-line.why": (
        "The spheres are smooth, so each pushes the other along the line through their centres. "
        "The impulse is mass × change of velocity; so the change in one sphere's velocity "
        "points along the line of centres, and finds it."
    ),
    "impulse-line.title": (
        "The impulse, and so the change of velocity, is along the line of centres"
    ),
    "impulse-normal.why": (
        "A smooth wall pushes only perpendicular to itself. The impulse is mass × change of "
        "velocity; so the change of the velocity is perpendicular to the wall, and tells how "
        "the wall runs."
    ),
    "impulse-normal.title": (
        "The impulse, and so the change of velocity, is perpendicular to {wall}"
    ),
    "impulse-along.why": (
        "The spheres are smooth, so each pushes the other along the line through their centres. "
        "The impulse on a sphere has the size that is given, in the direction away from the other "
        "sphere."
    ),
    "impulse-along.title": (
        "The impulse on {body} is along the line of centres, away from the other sphere"
    ),
    "impulse-away.why": (
        "A smooth wall pushes only perpendicular to itself, and away. So the impulse has the size "
        "that is given, in that direction."
    ),
    "impulse-away.title": "The impulse on {body} is perpendicular to {wall}, away from it",
    "changed-spheres.why": (
        "The spheres are smooth, so the impulse is along the line of centres, and so is the change "
        "of each velocity. What is added to the velocity before is the change of its component "
        "along that line, times the unit vector of the line."
    ),
    "changed-spheres.title": "The velocity changes along the line of centres only",
    "changed-wall.why": (
        "A smooth wall pushes only perpendicular to itself, so the velocity changes in that "
        "direction alone. What is added to the velocity before is the change of its component "
        "in that direction, times the unit vector."
    ),
    "changed-wall.title": "The velocity changes perpendicular to {wall} only",
    "moves-off.why": (
        "Whatever momentum a sphere at rest receives comes from the impulse, and the impulse "
        "acts along the line of centres. So that is the way in which it moves off."
    ),
    "moves-off.title": "{body} was at rest, so it moves off along the line of centres",
    "kept.angle": (
        "{wall} is perfectly elastic, so the path of {body} makes the same angle with it after the "
        "impact as before:"
    ),
    "moves-along.title": "{body} moves along the line of centres",
    "moves-along.from-rest": "{body} was at rest, so it moves along the line of centres",
    "moves-along.why": (
        "Smooth spheres push each other along the line of centres only. A sphere that has no "
        "velocity across that line before the impact has none after it. So it moves along the "
        "line, and its speed is the size of its one component."
    ),
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
}
