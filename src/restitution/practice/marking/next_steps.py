"""Hints at a step that is missing, by its principle: a question, and what the principle says."""

from __future__ import annotations

from collections.abc import Mapping

AT_A_WALL = {
    "across": "parallel to the wall",
    "along": "perpendicular to the wall",
    "newton": "perpendicular to the wall, the component after the impact is e times that before "
    "it, and away from the wall",
}
OF_SPHERES = {
    "across": "perpendicular to the line of centres",
    "along": "along the line of centres",
    "newton": "along the line of centres, the speed of separation is e times the speed of approach",
}
"""Directions at an impact, and what Newton's experimental law says of it."""

QUESTIONS: Mapping[str, str] = {
    "momentum": "What is conserved along the line of centres?",
    "restitution": "What does e tell about the components {along}?",
    "unchanged": "What happens to the component {across}?",
    "impulse": "What does the impulse change?",
    "energy": "On what does a kinetic energy depend?",
    "angle": "Which components tell the angle?",
    "direction": "Which components tell the direction?",
    "deflection": "Between which two directions is the angle of deflection?",
    "speed": "Which components make up the speed?",
    "velocity": "Which components make up the velocity?",
    "fact": "What does the question give that you have not used?",
}

LAWS: Mapping[str, str] = {
    "momentum": "Along the line of centres, the sum of mass × component is the same before and "
    "after the collision.",
    "restitution": "It says that, {newton}.",
    "unchanged": "The impulse has no component {across}, so that this component of the velocity "
    "is the same before and after.",
    "impulse": "The impulse is mass × (component after − component before), {along}.",
    "energy": "The kinetic energy of a sphere is ½ × mass × speed².",
    "angle": "Its tangent is the ratio of two perpendicular components.",
    "deflection": "It is the angle between the velocities before and after.",
    "speed": "Its square is the sum of the squares of two perpendicular components.",
    "velocity": "It is put together from two perpendicular components.",
}
