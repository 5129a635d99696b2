"""More about the principles that a step of the working names: what each says, why it holds, and
the mistake most often made against it.

The texts are for students, in words alone. They are found by the words of a step, so that a step
needs nothing beyond what it says anyway.
"""

from __future__ import annotations

import re

from restitution.explain.steps import Step

# A principle, or the words of a step that uses one, and what is told about it. The first that fits
# is meant. "…" stands where a step has a formula.
_ABOUT: dict[str, str] = {
    r"Newton's experimental law": (
        "The speed at which two bodies separate is e times the speed at which they approached, "
        "both measured along the line of centres; e, between 0 and 1, is found by experiment. A "
        "fixed wall does not move, so there it says: speed of rebound = e × speed of approach, "
        "perpendicular to the wall. Usual mistakes: e applied to the whole speed, or to the "
        "component that does not change; e put on the side of the approach; the sign lost of a "
        "component that is reversed."
    ),
    r"Conservation of momentum along the line of centres": (
        "The spheres push each other with equal and opposite impulses, so what one gains in "
        "momentum the other loses: the total is the same before and after. The impulses act "
        "along the line of centres, so it is in that direction that the principle tells "
        "something new. Usual mistakes: whole speeds in place of components; a mass left out; a "
        "plus sign for a sphere that moves against the positive sense."
    ),
    r"Parallel to \S+ the velocity does not change": (
        "The wall is smooth, so it can push the sphere only perpendicular to itself. No impulse "
        "acts along the wall, and so the component of velocity along it is the same before and "
        "after. Usual mistakes: multiplying this component by e as well, or exchanging it with "
        "the perpendicular one, sine for cosine."
    ),
    r"Perpendicular to the line of centres the velocities do not change": (
        "The spheres are smooth, so each pushes the other only along the line of centres. No "
        "impulse acts across it, and so each sphere keeps its own component in that direction. "
        "A sphere that was at rest has none, and moves off along the line of centres. Usual "
        "mistakes: letting the spheres exchange these components, or applying e to them."
    ),
    r"Impulse = change of momentum of \S+ perpendicular to ": (
        "The impulse on a body is its momentum after minus its momentum before. The wall is "
        "smooth, so only the perpendicular component changes, and it is reversed: the two sizes "
        "are added, and the impulse is m × (speed of approach + speed of rebound). Usual "
        "mistakes: subtracting the sizes because the sign of the reversed component is lost, or "
        "taking the difference of the speeds."
    ),
    r"Impulse = change of momentum of \S+ along the line of centres": (
        "The impulse on a sphere is its momentum after minus its momentum before; on the other "
        "sphere it is equal and opposite, so either sphere will do. The spheres are smooth, so "
        "only the components along the line of centres change. Usual mistakes: a sign lost "
        "where a component is reversed, and mass × (difference of speeds), which is not what a "
        "vector changes by."
    ),
    r"Impulse = change of momentum": (
        "The impulse on a body is its momentum after minus its momentum before: a vector, m(v − "
        "u), component by component. Its size is the size of that difference. Usual mistake: "
        "taking the difference of the sizes, mass × (difference of speeds), which is right only "
        "if the direction stays the same."
    ),
    r"Components before the impact, along and across the line of centres": (
        "Along the line of centres momentum and Newton's experimental law hold; across it "
        "nothing changes. So each velocity is resolved in these two directions first, by sine "
        "and cosine or by scalar product with a unit vector. Usual mistakes: sine and cosine "
        "exchanged, an angle measured from the wrong line, and a scalar product with a vector "
        "that was not divided by its size."
    ),
    r"Components before the impact, towards \S+ and parallel to it": (
        "The two components behave differently at a wall: the one towards it is reversed and "
        "multiplied by e, the one along it stays. So the velocity is resolved in these two "
        "directions first. Usual mistakes: taking the angle from the normal where it was given "
        "to the wall; and at a second wall, using the angle of the first again."
    ),
    r"The line of centres makes an angle … with the path of": (
        "At the impact the centres are two radii apart: the longest side of a right-angled "
        "triangle whose other side, across the path, is the offset. So the sine of the angle "
        "between the path and the line of centres is offset/(2r). Usual mistakes: one radius in "
        "place of two, and cosine for sine."
    ),
    r"A chord of the circle makes equal angles": (
        "The radius to the point of impact is perpendicular to the wall there. Two radii and "
        "the path between their ends form an isosceles triangle, so the path makes the same "
        "angle with the radius where it arrives as where it set out."
    ),
    r"The impulse on \S+ acts along the line of centres": (
        "The spheres are smooth, so each pushes the other along the line through their centres. "
        "The impulse is mass × change of velocity; so the change in one sphere's velocity "
        "points along the line of centres, and finds it. Usual mistake: taking the direction of "
        "a velocity instead of that of the change."
    ),
    r"The impulse on \S+ acts perpendicular to ": (
        "A smooth wall pushes only perpendicular to itself. The impulse is mass × change of "
        "velocity; so the change of the velocity is perpendicular to the wall, and tells how "
        "the wall runs. Usual mistake: taking the change to be parallel to the wall."
    ),
    r"The line of centres joins the centres at the impact": (
        "When two spheres touch, the line through their centres is the common normal, and the "
        "impulses act along it. It is found from where the centres are at that moment, and not "
        "from where they were at the start."
    ),
    r"\S+ was at rest, and the impulse on it acts along the line of centres": (
        "Whatever momentum a sphere at rest receives comes from the impulse, and the impulse "
        "acts along the line of centres. So that is the way in which it moves off. Usual "
        "mistake: sending it off in the direction in which the other sphere came."
    ),
    r"The components perpendicular to the line of centres do not change, and lose no": (
        "Kinetic energy is ½m × (sum of the squares of the components). Those across the line "
        "of centres stay, so what is lost comes from those along it, of both spheres. Usual "
        "mistakes: counting one sphere alone, and ½m(v − u)², the square of a difference in "
        "place of the difference of squares. For a fraction of the original energy, divide by "
        "all of it."
    ),
    r"The components parallel to \S+ do not change, and lose no kinetic energy": (
        "Kinetic energy is ½m × (sum of the squares of the components). The one along the wall "
        "stays, so what is lost comes from the perpendicular one alone: ½m × (its square before "
        "− its square after). Usual mistake: ½m(v − u)², the square of a difference in place of "
        "the difference of squares. For a fraction of the original energy, divide by all of it."
    ),
    r".*\S+ is turned through the ": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after. The path comes in at one angle to the wall and leaves at another on "
        "the same side: the sphere is turned through both, one after the other. Usual mistake: "
        "giving the angle of rebound alone, or the difference of the two."
    ),
    r".*[Tt]he angle of deflection of \S+ is ": (
        "The angle of deflection lies between the direction before, continued, and the "
        "direction after: by how much the path has turned. It is found by scalar product, or "
        "from the angles that both velocities make with one line. Usual mistake: giving the "
        "angle of the new path to the line of centres, which is only a part of it."
    ),
    r"\S+ and \S+ (?:do not )?collide again if ": (
        "After an impact the spheres separate. They meet again only if the one behind, after "
        "what happened in between, moves faster along the line than the one in front: it is "
        "velocities with their signs that are compared, and not speeds."
    ),
    r"A coefficient of restitution lies between 0 and 1": (
        "Spheres separate no faster than they approached, as no energy is gained: e is at most "
        "1. They do not pass through each other: e is at least 0. A value outside means that "
        "what is told cannot happen; where letters are left, it bounds them."
    ),
    r"\S+ moves a distance … ": (
        "Between impacts nothing acts on a sphere on a smooth table, so its velocity stays the "
        "same: distance = speed × time, for each component by itself. Usual mistake: the whole "
        "speed with a distance that is measured in the direction of one component."
    ),
    r"The gap between ": (
        "Two bodies that move along one line come together at the difference of their "
        "velocities: time = gap ÷ speed of approach. Velocities count with their signs; for "
        "bodies that move towards each other the speeds are added."
    ),
}

_COMPILED = tuple((re.compile(pattern), text) for pattern, text in _ABOUT.items())


def about(step: Step | str) -> str | None:
    """A few sentences on the principle of a step, or None where the step uses none of them.

    In place of a step its words will do: the name of a principle, or how a sentence begins.
    """
    for said in (step,) if isinstance(step, str) else _said(step):
        for pattern, text in _COMPILED:
            if pattern.match(said):
                return text
    return None


def _said(step: Step) -> tuple[str, ...]:
    words = "".join(each if isinstance(each, str) else "…" for each in step.words)
    return (words,) if step.principle is None else (step.principle, words)
